//! Mirrors in the lights' views.

use crate::ensure;
use crate::parity_views::views_apart;
use crate::test_scenes::{TEST_SCENES, TestScene, room};
use crate::variants::{Outcome, cpu_scene, on_both, on_gpu};
use glam::Vec3;
use interreflect_cpu::capture::rsm::capture_rsms as by_rays;
use interreflect_cpu::scene::CpuScene;
use interreflect_estimators::Tolerance;
use interreflect_estimators::execution::BackendScene;
use interreflect_gpu::{GpuContext, GpuScene, capture_rsms};
use interreflect_scene::rsm::MAX_MIRRORS;
use interreflect_scene::shapes;
use interreflect_scene::{
    Light, Material, Mesh, Object, Point, Role, RsmChannels, RsmImage, RsmSpec, RsmViews, Scene,
    SpotShape,
};
use libtest_mimic::{Failed, Trial};
use std::f64::consts::PI;
use std::sync::{Arc, LazyLock};

pub(super) fn trials() -> Vec<Trial> {
    let mut trials = Vec::from(on_both(
        "radiance_maps/plane_mirrors_are_mirrored_lights",
        || &BEFORE_A_MIRROR,
        plane_mirror,
        plane_mirror,
    ));
    trials.push(on_gpu("radiance_maps/views_agree/gpu".into(), views_agree));
    trials.push(on_gpu(
        "radiance_maps/coarse_views_show_what_rays_meet/gpu".into(),
        coarse_views,
    ));
    trials.push(Trial::test("radiance_maps/mirrors_end/cpu", mirrors_end));
    trials
}

/// Albedo of the wall, reflectance of the mirror, intensity of the light.
const WALL: f32 = 0.6;
const REFLECTANCE: f32 = 0.8;
const INTENSITY: f32 = 2.0;

fn quad(x: f32, half: f32, material: u32) -> Object {
    let corner = |y: f32, z: f32| Vec3::new(x, y * half, z * half);
    Object {
        motion: None,
        name: format!("quad at {x}"),
        role: Role::Environment,
        mesh: Mesh {
            positions: vec![
                corner(-1.0, -1.0),
                corner(1.0, -1.0),
                corner(1.0, 1.0),
                corner(-1.0, 1.0),
            ],
            normals: Vec::new(),
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            materials: vec![material; 2],
        },
    }
}

fn spot(x: f32, direction: Vec3, intensity: f32) -> Light {
    Light::Spot {
        position: Vec3::new(x, 0.0, 0.0),
        direction,
        up: Vec3::Y,
        shape: SpotShape::Square,
        angle_deg: 40.0,
        intensity: Vec3::splat(intensity),
    }
}

/// A wall at x = −2 and these objects, with points before it.
fn before_the_wall(objects: Vec<Object>, light: Light) -> TestScene {
    let mut scene: Scene = room([0.0; 6], Vec3::ZERO);
    scene.objects = objects;
    scene.objects.push(quad(-2.0, 4.0, 0));
    scene.materials = vec![
        Material::diffuse(Vec3::splat(WALL)),
        Material {
            mirror: true,
            specular: Vec3::splat(REFLECTANCE),
            ..Material::diffuse(Vec3::ZERO)
        },
    ];
    scene.lights = vec![light];
    let at = |x, y, z| {
        Some(Point {
            position: Vec3::new(x, y, z),
            normal: Vec3::NEG_X,
            ..Point::default()
        })
    };
    let points = vec![at(-1.0, 0.0, 0.0), at(0.3, 0.2, 0.1), at(-1.9, 0.5, -0.7)];
    TestScene::new("before-the-wall", &scene, points)
}

/// A spot at the origin that shines away from the wall, on a mirror at x = 1.
static BEFORE_A_MIRROR: LazyLock<TestScene> =
    LazyLock::new(|| before_the_wall(vec![quad(1.0, 2.0, 1)], spot(0.0, Vec3::X, INTENSITY)));

/// The same light where the mirror shows it, dimmed by the mirror, and no mirror.
static MIRRORED_LIGHT: LazyLock<TestScene> =
    LazyLock::new(|| before_the_wall(Vec::new(), spot(2.0, Vec3::NEG_X, INTENSITY * REFLECTANCE)));

/// A mirror counts what the light behind it would; with one sample that is computed by hand.
fn plane_mirror<S: BackendScene>(loaded: &S, test_scene: &TestScene) -> Outcome {
    let rounding = Tolerance {
        absolute: 1e-7,
        relative: 1e-5,
        cause: "float32 positions on the wall, 2e-7 m, seen from 0.1 m",
    };
    for settings in [
        &[("fidelity", "published")][..],
        &[("fidelity", "corrected"), ("samples_per_side", "15")],
        &[("solid_angle", "eq11")],
        &[("fidelity", "corrected"), ("surface", "blinn_phong")],
    ] {
        // A mirror reverses the order of texels: the samples' must be the same from both ends.
        let settings = &[settings, &[("map_resolution", "15")]].concat()[..];
        let mirrored = super::shaded(loaded, test_scene, settings)?;
        let direct = super::shaded(&cpu_scene(&MIRRORED_LIGHT), &MIRRORED_LIGHT, settings)?;
        ensure!(super::total(&direct) > 0.0, "{settings:?}: no light");
        super::same(&direct, &mirrored, &rounding).map_err(|e| format!("{settings:?}: {e}"))?;
    }
    let settings = [("fidelity", "corrected"), ("samples_per_side", "1")];
    // An odd number of texels has one in the middle.
    let settings = [&settings[..], &[("map_resolution", "3")]].concat();
    let estimate = super::shaded(loaded, test_scene, &settings)?;
    // From the light to the mirror 1 m, to the wall 3 m; from the wall to the point 1 m.
    let (b, r) = (4.0_f64, 1.0_f64);
    let half = (20.0_f64).to_radians().tan();
    let omega_sr = 4.0 * (half * half).atan2((2.0 * half * half + 1.0).sqrt());
    let radiance = f64::from(WALL * REFLECTANCE * INTENSITY) / PI / (b * b);
    let area = omega_sr * b * b;
    let by_hand = radiance * area / (r * r + area / PI);
    Ok(rounding.check(f64::from(estimate.get(0).x), by_hand)?)
}

