//! The ladder from float64 to the device: one formula in float64, in one f32 at a time, in sixteen
//! lanes and in WGSL. Leaf functions climb it in `twins`; here what `prepare` makes, estimates at
//! points, and images do.

mod images;
mod points;
mod records;

use interreflect_estimators::{Captures, Cpu};
use interreflect_scene::{CubeImage, LightViewImage};
use libtest_mimic::Trial;

pub(crate) fn trials() -> Vec<Trial> {
    [records::trials(), points::trials(), images::trials()]
        .into_iter()
        .flatten()
        .collect()
}

/// Half a unit in the last place of an f32 of 1.
const ROUNDING: f64 = 5.96e-8;

/// Relative error of a sum of `terms` numbers of one sign in f32: their roundings add up like a
/// random walk, √N, four times that for the worst of some thousand sums; and `own` roundings that a
/// term brings along.
fn sum_of(terms: f64, own: f64) -> f64 {
    (4.0 * terms.sqrt() + own) * ROUNDING
}

/// Texels along the edge of a captured cube.
const CAPTURED: u32 = 64;

/// Texels of all captures: more than any record or estimate is summed of.
fn texels(captures: &Captures<Cpu>) -> f64 {
    let cubes = captures.cubes.values().map(CubeImage::texels);
    let views = captures.light_views.values().map(LightViewImage::texels);
    cubes.chain(views).sum::<usize>() as f64
}

/// Roundings that a term of a sum brings along: those of the direction to a texel that is a tenth of
/// a unit away at least, as the leaf functions state them.
const OF_A_TERM: f64 = 40.0;
