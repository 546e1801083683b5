//! Emitters of simple shapes, whose form factors are known.

use super::scenes::{
    DISC_ERROR, cpu, directions, disc, glowing, moved, only, places, polygon, walls,
};
use super::{IRRADIANCE, hold};
use crate::ensure;
use crate::variants::Outcome;
use glam::{DVec3, Vec3};
use interreflect_conformance::oracles::form_factors::{
    CUBE_ADJACENT, CUBE_OPPOSITE, coaxial_disc, coaxial_discs, offset_disc, parallel_rectangle,
    perpendicular_rectangle, sphere_above_horizon,
};
use interreflect_conformance::statistics::{FAMILY_ERROR, Scores, largest_bound, score_of};
use interreflect_scene::{Role, Scene, shapes};
use libtest_mimic::Trial;
use std::f64::consts::PI;

pub(super) fn trials() -> Vec<Trial> {
    let trial = |name: &str, test: fn() -> Outcome| {
        Trial::test(format!("path_reference/form_factors/{name}"), test)
    };
    vec![
        trial("faces_of_a_cube", faces_of_a_cube),
        trial("coaxial_discs", between_discs),
        trial("rectangle", rectangle),
        trial("standing_rectangle", standing_rectangle),
        trial("disc", discs),
        trial("sphere", spheres),
    ]
}

/// Nothing but a mesh that emits 1 from its front.
fn emitter(mesh: interreflect_scene::Mesh) -> Scene {
    only([(Role::Environment, mesh, glowing(0.0, 1.0))])
}

/// Groups of places that stand for the mean over a patch, and places in each.
const GROUPS: u32 = 32;
const PLACES: u32 = 256;

/// The normal score of the mean of E/π over a patch, less a form factor: `at` takes the unit square to
/// the patch. Each group is an independent scrambling of Sobol points, so that the error holds what
/// is left of the integral over the patch.
fn score_over(
    scene: &Scene,
    at: impl Fn(f32, f32) -> (Vec3, Vec3),
    factor: f64,
) -> Result<f64, libtest_mimic::Failed> {
    let groups = (0..GROUPS).flat_map(|group| (0..PLACES).map(move |i| (group, i)));
    let points = places(groups.map(|(group, i)| {
        let [u, v, ..] = sobol_burley::sample_4d(i, 0, group);
        at(u, v)
    }));
    let ask = super::Ask {
        samples: 64,
        ..IRRADIANCE
    };
    let traced = ask.trace(&cpu(scene), &points);
    let factors: Vec<f64> = traced.mean.iter().map(|e| f64::from(e.x) / PI).collect();
    let mean = |group: &[f64]| group.iter().sum::<f64>() / group.len() as f64;
    let means: Vec<f64> = factors.chunks(PLACES as usize).map(mean).collect();
    let off = mean(&means) / factor - 1.0;
    ensure!(off.abs() < 1e-2, "{off} relative: too noisy, or wrong");
    Ok(score_of(&means, factor))
}

fn small(scores: &[f64]) -> Outcome {
    let bound = largest_bound(scores.len(), FAMILY_ERROR);
    for (i, z) in scores.iter().enumerate() {
        ensure!(z.abs() <= bound, "case {i}: z = {z:.2}, bound {bound:.2}");
    }
    Ok(())
}

/// From the wall +x of a box to each of the others.
fn faces_of_a_cube() -> Outcome {
    let mut scores = Vec::new();
    for emitting in 1..6 {
        let mut materials = [glowing(0.0, 0.0); 6];
        materials[emitting] = glowing(0.0, 1.0);
        let factor = match emitting {
            1 => CUBE_OPPOSITE,
            _ => CUBE_ADJACENT,
        };
        let at = |u: f32, v: f32| {
            let place = Vec3::new(1.0, 2.0 * u - 1.0, 2.0 * v - 1.0);
            (place, Vec3::NEG_X)
        };
        scores.push(score_over(&walls(materials), at, factor)?);
    }
    small(&scores)
}

