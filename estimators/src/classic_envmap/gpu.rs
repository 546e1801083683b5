//! Classic environment mapping on the GPU.

use super::map::directions;
use super::math::{map_nodes, node_direction};
use super::{ClassicEnvmap, ClassicEnvmapParams, MAX_LOBES, lobe_exponents};
use crate::averaging::face_solid_angles_sr;
use crate::{Changed, Estimator, EstimatorError, Gpu, Inputs, LOBE_POWER, Quantity};
use interreflect_gpu::{GpuCx, GpuEstimate, Kernel, Shader, wgsl};

const LEAVES: &str = include_str!("math.wgsl");
const SOURCE: &str = include_str!("source.wgsl");

const AVERAGE: Shader = Shader {
    label: "classic_envmap average",
    parts: &[wgsl::CUBE, SOURCE, include_str!("average.wgsl")],
};

const CONVOLVE: Shader = Shader {
    label: "classic_envmap convolve",
    parts: &[
        wgsl::CUBE,
        LOBE_POWER,
        LEAVES,
        SOURCE,
        include_str!("convolve.wgsl"),
    ],
};

const SHADE: Shader = Shader {
    label: "classic_envmap shade",
    parts: &[
        wgsl::MATH,
        wgsl::CUBE,
        wgsl::POINTS,
        LOBE_POWER,
        LEAVES,
        include_str!("shade.wgsl"),
    ],
};

/// The convolved maps and the kernel that looks them up, kept across frames.
#[derive(Default)]
pub struct State {
    maps: Option<wgpu::Buffer>,
    exponents: Vec<f32>,
    shade: Option<Kernel>,
}

/// As `Average` in average.wgsl.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Average {
    resolution: u32,
    size: u32,
}

/// As `Convolve` in convolve.wgsl.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Convolve {
    nodes: u32,
    sources: u32,
    first: u32,
    exponent: f32,
}

/// As `Shade` in shade.wgsl.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Shade {
    cells: u32,
    lobes: u32,
    pad: [u32; 2],
    exponents: [f32; MAX_LOBES],
}

impl Estimator<Gpu> for ClassicEnvmap {
    type State = State;

    const SHADERS: &'static [Shader] = &[AVERAGE, CONVOLVE, SHADE];

    fn prepare(
        params: &ClassicEnvmapParams,
        state: &mut State,
        cx: &mut GpuCx,
        quantity: Quantity,
        inputs: &Inputs<'_, Gpu>,
        out: &GpuEstimate,
    ) -> Result<(), EstimatorError> {
        let glossy = quantity == Quantity::GlossyRadiance;
        let exponents = match glossy {
            true => lobe_exponents(inputs)?,
            false => Vec::new(),
        };
        let stale = inputs.changed.any(Changed::PARAMS | Changed::CAPTURES);
        if stale || state.maps.is_none() || exponents != state.exponents {
            state.maps = Some(convolve(params, cx, inputs, &exponents)?);
            state.exponents = exponents;
        }
        let maps = state.maps.as_ref().ok_or(EstimatorError::Unprepared)?;
        let mut shade = Shade {
            cells: params.map_resolution,
            lobes: state.exponents.len() as u32,
            pad: [0; 2],
            exponents: [0.0; MAX_LOBES],
        };
        shade.exponents[..state.exponents.len()].copy_from_slice(&state.exponents);
        let shade = cx.context().uniform("classic_envmap shade", &shade)?;
        let [points, info, estimate] = inputs.points.bindings(out);
        let bindings = [points, info, estimate, (&shade).into(), maps.into()];
        let entry = if glossy { "glossy" } else { "irradiance" };
        state.shade = Some(cx.context().kernel(&SHADE, entry, &bindings)?);
        Ok(())
    }

    fn shade(
        _params: &ClassicEnvmapParams,
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

/// Records the averaging and the convolutions; returns the buffer of maps that they fill: the
/// irradiance, then one map for each exponent.
fn convolve(
    params: &ClassicEnvmapParams,
    cx: &mut GpuCx,
    inputs: &Inputs<'_, Gpu>,
    exponents: &[f32],
) -> Result<wgpu::Buffer, EstimatorError> {
    let captured = inputs.cube(&params.captured())?;
    let size = captured.spec().size;
    let missing = || EstimatorError::Missing("the radiance of the captured cube".into());
    let radiance = captured.radiance_distance().ok_or_else(missing)?;
    let context = cx.context().clone();
    let resolution = params.resolution;
    let texels = directions(resolution);
    let sources = context.storage("classic_envmap sources", &texels)?;
    let average = context.uniform("classic_envmap average", &Average { resolution, size })?;
    let omegas_sr = context.storage("captured solid angles", &face_solid_angles_sr(size))?;
    context
        .kernel(
            &AVERAGE,
            "average_radiance",
            &[
                (&average).into(),
                (&sources).into(),
                radiance.into(),
                (&omegas_sr).into(),
            ],
        )?
        .record(cx, [(texels.len() as u32).div_ceil(64), 1, 1]);

    let cells = params.map_resolution;
    let nodes = map_nodes(cells);
    let directions: Vec<[f32; 4]> = (0..nodes)
        .map(|i| node_direction(cells, i).extend(0.0).to_array())
        .collect();
    let directions = context.storage("classic_envmap directions", &directions)?;
    let maps = (1 + exponents.len()) * nodes;
    let maps = context.storage_zeroed("classic_envmap maps", (maps * 16) as u64)?;
    let lobes = exponents.iter().map(|&e| ("convolve_phong", e));
    for (i, (entry, exponent)) in [("convolve_cosine", 0.0)]
        .into_iter()
        .chain(lobes)
        .enumerate()
    {
        let uniform = Convolve {
            nodes: nodes as u32,
            sources: texels.len() as u32,
            first: (i * nodes) as u32,
            exponent,
        };
        let uniform = context.uniform("classic_envmap convolve", &uniform)?;
        let bindings = [
            (&uniform).into(),
            (&sources).into(),
            (&directions).into(),
            (&maps).into(),
        ];
        let kernel = context.kernel(&CONVOLVE, entry, &bindings)?;
        kernel.record(cx, [(nodes as u32).div_ceil(64), 1, 1]);
    }
    Ok(maps)
}

#[cfg(test)]
#[path = "tests.rs"]
mod tests;
