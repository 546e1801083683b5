//! One number.

use super::polynomials::{self, angle, exp2};
use super::{Lane, Scalar};
use std::slice::{from_mut, from_ref};

impl Lane for f64 {
    type Scalar = Self;
    const WIDTH: usize = 1;

    #[inline(always)]
    fn lanes(&self) -> &[Self] {
        from_ref(self)
    }
    #[inline(always)]
    fn lanes_mut(&mut self) -> &mut [Self] {
        from_mut(self)
    }
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
    #[inline(always)]
    fn log2(self) -> Self {
        f64::log2(self)
    }
}

impl Scalar for f64 {
    #[inline(always)]
    fn whole(self) -> usize {
        self as usize
    }
}

impl Lane for f32 {
    type Scalar = Self;
    const WIDTH: usize = 1;

    #[inline(always)]
    fn lanes(&self) -> &[Self] {
        from_ref(self)
    }
    #[inline(always)]
    fn lanes_mut(&mut self) -> &mut [Self] {
        from_mut(self)
    }
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
        let power = exp2(exponent * polynomials::log2(self));
        if self > 0.0 { power } else { 0.0 }
    }
    #[inline(always)]
    fn angle(self, cos: Self) -> Self {
        angle(self, cos)
    }
    #[inline(always)]
    fn log2(self) -> Self {
        f32::log2(self)
    }
}

impl Scalar for f32 {
    #[inline(always)]
    fn whole(self) -> usize {
        self as usize
    }
}
