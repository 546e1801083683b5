//! One formula over one `f64`, one `f32` or sixteen `f32`s.
//!
//! The leaf functions of the estimators are generic over [`Lane`]: the float64 oracle, the scalar
//! twin and the fast kernel are then the same source. No operation is fused and `f32` runs the
//! same polynomials alone and in sixteen lanes, so a result has the same bits for any width and
//! any instruction set.

mod polynomials;
mod wide;

use polynomials::{angle, exp2, log2};
pub use wide::{WIDTH, Wide};

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number, or several side by side.
pub trait Lane:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The same constant in every lane, rounded once to the lane's precision.
    fn splat(value: f64) -> Self;
    /// Square root.
    fn sqrt(self) -> Self;
    /// The larger value; `other` where `self` is not a number.
    fn max(self, other: Self) -> Self;
    /// The smaller value; `other` where `self` is not a number.
    fn min(self, other: Self) -> Self;
    /// `yes` where `self > than`, else `no`.
    fn select_gt(self, than: Self, yes: Self, no: Self) -> Self;
    /// `self` to the power of `exponent` for a base in (0, 1] and an exponent ≥ 0; 0 for a base
    /// ≤ 0. Relative error in `f32` below 1e-5 where the result exceeds 1e-6, for exponents up to
    /// 1e5; results below 2⁻¹²⁶ become about 2⁻¹²⁶.
    fn lobe_power(self, exponent: Self) -> Self;
    /// The angle in [0, π] whose sine and cosine are in the ratio `self` : `cos`, for `self` ≥ 0:
    /// atan2. 0 where both are 0. Relative error in `f32` below 3e-7.
    fn angle(self, cos: Self) -> Self;
}

/// Three lanes as a vector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vector<L> {
    /// First component.
    pub x: L,
    /// Second component.
    pub y: L,
    /// Third component.
    pub z: L,
}

impl<L: Lane> Vector<L> {
    /// A vector from its components.
    #[inline(always)]
    pub fn new(x: L, y: L, z: L) -> Self {
        Self { x, y, z }
    }

    /// The same vector in every lane.
    #[inline(always)]
    pub fn splat(v: [f32; 3]) -> Self {
        let [x, y, z] = v.map(|c| L::splat(f64::from(c)));
        Self { x, y, z }
    }

    /// Scalar product.
    #[inline(always)]
    pub fn dot(self, o: Self) -> L {
        self.x * o.x + self.y * o.y + self.z * o.z
    }

    /// Vector product.
    #[inline(always)]
    pub fn cross(self, o: Self) -> Self {
        Self {
            x: self.y * o.z - self.z * o.y,
            y: self.z * o.x - self.x * o.z,
            z: self.x * o.y - self.y * o.x,
        }
    }

    /// The vector times a number.
    #[inline(always)]
    pub fn scale(self, k: L) -> Self {
        Self {
            x: self.x * k,
            y: self.y * k,
            z: self.z * k,
        }
    }
}

impl<L: Lane> Add for Vector<L> {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        Self::new(self.x + o.x, self.y + o.y, self.z + o.z)
    }
}

impl<L: Lane> Sub for Vector<L> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        Self::new(self.x - o.x, self.y - o.y, self.z - o.z)
    }
}

impl<L: Lane> Neg for Vector<L> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

impl Lane for f64 {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }
    #[inline(always)]
    fn select_gt(self, than: Self, yes: Self, no: Self) -> Self {
        if self > than { yes } else { no }
    }
    #[inline(always)]
    fn lobe_power(self, exponent: Self) -> Self {
        if self > 0.0 { self.powf(exponent) } else { 0.0 }
    }
    #[inline(always)]
    fn angle(self, cos: Self) -> Self {
        self.atan2(cos)
    }
}

impl Lane for f32 {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        value as f32
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        f32::sqrt(self)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }
    #[inline(always)]
    fn select_gt(self, than: Self, yes: Self, no: Self) -> Self {
        if self > than { yes } else { no }
    }
    #[inline(always)]
    fn lobe_power(self, exponent: Self) -> Self {
        let power = exp2(exponent * log2(self));
        if self > 0.0 { power } else { 0.0 }
    }
    #[inline(always)]
    fn angle(self, cos: Self) -> Self {
        angle(self, cos)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cause of the bound: log2 has a relative error of 2e-7 near 1 and an absolute one of about
    /// 1e-7·|log2| elsewhere; times an exponent that keeps the result above 1e-6 (20 binary
    /// digits) it is 20·2e-7·ln 2, the polynomials' own 2e-7 and the rounding of the base added.
    #[test]
    fn lobe_power_keeps_its_stated_error() {
        let mut worst = 0.0_f64;
        for exponent in [0.0_f32, 0.5, 1.0, 5.0, 50.0, 1e3, 1e5] {
            for i in 0..20_000 {
                let x = 1.0 - (i as f32 / 20_000.0).powi(4);
                let exact = f64::from(x).powf(f64::from(exponent));
                if x > 0.0 && exact > 1e-6 {
                    let error = (f64::from(x.lobe_power(exponent)) - exact).abs() / exact;
                    worst = worst.max(error);
                }
            }
        }
        assert!(worst < 1e-5, "{worst}");
        assert_eq!((-0.5_f32).lobe_power(0.0), 0.0);
        assert_eq!(0.0_f32.lobe_power(5.0), 0.0);
    }

    /// Cause of the bound: the polynomial's 2e-8 and a few roundings; the smallest angles keep a
    /// relative error because the polynomial has the tangent as a factor.
    #[test]
    fn angle_keeps_its_stated_error() {
        for i in 0..20_000 {
            let exact = std::f64::consts::PI * (f64::from(i) / 20_000.0).powi(3);
            for length in [1e-12_f32, 1.0, 1e12] {
                let (sin, cos) = (length * exact.sin() as f32, length * exact.cos() as f32);
                let exact = f64::from(sin).atan2(f64::from(cos));
                let error = (f64::from(sin.angle(cos)) - exact).abs();
                assert!(error <= 3e-7 * exact, "{sin} {cos}: {error}");
            }
        }
        assert_eq!(0.0_f32.angle(0.0), 0.0);
    }

    #[test]
    fn sixteen_lanes_have_the_bits_of_one() {
        let a = Wide(std::array::from_fn(|i| 0.05 * i as f32 - 0.1));
        let b = Wide(std::array::from_fn(|i| 1.0 + i as f32));
        let wide = a.lobe_power(b).sqrt() * b - a / b + (a * a).angle(a);
        for i in 0..WIDTH {
            let (a, b) = (a.0[i], b.0[i]);
            let one = Lane::sqrt(a.lobe_power(b)) * b - a / b + (a * a).angle(a);
            assert_eq!(wide.0[i].to_bits(), one.to_bits(), "lane {i}");
        }
    }
}
