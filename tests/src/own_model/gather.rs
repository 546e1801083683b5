//! Points that lie side by side gather from the hierarchy together.
//!
//! Longer than most: what a tile knows, which nodes it takes whole and what it sums are one kernel.

use super::hierarchy::Hierarchy;
use super::near::{Receiver, near};
use super::node::{Node, Square};
use glam::DVec3;
use interreflect_cpu::lane::{Lane, Vector};
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

/// Neighbouring points, relative to the reference point: how finely all of them sum is decided by
/// the one that asks for most, so that fewer side by side give other roundings and errors.
pub(super) struct Tile<L: Lane> {
    x: Vector<L>,
    n: Vector<L>,
    /// 1 where there is a surface, else 0.
    pub(super) alive: L,
    far: L::Scalar,
    pub(super) near: L::Scalar,
    /// There where some point has a specular lobe.
    lobe: Option<Lobe<L>>,
}

struct Lobe<L> {
    view: Vector<L>,
    shininess: L,
}

/// Sums of power times geometry, and of that times the lobe (N·H)ⁿ.
#[derive(Clone, Copy)]
pub(super) struct Sums<L> {
    pub(super) diffuse: [L; 3],
    pub(super) specular: [L; 3],
}

/// A node as the points see it.
pub(super) struct Seen<L> {
    /// From the points to the node, not normalised.
    pub(super) r: Vector<L>,
    pub(super) r2: L,
    /// Length of `r` times the cosine at the point.
    pub(super) above: L,
    /// Length of `r` times the cosine at the node.
    pub(super) facing: L,
}

impl<L: Lane> Sums<L> {
    #[inline(always)]
    pub(super) fn zero() -> Self {
        Self {
            diffuse: [L::from(0.0); 3],
            specular: [L::from(0.0); 3],
        }
    }

