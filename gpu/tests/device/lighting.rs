//! Direct light and its shadows in captures, against the slow oracle.

use crate::capture::{OFF_CENTRE, capture};
use crate::oracle::{add_quad, add_room, empty, everything, first_hit, reached, texels};
use crate::{Case, ensure};
use glam::{DVec3, Vec3};
use interreflect_gpu::GpuContext;
use interreflect_scene::{Incident, Light, Material, Scene, SpotShape};
use libtest_mimic::Failed;
use std::sync::Arc;

pub(crate) const CASES: &[Case] = &[
    ("lighting::point", |c| matches_oracle(c, point())),
    ("lighting::cone_spot", |c| {
        matches_oracle(c, spot(SpotShape::Cone))
    }),
    ("lighting::square_spot", |c| {
        matches_oracle(c, spot(SpotShape::Square))
    }),
    ("lighting::directional", |c| {
        matches_oracle(c, directional())
    }),
    ("lighting::area", |c| matches_oracle(c, area())),
    (
        "lighting::walls_close_to_a_light_stay_lit",
        walls_close_to_a_light_stay_lit,
    ),
    ("lighting::lights_add_up", lights_add_up),
];

pub(crate) fn point() -> Light {
    Light::Point {
        position: Vec3::new(0.1, 0.8, -0.2),
        intensity: Vec3::new(3.0, 2.0, 1.0),
        picture: None,
    }
}

fn spot(shape: SpotShape) -> Light {
    let direction = Vec3::new(0.2, -1.0, 0.3).normalize();
    Light::Spot {
        position: Vec3::new(0.1, 0.8, -0.2),
        direction,
        up: direction.any_orthonormal_vector(),
        shape,
        angle_deg: 80.0,
        intensity: Vec3::new(3.0, 2.0, 1.0),
    }
}

fn directional() -> Light {
    Light::Directional {
        direction: Vec3::new(0.3, -1.0, 0.2).normalize(),
        irradiance: Vec3::new(3.0, 2.0, 1.0),
    }
}

fn area() -> Light {
    Light::Area {
        position: Vec3::new(0.1, 0.8, -0.2),
        normal: Vec3::new(0.1, -1.0, 0.0).normalize(),
        area_m2: 0.01,
        flux: Vec3::new(3.0, 2.0, 1.0),
        picture: None,
    }
}

/// A room without a ceiling, with an occluder between the light and the reference point.
pub(crate) fn lit_room(light: Light) -> Scene {
    let mut scene = empty(Vec3::new(0.2, -0.5, 0.3));
    let walls = [0.7, 0.1, 0.6, 0.6, 0.2, 0.7];
    add_room(
        &mut scene,
        walls.map(|a| Material::diffuse(Vec3::new(a, 0.5, 1.0 - a))),
    );
    scene.objects.remove(2);
    let corner = |x: f32, z: f32| Vec3::new(x, 0.2 + 0.3 * x, z);
    add_quad(
        &mut scene,
        [
            corner(-0.3, -0.4),
            corner(0.4, -0.4),
            corner(0.4, 0.2),
            corner(-0.3, 0.2),
        ],
        Material::diffuse(Vec3::splat(0.5)),
    );
    scene.lights.push(light);
    scene
}

/// What the oracle captures at a point, and `None` where a step of a shadow texel changes it.
fn reflected(scene: &Scene, light: &Light, direction: DVec3) -> Option<Vec3> {
    let origin = scene.reference_point.as_dvec3();
    let Some(hit) = first_hit(scene, origin, direction) else {
        return Some(Vec3::ZERO);
    };
    if hit.inside < 1e-2 {
        return None;
    }
    let normal = if hit.normal.dot(direction) < 0.0 {
        hit.normal
    } else {
        -hit.normal
    };
    let shining = |x: DVec3| {
        let incident = light.incident(x.as_vec3());
        let cos_theta = |i: &Incident| normal.dot(i.to_light.as_dvec3());
        incident.filter(|i| cos_theta(i) > 0.0 && reached(scene, light, x, normal))
    };
    let here = shining(hit.position);
    let (u, v) = normal.any_orthonormal_pair();
    // The light is up to 2.5 m away; shadow texels are 2/1024 of that wide, more where it grazes.
    let step = 3.0 * 2.5 * 2.0 / 1024.0;
    for k in 0..16 {
        let (sin, cos) = (f64::from(k) * std::f64::consts::PI / 8.0).sin_cos();
        for radius in [0.25 * step, step] {
            let there = shining(hit.position + (u * cos + v * sin) * radius);
            if there.is_some() != here.is_some() {
                return None;
            }
        }
    }
    let irradiance = here.map_or(Vec3::ZERO, |i| {
        i.irradiance * normal.dot(i.to_light.as_dvec3()) as f32
    });
    Some(hit.material.albedo * irradiance * std::f32::consts::FRAC_1_PI)
}

fn matches_oracle(context: &Arc<GpuContext>, light: Light) -> Result<(), Failed> {
    let scene = lit_room(light);
    let image = capture(context, &scene, everything(64))?;
    let (mut compared, mut dark) = (0, 0);
    for (i, direction) in texels(64) {
        let Some(expected) = reflected(&scene, &light, direction) else {
            continue;
        };
        let error = (image.radiance[i] - expected).abs().max_element();
        // Roundings of f32 in the position (1e-6 relative) and in the cosine near grazing.
        let tolerance = 1e-4 * expected.max_element() + 1e-6;
        ensure!(
            error < tolerance,
            "texel {i} {direction}: {} instead of {expected}",
            image.radiance[i]
        );
        compared += 1;
        dark += u32::from(expected == Vec3::ZERO);
    }
    let texels = 6 * 64 * 64;
    ensure!(
        compared > texels * 3 / 4,
        "only {compared} of {texels} texels were compared"
    );
    ensure!(
        dark > texels / 100 && dark < compared,
        "{dark} texels are dark: no shadow to test"
    );
    Ok(())
}

fn walls_close_to_a_light_stay_lit(context: &Arc<GpuContext>) -> Result<(), Failed> {
    for y in [0.9, 0.99, 0.999] {
        let mut scene = empty(OFF_CENTRE);
        add_room(&mut scene, [Material::diffuse(Vec3::ONE); 6]);
        scene.lights.push(Light::Point {
            position: Vec3::new(0.0, y, 0.0),
            intensity: Vec3::ONE,
            picture: None,
        });
        let image = capture(context, &scene, everything(64))?;
        let dark = image.radiance.iter().filter(|r| **r == Vec3::ZERO).count();
        // Along the edges of the room a shadow texel's centre may lie on the other wall.
        ensure!(
            dark < image.texels() / 1000,
            "light at y = {y}: {dark} texels are dark"
        );
    }
    Ok(())
}

fn lights_add_up(context: &Arc<GpuContext>) -> Result<(), Failed> {
    let lights = [point(), directional(), spot(SpotShape::Cone), area()];
    let spec = everything(32);
    let mut sum = vec![Vec3::ZERO; 6 * 32 * 32];
    for light in lights {
        let image = capture(context, &lit_room(light), spec)?;
        sum.iter_mut()
            .zip(&image.radiance)
            .for_each(|(s, r)| *s += *r);
    }
    let scene = Scene {
        lights: lights.to_vec(),
        ..lit_room(point())
    };
    let image = capture(context, &scene, spec)?;
    for (i, (one, sum)) in image.radiance.iter().zip(&sum).enumerate() {
        let error = (*one - *sum).abs().max_element();
        ensure!(
            error <= 1e-6 * sum.max_element(),
            "texel {i}: {one} instead of {sum}"
        );
    }
    Ok(())
}
