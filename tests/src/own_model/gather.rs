//! Sixteen points gather from the hierarchy.

use super::hierarchy::Hierarchy;
use super::near::{Receiver, near};
use super::node::{Node, Square};
use glam::{DVec3, Vec3};
use interreflect_cpu::lane::{Lane, Vector, WIDTH, Wide};
use interreflect_cpu::tiles::{PointLanes, TileKernel};
use interreflect_estimators::Quantity;
use interreflect_scene::PointLayout;
use interreflect_scene::material::blinn_phong_normalisation;
use std::f64::consts::FRAC_1_PI;

/// Squared distance over squared radius below which the point kernel is too coarse even for a
/// single patch, whose shape then counts.
const NEAR: f32 = 256.0;

/// Squared distance over squared radius, for each unit of the exponent, at which a node is small
/// in the specular lobe.
const FAR_BY_SHININESS: f32 = 16.0;

/// Height above a flat node's plane, over its distance from the reference point, up to which a
/// point counts as lying in the plane: it may be off it by rounding to f32, and must not see it.
pub(super) const IN_PLANE: f32 = 2e-6;

/// Gathers one quantity from a hierarchy.
pub(super) struct Gather<'a> {
    hierarchy: &'a Hierarchy,
    glossy: bool,
    /// Squared distance over squared radius from which a node counts as a point.
    far: f32,
}

/// Sixteen points, relative to the reference point.
pub(super) struct Tile {
    x: Vector<Wide>,
    n: Vector<Wide>,
    /// 1 where there is a surface, else 0.
    pub(super) alive: [f32; WIDTH],
    far: f32,
    pub(super) near: f32,
    /// There where some point has a specular lobe.
    lobe: Option<Lobe>,
}

struct Lobe {
    view: Vector<Wide>,
    shininess: Wide,
}

/// Sums of power times geometry, and of that times the lobe (N·H)ⁿ.
#[derive(Clone, Copy)]
pub(super) struct Sums {
    pub(super) diffuse: [Wide; 3],
    pub(super) specular: [Wide; 3],
}

/// A node as sixteen points see it.
pub(super) struct Seen {
    /// From the points to the node, not normalised.
    pub(super) r: Vector<Wide>,
    pub(super) r2: Wide,
    /// Length of `r` times the cosine at the point.
    pub(super) above: Wide,
    /// Length of `r` times the cosine at the node.
    pub(super) facing: Wide,
}

impl Sums {
    #[inline(always)]
    pub(super) fn zero() -> Self {
        Self {
            diffuse: [Wide::splat(0.0); 3],
            specular: [Wide::splat(0.0); 3],
        }
    }

    /// What the points' materials reflect of the sums.
    #[inline(always)]
    pub(super) fn reflected(&self, points: &PointLanes<'_>) -> [Wide; 3] {
        let shininess = points.plane(PointLayout::SHININESS).0;
        let norm = Wide(shininess.map(|n| blinn_phong_normalisation(f64::from(n)) as f32));
        std::array::from_fn(|c| {
            let kd = points.plane(PointLayout::DIFFUSE + c) * Wide::splat(FRAC_1_PI);
            let ks = points.plane(PointLayout::SPECULAR + c) * norm;
            kd * self.diffuse[c] + ks * self.specular[c]
        })
    }
}

impl<'a> Gather<'a> {
    pub(super) fn new(hierarchy: &'a Hierarchy, quantity: Quantity, far: f32) -> Self {
        Self {
            hierarchy,
            glossy: quantity == Quantity::GlossyRadiance,
            far,
        }
    }

    /// Adds all that lies in a square of the coarsest level.
    #[inline(always)]
    fn descend(&self, root: Square, tile: &Tile, stack: &mut Vec<Square>, sums: &mut Sums) {
        stack.push(root);
        while let Some(square) = stack.pop() {
            let node = self.hierarchy.node(square);
            let seen = tile.look(node);
            let hidden = node.flat && tile.largest(seen.facing) <= IN_PLANE * node.centre.length();
            if hidden || tile.largest(seen.above) < -node.radius {
                continue;
            }
            let distance2 = tile.smallest(seen.r2);
            let is_patch = self.hierarchy.is_patch(square, node);
            let touching = !node.at_infinity && distance2 < tile.near * node.size2();
            if touching && node.uniform && (is_patch || !self.glossy) {
                self.add_near(square, seen.facing, tile, sums);
            } else if is_patch || distance2 > tile.far * node.size2() {
                tile.add(node, &seen, sums);
            } else {
                stack.extend(square.children());
            }
        }
    }

    /// Adds a near planar node, point by point.
    #[inline(never)]
    fn add_near(&self, square: Square, facing: Wide, tile: &Tile, sums: &mut Sums) {
        let corners = self.hierarchy.corners(square);
        let node = self.hierarchy.node(square);
        let radiance = node.radiance().to_array();
        let least = IN_PLANE * node.centre.length();
        for i in (0..WIDTH).filter(|&i| tile.alive[i] > 0.0 && facing.0[i] > least) {
            let (diffuse, specular) = near(&tile.receiver(i), &corners);
            for (c, radiance) in radiance.into_iter().enumerate() {
                sums.diffuse[c].0[i] += radiance * diffuse as f32;
                sums.specular[c].0[i] += radiance * specular as f32;
            }
        }
    }
}

