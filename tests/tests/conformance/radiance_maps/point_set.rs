//! What each solid angle gives in float64 in the box of `tests/points/drm.toml`.

use crate::ensure;
use crate::test_scenes::{TestScene, points_file};
use crate::variants::{Outcome, cpu_scene, gpu_scene, on_gpu};
use glam::DVec3;
use interreflect_estimators::Tolerance;
use interreflect_estimators::execution::BackendScene;
use interreflect_scene::conventions::texel_centre;
use interreflect_scene::{
    Light, Needs, Point, RsmChannels, RsmImage, RsmSpec, RsmViews, SceneRequest, open,
};
use libtest_mimic::{Failed, Trial};
use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::LazyLock;

/// The point set.
struct PointSet {
    columns: BTreeMap<String, Vec<f64>>,
    points: Vec<(DVec3, DVec3)>,
    test_scene: TestScene,
    light: DVec3,
    /// Albedos of the walls +x −x +y −y +z −z.
    albedos: [f64; 6],
}

static SET: LazyLock<PointSet> = LazyLock::new(|| PointSet::open().expect("a readable point set"));

/// A solid angle: beginning of its columns, and settings.
type Column = (&'static str, &'static [(&'static str, &'static str)]);

const COLUMNS: [Column; 4] = [
    ("eq11", &[("solid_angle", "eq11")]),
    ("eq14", &[("solid_angle", "eq14")]),
    ("eq15", &[("solid_angle", "eq15")]),
    ("corrected", &[("fidelity", "corrected")]),
];

pub(super) fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    for n in [2, 3, 4, 5, 16, 64] {
        for column in COLUMNS {
            let name = format!("radiance_maps/point_set/{}_{n}x{n}", column.0);
            trials.push(Trial::test(format!("{name}/cpu"), move || {
                let set = &*SET;
                let loaded = cpu_scene(&set.test_scene);
                let views = loaded.capture(&normals(n))?.0.rsms;
                let views = views.values().next().ok_or("no views")?;
                set.check(&loaded, views, column, n)
            }));
            trials.push(on_gpu(format!("{name}/gpu"), move |context| {
                let set = &*SET;
                let loaded = gpu_scene(context, &set.test_scene)?;
                let views = loaded.capture(&normals(n))?.0.rsms;
                let views = views.values().next().ok_or("no views")?;
                set.check(&loaded, &views.download(context)?, column, n)
            }));
        }
    }
    trials
}

/// Views of n² texels that tell which walls their rays met.
fn normals(n: u32) -> Needs {
    let channels = RsmChannels {
        normal: true,
        ..RsmChannels::default()
    };
    let spec = RsmSpec {
        size: n,
        views: RsmViews::Picture,
        channels,
    };
    Needs {
        rsms: [spec].into(),
        ..Needs::default()
    }
}

/// What the light meets along the ray of a sample, and on the other wall too where the ray meets the
/// edge between two: then it is rounding that decides.
struct Met {
    walls: Vec<(usize, f64)>,
    direction: DVec3,
    /// Exact solid angle of the sample's cell in sr.
    omega_sr: f64,
}

/// Mean relative error that the corrected form keeps at 64×64: 2.0 % in float64, most of it a few
/// centimetres from the floor, and what the edges add.
const CONVERGED: f64 = 0.025;

impl PointSet {
    fn open() -> Result<Self, Failed> {
        let mut reader = csv::Reader::from_path(points_file("drm.csv"))?;
        let header = reader.headers()?.clone();
        let mut columns: BTreeMap<String, Vec<f64>> = BTreeMap::new();
        for record in reader.records() {
            for (name, value) in header.iter().zip(&record?).filter(|(n, _)| *n != "group") {
                columns.entry(name.into()).or_default().push(value.parse()?);
            }
        }
        let at = |names: [&str; 3], i: usize| DVec3::from(names.map(|n| columns[n][i]));
        let points: Vec<(DVec3, DVec3)> = (0..columns["x"].len())
            .map(|i| (at(["x", "y", "z"], i), at(["nx", "ny", "nz"], i)))
            .collect();
        let scene = open(&SceneRequest::new(
            points_file("drm.toml").to_string_lossy(),
        ))?;
        let Some(Light::Spot { position, .. }) = scene.lights.first() else {
            return Err("the scene has no spot light".into());
        };
        let light = position.as_dvec3();
        let on_host = points.iter().map(|(x, n)| {
            Some(Point {
                position: x.as_vec3(),
                normal: n.as_vec3(),
                ..Point::default()
            })
        });
        let test_scene = TestScene::new("drm-box", &scene, on_host.collect());
        let objects = test_scene.cpu.environment_objects();
        let albedo = |wall: usize| {
            let axis = [DVec3::X, DVec3::Y, DVec3::Z][wall / 2];
            let axis = if wall.is_multiple_of(2) { axis } else { -axis };
            // Off the diagonals, where triangles meet.
            let towards = axis + DVec3::new(0.11, 0.07, 0.05);
            let hit = objects
                .bvh()
                .closest(DVec3::ZERO, towards, 0.0, f64::INFINITY);
            let hit = hit.expect("a closed box");
            let surface = test_scene.cpu.surface(objects, DVec3::ZERO, towards, hit);
            f64::from(surface.material.albedo.x)
        };
        Ok(Self {
            albedos: std::array::from_fn(albedo),
            columns,
            points,
            light,
            test_scene,
        })
    }

