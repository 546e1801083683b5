//! The report in a browser: a page of three runs is opened from a file and used as people would.
//!
//! Shown as ignored where no Chromium or Chrome is found; INTERREFLECT_REQUIRE_BROWSER=1 makes that a
//! failure. CHROME names a browser that is not in PATH.
#![allow(clippy::unwrap_used, reason = "tests")]

mod browser;
mod checks;
mod sample;

use browser::in_page;
use libtest_mimic::{Arguments, Trial};
use std::process::ExitCode;

/// What is tried, each in a tab of its own.
const CHECKS: [(&str, browser::Check); 11] = [
    ("the_exposure_slider_changes_the_image", checks::exposure),
    ("the_split_moves_by_slider_and_by_pointer", checks::split),
    ("a_point_of_the_plot_opens_its_image", checks::plot_point),
    ("a_link_to_a_run_opens_its_image", checks::link),
    ("keys_flip_between_images", checks::keys),
    ("the_pixel_under_the_pointer_is_read_out", checks::read_out),
    (
        "error_maps_have_a_colour_bar_that_scales",
        checks::error_maps,
    ),
    ("dark_mode_has_other_colours", checks::dark),
    ("a_phone_scrolls_in_one_direction_only", checks::phone),
    ("two_fingers_magnify", checks::pinch),
    ("pixels_are_exposed_and_errors_coloured", checks::pixels),
];

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let required = std::env::var_os("INTERREFLECT_REQUIRE_BROWSER").is_some();
    let missing = browser::config(&std::env::temp_dir()).is_err() && !required;
    let trials = CHECKS.into_iter().map(|(name, check)| {
        let trial = Trial::test(name, move || in_page(check));
        trial.with_ignored_flag(missing)
    });
    if missing {
        eprintln!("no Chromium or Chrome in PATH: the report's page is not tried");
    }
    libtest_mimic::run(&arguments, trials.collect()).exit_code()
}
