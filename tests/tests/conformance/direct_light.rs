//! Direct light of pictures: by hand before one wall, and on both backends alike.

use crate::ensure;
use crate::radiance_maps;
use crate::test_scenes::{TestScene, room};
use crate::variants::{Outcome, cpu_scene, on_both, on_gpu};
use glam::Vec3;
use interreflect_estimators::Tolerance;
use interreflect_estimators::execution::{BackendScene, GpuLoadedScene};
use interreflect_gpu::GpuContext;
use interreflect_scene::material::blinn_phong_normalisation;
use interreflect_scene::{
    DirectLight, Estimate, Light, Material, Mesh, Object, Point, PointLayout, Points,
    ReflectionLaw, Role, Scene, SurfaceMaterial,
};
use libtest_mimic::{Failed, Trial};
use std::f64::consts::PI;
use std::sync::{Arc, LazyLock};

pub(crate) fn trials() -> Vec<Trial> {
    let mut trials = Vec::from(on_both(
        "direct_light/known_by_hand",
        || &UNDER_A_LAMP,
        known_by_hand,
        known_by_hand,
    ));
    trials.push(on_gpu(
        "direct_light/backends_agree/gpu".into(),
        backends_agree,
    ));
    trials
}

/// A lamp 2 m above two points, one of which a receiver shades.
static UNDER_A_LAMP: LazyLock<TestScene> = LazyLock::new(|| {
    let mut scene: Scene = room([0.0; 6], Vec3::ZERO);
    let corner = |x: f32, z: f32| Vec3::new(1.0 + x, 0.5, z);
    scene.objects = vec![Object {
        motion: None,
        name: "shade".into(),
        role: Role::Receiver,
        mesh: Mesh {
            positions: vec![
                corner(-0.6, -0.5),
                corner(-0.6, 0.5),
                corner(0.6, 0.5),
                corner(0.6, -0.5),
            ],
            normals: Vec::new(),
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            materials: vec![0; 2],
        },
    }];
    scene.materials = vec![Material::diffuse(Vec3::splat(0.5))];
    scene.lights = vec![Light::Point {
        position: Vec3::new(0.0, 2.0, 0.0),
        intensity: Vec3::new(3.0, 2.0, 1.0),
        picture: None,
    }];
    let at = |x: f32| {
        Some(Point {
            position: Vec3::new(x, 0.0, 0.0),
            normal: Vec3::Y,
            view: Vec3::new(0.6, 0.8, 0.0),
            material: SurfaceMaterial {
                diffuse: Vec3::new(0.5, 0.25, 1.0),
                specular: Vec3::splat(0.3),
                shininess: 8.0,
            },
            footprint: 0.0,
        })
    };
    TestScene::new("under-a-lamp", &scene, vec![at(0.0), at(1.2), None])
});

fn computed<S: BackendScene>(
    loaded: &S,
    points: &Points,
    how: DirectLight,
) -> Result<Estimate, Failed> {
    let mut placed = loaded.place(points)?;
    loaded.direct_light(&mut placed, how)?;
    Ok(loaded.read_back(&placed.out)?.0)
}

fn known_by_hand<S: BackendScene>(loaded: &S, test_scene: &TestScene) -> Outcome {
    let points = test_scene.points(PointLayout::Material);
    // A few products in float32, and the GPU's powers.
    let rounding = Tolerance {
        absolute: 1e-7,
        relative: 2e-5,
        cause: "float32 products and a power",
    };
    for law in [ReflectionLaw::Lambert, ReflectionLaw::BlinnPhong] {
        for shadows in [true, false] {
            let found = computed(loaded, &points, DirectLight { law, shadows })?;
            for (i, point) in points.iter().enumerate() {
                let Some(point) = point else {
                    ensure!(found.get(i) == Vec3::ZERO, "light without a surface");
                    continue;
                };
                let to_lamp = glam::DVec3::new(0.0, 2.0, 0.0) - point.position.as_dvec3();
                let direction = to_lamp.normalize();
                let half = (direction + point.view.as_dvec3()).normalize();
                let lobe = match law {
                    ReflectionLaw::Lambert => 0.0,
                    ReflectionLaw::BlinnPhong => {
                        0.3 * half.y.powi(8) * blinn_phong_normalisation(8.0)
                    }
                };
                let dark = shadows && i == 1;
                let arriving = if dark {
                    0.0
                } else {
                    direction.y / to_lamp.length_squared()
                };
                for (channel, (intensity, diffuse)) in [(3.0, 0.5), (2.0, 0.25), (1.0, 1.0)]
                    .into_iter()
                    .enumerate()
                {
                    let expected = intensity * arriving * (diffuse / PI + lobe);
                    rounding
                        .check(f64::from(found.get(i)[channel]), expected)
                        .map_err(|e| format!("{law:?}, shadows {shadows}, point {i}: {e}"))?;
                }
            }
        }
    }
    Ok(())
}

