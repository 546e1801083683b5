//! One bounce of a spot light against its exact integral.
#![allow(clippy::unwrap_used, reason = "tests")]

mod support;

use glam::Vec3;
use interreflect_cpu::path_tracer::LightPaths;
use interreflect_scene::{Light, Material, SpotShape};
use support::estimates::{FULL, irradiance, largest_z};
use support::{cpu, lit, point, points, walls};

#[test]
fn one_bounce_of_a_spot_light_is_met_by_its_own_standard_error() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/points/drm.csv");
    let Ok(text) = std::fs::read_to_string(path) else {
        println!("skipped: {path} is not there");
        return;
    };
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let column = |name: &str| names.iter().position(|n| *n == name).unwrap();
    let columns = ["x", "y", "z", "nx", "ny", "nz", "E_exact"].map(column);
    let rows: Vec<[f64; 7]> = lines
        .map(|line| {
            let cells: Vec<&str> = line.split(',').collect();
            columns.map(|c| cells[c].parse().unwrap())
        })
        .collect();
    let albedo = [0.7, 0.1, 0.6, 0.6, 0.2, 0.7];
    let spot = Light::Spot {
        position: Vec3::Y * 0.9,
        direction: Vec3::NEG_Y,
        up: Vec3::Z,
        shape: SpotShape::Square,
        angle_deg: 90.0,
        intensity: Vec3::ONE,
    };
    let room = walls(albedo.map(|a| Material::diffuse(Vec3::splat(a))));
    let scene = cpu(&lit(room, spot));
    let vector = |row: &[f64]| Vec3::new(row[0] as f32, row[1] as f32, row[2] as f32);
    let list = points(rows.iter().map(|row| point(vector(row), vector(&row[3..]))));
    let once = LightPaths { bounces: 1, ..FULL };
    let traced = irradiance(&scene, &list, once, 4096);
    // The table is exact to 5e-5 relative, far below these standard errors.
    let z = largest_z(&traced, |i| rows[i][6]);
    assert!(z < 4.0, "largest |z| = {z} of {} points", rows.len());
}
