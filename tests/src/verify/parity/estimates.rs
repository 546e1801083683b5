//! Estimates of both backends from the CPU's captures.

use super::{Apart, LOBE, MethodUnderTest, ROUNDING, VerifyError, shared, texels};
use crate::exchange::uploaded;
use interreflect_estimators::Tolerance;
use interreflect_estimators::execution::{BackendScene, LoadedScene};
use interreflect_gpu::GpuContext;
use interreflect_scene::Points;
use std::rc::Rc;
use std::sync::Arc;

/// Both backends sum in f32, in orders of their own and with or without fused operations, over at
/// most all captured texels. Rounding errors of N terms add up like a random walk: √N, four times
/// that for the worst of some thousand values. Their scale is the largest value, not the point's
/// own: where most texels are just below the horizon, what is left of the sum keeps their error.
pub fn float32(texels: f64, largest: f64) -> Tolerance {
    let walk = 4.0 * texels.sqrt() * ROUNDING;
    Tolerance {
        absolute: walk * largest,
        relative: LOBE + walk,
        cause: "float32 sums over the captured texels, and the power of the lobe",
    }
}

/// Compares a method's estimates in a scene, both of the CPU's captures: the largest difference over what
/// it may be.
///
/// # Errors
/// [`VerifyError`] if the method can't run there on both, or can't be given captures.
pub fn estimate_parity(
    under_test: &MethodUnderTest<'_>,
    context: &Arc<GpuContext>,
    loaded: &LoadedScene,
    points: &Points,
) -> Result<Apart, VerifyError> {
    let (method, quantity) = (under_test.method, under_test.quantity);
    let mut on_host = loaded.cpu().executor(method, quantity, points)?;
    let host = on_host.estimate()?;
    let captures = on_host.captures()?;
    shared(&captures)?;
    let mut on_device = loaded.gpu()?.executor(method, quantity, points)?;
    on_device.set_captures(Rc::new(uploaded(context, &captures)?));
    let device = on_device.estimate()?;
    let largest = host.iter().fold(0.0_f32, |m, v| m.max(v.max_element()));
    let tolerance = float32(texels(&captures), f64::from(largest));
    let mut worst = Apart {
        of_bound: 0.0,
        cases: points.len(),
        place: tolerance.cause.into(),
    };
    for (i, (a, b)) in host.iter().zip(device.iter()).enumerate() {
        for (a, b) in a.to_array().into_iter().zip(b.to_array()) {
            worst.keep_larger(tolerance.of_bound(f64::from(a), f64::from(b)), || {
                format!("point {i}: {a}, on the GPU {b} ({})", tolerance.cause)
            });
        }
    }
    Ok(worst)
}
