//! Localized cube maps on the GPU: one workgroup averages a texel, one invocation shades a point.

use super::params::SolidAngle;
use super::texels::Texel;
use super::{LocalizedCubemap, LocalizedCubemapParams};
use crate::averaging::face_solid_angles_sr;
use crate::kept::Kept;
use crate::{Changed, Estimator, EstimatorError, Gpu, Inputs, LOBE_POWER, Quantity};
use interreflect_gpu::{Binding, GpuContext, GpuCx, GpuEstimate, Kernel, Shader, wgsl};
use interreflect_scene::CubeSpec;
use interreflect_scene::conventions::CUBE_FACES;
use interreflect_scene::params::Fidelity;

const LEAVES: &str = include_str!("math.wgsl");
const TEXEL: &str = include_str!("texel.wgsl");

/// Texels that the uniform buffer of texels_uniform.wgsl holds: 48 KiB of the 64 that WebGPU
/// guarantees.
const UNIFORM_TEXELS: usize = 1024;

const AVERAGE: Shader = Shader {
    label: "localized_cubemap average",
    parts: &[
        wgsl::MATH,
        wgsl::CUBE,
        LOBE_POWER,
        LEAVES,
        TEXEL,
        include_str!("average.wgsl"),
    ],
};

const SHADE_UNIFORM: Shader = Shader {
    label: "localized_cubemap shade, uniform texels",
    parts: &[
        wgsl::MATH,
        wgsl::POINTS,
        LOBE_POWER,
        LEAVES,
        TEXEL,
        include_str!("texels_uniform.wgsl"),
        include_str!("shade.wgsl"),
    ],
};

const SHADE_STORAGE: Shader = Shader {
    label: "localized_cubemap shade, stored texels",
    parts: &[
        wgsl::MATH,
        wgsl::POINTS,
        LOBE_POWER,
        LEAVES,
        TEXEL,
        include_str!("texels_storage.wgsl"),
        include_str!("shade.wgsl"),
    ],
};

/// Solid angles, texels and the kernel, kept across frames.
#[derive(Default)]
pub struct State {
    solid_angles: Kept<LocalizedCubemapParams, SolidAngles>,
    texels: Option<wgpu::Buffer>,
    shade: Option<Kernel>,
}

/// Solid angles in sr of a face's captured texels and of the texels that they are averaged to;
/// `corrected` only.
struct SolidAngles {
    captured: wgpu::Buffer,
    texels: wgpu::Buffer,
}

/// As `Average` in average.wgsl.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Average {
    m: u32,
    size: u32,
    shader_omega: u32,
    located: u32,
}

/// As `Shade` in shade.wgsl.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Shade {
    origin: [f32; 3],
    count: u32,
}

impl Estimator<Gpu> for LocalizedCubemap {
    type State = State;

    const SHADERS: &'static [Shader] = &[AVERAGE, SHADE_UNIFORM, SHADE_STORAGE];

