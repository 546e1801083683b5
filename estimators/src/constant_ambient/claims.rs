//! What the method claims.

use crate::{Answers, Claim, Quantity};

/// A mean of what is seen from the reference point, the same everywhere and for every normal.
pub(super) fn claims(quantity: Quantity) -> Vec<Claim> {
    let mut claims = vec![
        Claim::NonNegative,
        Claim::Bounded {
            by: 1.0,
            cause: "a mean of radiance is below the greatest",
        },
        Claim::Linear,
        Claim::ScaleInvariant,
        Claim::TranslationInvariant,
        Claim::CubeSymmetric,
        Claim::PositionInvariant,
        Claim::DistanceFree,
    ];
    if quantity == Quantity::Irradiance {
        claims.extend([
            Claim::Meets {
                answers: Answers::Uniform,
                within: 1e-3,
                cause: "a lit sphere's facets",
            },
            Claim::Meets {
                answers: Answers::Walls,
                within: 5e-3,
                cause: "captured texels on the edges of walls",
            },
        ]);
    }
    claims
}
