//! A closed cavern of bare rock with a lantern, a mirror and a mirror ball.

use super::Recipe;
use crate::load::build::{Model, Parts};
use crate::load::{Setting, assemble};
use crate::shapes::waves::{gyroid, swirl};
use crate::{Camera, Light, Material, Mesh, Role, Scene, SceneError, SpotShape, normals, shapes};
use glam::{Mat3, Quat, Vec3};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;

pub(super) struct Cave;

#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub(super) struct Settings {
    /// Full angle of the lantern's square frustum.
    #[serde(rename = "light.angle")]
    #[default(95.0)]
    #[schemars(range(min = 10.0, max = 150.0), extend("unit" = "°"))]
    angle_deg: f32,
    /// Intensity of the lantern.
    #[serde(rename = "light")]
    #[default(60.0)]
    #[schemars(range(min = 0.0, max = 10_000.0), extend("unit" = "W/sr"))]
    intensity: f32,
    /// The mirror and the mirror ball are there.
    #[default(true)]
    mirrors: bool,
    /// Reflectance of the mirrors.
    #[serde(rename = "mirror.specular")]
    #[default(0.9)]
    #[schemars(range(min = 0.0, max = 1.0), extend("symbol" = "k_s"))]
    specular: f32,
}

/// Semi-axes in metres of the ellipsoid that the cavern is carved from.
const SEMI_AXES_M: Vec3 = Vec3::new(3.4, 2.2, 2.9);
/// How far below the middle the floor is, in metres.
const FLOOR_M: f32 = 1.25;
/// Parts into which an edge of the cavern's icosahedron is cut: 20·40² = 32 000 triangles.
const CAVERN_FREQUENCY: u32 = 40;
/// The same of a boulder, 20·13² = 3 380 triangles, and of the ball, 20·10² = 2 000.
const BOULDER_FREQUENCY: u32 = 13;
const BALL_FREQUENCY: u32 = 10;

/// Albedos of the rock, from dark to light, and of the sand on level ground.
const ROCK: [[f32; 3]; 4] = [
    [0.45, 0.41, 0.38],
    [0.58, 0.50, 0.41],
    [0.66, 0.51, 0.35],
    [0.52, 0.56, 0.48],
];
const SAND: [f32; 3] = [0.72, 0.64, 0.52];

/// Centres and radii of boulders on the floor, in metres.
const BOULDERS: [(Vec3, f32); 2] = [
    (Vec3::new(-0.75, -1.1, -1.35), 0.5),
    (Vec3::new(0.62, -1.15, 0.75), 0.3),
];

impl Recipe for Cave {
    type Settings = Settings;
    const NAME: &'static str = "cave";
    const SUMMARY: &'static str =
        "closed cavern of 40 000 triangles with a lantern, a mirror and a mirror ball";
    const RECEIVERS: usize = 0;
    const BENCHED: bool = false;

    fn build(s: &Settings, _receivers: &[String]) -> Result<Scene, SceneError> {
        let mut parts = Parts::default();
        parts.add("cavern", Role::Environment, rock(cavern()));
        for (i, (centre, radius)) in BOULDERS.into_iter().enumerate() {
            let model = rock(boulder(centre, radius));
            parts.add(format!("boulder {}", i + 1), Role::Environment, model);
        }
        let mirror = Material {
            mirror: true,
            ..Material {
                specular: Vec3::splat(s.specular),
                ..Material::diffuse(Vec3::ZERO)
            }
        };
        let ball = Model::uniform(shapes::sphere(0.32, BALL_FREQUENCY), mirror);
        let ball = ball.moved(Vec3::new(0.05, -0.88, -0.25));
        let plane = Model::uniform(shapes::quad(1.3, 1.6), mirror);
        let facing = Vec3::new(-0.9, 0.05, 0.4).normalize();
        let plane = plane.placed(Vec3::new(1.35, -0.4, -0.7), upright(facing), 1.0);
        if s.mirrors {
            parts.add("mirror ball", Role::Environment, ball);
            parts.add("mirror", Role::Environment, plane);
        }
        let direction = Vec3::new(-0.7, -0.35, -0.62).normalize();
        let setting = Setting {
            lights: vec![Light::Spot {
                position: Vec3::new(0.5, 0.8, 0.45),
                direction,
                up: (Vec3::Y - direction * direction.y).normalize(),
                shape: SpotShape::Square,
                angle_deg: s.angle_deg,
                intensity: Vec3::new(1.0, 0.86, 0.66) * s.intensity,
            }],
            camera: Some(Camera {
                eye: Vec3::new(-0.7, 0.15, 2.05),
                target: Vec3::new(0.1, -0.3, -0.6),
                up: Vec3::Y,
                vfov_deg: 62.0,
                resolution: [640, 480],
            }),
            reference_point: Some(Vec3::new(0.0, 0.1, 0.2)),
            ..Setting::default()
        };
        Ok(assemble(Self::NAME, parts, setting))
    }
}

