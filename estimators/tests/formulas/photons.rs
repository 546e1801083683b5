//! Photons of direct radiance maps.

use crate::{near, vector};
use interreflect_estimators::direct_radiance_map;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, TAU};

/// Lighting by points: eqs 11 to 15 with numbers that need no calculator.
#[test]
fn areas_and_solid_angles_of_photons_follow_the_paper() {
    use direct_radiance_map::math as photons;
    // tan 45° = 1 and tan 30° = 1/√3, doubled and squared.
    near(photons::equal_angle_texel(FRAC_PI_2, 1), 4.0);
    near(photons::equal_angle_texel(4.0 * FRAC_PI_3, 4), 4.0 / 3.0);
    near(photons::hemisphere_share(9), TAU / 9.0);
    near(photons::area_across(0.25, 4.0), 4.0);
    near(photons::lit_area(3.0, 0.5), 6.0);
    near(photons::omega_far(8.0, 4.0), 2.0);
    near(photons::omega_published(3.0, 1.0, 0.5), 0.375);
    assert_eq!(photons::omega_published(3.0, 1.0, -0.5), 0.0);
    let (towards, r2) = photons::towards_photon(vector(1.0, 2.0, 5.0), vector(1.0, 2.0, 3.0));
    near(r2, 4.0);
    near(towards.z, 1.0);
    near(towards.x, 0.0);
    let (here, _) = photons::towards_photon(vector(1.0, 2.0, 3.0), vector(1.0, 2.0, 3.0));
    assert_eq!((here.x, here.y, here.z), (0.0, 0.0, 0.0));
}
