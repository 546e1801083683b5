//! Short ways to ask for estimates and to judge them.

use super::{point, points};
use glam::Vec3;
use interreflect_cpu::path_tracer::{LightPaths, PathQuantity, Stop, Traced, trace};
use interreflect_cpu::scene::CpuScene;
use interreflect_scene::Points;

pub(crate) const FULL: LightPaths = LightPaths {
    bounces: 0,
    indirect_visibility: true,
    self_shadowing: true,
    environment_at_infinity: false,
};

pub(crate) fn samples(count: u32) -> Stop {
    Stop {
        samples: Some(count),
        ..Stop::default()
    }
}

pub(crate) fn irradiance(
    scene: &CpuScene,
    points: &Points,
    paths: LightPaths,
    count: u32,
) -> Traced {
    irradiance_of_seed(scene, points, paths, count, 1)
}

pub(crate) fn irradiance_of_seed(
    scene: &CpuScene,
    points: &Points,
    paths: LightPaths,
    count: u32,
    seed: u64,
) -> Traced {
    trace(
        scene,
        points,
        PathQuantity::Irradiance,
        &paths,
        &samples(count),
        seed,
        &|_| (),
    )
}

/// Largest |z| over the points, in the red channel.
pub(crate) fn largest_z(traced: &Traced, exact: impl Fn(usize) -> f64) -> f64 {
    let values = traced.mean.iter().zip(traced.standard_error.iter());
    values
        .enumerate()
        .map(|(i, (mean, error))| ((f64::from(mean.x) - exact(i)) / f64::from(error.x)).abs())
        .fold(0.0, f64::max)
}

/// Points everywhere in [−1, 1]³, those near the walls included, with all kinds of normals.
pub(crate) fn inside(count: usize) -> Points {
    let spread = |i: usize, step: f64| (i as f64 * step).fract() as f32 * 1.998 - 0.999;
    points(super::directions(count).enumerate().map(|(i, normal)| {
        let at = Vec3::new(
            spread(i, 0.754_877_67),
            spread(i, 0.569_840_29),
            spread(i, 0.31),
        );
        point(at, normal)
    }))
}
