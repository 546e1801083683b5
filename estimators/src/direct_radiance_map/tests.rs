#![allow(clippy::unwrap_used, reason = "tests")]

use super::math::{
    area_across, equal_angle_texel, hemisphere_share, lit_area, omega_corrected, omega_far,
    omega_published,
};
use super::samples::{photons, samples};
use super::{DirectRadianceMap, Method, Quantity, SolidAngle, Surface, TexelOf};
use interreflect_scene::params::Fidelity;
use interreflect_scene::{Bounds, Light, RsmImage, RsmViews, SceneFacts, SpotShape, Surroundings};
use std::f64::consts::PI;

/// With exact areas the flux of a texel is what the light sends into it: A·L = ρ·I·Δω/π, whatever
/// the distance and the tilt.
#[test]
fn flux_does_not_depend_on_distance_or_tilt() {
    let (albedo, intensity, omega_sr) = (0.7, 2.5, 0.03);
    for b in [1e-3, 0.2, 1.0, 50.0] {
        for cos_light in [1e-3, 0.1, 0.5, 1.0] {
            let radiance = albedo / PI * intensity * cos_light / (b * b);
            let flux = radiance * lit_area(area_across(omega_sr, b), cos_light);
            let expected = albedo * intensity * omega_sr / PI;
            assert!((flux / expected - 1.0).abs() < 1e-12, "{b} {cos_light}");
        }
    }
}

/// Eq 12 takes texels to be equal in angle: over a view of 90° their solid angles sum to 17.8 % too
/// much at w = 3 · · · ∞ approaches (π/2)²; a corner texel has 3.2 times too much, a middle one .62.
#[test]
fn equal_angle_texels_do_not_fill_the_view() {
    let light = Light::Point {
        position: glam::Vec3::ZERO,
        intensity: glam::Vec3::ONE,
        picture: None,
    };
    let frame = light.frames(0, &Surroundings::default(), RsmViews::Surround)[0];
    let w = 256;
    let texel = equal_angle_texel(frame.full_angle(), w);
    let total = texel * f64::from(w * w) / (2.0 * PI / 3.0);
    assert!((total - 1.178).abs() < 1e-3, "{total}");
    let against = |column, row| texel / frame.cell_measure(w, column, row);
    let (corner, middle) = (against(0, 0), against(w / 2, w / 2));
    assert!((corner - 3.2).abs() < 0.05, "{corner}");
    assert!((middle - 0.617).abs() < 1e-3, "{middle}");
}

#[test]
fn solid_angles_stay_within_their_bounds() {
    for area in [0.0, 1e-6, 1.0, 1e6] {
        for r2 in [0.0, 1e-12, 1.0, 1e6] {
            for cos_surface in [-1.0, 0.0, 1e-3, 1.0] {
                let published = omega_published(area, r2, cos_surface);
                let corrected = omega_corrected(area, r2, cos_surface);
                assert!(
                    (0.0..=1.0).contains(&published),
                    "{area} {r2} {cos_surface}"
                );
                assert!(
                    (0.0..=PI + 1e-12).contains(&corrected),
                    "{area} {r2} {cos_surface}"
                );
                if cos_surface <= 0.0 {
                    assert_eq!((published, corrected), (0.0, 0.0));
                }
            }
        }
    }
    assert!((omega_far(3.0_f64, 12.0) - 0.25).abs() < 1e-15);
    assert!((hemisphere_share(9) * 9.0 - 2.0 * PI).abs() < 1e-12);
}

/// A grid finer than a texel of the picture, or as fine, meets each texel's middle.
#[test]
fn samples_are_the_texels_at_the_middles_of_cells() {
    let light = Light::Point {
        position: glam::Vec3::ZERO,
        intensity: glam::Vec3::ONE,
        picture: None,
    };
    let frames = light.frames(0, &Surroundings::default(), RsmViews::Surround);
    let params = |w, n, texel| DirectRadianceMap {
        map_resolution: w,
        samples_per_side: n,
        texel,
        ..DirectRadianceMap::default()
    };
    let all = samples(&params(5, 5, TexelOf::Grid), &frames);
    assert!(all.iter().enumerate().all(|(i, s)| s.texel as usize == i));
    let three = samples(&params(16, 3, TexelOf::Grid), &frames);
    let columns: Vec<u32> = three[..3].iter().map(|s| s.texel % 16).collect();
    assert_eq!(columns, [2, 8, 13]);
    // Of the picture's texels 9 of 256 count: about 97 % of the light is lost.
    let of_texture = samples(&params(16, 3, TexelOf::Texture), &frames);
    let kept = of_texture[0].measure / three[0].measure;
    assert!((kept - 9.0 / 256.0).abs() < 4e-3, "{kept}");
}

