//! The leaf functions and their inputs.

mod classic_envmap;
mod constant_ambient;
mod convolution;
mod direct_radiance_map;
mod directional_ao;
mod localized_cubemap;
mod point_form_factor;
mod polygon_form_factor;
mod reflection;
mod sh_mip_envmap;
mod shared;
mod texels;

use super::{ARGUMENTS, Call, Calls, Twin};
use interreflect_conformance::tolerance::Tolerance;
use interreflect_cpu::lane::{Lane, Scalar, Vector, Wide};

type Input = [f32; ARGUMENTS];

/// Functions that only the host calls: method and name.
pub(super) const CPU_ONLY: &[(&str, &str)] = &[
    ("convolution", "texel_vector_sr"),
    ("convolution", "node_direction"),
    ("sh_mip_envmap", "band_factor"),
    ("localized_cubemap", "texel_omega_text"),
    ("localized_cubemap", "texel_omega_shader"),
    ("localized_cubemap", "disc_area"),
    ("localized_cubemap", "cap_mean"),
    ("direct_radiance_map", "equal_angle_texel"),
    ("direct_radiance_map", "hemisphere_share"),
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
        Calls {
            f64: call::<f64>,
            f32: Some(call::<f32>),
            lanes: Some(call::<Wide>),
        }
    }};
}

/// Of functions that look into a table, lane by lane.
macro_rules! over_scalars {
    ($function:expr) => {{
        fn call<S: Scalar>(a: &[S; ARGUMENTS]) -> Vec<S> {
            let function: Call<S> = $function;
            function(a)
        }
        Calls {
            f64: call::<f64>,
            f32: Some(call::<f32>),
            lanes: None,
        }
    }};
}

/// Of functions of whole numbers.
macro_rules! in_f64 {
    ($function:expr) => {
        Calls {
            f64: $function,
            f32: None,
            lanes: None,
        }
    };
}

macro_rules! twin {
    ($method:literal, $name:literal, $wgsl:literal, $calls:expr, $inputs:expr, $tolerance:expr) => {
        Twin {
            method: $method,
            name: $name,
            wgsl: $wgsl,
            calls: $calls,
            inputs: $inputs,
            tolerance: $tolerance,
        }
    };
}

use {in_f64, over_lanes, over_scalars, twin};

/// Every function with a table, method by method.
pub(super) fn twins() -> impl Iterator<Item = &'static Twin> {
    let tables = [
        shared::TWINS,
        constant_ambient::TWINS,
        classic_envmap::TWINS,
        convolution::TWINS,
        directional_ao::TWINS,
        reflection::TWINS,
        localized_cubemap::TWINS,
        point_form_factor::TWINS,
        direct_radiance_map::TWINS,
        polygon_form_factor::TWINS,
        texels::TWINS,
        sh_mip_envmap::TWINS,
    ];
    tables.into_iter().flatten()
}

const SIGNED: [f32; 6] = [-1.0, -1e-3, 0.0, 1e-3, 0.5, 1.0];

fn vector<L: Lane>(a: &[L; ARGUMENTS], first: usize) -> Vector<L> {
    Vector::new(a[first], a[first + 1], a[first + 2])
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
