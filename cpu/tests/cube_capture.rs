//! Cube captures against the analytic box and the analytic light.

mod support;

use glam::{DVec3, Vec3};
use interreflect_cpu::{capture::cube::capture_cube, scene::CpuScene};
use interreflect_scene::{CubeChannels, CubeImage, CubeSpec, Light, Material, Role, conventions};
use support::{cpu, glowing, lit, object, quad, sphere, under, walls};

const ALL: CubeChannels = CubeChannels {
    radiance: true,
    distance: true,
    normal: true,
};

fn capture(scene: &CpuScene, size: u32) -> CubeImage {
    capture_cube(
        scene,
        scene.scene().reference_point,
        CubeSpec {
            size,
            channels: ALL,
            bounces: 0,
        },
    )
}

fn texels(size: u32) -> impl Iterator<Item = (usize, DVec3)> {
    (0..6 * size * size).map(move |i| {
        let (face, row, column) = (i / (size * size), i / size % size, i % size);
        let (s, t) = (
            conventions::texel_centre(size, column),
            conventions::texel_centre(size, row),
        );
        let index = conventions::texel_index(size, face as usize, column, row);
        (
            index,
            conventions::cube_vector(face as usize, s, t).normalize(),
        )
    })
}

/// Distance to the walls of [−1, 1]³ and the wall's index.
fn exact(origin: DVec3, direction: DVec3) -> (f64, usize) {
    let to = (DVec3::ONE.copysign(direction) - origin) / direction;
    let axis = (0..3).min_by(|&a, &b| to[a].total_cmp(&to[b])).unwrap_or(0);
    (to[axis], 2 * axis + usize::from(direction[axis] < 0.0))
}

#[test]
fn a_box_has_its_analytic_distances_normals_and_radiances() {
    let mut scene = walls([1.0, 0.2, 0.5, 0.8, 0.3, 0.6].map(|l| glowing(0.0, l)));
    for o in [
        Vec3::ZERO,
        Vec3::new(0.2, -0.1, 0.3),
        Vec3::new(0.999, 0.9, -0.99),
    ] {
        scene.reference_point = o;
        let image = capture(&cpu(&scene), 33);
        for (i, direction) in texels(33) {
            let (distance, wall) = exact(o.as_dvec3(), direction);
            let error = (f64::from(image.distance[i]) / distance - 1.0).abs();
            assert!(error < 1e-6, "texel {i} at {o}: {error}");
            assert_eq!(image.radiance[i], scene.materials[wall].emission);
            assert_eq!(image.normal[i], -conventions::cube_frame(wall).0.as_vec3());
        }
    }
}

#[test]
fn only_the_channels_that_were_asked_for_are_there() {
    let scene = cpu(&walls([glowing(0.0, 1.0); 6]));
    let whole = capture(&scene, 8);
    for bits in 0..8 {
        let channels = CubeChannels {
            radiance: bits & 1 != 0,
            distance: bits & 2 != 0,
            normal: bits & 4 != 0,
        };
        let spec = CubeSpec {
            size: 8,
            channels,
            bounces: 0,
        };
        let image = capture_cube(&scene, Vec3::ZERO, spec);
        assert!(image.radiance.is_empty() != channels.radiance);
        assert!(channels.radiance == (image.radiance == whole.radiance));
        assert!(channels.distance == (image.distance == whole.distance));
        assert!(channels.normal == (image.normal == whole.normal));
    }
    assert_eq!(capture(&scene, 0).texels(), 0);
}

#[test]
fn direct_light_is_lambertian_two_sided_and_shadowed_by_environment_objects_only() {
    let light = Vec3::new(0.0, 0.9, 0.0);
    let albedo = [0.7, 0.1, 0.6, 0.6, 0.2, 0.7];
    let mut scene = lit(
        walls(albedo.map(|a| Material::diffuse(Vec3::splat(a)))),
        Light::Point {
            position: light,
            intensity: Vec3::ONE,
            picture: None,
        },
    );
    let expected = |direction: DVec3| {
        let (distance, wall) = exact(DVec3::ZERO, direction);
        let x = (direction * distance).as_vec3();
        let normal = -conventions::cube_frame(wall).0.as_vec3();
        let to = light - x;
        albedo[wall] / std::f32::consts::PI * normal.dot(to.normalize()) / to.length_squared()
    };
    let check = |scene: &CpuScene, shadow: &dyn Fn(DVec3) -> bool| {
        let image = capture(scene, 17);
        for (i, direction) in texels(17) {
            let exact = if shadow(direction) {
                0.0
            } else {
                expected(direction)
            };
            // Position and direction to the light are f32: a few 1e-7 of 1/0.1² near the light.
            let error = (image.radiance[i].x - exact).abs();
            assert!(
                error < 2e-5 * exact.max(0.1),
                "texel {i}: {} for {exact}",
                image.radiance[i].x
            );
        }
    };
    check(&cpu(&scene), &|_| false);

    // A receiver that would cast a shadow does not; the walls seen from behind reflect as well.
    scene
        .objects
        .push(object(Role::Receiver, sphere(0.3, 4, false, true)));
    for triangle in &mut scene.objects[0].mesh.triangles {
        triangle.swap(1, 2);
    }
    check(&cpu(&scene), &|_| false);

    // A lid under the light as part of the environment hides it from everything below.
    scene.materials.push(Material::diffuse(Vec3::ZERO));
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let lid = quad(corners.map(|(x, z)| Vec3::new(x, 0.5, z)), 6);
    scene.objects.push(object(Role::Environment, lid));
    let image = capture(&cpu(&scene), 17);
    assert!(image.radiance.iter().all(|l| *l == Vec3::ZERO));
}

#[test]
fn rays_that_meet_nothing_see_the_environment_at_infinity() {
    let scene = support::scene(vec![], vec![]);
    let image = capture(&cpu(&under(scene.clone(), 2.0)), 4);
    assert!(
        image
            .radiance
            .iter()
            .all(|l| (*l - 2.0).abs().max_element() < 1e-6)
    );
    assert!(image.distance.iter().all(|d| *d == f32::INFINITY));
    assert!(image.normal.iter().all(|n| *n == Vec3::ZERO));
    assert!(
        capture(&cpu(&scene), 4)
            .radiance
            .iter()
            .all(|l| *l == Vec3::ZERO)
    );
}

#[test]
fn normals_are_the_triangles_and_turned_to_the_reference_point() {
    let shell = object(Role::Environment, sphere(1.0, 8, false, true));
    let scene = support::scene(vec![shell], vec![glowing(0.5, 1.0)]);
    let image = capture(&cpu(&scene), 9);
    for (i, direction) in texels(9) {
        // 8 × 8 quads a face are 11° wide and skewed at the cube's corners: off by up to 9°.
        let normal = image.normal[i];
        assert!(
            normal.dot(-direction.as_vec3()) > 0.985,
            "texel {i}: {normal}"
        );
        assert_eq!(image.radiance[i], Vec3::ZERO, "the back does not emit");
    }
}
