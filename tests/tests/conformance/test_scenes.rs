//! The scenes that trials run on, each with points.

use crate::ensure;
use glam::{DVec3, Vec3};
use interreflect::view::{Shade, View};
use interreflect_conformance::verify::{BoxScene, Lighting, Placement};
use interreflect_cpu::scene::CpuScene;
use interreflect_scene::{
    Environment, Estimate, LatLongImage, Point, PointLayout, Points, Scene, SceneRequest,
    SurfaceMaterial,
};
use std::path::{Path, PathBuf};
use std::sync::{Arc, LazyLock};

/// A scene with points.
pub(crate) struct TestScene {
    pub(crate) name: &'static str,
    pub(crate) cpu: Arc<CpuScene>,
    points: Vec<Option<Point>>,
}

impl TestScene {
    /// A scene that the CPU takes, with points.
    pub(crate) fn new(name: &'static str, scene: &Scene, points: Vec<Option<Point>>) -> Self {
        Self {
            name,
            cpu: Arc::new(CpuScene::new(scene).expect("a scene that the CPU takes")),
            points,
        }
    }

    /// A scene of the library with settings, and what its camera sees.
    pub(crate) fn library(name: &'static str, settings: &[(&str, &str)]) -> Self {
        let set = settings
            .iter()
            .map(|&(name, value)| (name.into(), value.into()));
        let request = SceneRequest {
            set: set.collect(),
            ..SceneRequest::new(name)
        };
        let scene = interreflect_scene::open(&request).expect("a library scene");
        let mut test_scene = Self::new(name, &scene, Vec::new());
        let view = View::of_about(&test_scene.cpu, &scene.camera, (400, Shade::default()))
            .expect("a view with points");
        test_scene.points = view.points(PointLayout::Material).iter().collect();
        test_scene
    }

    /// Other points in the same scene.
    pub(crate) fn set_points(&mut self, points: Vec<Option<Point>>) {
        self.points = points;
    }

    /// Another scene at the same points.
    pub(crate) fn with_scene(&self, cpu: Arc<CpuScene>) -> Self {
        Self {
            cpu,
            points: self.points.clone(),
            ..*self
        }
    }

    /// The points in a layout.
    pub(crate) fn points(&self, layout: PointLayout) -> Points {
        Points::new(layout, self.points.iter().copied())
    }
}

/// The test_scenes, each set up when it is first needed.
pub(crate) static TEST_SCENES: [LazyLock<TestScene>; 5] = [
    LazyLock::new(|| TestScene::library("colored-room", &[])),
    LazyLock::new(|| TestScene::library("cornell-box", &[])),
    LazyLock::new(|| TestScene::library("studio", &[])),
    LazyLock::new(|| {
        let scene = room(ROOM_RADIANCES, ROOM_ORIGIN);
        TestScene::new("emitting-box", &scene, inside(400))
    }),
    LazyLock::new(|| {
        let mut scene = room([0.0; 6], ROOM_ORIGIN);
        scene.objects.clear();
        scene.environment = Some(Environment {
            image: gradient(),
            scale: 1.0,
            rotate_deg: 20.0,
        });
        TestScene::new("open-sky", &scene, inside(100))
    }),
];

/// Reference point of the box of `tests/points/`.
pub(crate) const ROOM_ORIGIN: Vec3 = Vec3::new(0.2, -0.1, 0.3);

/// Radiances of the walls of the box of `tests/points/`.
pub(crate) const ROOM_RADIANCES: [f32; 6] = [1.0, 0.2, 0.5, 0.8, 0.3, 0.6];

/// The box [−1, 1]³ with walls that emit inwards, in the order of cube faces.
pub(crate) fn room(radiances: [f32; 6], reference_point: Vec3) -> Scene {
    let box_scene = BoxScene {
        lighting: Lighting::Walls,
        half: Vec3::ONE,
        walls: radiances.map(Vec3::splat),
        specks: false,
        reach: [1.0; 6],
        sky: Vec3::ZERO,
        reference: reference_point,
        lamp: Vec3::ZERO,
        points: Vec::new(),
        placement: Placement::NONE,
    };
    box_scene.scene()
}

/// A box on the CPU, with these points.
pub(crate) fn box_with(radiances: [f32; 6], points: Vec<Option<Point>>) -> TestScene {
    TestScene::new("box", &room(radiances, ROOM_ORIGIN), points)
}

/// A smooth environment without symmetry.
fn gradient() -> LatLongImage {
    let mut image = LatLongImage {
        width: 64,
        height: 32,
        texels: Vec::new(),
    };
    for row in 0..image.height {
        for column in 0..image.width {
            let d = image.direction(column as f32 + 0.5, row as f32 + 0.5);
            let texel = Vec3::new(1.0 + 0.5 * d.x, 0.7 + 0.3 * d.y, 0.6 - 0.4 * d.z);
            image.texels.push(texel);
        }
    }
    image
}

/// Points all over [−0.6, 0.6]³ with normals all around, every thirteenth without a surface.
pub(crate) fn inside(count: usize) -> Vec<Option<Point>> {
    // Additive recurrence with the plastic constants of five dimensions: fills space evenly.
    const STEPS: [f64; 5] = [
        0.856_674_9,
        0.733_891_9,
        0.628_706_7,
        0.538_597_3,
        0.461_402_7,
    ];
    let point = |i: usize| {
        let u = STEPS.map(|step| (0.5 + step * i as f64).fract());
        let position = DVec3::new(u[0], u[1], u[2]) * 1.2 - 0.6;
        let (z, phi) = (2.0 * u[3] - 1.0, std::f64::consts::TAU * u[4]);
        let r = (1.0 - z * z).sqrt();
        let normal = DVec3::new(r * phi.cos(), r * phi.sin(), z);
        let view = (normal + DVec3::new(0.3, 0.5, -0.4)).normalize();
        (i % 13 != 7).then(|| Point {
            position: position.as_vec3(),
            normal: normal.as_vec3(),
            view: view.as_vec3(),
            material: SurfaceMaterial {
                diffuse: Vec3::new(0.6, 0.5, 0.4),
                specular: Vec3::new(0.2, 0.3, 0.4),
                shininess: [1.0, 5.0, 50.0][i % 3],
            },
            ..Point::default()
        })
    };
    (0..count).map(point).collect()
}

/// A file of `tests/points/`.
pub(crate) fn points_file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("points")
        .join(name)
}

/// Whether two estimates are the same, bit by bit.
pub(crate) fn same_bits(a: &Estimate, b: impl Iterator<Item = glam::Vec3>) -> Result<(), String> {
    for (i, (a, b)) in a.iter().zip(b).enumerate() {
        let bits = |v: glam::Vec3| v.to_array().map(f32::to_bits);
        ensure!(bits(a) == bits(b), "point {i} has {a} and {b}");
    }
    Ok(())
}
