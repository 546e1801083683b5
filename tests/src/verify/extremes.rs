//! Estimates at the extremes of numbers: whether they are finite and inside their bound, and how far
//! they are from the same formula in float64.

mod axes;

use super::box_scene::Lighting;
use super::{MethodUnderTest, TestBackend, Verdict, VerifyError, claimed};
use crate::exchange::uploaded;
use axes::{Axis, Place};
use interreflect_cpu::tiles::Arithmetic;
use interreflect_estimators::execution::BackendScene;
use interreflect_estimators::{Claim, Configured, Quantity};
use interreflect_scene::{Estimate, Points, Scene};
use std::rc::Rc;

/// One method at one place of an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Extreme {
    /// What is taken to its extreme.
    pub axis: &'static str,
    /// The unit of its values.
    pub unit: &'static str,
    /// Where.
    pub value: f64,
    /// Largest difference from the same formula in float64 on the same captures, over the largest
    /// estimate; `None` where nothing ran or nothing arrives.
    pub relative_error: Option<f64>,
    /// The largest estimate, over what surroundings of the greatest radiance give.
    pub largest: Option<f64>,
    /// Passed if finite and inside the claimed bound, or refused with an error that names the input;
    /// not applicable if the axis has nothing to do with the method.
    pub verdict: Verdict,
    /// The error, or the bound.
    pub note: String,
}

/// Takes a method to every extreme.
pub fn extremes(under_test: &MethodUnderTest<'_>) -> Vec<Extreme> {
    let lighting = Lighting::of(under_test.model(), under_test.quantity);
    let mut all = Vec::new();
    for axis in axes::all() {
        for value in (axis.values)() {
            all.push(at(under_test, &axis, value, lighting));
        }
    }
    all
}

fn at(under_test: &MethodUnderTest<'_>, axis: &Axis, value: f64, lighting: Lighting) -> Extreme {
    let blank = Extreme {
        axis: axis.name,
        unit: axis.unit,
        value,
        relative_error: None,
        largest: None,
        verdict: Verdict::NotApplicable,
        note: String::new(),
    };
    let Some(place) = (axis.place)(under_test, lighting, value) else {
        return Extreme {
            note: "the axis does not touch it".into(),
            ..blank
        };
    };
    if let Err(refused) = place.scene.validate() {
        return Extreme {
            verdict: Verdict::Passed,
            note: format!("refused: {refused}"),
            ..blank
        };
    }
    match measured(under_test, &place) {
        Err(VerifyError::Unsupported(why)) => Extreme {
            note: why.to_string(),
            ..blank
        },
        // An error that names the input is an answer where the input is no number; else a failure.
        Err(error) => Extreme {
            verdict: match axis.refusable {
                true => Verdict::Passed,
                false => Verdict::Failed,
            },
            note: error.to_string(),
            ..blank
        },
        Ok(found) => judged(under_test, axis, found, blank),
    }
}

/// Largest estimate and relative error.
struct Measured {
    largest: f64,
    relative_error: Option<f64>,
}

fn judged(
    under_test: &MethodUnderTest<'_>,
    axis: &Axis,
    found: Measured,
    blank: Extreme,
) -> Extreme {
    let bound = claimed(under_test, |claim| match *claim {
        Claim::Bounded { by, .. } => Some(by),
        _ => None,
    });
    // What lies outside the claim's own domain has no bound: normals of other lengths.
    let bound = bound.filter(|_| axis.bounded);
    let inside = bound.is_none_or(|by| found.largest <= by * (1.0 + 1e-3) + 1e-3);
    Extreme {
        relative_error: found.relative_error,
        largest: Some(found.largest),
        verdict: match inside && !axis.refusable {
            true => Verdict::Passed,
            false => Verdict::Failed,
        },
        note: match (axis.refusable, bound) {
            (true, _) => "it was taken for a number".into(),
            (_, Some(by)) => format!("bound {by}"),
            _ => "no bound is claimed".into(),
        },
        ..blank
    }
}

fn measured(under_test: &MethodUnderTest<'_>, place: &Place) -> Result<Measured, VerifyError> {
    let Place {
        scene,
        points,
        method,
        greatest,
    } = place;
    let (backend, quantity) = (under_test.backend, under_test.quantity);
    // On its own captures: finite, or an error.
    let own = backend.estimate(scene, &**method, quantity, points)?;
    let (TestBackend::Cpu(cx) | TestBackend::Gpu(cx, _)) = backend;
    let float64 = cx.with_arithmetic(Arithmetic::Float64);
    let exact = TestBackend::Cpu(&float64).estimate(scene, &**method, quantity, points)?;
    let compared = match backend {
        TestBackend::Cpu(_) => Some(own.clone()),
        TestBackend::Gpu(..) => on_host_captures(backend, scene, &**method, quantity, points)?,
    };
    let largest = |e: &Estimate| {
        e.iter()
            .fold(0.0, |m: f64, v| m.max(v.max_element().into()))
    };
    let scale = largest(&exact);
    let apart = |compared: Estimate| {
        let pairs = exact.iter().zip(compared.iter());
        let apart = pairs.map(|(a, b)| f64::from((a - b).abs().max_element()));
        apart.fold(0.0, f64::max) / scale
    };
    Ok(Measured {
        largest: largest(&own) / greatest,
        relative_error: compared.filter(|_| scale > 0.0).map(apart),
    })
}

/// The device's estimate on the host's captures; `None` for methods whose depth maps can't be given.
fn on_host_captures(
    backend: TestBackend<'_>,
    scene: &Scene,
    method: &dyn Configured,
    quantity: Quantity,
    points: &Points,
) -> Result<Option<Estimate>, VerifyError> {
    let TestBackend::Gpu(_, context) = backend else {
        return Ok(None);
    };
    let loaded = backend.load(scene)?;
    let captures = loaded
        .cpu()
        .executor(method, quantity, points)?
        .captures()?;
    if !captures.depths.is_empty() {
        return Ok(None);
    }
    let mut on_device = loaded.gpu()?.executor(method, quantity, points)?;
    on_device.set_captures(Rc::new(uploaded(context, &captures)?));
    Ok(Some(on_device.estimate()?))
}
