//! Oracles, invariants and parity checks that every estimator faces.
//!
//! [`oracles`] are exact formulas, [`own_model`] evaluates what a method claims to compute by a
//! deterministic integral, [`statistics`] says whether path-traced estimates agree, and [`verify`] has
//! every check.

pub mod exchange;
pub mod oracles;
pub mod own_model;
pub mod statistics;
pub mod verify;
