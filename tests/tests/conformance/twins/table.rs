//! The leaf functions and their inputs.
//! Long because it is one table.

use super::{ARGUMENTS, Call, Twin};
use interreflect_conformance::tolerance::Tolerance;
use interreflect_cpu::lane::{Lane, Vector};
use interreflect_estimators::classic_envmap::math as classic;
use interreflect_estimators::constant_ambient::math as ambient;
use interreflect_estimators::localized_cubemap::math as localized;

type Input = [f32; ARGUMENTS];

/// Functions that only the host calls: method and name.
pub(super) const CPU_ONLY: &[(&str, &str)] = &[
    ("classic_envmap", "texel_vector_sr"),
    ("classic_envmap", "node_direction"),
];

/// WGSL's accuracy, in units in the last place of 2⁻²³: 2.5 for a division, about 3 for a square
/// root with its reciprocal, ½ for anything else.
const fn ulps(count: u32, scale: f64, cause: &'static str) -> Tolerance {
    let ulp = 1.2e-7;
    Tolerance {
        absolute: count as f64 * ulp * scale,
        relative: count as f64 * ulp,
        cause,
    }
}

/// Error of the power of a lobe, which multiplies everything after it.
const LOBE: Tolerance = Tolerance {
    absolute: 1e-6,
    relative: 1e-5,
    cause: "the power's stated relative error above 1e-6, and its clamp far below",
};

macro_rules! over_lanes {
    ($function:expr) => {{
        fn call<L: Lane>(a: &[L; ARGUMENTS]) -> Vec<L> {
            let function: Call<L> = $function;
            function(a)
        }
        (call::<f64> as Call<f64>, Some(call::<f32> as Call<f32>))
    }};
}

macro_rules! in_f64 {
    ($function:expr) => {
        ($function as Call<f64>, None::<Call<f32>>)
    };
}

macro_rules! twin {
    ($method:literal, $name:literal, $wgsl:literal, $calls:expr, $inputs:expr, $tolerance:expr) => {
        Twin {
            method: $method,
            name: $name,
            wgsl: $wgsl,
            f64: $calls.0,
            f32: $calls.1,
            inputs: $inputs,
            tolerance: $tolerance,
        }
    };
}

