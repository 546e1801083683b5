//! The environments that models are shown under.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;

/// The library's sky, and public environment maps where they are.
pub(super) fn environments(
    context: &ExperimentContext<'_>,
    finding: &mut Finding,
) -> Vec<(&'static str, ExperimentScene)> {
    let studio = || ExperimentScene::of("studio").with(&context.mesh("bunny"));
    let mut all = vec![("sky", studio())];
    let maps: &[&'static str] = context.pick(
        &["blender_courtyard"],
        &["blender_courtyard", "blender_interior", "pmndrs_lobby"],
    );
    for &name in maps {
        match context.assets().environment(name) {
            Some(path) => all.push((name, studio().under(Some(path)))),
            None => finding.note(format!(
                "{name} not found: left out; `make assets` brings public maps"
            )),
        }
    }
    all
}
