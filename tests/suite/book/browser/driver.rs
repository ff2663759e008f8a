//! WebDriver BiDi: a browser without a window is told what to do in JSON over a WebSocket.
//!
//! Firefox speaks it, and Chromium by its chromedriver. A shell starts them, waits until our
//! pipe closes because this program has ended, and then ends them.

use std::io::{BufRead, BufReader};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{ChildStdin, Command, Stdio};
use std::sync::mpsc;
use std::time::Duration;
use std::{env, fs, thread};

use serde_json::{Value, json};
use tungstenite::{Message, WebSocket};

/// Far more than any step takes, even where the machine is busy.
const PATIENCE: Duration = Duration::from_secs(60);

/// A promise that is kept when everything has been drawn once more.
pub(super) const NEXT_FRAME: &str = "new Promise((done) => \
    requestAnimationFrame(() => requestAnimationFrame(() => done(null))))";

/// A running browser with one tab.
pub(super) struct Browser {
    /// What it is called.
    pub(super) name: &'static str,
    socket: WebSocket<TcpStream>,
    tab: String,
    /// The number of the last command.
    last: u64,
    /// What happened while an answer was awaited.
    events: Vec<Value>,
    /// While it is open, the browser runs.
    _life: ChildStdin,
}

impl Browser {
    /// Starts Chromium or Chrome, or says why there is none.
    pub(super) fn chromium() -> Result<Self, String> {
        let mut driver = under_a_shell(&find("CHROMEDRIVER", &["chromedriver"])?);
        driver.arg("--port=0");
        // Only pages of this book are opened, and root has no sandbox.
        let arguments = [
            "--headless",
            "--no-sandbox",
            "--hide-scrollbars",
            "--disable-gpu",
        ];
        let options = json!({"goog:chromeOptions": {"args": arguments}});
        Self::start("Chromium", driver, "successfully on port ", options)
    }

    /// Starts Firefox, or says why there is none.
    pub(super) fn firefox() -> Result<Self, String> {
        let mut firefox = under_a_shell(&find("FIREFOX", &["firefox", "firefox-esr"])?);
        let profile = Path::new(env!("CARGO_TARGET_TMPDIR")).join("firefox");
        let _ = fs::remove_dir_all(&profile);
        fs::create_dir_all(&profile).map_err(|cause| format!("no profile: {cause}"))?;
        firefox
            .args(["--headless", "--no-remote", "--remote-debugging-port=0"])
            .arg("--profile")
            .arg(&profile);
        Self::start(
            "Firefox",
            firefox,
            "BiDi listening on ws://127.0.0.1:",
            json!({}),
        )
    }

