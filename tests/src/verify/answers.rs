//! Exact answers: scenes in which a method's own model has a closed form.

mod lit;
mod openness;
mod patches;
mod uniform;

use super::{Asked, Finding, Found, MethodUnderTest, Nothing, claimed};
use glam::DVec3;
use interreflect_estimators::{Answers, Claim, OwnModel, Quantity};
use interreflect_scene::{
    Camera, Environment, Light, Material, Mesh, Object, Point, Points, Role, Scene, SceneMotion,
};

/// A scene with an exact answer.
pub(super) struct Answer {
    pub(super) name: &'static str,
    pub(super) about: &'static str,
    kind: Answers,
    /// The scenes, each with its points and answers; `None` where the model has none there.
    settings: fn(OwnModel, Quantity) -> Option<Vec<Setting>>,
    /// What the estimates are reduced to before they are compared.
    reduce: Reduce,
}

/// How estimates are compared with answers.
#[derive(Clone, Copy, PartialEq)]
enum Reduce {
    /// Each by itself.
    Each,
    /// Their mean with the mean of the answers.
    Mean,
}

/// A scene, with points and the exact value at each, the same in every channel that the material
/// leaves alone.
struct Setting {
    scene: Scene,
    points: Vec<(Point, glam::DVec3)>,
}

/// Where a difference counts if no claim says: a twentieth.
const TRIED: f64 = 0.05;

/// All answers.
pub(super) fn all() -> Vec<Answer> {
    uniform::all()
        .into_iter()
        .chain(patches::all())
        .chain(lit::all())
        .chain(openness::all())
        .collect()
}

impl Answer {
    pub(super) fn asks(&self, claim: &Claim) -> bool {
        matches!(claim, Claim::Meets { answers, .. } if *answers == self.kind)
    }

    pub(super) fn run(&self, under_test: &MethodUnderTest<'_>) -> (Asked, Found) {
        let claim = claimed(under_test, |claim| match *claim {
            Claim::Meets {
                answers,
                within,
                cause,
            } if answers == self.kind => Some((within, cause)),
            _ => None,
        });
        let asked = match claim {
            Some(_) => Asked::Claimed,
            None => Asked::Tried,
        };
        (asked, self.found(under_test, claim.unwrap_or((TRIED, ""))))
    }

    fn found(&self, under_test: &MethodUnderTest<'_>, (bound, cause): (f64, &str)) -> Found {
        let model = under_test.model();
        let known = !matches!(model, OwnModel::Other(_));
        let settings = known.then(|| (self.settings)(model, under_test.quantity));
        let settings = settings.flatten().ok_or_else(|| {
            Nothing::NotApplicable(format!(
                "what it computes of {} has no closed form here",
                under_test.quantity.name()
            ))
        })?;
        let mut finding = Finding {
            bound,
            value: 0.0,
            ..Finding::default()
        };
        for setting in &settings {
            let (value, place) = self.worst(under_test, setting)?;
            finding.cases += setting.points.len();
            if value > finding.value || value.is_nan() {
                finding.value = value;
                finding.note = place;
            }
        }
        if !cause.is_empty() {
            finding.note = format!("{cause}; {}", finding.note);
        }
        Ok(finding)
    }

