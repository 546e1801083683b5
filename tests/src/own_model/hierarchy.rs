//! What is seen from the reference point: patches, merged four by four.

use glam::{DVec3, Vec3};
use interreflect_cpu::capture::cube::capture_cube;
use interreflect_cpu::direct::captured_radiance;
use interreflect_cpu::scene::CpuScene;
use interreflect_estimators::OwnModel;
use interreflect_scene::conventions::{
    CUBE_FACES, cube_vector, texel_centre, texel_index, texel_solid_angle_sr,
};
use interreflect_scene::{CubeChannels, CubeImage, CubeSpec};
use rayon::prelude::*;

/// Nodes along a face's edge at the coarsest level: 54 roots.
const ROOTS: u32 = 3;

/// A square of texels of one level.
#[derive(Clone, Copy, Debug)]
pub(super) struct Square {
    pub(super) size: u32,
    pub(super) face: usize,
    pub(super) column: u32,
    pub(super) row: u32,
}

impl Square {
    fn of_index(size: u32, index: usize) -> Self {
        let n = size as usize;
        Self {
            size,
            face: index / (n * n),
            column: (index % n) as u32,
            row: (index / n % n) as u32,
        }
    }

    pub(super) fn index(self) -> usize {
        texel_index(self.size, self.face, self.column, self.row)
    }

    /// The four squares of the next finer level.
    pub(super) fn children(self) -> [Self; 4] {
        [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(column, row)| Self {
            size: 2 * self.size,
            face: self.face,
            column: 2 * self.column + column,
            row: 2 * self.row + row,
        })
    }

    /// The squares beside it on the same face.
    fn neighbours(self) -> impl Iterator<Item = Self> {
        [(-1, 0), (1, 0), (0, -1), (0, 1)].into_iter().filter_map(move |(column, row)| {
            let moved = |i: u32, by| i.checked_add_signed(by).filter(|&i| i < self.size);
            Some(Self {
                column: moved(self.column, column)?,
                row: moved(self.row, row)?,
                ..self
            })
        })
    }

    /// Rays through the corners, clockwise seen from the centre of the cube of edge 2.
    pub(super) fn rays(self) -> [DVec3; 4] {
        let edge = |i: u32| 2.0 * f64::from(i) / f64::from(self.size) - 1.0;
        let (s0, s1) = (edge(self.column), edge(self.column + 1));
        let (t0, t1) = (edge(self.row), edge(self.row + 1));
        [(s0, t0), (s0, t1), (s1, t1), (s1, t0)].map(|(s, t)| cube_vector(self.face, s, t))
    }
}

/// A patch, or four nodes in one.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Node {
    /// Power-weighted centre relative to the reference point in metres, or mean direction.
    pub(super) centre: Vec3,
    /// Mean unit normal towards the reference point, weighted by area; zero at infinity.
    pub(super) normal: Vec3,
    /// Radiance times area in W/sr, or times solid angle in W/m².
    pub(super) power: Vec3,
    /// Area in m², or solid angle in sr.
    pub(super) measure: f32,
    /// Radius about the centre in metres, or radians; infinite where surfaces and sky meet.
    pub(super) radius: f32,
    /// Distance of a planar node's plane from the reference point in metres.
    pub(super) height: f32,
    /// All of it in one plane.
    pub(super) flat: bool,
    /// Flat, and of one radiance.
    pub(super) uniform: bool,
    /// A bundle of directions.
    pub(super) at_infinity: bool,
}

impl Node {
    pub(super) fn radiance(&self) -> Vec3 {
        self.power / self.measure
    }

    /// Squared radius, made larger where the normals part and a point tells less: sixteen-fold
    /// where two walls meet in a right angle.
    pub(super) fn size2(&self) -> f32 {
        let bent = match self.at_infinity {
            true => 0.0,
            false => (1.0 - self.normal.length_squared()).max(0.0),
        };
        self.radius * self.radius * (1.0 + 30.0 * bent)
    }

