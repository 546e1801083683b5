//! Measures real-time indirect-illumination estimators: bench, render, probe, reference,
//! compare, verify.
//!
//! [`run`] is the whole program: hand it a registry with methods of your own and they get the
//! command line, the comparison and the report. It prints, and has no other effect on the process:
//! [`restart_without_driver_chatter`] and [`memory::count_with`] are for `main` to call.
//!
//! Layers, each of which knows those before it alone: [`domain`] (records, metrics, significance, analysis),
//! [`running`] (measuring), [`presenting`] (tables, images, reports), and the command line.

pub mod command_line;
pub mod domain;
pub mod presenting;
pub mod running;

pub use command_line::restart::restart_without_driver_chatter;
pub use command_line::{run, run_with};
/// What `verify` checks, and how a program adds checks of its own.
pub use interreflect_conformance::verify;

/// What a method of another crate is written with.
pub use interreflect_estimators::{
    Entry, Registry, averaging, bytemuck, convolution, glam, leaves, lobes, prelude, reflection,
    texels, wgpu,
};

pub use domain::{analysis, image, machine, metrics, record};
pub use presenting::{output, report};
pub use running::memory::CountingAllocator;
pub use running::{clock, frames, measure, memory, on_backend, reproduce, truth, view};
