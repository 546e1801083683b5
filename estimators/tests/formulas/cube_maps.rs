//! Texels of localized cube maps, as discs and as points, and what depth maps hide.

use crate::{integral, near, vector, within};
use interreflect_estimators::{
    direct_radiance_map, directional_ao, localized_cubemap, point_form_factor, texels,
};
use interreflect_scene::conventions::{CUBE_FACES, cube_vector, texel_centre};
use std::f64::consts::{FRAC_1_SQRT_2, PI};

/// SPEC, P1: what the paper's solid angles sum to, of 4π.
#[test]
fn the_paper_s_solid_angles_sum_to_what_they_are_known_to() {
    use localized_cubemap::math::{texel_omega_shader, texel_omega_text};
    let share = |m: u32, omega: fn(f64, f64) -> f64| {
        let mut sum = 0.0;
        for face in 0..CUBE_FACES {
            for (row, column) in (0..m).flat_map(|r| (0..m).map(move |c| (r, c))) {
                let l = cube_vector(face, texel_centre(m, column), texel_centre(m, row));
                sum += omega(f64::from(m), l.length());
            }
        }
        sum / (4.0 * PI)
    };
    for (m, expected) in [(1, 0.840), (2, 0.886), (4, 0.969), (8, 0.992)] {
        let found = share(m, texel_omega_text);
        assert!((found - expected).abs() < 6e-4, "M = {m}: {found}");
    }
    let found = share(64, texel_omega_shader);
    assert!((found - 1.221).abs() < 2e-3, "{found}");
    // One texel straight ahead: 4/(1 + 4/π) for M = 1.
    near(texel_omega_text(1.0, 1.0), 4.0 / (1.0 + 4.0 / PI));
    near(texel_omega_shader(2.0, 1.5), 4.0 / (9.0 + 4.0 / PI));
    near(texel_omega_text(2.0, 1.5), 4.0 / (13.5 + 4.0 / PI));
}

/// A disc of radius R at distance d seen head-on counts πR²/(R² + d²) of the cosine-weighted sphere: the
/// one formula behind all solid angles of P1, inverted at d and applied at r.
#[test]
fn discs_subtend_their_solid_angles_from_near_and_far() {
    use direct_radiance_map::math as photons;
    use localized_cubemap::math::{disc_area, omega_corrected, omega_published};
    let disc = |radius: f64, distance: f64| {
        let sin2 = radius * radius / (radius * radius + distance * distance);
        // What a disc of half-angle asin(√sin2) around the normal gives: ∫cos dω.
        within(
            integral([0.0, sin2.sqrt().asin()], |w| w.z),
            PI * sin2,
            1e-5,
        );
        PI * sin2
    };
    for (radius, d, r) in [(0.5, 2.0, 1.0), (0.3, 1.0, 4.0), (1.0, 1.0, 1.0)] {
        let (at_d, at_r) = (disc(radius, d), disc(radius, r));
        let r2 = (r / d).powi(2);
        near(omega_published(at_d, r2), at_r);
        let area = PI * radius * radius;
        near(disc_area(at_d), area / (d * d));
        near(omega_corrected(area / (d * d), r2, 1.0), at_r);
        near(photons::omega_corrected(area, r * r, 1.0), at_r);
        // Turned by 60° a disc is one of half the area.
        let smaller = disc(radius * FRAC_1_SQRT_2, r);
        near(omega_corrected(area / (d * d), r2, 0.5), smaller);
        near(photons::omega_corrected(area, r * r, 0.5), smaller);
        assert_eq!(omega_corrected(area, r2, -0.5), 0.0);
        assert_eq!(photons::omega_corrected(area, r * r, -0.5), 0.0);
    }
}

#[test]
fn the_published_reflectivity_is_a_cosine_and_a_power_of_another() {
    use localized_cubemap::math::reflectivity_published;
    let (diffuse, specular) = reflectivity_published(0.25, 0.1, 0.5, 3.0);
    near(diffuse, 0.25);
    within(specular, 0.125, 1e-9);
    for (n_i, n_v) in [(-0.25, 0.1), (0.25, -0.1), (0.0, 0.1), (0.25, 0.0)] {
        assert_eq!(reflectivity_published(n_i, n_v, 0.5, 3.0), (0.0, 0.0));
    }
}

/// ⁴√((1 − cos θ)/2) and √(Δω/π): a half each at a sixteenth and a quarter.
#[test]
fn tables_are_read_by_a_fourth_root_and_a_square_root() {
    use localized_cubemap::math::table_place;
    for (cos_theta, omega, first, second) in [
        (1.0, 0.0, 0.0, 0.0),
        (-1.0, PI, 1.0, 1.0),
        (1.0 - 2.0 / 16.0, PI / 4.0, 0.5, 0.5),
        (1.0 - 2.0 / 10_000.0, PI / 100.0, 0.1, 0.1),
        (0.0, 2.0 * PI, 0.5_f64.powf(0.25), 1.0),
    ] {
        let (a, b) = table_place(cos_theta, omega);
        within(a, first, 1e-9);
        within(b, second, 1e-9);
    }
}

#[test]
fn a_point_s_solid_angle_falls_by_the_square_and_is_held() {
    use point_form_factor::math::point_omega;
    near(point_omega(2.0, 4.0, 0.5, 9.0), 0.25);
    near(point_omega(2.0, 0.01, 0.5, 9.0), 9.0);
    assert_eq!(point_omega(2.0, 4.0, -0.5, 9.0), 0.0);
}

/// R = direction − w·x: 2 m ahead of o, seen from 1 m to the side, and at infinity from anywhere.
#[test]
fn a_texel_s_place_is_seen_from_the_point() {
    use texels::math::towards_texel;
    let (towards, r2) = towards_texel(vector(0.0, 0.0, 1.0), 0.5, vector(1.0, 0.0, 0.0));
    // (y − x)/d = (−1, 0, 2)/2.
    near(r2, 1.25);
    near(towards.x, -1.0 / 5_f64.sqrt());
    near(towards.z, 2.0 / 5_f64.sqrt());
    let (towards, r2) = towards_texel(vector(0.0, 0.0, 1.0), 0.0, vector(7.0, 8.0, 9.0));
    near(r2, 1.0);
    near(towards.z, 1.0);
}

/// A depth passes up to the map's plus the margin, and some roundings of float32.
#[test]
fn what_lies_behind_the_map_is_hidden() {
    use directional_ao::math::{open_cosine, passes};
    assert_eq!(passes(0.25, 0.5, 0.0), 1.0);
    assert_eq!(passes(0.5, 0.5, 0.0), 1.0);
    assert_eq!(passes(0.5001, 0.5, 0.0), 0.0);
    assert_eq!(passes(0.55, 0.5, 0.1), 1.0);
    assert_eq!(passes(0.65, 0.5, 0.1), 0.0);
    for least in [0.0, -1.0] {
        near(open_cosine(0.5, 1.0, least), 0.5);
        near(open_cosine(0.5, 0.0, least), 0.0);
        near(open_cosine(-0.5, 0.0, least), 0.0);
    }
    near(open_cosine(-0.5, 1.0, 0.0), 0.0);
    near(open_cosine(-0.5, 1.0, -1.0), -0.5);
}
