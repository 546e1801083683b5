use interreflect_scene::LightPaths;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;

/// Path tracing, by its parameters.
#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub struct PathReference {
    /// Paths per point; beyond 32 rounded up to whole rounds.
    ///
    /// A round has [`interreflect_cpu::path_tracer::REPLICATES`] paths.
    #[default(256)]
    #[schemars(range(min = 1, max = 1 << 20), extend("scale" = "log"))]
    pub samples: u32,
    /// Most reflections between a source and the arrival at a point; 0 = no limit.
    #[default(0)]
    #[schemars(range(max = 64))]
    pub bounces: u32,
    /// Least reflections between a source and the arrival at a point.
    #[default(0)]
    #[schemars(range(max = 64))]
    pub least_bounces: u32,
    /// Occluders between a point and the surfaces around it count.
    #[default(true)]
    pub indirect_visibility: bool,
    /// The receivers occlude and reflect.
    #[default(true)]
    pub self_shadowing: bool,
    /// The surroundings are seen from the reference point, as if infinitely far away.
    #[default(false)]
    pub environment_at_infinity: bool,
    /// Seed of the sampling sequence.
    #[default(1)]
    pub seed: u32,
}

impl PathReference {
    /// The light paths that these parameters select.
    pub fn paths(&self) -> LightPaths {
        LightPaths {
            bounces: self.bounces,
            least_bounces: self.least_bounces,
            indirect_visibility: self.indirect_visibility,
            self_shadowing: self.self_shadowing,
            environment_at_infinity: self.environment_at_infinity,
        }
    }
}
