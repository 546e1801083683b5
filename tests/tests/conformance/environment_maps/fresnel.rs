//! Schlick's factor, seen by a surface that reflects by its lobe alone under radiance 1.

use super::{Feed, environment, under};
use crate::ensure;
use crate::variants::Outcome;
use glam::Vec3;
use interreflect_estimators::Quantity;
use interreflect_scene::{Point, SurfaceMaterial};
use libtest_mimic::Failed;

const METHODS: [&str; 2] = ["sh_mip_envmap", "phong_envmap"];

/// The factor at these cosines between normal and viewer.
fn factors<S: Feed>(
    loaded: &S,
    method: &str,
    f_lambda: &str,
    cosines: &[f32],
) -> Result<Vec<f32>, Failed> {
    let image = environment(64, |_| Vec3::ONE);
    let point = |&c: &f32| Point {
        normal: Vec3::Z,
        view: Vec3::new((1.0 - c * c).max(0.0).sqrt(), 0.0, c),
        material: SurfaceMaterial {
            specular: Vec3::ONE,
            ..SurfaceMaterial::default()
        },
        ..Point::default()
    };
    let points: Vec<Point> = cosines.iter().map(point).collect();
    // Few texels are enough for radiance that is the same everywhere.
    let settings = [("f_lambda", f_lambda), ("resolution", "8")];
    let quantity = Quantity::GlossyRadiance;
    let estimate = under(loaded, &image, (method, &settings), quantity, &points)?;
    Ok(estimate.iter().map(|v| v.x).collect())
}

pub(super) fn schlick_grows_towards_grazing_angles<S: Feed>(loaded: &S) -> Outcome {
    let cosines: Vec<f32> = (0..=50).map(|i| 1.0 - i as f32 / 50.0).collect();
    for method in METHODS {
        for f_lambda in ["0", "0.04", "0.7", "1"] {
            let factors = factors(loaded, method, f_lambda, &cosines)?;
            let normal: f32 = f_lambda.parse()?;
            // Roundings of the filtered constant and of the factor.
            let at = |value: f32, expected: f32| (value - expected).abs() < 2e-6;
            ensure!(
                at(factors[0], normal) && at(factors[50], 1.0),
                "{method}: F is {} head-on for {f_lambda}, {} grazing",
                factors[0],
                factors[50]
            );
            let grows = factors.windows(2).all(|w| w[1] >= w[0] - 1e-6);
            ensure!(grows, "{method}, f = {f_lambda}: {factors:?}");
        }
        // From behind an interpolated normal the factor stays that of a grazing view.
        let behind = factors(loaded, method, "0.2", &[-0.3])?;
        ensure!(
            (behind[0] - 1.0).abs() < 2e-6,
            "{method}: {behind:?} behind"
        );
    }
    Ok(())
}

/// 2∫F·c dc = f + (1 − f)/21.
pub(super) fn schlick_averages_to_its_integral<S: Feed>(loaded: &S) -> Outcome {
    let count = 1000;
    let cosines: Vec<f32> = (0..count)
        .map(|i| (i as f32 + 0.5) / count as f32)
        .collect();
    for method in METHODS {
        for (f_lambda, f) in [("0", 0.0), ("0.2", 0.2)] {
            let factors = factors(loaded, method, f_lambda, &cosines)?;
            let terms = factors.iter().zip(&cosines);
            let sum: f64 = terms.map(|(f, c)| f64::from(*f) * f64::from(*c)).sum();
            let mean = 2.0 * sum / f64::from(count);
            let expected = f + (1.0 - f) / 21.0;
            // A midpoint rule of a thousand points, and float32.
            ensure!(
                (mean - expected).abs() < 3e-6,
                "{method}, f = {f}: {mean}, not {expected}"
            );
        }
    }
    Ok(())
}
