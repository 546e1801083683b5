mod meshes;
mod motions;
mod scene_files;

use super::{Folder, TRIANGLE};
use crate::{SceneRequest, open, open_points};

/// Opens the first of some files and expects the one-line error; `DIR` stands for their folder.
fn refuse(files: &[(&str, &str)], expected: &str) {
    let folder = Folder::new(files);
    let path = folder.path(files[0].0);
    let error = match files[0].0.ends_with(".csv") {
        true => open_points(&path).map(|p| format!("{} points", p.len())),
        false => open(&SceneRequest::new(path.to_string_lossy())).map(|s| format!("{s:?}")),
    }
    .expect_err(expected)
    .to_string()
    .replace(&*folder.path("").to_string_lossy(), "DIR/");
    assert_eq!(error, expected, "for {files:?}");
}

#[test]
fn malformed_points() {
    let cases = [
        (
            "x,y,z,nx,ny\n0,0,0,0,1\n",
            "DIR/p.csv:1: column `nz` is missing; name the columns x,y,z,nx,ny,nz and optionally vx,vy,vz",
        ),
        (
            "x,y,z,nx,ny,nz,x\n0,0,0,0,1,0,0\n",
            "DIR/p.csv:1: column `x` is there twice; remove or rename one",
        ),
        (
            "x,y,z,nx,ny,nz,vy\n0,0,0,0,1,0,0\n",
            "DIR/p.csv:1: column `vx` is missing; name the columns x,y,z,nx,ny,nz and optionally vx,vy,vz",
        ),
        (
            "x,y,z,nx,ny,nz\n0,0,0,0,1,0\n0,0,0,0,0,0\n",
            "DIR/p.csv:3: nx,ny,nz is [0, 0, 0]; give a direction of non-zero length",
        ),
        (
            "x,y,z,nx,ny,nz\n0,0,0,0,1,nan\n",
            "DIR/p.csv:2: nz is `nan`; give a finite number",
        ),
        (
            "x,y,z,nx,ny,nz\n0,0,1e39,0,1,0\n",
            "DIR/p.csv:2: z is `1e39`; give a finite number",
        ),
        (
            "x,y,z,nx,ny,nz\n0,,0,0,1,0\n",
            "DIR/p.csv:2: y is ``; give a finite number",
        ),
        (
            "x,y,z,nx,ny,nz\n0,0,0,0,1,0\n0,0,0,0,1\n",
            "DIR/p.csv:3: 5 values, but the header has 6; give one value per column",
        ),
        (
            "x,y,z,nx,ny,nz,vx,vy,vz\n0,0,0,0,1,0,0,0,0\n",
            "DIR/p.csv:2: vx,vy,vz is [0, 0, 0]; give a direction of non-zero length",
        ),
        (
            "x,y,z,nx,ny,nz\n",
            "DIR/p.csv: there are no points in it; add a line per point below the header",
        ),
        (
            "x,y,z,nx,ny,nz\r\n\r\n\r\n0,0,0,0,1,0\r\n\r\n0,0,0,0,up,0\r\n",
            "DIR/p.csv:6: ny is `up`; give a finite number",
        ),
        (
            "",
            "DIR/p.csv:1: column `x` is missing; name the columns x,y,z,nx,ny,nz and optionally vx,vy,vz",
        ),
    ];
    for (content, expected) in cases {
        refuse(&[("p.csv", content)], expected);
    }
}

#[test]
fn requests_that_name_nothing() {
    let refused = |request: SceneRequest| open(&request).expect_err("refused").to_string();
    assert_eq!(
        refused(SceneRequest::new("cornel-box")),
        "there is no scene `cornel-box`, did you mean `cornell-box`?; use one of cornell-box, \
         colored-room, divided-room, studio, furnace, cave, pit, dragons, or a .toml or .obj file"
    );
    assert_eq!(
        refused(SceneRequest::new("none.obj")),
        "none.obj: No such file or directory (os error 2); check the path and its permissions"
    );
    let room = SceneRequest::new("colored-room");
    assert_eq!(
        refused(SceneRequest {
            receivers: vec!["cube".into()],
            ..room.clone()
        }),
        "there is no receiver `cube`; use one of sphere, torus, blob, or an .obj file"
    );
    let set = |name: &str, value: &str| SceneRequest {
        set: vec![(name.into(), value.into())],
        ..room.clone()
    };
    assert!(refused(set("receiver.gpa", "1")).contains("did you mean `receiver.gap`?"));
    assert_eq!(
        refused(set("receiver.gap", "wide")),
        "scene setting: `receiver.gap` = `wide`: expected a number"
    );
    assert_eq!(
        refused(SceneRequest {
            environment: Some("sky.png".into()),
            ..room
        }),
        "sky.png: not an environment map by its name; use a file that ends in .hdr or .exr"
    );
}
