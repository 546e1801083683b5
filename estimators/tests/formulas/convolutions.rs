//! Convolved cube maps.

use crate::{near, of, vector, within};
use glam::DVec3;
use interreflect_estimators::convolution;
use interreflect_scene::conventions::cube_vector;

/// ∫ω dω over a texel, by the midpoint rule on the face: dω = ds dt/l³.
#[test]
fn a_texel_s_vector_points_to_it_and_has_its_cosine() {
    use convolution::math::{cosine_weight, texel_vector_sr};
    const STEPS: u32 = 60;
    for (face, column, row) in [
        (0, 0, 2),
        (1, 2, 1),
        (2, 1, 0),
        (3, 2, 2),
        (4, 0, 1),
        (5, 1, 2),
    ] {
        let mut expected = DVec3::ZERO;
        let width = 2.0 / 3.0 / f64::from(STEPS);
        for (i, j) in (0..STEPS).flat_map(|i| (0..STEPS).map(move |j| (i, j))) {
            let at = |cell: u32, step: u32| {
                2.0 * f64::from(cell) / 3.0 - 1.0 + (f64::from(step) + 0.5) * width
            };
            let l = cube_vector(face, at(column, i), at(row, j));
            expected += l.normalize() * (width * width / l.length().powi(3));
        }
        let found = texel_vector_sr(3, face, column, row);
        assert!((found - expected).length() < 1e-4, "{found} {expected}");
        let n = cube_vector(face, 0.0, 0.0);
        // All of it lies above this horizon.
        within(cosine_weight(of(n), of(found)), n.dot(found), 1e-9);
        assert_eq!(cosine_weight(of(-n), of(found)), 0.0);
    }
    // Cut in the middle: c = 0, so w/4 of |Ω|, where w is half of √|Ω|.
    let cut = cosine_weight(vector(1.0, 0.0, 0.0), vector(0.0, 0.0, 0.04));
    near(cut, 0.04 * 0.1 / 4.0);
}

#[test]
fn nodes_and_taps_of_a_convolved_map_meet() {
    use convolution::math::{map_nodes, map_taps, node_direction, phong_weight};
    assert_eq!(map_nodes(4), 6 * 25);
    // The first node of +x lies at s = t = −1: up and towards +z.
    let third = 1.0 / 3_f32.sqrt();
    let first = node_direction(4, 0);
    assert!(
        (first - glam::Vec3::splat(third)).length() < 1e-6,
        "{first}"
    );
    for index in [6, 31, 62, 87, 112, 137] {
        let direction = node_direction(4, index).as_dvec3();
        let taps = map_taps(4, of(direction));
        let weight: f64 = taps.iter().filter(|t| t.0 == index).map(|t| t.1).sum();
        within(weight, 1.0, 1e-5);
    }
    // A quarter of a cell to the right and half a cell down from node (1, 2) of face +z.
    let at = |cell: f64| 2.0 * cell / 4.0 - 1.0;
    let taps = map_taps(4, of(cube_vector(4, at(1.25), at(2.5))));
    let node = |column: usize, row: usize| (4 * 5 + row) * 5 + column;
    let expected = [
        (node(1, 2), 0.375),
        (node(2, 2), 0.125),
        (node(1, 3), 0.375),
        (node(2, 3), 0.125),
    ];
    for (found, expected) in taps.iter().zip(expected) {
        assert_eq!(found.0, expected.0);
        near(found.1, expected.1);
    }
    within(phong_weight(0.5, 1.0, 3.0), 0.125, 1e-9);
    within(phong_weight(0.4, 0.8, 3.0), 0.125, 1e-9);
    assert_eq!(phong_weight(-0.4, 0.8, 3.0), 0.0);
}
