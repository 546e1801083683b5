//! A rectangular pit in open ground: openness of its floor has a closed form.

use super::{Recipe, sky};
use crate::load::build::{Model, Parts};
use crate::load::{Setting, assemble};
use crate::shapes::grid;
use crate::{Camera, Environment, Material, Mesh, Role, Scene, SceneError};
use glam::Vec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;

pub(super) struct Pit;

/// What is above.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Sky {
    /// Radiance 1 from everywhere.
    #[default]
    Constant,
    /// A procedural sky with a sun.
    Procedural,
}

#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub(super) struct Settings {
    /// Size of the pit along x.
    #[default(1.0)]
    #[schemars(range(min = 0.1, max = 10.0), extend("unit" = "m"))]
    width: f32,
    /// Size of the pit along z.
    #[default(1.5)]
    #[schemars(range(min = 0.1, max = 10.0), extend("unit" = "m"))]
    length: f32,
    /// How far the floor lies below the ground.
    #[default(0.75)]
    #[schemars(range(min = 0.1, max = 10.0), extend("unit" = "m"))]
    depth: f32,
    /// Cells along each side of the floor and of the walls.
    #[default(32)]
    #[schemars(range(min = 1, max = 256), extend("scale" = "log"))]
    cells: u32,
    /// Diffuse albedo of pit and ground.
    #[default(0.6)]
    #[schemars(range(min = 0.0, max = 1.0), extend("symbol" = "ρ"))]
    albedo: f32,
    /// Radiance 1 from everywhere, or a procedural sky with a sun.
    sky: Sky,
}

impl Recipe for Pit {
    type Settings = Settings;
    const NAME: &'static str = "pit";
    const SUMMARY: &'static str =
        "rectangular pit in open ground: openness of its floor has a closed form";
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
