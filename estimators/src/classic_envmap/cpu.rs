//! Classic environment mapping on the CPU.

use super::map::{Source, directions, light, node_points};
use super::math::{cosine_weight, map_nodes, map_taps, phong_exponent, phong_weight};
use super::{ClassicEnvmap, ClassicEnvmapParams, lobe_exponents};
use crate::averaging::face_solid_angles_sr;
use crate::kept::Kept;
use crate::{Changed, Cpu, Estimator, EstimatorError, Inputs, Quantity};
use glam::Vec3;
use interreflect_cpu::lane::{Lane, Vector, WIDTH, Wide};
use interreflect_cpu::tiles::{CpuCx, PointLanes, TileKernel};
use interreflect_scene::{Estimate, PointLayout, Points};
use std::f32::consts::FRAC_1_PI;

/// The tables and the convolved maps, kept across frames.
#[derive(Default)]
pub struct State {
    tables: Kept<ClassicEnvmapParams, Tables>,
    maps: Option<Maps>,
}

/// What a convolution reads and where it is evaluated.
struct Tables {
    omegas_sr: Vec<f32>,
    sources: Vec<Source>,
    nodes: Points,
}

impl Tables {
    fn new(params: &ClassicEnvmapParams) -> Self {
        Self {
            omegas_sr: face_solid_angles_sr(params.captured().size),
            sources: directions(params.resolution),
            nodes: node_points(params.map_resolution),
        }
    }
}

/// The convolved maps: for each lobe its exponent and map, ascending.
struct Maps {
    irradiance: Map,
    lobes: Vec<(f32, Map)>,
}

impl Maps {
    fn exponents(&self) -> Vec<f32> {
        self.lobes.iter().map(|(exponent, _)| *exponent).collect()
    }
}

/// RGB at the nodes of a cube map, row by row.
struct Map {
    cells: u32,
    nodes: Vec<Vec3>,
}

impl Map {
    fn convolve<K: TileKernel>(cx: &CpuCx, cells: u32, at: &Points, kernel: &K) -> Self {
        let mut nodes = Estimate::new(map_nodes(cells));
        cx.for_each_tile(at, &mut nodes, kernel);
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
        let kept = state.maps.as_ref().map(Maps::exponents);
        let exponents = lobe_exponents(quantity, inputs, kept.clone().unwrap_or_default())?;
        let stale = inputs.changed.any(Changed::PARAMS | Changed::CAPTURES);
        if !stale && kept.as_ref() == Some(&exponents) {
            return Ok(());
        }
        let captured = inputs.cube(&params.captured())?;
        let tables = state.tables.tables(params, || Ok(Tables::new(params)))?;
        let (sources, nodes) = (&mut tables.sources, &tables.nodes);
        light(sources, params.resolution, captured, &tables.omegas_sr);
        let cells = params.map_resolution;
        let lobe = |e| (e, Map::convolve(cx, cells, nodes, &Phong(sources, e)));
        state.maps = Some(Maps {
            irradiance: Map::convolve(cx, cells, nodes, &Cosine(sources)),
            lobes: exponents.into_iter().map(lobe).collect(),
        });
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
        let maps = state.maps.as_ref().ok_or(EstimatorError::Unprepared)?;
        match quantity {
            Quantity::GlossyRadiance if maps.lobes.is_empty() => {
                return Err(EstimatorError::Unprepared);
            }
            Quantity::GlossyRadiance => cx.for_each_tile(inputs.points, out, &Glossy(maps)),
            _ => cx.for_each_tile(inputs.points, out, &Diffuse(maps)),
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

struct Diffuse<'a>(&'a Maps);

impl TileKernel for Diffuse<'_> {
    #[inline(always)]
    fn shade(&self, points: &PointLanes<'_>) -> [Wide; 3] {
        let n = points.vector(PointLayout::NORMAL);
        lanes(|lane| self.0.irradiance.lookup(at(n, lane)))
    }
}

/// L = k_d/π·E(n) + k_s·L_N(r).
struct Glossy<'a>(&'a Maps);

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
