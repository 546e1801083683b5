//! What the method claims.

use super::PathReference;
use crate::{Answers, Claim, Quantity};

/// An unbiased estimate of light transport: what it claims of single points is their noise.
pub(super) fn claims(params: &PathReference, quantity: Quantity) -> Vec<Claim> {
    let noise = 1.0 / f64::from(params.samples).sqrt();
    let mut claims = vec![Claim::NonNegative, Claim::ScaleInvariant];
    if quantity == Quantity::AmbientOcclusion {
        claims.extend([
            Claim::Bounded {
                by: 1.0,
                cause: "a fraction of rays",
            },
            Claim::Meets {
                answers: Answers::Openness,
                within: 2.0 * noise,
                cause: "noise: four standard errors, at most half a ray each",
            },
        ]);
        return claims;
    }
    claims.push(Claim::DarkFromBehind);
    if quantity == Quantity::Irradiance {
        let meets = |answers, standard_errors: f64| Claim::Meets {
            answers,
            within: standard_errors * noise,
            cause: "noise of the worst of some hundred samples",
        };
        // Rays that miss a small patch are most of them.
        claims.extend([
            meets(Answers::Uniform, 2.0),
            meets(Answers::Smooth, 2.0),
            meets(Answers::Walls, 2.0),
            meets(Answers::Patches, 4.0),
            meets(Answers::Lit, 2.0),
        ]);
    }
    claims
}
