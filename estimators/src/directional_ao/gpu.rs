//! Ambient occlusion from many directions on the GPU.

use super::environment::Blurred;
use super::progress::{Progress, Step, WORD, by_words, words};
use super::sphere::{DIRECTIONS, MAX_LEVEL, directions};
use super::{DirectionalAo, DirectionalAoParams, Visibility, environment, values};
use crate::{Estimator, EstimatorError, Gpu, Inputs, Quantity, Unsupported};
use bytemuck::{Pod, Zeroable};
use interreflect_gpu::{
    Binding, GpuContext, GpuCx, GpuDepthMaps, GpuEstimate, Kernel, MAX_QUERIES, Shader, wgsl,
    workgroup_grid,
};
use interreflect_scene::LANES;

const VISIBILITY: Shader = Shader {
    label: "directional_ao visibility",
    parts: &[
        wgsl::POINTS,
        wgsl::DIRECTIONAL,
        include_str!("math.wgsl"),
        include_str!("visibility.wgsl"),
    ],
};

const SHADE: Shader = Shader {
    label: "directional_ao shade",
    parts: &[
        wgsl::POINTS,
        include_str!("math.wgsl"),
        include_str!("shade.wgsl"),
    ],
};

const MAX_DIRECTIONS: usize = DIRECTIONS[MAX_LEVEL as usize] as usize;

/// Visibility, light and kernel, kept across frames.
#[derive(Default)]
pub struct State {
    progress: Progress,
    /// As on the CPU.
    bits: Option<wgpu::Buffer>,
    maps: Option<GpuDepthMaps>,
    blurred: Option<Blurred>,
    shade: Option<Kernel>,
}

impl State {
    /// As on the CPU, read back; empty before the first frame.
    ///
    /// # Errors
    /// [`EstimatorError`] if the device fails.
    pub fn bits(&self, context: &GpuContext) -> Result<Vec<u32>, EstimatorError> {
        match &self.bits {
            Some(bits) => Ok(context.read_buffer(bits)?),
            None => Ok(Vec::new()),
        }
    }

    /// Points that were evaluated since the start, repetitions counted.
    pub fn evaluations(&self) -> u64 {
        self.progress.todo.evaluations
    }
}

/// As `Batch` in visibility.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct Batch {
    first: u32,
    count: u32,
    word: u32,
    todo: u32,
    margin: f32,
}

/// As `Direction` in shade.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct Direction {
    towards: [f32; 3],
    pad_towards: f32,
    value: [f32; 3],
    pad_value: f32,
}

/// As `Light` in shade.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct Light {
    count: u32,
    stride: u32,
    pad: [u32; 2],
    directions: [Direction; MAX_DIRECTIONS],
}

impl Estimator<Gpu> for DirectionalAo {
    type State = State;

    const SHADERS: &'static [Shader] = &[VISIBILITY, SHADE];

    fn supports(params: &DirectionalAoParams, _caps: &GpuContext) -> Result<(), Unsupported> {
        match params.visibility {
            Visibility::Rays => Err(Unsupported(
                "directional_ao: rays are the CPU's; use visibility=depth_map or queries on the GPU"
                    .into(),
            )),
            Visibility::DepthMap | Visibility::Queries => Ok(()),
        }
    }

    fn prepare(
        params: &DirectionalAoParams,
        state: &mut State,
        cx: &mut GpuCx,
        quantity: Quantity,
        inputs: &Inputs<'_, Gpu>,
        out: &GpuEstimate,
    ) -> Result<(), EstimatorError> {
        let (steps, forget) = state.progress.begin(params, inputs);
        let context = cx.context().clone();
        let stride = inputs.host_points.block_count() * LANES;
        let count = stride * words(params.level);
        let fits = |b: &wgpu::Buffer| b.size() == 4 * count.max(1) as u64;
        match state.bits.as_ref().filter(|b| fits(b)) {
            Some(bits) if forget => cx.encoder().clear_buffer(bits, 0, None),
            Some(_) => {}
            None => {
                let zeros = context.storage_zeroed("directional_ao visibility", 4 * count as u64);
                state.bits = Some(zeros?);
            }
        }
        let bits = state.bits.as_ref().ok_or(EstimatorError::Unprepared)?;
        let maps = &mut state.maps;
        for step in &steps {
            look(params, (maps, bits, stride), cx, step, inputs)?;
        }
        let level = state.progress.level().ok_or(EstimatorError::Unprepared)?;
        let from_afar = environment(quantity, inputs)?;
        let values = values(params, level, from_afar, &mut state.blurred);
        let light = light(level, stride, &values);
        let light = context.uniform("directional_ao light", &light)?;
        let [points, info, estimate] = inputs.points.bindings(out);
        let bindings = [points, info, estimate, (&light).into(), bits.into()];
        state.shade = Some(context.kernel(&SHADE, "shade", &bindings)?);
        Ok(())
    }

    fn shade(
        _params: &DirectionalAoParams,
        state: &mut State,
        cx: &mut GpuCx,
        _quantity: Quantity,
        inputs: &Inputs<'_, Gpu>,
        _out: &mut GpuEstimate,
    ) -> Result<(), EstimatorError> {
        let shade = state.shade.as_ref().ok_or(EstimatorError::Unprepared)?;
        shade.record(cx, inputs.points.workgroups());
        Ok(())
    }
}

