//! A rectangular pit in open ground: how open its floor is has a closed form.

use super::{Recipe, sky};
use crate::load::build::{Model, Parts};
use crate::load::{Setting, assemble};
use crate::params::{Choice, Field, Params};
use crate::shapes::grid;
use crate::{Camera, Environment, Material, Mesh, Role, Scene, SceneError};
use glam::Vec3;

pub(super) struct Pit;

/// What is above.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Sky {
    #[default]
    Constant,
    Procedural,
}

impl Choice for Sky {
    const ALL: &'static [(&'static str, Self)] = &[
        ("constant", Self::Constant),
        ("procedural", Self::Procedural),
    ];
}

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Settings {
    width: f32,
    length: f32,
    depth: f32,
    cells: u32,
    albedo: f32,
    sky: Sky,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            width: 1.0,
            length: 1.5,
            depth: 0.75,
            cells: 32,
            albedo: 0.6,
            sky: Sky::Constant,
        }
    }
}

impl Params for Settings {
    fn fields() -> Vec<Field<Self>> {
        vec![
            Field::f32(
                "width",
                "size of the pit along x",
                0.1..=10.0,
                |s: &Self| s.width,
                |s, v| s.width = v,
            )
            .unit("m"),
            Field::f32(
                "length",
                "size of the pit along z",
                0.1..=10.0,
                |s: &Self| s.length,
                |s, v| s.length = v,
            )
            .unit("m"),
            Field::f32(
                "depth",
                "how far the floor lies below the ground",
                0.1..=10.0,
                |s: &Self| s.depth,
                |s, v| s.depth = v,
            )
            .unit("m"),
            Field::u32(
                "cells",
                "cells along each side of the floor and of the walls",
                1..=256,
                |s: &Self| s.cells,
                |s, v| s.cells = v,
            )
            .log(),
            Field::f32(
                "albedo",
                "diffuse albedo of pit and ground",
                0.0..=1.0,
                |s: &Self| s.albedo,
                |s, v| s.albedo = v,
            )
            .symbol("ρ"),
            Field::choice(
                "sky",
                "radiance 1 from everywhere, or a procedural sky with a sun",
                |s: &Self| s.sky,
                |s, v| s.sky = v,
            ),
        ]
    }
}

impl Recipe for Pit {
    type Settings = Settings;
    const NAME: &'static str = "pit";
    const SUMMARY: &'static str =
        "rectangular pit in open ground: its floor sees the sky through a rectangle";
    const RECEIVERS: usize = 0;
    const BENCHED: bool = false;

    fn build(s: &Settings, _receivers: &[String]) -> Result<Scene, SceneError> {
        let stone = Material::diffuse(Vec3::splat(s.albedo));
        let mut parts = Parts::default();
        for (name, mesh) in [
            ("floor", floor(s)),
            ("walls", walls(s)),
            ("ground", ground(s)),
        ] {
            parts.add(name, Role::Receiver, Model::uniform(mesh, stone));
        }
        let environment = match s.sky {
            Sky::Constant => Environment::constant(Vec3::ONE),
            Sky::Procedural => Environment {
                image: sky::sky(),
                scale: 1.0,
                rotate_deg: 0.0,
            },
        };
        let size = s.width.max(s.length);
        let setting = Setting {
            environment: Some(environment),
            camera: Some(Camera {
                // High enough to see the floor past the near edge.
                eye: Vec3::new(0.35 * size, 1.6 * size + 0.5 * s.depth, 1.1 * size),
                target: Vec3::new(0.0, -0.5 * s.depth, 0.0),
                up: Vec3::Y,
                vfov_deg: 45.0,
                resolution: [512, 512],
            }),
            reference_point: Some(Vec3::new(0.0, -0.5 * s.depth, 0.0)),
            ..Setting::default()
        };
        Ok(assemble(Self::NAME, parts, setting))
    }
}

/// The floor, its front up.
fn floor(s: &Settings) -> Mesh {
    let corner = Vec3::new(-0.5 * s.width, -s.depth, 0.5 * s.length);
    let (right, up) = (Vec3::X * s.width, Vec3::NEG_Z * s.length);
    grid(corner, right, up, [s.cells; 2])
}

/// The four walls, their fronts inside; they share no vertices, so that values at vertices are
/// those of one wall.
fn walls(s: &Settings) -> Mesh {
    let (x, z) = (0.5 * s.width, 0.5 * s.length);
    // Corners of the floor, counter-clockwise from above.
    let corners = [(-x, z), (x, z), (x, -z), (-x, -z)].map(|(x, z)| Vec3::new(x, -s.depth, z));
    let wall = |i: usize| {
        let (left, right) = (corners[(i + 1) % 4], corners[i]);
        grid(left, right - left, Vec3::Y * s.depth, [s.cells; 2])
    };
    joined((0..4).map(wall))
}

/// The ground around the pit, its front up: as far as the pit is long on every side.
fn ground(s: &Settings) -> Mesh {
    let margin = s.width.max(s.length);
    let (x, z) = (0.5 * s.width, 0.5 * s.length);
    let spans = |half: f32| [-half - margin, -half, half, half + margin];
    let (xs, zs) = (spans(x), spans(z));
    let cells = |i: usize| if i == 1 { s.cells } else { s.cells.div_ceil(2) };
    let around = (0..9).filter(|i| *i != 4).map(|i| (i % 3, i / 3));
    joined(around.map(|(i, j)| {
        let corner = Vec3::new(xs[i], 0.0, zs[j + 1]);
        let (right, up) = (xs[i + 1] - xs[i], zs[j + 1] - zs[j]);
        let cells = [cells(i), cells(j)];
        grid(corner, Vec3::X * right, Vec3::NEG_Z * up, cells)
    }))
}

/// Meshes as one.
fn joined(meshes: impl Iterator<Item = Mesh>) -> Mesh {
    meshes.fold(Mesh::default(), |mut all, mesh| {
        let first = all.positions.len() as u32;
        all.positions.extend(mesh.positions);
        all.normals.extend(mesh.normals);
        all.materials.extend(mesh.materials);
        let triangles = mesh.triangles.into_iter();
        all.triangles
            .extend(triangles.map(|t| t.map(|v| v + first)));
        all
    })
}
