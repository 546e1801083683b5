use super::*;
use interreflect_cpu::scene::CpuScene;

/// A pixel whose normal is turned about y by this angle, seen along −z.
fn turned(angle: f32) -> Option<Point> {
    Some(Point {
        normal: Vec3::new(angle.sin(), 0.0, angle.cos()),
        view: Vec3::Z,
        ..Point::default()
    })
}

#[test]
fn footprints_are_the_larger_turn_to_a_neighbour() {
    // Three columns, two rows; the mirrored direction turns twice as far as the normal.
    let points = [
        turned(0.0),
        turned(1e-3),
        turned(1.5e-3),
        turned(4e-3),
        None,
        turned(0.3),
    ];
    // Right 1e-3, below 4e-3; right ½e-3 alone; left ½e-3, below 0.2985; above 4e-3 alone; no
    // surface; above 0.2985 alone.
    let expected = [8e-3, 1e-3, 0.597, 8e-3, 0.0, 0.597];
    for (i, expected) in expected.into_iter().enumerate() {
        let found = footprint(&points, 3, i);
        // Directions rounded to float32.
        assert!((found - expected).abs() < 1e-6, "pixel {i}: {found}");
    }
    assert_eq!(footprint(&[turned(0.2)], 1, 0), 0.0);
}

/// A floor before an upright mirror, from a file.
fn mirrored_floor() -> CpuScene {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("floor.toml");
    let text = r#"
        [camera]
        eye = [0.0, 1.0, 3.0]
        target = [0.0, 1.0, 0.0]
        up = [0.0, 1.0, 0.0]
        vfov_deg = 60.0
        resolution = [33, 33]
        [[mesh]]
        shape = "quad"
        scale = 4.0
        translate = [0.0, 0.0, 2.0]
        material = { albedo = [0.5, 0.5, 0.5] }
        [[mesh]]
        shape = "quad"
        scale = 4.0
        rotate_deg = [90.0, 0.0, 0.0]
        translate = [0.0, 2.0, 0.0]
        material = { albedo = [0.0, 0.0, 0.0], specular = [0.5, 0.25, 1.0], mirror = true }
    "#;
    std::fs::write(&file, text).expect("a writable folder");
    let request = interreflect_scene::SceneRequest::new(file.to_string_lossy());
    let scene = interreflect_scene::open(&request).expect("a scene");
    CpuScene::new(&scene).expect("a scene that the CPU takes")
}

#[test]
fn mirrors_show_what_is_asked() {
    let scene = mirrored_floor();
    let camera = scene.scene().camera;
    let view = |mirrors| {
        let look = Look {
            mirrors,
            ..Look::default()
        };
        View::new(&scene, &camera, look).expect("a small view")
    };
    let [direct, diffuse, included] =
        [Mirrors::Direct, Mirrors::Diffuse, Mirrors::Included].map(view);
    let on_mirror = |view: &View| {
        let points = view.points.iter().flatten();
        points.filter(|p| p.position.z.abs() < 1e-4).count()
    };
    let in_mirror = |view: &View| {
        let ones = Estimate::from_blocks(
            view.points.len(),
            vec![1.0; Estimate::new(view.points.len()).blocks().len()],
        );
        let image = view.image(&ones.expect("as many blocks as points"));
        let tinted = Vec3::new(0.5, 0.25, 1.0);
        image.pixels.iter().filter(|p| **p == tinted).count()
    };
    assert_eq!((on_mirror(&direct), in_mirror(&direct)), (0, 0));
    assert!(on_mirror(&included) == 0 && in_mirror(&included) > 10);
    assert!(on_mirror(&diffuse) > in_mirror(&included) && in_mirror(&diffuse) == 0);
    let albedo = diffuse
        .points
        .iter()
        .flatten()
        .find(|p| p.position.z.abs() < 1e-4);
    assert_eq!(
        albedo.map(|p| p.material.diffuse),
        Some(Vec3::new(0.5, 0.25, 1.0))
    );
}

#[test]
fn vertices_interpolate_over_their_triangles() {
    let scene = mirrored_floor();
    let camera = scene.scene().camera;
    let look = Look {
        at: ShadedAt::Vertices,
        ..Look::default()
    };
    let vertices = View::new(&scene, &camera, look).expect("a small view");
    let pixels = View::new(&scene, &camera, Look::default()).expect("a small view");
    // Positions are linear over a triangle: interpolated they are those of the pixels.
    let positions = |view: &View| {
        let mut estimate = Estimate::new(view.points.len());
        for (i, point) in view.points.iter().enumerate() {
            estimate.set(i, point.map_or(Vec3::ZERO, |p| p.position));
        }
        view.image(&estimate)
    };
    let (a, b) = (positions(&vertices), positions(&pixels));
    for (a, b) in a.pixels.iter().zip(&b.pixels) {
        // Rounding of weights and positions of a few metres to float32.
        assert!(a.distance(*b) < 1e-5, "{a} and {b}");
    }
    let seen = vertices.visible().expect("vertices have triangles");
    assert!(pixels.visible().is_none() && !seen.visible.is_empty());
    let of_mirror = |t: &&u32| vertices.points[seen.triangles[**t as usize][0] as usize];
    let floor_only = seen
        .visible
        .iter()
        .all(|t| of_mirror(&t).is_some_and(|p| p.position.y == 0.0));
    assert!(
        floor_only,
        "the mirror's triangles are not shaded where it shows others"
    );
}

#[test]
fn lambertian_points_reflect_by_their_albedo_over_pi() {
    let of = |albedo| {
        let mut point = turned(0.0)?;
        point.material.diffuse = Vec3::splat(albedo);
        Some(point)
    };
    let points = Points::new(PointLayout::Material, [of(0.5), None, of(0.25)]);
    let mut irradiance = Estimate::new(3);
    for (i, share) in [1.0, 1.0, 4.0].into_iter().enumerate() {
        irradiance.set(i, Vec3::splat(share * std::f32::consts::PI));
    }
    let found = lambertian(&points, &irradiance);
    for (found, expected) in found.iter().zip([0.5, 0.0, 1.0]) {
        // Roundings of two products.
        assert!((found.x - expected).abs() < 1e-6, "{found}");
    }
}
