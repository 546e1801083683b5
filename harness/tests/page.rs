//! The arithmetic of the report's page: its scripts are run by Node.js on numbers worked out by hand.
//!
//! Shown as ignored where no `node` is found; INTERREFLECT_REQUIRE_NODE=1 makes that a failure.
#![allow(clippy::unwrap_used, reason = "tests")]

use libtest_mimic::{Arguments, Failed, Trial};
use serde_json::{Value, json};
use std::process::{Command, ExitCode};

/// The scripts up to the page itself, which needs a document.
const SCRIPTS: [&str; 4] = [
    include_str!("../src/presenting/report/js/colour.js"),
    include_str!("../src/presenting/report/js/pixels.js"),
    include_str!("../src/presenting/report/js/canvas.js"),
    include_str!("../src/presenting/report/js/viewer.js"),
];

/// What a browser has and Node.js has not.
const STAND_INS: &str = "class ImageData { constructor(width, height) { this.width = width; \
    this.height = height; this.data = new Uint8ClampedArray(4 * width * height); } }\n\
    const bare = (type, fields) => Object.assign(Object.create(type.prototype), fields);\n";

/// An expression and its value. Numbers may be a rounding apart.
type Case = (&'static str, Value);

/// Cases that are tried together, by name.
type Group = (&'static str, fn() -> Vec<Case>);

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let required = std::env::var_os("INTERREFLECT_REQUIRE_NODE").is_some();
    let missing = Command::new("node").arg("--version").output().is_err() && !required;
    if missing {
        eprintln!("node is not installed: the arithmetic of the report's page is not tried");
    }
    let groups: [Group; 5] = [
        ("what_is_shown_is_exposed_clipped_and_encoded", shown),
        ("errors_are_signed_relative_and_coloured", errors),
        ("halves_are_unpacked_to_their_values", halves),
        ("the_sliders_scale_by_stops_and_round_numbers", sliders),
        (
            "canvases_keep_to_the_image_and_pictures_to_their_order",
            looks,
        ),
    ];
    let trials = groups
        .into_iter()
        .map(|(name, cases)| Trial::test(name, move || check(&cases())).with_ignored_flag(missing));
    libtest_mimic::run(&arguments, trials.collect()).exit_code()
}

fn check(cases: &[Case]) -> Result<(), Failed> {
    let folder = tempfile::tempdir()?;
    let file = folder.path().join("page.js");
    // What is no number in JSON is written as words.
    let asked: Vec<String> = cases.iter().map(|(e, _)| format!("() => ({e})")).collect();
    let script = format!(
        "{STAND_INS}{}\nconst plain = (_, v) => typeof v === 'number' && !Number.isFinite(v) ? String(v) \
         : Object.is(v, -0) ? 0 : ArrayBuffer.isView(v) ? Array.from(v) : v;\n\
         console.log(JSON.stringify([{}].map((f) => f()), plain));",
        SCRIPTS.concat(),
        asked.join(",\n")
    );
    std::fs::write(&file, script)?;
    let output = Command::new("node").arg(&file).output()?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned().into());
    }
    let found: Vec<Value> = serde_json::from_slice(&output.stdout)?;
    for ((expression, expected), found) in cases.iter().zip(&found) {
        if !alike(found, expected) {
            return Err(format!("{expression} is {found}, not {expected}").into());
        }
    }
    Ok(())
}

/// Equal, numbers up to a few roundings of float32, in which pixels are.
fn alike(found: &Value, expected: &Value) -> bool {
    match (found, expected) {
        (Value::Array(a), Value::Array(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| alike(a, b))
        }
        (Value::Number(a), Value::Number(b)) => {
            let [a, b] = [a, b].map(|n| n.as_f64().unwrap());
            (a - b).abs() <= 1e-6 * b.abs().max(1e-3)
        }
        _ => found == expected,
    }
}

/// Linear .18 is sRGB .461356, byte 117.65; .36 is .635957. Below .0031308 the curve is 12.92 times.
fn shown() -> Vec<Case> {
    vec![
        (
            "[0, 0.001, 0.0031308, 1, 2, -1, NaN, Infinity].map(srgbByte)",
            json!([0, 3.2946, 10.314_734, 255, 255, 0, 0, 255]),
        ),
        ("Math.round(srgbByte(0.18) * 100)", json!(11765)),
        // Exposure 2: .18, .36, 2; 1, 0, below 0.
        (
            "shownImage([0.09, 0.18, 1, 0.5, 0, -1], 2, 1, 2).data",
            json!([118, 162, 255, 255, 255, 0, 0, 255]),
        ),
        // Two columns, two rows: each pixel in its place.
        (
            "shownImage([0,0,0, 1,0,0, 0,1,0, 0,0,1], 2, 2, 1).data",
            json!([0, 0, 0, 255, 255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255]),
        ),
        ("words(0)", json!("0")),
        (
            "[0.12345, -12.3456, 9999.4, 0.001, 1e5, 0.00099, -1e-7].map(words)",
            json!([
                "0.1235", "-12.35", "9999", "0.001000", "1.00e+5", "9.90e-4", "-1.00e-7"
            ]),
        ),
    ]
}

