//! The environments that models are shown under.

use super::super::desk::Desk;
use super::super::finding::Finding;
use super::super::place::Place;

/// The library's sky, and public environment maps where they are.
pub(super) fn environments(desk: &Desk<'_>, finding: &mut Finding) -> Vec<(&'static str, Place)> {
    let studio = || Place::of("studio").with(&desk.mesh("bunny"));
    let mut all = vec![("sky", studio())];
    let maps: &[&'static str] = desk.pick(
        &["blender_courtyard"],
        &["blender_courtyard", "blender_interior", "pmndrs_lobby"],
    );
    for &name in maps {
        match desk.assets().environment(name) {
            Some(path) => all.push((name, studio().under(Some(path)))),
            None => finding.note(format!(
                "{name} not found: left out; `make assets` brings public maps"
            )),
        }
    }
    all
}
