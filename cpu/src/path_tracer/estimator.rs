//! One sample of the light that arrives at a point.
//!
//! Every leg is estimated by two techniques, drawing a direction from the lobe and drawing a
//! source, combined by the balance heuristic (Veach, Robust Monte Carlo Methods, 1997, §9.2).
//! Lights without extent are added at every vertex but the point itself. Surfaces scatter by
//! their triangles' own normals, as captures have it; mirrors reflect by the interpolated ones.

use super::{PathQuantity, lobe::Lobe, sampling::Sample};
use crate::{
    direct,
    scene::{CpuScene, Geometry, SurfaceHit},
};
use glam::{DVec3, Vec3};
use interreflect_scene::{LightPaths, Point};

/// Bounces before Russian roulette begins.
const CERTAIN_BOUNCES: u32 = 3;
/// Largest probability of going on, so that paths between perfect reflectors end as well.
const LARGEST_SURVIVAL: f32 = 0.95;

/// A scene with the choice of light paths.
pub(super) struct Estimator<'a> {
    scene: &'a CpuScene,
    paths: LightPaths,
    /// What the gather leg meets.
    first: &'a Geometry,
    /// What all later legs meet.
    later: &'a Geometry,
}

/// A point made ready to be sampled.
pub(super) struct Gather {
    origin: DVec3,
    lobe: Lobe,
    openness: bool,
}

impl<'a> Estimator<'a> {
    pub(super) fn new(scene: &'a CpuScene, paths: &LightPaths) -> Self {
        let later = match paths.self_shadowing {
            true => scene.all_objects(),
            false => scene.environment_objects(),
        };
        let first = match paths.environment_at_infinity {
            true => scene.environment_objects(),
            false => later,
        };
        Self {
            scene,
            paths: *paths,
            first,
            later,
        }
    }

    /// `None` if the point's position, normal or material is not a number.
    pub(super) fn gather(&self, point: &Point, quantity: PathQuantity) -> Option<Gather> {
        let normal = point.normal.try_normalize()?;
        let m = &point.material;
        let finite = point.position.is_finite()
            && point.view.is_finite()
            && m.diffuse.is_finite()
            && m.specular.is_finite()
            && m.shininess.is_finite();
        let lifted = self.first.above(point.position, normal);
        finite.then(|| Gather {
            origin: match self.paths.environment_at_infinity {
                true => self.scene.scene().reference_point.as_dvec3(),
                false => lifted,
            },
            lobe: match quantity {
                PathQuantity::GlossyRadiance => Lobe::of_point(normal, point),
                _ => Lobe::cosine(normal),
            },
            openness: quantity == PathQuantity::AmbientOcclusion,
        })
    }

    /// One sample of the quantity.
    pub(super) fn sample(&self, at: &Gather, sample: Sample) -> Vec3 {
        let [u, v, choice, _] = sample.set(0);
        let drawn = at.lobe.sample([u, v, choice]);
        if at.openness {
            let open = drawn.is_some_and(|d| self.open(at.origin, d.direction));
            return Vec3::splat(f32::from(u8::from(open)));
        }
        let unhidden = !self.paths.indirect_visibility;
        let mut sum = self.counted(0, || {
            self.drawn_source(self.first, at.origin, &at.lobe, unhidden, sample.set(1))
        });
        if let Some(drawn) = drawn {
            let arriving = self.arriving(at.origin, drawn.direction, drawn.density, sample);
            sum += drawn.weight * arriving;
        }
        sum
    }

    /// One sample of the irradiance from emission and from infinity on the side of a surface that
    /// `lobe`, a plain cosine, lies on; and the surface that the drawn direction met.
    pub(super) fn sources(
        &self,
        origin: DVec3,
        lobe: &Lobe,
        sample: Sample,
    ) -> (Vec3, Option<SurfaceHit>) {
        let objects = self.first;
        let [u, v, choice, _] = sample.set(0);
        let mut sum = self.drawn_source(objects, origin, lobe, false, sample.set(1));
        let Some(drawn) = lobe.sample([u, v, choice]) else {
            return (sum, None);
        };
        let density = Some(drawn.density);
        let start = objects.ray_start();
        let met = self.scene.closest(objects, origin, drawn.direction, start);
        let found = self.source(objects, met.as_ref(), drawn.direction, density);
        sum += drawn.weight * found;
        (sum, met)
    }

    /// Light that arrives after this many reflections, if such paths count.
    fn counted(&self, reflections: u32, light: impl FnOnce() -> Vec3) -> Vec3 {
        match reflections >= self.paths.least_bounces {
            true => light(),
            false => Vec3::ZERO,
        }
    }

    fn open(&self, origin: DVec3, direction: Vec3) -> bool {
        let direction = direction.as_dvec3();
        let bvh = self.first.bvh();
        !self.paths.indirect_visibility || !bvh.occluded(origin, direction, 0.0, f64::INFINITY)
    }

