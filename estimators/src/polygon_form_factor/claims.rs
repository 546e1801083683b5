//! What the method claims.

use super::math::{clipped_quad, edge_integral};
use super::{Corners, Facing, PolygonFormFactor};
use crate::{Answers, Claim, FormFactorLaw};
use glam::Vec3;
use interreflect_cpu::lane::Vector;
use interreflect_scene::params::Fidelity;

pub(super) fn claims(params: &PolygonFormFactor) -> Vec<Claim> {
    let mut claims = vec![
        Claim::NonNegative,
        Claim::Linear,
        Claim::ScaleInvariant,
        Claim::TranslationInvariant,
        Claim::DistanceFree,
    ];
    claims.extend(match params.fidelity {
        Fidelity::Published => published(),
        Fidelity::Corrected => corrected(params),
    });
    claims
}

/// Neither the furnace nor the cube's symmetries: one edge's angle stands for all four.
fn published() -> Vec<Claim> {
    let cause = "one edge's angle stands for all four, and nothing is clipped at the horizon";
    let meets = |answers, within| Claim::Meets {
        answers,
        within,
        cause,
    };
    vec![
        meets(Answers::Uniform, 0.7),
        meets(Answers::Walls, 0.9),
        meets(Answers::Smooth, 0.25),
        Claim::Bounded { by: 3.0, cause },
    ]
}

fn corrected(params: &PolygonFormFactor) -> Vec<Claim> {
    let m = f64::from(params.resolution);
    let laws = [
        FormFactorLaw::Fraction,
        FormFactorLaw::Additive,
        FormFactorLaw::Closed,
        FormFactorLaw::Oriented,
        FormFactorLaw::ReciprocalPatches,
    ];
    let kernel = irradiance_of_patch;
    let mut claims = vec![Claim::Meets {
        answers: Answers::Smooth,
        within: 0.5 / (m * m),
        cause: "radiance is constant over a texel",
    }];
    claims.extend(laws.map(|law| Claim::FormFactor { law, kernel }));
    if params.facing == Facing::Signed && params.corners() == Corners::Exact {
        let cause = "a texel's quadrilateral cuts off what it does not meet at its corners";
        claims.extend([
            Claim::Bounded {
                by: 1.0,
                cause: "signed quadrilaterals around a point count 1",
            },
            Claim::Meets {
                answers: Answers::Uniform,
                within: 1e-3,
                cause: "a lit sphere's facets; a closed hull counts 1",
            },
            Claim::Meets {
                answers: Answers::Walls,
                within: 0.4 / m,
                cause,
            },
            Claim::Converges {
                parameter: "resolution",
                values: ["4", "16"],
                within: 0.005,
                cause,
            },
        ]);
    }
    claims
}

/// Lambert's kernel in float32, clipped at the horizon.
fn irradiance_of_patch(x: Vec3, n: Vec3, corners: &[Vec3; 4]) -> f32 {
    let vector = |v: Vec3| Vector::new(v.x, v.y, v.z);
    let r = corners.map(|c| vector(c - x));
    let n = vector(n);
    let heights = r.map(|r| n.dot(r));
    if heights.iter().all(|h| *h > 0.0) {
        let edges = (0..4).map(|i| edge_integral(r[i], r[(i + 1) % 4], n));
        return 0.5 * edges.sum::<f32>();
    }
    match heights.iter().any(|h| *h > 0.0) {
        true => clipped_quad(&r, &heights, n),
        false => 0.0,
    }
}
