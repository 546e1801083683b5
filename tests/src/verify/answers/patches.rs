//! Patches that emit 1 in the dark.

use super::{Answer, Reduce, Setting, facing, orientations, scene, seen_from, within};
use crate::oracles::form_factors::{
    CUBE_ADJACENT, CUBE_OPPOSITE, coaxial_disc, offset_disc, parallel_rectangle,
    perpendicular_rectangle, sphere_above_horizon,
};
use crate::verify::box_scene::Lighting;
use crate::verify::case::Case;
use glam::{DVec3, Vec3};
use interreflect_estimators::{Answers, OwnModel, Quantity};
use interreflect_scene::{Material, Mesh, Point, Scene, shapes};
use std::f64::consts::PI;

pub(super) fn all() -> Vec<Answer> {
    let patch = |name, about, settings| Answer {
        name,
        about,
        kind: Answers::Patches,
        settings,
        reduce: Reduce::Each,
    };
    let walls = |name, about, settings, reduce| Answer {
        name,
        about,
        kind: Answers::Walls,
        settings,
        reduce,
    };
    vec![
        patch(
            "parallel_rectangle",
            "a rectangle above, parallel to the receiver",
            parallel,
        ),
        patch(
            "perpendicular_rectangle",
            "a rectangle that stands on the receiver's plane",
            perpendicular,
        ),
        patch("disc", "a disc above, coaxial and beside", disc),
        patch("sphere", "a sphere above the horizon", sphere),
        walls(
            "opposite_faces",
            "the mean over a unit cube's face of what the opposite one sends",
            |model, quantity| faces(model, quantity, 4, CUBE_OPPOSITE),
            Reduce::Mean,
        ),
        walls(
            "adjacent_faces",
            "the mean over a unit cube's face of what an adjacent one sends",
            |model, quantity| faces(model, quantity, 0, CUBE_ADJACENT),
            Reduce::Mean,
        ),
        walls(
            "room",
            "six walls of different radiance, by the exact kernel of polygons",
            room,
            Reduce::Each,
        ),
    ]
}

/// A setting of irradiance F(x)·π, with every point upright; `None` for a model without an answer.
fn lit_by(
    model: OwnModel,
    quantity: Quantity,
    mesh: Mesh,
    reference: DVec3,
    places: &[DVec3],
    normal: DVec3,
    fraction: impl Fn(DVec3) -> f64,
) -> Option<Vec<Setting>> {
    if quantity != Quantity::Irradiance {
        return None;
    }
    let answer = |&x: &DVec3| {
        let from = seen_from(model, x, reference)?;
        Some((facing(x, normal), DVec3::splat(PI * fraction(from))))
    };
    let points: Option<Vec<(Point, DVec3)>> = places.iter().map(answer).collect();
    let surfaces = vec![(mesh, Material::emitter(Vec3::ONE))];
    points.map(|points| {
        vec![Setting {
            scene: scene(surfaces, reference),
            points,
        }]
    })
}

/// The fan of a planar polygon's corners, counter-clockwise from its front.
fn polygon(corners: &[DVec3]) -> Mesh {
    let last = corners.len() as u32 - 1;
    Mesh {
        positions: corners.iter().map(|c| c.as_vec3()).collect(),
        triangles: (1..last).map(|i| [0, i, i + 1]).collect(),
        ..Mesh::default()
    }
}

/// Sides a and b at the height c.
const RECTANGLE: (f64, f64, f64) = (1.4, 0.9, 0.8);

fn parallel(model: OwnModel, quantity: Quantity) -> Option<Vec<Setting>> {
    let (a, b, c) = RECTANGLE;
    let corners = [(0.0, 0.0), (0.0, b), (a, b), (a, 0.0)].map(|(x, y)| DVec3::new(x, y, c));
    let places = [
        (0.0, 0.0),
        (0.3, 0.5),
        (0.7, 0.45),
        (1.6, -0.4),
        (-0.5, 0.2),
    ];
    let places = places.map(|(x, y)| DVec3::new(x, y, 0.0));
    let reference = DVec3::new(0.6, 0.3, 0.0);
    let fraction = |x: DVec3| {
        let part = |s: f64, t: f64| {
            let sign = s.signum() * t.signum();
            sign * parallel_rectangle(s.abs(), t.abs(), c - x.z)
        };
        part(a - x.x, b - x.y) + part(x.x, b - x.y) + part(a - x.x, x.y) + part(x.x, x.y)
    };
    lit_by(
        model,
        quantity,
        polygon(&corners),
        reference,
        &places,
        DVec3::Z,
        fraction,
    )
}