    fn column(&self, name: &str) -> Result<&[f64], Failed> {
        let found = self.columns.get(name).map(Vec::as_slice);
        Ok(found.ok_or_else(|| format!("no column {name}"))?)
    }

    /// The estimate against a column. A sample whose ray meets the edge between two walls is given to
    /// the wall that the backend's own `views` say it met: the columns take the first.
    fn check<S: BackendScene>(
        &self,
        loaded: &S,
        views: &RsmImage,
        (column, settings): Column,
        n: u32,
    ) -> Outcome {
        let side = n.to_string();
        let mut settings = settings.to_vec();
        settings.extend([("samples_per_side", &*side), ("map_resolution", &*side)]);
        let estimate = super::shaded(loaded, &self.test_scene, &settings)?;
        let values: Vec<f64> = estimate.iter().map(|v| f64::from(v.x)).collect();
        let tolerance = Tolerance {
            absolute: 1e-7,
            relative: 5e-5,
            cause: "float32 positions, 1e-7 m, seen from 1 mm, and float32 sums",
        };
        let met = self.met(n);
        let expected = self.column(&format!("{column}_{n}x{n}"))?;
        for (i, (value, expected)) in values.iter().zip(expected).enumerate() {
            let mut expected = *expected;
            for (met, normal) in met.iter().zip(&views.normal) {
                let seen = |w: &&(usize, f64)| wall_normal(w.0).dot(normal.as_dvec3()) > 0.5;
                let seen = met.walls.iter().find(seen).ok_or("another wall")?;
                let counts = |wall| self.counts(column, n, met, wall, i);
                if seen != &met.walls[0] {
                    expected += counts(*seen) - counts(met.walls[0]);
                }
            }
            tolerance
                .check(*value, expected)
                .map_err(|e| format!("point {i}: {e}"))?;
        }
        if column == "corrected" && n == 64 {
            let exact = self.column("E_exact")?;
            let errors = values.iter().zip(exact).map(|(v, e)| (v / e - 1.0).abs());
            let mean = errors.sum::<f64>() / values.len() as f64;
            println!("mean relative error: {:.2} %", 100.0 * mean);
            ensure!(mean <= CONVERGED, "mean relative error {mean:.4}");
        }
        Ok(())
    }

    /// What the samples' rays meet, in the order of the view's texels; ties between walls go to x first, as in the columns.
    fn met(&self, n: u32) -> Vec<Met> {
        let cells = (0..n * n).map(|i| (i % n, i / n));
        let at = |(column, row): (u32, u32)| {
            let (s, t) = (texel_centre(n, column), texel_centre(n, row));
            // The view's columns run along direction × up = −x, its rows along −up = −z.
            let direction = DVec3::new(-s, -1.0, -t).normalize();
            let mut walls: Vec<(usize, f64)> = (0..3)
                .filter(|&axis| direction[axis] != 0.0)
                .map(|axis| {
                    let wall = 2 * axis + usize::from(direction[axis] < 0.0);
                    (
                        wall,
                        (direction[axis].signum() - self.light[axis]) / direction[axis],
                    )
                })
                .collect();
            walls.sort_by(|a, b| a.1.total_cmp(&b.1));
            let nearest = walls[0].1;
            walls.retain(|w| w.1 < nearest * (1.0 + 1e-9));
            walls.sort_unstable_by_key(|w| w.0);
            let corner = |a: f64, b: f64| (a * b).atan2((a * a + b * b + 1.0).sqrt());
            let h = 1.0 / f64::from(n);
            Met {
                walls,
                direction,
                omega_sr: corner(s + h, t + h) - corner(s - h, t + h) - corner(s + h, t - h)
                    + corner(s - h, t - h),
            }
        };
        cells.map(at).collect()
    }

    /// What a sample on a wall adds at a point, by the formula of a column.
    fn counts(&self, column: &str, n: u32, met: &Met, (wall, b): (usize, f64), i: usize) -> f64 {
        let normal = wall_normal(wall);
        let cos_light = -normal.dot(met.direction);
        let radiance = self.albedos[wall] / PI * cos_light / (b * b);
        let (x, surface_normal) = self.points[i];
        let r = self.light + met.direction * b - x;
        let r2 = r.length_squared();
        let cos_theta = surface_normal.dot(r.normalize()).max(0.0);
        let cos_surface = (-normal.dot(r.normalize())).max(0.0);
        let across = (2.0 * b * (FRAC_PI_2 / (2.0 * f64::from(n))).tan()).powi(2);
        let omega = match column {
            "eq11" => 2.0 * PI / f64::from(n * n),
            "eq15" => across / 12.0,
            "eq14" => {
                let area = across / cos_light;
                cos_surface * area / (area + r2)
            }
            _ => {
                let seen = met.omega_sr * b * b / cos_light * cos_surface;
                seen / (r2 + seen / PI)
            }
        };
        radiance * cos_theta * omega
    }
}

/// Unit normal of a wall, into the box.
fn wall_normal(wall: usize) -> DVec3 {
    let mut normal = DVec3::ZERO;
    normal[wall / 2] = if wall.is_multiple_of(2) { -1.0 } else { 1.0 };
    normal
}