/// Two mirrors that face each other send a ray to and fro: after [`MAX_MIRRORS`] it is given up.
fn mirrors_end() -> Outcome {
    let light = spot(0.0, Vec3::X, INTENSITY);
    let test_scene = before_the_wall(vec![quad(1.0, 2.0, 1), quad(-1.0, 9.0, 1)], light);
    let spec = RsmSpec {
        size: 3,
        views: RsmViews::Picture,
        channels: RsmChannels::default(),
    };
    let views = by_rays(&test_scene.cpu, spec);
    // The middle ray never leaves.
    ensure!(
        views.path_m[4] == 0.0,
        "{MAX_MIRRORS} mirrors: {:?}",
        views.path_m
    );
    Ok(())
}

/// Fraction of a ray's way by which a place may be off, and the share of texels that may be farther off: one
/// of the picture's 256, whose ray may meet an edge between triangles.
const OFF: f32 = 1e-3;
const ON_AN_EDGE: f64 = 1.0 / 256.0;

/// In the cave a triangle is smaller than a texel of a picture of 16²: each texel shows what the ray through its
/// middle meets all the same.
fn coarse_views(context: &Arc<GpuContext>) -> Outcome {
    let cave = TestScene::library("cave", &[]);
    let spec = RsmSpec {
        size: 16,
        views: RsmViews::Picture,
        channels: ALL_CHANNELS,
    };
    let rays = by_rays(&cave.cpu, spec);
    let on_device = GpuScene::new(context, cave.cpu.scene())?;
    let (view, _) = context.record("capture", |cx| capture_rsms(cx, &on_device, spec))?;
    let view = view.download(context)?;
    let elsewhere = |i: &usize| {
        let way = rays.path_m[*i];
        let apart = rays.position[*i].distance(view.position[*i]);
        (way > 0.0) != (view.path_m[*i] > 0.0) || apart > OFF * way
    };
    let count = (0..rays.texels()).filter(elsewhere).count();
    let share = count as f64 / rays.texels() as f64;
    println!("{count} of {} texels show something else", rays.texels());
    ensure!(share <= ON_AN_EDGE, "{count} texels show something else");
    Ok(())
}

const ALL_CHANNELS: RsmChannels = RsmChannels {
    radiance: true,
    normal: true,
    true_colors: true,
};

/// Views of both backends: without mirrors, with plane ones and with a curved one, through as many
/// reflections as there are.
fn views_agree(context: &Arc<GpuContext>) -> Outcome {
    let mirror = Material {
        mirror: true,
        specular: Vec3::new(0.9, 0.8, 0.7),
        ..Material::diffuse(Vec3::ZERO)
    };
    let with_mirror = |change: &dyn Fn(&mut Scene, u32)| {
        let mut scene = TEST_SCENES[1].cpu.scene().clone();
        scene.materials.push(mirror);
        let index = scene.materials.len() as u32 - 1;
        change(&mut scene, index);
        scene
    };
    let plain = TEST_SCENES[1].cpu.scene().clone();
    let blocks = with_mirror(&|scene, mirror| {
        let inner = scene.objects.len() - 1;
        for object in &mut scene.objects[inner / 2..] {
            object.mesh.materials.fill(mirror);
        }
    });
    let ball = |role| {
        with_mirror(&|scene, mirror| {
            let centre = Vec3::new(0.2, 0.4, 0.25);
            let mut mesh = shapes::sphere(0.1, 12);
            mesh.positions.iter_mut().for_each(|p| *p += centre);
            mesh.materials.fill(mirror);
            scene.objects.push(Object {
                motion: None,
                name: "ball".into(),
                role,
                mesh,
            });
        })
    };
    let (ball, receiver) = (ball(Role::Environment), ball(Role::Receiver));
    let all = TestScene::new("lit-box", super::LIT[4].cpu.scene(), Vec::new());
    let scenes = [
        ("cornell box", &plain),
        ("mirrors", &blocks),
        ("mirror ball", &ball),
        ("a receiver that is one", &receiver),
        ("all lights", all.cpu.scene()),
    ];
    for (name, scene) in scenes {
        let spec = RsmSpec {
            size: 64,
            views: RsmViews::Surround,
            channels: ALL_CHANNELS,
        };
        let ours = by_rays(&CpuScene::new(scene)?, spec);
        let on_device = GpuScene::new(context, scene)?;
        let (view, _) = context.record("capture", |cx| capture_rsms(cx, &on_device, spec))?;
        let theirs: RsmImage = view.download(context)?;
        let photons = ours.path_m.iter().filter(|b| **b > 0.0).count();
        ensure!(photons > ours.texels() / 8, "{name}: {photons} photons");
        views_apart(&ours, &theirs)
            .map_err(|e: Failed| format!("{name}: {}", e.message().unwrap_or_default()))?;
    }
    Ok(())
}
