//! Sampling what emits: triangles by area times radiance, and the environment map.
//!
//! Sources that fill much of the view are found well enough by directions drawn from the lobe;
//! drawing them as sources too would only add noise. They are left out of the tables, and have
//! density 0 there.

use super::{
    environment::EnvironmentTable,
    sampling::{Cdf, triangle},
    spread::{BROAD, Spread, brightness},
};
use glam::{DVec3, Vec3};
use interreflect_scene::Scene;

/// Everything in a scene that can be drawn as a source of light, but for its delta lights.
#[derive(Clone, Debug, Default)]
pub(crate) struct Emitters {
    triangles: Vec<Emitter>,
    environment: Option<EnvironmentTable>,
    /// Over the triangles, then the environment; `None` if nothing emits.
    choice: Option<Cdf>,
    /// Sum of area × brightness, the environment's share included.
    total: f32,
}

#[derive(Clone, Copy, Debug)]
struct Emitter {
    corners: [Vec3; 3],
    normal: Vec3,
    radiance: Vec3,
}

/// A direction in which a source was drawn, with what arrives if nothing is between.
pub(super) struct Source {
    /// Unit, in f64: a shadow ray that grazes the source has to end before it.
    pub(super) direction: DVec3,
    /// Metres; +∞ for the environment.
    pub(super) distance: f64,
    pub(super) radiance: Vec3,
    /// Density in sr⁻¹.
    pub(super) density: f32,
}

impl Emitters {
    /// Collects the emitting triangles of a soup, and the scene's environment; `emission` gives a
    /// triangle's radiance and unit normal.
    pub(crate) fn new(
        scene: &Scene,
        soup: &[[Vec3; 3]],
        emission: impl Fn(u32) -> (Vec3, Vec3),
    ) -> Self {
        let (mut weights, mut triangles) = (Vec::new(), Vec::new());
        let mut spread = Spread::default();
        for (index, &corners) in soup.iter().enumerate() {
            let (radiance, normal) = emission(index as u32);
            let [a, b, c] = corners.map(Vec3::as_dvec3);
            let area = 0.5 * (b - a).cross(c - a).length();
            spread.add(area, brightness(radiance));
            if brightness(radiance) > 0.0 && area > 0.0 {
                weights.push(area * f64::from(brightness(radiance)));
                triangles.push(Emitter {
                    corners,
                    normal,
                    radiance,
                });
            }
        }
        if spread.part() > BROAD {
            weights.clear();
            triangles.clear();
        }
        let environment = scene.environment.as_ref().and_then(EnvironmentTable::new);
        if let Some(table) = &environment {
            // The environment shines through a disc as wide as the scene: π r² ∫ L dω against π A L.
            weights.push(f64::from(table.total()) * squared_radius(soup));
        }
        let (choice, total) = Cdf::new(weights.into_iter()).unzip();
        Self {
            triangles,
            environment,
            choice,
            total: total.unwrap_or(0.0) as f32,
        }
    }

    /// Draws a source as seen from `x`; `None` if nothing emits or the source faces away.
    pub(super) fn sample(&self, x: DVec3, [choice, u, v, _]: [f32; 4]) -> Option<Source> {
        let (index, _) = self.choice.as_ref()?.sample(choice);
        let Some(emitter) = self.triangles.get(index) else {
            let table = self.environment.as_ref()?;
            let (direction, density) = table.sample(u, v);
            return Some(Source {
                direction: direction.as_dvec3(),
                distance: f64::INFINITY,
                radiance: table.radiance(direction),
                density: density * self.probability(index),
            });
        };
        let at: DVec3 = emitter
            .corners
            .iter()
            .zip(triangle(u, v))
            .map(|(corner, weight)| corner.as_dvec3() * f64::from(weight))
            .sum();
        let distance = (at - x).length();
        let direction = (at - x) / distance;
        let cos_source = -emitter.normal.dot(direction.as_vec3());
        (cos_source > 0.0 && distance > 0.0).then(|| Source {
            direction,
            distance,
            radiance: emitter.radiance,
            density: self.density_of_surface(emitter.radiance, distance, cos_source),
        })
    }

    /// Density in sr⁻¹ with which [`Emitters::sample`] draws a direction to a surface point that
    /// emits `radiance`: brightness/total per area, times d²/cos θ.
    pub(super) fn density_of_surface(&self, radiance: Vec3, distance: f64, cos_source: f32) -> f32 {
        if self.triangles.is_empty() || cos_source <= 0.0 {
            return 0.0;
        }
        let per_area = brightness(radiance) / self.total;
        per_area * (distance * distance / f64::from(cos_source)) as f32
    }

    /// Density in sr⁻¹ with which [`Emitters::sample`] draws a direction to the environment.
    pub(super) fn density_of_environment(&self, direction: Vec3) -> f32 {
        match &self.environment {
            Some(table) => table.density(direction) * self.probability(self.triangles.len()),
            None => 0.0,
        }
    }

    fn probability(&self, index: usize) -> f32 {
        self.choice.as_ref().map_or(0.0, |c| c.probability(index))
    }
}

/// Squared radius of the sphere around a soup's bounding box; 1 without triangles.
fn squared_radius(soup: &[[Vec3; 3]]) -> f64 {
    let mut corners = soup.iter().flatten().copied();
    let Some(first) = corners.next() else {
        return 1.0;
    };
    let (low, high) = corners.fold((first, first), |(l, h), c| (l.min(c), h.max(c)));
    0.25 * (high - low).as_dvec3().length_squared()
}
