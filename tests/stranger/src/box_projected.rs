//! A parallax-corrected look-up of a cube map: an estimator with a rule that depends on where a point is, and
//! with a reference model of its own.

use interreflect::prelude::*;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;
use std::f32::consts::PI;

/// π times the radiance of the surface that a point's normal meets on the box around all surfaces.
#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub struct BoxProjected {
    /// Texels along a face's edge when the environment is captured.
    #[default(64)]
    #[schemars(range(min = 2, max = 256), extend("unit" = "texels"))]
    capture_resolution: u32,
}

impl BoxProjected {
    fn captured(&self) -> CubeSpec {
        CubeSpec::of_radiance(self.capture_resolution)
    }
}

impl Method for BoxProjected {
    const INFO: Info = Info {
        id: "box_projected",
        title: "Box-projected cube map",
        summary: "the radiance where the normal meets the box around the surroundings, from everywhere",
        references: &[],
        figure: None,
    };

    const QUANTITIES: &'static [Quantity] = &[Quantity::Irradiance];

    fn needs(&self, _: Quantity, scene: &SceneFacts) -> Result<Needs, Unsupported> {
        if !scene.captured_surfaces {
            return Err(Unsupported("no surfaces to project onto".into()));
        }
        Ok(Needs {
            cubes: [self.captured()].into(),
            ..Needs::default()
        })
    }

    fn model(&self, _: Quantity) -> OwnModel {
        OwnModel::Other(OtherModel(&AlongTheNormal))
    }

    fn claims(&self, _: Quantity) -> Vec<Claim> {
        vec![
            Claim::NonNegative,
            Claim::AtPoints {
                departure: from_the_wall,
                within: 1e-5,
                cause: "each point receives π times the radiance of the wall in front of it; π is rounded",
            },
        ]
    }
}

/// How far an estimate is from π times the radiance of the wall that the normal meets, among walls that are
/// planes around the point. Of a place near an edge a texel can't tell which wall it is on: 0 there.
fn from_the_wall(at: &PointEstimate<'_>) -> f64 {
    let (x, n) = (at.point.position, at.point.normal);
    let walls = at.scene.objects.iter().flat_map(|object| {
        let mesh = &object.mesh;
        (0..mesh.triangles.len()).filter_map(move |i| {
            let corner = mesh.positions[mesh.triangles[i][0] as usize];
            let distance = (corner - x).dot(mesh.normal(i)) / n.dot(mesh.normal(i));
            (distance > 0.0).then_some((distance, mesh.materials[i] as usize))
        })
    });
    let mut walls: Vec<_> = walls.collect();
    walls.sort_by(|a, b| a.0.total_cmp(&b.0));
    let Some(&(nearest, wall)) = walls.first() else {
        return f64::from(at.estimate.abs().max_element()) / at.greatest;
    };
    let next = walls.iter().find(|other| other.1 != wall);
    if next.is_some_and(|next| next.0 < 1.2 * nearest) {
        return 0.0;
    }
    let expected = PI * at.scene.materials[wall].emission;
    f64::from((at.estimate - expected).abs().max_element()) / at.greatest
}

/// π times the radiance that the surface in front of a point emits: what the method computes where the
/// surfaces fill the box around them.
struct AlongTheNormal;

impl ReferenceModel for AlongTheNormal {
    fn name(&self) -> &'static str {
        "π times the radiance emitted along the normal"
    }

    fn evaluate(
        &self,
        _: &CpuCx,
        scene: &CpuScene,
        _: Quantity,
        points: &Points,
    ) -> (Estimate, Estimate) {
        let mut values = Estimate::new(points.len());
        for (i, point) in points.iter().enumerate() {
            let Some(point) = point else { continue };
            let (origin, surroundings) = (point.position.as_dvec3(), scene.environment_objects());
            let start = surroundings.ray_start();
            let hit = scene.closest(surroundings, origin, point.normal, start);
            let lit = hit.filter(|hit| hit.front);
            values.set(i, PI * lit.map_or(Vec3::ZERO, |hit| hit.material.emission));
        }
        (values, Estimate::new(points.len()))
    }
}

impl CpuOnly for BoxProjected {
    const NO_GPU: &'static str = "this example runs on the CPU only";
}

/// The cube map.
pub struct Captured(CubeImage);

/// Index of the texel in a direction.
fn texel_towards(size: u32, direction: Vec3) -> usize {
    let (face, s, t) = cube_coordinates(direction.as_dvec3());
    let place = |s: f64| (((s + 1.0) * 0.5 * f64::from(size)) as u32).min(size - 1);
    texel_index(size, face, place(s), place(t))
}

impl Estimator<Cpu> for BoxProjected {
    type Prepared = Captured;

    fn prepare(
        &self,
        frame: &mut Frame<'_, Cpu>,
        _last: Option<Captured>,
    ) -> Result<Captured, EstimatorError> {
        Ok(Captured(frame.cube(&self.captured())?.clone()))
    }
}

impl Prepared<Cpu> for Captured {
    fn shade(&self, frame: &mut Frame<'_, Cpu>) -> Result<(), EstimatorError> {
        let (cube, Bounds { low, high }) = (&self.0, frame.scene.bounds);
        for (i, point) in frame.points.iter().enumerate() {
            let irradiance = point.map_or(Vec3::ZERO, |point| {
                // Where the normal's ray leaves the box.
                let wall = Vec3::select(point.normal.cmpgt(Vec3::ZERO), high, low);
                let along = (wall - point.position).abs() / point.normal.abs();
                let distance = along.min_element();
                let seen = point.position + distance * point.normal - frame.reference_point;
                PI * cube.radiance[texel_towards(cube.size, seen)]
            });
            frame.out.set(i, irradiance);
        }
        Ok(())
    }
}
