//! What every registered method must satisfy, one named trial each.
//!
//! Trials that need a device show as ignored, with the reason, where there is none; with
//! `INTERREFLECT_REQUIRE_GPU=1` they then fail.

mod bounces;
mod brief;
mod costs;
mod direct_light;
mod environment_maps;
mod errata;
mod extremes;
mod form_factors;
mod frames;
mod leaf_parity;
mod moved;
mod neighbours;
mod openness;
mod parity;
mod parity_views;
mod path_reference;
mod precision_parity;
mod radiance_maps;
mod room;
mod room_points;
mod rules;
mod shaders;
mod test_scenes;
mod variants;
mod verify;
mod visibility;

use libtest_mimic::{Arguments, Trial};

fn main() {
    let arguments = Arguments::from_args();
    let trials: Vec<Trial> = [
        vec![Trial::test(
            "messages_fit_a_screen",
            brief::messages_fit_a_screen,
        )],
        shaders::trials(),
        leaf_parity::trials(),
        rules::trials(),
        verify::trials(),
        extremes::trials(),
        costs::trials(),
        parity::trials(),
        precision_parity::trials(),
        moved::trials(),
        neighbours::trials(),
        frames::trials(),
        bounces::trials(),
        errata::trials(),
        form_factors::trials(),
        direct_light::trials(),
        radiance_maps::trials(),
        environment_maps::trials(),
        openness::trials(),
        visibility::trials(),
        path_reference::trials(),
        room::trials(),
    ]
    .into_iter()
    .flatten()
    .collect();
    libtest_mimic::run(&arguments, trials).exit();
}

/// Fails with a message, of a screen at most, unless the condition holds.
macro_rules! ensure {
    ($condition:expr, $($message:tt)*) => {
        let holds: bool = $condition;
        if !holds {
            return Err($crate::brief::brief(&format!($($message)*)).into());
        }
    };
}
pub(crate) use ensure;
