//! The shaded points, in one layout with the same bytes on both backends.
//!
//! Points come in blocks of [`LANES`] lanes; a block is a run of planes of [`LANES`] `f32` each,
//! in the order of the offsets below. Estimates come in blocks of three planes (R, G, B). Lanes
//! after the last point, and points without a surface, have a mask of 0.

mod check;

pub use check::PointError;

use glam::Vec3;

/// Points in a block.
pub const LANES: usize = 64;

/// Planes that a point list carries; the first seven are always there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum PointLayout {
    /// Position, normal and mask: enough for irradiance and ambient occlusion.
    Surface,
    /// As `Surface`, then view direction, k_d, k_s, shininess and footprint: enough for reflected
    /// radiance.
    Material,
}

impl PointLayout {
    /// First plane of the position (x, y, z) in metres.
    pub const POSITION: usize = 0;
    /// First plane of the unit shading normal.
    pub const NORMAL: usize = 3;
    /// Plane of the mask: 1 where there is a surface, else 0.
    pub const MASK: usize = 6;
    /// First plane of the unit direction to the viewer.
    pub const VIEW: usize = 7;
    /// First plane of the diffuse albedo k_d.
    pub const DIFFUSE: usize = 10;
    /// First plane of the specular albedo k_s.
    pub const SPECULAR: usize = 13;
    /// Plane of the Blinn–Phong exponent.
    pub const SHININESS: usize = 16;
    /// Plane of the mirrored direction's change to the neighbouring pixels, in radians.
    pub const FOOTPRINT: usize = 17;

    /// Number of planes in a block.
    pub const fn planes(self) -> usize {
        match self {
            Self::Surface => 7,
            Self::Material => 18,
        }
    }
}

/// Reflection at a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SurfaceMaterial {
    /// Diffuse albedo k_d.
    pub diffuse: Vec3,
    /// Specular albedo k_s.
    pub specular: Vec3,
    /// Blinn–Phong exponent n.
    pub shininess: f32,
}

/// One shaded point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    /// Position in metres.
    pub position: Vec3,
    /// Unit shading normal.
    pub normal: Vec3,
    /// Unit direction to the viewer; zero where the layout has none.
    pub view: Vec3,
    /// Reflection at the point; zero where the layout has none.
    pub material: SurfaceMaterial,
    /// Angle in radians between the mirrored view direction here and at the neighbouring pixels,
    /// the larger of a column's and a row's; 0 where it is not known: points that are no pixels,
    /// and layouts that have none.
    pub footprint: f32,
}

/// A list of points in blocks of planes.
#[derive(Clone, Debug, PartialEq)]
pub struct Points {
    layout: PointLayout,
    len: usize,
    blocks: Vec<f32>,
}

