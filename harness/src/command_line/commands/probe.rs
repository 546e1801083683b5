//! `probe`: one estimate at the points of a file.

use super::{load, print_json, print_line, with_method};
use crate::command_line::cli::Probe;
use crate::command_line::error::CommandError;
use crate::domain::files::write_json;
use crate::domain::record::Backend;
use crate::running::clock::Sampling;
use crate::running::context::GpuUse;
use crate::running::on_backend::{Timed, measure_on};
use glam::Vec3;
use interreflect_estimators::{Configured, Quantity, Registry};
use interreflect_scene::load::open_points;
use interreflect_scene::{Point, Points, SurfaceMaterial};
use serde::Serialize;

#[derive(Serialize)]
struct Probed {
    estimator: &'static str,
    backend: Backend,
    quantity: &'static str,
    values: Vec<[f32; 3]>,
}

pub(super) fn run(command: &Probe, registry: Registry) -> Result<(), CommandError> {
    let (context, method) = with_method(
        registry,
        &command.run,
        &command.estimator,
        &command.settings,
    )?;
    let quantity = match command.quantity {
        Some(quantity) => quantity,
        None => main_quantity(&*method)?,
    };
    let points = points(command, quantity)?;
    let gpu = GpuUse::required_in(&[command.backend]);
    let loaded = load(
        &context,
        (&*command.scene, &command.scene_options),
        &command.settings,
        gpu,
    )?;
    let backend = command.backend;
    let once = Sampling::ONCE;
    let Timed { measured, .. } = measure_on(&loaded, backend, &*method, quantity, &points, &once)?;
    let probed = Probed {
        estimator: method.info().id,
        backend,
        quantity: quantity.name(),
        values: measured.estimate.iter().map(|v| v.to_array()).collect(),
    };
    if let Some(folder) = &command.out {
        write_json(&folder.join("probe.json"), &probed)?;
    }
    if command.json {
        return print_json(&probed);
    }
    for ([r, g, b], point) in probed.values.iter().zip(points.iter().flatten()) {
        let (p, n) = (point.position, point.normal);
        print_line(&format!(
            "{:>10.6} {:>10.6} {:>10.6}  {:>8.5} {:>8.5} {:>8.5}  {r:>12.6} {g:>12.6} {b:>12.6}",
            p.x, p.y, p.z, n.x, n.y, n.z
        ))?;
    }
    Ok(())
}

/// Irradiance where the method offers it, else the first that it offers.
fn main_quantity(method: &dyn Configured) -> Result<Quantity, CommandError> {
    let offered = method.quantities();
    let irradiance = offered.iter().find(|q| **q == Quantity::Irradiance);
    irradiance
        .or(offered.first())
        .copied()
        .ok_or_else(|| CommandError::Usage(format!("{} estimates no quantity", method.info().id)))
}

/// The file's points, with the material of the command line.
fn points(command: &Probe, quantity: Quantity) -> Result<Points, CommandError> {
    let mut points = open_points(&command.points)?;
    if quantity == Quantity::GlossyRadiance {
        let Some(material) = &command.material else {
            return Err(CommandError::Usage(
                "glossy_radiance needs a material: add --material KD,KS,SHININESS, such as \
                 --material .5,.5,5"
                    .into(),
            ));
        };
        if points.iter().any(|p| p.view == Vec3::ZERO) {
            return Err(CommandError::Usage(format!(
                "{}: glossy_radiance needs the columns vx,vy,vz, the direction to the viewer",
                command.points.display()
            )));
        }
        for point in &mut points {
            point.material = SurfaceMaterial {
                diffuse: Vec3::splat(material.diffuse),
                specular: Vec3::splat(material.specular),
                shininess: material.shininess,
            };
        }
    }
    let points = points.into_iter().map(Some::<Point>);
    Ok(Points::new(quantity.layout(), points))
}
