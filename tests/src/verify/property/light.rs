//! What more, less or other light must do.

use super::{Property, Slack, Worst, apart};
use crate::verify::{BoxScene, Lighting, MethodUnderTest, VerifyError};
use glam::Vec3;
use interreflect_estimators::{Claim, Quantity};
use interreflect_scene::conventions::cube_frame;

pub(super) fn all() -> [Property; 5] {
    [
        Property {
            name: "non_negative",
            about: "no estimate is negative where radiance is not",
            bound: |claim| matches!(claim, Claim::NonNegative).then_some((0.0, "")),
            tried: Some(0.0),
            slack: Slack::Rounding,
            out_of_place: |_, _| None,
            violation: non_negative,
        },
        Property {
            name: "bounded",
            about: "no estimate exceeds that of uniform surroundings of the greatest radiance",
            bound: |claim| match *claim {
                Claim::Bounded { by, cause } => Some((by, cause)),
                _ => None,
            },
            tried: Some(1.0),
            slack: Slack::Rounding,
            out_of_place: |_, _| None,
            violation: bounded,
        },
        Property {
            name: "linear",
            about: "the estimate of a sum of lights is the sum of the estimates",
            bound: |claim| matches!(claim, Claim::Linear).then_some((0.0, "")),
            tried: Some(0.0),
            slack: Slack::Rounding,
            out_of_place: |_, quantity| no_light(quantity),
            violation: linear,
        },
        Property {
            name: "dark_from_behind",
            about: "light from behind the surface contributes nothing",
            bound: |claim| matches!(claim, Claim::DarkFromBehind).then_some((0.0, "")),
            tried: Some(0.0),
            slack: Slack::Edges,
            out_of_place: |lighting, quantity| match lighting {
                Lighting::Sky => Some("a sky is never behind only"),
                _ => no_light(quantity),
            },
            violation: dark_from_behind,
        },
        Property {
            name: "monotone_in_occluders",
            about: "no estimate rises where an occluder is added",
            bound: |claim| matches!(claim, Claim::MonotoneInOccluders).then_some((0.0, "")),
            tried: Some(0.0),
            slack: Slack::Rounding,
            out_of_place: |lighting, _| match lighting {
                Lighting::Sky => None,
                _ => Some("its model takes light from the walls, not past them"),
            },
            violation: monotone_in_occluders,
        },
    ]
}

fn no_light(quantity: Quantity) -> Option<&'static str> {
    (quantity == Quantity::AmbientOcclusion).then_some("openness does not depend on light")
}

fn non_negative(
    under_test: &MethodUnderTest<'_>,
    box_scene: &BoxScene,
) -> Result<Worst, VerifyError> {
    let estimate = under_test.estimate(box_scene)?;
    let below = estimate.iter().map(|v| f64::from(-v.min_element()));
    Ok(Worst::of(below, box_scene.greatest(under_test.quantity)))
}

fn bounded(under_test: &MethodUnderTest<'_>, box_scene: &BoxScene) -> Result<Worst, VerifyError> {
    let estimate = under_test.estimate(box_scene)?;
    let values = estimate.iter().map(|v| f64::from(v.max_element()));
    Ok(Worst::of(values, box_scene.greatest(under_test.quantity)))
}

/// Half of one light and half of another, against the mean of their estimates.
fn linear(under_test: &MethodUnderTest<'_>, box_scene: &BoxScene) -> Result<Worst, VerifyError> {
    let mut other = box_scene.clone();
    match box_scene.lighting {
        Lighting::Sky => {
            other.sky = Vec3::new(-box_scene.sky.y, box_scene.sky.z, 0.5 * box_scene.sky.x)
        }
        _ => other.walls.rotate_left(1),
    }
    let mut both = box_scene.clone();
    both.sky = 0.5 * (box_scene.sky + other.sky);
    if box_scene.lighting != Lighting::Sky {
        let pairs = box_scene.walls.iter().zip(other.walls);
        let mut pairs = pairs.map(|(a, b)| 0.5 * (*a + b));
        both.walls = std::array::from_fn(|_| pairs.next().unwrap_or_default());
    }
    let [first, second, sum] = [box_scene, &other, &both].map(|w| under_test.estimate(w));
    let (first, second, sum) = (first?, second?, sum?);
    let parts = first.iter().zip(second.iter());
    let residual = parts.zip(sum.iter());
    let residual = residual.map(|((a, b), sum)| apart(0.5 * (a + b), sum));
    let greatest = [box_scene, &other].map(|w| w.greatest(under_test.quantity));
    Ok(Worst::of(residual, greatest[0].max(greatest[1])))
}

/// Each wall alone, seen by points that face away from it.
fn dark_from_behind(
    under_test: &MethodUnderTest<'_>,
    box_scene: &BoxScene,
) -> Result<Worst, VerifyError> {
    let mut worst = Worst::default();
    for face in 0..box_scene.walls.len() {
        let mut alone = box_scene.clone();
        for (i, wall) in alone.walls.iter_mut().enumerate() {
            *wall = Vec3::splat(f32::from(u8::from(i == face)));
        }
        let (axis, beside, _) = cube_frame(face);
        for point in &mut alone.points {
            point.normal = -axis.as_vec3();
            point.view = (point.normal + 0.3 * beside.as_vec3()).normalize();
        }
        worst = worst.or(bounded(under_test, &alone)?);
    }
    Ok(worst)
}

/// Half of the walls, then all.
fn monotone_in_occluders(
    under_test: &MethodUnderTest<'_>,
    box_scene: &BoxScene,
) -> Result<Worst, VerifyError> {
    let all = BoxScene {
        specks: true,
        ..box_scene.clone()
    };
    let mut fewer = all.clone();
    for wall in fewer.walls.iter_mut().step_by(2) {
        *wall = Vec3::ZERO;
    }
    let (fewer, all) = (under_test.estimate(&fewer)?, under_test.estimate(&all)?);
    let risen = fewer.iter().zip(all.iter());
    let risen = risen.map(|(fewer, all)| f64::from((all - fewer).max_element()));
    Ok(Worst::of(risen, box_scene.greatest(under_test.quantity)))
}
