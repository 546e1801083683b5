#![allow(clippy::unwrap_used, reason = "tests")]

use super::*;
use crate::oracles::polygon::polygon_irradiance;
use glam::Vec3;
use interreflect_estimators::Tolerance;
use interreflect_scene::conventions::{CUBE_FACES, cube_vector};
use interreflect_scene::load::{SceneRequest, open};
use interreflect_scene::{Environment, LightPaths, Mesh, Point, Role, Scene, SurfaceMaterial};
use std::f64::consts::PI;
use std::path::Path;

/// The points with known answers.
const POINTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/points");

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

/// The box with six constant walls.
fn room() -> Scene {
    let path = Path::new(POINTS).join("room.obj");
    let request = SceneRequest {
        reference_point: Some(Vec3::new(0.2, -0.1, 0.3)),
        ..SceneRequest::new(path.to_string_lossy())
    };
    open(&request).unwrap()
}

/// Points of `room.csv`: group, point, exact irradiance, irradiance of the environment at infinity.
fn room_points() -> Vec<(String, Point, f64, f64)> {
    let text = std::fs::read_to_string(Path::new(POINTS).join("room.csv")).unwrap();
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
    let scene = room();
    let rows = room_points();
    let points: Vec<Point> = rows.iter().map(|r| r.1).collect();
    let check = |model, exact: fn(&(String, Point, f64, f64)) -> f64, tolerance: Tolerance| {
        let computed = values(model, Quantity::Irradiance, &scene, &points).values;
        for (row, value) in rows.iter().zip(computed.iter()) {
            let result = tolerance.check(f64::from(value.x), exact(row));
            assert_eq!(result, Ok(()), "{model:?} {} {:?}", row.0, row.1);
        }
    };
    check(
        OwnModel::VisibleFromReference { bounces: 0 },
        |row| row.2,
        Tolerance {
            absolute: 0.0,
            relative: 2e-3,
            cause: "parts of patches on the wrong wall along the edges, seen from 0.2 m",
        },
    );
    check(
        OwnModel::EnvironmentAtInfinity { bounces: 0 },
        |row| row.3,
        Tolerance {
            absolute: 0.0,
            relative: 4e-4,
            cause: "nodes that the horizon cuts count by their centre",
        },
    );
}

