// The page Check your picture: takes a file that a reader chooses, drops or pastes, has it judged,
// and shows the answer. No request leaves the page, because the judge is a part of it.

"use strict";

// The size in bytes above which a file is not read. The judge then says so.
const MOST_BYTES = 2 ** 29;
// The time in milliseconds between two looks at a file that is watched.
const LOOK = 500;
// The number of tries that the page lists.
const TRIES = 20;

class CheckPage {
    constructor(form) {
        this.form = form;
        this.judge = new Judge();
        this.lists = ["chapter", "probe"].map((name) => form.elements[name]);
        this.status = form.querySelector(".verdict");
        this.rest = form.querySelector(".rest");
        this.tries = form.querySelector(".tries");
        this.inspector = form.querySelector(".inspector");
        this.waiting = form.querySelector(".waiting");
        this.pixels = new Pixels(form.querySelector(".pixels"), (column, row) => this.inspect(column, row));
        // The file to be judged, and its handle if the page watches it.
        this.given = null;
        this.turn = 0;
        this.listen();
        this.judge.choices.then((choices) => this.offer(choices));
    }

    offer(choices) {
        for (const [list, name, what] of choices) {
            this.form.elements[list].append(new Option(what, name));
        }
        this.form.classList.add("alive");
    }

    listen() {
        const { form } = this;
        form.addEventListener("submit", (event) => event.preventDefault());
        form.elements.file.addEventListener("change", ({ target }) => this.take(target.files[0]));
        form.elements.text.addEventListener("input", ({ target }) => this.takeText(target.value));
        this.lists.forEach((list) => list.addEventListener("change", () => this.ask()));
        form.addEventListener("click", ({ target }) => this.click(target));
        form.elements.watch.hidden = !("showOpenFilePicker" in window);
        document.addEventListener("dragover", (event) => event.preventDefault());
        document.addEventListener("drop", (event) => this.drop(event));
        document.addEventListener("paste", (event) => this.paste(event));
    }

    async click({ dataset, name }) {
        if (name === "watch") {
            const [handle] = await showOpenFilePicker().catch(() => []);
            handle && this.take(await handle.getFile(), handle);
        } else if (name === "stop") {
            this.turn++;
            this.judge.start();
            this.status.textContent = "You stopped the check.";
            this.wait(false);
        } else if (dataset.probe !== undefined) {
            // The next picture will be that of the probe.
            const [chapter, probe] = this.lists;
            chapter.value = this.answer.chapter;
            probe.value = dataset.probe;
            this.status.textContent = "Draw the probe, and drop its picture here.";
            form.elements.file.focus();
        }
    }

    async drop(event) {
        event.preventDefault();
        const [item] = event.dataTransfer.items;
        const file = event.dataTransfer.files[0];
        const text = event.dataTransfer.getData("text");
        // This waits, so it comes last: nothing of the event is left after a wait.
        const handle = await item?.getAsFileSystemHandle?.().catch(() => null);
        file ? this.take(file, handle?.kind === "file" ? handle : null) : this.takeText(text);
    }

    paste(event) {
        const [file] = event.clipboardData.files;
        const text = event.clipboardData.getData("text");
        // The browser itself puts text into the text field.
        if (file || (text && event.target !== this.form.elements.text)) {
            event.preventDefault();
            file ? this.take(file) : this.takeText(text);
        }
    }

    takeText(text) {
        text.trim() && this.take(new File([text], "your pasted text"));
    }

    take(file, handle = null) {
        if (file) {
            this.given = { file, handle };
            this.ask();
            handle && this.watch(handle);
        }
    }

    // Judges the file again whenever it is saved, until the reader gives another one.
    async watch(handle) {
        while (this.given?.handle === handle) {
            await new Promise((done) => setTimeout(done, LOOK));
            // While another program writes the file, it may be gone.
            const file = await handle.getFile().catch(() => null);
            const last = this.given.file;
            const isNew = file && (file.lastModified !== last.lastModified || file.size !== last.size);
            if (isNew && this.given?.handle === handle) {
                this.given.file = file;
                await this.ask();
            }
        }
    }

