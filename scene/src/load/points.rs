//! Points to be probed, from a CSV file.

use super::text;
use crate::{Place, Point, SceneError};
use glam::{DVec3, Vec3};
use std::path::Path;

/// Reads points from a CSV file with a header. Columns are found by name: `x`, `y`, `z` in metres
/// and `nx`, `ny`, `nz`, the normal; `vx`, `vy`, `vz`, the direction to the viewer, are optional;
/// others are ignored. Normals and directions are normalised. The material is left at zero.
///
/// # Errors
/// [`SceneError`] naming file and line for a missing or doubled column, a value that is no finite
/// number, a direction of length zero, or a file without points.
pub fn open_points(path: &Path) -> Result<Vec<Point>, SceneError> {
    let text = text::read(path)?;
    let source = Source { path, text: &text };
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let header = reader.headers().map_err(|e| source.broken(&e))?.clone();
    let columns = Columns::find(&source, &header)?;
    let mut points = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|e| source.broken(&e))?;
        let row = Row {
            source: &source,
            record: &record,
        };
        points.push(Point {
            position: row.finite(["x", "y", "z"], columns.position)?.as_vec3(),
            normal: row.unit(["nx", "ny", "nz"], columns.normal)?,
            view: match columns.view {
                Some(view) => row.unit(["vx", "vy", "vz"], view)?,
                None => Vec3::ZERO,
            },
            ..Point::default()
        });
    }
    match points.is_empty() {
        true => Err(Place::file(path).error(
            "there are no points in it",
            "add a line per point below the header",
        )),
        false => Ok(points),
    }
}

/// The file that points come from.
struct Source<'a> {
    path: &'a Path,
    text: &'a str,
}

impl Source<'_> {
    /// The line of a record. Its position is that of the empty lines before it: they are counted.
    fn at(&self, record: Option<&csv::Position>) -> Place {
        let line = record.map(|position| {
            let rest = self.text.as_bytes().iter().skip(position.byte() as usize);
            let empty = rest.take_while(|b| matches!(b, b'\r' | b'\n'));
            position.line() as usize + empty.filter(|b| **b == b'\n').count()
        });
        Place {
            file: self.path.into(),
            line,
        }
    }

    fn broken(&self, error: &csv::Error) -> SceneError {
        let place = self.at(error.position());
        match error.kind() {
            csv::ErrorKind::UnequalLengths {
                expected_len, len, ..
            } => place.error(
                format!("{len} values, but the header has {expected_len}"),
                "give one value per column",
            ),
            _ => place.error(
                format!("not readable as CSV: {error}"),
                "save it as UTF-8 text with commas",
            ),
        }
    }
}

struct Columns {
    position: [usize; 3],
    normal: [usize; 3],
    view: Option<[usize; 3]>,
}

impl Columns {
    fn find(source: &Source<'_>, header: &csv::StringRecord) -> Result<Self, SceneError> {
        let place = || source.at(header.position());
        let find = |name: &str| -> Result<Option<usize>, SceneError> {
            let mut found = header.iter().enumerate().filter(|(_, h)| *h == name);
            let first = found.next().map(|(i, _)| i);
            match found.next() {
                Some(_) => Err(place().error(
                    format!("column `{name}` is there twice"),
                    "remove or rename one",
                )),
                None => Ok(first),
            }
        };
        let need = |name: &str| {
            find(name)?.ok_or_else(|| {
                let remedy = "name the columns x,y,z,nx,ny,nz and optionally vx,vy,vz";
                place().error(format!("column `{name}` is missing"), remedy)
            })
        };
        let with_view = ["vx", "vy", "vz"].map(find);
        let any_view = with_view.iter().any(|c| !matches!(c, Ok(None)));
        Ok(Self {
            position: [need("x")?, need("y")?, need("z")?],
            normal: [need("nx")?, need("ny")?, need("nz")?],
            view: match any_view {
                true => Some([need("vx")?, need("vy")?, need("vz")?]),
                false => None,
            },
        })
    }
}

struct Row<'a> {
    source: &'a Source<'a>,
    record: &'a csv::StringRecord,
}

impl Row<'_> {
    fn error(&self, what: String, remedy: &str) -> SceneError {
        self.source.at(self.record.position()).error(what, remedy)
    }

    /// Three finite numbers, each within the range of f32.
    fn finite(&self, names: [&str; 3], columns: [usize; 3]) -> Result<DVec3, SceneError> {
        let mut vector = [0.0; 3];
        for i in 0..3 {
            let text = &self.record[columns[i]];
            vector[i] = match text.parse::<f64>() {
                Ok(v) if (v as f32).is_finite() => v,
                _ => {
                    let what = format!("{} is `{text}`", names[i]);
                    return Err(self.error(what, "give a finite number"));
                }
            };
        }
        Ok(DVec3::from(vector))
    }

    fn unit(&self, names: [&str; 3], columns: [usize; 3]) -> Result<Vec3, SceneError> {
        let v = self.finite(names, columns)?;
        // By the largest component first, so that no square under- or overflows.
        (v / v.abs().max_element())
            .try_normalize()
            .map(|n| n.as_vec3())
            .ok_or_else(|| {
                self.error(
                    format!("{} is {v}", names.join(",")),
                    "give a direction of non-zero length",
                )
            })
    }
}
