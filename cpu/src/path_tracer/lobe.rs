//! How incident radiance is weighted at a point: a Lambertian and a Blinn–Phong lobe.

use super::sampling;
use glam::{Quat, Vec3};
use interreflect_scene::{Material, Point, material::blinn_phong_normalisation};
use std::f32::consts::{FRAC_1_PI, PI, TAU};

/// k_d/π + k_s·norm(n)·(N·H)ⁿ, times (N·I)⁺ (SPEC: the glossy lobe of every method here).
#[derive(Clone, Copy, Debug)]
pub(super) struct Lobe {
    normal: Vec3,
    world_from_normal: Quat,
    to_viewer: Vec3,
    diffuse: Vec3,
    /// k_s times the normalisation.
    specular: Vec3,
    shininess: f32,
    /// Probability of sampling the diffuse lobe.
    choose_diffuse: f32,
}

/// A sampled incident direction.
pub(super) struct Sampled {
    pub(super) direction: Vec3,
    /// Lobe × cosine / density.
    pub(super) weight: Vec3,
    /// Density in sr⁻¹.
    pub(super) density: f32,
}

impl Lobe {
    /// The plain cosine: integrates incident radiance to irradiance.
    pub(super) fn cosine(normal: Vec3) -> Self {
        Self::new(normal, Vec3::ZERO, Vec3::splat(PI), Vec3::ZERO, 0.0)
    }

    /// Reflection of a surface that is not a mirror.
    pub(super) fn of_material(normal: Vec3, to_viewer: Vec3, material: &Material) -> Self {
        let m = material;
        Self::new(normal, to_viewer, m.albedo, m.specular, m.shininess)
    }

    /// Reflection at a shaded point with a unit normal.
    pub(super) fn of_point(normal: Vec3, point: &Point) -> Self {
        let m = &point.material;
        Self::new(normal, point.view, m.diffuse, m.specular, m.shininess)
    }

    fn new(normal: Vec3, to_viewer: Vec3, diffuse: Vec3, specular: Vec3, shininess: f32) -> Self {
        let (d, s) = (diffuse.max_element(), specular.max_element());
        let shininess = shininess.max(0.0);
        Self {
            normal,
            world_from_normal: sampling::world_from_normal(normal),
            to_viewer,
            diffuse,
            specular: specular * blinn_phong_normalisation(f64::from(shininess)) as f32,
            shininess,
            choose_diffuse: if s > 0.0 { d / (d + s) } else { 1.0 },
        }
    }

    /// Lobe × cosine towards a unit direction, and the density of [`Lobe::sample`] there.
    pub(super) fn evaluate(&self, incident: Vec3) -> (Vec3, f32) {
        let cos_theta = self.normal.dot(incident);
        if cos_theta <= 0.0 {
            return (Vec3::ZERO, 0.0);
        }
        let mut lobe = self.diffuse * FRAC_1_PI;
        let mut density = self.choose_diffuse * cos_theta * FRAC_1_PI;
        if self.choose_diffuse < 1.0 {
            let half = (incident + self.to_viewer).normalize_or_zero();
            let power = self.normal.dot(half).max(0.0).powf(self.shininess);
            lobe += self.specular * power;
            density += (1.0 - self.choose_diffuse) * self.specular_density(half, power);
        }
        (lobe * cos_theta, density)
    }

    /// Draws a direction by u, v and the choice of lobe; `None` below the horizon.
    pub(super) fn sample(&self, [u, v, choice]: [f32; 3]) -> Option<Sampled> {
        let direction = if choice < self.choose_diffuse {
            self.world_from_normal * sampling::cosine_hemisphere(u, v)
        } else {
            let half = self.world_from_normal * sampling::cosine_power(self.shininess, u, v);
            half * (2.0 * self.to_viewer.dot(half)) - self.to_viewer
        };
        let (value, density) = self.evaluate(direction);
        (density > 0.0).then(|| Sampled {
            direction,
            weight: value / density,
            density,
        })
    }

    /// Density of incident directions when H has density (n+1)/(2π)·(N·H)ⁿ: dω_I = 4(V·H) dω_H.
    fn specular_density(&self, half: Vec3, power: f32) -> f32 {
        let jacobian = 4.0 * self.to_viewer.dot(half);
        if jacobian <= 0.0 {
            return 0.0;
        }
        (self.shininess + 1.0) / TAU * power / jacobian
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Midpoint rule over the sphere.
    fn integrate(f: impl Fn(Vec3) -> f32) -> f64 {
        let (rows, columns) = (1000, 2000);
        let mut sum = 0.0;
        for r in 0..rows {
            let z = 1.0 - (2 * r + 1) as f32 / rows as f32;
            let radius = (1.0 - z * z).sqrt();
            for c in 0..columns {
                let (s, k) = ((c as f32 + 0.5) * TAU / columns as f32).sin_cos();
                sum += f64::from(f(Vec3::new(radius * k, radius * s, z)));
            }
        }
        sum * 4.0 * std::f64::consts::PI / f64::from(rows * columns)
    }

    fn lobes() -> impl Iterator<Item = Lobe> {
        let normal = Vec3::new(0.3, 0.4, 0.866).normalize();
        let view = Vec3::new(-0.5, 0.6, 0.7).normalize();
        [
            (0.6, 0.0, 5.0),
            (0.3, 0.5, 5.0),
            (0.0, 0.7, 40.0),
            (0.2, 0.2, 0.0),
        ]
        .into_iter()
        .map(move |(d, s, n)| Lobe::new(normal, view, Vec3::splat(d), Vec3::splat(s), n))
    }

    #[test]
    fn sampled_directions_estimate_the_lobes_integral() {
        for lobe in lobes() {
            let exact = integrate(|d| lobe.evaluate(d).0.x);
            let count = 1 << 16;
            let sum: f64 = (0..count)
                .map(|i| sampling::Sample::new(i, 7).set(0))
                .filter_map(|[u, v, choice, _]| lobe.sample([u, v, choice]))
                .map(|s| f64::from(s.weight.x))
                .sum();
            let estimate = sum / f64::from(count);
            // The midpoint rule and 65 536 Sobol samples are each good to about 1e-4.
            assert!(
                (estimate / exact - 1.0).abs() < 5e-4,
                "{estimate} for {exact}: {lobe:?}"
            );
        }
    }

    #[test]
    fn densities_stay_below_one_and_reflection_conserves_energy() {
        for lobe in lobes() {
            let drawn = integrate(|d| lobe.evaluate(d).1);
            assert!(drawn <= 1.0 + 1e-3, "density integrates to {drawn}");
            assert!(integrate(|d| lobe.evaluate(d).0.x) < 1.0);
        }
    }

    #[test]
    fn a_head_on_beam_is_reflected_whole() {
        for n in [0.0, 1.0, 5.0, 100.0] {
            let lobe = Lobe::new(Vec3::Z, Vec3::Z, Vec3::ZERO, Vec3::ONE, n);
            let albedo = integrate(|d| lobe.evaluate(d).0.x);
            assert!((albedo - 1.0).abs() < 1e-3, "n = {n}: {albedo}");
        }
    }
}
