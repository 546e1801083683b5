//! Lights on the GPU.

use crate::{GpuContext, GpuError, scene::Bounds};
use bytemuck::{Pod, Zeroable};
use glam::Vec3;
use interreflect_scene::{Light, SpotShape};

/// Most lights of a capture; they lie in a uniform buffer, which reads faster than storage.
pub const MAX_LIGHTS: usize = 16;

/// The WGSL struct `Light`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub(crate) struct GpuLight {
    pub(crate) position: [f32; 3],
    pub(crate) kind: u32,
    pub(crate) axis: [f32; 3],
    pub(crate) limit: f32,
    pub(crate) up: [f32; 3],
    pub(crate) first_layer: u32,
    pub(crate) power: [f32; 3],
    pub(crate) pad: f32,
}

/// The WGSL struct `Lights`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(crate) struct LightList {
    pub(crate) lights: [GpuLight; MAX_LIGHTS],
    pub(crate) count: u32,
    pub(crate) near: f32,
    pub(crate) pad: [f32; 2],
}

/// Values of `Light::kind` in WGSL.
pub(crate) mod kind {
    pub(crate) const POINT: u32 = 0;
    pub(crate) const CONE: u32 = 1;
    pub(crate) const SQUARE: u32 = 2;
    pub(crate) const DIRECTIONAL: u32 = 3;
    pub(crate) const AREA: u32 = 4;
}

/// The lights of a scene in a uniform buffer.
pub(crate) struct GpuLights {
    pub(crate) buffer: wgpu::Buffer,
    /// For each shadow map in order: its instance, which is light · 6 + face.
    pub(crate) shadow_instances: Vec<u32>,
}

impl GpuLights {
    /// Uploads lights; `None` if there are none.
    pub(crate) fn new(
        context: &GpuContext,
        lights: &[Light],
        bounds: Bounds,
    ) -> Result<Option<Self>, GpuError> {
        if lights.is_empty() {
            return Ok(None);
        }
        if lights.len() > MAX_LIGHTS {
            return Err(GpuError::TooManyLights {
                lights: lights.len(),
                max: MAX_LIGHTS,
            });
        }
        let mut list = LightList::zeroed();
        let mut shadow_instances = Vec::new();
        let mut near = f32::INFINITY;
        for (i, (light, slot)) in lights.iter().zip(&mut list.lights).enumerate() {
            *slot = GpuLight::new(light, bounds);
            slot.first_layer = shadow_instances.len() as u32;
            let faces = match slot.kind {
                kind::DIRECTIONAL => 1,
                _ => 6,
            };
            shadow_instances.extend((0..faces).map(|face| i as u32 * 6 + face));
            near = near.min(bounds.near(slot.position.into()));
        }
        list.count = lights.len() as u32;
        list.near = near;
        Ok(Some(Self {
            buffer: context.uniform("lights", &list)?,
            shadow_instances,
        }))
    }
}

impl GpuLight {
    fn new(light: &Light, bounds: Bounds) -> Self {
        match *light {
            Light::Point {
                position,
                intensity,
                ..
            } => Self::at(position, kind::POINT, intensity),
            Light::Spot {
                position,
                direction,
                up,
                shape,
                angle_deg,
                intensity,
            } => {
                let half = 0.5 * angle_deg.to_radians();
                let (kind, limit) = match shape {
                    SpotShape::Cone => (kind::CONE, half.cos()),
                    SpotShape::Square => (kind::SQUARE, half.tan()),
                };
                Self {
                    limit,
                    up: up.to_array(),
                    ..Self::at(position, kind, intensity).facing(direction)
                }
            }
            Light::Directional {
                direction,
                irradiance,
            } => Self {
                // A little more than the sphere, so that its rim lies inside the map.
                limit: (1.01 * bounds.radius).max(f32::MIN_POSITIVE),
                ..Self::at(bounds.centre, kind::DIRECTIONAL, irradiance).facing(direction)
            },
            Light::Area {
                position,
                normal,
                flux,
                ..
            } => Self::at(position, kind::AREA, flux * std::f32::consts::FRAC_1_PI).facing(normal),
        }
    }

    fn at(position: Vec3, kind: u32, power: Vec3) -> Self {
        Self {
            position: position.to_array(),
            kind,
            power: power.to_array(),
            ..Self::default()
        }
    }

    fn facing(self, axis: Vec3) -> Self {
        Self {
            axis: axis.to_array(),
            up: axis.any_orthonormal_vector().to_array(),
            ..self
        }
    }
}
