//! Directions from a subdivided octahedron: each level begins with the directions of the one below.

use glam::{DVec3, Vec3};
use std::collections::HashMap;
use std::sync::LazyLock;

/// The highest level.
pub const MAX_LEVEL: u32 = 4;

/// Directions of each level: 4·4ˢ + 2.
pub const DIRECTIONS: [u32; MAX_LEVEL as usize + 1] = [6, 18, 66, 258, 1026];

struct Sphere {
    directions: Vec<DVec3>,
    /// Of each level.
    triangles: Vec<Vec<[usize; 3]>>,
}

static SPHERE: LazyLock<Sphere> = LazyLock::new(|| {
    let mut directions: Vec<_> = [DVec3::X, DVec3::Y, DVec3::Z]
        .into_iter()
        .flat_map(|axis| [axis, -axis])
        .collect();
    let sides = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4]];
    let below = sides.map(|[a, b, _]| [b, a, 5]);
    let mut triangles = vec![[sides, below].concat()];
    for level in 1..=MAX_LEVEL as usize {
        let mut middles = HashMap::new();
        let mut finer = Vec::new();
        for &[a, b, c] in &triangles[level - 1] {
            let [ab, bc, ca] = [(a, b), (b, c), (c, a)].map(|(i, j)| {
                *middles.entry((i.min(j), i.max(j))).or_insert_with(|| {
                    directions.push((directions[i] + directions[j]).normalize());
                    directions.len() - 1
                })
            });
            finer.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
        }
        triangles.push(finer);
    }
    Sphere {
        directions,
        triangles,
    }
});

/// Unit directions of a level, those of lower levels first.
pub fn directions(level: u32) -> Vec<Vec3> {
    let count = DIRECTIONS[level as usize] as usize;
    let directions = SPHERE.directions[..count].iter();
    directions.map(|d| d.as_vec3()).collect()
}

/// Weight in sr of each direction of a level: a third of the solid angles of the geodesic triangles
/// around it. They sum to 4π.
pub(super) fn weights_sr(level: u32) -> Vec<f64> {
    let mut weights = vec![0.0; DIRECTIONS[level as usize] as usize];
    for triangle in &SPHERE.triangles[level as usize] {
        let omega_sr = solid_angle_sr(triangle.map(|v| SPHERE.directions[v]));
        triangle.iter().for_each(|&v| weights[v] += omega_sr / 3.0);
    }
    weights
}

/// Solid angle of a geodesic triangle with unit corners (van Oosterom & Strackee 1983).
fn solid_angle_sr([a, b, c]: [DVec3; 3]) -> f64 {
    let volume = a.dot(b.cross(c)).abs();
    2.0 * volume.atan2(1.0 + a.dot(b) + b.dot(c) + c.dot(a))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn levels_nest_and_weights_fill_the_sphere() {
        for level in 0..=MAX_LEVEL {
            let (all, weights) = (directions(level), weights_sr(level));
            assert_eq!(all.len(), 4usize.pow(level + 1) + 2);
            assert_eq!(all.len(), weights.len());
            assert!((weights.iter().sum::<f64>() - 4.0 * PI).abs() < 1e-12);
            let moment: DVec3 = (all.iter().zip(&weights))
                .map(|(d, w)| d.as_dvec3() * *w)
                .sum();
            assert!(moment.length() < 1e-6, "{moment}");
            let finer = directions(MAX_LEVEL);
            assert_eq!(all[..], finer[..all.len()]);
            let mut sorted: Vec<_> = all.iter().map(|d| d.to_array().map(f32::to_bits)).collect();
            sorted.sort_unstable();
            sorted.dedup();
            assert_eq!(sorted.len(), all.len(), "a direction twice");
        }
    }
}
