//! What people do with a page, and what has to come of it.

use crate::browser::{PATIENCE, Tab};
use crate::sample::SIZE;
use chromiumoxide::cdp::browser_protocol::emulation::{
    MediaFeature, SetDeviceMetricsOverrideParams, SetEmulatedMediaParams,
};
use chromiumoxide::cdp::browser_protocol::input::{
    DispatchMouseEventType, DispatchTouchEventParams, DispatchTouchEventType, TouchPoint,
};
use interreflect::output::{NOTHING, STOPS};
use libtest_mimic::Failed;
use std::time::{Duration, Instant};

const PICTURE: &str = "document.getElementById('v-canvas').toDataURL()";
const CAPTION: &str = "document.getElementById('v-caption').textContent";

/// Does something and waits until the canvas shows something else.
fn changes(tab: &Tab, act: impl FnOnce() -> Result<(), Failed>) -> Result<(), Failed> {
    let before = tab.text(PICTURE)?;
    act()?;
    tab.wait(&format!("{PICTURE} !== {before:?}"))
}

fn shows(tab: &Tab, words: &str) -> Result<(), Failed> {
    tab.wait(&format!("{CAPTION}.includes({words:?})"))
}

pub(crate) fn exposure(tab: &Tab) -> Result<(), Failed> {
    tab.focus("#v-exposure")?;
    changes(tab, || tab.press("ArrowLeft"))?;
    tab.wait("document.getElementById('v-exposure-value').textContent.startsWith('-0.1 stops')")
}

pub(crate) fn split(tab: &Tab) -> Result<(), Failed> {
    tab.click(".mark[href='#run-2']")?;
    changes(tab, || tab.click("input[name=v-layout][value=split]"))?;
    tab.focus("#v-split")?;
    changes(tab, || tab.press("ArrowRight"))?;
    tab.wait("document.getElementById('v-split').value === '50.5'")?;
    let (from, to) = (tab.on_canvas([0.505, 0.5])?, tab.on_canvas([0.25, 0.5])?);
    use DispatchMouseEventType::{MouseMoved, MousePressed, MouseReleased};
    changes(tab, || {
        tab.mouse(MouseMoved, from)?;
        tab.mouse(MousePressed, from)?;
        tab.mouse(MouseMoved, to)?;
        tab.mouse(MouseReleased, to)
    })?;
    tab.wait("Math.abs(document.getElementById('v-split').value - 25) < 1")
}

pub(crate) fn plot_point(tab: &Tab) -> Result<(), Failed> {
    changes(tab, || tab.click(".plot .mark[href='#run-3']"))?;
    shows(tab, "texels, cpu, resolution=8")?;
    tab.wait("location.hash === '#run-3'")?;
    tab.wait(
        "document.querySelector(\".plot .mark[href='#run-3']\").hasAttribute('aria-current')",
    )?;
    tab.click(".curves .mark[href='#run-2']")?;
    shows(tab, "texels, cpu, resolution=4")
}

pub(crate) fn link(tab: &Tab) -> Result<(), Failed> {
    tab.value("location.hash = '#run-1'")?;
    shows(tab, "ambient")?;
    tab.value(
        "document.getElementById('viewer').removeAttribute('data-drawn'), location.reload()",
    )?;
    tab.wait("document.getElementById('viewer')?.dataset.drawn !== undefined")?;
    shows(tab, "ambient")
}

pub(crate) fn keys(tab: &Tab) -> Result<(), Failed> {
    shows(tab, "truth")?;
    changes(tab, || tab.press("ArrowRight"))?;
    shows(tab, "ambient")?;
    changes(tab, || tab.press("3"))?;
    shows(tab, "texels, cpu, resolution=4")?;
    changes(tab, || tab.press("x"))?;
    shows(tab, "truth")?;
    changes(tab, || tab.press("e"))?;
    tab.wait("document.querySelector('input[name=v-show]:checked').value === 'signed'")
}

