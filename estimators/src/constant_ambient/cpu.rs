//! Constant ambient light on the CPU.

use super::math::{ambient_irradiance, ambient_reflection};
use super::{ConstantAmbient, ConstantAmbientParams};
use crate::averaging::{face_solid_angles_sr, mean_radiance};
use crate::kept::Kept;
use crate::{Cpu, Estimator, EstimatorError, Inputs, Prepared, Quantity, Records};
use glam::Vec3;
use interreflect_cpu::lane::Lane;
use interreflect_cpu::tiles::{CpuCx, PointLanes, TileKernel};
use interreflect_scene::conventions::CUBE_FACES;
use interreflect_scene::{Estimate, PointLayout};

/// The texels' solid angles and the mean radiance, kept across frames.
#[derive(Default)]
pub struct State {
    omegas_sr: Kept<ConstantAmbientParams, Vec<f32>>,
    radiance: Option<Vec3>,
}

impl Prepared<Cpu> for State {
    fn records(&self, _caps: &()) -> Result<Vec<Records>, EstimatorError> {
        let radiance = self.radiance.iter();
        let record = |rgb: &Vec3| Records::host("mean", &[rgb.extend(0.0).to_array()]);
        Ok(radiance.map(record).collect())
    }
}

impl Estimator<Cpu> for ConstantAmbient {
    type State = State;

    fn prepare(
        params: &ConstantAmbientParams,
        state: &mut State,
        _cx: &mut &CpuCx,
        _quantity: Quantity,
        inputs: &Inputs<'_, Cpu>,
        _out: &Estimate,
    ) -> Result<(), EstimatorError> {
        let captured = inputs.cube(&params.captured())?;
        let solid_angles = || Ok(face_solid_angles_sr(captured.size));
        let omegas_sr = state.omegas_sr.tables(params, solid_angles)?;
        let face = |face| mean_radiance(captured, omegas_sr, 1, face, 0, 0);
        let sum: Vec3 = (0..CUBE_FACES).map(face).sum();
        state.radiance = Some(sum / CUBE_FACES as f32);
        Ok(())
    }

    fn shade(
        _params: &ConstantAmbientParams,
        state: &mut State,
        cx: &mut &CpuCx,
        quantity: Quantity,
        inputs: &Inputs<'_, Cpu>,
        out: &mut Estimate,
    ) -> Result<(), EstimatorError> {
        let radiance = state.radiance.ok_or(EstimatorError::Unprepared)?.to_array();
        match quantity {
            Quantity::GlossyRadiance => cx.for_each_tile(inputs.points, out, &Glossy(radiance)),
            _ => cx.for_each_tile(inputs.points, out, &Diffuse(radiance)),
        }
        Ok(())
    }
}

struct Diffuse([f32; 3]);

impl TileKernel for Diffuse {
    #[inline(always)]
    fn shade<L: Lane>(&self, _points: &PointLanes<'_, L>) -> [L; 3] {
        self.0.map(|radiance| ambient_irradiance(L::from(radiance)))
    }
}

struct Glossy([f32; 3]);

impl TileKernel for Glossy {
    #[inline(always)]
    fn shade<L: Lane>(&self, points: &PointLanes<'_, L>) -> [L; 3] {
        std::array::from_fn(|c| {
            ambient_reflection(
                points.plane(PointLayout::DIFFUSE + c),
                points.plane(PointLayout::SPECULAR + c),
                self.0[c].into(),
            )
        })
    }
}
