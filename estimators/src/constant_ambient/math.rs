//! What uniform radiance from everywhere does at a point.

use interreflect_cpu::lane::Lane;
use std::f64::consts::PI;

/// Irradiance under uniform radiance: E = πL.
#[inline(always)]
pub fn ambient_irradiance<L: Lane>(radiance: L) -> L {
    radiance * L::splat(PI)
}

/// Radiance reflected under uniform radiance: (k_d + k_s)·L.
///
/// Deviation: takes the lobe's albedo to be k_s at every angle; it falls off towards grazing ones.
#[inline(always)]
pub fn ambient_reflection<L: Lane>(diffuse: L, specular: L, radiance: L) -> L {
    (diffuse + specular) * radiance
}
