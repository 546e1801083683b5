//! Patches with an edge in them, divided until what is seen lies on the right surface.

use super::node::{Node, Square, patch};
use glam::{DVec3, Vec3};
use interreflect_cpu::direct::captured_radiance;
use interreflect_cpu::scene::CpuScene;
use interreflect_scene::{CoarseIrradiance, CubeSpec};
use rayon::prelude::*;

/// How often a patch with an edge in it is divided in four.
pub(super) const SPLITS: usize = 3;

/// The nodes below a patch with an edge in it: 2², 4² and 8² of them, row by row.
pub(super) struct Split {
    pub(super) levels: [Vec<Node>; SPLITS],
}

/// Divides the patches with an edge in them: what is seen at an edge is then on the right surface
/// to an eighth of a texel. `spec` is that of the patches' capture.
pub(super) fn split_edges(patches: &mut [Node], scene: &CpuScene, spec: CubeSpec) -> Vec<Split> {
    let coarse = scene.coarse_for(&spec);
    let rays = Rays {
        scene,
        coarse: coarse.as_ref().map(|c| &c.irradiance),
        local: spec.channels.distance,
    };
    let splits: Vec<(usize, Split)> = (0..patches.len())
        .into_par_iter()
        .filter_map(|index| {
            let square = Square::of_index(spec.size, index);
            let is_edge = square
                .neighbours()
                .any(|n| patches[index].is_cut_off_from(&patches[n.index()]));
            is_edge.then(|| (index, Split::new(&rays, square)))
        })
        .collect();
    for (place, (index, split)) in splits.iter().enumerate() {
        let [coarsest, ..] = &split.levels;
        patches[*index] = Node {
            split: Some(place as u32),
            ..Node::merge([&coarsest[0], &coarsest[1], &coarsest[2], &coarsest[3]])
        };
    }
    splits.into_iter().map(|(_, split)| split).collect()
}

impl Split {
    fn new(rays: &Rays<'_>, square: Square) -> Self {
        let part = |levels: usize, place: usize| Square {
            size: square.size << levels,
            face: square.face,
            column: (square.column << levels) + (place & ((1 << levels) - 1)) as u32,
            row: (square.row << levels) + (place >> levels) as u32,
        };
        let count = |levels: usize| 1 << (2 * levels);
        let mut levels = [const { Vec::new() }; SPLITS];
        levels[SPLITS - 1] = (0..count(SPLITS))
            .map(|place| rays.patch(part(SPLITS, place)))
            .collect();
        for below in (1..SPLITS).rev() {
            let merged = (0..count(below)).map(|place| {
                let children = part(below, place).children();
                Node::merge(children.map(|c| &levels[below][c.within(below + 1)]))
            });
            levels[below - 1] = merged.collect();
        }
        Self { levels }
    }
}

/// What rays are traced in.
struct Rays<'a> {
    scene: &'a CpuScene,
    coarse: Option<&'a CoarseIrradiance>,
    /// Surfaces are at their place, not at infinity.
    local: bool,
}

impl Rays<'_> {
    /// A patch from a ray of its own, as [`interreflect_cpu::capture::cube::capture_cube`] traces
    /// them.
    fn patch(&self, square: Square) -> Node {
        let scene = self.scene;
        let origin = scene.scene().reference_point.as_dvec3();
        let objects = scene.environment_objects();
        let direction = square.rays().iter().sum::<DVec3>().normalize();
        let hit = objects.bvh().closest(origin, direction, 0.0, f64::INFINITY);
        let hit = hit.map(|hit| scene.surface(objects, origin, direction, hit));
        let radiance = match (&hit, &scene.scene().environment) {
            (Some(hit), _) => captured_radiance(scene, objects, hit, self.coarse),
            (None, Some(environment)) => environment.radiance(direction.as_vec3()),
            (None, None) => Vec3::ZERO,
        };
        match hit.filter(|_| self.local) {
            Some(hit) => patch(square, radiance, hit.distance as f32, hit.geometric_normal),
            None => patch(square, radiance, f32::INFINITY, Vec3::ZERO),
        }
    }
}
