//! Methods that move the environment to infinity, fed with environments whose answers are known.

mod fresnel;
mod harmonics;
mod pyramid;
mod switches;

use crate::test_scenes::TEST_SCENES;
use crate::variants::{Outcome, Variant, cpu_scene, estimate, gpu_scene, on_gpu};
use glam::{DVec3, Vec3};
use interreflect_estimators::execution::{BackendScene, CpuLoadedScene, GpuLoadedScene};
use interreflect_estimators::{Captures, Quantity, Registry};
use interreflect_gpu::GpuCube;
use interreflect_scene::conventions::{CUBE_FACES, cube_vector, texel_centre, texel_index};
use interreflect_scene::{CubeImage, CubeSpec, Estimate, Point, Points, SurfaceMaterial};
use libtest_mimic::{Failed, Trial};
use std::f64::consts::TAU;
use std::rc::Rc;

type Check<S> = fn(&S) -> Outcome;

pub(crate) fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    macro_rules! on_both {
        ($module:ident, $check:ident) => {
            let name = concat!("environment_maps/", stringify!($check));
            trials.push(Trial::test(format!("{name}/cpu"), || {
                let check: Check<_> = $module::$check;
                check(&cpu_scene(&TEST_SCENES[4]))
            }));
            trials.push(on_gpu(format!("{name}/gpu"), |context| {
                let check: Check<_> = $module::$check;
                check(&gpu_scene(context, &TEST_SCENES[4])?)
            }));
        };
    }
    on_both!(harmonics, constant_environment_gives_pi);
    on_both!(harmonics, hemispherical_sky_falls_with_the_texels);
    on_both!(harmonics, delta_light_shows_the_bands);
    on_both!(pyramid, pyramid_keeps_the_mean);
    on_both!(pyramid, lookups_stay_between_the_extremes);
    on_both!(pyramid, seams_are_of_published_alone);
    on_both!(pyramid, matched_level_is_near_the_phong_lobe);
    on_both!(fresnel, schlick_grows_towards_grazing_angles);
    on_both!(fresnel, schlick_averages_to_its_integral);
    on_both!(switches, settings_change_what_they_should);
    on_both!(switches, bias_takes_the_level_from_the_footprint);
    on_both!(switches, bias_needs_a_footprint);
    trials
}

/// A backend that can be fed a captured cube.
trait Feed: BackendScene {
    fn feed(&self, image: &CubeImage) -> Result<Captures<Self::Backend>, Failed>;
}

impl Feed for CpuLoadedScene {
    fn feed(&self, image: &CubeImage) -> Result<Captures<Self::Backend>, Failed> {
        let mut captures = Captures::default();
        captures.cubes.insert(image.spec(), image.clone());
        Ok(captures)
    }
}

impl Feed for GpuLoadedScene {
    fn feed(&self, image: &CubeImage) -> Result<Captures<Self::Backend>, Failed> {
        let mut captures = Captures::default();
        let cube = GpuCube::upload(&self.context, image)?;
        captures.cubes.insert(image.spec(), cube);
        Ok(captures)
    }
}

/// An environment of `size`² texels a face.
fn environment(size: u32, radiance: impl Fn(DVec3) -> Vec3) -> CubeImage {
    let mut image = CubeImage::new(CubeSpec::of_radiance(size));
    for (face, column, row) in texels(size) {
        image.radiance[texel_index(size, face, column, row)] =
            radiance(centre(size, (face, column, row)));
    }
    image
}

fn texels(size: u32) -> impl Iterator<Item = (usize, u32, u32)> {
    (0..CUBE_FACES).flat_map(move |f| (0..size * size).map(move |i| (f, i % size, i / size)))
}

/// Unit direction of a texel's centre.
fn centre(size: u32, (face, column, row): (usize, u32, u32)) -> DVec3 {
    cube_vector(face, texel_centre(size, column), texel_centre(size, row)).normalize()
}

/// A smooth environment without symmetry: some broad lobes.
fn lobes(d: DVec3) -> Vec3 {
    let lobe = |x: f64, y: f64, z: f64, sharpness: f64| {
        let towards = DVec3::new(x, y, z).normalize();
        (sharpness * (d.dot(towards) - 1.0)).exp()
    };
    let r = 0.2 + 2.0 * lobe(0.8, 0.5, 0.3, 12.0);
    let g = 0.3 + lobe(-0.4, 0.7, 0.6, 8.0) + lobe(0.3, -0.9, 0.2, 20.0);
    let b = 0.4 + 1.5 * lobe(-0.5, 0.1, -0.8, 15.0);
    DVec3::new(r, g, b).as_vec3()
}

/// Directions all over the sphere, on a Fibonacci spiral.
fn sphere(count: usize) -> impl Iterator<Item = DVec3> {
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    (0..count).map(move |i| {
        let z = 1.0 - (2.0 * i as f64 + 1.0) / count as f64;
        let (sin, cos) = (TAU * golden * i as f64).sin_cos();
        let r = (1.0 - z * z).sqrt();
        DVec3::new(r * cos, r * sin, z)
    })
}

/// Points with these normals that are looked at head-on and reflect by their lobe alone: with
/// `f_lambda` = 1 their glossy radiance is the filtered radiance along the normal.
fn mirrors(directions: impl IntoIterator<Item = DVec3>) -> Vec<Point> {
    let point = |d: DVec3| Point {
        normal: d.as_vec3(),
        view: d.as_vec3(),
        material: SurfaceMaterial {
            specular: Vec3::ONE,
            ..SurfaceMaterial::default()
        },
        ..Point::default()
    };
    directions.into_iter().map(point).collect()
}

/// What a method estimates at points under an environment.
fn under<S: Feed>(
    loaded: &S,
    image: &CubeImage,
    (method, settings): (&str, &[(&str, &str)]),
    quantity: Quantity,
    points: &[Point],
) -> Result<Estimate, Failed> {
    let mut method = Registry::builtin().get(method)?.configure();
    method.set("capture_resolution", &image.size.to_string())?;
    for (name, value) in settings {
        method.set(name, value)?;
    }
    let points = Points::new(quantity.layout(), points.iter().copied().map(Some));
    let variant = Variant { method, quantity };
    estimate(loaded, &variant, &Rc::new(loaded.feed(image)?), &points)
}

/// The filtered radiance of the mip pyramid along directions.
fn filtered<S: Feed>(
    loaded: &S,
    image: &CubeImage,
    settings: &[(&str, &str)],
    directions: impl IntoIterator<Item = DVec3>,
) -> Result<Vec<Vec3>, Failed> {
    let settings = [&[("f_lambda", "1")], settings].concat();
    let method = ("sh_mip_envmap", &*settings);
    let quantity = Quantity::GlossyRadiance;
    let estimate = under(loaded, image, method, quantity, &mirrors(directions))?;
    Ok(estimate.iter().collect())
}
