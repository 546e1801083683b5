//! What each method gives in float64 in the box of `tests/points/room.obj`.

use crate::ensure;
use crate::room_points::{ROOM, Room};
use crate::test_scenes::TestScene;
use crate::variants::{Outcome, Variant, configured, cpu_scene, gpu_scene, on_both, on_gpu, run};
use interreflect_estimators::Quantity;
use interreflect_estimators::Tolerance;
use interreflect_estimators::execution::BackendScene;
use libtest_mimic::{Failed, Trial};
use std::f64::consts::PI;
use std::sync::Arc;

pub(crate) fn trials() -> Vec<Trial> {
    let one = ONE_COLUMN
        .iter()
        .map(|(column, id, settings)| Case::new(column, id, settings));
    let mut cases: Vec<Case> = one.collect();
    for m in ["2", "4", "8", "16"] {
        cases.extend(COLUMNS.iter().map(|(column, id, settings)| {
            let mut settings = settings.to_vec();
            settings.push(("resolution", m));
            Case::new(&format!("{column}_M{m}"), id, &settings)
        }));
    }
    let mut trials = Vec::from(on_both(
        "room/corrected_polygons_are_good_to_their_promise",
        || &ROOM.test_scene,
        promise,
        promise,
    ));
    for case in cases {
        let (name, case) = (format!("room/{}", case.column), Arc::new(case));
        let one = case.clone();
        trials.push(Trial::test(format!("{name}/cpu"), move || {
            one.check(&ROOM, &cpu_scene(&ROOM.test_scene))
        }));
        trials.push(on_gpu(format!("{name}/gpu"), move |context| {
            case.check(&ROOM, &gpu_scene(context, &ROOM.test_scene)?)
        }));
    }
    trials
}

/// Mean relative error over each group that corrected polygons with exact corners keep at M = 8: 1.5 %
/// in float64 near walls, where quadrilaterals cut the room's edges off, and what float32 adds.
const PROMISE: f64 = 0.016;

fn promise<S: BackendScene>(loaded: &S, _: &TestScene) -> Outcome {
    let room = &*ROOM;
    let settings = [
        ("fidelity", "corrected"),
        ("corners", "exact"),
        ("resolution", "8"),
    ];
    let variant = configured("polygon_form_factor", Quantity::Irradiance, &settings)?;
    let estimate = run(loaded, &variant, &room.points)?;
    let exact = room.column("E_exact")?;
    let error = |i: usize| (f64::from(estimate.get(i).x) / exact[i] - 1.0).abs();
    for (group, mean) in room.means(error) {
        ensure!(mean <= PROMISE, "group {group}: {:.2} %", 100.0 * mean);
    }
    Ok(())
}

/// A column, the method that gives it and its settings.
type Column = (
    &'static str,
    &'static str,
    &'static [(&'static str, &'static str)],
);

/// Columns of methods without a resolution.
const ONE_COLUMN: &[Column] = &[
    ("classic", "classic_envmap", &[]),
    // The column projects a map of 512² texels a face, each by its centre and exact solid angle.
    (
        "sh9",
        "sh_mip_envmap",
        &[("capture_resolution", "512"), ("sh_resolution", "64")],
    ),
];

/// Columns that exist for M = 2, 4, 8 and 16.
const COLUMNS: &[Column] = &[
    (
        "p1_text",
        "localized_cubemap",
        &[("fidelity", "published"), ("solid_angle", "text")],
    ),
    (
        "p1_shader",
        "localized_cubemap",
        &[("fidelity", "published"), ("solid_angle", "shader")],
    ),
    (
        "p1_corrected",
        "localized_cubemap",
        &[("fidelity", "corrected")],
    ),
    ("vpl", "point_form_factor", &[]),
    (
        "p4_published",
        "polygon_form_factor",
        &[("fidelity", "published")],
    ),
    (
        "p4_corrected_exact",
        "polygon_form_factor",
        &[
            ("fidelity", "corrected"),
            ("corners", "exact"),
            ("facing", "clamped"),
        ],
    ),
    (
        "p4_corrected_seamless",
        "polygon_form_factor",
        &[
            ("fidelity", "corrected"),
            ("corners", "seamless"),
            ("facing", "clamped"),
        ],
    ),
];

/// Places in the box in float32, in metres: three roundings of a coordinate up to 1.
const FLOAT32_M: f64 = 1.8e-7;

struct Case {
    column: String,
    variant: Variant,
}

