//! Leaf functions: the pure formulas of a folder's math.rs, each with a WGSL twin of its name in
//! math.wgsl.
//!
//! A folder's leaves.rs lists them with inputs and a tolerance. `verify` runs each on the device, and
//! in float32 alone and in lanes, and compares with float64 for the same inputs.

pub use crate::tolerance::Tolerance;
pub use crate::{over_lanes, over_scalars};
pub use interreflect_cpu::lane::{Lane, Scalar, Vector, Wide};

/// Numbers that a function takes, at most.
pub const ARGUMENTS: usize = 16;

/// Numbers that a function returns, at most.
pub const RESULTS: usize = 4;

/// The numbers that a function takes; those that it does not take are 0.
pub type Input = [f32; ARGUMENTS];

/// A call in Rust, over numbers of one precision.
pub type Call<T> = fn(&[T; ARGUMENTS]) -> Vec<T>;

/// A function in the arithmetics that it is generic over.
pub struct Calls {
    /// The exact one, which the others are compared with.
    pub f64: Call<f64>,
    /// One number at a time.
    pub f32: Option<Call<f32>>,
    /// Sixteen inputs side by side.
    pub lanes: Option<Call<Wide>>,
}

impl Calls {
    /// Calls of a function of whole numbers, in float64 alone.
    pub const fn in_f64(call: Call<f64>) -> Self {
        Self {
            f64: call,
            f32: None,
            lanes: None,
        }
    }
}

/// A leaf function with its inputs.
pub struct Leaf {
    /// Name in Rust and in WGSL.
    pub name: &'static str,
    /// The call in WGSL: statements that set `outputs[id.x]`, a `vec4f`, from the numbers in `a`.
    pub wgsl: &'static str,
    /// The calls in Rust.
    pub calls: Calls,
    /// The inputs.
    pub inputs: fn() -> Vec<Input>,
    /// How far float32 may be from float64.
    pub tolerance: Tolerance,
}

/// The leaf functions of one folder.
pub struct Leaves {
    /// The folder: a method's id, or the name of what several methods share.
    pub folder: &'static str,
    /// The source of math.wgsl.
    pub wgsl: &'static str,
    /// The functions that both math.rs and math.wgsl have.
    pub functions: &'static [Leaf],
    /// The functions of math.rs that only the host calls.
    pub host_only: &'static [&'static str],
}

impl Leaves {
    /// Of a method without a math.rs.
    pub const NONE: Self = Self {
        folder: "",
        wgsl: "",
        functions: &[],
        host_only: &[],
    };
}

/// The leaf functions that several methods share.
pub fn shared() -> [&'static Leaves; 4] {
    [
        &LANE,
        &crate::texels::leaves::LEAVES,
        &crate::convolution::leaves::LEAVES,
        &crate::reflection::leaves::LEAVES,
    ]
}

/// Functions of [`Lane`] itself.
const LANE: Leaves = Leaves {
    folder: "lane",
    wgsl: crate::LOBE_POWER,
    functions: &[Leaf {
        name: "lobe_power",
        wgsl: "outputs[id.x] = vec4f(lobe_power(a[0], a[1]), 0.0, 0.0, 0.0);",
        calls: over_lanes!(|a| vec![a[0].lobe_power(a[1])]),
        inputs: || grid(&[&cosines(), &[0.0, 0.5, 1.0, 5.0, 50.0, 1e3]]),
        tolerance: LOBE,
    }],
    host_only: &[],
};

fn cosines() -> Vec<f32> {
    let near_one = (0..200).map(|i| 1.0 - (i as f32 / 200.0).powi(4));
    near_one.chain([-1.0, 0.0, 1e-7]).collect()
}

/// A tolerance of `count` units in the last place, 2⁻²³, of the larger value and of `scale`.
///
/// WGSL's accuracy is 2.5 units for a division, about 3 for a square root with its reciprocal, ½ for
/// anything else.
pub const fn ulps(count: u32, scale: f64, cause: &'static str) -> Tolerance {
    let ulp = 1.2e-7;
    Tolerance {
        absolute: count as f64 * ulp * scale,
        relative: count as f64 * ulp,
        cause,
    }
}

/// Error of the power of a lobe, which multiplies everything after it.
pub const LOBE: Tolerance = Tolerance {
    absolute: 1e-6,
    relative: 1e-5,
    cause: "the power's stated relative error above 1e-6, and its clamp far below",
};

/// Cosines of either sign, with those near 0 and 1.
pub const SIGNED: [f32; 6] = [-1.0, -1e-3, 0.0, 1e-3, 0.5, 1.0];

/// Three neighbouring arguments as a vector.
pub fn vector<L: Lane>(a: &[L; ARGUMENTS], first: usize) -> Vector<L> {
    Vector::new(a[first], a[first + 1], a[first + 2])
}

/// Every combination of the values of these arguments.
pub fn grid(axes: &[&[f32]]) -> Vec<Input> {
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

/// 500 inputs whose first `count` numbers fill [low, high] evenly and independently.
pub fn spread(count: usize, low: f32, high: f32) -> Vec<Input> {
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

/// The [`Calls`] of a function over any [`Lane`]: a closure from the numbers `a: &[L; 16]` to the
/// results.
#[macro_export]
macro_rules! over_lanes {
    ($function:expr) => {{
        fn call<L: $crate::leaves::Lane>(a: &[L; $crate::leaves::ARGUMENTS]) -> Vec<L> {
            let function: $crate::leaves::Call<L> = $function;
            function(a)
        }
        $crate::leaves::Calls {
            f64: call::<f64>,
            f32: Some(call::<f32>),
            lanes: Some(call::<$crate::leaves::Wide>),
        }
    }};
}

/// The [`Calls`] of a function over any [`Scalar`], as one that looks into a table lane by lane is.
#[macro_export]
macro_rules! over_scalars {
    ($function:expr) => {{
        fn call<S: $crate::leaves::Scalar>(a: &[S; $crate::leaves::ARGUMENTS]) -> Vec<S> {
            let function: $crate::leaves::Call<S> = $function;
            function(a)
        }
        $crate::leaves::Calls {
            f64: call::<f64>,
            f32: Some(call::<f32>),
            lanes: None,
        }
    }};
}
