//! A coarse solution of light transport: irradiance at vertices on the captured surfaces.

use crate::{Role, Scene};
use glam::Vec3;

/// Cells along the longest side of the scene's bounding box.
const CELLS: u32 = 8;

/// Vertices above which triangles are divided less. Three per triangle there are in any case.
const MAX_VERTICES: usize = 1 << 18;

/// Distance of a triangle's outermost vertices from its edges, in heights of a cell: on an edge
/// itself they would lie on the neighbouring surface, in the corner of a room on two of them.
const INSET: f64 = 0.1;

/// Irradiance on both sides of the environment objects' triangles, linear between the vertices of
/// a uniform grid on each: what arrives from emission, from infinity and from surfaces, not straight
/// from the scene's lights.
///
/// Large triangles are divided so that about eight cells span the scene. Shadows and colour that
/// change over less than a cell are smoothed: a cell beneath a thin wall mixes both of its sides.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CoarseIrradiance {
    bounces: u32,
    grids: Vec<Grid>,
    values: Vec<[Vec3; 2]>,
}

/// The grid on one triangle: rows of vertices parallel to the edge from corner 0 to corner 2, one
/// vertex fewer in each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grid {
    /// Index of its first vertex, at corner 0.
    pub first: u32,
    /// Cells along an edge.
    pub cells: u32,
}

impl Grid {
    fn vertices(self) -> u32 {
        (self.cells + 1) * (self.cells + 2) / 2
    }

    /// Index of a vertex: `i` cells towards corner 1, `j` towards corner 2.
    fn index(self, i: u32, j: u32) -> usize {
        (self.first + i * (2 * self.cells + 3 - i) / 2 + j) as usize
    }

    /// Weights of the triangle's corners at each vertex, where it is evaluated: a little inside.
    fn places(self) -> impl Iterator<Item = [f64; 3]> {
        let n = f64::from(self.cells);
        let inset = INSET / n;
        let moved = move |weight: f64| weight * (1.0 - 3.0 * inset) + inset;
        (0..=self.cells).flat_map(move |i| {
            (0..=self.cells - i).map(move |j| {
                let (v, w) = (f64::from(i) / n, f64::from(j) / n);
                [1.0 - v - w, v, w].map(moved)
            })
        })
    }

    /// The three vertices around a place, given by its weights of corners 1 and 2, with their own
    /// weights.
    fn around(self, v: f32, w: f32) -> [(usize, f32); 3] {
        let n = self.cells as f32;
        let (x, y) = ((v * n).clamp(0.0, n), (w * n).clamp(0.0, n));
        let i = (x as u32).min(self.cells - 1);
        let j = (y as u32).min(self.cells - 1 - i);
        let (x, y) = ((x - i as f32).min(1.0), (y - j as f32).min(1.0));
        // The last cell of a row has no upper half.
        if x + y <= 1.0 || i + j + 1 == self.cells {
            [
                (self.index(i, j), 1.0 - x - y),
                (self.index(i + 1, j), x),
                (self.index(i, j + 1), y),
            ]
        } else {
            [
                (self.index(i + 1, j + 1), x + y - 1.0),
                (self.index(i, j + 1), 1.0 - x),
                (self.index(i + 1, j), 1.0 - y),
            ]
        }
    }
}

/// A vertex of a [`CoarseIrradiance`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoarseVertex {
    /// Index of its triangle, counted over all environment objects.
    pub triangle: u32,
    /// Weights of the triangle's corners where it is evaluated, each above 0.
    pub barycentric: [f64; 3],
}

impl CoarseIrradiance {
    /// A solution of 0 at the vertices that a scene's environment objects get.
    pub fn dark(scene: &Scene, bounces: u32) -> Self {
        let triangles: Vec<[Vec3; 3]> = scene
            .objects_of(Role::Environment)
            .flat_map(|o| (0..o.mesh.triangles.len()).map(|t| o.mesh.corners(t)))
            .collect();
        let corners = || triangles.iter().flatten().copied();
        let low = corners().reduce(Vec3::min).unwrap_or_default();
        let high = corners().reduce(Vec3::max).unwrap_or_default();
        let extent = (high - low).max_element();
        let divided = |cells: u32| {
            let mut first = 0;
            let grids: Vec<Grid> = triangles
                .iter()
                .map(|corners| {
                    let grid = Grid {
                        first,
                        cells: cells_of(corners, extent / cells as f32),
                    };
                    first += grid.vertices();
                    grid
                })
                .collect();
            (grids, first as usize)
        };
        let (mut grids, mut vertices) = divided(CELLS);
        for cells in (1..CELLS).rev() {
            if vertices <= MAX_VERTICES {
                break;
            }
            (grids, vertices) = divided(cells);
        }
        Self {
            bounces,
            grids,
            values: vec![[Vec3::ZERO; 2]; vertices],
        }
    }

