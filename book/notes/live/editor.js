// The editor of a chapter: a text field beside the listing, with the picture of the text and the
// verdict on it. No request leaves the page, because the interpreter and the judge are a part of
// it.

"use strict";

// The editor draws a small picture after each letter. After PAUSE milliseconds without a letter it
// draws the text at the book's size, and shows the verdict LONG_PAUSE milliseconds after the
// letter. After REST milliseconds the line at the caret counts as finished if it can be read.
const PAUSE = 100;
const LONG_PAUSE = 300;
const REST = 2000;
// The number of letters above which a text is not read. No chapter has 8 kB.
const MOST_LETTERS = 100000;
// The time in milliseconds after which a worker is replaced, for small questions and for large
// ones. The interpreter counts steps, and names an endless loop long before.
const PATIENCE = 2000;
const LONG_PATIENCE = 30000;
// The number of verdicts after which the judging worker is replaced: it keeps every program that it
// has seen.
const JUDGED_BY_ONE = 100;

// Makes the methods that read, draw and judge a typed text.
function editorMethods(rust, { bytes, text, give }) {
    const asked = (fields) => give(fields.join("\0"));

    // Splits the last answer into grade, whether the line at the caret waits, places, headline and rest.
    function feedback(length) {
        const [facts, headline, ...rest] = text(length).split("\n");
        const [grade, waits, ...places] = facts.split("\t");
        const numbers = (place) => place.split(" ").map(Number);
        return { grade, isWaiting: waits !== "", places: places.map(numbers), headline, rest: rest.join("\n") };
    }

    return {
        start: () => null,
        begin({ chapter }) {
            asked([chapter]);
            return text(rust.begin()).split("\0");
        },
        draw({ fields, width, caret: [file, line], rests }) {
            asked(fields);
            const height = rust.draw(width, file, line, rests);
            const length = rust.length();
            return height ? { width, height, rgba: bytes(length).slice() } : { said: feedback(length) };
        },
        // Judges the text that was drawn last.
        judge: () => feedback(rust.judge()),
        next({ fields, caret: [file, line] }) {
            asked(fields);
            return text(rust.next_line(file, line)).split("\t");
        },
        home({ fields, number }) {
            asked(fields);
            return bytes(rust.take_home(number)).slice();
        },
    };
}

class Editor {
    // The worker that draws small pictures, and the one that draws large ones and judges them; all
    // editors of a page share both.
    static drawing = null;
    static judging = null;

    constructor(name) {
        this.name = name;
        this.width = name === "build_test" ? 256 : 400;
        this.turn = 0;
        this.judged = 0;
        Editor.drawing ??= new RustWorker(editorMethods, judgeModule);
        Editor.judging ??= new RustWorker(editorMethods, judgeModule);
        this.desk = document.createElement("section");
        this.desk.className = "check typing alive";
        this.desk.setAttribute("aria-label", `${name}, typed by you`);
        this.desk.innerHTML = DESK.replaceAll("NAME", name);
        this.desk.addEventListener("click", (event) => this.click(event));
        this.dialog = this.desk.querySelector("dialog");
        // mdBook listens to this key for its search.
        this.dialog.addEventListener("keydown", ({ key }) => key === "Escape" && this.dialog.close());
        this.verdict = this.desk.querySelector(".verdict");
        this.rest = this.desk.querySelector(".rest");
        this.yours = this.desk.querySelector("canvas");
        [this.yours.width, this.yours.height] = [this.width, name === "build_test" ? 256 : 225];
        this.opened = this.open();
    }

    async open() {
        const fields = await Editor.drawing.within(LONG_PATIENCE, "begin", { chapter: this.name });
        const steps = fields.pop();
        this.files = [];
        for (let n = 0; n < fields.length; n += 3) {
            const [name, skeleton, full] = fields.slice(n, n + 3);
            this.files.push(new TypedFile(this, name, skeleton, full));
        }
        this.desk.querySelector(".files").append(...this.files.map((it) => it.panel));
        this.desk.querySelector(".names").append(...this.files.map((it) => it.choice));
        this.desk.querySelector(".names").hidden = this.files.length === 1;
        this.desk.querySelector(".steps").append(...steps.split("\n").map(withCode));
        const kept = this.kept();
        this.files.forEach((file) => file.put(kept[file.name] ?? file.skeleton));
    }

