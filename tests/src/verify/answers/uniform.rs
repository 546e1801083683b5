//! Surroundings of one radiance, and skies that change slowly.

use super::{Answer, Reduce, Setting, facing, orientations, scene};
use crate::oracles::form_factors::furnace_radiance;
use crate::oracles::skies::{hemispherical_sky, linear_sky, quadratic_sky};
use crate::verify::box_scene::sky;
use glam::{DVec3, Vec3};
use interreflect_estimators::{Answers, OwnModel, Quantity};
use interreflect_scene::material::blinn_phong_normalisation;
use interreflect_scene::{Environment, Material, Point, Scene, shapes};
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
            "furnace_sky",
            "a constant sky of radiance 1 gives π",
            Answers::Uniform,
            |model, quantity| match model {
                OwnModel::FirstHitsOfLights { .. } => None,
                _ => Some(vec![everywhere(furnace_sky(), quantity, 1.0)]),
            },
        ),
        answer(
            "furnace_box",
            "a box of radiance 1 gives π",
            Answers::Uniform,
            |model, quantity| {
                emitting(
                    model,
                    quantity,
                    shapes::cuboid(Vec3::new(2.0, 1.5, 2.5), shapes::Facing::Inward),
                )
            },
        ),
        answer(
            "furnace_sphere",
            "a sphere of radiance 1 gives π",
            Answers::Uniform,
            |model, quantity| {
                let mut mesh = shapes::sphere(1.0, 12);
                mesh.triangles.iter_mut().for_each(|t| t.swap(1, 2));
                mesh.normals.clear();
                emitting(model, quantity, mesh)
            },
        ),
        answer(
            "furnace_of_albedo",
            "a box that emits 1 and reflects a half gives the sum of its reflections",
            Answers::Uniform,
            reflecting,
        ),
        answer(
            "linear_sky",
            "a sky of radiance 1 + b·(d·m) gives π(1 + ⅔b·(n·m))",
            Answers::Smooth,
            |model, quantity| {
                let exact = |n: DVec3| linear_sky(1.0, SLOPE, n.dot(AXIS));
                under(model, quantity, |d| 1.0 + SLOPE * d.dot(AXIS), exact)
            },
        ),
        answer(
            "quadratic_sky",
            "a sky of radiance (d·m)² gives π/4·(1 + (n·m)²)",
            Answers::Smooth,
            |model, quantity| {
                let exact = |n: DVec3| quadratic_sky(n.dot(AXIS));
                under(model, quantity, |d| d.dot(AXIS).powi(2), exact)
            },
        ),
        answer(
            "hemispherical_sky",
            "a sky of radiance 1 above gives π/2·(1 + cos)",
            Answers::Patches,
            |model, quantity| {
                under(
                    model,
                    quantity,
                    |d| f64::from(u8::from(d.y > 0.0)),
                    |n| hemispherical_sky(n.y),
                )
            },
        ),
    ]
}

/// Where the smooth skies are brightest.
const AXIS: DVec3 = DVec3::new(0.48, -0.6, 0.64);

/// How bright the linear sky's bright side is beside its mean.
const SLOPE: f64 = 0.8;

fn furnace_sky() -> Scene {
    Scene {
        environment: Some(Environment::constant(Vec3::ONE)),
        ..scene(Vec::new(), DVec3::ZERO)
    }
}

/// Points in all orientations where the same radiance arrives from everywhere.
fn everywhere(scene: Scene, quantity: Quantity, radiance: f64) -> Setting {
    let point = |(i, n): (usize, DVec3)| {
        let at = DVec3::new(0.31, -0.22, 0.4) * [0.0, 0.7, -1.0][i % 3];
        let point = facing(at, n);
        let exact = match quantity {
            Quantity::Irradiance => DVec3::splat(PI * radiance),
            Quantity::GlossyRadiance => albedo(&point) * radiance,
            Quantity::AmbientOcclusion => DVec3::splat(1.0),
        };
        (point, exact)
    };
    Setting {
        scene,
        points: orientations(60).enumerate().map(point).collect(),
    }
}

