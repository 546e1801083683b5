//! What every method claims that convolves the captured environment.

use super::Sizes;
use crate::{Answers, Claim, Quantity};

/// An environment at infinity, convolved exactly with the cosine at the nodes of a map.
pub fn claims(sizes: &Sizes, quantity: Quantity) -> Vec<Claim> {
    let mut claims = vec![
        Claim::NonNegative,
        Claim::Bounded {
            by: 1.0,
            cause: "weights of a convolution sum up to 1",
        },
        Claim::Linear,
        Claim::ScaleInvariant,
        Claim::TranslationInvariant,
        Claim::CubeSymmetric,
        Claim::PositionInvariant,
        Claim::DistanceFree,
    ];
    if quantity == Quantity::Irradiance {
        // Bilinear lookup: h²/8 of the second derivative, which is at most the value itself, in each of
        // two directions, h = 2/cells at the middle of a face.
        let lookup = (2.0 / sizes.cells as f64).powi(2) / 4.0;
        // A captured texel counts at its middle: the light of an edge is moved by half of one.
        let edge = 2.0 / f64::from(sizes.captured.size);
        // Averaged texels count by their vector solid angles, exact but for the horizon's.
        let horizon = 1.0 / f64::from(sizes.resolution).powi(2);
        claims.extend([
            Claim::Meets {
                answers: Answers::Uniform,
                within: lookup + 1e-3,
                cause: "the bilinear lookup, and a lit sphere's facets",
            },
            Claim::Meets {
                answers: Answers::Smooth,
                within: lookup + horizon,
                cause: "the bilinear lookup, and texels that the horizon cuts",
            },
            Claim::Meets {
                answers: Answers::Walls,
                within: lookup + horizon + edge,
                cause: "the bilinear lookup, texels that the horizon cuts, and edges of walls",
            },
        ]);
    }
    claims
}
