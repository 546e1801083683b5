//! What is estimated.

use interreflect_scene::PointLayout;
use interreflect_scene::params::Choice;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The quantity that an estimate holds at each point.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize, JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Irradiance in W/m² from surfaces and environment, before the receiver's albedo.
    Irradiance,
    /// Radiance in W·m⁻²·sr⁻¹ that the point's own material reflects to the viewer, of what
    /// arrives from surfaces and environment.
    GlossyRadiance,
    /// Cosine-weighted open fraction of the hemisphere: 1 where nothing occludes.
    AmbientOcclusion,
}

impl Choice for Quantity {}

impl Quantity {
    /// Its name on the command line and in records.
    pub fn name(self) -> &'static str {
        Choice::name(self)
    }

    /// The planes that its points must carry.
    pub fn layout(self) -> PointLayout {
        match self {
            Self::Irradiance | Self::AmbientOcclusion => PointLayout::Surface,
            Self::GlossyRadiance => PointLayout::Material,
        }
    }
}
