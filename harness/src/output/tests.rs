#![allow(clippy::unwrap_used, reason = "tests")]
use super::*;
use glam::Vec3;

fn gradient() -> HdrImage {
    let mut image = HdrImage::new(5, 3);
    for (i, p) in image.pixels.iter_mut().enumerate() {
        *p = Vec3::new(i as f32 * 0.1, -1e-6, 1e9 / (i + 1) as f32);
    }
    image
}

#[test]
fn exr_keeps_every_bit() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("deep/er/image.exr");
    write_exr(&path, &gradient()).unwrap();
    assert_eq!(read_exr(&path).unwrap(), gradient());
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
fn a_failed_write_leaves_the_old_file_and_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    // A folder in the file's place: the temporary file is written, its last step fails.
    let path = folder.path().join("results.json");
    fs::create_dir(&path).unwrap();
    fs::write(path.join("old"), "old").unwrap();
    let error = write_atomically(&path, b"new").unwrap_err().to_string();
    assert!(
        error.contains("results.json") && error.contains("--out"),
        "{error}"
    );
    let names: Vec<_> = fs::read_dir(folder.path())
        .unwrap()
        .map(|e| e.unwrap().file_name())
        .collect();
    assert_eq!(names, ["results.json"]);
}

/// A second name of the old file keeps what it held: nothing was written over it.
#[test]
fn a_new_file_takes_the_old_one_s_place_and_leaves_it_whole() {
    let folder = tempfile::tempdir().unwrap();
    let [path, other] = ["results.json", "other.json"].map(|name| folder.path().join(name));
    fs::write(&path, "old").unwrap();
    fs::hard_link(&path, &other).unwrap();
    write_atomically(&path, b"new").unwrap();
    let texts = [path, other].map(|path| fs::read_to_string(path).unwrap());
    assert_eq!(texts, ["new", "old"]);
}

#[test]
fn json_ends_its_last_line() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.json");
    write_json(&path, &[1, 2]).unwrap();
    write_json(&path, &[3]).unwrap();
    assert_eq!(fs::read_to_string(&path).unwrap(), "[\n  3\n]\n");
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
