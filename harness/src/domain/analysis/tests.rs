#![allow(clippy::unwrap_used, reason = "tests")]

mod advice;
mod equal;
mod front;
mod metric;

use super::samples::*;
use super::*;
use crate::domain::record::{Backend, ParamValue, Phases, Verdict};

fn close(found: f64, expected: f64) {
    // A power of a logarithm in float64.
    let apart = (found / expected - 1.0).abs();
    assert!(apart < 1e-12, "{found} is not {expected}");
}
