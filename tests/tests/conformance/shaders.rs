//! Every shader is valid. No device is needed.

use crate::ensure;
use interreflect_estimators::Registry;
use interreflect_gpu::{Shader, validate};
use libtest_mimic::Trial;
use std::collections::BTreeMap;

pub(crate) fn trials() -> Vec<Trial> {
    let own = interreflect_gpu::shaders();
    let registry = Registry::builtin();
    let of_methods = registry.entries().iter().flat_map(|e| e.shaders());
    // Methods share some: each is one trial.
    let each: BTreeMap<_, _> = own
        .iter()
        .chain(of_methods)
        .map(|s| (s.label, *s))
        .collect();
    each.into_values().map(valid).collect()
}

fn valid(shader: Shader) -> Trial {
    let name = format!("shaders/{}", shader.label);
    Trial::test(name, move || {
        let parts = shader.parts.iter().all(|p| p.ends_with('\n'));
        ensure!(
            parts,
            "a part does not end with a newline: lines in messages would be off"
        );
        Ok(validate(&shader)?)
    })
}
