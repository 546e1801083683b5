//! Every check that an estimator faces, whoever wrote it: the house's rules, exact answers, and what
//! it claims.
//!
//! [`checks`] is the one list. A check gives a [`Finding`]: a number that has to stay at or below a
//! bound, the worst over its cases, and for a random box scene ([`Case`]) the smallest counterexample.

mod answers;
mod box_scene;
mod case;
mod converge;
mod extremes;
mod laws;
mod method_under_test;
pub mod parity;
mod property;
mod rules;
mod settings;
mod steady;
mod test_backend;

pub use box_scene::{BoxScene, Lighting, Placement, sky};
pub use case::Case;
pub use extremes::{Extreme, extremes};
pub use method_under_test::MethodUnderTest;
pub use rules::rules_in;
pub use settings::quick;
pub use test_backend::{OnBackend, TestBackend, VerifyError};

use answers::Answer;
use interreflect_estimators::{Claim, Unsupported};
use laws::Law;
use parity::Parity;
use property::Property;
use rules::Rule;

/// One thing that is checked.
pub struct Check {
    /// Its name on the command line and in records.
    pub name: &'static str,
    /// What must hold, in a line.
    pub about: &'static str,
    kind: Kind,
}

enum Kind {
    /// What every estimator must keep to.
    Rule(Rule),
    /// What both backends must agree on.
    Parity(Parity),
    /// An exact answer.
    Answer(Answer),
    /// A claim tried in random box scenes.
    Property(Property),
    /// Convergence in a parameter.
    Convergence,
    /// No resolution stands out.
    Steady,
    /// A law of form factors.
    Law(Law),
    /// A program's own.
    Own(fn(&MethodUnderTest<'_>) -> Result<Finding, VerifyError>),
}

/// What a check came to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Verdict {
    /// It holds, by the margin between value and bound.
    Passed,
    /// It does not hold.
    Failed,
    /// It can't be asked of this estimator here; the note says why.
    NotApplicable,
    /// Not claimed, and not falsified in the cases that were tried.
    Unclaimed,
    /// Not claimed, and falsified: the method is right not to claim it.
    UnclaimedFalsified,
}

impl Verdict {
    /// Its name in records.
    pub fn name(self) -> &'static str {
        match self {
            Self::Passed => "passed",
            Self::Failed => "failed",
            Self::NotApplicable => "not_applicable",
            Self::Unclaimed => "unclaimed",
            Self::UnclaimedFalsified => "unclaimed_falsified",
        }
    }
}

/// What a check found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Finding {
    /// The worst that was met.
    pub value: f64,
    /// What it may be at most.
    pub bound: f64,
    /// Box scenes or points that were tried.
    pub cases: usize,
    /// Where the worst was met, and what is left where the bound is not 0.
    pub note: String,
    /// The smallest random box scene in which it does not hold.
    pub counterexample: Option<Case>,
}

impl Finding {
    /// Whether it holds; NaN never does.
    pub fn holds(&self) -> bool {
        self.value <= self.bound
    }
}

/// The result of one check.
#[derive(Clone, Debug, PartialEq)]
pub struct Checked {
    /// The verdict.
    pub verdict: Verdict,
    /// What was found; `None` where nothing ran.
    pub finding: Option<Finding>,
    /// The reason where nothing ran, or why it failed without a number.
    pub reason: String,
}

impl Checked {
    fn because(verdict: Verdict, reason: impl Into<String>) -> Self {
        Self {
            verdict,
            finding: None,
            reason: reason.into(),
        }
    }
}

/// Whether a check is asked of an estimator.
enum Asked {
    /// It must hold.
    Claimed,
    /// It is only tried.
    Tried,
}

