//! Scenes in motion, and requests that a scene can't follow.

use super::opened;
use crate::library::library;
use crate::{SceneRequest, open};

#[test]
fn every_moving_scene_is_sound_at_every_time() {
    for scene in library() {
        let mut set = vec![("camera.orbit_deg_per_s", "30")];
        let still = opened(scene.name, &[], None);
        let turns = ("environment.turn_deg_per_s", "-20");
        set.extend(still.environment.is_some().then_some(turns));
        let names: Vec<_> = scene.settings().iter().map(|(info, _)| info.name).collect();
        for deformation in ["twist", "wave", "breathe"] {
            let mut set = set.clone();
            if names.contains(&"receiver.deformation") {
                set.push(("receiver.deformation", deformation));
            }
            let scene = opened(scene.name, &set, None);
            assert_eq!(scene.at(0.0), scene);
            for time_s in [0.5, 1.3] {
                scene.at(time_s).validate().unwrap();
            }
            let moves = scene.moves();
            assert!(moves.camera && !moves.lights, "{}", scene.name);
            assert_eq!(moves.environment, scene.environment.is_some());
            // The Cornell box has a receiver only if one is asked for.
            let receives = names.contains(&"receiver.deformation");
            assert_eq!(moves.geometry, receives && scene.name != "cornell-box");
        }
    }
}

#[test]
fn what_cannot_be_set_in_motion_or_received_is_refused() {
    let refused = |set: &[(&str, &str)], receivers: &[&str], name: &str| {
        let set = set
            .iter()
            .map(|(n, v)| ((*n).into(), (*v).into()))
            .collect();
        let receivers = receivers.iter().map(|r| (*r).into()).collect();
        let request = SceneRequest {
            set,
            receivers,
            ..SceneRequest::new(name)
        };
        open(&request).unwrap_err().to_string()
    };
    assert_eq!(
        refused(&[("environment.turn_deg_per_s", "5")], &[], "furnace"),
        "scene `furnace`: it has no environment that could turn; leave out \
         scene.environment.turn_deg_per_s, or give it an environment"
    );
    assert_eq!(
        refused(&[], &["blob", "torus"], "furnace"),
        "scene `furnace`: it takes 1 receiver, not 2; leave out `--receiver`, or name fewer"
    );
    assert_eq!(
        refused(&[], &["blob"], "cave"),
        "scene `cave`: it takes no receiver; leave out `--receiver`, or name fewer"
    );
    assert!(refused(&[], &["blob"; 3], "dragons").contains("it takes 2 receivers, not 3"));
    let unknown = refused(&[("camera.orbit", "5")], &[], "pit");
    assert!(
        unknown.contains("did you mean `camera.orbit_deg_per_s`?"),
        "{unknown}"
    );
}
