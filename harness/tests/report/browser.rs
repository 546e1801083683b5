//! A page in a browser, and what can be done with it.

use crate::sample::report;
use chromiumoxide::browser::{Browser, BrowserConfig};
use chromiumoxide::cdp::IntoEventKind;
use chromiumoxide::cdp::browser_protocol::input::{
    DispatchMouseEventParams, DispatchMouseEventType, MouseButton,
};
use chromiumoxide::cdp::browser_protocol::{log, network};
use chromiumoxide::cdp::js_protocol::runtime::{
    EvaluateParams, EventConsoleApiCalled, EventExceptionThrown,
};
use chromiumoxide::{Command, Page};
use futures::StreamExt as _;
use libtest_mimic::Failed;
use std::path::Path;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};
use tokio::runtime::Runtime;

/// The longest that a browser may take to start or to answer. It answers at once, but on a machine that
/// is busy with something else it may have to wait for its turn.
pub(crate) const PATIENCE: Duration = Duration::from_secs(180);

/// Something that is tried in a page.
pub(crate) type Check = fn(&Tab) -> Result<(), Failed>;

/// An open page.
pub(crate) struct Tab {
    runtime: Runtime,
    page: Page,
    heard: Arc<Mutex<Heard>>,
}

/// What the browser told of the page.
#[derive(Default)]
struct Heard {
    /// Errors, exceptions, and requests to anything but the page's own file.
    complaints: Vec<String>,
    /// Whether it told of the request for the page itself.
    own_file: bool,
}

/// How to start a browser with a folder of its own; an error where there is none.
pub(crate) fn config(profile: &Path) -> Result<BrowserConfig, String> {
    BrowserConfig::builder()
        .no_sandbox()
        .window_size(1440, 900)
        .viewport(None)
        .user_data_dir(profile)
        .launch_timeout(PATIENCE)
        .request_timeout(PATIENCE)
        .args([
            "disable-gpu",
            "disable-quic",
            "no-first-run",
            "disable-sync",
        ])
        .args(["disable-background-networking", "disable-component-update"])
        .build()
}

/// Tries something in a page in a browser of its own; what the page complained about or asked of others
/// is a failure too.
pub(crate) fn in_page(check: Check) -> Result<(), Failed> {
    let folder = tempfile::tempdir()?;
    let file = folder.path().join("report.html");
    report().write(&file)?;
    let runtime = Runtime::new()?;
    let config = config(&folder.path().join("profile"))?;
    let (mut browser, page) = runtime.block_on(async {
        let (browser, mut handler) = Browser::launch(config).await?;
        tokio::spawn(async move { while handler.next().await.is_some() {} });
        let page = browser.new_page("about:blank").await?;
        Ok::<_, chromiumoxide::error::CdpError>((browser, page))
    })?;
    let heard = Arc::default();
    let tab = Tab {
        runtime,
        page,
        heard,
    };
    let tried = tab
        .open(&file)
        .and_then(|()| check(&tab))
        .and_then(|()| tab.verdict());
    tab.runtime.block_on(async {
        // It ends with the program at the latest.
        let _ = browser.close().await;
        let _ = browser.wait().await;
    });
    tried
}

impl Tab {
    fn open(&self, file: &Path) -> Result<(), Failed> {
        self.listen(|heard, e: &EventExceptionThrown| {
            heard
                .complaints
                .push(format!("exception: {:?}", e.exception_details));
        })?;
        self.listen(|heard, e: &EventConsoleApiCalled| {
            heard.complaints.push(format!("console: {:?}", e.args));
        })?;
        self.listen(|heard, e: &log::EventEntryAdded| {
            heard.complaints.push(format!("log: {}", e.entry.text));
        })?;
        self.listen(|heard, e: &network::EventRequestWillBeSent| {
            let url = &e.request.url;
            heard.own_file |= url.starts_with("file:");
            if !url.starts_with("file:") && !url.starts_with("data:") {
                heard.complaints.push(format!("request: {url}"));
            }
        })?;
        self.execute(log::EnableParams::default())?;
        self.execute(network::EnableParams::default())?;
        let url = format!("file://{}", file.display());
        self.runtime.block_on(self.page.goto(url))?;
        self.wait("document.getElementById('viewer')?.dataset.drawn !== undefined")
    }

