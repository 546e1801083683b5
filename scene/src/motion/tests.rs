#![allow(clippy::unwrap_used, reason = "tests")]

use super::*;
use crate::params::Choice;
use crate::{Camera, Light, SceneRequest, SpotShape, normals, open, shapes};

/// Times before, within and after keyframes and periods, and far away.
const TIMES: [f32; 9] = [-3.0, -0.3, 0.0, 0.25, 0.5, 1.0, 1.7, 4.0, 1e30];

fn moving() -> Scene {
    let mut scene = open(&SceneRequest::new("colored-room")).unwrap();
    let pose = |turn: f32, scale| Pose {
        translate: Vec3::new(0.1, 0.2, 0.0) * turn,
        rotate: Quat::from_rotation_z(turn),
        scale,
    };
    let kinds = DeformationKind::all().into_iter().map(|(_, kind)| kind);
    for (object, kind) in scene.objects.iter_mut().zip(kinds) {
        object.motion = Some(Motion {
            poses: Track {
                keys: vec![
                    (0.0, Pose::REST),
                    (1.0, pose(1.0, 1.5)),
                    (2.0, pose(2.5, 0.5)),
                ],
            },
            deformation: Some(Deformation::new(kind)),
            ..Motion::default()
        });
    }
    scene.lights.push(Light::Spot {
        position: Vec3::ZERO,
        direction: Vec3::X,
        up: Vec3::Y,
        shape: SpotShape::Square,
        angle_deg: 90.0,
        intensity: Vec3::ONE,
    });
    let to = Vec3::new(-1.0, 1.0, 1.0).normalize();
    scene.motion = SceneMotion {
        camera: Some(CameraMotion::Orbit { deg_per_s: 40.0 }),
        lights: vec![
            LightMotion::default(),
            LightMotion {
                position: Track {
                    keys: vec![(0.0, Vec3::ZERO), (2.0, Vec3::splat(0.5))],
                },
                // The opposite direction, and one that is none of the axes.
                direction: Track {
                    keys: vec![(0.0, Vec3::X), (0.5, to), (1.0, -to)],
                },
            },
        ],
        environment_deg_per_s: 10.0,
    };
    scene
}

#[test]
fn every_time_gives_a_sound_scene_and_time_0_the_scene_itself() {
    let scene = moving();
    scene.validate().unwrap();
    assert_eq!(scene.at(0.0), scene);
    assert_eq!(scene.at(f32::NAN), scene);
    for time_s in TIMES {
        let at = scene.at(time_s);
        at.validate().unwrap();
        assert_eq!(at, scene.at(time_s));
        for (a, b) in at.objects.iter().zip(&scene.objects) {
            assert_eq!(a.mesh.triangles, b.mesh.triangles);
            assert_eq!(a.mesh.materials, b.mesh.materials);
        }
    }
    assert_ne!(scene.at(0.25), scene);
}

#[test]
fn what_moves_is_told() {
    let mut scene = open(&SceneRequest::new("studio")).unwrap();
    assert_eq!(scene.moves(), Moves::default());
    scene.motion.environment_deg_per_s = 1.0;
    assert_eq!(
        scene.moves(),
        Moves {
            environment: true,
            ..Moves::default()
        }
    );
    let moves = moving().moves();
    assert!(moves.geometry && moves.camera && moves.lights);
    assert!(!moves.environment, "there is none");
}

/// One object that keeps its shape and size is told by its rotation; nothing else is.
#[test]
fn a_rigid_motion_of_the_only_object_is_told() {
    let mut scene = open(&SceneRequest::new("studio")).unwrap();
    assert_eq!(scene.rigid_rotation(), None, "it stands still");
    let pose = |turn: f32| Pose {
        translate: Vec3::X * turn,
        rotate: Quat::from_rotation_y(turn),
        scale: 0.5,
    };
    let motion = |scene: &mut Scene, poses: [Pose; 2], deformation| {
        scene.objects[0].motion = Some(Motion {
            poses: Track {
                keys: vec![(0.0, poses[0]), (1.0, poses[1])],
            },
            deformation,
            ..Motion::default()
        });
    };
    motion(&mut scene, [pose(0.0), pose(2.0)], None);
    // A few roundings of f32.
    let turned = |time_s| scene.at(time_s).rigid_rotation().unwrap();
    assert!(turned(0.5).angle_between(Quat::from_rotation_y(1.0)) < 1e-3);
    assert_eq!(turned(1.0), Quat::from_rotation_y(2.0));
    let larger = Pose {
        scale: 0.6,
        ..pose(2.0)
    };
    motion(&mut scene, [pose(0.0), larger], None);
    assert_eq!(scene.at(0.5).rigid_rotation(), None, "it grows");
    let wave = Deformation::new(DeformationKind::Wave);
    motion(&mut scene, [pose(0.0), pose(2.0)], Some(wave));
    assert_eq!(scene.at(0.5).rigid_rotation(), None, "it deforms");
    let still = Deformation {
        amount: 0.0,
        ..wave
    };
    motion(&mut scene, [pose(0.0), pose(2.0)], Some(still));
    assert!(scene.rigid_rotation().is_some());
    let other = scene.objects[0].clone();
    scene.objects.push(other);
    assert_eq!(scene.rigid_rotation(), None, "there are two");
}

