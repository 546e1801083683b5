//! The specular lobes among the shaded points.

use crate::backend::Backend;
use crate::error::{EstimatorError, Unsupported};
use crate::frame::{Changed, Inputs};
use crate::quantity::Quantity;
use glam::Vec3;

/// Lobes that tables or filtered maps are kept for.
pub const MAX_LOBES: usize = 8;

/// What `of` makes of the Blinn–Phong exponents of points with a specular lobe, each once, ascending;
/// none for quantities without one. `kept` are those of the session's last `prepare`: a list
/// that is not empty holds until the points change.
///
/// # Errors
/// [`Unsupported`] for more than [`MAX_LOBES`].
pub fn lobes<B: Backend>(
    inputs: &Inputs<'_, B>,
    kept: Option<Vec<f32>>,
    of: fn(f32) -> f32,
) -> Result<Vec<f32>, EstimatorError> {
    if inputs.quantity != Quantity::GlossyRadiance {
        return Ok(Vec::new());
    }
    // An empty list may be that of another quantity.
    let holds = |kept: &Vec<f32>| !(kept.is_empty() || inputs.changed.any(Changed::POINTS));
    if let Some(kept) = kept.filter(holds) {
        return Ok(kept);
    }
    let mut exponents: Vec<f32> = Vec::new();
    let shining = inputs.host_points.iter().flatten();
    for point in shining.filter(|p| p.material.specular != Vec3::ZERO) {
        let exponent = of(point.material.shininess);
        if let Err(place) = exponents.binary_search_by(|e| e.total_cmp(&exponent)) {
            exponents.insert(place, exponent);
        }
        if exponents.len() > MAX_LOBES {
            return Err(Unsupported(format!(
                "one table or map is kept for each shininess, at most {MAX_LOBES}; the points have \
                 more: use fewer materials"
            ))
            .into());
        }
    }
    Ok(exponents)
}
