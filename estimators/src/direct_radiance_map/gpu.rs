//! Direct radiance maps on the GPU.

use super::samples::{Highlight, Photon, samples};
use super::{DirectRadianceMap, Formula};
use crate::texels::gpu::LEAVES as TEXEL_LEAVES;
use crate::{Estimator, EstimatorError, Frame, Gpu, Kernels, LOBE_POWER, Quantity, Records};
use bytemuck::{Pod, Zeroable};
use interreflect_gpu::{GpuContext, GpuCx, GpuRsm, Kernel, Shader, wgsl};

const LEAVES: &str = include_str!("math.wgsl");
const PHOTON: &str = include_str!("photon.wgsl");

const PHOTONS: Shader = Shader {
    label: "direct_radiance_map photons",
    parts: &[
        wgsl::MATH,
        wgsl::TRUE_COLORS,
        LOBE_POWER,
        TEXEL_LEAVES,
        LEAVES,
        PHOTON,
        include_str!("photons.wgsl"),
    ],
};

const fn shade_parts(photons: &'static str) -> [&'static str; 8] {
    [
        wgsl::MATH,
        wgsl::POINTS,
        LOBE_POWER,
        TEXEL_LEAVES,
        LEAVES,
        PHOTON,
        photons,
        include_str!("shade.wgsl"),
    ]
}

const SHADE: [Shader; 2] = [
    Shader {
        label: "direct_radiance_map shade, uniform photons",
        parts: &shade_parts(include_str!("photons_uniform.wgsl")),
    },
    Shader {
        label: "direct_radiance_map shade, stored photons",
        parts: &shade_parts(include_str!("photons_storage.wgsl")),
    },
];

/// Photons that the uniform buffer of photons_uniform.wgsl holds: 48 KiB of the 64 that WebGPU
/// guarantees.
pub(super) const UNIFORM_PHOTONS: usize = 1024;

/// Photons that one dispatch sums: lavapipe ends the loops of an invocation after 65,535 turns.
const PART: u32 = 1 << 15;

/// The photons and the kernels of the parts of their sum.
pub struct Photons {
    made: GpuPhotons,
    shade: Vec<Kernel>,
}

struct GpuPhotons {
    photons: wgpu::Buffer,
    highlights: wgpu::Buffer,
    count: u32,
}

/// As `Gather` in photons.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub(super) struct Gather {
    pub(super) samples: u32,
    pub(super) per_side: u32,
    pub(super) size: u32,
    pub(super) diagonal2: f32,
}

/// As `Shade` in shade.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub(super) struct Shade {
    pub(super) first: u32,
    pub(super) count: u32,
    pub(super) adds: u32,
    pub(super) pad: u32,
}

impl GpuPhotons {
    /// Records the making of photons.
    fn new(
        method: &DirectRadianceMap,
        cx: &mut GpuCx,
        views: &GpuRsm,
    ) -> Result<Self, EstimatorError> {
        let context = cx.context().clone();
        let samples = samples(method, views.frames());
        let count = samples.len() as u32;
        let gather = Gather {
            samples: count,
            per_side: method.samples_per_side,
            size: method.map_resolution,
            diagonal2: views.bounds().diagonal().powi(2),
        };
        let gather = context.uniform("direct_radiance_map photons", &gather)?;
        let places = context.storage("samples of RSMs", &samples)?;
        let shining = if method.shining() { samples.len() } else { 1 };
        let bytes = shining * size_of::<Highlight>();
        let made = Self {
            photons: photon_buffer(&context, samples.len())?,
            highlights: context.storage_zeroed("highlights", bytes as u64)?,
            count,
        };
        let bindings = [
            (&gather).into(),
            (&places).into(),
            views.position().into(),
            views.radiance().into(),
            views.normal().into(),
            views.true_colors().into(),
            (&made.photons).into(),
            (&made.highlights).into(),
        ];
        let extent_kind = match (method.formula(), method.shares_hemisphere()) {
            (_, true) => 0.0,
            (Formula::Constant, _) => 1.0,
            _ => 2.0,
        };
        let flag = |on: bool| f64::from(u8::from(on));
        let constants = [
            ("extent_kind", extent_kind),
            ("shining", flag(method.shining())),
            ("normals_known", flag(method.captured().channels.normal)),
        ];
        let per_view = method.samples_per_side.pow(2);
        let cells = [per_view, views.frames().len() as u32, 1];
        let (entry, workgroups) = match (method.mip, method.averages_cells()) {
            (_, true) => ("gather_cells", cells),
            (true, false) => ("gather_means", cells),
            (false, false) => ("gather_middles", [count.div_ceil(64), 1, 1]),
        };
        let kernel = context.kernel_with(&PHOTONS, entry, &constants, &bindings)?;
        kernel.record(cx, workgroups);
        Ok(made)
    }
}

