//! The path tracer against exact light.
#![allow(clippy::unwrap_used, reason = "tests")]

mod support;

use glam::Vec3;
use interreflect_cpu::path_tracer::{LightPaths, PathQuantity, REPLICATES, Stop, Traced, trace};
use interreflect_cpu::scene::CpuScene;
use interreflect_scene::{
    Environment, LatLongImage, Light, Material, Point, PointLayout, Points, Role, SurfaceMaterial,
};
use std::{f32::consts::PI, sync::Mutex};
use support::{cpu, glowing, lit, object, point, points, quad, room, sphere, under, walls};

const FULL: LightPaths = LightPaths {
    bounces: 0,
    indirect_visibility: true,
    self_shadowing: true,
    environment_at_infinity: false,
};

fn samples(count: u32) -> Stop {
    Stop {
        samples: Some(count),
        ..Stop::default()
    }
}

fn irradiance(scene: &CpuScene, points: &Points, paths: LightPaths, count: u32) -> Traced {
    trace(
        scene,
        points,
        PathQuantity::Irradiance,
        &paths,
        &samples(count),
        1,
        &|_| (),
    )
}

/// Largest |z| over the points, in the red channel.
fn largest_z(traced: &Traced, exact: impl Fn(usize) -> f64) -> f64 {
    let values = traced.mean.iter().zip(traced.standard_error.iter());
    values
        .enumerate()
        .map(|(i, (mean, error))| ((f64::from(mean.x) - exact(i)) / f64::from(error.x)).abs())
        .fold(0.0, f64::max)
}

/// Points everywhere in [−1, 1]³, those near the walls included, with all kinds of normals.
fn inside(count: usize) -> Points {
    let spread = |i: usize, step: f64| (i as f64 * step).fract() as f32 * 1.998 - 0.999;
    points(support::directions(count).enumerate().map(|(i, normal)| {
        let at = Vec3::new(
            spread(i, 0.754_877_67),
            spread(i, 0.569_840_29),
            spread(i, 0.318),
        );
        point(at, normal)
    }))
}

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
    // over the face stand for the area integral: replicate means of it give its own error.
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
                let traced = irradiance(&scene, &face, FULL, 256);
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
    let traced = irradiance(&scene, &list, FULL, 1024);
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

/// A receiver sphere of radius ½ in the middle of a glowing room.
fn room_with_receiver() -> CpuScene {
    let mut scene = walls([glowing(0.0, 1.0); 6]);
    let mut ball = sphere(0.5, 8, false, false);
    ball.materials.fill(6);
    scene.materials.push(Material::diffuse(Vec3::ZERO));
    scene.objects.push(object(Role::Receiver, ball));
    cpu(&scene)
}

#[test]
fn receivers_are_absent_without_self_shadowing() {
    let scene = room_with_receiver();
    // On the axis, facing the ball at distance d: it hides (r/d)² of the light.
    let facing = points([point(Vec3::X * 0.9, Vec3::NEG_X)]);
    let with = irradiance(&scene, &facing, FULL, 4096).mean.get(0).x / PI;
    // The polyhedron of 768 triangles is up to 1 % smaller than the sphere.
    assert!(
        (with - (1.0 - (0.5_f32 / 0.9).powi(2))).abs() < 0.01,
        "{with}"
    );
    let paths = LightPaths {
        self_shadowing: false,
        ..FULL
    };
    let without = irradiance(&scene, &facing, paths, 4096);
    assert!(largest_z(&without, |_| std::f64::consts::PI) < 4.0);
}

#[test]
fn all_surfaces_along_a_ray_count_without_indirect_visibility() {
    let scene = room_with_receiver();
    let facing = points([point(Vec3::X * 0.9, Vec3::NEG_X)]);
    let paths = LightPaths {
        indirect_visibility: false,
        ..FULL
    };
    // The black ball hides nothing of the walls behind it.
    let traced = irradiance(&scene, &facing, paths, 2048);
    assert!(largest_z(&traced, |_| std::f64::consts::PI) < 4.0);

    // Two rooms, one in the other, both glowing inwards, and the sky: three radiances add up.
    let mut twice = walls([glowing(0.0, 1.0); 6]);
    let outer = room(Vec3::splat(-2.0), Vec3::splat(2.0));
    twice.objects.push(object(Role::Environment, outer));
    let twice = cpu(&under(twice, 0.5));
    let traced = irradiance(&twice, &inside(10), paths, 4096);
    assert!(largest_z(&traced, |_| 2.5 * std::f64::consts::PI) < 4.0);
    let traced = irradiance(&twice, &inside(10), FULL, 4096);
    assert!(largest_z(&traced, |_| std::f64::consts::PI) < 4.0);
}

