//! Points, kernels, times and read-back.

use crate::{Case, ensure};
use glam::{DVec3, Vec3, Vec4};
use interreflect_gpu::{Binding, GpuContext, GpuError, GpuEstimate, GpuPoints, Shader, wgsl};
use interreflect_scene::{LANES, Point, PointLayout, Points, SurfaceMaterial, conventions};
use libtest_mimic::Failed;
use std::sync::Arc;

pub(crate) const CASES: &[Case] = &[
    (
        "compute::points_arrive_and_estimates_return",
        points_arrive_and_estimates_return,
    ),
    (
        "compute::cube_functions_match_the_host",
        cube_functions_match_the_host,
    ),
    (
        "compute::split_orders_writes_and_work",
        split_orders_writes_and_work,
    ),
    (
        "compute::large_buffers_are_read_in_chunks",
        large_buffers_are_read_in_chunks,
    ),
    (
        "compute::pipelines_are_built_once",
        pipelines_are_built_once,
    ),
    (
        "compute::constants_make_other_pipelines",
        constants_make_other_pipelines,
    ),
    ("compute::devices_can_be_shared", devices_can_be_shared),
];

const POINTS: Shader = Shader {
    label: "points test",
    parts: &[wgsl::POINTS, include_str!("points.wgsl")],
};

const CUBE: Shader = Shader {
    label: "cube test",
    parts: &[wgsl::MATH, wgsl::CUBE, include_str!("cube.wgsl")],
};

fn point(i: usize) -> Point {
    let vector = |k: f32| Vec3::new(i as f32 + k, 2.0 * i as f32 - k, 0.5 * k);
    Point {
        position: vector(1.0),
        normal: vector(2.0),
        view: vector(3.0),
        material: SurfaceMaterial {
            diffuse: vector(4.0),
            specular: vector(5.0),
            shininess: 3.0 * i as f32,
        },
        footprint: 0.5 * i as f32,
    }
}

fn points_arrive_and_estimates_return(context: &Arc<GpuContext>) -> Result<(), Failed> {
    for (layout, entry) in [
        (PointLayout::Surface, "surface"),
        (PointLayout::Material, "material"),
    ] {
        for len in [0, 1, LANES, 1000] {
            let points = Points::new(layout, (0..len).map(|i| (i % 7 != 3).then(|| point(i))));
            let uploaded = GpuPoints::upload(context, &points)?;
            let estimate = GpuEstimate::new(context, len)?;
            let kernel = context.kernel(&POINTS, entry, &uploaded.bindings(&estimate))?;
            context.record("points", |cx| {
                kernel.record(cx, uploaded.workgroups());
                Ok::<_, GpuError>(())
            })?;
            let result = estimate.download(context)?;
            ensure!(result.len() == len, "{} of {len} points", result.len());
            for i in 0..len {
                let expected = match (points.get(i), layout) {
                    (None, _) => Vec3::splat(-1.0),
                    (Some(p), PointLayout::Surface) => p.position + 10.0 * p.normal,
                    (Some(p), PointLayout::Material) => {
                        let m = p.material;
                        let lobe = 1000.0 * m.shininess + 10_000.0 * p.footprint;
                        p.view + 10.0 * m.diffuse + 100.0 * m.specular + lobe
                    }
                };
                let error = (result.get(i) - expected).abs().max_element();
                ensure!(
                    error <= 1e-6 * expected.abs().max_element(),
                    "{entry} {i}: {} instead of {expected}",
                    result.get(i)
                );
            }
        }
    }
    Ok(())
}

