//! A folder of results is enough to make its report again, and to show its images elsewhere.
#![allow(clippy::unwrap_used, reason = "tests")]

use std::io::Read as _;
use std::net::TcpListener;
use std::path::Path;
use std::process::Command;
use std::thread;

/// Runs a command line in a folder; it has to succeed.
fn run(folder: &Path, line: &str) {
    let output = Command::new(env!("CARGO_BIN_EXE_interreflect"))
        .args(line.split_whitespace())
        .current_dir(folder)
        .output()
        .unwrap();
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "`{line}`: {complaint}");
}

#[test]
fn a_report_can_be_made_again_from_its_folder() {
    let folder = tempfile::tempdir().unwrap();
    let bench = "bench furnace --backend cpu --estimator constant_ambient --estimator \
        localized_cubemap --set constant_ambient.capture_resolution=8 --points 40 --repeat 1 --samples 8 --out made";
    run(folder.path(), bench);
    let page = folder.path().join("made/report.html");
    let made = std::fs::read_to_string(&page).unwrap();
    assert!(made.contains("id=\"pixels-0-3\""), "no images in the page");
    std::fs::remove_file(&page).unwrap();

    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = listener.local_addr().unwrap();
    let received = thread::spawn(move || {
        let mut bytes = Vec::new();
        let (mut stream, _) = listener.accept().unwrap();
        stream.read_to_end(&mut bytes).unwrap();
        bytes
    });
    run(folder.path(), &format!("report made --tev={address}"));
    let again = std::fs::read_to_string(&page).unwrap();
    assert!(again == made, "the report differs");

    let received = received.join().unwrap();
    for name in [
        "furnace/irradiance/truth",
        "furnace/irradiance/constant_ambient, cpu",
        "furnace/glossy_radiance/localized_cubemap, corrected, cpu",
    ] {
        let named = [name.as_bytes(), &[0]].concat();
        let times = received
            .windows(named.len())
            .filter(|w| *w == named)
            .count();
        assert_eq!(times, 2, "{name} is made and filled");
    }
}