pub(crate) fn read_out(tab: &Tab) -> Result<(), Failed> {
    tab.click(".mark[href='#run-3']")?;
    shows(tab, "texels, cpu, resolution=8")?;
    // The middle of pixel 8, 4; the canvas may be wider or higher than the image.
    let sizes = tab.text(
        "(() => { const c = document.getElementById('v-canvas'); \
         return JSON.stringify([c.clientWidth, c.clientHeight]); })()",
    )?;
    let [width, height]: [f64; 2] = serde_json::from_str(&sizes)?;
    let scale = (width / SIZE.0 as f64).min(height / SIZE.1 as f64);
    let at = |pixel: f64, pixels: usize, extent: f64| {
        0.5 + scale * (pixel + 0.5 - pixels as f64 / 2.0) / extent
    };
    let place = tab.on_canvas([at(8.0, SIZE.0, width), at(4.0, SIZE.1, height)])?;
    tab.mouse(DispatchMouseEventType::MouseMoved, place)?;
    tab.wait("document.getElementById('v-pixel').textContent === '8, 4'")?;
    let cells = tab.text(
        "[...document.querySelectorAll('#v-values td')].map((c) => c.textContent).join(' ')",
    )?;
    let expected = "0.6250 0.3125 0.3125 0.5000 0.2500 0.2500 0.1250 0.06250 0.06250";
    match cells == expected {
        true => Ok(()),
        false => Err(format!("{cells}, not {expected}").into()),
    }
}

pub(crate) fn error_maps(tab: &Tab) -> Result<(), Failed> {
    tab.click(".mark[href='#run-2']")?;
    shows(tab, "texels, cpu, resolution=4")?;
    changes(tab, || tab.click("input[name=v-show][value=signed]"))?;
    // Twice the truth: 1.0 is the next round number above the largest mean error.
    let high = tab.text("document.getElementById('v-high').textContent")?;
    if !high.ends_with("+1 W/m2") {
        return Err(format!("the colour bar ends at `{high}`").into());
    }
    tab.focus("#v-range")?;
    changes(tab, || tab.press("ArrowRight"))?;
    tab.wait("document.getElementById('v-high').textContent.endsWith('+2 W/m2')")?;
    changes(tab, || tab.click("input[name=v-show][value=relative]"))
}

pub(crate) fn dark(tab: &Tab) -> Result<(), Failed> {
    const COLOURS: &str = "JSON.stringify([document.body, document.querySelector('.plot svg text'), \
        document.querySelector('.mark circle:not(.reach)')].map((n) => { const s = getComputedStyle(n); \
        return [s.backgroundColor, s.color, s.fill, s.stroke]; }))";
    let scheme = |name: &str| -> Result<String, Failed> {
        tab.execute(SetEmulatedMediaParams {
            features: Some(vec![MediaFeature::new("prefers-color-scheme", name)]),
            ..SetEmulatedMediaParams::default()
        })?;
        tab.text(COLOURS)
    };
    let light: Vec<Vec<String>> = serde_json::from_str(&scheme("light")?)?;
    let dark: Vec<Vec<String>> = serde_json::from_str(&scheme("dark")?)?;
    let same = light.iter().zip(&dark).position(|(l, d)| l == d);
    match same {
        None => Ok(()),
        Some(i) => Err(format!("element {i} is the same in light and dark: {:?}", dark[i]).into()),
    }
}

pub(crate) fn phone(tab: &Tab) -> Result<(), Failed> {
    tab.execute(SetDeviceMetricsOverrideParams::new(390, 844, 2.0, true))?;
    // What is wider than the screen widens the window of a page on a phone.
    let fits = "innerWidth === 390 && document.documentElement.scrollWidth === 390";
    tab.wait(fits)?;
    for layout in ["split", "all"] {
        tab.click(&format!("input[name=v-layout][value={layout}]"))?;
        tab.wait(fits)?;
    }
    Ok(())
}

pub(crate) fn pinch(tab: &Tab) -> Result<(), Failed> {
    let touch = |kind, fingers: [[f64; 2]; 2]| {
        let finger = |id: usize| TouchPoint {
            id: Some(id as f64),
            ..TouchPoint::new(fingers[id][0], fingers[id][1])
        };
        tab.execute(DispatchTouchEventParams::new(
            kind,
            vec![finger(0), finger(1)],
        ))
    };
    let places = |apart: f64| -> Result<[[f64; 2]; 2], Failed> {
        Ok([
            tab.on_canvas([0.5 - apart, 0.5])?,
            tab.on_canvas([0.5 + apart, 0.5])?,
        ])
    };
    let (near, far) = (places(0.05)?, places(0.2)?);
    changes(tab, || {
        touch(DispatchTouchEventType::TouchStart, near)?;
        touch(DispatchTouchEventType::TouchMove, far)
    })?;
    tab.wait("document.getElementById('v-canvas').classList.contains('zoomed')")?;
    changes(tab, || tab.press("f"))
}

