//! A scene on the GPU: what captures see of it.

use crate::{GpuContext, GpuError, lights};
use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Vec3};
use interreflect_scene::{
    self as host, Environment, Light, Material, Mesh, Role, Scene, Surroundings,
};

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
    pub(crate) shininess: f32,
    pub(crate) emission: [f32; 3],
    pub(crate) mirror: u32,
    pub(crate) specular: [f32; 3],
    pub(crate) pad: f32,
}

/// The struct `Material` in WGSL.
pub(crate) const MATERIAL: &str = include_str!("capture/material.wgsl");

/// Radiance from infinity on the GPU.
pub(crate) struct GpuEnvironment {
    pub(crate) image: wgpu::TextureView,
    pub(crate) scale: f32,
    /// Cosine and sine of the rotation about +y.
    pub(crate) turn: [f32; 2],
}

/// A scene on the GPU: its surfaces, their materials, the lights and the environment.
pub struct GpuScene {
    /// Corners of the triangles of environment objects, then of those of receivers.
    pub(crate) vertices: wgpu::Buffer,
    /// Corners that belong to environment objects: what cube captures see.
    pub(crate) vertex_count: u32,
    /// Corners of all objects: what views from lights see.
    pub(crate) all_vertex_count: u32,
    /// What each drawn triangle of environment objects is called among all of theirs.
    pub(crate) triangles: Vec<u32>,
    pub(crate) materials: wgpu::Buffer,
    /// `None` for a scene without lights.
    pub(crate) lights: Option<lights::GpuLights>,
    pub(crate) environment: Option<GpuEnvironment>,
    /// Around what cube captures see.
    pub(crate) bounds: Bounds,
    /// What views from the lights are aimed at.
    pub(crate) surroundings: Surroundings,
    /// Where views from the lights are taken.
    pub(crate) view_lights: Vec<Light>,
    /// Unit normals at the corners of each drawn triangle; `None` for a scene without mirrors.
    pub(crate) corner_normals: Option<wgpu::Buffer>,
}

/// A sphere around surfaces.
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
        let captured = drawn(scene, Role::Environment);
        let receivers = drawn(scene, Role::Receiver);
        let all = || captured.iter().chain(&receivers);
        let vertices: Vec<Vertex> = all().flat_map(Drawn::vertices).collect();
        let mut materials: Vec<_> = scene.materials.iter().map(GpuMaterial::new).collect();
        if materials.is_empty() {
            // The shaders' array has one element at least.
            materials.push(GpuMaterial::zeroed());
        }
        let bounds = Bounds::around(&host::Bounds::of_captured(scene));
        let surroundings = Surroundings::of(scene);
        let usage = wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::STORAGE;
        let buffer = context.filled_buffer("triangles", bytemuck::cast_slice(&vertices), usage)?;
        let environment = scene.environment.as_ref();
        Ok(Self {
            vertices: buffer,
            vertex_count: 3 * captured.len() as u32,
            all_vertex_count: vertices.len() as u32,
            triangles: captured.iter().map(|d| d.index).collect(),
            materials: context.storage("materials", &materials)?,
            lights: lights::GpuLights::new(
                context,
                &scene.lights,
                Bounds::around(&surroundings.all),
            )?,
            environment: environment
                .map(|e| GpuEnvironment::new(context, e))
                .transpose()?,
            bounds,
            surroundings,
            view_lights: scene.lights.clone(),
            corner_normals: corner_normals(context, scene, all())?,
        })
    }
}

/// The normals by which mirrors reflect, if there are any.
fn corner_normals<'a>(
    context: &GpuContext,
    scene: &Scene,
    drawn: impl Iterator<Item = &'a Drawn<'a>> + Clone,
) -> Result<Option<wgpu::Buffer>, GpuError> {
    let is_mirror = |d: &Drawn<'_>| scene.materials[d.material as usize].mirror;
    if !drawn.clone().any(is_mirror) {
        return Ok(None);
    }
    let normals: Vec<_> = drawn.flat_map(Drawn::corner_normals).collect();
    context.storage("normals of corners", &normals).map(Some)
}

impl Bounds {
    pub(crate) fn around(surfaces: &host::Bounds) -> Self {
        Self {
            centre: surfaces.centre(),
            radius: surfaces.radius(),
        }
    }

    /// Largest distance of a surface from the origin.
    pub(crate) fn reach(&self) -> f32 {
        self.centre.length() + self.radius
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
            shininess: material.shininess,
            emission: material.emission.to_array(),
            mirror: u32::from(material.mirror),
            specular: material.specular.to_array(),
            pad: 0.0,
        }
    }
}

/// A triangle that has an area.
struct Drawn<'a> {
    /// Counted over all objects of its role.
    index: u32,
    mesh: &'a Mesh,
    /// Index in its mesh.
    triangle: usize,
    normal: DVec3,
    material: u32,
}

impl Drawn<'_> {
    fn vertices(&self) -> [Vertex; 3] {
        let corners = self.mesh.corners(self.triangle);
        corners.map(|p| Vertex::new(p, self.normal, self.material))
    }

    fn corner_normals(&self) -> [[f32; 4]; 3] {
        let own = self.normal.as_vec3();
        self.mesh.triangles[self.triangle].map(|v| {
            let normal = self.mesh.normals.get(v as usize).copied();
            normal.unwrap_or(own).extend(0.0).to_array()
        })
    }
}

fn drawn(scene: &Scene, role: Role) -> Vec<Drawn<'_>> {
    let mut drawn = Vec::new();
    let meshes = scene.objects_of(role).map(|o| &o.mesh);
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
        drawn.push(Drawn {
            index,
            mesh,
            triangle,
            normal,
            material,
        });
    }
    drawn
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
