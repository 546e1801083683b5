//! What a scene must keep to for the CPU backend.

use glam::Vec3;
use interreflect_scene::{Object, Scene};

/// Largest coordinate that ray queries take; areas of boxes must not overflow f32.
const LARGEST_COORDINATE: f32 = 1e15;
/// Why a scene can't be taken over by the CPU backend.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CpuError {
    /// A mesh contradicts itself.
    #[error("object `{object}`: {what}; export the mesh again or remove it")]
    Mesh {
        /// Name of the object.
        object: String,
        /// What is wrong, with the index and the value.
        what: String,
    },
    /// The meshes are too big for 32-bit indices.
    #[error(
        "the scene has {triangles} triangles, at most {} are possible; simplify it",
        u32::MAX
    )]
    TooManyTriangles {
        /// Triangles in all meshes.
        triangles: usize,
    },
    /// The environment's image contradicts itself.
    #[error("the environment's {width}×{height} image has {texels} texels; load it again")]
    Environment {
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
        /// Texels that are there.
        texels: usize,
    },
}

/// Checks indices, lengths, coordinates and the environment's size.
pub(super) fn check(scene: &Scene) -> Result<(), CpuError> {
    let triangles = scene.objects.iter().map(|o| o.mesh.triangles.len()).sum();
    if triangles >= u32::MAX as usize {
        return Err(CpuError::TooManyTriangles { triangles });
    }
    for object in &scene.objects {
        check_mesh(object, scene.materials.len()).map_err(|what| CpuError::Mesh {
            object: object.name.clone(),
            what,
        })?;
    }
    if let Some(environment) = &scene.environment {
        let image = &environment.image;
        let texels = image.texels.len();
        if texels == 0 || texels != image.width as usize * image.height as usize {
            return Err(CpuError::Environment {
                width: image.width,
                height: image.height,
                texels,
            });
        }
    }
    Ok(())
}

fn check_mesh(object: &Object, materials: usize) -> Result<(), String> {
    let mesh = &object.mesh;
    let vertices = mesh.positions.len();
    if !mesh.normals.is_empty() && mesh.normals.len() != vertices {
        let normals = mesh.normals.len();
        return Err(format!("{normals} normals for {vertices} vertices"));
    }
    if mesh.materials.len() != mesh.triangles.len() {
        let (m, t) = (mesh.materials.len(), mesh.triangles.len());
        return Err(format!("{m} materials for {t} triangles"));
    }
    if let Some(m) = mesh.materials.iter().find(|&&m| m as usize >= materials) {
        return Err(format!("material {m} of {materials}"));
    }
    if let Some(v) = (mesh.triangles.iter().flatten()).find(|&&v| v as usize >= vertices) {
        return Err(format!("a triangle refers to vertex {v} of {vertices}"));
    }
    let inside = |p: &Vec3| p.is_finite() && p.abs().max_element() <= LARGEST_COORDINATE;
    match mesh.positions.iter().position(|p| !inside(p)) {
        Some(i) => Err(format!("vertex {i} lies at {}", mesh.positions[i])),
        None => Ok(()),
    }
}