fn light(level: u32, stride: usize, values: &[[f32; 3]]) -> Light {
    let mut light = Light {
        count: DIRECTIONS[level as usize],
        stride: stride as u32,
        ..Light::zeroed()
    };
    let directions = directions(level).into_iter().zip(values);
    for (slot, (towards, &value)) in light.directions.iter_mut().zip(directions) {
        *slot = Direction {
            towards: towards.to_array(),
            value,
            ..Direction::zeroed()
        };
    }
    light
}

/// Records the looks along the directions of a step, as many at a time as there are depth maps.
fn look(
    params: &DirectionalAoParams,
    (maps, bits, stride): (&mut Option<GpuDepthMaps>, &wgpu::Buffer, usize),
    cx: &mut GpuCx,
    step: &Step,
    inputs: &Inputs<'_, Gpu>,
) -> Result<(), EstimatorError> {
    let context = cx.context().clone();
    let towards = directions(MAX_LEVEL);
    let queries = params.visibility == Visibility::Queries;
    check_queries(params, step, inputs)?;
    let depths = match inputs.scene.occluders {
        true => Some(inputs.depths(&params.depths())?),
        false => None,
    };
    if depths.is_some()
        && maps
            .as_ref()
            .is_none_or(|m| m.size() != params.map_resolution)
    {
        *maps = Some(GpuDepthMaps::new(&context, params.map_resolution)?);
    }
    let todo = context.storage("directional_ao points", &step.points)?;
    for range in by_words(step.directions.clone()) {
        let count = range.len() as u32;
        let batch = Batch {
            first: (range.start % WORD) as u32,
            count,
            word: (range.start / WORD * stride) as u32,
            todo: step.points.len() as u32,
            margin: params.margin(),
        };
        let batch = context.uniform("directional_ao batch", &batch)?;
        let [points, info] = inputs.points.inputs();
        let mut bindings = [Binding::None; 9];
        (bindings[0], bindings[1]) = (points, info);
        bindings[5..8].copy_from_slice(&[(&todo).into(), bits.into(), (&batch).into()]);
        let groups = workgroup_grid(step.points.len().div_ceil(LANES));
        let (Some(depths), Some(maps)) = (depths, maps.as_ref()) else {
            context
                .kernel(&VISIBILITY, "all_open", &bindings)?
                .record(cx, groups);
            continue;
        };
        let frames = depths.record(cx, maps, &towards[range])?;
        (bindings[3], bindings[4]) = ((&frames).into(), maps.view().into());
        let answers;
        let entry = match queries {
            true => {
                answers = depths.queries(cx, maps, (&frames, count), inputs.points)?;
                bindings[8] = (&answers).into();
                "take_answers"
            }
            false => "look_into_maps",
        };
        context
            .kernel(&VISIBILITY, entry, &bindings)?
            .record(cx, groups);
    }
    Ok(())
}

/// A driver answers each query by itself: where there are too many, a look into the map is the way.
fn check_queries(
    params: &DirectionalAoParams,
    step: &Step,
    inputs: &Inputs<'_, Gpu>,
) -> Result<(), EstimatorError> {
    let (points, directions) = (inputs.points.len(), step.directions.len());
    let queries = points * directions;
    if params.visibility != Visibility::Queries || queries <= MAX_QUERIES {
        return Ok(());
    }
    Err(EstimatorError::Unsupported(Unsupported(format!(
        "directional_ao: {points} points in {directions} directions take {queries} occlusion \
         queries, and beyond {MAX_QUERIES} a driver answers too slowly; use visibility=depth_map, a \
         lower level or fewer points"
    ))))
}

#[cfg(test)]
mod tests {
    use super::super::math::DEPTH_ROUNDING;
    use super::{Batch, Direction, Light, MAX_DIRECTIONS, SHADE, VISIBILITY};
    use crate::layout::{assert_layout, constant, constant_u32, module};

    #[test]
    fn structs_and_constants_are_the_same() {
        assert_layout!(VISIBILITY, Batch, [first, count, word, todo, margin]);
        let direction = crate::layout::layout(&module(&SHADE), "Direction");
        let offsets = [
            ("towards", 0),
            ("value", std::mem::offset_of!(Direction, value)),
        ];
        let offsets = offsets.map(|(name, offset)| (name.to_owned(), offset));
        assert_eq!(direction, (size_of::<Direction>(), offsets.to_vec()));
        let light = crate::layout::layout(&module(&SHADE), "Light");
        let at = light.1.iter().find(|m| m.0 == "directions").map(|m| m.1);
        assert_eq!(light.0, size_of::<Light>());
        assert_eq!(at, Some(std::mem::offset_of!(Light, directions)));
        let shade = module(&SHADE);
        assert_eq!(
            constant_u32(&shade, "MAX_DIRECTIONS") as usize,
            MAX_DIRECTIONS
        );
        assert_eq!(constant(&shade, "DEPTH_ROUNDING"), DEPTH_ROUNDING);
    }
}
