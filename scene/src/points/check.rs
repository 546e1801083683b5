//! What every point list promises a backend.

use super::{Point, PointLayout, Points};
use crate::validate::is_near;
use glam::Vec3;

/// A point that is none.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("point {index} {fault}")]
pub struct PointError {
    /// Its place in the list.
    pub index: usize,
    /// What is wrong with it, and what it has to be.
    pub fault: String,
}

/// Largest distance of a normal's length from 1: normals that were interpolated and normalised again
/// are far nearer.
const UNIT: f32 = 1e-3;

/// Largest exponent of a lobe: beyond it the power's stated error does not hold.
const LARGEST_SHININESS: f32 = 1e5;

impl Points {
    /// Checks positions, normals, directions to the viewer and materials of all points.
    ///
    /// # Errors
    /// [`PointError`] names the first point that a formula could not take.
    pub fn validate(&self) -> Result<(), PointError> {
        let material = self.layout() == PointLayout::Material;
        for (index, point) in self.iter().enumerate() {
            if let Some(fault) = point.and_then(|p| fault(&p, material)) {
                return Err(PointError { index, fault });
            }
        }
        Ok(())
    }
}

fn fault(point: &Point, material: bool) -> Option<String> {
    let unit = |v: Vec3| (v.length() - 1.0).abs() <= UNIT;
    if !is_near(point.position) {
        return Some(format!(
            "is at {:?}: use coordinates within ±1e15 m",
            point.position.to_array()
        ));
    }
    if !unit(point.normal) {
        return Some(format!(
            "has the normal {:?}: normals have length 1",
            point.normal.to_array()
        ));
    }
    if !material {
        return None;
    }
    if !unit(point.view) {
        return Some(format!(
            "has the direction {:?} to the viewer: directions have length 1",
            point.view.to_array()
        ));
    }
    let m = &point.material;
    let albedo = |v: Vec3| v.cmpge(Vec3::ZERO).all() && v.cmple(Vec3::ONE).all();
    let exponent = (0.0..=LARGEST_SHININESS).contains(&m.shininess);
    (!albedo(m.diffuse) || !albedo(m.specular) || !exponent).then(|| {
        format!("has a material that is not physical: {m:?}; albedos lie in [0, 1], exponents in [0, 1e5]")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_point_that_is_none_is_named() {
        let good = Point {
            normal: Vec3::Y,
            view: Vec3::Z,
            ..Point::default()
        };
        let list = |bad| Points::new(PointLayout::Material, [Some(good), None, Some(bad)]);
        assert_eq!(list(good).validate(), Ok(()));
        let far = Vec3::new(0.0, f32::NAN, 0.0);
        let mut material = good.material;
        material.shininess = f32::INFINITY;
        for bad in [
            Point {
                position: far,
                ..good
            },
            Point {
                normal: Vec3::ZERO,
                ..good
            },
            Point {
                normal: 1.1 * Vec3::Y,
                ..good
            },
            Point { view: far, ..good },
            Point { material, ..good },
        ] {
            let error = list(bad).validate().map_err(|e| e.index);
            assert_eq!(error, Err(2), "{bad:?}");
        }
        // What a layout does not carry is not looked at.
        let surface = Points::new(PointLayout::Surface, [Some(Point { view: far, ..good })]);
        assert_eq!(surface.validate(), Ok(()));
    }
}
