//! Estimates at points, from the same captures: float64, one f32 at a time, sixteen lanes, device.

use super::{CAPTURED, OF_A_TERM, sum_of, texels};
use crate::ensure;
use crate::test_scenes::{TEST_SCENES, TestScene, same_bits};
use crate::variants::{
    Outcome, Variant, captures, cpu_scene, estimate, gpu_scene, ignored, on_gpu, switched, variants,
};
use interreflect_conformance::exchange::uploaded;
use interreflect_cpu::tiles::Arithmetic;
use interreflect_estimators::Tolerance;
use interreflect_estimators::directional_ao::DIRECTIONS;
use interreflect_estimators::{Captures, Changed, Cpu, Quantity};
use interreflect_gpu::GpuContext;
use interreflect_scene::params::Value;
use interreflect_scene::{Estimate, Points};
use libtest_mimic::{Failed, Trial};
use std::rc::Rc;
use std::sync::{Arc, LazyLock};

pub(crate) fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    for variant in variants(CAPTURED) {
        let name = format!("precision_parity/points/{}", variant.name());
        trials.push(trial(name, variant));
    }
    // Its switches say how visibility is found, which costs much: shading is the same.
    let cheap = |(variant, _): &(Variant, String)| variant.method.info().id != "directional_ao";
    for (variant, setting) in switched(CAPTURED).into_iter().filter(cheap) {
        let name = format!("precision_parity/points/{}/{setting}", variant.name());
        trials.push(trial(name, variant));
    }
    trials
}

/// In the first test scene that the method can run in, and that is open where openness is asked for.
fn trial(name: String, variant: Variant) -> Trial {
    let runs = |s: &&LazyLock<TestScene>| {
        let open = s.cpu.scene().environment.is_some();
        let shows = open || variant.quantity != Quantity::AmbientOcclusion;
        shows && variant.unsupported(s).is_none() && variant.runs_in(s)
    };
    match TEST_SCENES.iter().find(runs) {
        Some(test_scene) => on_gpu(name, move |context| climb(context, test_scene, &variant)),
        None => ignored(name, "no test scene on both backends"),
    }
}

/// Relative error of the power of a lobe.
const LOBE: f64 = 1e-5;

fn climb(context: &Arc<GpuContext>, test_scene: &'static TestScene, variant: &Variant) -> Outcome {
    let points = test_scene.points(variant.quantity.layout());
    let captured = captures(&cpu_scene(test_scene), variant)?;
    let [exact, scalar, lanes] = in_each_arithmetic(test_scene, variant, &captured, &points)?;
    let to_scalar = climbed(&exact, &scalar, &shading(variant))
        .map_err(|e| format!("float64 to scalar: {e}"))?;
    same_bits(&scalar, lanes.iter()).map_err(|e| format!("scalar to lanes: {e}"))?;
    let to_device = match captured.depths.is_empty() {
        true => {
            let given = Rc::new(uploaded(context, &captured)?);
            let gpu = gpu_scene(context, test_scene)?;
            let on_device = estimate(&gpu, variant, &given, &points)?;
            let largest = climbed(&exact, &on_device, &prepared(variant, &captured))
                .map_err(|e| format!("float64 to device: {e}"))?;
            format!("{largest:.1e}")
        }
        // Depth maps are made while they are read: they are no capture that both can be fed.
        false => "not the same depth maps".into(),
    };
    println!(
        "{}: largest error over largest value, scalar and lanes {to_scalar:.1e}, device {to_device}",
        variant.name()
    );
    Ok(())
}

/// Prepared once, shaded in float64, one f32 at a time and in sixteen lanes.
fn in_each_arithmetic(
    test_scene: &'static TestScene,
    variant: &Variant,
    captures: &Rc<Captures<Cpu>>,
    points: &Points,
) -> Result<[Estimate; 3], Failed> {
    let loaded = cpu_scene(test_scene);
    let mut executor = variant.executor(&loaded, points)?;
    executor.set_captures(captures.clone());
    executor.prepare(Changed::ALL)?;
    let mut shade = |arithmetic| {
        executor.phase("shade", Changed::NOTHING, |session, frame| {
            *frame.cx = frame.cx.with_arithmetic(arithmetic);
            let prepared = session.prepared();
            prepared.map_or(Ok(()), |prepared| prepared.shade(frame))
        })?;
        Ok::<_, Failed>(executor.read_back()?.0)
    };
    Ok([
        shade(Arithmetic::Float64)?,
        shade(Arithmetic::Scalar)?,
        shade(Arithmetic::Lanes)?,
    ])
}

/// Bound on what shading alone rounds: the sum over the records that a point reads. Its scale is the
/// largest value: where most terms are just below the horizon, what is left keeps their error.
fn shading(variant: &Variant) -> Tolerance {
    let values = variant.method.values();
    let number = |name: &str| {
        values.iter().find_map(|(field, value)| match value {
            Value::U32(number) if field.name == name => Some(f64::from(*number)),
            _ => None,
        })
    };
    let taps = number("map_resolution").filter(|_| number("resolution").is_some());
    let terms = match (taps, number("resolution"), number("samples_per_side")) {
        // Four nodes of a map, whose weights have the error of a place among its cells.
        (Some(cells), ..) => 4.0 + cells,
        (None, Some(m), _) => 6.0 * m * m,
        (None, None, Some(n)) => 6.0 * n * n,
        (None, None, None) => match number("level") {
            Some(level) => f64::from(DIRECTIONS[level as usize]),
            None => 4.0 + number("base_resolution").unwrap_or(64.0),
        },
    };
    bound(variant, terms, "float32 sums over prepared records")
}

/// Bound on what shading and preparing on the device round: sums over all captured texels.
fn prepared(variant: &Variant, captured: &Captures<Cpu>) -> Tolerance {
    let cause = "float32 sums over captured texels";
    bound(variant, texels(captured), cause)
}

fn bound(variant: &Variant, terms: f64, cause: &'static str) -> Tolerance {
    let glossy = variant.quantity == Quantity::GlossyRadiance;
    Tolerance {
        absolute: sum_of(terms, OF_A_TERM),
        relative: if glossy { LOBE } else { 0.0 },
        cause,
    }
}

/// The largest difference over the largest value, if each is within the tolerance, whose absolute
/// part is in units of that value.
fn climbed(exact: &Estimate, found: &Estimate, tolerance: &Tolerance) -> Result<f64, String> {
    let values =
        |e: &Estimate| -> Vec<f64> { e.iter().flat_map(|v| v.to_array()).map(f64::from).collect() };
    let (exact, found) = (values(exact), values(found));
    let largest = exact.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    ensure!(largest > 0.0, "nothing arrives anywhere");
    let scaled = Tolerance {
        absolute: tolerance.absolute * largest,
        ..*tolerance
    };
    scaled.check_all(exact.iter().copied(), found.iter().copied())?;
    let apart = exact.iter().zip(&found).map(|(a, b)| (a - b).abs());
    Ok(apart.fold(0.0, f64::max) / largest)
}
