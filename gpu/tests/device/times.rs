//! Times contain the work that they are the times of.
//!
//! Bounds are wide enough for any machine under any load: they tell work that was measured from
//! work that was missed, not fast from slow.

use crate::capture::capture;
use crate::lighting::{lit_room, point};
use crate::oracle::everything;
use crate::{Case, ensure};
use glam::Vec3;
use interreflect_gpu::{GpuContext, GpuCx, GpuError, GpuScene, Shader, capture_cube};
use libtest_mimic::Failed;
use std::sync::Arc;
use std::time::Instant;

pub(crate) const CASES: &[Case] = &[
    ("times::one_dispatch", one_dispatch),
    ("times::several_dispatches", several_dispatches),
    ("times::split_recordings", split_recordings),
    ("times::rendering_counts", rendering_counts),
    ("times::nothing_takes_no_time", nothing_takes_no_time),
];

const CHAIN: Shader = Shader {
    label: "times test",
    parts: &[include_str!("times.wgsl")],
};

/// Turns of the long chain, and how many times fewer the short one has. The short one still takes
/// milliseconds: what a driver needs for four submissions is small beside it.
const TURNS: u32 = 64_000;
const RATIO: u32 = 64;

/// A turn is 256 products, each with a sum that waits for it: two clock cycles at least. No
/// processor has 10 GHz.
const TURN_AT_LEAST_MS: f64 = 256.0 * 2.0 / 10e9 * 1e3;

fn one_dispatch(context: &Arc<GpuContext>) -> Result<(), Failed> {
    grows_with_work(context, 1, |_| {})
}

fn several_dispatches(context: &Arc<GpuContext>) -> Result<(), Failed> {
    grows_with_work(context, 4, |_| {})
}

fn split_recordings(context: &Arc<GpuContext>) -> Result<(), Failed> {
    grows_with_work(context, 4, GpuCx::split)
}

/// Times `dispatches` chains that wait for each other, short and long, after a capture: drivers may
/// treat timestamps otherwise once something was rendered.
fn grows_with_work(
    context: &Arc<GpuContext>,
    dispatches: u32,
    between: impl Fn(&mut GpuCx),
) -> Result<(), Failed> {
    capture(context, &a_room(), everything(64))?;
    let time = |turns: u32| -> Result<f64, Failed> {
        let buffer = context.storage("chains", &[1_u32; 64])?;
        let turns = context.uniform("turns", &[turns, 0, 0, 0])?;
        let kernel = context.kernel(&CHAIN, "chain", &[(&buffer).into(), (&turns).into()])?;
        timed(context, |cx| {
            for _ in 0..dispatches {
                kernel.record(cx, [1, 1, 1]);
                between(cx);
            }
            Ok(())
        })
    };
    time(1)?;
    let turns = TURNS / dispatches;
    let long = time(turns)?;
    let at_least = f64::from(TURNS) * TURN_AT_LEAST_MS;
    ensure!(
        long >= at_least,
        "{TURNS} turns in {long} ms; they take {at_least} ms at least"
    );
    let most = long / f64::from(RATIO / 4);
    let short = shortest(most, || time(turns / RATIO))?;
    ensure!(
        short <= most,
        "{long} ms for {RATIO} times the work of {short} ms"
    );
    Ok(())
}

fn rendering_counts(context: &Arc<GpuContext>) -> Result<(), Failed> {
    let mut room = a_room();
    // Shadow maps take the same time whatever the capture's size.
    room.lights.clear();
    let scene = GpuScene::new(context, &room)?;
    let time = |size| {
        timed(context, |cx| {
            capture_cube(cx, &scene, Vec3::ZERO, everything(size), None).map(drop)
        })
    };
    time(32)?;
    let long = time(1024)?;
    let short = shortest(long / 4.0, || time(32))?;
    ensure!(
        short <= long / 4.0,
        "{long} ms for 1024 times the texels of {short} ms"
    );
    Ok(())
}

fn nothing_takes_no_time(context: &Arc<GpuContext>) -> Result<(), Failed> {
    capture(context, &a_room(), everything(64))?;
    let most = 1.0;
    let overhead = shortest(most, || timed(context, |_| Ok(())))?;
    ensure!(overhead <= most, "{overhead} ms for no work");
    Ok(())
}

/// The shortest of several times, as soon as it is short enough: another test, or another process,
/// may hold the device or the processor up.
fn shortest(enough: f64, mut time: impl FnMut() -> Result<f64, Failed>) -> Result<f64, Failed> {
    let mut shortest = f64::INFINITY;
    for _ in 0..100 {
        shortest = shortest.min(time()?);
        if shortest <= enough {
            break;
        }
    }
    Ok(shortest)
}

fn a_room() -> interreflect_scene::Scene {
    lit_room(point())
}

/// Milliseconds of recorded work; never more than the call itself takes.
fn timed(
    context: &Arc<GpuContext>,
    work: impl FnOnce(&mut GpuCx) -> Result<(), GpuError>,
) -> Result<f64, Failed> {
    let start = Instant::now();
    let ((), time) = context.record("times test", work)?;
    let wall_ms = start.elapsed().as_secs_f64() * 1e3;
    let ms = time.ms();
    ensure!(ms <= wall_ms, "{ms} ms on the GPU within {wall_ms} ms");
    // The software driver that tests run on has timestamps; elsewhere either clock will do.
    ensure!(
        time.device_ms.is_ok() || !context.info().software,
        "{:?} on {:?}",
        time.device_ms,
        context.info()
    );
    Ok(ms)
}
