//! Short ways to ask for estimates.

use super::{point, points};
use glam::Vec3;
use interreflect_cpu::path_tracer::{PathQuantity, Stop, Traced, trace};
use interreflect_cpu::scene::CpuScene;
use interreflect_scene::{LightPaths, Points};

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
    let stop = samples(count);
    trace(
        scene,
        points,
        PathQuantity::Irradiance,
        &paths,
        &stop,
        1,
        &|_| (),
    )
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