pub(super) const TWINS: &[Twin] = &[
    twin!(
        "",
        "lobe_power",
        "outputs[id.x] = vec4f(lobe_power(a[0], a[1]), 0.0, 0.0, 0.0);",
        over_lanes!(|a| vec![a[0].lobe_power(a[1])]),
        || grid(&[&cosines(), &[0.0, 0.5, 1.0, 5.0, 50.0, 1e3]]),
        LOBE
    ),
    twin!(
        "constant_ambient",
        "ambient_irradiance",
        "outputs[id.x] = vec4f(ambient_irradiance(vec3f(a[0], a[1], a[2])), 0.0);",
        over_lanes!(|a| (0..3).map(|i| ambient::ambient_irradiance(a[i])).collect()),
        || spread(3, 0.0, 50.0),
        ulps(2, 0.0, "one product and the rounding of π")
    ),
    twin!(
        "constant_ambient",
        "ambient_reflection",
        "outputs[id.x] = vec4f(ambient_reflection(vec3f(a[0], a[1], a[2]), vec3f(a[3], a[4], a[5]), vec3f(a[6], a[7], a[8])), 0.0);",
        over_lanes!(|a| (0..3)
            .map(|i| ambient::ambient_reflection(a[i], a[i + 3], a[i + 6]))
            .collect()),
        || spread(9, 0.0, 1.0),
        ulps(2, 0.0, "a sum of positive numbers and a product")
    ),
    twin!(
        "classic_envmap",
        "phong_exponent",
        "outputs[id.x] = vec4f(phong_exponent(a[0]), 0.0, 0.0, 0.0);",
        in_f64!(|a| vec![f64::from(classic::phong_exponent(a[0] as f32))]),
        || spread(1, 0.0, 1e5),
        ulps(1, 0.0, "one product")
    ),
    twin!(
        "classic_envmap",
        "cosine_weight",
        "outputs[id.x] = vec4f(cosine_weight(vec3f(a[0], a[1], a[2]), vec3f(a[3], a[4], a[5])), 0.0, 0.0, 0.0);",
        over_lanes!(|a| vec![classic::cosine_weight(vector(a, 0), vector(a, 3))]),
        || spread(6, -1.0, 1.0),
        ulps(
            3,
            3.0,
            "a scalar product whose terms cancel, of magnitude 3 at most"
        )
    ),
    twin!(
        "classic_envmap",
        "phong_weight",
        "outputs[id.x] = vec4f(phong_weight(a[0], a[1], a[2]), 0.0, 0.0, 0.0);",
        over_lanes!(|a| vec![classic::phong_weight(a[0], a[1], a[2])]),
        || grid(&[
            &[-1.0, 0.0, 0.1, 0.5, 0.9],
            &[0.9, 0.99, 1.0],
            &[0.0, 1.0, 2.5, 12.5]
        ]),
        LOBE
    ),
    twin!(
        "classic_envmap",
        "map_nodes",
        "outputs[id.x] = vec4f(f32(map_nodes(u32(a[0]))), 0.0, 0.0, 0.0);",
        in_f64!(|a| vec![classic::map_nodes(a[0] as u32) as f64]),
        || grid(&[&[1.0, 2.0, 32.0, 256.0]]),
        ulps(0, 0.0, "whole numbers")
    ),
    twin!(
        "classic_envmap",
        "map_taps",
        "let taps = map_taps(u32(a[0]), vec3f(a[1], a[2], a[3]));\n\
         outputs[id.x] = vec4f(f32(taps.base), f32(taps.side), taps.u, taps.v);",
        in_f64!(map_taps),
        || {
            let mut inputs = spread(4, -1.0, 1.0);
            for (i, a) in inputs.iter_mut().enumerate() {
                a[0] = [1.0, 7.0, 32.0][i % 3];
            }
            inputs
        },
        ulps(
            4,
            32.0,
            "a division and a difference of numbers up to the cells along an edge"
        )
    ),
    twin!(
        "localized_cubemap",
        "texel_omega_text",
        "outputs[id.x] = vec4f(texel_omega_text(a[0], a[1]), 0.0, 0.0, 0.0);",
        in_f64!(|a| vec![localized::texel_omega_text(a[0], a[1])]),
        || grid(&[&[1.0, 2.0, 4.0, 8.0, 64.0], &[1.0, 1.1, 1.3, 1.7]]),
        ulps(8, 0.0, "two divisions and products of positive numbers")
    ),
    twin!(
        "localized_cubemap",
        "texel_omega_shader",
        "outputs[id.x] = vec4f(texel_omega_shader(a[0], a[1]), 0.0, 0.0, 0.0);",
        in_f64!(|a| vec![localized::texel_omega_shader(a[0], a[1])]),
        || grid(&[&[1.0, 2.0, 4.0, 8.0, 64.0], &[1.0, 1.1, 1.3, 1.7]]),
        ulps(8, 0.0, "two divisions and products of positive numbers")
    ),
    twin!(
        "localized_cubemap",
        "omega_published",
        "outputs[id.x] = vec4f(omega_published(a[0], a[1]), 0.0, 0.0, 0.0);",
        over_lanes!(|a| vec![localized::omega_published(a[0], a[1])]),
        || grid(&[
            &[1e-4, 0.01, 0.3, 0.9, 1.8],
            &[0.0, 1e-12, 1e-3, 0.5, 1.0, 4.0, 1e4]
        ]),
        ulps(
            8,
            0.0,
            "a division, sums of positive numbers, and 1 − Δω/π ≥ 0.4"
        )
    ),
    twin!(
        "localized_cubemap",
        "disc_area",
        "outputs[id.x] = vec4f(disc_area(a[0], a[1]), 0.0, 0.0, 0.0);",
        in_f64!(|a| vec![localized::disc_area(a[0], a[1])]),
        || grid(&[&[1e-4, 0.01, 0.3, 0.9, 1.8], &[1e-6, 0.01, 0.5, 1.0]]),
        ulps(8, 0.0, "a division, products, and 1 − Δω/π ≥ 0.4")
    ),
    twin!(
        "localized_cubemap",
        "omega_corrected",
        "outputs[id.x] = vec4f(omega_corrected(a[0], a[1], a[2]), 0.0, 0.0, 0.0);",
        over_lanes!(|a| vec![localized::omega_corrected(a[0], a[1], a[2])]),
        || grid(&[
            &[1e-4, 0.3, 3.0],
            &[1e-12, 1e-3, 1.0, 1e4],
            &[-1.0, 0.0, 1e-6, 0.5, 1.0]
        ]),
        ulps(6, 0.0, "a division, products and a sum of positive numbers")
    ),
    twin!(
        "localized_cubemap",
        "towards_texel",
        "let t = towards_texel(vec3f(a[0], a[1], a[2]), a[3], vec3f(a[4], a[5], a[6]));\n\
         outputs[id.x] = vec4f(t.i, t.r2);",
        over_lanes!(|a| {
            let (i, r2) = localized::towards_texel(vector(a, 0), a[3], vector(a, 4));
            vec![i.x, i.y, i.z, r2]
        }),
        towards,
        ulps(
            40,
            1.0,
            "a difference of unit size, divided by its length of 1/10 at least"
        )
    ),
    twin!(
        "localized_cubemap",
        "cos_half",
        "outputs[id.x] = vec4f(cos_half(vec3f(a[0], a[1], a[2]), vec3f(a[3], a[4], a[5]), vec3f(a[6], a[7], a[8])), 0.0, 0.0, 0.0);",
        over_lanes!(|a| vec![localized::cos_half(
            vector(a, 0),
            vector(a, 3),
            vector(a, 6)
        )]),
        || spread(9, -1.0, 1.0)
            .into_iter()
            .filter(|a| { (0..3).map(|i| (a[3 + i] + a[6 + i]).powi(2)).sum::<f32>() > 0.01 })
            .collect(),
        ulps(
            40,
            2.0,
            "a sum of terms that cancel, divided by its length of 1/10 at least"
        )
    ),
    twin!(
        "localized_cubemap",
        "reflectivity_published",
        "let r = reflectivity_published(a[0], a[1], a[2], a[3]);\n\
         outputs[id.x] = vec4f(r.diffuse, r.specular, 0.0, 0.0);",
        over_lanes!(|a| {
            let (d, s) = localized::reflectivity_published(a[0], a[1], a[2], a[3]);
            vec![d, s]
        }),
        || grid(&[&SIGNED, &SIGNED, &SIGNED, &[0.0, 1.0, 5.0, 100.0]]),
        LOBE
    ),
    twin!(
        "localized_cubemap",
        "reflectivity_corrected",
        "let r = reflectivity_corrected(a[0], a[1], a[2], a[3]);\n\
         outputs[id.x] = vec4f(r.diffuse, r.specular, 0.0, 0.0);",
        over_lanes!(|a| {
            let (d, s) = localized::reflectivity_corrected(a[0], a[1], a[2], a[3]);
            vec![d, s]
        }),
        || grid(&[&SIGNED, &SIGNED, &[0.0, 1.0, 5.0, 100.0], &[0.3, 4.0]]),
        Tolerance {
            absolute: 4e-6,
            ..LOBE
        }
    ),
    twin!(
        "localized_cubemap",
        "lobe_normalisation",
        "outputs[id.x] = vec4f(lobe_normalisation(a[0]), 0.0, 0.0, 0.0);",
        over_lanes!(|a| vec![localized::lobe_normalisation(a[0])]),
        || grid(&[&[0.0, 0.25, 1.0, 5.0, 30.0, 100.0, 1e3, 1e5]]),
        LOBE
    ),
];

