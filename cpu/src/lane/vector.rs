//! Three lanes as a vector.

use super::{Lane, Scalar};
use glam::DVec3;
use std::ops::{Add, Neg, Sub};

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
        let [x, y, z] = v.map(L::from);
        Self { x, y, z }
    }

    /// One of the vectors that lie side by side.
    #[inline(always)]
    pub fn lane(&self, i: usize) -> Vector<L::Scalar> {
        Vector::new(self.x.lanes()[i], self.y.lanes()[i], self.z.lanes()[i])
    }

    /// What a function of a lane's number in the row gives for each.
    #[inline(always)]
    pub fn by_lane(of: impl Fn(usize) -> Vector<L::Scalar>) -> Self {
        let mut all = Self::splat([0.0; 3]);
        for i in 0..L::WIDTH {
            let one = of(i);
            all.x.lanes_mut()[i] = one.x;
            all.y.lanes_mut()[i] = one.y;
            all.z.lanes_mut()[i] = one.z;
        }
        all
    }

    /// Its components.
    #[inline(always)]
    pub fn to_array(self) -> [L; 3] {
        [self.x, self.y, self.z]
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

impl<S: Scalar> From<Vector<S>> for DVec3 {
    #[inline(always)]
    fn from(v: Vector<S>) -> Self {
        Self::new(v.x.into(), v.y.into(), v.z.into())
    }
}