    fn merge(children: [&Node; 4]) -> Self {
        let at_infinity = children[0].at_infinity;
        let measure: f32 = children.iter().map(|c| c.measure).sum();
        let power: Vec3 = children.iter().map(|c| c.power).sum();
        // Dark children count a little, so that a dark node has a centre.
        let dim = 1e-3 * power.max_element() / measure + f32::MIN_POSITIVE;
        let weight = |c: &Node| c.power.max_element() + dim * c.measure;
        let total: f32 = children.iter().map(|c| weight(c)).sum();
        let weighted: Vec3 = children.iter().map(|c| c.centre * weight(c)).sum();
        let centre = weighted / total;
        let mixed = children.iter().any(|c| c.at_infinity != at_infinity);
        let reach = children
            .iter()
            .map(|c| c.centre.distance(centre) + c.radius);
        let radius = reach.fold(if mixed { f32::INFINITY } else { 0.0 }, f32::max);
        let normals: Vec3 = children.iter().map(|c| c.normal * c.measure).sum();
        let first = children[0];
        // Tolerances: rounding of f32 in the capture.
        let in_plane = |c: &Node| {
            c.flat
                && (c.normal - first.normal).length_squared() < 1e-12
                && (c.height - first.height).abs() < 1e-6 * first.height
        };
        let like_first = |c: &Node| {
            let difference = (c.radiance() - first.radiance()).abs();
            c.uniform && difference.max_element() <= 1e-6 * first.radiance().max_element()
        };
        let flat = children.iter().all(|c| in_plane(c));
        Self {
            centre,
            normal: normals / measure,
            power,
            measure,
            radius,
            height: first.height,
            flat,
            uniform: flat && children.iter().all(|c| like_first(c)),
            at_infinity,
        }
    }
}

/// Nodes of all levels around a reference point.
pub(super) struct Hierarchy {
    /// The reference point.
    pub(super) origin: DVec3,
    /// From coarse to fine: level k has (3·2ᵏ)² nodes a face.
    levels: Vec<Vec<Node>>,
}

impl Hierarchy {
    /// Captures 6·size² patches, size = 3·2ᵏ, and merges them.
    pub(super) fn new(model: OwnModel, scene: &CpuScene, size: u32) -> Self {
        let local = model == OwnModel::VisibleFromReference;
        let channels = CubeChannels {
            radiance: true,
            distance: local,
            normal: local,
        };
        let mut captured = capture_cube(scene, CubeSpec { size, channels });
        average_edges(&mut captured, scene);
        let mut patches: Vec<Node> = (0..captured.texels())
            .into_par_iter()
            .map(|index| patch(&captured, Square::of_index(size, index)))
            .collect();
        if model == OwnModel::MeanRadiance {
            let total = |f: fn(&Node) -> DVec3| patches.iter().map(f).sum::<DVec3>();
            let mean = total(|p| p.power.as_dvec3()) / total(|p| DVec3::splat(p.measure.into()));
            let mean = mean.as_vec3();
            patches.iter_mut().for_each(|p| p.power = mean * p.measure);
        }
        let mut levels = vec![patches];
        let mut size = size;
        while size > ROOTS {
            size /= 2;
            let finer = &levels[levels.len() - 1];
            let level = (0..CUBE_FACES * (size * size) as usize)
                .into_par_iter()
                .map(|index| {
                    let children = Square::of_index(size, index).children();
                    Node::merge(children.map(|c| &finer[c.index()]))
                })
                .collect();
            levels.push(level);
        }
        levels.reverse();
        Self {
            origin: scene.scene().reference_point.as_dvec3(),
            levels,
        }
    }

    /// The squares of the coarsest level.
    pub(super) fn roots(&self) -> impl Iterator<Item = Square> + '_ {
        (0..self.levels[0].len()).map(|index| Square::of_index(ROOTS, index))
    }

    #[inline(always)]
    pub(super) fn node(&self, square: Square) -> &Node {
        &self.levels[(square.size / ROOTS).ilog2() as usize][square.index()]
    }

    /// Whether a square is a single patch.
    #[inline(always)]
    pub(super) fn is_patch(&self, square: Square) -> bool {
        square.size / ROOTS == 1 << (self.levels.len() - 1)
    }

    /// Corners of a planar node relative to the reference point, clockwise seen from it.
    pub(super) fn corners(&self, square: Square) -> [DVec3; 4] {
        let node = self.node(square);
        let normal = node.normal.as_dvec3().normalize();
        let height = f64::from(node.height);
        square.rays().map(|ray| ray * (height / -normal.dot(ray)))
    }
}

