//! Cells of the lights' views, and where they lie.

use glam::DVec3;
use interreflect_cpu::capture::rsm::LitPlace;
use interreflect_cpu::scene::CpuScene;
use interreflect_scene::{LightFrame, Projection, conventions};

/// A cell of a view, with what its middle ray lights.
#[derive(Clone, Copy)]
pub(super) struct Cell {
    size: u32,
    column: u32,
    row: u32,
    pub(super) place: Option<LitPlace>,
}

/// Parts along the edge of a cell that an edge of a surface, or of the light, cuts.
const PARTS: u32 = 4;

impl Cell {
    pub(super) fn new(
        scene: &CpuScene,
        frame: &LightFrame,
        size: u32,
        [column, row]: [u32; 2],
    ) -> Self {
        let [s, t] = [column, row].map(|i| conventions::texel_centre(size, i));
        Self {
            size,
            column,
            row,
            place: LitPlace::along(scene, frame, s, t),
        }
    }

    pub(super) fn parts(&self, scene: &CpuScene, frame: &LightFrame) -> Vec<Self> {
        let part = |i: u32| {
            let (column, row) = (
                PARTS * self.column + i % PARTS,
                PARTS * self.row + i / PARTS,
            );
            Self::new(scene, frame, PARTS * self.size, [column, row])
        };
        (0..PARTS * PARTS).map(part).collect()
    }

    /// Whether the same plane, of the same material, is seen here and there.
    fn continues_in(&self, other: &Self) -> bool {
        match (&self.place, &other.place) {
            (Some(a), Some(b)) => {
                let offset = b.position - a.position;
                let height = offset.dot(a.normal.as_dvec3()).abs();
                height <= 0.1 * offset.length()
                    && a.normal.dot(b.normal) > 0.9
                    && (a.colors.diffuse, a.colors.specular)
                        == (b.colors.diffuse, b.colors.specular)
            }
            (a, b) => a.is_none() && b.is_none(),
        }
    }
}

/// Whether a cell and one beside it see different surfaces.
pub(super) fn is_edge(cells: &[Cell], index: usize, size: usize) -> bool {
    let (column, row) = (index % size, index / size);
    let beside = [
        (column > 0).then(|| index - 1),
        (column + 1 < size).then_some(index + 1),
        (row > 0).then(|| index - size),
        (row + 1 < size).then_some(index + size),
    ];
    let mut beside = beside.into_iter().flatten();
    beside.any(|other| !cells[index].continues_in(&cells[other]))
}

/// Corners of a cell on its surface's plane, clockwise seen from the lit side: where its corner rays
/// meet the plane. Behind a mirror, or where the plane is nearly edge-on to a ray, a square of the
/// area that the cell's light falls on.
pub(super) fn corners(frame: &LightFrame, cell: &Cell, place: &LitPlace) -> [DVec3; 4] {
    let normal = place.normal.as_dvec3().normalize();
    let corners = cut(frame, cell, place.position, normal);
    let mut corners = corners.unwrap_or_else(|| {
        let across = match frame.projection {
            Projection::Perspective => place.path_m.powi(2),
            Projection::Orthographic => 1.0,
        };
        let measure = frame.cell_measure(cell.size, cell.column, cell.row);
        let area = measure * across / f64::from(place.cos_light).max(1e-6);
        let (u, v) = normal.any_orthonormal_pair();
        let [u, v] = [u, v].map(|d| d * (0.5 * area.sqrt()));
        [-u - v, v - u, u + v, u - v].map(|c| place.position + c)
    });
    let [a, b, c, d] = corners;
    if (c - a).cross(d - b).dot(normal) > 0.0 {
        corners = [a, d, c, b];
    }
    corners
}

/// Where the corner rays meet the plane; `None` if the middle ray does not arrive there, or a corner
/// ray does not.
fn cut(frame: &LightFrame, cell: &Cell, position: DVec3, normal: DVec3) -> Option<[DVec3; 4]> {
    let [s, t] = [cell.column, cell.row].map(|i| conventions::texel_centre(cell.size, i));
    let (start, middle) = frame.ray(s, t);
    let offset = position - start;
    // A ray that met no mirror passes through, but for the rounding of f64.
    if (offset - middle * offset.dot(middle)).length() > 1e-9 * offset.length() {
        return None;
    }
    let half = 1.0 / f64::from(cell.size);
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
