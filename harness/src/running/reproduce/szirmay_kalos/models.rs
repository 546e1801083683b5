//! A model at several places in the room: classic mapping, localized maps of few and of many texels, and the reference.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::judge::{ERROR, Judge, scaled};
use super::super::pictures::Row;
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::{Amount, Trial};
use super::super::viewer::{LOOKS, Viewer};
use super::super::{Claim, Experiment, Item, Paper};
use super::CAPTURE;
use super::alike;
use super::room;
use super::room::{DIFFUSE, SPECULAR};
use super::room::{Reflection, UNSHADOWED, classic, localized};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use interreflect_estimators::Configured;
use interreflect_scene::Estimate;
use serde::Serialize;

/// Pictures of a model at several places, by M of a few and of many texels.
const fn pictures(scene: SceneSetup, reflection: Reflection) -> Models {
    Models {
        scene,
        reflection,
        places: &["middle", "halfway", "wall"],
        resolutions: [2, 4, 16],
        capture_resolution: CAPTURE,
        weights: ["shader", "text"],
    }
}

const OF_SPECULAR_MODELS: &[Claim] = &[
    Claim {
        id: "C1",
        says: "Even 2×2 texels are more pleasing than classic mapping.",
        rule: "A trial is a place, solid angles, a measure and a backend: the map of the listing's solid \
            angles (l², which made the pictures) or the text's (l³) is nearer to a path-traced reference than classic mapping, in mean squared \
            error and in mean FLIP, by more than the reference's noise. Each is compared up to one factor on \
            its brightness, since the paper's lobe is not normalised. The reference leaves out the model's \
            shadows on itself; captures hold four reflections.",
    },
    Claim {
        id: "C2",
        says: "They are similar to the map of many texels.",
        rule: "A trial is a place, solid angles and a backend: 2×2 texels differ from 16×16 by less than half of what \
            classic mapping does, root mean square.",
    },
];

pub(super) const FIGURE_6: Experiment = Experiment {
    id: "szirmay-kalos.6",
    paper: Paper::SzirmayKalos,
    item: Item::Figure(6),
    title: "diffuse bunny at several places",
    setup: &pictures(room(&["bunny"], DIFFUSE), Reflection::Diffuse),
    claims: &[
        Claim {
            id: "C1",
            says: "By classic mapping the bunny looks alike everywhere.",
            rule: "A trial is a place and a backend: from the middle of the room to there, irradiance at \
                the same vertices changes by less than half as much as the reference's, root mean \
                square.",
        },
        Claim {
            id: "C2",
            says: "Even 2×2 texels are similar to the map of many texels and to the reference.",
            rule: "A trial is a place, M = 2 or 4, solid angles, a rival picture and a backend: a map of \
                the listing's solid angles (l², which made the pictures) or the text's (l³) differs from \
                that of 16×16 texels by less than half of what classic mapping does, root mean square; \
                and it is nearer to a path-traced reference than classic mapping, in mean squared error \
                beyond the reference's noise. The reference leaves out the model's shadows on itself; captures \
                hold four reflections.",
        },
    ],
};

pub(super) const FIGURE_7: Experiment = Experiment {
    id: "szirmay-kalos.7",
    paper: Paper::SzirmayKalos,
    item: Item::Figure(7),
    title: "specular buddha, shininess 5",
    setup: &pictures(room(&["buddha"], SPECULAR), Reflection::Specular),
    claims: OF_SPECULAR_MODELS,
};

pub(super) const FIGURE_8: Experiment = Experiment {
    id: "szirmay-kalos.8",
    paper: Paper::SzirmayKalos,
    item: Item::Figure(8),
    title: "specular dragon, shininess 5",
    setup: &pictures(room(&["dragon"], SPECULAR), Reflection::Specular),
    claims: OF_SPECULAR_MODELS,
};

/// A figure's pictures.
#[derive(Serialize)]
pub(super) struct Models {
    pub(super) scene: SceneSetup,
    pub(super) reflection: Reflection,
    /// Places of the receiver.
    pub(super) places: &'static [&'static str],
    /// M, texels along a face's edge; the last is the large one.
    pub(super) resolutions: [u32; 3],
    /// Texels along a face's edge of the capture.
    pub(super) capture_resolution: u32,
    /// The listing's solid angle, which made the pictures, and the text's.
    pub(super) weights: [&'static str; 2],
}

/// Largest share of classic mapping's difference from the large map that passes for similar to it.
const SIMILAR: f64 = 0.5;

impl Runs for Models {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        if self.reflection == Reflection::Diffuse {
            let places = (&self.scene, self.places);
            alike::judge(context, places, self.capture_resolution, &mut finding)?;
        }
        for place in self.places {
            self.at(context, place, &mut finding)?;
        }
        Ok(finding)
    }
}

