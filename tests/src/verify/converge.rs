//! Convergence to a method's own model inside a convex room.

use super::box_scene::Lighting;
use super::case::Case;
use super::{Asked, Finding, Found, MethodUnderTest, Nothing, VerifyError, claimed};
use interreflect_estimators::{Claim, Configured, Quantity};
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

pub(super) const NAME: &str = "converges";
pub(super) const ABOUT: &str = "closer to its own model in a convex room as a parameter grows";

pub(super) fn run(under_test: &MethodUnderTest<'_>) -> (Asked, Found) {
    let claim = claimed(under_test, |claim| match *claim {
        Claim::Converges {
            parameter,
            values,
            within,
            cause,
        } => Some((parameter, values, within, cause)),
        _ => None,
    });
    match claim {
        Some(claim) => (Asked::Claimed, found(under_test, claim)),
        None => {
            let why = "it does not say in which parameter it converges".into();
            (Asked::Tried, Err(Nothing::NotApplicable(why)))
        }
    }
}

fn found(
    under_test: &MethodUnderTest<'_>,
    (parameter, values, within, cause): (&str, [&str; 2], f64, &str),
) -> Found {
    if under_test.quantity != Quantity::Irradiance {
        let why = "only irradiance has an exact answer in every room".into();
        return Err(Nothing::NotApplicable(why));
    }
    let rooms = rooms(under_test);
    let mut errors = [0.0; 2];
    for (error, value) in errors.iter_mut().zip(values) {
        let mut method = under_test.method.boxed_clone();
        // A claim about a parameter that is not there is found by the suite over all claims.
        method
            .set(parameter, value)
            .map_err(|e| Nothing::NotApplicable(e.to_string()))?;
        *error = mean_error(under_test, &*method, &rooms)?;
    }
    let [coarse, fine] = errors;
    Ok(Finding {
        // Not below the coarse error: as bad as if it were infinite.
        value: if fine < coarse { fine } else { f64::INFINITY },
        bound: within,
        cases: rooms.len(),
        note: format!(
            "{cause}; mean error {coarse:.5} at {parameter}={}, {fine:.5} at {}",
            values[0], values[1]
        ),
        counterexample: None,
    })
}

/// Some rooms of the random ones.
fn rooms(under_test: &MethodUnderTest<'_>) -> Vec<Case> {
    let mut seed = [1; 32];
    seed[..8].copy_from_slice(&under_test.seed.to_le_bytes());
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &seed);
    let mut runner = TestRunner::new_with_rng(Config::default(), rng);
    let any = Case::any();
    let rooms = (0..under_test.cases).filter_map(|_| any.new_tree(&mut runner).ok());
    rooms.map(|tree| tree.current()).collect()
}

/// Mean difference from the exact answer over what surroundings of the greatest radiance give.
fn mean_error(
    under_test: &MethodUnderTest<'_>,
    method: &dyn Configured,
    rooms: &[Case],
) -> Result<f64, VerifyError> {
    let of = MethodUnderTest {
        method,
        case: None,
        ..*under_test
    };
    let (mut sum, mut count) = (0.0, 0.0);
    for room in rooms {
        let box_scene = room.box_scene(Lighting::Walls);
        let estimate = of.estimate(&box_scene)?;
        let greatest = box_scene
            .greatest(under_test.quantity)
            .max(f64::MIN_POSITIVE);
        for (point, value) in box_scene.points.iter().zip(estimate.iter()) {
            if let Some(exact) = box_scene.irradiance(under_test.model(), point) {
                sum += (f64::from(value.x) - exact).abs() / greatest;
                count += 1.0;
            }
        }
    }
    Ok(sum / f64::max(count, 1.0))
}
