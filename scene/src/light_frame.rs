//! Frames of the views from the lights: squares of texels through which rays leave a light.

use crate::{Bounds, Light, LightPicture, RsmViews, Scene, conventions};
use glam::{DVec3, Vec3};

/// How the rays of a view leave the light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Projection {
    /// From one point.
    Perspective,
    /// Side by side.
    Orthographic,
}

/// A square of texels through which rays leave a light. Its vectors are unit and orthogonal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightFrame {
    /// Index of the light in the scene.
    pub light: u32,
    /// Where rays leave: the light, or for parallel light the middle of a square before the scene.
    pub origin: Vec3,
    /// Middle of the view.
    pub axis: Vec3,
    /// Direction in which s grows, with the column.
    pub right: Vec3,
    /// Direction in which t grows, with the row.
    pub down: Vec3,
    /// Perspective: tangent of half the view's full angle γ; orthographic: half its width in metres.
    pub half: f32,
    /// How the rays leave.
    pub projection: Projection,
}

impl LightFrame {
    /// Start in metres and unit direction of the ray through (s, t) ∈ [−1, 1]².
    pub fn ray(&self, s: f64, t: f64) -> (DVec3, DVec3) {
        let (start, along) = self.ray_through(s, t);
        (start, along.normalize())
    }

    /// As [`Self::ray`], the direction not normalised: its component along the axis is 1.
    pub fn ray_through(&self, s: f64, t: f64) -> (DVec3, DVec3) {
        let across = (self.right.as_dvec3() * s + self.down.as_dvec3() * t) * f64::from(self.half);
        let (origin, axis) = (self.origin.as_dvec3(), self.axis.as_dvec3());
        match self.projection {
            Projection::Perspective => (origin, axis + across),
            Projection::Orthographic => (origin + across, axis),
        }
    }

    /// The view's full angle γ in radians; 0 for parallel rays.
    pub fn full_angle(&self) -> f64 {
        match self.projection {
            Projection::Perspective => 2.0 * f64::from(self.half).atan(),
            Projection::Orthographic => 0.0,
        }
    }

    /// What the bundle of rays through one of `size`² cells measures: its exact solid angle in sr,
    /// or its cross-section in m² where rays are parallel.
    ///
    /// The solid angle is the difference over the cell's corners (a, b), as tangents, of
    /// atan2(a·b, √(a² + b² + 1)).
    pub fn cell_measure(&self, size: u32, column: u32, row: u32) -> f64 {
        let half = f64::from(self.half);
        match self.projection {
            Projection::Orthographic => (2.0 * half / f64::from(size)).powi(2),
            Projection::Perspective => {
                let edge = |i: u32| half * (2.0 * f64::from(i) / f64::from(size) - 1.0);
                let corner = |a: f64, b: f64| (a * b).atan2((a * a + b * b + 1.0).sqrt());
                let (a0, a1) = (edge(column), edge(column + 1));
                let (b0, b1) = (edge(row), edge(row + 1));
                corner(a1, b1) - corner(a0, b1) - corner(a1, b0) + corner(a0, b0)
            }
        }
    }
}

/// What the views of lights are aimed at.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Surroundings {
    /// Box around all surfaces.
    pub all: Bounds,
    /// Middle of the objects with [`Role::Environment`](crate::Role::Environment), or of all where there are none: it
    /// stays where it is while receivers move.
    pub middle: Vec3,
}

impl Surroundings {
    /// Of a scene.
    pub fn of(scene: &Scene) -> Self {
        let all = Bounds::of_all(scene);
        let captured = Bounds::of_captured(scene);
        let aimed_at = match scene.facts().captured_surfaces {
            true => captured,
            false => all,
        };
        Self {
            all,
            middle: aimed_at.centre(),
        }
    }

    /// All surfaces are in a box, in whose middle their middle is.
    pub fn within(bounds: Bounds) -> Self {
        Self {
            all: bounds,
            middle: bounds.centre(),
        }
    }
}

