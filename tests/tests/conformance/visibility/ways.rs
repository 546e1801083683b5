//! Depth maps, occlusion queries and rays against each other, direction by direction.

use super::{AO, VERTICES, small};
use crate::ensure;
use crate::test_scenes::TestScene;
use crate::variants::{Outcome, configured, cpu_scene, gpu_scene};
use interreflect::view::View;
use interreflect_estimators::directional_ao::{DIRECTIONS, directions};
use interreflect_estimators::execution::BackendScene;
use interreflect_estimators::{Changed, Configured};
use interreflect_gpu::{GpuContext, QUERIED_AT_ONCE};
use interreflect_scene::{LANES, PointLayout, Points, SceneRequest, open};
use libtest_mimic::Failed;
use std::path::Path;
use std::sync::Arc;

/// Bits of the directions of a level at points with a normal towards them.
struct Seen<'a> {
    points: &'a Points,
    level: usize,
}

impl Seen<'_> {
    /// How many of the open half-spheres' directions two ways find different, how many of these graze
    /// (the cosine is below a tenth), and how many there are.
    fn apart(&self, a: &[u32], b: &[u32]) -> [usize; 3] {
        let stride = self.points.block_count() * LANES;
        let directions = directions(self.level as u32);
        let (mut apart, mut grazing, mut all) = (0, 0, 0);
        for (i, point) in self.points.iter().enumerate() {
            let Some(point) = point else { continue };
            for (j, towards) in directions.iter().enumerate() {
                let cosine = point.normal.dot(*towards);
                if cosine <= 0.0 {
                    continue;
                }
                let bit = |bits: &[u32]| bits[j / 32 * stride + i] >> (j % 32) & 1;
                all += 1;
                if bit(a) != bit(b) {
                    apart += 1;
                    grazing += usize::from(cosine < 0.1);
                }
            }
        }
        [apart, grazing, all]
    }
}

/// On the vertices of a built-in shape or a model from a file, in 18 directions: occlusion queries and
/// depth maps decide alike but where a drawn point, rounded to a 256th of a texel, falls into the next
/// one, the backends too but where rounding decides, and all as rays do but where a texel is too coarse:
/// along silhouettes and in grazing light.
pub(super) fn ways_agree(context: &Arc<GpuContext>, model: &Path) -> Outcome {
    let scene = open(&SceneRequest {
        receivers: vec![model.to_string_lossy().into_owned()],
        ..SceneRequest::new("studio")
    })?;
    let level = 1;
    let mut test_scene = TestScene::new("model", &scene, Vec::new());
    let view = View::new(&test_scene.cpu, &small(scene.camera), VERTICES)?;
    // Some vertices, for queries are slow, but more than are queried at a time.
    let vertices = view.points(PointLayout::Surface);
    let step = vertices.len() / (QUERIED_AT_ONCE + 1);
    test_scene.set_points(vertices.iter().step_by(step.max(1)).collect());
    let points = test_scene.points(PointLayout::Surface);
    let (cpu, gpu) = (cpu_scene(&test_scene), gpu_scene(context, &test_scene)?);
    let method = |visibility| {
        let level = level.to_string();
        let settings = [
            ("level", level.as_str()),
            ("visibility", visibility),
            ("map_resolution", "1024"),
            ("bias", "polygon_offset"),
        ];
        Ok::<_, Failed>(configured("directional_ao", AO, &settings)?.method)
    };
    let seen = Seen {
        points: &points,
        level,
    };
    let rays = bits(&cpu, &*method("rays")?, &points)?;
    let maps = bits(&cpu, &*method("depth_map")?, &points)?;
    let gpu_maps = bits(&gpu, &*method("depth_map")?, &points)?;
    let queries = bits(&cpu, &*method("queries")?, &points)?;
    let gpu_queries = bits(&gpu, &*method("queries")?, &points)?;
    let count = DIRECTIONS[level];
    println!("{} points, {count} directions", points.len());
    for (name, a, b, apart_max, blunt_max) in [
        ("CPU and GPU depth maps", &maps, &gpu_maps, 2e-3, 1e-3),
        (
            "GPU depth maps and queries",
            &gpu_maps,
            &gpu_queries,
            1e-3,
            1e-3,
        ),
        ("CPU depth maps and queries", &maps, &queries, 1e-3, 1e-3),
        ("CPU and GPU queries", &queries, &gpu_queries, 2e-3, 1e-3),
        ("queries and rays", &queries, &rays, 3e-2, 1.5e-2),
        ("depth maps and rays", &maps, &rays, 3e-2, 1.5e-2),
    ] {
        let [apart, grazing, all] = seen.apart(a, b);
        println!("{name}: {apart} of {all} apart, {grazing} of them grazing");
        let share = |n: usize| n as f64 / all as f64;
        ensure!(
            share(apart) < apart_max && share(apart - grazing) < blunt_max,
            "{name}: {apart} of {all} apart, {grazing} of them grazing"
        );
    }
    Ok(())
}

/// The visibility bits that a session shows of itself.
fn bits<S: BackendScene>(
    loaded: &S,
    method: &dyn Configured,
    points: &Points,
) -> Result<Vec<u32>, Failed> {
    let mut executor = loaded.executor(method, AO, points)?;
    executor.prepare(Changed::ALL)?;
    let records = executor.records()?;
    let found = records.iter().find(|r| r.name == "visibility bits");
    let found = found.ok_or("no visibility bits")?;
    Ok(found.values.iter().map(|bits| bits.to_bits()).collect())
}
