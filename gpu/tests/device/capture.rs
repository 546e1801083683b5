//! Captures against the analytic box and the host's environment.

use crate::lighting::{lit_room, point};
use crate::oracle::{add_room, empty, everything, texels};
use crate::{Case, ensure};
use glam::{DVec3, Vec3};
use interreflect_gpu::{GpuContext, GpuCube, GpuScene, capture_cube};
use interreflect_scene::{
    CubeChannels, CubeImage, CubeSpec, Environment, LatLongImage, Material, Object, Role, Scene,
    conventions,
};
use libtest_mimic::Failed;
use std::sync::Arc;

pub(crate) const CASES: &[Case] = &[
    ("capture::box_matches_analysis", box_matches_analysis),
    (
        "capture::back_sides_are_seen_but_dark",
        back_sides_are_seen_but_dark,
    ),
    ("capture::only_what_was_asked_for", only_what_was_asked_for),
    ("capture::receivers_are_absent", receivers_are_absent),
    (
        "capture::environment_matches_host",
        environment_matches_host,
    ),
    (
        "capture::images_survive_the_round_trip",
        images_survive_the_round_trip,
    ),
    ("capture::threads_agree", threads_agree),
];

pub(crate) fn capture(
    context: &Arc<GpuContext>,
    scene: &Scene,
    spec: CubeSpec,
) -> Result<CubeImage, Failed> {
    let uploaded = GpuScene::new(context, scene)?;
    let origin = scene.reference_point;
    let (cube, _) = context.record("capture", |cx| {
        capture_cube(cx, &uploaded, origin, spec, None)
    })?;
    Ok(cube.download(context)?)
}

pub(crate) const OFF_CENTRE: Vec3 = Vec3::new(0.2, -0.1, 0.3);
const WALLS: [f32; 6] = [1.0, 0.2, 0.5, 0.8, 0.3, 0.6];

fn glowing_room(reference_point: Vec3) -> Scene {
    let mut scene = empty(reference_point);
    add_room(
        &mut scene,
        WALLS.map(|e| Material::emitter(Vec3::new(e, 2.0 * e, 0.5))),
    );
    scene
}

/// Wall that a ray from inside [−1, 1]³ meets first, its distance, and how much farther the second
/// nearest plane is.
fn box_hit(origin: DVec3, direction: DVec3) -> (usize, f64, f64) {
    let mut distances: Vec<_> = (0..3)
        .map(|axis| {
            let d = direction[axis];
            (
                (d.signum() - origin[axis]) / d,
                2 * axis + usize::from(d < 0.0),
            )
        })
        .collect();
    distances.sort_by(|a, b| a.0.total_cmp(&b.0));
    (
        distances[0].1,
        distances[0].0,
        distances[1].0 - distances[0].0,
    )
}

fn box_matches_analysis(context: &Arc<GpuContext>) -> Result<(), Failed> {
    let scene = glowing_room(OFF_CENTRE);
    for size in [1, 5, 64, 256] {
        let image = capture(context, &scene, everything(size))?;
        ensure!(image.spec() == everything(size), "{:?}", image.spec());
        for (i, direction) in texels(size) {
            let (wall, distance, margin) = box_hit(OFF_CENTRE.as_dvec3(), direction);
            let error = (f64::from(image.distance[i]) / distance - 1.0).abs();
            // A few roundings of f32 (6e-8 each).
            ensure!(
                error < 1e-6,
                "size {size}, texel {i}: distance is off by {error:e}"
            );
            // Nearer than this to an edge of the room the rasteriser's rounding decides.
            if margin < 1e-2 {
                continue;
            }
            let radiance = Vec3::new(WALLS[wall], 2.0 * WALLS[wall], 0.5);
            ensure!(
                image.radiance[i] == radiance,
                "size {size}, texel {i}, wall {wall}: {}",
                image.radiance[i]
            );
            let normal = -conventions::cube_vector(wall, 0.0, 0.0).as_vec3();
            ensure!(
                image.normal[i] == normal,
                "size {size}, texel {i}: {}",
                image.normal[i]
            );
        }
    }
    Ok(())
}

fn back_sides_are_seen_but_dark(context: &Arc<GpuContext>) -> Result<(), Failed> {
    let mut scene = glowing_room(OFF_CENTRE);
    for object in &mut scene.objects {
        for triangle in &mut object.mesh.triangles {
            triangle.swap(1, 2);
        }
    }
    let image = capture(context, &scene, everything(16))?;
    for (i, direction) in texels(16) {
        let facing = image.normal[i].as_dvec3().dot(direction);
        ensure!(
            facing < 0.0,
            "texel {i}: normal {} looks away",
            image.normal[i]
        );
        ensure!(image.distance[i] < 4.0, "texel {i}: {}", image.distance[i]);
        ensure!(
            image.radiance[i] == Vec3::ZERO,
            "texel {i}: {}",
            image.radiance[i]
        );
    }
    Ok(())
}

