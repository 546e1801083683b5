//! All places that the lights' rays meet first, summed patch by patch.

use super::cell::{Cell, corners, is_edge};
use super::gather::{IN_PLANE, Sums, Tile, unit};
use super::node::Node;
use glam::{DVec3, Vec3};
use interreflect_cpu::lane::{Lane, Vector};
use interreflect_cpu::scene::CpuScene;
use interreflect_cpu::tiles::{PointLanes, TileKernel};
use interreflect_estimators::Quantity;
use interreflect_scene::material::blinn_phong_normalisation;
use interreflect_scene::{LightFrame, RsmViews};
use rayon::prelude::*;

/// Patches of all views of the finer integral, about.
pub(super) const PATCHES: usize = 6 * 96 * 96;

/// The lit patches, and what is gathered from them.
pub(super) struct Lit {
    patches: Vec<Patch>,
    origin: DVec3,
    /// The points reflect by their lobes.
    glossy: bool,
}

struct Patch {
    node: Node,
    /// Relative to the reference point, clockwise seen from the lit side.
    corners: [DVec3; 4],
    highlight: Option<Highlight>,
}

/// What a patch reflects by its lobe.
struct Highlight {
    /// Radiance at its peak.
    radiance: Vec3,
    to_light: Vec3,
    shininess: f32,
}

impl Lit {
    /// Traces `patches` in all views together, about, and more where edges cut them.
    pub(super) fn new(
        scene: &CpuScene,
        directional: bool,
        quantity: Quantity,
        patches: usize,
    ) -> Self {
        let frames = scene.scene().light_frames(RsmViews::Surround);
        let size = ((patches / frames.len().max(1)) as f64).sqrt().max(1.0) as u32;
        let origin = scene.scene().reference_point.as_dvec3();
        let mut patches = Vec::new();
        for frame in &frames {
            let cells: Vec<Cell> = (0..size * size)
                .into_par_iter()
                .map(|i| Cell::new(scene, frame, size, [i % size, i / size]))
                .collect();
            let parts = (0..cells.len()).into_par_iter().flat_map_iter(|i| {
                match is_edge(&cells, i, size as usize) {
                    true => cells[i].parts(scene, frame),
                    false => vec![cells[i]],
                }
            });
            let patch = |cell: Cell| Patch::new(frame, &cell, origin, directional);
            patches.extend(parts.filter_map(patch).collect::<Vec<_>>());
        }
        Self {
            patches,
            origin,
            glossy: quantity == Quantity::GlossyRadiance,
        }
    }
}

impl Patch {
    /// The patch of a lit cell.
    fn new(frame: &LightFrame, cell: &Cell, origin: DVec3, directional: bool) -> Option<Self> {
        let place = cell.place.as_ref()?;
        let corners = corners(frame, cell, place).map(|c| c - origin);
        let [a, b, c, d] = corners;
        let centre = place.position - origin;
        let area = 0.5 * (c - a).cross(d - b).length();
        let radius = corners
            .iter()
            .map(|p| p.distance(centre))
            .fold(0.0, f64::max);
        let colors = &place.colors;
        let highlight = || {
            let norm = blinn_phong_normalisation(f64::from(colors.shininess)) as f32;
            Highlight {
                radiance: colors.specular * colors.irradiance * norm,
                to_light: colors.to_light,
                shininess: colors.shininess,
            }
        };
        Some(Self {
            node: Node {
                centre: centre.as_vec3(),
                normal: place.normal,
                power: place.radiance() * area as f32,
                measure: area as f32,
                radius: radius as f32,
                flat: true,
                uniform: true,
                ..Node::default()
            },
            corners,
            highlight: (directional && colors.specular != Vec3::ZERO).then(highlight),
        })
    }

    /// Radiance towards the points, `r` from them to the patch.
    #[inline(always)]
    fn radiance<L: Lane>(&self, r: Vector<L>) -> [L; 3] {
        let lambertian = self.node.radiance().to_array();
        let Some(highlight) = &self.highlight else {
            return lambertian.map(L::from);
        };
        let half = unit(Vector::splat(highlight.to_light.to_array()) - unit(r));
        let cos_half = Vector::splat(self.node.normal.to_array()).dot(half);
        let lobe = cos_half
            .min(L::from(1.0))
            .lobe_power(highlight.shininess.into());
        let peak = highlight.radiance.to_array();
        std::array::from_fn(|c| L::from(lambertian[c]) + lobe * L::from(peak[c]))
    }

    /// Adds what the patch sends to the points.
    #[inline(always)]
    fn add<L: Lane>(&self, tile: &Tile<L>, sums: &mut Sums<L>) {
        let scalar = L::Scalar::from;
        let seen = tile.look(&self.node);
        let least = IN_PLANE * self.node.centre.length();
        let hidden = tile.largest(seen.facing) <= scalar(least);
        if hidden || tile.largest(seen.above) < scalar(-self.node.radius) {
            return;
        }
        let radiance = self.radiance(seen.r);
        if tile.smallest(seen.r2) > tile.near * scalar(self.node.size2()) {
            let area = L::from(self.node.measure);
            tile.add_power(&self.node, radiance.map(|l| l * area), &seen, sums);
        } else {
            let corners = (&self.corners, radiance);
            tile.add_corners(corners, (seen.facing, least), sums);
        }
    }
}

impl TileKernel for Lit {
    #[inline(always)]
    fn shade<L: Lane>(&self, points: &PointLanes<'_, L>) -> [L; 3] {
        let tile = Tile::new(points, self.origin, self.glossy, 0.0);
        let mut total = Sums::zero();
        // Sums of sums: rounding stays near that of one term.
        for patches in self.patches.chunks(1024) {
            let mut part = Sums::zero();
            for patch in patches {
                patch.add(&tile, &mut part);
            }
            for c in 0..3 {
                total.diffuse[c] = total.diffuse[c] + part.diffuse[c];
                total.specular[c] = total.specular[c] + part.specular[c];
            }
        }
        if self.glossy {
            return total.reflected(points);
        }
        total.diffuse
    }
}
