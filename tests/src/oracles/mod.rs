//! Exact answers.

pub mod form_factors;
pub mod lobes;
pub mod polygon;
#[cfg(test)]
mod quadrature;
pub mod skies;
pub mod solid_angle;
