//! Scenes whose light is known, made by hand.
#![allow(dead_code, reason = "each test binary uses a part")]

pub(crate) mod estimates;

use glam::Vec3;
use interreflect_cpu::scene::CpuScene;
use interreflect_scene::{
    Camera, Environment, Light, Material, Mesh, Object, Point, PointLayout, Points, Role, Scene,
    SceneMotion,
};

/// A scene without lights or environment.
pub(crate) fn scene(objects: Vec<Object>, materials: Vec<Material>) -> Scene {
    Scene {
        name: "test".into(),
        objects,
        materials,
        lights: Vec::new(),
        environment: None,
        camera: Camera {
            eye: Vec3::ZERO,
            target: Vec3::Z,
            up: Vec3::Y,
            vfov_deg: 60.0,
            resolution: [4, 4],
        },
        reference_point: Vec3::ZERO,
        captured_at: None,
        motion: SceneMotion::default(),
    }
}

pub(crate) fn lit(mut scene: Scene, light: Light) -> Scene {
    scene.lights.push(light);
    scene
}

pub(crate) fn under(mut scene: Scene, radiance: f32) -> Scene {
    scene.environment = Some(Environment::constant(Vec3::splat(radiance)));
    scene
}

pub(crate) fn object(role: Role, mesh: Mesh) -> Object {
    Object {
        name: "mesh".into(),
        role,
        mesh,
        motion: None,
    }
}

/// Two triangles from corners that run counter-clockwise seen from the front.
pub(crate) fn quad(corners: [Vec3; 4], material: u32) -> Mesh {
    Mesh {
        positions: corners.to_vec(),
        normals: Vec::new(),
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        materials: vec![material; 2],
    }
}

/// The walls of a box in the order +x −x +y −y +z −z, fronts inside, wall w of material w.
pub(crate) fn room(low: Vec3, high: Vec3) -> Mesh {
    let mut mesh = Mesh::default();
    for wall in 0..6u32 {
        let axis = wall as usize / 2;
        let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
        let positive = wall % 2 == 0;
        let first = mesh.positions.len() as u32;
        for (s, t) in [(0, 0), (1, 0), (1, 1), (0, 1)] {
            let mut corner = if positive { high } else { low };
            corner[a] = if s == 1 { high[a] } else { low[a] };
            corner[b] = if t == 1 { high[b] } else { low[b] };
            mesh.positions.push(corner);
        }
        // a × b points along +axis: reversed on the positive wall to face inwards.
        let order = if positive { [0, 3, 2, 1] } else { [0, 1, 2, 3] };
        mesh.triangles.push([0, 1, 2].map(|i| first + order[i]));
        mesh.triangles.push([0, 2, 3].map(|i| first + order[i]));
        mesh.materials.extend([wall; 2]);
    }
    mesh
}

/// The room [−1, 1]³ with one material per wall.
pub(crate) fn walls(materials: [Material; 6]) -> Scene {
    let mesh = room(Vec3::NEG_ONE, Vec3::ONE);
    scene(vec![object(Role::Environment, mesh)], materials.to_vec())
}

/// A grey surface that also emits.
pub(crate) fn glowing(albedo: f32, radiance: f32) -> Material {
    Material {
        emission: Vec3::splat(radiance),
        ..Material::diffuse(Vec3::splat(albedo))
    }
}

/// A sphere of `2·n²·6` triangles around the origin from the faces of a cube, fronts outside or
/// inside.
pub(crate) fn sphere(radius: f32, n: u32, inside: bool, smooth: bool) -> Mesh {
    let mut mesh = Mesh::default();
    for face in 0..6 {
        let at = |i: u32| f64::from(i) / f64::from(n) * 2.0 - 1.0;
        let warp = |x: f64| (x * std::f64::consts::FRAC_PI_4).tan();
        for row in 0..=n {
            for column in 0..=n {
                let l = interreflect_scene::conventions::cube_vector(
                    face,
                    warp(at(column)),
                    warp(at(row)),
                );
                let unit = l.normalize().as_vec3();
                mesh.positions.push(unit * radius);
                if smooth {
                    mesh.normals.push(if inside { -unit } else { unit });
                }
            }
        }
        for row in 0..n {
            for column in 0..n {
                let v = face as u32 * (n + 1) * (n + 1) + row * (n + 1) + column;
                for [a, b, c] in [[v, v + n + 1, v + 1], [v + 1, v + n + 1, v + n + 2]] {
                    let [p, q, r] = [a, b, c].map(|i| mesh.positions[i as usize]);
                    let outward = (q - p).cross(r - p).dot(p) > 0.0;
                    mesh.triangles.push(if outward == inside {
                        [a, c, b]
                    } else {
                        [a, b, c]
                    });
                    mesh.materials.push(0);
                }
            }
        }
    }
    mesh
}

pub(crate) fn point(position: Vec3, normal: Vec3) -> Option<Point> {
    Some(Point {
        position,
        normal: normal.normalize(),
        ..Point::default()
    })
}

pub(crate) fn points(list: impl IntoIterator<Item = Option<Point>>) -> Points {
    Points::new(PointLayout::Surface, list)
}

pub(crate) fn cpu(scene: &Scene) -> CpuScene {
    CpuScene::new(scene).expect("a valid scene")
}

/// Evenly spread unit vectors (a Fibonacci spiral).
pub(crate) fn directions(count: usize) -> impl Iterator<Item = Vec3> {
    (0..count).map(move |i| {
        let z = 1.0 - (2 * i + 1) as f32 / count as f32;
        let (s, c) = (i as f32 * 2.399_963_2).sin_cos();
        let r = (1.0 - z * z).sqrt();
        Vec3::new(r * c, r * s, z)
    })
}
