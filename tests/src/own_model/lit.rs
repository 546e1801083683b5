//! All places that the lights' rays meet first, summed patch by patch.

use super::gather::{IN_PLANE, Seen, Sums, Tile, unit};
use super::near::near;
use super::node::Node;
use glam::{DVec3, Vec3};
use interreflect_cpu::capture::light_view::capture_light_views;
use interreflect_cpu::lane::{Lane, Vector, WIDTH, Wide};
use interreflect_cpu::scene::CpuScene;
use interreflect_cpu::tiles::{PointLanes, TileKernel};
use interreflect_estimators::Quantity;
use interreflect_scene::material::blinn_phong_normalisation;
use interreflect_scene::{
    LightFrame, LightViewChannels, LightViewImage, LightViewSpec, PointLayout, conventions,
};
use std::f64::consts::FRAC_1_PI;

/// Patches of all views of the finer integral, about.
pub(super) const PATCHES: usize = 6 * 96 * 96;

/// The lit patches, and what is gathered from them.
pub(super) struct Lit {
    patches: Vec<Patch>,
    origin: DVec3,
    /// The points reflect by their lobes.
    glossy: bool,
    /// The points reflect by Lambert's law.
    diffuse: bool,
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
    /// Captures `patches` in all views together, about.
    pub(super) fn new(
        scene: &CpuScene,
        directional: bool,
        quantity: Quantity,
        patches: usize,
    ) -> Self {
        let views = scene.scene().light_frames().len().max(1);
        let size = ((patches / views) as f64).sqrt().max(1.0) as u32;
        let channels = LightViewChannels {
            radiance: false,
            normal: true,
            true_colors: true,
        };
        let image = capture_light_views(scene, LightViewSpec { size, channels });
        let origin = scene.scene().reference_point.as_dvec3();
        let lit = (0..image.texels()).filter(|&i| image.path_m[i] > 0.0);
        let glossy = quantity == Quantity::GlossyRadiance;
        Self {
            patches: lit
                .map(|index| Patch::new(&image, index, origin, directional))
                .collect(),
            origin,
            glossy: glossy && directional,
            diffuse: glossy && !directional,
        }
    }
}

impl Patch {
    fn new(image: &LightViewImage, index: usize, origin: DVec3, directional: bool) -> Self {
        let corners = corners(image, index).map(|c| c - origin);
        let [a, b, c, d] = corners;
        let centre = image.position[index].as_dvec3() - origin;
        let area = 0.5 * (c - a).cross(d - b).length();
        let radius = corners
            .iter()
            .map(|p| p.distance(centre))
            .fold(0.0, f64::max);
        let colors = &image.true_colors[index];
        let radiance = colors.diffuse * FRAC_1_PI as f32 * colors.irradiance;
        let highlight = || {
            let norm = blinn_phong_normalisation(f64::from(colors.shininess)) as f32;
            Highlight {
                radiance: colors.specular * colors.irradiance * norm,
                to_light: colors.to_light,
                shininess: colors.shininess,
            }
        };
        Self {
            node: Node {
                centre: centre.as_vec3(),
                normal: image.normal[index],
                power: radiance * area as f32,
                measure: area as f32,
                radius: radius as f32,
                flat: true,
                uniform: true,
                ..Node::default()
            },
            corners,
            highlight: (directional && colors.specular != Vec3::ZERO).then(highlight),
        }
    }

    /// Radiance towards sixteen points, `r` from them to the patch.
    #[inline(always)]
    fn radiance(&self, r: Vector<Wide>) -> [Wide; 3] {
        let splat = |v: f32| Wide([v; WIDTH]);
        let lambertian = self.node.radiance().to_array();
        let Some(highlight) = &self.highlight else {
            return lambertian.map(splat);
        };
        let half = unit(Vector::splat(highlight.to_light.to_array()) - unit(r));
        let cos_half = Vector::splat(self.node.normal.to_array()).dot(half);
        let lobe = cos_half
            .min(Wide::splat(1.0))
            .lobe_power(splat(highlight.shininess));
        let peak = highlight.radiance.to_array();
        std::array::from_fn(|c| splat(lambertian[c]) + lobe * splat(peak[c]))
    }

