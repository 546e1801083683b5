//! What must not change an estimate.

use super::{Property, Slack, Worst};
use crate::verify::{BoxScene, Lighting, MethodUnderTest, Placement, VerifyError};
use glam::{Mat3, Vec3};
use interreflect_estimators::Claim;

pub(super) fn all() -> [Property; 5] {
    [
        Property {
            name: "scale_invariant",
            about: "the same in a scene of another size",
            bound: |claim| matches!(claim, Claim::ScaleInvariant).then_some((0.0, "")),
            tried: Some(0.0),
            slack: Slack::Edges,
            out_of_place: |_, _| None,
            violation: scale_invariant,
        },
        Property {
            name: "translation_invariant",
            about: "the same in a scene somewhere else",
            bound: |claim| matches!(claim, Claim::TranslationInvariant).then_some((0.0, "")),
            tried: Some(0.0),
            slack: Slack::Edges,
            out_of_place: |_, _| None,
            violation: translation_invariant,
        },
        Property {
            name: "cube_symmetric",
            about: "the same in a scene that is mirrored, or whose axes are swapped",
            bound: |claim| matches!(claim, Claim::CubeSymmetric).then_some((0.0, "")),
            tried: Some(0.0),
            slack: Slack::Edges,
            out_of_place: |_, _| None,
            violation: cube_symmetric,
        },
        Property {
            name: "position_invariant",
            about: "the same everywhere for one normal, viewer and material",
            bound: |claim| matches!(claim, Claim::PositionInvariant).then_some((0.0, "")),
            tried: Some(0.0),
            slack: Slack::Rounding,
            out_of_place: |_, _| None,
            violation: position_invariant,
        },
        Property {
            name: "distance_free",
            about: "at the reference point, distance does not matter",
            bound: |claim| matches!(claim, Claim::DistanceFree).then_some((0.0, "")),
            tried: Some(0.0),
            slack: Slack::Edges,
            out_of_place: |lighting, quantity| match (lighting, quantity) {
                (Lighting::Walls, _) => None,
                _ => Some(
                    "its light comes from elsewhere than what is seen from the reference point",
                ),
            },
            violation: distance_free,
        },
    ]
}

fn placed(
    under_test: &MethodUnderTest<'_>,
    box_scene: &BoxScene,
    placements: &[Placement],
) -> Result<Worst, VerifyError> {
    let first = under_test.estimate(box_scene)?;
    let mut worst = Worst::default();
    for &placement in placements {
        let there = under_test.estimate(&BoxScene {
            placement,
            ..box_scene.clone()
        })?;
        worst = worst.or(Worst::apart(
            &first,
            &there,
            box_scene.greatest(under_test.quantity),
        ));
    }
    Ok(worst)
}

fn scale_invariant(
    under_test: &MethodUnderTest<'_>,
    box_scene: &BoxScene,
) -> Result<Worst, VerifyError> {
    let scaled = |k: f32| Placement {
        linear: Mat3::from_diagonal(Vec3::splat(k)),
        shift: Vec3::ZERO,
    };
    placed(under_test, box_scene, &[scaled(0.037), scaled(29.0)])
}

fn translation_invariant(
    under_test: &MethodUnderTest<'_>,
    box_scene: &BoxScene,
) -> Result<Worst, VerifyError> {
    let shifted = Placement {
        linear: Mat3::IDENTITY,
        shift: Vec3::new(3.1, -2.3, 1.7),
    };
    placed(under_test, box_scene, &[shifted])
}

/// A mirror and a swap of axes: together they make all 48 symmetries.
fn cube_symmetric(
    under_test: &MethodUnderTest<'_>,
    box_scene: &BoxScene,
) -> Result<Worst, VerifyError> {
    let mirrored = Mat3::from_diagonal(Vec3::new(-1.0, 1.0, 1.0));
    let swapped = Mat3::from_cols(Vec3::Y, Vec3::X, Vec3::Z);
    let turned = Mat3::from_cols(Vec3::Y, Vec3::Z, Vec3::X);
    let placements = [mirrored, swapped, turned].map(|linear| Placement {
        linear,
        shift: Vec3::ZERO,
    });
    placed(under_test, box_scene, &placements)
}

/// All points moved to the place of the first.
fn position_invariant(
    under_test: &MethodUnderTest<'_>,
    box_scene: &BoxScene,
) -> Result<Worst, VerifyError> {
    let mut together = box_scene.clone();
    let place = together.points[0].position + Vec3::new(0.11, -0.07, 0.05);
    together.points.iter_mut().for_each(|p| p.position = place);
    let lists = [box_scene, &together].map(|w| w.placed_points(under_test.quantity));
    let estimates = under_test.estimates(&box_scene.scene(), &lists)?;
    let greatest = box_scene.greatest(under_test.quantity);
    Ok(Worst::apart(&estimates[0], &estimates[1], greatest))
}

/// Points at the reference point of a box, and of one whose walls stand at other distances along the
/// same rays.
fn distance_free(
    under_test: &MethodUnderTest<'_>,
    box_scene: &BoxScene,
) -> Result<Worst, VerifyError> {
    let mut near = box_scene.clone();
    for point in &mut near.points {
        point.position = box_scene.reference;
    }
    let far = BoxScene {
        reach: [1.0, 2.5, 0.6, 3.0, 1.4, 0.8],
        ..near.clone()
    };
    let (near, far) = (under_test.estimate(&near)?, under_test.estimate(&far)?);
    Ok(Worst::apart(
        &near,
        &far,
        box_scene.greatest(under_test.quantity),
    ))
}
