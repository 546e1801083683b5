//! What a view may be asked for.

use interreflect_scene::params::Choice;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Where an estimator is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ShadedAt {
    /// At the surface that each pixel sees.
    Pixels,
    /// At the vertices of all that is shaded; pixels interpolate.
    Vertices,
}

impl Choice for ShadedAt {}

/// What a mirror shows of indirect light (P3, Figure 8).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Mirrors {
    /// None: direct light alone.
    Direct,
    /// Direct light, and on it what the mirror's own surface would reflect if it were diffuse, of its
    /// reflectance for an albedo: a trick, which costs no reflected point.
    Diffuse,
    /// What the surfaces that it shows reflect.
    Included,
}

impl Choice for Mirrors {}

/// How a view is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Look {
    /// Where the estimator is asked.
    pub at: ShadedAt,
    /// What mirrors show.
    pub mirrors: Mirrors,
}

impl Default for Look {
    fn default() -> Self {
        Self {
            at: ShadedAt::Pixels,
            mirrors: Mirrors::Included,
        }
    }
}
