//! Closed cubic rooms of edge 2, [−1, 1]³.

use crate::load::build::Model;
use crate::shapes::{self, Facing};
use crate::{Camera, LightPicture, Material};
use glam::Vec3;

/// Half the edge of a room in metres.
pub(super) const HALF: f32 = 1.0;

/// Where a room's lamp takes its picture: down, and wide enough to see the walls beside a receiver in the middle.
pub(super) const PICTURE: LightPicture = LightPicture {
    direction: Vec3::NEG_Y,
    up: Vec3::Z,
    angle_deg: 120.0,
};

/// Thickness of a divider in metres.
pub(super) const DIVIDER: f32 = 0.06;

/// A closed room, fronts inside, with a material per wall in the order +x −x +y −y +z −z.
pub(super) fn walls(materials: [Material; 6]) -> Model {
    let mut mesh = shapes::cuboid(Vec3::splat(2.0 * HALF), Facing::Inward);
    mesh.materials = (0..12).map(|t| t / 2).collect();
    Model {
        mesh,
        materials: materials.into(),
    }
}

/// A wall of the given albedo that also glows, with `glow` times its own colour.
pub(super) fn glowing(albedo: [f32; 3], glow: f32) -> Material {
    let albedo = Vec3::from(albedo);
    Material {
        emission: albedo * glow,
        ..Material::diffuse(albedo)
    }
}

/// A box standing in the room, all of one material.
pub(super) fn block(centre: Vec3, size: Vec3, material: Material) -> Model {
    Model::uniform(shapes::cuboid(size, Facing::Outward), material).moved(centre)
}

/// A camera just before the +z wall that sees the room around `target`.
pub(super) fn camera(target: Vec3) -> Camera {
    Camera {
        eye: Vec3::new(0.12, 0.18, 0.97),
        target,
        up: Vec3::Y,
        vfov_deg: 70.0,
        resolution: [512, 512],
    }
}
