//! `render --show rsm`: the reflective shadow maps that an estimator uses, side by side
//! (P3, Figure 6).

use super::print_line;
use super::render::{OUT, opened};
use crate::command_line::cli::Render;
use crate::command_line::error::CommandError;
use crate::command_line::invocation::Invoked;
use crate::domain::image::{Exposure, HdrImage};
use crate::presenting::output::{Header, write_exr, write_png};
use crate::running::on_backend::rsms;
use glam::Vec3;
use interreflect_estimators::{Quantity, Registry};
use interreflect_scene::RsmImage;

/// Pixels along the edge of a shown view, at least: texels are enlarged to whole blocks.
const SHOWN: usize = 256;

pub(super) fn run(
    command: &Render,
    registry: Registry,
    invoked: &Invoked,
) -> Result<(), CommandError> {
    let (context, method, loaded) = opened(command, registry)?;
    let scene = loaded.scene();
    let quantity = command.quantity.or(method.quantities().first().copied());
    let quantity = quantity.unwrap_or(Quantity::Irradiance);
    let needs = method.needs(quantity, &scene.facts())?;
    if needs.rsms.is_empty() {
        return Err(CommandError::Usage(format!(
            "--show rsm: {} uses no reflective shadow maps; `interreflect list --needs` \
             says which estimators do",
            command.estimator
        )));
    }
    let folder = command.out.clone().unwrap_or_else(|| OUT.into());
    for &backend in command.backend.list() {
        for views in rsms(&loaded, backend, &needs)? {
            for (channel, values, shown) in channels(&views) {
                let (name, id) = (&scene.name, method.info().id);
                let stem = format!("{name}-{id}-rsm-{channel}-{backend}");
                write_exr(
                    &folder.join(format!("{stem}.exr")),
                    &sheet(&views, &values, 1),
                    None,
                    &Header::of_program(&invoked.line, &context.machine(), context.seed)
                        .with("scene", name)
                        .with("estimator", id)
                        .with("backend", backend.to_string())
                        .with("shown", format!("RSM, {channel}")),
                )?;
                let factor = SHOWN.div_ceil(views.size as usize);
                let image = sheet(&views, &shown, factor);
                let png = folder.join(format!("{stem}.png"));
                write_png(&png, &image, Exposure::of(&image))?;
                print_line(&png.display().to_string())?;
            }
        }
    }
    Ok(())
}

/// Name of each channel that there is, its values, and these as colours in [0, 1] or as radiance.
fn channels(views: &RsmImage) -> Vec<(&'static str, Vec<Vec3>, Vec<Vec3>)> {
    let (low, size) = (views.bounds.low, views.bounds.high - views.bounds.low);
    let hit = |i: usize| views.path_m[i] > 0.0;
    let where_hit = |values: &[Vec3], colour: &dyn Fn(Vec3) -> Vec3| -> Vec<Vec3> {
        let values = values.iter().enumerate();
        values
            .map(|(i, v)| if hit(i) { colour(*v) } else { Vec3::ZERO })
            .collect()
    };
    let place = |p: Vec3| (p - low) / size.max(Vec3::splat(f32::MIN_POSITIVE));
    let shown = [
        (
            "position",
            &views.position,
            where_hit(&views.position, &place),
        ),
        ("radiance", &views.radiance, views.radiance.clone()),
        (
            "normal",
            &views.normal,
            where_hit(&views.normal, &|n| 0.5 + 0.5 * n),
        ),
    ];
    let there = shown
        .into_iter()
        .filter(|(_, values, _)| !values.is_empty());
    there
        .map(|(name, values, shown)| (name, values.clone(), shown))
        .collect()
}

/// The views side by side, each texel as a block of pixels.
fn sheet(views: &RsmImage, values: &[Vec3], factor: usize) -> HdrImage {
    let size = views.size as usize;
    let (width, height) = (views.frames.len() * size * factor, size * factor);
    let pixel = |i: usize| {
        let (x, y) = (i % width / factor, i / width / factor);
        let (frame, column) = (x / size, x % size);
        let (column, row) = (column as u32, y as u32);
        values[interreflect_scene::rsm::view_index(views.size, frame, column, row)]
    };
    HdrImage {
        width,
        height,
        pixels: (0..width * height).map(pixel).collect(),
    }
}
