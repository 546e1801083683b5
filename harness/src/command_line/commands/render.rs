//! `render`: an image with one estimator.

use super::{load, print_json, print_line, with_method};
use crate::command_line::cli::Render;
use crate::command_line::error::CommandError;
use crate::command_line::invocation::Invoked;
use crate::domain::image::{Exposure, HdrImage};
use crate::domain::record::{Backend, Phases, Run};
use crate::presenting::output::{Header, write_exr, write_png};
use crate::running::clock::Sampling;
use crate::running::context::{Context, GpuUse};
use crate::running::on_backend::{Timed, direct_light, measure_on};
use crate::running::view::{View, lambertian};
use interreflect_estimators::execution::LoadedScene;
use interreflect_estimators::{Configured, Quantity, Registry};
use interreflect_scene::{Camera, Estimate, PointLayout, Points, ReflectionLaw, Scene};
use serde::Serialize;
use std::path::PathBuf;

/// Folder for images if nothing is said.
pub(super) const OUT: &str = "results";

#[derive(Serialize)]
struct Rendered {
    scene: String,
    estimator: &'static str,
    backend: Backend,
    software: bool,
    quantity: &'static str,
    shown: &'static str,
    resolution: [u32; 2],
    points: usize,
    phases_ms: Phases,
    exr: PathBuf,
    png: PathBuf,
}

/// The context of a `render`, its method, and its scene on the backends that it runs on.
pub(super) fn opened(
    command: &Render,
    registry: Registry,
) -> Result<(Context, Box<dyn Configured>, LoadedScene), CommandError> {
    let (context, method) = with_method(
        registry,
        &command.run,
        &command.estimator,
        &command.settings,
    )?;
    let gpu = GpuUse::required_in(command.backend.list());
    let scene = (&*command.scene, &command.scene_options);
    let loaded = load(&context, scene, &command.settings, gpu)?;
    Ok((context, method, loaded))
}

pub(super) fn run(
    command: &Render,
    registry: Registry,
    invoked: &Invoked,
) -> Result<(), CommandError> {
    let (context, method, loaded) = opened(command, registry)?;
    let shown = Shown::choose(&*method, command.quantity);
    let scene = &loaded.cpu().scene;
    let camera = resized(scene.scene(), command);
    let view = context
        .cpu
        .install(|| View::new(scene, &camera, command.look()))?;
    let points = view.points(shown.quantity().layout());
    let materials = view.points(PointLayout::Material);
    let mut rendered = Vec::new();
    for &backend in command.backend.list() {
        let Timed {
            measured, software, ..
        } = measure_on(
            &loaded,
            backend,
            &*method,
            shown.quantity(),
            &points,
            &Sampling::ONCE,
        )?;
        let direct = shown.direct(&loaded, backend, (&view, command.direct_light))?;
        let image = shown.image((&view, &materials), &measured.estimate, direct.as_ref());
        let stem = shown.stem(scene.scene(), &*method, backend);
        let folder = command.out.clone().unwrap_or_else(|| OUT.into());
        let (exr, png) = (
            folder.join(format!("{stem}.exr")),
            folder.join(format!("{stem}.png")),
        );
        let run = Run::of(&scene.scene().name, &*method, backend, shown.quantity());
        let header = Header::of_program(&invoked.line, &context.machine(), context.seed)
            .of_run(&run)
            .with("shown", shown.name());
        write_exr(&exr, &image, None, &header)?;
        write_png(&png, &image, Exposure::of(&image))?;
        rendered.push(Rendered {
            scene: scene.scene().name.clone(),
            estimator: method.info().id,
            backend,
            software,
            quantity: shown.quantity().name(),
            shown: shown.name(),
            resolution: camera.resolution,
            points: points.len(),
            phases_ms: measured.phases,
            exr,
            png,
        });
    }
    if command.json {
        return print_json(&rendered);
    }
    for r in &rendered {
        let ms = r.phases_ms.frame_ms().unwrap_or(0.0);
        let software = if r.software {
            " (software adapter)"
        } else {
            ""
        };
        print_line(&format!(
            "{}  {} points, {ms:.1} ms a frame{software}",
            r.png.display(),
            r.points
        ))?;
    }
    Ok(())
}

pub(super) fn resized(scene: &Scene, command: &Render) -> Camera {
    let [width, height] = scene.camera.resolution;
    Camera {
        resolution: [
            command.width.unwrap_or(width),
            command.height.unwrap_or(height),
        ],
        ..scene.camera
    }
}

/// What the image shows.
pub(super) enum Shown {
    /// The quantity by itself.
    Quantity(Quantity),
    /// All light that reaches the camera: direct light and, from the estimate, indirect light.
    Light(Quantity),
}

impl Shown {
    pub(super) fn choose(method: &dyn Configured, asked: Option<Quantity>) -> Self {
        let offered = method.quantities();
        match asked {
            Some(quantity) => Self::Quantity(quantity),
            None if offered.contains(&Quantity::GlossyRadiance) => {
                Self::Light(Quantity::GlossyRadiance)
            }
            None if offered.contains(&Quantity::Irradiance) => Self::Light(Quantity::Irradiance),
            None => Self::Quantity(offered.first().copied().unwrap_or(Quantity::Irradiance)),
        }
    }

    pub(super) fn quantity(&self) -> Quantity {
        match self {
            Self::Quantity(quantity) | Self::Light(quantity) => *quantity,
        }
    }

    pub(super) fn name(&self) -> &'static str {
        match self {
            Self::Quantity(quantity) => quantity.name(),
            Self::Light(_) => "light",
        }
    }

    /// Name of an image without its ending.
    pub(super) fn stem(&self, scene: &Scene, method: &dyn Configured, backend: Backend) -> String {
        let fidelity = method.fidelity().map(|f| format!("-{f}"));
        let fidelity = fidelity.unwrap_or_default();
        let (scene, id) = (&scene.name, method.info().id);
        format!("{scene}-{id}{fidelity}-{}-{backend}", self.name())
    }

    /// The direct light of the image, computed where the estimate is; `None` where it shows none.
    pub(super) fn direct(
        &self,
        loaded: &LoadedScene,
        backend: Backend,
        (view, law): (&View, ReflectionLaw),
    ) -> Result<Option<Estimate>, CommandError> {
        let Self::Light(_) = self else {
            return Ok(None);
        };
        let (direct, _) = direct_light(loaded, backend, &view.seen(), law.into())?;
        Ok(Some(direct))
    }

    pub(super) fn image(
        &self,
        (view, points): (&View, &Points),
        estimate: &Estimate,
        direct: Option<&Estimate>,
    ) -> HdrImage {
        let Some(direct) = direct else {
            return view.image(estimate);
        };
        if self.quantity() == Quantity::GlossyRadiance {
            return view.lit(estimate, direct);
        }
        view.lit(&lambertian(points, estimate), direct)
    }
}
