//! The switches between a paper's errata and their correction change what they should, and
//! nothing else.

use crate::ensure;
use crate::test_scenes::{ROOM_ORIGIN, TEST_SCENES, TestScene, box_with, inside};
use crate::variants::{Outcome, Variant, configured, on_both, run};
use glam::Vec3;
use interreflect_estimators::Quantity;
use interreflect_estimators::Tolerance;
use interreflect_estimators::execution::BackendScene;
use interreflect_scene::conventions::{
    CUBE_FACES, cube_vector, texel_centre, texel_solid_angle_sr,
};
use interreflect_scene::{Estimate, Point, Points};
use libtest_mimic::{Failed, Trial};
use std::f64::consts::PI;

pub(crate) fn trials() -> Vec<Trial> {
    macro_rules! both {
        ($check:ident, $test_scene:expr) => {
            on_both(
                concat!("errata/", stringify!($check)),
                || $test_scene,
                $check,
                $check,
            )
        };
    }
    [
        both!(solid_angle_is_of_published_alone, &TEST_SCENES[0]),
        both!(diffuse_lacks_one_over_pi_in_published, &TEST_SCENES[0]),
        both!(fidelities_meet_at_the_reference_point, &UNIFORM),
        both!(tables_average_the_reflectivity, &UNIFORM),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// A room of radiance 1, with points at the reference point.
static UNIFORM: std::sync::LazyLock<TestScene> = std::sync::LazyLock::new(|| {
    let points = inside(100).into_iter().map(|p| {
        p.map(|p| Point {
            position: ROOM_ORIGIN,
            ..p
        })
    });
    box_with([1.0; 6], points.collect())
});

fn localized(quantity: Quantity, settings: &[(&str, &str)]) -> Result<Variant, Failed> {
    configured("localized_cubemap", quantity, settings)
}

fn shaded<S: BackendScene>(
    loaded: &S,
    test_scene: &TestScene,
    quantity: Quantity,
    settings: &[(&str, &str)],
) -> Result<Estimate, Failed> {
    let points = test_scene.points(quantity.layout());
    run(loaded, &localized(quantity, settings)?, &points)
}

fn solid_angle_is_of_published_alone<S: BackendScene>(
    loaded: &S,
    test_scene: &TestScene,
) -> Outcome {
    for quantity in [Quantity::Irradiance, Quantity::GlossyRadiance] {
        let shaded = |fidelity, solid_angle| {
            let settings = [("fidelity", fidelity), ("solid_angle", solid_angle)];
            shaded(loaded, test_scene, quantity, &settings)
        };
        ensure!(
            shaded("corrected", "text")? == shaded("corrected", "shader")?,
            "solid_angle changes what corrected gives"
        );
        let (text, shader) = (shaded("published", "text")?, shaded("published", "shader")?);
        // 4/(M²l³ + 4/π) < 4/(M²l² + 4/π) for l > 1, and it grows with Δω'.
        let brighter = text
            .iter()
            .zip(shader.iter())
            .all(|(t, s)| t.cmple(s).all());
        ensure!(
            brighter && text != shader,
            "the shader's solid angles are not the larger ones"
        );
    }
    Ok(())
}

/// Without a lobe the published radiance is k_d·E, the corrected one k_d/π·E.
fn diffuse_lacks_one_over_pi_in_published<S: BackendScene>(
    loaded: &S,
    test_scene: &TestScene,
) -> Outcome {
    let matte = |p: Point| {
        let mut p = p;
        p.material.specular = Vec3::ZERO;
        // In published nothing is seen from behind.
        (p.normal.dot(p.view) > 0.01).then_some(p)
    };
    let points = test_scene.points(Quantity::GlossyRadiance.layout());
    let points = Points::new(points.layout(), points.iter().map(|p| p.and_then(matte)));
    for (fidelity, factor) in [("published", 1.0), ("corrected", 1.0 / PI)] {
        let settings = [("fidelity", fidelity)];
        let run = |quantity| run(loaded, &localized(quantity, &settings)?, &points);
        let (e, l) = (run(Quantity::Irradiance)?, run(Quantity::GlossyRadiance)?);
        let rounding = Tolerance {
            absolute: 1e-7,
            relative: 1e-5,
            cause: "float32 sums of 96 texels in another order of factors",
        };
        for (i, point) in points.iter().enumerate() {
            let Some(point) = point else { continue };
            for c in 0..3 {
                let expected = factor * f64::from(point.material.diffuse[c] * e.get(i)[c]);
                rounding
                    .check(f64::from(l.get(i)[c]), expected)
                    .map_err(|e| format!("{fidelity}, point {i}: {e}"))?;
            }
        }
    }
    Ok(())
}

/// At x = o both solid angles are those from o: Δω' in published, the exact Δω in corrected.
fn fidelities_meet_at_the_reference_point<S: BackendScene>(
    loaded: &S,
    test_scene: &TestScene,
) -> Outcome {
    let points = test_scene.points(Quantity::Irradiance.layout());
    for m in [1, 2, 4, 8] {
        let resolution = m.to_string();
        for (fidelity, solid_angle) in [
            ("published", "text"),
            ("published", "shader"),
            ("corrected", "text"),
        ] {
            let settings = [
                ("fidelity", fidelity),
                ("solid_angle", solid_angle),
                ("resolution", &resolution),
            ];
            let estimate = shaded(loaded, test_scene, Quantity::Irradiance, &settings)?;
            let omega = |column, row, l: f64| match (fidelity, solid_angle) {
                ("corrected", _) => texel_solid_angle_sr(m, column, row),
                (_, "text") => 4.0 / (f64::from(m * m) * l.powi(3) + 4.0 / PI),
                _ => 4.0 / (f64::from(m * m) * l.powi(2) + 4.0 / PI),
            };
            let rounding = Tolerance {
                absolute: 1e-6,
                relative: 1e-5,
                cause: "float32 sums of up to 384 texels",
            };
            for (i, point) in points.iter().enumerate() {
                let expected = point.map_or(0.0, |p| at_origin(m, p.normal, omega));
                rounding
                    .check(f64::from(estimate.get(i).y), expected)
                    .map_err(|e| format!("M = {m}, {fidelity}, {solid_angle}, point {i}: {e}"))?;
            }
        }
    }
    Ok(())
}

/// Σ (n·I)⁺·Δω over the texels.
fn at_origin(m: u32, normal: Vec3, omega: impl Fn(u32, u32, f64) -> f64) -> f64 {
    let mut sum = 0.0;
    for face in 0..CUBE_FACES {
        for (column, row) in (0..m * m).map(|i| (i % m, i / m)) {
            let l = cube_vector(face, texel_centre(m, column), texel_centre(m, row));
            let cos_theta = normal.as_dvec3().dot(l.normalize()).max(0.0);
            sum += cos_theta * omega(column, row, l.length());
        }
    }
    sum
}

/// At the middle of a room of radiance 1 the irradiance is π, and the sum over texels misses it by
/// how badly one sample stands for the cosine over a texel: averages from a table miss it by less at
/// M = 1 and 2: what is left is the difference between a texel and a cap. As M grows the two agree.
fn tables_average_the_reflectivity<S: BackendScene>(loaded: &S, test_scene: &TestScene) -> Outcome {
    let points = test_scene.points(Quantity::Irradiance.layout());
    let errors = |m: &str, reflectivity: &str| -> Result<Vec<f64>, Failed> {
        let settings = [
            ("fidelity", "corrected"),
            ("resolution", m),
            ("reflectivity", reflectivity),
        ];
        let estimate = shaded(loaded, test_scene, Quantity::Irradiance, &settings)?;
        let shaded = points.iter().zip(estimate.iter());
        let of_pi = shaded.filter_map(|(p, e)| p.map(|_| f64::from(e.y) / PI - 1.0));
        Ok(of_pi.collect())
    };
    let rms = |errors: &[f64]| {
        let sum: f64 = errors.iter().map(|e| e * e).sum();
        (sum / errors.len() as f64).sqrt()
    };
    for m in ["1", "2"] {
        let (sample, table) = (rms(&errors(m, "sample")?), rms(&errors(m, "table")?));
        ensure!(
            table < 0.7 * sample,
            "M = {m}: rms {table:.4} from tables, {sample:.4} from samples"
        );
    }
    let (sample, table) = (errors("32", "sample")?, errors("32", "table")?);
    let apart = sample.iter().zip(&table).map(|(a, b)| (a - b).abs());
    let apart = apart.fold(0.0, f64::max);
    // A texel is 1/16 rad wide: its mean cosine differs by the bend over it, 1e-3, where the horizon
    // cuts it.
    ensure!(apart < 2e-3, "M = 32: {apart:.1e} apart");
    Ok(())
}
