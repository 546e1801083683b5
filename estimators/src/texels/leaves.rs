//! The leaf functions of math.rs and math.wgsl, with inputs and tolerances.

use super::math as texels;
use crate::leaves::*;

/// The leaf functions.
pub const LEAVES: Leaves = Leaves {
    folder: "texels",
    wgsl: include_str!("math.wgsl"),
    functions: FUNCTIONS,
    host_only: &[],
};

const FUNCTIONS: &[Leaf] = &[
    Leaf {
        name: "towards_texel",
        wgsl: "let t = towards_texel(vec3f(a[0], a[1], a[2]), a[3], vec3f(a[4], a[5], a[6]));\n\
         outputs[id.x] = vec4f(t.i, t.r2);",
        calls: over_lanes!(|a| {
            let (i, r2) = texels::towards_texel(vector(a, 0), a[3], vector(a, 4));
            vec![i.x, i.y, i.z, r2]
        }),
        inputs: towards,
        tolerance: ulps(
            40,
            1.0,
            "a difference of unit size, divided by its length of 1/10 at least",
        ),
    },
    Leaf {
        name: "cos_half",
        wgsl: "outputs[id.x] = vec4f(cos_half(vec3f(a[0], a[1], a[2]), vec3f(a[3], a[4], a[5]), vec3f(a[6], a[7], a[8])), 0.0, 0.0, 0.0);",
        calls: over_lanes!(|a| vec![texels::cos_half(vector(a, 0), vector(a, 3), vector(a, 6))]),
        inputs: || {
            spread(9, -1.0, 1.0)
                .into_iter()
                .filter(|a| (0..3).map(|i| (a[3 + i] + a[6 + i]).powi(2)).sum::<f32>() > 0.01)
                .collect()
        },
        tolerance: ulps(
            40,
            2.0,
            "a sum of terms that cancel, divided by its length of 1/10 at least",
        ),
    },
    Leaf {
        name: "normalised_reflectivity",
        wgsl: "let r = normalised_reflectivity(a[0], a[1], a[2], a[3]);\n\
         outputs[id.x] = vec4f(r.diffuse, r.specular, 0.0, 0.0);",
        calls: over_lanes!(|a| {
            let (d, s) = texels::normalised_reflectivity(a[0], a[1], a[2], a[3]);
            vec![d, s]
        }),
        inputs: || grid(&[&SIGNED, &SIGNED, &[0.0, 1.0, 5.0, 100.0], &[0.3, 4.0]]),
        tolerance: Tolerance {
            absolute: 4e-6,
            ..LOBE
        },
    },
    Leaf {
        name: "lobe_normalisation",
        wgsl: "outputs[id.x] = vec4f(lobe_normalisation(a[0]), 0.0, 0.0, 0.0);",
        calls: over_lanes!(|a| vec![texels::lobe_normalisation(a[0])]),
        inputs: || grid(&[&[0.0, 0.25, 1.0, 5.0, 30.0, 100.0, 1e3, 1e5]]),
        tolerance: LOBE,
    },
];

/// Texels at distances 1 to infinity in all directions, points within 0.9 of the reference point;
/// and a point at the very place of a texel.
fn towards() -> Vec<Input> {
    let mut inputs = spread(7, -1.0, 1.0);
    for a in &mut inputs {
        let length = (0..3).map(|i| a[i] * a[i]).sum::<f32>().sqrt().max(1e-3);
        for i in 0..3 {
            a[i] /= length;
            a[4 + i] *= 0.5;
        }
        a[3] = a[3].max(0.0);
    }
    let mut at_texel = [0.0; ARGUMENTS];
    (at_texel[0], at_texel[3], at_texel[4]) = (1.0, 0.5, 2.0);
    inputs.push(at_texel);
    inputs
}
