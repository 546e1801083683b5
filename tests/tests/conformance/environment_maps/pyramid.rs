//! The mip pyramid: what it keeps, its seams, and the Phong lobe that a level stands for.

use super::{Feed, centre, environment, filtered, lobes, mirrors, sphere, texels, under};
use crate::ensure;
use crate::variants::Outcome;
use glam::{DVec3, Vec3};
use interreflect_estimators::Quantity;
use interreflect_scene::CubeImage;
use interreflect_scene::conventions::{CUBE_FACES, cube_vector, texel_solid_angle_sr};

/// An environment whose texels have nothing to do with each other, in [0, 1).
fn noise(size: u32) -> CubeImage {
    environment(size, |d| {
        let value =
            |k: f64| ((d.x * 12.9 + d.y * 78.2 + d.z * 37.7 + k).sin() * 43758.5).rem_euclid(1.0);
        DVec3::new(value(0.0), value(1.0), value(2.0)).as_vec3()
    })
}

/// Mean over the cube, texel by texel or by solid angle.
fn mean(size: u32, values: &[Vec3], by_solid_angle: bool) -> DVec3 {
    let (mut sum, mut total) = (DVec3::ZERO, 0.0);
    for ((_, column, row), value) in texels(size).zip(values) {
        let weight = match by_solid_angle {
            true => texel_solid_angle_sr(size, column, row),
            false => 1.0,
        };
        sum += value.as_dvec3() * weight;
        total += weight;
    }
    sum / total
}

/// Along a texel's centre a lookup gives the texel: every level has the environment's mean,
/// `published` over the texels, `corrected` over the sphere.
pub(super) fn pyramid_keeps_the_mean<S: Feed>(loaded: &S) -> Outcome {
    let image = noise(64);
    for (fidelity, by_solid_angle) in [("published", false), ("corrected", true)] {
        let expected = mean(64, &image.radiance, by_solid_angle);
        for level in 0..=5_u32 {
            let size = 32 >> level;
            let lod = level.to_string();
            let settings = [("fidelity", fidelity), ("resolution", "32"), ("lod", &lod)];
            let directions = texels(size).map(|texel| centre(size, texel));
            let values = filtered(loaded, &image, &settings, directions)?;
            let found = mean(size, &values, by_solid_angle);
            // Float32 means of four, five times; a direction off a texel's centre by rounding
            // takes 1e-6 of the next texel, of either sign.
            ensure!(
                (found - expected).abs().max_element() < 2e-6,
                "{fidelity}, level {level}: mean {found}, of the environment {expected}"
            );
        }
    }
    Ok(())
}

pub(super) fn lookups_stay_between_the_extremes<S: Feed>(loaded: &S) -> Outcome {
    let image = noise(64);
    let (low, high) = (image.radiance.iter()).fold((Vec3::ONE, Vec3::ZERO), |(low, high), v| {
        (low.min(*v), high.max(*v))
    });
    for fidelity in ["published", "corrected"] {
        for lod in ["-1", "0", "0.5", "2.3", "4", "6", "9.4"] {
            let settings = [("fidelity", fidelity), ("lod", lod)];
            for value in filtered(loaded, &image, &settings, sphere(3000))? {
                let inside = (value - low)
                    .min_element()
                    .min((high - value).min_element());
                // Weights of a mean add up to 1 but for float32.
                ensure!(
                    inside > -1e-6,
                    "{fidelity}, lod {lod}: {value} beyond {low}..{high}"
                );
            }
        }
    }
    Ok(())
}

/// Directions in pairs, 2e-5 apart, on both sides of all edges of all faces.
fn across_edges() -> impl Iterator<Item = DVec3> {
    let places = (0..CUBE_FACES).flat_map(|face| (0..200).map(move |i| (face, i)));
    places.flat_map(|(face, i)| {
        let along = (f64::from(i) + 0.5) / 100.0 - 1.0;
        let beside = [-1.0 + 1e-5, -1.0 - 1e-5, 1.0 - 1e-5, 1.0 + 1e-5];
        let columns = beside.map(|edge| cube_vector(face, edge, along).normalize());
        let rows = beside.map(|edge| cube_vector(face, along, edge).normalize());
        columns.into_iter().chain(rows)
    })
}

/// Across an edge of the cube a lookup in `published` steps by about a texel's contrast: Figure
/// 4's seams. In `corrected` it goes on: what is left is the change over 2e-5 of a face's half
/// edge, 1e-5·size of a texel, of a contrast below 3.
pub(super) fn seams_are_of_published_alone<S: Feed>(loaded: &S) -> Outcome {
    let image = environment(64, lobes);
    for level in 1..=6_u32 {
        let step = |fidelity: &str| {
            let lod = level.to_string();
            let settings = [("fidelity", fidelity), ("lod", &*lod)];
            let values = filtered(loaded, &image, &settings, across_edges())?;
            let steps = values
                .chunks_exact(2)
                .map(|v| (v[0] - v[1]).abs().max_element());
            Ok::<_, libtest_mimic::Failed>(steps.fold(0.0, f32::max))
        };
        let (published, corrected) = (step("published")?, step("corrected")?);
        println!(
            "level {level}: largest step {published:.2e} published, {corrected:.2e} corrected"
        );
        let size = (64 >> level) as f32;
        ensure!(
            corrected < 3.0 * 1e-5 * size + 2e-6,
            "level {level}: corrected steps by {corrected}"
        );
        ensure!(
            published > 0.02 && published > 100.0 * corrected,
            "level {level}: published steps by {published}, corrected by {corrected}"
        );
    }
    Ok(())
}

/// E[1 − cos] = 1/(N+2) for the lobe of N = 225 is met by a box of K/2^m = √(N/3) = 8.7 texels
/// along an edge, level 2.9 of 64. In a smooth environment the two differ by less than a twentieth
/// in the relative root mean square, and more a level further up.
pub(super) fn matched_level_is_near_the_phong_lobe<S: Feed>(loaded: &S) -> Outcome {
    let image = environment(64, lobes);
    let points = mirrors(sphere(4000));
    let phong = (
        "phong_envmap",
        &[("f_lambda", "1"), ("exponent", "225")][..],
    );
    let phong = under(loaded, &image, phong, Quantity::GlossyRadiance, &points)?;
    let apart = |fidelity: &str, lod: &str| {
        let settings = [("fidelity", fidelity), ("lod", lod)];
        let values = filtered(loaded, &image, &settings, sphere(4000))?;
        let (mut difference, mut whole) = (0.0, 0.0);
        for (value, phong) in values.iter().zip(phong.iter()) {
            difference += (*value - phong).as_dvec3().length_squared();
            whole += phong.as_dvec3().length_squared();
        }
        Ok::<_, libtest_mimic::Failed>((difference / whole).sqrt())
    };
    for fidelity in ["published", "corrected"] {
        let mut found = Vec::new();
        for lod in ["1.9", "2.4", "2.9", "3.9"] {
            found.push(apart(fidelity, lod)?);
        }
        println!("{fidelity}: {found:?} at levels 1.9, 2.4, 2.9, 3.9");
        ensure!(
            found[2] < 0.05,
            "{fidelity}: {} at the matched level",
            found[2]
        );
        // A bilinear lookup widens the box: the best level is half a level below the formula's.
        ensure!(
            found[1] < found[0] && found[1] < found[2],
            "{fidelity}: the best of {found:?} is not at 2.4"
        );
        ensure!(found[3] > 2.0 * found[2], "{fidelity}: {found:?}");
    }
    Ok(())
}
