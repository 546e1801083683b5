//! What `prepare` makes on the CPU and on the device of the same captures, record by record.

use super::{CAPTURED, OF_A_TERM, sum_of, texels};
use crate::ensure;
use crate::subjects::{SUBJECTS, Subject};
use crate::world::{Outcome, Variant, cpu_scene, gpu_scene, ignored, on_gpu, switched, variants};
use interreflect_conformance::exchange::uploaded;
use interreflect_conformance::tolerance::Tolerance;
use interreflect_estimators::{Changed, Quantity, Records};
use interreflect_gpu::GpuContext;
use libtest_mimic::{Failed, Trial};
use std::rc::Rc;
use std::sync::Arc;

/// Each method on both backends, in each fidelity and with each of its switches set otherwise.
pub(crate) fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    let all = variants(CAPTURED)
        .into_iter()
        .map(|v| (v, String::new()))
        .chain(
            switched(CAPTURED)
                .into_iter()
                .map(|(v, s)| (v, format!("/{s}"))),
        );
    for (variant, setting) in all {
        // Records are of captures, whatever is estimated from them: the quantity that needs most.
        let offered = variant.method.quantities();
        let most = match offered.contains(&Quantity::GlossyRadiance) {
            true => Quantity::GlossyRadiance,
            false => offered[0],
        };
        if variant.quantity != most || variant.gpu().is_err() {
            continue;
        }
        let fidelity = variant.method.fidelity().map(|f| format!(".{f}"));
        let id = variant.method.info().id;
        let name = format!(
            "ladder/records/{id}{}{setting}",
            fidelity.unwrap_or_default()
        );
        match SUBJECTS.iter().find(|s| why_not(&variant, s).is_none()) {
            Some(subject) => {
                trials.push(on_gpu(name, move |context| {
                    compare(context, subject, &variant)
                }));
            }
            None => trials.push(ignored(name, "no subject on both backends")),
        }
    }
    trials
}

/// Why a method's records can't be compared in a scene: it does not run there on both backends, or it
/// makes depth maps while it prepares, each backend its own.
fn why_not(variant: &Variant, subject: &Subject) -> Option<String> {
    let facts = subject.cpu.scene().facts();
    let own_maps = match variant.method.needs(variant.quantity, &facts) {
        Ok(needs) => (!needs.directional_depths.is_empty()).then(|| "depth maps".to_owned()),
        Err(_) => None,
    };
    own_maps
        .or_else(|| variant.unsupported(subject))
        .or_else(|| variant.unsupported_on_gpu(subject))
}

fn compare(context: &Arc<GpuContext>, subject: &'static Subject, variant: &Variant) -> Outcome {
    let (cpu, gpu) = (cpu_scene(subject), gpu_scene(context, subject)?);
    let points = subject.points(variant.quantity.layout());
    let mut on_host = variant.executor(&cpu, &points)?;
    on_host.prepare(Changed::ALL)?;
    let captures = on_host.captures()?;
    let mut on_device = variant.executor(&gpu, &points)?;
    on_device.set_captures(Rc::new(uploaded(context, &captures)?));
    on_device.prepare(Changed::ALL)?;
    let (host, device) = (on_host.records()?, on_device.records()?);
    let first = host.first().ok_or("nothing was prepared")?;
    ensure!(!first.values.is_empty(), "no {}", first.name);
    ensure!(host.len() == device.len(), "other lists on the device");
    for (host, device) in host.iter().zip(&device) {
        let largest = same(host, device, texels(&captures))?;
        println!(
            "{} {}: {largest:.1e} of the largest number",
            variant.name(),
            host.name
        );
    }
    Ok(())
}

/// Checks each number; the largest difference. Its scale is the largest of its column: the
/// components of a unit vector, and coefficients that cancel, have the error of their terms.
fn same(host: &Records, device: &Records, captured: f64) -> Result<f64, Failed> {
    let (name, width) = (host.name, host.width);
    ensure!(
        name == device.name && width == device.width && host.values.len() == device.values.len(),
        "{name}: {} numbers, on the device {}",
        host.values.len(),
        device.values.len()
    );
    let records = (host.values.len() / width).max(1) as f64;
    // Records of single directions share the captured texels; the others each sum over all.
    let terms = match name {
        "texels" | "corners" | "radiances" | "photons" | "highlights" => captured / records,
        _ => captured,
    };
    let mut worst = 0.0_f64;
    for column in 0..width {
        let of = |list: &Records| -> Vec<f64> {
            let column = list.values.iter().skip(column).step_by(width);
            column.map(|v| f64::from(*v)).collect()
        };
        let (a, b) = (of(host), of(device));
        let scale = a.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let tolerance = Tolerance {
            absolute: sum_of(terms, OF_A_TERM) * scale,
            relative: if name == "highlights" { LOBE } else { 0.0 },
            cause: "float32 sums over the captured texels of a record",
        };
        let checked = tolerance.check_all(a.iter().copied(), b.iter().copied());
        checked.map_err(|e| format!("{name}, column {column}: {e}"))?;
        let apart = a.iter().zip(&b).map(|(a, b)| (a - b).abs());
        worst = worst.max(apart.fold(0.0, f64::max) / scale.max(f64::MIN_POSITIVE));
    }
    Ok(worst)
}

/// Relative error of a lobe's normalisation, which has a power in it.
const LOBE: f64 = 1e-5;
