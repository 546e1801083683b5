//! Depth maps, occlusion queries and rays against each other, direction by direction.

use super::{AO, VERTICES, small};
use crate::ensure;
use crate::subjects::Subject;
use crate::world::{CPU, Outcome, cpu_stage, gpu_stage};
use interreflect::view::View;
use interreflect_estimators::directional_ao::{
    Bias, CpuState, DIRECTIONS, DirectionalAo, DirectionalAoParams, GpuState, Visibility,
    directions,
};
use interreflect_estimators::stage::Stage;
use interreflect_estimators::{Changed, Cpu, Estimator, Gpu, Inputs, Method};
use interreflect_gpu::GpuContext;
use interreflect_scene::{Estimate, LANES, PointLayout, Points, SceneRequest, open};
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

/// On the vertices of a built-in shape or a model from a file, in 18 directions: occlusion queries and depth maps decide alike but
/// where a drawn point, snapped to a 256th of a texel, falls into the next one, and both as rays do but where a texel is too
/// coarse: along silhouettes and in grazing light.
pub(super) fn ways_agree(context: &Arc<GpuContext>, model: &Path) -> Outcome {
    let scene = open(&SceneRequest {
        receivers: vec![model.to_string_lossy().into_owned()],
        ..SceneRequest::new("studio")
    })?;
    let level = 1;
    let mut subject = Subject::new("model", &scene, Vec::new());
    let view = View::with(&subject.cpu, &small(scene.camera), VERTICES)?;
    // Every fourth vertex: queries are slow.
    let vertices = view.points(PointLayout::Surface);
    subject.set_points(vertices.iter().step_by(4).collect());
    let points = subject.points(PointLayout::Surface);
    let bits_by = |visibility, gpu: bool| {
        let params = DirectionalAoParams {
            level: level as u32,
            visibility,
            map_resolution: 1024,
            bias: Bias::PolygonOffset,
            ..DirectionalAoParams::default()
        };
        match gpu {
            false => cpu_bits(&subject, &points, &params),
            true => gpu_bits(context, &subject, &points, &params),
        }
    };
    let seen = Seen {
        points: &points,
        level,
    };
    let rays = bits_by(Visibility::Rays, false)?;
    let maps = bits_by(Visibility::DepthMap, false)?;
    let gpu_maps = bits_by(Visibility::DepthMap, true)?;
    let queries = bits_by(Visibility::Queries, true)?;
    let count = DIRECTIONS[level];
    println!("{} points, {count} directions", points.len());
    for (name, a, b, apart_max, blunt_max) in [
        ("CPU and GPU depth maps", &maps, &gpu_maps, 2e-3, 1e-3),
        (
            "GPU depth maps and queries",
            &gpu_maps,
            &queries,
            1e-3,
            1e-3,
        ),
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

fn cpu_bits(
    subject: &Subject,
    points: &Points,
    params: &DirectionalAoParams,
) -> Result<Vec<u32>, Failed> {
    let stage = cpu_stage(subject);
    let (facts, mut state) = (subject.cpu.scene().facts(), CpuState::default());
    let needs = DirectionalAo::needs(params, AO, &facts)?;
    let captures = stage.capture(&needs)?.0;
    let origin = (facts, subject.cpu.scene().reference_point);
    let inputs = Inputs::<Cpu>::new(&needs, &captures, points, points, origin, Changed::ALL);
    let out = Estimate::new(points.len());
    <DirectionalAo as Estimator<Cpu>>::prepare(params, &mut state, &mut &*CPU, AO, &inputs, &out)?;
    Ok(state.bits().to_vec())
}

fn gpu_bits(
    context: &Arc<GpuContext>,
    subject: &Subject,
    points: &Points,
    params: &DirectionalAoParams,
) -> Result<Vec<u32>, Failed> {
    let stage = gpu_stage(context, subject)?;
    let (facts, mut state) = (subject.cpu.scene().facts(), GpuState::default());
    let needs = DirectionalAo::needs(params, AO, &facts)?;
    let captures = stage.capture(&needs)?.0;
    let placed = stage.place(points)?;
    let origin = (facts, subject.cpu.scene().reference_point);
    let inputs = Inputs::<Gpu>::new(
        &needs,
        &captures,
        &placed.points,
        points,
        origin,
        Changed::ALL,
    );
    stage.timed("prepare", &mut |cx| {
        <DirectionalAo as Estimator<Gpu>>::prepare(params, &mut state, cx, AO, &inputs, &placed.out)
    })?;
    Ok(state.bits(context)?)
}