/// A pixel of the canvas, red, green and blue, where the middle of a pixel of the image lies. It is read from
/// a copy: Chromium warns of canvases that are read often.
fn pixel(tab: &Tab, [column, row]: [usize; 2]) -> Result<[f64; 3], Failed> {
    let read = tab.text(&format!(
        "(() => {{ const c = document.getElementById('v-canvas'); \
         const s = Math.min(c.width / {w}, c.height / {h}); \
         const at = (i, n, extent) => Math.floor(extent / 2 + s * (i + 0.5 - n / 2)); \
         const copy = new OffscreenCanvas(1, 1).getContext('2d', {{ willReadFrequently: true }}); \
         copy.drawImage(c, -at({column}, {w}, c.width), -at({row}, {h}, c.height)); \
         const p = copy.getImageData(0, 0, 1, 1); \
         return JSON.stringify([...p.data.slice(0, 3)]); }})()",
        w = SIZE.0,
        h = SIZE.1,
    ))?;
    Ok(serde_json::from_str(&read)?)
}

/// Waits until a pixel of the image is shown as it should be, to a byte's rounding: the page draws while it is
/// looked at.
fn shows_pixel(tab: &Tab, at: [usize; 2], expected: [f64; 3]) -> Result<(), Failed> {
    let end = Instant::now() + PATIENCE;
    loop {
        let found = pixel(tab, at)?;
        let apart = found.iter().zip(expected).map(|(a, b)| (a - b).abs());
        if apart.fold(0.0, f64::max) <= 1.0 {
            return Ok(());
        }
        if Instant::now() > end {
            return Err(format!("a pixel is {found:?}, not {expected:?}").into());
        }
        std::thread::sleep(Duration::from_millis(20));
    }
}

/// Column 8, row 4 of the third run is 1.25 times (8/16, 4/16, ¼), column 23 the brightest of the truth, which
/// shows as 0.9 of white. A step of the keys is half a stop. Errors: a quarter of the truth's.
pub(crate) fn pixels(tab: &Tab) -> Result<(), Failed> {
    tab.click(".mark[href='#run-3']")?;
    shows(tab, "texels, cpu, resolution=8")?;
    let shown = |stops: f64| {
        let exposure = 0.9 / (23.0 / 16.0) * stops.exp2();
        [0.625, 0.3125, 0.3125].map(|linear: f64| {
            let v = (linear * exposure).min(1.0);
            255.0 * (1.055 * v.powf(1.0 / 2.4) - 0.055)
        })
    };
    shows_pixel(tab, [8, 4], shown(0.0))?;
    changes(tab, || tab.press("="))?;
    shows_pixel(tab, [8, 4], shown(0.5))?;
    changes(tab, || tab.press("-"))?;
    changes(tab, || tab.press("-"))?;
    shows_pixel(tab, [8, 4], shown(-0.5))?;
    // Half as bright as the truth: too dark by half of the mean of (½, ¼, ¼), of a range of 1.
    tab.click(".mark[href='#run-1']")?;
    shows(tab, "ambient")?;
    changes(tab, || tab.click("input[name=v-show][value=signed]"))?;
    let place: f64 = (1.0 - 1.0 / 6.0) * 0.5 * 4.0;
    let (lower, t) = (place as usize, place - place.floor());
    let [a, b] = [STOPS[lower], STOPS[lower + 1]].map(|c| c.map(f64::from));
    let colour = [0, 1, 2].map(|c| a[c] + t * (b[c] - a[c]));
    shows_pixel(tab, [8, 4], colour)?;
    let [r, g, b, _] = NOTHING.0.map(f64::from);
    shows_pixel(tab, [0, 0], [r, g, b])
}
