use super::super::texels::{EDGE_ON, NEAREST_M, Texel};
use super::{AVERAGE, Average, SHADE_STORAGE, SHADE_UNIFORM, Shade, UNIFORM_TEXELS};
use crate::layout::{array_length, assert_layout, constant, module};

#[test]
fn structs_have_the_same_layout() {
    assert_layout!(AVERAGE, Average, [m, size, shader_omega, located]);
    for shader in [SHADE_UNIFORM, SHADE_STORAGE] {
        assert_layout!(shader, Shade, [origin, count]);
    }
    for shader in [AVERAGE, SHADE_UNIFORM, SHADE_STORAGE] {
        assert_layout!(
            shader,
            Texel,
            [direction, inverse_distance, radiance, extent, normal, pad]
        );
    }
}

#[test]
fn constants_are_the_same() {
    let average = module(&AVERAGE);
    assert_eq!(constant(&average, "NEAREST_M"), NEAREST_M);
    assert_eq!(constant(&average, "EDGE_ON"), EDGE_ON as f32);
    let length = array_length(&module(&SHADE_UNIFORM), "texels");
    assert_eq!(length, Some(UNIFORM_TEXELS as u32));
}
