//! Captures by rasterisation.

pub(crate) mod cube;
pub(crate) mod directional_depth;
pub(crate) mod light_view;
pub(crate) mod raster;
pub(crate) mod shadow;
