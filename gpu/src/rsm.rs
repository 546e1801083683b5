//! Reflective shadow maps in storage buffers.

use crate::{GpuContext, GpuError};
use bytemuck::{Pod, Zeroable};
use glam::{Vec3, Vec4};
use interreflect_scene::{Bounds, LightFrame, RsmImage, RsmSpec, TrueColors};

/// Reflective shadow maps of every light: buffers of texels, frame by frame and row by row as in
/// [`RsmImage`], which compute shaders read. A texel whose way has length 0 is no photon.
#[derive(Clone, Debug)]
pub struct GpuRsm {
    spec: RsmSpec,
    frames: Vec<LightFrame>,
    bounds: Bounds,
    pub(crate) planes: Planes,
}

/// The buffers of the channels; of one that was not asked for, a few bytes of nothing.
#[derive(Clone, Debug)]
pub(crate) struct Planes {
    pub(crate) position: wgpu::Buffer,
    pub(crate) radiance: wgpu::Buffer,
    pub(crate) normal: wgpu::Buffer,
    pub(crate) true_colors: wgpu::Buffer,
}

/// The WGSL struct `TrueColors`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub(crate) struct GpuTrueColors {
    pub(crate) diffuse: [f32; 3],
    pub(crate) shininess: f32,
    pub(crate) specular: [f32; 3],
    pub(crate) pad_specular: f32,
    pub(crate) irradiance: [f32; 3],
    pub(crate) pad_irradiance: f32,
    pub(crate) to_light: [f32; 3],
    pub(crate) pad: f32,
}

impl GpuRsm {
    /// Views from these frames without a photon.
    pub(crate) fn blank(
        context: &GpuContext,
        frames: Vec<LightFrame>,
        bounds: Bounds,
        spec: RsmSpec,
    ) -> Result<Self, GpuError> {
        let texels = frames.len() as u64 * u64::from(spec.size).pow(2);
        let room = |label: &str, asked: bool, bytes: usize| {
            let count = if asked { texels.max(1) } else { 1 };
            context.storage_zeroed(label, count * bytes as u64)
        };
        let channels = spec.channels;
        let planes = Planes {
            position: room("positions in RSMs", true, size_of::<Vec4>())?,
            radiance: room("radiance in RSMs", channels.radiance, size_of::<Vec4>())?,
            normal: room("normals in RSMs", channels.normal, size_of::<Vec4>())?,
            true_colors: room(
                "true colours in RSMs",
                channels.true_colors,
                size_of::<GpuTrueColors>(),
            )?,
        };
        Ok(Self {
            spec,
            frames,
            bounds,
            planes,
        })
    }

    /// The spec that these views answer.
    pub fn spec(&self) -> RsmSpec {
        self.spec
    }

    /// Where the views are taken from.
    pub fn frames(&self) -> &[LightFrame] {
        &self.frames
    }

    /// Box around all surfaces.
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// Position (xyz) and the length b of the light's way in metres (w, 0 without a photon): an
    /// array of `vec4f`.
    pub fn position(&self) -> &wgpu::Buffer {
        &self.planes.position
    }

    /// Reflected radiance (rgb): an array of `vec4f`, one element if it was not asked for.
    pub fn radiance(&self) -> &wgpu::Buffer {
        &self.planes.radiance
    }

    /// Unit normal (xyz) and cosine of the arriving light (w): an array of `vec4f`, one element if
    /// it was not asked for.
    pub fn normal(&self) -> &wgpu::Buffer {
        &self.planes.normal
    }

    /// True colours: an array of [`crate::wgsl::TRUE_COLORS`], one element if they were not asked
    /// for.
    pub fn true_colors(&self) -> &wgpu::Buffer {
        &self.planes.true_colors
    }

    /// Uploads views from the host, made by either backend.
    ///
    /// # Errors
    /// [`GpuError::CubeImage`] if a channel has another number of texels than the image's size
    /// and frames say, or another [`GpuError`] if the device has no room.
    pub fn upload(context: &GpuContext, image: &RsmImage) -> Result<Self, GpuError> {
        let (expected, channels) = (image.texels(), image.channels);
        for (asked, found) in [
            (true, image.position.len()),
            (true, image.path_m.len()),
            (channels.radiance, image.radiance.len()),
            (channels.normal, image.normal.len()),
            (channels.normal, image.cos_light.len()),
            (channels.true_colors, image.true_colors.len()),
        ] {
            if asked && found != expected {
                return Err(GpuError::CubeImage { found, expected });
            }
        }
        let view = Self::blank(context, image.frames.clone(), image.bounds, image.spec())?;
        let planes = &view.planes;
        let with = |v: &[Vec3], w: &[f32]| -> Vec<Vec4> {
            v.iter().zip(w).map(|(v, w)| v.extend(*w)).collect()
        };
        context.write(&planes.position, &with(&image.position, &image.path_m))?;
        if channels.radiance {
            let values: Vec<Vec4> = image.radiance.iter().map(|l| l.extend(0.0)).collect();
            context.write(&planes.radiance, &values)?;
        }
        if channels.normal {
            context.write(&planes.normal, &with(&image.normal, &image.cos_light))?;
        }
        if channels.true_colors {
            let values: Vec<_> = image.true_colors.iter().map(GpuTrueColors::new).collect();
            context.write(&planes.true_colors, &values)?;
        }
        Ok(view)
    }

    /// Reads the views back.
    ///
    /// # Errors
    /// [`GpuError`] if the device fails.
    pub fn download(&self, context: &GpuContext) -> Result<RsmImage, GpuError> {
        let mut image = RsmImage::blank(self.frames.clone(), self.bounds, self.spec);
        let (texels, channels) = (image.texels(), self.spec.channels);
        let read = |buffer| -> Result<Vec<Vec4>, GpuError> {
            let mut values = context.read_buffer(buffer)?;
            values.truncate(texels);
            Ok(values)
        };
        let position = read(&self.planes.position)?;
        image.position = position.iter().map(|v| v.truncate()).collect();
        image.path_m = position.iter().map(|v| v.w).collect();
        if channels.radiance {
            let radiance = read(&self.planes.radiance)?;
            image.radiance = radiance.iter().map(|v| v.truncate()).collect();
        }
        if channels.normal {
            let normal = read(&self.planes.normal)?;
            image.normal = normal.iter().map(|v| v.truncate()).collect();
            image.cos_light = normal.iter().map(|v| v.w).collect();
        }
        if channels.true_colors {
            let colors: Vec<GpuTrueColors> = context.read_buffer(&self.planes.true_colors)?;
            image.true_colors = colors.iter().take(texels).map(|c| c.on_host()).collect();
        }
        Ok(image)
    }
}

impl GpuTrueColors {
    fn new(colors: &TrueColors) -> Self {
        Self {
            diffuse: colors.diffuse.to_array(),
            shininess: colors.shininess,
            specular: colors.specular.to_array(),
            irradiance: colors.irradiance.to_array(),
            to_light: colors.to_light.to_array(),
            ..Self::default()
        }
    }

    fn on_host(self) -> TrueColors {
        TrueColors {
            diffuse: self.diffuse.into(),
            specular: self.specular.into(),
            shininess: self.shininess,
            irradiance: self.irradiance.into(),
            to_light: self.to_light.into(),
        }
    }
}
