//! From measured numbers to a verdict, without a word of any experiment.
//!
//! A trial says that one amount is smaller than another. Amounts that differ by less than what they may
//! be off decide nothing. A claim holds if all its trials do, does not if none does but some fail, is inconclusive
//! if all are undecided, and holds in part otherwise.

use crate::domain::format;
use crate::domain::record::Backend;
use serde::Serialize;

/// A number, and how far it may be off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Amount {
    /// The number.
    pub value: f64,
    /// Half the width of the interval around it that counts as the same; not negative.
    pub spread: f64,
}

impl Amount {
    /// A number that a formula or a repeated run gives alike every time.
    pub const fn exact(value: f64) -> Self {
        Self { value, spread: 0.0 }
    }

    /// The number times an exact factor.
    pub fn times(self, factor: f64) -> Self {
        Self {
            value: self.value * factor,
            spread: self.spread * factor.abs(),
        }
    }

    /// The sum of two independent numbers.
    pub fn plus(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            spread: self.spread.hypot(other.spread),
        }
    }

    /// The quotient of two independent numbers, the spreads to first order; the divisor is not 0.
    pub fn over(self, other: Self) -> Self {
        let value = self.value / other.value;
        let relative = (self.spread / self.value).hypot(other.spread / other.value);
        Self {
            value,
            spread: if self.value == 0.0 {
                self.spread / other.value.abs()
            } else {
                value.abs() * relative
            },
        }
    }
}

/// What a trial comes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Outcome {
    /// As claimed.
    Holds,
    /// Not as claimed.
    Fails,
    /// The difference is within what the numbers may be off.
    Undecided,
}

/// One comparison that a claim makes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Trial {
    /// What is compared, in which case.
    pub what: String,
    /// Where it ran.
    pub backend: Backend,
    /// What it comes to.
    pub outcome: Outcome,
    /// The numbers, in words.
    pub evidence: String,
    /// Logarithm of the amount that is claimed to be larger over the other one.
    #[serde(skip)]
    margin: f64,
    /// What is compared are ratios of times.
    #[serde(skip)]
    of_times: bool,
}

impl Trial {
    /// That `a` is smaller than `b`, each with its own uncertainty.
    pub fn less(what: impl Into<String>, backend: Backend, a: Amount, b: Amount) -> Self {
        Self::less_by(what, backend, (a.value, b.value), a.spread.hypot(b.spread))
    }

    /// The same trial, of ratios of times.
    pub fn of_times(self) -> Self {
        Self {
            of_times: true,
            ..self
        }
    }

    /// Whether it compares times, whose unit is the last word, or ratios of them.
    pub fn is_of_times(&self) -> bool {
        self.of_times || self.what.ends_with(" ms")
    }

    /// That the first number is smaller than the second, where their difference may be off by
    /// `noise`. Numbers that are equal up to that, or no numbers at all, decide nothing.
    pub fn less_by(
        what: impl Into<String>,
        backend: Backend,
        (a, b): (f64, f64),
        noise: f64,
    ) -> Self {
        let outcome = match b - a {
            d if d > noise => Outcome::Holds,
            d if d < -noise => Outcome::Fails,
            _ => Outcome::Undecided,
        };
        let sign = match outcome {
            Outcome::Holds => "<",
            Outcome::Fails => ">",
            Outcome::Undecided => "≈",
        };
        Self {
            what: what.into(),
            backend,
            outcome,
            evidence: format!("{} {sign} {}", format::number(a), format::number(b)),
            margin: (b.max(f64::MIN_POSITIVE) / a.max(f64::MIN_POSITIVE)).ln(),
            of_times: false,
        }
    }
}

/// What becomes of a claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Every trial holds.
    Holds,
    /// Some trials hold, others don't or are undecided.
    HoldsInPart,
    /// No trial holds.
    DoesNotHold,
    /// Each trial's difference is within what its numbers may be off.
    Inconclusive,
    /// Nothing was tried: why.
    NotRun(String),
    /// Nothing is claimed of the pictures and numbers that are there.
    Shown,
}

impl Verdict {
    /// In words.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::HoldsInPart => "holds in part",
            Self::DoesNotHold => "does not hold",
            Self::Inconclusive => "inconclusive",
            Self::NotRun(_) => "not run",
            Self::Shown => "shown",
        }
    }

    /// Why there is none.
    pub fn reason(&self) -> Option<&str> {
        match self {
            Self::NotRun(reason) => Some(reason),
            _ => None,
        }
    }
}

/// What is said of a claim that an experiment neither tries nor leaves out with a reason.
const UNTRIED: &str = "the experiment made no trial of it";

/// The verdict on a claim, and one sentence why.
pub fn conclude(trials: &[&Trial]) -> (Verdict, String) {
    if trials.is_empty() {
        return (Verdict::NotRun(UNTRIED.into()), UNTRIED.into());
    }
    let of = |outcome| trials.iter().filter(move |t| t.outcome == outcome);
    let (held, failed) = (of(Outcome::Holds).count(), of(Outcome::Fails).count());
    let verdict = match (held, failed) {
        (0, 0) => Verdict::Inconclusive,
        (0, _) => Verdict::DoesNotHold,
        (held, 0) if held == trials.len() => Verdict::Holds,
        _ => Verdict::HoldsInPart,
    };
    (verdict, sentence(trials))
}

fn sentence(trials: &[&Trial]) -> String {
    let of = |outcome| trials.iter().filter(move |t| t.outcome == outcome);
    let held = of(Outcome::Holds).count();
    let undecided = of(Outcome::Undecided).count();
    let mut text = format!("{held} of {} trials hold", trials.len());
    if undecided > 0 {
        text += &format!(", {undecided} are within the noise");
    }
    if let Some(apart) = backends_apart(trials) {
        text += &format!(" ({apart})");
    }
    let worst = of(Outcome::Fails).min_by(|a, b| a.margin.total_cmp(&b.margin));
    let told = match worst {
        Some(worst) => Some(("not", worst)),
        None => of(Outcome::Holds)
            .min_by(|a, b| a.margin.total_cmp(&b.margin))
            .map(|closest| ("closest", closest)),
    };
    if let Some((how, trial)) = told {
        let Trial { what, evidence, .. } = trial;
        text += &format!("; {how}: {what} on {}, {evidence}", trial.backend);
    }
    text
}

/// How many trials hold on each backend, where the same trial comes out differently on them.
fn backends_apart(trials: &[&Trial]) -> Option<String> {
    let differs = |t: &Trial| {
        let twin = trials
            .iter()
            .find(|o| o.what == t.what && o.backend != t.backend);
        twin.is_some_and(|twin| twin.outcome != t.outcome)
    };
    trials.iter().any(|trial| differs(trial)).then(|| {
        let count = |backend| {
            let of = || trials.iter().filter(move |t| t.backend == backend);
            let held = of().filter(|t| t.outcome == Outcome::Holds).count();
            format!("{held} of {} on {backend}", of().count())
        };
        format!("{}, {}", count(Backend::Cpu), count(Backend::Gpu))
    })
}

#[cfg(test)]
mod tests;
