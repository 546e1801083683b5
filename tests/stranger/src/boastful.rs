//! Too much light, said to be none too much: an estimator whose claims are false.

use interreflect::prelude::*;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f32::consts::PI;

/// The brightest radiance that is seen from the reference point, doubled, as if it arrived from
/// everywhere.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Boastful;

fn captured() -> CubeSpec {
    CubeSpec::of_radiance(16)
}

impl Method for Boastful {
    const INFO: Info = Info {
        id: "boastful",
        title: "Twice the brightest",
        summary: "twice the brightest radiance from everywhere: its claims are false",
        references: &[],
        figure: None,
    };

    const QUANTITIES: &'static [Quantity] = &[Quantity::Irradiance];

    fn needs(&self, _: Quantity, _: &SceneFacts) -> Result<Needs, Unsupported> {
        Ok(Needs {
            cubes: [captured()].into(),
            ..Needs::default()
        })
    }

    fn model(&self, _: Quantity) -> OwnModel {
        OwnModel::MeanRadiance { bounces: 0 }
    }

    fn claims(&self, _: Quantity) -> Vec<Claim> {
        vec![
            Claim::NonNegative,
            Claim::Bounded {
                by: 1.0,
                cause: "it is not",
            },
            Claim::Linear,
            Claim::Meets {
                answers: Answers::Uniform,
                within: 0.01,
                cause: "it does not",
            },
        ]
    }
}

impl CpuOnly for Boastful {
    const NO_GPU: &'static str = "this example runs on the CPU only";
}

/// Twice the brightest radiance.
pub struct Twice(Vec3);

impl Estimator<Cpu> for Boastful {
    type Prepared = Twice;

    fn prepare(
        &self,
        frame: &mut Frame<'_, Cpu>,
        _last: Option<Twice>,
    ) -> Result<Twice, EstimatorError> {
        let radiance = &frame.cube(&captured())?.radiance;
        let brightest = radiance.iter().copied().fold(Vec3::ZERO, Vec3::max);
        Ok(Twice(2.0 * brightest))
    }
}

impl Prepared<Cpu> for Twice {
    fn shade(&self, frame: &mut Frame<'_, Cpu>) -> Result<(), EstimatorError> {
        for (i, point) in frame.points.iter().enumerate() {
            let irradiance = point.map_or(Vec3::ZERO, |_| PI * self.0);
            frame.out.set(i, irradiance);
        }
        Ok(())
    }
}