/// Turns a rectangle in the xz-plane so that its front faces a direction and its x-edge is level.
fn upright(facing: Vec3) -> Quat {
    let right = Vec3::Y.cross(facing).normalize();
    Quat::from_mat3(&Mat3::from_cols(right, facing, right.cross(facing)))
}

/// How far a surface is pushed along its direction, relative to its size: bulges and hollows of
/// about a metre, then creased layers, then grain.
fn roughness(direction: Vec3) -> f32 {
    let bent = direction + 0.3 * swirl(2.9 * direction) + 0.08 * swirl(9.0 * direction);
    // |gyroid| has creases where the gyroid vanishes.
    let creased = |number: f32, phase: f32| 0.5 - gyroid(number * bent + phase).abs();
    0.10 * gyroid(2.3 * bent + 0.6)
        + 0.075 * creased(3.9, 1.7)
        + 0.07 * creased(7.7, 4.0)
        + 0.03 * creased(15.1, 2.2)
        + 0.008 * gyroid(29.0 * bent + 5.1)
}

/// The cavern, star-shaped about the origin, its front inside.
fn cavern() -> Mesh {
    let mut mesh = shapes::sphere(1.0, CAVERN_FREQUENCY);
    for p in &mut mesh.positions {
        let direction = *p;
        let wall = (1.0 + roughness(direction)) / (direction / SEMI_AXES_M).length();
        // The nearer of wall and floor, as a smooth minimum: the sum of high powers of the
        // inverses.
        let inverse_floor = (-direction.y).max(0.0) / FLOOR_M;
        let inverse = (wall.recip().powi(8) + inverse_floor.powi(8)).powf(0.125);
        let bumps = 0.02 * gyroid(5.0 * direction / inverse);
        *p = direction * (inverse.recip() + bumps);
    }
    for t in &mut mesh.triangles {
        t.swap(1, 2);
    }
    normals::smooth(&mut mesh);
    mesh
}

fn boulder(centre: Vec3, radius: f32) -> Mesh {
    let mut mesh = shapes::sphere(1.0, BOULDER_FREQUENCY);
    for p in &mut mesh.positions {
        let push = 1.0 + 1.5 * roughness(0.5 * *p + centre);
        *p = centre + *p * Vec3::new(1.15, 0.85, 1.0) * (radius * push);
    }
    normals::smooth(&mut mesh);
    mesh
}

/// A mesh of rock: sand where it is level, elsewhere one of four stones by where it is.
fn rock(mut mesh: Mesh) -> Model {
    let materials = ROCK.into_iter().chain([SAND]);
    let of_triangle = |t: usize| {
        let [a, b, c] = mesh.corners(t);
        let middle = (a + b + c) / 3.0;
        let grain = 0.3 * gyroid(4.1 * middle) + 0.15 * gyroid(9.3 * middle + 1.0);
        if mesh.normal(t).y + 0.4 * grain > 0.85 {
            return ROCK.len() as u32;
        }
        let stone = gyroid(0.9 * middle + 0.5 * swirl(1.7 * middle)) + grain;
        // Within about ±1.5: four equal parts of ±1.
        ((2.0 * stone + 2.0).clamp(0.0, 3.0)) as u32
    };
    mesh.materials = (0..mesh.triangles.len()).map(of_triangle).collect();
    Model {
        mesh,
        materials: materials.map(|c| Material::diffuse(c.into())).collect(),
    }
}
