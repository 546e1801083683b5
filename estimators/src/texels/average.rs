//! How the few texels are made from captures.

use super::Texel;
use crate::averaging::{covered, face_solid_angles_sr, mean_radiance};
use glam::{DVec3, Vec3};
use interreflect_scene::CubeImage;
use interreflect_scene::conventions::{CUBE_FACES, cube_vector, texel_centre, texel_index};

/// How captured texels become one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Averaging {
    /// Plain means of radiance and distance (P1 §2); averaged distances leave the wall.
    Plain,
    /// Radiance weighted by solid angle; distance of the surface along the ray through the texel's
    /// middle. For what needs no normal: that of one captured texel may be at a grazing angle.
    Middle,
    /// Radiance weighted by solid angle; the place and the normal of the mean plane: depths along the
    /// face's axis by their reciprocals, which keeps a plane where it is, and normals by the area that
    /// the texel sees of each surface. No captured texel stands for its neighbours.
    MeanPlane,
}

/// Distances below this count as this, so that 1/d stays finite.
pub(super) const NEAREST_M: f32 = 1e-30;

/// Smallest cosine that an extent is divided by: only a surface seen edge-on is nearer to 0.
pub(super) const EDGE_ON: f64 = 1e-6;

/// Smallest cosine that a captured texel's solid angle is divided by where normals are averaged: light of
/// all that a texel sees leaves its mean plane, so that a sliver of a surface at a grazing angle, whose area
/// is large, must not turn the plane to itself. Without it rows of texels along such slivers are far too bright.
pub(super) const LEAST_COS: f64 = 0.25;

/// What averaging reads beside the capture; depends on a method's parameters alone.
pub struct Tables {
    /// M: texels along a face's edge.
    pub(super) resolution: u32,
    pub(super) averaging: Averaging,
    /// Solid angles in sr of the captured texels of a face; not for [`Averaging::Plain`].
    pub(super) omegas_sr: Vec<f32>,
    /// The extents of a face's texels.
    pub(super) extents: Vec<f32>,
}

impl Tables {
    /// Tables for `resolution`² texels a face out of a [`super::capture`] of `capture_resolution`².
    ///
    /// `extent` of (column, row) becomes the texel's extent: over the cosine between ray and mean
    /// normal with [`Averaging::MeanPlane`], and as it is with the others.
    pub fn new(
        resolution: u32,
        capture_resolution: u32,
        averaging: Averaging,
        extent: impl Fn(u32, u32) -> f64,
    ) -> Self {
        let texels = (0..resolution * resolution).map(|i| (i % resolution, i / resolution));
        Self {
            resolution,
            averaging,
            omegas_sr: match averaging {
                Averaging::Plain => Vec::new(),
                Averaging::Middle | Averaging::MeanPlane => {
                    face_solid_angles_sr(capture_resolution.next_multiple_of(resolution))
                }
            },
            extents: texels
                .map(|(column, row)| extent(column, row) as f32)
                .collect(),
        }
    }

    /// Averages a capture, in the order of texel indices. A cube without distances is at infinity,
    /// one without normals faces the reference point.
    pub fn average(&self, captured: &CubeImage) -> Vec<Texel> {
        let m = self.resolution;
        let mut texels = Vec::with_capacity(CUBE_FACES * (m * m) as usize);
        for face in 0..CUBE_FACES {
            for row in 0..m {
                for column in 0..m {
                    let at = CubeTexel { face, column, row };
                    texels.push(match self.averaging {
                        Averaging::Plain => self.plain(captured, at),
                        Averaging::Middle => self.middle(captured, at),
                        Averaging::MeanPlane => self.on_mean_plane(captured, at),
                    });
                }
            }
        }
        texels
    }

    fn extent(&self, at: CubeTexel) -> f64 {
        f64::from(self.extents[texel_index(self.resolution, 0, at.column, at.row)])
    }

