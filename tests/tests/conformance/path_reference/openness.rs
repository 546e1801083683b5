//! Openness beside shapes that hide a known part of the sky.

use super::scenes::{cpu, directions, glowing, moved, only, places, polygon, under};
use super::{Ask, IRRADIANCE, hold};
use crate::ensure;
use crate::variants::Outcome;
use glam::{DVec3, Vec3};
use interreflect_conformance::oracles::form_factors::{
    openness_beside_half_space, openness_beside_sphere, openness_beside_wall, openness_in_pit,
    parallel_rectangle,
};
use interreflect_conformance::statistics::Scores;
use interreflect_cpu::path_tracer::PathQuantity;
use interreflect_scene::{LightPaths, Mesh, Role, Scene, SceneRequest, open, shapes};
use libtest_mimic::Trial;
use std::f64::consts::PI;

pub(super) fn trials() -> Vec<Trial> {
    let trial = |name: &str, test: fn() -> Outcome| {
        Trial::test(format!("path_reference/openness/{name}"), test)
    };
    vec![
        trial("sphere", sphere),
        trial("half_space", half_space),
        trial("wall", wall),
        trial("pit", pit),
        trial("irradiance_under_a_sky_of_one", as_irradiance),
    ]
}

const OPENNESS: Ask = Ask {
    quantity: PathQuantity::AmbientOcclusion,
    ..IRRADIANCE
};

/// Nothing but a black receiver.
fn receiver(mesh: Mesh) -> Scene {
    only([(Role::Receiver, mesh, glowing(0.0, 0.0))])
}

fn sphere() -> Outcome {
    let (radius, tilt) = (0.5_f32, 0.5_f32);
    let ball = cpu(&receiver(moved(shapes::sphere(radius, 40), Vec3::X)));
    let list: Vec<(Vec3, f32)> = directions(60)
        .enumerate()
        .map(|(i, d)| (d, 1.0 + 0.02 * i as f32))
        .collect();
    let points = places(list.iter().map(|&(d, distance)| {
        let normal = -d * tilt.cos() + d.any_orthonormal_vector() * tilt.sin();
        (Vec3::X + d * distance, normal)
    }));
    let traced = OPENNESS.trace(&ball, &points);
    let exact = |i: usize| {
        let (r, d) = (f64::from(radius), f64::from(list[i].1));
        DVec3::splat(openness_beside_sphere(r, d, f64::from(tilt).cos()))
    };
    // Edges of 1.6° leave the outline's area short by 2e-4 of a quarter of the view at most.
    hold(Scores::new(&[(1.0, &traced)], exact, 6e-5), 0.02)
}

fn half_space() -> Outcome {
    let plane = cpu(&receiver(shapes::quad(2000.0, 2000.0)));
    let normals: Vec<Vec3> = directions(60).map(Vec3::normalize).collect();
    let points = places(normals.iter().map(|&n| (Vec3::Y * 0.01, n)));
    let traced = OPENNESS.trace(&plane, &points);
    let exact = |i: usize| openness_beside_half_space(normals[i].y.into());
    hold(Scores::against(&traced, exact), 0.02)
}

fn wall() -> Outcome {
    let height = 1.0;
    let corners = [(-1e3, 0.0), (1e3, 0.0), (1e3, height), (-1e3, height)];
    let wall = polygon(corners.map(|(z, y)| Vec3::new(0.0, y, z)).into());
    let wall = cpu(&receiver(wall));
    let distances: Vec<f32> = (1..=60).map(|i| 0.05 * i as f32).collect();
    let points = places(distances.iter().map(|&d| (Vec3::X * d, Vec3::Y)));
    let traced = OPENNESS.trace(&wall, &points);
    let exact = |i: usize| openness_beside_wall(height.into(), distances[i].into());
    hold(Scores::against(&traced, exact), 0.02)?;

    let absent = LightPaths {
        self_shadowing: false,
        ..LightPaths::ALL
    };
    let open = OPENNESS.of(absent).trace(&wall, &points);
    let all = open.mean.iter().all(|open| open == Vec3::ONE);
    ensure!(all, "a receiver that is absent hides something");
    Ok(())
}

/// The sky through the rectangle above the floor of the library's pit.
fn pit() -> Outcome {
    let set = [("width", "1.2"), ("length", "2"), ("depth", "0.7")];
    let request = SceneRequest {
        set: set.map(|(n, v)| (n.into(), v.into())).into(),
        ..SceneRequest::new("pit")
    };
    let list: Vec<[f32; 2]> = (0..60)
        .map(|i| sobol_burley::sample_4d(i, 0, 0))
        .map(|[u, v, ..]| [1.18 * (u - 0.5), 1.98 * (v - 0.5)])
        .chain([[0.0; 2]])
        .collect();
    let points = places(list.iter().map(|&[x, z]| (Vec3::new(x, -0.7, z), Vec3::Y)));
    let traced = OPENNESS.trace(&cpu(&open(&request)?), &points);
    let exact = |i: usize| {
        let [x, z] = list[i].map(f64::from);
        if (x, z) == (0.0, 0.0) {
            return openness_in_pit(1.2, 2.0, 0.7);
        }
        let sides = [0.6 - x, 0.6 + x].into_iter();
        let corners = sides.flat_map(|a| [1.0 - z, 1.0 + z].map(|b| (a, b)));
        corners.map(|(a, b)| parallel_rectangle(a, b, 0.7)).sum()
    };
    hold(Scores::against(&traced, exact), 0.02)
}

/// Black surfaces under a sky of radiance 1: E = π times the openness, by another way of sampling.
fn as_irradiance() -> Outcome {
    let mut scene = open(&SceneRequest::new("pit"))?;
    scene.lights.clear();
    scene.materials.fill(glowing(0.0, 0.0));
    let scene = cpu(&under(scene, 1.0));
    let points = places(directions(60).map(|d| (d * 0.1 - Vec3::Y * 0.1, d)));
    let irradiance = IRRADIANCE.trace(&scene, &points);
    let openness = OPENNESS.seeded(2).trace(&scene, &points);
    let terms = [(1.0, &irradiance), (-PI, &openness)];
    hold(Scores::new(&terms, |_| DVec3::ZERO, 0.0), 0.02)
}
