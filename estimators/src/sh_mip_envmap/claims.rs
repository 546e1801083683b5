//! What the method claims.

use super::{ShMipEnvmap, Window};
use crate::{Answers, Claim, Quantity};

/// Nine coefficients of an environment at infinity. Not that it is never negative, nor bounded: a
/// delta light gives −19/480 of its irradiance at the least.
pub(super) fn claims(params: &ShMipEnvmap, quantity: Quantity) -> Vec<Claim> {
    let mut claims = vec![
        Claim::Linear,
        Claim::ScaleInvariant,
        Claim::TranslationInvariant,
        Claim::CubeSymmetric,
        Claim::PositionInvariant,
        Claim::DistanceFree,
    ];
    if quantity != Quantity::Irradiance {
        return claims;
    }
    claims.push(Claim::Meets {
        answers: Answers::Uniform,
        within: 1e-3,
        cause: "a lit sphere's facets; a constant is exact",
    });
    if params.window == Window::None {
        let texels = f64::from(params.sh_size());
        claims.extend([
            Claim::Meets {
                answers: Answers::Smooth,
                within: 1.0 / (texels * texels),
                cause: "texels of the cube that is projected, whose radiance is a mean",
            },
            Claim::Meets {
                answers: Answers::Walls,
                within: 0.05,
                cause: "bands above the second: the cosine's are 1/16 of its mean and less",
            },
            Claim::Meets {
                answers: Answers::Patches,
                within: 3.0 / 32.0,
                cause: "bands above the second: 3/32 of a delta light's irradiance at the most",
            },
        ]);
    }
    claims
}
