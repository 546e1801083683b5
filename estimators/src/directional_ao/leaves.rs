//! The leaf functions of math.rs and math.wgsl, with inputs and tolerances.

use super::math as ao;
use crate::leaves::*;

/// The leaf functions.
pub(super) const LEAVES: Leaves = Leaves {
    folder: "directional_ao",
    wgsl: include_str!("math.wgsl"),
    functions: FUNCTIONS,
    host_only: &[],
};

const FUNCTIONS: &[Leaf] = &[
    Leaf {
        name: "passes",
        wgsl: "outputs[id.x] = vec4f(passes(a[0], a[1], a[2]), 0.0, 0.0, 0.0);",
        calls: over_lanes!(|a| vec![ao::passes(a[0], a[1], a[2])]),
        inputs: depths,
        tolerance: Tolerance {
            absolute: 0.0,
            relative: 0.0,
            cause: "a comparison: no input lies within rounding of its threshold",
        },
    },
    Leaf {
        name: "open_cosine",
        wgsl: "outputs[id.x] = vec4f(open_cosine(a[0], a[1], a[2]), 0.0, 0.0, 0.0);",
        calls: over_lanes!(|a| vec![ao::open_cosine(a[0], a[1], a[2])]),
        inputs: || grid(&[&SIGNED, &[0.0, 1.0], &[-1.0, 0.0]]),
        tolerance: ulps(1, 1.0, "a product with 0 or 1"),
    },
];

/// Depths before, at and behind the map's, without and with a margin.
fn depths() -> Vec<Input> {
    let offsets = [-0.3, -1e-5, 0.0, 2e-7, 1e-6, 1e-3, 0.2];
    let mut inputs = grid(&[&offsets, &[0.31, 0.5, 1.0], &[0.0, 1.0 / 512.0]]);
    for a in &mut inputs {
        a[0] += a[1];
    }
    inputs
}
