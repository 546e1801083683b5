//! What is seen from the reference point: patches, merged four by four.

use super::node::{Node, Square, patch};
use super::split::{SPLITS, Split, split_edges};
use glam::DVec3;
use interreflect_cpu::capture::cube::capture_cube;
use interreflect_cpu::scene::CpuScene;
use interreflect_estimators::OwnModel;
use interreflect_scene::conventions::CUBE_FACES;
use interreflect_scene::{CubeChannels, CubeSpec};
use rayon::prelude::*;

/// Nodes along a face's edge at the coarsest level: 54 roots.
const ROOTS: u32 = 3;

/// Nodes of all levels around a reference point.
pub(super) struct Hierarchy {
    /// The reference point.
    pub(super) origin: DVec3,
    /// From coarse to fine: level k has (3·2ᵏ)² nodes a face.
    levels: Vec<Vec<Node>>,
    /// Finer levels of the patches with an edge in them.
    split: Vec<Split>,
}

impl Hierarchy {
    /// Captures 6·size² patches, size = 3·2ᵏ, and merges them.
    pub(super) fn new(model: OwnModel, scene: &CpuScene, size: u32) -> Self {
        let (local, bounces) = match model {
            OwnModel::VisibleFromReference { bounces } => (true, bounces),
            OwnModel::MeanRadiance { bounces } | OwnModel::EnvironmentAtInfinity { bounces } => {
                (false, bounces)
            }
            OwnModel::OccludedEnvironment
            | OwnModel::FirstHitsOfLights { .. }
            | OwnModel::LightTransport(_)
            | OwnModel::Other(_) => (false, 0),
        };
        let channels = CubeChannels {
            radiance: true,
            distance: local,
            normal: local,
        };
        let spec = CubeSpec {
            size,
            channels,
            bounces,
        };
        let origin = scene.scene().reference_point;
        let captured = capture_cube(scene, origin, spec);
        let mut patches: Vec<Node> = (0..captured.texels())
            .into_par_iter()
            .map(|index| {
                let normal = captured.normal.get(index).copied().unwrap_or_default();
                let distance = captured.distance.get(index).copied();
                let distance = distance.unwrap_or(f32::INFINITY);
                let square = Square::of_index(size, index);
                patch(square, captured.radiance[index], distance, normal)
            })
            .collect();
        let split = split_edges(&mut patches, scene, spec);
        if matches!(model, OwnModel::MeanRadiance { .. }) {
            let total = |f: fn(&Node) -> DVec3| patches.iter().map(f).sum::<DVec3>();
            let mean = total(|p| p.power.as_dvec3()) / total(|p| DVec3::splat(p.measure.into()));
            let mean = mean.as_vec3();
            patches.iter_mut().for_each(|p| p.power = mean * p.measure);
            patches.iter_mut().for_each(|p| p.split = None);
        }
        let mut levels = vec![patches];
        let mut size = size;
        while size > ROOTS {
            size /= 2;
            let finer = &levels[levels.len() - 1];
            let level = (0..CUBE_FACES * (size * size) as usize)
                .into_par_iter()
                .map(|index| {
                    let children = Square::of_index(size, index).children();
                    Node::merge(children.map(|c| &finer[c.index()]))
                })
                .collect();
            levels.push(level);
        }
        levels.reverse();
        Self {
            origin: origin.as_dvec3(),
            levels,
            split,
        }
    }

    /// The squares of the coarsest level.
    pub(super) fn roots(&self) -> impl Iterator<Item = Square> + '_ {
        (0..self.levels[0].len()).map(|index| Square::of_index(ROOTS, index))
    }

    #[inline(always)]
    pub(super) fn node(&self, square: Square) -> &Node {
        let level = (square.size / ROOTS).ilog2() as usize;
        match level.checked_sub(self.levels.len()) {
            None => &self.levels[level][square.index()],
            Some(below) => self.below_patch(square, below + 1),
        }
    }

    /// A node `levels` below a patch that is split.
    fn below_patch(&self, square: Square, levels: usize) -> &Node {
        let patch = Square {
            size: square.size >> levels,
            face: square.face,
            column: square.column >> levels,
            row: square.row >> levels,
        };
        let finest = self.levels.len() - 1;
        let split = self.levels[finest][patch.index()].split;
        &self.split[split.unwrap_or(0) as usize].levels[levels - 1][square.within(levels)]
    }

    /// Whether a square is not divided further.
    #[inline(always)]
    pub(super) fn is_patch(&self, square: Square, node: &Node) -> bool {
        let level = (square.size / ROOTS).ilog2() as usize + 1;
        level == self.levels.len() + SPLITS || (level == self.levels.len() && node.split.is_none())
    }

    /// Corners of a planar node relative to the reference point, clockwise seen from it.
    pub(super) fn corners(&self, square: Square) -> [DVec3; 4] {
        let node = self.node(square);
        let normal = node.normal.as_dvec3().normalize();
        let height = f64::from(node.height);
        square.rays().map(|ray| ray * (height / -normal.dot(ray)))
    }
}
