//! The path tracer against exact answers and against itself.

use crate::ensure;
use crate::room_points::ROOM;
use crate::subjects::{ROOM_RADIANCES, SUBJECTS, Subject, box_with, inside};
use crate::world::{CPU, Outcome, ignored};
use interreflect_cpu::path_tracer::{LightPaths, PathQuantity, Stop, Traced, trace};
use interreflect_scene::{PointLayout, Points};
use libtest_mimic::Trial;
use std::f64::consts::PI;

pub(crate) fn trials() -> Vec<Trial> {
    let mut trials = vec![Trial::test("path_reference/furnace", furnace)];
    for subject in &SUBJECTS[..3] {
        for (name, quantity) in [
            ("irradiance", PathQuantity::Irradiance),
            ("glossy_radiance", PathQuantity::GlossyRadiance),
        ] {
            let name = format!("path_reference/two_seeds/{}/{name}", subject.name);
            trials.push(Trial::test(name, move || two_seeds(subject, quantity)));
        }
    }
    let name = "path_reference/room";
    trials.push(match ROOM.is_some() {
        true => Trial::test(name, room),
        false => ignored(name.into(), "../shared/points is not there"),
    });
    trials
}

fn traced(subject: &Subject, points: &Points, quantity: PathQuantity, seed: u64) -> Traced {
    let stop = Stop {
        samples: Some(1024),
        ..Stop::default()
    };
    let paths = LightPaths::default();
    CPU.install(|| trace(&subject.cpu, points, quantity, &paths, &stop, seed, &|_| {}))
}

/// Radiance 1 all around gives E = π.
fn furnace() -> Outcome {
    let subject = box_with([1.0; 6], inside(200));
    let points = subject.points(PointLayout::Surface);
    let traced = traced(&subject, &points, PathQuantity::Irradiance, 1);
    for (i, value) in traced.mean.iter().enumerate() {
        let exact = if points.get(i).is_some() { PI } else { 0.0 };
        for value in value.to_array() {
            let error = (f64::from(value) - exact).abs();
            ensure!(error <= 1e-3 * exact, "point {i}: {value} for {exact}");
        }
    }
    Ok(())
}

/// Two means part by no more than four of their common standard errors.
fn two_seeds(subject: &Subject, quantity: PathQuantity) -> Outcome {
    let points = subject.points(PointLayout::Material);
    let [a, b] = [1, 2].map(|seed| traced(subject, &points, quantity, seed));
    ensure!(a.mean != b.mean, "the seed has no effect");
    for i in 0..points.len() {
        for c in 0..3 {
            let value = |t: &Traced| f64::from(t.mean.get(i)[c]);
            let error = |t: &Traced| f64::from(t.standard_error.get(i)[c]);
            let z = (value(&a) - value(&b)) / error(&a).hypot(error(&b));
            ensure!(
                z.abs() < 4.0 || points.get(i).is_none(),
                "point {i}: z = {z:.2}"
            );
        }
    }
    Ok(())
}

/// The exact irradiances of the public point set.
fn room() -> Outcome {
    let room = ROOM.as_ref().ok_or("no point set")?;
    let subject = box_with(ROOM_RADIANCES, Vec::new());
    let traced = traced(&subject, &room.points, PathQuantity::Irradiance, 1);
    for (i, exact) in room.column("E_exact")?.iter().enumerate() {
        let (value, error) = (traced.mean.get(i).x, traced.standard_error.get(i).x);
        let z = (f64::from(value) - exact) / f64::from(error);
        ensure!(z.abs() < 4.0, "point {i}: {value} for {exact}, z = {z:.2}");
    }
    Ok(())
}
