//! Indexed triangle meshes.

use glam::Vec3;

/// An indexed triangle mesh with one material per triangle.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Vertex positions in metres.
    pub positions: Vec<Vec3>,
    /// Unit vertex normals, as many as positions; empty for flat shading.
    pub normals: Vec<Vec3>,
    /// Corners of each triangle, counter-clockwise seen from the front.
    pub triangles: Vec<[u32; 3]>,
    /// Index into the scene's materials, one per triangle.
    pub materials: Vec<u32>,
}

impl Mesh {
    /// The three corners of a triangle.
    #[inline]
    pub fn corners(&self, triangle: usize) -> [Vec3; 3] {
        self.triangles[triangle].map(|v| self.positions[v as usize])
    }

    /// Unit normal of a triangle's front side; zero without an area.
    #[inline]
    pub fn normal(&self, triangle: usize) -> Vec3 {
        let [a, b, c] = self.corners(triangle);
        let (ab, ac) = ((b - a).as_dvec3(), (c - a).as_dvec3());
        ab.cross(ac).normalize_or_zero().as_vec3()
    }

    /// Smallest axis-aligned box around the vertices, or `None` for an empty mesh.
    pub fn bounds(&self) -> Option<(Vec3, Vec3)> {
        let first = *self.positions.first()?;
        Some(
            self.positions
                .iter()
                .fold((first, first), |(lo, hi), &p| (lo.min(p), hi.max(p))),
        )
    }
}
