//! Ray queries: nothing leaks out of a closed box, answers are exact and do not depend on the tree.
#![allow(clippy::unwrap_used, reason = "tests")]

mod support;

use glam::{DVec3, Vec3};
use interreflect_cpu::bvh::Bvh;
use interreflect_scene::Mesh;
use rayon::prelude::*;

fn soup(mesh: &Mesh) -> Vec<[Vec3; 3]> {
    (0..mesh.triangles.len()).map(|t| mesh.corners(t)).collect()
}

/// The room [−1, 1]³ with walls of 2·n² triangles.
fn fine_room(n: u32) -> Vec<[Vec3; 3]> {
    let walls = soup(&support::room(Vec3::NEG_ONE, Vec3::ONE));
    let mut fine = Vec::new();
    for [a, b, c] in walls {
        let at =
            |i: u32, j: u32| a + (b - a) * (i as f32 / n as f32) + (c - b) * (j as f32 / n as f32);
        for i in 0..n {
            for j in 0..=i {
                fine.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
                if j < i {
                    fine.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
                }
            }
        }
    }
    fine
}

fn random(seed: u64) -> impl Iterator<Item = f64> {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    std::iter::repeat_with(move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64
    })
}

/// Origin inside the room and a target: in turn anywhere on a wall, on an edge, at a corner, each
/// of the fine mesh.
fn ray(index: u64, triangles: &[[Vec3; 3]]) -> (DVec3, DVec3) {
    let mut random = random(index + 1).skip(4);
    let mut next = || random.next().unwrap();
    let origin = DVec3::new(next(), next(), next()) * 1.9 - 0.95;
    // Every eighth origin has short coordinates, so that coincidences are exact.
    let origin = if index.is_multiple_of(8) {
        (origin * 4.0).trunc() / 4.0
    } else {
        origin
    };
    let [a, b, c] = triangles[(next() * triangles.len() as f64) as usize].map(Vec3::as_dvec3);
    let target = match index % 4 {
        0 => a,
        1 => a + (b - a) * next(),
        2 => (a + c) * 0.5,
        _ => a + (b - a) * next() * 0.5 + (c - a) * next() * 0.5,
    };
    (origin, target)
}

#[test]
fn no_ray_of_ten_million_leaks_out_of_a_closed_box() {
    for triangles in [fine_room(1), fine_room(7)] {
        let bvh = Bvh::new(&triangles);
        let leaks: u64 = (0..5_000_000u64)
            .into_par_iter()
            .map(|index| {
                let (origin, target) = ray(index, &triangles);
                let to = target - origin;
                // Both as it is, exactly at the target, and rounded like a shader's direction.
                let direction = if index % 3 == 0 {
                    to
                } else {
                    to.normalize().as_vec3().as_dvec3()
                };
                let Some(hit) = bvh.closest(origin, direction, 0.0, f64::INFINITY) else {
                    return 1;
                };
                let surface = (origin + direction * hit.distance).abs().max_element();
                let apart = (hit.distance * direction.length() / to.length() - 1.0).abs();
                u64::from((surface - 1.0).abs() > 1e-12 || apart > 1e-5)
            })
            .sum();
        assert_eq!(
            leaks,
            0,
            "of 5 000 000 rays in {} triangles",
            triangles.len()
        );
    }
}

#[test]
fn nearest_hits_are_those_of_all_triangles_tested_one_by_one() {
    let sphere = soup(&support::sphere(1.0, 12, false, false));
    let bvh = Bvh::new(&sphere);
    let singles: Vec<Bvh> = sphere.iter().map(|t| Bvh::new(&[*t])).collect();
    for (index, direction) in support::directions(300).enumerate() {
        let origin = DVec3::new(0.1, -2.0 + 0.01 * index as f64, 0.3);
        let direction = direction.as_dvec3();
        let one_by_one: Vec<(f64, usize)> = singles
            .iter()
            .enumerate()
            .filter_map(|(i, s)| Some((s.closest(origin, direction, 0.0, 9.0)?.distance, i)))
            .collect();
        let nearest = one_by_one
            .iter()
            .copied()
            .min_by(|a, b| a.0.total_cmp(&b.0));
        let hit = bvh.closest(origin, direction, 0.0, 9.0);
        assert_eq!(hit.map(|h| (h.distance, h.triangle as usize)), nearest);
        assert_eq!(bvh.occluded(origin, direction, 0.0, 9.0), nearest.is_some());
        assert_eq!(bvh.all(origin, direction, 0.0).len(), one_by_one.len());
        if let Some((distance, _)) = nearest {
            assert!(!bvh.occluded(origin, direction, 0.0, distance));
            assert_eq!(bvh.closest(origin, direction, 0.0, distance), None);
        }
    }
}

