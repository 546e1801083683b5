//! What people do with a page, and what has to come of it.

use crate::browser::{click, focus, mouse, on_canvas, press, text, value, wait};
use crate::sample::SIZE;
use headless_chrome::Tab;
use headless_chrome::protocol::cdp::{Emulation, Input};
use libtest_mimic::Failed;

const PICTURE: &str = "document.getElementById('v-canvas').toDataURL()";
const CAPTION: &str = "document.getElementById('v-caption').textContent";

/// Does something and waits until the canvas shows something else.
fn changes(tab: &Tab, act: impl FnOnce() -> Result<(), Failed>) -> Result<(), Failed> {
    let before = text(tab, PICTURE)?;
    act()?;
    wait(tab, &format!("{PICTURE} !== {before:?}"))
}

fn shows(tab: &Tab, words: &str) -> Result<(), Failed> {
    wait(tab, &format!("{CAPTION}.includes({words:?})"))
}

pub(crate) fn exposure(tab: &Tab) -> Result<(), Failed> {
    focus(tab, "#v-exposure")?;
    changes(tab, || press(tab, "ArrowLeft"))?;
    wait(
        tab,
        "document.getElementById('v-exposure-value').textContent.startsWith('-0.1 stops')",
    )
}

pub(crate) fn split(tab: &Tab) -> Result<(), Failed> {
    click(tab, ".mark[href='#run-2']")?;
    changes(tab, || click(tab, "input[name=v-layout][value=split]"))?;
    focus(tab, "#v-split")?;
    changes(tab, || press(tab, "ArrowRight"))?;
    wait(tab, "document.getElementById('v-split').value === '50.5'")?;
    let (from, to) = (on_canvas(tab, [0.505, 0.5])?, on_canvas(tab, [0.25, 0.5])?);
    use Input::DispatchMouseEventTypeOption::{MouseMoved, MousePressed, MouseReleased};
    changes(tab, || {
        mouse(tab, MouseMoved, from)?;
        mouse(tab, MousePressed, from)?;
        mouse(tab, MouseMoved, to)?;
        mouse(tab, MouseReleased, to)
    })?;
    wait(
        tab,
        "Math.abs(document.getElementById('v-split').value - 25) < 1",
    )
}

pub(crate) fn plot_point(tab: &Tab) -> Result<(), Failed> {
    changes(tab, || click(tab, ".plot .mark[href='#run-3']"))?;
    shows(tab, "texels, cpu, resolution=8")?;
    wait(tab, "location.hash === '#run-3'")?;
    wait(
        tab,
        "document.querySelector(\".plot .mark[href='#run-3']\").hasAttribute('aria-current')",
    )?;
    click(tab, ".curves .mark[href='#run-2']")?;
    shows(tab, "texels, cpu, resolution=4")
}

pub(crate) fn link(tab: &Tab) -> Result<(), Failed> {
    value(tab, "location.hash = '#run-1'")?;
    shows(tab, "ambient")?;
    value(
        tab,
        "document.getElementById('viewer').removeAttribute('data-drawn'), location.reload()",
    )?;
    wait(
        tab,
        "document.getElementById('viewer')?.dataset.drawn !== undefined",
    )?;
    shows(tab, "ambient")
}

pub(crate) fn keys(tab: &Tab) -> Result<(), Failed> {
    shows(tab, "truth")?;
    changes(tab, || press(tab, "ArrowRight"))?;
    shows(tab, "ambient")?;
    changes(tab, || press(tab, "3"))?;
    shows(tab, "texels, cpu, resolution=4")?;
    changes(tab, || press(tab, "x"))?;
    shows(tab, "truth")?;
    changes(tab, || press(tab, "e"))?;
    wait(
        tab,
        "document.querySelector('input[name=v-show]:checked').value === 'signed'",
    )
}

pub(crate) fn read_out(tab: &Tab) -> Result<(), Failed> {
    click(tab, ".mark[href='#run-3']")?;
    shows(tab, "texels, cpu, resolution=8")?;
    // The middle of pixel 8, 4; the canvas may be wider or higher than the image.
    let sizes = text(
        tab,
        "(() => { const c = document.getElementById('v-canvas'); \
         return JSON.stringify([c.clientWidth, c.clientHeight]); })()",
    )?;
    let [width, height]: [f64; 2] = serde_json::from_str(&sizes)?;
    let scale = (width / SIZE.0 as f64).min(height / SIZE.1 as f64);
    let at = |pixel: f64, pixels: usize, extent: f64| {
        0.5 + scale * (pixel + 0.5 - pixels as f64 / 2.0) / extent
    };
    let place = on_canvas(tab, [at(8.0, SIZE.0, width), at(4.0, SIZE.1, height)])?;
    mouse(tab, Input::DispatchMouseEventTypeOption::MouseMoved, place)?;
    wait(
        tab,
        "document.getElementById('v-pixel').textContent === '8, 4'",
    )?;
    let cells = text(
        tab,
        "[...document.querySelectorAll('#v-values td')].map((c) => c.textContent).join(' ')",
    )?;
    let expected = "0.6250 0.3125 0.3125 0.5000 0.2500 0.2500 0.1250 0.06250 0.06250";
    match cells == expected {
        true => Ok(()),
        false => Err(format!("{cells}, not {expected}").into()),
    }
}

