use super::{TRIANGLE, refuse};

#[test]
fn malformed_scene_files() {
    let cases = [
        (
            "naem = \"x\"\n",
            "DIR/s.toml:1: unknown field `naem`, expected one of `name`, `reference_point`, `captured_at`, `camera`, `mesh`, `light`; did you mean `name`?",
        ),
        (
            "name = \n",
            "DIR/s.toml:1: string values must be quoted, expected literal string; mend this line",
        ),
        (
            "name = \"x\"\n",
            "DIR/s.toml: there is no mesh in the scene; add a `[[mesh]]` table",
        ),
        (
            "[[mesh]]\nrole = \"receiver\"\n",
            "DIR/s.toml:1: a mesh needs either `file` or `shape`; give one of them",
        ),
        (
            "[[mesh]]\nfile = \"none.obj\"\n",
            "DIR/s.toml:2: there is no file `DIR/none.obj`; name a file relative to this one",
        ),
        (
            "[[mesh]]\nfile = \"bad.obj\"\n",
            "DIR/bad.obj:1: `x` is not a number; give a number",
        ),
        (
            "[[mesh]]\nshape = \"sphere\"\nrole = \"reciever\"\n",
            "DIR/s.toml:3: unknown variant `reciever`, expected `environment` or `receiver`; did you mean `receiver`?",
        ),
        (
            "[[mesh]]\nshape = \"sphere\"\nradius = -1\n",
            "DIR/s.toml:3: `radius` is -1.0; use a number above 0",
        ),
        (
            "[[mesh]]\nshape = \"sphere\"\nsize = [1, 1]\n",
            "DIR/s.toml:3: `size` means nothing to the shape `sphere`; remove it; allowed: radius",
        ),
        (
            "[[mesh]]\nshape = \"box\"\nsize = [1, 1]\n",
            "DIR/s.toml:3: `size` is [1.0, 1.0]; give 3 numbers above 0",
        ),
        (
            "[[mesh]]\nfile = \"good.obj\"\nradius = 1\n",
            "DIR/s.toml:3: `radius` means nothing to a mesh from a file; remove it",
        ),
        (
            "[[mesh]]\nshape = \"sphere\"\ntranslate = [0, nan, 0]\n",
            "DIR/s.toml:3: `translate` is [0.0, NaN, 0.0]; use finite numbers",
        ),
        (
            "[[mesh]]\nshape = \"sphere\"\ntranslate = [0, 1]\n",
            "DIR/s.toml:3: invalid length 2, expected an array of length 3; mend this line",
        ),
        (
            "[[mesh]]\nshape = \"sphere\"\nscale = 0\n",
            "DIR/s.toml:3: `scale` is 0.0; use a number above 0",
        ),
        (
            "[[mesh]]\nshape = \"sphere\"\nfit = \"big\"\n",
            "DIR/s.toml:3: invalid type: string \"big\", expected f32; mend this line",
        ),
        (
            "[[mesh]]\nshape = \"sphere\"\nmaterial = { albdo = [1, 1, 1] }\n",
            "DIR/s.toml:3: unknown field `albdo`, expected one of `albedo`, `specular`, `shininess`, `emission`, `mirror`; did you mean `albedo`?",
        ),
        (
            "[[mesh]]\nshape = \"sphere\"\nmaterial = { albedo = [2, 1, 1] }\n",
            "DIR/s.toml:3: `albedo` is [2.0, 1.0, 1.0]; use numbers from 0 to 1",
        ),
        (
            "[[mesh]]\nshape = \"sphere\"\nmaterial = { specular = [0.5, 0.5, 0.5] }\n",
            "DIR/s.toml:3: the surface reflects more than it receives: albedo [0.7, 0.7, 0.7] + specular [0.5, 0.5, 0.5] exceeds 1; lower one of them",
        ),
        (
            "reference_point = [0, 0, 1e16]\n[[mesh]]\nshape = \"sphere\"\n",
            "DIR/s.toml: the reference point is [0.0, 0.0, 1e16]; use coordinates within ±1e15 m",
        ),
        (
            "captured_at = [0, 0, 1e16]\n[[mesh]]\nshape = \"sphere\"\n",
            "DIR/s.toml: captures were made at [0.0, 0.0, 1e16]; use coordinates within ±1e15 m",
        ),
        (
            "captured_at = [0, nan, 0]\n[[mesh]]\nshape = \"sphere\"\n",
            "DIR/s.toml:1: `captured_at` is [0.0, NaN, 0.0]; use finite numbers",
        ),
        (
            "[[mesh]]\nshape = \"sphere\"\nmaterial = { emission = [3e38, 1, 1] }\n",
            "DIR/s.toml:3: `emission` is [3e38, 1.0, 1.0]; use numbers from 0 to 1e30",
        ),
        (
            "[[mesh]]\nshape = \"sphere\"\nscale = 1e38\nradius = 1e3\n",
            "DIR/s.toml: object `sphere`: vertex 0 is at [NaN, NaN, NaN], not within ±1e15 m; mend the mesh or its transform",
        ),
    ];
    let beside = [("good.obj", TRIANGLE), ("bad.obj", "v x\n")];
    for (content, expected) in cases {
        refuse(&[("s.toml", content), beside[0], beside[1]], expected);
    }
}

