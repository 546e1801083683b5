//! `render --frames`: images of a scene that moves, by sessions that live on from frame to frame.

use super::render::{OUT, Shown, resized};
use super::{print_json, print_line, remark_on, with_method};
use crate::command_line::cli::Render;
use crate::command_line::error::CommandError;
use crate::domain::image::Exposure;
use crate::domain::record::Backend;
use crate::presenting::output::write_png;
use crate::running::context::GpuUse;
use crate::running::frames::Frame;
use crate::running::on_backend::{Sequence, next_frame};
use crate::running::view::View;
use interreflect_estimators::Registry;
use interreflect_scene::PointLayout;
use serde::Serialize;
use std::path::PathBuf;

#[derive(Serialize)]
struct Rendered {
    frame: u32,
    time_s: f32,
    scene: String,
    estimator: &'static str,
    backend: Backend,
    shown: &'static str,
    points: usize,
    frame_ms: f64,
    png: PathBuf,
}

pub(super) fn run(command: &Render, registry: Registry) -> Result<(), CommandError> {
    let (context, method) = with_method(
        registry,
        &command.run,
        &command.estimator,
        &command.settings,
    )?;
    let shown = Shown::choose(&*method, command.quantity);
    let rest = context.scene(
        &command.scene,
        &command.scene_options.changes(),
        &command.settings,
    )?;
    remark_on(&rest);
    let moves = rest.moves();
    let gpu = GpuUse::required_in(command.backend.list());
    let mut loaded = context.set_up(&context.cpu, &rest, gpu)?;
    let (mut sequence, mut exposure) = (Sequence::default(), None);
    let mut all = Vec::new();
    for index in 0..command.frames.unwrap_or(1) {
        let time_s = index as f32 / command.fps;
        let scene = rest.at(time_s);
        if moves.geometry || moves.lights || moves.environment {
            loaded = context.set_up(&context.cpu, &scene, gpu)?;
        }
        let camera = resized(&scene, command);
        let look = command.look();
        let cpu = &loaded.cpu().scene;
        let view = context.cpu.install(|| View::new(cpu, &camera, look))?;
        let points = view.points(shown.quantity().layout());
        let frame = Frame {
            scene: &scene,
            moves,
            points: &points,
            visible: view.visible(),
        };
        for &backend in command.backend.list() {
            let (method, quantity) = (&*method, shown.quantity());
            let shaded = next_frame(&loaded, backend, &mut sequence, method, quantity, &frame)?;
            let materials = view.points(PointLayout::Material);
            let direct = shown.direct(&loaded, backend, (&view, command.direct_light))?;
            let image = shown.image((&view, &materials), &shaded.estimate, direct.as_ref());
            // One for all frames: brightness must not flicker.
            let exposure = *exposure.get_or_insert_with(|| Exposure::of(&image));
            let folder = command.out.clone().unwrap_or_else(|| OUT.into());
            let stem = shown.stem(&rest, method, backend);
            let png = folder.join(format!("{stem}-{index:04}.png"));
            write_png(&png, &image, exposure)?;
            let rendered = Rendered {
                frame: index,
                time_s,
                scene: rest.name.clone(),
                estimator: method.info().id,
                backend,
                shown: shown.name(),
                points: points.len(),
                frame_ms: shaded.ms,
                png,
            };
            if !command.json {
                let Rendered { png, .. } = &rendered;
                let ms = rendered.frame_ms;
                print_line(&format!(
                    "{}  {} points, {ms:.1} ms",
                    png.display(),
                    points.len()
                ))?;
            }
            all.push(rendered);
        }
    }
    match command.json {
        true => print_json(&all),
        false => Ok(()),
    }
}
