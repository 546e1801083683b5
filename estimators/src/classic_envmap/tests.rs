use super::super::map::Source;
use super::{AVERAGE, Average, CONVOLVE, Convolve, SHADE, Shade};
use crate::layout::assert_layout;

#[test]
fn structs_have_the_same_layout() {
    assert_layout!(AVERAGE, Average, [resolution, size]);
    assert_layout!(CONVOLVE, Convolve, [nodes, sources, first, exponent]);
    assert_layout!(SHADE, Shade, [cells, lobes, pad, exponents]);
    for shader in [AVERAGE, CONVOLVE] {
        assert_layout!(shader, Source, [vector, pad, radiance, pad2]);
    }
}
