//! Estimators outside the registry, one that keeps its word and one that does not.

mod boastful;
mod hemisphere;

pub use boastful::Boastful;
pub use hemisphere::HemisphereAmbient;
