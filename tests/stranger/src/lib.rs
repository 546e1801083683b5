//! Estimators outside the registry: one whose claims are true, on both backends, and one whose claims are
//! false.

mod boastful;
mod hemisphere_ambient;

pub use boastful::Boastful;
pub use hemisphere_ambient::HemisphereAmbient;
