//! Runs methods on scenes and fills records: timing, references, campaigns and the papers' experiments.
//!
//! It knows the domain alone: requests come as plain values, warnings and progress go back as such.

pub mod campaign;
pub mod clock;
pub mod context;
pub mod error;
pub mod frames;
pub mod measure;
pub mod memory;
pub mod on_backend;
pub mod reproduce;
mod run_record;
pub mod settings;
pub mod truth;
pub mod view;
pub mod warning;
