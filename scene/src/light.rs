//! Lights that are not surfaces.

use glam::Vec3;

/// Cross-section of a spot light's frustum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpotShape {
    /// A circular cone of the full angle.
    Cone,
    /// A square pyramid whose opposite sides enclose the full angle.
    Square,
}

/// The view in which a light that shines into all directions, or into a half-space, takes its picture
/// (Frisvad et al., §3). It does not narrow the light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightPicture {
    /// Unit direction of the middle of the picture.
    pub direction: Vec3,
    /// Unit upward direction of the picture, orthogonal to `direction`.
    pub up: Vec3,
    /// Full angle between opposite sides of the square picture in degrees, in (0, 180).
    pub angle_deg: f32,
}

/// A light with hard shadows. Directions are unit vectors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light {
    /// Radiates equally in all directions.
    Point {
        /// Position in metres.
        position: Vec3,
        /// Radiant intensity in W/sr; a flux Φ is 4π times as much.
        intensity: Vec3,
        /// Where it takes its picture; `None`: 90° wide, towards the middle of what is no receiver.
        picture: Option<LightPicture>,
    },
    /// A point light inside a frustum.
    Spot {
        /// Position in metres.
        position: Vec3,
        /// Axis of the frustum, away from the light.
        direction: Vec3,
        /// Upward direction of the square cross-section, orthogonal to `direction`.
        up: Vec3,
        /// Cross-section.
        shape: SpotShape,
        /// Full opening angle in degrees, in (0, 180).
        angle_deg: f32,
        /// Radiant intensity in W/sr inside the frustum.
        intensity: Vec3,
    },
    /// Parallel light.
    Directional {
        /// Direction in which the light travels.
        direction: Vec3,
        /// Irradiance in W/m² on a surface that faces the light.
        irradiance: Vec3,
    },
    /// A distant isotropic area light, taken as one point that radiates by the cosine
    /// (Frisvad et al., §3): L_e = Φ/(πA).
    Area {
        /// Centre in metres.
        position: Vec3,
        /// Direction into which it radiates.
        normal: Vec3,
        /// Area A in m²; cancels in the irradiance.
        area_m2: f32,
        /// Flux Φ in W.
        flux: Vec3,
        /// Where it takes its picture; `None`: 90° wide, along the normal.
        picture: Option<LightPicture>,
    },
}

/// Light arriving at a point from one light, before any shadow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Incident {
    /// Unit direction from the point to the light.
    pub to_light: Vec3,
    /// Distance to the light in metres, +∞ for directional light.
    pub distance: f32,
    /// Irradiance in W/m² on a surface that faces the light.
    pub irradiance: Vec3,
}

impl LightPicture {
    /// A picture with the default up: from +y, or from +z where the direction is nearly vertical.
    pub fn towards(direction: Vec3, angle_deg: f32) -> Self {
        Self {
            direction,
            up: upright(direction),
            angle_deg,
        }
    }
}

/// The upward direction across a unit axis: from +y, or from +z where the axis is nearly vertical.
pub fn upright(axis: Vec3) -> Vec3 {
    let up = if axis.y.abs() < 0.99 {
        Vec3::Y
    } else {
        Vec3::Z
    };
    (up - axis * up.dot(axis)).normalize()
}

impl Light {
    /// What arrives at `x`, or `None` where the light does not shine or `x` is at the light.
    pub fn incident(&self, x: Vec3) -> Option<Incident> {
        let from = |position: Vec3| {
            let d = position - x;
            let r2 = d.length_squared();
            (r2 > 0.0).then(|| (d / r2.sqrt(), r2))
        };
        let radiating = |to_light: Vec3, r2: f32, intensity: Vec3| Incident {
            to_light,
            distance: r2.sqrt(),
            irradiance: intensity / r2,
        };
        match *self {
            Light::Point {
                position,
                intensity,
                ..
            } => from(position).map(|(d, r2)| radiating(d, r2, intensity)),
            Light::Spot {
                position,
                direction,
                up,
                shape,
                angle_deg,
                intensity,
            } => {
                let (d, r2) = from(position)?;
                let inside = in_frustum(-d, direction, up, shape, angle_deg);
                inside.then(|| radiating(d, r2, intensity))
            }
            Light::Directional {
                direction,
                irradiance,
            } => Some(Incident {
                to_light: -direction,
                distance: f32::INFINITY,
                irradiance,
            }),
            Light::Area {
                position,
                normal,
                flux,
                ..
            } => {
                let (d, r2) = from(position)?;
                let cos_light = (-d).dot(normal);
                (cos_light > 0.0)
                    .then(|| radiating(d, r2, flux * cos_light * std::f32::consts::FRAC_1_PI))
            }
        }
    }
}

/// Whether a unit direction away from a spot light lies inside its frustum.
fn in_frustum(away: Vec3, axis: Vec3, up: Vec3, shape: SpotShape, angle_deg: f32) -> bool {
    let half = 0.5 * angle_deg.to_radians();
    let along = away.dot(axis);
    match shape {
        SpotShape::Cone => along >= half.cos(),
        SpotShape::Square => {
            let limit = along * half.tan();
            let right = axis.cross(up);
            along > 0.0 && away.dot(right).abs() <= limit && away.dot(up).abs() <= limit
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spot_ends_at_half_of_its_full_angle() {
        let irradiance = |shape, across: f32| {
            let spot = Light::Spot {
                position: Vec3::Y,
                direction: Vec3::NEG_Y,
                up: Vec3::Z,
                shape,
                angle_deg: 90.0,
                intensity: Vec3::ONE,
            };
            spot.incident(Vec3::new(across, 0.0, across))
                .map(|light| light.irradiance.x)
        };
        // 45° from the axis, one metre below: a circle of radius 1, a square of half-width 1.
        for (shape, edge) in [(SpotShape::Cone, 0.5_f32.sqrt()), (SpotShape::Square, 1.0)] {
            let inside = 0.99 * edge;
            let expected = 1.0 / (1.0 + 2.0 * inside * inside);
            let found = irradiance(shape, inside).unwrap_or(0.0);
            // Roundings of a squared distance.
            assert!((found / expected - 1.0).abs() < 1e-6, "{shape:?}: {found}");
            assert_eq!(irradiance(shape, 1.01 * edge), None, "{shape:?}");
        }
    }

    #[test]
    fn an_area_light_radiates_its_flux_by_the_cosine() {
        let light = Light::Area {
            position: Vec3::ZERO,
            normal: Vec3::X,
            area_m2: 3.0,
            flux: Vec3::splat(std::f32::consts::PI),
            picture: None,
        };
        let at = |x, y| light.incident(Vec3::new(x, y, 0.0)).map(|i| i.irradiance.x);
        // Φ/π·cos θ/r²; behind it nothing. Roundings of a few products.
        assert!(at(2.0, 0.0).is_some_and(|e| (e - 0.25).abs() < 1e-6));
        assert!(at(1.0, 1.0).is_some_and(|e| (e - 0.5 * 0.5_f32.sqrt()).abs() < 1e-6));
        assert_eq!(at(-1.0, 1.0), None);
    }
}
