use super::super::tables::{ANGLES, SOLID_ANGLES};
use super::{Lobes, SHADE};
use interreflect_gpu::layout::{assert_layout, constant_u32, module};

#[test]
fn structs_have_the_same_layout() {
    for shader in SHADE {
        assert_layout!(shader, Lobes, [shininess, count, pad]);
    }
}

#[test]
fn tables_have_the_same_shape() {
    let shade = module(&SHADE[0]);
    assert_eq!(constant_u32(&shade, "ANGLES"), ANGLES as u32);
    assert_eq!(constant_u32(&shade, "SOLID_ANGLES"), SOLID_ANGLES as u32);
}
