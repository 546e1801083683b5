//! The leaf functions of math.rs and math.wgsl, with inputs and tolerances.

use super::math as sh_mip;
use crate::leaves::*;

/// The leaf functions.
pub(super) const LEAVES: Leaves = Leaves {
    folder: "sh_mip_envmap",
    wgsl: include_str!("math.wgsl"),
    functions: FUNCTIONS,
    host_only: &["band_factor"],
};

const FUNCTIONS: &[Leaf] = &[
    Leaf {
        name: "harmonics",
        wgsl: "var y = harmonics(vec3f(a[0], a[1], a[2]));\n\
         var chosen = 0.0;\n\
         for (var i = 0u; i < HARMONICS; i++) { chosen += a[3u + i] * y[i]; }\n\
         outputs[id.x] = vec4f(chosen, 0.0, 0.0, 0.0);",
        calls: over_lanes!(|a| {
            let terms = sh_mip::harmonics(vector(a, 0)).into_iter().zip(&a[3..]);
            vec![terms.fold(L::splat(0.0), |sum, (y, weight)| sum + y * *weight)]
        }),
        inputs: one_harmonic_at_a_time,
        tolerance: ulps(
            4,
            2.0,
            "a difference of two products of magnitude 3·1/3 at most",
        ),
    },
    Leaf {
        name: "level_offset",
        wgsl: "outputs[id.x] = vec4f(f32(level_offset(u32(a[0]), u32(a[1]))), 0.0, 0.0, 0.0);",
        calls: Calls::in_f64(|a| vec![f64::from(sh_mip::level_offset(a[0] as u32, a[1] as u32))]),
        inputs: || grid(&[&[64.0, 512.0], &[1.0, 2.0, 16.0, 64.0]]),
        tolerance: ulps(0, 0.0, "whole numbers"),
    },
    Leaf {
        name: "neighbour",
        wgsl: "let found = neighbour(u32(a[0]), u32(a[1]), i32(a[2]), i32(a[3]));\n\
         outputs[id.x] = vec4f(vec3f(found), 0.0);",
        calls: Calls::in_f64(|a| {
            let at = (a[2] as i32, a[3] as i32);
            let (face, column, row) = sh_mip::neighbour(a[0] as u32, a[1] as usize, at.0, at.1);
            vec![face as f64, f64::from(column), f64::from(row)]
        }),
        inputs: around_faces,
        tolerance: ulps(0, 0.0, "whole numbers"),
    },
    Leaf {
        name: "mip_taps",
        wgsl: "let taps = mip_taps(u32(a[0]), vec3f(a[1], a[2], a[3]));\n\
         outputs[id.x] = vec4f(f32(taps.first), taps.u, taps.v, 0.0);",
        calls: over_scalars!(|a| {
            let (first, u, v) = sh_mip::mip_taps(a[0].whole() as u32, vector(a, 1));
            vec![S::from(first as f32), u, v]
        }),
        inputs: || {
            let mut inputs = spread(4, -1.0, 1.0);
            for (i, a) in inputs.iter_mut().enumerate() {
                a[0] = [1.0, 2.0, 64.0][i % 3];
            }
            inputs
        },
        tolerance: ulps(
            4,
            64.0,
            "a division and a difference of numbers up to the texels along an edge",
        ),
    },
    Leaf {
        name: "biased_level",
        wgsl: "outputs[id.x] = vec4f(biased_level(a[0], a[1], a[2], a[3]), 0.0, 0.0, 0.0);",
        calls: over_lanes!(|a| vec![sh_mip::biased_level(a[0], a[1], a[2], a[3])]),
        inputs: || {
            grid(&[
                &[0.0, 1e-4, 0.01, 0.3, 3.0],
                &[8.0, 64.0],
                &[-1.0, 0.0, 2.5],
                &[3.0, 6.0],
            ])
        },
        tolerance: ulps(
            3,
            12.0,
            "WGSL's logarithm, of magnitude 12 at most where it is not clamped",
        ),
    },
];

/// Unit directions, with a weight of 1 for one of the harmonics.
fn one_harmonic_at_a_time() -> Vec<Input> {
    let directions = spread(3, -1.0, 1.0).into_iter().filter_map(|mut a| {
        let length = (0..3).map(|i| a[i] * a[i]).sum::<f32>().sqrt();
        (0..3).for_each(|i| a[i] /= length);
        (length > 0.1).then_some(a)
    });
    let with_weight = |a: Input, i: usize| {
        let mut a = a;
        a[3 + i] = 1.0;
        a
    };
    directions
        .flat_map(|a| (0..sh_mip::HARMONICS).map(move |i| with_weight(a, i)))
        .collect()
}

/// Every texel of a face and of its border, but for the border's corners.
fn around_faces() -> Vec<Input> {
    let mut inputs = Vec::new();
    for size in [1, 2, 8, 64] {
        for face in 0..6 {
            for (column, row) in (-1..=size).flat_map(|r| (-1..=size).map(move |c| (c, r))) {
                let inside = |i: i32| (0..size).contains(&i);
                if inside(column) || inside(row) {
                    let mut a = [0.0; ARGUMENTS];
                    (a[0], a[1], a[2], a[3]) =
                        (size as f32, face as f32, column as f32, row as f32);
                    inputs.push(a);
                }
            }
        }
    }
    inputs
}
