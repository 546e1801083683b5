use interreflect_cpu::path_tracer::LightPaths;
#[cfg(doc)]
use interreflect_cpu::path_tracer::REPLICATES;
use interreflect_scene::params::{Field, Params};

/// Parameters of [`super::PathReference`].
#[derive(Clone, Debug, PartialEq)]
pub struct PathReference {
    /// Samples per point; beyond [`REPLICATES`] rounded up to a multiple of it.
    pub samples: u32,
    /// Most reflections between a source and the arrival at a point; 0 = no limit.
    pub bounces: u32,
    /// Least reflections between a source and the arrival at a point.
    pub least_bounces: u32,
    /// Occluders between a point and what it sees count.
    pub indirect_visibility: bool,
    /// The receivers occlude and reflect.
    pub self_shadowing: bool,
    /// The surroundings are seen from the reference point, as if infinitely far away.
    pub environment_at_infinity: bool,
    /// Seed of the sampling sequence.
    pub seed: u32,
}

impl Default for PathReference {
    fn default() -> Self {
        Self {
            samples: 256,
            bounces: 0,
            least_bounces: 0,
            indirect_visibility: true,
            self_shadowing: true,
            environment_at_infinity: false,
            seed: 1,
        }
    }
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

impl Params for PathReference {
    fn fields() -> Vec<Field<Self>> {
        vec![
            Field::u32(
                "samples",
                "paths per point; beyond 32 rounded up to whole rounds",
                1..=1 << 20,
                |p: &Self| p.samples,
                |p, v| p.samples = v,
            )
            .log(),
            Field::u32(
                "bounces",
                "most reflections between a source and the arrival at a point; 0 = no limit",
                0..=64,
                |p: &Self| p.bounces,
                |p, v| p.bounces = v,
            ),
            Field::u32(
                "least_bounces",
                "least reflections between a source and the arrival at a point",
                0..=64,
                |p: &Self| p.least_bounces,
                |p, v| p.least_bounces = v,
            ),
            Field::bool(
                "indirect_visibility",
                "occluders between a point and what it sees count",
                |p: &Self| p.indirect_visibility,
                |p, v| p.indirect_visibility = v,
            ),
            Field::bool(
                "self_shadowing",
                "the receivers occlude and reflect",
                |p: &Self| p.self_shadowing,
                |p, v| p.self_shadowing = v,
            ),
            Field::bool(
                "environment_at_infinity",
                "the surroundings are seen from the reference point, as if infinitely far away",
                |p: &Self| p.environment_at_infinity,
                |p, v| p.environment_at_infinity = v,
            ),
            Field::u32(
                "seed",
                "seed of the sampling sequence",
                0..=u32::MAX,
                |p: &Self| p.seed,
                |p, v| p.seed = v,
            ),
        ]
    }
}
