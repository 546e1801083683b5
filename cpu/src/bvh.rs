//! Ray queries on a triangle soup: an eight-wide BVH (obvhs) with a watertight triangle test.
//!
//! Boxes are tested in f32 and padded so that rounding never drops one that the ray enters;
//! triangles are tested in f64 on the ray as given. A ray can therefore start *on* a triangle:
//! `t_min` only has to exceed f64 rounding, and nothing is moved off the surface.

use glam::{DVec3, Vec3, Vec3A};
use obvhs::{
    Boundable,
    aabb::Aabb,
    bvh2::reinsertion::ReinsertionOptimizer,
    cwbvh::{CwBvh, bvh2_to_cwbvh::bvh2_to_cwbvh},
    ploc::{PlocBuilder, PlocSearchDistance, SortPrecision},
    ray::{Ray, RayHit},
};

/// Padding of boxes relative to the largest coordinate: above the error of f32 slab tests (a few
/// 1e-7), far below the size of triangles.
const PADDING: f32 = 4e-6;
/// Boxes nearer than 1e-4 are skipped by obvhs, so boxes see the ray start this much earlier.
const HEAD_START: f32 = 2e-4;
/// Edge functions below this multiple of the squared distance to the corners count as zero; f64
/// rounding stays below it.
const EDGE_ROUNDING: f64 = 4e-15;
/// From this many triangles on, the tree is built fast rather than well.
const BIG_MESH: usize = 200_000;

/// The nearest intersection of a ray with a triangle soup.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Ray parameter: metres for a unit direction.
    pub distance: f64,
    /// Index of the triangle in the soup.
    pub triangle: u32,
    /// Weights of the triangle's three corners, ≥ 0 up to rounding, with sum 1.
    pub barycentric: [f64; 3],
}

/// A bounding-volume hierarchy over a triangle soup. Immutable; queries may run on any thread.
///
/// Answers do not depend on the shape of the tree: of equally near triangles the one with the
/// lower index is hit.
#[derive(Clone, Debug, Default)]
pub struct Bvh {
    tree: CwBvh,
    /// Corners in the tree's order.
    triangles: Vec<[Vec3; 3]>,
    /// How much earlier than asked boxes see the ray start, in units of t.
    head_start: f32,
}

struct PaddedTriangle<'a> {
    corners: &'a [Vec3; 3],
    padding: f32,
}

impl Boundable for PaddedTriangle<'_> {
    fn aabb(&self) -> Aabb {
        let [a, b, c] = self.corners.map(Vec3A::from);
        Aabb::new(
            a.min(b).min(c) - self.padding,
            a.max(b).max(c) + self.padding,
        )
    }
}

impl Bvh {
    /// Builds the hierarchy. Coordinates must be finite and below 1e15; triangles without area
    /// are allowed and never hit. Big meshes get a faster build and a slightly slower tree.
    pub fn new(soup: &[[Vec3; 3]]) -> Self {
        if soup.is_empty() {
            return Self::default();
        }
        let reach = soup
            .iter()
            .flatten()
            .fold(0.0_f32, |m, c| m.max(c.abs().max_element()));
        let padding = (PADDING * reach).max(f32::MIN_POSITIVE);
        let boxes: Vec<_> = soup
            .iter()
            .map(|corners| PaddedTriangle { corners, padding })
            .collect();
        let (distance, threshold, reinsertion) = match soup.len() {
            BIG_MESH.. => (PlocSearchDistance::Low, 2, 0.01),
            _ => (PlocSearchDistance::Medium, 3, 0.05),
        };
        let mut binary = PlocBuilder::with_capacity(soup.len()).build(
            distance,
            &boxes,
            (0..soup.len() as u32).collect(),
            SortPrecision::U64,
            threshold,
        );
        ReinsertionOptimizer::default().run(&mut binary, reinsertion, None);
        let tree = bvh2_to_cwbvh(&binary, 3, true, false);
        let triangles = tree
            .primitive_indices
            .iter()
            .map(|&i| soup[i as usize])
            .collect();
        Self {
            tree,
            triangles,
            head_start: HEAD_START.max(padding),
        }
    }