    /// Radiance along the gather leg, drawn from the lobe with a density.
    fn arriving(&self, origin: DVec3, direction: Vec3, density: f32, sample: Sample) -> Vec3 {
        let density = Some(density);
        let source = |surface: Option<&SurfaceHit>| {
            self.counted(0, || self.source(self.first, surface, direction, density))
        };
        let reflected = |surface| self.reflected(surface, direction, sample);
        if self.paths.indirect_visibility {
            let met = self.scene.closest(self.first, origin, direction, 0.0);
            return source(met.as_ref()) + met.map_or(Vec3::ZERO, reflected);
        }
        let along = direction.as_dvec3();
        let hits = self.first.bvh().all(origin, along, 0.0).into_iter();
        let surfaces = hits.map(|hit| self.scene.surface(self.first, origin, along, hit));
        surfaces
            .map(|surface| source(Some(&surface)) + reflected(surface))
            .sum::<Vec3>()
            + source(None)
    }

    /// Radiance that a surface reflects back along the leg that found it.
    fn reflected(&self, mut at: SurfaceHit, mut direction: Vec3, sample: Sample) -> Vec3 {
        let mut sum = Vec3::ZERO;
        let mut throughput = Vec3::ONE;
        let unlimited = self.paths.bounces == 0;
        for bounce in 1.. {
            if !unlimited && bounce > self.paths.bounces {
                break;
            }
            let [u, v, choice, roulette] = sample.set(2 * bounce);
            if unlimited && bounce > CERTAIN_BOUNCES {
                let survival = throughput.max_element().min(LARGEST_SURVIVAL);
                if roulette >= survival {
                    break;
                }
                throughput /= survival;
            }
            let density = if at.material.mirror {
                throughput *= at.material.specular;
                direction = direction.reflect(at.shading_normal);
                None
            } else {
                let lobe = Lobe::of_material(at.geometric_normal, -direction, &at.material);
                sum += throughput * self.counted(bounce, || self.reflected_direct(&at, &lobe));
                let set = sample.set(2 * bounce + 1);
                sum += throughput
                    * self.counted(bounce, || {
                        self.drawn_source(self.later, at.position, &lobe, false, set)
                    });
                let Some(drawn) = lobe.sample([u, v, choice]) else {
                    break;
                };
                throughput *= drawn.weight;
                direction = drawn.direction;
                Some(drawn.density)
            };
            // Reflection by an interpolated normal may lead behind the triangle.
            let behind = direction.dot(at.geometric_normal) <= 0.0;
            if behind || throughput.max_element() <= 0.0 {
                break;
            }
            let start = self.later.ray_start();
            let met = self
                .scene
                .closest(self.later, at.position, direction, start);
            let source = || self.source(self.later, met.as_ref(), direction, density);
            sum += throughput * self.counted(bounce, source);
            let Some(next) = met else { break };
            at = next;
        }
        sum
    }

    /// Reflected light of the scene's lights.
    fn reflected_direct(&self, at: &SurfaceHit, lobe: &Lobe) -> Vec3 {
        direct::arriving(self.scene, self.later, at)
            .map(|light| light.irradiance * lobe.evaluate(light.to_light).0)
            .sum()
    }

    /// Light of a drawn source, weighted against drawing its direction from the lobe. Nothing
    /// occludes an `unhidden` leg.
    fn drawn_source(
        &self,
        objects: &Geometry,
        origin: DVec3,
        lobe: &Lobe,
        unhidden: bool,
        set: [f32; 4],
    ) -> Vec3 {
        let Some(source) = objects.emitters().sample(origin, set) else {
            return Vec3::ZERO;
        };
        let (value, density) = lobe.evaluate(source.direction.as_vec3());
        if density <= 0.0 {
            return Vec3::ZERO;
        }
        if !unhidden && objects.occluded(origin, source.direction, source.distance) {
            return Vec3::ZERO;
        }
        value * source.radiance / (source.density + density)
    }

    /// Light of the source that a direction of the lobe has found: a surface, or the environment.
    fn source(
        &self,
        objects: &Geometry,
        met: Option<&SurfaceHit>,
        direction: Vec3,
        density: Option<f32>,
    ) -> Vec3 {
        match met {
            Some(surface) => self.emitted(objects, surface, direction, density),
            None => self.environment(objects, direction, density),
        }
    }

    /// Emission of a surface found by a direction of the lobe, weighted against drawing it as a
    /// source; whole if the direction had no density (a mirror's).
    fn emitted(
        &self,
        objects: &Geometry,
        at: &SurfaceHit,
        direction: Vec3,
        density: Option<f32>,
    ) -> Vec3 {
        let radiance = at.material.emission;
        if !at.front || radiance == Vec3::ZERO {
            return Vec3::ZERO;
        }
        let cos_source = -at.geometric_normal.dot(direction);
        let source = objects
            .emitters()
            .density_of_surface(radiance, at.distance, cos_source);
        radiance * balance(density, source)
    }

    /// Radiance of the environment, weighted likewise.
    fn environment(&self, objects: &Geometry, direction: Vec3, density: Option<f32>) -> Vec3 {
        match &self.scene.scene().environment {
            Some(environment) => {
                let source = objects.emitters().density_of_environment(direction);
                environment.radiance(direction) * balance(density, source)
            }
            None => Vec3::ZERO,
        }
    }
}

/// Balance heuristic: the share of the technique with `density` against one with `other`.
fn balance(density: Option<f32>, other: f32) -> f32 {
    density.map_or(1.0, |d| d / (d + other))
}
