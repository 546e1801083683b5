//! Direct light of pictures: by hand before one wall, and on both backends alike.

use crate::ensure;
use crate::test_scenes::{TEST_SCENES, TestScene, room};
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

/// Largest share of points at a shadow's edge, which is a map's texel wide: 0.11° from the light.
const AT_EDGES: f64 = 0.02;

fn backends_agree(context: &Arc<GpuContext>) -> Outcome {
    for test_scene in TEST_SCENES.iter() {
        let points = test_scene.points(PointLayout::Material);
        let host = cpu_scene(test_scene);
        let device = GpuLoadedScene::new(context, host.clone())?;
        for law in [ReflectionLaw::Lambert, ReflectionLaw::BlinnPhong] {
            let ours = computed(&host, &points, law.into())?;
            let theirs = computed(&device, &points, law.into())?;
            let largest = ours.iter().fold(0.0, |m: f32, v| m.max(v.max_element()));
            let apart = |(a, b): (Vec3, Vec3)| (a - b).abs().max_element() > 1e-3 * largest;
            let elsewhere = ours.iter().zip(theirs.iter()).filter(|&pair| apart(pair));
            let share = elsewhere.count() as f64 / points.len().max(1) as f64;
            println!(
                "{}, {law:?}: {:.2} % of points differ",
                test_scene.name,
                100.0 * share
            );
            ensure!(
                share <= AT_EDGES,
                "{}, {law:?}: {:.2} % of points differ",
                test_scene.name,
                100.0 * share
            );
        }
    }
    Ok(())
}
