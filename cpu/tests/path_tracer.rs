//! The path tracer against exact light: the full transport.
#![allow(clippy::unwrap_used, reason = "tests")]

mod support;

use glam::Vec3;
use interreflect_cpu::path_tracer::{LightPaths, PathQuantity, trace};
use interreflect_scene::{
    Environment, LatLongImage, Light, Material, Point, PointLayout, Points, Role, SurfaceMaterial,
};
use std::f32::consts::PI;
use support::estimates::{FULL, inside, irradiance, irradiance_of_seed, largest_z, samples};
use support::{cpu, glowing, lit, object, point, points, quad, sphere, under, walls};

#[test]
fn irradiance_in_a_room_of_radiance_one_is_pi() {
    let scene = cpu(&walls([glowing(0.0, 1.0); 6]));
    let traced = irradiance(&scene, &inside(100), FULL, 1024);
    for (mean, error) in traced.mean.iter().zip(traced.standard_error.iter()) {
        assert!((mean.x / PI - 1.0).abs() < 1e-3, "{mean} ± {error}");
    }
    assert!(largest_z(&traced, |_| std::f64::consts::PI) < 4.0);
}

#[test]
fn form_factors_of_the_cubes_faces_are_exact() {
    // The mean over a face of E/π is the form factor to the one face that emits. Sobol points
    // over the face stand for the area integral: replicates of points and paths give its error.
    let opposite = 0.199_824_895_698_387_46;
    let adjacent = 0.200_043_776_075_403_16;
    for (emitting, exact) in [(1, opposite), (2, adjacent), (5, adjacent)] {
        let mut materials = [glowing(0.0, 0.0); 6];
        materials[emitting] = glowing(0.0, 1.0);
        let scene = cpu(&walls(materials));
        let means: Vec<f64> = (0..32)
            .map(|replicate| {
                let over_face = (0..256).map(|i| {
                    let [u, v, ..] = sobol_burley::sample_4d(i, 0, replicate);
                    let at = Vec3::new(1.0, 2.0 * u - 1.0, 2.0 * v - 1.0);
                    point(at, Vec3::NEG_X)
                });
                let face = points(over_face);
                let traced = irradiance_of_seed(&scene, &face, FULL, 256, replicate.into());
                traced.mean.iter().map(|e| f64::from(e.x)).sum::<f64>() / 256.0
            })
            .map(|e| e / std::f64::consts::PI)
            .collect();
        let mean = means.iter().sum::<f64>() / 32.0;
        let variance = means.iter().map(|m| (m - mean).powi(2)).sum::<f64>() / 31.0 / 32.0;
        let z = (mean - exact) / variance.sqrt();
        assert!(
            z.abs() < 4.0,
            "wall {emitting}: {mean} for {exact}, z = {z}"
        );
        assert!((mean / exact - 1.0).abs() < 1e-3);
    }
}

#[test]
fn a_face_seen_from_the_opposite_one_is_met_within_the_stated_error() {
    let mut materials = [glowing(0.0, 0.0); 6];
    materials[1] = glowing(0.0, 1.0);
    let places: Vec<[f32; 2]> = (0..256)
        .map(|i| {
            let [u, v, ..] = sobol_burley::sample_4d(i, 0, 0);
            [2.0 * u - 1.0, 2.0 * v - 1.0]
        })
        .collect();
    let at = |&[y, z]: &[f32; 2]| point(Vec3::new(1.0, y, z), Vec3::NEG_X);
    let list = points(places.iter().map(at));
    let traced = irradiance(&cpu(&walls(materials)), &list, FULL, 256);
    // π times the form factor of a rectangle of edges a and b, in distances, above one corner.
    let corner = |a: f64, b: f64| {
        let (c, d) = ((1.0 + a * a).sqrt(), (1.0 + b * b).sqrt());
        0.5 * (a / c * (b / c).atan() + b / d * (a / d).atan())
    };
    let exact = |i: usize| {
        let edges = |x: f32| [0.5 - 0.5 * f64::from(x), 0.5 + 0.5 * f64::from(x)];
        let [y, z] = places[i];
        let pairs = edges(y).into_iter().flat_map(|a| edges(z).map(|b| (a, b)));
        pairs.map(|(a, b)| corner(a, b)).sum::<f64>()
    };
    // 256 normal variables stay below 4.3 with probability 0.995 (Šidák).
    let z = largest_z(&traced, exact);
    assert!(z < 4.3, "largest |z| = {z}");
    let beyond_1 = traced.mean.iter().zip(traced.standard_error.iter());
    let beyond_1 = beyond_1
        .enumerate()
        .filter(|(i, (mean, error))| (f64::from(mean.x) - exact(*i)).abs() > f64::from(error.x))
        .count();
    // A third of normal variables lie beyond; the error is scaled at 4σ and so larger at 1σ.
    assert!(beyond_1 > 20, "only {beyond_1} of 256 are beyond one error");
}

