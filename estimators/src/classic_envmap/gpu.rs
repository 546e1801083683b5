//! Classic environment mapping on the GPU.

use super::map::directions;
use super::math::{map_nodes, node_direction};
use super::{ClassicEnvmap, ClassicEnvmapParams, MAX_LOBES, lobe_exponents};
use crate::averaging::face_solid_angles_sr;
use crate::kept::Kept;
use crate::{Changed, Estimator, EstimatorError, Gpu, Inputs, LOBE_POWER, Quantity};
use interreflect_gpu::{GpuContext, GpuCx, GpuEstimate, Kernel, Shader, wgsl};

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

/// The tables, the convolved maps and the kernel that looks them up, kept across frames.
#[derive(Default)]
pub struct State {
    tables: Kept<ClassicEnvmapParams, Tables>,
    maps: Option<wgpu::Buffer>,
    exponents: Vec<f32>,
    shade: Option<Kernel>,
}

/// What a convolution reads and where it is evaluated.
struct Tables {
    /// Solid angles in sr of a face's captured texels.
    omegas_sr: wgpu::Buffer,
    /// The texels, whose radiance each averaging writes anew.
    sources: wgpu::Buffer,
    source_count: u32,
    /// Directions of a map's nodes.
    directions: wgpu::Buffer,
}

impl Tables {
    fn new(params: &ClassicEnvmapParams, context: &GpuContext) -> Result<Self, EstimatorError> {
        let cells = params.map_resolution;
        let omegas_sr = face_solid_angles_sr(params.captured().size);
        let sources = directions(params.resolution);
        let directions: Vec<[f32; 4]> = (0..map_nodes(cells))
            .map(|i| node_direction(cells, i).extend(0.0).to_array())
            .collect();
        Ok(Self {
            omegas_sr: context.storage("captured solid angles", &omegas_sr)?,
            source_count: sources.len() as u32,
            sources: context.storage("classic_envmap sources", &sources)?,
            directions: context.storage("classic_envmap directions", &directions)?,
        })
    }
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
        let exponents = lobe_exponents(quantity, inputs, state.exponents.clone())?;
        let stale = inputs.changed.any(Changed::PARAMS | Changed::CAPTURES);
        if stale || state.maps.is_none() || exponents != state.exponents {
            let make = || Tables::new(params, cx.context());
            let tables = state.tables.tables(params, make)?;
            average(params, cx, inputs, tables)?;
            state.maps = Some(convolve(params, cx, tables, &exponents)?);
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
        let entry = match quantity {
            Quantity::GlossyRadiance => "glossy",
            _ => "irradiance",
        };
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

/// Records the averaging of the capture down to the texels.
fn average(
    params: &ClassicEnvmapParams,
    cx: &mut GpuCx,
    inputs: &Inputs<'_, Gpu>,
    tables: &Tables,
) -> Result<(), EstimatorError> {
    let captured = inputs.cube(&params.captured())?;
    let missing = || EstimatorError::Missing("the radiance of the captured cube".into());
    let radiance = captured.radiance_distance().ok_or_else(missing)?;
    let average = Average {
        resolution: params.resolution,
        size: captured.spec().size,
    };
    let average = cx.context().uniform("classic_envmap average", &average)?;
    let bindings = [
        (&average).into(),
        (&tables.sources).into(),
        radiance.into(),
        (&tables.omegas_sr).into(),
    ];
    let kernel = cx
        .context()
        .kernel(&AVERAGE, "average_radiance", &bindings)?;
    kernel.record(cx, [tables.source_count.div_ceil(64), 1, 1]);
    Ok(())
}

/// Records the convolutions; returns the buffer of maps that they fill: the irradiance, then one
/// map for each exponent.
fn convolve(
    params: &ClassicEnvmapParams,
    cx: &mut GpuCx,
    tables: &Tables,
    exponents: &[f32],
) -> Result<wgpu::Buffer, EstimatorError> {
    let context = cx.context().clone();
    let nodes = map_nodes(params.map_resolution);
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
            sources: tables.source_count,
            first: (i * nodes) as u32,
            exponent,
        };
        let uniform = context.uniform("classic_envmap convolve", &uniform)?;
        let bindings = [
            (&uniform).into(),
            (&tables.sources).into(),
            (&tables.directions).into(),
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
