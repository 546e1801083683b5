//! A patch, or several merged in one.

use glam::{DVec3, Vec3};
use interreflect_scene::conventions::{cube_vector, texel_index, texel_solid_angle_sr};

/// A square of texels of one level.
#[derive(Clone, Copy, Debug)]
pub(super) struct Square {
    pub(super) size: u32,
    pub(super) face: usize,
    pub(super) column: u32,
    pub(super) row: u32,
}

impl Square {
    pub(super) fn of_index(size: u32, index: usize) -> Self {
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

    /// Its place, row by row, in the patch that is so many levels coarser.
    pub(super) fn within(self, levels: usize) -> usize {
        let last = (1 << levels) - 1;
        (((self.row & last) << levels) | (self.column & last)) as usize
    }

    /// The squares beside it on the same face.
    pub(super) fn neighbours(self) -> impl Iterator<Item = Self> {
        [(-1, 0), (1, 0), (0, -1), (0, 1)]
            .into_iter()
            .filter_map(move |(column, row)| {
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
    /// Of a patch with an edge in it: where its parts are.
    pub(super) split: Option<u32>,
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

    pub(super) fn merge(children: [&Node; 4]) -> Self {
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
            split: None,
        }
    }

    /// Whether an edge of a surface or of a shadow lies between this patch and its neighbour.
    pub(super) fn is_cut_off_from(&self, neighbour: &Self) -> bool {
        let (a, b) = (self.radiance(), neighbour.radiance());
        if self.at_infinity != neighbour.at_infinity
            || (a - b).abs().max_element() > 0.1 * a.max(b).max_element()
        {
            return true;
        }
        let off_plane = self.normal.dot(neighbour.centre) + self.height;
        !self.at_infinity
            && (self.normal.dot(neighbour.normal) < 0.9 || off_plane.abs() > 0.5 * self.radius)
    }
}

/// A captured texel as a patch: its corner rays cut with the plane of the surface at its centre.
pub(super) fn patch(square: Square, radiance: Vec3, distance: f32, normal: Vec3) -> Node {
    let rays = square.rays();
    let middle = rays.iter().sum::<DVec3>().normalize();
    if !distance.is_finite() {
        let omega_sr = texel_solid_angle_sr(square.size, square.column, square.row) as f32;
        return Node {
            centre: middle.as_vec3(),
            power: radiance * omega_sr,
            measure: omega_sr,
            radius: 0.5 * rays[0].normalize().distance(rays[2].normalize()) as f32,
            at_infinity: true,
            ..Node::default()
        };
    }
    let distance = f64::from(distance);
    let normal = normal.as_dvec3().normalize_or_zero();
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
        split: None,
    }
}