impl Points {
    /// Bytes of all its planes, the same on every backend.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.blocks)
    }

    /// Lays out points; `None` is a place without a surface (a pixel that sees none).
    pub fn new(layout: PointLayout, points: impl IntoIterator<Item = Option<Point>>) -> Self {
        let stride = layout.planes() * LANES;
        let (mut blocks, mut len) = (Vec::new(), 0);
        for point in points {
            if len % LANES == 0 {
                blocks.resize(blocks.len() + stride, 0.0);
            }
            let start = len / LANES * stride + len % LANES;
            len += 1;
            let Some(p) = point else { continue };
            let mut put = |plane: usize, values: &[f32]| {
                for (i, v) in values.iter().enumerate() {
                    blocks[start + (plane + i) * LANES] = *v;
                }
            };
            put(PointLayout::POSITION, &p.position.to_array());
            put(PointLayout::NORMAL, &p.normal.to_array());
            put(PointLayout::MASK, &[1.0]);
            if layout == PointLayout::Material {
                put(PointLayout::VIEW, &p.view.to_array());
                put(PointLayout::DIFFUSE, &p.material.diffuse.to_array());
                put(PointLayout::SPECULAR, &p.material.specular.to_array());
                put(PointLayout::SHININESS, &[p.material.shininess]);
                put(PointLayout::FOOTPRINT, &[p.footprint]);
            }
        }
        Self {
            layout,
            len,
            blocks,
        }
    }

    /// Which planes each block has.
    pub fn layout(&self) -> PointLayout {
        self.layout
    }

    /// Number of points, those without a surface included.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether the list is empty.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// All blocks, one after the other: what a backend uploads.
    pub fn blocks(&self) -> &[f32] {
        &self.blocks
    }

    /// The planes of one block.
    pub fn block(&self, index: usize) -> &[f32] {
        let stride = self.layout.planes() * LANES;
        &self.blocks[index * stride..][..stride]
    }

    /// Number of blocks.
    pub fn block_count(&self) -> usize {
        self.len.div_ceil(LANES)
    }

    /// Point `index`, or `None` where it has no surface.
    pub fn get(&self, index: usize) -> Option<Point> {
        assert!(index < self.len, "point {index} of {}", self.len);
        let block = self.block(index / LANES);
        let at = |plane: usize| block[plane * LANES + index % LANES];
        let vector = |plane: usize| Vec3::new(at(plane), at(plane + 1), at(plane + 2));
        if at(PointLayout::MASK) == 0.0 {
            return None;
        }
        let mut point = Point {
            position: vector(PointLayout::POSITION),
            normal: vector(PointLayout::NORMAL),
            ..Point::default()
        };
        if self.layout == PointLayout::Material {
            point.view = vector(PointLayout::VIEW);
            point.material = SurfaceMaterial {
                diffuse: vector(PointLayout::DIFFUSE),
                specular: vector(PointLayout::SPECULAR),
                shininess: at(PointLayout::SHININESS),
            };
            point.footprint = at(PointLayout::FOOTPRINT);
        }
        Some(point)
    }

    /// All points in order.
    pub fn iter(&self) -> impl Iterator<Item = Option<Point>> + '_ {
        (0..self.len).map(|i| self.get(i))
    }
}

/// One RGB value per point, in blocks of three planes of [`LANES`] values.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    len: usize,
    blocks: Vec<f32>,
}

impl Estimate {
    /// Bytes of all its planes, the same on every backend.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.blocks)
    }

    /// Planes in a block.
    pub const PLANES: usize = 3;

    /// Zeros for `len` points.
    pub fn new(len: usize) -> Self {
        Self {
            len,
            blocks: vec![0.0; len.div_ceil(LANES) * Self::PLANES * LANES],
        }
    }

    /// An estimate from blocks that a backend wrote; `None` if their length does not fit.
    pub fn from_blocks(len: usize, blocks: Vec<f32>) -> Option<Self> {
        (blocks.len() == len.div_ceil(LANES) * Self::PLANES * LANES).then_some(Self { len, blocks })
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there are no points.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// All blocks.
    pub fn blocks(&self) -> &[f32] {
        &self.blocks
    }

    /// All blocks, to be written.
    pub fn blocks_mut(&mut self) -> &mut [f32] {
        &mut self.blocks
    }

    /// Value at point `index`.
    pub fn get(&self, index: usize) -> Vec3 {
        assert!(index < self.len, "point {index} of {}", self.len);
        let base = index / LANES * Self::PLANES * LANES + index % LANES;
        Vec3::new(
            self.blocks[base],
            self.blocks[base + LANES],
            self.blocks[base + 2 * LANES],
        )
    }

    /// Sets the value at point `index`.
    pub fn set(&mut self, index: usize, value: Vec3) {
        assert!(index < self.len, "point {index} of {}", self.len);
        let base = index / LANES * Self::PLANES * LANES + index % LANES;
        for (i, v) in value.to_array().into_iter().enumerate() {
            self.blocks[base + i * LANES] = v;
        }
    }

    /// All values in order.
    pub fn iter(&self) -> impl Iterator<Item = Vec3> + '_ {
        (0..self.len).map(|i| self.get(i))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_come_back_as_they_went_in() {
        let point = |i: usize| {
            (i % 5 != 3).then(|| Point {
                position: Vec3::splat(i as f32),
                normal: Vec3::Y,
                view: Vec3::X,
                material: SurfaceMaterial {
                    diffuse: Vec3::splat(0.5),
                    specular: Vec3::splat(0.25),
                    shininess: i as f32,
                },
                footprint: 0.01 * i as f32,
            })
        };
        for len in [0, 1, 63, 64, 65, 200] {
            let points = Points::new(PointLayout::Material, (0..len).map(point));
            assert_eq!(points.block_count(), len.div_ceil(LANES));
            assert!(points.iter().eq((0..len).map(point)), "{len} points");
        }
    }
}