#[test]
fn the_rooms_exact_irradiances_are_met_by_their_own_standard_error() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/points/room.csv");
    let Ok(text) = std::fs::read_to_string(path) else {
        println!("skipped: {path} is not there");
        return;
    };
    let rows: Vec<Vec<f64>> = text
        .lines()
        .skip(1)
        .map(|line| {
            line.split(',')
                .skip(1)
                .map(|v| v.parse().unwrap())
                .collect()
        })
        .collect();
    let scene = cpu(&walls(
        [1.0, 0.2, 0.5, 0.8, 0.3, 0.6].map(|l| glowing(0.0, l)),
    ));
    let vector = |row: &[f64]| Vec3::new(row[0] as f32, row[1] as f32, row[2] as f32);
    let list = points(rows.iter().map(|row| point(vector(row), vector(&row[3..]))));
    let traced = irradiance(&scene, &list, FULL, 4096);
    let z = largest_z(&traced, |i| rows[i][6]);
    // 884 normal variables stay below 4.7 with probability 0.998 (Šidák).
    assert!(z < 4.7, "largest |z| = {z}");
    let beyond_3 = traced
        .mean
        .iter()
        .zip(traced.standard_error.iter())
        .zip(&rows);
    let beyond_3 =
        beyond_3.filter(|((m, e), row)| (f64::from(m.x) - row[6]).abs() > 3.0 * f64::from(e.x));
    // Expected 884 × 0.0027 ≈ 2.4 (fewer: the error is scaled at 4σ); 10 would have p < 1e-4.
    assert!(beyond_3.count() < 10);
    let error = traced
        .standard_error
        .iter()
        .map(|e| e.x)
        .fold(0.0, f32::max);
    assert!(
        error < 0.02,
        "standard errors are up to {error}: the test would see nothing"
    );
}

#[test]
fn a_furnace_gains_what_its_bounces_give() {
    let (albedo, emitted) = (0.6_f64, 0.5_f64);
    let scene = cpu(&walls([glowing(albedo as f32, emitted as f32); 6]));
    let points = inside(24);
    for bounces in [1, 2, 3, 0] {
        let gain = match bounces {
            0 => 1.0 / (1.0 - albedo),
            k => (1.0 - albedo.powi(k + 1)) / (1.0 - albedo),
        };
        let exact = std::f64::consts::PI * emitted * gain;
        let paths = LightPaths {
            bounces: bounces as u32,
            ..FULL
        };
        let traced = irradiance(&scene, &points, paths, 2048);
        let z = largest_z(&traced, |_| exact);
        assert!(z < 4.0, "{bounces} bounces: |z| = {z}");
        for mean in traced.mean.iter() {
            assert!(
                (f64::from(mean.x) / exact - 1.0).abs() < 0.01,
                "{bounces}: {mean} for {exact}"
            );
        }
    }
}

#[test]
fn an_integrating_sphere_spreads_a_point_lights_flux_evenly() {
    let (albedo, radius) = (0.5, 1.0);
    let shell = object(Role::Environment, sphere(radius, 24, true, true));
    let scene = lit(
        support::scene(vec![shell], vec![Material::diffuse(Vec3::splat(albedo))]),
        Light::Point {
            position: Vec3::new(0.3, 0.2, 0.0),
            intensity: Vec3::ONE,
        },
    );
    let list = points(support::directions(20).map(|d| point(d * 0.99, -d)));
    let flux = 4.0 * PI;
    let first = albedo * flux / (4.0 * PI * radius * radius);
    for (bounces, exact) in [(1, first), (0, first / (1.0 - albedo))] {
        let paths = LightPaths { bounces, ..FULL };
        let traced = irradiance(&cpu(&scene), &list, paths, 2048);
        for (mean, error) in traced.mean.iter().zip(traced.standard_error.iter()) {
            // 6 × 24² quads: the polyhedron's area is 0.2 % below the sphere's, its corners 0.2 %
            // nearer; both enter once a bounce.
            let tolerance = 0.01 * exact + 4.0 * error.x;
            assert!(
                (mean.x - exact).abs() < tolerance,
                "{bounces}: {mean} ± {error} for {exact}"
            );
        }
    }
}

