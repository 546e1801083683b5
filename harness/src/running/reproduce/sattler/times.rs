//! Time of a frame over directions and vertices: with and without filtering, at rest and deforming.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::measured_run::amount_of;
use super::super::verdict::{Amount, Trial};
use super::directions;
use super::sequence::{DEFORMING, Moment, RESTING};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::on_backend::Sequence;
use interreflect_estimators::{Configured, Quantity};
use interreflect_scene::motion::Moves;

/// How a model is shown.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Way {
    /// It deforms.
    Animated,
    /// It deforms, and only vertices about to be seen are evaluated.
    Filtered,
    /// It rests while the environment turns.
    Static,
}

const WAYS: [(Way, &str); 3] = [
    (Way::Animated, "animated"),
    (Way::Filtered, "animated, filtered"),
    (Way::Static, "static"),
];

/// A session with its times.
struct Film {
    backend: Backend,
    level: u32,
    way: Way,
    method: Box<dyn Configured>,
    running: Sequence,
    ms: Vec<f64>,
}

/// A model's sessions.
struct Column {
    model: String,
    vertices: usize,
    films: Vec<Film>,
}

impl Column {
    fn time(&self, backend: Backend, level: u32, way: Way) -> Amount {
        let same = |f: &&Film| (f.backend, f.level, f.way) == (backend, level, way);
        let film = self.films.iter().find(same);
        film.map_or(Amount::exact(f64::NAN), |f| amount_of(&f.ms))
    }
}

pub(super) fn run(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    let models: &[&str] = context.pick(&["dragon", "bunny"], &["dragon", "buddha", "bunny"]);
    let mut table = Vec::new();
    for name in models {
        let column = column(context, name, &mut finding)?;
        for film in &column.films {
            note(context, &column, film, &mut finding);
        }
        table.push(column);
    }
    for backend in context.backends() {
        judge(levels(context), backend, &table, &mut finding);
    }
    Ok(finding)
}

