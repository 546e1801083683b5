//! Texels on the GPU: one workgroup averages a texel, one invocation gathers at a point.

use super::Texel;
use super::average::{Averaging, Tables};
use crate::averaging::captured_radiance;
use crate::{EstimatorError, Frame, Gpu, LOBE_POWER, Quantity, Records};
use bytemuck::{Pod, Zeroable};
use interreflect_gpu::{Binding, Constants, GpuContext, GpuCube, GpuCx, Kernel, Shader, wgsl};
use interreflect_scene::conventions::CUBE_FACES;
use interreflect_scene::{CubeChannels, CubeSpec};

/// The surface along a ray of a capture.
pub const SURFACE: &str = include_str!("surface.wgsl");

/// The struct `Texel`.
pub const TEXEL: &str = include_str!("texel.wgsl");

/// Leaf functions of the sum.
pub const LEAVES: &str = include_str!("math.wgsl");

/// The entry points `irradiance` and `glossy`.
pub const GATHER: &str = include_str!("gather.wgsl");

/// The texels as a uniform array.
pub const UNIFORM: &str = include_str!("texels_uniform.wgsl");

/// The texels as a storage array.
pub const STORAGE: &str = include_str!("texels_storage.wgsl");

/// Texels that the uniform buffer of texels_uniform.wgsl holds: 48 KiB of the 64 that WebGPU
/// guarantees.
pub(super) const UNIFORM_TEXELS: usize = 1024;

/// Averages captures to texels.
pub const AVERAGE: Shader = Shader {
    label: "texels average",
    parts: &[wgsl::CUBE, TEXEL, SURFACE, include_str!("average.wgsl")],
};

/// The parts of a shader that gathers from `texels`: [`UNIFORM`] or [`STORAGE`]. `leaves` are the
/// method's formulas, `light` what it says of a texel to gather.wgsl.
pub const fn gather_parts(
    leaves: &'static str,
    light: &'static str,
    texels: &'static str,
) -> [&'static str; 9] {
    [
        wgsl::MATH,
        wgsl::POINTS,
        LOBE_POWER,
        LEAVES,
        leaves,
        TEXEL,
        texels,
        light,
        GATHER,
    ]
}

/// As `Average` in average.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub(super) struct Average {
    pub(super) m: u32,
    pub(super) size: u32,
    pub(super) place: u32,
    pub(super) pad: u32,
}

/// As `Gather` in gather.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub(super) struct Gather {
    pub(super) origin: [f32; 3],
    pub(super) count: u32,
}

/// Number in WGSL for the channels of place that a capture has.
pub fn place(channels: CubeChannels) -> u32 {
    u32::from(channels.distance) + u32::from(channels.distance && channels.normal)
}

/// [`Tables`] on the device.
pub struct GpuTables {
    resolution: u32,
    averaging: Averaging,
    omegas_sr: wgpu::Buffer,
    extents: wgpu::Buffer,
}

impl GpuTables {
    /// Uploads the tables.
    ///
    /// # Errors
    /// [`EstimatorError`] if the device refuses.
    pub fn new(context: &GpuContext, tables: &Tables) -> Result<Self, EstimatorError> {
        Ok(Self {
            resolution: tables.resolution,
            averaging: tables.averaging,
            omegas_sr: context.storage("captured solid angles", &tables.omegas_sr)?,
            extents: context.storage("texel extents", &tables.extents)?,
        })
    }

    /// Number of texels.
    pub fn count(&self) -> u32 {
        CUBE_FACES as u32 * self.resolution * self.resolution
    }

    /// The texels of a buffer that [`GpuTables::average`] returned, as the CPU has them.
    pub fn records(
        &self,
        context: &GpuContext,
        texels: &wgpu::Buffer,
    ) -> Result<Records, EstimatorError> {
        let records = Records::device::<Texel>("texels", context, texels)?;
        Ok(records.first(self.count() as usize))
    }

    /// Records the averaging of a capture and returns the buffer of texels that it fills.
    pub fn average(
        &self,
        cx: &mut GpuCx,
        captured: &GpuCube,
    ) -> Result<wgpu::Buffer, EstimatorError> {
        let CubeSpec { size, channels, .. } = captured.spec();
        let context = cx.context();
        let texels = texel_buffer(context, self.count() as usize)?;
        let average = Average {
            m: self.resolution,
            size,
            place: place(channels),
            pad: 0,
        };
        let average = context.uniform("texels average", &average)?;
        let entry = match self.averaging {
            Averaging::Plain => "average_plain",
            Averaging::Middle => "average_middle",
            Averaging::MeanPlane => "average_mean_plane",
        };
        let [radiance, normals] = views(captured)?;
        let bindings = [
            (&average).into(),
            (&texels).into(),
            radiance,
            normals,
            (&self.omegas_sr).into(),
            (&self.extents).into(),
        ];
        let kernel = context.kernel(&AVERAGE, entry, &bindings)?;
        kernel.record(cx, [self.resolution, self.resolution, CUBE_FACES as u32]);
        Ok(texels)
    }
}

/// The slots `captured` and `normals` of shaders with the part [`SURFACE`]. A capture without
/// normals gives its radiance twice: the shader does not look at normals then.
pub fn views(captured: &GpuCube) -> Result<[Binding<'_>; 2], EstimatorError> {
    let radiance = captured_radiance(captured)?;
    Ok([radiance, captured.normal().map_or(radiance, Binding::from)])
}

/// The kernel that sums over texels at every point. `shaders`: with the texels as a uniform and as
/// a storage array; `own`: the bindings of the method's own slots, from 5 on.
pub fn gather_kernel(
    frame: &Frame<'_, Gpu>,
    shaders: &[Shader; 2],
    constants: Constants<'_>,
    (texels, count): (&wgpu::Buffer, u32),
    own: &[Binding<'_>],
) -> Result<Kernel, EstimatorError> {
    let context = frame.context();
    let origin = frame.reference_point.to_array();
    let gather = context.uniform("texels gather", &Gather { origin, count })?;
    let [points, info, estimate] = frame.point_bindings();
    let mut bindings = vec![points, info, estimate, (&gather).into(), texels.into()];
    bindings.extend_from_slice(own);
    let entry = match frame.quantity {
        Quantity::GlossyRadiance => "glossy",
        _ => "irradiance",
    };
    let shader = &shaders[usize::from(count as usize > UNIFORM_TEXELS)];
    Ok(context.kernel_with(shader, entry, constants, &bindings)?)
}

/// A buffer of texels that shaders write as storage and read as storage or, if short, as a uniform
/// array of its full length.
fn texel_buffer(context: &GpuContext, count: usize) -> Result<wgpu::Buffer, EstimatorError> {
    let descriptor = wgpu::BufferDescriptor {
        label: Some("the texels of a cube map"),
        size: (count.max(UNIFORM_TEXELS) * size_of::<Texel>()) as u64,
        usage: wgpu::BufferUsages::STORAGE
            | wgpu::BufferUsages::UNIFORM
            | wgpu::BufferUsages::COPY_SRC,
        mapped_at_creation: false,
    };
    Ok(context.buffer(&descriptor)?)
}

#[cfg(test)]
#[path = "tests.rs"]
mod tests;