#[test]
fn a_constant_environment_gives_pi_and_a_bright_spot_its_share() {
    let open = support::scene(vec![], vec![]);
    let points = inside(20);
    let traced = irradiance(&cpu(&under(open.clone(), 1.0)), &points, FULL, 1024);
    assert!(largest_z(&traced, |_| std::f64::consts::PI) < 4.0);

    // All light in 1 texel of 64 × 32, well above the horizon: E = ∫ L cos θ dω, by midpoint rule.
    let (width, height, spot) = (64, 32, 6 * 64 + 20);
    let mut texels = vec![Vec3::ZERO; (width * height) as usize];
    texels[spot] = Vec3::splat(1000.0);
    let mut scene = open;
    scene.environment = Some(Environment {
        image: LatLongImage {
            width,
            height,
            texels,
        },
        scale: 0.5,
        rotate_deg: 70.0,
    });
    // It is not seen from inside a room, and must not take anything from the room's own light.
    let mut inside_room = walls([glowing(0.0, 1.0); 6]);
    inside_room.environment = scene.environment.clone();
    let traced = irradiance(&cpu(&inside_room), &points, FULL, 1024);
    assert!(largest_z(&traced, |_| std::f64::consts::PI) < 4.0);

    let environment = scene.environment.clone().unwrap();
    let fine = 1000;
    let mut exact = 0.0;
    for i in 0..fine {
        let theta = (i as f64 + 0.5) * std::f64::consts::FRAC_PI_2 / f64::from(fine);
        for j in 0..2 * fine {
            let phi = (f64::from(j) + 0.5) * std::f64::consts::PI / f64::from(fine);
            let d = [
                theta.sin() * phi.sin(),
                theta.cos(),
                -theta.sin() * phi.cos(),
            ];
            let radiance = environment.radiance(Vec3::from(d.map(|c| c as f32)));
            exact += f64::from(radiance.x) * theta.cos() * theta.sin();
        }
    }
    exact *= std::f64::consts::PI * std::f64::consts::FRAC_PI_2 / f64::from(fine * fine);
    let up = support::points([point(Vec3::ZERO, Vec3::Y)]);
    let traced = irradiance(&cpu(&scene), &up, FULL, 4096);
    let (mean, error) = (
        f64::from(traced.mean.get(0).x),
        f64::from(traced.standard_error.get(0).x),
    );
    assert!(error < 0.01 * mean, "importance sampling: {mean} ± {error}");
    // The midpoint rule over 2 000 000 directions is good to 1e-4.
    assert!(
        (mean - exact).abs() < 4.0 * error + 1e-3 * exact,
        "{mean} ± {error} for {exact}"
    );
}

#[test]
fn mirrors_show_what_they_face() {
    // A mirror floor under an open sky of radiance 1: from above it looks like the sky.
    let corners = [(-9.0, -9.0), (-9.0, 9.0), (9.0, 9.0), (9.0, -9.0)];
    let floor = quad(corners.map(|(x, z)| Vec3::new(x, 0.0, z)), 0);
    let mirror = Material {
        specular: Vec3::splat(0.5),
        mirror: true,
        ..glowing(0.9, 0.0)
    };
    let scene = support::scene(vec![object(Role::Environment, floor)], vec![mirror]);
    let down = points([point(Vec3::Y * 0.01, Vec3::NEG_Y)]);
    let traced = irradiance(&cpu(&under(scene, 1.0)), &down, FULL, 1024);
    // The floor fills all but (0.01/9)² of the view.
    assert!(
        (traced.mean.get(0).x / (0.5 * PI) - 1.0).abs() < 1e-3,
        "{:?}",
        traced.mean.get(0)
    );
}

fn glossy_points(view: Vec3) -> Points {
    let of = |shininess: f32| Point {
        normal: Vec3::Z,
        view,
        material: SurfaceMaterial {
            diffuse: Vec3::splat(0.3),
            specular: Vec3::splat(0.6),
            shininess,
        },
        ..Point::default()
    };
    Points::new(PointLayout::Material, [0.0, 5.0, 60.0].map(|n| Some(of(n))))
}

#[test]
fn glossy_radiance_under_a_constant_sky_is_the_lobes_albedo() {
    let scene = cpu(&under(support::scene(vec![], vec![]), 1.0));
    let glossy = |paths: LightPaths| {
        let points = glossy_points(Vec3::Z);
        trace(
            &scene,
            &points,
            PathQuantity::GlossyRadiance,
            &paths,
            &samples(4096),
            3,
            &|_| (),
        )
    };
    // Head-on the normalised lobe reflects all: k_d + k_s.
    assert!(largest_z(&glossy(FULL), |_| 0.9) < 4.0);
    assert!(
        glossy(FULL).standard_error.iter().all(|e| e.x < 5e-3),
        "{:?}",
        glossy(FULL).standard_error.iter().collect::<Vec<_>>()
    );
}
