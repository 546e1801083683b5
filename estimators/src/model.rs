//! What a method claims to compute, apart from how well it does.

use crate::quantity::Quantity;
use interreflect_cpu::scene::CpuScene;
use interreflect_cpu::tiles::CpuCx;
use interreflect_scene::{Estimate, LightPaths, Points};
use std::fmt;

/// The quantity's value to which a method would converge if its own assumptions were true.
///
/// Every estimate is compared with its own model (how well it computes what it sets out to) and
/// with full light transport (what the model leaves out). Both fidelities of a method share one
/// model and the normalised reflectance of the `corrected` form, so an erratum shows as an error.
///
/// The reference point is where captures are wanted: that a method uses kept ones, made elsewhere, is
/// an error of the method and shows as one.
///
/// The first three take radiance as captures hold it, with as many `bounces` of the coarse solution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OwnModel {
    /// The mean radiance that is seen from the reference point arrives from everywhere.
    MeanRadiance {
        /// Reflections beyond that of the lights' light.
        bounces: u32,
    },
    /// What is seen from the reference point, moved to infinity.
    EnvironmentAtInfinity {
        /// Reflections beyond that of the lights' light.
        bounces: u32,
    },
    /// The surfaces visible from the reference point, at their place, all visible from the point.
    VisibleFromReference {
        /// Reflections beyond that of the lights' light.
        bounces: u32,
    },
    /// The environment at infinity, occluded by all surfaces, which themselves are black.
    OccludedEnvironment,
    /// All places that the scene's lights' rays meet first, through mirrors too, as they reflect that
    /// light once, all of them visible from the point.
    FirstHitsOfLights {
        /// They reflect by their whole material; else by Lambert's law alone.
        directional: bool,
    },
    /// Full light transport along these paths.
    LightTransport(LightPaths),
    /// A model of the method's own.
    Other(OtherModel),
}

/// A model that no other variant is: a method's crate computes it.
#[derive(Clone, Copy)]
pub struct OtherModel(pub &'static dyn ReferenceModel);

/// What a method claims to compute, evaluated by the method's crate: slowly, and better than the method
/// does.
pub trait ReferenceModel: Send + Sync {
    /// Its name in reports: one for each model.
    fn name(&self) -> &'static str;

    /// The quantity at each point, and how far each value may be off: a standard error, or the change
    /// from a computation half as fine.
    fn evaluate(
        &self,
        cx: &CpuCx,
        scene: &CpuScene,
        quantity: Quantity,
        points: &Points,
    ) -> (Estimate, Estimate);
}

impl PartialEq for OtherModel {
    fn eq(&self, other: &Self) -> bool {
        self.0.name() == other.0.name()
    }
}

impl fmt::Debug for OtherModel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0.name())
    }
}
