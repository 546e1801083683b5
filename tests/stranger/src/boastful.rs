//! Too much light, said to be none too much: an estimator whose claims are false.

use glam::Vec3;
use interreflect_cpu::tiles::CpuCx;
use interreflect_estimators::{
    Answers, Claim, Cpu, CpuOnly, Estimator, EstimatorError, Info, Inputs, Method, OwnModel,
    Quantity, Unsupported,
};
use interreflect_scene::{CubeSpec, Estimate, Needs, SceneFacts};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f32::consts::PI;

/// The brightest radiance that is seen from the reference point, doubled, as if it arrived from
/// everywhere.
pub struct Boastful;

/// It has none.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct NoParams;

fn captured() -> CubeSpec {
    CubeSpec::of_radiance(16)
}

impl Method for Boastful {
    type Params = NoParams;

    const INFO: Info = Info {
        id: "boastful",
        title: "Twice the brightest",
        source: "an example of claims that are false",
    };

    const QUANTITIES: &'static [Quantity] = &[Quantity::Irradiance];

    fn needs(_: &NoParams, _: Quantity, _: &SceneFacts) -> Result<Needs, Unsupported> {
        Ok(Needs {
            cubes: [captured()].into(),
            ..Needs::default()
        })
    }

    fn model(_: &NoParams, _: Quantity) -> OwnModel {
        OwnModel::MeanRadiance { bounces: 0 }
    }

    fn claims(_: &NoParams, _: Quantity) -> Vec<Claim> {
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

/// Twice the brightest radiance; `None` until it was prepared.
#[derive(Default)]
pub struct State(Option<Vec3>);

impl Estimator<Cpu> for Boastful {
    type State = State;

    fn prepare(
        _params: &NoParams,
        state: &mut State,
        _cx: &mut &CpuCx,
        _quantity: Quantity,
        inputs: &Inputs<'_, Cpu>,
        _out: &Estimate,
    ) -> Result<(), EstimatorError> {
        let radiance = &inputs.cube(&captured())?.radiance;
        let brightest = radiance.iter().copied().fold(Vec3::ZERO, Vec3::max);
        state.0 = Some(2.0 * brightest);
        Ok(())
    }

    fn shade(
        _params: &NoParams,
        state: &mut State,
        _cx: &mut &CpuCx,
        _quantity: Quantity,
        inputs: &Inputs<'_, Cpu>,
        out: &mut Estimate,
    ) -> Result<(), EstimatorError> {
        let radiance = state.0.ok_or(EstimatorError::Unprepared)?;
        for (i, point) in inputs.points.iter().enumerate() {
            out.set(i, point.map_or(Vec3::ZERO, |_| PI * radiance));
        }
        Ok(())
    }
}
