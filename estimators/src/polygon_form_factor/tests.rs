use super::super::corners::NONE;
use super::{Build, CORNERS, SHADE, Shade};
use interreflect_gpu::layout::{assert_layout, constant_u32, module};

#[test]
fn structs_have_the_same_layout() {
    assert_layout!(CORNERS, Build, [m, size, place, exact, mean_radiance, pad]);
    assert_layout!(SHADE, Shade, [origin, m, reused]);
}

#[test]
fn constants_are_the_same() {
    assert_eq!(constant_u32(&module(&CORNERS), "NONE"), NONE);
    let longest = constant_u32(&module(&SHADE), "MAX_SIDE");
    assert_eq!(longest, super::super::cpu::MAX_SIDE as u32);
}