fn errors() -> Vec<Case> {
    vec![
        // (0.01 · mean of 1, 2, 3)², the second pixel shows no surface.
        (
            "epsilonOf([1, -2, 3, 50, 60, 70], [1, 0], 0.01)",
            json!(4e-4),
        ),
        ("epsilonOf([1, -2, 3, 4, 5, 9], null, 0.5)", json!(4)),
        ("epsilonOf([1, 1, 1], [0], 0.01)", json!(0)),
        // Estimate less reference: too bright is positive.
        (
            "errorAt([0,0,0, 4, 2, 0], [0,0,0, 1, 2, 3], 1, null)",
            json!(0),
        ),
        ("errorAt([4, 5, 6], [1, 2, 0], 0, null)", json!(4)),
        ("errorAt([1, 2, 0], [4, 5, 6], 0, null)", json!(-4)),
        // 2/√(3² + 4²) each.
        ("errorAt([5, 5, 5], [3, 3, 3], 0, 16)", json!(0.4)),
        ("errorAt([1, 1, 1], [0, 0, 0], 0, 0)", json!(1)),
        (
            "[-1, -0.75, 0, 0.25, 1, -9, 9].map((f) => errorColour(f, [[0,10,20], [40,0,0], [60,60,60], \
             [80,0,0], [200,0,40]]))",
            json!([
                [0, 10, 20],
                [20, 5, 10],
                [60, 60, 60],
                [70, 30, 30],
                [200, 0, 40],
                [0, 10, 20],
                [200, 0, 40]
            ]),
        ),
        // Half of the range too bright; no surface; no number; in black as far as the range too dark.
        (
            "errorImage([2,2,2, 9,9,9, NaN,1,1, -3,-3,-3], [1,1,1, 1,1,1, 1,1,1, 1,1,1], [1, 0, 1, 1], 2, 2, \
             { epsilon: null, range: 2, stops: [[0,0,0], [100,100,100], [200,0,0]], nothing: [7,8,9] }).data",
            json!([150, 50, 50, 255, 7, 8, 9, 255, 7, 8, 9, 255, 0, 0, 0, 255]),
        ),
        // Relative: (4 − 2)/√(2² + 0) of a range of 2.
        (
            "errorImage([4,4,4], [2,2,2], null, 1, 1, { epsilon: 0, range: 2, stops: [[0,0,0], [100,0,0], \
             [200,0,0]], nothing: [7,8,9] }).data",
            json!([150, 0, 0, 255]),
        ),
    ]
}

fn halves() -> Vec<Case> {
    vec![
        (
            "[0x0000, 0x3800, 0x3c00, 0x4000, 0xbc00, 0xb400, 0x7bff, 0xfbff, 0x3555].map(halfToFloat)",
            json!([0, 0.5, 1, 2, -1, -0.25, 65504, -65504, 0.333_251_953_125]),
        ),
        // The least and the largest subnormal, and the least normal number.
        (
            "[0x0001, 0x03ff, 0x0400].map((b) => halfToFloat(b) * 2 ** 24)",
            json!([1, 1023, 1024]),
        ),
        (
            "[0x7c00, 0xfc00, 0x7e00].map(halfToFloat)",
            json!(["Infinity", "-Infinity", "NaN"]),
        ),
        // Red ½ then −1: 0x3800, then 0xbc00 − 0x3800 = 0x8400; green 1 then 0: 0x3c00, 0xc400; blue 2, 2.
        (
            "rgbOf(new Uint8Array([0x38,0x84,0,0, 0x3c,0xc4,0,0, 0x40,0,0,0]))",
            json!([0.5, 1, 2, -1, 0, 2]),
        ),
        // Lower bytes carry: 0x35ff + 0x0001 = 0x3600, ⅜.
        (
            "rgbOf(new Uint8Array([0x35,0,0xff,1, 0,0,0,0, 0,0,0,0]))[3]",
            json!(0.375),
        ),
    ]
}

