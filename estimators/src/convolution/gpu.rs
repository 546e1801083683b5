//! Convolutions on the GPU: one invocation a node.

use super::Sizes;
use super::math::{map_nodes, node_direction};
use super::sources::vectors_sr;
use crate::averaging::{AVERAGE, Target, face_solid_angles_sr, record_average};
use crate::{EstimatorError, Frame, Gpu, LOBE_POWER, Records};
use interreflect_gpu::{GpuContext, GpuCx, Shader, wgsl};

/// Twins of math.rs; needs [`wgsl::CUBE`] and [`LOBE_POWER`].
pub const LEAVES: &str = include_str!("math.wgsl");

/// `map_lookup` in the maps of slot 4; needs [`LEAVES`].
pub const LOOKUP: &str = include_str!("lookup.wgsl");

const CONVOLVE: Shader = Shader {
    label: "convolution",
    parts: &[
        wgsl::CUBE,
        LOBE_POWER,
        LEAVES,
        include_str!("convolve.wgsl"),
    ],
};

/// The shaders that a convolution runs.
pub const SHADERS: [Shader; 2] = [AVERAGE, CONVOLVE];

/// The convolved maps with their tables.
pub struct Convolved {
    tables: Tables,
    maps: wgpu::Buffer,
    exponents: Vec<f32>,
}

/// What a convolution reads and where it is evaluated.
struct Tables {
    /// Solid angles in sr of a face's captured texels.
    omegas_sr: wgpu::Buffer,
    /// Vector solid angles in sr of the texels to sum over.
    vectors: wgpu::Buffer,
    /// Their radiance, which each averaging writes anew.
    radiances: wgpu::Buffer,
    source_count: u32,
    /// Directions of a map's nodes.
    directions: wgpu::Buffer,
}

impl Tables {
    fn new(sizes: &Sizes, context: &GpuContext) -> Result<Self, EstimatorError> {
        let omegas_sr = face_solid_angles_sr(sizes.captured.size);
        let vectors: Vec<[f32; 4]> = vectors_sr(sizes.resolution)
            .map(|vector| vector.extend(0.0).to_array())
            .collect();
        let directions: Vec<[f32; 4]> = (0..map_nodes(sizes.cells))
            .map(|i| node_direction(sizes.cells, i).extend(0.0).to_array())
            .collect();
        let bytes = size_of_val(&*vectors) as u64;
        Ok(Self {
            omegas_sr: context.storage("captured solid angles", &omegas_sr)?,
            source_count: vectors.len() as u32,
            vectors: context.storage("vector solid angles", &vectors)?,
            radiances: context.storage_zeroed("averaged radiances", bytes)?,
            directions: context.storage("directions of nodes", &directions)?,
        })
    }
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

impl Convolved {
    /// The Phong exponents that there are maps for.
    pub fn exponents(&self) -> Vec<f32> {
        self.exponents.clone()
    }

    /// All maps, the irradiance first.
    pub fn records(&self, context: &GpuContext) -> Result<Vec<Records>, EstimatorError> {
        let maps = Records::device::<[f32; 4]>("maps", context, &self.maps)?;
        Ok(vec![maps])
    }

    /// The buffer of the maps, the irradiance first.
    pub fn maps(&self) -> &wgpu::Buffer {
        &self.maps
    }

    /// Records the convolution of the declared capture with the cosine and with a Phong lobe of
    /// each exponent; what the last frame had is kept where nothing has changed.
    pub fn new(
        sizes: &Sizes,
        frame: &mut Frame<'_, Gpu>,
        exponents: Vec<f32>,
        last: Option<Self>,
    ) -> Result<Self, EstimatorError> {
        let tables = match last {
            Some(last) => {
                let holds = frame.unless_stale(Some(())).is_some();
                if holds && last.exponents == exponents {
                    return Ok(last);
                }
                last.tables
            }
            None => Tables::new(sizes, frame.context())?,
        };
        let target = Target {
            buffer: &tables.radiances,
            resolution: sizes.resolution,
            border: 0,
        };
        record_average(frame, &sizes.captured, &tables.omegas_sr, &target)?;
        let maps = convolve(sizes, frame.cx, &tables, &exponents)?;
        Ok(Self {
            tables,
            maps,
            exponents,
        })
    }
}

/// Records the convolutions; returns the buffer of maps that they fill: the irradiance, then one
/// map for each exponent.
fn convolve(
    sizes: &Sizes,
    cx: &mut GpuCx,
    tables: &Tables,
    exponents: &[f32],
) -> Result<wgpu::Buffer, EstimatorError> {
    let context = cx.context().clone();
    let nodes = map_nodes(sizes.cells);
    let maps = (1 + exponents.len()) * nodes;
    let maps = context.storage_zeroed("convolved maps", (maps * 16) as u64)?;
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
        let uniform = context.uniform("convolution", &uniform)?;
        let bindings = [
            (&uniform).into(),
            (&tables.vectors).into(),
            (&tables.radiances).into(),
            (&tables.directions).into(),
            (&maps).into(),
        ];
        let kernel = context.kernel(&CONVOLVE, entry, &bindings)?;
        kernel.record(cx, [(nodes as u32).div_ceil(64), 1, 1]);
    }
    Ok(maps)
}

#[cfg(test)]
mod tests {
    use super::*;
    use interreflect_gpu::layout::assert_layout;

    #[test]
    fn structs_have_the_same_layout() {
        assert_layout!(CONVOLVE, Convolve, [nodes, sources, first, exponent]);
    }
}
