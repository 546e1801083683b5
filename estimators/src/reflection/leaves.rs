//! The leaf functions of math.rs and math.wgsl, with inputs and tolerances.

use super::math as reflection;
use crate::leaves::*;

/// The leaf functions.
pub const LEAVES: Leaves = Leaves {
    folder: "reflection",
    wgsl: include_str!("math.wgsl"),
    functions: FUNCTIONS,
    host_only: &[],
};

const FUNCTIONS: &[Leaf] = &[
    Leaf {
        name: "mirrored",
        wgsl: "outputs[id.x] = vec4f(mirrored(vec3f(a[0], a[1], a[2]), vec3f(a[3], a[4], a[5])), 0.0);",
        calls: over_lanes!(|a| {
            let r = reflection::mirrored(vector(a, 0), vector(a, 3));
            vec![r.x, r.y, r.z]
        }),
        inputs: || spread(6, -1.0, 1.0),
        tolerance: ulps(
            4,
            7.0,
            "a scalar product of magnitude 3 at most, doubled, and a difference",
        ),
    },
    Leaf {
        name: "schlick",
        wgsl: "outputs[id.x] = vec4f(schlick(a[0], a[1]), 0.0, 0.0, 0.0);",
        calls: over_lanes!(|a| vec![reflection::schlick(a[0], a[1])]),
        inputs: || {
            grid(&[
                &[0.0, 0.04, 0.2, 1.0],
                &[-1.0, -1e-3, 0.0, 1e-3, 0.3, 0.9, 1.0, 1.0001],
            ])
        },
        tolerance: ulps(4, 1.0, "a fifth power of a number of 1 at most, and a sum"),
    },
    Leaf {
        name: "fresnel_mix",
        wgsl: "outputs[id.x] = vec4f(fresnel_mix(a[0], vec3f(a[1]), vec3f(a[2]), vec3f(a[3]), vec3f(a[4])).x, 0.0, 0.0, 0.0);",
        calls: over_lanes!(|a| vec![reflection::fresnel_mix(a[0], a[1], a[2], a[3], a[4])]),
        inputs: || spread(5, 0.0, 1.0),
        tolerance: ulps(5, 0.0, "a sum of positive products"),
    },
];
