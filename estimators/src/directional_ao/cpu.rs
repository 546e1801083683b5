//! Ambient occlusion from many directions on the CPU.

use super::environment::Blurred;
use super::math::{open_cosine, passes};
use super::progress::{Progress, Step, WORD, by_words, words};
use super::sphere::directions;
use super::{DirectionalAo, DirectionalAoParams, Visibility, environment, values};
use crate::{Cpu, Estimator, EstimatorError, Inputs, Quantity, Unsupported};
use glam::Vec3;
use interreflect_cpu::capture::directional_depth::DirectionalDepths;
use interreflect_cpu::lane::{Lane, Vector};
use interreflect_cpu::scene::CpuScene;
use interreflect_cpu::tiles::{CpuCx, PointLanes, TileKernel};
use interreflect_scene::{Estimate, LANES, PointLayout, Points};
use rayon::prelude::*;

/// Visibility and light, kept across frames.
#[derive(Default)]
pub struct State {
    progress: Progress,
    bits: Vec<u32>,
    light: Option<Light>,
    blurred: Option<Blurred>,
}

/// Directions and what they count.
struct Light {
    towards: Vec<Vec3>,
    values: Vec<[f32; 3]>,
}

impl State {
    /// A bit for each direction, a word for each 32 directions and point: word after word, points
    /// padded to whole blocks.
    pub fn bits(&self) -> &[u32] {
        &self.bits
    }

    /// Points that were evaluated since the start, repetitions counted.
    pub fn evaluations(&self) -> u64 {
        self.progress.todo.evaluations
    }
}

impl Estimator<Cpu> for DirectionalAo {
    type State = State;

    fn supports(params: &DirectionalAoParams, _caps: &()) -> Result<(), Unsupported> {
        match params.visibility {
            Visibility::Queries => Err(Unsupported(
                "directional_ao: occlusion queries are the GPU's; use visibility=depth_map or rays \
                 on the CPU"
                    .into(),
            )),
            Visibility::DepthMap | Visibility::Rays => Ok(()),
        }
    }

    fn prepare(
        params: &DirectionalAoParams,
        state: &mut State,
        cx: &mut &CpuCx,
        quantity: Quantity,
        inputs: &Inputs<'_, Cpu>,
        _out: &Estimate,
    ) -> Result<(), EstimatorError> {
        let (steps, forget) = state.progress.begin(params, inputs);
        let stride = inputs.points.block_count() * LANES;
        if forget || state.bits.is_empty() {
            state.bits.clear();
            state.bits.resize(stride * words(params.level), 0);
        }
        let source = Source::new(params, inputs)?;
        for step in &steps {
            cx.install(|| look(&mut state.bits, stride, step, inputs.points, &source));
        }
        let level = state.progress.level().ok_or(EstimatorError::Unprepared)?;
        let light = environment(quantity, inputs)?;
        let values = cx.install(|| values(params, level, light, &mut state.blurred));
        state.light = Some(Light {
            towards: directions(level),
            values,
        });
        Ok(())
    }

    fn shade(
        _params: &DirectionalAoParams,
        state: &mut State,
        cx: &mut &CpuCx,
        _quantity: Quantity,
        inputs: &Inputs<'_, Cpu>,
        out: &mut Estimate,
    ) -> Result<(), EstimatorError> {
        let light = state.light.as_ref().ok_or(EstimatorError::Unprepared)?;
        let sum = Sum {
            light,
            bits: &state.bits,
            stride: inputs.points.block_count() * LANES,
        };
        cx.for_each_tile(inputs.points, out, &sum);
        Ok(())
    }
}

/// Where visibility comes from.
enum Source<'a> {
    /// Nothing occludes.
    Open,
    /// Depth maps, and how far behind them a point may lie.
    Maps(&'a DirectionalDepths, f32),
    /// Rays.
    Rays(&'a CpuScene),
}

impl<'a> Source<'a> {
    fn new(params: &DirectionalAoParams, inputs: &Inputs<'a, Cpu>) -> Result<Self, EstimatorError> {
        Ok(match (inputs.scene.occluders, params.visibility) {
            (false, _) => Self::Open,
            (true, Visibility::Rays) => Self::Rays(inputs.light_transport()?),
            (true, _) => Self::Maps(inputs.depths(&params.depths())?, params.margin()),
        })
    }

    /// Whether each of the points is open in a direction.
    fn open(&self, towards: Vec3, points: &[u32], all: &Points) -> Vec<bool> {
        let point = |&i: &u32| all.get(i as usize);
        match self {
            Self::Open => vec![true; points.len()],
            Self::Maps(depths, margin) => {
                let map = depths.map(towards);
                let test = |position| {
                    let [depth, first] = map.depths(position);
                    passes(depth, first, *margin) > 0.0
                };
                let open = points.iter().map(point);
                open.map(|p| p.is_some_and(|p| test(p.position))).collect()
            }
            Self::Rays(scene) => {
                let objects = scene.all_objects();
                let open = |p: interreflect_scene::Point| {
                    let (origin, direction) = (p.position.as_dvec3(), towards.as_dvec3());
                    p.normal.dot(towards) > 0.0
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
fn look(bits: &mut [u32], stride: usize, step: &Step, all: &Points, source: &Source<'_>) {
    let towards = directions(super::MAX_LEVEL);
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
                let m = open_cosine(cosine, open);
                for (sum, value) in sum.iter_mut().zip(value) {
                    *sum = *sum + m * L::from(*value);
                }
            }
        }
        sum
    }
}
