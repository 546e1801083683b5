//! A page in a browser, and what can be done with it.

use crate::sample::report;
use headless_chrome::browser::default_executable;
use headless_chrome::protocol::cdp::types::Event;
use headless_chrome::protocol::cdp::{Input, Log, Network, Runtime};
use headless_chrome::{Browser, LaunchOptions, Tab};
use libtest_mimic::Failed;
use std::ffi::OsStr;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// Something that is tried in a page.
pub(crate) type Check = fn(&Tab) -> Result<(), Failed>;

/// A page in a browser of its own; what the page complained about or asked of others is a failure.
pub(crate) fn in_page(check: Check) -> Result<(), Failed> {
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
pub(crate) fn value(tab: &Tab, expression: &str) -> Result<serde_json::Value, Failed> {
    let object = tab.evaluate(expression, true).map_err(|e| e.to_string())?;
    Ok(object.value.unwrap_or_default())
}

pub(crate) fn text(tab: &Tab, expression: &str) -> Result<String, Failed> {
    let value = value(tab, expression)?;
    let text = value.as_str().map(str::to_owned);
    text.ok_or_else(|| format!("{expression} is {value}").into())
}

/// Waits until an expression is true in the page.
pub(crate) fn wait(tab: &Tab, expression: &str) -> Result<(), Failed> {
    let end = Instant::now() + Duration::from_secs(20);
    while value(tab, expression)? != true {
        if Instant::now() > end {
            return Err(format!("never: {expression}").into());
        }
        std::thread::sleep(Duration::from_millis(20));
    }
    Ok(())
}

pub(crate) fn click(tab: &Tab, selector: &str) -> Result<(), Failed> {
    let clicked = tab.find_element(selector).and_then(|e| e.click().map(drop));
    Ok(clicked.map_err(|e| format!("{selector}: {e}"))?)
}

pub(crate) fn press(tab: &Tab, key: &str) -> Result<(), Failed> {
    Ok(tab
        .press_key(key)
        .map(drop)
        .map_err(|e| format!("{key}: {e}"))?)
}

pub(crate) fn focus(tab: &Tab, selector: &str) -> Result<(), Failed> {
    let focused = tab.find_element(selector).and_then(|e| e.focus().map(drop));
    Ok(focused.map_err(|e| format!("{selector}: {e}"))?)
}

/// The mouse at a place of the page's window.
pub(crate) fn mouse(
    tab: &Tab,
    kind: Input::DispatchMouseEventTypeOption,
    at: [f64; 2],
) -> Result<(), Failed> {
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
pub(crate) fn on_canvas(tab: &Tab, [x, y]: [f64; 2]) -> Result<[f64; 2], Failed> {
    let bounds = text(
        tab,
        "(() => { const c = document.getElementById('v-canvas'); c.scrollIntoView({ block: 'nearest' }); \
         const b = c.getBoundingClientRect(); \
         return JSON.stringify([b.left, b.top, b.width, b.height]); })()",
    )?;
    let [left, top, width, height]: [f64; 4] = serde_json::from_str(&bounds)?;
    Ok([left + x * width, top + y * height])
}
