use super::pyramid::{PYRAMID, Reduce};
use super::{SHADE, Shade};
use interreflect_gpu::layout::assert_layout;

#[test]
fn structs_have_the_same_layout() {
    assert_layout!(SHADE, Shade, [base, top, lod, bias, f_lambda]);
    assert_layout!(PYRAMID, Reduce, [base, size, first_weight, across]);
}
