//! Constant ambient light on the CPU.

use super::ConstantAmbient;
use super::math::{ambient_irradiance, ambient_reflection};
use crate::averaging::{face_solid_angles_sr, mean_radiance};
use crate::{Cpu, Estimator, EstimatorError, Frame, Prepared, Quantity, Records};
use glam::Vec3;
use interreflect_cpu::lane::Lane;
use interreflect_cpu::tiles::{PointLanes, TileKernel};
use interreflect_scene::PointLayout;
use interreflect_scene::conventions::CUBE_FACES;

/// The texels' solid angles and the mean radiance.
pub struct Mean {
    omegas_sr: Vec<f32>,
    radiance: Vec3,
}

impl Estimator<Cpu> for ConstantAmbient {
    type Prepared = Mean;

    fn prepare(
        &self,
        frame: &mut Frame<'_, Cpu>,
        last: Option<Mean>,
    ) -> Result<Mean, EstimatorError> {
        let captured = frame.cube(&self.captured())?;
        let omegas_sr = match last {
            Some(last) => last.omegas_sr,
            None => face_solid_angles_sr(captured.size),
        };
        let face = |face| mean_radiance(captured, &omegas_sr, 1, face, 0, 0);
        let sum: Vec3 = (0..CUBE_FACES).map(face).sum();
        Ok(Mean {
            omegas_sr,
            radiance: sum / CUBE_FACES as f32,
        })
    }
}

impl Prepared<Cpu> for Mean {
    fn shade(&self, frame: &mut Frame<'_, Cpu>) -> Result<(), EstimatorError> {
        let radiance = self.radiance.to_array();
        match frame.quantity {
            Quantity::GlossyRadiance => frame.for_each_tile(&Glossy(radiance)),
            _ => frame.for_each_tile(&Diffuse(radiance)),
        }
        Ok(())
    }

    fn records(&self, _caps: &()) -> Result<Vec<Records>, EstimatorError> {
        let mean = self.radiance.extend(0.0).to_array();
        Ok(vec![Records::host("mean", &[mean])])
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
