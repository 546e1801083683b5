//! Parameters that several methods declare alike.

use interreflect_scene::params::{Field, Params};

/// Most texels along a face's edge that shading sums over.
pub(crate) const MAX_RESOLUTION: u32 = 64;

/// `resolution`: texels along a face's edge that shading sums over.
pub(crate) fn resolution<P: Params>(get: fn(&P) -> u32, set: fn(&mut P, u32)) -> Field<P> {
    let doc = "texels along a face's edge that shading sums over";
    Field::u32("resolution", doc, 1..=MAX_RESOLUTION, get, set)
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

/// `recapture_distance`: how far the reference point may be from where captures were made.
pub(crate) fn recapture_distance<P: Params>(get: fn(&P) -> f32, set: fn(&mut P, f32)) -> Field<P> {
    let doc =
        "captures are kept while the reference point is no farther from theirs; 0: always fresh";
    Field::f32("recapture_distance", doc, 0.0..=1000.0, get, set).unit("m")
}

/// f_λ of `f_lambda` if nothing is said: between glass (0.04) and metals (0.5 to 1).
pub(crate) const F_LAMBDA: f32 = 0.2;

/// `f_lambda`: reflectance at normal incidence in Schlick's Fresnel factor.
pub(crate) fn f_lambda<P: Params>(get: fn(&P) -> f32, set: fn(&mut P, f32)) -> Field<P> {
    let doc =
        "reflectance at normal incidence in Schlick's Fresnel factor, which weighs k_d and k_s";
    Field::f32("f_lambda", doc, 0.0..=1.0, get, set).symbol("f_λ")
}

/// `resolution`: texels along a face's edge that a convolution sums over.
///
/// The range keeps all loops of a shader invocation together below 65,536 turns: lavapipe ends
/// them there without a word.
pub(crate) fn convolution_resolution<P: Params>(
    get: fn(&P) -> u32,
    set: fn(&mut P, u32),
) -> Field<P> {
    let doc = "texels along a face's edge that the convolution sums over";
    Field::u32("resolution", doc, 8..=64, get, set)
        .unit("texels")
        .log()
}

/// `map_resolution`: cells along a face's edge of convolved maps.
pub(crate) fn map_resolution<P: Params>(get: fn(&P) -> u32, set: fn(&mut P, u32)) -> Field<P> {
    let doc = "cells along a face's edge of the convolved maps";
    Field::u32("map_resolution", doc, 1..=256, get, set)
        .unit("cells")
        .log()
}
