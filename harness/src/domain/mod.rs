//! What was measured, and what follows from it: records, metrics, significance, statistics and analysis.
//!
//! The lowest layer of the harness: nothing in it runs a method, prints, or knows the command line.

pub mod analysis;
pub mod files;
pub mod format;
pub mod image;
pub mod machine;
pub mod metrics;
pub mod record;
pub mod significance;
pub mod statistics;
