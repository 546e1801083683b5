//! Laws of form factors, tried on a method's own kernel with random patches.

use super::{Asked, Finding, Found, MethodUnderTest, Nothing, claimed};
use glam::{Quat, Vec3};
use interreflect_estimators::{Claim, FormFactorLaw, PatchKernel};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestError, TestRng, TestRunner};
use std::cell::Cell;
use std::f64::consts::PI;

/// A law with the way to falsify it.
pub(super) struct Law {
    pub(super) name: &'static str,
    pub(super) about: &'static str,
    law: FormFactorLaw,
    violation: fn(PatchKernel, &Pair) -> f64,
    bound: f64,
    cause: &'static str,
}

/// All laws.
pub(super) fn all() -> [Law; 6] {
    [
        Law {
            name: "form_factor_fraction",
            about: "a form factor lies between 0 and 1",
            law: FormFactorLaw::Fraction,
            violation: fraction,
            bound: 1e-6,
            cause: "float32",
        },
        Law {
            name: "form_factor_additive",
            about: "the four parts of a quadrilateral add up to it",
            law: FormFactorLaw::Additive,
            violation: additive,
            bound: 2e-6,
            cause: "float32, and middles of edges that are rounded",
        },
        Law {
            name: "form_factor_closed",
            about: "the faces of a box around a point add up to 1",
            law: FormFactorLaw::Closed,
            violation: closed,
            bound: 3e-6,
            cause: "float32 over six faces",
        },
        Law {
            name: "form_factor_oriented",
            about: "reversing the corners changes the sign only",
            law: FormFactorLaw::Oriented,
            violation: oriented,
            bound: 1e-6,
            cause: "float32",
        },
        Law {
            name: "form_factor_reciprocal",
            about: "A₁F₁₂ = A₂F₂₁ for two patches",
            law: FormFactorLaw::ReciprocalPatches,
            violation: reciprocal,
            bound: 1e-4,
            cause: "float32 in small polygons, and five Gauss points along each edge",
        },
        Law {
            name: "form_factor_reciprocal_middles",
            about: "A₁F₁₂ = A₂F₂₁ from middle to middle",
            law: FormFactorLaw::ReciprocalMiddles,
            violation: reciprocal_middles,
            bound: 2e-6,
            cause: "float32",
        },
    ]
}

/// Random pairs of patches.
const PAIRS: u32 = 256;

impl Law {
    pub(super) fn asks(&self, claim: &Claim) -> bool {
        matches!(claim, Claim::FormFactor { law, .. } if *law == self.law)
    }

    /// Tries to falsify the law.
    pub(super) fn run(&self, under_test: &MethodUnderTest<'_>) -> (Asked, Found) {
        (Asked::Claimed, self.found(under_test))
    }

    fn found(&self, under_test: &MethodUnderTest<'_>) -> Found {
        if under_test.backend.name() != "cpu" {
            let why = "a kernel is tried on the host; its WGSL twin is compared with it".into();
            return Err(Nothing::NotApplicable(why));
        }
        let kernel = claimed(under_test, |claim| match *claim {
            Claim::FormFactor { law, kernel } if law == self.law => Some(kernel),
            _ => None,
        });
        let kernel = kernel.ok_or_else(|| {
            Nothing::NotApplicable("it claims nothing of this kind of a kernel".into())
        })?;
        let worst = Cell::new(0.0_f64);
        let config = Config {
            cases: PAIRS,
            failure_persistence: None,
            ..Config::default()
        };
        let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &[7; 32]);
        let outcome = TestRunner::new_with_rng(config, rng).run(&Pair::any(), |pair| {
            let value = (self.violation)(kernel, &pair);
            worst.set(worst.get().max(value));
            match value <= self.bound {
                true => Ok(()),
                false => Err(TestCaseError::fail(value.to_string())),
            }
        });
        let (value, note) = match outcome {
            Err(TestError::Fail(_, pair)) => (
                (self.violation)(kernel, &pair),
                format!("{}; {pair:?}", self.cause),
            ),
            _ => (worst.get(), self.cause.into()),
        };
        Ok(Finding {
            value,
            bound: self.bound,
            cases: PAIRS as usize,
            note,
            counterexample: None,
        })
    }
}

/// A parallelogram: its middle and half its edges.
#[derive(Clone, Copy, Debug)]
struct Patch {
    middle: Vec3,
    s: Vec3,
    t: Vec3,
}

/// Two patches that see each other's front wholly.
#[derive(Clone, Debug)]
struct Pair {
    first: Patch,
    second: Patch,
    /// A point's place in the unit cube and its normal, for laws of a point.
    at: Vec3,
    normal: Vec3,
}

