//! An estimator outside this repository: it gets the command line, the comparison and the report.
//!
//! `cargo run --release --example own_estimator -- bench studio --estimator hemisphere_ambient`

use glam::Vec3;
use interreflect_cpu::tiles::CpuCx;
use interreflect_estimators::{
    Answers, Claim, Cpu, CpuOnly, Entry, Estimator, EstimatorError, Info, Inputs, Method, OwnModel,
    Quantity, Registry, Unsupported,
};
use interreflect_scene::conventions::{CUBE_FACES, cube_vector, texel_centre, texel_index};
use interreflect_scene::params::{Field, Params};
use interreflect_scene::{CubeSpec, Estimate, Needs, SceneFacts};
use std::f32::consts::PI;
use std::process::ExitCode;

/// Ambient light of two colours: one from above, one from below, blended by the normal.
struct HemisphereAmbient;

#[derive(Clone, Debug, PartialEq)]
struct HemisphereParams {
    capture_resolution: u32,
}

impl Default for HemisphereParams {
    fn default() -> Self {
        Self {
            capture_resolution: 32,
        }
    }
}

impl Params for HemisphereParams {
    fn fields() -> Vec<Field<Self>> {
        vec![
            Field::u32(
                "capture_resolution",
                "texels along a face's edge when the environment is captured",
                2..=256,
                |p: &Self| p.capture_resolution,
                |p, v| p.capture_resolution = v,
            )
            .unit("texels"),
        ]
    }
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
                within: 1e-5,
                cause: "float32 sums over the captured texels",
            },
        ]
    }
}

impl CpuOnly for HemisphereAmbient {
    const NO_GPU: &'static str = "this example runs on the CPU only";
}

/// Mean radiance from above and from below.
#[derive(Default)]
struct State {
    above: Vec3,
    below: Vec3,
}

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
        *state = State {
            above: sums[0].0 / sums[0].1,
            below: sums[1].0 / sums[1].1,
        };
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
        for (i, point) in inputs.points.iter().enumerate() {
            let up = point.map_or(0.0, |p| p.normal.y);
            out.set(i, state.below.lerp(state.above, 0.5 + 0.5 * up) * PI);
        }
        Ok(())
    }
}

fn main() -> ExitCode {
    interreflect::run(Registry::builtin().with(Entry::cpu_only::<HemisphereAmbient>()))
}
