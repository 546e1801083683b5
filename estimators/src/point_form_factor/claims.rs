//! What the method claims.

use super::PointFormFactor;
use super::math::point_omega;
use crate::{Answers, Claim, FormFactorLaw, Quantity};
use glam::Vec3;

/// Points instead of surfaces: no bound, for they spike near a wall. Reciprocal from middle to middle
/// by construction.
pub(super) fn claims(params: &PointFormFactor, quantity: Quantity) -> Vec<Claim> {
    let mut claims = vec![
        Claim::NonNegative,
        Claim::Linear,
        Claim::ScaleInvariant,
        Claim::TranslationInvariant,
        Claim::CubeSymmetric,
        Claim::DistanceFree,
        Claim::FormFactor {
            law: FormFactorLaw::ReciprocalMiddles,
            kernel: from_middle,
        },
    ];
    if quantity == Quantity::Irradiance && params.clamp == 0.0 {
        claims.push(Claim::Converges {
            parameter: "resolution",
            values: ["4", "16"],
            within: 0.02,
            cause: "a point stands for a texel: near texels count too much or too little",
        });
        claims.push(Claim::Meets {
            answers: Answers::Smooth,
            within: 0.1 / f64::from(params.resolution),
            cause: "a direction stands for a texel",
        });
    }
    claims
}

/// A quadrilateral as one point at its middle.
fn from_middle(x: Vec3, n: Vec3, corners: &[Vec3; 4]) -> f32 {
    let [a, b, c, d] = *corners;
    let middle = 0.25 * (a + b + c + d);
    // Clockwise seen from the front.
    let area = 0.5 * (d - b).cross(c - a);
    let i = middle - x;
    let distance = i.length();
    let cos_surface = -(i / distance).dot(area.normalize());
    let omega_sr = point_omega(area.length(), distance * distance, cos_surface, f32::MAX);
    omega_sr * n.dot(i / distance).max(0.0)
}
