//! The points of `tests/points/room.csv` with their columns.

use crate::test_scenes::{ROOM_ORIGIN, TestScene, points_file};
use glam::Vec3;
use interreflect_scene::{Point, PointLayout, Points, SceneRequest, open};
use libtest_mimic::Failed;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// The point set.
pub(crate) struct Room {
    pub(crate) points: Points,
    /// Group of each point.
    pub(crate) groups: Vec<String>,
    columns: BTreeMap<String, Vec<f64>>,
    /// The text with the table of means.
    pub(crate) readme: String,
    pub(crate) test_scene: TestScene,
}

/// The point set.
pub(crate) static ROOM: LazyLock<Room> =
    LazyLock::new(|| Room::open().expect("a readable point set"));

impl Room {
    fn open() -> Result<Self, Failed> {
        let mut reader = csv::Reader::from_path(points_file("room.csv"))?;
        let header = reader.headers()?.clone();
        let mut columns: BTreeMap<String, Vec<f64>> = BTreeMap::new();
        let mut groups = Vec::new();
        for record in reader.records() {
            for (name, value) in header.iter().zip(&record?) {
                match name {
                    "group" => groups.push(value.to_owned()),
                    _ => columns.entry(name.into()).or_default().push(value.parse()?),
                }
            }
        }
        let at = |names: [&str; 3], i: usize| Vec3::from(names.map(|n| columns[n][i] as f32));
        let points = (0..groups.len()).map(|i| {
            Some(Point {
                position: at(["x", "y", "z"], i),
                normal: at(["nx", "ny", "nz"], i).normalize(),
                ..Point::default()
            })
        });
        let points = Points::new(PointLayout::Surface, points);
        let scene = open(&SceneRequest {
            reference_point: Some(ROOM_ORIGIN),
            ..SceneRequest::new(points_file("room.obj").to_string_lossy())
        })?;
        Ok(Self {
            points,
            groups,
            columns,
            readme: std::fs::read_to_string(points_file("README.md"))?,
            test_scene: TestScene::new("room", &scene, Vec::new()),
        })
    }

    /// A column by its name.
    pub(crate) fn column(&self, name: &str) -> Result<&[f64], Failed> {
        let found = self.columns.get(name).map(Vec::as_slice);
        Ok(found.ok_or_else(|| format!("no column {name}"))?)
    }

    /// Mean of a value over each group.
    pub(crate) fn means(&self, value: impl Fn(usize) -> f64) -> Vec<(&str, f64)> {
        let mut groups: Vec<&str> = self.groups.iter().map(String::as_str).collect();
        groups.dedup();
        let mean = |group: &str| {
            let members = || (0..self.groups.len()).filter(|&i| self.groups[i] == group);
            members().map(&value).sum::<f64>() / members().count() as f64
        };
        groups.into_iter().map(|g| (g, mean(g))).collect()
    }
}
