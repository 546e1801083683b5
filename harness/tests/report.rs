//! The report in a browser: a page of three runs is opened from a file and used as people would.
//!
//! Shown as ignored where no Chromium or Chrome is found; INTERREFLECT_REQUIRE_BROWSER=1 makes that a
//! failure. CHROME names a browser that is not in PATH.
#![allow(clippy::unwrap_used, reason = "tests")]

use glam::Vec3;
use headless_chrome::browser::default_executable;
use headless_chrome::protocol::cdp::types::Event;
use headless_chrome::protocol::cdp::{Emulation, Input, Log, Network, Runtime};
use headless_chrome::{Browser, LaunchOptions, Tab};
use interreflect::machine::Machine;
use interreflect::output::HdrImage;
use interreflect::record::{Backend, Comparison, Phases, Results, Run, Timing, Verdict};
use interreflect::report::{ImageRow, LabelledImage, Report};
use interreflect_scene::params::Value;
use libtest_mimic::{Arguments, Failed, Trial};
use std::ffi::OsStr;
use std::process::ExitCode;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// Size of the images in pixels.
const SIZE: (usize, usize) = (24, 16);

type Check = fn(&Tab) -> Result<(), Failed>;

/// What is tried, each in a tab of its own.
const CHECKS: [(&str, Check); 9] = [
    ("the_exposure_slider_changes_the_image", exposure),
    ("the_split_moves_by_slider_and_by_pointer", split),
    ("a_point_of_the_plot_opens_its_image", plot_point),
    ("a_link_to_a_run_opens_its_image", link),
    ("keys_flip_between_images", keys),
    ("the_pixel_under_the_pointer_is_read_out", read_out),
    ("error_maps_have_a_colour_bar_that_scales", error_maps),
    ("dark_mode_has_other_colours", dark),
    ("a_phone_scrolls_in_one_direction_only", phone),
];

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let required = std::env::var_os("INTERREFLECT_REQUIRE_BROWSER").is_some();
    let missing = default_executable().is_err() && !required;
    let trials = CHECKS.into_iter().map(|(name, check)| {
        let trial = Trial::test(name, move || in_page(check));
        trial.with_ignored_flag(missing)
    });
    if missing {
        eprintln!("no Chromium or Chrome in PATH: the report's page is not tried");
    }
    libtest_mimic::run(&arguments, trials.collect()).exit_code()
}

fn comparison(relmse: f64) -> Option<Comparison> {
    Some(Comparison {
        relmse: Some(relmse),
        rmse: 0.1,
        energy_ratio: Some(0.9),
        p999: 0.2,
        max: 0.3,
        noise_floor: Some(1e-4),
        verdict: Verdict::Conclusive,
        relmse_above_noise: Some(relmse),
        noise_floor_rmse: 0.01,
        epsilon: 1e-4,
        compared: 384,
        reference: None,
    })
}

/// An image whose red grows by a sixteenth with every column, times a factor.
fn image(factor: f32) -> HdrImage {
    let mut image = HdrImage::new(SIZE.0, SIZE.1);
    for (i, pixel) in image.pixels.iter_mut().enumerate() {
        let (x, y) = ((i % SIZE.0) as f32, (i / SIZE.0) as f32);
        *pixel = factor * Vec3::new(x / 16.0, y / 16.0, 0.25);
    }
    image
}

