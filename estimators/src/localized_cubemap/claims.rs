//! What the method claims. The bounds beside errors of a formula are measured ones, at the resolution
//! that they are stated for.

use super::LocalizedCubemap;
use crate::{Answers, Claim, Quantity};
use interreflect_scene::params::Fidelity;

pub(super) fn claims(params: &LocalizedCubemap, quantity: Quantity) -> Vec<Claim> {
    let mut claims = vec![
        Claim::NonNegative,
        Claim::Linear,
        Claim::ScaleInvariant,
        Claim::TranslationInvariant,
        Claim::CubeSymmetric,
        Claim::DistanceFree,
        Claim::Steady,
        bound(params.fidelity, quantity),
    ];
    if quantity == Quantity::Irradiance {
        claims.extend(match params.fidelity {
            Fidelity::Published => published(),
            Fidelity::Corrected => corrected(params.resolution),
        });
    }
    claims
}

/// No energy bound: discs overlap.
fn bound(fidelity: Fidelity, quantity: Quantity) -> Claim {
    let (by, cause) = match (fidelity, quantity) {
        (Fidelity::Corrected, _) => (1.3, "discs overlap near a wall"),
        (Fidelity::Published, Quantity::Irradiance) => (
            1.6,
            "every surface counts as if it faced the reference point's way",
        ),
        (Fidelity::Published, _) => (
            6.0,
            "k_d lacks 1/π, the lobe its normalisation and the cosine",
        ),
    };
    Claim::Bounded { by, cause }
}

fn published() -> Vec<Claim> {
    let cause = "the sum of Δω' is short of 4π, and every surface counts as if it faced the \
                 reference point's way";
    let meets = |answers, within| Claim::Meets {
        answers,
        within,
        cause,
    };
    vec![meets(Answers::Uniform, 0.3), meets(Answers::Walls, 0.7)]
}

/// It converges inside a convex room; a disc stands for a texel.
fn corrected(resolution: u32) -> Vec<Claim> {
    let cause = "a disc stands for a texel";
    let meets = |answers, within: f64| Claim::Meets {
        answers,
        within: within / f64::from(resolution),
        cause,
    };
    vec![
        meets(Answers::Uniform, 0.8),
        meets(Answers::Walls, 1.2),
        meets(Answers::Smooth, 0.1),
        meets(Answers::Lit, 0.3),
        Claim::Converges {
            parameter: "resolution",
            values: ["4", "16"],
            within: 0.01,
            cause,
        },
    ]
}
