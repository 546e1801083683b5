//! Classic environment mapping on the CPU.

use super::map::{Source, node_points, sources};
use super::math::{cosine_weight, map_nodes, map_taps, phong_exponent, phong_weight};
use super::{ClassicEnvmap, ClassicEnvmapParams, lobe_exponents};
use crate::{Changed, Cpu, Estimator, EstimatorError, Inputs, Quantity};
use glam::Vec3;
use interreflect_cpu::lane::{Lane, Vector, WIDTH, Wide};
use interreflect_cpu::tiles::{CpuCx, PointLanes, TileKernel};
use interreflect_scene::{Estimate, PointLayout};
use std::f32::consts::FRAC_1_PI;

/// The convolved maps, kept across frames.
#[derive(Default)]
pub struct State {
    irradiance: Map,
    lobes: Vec<(f32, Map)>,
}

/// RGB at the nodes of a cube map, row by row.
#[derive(Default)]
struct Map {
    cells: u32,
    nodes: Vec<Vec3>,
}

impl Map {
    fn convolve<K: TileKernel>(cx: &CpuCx, cells: u32, kernel: &K) -> Self {
        let mut nodes = Estimate::new(map_nodes(cells));
        cx.for_each_tile(&node_points(cells), &mut nodes, kernel);
        Self {
            cells,
            nodes: nodes.iter().collect(),
        }
    }

    #[inline(always)]
    fn lookup(&self, direction: Vec3) -> Vec3 {
        map_taps(self.cells, direction)
            .into_iter()
            .map(|(node, weight)| self.nodes[node] * weight)
            .sum()
    }
}

impl Estimator<Cpu> for ClassicEnvmap {
    type State = State;

    fn prepare(
        params: &ClassicEnvmapParams,
        state: &mut State,
        cx: &mut &CpuCx,
        quantity: Quantity,
        inputs: &Inputs<'_, Cpu>,
        _out: &Estimate,
    ) -> Result<(), EstimatorError> {
        let glossy = quantity == Quantity::GlossyRadiance;
        let stale = inputs.changed.any(Changed::PARAMS | Changed::CAPTURES);
        let other_lobes = glossy && inputs.changed.any(Changed::POINTS);
        if !(stale || other_lobes) {
            return Ok(());
        }
        let captured = inputs.cube(&params.captured())?;
        let sources = sources(params.resolution, captured);
        let cells = params.map_resolution;
        state.irradiance = Map::convolve(cx, cells, &Cosine(&sources));
        state.lobes.clear();
        if glossy {
            for exponent in lobe_exponents(inputs)? {
                let map = Map::convolve(cx, cells, &Phong(&sources, exponent));
                state.lobes.push((exponent, map));
            }
        }
        Ok(())
    }

    fn shade(
        _params: &ClassicEnvmapParams,
        state: &mut State,
        cx: &mut &CpuCx,
        quantity: Quantity,
        inputs: &Inputs<'_, Cpu>,
        out: &mut Estimate,
    ) -> Result<(), EstimatorError> {
        match quantity {
            Quantity::GlossyRadiance => cx.for_each_tile(inputs.points, out, &Glossy(state)),
            _ => cx.for_each_tile(inputs.points, out, &Diffuse(state)),
        }
        Ok(())
    }
}

/// E(n) = Σ L·∫(n·ω)⁺dω.
struct Cosine<'a>(&'a [Source]);

impl TileKernel for Cosine<'_> {
    #[inline(always)]
    fn shade(&self, points: &PointLanes<'_>) -> [Wide; 3] {
        let n = points.vector(PointLayout::NORMAL);
        let mut sum = [Wide::splat(0.0); 3];
        for source in self.0 {
            let weight = cosine_weight(n, Vector::splat(source.vector));
            for (sum, radiance) in sum.iter_mut().zip(source.radiance) {
                *sum = *sum + weight * Wide([radiance; WIDTH]);
            }
        }
        sum
    }
}

/// L(r) = Σ L·Δω·((r·l)⁺)^N / Σ Δω·((r·l)⁺)^N.
struct Phong<'a>(&'a [Source], f32);

impl TileKernel for Phong<'_> {
    #[inline(always)]
    fn shade(&self, points: &PointLanes<'_>) -> [Wide; 3] {
        let r = points.vector(PointLayout::NORMAL);
        let zero = Wide::splat(0.0);
        let exponent = Wide([self.1; WIDTH]);
        let texel = |source: &Source| {
            let vector: Vector<Wide> = Vector::splat(source.vector);
            let omega = vector.dot(vector).sqrt();
            (r.dot(vector) / omega, omega)
        };
        let mut cos_max = zero;
        for source in self.0 {
            cos_max = cos_max.max(texel(source).0);
        }
        let (mut sum, mut total) = ([zero; 3], zero);
        for source in self.0 {
            let (cos, omega) = texel(source);
            let weight = omega * phong_weight(cos, cos_max, exponent);
            total = total + weight;
            for (sum, radiance) in sum.iter_mut().zip(source.radiance) {
                *sum = *sum + weight * Wide([radiance; WIDTH]);
            }
        }
        sum.map(|s| s / total)
    }
}

struct Diffuse<'a>(&'a State);

impl TileKernel for Diffuse<'_> {
    #[inline(always)]
    fn shade(&self, points: &PointLanes<'_>) -> [Wide; 3] {
        let n = points.vector(PointLayout::NORMAL);
        lanes(|lane| self.0.irradiance.lookup(at(n, lane)))
    }
}

/// L = k_d/π·E(n) + k_s·L_N(r).
struct Glossy<'a>(&'a State);

impl TileKernel for Glossy<'_> {
    #[inline(always)]
    fn shade(&self, points: &PointLanes<'_>) -> [Wide; 3] {
        let (n, v) = (
            points.vector(PointLayout::NORMAL),
            points.vector(PointLayout::VIEW),
        );
        let reflected = n.scale(Wide::splat(2.0) * n.dot(v)) - v;
        let (kd, ks) = (
            points.vector(PointLayout::DIFFUSE),
            points.vector(PointLayout::SPECULAR),
        );
        let shininess = points.plane(PointLayout::SHININESS);
        lanes(|lane| {
            let exponent = phong_exponent(shininess.0[lane]);
            let lobe = self.0.lobes.iter().find(|(e, _)| *e >= exponent);
            let specular = lobe.map_or(Vec3::ZERO, |(_, map)| map.lookup(at(reflected, lane)));
            let diffuse = self.0.irradiance.lookup(at(n, lane)) * FRAC_1_PI;
            at(kd, lane) * diffuse + at(ks, lane) * specular
        })
    }
}

#[inline(always)]
fn at(v: Vector<Wide>, lane: usize) -> Vec3 {
    Vec3::new(v.x.0[lane], v.y.0[lane], v.z.0[lane])
}

#[inline(always)]
fn lanes(value: impl Fn(usize) -> Vec3) -> [Wide; 3] {
    let mut planes = [Wide::splat(0.0); 3];
    for lane in 0..WIDTH {
        let rgb = value(lane);
        for c in 0..3 {
            planes[c].0[lane] = rgb[c];
        }
    }
    planes
}
