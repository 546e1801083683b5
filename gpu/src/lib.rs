//! The GPU backend: wgpu context, passes, timestamps, read-back and captures.