fn only_what_was_asked_for(context: &Arc<GpuContext>) -> Result<(), Failed> {
    let mut scene = glowing_room(OFF_CENTRE);
    scene.lights.push(point());
    let uploaded = GpuScene::new(context, &scene)?;
    let all = capture(context, &scene, everything(8))?;
    for bits in 0..8 {
        let asked = |bit: u32| bits >> bit & 1 == 1;
        let spec = CubeSpec {
            size: 8,
            channels: CubeChannels {
                radiance: asked(0),
                distance: asked(1),
                normal: asked(2),
            },
            bounces: 0,
        };
        let origin = scene.reference_point;
        let (cube, _) = context.record("capture", |cx| {
            capture_cube(cx, &uploaded, origin, spec, None)
        })?;
        ensure!(
            cube.radiance_distance().is_some() == (asked(0) || asked(1)),
            "{spec:?}"
        );
        ensure!(cube.normal().is_some() == asked(2), "{spec:?}");
        let image = cube.download(context)?;
        ensure!(image.spec() == spec, "{:?} for {spec:?}", image.spec());
        ensure!(
            !asked(0) || image.radiance == all.radiance,
            "radiance of {spec:?}"
        );
        ensure!(
            !asked(1) || image.distance == all.distance,
            "distance of {spec:?}"
        );
        ensure!(
            !asked(2) || image.normal == all.normal,
            "normal of {spec:?}"
        );
    }
    Ok(())
}

fn receivers_are_absent(context: &Arc<GpuContext>) -> Result<(), Failed> {
    let without = lit_room(point());
    let mut with = without.clone();
    let receiver = with.objects.last().map(|o| Object {
        role: Role::Receiver,
        ..o.clone()
    });
    // A copy of the occluder, shrunk towards the reference point: it would hide and shade much.
    with.objects.extend(receiver.map(|mut r| {
        r.mesh.positions.iter_mut().for_each(|p| *p *= 0.5);
        r
    }));
    let spec = everything(32);
    ensure!(
        capture(context, &with, spec)? == capture(context, &without, spec)?,
        "the receiver shows"
    );
    Ok(())
}

/// An image whose neighbouring texels differ by at most 1.
fn pattern(width: u32, height: u32) -> LatLongImage {
    let texel = |i: u32| {
        let (x, y) = (i % width, i / width);
        let wave = |k: u32| ((x * 7 + y * 13 + k * 5) % 11) as f32 / 10.0;
        Vec3::new(wave(0), wave(1), wave(2))
    };
    LatLongImage {
        width,
        height,
        texels: (0..width * height).map(texel).collect(),
    }
}

fn environment_matches_host(context: &Arc<GpuContext>) -> Result<(), Failed> {
    for (width, height, rotate_deg) in [(8, 4, 0.0), (13, 6, 37.0), (1, 1, 0.0), (64, 32, -200.0)] {
        let environment = Environment {
            image: pattern(width, height),
            scale: 2.5,
            rotate_deg,
        };
        let mut scene = empty(OFF_CENTRE);
        scene.environment = Some(environment.clone());
        let image = capture(context, &scene, everything(32))?;
        // Radiance changes by at most 2 · scale per texel and coordinate. WGSL's atan2 is good to
        // 4096 roundings of f32 (2.4e-4 of π at worst); the host's acos loses as much at the poles.
        let texels_per_radian = (width as f32).max(1.0) / std::f32::consts::PI;
        let tolerance = 5.0 * texels_per_radian * 5e-4;
        for (i, direction) in texels(32) {
            let expected = environment.radiance(direction.as_vec3());
            let error = (image.radiance[i] - expected).abs().max_element();
            ensure!(
                error < tolerance,
                "{width}×{height}, texel {i}: off by {error} of {expected}"
            );
            ensure!(
                image.distance[i] == f32::INFINITY,
                "texel {i}: {}",
                image.distance[i]
            );
            ensure!(
                image.normal[i] == Vec3::ZERO,
                "texel {i}: {}",
                image.normal[i]
            );
        }
    }
    Ok(())
}

fn images_survive_the_round_trip(context: &Arc<GpuContext>) -> Result<(), Failed> {
    let mut scene = lit_room(point());
    scene.environment = Some(Environment::constant(Vec3::new(1.0, 2.0, 3.0)));
    // 7 texels: rows of no round number of bytes.
    let image = capture(context, &scene, everything(7))?;
    let misses = image.distance.iter().filter(|d| d.is_infinite()).count();
    ensure!(misses > 0 && misses < image.texels(), "{misses} misses");
    let back = GpuCube::upload(context, &image)?.download(context)?;
    ensure!(back == image, "the image changed");
    Ok(())
}

fn threads_agree(context: &Arc<GpuContext>) -> Result<(), Failed> {
    let scene = lit_room(point());
    let alone = capture(context, &scene, everything(32))?;
    let images: Vec<_> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..8)
            .map(|i| {
                let scene = &scene;
                scope.spawn(move || match i % 2 {
                    0 => capture(context, scene, everything(32)),
                    _ => capture(&GpuContext::new(None)?, scene, everything(32)),
                })
            })
            .collect();
        threads
            .into_iter()
            .map(std::thread::ScopedJoinHandle::join)
            .collect()
    });
    for image in images {
        let image = image.map_err(|_| "a thread panicked")??;
        ensure!(image == alone, "a thread captured something else");
    }
    Ok(())
}
