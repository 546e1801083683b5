//! Which error is asked for, and how far it can be believed.

use crate::domain::record::{Comparison, Run, Verdict};
use serde::{Deserialize, Serialize};
use std::fmt;

/// The error by which runs are judged.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Metric {
    /// relMSE against path-traced truth.
    #[default]
    Truth,
    /// relMSE against what each method claims to compute: its implementation, not its model.
    OwnModel,
    /// Mean FLIP of the image against the truth's.
    Flip,
}

impl Metric {
    /// A run's error; `None` if it has no such number.
    pub fn value(self, run: &Run) -> Option<Measured> {
        let measured = match self {
            Self::Truth => relmse(run.truth.as_ref()?),
            Self::OwnModel => relmse(run.own_model.as_ref()?),
            Self::Flip => flip(run.truth.as_ref()?),
        }?;
        let numbers = [measured.value, measured.noise];
        numbers
            .iter()
            .all(|v| v.is_finite() && *v >= 0.0)
            .then_some(measured)
    }
}

impl fmt::Display for Metric {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Truth => "relMSE against the truth",
            Self::OwnModel => "relMSE against its own model",
            Self::Flip => "FLIP against the truth",
        })
    }
}

fn relmse(comparison: &Comparison) -> Option<Measured> {
    Some(Measured {
        value: comparison.relmse?,
        noise: comparison.noise_floor?,
        conclusive: comparison.verdict == Verdict::Conclusive,
    })
}

/// FLIP has no floor of its own. It grows about as the 0.7th power of a colour difference, so as the
/// 0.35th of relMSE: that part of it is put down to the noise which the noise has of relMSE.
fn flip(comparison: &Comparison) -> Option<Measured> {
    let (value, of_relmse) = (comparison.flip?, relmse(comparison)?);
    let part = match of_relmse.value > of_relmse.noise {
        true => (of_relmse.noise / of_relmse.value).powf(0.35),
        false => 1.0,
    };
    Some(Measured {
        value,
        noise: if of_relmse.noise > 0.0 {
            part * value
        } else {
            0.0
        },
        conclusive: of_relmse.conclusive,
    })
}

/// An error with its noise.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Measured {
    /// The error as it was measured, the reference's noise included; at least 0.
    pub value: f64,
    /// What of it the reference's noise alone would show.
    pub noise: f64,
    /// Whether the reference resolves it; else it is an upper bound.
    pub conclusive: bool,
}

impl Measured {
    /// By how much two errors have to differ to be told apart: the sum of their noises. They share a
    /// reference, whose noise shows in both, so that this errs on the side of doubt.
    fn doubt(self, other: Self) -> f64 {
        self.noise + other.noise
    }

    /// Whether this is the smaller error beyond doubt. Two upper bounds are never told apart.
    pub fn surely_less(self, other: Self) -> bool {
        self.resolves(other) && other.value - self.value > self.doubt(other)
    }

    /// Whether this is beyond doubt not the larger error: smaller, or the same without any noise.
    pub(super) fn surely_at_most(self, other: Self) -> bool {
        self.resolves(other) && other.value - self.value >= self.doubt(other)
    }

    fn resolves(self, other: Self) -> bool {
        self.conclusive || other.conclusive
    }

    /// Whether neither error is the smaller one beyond doubt.
    pub fn alike(self, other: Self) -> bool {
        !self.surely_less(other) && !other.surely_less(self)
    }
}
