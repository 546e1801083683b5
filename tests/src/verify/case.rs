//! Random box scenes that shrink towards simple ones, and that JSON can hold.

use super::answers::{orientations, within};
use super::box_scene::{BoxScene, Lighting, Placement};
use glam::{DVec3, Vec3};
use interreflect_scene::{Point, SceneFacts, SurfaceMaterial};
use proptest::prelude::*;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;

/// A box scene as a few numbers, hundredths or integers, so that a counterexample is short.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// Half the box's edges, in metres.
    pub half: [f32; 3],
    /// Radiance, albedo or size of each wall, in [0, 1].
    pub walls: [f32; 6],
    /// The sky's gradient.
    pub sky: [f32; 3],
    /// Reference point, in half edges.
    pub reference: [f32; 3],
    /// Position of the lamp, in half edges.
    pub lamp: [f32; 3],
    /// Each point's position in half edges, and its normal, of any length.
    pub points: Vec<[[f32; 3]; 2]>,
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&serde_json::to_string(self).map_err(|_| fmt::Error)?)
    }
}

impl FromStr for Case {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let case: Self = serde_json::from_str(text).map_err(|e| e.to_string())?;
        let inside = |v: &[f32; 3], most: f32| v.iter().all(|c| c.abs() <= most);
        let normals = case.points.iter().all(|p| Vec3::from(p[1]) != Vec3::ZERO);
        let places = case.points.iter().all(|p| inside(&p[0], 1.0));
        let checks = [
            (case.half.iter().all(|h| *h > 0.0), "half must be above 0"),
            (
                case.walls.iter().all(|w| (0.0..=1.0).contains(w)),
                "walls must be in [0, 1]",
            ),
            (inside(&case.sky, 1.0), "sky must be in [-1, 1]"),
            (
                inside(&case.reference, 0.99) && inside(&case.lamp, 0.99),
                "reference and lamp must be in [-0.99, 0.99]",
            ),
            (
                places && !case.points.is_empty(),
                "points must be in [-1, 1]",
            ),
            (normals, "a point's normal must not be zero"),
        ];
        match checks.iter().find(|(holds, _)| !holds) {
            Some((_, wrong)) => Err((*wrong).into()),
            None => Ok(case),
        }
    }
}

/// Whole hundredths, which shrink towards zero.
fn hundredths(range: std::ops::RangeInclusive<i32>) -> impl Strategy<Value = f32> + Clone {
    range.prop_map(|v| v as f32 / 100.0)
}

/// Keeps edges of walls, whose places are round numbers, off the middles of captured texels: a ray that
/// meets an edge exactly may see either wall.
const OFF_THE_GRID: Vec3 = Vec3::new(0.003_127, -0.001_913, 0.002_371);

/// Points that each random case has.
const POINTS: std::ops::RangeInclusive<usize> = 1..=48;

impl Case {
    /// Boxes of edges up to 4 m, the reference point and points well inside.
    pub fn any() -> impl Strategy<Value = Self> {
        let within = |most: i32| prop::array::uniform3(hundredths(-most..=most));
        let normal = prop::array::uniform3((-9..=9_i32).prop_map(|v| v as f32));
        let normal = normal.prop_filter("a normal", |n| *n != [0.0; 3]);
        let point = (within(60), normal).prop_map(|(at, normal)| [at, normal]);
        (
            prop::array::uniform3(hundredths(50..=200)),
            prop::array::uniform6(hundredths(0..=100)),
            within(50),
            within(40),
            within(40),
            prop::collection::vec(point, POINTS),
        )
            .prop_map(|(half, walls, sky, reference, lamp, points)| Self {
                half,
                walls,
                sky,
                reference,
                lamp,
                points,
            })
    }

    /// One whose walls all differ, with so many points all over it.
    pub(super) fn unequal(points: usize) -> Self {
        let place = |(i, n): (usize, DVec3)| [within(i), n.as_vec3().to_array()];
        Self {
            half: [1.2, 0.9, 1.0],
            walls: [0.9, 0.3, 0.6, 0.75, 0.4, 0.5],
            sky: [0.3, -0.4, 0.2],
            reference: [0.17, -0.12, 0.26],
            lamp: [0.21, 0.33, -0.14],
            points: orientations(points).enumerate().map(place).collect(),
        }
    }

    /// The box scene with these numbers.
    pub fn box_scene(&self, lighting: Lighting) -> BoxScene {
        let half = Vec3::from(self.half);
        BoxScene {
            lighting,
            half,
            walls: self.walls.map(Vec3::splat),
            specks: false,
            reach: [1.0; 6],
            sky: self.sky.into(),
            reference: (Vec3::from(self.reference) + OFF_THE_GRID) * half,
            lamp: Vec3::from(self.lamp) * half,
            points: self
                .points
                .iter()
                .enumerate()
                .map(|(i, p)| point(i, *p, half))
                .collect(),
            placement: Placement::NONE,
        }
    }
}

/// A point with a viewer beside its normal, and one of three lobes.
fn point(index: usize, [at, normal]: [[f32; 3]; 2], half: Vec3) -> Point {
    let normal = DVec3::from(normal.map(f64::from)).normalize();
    let view = (normal + DVec3::new(0.3, 0.5, -0.4)).normalize();
    Point {
        position: Vec3::from(at) * half,
        normal: normal.as_vec3(),
        view: view.as_vec3(),
        material: SurfaceMaterial {
            diffuse: Vec3::new(0.6, 0.5, 0.4),
            specular: Vec3::new(0.2, 0.3, 0.4),
            shininess: [1.0, 5.0, 50.0][index % 3],
        },
        ..Point::default()
    }
}

/// Points that every box scene under a lighting has.
pub(super) fn facts(lighting: Lighting) -> SceneFacts {
    SceneFacts {
        captured_surfaces: true,
        any_surface: true,
        environment: lighting == Lighting::Sky,
        lights: u32::from(lighting == Lighting::Lamp),
        emitters: lighting == Lighting::Walls,
        mirrors: false,
        ..SceneFacts::default()
    }
}
