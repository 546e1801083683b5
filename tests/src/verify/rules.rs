//! What every estimator must keep to, whatever it computes.

mod captures;
mod points;

use super::box_scene::{BoxScene, Lighting};
use super::case::Case;
use super::{Asked, Checked, Finding, Found, MethodUnderTest, Nothing, judged};
use glam::Vec3;
use interreflect_scene::{Points, Scene};

/// A rule: how often it was broken in so many cases, and where first.
pub(super) struct Rule {
    pub(super) name: &'static str,
    pub(super) about: &'static str,
    broken: Where,
}

/// Where a rule can be tried.
enum Where {
    /// In any scene, at any points.
    Scene(fn(&MethodUnderTest<'_>, &Scene, &Points) -> Outcome),
    /// In a box scene that the rule varies.
    BoxScene(fn(&MethodUnderTest<'_>, BoxScene) -> Outcome),
}

/// How often a rule was broken.
#[derive(Default)]
struct Broken {
    cases: usize,
    count: usize,
    first: String,
}

impl Broken {
    /// Looks at one more case.
    fn case(&mut self, holds: bool, what: impl FnOnce() -> String) {
        self.cases += 1;
        if !holds {
            self.count += 1;
            if self.count == 1 {
                self.first = what();
            }
        }
    }
}

impl Broken {
    /// Takes in what was found in one more box scene.
    fn add(&mut self, found: Self, lighting: Lighting) {
        if self.count == 0 && found.count > 0 {
            self.first = format!("{lighting:?}: {}", found.first);
        }
        self.cases += found.cases;
        self.count += found.count;
    }
}

/// All rules.
pub(super) fn all() -> Vec<Rule> {
    captures::all().into_iter().chain(points::all()).collect()
}

impl Rule {
    /// Tries the rule: where any scene will do, in closed walls, in the light of a lamp and under an open
    /// sky, as far as the method can work there.
    pub(super) fn run(&self, under_test: &MethodUnderTest<'_>) -> Found {
        let broken = match self.broken {
            Where::Scene(broken) => broken,
            Where::BoxScene(broken) => {
                return finding(broken(
                    under_test,
                    box_scene(Lighting::of(under_test.model(), under_test.quantity)),
                )?);
            }
        };
        let (mut all, mut reason) = (Broken::default(), None);
        for lighting in [Lighting::Walls, Lighting::Lamp, Lighting::Sky] {
            let box_scene = box_scene(lighting);
            let points = box_scene.placed_points(under_test.quantity);
            match broken(under_test, &box_scene.scene(), &points) {
                Ok(found) => all.add(found, lighting),
                Err(Nothing::NotApplicable(why)) => reason = Some(why),
                Err(error) => return Err(error),
            }
        }
        match (all.cases, reason) {
            (0, Some(why)) => Err(Nothing::NotApplicable(why)),
            _ => finding(all),
        }
    }

    fn in_scene(&self, under_test: &MethodUnderTest<'_>, scene: &Scene, points: &Points) -> Found {
        match self.broken {
            Where::Scene(broken) => finding(broken(under_test, scene, points)?),
            Where::BoxScene(_) => Err(Nothing::NotApplicable(
                "it needs a box scene to vary".into(),
            )),
        }
    }
}

/// The rules that can be tried in any scene, tried there: each one's name and what it came to.
pub fn rules_in<'a>(
    under_test: &'a MethodUnderTest<'a>,
    scene: &'a Scene,
    points: &'a Points,
) -> impl Iterator<Item = (&'static str, Checked)> + 'a {
    let anywhere = all().into_iter();
    let anywhere = anywhere.filter(|rule| matches!(rule.broken, Where::Scene(_)));
    anywhere.map(|rule| {
        let found = rule.in_scene(under_test, scene, points);
        (rule.name, judged(&Asked::Claimed, found))
    })
}

fn finding(broken: Broken) -> Found {
    Ok(Finding {
        value: broken.count as f64,
        bound: 0.0,
        cases: broken.cases,
        note: broken.first,
        counterexample: None,
    })
}

/// A box scene of unequal walls, with more points than a block of 64, and not a multiple of sixteen.
fn box_scene(lighting: Lighting) -> BoxScene {
    const POINTS: usize = 203;
    Case::unequal(POINTS).box_scene(lighting)
}

fn same_bits(a: Vec3, b: Vec3) -> bool {
    a.to_array().map(f32::to_bits) == b.to_array().map(f32::to_bits)
}

type Outcome = Result<Broken, Nothing>;
