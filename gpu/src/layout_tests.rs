//! Every shader is valid, and what Rust and WGSL both know is the same. No GPU is needed.
#![allow(clippy::unwrap_used, reason = "tests")]

use crate::capture::cube::Capture;
use crate::capture::{directional_depth, rsm};
use crate::coarse::Grid;
use crate::layout::{constant_u32 as constant, layout, module};
use crate::lights::{GpuLight, LightList, MAX_LIGHTS, kind};
use crate::points::PointsInfo;
use crate::rsm::GpuTrueColors;
use crate::scene::GpuMaterial;
use crate::{Shader, capture, shaders, validate, wgsl};
use interreflect_scene::{Estimate, LANES, PointLayout, conventions};
use std::mem::offset_of;

/// The shared parts that no shader of this crate includes, with an entry point that needs them.
const POINTS: Shader = Shader {
    label: "points",
    parts: &[
        wgsl::MATH,
        wgsl::CUBE,
        wgsl::POINTS,
        "@compute @workgroup_size(64) fn f() { write_estimate(0, vec3f(0)); }",
    ],
};

/// Checks a Rust struct against the WGSL struct of a name; members called `pad…` are Rust's alone.
macro_rules! assert_layout {
    ($module:expr, $name:expr, $rust:ty, [$($member:ident),*]) => {
        let expected = vec![$((stringify!($member).to_owned(), offset_of!($rust, $member))),*];
        assert_eq!(layout($module, $name), (size_of::<$rust>(), expected), "{}", $name);
    };
}

#[test]
fn every_shader_is_valid() {
    for shader in shaders().into_iter().chain([POINTS]) {
        assert_eq!(validate(&shader), Ok(()), "{}", shader.label);
    }
}

#[test]
fn labels_are_unique() {
    let mut labels: Vec<_> = shaders().map(|s| s.label).to_vec();
    labels.sort_unstable();
    labels.dedup();
    assert_eq!(labels.len(), shaders().len());
}

#[test]
fn an_invalid_shader_says_where() {
    let broken = Shader {
        label: "broken",
        parts: &["fn f() -> f32 { return 1; }", "fn g() { nothing(); }"],
    };
    let reason = validate(&broken).unwrap_err();
    assert!(
        reason.contains("nothing") && reason.contains("broken:2"),
        "{reason}"
    );
}

#[test]
fn planes_of_points_are_the_same() {
    let module = module(&POINTS);
    for (name, value) in [
        ("LANES", LANES),
        ("POSITION", PointLayout::POSITION),
        ("NORMAL", PointLayout::NORMAL),
        ("MASK", PointLayout::MASK),
        ("VIEW", PointLayout::VIEW),
        ("DIFFUSE", PointLayout::DIFFUSE),
        ("SPECULAR", PointLayout::SPECULAR),
        ("SHININESS", PointLayout::SHININESS),
        ("FOOTPRINT", PointLayout::FOOTPRINT),
        ("ESTIMATE_PLANES", Estimate::PLANES),
        ("CUBE_FACES", conventions::CUBE_FACES),
    ] {
        assert_eq!(constant(&module, name) as usize, value, "{name}");
    }
}

#[test]
fn kinds_and_numbers_of_lights_are_the_same() {
    let module = module(&capture::cube::SHADER);
    for (name, value) in [
        ("LIGHT_POINT", kind::POINT),
        ("LIGHT_CONE", kind::CONE),
        ("LIGHT_SQUARE", kind::SQUARE),
        ("LIGHT_DIRECTIONAL", kind::DIRECTIONAL),
        ("LIGHT_AREA", kind::AREA),
        ("MAX_LIGHTS", MAX_LIGHTS as u32),
        ("SHADOW_SIZE", capture::shadow::SHADOW_SIZE),
    ] {
        assert_eq!(constant(&module, name), value, "{name}");
    }
}

#[test]
fn structs_have_the_same_layout() {
    let capture = module(&capture::cube::SHADER);
    assert_layout!(
        &capture,
        "Light",
        GpuLight,
        [position, kind, axis, limit, up, first_layer, power]
    );
    assert_layout!(&capture, "Lights", LightList, [lights, count, near]);
    assert_layout!(
        &capture,
        "Material",
        GpuMaterial,
        [albedo, shininess, emission, mirror, specular]
    );
    let views = module(&rsm::SHADER);
    assert_layout!(
        &views,
        "Frame",
        rsm::Frame,
        [
            origin,
            light,
            axis,
            half_extent,
            right,
            orthographic,
            down,
            near
        ]
    );
    assert_layout!(
        &views,
        "Views",
        rsm::Views,
        [size, channels, triangles, ray_start, pixels]
    );
    assert_layout!(
        &views,
        "TrueColors",
        GpuTrueColors,
        [diffuse, shininess, specular, irradiance, to_light]
    );
    assert_layout!(&capture, "Grid", Grid, [first, cells]);
    let depths = module(&directional_depth::SHADER);
    assert_layout!(
        &depths,
        "Frame",
        directional_depth::Frame,
        [right, up, towards]
    );
    assert_layout!(
        &depths,
        "Frames",
        directional_depth::Frames,
        [centre, radius, frames]
    );
    let at_once = constant(&depths, "DEPTH_MAPS_AT_ONCE");
    assert_eq!(at_once, directional_depth::DEPTH_MAPS_AT_ONCE);
    assert_layout!(
        &capture,
        "Capture",
        Capture,
        [origin, size, near, environment_scale, environment_turn]
    );
    assert_layout!(&module(&POINTS), "PointsInfo", PointsInfo, [count, planes]);
}
