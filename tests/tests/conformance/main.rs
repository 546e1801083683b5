//! What every registered method must satisfy, one named trial each.
//!
//! Trials that need a device show as ignored, with the reason, where there is none; with
//! `INTERREFLECT_REQUIRE_GPU=1` they then fail.

mod bits;
mod environment_maps;
mod errata;
mod needs;
mod parity;
mod path_reference;
mod room;
mod room_ties;
mod shaders;
mod subjects;
mod twins;
mod world;

use libtest_mimic::{Arguments, Trial};

fn main() {
    let arguments = Arguments::from_args();
    let trials: Vec<Trial> = [
        shaders::trials(),
        twins::trials(),
        needs::trials(),
        bits::trials(),
        parity::trials(),
        errata::trials(),
        environment_maps::trials(),
        path_reference::trials(),
        room::trials(),
        room_ties::trials(),
    ]
    .into_iter()
    .flatten()
    .collect();
    libtest_mimic::run(&arguments, trials).exit();
}

/// Fails with a message unless the condition holds.
macro_rules! ensure {
    ($condition:expr, $($message:tt)*) => {
        let holds: bool = $condition;
        if !holds {
            return Err(format!($($message)*).into());
        }
    };
}
pub(crate) use ensure;
