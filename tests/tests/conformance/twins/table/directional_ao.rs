use super::*;
use interreflect_estimators::directional_ao::math as ao;

pub(super) const TWINS: &[Twin] = &[
    twin!(
        "directional_ao",
        "passes",
        "outputs[id.x] = vec4f(passes(a[0], a[1], a[2]), 0.0, 0.0, 0.0);",
        over_lanes!(|a| vec![ao::passes(a[0], a[1], a[2])]),
        depths,
        Tolerance {
            absolute: 0.0,
            relative: 0.0,
            cause: "a comparison: no input lies within rounding of its threshold",
        }
    ),
    twin!(
        "directional_ao",
        "open_cosine",
        "outputs[id.x] = vec4f(open_cosine(a[0], a[1]), 0.0, 0.0, 0.0);",
        over_lanes!(|a| vec![ao::open_cosine(a[0], a[1])]),
        || grid(&[&SIGNED, &[0.0, 1.0]]),
        ulps(1, 1.0, "a product with 0 or 1")
    ),
];

/// Depths before, at and behind the map's, without and with a margin.
fn depths() -> Vec<Input> {
    let offsets = [-0.3, -1e-5, 0.0, 2e-7, 1e-6, 1e-3, 0.2];
    let mut inputs = grid(&[&offsets, &[0.31, 0.5, 1.0], &[0.0, 1.0 / 512.0]]);
    for a in &mut inputs {
        a[0] += a[1];
    }
    inputs
}
