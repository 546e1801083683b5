//! Parameters that several methods declare alike.

use interreflect_scene::params::{Field, Params};

/// `resolution`: texels along a face's edge that shading sums over.
pub(crate) fn resolution<P: Params>(get: fn(&P) -> u32, set: fn(&mut P, u32)) -> Field<P> {
    let doc = "texels along a face's edge that shading sums over";
    Field::u32("resolution", doc, 1..=64, get, set)
        .symbol("M")
        .unit("texels")
        .log()
}

/// `capture_resolution`: texels along a face's edge when the environment is captured.
pub(crate) fn capture_resolution<P: Params>(get: fn(&P) -> u32, set: fn(&mut P, u32)) -> Field<P> {
    let doc = "texels along a face's edge when the environment is captured";
    Field::u32("capture_resolution", doc, 1..=1024, get, set)
        .unit("texels")
        .log()
}

/// `bounces`: reflections that captured radiance holds beyond that of the lights' light.
pub(crate) fn bounces<P: Params>(get: fn(&P) -> u32, set: fn(&mut P, u32)) -> Field<P> {
    let doc = "reflections in the captured radiance beyond that of the lights' light, from a \
               coarse solution at the vertices";
    Field::u32("bounces", doc, 0..=8, get, set)
}
