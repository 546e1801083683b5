//! What is taken to its extreme, and where on each axis.

use crate::verify::box_scene::{BoxScene, Lighting, Placement};
use crate::verify::{Case, MethodUnderTest};
use glam::{DVec3, Mat3, Vec3};
use interreflect_estimators::{Configured, Quantity};
use interreflect_scene::params::Value;
use interreflect_scene::{Light, Points, Scene};

/// An axis.
pub(super) struct Axis {
    pub(super) name: &'static str,
    pub(super) unit: &'static str,
    pub(super) values: fn() -> Vec<f64>,
    /// Whether a claimed bound is about its places.
    pub(super) bounded: bool,
    /// Whether its inputs have to be refused.
    pub(super) refusable: bool,
    /// What is estimated there; `None` where the axis does not touch the method.
    pub(super) place: fn(&MethodUnderTest<'_>, Lighting, f64) -> Option<Place>,
}

/// A scene, points and a method on an axis.
pub(super) struct Place {
    pub(super) scene: Scene,
    pub(super) points: Points,
    pub(super) method: Box<dyn Configured>,
    /// What surroundings of the greatest radiance give there.
    pub(super) greatest: f64,
}

/// Powers of ten.
fn decades(first: i32, last: i32, step: usize) -> Vec<f64> {
    (first..=last)
        .step_by(step)
        .map(|e| 10f64.powi(e))
        .collect()
}

/// Nothing, then powers of ten.
fn from_nothing(first: i32, last: i32, step: usize) -> Vec<f64> {
    std::iter::once(0.0)
        .chain(decades(first, last, step))
        .collect()
}

pub(super) fn all() -> Vec<Axis> {
    let axis = |name, unit, values, place| Axis {
        name,
        unit,
        values,
        bounded: true,
        refusable: false,
        place,
    };
    vec![
        axis("scale", "m", || decades(-6, 6, 2), scale),
        axis("radiance", "W/(m² sr)", || decades(-30, 30, 10), radiance),
        axis("gap", "m", || from_nothing(-7, -1, 1), gap),
        axis(
            "from_reference",
            "m",
            || from_nothing(-7, -1, 2),
            from_reference,
        ),
        axis(
            "on_texel",
            "0 middle, 1 edge, 2 corner",
            || vec![0.0, 1.0, 2.0],
            on_texel,
        ),
        axis("grazing", "cosine", || from_nothing(-8, 0, 2), grazing),
        axis("sliver", "m", || from_nothing(-7, -1, 2), sliver),
        axis("texels", "a side", || vec![1.0, 2.0, 3.0], texels),
        Axis {
            bounded: false,
            ..axis("shininess", "exponent", || from_nothing(0, 5, 1), shininess)
        },
        Axis {
            refusable: true,
            ..axis("normal_length", "", normal_lengths, normal_length)
        },
        Axis {
            refusable: true,
            ..axis(
                "no_number",
                "0 mesh, 1 radiance, 2 sky, 3 point",
                || vec![0.0, 1.0, 2.0, 3.0],
                no_number,
            )
        },
    ]
}

/// None of them 1.
fn normal_lengths() -> Vec<f64> {
    vec![0.0, 1e-30, 1e-10, 1e-3, 0.9, 1.1, 1e3, 1e30]
}

/// A box of unequal walls with points all over it.
fn box_scene(lighting: Lighting) -> BoxScene {
    Case::unequal(48).box_scene(lighting)
}

fn place(under_test: &MethodUnderTest<'_>, box_scene: &BoxScene) -> Place {
    Place {
        scene: box_scene.scene(),
        points: box_scene.placed_points(under_test.quantity),
        method: under_test.method.boxed_clone(),
        greatest: box_scene.greatest(under_test.quantity),
    }
}

fn scale(under_test: &MethodUnderTest<'_>, lighting: Lighting, metres: f64) -> Option<Place> {
    let mut box_scene = box_scene(lighting);
    box_scene.placement = Placement {
        linear: Mat3::from_diagonal(Vec3::splat(metres as f32)),
        shift: Vec3::ZERO,
    };
    Some(place(under_test, &box_scene))
}

/// All light times a factor.
fn radiance(under_test: &MethodUnderTest<'_>, lighting: Lighting, factor: f64) -> Option<Place> {
    if under_test.quantity == Quantity::AmbientOcclusion {
        return None;
    }
    let mut place = place(under_test, &box_scene(lighting));
    let factor = factor as f32;
    for material in &mut place.scene.materials {
        material.emission *= factor;
    }
    for light in &mut place.scene.lights {
        if let Light::Point { intensity, .. } = light {
            *intensity *= factor;
        }
    }
    if let Some(environment) = &mut place.scene.environment {
        environment.scale *= factor;
    }
    place.greatest *= f64::from(factor);
    Some(place)
}

/// Points so far from a wall, which face it, face away and look along it.
fn gap(under_test: &MethodUnderTest<'_>, lighting: Lighting, metres: f64) -> Option<Place> {
    let mut box_scene = box_scene(lighting);
    let x = box_scene.half.x - metres as f32;
    for (i, point) in box_scene.points.iter_mut().enumerate() {
        point.position.x = x;
        point.normal = [Vec3::X, Vec3::NEG_X, Vec3::Y, Vec3::NEG_Z][i % 4];
        point.view = (point.normal + Vec3::new(-0.3, 0.2, 0.1)).normalize();
    }
    Some(place(under_test, &box_scene))
}

/// Points so far from the reference point.
fn from_reference(
    under_test: &MethodUnderTest<'_>,
    lighting: Lighting,
    metres: f64,
) -> Option<Place> {
    let mut box_scene = box_scene(lighting);
    let reference = box_scene.reference;
    for point in &mut box_scene.points {
        let away = Vec3::new(point.normal.y, point.normal.z, point.normal.x);
        point.position = reference + away * metres as f32;
    }
    Some(place(under_test, &box_scene))
}

/// Points on a wall where the rays from the reference point through middles, edges and corners of its
/// texels meet it, for maps of 4² texels a face.
fn on_texel(under_test: &MethodUnderTest<'_>, lighting: Lighting, which: f64) -> Option<Place> {
    let mut box_scene = box_scene(lighting);
    let (s, t) = [(0.25, 0.25), (0.5, 0.25), (0.5, 0.5)][which as usize];
    let distance = box_scene.half.x - box_scene.reference.x;
    for (i, point) in box_scene.points.iter_mut().enumerate() {
        let side = |k: usize| if i >> k & 1 == 0 { -1.0_f32 } else { 1.0 };
        let along = Vec3::new(1.0, side(0) * s, side(1) * t);
        point.position = box_scene.reference + along * distance;
        point.position.x = box_scene.half.x;
        point.normal = [Vec3::NEG_X, Vec3::X, Vec3::Y][(i >> 2) % 3];
        point.view = (point.normal + Vec3::new(-0.3, 0.2, 0.1)).normalize();
    }
    Some(place(under_test, &box_scene))
}

/// One wall alone, seen by points whose normals have so large a cosine to its axis.
fn grazing(under_test: &MethodUnderTest<'_>, lighting: Lighting, cosine: f64) -> Option<Place> {
    let mut box_scene = box_scene(lighting);
    if lighting != Lighting::Sky {
        box_scene.walls = std::array::from_fn(|i| Vec3::splat(f32::from(u8::from(i == 0))));
    }
    let sine = (1.0 - cosine * cosine).sqrt();
    for (i, point) in box_scene.points.iter_mut().enumerate() {
        let (sin, cos) = (0.7 * i as f64).sin_cos();
        point.normal = DVec3::new(cosine, sine * sin, sine * cos).as_vec3();
        point.view = (point.normal + Vec3::new(0.3, 0.2, -0.1)).normalize();
    }
    Some(place(under_test, &box_scene))
}

/// The box with a strip before one wall, so wide.
fn sliver(under_test: &MethodUnderTest<'_>, lighting: Lighting, metres: f64) -> Option<Place> {
    let mut place = place(under_test, &box_scene(lighting));
    let mesh = &mut place.scene.objects.first_mut()?.mesh;
    let first = mesh.positions.len() as u32;
    let width = metres.min(1.0) as f32;
    let corners = [(0.0, -0.7), (0.0, 0.7), (width, 0.7), (width, -0.7)];
    // Not quite planar: the last corner stands off.
    let corner = |(i, (y, z)): (usize, (f32, f32))| {
        Vec3::new(1.1 - 1e-3 * f32::from(u8::from(i == 3)), y, z)
    };
    mesh.positions
        .extend(corners.into_iter().enumerate().map(corner));
    mesh.triangles.push([first, first + 1, first + 2]);
    mesh.triangles.push([first, first + 2, first + 3]);
    mesh.materials.extend([1; 2]);
    Some(place)
}

/// Every map of so few texels.
fn texels(under_test: &MethodUnderTest<'_>, lighting: Lighting, side: f64) -> Option<Place> {
    let mut place = place(under_test, &box_scene(lighting));
    let mut touched = false;
    for (field, value) in place.method.values() {
        let counts = field.name.ends_with("resolution") || field.name == "samples_per_side";
        if counts && matches!(value, Value::U32(_)) {
            // What it can't have so small it keeps.
            touched |= place.method.set(field.name, &side.to_string()).is_ok();
        }
    }
    touched.then_some(place)
}

fn shininess(under_test: &MethodUnderTest<'_>, lighting: Lighting, exponent: f64) -> Option<Place> {
    let mut box_scene = box_scene(lighting);
    for point in &mut box_scene.points {
        point.material.shininess = exponent as f32;
    }
    (under_test.quantity == Quantity::GlossyRadiance).then(|| place(under_test, &box_scene))
}

fn normal_length(
    under_test: &MethodUnderTest<'_>,
    lighting: Lighting,
    length: f64,
) -> Option<Place> {
    let mut box_scene = box_scene(lighting);
    for point in &mut box_scene.points {
        point.normal *= length as f32;
    }
    Some(place(under_test, &box_scene))
}

/// No number in a mesh, a radiance, a sky, a point.
fn no_number(under_test: &MethodUnderTest<'_>, lighting: Lighting, which: f64) -> Option<Place> {
    let mut place = place(under_test, &box_scene(lighting));
    match which as u32 {
        0 => place.scene.objects.first_mut()?.mesh.positions[2].y = f32::NAN,
        1 => place.scene.materials.first_mut()?.emission.x = f32::INFINITY,
        2 => place.scene.environment.as_mut()?.image.texels[5].z = f32::NAN,
        _ => {
            let mut box_scene = box_scene(lighting);
            box_scene.points[7].position.x = f32::NAN;
            place.points = box_scene.placed_points(under_test.quantity);
        }
    }
    Some(place)
}
