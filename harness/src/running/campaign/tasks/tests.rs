use super::*;
use interreflect_estimators::Registry;
use std::collections::BTreeSet;

fn method(id: &str, settings: &[(&str, &str)]) -> Box<dyn Configured> {
    let registry = Registry::builtin();
    let mut method = registry.get(id).expect("a built-in method").configure();
    for (name, value) in settings {
        method.set(name, value).expect("a parameter of it");
    }
    method
}

/// Tasks that differ in anything have other digests; the same task has the same.
#[test]
fn a_digest_tells_tasks_apart() {
    let id = "localized_cubemap";
    let run = |settings: &[(&str, &str)], backend| Task::Run(method(id, settings), backend);
    let of = |task: Task| task.digest(Quantity::Irradiance);
    let mut digests = vec![
        of(run(&[], Backend::Cpu)),
        of(run(&[], Backend::Gpu)),
        of(Task::Baseline(method(id, &[]))),
        of(Task::Floor(method(id, &[]))),
        of(Task::Split(method(id, &[]))),
        of(Task::Run(method("point_form_factor", &[]), Backend::Cpu)),
        run(&[], Backend::Cpu).digest(Quantity::GlossyRadiance),
    ];
    for setting in [
        ("resolution", "8"),
        ("capture_resolution", "8"),
        ("bounces", "1"),
        ("recapture_distance", ".5"),
        ("fidelity", "corrected"),
        ("solid_angle", "shader"),
        ("reflectivity", "table"),
    ] {
        digests.push(of(run(&[setting], Backend::Cpu)));
    }
    let parameters = method(id, &[]).values().len();
    assert_eq!(digests.len(), 7 + parameters, "each parameter is tried");
    let different: BTreeSet<&String> = digests.iter().collect();
    assert_eq!(different.len(), digests.len());
    assert_eq!(of(run(&[], Backend::Cpu)), digests[0]);
    assert_eq!(of(run(&[("resolution", "4")], Backend::Cpu)), digests[0]);
}

/// Path tracing without an end, and rays that gather light reflected once, at 1 to 64 samples.
#[test]
fn baselines_are_path_tracing_and_n_rays() {
    assert_eq!((RAYS, BOUNCES), ([1, 4, 16, 64], [0, 1]));
}
