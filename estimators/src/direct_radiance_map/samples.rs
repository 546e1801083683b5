//! Which texels of the views are sampled, how large each is, and the photons that they become.

use super::math::{area_across, equal_angle_texel, hemisphere_share, lit_area, omega_far};
use super::{DirectRadianceMap, Formula, TexelOf};
use crate::texels::math::lobe_normalisation;
use bytemuck::{Pod, Zeroable};
use glam::Vec3;
use interreflect_scene::params::Fidelity;
use interreflect_scene::rsm::view_index;
use interreflect_scene::{LightFrame, Projection, RsmImage};
use std::f32::consts::FRAC_1_PI;

/// A place in the views, as photons.wgsl reads it.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub(super) struct Sample {
    /// Index of its texel.
    pub(super) texel: u32,
    /// Area across the light's way over b², or that area where rays are parallel.
    pub(super) measure: f32,
    /// Tangent of half the view's full angle; 0 where rays are parallel.
    pub(super) half: f32,
    /// Share of the hemisphere in sr (eq 11).
    pub(super) share_sr: f32,
}

/// A lit place, as shade.wgsl reads it: three vectors of four `f32`s.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub(super) struct Photon {
    pub(super) position: [f32; 3],
    /// Solid angle in sr where that is the same from everywhere, else area in m².
    pub(super) extent: f32,
    /// Radiance that is reflected by Lambert's law.
    pub(super) radiance: [f32; 3],
    pub(super) pad: f32,
    pub(super) normal: [f32; 3],
    pub(super) shininess: f32,
}

/// What a photon reflects by its lobe, as shade.wgsl reads it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub(super) struct Highlight {
    /// k_s·E times the lobe's normalisation: radiance at the lobe's peak.
    pub(super) radiance: [f32; 3],
    pub(super) pad: f32,
    /// Unit direction from which light arrives.
    pub(super) to_light: [f32; 3],
    pub(super) pad_to_light: f32,
}

/// The samples of all views, frame by frame and row by row: the texel at the middle of each cell of
/// the grid.
pub(super) fn samples(params: &DirectRadianceMap, frames: &[LightFrame]) -> Vec<Sample> {
    let (n, size) = (params.samples_per_side, params.map_resolution);
    let per_view = (n * n) as usize;
    let middle = |i: u32| (2 * i + 1) * size / (2 * n);
    let mut samples = Vec::with_capacity(frames.len() * per_view);
    for (index, frame) in frames.iter().enumerate() {
        let views = frames.iter().filter(|f| f.light == frame.light).count();
        let share_sr = hemisphere_share(views * per_view) as f32;
        for cell in 0..n * n {
            let (column, row) = (cell % n, cell / n);
            let texel = [middle(column), middle(row)];
            samples.push(Sample {
                texel: view_index(size, index, texel[0], texel[1]) as u32,
                measure: measure(params, frame, [column, row], texel) as f32,
                half: match frame.projection {
                    Projection::Perspective => frame.half,
                    Projection::Orthographic => 0.0,
                },
                share_sr,
            });
        }
    }
    samples
}

/// [`Sample::measure`] of a cell of the grid and the texel at its middle.
fn measure(params: &DirectRadianceMap, frame: &LightFrame, cell: [u32; 2], texel: [u32; 2]) -> f64 {
    let (size, [column, row]) = match params.texel {
        TexelOf::Grid => (params.samples_per_side, cell),
        TexelOf::Texture => (params.map_resolution, texel),
    };
    match (frame.projection, params.fidelity) {
        (Projection::Perspective, Fidelity::Published) => {
            equal_angle_texel(frame.full_angle(), size)
        }
        _ => frame.cell_measure(size, column, row),
    }
}

/// Texels along a row or column of `size` that one of `n` cells covers, with the part of the cell
/// that each covers.
fn covered(n: u32, size: u32, cell: u32) -> impl Iterator<Item = (u32, f32)> + Clone {
    // In units of which a texel has n and a cell `size`.
    let (low, high) = (cell * size, (cell + 1) * size);
    (low / n..high.div_ceil(n)).map(move |texel| {
        let part = high.min((texel + 1) * n) - low.max(texel * n);
        (texel, part as f32 / size as f32)
    })
}

/// Makes the photons of a capture; without those that are none.
pub(super) fn photons(
    params: &DirectRadianceMap,
    views: &RsmImage,
) -> (Vec<Photon>, Vec<Highlight>) {
    let (mut photons, mut highlights) = (Vec::new(), Vec::new());
    let per_view = (params.samples_per_side * params.samples_per_side) as usize;
    for (index, sample) in samples(params, &views.frames).iter().enumerate() {
        if params.averages_cells() {
            let cell = Cell::new(
                params,
                views,
                index / per_view,
                (index % per_view) as u32,
                sample.half,
            );
            if let Some((photon, highlight)) = cell.photon(sample.measure) {
                photons.push(photon);
                highlights.extend(params.shining().then_some(highlight));
            }
            continue;
        }
        let texel = sample.texel as usize;
        if views.path_m[texel] <= 0.0 {
            continue;
        }
        let (diffuse, specular) = match params.mip {
            true => mean(params, views, index / per_view, (index % per_view) as u32),
            false => reflected(views, texel),
        };
        let colors = views.true_colors.get(texel).copied().unwrap_or_default();
        photons.push(Photon {
            position: views.position[texel].to_array(),
            extent: extent(params, sample, views),
            radiance: diffuse.to_array(),
            pad: 0.0,
            normal: views
                .normal
                .get(texel)
                .copied()
                .unwrap_or_default()
                .to_array(),
            shininess: colors.shininess,
        });
        if params.shining() {
            let radiance = specular * lobe_normalisation(colors.shininess);
            highlights.push(Highlight {
                radiance: radiance.to_array(),
                to_light: colors.to_light.to_array(),
                ..Highlight::default()
            });
        }
    }
    (photons, highlights)
}