fn sliders() -> Vec<Case> {
    vec![
        (
            "[0, 1, -1, 2.5].map((stops) => bare(Viewer, { row: { exposure: 3 }, stops }).exposure)",
            json!([3, 6, 1.5, 16.970_562_748]),
        ),
        (
            "[-4, -3, -1, 0, 1, 2, 3].map((steps) => bare(Viewer, { row: { range: 0.2 }, show: 'signed', steps }).range)",
            json!([0.01, 0.02, 0.1, 0.2, 0.5, 1, 2]),
        ),
        (
            "[-1, 0, 1].map((steps) => bare(Viewer, { row: { range: 50 }, show: 'signed', steps }).range)",
            json!([20, 50, 100]),
        ),
        // Relative errors begin at 1, whatever the row's range.
        (
            "[-2, 0, 2].map((steps) => bare(Viewer, { row: { range: 50 }, show: 'relative', steps }).range)",
            json!([0.2, 1, 5]),
        ),
    ]
}

/// Pictures a, b and c of two methods, with what flips between them.
fn looks() -> Vec<Case> {
    vec![
        (
            "[[0.5, 0.2, 0.9], [4, 0, 1], [1000, 0.3, 0.4]].map(([z, x, y]) => { const look = new Look(); \
             look.set(z, x, y); return [look.zoom, look.x, look.y]; })",
            json!([[1, 0.5, 0.5], [4, 0.125, 0.875], [64, 0.3, 0.4]]),
        ),
        // An image of 20 × 10 in 100 × 100: five times as large, and in the middle.
        (
            "(({ x, y, scale }) => [x, y, scale])(bare(Pane, { canvas: { clientWidth: 100, clientHeight: 100 }, \
             left: { width: 20, height: 10 }, look: { zoom: 1, x: 0.5, y: 0.5 } }).placed())",
            json!([0, 25, 5]),
        ),
        // Twice magnified about its upper left quarter.
        (
            "(({ x, y, scale }) => [x, y, scale])(bare(Pane, { canvas: { clientWidth: 100, clientHeight: 100 }, \
             left: { width: 20, height: 10 }, look: { zoom: 2, x: 0.25, y: 0.25 } }).placed())",
            json!([0, 25, 10]),
        ),
        // The pixel under a place; to the right of the line the other picture's.
        (
            "(() => { const read = []; const pane = bare(Pane, { canvas: { clientWidth: 100, clientHeight: 100 }, \
             left: { width: 20, height: 10 }, right: {}, split: 0.5, look: { zoom: 1, x: 0.5, y: 0.5 }, \
             onPixel: (...a) => read.push(a) }); pane.read({ x: 12, y: 31 }); pane.read({ x: 99, y: 74 }); \
             pane.read({ x: 12, y: 24 }); return read; })()",
            json!([[2, 1, false], [19, 9, true]]),
        ),
        // Magnifying about a place keeps what is under it: 12 of 100 is pixel 2.4 of 20.
        (
            "(() => { const look = new Look(); const pane = bare(Pane, { canvas: { clientWidth: 100, clientHeight: 100 }, \
             left: { width: 20, height: 10 }, look }); pane.pan({ x: 40, y: 45 }, { x: 40, y: 45 }, 2); \
             const { x, y, scale } = pane.placed(); return [(40 - x) / scale, (45 - y) / scale, look.zoom]; })()",
            json!([8, 4, 2]),
        ),
        (
            "(() => { const [a, b, c] = [['m', 'cpu'], ['n', 'cpu, r=1'], ['n', 'gpu, r=1']].map(([method, variant]) => \
             ({ method, variant })); const row = { pictures: [a, b, c] }; const v = bare(Viewer, { row, shown: a, \
             other: c, show: 'image', set(changes) { Object.assign(this, changes); } }); const at = () => \
             row.pictures.indexOf(v.shown); const seen = []; v.flip(1); seen.push(at()); v.flip(2); seen.push(at()); \
             v.flip(-1); seen.push(at()); v.swap(); seen.push(at(), row.pictures.indexOf(v.other)); v.openMethod('m'); \
             seen.push(at()); v.shown = c; v.openMethod('n'); seen.push(at()); v.shown = a; v.openMethod('n'); \
             seen.push(at()); v.cycle('show', ['image', 'signed', 'relative']); seen.push(v.show); \
             v.show = 'relative'; v.cycle('show', ['image', 'signed', 'relative']); seen.push(v.show); return seen; })()",
            json!([1, 0, 2, 2, 2, 0, 2, 1, "signed", "image"]),
        ),
    ]
}