#[test]
fn of_triangles_at_one_distance_the_first_is_hit() {
    let once = fine_room(7);
    let twice = [once.as_slice(), &once].concat();
    let bvh = Bvh::new(&twice);
    for (index, direction) in support::directions(300).enumerate() {
        let origin = DVec3::new(0.1, 0.2, -0.003 * index as f64);
        let hit = bvh.closest(origin, direction.as_dvec3(), 0.0, 9.0);
        let triangle = hit.map(|h| h.triangle as usize);
        assert!(triangle.is_some_and(|t| t < once.len()), "{triangle:?}");
    }
}

/// Powers of two scale without rounding: hits are the same triangles in the same places.
#[test]
fn a_larger_or_smaller_scene_has_the_same_hits() {
    let triangles = fine_room(7);
    let bvh = Bvh::new(&triangles);
    for factor in [20, -10].map(|power| 2.0_f64.powi(power)) {
        let scaled: Vec<_> = triangles
            .iter()
            .map(|t| t.map(|corner| corner * factor as f32))
            .collect();
        let scaled = Bvh::new(&scaled);
        for index in 0..20_000 {
            let (origin, target) = ray(index, &triangles);
            let direction = (target - origin).normalize();
            let hit = bvh.closest(origin, direction, 0.0, f64::INFINITY);
            let same = scaled.closest(origin * factor, direction, 0.0, f64::INFINITY);
            let same = same.map(|h| (h.distance / factor, h.triangle, h.barycentric));
            assert_eq!(
                same,
                hit.map(|h| (h.distance, h.triangle, h.barycentric)),
                "ray {index}, scene times {factor}"
            );
        }
    }
}

#[test]
fn a_ray_that_starts_on_a_triangle_sees_the_next_one_however_near() {
    let bvh = Bvh::new(&fine_room(16));
    for gap in [1e-2, 1e-4, 1e-6] {
        let origin = DVec3::new(1.0 - gap, 0.31, 0.2);
        let hit = bvh.closest(origin, DVec3::X, 1e-8, f64::INFINITY).unwrap();
        assert!((hit.distance - gap).abs() < 1e-15);
    }
}

#[test]
fn odd_input_hits_nothing_and_never_panics() {
    let empty = Bvh::new(&[]);
    assert!(!empty.occluded(DVec3::ZERO, DVec3::X, 0.0, f64::INFINITY));
    let line = [Vec3::ZERO, Vec3::X, Vec3::X * 2.0];
    let bvh = Bvh::new(&[line, [Vec3::Y; 3]]);
    assert_eq!(
        bvh.closest(DVec3::NEG_Y, DVec3::Y, 0.0, f64::INFINITY),
        None
    );
    let room = Bvh::new(&soup(&support::room(Vec3::NEG_ONE, Vec3::ONE)));
    let nan = DVec3::new(f64::NAN, 0.0, 0.0);
    for (origin, direction) in [
        (nan, DVec3::X),
        (DVec3::ZERO, nan),
        (DVec3::ZERO, DVec3::INFINITY),
        (DVec3::splat(1e300), DVec3::X),
        (DVec3::ZERO, DVec3::ZERO),
    ] {
        assert_eq!(room.closest(origin, direction, 0.0, f64::INFINITY), None);
        assert!(!room.occluded(origin, direction, 0.0, f64::INFINITY));
    }
    assert!(
        room.closest(DVec3::ZERO, DVec3::new(-0.0, -0.0, 1.0), 0.0, 9.0)
            .is_some()
    );
}
