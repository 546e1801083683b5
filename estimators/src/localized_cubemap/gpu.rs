//! Localized cube maps on the GPU.

use super::tables::Tables;
use super::{LocalizedCubemap, LocalizedCubemapParams, Reflectivity};
use crate::kept::Kept;
use crate::lobes::{MAX_LOBES, lobes};
use crate::texels::gpu::{AVERAGE, GpuTables, STORAGE, UNIFORM, gather_kernel, gather_parts};
use crate::{Changed, Estimator, EstimatorError, Gpu, Inputs, Prepared, Quantity, Records};
use interreflect_gpu::{GpuContext, GpuCx, GpuEstimate, Kernel, Shader};
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

/// What averaging reads, the texels, the reflectivity's tables and the kernel, kept across frames.
#[derive(Default)]
pub struct State {
    averaging: Kept<LocalizedCubemapParams, GpuTables>,
    texels: Option<wgpu::Buffer>,
    reflectivity: Option<GpuReflectivity>,
    shade: Option<Kernel>,
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

impl Prepared<Gpu> for State {
    fn records(&self, context: &GpuContext) -> Result<Vec<Records>, EstimatorError> {
        let made = self.averaging.made().zip(self.texels.as_ref());
        let read = |(tables, texels): (&GpuTables, _)| tables.records(context, texels);
        made.into_iter().map(read).collect()
    }
}

impl Estimator<Gpu> for LocalizedCubemap {
    type State = State;

    const SHADERS: &'static [Shader] = &[AVERAGE, SHADE[0], SHADE[1]];

    fn prepare(
        params: &LocalizedCubemapParams,
        state: &mut State,
        cx: &mut GpuCx,
        quantity: Quantity,
        inputs: &Inputs<'_, Gpu>,
        out: &GpuEstimate,
    ) -> Result<(), EstimatorError> {
        let stale = inputs.changed.any(Changed::PARAMS | Changed::CAPTURES);
        let make = || GpuTables::new(cx.context(), &params.averaging());
        let averaging = state.averaging.tables(params, make)?;
        if stale || state.texels.is_none() {
            let captured = inputs.cube(&params.captured(&inputs.scene))?;
            state.texels = Some(averaging.average(cx, captured)?);
        }
        let context = cx.context();
        let texels = state.texels.as_ref().ok_or(EstimatorError::Unprepared)?;
        let reflectivity = reflectivity(
            params,
            context,
            state.reflectivity.take(),
            (quantity, inputs),
        )?;
        let reflectivity = state.reflectivity.insert(reflectivity);
        let constants = [
            ("corrected", params.fidelity == Fidelity::Corrected),
            ("averaged", params.reflectivity == Reflectivity::Table),
        ];
        state.shade = Some(gather_kernel(
            context,
            &SHADE,
            &constants.map(|(name, on)| (name, f64::from(u8::from(on)))),
            (texels, averaging.count()),
            (quantity, inputs, out),
            &[(&reflectivity.lobes).into(), (&reflectivity.tables).into()],
        )?);
        Ok(())
    }

    fn shade(
        _params: &LocalizedCubemapParams,
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

/// The reflectivity's tables, those of the last `prepare` where they still hold.
fn reflectivity(
    params: &LocalizedCubemapParams,
    context: &GpuContext,
    kept: Option<GpuReflectivity>,
    (quantity, inputs): (Quantity, &Inputs<'_, Gpu>),
) -> Result<GpuReflectivity, EstimatorError> {
    let exponents = match params.reflectivity {
        Reflectivity::Sample => Vec::new(),
        Reflectivity::Table => {
            let known = kept.as_ref().map(|k| k.exponents.clone());
            lobes(quantity, inputs, known, |n| n)?
        }
    };
    match (kept, params.reflectivity) {
        (Some(kept), _) if kept.exponents == exponents => Ok(kept),
        (_, Reflectivity::Sample) => GpuReflectivity::new(context, Tables::default()),
        (_, Reflectivity::Table) => GpuReflectivity::new(context, Tables::new(exponents)),
    }
}

#[cfg(test)]
#[path = "tests.rs"]
mod tests;
