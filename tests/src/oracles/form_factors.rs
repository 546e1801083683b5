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

#[cfg(test)]
mod tests {
    use super::super::polygon::polygon_irradiance;
    use super::*;
    use glam::DVec3;

    /// Mean over one face of the irradiance from another, by the midpoint rule, which converges
    /// as 1/n² for opposite faces and as 1/n towards the shared edge of adjacent ones.
    fn mean_over_floor(n: usize, corners: [DVec3; 4]) -> f64 {
        let at = |i: usize| (i as f64 + 0.5) / n as f64;
        let sum: f64 = (0..n * n)
            .map(|k| {
                let x = DVec3::new(at(k % n), at(k / n), 0.0);
                polygon_irradiance(DVec3::Z, &corners.map(|c| c - x)).abs()
            })
            .sum();
        sum / (n * n) as f64 / PI
    }

    #[test]
    fn the_cubes_faces_agree_with_quadrature() {
        let ceiling = [(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)];
        let ceiling = ceiling.map(|(x, y)| DVec3::new(x, y, 1.0));
        let wall = [(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)];
        let wall = wall.map(|(y, z)| DVec3::new(0.0, y, z));
        // Richardson: the midpoint errors fall by 4 (opposite) with each doubling.
        let opposite = (4.0 * mean_over_floor(64, ceiling) - mean_over_floor(32, ceiling)) / 3.0;
        assert!((opposite - CUBE_OPPOSITE).abs() < 1e-8, "{opposite}");
        let adjacent = (4.0 * mean_over_floor(64, wall) - mean_over_floor(32, wall)) / 3.0;
        assert!((adjacent - CUBE_ADJACENT).abs() < 1e-5, "{adjacent}");
        let closure = CUBE_OPPOSITE + 4.0 * CUBE_ADJACENT;
        assert!((closure - 1.0).abs() < 1e-15, "{closure}");
    }
}
