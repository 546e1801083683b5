//! Exact answers.

pub mod form_factors;
pub mod polygon;
pub mod solid_angle;
