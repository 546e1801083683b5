//! Exact answers.

pub mod form_factors;
pub mod polygon;
