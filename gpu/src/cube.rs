//! Cube captures as textures.

use crate::capture::raster::{array_view, layer_view};
use crate::{GpuContext, GpuError};
use glam::Vec4;
use interreflect_scene::{CubeImage, CubeSpec, conventions::CUBE_FACES};

const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba32Float;

/// A cube capture: texture arrays of six layers (faces in the order of
/// `interreflect_scene::conventions`) that compute shaders read by `textureLoad`.
#[derive(Clone, Debug)]
pub struct GpuCube {
    spec: CubeSpec,
    radiance_distance: Option<Channels>,
    normal: Option<Channels>,
}

#[derive(Clone, Debug)]
struct Channels {
    texture: wgpu::Texture,
    view: wgpu::TextureView,
}

impl Channels {
    fn new(context: &GpuContext, label: &str, size: u32) -> Result<Self, GpuError> {
        let texture = context.target_array(label, size, CUBE_FACES as u32, FORMAT)?;
        let view = array_view(&texture);
        Ok(Self { texture, view })
    }
}

impl GpuCube {
    /// Textures for the channels of `spec`.
    pub(crate) fn blank(context: &GpuContext, spec: CubeSpec) -> Result<Self, GpuError> {
        let channels = spec.channels;
        let make = |asked: bool, label: &str| {
            asked
                .then(|| Channels::new(context, label, spec.size))
                .transpose()
        };
        Ok(Self {
            spec,
            radiance_distance: make(channels.radiance || channels.distance, "radiance, distance")?,
            normal: make(channels.normal, "normal")?,
        })
    }

    /// The spec that this capture answers.
    pub fn spec(&self) -> CubeSpec {
        self.spec
    }

    /// Radiance (rgb) and distance in metres (a), if either was asked for; what was not asked for
    /// is undefined. WGSL has no dependable infinity, so **distance 0 means no surface** here,
    /// where the host's [`CubeImage`] has +∞; radiance is then the environment's.
    pub fn radiance_distance(&self) -> Option<&wgpu::TextureView> {
        self.radiance_distance.as_ref().map(|c| &c.view)
    }

    /// Unit normal (xyz) on the side of the reference point, if asked for; 0 where there is no
    /// surface.
    pub fn normal(&self) -> Option<&wgpu::TextureView> {
        self.normal.as_ref().map(|c| &c.view)
    }

    /// Formats of the render targets.
    pub(crate) fn targets(&self) -> [Option<wgpu::TextureFormat>; 2] {
        self.channels().map(|c| c.map(|_| FORMAT))
    }

    /// One face of each render target.
    pub(crate) fn face_views(&self, face: u32) -> [Option<wgpu::TextureView>; 2] {
        self.channels()
            .map(|c| c.map(|c| layer_view(&c.texture, face)))
    }

    fn channels(&self) -> [Option<&Channels>; 2] {
        [self.radiance_distance.as_ref(), self.normal.as_ref()]
    }

    /// Uploads a capture from the host, made by either backend.
    ///
    /// # Errors
    /// [`GpuError::CubeImage`] if a channel has another number of texels than the image's size
    /// says, or another [`GpuError`] if the device has no room.
    pub fn upload(context: &GpuContext, image: &CubeImage) -> Result<Self, GpuError> {
        let texels = image.texels();
        for found in [
            image.radiance.len(),
            image.distance.len(),
            image.normal.len(),
        ] {
            if found != 0 && found != texels {
                return Err(GpuError::CubeImage {
                    found,
                    expected: texels,
                });
            }
        }
        let cube = Self::blank(context, image.spec())?;
        if let Some(channels) = &cube.radiance_distance {
            let texel = |i: usize| {
                let radiance = image.radiance.get(i).copied().unwrap_or_default();
                let distance = image.distance.get(i).copied().filter(|d| d.is_finite());
                radiance.extend(distance.unwrap_or(0.0))
            };
            let values: Vec<Vec4> = (0..texels).map(texel).collect();
            context.write_texture(&channels.texture, &values)?;
        }
        if let Some(channels) = &cube.normal {
            let values: Vec<Vec4> = image.normal.iter().map(|n| n.extend(0.0)).collect();
            context.write_texture(&channels.texture, &values)?;
        }
        Ok(cube)
    }

    /// Reads the capture back.
    ///
    /// # Errors
    /// [`GpuError`] if the device fails.
    pub fn download(&self, context: &GpuContext) -> Result<CubeImage, GpuError> {
        let mut image = CubeImage {
            size: self.spec.size,
            bounces: self.spec.bounces,
            ..CubeImage::default()
        };
        if let Some(channels) = &self.radiance_distance {
            let values: Vec<Vec4> = context.read_texture(&channels.texture)?;
            if self.spec.channels.radiance {
                image.radiance = values.iter().map(|v| v.truncate()).collect();
            }
            if self.spec.channels.distance {
                image.distance = values.iter().map(|v| distance(v.w)).collect();
            }
        }
        if let Some(channels) = &self.normal {
            let values: Vec<Vec4> = context.read_texture(&channels.texture)?;
            image.normal = values.iter().map(|v| v.truncate()).collect();
        }
        Ok(image)
    }
}

/// The host's distance of a texel.
fn distance(stored: f32) -> f32 {
    match stored {
        0.0 => f32::INFINITY,
        d => d,
    }
}
