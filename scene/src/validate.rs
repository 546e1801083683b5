//! What every scene promises: indices in range, finite numbers, unit normals.

use crate::{
    Camera, Environment, Light, LightPicture, Material, Mesh, Object, Role, Scene, SceneError,
    motion,
};
use glam::Vec3;

/// Largest distance of a stored normal's length from 1: a few roundings of f32.
const UNIT_TOLERANCE: f32 = 1e-4;
/// Largest coordinate in metres: areas of boxes must not overflow f32.
pub(crate) const LARGEST_COORDINATE: f32 = 1e15;
/// Smallest extent of a scene in metres: ray queries would take less for rounding.
pub(crate) const SMALLEST_EXTENT: f32 = 1e-8;
/// Largest radiance, intensity, irradiance and flux: sums over many must stay finite in f32.
pub(crate) const LARGEST_POWER: f32 = 1e30;

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
        if let Some(fault) = self.extent_fault() {
            return Err(wrong(fault, "scale the meshes, for example to metres"));
        }
        if let Some(i) = self.materials.iter().position(|m| !is_physical(m)) {
            return Err(wrong(
                format!("material {i} is not physical: {:?}", self.materials[i]),
                "keep reflectances in [0, 1], specular plus diffuse at most 1, and emission from 0 to 1e30",
            ));
        }
        if let Some(i) = self.lights.iter().position(|l| !is_sound(l)) {
            return Err(wrong(
                format!("light {i} is not usable: {:?}", self.lights[i]),
                "use positions within ±1e15 m, powers from 0 to 1e30 and unit directions",
            ));
        }
        if let Some(fault) = self.environment.as_ref().and_then(environment_fault) {
            return Err(wrong(fault, "choose another image or scale"));
        }
        if let Some(fault) = camera_fault(&self.camera) {
            return Err(wrong(
                fault,
                "look at another point, with `up` off the view direction",
            ));
        }
        if !is_near(self.reference_point) {
            return Err(wrong(
                format!(
                    "the reference point is {:?}",
                    self.reference_point.to_array()
                ),
                "use coordinates within ±1e15 m",
            ));
        }
        if let Some(at) = self.captured_at.filter(|at| !is_near(*at)) {
            return Err(wrong(
                format!("captures were made at {:?}", at.to_array()),
                "use coordinates within ±1e15 m",
            ));
        }
        self.check_motion()
    }

    /// Checks that the scene stays sound at every time.
    fn check_motion(&self) -> Result<(), SceneError> {
        let of_object = |o: &Object| {
            let fault = motion::mesh_fault(&o.mesh, o.motion.as_ref()?)?;
            Some(format!("object `{}`: {fault}", o.name))
        };
        let of_objects = self.objects.iter().find_map(of_object);
        match of_objects.or_else(|| motion::scene_fault(self)) {
            None => Ok(()),
            Some(what) => Err(SceneError::Inconsistent {
                scene: self.name.clone(),
                what,
                remedy: "fix the motion, for example with other keyframes".into(),
            }),
        }
    }

    /// What is wrong with the size of the surroundings or of the receivers.
    fn extent_fault(&self) -> Option<String> {
        [Role::Environment, Role::Receiver]
            .into_iter()
            .find_map(|role| {
                let largest = self
                    .objects_of(role)
                    .flat_map(|o| &o.mesh.positions)
                    .map(|p| p.abs().max_element())
                    .reduce(f32::max)?;
                (largest < SMALLEST_EXTENT).then(|| {
                    format!(
                        "the largest coordinate of the {} is {largest:e} m, below {SMALLEST_EXTENT:e} m",
                        match role {
                            Role::Environment => "surroundings",
                            Role::Receiver => "receivers",
                        }
                    )
                })
            })
    }
}

/// Whether a vector's length is 1 but for rounding.
pub(crate) fn is_unit(v: Vec3) -> bool {
    (v.length() - 1.0).abs() < UNIT_TOLERANCE
}

