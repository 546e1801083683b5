//! The box-filtered mip pyramid on the CPU, in the arithmetic and order of the GPU's.

use super::super::ShMipEnvmap;
use super::super::math::{level_offset, mip_taps, neighbour};
use super::super::tables::box_weights;
use crate::averaging::{averaged, cube_texels};
use glam::Vec3;
use interreflect_cpu::lane::{Scalar, Vector};
use interreflect_scene::CubeImage;
use interreflect_scene::conventions::{CUBE_FACES, texel_index};
use interreflect_scene::params::Fidelity;

/// Weights of the texels that are averaged: of the capture, and of each level but the coarsest,
/// the finest first.
pub(super) struct BoxWeights {
    captured: Vec<f32>,
    levels: Vec<Vec<f32>>,
}

impl BoxWeights {
    pub(super) fn new(method: &ShMipEnvmap) -> Self {
        let weights = |size| box_weights(method.fidelity, size);
        let levels = 0..method.top_level();
        Self {
            captured: weights(method.captured().size),
            levels: levels.map(|l| weights(method.base_size() >> l)).collect(),
        }
    }
}

/// All levels with their borders, the finest first.
pub(super) struct Pyramid {
    base: u32,
    top: u32,
    texels: Vec<Vec3>,
}

impl Pyramid {
    /// Averages the capture down, level by level, and fills the borders.
    pub(super) fn new(method: &ShMipEnvmap, weights: &BoxWeights, captured: &CubeImage) -> Self {
        let base = method.base_size();
        let coarsest = CUBE_FACES * 9;
        let mut pyramid = Self {
            base,
            top: method.top_level(),
            texels: vec![Vec3::ZERO; level_offset(base, 1) as usize + coarsest],
        };
        let means = averaged(captured, &weights.captured, base);
        for ((face, column, row), mean) in cube_texels(base).zip(means) {
            let place = pyramid.place(base, face, column + 1, row + 1);
            pyramid.texels[place] = mean;
        }
        for (level, weights) in weights.levels.iter().enumerate() {
            pyramid.reduce(base >> (level + 1), weights);
        }
        for level in 0..=pyramid.top {
            pyramid.fill_border(base >> level, method.fidelity);
        }
        pyramid
    }

    /// All levels with their borders, the finest first.
    pub(super) fn texels(&self) -> &[Vec3] {
        &self.texels
    }

    /// Place of a stored texel of a level of `size`² texels: columns and rows count the border.
    fn place(&self, size: u32, face: usize, column: u32, row: u32) -> usize {
        level_offset(self.base, size) as usize + texel_index(size + 2, face, column, row)
    }

    /// A texel of a level, without the border.
    fn texel(&self, size: u32, (face, column, row): (usize, u32, u32)) -> Vec3 {
        self.texels[self.place(size, face, column + 1, row + 1)]
    }

    /// Fills a level of `size`² texels from the finer one, whose texels count by `weights`.
    fn reduce(&mut self, size: u32, weights: &[f32]) {
        let finer = 2 * size;
        for (face, column, row) in cube_texels(size) {
            let (mut sum, mut total) = (Vec3::ZERO, 0.0);
            for k in 0..4 {
                let (column, row) = (2 * column + k % 2, 2 * row + k / 2);
                let weight = weights[texel_index(finer, 0, column, row)];
                sum += self.texel(finer, (face, column, row)) * weight;
                total += weight;
            }
            let place = self.place(size, face, column + 1, row + 1);
            self.texels[place] = sum / total;
        }
    }

    /// Fills the border of a level: `published` repeats a face's own texels, `corrected` takes the
    /// neighbours' across the edges, and the mean of the three that meet in a corner.
    fn fill_border(&mut self, size: u32, fidelity: Fidelity) {
        let last = size as i32;
        for (face, column, row) in cube_texels(size + 2) {
            let (c, r) = (column as i32 - 1, row as i32 - 1);
            let (inside_c, inside_r) = (c.clamp(0, last - 1), r.clamp(0, last - 1));
            let (beyond_c, beyond_r) = (c != inside_c, r != inside_r);
            if !beyond_c && !beyond_r {
                continue;
            }
            let of = |column, row| self.texel(size, neighbour(size, face, column, row));
            let value = match fidelity {
                Fidelity::Published => of(inside_c, inside_r),
                Fidelity::Corrected if beyond_c && beyond_r => {
                    (of(inside_c, inside_r) + of(c, inside_r) + of(inside_c, r)) / 3.0
                }
                Fidelity::Corrected => of(c, r),
            };
            let place = self.place(size, face, column, row);
            self.texels[place] = value;
        }
    }

    /// Bilinear radiance of a level in a direction.
    #[inline(always)]
    fn bilinear<S: Scalar>(&self, level: u32, direction: Vector<S>) -> Vector<S> {
        let size = self.base >> level;
        let (first, u, v) = mip_taps(size, direction);
        let first = level_offset(self.base, size) as usize + first;
        let below = first + size as usize + 2;
        let one = S::from(1.0);
        let texel = |i: usize| Vector::splat(self.texels[i].to_array());
        texel(first).scale((one - u) * (one - v))
            + texel(first + 1).scale(u * (one - v))
            + texel(below).scale((one - u) * v)
            + texel(below + 1).scale(u * v)
    }

    /// Trilinear radiance at a level in [0, top], in a direction that need not be unit.
    #[inline(always)]
    pub(super) fn radiance<S: Scalar>(&self, direction: Vector<S>, level: S) -> Vector<S> {
        let fine = (level.whole() as u32).min(self.top);
        let fraction = level - S::from(fine as f32);
        let value = self.bilinear(fine, direction);
        if fraction <= S::from(0.0) || fine == self.top {
            return value;
        }
        let coarse = self.bilinear(fine + 1, direction);
        value.scale(S::from(1.0) - fraction) + coarse.scale(fraction)
    }
}
