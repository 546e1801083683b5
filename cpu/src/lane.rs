//! One formula over one `f64`, one `f32` or sixteen `f32`s.
//!
//! The leaf functions and the kernels of the estimators are generic over [`Lane`]: the float64
//! oracle, the scalar twin and the fast kernel are then the same source. No operation is fused and `f32` runs the
//! same polynomials alone and in sixteen lanes, so a result has the same bits for any width and
//! any instruction set.

mod one;
mod polynomials;
mod vector;
mod wide;

pub use vector::Vector;
pub use wide::{WIDTH, Wide};

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number, or several side by side; `from` an `f32` is that number, exactly, in every lane.
pub trait Lane:
    Copy
    + From<f32>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// One of the numbers.
    type Scalar: Scalar;
    /// How many there are.
    const WIDTH: usize;

    /// The numbers, for what is done to each by itself: looking up a table.
    fn lanes(&self) -> &[Self::Scalar];
    /// The numbers, to be set.
    fn lanes_mut(&mut self) -> &mut [Self::Scalar];
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
    /// Base-2 logarithm of a positive number.
    fn log2(self) -> Self;

    /// What a function of a lane's number in the row gives for each.
    #[inline(always)]
    fn by_lane(of: impl Fn(usize) -> Self::Scalar) -> Self {
        let mut all = Self::from(0.0);
        for (i, lane) in all.lanes_mut().iter_mut().enumerate() {
            *lane = of(i);
        }
        all
    }

    /// The largest of the numbers.
    #[inline(always)]
    fn largest(self) -> Self::Scalar {
        // Halves against halves: a chain would wait for each link.
        let mut all = self;
        let lanes = all.lanes_mut();
        let mut half = Self::WIDTH / 2;
        while half > 0 {
            for i in 0..half {
                lanes[i] = lanes[i].max(lanes[i + half]);
            }
            half /= 2;
        }
        lanes[0]
    }
}

/// One number.
pub trait Scalar: Lane<Scalar = Self> + Into<f64> + PartialOrd {
    /// The whole part of a number ≥ 0: a place in a table.
    fn whole(self) -> usize;
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
        let wide = a.lobe_power(b).sqrt() * b - a / b + (a * a).angle(a) + b.log2();
        for i in 0..WIDTH {
            let (a, b) = (a.0[i], b.0[i]);
            let one = Lane::sqrt(a.lobe_power(b)) * b - a / b + (a * a).angle(a) + Lane::log2(b);
            assert_eq!(wide.0[i].to_bits(), one.to_bits(), "lane {i}");
        }
    }
    #[test]
    fn lanes_are_reached_one_by_one() {
        let all = Wide::by_lane(|i| (i as f32 - 9.0).powi(2));
        assert_eq!((all.lanes()[0], all.lanes()[WIDTH - 1]), (81.0, 36.0));
        for peak in 0..WIDTH {
            let all = Wide::by_lane(|i| if i == peak { 3.0 } else { -(i as f32) });
            assert_eq!(all.largest(), 3.0, "lane {peak}");
        }
        assert_eq!((-2.5_f64).largest(), -2.5);
        let v = Vector::<Wide>::by_lane(|i| Vector::splat([i as f32, 1.0, 2.0]));
        assert_eq!(v.lane(5), Vector::new(5.0, 1.0, 2.0));
    }
}
