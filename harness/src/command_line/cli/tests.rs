#![allow(clippy::unwrap_used, reason = "tests")]
use super::*;
use clap::CommandFactory as _;
use glam::Vec3;

fn parse(line: &str) -> Result<Command, Stop> {
    let arguments = std::iter::once("interreflect").chain(line.split_whitespace());
    Cli::parse_arguments(arguments).map(|cli| cli.command)
}

fn usage(line: &str) -> String {
    match parse(line).unwrap_err() {
        Stop::Usage(message) => message,
        Stop::Information(text) => panic!("`{line}` printed help: {text}"),
    }
}

#[test]
fn the_parser_is_consistent() {
    Cli::command().debug_assert();
}

#[test]
fn a_probe_as_other_programs_call_it() {
    let line = "probe room.obj --reference-point .2,-.1,.3 --estimator localized_cubemap \
        --set resolution=4 --set fidelity=corrected --backend gpu --points room.csv --json";
    let Command::Probe(probe) = parse(line).unwrap() else {
        panic!("not a probe");
    };
    assert_eq!(
        probe.scene_options.reference_point,
        Some(Vec3::new(0.2, -0.1, 0.3))
    );
    assert_eq!(
        (probe.backend, probe.json, probe.quantity),
        (Backend::Gpu, true, None)
    );
    let names: Vec<_> = probe
        .settings
        .iter()
        .map(|s| (s.name.as_str(), s.value.as_str()))
        .collect();
    assert_eq!(names, [("resolution", "4"), ("fidelity", "corrected")]);
}

#[test]
fn vectors_may_start_with_a_minus_sign() {
    for (text, vector) in [
        ("-1,0,0", Vec3::NEG_X),
        ("-.5,-1e-3,2", Vec3::new(-0.5, -1e-3, 2.0)),
    ] {
        for line in [
            format!("bench studio --reference-point {text}"),
            format!("bench studio --reference-point={text}"),
        ] {
            let Command::Bench(bench) = parse(&line).unwrap() else {
                panic!("not a bench");
            };
            assert_eq!(bench.what.scene.reference_point, Some(vector));
        }
    }
}

#[test]
fn a_bare_bench_runs_everything() {
    let Command::Bench(bench) = parse("bench").unwrap() else {
        panic!("not a bench");
    };
    assert!(
        bench.scenes.is_empty()
            && bench.what.estimators.is_empty()
            && bench.what.quantities.is_empty()
    );
    assert_eq!(bench.what.backend.list(), [Backend::Cpu, Backend::Gpu]);
    assert_eq!(bench.what.budget, ReferenceOptions::default());
}

#[test]
fn repeated_options_add_up() {
    let line = "bench a b.toml --estimator x --estimator y --quantity irradiance \
        --quantity glossy_radiance --set x.resolution=8 --samples 64 --error .01 --seconds 2.5";
    let Command::Bench(bench) = parse(line).unwrap() else {
        panic!("not a bench");
    };
    assert_eq!(bench.scenes, ["a", "b.toml"]);
    assert_eq!(bench.what.estimators, ["x", "y"]);
    assert_eq!(
        bench
            .what
            .quantities
            .iter()
            .map(|q| q.name())
            .collect::<Vec<_>>(),
        ["irradiance", "glossy_radiance"]
    );
    assert_eq!(bench.what.settings[0].split(), (Some("x"), "resolution"));
    assert_eq!(
        (
            bench.what.budget.samples,
            bench.what.budget.error,
            bench.what.budget.seconds
        ),
        (Some(64), Some(0.01), Some(2.5))
    );
}

#[test]
fn a_material_is_three_numbers_in_range() {
    let line = "probe a --estimator b --points c --material .5,.25,5";
    let Command::Probe(probe) = parse(line).unwrap() else {
        panic!("not a probe");
    };
    let expected = MaterialArg {
        diffuse: 0.5,
        specular: 0.25,
        shininess: 5.0,
    };
    assert_eq!(probe.material, Some(expected));
}

/// One line, which names the offender and says what to do.
#[test]
fn bad_usage_is_one_line() {
    let probe = "probe a --estimator b --points c";
    for (line, words) in [
        ("", &["requires a subcommand", "bench"][..]),
        ("bnech", &["bnech", "'bench'"]),
        ("bench --estimater x", &["--estimater", "'--estimator'"]),
        ("bench --backend cuda", &["cuda", "cpu, gpu, both"]),
        (
            "bench --quantity light",
            &["light", "irradiance, glossy_radiance, ambient_occlusion"],
        ),
        ("bench --threads 0", &["--threads", "1 to 1024"]),
        ("bench --points", &["--points", "value is required"]),
        ("bench --set resolution", &["resolution", "name=value"]),
        (
            "probe room.obj",
            &["--estimator <ID>", "--points <FILE>", "required"],
        ),
        (
            "render a --estimator b --width 0",
            &["--width", "1..=16384"],
        ),
        ("reference a --error 2", &["--error", "between 0 and 1"]),
        ("compare a.exr", &["<B>", "required"]),
        (&format!("{probe} --backend both"), &["both", "cpu, gpu"]),
        (&format!("{probe} --reference-point 1,2"), &["1,2", "x,y,z"]),
        (
            &format!("{probe} --reference-point 1,2,nan"),
            &["nan", "x,y,z"],
        ),
        (
            &format!("{probe} --material 2,0,5"),
            &["2,0,5", "from 0 to 1"],
        ),
    ] {
        let message = usage(line);
        assert!(!message.contains('\n'), "`{line}`: {message}");
        for word in words {
            assert!(message.contains(word), "`{line}`: no {word} in: {message}");
        }
        assert!(message.ends_with("; see --help"), "{message}");
    }
}

#[test]
fn help_has_examples_for_every_command() {
    for command in [
        "",
        "list",
        "bench",
        "render",
        "probe",
        "reference",
        "compare",
    ] {
        let Stop::Information(text) = parse(&format!("{command} --help")).unwrap_err() else {
            panic!("{command} --help is no help");
        };
        assert!(text.contains("Example"), "{command}");
    }
    assert!(
        matches!(parse("--version"), Err(Stop::Information(v)) if v.starts_with("interreflect "))
    );
}
