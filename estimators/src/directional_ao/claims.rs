//! What the method claims.

use super::{BelowHorizon, DIRECTIONS, DirectionalAo};
use crate::{Answers, Claim, Quantity};
use interreflect_scene::params::Fidelity;
use std::f64::consts::PI;

pub(super) fn claims(params: &DirectionalAo, quantity: Quantity) -> Vec<Claim> {
    let k = f64::from(DIRECTIONS[params.level as usize]);
    // Largest error of an open point over its orientations, measured for each level of the octahedron.
    let open = match params.fidelity {
        Fidelity::Published => [0.16, 0.08, 0.055, 0.03, 0.022],
        Fidelity::Corrected => [0.16, 0.08, 0.033, 0.01, 0.003],
    }[params.level as usize];
    let bounded = Claim::Bounded {
        by: 1.0 + open,
        cause: "how well the directions integrate a cosine",
    };
    let mut claims = vec![bounded, Claim::ScaleInvariant, Claim::TranslationInvariant];
    if quantity == Quantity::Irradiance {
        claims.push(Claim::Linear);
    }
    // With its sign a direction below the horizon takes away what one above it gives: the sum over an
    // open sphere is 0.
    if params.below_horizon == BelowHorizon::Signed {
        return claims;
    }
    claims.extend([
        Claim::NonNegative,
        Claim::Meets {
            answers: Answers::Uniform,
            within: open,
            cause: "how well the directions integrate a cosine",
        },
    ]);
    if quantity == Quantity::AmbientOcclusion {
        claims.extend([
            Claim::MonotoneInOccluders,
            Claim::Meets {
                answers: Answers::Openness,
                // The border between open and occluded cuts about ½√(πk) of k cells, each of which
                // counts 4/k at most and is wrong like a number cut evenly, 1/√12 of it. Twice for
                // cells that lie alike, three times for the worst of thirty.
                within: open + 6.0 * (4.0 / k) * (0.5 * (PI * k).sqrt()).sqrt() / 12f64.sqrt(),
                cause: "directions along the border between open and occluded",
            },
        ]);
    }
    claims
}