/// Three runs, two of which differ in a parameter.
fn report() -> Report {
    let run = |estimator: &str, resolution: u32, ms: f64, relmse: f64| Run {
        params: [("resolution", Value::U32(resolution))]
            .into_iter()
            .collect(),
        points: 384,
        phases_ms: Phases {
            shade: Timing::of(&[ms, 1.1 * ms]),
            ..Phases::default()
        },
        own_model: comparison(relmse),
        truth: comparison(relmse),
        ..Run::new("box", estimator, Backend::Cpu, "irradiance")
    };
    let runs = vec![
        run("ambient", 4, 0.1, 0.4),
        run("texels", 4, 1.0, 0.1),
        run("texels", 8, 4.0, 0.01),
    ];
    let labelled = |label: &str, run: Option<usize>, factor: f32| LabelledImage {
        label: label.into(),
        note: "cpu".into(),
        run,
        image: image(factor),
    };
    let rows = vec![ImageRow {
        scene: "box".into(),
        quantity: "irradiance".into(),
        reference: labelled("truth", None, 1.0),
        estimates: vec![
            labelled("ambient", Some(0), 0.5),
            labelled("texels", Some(1), 2.0),
            labelled("texels", Some(2), 1.25),
        ],
        surfaces: Some((0..SIZE.0 * SIZE.1).map(|i| i != 0).collect()),
    }];
    let results = Results {
        machine: Machine::detect(2, "avx2", None),
        command: "interreflect bench box".into(),
        seed: Some(1),
        runs,
    };
    Report::new(&results, rows)
}

/// A page in a browser of its own; what the page complained about or asked of others is a failure.
fn in_page(check: Check) -> Result<(), Failed> {
    let folder = tempfile::tempdir()?;
    let file = folder.path().join("report.html");
    report().write(&file)?;
    let flags = [
        "--disable-quic",
        "--no-first-run",
        "--disable-component-update",
        "--disable-sync",
    ];
    let options = LaunchOptions {
        sandbox: false,
        window_size: Some((1440, 900)),
        path: Some(default_executable()?),
        args: flags.iter().map(OsStr::new).collect(),
        ..LaunchOptions::default()
    };
    let browser = Browser::new(options).map_err(|e| e.to_string())?;
    let tab = browser.new_tab().map_err(|e| e.to_string())?;
    let heard = Arc::new(Mutex::new(Heard::default()));
    listen(&tab, &heard)?;
    let url = format!("file://{}", file.display());
    tab.navigate_to(&url).map_err(|e| e.to_string())?;
    wait(
        &tab,
        "document.getElementById('viewer')?.dataset.drawn !== undefined",
    )?;
    check(&tab)?;
    let heard = heard.lock().unwrap();
    match (heard.own_file, heard.complaints.is_empty()) {
        (true, true) => Ok(()),
        (false, _) => Err("the browser did not tell what it asks for".into()),
        (_, false) => Err(heard.complaints.join("; ").into()),
    }
}

/// What the browser told of the page.
#[derive(Default)]
struct Heard {
    /// Errors, exceptions, and requests to anything but the page's own file.
    complaints: Vec<String>,
    /// Whether it told of the request for the page itself.
    own_file: bool,
}

impl Heard {
    fn hear(&mut self, event: &Event) {
        let complaint = match event {
            Event::RuntimeExceptionThrown(e) => {
                format!("exception: {:?}", e.params.exception_details)
            }
            Event::RuntimeConsoleAPICalled(e) => format!("console: {:?}", e.params.args),
            Event::LogEntryAdded(e) => format!("log: {}", e.params.entry.text),
            Event::NetworkRequestWillBeSent(e) => {
                let url = &e.params.request.url;
                self.own_file |= url.starts_with("file:");
                if url.starts_with("file:") || url.starts_with("data:") {
                    return;
                }
                format!("request: {url}")
            }
            _ => return,
        };
        self.complaints.push(complaint);
    }
}

fn listen(tab: &Tab, heard: &Arc<Mutex<Heard>>) -> Result<(), Failed> {
    let heard = heard.clone();
    let listener = move |event: &Event| heard.lock().unwrap().hear(event);
    let enabled = tab
        .add_event_listener(Arc::new(listener))
        .and_then(|_| tab.call_method(Runtime::Enable(None)).map(drop))
        .and_then(|()| tab.call_method(Log::Enable(None)).map(drop))
        .and_then(|()| {
            let network = Network::Enable {
                max_total_buffer_size: None,
                max_resource_buffer_size: None,
                max_post_data_size: None,
                report_direct_socket_traffic: None,
                enable_durable_messages: None,
            };
            tab.call_method(network).map(drop)
        });
    Ok(enabled.map_err(|e| e.to_string())?)
}

