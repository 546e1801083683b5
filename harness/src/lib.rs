//! Measures real-time indirect-illumination estimators: bench, render, probe, reference, compare.

pub mod cli;
mod format;
pub mod machine;
pub mod metrics;
pub mod output;
pub mod record;
pub mod report;
pub mod table;
