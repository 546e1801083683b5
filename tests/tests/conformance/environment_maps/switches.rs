//! The settings of the method change what they should, and nothing else.

use super::{Feed, environment, lobes, mirrors, sphere, under};
use crate::ensure;
use crate::variants::Outcome;
use glam::Vec3;
use interreflect_estimators::Quantity;
use interreflect_scene::{Estimate, Point};
use libtest_mimic::Failed;

const IRRADIANCE: Quantity = Quantity::Irradiance;
const GLOSSY: Quantity = Quantity::GlossyRadiance;

/// Points that reflect by their lobe alone, looked at along the mirrored directions.
fn shiny() -> Vec<Point> {
    mirrors(sphere(300))
}

/// The same points without a lobe.
fn matte() -> Vec<Point> {
    let matte = |mut p: Point| {
        (p.material.diffuse, p.material.specular) = (Vec3::splat(0.5), Vec3::ZERO);
        p
    };
    shiny().into_iter().map(matte).collect()
}

fn run<S: Feed>(
    loaded: &S,
    settings: &[(&str, &str)],
    quantity: Quantity,
    points: &[Point],
) -> Result<Estimate, Failed> {
    let image = environment(64, lobes);
    under(
        loaded,
        &image,
        ("sh_mip_envmap", settings),
        quantity,
        points,
    )
}

pub(super) fn settings_change_what_they_should<S: Feed>(loaded: &S) -> Outcome {
    // Each setting with what it changes: irradiance (and with it matte points), and lobes.
    for (settings, harmonics, lobes) in [
        ([("fidelity", "corrected")], true, true),
        ([("window", "hanning")], true, false),
        ([("sh_resolution", "16")], true, false),
        ([("resolution", "16")], false, true),
        ([("lod", "1.5")], false, true),
        ([("f_lambda", "0.5")], false, true),
    ] {
        let changes = |quantity, points: &[Point]| {
            let before = run(loaded, &[], quantity, points)?;
            Ok::<_, Failed>(before != run(loaded, &settings, quantity, points)?)
        };
        ensure!(
            changes(IRRADIANCE, &shiny())? == harmonics,
            "{settings:?} changes the irradiance: {}",
            !harmonics
        );
        ensure!(
            changes(GLOSSY, &shiny())? == lobes,
            "{settings:?} changes lobes: {}",
            !lobes
        );
        // Schlick's factor takes from k_d what it gives to k_s.
        let mixed = harmonics || settings[0].0 == "f_lambda";
        ensure!(
            changes(GLOSSY, &matte())? == mixed,
            "{settings:?} changes matte points: {}",
            !mixed
        );
    }
    Ok(())
}

/// A mirrored direction that turns by 2^k texels of the base, 2/64 rad each, is looked up at level
/// k plus the bias; one that is not known at the finest.
pub(super) fn bias_takes_the_level_from_the_footprint<S: Feed>(loaded: &S) -> Outcome {
    for (footprint, bias, level) in [
        (2.0 / 64.0, "2", "2"),
        (8.0 / 64.0, "0", "2"),
        (8.0 / 64.0, "1.5", "3.5"),
        (8.0 / 64.0, "-1", "1"),
        (0.5 / 64.0, "1", "0"),
        (1.0 / 64.0, "9.4", "6"),
    ] {
        let mut points = shiny();
        points.iter_mut().for_each(|p| p.footprint = footprint);
        points[0].footprint = 0.0;
        let biased = run(
            loaded,
            &[("lod_mode", "bias"), ("lod", bias)],
            GLOSSY,
            &points,
        )?;
        let absolute = run(loaded, &[("lod", level)], GLOSSY, &points)?;
        let finest = run(loaded, &[("lod", "0")], GLOSSY, &points)?;
        for i in 0..points.len() {
            let expected = if i == 0 { &finest } else { &absolute };
            let apart = (biased.get(i) - expected.get(i)).abs().max_element();
            // A logarithm of magnitude 5 to 3 units in the last place, between levels 1 apart.
            ensure!(
                apart < 5e-6,
                "footprint {footprint}, bias {bias}: point {i} differs by {apart} from level {level}"
            );
        }
    }
    Ok(())
}

/// Points that are no pixels have no level with a bias; where no level is needed that is no matter.
pub(super) fn bias_needs_a_footprint<S: Feed>(loaded: &S) -> Outcome {
    let bias = [("lod_mode", "bias")];
    let refused = run(loaded, &bias, GLOSSY, &shiny());
    let Err(reason) = refused else {
        return Err("levels were taken from nothing".into());
    };
    let reason = reason.message().unwrap_or_default().to_owned();
    ensure!(
        reason.contains("lod_mode=absolute"),
        "no remedy in: {reason}"
    );
    for (quantity, points) in [(IRRADIANCE, shiny()), (GLOSSY, matte())] {
        let biased = run(loaded, &bias, quantity, &points)?;
        ensure!(
            biased == run(loaded, &[], quantity, &points)?,
            "{}: lod_mode changes what has no level",
            quantity.name()
        );
    }
    Ok(())
}
