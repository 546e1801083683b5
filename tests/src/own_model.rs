//! What a method claims to compute, evaluated by a deterministic integral.
//!
//! The surroundings of the reference point are captured in many small patches, each a planar quad
//! at its surface's place or a bundle of directions at infinity, and every point sums over all of
//! them: near quads by the exact polygon kernel, far ones by the point kernel.

use glam::{DVec3, Vec3};
use interreflect_cpu::capture::cube::capture_cube;
use interreflect_cpu::path_tracer::{Stop, trace};
use interreflect_cpu::scene::CpuScene;
use interreflect_estimators::path_reference::path_quantity;
use interreflect_estimators::{OwnModel, Quantity};
use interreflect_scene::conventions::{CUBE_FACES, cube_vector, texel_index, texel_solid_angle_sr};
use interreflect_scene::material::blinn_phong_normalisation;
use interreflect_scene::{CubeChannels, CubeImage, CubeSpec, Estimate, Point, Points};
use rayon::prelude::*;
use std::f64::consts::FRAC_1_PI;

use crate::oracles::polygon::polygon_irradiance;

/// A model's value at each point, with how far it may be off.
pub struct ModelValues {
    /// The values.
    pub values: Estimate,
    /// For each value: the standard error of a path-traced model, or the change when the patches
    /// were halved, which bounds the error left in the finer ones.
    pub error: Estimate,
    /// One line on how they were computed.
    pub description: String,
}

/// Texels along the edge of the finer of the two patch captures.
pub const PATCH_RESOLUTION: u32 = 192;

/// Evaluates `model` for `quantity` at every point. `stop` and `seed` are for path-traced models.
pub fn evaluate(
    model: OwnModel,
    quantity: Quantity,
    scene: &CpuScene,
    points: &Points,
    stop: &Stop,
    seed: u64,
) -> ModelValues {
    if let OwnModel::LightTransport(paths) = model {
        let quantity = path_quantity(quantity);
        let traced = trace(scene, points, quantity, &paths, stop, seed, &|_| {});
        return ModelValues {
            values: traced.mean,
            error: traced.standard_error,
            description: format!("path tracing, {} samples", traced.samples),
        };
    }
    let gather = |size| gather(&patches(model, scene, size), quantity, points);
    let values = gather(PATCH_RESOLUTION);
    let coarse = gather(PATCH_RESOLUTION / 2);
    let mut error = Estimate::new(points.len());
    for i in 0..points.len() {
        error.set(i, (values.get(i) - coarse.get(i)).abs());
    }
    ModelValues {
        values,
        error,
        description: format!("integral over 6×{PATCH_RESOLUTION}² patches"),
    }
}

/// A small piece of what is seen from the reference point.
struct Patch {
    radiance: DVec3,
    place: Place,
}

enum Place {
    /// A planar quad, corners clockwise seen from the reference point; centre, area, and normal
    /// on the side of the reference point.
    Surface {
        corners: [DVec3; 4],
        centre: DVec3,
        normal: DVec3,
        area_m2: f64,
    },
    /// A bundle of directions: vector solid angle in sr.
    Infinity { vector_sr: DVec3 },
}

fn patches(model: OwnModel, scene: &CpuScene, size: u32) -> Vec<Patch> {
    let local = model == OwnModel::VisibleFromReference;
    let captured = capture_cube(
        scene,
        CubeSpec {
            size,
            channels: CubeChannels {
                radiance: true,
                distance: local,
                normal: local,
            },
        },
    );
    let mut patches = Vec::with_capacity(captured.texels());
    let origin = scene.scene().reference_point.as_dvec3();
    for face in 0..CUBE_FACES {
        for row in 0..size {
            for column in 0..size {
                let index = texel_index(size, face, column, row);
                patches.push(Patch {
                    radiance: captured.radiance[index].as_dvec3(),
                    place: place(&captured, origin, face, column, row),
                });
            }
        }
    }
    if model == OwnModel::MeanRadiance {
        let omega = |patch: &Patch| match &patch.place {
            Place::Infinity { vector_sr } => vector_sr.length(),
            Place::Surface { .. } => 0.0,
        };
        let total: f64 = patches.iter().map(omega).sum();
        let mean = patches.iter().map(|p| p.radiance * omega(p)).sum::<DVec3>() / total;
        patches.iter_mut().for_each(|p| p.radiance = mean);
    }
    patches
}