#[test]
fn names_that_files_cannot_have() {
    for (name, fault) in [
        ("", "is empty"),
        (&"n".repeat(101), "is longer than 100 characters"),
        (".hidden", "starts with a dot"),
        ("../up", "starts with a dot"),
        ("a/b", "has a slash, a backslash or a control character"),
        ("a\\\\b", "has a slash, a backslash or a control character"),
        ("a\\nb", "has a slash, a backslash or a control character"),
    ] {
        let content = format!("# a scene\nname = \"{name}\"\n[[mesh]]\nshape = \"quad\"\n");
        let expected = format!(
            "DIR/s.toml:2: the scene's `name` {fault}; choose a name that can be part of a file's name"
        );
        refuse(&[("s.toml", &content)], &expected);
    }
    refuse(
        &[("..obj", TRIANGLE)],
        "DIR/..obj: the file's name as the scene's starts with a dot; rename the file",
    );
}

#[test]
fn malformed_lights_and_cameras() {
    let cases = [
        (
            "[[light]]\nposition = [0, 0, 0]\n",
            "DIR/s.toml:3: missing field `kind`; add `kind = …`",
        ),
        (
            "[[light]]\nkind = \"pont\"\n",
            "DIR/s.toml:4: unknown variant `pont`, expected one of `point`, `spot`, `directional`, `area`, `environment`; did you mean `point`?",
        ),
        (
            "[[light]]\nkind = \"point\"\nintensity = [1, 1, 1]\n",
            "DIR/s.toml:3: a point light needs `position`; add `position = …`",
        ),
        (
            "[[light]]\nkind = \"point\"\nposition = [0, 0, 0]\n",
            "DIR/s.toml:3: a point light needs `intensity` or `flux`; add `intensity = [r, g, b]` in W/sr or `flux = [r, g, b]` in W",
        ),
        (
            "[[light]]\nkind = \"point\"\nposition = [0, 0, 0]\nintensity = [1, 1, 1]\nflux = [1, 1, 1]\n",
            "DIR/s.toml:7: both `intensity` and `flux` are given; keep one",
        ),
        (
            "[[light]]\nkind = \"point\"\nposition = [0, 0, 0]\nintensity = [1, -1, 1]\n",
            "DIR/s.toml:6: `intensity` is [1.0, -1.0, 1.0]; use numbers from 0 to 1e30",
        ),
        (
            "[[light]]\nkind = \"point\"\nposition = [0, 0, 0]\nirradiance = [1, 1, 1]\n",
            "DIR/s.toml:6: `irradiance` means nothing to a point light; remove it; allowed: position, intensity, flux, picture_direction, picture_up, picture_angle_deg, motion",
        ),
        (
            "[[light]]\nkind = \"spot\"\nposition = [0, 0, 0]\ndirection = [0, 0, 0]\nangle_deg = 90\nintensity = [1, 1, 1]\n",
            "DIR/s.toml:6: `direction` has length zero; give a direction",
        ),
        (
            "[[light]]\nkind = \"spot\"\nposition = [0, 0, 0]\ndirection = [0, 1, 0]\nangle_deg = 180\nintensity = [1, 1, 1]\n",
            "DIR/s.toml:7: `angle_deg` is 180.0; use an angle between 0 and 180 degrees",
        ),
        (
            "[[light]]\nkind = \"spot\"\nposition = [0, 0, 0]\ndirection = [0, 1, 0]\nup = [0, 2, 0]\nangle_deg = 90\nintensity = [1, 1, 1]\n",
            "DIR/s.toml:7: `up` is parallel to `direction`; turn it away",
        ),
        (
            "[[light]]\nkind = \"point\"\nposition = [0, 0, 0]\nintensity = [1, 1, 1]\npicture_direction = [0, 1, 0]\npicture_up = [0, 2, 0]\n",
            "DIR/s.toml:8: `picture_up` is parallel to `picture_direction`; turn it away",
        ),
        (
            "[[light]]\nkind = \"point\"\nposition = [0, 0, 0]\nintensity = [1, 1, 1]\npicture_angle_deg = 60\n",
            "DIR/s.toml:7: `picture_angle_deg` means nothing to a light without `picture_direction`; remove it",
        ),
        (
            "[[light]]\nkind = \"environment\"\n",
            "DIR/s.toml:3: an environment light needs either `file` or `constant`; give one of them",
        ),
        (
            "[[light]]\nkind = \"environment\"\nconstant = [1, 1, 1]\n[[light]]\nkind = \"environment\"\nconstant = [1, 1, 1]\n",
            "DIR/s.toml:6: a second environment light; keep one",
        ),
        (
            "[[light]]\nkind = \"environment\"\nconstant = [1e31, 1, 1]\n",
            "DIR/s.toml:5: `constant` is [1e31, 1.0, 1.0]; use numbers from 0 to 1e30",
        ),
        (
            "[[light]]\nkind = \"environment\"\nconstant = [1e20, 1, 1]\nscale = 1e20\n",
            "DIR/s.toml:6: `scale` is 1e20 and makes radiances above 1e30; lower it",
        ),
        (
            "[[light]]\nkind = \"spot\"\nposition = [0, 0, 0]\ndirection = [0, 1, 0]\nangle_deg = 1e-9\nflux = [1, 1, 1]\n",
            "DIR/s.toml:8: `flux` in 0e0 sr exceeds an intensity of 1e30 W/sr; lower it or widen the light's angle",
        ),
        (
            "[camera]\neye = [0, 0, 1e16]\ntarget = [0, 0, 0]\n",
            "DIR/s.toml: the camera has no valid view: from [0.0, 0.0, 1e16] to [0.0, 0.0, 0.0], up [0.0, 1.0, 0.0], 45° in 512 × 512 pixels; look at another point, with `up` off the view direction",
        ),
        (
            "[camera]\neye = [0, 0, 1]\n",
            "DIR/s.toml:3: missing field `target`; add `target = …`",
        ),
        (
            "[camera]\neye = [0, 0, 1]\ntarget = [0, 0, 1]\n",
            "DIR/s.toml:3: `eye` and `target` are the same point; move one",
        ),
        (
            "[camera]\neye = [0, 0, 1]\ntarget = [0, 1, 1]\n",
            "DIR/s.toml:3: `up` is parallel to the view direction; turn `up` away from the view direction",
        ),
        (
            "[camera]\neye = [0, 0, 1]\ntarget = [0, 0, 0]\nvfov_deg = 0\n",
            "DIR/s.toml:6: `vfov_deg` is 0.0; use an angle between 0 and 180 degrees",
        ),
        (
            "[camera]\neye = [0, 0, 1]\ntarget = [0, 0, 0]\nresolution = [0, 512]\n",
            "DIR/s.toml:6: `resolution` is [0, 512]; use 1 to 16384 pixels",
        ),
    ];
    for (content, expected) in cases {
        let content = format!("[[mesh]]\nshape = \"quad\"\n{content}");
        refuse(&[("s.toml", &content)], expected);
    }
}
