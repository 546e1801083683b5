//! What every scene promises: indices in range, finite numbers, unit normals.

use crate::{Light, Material, Mesh, Scene, SceneError};
use glam::Vec3;

/// Largest distance of a stored normal's length from 1: a few roundings of f32.
const UNIT_TOLERANCE: f32 = 1e-4;

impl Scene {
    /// Checks what every scene promises. Scenes that come from [`crate::load::open`] have passed;
    /// call it on a scene made by hand.
    ///
    /// # Errors
    /// [`SceneError::Inconsistent`] names the first thing that does not hold.
    pub fn validate(&self) -> Result<(), SceneError> {
        let wrong = |what: String, remedy: &str| SceneError::Inconsistent {
            scene: self.name.clone(),
            what,
            remedy: remedy.into(),
        };
        for object in &self.objects {
            mesh_fault(&object.mesh, self.materials.len()).map_err(|fault| {
                wrong(
                    format!("object `{}`: {fault}", object.name),
                    "mend the mesh or its transform",
                )
            })?;
        }
        if let Some(i) = self.materials.iter().position(|m| !is_physical(m)) {
            return Err(wrong(
                format!("material {i} is not physical: {:?}", self.materials[i]),
                "keep reflectances in [0, 1], specular plus diffuse at most 1, and emission at least 0",
            ));
        }
        if let Some(i) = self.lights.iter().position(|l| !is_sound(l)) {
            return Err(wrong(
                format!("light {i} is not usable: {:?}", self.lights[i]),
                "use finite numbers, powers of at least 0 and unit directions",
            ));
        }
        let camera = &self.camera;
        let view = camera.target - camera.eye;
        let framed = view.cross(camera.up).length_squared() > 0.0
            && view.cross(camera.up).is_finite()
            && camera.vfov_deg > 0.0
            && camera.vfov_deg < 180.0
            && camera.resolution.iter().all(|r| *r > 0);
        if !framed {
            return Err(wrong(
                format!("the camera has no view: {camera:?}"),
                "look at another point, with `up` off the view direction",
            ));
        }
        if !self.reference_point.is_finite() {
            return Err(wrong(
                format!("the reference point {} is not finite", self.reference_point),
                "use finite numbers",
            ));
        }
        Ok(())
    }
}

fn mesh_fault(mesh: &Mesh, materials: usize) -> Result<(), String> {
    let vertices = mesh.positions.len();
    if let Some(v) = mesh.positions.iter().position(|p| !p.is_finite()) {
        return Err(format!("vertex {v} is at {}", mesh.positions[v]));
    }
    if !mesh.normals.is_empty() && mesh.normals.len() != vertices {
        return Err(format!(
            "{} normals for {vertices} vertices",
            mesh.normals.len()
        ));
    }
    let is_unit = |n: &Vec3| (n.length() - 1.0).abs() < UNIT_TOLERANCE;
    if let Some(v) = mesh.normals.iter().position(|n| !is_unit(n)) {
        return Err(format!("normal {v} is {}", mesh.normals[v]));
    }
    if mesh.materials.len() != mesh.triangles.len() {
        let (m, t) = (mesh.materials.len(), mesh.triangles.len());
        return Err(format!("{m} materials for {t} triangles"));
    }
    if mesh.triangles.is_empty() {
        return Err("it has no triangles".into());
    }
    if let Some(t) = mesh
        .triangles
        .iter()
        .position(|t| t.iter().any(|v| *v as usize >= vertices))
    {
        let corners = mesh.triangles[t];
        return Err(format!(
            "triangle {t} is {corners:?} of {vertices} vertices"
        ));
    }
    match mesh.materials.iter().find(|m| **m as usize >= materials) {
        Some(m) => Err(format!("material {m} of {materials}")),
        None => Ok(()),
    }
}

/// Whether a material neither makes energy nor holds a number that is no number.
pub(crate) fn is_physical(m: &Material) -> bool {
    let reflectance = |v: Vec3| v.is_finite() && v.min_element() >= 0.0 && v.max_element() <= 1.0;
    // 1e-3: materials are written with three digits or more.
    let conserves = m.mirror || (m.albedo + m.specular).max_element() <= 1.0 + 1e-3;
    reflectance(m.albedo)
        && reflectance(m.specular)
        && conserves
        && is_power(m.emission)
        && m.shininess.is_finite()
        && m.shininess >= 0.0
}

fn is_power(v: Vec3) -> bool {
    v.is_finite() && v.min_element() >= 0.0
}

fn is_sound(light: &Light) -> bool {
    let unit = |v: Vec3| (v.length() - 1.0).abs() < UNIT_TOLERANCE;
    match *light {
        Light::Point {
            position,
            intensity,
        } => position.is_finite() && is_power(intensity),
        Light::Spot {
            position,
            direction,
            up,
            angle_deg,
            intensity,
            ..
        } => {
            position.is_finite()
                && is_power(intensity)
                && unit(direction)
                && unit(up)
                && direction.dot(up).abs() < UNIT_TOLERANCE
                && angle_deg > 0.0
                && angle_deg < 180.0
        }
        Light::Directional {
            direction,
            irradiance,
        } => unit(direction) && is_power(irradiance),
        Light::Area {
            position,
            normal,
            area_m2,
            flux,
        } => {
            position.is_finite()
                && unit(normal)
                && area_m2 > 0.0
                && area_m2.is_finite()
                && is_power(flux)
        }
    }
}
