//! The leaf functions of math.rs and math.wgsl, with inputs and tolerances.

use super::math as localized;
use crate::leaves::*;

/// The leaf functions.
pub(super) const LEAVES: Leaves = Leaves {
    folder: "localized_cubemap",
    wgsl: include_str!("math.wgsl"),
    functions: FUNCTIONS,
    host_only: &[
        "texel_omega_text",
        "texel_omega_shader",
        "disc_area",
        "cap_mean",
    ],
};

const FUNCTIONS: &[Leaf] = &[
    Leaf {
        name: "omega_published",
        wgsl: "outputs[id.x] = vec4f(omega_published(a[0], a[1]), 0.0, 0.0, 0.0);",
        calls: over_lanes!(|a| vec![localized::omega_published(a[0], a[1])]),
        inputs: || {
            grid(&[
                &[1e-7, 1e-4, 0.01, 0.3, 0.9, 1.8],
                &[0.0, 1e-30, 1e-12, 1e-3, 0.5, 1.0, 4.0, 1e4, 1e12],
            ])
        },
        tolerance: ulps(
            8,
            0.0,
            "a division, sums of positive numbers, and 1 − Δω/π ≥ 0.4",
        ),
    },
    Leaf {
        name: "omega_corrected",
        wgsl: "outputs[id.x] = vec4f(omega_corrected(a[0], a[1], a[2]), 0.0, 0.0, 0.0);",
        calls: over_lanes!(|a| vec![localized::omega_corrected(a[0], a[1], a[2])]),
        inputs: || {
            grid(&[
                &[1e-7, 1e-4, 0.3, 3.0],
                &[0.0, 1e-30, 1e-12, 1e-3, 1.0, 1e4, 1e12],
                &[-1.0, -1e-6, 0.0, 1e-6, 1e-3, 0.5, 1.0],
            ])
        },
        tolerance: ulps(6, 0.0, "a division, products and a sum of positive numbers"),
    },
    Leaf {
        name: "reflectivity_published",
        wgsl: "let r = reflectivity_published(a[0], a[1], a[2], a[3]);\n\
         outputs[id.x] = vec4f(r.diffuse, r.specular, 0.0, 0.0);",
        calls: over_lanes!(|a| {
            let (d, s) = localized::reflectivity_published(a[0], a[1], a[2], a[3]);
            vec![d, s]
        }),
        inputs: || grid(&[&SIGNED, &SIGNED, &SIGNED, &[0.0, 1.0, 5.0, 100.0]]),
        tolerance: LOBE,
    },
    Leaf {
        name: "table_place",
        wgsl: "let p = table_place(a[0], a[1]);\n\
         outputs[id.x] = vec4f(p.first, p.second, 0.0, 0.0);",
        calls: over_lanes!(|a| {
            let (first, second) = localized::table_place(a[0], a[1]);
            vec![first, second]
        }),
        inputs: || {
            grid(&[
                &[-1.0, -0.5, 0.0, 0.7, 0.99, 1.0],
                &[0.0, 1e-4, 0.3, 3.0, 4.0],
            ])
        },
        tolerance: ulps(
            12,
            0.0,
            "two square roots of a difference that is exact or above 1/200",
        ),
    },
];
