//! The coarse solution that captures may hold: irradiance at vertices, by Jacobi iteration.
//!
//! E_1 is what arrives from emission, from infinity and from surfaces that the lights reach; E_k is
//! that and what surfaces reflect of E_{k−1}. All E_k use the same rays, shot once.

use super::estimator::Estimator;
use super::lobe::Lobe;
use super::sampling::{Sample, hash};
use crate::direct;
use crate::scene::CpuScene;
use glam::{DVec3, Vec3};
use interreflect_scene::coarse_irradiance::CoarseVertex;
use interreflect_scene::{CoarseIrradiance, LightPaths, Role};
use rayon::prelude::*;
use std::f32::consts::PI;
use std::time::Instant;

/// Rays from each side of a vertex, where vertices are few.
const MOST_RAYS: u32 = 256;

/// Rays from each side of a vertex, where vertices are many.
const FEWEST_RAYS: u32 = 4;

/// Rays in all: above it, each vertex gets fewer, down to the fewest. A few seconds on two cores,
/// with one light.
const RAYS: usize = 1 << 23;

/// A coarse solution and what it took.
#[derive(Clone, Debug, PartialEq)]
pub struct CoarseSolution {
    /// The irradiance.
    pub irradiance: CoarseIrradiance,
    /// Time that it took, in milliseconds.
    pub ms: f64,
}

impl CoarseSolution {
    /// Gathers at the vertices on the environment objects; receivers are absent.
    ///
    /// Directions are drawn from the cosine by a sequence of each vertex's own, emitters and the
    /// environment are sampled as well. The result does not depend on the number of threads.
    pub(crate) fn new(scene: &CpuScene, bounces: u32) -> Self {
        let start = Instant::now();
        let mut irradiance = CoarseIrradiance::dark(scene.scene(), bounces);
        let places = Place::all(scene, &irradiance);
        let share = (RAYS / (2 * places.len()).max(1)).max(1) as u32;
        let rays = (1 << share.ilog2()).clamp(FEWEST_RAYS, MOST_RAYS);
        let paths = LightPaths {
            self_shadowing: false,
            ..LightPaths::default()
        };
        let estimator = Estimator::new(scene, &paths);
        let gathered: Vec<[Gathered; 2]> = places
            .par_iter()
            .enumerate()
            .map(|(vertex, place)| {
                [1.0, -1.0].map(|side| {
                    let normal = place.normal * side;
                    let seed = hash(2 * vertex as u64 + u64::from(side < 0.0)) as u32;
                    match place.albedo == Vec3::ZERO {
                        true => Gathered::default(),
                        false => {
                            Gathered::new(scene, &estimator, place.position, normal, seed, rays)
                        }
                    }
                })
            })
            .collect();
        for _ in 0..bounces {
            let albedos = places.iter().map(|place| place.albedo);
            let reflected = irradiance.values().iter().zip(albedos);
            let reflected: Vec<_> = reflected.map(|(e, rho)| e.map(|e| rho * e)).collect();
            irradiance.set_values(reflected);
            let next: Vec<_> = gathered
                .par_iter()
                .map(|sides| [0, 1].map(|i| sides[i].irradiance(&irradiance, rays)))
                .collect();
            irradiance.set_values(next);
        }
        Self {
            irradiance,
            ms: start.elapsed().as_secs_f64() * 1e3,
        }
    }
}

/// Where a vertex gathers.
struct Place {
    position: DVec3,
    /// Unit normal of the front; 0 without an area.
    normal: Vec3,
    /// ρ; 0 for a mirror, and without an area.
    albedo: Vec3,
}

impl Place {
    /// Every vertex, in the order of the solution's values.
    fn all(scene: &CpuScene, solution: &CoarseIrradiance) -> Vec<Self> {
        let objects = scene.scene().objects_of(Role::Environment);
        let triangles: Vec<_> = objects
            .flat_map(|o| (0..o.mesh.triangles.len()).map(move |t| (&o.mesh, t)))
            .collect();
        let place = |vertex: CoarseVertex| {
            let (mesh, t) = triangles[vertex.triangle as usize];
            let corners = mesh.corners(t).map(|c| c.as_dvec3());
            let material = &scene.scene().materials[mesh.materials[t] as usize];
            let normal = mesh.normal(t);
            let reflects = !material.mirror && normal != Vec3::ZERO;
            Self {
                position: corners
                    .iter()
                    .zip(vertex.barycentric)
                    .map(|(&c, w)| c * w)
                    .sum(),
                normal,
                albedo: if reflects {
                    material.albedo
                } else {
                    Vec3::ZERO
                },
            }
        };
        solution.vertices().map(place).collect()
    }
}

/// What one side of a vertex sees.
#[derive(Default)]
struct Gathered {
    /// Sum over all rays of the irradiance from sources, and from surfaces that the lights reach.
    sources: Vec3,
    /// The surfaces that rays met.
    seen: Vec<Seen>,
}

/// A place on a surface.
struct Seen {
    triangle: u32,
    barycentric: [f32; 2],
    front: bool,
}

impl Gathered {
    fn new(
        scene: &CpuScene,
        estimator: &Estimator<'_>,
        position: DVec3,
        normal: Vec3,
        seed: u32,
        rays: u32,
    ) -> Self {
        let lobe = Lobe::cosine(normal);
        let objects = scene.environment_objects();
        let mut gathered = Self::default();
        for ray in 0..rays {
            let sample = Sample::new(ray, seed);
            let (sources, met) = estimator.sources(position, &lobe, sample);
            gathered.sources += sources;
            if let Some(at) = met {
                gathered.sources += PI * direct::reflected(scene, objects, &at, None);
                gathered.seen.push(Seen {
                    triangle: at.triangle,
                    barycentric: at.barycentric,
                    front: at.front,
                });
            }
        }
        gathered
    }

    /// Irradiance with what surfaces reflect of an earlier solution, given as ρ·E: each ray stands for
    /// π sr of cosine-weighted directions, ρ/π·E of radiance.
    fn irradiance(&self, reflected: &CoarseIrradiance, rays: u32) -> Vec3 {
        let at = |s: &Seen| reflected.at(s.triangle, s.barycentric, s.front);
        let seen: Vec3 = self.seen.iter().map(at).sum();
        (self.sources + seen) / rays as f32
    }
}