#[test]
fn an_environment_at_infinity_depends_on_the_normal_alone() {
    let mut scene = walls([1.0, 0.2, 0.5, 0.8, 0.3, 0.6].map(|l| glowing(0.0, l)));
    scene.reference_point = Vec3::new(0.2, -0.1, 0.3);
    let (here, there) = (scene.reference_point, Vec3::new(0.9, 0.9, -0.9));
    let both = points([point(here, Vec3::NEG_X), point(there, Vec3::NEG_X)]);
    let at_infinity = LightPaths {
        environment_at_infinity: true,
        ..FULL
    };
    let scene = cpu(&scene);
    let far = irradiance(&scene, &both, at_infinity, 4096);
    let local = irradiance(&scene, &both, FULL, 4096);
    let exact = f64::from(local.mean.get(0).x);
    // The local estimate has an error of its own: √2 times 4.
    assert!(largest_z(&far, |_| exact) < 5.7);
    let other = f64::from(local.mean.get(1).x);
    assert!((other / exact - 1.0).abs() > 0.1, "{other} and {exact}");
}

#[test]
fn openness_is_one_outside_zero_in_a_closed_room_and_half_beside_a_wall() {
    let openness = |scene: &CpuScene, points: &Points, paths: LightPaths| {
        let quantity = PathQuantity::AmbientOcclusion;
        trace(scene, points, quantity, &paths, &samples(4096), 5, &|_| ())
    };
    let closed = cpu(&walls([glowing(0.0, 1.0); 6]));
    assert!(
        openness(&closed, &inside(9), FULL)
            .mean
            .iter()
            .all(|a| a == Vec3::ZERO)
    );
    let unseen = LightPaths {
        indirect_visibility: false,
        ..FULL
    };
    assert!(
        openness(&closed, &inside(9), unseen)
            .mean
            .iter()
            .all(|a| a == Vec3::ONE)
    );

    // Beside a wall of height h at distance d: 1 − ½(1 − d/√(d² + h²)).
    let (far, h, d) = (1000.0, 1.0, 0.5_f64);
    let wall = quad(
        [(-far, 0.0), (far, 0.0), (far, h), (-far, h)].map(|(z, y)| Vec3::new(0.0, y, z)),
        0,
    );
    let scene = support::scene(vec![object(Role::Receiver, wall)], vec![glowing(0.5, 0.0)]);
    let ground = points([point(Vec3::X * d as f32, Vec3::Y)]);
    let traced = openness(&cpu(&scene), &ground, FULL);
    let exact = 1.0 - 0.5 * (1.0 - d / (d * d + f64::from(h * h)).sqrt());
    assert!(largest_z(&traced, |_| exact) < 4.0);
    let absent = LightPaths {
        self_shadowing: false,
        ..FULL
    };
    assert_eq!(
        openness(&cpu(&scene), &ground, absent).mean.get(0),
        Vec3::ONE
    );
}

/// A room with everything in it: emitters, lights, a mirror, gloss, a receiver, an opening.
fn busy_scene() -> interreflect_scene::Scene {
    let mut scene = walls([0.0, 0.3, 0.0, 0.0, 2.0, 0.0].map(|l| glowing(0.5, l)));
    scene.materials[2] = Material {
        specular: Vec3::splat(0.8),
        mirror: true,
        ..scene.materials[2]
    };
    scene.materials[3].specular = Vec3::splat(0.4);
    scene.objects[0].mesh.triangles.truncate(11);
    scene.objects[0].mesh.materials.truncate(11);
    scene
        .objects
        .push(object(Role::Receiver, sphere(0.4, 6, false, true)));
    let scene = under(scene, 0.7);
    lit(
        scene,
        Light::Point {
            position: Vec3::new(0.2, 0.7, 0.1),
            intensity: Vec3::ONE,
        },
    )
}

