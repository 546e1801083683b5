//! The leaf functions of math.rs and math.wgsl, with inputs and tolerances.

use super::math as classic;
use crate::leaves::*;

/// The leaf functions.
pub(super) const LEAVES: Leaves = Leaves {
    folder: "classic_envmap",
    wgsl: include_str!("math.wgsl"),
    functions: FUNCTIONS,
    host_only: &[],
};

const FUNCTIONS: &[Leaf] = &[Leaf {
    name: "phong_exponent",
    wgsl: "outputs[id.x] = vec4f(phong_exponent(a[0]), 0.0, 0.0, 0.0);",
    calls: over_lanes!(|a| vec![classic::phong_exponent(a[0])]),
    inputs: || spread(1, 0.0, 1e5),
    tolerance: ulps(1, 0.0, "one product"),
}];
