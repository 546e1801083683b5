#![allow(clippy::unwrap_used, reason = "tests")]

mod large;
mod moving;

use super::{RECEIVERS, library};
use crate::{Role, Scene, SceneRequest, open};
use glam::Vec3;

fn opened(name: &str, set: &[(&str, &str)], receiver: Option<&str>) -> Scene {
    let set = set
        .iter()
        .map(|(n, v)| ((*n).into(), (*v).into()))
        .collect();
    let receivers = receiver.map(Into::into).into_iter().collect();
    open(&SceneRequest {
        set,
        receivers,
        ..SceneRequest::new(name)
    })
    .unwrap()
}

/// Signed volume around a point: negative when fronts are inside.
fn volume(scene: &Scene, role: Role, centre: Vec3) -> f32 {
    let mut sum = 0.0;
    for object in scene.objects_of(role) {
        for t in 0..object.mesh.triangles.len() {
            let [a, b, c] = object.mesh.corners(t).map(|p| p - centre);
            sum += a.dot(b.cross(c)) / 6.0;
        }
    }
    sum
}

#[test]
fn every_scene_opens_with_every_receiver() {
    for scene in library() {
        assert_eq!(opened(scene.name, &[], None).name, scene.name);
        for receiver in RECEIVERS.iter().filter(|_| scene.receivers > 0) {
            let opened = opened(scene.name, &[], Some(receiver));
            let object = opened.objects_of(Role::Receiver).next().unwrap();
            assert_eq!(object.name, *receiver);
            assert_eq!(object.mesh.normals.len(), object.mesh.positions.len());
            // The reference point of a scene with a receiver is inside its bounding box.
            let (lo, hi) = object.mesh.bounds().unwrap();
            let o = opened.reference_point;
            assert!(
                o.cmpge(lo).all() && o.cmple(hi).all(),
                "{}: {o}",
                scene.name
            );
        }
    }
}

#[test]
fn settings_are_declared_once_and_take_their_own_defaults() {
    for scene in library() {
        let settings = scene.settings();
        let mut names: Vec<_> = settings.iter().map(|(info, _)| info.name).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(
            names.len(),
            settings.len(),
            "{}: a name is there twice",
            scene.name
        );
        let texts: Vec<_> = settings
            .iter()
            .map(|(i, v)| (i.name, v.to_string()))
            .collect();
        let set: Vec<_> = texts.iter().map(|(n, v)| (*n, v.as_str())).collect();
        assert_eq!(
            opened(scene.name, &set, None),
            opened(scene.name, &[], None)
        );
    }
}

#[test]
fn rooms_show_their_fronts_inside() {
    // Blocks stand in the rooms with their fronts outside: they take their volume away.
    for (name, expected) in [
        ("colored-room", -8.0 + 0.144),
        ("furnace", -8.0),
        ("divided-room", -8.0 + 0.132),
    ] {
        let found = volume(&opened(name, &[], None), Role::Environment, Vec3::ZERO);
        assert!((found - expected).abs() < 1e-4, "{name}: {found}");
    }
}

#[test]
fn the_receiver_stands_at_its_gap() {
    for (place, axis, gap) in [("wall", 0, 0.01), ("floor", 1, 0.3)] {
        let set = [
            ("receiver.place", place),
            ("receiver.gap", &gap.to_string()),
        ];
        let scene = opened("colored-room", &set, Some("torus"));
        let (lo, _) = scene
            .objects_of(Role::Receiver)
            .next()
            .unwrap()
            .mesh
            .bounds()
            .unwrap();
        assert!((lo[axis] + 1.0 - gap).abs() < 1e-6, "{place}: {lo}");
    }
    let set = [("receiver.place", "ceiling"), ("receiver.gap", "0.2")];
    let scene = opened("colored-room", &set, Some("torus"));
    let mesh = &scene.objects_of(Role::Receiver).next().unwrap().mesh;
    let (_, hi) = mesh.bounds().unwrap();
    assert!((hi.y - 0.8).abs() < 1e-6, "{hi}");
}

