use super::*;
use interreflect_estimators::classic_envmap::math as classic;

pub(super) const TWINS: &[Twin] = &[twin!(
    "classic_envmap",
    "phong_exponent",
    "outputs[id.x] = vec4f(phong_exponent(a[0]), 0.0, 0.0, 0.0);",
    over_lanes!(|a| vec![classic::phong_exponent(a[0])]),
    || spread(1, 0.0, 1e5),
    ulps(1, 0.0, "one product")
)];
