//! Ambient occlusion from many directions on the GPU.

use super::environment::Blurred;
use super::progress::{Progress, Step, WORD, by_words, words};
use super::sphere::{DIRECTIONS, MAX_LEVEL};
use super::{DirectionalAo, Visibility, environment, least_cosine, record_names, values};
use crate::{Estimator, EstimatorError, Frame, Gpu, Kernels, Records, Unsupported};
use bytemuck::{Pod, Zeroable};
use glam::Vec3;
use interreflect_gpu::{
    Binding, GpuContext, GpuDepthMaps, Kernel, QUERIED_AT_ONCE, Shader, wgsl, workgroup_grid,
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

/// Visibility, light and kernel.
pub struct Openness {
    progress: Progress,
    /// As on the CPU.
    bits: wgpu::Buffer,
    maps: Option<GpuDepthMaps>,
    blurred: Option<Blurred>,
    shade: Kernel,
}

/// As `Batch` in visibility.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct Batch {
    first: u32,
    count: u32,
    word: u32,
    first_point: u32,
    points: u32,
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
    least: f32,
    pad: u32,
    directions: [Direction; MAX_DIRECTIONS],
}

impl Estimator<Gpu> for DirectionalAo {
    type Prepared = Openness;

    const SHADERS: &'static [Shader] = &[VISIBILITY, SHADE];

    fn supports(&self, _caps: &GpuContext) -> Result<(), Unsupported> {
        match self.visibility {
            Visibility::Rays => Err(Unsupported(
                "directional_ao: rays are the CPU's; use visibility=depth_map or queries on the GPU"
                    .into(),
            )),
            Visibility::DepthMap | Visibility::Queries => Ok(()),
        }
    }

    fn prepare(
        &self,
        frame: &mut Frame<'_, Gpu>,
        last: Option<Openness>,
    ) -> Result<Openness, EstimatorError> {
        let (mut progress, bits, mut maps, mut blurred) = match last {
            Some(last) => (last.progress, Some(last.bits), last.maps, last.blurred),
            None => (Progress::default(), None, None, None),
        };
        let begun = progress.begin(self, frame);
        let context = frame.context().clone();
        let stride = frame.host_points.block_count() * LANES;
        let count = stride * words(self.level);
        let fits = |b: &wgpu::Buffer| b.size() == 4 * count.max(1) as u64;
        let bits = match bits.filter(fits) {
            Some(bits) => {
                if begun.forget {
                    frame.cx.encoder().clear_buffer(&bits, 0, None);
                }
                bits
            }
            None => context.storage_zeroed("directional_ao visibility", 4 * count as u64)?,
        };
        let towards = begun.directions(MAX_LEVEL);
        for step in &begun.steps {
            self.look(frame, (&mut maps, &bits, stride), (step, &towards))?;
        }
        let towards = begun.directions(begun.level);
        let environment = environment(frame)?;
        let values = values(self, (begun.level, &towards), environment, &mut blurred);
        let light = light(&towards, &values, (stride, least_cosine(self)));
        let light = context.uniform("directional_ao light", &light)?;
        let [points, info, estimate] = frame.point_bindings();
        let bindings = [points, info, estimate, (&light).into(), (&bits).into()];
        let shade = context.kernel(&SHADE, "shade", &bindings)?;
        Ok(Openness {
            progress,
            bits,
            maps,
            blurred,
            shade,
        })
    }
}

impl Kernels for Openness {
    fn kernels(&self) -> &[Kernel] {
        std::slice::from_ref(&self.shade)
    }

    fn records(&self, context: &GpuContext) -> Result<Vec<Records>, EstimatorError> {
        Ok(vec![
            Records::bits(record_names::VISIBILITY, context.read_buffer(&self.bits)?),
            Records::count(record_names::EVALUATIONS, self.progress.evaluations()),
        ])
    }
}

