//! Convolutions on the CPU: every node of a map sums over all texels, as a point of its own.

use super::Sizes;
use super::math::{cosine_weight, map_nodes, map_taps, phong_weight};
use super::sources::{Source, light, node_points, vectors_sr};
use crate::averaging::face_solid_angles_sr;
use crate::{Cpu, EstimatorError, Frame, Records};
use glam::Vec3;
use interreflect_cpu::lane::{Lane, Scalar, Vector};
use interreflect_cpu::tiles::{Arithmetic, CpuCx, PointLanes, TileKernel};
use interreflect_scene::{Estimate, PointLayout, Points};

/// The convolved maps with their tables.
pub struct Convolved {
    tables: Tables,
    maps: Maps,
}

/// What a convolution reads and where it is evaluated.
struct Tables {
    omegas_sr: Vec<f32>,
    sources: Vec<Source>,
    nodes: Points,
}

impl Tables {
    fn new(sizes: &Sizes) -> Self {
        let source = |vector: Vec3| Source {
            vector: vector.to_array(),
            ..Source::default()
        };
        Self {
            omegas_sr: face_solid_angles_sr(sizes.captured.size),
            sources: vectors_sr(sizes.resolution).map(source).collect(),
            nodes: node_points(sizes.cells),
        }
    }
}

/// The convolved maps: of irradiance, and for each lobe its exponent and its map of radiance.
pub struct Maps {
    /// Irradiance by normal.
    pub irradiance: Map,
    /// Exponent of each lobe, ascending, with its filtered radiance.
    pub lobes: Vec<(f32, Map)>,
}

impl Maps {
    /// Radiance in each lane's direction, filtered with the lobe of its exponent; 0 without one.
    #[inline(always)]
    pub fn of_lobe<L: Lane>(&self, exponent: L, directions: Vector<L>) -> Vector<L> {
        Vector::by_lane(|i| {
            let is_its = |e: f32| L::Scalar::from(e) >= exponent.lanes()[i];
            let lobe = self.lobes.iter().find(|(e, _)| is_its(*e));
            lobe.map_or(Vector::splat([0.0; 3]), |(_, map)| {
                map.lookup(directions.lane(i))
            })
        })
    }
}

impl Convolved {
    /// The Phong exponents that there are maps for.
    pub fn exponents(&self) -> Vec<f32> {
        let lobes = self.maps.lobes.iter();
        lobes.map(|(exponent, _)| *exponent).collect()
    }

    /// Convolves the declared capture with the cosine and with a Phong lobe of each exponent; what
    /// the last frame had is kept where nothing has changed.
    pub fn new(
        sizes: &Sizes,
        frame: &Frame<'_, Cpu>,
        exponents: Vec<f32>,
        last: Option<Self>,
    ) -> Result<Self, EstimatorError> {
        let mut tables = match last {
            Some(last) => {
                let holds = frame.unless_stale(Some(())).is_some();
                if holds && last.exponents() == exponents {
                    return Ok(last);
                }
                last.tables
            }
            None => Tables::new(sizes),
        };
        let captured = frame.cube(&sizes.captured)?;
        let (sources, nodes) = (&mut tables.sources, &tables.nodes);
        light(sources, sizes.resolution, captured, &tables.omegas_sr);
        let cx: &CpuCx = frame.cx;
        let lobe = |e| (e, Map::convolve(cx, sizes.cells, nodes, &Phong(sources, e)));
        let maps = Maps {
            irradiance: Map::convolve(cx, sizes.cells, nodes, &Cosine(sources)),
            lobes: exponents.into_iter().map(lobe).collect(),
        };
        Ok(Self { tables, maps })
    }

    /// All maps, the irradiance first, as the GPU has them.
    pub fn records(&self) -> Vec<Records> {
        let lobes = self.maps.lobes.iter().map(|(_, map)| map);
        let nodes = std::iter::once(&self.maps.irradiance)
            .chain(lobes)
            .flat_map(|map| map.nodes.iter().map(|rgb| rgb.extend(0.0).to_array()));
        vec![Records::host("maps", &nodes.collect::<Vec<_>>())]
    }

    /// The maps.
    pub fn maps(&self) -> &Maps {
        &self.maps
    }
}

/// RGB at the nodes of a cube map, row by row.
pub struct Map {
    cells: u32,
    nodes: Vec<Vec3>,
}

impl Map {
    fn convolve<K: TileKernel>(cx: &CpuCx, cells: u32, at: &Points, kernel: &K) -> Self {
        let mut nodes = Estimate::new(map_nodes(cells));
        // A map is prepared: the same whatever arithmetic shades with it.
        let cx = cx.with_arithmetic(Arithmetic::Lanes);
        cx.for_each_tile(at, &mut nodes, kernel);
        Self {
            cells,
            nodes: nodes.iter().collect(),
        }
    }

    /// Bilinear value in a direction, which need not be unit.
    #[inline(always)]
    fn lookup<S: Scalar>(&self, direction: Vector<S>) -> Vector<S> {
        let mut sum = Vector::splat([0.0; 3]);
        for (node, weight) in map_taps(self.cells, direction) {
            sum = sum + Vector::splat(self.nodes[node].to_array()).scale(weight);
        }
        sum
    }

    /// RGB in each lane's direction.
    #[inline(always)]
    pub fn along<L: Lane>(&self, directions: Vector<L>) -> Vector<L> {
        Vector::by_lane(|i| self.lookup(directions.lane(i)))
    }
}

/// The value along each point's normal.
impl TileKernel for Map {
    #[inline(always)]
    fn shade<L: Lane>(&self, points: &PointLanes<'_, L>) -> [L; 3] {
        self.along(points.vector(PointLayout::NORMAL)).to_array()
    }
}

/// E(n) = Σ L·∫(n·ω)⁺dω.
struct Cosine<'a>(&'a [Source]);

impl TileKernel for Cosine<'_> {
    #[inline(always)]
    fn shade<L: Lane>(&self, points: &PointLanes<'_, L>) -> [L; 3] {
        let n = points.vector(PointLayout::NORMAL);
        let mut sum = [L::from(0.0); 3];
        for source in self.0 {
            let weight = cosine_weight(n, Vector::splat(source.vector));
            for (sum, radiance) in sum.iter_mut().zip(source.radiance) {
                *sum = *sum + weight * L::from(radiance);
            }
        }
        sum
    }
}

/// L(r) = Σ L·Δω·((r·l)⁺)^N / Σ Δω·((r·l)⁺)^N.
struct Phong<'a>(&'a [Source], f32);

impl TileKernel for Phong<'_> {
    #[inline(always)]
    fn shade<L: Lane>(&self, points: &PointLanes<'_, L>) -> [L; 3] {
        let r = points.vector(PointLayout::NORMAL);
        let zero = L::from(0.0);
        let exponent = L::from(self.1);
        let texel = |source: &Source| {
            let vector: Vector<L> = Vector::splat(source.vector);
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
                *sum = *sum + weight * L::from(radiance);
            }
        }
        sum.map(|s| s / total)
    }
}