/// Rays along each side of a texel that has an edge in it.
const EDGE_RAYS: u32 = 8;

/// Gives texels whose radiance differs from a neighbour's the mean of 8×8 rays: an edge, of a
/// surface or of a shadow, then costs a fraction of a texel's eighth, not of its half.
fn average_edges(captured: &mut CubeImage, scene: &CpuScene) {
    let size = captured.size;
    let differs = |a: Vec3, b: Vec3| (a - b).abs().max_element() > 0.02 * a.max(b).max_element();
    let means: Vec<(usize, Vec3)> = (0..captured.texels())
        .into_par_iter()
        .filter_map(|index| {
            let square = Square::of_index(size, index);
            let is_edge = square.neighbours().any(|neighbour| {
                differs(captured.radiance[index], captured.radiance[neighbour.index()])
            });
            is_edge.then(|| (index, mean_radiance(scene, square)))
        })
        .collect();
    for (index, mean) in means {
        captured.radiance[index] = mean;
    }
}

/// Mean radiance of a texel over its solid angle.
fn mean_radiance(scene: &CpuScene, square: Square) -> Vec3 {
    let (origin, objects) = (
        scene.scene().reference_point.as_dvec3(),
        scene.environment_objects(),
    );
    let fine = square.size * EDGE_RAYS;
    let rays = (0..EDGE_RAYS * EDGE_RAYS).map(|i| {
        let column = square.column * EDGE_RAYS + i % EDGE_RAYS;
        let row = square.row * EDGE_RAYS + i / EDGE_RAYS;
        let (s, t) = (texel_centre(fine, column), texel_centre(fine, row));
        let direction = cube_vector(square.face, s, t).normalize().as_vec3();
        let radiance = match scene.closest(objects, origin, direction, 0.0) {
            Some(hit) => captured_radiance(scene, objects, &hit),
            None => (scene.scene().environment.as_ref())
                .map_or(Vec3::ZERO, |environment| environment.radiance(direction)),
        };
        (radiance, texel_solid_angle_sr(fine, column, row) as f32)
    });
    let (sum, total) = rays.fold((Vec3::ZERO, 0.0), |(sum, total), (radiance, omega_sr)| {
        (sum + radiance * omega_sr, total + omega_sr)
    });
    sum / total
}

/// A captured texel as a patch: its corner rays cut with the plane of the surface at its centre.
fn patch(captured: &CubeImage, square: Square) -> Node {
    let index = square.index();
    let rays = square.rays();
    let middle = rays.iter().sum::<DVec3>().normalize();
    let radiance = captured.radiance[index];
    let distance = captured.distance.get(index).copied();
    let Some(distance) = distance.filter(|d| d.is_finite()).map(f64::from) else {
        let omega_sr = texel_solid_angle_sr(square.size, square.column, square.row) as f32;
        return Node {
            centre: middle.as_vec3(),
            power: radiance * omega_sr,
            measure: omega_sr,
            radius: 0.5 * rays[0].normalize().distance(rays[2].normalize()) as f32,
            at_infinity: true,
            ..Node::default()
        };
    };
    let normal = captured.normal[index].as_dvec3().normalize_or_zero();
    let height = -distance * normal.dot(middle);
    // A plane that some corner ray misses, or meets far behind, is no continuation of the surface:
    // such a texel is a quad across its middle ray.
    let slope = rays.map(|ray| -normal.dot(ray) / ray.length());
    let facing = |&s: &f64| s > 0.2 * (height / distance) && s > 1e-3;
    let (normal, height) = match slope.iter().all(facing) {
        true => (normal, height),
        false => (-middle, distance),
    };
    let corners = rays.map(|ray| ray * (height / -normal.dot(ray)));
    let (p, q) = (corners[2] - corners[0], corners[3] - corners[1]);
    let area = (0.5 * p.cross(q).length()) as f32;
    let centre = middle * distance;
    let radius = corners
        .iter()
        .map(|c| c.distance(centre))
        .fold(0.0, f64::max);
    Node {
        centre: centre.as_vec3(),
        normal: normal.as_vec3(),
        power: radiance * area,
        measure: area,
        radius: radius as f32,
        height: height as f32,
        flat: true,
        uniform: true,
        at_infinity: false,
    }
}