/// As in P1's figures: the reference point stays in the middle while the receiver moves, a divider stands in the room, and
/// the ceiling is green.
#[test]
fn the_colored_room_may_have_a_divider_a_green_ceiling_and_its_own_reference_point() {
    let set = [
        ("receiver.place", "halfway"),
        ("reference.place", "room"),
        ("reference.offset", "0"),
        ("block", "false"),
        ("divider", "0.9"),
        ("ceiling", "green"),
    ];
    let scene = opened("colored-room", &set, None);
    assert_eq!(
        (scene.reference_point, scene.captured_at),
        (Vec3::ZERO, Some(Vec3::ZERO))
    );
    let found = volume(&scene, Role::Environment, Vec3::ZERO);
    assert!((found - (-8.0 + 0.06 * 2.0 * 0.9)).abs() < 1e-4, "{found}");
    let walls = scene.objects_of(Role::Environment).next().unwrap();
    let greenest = |wall: usize| {
        let albedo = scene.materials[walls.mesh.materials[2 * wall] as usize].albedo;
        albedo.y > albedo.x
    };
    assert_eq!([2, 5].map(greenest), [true, false]);
}

#[test]
fn the_sphere_of_the_colored_room_is_not_around_the_reference_point() {
    let turn = |set: &[(&str, &str)]| {
        let scene = opened("colored-room", set, None);
        let mesh = &scene.objects_of(Role::Receiver).next().unwrap().mesh;
        let cosines = mesh.positions.iter().zip(&mesh.normals).map(|(x, n)| {
            let from_reference = (*x - scene.reference_point).normalize();
            from_reference.dot(*n)
        });
        cosines.fold(1.0, f32::min)
    };
    assert!(turn(&[("reference.offset", "0")]) > 0.999);
    assert!(turn(&[]) < 0.9);
}

#[test]
fn the_cornell_box_has_one_flux_in_three_variants() {
    use crate::Light;
    use std::f32::consts::{PI, TAU};
    let expected = 3.0 * Vec3::new(17.0, 12.0, 4.0) * PI * 0.130 * 0.105;
    let close = |flux: Vec3| assert!((flux / expected - 1.0).abs().max_element() < 1e-5, "{flux}");
    match opened("cornell-box", &[("light.angle", "120")], None).lights[0] {
        Light::Spot { intensity, .. } => close(intensity * TAU * 0.5),
        ref other => panic!("{other:?}"),
    }
    match opened("cornell-box", &[("light", "area")], None).lights[0] {
        Light::Area { flux, .. } => close(flux),
        ref other => panic!("{other:?}"),
    }
    let patch = opened("cornell-box", &[("light", "emitter")], None);
    assert!(patch.lights.is_empty());
    let mesh = &patch.objects.last().unwrap().mesh;
    let [a, b, c] = mesh.corners(0);
    let normal_area = (b - a).cross(c - a); // twice a triangle's area: the patch's
    close(patch.materials[mesh.materials[0] as usize].emission * PI * -normal_area.y);
}

#[test]
fn the_cornell_box_is_the_measured_one() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../shared/assets/scenes/cornell_measured.obj"
    );
    if !std::path::Path::new(path).exists() {
        println!("skipped: {path} is not there");
        return;
    }
    let triangles = |scene: &Scene, scale: f32| {
        let mut all: Vec<_> = scene
            .objects
            .iter()
            .flat_map(|o| (0..o.mesh.triangles.len()).map(move |t| (o, t)))
            .map(|(o, t)| {
                let corners = o
                    .mesh
                    .corners(t)
                    .map(|p| (p * scale).to_array().map(|v| (v * 10.0).round() as i32));
                // The order of corners counts up to a rotation.
                let first = (0..3).min_by_key(|i| corners[*i]).unwrap_or(0);
                let albedo = scene.materials[o.mesh.materials[t] as usize]
                    .albedo
                    .to_array()
                    .map(f32::to_bits);
                (
                    [
                        corners[first],
                        corners[(first + 1) % 3],
                        corners[(first + 2) % 3],
                    ],
                    albedo,
                )
            })
            .collect();
        all.sort_unstable();
        all
    };
    let measured = opened(path, &[], None);
    let built = opened("cornell-box", &[("light", "emitter")], None);
    assert_eq!(triangles(&built, 1000.0), triangles(&measured, 1.0));
}
