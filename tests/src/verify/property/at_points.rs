//! Rules of a method's own.

use super::{Property, Slack, Worst};
use crate::verify::{BoxScene, MethodUnderTest, VerifyError};
use interreflect_estimators::{Claim, PointEstimate};

pub(super) fn property() -> Property {
    Property {
        name: "at_points",
        about: "the method's own rules hold at every point",
        bound: |claim| match *claim {
            Claim::AtPoints { cause, .. } => Some((1.0, cause)),
            _ => None,
        },
        tried: None,
        slack: Slack::Rounding,
        out_of_place: |_, _| None,
        violation,
    }
}

/// The largest departure from any of the rules, over what each allows.
fn violation(under_test: &MethodUnderTest<'_>, box_scene: &BoxScene) -> Result<Worst, VerifyError> {
    let quantity = under_test.quantity;
    let (scene, points) = (box_scene.scene(), box_scene.placed_points(quantity));
    let estimate = under_test.estimate(box_scene)?;
    let greatest = box_scene.greatest(quantity);
    let mut worst = Worst::default();
    for claim in under_test.claims() {
        let Claim::AtPoints {
            departure, within, ..
        } = claim
        else {
            continue;
        };
        for (index, point) in points.iter().enumerate() {
            let Some(point) = point else { continue };
            let value = departure(&PointEstimate {
                scene: &scene,
                quantity,
                point,
                estimate: estimate.get(index),
                greatest,
            }) / within;
            if value > worst.value || value.is_nan() {
                worst = Worst {
                    value,
                    point: index,
                };
            }
        }
    }
    Ok(worst)
}
