//! Vertices that are evaluated once the camera sees them: by visible triangles all is as without a
//! filter, by visible vertices hidden corners are wrong.

use super::{AO, VERTICES, evaluations_of, frames, small, studio};
use crate::ensure;
use crate::variants::{CPU, Outcome, configured, cpu_scene, gpu_scene, on_gpu};
use glam::Quat;
use interreflect::view::View;
use interreflect_cpu::scene::CpuScene;
use interreflect_estimators::execution::BackendScene;
use interreflect_estimators::{Changed, VisibleTriangles};
use interreflect_scene::{Camera, Estimate, PointLayout};
use libtest_mimic::{Failed, Trial};

pub(super) fn trials() -> Vec<Trial> {
    let name = "visibility/filtering";
    vec![
        Trial::test(format!("{name}/cpu"), || filtering(&cpu_scene(studio()))),
        on_gpu(format!("{name}/gpu"), |c| {
            filtering(&gpu_scene(c, studio())?)
        }),
        Trial::test("visibility/evaluations", evaluations),
    ]
}

/// Six views of the studio's receiver, 15° apart.
fn orbit() -> Result<Vec<View>, Failed> {
    let scene: &CpuScene = &studio().cpu;
    let camera = scene.scene().camera;
    let views = (0..6).map(|i| {
        let turn = Quat::from_rotation_y((15.0 * i as f32).to_radians());
        let eye = camera.target + turn * (camera.eye - camera.target);
        let camera = small(Camera { eye, ..camera });
        CPU.install(|| View::new(scene, &camera, VERTICES))
    });
    Ok(views.collect::<Result<_, _>>()?)
}

fn visible(view: &View) -> Result<VisibleTriangles<'_>, Failed> {
    Ok(view.visible().ok_or("no vertices")?)
}

/// What has changed in a frame of a camera that moves alone.
fn changed(frame: usize) -> Changed {
    match frame {
        0 => Changed::ALL,
        _ => Changed::NOTHING,
    }
}

/// A camera that goes around. Filtered by triangles each frame shows what an evaluation of all
/// vertices shows. Filtered by vertices it does too but where a corner was hidden in every frame so
/// far: that corner has no value, and some pixel shows it (P5, Figure 4).
fn filtering<S: BackendScene>(loaded: &S) -> Outcome {
    let views = orbit()?;
    let points = views[0].points(PointLayout::Surface);
    let filtered_by = |filter| {
        let settings = [
            ("level", "1"),
            ("map_resolution", "128"),
            ("filter", filter),
        ];
        let sequence = views.iter().enumerate();
        let sequence = sequence.map(|(i, view)| (changed(i), Some(view)));
        frames(loaded, &settings, &points, sequence)
    };
    let all = filtered_by("none")?;
    let by_triangles = filtered_by("triangles")?;
    let by_vertices = filtered_by("vertices")?;
    let mut hidden = vec![true; points.len()];
    let mut artefacts = Vec::new();
    for (i, view) in views.iter().enumerate() {
        for &v in visible(view)?.visible_points {
            hidden[v as usize] = false;
        }
        let [a, b, c] = [&all, &by_triangles, &by_vertices].map(|e| view.image(&e[i]));
        ensure!(a.pixels == b.pixels, "frame {i} has other visible vertices");
        // All that is known of what was seen, and nothing of the rest.
        let mut expected = Estimate::new(points.len());
        for (v, value) in all[i].iter().enumerate().filter(|(v, _)| !hidden[*v]) {
            expected.set(v, value);
        }
        ensure!(
            c.pixels == view.image(&expected).pixels,
            "frame {i}, by vertices: not what the seen vertices have"
        );
        let pairs = a.pixels.iter().zip(&c.pixels);
        artefacts.push(pairs.filter(|(a, c)| a != c).count());
    }
    println!("wrong pixels of each frame, filtered by vertices: {artefacts:?}");
    ensure!(
        artefacts[0] > 0,
        "no visible triangle has a hidden corner: nothing to see"
    );
    ensure!(
        by_triangles[0]
            .iter()
            .zip(all[0].iter())
            .any(|(a, b)| a != b),
        "vertices at the back were evaluated in the first frame too"
    );
    Ok(())
}

/// Filtered, no vertex is evaluated twice, only those are that were seen, or those whose triangles
/// were, and a camera that goes a quarter around leaves some untouched; without a filter all are
/// evaluated in the first frame.
fn evaluations() -> Outcome {
    let (views, loaded) = (orbit()?, cpu_scene(studio()));
    let points = views[0].points(PointLayout::Surface);
    let counts = |filter| {
        let settings = [("level", "0"), ("map_resolution", "64"), ("filter", filter)];
        let variant = configured("directional_ao", AO, &settings)?;
        let mut executor = variant.executor(&loaded, &points)?;
        let mut counts = Vec::new();
        for (i, view) in views.iter().enumerate() {
            executor.set_visible(view.visible());
            executor.prepare(changed(i))?;
            counts.push(evaluations_of(&executor.records()?)?);
        }
        Ok::<_, Failed>(counts)
    };
    let all = points.len() as u64;
    let mut seen = [vec![false; points.len()], vec![false; points.len()]];
    let mut expected = [Vec::new(), Vec::new()];
    for view in &views {
        let visible = visible(view)?;
        let triangles = visible.visible.iter().map(|&t| t as usize);
        let corners = triangles.flat_map(|t| visible.triangles[t]);
        corners.for_each(|v| seen[0][v as usize] = true);
        let vertices = visible.visible_points.iter();
        vertices.for_each(|&v| seen[1][v as usize] = true);
        for (seen, expected) in seen.iter().zip(&mut expected) {
            expected.push(seen.iter().filter(|s| **s).count() as u64);
        }
    }
    let found = [counts("none")?, counts("triangles")?, counts("vertices")?];
    println!("evaluated of {all}, unfiltered, by triangles, by vertices: {found:?}");
    let [by_triangles, by_vertices] = expected.clone();
    ensure!(
        found == [vec![all; views.len()], by_triangles, by_vertices],
        "evaluated {found:?}, seen {expected:?}"
    );
    ensure!(
        found[1][0] < all / 2 && found[1][5] < all && found[1] != found[2],
        "nothing to save: {found:?}"
    );
    Ok(())
}
