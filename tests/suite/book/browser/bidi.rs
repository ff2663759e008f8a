//! Firefox without a window, told what to do over WebDriver BiDi.
//!
//! With `--remote-debugging-port` it says on which port it listens, and speaks JSON over a
//! WebSocket. A shell waits until our pipe closes, because this program has ended, and
//! then ends Firefox.

use std::io::{BufRead, BufReader};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{ChildStdin, Command, Stdio};
use std::sync::mpsc;
use std::{env, fs, thread};

use serde_json::{Value, json};
use tungstenite::{Message, WebSocket};

use super::devtools::{NEXT_FRAME, PATIENCE};

/// A running browser with one tab.
pub(super) struct Firefox {
    socket: WebSocket<TcpStream>,
    tab: String,
    /// The number of the last command.
    last: u64,
    /// What happened while an answer was awaited.
    events: Vec<Value>,
    /// While it is open, the browser runs.
    _life: ChildStdin,
}

impl Firefox {
    /// Starts Firefox, or says why there is none.
    pub(super) fn start() -> Result<Self, String> {
        let program = find().ok_or("there is no Firefox here")?;
        let profile = Path::new(env!("CARGO_TARGET_TMPDIR")).join("firefox");
        let _ = fs::remove_dir_all(&profile);
        fs::create_dir_all(&profile).map_err(|cause| format!("no profile: {cause}"))?;
        let mut shell = Command::new("sh")
            .args(["-c", "\"$0\" \"$@\" >/dev/null & cat; kill $!"])
            .arg(&program)
            .args(["--headless", "--no-remote", "--remote-debugging-port", "0"])
            .arg("--profile")
            .arg(&profile)
            .stdin(Stdio::piped())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .map_err(|cause| format!("sh does not start: {cause}"))?;
        let life = shell.stdin.take().expect("a pipe");
        let said = BufReader::new(shell.stderr.take().expect("a pipe"));
        let (sender, addresses) = mpsc::channel();
        thread::spawn(move || {
            // It stops if nobody reads what it says.
            for line in said.lines().map_while(Result::ok) {
                if let Some((_, address)) = line.split_once("BiDi listening on ") {
                    let _ = sender.send(address.to_owned());
                }
            }
            let _ = shell.wait();
        });
        let address = addresses
            .recv_timeout(PATIENCE)
            .map_err(|cause| format!("Firefox does not listen: {cause}"))?;
        let mut firefox = Self {
            socket: connect(&address)?,
            tab: String::new(),
            last: 0,
            events: Vec::new(),
            _life: life,
        };
        firefox.call("session.new", json!({"capabilities": {}}));
        let events = [
            "log.entryAdded",
            "network.beforeRequestSent",
            "network.fetchError",
        ];
        firefox.call("session.subscribe", json!({ "events": events }));
        let tabs = firefox.call("browsingContext.getTree", json!({}));
        let tab = tabs["contexts"][0]["context"].as_str().expect("a tab");
        firefox.tab = tab.to_owned();
        Ok(firefox)
    }

    /// Makes the page `width` pixels wide.
    pub(super) fn set_width(&mut self, width: u32) {
        let size = json!({"width": width, "height": 800});
        let parameters = json!({"context": self.tab, "viewport": size});
        self.call("browsingContext.setViewport", parameters);
    }

    /// Opens the file, with a query or a fragment behind it, and waits until all of it is
    /// there.
    pub(super) fn open(&mut self, file: &Path, behind: &str) {
        // Where only the fragment differs, the page would stay as it is.
        self.navigate("about:blank");
        self.events.clear();
        self.navigate(&format!("file://{}{behind}", file.display()));
        self.evaluate("document.fonts.ready.then(() => null)");
        self.evaluate(NEXT_FRAME);
    }

    /// What happened since the page was opened, or since this was asked.
    pub(super) fn events(&mut self) -> Vec<Value> {
        std::mem::take(&mut self.events)
    }

    fn navigate(&mut self, url: &str) {
        let parameters = json!({"context": self.tab, "url": url, "wait": "complete"});
        self.call("browsingContext.navigate", parameters);
    }

