//! What a scene must be before rays are shot into it.

mod support;

use glam::{DVec3, Vec3};
use interreflect_cpu::scene::{CpuError, CpuScene};
use interreflect_scene::{Environment, Role, Scene};
use support::{cpu, glowing, object, sphere, walls};

#[test]
fn broken_scenes_are_refused_with_the_object_and_the_value() {
    let refused = |change: &dyn Fn(&mut Scene), what: &str| {
        let mut scene = walls([glowing(0.5, 0.0); 6]);
        change(&mut scene);
        let error = CpuScene::new(&scene).expect_err(what).to_string();
        assert!(error.contains(what), "{error}");
    };
    refused(
        &|s| s.objects[0].mesh.triangles[3][1] = 99,
        "vertex 99 of 24",
    );
    refused(&|s| s.objects[0].mesh.materials[3] = 6, "material 6 of 6");
    refused(
        &|s| s.objects[0].mesh.materials.truncate(3),
        "3 materials for 12 triangles",
    );
    refused(
        &|s| s.objects[0].mesh.normals.push(Vec3::X),
        "1 normals for 24 vertices",
    );
    refused(&|s| s.objects[0].mesh.positions[5].y = f32::NAN, "vertex 5");
    refused(
        &|s| s.objects[0].mesh.positions[5].y = 1e30,
        "`mesh`: vertex 5",
    );
    let hollow = |s: &mut Scene| {
        let mut environment = Environment::constant(Vec3::ONE);
        environment.image.width = 7;
        s.environment = Some(environment);
    };
    refused(&hollow, "7×1 image has 1 texels");
    let _: CpuError = CpuError::TooManyTriangles {
        triangles: 5_000_000_000,
    };
}

#[test]
fn receivers_are_in_the_second_tree_only_and_hits_name_their_surface() {
    let mut scene = walls([1.0, 0.2, 0.5, 0.8, 0.3, 0.6].map(|l| glowing(0.0, l)));
    let bare = cpu(&scene);
    assert!(std::ptr::eq(bare.environment_objects(), bare.all_objects()));
    scene.materials.push(glowing(0.25, 0.0));
    let mut ball = sphere(0.5, 16, false, true);
    ball.materials.fill(6);
    scene.objects.push(object(Role::Receiver, ball));
    let scene = cpu(&scene);
    let origin = DVec3::new(0.9, 0.01, 0.02);
    let look = |objects, direction| {
        scene
            .closest(objects, origin, direction, 0.0)
            .expect("closed")
    };
    let wall = look(scene.environment_objects(), Vec3::NEG_X);
    assert!((wall.distance - 1.9).abs() < 1e-12 && wall.front);
    assert_eq!(
        (wall.material.emission.x, wall.geometric_normal),
        (0.2, Vec3::X)
    );
    let ball = look(scene.all_objects(), Vec3::NEG_X);
    assert!((ball.distance - 0.4).abs() < 5e-3 && ball.front);
    assert_eq!(ball.material.albedo.x, 0.25);
    // Interpolated normals point away from the centre; flat ones are off by half a facet.
    let outward = ball.position.as_vec3().normalize();
    assert!(ball.shading_normal.dot(outward) > 0.999_99);
    assert!(ball.geometric_normal.dot(outward) > 0.99);
    let inside = scene
        .closest(
            scene.all_objects(),
            DVec3::new(0.01, 0.02, 0.0),
            Vec3::X,
            0.0,
        )
        .expect("closed");
    assert!(!inside.front && inside.geometric_normal.x < 0.0 && inside.shading_normal.x < 0.0);
}
