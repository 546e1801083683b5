//! What runs are called: by number, by method, and by what tells a method's runs apart.

use super::mark::Numbered;
use super::plot::HUES;
use crate::domain::record::Run;

/// All runs of a report, named; in their order.
pub(super) fn named(runs: &[Run]) -> Vec<Numbered<'_>> {
    let mut estimators: Vec<&str> = Vec::new();
    let mut all = Vec::new();
    for (i, run) in runs.iter().enumerate() {
        if !estimators.contains(&run.estimator.as_str()) {
            estimators.push(&run.estimator);
        }
        let hue = estimators.iter().position(|e| *e == run.estimator);
        let variant = variant(run, runs);
        all.push(Numbered {
            number: i + 1,
            run,
            label: format!("{}, {variant}", run.label()),
            variant,
            hue: hue.unwrap_or(0) % HUES,
        });
    }
    all
}

/// The backend of a run, and the parameters in which runs of its method differ for the same scene and
/// quantity.
pub(super) fn variant(run: &Run, runs: &[Run]) -> String {
    let same = |other: &&Run| {
        (&other.scene, &other.quantity, other.label()) == (&run.scene, &run.quantity, run.label())
            && other.skipped.is_none()
    };
    let mut words = vec![run.backend.to_string()];
    for (name, value) in &run.params.0 {
        let mut others = runs.iter().filter(same);
        if others.any(|other| other.params.get(name) != Some(value)) {
            words.push(format!("{name}={value}"));
        }
    }
    words.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::record::Backend;
    use interreflect_scene::params::Value;

    #[test]
    fn variants_name_what_differs_and_no_more() {
        let run = |resolution: u32, scene: &str| Run {
            params: [
                ("resolution", Value::U32(resolution)),
                ("rays", Value::U32(9)),
            ]
            .into_iter()
            .collect(),
            ..Run::new(scene, "texels", Backend::Cpu, "irradiance")
        };
        let runs = [run(4, "box"), run(8, "box"), run(4, "cave")];
        let labels: Vec<_> = named(&runs).into_iter().map(|n| n.label).collect();
        assert_eq!(
            labels,
            [
                "texels, cpu, resolution=4",
                "texels, cpu, resolution=8",
                "texels, cpu"
            ]
        );
    }
}
