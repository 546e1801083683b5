//! Spherical harmonics and mip pyramid on the CPU.

mod pyramid;

use super::math::{HARMONICS, biased_level, harmonics};
use super::tables::harmonic_weights;
use super::{LodMode, ShMipEnvmap};
use crate::averaging::{averaged, face_solid_angles_sr};
use crate::reflection::Lobes;
use crate::reflection::math::{fresnel_mix, mirrored, schlick};
use crate::{Cpu, Estimator, EstimatorError, Frame, Prepared, Quantity, Records};
use glam::{DVec3, Vec3};
use interreflect_cpu::lane::{Lane, Vector};
use interreflect_cpu::tiles::{PointLanes, TileKernel};
use interreflect_scene::{CubeImage, PointLayout};
use pyramid::{BoxWeights, Pyramid};

/// The coefficients and the pyramid, with their tables.
pub struct Filtered {
    method: ShMipEnvmap,
    tables: Tables,
    lobes: Lobes,
    irradiance: Harmonics,
    boxes: Option<BoxWeights>,
    /// There where some point has a lobe.
    pyramid: Option<Pyramid>,
}

struct Tables {
    omegas_sr: Vec<f32>,
    weights: Vec<f32>,
}

/// Coefficients of the irradiance.
struct Harmonics([Vec3; HARMONICS]);

impl Harmonics {
    /// Projects the capture, averaged by solid angle.
    fn project(method: &ShMipEnvmap, tables: &Tables, captured: &CubeImage) -> Self {
        let means: Vec<Vec3> = averaged(captured, &tables.omegas_sr, method.sh_size()).collect();
        let mut coefficients = [Vec3::ZERO; HARMONICS];
        let of_harmonics = tables.weights.chunks_exact(means.len());
        for (coefficient, weights) in coefficients.iter_mut().zip(of_harmonics) {
            let terms = means.iter().zip(weights);
            let sum: DVec3 = terms.map(|(l, w)| l.as_dvec3() * f64::from(*w)).sum();
            *coefficient = sum.as_vec3();
        }
        Self(coefficients)
    }

    /// E(n) = Σ Â_i·L_i·Y_i(n).
    #[inline(always)]
    fn irradiance<L: Lane>(&self, n: Vector<L>) -> [L; 3] {
        let mut sum = [L::from(0.0); 3];
        for (coefficient, y) in self.0.iter().zip(harmonics(n)) {
            for (sum, c) in sum.iter_mut().zip(coefficient.to_array()) {
                *sum = *sum + L::from(c) * y;
            }
        }
        sum
    }
}

impl Estimator<Cpu> for ShMipEnvmap {
    type Prepared = Filtered;

    fn prepare(
        &self,
        frame: &mut Frame<'_, Cpu>,
        last: Option<Filtered>,
    ) -> Result<Filtered, EstimatorError> {
        let (tables, mut lobes, irradiance, boxes, pyramid) = match last {
            Some(last) => (
                Some(last.tables),
                last.lobes,
                frame.unless_stale(Some(last.irradiance)),
                last.boxes,
                frame.unless_stale(last.pyramid),
            ),
            None => (None, Lobes::default(), None, None, None),
        };
        let shines = lobes.needed(frame);
        if shines {
            self.check_levels(frame)?;
        }
        let tables = tables.unwrap_or_else(|| Tables {
            omegas_sr: face_solid_angles_sr(self.captured().size),
            weights: harmonic_weights(self),
        });
        let irradiance = match irradiance {
            Some(irradiance) => irradiance,
            None => Harmonics::project(self, &tables, frame.cube(&self.captured())?),
        };
        let (boxes, pyramid) = match shines {
            false => (boxes, None),
            true => {
                let boxes = boxes.unwrap_or_else(|| BoxWeights::new(self));
                let pyramid = match pyramid {
                    Some(pyramid) => pyramid,
                    None => Pyramid::new(self, &boxes, frame.cube(&self.captured())?),
                };
                (Some(boxes), Some(pyramid))
            }
        };
        Ok(Filtered {
            method: self.clone(),
            tables,
            lobes,
            irradiance,
            boxes,
            pyramid,
        })
    }
}

impl Prepared<Cpu> for Filtered {
    fn shade(&self, frame: &mut Frame<'_, Cpu>) -> Result<(), EstimatorError> {
        let glossy = Glossy {
            method: &self.method,
            irradiance: &self.irradiance,
            pyramid: self.pyramid.as_ref(),
        };
        match frame.quantity {
            Quantity::GlossyRadiance => frame.for_each_tile(&glossy),
            _ => frame.for_each_tile(&self.irradiance),
        }
        Ok(())
    }

    fn records(&self, _caps: &()) -> Result<Vec<Records>, EstimatorError> {
        let padded = |rgb: &Vec3| rgb.extend(0.0).to_array();
        let of = |name, values: &[Vec3]| {
            Records::host(name, &values.iter().map(padded).collect::<Vec<_>>())
        };
        let pyramid = self.pyramid.iter().map(|p| of("pyramid", p.texels()));
        let coefficients = of("coefficients", &self.irradiance.0);
        Ok(std::iter::once(coefficients).chain(pyramid).collect())
    }
}

impl TileKernel for Harmonics {
    #[inline(always)]
    fn shade<L: Lane>(&self, points: &PointLanes<'_, L>) -> [L; 3] {
        self.irradiance(points.vector(PointLayout::NORMAL))
    }
}

/// L_o = (1 − F)·k_d/π·E(n) + F·k_s·L(r), the latter 0 where no point has a lobe.
struct Glossy<'a> {
    method: &'a ShMipEnvmap,
    irradiance: &'a Harmonics,
    pyramid: Option<&'a Pyramid>,
}

impl Glossy<'_> {
    #[inline(always)]
    fn level<L: Lane>(&self, footprint: L) -> L {
        let top = self.method.top_level() as f32;
        match self.method.lod_mode {
            LodMode::Absolute => L::from(self.method.lod.clamp(0.0, top)),
            LodMode::Bias => {
                let base = self.method.base_size() as f32;
                biased_level(footprint, base.into(), self.method.lod.into(), top.into())
            }
        }
    }
}

impl TileKernel for Glossy<'_> {
    #[inline(always)]
    fn shade<L: Lane>(&self, points: &PointLanes<'_, L>) -> [L; 3] {
        let n = points.vector(PointLayout::NORMAL);
        let v = points.vector(PointLayout::VIEW);
        let fresnel = schlick(self.method.f_lambda.into(), n.dot(v));
        let irradiance = self.irradiance.irradiance(n);
        let reflected = mirrored(n, v);
        let level: L = self.level(points.plane(PointLayout::FOOTPRINT));
        let radiance = self.pyramid.map_or(Vector::splat([0.0; 3]), |pyramid| {
            Vector::by_lane(|i| pyramid.radiance(reflected.lane(i), level.lanes()[i]))
        });
        let radiance = radiance.to_array();
        std::array::from_fn(|c| {
            let diffuse = points.plane(PointLayout::DIFFUSE + c);
            let specular = points.plane(PointLayout::SPECULAR + c);
            fresnel_mix(fresnel, diffuse, irradiance[c], specular, radiance[c])
        })
    }
}
