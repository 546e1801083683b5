//! What a method declares is what it reads, and a session keeps no more than it may.

use super::{Broken, Outcome, Rule, Where, same_bits};
use crate::verify::{OnStage, Subject, VerifyError};
use interreflect_estimators::stage::{Placed, Stage, captured, estimated};
use interreflect_estimators::{Captures, Changed, Configured, EstimatorError, Inputs, Quantity};
use interreflect_scene::{
    CubeChannels, CubeSpec, Estimate, LightViewChannels, LightViewSpec, Needs, Points, Scene,
};

pub(super) fn all() -> [Rule; 4] {
    let rule = |name, about, broken| Rule {
        name,
        about,
        broken: Where::Scene(broken),
    };
    [
        rule(
            "reads_what_it_declares",
            "every declared capture is read",
            |subject, scene, points| staged(subject, scene, points, What::ReadsAll),
        ),
        rule(
            "declares_what_it_reads",
            "no other capture can be read, and what is not in a scene is not asked for",
            |subject, scene, points| staged(subject, scene, points, What::ReadsNothingElse),
        ),
        rule(
            "unprepared",
            "a session that was not prepared says so",
            |subject, scene, points| staged(subject, scene, points, What::Unprepared),
        ),
        rule(
            "prepared_again",
            "a session prepared again for captures alone gives the same bits",
            |subject, scene, points| staged(subject, scene, points, What::PreparedAgain),
        ),
    ]
}

enum What {
    ReadsAll,
    ReadsNothingElse,
    Unprepared,
    PreparedAgain,
}

/// A rule for a scene that is set up.
struct Job<'a> {
    what: What,
    method: &'a dyn Configured,
    quantity: Quantity,
    points: &'a Points,
}

fn staged(subject: &Subject<'_>, scene: &Scene, points: &Points, what: What) -> Outcome {
    let job = Job {
        what,
        method: subject.method,
        quantity: subject.quantity,
        points,
    };
    let outcome = subject.rig.with(scene, job)?;
    Ok(outcome.map_err(VerifyError::from)?)
}

impl OnStage for Job<'_> {
    type Output = Result<Broken, EstimatorError>;

    fn run<S: Stage>(self, stage: &S, scene: &Scene) -> Self::Output {
        match self.what {
            What::ReadsAll => self.reads_all(stage, scene),
            What::ReadsNothingElse => self.reads_nothing_else(stage, scene),
            What::Unprepared => self.unprepared(stage, scene),
            What::PreparedAgain => self.prepared_again(stage, scene),
        }
    }
}

