//! A camera for scenes that bring none.

use super::build::{Parts, bounds_of};
use crate::{Camera, Object, Role};
use glam::Vec3;

/// Field of view from outside: a 35 mm lens on 25 mm film, the measured Cornell box's camera.
const OUTSIDE_VFOV_DEG: f32 = 39.3077;
const INSIDE_VFOV_DEG: f32 = 75.0;
const RESOLUTION: [u32; 2] = [512, 512];

/// Horizontal directions from the scene to where a camera may stand, the preferred first.
const SIDES: [Vec3; 4] = [Vec3::Z, Vec3::NEG_Z, Vec3::X, Vec3::NEG_X];

/// A camera that shows the surroundings, y up; without surroundings, the receivers. Three rules:
///
/// 1. Fronts mostly turned away from the centre of the bounding box: an object, seen from outside,
///    from the front (+z), a little to the right and from above.
/// 2. Else it is a room. If a vertical side of its bounding box is open, it is seen from outside
///    through that side, which just fills the image.
/// 3. Else from inside: from nine tenths of the way to the farthest of the four walls.
pub(super) fn default_camera(parts: &Parts) -> Camera {
    let of = |role: Role| parts.objects.iter().filter(move |o| o.role == role);
    let shown = match of(Role::Environment).next() {
        Some(_) => Shown::new(of(Role::Environment).collect()),
        None => Shown::new(of(Role::Receiver).collect()),
    };
    let (eye, vfov_deg) = shown.view();
    Camera {
        eye,
        target: shown.centre,
        up: Vec3::Y,
        vfov_deg,
        resolution: RESOLUTION,
    }
}

/// What the camera is to show, with its bounding box.
struct Shown<'a> {
    objects: Vec<&'a Object>,
    centre: Vec3,
    half: Vec3,
}

impl<'a> Shown<'a> {
    fn new(objects: Vec<&'a Object>) -> Self {
        let bounds = bounds_of(objects.iter().copied());
        let (lo, hi) = bounds.unwrap_or((Vec3::NEG_ONE, Vec3::ONE));
        Self {
            objects,
            centre: 0.5 * lo + 0.5 * hi,
            half: 0.5 * hi - 0.5 * lo,
        }
    }

    /// Eye and vertical field of view in degrees.
    fn view(&self) -> (Vec3, f32) {
        let reach = |side: Vec3| side.abs().dot(self.half);
        let slope = (0.5 * OUTSIDE_VFOV_DEG).to_radians();
        if !self.faces_inward() {
            let distance = 1.05 * self.half.length() / slope.sin();
            let towards = Vec3::new(0.35, 0.3, 1.0).normalize();
            return (self.centre + towards * distance, OUTSIDE_VFOV_DEG);
        }
        if let Some(side) = SIDES.into_iter().find(|side| self.is_open(*side)) {
            let across = self.half.y.max(reach(side.cross(Vec3::Y)));
            let distance = reach(side) + 1.04 * across / slope.tan();
            return (self.centre + side * distance, OUTSIDE_VFOV_DEG);
        }
        let free = SIDES.map(|side| side * self.first_hit(side).min(reach(side)));
        let farthest = free[1..].iter().fold(free[0], |a, b| {
            if b.length_squared() > a.length_squared() {
                *b
            } else {
                a
            }
        });
        (self.centre + 0.9 * farthest, INSIDE_VFOV_DEG)
    }

    fn triangles(&self) -> impl Iterator<Item = [Vec3; 3]> {
        self.objects
            .iter()
            .flat_map(|o| (0..o.mesh.triangles.len()).map(|t| o.mesh.corners(t)))
    }

    /// Whether the volume between centre and triangles, signed by their fronts, is negative.
    fn faces_inward(&self) -> bool {
        let signed = |[a, b, c]: [Vec3; 3]| {
            (a - self.centre)
                .as_dvec3()
                .dot((b - a).cross(c - a).as_dvec3())
        };
        self.triangles().map(signed).sum::<f64>() < 0.0
    }

    /// Whether most rays from the centre through the middle of a side of the box get out.
    fn is_open(&self, side: Vec3) -> bool {
        let across = side.cross(Vec3::Y);
        let steps = [-0.4, -0.2, 0.0, 0.2, 0.4];
        let out = steps
            .into_iter()
            .flat_map(|s| steps.map(|t| (side + s * across + t * Vec3::Y) * self.half))
            .filter(|ray| self.first_hit(*ray).is_infinite())
            .count();
        2 * out > steps.len().pow(2)
    }

    /// Distance from the centre, in lengths of the direction, to the first triangle, or +∞ (Möller
    /// and Trumbore, *Fast, Minimum Storage Ray/Triangle Intersection*, 1997).
    fn first_hit(&self, direction: Vec3) -> f32 {
        self.triangles()
            .filter_map(|[a, b, c]| {
                let (ab, ac) = (b - a, c - a);
                let p = direction.cross(ac);
                let from = (self.centre - a) / ab.dot(p);
                let (u, q) = (from.dot(p), from.cross(ab));
                let (v, t) = (direction.dot(q), ac.dot(q));
                (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0).then_some(t)
            })
            .fold(f32::INFINITY, f32::min)
    }
}
