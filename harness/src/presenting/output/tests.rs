#![allow(clippy::unwrap_used, reason = "tests")]
use super::*;
use crate::domain::machine::Machine;
use crate::domain::record::{Backend, Phases, Run, Timing};
use glam::Vec3;
use interreflect_scene::params::Value;

fn gradient() -> HdrImage {
    let mut image = HdrImage::new(5, 3);
    for (i, p) in image.pixels.iter_mut().enumerate() {
        *p = Vec3::new(i as f32 * 0.1, -1e-6, 1e9 / (i + 1) as f32);
    }
    image
}

#[test]
fn exr_keeps_every_bit_and_what_the_image_is() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("deep/er/image.exr");
    let run = Run {
        params: [("resolution", Value::U32(8))].into_iter().collect(),
        ..Run::new("höhle → 1", "texels", Backend::Gpu, "irradiance")
    };
    let machine = Machine::detect(2, "avx2", None);
    let header = Header::of_program("interreflect bench", &machine, 7).of_run(&run);
    let surfaces: Vec<bool> = (0..15).map(|i| i != 4).collect();
    write_exr(&path, &gradient(), Some(&surfaces), &header).unwrap();
    assert_eq!(read_exr(&path).unwrap(), gradient());
    let read = read_labelled_exr(&path).unwrap();
    assert_eq!((read.image, read.surfaces), (gradient(), surfaces));
    for (name, value) in [
        // The format has one byte a character.
        ("scene", "höhle ? 1"),
        ("quantity", "irradiance"),
        ("unit", "W/m2"),
        ("estimator", "texels"),
        ("params", "resolution=8"),
        ("backend", "gpu"),
        ("command", "interreflect bench"),
        ("seed", "7"),
    ] {
        assert_eq!(read.header.get(name), Some(value), "{name}");
    }
    assert_eq!(read.header.get("fidelity"), None);
}

#[test]
fn an_image_without_surfaces_has_them_everywhere() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("image.exr");
    write_exr(&path, &gradient(), None, &Header::default()).unwrap();
    let read = read_labelled_exr(&path).unwrap();
    assert_eq!((read.image, read.surfaces), (gradient(), vec![true; 15]));
}

#[test]
fn results_are_a_table_too() {
    let folder = tempfile::tempdir().unwrap();
    let timed = Run {
        phases_ms: Phases {
            shade: Timing::of(&[2.0]),
            ..Phases::default()
        },
        ..Run::new("a, b", "texels", Backend::Cpu, "irradiance")
    };
    let set = Run {
        params: [("rays", Value::U32(9))].into_iter().collect(),
        skipped: Some("no".into()),
        ..Run::new("c", "texels", Backend::Gpu, "irradiance")
    };
    let results = Results {
        machine: Machine::detect(2, "avx2", None),
        command: "interreflect bench".into(),
        seed: Some(1),
        runs: vec![timed, set],
        ..Results::default()
    };
    write_results(folder.path(), &results).unwrap();
    assert_eq!(read_results(folder.path()).unwrap(), results);
    let mut table = ::csv::Reader::from_path(folder.path().join("results.csv")).unwrap();
    let head = table.headers().unwrap().clone();
    let lines: Vec<_> = table.records().map(Result::unwrap).collect();
    let cell = |line: usize, column: &str| {
        let at = head.iter().position(|name| name == column).unwrap();
        lines[line][at].to_owned()
    };
    assert_eq!(lines.len(), 2);
    assert_eq!(cell(0, "scene"), "a, b");
    assert_eq!(cell(0, "phases_ms.shade.median"), "2.0");
    assert_eq!(
        (cell(0, "params.rays"), cell(1, "params.rays")),
        ("".into(), "9".into())
    );
    assert_eq!(cell(1, "skipped"), "no");
}

#[test]
fn a_folder_without_results_is_named_with_a_remedy() {
    let folder = tempfile::tempdir().unwrap();
    let message = read_results(folder.path()).unwrap_err().to_string();
    assert!(
        message.contains("results.json") && message.contains("bench --out"),
        "{message}"
    );
}

#[test]
fn png_has_the_image_s_size() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("image.png");
    write_png(&path, &gradient(), Exposure(1.0)).unwrap();
    let back = ::image::open(&path).unwrap().to_rgb8();
    assert_eq!((back.width(), back.height()), (5, 3));
    assert_eq!(back.get_pixel(0, 0).0, [0, 0, 255]);
}

#[test]
fn what_is_no_exr_is_an_error_that_names_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("not.exr");
    for content in [None, Some("plain text")] {
        if let Some(content) = content {
            fs::write(&path, content).unwrap();
        }
        let message = read_exr(&path).unwrap_err().to_string();
        assert!(
            message.contains("not.exr") && message.contains("OpenEXR"),
            "{message}"
        );
    }
}
