//! Convolutions of a cube map at infinity, and the lookup into the convolved maps.

use glam::{DVec3, Vec3};
use interreflect_cpu::lane::{Lane, Scalar, Vector};
use interreflect_scene::conventions::{cube_coordinates, cube_vector};

/// Vector solid angle ∫ω dω in sr of a texel of a face of `size`² texels: half the sum over its
/// edges of the angle they span times the edge plane's unit normal, outward.
///
/// `normal · vector` is then the exact cosine integral of a texel wholly above the horizon.
pub fn texel_vector_sr(size: u32, face: usize, column: u32, row: u32) -> DVec3 {
    let edge = |i: u32| 2.0 * f64::from(i) / f64::from(size) - 1.0;
    let (s0, s1, t0, t1) = (edge(column), edge(column + 1), edge(row), edge(row + 1));
    let corners = [(s0, t0), (s0, t1), (s1, t1), (s1, t0)].map(|(s, t)| cube_vector(face, s, t));
    let sum: DVec3 = (0..4)
        .map(|i| {
            let (a, b) = (corners[i], corners[(i + 1) % 4]);
            let c = a.cross(b - a);
            c.normalize() * c.length().atan2(a.dot(b))
        })
        .sum();
    let vector = sum * 0.5;
    // s and t are left-handed on every face: turn the vector to the texel it belongs to.
    if vector.dot(corners[0]) < 0.0 {
        -vector
    } else {
        vector
    }
}

/// ∫(n·ω)⁺dω over a texel of vector solid angle Ω: what it adds to the irradiance for radiance 1.
///
/// n·Ω is exact for a texel wholly above the horizon. One that the horizon cuts is taken to spread
/// its cosines evenly over c ± w, c = n·Ω/|Ω| and w = √|Ω|/2, half its width: (c+w)²/(4w) of |Ω|
/// is then above.
#[inline(always)]
pub fn cosine_weight<L: Lane>(n: Vector<L>, vector: Vector<L>) -> L {
    let zero = L::splat(0.0);
    let omega = vector.dot(vector).sqrt();
    let cos = n.dot(vector) / omega;
    let half_width = L::splat(0.5) * omega.sqrt();
    let risen = (cos + half_width).max(zero).min(half_width + half_width);
    let cut = risen * risen / (L::splat(4.0) * half_width);
    omega * (cut + (cos - half_width).max(zero))
}

/// (cos/cos_max)^N: a texel's Phong weight over that of the texel nearest to the lobe's axis, so
/// that a lobe narrower than a texel does not underflow. 0 for cos ≤ 0.
#[inline(always)]
pub fn phong_weight<L: Lane>(cos: L, cos_max: L, exponent: L) -> L {
    (cos / cos_max).lobe_power(exponent)
}

/// Number of nodes of one convolved map: each face has (cells+1)² nodes, on its corners too, so
/// that neighbouring faces agree along their edge and a bilinear lookup has no seam.
pub fn map_nodes(cells: u32) -> usize {
    6 * (cells as usize + 1).pow(2)
}

/// Unit direction of node `index` of a convolved map.
pub fn node_direction(cells: u32, index: usize) -> Vec3 {
    let side = cells as usize + 1;
    let (face, row, column) = (index / (side * side), index / side % side, index % side);
    let at = |i: usize| 2.0 * i as f64 / f64::from(cells) - 1.0;
    cube_vector(face, at(column), at(row)).normalize().as_vec3()
}

/// The four nodes around a direction with their bilinear weights. The direction need not be unit.
#[inline]
pub fn map_taps<S: Scalar>(cells: u32, direction: Vector<S>) -> [(usize, S); 4] {
    let (face, s, t) = cube_coordinates(direction.into());
    let (one, half) = (S::from(1.0), S::from(0.5));
    let place = |v: f64| {
        let v = (S::splat(v) * half + half) * S::from(cells as f32);
        let cell = v.whole().min(cells as usize - 1);
        (cell, v - S::from(cell as f32))
    };
    let ((column, u), (row, v)) = (place(s), place(t));
    let side = cells as usize + 1;
    let base = (face * side + row) * side + column;
    [
        (base, (one - u) * (one - v)),
        (base + 1, u * (one - v)),
        (base + side, (one - u) * v),
        (base + side + 1, u * v),
    ]
}
