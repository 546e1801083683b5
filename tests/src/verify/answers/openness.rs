//! Openness beside simple occluders, each turned six ways.

use super::{Answer, Reduce, Setting, facing, orientations, scene};
use crate::oracles::form_factors::{
    openness_beside_half_space, openness_beside_sphere, openness_in_pit, perpendicular_rectangle,
};
use glam::{DQuat, DVec3, Quat, Vec3};
use interreflect_estimators::{Answers, OwnModel, Quantity};
use interreflect_scene::{Material, Mesh, shapes};

pub(super) fn all() -> Vec<Answer> {
    let answer = |name, about, settings| Answer {
        name,
        about,
        kind: Answers::Openness,
        settings,
        reduce: Reduce::Each,
    };
    vec![
        answer("open", "nothing occludes: 1", |_, q| {
            turned(q, Vec::new(), DVec3::ZERO, DVec3::Z, 1.0)
        }),
        answer("in_pit", "on the floor of a pit", pit),
        answer("beside_wall", "on the ground before a wall", wall),
        answer(
            "beside_half_space",
            "tilted above a wide ground",
            half_space,
        ),
        answer("beside_sphere", "under a sphere", sphere),
    ]
}

/// The same, turned six ways.
fn turned(
    quantity: Quantity,
    occluders: Vec<Mesh>,
    x: DVec3,
    n: DVec3,
    openness: f64,
) -> Option<Vec<Setting>> {
    let black = Material::diffuse(Vec3::ZERO);
    let turned = |axis: DVec3| {
        let turn = DQuat::from_axis_angle(axis, 1.9);
        let meshes = occluders.iter().map(|mesh| {
            let mut mesh = mesh.clone();
            let turn = turn.as_quat();
            mesh.positions.iter_mut().for_each(|p| *p = turn * *p);
            mesh.normals.clear();
            (mesh, black)
        });
        Setting {
            scene: scene(meshes.collect(), DVec3::ZERO),
            points: vec![(facing(turn * x, turn * n), DVec3::splat(openness))],
        }
    };
    (quantity == Quantity::AmbientOcclusion).then(|| orientations(6).map(turned).collect())
}

fn pit(_: OwnModel, quantity: Quantity) -> Option<Vec<Setting>> {
    let (a, b, h) = (1.2, 0.8, 0.5);
    let size = DVec3::new(a, h, b).as_vec3();
    let mut mesh = shapes::cuboid(size, shapes::Facing::Inward);
    // Without its ceiling, the face +y.
    mesh.triangles.drain(4..6);
    mesh.materials.drain(4..6);
    let floor = DVec3::new(0.0, -0.5 * h, 0.0);
    turned(
        quantity,
        vec![mesh],
        floor,
        DVec3::Y,
        openness_in_pit(a, b, h),
    )
}

/// Upright on the point's plane, seen from its middle.
fn wall(_: OwnModel, quantity: Quantity) -> Option<Vec<Setting>> {
    let (height, width, distance) = (0.7, 2.0, 0.5);
    let mut mesh = shapes::quad(height as f32, width as f32);
    let upright = Quat::from_rotation_z(std::f32::consts::FRAC_PI_2);
    let place = DVec3::new(distance, 0.5 * height, 0.0).as_vec3();
    mesh.positions
        .iter_mut()
        .for_each(|p| *p = upright * *p + place);
    let occluded = 2.0 * perpendicular_rectangle(height, 0.5 * width, distance);
    turned(quantity, vec![mesh], DVec3::ZERO, DVec3::Y, 1.0 - occluded)
}

/// Far enough above the ground for what the bias of its map moves it; the lowest two degrees, which the
/// ground does not fill, count about 0.01.
fn half_space(_: OwnModel, quantity: Quantity) -> Option<Vec<Setting>> {
    let tilt = 50_f64.to_radians();
    let normal = DVec3::new(tilt.sin(), tilt.cos(), 0.0);
    let openness = openness_beside_half_space(tilt.cos());
    turned(
        quantity,
        vec![shapes::quad(12.0, 12.0)],
        DVec3::new(0.0, 0.25, 0.0),
        normal,
        openness,
    )
}

fn sphere(_: OwnModel, quantity: Quantity) -> Option<Vec<Setting>> {
    let (r, d) = (0.5, 1.1);
    let normal = DVec3::new(0.0, -1.0, 0.6).normalize();
    let openness = openness_beside_sphere(r, d, -normal.y);
    let ball = shapes::sphere(r as f32, 24);
    turned(
        quantity,
        vec![ball],
        DVec3::new(0.0, d, 0.0),
        normal,
        openness,
    )
}
