use super::*;
use crate::SpotShape;
use std::f64::consts::PI;

fn frames(light: &Light) -> Vec<LightFrame> {
    let bounds = Bounds {
        low: -Vec3::ONE,
        high: Vec3::new(1.0, 2.0, 3.0),
    };
    light.frames(0, &Surroundings::within(bounds), RsmViews::Surround)
}

fn solid_angle(frames: &[LightFrame], size: u32) -> f64 {
    let cells = (0..size * size).map(|i| (i % size, i / size));
    let of = |f: &LightFrame| -> f64 {
        let measure = |(column, row)| f.cell_measure(size, column, row);
        cells.clone().map(measure).sum()
    };
    frames.iter().map(of).sum()
}

#[test]
fn views_fill_what_a_light_shines_into() {
    let (position, one) = (Vec3::new(0.3, 0.2, 0.1), Vec3::ONE);
    let point = Light::Point {
        position,
        intensity: one,
        picture: None,
    };
    let area = Light::Area {
        position,
        normal: Vec3::new(0.6, 0.0, 0.8),
        area_m2: 1.0,
        flux: one,
        picture: None,
    };
    let spot = Light::Spot {
        position,
        direction: Vec3::X,
        up: Vec3::Y,
        shape: SpotShape::Square,
        angle_deg: 90.0,
        intensity: one,
    };
    for (light, expected) in [
        (point, 4.0 * PI),
        (area, 10.0 / 3.0 * PI),
        (spot, 2.0 / 3.0 * PI),
    ] {
        let found = solid_angle(&frames(&light), 8);
        // The spot's tangent is rounded to f32.
        assert!((found / expected - 1.0).abs() < 1e-6, "{light:?}: {found}");
    }
}

#[test]
fn rays_of_a_directional_light_pass_all_of_the_scene() {
    let light = Light::Directional {
        direction: Vec3::new(0.0, -0.6, 0.8),
        irradiance: Vec3::ONE,
    };
    let [frame] = frames(&light)[..] else {
        panic!("one view")
    };
    for corner in [
        -Vec3::ONE,
        Vec3::new(1.0, 2.0, 3.0),
        Vec3::new(-1.0, 2.0, 3.0),
    ] {
        let offset = corner - frame.origin;
        assert!(offset.dot(frame.axis) > 0.0, "{corner}");
        for across in [frame.right, frame.down] {
            assert!(offset.dot(across).abs() <= frame.half, "{corner}");
        }
    }
}

#[test]
fn the_sides_of_an_area_light_meet_its_front() {
    let light = Light::Area {
        position: Vec3::ZERO,
        normal: Vec3::Y,
        area_m2: 1.0,
        flux: Vec3::ONE,
        picture: None,
    };
    let frames = frames(&light);
    for frame in &frames {
        let orthogonal = [
            frame.axis.dot(frame.right),
            frame.axis.dot(frame.down),
            frame.right.dot(frame.down),
        ];
        assert!(orthogonal.iter().all(|d| d.abs() < 1e-6), "{frame:?}");
    }
    let middles: Vec3 = frames[1..].iter().map(|f| f.axis).sum();
    assert!(middles.length() < 1e-6, "{middles}");
}

#[test]
fn a_picture_is_one_view_where_it_is_aimed() {
    let bounds = Bounds {
        low: Vec3::ZERO,
        high: Vec3::new(2.0, 4.0, 2.0),
    };
    let point = |position, picture| Light::Point {
        position,
        intensity: Vec3::ONE,
        picture,
    };
    let picture = LightPicture::towards(Vec3::X, 60.0);
    let above = Vec3::new(1.0, 3.0, 1.0);
    let middle = bounds.centre();
    for (light, at, axis, angle_deg) in [
        (point(above, Some(picture)), above, Vec3::X, 60.0),
        (point(above, None), above, Vec3::NEG_Y, 90.0),
        (point(middle, None), middle, Vec3::NEG_Y, 90.0),
        (
            Light::Area {
                position: above,
                normal: Vec3::Z,
                area_m2: 1.0,
                flux: Vec3::ONE,
                picture: None,
            },
            above,
            Vec3::Z,
            90.0,
        ),
    ] {
        let around = Surroundings::within(bounds);
        let [frame] = light.frames(3, &around, RsmViews::Picture)[..] else {
            panic!("one view of {light:?}")
        };
        assert_eq!((frame.light, frame.origin), (3, at));
        assert!(frame.axis.distance(axis) < 1e-6, "{frame:?}");
        assert!(
            (frame.full_angle().to_degrees() - angle_deg).abs() < 1e-4,
            "{frame:?}"
        );
        // As an image: its right, seen along the axis with `up` above.
        assert!(
            frame.axis.cross(-frame.down).distance(frame.right) < 1e-6,
            "{frame:?}"
        );
    }
}

/// A receiver that moves about does not turn the picture of a light at rest.
#[test]
fn pictures_are_aimed_at_what_stands_still() {
    let quad = |role, at: Vec3| {
        let mut mesh = crate::shapes::quad(1.0, 1.0);
        mesh.positions.iter_mut().for_each(|p| *p += at);
        crate::Object {
            name: "quad".into(),
            role,
            mesh,
            motion: None,
        }
    };
    let request = crate::SceneRequest::new("cornell-box");
    let mut scene = crate::open(&request).expect("a library scene");
    let middle = |scene: &Scene| Surroundings::of(scene).middle;
    let alone = middle(&scene);
    scene
        .objects
        .push(quad(crate::Role::Receiver, Vec3::X * 9.0));
    assert_eq!(middle(&scene), alone);
    assert!(Surroundings::of(&scene).all.high.x > 9.0);
    scene.objects.retain(|o| o.role == crate::Role::Receiver);
    assert!(middle(&scene).distance(Vec3::X * 9.0) < 1e-5);
}