/// The box [−1, 1]³ with six constant walls, made here, against the polygons that the walls are.
#[test]
fn sees_every_wall_of_a_box() {
    let mut scene = open(&SceneRequest::new("furnace")).unwrap();
    let mut mesh = Mesh::default();
    let squares = |face| {
        let corners = [(-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (1.0, -1.0)];
        corners.map(|(s, t)| cube_vector(face, s, t))
    };
    for face in 0..CUBE_FACES {
        let first = mesh.positions.len() as u32;
        mesh.positions.extend(squares(face).map(|c| c.as_vec3()));
        // The fronts face inwards.
        mesh.triangles.push([first, first + 2, first + 1]);
        mesh.triangles.push([first, first + 3, first + 2]);
        mesh.materials.extend([face as u32; 2]);
    }
    scene.objects.truncate(1);
    scene.objects[0].role = Role::Environment;
    scene.objects[0].mesh = mesh;
    let radiances = [1.0, 0.2, 0.5, 0.8, 0.3, 0.6];
    scene.materials = radiances.map(|l| Material::emitter(Vec3::splat(l))).into();
    scene.lights.clear();
    scene.reference_point = Vec3::new(0.2, -0.1, 0.3);
    let points: Vec<Point> = (0..100)
        .map(|i| {
            let [u, v, w] = [0.754_877, 0.569_840, 0.430_160].map(|step| (step * i as f32).fract());
            let normal = Vec3::new(v - 0.5, w - 0.5, u - 0.51).normalize();
            Point {
                position: 1.6 * Vec3::new(u, v, w) - 0.8,
                normal,
                ..Point::default()
            }
        })
        .collect();
    let model = OwnModel::VisibleFromReference { bounces: 0 };
    let computed = values(model, Quantity::Irradiance, &scene, &points).values;
    let tolerance = Tolerance {
        absolute: 0.0,
        relative: 2e-3,
        cause: "parts of patches on the wrong wall along the edges, seen from 0.2 m",
    };
    for (point, value) in points.iter().zip(computed.iter()) {
        let (x, n) = (point.position.as_dvec3(), point.normal.as_dvec3());
        let wall = |face: usize| {
            let seen = squares(face).map(|corner| corner - x);
            f64::from(radiances[face]) * polygon_irradiance(n, &seen)
        };
        let exact = (0..CUBE_FACES).map(wall).sum();
        assert_eq!(tolerance.check(value.x.into(), exact), Ok(()), "{point:?}");
    }
}

/// A point that reflects by its lobe alone, in a constant environment: the reflectance by a
/// midpoint rule over the hemisphere, in double precision.
#[test]
fn constant_environment_gives_pi_and_the_lobes_reflectance() {
    let mut scene = open(&SceneRequest::new("furnace")).unwrap();
    scene.objects.clear();
    scene.lights.clear();
    scene.environment = Some(Environment::constant(Vec3::ONE));
    let models = [
        OwnModel::MeanRadiance { bounces: 0 },
        OwnModel::EnvironmentAtInfinity { bounces: 0 },
        OwnModel::VisibleFromReference { bounces: 0 },
    ];
    for (shininess, tilt) in [(1.0_f32, 0.2_f32), (5.0, 1.2), (50.0, 0.7), (200.0, 0.0)] {
        let point = Point {
            position: Vec3::new(0.3, 0.1, -0.2),
            normal: Vec3::Z,
            view: Vec3::new(tilt.sin(), 0.0, tilt.cos()),
            material: SurfaceMaterial {
                diffuse: Vec3::ZERO,
                specular: Vec3::ONE,
                shininess,
            },
            ..Point::default()
        };
        let exact = reflectance(&point);
        for model in models {
            let value = |quantity| {
                let v = values(model, quantity, &scene, &[point]).values.get(0).x;
                f64::from(v)
            };
            let e = value(Quantity::Irradiance) / PI - 1.0;
            assert!(e.abs() < 5e-4, "{model:?}: E = π(1 + {e})");
            let l = value(Quantity::GlossyRadiance) / exact - 1.0;
            // The lobe over a node: squared width 4/1024 or 1/(4n), by its second derivative.
            assert!(
                l.abs() < 2e-3,
                "{model:?}, n = {shininess}: {exact}·(1 + {l})"
            );
        }
    }
}

fn reflectance(point: &Point) -> f64 {
    const N: usize = 800;
    let shininess = f64::from(point.material.shininess);
    let view = point.view.as_dvec3();
    let sum: f64 = (0..N * N)
        .map(|k| {
            let cos2 = ((k / N) as f64 + 0.5) / N as f64;
            let phi = 2.0 * PI * ((k % N) as f64 + 0.5) / N as f64;
            let sin = (1.0 - cos2).sqrt();
            let i = glam::DVec3::new(sin * phi.cos(), sin * phi.sin(), cos2.sqrt());
            (i + view).normalize().z.powf(shininess)
        })
        .sum();
    let normalisation = interreflect_scene::material::blinn_phong_normalisation(shininess);
    normalisation * sum * PI / (N * N) as f64
}

/// The box of `drm.csv`: what a spot light meets first, against the exact irradiance.
#[test]
fn reproduces_exact_irradiance_from_what_a_light_meets() {
    let path = Path::new(POINTS).join("drm.toml");
    let scene = open(&SceneRequest::new(path.to_string_lossy())).unwrap();
    let text = std::fs::read_to_string(Path::new(POINTS).join("drm.csv")).unwrap();
    let rows: Vec<(Point, f64)> = text
        .lines()
        .skip(1)
        .map(|line| {
            let (_, numbers) = line.split_once(',').unwrap();
            let v: Vec<f64> = numbers.split(',').map(|n| n.parse().unwrap()).collect();
            let vector = |i: usize| Vec3::new(v[i] as f32, v[i + 1] as f32, v[i + 2] as f32);
            let point = Point {
                position: vector(0),
                normal: vector(3),
                ..Point::default()
            };
            (point, v[6])
        })
        .collect();
    let points: Vec<Point> = rows.iter().map(|r| r.0).collect();
    let model = OwnModel::FirstHitsOfLights { directional: false };
    let computed = values(model, Quantity::Irradiance, &scene, &points);
    let tolerance = Tolerance {
        absolute: 0.0,
        relative: 2e-3,
        cause: "patches that the box's edges cut, of one radiance each",
    };
    for ((point, exact), value) in rows.iter().zip(computed.values.iter()) {
        let result = tolerance.check(f64::from(value.x), *exact);
        assert_eq!(result, Ok(()), "{point:?}");
    }
}

#[test]
fn glossy_radiance_in_a_box_agrees_with_the_path_tracer() {
    let scene = room();
    let shiny = |(_, point, ..): &(String, Point, f64, f64)| Point {
        view: (point.normal + 0.5 * point.normal.any_orthonormal_vector()).normalize(),
        material: SurfaceMaterial {
            diffuse: Vec3::splat(0.4),
            specular: Vec3::splat(0.5),
            shininess: 30.0,
        },
        ..*point
    };
    let points: Vec<Point> = room_points().iter().step_by(40).map(shiny).collect();
    let own = values(
        OwnModel::VisibleFromReference { bounces: 0 },
        Quantity::GlossyRadiance,
        &scene,
        &points,
    );
    let paths = LightPaths {
        bounces: 1,
        self_shadowing: false,
        ..LightPaths::default()
    };
    let traced = values(
        OwnModel::LightTransport(paths),
        Quantity::GlossyRadiance,
        &scene,
        &points,
    );
    for (i, point) in points.iter().enumerate() {
        let (a, b) = (own.values.get(i).x, traced.values.get(i).x);
        // Four standard errors of the path tracer, and what edges cost the integral.
        let bound = 4.0 * traced.error.get(i).x + 5e-3 * a;
        assert!((a - b).abs() < bound, "{point:?}: {a} {b}, bound {bound}");
    }
}