/// With corrected averages the flux A·L of all photons is that of all texels, ρ·I·Ω/π, however far and tilted
/// the surfaces are; and a dark half is not lit by the other.
#[test]
fn averaged_cells_keep_the_flux() {
    let light = Light::Spot {
        position: glam::Vec3::ZERO,
        direction: glam::Vec3::NEG_Y,
        up: glam::Vec3::Z,
        shape: SpotShape::Square,
        angle_deg: 120.0,
        intensity: glam::Vec3::ONE,
    };
    let frames = light.frames(0, &Surroundings::default(), RsmViews::Surround);
    let params = DirectRadianceMap {
        map_resolution: 20,
        fidelity: Fidelity::Corrected,
        mip: true,
        ..DirectRadianceMap::default()
    };
    let (albedo, size) = (0.6, params.map_resolution);
    for dark_columns in [0, size / 2] {
        let mut views = RsmImage::blank(frames.clone(), Bounds::default(), params.captured());
        let mut expected = 0.0;
        for i in 0..views.texels() {
            let (column, row) = (i as u32 % size, i as u32 / size);
            if column < dark_columns {
                continue;
            }
            let (path, cos_light) = (0.5 + (i % 7) as f32, [0.02, 0.3, 1.0][i % 3]);
            views.path_m[i] = path;
            views.cos_light[i] = cos_light;
            views.normal[i] = glam::Vec3::Y;
            views.position[i] = glam::Vec3::NEG_Y * path;
            let radiance = albedo / PI as f32 * cos_light / (path * path);
            views.radiance[i] = glam::Vec3::splat(radiance);
            expected += f64::from(albedo) / PI * frames[0].cell_measure(size, column, row);
        }
        let (photons, _) = photons(&params, &views);
        let flux = |p: &super::samples::Photon| f64::from(p.extent * p.radiance[0]);
        let found: f64 = photons.iter().map(flux).sum();
        // Where a cell is dark in part, its share is by the middles of texels.
        let bound = if dark_columns == 0 { 1e-5 } else { 0.01 };
        assert!(
            (found / expected - 1.0).abs() < bound,
            "{found} for {expected}"
        );
        assert_eq!(photons.len(), if dark_columns == 0 { 9 } else { 6 });
        // A texel at a grazing angle, of fifty times its cross-section, does not take the cell over.
        let across = frames[0].cell_measure(3, 1, 1) as f32 * 7.0 * 7.0;
        assert!(photons.iter().all(|p| p.extent < 3.0 * across));
    }
}

#[test]
fn needs_are_no_more_than_the_formula_knows() {
    let lit = SceneFacts {
        any_surface: true,
        lights: 1,
        ..SceneFacts::default()
    };
    let channels = |params: &DirectRadianceMap| {
        let needs = super::DirectRadianceMap::needs(params, Quantity::Irradiance, &lit).unwrap();
        needs.rsms.first().unwrap().channels
    };
    for (solid_angle, normal) in [
        (SolidAngle::Eq11, false),
        (SolidAngle::Eq14, true),
        (SolidAngle::Eq15, false),
    ] {
        let params = DirectRadianceMap {
            solid_angle,
            ..DirectRadianceMap::default()
        };
        let found = channels(&params);
        assert!(found.normal == normal && found.radiance && !found.true_colors);
        let shining = DirectRadianceMap {
            surface: Surface::BlinnPhong,
            ..params.clone()
        };
        let found = channels(&shining);
        assert!(found.normal && found.true_colors && !found.radiance);
        let corrected = DirectRadianceMap {
            fidelity: Fidelity::Corrected,
            ..params
        };
        assert!(channels(&corrected).normal);
    }
}

#[test]
fn what_can_not_work_says_why() {
    let reason = |params: &DirectRadianceMap, scene: &SceneFacts| {
        let needs = super::DirectRadianceMap::needs(params, Quantity::Irradiance, scene);
        needs.unwrap_err().to_string()
    };
    let lit = SceneFacts {
        any_surface: true,
        lights: 1,
        ..SceneFacts::default()
    };
    let mut params = DirectRadianceMap::default();
    assert!(reason(&params, &SceneFacts { lights: 0, ..lit }).contains("light"));
    assert!(
        reason(
            &params,
            &SceneFacts {
                any_surface: false,
                ..lit
            }
        )
        .contains("surface")
    );
    params.samples_per_side = 17;
    assert!(reason(&params, &lit).contains("map_resolution to 17"));
}
