//! Estimators outside the registry: one on both backends, one with a rule and a reference model of its
//! own, and one whose claims are false.

mod boastful;
mod box_projected;
mod hemisphere_ambient;

pub use boastful::Boastful;
pub use box_projected::BoxProjected;
pub use hemisphere_ambient::HemisphereAmbient;
