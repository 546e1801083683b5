#![allow(clippy::unwrap_used, reason = "tests")]
use super::*;
use crate::domain::machine::Adapter;
use crate::domain::record::{Backend, Comparison, ParamMap, Phases, TimeSource, Timing, Verdict};
use crate::presenting::table::Table;
use glam::Vec3;
use interreflect_scene::params::Value;

fn comparison(relmse: f64, floor: f64, reference: &str) -> Comparison {
    Comparison {
        relmse: Some(relmse),
        rmse: relmse.sqrt(),
        energy_ratio: Some(0.93),
        p999: 0.4,
        max: 0.61,
        noise_floor: Some(floor),
        verdict: if relmse > 2.0 * floor {
            Verdict::Conclusive
        } else {
            Verdict::Inconclusive
        },
        relmse_above_noise: Some((relmse - floor).max(0.0)),
        noise_floor_rmse: floor.sqrt(),
        epsilon: 1e-4,
        flip: None,
        compared: 2000,
        reference: Some(reference.into()),
    }
}

fn run(
    scene: &str,
    estimator: &str,
    fidelity: Option<&'static str>,
    backend: Backend,
    relmse: f64,
) -> Run {
    let time = |ms: f64| Timing::of(&[ms, 1.1 * ms, 0.97 * ms]);
    let fidelity_value = fidelity.map(|f| ("fidelity", Value::Name(f)));
    let params = [
        ("resolution", Value::U32(4)),
        ("capture_resolution", Value::U32(256)),
    ];
    Run {
        fidelity: fidelity.map(Into::into),
        params: params
            .into_iter()
            .chain(fidelity_value)
            .collect::<ParamMap>(),
        points: 2048,
        phases_ms: Phases {
            solve: None,
            capture: time(if backend == Backend::Gpu { 9.0 } else { 25.0 } * relmse.powf(-0.3)),
            compile: (backend == Backend::Gpu)
                .then(|| Timing::of(&[310.0]))
                .flatten(),
            prepare: time(0.31),
            shade: time(0.9),
            readback: (backend == Backend::Gpu).then(|| time(0.05)).flatten(),
        },
        time_source: if backend == Backend::Gpu {
            TimeSource::GpuTimestamps
        } else {
            TimeSource::WallClock
        },
        software: backend == Backend::Gpu,
        slowed: None,
        backends_apart: None,
        bytes: None,
        own_model: (estimator != "mine").then(|| comparison(0.3 * relmse, 0.0, "own model")),
        own_model_missing: (estimator == "mine").then(|| "no deterministic integral".into()),
        truth: Some(comparison(
            relmse,
            1.2e-4,
            "path tracer, 1024 samples, seed 1",
        )),
        truth_missing: None,
        ..Run::new(scene, estimator, backend, "irradiance")
    }
}

fn image(brightness: f32) -> HdrImage {
    let mut image = HdrImage::new(96, 72);
    for (i, pixel) in image.pixels.iter_mut().enumerate() {
        let (x, y) = ((i % 96) as f32 / 96.0 - 0.5, (i / 96) as f32 / 72.0 - 0.5);
        let r2 = 4.0 * (x * x + y * y);
        let shade = (1.0 - r2).max(0.05).sqrt() + brightness * x;
        *pixel = Vec3::new(0.9, 0.7, 0.4 + 0.5 * y) * shade;
    }
    image
}

fn labelled(label: &str, note: &str, run: Option<usize>, brightness: f32) -> LabelledImage {
    LabelledImage {
        label: label.into(),
        note: note.into(),
        run,
        image: image(brightness),
    }
}

fn report() -> Report {
    let adapter = Adapter {
        name: "llvmpipe".into(),
        driver: "Mesa 22.3.6".into(),
        software: true,
    };
    let mut runs = Vec::new();
    for scene in ["colored-room", "studio"] {
        for backend in [Backend::Cpu, Backend::Gpu] {
            runs.push(run(scene, "constant_ambient", None, backend, 0.21));
            runs.push(run(scene, "classic_envmap", None, backend, 0.03));
            runs.push(run(
                scene,
                "localized_cubemap",
                Some("published"),
                backend,
                0.012,
            ));
            runs.push(run(
                scene,
                "localized_cubemap",
                Some("corrected"),
                backend,
                0.0019,
            ));
            runs.push(run(scene, "mine", None, backend, 1.1e-4));
        }
        let reason = "path tracing needs ray queries, which this adapter lacks";
        runs.push(Run {
            skipped: Some(reason.into()),
            ..Run::new(scene, "path_reference", Backend::Gpu, "irradiance")
        });
    }
    Report {
        title: "interreflect bench".into(),
        command: "interreflect bench --set a<b>".into(),
        invocation: None,
        machine: Machine::detect(2, "avx2", Some(&adapter)),
        seed: Some(7),
        runs,
        rows: vec![ImageRow {
            scene: "colored-room".into(),
            quantity: "irradiance".into(),
            reference: labelled("truth", "1024 samples", None, 0.0),
            estimates: vec![
                labelled("classic_envmap", "cpu", Some(1), -0.4),
                labelled("localized_cubemap, published", "cpu", Some(2), 0.2),
                labelled("localized_cubemap, corrected", "gpu", Some(8), 0.02),
            ],
            surfaces: Some((0..96 * 72).map(|i| i % 96 > 8).collect()),
        }],
        conclusions: vec![Tables {
            scene: "studio".into(),
            quantity: "irradiance".into(),
            tables: vec![Table {
                caption: "Equal time".into(),
                head: vec!["budget".into(), "best".into()],
                rows: vec![vec!["1 ms".into(), "constant_ambient <1>".into()]],
                note: "of the CPU's runs".into(),
            }],
        }],
    }
}

