//! Pictures from the lights: `tests/points/drm.csv`, what the paper's solid angles do, and mirrors.

mod mirrors;
mod model;
mod pictures;
mod point_set;

use crate::ensure;
use crate::test_scenes::{TestScene, inside, room};
use crate::variants::{Outcome, configured, cpu_scene, gpu_scene, on_both, on_gpu, run};
use glam::Vec3;
use interreflect_estimators::Quantity;
use interreflect_estimators::Tolerance;
use interreflect_estimators::execution::BackendScene;
use interreflect_scene::{Estimate, Light, Material, Point, PointLayout, Scene, SpotShape};
use libtest_mimic::{Failed, Trial};
use std::sync::LazyLock;

pub(crate) use pictures::{BALL, BALL_M, with_a_ball};

pub(crate) fn trials() -> Vec<Trial> {
    macro_rules! both {
        ($check:ident, $test_scene:expr) => {
            on_both(
                concat!("radiance_maps/", stringify!($check)),
                || $test_scene,
                $check,
                $check,
            )
        };
    }
    let mut trials: Vec<Trial> = [
        both!(back_sides_are_lit_by_equations_11_and_15, &BELOW),
        both!(settings_change_what_they_should, &LIT[1]),
        both!(texels_of_the_picture_lose_most_light, &LIT[1]),
    ]
    .into_iter()
    .flatten()
    .collect();
    trials.push(Trial::test("radiance_maps/lights_add_up/cpu", || {
        lights_add_up(|test_scene| Ok(cpu_scene(test_scene)))
    }));
    trials.push(on_gpu(
        "radiance_maps/lights_add_up/gpu".into(),
        |context| lights_add_up(|test_scene| gpu_scene(context, test_scene)),
    ));
    trials.push(on_gpu(
        "radiance_maps/long_sums_come_in_parts/gpu".into(),
        |context| long_sums_come_in_parts(&gpu_scene(context, &LIT[5])?, &LIT[5]),
    ));
    trials.extend(pictures::trials());
    trials.extend(point_set::trials());
    trials.extend(mirrors::trials());
    trials.extend(model::trials());
    trials
}

/// The box with diffuse walls, open above, and these lights.
fn lit_box(lights: &[Light], points: Vec<Option<Point>>) -> TestScene {
    let mut scene: Scene = room([0.0; 6], Vec3::ZERO);
    let albedo = |face: usize| Vec3::new(0.3 + 0.1 * face as f32, 0.6, 0.8 - 0.1 * face as f32);
    scene.materials = (0..6).map(|face| Material::diffuse(albedo(face))).collect();
    // Two triangles a wall, in the order of cube faces.
    let mesh = &mut scene.objects[0].mesh;
    mesh.triangles.drain(4..6);
    mesh.materials.drain(4..6);
    scene.lights = lights.to_vec();
    TestScene::new("lit-box", &scene, points)
}

/// One light of each kind in the box; parallel light falls in from above.
pub(crate) const LIGHTS: [Light; 4] = [
    Light::Point {
        position: Vec3::new(0.3, 0.7, -0.2),
        intensity: Vec3::new(1.0, 0.8, 0.6),
        picture: None,
    },
    Light::Spot {
        position: Vec3::new(0.05, 0.9, 0.02),
        direction: Vec3::NEG_Y,
        up: Vec3::Z,
        shape: SpotShape::Cone,
        angle_deg: 60.0,
        intensity: Vec3::new(0.5, 1.0, 1.0),
    },
    Light::Area {
        position: Vec3::new(-0.2, 0.95, 0.3),
        normal: Vec3::NEG_Y,
        area_m2: 0.1,
        flux: Vec3::new(3.0, 2.0, 2.5),
        picture: None,
    },
    Light::Directional {
        direction: Vec3::new(0.6, -0.8, 0.0),
        irradiance: Vec3::ONE,
    },
];

/// Two lights none of whose 64² rays a view meets an edge of the box.
const OFF_EDGES: [Light; 2] = [
    Light::Point {
        position: Vec3::new(0.3137, 0.6971, -0.2113),
        intensity: Vec3::new(1.0, 0.8, 0.6),
        picture: None,
    },
    Light::Point {
        position: Vec3::new(-0.5171, 0.1319, 0.3391),
        intensity: Vec3::new(0.6, 0.7, 0.9),
        picture: None,
    },
];

/// The box with each light alone, with all of them, and with two off its edges.
static LIT: [LazyLock<TestScene>; 6] = [
    LazyLock::new(|| lit_box(&LIGHTS[..1], inside(100))),
    LazyLock::new(|| lit_box(&LIGHTS[1..2], inside(100))),
    LazyLock::new(|| lit_box(&LIGHTS[2..3], inside(100))),
    LazyLock::new(|| lit_box(&LIGHTS[3..], inside(100))),
    LazyLock::new(|| lit_box(&LIGHTS, inside(100))),
    LazyLock::new(|| lit_box(&OFF_EDGES, inside(100))),
];

/// Below the floor, on which alone the light falls, a point that looks up at its dark side.
static BELOW: LazyLock<TestScene> = LazyLock::new(|| {
    let below = Point {
        position: Vec3::new(0.05, -2.0, 0.05),
        normal: Vec3::Y,
        ..Point::default()
    };
    lit_box(&LIGHTS[1..2], vec![Some(below)])
});

fn shaded<S: BackendScene>(
    loaded: &S,
    test_scene: &TestScene,
    settings: &[(&str, &str)],
) -> Result<Estimate, Failed> {
    let variant = configured("direct_radiance_map", Quantity::Irradiance, settings)?;
    run(loaded, &variant, &test_scene.points(PointLayout::Surface))
}

