//! What a method declares is what it reads, and a session keeps no more than it may.

use super::{Broken, Outcome, Rule, Where, same_bits};
use crate::verify::{MethodUnderTest, OnBackend, VerifyError};
use interreflect_estimators::execution::{BackendScene, Executor};
use interreflect_estimators::{Backend, Changed, Configured, EstimatorError, Quantity};
use interreflect_scene::{
    CubeChannels, CubeSpec, Needs, Points, RsmChannels, RsmSpec, RsmViews, Scene,
};
use std::rc::Rc;

pub(super) fn all() -> [Rule; 3] {
    let rule = |name, about, broken| Rule {
        name,
        about,
        broken: Where::Scene(broken),
    };
    [
        rule(
            "reads_what_it_declares",
            "every declared capture is read",
            |under_test, scene, points| staged(under_test, scene, points, What::ReadsAll),
        ),
        rule(
            "declares_what_it_reads",
            "no undeclared capture can be read, and none is declared that the scene cannot have",
            |under_test, scene, points| staged(under_test, scene, points, What::ReadsNothingElse),
        ),
        rule(
            "prepared_again",
            "a session prepared again for captures alone gives the same bits",
            |under_test, scene, points| staged(under_test, scene, points, What::PreparedAgain),
        ),
    ]
}

enum What {
    ReadsAll,
    ReadsNothingElse,
    PreparedAgain,
}

/// A rule for a scene that is set up.
struct Job<'a> {
    what: What,
    method: &'a dyn Configured,
    quantity: Quantity,
    points: &'a Points,
}

fn staged(under_test: &MethodUnderTest<'_>, scene: &Scene, points: &Points, what: What) -> Outcome {
    let job = Job {
        what,
        method: under_test.method,
        quantity: under_test.quantity,
        points,
    };
    let outcome = under_test.backend.with(scene, job)?;
    Ok(outcome.map_err(VerifyError::from)?)
}

impl OnBackend for Job<'_> {
    type Output = Result<Broken, EstimatorError>;

    fn run<S: BackendScene>(self, scene: &S) -> Self::Output {
        let executor = scene.executor(self.method, self.quantity, self.points)?;
        match self.what {
            What::ReadsAll => reads_all(executor),
            What::ReadsNothingElse => reads_nothing_else(executor),
            What::PreparedAgain => self.prepared_again(executor),
        }
    }
}

fn reads_all<B: Backend>(mut executor: Executor<'_, B>) -> Result<Broken, EstimatorError> {
    executor.estimate()?;
    let (needs, unread) = (executor.needs(), executor.unread());
    let mut broken = Broken::default();
    for spec in &needs.cubes {
        let read = !unread.cubes.contains(spec);
        broken.case(read, || format!("never read: {spec:?}"));
    }
    for spec in &needs.rsms {
        let read = !unread.rsms.contains(spec);
        broken.case(read, || format!("never read: {spec:?}"));
    }
    for spec in &needs.directional_depths {
        let read = !unread.directional_depths.contains(spec);
        broken.case(read, || format!("never read: {spec:?}"));
    }
    broken.case(!unread.environment, || "never read: the environment".into());
    broken.case(!unread.light_transport, || {
        "never read: light transport".into()
    });
    Ok(broken)
}

fn reads_nothing_else<B: Backend>(mut executor: Executor<'_, B>) -> Result<Broken, EstimatorError> {
    let facts = executor.scene().scene().facts();
    let needs = executor.needs().clone();
    let more = more_than(&needs);
    executor.set_captures(Rc::new(executor.scene().capture(&more)?.0));
    let mut broken = Broken::default();
    executor.phase("inspect", Changed::NOTHING, |_, inputs| {
        for spec in more.cubes.difference(&needs.cubes) {
            let refused = matches!(inputs.cube(spec), Err(EstimatorError::Undeclared(_)));
            broken.case(refused, || format!("could be read: {spec:?}"));
        }
        for spec in more.rsms.difference(&needs.rsms) {
            let refused = matches!(inputs.rsm(spec), Err(EstimatorError::Undeclared(_)));
            broken.case(refused, || format!("could be read: {spec:?}"));
        }
        Ok(())
    })?;
    let nothing = executor.unread()
        == Needs {
            keep_within_m: 0.0,
            ..needs.clone()
        };
    broken.case(nothing, || "what was refused counts as read".into());
    for spec in &needs.cubes {
        let places = spec.channels.distance || spec.channels.normal;
        broken.case(facts.captured_surfaces || !places, || {
            format!("asks for the place of surfaces, where there are none: {spec:?}")
        });
    }
    let lit = facts.any_surface && facts.lights > 0;
    broken.case(needs.rsms.is_empty() || lit, || {
        "asks for reflective shadow maps where no light or no surface is".into()
    });
    Ok(broken)
}

impl Job<'_> {
    fn prepared_again<B: Backend>(
        &self,
        mut executor: Executor<'_, B>,
    ) -> Result<Broken, EstimatorError> {
        let first = executor.estimate()?;
        let captures = executor.captures()?;
        let (scene, points) = (executor.scene(), self.points);
        let mut again = scene.executor(self.method, self.quantity, points)?;
        again.set_captures(captures);
        again.prepare(Changed::ALL)?;
        again.prepare(Changed::CAPTURES)?;
        again.shade()?;
        let again = again.read_back()?.0;
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
        more.rsms.insert(RsmSpec {
            size: 3,
            views: RsmViews::Surround,
            channels: RsmChannels {
                normal,
                ..RsmChannels::default()
            },
        });
    }
    more
}
