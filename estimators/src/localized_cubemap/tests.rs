use super::super::tables::{ANGLES, SOLID_ANGLES, Tables};
use super::{Lobes, SHADE};
use glam::DVec3;
use interreflect_gpu::layout::{assert_layout, constant_u32, module};
use std::f64::consts::TAU;

#[test]
fn structs_have_the_same_layout() {
    for shader in SHADE {
        assert_layout!(shader, Lobes, [shininess, count, pad]);
    }
}

#[test]
fn tables_have_the_same_shape() {
    let shade = module(&SHADE[0]);
    assert_eq!(constant_u32(&shade, "ANGLES"), ANGLES as u32);
    assert_eq!(constant_u32(&shade, "SOLID_ANGLES"), SOLID_ANGLES as u32);
}

/// Mean of ((n·h)⁺)ⁿ over the directions of a cap of solid angle `omega` around +z, by polar rings; `of` says
/// where a direction leads, and n lies `theta` from +z.
fn mean_over_cap(theta: f64, omega: f64, exponent: f64, of: impl Fn(DVec3) -> DVec3) -> f64 {
    const RINGS: u32 = 400;
    const AROUND: u32 = 200;
    let n = DVec3::new(theta.sin(), 0.0, theta.cos());
    let lowest = 1.0 - omega / TAU;
    let mut sum = 0.0;
    for ring in 0..RINGS {
        // Rings of equal solid angle.
        let z = 1.0 - (f64::from(ring) + 0.5) / f64::from(RINGS) * (1.0 - lowest);
        let r = (1.0 - z * z).sqrt();
        for k in 0..AROUND {
            let (sin, cos) = ((f64::from(k) + 0.5) / f64::from(AROUND) * TAU).sin_cos();
            let h = of(DVec3::new(r * cos, r * sin, z));
            sum += n.dot(h).max(0.0).powf(exponent);
        }
    }
    sum / f64::from(RINGS * AROUND)
}

/// The table of the cosine holds means over the texel's cap; those of the lobes over the half vectors that it
/// makes with a viewer in its middle: half as far from the axis each. Each lobe has the table of its own
/// exponent. Up to the bilinear table and cap_mean's midpoint rule, a few thousandths; a half vector's
/// density differs from a cap's by cos(α/2), under a hundredth here.
#[test]
fn tables_hold_means_over_the_cap_and_over_its_half_vectors() {
    let exponents = [3.0_f32, 20.0, 90.0];
    let tables = Tables::new(exponents.to_vec());
    for omega in [0.05, 0.2, 0.5] {
        for theta in [0.0_f64, 0.1, 0.3] {
            let cosine = tables.averaged_over(0.0, theta.cos(), omega);
            let exact = mean_over_cap(theta, omega, 1.0, |w| w);
            assert!(
                (cosine - exact).abs() < 4e-3,
                "{omega} {theta}: {cosine} {exact}"
            );
            for exponent in exponents {
                let exponent = f64::from(exponent);
                let table = tables.of_lobe(exponent);
                let found = tables.averaged_over(table, theta.cos(), omega);
                let half = |w: DVec3| (w + DVec3::Z).normalize();
                let exact = mean_over_cap(theta, omega, exponent, half);
                assert!(
                    (found - exact).abs() < 0.012,
                    "{exponent} over {omega} sr at {theta}: {found} {exact}"
                );
            }
        }
    }
    // In the order of the exponents, after the cosine's.
    assert_eq!(
        [3.0, 20.0, 90.0].map(|e| tables.of_lobe(e)),
        [1.0, 2.0, 3.0]
    );
    assert_eq!(Tables::new(Vec::new()).of_lobe(7.0), 0.0);
}
