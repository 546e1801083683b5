//! The corners of the quadrilaterals: where they are, each computed once for all texels that share
//! it on a face.

use super::params::{Corners, PolygonFormFactor, Radiance};
use crate::texels::Texel;
use crate::texels::average::{CubeTexel, surface_along};
use glam::{DVec3, Vec3};
use interreflect_scene::CubeImage;
use interreflect_scene::conventions::{CUBE_FACES, cube_vector, neighbour_texel, texel_index};

/// Ends of the edge whose angle the published form factor takes for all four, for each face: numbers
/// of corners in the order (s₀,t₀), (s₀,t₁), (s₁,t₁), (s₁,t₀).
///
/// The paper prints the loop over the +z face alone. Here corners begin at (−,−) and run
/// counter-clockwise in the two other axes, in the order of their names, on faces where these turn
/// outward; on the others they run the same list backwards.
pub(super) const REUSED_EDGE: [(usize, usize); CUBE_FACES] =
    [(2, 3), (2, 3), (1, 2), (1, 2), (1, 2), (3, 0)];

/// In a list of texels: none.
pub(super) const NONE: u32 = u32::MAX;

/// Which texels meet at each corner, and where its own ray starts from; depends on the parameters
/// alone.
pub(super) struct Tables {
    /// M: texels along a face's edge; (M+1)² corners a face, row by row.
    pub(super) resolution: u32,
    /// The texels whose mean a corner has; [`NONE`] for a fourth that is not there.
    pub(super) meeting: Vec<[u32; 4]>,
    /// The captured texel beside each corner, the same one for corners that faces share, where
    /// [`Corners::Exact`] looks for the surface; else empty.
    pub(super) captured: Vec<u32>,
    /// Texels along the captured cube's edge.
    pub(super) capture_size: u32,
    radiance: Radiance,
}

/// The contours and radiances that shading reads.
#[derive(Default)]
pub(super) struct Quads {
    /// Direction and w = 1/d of each corner.
    pub(super) corners: Vec<[f32; 4]>,
    /// Radiance of each texel.
    pub(super) radiances: Vec<[f32; 3]>,
}

impl Tables {
    pub(super) fn new(params: &PolygonFormFactor) -> Self {
        let (m, size) = (
            params.resolution,
            params
                .capture_resolution
                .next_multiple_of(params.resolution),
        );
        let mode = params.corners();
        let step = size / m;
        let corners = || {
            (0..CUBE_FACES)
                .flat_map(move |f| (0..=m).flat_map(move |j| (0..=m).map(move |i| (f, i, j))))
        };
        let captured = corners().map(|(f, i, j)| {
            let meeting = meeting_on_all_faces(size, f, i * step, j * step);
            meeting.into_iter().min().unwrap_or(0)
        });
        Self {
            resolution: m,
            meeting: corners()
                .map(|(f, i, j)| meeting(mode, m, f, i, j))
                .collect(),
            captured: match mode {
                Corners::Exact => captured.collect(),
                _ => Vec::new(),
            },
            capture_size: size,
            radiance: params.radiance,
        }
    }

    /// Directions of the corners, in the order of [`Tables::meeting`].
    pub(super) fn directions(&self) -> impl Iterator<Item = DVec3> {
        let m = self.resolution;
        let at = move |i: u32| 2.0 * f64::from(i) / f64::from(m) - 1.0;
        (0..CUBE_FACES).flat_map(move |face| {
            (0..=m).flat_map(move |j| {
                (0..=m).map(move |i| cube_vector(face, at(i), at(j)).normalize())
            })
        })
    }

    /// The quadrilaterals of averaged texels.
    pub(super) fn quads(&self, texels: &[Texel], captured: &CubeImage) -> Quads {
        let corners = self.directions().enumerate().map(|(k, direction)| {
            let w = match self.captured.get(k) {
                Some(&near) => {
                    let near = place(self.capture_size, near);
                    surface_along(captured, near, direction).0
                }
                None => mean_inverse_distance(self.meeting[k], texels),
            };
            direction.as_vec3().extend(w).to_array()
        });
        let radiances = (0..texels.len() as u32).map(|index| match self.radiance {
            Radiance::Centre => texels[index as usize].radiance,
            Radiance::Corners => self.mean_of_corners(index, texels).to_array(),
        });
        Quads {
            corners: corners.collect(),
            radiances: radiances.collect(),
        }
    }

