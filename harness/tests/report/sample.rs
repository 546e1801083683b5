//! A small report whose numbers are known.

use glam::Vec3;
use interreflect::image::HdrImage;
use interreflect::machine::Machine;
use interreflect::record::{Backend, Comparison, Phases, Results, Run, Timing, Verdict};
use interreflect::report::{ImageRow, LabelledImage, Report};
use interreflect_scene::params::Value;

/// Size of the images in pixels.
pub(crate) const SIZE: (usize, usize) = (24, 16);

fn comparison(relmse: f64) -> Option<Comparison> {
    Some(Comparison {
        relmse: Some(relmse),
        rmse: 0.1,
        energy_ratio: Some(0.9),
        p999: 0.2,
        max: 0.3,
        noise_floor: Some(1e-4),
        verdict: Verdict::Conclusive,
        relmse_above_noise: Some(relmse),
        noise_floor_rmse: 0.01,
        epsilon: 1e-4,
        flip: None,
        compared: 384,
        reference: None,
    })
}

/// An image whose red grows by a sixteenth with every column, times a factor.
fn image(factor: f32) -> HdrImage {
    let mut image = HdrImage::new(SIZE.0, SIZE.1);
    for (i, pixel) in image.pixels.iter_mut().enumerate() {
        let (x, y) = ((i % SIZE.0) as f32, (i / SIZE.0) as f32);
        *pixel = factor * Vec3::new(x / 16.0, y / 16.0, 0.25);
    }
    image
}

/// Three runs, two of which differ in a parameter.
pub(crate) fn report() -> Report {
    let run = |estimator: &str, resolution: u32, ms: f64, relmse: f64| Run {
        params: [("resolution", Value::U32(resolution))]
            .into_iter()
            .collect(),
        points: 384,
        phases_ms: Phases {
            shade: Timing::of(&[ms, 1.1 * ms]),
            ..Phases::default()
        },
        own_model: comparison(relmse),
        truth: comparison(relmse),
        ..Run::new("box", estimator, Backend::Cpu, "irradiance")
    };
    let runs = vec![
        run("ambient", 4, 0.1, 0.4),
        run("texels", 4, 1.0, 0.1),
        run("texels", 8, 4.0, 0.01),
    ];
    let labelled = |label: &str, run: Option<usize>, factor: f32| LabelledImage {
        label: label.into(),
        note: "cpu".into(),
        run,
        image: image(factor),
    };
    let rows = vec![ImageRow {
        scene: "box".into(),
        quantity: "irradiance".into(),
        reference: labelled("truth", None, 1.0),
        estimates: vec![
            labelled("ambient", Some(0), 0.5),
            labelled("texels", Some(1), 2.0),
            labelled("texels", Some(2), 1.25),
        ],
        surfaces: Some((0..SIZE.0 * SIZE.1).map(|i| i != 0).collect()),
    }];
    let results = Results {
        machine: Machine::detect(2, "avx2", None),
        command: "interreflect bench box".into(),
        seed: Some(1),
        runs,
        ..Results::default()
    };
    Report::new(&results, rows)
}
