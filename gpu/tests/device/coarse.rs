//! The coarse solution in captures, against the host's interpolation.

use crate::capture::capture;
use crate::lighting::{lit_room, point};
use crate::oracle::{empty, everything, texels};
use crate::{Case, ensure};
use glam::{DVec3, Vec3};
use interreflect_gpu::{GpuCoarseIrradiance, GpuContext, GpuError, GpuScene, capture_cube};
use interreflect_scene::{CoarseIrradiance, CubeSpec, Role, Scene};
use libtest_mimic::Failed;
use std::sync::Arc;

pub(crate) const CASES: &[Case] = &[
    (
        "coarse::interpolated_as_on_the_host",
        interpolated_as_on_the_host,
    ),
    ("coarse::wrong_ones_are_refused", wrong_ones_are_refused),
];

/// A solution whose irradiance differs from vertex to vertex and from side to side.
fn made_up(scene: &Scene, bounces: u32) -> CoarseIrradiance {
    let mut coarse = CoarseIrradiance::dark(scene, bounces);
    let side = |i: usize| Vec3::new((i % 7) as f32, (i % 11) as f32, (i % 13) as f32);
    let count = coarse.values().len();
    coarse.set_values((0..count).map(|i| [side(2 * i), side(2 * i + 1)]));
    coarse
}

/// Weights of corners 1 and 2 of the nearest triangle that a ray meets, its index and side, and the smallest
/// weight.
fn met(scene: &Scene, origin: DVec3, direction: DVec3) -> Option<(u32, [f32; 2], bool, f64)> {
    let objects = scene.objects_of(Role::Environment);
    let triangles = objects.flat_map(|o| (0..o.mesh.triangles.len()).map(|t| o.mesh.corners(t)));
    let hit = |(index, corners): (u32, [Vec3; 3])| {
        let [a, b, c] = corners.map(|p| p.as_dvec3());
        let area = (b - a).cross(c - a);
        let distance = area.dot(a - origin) / area.dot(direction);
        let x = origin + direction * distance;
        let weight = |p: DVec3, q: DVec3| (q - p).cross(x - p).dot(area) / area.length_squared();
        let (v, w) = (weight(c, a), weight(a, b));
        let inside = v.min(w).min(1.0 - v - w);
        let front = area.dot(direction) < 0.0;
        let met = distance > 1e-9 && inside >= 0.0;
        met.then_some((distance, (index, [v as f32, w as f32], front, inside)))
    };
    let hits = (0..).zip(triangles).filter_map(hit);
    hits.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, hit)| hit)
}

fn interpolated_as_on_the_host(context: &Arc<GpuContext>) -> Result<(), Failed> {
    for lit in [true, false] {
        let mut scene = lit_room(point());
        if !lit {
            scene.lights.clear();
        }
        // A triangle without an area is not drawn, but has a grid.
        scene.objects[1].mesh.triangles.insert(0, [0, 0, 1]);
        let material = scene.objects[1].mesh.materials[0];
        scene.objects[1].mesh.materials.push(material);
        let plain = capture(context, &scene, everything(32))?;
        let spec = CubeSpec {
            bounces: 2,
            ..everything(32)
        };
        let coarse = made_up(&scene, 2);
        let uploaded = GpuScene::new(context, &scene)?;
        let on_gpu = GpuCoarseIrradiance::upload(context, &uploaded, &coarse)?;
        let origin = scene.reference_point;
        let (cube, _) = context.record("capture", |cx| {
            capture_cube(cx, &uploaded, origin, spec, Some(&on_gpu))
        })?;
        let image = cube.download(context)?;
        ensure!(image.spec() == spec, "{:?}", image.spec());
        ensure!(
            image.distance == plain.distance && image.normal == plain.normal,
            "the surfaces moved"
        );
        let mut compared = 0;
        for (i, direction) in texels(32) {
            let Some((triangle, weights, front, inside)) =
                met(&scene, origin.as_dvec3(), direction)
            else {
                continue;
            };
            // Nearer than this to an edge the rasteriser's rounding decides.
            if inside < 1e-2 {
                continue;
            }
            let objects = scene.objects_of(Role::Environment);
            let ids: Vec<u32> = objects.flat_map(|o| o.mesh.materials.clone()).collect();
            let albedo = scene.materials[ids[triangle as usize] as usize].albedo;
            let reflected = albedo / std::f32::consts::PI * coarse.at(triangle, weights, front);
            let expected = plain.radiance[i] + reflected;
            let error = (image.radiance[i] - expected).abs().max_element();
            // Weights are interpolated in f32 between corners that may lie far beyond the face, and
            // irradiance changes by 13 within a cell of an eighth of the triangle.
            ensure!(
                error < 2e-3,
                "texel {i}, triangle {triangle} {weights:?}: {} instead of {expected}",
                image.radiance[i]
            );
            compared += 1;
        }
        ensure!(compared > 4000, "only {compared} texels were compared");
    }
    Ok(())
}

fn wrong_ones_are_refused(context: &Arc<GpuContext>) -> Result<(), Failed> {
    let scene = lit_room(point());
    let uploaded = GpuScene::new(context, &scene)?;
    let other = made_up(&empty(Vec3::ZERO), 2);
    let error = GpuCoarseIrradiance::upload(context, &uploaded, &other).err();
    ensure!(
        matches!(error, Some(GpuError::CoarseIrradiance { found: 0, .. })),
        "{error:?}"
    );
    let two = GpuCoarseIrradiance::upload(context, &uploaded, &made_up(&scene, 2))?;
    let spec = CubeSpec {
        bounces: 3,
        ..everything(4)
    };
    for (coarse, found) in [(None, 0), (Some(&two), 2)] {
        let error = context
            .record("capture", |cx| {
                capture_cube(cx, &uploaded, Vec3::ZERO, spec, coarse)
            })
            .err();
        let expected = GpuError::CoarseIrradiance {
            what: "bounces",
            found,
            expected: 3,
        };
        ensure!(error.as_ref() == Some(&expected), "{error:?}");
    }
    // Nothing to solve and nothing to draw.
    let nothing = empty(Vec3::ZERO);
    let uploaded = GpuScene::new(context, &nothing)?;
    let none = GpuCoarseIrradiance::upload(context, &uploaded, &made_up(&nothing, 3))?;
    context.record("capture", |cx| {
        capture_cube(cx, &uploaded, Vec3::ZERO, spec, Some(&none))
    })?;
    Ok(())
}
