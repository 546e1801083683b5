use super::super::Texel;
use super::super::average::{EDGE_ON, LEAST_COS, NEAREST_M};
use super::super::math::COINCIDENT;
use super::{AVERAGE, Average, Gather, STORAGE, UNIFORM, UNIFORM_TEXELS, gather_parts};
use interreflect_gpu::Shader;
use interreflect_gpu::layout::{array_length, assert_layout, constant, module};

/// A method that says the least of its texels.
const LIGHT: &str = "
fn texel_omega(extent: f32, r2: f32, cos_surface: f32) -> f32 { return extent; }
fn texel_cosine(n_i: f32, omega: f32) -> f32 { return n_i; }
fn texel_lobe(shininess: f32) -> f32 { return shininess; }
fn texel_reflectivity(lobe: f32, n_i: f32, n_v: f32, n_h: f32, omega: f32) -> Reflectivity {
    return Reflectivity(n_i, 0.0);
}
";

const SHADERS: [Shader; 2] = [
    Shader {
        label: "uniform texels",
        parts: &gather_parts("", LIGHT, UNIFORM),
    },
    Shader {
        label: "stored texels",
        parts: &gather_parts("", LIGHT, STORAGE),
    },
];

#[test]
fn structs_have_the_same_layout() {
    assert_layout!(AVERAGE, Average, [m, size, place, pad]);
    for shader in SHADERS {
        assert_layout!(shader, Gather, [origin, count]);
    }
    for shader in [AVERAGE].into_iter().chain(SHADERS) {
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
    assert_eq!(constant(&average, "LEAST_COS"), LEAST_COS as f32);
    let gather = module(&SHADERS[0]);
    assert_eq!(constant(&gather, "COINCIDENT"), COINCIDENT as f32);
    let length = array_length(&gather, "texels");
    assert_eq!(length, Some(UNIFORM_TEXELS as u32));
}