/// All checks, in the order in which they run.
pub fn checks() -> impl Iterator<Item = Check> {
    let rules = rules::all().into_iter();
    let rules = rules.map(|r| (r.name, r.about, Kind::Rule(r)));
    let parity = parity::all().into_iter();
    let parity = parity.map(|p| (p.name, p.about, Kind::Parity(p)));
    let answers = answers::all().into_iter();
    let answers = answers.map(|a| (a.name, a.about, Kind::Answer(a)));
    let properties = property::all().into_iter();
    let properties = properties.map(|p| (p.name, p.about, Kind::Property(p)));
    let convergence = std::iter::once((converge::NAME, converge::ABOUT, Kind::Convergence));
    let steady = std::iter::once((steady::NAME, steady::ABOUT, Kind::Steady));
    let laws = laws::all().into_iter();
    let laws = laws.map(|l| (l.name, l.about, Kind::Law(l)));
    let all = rules
        .chain(parity)
        .chain(answers)
        .chain(properties)
        .chain(convergence)
        .chain(steady);
    all.chain(laws)
        .map(|(name, about, kind)| Check { name, about, kind })
}

impl Check {
    /// A check of a program's own, asked of every method: `find` gives a number that must not be above its
    /// bound. [`VerifyError::NotComparable`] says that it can't be asked of the method.
    pub fn own(
        name: &'static str,
        about: &'static str,
        find: fn(&MethodUnderTest<'_>) -> Result<Finding, VerifyError>,
    ) -> Self {
        let kind = Kind::Own(find);
        Self { name, about, kind }
    }

    /// Whether this is how a claim is tried.
    pub fn asks(&self, claim: &Claim) -> bool {
        match &self.kind {
            Kind::Rule(_) | Kind::Parity(_) | Kind::Own(_) => false,
            Kind::Answer(answer) => answer.asks(claim),
            Kind::Property(property) => property.asks(claim),
            Kind::Convergence => matches!(claim, Claim::Converges { .. }),
            Kind::Steady => matches!(claim, Claim::Steady),
            Kind::Law(law) => law.asks(claim),
        }
    }

    /// Carries the check out.
    pub fn run(&self, under_test: &MethodUnderTest<'_>) -> Checked {
        if let Err(why) = under_test.backend.opens(under_test.method) {
            return Checked::because(Verdict::NotApplicable, why.to_string());
        }
        let (asked, found) = match &self.kind {
            Kind::Rule(rule) => (Asked::Claimed, rule.run(under_test)),
            Kind::Parity(parity) => (Asked::Claimed, parity.run(under_test)),
            Kind::Answer(answer) => answer.run(under_test),
            Kind::Property(property) => property.run(under_test),
            Kind::Convergence => converge::run(under_test),
            Kind::Steady => steady::run(under_test),
            Kind::Law(law) => law.run(under_test),
            Kind::Own(find) => (Asked::Claimed, find(under_test).map_err(Nothing::from)),
        };
        judged(&asked, found)
    }
}

/// Nothing found: a reason that lies in the method or the scene, or a failure.
enum Nothing {
    NotApplicable(String),
    Broken(VerifyError),
}

impl From<VerifyError> for Nothing {
    fn from(error: VerifyError) -> Self {
        match error {
            VerifyError::Unsupported(why) => why.into(),
            VerifyError::NotComparable(why) => Self::NotApplicable(why),
            broken => Self::Broken(broken),
        }
    }
}

impl From<Unsupported> for Nothing {
    fn from(why: Unsupported) -> Self {
        Self::NotApplicable(why.to_string())
    }
}

type Found = Result<Finding, Nothing>;

fn judged(asked: &Asked, found: Found) -> Checked {
    match (found, asked) {
        (Err(Nothing::NotApplicable(why)), _) => Checked::because(Verdict::NotApplicable, why),
        (Err(Nothing::Broken(error)), _) => Checked::because(Verdict::Failed, error.to_string()),
        (Ok(finding), asked) => {
            let (verdict, reason) = match (asked, finding.holds()) {
                (Asked::Claimed, true) => (Verdict::Passed, ""),
                (Asked::Claimed, false) => (Verdict::Failed, ""),
                (Asked::Tried, true) => (
                    Verdict::Unclaimed,
                    "not claimed, and not falsified in the cases tried",
                ),
                (Asked::Tried, false) => {
                    (Verdict::UnclaimedFalsified, "not claimed, and falsified")
                }
            };
            Checked {
                verdict,
                finding: Some(finding),
                reason: reason.into(),
            }
        }
    }
}

/// The bound that some claim of a method gives, and why.
fn claimed<T>(under_test: &MethodUnderTest<'_>, of: impl Fn(&Claim) -> Option<T>) -> Option<T> {
    under_test.claims().iter().find_map(of)
}
