//! A method run once, from captures to the estimate on the host.

use super::{Placed, Stage};
use crate::{Captures, Changed, Configured, EstimatorError, Inputs, Quantity};
use interreflect_scene::{Estimate, Points, Scene};

/// The captures that a method declares in a scene.
///
/// # Errors
/// [`EstimatorError`] if the method can't work there or the backend refuses.
pub fn captured<S: Stage>(
    stage: &S,
    scene: &Scene,
    method: &dyn Configured,
    quantity: Quantity,
) -> Result<Captures<S::Backend>, EstimatorError> {
    let needs = method.needs(quantity, &scene.facts())?;
    Ok(stage.capture(&needs)?.0)
}

/// A new session's estimate on these captures.
///
/// # Errors
/// [`EstimatorError`] as [`captured`].
pub fn estimated<S: Stage>(
    stage: &S,
    scene: &Scene,
    method: &dyn Configured,
    quantity: Quantity,
    captures: &Captures<S::Backend>,
    points: &Points,
) -> Result<Estimate, EstimatorError> {
    let facts = scene.facts();
    let needs = method.needs(quantity, &facts)?;
    let mut session = stage.open(method)?;
    let Placed {
        points: placed,
        mut out,
    } = stage.place(points)?;
    let origin = (facts, scene.capture_origin(needs.keep_within_m));
    let inputs = Inputs::new(&needs, captures, &placed, points, origin, Changed::ALL);
    stage.timed("prepare", &mut |cx| {
        session.prepare(cx, quantity, &inputs, &out)
    })?;
    stage.timed("shade", &mut |cx| {
        session.shade(cx, quantity, &inputs, &mut out)
    })?;
    Ok(stage.read_back(&out)?.0)
}
