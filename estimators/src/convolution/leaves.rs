//! The leaf functions of math.rs and math.wgsl, with inputs and tolerances.

use super::math as convolution;
use crate::leaves::*;

/// The leaf functions.
pub const LEAVES: Leaves = Leaves {
    folder: "convolution",
    wgsl: include_str!("math.wgsl"),
    functions: FUNCTIONS,
    host_only: &["texel_vector_sr", "node_direction"],
};

const FUNCTIONS: &[Leaf] = &[
    Leaf {
        name: "cosine_weight",
        wgsl: "outputs[id.x] = vec4f(cosine_weight(vec3f(a[0], a[1], a[2]), vec3f(a[3], a[4], a[5])), 0.0, 0.0, 0.0);",
        calls: over_lanes!(|a| vec![convolution::cosine_weight(vector(a, 0), vector(a, 3))]),
        inputs: || spread(6, -1.0, 1.0),
        tolerance: ulps(
            3,
            3.0,
            "a scalar product whose terms cancel, of magnitude 3 at most",
        ),
    },
    Leaf {
        name: "phong_weight",
        wgsl: "outputs[id.x] = vec4f(phong_weight(a[0], a[1], a[2]), 0.0, 0.0, 0.0);",
        calls: over_lanes!(|a| vec![convolution::phong_weight(a[0], a[1], a[2])]),
        inputs: || {
            grid(&[
                &[-1.0, 0.0, 0.1, 0.5, 0.9],
                &[0.9, 0.99, 1.0],
                &[0.0, 1.0, 2.5, 12.5],
            ])
        },
        tolerance: LOBE,
    },
    Leaf {
        name: "map_nodes",
        wgsl: "outputs[id.x] = vec4f(f32(map_nodes(u32(a[0]))), 0.0, 0.0, 0.0);",
        calls: Calls::in_f64(|a| vec![convolution::map_nodes(a[0] as u32) as f64]),
        inputs: || grid(&[&[1.0, 2.0, 32.0, 256.0]]),
        tolerance: ulps(0, 0.0, "whole numbers"),
    },
    Leaf {
        name: "map_taps",
        wgsl: "let taps = map_taps(u32(a[0]), vec3f(a[1], a[2], a[3]));\n\
         outputs[id.x] = vec4f(f32(taps.base), f32(taps.side), taps.u, taps.v);",
        calls: over_scalars!(map_taps),
        inputs: || {
            let mut inputs = spread(4, -1.0, 1.0);
            for (i, a) in inputs.iter_mut().enumerate() {
                a[0] = [1.0, 7.0, 32.0][i % 3];
            }
            inputs
        },
        tolerance: ulps(
            4,
            32.0,
            "a division and a difference of numbers up to the cells along an edge",
        ),
    },
];

fn map_taps<S: Scalar>(a: &[S; ARGUMENTS]) -> Vec<S> {
    let taps = convolution::map_taps(a[0].whole() as u32, vector(a, 1));
    // The weights are products of u, v and their complements.
    let (u, v) = (taps[1].1 + taps[3].1, taps[2].1 + taps[3].1);
    let side = taps[2].0 - taps[0].0;
    vec![S::from(taps[0].0 as f32), S::from(side as f32), u, v]
}
