//! The leaf functions of math.rs and math.wgsl, with inputs and tolerances.

use super::math as map;
use crate::leaves::*;

/// The leaf functions.
pub(super) const LEAVES: Leaves = Leaves {
    folder: "direct_radiance_map",
    wgsl: include_str!("math.wgsl"),
    functions: FUNCTIONS,
    host_only: &["equal_angle_texel", "hemisphere_share"],
};

const FUNCTIONS: &[Leaf] = &[
    Leaf {
        name: "towards_photon",
        wgsl: "let t = towards_photon(vec3f(a[0], a[1], a[2]), vec3f(a[3], a[4], a[5]));\n\
         outputs[id.x] = vec4f(t.i, t.r2);",
        calls: over_lanes!(|a| {
            let (i, r2) = map::towards_photon(vector(a, 0), vector(a, 3));
            vec![i.x, i.y, i.z, r2]
        }),
        inputs: places,
        tolerance: ulps(
            10,
            1.0,
            "a difference of exact numbers, divided by its own length",
        ),
    },
    Leaf {
        name: "area_across",
        wgsl: "outputs[id.x] = vec4f(area_across(a[0], a[1]), 0.0, 0.0, 0.0);",
        calls: over_lanes!(|a| vec![map::area_across(a[0], a[1])]),
        inputs: || grid(&[&[1e-4, 0.3, 3.0], &[1e-3, 1.0, 50.0]]),
        tolerance: ulps(2, 0.0, "two products of positive numbers"),
    },
    Leaf {
        name: "lit_area",
        wgsl: "outputs[id.x] = vec4f(lit_area(a[0], a[1]), 0.0, 0.0, 0.0);",
        calls: over_lanes!(|a| vec![map::lit_area(a[0], a[1])]),
        inputs: || grid(&[&[1e-4, 0.3, 3.0], &[0.0, 1e-7, 1e-3, 0.5, 1.0]]),
        tolerance: ulps(4, 0.0, "a division of positive numbers"),
    },
    Leaf {
        name: "omega_far",
        wgsl: "outputs[id.x] = vec4f(omega_far(a[0], a[1]), 0.0, 0.0, 0.0);",
        calls: over_lanes!(|a| vec![map::omega_far(a[0], a[1])]),
        inputs: || grid(&[&[1e-4, 0.3, 3.0], &[1e-3, 1.0, 12.0, 1e6]]),
        tolerance: ulps(3, 0.0, "a division of positive numbers"),
    },
    Leaf {
        name: "omega_published",
        wgsl: "outputs[id.x] = vec4f(omega_published(a[0], a[1], a[2]), 0.0, 0.0, 0.0);",
        calls: over_lanes!(|a| vec![map::omega_published(a[0], a[1], a[2])]),
        inputs: discs,
        tolerance: ulps(5, 0.0, "a sum and a division of positive numbers"),
    },
    Leaf {
        name: "omega_corrected",
        wgsl: "outputs[id.x] = vec4f(omega_corrected(a[0], a[1], a[2]), 0.0, 0.0, 0.0);",
        calls: over_lanes!(|a| vec![map::omega_corrected(a[0], a[1], a[2])]),
        inputs: discs,
        tolerance: ulps(6, 0.0, "a sum and a division of positive numbers"),
    },
];

/// Photons and points all over a room, points a few roundings from a photon, points far away, and one
/// at the very place of a photon.
fn places() -> Vec<Input> {
    let mut inputs = spread(6, -1.0, 1.0);
    for (i, mut a) in inputs.clone().into_iter().enumerate().step_by(10) {
        for k in 0..3 {
            // The difference of two neighbours is exact.
            a[3 + k] = match i % 20 {
                0 => a[k] * (1.0 + 4e-7 * k as f32),
                _ => 1e5 * a[3 + k],
            };
        }
        inputs.push(a);
    }
    inputs.push([0.5; ARGUMENTS]);
    inputs
}

/// Areas, squared distances and cosines.
fn discs() -> Vec<Input> {
    grid(&[
        &[0.0, 1e-7, 1e-4, 0.3, 3.0],
        &[0.0, 1e-30, 1e-12, 1e-3, 1.0, 1e4, 1e12],
        &[-1.0, -1e-6, 0.0, 1e-6, 1e-3, 0.5, 1.0],
    ])
}
