use super::{SHADE, Shade};
use interreflect_gpu::layout::assert_layout;

#[test]
fn structs_have_the_same_layout() {
    assert_layout!(SHADE, Shade, [cells, lobes, pad, exponents]);
}
