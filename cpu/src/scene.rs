//! A scene as the CPU sees it: triangles, ray queries and surface properties.

mod check;

pub use check::CpuError;

use crate::{
    bvh::{Bvh, Hit},
    path_tracer::{CoarseSolution, emitters::Emitters},
};
use glam::{DVec3, Vec3};
use interreflect_scene::{CubeSpec, Material, Mesh, Point, Role, Scene, SurfaceMaterial};
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// Rays that leave a surface start this far from it, relative to the largest coordinate.
const RAY_START: f64 = 1e-8;

/// Rays leave a shaded point from this far above it, relative to its coordinates: points on a
/// surface are rounded to f32 and may lie a few units in the last place behind it.
const LIFT: f32 = 2e-6;

/// A scene with ray queries. The tree over all objects is built when it is first asked for, and
/// never if there is no receiver.
#[derive(Debug)]
pub struct CpuScene {
    scene: Scene,
    environment: Geometry,
    everything: OnceLock<Geometry>,
    has_receivers: bool,
    /// By number of reflections.
    coarse: Mutex<BTreeMap<u32, Arc<CoarseSolution>>>,
}

/// Triangles of some of the scene's objects with a tree over them.
#[derive(Debug)]
pub struct Geometry {
    bvh: Bvh,
    /// Indices of the objects and the soup's index of their first triangle.
    objects: Vec<(u32, u32)>,
    /// Largest coordinate in metres.
    reach: f32,
    emitters: Emitters,
}

/// A surface that a ray met.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceHit {
    /// Distance from the ray's origin in metres, for a unit direction.
    pub distance: f64,
    /// Position in metres.
    pub position: DVec3,
    /// Unit normal of the triangle, turned to the side that the ray came from.
    pub geometric_normal: Vec3,
    /// Interpolated unit normal, turned along with the geometric one.
    pub shading_normal: Vec3,
    /// Whether the ray met the front side, the one that emits.
    pub front: bool,
    /// The material.
    pub material: Material,
    /// Role of the object.
    pub role: Role,
    /// Index of the triangle in its [`Geometry`].
    pub triangle: u32,
    /// Weights of the triangle's corners 1 and 2.
    pub barycentric: [f32; 2],
}

impl SurfaceHit {
    /// The surface as a shading point, seen along `direction`, with its interpolated normal and without a
    /// footprint.
    pub fn point(&self, direction: Vec3) -> Point {
        Point {
            position: self.position.as_vec3(),
            normal: self.shading_normal,
            view: -direction,
            material: SurfaceMaterial {
                diffuse: self.material.albedo,
                specular: self.material.specular,
                shininess: self.material.shininess,
            },
            footprint: 0.0,
        }
    }
}

impl CpuScene {
    /// Takes over a scene and builds the tree over its environment objects.
    ///
    /// # Errors
    /// [`CpuError`] if indices, lengths or coordinates of a mesh, or the environment's size, are
    /// out of range. A scene that was loaded has been checked for this.
    pub fn new(scene: &Scene) -> Result<Self, CpuError> {
        check::check(scene)?;
        Ok(Self {
            scene: scene.clone(),
            environment: Geometry::new(scene, |role| role == Role::Environment),
            everything: OnceLock::new(),
            has_receivers: scene
                .objects_of(Role::Receiver)
                .any(|o| !o.mesh.triangles.is_empty()),
            coarse: Mutex::default(),
        })
    }

    /// The scene that this was made of.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The environment objects: what captures see.
    pub fn environment_objects(&self) -> &Geometry {
        &self.environment
    }

    /// Environment objects and receivers. The first call builds their tree.
    pub fn all_objects(&self) -> &Geometry {
        if !self.has_receivers {
            return &self.environment;
        }
        self.everything
            .get_or_init(|| Geometry::new(&self.scene, |_| true))
    }

    /// Nearest surface of some objects along origin + t·direction (a unit vector), t > `t_min`.
    pub fn closest(
        &self,
        objects: &Geometry,
        origin: DVec3,
        direction: Vec3,
        t_min: f64,
    ) -> Option<SurfaceHit> {
        let direction = direction.as_dvec3();
        objects
            .bvh
            .closest(origin, direction, t_min, f64::INFINITY)
            .map(|hit| self.surface(objects, origin, direction, hit))
    }

