// The text field of the editor: a plain `textarea` that nothing is drawn in. Its colors and the lines
// below faults are two layers behind it, as wide and as high as the text, so that the box around all
// three is what scrolls.
//
// CodeMirror 6 (view, commands, language, lint, lang-rust) was tried in its place. It indents these
// chapters as this file does, without a fault. It would take about a hundred lines from this file and its
// styles and bring 432 kB of script (142 kB gzip; 260 and 85 kB without its grammar), which this text
// of at most 8 kB does not need. And it edits a `contenteditable`, where the textarea is the field
// that everyone's keyboard, dictation, screen reader, undo, search and spelling know.

"use strict";

// The number of letters above which a text has no colors.
const MOST_COLORED = 20000;
// The room in pixels that the editor leaves above itself for the header.
const HEADER = 60;

// A file of the reader: a text field, and behind it the layers of colors and of underlined faults.
class TypedFile {
    constructor(editor, name, skeleton, full) {
        Object.assign(this, { editor, name, skeleton, full });
        this.choice = document.createElement("label");
        this.choice.innerHTML = `<input type="radio" name="file ${editor.name}"> `;
        this.choice.append(name);
        this.choice.addEventListener("change", () => editor.choose(this));
        this.panel = document.createElement("div");
        this.panel.className = "text";
        this.panel.innerHTML = PANEL;
        [this.colors, this.faults] = this.panel.querySelectorAll("pre");
        this.area = this.panel.querySelector("textarea");
        this.area.ariaLabel = name;
        this.area.setAttribute("aria-describedby", `said-${editor.name}`);
        this.area.addEventListener("input", () => this.changed());
        // The keyboard of a phone comes and goes, too.
        this.area.addEventListener("keyup", () => this.reveal());
        for (const event of ["keyup", "click", "blur"]) {
            this.area.addEventListener(event, () => editor.moved());
        }
        visualViewport?.addEventListener("resize", () => document.activeElement === this.area && this.reveal());
        this.area.addEventListener("keydown", (event) => this.press(event));
    }

    put(text) {
        this.area.value = text;
        this.color();
    }

    changed() {
        this.color();
        this.editor.changed();
    }

    // Replaces a part of the text, all of it by default, so that the browser's undo can bring it
    // back.
    replace(text, [start, end] = [0, this.area.value.length]) {
        if (this.area.value.slice(start, end) !== text) {
            const { hidden } = this.panel;
            this.panel.hidden = false;
            this.area.focus();
            this.area.setSelectionRange(start, end);
            document.execCommand(text ? "insertText" : "delete", false, text);
            this.panel.hidden = hidden;
        }
    }

    // Indents as rustfmt does: a new line keeps the indentation, and gets four spaces more after an
    // opening bracket or if it continues a condition; a closing brace takes four away. Tab leaves
    // the text field, as it leaves any other.
    press(event) {
        const { value, selectionStart: at } = this.area;
        if (event.isComposing || event.ctrlKey || event.metaKey || event.altKey) {
            return;
        }
        const lines = value.slice(0, at).split("\n");
        const line = lines.pop();
        const [indent] = line.match(/^ */);
        const type = (spaces, letter) => {
            event.preventDefault();
            this.area.setSelectionRange(at - indent.length, this.area.selectionEnd);
            document.execCommand("insertText", false, " ".repeat(spaces) + letter);
        };
        if (event.key === "Enter") {
            event.preventDefault();
            document.execCommand("insertText", false, `\n${indent}${/[{([]\s*$/.test(line) ? "    " : ""}`);
            this.panel.scrollLeft = 0;
        } else if (line !== indent) {
            return;
        } else if (event.key === "}" && indent.length >= 4) {
            type(indent.length - 4, "}");
        } else if (event.key === "{" || event.key === "&" || event.key === "|") {
            const start = indentOfCondition(lines);
            start !== null && type(start + (event.key === "{" ? 0 : 4), event.key);
        }
    }

    // Scrolls until the line with the caret is seen: below the verdict, which stays on the screen
    // of a phone, and above the buttons and the keyboard.
    reveal() {
        const height = parseFloat(getComputedStyle(this.area).lineHeight);
        const line = this.lineOfCaret();
        const below = this.area.getBoundingClientRect().top + parseFloat(getComputedStyle(this.area).paddingTop) + line * height;
        const [said, controls] = [".said", ".controls"].map((it) => this.editor.desk.querySelector(it).getBoundingClientRect());
        const isBeside = said.right <= this.area.getBoundingClientRect().left;
        const highest = isBeside ? HEADER : said.height;
        const lowest = (visualViewport?.height ?? innerHeight) - controls.height;
        const away = Math.max(below - lowest, 0) || Math.min(below - 2 * height - highest, 0);
        // While all of the text is on the screen the page stays as it is.
        away && scrollBy(0, away);
    }

