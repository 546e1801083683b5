//! The two backends against each other: fed the same captures, then each its own.

use crate::ensure;
use crate::parity_views::views_apart;
use crate::test_scenes::{TEST_SCENES, TestScene};
use crate::variants::{
    Outcome, Variant, bounced, captures, cpu_scene, estimate, gpu_scene, ignored, on_gpu, switched,
    variants,
};
use interreflect_conformance::exchange::{downloaded, uploaded};
use interreflect_conformance::verify::parity::{float32, texels};
use interreflect_estimators::Tolerance;
use interreflect_estimators::{Captures, Cpu};
use interreflect_gpu::GpuContext;
use interreflect_scene::conventions::{CUBE_FACES, texel_index, texel_solid_angle_sr};
use interreflect_scene::{CubeImage, Estimate};
use libtest_mimic::{Failed, Trial};
use std::rc::Rc;
use std::sync::{Arc, LazyLock};

pub(crate) fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    for variant in variants(128) {
        for test_scene in &TEST_SCENES {
            let name = format!("parity/{}/{}", test_scene.name, variant.name());
            if let Some(why) = on_either(&variant, test_scene) {
                trials.push(ignored(name, &why));
                continue;
            }
            let variant = variant.copy();
            trials.push(on_gpu(name, move |context| {
                parity(context, test_scene, &variant)
            }));
        }
    }
    for variant in bounced(128) {
        for test_scene in &TEST_SCENES[..3] {
            let name = format!("parity/{}/{}.bounces", test_scene.name, variant.name());
            if on_either(&variant, test_scene).is_none() {
                let variant = variant.copy();
                trials.push(on_gpu(name, move |context| {
                    parity(context, test_scene, &variant)
                }));
            }
        }
    }
    for (variant, setting) in switched(128) {
        // The first test scene that it can run in.
        let why_not = |s: &&LazyLock<TestScene>| on_either(&variant, s).is_some();
        let test_scene = TEST_SCENES
            .iter()
            .find(|s| !why_not(s))
            .unwrap_or(&TEST_SCENES[0]);
        let name = format!("parity/{}/{}/{setting}", test_scene.name, variant.name());
        trials.push(match on_either(&variant, test_scene) {
            Some(why) => ignored(name, &why),
            None => on_gpu(name, move |context| parity(context, test_scene, &variant)),
        });
    }
    trials
}

/// Why a method can't be compared between the backends in a scene, if it can't.
fn on_either(variant: &Variant, test_scene: &TestScene) -> Option<String> {
    let on_cpu = variant.unsupported(test_scene);
    on_cpu.or_else(|| variant.unsupported_on_gpu(test_scene))
}

fn parity(context: &Arc<GpuContext>, test_scene: &'static TestScene, variant: &Variant) -> Outcome {
    let (cpu, gpu) = (cpu_scene(test_scene), gpu_scene(context, test_scene)?);
    let points = test_scene.points(variant.quantity.layout());
    let by_cpu = captures(&cpu, variant)?;
    let by_gpu = captures(&gpu, variant)?;
    let mut on_device = uploaded(context, &by_cpu)?;
    let mut on_host = downloaded(context, &by_gpu)?;
    // Depth maps are made while they are read, each backend's by itself: there is nothing to swap.
    on_device.depths.clone_from(&by_gpu.depths);
    on_host.depths.clone_from(&by_cpu.depths);
    let (on_device, on_host) = (Rc::new(on_device), Rc::new(on_host));
    let silhouettes = !by_cpu.depths.is_empty();

    let on_cpu = estimate(&cpu, variant, &by_cpu, &points)?;
    let on_gpu = estimate(&gpu, variant, &by_gpu, &points)?;
    let same = float32(texels(&by_cpu), largest(&on_cpu));
    let of_cpu_captures = estimate(&gpu, variant, &on_device, &points)?;
    let check = if silhouettes { check_most } else { check };
    check(&same, &on_cpu, &of_cpu_captures).map_err(|e| format!("on the CPU's captures: {e}"))?;
    let of_gpu_captures = estimate(&cpu, variant, &on_host, &points)?;
    check(&same, &of_gpu_captures, &on_gpu).map_err(|e| format!("on the GPU's captures: {e}"))?;

    let apart = captures_apart(&by_cpu, &on_host)?;
    let own = Tolerance {
        absolute: same.absolute + apart,
        cause: "captures that differ along edges of surfaces and shadows",
        ..same
    };
    Ok(check(&own, &on_cpu, &on_gpu).map_err(|e| format!("each on its own captures: {e}"))?)
}

