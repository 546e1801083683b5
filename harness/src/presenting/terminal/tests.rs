#![allow(clippy::unwrap_used, reason = "tests")]
use super::*;
use crate::domain::record::{Backend, Phases, TimeSource, Timing, Verdict};

fn comparison(relmse: f64, verdict: Verdict) -> Option<Comparison> {
    Some(Comparison {
        relmse: Some(relmse),
        rmse: 0.1,
        energy_ratio: Some(0.9),
        p999: 0.2,
        max: 0.3,
        noise_floor: Some(1e-4),
        verdict,
        relmse_above_noise: Some(relmse),
        noise_floor_rmse: 0.01,
        epsilon: 1e-4,
        flip: None,
        compared: 2048,
        reference: None,
    })
}

fn sample() -> Vec<Run> {
    let run = |estimator: &str, fidelity: Option<&str>, backend, relmse, verdict| Run {
        fidelity: fidelity.map(Into::into),
        points: 2048,
        phases_ms: Phases {
            capture: Timing::of(&[123.4, 120.0]),
            compile: (backend == Backend::Gpu)
                .then(|| Timing::of(&[345.6]))
                .flatten(),
            shade: Timing::of(&[0.456]),
            ..Phases::default()
        },
        time_source: TimeSource::WallClock,
        software: backend == Backend::Gpu,
        own_model: comparison(relmse, Verdict::Conclusive),
        truth: comparison(relmse, verdict),
        skipped: None,
        ..Run::new("colored-room", estimator, backend, "glossy_radiance")
    };
    vec![
        run(
            "localized_cubemap",
            Some("published"),
            Backend::Cpu,
            0.0123,
            Verdict::Conclusive,
        ),
        run(
            "localized_cubemap",
            Some("corrected"),
            Backend::Gpu,
            0.000_15,
            Verdict::Inconclusive,
        ),
        run(
            "constant_ambient",
            None,
            Backend::Cpu,
            0.4,
            Verdict::Conclusive,
        ),
        Run {
            skipped: Some("CPU only".into()),
            ..Run::new(
                "colored-room",
                "path_reference",
                Backend::Gpu,
                "glossy_radiance",
            )
        },
        Run {
            skipped: Some("no adapter".into()),
            ..Run::new("furnace", "mine", Backend::Gpu, "irradiance")
        },
    ]
}

#[test]
fn tables_fit_the_width_and_say_it_all() {
    for width in [100, 120, 140] {
        let text = runs(&sample(), Some(width));
        let widest = text.lines().map(|l| l.chars().count()).max().unwrap();
        assert!(widest <= usize::from(width), "{widest} of {width}:\n{text}");
        println!("{text}");
        for words in [
            "colored-room: glossy radiance, 2048 points",
            "gpu sw",
            "software adapter",
            "≲ 1.50e-4",
            "path_reference on gpu skipped: CPU only",
            "furnace: irradiance",
            "0.456",
            "own model",
        ] {
            assert!(text.contains(words), "no {words} at {width}:\n{text}");
        }
    }
}

#[test]
fn hardware_and_conclusive_runs_need_no_notes() {
    let text = runs(&sample()[..1], Some(120));
    assert!(!text.contains("software") && !text.contains('≲'), "{text}");
    assert_eq!(runs(&[], Some(120)), "");
}

#[test]
fn times_that_did_not_settle_are_counted() {
    let mut of_three = sample();
    let shade = of_three[0].phases_ms.shade.as_mut().unwrap();
    shade.settled = Some(false);
    of_three[0].phases_ms.capture = None;
    let text = runs(&of_three, Some(120));
    assert!(text.contains("1 of 3 frame times did not settle"), "{text}");
}
