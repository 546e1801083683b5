//! A scene on the GPU: what captures see of it.

use crate::{GpuContext, GpuError, lights};
use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Vec3};
use interreflect_scene::{Environment, Material, Role, Scene};

/// A corner of a triangle, as the vertex shaders read it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(crate) struct Vertex {
    position: [f32; 3],
    /// Unit geometric normal on the front side.
    normal: [f32; 3],
    material: u32,
}

/// The attributes of [`Vertex`] in the vertex shaders.
pub(crate) const VERTEX: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
    array_stride: size_of::<Vertex>() as u64,
    step_mode: wgpu::VertexStepMode::Vertex,
    attributes: &wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Uint32],
};

/// The WGSL struct `Material`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(crate) struct GpuMaterial {
    pub(crate) albedo: [f32; 3],
    pub(crate) pad_albedo: f32,
    pub(crate) emission: [f32; 3],
    pub(crate) pad_emission: f32,
}

/// Radiance from infinity on the GPU.
pub(crate) struct GpuEnvironment {
    pub(crate) image: wgpu::TextureView,
    pub(crate) scale: f32,
    /// Cosine and sine of the rotation about +y.
    pub(crate) turn: [f32; 2],
}

/// A scene on the GPU: the surfaces with [`Role::Environment`], their materials, the lights and
/// the environment.
pub struct GpuScene {
    pub(crate) vertices: wgpu::Buffer,
    pub(crate) vertex_count: u32,
    /// What each drawn triangle is called among all of the environment objects'.
    pub(crate) triangles: Vec<u32>,
    pub(crate) materials: wgpu::Buffer,
    /// `None` for a scene without lights.
    pub(crate) lights: Option<lights::GpuLights>,
    pub(crate) environment: Option<GpuEnvironment>,
    pub(crate) bounds: Bounds,
}

/// A sphere around all captured surfaces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    pub(crate) centre: Vec3,
    pub(crate) radius: f32,
}

impl GpuScene {
    /// Uploads a scene.
    ///
    /// # Errors
    /// [`GpuError::TooManyLights`], or another [`GpuError`] if the device has no room.
    pub fn new(context: &GpuContext, scene: &Scene) -> Result<Self, GpuError> {
        let (vertices, triangles) = vertices(scene);
        let mut materials: Vec<_> = scene.materials.iter().map(GpuMaterial::new).collect();
        if materials.is_empty() {
            // The shaders' array has one element at least.
            materials.push(GpuMaterial::zeroed());
        }
        let bounds = Bounds::of(&vertices);
        let usage = wgpu::BufferUsages::VERTEX;
        let buffer = context.filled_buffer("triangles", bytemuck::cast_slice(&vertices), usage)?;
        let environment = scene.environment.as_ref();
        Ok(Self {
            vertices: buffer,
            vertex_count: vertices.len() as u32,
            triangles,
            materials: context.storage("materials", &materials)?,
            lights: lights::GpuLights::new(context, &scene.lights, bounds)?,
            environment: environment
                .map(|e| GpuEnvironment::new(context, e))
                .transpose()?,
            bounds,
        })
    }
}

impl Bounds {
    fn of(vertices: &[Vertex]) -> Self {
        let positions = || vertices.iter().map(|v| Vec3::from(v.position));
        let low = positions().reduce(Vec3::min).unwrap_or_default();
        let high = positions().reduce(Vec3::max).unwrap_or_default();
        Self {
            centre: low.midpoint(high),
            radius: 0.5 * low.distance(high),
        }
    }

    /// A distance from a point so small that nothing worth seeing is nearer: 1e-6 of the way to
    /// the farthest surface.
    pub(crate) fn near(&self, point: Vec3) -> f32 {
        let farthest = point.distance(self.centre) + self.radius;
        (1e-6 * farthest).max(f32::MIN_POSITIVE)
    }
}

impl GpuMaterial {
    fn new(material: &Material) -> Self {
        let albedo = match material.mirror {
            true => Vec3::ZERO,
            false => material.albedo,
        };
        Self {
            albedo: albedo.to_array(),
            pad_albedo: 0.0,
            emission: material.emission.to_array(),
            pad_emission: 0.0,
        }
    }
}

/// The corners of all captured triangles that have an area, and the triangles' indices, counted over
/// all environment objects.
fn vertices(scene: &Scene) -> (Vec<Vertex>, Vec<u32>) {
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    let meshes = scene.objects_of(Role::Environment).map(|o| &o.mesh);
    let all = meshes.flat_map(|m| {
        m.materials
            .iter()
            .enumerate()
            .map(move |(t, id)| (m, t, *id))
    });
    for (index, (mesh, triangle, material)) in (0..).zip(all) {
        let corners = mesh.corners(triangle);
        let [a, b, c] = corners.map(|p| p.as_dvec3());
        let Some(normal) = (b - a).cross(c - a).try_normalize() else {
            continue;
        };
        triangles.push(index);
        vertices.extend(corners.map(|p| Vertex::new(p, normal, material)));
    }
    (vertices, triangles)
}

impl Vertex {
    fn new(position: Vec3, normal: DVec3, material: u32) -> Self {
        Self {
            position: position.to_array(),
            normal: normal.as_vec3().to_array(),
            material,
        }
    }
}

impl GpuEnvironment {
    fn new(context: &GpuContext, environment: &Environment) -> Result<Self, GpuError> {
        let image = &environment.image;
        let size = wgpu::Extent3d {
            width: image.width,
            height: image.height,
            depth_or_array_layers: 1,
        };
        let texture = context.texture(&wgpu::TextureDescriptor {
            label: Some("environment"),
            size,
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba32Float,
            usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        })?;
        let texels: Vec<_> = image.texels.iter().map(|t| t.extend(1.0)).collect();
        context.write_texture(&texture, &texels)?;
        let angle = environment.rotate_deg.to_radians();
        Ok(Self {
            image: texture.create_view(&wgpu::TextureViewDescriptor::default()),
            scale: environment.scale,
            turn: [angle.cos(), angle.sin()],
        })
    }
}