/// Sum of all values.
fn total(estimate: &Estimate) -> f64 {
    estimate.iter().map(|v| f64::from(v.element_sum())).sum()
}

fn same(a: &Estimate, b: &Estimate, tolerance: &Tolerance) -> Result<(), String> {
    let values =
        |e: &Estimate| -> Vec<f64> { e.iter().flat_map(|v| v.to_array()).map(f64::from).collect() };
    tolerance.check_all(values(a).into_iter(), values(b).into_iter())
}

/// A documented erratum: equations 11 and 15 know no normals, so what lies behind a lit surface gets
/// light from it. Equation 14 and the corrected form give it none.
fn back_sides_are_lit_by_equations_11_and_15<S: BackendScene>(
    loaded: &S,
    test_scene: &TestScene,
) -> Outcome {
    for (settings, lit) in [
        ([("solid_angle", "eq11")], true),
        ([("solid_angle", "eq15")], true),
        ([("solid_angle", "eq14")], false),
        ([("fidelity", "corrected")], false),
    ] {
        let e = total(&shaded(loaded, test_scene, &settings)?);
        ensure!((e > 0.0) == lit, "{settings:?} gives {e} behind the floor");
    }
    Ok(())
}

fn settings_change_what_they_should<S: BackendScene>(
    loaded: &S,
    test_scene: &TestScene,
) -> Outcome {
    let with = |settings: &[(&str, &str)]| shaded(loaded, test_scene, settings);
    let published = with(&[])?;
    ensure!(
        published == with(&[("solid_angle", "eq14"), ("texel", "grid"), ("mip", "false")])?,
        "published has other defaults than it should"
    );
    let corrected = with(&[("fidelity", "corrected")])?;
    for solid_angle in ["eq11", "eq15"] {
        ensure!(
            corrected == with(&[("fidelity", "corrected"), ("solid_angle", solid_angle)])?,
            "{solid_angle} changes what corrected gives"
        );
    }
    let rounding = Tolerance {
        absolute: 1e-7,
        relative: 1e-5,
        cause: "float32 products in another order",
    };
    for base in [&[][..], &[("fidelity", "corrected")][..]] {
        let without = with(base)?;
        for switch in [
            ("texel", "texture"),
            ("mip", "true"),
            ("samples_per_side", "4"),
        ] {
            let switched = with(&[base, &[switch]].concat())?;
            ensure!(
                without != switched,
                "{switch:?} changes nothing in {base:?}"
            );
        }
        // The walls have no lobe.
        let shining = with(&[base, &[("surface", "blinn_phong")]].concat())?;
        same(&without, &shining, &rounding).map_err(|e| format!("{base:?}: {e}"))?;
    }
    ensure!(
        with(&[("solid_angle", "eq11")])? != with(&[("solid_angle", "eq15")])?,
        "equations 11 and 15 are the same"
    );
    Ok(())
}

/// With 3×3 samples of a picture of 16×16 a texel's own size counts 9/256 of the light: about 97 %
/// is lost, and as near photons are bounded as discs are, a little less.
fn texels_of_the_picture_lose_most_light<S: BackendScene>(
    loaded: &S,
    test_scene: &TestScene,
) -> Outcome {
    let grid = total(&shaded(loaded, test_scene, &[("texel", "grid")])?);
    let texture = total(&shaded(loaded, test_scene, &[("texel", "texture")])?);
    let kept = texture / grid;
    println!("kept: {:.2} %", 100.0 * kept);
    ensure!(
        (0.02..0.06).contains(&kept),
        "{:.2} % of the light is kept",
        100.0 * kept
    );
    Ok(())
}

/// Several lights give the sum of what each gives alone.
fn lights_add_up<S: BackendScene>(loaded: impl Fn(&TestScene) -> Result<S, Failed>) -> Outcome {
    let rounding = Tolerance {
        absolute: 1e-6,
        relative: 1e-5,
        cause: "float32 sums in another order",
    };
    for settings in [
        &[("solid_angle", "eq11")][..],
        &[("solid_angle", "eq14")],
        &[("solid_angle", "eq15")],
        &[("fidelity", "corrected"), ("mip", "true")],
    ] {
        let of = |test_scene: &TestScene| shaded(&loaded(test_scene)?, test_scene, settings);
        let together = of(&LIT[4])?;
        let mut sum = Estimate::new(together.len());
        for alone in &LIT[..4] {
            let alone = of(alone)?;
            ensure!(total(&alone) > 0.0, "{settings:?}: a light gives nothing");
            for i in 0..sum.len() {
                sum.set(i, sum.get(i) + alone.get(i));
            }
        }
        same(&together, &sum, &rounding).map_err(|e| format!("{settings:?}: {e}"))?;
    }
    Ok(())
}

/// Two point lights with 64×64 samples a view: 49,152 photons, more than one dispatch sums. On the
/// CPU there is no such limit.
fn long_sums_come_in_parts<S: BackendScene>(loaded: &S, test_scene: &TestScene) -> Outcome {
    let settings = [
        ("samples_per_side", "64"),
        ("map_resolution", "64"),
        ("fidelity", "corrected"),
        ("pictures", "surround"),
    ];
    let on_cpu = shaded(&cpu_scene(test_scene), test_scene, &settings)?;
    let tolerance = Tolerance {
        absolute: 1e-6,
        relative: 6e-5,
        cause: "float32 sums of 49,152 photons: 4·√N roundings",
    };
    Ok(same(
        &on_cpu,
        &shaded(loaded, test_scene, &settings)?,
        &tolerance,
    )?)
}
