//! Uniform light, lobes, mirrors and Fresnel's factor.

use crate::{HEMISPHERE, integral, near, vector, within};
use glam::DVec3;
use interreflect_estimators::{classic_envmap, constant_ambient, reflection, texels};
use interreflect_scene::material::blinn_phong_normalisation;
use std::f64::consts::{FRAC_PI_3, FRAC_PI_6, PI};

#[test]
fn uniform_light_gives_pi_and_is_reflected_by_both_albedos() {
    use constant_ambient::math::{ambient_irradiance, ambient_reflection};
    let pi = integral(HEMISPHERE, |w| w.z);
    within(ambient_irradiance(1.0), pi, 1e-6);
    near(ambient_irradiance(2.0), 2.0 * PI);
    near(ambient_reflection(0.5, 0.25, 8.0), 6.0);
}

/// (N·H)ⁿ falls to a half where H is acos(2^(−1/n)) away, so light twice as far from the mirrored
/// direction; there cosᴺ has to be a half too. For large n, where angles are small, up to 1/n.
#[test]
fn the_phong_lobe_is_as_wide_as_the_blinn_phong_lobe() {
    for n in [100.0_f64, 400.0, 2000.0] {
        let exponent = classic_envmap::math::phong_exponent(n);
        let half_vector = 0.5_f64.powf(1.0 / n).acos();
        let there = (2.0 * half_vector).cos().powf(exponent);
        assert!((there - 0.5).abs() < 1.0 / n, "{n}: {there}");
    }
    near(classic_envmap::math::phong_exponent(6.0), 1.5);
}

/// A head-on beam is reflected whole: the lobe times both cosines over the hemisphere, where light and
/// normal are one and H is half-way to the viewer. The cosine of the viewer is the only one left.
#[test]
fn the_normalised_lobe_reflects_all_of_a_head_on_beam() {
    for n in [0.0_f64, 1.0, 5.0, 40.0, 250.0] {
        let lobe = integral(HEMISPHERE, |w| {
            let half = (DVec3::Z + w).normalize();
            half.z.powf(n) * w.z
        });
        within(texels::math::lobe_normalisation(n) * lobe, 1.0, 1e-4);
        within(blinn_phong_normalisation(n) * lobe, 1.0, 1e-4);
        let (diffuse, specular) = texels::math::normalised_reflectivity(0.5, 0.9, n, 1.0 / lobe);
        near(diffuse, 0.5 / PI);
        within(specular, 0.5 / lobe * 0.9_f64.powf(n), 1e-9);
    }
    // Light from behind is not reflected.
    let (diffuse, specular) = texels::math::normalised_reflectivity(-0.5, 0.9, 5.0, 1.0);
    assert_eq!((diffuse, specular), (0.0, 0.0));
}

#[test]
fn mirrored_directions_and_half_vectors_lie_on_the_right_side() {
    let n = vector(0.0, 1.0, 0.0);
    let mirrored = reflection::math::mirrored(n, vector(0.6, 0.8, 0.0));
    near(mirrored.x, -0.6);
    near(mirrored.y, 0.8);
    near(mirrored.z, 0.0);
    // Half-way between the normal and 60° from it: 30°.
    let i = vector(FRAC_PI_3.sin(), FRAC_PI_3.cos(), 0.0);
    near(texels::math::cos_half(n, i, n), FRAC_PI_6.cos());
    near(texels::math::cos_half(n, vector(0.0, -1.0, 0.0), n), 0.0);
}

/// The cosine-weighted mean of Schlick's factor is F₀ + (1 − F₀)/21; normal incidence gives F₀, and
/// grazing 1. A sixteenth of (1 − F₀)/2 at 60°.
#[test]
fn schlick_s_factor_has_its_mean_its_ends_and_its_middle() {
    use reflection::math::{fresnel_mix, schlick};
    for f0 in [0.0, 0.04, 0.5, 1.0] {
        let mean = integral(HEMISPHERE, |w| schlick(f0, w.z) * w.z) / PI;
        within(mean, f0 + (1.0 - f0) / 21.0, 1e-5);
        near(schlick(f0, 1.0), f0);
        near(schlick(f0, 0.0), 1.0);
        near(schlick(f0, -0.3), 1.0);
        near(schlick(f0, 0.5), f0 + (1.0 - f0) / 32.0);
    }
    // (1 − ¼)·½/π·4π + ¼·½·8.
    near(fresnel_mix(0.25, 0.5, 4.0 * PI, 0.5, 8.0), 1.5 + 1.0);
}
