use super::Folder;
use crate::motion::{CameraMotion, DeformationKind};
use crate::{Light, SceneRequest, open};
use glam::Vec3;

#[test]
fn a_scene_file_says_what_moves() {
    let folder = Folder::new(&[(
        "s.toml",
        r#"
        [camera]
        eye = [0, 0, 5]
        target = [0, 0, 0]
        [camera.motion]
        keyframes = [{ time = 0 }, { time = 2, eye = [2, 0, 5] }]
        [[mesh]]
        shape = "box"
        translate = [1, 0, 0]
        [mesh.motion]
        keyframes = [
            { time = 0 },
            { time = 1, translate = [0, 1, 0], rotate_deg = [0, 90, 0], scale = 2 },
        ]
        [[mesh]]
        shape = "torus"
        role = "receiver"
        motion = { deformation = "wave", period_s = 4, amount = 0.5 }
        [[light]]
        kind = "area"
        position = [0, 1, 0]
        normal = [0, -1, 0]
        area = 0.1
        flux = [1, 1, 1]
        motion = { keyframes = [{ time = 0, position = [0, 1, 0] }, { time = 1, normal = [2, 0, 0] }, { time = 2, position = [0, 3, 0] }] }
        [[light]]
        kind = "environment"
        constant = [1, 1, 1]
        rotate_deg = 300
        rotate_deg_per_s = 90
        "#,
    )]);
    let scene = open(&SceneRequest::new(folder.path("s.toml").to_string_lossy())).unwrap();
    let moves = scene.moves();
    assert!(moves.geometry && moves.camera && moves.lights && moves.environment);
    assert!(matches!(
        scene.motion.camera,
        Some(CameraMotion::Keyframes(_))
    ));
    let wave = scene.objects[1].motion.as_ref().unwrap().deformation;
    let wave = wave.map(|d| (d.kind, d.period_s, d.amount));
    assert_eq!(wave, Some((DeformationKind::Wave, 4.0, 0.5)));
    let at = scene.at(1.0);
    assert_eq!(at.camera.eye, Vec3::new(1.0, 0.0, 5.0));
    // Twice as large about its own centre, and moved up. 1e-5: roundings.
    let (lo, hi) = at.objects[0].mesh.bounds().unwrap();
    assert!(lo.distance(Vec3::new(0.0, 0.0, -1.0)) < 1e-5, "{lo}");
    assert!(hi.distance(Vec3::new(2.0, 2.0, 1.0)) < 1e-5, "{hi}");
    let Light::Area {
        position, normal, ..
    } = at.lights[0]
    else {
        panic!("not an area light: {:?}", at.lights);
    };
    // The keyframe that leaves out the position does not hold it.
    assert_eq!((position, normal), (Vec3::new(0.0, 2.0, 0.0), Vec3::X));
    assert_eq!(at.environment.unwrap().rotate_deg, 390.0);
}