impl Estimator<Gpu> for DirectRadianceMap {
    type Prepared = Photons;

    const SHADERS: &'static [Shader] = &[PHOTONS, SHADE[0], SHADE[1]];

    fn prepare(
        &self,
        frame: &mut Frame<'_, Gpu>,
        last: Option<Photons>,
    ) -> Result<Photons, EstimatorError> {
        let made = match frame.unless_stale(last) {
            Some(last) => last.made,
            None => {
                let views = frame.rsm(&self.captured())?;
                GpuPhotons::new(self, frame.cx, views)?
            }
        };
        let shade = self.sums(frame, &made)?;
        Ok(Photons { made, shade })
    }
}

impl DirectRadianceMap {
    /// The kernels of the parts of the sum over all photons.
    fn sums(
        &self,
        frame: &Frame<'_, Gpu>,
        photons: &GpuPhotons,
    ) -> Result<Vec<Kernel>, EstimatorError> {
        let entry = match frame.quantity {
            Quantity::GlossyRadiance => "glossy",
            _ => "irradiance",
        };
        let shining = f64::from(u8::from(self.shining()));
        let formula = match self.formula() {
            Formula::Constant => 0.0,
            Formula::Published => 1.0,
            Formula::Corrected => 2.0,
        };
        let context = frame.context();
        let shader = &SHADE[usize::from(photons.count as usize > UNIFORM_PHOTONS)];
        let [points, info, estimate] = frame.point_bindings();
        let parts = (0..photons.count).step_by(PART as usize);
        parts
            .map(|first| {
                let shade = Shade {
                    first,
                    count: PART.min(photons.count - first),
                    adds: u32::from(first > 0),
                    pad: 0,
                };
                let shade = context.uniform("direct_radiance_map shade", &shade)?;
                let bindings = [
                    points,
                    info,
                    estimate,
                    (&shade).into(),
                    (&photons.photons).into(),
                    (&photons.highlights).into(),
                ];
                let constants = [("formula", formula), ("shining", shining)];
                Ok(context.kernel_with(shader, entry, &constants, &bindings)?)
            })
            .collect()
    }
}

impl Kernels for Photons {
    fn kernels(&self) -> &[Kernel] {
        &self.shade
    }

    fn records(&self, context: &GpuContext) -> Result<Vec<Records>, EstimatorError> {
        let photons = Records::device::<Photon>("photons", context, &self.made.photons)?;
        let highlights =
            Records::device::<Highlight>("highlights", context, &self.made.highlights)?;
        // A sample that meets no surface is left as it was made.
        Ok([photons, highlights].map(Records::without_zeros).into())
    }
}

/// A buffer of photons that shaders write as storage and read as storage or, if short, as a uniform
/// array of its full length.
fn photon_buffer(context: &GpuContext, count: usize) -> Result<wgpu::Buffer, EstimatorError> {
    let descriptor = wgpu::BufferDescriptor {
        label: Some("photons"),
        size: (count.max(UNIFORM_PHOTONS) * size_of::<Photon>()) as u64,
        usage: wgpu::BufferUsages::STORAGE
            | wgpu::BufferUsages::UNIFORM
            | wgpu::BufferUsages::COPY_SRC,
        mapped_at_creation: false,
    };
    Ok(context.buffer(&descriptor)?)
}

#[cfg(test)]
mod tests {
    use super::super::samples::{Highlight, Photon, Sample};
    use super::*;
    use interreflect_gpu::layout::assert_layout;
    use interreflect_gpu::layout::{array_length, module};

    #[test]
    fn structs_have_the_same_layout() {
        assert_layout!(PHOTONS, Gather, [samples, per_side, size, diagonal2]);
        assert_layout!(PHOTONS, Sample, [texel, measure, half, share_sr]);
        assert_layout!(
            PHOTONS,
            Photon,
            [position, extent, radiance, pad, normal, shininess]
        );
        assert_layout!(PHOTONS, Highlight, [radiance, pad, to_light, pad_to_light]);
        assert_layout!(SHADE[0], Shade, [first, count, adds, pad]);
    }

    #[test]
    fn the_uniform_buffer_is_as_long_as_the_host_takes_it() {
        let length = array_length(&module(&SHADE[0]), "photons");
        assert_eq!(length, Some(UNIFORM_PHOTONS as u32));
    }
}