    /// Reflections that surfaces reflecting this irradiance add to that of the lights' light.
    pub fn bounces(&self) -> u32 {
        self.bounces
    }

    /// The grid of each triangle of the environment objects, in their order.
    pub fn grids(&self) -> &[Grid] {
        &self.grids
    }

    /// Irradiance at each vertex in W/m², on the front and on the back.
    pub fn values(&self) -> &[[Vec3; 2]] {
        &self.values
    }

    /// Replaces the irradiance at each vertex; as many as there are.
    pub fn set_values(&mut self, values: impl IntoIterator<Item = [Vec3; 2]>) {
        for (old, new) in self.values.iter_mut().zip(values) {
            *old = new;
        }
    }

    /// The vertices, in the order of their values.
    pub fn vertices(&self) -> impl Iterator<Item = CoarseVertex> + '_ {
        (0..).zip(&self.grids).flat_map(|(triangle, grid)| {
            grid.places().map(move |barycentric| CoarseVertex {
                triangle,
                barycentric,
            })
        })
    }

    /// Irradiance in W/m² on one side of a triangle of the environment objects, at the place with
    /// the given weights of its corners 1 and 2; 0 for a triangle that is not there.
    pub fn at(&self, triangle: u32, [v, w]: [f32; 2], front: bool) -> Vec3 {
        let side = usize::from(!front);
        let grid = self.grids.get(triangle as usize);
        grid.map_or(Vec3::ZERO, |grid| {
            let around = grid.around(v, w);
            around
                .map(|(i, weight)| self.values[i][side] * weight)
                .into_iter()
                .sum()
        })
    }
}

/// Cells along the edges of a triangle, for cells of about the given size: half a square's diagonal
/// counts as long as its sides.
fn cells_of([a, b, c]: &[Vec3; 3], size: f32) -> u32 {
    let longest = a.distance(*b).max(b.distance(*c)).max(c.distance(*a));
    let cells = longest * std::f32::consts::FRAC_1_SQRT_2 / size;
    // NaN, from a scene without extent, becomes 1.
    (cells.round() as u32).clamp(1, 2 * CELLS)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn linear_values_are_reproduced_and_every_vertex_has_its_index() {
        for cells in 1..=9 {
            let grid = Grid { first: 0, cells };
            let n = cells as f32;
            let mut exact = vec![f32::NAN; grid.vertices() as usize];
            for i in 0..=cells {
                for j in 0..=cells - i {
                    exact[grid.index(i, j)] = 2.0 * i as f32 / n - j as f32 / n;
                }
            }
            assert!(exact.iter().all(|v| v.is_finite()), "{cells} cells");
            for k in 0..2000 {
                let v = (k as f32 * 0.618_034).fract();
                let w = (k as f32 * 0.754_878).fract() * (1.0 - v);
                let around = grid.around(v, w);
                let sum: f32 = around.iter().map(|(i, weight)| exact[*i] * weight).sum();
                assert!(
                    (sum - (2.0 * v - w)).abs() < 1e-5,
                    "{cells}, {v}, {w}: {sum}"
                );
                assert!(around.iter().all(|(_, weight)| *weight > -1e-5));
            }
            for [u, v, w] in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
                let sum: f32 = grid.around(v, w).iter().map(|(i, x)| exact[*i] * x).sum();
                assert!(
                    (sum - (2.0 * v - w)).abs() < 1e-6,
                    "corner {u} {v} {w}: {sum}"
                );
            }
        }
    }

    #[test]
    fn vertices_are_evaluated_inside_their_triangle() {
        let grid = Grid { first: 0, cells: 8 };
        assert_eq!(grid.places().count(), grid.vertices() as usize);
        for weights in grid.places() {
            assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
            assert!(weights.iter().all(|w| *w >= INSET / 8.0 - 1e-12));
        }
    }

    #[test]
    fn a_wall_gets_eight_cells_and_their_number_is_bounded() {
        let square = [Vec3::ZERO, Vec3::X, Vec3::X + Vec3::Y];
        assert_eq!(cells_of(&square, 0.125), 8);
        assert_eq!(cells_of(&square, 1e-9), 2 * CELLS);
        assert_eq!(cells_of(&[Vec3::ZERO; 3], 0.0), 1);
    }
}