impl Case {
    fn new(column: &str, id: &str, settings: &[(&str, &str)]) -> Self {
        let variant = configured(id, Quantity::Irradiance, settings);
        Self {
            column: column.into(),
            variant: variant
                .map_err(|e| e.message().unwrap_or_default().to_owned())
                .expect("a method with these parameters"),
        }
    }

    fn check<S: BackendScene>(&self, room: &Room, loaded: &S) -> Outcome {
        let estimate = run(loaded, &self.variant, &room.points)?;
        let values: Vec<f64> = estimate.iter().map(|v| f64::from(v.x)).collect();
        let expected = room.column(&self.column)?;
        let slopes = self.slopes(room)?;
        for (i, (value, expected)) in values.iter().zip(expected).enumerate() {
            let mut tolerance = self.tolerance();
            tolerance.absolute += slopes.map_or(0.0, |slopes| slopes[i] * FLOAT32_M);
            tolerance
                .check(*value, *expected)
                .map_err(|e| format!("point {i} of group {}: {e}", room.groups[i]))?;
        }
        self.check_means(room, &values)
    }

    /// What a metre changes at each point, where that is much: beside virtual point lights.
    fn slopes<'r>(&self, room: &'r Room) -> Result<Option<&'r [f64]>, Failed> {
        match self.column.strip_prefix("vpl_") {
            Some(m) => Ok(Some(room.column(&format!("vpl_slope_{m}"))?)),
            None => Ok(None),
        }
    }

    fn tolerance(&self) -> Tolerance {
        match self.column.as_str() {
            // Cells of a face of the map span h = 1/16 rad at most, a bilinear lookup errs by h²/8
            // times the second derivative in each of two directions, and that is at most E.
            "classic" => Tolerance {
                absolute: 2.0 / (8.0 * 16.0 * 16.0) * PI,
                relative: 0.0,
                cause: "the bilinear lookup in a map of 32 cells along a face's edge",
            },
            "sh9" => Tolerance {
                absolute: 1e-4 * PI,
                relative: 0.0,
                cause: "averages of 8x8 of the column's texels count by their centres: 3.4e-5; \
                        and the captured texels on the room's edges, 2e-5 sr each",
            },
            _ => Tolerance {
                absolute: 1e-4 * PI,
                relative: 0.0,
                cause: "float32 sums, and some captured texels on the room's edges, 6e-5 sr each, \
                        where rays, rasteriser and reference see either wall",
            },
        }
    }

    /// Mean relative error over each group against the table of the README, which is that of the
    /// column: a tenth of the value, and half a unit of its last digit.
    fn check_means(&self, room: &Room, values: &[f64]) -> Outcome {
        let exact = room.column("E_exact")?;
        let expected = room.column(&self.column)?;
        let means = table(&room.readme, &self.column)
            .ok_or_else(|| format!("the README's table has no row {}", self.column))?;
        let column = room.means(|i| (expected[i] / exact[i] - 1.0).abs());
        let ours = room.means(|i| (values[i] / exact[i] - 1.0).abs());
        ensure!(
            ours.len() == means.len(),
            "{} groups, {} in the table",
            ours.len(),
            means.len()
        );
        for (((group, ours), (_, column)), (mean, half_digit)) in
            ours.into_iter().zip(column).zip(means)
        {
            ensure!(
                // A digit more, for a half that the table rounds to the other side.
                (100.0 * column - mean).abs() <= 1.01 * half_digit,
                "group {group}: the README says {mean} %, the column {:.4} %",
                100.0 * column
            );
            let (ours, bound) = (100.0 * ours, 0.1 * mean + half_digit);
            ensure!(
                (ours - mean).abs() <= bound,
                "group {group}: mean error {ours:.3} % for {mean} %"
            );
        }
        Ok(())
    }
}

/// The means of a column, in %, with half a unit of their last digit; `None` if the table of the
/// README has no such row.
fn table(readme: &str, column: &str) -> Option<Vec<(f64, f64)>> {
    let begins = format!("| {column} | ");
    let row = readme.lines().find_map(|line| line.strip_prefix(&begins))?;
    let value = |cell: &str| {
        let decimals = cell.split_once('.').map_or(0, |(_, d)| d.len());
        Some((cell.parse().ok()?, 0.5 * 0.1_f64.powi(decimals as i32)))
    };
    row.trim_end_matches('|')
        .split('|')
        .map(|cell| value(cell.trim()))
        .collect()
}
