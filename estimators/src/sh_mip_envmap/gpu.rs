//! Spherical harmonics and mip pyramid on the GPU.

mod pyramid;

use super::math::HARMONICS;
use super::tables::harmonic_weights;
use super::{LodMode, ShMipEnvmap};
use crate::averaging::{AVERAGE, Target, face_solid_angles_sr, record_average};
use crate::reflection::{self, Lobes};
use crate::{Changed, Estimator, EstimatorError, Frame, Gpu, Kernels, Quantity, Records};
use interreflect_gpu::{Binding, GpuContext, Kernel, Shader, wgsl};
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

/// The coefficients and the pyramid, with the kernels that fill them.
pub struct Filtered {
    harmonics: Harmonics,
    /// Made when a point first had a lobe; what it holds is of the captures if `filled`.
    pyramid: Option<Pyramid>,
    filled: bool,
    lobes: Lobes,
    shade: Kernel,
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
    fn new(method: &ShMipEnvmap, context: &GpuContext) -> Result<Self, EstimatorError> {
        let omegas_sr = face_solid_angles_sr(method.captured().size);
        let texels = CUBE_FACES as u64 * u64::from(method.sh_size()).pow(2);
        let radiances = context.storage_zeroed("sh_mip_envmap radiances", 16 * texels)?;
        let weights = context.storage("sh_mip_envmap weights", &harmonic_weights(method))?;
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
        method: &ShMipEnvmap,
        frame: &mut Frame<'_, Gpu>,
    ) -> Result<(), EstimatorError> {
        let target = Target {
            buffer: &self.radiances,
            resolution: method.sh_size(),
            border: 0,
        };
        record_average(frame, &method.captured(), &self.omegas_sr, &target)?;
        self.project.record(frame.cx, [HARMONICS as u32, 1, 1]);
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
    fn new(method: &ShMipEnvmap) -> Self {
        Self {
            base: method.base_size(),
            top: method.top_level(),
            lod: method.lod,
            bias: u32::from(method.lod_mode == LodMode::Bias),
            f_lambda: method.f_lambda,
        }
    }
}

impl Estimator<Gpu> for ShMipEnvmap {
    type Prepared = Filtered;

    const SHADERS: &'static [Shader] = &[AVERAGE, PROJECT, PYRAMID, SHADE];

    fn prepare(
        &self,
        frame: &mut Frame<'_, Gpu>,
        last: Option<Filtered>,
    ) -> Result<Filtered, EstimatorError> {
        let context = frame.context().clone();
        let stale = frame.changed.any(Changed::PARAMS | Changed::CAPTURES);
        let (harmonics, pyramid, filled, mut lobes) = match last {
            Some(last) => (
                Some(last.harmonics),
                last.pyramid,
                last.filled && !stale,
                last.lobes,
            ),
            None => (None, None, false, Lobes::default()),
        };
        let shines = lobes.needed(frame);
        if shines {
            self.check_levels(frame)?;
        }
        let projected = harmonics.is_some() && !stale;
        let harmonics = match harmonics {
            Some(harmonics) => harmonics,
            None => Harmonics::new(self, &context)?,
        };
        if !projected {
            harmonics.record(self, frame)?;
        }
        let (pyramid, filled) = match (shines, pyramid) {
            (false, pyramid) => (pyramid, filled),
            (true, pyramid) => {
                let pyramid = match pyramid {
                    Some(pyramid) => pyramid,
                    None => Pyramid::new(self, &context)?,
                };
                if !filled {
                    pyramid.record(self, frame)?;
                }
                (Some(pyramid), true)
            }
        };
        let texels = pyramid.as_ref().filter(|_| shines);
        let texels = texels.map_or(Binding::None, |p| Binding::Buffer(&p.texels));
        let uniform = context.uniform("sh_mip_envmap shade", &Shade::new(self))?;
        let [points, info, estimate] = frame.point_bindings();
        let coefficients = (&harmonics.coefficients).into();
        let bindings = [
            points,
            info,
            estimate,
            (&uniform).into(),
            coefficients,
            texels,
        ];
        let entry = match frame.quantity {
            Quantity::GlossyRadiance if shines => "glossy",
            Quantity::GlossyRadiance => "matte",
            _ => "irradiance",
        };
        let shade = context.kernel(&SHADE, entry, &bindings)?;
        Ok(Filtered {
            harmonics,
            pyramid,
            filled,
            lobes,
            shade,
        })
    }
}

impl Kernels for Filtered {
    fn kernels(&self) -> &[Kernel] {
        std::slice::from_ref(&self.shade)
    }

    fn records(&self, context: &GpuContext) -> Result<Vec<Records>, EstimatorError> {
        let pyramid = self.pyramid.as_ref().filter(|_| self.filled);
        let pyramid = pyramid.map(|p| ("pyramid", &p.texels));
        let buffers = std::iter::once(("coefficients", &self.harmonics.coefficients));
        let read = |(name, buffer)| Records::device::<[f32; 4]>(name, context, buffer);
        buffers.chain(pyramid).map(read).collect()
    }
}

#[cfg(test)]
#[path = "tests.rs"]
mod tests;