impl Tile {
    /// Points relative to `origin`; `glossy`: with the lobes of those that have one.
    #[inline(always)]
    pub(super) fn new(points: &PointLanes<'_>, origin: DVec3, glossy: bool, far: f32) -> Self {
        let alive = points.plane(PointLayout::MASK).0;
        let shines = |i: usize| (0..3).any(|c| points.plane(PointLayout::SPECULAR + c).0[i] > 0.0);
        let (mut far, mut near) = (far, NEAR);
        let mut lobe = None;
        if glossy {
            let shininess = points.plane(PointLayout::SHININESS);
            for i in (0..WIDTH).filter(|&i| alive[i] > 0.0 && shines(i)) {
                far = far.max(FAR_BY_SHININESS * shininess.0[i]);
                near = near.max(0.5 * FAR_BY_SHININESS * shininess.0[i]);
                lobe = Some(Lobe {
                    view: points.vector(PointLayout::VIEW),
                    shininess,
                });
            }
        }
        let origin = origin.as_vec3().to_array();
        Self {
            x: points.vector(PointLayout::POSITION) - Vector::splat(origin),
            n: points.vector(PointLayout::NORMAL),
            alive,
            far,
            near,
            lobe,
        }
    }

    #[inline(always)]
    pub(super) fn look(&self, node: &Node) -> Seen {
        let centre = Vector::splat(node.centre.to_array());
        let (r, r2) = match node.at_infinity {
            true => (centre, Wide::splat(1.0)),
            false => (centre - self.x, (centre - self.x).dot(centre - self.x)),
        };
        Seen {
            r,
            r2,
            above: self.n.dot(r),
            facing: Vector::splat((-node.normal).to_array()).dot(r),
        }
    }

    /// Adds a far node by the point kernel.
    #[inline(always)]
    fn add(&self, node: &Node, seen: &Seen, sums: &mut Sums) {
        let power = node.power.to_array().map(|p| Wide([p; WIDTH]));
        self.add_power(node, power, seen, sums);
    }

    /// Adds a far node by the point kernel: power × cosine × cosine' / distance².
    #[inline(always)]
    pub(super) fn add_power(&self, node: &Node, power: [Wide; 3], seen: &Seen, sums: &mut Sums) {
        let zero = Wide::splat(0.0);
        let above = seen.above.max(zero);
        let geometry = match node.at_infinity {
            true => above,
            false => {
                let r4 = (seen.r2 * seen.r2).max(Wide::splat(f64::from(f32::MIN_POSITIVE)));
                above * seen.facing.max(zero) / r4
            }
        };
        accumulate(&mut sums.diffuse, power, geometry);
        let Some(lobe) = &self.lobe else { return };
        let cos_half = self.n.dot(unit(unit(seen.r) + lobe.view));
        let lobe = cos_half.min(Wide::splat(1.0)).lobe_power(lobe.shininess);
        accumulate(&mut sums.specular, power, geometry * lobe);
    }

    /// Point `i` in double precision.
    pub(super) fn receiver(&self, i: usize) -> Receiver {
        let at = |v: &Vector<Wide>| Vec3::new(v.x.0[i], v.y.0[i], v.z.0[i]).as_dvec3();
        let lobe = self.lobe.as_ref();
        Receiver {
            x: at(&self.x),
            n: at(&self.n),
            lobe: lobe.map(|l| (at(&l.view), f64::from(l.shininess.0[i]))),
        }
    }

    /// The largest value of any point.
    #[inline(always)]
    pub(super) fn largest(&self, values: Wide) -> f32 {
        let mut v = values.0;
        for (v, alive) in v.iter_mut().zip(&self.alive) {
            *v = if *alive > 0.0 { *v } else { f32::NEG_INFINITY };
        }
        for half in [8, 4, 2, 1] {
            for i in 0..half {
                v[i] = Lane::max(v[i], v[i + half]);
            }
        }
        v[0]
    }

    /// The smallest value of any point.
    #[inline(always)]
    pub(super) fn smallest(&self, values: Wide) -> f32 {
        -self.largest(-values)
    }
}

#[inline(always)]
fn accumulate(sums: &mut [Wide; 3], power: [Wide; 3], geometry: Wide) {
    for (sum, power) in sums.iter_mut().zip(power) {
        *sum = *sum + geometry * power;
    }
}

/// A vector of length 1.
#[inline(always)]
pub(super) fn unit(v: Vector<Wide>) -> Vector<Wide> {
    let tiny = Wide::splat(f64::from(f32::MIN_POSITIVE));
    v.scale(Wide::splat(1.0) / v.dot(v).max(tiny).sqrt())
}

impl TileKernel for Gather<'_> {
    #[inline(always)]
    fn shade(&self, points: &PointLanes<'_>) -> [Wide; 3] {
        let tile = Tile::new(points, self.hierarchy.origin, self.glossy, self.far);
        let zero = Sums::zero();
        let mut total = zero;
        let mut stack = Vec::new();
        for root in self.hierarchy.roots() {
            // Sums of sums: rounding stays near that of one term.
            let mut part = zero;
            self.descend(root, &tile, &mut stack, &mut part);
            for c in 0..3 {
                total.diffuse[c] = total.diffuse[c] + part.diffuse[c];
                total.specular[c] = total.specular[c] + part.specular[c];
            }
        }
        if !self.glossy {
            return total.diffuse;
        }
        total.reflected(points)
    }
}