impl Light {
    /// The frames of a light's views.
    ///
    /// [`RsmViews::Picture`]: one square. A spot light looks along its axis with its full angle, a
    /// point or area light where its picture is ([`LightPicture`]), a directional light at the sphere
    /// around all surfaces. [`RsmViews::Surround`]: the frames that together see all that the light may shine on:
    /// of a point light the six faces of a cube, of an area light the five that look into its
    /// half-space, of the others the same one square. Where a view is wider than the light, its rays
    /// carry none: [`Light::incident`] says so.
    pub fn frames(&self, light: u32, around: &Surroundings, views: RsmViews) -> Vec<LightFrame> {
        let frame = |origin, axis, right, down, half| LightFrame {
            light,
            origin,
            axis,
            right,
            down,
            half,
            projection: Projection::Perspective,
        };
        let pictured = |origin, picture: LightPicture| {
            let LightPicture { direction, up, .. } = picture;
            let half = (0.5 * picture.angle_deg.to_radians()).tan();
            vec![frame(origin, direction, direction.cross(up), -up, half)]
        };
        match (*self, views) {
            (Self::Point { position, .. }, RsmViews::Surround) => (0..conventions::CUBE_FACES)
                .map(|face| {
                    let (axis, s, t) = conventions::cube_frame(face);
                    frame(position, axis.as_vec3(), s.as_vec3(), t.as_vec3(), 1.0)
                })
                .collect(),
            (
                Self::Point {
                    position, picture, ..
                },
                RsmViews::Picture,
            ) => {
                let ahead = || {
                    let inwards = (around.middle - position).try_normalize();
                    LightPicture::towards(inwards.unwrap_or(Vec3::NEG_Y), PICTURE_DEG)
                };
                pictured(position, picture.unwrap_or_else(ahead))
            }
            (
                Self::Spot {
                    position,
                    direction,
                    up,
                    angle_deg,
                    ..
                },
                _,
            ) => {
                let picture = LightPicture {
                    direction,
                    up,
                    angle_deg,
                };
                pictured(position, picture)
            }
            (
                Self::Area {
                    position, normal, ..
                },
                RsmViews::Surround,
            ) => {
                let (u, v) = normal.any_orthonormal_pair();
                let front = frame(position, normal, u, v, 1.0);
                let sides = [(u, v), (-u, v), (v, u), (-v, u)];
                let sides = sides.map(|(axis, s)| frame(position, axis, s, normal, 1.0));
                [vec![front], sides.to_vec()].concat()
            }
            (
                Self::Area {
                    position,
                    normal,
                    picture,
                    ..
                },
                RsmViews::Picture,
            ) => {
                let ahead = || LightPicture::towards(normal, PICTURE_DEG);
                pictured(position, picture.unwrap_or_else(ahead))
            }
            (Self::Directional { direction, .. }, _) => {
                let (u, v) = direction.any_orthonormal_pair();
                // A little more than the sphere, so that its rim lies inside the view.
                let half = (1.01 * around.all.radius()).max(f32::MIN_POSITIVE);
                let origin = around.all.centre() - direction * half;
                vec![LightFrame {
                    projection: Projection::Orthographic,
                    ..frame(origin, direction, u, v, half)
                }]
            }
        }
    }
}

/// Full angle in degrees of a picture for which a scene gives none.
const PICTURE_DEG: f32 = 90.0;

impl Scene {
    /// The frames of all lights' views, light by light.
    pub fn light_frames(&self, views: RsmViews) -> Vec<LightFrame> {
        light_frames(&self.lights, &Surroundings::of(self), views)
    }
}

/// The frames of the views of `lights`, light by light.
pub fn light_frames(lights: &[Light], around: &Surroundings, views: RsmViews) -> Vec<LightFrame> {
    let lights = (0..).zip(lights);
    lights
        .flat_map(|(i, l)| l.frames(i, around, views))
        .collect()
}

#[cfg(test)]
mod tests;
