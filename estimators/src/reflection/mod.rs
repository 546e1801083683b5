//! Reflection of an environment at infinity: the mirrored direction, Schlick's Fresnel factor and
//! what they make of irradiance and filtered radiance.

pub mod leaves;
pub mod math;

use crate::{Backend, Changed, Inputs, Quantity};
use glam::Vec3;

/// Twins of math.rs.
pub const LEAVES: &str = include_str!("math.wgsl");

/// Whether the points of a session reflect by a specular lobe, found out anew when they change.
#[derive(Default)]
pub struct Lobes(Option<bool>);

impl Lobes {
    /// Whether what is estimated needs radiance filtered with a lobe: a glossy quantity, and some
    /// point with k_s ≠ 0.
    pub fn needed<B: Backend>(&mut self, inputs: &Inputs<'_, B>) -> bool {
        if inputs.quantity != Quantity::GlossyRadiance {
            return false;
        }
        if self.0.is_none() || inputs.changed.any(Changed::POINTS) {
            let mut points = inputs.host_points.iter().flatten();
            self.0 = Some(points.any(|point| point.material.specular != Vec3::ZERO));
        }
        self.0 == Some(true)
    }
}
