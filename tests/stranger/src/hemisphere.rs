//! Ambient light of two colours: an estimator whose claims are true.

use glam::Vec3;
use interreflect_cpu::tiles::CpuCx;
use interreflect_estimators::{
    Answers, Claim, Cpu, CpuOnly, Estimator, EstimatorError, Info, Inputs, Method, OwnModel,
    Quantity, Unsupported,
};
use interreflect_scene::conventions::{CUBE_FACES, cube_vector, texel_centre, texel_index};
use interreflect_scene::{CubeSpec, Estimate, Needs, SceneFacts};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;
use std::f32::consts::PI;

/// Ambient light of two colours: one from above, one from below, blended by the normal.
pub struct HemisphereAmbient;

/// Parameters of [`HemisphereAmbient`].
#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub struct HemisphereParams {
    /// Texels along a face's edge when the environment is captured.
    #[default(32)]
    #[schemars(range(min = 2, max = 256), extend("unit" = "texels"))]
    capture_resolution: u32,
}

fn captured(params: &HemisphereParams) -> CubeSpec {
    CubeSpec::of_radiance(params.capture_resolution)
}

impl Method for HemisphereAmbient {
    type Params = HemisphereParams;

    const INFO: Info = Info {
        id: "hemisphere_ambient",
        title: "Hemisphere ambient light",
        source: "an example",
    };

    const QUANTITIES: &'static [Quantity] = &[Quantity::Irradiance];

    fn needs(p: &HemisphereParams, _: Quantity, _: &SceneFacts) -> Result<Needs, Unsupported> {
        Ok(Needs {
            cubes: [captured(p)].into(),
            ..Needs::default()
        })
    }

    fn model(_: &HemisphereParams, _: Quantity) -> OwnModel {
        OwnModel::EnvironmentAtInfinity { bounces: 0 }
    }

    fn claims(_: &HemisphereParams, _: Quantity) -> Vec<Claim> {
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

impl CpuOnly for HemisphereAmbient {
    const NO_GPU: &'static str = "this example runs on the CPU only";
}

/// Mean radiance from above and from below; `None` until it was prepared.
#[derive(Default)]
pub struct State(Option<[Vec3; 2]>);

impl Estimator<Cpu> for HemisphereAmbient {
    type State = State;

    fn prepare(
        params: &HemisphereParams,
        state: &mut State,
        _cx: &mut &CpuCx,
        _quantity: Quantity,
        inputs: &Inputs<'_, Cpu>,
        _out: &Estimate,
    ) -> Result<(), EstimatorError> {
        let cube = inputs.cube(&captured(params))?;
        let mut sums = [(Vec3::ZERO, 0.0_f32); 2];
        for face in 0..CUBE_FACES {
            for row in 0..cube.size {
                for column in 0..cube.size {
                    let (s, t) = (
                        texel_centre(cube.size, column),
                        texel_centre(cube.size, row),
                    );
                    let l = cube_vector(face, s, t);
                    let omega = 1.0 / l.length().powi(3) as f32;
                    let radiance = cube.radiance[texel_index(cube.size, face, column, row)];
                    let sum = &mut sums[usize::from(l.y < 0.0)];
                    *sum = (sum.0 + radiance * omega, sum.1 + omega);
                }
            }
        }
        state.0 = Some(sums.map(|(sum, omega)| sum / omega));
        Ok(())
    }

    fn shade(
        _params: &HemisphereParams,
        state: &mut State,
        _cx: &mut &CpuCx,
        _quantity: Quantity,
        inputs: &Inputs<'_, Cpu>,
        out: &mut Estimate,
    ) -> Result<(), EstimatorError> {
        let [above, below] = state.0.ok_or(EstimatorError::Unprepared)?;
        for (i, point) in inputs.points.iter().enumerate() {
            let radiance = point.map(|p| below.lerp(above, 0.5 + 0.5 * p.normal.y));
            out.set(i, PI * radiance.unwrap_or_default());
        }
        Ok(())
    }
}
