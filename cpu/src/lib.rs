//! The CPU backend: rays, captures, path tracer, tiles and SIMD dispatch.

pub mod bvh;
pub mod capture;
pub mod direct;
pub mod lane;
pub mod path_tracer;
pub mod scene;
pub mod tiles;
