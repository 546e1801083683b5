//! What a convolution reads and where it is evaluated.

use super::math::{map_nodes, node_direction, texel_vector_sr};
use crate::averaging::mean_radiance;
use glam::Vec3;
use interreflect_scene::conventions::CUBE_FACES;
use interreflect_scene::{CubeImage, Point, PointLayout, Points};

/// A texel at infinity, as both backends read it: two vectors of four `f32`s.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct Source {
    /// Vector solid angle in sr.
    pub vector: [f32; 3],
    /// Nothing; keeps the layout.
    pub pad: f32,
    /// Mean radiance.
    pub radiance: [f32; 3],
    /// Nothing; keeps the layout.
    pub pad2: f32,
}

/// The texels of a cube of `resolution`² a face, black: their geometry alone.
pub(super) fn directions(resolution: u32) -> Vec<Source> {
    texels(resolution)
        .map(|(face, column, row)| Source {
            vector: texel_vector_sr(resolution, face, column, row)
                .as_vec3()
                .to_array(),
            ..Source::default()
        })
        .collect()
}

/// Gives texels of a cube of `resolution`² a face the mean radiance of what they cover of the
/// capture, whose texels have these solid angles.
pub(super) fn light(
    sources: &mut [Source],
    resolution: u32,
    captured: &CubeImage,
    omegas_sr: &[f32],
) {
    for (source, (face, column, row)) in sources.iter_mut().zip(texels(resolution)) {
        let mean = mean_radiance(captured, omegas_sr, resolution, face, column, row);
        source.radiance = mean.to_array();
    }
}

fn texels(resolution: u32) -> impl Iterator<Item = (usize, u32, u32)> {
    (0..CUBE_FACES).flat_map(move |face| {
        (0..resolution).flat_map(move |row| (0..resolution).map(move |column| (face, column, row)))
    })
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
