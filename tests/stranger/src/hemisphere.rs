//! Ambient light of two colours: an estimator whose claims are true.

use glam::Vec3;
use interreflect_estimators::averaging::cube_texels;
use interreflect_estimators::{
    Answers, Claim, Cpu, CpuOnly, Estimator, EstimatorError, Frame, Info, Method, OwnModel,
    Prepared, Quantity, Unsupported,
};
use interreflect_scene::conventions::{cube_vector, texel_centre, texel_index};
use interreflect_scene::{CubeSpec, Needs, SceneFacts};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;
use std::f32::consts::PI;

/// Ambient light of two colours: one from above, one from below, blended by the normal.
#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub struct HemisphereAmbient {
    /// Texels along a face's edge when the environment is captured.
    #[default(32)]
    #[schemars(range(min = 2, max = 256), extend("unit" = "texels"))]
    capture_resolution: u32,
}

fn captured(method: &HemisphereAmbient) -> CubeSpec {
    CubeSpec::of_radiance(method.capture_resolution)
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

    fn needs(&self, _: Quantity, _: &SceneFacts) -> Result<Needs, Unsupported> {
        Ok(Needs {
            cubes: [captured(self)].into(),
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

impl CpuOnly for HemisphereAmbient {
    const NO_GPU: &'static str = "this example runs on the CPU only";
}

/// Mean radiance from above and from below.
pub struct Means([Vec3; 2]);

impl Estimator<Cpu> for HemisphereAmbient {
    type Prepared = Means;

    fn prepare(
        &self,
        frame: &mut Frame<'_, Cpu>,
        _last: Option<Means>,
    ) -> Result<Means, EstimatorError> {
        let cube = frame.cube(&captured(self))?;
        let mut sums = [(Vec3::ZERO, 0.0_f32); 2];
        for (face, column, row) in cube_texels(cube.size) {
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
        Ok(Means(sums.map(|(sum, omega)| sum / omega)))
    }
}

impl Prepared<Cpu> for Means {
    fn shade(&self, frame: &mut Frame<'_, Cpu>) -> Result<(), EstimatorError> {
        let [above, below] = self.0;
        for (i, point) in frame.points.iter().enumerate() {
            let radiance = point.map(|p| below.lerp(above, 0.5 + 0.5 * p.normal.y));
            frame.out.set(i, PI * radiance.unwrap_or_default());
        }
        Ok(())
    }
}
