use super::*;
use interreflect_estimators::convolution::math as convolution;

pub(super) const TWINS: &[Twin] = &[
    twin!(
        "convolution",
        "cosine_weight",
        "outputs[id.x] = vec4f(cosine_weight(vec3f(a[0], a[1], a[2]), vec3f(a[3], a[4], a[5])), 0.0, 0.0, 0.0);",
        over_lanes!(|a| vec![convolution::cosine_weight(vector(a, 0), vector(a, 3))]),
        || spread(6, -1.0, 1.0),
        ulps(
            3,
            3.0,
            "a scalar product whose terms cancel, of magnitude 3 at most"
        )
    ),
    twin!(
        "convolution",
        "phong_weight",
        "outputs[id.x] = vec4f(phong_weight(a[0], a[1], a[2]), 0.0, 0.0, 0.0);",
        over_lanes!(|a| vec![convolution::phong_weight(a[0], a[1], a[2])]),
        || grid(&[
            &[-1.0, 0.0, 0.1, 0.5, 0.9],
            &[0.9, 0.99, 1.0],
            &[0.0, 1.0, 2.5, 12.5]
        ]),
        LOBE
    ),
    twin!(
        "convolution",
        "map_nodes",
        "outputs[id.x] = vec4f(f32(map_nodes(u32(a[0]))), 0.0, 0.0, 0.0);",
        in_f64!(|a| vec![convolution::map_nodes(a[0] as u32) as f64]),
        || grid(&[&[1.0, 2.0, 32.0, 256.0]]),
        ulps(0, 0.0, "whole numbers")
    ),
    twin!(
        "convolution",
        "map_taps",
        "let taps = map_taps(u32(a[0]), vec3f(a[1], a[2], a[3]));\n\
         outputs[id.x] = vec4f(f32(taps.base), f32(taps.side), taps.u, taps.v);",
        over_scalars!(map_taps),
        || {
            let mut inputs = spread(4, -1.0, 1.0);
            for (i, a) in inputs.iter_mut().enumerate() {
                a[0] = [1.0, 7.0, 32.0][i % 3];
            }
            inputs
        },
        ulps(
            4,
            32.0,
            "a division and a difference of numbers up to the cells along an edge"
        )
    ),
];

fn map_taps<S: Scalar>(a: &[S; ARGUMENTS]) -> Vec<S> {
    let taps = convolution::map_taps(a[0].whole() as u32, vector(a, 1));
    // The weights are products of u, v and their complements.
    let (u, v) = (taps[1].1 + taps[3].1, taps[2].1 + taps[3].1);
    let side = taps[2].0 - taps[0].0;
    vec![S::from(taps[0].0 as f32), S::from(side as f32), u, v]
}
