//! The camera's rays, and how it moves.

use crate::{ROUNDING, near};
use glam::Vec3;
use interreflect_scene::Camera;
use interreflect_scene::motion::{CameraMotion, Track};
use std::f32::consts::FRAC_1_SQRT_2 as H;

/// Looks along −z; up lies half-way between +x and +y, and leans towards the target.
fn tilted_camera(resolution: [u32; 2]) -> Camera {
    let eye = Vec3::new(1.0, 2.0, 3.0);
    Camera {
        eye,
        target: eye - 4.0 * Vec3::Z,
        up: Vec3::new(1.0, 1.0, -0.5),
        vfov_deg: 90.0,
        resolution,
    }
}

/// Right is forward × up, so (1, −1, 0)/√2 here. The vertical field of view spans the height: at 90°
/// the upper edge of any image is 45° above the axis, and the right one twice as far across in an
/// image twice as wide as high.
#[test]
fn rays_leave_a_tilted_camera_through_an_image_that_is_not_square() {
    let (forward, right, up) = (-Vec3::Z, Vec3::new(H, -H, 0.0), Vec3::new(H, H, 0.0));
    for ([width, height], aspect) in [([200, 100], 2.0), ([60, 120], 0.5), ([64, 64], 1.0)] {
        let camera = tilted_camera([width, height]);
        let (w, h) = (width as f32, height as f32);
        for (x, y, across, above) in [
            (0.5 * w, 0.5 * h, 0.0, 0.0),
            (0.5 * w, 0.0, 0.0, 1.0),
            (0.5 * w, h, 0.0, -1.0),
            (w, 0.5 * h, aspect, 0.0),
            (0.0, 0.5 * h, -aspect, 0.0),
            (0.75 * w, 0.25 * h, 0.5 * aspect, 0.5),
        ] {
            let expected = (forward + across * right + above * up).normalize();
            near(camera.ray(x, y), expected);
        }
    }
    let narrow = Camera {
        vfov_deg: 60.0,
        ..tilted_camera([200, 100])
    };
    let edge = narrow.ray(100.0, 0.0);
    assert!((edge.dot(forward) - 30_f32.to_radians().cos()).abs() < ROUNDING);
}

/// Counter-clockwise seen from above, whatever "above" is: a quarter turn about +x takes +y to +z,
/// one about +z takes +x to +y, and what lies along the axis stays.
#[test]
fn an_orbit_turns_about_the_camera_s_own_up() {
    let target = Vec3::new(3.0, -1.0, 2.0);
    for (up, offset, quarter) in [
        (Vec3::Y, Vec3::Z, Vec3::X),
        (Vec3::X, Vec3::new(0.5, 2.0, 0.0), Vec3::new(0.5, 0.0, 2.0)),
        (
            2.0 * Vec3::Z,
            Vec3::new(1.0, 0.0, -0.25),
            Vec3::new(0.0, 1.0, -0.25),
        ),
        (
            // About (1, 1, 0)/√2 the vector (1, −1, 0) goes to −2/√2·z.
            Vec3::new(1.0, 1.0, 0.0),
            Vec3::new(1.0, -1.0, 0.0),
            Vec3::new(0.0, 0.0, -2.0 * H),
        ),
    ] {
        let camera = Camera {
            eye: target + offset,
            target,
            up,
            ..tilted_camera([4, 2])
        };
        let motion = CameraMotion::Orbit { deg_per_s: 45.0 };
        let moved = motion.of(&camera, 2.0);
        near(moved.eye - target, quarter);
        // Half a turn mirrors what is across the axis; a turn back undoes a turn.
        let axis = up.normalize();
        let along = axis * offset.dot(axis);
        near(motion.of(&camera, 4.0).eye - target, 2.0 * along - offset);
        near(motion.of(&moved, -2.0).eye - target, offset);
        assert_eq!(
            Camera {
                eye: camera.eye,
                ..moved
            },
            camera,
            "only the eye moves"
        );
    }
}

#[test]
fn cameras_between_keyframes_are_on_the_way() {
    let camera = tilted_camera([4, 2]);
    let keys = vec![
        (1.0, [Vec3::ZERO, Vec3::Z]),
        (3.0, [Vec3::new(4.0, 0.0, 8.0), Vec3::new(0.0, 2.0, 1.0)]),
    ];
    let motion = CameraMotion::Keyframes(Track { keys });
    let moved = motion.of(&camera, 1.5);
    near(moved.eye, Vec3::new(1.0, 0.0, 2.0));
    near(moved.target, Vec3::new(0.0, 0.5, 1.0));
    assert_eq!((moved.up, moved.vfov_deg), (camera.up, camera.vfov_deg));
    assert_eq!(motion.of(&camera, 0.0).eye, Vec3::ZERO);
    assert_eq!(motion.of(&camera, 9.0).eye, Vec3::new(4.0, 0.0, 8.0));
}
