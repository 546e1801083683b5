#![allow(clippy::unwrap_used, reason = "tests")]
use super::*;

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
