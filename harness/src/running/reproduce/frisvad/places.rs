//! The measured Cornell box by its places: walls, shadows, the tall block and what is above it.

use glam::Vec3;
use interreflect_scene::{Estimate, Point};

/// Points of the picture, by where they are in the box.
pub(super) struct Places<'a> {
    pub(super) points: &'a [Point],
    /// Without direct light.
    pub(super) dark: &'a [bool],
}

/// In metres, of the measured box: how near to a wall is on it, where the tall block's front and top are.
const ON_WALL_M: f32 = 1e-3;
const BOX_M: Vec3 = Vec3::new(0.556, 0.5488, 0.5592);
const TALL_TOP_M: f32 = 0.33;
const TALL_MIDDLE_M: Vec3 = Vec3::new(0.3685, 0.165, 0.35125);
const SPOT_M: f32 = 0.08;

impl Places<'_> {
    /// Claim, what is measured, and its value for the map and for the truth.
    pub(super) fn compared(
        &self,
        map: &Estimate,
        (truth, error): (&Estimate, &Estimate),
    ) -> [(&'static str, &'static str, [f64; 2]); 4] {
        let both = |measure: &dyn Fn(&Estimate) -> f64| [measure(map), measure(truth)];
        [
            (
                "C1",
                "spread of bleeding over floor, ceiling and back wall",
                [self.bleeding(map, None), self.bleeding(truth, Some(error))],
            ),
            (
                "C2",
                "irradiance out of direct light over that in it",
                both(&|e| self.in_shadow(e)),
            ),
            (
                "C3",
                "ceiling above the tall block over the ceiling",
                both(&|e| self.spot(e)),
            ),
            (
                "C4",
                "green of the tall block's front over red",
                both(&|e| self.green(e)),
            ),
        ]
    }

    /// Standard deviation of (red − green)/(red + green) over white walls, less what an estimate's own standard
    /// errors add to it.
    fn bleeding(&self, e: &Estimate, error: Option<&Estimate>) -> f64 {
        let on = |p: &Point| {
            let [y, z] = [p.position.y, p.position.z];
            let between = ON_WALL_M..=BOX_M.y - ON_WALL_M;
            !between.contains(&y) || z > BOX_M.z - ON_WALL_M
        };
        let shades: Vec<(f64, f64)> = self
            .at(on)
            .map(|i| {
                let noise = error.map_or(0.0, |error| balance_variance(e.get(i), error.get(i)));
                (balance(e.get(i)), noise)
            })
            .collect();
        let count = shades.len().max(1) as f64;
        let mean = shades.iter().map(|s| s.0).sum::<f64>() / count;
        let square: f64 = shades.iter().map(|s| (s.0 - mean).powi(2) - s.1).sum();
        (square.max(0.0) / count).sqrt()
    }

    /// Mean on the floor without direct light over that with it.
    fn in_shadow(&self, e: &Estimate) -> f64 {
        let floor = |p: &Point| p.position.y < ON_WALL_M;
        let mean = |dark: bool| mean(e, self.at(floor).filter(|&i| self.dark[i] == dark));
        mean(true) / mean(false)
    }

    /// Mean on the ceiling above the tall block over that on all of the ceiling.
    fn spot(&self, e: &Estimate) -> f64 {
        let ceiling = |p: &Point| p.position.y > BOX_M.y - ON_WALL_M;
        let above = |p: &Point| {
            let across = (p.position - TALL_MIDDLE_M) * Vec3::new(1.0, 0.0, 1.0);
            ceiling(p) && across.length() < SPOT_M
        };
        mean(e, self.at(above)) / mean(e, self.at(ceiling))
    }

    /// Green over red on the tall block's front.
    fn green(&self, e: &Estimate) -> f64 {
        let front = |p: &Point| {
            let across = (p.position - TALL_MIDDLE_M) * Vec3::new(1.0, 0.0, 1.0);
            let low = p.position.y > ON_WALL_M && p.position.y < TALL_TOP_M - ON_WALL_M;
            low && across.length() < 0.14 && p.normal.z < -0.5
        };
        let sum = self.at(front).fold(Vec3::ZERO, |sum, i| sum + e.get(i));
        f64::from(sum.y / sum.x)
    }

    fn at<'s>(&'s self, on: impl Fn(&Point) -> bool + 's) -> impl Iterator<Item = usize> + 's {
        let there = self.points.iter().enumerate();
        there.filter(move |(_, p)| on(p)).map(|(i, _)| i)
    }
}

/// (red − green)/(red + green).
fn balance(v: Vec3) -> f64 {
    f64::from((v.x - v.y) / (v.x + v.y).max(f32::MIN_POSITIVE))
}

/// Variance of [`balance`] that independent standard errors of red and green cause, to first order.
fn balance_variance(v: Vec3, error: Vec3) -> f64 {
    let (v, error) = (v.as_dvec3(), error.as_dvec3());
    let square = (v.x + v.y).powi(2).max(f64::MIN_POSITIVE);
    (2.0 * v.y * error.x / square).powi(2) + (2.0 * v.x * error.y / square).powi(2)
}

fn mean(e: &Estimate, at: impl Iterator<Item = usize>) -> f64 {
    let (mut sum, mut count) = (0.0, 0_usize);
    for i in at {
        sum += f64::from(e.get(i).element_sum()) / 3.0;
        count += 1;
    }
    sum / count.max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_found() {
        let at = |x, y, z, normal| Point {
            position: Vec3::new(x, y, z),
            normal,
            ..Point::default()
        };
        let points = [
            at(0.1, 0.0, 0.1, Vec3::Y),
            at(0.2, 0.0, 0.1, Vec3::Y),
            at(0.37, BOX_M.y, 0.35, Vec3::NEG_Y),
            at(0.1, BOX_M.y, 0.1, Vec3::NEG_Y),
            at(0.34, 0.2, 0.27, Vec3::new(0.3, 0.0, -0.95)),
        ];
        let places = Places {
            points: &points,
            dark: &[true, false, true, true, false],
        };
        let mut e = Estimate::new(5);
        for (i, value) in [1.0, 4.0, 3.0, 1.0, 2.0].into_iter().enumerate() {
            e.set(i, Vec3::new(value, 2.0 * value, 0.0));
        }
        assert!((places.in_shadow(&e) - 0.25).abs() < 1e-6);
        assert!((places.spot(&e) - 1.5).abs() < 1e-6);
        assert!((places.green(&e) - 2.0).abs() < 1e-6);
        assert!(places.bleeding(&e, None) < 1e-6);
        e.set(0, Vec3::X);
        let spread = places.bleeding(&e, None);
        let mut error = Estimate::new(5);
        assert!(spread > 0.1 && places.bleeding(&e, Some(&error)) == spread);
        (0..5).for_each(|i| error.set(i, Vec3::splat(9.0)));
        assert_eq!(
            places.bleeding(&e, Some(&error)),
            0.0,
            "all of it may be noise"
        );
    }
}