const SIGNED: [f32; 6] = [-1.0, -1e-3, 0.0, 1e-3, 0.5, 1.0];

fn cosines() -> Vec<f32> {
    let near_one = (0..200).map(|i| 1.0 - (i as f32 / 200.0).powi(4));
    near_one.chain([-1.0, 0.0, 1e-7]).collect()
}

fn vector<L: Lane>(a: &[L; ARGUMENTS], first: usize) -> Vector<L> {
    Vector::new(a[first], a[first + 1], a[first + 2])
}

fn map_taps(a: &[f64; ARGUMENTS]) -> Vec<f64> {
    let direction = glam::DVec3::new(a[1], a[2], a[3]).as_vec3();
    let taps = classic::map_taps(a[0] as u32, direction);
    // The weights are products of u, v and their complements.
    let (u, v) = (taps[1].1 + taps[3].1, taps[2].1 + taps[3].1);
    let side = taps[2].0 - taps[0].0;
    vec![taps[0].0 as f64, side as f64, f64::from(u), f64::from(v)]
}

/// Every combination of these values.
fn grid(axes: &[&[f32]]) -> Vec<Input> {
    let mut inputs: Vec<Input> = vec![[0.0; ARGUMENTS]];
    for (i, axis) in axes.iter().enumerate() {
        let with = |input: &Input, value: f32| {
            let mut input = *input;
            input[i] = value;
            input
        };
        let previous = std::mem::take(&mut inputs);
        inputs.extend(
            previous
                .iter()
                .flat_map(|p| axis.iter().map(move |v| with(p, *v))),
        );
    }
    inputs
}

/// Inputs whose first `count` numbers fill [low, high] evenly and independently.
fn spread(count: usize, low: f32, high: f32) -> Vec<Input> {
    let fraction = |i: usize, k: usize| {
        let prime = [2, 3, 5, 7, 11, 13, 17, 19, 23][k] as f64;
        (prime.sqrt() * (i + 1) as f64).fract() as f32
    };
    (0..500)
        .map(|i| {
            let value = |k| match k < count {
                true => low + (high - low) * fraction(i, k),
                false => 0.0,
            };
            std::array::from_fn(value)
        })
        .collect()
}

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
