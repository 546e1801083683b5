//! Where captures are made, and how depth maps are read.

use crate::{ROUNDING, boxed, near};
use glam::{DVec3, Vec3};
use interreflect_scene::{
    BoundingSphere, Bounds, DepthMap, DirectionalFrame, Role, SceneRequest, open,
};

/// The receiver stands off the middle of what surrounds it.
#[test]
fn without_a_word_the_reference_point_is_in_the_receivers() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        path.to_string_lossy().into_owned()
    };
    file("wall.obj", "v -10 0 0\nv 30 0 0\nv 0 8 0\nf 1 2 3\n");
    file("a.obj", "v 1 0 2\nv 3 0 2\nv 1 4 4\nf 1 2 3\n");
    file("b.obj", "v 5 0 2\nv 6 0 2\nv 5 2 4\nf 1 2 3\n");
    let mesh = |name: &str, role: &str| format!("[[mesh]]\nfile = \"{name}\"\nrole = \"{role}\"\n");
    let reference = |name: &str, meshes: &[(&str, &str)]| {
        let meshes: String = meshes.iter().map(|(n, role)| mesh(n, role)).collect();
        let path = file(name, &meshes);
        open(&SceneRequest::new(path)).unwrap().reference_point
    };
    let (wall, a, b) = (
        ("wall.obj", "environment"),
        ("a.obj", "receiver"),
        ("b.obj", "receiver"),
    );
    near(reference("one.toml", &[wall, a]), Vec3::new(2.0, 2.0, 3.0));
    near(
        reference("two.toml", &[a, wall, b]),
        Vec3::new(3.5, 2.0, 3.0),
    );
    near(reference("none.toml", &[wall]), Vec3::new(10.0, 4.0, 0.0));
}

/// Captures that may be kept lie where they were made, up to a distance and not beyond; with 0 never.
#[test]
fn captures_are_kept_within_a_distance() {
    let mut scene = open(&SceneRequest::new("colored-room")).unwrap();
    scene.reference_point = Vec3::new(0.3, 0.0, 0.4);
    scene.captured_at = Some(Vec3::ZERO);
    for (within, kept) in [(0.0, false), (0.49, false), (0.51, true)] {
        assert_eq!(scene.keeps_captures(within), kept, "{within}");
        let origin = if kept {
            Vec3::ZERO
        } else {
            scene.reference_point
        };
        assert_eq!(scene.capture_origin(within), origin);
    }
    scene.captured_at = None;
    assert!(!scene.keeps_captures(9.0));
    assert_eq!(scene.capture_origin(9.0), scene.reference_point);
}

/// Each texel of a depth map has a depth of its own: columns go to the right, rows down.
#[test]
fn a_depth_map_is_read_where_the_position_projects_to() {
    let sphere = BoundingSphere {
        centre: Vec3::new(1.0, 2.0, 3.0),
        radius: 2.0,
    };
    let towards = Vec3::new(0.6, -0.48, 0.64);
    let frame = DirectionalFrame::new(sphere, towards);
    let size = 4;
    let mut map = DepthMap::new(frame, size);
    assert_eq!(map.depth, vec![1.0; 16]);
    for (i, depth) in map.depth.iter_mut().enumerate() {
        *depth = i as f32 / 16.0;
    }
    for (column, row) in [(0, 0), (3, 0), (1, 2), (2, 3)] {
        let centre = |i: u32| (i as f32 + 0.5) / 2.0 - 1.0;
        let offset = frame.right * centre(column) - frame.up * centre(row) + 0.5 * towards;
        let [depth, stored] = map.depths(sphere.centre + sphere.radius * offset);
        assert!((depth - 0.25).abs() < 1e-6, "nearer is less: {depth}");
        assert_eq!(stored, (row * size + column) as f32 / 16.0);
    }
    let beyond = frame.project(sphere.centre - 9.0 * towards);
    assert!((beyond - DVec3::new(0.0, 0.0, 1.0)).length() < 1e-6);
}

/// From the box around all objects, receivers too, and a hundredth more.
#[test]
fn maps_along_directions_hold_all_objects() {
    let mut scene = open(&SceneRequest::new("studio")).unwrap();
    scene.objects.truncate(1);
    scene.objects[0].role = Role::Receiver;
    scene.objects[0].mesh = boxed(Vec3::new(4.0, 5.0, 6.0), &[]);
    let sphere = BoundingSphere::of_objects(&scene);
    near(sphere.centre, Vec3::new(4.0, 5.0, 6.0));
    // Half the diagonal of a cube of 4.
    let radius = 1.01 * 2.0 * 3_f32.sqrt();
    assert!((sphere.radius / radius - 1.0).abs() < ROUNDING);
    let captured = Bounds::of_captured(&scene);
    assert_eq!((captured.low, captured.high), (Vec3::ZERO, Vec3::ZERO));
}