    fn plain(&self, captured: &CubeImage, at: CubeTexel) -> Texel {
        let m = self.resolution;
        let mut radiance = DVec3::ZERO;
        let (mut distance, mut met) = (0.0, 0_u32);
        let mut count = 0_u32;
        for (_, index) in covered(m, captured.size, at.face, at.column, at.row) {
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
        Texel {
            direction: at.ray(m).as_vec3().to_array(),
            inverse_distance,
            radiance: (radiance / f64::from(count)).as_vec3().to_array(),
            extent: self.extent(at) as f32,
            ..Texel::default()
        }
    }

    fn middle(&self, captured: &CubeImage, at: CubeTexel) -> Texel {
        let m = self.resolution;
        let CubeTexel { face, column, row } = at;
        let direction = at.ray(m);
        let (inverse_distance, _) =
            surface_along(captured, middle(m, captured.size, at), direction);
        Texel {
            direction: direction.as_vec3().to_array(),
            inverse_distance,
            radiance: mean_radiance(captured, &self.omegas_sr, m, face, column, row).to_array(),
            extent: self.extent(at) as f32,
            ..Texel::default()
        }
    }

    fn on_mean_plane(&self, captured: &CubeImage, at: CubeTexel) -> Texel {
        let m = self.resolution;
        let CubeTexel { face, column, row } = at;
        let direction = at.ray(m);
        let (inverse_distance, normal) = self.mean_plane(captured, at);
        let cos_reference = (-normal.dot(direction)).max(EDGE_ON);
        Texel {
            direction: direction.as_vec3().to_array(),
            inverse_distance: inverse_distance as f32,
            radiance: mean_radiance(captured, &self.omegas_sr, m, face, column, row).to_array(),
            extent: (self.extent(at) / cos_reference) as f32,
            normal: normal.as_vec3().to_array(),
            ..Texel::default()
        }
    }

    /// 1/d in 1/m along the texel's middle ray, and the unit normal, of the mean of the surfaces that
    /// the texel sees; 0 and the direction back where it is mostly open.
    ///
    /// On the cube's face, at (a, b, 1), a plane's l/d is linear in a and b: the mean over the texel is
    /// the value at its middle, whatever the plane's tilt. A normal counts by its surface's area, the
    /// solid angle over the cosine, but the latter by [`LEAST_COS`] at least.
    fn mean_plane(&self, captured: &CubeImage, at: CubeTexel) -> (f64, DVec3) {
        let m = self.resolution;
        let back = -at.ray(m);
        let (mut reciprocals, mut met, mut count) = (0.0, 0_u32, 0_u32);
        let mut normals = DVec3::ZERO;
        for (on_face, index) in covered(m, captured.size, at.face, at.column, at.row) {
            count += 1;
            let Some(d) = captured.distance.get(index).filter(|d| d.is_finite()) else {
                continue;
            };
            met += 1;
            let near = CubeTexel::of_face(at.face, captured.size, on_face);
            let ray = near.vector(captured.size);
            reciprocals += ray.length() / f64::from(d.max(NEAREST_M));
            if let Some(normal) = captured.normal.get(index) {
                let cos = -normal.as_dvec3().dot(ray.normalize());
                let omega_sr = f64::from(self.omegas_sr[on_face]);
                normals += normal.as_dvec3() * (omega_sr / cos.max(LEAST_COS));
            }
        }
        // A texel that is mostly open has no place: it stays at infinity.
        if 2 * met < count || met == 0 {
            return (0.0, back);
        }
        let depth = reciprocals / f64::from(met);
        let inverse_distance = depth / at.vector(m).length();
        (inverse_distance, normals.try_normalize().unwrap_or(back))
    }
}

/// A texel of a face.
#[derive(Clone, Copy)]
pub struct CubeTexel {
    /// Index of the face: +x −x +y −y +z −z.
    pub face: usize,
    /// Column on the face.
    pub column: u32,
    /// Row on the face.
    pub row: u32,
}

impl CubeTexel {
    /// Texel `on_face`, counted row by row, of a face of `size`² texels.
    fn of_face(face: usize, size: u32, on_face: usize) -> Self {
        let (column, row) = (on_face as u32 % size, on_face as u32 / size);
        Self { face, column, row }
    }

    /// From the reference point to its middle on the cube of edge 2, whose faces have `size`² texels.
    fn vector(self, size: u32) -> DVec3 {
        let (s, t) = (
            texel_centre(size, self.column),
            texel_centre(size, self.row),
        );
        cube_vector(self.face, s, t)
    }

    /// Unit direction of its middle on a face of `size`² texels.
    pub fn ray(self, size: u32) -> DVec3 {
        self.vector(size).normalize()
    }
}

/// The captured texel at the middle of one of the M×M texels; of the four around it, where their
/// number is even, the one of the smallest column and row. A fixed choice: on an edge of the scene
/// that the middle ray meets exactly, both backends then take the same side.
fn middle(m: u32, size: u32, at: CubeTexel) -> CubeTexel {
    let step = size / m;
    let middle = |i: u32| i * step + (step - 1) / 2;
    CubeTexel {
        column: middle(at.column),
        row: middle(at.row),
        ..at
    }
}

/// 1/d in 1/m along `direction` of the surface that the captured texel `near` lies on, and its
/// normal; 0 and the direction back where there is no surface.
pub fn surface_along(captured: &CubeImage, near: CubeTexel, direction: DVec3) -> (f32, Vec3) {
    let index = texel_index(captured.size, near.face, near.column, near.row);
    let back = -direction.as_vec3();
    match captured.distance.get(index) {
        Some(d) if d.is_finite() => {
            let normal = captured.normal.get(index).copied().unwrap_or(back);
            let d = distance_along(direction, near.ray(captured.size), *d, normal);
            (1.0 / d.max(NEAREST_M), normal)
        }
        _ => (0.0, back),
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