/// Whether a point is at finite coordinates that ray queries can take.
pub(crate) fn is_near(point: Vec3) -> bool {
    point.is_finite() && point.abs().max_element() <= LARGEST_COORDINATE
}

fn camera_fault(camera: &Camera) -> Option<String> {
    let Camera {
        eye,
        target,
        up,
        vfov_deg,
        resolution: [width, height],
    } = *camera;
    let across = (target - eye).cross(up);
    let framed = is_near(eye)
        && is_near(target)
        && across.is_finite()
        && across.length_squared() > 0.0
        && vfov_deg > 0.0
        && vfov_deg < 180.0
        && width > 0
        && height > 0;
    (!framed).then(|| {
        let [eye, target, up] = [eye, target, up].map(|v| v.to_array());
        format!(
            "the camera has no valid view: from {eye:?} to {target:?}, up {up:?}, {vfov_deg}° in {width} × {height} pixels"
        )
    })
}

fn environment_fault(environment: &Environment) -> Option<String> {
    let Environment {
        image,
        scale,
        rotate_deg,
    } = environment;
    let (width, height, texels) = (image.width, image.height, image.texels.len());
    if texels == 0 || texels != width as usize * height as usize {
        return Some(format!(
            "the environment's {width} × {height} image has {texels} texels"
        ));
    }
    if !rotate_deg.is_finite() {
        return Some(format!("the environment is turned by {rotate_deg}°"));
    }
    let unusable = |t: &Vec3| !is_power(*t) || !is_power(*t * *scale);
    let texel = image.texels.iter().position(unusable)?;
    Some(format!(
        "the environment's texel {texel}, {:?} times {scale}, is no radiance from 0 to {LARGEST_POWER:e}",
        image.texels[texel].to_array()
    ))
}

fn mesh_fault(mesh: &Mesh, materials: usize) -> Result<(), String> {
    let vertices = mesh.positions.len();
    if let Some(v) = mesh.positions.iter().position(|p| !is_near(*p)) {
        return Err(format!(
            "vertex {v} is at {:?}, not within ±{LARGEST_COORDINATE:e} m",
            mesh.positions[v].to_array()
        ));
    }
    if !mesh.normals.is_empty() && mesh.normals.len() != vertices {
        return Err(format!(
            "{} normals for {vertices} vertices",
            mesh.normals.len()
        ));
    }
    if let Some(v) = mesh.normals.iter().position(|n| !is_unit(*n)) {
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

/// Whether a radiance, intensity, irradiance or flux can be summed.
pub(crate) fn is_power(v: Vec3) -> bool {
    v.is_finite() && v.min_element() >= 0.0 && v.max_element() <= LARGEST_POWER
}

/// Whether a view has a direction, an upward direction across it, and an opening angle.
fn is_picture(picture: LightPicture) -> bool {
    let LightPicture {
        direction,
        up,
        angle_deg,
    } = picture;
    is_unit(direction)
        && is_unit(up)
        && direction.dot(up).abs() < UNIT_TOLERANCE
        && angle_deg > 0.0
        && angle_deg < 180.0
}

fn is_sound(light: &Light) -> bool {
    let unit = is_unit;
    match *light {
        Light::Point {
            position,
            intensity,
            picture,
        } => is_near(position) && is_power(intensity) && picture.is_none_or(is_picture),
        Light::Spot {
            position,
            direction,
            up,
            angle_deg,
            intensity,
            ..
        } => {
            is_near(position)
                && is_power(intensity)
                && is_picture(LightPicture {
                    direction,
                    up,
                    angle_deg,
                })
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
            picture,
        } => {
            is_near(position)
                && picture.is_none_or(is_picture)
                && unit(normal)
                && area_m2 > 0.0
                && area_m2.is_finite()
                && is_power(flux)
        }
    }
}
