//! Ambient occlusion from many directions on the CPU.

use super::environment::Blurred;
use super::math::{open_cosine, passes};
use super::progress::{Progress, Step, WORD, by_words, words};
use super::{
    BelowHorizon, DirectionalAo, MAX_LEVEL, Visibility, environment, least_cosine, record_names,
    values,
};
use crate::{Cpu, Estimator, EstimatorError, Frame, Inputs, Prepared, Records, Unsupported};
use glam::Vec3;
use interreflect_cpu::capture::directional_depth::DirectionalDepths;
use interreflect_cpu::lane::{Lane, Vector};
use interreflect_cpu::scene::CpuScene;
use interreflect_cpu::tiles::{PointLanes, TileKernel};
use interreflect_scene::{LANES, PointLayout, Points};
use rayon::prelude::*;

/// Visibility and light.
pub struct Openness {
    progress: Progress,
    bits: Vec<u32>,
    light: Light,
    blurred: Option<Blurred>,
}

/// Directions and what they count.
struct Light {
    towards: Vec<Vec3>,
    values: Vec<[f32; 3]>,
    /// What a cosine counts at least.
    least: f32,
}

impl Estimator<Cpu> for DirectionalAo {
    type Prepared = Openness;

    fn supports(&self, _caps: &()) -> Result<(), Unsupported> {
        Ok(())
    }

    fn prepare(
        &self,
        frame: &mut Frame<'_, Cpu>,
        last: Option<Openness>,
    ) -> Result<Openness, EstimatorError> {
        let (mut progress, mut bits, mut blurred) = match last {
            Some(last) => (last.progress, last.bits, last.blurred),
            None => (Progress::default(), Vec::new(), None),
        };
        let begun = progress.begin(self, frame);
        let points = frame.points;
        let stride = points.block_count() * LANES;
        if begun.forget || bits.is_empty() {
            bits.clear();
            bits.resize(stride * words(self.level), 0);
        }
        let towards = begun.directions(MAX_LEVEL);
        for step in &begun.steps {
            let source = Source::new(self, frame)?;
            let looked = || look(&mut bits, stride, (step, &towards), points, &source);
            frame.cx.install(looked);
        }
        let towards = begun.directions(begun.level);
        let light = environment(frame)?;
        let values = || values(self, (begun.level, &towards), light, &mut blurred);
        let light = Light {
            values: frame.cx.install(values),
            towards,
            least: least_cosine(self),
        };
        Ok(Openness {
            progress,
            bits,
            light,
            blurred,
        })
    }
}

impl Prepared<Cpu> for Openness {
    fn shade(&self, frame: &mut Frame<'_, Cpu>) -> Result<(), EstimatorError> {
        let sum = Sum {
            light: &self.light,
            bits: &self.bits,
            stride: frame.points.block_count() * LANES,
        };
        frame.for_each_tile(&sum);
        Ok(())
    }

    fn records(&self, _caps: &()) -> Result<Vec<Records>, EstimatorError> {
        Ok(vec![
            Records::bits(record_names::VISIBILITY, self.bits.clone()),
            Records::count(record_names::EVALUATIONS, self.progress.evaluations()),
        ])
    }
}

/// Where visibility comes from.
enum Source<'a> {
    /// Nothing occludes.
    Open,
    /// Depth maps, how far behind them a point may lie, and whether it is tested as it is drawn.
    Maps(&'a DirectionalDepths, f32, bool),
    /// Rays, and whether below the horizon too.
    Rays(&'a CpuScene, bool),
}

impl<'a> Source<'a> {
    fn new(method: &DirectionalAo, inputs: &Inputs<'a, Cpu>) -> Result<Self, EstimatorError> {
        Ok(match (inputs.scene.any_surface, method.visibility) {
            (false, _) => Self::Open,
            (true, Visibility::Rays) => {
                let below = method.below_horizon == BelowHorizon::Signed;
                Self::Rays(inputs.light_transport()?, below)
            }
            (true, visibility) => {
                let drawn = visibility == Visibility::Queries;
                Self::Maps(inputs.depths(&method.depths())?, method.margin(), drawn)
            }
        })
    }

    /// Whether each of the points is open in a direction.
    fn open(&self, towards: Vec3, points: &[u32], all: &Points) -> Vec<bool> {
        let point = |&i: &u32| all.get(i as usize);
        match self {
            Self::Open => vec![true; points.len()],
            Self::Maps(depths, margin, drawn) => {
                let map = depths.map(towards);
                let test = |position| match drawn {
                    true => map.shows(position, *margin),
                    false => {
                        let [depth, first] = map.depths(position);
                        passes(depth, first, *margin) > 0.0
                    }
                };
                let open = points.iter().map(point);
                open.map(|p| p.is_some_and(|p| test(p.position))).collect()
            }
            Self::Rays(scene, below) => {
                let objects = scene.all_objects();
                let open = |p: interreflect_scene::Point| {
                    let (origin, direction) = (p.position.as_dvec3(), towards.as_dvec3());
                    (*below || p.normal.dot(towards) > 0.0)
                        && !objects.occluded(origin, direction, f64::INFINITY)
                };
                points
                    .iter()
                    .map(point)
                    .map(|p| p.is_some_and(open))
                    .collect()
            }
        }
    }
}

/// Looks along the directions of a step; the result does not depend on the number of threads.
fn look(
    bits: &mut [u32],
    stride: usize,
    (step, towards): (&Step, &[Vec3]),
    all: &Points,
    source: &Source<'_>,
) {
    for range in by_words(step.directions.clone()) {
        let word = &mut bits[range.start / WORD * stride..][..stride];
        let mask = range.clone().fold(0, |mask, j| mask | 1 << (j % WORD));
        let open: Vec<Vec<bool>> = range
            .clone()
            .into_par_iter()
            .map(|j| source.open(towards[j], &step.points, all))
            .collect();
        for (k, &i) in step.points.iter().enumerate() {
            let columns = range.clone().zip(&open);
            let new = columns.fold(0, |new, (j, open)| new | u32::from(open[k]) << (j % WORD));
            let bits = &mut word[i as usize];
            *bits = *bits & !mask | new;
        }
    }
}

/// Σ_j M_ij·value_j.
struct Sum<'a> {
    light: &'a Light,
    bits: &'a [u32],
    stride: usize,
}

impl TileKernel for Sum<'_> {
    #[inline(always)]
    fn shade<L: Lane>(&self, points: &PointLanes<'_, L>) -> [L; 3] {
        let n = points.vector(PointLayout::NORMAL);
        let mut sum = [L::from(0.0); 3];
        let least = L::from(self.light.least);
        let chunks = self
            .light
            .towards
            .chunks(WORD)
            .zip(self.light.values.chunks(WORD));
        for (word, (towards, values)) in chunks.enumerate() {
            let bits = &self.bits[word * self.stride + points.first()..][..L::WIDTH];
            for (bit, (towards, value)) in towards.iter().zip(values).enumerate() {
                let open = L::by_lane(|i| L::Scalar::from(((bits[i] >> bit) & 1) as f32));
                let cosine = n.dot(Vector::splat(towards.to_array()));
                let m = open_cosine(cosine, open, least);
                for (sum, value) in sum.iter_mut().zip(value) {
                    *sum = *sum + m * L::from(*value);
                }
            }
        }
        sum
    }
}
