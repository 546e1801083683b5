//! The path tracer with a choice of light paths.

mod support;

use glam::Vec3;
use interreflect_cpu::path_tracer::{LightPaths, PathQuantity, trace};
use interreflect_cpu::scene::CpuScene;
use interreflect_scene::{Material, Mesh, Points, Role, SceneRequest, open};
use std::f32::consts::PI;
use support::estimates::{FULL, inside, irradiance, largest_z, samples};
use support::{cpu, glowing, object, point, points, quad, room, sphere, under, walls};

/// A receiver sphere of radius ½ in the middle of a glowing room.
fn room_with_receiver() -> CpuScene {
    let mut scene = walls([glowing(0.0, 1.0); 6]);
    let mut ball = sphere(0.5, 8, false, false);
    ball.materials.fill(6);
    scene.materials.push(Material::diffuse(Vec3::ZERO));
    scene.objects.push(object(Role::Receiver, ball));
    cpu(&scene)
}

#[test]
fn receivers_are_absent_without_self_shadowing() {
    let scene = room_with_receiver();
    // On the axis, facing the ball at distance d: it hides (r/d)² of the light.
    let facing = points([point(Vec3::X * 0.9, Vec3::NEG_X)]);
    let with = irradiance(&scene, &facing, FULL, 4096).mean.get(0).x / PI;
    // The polyhedron of 768 triangles is up to 1 % smaller than the sphere.
    assert!(
        (with - (1.0 - (0.5_f32 / 0.9).powi(2))).abs() < 0.01,
        "{with}"
    );
    let paths = LightPaths {
        self_shadowing: false,
        ..FULL
    };
    let without = irradiance(&scene, &facing, paths, 4096);
    assert!(largest_z(&without, |_| std::f64::consts::PI) < 4.0);
}

#[test]
fn all_surfaces_along_a_ray_count_without_indirect_visibility() {
    let scene = room_with_receiver();
    let facing = points([point(Vec3::X * 0.9, Vec3::NEG_X)]);
    let paths = LightPaths {
        indirect_visibility: false,
        ..FULL
    };
    // The black ball hides nothing of the walls behind it.
    let traced = irradiance(&scene, &facing, paths, 2048);
    assert!(largest_z(&traced, |_| std::f64::consts::PI) < 4.0);

    // Two rooms, one in the other, both glowing inwards, and the sky: three radiances add up.
    let mut twice = walls([glowing(0.0, 1.0); 6]);
    let outer = room(Vec3::splat(-2.0), Vec3::splat(2.0));
    twice.objects.push(object(Role::Environment, outer));
    let twice = cpu(&under(twice, 0.5));
    let traced = irradiance(&twice, &inside(10), paths, 4096);
    assert!(largest_z(&traced, |_| 2.5 * std::f64::consts::PI) < 4.0);
    let traced = irradiance(&twice, &inside(10), FULL, 4096);
    assert!(largest_z(&traced, |_| std::f64::consts::PI) < 4.0);
}

#[test]
fn an_environment_at_infinity_depends_on_the_normal_alone() {
    let mut scene = walls([1.0, 0.2, 0.5, 0.8, 0.3, 0.6].map(|l| glowing(0.0, l)));
    scene.reference_point = Vec3::new(0.2, -0.1, 0.3);
    let (here, there) = (scene.reference_point, Vec3::new(0.9, 0.9, -0.9));
    let both = points([point(here, Vec3::NEG_X), point(there, Vec3::NEG_X)]);
    let at_infinity = LightPaths {
        environment_at_infinity: true,
        ..FULL
    };
    // A receiver around the reference point hides nothing of its view.
    let mut ball = sphere(0.1, 4, false, false);
    ball.positions.iter_mut().for_each(|p| *p += here);
    ball.materials.fill(6);
    scene.materials.push(Material::diffuse(Vec3::ZERO));
    scene.objects.push(object(Role::Receiver, ball));
    let scene = cpu(&scene);
    let bare = LightPaths {
        self_shadowing: false,
        ..FULL
    };
    let far = irradiance(&scene, &both, at_infinity, 4096);
    let local = irradiance(&scene, &both, bare, 4096);
    let exact = f64::from(local.mean.get(0).x);
    // The local estimate has an error of its own: √2 times 4.
    assert!(largest_z(&far, |_| exact) < 5.7);
    let other = f64::from(local.mean.get(1).x);
    assert!((other / exact - 1.0).abs() > 0.1, "{other} and {exact}");
}

