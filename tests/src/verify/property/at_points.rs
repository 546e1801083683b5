//! Rules of a method's own.

use super::{Property, Slack, Worst};
use crate::verify::{MethodUnderTest, VerifyError, World};
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
fn violation(subject: &MethodUnderTest<'_>, world: &World) -> Result<Worst, VerifyError> {
    let quantity = subject.quantity;
    let (scene, points) = (world.scene(), world.placed_points(quantity));
    let estimate = subject.estimate(world)?;
    let greatest = world.greatest(quantity);
    let mut worst = Worst::default();
    for claim in subject.claims() {
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
