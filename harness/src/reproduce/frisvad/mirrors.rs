//! What mirrors show of indirect light: nothing, a trick, or what is there.

use super::super::desk::{Desk, Room};
use super::super::finding::Finding;
use super::super::judge::{Judge, scaled};
use super::super::pictures::Row;
use super::super::place::Place;
use super::super::verdict::{Amount, Trial};
use super::bleeding::reflected;
use crate::error::HarnessError;
use crate::output::HdrImage;
use crate::record::Backend;
use crate::view::{Look, Mirrors, ShadedAt, View};
use interreflect_estimators::Quantity;
use interreflect_scene::{Estimate, PointLayout};

/// The figure's pictures.
const SHOWN: [(&str, Mirrors); 3] = [
    ("(a) none", Mirrors::Direct),
    ("(b) trick", Mirrors::Diffuse),
    ("(c) included", Mirrors::Included),
];

pub(super) fn run(desk: &Desk<'_>) -> Result<Finding, HarnessError> {
    let mut finding = Finding::default();
    let room = desk.room(&Place::of("cave"), &mut finding)?;
    let mut views = Vec::new();
    for (name, mirrors) in SHOWN {
        views.push((name, look(desk, &room, mirrors)?));
    }
    let (direct, included) = (&views[0].1, &views[2].1);
    // Where only light in mirrors makes the difference.
    let plain = direct.surfaces();
    let mirrored = included.surfaces().into_iter().enumerate();
    let at: Vec<usize> = mirrored
        .filter(|&(i, shows)| shows && !plain[i])
        .map(|(i, _)| i)
        .collect();
    let points = included.points(Quantity::Irradiance.layout());
    let mut references = desk.references(&room, Quantity::Irradiance, &points);
    let truth = references.truth();
    let reference = lit(included, &truth.values);
    let materials = included.points(PointLayout::Material);
    let error = included.image(&reflected(&materials, &truth.error));
    let (values, errors) = (reference.to_estimate(), error.to_estimate());
    let judge = Judge::at(&values, Some(&errors), at);
    let mut row = Row::against(
        "a mirror and a mirror ball",
        "path tracing",
        reference,
        included.surfaces(),
    );
    let everywhere = Judge::new(truth, &points);
    for backend in desk.backends() {
        let mut pictures = Vec::new();
        // Few samples are too dark in mirrors and beside them alike.
        let plain = shoot(desk, &room, (included, backend), &mut finding)?;
        let factor = everywhere.factor(&plain);
        for (name, view) in &views {
            let light = shoot(desk, &room, (view, backend), &mut finding)?;
            let image = lit(view, &scaled(&light, factor));
            let error = judge.error(&image.to_estimate());
            finding.measure((*name, "MSE / mean² in mirrors"), backend, error, "");
            let shaded = Amount::exact(view.points(PointLayout::Surface).len() as f64);
            finding.measure((*name, "points"), backend, shaded, "");
            pictures.push(image.to_estimate());
            if backend == desk.backends()[0] {
                row.add(*name, image);
            }
        }
        finding.trials.extend(steps(&judge, backend, &pictures));
    }
    finding.pictures.push(row);
    Ok(finding)
}

/// That each of the figure's pictures is nearer to the reference than the one before.
fn steps(judge: &Judge<'_>, backend: Backend, pictures: &[Estimate]) -> Vec<Trial> {
    let names = ["(b) nearer than (a)", "(c) nearer than (b)"];
    let pairs = pictures.windows(2).zip(names);
    let nearer =
        |(pair, what): (&[Estimate], &str)| judge.nearer(what, backend, &pair[1], &pair[0]);
    pairs.map(nearer).collect()
}

fn look(desk: &Desk<'_>, room: &Room<'_>, mirrors: Mirrors) -> Result<View, HarnessError> {
    let look = Look {
        at: ShadedAt::Pixels,
        mirrors,
    };
    desk.whole_view(room, desk.pick(180, 640), look)
}

fn shoot(
    desk: &Desk<'_>,
    room: &Room<'_>,
    (view, backend): (&View, Backend),
    finding: &mut Finding,
) -> Result<Estimate, HarnessError> {
    let map = desk.method(
        "direct_radiance_map",
        &[("fidelity", &"corrected"), ("samples_per_side", &5)],
    )?;
    let points = view.points(Quantity::Irradiance.layout());
    let shot = desk.shot(room, backend, &*map, Quantity::Irradiance, &points)?;
    finding.runs.push(shot.run);
    Ok(shot.estimate)
}

fn lit(view: &View, irradiance: &Estimate) -> HdrImage {
    view.lit(&reflected(&view.points(PointLayout::Material), irradiance))
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{exact, flat, signs};
    use super::*;

    #[test]
    fn each_picture_has_to_be_nearer_than_the_one_before() {
        let reference = flat(1.0);
        let judge = exact(&reference);
        let judged = |values: [f32; 3]| signs(&steps(&judge, Backend::Cpu, &values.map(flat)));
        assert_eq!(judged([0.0, 0.5, 0.9]), "++");
        assert_eq!(judged([0.9, 0.5, 0.0]), "--");
        assert_eq!(judged([0.0, 0.9, 0.5]), "+-");
    }
}
