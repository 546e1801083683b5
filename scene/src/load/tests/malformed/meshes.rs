use super::{TRIANGLE, refuse};

#[test]
fn malformed_meshes() {
    let cases = [
        (
            "v 0 0 nan\nf 1 1 1",
            "DIR/a.obj:1: `nan` is not finite; use finite numbers of at most 3e38",
        ),
        (
            "v 0 0 1e39\nf 1 1 1",
            "DIR/a.obj:1: `1e39` is not finite; use finite numbers of at most 3e38",
        ),
        (
            "# x\n\nv 0 zero 0\n",
            "DIR/a.obj:3: `zero` is not a number; give a number",
        ),
        (
            "v 0 0\n",
            "DIR/a.obj:1: `v` needs 3 value(s) and has 2; add the missing ones",
        ),
        (
            "v 0 0 0 0\n",
            "DIR/a.obj:1: the vertex has a weight of 0; use a weight of 1, or none",
        ),
        (
            "v 0 0 0 1 2\n",
            "DIR/a.obj:1: the vertex has 5 numbers; give three",
        ),
        (
            "vn 0 0 0\n",
            "DIR/a.obj:1: the normal has length zero; give a direction, or leave out all normals",
        ),
        (
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n",
            "DIR/a.obj:4: position 4 of `4` does not exist: there are 3 above; use an index from 1 to their number",
        ),
        (
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n",
            "DIR/a.obj:4: position 0 of `0` does not exist: there are 3 above; use an index from 1 to their number",
        ),
        (
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -4 1 2\n",
            "DIR/a.obj:4: position -4 of `-4` does not exist: there are 3 above; use an index from 1 to their number",
        ),
        (
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//1 2//1 3//1\n",
            "DIR/a.obj:4: normal 1 of `1//1` does not exist: there are 0 above; use an index from 1 to their number",
        ),
        (
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 x\n",
            "DIR/a.obj:4: `x` is not a corner of a face; write v, v/vt, v//vn or v/vt/vn",
        ),
        (
            "v 0 0 0\nv 1 0 0\nf 1 2\n",
            "DIR/a.obj:3: a face of 2 corners; give at least three",
        ),
        (
            "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n",
            "DIR/a.obj: no triangle has an area; give at least one triangle with three different corners",
        ),
        (
            "v 0 0 0\n",
            "DIR/a.obj: no face (`f`) found; export a triangle mesh",
        ),
        ("", "DIR/a.obj: no face (`f`) found; export a triangle mesh"),
        (
            "v 0 0 0\nv 1e-9 0 0\nv 0 1e-9 0\nf 1 2 3\n",
            "DIR/a.obj: the largest coordinate of the surroundings is 1e-9 m, below 1e-8 m; scale the meshes, for example to metres",
        ),
        (
            "v 0 0 0\nv 1e-30 0 0\nv 0 1e-30 0\nf 1 2 3\n",
            "DIR/a.obj: the largest coordinate of the surroundings is 1e-30 m, below 1e-8 m; scale the meshes, for example to metres",
        ),
        (
            "v 0 0 0\nv 1e38 0 0\nv 0 1e38 0\nf 1 2 3\n",
            "DIR/a.obj: object `a`: vertex 1 is at [1e38, 0.0, 0.0], not within ±1e15 m; mend the mesh or its transform",
        ),
        (
            "mtllib b.mtl\n",
            "DIR/a.obj:1: cannot read material library: DIR/b.mtl: No such file or directory (os error 2); check the path and its permissions; put the MTL file beside the OBJ file, or remove the line",
        ),
        (
            "usemtl red\n",
            "DIR/a.obj:1: there is no material `red`; name the MTL file first, in a line `mtllib FILE.mtl`",
        ),
    ];
    for (content, expected) in cases {
        refuse(&[("a.obj", content)], expected);
    }
}

#[test]
fn malformed_materials() {
    let cases = [
        (
            "newmtl red\nKd 0.5\n",
            "DIR/m.mtl:2: `Kd` needs 3 value(s) and has 1; add the missing ones",
        ),
        (
            "newmtl red\nKd 0.5 1.5 0\n",
            "DIR/m.mtl:2: Kd is [0.5, 1.5, 0.0]; use numbers from 0 to 1.0",
        ),
        (
            "newmtl red\nKe 0 -1 0\n",
            "DIR/m.mtl:2: Ke is [0.0, -1.0, 0.0]; use numbers from 0 to 1e30",
        ),
        (
            "newmtl red\nKe 0 2e30 0\n",
            "DIR/m.mtl:2: Ke is [0.0, 2e30, 0.0]; use numbers from 0 to 1e30",
        ),
        (
            "newmtl red\nKs inf 0 0\n",
            "DIR/m.mtl:2: `inf` is not finite; use finite numbers of at most 3e38",
        ),
        (
            "newmtl red\nNs -3\n",
            "DIR/m.mtl:2: shininess Ns is -3; use 0 or more",
        ),
        (
            "newmtl red\nNs\n",
            "DIR/m.mtl:2: `Ns` needs 1 value(s) and has 0; add the missing ones",
        ),
        (
            "Kd 1 1 1\n",
            "DIR/m.mtl:1: `Kd` before any `newmtl`; name the material first",
        ),
        (
            "newmtl\n",
            "DIR/m.mtl:1: `newmtl` without a name; name the material",
        ),
        (
            "newmtl red\nKd 0.8 0.8 0.8\nKs 0.5 0.5 0.5\n",
            "DIR/m.mtl:1: material `red` reflects more than it receives: Kd [0.8, 0.8, 0.8] + Ks [0.5, 0.5, 0.5] exceeds 1; lower Ks or Kd",
        ),
        (
            "newmtl redd\n",
            "DIR/a.obj:2: there is no material `red`; did you mean `redd`?",
        ),
        (
            "newmtl white\n",
            "DIR/a.obj:2: there is no material `red`; define it in the MTL file",
        ),
    ];
    let obj = format!("mtllib m.mtl\nusemtl red\n{TRIANGLE}");
    for (content, expected) in cases {
        refuse(&[("a.obj", &obj), ("m.mtl", content)], expected);
    }
}
