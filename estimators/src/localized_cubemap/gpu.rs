//! Localized cube maps on the GPU.

use super::tables::Tables;
use super::{LocalizedCubemap, Reflectivity};
use crate::lobes::{MAX_LOBES, lobes};
use crate::texels::gpu::{AVERAGE, GpuTables, STORAGE, UNIFORM, gather_kernel, gather_parts};
use crate::{Estimator, EstimatorError, Frame, Gpu, Kernels, Records};
use interreflect_gpu::{GpuContext, Kernel, Shader};
use interreflect_scene::params::Fidelity;

const LEAVES: &str = include_str!("math.wgsl");
const LIGHT: &str = include_str!("light.wgsl");

const SHADE: [Shader; 2] = [
    Shader {
        label: "localized_cubemap shade, uniform texels",
        parts: &gather_parts(LEAVES, LIGHT, UNIFORM),
    },
    Shader {
        label: "localized_cubemap shade, stored texels",
        parts: &gather_parts(LEAVES, LIGHT, STORAGE),
    },
];

/// The texels, what averaging reads, the reflectivity's tables and the kernel.
pub struct Lights {
    averaging: GpuTables,
    texels: wgpu::Buffer,
    reflectivity: GpuReflectivity,
    shade: Kernel,
}

/// The reflectivity's tables; empty where it is sampled.
struct GpuReflectivity {
    exponents: Vec<f32>,
    lobes: wgpu::Buffer,
    tables: wgpu::Buffer,
}

/// As `Lobes` in light.wgsl.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Lobes {
    shininess: [f32; MAX_LOBES],
    count: u32,
    pad: [u32; 3],
}

impl GpuReflectivity {
    fn new(context: &GpuContext, tables: Tables) -> Result<Self, EstimatorError> {
        let mut lobes = Lobes {
            shininess: [0.0; MAX_LOBES],
            count: tables.lobes.len() as u32,
            pad: [0; 3],
        };
        lobes.shininess[..tables.lobes.len()].copy_from_slice(&tables.lobes);
        Ok(Self {
            exponents: tables.lobes,
            lobes: context.uniform("localized_cubemap lobes", &lobes)?,
            tables: context.storage("localized_cubemap reflectivity", &tables.values)?,
        })
    }
}

impl Estimator<Gpu> for LocalizedCubemap {
    type Prepared = Lights;

    const SHADERS: &'static [Shader] = &[AVERAGE, SHADE[0], SHADE[1]];

    fn prepare(
        &self,
        frame: &mut Frame<'_, Gpu>,
        last: Option<Lights>,
    ) -> Result<Lights, EstimatorError> {
        let (averaging, texels, reflectivity) = match last {
            Some(last) => (
                last.averaging,
                frame.unless_stale(Some(last.texels)),
                Some(last.reflectivity),
            ),
            None => {
                let averaging = GpuTables::new(frame.context(), &self.averaging())?;
                (averaging, None, None)
            }
        };
        let texels = match texels {
            Some(texels) => texels,
            None => averaging.average(frame.cx, frame.cube(&self.captured(&frame.scene))?)?,
        };
        let reflectivity = self.reflectivity_for(frame, reflectivity)?;
        let constants = [
            ("corrected", self.fidelity == Fidelity::Corrected),
            ("averaged", self.reflectivity == Reflectivity::Table),
        ];
        let shade = gather_kernel(
            frame,
            &SHADE,
            &constants.map(|(name, on)| (name, f64::from(u8::from(on)))),
            (&texels, averaging.count()),
            &[(&reflectivity.lobes).into(), (&reflectivity.tables).into()],
        )?;
        Ok(Lights {
            averaging,
            texels,
            reflectivity,
            shade,
        })
    }
}

impl LocalizedCubemap {
    /// The reflectivity's tables: those of the last `prepare` where they still hold.
    fn reflectivity_for(
        &self,
        frame: &Frame<'_, Gpu>,
        last: Option<GpuReflectivity>,
    ) -> Result<GpuReflectivity, EstimatorError> {
        let exponents = match self.reflectivity {
            Reflectivity::Sample => Vec::new(),
            Reflectivity::Table => {
                let known = last.as_ref().map(|last| last.exponents.clone());
                lobes(frame, known, |n| n)?
            }
        };
        match (last, self.reflectivity) {
            (Some(last), _) if last.exponents == exponents => Ok(last),
            (_, Reflectivity::Sample) => GpuReflectivity::new(frame.context(), Tables::default()),
            (_, Reflectivity::Table) => {
                GpuReflectivity::new(frame.context(), Tables::new(exponents))
            }
        }
    }
}

impl Kernels for Lights {
    fn kernels(&self) -> &[Kernel] {
        std::slice::from_ref(&self.shade)
    }

    fn records(&self, context: &GpuContext) -> Result<Vec<Records>, EstimatorError> {
        Ok(vec![self.averaging.records(context, &self.texels)?])
    }
}

#[cfg(test)]
#[path = "tests.rs"]
mod tests;