fn light(directions: &[Vec3], values: &[[f32; 3]], (stride, least): (usize, f32)) -> Light {
    let mut light = Light {
        count: directions.len() as u32,
        stride: stride as u32,
        least,
        ..Light::zeroed()
    };
    let directions = directions.iter().zip(values);
    for (slot, (towards, &value)) in light.directions.iter_mut().zip(directions) {
        *slot = Direction {
            towards: towards.to_array(),
            value,
            ..Direction::zeroed()
        };
    }
    light
}

impl DirectionalAo {
    /// Records the looks along the directions of a step, of which `towards` has all: as many at a time
    /// as there are depth maps.
    fn look(
        &self,
        frame: &mut Frame<'_, Gpu>,
        (maps, bits, stride): (&mut Option<GpuDepthMaps>, &wgpu::Buffer, usize),
        (step, towards): (&Step, &[Vec3]),
    ) -> Result<(), EstimatorError> {
        let (context, gpu_points) = (frame.context().clone(), frame.points);
        let depths = match frame.scene.any_surface {
            true => Some(frame.depths(&self.depths())?),
            false => None,
        };
        if depths.is_some()
            && maps
                .as_ref()
                .is_none_or(|m| m.size() != self.map_resolution)
        {
            *maps = Some(GpuDepthMaps::new(&context, self.map_resolution)?);
        }
        let todo = context.storage("directional_ao points", &step.points)?;
        for range in by_words(step.directions.clone()) {
            let rendered = match (depths, maps.as_ref()) {
                (Some(depths), Some(maps)) => {
                    let frames = depths.record(frame.cx, maps, &towards[range.clone()])?;
                    Some((depths, maps, frames))
                }
                _ => None,
            };
            let at_once = match (&rendered, self.visibility) {
                (Some(_), Visibility::Queries) => QUERIED_AT_ONCE,
                _ => step.points.len(),
            };
            for (i, points) in step.points.chunks(at_once).enumerate() {
                let batch = Batch {
                    first: (range.start % WORD) as u32,
                    count: range.len() as u32,
                    word: (range.start / WORD * stride) as u32,
                    first_point: (i * at_once) as u32,
                    points: points.len() as u32,
                    margin: self.margin(),
                };
                let batch = context.uniform("directional_ao batch", &batch)?;
                let [all, info] = gpu_points.inputs();
                let mut bindings = [Binding::None; 9];
                (bindings[0], bindings[1]) = (all, info);
                bindings[5..8].copy_from_slice(&[(&todo).into(), bits.into(), (&batch).into()]);
                let answers;
                let entry = match &rendered {
                    None => "all_open",
                    Some((depths, maps, frames)) => {
                        (bindings[3], bindings[4]) = (frames.into(), maps.view().into());
                        match self.visibility {
                            Visibility::Queries => {
                                let asked = (gpu_points, points);
                                let recorded = (*maps, frames, range.len() as u32);
                                answers =
                                    depths.queries(frame.cx, recorded, asked, self.margin())?;
                                bindings[8] = (&answers).into();
                                "take_answers"
                            }
                            _ => "look_into_maps",
                        }
                    }
                };
                let groups = workgroup_grid(points.len().div_ceil(LANES));
                context
                    .kernel(&VISIBILITY, entry, &bindings)?
                    .record(frame.cx, groups);
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::math::DEPTH_ROUNDING;
    use super::{Batch, Direction, Light, MAX_DIRECTIONS, SHADE, VISIBILITY};
    use interreflect_gpu::layout::assert_layout;
    use interreflect_gpu::layout::{constant, constant_u32, module};

    #[test]
    fn structs_and_constants_are_the_same() {
        assert_layout!(
            VISIBILITY,
            Batch,
            [first, count, word, first_point, points, margin]
        );
        let direction = interreflect_gpu::layout::layout(&module(&SHADE), "Direction");
        let offsets = [
            ("towards", 0),
            ("value", std::mem::offset_of!(Direction, value)),
        ];
        let offsets = offsets.map(|(name, offset)| (name.to_owned(), offset));
        assert_eq!(direction, (size_of::<Direction>(), offsets.to_vec()));
        let light = interreflect_gpu::layout::layout(&module(&SHADE), "Light");
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