/// [`Photon::extent`].
fn extent(params: &DirectRadianceMap, sample: &Sample, views: &RsmImage) -> f32 {
    if params.shares_hemisphere() {
        return sample.share_sr;
    }
    let texel = sample.texel as usize;
    let across = area_across(sample.measure, way(views, texel, sample.half));
    match params.formula() {
        Formula::Constant => omega_far(across, views.bounds.diagonal().powi(2)),
        Formula::Published | Formula::Corrected => lit_area(across, views.cos_light[texel]),
    }
}

/// b in m, or 1 where rays are parallel.
fn way(views: &RsmImage, texel: usize, half: f32) -> f32 {
    if half > 0.0 { views.path_m[texel] } else { 1.0 }
}

/// What a texel reflects by Lambert's law, and k_s·E.
fn reflected(views: &RsmImage, texel: usize) -> (Vec3, Vec3) {
    match views.true_colors.get(texel) {
        Some(colors) => (
            colors.diffuse * FRAC_1_PI * colors.irradiance,
            colors.specular * colors.irradiance,
        ),
        None => (views.radiance[texel], Vec3::ZERO),
    }
}

/// The mean of [`reflected`] over a cell of a view: texels without a photon count as dark.
fn mean(params: &DirectRadianceMap, views: &RsmImage, frame: usize, cell: u32) -> (Vec3, Vec3) {
    let (n, size) = (params.samples_per_side, params.map_resolution);
    let columns = covered(n, size, cell % n);
    let (mut diffuse, mut specular) = (Vec3::ZERO, Vec3::ZERO);
    for (row, height) in covered(n, size, cell / n) {
        for (column, width) in columns.clone() {
            let (d, s) = reflected(views, view_index(size, frame, column, row));
            diffuse += d * (width * height);
            specular += s * (width * height);
        }
    }
    (diffuse, specular)
}

/// Sums over the texels of a cell that show a photon, each by the rays that it and the cell have in common.
///
/// All that belongs to a photon is averaged together: its flux A·L is the sum of the texels', its place
/// and normal their mean. A texel's area counts at most as if the cell's horizon were in it.
#[derive(Default)]
struct Cell {
    /// Rays of the whole cell, and of the texels with a photon: no unit, only their ratio counts.
    total: f32,
    lit: f32,
    /// Σ A and Σ A·L, in m² and W/sr but for the unit of the rays.
    area: f32,
    diffuse: Vec3,
    specular: Vec3,
    position: Vec3,
    normal: Vec3,
    to_light: Vec3,
    shininess: f32,
}

impl Cell {
    fn new(
        params: &DirectRadianceMap,
        views: &RsmImage,
        frame: usize,
        cell: u32,
        half: f32,
    ) -> Self {
        let (n, size) = (params.samples_per_side, params.map_resolution);
        let columns = covered(n, size, cell % n);
        let mut sums = Self::default();
        for (row, height) in covered(n, size, cell / n) {
            for (column, width) in columns.clone() {
                let rays = width * height * density(half, size, column, row);
                sums.total += rays;
                let texel = view_index(size, frame, column, row);
                if views.path_m[texel] > 0.0 {
                    let across = area_across(rays, way(views, texel, half));
                    sums.add(views, texel, (rays, across, 1.0 / n as f32));
                }
            }
        }
        sums
    }

    fn add(&mut self, views: &RsmImage, texel: usize, (rays, across, least_cos): (f32, f32, f32)) {
        let cos_light = views.cos_light[texel];
        let (diffuse, specular) = reflected(views, texel);
        let area = lit_area(across, cos_light);
        self.lit += rays;
        self.area += lit_area(across, cos_light.max(least_cos));
        self.diffuse += diffuse * area;
        self.specular += specular * area;
        self.position += views.position[texel] * rays;
        self.normal += views.normal[texel] * rays;
        if let Some(colors) = views.true_colors.get(texel) {
            self.to_light += colors.to_light * rays;
            self.shininess += colors.shininess * rays;
        }
    }

    /// The cell as one photon, `measure` its [`Sample::measure`]; `None` without light.
    fn photon(&self, measure: f32) -> Option<(Photon, Highlight)> {
        if self.lit <= 0.0 {
            return None;
        }
        let shininess = self.shininess / self.lit;
        let photon = Photon {
            position: (self.position / self.lit).to_array(),
            extent: self.area * (measure / self.total),
            radiance: (self.diffuse / self.area).to_array(),
            pad: 0.0,
            normal: self.normal.normalize_or_zero().to_array(),
            shininess,
        };
        let radiance = self.specular / self.area * lobe_normalisation(shininess);
        let highlight = Highlight {
            radiance: radiance.to_array(),
            to_light: self.to_light.normalize_or_zero().to_array(),
            ..Highlight::default()
        };
        Some((photon, highlight))
    }
}

/// Solid angle of a texel over that of one in the middle of the view: 1 where rays are parallel.
fn density(half: f32, size: u32, column: u32, row: u32) -> f32 {
    let at = |i: u32| half * (2.0 * (i as f32 + 0.5) / size as f32 - 1.0);
    let (a, b) = (at(column), at(row));
    let l2 = 1.0 + a * a + b * b;
    1.0 / (l2 * l2.sqrt())
}