/// What a material reflects of surroundings of radiance 1 to the viewer, by the midpoint rule over
/// the hemisphere: 256² cells, whose error is far below the bounds here.
fn albedo(point: &Point) -> DVec3 {
    const CELLS: u32 = 256;
    let (n, v) = (point.normal.as_dvec3(), point.view.as_dvec3());
    let (s, t) = n.any_orthonormal_pair();
    let exponent = f64::from(point.material.shininess);
    let at = |k: u32| (f64::from(k) + 0.5) / f64::from(CELLS);
    let mut lobe = 0.0;
    for k in 0..CELLS * CELLS {
        let (cos2, phi) = (at(k / CELLS), 2.0 * PI * at(k % CELLS));
        let (sin, cos) = ((1.0 - cos2).sqrt(), cos2.sqrt());
        let i = s * (sin * phi.cos()) + t * (sin * phi.sin()) + n * cos;
        lobe += (i + v).normalize().dot(n).max(0.0).powf(exponent);
    }
    // Cells of equal cos·dω: π over their number.
    lobe *= blinn_phong_normalisation(exponent) * PI / f64::from(CELLS * CELLS);
    let material = point.material;
    material.diffuse.as_dvec3() + material.specular.as_dvec3() * lobe
}

/// Inside a closed mesh that emits 1.
fn emitting(
    model: OwnModel,
    quantity: Quantity,
    mesh: interreflect_scene::Mesh,
) -> Option<Vec<Setting>> {
    let surroundings = !matches!(
        model,
        OwnModel::FirstHitsOfLights { .. } | OwnModel::OccludedEnvironment
    );
    let light = quantity != Quantity::AmbientOcclusion;
    (surroundings && light).then(|| {
        let surfaces = vec![(mesh, Material::emitter(Vec3::ONE))];
        vec![everywhere(
            scene(surfaces, DVec3::new(0.1, -0.05, 0.2)),
            quantity,
            1.0,
        )]
    })
}

/// A box that emits 1 and has the albedo ½.
fn reflecting(model: OwnModel, quantity: Quantity) -> Option<Vec<Setting>> {
    let bounces = match model {
        OwnModel::MeanRadiance { bounces }
        | OwnModel::EnvironmentAtInfinity { bounces }
        | OwnModel::VisibleFromReference { bounces } => Some(bounces as i32),
        OwnModel::LightTransport(paths) if paths == Default::default() => None,
        _ => return None,
    };
    let material = Material {
        albedo: Vec3::splat(0.5),
        ..Material::emitter(Vec3::ONE)
    };
    let mesh = shapes::cuboid(Vec3::splat(2.0), shapes::Facing::Inward);
    let radiance = furnace_radiance(0.5, bounces);
    let light = quantity != Quantity::AmbientOcclusion;
    light.then(|| {
        vec![everywhere(
            scene(vec![(mesh, material)], DVec3::ZERO),
            quantity,
            radiance,
        )]
    })
}

/// Rows of the skies' images.
const ROWS: u32 = 64;

/// Under a sky, with irradiance known by the normal.
fn under(
    model: OwnModel,
    quantity: Quantity,
    radiance: fn(DVec3) -> f64,
    exact: fn(DVec3) -> f64,
) -> Option<Vec<Setting>> {
    let by_direction = match model {
        OwnModel::EnvironmentAtInfinity { .. }
        | OwnModel::VisibleFromReference { .. }
        | OwnModel::OccludedEnvironment
        | OwnModel::LightTransport(_) => quantity == Quantity::Irradiance,
        _ => false,
    };
    by_direction.then(|| {
        let points = orientations(60).map(|n| (facing(DVec3::ZERO, n), DVec3::splat(exact(n))));
        vec![Setting {
            scene: Scene {
                environment: Some(sky(ROWS, |d| radiance(d.as_dvec3()) as f32)),
                ..scene(Vec::new(), DVec3::ZERO)
            },
            points: points.collect(),
        }]
    })
}
