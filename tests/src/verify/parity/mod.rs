//! The GPU against the CPU: shaders, leaf functions, what `prepare` makes, and estimates, all of the
//! same captures.

mod estimates;
mod leaves;
mod records;

pub use estimates::{estimate_parity, float32};
pub use leaves::{on_device as leaf_on_device, on_host as leaf_on_host};
pub use records::record_parity;

use super::{Finding, Found, MethodUnderTest, Nothing, TestBackend, VerifyError};
use crate::verify::box_scene::Lighting;
use crate::verify::case::Case;
use interreflect_estimators::execution::LoadedScene;
use interreflect_estimators::{Captures, Cpu};
use interreflect_gpu::{GpuContext, validate};
use interreflect_scene::{CubeImage, Points, RsmImage};
use std::sync::Arc;

/// A check that asks both backends.
pub(super) struct Parity {
    pub(super) name: &'static str,
    pub(super) about: &'static str,
    find: fn(&MethodUnderTest<'_>, &Arc<GpuContext>) -> Found,
}

/// All of them.
pub(super) fn all() -> [Parity; 4] {
    [
        Parity {
            name: "shaders_valid",
            about: "every shader is valid WGSL",
            find: shaders_valid,
        },
        Parity {
            name: "leaf_parity",
            about: "leaf functions agree in float32, in lanes and in WGSL with float64",
            find: leaves::parity,
        },
        Parity {
            name: "record_parity",
            about: "both backends prepare the same records from the same captures",
            find: |under_test, context| in_box_scenes(under_test, context, record_parity),
        },
        Parity {
            name: "estimate_parity",
            about: "both backends give the same estimates from the same captures",
            find: |under_test, context| in_box_scenes(under_test, context, estimate_parity),
        },
    ]
}

impl Parity {
    pub(super) fn run(&self, under_test: &MethodUnderTest<'_>) -> Found {
        let TestBackend::Gpu(_, context) = under_test.backend else {
            let why = "the GPU is compared with the CPU: asked on the GPU";
            return Err(Nothing::NotApplicable(why.into()));
        };
        under_test.method.on_cpu().map(drop)?;
        (self.find)(under_test, context)
    }
}

fn shaders_valid(under_test: &MethodUnderTest<'_>, _context: &Arc<GpuContext>) -> Found {
    let shaders = under_test.method.shaders();
    let mut finding = Finding {
        cases: shaders.len(),
        ..Finding::default()
    };
    for shader in shaders {
        if let Err(why) = validate(shader) {
            finding.value += 1.0;
            finding.note = why;
        }
    }
    Ok(finding)
}

/// What a comparison came to: the largest difference over what it may be, and where that is.
pub struct Apart {
    /// At most 1 where it holds.
    pub of_bound: f64,
    /// Numbers that were compared.
    pub cases: usize,
    /// Where the largest difference is, and why there is one.
    pub place: String,
}

impl Apart {
    /// Keeps the larger difference. One that is no number is larger than all: it does not get lost among
    /// those that hold.
    fn keep_larger(&mut self, of_bound: f64, place: impl FnOnce() -> String) {
        let of_bound = match of_bound.is_nan() {
            true => f64::INFINITY,
            false => of_bound,
        };
        if of_bound > self.of_bound {
            (self.of_bound, self.place) = (of_bound, place());
        }
    }
}

/// A comparison of the backends in a scene, at points.
type Compare =
    fn(&MethodUnderTest<'_>, &Arc<GpuContext>, &LoadedScene, &Points) -> Result<Apart, VerifyError>;

/// Tries all box scenes that the method can run in: closed walls that emit, a lamp, an open sky.
fn in_box_scenes(
    under_test: &MethodUnderTest<'_>,
    context: &Arc<GpuContext>,
    compare: Compare,
) -> Found {
    const POINTS: usize = 203;
    let mut finding = Finding {
        bound: 1.0,
        ..Finding::default()
    };
    let mut reason = None;
    for lighting in [Lighting::Walls, Lighting::Lamp, Lighting::Sky] {
        let box_scene = Case::unequal(POINTS).box_scene(lighting);
        let points = box_scene.placed_points(under_test.quantity);
        let apart = under_test.backend.load(&box_scene.scene());
        let apart = apart.and_then(|loaded| compare(under_test, context, &loaded, &points));
        match apart.map_err(Nothing::from) {
            Ok(apart) => {
                finding.cases += apart.cases;
                if apart.of_bound >= finding.value {
                    finding.value = apart.of_bound;
                    finding.note = format!("{lighting:?}: {}", apart.place);
                }
            }
            Err(Nothing::NotApplicable(why)) => reason = Some(why),
            Err(broken) => return Err(broken),
        }
    }
    match (finding.cases, reason) {
        (0, Some(why)) => Err(Nothing::NotApplicable(why)),
        _ => Ok(finding),
    }
}

/// Refuses captures that the backends can't share.
fn shared(captures: &Captures<Cpu>) -> Result<(), VerifyError> {
    match captures.depths.is_empty() {
        true => Ok(()),
        false => {
            let why = "depth maps are made while they are read, each backend's by itself";
            Err(VerifyError::NotComparable(why.into()))
        }
    }
}

/// Half a unit in the last place of an f32 of 1.
pub const ROUNDING: f64 = 5.96e-8;

/// Relative error of the power of a lobe.
const LOBE: f64 = 1e-5;

/// Relative error of a sum of `terms` numbers of one sign in f32: their roundings add up like a
/// random walk, √N, four times that for the worst of some thousand sums; and `own` roundings that a
/// term brings along.
pub fn sum_of(terms: f64, own: f64) -> f64 {
    (4.0 * terms.sqrt() + own) * ROUNDING
}

/// Roundings that a term of a sum brings along: those of the direction to a texel that is a tenth of
/// a unit away at least, as the leaf functions state them.
pub const OF_A_TERM: f64 = 40.0;

/// Texels of all captures: more than any record or estimate is summed of.
pub fn texels(captures: &Captures<Cpu>) -> f64 {
    let cubes = captures.cubes.values().map(CubeImage::texels);
    let views = captures.rsms.values().map(RsmImage::texels);
    cubes.chain(views).sum::<usize>() as f64
}
