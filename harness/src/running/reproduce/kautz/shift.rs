//! The same picture with the faces of the cube turned against it: a filter that depended on the direction would show.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::pictures::Row;
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::Amount;
use super::super::viewer::{LOOKS, SHOWN, Viewer};
use super::super::{Claim, Experiment, Item, Paper};
use super::biased;
use super::phong::unnoticed;
use super::studio;
use super::{MIRRORING, PIXELS, RESOLUTION};
use crate::running::error::RunError;
use crate::running::view::Look;
use glam::Quat;
use interreflect_estimators::{Configured, Quantity};
use interreflect_scene::{Point, Points};
use serde::Serialize;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "kautz.shift-variance",
    paper: Paper::Kautz,
    item: Item::Section("4.2"),
    title: "the box filter's shape over the sphere",
    setup: &Shift {
        scene: studio(&["bunny"], MIRRORING),
        bias: 2.25,
        resolution: RESOLUTION,
        pixels: PIXELS,
        turned_deg: 45.0,
    },
    claims: &[Claim {
        id: "C1",
        says: "That the filter differs from direction to direction is hardly noticeable.",
        rule: "A trial is a backend: a picture of mirrored light alone, and the same with the cube's faces \
            turned by 45°, clipped and encoded as they are shown, differ by less than 5 % of white, rms.",
    }],
};

/// A mirroring model under an environment, and how far both are turned.
#[derive(Serialize)]
pub(super) struct Shift {
    pub(super) scene: SceneSetup,
    /// b of the box filter.
    pub(super) bias: f64,
    /// Texels along a face's edge of the pyramid's base.
    pub(super) resolution: u32,
    /// Pixels along the picture's edge, whatever the effort: the hardware's level rises where pixels are larger.
    pub(super) pixels: u32,
    /// Degrees about the axis upwards by which environment and model are turned against the cube.
    pub(super) turned_deg: f64,
}

impl Runs for Shift {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        let quantity = Quantity::GlossyRadiance;
        let scene = context.scene(&context.place(&self.scene), &mut finding)?;
        let degrees = self.turned_deg as f32;
        let mut turned = scene.clone();
        if let Some(environment) = &mut turned.environment {
            environment.rotate_deg += degrees;
        }
        let (loaded, loaded_turned) = (context.set_up(&scene)?, context.set_up(&turned)?);
        let view = context.whole_view(&loaded, self.pixels, Look::default())?;
        let points = view.points(quantity.layout());
        let points_turned = turn(&points, Quat::from_rotation_y(degrees.to_radians()));
        let parameters: [(&str, &dyn ToString); 2] = [("exponent", &225), ("f_lambda", &1)];
        let phong = context.method("phong_envmap", &parameters)?;
        let boxed = biased(context, self.resolution, self.bias, 1.0)?;
        for backend in context.backends() {
            for (filter, method) in [("box", &boxed), ("Phong", &phong)] {
                let method: &dyn Configured = &**method;
                let as_is = context.run_once(&loaded, backend, method, quantity, &points)?;
                let faces_turned =
                    context.run_once(&loaded_turned, backend, method, quantity, &points_turned)?;
                let viewer = Viewer::new(&view, &as_is.estimate, None);
                let rms = viewer.shown_rms(&faces_turned.estimate);
                let looks = viewer.difference(&faces_turned.estimate);
                for (name, value) in [(SHOWN, rms), (LOOKS, looks)] {
                    finding.measure((filter, name), backend, Amount::exact(value), "");
                }
                if filter == "box" {
                    finding.judge("C1", [unnoticed(backend, rms)]);
                }
                if backend == context.backends()[0] {
                    let title = format!("{filter} filter");
                    let mut row = Row::rendered(title, "as it is", &view, &as_is.estimate);
                    let caption = format!("faces turned by {}°", self.turned_deg);
                    row.add(caption, view.image(&faces_turned.estimate));
                    finding.pictures.push(row);
                }
                finding.runs.extend([as_is.run, faces_turned.run]);
            }
        }
        Ok(finding)
    }
}

/// Points turned about the origin.
fn turn(points: &Points, by: Quat) -> Points {
    let turned = |point: Point| Point {
        position: by * point.position,
        normal: by * point.normal,
        view: by * point.view,
        ..point
    };
    Points::new(
        points.layout(),
        points.iter().map(|point| point.map(turned)),
    )
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::signs;
    use super::*;
    use crate::domain::record::Backend;
    use glam::Vec3;
    use interreflect_scene::PointLayout;

    #[test]
    fn pictures_may_differ_by_a_twentieth_of_white() {
        let judged = |rms| signs([&unnoticed(Backend::Cpu, rms)]);
        assert_eq!((judged(0.049), judged(0.051)), ("+".into(), "-".into()));
        let at = Point {
            position: Vec3::X,
            normal: Vec3::Z,
            view: Vec3::Y,
            ..Point::default()
        };
        let points = Points::new(PointLayout::Material, [Some(at), None]);
        let turned = turn(&points, Quat::from_rotation_y(std::f32::consts::FRAC_PI_2));
        let found = turned
            .get(0)
            .map(|p| (p.position.round(), p.normal.round(), p.view.round()));
        assert_eq!(found, Some((Vec3::NEG_Z, Vec3::X, Vec3::Y)));
        assert_eq!(turned.get(1), None);
    }
}
