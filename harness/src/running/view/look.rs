//! What a view may be asked for.

use interreflect_scene::params::Choice;
use interreflect_scene::{Role, Scene};
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

/// Which surfaces are shaded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Shade {
    /// Receivers; every surface in a scene that has none.
    #[default]
    Receivers,
    /// Every surface that the camera sees.
    All,
}

impl Choice for Shade {}

impl Shade {
    /// Whether an object of this role is shaded in a scene.
    pub(super) fn shows(self, scene: &Scene, role: Role) -> bool {
        let all = self == Self::All || scene.objects_of(Role::Receiver).next().is_none();
        all || role == Role::Receiver
    }
}

/// How a view is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Look {
    /// Where the estimator is asked.
    pub at: ShadedAt,
    /// What mirrors show.
    pub mirrors: Mirrors,
    /// Which surfaces are shaded.
    pub shade: Shade,
}

impl Default for Look {
    fn default() -> Self {
        Self {
            at: ShadedAt::Pixels,
            mirrors: Mirrors::Included,
            shade: Shade::default(),
        }
    }
}
