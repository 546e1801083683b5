//! The scenes that are not measured unless they are named.

use super::opened;
use crate::{Light, Scene, SceneRequest, open};
use glam::Vec3;

/// The distance at which a ray meets a mesh, and whether it meets the front (Möller and Trumbore).
fn first_hit(scene: &Scene, origin: Vec3, direction: Vec3) -> Option<(f32, bool)> {
    let meshes = scene.objects.iter().map(|o| &o.mesh);
    let triangles = meshes.flat_map(|m| (0..m.triangles.len()).map(|t| m.corners(t)));
    triangles
        .filter_map(|[a, b, c]| {
            let (ab, ac) = (b - a, c - a);
            let p = direction.cross(ac);
            let det = ab.dot(p);
            let from = (origin - a) / det;
            let (u, q) = (from.dot(p), from.cross(ab));
            let (v, t) = (direction.dot(q), ac.dot(q));
            (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 1e-5).then_some((t, det > 0.0))
        })
        .min_by(|a, b| a.0.total_cmp(&b.0))
}

#[test]
fn the_cave_is_closed_detailed_and_has_its_mirrors_inside() {
    let scene = opened("cave", &[], None);
    let triangles: usize = scene.objects.iter().map(|o| o.mesh.triangles.len()).sum();
    assert!((35_000..45_000).contains(&triangles), "{triangles}");
    let cavern = &scene.objects[0].mesh;
    let edges: std::collections::HashSet<_> = (cavern.triangles.iter())
        .flat_map(|t| [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])])
        .collect();
    assert_eq!(edges.len(), 3 * cavern.triangles.len());
    assert!(edges.iter().all(|(a, b)| edges.contains(&(*b, *a))));
    // Whatever is seen from the camera, the lantern or the reference point shows its front, but for
    // the mirror, which is a sheet.
    let Light::Spot { position, .. } = scene.lights[0] else {
        panic!("{:?}", scene.lights);
    };
    let sheet = scene
        .objects
        .iter()
        .position(|o| o.name == "mirror")
        .unwrap();
    let mut solid = scene.clone();
    solid.objects.remove(sheet);
    for origin in [scene.camera.eye, position, scene.reference_point] {
        for i in 0..200 {
            let (z, turn) = (1.0 - (i as f32 + 0.5) / 100.0, 2.4 * i as f32);
            let direction =
                Vec3::new(turn.cos(), turn.sin(), 0.0) * (1.0 - z * z).sqrt() + Vec3::Z * z;
            let (distance, front) = first_hit(&solid, origin, direction).unwrap();
            assert!(front && distance > 0.1, "{origin} {direction}: {distance}");
        }
    }
    // The whole mirror is inside the cavern.
    for p in &scene.objects[sheet].mesh.positions {
        let alone = Scene {
            objects: vec![scene.objects[0].clone()],
            ..scene.clone()
        };
        let (distance, _) = first_hit(&alone, Vec3::ZERO, p.normalize()).unwrap();
        assert!(distance > p.length(), "{p}");
    }
}

#[test]
fn the_pit_has_its_size_and_shows_its_fronts() {
    let set = [
        ("width", "2"),
        ("length", "3"),
        ("depth", "4"),
        ("cells", "5"),
    ];
    let scene = opened("pit", &set, None);
    let bounds: Vec<_> = (scene.objects.iter())
        .map(|o| o.mesh.bounds().unwrap())
        .collect();
    let (lo, hi) = (Vec3::new(-1.0, -4.0, -1.5), Vec3::new(1.0, 0.0, 1.5));
    assert_eq!(bounds[0], (lo, Vec3::new(hi.x, lo.y, hi.z)));
    assert_eq!(bounds[1], (lo, hi));
    let margin = Vec3::new(3.0, 0.0, 3.0);
    assert_eq!(
        bounds[2],
        (lo * Vec3::new(1.0, 0.0, 1.0) - margin, hi + margin)
    );
    let middle = Vec3::new(0.0, -2.0, 0.0);
    for object in &scene.objects {
        let mesh = &object.mesh;
        let area: f32 = (0..mesh.triangles.len())
            .map(|t| {
                let [a, b, c] = mesh.corners(t);
                let flat = mesh.normal(t);
                for v in mesh.triangles[t] {
                    assert!(mesh.normals[v as usize].dot(flat) > 1.0 - 1e-6);
                }
                if object.name != "ground" {
                    assert!(flat.dot(middle - a) > 0.0, "{}", object.name);
                }
                0.5 * (b - a).cross(c - a).length()
            })
            .sum();
        let expected = match object.name.as_str() {
            "floor" => 6.0,
            "walls" => 40.0,
            _ => 8.0 * 9.0 - 6.0,
        };
        assert!(
            (area / expected - 1.0).abs() < 1e-5,
            "{}: {area}",
            object.name
        );
    }
}

#[test]
fn dragons_stand_on_the_ground_beside_the_model_in_the_middle() {
    let request = SceneRequest {
        receivers: vec!["sphere".into(), "blob".into()],
        ..SceneRequest::new("dragons")
    };
    let scene = open(&request).unwrap();
    let names: Vec<_> = scene.objects.iter().map(|o| o.name.as_str()).collect();
    assert_eq!(names, ["sphere", "blob", "blob", "ground"]);
    let bounds: Vec<_> = (scene.objects.iter())
        .map(|o| o.mesh.bounds().unwrap())
        .collect();
    // 1e-6: roundings of lengths of about a metre.
    assert!(bounds[..3].iter().all(|(lo, _)| lo.y.abs() < 1e-6));
    assert!((bounds[0].0.x - bounds[1].1.x - 0.04).abs() < 1e-6);
    assert!((bounds[2].0.x - bounds[0].1.x - 0.04).abs() < 1e-6);
    // The neighbours mirror each other: what is in front of the left one is on its right.
    let [left, right] = [1, 2].map(|i| &scene.objects[i].mesh.positions);
    let centre = |i: usize| 0.5 * (bounds[i].0 + bounds[i].1) * Vec3::new(1.0, 0.0, 1.0);
    for (a, b) in left.iter().zip(right) {
        let turned = (*a - centre(1)) * Vec3::new(-1.0, 1.0, -1.0);
        assert!(turned.distance(*b - centre(2)) < 1e-5);
    }
}
