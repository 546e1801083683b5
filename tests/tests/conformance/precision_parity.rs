//! One formula in float64, in one f32 at a time, in sixteen lanes and in WGSL: what `prepare` makes,
//! estimates at points, and images. Leaf functions are in `leaf_parity`.

mod images;
mod points;
mod records;

use interreflect_conformance::verify::parity::{OF_A_TERM, sum_of, texels};
use libtest_mimic::Trial;

pub(crate) fn trials() -> Vec<Trial> {
    [records::trials(), points::trials(), images::trials()]
        .into_iter()
        .flatten()
        .collect()
}

/// Texels along the edge of a captured cube.
const CAPTURED: u32 = 64;
