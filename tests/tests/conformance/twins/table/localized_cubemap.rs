use super::*;
use interreflect_estimators::localized_cubemap::math as localized;

pub(super) const TWINS: &[Twin] = &[
    twin!(
        "localized_cubemap",
        "texel_omega_text",
        "outputs[id.x] = vec4f(texel_omega_text(a[0], a[1]), 0.0, 0.0, 0.0);",
        in_f64!(|a| vec![localized::texel_omega_text(a[0], a[1])]),
        || grid(&[&[1.0, 2.0, 4.0, 8.0, 64.0], &[1.0, 1.1, 1.3, 1.7]]),
        ulps(8, 0.0, "two divisions and products of positive numbers")
    ),
    twin!(
        "localized_cubemap",
        "texel_omega_shader",
        "outputs[id.x] = vec4f(texel_omega_shader(a[0], a[1]), 0.0, 0.0, 0.0);",
        in_f64!(|a| vec![localized::texel_omega_shader(a[0], a[1])]),
        || grid(&[&[1.0, 2.0, 4.0, 8.0, 64.0], &[1.0, 1.1, 1.3, 1.7]]),
        ulps(8, 0.0, "two divisions and products of positive numbers")
    ),
    twin!(
        "localized_cubemap",
        "omega_published",
        "outputs[id.x] = vec4f(omega_published(a[0], a[1]), 0.0, 0.0, 0.0);",
        over_lanes!(|a| vec![localized::omega_published(a[0], a[1])]),
        || grid(&[
            &[1e-4, 0.01, 0.3, 0.9, 1.8],
            &[0.0, 1e-12, 1e-3, 0.5, 1.0, 4.0, 1e4]
        ]),
        ulps(
            8,
            0.0,
            "a division, sums of positive numbers, and 1 − Δω/π ≥ 0.4"
        )
    ),
    twin!(
        "localized_cubemap",
        "disc_area",
        "outputs[id.x] = vec4f(disc_area(a[0], a[1]), 0.0, 0.0, 0.0);",
        in_f64!(|a| vec![localized::disc_area(a[0], a[1])]),
        || grid(&[&[1e-4, 0.01, 0.3, 0.9, 1.8], &[1e-6, 0.01, 0.5, 1.0]]),
        ulps(8, 0.0, "a division, products, and 1 − Δω/π ≥ 0.4")
    ),
    twin!(
        "localized_cubemap",
        "omega_corrected",
        "outputs[id.x] = vec4f(omega_corrected(a[0], a[1], a[2]), 0.0, 0.0, 0.0);",
        over_lanes!(|a| vec![localized::omega_corrected(a[0], a[1], a[2])]),
        || grid(&[
            &[1e-4, 0.3, 3.0],
            &[1e-12, 1e-3, 1.0, 1e4],
            &[-1.0, 0.0, 1e-6, 0.5, 1.0]
        ]),
        ulps(6, 0.0, "a division, products and a sum of positive numbers")
    ),
    twin!(
        "localized_cubemap",
        "towards_texel",
        "let t = towards_texel(vec3f(a[0], a[1], a[2]), a[3], vec3f(a[4], a[5], a[6]));\n\
         outputs[id.x] = vec4f(t.i, t.r2);",
        over_lanes!(|a| {
            let (i, r2) = localized::towards_texel(vector(a, 0), a[3], vector(a, 4));
            vec![i.x, i.y, i.z, r2]
        }),
        towards,
        ulps(
            40,
            1.0,
            "a difference of unit size, divided by its length of 1/10 at least"
        )
    ),
    twin!(
        "localized_cubemap",
        "cos_half",
        "outputs[id.x] = vec4f(cos_half(vec3f(a[0], a[1], a[2]), vec3f(a[3], a[4], a[5]), vec3f(a[6], a[7], a[8])), 0.0, 0.0, 0.0);",
        over_lanes!(|a| vec![localized::cos_half(
            vector(a, 0),
            vector(a, 3),
            vector(a, 6)
        )]),
        || spread(9, -1.0, 1.0)
            .into_iter()
            .filter(|a| { (0..3).map(|i| (a[3 + i] + a[6 + i]).powi(2)).sum::<f32>() > 0.01 })
            .collect(),
        ulps(
            40,
            2.0,
            "a sum of terms that cancel, divided by its length of 1/10 at least"
        )
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
        "reflectivity_corrected",
        "let r = reflectivity_corrected(a[0], a[1], a[2], a[3]);\n\
         outputs[id.x] = vec4f(r.diffuse, r.specular, 0.0, 0.0);",
        over_lanes!(|a| {
            let (d, s) = localized::reflectivity_corrected(a[0], a[1], a[2], a[3]);
            vec![d, s]
        }),
        || grid(&[&SIGNED, &SIGNED, &[0.0, 1.0, 5.0, 100.0], &[0.3, 4.0]]),
        Tolerance {
            absolute: 4e-6,
            ..LOBE
        }
    ),
    twin!(
        "localized_cubemap",
        "lobe_normalisation",
        "outputs[id.x] = vec4f(lobe_normalisation(a[0]), 0.0, 0.0, 0.0);",
        over_lanes!(|a| vec![localized::lobe_normalisation(a[0])]),
        || grid(&[&[0.0, 0.25, 1.0, 5.0, 30.0, 100.0, 1e3, 1e5]]),
        LOBE
    ),
];

const SIGNED: [f32; 6] = [-1.0, -1e-3, 0.0, 1e-3, 0.5, 1.0];

/// Texels at distances 1 to infinity in all directions, points within 0.9 of the reference point;
/// and a point at the very place of a texel.
fn towards() -> Vec<Input> {
    let mut inputs = spread(7, -1.0, 1.0);
    for a in &mut inputs {
        let length = (0..3).map(|i| a[i] * a[i]).sum::<f32>().sqrt().max(1e-3);
        for i in 0..3 {
            a[i] /= length;
            a[4 + i] *= 0.5;
        }
        a[3] = a[3].max(0.0);
    }
    let mut at_texel = [0.0; ARGUMENTS];
    (at_texel[0], at_texel[3], at_texel[4]) = (1.0, 0.5, 2.0);
    inputs.push(at_texel);
    inputs
}