/// Carried normals are those of the moved surface: of a fine sphere, by its own triangles.
#[test]
fn normals_follow_the_deformation() {
    let sphere = shapes::sphere(0.5, 48);
    for (name, kind) in DeformationKind::all() {
        let motion = Motion {
            deformation: Some(Deformation::new(kind)),
            ..Motion::default()
        };
        let moved = motion.of(&sphere, 0.5);
        let mut smoothed = moved.clone();
        normals::smooth(&mut smoothed);
        let index: std::collections::HashMap<_, _> = (smoothed.positions.iter())
            .zip(&smoothed.normals)
            .map(|(p, n)| (p.to_array().map(f32::to_bits), n))
            .collect();
        let worst = (moved.positions.iter().zip(&moved.normals))
            .map(|(p, n)| n.dot(*index[&(*p + 0.0).to_array().map(f32::to_bits)]))
            .fold(1.0, f32::min);
        let rest = (sphere.normals.iter().zip(&moved.normals))
            .map(|(a, b)| a.dot(*b))
            .fold(1.0, f32::min);
        // 1°: the triangles turn by 1.3° from one to the next. The normals have turned by more.
        assert!(worst > 1f32.to_radians().cos(), "{name}: {worst}");
        assert!(rest < 5f32.to_radians().cos(), "{name}: {rest}");
    }
}

#[test]
fn deformations_return_after_a_period() {
    for (_, kind) in DeformationKind::all() {
        let motion = Motion {
            deformation: Some(Deformation {
                period_s: 0.75,
                ..Deformation::new(kind)
            }),
            ..Motion::default()
        };
        let blob = shapes::blob();
        assert_eq!(motion.of(&blob, 3.0), blob);
        assert_ne!(motion.of(&blob, 3.1), blob);
    }
}

#[test]
fn poses_hold_outside_and_go_linearly_between() {
    let key = |x: f32, turn: f32| Pose {
        translate: Vec3::X * x,
        rotate: Quat::from_rotation_y(turn),
        scale: x,
    };
    let track = Track {
        keys: vec![(1.0, key(1.0, 0.0)), (3.0, key(2.0, 1.0))],
    };
    let at = |time| track.at(time, Pose::between).unwrap();
    assert_eq!((at(0.0), at(1.0)), (key(1.0, 0.0), key(1.0, 0.0)));
    assert_eq!((at(3.0), at(9.0)), (key(2.0, 1.0), key(2.0, 1.0)));
    let half = at(2.0);
    assert_eq!((half.translate, half.scale), (Vec3::X * 1.5, 1.5));
    // A few roundings of f32.
    assert!(half.rotate.angle_between(Quat::from_rotation_y(0.5)) < 1e-3);
    assert_eq!(Track::<Pose>::default().at(0.0, Pose::between), None);
}

#[test]
fn an_orbit_keeps_its_distance() {
    let camera = Camera {
        eye: Vec3::new(0.0, 1.0, 2.0),
        target: Vec3::ZERO,
        up: Vec3::Y,
        vfov_deg: 40.0,
        resolution: [4, 4],
    };
    let motion = CameraMotion::Orbit { deg_per_s: 90.0 };
    let eye = motion.of(&camera, 1.0).eye;
    assert!(eye.distance(Vec3::new(2.0, 1.0, 0.0)) < 1e-6, "{eye}");
    assert_eq!(motion.of(&camera, 4.0), camera);
}

fn block(scene: &mut Scene) -> &mut Motion {
    scene.objects[1].motion.as_mut().unwrap()
}

#[test]
fn unsound_motions_are_refused() {
    for (change, expected) in [
        (
            (|s| block(s).poses.keys[2].0 = 1.0) as fn(&mut Scene),
            "object `block`: times of its motion do not increase",
        ),
        (
            |s| block(s).poses.keys[2].1.scale = 0.0,
            "object `block`: its pose at 2 s is not usable",
        ),
        (
            |s| block(s).poses.keys[2].1.translate.x = 2e15,
            "object `block`: its motion takes it beyond ±1e15 m at 2 s",
        ),
        (
            |s| block(s).deformation.as_mut().unwrap().period_s = 0.0,
            "object `block`: its deformation is not usable",
        ),
        (
            |s| s.motion.lights[0].direction.keys.push((0.0, Vec3::X)),
            "the motion of light 0 is not usable",
        ),
        (
            |s| s.motion.lights.resize(3, LightMotion::default()),
            "3 motions for 2 lights",
        ),
        (
            |s| s.motion.environment_deg_per_s = f32::INFINITY,
            "the environment turns by inf° per second",
        ),
        (
            |s| {
                let keys = vec![(0.0, [Vec3::Z, Vec3::ZERO]), (1.0, [-Vec3::Z, Vec3::ZERO])];
                s.motion.camera = Some(CameraMotion::Keyframes(Track { keys }));
            },
            "the camera has no valid view at some time from 0 s to 1 s",
        ),
    ] {
        let mut scene = moving();
        change(&mut scene);
        let error = scene.validate().expect_err(expected).to_string();
        assert!(error.contains(expected), "{error}");
    }
}
