//! What a method says of itself that can be checked.

use crate::quantity::Quantity;
use glam::Vec3;
use interreflect_scene::{Point, Scene};

/// Irradiance in W/m² at a point `x` with unit normal `n` from a planar quadrilateral that radiates 1
/// W·m⁻²·sr⁻¹, in metres: a method's own kernel, in its own precision. Positive when the corners run
/// clockwise seen from `x`.
pub type PatchKernel = fn(x: Vec3, n: Vec3, corners: &[Vec3; 4]) -> f32;

/// Something that must hold for every estimate of a method, or for its kernel.
///
/// A claim is the method's word for one quantity and one set of parameters: `verify` tries to falsify
/// it on every backend. What a method does not claim is tried too, and mentioned if it was not
/// falsified.
#[derive(Clone, Copy, Debug)]
pub enum Claim {
    /// Never below zero where no radiance is.
    NonNegative,
    /// Never above `by` times what surroundings of the greatest radiance would give everywhere.
    Bounded {
        /// The factor; 1 is the energy bound.
        by: f64,
        /// Why it is not 1, or why it is.
        cause: &'static str,
    },
    /// A sum of light gives the sum of the estimates.
    Linear,
    /// Light from behind the surface does not count.
    DarkFromBehind,
    /// The same in a scene of another size.
    ScaleInvariant,
    /// The same in a scene somewhere else.
    TranslationInvariant,
    /// The same in a scene that is mirrored or whose axes are swapped, as the cube allows.
    CubeSymmetric,
    /// The same everywhere for one normal, one viewer and one material.
    PositionInvariant,
    /// At the reference point it does not matter how far away things are.
    DistanceFree,
    /// Never higher where an occluder was added.
    MonotoneInOccluders,
    /// Meets exact answers of this kind, where its own model has them.
    Meets {
        /// Which answers.
        answers: Answers,
        /// Largest difference over the largest exact value.
        within: f64,
        /// What is left of it, and why.
        cause: &'static str,
    },
    /// Comes close to its own model inside a convex room as a parameter grows.
    Converges {
        /// The parameter.
        parameter: &'static str,
        /// A coarse value and a fine one.
        values: [&'static str; 2],
        /// Mean difference at the fine value over what surroundings of the greatest radiance would
        /// give. It is less at the fine value than at the coarse one.
        within: f64,
        /// What is left of it, and why.
        cause: &'static str,
    },
    /// No value of the parameter `resolution` from 1 to 64 is an outlier: in the scenes of the library its mean
    /// squared error against the own model is at most three times its neighbours'.
    Steady,
    /// A rule of the method's own holds at every point: one that may depend on where the point is.
    AtPoints {
        /// How far the estimate at a point is from it, in the unit of the quantity over
        /// [`PointEstimate::greatest`].
        departure: fn(&PointEstimate<'_>) -> f64,
        /// Its largest value.
        within: f64,
        /// The rule, and what is left of it.
        cause: &'static str,
    },
    /// A law of form factors holds for its kernel.
    FormFactor {
        /// The law.
        law: FormFactorLaw,
        /// The kernel.
        kernel: PatchKernel,
    },
}

/// An estimate at one point of a scene.
pub struct PointEstimate<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// What is estimated.
    pub quantity: Quantity,
    /// The point.
    pub point: Point,
    /// The estimate: RGB.
    pub estimate: Vec3,
    /// What surroundings of the greatest radiance that is sent anywhere would give.
    pub greatest: f64,
}

/// Kinds of exact answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Answers {
    /// Surroundings of one radiance.
    Uniform,
    /// A sky that changes slowly with direction.
    Smooth,
    /// Closed rooms whose walls differ.
    Walls,
    /// Patches alone in the dark: rectangles, discs, spheres, half a sky.
    Patches,
    /// Openness beside simple occluders.
    Openness,
    /// Walls that reflect the light of a lamp, as often as the model has it.
    Lit,
}

/// Laws of form factors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FormFactorLaw {
    /// Between 0 and 1.
    Fraction,
    /// A quadrilateral counts what its four parts count together.
    Additive,
    /// All faces of a closed box around the point count 1 together.
    Closed,
    /// A quadrilateral and the one that replaces it, corners in the other order, add up to nothing.
    Oriented,
    /// A₁F₁₂ = A₂F₂₁ for two patches, F₁₂ the mean over patch 1.
    ReciprocalPatches,
    /// The same from one patch's middle to the other's.
    ReciprocalMiddles,
}
