//! Images that each backend makes of its own captures, pixel by pixel.

use super::{CAPTURED, OF_A_TERM, sum_of, texels};
use crate::ensure;
use crate::parity::captures_apart;
use crate::test_scenes::{TEST_SCENES, TestScene};
use crate::variants::{
    Outcome, Variant, captures, cpu_scene, gpu_scene, ignored, on_gpu, variants,
};
use glam::Vec3;
use interreflect::clock::Sampling;
use interreflect::image::HdrImage;
use interreflect::measure::measure;
use interreflect::view::{Look, View};
use interreflect_conformance::exchange::downloaded;
use interreflect_estimators::Quantity;
use interreflect_estimators::execution::{BackendScene, CpuLoadedScene, GpuLoadedScene};
use interreflect_gpu::GpuContext;
use interreflect_scene::Camera;
use libtest_mimic::{Failed, Trial};
use std::sync::{Arc, LazyLock};

pub(crate) fn trials() -> Vec<Trial> {
    variants(CAPTURED).into_iter().map(trial).collect()
}

/// In the first library scene that the method can run in, and that is open where openness is shown.
fn trial(variant: Variant) -> Trial {
    let name = format!("precision_parity/images/{}", variant.name());
    let runs = |s: &&LazyLock<TestScene>| {
        let open = s.cpu.scene().environment.is_some();
        let shows = open || variant.quantity != Quantity::AmbientOcclusion;
        shows && variant.unsupported(s).is_none() && variant.runs_in(s)
    };
    match TEST_SCENES[..3].iter().find(runs) {
        Some(test_scene) => on_gpu(name, move |context| {
            same_image(context, test_scene, &variant)
        }),
        None => ignored(name, "no library scene on both backends"),
    }
}

fn same_image(
    context: &Arc<GpuContext>,
    test_scene: &'static TestScene,
    variant: &Variant,
) -> Outcome {
    let camera = Camera {
        resolution: [96, 72],
        ..test_scene.cpu.scene().camera
    };
    let view = View::new(&test_scene.cpu, &camera, Look::default())?;
    let (cpu, gpu) = (cpu_scene(test_scene), gpu_scene(context, test_scene)?);
    let by_cpu = image(&cpu, variant, &view)?;
    let by_gpu = image(&gpu, variant, &view)?;
    let bound = Bound::of(variant, &cpu, (&gpu, context))?;
    let of_pixel = |pixel: &Vec3| f64::from(pixel.abs().max_element());
    let pixels = by_cpu.pixels.iter().map(of_pixel);
    let (brightest, total) = pixels.fold((0.0, 0.0), |(m, s), v| (f64::max(m, v), s + v));
    ensure!(total > 0.0, "a black image");
    let pairs = by_cpu.pixels.iter().zip(&by_gpu.pixels);
    let apart = pairs.map(|(a, b)| of_pixel(&(*a - *b)));
    let (largest, sum) = apart.fold((0.0, 0.0), |(m, s), v| (f64::max(m, v), s + v));
    let (largest, mean) = (largest / brightest, sum / total);
    println!(
        "{} in {}: pixels differ by {largest:.1e} of the brightest at most, {mean:.1e} of the mean on \
         average",
        variant.name(),
        test_scene.name
    );
    let brightest_over_mean = brightest * by_cpu.pixels.len() as f64 / total;
    ensure!(
        largest <= bound.largest + bound.captures / brightest,
        "a pixel is {largest:.2e} of the brightest apart, more than {:.2e} ({})",
        bound.largest,
        bound.cause
    );
    ensure!(
        mean <= bound.mean * brightest_over_mean + bound.captures * brightest_over_mean / brightest,
        "pixels are {mean:.2e} of the mean apart on average, more than {:.2e} ({})",
        bound.mean * brightest_over_mean,
        bound.cause
    );
    Ok(())
}

/// How far two images may part, in units of the brightest pixel.
struct Bound {
    largest: f64,
    mean: f64,
    /// What the difference of the captures adds, as an irradiance.
    captures: f64,
    cause: &'static str,
}

impl Bound {
    fn of(
        variant: &Variant,
        cpu: &CpuLoadedScene,
        (gpu, context): (&GpuLoadedScene, &GpuContext),
    ) -> Result<Self, Failed> {
        let by_cpu = captures(cpu, variant)?;
        if !by_cpu.depths.is_empty() {
            // Of the directions of a pixel 1e-4 each lie along a rasterised silhouette; one that is seen
            // otherwise counts four shares of all, and four of them are the most that a pixel has.
            return Ok(Self {
                largest: 0.25,
                mean: 4e-4,
                captures: 0.0,
                cause: "silhouettes in depth maps",
            });
        }
        let by_gpu = downloaded(context, &*captures(gpu, variant)?)?;
        let rounding = sum_of(texels(&by_cpu), OF_A_TERM);
        Ok(Self {
            largest: rounding,
            mean: rounding,
            captures: captures_apart(&by_cpu, &by_gpu)?,
            cause: "float32 sums over captured texels, and what the captures differ by",
        })
    }
}

fn image<S: BackendScene>(loaded: &S, variant: &Variant, view: &View) -> Result<HdrImage, Failed> {
    let points = view.points(variant.quantity.layout());
    let measured = measure(
        loaded,
        &*variant.method,
        variant.quantity,
        &points,
        &Sampling::ONCE,
    )?;
    Ok(view.image(&measured.estimate))
}
