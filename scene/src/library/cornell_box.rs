//! The measured Cornell box (Cornell University Program of Computer Graphics, *Cornell Box Data*),
//! in metres.

use super::Recipe;
use super::receiver::{self, Look};
use crate::load::build::{Model, Parts};
use crate::load::{Setting, assemble};
use crate::{Camera, Light, Material, Mesh, Role, Scene, SceneError, SpotShape, shapes};
use glam::Vec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;
use std::f32::consts::PI;

pub(super) struct CornellBox;

/// What lights the box; the flux is the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Lamp {
    /// A spot light.
    #[default]
    Spot,
    /// A distant isotropic area light.
    Area,
    /// The glowing patch itself.
    Emitter,
}

/// What stands in the box.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Blocks {
    /// The two blocks.
    #[default]
    Blocks,
    /// Two mirror balls in their places.
    MirrorBalls,
}

/// Where a receiver is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Place {
    /// On the floor, beside the short block.
    #[default]
    Floor,
    /// In the air, its top 5 cm under the lamp.
    Lamp,
}

#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub(super) struct Settings {
    /// The two blocks, or two mirror balls in their places.
    #[serde(rename = "inside")]
    blocks: Blocks,
    /// A spot light, a distant isotropic area light, or the glowing patch itself.
    #[serde(rename = "light")]
    lamp: Lamp,
    /// Full angle of the spot light.
    #[serde(rename = "light.angle")]
    #[default(140.0)]
    #[schemars(range(min = 10.0, max = 170.0), extend("unit" = "°"))]
    angle_deg: f32,
    /// Factor on the measured light; 1 gives a dim image, 3 a well-exposed one.
    #[serde(rename = "light.brightness")]
    #[default(3.0)]
    #[schemars(range(min = 0.0, max = 1000.0))]
    brightness: f32,
    /// A receiver stands on the floor, or is in the air under the lamp.
    #[serde(rename = "receiver.place")]
    place: Place,
    /// Longest side of the receiver, if one is asked for.
    #[serde(rename = "receiver.size")]
    #[default(0.18)]
    #[schemars(range(min = 0.01, max = 0.25), extend("unit" = "m"))]
    size: f32,
    /// How the receiver reflects and moves.
    #[serde(flatten)]
    look: Look,
}

/// Corners in millimetres, counter-clockwise seen from the front: the floor, the ceiling, the back
/// wall (white), the right wall (green), the left wall (red), then five faces of each block.
const ROOM: [[[f32; 3]; 4]; 5] = [
    [
        [552.8, 0.0, 0.0],
        [0.0, 0.0, 0.0],
        [0.0, 0.0, 559.2],
        [549.6, 0.0, 559.2],
    ],
    [
        [556.0, 548.8, 0.0],
        [556.0, 548.8, 559.2],
        [0.0, 548.8, 559.2],
        [0.0, 548.8, 0.0],
    ],
    [
        [549.6, 0.0, 559.2],
        [0.0, 0.0, 559.2],
        [0.0, 548.8, 559.2],
        [556.0, 548.8, 559.2],
    ],
    [
        [0.0, 0.0, 559.2],
        [0.0, 0.0, 0.0],
        [0.0, 548.8, 0.0],
        [0.0, 548.8, 559.2],
    ],
    [
        [552.8, 0.0, 0.0],
        [549.6, 0.0, 559.2],
        [556.0, 548.8, 559.2],
        [556.0, 548.8, 0.0],
    ],
];

/// Feet (x, z) of the blocks in millimetres, counter-clockwise seen from above, and their heights.
const BLOCKS: [(&str, [[f32; 2]; 4], f32); 2] = [
    (
        "short block",
        [[130.0, 65.0], [82.0, 225.0], [240.0, 272.0], [290.0, 114.0]],
        165.0,
    ),
    (
        "tall block",
        [
            [423.0, 247.0],
            [265.0, 296.0],
            [314.0, 456.0],
            [472.0, 406.0],
        ],
        330.0,
    ),
];

/// The light patch in millimetres, its front down.
const PATCH: [[f32; 3]; 4] = [
    [343.0, 548.3, 227.0],
    [343.0, 548.3, 332.0],
    [213.0, 548.3, 332.0],
    [213.0, 548.3, 227.0],
];
const PATCH_AREA_M2: f32 = 0.130 * 0.105;
/// Radiance of the patch in the usual RGB version of the measured spectrum.
const PATCH_RADIANCE: Vec3 = Vec3::new(17.0, 12.0, 4.0);

const WHITE: Vec3 = Vec3::new(0.725, 0.71, 0.68);
const RED: Vec3 = Vec3::new(0.63, 0.065, 0.05);
const GREEN: Vec3 = Vec3::new(0.14, 0.45, 0.091);

/// Where a receiver stands: on the floor in the front half, beside the short block.
const RECEIVER_FOOT: Vec3 = Vec3::new(0.42, 0.0, 0.12);
/// The top of a receiver under the lamp, above the blocks.
const UNDER_THE_LAMP: Vec3 = Vec3::new(0.278, 0.4983, 0.2795);
/// Radius in metres of a mirror ball, and its reflectance.
const BALL_M: f32 = 0.09;
const BALL_REFLECTANCE: f32 = 0.9;
/// The middle of the free space: above the short block, before the tall one.
const FREE_CENTRE: Vec3 = Vec3::new(0.278, 0.36, 0.16);