fn check(tolerance: &Tolerance, a: &Estimate, b: &Estimate) -> Result<(), String> {
    let values =
        |e: &Estimate| -> Vec<f64> { e.iter().flat_map(|v| v.to_array()).map(f64::from).collect() };
    tolerance.check_all(values(a).into_iter(), values(b).into_iter())
}

/// Most points that a texel seen differently may change: of the directions of a point about 1e-4 each
/// lie along a rasterised silhouette, and there are 66 of them.
const CHANGED_SHARE: f64 = 0.03;

/// As [`check`], but for points whose depth maps see a silhouette in another texel. These are few, and
/// change by four directions' shares at most: 4/66 each, a quarter of an open point in all.
fn check_most(tolerance: &Tolerance, a: &Estimate, b: &Estimate) -> Result<(), String> {
    let largest = a
        .iter()
        .chain(b.iter())
        .fold(0.0_f32, |m, v| m.max(v.max_element()));
    let mut changed = 0;
    for (i, (a, b)) in a.iter().zip(b.iter()).enumerate() {
        let apart = (a - b).abs().max_element();
        ensure!(apart <= 0.25 * largest, "point {i} has {a} and {b}");
        let bound = tolerance.absolute + tolerance.relative * f64::from(a.abs().max_element());
        changed += usize::from(f64::from(apart) > bound);
    }
    ensure!(
        changed as f64 <= CHANGED_SHARE * a.len() as f64,
        "{changed} of {} points are apart",
        a.len()
    );
    Ok(())
}

fn largest(estimate: &Estimate) -> f64 {
    let largest = estimate.iter().fold(0.0_f32, |m, v| m.max(v.max_element()));
    f64::from(largest)
}

/// A texel at half the distance from the point as from the reference point counts four times.
const NEARER: f64 = 4.0;

/// Most of the sphere, in sr, that two captures may see differently: a row of texels along the
/// edges, and shadows' borders of some texels of the shadow map.
const SEEN_DIFFERENTLY_SR: f64 = 0.03;

/// Bound on what the captures' differences do to an irradiance: all radiance that is new, gone or
/// from elsewhere, as if it arrived head-on from texels at half the distance.
pub(crate) fn captures_apart(a: &Captures<Cpu>, b: &Captures<Cpu>) -> Result<f64, Failed> {
    let mut bound = 0.0;
    for (spec, a) in &a.cubes {
        let b = b.cubes.get(spec).ok_or("a capture of one backend only")?;
        let brightest = a
            .radiance
            .iter()
            .fold(0.0_f32, |m, v| m.max(v.max_element()));
        let (mut flux, mut differently_sr) = (0.0, 0.0);
        for (index, omega_sr) in solid_angles(a.size) {
            let radiance = (a.radiance[index] - b.radiance[index]).abs().max_element();
            let moved = moved(a, b, index);
            flux += omega_sr * f64::from(radiance + brightest * moved);
            if radiance > 1e-2 * brightest || moved > 1e-2 {
                differently_sr += omega_sr;
            }
        }
        ensure!(
            differently_sr < SEEN_DIFFERENTLY_SR,
            "captures of {spec:?} differ over {differently_sr:.4} sr"
        );
        bound += NEARER * flux;
    }
    for (spec, a) in &a.rsms {
        let b = b.rsms.get(spec);
        bound += views_apart(a, b.ok_or("a capture of one backend only")?)?;
    }
    Ok(bound)
}

/// How far a texel's surface is from the other capture's, relative to its distance, or how much it
/// is turned; at most 1.
fn moved(a: &CubeImage, b: &CubeImage, index: usize) -> f32 {
    let distance = match (a.distance.get(index), b.distance.get(index)) {
        (Some(a), Some(b)) if a.is_finite() && b.is_finite() => (a - b).abs() / a.min(*b),
        (Some(a), Some(b)) if a.is_finite() != b.is_finite() => 1.0,
        _ => 0.0,
    };
    let turned = match (a.normal.get(index), b.normal.get(index)) {
        (Some(a), Some(b)) => a.distance(*b),
        _ => 0.0,
    };
    (2.0 * distance).max(turned).min(1.0)
}

fn solid_angles(size: u32) -> impl Iterator<Item = (usize, f64)> {
    let face: Vec<f64> = (0..size * size)
        .map(|i| texel_solid_angle_sr(size, i % size, i / size))
        .collect();
    (0..CUBE_FACES).flat_map(move |f| {
        let first = texel_index(size, f, 0, 0);
        face.clone()
            .into_iter()
            .enumerate()
            .map(move |(i, omega_sr)| (first + i, omega_sr))
    })
}
