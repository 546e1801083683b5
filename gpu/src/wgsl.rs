//! Parts that shaders share; list them before the parts that use them.

/// π, 2π and 1/π.
pub const MATH: &str = include_str!("wgsl/math.wgsl");

/// `cube_vector`, `cube_coordinates` and texel geometry, as in `interreflect_scene::conventions`.
pub const CUBE: &str = include_str!("wgsl/cube.wgsl");

/// Points in slots 0 and 1, the estimate in slot 2, and the functions that read and write them;
/// the shader's own bindings start at slot 3.
pub const POINTS: &str = include_str!("wgsl/points.wgsl");

/// Lights, and what arrives from them: `incident`, as `interreflect_scene::Light::incident`; needs
/// [`MATH`].
pub const LIGHTS: &str = include_str!("wgsl/lights.wgsl");

/// What a surface in a light's view is made of: `TrueColors`, as
/// `interreflect_scene::TrueColors`.
pub const TRUE_COLORS: &str = include_str!("wgsl/true_colors.wgsl");

/// Lookup in a latitude–longitude image, as `interreflect_scene::LatLongImage::sample`; needs
/// [`MATH`].
pub const LAT_LONG: &str = include_str!("wgsl/lat_long.wgsl");

/// Orthographic frames along directions, as `interreflect_scene::DirectionalFrame`.
pub const DIRECTIONAL: &str = include_str!("wgsl/directional.wgsl");
