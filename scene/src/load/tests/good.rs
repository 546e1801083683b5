use super::{Folder, TRIANGLE, shared};
use crate::{Camera, Light, Role, Scene, SceneRequest, SpotShape, open, open_points};
use glam::Vec3;
use std::path::{Path, PathBuf};

fn open_path(path: &Path) -> Scene {
    open(&SceneRequest::new(path.to_string_lossy())).unwrap()
}

#[test]
fn a_scene_file_says_what_it_says() {
    let folder = Folder::new(&[
        ("t.obj", TRIANGLE),
        (
            "s.toml",
            r#"
            reference_point = [1, 2, 3]
            captured_at = [1, 2, 2]
            [camera]
            eye = [0, 0, 5]
            target = [0, 0, 0]
            [[mesh]]
            file = "t.obj"
            fit = 4.0
            rotate_deg = [90, 0, 90]
            scale = 0.5
            translate = [10, 0, 0]
            material = { emission = [1, 2, 3], mirror = true }
            [[mesh]]
            shape = "blob"
            role = "receiver"
            [[light]]
            kind = "spot"
            position = [0, 1, 0]
            direction = [0, -2, 0]
            shape = "square"
            angle_deg = 90
            flux = [2.0943951, 0, 0]
            [[light]]
            kind = "point"
            position = [0, 1, 0]
            flux = [12.566371, 0, 0]
            [[light]]
            kind = "spot"
            position = [0, 1, 0]
            direction = [0, -1, 0]
            angle_deg = 120
            flux = [3.1415927, 0, 0]
            [[light]]
            kind = "environment"
            constant = [1, 1, 1]
            scale = 2
            "#,
        ),
    ]);
    let scene = open_path(&folder.path("s.toml"));
    assert_eq!(
        (scene.name.as_str(), scene.reference_point),
        ("s", Vec3::new(1.0, 2.0, 3.0))
    );
    assert_eq!(scene.captured_at, Some(Vec3::new(1.0, 2.0, 2.0)));
    for (keep_within_m, z) in [(0.0, 3.0), (0.5, 3.0), (1.0, 2.0)] {
        let origin = scene.capture_origin(keep_within_m);
        assert_eq!(origin, Vec3::new(1.0, 2.0, z), "{keep_within_m}");
    }
    assert_eq!(
        scene.objects.iter().map(|o| o.role).collect::<Vec<_>>(),
        [Role::Environment, Role::Receiver]
    );
    // Corner (1, 0, 0) is (2, −2, 0) when fitted, (2, 0, −2) turned by 90° about x, then
    // (0, 2, −2) about z, halved and moved. 1e-5: roundings of unit rotations of numbers near 10.
    let corner = scene.objects[0].mesh.positions[1];
    assert!(
        corner.distance(Vec3::new(10.0, 1.0, -1.0)) < 1e-5,
        "{corner}"
    );
    let material = scene.materials[scene.objects[0].mesh.materials[0] as usize];
    assert!(
        material.mirror
            && material.specular == Vec3::ONE
            && material.emission == Vec3::new(1.0, 2.0, 3.0)
    );
    let Light::Spot {
        direction,
        up,
        shape,
        intensity,
        ..
    } = scene.lights[0]
    else {
        panic!("not a spot light: {:?}", scene.lights);
    };
    assert_eq!(
        (direction, up, shape),
        (Vec3::NEG_Y, Vec3::Z, SpotShape::Square)
    );
    // A square frustum of 90° is a sixth of the sphere, 2π/3 sr; a point light fills it with its 4π sr,
    // a cone of 120° has π sr.
    assert!((intensity.x - 1.0).abs() < 1e-6);
    for light in &scene.lights[1..] {
        let (Light::Point { intensity, .. } | Light::Spot { intensity, .. }) = light else {
            panic!("neither a point nor a spot light: {light:?}");
        };
        assert!((intensity.x - 1.0).abs() < 1e-6, "{light:?}");
    }
    assert_eq!(
        scene.environment.unwrap().radiance(Vec3::X),
        Vec3::splat(2.0)
    );
}

#[test]
fn meshes_keep_materials_and_lose_what_has_no_area() {
    let folder = Folder::new(&[
        (
            "m.mtl",
            "newmtl a\nKd 0.5 0.25 0\nKs 0.1 0.1 0.1\nNs 7\nnewmtl b\nKe 1 2 3\n",
        ),
        (
            "a.obj",
            "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nf 1 2 5\nl 1 2 3\n\
             usemtl a\nf 1 2 3 4\nusemtl\tb\nf -5 -4 -3\no other\n f 1 2 5\n",
        ),
    ]);
    let scene = open_path(&folder.path("a.obj"));
    let mesh = &scene.objects[0].mesh;
    assert_eq!(mesh.triangles.len(), 3);
    assert!(mesh.normals.is_empty());
    let materials: Vec<_> = mesh
        .materials
        .iter()
        .map(|m| scene.materials[*m as usize])
        .collect();
    assert_eq!(materials[0].albedo, Vec3::new(0.5, 0.25, 0.0));
    assert_eq!(
        (materials[1].specular, materials[1].shininess),
        (Vec3::splat(0.1), 7.0)
    );
    assert_eq!(materials[2].emission, Vec3::new(1.0, 2.0, 3.0));
}

