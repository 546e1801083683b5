//! The slow, obvious capture: every texel's ray against every triangle, in f64.

use glam::{DVec3, Vec3};
use interreflect_scene::{
    Camera, CubeChannels, CubeSpec, Light, Material, Mesh, Object, Role, Scene, SceneMotion,
    conventions,
};

/// All channels at a size.
pub(crate) fn everything(size: u32) -> CubeSpec {
    CubeSpec {
        size,
        channels: CubeChannels {
            radiance: true,
            distance: true,
            normal: true,
        },
        bounces: 0,
    }
}

/// An empty scene seen from a reference point.
pub(crate) fn empty(reference_point: Vec3) -> Scene {
    Scene {
        name: "test".into(),
        objects: Vec::new(),
        materials: Vec::new(),
        lights: Vec::new(),
        environment: None,
        camera: Camera {
            eye: Vec3::ZERO,
            target: Vec3::NEG_Z,
            up: Vec3::Y,
            vfov_deg: 60.0,
            resolution: [8, 8],
        },
        reference_point,
        captured_at: None,
        motion: SceneMotion::default(),
    }
}

/// Adds a quad with corners counter-clockwise seen from the front.
pub(crate) fn add_quad(scene: &mut Scene, corners: [Vec3; 4], material: Material) {
    let index = scene.materials.len() as u32;
    scene.materials.push(material);
    scene.objects.push(Object {
        name: format!("quad {index}"),
        role: Role::Environment,
        mesh: Mesh {
            positions: corners.to_vec(),
            normals: Vec::new(),
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            materials: vec![index; 2],
        },
        motion: None,
    });
}

/// The walls of [−1, 1]³ in the order +x −x +y −y +z −z; their fronts face inwards.
pub(crate) fn add_room(scene: &mut Scene, materials: [Material; 6]) {
    for (face, material) in materials.into_iter().enumerate() {
        // s × t points inwards on every face.
        let at = |s: f64, t: f64| conventions::cube_vector(face, s, t).as_vec3();
        let corners = [at(-1.0, -1.0), at(1.0, -1.0), at(1.0, 1.0), at(-1.0, 1.0)];
        add_quad(scene, corners, material);
    }
}

/// A point that a ray met.
pub(crate) struct Hit {
    pub(crate) position: DVec3,
    pub(crate) distance: f64,
    /// On the front side.
    pub(crate) normal: DVec3,
    pub(crate) material: Material,
    /// Smallest barycentric coordinate: how far inside its triangle the point lies.
    pub(crate) inside: f64,
}

/// The first surface along a ray with a unit direction.
pub(crate) fn first_hit(scene: &Scene, origin: DVec3, direction: DVec3) -> Option<Hit> {
    let mut first: Option<Hit> = None;
    for object in scene.objects_of(Role::Environment) {
        for triangle in 0..object.mesh.triangles.len() {
            let [a, b, c] = object.mesh.corners(triangle).map(|p| p.as_dvec3());
            let area = (b - a).cross(c - a);
            let distance = area.dot(a - origin) / area.dot(direction);
            let position = origin + direction * distance;
            let share =
                |p: DVec3, q: DVec3| (q - p).cross(position - p).dot(area) / area.length_squared();
            let inside = share(a, b).min(share(b, c)).min(share(c, a));
            let nearer = first.as_ref().is_none_or(|f| distance < f.distance);
            if distance.is_finite() && distance > 1e-9 && inside >= 0.0 && nearer {
                let index = object.mesh.materials[triangle] as usize;
                first = Some(Hit {
                    position,
                    distance,
                    normal: area.normalize(),
                    material: scene.materials[index],
                    inside,
                });
            }
        }
    }
    first
}

/// Whether light from a light reaches a point, as far as surfaces go.
pub(crate) fn reached(scene: &Scene, light: &Light, x: DVec3, normal: DVec3) -> bool {
    let Some(incident) = light.incident(x.as_vec3()) else {
        return true;
    };
    let to_light = incident.to_light.as_dvec3();
    let occluder = first_hit(scene, x + normal * 1e-6, to_light);
    occluder.is_none_or(|hit| hit.distance > f64::from(incident.distance))
}

/// Every texel: face, column, row, and the unit direction through its centre.
pub(crate) fn texels(size: u32) -> impl Iterator<Item = (usize, DVec3)> {
    (0..conventions::CUBE_FACES).flat_map(move |face| {
        (0..size * size).map(move |i| {
            let (column, row) = (i % size, i / size);
            let (s, t) = (
                conventions::texel_centre(size, column),
                conventions::texel_centre(size, row),
            );
            let direction = conventions::cube_vector(face, s, t).normalize();
            (conventions::texel_index(size, face, column, row), direction)
        })
    })
}
