//! Irradiance by nine spherical harmonics.

use super::{Feed, centre, environment, mirrors, sphere, under};
use crate::ensure;
use crate::variants::Outcome;
use glam::{DVec3, Vec3};
use interreflect_estimators::Quantity;
use interreflect_estimators::Tolerance;
use interreflect_scene::CubeImage;
use interreflect_scene::conventions::{texel_index, texel_solid_angle_sr};
use libtest_mimic::Failed;
use std::f64::consts::{FRAC_PI_2, PI};

/// Irradiance under an environment at points with these normals.
fn irradiance<S: Feed>(
    loaded: &S,
    image: &CubeImage,
    settings: &[(&str, &str)],
    normals: &[DVec3],
) -> Result<Vec<f64>, Failed> {
    let points = mirrors(normals.iter().copied());
    let method = ("sh_mip_envmap", settings);
    let estimate = under(loaded, image, method, Quantity::Irradiance, &points)?;
    Ok(estimate.iter().map(|v| f64::from(v.x)).collect())
}

pub(super) fn constant_environment_gives_pi<S: Feed>(loaded: &S) -> Outcome {
    let image = environment(64, |_| Vec3::ONE);
    let normals: Vec<DVec3> = sphere(200).collect();
    let rounding = Tolerance {
        absolute: 1e-5,
        relative: 0.0,
        cause: "weights rounded to float32: 384 texels cancel in the bands 1 and 2",
    };
    for fidelity in ["published", "corrected"] {
        let settings = [("fidelity", fidelity)];
        for value in irradiance(loaded, &image, &settings, &normals)? {
            rounding
                .check(value, PI)
                .map_err(|e| format!("{fidelity}: {e}"))?;
        }
    }
    Ok(())
}

/// E = π/2·(1 + c) under a sky of radiance 1 above y = 0: Y at the texels' centres errs by what a
/// midpoint rule does, a quarter for half the width; the integrals over texels are exact here.
pub(super) fn hemispherical_sky_falls_with_the_texels<S: Feed>(loaded: &S) -> Outcome {
    let image = environment(64, |d| Vec3::splat(if d.y > 0.0 { 1.0 } else { 0.0 }));
    let normals: Vec<DVec3> = sphere(400).chain([DVec3::Y, DVec3::NEG_Y]).collect();
    let error = |fidelity, size| -> Result<f64, Failed> {
        let settings = [("fidelity", fidelity), ("sh_resolution", size)];
        let values = irradiance(loaded, &image, &settings, &normals)?;
        let errors = values.iter().zip(&normals);
        Ok(errors
            .map(|(e, n)| (e - FRAC_PI_2 * (1.0 + n.y)).abs())
            .fold(0.0, f64::max))
    };
    let published = [
        error("published", "8")?,
        error("published", "16")?,
        error("published", "32")?,
    ];
    println!("published at 8, 16, 32: {published:?}");
    ensure!(
        (1e-3 * PI..3e-3 * PI).contains(&published[0]),
        "published errs by {} at 8²",
        published[0]
    );
    for pair in published.windows(2) {
        let ratio = pair[0] / pair[1];
        ensure!(
            (3.8..4.2).contains(&ratio),
            "half the width divides the error by {ratio}"
        );
    }
    let corrected = error("corrected", "8")?;
    println!("corrected at 8: {corrected:e}");
    // Float32 weights, and a rule that errs by 1e-7.
    ensure!(corrected < 3e-6, "corrected errs by {corrected:e}");
    Ok(())
}

/// Normals at cosines of −1 to 1 to a direction, the lowest value's among them.
fn turned_from(light: DVec3) -> Vec<(f64, DVec3)> {
    let across = light.any_orthonormal_vector();
    let cosines = (0..=40).map(|i| f64::from(i) / 20.0 - 1.0);
    cosines
        .chain([-8.0 / 15.0])
        .map(|c| (c, light * c + across * (1.0 - c * c).sqrt()))
        .collect()
}

/// One bright texel of 64², 1/30 rad wide, so that what its width smears is (1/30)²/24 in the band
/// 1 and three times that in the band 2: E/E₀ = ¼ + ½c + 5/32(3c² − 1), its minimum −19/480 at
/// c = −8/15. The window leaves 1, 3/4 and 1/4 of the bands.
pub(super) fn delta_light_shows_the_bands<S: Feed>(loaded: &S) -> Outcome {
    let bands = |c: f64, [b0, b1, b2]: [f64; 3]| {
        b0 * 0.25 + b1 * 0.5 * c + b2 * 5.0 / 32.0 * (3.0 * c * c - 1.0)
    };
    for texel in [(0, 31, 31), (2, 5, 60), (5, 63, 0)] {
        let mut image = environment(64, |_| Vec3::ZERO);
        let (face, column, row) = texel;
        let omega_sr = texel_solid_angle_sr(64, column, row);
        image.radiance[texel_index(64, face, column, row)] = Vec3::splat((1.0 / omega_sr) as f32);
        let turned = turned_from(centre(64, texel));
        let normals: Vec<DVec3> = turned.iter().map(|(_, n)| *n).collect();
        for fidelity in ["published", "corrected"] {
            for (window, factors) in [("none", [1.0; 3]), ("hanning", [1.0, 0.75, 0.25])] {
                let settings = [
                    ("fidelity", fidelity),
                    ("window", window),
                    ("sh_resolution", "64"),
                ];
                let values = irradiance(loaded, &image, &settings, &normals)?;
                for ((c, _), value) in turned.iter().zip(&values) {
                    let expected = bands(*c, factors);
                    ensure!(
                        (value - expected).abs() < 2e-4,
                        "{fidelity}, {window}, {texel:?}: E/E0 = {value} at c = {c}, not {expected}"
                    );
                }
                let lowest = values.last().copied().unwrap_or(0.0);
                ensure!(
                    window != "none" || (lowest + 19.0 / 480.0).abs() < 2e-4,
                    "{fidelity}, {texel:?}: the minimum is {lowest}"
                );
            }
        }
    }
    Ok(())
}
