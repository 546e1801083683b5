//! The leaf functions of math.rs and math.wgsl, with inputs and tolerances.

use super::math::blended_irradiance;
use interreflect::leaves::*;

pub(super) const LEAVES: Leaves = Leaves {
    folder: "hemisphere_ambient",
    wgsl: include_str!("math.wgsl"),
    functions: &[Leaf {
        name: "blended_irradiance",
        wgsl: "outputs[id.x] = vec4f(blended_irradiance(vec3f(a[0]), vec3f(a[1]), a[2]), 0.0);",
        calls: over_lanes!(|a| vec![blended_irradiance(a[0], a[1], a[2])]),
        inputs: || grid(&[&[0.0, 0.3, 20.0], &[0.0, 0.7, 5.0], &SIGNED]),
        tolerance: ulps(6, 20.0, "a difference of two radiances of 20 at most"),
    }],
    host_only: &[],
};
