//! What two colours of light do at a point.

use interreflect::prelude::*;
use std::f64::consts::PI;

/// Irradiance at a normal whose component along +y is `up`: π times the radiance from below and from
/// above, blended linearly in `up`.
#[inline(always)]
pub(super) fn blended_irradiance<L: Lane>(below: L, above: L, up: L) -> L {
    let half = L::splat(0.5);
    L::splat(PI) * (below + (above - below) * (half + half * up))
}