    // Shows the editor beside a listing, in the listing's file. Selects the `todo!()` of the
    // listing's first empty function, or else begins at its first function.
    show(listing) {
        this.listing = listing;
        listing.before(this.desk);
        this.desk.querySelector(".listed").append(listing);
        const [name] = listing.querySelector(".file").textContent.match(/src\/\w+\.rs$/);
        const file = this.files.find((it) => it.name === name);
        this.choose(file);
        const code = listing.querySelector("pre code").textContent;
        file.select(...file.toType(code));
        // The editor begins below the header, or higher if the selected line needs it.
        scrollBy(0, this.desk.getBoundingClientRect().top - HEADER);
        file.reveal();
        this.changed();
    }

    close() {
        this.keep();
        this.desk.replaceWith(this.listing);
        this.listing.querySelector(".tools button").focus({ preventScroll: true });
    }

    // The key under which the browser keeps the reader's files. It has a version, so that a new
    // format can have a new key.
    get key() {
        return `typed 1 ${this.name}`;
    }

    // Returns the kept files: an object of texts by file names.
    kept() {
        try {
            return JSON.parse(localStorage.getItem(this.key)) ?? {};
        } catch {
            return {};
        }
    }

    keep() {
        const texts = Object.fromEntries(this.files.map((file) => [file.name, file.area.value]));
        let isKept = true;
        try {
            localStorage.setItem(this.key, JSON.stringify(texts));
        } catch {
            isKept = false;
        }
        this.desk.querySelector(".unkept").hidden = isKept;
    }

    choose(file) {
        this.chosen = file;
        this.files.forEach((it) => { it.panel.hidden = it !== file; });
        file.choice.querySelector("input").checked = true;
    }

    // Returns the chapter's name, and the name and the text of each file.
    fields() {
        const files = this.files.flatMap((file) => [file.name, file.area.value.replaceAll("\0", "")]);
        return [this.name, ...files];
    }

    // Returns the index of the file, and the line (from 1) at whose end the reader types; 0 for
    // none.
    caret() {
        const { area } = this.chosen;
        const isTyping = document.activeElement === area;
        return [this.files.indexOf(this.chosen), isTyping && this.chosen.isAtEnd() ? this.chosen.lineOfCaret() : 0];
    }

    // Judges an unfinished line when the caret leaves it.
    moved() {
        if (this.isWaiting && String(this.caret()) !== this.typedAt) {
            this.changed();
        }
    }

    // Draws the text again and again until no letter comes meanwhile, and then judges it. The reader
    // may have typed nothing, and rest.
    async changed(rests = false) {
        const now = ++this.turn;
        this.rests = rests;
        this.typed = rests ? this.typed : performance.now();
        this.typedAt = String(this.caret());
        this.isRight = false;
        this.desk.ariaBusy = "true";
        this.files.forEach((file) => file.mark([]));
        if (this.isDrawing) {
            return;
        }
        this.isDrawing = true;
        let [turn, said] = [now, null];
        do {
            turn = this.turn;
            said = await this.draw(Editor.drawing, this.width / 2, PATIENCE);
        } while (turn !== this.turn);
        this.isDrawing = false;
        await until(this.typed + PAUSE);
        if (turn === this.turn) {
            this.keep();
            said ? this.say(said, true) : this.judge(turn);
        }
    }

    // Draws the text. Returns the feedback on a text that is no program or stops, and nothing for a
    // picture.
    async draw(worker, width, patience) {
        const fields = this.fields();
        if (fields.join("").length > MOST_LETTERS) {
            return refusal(`This page reads no text of more than ${MOST_LETTERS} letters.`);
        }
        const turn = this.turn;
        const caret = this.caret();
        try {
            const drawn = await worker.within(patience, "draw", { fields, width, caret, rests: this.rests });
            if (!drawn.said && turn === this.turn) {
                this.paint(drawn);
            }
            return drawn.said;
        } catch (error) {
            return refusal(gaveUp(error));
        }
    }

