//! Chromium without a window, told what to do over its DevTools protocol.
//!
//! With `--remote-debugging-pipe` it reads JSON messages from file descriptor 3
//! and writes to 4, each followed by a zero byte. A shell puts our pipes there. When
//! they close, because this program has ended, Chromium ends too.

use std::collections::VecDeque;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{ChildStdin, Command, Stdio};
use std::sync::mpsc::{self, Receiver};
use std::time::Duration;
use std::{env, fs, thread};

use serde_json::{Value, json};

/// Far more than any step takes, even where the machine is busy.
pub(super) const PATIENCE: Duration = Duration::from_secs(60);

/// A promise that is kept when everything has been drawn once more.
pub(super) const NEXT_FRAME: &str = "new Promise((done) => \
    requestAnimationFrame(() => requestAnimationFrame(() => done(null))))";

/// A running browser.
pub(super) struct Browser {
    to: ChildStdin,
    from: Receiver<Value>,
    /// The number of the last command.
    last: u64,
    /// What happened while an answer was awaited.
    events: VecDeque<Value>,
}

impl Browser {
    /// Starts Chromium, or says why there is none.
    pub(super) fn start() -> Result<Self, String> {
        let program = find().ok_or("there is no Chromium here")?;
        let profile = Path::new(env!("CARGO_TARGET_TMPDIR")).join("browser");
        let _ = fs::remove_dir_all(&profile);
        let mut child = Command::new("sh")
            .args([
                "-c",
                "exec \"$0\" \"$@\" 3<&0 4>&1 </dev/null >/dev/null 2>&1",
            ])
            .arg(&program)
            .args(["--headless", "--remote-debugging-pipe", "--hide-scrollbars"])
            .args(["--disable-gpu", "--disable-dev-shm-usage", "--no-first-run"])
            .args([
                "--disable-background-networking",
                "--disable-component-update",
            ])
            // Only pages of this book are opened, and root has no sandbox.
            .arg("--no-sandbox")
            .arg(format!("--user-data-dir={}", profile.display()))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|cause| format!("sh does not start: {cause}"))?;
        let to = child.stdin.take().expect("a pipe");
        let mut output = BufReader::new(child.stdout.take().expect("a pipe"));
        let (sender, from) = mpsc::channel();
        thread::spawn(move || {
            let mut message = Vec::new();
            while output
                .read_until(0, &mut message)
                .is_ok_and(|count| count > 0)
            {
                message.pop();
                let value = serde_json::from_slice(&message).expect("DevTools speak JSON");
                if sender.send(value).is_err() {
                    break;
                }
                message.clear();
            }
            let _ = child.wait();
        });
        let mut browser = Self {
            to,
            from,
            last: 0,
            events: VecDeque::new(),
        };
        browser.try_call(None, "Browser.getVersion", json!({}))?;
        Ok(browser)
    }

    /// A new tab with nothing in it, `width` pixels wide.
    pub(super) fn tab(&mut self, width: u32) -> Tab<'_> {
        let target = self.call(None, "Target.createTarget", json!({"url": "about:blank"}));
        let target = target["targetId"].as_str().expect("an id").to_owned();
        let attach = json!({"targetId": target, "flatten": true});
        let session = self.call(None, "Target.attachToTarget", attach);
        let session = session["sessionId"].as_str().expect("an id").to_owned();
        let mut tab = Tab {
            browser: self,
            target,
            session,
        };
        for domain in ["Page", "Runtime", "Log", "Network"] {
            tab.call(&format!("{domain}.enable"), json!({}));
        }
        let size = json!({"width": width, "height": 800, "deviceScaleFactor": 1, "mobile": false});
        tab.call("Emulation.setDeviceMetricsOverride", size);
        tab
    }

    fn call(&mut self, session: Option<&str>, method: &str, parameters: Value) -> Value {
        self.try_call(session, method, parameters)
            .unwrap_or_else(|cause| panic!("{cause}"))
    }

    fn try_call(
        &mut self,
        session: Option<&str>,
        method: &str,
        parameters: Value,
    ) -> Result<Value, String> {
        self.last += 1;
        let mut command = json!({"id": self.last, "method": method, "params": parameters});
        if let Some(session) = session {
            command["sessionId"] = json!(session);
        }
        let message = format!("{command}\0");
        self.to
            .write_all(message.as_bytes())
            .map_err(|cause| format!("Chromium does not listen: {cause}"))?;
        loop {
            let answer = self
                .from
                .recv_timeout(PATIENCE)
                .map_err(|cause| format!("Chromium does not answer {method}: {cause}"))?;
            if answer["id"] == self.last {
                return match answer.get("error") {
                    None => Ok(answer["result"].clone()),
                    Some(error) => Err(format!("{method}: {error}")),
                };
            }
            self.events.push_back(answer);
        }
    }
}