fn perpendicular(model: OwnModel, quantity: Quantity) -> Option<Vec<Setting>> {
    let (height, width, distance) = (1.1, 1.3, 1.0);
    // Faces −y, towards the points.
    let corners = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)];
    let corners = corners.map(|(x, z)| DVec3::new(x, distance, z));
    let places = [(0.0, 0.0), (0.5, 0.2), (1.0, 0.5), (-0.4, 0.1)];
    let places = places.map(|(x, y)| DVec3::new(x, y, 0.0));
    let reference = DVec3::new(0.7, 0.1, 0.0);
    let fraction = |x: DVec3| {
        let part = |w: f64| match w {
            0.0 => 0.0,
            w => w.signum() * perpendicular_rectangle(height, w.abs(), distance - x.y),
        };
        part(width - x.x) + part(x.x)
    };
    lit_by(
        model,
        quantity,
        polygon(&corners),
        reference,
        &places,
        DVec3::Z,
        fraction,
    )
}

/// A disc of this radius at this height, of as many triangles: its area is the circle's.
const DISC: (f64, f64, u32) = (0.7, 0.9, 96);

fn disc(model: OwnModel, quantity: Quantity) -> Option<Vec<Setting>> {
    let (radius, height, sides) = DISC;
    let step = 2.0 * PI / f64::from(sides);
    let outer = radius * (step / step.sin()).sqrt();
    let corner = |k: u32| {
        let (sin, cos) = (-step * f64::from(k)).sin_cos();
        DVec3::new(outer * cos, outer * sin, height)
    };
    let corners: Vec<DVec3> = (0..sides).map(corner).collect();
    let places = [(0.0, 0.0), (0.4, 0.0), (0.5, 0.6), (-1.2, 0.3)];
    let places = places.map(|(x, y)| DVec3::new(x, y, 0.0));
    let fraction = |x: DVec3| match x.truncate().length() {
        0.0 => coaxial_disc(radius, height),
        a => offset_disc(radius, height, a),
    };
    let reference = DVec3::new(0.2, -0.1, 0.0);
    lit_by(
        model,
        quantity,
        polygon(&corners),
        reference,
        &places,
        DVec3::Z,
        fraction,
    )
}

/// What is seen of a sphere depends on where it is seen from: points at the reference point only.
fn sphere(model: OwnModel, quantity: Quantity) -> Option<Vec<Setting>> {
    let (radius, distance, cos_theta) = (0.5, 1.2, 0.8_f64);
    let mesh = shapes::sphere(radius as f32, 24);
    let sin_theta = (1.0 - cos_theta * cos_theta).sqrt();
    let x = DVec3::new(distance * sin_theta, 0.0, -distance * cos_theta);
    let fraction = |_| sphere_above_horizon(radius, distance, cos_theta);
    lit_by(model, quantity, mesh, x, &[x], DVec3::Z, fraction)
}

/// Points on the face −z of a unit cube, one other face of which emits.
fn faces(model: OwnModel, quantity: Quantity, face: usize, factor: f64) -> Option<Vec<Setting>> {
    const CELLS: usize = 24;
    let at_point = matches!(
        model,
        OwnModel::VisibleFromReference { .. } | OwnModel::LightTransport(_)
    );
    if !at_point || quantity != Quantity::Irradiance {
        return None;
    }
    let at = |k: usize| (k as f64 + 0.5) / CELLS as f64 - 0.5;
    let points = (0..CELLS * CELLS).map(|k| {
        let x = DVec3::new(at(k % CELLS), at(k / CELLS), -0.5);
        (facing(x, DVec3::Z), DVec3::splat(PI * factor))
    });
    let mut cube = case([0.5; 3], [0.0; 6], [0.0; 3], Vec::new());
    cube.walls[face] = 1.0;
    Some(vec![Setting {
        scene: cube.box_scene(Lighting::Walls).scene(),
        points: points.collect(),
    }])
}

fn case(half: [f32; 3], walls: [f32; 6], reference: [f32; 3], points: Vec<[[f32; 3]; 2]>) -> Case {
    Case {
        half,
        walls,
        sky: [0.0; 3],
        reference,
        lamp: [0.0; 3],
        points,
    }
}

/// The box of `points/room.obj` and another, with points all over the inside.
fn room(model: OwnModel, quantity: Quantity) -> Option<Vec<Setting>> {
    let boxes = [
        ([1.0; 3], [1.0, 0.2, 0.5, 0.8, 0.3, 0.6], [0.2, -0.1, 0.3]),
        (
            [1.5, 0.6, 1.0],
            [0.1, 0.9, 0.4, 0.7, 1.0, 0.0],
            [0.0, 0.2, -0.3],
        ),
    ];
    if quantity != Quantity::Irradiance {
        return None;
    }
    let settings = boxes.map(|(half, walls, reference)| {
        let points = orientations(64).enumerate();
        let points = points.map(|(i, n)| [within(i), n.as_vec3().to_array()]);
        let box_scene = case(half, walls, reference, points.collect()).box_scene(Lighting::Walls);
        let answer = |p: &Point| Some((*p, DVec3::splat(box_scene.irradiance(model, p)?)));
        let points: Option<Vec<_>> = box_scene.points.iter().map(answer).collect();
        let scene: Scene = box_scene.scene();
        points.map(|points| Setting { scene, points })
    });
    settings.into_iter().collect()
}
