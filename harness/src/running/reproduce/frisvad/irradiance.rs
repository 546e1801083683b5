//! Irradiance as light of its mean colour, as what surfaces reflect of it, and by its colours.

use glam::{DVec3, Vec3};
use interreflect_scene::{Estimate, Points};

/// The same colour at every point that has a surface: the mean of all.
pub(super) fn uniform(of: &Estimate, points: &Points) -> Estimate {
    let surfaces: Vec<usize> = (0..points.len())
        .filter(|&i| points.get(i).is_some())
        .collect();
    let total: DVec3 = surfaces.iter().map(|&i| of.get(i).as_dvec3()).sum();
    let mean = (total / surfaces.len().max(1) as f64).as_vec3();
    let mut all = Estimate::new(of.len());
    for i in surfaces {
        all.set(i, mean);
    }
    all
}

/// Sum over points.
pub(super) fn sum(estimate: &Estimate) -> DVec3 {
    estimate.iter().map(|v| v.as_dvec3()).sum()
}

/// Pearson's correlation of red less green over their sum, weighted by the second one's sum: colours of
/// what is nearly black are noise.
pub(super) fn correlation(a: &Estimate, b: &Estimate) -> f64 {
    let colour = |v: Vec3| {
        let v = v.as_dvec3();
        let sum = v.x + v.y;
        (sum > 0.0).then(|| ((v.x - v.y) / sum, sum))
    };
    let pairs = a.iter().zip(b.iter()).filter_map(|(a, b)| {
        let (a, (b, weight)) = (colour(a)?.0, colour(b)?);
        Some((a, b, weight))
    });
    let pairs: Vec<(f64, f64, f64)> = pairs.collect();
    let total: f64 = pairs.iter().map(|p| p.2).sum();
    let mean =
        |f: &dyn Fn(f64, f64) -> f64| pairs.iter().map(|p| p.2 * f(p.0, p.1)).sum::<f64>() / total;
    let (ma, mb) = (mean(&|a, _| a), mean(&|_, b| b));
    let covariance = mean(&|a, b| (a - ma) * (b - mb));
    covariance / (mean(&|a, _| (a - ma).powi(2)) * mean(&|_, b| (b - mb).powi(2))).sqrt()
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::of;
    use super::*;
    use interreflect_scene::{Point, PointLayout};

    #[test]
    fn ambient_light_is_the_mean() {
        let points = Points::new(
            PointLayout::Surface,
            [Some(Point::default()), None, Some(Point::default())],
        );
        let mean = uniform(&of(&[1.0, 7.0, 3.0]), &points);
        let found: Vec<f32> = mean.iter().map(|v| v.y).collect();
        assert_eq!(found, [2.0, 0.0, 2.0]);
        assert_eq!(sum(&of(&[1.0, 2.0])), DVec3::splat(3.0));
    }

    #[test]
    fn opposite_colours_correlate_negatively() {
        let (mut a, mut b) = (Estimate::new(3), Estimate::new(3));
        for (i, share) in [0.2_f32, 0.5, 0.8].into_iter().enumerate() {
            a.set(i, Vec3::new(share, 1.0 - share, 0.0));
            b.set(i, Vec3::new(1.0 - share, share, 0.0));
        }
        assert!((correlation(&a, &b) + 1.0).abs() < 1e-6);
    }

    #[test]
    fn colours_correlate_whatever_their_brightness() {
        let (mut a, mut b) = (Estimate::new(4), Estimate::new(4));
        for i in 0..4 {
            let red = i as f32;
            a.set(i, Vec3::new(red, 3.0, 0.0));
            b.set(i, Vec3::new(red, 3.0, 1.0) * (1.0 + red));
        }
        assert!((correlation(&a, &b) - 1.0).abs() < 1e-9);
    }
}