#[test]
fn openness_is_one_outside_zero_in_a_closed_room_and_half_beside_a_wall() {
    let openness = |scene: &CpuScene, points: &Points, paths: LightPaths| {
        let quantity = PathQuantity::AmbientOcclusion;
        trace(scene, points, quantity, &paths, &samples(4096), 5, &|_| ())
    };
    let closed = cpu(&walls([glowing(0.0, 1.0); 6]));
    assert!(
        openness(&closed, &inside(9), FULL)
            .mean
            .iter()
            .all(|a| a == Vec3::ZERO)
    );
    let unseen = LightPaths {
        indirect_visibility: false,
        ..FULL
    };
    assert!(
        openness(&closed, &inside(9), unseen)
            .mean
            .iter()
            .all(|a| a == Vec3::ONE)
    );

    // Beside a wall of height h at distance d: 1 − ½(1 − d/√(d² + h²)).
    let (far, h, d) = (1000.0, 1.0, 0.5_f64);
    let wall = quad(
        [(-far, 0.0), (far, 0.0), (far, h), (-far, h)].map(|(z, y)| Vec3::new(0.0, y, z)),
        0,
    );
    let scene = support::scene(vec![object(Role::Receiver, wall)], vec![glowing(0.5, 0.0)]);
    let ground = points([point(Vec3::X * d as f32, Vec3::Y)]);
    let traced = openness(&cpu(&scene), &ground, FULL);
    let exact = 1.0 - 0.5 * (1.0 - d / (d * d + f64::from(h * h)).sqrt());
    assert!(largest_z(&traced, |_| exact) < 4.0);
    let absent = LightPaths {
        self_shadowing: false,
        ..FULL
    };
    assert_eq!(
        openness(&cpu(&scene), &ground, absent).mean.get(0),
        Vec3::ONE
    );
}

/// Openness of a horizontal point that sees the sky through a rectangle from its zenith's corner, of
/// sides a and b at height c: 1/(2π)[A/√(1+A²)·atan(B/√(1+A²)) + B/√(1+B²)·atan(A/√(1+B²))].
fn seen_through(a: f64, b: f64, c: f64) -> f64 {
    let half = |a: f64, b: f64| a / a.hypot(1.0) * (b / a.hypot(1.0)).atan();
    let (a, b) = (a / c, b / c);
    (half(a, b) + half(b, a)) / std::f64::consts::TAU
}

#[test]
fn the_floor_of_the_pit_is_as_open_as_its_rectangle() {
    let set = [("width", "1.2"), ("length", "2"), ("depth", "0.7")];
    let request = SceneRequest {
        set: set.map(|(n, v)| (n.into(), v.into())).into(),
        ..SceneRequest::new("pit")
    };
    let scene = open(&request).expect("the library's own scene");
    let places = [(0.0, 0.0), (0.5, 0.0), (-0.55, 0.9), (0.2, -0.8)];
    let floor = points(places.map(|(x, z)| point(Vec3::new(x, -0.7, z), Vec3::Y)));
    let quantity = PathQuantity::AmbientOcclusion;
    let traced = trace(
        &cpu(&scene),
        &floor,
        quantity,
        &FULL,
        &samples(4096),
        5,
        &|_| (),
    );
    let open_at = |i: usize| {
        let (x, z) = (f64::from(places[i].0), f64::from(places[i].1));
        let corners = [
            (0.6 - x, 1.0 - z),
            (0.6 + x, 1.0 - z),
            (0.6 - x, 1.0 + z),
            (0.6 + x, 1.0 + z),
        ];
        corners.iter().map(|(a, b)| seen_through(*a, *b, 0.7)).sum()
    };
    assert!(largest_z(&traced, open_at) < 4.0);
}

#[test]
fn points_on_a_surface_do_not_see_it_though_they_are_rounded() {
    let corners = [(5.1, 0.3, -2.2), (4.3, 1.1, -1.7), (5.0, -0.6, -0.9)].map(Vec3::from);
    let [a, b, c] = corners;
    let plate = Mesh {
        positions: corners.to_vec(),
        normals: Vec::new(),
        triangles: vec![[0, 1, 2]],
        materials: vec![0],
    };
    // Rounded to f32, half of these points lie behind the plane.
    let weights = support::directions(500).map(|d| d * d);
    let list = points(weights.map(|w| {
        let at = a * w.x + b * w.y + c * w.z;
        point(at, (b - a).cross(c - a))
    }));
    let plate = object(Role::Receiver, plate);
    let scene = support::scene(vec![plate], vec![glowing(0.5, 0.0)]);
    let quantity = PathQuantity::AmbientOcclusion;
    let traced = trace(
        &cpu(&scene),
        &list,
        quantity,
        &FULL,
        &samples(256),
        2,
        &|_| (),
    );
    assert!(traced.mean.iter().all(|open| open == Vec3::ONE));
}

#[test]
fn emission_leaves_the_front_only_and_reflection_both_sides() {
    let corners = [(-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (1.0, -1.0)];
    let plate = quad(corners.map(|(x, z)| Vec3::new(x, 0.0, z)), 0);
    let plate = object(Role::Environment, plate);
    let both_sides = points([point(Vec3::Y, Vec3::NEG_Y), point(Vec3::NEG_Y, Vec3::Y)]);
    let of = |material| cpu(&support::scene(vec![plate.clone()], vec![material]));
    let glow = irradiance(&of(glowing(0.0, 1.0)), &both_sides, FULL, 1024);
    assert!(
        glow.mean.get(0).x > 1.0,
        "the front looks to +y: {}",
        glow.mean.get(0)
    );
    assert_eq!(glow.mean.get(1), Vec3::ZERO);

    let mut white = support::scene(vec![plate.clone()], vec![glowing(1.0, 0.0)]);
    white = under(white, 1.0);
    let reflected = irradiance(&cpu(&white), &both_sides, FULL, 1024);
    // Sky and white plate are both of radiance 1: neither side can be told from the sky.
    assert!(largest_z(&reflected, |_| std::f64::consts::PI) < 4.0);
}
