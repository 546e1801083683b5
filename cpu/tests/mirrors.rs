//! Mirrors whose shading normals are not those of their triangles.

mod support;

use glam::Vec3;
use interreflect_scene::{Environment, LatLongImage, LightPaths, Material, Role};
use std::f64::consts::{PI, TAU};
use support::estimates::irradiance;
use support::{cpu, glowing, object, point, points, quad};

/// Radiance from infinitely far away, by direction: brighter towards +x and −z.
fn sky(direction: Vec3) -> f32 {
    1.0 + 0.6 * direction.x - 0.3 * direction.z
}

/// A mirror floor, seen from just above by a point that looks down; its vertex normals lean away from +y, all
/// alike. Light comes from where the leaning normal mirrors it, so long as that is above the floor; were the
/// floor's own normal taken, the mean of this sky, π/2 for a reflectance of a half.
#[test]
fn a_mirror_reflects_about_its_shading_normal() {
    let (width, height) = (256, 128);
    let mut image = LatLongImage {
        width,
        height,
        texels: Vec::new(),
    };
    for (row, column) in (0..height).flat_map(|r| (0..width).map(move |c| (r, c))) {
        let direction = image.direction(column as f32 + 0.5, row as f32 + 0.5);
        image.texels.push(Vec3::splat(sky(direction)));
    }
    let down = points([point(Vec3::Y * 0.001, Vec3::NEG_Y)]);
    for lean in [
        Vec3::ZERO,
        Vec3::new(0.3, 0.0, 0.0),
        Vec3::new(-0.2, 0.0, 0.25),
    ] {
        let normal = (Vec3::Y + lean).normalize();
        let corners = [(-9.0, -9.0), (-9.0, 9.0), (9.0, 9.0), (9.0, -9.0)];
        let mut floor = quad(corners.map(|(x, z)| Vec3::new(x, 0.0, z)), 0);
        floor.normals = vec![normal; 4];
        let mirror = Material {
            specular: Vec3::splat(0.5),
            mirror: true,
            ..glowing(0.9, 0.0)
        };
        let mut scene = support::scene(vec![object(Role::Environment, floor)], vec![mirror]);
        scene.environment = Some(Environment {
            image: image.clone(),
            scale: 1.0,
            rotate_deg: 0.0,
        });
        let traced = irradiance(&cpu(&scene), &down, LightPaths::ALL, 4096);
        let found = f64::from(traced.mean.get(0).x);
        let expected = mirrored_irradiance(normal);
        // 4,096 stratified samples of a smooth sky with an edge where light would come through the floor.
        let error = (found / expected - 1.0).abs();
        assert!(error < 0.01, "{lean}: {found}, not {expected}");
    }
}

/// ½∫cos θ·L(r) over the directions downwards, r mirrored about the normal, where r goes up.
fn mirrored_irradiance(normal: Vec3) -> f64 {
    const STEPS: u32 = 500;
    let mut sum = 0.0;
    for (i, j) in (0..STEPS).flat_map(|i| (0..STEPS).map(move |j| (i, j))) {
        let [u, v] = [i, j].map(|k| (f64::from(k) + 0.5) / f64::from(STEPS));
        let (r, (sin, cos)) = (u.sqrt(), (TAU * v).sin_cos());
        let d = Vec3::new(
            (r * cos) as f32,
            -((1.0 - u).sqrt() as f32),
            (r * sin) as f32,
        );
        let mirrored = d - 2.0 * d.dot(normal) * normal;
        if mirrored.y > 0.0 {
            sum += f64::from(sky(mirrored));
        }
    }
    0.5 * PI * sum / f64::from(STEPS * STEPS)
}