    /// Largest difference over the largest answer, and where.
    fn worst(
        &self,
        under_test: &MethodUnderTest<'_>,
        setting: &Setting,
    ) -> Result<(f64, String), Nothing> {
        let list = setting.points.iter().map(|(point, _)| Some(*point));
        let points = Points::new(under_test.quantity.layout(), list);
        let (backend, method) = (under_test.backend, under_test.method);
        let estimate = backend.estimate(&setting.scene, method, under_test.quantity, &points)?;
        let pairs = setting.points.iter().zip(estimate.iter());
        let pairs = pairs.map(|((point, exact), value)| (*point, *exact, value.as_dvec3()));
        let largest = setting.points.iter().map(|(_, e)| e.abs().max_element());
        let largest = largest.fold(0.0, f64::max);
        if self.reduce == Reduce::Mean {
            let count = setting.points.len() as f64;
            let sums = pairs.fold((DVec3::ZERO, DVec3::ZERO), |sums, (_, exact, value)| {
                (sums.0 + exact, sums.1 + value)
            });
            let (exact, value) = (sums.0.x / count, sums.1.x / count);
            return Ok((
                (value / exact - 1.0).abs(),
                format!("a mean of {value} for {exact}"),
            ));
        }
        let mut worst = (0.0, String::new());
        for (point, exact, value) in pairs {
            let apart = (value - exact).abs().max_element() / largest;
            if apart > worst.0 || apart.is_nan() {
                let (x, n) = (point.position, point.normal);
                worst = (
                    apart,
                    format!("{value} for {exact} at {x} with the normal {n}"),
                );
            }
        }
        Ok(worst)
    }
}

/// Where a closed form of what is seen is to be taken for a point: the point itself, or the reference
/// point where the surroundings count as infinitely far away. `None` for other models.
fn seen_from(model: OwnModel, x: DVec3, reference: DVec3) -> Option<DVec3> {
    match model {
        OwnModel::VisibleFromReference { .. } | OwnModel::LightTransport(_) => Some(x),
        OwnModel::EnvironmentAtInfinity { .. } => Some(reference),
        _ => None,
    }
}

/// A scene of these meshes.
fn scene(meshes: Vec<(Mesh, Material)>, reference: DVec3) -> Scene {
    let mut materials = Vec::new();
    let object = |(i, (mut mesh, material)): (usize, (Mesh, Material))| {
        materials.push(material);
        mesh.materials = vec![i as u32; mesh.triangles.len()];
        Object {
            name: "surface".into(),
            role: Role::Environment,
            mesh,
            motion: None,
        }
    };
    let objects = meshes.into_iter().enumerate().map(object).collect();
    Scene {
        name: "answer".into(),
        objects,
        materials,
        lights: Vec::<Light>::new(),
        environment: None::<Environment>,
        camera: Camera {
            eye: glam::Vec3::new(0.0, 0.0, 3.0),
            target: glam::Vec3::ZERO,
            up: glam::Vec3::Y,
            vfov_deg: 60.0,
            resolution: [16, 16],
        },
        reference_point: reference.as_vec3(),
        captured_at: None,
        motion: SceneMotion::default(),
    }
}

/// Evenly spread unit vectors.
pub(super) fn orientations(count: usize) -> impl Iterator<Item = DVec3> {
    (0..count).map(move |i| {
        let z = 1.0 - (2 * i + 1) as f64 / count as f64;
        let (sin, cos) = (2.399_963_2 * i as f64).sin_cos();
        DVec3::new((1.0 - z * z).sqrt() * cos, (1.0 - z * z).sqrt() * sin, z)
    })
}

/// Evenly spread places within six tenths of the half edges of a box.
pub(super) fn within(index: usize) -> [f32; 3] {
    // Additive recurrence with the plastic constants of three dimensions.
    let steps = [0.819_172_5, 0.671_043_6, 0.549_700_5];
    steps.map(|step| (1.2 * (0.5 + step * index as f64).fract() - 0.6) as f32)
}

/// A point with a viewer beside its normal.
fn facing(position: DVec3, normal: DVec3) -> Point {
    let view = (normal + DVec3::new(0.3, 0.5, -0.4)).normalize();
    Point {
        position: position.as_vec3(),
        normal: normal.as_vec3(),
        view: view.as_vec3(),
        material: interreflect_scene::SurfaceMaterial {
            diffuse: glam::Vec3::new(0.6, 0.5, 0.4),
            specular: glam::Vec3::new(0.2, 0.3, 0.4),
            shininess: 5.0,
        },
        ..Point::default()
    }
}
