//! The leaf functions of math.rs and math.wgsl, with inputs and tolerances.

use super::math as point;
use crate::leaves::*;

/// The leaf functions.
pub(super) const LEAVES: Leaves = Leaves {
    folder: "point_form_factor",
    wgsl: include_str!("math.wgsl"),
    functions: FUNCTIONS,
    host_only: &[],
};

const FUNCTIONS: &[Leaf] = &[Leaf {
    name: "point_omega",
    wgsl: "outputs[id.x] = vec4f(point_omega(a[0], a[1], a[2], a[3]), 0.0, 0.0, 0.0);",
    calls: over_lanes!(|a| vec![point::point_omega(a[0], a[1], a[2], a[3])]),
    inputs: || {
        grid(&[
            &[1e-4, 0.3, 3.0],
            &[0.0, 1e-12, 1e-3, 1.0, 1e4],
            &[-1.0, 0.0, 1e-6, 0.5, 1.0],
            &[0.5, 1e30],
        ])
    },
    tolerance: ulps(4, 0.0, "a product and a division of positive numbers"),
}];
