//! Captures of the scene from the host's point of view: what estimators start from.

pub mod cube;
pub mod directional_depth;
pub mod rsm;
