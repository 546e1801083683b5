//! Spherical harmonics and mip pyramid on the CPU.

mod pyramid;

use super::math::{HARMONICS, biased_level, harmonics};
use super::tables::harmonic_weights;
use super::{LodMode, ShMipEnvmap, ShMipEnvmapParams, check_levels};
use crate::averaging::{averaged, face_solid_angles_sr};
use crate::kept::Kept;
use crate::reflection::Lobes;
use crate::reflection::math::{fresnel_mix, mirrored, schlick};
use crate::{Changed, Cpu, Estimator, EstimatorError, Inputs, Prepared, Quantity, Records};
use glam::{DVec3, Vec3};
use interreflect_cpu::lane::{Lane, Vector};
use interreflect_cpu::tiles::{CpuCx, PointLanes, TileKernel};
use interreflect_scene::{CubeImage, Estimate, PointLayout};
use pyramid::{BoxWeights, Pyramid};

/// The tables, the coefficients and the pyramid, kept across frames.
#[derive(Default)]
pub struct State {
    tables: Kept<ShMipEnvmapParams, Tables>,
    boxes: Kept<ShMipEnvmapParams, BoxWeights>,
    lobes: Lobes,
    irradiance: Option<Harmonics>,
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
    fn project(params: &ShMipEnvmapParams, tables: &Tables, captured: &CubeImage) -> Self {
        let means: Vec<Vec3> = averaged(captured, &tables.omegas_sr, params.sh_size()).collect();
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

impl Prepared<Cpu> for State {
    fn records(&self, _caps: &()) -> Result<Vec<Records>, EstimatorError> {
        let padded = |rgb: &Vec3| rgb.extend(0.0).to_array();
        let of = |name, values: &[Vec3]| {
            Records::host(name, &values.iter().map(padded).collect::<Vec<_>>())
        };
        let harmonics = self.irradiance.iter().map(|h| of("coefficients", &h.0));
        let pyramid = self.pyramid.iter().map(|p| of("pyramid", p.texels()));
        Ok(harmonics.chain(pyramid).collect())
    }
}

impl Estimator<Cpu> for ShMipEnvmap {
    type State = State;

    fn prepare(
        params: &ShMipEnvmapParams,
        state: &mut State,
        _cx: &mut &CpuCx,
        quantity: Quantity,
        inputs: &Inputs<'_, Cpu>,
        _out: &Estimate,
    ) -> Result<(), EstimatorError> {
        let lobes = state.lobes.needed(quantity, inputs);
        if lobes {
            check_levels(params, inputs)?;
        }
        let stale = inputs.changed.any(Changed::PARAMS | Changed::CAPTURES);
        if stale || state.irradiance.is_none() {
            let captured = inputs.cube(&params.captured())?;
            let tables = state.tables.tables(params, || {
                Ok(Tables {
                    omegas_sr: face_solid_angles_sr(captured.size),
                    weights: harmonic_weights(params),
                })
            })?;
            state.irradiance = Some(Harmonics::project(params, tables, captured));
        }
        if !lobes {
            state.pyramid = None;
        } else if stale || state.pyramid.is_none() {
            let captured = inputs.cube(&params.captured())?;
            let boxes = state.boxes.tables(params, || Ok(BoxWeights::new(params)))?;
            state.pyramid = Some(Pyramid::new(params, boxes, captured));
        }
        Ok(())
    }

    fn shade(
        params: &ShMipEnvmapParams,
        state: &mut State,
        cx: &mut &CpuCx,
        quantity: Quantity,
        inputs: &Inputs<'_, Cpu>,
        out: &mut Estimate,
    ) -> Result<(), EstimatorError> {
        let found = state.irradiance.as_ref();
        let irradiance = found.ok_or(EstimatorError::Unprepared)?;
        let glossy = Glossy {
            params,
            irradiance,
            pyramid: state.pyramid.as_ref(),
        };
        match quantity {
            Quantity::GlossyRadiance => cx.for_each_tile(inputs.points, out, &glossy),
            _ => cx.for_each_tile(inputs.points, out, irradiance),
        }
        Ok(())
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
    params: &'a ShMipEnvmapParams,
    irradiance: &'a Harmonics,
    pyramid: Option<&'a Pyramid>,
}

impl Glossy<'_> {
    #[inline(always)]
    fn level<L: Lane>(&self, footprint: L) -> L {
        let top = self.params.top_level() as f32;
        match self.params.lod_mode {
            LodMode::Absolute => L::from(self.params.lod.clamp(0.0, top)),
            LodMode::Bias => {
                let base = self.params.base_size() as f32;
                biased_level(footprint, base.into(), self.params.lod.into(), top.into())
            }
        }
    }
}

impl TileKernel for Glossy<'_> {
    #[inline(always)]
    fn shade<L: Lane>(&self, points: &PointLanes<'_, L>) -> [L; 3] {
        let n = points.vector(PointLayout::NORMAL);
        let v = points.vector(PointLayout::VIEW);
        let fresnel = schlick(self.params.f_lambda.into(), n.dot(v));
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
