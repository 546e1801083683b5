//! Skies of known irradiance, and the glossy lobe under a constant one.

use super::scenes::{cpu, directions, glowing, only, places, under, walls};
use super::{Ask, IRRADIANCE, exactly, hold};
use crate::variants::Outcome;
use glam::{DVec3, Vec3};
use interreflect_conformance::oracles::skies::{hemispherical_sky, linear_sky, quadratic_sky};
use interreflect_conformance::statistics::Scores;
use interreflect_cpu::path_tracer::PathQuantity;
use interreflect_scene::{
    Environment, LatLongImage, Point, PointLayout, Points, Role, Scene, SurfaceMaterial, shapes,
};
use libtest_mimic::Trial;
use std::f64::consts::{FRAC_PI_2, PI};

pub(super) fn trials() -> Vec<Trial> {
    let trial = |name: &str, test: fn() -> Outcome| {
        Trial::test(format!("path_reference/skies/{name}"), test)
    };
    vec![
        trial("constant", constant),
        trial("hemispherical", hemispherical),
        trial("smooth", smooth),
        trial("white_plate", white_plate),
        trial("bright_spot", bright_spot),
        trial("glossy_furnace", glossy_furnace),
    ]
}

/// No surface, and this sky.
fn beneath(environment: Environment) -> Scene {
    let mut scene = only([]);
    scene.environment = Some(environment);
    scene
}

/// A sky of this radiance in each direction.
fn image(width: u32, height: u32, radiance: impl Fn(Vec3) -> f32) -> LatLongImage {
    let mut image = LatLongImage {
        width,
        height,
        texels: Vec::new(),
    };
    let middles = (0..height).flat_map(|row| (0..width).map(move |column| (column, row)));
    image.texels = middles
        .map(|(c, r)| image.direction(c as f32 + 0.5, r as f32 + 0.5))
        .map(|direction| Vec3::splat(radiance(direction)))
        .collect();
    image
}

/// Places at the origin with normals all around.
fn all_around() -> Points {
    places(directions(60).map(|d| (Vec3::ZERO, d)))
}

fn constant() -> Outcome {
    let traced = IRRADIANCE.trace(&cpu(&under(only([]), 1.0)), &all_around());
    exactly(&traced, PI)
}

/// A black plane without end hides the lower half of the sky.
fn hemispherical() -> Outcome {
    let plane = shapes::quad(2000.0, 2000.0);
    let scene = under(only([(Role::Environment, plane, glowing(0.0, 0.0))]), 1.0);
    // 1 cm above it, the plane ends (1e-5)² of the sky below the horizon.
    let points = places(directions(60).map(|d| (Vec3::Y * 0.01, d)));
    let traced = IRRADIANCE.trace(&cpu(&scene), &points);
    let normals: Vec<Vec3> = directions(60).collect();
    let exact = |i: usize| hemispherical_sky(f64::from(normals[i].normalize().y));
    hold(Scores::against(&traced, exact), 0.01)
}

/// A white plate under a sky of radiance 1 can't be told from it, on either side.
fn white_plate() -> Outcome {
    let plate = (Role::Environment, shapes::quad(2.0, 2.0), glowing(1.0, 0.0));
    let scene = cpu(&under(only([plate]), 1.0));
    let points = places(directions(60).map(|d| (d * 0.8, -d)));
    let traced = IRRADIANCE.trace(&scene, &points);
    hold(Scores::against(&traced, |_| PI), 0.02)
}

/// A value by the cosine to a sky's axis.
type Profile<T> = fn(T) -> T;

/// Skies that are linear and quadratic in the direction.
fn smooth() -> Outcome {
    let axis = Vec3::new(0.5, 0.3, -0.7).normalize();
    let skies: [(Profile<f32>, Profile<f64>); 2] = [
        (|t| 0.7 + 0.6 * t, |c| linear_sky(0.7, 0.6, c)),
        (|t| t * t, quadratic_sky),
    ];
    for (radiance, exact) in skies {
        let sky = Environment {
            image: image(512, 256, |d| radiance(d.dot(axis))),
            scale: 1.0,
            rotate_deg: 0.0,
        };
        let traced = IRRADIANCE.trace(&cpu(&beneath(sky)), &all_around());
        let normals: Vec<Vec3> = directions(60).collect();
        let exact = |i: usize| DVec3::splat(exact(f64::from(normals[i].normalize().dot(axis))));
        // Between texels the image is bilinear: (π/256)²/8 times a second derivative of 2 at most.
        hold(Scores::new(&[(1.0, &traced)], exact, 1e-4), 0.02)?;
    }
    Ok(())
}

/// All light in one texel well above the horizon; by the midpoint rule over 2 000 000 directions.
fn bright_spot() -> Outcome {
    let (width, height, spot) = (64, 32, 6 * 64 + 20);
    let mut image = image(width, height, |_| 0.0);
    image.texels[spot] = Vec3::splat(1000.0);
    let sky = Environment {
        image,
        scale: 0.5,
        rotate_deg: 70.0,
    };
    let fine = 1000;
    let mut exact = 0.0;
    for i in 0..fine {
        let theta = (f64::from(i) + 0.5) * FRAC_PI_2 / f64::from(fine);
        for j in 0..2 * fine {
            let phi = (f64::from(j) + 0.5) * PI / f64::from(fine);
            let d = [
                theta.sin() * phi.sin(),
                theta.cos(),
                -theta.sin() * phi.cos(),
            ];
            let radiance = sky.radiance(Vec3::from(d.map(|c| c as f32)));
            exact += f64::from(radiance.x) * theta.cos() * theta.sin();
        }
    }
    exact *= PI * FRAC_PI_2 / f64::from(fine * fine);
    let up = places([(Vec3::ZERO, Vec3::Y)]);
    let traced = IRRADIANCE.trace(&cpu(&beneath(sky.clone())), &up);
    // The spot spans 60 × 60 of the rule's cells: 1/60² of it is left.
    let scores = Scores::new(&[(1.0, &traced)], |_| DVec3::splat(exact), 3e-4);
    hold(scores, 0.03)?;

    // It is not seen from inside a room, and must not take anything from the room's own light.
    let mut room = walls([glowing(0.0, 1.0); 6]);
    room.environment = Some(sky);
    let traced = IRRADIANCE.trace(&cpu(&room), &all_around());
    hold(Scores::against(&traced, |_| PI), 0.02)
}

/// Seen head-on, the normalised lobe reflects all of a constant sky: k_d + k_s.
fn glossy_furnace() -> Outcome {
    let scene = cpu(&under(only([]), 1.0));
    let point = |shininess: f32, direction: Vec3| Point {
        normal: direction,
        view: direction,
        material: SurfaceMaterial {
            diffuse: Vec3::splat(0.3),
            specular: Vec3::splat(0.6),
            shininess,
        },
        ..Point::default()
    };
    let glossy = Ask {
        quantity: PathQuantity::GlossyRadiance,
        samples: 4096,
        ..IRRADIANCE
    };
    for shininess in [0.0, 5.0, 60.0] {
        let list = directions(30).map(|d| Some(point(shininess, d)));
        let traced = glossy.trace(&scene, &Points::new(PointLayout::Material, list));
        hold(Scores::against(&traced, |_| 0.3 + 0.6), 5e-3)?;
    }
    Ok(())
}
