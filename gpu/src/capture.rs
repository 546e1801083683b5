//! Captures by rasterisation.

pub(crate) mod cube;
pub(crate) mod directional_depth;
pub(crate) mod raster;
pub(crate) mod rsm;
pub(crate) mod shadow;
