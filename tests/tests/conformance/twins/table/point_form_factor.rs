use super::*;
use interreflect_estimators::point_form_factor::math as point;

pub(super) const TWINS: &[Twin] = &[twin!(
    "point_form_factor",
    "point_omega",
    "outputs[id.x] = vec4f(point_omega(a[0], a[1], a[2], a[3]), 0.0, 0.0, 0.0);",
    over_lanes!(|a| vec![point::point_omega(a[0], a[1], a[2], a[3])]),
    || grid(&[
        &[1e-4, 0.3, 3.0],
        &[0.0, 1e-12, 1e-3, 1.0, 1e4],
        &[-1.0, 0.0, 1e-6, 0.5, 1.0],
        &[0.5, 1e30]
    ]),
    ulps(4, 0.0, "a product and a division of positive numbers")
)];