fn cube_functions_match_the_host(context: &Arc<GpuContext>) -> Result<(), Failed> {
    const SIZE: u32 = 9;
    let texels = 6 * (SIZE * SIZE) as usize;
    let out = context.storage_zeroed("out", texels as u64 * 32)?;
    let kernel = context.kernel(&CUBE, "texels", &[Binding::Buffer(&out)])?;
    context.record("texels", |cx| {
        kernel.record(cx, [SIZE, SIZE, 6]);
        Ok::<_, GpuError>(())
    })?;
    let values: Vec<[Vec4; 2]> = context.read_buffer(&out)?;
    for face in 0..6 {
        for (row, column) in (0..SIZE).flat_map(|r| (0..SIZE).map(move |c| (r, c))) {
            let [vector, found] = values[conventions::texel_index(SIZE, face, column, row)];
            let s = conventions::texel_centre(SIZE, column);
            let t = conventions::texel_centre(SIZE, row);
            let expected = conventions::cube_vector(face, s, t);
            ensure!(
                close(vector.truncate().as_dvec3(), expected, 1e-6),
                "{vector} instead of {expected}"
            );
            let (f, s2, t2) = conventions::cube_coordinates(expected * 3.0);
            let coordinates = DVec3::new(f64::from(vector.w), found.x.into(), found.y.into());
            ensure!(
                close(coordinates, DVec3::new(f as f64, s2, t2), 1e-6),
                "{coordinates} for {expected}"
            );
            ensure!(
                found.z == column as f32 && found.w == row as f32,
                "texel_at gives {found}"
            );
        }
    }
    Ok(())
}

fn close(a: DVec3, b: DVec3, tolerance: f64) -> bool {
    (a - b).abs().max_element() <= tolerance
}

fn split_orders_writes_and_work(context: &Arc<GpuContext>) -> Result<(), Failed> {
    let sum = context.storage("sum", &[0_u32; 4])?;
    let step = context.uniform("step", &[1_u32, 0, 0, 0])?;
    let bindings = [Binding::None, Binding::None, (&sum).into(), (&step).into()];
    let kernel = context.kernel(&CUBE, "append", &bindings)?;
    context.record("steps", |cx| {
        for digit in 1..=4_u32 {
            context.write(&step, &[digit])?;
            kernel.record(cx, [1, 1, 1]);
            cx.split();
        }
        Ok::<_, GpuError>(())
    })?;
    let result: Vec<u32> = context.read_buffer(&sum)?;
    ensure!(result[0] == 1234, "{result:?}");
    Ok(())
}

fn large_buffers_are_read_in_chunks(context: &Arc<GpuContext>) -> Result<(), Failed> {
    // 40 MiB: two whole chunks and a half.
    let values: Vec<u32> = (0..10 << 20).collect();
    let buffer = context.storage("large", &values)?;
    ensure!(
        context.read_buffer::<u32>(&buffer)? == values,
        "the values changed"
    );
    Ok(())
}

fn pipelines_are_built_once(context: &Arc<GpuContext>) -> Result<(), Failed> {
    // A context of its own: other tests build pipelines on the shared one.
    let context = GpuContext::from_device(context.device().clone(), context.queue().clone());
    let buffer = context.storage_zeroed("out", 64)?;
    for _ in 0..3 {
        context.kernel(&CUBE, "constant", &[Binding::None, (&buffer).into()])?;
    }
    let stats = context.cache_stats();
    ensure!(stats.misses == 1 && stats.ms > 0.0, "{stats:?}");
    Ok(())
}

fn constants_make_other_pipelines(context: &Arc<GpuContext>) -> Result<(), Failed> {
    let buffer = context.storage_zeroed("out", 16)?;
    let bindings = [Binding::None, (&buffer).into()];
    for value in [3.0, 4.5] {
        let kernel = context.kernel_with(&CUBE, "constant", &[("factor", value)], &bindings)?;
        context.record("constant", |cx| {
            kernel.record(cx, [1, 1, 1]);
            Ok::<_, GpuError>(())
        })?;
        let found: Vec<f32> = context.read_buffer(&buffer)?;
        ensure!(f64::from(found[0]) == 2.0 * value, "{found:?}");
    }
    Ok(())
}

fn devices_can_be_shared(context: &Arc<GpuContext>) -> Result<(), Failed> {
    let shared = GpuContext::from_device(context.device().clone(), context.queue().clone());
    ensure!(shared.info() == context.info(), "{:?}", shared.info());
    Ok(())
}
