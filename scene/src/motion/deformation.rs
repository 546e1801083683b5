//! Smooth periodic deformations of a mesh.

use crate::params::Choice;
use glam::{Mat3, Vec3};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// A periodic deformation of a mesh about the centre of its bounding box; at time 0, and at every
/// whole period, the mesh is at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deformation {
    /// Which one.
    pub kind: DeformationKind,
    /// Period in seconds, above 0.
    pub period_s: f32,
    /// Amplitude, from 0 to [`DeformationKind::largest_amount`]; lengths are relative to half of the
    /// longest side of the mesh's bounding box.
    pub amount: f32,
}

/// The deformations. Lengths are relative to half of the longest side of the mesh's bounding box,
/// s swings between ±amount as a sine of time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum DeformationKind {
    /// Turned about the vertical axis by the angle s·y in radians.
    Twist,
    /// Moved along x by s·sin(πy).
    Wave,
    /// Wider and narrower: x and z times 1 + s·cos²(πy/2), so most in the middle.
    Breathe,
}

impl Choice for DeformationKind {}

impl Deformation {
    /// Period in seconds where nothing says.
    pub const PERIOD_S: f32 = 2.0;

    /// A deformation of the default period and amount.
    pub fn new(kind: DeformationKind) -> Self {
        Self {
            kind,
            period_s: Self::PERIOD_S,
            amount: kind.default_amount(),
        }
    }

    /// Where between ±amount the deformation is at a time in seconds; exactly 0 at whole periods.
    pub(super) fn swing(&self, time_s: f32) -> f32 {
        let turns = (f64::from(time_s) / f64::from(self.period_s)).fract();
        // A fraction of 0 gives 0 whatever the amount.
        self.amount * (TAU * turns).sin() as f32
    }
}

impl DeformationKind {
    /// Amplitude where nothing says: 46° at both ends for the twist, else a seventh of half the
    /// mesh's size.
    pub fn default_amount(self) -> f32 {
        match self {
            Self::Twist => 0.8,
            Self::Wave | Self::Breathe => 0.15,
        }
    }

    /// Largest amplitude: a twist of three turns, a wave as wide as four meshes, and half the width
    /// for breathing, which would turn the mesh inside out from 1.
    pub fn largest_amount(self) -> f32 {
        match self {
            Self::Twist => 20.0,
            Self::Wave => 4.0,
            Self::Breathe => 0.5,
        }
    }

    /// Where a point goes, and the Jacobian of the map there, column by column; its determinant is
    /// positive. Coordinates are relative to the mesh's centre and half its longest side, so
    /// within ±1; `swing` within ±amount.
    pub(super) fn displaced(self, q: Vec3, swing: f32) -> (Vec3, Mat3) {
        match self {
            Self::Twist => {
                let turn = Mat3::from_rotation_y(swing * q.y);
                let to = turn * q;
                // d/dy turns on: swing · (axis × point).
                let along = Vec3::Y + swing * Vec3::Y.cross(to);
                (to, Mat3::from_cols(turn.x_axis, along, turn.z_axis))
            }
            Self::Wave => {
                let (sin, cos) = (std::f32::consts::PI * q.y).sin_cos();
                let along = Vec3::Y + Vec3::X * (swing * std::f32::consts::PI * cos);
                let to = q + Vec3::X * (swing * sin);
                (to, Mat3::from_cols(Vec3::X, along, Vec3::Z))
            }
            Self::Breathe => {
                // cos²(πy/2) = (1 + cos πy)/2.
                let (sin, cos) = (std::f32::consts::PI * q.y).sin_cos();
                let width = 1.0 + 0.5 * swing * (1.0 + cos);
                let slope = -0.5 * swing * std::f32::consts::PI * sin;
                let along = Vec3::new(q.x * slope, 1.0, q.z * slope);
                let to = Vec3::new(q.x * width, q.y, q.z * width);
                (to, Mat3::from_cols(Vec3::X * width, along, Vec3::Z * width))
            }
        }
    }
}