    fn prepare(
        params: &LocalizedCubemapParams,
        state: &mut State,
        cx: &mut GpuCx,
        quantity: Quantity,
        inputs: &Inputs<'_, Gpu>,
        out: &GpuEstimate,
    ) -> Result<(), EstimatorError> {
        let stale = inputs.changed.any(Changed::PARAMS | Changed::CAPTURES);
        if stale || state.texels.is_none() {
            let make = || solid_angles(params, cx.context());
            let solid_angles = state.solid_angles.tables(params, make)?;
            state.texels = Some(average(params, cx, inputs, solid_angles)?);
        }
        let texels = state.texels.as_ref().ok_or(EstimatorError::Unprepared)?;
        let context = cx.context();
        let count = params.texels();
        let origin = inputs.reference_point.to_array();
        let shade = context.uniform("localized_cubemap shade", &Shade { origin, count })?;
        let [points, info, estimate] = inputs.points.bindings(out);
        let bindings = [points, info, estimate, (&shade).into(), texels.into()];
        let shader = match count as usize <= UNIFORM_TEXELS {
            true => &SHADE_UNIFORM,
            false => &SHADE_STORAGE,
        };
        let entry = match (quantity, params.fidelity) {
            (Quantity::GlossyRadiance, Fidelity::Published) => "glossy_published",
            (Quantity::GlossyRadiance, Fidelity::Corrected) => "glossy_corrected",
            (_, Fidelity::Published) => "irradiance_published",
            (_, Fidelity::Corrected) => "irradiance_corrected",
        };
        state.shade = Some(context.kernel(shader, entry, &bindings)?);
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

impl LocalizedCubemapParams {
    fn texels(&self) -> u32 {
        CUBE_FACES as u32 * self.resolution * self.resolution
    }
}

/// Uploads the solid angles that the averaging reads.
fn solid_angles(
    params: &LocalizedCubemapParams,
    context: &GpuContext,
) -> Result<SolidAngles, EstimatorError> {
    let of_face = |size| match params.fidelity {
        Fidelity::Published => vec![0.0],
        Fidelity::Corrected => face_solid_angles_sr(size),
    };
    let captured = of_face(params.capture_size());
    let texels = of_face(params.resolution);
    Ok(SolidAngles {
        captured: context.storage("captured solid angles", &captured)?,
        texels: context.storage("texel solid angles", &texels)?,
    })
}

/// Records the averaging of the captures and returns the buffer of texels that it fills.
fn average(
    params: &LocalizedCubemapParams,
    cx: &mut GpuCx,
    inputs: &Inputs<'_, Gpu>,
    solid_angles: &SolidAngles,
) -> Result<wgpu::Buffer, EstimatorError> {
    let captured = inputs.cube(&params.captured(&inputs.scene))?;
    let CubeSpec { size, channels, .. } = captured.spec();
    let context = cx.context();
    let texels = texel_buffer(context, params.texels() as usize)?;
    let missing = || EstimatorError::Missing("a channel of the captured cube".into());
    let radiance = captured.radiance_distance().ok_or_else(missing)?;
    let average = Average {
        m: params.resolution,
        size,
        shader_omega: u32::from(params.solid_angle == SolidAngle::Shader),
        located: u32::from(channels.distance),
    };
    let average = context.uniform("localized_cubemap average", &average)?;
    let entry = match params.fidelity {
        Fidelity::Published => "average_published",
        Fidelity::Corrected => "average_corrected",
    };
    // A cube without normals has no place either: the shader does not look at them then.
    let normal = captured.normal().unwrap_or(radiance);
    let bindings: [Binding<'_>; 6] = [
        (&average).into(),
        (&texels).into(),
        radiance.into(),
        (&solid_angles.captured).into(),
        (&solid_angles.texels).into(),
        normal.into(),
    ];
    let kernel = context.kernel(&AVERAGE, entry, &bindings)?;
    kernel.record(
        cx,
        [params.resolution, params.resolution, CUBE_FACES as u32],
    );
    Ok(texels)
}

/// A buffer of texels that shaders write as storage and read as storage or, if short, as a uniform
/// array of its full length.
fn texel_buffer(context: &GpuContext, count: usize) -> Result<wgpu::Buffer, EstimatorError> {
    let descriptor = wgpu::BufferDescriptor {
        label: Some("localized_cubemap texels"),
        size: (count.max(UNIFORM_TEXELS) * size_of::<Texel>()) as u64,
        usage: wgpu::BufferUsages::STORAGE
            | wgpu::BufferUsages::UNIFORM
            | wgpu::BufferUsages::COPY_SRC,
        mapped_at_creation: false,
    };
    Ok(context.checked("the texels of localized_cubemap", || {
        context.device().create_buffer(&descriptor)
    })?)
}

#[cfg(test)]
#[path = "tests.rs"]
mod tests;
