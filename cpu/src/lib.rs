//! The CPU backend: rays, captures, path tracer, tiles and SIMD dispatch.
