//! What records let one conclude: which method, with which parameters, for this scene, this time and this
//! error.
//!
//! Every method is biased, so error times time would be no fair rank: a method that stops at its floor
//! would be charged for each further millisecond. Said instead are the [`Front`] of error against time, the
//! tables at equal time and at equal error ([`Table`]), which hold methods against each other and against
//! path tracing and n-ray gathering, and each method's [`Floor`], the error that more time does not lower.
//! [`advise`] answers a question with a limit.
//!
//! All are pure functions of runs on one machine; what is held against each other shares its [`Problem`].
//! Errors are by a [`Metric`]; what is inside the noise of the times or of the reference is named with the answer.

mod advice;
mod baseline;
mod candidate;
mod equal;
mod floor;
mod metric;
mod nice_numbers;
mod pareto;
mod problem;

pub use advice::{Advice, Answer, Budget, advise};
pub use baseline::{Baseline, Interpolated};
pub use candidate::{Choice, FrameTime};
pub use equal::{Cell, Contestant, Numbers, Question, Row, Table, equal_error, equal_time};
pub use floor::{Floor, floors};
pub use metric::{Measured, Metric};
pub use pareto::{Front, Standing, fronts, pareto};
pub use problem::Problem;

use crate::domain::record::Run;
use serde::Serialize;

/// All that can be concluded without a question.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Conclusions {
    /// By which errors.
    pub metric: Metric,
    /// One front for each place.
    pub fronts: Vec<Front>,
    /// The least error within a time; one table for each place and backend.
    pub equal_time: Vec<Table>,
    /// The least time to an error; one table for each place and backend.
    pub equal_error: Vec<Table>,
    /// One floor for each place, method and backend.
    pub floors: Vec<Floor>,
}

impl Conclusions {
    /// Concludes from methods' runs; `baselines` are runs of the path tracer, which the tables show beside
    /// them. Those that are no [`Baseline`] are passed over.
    pub fn of(runs: &[Run], baselines: &[Run], metric: Metric) -> Self {
        Self {
            metric,
            fronts: pareto(runs, metric),
            equal_time: equal_time(runs, baselines, metric),
            equal_error: equal_error(runs, baselines, metric),
            floors: floors(runs, metric),
        }
    }
}

#[cfg(test)]
pub(crate) mod samples;
#[cfg(test)]
mod tests;
