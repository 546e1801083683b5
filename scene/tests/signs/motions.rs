//! How meshes, lights and the environment move.

use crate::{ROUNDING, boxed, near};
use glam::{Quat, Vec3};
use interreflect_scene::motion::{
    CameraMotion, Deformation, DeformationKind, LightMotion, Motion, Pose, Track,
};
use interreflect_scene::{Light, LightPicture, Moves, SceneMotion, SceneRequest, SpotShape, open};
use std::f32::consts::FRAC_1_SQRT_2 as H;

/// The definitions of the deformations at a quarter of the period, where the sine is 1: lengths are
/// relative to half of the longest side, here 2 m, coordinates to the middle of the box.
#[test]
fn deformations_are_those_that_their_names_say() {
    let centre = Vec3::new(5.0, -3.0, 1.0);
    let q = Vec3::new(0.5, 0.5, -0.25);
    let place = |kind, amount: f32, time_s: f32, q: Vec3| {
        let deformation = Deformation {
            kind,
            period_s: 2.0,
            amount,
        };
        let motion = Motion {
            deformation: Some(deformation),
            ..Motion::default()
        };
        (motion.of(&boxed(centre, &[q]), time_s).positions[2] - centre) / 2.0
    };
    // R_y(0.8·0.5): x' = x cos + z sin, z' = −x sin + z cos.
    let (sin, cos) = 0.4_f32.sin_cos();
    let twisted = Vec3::new(0.5 * cos - 0.25 * sin, 0.5, -0.5 * sin - 0.25 * cos);
    near(place(DeformationKind::Twist, 0.8, 0.5, q), twisted);
    // sin(π/2) = 1 at y = ½.
    let waved = q + Vec3::X * 0.15;
    near(place(DeformationKind::Wave, 0.15, 0.5, q), waved);
    // cos²(π/4) = ½ at y = ½: x and z grow by half the amount.
    let breathed = Vec3::new(q.x * 1.1, q.y, q.z * 1.1);
    near(place(DeformationKind::Breathe, 0.2, 0.5, q), breathed);
    let middle = Vec3::new(0.5, 0.0, 0.0);
    near(
        place(DeformationKind::Breathe, 0.2, 0.5, middle),
        1.2 * middle,
    );
    // Half a period later everything swings to the other side.
    let untwisted = Vec3::new(0.5 * cos + 0.25 * sin, 0.5, 0.5 * sin - 0.25 * cos);
    near(place(DeformationKind::Twist, 0.8, 1.5, q), untwisted);
    near(
        place(DeformationKind::Wave, 0.15, 1.5, q),
        q - Vec3::X * 0.15,
    );
    // A twelfth of the period: the sine is ½.
    near(
        place(DeformationKind::Wave, 0.15, 1.0 / 6.0, q),
        q + Vec3::X * 0.075,
    );
    assert_eq!(Deformation::PERIOD_S, 2.0);
    for (kind, amount) in [
        (DeformationKind::Twist, 0.8),
        (DeformationKind::Wave, 0.15),
        (DeformationKind::Breathe, 0.15),
    ] {
        assert_eq!(Deformation::new(kind).amount, amount);
    }
}

/// Scaled, then turned, both about the middle of the box at rest, then moved; normals turn along.
#[test]
fn a_pose_scales_turns_and_moves_about_the_middle() {
    let centre = Vec3::new(5.0, -3.0, 1.0);
    let mesh = boxed(centre, &[Vec3::X]);
    let pose = Pose {
        translate: Vec3::new(0.0, 0.0, 7.0),
        rotate: Quat::from_rotation_z(90_f32.to_radians()),
        scale: 3.0,
    };
    let motion = Motion {
        poses: Track {
            keys: vec![(0.0, pose)],
        },
        ..Motion::default()
    };
    let moved = motion.of(&mesh, 0.0);
    // 2 m to the right of the middle, three times as far, above it after the turn.
    near(moved.positions[2], centre + Vec3::new(0.0, 6.0, 7.0));
    near(moved.normals[2], Vec3::NEG_X);
    let between = Pose::between(Pose::REST, pose, 0.25);
    near(between.translate, Vec3::new(0.0, 0.0, 1.75));
    assert!((between.scale - 1.5).abs() < ROUNDING);
    let turned = between.rotate * Vec3::X;
    let quarter = 22.5_f32.to_radians();
    near(turned, Vec3::new(quarter.cos(), quarter.sin(), 0.0));
}