    /// Starts what says after an `announcement` at which port it listens.
    fn start(
        name: &'static str,
        mut shell: Command,
        announcement: &'static str,
        options: Value,
    ) -> Result<Self, String> {
        let mut shell = shell
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|cause| format!("sh does not start: {cause}"))?;
        let life = shell.stdin.take().expect("a pipe");
        let said = BufReader::new(shell.stdout.take().expect("a pipe"));
        let (sender, ports) = mpsc::channel();
        thread::spawn(move || {
            // It stops if nobody reads what it says.
            for line in said.lines().map_while(Result::ok) {
                if let Some((_, port)) = line.split_once(announcement) {
                    let _ = sender.send(port.trim_end_matches('.').to_owned());
                }
            }
            let _ = shell.wait();
        });
        let port = ports
            .recv_timeout(PATIENCE)
            .map_err(|cause| format!("{name} does not listen: {cause}"))?;
        let mut browser = Self {
            name,
            socket: connect(&port).map_err(|cause| format!("{name}: {cause}"))?,
            tab: String::new(),
            last: 0,
            events: Vec::new(),
            _life: life,
        };
        let capabilities = json!({"capabilities": {"alwaysMatch": options}});
        browser.call("session.new", capabilities);
        let events = [
            "log.entryAdded",
            "network.beforeRequestSent",
            "network.fetchError",
        ];
        browser.call("session.subscribe", json!({ "events": events }));
        let tabs = browser.call("browsingContext.getTree", json!({}));
        let tab = tabs["contexts"][0]["context"].as_str().expect("a tab");
        tab.clone_into(&mut browser.tab);
        Ok(browser)
    }

    /// Makes the page `width` pixels wide.
    pub(super) fn set_width(&mut self, width: u32) {
        let size = json!({"width": width, "height": 800});
        self.tell("browsingContext.setViewport", json!({ "viewport": size }));
    }

    /// Opens the file, with a query or a fragment behind it, such as `?search=…` or
    /// `#exercises`, and waits until all of it is there.
    pub(super) fn open(&mut self, file: &Path, behind: &str) {
        // Where only the fragment differs, the page would stay as it is.
        self.navigate("about:blank");
        self.events.clear();
        self.navigate(&format!("file://{}{behind}", file.display()));
        self.evaluate("document.fonts.ready.then(() => null)");
        self.evaluate(NEXT_FRAME);
    }

    fn navigate(&mut self, url: &str) {
        let page = json!({"url": url, "wait": "complete"});
        self.tell("browsingContext.navigate", page);
    }

    /// The value of a script, as JSON; a promise is waited for.
    pub(super) fn evaluate(&mut self, script: &str) -> Value {
        let script = json!({
            "expression": format!("Promise.resolve({script}).then((it) => JSON.stringify(it ?? null))"),
            "target": {"context": self.tab},
            "awaitPromise": true,
        });
        let answer = self.call("script.evaluate", script);
        let value = answer["result"]["value"].as_str();
        let value = value.unwrap_or_else(|| panic!("{}: {answer}", self.name));
        serde_json::from_str(value).expect("it was made JSON")
    }

    /// What the browser complains of since the page was opened, and each request to others.
    pub(super) fn complaints(&mut self) -> Vec<String> {
        let events = std::mem::take(&mut self.events).into_iter();
        let complaints = events.filter(is_complaint);
        complaints.map(|it| it["params"].to_string()).collect()
    }

    /// Lets the page be on a `"screen"` or in `"print"`, and prefer `"light"` or `"dark"`:
    /// by a command of Chromium's own, for which BiDi has no word.
    pub(super) fn set_media(&mut self, media: &str, scheme: &str) {
        let session = self.tell("goog:cdp.getSession", json!({}));
        let scheme = json!([{"name": "prefers-color-scheme", "value": scheme}]);
        let command = json!({
            "session": session["session"],
            "method": "Emulation.setEmulatedMedia",
            "params": {"media": media, "features": scheme},
        });
        self.call("goog:cdp.sendCommand", command);
        // The page hears of it before it is drawn again.
        self.evaluate(NEXT_FRAME);
    }

    /// Puts a `"mouse"`, a `"pen"` or a `"touch"` on the first of these places, drags it along
    /// the others, and lets go at the last.
    pub(super) fn drag(&mut self, pointer: &str, way: &[(f64, f64)]) {
        let to =
            |&(x, y): &(f64, f64)| json!({"type": "pointerMove", "x": x as i32, "y": y as i32});
        let mut steps = vec![to(&way[0]), json!({"type": "pointerDown", "button": 0})];
        steps.extend(way.iter().map(to));
        steps.push(json!({"type": "pointerUp", "button": 0}));
        self.perform(json!({"type": "pointer", "id": pointer, "actions": steps,
            "parameters": {"pointerType": pointer}}));
    }

    /// Presses keys, each by its sign in WebDriver, and lets go of all of them.
    pub(super) fn press(&mut self, keys: &[char]) {
        let all = |kind: &'static str| {
            keys.iter()
                .map(move |key| json!({"type": kind, "value": key}))
        };
        let steps: Vec<Value> = all("keyDown").chain(all("keyUp")).collect();
        self.perform(json!({"type": "key", "id": "keyboard", "actions": steps}));
    }

    fn perform(&mut self, actions: Value) {
        self.tell("input.performActions", json!({"actions": [actions]}));
        self.evaluate(NEXT_FRAME);
    }

    /// A command to the tab.
    fn tell(&mut self, method: &str, mut parameters: Value) -> Value {
        parameters["context"] = json!(self.tab);
        self.call(method, parameters)
    }

    fn call(&mut self, method: &str, parameters: Value) -> Value {
        self.last += 1;
        let command = json!({"id": self.last, "method": method, "params": parameters});
        let name = self.name;
        self.socket
            .send(Message::text(command.to_string()))
            .unwrap_or_else(|cause| panic!("{name} does not listen: {cause}"));
        loop {
            let message = self.socket.read();
            let message =
                message.unwrap_or_else(|cause| panic!("{name} does not answer {method}: {cause}"));
            let Message::Text(text) = message else {
                continue;
            };
            let mut answer: Value = serde_json::from_str(&text).expect("BiDi is JSON");
            if answer["type"] == "event" {
                self.events.push(answer);
            } else if answer["id"] == self.last {
                assert_eq!(answer["type"], "success", "{name}, {command}: {answer}");
                return answer["result"].take();
            }
        }
    }
}

/// Errors and warnings, files that are missing, and requests to others.
fn is_complaint(event: &Value) -> bool {
    let said = &event["params"];
    match event["method"].as_str() {
        Some("log.entryAdded") => {
            let text = said["text"].as_str().unwrap_or_default();
            // Firefox may draw a page of which it has read the half, and then it says so of a
            // half fraction too. Whether a whole one has two parts, FORMULAS looks.
            let is_half = text.starts_with("Invalid markup: Incorrect number of children for <m");
            (said["level"] == "error" || said["level"] == "warn") && !is_half
        }
        Some("network.beforeRequestSent") => {
            let url = said["request"]["url"].as_str().unwrap_or_default();
            !["file:", "data:", "about:", "blob:"]
                .iter()
                .any(|it| url.starts_with(it))
        }
        Some("network.fetchError") => true,
        _ => false,
    }
}

/// A shell for the program, in a process group of its own, which it ends as a whole: a
/// chromedriver leaves its Chromium behind.
fn under_a_shell(program: &Path) -> Command {
    let mut shell = Command::new("sh");
    shell.args(["-c", "\"$0\" \"$@\" 2>&1 & cat; kill 0"]);
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(&mut shell, 0);
    shell.arg(program);
    shell
}

fn connect(port: &str) -> Result<WebSocket<TcpStream>, Box<dyn std::error::Error>> {
    let stream = TcpStream::connect(format!("localhost:{port}"))?;
    stream.set_read_timeout(Some(PATIENCE))?;
    let (socket, _) = tungstenite::client(format!("ws://localhost:{port}/session"), stream)?;
    Ok(socket)
}

/// A program: there where the variable says, or by one of its names on the path.
fn find(variable: &str, names: &[&str]) -> Result<PathBuf, String> {
    if !cfg!(unix) {
        return Err("a shell is needed that ends it".to_owned());
    }
    let path = env::var_os("PATH").unwrap_or_default();
    let mut on_path =
        env::split_paths(&path).flat_map(|folder| names.iter().map(move |name| folder.join(name)));
    env::var_os(variable)
        .map(PathBuf::from)
        .or_else(|| on_path.find(|program| program.is_file()))
        .ok_or_else(|| {
            format!(
                "there is no {}: install it, or say in {variable} where it is",
                names[0]
            )
        })
}