impl Job<'_> {
    fn reads_all<S: Stage>(&self, stage: &S, scene: &Scene) -> Result<Broken, EstimatorError> {
        let (facts, quantity) = (scene.facts(), self.quantity);
        let needs = self.method.needs(quantity, &facts)?;
        let captures = captured(stage, scene, self.method, quantity)?;
        let mut session = stage.open(self.method)?;
        let Placed {
            points: placed,
            mut out,
        } = stage.place(self.points)?;
        let origin = (facts, scene.capture_origin(needs.keep_within_m));
        let inputs = Inputs::new(
            &needs,
            &captures,
            &placed,
            self.points,
            origin,
            Changed::ALL,
        );
        stage.timed("prepare", &mut |cx| {
            session.prepare(cx, quantity, &inputs, &out)
        })?;
        stage.timed("shade", &mut |cx| {
            session.shade(cx, quantity, &inputs, &mut out)
        })?;
        let read = inputs.read();
        let mut broken = Broken::default();
        for spec in &needs.cubes {
            broken.case(read.cubes.contains(spec), || {
                format!("never read: {spec:?}")
            });
        }
        for spec in &needs.light_views {
            broken.case(read.light_views.contains(spec), || {
                format!("never read: {spec:?}")
            });
        }
        for spec in &needs.directional_depths {
            let was = read.directional_depths.contains(spec);
            broken.case(was, || format!("never read: {spec:?}"));
        }
        let flags = [
            (needs.environment, read.environment, "the environment"),
            (
                needs.light_transport,
                read.light_transport,
                "light transport",
            ),
        ];
        for (declared, read, what) in flags {
            broken.case(read || !declared, || format!("never read: {what}"));
        }
        Ok(broken)
    }

    fn reads_nothing_else<S: Stage>(
        &self,
        stage: &S,
        scene: &Scene,
    ) -> Result<Broken, EstimatorError> {
        let facts = scene.facts();
        let needs = self.method.needs(self.quantity, &facts)?;
        let more = more_than(&needs);
        let captures: Captures<S::Backend> = stage.capture(&more)?.0;
        let Placed { points: placed, .. } = stage.place(self.points)?;
        let origin = (facts, scene.reference_point);
        let inputs = Inputs::new(
            &needs,
            &captures,
            &placed,
            self.points,
            origin,
            Changed::ALL,
        );
        let mut broken = Broken::default();
        for spec in more.cubes.difference(&needs.cubes) {
            let refused = matches!(inputs.cube(spec), Err(EstimatorError::Undeclared(_)));
            broken.case(refused, || format!("could be read: {spec:?}"));
        }
        for spec in more.light_views.difference(&needs.light_views) {
            let refused = matches!(inputs.light_view(spec), Err(EstimatorError::Undeclared(_)));
            broken.case(refused, || format!("could be read: {spec:?}"));
        }
        let nothing = inputs.read() == Needs::default();
        broken.case(nothing, || "what was refused counts as read".into());
        for spec in &needs.cubes {
            let places = spec.channels.distance || spec.channels.normal;
            broken.case(facts.surfaces || !places, || {
                format!("asks for the place of surfaces, where there are none: {spec:?}")
            });
        }
        let lit = facts.surfaces && facts.lights > 0;
        broken.case(needs.light_views.is_empty() || lit, || {
            "asks for pictures where no light or no surface is".into()
        });
        Ok(broken)
    }

    fn unprepared<S: Stage>(&self, stage: &S, scene: &Scene) -> Result<Broken, EstimatorError> {
        let (facts, quantity) = (scene.facts(), self.quantity);
        let needs = self.method.needs(quantity, &facts)?;
        let mut broken = Broken::default();
        // Without a state, which traces the scene itself, it may answer.
        if needs.light_transport {
            return Ok(broken);
        }
        let captures = captured(stage, scene, self.method, quantity)?;
        let Placed {
            points: placed,
            mut out,
        } = stage.place(self.points)?;
        let origin = (facts, scene.reference_point);
        let inputs = Inputs::new(
            &needs,
            &captures,
            &placed,
            self.points,
            origin,
            Changed::ALL,
        );
        let mut session = stage.open(self.method)?;
        let shaded = stage.timed("shade", &mut |cx| {
            session.shade(cx, quantity, &inputs, &mut out)
        });
        broken.case(
            matches!(shaded, Err(EstimatorError::Unprepared)),
            || match shaded {
                Err(other) => format!("it fails with another reason: {other}"),
                Ok(_) => "it shades without having been prepared".into(),
            },
        );
        Ok(broken)
    }

    fn prepared_again<S: Stage>(&self, stage: &S, scene: &Scene) -> Result<Broken, EstimatorError> {
        let (facts, quantity) = (scene.facts(), self.quantity);
        let (method, points) = (self.method, self.points);
        let needs = method.needs(quantity, &facts)?;
        let captures = captured(stage, scene, method, quantity)?;
        let first: Estimate = estimated(stage, scene, method, quantity, &captures, points)?;
        let mut session = stage.open(method)?;
        let mut placed = stage.place(points)?;
        let origin = (facts, scene.reference_point);
        let view =
            |changed| Inputs::new(&needs, &captures, &placed.points, points, origin, changed);
        for changed in [Changed::ALL, Changed::CAPTURES] {
            let inputs = view(changed);
            stage.timed("prepare", &mut |cx| {
                session.prepare(cx, quantity, &inputs, &placed.out)
            })?;
        }
        let inputs = view(Changed::NOTHING);
        stage.timed("shade", &mut |cx| {
            session.shade(cx, quantity, &inputs, &mut placed.out)
        })?;
        let again = stage.read_back(&placed.out)?.0;
        let mut broken = Broken::default();
        for (i, (a, b)) in first.iter().zip(again.iter()).enumerate() {
            broken.case(same_bits(a, b), || format!("point {i} has {a} and {b}"));
        }
        Ok(broken)
    }
}

/// What is declared, and captures that nothing declares.
fn more_than(needs: &Needs) -> Needs {
    let mut more = needs.clone();
    more.light_transport = true;
    for normal in [false, true] {
        more.cubes.insert(CubeSpec {
            size: 3,
            channels: CubeChannels {
                radiance: true,
                normal,
                ..CubeChannels::default()
            },
            bounces: 0,
        });
        more.light_views.insert(LightViewSpec {
            size: 3,
            channels: LightViewChannels {
                normal,
                ..LightViewChannels::default()
            },
        });
    }
    more
}