    paint({ width, height, rgba }) {
        [this.yours.width, this.yours.height] = [width, height];
        const data = new ImageData(new Uint8ClampedArray(rgba.buffer), width, height);
        this.yours.getContext("2d").putImageData(data, 0, 0);
    }

    // Draws the text at the book's size, and shows the verdict.
    async judge(turn) {
        this.judged += 1;
        if (this.judged % JUDGED_BY_ONE === 0 || Editor.judging.waiting.size > 0) {
            Editor.judging.start();
        }
        let said = await this.draw(Editor.judging, this.width, LONG_PATIENCE);
        if (!said && turn === this.turn) {
            await until(this.typed + LONG_PAUSE);
        }
        if (turn !== this.turn) {
            return;
        }
        said ??= await Editor.judging.within(LONG_PATIENCE, "judge", {})
            .catch((error) => refusal(gaveUp(error)));
        if (turn === this.turn) {
            this.say(said);
            if (this.isRight) {
                this.remember();
                this.leadOn();
            }
        }
    }

    // Keeps the picture for the page after the last chapter.
    remember() {
        try {
            localStorage.setItem(`drawn ${this.name}`, this.yours.toDataURL());
        } catch {
            // That page then shows the chapter's picture.
        }
    }

    // Adds a link to the editor of the next page of the book.
    leadOn() {
        const next = document.querySelector("a[rel~=next]");
        if (next) {
            const link = document.createElement("a");
            link.className = "door";
            link.href = `${next.href}#type`;
            link.textContent = "Type the next chapter";
            this.rest.append(link);
        }
    }

    // Shows feedback; the picture beside it is from before if `isOld`.
    say({ grade, isWaiting, places, headline, rest }, isOld = false) {
        this.isWaiting = isWaiting;
        this.isRight = grade === "right";
        this.desk.classList.toggle("old", isOld && grade !== "calm");
        if (this.verdict.innerHTML !== headline) {
            this.verdict.innerHTML = headline;
        }
        this.rest.innerHTML = rest;
        // A place such as src/lib.rs:12 becomes a button that leads there.
        for (const told of this.rest.querySelectorAll("code, .printed")) {
            this.lead(told);
        }
        this.files.forEach((file, n) => file.mark(places.filter(([of]) => of === n)));
        this.desk.ariaBusy = "false";
        isWaiting && !this.rests && this.judgeAtRest(this.turn);
    }

    // Judges the line at the caret when the reader has typed nothing for a while.
    async judgeAtRest(turn) {
        await until(this.typed + REST);
        turn === this.turn && this.changed(true);
    }

    lead(told) {
        const [place, name, line, column = 1] = told.textContent.match(/^(src\/\w+\.rs):(\d+)(?::(\d+))?/) ?? [];
        const file = this.files.find((it) => it.name === name);
        if (file) {
            const button = document.createElement("button");
            button.type = "button";
            button.className = "place";
            button.textContent = place;
            button.addEventListener("click", () => {
                this.choose(file);
                file.go(line - 1, column - 1);
            });
            told.firstChild.textContent = told.textContent.slice(place.length);
            told.prepend(button);
        }
    }

    async click({ target }) {
        const action = target.dataset?.action;
        if (action === "again") {
            this.dialog.showModal();
        } else if (action === "empty" || action === "stay") {
            this.dialog.close();
            action === "empty" && this.replace((file) => file.skeleton);
        } else if (action === "full") {
            this.replace((file) => file.full);
        } else if (action === "hint" || action === "next") {
            this.help(action === "next");
        } else if (action === "home") {
            this.takeHome();
        } else if (action === "close") {
            this.close();
        }
    }

    replace(text) {
        this.files.forEach((file) => file.replace(text(file)));
        this.chosen.area.focus();
    }