/// What an expression gives in the page.
fn value(tab: &Tab, expression: &str) -> Result<serde_json::Value, Failed> {
    let object = tab.evaluate(expression, true).map_err(|e| e.to_string())?;
    Ok(object.value.unwrap_or_default())
}

fn text(tab: &Tab, expression: &str) -> Result<String, Failed> {
    let value = value(tab, expression)?;
    let text = value.as_str().map(str::to_owned);
    text.ok_or_else(|| format!("{expression} is {value}").into())
}

/// Waits until an expression is true in the page.
fn wait(tab: &Tab, expression: &str) -> Result<(), Failed> {
    let end = Instant::now() + Duration::from_secs(20);
    while value(tab, expression)? != true {
        if Instant::now() > end {
            return Err(format!("never: {expression}").into());
        }
        std::thread::sleep(Duration::from_millis(20));
    }
    Ok(())
}

fn click(tab: &Tab, selector: &str) -> Result<(), Failed> {
    let clicked = tab.find_element(selector).and_then(|e| e.click().map(drop));
    Ok(clicked.map_err(|e| format!("{selector}: {e}"))?)
}

fn press(tab: &Tab, key: &str) -> Result<(), Failed> {
    Ok(tab
        .press_key(key)
        .map(drop)
        .map_err(|e| format!("{key}: {e}"))?)
}

fn focus(tab: &Tab, selector: &str) -> Result<(), Failed> {
    let focused = tab.find_element(selector).and_then(|e| e.focus().map(drop));
    Ok(focused.map_err(|e| format!("{selector}: {e}"))?)
}

/// The mouse at a place of the page's window.
fn mouse(tab: &Tab, kind: Input::DispatchMouseEventTypeOption, at: [f64; 2]) -> Result<(), Failed> {
    let event = Input::DispatchMouseEvent {
        Type: kind,
        x: at[0],
        y: at[1],
        modifiers: None,
        timestamp: None,
        button: Some(Input::MouseButton::Left),
        buttons: None,
        click_count: None,
        force: None,
        tangential_pressure: None,
        tilt_x: None,
        tilt_y: None,
        twist: None,
        delta_x: None,
        delta_y: None,
        pointer_Type: None,
    };
    Ok(tab
        .call_method(event)
        .map(drop)
        .map_err(|e| e.to_string())?)
}

/// A place of the canvas as fractions of its size, in the page's window.
fn on_canvas(tab: &Tab, [x, y]: [f64; 2]) -> Result<[f64; 2], Failed> {
    let bounds = text(
        tab,
        "(() => { const c = document.getElementById('v-canvas'); c.scrollIntoView({ block: 'nearest' }); \
         const b = c.getBoundingClientRect(); \
         return JSON.stringify([b.left, b.top, b.width, b.height]); })()",
    )?;
    let [left, top, width, height]: [f64; 4] = serde_json::from_str(&bounds)?;
    Ok([left + x * width, top + y * height])
}

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

fn exposure(tab: &Tab) -> Result<(), Failed> {
    focus(tab, "#v-exposure")?;
    changes(tab, || press(tab, "ArrowLeft"))?;
    wait(
        tab,
        "document.getElementById('v-exposure-value').textContent.startsWith('-0.1 stops')",
    )
}

fn split(tab: &Tab) -> Result<(), Failed> {
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

fn plot_point(tab: &Tab) -> Result<(), Failed> {
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

fn link(tab: &Tab) -> Result<(), Failed> {
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

fn keys(tab: &Tab) -> Result<(), Failed> {
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

fn read_out(tab: &Tab) -> Result<(), Failed> {
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

fn error_maps(tab: &Tab) -> Result<(), Failed> {
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

fn dark(tab: &Tab) -> Result<(), Failed> {
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

fn phone(tab: &Tab) -> Result<(), Failed> {
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
    wait(tab, "innerWidth === 390")?;
    wait(tab, "document.documentElement.scrollWidth <= innerWidth")?;
    for layout in ["split", "all"] {
        click(tab, &format!("input[name=v-layout][value={layout}]"))?;
        wait(tab, "document.documentElement.scrollWidth <= innerWidth")?;
    }
    Ok(())
}