/// From a disc around the origin to one above it.
fn between_discs() -> Outcome {
    let mut scores = Vec::new();
    for (r1, r2, h) in [(1.0_f32, 2.0, 1.0), (1.0, 0.5, 0.3), (0.7, 0.9, 2.0)] {
        let at = |u: f32, v: f32| {
            let (s, c) = (v * std::f32::consts::TAU).sin_cos();
            (Vec3::new(c, s, 0.0) * (r1 * u.sqrt()), Vec3::Z)
        };
        let factor = coaxial_discs(r1.into(), r2.into(), h.into());
        let emitter = emitter(disc(Vec3::Z * h, r2));
        scores.push(score_over(&emitter, at, factor)?);
    }
    small(&scores)
}

/// Points on a wall that face the opposite one.
fn rectangle() -> Outcome {
    let mut materials = [glowing(0.0, 0.0); 6];
    materials[1] = glowing(0.0, 1.0);
    let list: Vec<[f32; 2]> = (0..256)
        .map(|i| {
            let [u, v, ..] = sobol_burley::sample_4d(i, 0, 0);
            [2.0 * u - 1.0, 2.0 * v - 1.0]
        })
        .collect();
    let points = places(
        list.iter()
            .map(|&[y, z]| (Vec3::new(1.0, y, z), Vec3::NEG_X)),
    );
    let traced = IRRADIANCE.trace(&cpu(&walls(materials)), &points);
    let exact = |i: usize| {
        let sides = |x: f32| [1.0 - f64::from(x), 1.0 + f64::from(x)];
        let [y, z] = list[i];
        let corners = sides(y).into_iter().flat_map(|a| sides(z).map(|b| (a, b)));
        PI * corners
            .map(|(a, b)| parallel_rectangle(a, b, 2.0))
            .sum::<f64>()
    };
    hold(Scores::against(&traced, exact), 0.01)
}

/// Points on a floor before a wall of height 1 that begins straight ahead.
fn standing_rectangle() -> Outcome {
    let wall = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0)];
    let wall = polygon(wall.map(|(x, z)| Vec3::new(x, 0.0, z)).into());
    let distances: Vec<f32> = (1..=40).map(|i| 0.05 * i as f32).collect();
    let points = places(
        distances
            .iter()
            .map(|&d| (Vec3::new(0.0, -d, 0.0), Vec3::Z)),
    );
    let traced = IRRADIANCE.trace(&cpu(&emitter(wall)), &points);
    let exact = |i: usize| PI * perpendicular_rectangle(1.0, 2.0, distances[i].into());
    hold(Scores::against(&traced, exact), 0.03)
}

/// Points in a plane below a disc.
fn discs() -> Outcome {
    let (radius, height) = (0.8_f32, 0.6_f32);
    // So far that ten of the samples and more still meet the disc: what so few of them see that all
    // may miss it is not normal.
    let offsets: Vec<f32> = (0..60).map(|i| 0.035 * i as f32).collect();
    let points = places(offsets.iter().map(|&a| (Vec3::X * a, Vec3::Z)));
    let traced = IRRADIANCE.trace(&cpu(&emitter(disc(Vec3::Z * height, radius))), &points);
    let exact = |i: usize| {
        let (r, h) = (radius.into(), height.into());
        DVec3::splat(
            PI * match offsets[i] {
                0.0 => coaxial_disc(r, h),
                a => offset_disc(r, h, a.into()),
            },
        )
    };
    hold(Scores::new(&[(1.0, &traced)], exact, DISC_ERROR), 0.02)
}

/// Points around a sphere that lies above their horizons.
fn spheres() -> Outcome {
    let radius = 0.5_f32;
    let ball = moved(shapes::sphere(radius, 40), Vec3::new(0.1, 0.2, 0.3));
    // 32 000 triangles, edges of 1.6°: the outline's radius is short by up to (1.6°)²/8 = 1e-4, its
    // area by twice that.
    let known = 2e-4;
    let directions: Vec<Vec3> = directions(60).collect();
    let (distance, tilt) = (1.4_f32, 0.6_f32);
    let points = places(directions.iter().map(|&d| {
        let normal = -d * tilt.cos() + d.any_orthonormal_vector() * tilt.sin();
        (Vec3::new(0.1, 0.2, 0.3) + d * distance, normal)
    }));
    let factor = sphere_above_horizon(radius.into(), distance.into(), f64::from(tilt).cos());
    let traced = IRRADIANCE.trace(&cpu(&emitter(ball)), &points);
    let exact = |_| DVec3::splat(PI * factor);
    hold(Scores::new(&[(1.0, &traced)], exact, known), 0.06)
}