#[test]
fn seeds_agree_within_their_errors_and_techniques_are_unbiased() {
    let scene = cpu(&busy_scene());
    let list = points(support::directions(40).map(|d| point(d * 0.41, d)));
    for indirect_visibility in [true, false] {
        let paths = LightPaths {
            indirect_visibility,
            ..FULL
        };
        let by_seed = |seed| {
            trace(
                &scene,
                &list,
                PathQuantity::Irradiance,
                &paths,
                &samples(2048),
                seed,
                &|_| (),
            )
        };
        let (a, b) = (by_seed(1), by_seed(2));
        assert_ne!(a, b);
        for i in 0..list.len() {
            let difference = a.mean.get(i) - b.mean.get(i);
            let error = a.standard_error.get(i).hypot(b.standard_error.get(i));
            let z = difference.abs().max_element() / error.max_element();
            assert!(
                z < 4.5,
                "point {i}: {} and {}",
                a.mean.get(i),
                b.mean.get(i)
            );
        }
    }
}

trait Hypot {
    fn hypot(self, other: Self) -> Self;
}

impl Hypot for Vec3 {
    fn hypot(self, other: Self) -> Self {
        (self * self + other * other).map(f32::sqrt)
    }
}

#[test]
fn the_number_of_threads_does_not_change_a_bit() {
    let scene = busy_scene();
    let list = points(support::directions(30).map(|d| point(d * 0.41, d)));
    for indirect_visibility in [true, false] {
        let paths = LightPaths {
            indirect_visibility,
            ..FULL
        };
        let stop = Stop {
            samples: Some(500),
            relative_error: Some(1e-9),
            seconds: None,
        };
        let run = |threads| {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            pool.install(|| {
                trace(
                    &cpu(&scene),
                    &list,
                    PathQuantity::Irradiance,
                    &paths,
                    &stop,
                    9,
                    &|_| (),
                )
            })
        };
        let one = run(1);
        assert_eq!(one, run(2));
        assert_eq!(one, run(3));
        assert_eq!(one.samples, 512);
        // Rounds do not change what is sampled.
        let at_once = trace(
            &cpu(&scene),
            &list,
            PathQuantity::Irradiance,
            &paths,
            &samples(500),
            9,
            &|_| (),
        );
        for (a, b) in one.mean.iter().zip(at_once.mean.iter()) {
            assert!((a - b).abs().max_element() <= 1e-6 * a.max_element());
        }
    }
}

#[test]
fn a_requested_error_is_reached_and_progress_ends_at_one() {
    let scene = cpu(&busy_scene());
    let list = points(support::directions(10).map(|d| point(d * 0.41, d)));
    let seen = Mutex::new(Vec::new());
    let run = |stop: &Stop| {
        let progress = |f| seen.lock().unwrap().push(f);
        trace(
            &scene,
            &list,
            PathQuantity::Irradiance,
            &FULL,
            stop,
            1,
            &progress,
        )
    };
    let stop = Stop {
        relative_error: Some(0.02),
        ..Stop::default()
    };
    let traced = run(&stop);
    let norm = |e: &interreflect_scene::Estimate| e.iter().map(|v| v.length_squared()).sum::<f32>();
    assert!(norm(&traced.standard_error) <= 0.02_f32.powi(2) * norm(&traced.mean) * 1.001);
    assert!(traced.samples % REPLICATES == 0 && traced.samples < 1 << 20);
    assert!(seen.lock().unwrap().iter().all(|f| (0.0..=1.0).contains(f)));
    seen.lock().unwrap().clear();
    run(&samples(320));
    let last = seen.lock().unwrap().iter().copied().fold(0.0, f32::max);
    assert_eq!(last, 1.0);
}

#[test]
fn points_that_are_not_numbers_stay_alone() {
    let scene = cpu(&walls([glowing(0.0, 1.0); 6]));
    let nan = Point {
        position: Vec3::NAN,
        normal: Vec3::X,
        ..Point::default()
    };
    let list = points([
        point(Vec3::ZERO, Vec3::X),
        Some(nan),
        None,
        Some(Point::default()),
    ]);
    for quantity in [PathQuantity::Irradiance, PathQuantity::AmbientOcclusion] {
        let stop = Stop {
            samples: Some(64),
            relative_error: Some(0.5),
            seconds: Some(5.0),
        };
        let traced = trace(&scene, &list, quantity, &FULL, &stop, 1, &|_| ());
        assert!(traced.mean.get(0).is_finite());
        assert!(traced.mean.get(1).is_nan() && traced.standard_error.get(1).is_nan());
        assert_eq!(traced.mean.get(2), Vec3::ZERO);
        assert!(traced.mean.get(3).is_nan(), "a normal without length");
    }
    let nothing = irradiance(&scene, &points([]), FULL, 10);
    assert!(nothing.mean.is_empty());
}
