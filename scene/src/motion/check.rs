//! What keeps a motion from giving a valid scene at every time.

use super::{CameraMotion, LightMotion, Motion, Pose, SceneMotion};
use crate::validate::{LARGEST_COORDINATE, SMALLEST_EXTENT, is_near, is_unit};
use crate::{Camera, Light, Mesh, Scene};
use glam::{DVec3, Vec3};

/// What a motion lets a mesh become, from its size at rest.
pub(crate) fn mesh_fault(mesh: &Mesh, motion: &Motion) -> Option<String> {
    if !motion.poses.is_ordered() {
        return Some("times of its motion do not increase".into());
    }
    let [least, most] = Pose::SCALES;
    let unsound = |pose: &Pose| {
        !pose.translate.is_finite()
            || !pose.rotate.is_normalized()
            || !(least..=most).contains(&pose.scale)
    };
    if let Some((time, pose)) = motion.poses.keys.iter().find(|(_, pose)| unsound(pose)) {
        return Some(format!("its pose at {time} s is not usable: {pose:?}"));
    }
    if let Some(d) = motion.deformation {
        let amounts = 0.0..=d.kind.largest_amount();
        let period = d.period_s.is_finite() && d.period_s > 0.0;
        if !(period && amounts.contains(&d.amount)) {
            return Some(format!("its deformation is not usable: {d:?}"));
        }
    }
    let (lo, hi) = mesh.bounds()?;
    let (centre, half) = (0.5 * lo + 0.5 * hi, 0.5 * hi - 0.5 * lo);
    // The largest wave moves by four times half the longest side, so a vertex is within
    // √3 + 4 < 6 of it from the centre.
    let widest = motion.deformation.map_or(2.0, |_| 6.0) * half.max_element();
    let scales = motion.poses.keys.iter().map(|(_, pose)| pose.scale);
    let far = motion.poses.keys.iter().find(|(_, pose)| {
        let middle = (centre + pose.translate).abs().max_element();
        middle + widest * pose.scale > LARGEST_COORDINATE
    });
    if let Some((time, _)) = far {
        return Some(format!(
            "its motion takes it beyond ±{LARGEST_COORDINATE:e} m at {time} s"
        ));
    }
    // Breathing halves it, and a box of some length has a corner at more than a quarter of it.
    scales
        .chain([1.0])
        .any(|scale| half.max_element() * scale < 4.0 * SMALLEST_EXTENT)
        .then(|| format!("its motion makes it smaller than {SMALLEST_EXTENT:e} m"))
}

/// What is wrong with the motion of camera, lights or environment.
pub(crate) fn scene_fault(scene: &Scene) -> Option<String> {
    let SceneMotion {
        camera,
        lights,
        environment_deg_per_s: speed,
    } = &scene.motion;
    if !speed.is_finite() {
        return Some(format!("the environment turns by {speed}° per second"));
    }
    if lights.len() > scene.lights.len() {
        let (motions, lights) = (lights.len(), scene.lights.len());
        return Some(format!("{motions} motions for {lights} lights"));
    }
    let light = scene
        .lights
        .iter()
        .zip(lights)
        .position(|(l, m)| !lights_up(l, m));
    if let Some(i) = light {
        return Some(format!(
            "the motion of light {i} is not usable: {:?}",
            lights[i]
        ));
    }
    camera_fault(&scene.camera, camera.as_ref()?)
}

fn lights_up(light: &Light, motion: &LightMotion) -> bool {
    let (placed, directed) = match light {
        Light::Point { .. } => (true, false),
        Light::Directional { .. } => (false, true),
        Light::Spot { .. } | Light::Area { .. } => (true, true),
    };
    let LightMotion {
        position,
        direction,
    } = motion;
    position.is_ordered()
        && direction.is_ordered()
        && (placed || position.keys.is_empty())
        && (directed || direction.keys.is_empty())
        && position.keys.iter().all(|(_, p)| is_near(*p))
        && direction.keys.iter().all(|(_, d)| is_unit(*d))
}

/// Smallest sine of the angle between view and upward direction that a motion may reach, relative to
/// the longest distance between eye and target: below it the image's horizontal axis is rounding.
const LEAST_ACROSS: f64 = 1e-6;

/// What is wrong with a camera's motion.
pub(crate) fn camera_fault(camera: &Camera, motion: &CameraMotion) -> Option<String> {
    let track = match motion {
        CameraMotion::Orbit { deg_per_s } if deg_per_s.is_finite() => {
            // The orbit stays within this distance of the target.
            let reach = camera.target.abs().max_element() + camera.eye.distance(camera.target);
            return (reach > LARGEST_COORDINATE)
                .then(|| format!("the camera's orbit leaves ±{LARGEST_COORDINATE:e} m"));
        }
        CameraMotion::Orbit { deg_per_s } => {
            return Some(format!("the camera turns by {deg_per_s}° per second"));
        }
        CameraMotion::Keyframes(track) => track,
    };
    if !track.is_ordered() {
        return Some("times of the camera's motion do not increase".into());
    }
    let far = |[eye, target]: [Vec3; 2]| !(is_near(eye) && is_near(target));
    if let Some((time, _)) = track.keys.iter().find(|(_, at)| far(*at)) {
        return Some(format!(
            "the camera is beyond ±{LARGEST_COORDINATE:e} m at {time} s"
        ));
    }
    let view = |[eye, target]: [Vec3; 2]| target.as_dvec3() - eye.as_dvec3();
    // Eye and target go linearly, and so does the view's part across `up`: a segment that must not
    // meet the origin.
    let across = |at: [Vec3; 2]| view(at).cross(camera.up.as_dvec3());
    let last = track.keys.last().map(|key| [*key, *key]);
    let mut pairs = track.keys.windows(2).map(|p| [p[0], p[1]]).chain(last);
    let lost = pairs.find(|[(_, a), (_, b)]| {
        let longest = view(*a).length().max(view(*b).length());
        nearest_to_origin(across(*a), across(*b)) <= LEAST_ACROSS * longest
    });
    lost.map(|[(from, _), (to, _)]| match from == to {
        true => format!("the camera has no valid view at {from} s: eye and target coincide, or `up` is parallel to the view direction"),
        false => format!("the camera has no valid view at some time from {from} s to {to} s: it passes through its target, or `up` becomes parallel to the view direction"),
    })
}

/// Distance of a segment from the origin.
fn nearest_to_origin(a: DVec3, b: DVec3) -> f64 {
    let along = b - a;
    let t = match along.length_squared() {
        0.0 => 0.0,
        square => (-a.dot(along) / square).clamp(0.0, 1.0),
    };
    (a + along * t).length()
}