/// Where a captured texel lies: its corner rays cut with the plane of the surface at its centre.
fn place(captured: &CubeImage, origin: DVec3, face: usize, column: u32, row: u32) -> Place {
    let size = captured.size;
    let edge = |i: u32| 2.0 * f64::from(i) / f64::from(size) - 1.0;
    let (s0, s1, t0, t1) = (edge(column), edge(column + 1), edge(row), edge(row + 1));
    // Clockwise seen from the centre.
    let rays = [(s0, t0), (s0, t1), (s1, t1), (s1, t0)].map(|(s, t)| cube_vector(face, s, t));
    let middle = cube_vector(face, 0.5 * (s0 + s1), 0.5 * (t0 + t1)).normalize();
    let index = texel_index(size, face, column, row);
    let distance = captured
        .distance
        .get(index)
        .copied()
        .unwrap_or(f32::INFINITY);
    let omega_sr = texel_solid_angle_sr(size, column, row);
    if !distance.is_finite() {
        return Place::Infinity {
            vector_sr: middle * omega_sr,
        };
    }
    let (distance, normal) = (f64::from(distance), captured.normal[index].as_dvec3());
    let height = -distance * normal.dot(middle);
    // A plane that some corner ray misses, or meets far behind, is no continuation of the surface:
    // such a texel is a quad across its middle ray.
    let slope = rays.map(|ray| -normal.dot(ray) / ray.length());
    let facing = slope
        .iter()
        .all(|&s| s > 0.2 * (height / distance) && s > 1e-3);
    let (normal, height) = if facing {
        (normal, height)
    } else {
        (-middle, distance)
    };
    let corners = rays.map(|ray| origin + ray * (height / -normal.dot(ray)));
    let diagonals = (corners[2] - corners[0]).cross(corners[3] - corners[1]);
    Place::Surface {
        corners,
        centre: origin + middle * distance,
        normal,
        area_m2: 0.5 * diagonals.length(),
    }
}

fn gather(patches: &[Patch], quantity: Quantity, points: &Points) -> Estimate {
    let values: Vec<Vec3> = (0..points.len())
        .into_par_iter()
        .map(|i| match points.get(i) {
            Some(point) => gather_point(patches, quantity, &point),
            None => Vec3::ZERO,
        })
        .collect();
    let mut estimate = Estimate::new(points.len());
    for (i, value) in values.into_iter().enumerate() {
        estimate.set(i, value);
    }
    estimate
}

/// Reflectance of a point towards its viewer, or 1 where irradiance is asked for.
struct Reflectance {
    normal: DVec3,
    view: DVec3,
    shininess: f64,
    normalisation: f64,
}

impl Reflectance {
    /// Diffuse and specular factor for light from a unit direction.
    fn factors(&self, i: DVec3) -> (f64, f64) {
        let h = (i + self.view).normalize_or_zero();
        let cos_half = self.normal.dot(h).max(0.0);
        let specular = self.normalisation * cos_half.powf(self.shininess);
        (FRAC_1_PI, if cos_half > 0.0 { specular } else { 0.0 })
    }
}

fn gather_point(patches: &[Patch], quantity: Quantity, point: &Point) -> Vec3 {
    let (x, n) = (point.position.as_dvec3(), point.normal.as_dvec3());
    let material = point.material;
    let shininess = f64::from(material.shininess);
    let reflectance = (quantity == Quantity::GlossyRadiance).then(|| Reflectance {
        normal: n,
        view: point.view.as_dvec3(),
        shininess,
        normalisation: blinn_phong_normalisation(shininess),
    });
    let (mut diffuse, mut specular) = (DVec3::ZERO, DVec3::ZERO);
    for patch in patches {
        let mut add = |irradiance: f64, i: DVec3| {
            let (d, s) = reflectance.as_ref().map_or((1.0, 0.0), |r| r.factors(i));
            diffuse += patch.radiance * (irradiance * d);
            specular += patch.radiance * (irradiance * s);
        };
        match &patch.place {
            Place::Infinity { vector_sr } => {
                let irradiance = n.dot(*vector_sr);
                if irradiance > 0.0 {
                    add(irradiance, vector_sr.normalize());
                }
            }
            Place::Surface {
                corners,
                centre,
                normal,
                area_m2,
            } => {
                let r = *centre - x;
                let r2 = r.length_squared();
                if normal.dot(r) >= 0.0 {
                    continue;
                }
                if r2 > FAR * area_m2 {
                    let i = r / r2.sqrt();
                    let cosines = n.dot(i).max(0.0) * -normal.dot(i);
                    if cosines > 0.0 {
                        add(area_m2 * cosines / r2, i);
                    }
                } else {
                    let corners = corners.map(|c| c - x);
                    let depth = if reflectance.is_some() { SPLITS } else { 0 };
                    near(n, &corners, depth, &mut add);
                }
            }
        }
    }
    let kd = material.diffuse.as_dvec3();
    let ks = material.specular.as_dvec3();
    match quantity {
        Quantity::GlossyRadiance => (kd * diffuse + ks * specular).as_vec3(),
        _ => diffuse.as_vec3(),
    }
}

/// Squared distance over area from which a quad counts as a point: the point kernel's relative
/// error is then below 1/FAR.
const FAR: f64 = 256.0;

/// How often a near quad is split in four so that the lobe varies little over each part.
const SPLITS: u32 = 3;

/// A near quad: its exact irradiance, in parts where the reflectance varies.
fn near(n: DVec3, corners: &[DVec3; 4], depth: u32, add: &mut impl FnMut(f64, DVec3)) {
    let [a, b, c, d] = *corners;
    let middle = (a + b + c + d) * 0.25;
    if depth == 0 {
        let irradiance = polygon_irradiance(n, corners);
        if irradiance > 0.0 {
            add(irradiance, middle.normalize_or_zero());
        }
        return;
    }
    let (ab, bc, cd, da) = ((a + b) * 0.5, (b + c) * 0.5, (c + d) * 0.5, (d + a) * 0.5);
    for part in [
        [a, ab, middle, da],
        [ab, b, bc, middle],
        [middle, bc, c, cd],
        [da, middle, cd, d],
    ] {
        near(n, &part, depth - 1, add);
    }
}