#[test]
fn receivers_get_smooth_normals_and_the_middle_of_the_scene() {
    let folder = Folder::new(&[(
        "cube.obj",
        "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\n\
         f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n",
    )]);
    let cube = folder.path("cube.obj");
    let scene = open(&SceneRequest {
        receivers: vec![cube.to_string_lossy().into()],
        reference_point: None,
        ..SceneRequest::new(cube.to_string_lossy())
    })
    .unwrap();
    let receiver = &scene.objects_of(Role::Receiver).next().unwrap().mesh;
    assert_eq!(receiver.positions.len(), 8);
    for (p, n) in receiver.positions.iter().zip(&receiver.normals) {
        // Weighted by angle a cube's corner normals are its diagonals, however faces are cut; by
        // area they would not be.
        assert!(n.dot((*p - Vec3::ONE).normalize()) > 1.0 - 1e-6);
    }
    let (lo, hi) = receiver.bounds().unwrap();
    assert!(
        (hi - lo - Vec3::splat(0.6)).abs().max_element() < 1e-6,
        "0.3 of the shortest side"
    );
    assert!(scene.reference_point.distance(Vec3::ONE) < 1e-6);
}

#[test]
fn points_come_with_unit_directions() {
    let folder = Folder::new(&[(
        "p.csv",
        "group, nx, ny, nz, x, y, z, vx, vy, vz\na,0,3,0,1,2,3,1e-30,0,0\nb,1e30,0,0,4,5,6,0,0,-2\n",
    )]);
    let points = open_points(&folder.path("p.csv")).unwrap();
    assert_eq!(points.len(), 2);
    assert_eq!(
        (points[0].position, points[0].normal),
        (Vec3::new(1.0, 2.0, 3.0), Vec3::Y)
    );
    assert_eq!(
        (points[0].view, points[1].normal, points[1].view),
        (Vec3::X, Vec3::X, Vec3::NEG_Z)
    );
}

/// An image of 8 × 4 texels, black but for one.
#[test]
fn the_measured_box_is_framed_as_published() {
    let Some(path) = shared("assets/scenes/cornell_measured.obj") else {
        return;
    };
    let Camera {
        eye,
        target,
        vfov_deg,
        ..
    } = open_path(&path).camera;
    // Its camera is at (278, 273, −800); the box is 559 deep: 3 % of the distance.
    assert!(
        eye.distance(Vec3::new(278.0, 273.0, -800.0)) < 24.0,
        "{eye}"
    );
    assert!((target - eye).normalize().z > 0.999 && vfov_deg == 39.3077);
    let request = SceneRequest {
        receivers: vec!["sphere".into()],
        ..SceneRequest::new(path.to_string_lossy())
    };
    assert_eq!(
        open(&request).unwrap().camera.eye,
        eye,
        "a receiver does not move the camera"
    );
}

/// A file of the points with known answers.
fn known(name: &str) -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/points")).join(name)
}

/// The camera of a scene file without one looks into a room, and at a model from outside.
fn looks_from(path: &Path, inside: bool) {
    let scene = open_path(path);
    let (lo, hi) = scene.objects[0].mesh.bounds().unwrap();
    let eye = scene.camera.eye;
    let is_inside = eye.cmpge(lo).all() && eye.cmple(hi).all();
    let path = path.display();
    assert_eq!(is_inside, inside, "{path}: eye {eye} of {lo} to {hi}");
}

#[test]
fn scenes_and_points_with_known_answers_load() {
    for name in ["room.obj", "drm.toml"] {
        looks_from(&known(name), true);
    }
    for (name, count) in [("room.csv", 884), ("drm.csv", 21)] {
        let points = open_points(&known(name)).unwrap();
        assert_eq!(points.len(), count, "{name}");
    }
}

#[test]
fn shared_scenes_load() {
    for (name, inside) in [
        ("assets/scenes/sponza_34k.obj", true),
        ("assets/meshes/bunny.obj", false),
    ] {
        if let Some(path) = shared(name) {
            looks_from(&path, inside);
        }
    }
}

#[test]
fn lights_take_their_pictures_where_they_are_told() {
    let light = |keys: &str| {
        let text = format!("[[mesh]]\nshape = \"quad\"\n[[light]]\nposition = [0, 2, 0]\n{keys}");
        let folder = Folder::new(&[("s.toml", &*text)]);
        open_path(&folder.path("s.toml")).lights[0]
    };
    let Light::Point { picture, .. } = light("kind = \"point\"\nintensity = [1, 1, 1]\n") else {
        panic!("not a point light");
    };
    assert_eq!(picture, None);
    let Light::Area { picture, .. } = light(
        "kind = \"area\"\nnormal = [0, -1, 0]\narea = 1\nflux = [1, 1, 1]\n\
         picture_direction = [2, 0, 0]\npicture_up = [1, 0, 3]\npicture_angle_deg = 60\n",
    ) else {
        panic!("not an area light");
    };
    let picture = picture.expect("a picture");
    assert_eq!(
        (picture.direction, picture.up, picture.angle_deg),
        (Vec3::X, Vec3::Z, 60.0)
    );
}