    /// Adds what the patch sends to the points.
    #[inline(always)]
    fn add(&self, tile: &Tile, sums: &mut Sums) {
        let seen = tile.look(&self.node);
        let least = IN_PLANE * self.node.centre.length();
        if tile.largest(seen.facing) <= least || tile.largest(seen.above) < -self.node.radius {
            return;
        }
        let radiance = self.radiance(seen.r);
        if tile.smallest(seen.r2) > tile.near * self.node.size2() {
            let area = Wide([self.node.measure; WIDTH]);
            tile.add_power(&self.node, radiance.map(|l| l * area), &seen, sums);
        } else {
            self.add_near(tile, &seen, radiance, sums);
        }
    }

    #[inline(never)]
    fn add_near(&self, tile: &Tile, seen: &Seen, radiance: [Wide; 3], sums: &mut Sums) {
        let least = IN_PLANE * self.node.centre.length();
        for i in (0..WIDTH).filter(|&i| tile.alive[i] > 0.0 && seen.facing.0[i] > least) {
            let (diffuse, specular) = near(&tile.receiver(i), &self.corners);
            for (c, radiance) in radiance.iter().enumerate() {
                sums.diffuse[c].0[i] += radiance.0[i] * diffuse as f32;
                sums.specular[c].0[i] += radiance.0[i] * specular as f32;
            }
        }
    }
}

impl TileKernel for Lit {
    #[inline(always)]
    fn shade(&self, points: &PointLanes<'_>) -> [Wide; 3] {
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
        if self.diffuse {
            let over_pi = Wide::splat(FRAC_1_PI);
            return std::array::from_fn(|c| {
                points.plane(PointLayout::DIFFUSE + c) * over_pi * total.diffuse[c]
            });
        }
        total.diffuse
    }
}

/// Corners of a texel on its surface's plane, clockwise seen from the lit side: where its corner
/// rays meet the plane. Behind a mirror, or where the plane is nearly edge-on to a ray, a square of
/// the area that the texel's light falls on.
fn corners(image: &LightViewImage, index: usize) -> [DVec3; 4] {
    let size = image.size as usize;
    let frame = &image.frames[index / (size * size)];
    let (column, row) = ((index % size) as u32, (index / size % size) as u32);
    let position = image.position[index].as_dvec3();
    let normal = image.normal[index].as_dvec3().normalize();
    let corners = cut(frame, image.size, [column, row], position, normal);
    let mut corners = corners.unwrap_or_else(|| {
        let b = f64::from(image.path_m[index]);
        let across = match frame.projection {
            interreflect_scene::Projection::Perspective => b * b,
            interreflect_scene::Projection::Orthographic => 1.0,
        };
        let measure = frame.cell_measure(image.size, column, row);
        let area = measure * across / f64::from(image.cos_light[index]).max(1e-6);
        let (u, v) = normal.any_orthonormal_pair();
        let [u, v] = [u, v].map(|d| d * (0.5 * area.sqrt()));
        [
            position - u - v,
            position - u + v,
            position + u + v,
            position + u - v,
        ]
    });
    let [a, b, c, d] = corners;
    if (c - a).cross(d - b).dot(normal) > 0.0 {
        corners = [a, d, c, b];
    }
    corners
}

/// Where the corner rays meet the plane; `None` if the middle ray does not arrive there, or a corner
/// ray does not.
fn cut(
    frame: &LightFrame,
    size: u32,
    [column, row]: [u32; 2],
    position: DVec3,
    normal: DVec3,
) -> Option<[DVec3; 4]> {
    let [s, t] = [column, row].map(|i| conventions::texel_centre(size, i));
    let (start, middle) = frame.ray(s, t);
    let offset = position - start;
    // Rounding to f32 leaves the ray by less.
    if (offset - middle * offset.dot(middle)).length() > 1e-5 * offset.length() {
        return None;
    }
    let half = 1.0 / f64::from(size);
    let corners = [(-half, -half), (-half, half), (half, half), (half, -half)];
    let mut met = [DVec3::ZERO; 4];
    for (met, (ds, dt)) in met.iter_mut().zip(corners) {
        let (start, ray) = frame.ray(s + ds, t + dt);
        let slope = -normal.dot(ray);
        if slope < 1e-3 || slope < 0.2 * -normal.dot(middle) {
            return None;
        }
        *met = start + ray * (normal.dot(start - position) / slope);
    }
    Some(met)
}
