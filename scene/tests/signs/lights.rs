//! What lights send where, and the frames of their views.

use crate::{ROUNDING, near};
use glam::Vec3;
use interreflect_scene::{
    Bounds, Light, LightFrame, Projection, RsmViews, SpotShape, Surroundings,
};
use std::f32::consts::FRAC_1_SQRT_2 as H;

fn only(frames: &[LightFrame]) -> LightFrame {
    assert_eq!(frames.len(), 1);
    frames[0]
}

const BOX: Bounds = Bounds {
    low: Vec3::new(-1.0, 0.0, 2.0),
    high: Vec3::new(3.0, 2.0, 6.0),
};

/// A spot's picture is upright and not mirrored: its columns go to the right of who looks along the
/// light, its rows down.
#[test]
fn a_spot_s_view_is_upright() {
    let position = Vec3::new(1.0, 2.0, 3.0);
    for (direction, up, right) in [
        (-Vec3::Z, Vec3::Y, Vec3::X),
        (Vec3::X, Vec3::Z, Vec3::NEG_Y),
        (-Vec3::Y, Vec3::new(H, 0.0, H), Vec3::new(-H, 0.0, H)),
    ] {
        let spot = Light::Spot {
            position,
            direction,
            up,
            shape: SpotShape::Square,
            angle_deg: 120.0,
            intensity: Vec3::ONE,
        };
        let frame = only(&spot.frames(7, &Surroundings::within(BOX), RsmViews::Picture));
        assert_eq!((frame.light, frame.origin), (7, position));
        assert_eq!(frame.projection, Projection::Perspective);
        near(frame.axis, direction);
        near(frame.right, right);
        near(frame.down, -up);
        let tan60 = 3_f64.sqrt();
        let (start, along) = frame.ray_through(0.5, -1.0);
        let expected = direction.as_dvec3() + tan60 * (0.5 * right + up).as_dvec3();
        assert!((along - expected).length() < 1e-5, "{along}");
        assert_eq!(start, position.as_dvec3());
        let unit = frame.ray(0.5, -1.0).1;
        assert!((unit - expected.normalize()).length() < 1e-5, "{unit}");
        assert!((frame.full_angle() - 120_f64.to_radians()).abs() < 1e-6);
        // Rays inside the view are lit, and those beyond its edge are not.
        for (s, t, lit) in [(0.99, -0.99, true), (1.01, 0.0, false), (0.0, 1.01, false)] {
            let (start, along) = frame.ray(s, t);
            let there = (start + along).as_vec3();
            assert_eq!(spot.incident(there).is_some(), lit, "{s} {t}");
        }
    }
}

/// Its view begins before the scene and looks along the light; texels are squares of one area.
#[test]
fn parallel_light_is_looked_along_from_outside() {
    let direction = Vec3::new(0.0, -0.6, 0.8);
    let light = Light::Directional {
        direction,
        irradiance: Vec3::ONE,
    };
    let frame = only(&light.frames(0, &Surroundings::within(BOX), RsmViews::Picture));
    assert_eq!(frame.projection, Projection::Orthographic);
    // Half the diagonal of 4 × 2 × 4 is 3; a hundredth more.
    assert!((frame.half - 3.03).abs() < 1e-5, "{}", frame.half);
    near(frame.axis, direction);
    near(frame.origin, Vec3::new(1.0, 1.0, 4.0) - 3.03 * direction);
    let (start, along) = frame.ray(0.5, -1.0);
    let across = 3.03 * (0.5 * frame.right - frame.down);
    near(start.as_vec3(), frame.origin + across);
    near(along.as_vec3(), direction);
    assert_eq!(frame.full_angle(), 0.0);
    let texel = frame.cell_measure(16, 3, 11);
    assert!((texel / (6.06_f64 / 16.0).powi(2) - 1.0).abs() < 1e-5);
    let arriving = light.incident(Vec3::new(9.0, 9.0, 9.0)).unwrap();
    assert_eq!(arriving.to_light, -direction);
    assert_eq!(arriving.distance, f32::INFINITY);
}

/// Point lights: the faces of a cube map, in its order. Area lights: the front first, then sides whose
/// later rows look to the front, where light goes.
#[test]
fn the_views_of_points_and_areas_are_faces_of_cubes() {
    let position = Vec3::new(1.0, 2.0, 3.0);
    let point = Light::Point {
        position,
        intensity: Vec3::ONE,
        picture: None,
    };
    let frames = point.frames(0, &Surroundings::within(BOX), RsmViews::Surround);
    let axes = [
        Vec3::X,
        Vec3::NEG_X,
        Vec3::Y,
        Vec3::NEG_Y,
        Vec3::Z,
        Vec3::NEG_Z,
    ];
    assert_eq!(frames.len(), 6);
    for (frame, axis) in frames.iter().zip(axes) {
        assert_eq!(
            (frame.axis, frame.origin, frame.half),
            (axis, position, 1.0)
        );
        // As hardware lays cubes out: left-handed.
        near(frame.right.cross(frame.down), -axis);
    }
    assert_eq!(frames[0].right, Vec3::NEG_Z);
    assert_eq!((frames[2].right, frames[2].down), (Vec3::X, Vec3::Z));
    let normal = Vec3::new(0.6, 0.0, 0.8);
    let area = Light::Area {
        position,
        normal,
        area_m2: 1.0,
        flux: Vec3::ONE,
        picture: None,
    };
    let frames = area.frames(0, &Surroundings::within(BOX), RsmViews::Surround);
    assert_eq!(frames.len(), 5);
    near(frames[0].axis, normal);
    for side in &frames[1..] {
        near(side.down, normal);
        assert!(side.axis.dot(normal).abs() < ROUNDING);
        for (t, lit) in [(0.5, true), (-0.5, false)] {
            let (start, along) = side.ray(0.3, t);
            let there = (start + along).as_vec3();
            assert_eq!(area.incident(there).is_some(), lit, "{side:?}");
        }
    }
}

#[test]
fn light_falls_by_the_square_of_the_distance() {
    let from = Vec3::new(1.0, 0.0, 0.0);
    let point = Light::Point {
        position: from,
        intensity: Vec3::new(8.0, 4.0, 2.0),
        picture: None,
    };
    let arriving = point.incident(Vec3::new(1.0, -2.0, 0.0)).unwrap();
    near(arriving.irradiance, Vec3::new(2.0, 1.0, 0.5));
    near(arriving.to_light, Vec3::Y);
    assert!((arriving.distance - 2.0).abs() < ROUNDING);
    assert_eq!(point.incident(from), None);
}
