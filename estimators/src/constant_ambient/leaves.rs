//! The leaf functions of math.rs and math.wgsl, with inputs and tolerances.

use super::math as ambient;
use crate::leaves::*;

/// The leaf functions.
pub(super) const LEAVES: Leaves = Leaves {
    folder: "constant_ambient",
    wgsl: include_str!("math.wgsl"),
    functions: FUNCTIONS,
    host_only: &[],
};

const FUNCTIONS: &[Leaf] = &[
    Leaf {
        name: "ambient_irradiance",
        wgsl: "outputs[id.x] = vec4f(ambient_irradiance(vec3f(a[0], a[1], a[2])), 0.0);",
        calls: over_lanes!(|a| (0..3).map(|i| ambient::ambient_irradiance(a[i])).collect()),
        inputs: || spread(3, 0.0, 50.0),
        tolerance: ulps(2, 0.0, "one product and the rounding of π"),
    },
    Leaf {
        name: "ambient_reflection",
        wgsl: "outputs[id.x] = vec4f(ambient_reflection(vec3f(a[0], a[1], a[2]), vec3f(a[3], a[4], a[5]), vec3f(a[6], a[7], a[8])), 0.0);",
        calls: over_lanes!(|a| (0..3)
            .map(|i| ambient::ambient_reflection(a[i], a[i + 3], a[i + 6]))
            .collect()),
        inputs: || spread(9, 0.0, 1.0),
        tolerance: ulps(2, 0.0, "a sum of positive numbers and a product"),
    },
];
