//! What form factors of points and polygons must give, and how they must fail.

use crate::ensure;
use crate::test_scenes::{ROOM_ORIGIN, ROOM_RADIANCES, TEST_SCENES, TestScene, box_with, inside};
use crate::variants::{Outcome, configured, on_both, run};
use glam::{DVec3, Vec3};
use interreflect_estimators::Quantity;
use interreflect_estimators::execution::BackendScene;
use interreflect_scene::conventions::{CUBE_FACES, cube_vector, texel_centre};
use interreflect_scene::{Estimate, Point, PointLayout, Points, SceneRequest, open};
use libtest_mimic::{Failed, Trial};
use std::f64::consts::PI;
use std::sync::LazyLock;

pub(crate) fn trials() -> Vec<Trial> {
    macro_rules! both {
        ($check:ident, $test_scene:expr) => {
            on_both(
                concat!("form_factors/", stringify!($check)),
                || $test_scene,
                $check,
                $check,
            )
        };
    }
    [
        both!(polygons_close_a_furnace, &UNIFORM),
        both!(published_polygons_do_not_close_it, &UNIFORM),
        both!(point_lights_spike_along_a_wall, &ROOM),
        both!(point_lights_add_nothing_at_their_own_place, &ROOM),
        both!(polygons_do_not_spike_along_a_wall, &ROOM),
        both!(switches_of_polygons_change_what_they_should, &DIVIDED),
        both!(polygons_at_infinity_are_classic_mapping, &TEST_SCENES[4]),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// The box with walls of radiance 1 and with its own radiances, with points all over it.
static UNIFORM: LazyLock<TestScene> = LazyLock::new(|| box_with([1.0; 6], inside(300)));
static ROOM: LazyLock<TestScene> = LazyLock::new(|| box_with(ROOM_RADIANCES, inside(300)));

/// A room with a divider, points on both sides of it: from the far side, what is seen from the
/// reference point faces away.
static DIVIDED: LazyLock<TestScene> = LazyLock::new(|| {
    let scene = open(&SceneRequest::new("divided-room")).expect("a library scene");
    TestScene::new("divided-room", &scene, inside(300))
});

fn irradiance<S: BackendScene>(
    loaded: &S,
    id: &str,
    settings: &[(&str, &str)],
    points: &Points,
) -> Result<Estimate, Failed> {
    let variant = configured(id, Quantity::Irradiance, settings)?;
    run(loaded, &variant, points)
}

/// Values at the points that have a surface.
fn values(points: &Points, estimate: &Estimate) -> Vec<f64> {
    let shaded = points.iter().zip(estimate.iter());
    shaded
        .filter_map(|(point, e)| point.map(|_| f64::from(e.x)))
        .collect()
}

/// Inside a closed mesh of radiance 1 the irradiance is π. What is left of it is where a texel's
/// quadrilateral cuts off an edge of the box: half a percent at M = 8, and 2 % where mean distances
/// round the edges off.
fn polygons_close_a_furnace<S: BackendScene>(loaded: &S, test_scene: &TestScene) -> Outcome {
    let points = test_scene.points(PointLayout::Surface);
    for (corners, facing) in [
        ("exact", "clamped"),
        ("exact", "signed"),
        ("seamless", "signed"),
    ] {
        let settings = [
            ("fidelity", "corrected"),
            ("resolution", "8"),
            ("corners", corners),
            ("facing", facing),
        ];
        let estimate = irradiance(loaded, "polygon_form_factor", &settings, &points)?;
        let bound = if corners == "exact" { 0.005 } else { 0.02 };
        for (i, e) in values(&points, &estimate).into_iter().enumerate() {
            ensure!(
                (e / PI - 1.0).abs() < bound,
                "{corners}, {facing}, point {i}: {e}"
            );
        }
    }
    Ok(())
}

/// The reused angle and the missing clip: some points get a tenth more or less than π.
fn published_polygons_do_not_close_it<S: BackendScene>(
    loaded: &S,
    test_scene: &TestScene,
) -> Outcome {
    let points = test_scene.points(PointLayout::Surface);
    let settings = [("fidelity", "published"), ("resolution", "8")];
    let estimate = irradiance(loaded, "polygon_form_factor", &settings, &points)?;
    let worst = values(&points, &estimate)
        .into_iter()
        .map(|e| (e / PI - 1.0).abs())
        .fold(0.0, f64::max);
    ensure!(worst > 0.1, "published is within {worst:.3} of π");
    Ok(())
}

/// At a texel's own place, as float32 has it, the direction to it is rounding alone, and 1/r² is 10¹³: it must
/// not count. Walls of the greatest radiance, 1, give π; all other texels, points instead of surfaces, less than twice that.
fn point_lights_add_nothing_at_their_own_place<S: BackendScene>(
    loaded: &S,
    _: &TestScene,
) -> Outcome {
    let m = 4;
    let origin = ROOM_ORIGIN.as_dvec3();
    let texels = (0..CUBE_FACES)
        .flat_map(|face| (0..m * m).map(move |i| (face, i % m, i / m)))
        .filter_map(|(face, column, row)| {
            let l = cube_vector(face, texel_centre(m, column), texel_centre(m, row));
            let inward = -cube_vector(face, 0.0, 0.0);
            let distance = (1.0 + inward.dot(origin)) / -inward.dot(l);
            let place = origin + l * distance;
            // Others see two walls, and are on neither.
            let on_wall = place.abs().max_element() < 1.0 + 1e-9;
            on_wall.then(|| Point {
                position: place.as_vec3(),
                normal: inward.as_vec3(),
                ..Point::default()
            })
        });
    let points = Points::new(PointLayout::Surface, texels.map(Some));
    ensure!(points.len() > 50, "{} texels see one wall", points.len());
    let estimate = irradiance(loaded, "point_form_factor", &[("resolution", "4")], &points)?;
    for (i, e) in estimate.iter().enumerate() {
        ensure!(f64::from(e.x) < 2.0 * PI, "point {i}: {e}");
    }
    Ok(())
}

/// Gap between the wall and the points of a scan along it, in metres.
const GAP_M: f64 = 1e-3;

/// Points along the +x wall, facing it, on a line through the centres of the texels of M = 4 in
/// their second row: one at each centre, and so many steps between that the spikes, about as wide as
/// the gap, are resolved.
fn scan() -> Points {
    let m = 4;
    let origin = ROOM_ORIGIN.as_dvec3();
    let on_wall = |column: u32| {
        let l = cube_vector(0, texel_centre(m, column), texel_centre(m, 1));
        origin + l * ((1.0 - origin.x) / l.x)
    };
    let (first, last) = (on_wall(0), on_wall(m - 1));
    let steps = 1024 * (m - 1);
    let points = (0..=steps).map(|k| {
        let at = first.lerp(last, f64::from(k) / f64::from(steps));
        Some(Point {
            position: (at - DVec3::X * GAP_M).as_vec3(),
            normal: Vec3::X,
            ..Point::default()
        })
    });
    Points::new(PointLayout::Surface, points)
}

/// Largest value, and the mean.
fn peak(points: &Points, estimate: &Estimate) -> (f64, f64) {
    let values = values(points, estimate);
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    (values.into_iter().fold(0.0, f64::max), mean)
}

/// Near a texel's centre a point light is singular: there it exceeds the mean of the scan by two
/// orders of magnitude or more. `clamp` bounds it: each of 96 texels counts so much solid angle at
/// most, and the walls' radiance is 1 at most.
fn point_lights_spike_along_a_wall<S: BackendScene>(loaded: &S, _: &TestScene) -> Outcome {
    let points = scan();
    let estimate = irradiance(loaded, "point_form_factor", &[], &points)?;
    let (free, mean) = peak(&points, &estimate);
    ensure!(
        free > 100.0 * mean,
        "the peak is {free:.1}, the mean {mean:.3}"
    );
    for clamp in ["0.1", "1"] {
        let settings = [("clamp", clamp)];
        let estimate = irradiance(loaded, "point_form_factor", &settings, &points)?;
        let (clamped, _) = peak(&points, &estimate);
        let bound = 96.0 * clamp.parse::<f64>()?;
        ensure!(clamped <= bound, "clamp {clamp} leaves {clamped:.2}");
        ensure!(
            clamped < free / 100.0,
            "clamp {clamp} leaves {clamped:.2} of {free:.2}"
        );
    }
    Ok(())
}

/// The same scan with polygons: nowhere more than what the brightest wall could give.
fn polygons_do_not_spike_along_a_wall<S: BackendScene>(loaded: &S, _: &TestScene) -> Outcome {
    let points = scan();
    let settings = [("fidelity", "corrected")];
    let estimate = irradiance(loaded, "polygon_form_factor", &settings, &points)?;
    let (highest, _) = peak(&points, &estimate);
    let brightest = PI * f64::from(ROOM_RADIANCES[0]);
    // Quadrilaterals that cut the box's edges off may overlap a little.
    ensure!(highest < 1.05 * brightest, "{highest} of {brightest}");
    Ok(())
}

/// Each switch of `polygon_form_factor` changes the fidelity that it belongs to.
fn switches_of_polygons_change_what_they_should<S: BackendScene>(
    loaded: &S,
    test_scene: &TestScene,
) -> Outcome {
    let points = test_scene.points(PointLayout::Surface);
    let with =
        |settings: &[(&str, &str)]| irradiance(loaded, "polygon_form_factor", settings, &points);
    let published = with(&[])?;
    let corrected = with(&[("fidelity", "corrected")])?;
    ensure!(published != corrected, "the fidelities are the same");
    ensure!(
        published == with(&[("corners", "per_face"), ("radiance", "centre")])?,
        "published has other defaults than the paper"
    );
    ensure!(
        published == with(&[("facing", "clamped")])?,
        "facing changes what published gives"
    );
    ensure!(
        corrected == with(&[("fidelity", "corrected"), ("corners", "exact")])?,
        "corrected has no exact corners by itself"
    );
    for fidelity in ["published", "corrected"] {
        let base = with(&[("fidelity", fidelity)])?;
        let mut switches = vec![
            ("radiance", "corners"),
            ("corners", "nearest"),
            ("corners", "seamless"),
        ];
        if fidelity == "corrected" {
            switches.push(("corners", "per_face"));
            switches.push(("facing", "clamped"));
        }
        for switch in switches {
            ensure!(
                base != with(&[("fidelity", fidelity), switch])?,
                "{switch:?} changes nothing in {fidelity}"
            );
        }
    }
    Ok(())
}

/// Where nothing has a place, quadrilaterals are texels of a map at infinity. What parts the two:
/// radiance averaged over 16² texels a face against 32², each wrong by its share of the slope where
/// the horizon cuts it (1/16 rad · 2/3 · 1/16 ≈ 3e-3), and a bilinear lookup between 32 cells, 1e-3.
fn polygons_at_infinity_are_classic_mapping<S: BackendScene>(
    loaded: &S,
    test_scene: &TestScene,
) -> Outcome {
    let points = test_scene.points(PointLayout::Surface);
    let settings = [("fidelity", "corrected"), ("resolution", "16")];
    let polygons = irradiance(loaded, "polygon_form_factor", &settings, &points)?;
    let classic = irradiance(loaded, "classic_envmap", &[], &points)?;
    let pairs = values(&points, &polygons)
        .into_iter()
        .zip(values(&points, &classic));
    for (i, (a, b)) in pairs.enumerate() {
        ensure!((a / b - 1.0).abs() < 4e-3, "point {i}: {a} and {b}");
    }
    Ok(())
}