impl Recipe for CornellBox {
    type Settings = Settings;
    const NAME: &'static str = "cornell-box";
    const SUMMARY: &'static str =
        "the measured Cornell box with its two blocks; a receiver only if one is asked for";

    fn build(s: &Settings, receivers: &[String]) -> Result<Scene, SceneError> {
        let mut parts = Parts::default();
        let mut room = Model {
            mesh: quads(&ROOM),
            materials: [WHITE, GREEN, RED].map(Material::diffuse).into(),
        };
        room.mesh.materials = vec![0, 0, 0, 0, 0, 0, 1, 1, 2, 2];
        parts.add("room", Role::Environment, room);
        for (name, foot, height) in BLOCKS {
            let (name, model) = match s.blocks {
                Blocks::Blocks => {
                    let mesh = quads(&block(foot, height));
                    (name, Model::uniform(mesh, Material::diffuse(WHITE)))
                }
                Blocks::MirrorBalls => ("mirror ball", mirror_ball(foot)),
            };
            parts.add(name, Role::Environment, model);
        }
        if s.lamp == Lamp::Emitter {
            let patch = Model::uniform(
                quads(&[PATCH]),
                Material::emitter(PATCH_RADIANCE * s.brightness),
            );
            parts.add("light", Role::Environment, patch);
        }
        let mut reference_point = FREE_CENTRE;
        if let Some(name) = receivers.first() {
            let model = receiver::model(name, s.size, &s.look)?;
            let (lo, hi) = model.mesh.bounds().unwrap_or_default();
            reference_point = match s.place {
                Place::Floor => RECEIVER_FOOT - Vec3::Y * lo.y,
                Place::Lamp => UNDER_THE_LAMP - Vec3::Y * hi.y,
            };
            receiver::add(&mut parts, name, model.moved(reference_point), &s.look);
        }
        let setting = Setting {
            lights: light(s).into_iter().collect(),
            camera: Some(Camera {
                eye: Vec3::new(0.278, 0.273, -0.8),
                target: Vec3::new(0.278, 0.273, 0.0),
                up: Vec3::Y,
                vfov_deg: 39.3077,
                resolution: [512, 512],
            }),
            reference_point: Some(reference_point),
            ..Setting::default()
        };
        Ok(assemble(Self::NAME, parts, setting))
    }
}

/// The light that is no surface; all lamps have the patch's flux π·L·A, times the brightness.
fn light(s: &Settings) -> Option<Light> {
    let flux = PATCH_RADIANCE * (s.brightness * PI * PATCH_AREA_M2);
    match s.lamp {
        Lamp::Emitter => None,
        Lamp::Area => Some(Light::Area {
            position: Vec3::new(0.278, 0.5483, 0.2795),
            normal: Vec3::NEG_Y,
            area_m2: PATCH_AREA_M2,
            flux,
            picture: None,
        }),
        Lamp::Spot => {
            let cone_sr = 2.0 * PI * (1.0 - (0.5 * s.angle_deg).to_radians().cos());
            Some(Light::Spot {
                position: Vec3::new(0.278, 0.54, 0.2795),
                direction: Vec3::NEG_Y,
                up: Vec3::Z,
                shape: SpotShape::Cone,
                angle_deg: s.angle_deg,
                intensity: flux / cone_sr,
            })
        }
    }
}

/// A ball on the floor in the middle of a block's foot.
fn mirror_ball(foot: [[f32; 2]; 4]) -> Model {
    let mirror = Material {
        mirror: true,
        specular: Vec3::splat(BALL_REFLECTANCE),
        ..Material::diffuse(Vec3::ZERO)
    };
    let [x, z] = [0, 1].map(|axis| foot.iter().map(|corner| corner[axis]).sum::<f32>() * 0.25e-3);
    let ball = Model::uniform(shapes::sphere(BALL_M, 12), mirror);
    ball.moved(Vec3::new(x, BALL_M, z))
}

/// Top and sides of a block.
fn block(foot: [[f32; 2]; 4], height: f32) -> [[[f32; 3]; 4]; 5] {
    let at = |i: usize, y: f32| [foot[i % 4][0], y, foot[i % 4][1]];
    let side = |i: usize| [at(i, 0.0), at(i, height), at(i + 3, height), at(i + 3, 0.0)];
    let top = [at(0, height), at(1, height), at(2, height), at(3, height)];
    [top, side(0), side(1), side(2), side(3)]
}

/// Quads given in millimetres as a mesh in metres.
fn quads(corners: &[[[f32; 3]; 4]]) -> Mesh {
    let first = (0..corners.len() as u32).map(|q| 4 * q);
    Mesh {
        positions: corners
            .as_flattened()
            .iter()
            .map(|p| Vec3::from(*p) * 1e-3)
            .collect(),
        normals: Vec::new(),
        triangles: first
            .flat_map(|v| [[v, v + 1, v + 2], [v, v + 2, v + 3]])
            .collect(),
        materials: vec![0; 2 * corners.len()],
    }
}
