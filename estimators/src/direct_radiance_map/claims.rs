//! What the method claims.

use super::{DirectRadianceMap, Formula, Pictures};
use crate::{Answers, Claim, Quantity};

/// A few photons stand for all: no more than what they are can be claimed of their sum.
pub(super) fn claims(params: &DirectRadianceMap, quantity: Quantity) -> Vec<Claim> {
    let mut claims = vec![
        Claim::NonNegative,
        Claim::Linear,
        Claim::TranslationInvariant,
    ];
    if params.samples_symmetrically() {
        claims.push(Claim::CubeSymmetric);
    }
    if params.formula() != Formula::Constant {
        claims.extend([Claim::DarkFromBehind, Claim::ScaleInvariant]);
        claims.push(Claim::Bounded {
            by: 1.0,
            cause: "measured: photons cover all that the light sees",
        });
    }
    let complete = params.pictures == Pictures::Surround;
    let fine = params.formula() == Formula::Corrected && params.samples_per_side >= 3 && complete;
    if fine && quantity == Quantity::Irradiance {
        let cause = "a photon is a disc, and its wall is curved";
        claims.extend([
            Claim::Meets {
                answers: Answers::Uniform,
                within: 0.1,
                cause,
            },
            Claim::Meets {
                answers: Answers::Lit,
                within: 0.12,
                cause,
            },
        ]);
    }
    claims
}
