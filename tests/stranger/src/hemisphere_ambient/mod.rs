//! Ambient light of two colours, on both backends: an estimator whose claims are true.

mod cpu;
mod gpu;
mod leaves;
mod math;

use interreflect::prelude::*;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;

/// Ambient light of two colours: one from above, one from below, blended by the normal.
#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub struct HemisphereAmbient {
    /// Texels along a face's edge when the environment is captured.
    #[default(32)]
    #[schemars(range(min = 2, max = 96), extend("unit" = "texels"))]
    capture_resolution: u32,
}

impl HemisphereAmbient {
    fn captured(&self) -> CubeSpec {
        CubeSpec::of_radiance(self.capture_resolution)
    }
}

impl Method for HemisphereAmbient {
    const INFO: Info = Info {
        id: "hemisphere_ambient",
        title: "Hemisphere ambient light",
        summary: "the mean radiance from above and from below, blended by the normal",
        references: &[],
        figure: None,
    };

    const QUANTITIES: &'static [Quantity] = &[Quantity::Irradiance];

    const LEAVES: Leaves = leaves::LEAVES;

    fn needs(&self, _: Quantity, _: &SceneFacts) -> Result<Needs, Unsupported> {
        Ok(Needs {
            cubes: [self.captured()].into(),
            ..Needs::default()
        })
    }

    fn model(&self, _: Quantity) -> OwnModel {
        OwnModel::EnvironmentAtInfinity { bounces: 0 }
    }

    fn claims(&self, _: Quantity) -> Vec<Claim> {
        vec![
            Claim::NonNegative,
            Claim::Bounded {
                by: 1.0,
                cause: "a mean of means over half the sphere",
            },
            Claim::Linear,
            Claim::PositionInvariant,
            Claim::Meets {
                answers: Answers::Uniform,
                within: 1e-3,
                cause: "the facets of a lit sphere",
            },
        ]
    }
}
