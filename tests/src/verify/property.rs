//! Claims, tested in random box scenes.

mod at_points;
mod invariances;
mod light;

use super::box_scene::{BoxScene, Lighting};
use super::case::Case;
use super::{Asked, Finding, Found, MethodUnderTest, Nothing, VerifyError, claimed};
use glam::Vec3;
use interreflect_estimators::{Claim, Quantity};
use interreflect_scene::Estimate;
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestError, TestRng, TestRunner};
use std::cell::Cell;

/// A claim with the way to falsify it.
pub(super) struct Property {
    pub(super) name: &'static str,
    pub(super) about: &'static str,
    /// The bound that a claim sets, and its cause; `None` for another claim.
    bound: fn(&Claim) -> Option<(f64, &'static str)>,
    /// The bound where it is not claimed; `None`: it is not tried then.
    tried: Option<f64>,
    /// What rounding may add to it.
    slack: Slack,
    /// Why it can't be asked under this lighting, if it can't.
    out_of_place: fn(Lighting, Quantity) -> Option<&'static str>,
    /// By how much it is violated in a box scene.
    violation: fn(&MethodUnderTest<'_>, &BoxScene) -> Result<Worst, VerifyError>,
}

/// What a bound leaves room for.
#[derive(Clone, Copy, PartialEq)]
enum Slack {
    /// float32 sums.
    Rounding,
    /// And captured texels that lie on the edges of surfaces.
    Edges,
}

/// All properties.
pub(super) fn all() -> Vec<Property> {
    let all = light::all().into_iter().chain(invariances::all());
    all.chain([at_points::property()]).collect()
}

/// The largest violation among the points of a box scene.
#[derive(Clone, Copy, Debug, Default)]
struct Worst {
    value: f64,
    point: usize,
}

impl Worst {
    /// The largest of some values, over what surroundings of the greatest radiance would give.
    fn of(values: impl Iterator<Item = f64>, greatest: f64) -> Self {
        let mut worst = Self {
            value: f64::NEG_INFINITY,
            point: 0,
        };
        for (point, value) in values.enumerate() {
            if value > worst.value || value.is_nan() {
                worst = Self { value, point };
            }
        }
        let nothing = worst.value <= 0.0 || greatest <= 0.0;
        worst.value = match nothing {
            // Nothing was sent: any light is beyond every bound.
            true if worst.value > 0.0 => f64::INFINITY,
            true => worst.value.max(0.0),
            false => worst.value / greatest,
        };
        worst
    }

    /// The largest difference of two estimates.
    fn apart(a: &Estimate, b: &Estimate, greatest: f64) -> Self {
        Self::of(a.iter().zip(b.iter()).map(|(a, b)| apart(a, b)), greatest)
    }

    /// The larger of two.
    fn or(self, other: Self) -> Self {
        match self.value >= other.value {
            true => self,
            false => other,
        }
    }
}

fn apart(a: Vec3, b: Vec3) -> f64 {
    f64::from((a - b).abs().max_element())
}

/// Box scenes that a shrinking counterexample may be tried in.
const SHRINKING: u32 = 120;

impl Property {
    pub(super) fn asks(&self, claim: &Claim) -> bool {
        (self.bound)(claim).is_some()
    }

    /// Tries to falsify the claim.
    pub(super) fn run(&self, under_test: &MethodUnderTest<'_>) -> (Asked, Found) {
        let claim = claimed(under_test, self.bound);
        let asked = match claim {
            Some(_) => Asked::Claimed,
            None => Asked::Tried,
        };
        (asked, self.found(under_test, claim))
    }

    fn found(&self, under_test: &MethodUnderTest<'_>, claim: Option<(f64, &'static str)>) -> Found {
        let lighting = Lighting::of(under_test.model(), under_test.quantity);
        if let Some(why) = (self.out_of_place)(lighting, under_test.quantity) {
            return Err(Nothing::NotApplicable(why.into()));
        }
        let Some((bound, cause)) = claim.or(self.tried.map(|bound| (bound, ""))) else {
            return Err(Nothing::NotApplicable("not claimed".into()));
        };
        let bound = bound + self.slack(under_test, lighting);
        if let Some(case) = &under_test.case {
            return self.tell(under_test, case, lighting, bound, cause, 1);
        }
        let worst = Cell::new(0.0_f64);
        let tried = Cell::new(0);
        // What is not claimed is not worth a small counterexample.
        let shrinking = if claim.is_some() { SHRINKING } else { 0 };
        let smaller = Cell::new(None::<u32>);
        let outcome = runner(under_test).run(&Case::any(), |case| {
            match smaller.get() {
                // Whatever is still simpler than the smallest so far is let pass.
                Some(count) if count >= shrinking => return Ok(()),
                Some(count) => smaller.set(Some(count + 1)),
                None => tried.set(tried.get() + 1),
            }
            let outcome = match (self.violation)(under_test, &case.box_scene(lighting)) {
                Ok(found) if found.value <= bound => {
                    worst.set(worst.get().max(found.value));
                    return Ok(());
                }
                Ok(found) => TestCaseError::fail(found.value.to_string()),
                Err(VerifyError::Unsupported(why)) => return Err(TestCaseError::reject(why.0)),
                Err(broken) => TestCaseError::fail(broken.to_string()),
            };
            smaller.set(smaller.get().or(Some(0)));
            Err(outcome)
        });
        let tried = tried.get();
        match outcome {
            Ok(()) => Ok(Finding {
                value: worst.get(),
                bound,
                cases: tried,
                note: cause.into(),
                counterexample: None,
            }),
            Err(TestError::Fail(_, case)) => {
                self.tell(under_test, &case, lighting, bound, cause, tried)
            }
            Err(TestError::Abort(why)) => Err(Nothing::NotApplicable(why.to_string())),
        }
    }

    /// The violation in one box scene, as a sentence.
    fn tell(
        &self,
        under_test: &MethodUnderTest<'_>,
        case: &Case,
        lighting: Lighting,
        bound: f64,
        cause: &str,
        cases: usize,
    ) -> Found {
        let (value, what) = match (self.violation)(under_test, &case.box_scene(lighting)) {
            Ok(found) => (found.value, format!("worst at point {}", found.point)),
            Err(VerifyError::Unsupported(why)) => return Err(why.into()),
            // No number, or no estimate at all: beyond every bound.
            Err(broken) => (f64::INFINITY, broken.to_string()),
        };
        let parts = [cause, &what];
        let parts: Vec<&str> = parts.into_iter().filter(|p| !p.is_empty()).collect();
        let finding = Finding {
            value,
            bound,
            cases,
            note: parts.join("; "),
            counterexample: None,
        };
        Ok(Finding {
            counterexample: (!finding.holds()).then(|| case.clone()),
            ..finding
        })
    }

    fn slack(&self, under_test: &MethodUnderTest<'_>, lighting: Lighting) -> f64 {
        let facts = super::case::facts(lighting);
        let rounding = under_test.rounding(&facts);
        match self.slack {
            Slack::Rounding => rounding,
            Slack::Edges => rounding + under_test.edge_texels(&facts),
        }
    }
}

/// Box scenes from the seed of the method under test, the same for every property, method and backend.
fn runner(under_test: &MethodUnderTest<'_>) -> TestRunner {
    let config = Config {
        cases: under_test.cases,
        // No more than `SHRINKING` of them are tried; the largest number would mean four a case.
        max_shrink_iters: u32::MAX - 1,
        max_local_rejects: 1,
        max_global_rejects: 1,
        failure_persistence: None,
        ..Config::default()
    };
    let mut seed = [0; 32];
    seed[..8].copy_from_slice(&under_test.seed.to_le_bytes());
    TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &seed))
}
