//! Closed rooms, where the answer is known with all reflections; the boxes of `tests/points/`.

use super::scenes::{add, cpu, directions, glowing, places, turned, under, walls};
use super::{IRRADIANCE, exactly, hold};
use crate::room_points::ROOM;
use crate::test_scenes::{ROOM_RADIANCES, box_with, inside, points_file};
use crate::variants::Outcome;
use glam::{DVec3, Vec3};
use interreflect_conformance::oracles::form_factors::{furnace_radiance, integrating_sphere};
use interreflect_conformance::statistics::Scores;
use interreflect_scene::{
    Light, LightPaths, Material, Point, PointLayout, Points, Role, SceneRequest, open, shapes,
};
use libtest_mimic::Trial;
use std::f64::consts::PI;

pub(super) fn trials() -> Vec<Trial> {
    vec![
        Trial::test("path_reference/furnace", furnace),
        Trial::test("path_reference/furnace_bounces", furnace_bounces),
        Trial::test("path_reference/integrating_sphere", integrating),
        Trial::test("path_reference/rooms_in_rooms", rooms_in_rooms),
        Trial::test("path_reference/room", room),
        Trial::test("path_reference/spot", spot),
    ]
}

/// Points all over the box, some of them close to its walls.
fn everywhere() -> Points {
    let stretched = |mut point: Point| {
        point.position *= 1.665;
        Some(point)
    };
    let list = inside(200).into_iter().flatten().map(stretched);
    Points::new(PointLayout::Surface, list)
}

/// Radiance 1 all around gives E = π.
fn furnace() -> Outcome {
    let scene = cpu(&walls([glowing(0.0, 1.0); 6]));
    let traced = IRRADIANCE.trace(&scene, &everywhere());
    exactly(&traced, PI)
}

/// Each number of reflections gives its term of the series, and all of them its sum.
fn furnace_bounces() -> Outcome {
    let (albedo, emitted) = (0.6, 0.5);
    let scene = cpu(&walls([glowing(albedo, emitted); 6]));
    let (albedo, points) = (f64::from(albedo), everywhere());
    let traced = |bounces, least_bounces, seed| {
        let paths = LightPaths {
            bounces,
            least_bounces,
            ..LightPaths::ALL
        };
        IRRADIANCE.of(paths).seeded(seed).trace(&scene, &points)
    };
    let exact = |radiance: f64| move |_| DVec3::splat(PI * f64::from(emitted) * radiance);
    let all = furnace_radiance(albedo, None);
    let whole = traced(0, 0, 1);
    hold(Scores::new(&[(1.0, &whole)], exact(all), 0.0), 0.01)?;
    let first = furnace_radiance(albedo, Some(0));
    let reflected = traced(0, 1, 2);
    let terms = [(1.0, &whole), (-1.0, &reflected)];
    hold(Scores::new(&terms, exact(first), 0.0), 0.03)?;
    for k in 1..=4 {
        let (upto, below) = (
            furnace_radiance(albedo, Some(k)),
            furnace_radiance(albedo, Some(k - 1)),
        );
        let k = k as u32;
        for (least, sum) in [(0, upto), (k, upto - below)] {
            let traced = traced(k, least, u64::from(3 + 2 * k + least));
            hold(Scores::new(&[(1.0, &traced)], exact(sum), 0.0), 0.01)?;
        }
        let beyond = traced(0, k + 1, u64::from(20 + k));
        hold(Scores::new(&[(1.0, &beyond)], exact(all - upto), 0.0), 0.1)?;
    }
    Ok(())
}

