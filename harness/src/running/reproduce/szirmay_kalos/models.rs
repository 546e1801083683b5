//! A model in a coloured room: localized maps of few texels beside classic mapping and the truth.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::judge::{ERROR, Judge, scaled};
use super::super::pictures::Row;
use super::super::verdict::Trial;
use crate::domain::record::Backend;
use crate::running::error::RunError;
use interreflect_estimators::execution::LoadedScene;
use interreflect_estimators::{Configured, OwnModel, Quantity};
use interreflect_scene::{Estimate, LightPaths};

/// How the model reflects.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Reflection {
    /// Irradiance, whatever the albedo.
    Diffuse,
    /// A Blinn–Phong lobe of the figures' shininess, alone.
    Specular,
}

/// Places of the receiver in the room.
const PLACES: [&str; 3] = ["middle", "halfway", "wall"];

/// Texels along a face's edge.
const RESOLUTIONS: [u32; 3] = [2, 4, 16];

/// Reflections that captures hold, so that what is left out is not in the comparison.
const BOUNCES: u32 = 4;

/// All light but what the model keeps from itself: in neither map is there any of the model, and a map
/// that is too dark must not gain by its missing shadows.
const UNSHADOWED: LightPaths = LightPaths {
    self_shadowing: false,
    ..LightPaths::ALL
};

pub(super) fn run(
    context: &ExperimentContext<'_>,
    model: &str,
    reflections: &[Reflection],
) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    let model = context.mesh(model);
    for &reflection in reflections {
        for place in PLACES {
            let (diffuse, specular) = match reflection {
                Reflection::Diffuse => (0.8, 0.0),
                Reflection::Specular => (0.0, 0.8),
            };
            let room = ExperimentScene::of("colored-room")
                .set("reference.offset", 0)
                .with(&model)
                .set("receiver.place", place)
                .set("receiver.size", 0.7)
                .set("receiver.diffuse", diffuse)
                .set("receiver.specular", specular)
                .set("receiver.shininess", 5);
            let loaded = context.load(&room, &mut finding)?;
            let words = format!("{reflection:?}").to_lowercase();
            let case = format!("{words} {}, {place}", model.name);
            compare(context, &loaded, (&case, reflection), &mut finding)?;
        }
    }
    Ok(finding)
}

fn compare(
    context: &ExperimentContext<'_>,
    loaded: &LoadedScene,
    (case, reflection): (&str, Reflection),
    finding: &mut Finding,
) -> Result<(), RunError> {
    let quantity = match reflection {
        Reflection::Diffuse => Quantity::Irradiance,
        Reflection::Specular => Quantity::GlossyRadiance,
    };
    let view = context.view(loaded)?;
    let points = view.points(quantity.layout());
    let mut references = context.references(loaded, quantity, &points);
    let mut complete = context.references(loaded, quantity, &points);
    let all = context.pick(None, Some(())).map(|()| complete.truth());
    let truth = references.model(OwnModel::LightTransport(UNSHADOWED));
    let judge = Judge::new(truth, &points);
    let brought = |e: &Estimate| match reflection {
        Reflection::Diffuse => e.clone(),
        Reflection::Specular => scaled(e, judge.factor(e)),
    };
    let mut row = Row::rendered(case, "reference", &view, &truth.values);
    for backend in context.backends() {
        let mut shoot = |label: &str, method: &dyn Configured| {
            let measured = context.run_once(loaded, backend, method, quantity, &points)?;
            let estimate = brought(&measured.estimate);
            finding.measure(
                (case, format!("{ERROR}, {label}")),
                backend,
                judge.error(&estimate),
                "",
            );
            if let Some(all) = &all {
                let full = Judge::new(all, &points).error(&estimate);
                finding.measure(
                    (case, format!("with shadows of itself {label}")),
                    backend,
                    full,
                    "",
                );
            }
            finding.runs.push(measured.run);
            if backend == context.backends()[0] {
                row.add(label, view.image(&estimate));
            }
            Ok::<_, RunError>(estimate)
        };
        let classic = shoot(
            "classic",
            &*context.method("classic_envmap", &[("bounces", &BOUNCES)])?,
        )?;
        let mut maps = Vec::new();
        for m in RESOLUTIONS {
            let map = localized(context, m, "published")?;
            maps.push((m, shoot(&format!("M = {m}"), &*map)?));
        }
        shoot("M = 16 corrected", &*localized(context, 16, "corrected")?)?;
        let trials = nearer_than_classic(&judge, (case, backend), &maps, &classic);
        finding.judge("C1", trials);
    }
    finding.pictures.push(row);
    Ok(())
}

/// That each map, of M texels along a face's edge, is nearer to the reference than classic mapping.
fn nearer_than_classic(
    judge: &Judge<'_>,
    (case, backend): (&str, Backend),
    maps: &[(u32, Estimate)],
    classic: &Estimate,
) -> Vec<Trial> {
    let nearer = |(m, map): &(u32, Estimate)| {
        judge.nearer(format!("{case}, M = {m}"), backend, map, classic)
    };
    maps.iter().map(nearer).collect()
}

fn localized(
    context: &ExperimentContext<'_>,
    resolution: u32,
    fidelity: &str,
) -> Result<Box<dyn Configured>, RunError> {
    let parameters: [(&str, &dyn ToString); 3] = [
        ("resolution", &resolution),
        ("bounces", &BOUNCES),
        ("fidelity", &fidelity),
    ];
    context.method("localized_cubemap", &parameters)
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{exact, flat, signs};
    use super::*;

    #[test]
    fn maps_have_to_be_nearer_than_classic_mapping() {
        let reference = flat(1.0);
        let judge = exact(&reference);
        let maps = [(2, flat(1.2)), (4, flat(0.7)), (16, flat(0.4))];
        let trials = nearer_than_classic(&judge, ("case", Backend::Gpu), &maps, &flat(1.5));
        assert_eq!(signs(&trials), "++-");
        assert_eq!(trials[1].what, "case, M = 4, MSE / mean²");
        assert!(trials.iter().all(|t| t.backend == Backend::Gpu));
    }
}