    /// Mean of the radiances at a texel's corners, each the mean of the texels that meet there.
    fn mean_of_corners(&self, index: u32, texels: &[Texel]) -> Vec3 {
        let side = self.resolution + 1;
        let CubeTexel { face, column, row } = place(self.resolution, index);
        let first = (face as u32 * side + row) * side + column;
        let corners = [first, first + 1, first + side, first + side + 1];
        let at_corner = |corner: u32| {
            let meeting = self.meeting[corner as usize];
            let there = meeting.into_iter().filter(|&t| t != NONE);
            let sum: Vec3 = there
                .clone()
                .map(|t| Vec3::from(texels[t as usize].radiance))
                .sum();
            sum / there.count() as f32
        };
        corners.map(at_corner).into_iter().sum::<Vec3>() * 0.25
    }
}

/// 1 over the mean distance of texels; 0 if most lie at infinity.
fn mean_inverse_distance(meeting: [u32; 4], texels: &[Texel]) -> f32 {
    let (mut sum, mut met, mut count) = (0.0, 0_u32, 0_u32);
    for texel in meeting.into_iter().filter(|&t| t != NONE) {
        let w = texels[texel as usize].inverse_distance;
        count += 1;
        if w > 0.0 {
            sum += 1.0 / w;
            met += 1;
        }
    }
    match met > 0 && 2 * met >= count {
        true => met as f32 / sum,
        false => 0.0,
    }
}

/// The texel of an index.
fn place(size: u32, index: u32) -> CubeTexel {
    CubeTexel {
        face: (index / (size * size)) as usize,
        column: index % size,
        row: index / size % size,
    }
}

/// The texels whose mean a corner has: column i and row j of (M+1)² on a face.
fn meeting(mode: Corners, m: u32, face: usize, i: u32, j: u32) -> [u32; 4] {
    let at = |column: u32, row: u32| texel_index(m, face, column, row) as u32;
    // Before and after the corner, kept on the face.
    let sides = |k: u32| [k.saturating_sub(1), k.min(m - 1)];
    let ([left, right], [above, below]) = (sides(i), sides(j));
    match mode {
        Corners::Nearest => [at(left, above), NONE, NONE, NONE],
        Corners::PerFace | Corners::Fidelity => [
            at(left, above),
            at(right, above),
            at(left, below),
            at(right, below),
        ],
        Corners::Seamless | Corners::Exact => {
            let mut list = [NONE; 4];
            let found = meeting_on_all_faces(m, face, i, j);
            list.iter_mut().zip(found).for_each(|(l, t)| *l = t);
            list
        }
    }
}

/// The texels of all faces that meet at a corner, ascending: four, or three at a corner of the cube.
fn meeting_on_all_faces(size: u32, face: usize, i: u32, j: u32) -> Vec<u32> {
    let mut found = Vec::with_capacity(4);
    // Column and row of a texel that may lie just beyond the face's edge.
    for (column, row) in [(-1, -1), (0, -1), (-1, 0), (0, 0)] {
        let (column, row) = (i as i32 + column, j as i32 + row);
        let beyond = |k: i32| k < 0 || k >= size as i32;
        if beyond(column) && beyond(row) {
            continue;
        }
        let (face, column, row) = neighbour_texel(size, face, column, row);
        found.push(texel_index(size, face, column, row) as u32);
    }
    found.sort_unstable();
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use interreflect_scene::conventions::texel_centre;

    /// Texels that meet at a corner are as near to its direction as half a texel's diagonal, there
    /// are three of them at the cube's eight corners and four elsewhere, and faces agree.
    #[test]
    fn the_texels_that_meet_at_a_corner_surround_it() {
        for size in [1, 2, 5, 8] {
            let mut known: Vec<(DVec3, Vec<u32>)> = Vec::new();
            for (face, i, j) in (0..CUBE_FACES)
                .flat_map(|f| (0..=size).flat_map(move |j| (0..=size).map(move |i| (f, i, j))))
            {
                let at = |k: u32| 2.0 * f64::from(k) / f64::from(size) - 1.0;
                let corner = cube_vector(face, at(i), at(j));
                let found = meeting_on_all_faces(size, face, i, j);
                let at_cubes_corner = corner.abs().min_element() == 1.0;
                assert_eq!(found.len(), if at_cubes_corner { 3 } else { 4 });
                for &texel in &found {
                    let p = place(size, texel);
                    let (s, t) = (texel_centre(size, p.column), texel_centre(size, p.row));
                    let middle = cube_vector(p.face, s, t);
                    let apart = (middle - corner).abs().max_element();
                    assert!(apart < 1.001 / f64::from(size), "{corner} {middle}");
                }
                match known.iter().find(|(c, _)| c.distance(corner) < 1e-9) {
                    Some((_, first)) => assert_eq!(*first, found, "{corner}"),
                    None => known.push((corner, found)),
                }
            }
        }
    }
}