    /// What the points' materials reflect of the sums.
    #[inline(always)]
    pub(super) fn reflected(&self, points: &PointLanes<'_, L>) -> [L; 3] {
        let shininess = points.plane(PointLayout::SHININESS);
        let norm = |n: L::Scalar| L::Scalar::splat(blinn_phong_normalisation(n.into()));
        let norm = L::by_lane(|i| norm(shininess.lanes()[i]));
        std::array::from_fn(|c| {
            let kd = points.plane(PointLayout::DIFFUSE + c) * L::splat(FRAC_1_PI);
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
    fn descend<L: Lane>(
        &self,
        root: Square,
        tile: &Tile<L>,
        stack: &mut Vec<Square>,
        sums: &mut Sums<L>,
    ) {
        let scalar = L::Scalar::from;
        stack.push(root);
        while let Some(square) = stack.pop() {
            let node = self.hierarchy.node(square);
            let seen = tile.look(node);
            let hidden =
                node.flat && tile.largest(seen.facing) <= scalar(IN_PLANE * node.centre.length());
            if hidden || tile.largest(seen.above) < scalar(-node.radius) {
                continue;
            }
            let distance2 = tile.smallest(seen.r2);
            let is_patch = self.hierarchy.is_patch(square, node);
            let touching = !node.at_infinity && distance2 < tile.near * scalar(node.size2());
            if touching && node.uniform && (is_patch || !self.glossy) {
                self.add_near(square, seen.facing, tile, sums);
            } else if is_patch || distance2 > tile.far * scalar(node.size2()) {
                tile.add(node, &seen, sums);
            } else {
                stack.extend(square.children());
            }
        }
    }

    /// Adds a near planar node, point by point.
    #[inline(always)]
    fn add_near<L: Lane>(&self, square: Square, facing: L, tile: &Tile<L>, sums: &mut Sums<L>) {
        let corners = self.hierarchy.corners(square);
        let node = self.hierarchy.node(square);
        let radiance = node.radiance().to_array().map(L::from);
        let least = IN_PLANE * node.centre.length();
        tile.add_corners((&corners, radiance), (facing, least), sums);
    }
}

impl<L: Lane> Tile<L> {
    /// Points relative to `origin`; `glossy`: with the lobes of those that have one.
    #[inline(always)]
    pub(super) fn new(points: &PointLanes<'_, L>, origin: DVec3, glossy: bool, far: f32) -> Self {
        let scalar = L::Scalar::from;
        let alive: L = points.plane(PointLayout::MASK);
        let (mut far, mut near) = (scalar(far), scalar(NEAR));
        let mut lobe = None;
        if glossy {
            let shininess: L = points.plane(PointLayout::SHININESS);
            let [r, g, b] = points.vector(PointLayout::SPECULAR).to_array();
            let specular = alive.min(r.max(g).max(b));
            let shining = |i: &usize| specular.lanes()[*i] > scalar(0.0);
            for i in (0..L::WIDTH).filter(shining) {
                let by_shininess = scalar(FAR_BY_SHININESS) * shininess.lanes()[i];
                far = far.max(by_shininess);
                near = near.max(scalar(0.5) * by_shininess);
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
    pub(super) fn look(&self, node: &Node) -> Seen<L> {
        let centre = Vector::splat(node.centre.to_array());
        let (r, r2) = match node.at_infinity {
            true => (centre, L::from(1.0)),
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
    fn add(&self, node: &Node, seen: &Seen<L>, sums: &mut Sums<L>) {
        let power = node.power.to_array().map(L::from);
        self.add_power(node, power, seen, sums);
    }

    /// Adds a far node by the point kernel: power × cosine × cosine' / distance².
    #[inline(always)]
    pub(super) fn add_power(&self, node: &Node, power: [L; 3], seen: &Seen<L>, sums: &mut Sums<L>) {
        let zero = L::from(0.0);
        let above = seen.above.max(zero);
        let geometry = match node.at_infinity {
            true => above,
            false => {
                let r4 = (seen.r2 * seen.r2).max(L::from(f32::MIN_POSITIVE));
                above * seen.facing.max(zero) / r4
            }
        };
        accumulate(&mut sums.diffuse, power, geometry);
        let Some(lobe) = &self.lobe else { return };
        let cos_half = self.n.dot(unit(unit(seen.r) + lobe.view));
        let lobe = cos_half.min(L::from(1.0)).lobe_power(lobe.shininess);
        accumulate(&mut sums.specular, power, geometry * lobe);
    }

    /// Adds a near quadrilateral of these radiances, point by point, to points more than `least` in
    /// front of it.
    #[inline(never)]
    pub(super) fn add_corners(
        &self,
        (corners, radiance): (&[DVec3; 4], [L; 3]),
        (facing, least): (L, f32),
        sums: &mut Sums<L>,
    ) {
        let scalar = L::Scalar::from;
        let sees =
            |i: usize| self.alive.lanes()[i] > scalar(0.0) && facing.lanes()[i] > scalar(least);
        for i in (0..L::WIDTH).filter(|&i| sees(i)) {
            let (diffuse, specular) = near(&self.receiver(i), corners);
            for c in 0..3 {
                let radiance = radiance[c].lanes()[i];
                let add = |sum: &mut L, factor: f64| {
                    let sum = &mut sum.lanes_mut()[i];
                    *sum = *sum + radiance * L::Scalar::splat(factor);
                };
                add(&mut sums.diffuse[c], diffuse);
                add(&mut sums.specular[c], specular);
            }
        }
    }

    /// Point `i` in double precision.
    fn receiver(&self, i: usize) -> Receiver {
        let lobe = self.lobe.as_ref();
        Receiver {
            x: self.x.lane(i).into(),
            n: self.n.lane(i).into(),
            lobe: lobe.map(|l| (l.view.lane(i).into(), l.shininess.lanes()[i].into())),
        }
    }

    /// The largest value of any point.
    #[inline(always)]
    pub(super) fn largest(&self, values: L) -> L::Scalar {
        let nothing = L::from(f32::NEG_INFINITY);
        self.alive
            .select_gt(L::from(0.0), values, nothing)
            .largest()
    }

    /// The smallest value of any point.
    #[inline(always)]
    pub(super) fn smallest(&self, values: L) -> L::Scalar {
        -self.largest(-values)
    }
}

#[inline(always)]
fn accumulate<L: Lane>(sums: &mut [L; 3], power: [L; 3], geometry: L) {
    for (sum, power) in sums.iter_mut().zip(power) {
        *sum = *sum + geometry * power;
    }
}

/// A vector of length 1.
#[inline(always)]
pub(super) fn unit<L: Lane>(v: Vector<L>) -> Vector<L> {
    let tiny = L::from(f32::MIN_POSITIVE);
    v.scale(L::from(1.0) / v.dot(v).max(tiny).sqrt())
}

impl TileKernel for Gather<'_> {
    #[inline(always)]
    fn shade<L: Lane>(&self, points: &PointLanes<'_, L>) -> [L; 3] {
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
