//! Sixteen lanes.

use super::Lane;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Number of points that a kernel computes side by side.
pub const WIDTH: usize = 16;

/// Sixteen `f32`s side by side; loops over it become vector instructions.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct Wide(pub [f32; WIDTH]);

impl Wide {
    #[inline(always)]
    fn zip(mut self, other: Self, f: impl Fn(f32, f32) -> f32) -> Self {
        for i in 0..WIDTH {
            self.0[i] = f(self.0[i], other.0[i]);
        }
        self
    }
}

impl Add for Wide {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        self.zip(o, |a, b| a + b)
    }
}

impl Sub for Wide {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        self.zip(o, |a, b| a - b)
    }
}

impl Mul for Wide {
    type Output = Self;
    #[inline(always)]
    fn mul(self, o: Self) -> Self {
        self.zip(o, |a, b| a * b)
    }
}

impl Div for Wide {
    type Output = Self;
    #[inline(always)]
    fn div(self, o: Self) -> Self {
        self.zip(o, |a, b| a / b)
    }
}

impl Neg for Wide {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.zip(self, |a, _| -a)
    }
}

impl From<f32> for Wide {
    #[inline(always)]
    fn from(value: f32) -> Self {
        Self([value; WIDTH])
    }
}

impl Lane for Wide {
    type Scalar = f32;
    const WIDTH: usize = WIDTH;

    #[inline(always)]
    fn lanes(&self) -> &[f32] {
        &self.0
    }
    #[inline(always)]
    fn lanes_mut(&mut self) -> &mut [f32] {
        &mut self.0
    }
    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self([value as f32; WIDTH])
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        self.zip(self, |a, _| a.sqrt())
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.zip(other, Lane::max)
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.zip(other, Lane::min)
    }
    #[inline(always)]
    fn select_gt(mut self, than: Self, yes: Self, no: Self) -> Self {
        for i in 0..WIDTH {
            self.0[i] = self.0[i].select_gt(than.0[i], yes.0[i], no.0[i]);
        }
        self
    }
    #[inline(always)]
    fn lobe_power(self, exponent: Self) -> Self {
        self.zip(exponent, |a, b| a.lobe_power(b))
    }
    #[inline(always)]
    fn angle(self, cos: Self) -> Self {
        self.zip(cos, |a, b| a.angle(b))
    }
    #[inline(always)]
    fn log2(self) -> Self {
        self.zip(self, |a, _| a.log2())
    }
}
