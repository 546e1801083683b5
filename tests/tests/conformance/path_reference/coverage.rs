//! Standard errors are worth their name: two of them hold the truth as often as chance says.

use super::{Ask, IRRADIANCE};
use crate::ensure;
use crate::test_scenes::TestScene;
use crate::variants::Outcome;
use glam::DVec3;
use interreflect_scene::library::library;
use interreflect_scene::{PointLayout, Points};
use libtest_mimic::Trial;

/// Seeds for each scene.
const SEEDS: u64 = 400;

/// Points in each scene: with all seeds and channels some 30,000 intervals.
const POINTS: usize = 24;

/// Values that move by less than this from seed to seed, relative to themselves, have no noise to cover: their
/// errors are what samples can't tell, and hold the truth more often.
const NOISELESS: f64 = 1e-3;

/// Shares of all intervals of two standard errors that may hold the truth; 95.45 % of a normal variable's do.
const COVERED: std::ops::RangeInclusive<f64> = 0.93..=0.97;

pub(super) fn trials() -> Vec<Trial> {
    let trial = |name: &'static str| {
        let named = format!("path_reference/coverage/{name}");
        Trial::test(named, move || covers(name))
    };
    library().iter().map(|scene| trial(scene.name)).collect()
}

/// With few samples, where replicates are most skewed: one value of each seed against the mean of all others.
fn covers(name: &'static str) -> Outcome {
    let test_scene = TestScene::library(name, &[]);
    let all: Vec<_> = test_scene.points(PointLayout::Material).iter().collect();
    let step = all.len().div_ceil(POINTS);
    let points = Points::new(PointLayout::Material, all.into_iter().step_by(step));
    let ask = Ask {
        samples: 64,
        ..IRRADIANCE
    };
    let traced: Vec<_> = (0..SEEDS)
        .map(|seed| ask.seeded(seed).trace(&test_scene.cpu, &points))
        .collect();
    let (mut noisy, mut noiseless) = (Share::default(), Share::default());
    for point in 0..points.len() {
        let values: Vec<DVec3> = traced
            .iter()
            .map(|t| t.mean.get(point).as_dvec3())
            .collect();
        let count = SEEDS as f64;
        let mean = values.iter().sum::<DVec3>() / count;
        let square = values.iter().map(|v| (*v - mean).powf(2.0)).sum::<DVec3>() / count;
        for channel in 0..3 {
            let moves = square[channel].sqrt() > NOISELESS * mean[channel];
            let share = if moves { &mut noisy } else { &mut noiseless };
            for (value, traced) in values.iter().zip(&traced) {
                // From the mean of the others.
                let off = (value[channel] - mean[channel]).abs() * count / (count - 1.0);
                let error = f64::from(traced.standard_error.get(point)[channel]);
                share.add(off <= 2.0 * error);
            }
        }
    }
    println!(
        "{name}: two standard errors hold the truth in {:.2} % of {} intervals with noise, {:.2} % of {} without",
        noisy.percent(),
        noisy.of,
        noiseless.percent(),
        noiseless.of
    );
    let (least, most) = (*COVERED.start(), *COVERED.end());
    let (found, quiet) = (noisy.percent() / 100.0, noiseless.percent() / 100.0);
    ensure!(
        noisy.of == 0 || (least..=most).contains(&found),
        "{found:.4} with noise"
    );
    ensure!(
        noiseless.of == 0 || quiet >= least,
        "{quiet:.4} without noise"
    );
    Ok(())
}

/// How many of so many.
#[derive(Default)]
struct Share {
    held: u32,
    of: u32,
}

impl Share {
    fn add(&mut self, holds: bool) {
        self.held += u32::from(holds);
        self.of += 1;
    }

    fn percent(&self) -> f64 {
        100.0 * f64::from(self.held) / f64::from(self.of.max(1))
    }
}
