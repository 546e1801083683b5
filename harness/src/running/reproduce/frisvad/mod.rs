//! Frisvad, Frisvad, Christensen and Falster, *Direct Radiance Mapping*: each experiment with its claims beside what it
//! runs.

mod back_sides;
mod bleeding;
mod caustic;
mod close_to_the_light;
mod dynamic;
mod flashing;
mod irradiance;
mod materials;
mod mirror_balls;
mod mirrors;
mod number_of_samples;
mod places;
mod rates;
mod rsm;
mod solid_angles;
mod steps;
mod table;
mod traced;

use super::Experiment;

/// In the order of the paper, then what it does not have.
pub(super) const EXPERIMENTS: &[Experiment] = &[
    steps::FIGURE_3,
    solid_angles::EXPERIMENT,
    traced::EXPERIMENT,
    rsm::FIGURE_6,
    close_to_the_light::EXPERIMENT,
    mirror_balls::EXPERIMENT,
    steps::FIGURE_9,
    table::EXPERIMENT,
    number_of_samples::EXPERIMENT,
    back_sides::EXPERIMENT,
    flashing::EXPERIMENT,
    bleeding::CORNELL_BOX,
    bleeding::LANTERN,
    caustic::EXPERIMENT,
    rsm::TEXELS,
    dynamic::EXPERIMENT,
    mirrors::EXPERIMENT,
    materials::EXPERIMENT,
    rates::EXPERIMENT,
];
