use super::*;
use interreflect_estimators::localized_cubemap::math as localized;

pub(super) const TWINS: &[Twin] = &[
    twin!(
        "localized_cubemap",
        "omega_published",
        "outputs[id.x] = vec4f(omega_published(a[0], a[1]), 0.0, 0.0, 0.0);",
        over_lanes!(|a| vec![localized::omega_published(a[0], a[1])]),
        || grid(&[
            &[1e-7, 1e-4, 0.01, 0.3, 0.9, 1.8],
            &[0.0, 1e-30, 1e-12, 1e-3, 0.5, 1.0, 4.0, 1e4, 1e12]
        ]),
        ulps(
            8,
            0.0,
            "a division, sums of positive numbers, and 1 − Δω/π ≥ 0.4"
        )
    ),
    twin!(
        "localized_cubemap",
        "omega_corrected",
        "outputs[id.x] = vec4f(omega_corrected(a[0], a[1], a[2]), 0.0, 0.0, 0.0);",
        over_lanes!(|a| vec![localized::omega_corrected(a[0], a[1], a[2])]),
        || grid(&[
            &[1e-7, 1e-4, 0.3, 3.0],
            &[0.0, 1e-30, 1e-12, 1e-3, 1.0, 1e4, 1e12],
            &[-1.0, -1e-6, 0.0, 1e-6, 1e-3, 0.5, 1.0]
        ]),
        ulps(6, 0.0, "a division, products and a sum of positive numbers")
    ),
    twin!(
        "localized_cubemap",
        "reflectivity_published",
        "let r = reflectivity_published(a[0], a[1], a[2], a[3]);\n\
         outputs[id.x] = vec4f(r.diffuse, r.specular, 0.0, 0.0);",
        over_lanes!(|a| {
            let (d, s) = localized::reflectivity_published(a[0], a[1], a[2], a[3]);
            vec![d, s]
        }),
        || grid(&[&SIGNED, &SIGNED, &SIGNED, &[0.0, 1.0, 5.0, 100.0]]),
        LOBE
    ),
    twin!(
        "localized_cubemap",
        "table_place",
        "let p = table_place(a[0], a[1]);\n\
         outputs[id.x] = vec4f(p.first, p.second, 0.0, 0.0);",
        over_lanes!(|a| {
            let (first, second) = localized::table_place(a[0], a[1]);
            vec![first, second]
        }),
        || grid(&[
            &[-1.0, -0.5, 0.0, 0.7, 0.99, 1.0],
            &[0.0, 1e-4, 0.3, 3.0, 4.0]
        ]),
        ulps(
            12,
            0.0,
            "two square roots of a difference that is exact or above 1/200"
        )
    ),
];
