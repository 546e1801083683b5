//! The vertices of what is shaded, as points.

use super::Shade;
use glam::Vec3;
use interreflect_cpu::scene::CpuScene;
use interreflect_scene::{Camera, Mesh, Point, Scene, SurfaceMaterial};
use rayon::prelude::*;

/// Share of the distance to a vertex within which a surface lies at it, its own triangles among them:
/// single precision places a vertex to a ten-millionth.
const AT_VERTEX: f64 = 1e-5;

/// Vertices and the triangles between them.
pub(super) struct Vertices {
    /// One for each vertex; for each corner of a triangle where a mesh has no vertex normals. None
    /// where no triangle with an area is.
    pub(super) points: Vec<Option<Point>>,
    /// The points at each triangle's corners.
    pub(super) triangles: Vec<[u32; 3]>,
    /// For each object, its first triangle.
    pub(super) first_triangle: Vec<u32>,
}

impl Vertices {
    /// The vertices of what is shaded, seen from `eye`. A vertex has the material of
    /// the first triangle that it is a corner of.
    pub(super) fn new(scene: &Scene, eye: Vec3, shade: Shade) -> Self {
        let mut all = Self {
            points: Vec::new(),
            triangles: Vec::new(),
            first_triangle: Vec::new(),
        };
        for object in &scene.objects {
            all.first_triangle.push(all.triangles.len() as u32);
            if shade.shows(scene, object.role) {
                all.add(scene, &object.mesh, eye);
            }
        }
        all
    }

    /// Indices of the vertices that `camera` sees themselves: inside its image, and with nothing
    /// between eye and vertex but what lies at it.
    pub(super) fn visible_points(&self, scene: &CpuScene, camera: &Camera) -> Vec<u32> {
        let geometry = scene.all_objects();
        let eye = camera.eye.as_dvec3();
        let seen = |&i: &u32| {
            let point = self.points[i as usize];
            point.is_some_and(|point| {
                let towards = point.position.as_dvec3() - eye;
                let before = towards.length() * (1.0 - AT_VERTEX);
                camera.shows(point.position) && !geometry.occluded(eye, towards.normalize(), before)
            })
        };
        let all = (0..self.points.len() as u32).into_par_iter();
        all.filter(seen).collect()
    }

    fn add(&mut self, scene: &Scene, mesh: &Mesh, eye: Vec3) {
        let first = self.points.len() as u32;
        let shared = !mesh.normals.is_empty();
        if shared {
            self.points
                .resize(self.points.len() + mesh.positions.len(), None);
        }
        for (t, corners) in mesh.triangles.iter().enumerate() {
            let material = &scene.materials[mesh.materials[t] as usize];
            let flat = mesh.normal(t);
            let points = corners.map(|v| {
                let position = mesh.positions[v as usize];
                let normal = match shared {
                    true => mesh.normals[v as usize],
                    false => flat,
                };
                (normal != Vec3::ZERO).then(|| Point {
                    position,
                    normal,
                    view: (eye - position).normalize_or(normal),
                    material: SurfaceMaterial {
                        diffuse: material.albedo,
                        specular: material.specular,
                        shininess: material.shininess,
                    },
                    footprint: 0.0,
                })
            });
            let indices = match shared {
                true => corners.map(|v| first + v),
                false => {
                    let next = self.points.len() as u32;
                    self.points.extend([None; 3]);
                    [next, next + 1, next + 2]
                }
            };
            for (i, point) in indices.into_iter().zip(points) {
                let place = &mut self.points[i as usize];
                *place = place.or(point);
            }
            self.triangles.push(indices);
        }
    }
}
