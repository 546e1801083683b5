//! What a convolution reads and where it is evaluated.

use super::math::{map_nodes, node_direction, texel_vector_sr};
use crate::averaging::{averaged, cube_texels};
use glam::Vec3;
use interreflect_scene::{CubeImage, Point, PointLayout, Points};

/// A texel at infinity.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Source {
    /// Vector solid angle in sr.
    pub(super) vector: [f32; 3],
    /// Mean radiance.
    pub(super) radiance: [f32; 3],
}

/// Vector solid angles in sr of the texels of a cube of `resolution`² a face.
pub(super) fn vectors_sr(resolution: u32) -> impl Iterator<Item = Vec3> {
    cube_texels(resolution)
        .map(move |(face, column, row)| texel_vector_sr(resolution, face, column, row).as_vec3())
}

/// Gives texels of a cube of `resolution`² a face the mean radiance of what they cover of the
/// capture, whose texels have these solid angles.
pub(super) fn light(
    sources: &mut [Source],
    resolution: u32,
    captured: &CubeImage,
    omegas_sr: &[f32],
) {
    let means = averaged(captured, omegas_sr, resolution);
    for (source, mean) in sources.iter_mut().zip(means) {
        source.radiance = mean.to_array();
    }
}

/// The nodes of a convolved map as points whose normals are the nodes' directions.
pub(super) fn node_points(cells: u32) -> Points {
    Points::new(
        PointLayout::Surface,
        (0..map_nodes(cells)).map(|i| {
            Some(Point {
                position: Vec3::ZERO,
                normal: node_direction(cells, i),
                ..Point::default()
            })
        }),
    )
}