/// A point light's flux is spread evenly over a sphere's wall by its first reflection.
fn integrating() -> Outcome {
    let (albedo, radius) = (0.5, 1.0);
    // 82 000 triangles with edges of 1°: a sphere to (1°)²/6 = 5e-5 in radius and in direction,
    // which enter once a bounce; five for the worst of both, squared.
    let known = 3e-4;
    let mesh = turned(shapes::sphere(radius, 64));
    let at = |t: usize| (mesh.corners(t).iter().sum::<Vec3>() / 3.0, mesh.normal(t));
    let points = places((0..mesh.triangles.len()).step_by(997).map(at));
    let mut scene = super::scenes::only([(
        Role::Environment,
        mesh.clone(),
        Material::diffuse(Vec3::splat(albedo)),
    )]);
    scene.lights.push(Light::Point {
        position: Vec3::new(0.3, 0.2, 0.0),
        intensity: Vec3::ONE,
        picture: None,
    });
    let (scene, flux) = (cpu(&scene), 4.0 * PI);
    for bounces in [1, 0] {
        let paths = LightPaths {
            bounces,
            ..LightPaths::ALL
        };
        let traced = IRRADIANCE.of(paths).trace(&scene, &points);
        let exact = flux * integrating_sphere(f64::from(albedo), f64::from(radius), bounces == 0);
        let scores = Scores::new(&[(1.0, &traced)], |_| DVec3::splat(exact), known);
        hold(scores, 0.02)?;
    }
    Ok(())
}

/// Seen through one another, radiances add up; where surfaces hide what is behind them, only the
/// nearest counts; and a receiver that is absent hides nothing.
fn rooms_in_rooms() -> Outcome {
    let mut scene = walls([glowing(0.0, 1.0); 6]);
    let shape = shapes::cuboid(Vec3::splat(4.0), shapes::Facing::Inward);
    add(&mut scene, (Role::Environment, shape, glowing(0.0, 1.0)));
    let ball = shapes::sphere(0.3, 20);
    add(&mut scene, (Role::Receiver, ball, glowing(0.0, 0.0)));
    let scene = cpu(&under(scene, 0.5));
    // Outside the ball, in all directions.
    let points = places(directions(40).map(|d| (d * 0.8, Vec3::new(d.y, -d.z, -d.x))));
    let through = LightPaths {
        indirect_visibility: false,
        ..LightPaths::ALL
    };
    let bare = LightPaths {
        self_shadowing: false,
        ..LightPaths::ALL
    };
    for (paths, radiance) in [(through, 2.5), (bare, 1.0)] {
        let traced = IRRADIANCE.of(paths).trace(&scene, &points);
        hold(Scores::against(&traced, |_| PI * radiance), 0.02)?;
    }
    Ok(())
}

/// The exact irradiances of `room.csv`.
fn room() -> Outcome {
    let room = &*ROOM;
    let test_scene = box_with(ROOM_RADIANCES, Vec::new());
    let traced = IRRADIANCE.trace(&test_scene.cpu, &room.points);
    let exact = room.column("E_exact")?;
    hold(Scores::against(&traced, |i| exact[i]), 0.01)
}

/// The exact first reflection of a spot light.
fn spot() -> Outcome {
    let mut reader = csv::Reader::from_path(points_file("drm.csv"))?;
    let header = reader.headers()?.clone();
    let column = |name: &str| header.iter().position(|n| n == name).ok_or(name.to_owned());
    let mut columns = [0; 7];
    for (found, name) in columns
        .iter_mut()
        .zip(["x", "y", "z", "nx", "ny", "nz", "E_exact"])
    {
        *found = column(name)?;
    }
    let (mut list, mut exact) = (Vec::new(), Vec::new());
    for record in reader.records() {
        let record = record?;
        let cell = |i: usize| record[columns[i]].parse::<f64>();
        let vector = |i: usize| {
            Ok::<_, std::num::ParseFloatError>(
                DVec3::new(cell(i)?, cell(i + 1)?, cell(i + 2)?).as_vec3(),
            )
        };
        list.push((vector(0)?, vector(3)?));
        exact.push(cell(6)?);
    }
    let scene = open(&SceneRequest::new(
        points_file("drm.toml").to_string_lossy(),
    ))?;
    let once = LightPaths {
        bounces: 1,
        ..LightPaths::ALL
    };
    let traced = IRRADIANCE.of(once).trace(&cpu(&scene), &places(list));
    // The table is exact to 5e-5.
    let exact = |i: usize| DVec3::splat(exact[i]);
    hold(Scores::new(&[(1.0, &traced)], exact, 5e-5), 0.05)
}