#[test]
fn lights_go_on_straight_lines_and_great_circles() {
    let motion = LightMotion {
        position: Track {
            keys: vec![(0.0, Vec3::ZERO), (2.0, Vec3::new(2.0, 0.0, -4.0))],
        },
        direction: Track {
            keys: vec![(0.0, Vec3::X), (2.0, Vec3::Y)],
        },
    };
    let at = Vec3::new(1.0, 0.0, -2.0);
    let towards = Vec3::new(H, H, 0.0);
    let point = Light::Point {
        position: Vec3::ONE,
        intensity: Vec3::ONE,
        picture: None,
    };
    let Light::Point { position, .. } = motion.of(&point, 1.0) else {
        panic!("still a point light");
    };
    near(position, at);
    let directional = Light::Directional {
        direction: Vec3::Z,
        irradiance: Vec3::ONE,
    };
    let Light::Directional { direction, .. } = motion.of(&directional, 1.0) else {
        panic!("still a directional light");
    };
    near(direction, towards);
    let area = Light::Area {
        position: Vec3::ONE,
        normal: Vec3::Z,
        area_m2: 1.0,
        flux: Vec3::ONE,
        picture: None,
    };
    let Light::Area {
        position, normal, ..
    } = motion.of(&area, 1.0)
    else {
        panic!("still an area light");
    };
    near(position, at);
    near(normal, towards);
    // Its picture turns with it, about x × y = z; a point light's stays.
    let picture = Some(LightPicture::towards(Vec3::X, 60.0));
    let area = Light::Area {
        position: Vec3::ONE,
        normal: Vec3::X,
        area_m2: 1.0,
        flux: Vec3::ONE,
        picture,
    };
    let Light::Area {
        picture: Some(turned),
        ..
    } = motion.of(&area, 1.0)
    else {
        panic!("an area light with a picture");
    };
    near(turned.direction, towards);
    near(turned.up, Vec3::new(-H, H, 0.0));
    let point = Light::Point {
        position: Vec3::ONE,
        intensity: Vec3::ONE,
        picture,
    };
    let Light::Point { picture: kept, .. } = motion.of(&point, 1.0) else {
        panic!("still a point light");
    };
    assert_eq!(kept, picture);
    // A spot turns about x × y = z: what is up along z stays, what is up along y goes to −x.
    for (up, turned) in [(Vec3::Z, Vec3::Z), (Vec3::Y, Vec3::new(-H, H, 0.0))] {
        let spot = Light::Spot {
            position: Vec3::ONE,
            direction: Vec3::X,
            up,
            shape: SpotShape::Square,
            angle_deg: 60.0,
            intensity: Vec3::ONE,
        };
        let Light::Spot {
            position,
            direction,
            up,
            ..
        } = motion.of(&spot, 1.0)
        else {
            panic!("still a spot light");
        };
        near(position, at);
        near(direction, towards);
        near(up, turned);
    }
}

#[test]
fn an_environment_turns_on_from_its_own_angle() {
    let mut scene = open(&SceneRequest::new("studio")).unwrap();
    scene.environment.as_mut().unwrap().rotate_deg = 20.0;
    scene.motion.environment_deg_per_s = 25.0;
    let angle = |time_s| scene.at(time_s).environment.unwrap().rotate_deg;
    assert!((angle(2.0) - 70.0).abs() < 1e-4, "{}", angle(2.0));
    assert!((angle(-2.0) + 30.0).abs() < 1e-4, "{}", angle(-2.0));
    // 500° are 140°.
    assert!((angle(20.0) - 160.0).abs() < 1e-4, "{}", angle(20.0));
}

/// One motion at a time, and nothing else is told.
#[test]
fn only_what_moves_is_told_to_move() {
    let still = open(&SceneRequest::new("colored-room")).unwrap();
    let told = |change: &dyn Fn(&mut interreflect_scene::Scene)| {
        let mut scene = still.clone();
        change(&mut scene);
        scene.moves()
    };
    let nothing = Moves::default();
    assert_eq!(told(&|_| {}), nothing);
    let geometry = told(&|s| {
        s.objects[0].motion = Some(Motion {
            deformation: Some(Deformation::new(DeformationKind::Wave)),
            ..Motion::default()
        });
    });
    assert_eq!(
        geometry,
        Moves {
            geometry: true,
            ..nothing
        }
    );
    let camera = told(&|s| s.motion.camera = Some(CameraMotion::Orbit { deg_per_s: -1.0 }));
    assert_eq!(
        camera,
        Moves {
            camera: true,
            ..nothing
        }
    );
    let lights = told(&|s| {
        let position = Track {
            keys: vec![(0.0, Vec3::ZERO), (1.0, Vec3::X)],
        };
        s.motion.lights = vec![LightMotion {
            position,
            ..LightMotion::default()
        }];
    });
    assert_eq!(
        lights,
        Moves {
            lights: true,
            ..nothing
        }
    );
    // What is there but stands still does not move.
    let resting = told(&|s| {
        s.objects[0].motion = Some(Motion {
            poses: Track {
                keys: vec![(0.0, Pose::REST), (1.0, Pose::REST)],
            },
            ..Motion::default()
        });
        s.motion = SceneMotion {
            camera: Some(CameraMotion::Orbit { deg_per_s: 0.0 }),
            lights: vec![LightMotion::default()],
            environment_deg_per_s: 5.0,
        };
    });
    assert_eq!(resting, nothing, "there is no environment");
}