/// Largest share of points at a shadow's edge: the floor is at most 2 m from a light, where a texel of a shadow map is
/// 4 mm wide, and all edges on its 4 m² are shorter than 5 m; a band of a texel on each side is 1 % of it.
const AT_EDGES: f64 = 0.01;

/// Points on the floor of the lit box, on the ball that shades it, and none behind.
fn under_a_ball(light: usize) -> TestScene {
    let on_floor = (0..1024).map(|i| {
        let [x, z] = [i % 32, i / 32].map(|k| (k as f32 + 0.5) / 16.0 - 1.0);
        (Vec3::new(0.98 * x, -1.0, 0.98 * z), Vec3::Y)
    });
    let centre = radiance_maps::BALL;
    let on_ball = (0..256).map(|i| {
        let y = (i as f32 + 0.5) / 128.0 - 1.0;
        let (sin, cos) = (2.4 * i as f32).sin_cos();
        let normal = Vec3::new(cos * (1.0 - y * y).sqrt(), y, sin * (1.0 - y * y).sqrt());
        // Outside of the ball, whose mesh of 12² facets a part lies within 1 cm of.
        (centre + normal * (radiance_maps::BALL_M + 0.01), normal)
    });
    let point = |(position, normal)| {
        Some(Point {
            position,
            normal,
            view: normal,
            material: SurfaceMaterial {
                diffuse: Vec3::splat(0.5),
                specular: Vec3::splat(0.3),
                shininess: 8.0,
            },
            footprint: 0.0,
        })
    };
    radiance_maps::with_a_ball(
        Role::Receiver,
        &radiance_maps::LIGHTS[light..=light],
        on_floor.chain(on_ball).map(point).collect(),
    )
}

/// Every kind of light, with a receiver in its way: shadows differ at their edges alone.
fn backends_agree(context: &Arc<GpuContext>) -> Outcome {
    for light in 0..radiance_maps::LIGHTS.len() {
        let test_scene = under_a_ball(light);
        let points = test_scene.points(PointLayout::Material);
        let host = cpu_scene(&test_scene);
        let device = GpuLoadedScene::new(context, host.clone())?;
        for law in [ReflectionLaw::Lambert, ReflectionLaw::BlinnPhong] {
            let ours = computed(&host, &points, law.into())?;
            // What was there before is overwritten.
            let mut placed = device.place(&points)?;
            device.direct_light(&mut placed, ReflectionLaw::BlinnPhong.into())?;
            device.direct_light(&mut placed, law.into())?;
            let theirs = device.read_back(&placed.out)?.0;
            let name = format!("light {light}, {law:?}");
            let lit = ours.iter().filter(|v| *v != Vec3::ZERO).count();
            let without = DirectLight {
                law,
                shadows: false,
            };
            let unshadowed = computed(&host, &points, without)?;
            let shaded = ours.iter().zip(unshadowed.iter());
            let shaded = shaded
                .filter(|(a, b)| *a == Vec3::ZERO && *b != Vec3::ZERO)
                .count();
            ensure!(
                lit > 50 && shaded > 20,
                "{name}: {lit} points are lit, {shaded} in shadow"
            );
            let largest = ours.iter().fold(0.0, |m: f32, v| m.max(v.max_element()));
            // Float32 products and a power: 1e-4 of the largest.
            let apart = |(a, b): (Vec3, Vec3)| (a - b).abs().max_element() > 1e-4 * largest;
            let elsewhere = ours.iter().zip(theirs.iter()).filter(|&pair| apart(pair));
            let share = elsewhere.count() as f64 / points.len() as f64;
            println!("{name}: {:.2} % of points differ", 100.0 * share);
            ensure!(
                share <= AT_EDGES,
                "{name}: {:.2} % of points differ",
                100.0 * share
            );
        }
    }
    Ok(())
}
