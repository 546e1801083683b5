//! Spherical harmonics and mip pyramid on the GPU.

mod pyramid;

use super::math::HARMONICS;
use super::tables::harmonic_weights;
use super::{LodMode, ShMipEnvmap, ShMipEnvmapParams, check_levels};
use crate::averaging::{AVERAGE, Target, face_solid_angles_sr, record_average};
use crate::kept::Kept;
use crate::reflection::{self, Lobes};
use crate::{Changed, Estimator, EstimatorError, Gpu, Inputs, Prepared, Quantity, Records};
use interreflect_gpu::{Binding, GpuContext, GpuCx, GpuEstimate, Kernel, Shader, wgsl};
use interreflect_scene::conventions::CUBE_FACES;
use pyramid::{PYRAMID, Pyramid};

/// Twins of math.rs.
const LEAVES: &str = include_str!("math.wgsl");

const PROJECT: Shader = Shader {
    label: "sh_mip_envmap projection",
    parts: &[include_str!("project.wgsl")],
};

const SHADE: Shader = Shader {
    label: "sh_mip_envmap shade",
    parts: &[
        wgsl::MATH,
        wgsl::CUBE,
        wgsl::POINTS,
        LEAVES,
        reflection::LEAVES,
        include_str!("shade.wgsl"),
    ],
};

/// The buffers with their kernels, kept across frames.
#[derive(Default)]
pub struct State {
    harmonics: Kept<ShMipEnvmapParams, Harmonics>,
    pyramid: Kept<ShMipEnvmapParams, Pyramid>,
    lobes: Lobes,
    /// What the buffers hold: coefficients, and a pyramid.
    built: Built,
    shade: Option<Kernel>,
}

#[derive(Clone, Copy, Default)]
struct Built {
    harmonics: bool,
    pyramid: bool,
}

/// Coefficients of the irradiance, and what they are projected from.
struct Harmonics {
    /// Solid angles in sr of a face's captured texels.
    omegas_sr: wgpu::Buffer,
    /// The averaged cube.
    radiances: wgpu::Buffer,
    coefficients: wgpu::Buffer,
    project: Kernel,
}

impl Harmonics {
    fn new(params: &ShMipEnvmapParams, context: &GpuContext) -> Result<Self, EstimatorError> {
        let omegas_sr = face_solid_angles_sr(params.captured().size);
        let texels = CUBE_FACES as u64 * u64::from(params.sh_size()).pow(2);
        let radiances = context.storage_zeroed("sh_mip_envmap radiances", 16 * texels)?;
        let weights = context.storage("sh_mip_envmap weights", &harmonic_weights(params))?;
        let coefficients =
            context.storage_zeroed("sh_mip_envmap coefficients", 16 * HARMONICS as u64)?;
        let bindings = [
            (&radiances).into(),
            (&weights).into(),
            (&coefficients).into(),
        ];
        Ok(Self {
            omegas_sr: context.storage("captured solid angles", &omegas_sr)?,
            project: context.kernel(&PROJECT, "project", &bindings)?,
            radiances,
            coefficients,
        })
    }

    /// Records averaging and projection of the capture.
    fn record(
        &self,
        params: &ShMipEnvmapParams,
        cx: &mut GpuCx,
        inputs: &Inputs<'_, Gpu>,
    ) -> Result<(), EstimatorError> {
        let target = Target {
            buffer: &self.radiances,
            resolution: params.sh_size(),
            border: 0,
        };
        record_average(cx, inputs, &params.captured(), &self.omegas_sr, &target)?;
        self.project.record(cx, [HARMONICS as u32, 1, 1]);
        Ok(())
    }
}

/// As `Shade` in shade.wgsl.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Shade {
    base: u32,
    top: u32,
    lod: f32,
    bias: u32,
    f_lambda: f32,
}

impl Shade {
    fn new(params: &ShMipEnvmapParams) -> Self {
        Self {
            base: params.base_size(),
            top: params.top_level(),
            lod: params.lod,
            bias: u32::from(params.lod_mode == LodMode::Bias),
            f_lambda: params.f_lambda,
        }
    }
}

impl Prepared<Gpu> for State {
    fn records(&self, context: &GpuContext) -> Result<Vec<Records>, EstimatorError> {
        let harmonics = self.harmonics.made().filter(|_| self.built.harmonics);
        let pyramid = self.pyramid.made().filter(|_| self.built.pyramid);
        let harmonics = harmonics.map(|h| ("coefficients", &h.coefficients));
        let pyramid = pyramid.map(|p| ("pyramid", &p.texels));
        let read = |(name, buffer)| Records::device::<[f32; 4]>(name, context, buffer);
        harmonics.into_iter().chain(pyramid).map(read).collect()
    }
}

impl Estimator<Gpu> for ShMipEnvmap {
    type State = State;

    const SHADERS: &'static [Shader] = &[AVERAGE, PROJECT, PYRAMID, SHADE];

    fn prepare(
        params: &ShMipEnvmapParams,
        state: &mut State,
        cx: &mut GpuCx,
        quantity: Quantity,
        inputs: &Inputs<'_, Gpu>,
        out: &GpuEstimate,
    ) -> Result<(), EstimatorError> {
        let context = cx.context().clone();
        let lobes = state.lobes.needed(quantity, inputs);
        if lobes {
            check_levels(params, inputs)?;
        }
        if inputs.changed.any(Changed::PARAMS | Changed::CAPTURES) {
            state.built = Built::default();
        }
        let make = || Harmonics::new(params, &context);
        let harmonics = state.harmonics.tables(params, make)?;
        if !state.built.harmonics {
            harmonics.record(params, cx, inputs)?;
            state.built.harmonics = true;
        }
        let mut texels = Binding::None;
        if lobes {
            let make = || Pyramid::new(params, &context);
            let pyramid = state.pyramid.tables(params, make)?;
            if !state.built.pyramid {
                pyramid.record(params, cx, inputs)?;
                state.built.pyramid = true;
            }
            texels = Binding::Buffer(&pyramid.texels);
        }
        let uniform = context.uniform("sh_mip_envmap shade", &Shade::new(params))?;
        let [points, info, estimate] = inputs.points.bindings(out);
        let coefficients = (&harmonics.coefficients).into();
        let bindings = [
            points,
            info,
            estimate,
            (&uniform).into(),
            coefficients,
            texels,
        ];
        let entry = match quantity {
            Quantity::GlossyRadiance if lobes => "glossy",
            Quantity::GlossyRadiance => "matte",
            _ => "irradiance",
        };
        state.shade = Some(context.kernel(&SHADE, entry, &bindings)?);
        Ok(())
    }

    fn shade(
        _params: &ShMipEnvmapParams,
        state: &mut State,
        cx: &mut GpuCx,
        _quantity: Quantity,
        inputs: &Inputs<'_, Gpu>,
        _out: &mut GpuEstimate,
    ) -> Result<(), EstimatorError> {
        let shade = state.shade.as_ref().ok_or(EstimatorError::Unprepared)?;
        shade.record(cx, inputs.points.workgroups());
        Ok(())
    }
}

#[cfg(test)]
#[path = "tests.rs"]
mod tests;
