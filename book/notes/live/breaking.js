// Lets a reader break a chapter at any word: the reader chooses a word, and from a list a text that
// people type instead. Rust makes the list and draws the broken program; this script only shows a
// menu. The menu is the browser's own list, so that keys, fingers and screen readers know it.

"use strict";

class Breaker {
    constructor(editor) {
        this.editor = editor;
        this.menu = editor.desk.querySelector(".instead");
        this.list = this.menu.querySelector("select");
        this.edit = null;
        this.list.addEventListener("input", () => this.make(this.offered[this.list.selectedIndex - 1]));
        this.menu.addEventListener("click", ({ target }) => target.dataset.action === "mend" && this.leave());
        this.menu.addEventListener("keydown", (event) => {
            // mdBook listens to keys for its search.
            event.stopPropagation();
            event.key === "Escape" && this.leave();
        });
        for (const { colors } of editor.files) {
            colors.addEventListener("click", ({ target }) => target.dataset.word && this.choose(Number(target.dataset.word)));
            colors.addEventListener("keydown", (event) => this.press(event));
        }
    }

    // Gets the words that can be chosen: the index of the file, start and end of each.
    async open() {
        this.words = await Editor.drawing.within(LONG_PATIENCE, "words", { chapter: this.editor.name });
        this.editor.files.forEach((file) => file.color());
    }

    // Makes buttons of the words of a file, where they are now.
    wrap(file) {
        const code = file.colors.firstChild;
        const walker = document.createTreeWalker(code, NodeFilter.SHOW_TEXT);
        const texts = [];
        for (let at = 0; walker.nextNode(); at += walker.currentNode.length) {
            texts.push([walker.currentNode, at]);
        }
        for (const [n, start, end] of this.placesIn(file).reverse()) {
            const [node, at] = texts.findLast(([, at]) => at <= start);
            if (end <= at + node.length) {
                const range = new Range();
                range.setStart(node, start - at);
                range.setEnd(node, end - at);
                const button = Object.assign(document.createElement("button"), { type: "button", className: "word", tabIndex: -1 });
                button.dataset.word = n;
                button.ariaHasPopup = "listbox";
                range.surroundContents(button);
            }
        }
        this.highlight(file, texts);
        const first = code.querySelector(`[data-word="${this.word}"]`) ?? code.querySelector(".word");
        first && (first.tabIndex = 0);
    }

    // Returns the words of a file (index, start, end), where the current edit has moved them; the words
    // that it replaces are left out.
    placesIn(file) {
        const [start, end, added] = this.edit?.file === file ? this.edit.at : [Infinity, Infinity, 0];
        const here = this.words.map((word, n) => [n, ...word]).filter(([, of]) => this.editor.files[of] === file);
        return here.filter(([, , from, to]) => to <= start || from >= end)
            .map(([n, , from, to]) => to <= start ? [n, from, to] : [n, from + added, to + added]);
    }

    // Highlights the text that the edit has put in.
    highlight(file, texts) {
        if (this.edit && this.edit.file !== file || !CSS.highlights) {
            return;
        }
        CSS.highlights.delete("broken");
        if (this.edit) {
            const [start, end, added] = this.edit.at;
            const range = new Range();
            const place = (at) => {
                const [node, from] = texts.findLast(([it, from]) => it.isConnected && from <= at);
                return [node, Math.min(at - from, node.length)];
            };
            range.setStart(...place(start));
            range.setEnd(...place(end + added));
            CSS.highlights.set("broken", new Highlight(range));
        }
    }

    button(n) {
        return this.editor.desk.querySelector(`[data-word="${n}"]`);
    }

    // Puts the keyboard on the first word at or behind a position of a file.
    begin(file, at) {
        const of = this.editor.files.indexOf(file);
        const n = this.words.findIndex(([it, start]) => it === of && start >= at);
        this.go(this.button(n));
    }

    go(button) {
        if (button) {
            this.editor.desk.querySelectorAll(".word[tabindex='0']").forEach((it) => { it.tabIndex = -1; });
            button.tabIndex = 0;
            button.focus();
        }
    }

    // Moves the keyboard by an arrow from word to word, or to the nearest word of the next line that has
    // one. Enter and the space bar choose a word.
    press(event) {
        const { key, target } = event;
        if (target.dataset.word && (key === "Enter" || key === " ")) {
            event.preventDefault();
            this.choose(Number(target.dataset.word));
        }
        const way = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[key];
        if (!way || !target.dataset.word) {
            return;
        }
        event.preventDefault();
        event.stopPropagation();
        const all = [...event.currentTarget.querySelectorAll(".word")];
        const here = target.getBoundingClientRect();
        let next = all[all.indexOf(target) + way];
        if (key === "ArrowDown" || key === "ArrowUp") {
            const boxes = all.map((it) => [it, it.getBoundingClientRect()]);
            const beyond = boxes.filter(([, box]) => way * (box.top - here.top) > here.height / 2);
            const away = ([, box]) => 1000 * Math.abs(box.top - here.top) + Math.abs(box.left - here.left);
            [next] = beyond.reduce((one, other) => away(other) < away(one) ? other : one, beyond[0] ?? []);
        }
        this.go(next);
    }

    async choose(n) {
        this.mend();
        this.word = n;
        const [of, start, end] = this.words[n];
        const turn = this.turn = {};
        const offered = await Editor.drawing.within(LONG_PATIENCE, "alternatives", { word: n });
        if (turn !== this.turn) {
            return;
        }
        this.offered = offered;
        const text = this.editor.files[of].full.slice(start, end);
        this.menu.querySelector("span").textContent = offered.length ? `In place of ${text}` : `This page knows nothing that people type in place of ${text}`;
        this.list.replaceChildren(new Option(`${text}, as it is`), ...offered.map(([label]) => new Option(label)));
        this.list.size = offered.length + 1;
        this.list.selectedIndex = 0;
        this.place(this.button(n));
        this.list.focus({ preventScroll: true });
    }

    // Puts the menu below its word; on a phone, the style sheet puts it at the bottom.
    place(button) {
        this.menu.hidden = false;
        const around = this.menu.offsetParent.getBoundingClientRect();
        const box = button.getBoundingClientRect();
        const left = Math.min(box.left - around.left, around.width - this.menu.offsetWidth);
        this.menu.style.setProperty("--beside", `${Math.max(left, 0)}px`);
        this.menu.style.setProperty("--below", `${box.bottom - around.top + 4}px`);
        this.menu.scrollIntoView({ block: "nearest" });
    }

    // Makes an edit in the chapter's own text; null makes none.
    make(offered) {
        this.editor.files.forEach((file) => { file.area.value = file.full; });
        this.edit = null;
        if (offered) {
            const [, [of, start, end], added] = offered;
            const file = this.editor.files[of];
            this.edit = { file, at: [start, end, added.length - (end - start)] };
            file.area.value = file.full.slice(0, start) + added + file.full.slice(end);
        }
        this.editor.files.forEach((file) => file.color());
        this.editor.changed();
    }

    mend() {
        this.menu.hidden = true;
        this.edit && this.make(null);
    }

    leave() {
        this.mend();
        this.go(this.button(this.word));
    }
}