/// A page that is open; it closes when this is dropped.
pub(super) struct Tab<'a> {
    browser: &'a mut Browser,
    target: String,
    session: String,
}

impl Tab<'_> {
    /// Opens the file, with a query or a fragment behind it, such as `?search=…` or
    /// `#exercises`, and waits until all of it is there.
    pub(super) fn open(&mut self, file: &Path, behind: &str) {
        let url = format!("file://{}{behind}", file.display());
        self.browser.events.clear();
        self.call("Page.navigate", json!({ "url": url }));
        let seen = self.wait_for("Page.loadEventFired");
        self.browser.events.extend(seen);
        self.evaluate("document.fonts.ready.then(() => undefined)");
        self.evaluate(NEXT_FRAME);
    }

    /// What happened since the page was opened, or since this was asked.
    pub(super) fn events(&mut self) -> Vec<Value> {
        self.browser.events.drain(..).collect()
    }

    /// The value of a script, as JSON; a promise is waited for.
    pub(super) fn evaluate(&mut self, script: &str) -> Value {
        let parameters = json!({"expression": script, "returnByValue": true, "awaitPromise": true});
        let answer = self.call("Runtime.evaluate", parameters);
        assert!(
            answer.get("exceptionDetails").is_none(),
            "{script}\nfails: {}",
            answer["exceptionDetails"]
        );
        answer["result"]["value"].clone()
    }

    /// Lets the page be on a `"screen"` or in `"print"`, and prefer `"light"` or
    /// `"dark"`.
    pub(super) fn set_media(&mut self, media: &str, scheme: &str) {
        let scheme = json!([{"name": "prefers-color-scheme", "value": scheme}]);
        let media = json!({"media": media, "features": scheme});
        self.call("Emulation.setEmulatedMedia", media);
        // The page hears of it before it is drawn again.
        self.evaluate(NEXT_FRAME);
    }

    /// Presses a key and lets go of it: `"Tab"`, `"Enter"`, `"Home"` or an arrow; with
    /// Shift after `"Shift+"`.
    pub(super) fn press(&mut self, key: &str) {
        let bare = key.strip_prefix("Shift+");
        let shift = if bare.is_some() { 8 } else { 0 };
        let key = bare.unwrap_or(key);
        let (code, text) = match key {
            "Enter" => (13, "\r"),
            "Home" => (36, ""),
            "ArrowLeft" => (37, ""),
            "ArrowUp" => (38, ""),
            "ArrowRight" => (39, ""),
            _ => (9, ""),
        };
        for kind in ["keyDown", "keyUp"] {
            let text = if kind == "keyDown" { text } else { "" };
            let event = json!({
                "type": kind, "key": key, "code": key, "windowsVirtualKeyCode": code,
                "text": text, "modifiers": shift,
            });
            self.call("Input.dispatchKeyEvent", event);
        }
    }

    /// Presses a `"mouse"` or a `"pen"` at the first of these places, drags it along the
    /// others, and lets go at the last.
    pub(super) fn drag(&mut self, pointer: &str, way: &[(f64, f64)]) {
        let moves = way.iter().map(|at| ("mouseMoved", at));
        let steps = [("mousePressed", &way[0])].into_iter().chain(moves);
        for (kind, (x, y)) in steps.chain(way.last().map(|at| ("mouseReleased", at))) {
            let event = json!({
                "type": kind, "x": x, "y": y, "button": "left", "buttons": 1, "clickCount": 1,
                "pointerType": pointer,
            });
            self.call("Input.dispatchMouseEvent", event);
        }
        self.evaluate(NEXT_FRAME);
    }

    /// Does something, and returns how long each task of the page's main thread took
    /// meanwhile: in milliseconds by the clock, and of processor time.
    pub(super) fn tasks_during(&mut self, act: impl FnOnce(&mut Self)) -> Vec<[f64; 2]> {
        let categories = [
            "toplevel",
            "disabled-by-default-devtools.timeline",
            "__metadata",
        ];
        let config = json!({"includedCategories": categories, "excludedCategories": ["*"]});
        self.call("Tracing.start", json!({ "traceConfig": config }));
        act(self);
        self.call("Tracing.end", json!({}));
        let traced: Vec<Value> = self
            .wait_for("Tracing.tracingComplete")
            .into_iter()
            .filter(|event| event["method"] == "Tracing.dataCollected")
            .flat_map(|event| {
                event["params"]["value"]
                    .as_array()
                    .cloned()
                    .unwrap_or_default()
            })
            .collect();
        let thread = |event: &Value| (event["pid"].as_u64(), event["tid"].as_u64());
        let is_main = |event: &&Value| event["args"]["name"] == "CrRendererMain";
        let main: Vec<_> = traced.iter().filter(is_main).map(thread).collect();
        traced
            .iter()
            .filter(|event| event["name"] == "RunTask" && main.contains(&thread(event)))
            .map(|event| ["dur", "tdur"].map(|it| event[it].as_f64().unwrap_or(0.0) / 1000.0))
            .collect()
    }

    /// Waits for an event; returns those before it.
    fn wait_for(&mut self, method: &str) -> Vec<Value> {
        let mut seen = Vec::new();
        loop {
            let event = match self.browser.events.pop_front() {
                Some(event) => event,
                None => self
                    .browser
                    .from
                    .recv_timeout(PATIENCE)
                    .unwrap_or_else(|cause| panic!("no {method}: {cause}")),
            };
            if event["sessionId"] != self.session.as_str() {
                continue;
            }
            if event["method"] == method {
                return seen;
            }
            seen.push(event);
        }
    }

    fn call(&mut self, method: &str, parameters: Value) -> Value {
        self.browser.call(Some(&self.session), method, parameters)
    }
}

impl Drop for Tab<'_> {
    fn drop(&mut self) {
        let target = json!({"targetId": self.target});
        // A test that fails because the browser is gone has said so.
        let _ = self.browser.try_call(None, "Target.closeTarget", target);
        self.browser.events.clear();
    }
}

/// Chromium or Chrome: where `CHROMIUM` says, on the path, or where macOS has it.
fn find() -> Option<PathBuf> {
    if !cfg!(unix) {
        return None; // A shell that hands over pipes is needed.
    }
    let names = [
        "chromium",
        "chromium-browser",
        "google-chrome",
        "google-chrome-stable",
    ];
    let path = env::var_os("PATH").unwrap_or_default();
    let on_path = env::split_paths(&path).flat_map(|folder| names.map(|name| folder.join(name)));
    env::var_os("CHROMIUM")
        .map(PathBuf::from)
        .into_iter()
        .chain(on_path)
        .chain([
            "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome".into(),
            "/Applications/Chromium.app/Contents/MacOS/Chromium".into(),
        ])
        .find(|program| program.is_file())
}
