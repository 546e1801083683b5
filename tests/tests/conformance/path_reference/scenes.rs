//! Scenes whose light is known, and places in them.

use crate::test_scenes::room;
use glam::Vec3;
use interreflect_cpu::scene::CpuScene;
use interreflect_scene::{
    Environment, Material, Mesh, Object, Point, PointLayout, Points, Role, Scene,
};

/// The box [−1, 1]³ with one material a wall, in the order of cube faces.
pub(super) fn walls(materials: [Material; 6]) -> Scene {
    let mut scene = room([0.0; 6], Vec3::ZERO);
    scene.materials = materials.into();
    scene
}

/// A grey surface that emits as well.
pub(super) fn glowing(albedo: f32, radiance: f32) -> Material {
    Material {
        emission: Vec3::splat(radiance),
        ..Material::diffuse(Vec3::splat(albedo))
    }
}

/// Nothing but these surfaces.
pub(super) fn only(surfaces: impl IntoIterator<Item = (Role, Mesh, Material)>) -> Scene {
    let mut scene = room([0.0; 6], Vec3::ZERO);
    (scene.objects, scene.materials) = (Vec::new(), Vec::new());
    for surface in surfaces {
        add(&mut scene, surface);
    }
    scene
}

/// One more surface.
pub(super) fn add(scene: &mut Scene, (role, mut mesh, material): (Role, Mesh, Material)) {
    mesh.materials.fill(scene.materials.len() as u32);
    scene.materials.push(material);
    scene.objects.push(Object {
        name: format!("surface {}", scene.objects.len()),
        role,
        mesh,
        motion: None,
    });
}

/// The same under a sky of constant radiance.
pub(super) fn under(mut scene: Scene, radiance: f32) -> Scene {
    scene.environment = Some(Environment::constant(Vec3::splat(radiance)));
    scene
}

/// The scene on the CPU.
pub(super) fn cpu(scene: &Scene) -> CpuScene {
    CpuScene::new(scene).expect("a scene that the CPU takes")
}

/// The mesh moved.
pub(super) fn moved(mut mesh: Mesh, by: Vec3) -> Mesh {
    mesh.positions.iter_mut().for_each(|p| *p += by);
    mesh
}

/// The mesh with its front on the other side.
pub(super) fn turned(mut mesh: Mesh) -> Mesh {
    mesh.triangles.iter_mut().for_each(|t| t.swap(1, 2));
    mesh.normals.clear();
    mesh
}

/// A planar polygon as a fan around its first corner; its front is where the corners run
/// counter-clockwise.
pub(super) fn polygon(corners: Vec<Vec3>) -> Mesh {
    let count = corners.len() as u32;
    Mesh {
        triangles: (2..count).map(|i| [0, i - 1, i]).collect(),
        materials: vec![0; count as usize - 2],
        positions: corners,
        normals: Vec::new(),
    }
}

/// Corners of [`disc`]: its area falls short of a circle's by (2π/512)²/6 = 2.5e-5 of it.
const CORNERS: u16 = 512;
/// What that is, rounded up.
pub(super) const DISC_ERROR: f64 = 3e-5;

/// A disc in a plane z = const whose front faces −z.
pub(super) fn disc(centre: Vec3, radius: f32) -> Mesh {
    let corner = |i: u16| {
        let (s, c) = (-f32::from(i) / f32::from(CORNERS) * std::f32::consts::TAU).sin_cos();
        centre + Vec3::new(c, s, 0.0) * radius
    };
    polygon((0..CORNERS).map(corner).collect())
}

/// Places with normals of any length.
pub(super) fn places(list: impl IntoIterator<Item = (Vec3, Vec3)>) -> Points {
    let point = |(position, normal): (Vec3, Vec3)| {
        Some(Point {
            position,
            normal: normal.normalize(),
            ..Point::default()
        })
    };
    Points::new(PointLayout::Surface, list.into_iter().map(point))
}

/// Evenly spread unit vectors (a Fibonacci spiral).
pub(super) fn directions(count: usize) -> impl Iterator<Item = Vec3> {
    (0..count).map(move |i| {
        let z = 1.0 - (2 * i + 1) as f32 / count as f32;
        let (s, c) = (i as f32 * 2.399_963_2).sin_cos();
        let r = (1.0 - z * z).sqrt();
        Vec3::new(r * c, r * s, z)
    })
}