    /// Has a kind of events heard from now on.
    fn listen<E: IntoEventKind + Unpin>(
        &self,
        hear: impl Fn(&mut Heard, &E) + Send + 'static,
    ) -> Result<(), Failed> {
        let mut events = self.runtime.block_on(self.page.event_listener::<E>())?;
        let heard = self.heard.clone();
        self.runtime.spawn(async move {
            while let Some(event) = events.next().await {
                hear(&mut heard.lock().unwrap(), &event);
            }
        });
        Ok(())
    }

    fn verdict(&self) -> Result<(), Failed> {
        // Events are heard on another thread, which may come after what is asked here.
        let end = Instant::now() + PATIENCE;
        while !self.heard.lock().unwrap().own_file && Instant::now() < end {
            std::thread::sleep(Duration::from_millis(20));
        }
        let heard = self.heard.lock().unwrap();
        match (heard.own_file, heard.complaints.is_empty()) {
            (true, true) => Ok(()),
            (false, _) => Err("the browser did not tell what it asks for".into()),
            (_, false) => Err(heard.complaints.join("; ").into()),
        }
    }

    /// Asks the browser for something that is not here.
    pub(crate) fn execute(&self, command: impl Command) -> Result<(), Failed> {
        self.runtime.block_on(self.page.execute(command))?;
        Ok(())
    }

    /// What an expression gives in the page.
    pub(crate) fn value(&self, expression: &str) -> Result<serde_json::Value, Failed> {
        let evaluated = self.runtime.block_on(
            self.page
                .evaluate_expression(EvaluateParams::from(expression)),
        )?;
        Ok(evaluated.value().cloned().unwrap_or_default())
    }

    pub(crate) fn text(&self, expression: &str) -> Result<String, Failed> {
        let value = self.value(expression)?;
        let text = value.as_str().map(str::to_owned);
        text.ok_or_else(|| format!("{expression} is {value}").into())
    }

    /// Waits until an expression is true in the page.
    pub(crate) fn wait(&self, expression: &str) -> Result<(), Failed> {
        let end = Instant::now() + PATIENCE;
        // While a page loads anew there is nothing to ask.
        while self.value(expression).ok() != Some(true.into()) {
            if Instant::now() > end {
                return Err(format!("never: {expression}").into());
            }
            std::thread::sleep(Duration::from_millis(20));
        }
        Ok(())
    }

    pub(crate) fn click(&self, selector: &str) -> Result<(), Failed> {
        let clicked = self.runtime.block_on(async {
            self.page.find_element(selector).await?.click().await?;
            Ok::<_, chromiumoxide::error::CdpError>(())
        });
        clicked.map_err(|e| format!("{selector}: {e}").into())
    }

    pub(crate) fn focus(&self, selector: &str) -> Result<(), Failed> {
        let element = self.runtime.block_on(self.page.find_element(selector))?;
        self.runtime.block_on(element.focus())?;
        Ok(())
    }

    /// Presses a key wherever the focus is.
    pub(crate) fn press(&self, key: &str) -> Result<(), Failed> {
        let body = self.runtime.block_on(self.page.find_element("body"))?;
        self.runtime.block_on(body.press_key(key))?;
        Ok(())
    }

    /// The mouse at a place of the page's window, with its left button.
    pub(crate) fn mouse(&self, kind: DispatchMouseEventType, at: [f64; 2]) -> Result<(), Failed> {
        self.execute(DispatchMouseEventParams {
            button: Some(MouseButton::Left),
            ..DispatchMouseEventParams::new(kind, at[0], at[1])
        })
    }

    /// A place of the canvas as fractions of its size, in the page's window.
    pub(crate) fn on_canvas(&self, [x, y]: [f64; 2]) -> Result<[f64; 2], Failed> {
        let bounds = self.text(
            "(() => { const c = document.getElementById('v-canvas'); \
             c.scrollIntoView({ block: 'nearest' }); const b = c.getBoundingClientRect(); \
             return JSON.stringify([b.left, b.top, b.width, b.height]); })()",
        )?;
        let [left, top, width, height]: [f64; 4] = serde_json::from_str(&bounds)?;
        Ok([left + x * width, top + y * height])
    }
}