    /// What a ray met, from the hit of a tree of this scene.
    pub fn surface(
        &self,
        objects: &Geometry,
        origin: DVec3,
        direction: DVec3,
        hit: Hit,
    ) -> SurfaceHit {
        let (object, local) = objects.locate(hit.triangle);
        let object = &self.scene.objects[object];
        let mesh = &object.mesh;
        let normal = mesh.normal(local);
        let front = normal.as_dvec3().dot(direction) < 0.0;
        let side = if front { 1.0 } else { -1.0 };
        SurfaceHit {
            distance: hit.distance,
            position: origin + direction * hit.distance,
            geometric_normal: normal * side,
            shading_normal: shading_normal(mesh, local, hit.barycentric).unwrap_or(normal) * side,
            front,
            material: self.scene.materials[mesh.materials[local] as usize],
            role: object.role,
            triangle: hit.triangle,
            barycentric: [hit.barycentric[1], hit.barycentric[2]].map(|weight| weight as f32),
        }
    }

    /// The coarse solution of a number of further reflections (at least 1), computed when it is
    /// first asked for. Where several threads ask at once, each may compute it, with the same result.
    pub fn coarse_solution(&self, bounces: u32) -> Arc<CoarseSolution> {
        let known = || self.coarse.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(found) = known().get(&bounces) {
            return found.clone();
        }
        // Not under the lock: a thread of the pool that waits for its own part may be given work
        // that asks for the same solution.
        let solved = Arc::new(CoarseSolution::new(self, bounces));
        known().entry(bounces).or_insert(solved).clone()
    }

    /// The coarse solution that a capture's radiance holds; `None` if it holds none.
    pub fn coarse_for(&self, spec: &CubeSpec) -> Option<Arc<CoarseSolution>> {
        let asked = spec.channels.radiance && spec.bounces > 0;
        asked.then(|| self.coarse_solution(spec.bounces))
    }
}

impl Geometry {
    fn new(scene: &Scene, wanted: impl Fn(Role) -> bool) -> Self {
        let mut soup = Vec::new();
        let mut objects = Vec::new();
        for (index, object) in scene.objects.iter().enumerate() {
            let mesh = &object.mesh;
            if wanted(object.role) && !mesh.triangles.is_empty() {
                objects.push((index as u32, soup.len() as u32));
                soup.extend((0..mesh.triangles.len()).map(|t| mesh.corners(t)));
            }
        }
        let reach =
            (soup.iter().flatten()).fold(0.0_f32, |m, c: &Vec3| m.max(c.abs().max_element()));
        let mut geometry = Self {
            bvh: Bvh::new(&soup),
            objects,
            reach,
            emitters: Emitters::default(),
        };
        geometry.emitters = Emitters::new(scene, &soup, |triangle| {
            let (object, local) = geometry.locate(triangle);
            let mesh = &scene.objects[object].mesh;
            let radiance = scene.materials[mesh.materials[local] as usize].emission;
            (radiance, mesh.normal(local))
        });
        geometry
    }

    /// The tree over the triangles.
    pub fn bvh(&self) -> &Bvh {
        &self.bvh
    }

    /// Smallest ray parameter at which a ray that starts on a surface may meet another.
    pub fn ray_start(&self) -> f64 {
        RAY_START * f64::from(self.reach)
    }

    /// Where rays leave a shaded point: a little above its surface, along the unit normal.
    pub fn above(&self, position: Vec3, normal: Vec3) -> DVec3 {
        let reach = position.abs().max_element().max(0.1 * self.reach);
        position.as_dvec3() + (normal * (LIFT * reach)).as_dvec3()
    }

    /// Largest coordinate of any corner, in metres.
    pub fn reach(&self) -> f32 {
        self.reach
    }

    /// The triangles that emit, and the environment map: what can be sampled as a light.
    pub(crate) fn emitters(&self) -> &Emitters {
        &self.emitters
    }

    /// Whether something lies between a surface point and `distance` along a unit direction.
    /// What touches either end does not count.
    pub fn occluded(&self, origin: DVec3, direction: DVec3, distance: f64) -> bool {
        let end = distance * (1.0 - 1e-6);
        self.bvh.occluded(origin, direction, self.ray_start(), end)
    }

    /// Index of the object of a triangle, and the triangle's index in the object's mesh.
    pub fn locate(&self, triangle: u32) -> (usize, usize) {
        let at = self
            .objects
            .partition_point(|&(_, first)| first <= triangle)
            - 1;
        let (object, first) = self.objects[at];
        (object as usize, (triangle - first) as usize)
    }
}

fn shading_normal(mesh: &Mesh, triangle: usize, barycentric: [f64; 3]) -> Option<Vec3> {
    if mesh.normals.is_empty() {
        return None;
    }
    let sum: Vec3 = mesh.triangles[triangle]
        .iter()
        .zip(barycentric)
        .map(|(&v, weight)| mesh.normals[v as usize] * weight as f32)
        .sum();
    sum.try_normalize()
}
