//! The coarse solution that captures may hold, against rooms whose light is known.

mod support;

use glam::Vec3;
use interreflect_cpu::{capture::cube::capture_cube, scene::CpuScene};
use interreflect_scene::{CubeImage, CubeSpec, Light, Material, Mesh, Object, Role, Scene};
use support::{cpu, glowing, lit, object, quad, sphere, under, walls};

fn radiance(scene: &CpuScene, bounces: u32) -> CubeImage {
    let spec = CubeSpec {
        bounces,
        ..CubeSpec::of_radiance(16)
    };
    let image = capture_cube(scene, Vec3::ZERO, spec);
    assert_eq!(image.spec(), spec);
    image
}

fn point_light() -> Light {
    Light::Point {
        position: Vec3::new(0.1, 0.6, -0.2),
        intensity: Vec3::splat(2.0),
        picture: None,
    }
}

#[test]
fn each_bounce_of_a_furnace_adds_a_power_of_the_albedo() {
    let (albedo, emission) = (0.7_f32, 0.4);
    let scene = cpu(&walls([glowing(albedo, emission); 6]));
    for bounces in 0..=8 {
        let left_out = albedo.powi(bounces as i32 + 1);
        let exact = emission * (1.0 - left_out) / (1.0 - albedo);
        for texel in radiance(&scene, bounces).radiance {
            // Emitters are sampled beside the cosine, and the two together see more or less than
            // the whole hemisphere by a few tenths of a per cent from 256 rays.
            assert!(
                (texel.x / exact - 1.0).abs() < 0.02,
                "{bounces}: {texel} for {exact}"
            );
        }
    }
}

#[test]
fn a_constant_sky_is_reflected_from_the_first_bounce_on() {
    let floor = [(-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (1.0, -1.0)];
    let floor = quad(floor.map(|(x, z)| Vec3::new(x, -0.5, z)), 0);
    let material = Material::diffuse(Vec3::splat(0.5));
    let scene = support::scene(vec![object(Role::Environment, floor)], vec![material]);
    let scene = cpu(&under(scene, 2.0));
    for bounces in [1, 3] {
        let image = radiance(&scene, bounces);
        let reflected = image.radiance.iter().filter(|l| l.x < 1.5);
        assert!(reflected.clone().count() > 16);
        for texel in reflected {
            // A plane sees half a sphere of sky and nothing of itself: ρ·L.
            assert!((texel.x - 1.0).abs() < 0.02, "{bounces}: {texel}");
        }
    }
}

#[test]
fn without_bounces_nothing_is_solved_and_nothing_changes() {
    let room = lit(walls([glowing(0.6, 0.1); 6]), point_light());
    let (fresh, used) = (cpu(&room), cpu(&room));
    let solved = radiance(&used, 2);
    assert_eq!(radiance(&used, 0), radiance(&fresh, 0));
    assert_ne!(solved.radiance, radiance(&fresh, 0).radiance);
    let spec = |radiance, bounces| CubeSpec {
        channels: interreflect_scene::CubeChannels {
            radiance,
            distance: true,
            normal: true,
        },
        size: 4,
        bounces,
    };
    assert!(fresh.coarse_for(&spec(true, 0)).is_none());
    assert!(fresh.coarse_for(&spec(false, 3)).is_none());
    assert!(fresh.coarse_for(&spec(true, 3)).is_some());
}

/// The same bits for any number of threads, and for a solution asked for again.
#[test]
fn threads_do_not_matter() {
    let room = lit(walls([glowing(0.6, 0.1); 6]), point_light());
    let solve = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let pool = pool.build().expect("threads");
        pool.install(|| cpu(&room).coarse_solution(3).irradiance.clone())
    };
    let (one, four) = (solve(1), solve(4));
    assert!(one == four);
    let scene = cpu(&room);
    assert!(std::sync::Arc::ptr_eq(
        &scene.coarse_solution(2),
        &scene.coarse_solution(2)
    ));
}

/// A room with a light in its +x half.
fn half_lit(divider: Mesh) -> Scene {
    let white = Material::diffuse(Vec3::splat(0.8));
    let light = Light::Point {
        position: Vec3::new(0.5, 0.1, 0.0),
        intensity: Vec3::splat(5.0),
        picture: None,
    };
    let mut scene = lit(walls([white; 6]), light);
    scene.materials.push(white);
    scene.objects.push(object(Role::Environment, divider));
    scene
}

/// Radiance around a point at x on the x axis, summed over all texels.
fn total(scene: &CpuScene, x: f32, bounces: u32) -> f32 {
    let spec = CubeSpec {
        bounces,
        ..CubeSpec::of_radiance(32)
    };
    let image = capture_cube(scene, Vec3::new(x, 0.0, 0.0), spec);
    image.radiance.iter().map(|l| l.x).sum()
}

#[test]
fn the_sides_of_a_sheet_are_lit_apart() {
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let sheet = quad(corners.map(|(y, z)| Vec3::new(0.0, y, z)), 6);
    let scene = cpu(&half_lit(sheet));
    let solution = scene.coarse_solution(1);
    let irradiance = &solution.irradiance;
    let sheet = irradiance.vertices().zip(irradiance.values());
    let sheet: Vec<_> = sheet.filter(|(v, _)| v.triangle >= 12).collect();
    assert!(sheet.len() > 50);
    for (vertex, [front, back]) in sheet {
        assert!(front.max(*back).x > 0.5, "{vertex:?}: {front} {back}");
        assert_eq!(front.min(*back), Vec3::ZERO, "{vertex:?}");
    }
    // From the second bounce on, cells of the walls that the sheet crosses leak: a strip of them,
    // an eighth of the walls wide, has vertices on the bright side.
    let (dark, bright) = (total(&scene, -0.5, 4), total(&scene, 0.5, 4));
    assert!(dark < 0.2 * bright, "{dark} beside {bright}");
}

#[test]
fn a_wall_lets_no_light_through() {
    let mut wall = support::room(Vec3::new(-0.03, -1.0, -1.0), Vec3::new(0.03, 1.0, 1.0));
    wall.materials.fill(6);
    wall.triangles.iter_mut().for_each(|t| t.swap(1, 2));
    let scene = cpu(&half_lit(wall));
    assert_eq!(total(&scene, -0.5, 1), 0.0);
    let (dark, bright) = (total(&scene, -0.5, 4), total(&scene, 0.5, 4));
    // Inside the wall, cells of the room's walls blend towards their vertices on the bright side,
    // and the vertices in there see a little of each other.
    assert!(dark < 1e-3 * bright, "{dark} beside {bright}");
    assert!(bright > total(&scene, 0.5, 1));
}

/// Receivers neither block nor reflect.
#[test]
fn receivers_are_absent() {
    let mut room = lit(walls([glowing(0.6, 0.1); 6]), point_light());
    let without = cpu(&room).coarse_solution(2).irradiance.clone();
    room.objects.insert(
        0,
        Object {
            role: Role::Receiver,
            ..object(Role::Receiver, sphere(0.4, 4, false, true))
        },
    );
    assert!(cpu(&room).coarse_solution(2).irradiance == without);
}