fn levels(context: &ExperimentContext<'_>) -> &'static [u32] {
    context.pick(&[0, 1], &[0, 1, 2, 3])
}

fn column(
    context: &ExperimentContext<'_>,
    name: &str,
    finding: &mut Finding,
) -> Result<Column, RunError> {
    let model = context.mesh(name);
    let place = ExperimentScene::of("studio")
        .with(&model)
        .set("receiver.deformation", "wave")
        .set("environment.turn_deg_per_s", 30);
    let rest = context.scene(&place, finding)?;
    let mut films = Vec::new();
    for backend in context.backends() {
        for &level in levels(context) {
            for (way, _) in WAYS {
                films.push(film(context, backend, level, way)?);
            }
        }
    }
    let resting = Moment::of(context, &rest, 0.0)?;
    let turning = Moves {
        environment: true,
        ..RESTING
    };
    for index in 0..=context.pick(4_u8, 12) {
        let moment = Moment::of(context, &rest, f32::from(index) / 15.0)?;
        for film in &mut films {
            let (shown, moves) = match film.way {
                Way::Static => (&resting, turning),
                Way::Animated | Way::Filtered => (&moment, DEFORMING),
            };
            let (on, of) = ((&mut film.running, film.backend), Quantity::Irradiance);
            let shaded = shown.shade_as(context, on, (&*film.method, of), moves)?;
            // The first frame warms up, and a resting model's has all its directions to do.
            if index > 0 {
                film.ms.push(shaded.ms);
            }
        }
    }
    Ok(Column {
        model: model.name,
        vertices: rest.objects.iter().map(|o| o.mesh.positions.len()).sum(),
        films,
    })
}

fn film(
    context: &ExperimentContext<'_>,
    backend: Backend,
    level: u32,
    way: Way,
) -> Result<Film, RunError> {
    let filter = match way {
        Way::Filtered => "triangles",
        Way::Animated | Way::Static => "none",
    };
    let method = context.method(
        "directional_ao",
        &[
            ("level", &level),
            ("map_resolution", &context.pick(64, 256)),
            ("filter", &filter),
        ],
    )?;
    Ok(Film {
        backend,
        level,
        way,
        method,
        running: Sequence::default(),
        ms: Vec::new(),
    })
}

fn note(context: &ExperimentContext<'_>, column: &Column, film: &Film, finding: &mut Finding) {
    let (model, vertices, k) = (&column.model, column.vertices, directions(film.level));
    let case = format!("{model}, {vertices} vertices, k = {k}");
    let names = WAYS.iter().filter(|(way, _)| *way == film.way);
    for (_, name) in names {
        let unit = ("ms", context.software(film.backend));
        finding.time((&*case, *name), film.backend, amount_of(&film.ms), unit);
    }
}

fn judge(levels: &[u32], backend: Backend, table: &[Column], finding: &mut Finding) {
    let mut less = |claim: &'static str, what: String, a: Amount, b: Amount| {
        finding.judge(claim, [Trial::less(what, backend, a, b)]);
    };
    for column in table {
        let (model, time) = (&column.model, |l, way| column.time(backend, l, way));
        for pair in levels.windows(2) {
            let [fewer, more] = [pair[0], pair[1]];
            let what = format!(
                "{model}: {} directions below {}, ms",
                directions(fewer),
                directions(more)
            );
            less(
                "C1",
                what,
                time(fewer, Way::Animated),
                time(more, Way::Animated),
            );
        }
        for &level in levels {
            let (k, animated) = (directions(level), time(level, Way::Animated));
            let what = format!("{model}, k = {k}: filtered below unfiltered, ms");
            less("C3", what, time(level, Way::Filtered), animated);
            let what = format!("{model}, k = {k}: static below animated, ms");
            less("C4", what, time(level, Way::Static), animated);
        }
    }
    let fewest = table.iter().min_by_key(|c| c.vertices);
    let most = table.iter().max_by_key(|c| c.vertices);
    if let (Some(few), Some(many)) = (fewest, most) {
        for &level in levels {
            let k = directions(level);
            let what = format!(
                "k = {k}: {} vertices below {}, ms",
                few.vertices, many.vertices
            );
            let time = |column: &Column| column.time(backend, level, Way::Animated);
            less("C2", what, time(few), time(many));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::signs;
    use super::*;
    use interreflect_estimators::Registry;

    /// A model whose frame takes these times at levels 0 and 1: animated, filtered, static.
    fn column(model: &str, vertices: usize, ms: [[f64; 3]; 2]) -> Column {
        let registry = Registry::builtin();
        let entry = registry.get("directional_ao").expect("a built-in method");
        let film = |level: usize, way: usize| Film {
            backend: Backend::Cpu,
            level: level as u32,
            way: WAYS[way].0,
            method: entry.configure(),
            running: Sequence::default(),
            ms: vec![ms[level][way]; 3],
        };
        let films = (0..6).map(|i| film(i / 3, i % 3)).collect();
        Column {
            model: model.into(),
            vertices,
            films,
        }
    }

    #[test]
    fn time_rises_with_directions_and_vertices_and_falls_by_lists_and_rest() {
        let judged = |small: [[f64; 3]; 2], large: [[f64; 3]; 2]| {
            let mut finding = Finding::default();
            let table = [column("large", 900, large), column("small", 90, small)];
            judge(&[0, 1], Backend::Cpu, &table, &mut finding);
            ["C1", "C2", "C3", "C4"].map(|claim| signs(finding.trials_of(claim)))
        };
        let (small, large) = (
            [[3.0, 2.0, 1.0], [6.0, 5.0, 4.0]],
            [[7.0, 6.0, 5.0], [9.0, 8.0, 7.0]],
        );
        assert_eq!(judged(small, large), ["++", "++", "++++", "++++"]);
        // More directions faster, lists and rest slower, and fewer vertices slower.
        let (slow, fast) = (
            [[6.0, 7.0, 8.0], [5.0, 6.0, 7.0]],
            [[3.0, 4.0, 5.0], [2.0, 3.0, 4.0]],
        );
        assert_eq!(judged(slow, fast), ["--", "--", "----", "----"]);
    }
}
