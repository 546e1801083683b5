//! Directions, turns and signs of cameras, motions, lights and their frames, each against a value
//! worked out by hand: tilted up vectors, images that are not square, objects off centre.
#![allow(clippy::unwrap_used, reason = "tests")]

use glam::{DVec3, Quat, Vec3};
use interreflect_scene::motion::{
    CameraMotion, Deformation, DeformationKind, LightMotion, Motion, Pose, Track,
};
use interreflect_scene::{
    BoundingSphere, Bounds, Camera, DepthMap, DirectionalFrame, Light, LightFrame, Mesh, Moves,
    Projection, Role, SceneMotion, SceneRequest, SpotShape, open,
};
use std::f32::consts::FRAC_1_SQRT_2 as H;

/// A few roundings of float32 numbers near 1.
const ROUNDING: f32 = 2e-6;

#[track_caller]
fn near(found: Vec3, expected: Vec3) {
    let apart = found.distance(expected);
    let allowed = ROUNDING * expected.length().max(1.0);
    assert!(apart <= allowed, "{found} is not {expected}");
}

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

/// A box from −2 to 2 about a centre, its corners and three further vertices.
fn boxed(centre: Vec3, more: &[Vec3]) -> Mesh {
    let mut positions = vec![centre - 2.0 * Vec3::ONE, centre + 2.0 * Vec3::ONE];
    positions.extend(more.iter().map(|p| centre + 2.0 * *p));
    Mesh {
        normals: vec![Vec3::Y; positions.len()],
        positions,
        triangles: vec![[0, 1, 2]],
        materials: vec![0],
    }
}

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
        deformation: None,
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
    };
    let Light::Area {
        position, normal, ..
    } = motion.of(&area, 1.0)
    else {
        panic!("still an area light");
    };
    near(position, at);
    near(normal, towards);
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
            deformation: None,
        });
        s.motion = SceneMotion {
            camera: Some(CameraMotion::Orbit { deg_per_s: 0.0 }),
            lights: vec![LightMotion::default()],
            environment_deg_per_s: 5.0,
        };
    });
    assert_eq!(resting, nothing, "there is no environment");
}

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
        let frame = only(&spot.frames(7, &BOX));
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
    let frame = only(&light.frames(0, &BOX));
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
    };
    let frames = point.frames(0, &BOX);
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
    };
    let frames = area.frames(0, &BOX);
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
    };
    let arriving = point.incident(Vec3::new(1.0, -2.0, 0.0)).unwrap();
    near(arriving.irradiance, Vec3::new(2.0, 1.0, 0.5));
    near(arriving.to_light, Vec3::Y);
    assert!((arriving.distance - 2.0).abs() < ROUNDING);
    assert_eq!(point.incident(from), None);
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
