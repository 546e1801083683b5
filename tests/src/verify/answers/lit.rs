//! Walls that reflect a lamp's light.

use super::{Answer, Reduce, Setting, facing, orientations, scene};
use crate::oracles::form_factors::integrating_sphere;
use glam::{DVec3, Vec3};
use interreflect_estimators::{Answers, OwnModel, Quantity};
use interreflect_scene::{Light, LightPaths, Material, Scene, shapes};
use std::f64::consts::PI;

pub(super) fn all() -> Vec<Answer> {
    let answer = |name, about, kind, settings| Answer {
        name,
        about,
        kind,
        settings,
        reduce: Reduce::Each,
    };
    vec![
        answer(
            "integrating_sphere",
            "a lamp in the middle of a sphere: what its wall reflects arrives evenly everywhere",
            Answers::Uniform,
            |model, quantity| in_sphere(model, quantity, DVec3::ZERO, 0.8),
        ),
        answer(
            "integrating_sphere_beside",
            "a lamp beside the middle: the same arrives at the wall",
            Answers::Lit,
            |model, quantity| match model {
                // These see one radiance in each direction, and it is not the same everywhere.
                OwnModel::EnvironmentAtInfinity { .. } | OwnModel::MeanRadiance { .. } => None,
                _ => in_sphere(model, quantity, DVec3::new(0.35, -0.2, 0.1), 0.97),
            },
        ),
    ]
}

const ALBEDO: f64 = 0.6;

/// Points this far from the middle, in radii, which face inwards.
fn in_sphere(model: OwnModel, quantity: Quantity, lamp: DVec3, out: f64) -> Option<Vec<Setting>> {
    const RADIUS: f64 = 1.2;
    let all_bounces = match model {
        OwnModel::MeanRadiance { bounces: 0 }
        | OwnModel::EnvironmentAtInfinity { bounces: 0 }
        | OwnModel::VisibleFromReference { bounces: 0 }
        | OwnModel::FirstHitsOfLights { .. } => false,
        OwnModel::LightTransport(paths) if paths == LightPaths::default() => true,
        _ => return None,
    };
    if quantity != Quantity::Irradiance {
        return None;
    }
    let mesh = shapes::sphere(RADIUS as f32, 32);
    // 1 W/sr in all directions.
    let exact = DVec3::splat(4.0 * PI * integrating_sphere(ALBEDO, RADIUS, all_bounces));
    let points = orientations(60).map(|n| (facing(out * RADIUS * n, -n), exact));
    Some(vec![Setting {
        scene: Scene {
            lights: vec![Light::Point {
                position: lamp.as_vec3(),
                intensity: Vec3::ONE,
                picture: None,
            }],
            ..scene(
                vec![(mesh, Material::diffuse(Vec3::splat(ALBEDO as f32)))],
                DVec3::ZERO,
            )
        },
        points: points.collect(),
    }])
}