    /// The value of a script, as JSON; a promise is waited for.
    pub(super) fn evaluate(&mut self, script: &str) -> Value {
        let parameters = json!({
            "expression": format!("Promise.resolve({script}).then((it) => JSON.stringify(it ?? null))"),
            "target": {"context": self.tab},
            "awaitPromise": true,
        });
        let answer = self.call("script.evaluate", parameters);
        let value = answer["result"]["value"].as_str();
        let value = value.unwrap_or_else(|| panic!("{script}\nfails: {answer}"));
        serde_json::from_str(value).expect("it was made JSON")
    }

    /// Puts a finger on the first of these places, moves it along the others, and lifts it
    /// at the last.
    pub(super) fn drag(&mut self, way: &[(f64, f64)]) {
        let to =
            |&(x, y): &(f64, f64)| json!({"type": "pointerMove", "x": x as i32, "y": y as i32});
        let mut steps = vec![to(&way[0]), json!({"type": "pointerDown", "button": 0})];
        steps.extend(way.iter().map(to));
        steps.push(json!({"type": "pointerUp", "button": 0}));
        let finger = json!({"type": "pointer", "id": "finger", "actions": steps,
            "parameters": {"pointerType": "touch"}});
        self.perform(finger);
    }

    /// Presses keys, each by its sign in WebDriver, and lets go of all of them.
    pub(super) fn press_together(&mut self, keys: &[char]) {
        let all = |kind: &'static str| {
            keys.iter()
                .map(move |key| json!({"type": kind, "value": key}))
        };
        let steps: Vec<Value> = all("keyDown").chain(all("keyUp")).collect();
        self.perform(json!({"type": "key", "id": "keyboard", "actions": steps}));
    }

    fn perform(&mut self, actions: Value) {
        let parameters = json!({"context": self.tab, "actions": [actions]});
        self.call("input.performActions", parameters);
        self.evaluate(NEXT_FRAME);
    }

    fn call(&mut self, method: &str, parameters: Value) -> Value {
        self.last += 1;
        let command = json!({"id": self.last, "method": method, "params": parameters});
        self.socket
            .send(Message::text(command.to_string()))
            .unwrap_or_else(|cause| panic!("Firefox does not listen: {cause}"));
        loop {
            let message = self.socket.read();
            let message =
                message.unwrap_or_else(|cause| panic!("Firefox does not answer {method}: {cause}"));
            let Message::Text(text) = message else {
                continue;
            };
            let mut answer: Value = serde_json::from_str(&text).expect("BiDi is JSON");
            if answer["type"] == "event" {
                self.events.push(answer);
            } else if answer["id"] == self.last {
                assert_eq!(answer["type"], "success", "{method}: {answer}");
                return answer["result"].take();
            }
        }
    }
}

fn connect(address: &str) -> Result<WebSocket<TcpStream>, String> {
    let host = address.trim_start_matches("ws://");
    let stream = TcpStream::connect(host).map_err(|cause| format!("{address}: {cause}"))?;
    stream
        .set_read_timeout(Some(PATIENCE))
        .map_err(|cause| format!("{address}: {cause}"))?;
    let (socket, _) = tungstenite::client(format!("{address}/session"), stream)
        .map_err(|cause| format!("{address}: {cause}"))?;
    Ok(socket)
}

/// Firefox: where `FIREFOX` says, on the path, or where macOS has it.
fn find() -> Option<PathBuf> {
    if !cfg!(unix) {
        return None; // A shell that ends it is needed.
    }
    let path = env::var_os("PATH").unwrap_or_default();
    let on_path = env::split_paths(&path)
        .flat_map(|folder| ["firefox", "firefox-esr"].map(|name| folder.join(name)));
    env::var_os("FIREFOX")
        .map(PathBuf::from)
        .into_iter()
        .chain(on_path)
        .chain(["/Applications/Firefox.app/Contents/MacOS/firefox".into()])
        .find(|program| program.is_file())
}
