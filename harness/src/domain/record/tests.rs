#![allow(clippy::unwrap_used, reason = "tests")]
use super::*;
use crate::domain::machine::Machine;
use interreflect_scene::params::Value;
use serde_json::json;

fn comparison() -> Comparison {
    Comparison {
        relmse: Some(0.25),
        rmse: 0.5,
        energy_ratio: Some(0.9),
        p999: 1.5,
        max: 2.0,
        noise_floor: Some(0.001),
        verdict: Verdict::Conclusive,
        relmse_above_noise: Some(0.249),
        noise_floor_rmse: 0.01,
        epsilon: 1e-4,
        flip: Some(0.03),
        compared: 90,
        reference: Some("path tracer, 256 samples, seed 1".into()),
    }
}

fn run() -> Run {
    Run {
        scene: "colored-room".into(),
        scene_hash: Some("5ce9e".into()),
        settings: [("scene.receiver.gap", Value::F32(0.05))]
            .into_iter()
            .collect(),
        machine: None,
        estimator: "localized_cubemap".into(),
        backend: Backend::Gpu,
        fidelity: Some("published".into()),
        quantity: "irradiance".into(),
        params: [
            ("resolution", Value::U32(4)),
            ("clamp", Value::F32(0.1)),
            ("fidelity", Value::Name("published")),
            ("table", Value::Bool(false)),
        ]
        .into_iter()
        .collect(),
        points: 100,
        phases_ms: Phases {
            shade: Timing::of(&[1.0, 2.0, 4.0]),
            ..Phases::default()
        },
        time_source: TimeSource::GpuTimestamps,
        software: true,
        backends_apart: None,
        slowed: Some(1.3),
        bytes: Some(Bytes {
            captures: 6,
            own: Some(5),
            points: 4,
        }),
        own_model: None,
        own_model_missing: Some("no deterministic integral for this quantity".into()),
        truth: Some(comparison()),
        truth_missing: None,
        skipped: None,
        image: None,
    }
}

/// The words that other programs rely on.
#[test]
fn json_has_the_contract_s_keys() {
    let results = Results {
        machine: Machine::detect(2, "avx2", None),
        command: "interreflect bench".into(),
        seed: Some(1),
        runs: vec![run()],
        ..Results::default()
    };
    let json = serde_json::to_value(&results).unwrap();
    let run = &json["runs"][0];
    for key in [
        "scene",
        "estimator",
        "backend",
        "fidelity",
        "quantity",
        "params",
        "points",
        "phases_ms",
        "own_model",
        "truth",
    ] {
        assert!(run.get(key).is_some(), "run.{key} is missing");
    }
    for key in ["capture", "compile", "prepare", "shade", "readback"] {
        assert!(run["phases_ms"].get(key).is_some(), "phase {key}");
    }
    for key in ["median", "mad", "n"] {
        assert!(run["phases_ms"]["shade"][key].is_number(), "shade.{key}");
    }
    let truth = &run["truth"];
    for key in [
        "relmse",
        "rmse",
        "energy_ratio",
        "p999",
        "max",
        "noise_floor",
    ] {
        assert!(truth[key].is_number(), "truth.{key}");
    }
    assert_eq!(truth["verdict"], "conclusive");
    assert_eq!(run["backend"], "gpu");
    assert!(run["own_model"].is_null() && run["phases_ms"]["capture"].is_null());
    let machine = &json["machine"];
    for key in [
        "cpu",
        "threads",
        "instruction_set",
        "adapter",
        "driver",
        "software",
        "commit",
        "dirty",
        "versions",
    ] {
        assert!(machine.get(key).is_some(), "machine.{key}");
    }
}

#[test]
fn parameters_keep_their_order_and_types() {
    let text = serde_json::to_string(&run().params).unwrap();
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    let entries = json.as_object().unwrap().iter();
    let expected = [
        ("resolution", json!(4)),
        ("clamp", json!(0.1)),
        ("fidelity", json!("published")),
        ("table", json!(false)),
    ];
    let entries: Vec<_> = entries.map(|(n, v)| (n.as_str(), v.clone())).collect();
    assert_eq!(entries, expected);
    assert_eq!(
        serde_json::from_str::<ParamMap>(&text).unwrap(),
        run().params
    );
}

#[test]
fn runs_come_back_from_json() {
    let skipped = Run {
        skipped: Some("no Vulkan adapter".into()),
        ..Run::new("studio", "mine", Backend::Gpu, "irradiance")
    };
    for original in [run(), skipped] {
        let text = serde_json::to_string(&original).unwrap();
        assert_eq!(serde_json::from_str::<Run>(&text).unwrap(), original);
    }
}

#[test]
fn timings_are_medians_and_median_deviations() {
    let of = |times: &[f64]| Timing::of(times).map(|t| (t.median, t.mad, t.n));
    assert_eq!(of(&[]), None);
    assert_eq!(of(&[3.0]), Some((3.0, 0.0, 1)));
    assert_eq!(of(&[9.0, 1.0, 2.0]), Some((2.0, 1.0, 3)));
    assert_eq!(of(&[4.0, 1.0, 2.0, 100.0]), Some((3.0, 1.5, 4)));
}

#[test]
fn a_frame_pays_for_capture_prepare_and_shade() {
    let phase = |ms| Timing::of(&[ms]);
    let mut phases = Phases {
        solve: phase(100.0),
        capture: phase(4.0),
        compile: phase(500.0),
        prepare: phase(2.0),
        shade: phase(1.0),
        readback: phase(30.0),
    };
    assert_eq!(phases.frame_ms(), Some(7.0));
    phases.prepare = None;
    assert_eq!(phases.frame_ms(), Some(5.0));
    phases.shade = None;
    assert_eq!(phases.frame_ms(), None);
}