    /// Nearest triangle with `t_min` < t < `t_max` along `origin` + t·`direction`; both sides of a
    /// triangle are hit. A ray that is not finite hits nothing.
    pub fn closest(&self, origin: DVec3, direction: DVec3, t_min: f64, t_max: f64) -> Option<Hit> {
        let ray = self.box_ray(origin, direction, t_max)?;
        let mut best: Option<Hit> = None;
        self.tree.ray_traverse(ray, &mut RayHit::none(), |_, slot| {
            let far = best.map_or(t_max, |h| h.distance);
            let Some(hit) = self.intersect(slot, origin, direction, t_min) else {
                return f32::INFINITY;
            };
            let nearer = hit.distance < far
                || best.is_some_and(|b| hit.distance == far && hit.triangle < b.triangle);
            if !nearer {
                return f32::INFINITY;
            }
            best = Some(hit);
            self.box_distance(hit.distance)
        });
        best
    }

    /// Whether any triangle lies at `t_min` < t < `t_max`.
    pub fn occluded(&self, origin: DVec3, direction: DVec3, t_min: f64, t_max: f64) -> bool {
        let Some(ray) = self.box_ray(origin, direction, t_max) else {
            return false;
        };
        !self.tree.ray_traverse_miss(ray, |_, slot| {
            match self.intersect(slot, origin, direction, t_min) {
                Some(hit) if hit.distance < t_max => f32::NEG_INFINITY,
                _ => f32::INFINITY,
            }
        })
    }

    /// Every triangle with t > `t_min` along the ray, nearest first.
    pub fn all(&self, origin: DVec3, direction: DVec3, t_min: f64) -> Vec<Hit> {
        let mut hits = Vec::new();
        if let Some(ray) = self.box_ray(origin, direction, f64::INFINITY) {
            self.tree.ray_traverse_anyhit(ray, |_, slot| {
                hits.extend(self.intersect(slot, origin, direction, t_min));
            });
        }
        hits.sort_by(|a, b| (a.distance.total_cmp(&b.distance)).then(a.triangle.cmp(&b.triangle)));
        hits
    }

    /// The f32 ray that boxes are tested with; `None` if it is not finite.
    fn box_ray(&self, origin: DVec3, direction: DVec3, t_max: f64) -> Option<Ray> {
        // Adding +0 turns −0 into +0, whose inverse has the sign that obvhs orders slabs by.
        let direction = direction.as_vec3a() + Vec3A::ZERO;
        let start = origin.as_vec3a() - direction * self.head_start;
        let finite = start.is_finite() && direction.is_finite() && !t_max.is_nan();
        finite.then(|| Ray::new(start, direction, 0.0, self.box_distance(t_max)))
    }

    /// The parameter along the box ray, rounded up, of parameter `t` along the given ray.
    fn box_distance(&self, t: f64) -> f32 {
        ((t + f64::from(self.head_start)) as f32).next_up()
    }

    /// Ray against the triangle in a slot of the tree, by signed volumes (edge functions) in f64.
    ///
    /// The volume of the ray with a shared edge is the same number with opposite sign for both
    /// neighbours, so a ray between them always hits one; volumes within rounding of zero count
    /// as inside, so that rays through edges and corners hit as well.
    #[inline]
    fn intersect(&self, slot: usize, origin: DVec3, direction: DVec3, t_min: f64) -> Option<Hit> {
        let [a, b, c] = self.triangles[slot].map(|p| p.as_dvec3() - origin);
        let u = direction.dot(c.cross(b));
        let v = direction.dot(a.cross(c));
        let w = direction.dot(b.cross(a));
        let reach = a.abs().max(b.abs()).max(c.abs()).max_element();
        let zero = EDGE_ROUNDING * reach * reach;
        if u.min(v).min(w) < -zero && u.max(v).max(w) > zero {
            return None;
        }
        let sum = u + v + w;
        if sum.abs() <= zero {
            return None; // seen edge-on, or without area: its neighbours are hit instead
        }
        let normal = (b - a).cross(c - a);
        let distance = a.dot(normal) / direction.dot(normal);
        (distance > t_min && distance.is_finite()).then(|| Hit {
            distance,
            triangle: self.tree.primitive_indices[slot],
            barycentric: [u / sum, v / sum, w / sum],
        })
    }
}