    async ask() {
        if (!this.given) {
            return;
        }
        const turn = ++this.turn;
        const { file, handle } = this.given;
        this.status.textContent = `Judging ${file.name} …`;
        // The answer to the last picture goes at once.
        this.rest.replaceChildren();
        this.inspector.replaceChildren();
        this.pixels.box.hidden = true;
        this.wait(true);
        const asked = this.lists.map((list) => list.selectedIndex);
        try {
            const answer = await this.judge.judge({ file, most: MOST_BYTES, asked });
            this.show(answer, handle);
        } catch (error) {
            if (turn === this.turn) {
                this.giveUp(file, error);
            }
        }
        if (turn === this.turn) {
            this.wait(false);
        }
    }

    // Shows the seconds that judging has taken so far, if it takes more than one.
    wait(isBusy) {
        this.form.ariaBusy = String(isBusy);
        this.waiting.hidden = true;
        clearInterval(this.clock);
        const start = Date.now();
        this.clock = isBusy && setInterval(() => {
            this.waiting.hidden = false;
            this.waiting.querySelector("span").textContent = `${Math.round((Date.now() - start) / 1000)} s`;
        }, 1000);
    }

    show(answer, handle) {
        const before = this.answer;
        this.answer = answer;
        this.status.innerHTML = answer.verdict;
        this.rest.innerHTML = answer.rest;
        if (handle) {
            this.rest.append(`This page watches ${this.given.file.name} and judges it again whenever you save it.`);
        }
        // A guess is shown in the list where the reader can change it.
        const [chapter, probe] = this.lists;
        const guessed = answer.chapter && chapter.selectedIndex === 0;
        chapter.options[0].text = guessed ? `guessed: ${answer.chapter}` : "guess it";
        const found = answer.probe && probe.selectedIndex === 0;
        probe.options[0].text = found ? `guessed: ${answer.probe}` : "none";
        this.pixels.show(answer.pictures, answer.first);
        if (this.pixels.chosen) {
            this.inspect(...this.pixels.chosen);
        } else {
            this.inspector.replaceChildren();
        }
        this.remember(before);
    }

    giveUp({ name }, error) {
        const unreadable = error.message.includes("NotReadableError") || error.message.includes("NotFoundError");
        this.pixels.show([null, null, null]);
        this.status.textContent = unreadable
            ? `${name} has changed since you chose it: choose it again.`
            : `${name} needs more time or memory than this page has. The command has more: cargo rtrace check.`;
    }

    // Puts this try at the top of the list, with the change since the last one.
    remember(before) {
        const { answer } = this;
        const entry = document.createElement("li");
        const verdict = this.status.querySelector("strong").cloneNode(true);
        const time = new Date().toLocaleTimeString();
        entry.append(time, " ", this.given.file.name, ": ", verdict);
        if (answer.width) {
            entry.append(`, ${answer.width} × ${answer.height}`);
            answer.different && entry.append(`, ${answer.different} ${answer.different === 1 ? "pixel differs" : "pixels differ"}`);
        }
        const isLike = before?.width === answer.width && before?.height === answer.height && answer.width;
        const less = isLike ? before.different - answer.different : 0;
        if (less !== 0) {
            entry.append(less > 0 ? `, ${less} fewer than before` : `, ${-less} more than before`);
        }
        this.tries.prepend(entry);
        [...this.tries.children].slice(TRIES).forEach((old) => old.remove());
        this.tries.parentElement.hidden = false;
    }

    async inspect(column, row) {
        const lines = await this.judge.inspect(column, row).catch(() => "");
        if (lines) {
            const heads = ["as it should be", "with that mistake"];
            showNumbers(this.inspector, lines, [column, row], heads);
        }
    }
}

const form = document.getElementById("check");
const checkPage = new CheckPage(form);