impl Models {
    fn at(
        &self,
        context: &ExperimentContext<'_>,
        place: &str,
        finding: &mut Finding,
    ) -> Result<(), RunError> {
        let quantity = self.reflection.quantity();
        let scene = context.place(&self.scene).set("receiver.place", place);
        let loaded = context.load(&scene, finding)?;
        let view = context.view(&loaded)?;
        let points = view.points(quantity.layout());
        let mut references = context.references(&loaded, quantity, &points);
        let truth = references.model(UNSHADOWED);
        let judge = Judge::new(truth, &points);
        let viewer = Viewer::new(&view, &truth.values, Some(&truth.error));
        let mut row = Row::rendered(place, "reference", &view, &truth.values);
        let capture = self.capture_resolution;
        for backend in context.backends() {
            let mut shoot = |label: &str, shown: bool, method: &dyn Configured| {
                let run = context.run_once(&loaded, backend, method, quantity, &points)?;
                // The published lobe is not normalised: one factor brings a picture to the reference's brightness.
                let estimate = match self.reflection {
                    Reflection::Diffuse => run.estimate,
                    Reflection::Specular => scaled(&run.estimate, judge.factor(&run.estimate)),
                };
                finding.runs.push(run.run);
                let at = |name: &str| (place.to_owned(), format!("{name}, {label}"));
                finding.measure(at(ERROR), backend, judge.error(&estimate), "");
                let looks = Amount::exact(viewer.difference(&estimate));
                finding.measure(at(LOOKS), backend, looks, "");
                if shown && backend == context.backends()[0] {
                    row.add(label, view.image(&estimate));
                }
                Ok::<_, RunError>(estimate)
            };
            let classic = shoot("classic", true, &*classic(context, capture)?)?;
            let mut maps = Vec::new();
            for (weights, name) in self.weights.into_iter().zip(["listing", "text"]) {
                for m in self.resolutions {
                    let method = localized(context, (m, capture), weights, &[])?;
                    // The listing made the pictures.
                    let (label, shown) = match name {
                        "listing" => (format!("M = {m}"), true),
                        _ => (format!("M = {m} by the {name}"), false),
                    };
                    let estimate = shoot(&label, shown, &*method)?;
                    maps.push((format!("M = {m} by the {name}"), estimate));
                }
            }
            let at = (place, backend);
            for maps in maps.chunks_exact(self.resolutions.len()) {
                let [first, second, (_, large)] = maps else {
                    continue;
                };
                match self.reflection {
                    Reflection::Diffuse => {
                        for map in [first, second] {
                            finding.judge("C2", [similar(at, (map, large, &classic))]);
                            finding.judge("C2", [nearer(&judge, at, map, &classic)]);
                        }
                    }
                    Reflection::Specular => {
                        let pleasing = [
                            nearer(&judge, at, first, &classic),
                            looks(&viewer, at, first, &classic),
                        ];
                        finding.judge("C1", pleasing);
                        finding.judge("C2", [similar(at, (first, large, &classic))]);
                    }
                }
            }
        }
        finding.pictures.push(row);
        Ok(())
    }
}

/// A map's name and picture.
type Map = (String, Estimate);

/// That a map is nearer to the reference than classic mapping.
fn nearer(
    judge: &Judge<'_>,
    (place, backend): (&str, Backend),
    map: &Map,
    classic: &Estimate,
) -> Trial {
    let what = format!("{place}: {} nearer to the reference than classic", map.0);
    judge.nearer(what, backend, &map.1, classic)
}

/// That it looks more like it.
fn looks(
    viewer: &Viewer<'_>,
    (place, backend): (&str, Backend),
    map: &Map,
    classic: &Estimate,
) -> Trial {
    let what = format!(
        "{place}: {} looks more like the reference than classic",
        map.0
    );
    viewer.nearer(what, backend, (&map.1, classic))
}

/// That a map differs from the large one by less than half of what classic mapping does, root mean square.
fn similar(
    (place, backend): (&str, Backend),
    (map, large, classic): (&Map, &Estimate, &Estimate),
) -> Trial {
    let from_large = Judge::at(large, None, (0..large.len()).collect());
    let rms = |e: &Estimate| from_large.relative_rms(e).value;
    let what = format!(
        "{place}: {} differs from the large map by less than {SIMILAR} of classic's difference, rms / mean",
        map.0
    );
    let pair = (rms(&map.1), SIMILAR * rms(classic));
    Trial::less_by(what, backend, pair, 0.0)
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{exact, flat, signs};
    use super::*;

    #[test]
    fn few_texels_have_to_be_nearer_than_classic_and_near_to_the_large_map() {
        let reference = flat(1.0);
        let judge = exact(&reference);
        let at = ("wall", Backend::Gpu);
        let (classic, large) = (flat(1.5), flat(0.9));
        let map = |value| ("M = 2".to_owned(), flat(value));
        let judged = |map: Map| {
            let nearer = nearer(&judge, at, &map, &classic);
            let similar = similar(at, (&map, &large, &classic));
            assert_eq!(similar.backend, Backend::Gpu);
            signs([&nearer, &similar])
        };
        assert_eq!(judged(map(1.1)), "++");
        assert_eq!(judged(map(1.3)), "+-");
        assert_eq!(judged(map(0.4)), "--");
    }
}
