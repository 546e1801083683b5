use super::refuse;

#[test]
fn malformed_motions_of_meshes() {
    let cases = [
        (
            "{ kind = \"turn\" }",
            "unknown field `kind`, expected one of `keyframes`, `deformation`, `period_s`, `amount`; use one of these names",
        ),
        (
            "{ }",
            "a mesh's motion needs `keyframes` or `deformation`; give one of them, or both",
        ),
        (
            "{ deformation = \"twsit\" }",
            "unknown variant `twsit`, expected one of `twist`, `wave`, `breathe`; did you mean `twist`?",
        ),
        (
            "{ deformation = \"twist\", period_s = 0 }",
            "`period_s` is 0.0; use a number above 0",
        ),
        (
            "{ deformation = \"breathe\", amount = 1 }",
            "`amount` is 1.0; use a number from 0 to 0.5",
        ),
        (
            "{ deformation = \"wave\", amount = nan }",
            "`amount` is NaN; use a number from 0 to 4",
        ),
        (
            "{ keyframes = [{ time = 0 }], amount = 1 }",
            "`amount` means nothing to a motion without `deformation`; remove it",
        ),
        (
            "{ keyframes = [] }",
            "`keyframes` is empty; add a keyframe, such as `{ time = 0 }`",
        ),
        (
            "{ keyframes = [{ scale = 1 }] }",
            "missing field `time`; add `time = …`",
        ),
        (
            "{ keyframes = [{ time = 1, rotate = [0, 0, 0] }] }",
            "unknown field `rotate`, expected one of `time`, `translate`, `rotate_deg`, `scale`; did you mean `rotate_deg`?",
        ),
        (
            "{ keyframes = [{ time = 1 }, { time = 1 }] }",
            "`time` is 1.0 after 1.0; let the times of keyframes increase",
        ),
        (
            "{ keyframes = [{ time = inf }] }",
            "`time` is inf; use a finite number",
        ),
        (
            "{ keyframes = [{ time = 0, translate = [nan, 0, 0] }] }",
            "`translate` is [NaN, 0.0, 0.0]; use finite numbers",
        ),
        (
            "{ keyframes = [{ time = 0, scale = 0 }] }",
            "`scale` is 0.0; use a number from 0.001 to 1000",
        ),
    ];
    for (motion, expected) in cases {
        let content = format!("[[mesh]]\nshape = \"sphere\"\nmotion = {motion}\n");
        refuse(
            &[("s.toml", &content)],
            &format!("DIR/s.toml:3: {expected}"),
        );
    }
    refuse(
        &[(
            "s.toml",
            "[[mesh]]\nshape = \"sphere\"\n[mesh.motion]\nkeyframes = [\n{ time = 2 },\n{ time = 1 }]\n",
        )],
        "DIR/s.toml:6: `time` is 1.0 after 2.0; let the times of keyframes increase",
    );
    refuse(
        &[(
            "s.toml",
            "[[mesh]]\nshape = \"sphere\"\nmotion = { keyframes = [{ time = 0, translate = [1e16, 0, 0] }] }\n",
        )],
        "DIR/s.toml: object `sphere`: its motion takes it beyond ±1e15 m at 0 s; fix the motion, for example with other keyframes",
    );
}

#[test]
fn malformed_motions_of_camera_and_lights() {
    let cases = [
        (
            "[camera]\neye = [0, 0, 1]\ntarget = [0, 0, 0]\nmotion = { orbit_deg_per_s = 1, keyframes = [{ time = 0 }] }\n",
            ":6: the camera's motion needs either `keyframes` or `orbit_deg_per_s`; give one of them",
        ),
        (
            "[camera]\neye = [0, 0, 1]\ntarget = [0, 0, 0]\nmotion = { orbit_deg_per_s = nan }\n",
            ":6: `orbit_deg_per_s` is NaN; use a finite number",
        ),
        (
            "[camera]\neye = [0, 0, 1]\ntarget = [0, 0, 0]\nmotion = { keyframes = [{ time = 0, up = [0, 1, 0] }] }\n",
            ":6: unknown field `up`, expected one of `time`, `eye`, `target`; use one of these names",
        ),
        (
            "[camera]\neye = [0, 0, 1]\ntarget = [0, 0, 0]\nmotion = { keyframes = [{ time = 0, target = [0, 0, 1] }] }\n",
            ":6: the camera has no valid view at 0 s: eye and target coincide, or `up` is parallel to the view direction; choose other keyframes, or more of them",
        ),
        (
            "[camera]\neye = [0, 0, 1]\ntarget = [0, 0, 0]\nmotion = { keyframes = [{ time = 0 }, { time = 1, eye = [0, 0, -1] }] }\n",
            ":6: the camera has no valid view at some time from 0 s to 1 s: it passes through its target, or `up` becomes parallel to the view direction; choose other keyframes, or more of them",
        ),
        (
            "[[light]]\nkind = \"point\"\nposition = [0, 0, 0]\nintensity = [1, 1, 1]\nmotion = { keyframes = [{ time = 0, direction = [0, 1, 0] }] }\n",
            ":7: `direction` means nothing to the motion of a point light; remove it; allowed: position",
        ),
        (
            "[[light]]\nkind = \"directional\"\ndirection = [0, 1, 0]\nirradiance = [1, 1, 1]\nmotion = { keyframes = [{ time = 0, direction = [0, 0, 0] }] }\n",
            ":7: `direction` has length zero; give a direction",
        ),
        (
            "[[light]]\nkind = \"point\"\nposition = [0, 0, 0]\nintensity = [1, 1, 1]\nmotion = { }\n",
            ":7: missing field `keyframes`; add `keyframes = …`",
        ),
        (
            "[[light]]\nkind = \"environment\"\nconstant = [1, 1, 1]\nmotion = { keyframes = [] }\n",
            ":6: `motion` means nothing to an environment light; remove it; allowed: file, constant, scale, rotate_deg, rotate_deg_per_s",
        ),
        (
            "[[light]]\nkind = \"environment\"\nconstant = [1, 1, 1]\nrotate_deg_per_s = inf\n",
            ":6: `rotate_deg_per_s` is inf; use a finite number",
        ),
    ];
    for (rest, expected) in cases {
        let content = format!("[[mesh]]\nshape = \"sphere\"\n{rest}");
        refuse(&[("s.toml", &content)], &format!("DIR/s.toml{expected}"));
    }
}
