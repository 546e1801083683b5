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

    /// Share of the area in triangles that face against the sum of their corners' normals: folds of a
    /// scanned surface, whose front is on its inside. 0 without vertex normals or area.
    pub fn folded_share(&self) -> f64 {
        if self.normals.is_empty() {
            return 0.0;
        }
        let (mut folded, mut all) = (0.0, 0.0);
        for (triangle, vertices) in self.triangles.iter().enumerate() {
            let [a, b, c] = self.corners(triangle).map(Vec3::as_dvec3);
            let twice_area = (b - a).cross(c - a);
            let outward: Vec3 = vertices.iter().map(|&v| self.normals[v as usize]).sum();
            all += twice_area.length();
            if twice_area.dot(outward.as_dvec3()) < 0.0 {
                folded += twice_area.length();
            }
        }
        if all > 0.0 { folded / all } else { 0.0 }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folds_count_by_their_area() {
        // Two triangles in the plane z = 0, the second of them three times as large and turned.
        let mut mesh = Mesh {
            positions: [[0., 0.], [1., 0.], [0., 1.], [0., 3.], [1., 3.]]
                .map(|[x, y]| Vec3::new(x, y, 0.0))
                .to_vec(),
            normals: vec![Vec3::Z; 5],
            triangles: vec![[0, 1, 2], [0, 3, 4]],
            materials: vec![0; 2],
        };
        assert!((mesh.folded_share() - 0.75).abs() < 1e-12);
        mesh.triangles.swap_remove(1);
        assert_eq!(mesh.folded_share(), 0.0);
        mesh.normals.clear();
        mesh.triangles = vec![[0, 3, 4]];
        assert_eq!(mesh.folded_share(), 0.0);
        assert_eq!(Mesh::default().folded_share(), 0.0);
    }
}
