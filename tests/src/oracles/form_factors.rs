//! Closed forms: fractions of the cosine-weighted hemisphere, so that E = π·L·F.

use std::f64::consts::PI;

/// Rectangle of sides a and b parallel to the receiver, one corner straight above it at height c.
pub fn parallel_rectangle(a: f64, b: f64, c: f64) -> f64 {
    let (a, b) = (a / c, b / c);
    let (ra, rb) = ((1.0 + a * a).sqrt(), (1.0 + b * b).sqrt());
    (a / ra * (b / ra).atan() + b / rb * (a / rb).atan()) / (2.0 * PI)
}

/// Rectangle of this height and width perpendicular to the receiver, standing on its plane at this
/// distance, one lower corner straight ahead.
pub fn perpendicular_rectangle(height: f64, width: f64, distance: f64) -> f64 {
    let (x, y) = (height / width, distance / width);
    let r = x.hypot(y);
    ((1.0 / y).atan() - y / r * (1.0 / r).atan()) / (2.0 * PI)
}

/// Two opposite faces of a unit cube.
pub const CUBE_OPPOSITE: f64 = 0.199_824_895_698_387_46;

/// Two adjacent faces of a unit cube.
pub const CUBE_ADJACENT: f64 = 0.200_043_776_075_403_16;

/// Disc of radius `r` parallel to the receiver, its centre straight above at height h.
pub fn coaxial_disc(r: f64, h: f64) -> f64 {
    r * r / (r * r + h * h)
}

/// Disc of radius `r` parallel to the receiver at height h, its centre `a` > 0 off the normal.
pub fn offset_disc(r: f64, h: f64, a: f64) -> f64 {
    let (h, r) = (h / a, r / a);
    let z = 1.0 + h * h + r * r;
    0.5 * (1.0 - (z - 2.0 * r * r) / (z * z - 4.0 * r * r).sqrt())
}

/// Sphere of radius `r` whose centre lies at distance d ≥ r, at angle θ to the receiver's normal.
/// Domain: wholly above the horizon, d·cos θ ≥ r.
pub fn sphere_above_horizon(r: f64, d: f64, cos_theta: f64) -> f64 {
    cos_theta * (r / d).powi(2)
}

/// Openness beside a sphere that is wholly above the horizon; parameters as
/// [`sphere_above_horizon`].
pub fn openness_beside_sphere(r: f64, d: f64, cos_theta: f64) -> f64 {
    1.0 - sphere_above_horizon(r, d, cos_theta)
}

/// Openness where a half-space fills all directions i with m·i < 0; `cos_tilt` = n·m.
pub fn openness_beside_half_space(cos_tilt: f64) -> f64 {
    0.5 * (1.0 + cos_tilt)
}

/// Openness on a floor at distance d from an endless wall of height h.
pub fn openness_beside_wall(h: f64, d: f64) -> f64 {
    1.0 - 0.5 * (1.0 - d / d.hypot(h))
}

/// Openness at the centre of the floor of a pit: the rectangular opening of sides a and b at
/// height h.
pub fn openness_in_pit(a: f64, b: f64, h: f64) -> f64 {
    4.0 * parallel_rectangle(0.5 * a, 0.5 * b, h)
}

/// Factor from disc 1 of radius r₁ to a parallel coaxial disc of radius r₂ at distance h.
pub fn coaxial_discs(r1: f64, r2: f64, h: f64) -> f64 {
    let (r1, r2) = (r1 / h, r2 / h);
    let x = 1.0 + (1.0 + r2 * r2) / (r1 * r1);
    0.5 * (x - (x * x - 4.0 * (r2 / r1).powi(2)).sqrt())
}

/// Radiance inside a furnace whose walls emit 1 and have albedo ρ < 1, after up to k reflections;
/// `None`: any number.
pub fn furnace_radiance(albedo: f64, bounces: Option<i32>) -> f64 {
    let left_out = bounces.map_or(0.0, |k| albedo.powi(k + 1));
    (1.0 - left_out) / (1.0 - albedo)
}

/// Indirect irradiance in W/m² everywhere on the wall of a sphere of radius r and albedo ρ < 1, of
/// a flux of 1 W that first meets its wall; by one reflection, or by any number of them.
pub fn integrating_sphere(albedo: f64, r: f64, all_bounces: bool) -> f64 {
    let first = albedo / (4.0 * PI * r * r);
    if all_bounces {
        first / (1.0 - albedo)
    } else {
        first
    }
}

/// Cosine-weighted mean of Schlick's Fresnel factor F₀ + (1 − F₀)(1 − cos θ)⁵.
pub fn schlick_mean(f0: f64) -> f64 {
    f0 + (1.0 - f0) / 21.0
}

#[cfg(test)]
mod tests;