    color() {
        const { value } = this.area;
        this.panel.classList.toggle("long", value.length > MOST_LETTERS);
        const code = this.colors.firstChild;
        if (value.length > MOST_LETTERS) {
            code.textContent = "";
        } else if (value.length > MOST_COLORED) {
            code.textContent = value;
        } else {
            code.innerHTML = hljs.highlight("rust", value, true).value;
        }
    }

    // Returns true if the caret stands at the end of its line.
    isAtEnd() {
        const { value, selectionStart: at, selectionEnd } = this.area;
        return at === selectionEnd && /^ *(\n|$)/.test(value.slice(at));
    }

    // Returns the line with the caret, counted from 1.
    lineOfCaret() {
        return this.area.value.slice(0, this.area.selectionStart).split("\n").length;
    }

    // Returns the text of a line, counted from 0, without blanks around it.
    line(n) {
        return (this.area.value.split("\n")[n] ?? "").trim();
    }

    // Returns two positions in the text, of columns of a line. Columns count characters, positions
    // UTF-16 units; these and lines count from 0.
    range(line, from, to) {
        const lines = this.area.value.split("\n");
        const start = lines.slice(0, line).reduce((sum, it) => sum + it.length + 1, 0);
        const letters = [...lines[line] ?? ""];
        const at = (count) => Math.min(start + letters.slice(0, count).join("").length, this.area.value.length);
        return [at(from), at(to)];
    }

    // Underlines these places, each a file, a line from 1, and two columns from 0.
    mark(places) {
        const { value } = this.area;
        this.area.ariaInvalid = String(places.length > 0);
        const ranges = places.map(([, line, from, to]) => this.range(line - 1, from, Math.max(to, from + 1)));
        ranges.sort(([one], [other]) => one - other);
        const parts = [];
        let done = 0;
        for (const [start, end] of ranges.filter(([start]) => start >= done)) {
            const mark = document.createElement("mark");
            mark.textContent = value.slice(start, end) || " ";
            parts.push(value.slice(done, start), mark);
            done = Math.max(end, done);
        }
        this.faults.replaceChildren(...parts);
    }

    go(line, column) {
        this.area.focus();
        this.area.setSelectionRange(...this.range(line, column, column));
    }

    select(at, length) {
        this.area.focus({ preventScroll: true });
        this.area.setSelectionRange(at, at + length);
    }

    // Returns the position and the length of the `todo!()` in the first empty function of this
    // code; or the position where its first function begins, and 0.
    toType(code) {
        const { value } = this.area;
        const starts = [...code.matchAll(/\bfn \w+/g)].map(([name]) => value.indexOf(name)).filter((at) => at >= 0);
        const isEmpty = (at) => /^fn (?:(?!\bfn )[^])*?todo!\(\)/.test(value.slice(at));
        const at = starts.find(isEmpty);
        return at === undefined ? [starts[0] ?? 0, 0] : [value.indexOf("todo!()", at), "todo!()".length];
    }

    // Types a line above another one, or in its place.
    insert(line, text, isInstead) {
        const [start, end] = this.range(line, 0, isInstead ? Infinity : 0);
        const isAtEnd = start === this.area.value.length;
        this.replace(isInstead ? text : isAtEnd ? `\n${text}` : `${text}\n`, [start, end]);
        this.area.setSelectionRange(start + text.length, start + text.length);
    }
}

// Returns the indentation of the condition that continues in the last of these lines; null if none
// does.
function indentOfCondition(lines) {
    const isMore = (line) => /^\s*(&&|\|\|)/.test(line);
    const start = lines.findLast((line) => !isMore(line)) ?? "";
    const isOpen = /^\s*(\} else )?(if|while)\b/.test(start) && !lines.at(-1).trimEnd().endsWith("{");
    return isOpen ? start.match(/^ */)[0].length : null;
}

const PANEL = `<pre aria-hidden="true"><code class="hljs"></code></pre><pre class="faults" aria-hidden="true"></pre>
<textarea spellcheck="false" autocapitalize="off" autocomplete="off" autocorrect="off" wrap="off"></textarea>`;
