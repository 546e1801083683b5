#![allow(clippy::unwrap_used, reason = "tests")]

use super::*;
use crate::tolerance::Tolerance;
use glam::Vec3;
use interreflect_cpu::path_tracer::LightPaths;
use interreflect_scene::load::{SceneRequest, open};
use interreflect_scene::{Environment, Point, PointLayout, Scene, SurfaceMaterial};
use std::f64::consts::PI;
use std::path::Path;

const SHARED_POINTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/points");

const SAMPLES: Stop = Stop {
    samples: Some(4096),
    relative_error: None,
    seconds: None,
};

fn values(model: OwnModel, quantity: Quantity, scene: &Scene, points: &[Point]) -> ModelValues {
    let cx = CpuCx::new(None, None).unwrap();
    let scene = CpuScene::new(scene).unwrap();
    let points = Points::new(quantity.layout(), points.iter().copied().map(Some));
    evaluate(&cx, model, quantity, &scene, &points, &SAMPLES, 7)
}

/// The box with six constant walls, or `None` with a printed reason.
fn room() -> Option<Scene> {
    let path = Path::new(SHARED_POINTS).join("room.obj");
    if !path.exists() {
        println!("not run: {} is not there", path.display());
        return None;
    }
    let request = SceneRequest {
        reference_point: Some(Vec3::new(0.2, -0.1, 0.3)),
        ..SceneRequest::new(path.to_string_lossy())
    };
    Some(open(&request).unwrap())
}

/// Points of `room.csv`: group, point, exact irradiance, irradiance of the environment at infinity.
fn room_points() -> Vec<(String, Point, f64, f64)> {
    let text = std::fs::read_to_string(Path::new(SHARED_POINTS).join("room.csv")).unwrap();
    let row = |line: &str| {
        let (group, numbers) = line.split_once(',').unwrap();
        let v: Vec<f64> = numbers.split(',').map(|n| n.parse().unwrap()).collect();
        let vector = |i: usize| Vec3::new(v[i] as f32, v[i + 1] as f32, v[i + 2] as f32);
        let point = Point {
            position: vector(0),
            normal: vector(3),
            ..Point::default()
        };
        (group.to_owned(), point, v[6], v[7])
    };
    text.lines().skip(1).map(row).collect()
}

#[test]
fn reproduces_exact_irradiance_in_a_box() {
    let Some(scene) = room() else { return };
    let rows = room_points();
    let points: Vec<Point> = rows.iter().map(|r| r.1).collect();
    for model in [
        OwnModel::VisibleFromReference,
        OwnModel::EnvironmentAtInfinity,
    ] {
        let start = std::time::Instant::now();
        let v = values(model, Quantity::Irradiance, &scene, &points);
        println!("{model:?} {:?}", start.elapsed());
        let mut groups: std::collections::BTreeMap<&str, (f64, f64, f64, f64)> = Default::default();
        for (i, r) in rows.iter().enumerate() {
            let exact = if model == OwnModel::VisibleFromReference {
                r.2
            } else {
                r.3
            };
            let d = f64::from(v.values.get(i).x) - exact;
            let e = f64::from(v.error.get(i).x);
            let g = groups.entry(&r.0).or_default();
            g.0 = g.0.max((d / exact).abs());
            g.1 = g.1.max(d.abs());
            g.2 = g.2.max(e);
            g.3 = g.3.max(if d.abs() > 1e-5 { d.abs() / e } else { 0.0 });
        }
        println!("{groups:#?}");
    }
}

#[test]
fn timing() {
    let cx = CpuCx::new(None, None).unwrap();
    for name in [
        "colored-room",
        "cornell-box",
        "furnace",
        "divided-room",
        "room",
        "sky",
        "studio",
    ] {
        let Ok(scene) = open(&SceneRequest::new(name)) else {
            println!("no {name}");
            continue;
        };
        let cpu = CpuScene::new(&scene).unwrap();
        let objects = cpu.all_objects();
        let mut list = Vec::new();
        for y in 0..96 {
            for x in 0..96 {
                let d = scene.camera.ray(
                    (x as f32 + 0.5) / 96.0 * scene.camera.resolution[0] as f32,
                    (y as f32 + 0.5) / 96.0 * scene.camera.resolution[1] as f32,
                );
                if let Some(h) = cpu.closest(objects, scene.camera.eye.as_dvec3(), d, 0.0) {
                    list.push(Some(Point {
                        position: h.position.as_vec3(),
                        normal: h.shading_normal,
                        view: -d,
                        material: SurfaceMaterial {
                            diffuse: Vec3::splat(0.5),
                            specular: Vec3::splat(0.3),
                            shininess: 50.0,
                        },
                    }));
                }
            }
        }
        list.truncate(4400);
        for q in [Quantity::Irradiance, Quantity::GlossyRadiance] {
            let points = Points::new(q.layout(), list.iter().copied());
            for m in [
                OwnModel::MeanRadiance,
                OwnModel::EnvironmentAtInfinity,
                OwnModel::VisibleFromReference,
            ] {
                let start = std::time::Instant::now();
                let v = evaluate(&cx, m, q, &cpu, &points, &SAMPLES, 1);
                let t = start.elapsed();
                let (s, e) = v
                    .values
                    .iter()
                    .zip(v.error.iter())
                    .fold((0.0, 0.0), |(s, e), (a, b)| {
                        (s + a.length_squared(), e + b.length_squared())
                    });
                println!(
                    "{name} {q:?} {m:?} n={} {t:?} relmse err {:.2e}",
                    list.len(),
                    e / s
                );
            }
        }
    }
}
