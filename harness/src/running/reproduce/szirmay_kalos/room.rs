//! The room of the paper's figures, and the methods that are shown in it.

use super::super::experiment_context::ExperimentContext;
use crate::running::error::RunError;
use glam::Vec3;
use interreflect_estimators::{Configured, OwnModel, Quantity};
use interreflect_scene::LightPaths;
use serde::Serialize;

/// Settings of `colored-room`.
pub(super) type Settings = &'static [(&'static str, &'static str)];

/// Reflections that captures hold, so that what is left out is not in the comparison.
pub(super) const BOUNCES: u32 = 4;

/// All light but what the model keeps from itself: in no map is there any of the model, and one that is too dark must
/// not gain by its missing shadows.
pub(super) const UNSHADOWED: OwnModel = OwnModel::LightTransport(LightPaths {
    self_shadowing: false,
    ..LightPaths::ALL
});

/// How a model reflects.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Reflection {
    /// Irradiance, whatever the albedo.
    Diffuse,
    /// Its Blinn–Phong lobe, alone.
    Specular,
}

impl Reflection {
    /// What is estimated.
    pub(super) fn quantity(self) -> Quantity {
        match self {
            Self::Diffuse => Quantity::Irradiance,
            Self::Specular => Quantity::GlossyRadiance,
        }
    }
}

/// A diffuse model in the figures' room.
pub(super) const DIFFUSE: Settings = &[
    ("ceiling", "green"),
    ("divider", "0.9"),
    ("block", "false"),
    ("reference.place", "room"),
    ("reference.offset", "0"),
    ("receiver.size", "0.7"),
    ("receiver.diffuse", "0.8"),
    ("receiver.specular", "0"),
];

/// A specular model there.
pub(super) const SPECULAR: Settings = &[
    ("ceiling", "green"),
    ("divider", "0.9"),
    ("block", "false"),
    ("reference.place", "room"),
    ("reference.offset", "0"),
    ("receiver.size", "0.7"),
    ("receiver.diffuse", "0"),
    ("receiver.specular", "0.8"),
    ("receiver.shininess", "5"),
];

/// Classic mapping of a capture.
pub(super) fn classic(
    context: &ExperimentContext<'_>,
    capture: u32,
) -> Result<Box<dyn Configured>, RunError> {
    let parameters: [(&str, &dyn ToString); 2] =
        [("bounces", &BOUNCES), ("capture_resolution", &capture)];
    context.method("classic_envmap", &parameters)
}

/// The published map of M² texels a face, by the text's solid angle (l³) or the listing's (l²), `shader`.
pub(super) fn localized(
    context: &ExperimentContext<'_>,
    (m, capture): (u32, u32),
    weights: &str,
    others: &[(&str, &dyn ToString)],
) -> Result<Box<dyn Configured>, RunError> {
    let mut parameters: Vec<(&str, &dyn ToString)> = vec![
        ("resolution", &m),
        ("capture_resolution", &capture),
        ("bounces", &BOUNCES),
        ("solid_angle", &weights),
    ];
    parameters.extend(others);
    context.method("localized_cubemap", &parameters)
}

/// Towards the faces, edges and corners of a cube.
pub(super) fn directions() -> Vec<Vec3> {
    let axis = [-1.0, 0.0, 1.0];
    let all = axis
        .into_iter()
        .flat_map(|x| axis.into_iter().map(move |y| (x, y)))
        .flat_map(|(x, y)| axis.into_iter().map(move |z| Vec3::new(x, y, z)));
    all.filter(|d| *d != Vec3::ZERO)
        .map(Vec3::normalize)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_those_of_a_cube() {
        let all = directions();
        assert_eq!(all.len(), 26);
        assert!(all.iter().all(|d| (d.length() - 1.0).abs() < 1e-6));
    }
}