pub(crate) fn error_maps(tab: &Tab) -> Result<(), Failed> {
    click(tab, ".mark[href='#run-2']")?;
    shows(tab, "texels, cpu, resolution=4")?;
    changes(tab, || click(tab, "input[name=v-show][value=signed]"))?;
    // Twice the truth: 1.0 is the next round number above the largest mean error.
    let high = text(tab, "document.getElementById('v-high').textContent")?;
    if !high.ends_with("+1 W/m2") {
        return Err(format!("the colour bar ends at `{high}`").into());
    }
    focus(tab, "#v-range")?;
    changes(tab, || press(tab, "ArrowRight"))?;
    wait(
        tab,
        "document.getElementById('v-high').textContent.endsWith('+2 W/m2')",
    )?;
    changes(tab, || click(tab, "input[name=v-show][value=relative]"))
}

pub(crate) fn dark(tab: &Tab) -> Result<(), Failed> {
    const COLOURS: &str = "JSON.stringify([document.body, document.querySelector('.plot svg text'), \
        document.querySelector('.mark circle:not(.reach)')].map((n) => { const s = getComputedStyle(n); \
        return [s.backgroundColor, s.color, s.fill, s.stroke]; }))";
    let scheme = |name: &str| -> Result<String, Failed> {
        let media = Emulation::SetEmulatedMedia {
            media: None,
            features: Some(vec![Emulation::MediaFeature {
                name: "prefers-color-scheme".into(),
                value: name.into(),
            }]),
        };
        tab.call_method(media).map_err(|e| e.to_string())?;
        text(tab, COLOURS)
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
    let metrics = Emulation::SetDeviceMetricsOverride {
        width: 390,
        height: 844,
        device_scale_factor: 2.0,
        mobile: true,
        scale: None,
        screen_width: None,
        screen_height: None,
        position_x: None,
        position_y: None,
        dont_set_visible_size: None,
        screen_orientation: None,
        viewport: None,
        display_feature: None,
        device_posture: None,
    };
    tab.call_method(metrics).map_err(|e| e.to_string())?;
    // What is wider than the screen widens the window of a page on a phone.
    let fits = "innerWidth === 390 && document.documentElement.scrollWidth === 390";
    wait(tab, fits)?;
    for layout in ["split", "all"] {
        click(tab, &format!("input[name=v-layout][value={layout}]"))?;
        wait(tab, fits)?;
    }
    Ok(())
}

pub(crate) fn pinch(tab: &Tab) -> Result<(), Failed> {
    use Input::DispatchTouchEventTypeOption::{TouchEnd, TouchMove, TouchStart};
    let touch = |kind, fingers: &[[f64; 2]]| -> Result<(), Failed> {
        let finger = |(id, at): (usize, &[f64; 2])| Input::TouchPoint {
            x: at[0],
            y: at[1],
            radius_x: None,
            radius_y: None,
            rotation_angle: None,
            force: None,
            tangential_pressure: None,
            tilt_x: None,
            tilt_y: None,
            twist: None,
            id: Some(id as f64),
        };
        let event = Input::DispatchTouchEvent {
            Type: kind,
            touch_points: fingers.iter().enumerate().map(finger).collect(),
            modifiers: None,
            timestamp: None,
        };
        Ok(tab
            .call_method(event)
            .map(drop)
            .map_err(|e| e.to_string())?)
    };
    let places = |apart: f64| -> Result<[[f64; 2]; 2], Failed> {
        Ok([
            on_canvas(tab, [0.5 - apart, 0.5])?,
            on_canvas(tab, [0.5 + apart, 0.5])?,
        ])
    };
    let (near, far) = (places(0.05)?, places(0.2)?);
    changes(tab, || {
        touch(TouchStart, &near)?;
        touch(TouchMove, &far)?;
        touch(TouchEnd, &[])
    })?;
    wait(
        tab,
        "document.getElementById('v-canvas').classList.contains('zoomed')",
    )?;
    changes(tab, || press(tab, "f"))
}
