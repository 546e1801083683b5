//! Leaf functions of sums over texels, over any [`Lane`].
//!
//! A texel's surface point is kept relative to the reference point o and in homogeneous form:
//! y − o = direction / w with the unit `direction` = L/l and w = 1/d, so that the environment at
//! infinity is w = 0 and no formula has a case for it. With x relative to o as well,
//! R = direction − w·x is (y − x)·w, its square is (r/d)², and its direction is that of I.

use interreflect_cpu::lane::{Lane, Vector};

/// The direction I from x to a texel's surface point, and r2 = (r/d)².
///
/// `direction`, `w`: the texel's homogeneous point; `x`: the shaded point relative to o. Where x
/// is that very point, or nearer than float32 resolves, I is zero: the texel then adds nothing.
#[inline(always)]
pub fn towards_texel<L: Lane>(direction: Vector<L>, w: L, x: Vector<L>) -> (Vector<L>, L) {
    let r = direction - x.scale(w);
    let r2 = r.dot(r);
    let tiny = L::splat(f64::from(f32::MIN_POSITIVE));
    let inverse = r2.select_gt(tiny, L::splat(1.0) / r2.max(tiny).sqrt(), L::splat(0.0));
    (r.scale(inverse), r2)
}

/// Cosine N·H with the half vector of I and V; 0 where I = −V.
#[inline(always)]
pub fn cos_half<L: Lane>(n: Vector<L>, i: Vector<L>, v: Vector<L>) -> L {
    let h = i + v;
    let h2 = h.dot(h);
    let tiny = L::splat(1e-20);
    n.dot(h) * h2.select_gt(tiny, L::splat(1.0) / h2.max(tiny).sqrt(), L::splat(0.0))
}
