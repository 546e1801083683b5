//! `reference`: the truth with its standard error.

use super::{load, print_json, print_line};
use crate::command_line::cli::ReferenceCommand;
use crate::command_line::error::CommandError;
use crate::command_line::invocation::Invoked;
use crate::domain::files::write_json;
use crate::domain::image::HdrImage;
use crate::presenting::output::{Header, write_exr};
use crate::running::context::{Context, GpuUse};
use crate::running::settings::Setting;
use crate::running::view::View;
use interreflect_cpu::path_tracer::trace;
use interreflect_estimators::path_reference::path_quantity;
use interreflect_estimators::{OwnModel, Registry};
use interreflect_scene::LightPaths;
use serde::Serialize;

/// Points of a reference if none are asked for.
const POINTS: usize = 4096;

#[derive(Serialize)]
struct Traced {
    scene: String,
    quantity: &'static str,
    samples: u32,
    seed: u64,
    mean_relative_error: f64,
    points: Vec<TracedPoint>,
}

#[derive(Serialize)]
struct TracedPoint {
    position: [f32; 3],
    normal: [f32; 3],
    value: [f32; 3],
    standard_error: [f32; 3],
}

pub(super) fn run(
    command: &ReferenceCommand,
    registry: Registry,
    invoked: &Invoked,
) -> Result<(), CommandError> {
    let context = Context::new(registry, &command.run.context())?;
    let paths = light_paths(&context, command)?;
    let loaded = load(
        &context,
        (&*command.scene, &command.scene_options),
        &command.settings,
        GpuUse::No,
    )?;
    let scene = &*loaded.cpu().scene;
    let camera = scene.scene().camera;
    let shaded = (command.points.unwrap_or(POINTS), command.shade);
    let view = context
        .cpu
        .install(|| View::of_about(scene, &camera, shaded))?;
    let points = view.points(command.quantity.layout());
    let stop = command.budget.budget().stop();
    let bar = crate::command_line::progress::bar("path tracing", 1000);
    let traced = context.cpu.install(|| {
        let quantity = path_quantity(command.quantity);
        trace(
            scene,
            &points,
            quantity,
            &paths,
            &stop,
            context.seed,
            &|done| {
                bar.set_position((done * 1000.0) as u64);
            },
        )
    });
    bar.finish_and_clear();
    let (mut sum, mut error) = (0.0, 0.0);
    let mut listed = Vec::new();
    for (i, point) in points.iter().enumerate() {
        let Some(point) = point else { continue };
        let (value, standard_error) = (traced.mean.get(i), traced.standard_error.get(i));
        sum += f64::from(value.element_sum());
        error += f64::from(standard_error.element_sum());
        listed.push(TracedPoint {
            position: point.position.to_array(),
            normal: point.normal.to_array(),
            value: value.to_array(),
            standard_error: standard_error.to_array(),
        });
    }
    let result = Traced {
        scene: scene.scene().name.clone(),
        quantity: command.quantity.name(),
        samples: traced.samples,
        seed: context.seed,
        mean_relative_error: if sum > 0.0 { error / sum } else { 0.0 },
        points: listed,
    };
    if let Some(folder) = &command.out {
        write_json(&folder.join("reference.json"), &result)?;
        let [width, height] = view.resolution.map(|v| v as usize);
        for (name, values) in [
            ("reference.exr", &traced.mean),
            ("standard_error.exr", &traced.standard_error),
        ] {
            if let Some(image) = HdrImage::from_estimate(width, height, values) {
                let header = Header::of_program(&invoked.line, &context.machine(), context.seed)
                    .of_quantity(&result.scene, result.quantity)
                    .with("samples", traced.samples.to_string());
                let surfaces = view.surfaces();
                write_exr(&folder.join(name), &image, Some(&surfaces), &header)?;
            }
        }
    }
    if command.json {
        return print_json(&result);
    }
    print_line(&format!(
        "{}: {} at {} points, {} samples, mean {:.6}, mean relative standard error {:.2} %",
        result.scene,
        result.quantity,
        result.points.len(),
        result.samples,
        sum / (3 * result.points.len().max(1)) as f64,
        100.0 * result.mean_relative_error
    ))
}

/// The light paths that count: those of the registered method that traces paths, as it is set.
fn light_paths(context: &Context, command: &ReferenceCommand) -> Result<LightPaths, CommandError> {
    let quantity = command.quantity;
    for setting in &command.settings {
        let (_, name) = setting.split();
        if ["samples", "seed"].contains(&name) {
            return Err(CommandError::Usage(format!(
                "--set {name}={}: use --{name} {} here",
                setting.value, setting.value
            )));
        }
    }
    let traces = |id: &str, settings: &[Setting]| {
        let model = context.configure(id, settings)?.model(quantity);
        Ok::<_, CommandError>(match model {
            OwnModel::LightTransport(paths) => Some(paths),
            _ => None,
        })
    };
    for entry in context.registry.entries() {
        let id = entry.info().id;
        if traces(id, &[])?.is_some() {
            context.check_owners(&[id.to_owned()], &command.settings)?;
            return Ok(traces(id, &command.settings)?.unwrap_or_default());
        }
    }
    Ok(LightPaths::default())
}