    // Says where the next line goes and how it begins, or types it. A right program lacks nothing.
    async help(isTyped) {
        while (this.desk.ariaBusy === "true") {
            await until(performance.now() + PAUSE);
        }
        if (this.isRight) {
            this.verdict.textContent = "Right: nothing is missing.";
            return;
        }
        const question = { fields: this.fields(), caret: [this.files.indexOf(this.chosen), this.chosen.lineOfCaret()] };
        const [n, above, isInstead, line] = await Editor.drawing.within(PATIENCE, "next", question);
        const file = this.files[n];
        if (!file) {
            this.say(refusal(n ? "Your lines are not the chapter's, so the next one is not known."
                : "Every line of the chapter is there."));
            return;
        }
        this.choose(file);
        const begun = isInstead === "1" ? file.line(Number(above)).replace("todo!()", "") : "";
        if (isTyped) {
            file.insert(Number(above), line, isInstead === "1");
        } else {
            file.go(Number(above), Infinity);
            const begins = line.trim().split(/\s+/).slice(0, 1 + begun.split(/\s+/).length).join(" ");
            const place = `line ${Number(above) + 1} of ${file.name}`;
            this.say(refusal(`${begun ? `The next line is ${place},` : `The next line goes above ${place},`} and begins with ${begins}`));
        }
    }

    async takeHome() {
        const question = { fields: this.fields(), number: Math.floor(Math.random() * 2 ** 53) };
        const archive = await Editor.drawing.within(PATIENCE, "home", question);
        const link = document.createElement("a");
        link.href = URL.createObjectURL(new Blob([archive], { type: "application/x-tar" }));
        link.download = `${this.name}.tar`;
        link.click();
        URL.revokeObjectURL(link.href);
        this.desk.querySelector(".home").hidden = false;
    }
}

const until = (time) => new Promise((done) => setTimeout(done, time - performance.now()));

const refusal = (words) => {
    const said = document.createElement("p");
    said.textContent = words;
    return { grade: "wrong", isWaiting: false, places: [], headline: said.innerHTML, rest: "" };
};

function gaveUp({ message }) {
    return message === "it takes too long"
        ? "Your program did not end in time. Does every loop end, and every function that calls itself?"
        : "This page cannot run your text, which is nested too deeply or needs too much memory.";
}

// Makes an item of a list, with the text between backticks as code.
function withCode(says) {
    const item = document.createElement("li");
    says.split("`").forEach((part, n) => {
        const code = document.createElement("code");
        code.textContent = part;
        item.append(n % 2 ? code : part);
    });
    return item;
}

const DESK = `<fieldset class="names"><legend>File</legend></fieldset>
<div class="sides">
<div class="said">
<div class="pictures">
<figure><canvas role="img" aria-label="Your picture"></canvas><figcaption>yours</figcaption></figure>
<figure><img src="pictures/NAME.snap.png" alt="The right picture"><figcaption>what it should be</figcaption></figure>
</div>
<p class="verdict" role="status" id="said-NAME"></p>
<div class="rest"></div>
</div>
<div class="written">
<div class="files"></div>
<p class="controls">
<button type="button" data-action="hint">Hint</button>
<button type="button" data-action="next">Show the next line</button>
<button type="button" data-action="full">Show the chapter</button>
<button type="button" data-action="again">Start again</button>
<button type="button" data-action="home">Take it home</button>
<button type="button" data-action="close">Close</button>
</p>
</div>
</div>
<p class="unkept" hidden>Your browser does not let this page keep your text: take the text home before you leave.</p>
<div class="home" hidden><p>Unpack the archive in the folder of the workspace: tar overwrites none of the files there.</p>
<pre><code>tar -xkf NAME.tar
cargo rtrace watch NAME</code></pre>
<p>This page does not check moves, borrows, privacy, traits, nor lines that never ran: cargo does that.</p></div>
<dialog aria-label="Start again"><p>Begin with empty functions? They replace your text; undo (Ctrl+Z) brings it back.</p>
<p class="controls"><button type="button" data-action="empty">Start again</button>
<button type="button" data-action="stay">Keep my text</button></p></dialog>
<details open><summary>The steps</summary><ol class="steps"></ol></details>
<details class="listed"><summary>The chapter's own lines</summary></details>
<p class="small">This browser keeps your text; it goes nowhere else.</p>`;

// The editors that were opened on this page, one for a chapter.
const editors = {};

// Opens the editor of a chapter beside a listing of it, with what was typed.
async function openEditor(listing, name) {
    const editor = editors[name] ??= new Editor(name);
    await editor.opened;
    Object.values(editors).filter((it) => it.desk.isConnected).forEach((it) => it.close());
    editor.show(listing);
}
