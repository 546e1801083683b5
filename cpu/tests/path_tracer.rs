//! The path tracer where its answer has no noise.

mod support;

use glam::Vec3;
use interreflect_cpu::path_tracer::{PathQuantity, trace};
use interreflect_cpu::scene::CpuScene;
use interreflect_scene::{LightPaths, Material, Mesh, Points, Role};
use std::f32::consts::PI;
use support::estimates::{inside, irradiance, samples};
use support::{cpu, glowing, object, point, points, quad, under, walls};

fn openness(scene: &CpuScene, points: &Points, paths: LightPaths, count: u32) -> Vec<Vec3> {
    let (quantity, stop) = (PathQuantity::AmbientOcclusion, samples(count));
    let traced = trace(scene, points, quantity, &paths, &stop, 5, &|_| ());
    traced.mean.iter().collect()
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
    let traced = irradiance(&cpu(&under(scene, 1.0)), &down, LightPaths::ALL, 1024);
    // The floor fills all but (0.01/9)² of the view.
    assert!(
        (traced.mean.get(0).x / (0.5 * PI) - 1.0).abs() < 1e-3,
        "{:?}",
        traced.mean.get(0)
    );
}

#[test]
fn openness_is_zero_in_a_closed_room_and_one_where_nothing_occludes() {
    let closed = cpu(&walls([glowing(0.0, 1.0); 6]));
    let unseen = LightPaths {
        indirect_visibility: false,
        ..LightPaths::ALL
    };
    for (paths, exact) in [(LightPaths::ALL, Vec3::ZERO), (unseen, Vec3::ONE)] {
        let found = openness(&closed, &inside(9), paths, 4096);
        assert!(found.iter().all(|&open| open == exact), "{found:?}");
    }
}

#[test]
fn points_on_a_surface_do_not_see_it_though_they_are_rounded() {
    let corners = [(5.1, 0.3, -2.2), (4.3, 1.1, -1.7), (5.0, -0.6, -0.9)].map(Vec3::from);
    let [a, b, c] = corners;
    let plate = Mesh {
        positions: corners.to_vec(),
        normals: Vec::new(),
        triangles: vec![[0, 1, 2]],
        materials: vec![0],
    };
    // Rounded to f32, half of these points lie behind the plane.
    let weights = support::directions(500).map(|d| d * d);
    let list = points(weights.map(|w| {
        let at = a * w.x + b * w.y + c * w.z;
        point(at, (b - a).cross(c - a))
    }));
    let plate = object(Role::Receiver, plate);
    let scene = support::scene(vec![plate], vec![glowing(0.5, 0.0)]);
    let found = openness(&cpu(&scene), &list, LightPaths::ALL, 256);
    assert!(found.iter().all(|&open| open == Vec3::ONE));
}

#[test]
fn emission_leaves_the_front_only() {
    let corners = [(-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (1.0, -1.0)];
    let plate = quad(corners.map(|(x, z)| Vec3::new(x, 0.0, z)), 0);
    let plate = object(Role::Environment, plate);
    let scene = cpu(&support::scene(vec![plate], vec![glowing(0.0, 1.0)]));
    let both_sides = points([point(Vec3::Y, Vec3::NEG_Y), point(Vec3::NEG_Y, Vec3::Y)]);
    let glow = irradiance(&scene, &both_sides, LightPaths::ALL, 1024).mean;
    assert!(
        glow.get(0).x > 1.0,
        "the front looks to +y: {}",
        glow.get(0)
    );
    assert_eq!(glow.get(1), Vec3::ZERO);
}
