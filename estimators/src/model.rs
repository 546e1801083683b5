//! What a method claims to compute, apart from how well it does.

use interreflect_cpu::path_tracer::LightPaths;

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
}