impl Pair {
    fn any() -> impl Strategy<Value = Self> {
        let tenths = |range: std::ops::RangeInclusive<i32>| range.prop_map(|v| v as f32 / 10.0);
        let vector = |most: i32| prop::array::uniform3(tenths(-most..=most)).prop_map(Vec3::from);
        let normal = vector(10).prop_filter("a normal", |n| *n != Vec3::ZERO);
        let sizes = prop::array::uniform4(tenths(1..=6));
        (sizes, vector(3), tenths(12..=30), vector(8), normal).prop_map(
            |(size, tilt, distance, at, normal)| {
                let turn = Quat::from_scaled_axis(tilt);
                Self {
                    first: Patch {
                        middle: Vec3::ZERO,
                        s: Vec3::X * size[0],
                        t: Vec3::Y * size[1],
                    },
                    second: Patch {
                        middle: Vec3::new(0.3 * tilt.x, 0.4 * tilt.y, distance),
                        s: turn * (Vec3::Y * size[2]),
                        t: turn * (Vec3::X * size[3]),
                    },
                    at,
                    normal: normal.normalize(),
                }
            },
        )
    }
}

impl Patch {
    /// Clockwise seen from the side that the normal points to.
    fn corners(&self) -> [Vec3; 4] {
        let (s, t) = (self.s, self.t);
        [-s - t, t - s, s + t, s - t].map(|c| self.middle + c)
    }

    fn normal(&self) -> Vec3 {
        self.s.cross(self.t).normalize()
    }

    fn area(&self) -> f64 {
        4.0 * f64::from(self.s.cross(self.t).length())
    }

    fn parts(&self) -> [Self; 4] {
        let (s, t) = (0.5 * self.s, 0.5 * self.t);
        [s + t, s - t, t - s, -s - t].map(|c| Self {
            middle: self.middle + c,
            s,
            t,
        })
    }
}

fn factor(kernel: PatchKernel, x: Vec3, n: Vec3, patch: &Patch) -> f64 {
    f64::from(kernel(x, n, &patch.corners())) / PI
}

fn fraction(kernel: PatchKernel, pair: &Pair) -> f64 {
    let f = factor(kernel, pair.at, pair.normal, &pair.second);
    (f - 1.0).max(-f).max(0.0)
}

fn additive(kernel: PatchKernel, pair: &Pair) -> f64 {
    let of = |patch: &Patch| factor(kernel, pair.at, pair.normal, patch);
    let parts: f64 = pair.second.parts().iter().map(of).sum();
    (of(&pair.second) - parts).abs()
}

fn oriented(kernel: PatchKernel, pair: &Pair) -> f64 {
    let mut turned = pair.second;
    std::mem::swap(&mut turned.s, &mut turned.t);
    let of = |patch: &Patch| factor(kernel, pair.at, pair.normal, patch);
    (of(&pair.second) + of(&turned)).abs()
}

/// The six faces of a box, seen from inside.
fn closed(kernel: PatchKernel, pair: &Pair) -> f64 {
    let half = Vec3::new(1.0, 1.2, 0.9);
    let faces = (0..6).map(|face| {
        let (axis, s, t) = interreflect_scene::conventions::cube_frame(face);
        let [middle, s, t] = [axis, s, t].map(|v| v.as_vec3() * half);
        let inward = s.cross(t).dot(middle) < 0.0;
        let (s, t) = if inward { (s, t) } else { (t, s) };
        factor(kernel, pair.at, pair.normal, &Patch { middle, s, t })
    });
    (faces.sum::<f64>() - 1.0).abs()
}

fn reciprocal(kernel: PatchKernel, pair: &Pair) -> f64 {
    let (a, b) = (&pair.first, &pair.second);
    let (ab, ba) = (mean(kernel, a, b), mean(kernel, b, a));
    (a.area() * ab - b.area() * ba).abs() / (a.area() * ab).abs().max(1e-6)
}

/// Nodes in [−1, 1] and weights of the Gauss–Legendre rule of five points.
const GAUSS: [(f32, f64); 5] = [
    (-0.906_179_85, 0.236_926_885_056_189_1),
    (-0.538_469_3, 0.478_628_670_499_366_5),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_3, 0.478_628_670_499_366_5),
    (0.906_179_85, 0.236_926_885_056_189_1),
];

/// Mean form factor over a patch.
fn mean(kernel: PatchKernel, over: &Patch, of: &Patch) -> f64 {
    let n = over.normal();
    let mut sum = 0.0;
    for (s, weight_s) in GAUSS {
        for (t, weight_t) in GAUSS {
            let x = over.middle + over.s * s + over.t * t;
            sum += 0.25 * weight_s * weight_t * factor(kernel, x, n, of);
        }
    }
    sum
}

fn reciprocal_middles(kernel: PatchKernel, pair: &Pair) -> f64 {
    let (a, b) = (&pair.first, &pair.second);
    let ab = factor(kernel, a.middle, a.normal(), b);
    let ba = factor(kernel, b.middle, b.normal(), a);
    (a.area() * ab - b.area() * ba).abs() / (a.area() * ab).abs().max(1e-6)
}
