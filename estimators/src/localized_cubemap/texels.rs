//! The few texels that shading sums over, and how they are made from captures.

use super::math::{disc_area, texel_omega_shader, texel_omega_text};
use super::params::{LocalizedCubemapParams, SolidAngle};
use crate::averaging::{covered, mean_radiance};
use glam::{DVec3, Vec3};
use interreflect_scene::CubeImage;
use interreflect_scene::conventions::{
    CUBE_FACES, cube_vector, texel_centre, texel_index, texel_solid_angle_sr,
};
use interreflect_scene::params::Fidelity;

/// One texel, as both backends read it: three vectors of four `f32`s.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct Texel {
    /// Unit direction from the reference point.
    pub direction: [f32; 3],
    /// w = 1/d in 1/m; 0 at infinity.
    pub inverse_distance: f32,
    /// Mean radiance.
    pub radiance: [f32; 3],
    /// `published`: Δω' in sr. `corrected`: A/d², the disc's area over d².
    pub extent: f32,
    /// Unit normal of the surface; `corrected` only.
    pub normal: [f32; 3],
    /// Nothing; keeps the layout.
    pub pad: f32,
}

/// Distances below this count as this, so that 1/d stays finite.
pub(super) const NEAREST_M: f32 = 1e-30;

/// Smallest cosine that a disc's area is divided by: only a surface seen edge-on is nearer to 0.
pub(super) const EDGE_ON: f64 = 1e-6;

/// Averages the captures down to the texels of `params`, in the order of texel indices.
///
/// `omegas_sr`: solid angles of the captured texels of a face; `corrected` only. A cube without
/// distances is at infinity.
pub(super) fn texels(
    params: &LocalizedCubemapParams,
    omegas_sr: &[f32],
    captured: &CubeImage,
) -> Vec<Texel> {
    let m = params.resolution;
    let mut texels = Vec::with_capacity(CUBE_FACES * (m * m) as usize);
    for face in 0..CUBE_FACES {
        for row in 0..m {
            for column in 0..m {
                texels.push(match params.fidelity {
                    Fidelity::Published => published(params, captured, face, column, row),
                    Fidelity::Corrected => {
                        let radiance = mean_radiance(captured, omegas_sr, m, face, column, row);
                        corrected(radiance, m, captured, face, column, row)
                    }
                });
            }
        }
    }
    texels
}

/// Length of L and its direction for a texel of M×M.
fn ray(m: u32, face: usize, column: u32, row: u32) -> (f64, DVec3) {
    let l = cube_vector(face, texel_centre(m, column), texel_centre(m, row));
    (l.length(), l.normalize())
}

fn published(
    params: &LocalizedCubemapParams,
    captured: &CubeImage,
    face: usize,
    column: u32,
    row: u32,
) -> Texel {
    let m = params.resolution;
    let (l, direction) = ray(m, face, column, row);
    let mut radiance = DVec3::ZERO;
    let (mut distance, mut met) = (0.0, 0_u32);
    let mut count = 0_u32;
    for (_, index) in covered(m, captured.size, face, column, row) {
        radiance += captured.radiance[index].as_dvec3();
        count += 1;
        if let Some(d) = captured.distance.get(index).filter(|d| d.is_finite()) {
            distance += f64::from(*d);
            met += 1;
        }
    }
    // A texel that is mostly open has no place: it stays at infinity.
    let inverse_distance = if 2 * met < count.max(1) || met == 0 {
        0.0
    } else {
        1.0 / ((distance / f64::from(met)) as f32).max(NEAREST_M)
    };
    let omega = match params.solid_angle {
        SolidAngle::Text => texel_omega_text(f64::from(m), l),
        SolidAngle::Shader => texel_omega_shader(f64::from(m), l),
    };
    Texel {
        direction: direction.as_vec3().to_array(),
        inverse_distance,
        radiance: (radiance / f64::from(count)).as_vec3().to_array(),
        extent: omega as f32,
        ..Texel::default()
    }
}

fn corrected(
    radiance: Vec3,
    m: u32,
    captured: &CubeImage,
    face: usize,
    column: u32,
    row: u32,
) -> Texel {
    let (_, direction) = ray(m, face, column, row);
    let near = middle(m, captured.size, face, column, row);
    let (inverse_distance, normal) = match captured.distance.get(near.index) {
        Some(d) if d.is_finite() => {
            let normal = captured.normal[near.index];
            let d = distance_along(direction, near.direction, *d, normal);
            (1.0 / d.max(NEAREST_M), normal)
        }
        _ => (0.0, -direction.as_vec3()),
    };
    let cos_reference = (-normal.as_dvec3().dot(direction)).max(EDGE_ON);
    Texel {
        direction: direction.as_vec3().to_array(),
        inverse_distance,
        radiance: radiance.to_array(),
        extent: disc_area(texel_solid_angle_sr(m, column, row), cos_reference) as f32,
        normal: normal.to_array(),
        ..Texel::default()
    }
}

/// A captured texel.
struct Captured {
    index: usize,
    direction: DVec3,
}

/// The captured texel at the middle of one of the M×M texels; of the four around it, where their
/// number is even, the one of the smallest column and row. A fixed choice: on an edge of the scene
/// that the middle ray meets exactly, both backends then take the same side.
fn middle(m: u32, size: u32, face: usize, column: u32, row: u32) -> Captured {
    let step = size / m;
    let at = |i: u32| i * step + (step - 1) / 2;
    let (c, r) = (at(column), at(row));
    Captured {
        index: texel_index(size, face, c, r),
        direction: cube_vector(face, texel_centre(size, c), texel_centre(size, r)).normalize(),
    }
}

/// Distance at which the ray along `direction` meets the plane that a neighbouring ray, along
/// `near`, met at distance `d`; d itself where the plane is almost edge-on to either.
fn distance_along(direction: DVec3, near: DVec3, d: f32, normal: Vec3) -> f32 {
    let normal = normal.as_dvec3();
    let (at_near, at_direction) = (-normal.dot(near), -normal.dot(direction));
    if at_near < 2.0 * at_direction && at_direction < 2.0 * at_near {
        (f64::from(d) * (at_near / at_direction)) as f32
    } else {
        d
    }
}
