//! The path tracer on trial: against exact answers, against itself, and light paths that add up.

mod coverage;
mod exact;
mod form_factors;
mod images;
mod openness;
mod scenes;
mod selections;
mod skies;

use crate::ensure;
use crate::variants::{CPU, Outcome};
use interreflect_conformance::statistics::{Disagreement, Scores};
use interreflect_cpu::path_tracer::{PathQuantity, Stop, Traced, trace};
use interreflect_cpu::scene::CpuScene;
use interreflect_scene::{LightPaths, Points};
use libtest_mimic::Trial;

pub(crate) fn trials() -> Vec<Trial> {
    let groups = [
        exact::trials(),
        form_factors::trials(),
        skies::trials(),
        openness::trials(),
        images::trials(),
        selections::trials(),
        coverage::trials(),
    ];
    groups.into_iter().flatten().collect()
}

/// What is traced, but for the scene and its points.
#[derive(Clone, Copy)]
struct Ask {
    quantity: PathQuantity,
    paths: LightPaths,
    samples: u32,
    seed: u64,
}

/// Irradiance by full light transport.
const IRRADIANCE: Ask = Ask {
    quantity: PathQuantity::Irradiance,
    paths: LightPaths::ALL,
    samples: 1024,
    seed: 1,
};

impl Ask {
    /// The same of other light paths.
    fn of(self, paths: LightPaths) -> Self {
        Self { paths, ..self }
    }

    /// The same with another seed.
    fn seeded(self, seed: u64) -> Self {
        Self { seed, ..self }
    }

    fn trace(&self, scene: &CpuScene, points: &Points) -> Traced {
        let stop = Stop {
            samples: Some(self.samples),
            ..Stop::default()
        };
        let (quantity, seed) = (self.quantity, self.seed);
        CPU.install(|| trace(scene, points, quantity, &self.paths, &stop, seed, &|_| {}))
    }
}

/// The scores are chance, of estimates with at most this noise: with more a trial sees nothing.
fn hold(scores: Result<Scores, Disagreement>, noise: f64) -> Outcome {
    let scores = scores?;
    let found = scores.noise();
    ensure!(found <= noise, "noise of {found:.4}, to be below {noise}");
    Ok(scores.check()?)
}

/// Every value is right without noise, but for rounding: a sum of samples that are each exact.
fn exactly(traced: &Traced, exact: f64) -> Outcome {
    for (i, value) in traced.mean.iter().enumerate() {
        let error = (value.as_dvec3() / exact - 1.0).abs().max_element();
        ensure!(error <= 2e-6, "point {i}: {value} for {exact}");
    }
    Ok(())
}
