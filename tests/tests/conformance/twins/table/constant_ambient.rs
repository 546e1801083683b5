use super::*;
use interreflect_estimators::constant_ambient::math as ambient;

pub(super) const TWINS: &[Twin] = &[
    twin!(
        "constant_ambient",
        "ambient_irradiance",
        "outputs[id.x] = vec4f(ambient_irradiance(vec3f(a[0], a[1], a[2])), 0.0);",
        over_lanes!(|a| (0..3).map(|i| ambient::ambient_irradiance(a[i])).collect()),
        || spread(3, 0.0, 50.0),
        ulps(2, 0.0, "one product and the rounding of π")
    ),
    twin!(
        "constant_ambient",
        "ambient_reflection",
        "outputs[id.x] = vec4f(ambient_reflection(vec3f(a[0], a[1], a[2]), vec3f(a[3], a[4], a[5]), vec3f(a[6], a[7], a[8])), 0.0);",
        over_lanes!(|a| (0..3)
            .map(|i| ambient::ambient_reflection(a[i], a[i + 3], a[i + 6]))
            .collect()),
        || spread(9, 0.0, 1.0),
        ulps(2, 0.0, "a sum of positive numbers and a product")
    ),
];