/// Set INTERREFLECT_SAMPLE_REPORT to a file name to keep the page and look at it.
#[test]
fn a_report_is_one_file_that_says_what_must_be_said() {
    let html = report().html().unwrap();
    if let Some(path) = std::env::var_os("INTERREFLECT_SAMPLE_REPORT") {
        std::fs::write(path, &html).unwrap();
    }
    for words in [
        "SOFTWARE",
        "badge software",
        "skipped: path tracing needs ray queries",
        "inconclusive",
        "no deterministic integral",
        "resolution=4",
        "avx2",
        "GPU timestamps",
        "linear-gradient",
        "Equal time",
        "constant_ambient &lt;1&gt;",
        "<dt>Seed</dt><dd>7</dd>",
        "href=\"#run-9\"",
        "<tr id=\"run-9\">",
        "id=\"pixels-0-3\"",
        "var(--hue-2)",
        "<math",
    ] {
        assert!(html.contains(words), "no {words}");
    }
    assert!(html.contains("--set a&lt;b&gt;"), "text is escaped");
    // The truth and an image of each of the three methods.
    assert_eq!(html.matches("<img src=\"data:image/png;base64,").count(), 4);
    for outside in [
        "http://",
        "https://",
        "src=\"/",
        "<link rel=\"stylesheet",
        "url(",
        "import ",
    ] {
        assert!(
            !html.contains(outside),
            "the file refers to something outside: {outside}"
        );
    }
}

/// A name must not end the script element that holds it.
#[test]
fn names_can_t_break_out_of_the_page() {
    let mut report = report();
    report.rows[0].reference.label = "</script><b>".into();
    report.rows[0].scene = "<i>".into();
    let html = report.html().unwrap();
    assert!(!html.contains("</script><b>") && !html.contains("<i>,"));
}

#[test]
fn runs_that_differ_in_one_number_make_a_curve() {
    let html = |resolutions: [u32; 3]| {
        let mut report = report();
        let mut swept = report.runs[2].clone();
        report.runs.clear();
        for resolution in resolutions {
            swept.params = [
                ("resolution", Value::U32(resolution)),
                ("rays", Value::U32(9)),
            ]
            .into_iter()
            .collect();
            report.runs.push(swept.clone());
        }
        report.rows.clear();
        report.html().unwrap()
    };
    let swept = html([4, 8, 16]);
    assert!(
        swept.contains("<strong>resolution</strong>") && !swept.contains("<strong>rays</strong>")
    );
    assert_eq!(
        swept.matches("over resolution").count(),
        3,
        "two errors and the time"
    );
    assert!(swept.contains("localized_cubemap, published, cpu, resolution=16"));
    assert!(!html([4, 4, 4]).contains("class=\"curves\""));
}

#[test]
fn hardware_times_are_not_called_software() {
    let mut report = report();
    report.runs.retain(|r| r.backend == Backend::Cpu);
    report.machine = Machine::detect(1, "baseline", None);
    let html = report.html().unwrap();
    assert!(!html.contains("SOFTWARE") && !html.contains("class=\"badge software\">software"));
}

#[test]
fn an_empty_report_is_still_a_page() {
    let mut report = report();
    report.runs.clear();
    report.rows.clear();
    assert!(report.html().unwrap().contains("</html>"));
}

#[test]
fn images_of_another_size_are_refused() {
    let mut report = report();
    report.rows[0].estimates[1].image = HdrImage::new(2, 2);
    let message = report.html().unwrap_err().to_string();
    assert!(
        message.contains("localized_cubemap, published") && message.contains("2 × 2"),
        "{message}"
    );
}

#[test]
fn reports_are_written_whole() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("report.html");
    report().write(&path).unwrap();
    assert!(std::fs::read_to_string(&path).unwrap().ends_with("</html>"));
}
