// Live figures: carries a reader's moves to Rust, and Rust's answers to the page.
//
// The package `page`, compiled into the modules, computes all that a figure shows, says and allows.
// This script knows nothing of rays: it sends numbers, and gets lines of text, which start.js reads.

"use strict";

class LiveFigure {
    constructor(figure, rust) {
        this.figure = figure;
        this.rust = rust;
        this.place = Number(figure.dataset.figure);
        this.stage = figure.querySelector(".stage");
        this.sentence = figure.querySelector(".sentence");
        this.handles = [...figure.querySelectorAll(".handle")];
        // The sliders or the list of each parameter, by its index.
        this.inputs = [];
        for (const input of figure.querySelectorAll("[data-number]")) {
            (this.inputs[input.dataset.number] ??= []).push(input);
        }
        // The attribute and not the current value, which Firefox keeps from the last visit.
        this.defaults = this.inputs.map(
            ([input]) => Number(input.getAttribute("value") ?? input.options[0].value));
        this.numbers = this.fromLink() ?? [...this.defaults];
        // The change to be made before the next frame: the last one, if there are several drags.
        this.waiting = null;

        this.handles.forEach((handle, n) => this.listenToPointer(handle, n));
        figure.addEventListener("input", ({ target }) => this.take(target));
        figure.addEventListener("change", () => this.settle());
        figure.addEventListener("click", ({ target }) => this.click(target.dataset.action));
        figure.addEventListener("keydown", (event) => this.press(event));
        this.draw();
        this.settle();
        figure.classList.add("alive");
    }

    // Returns the numbers in a link such as ?ray=0,0,1,0.5,2#ray, or null if it has none for this
    // figure.
    fromLink() {
        const numbers = new URLSearchParams(location.search).get(this.figure.id)?.split(",").map(Number);
        return numbers?.length === this.inputs.length ? numbers : null;
    }

    // Lets the handle follow mouse, finger and pen, from the point where it was grasped.
    listenToPointer(handle, n) {
        let grip = null;
        handle.addEventListener("pointerdown", (event) => {
            if (event.button !== 0) {
                return;
            }
            const [box, stage] = [handle, this.stage].map((it) => it.getBoundingClientRect());
            const sheet = this.sheet();
            grip = {
                x: stage.left + event.clientX - (box.left + box.right) / 2,
                y: stage.top + event.clientY - (box.top + box.bottom) / 2,
                scale: sheet.width / stage.width,
            };
            handle.setPointerCapture(event.pointerId);
            handle.querySelector("input").focus({ preventScroll: true });
            event.preventDefault();
        });
        handle.addEventListener("pointermove", (event) => {
            if (grip) {
                const [x, y] = [event.clientX - grip.x, event.clientY - grip.y];
                const { scale } = grip;
                this.request(() => this.rust.drag(this.place, n, scale * x, scale * y));
            }
        });
        for (const end of ["pointerup", "pointercancel"]) {
            handle.addEventListener(end, () => {
                grip = null;
                this.settle();
            });
        }
    }

    // Returns the size of the drawing in its own units.
    sheet() {
        return this.stage.querySelector("svg").viewBox.baseVal;
    }

    // Moves a handle by the arrow keys, left and right or up and down; by ten steps with Shift.
    press(event) {
        const slider = event.target;
        if (slider.type !== "range") {
            return;
        }
        const sign = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
        if (!sign || event.ctrlKey || event.altKey || event.metaKey) {
            return;
        }
        event.preventDefault();
        const [across, up = across] = slider.parentElement.querySelectorAll("input");
        const chosen = event.key === "ArrowUp" || event.key === "ArrowDown" ? up : across;
        chosen.focus();
        const way = chosen === up && "downwards" in chosen.dataset ? -sign : sign;
        chosen.stepUp(way * (event.shiftKey ? 10 : 1));
        this.take(chosen);
        this.settle();
    }

    click(action) {
        if (action === "reset") {
            this.numbers = [...this.defaults];
            this.request(() => {});
        } else if (action) {
            this.request(() => this.rust.act(this.place, Number(action)));
        }
        this.settle();
    }

    take(input) {
        this.numbers[input.dataset.number] = Number(input.value);
        this.request(() => {});
    }

    // Makes a change and draws, once before the next frame, however often it is called.
    request(change) {
        if (!this.waiting) {
            requestAnimationFrame(() => this.draw());
        }
        this.waiting = change;
        this.sentence.ariaBusy = "true";
    }

    draw() {
        this.numbers.forEach((value, n) => this.rust.set(n, value));
        this.waiting?.();
        this.waiting = null;
        const answer = read(this.rust, this.rust.answer(this.place));
        const [svg, sentence, ...lines] = answer.split("\n");
        this.numbers = this.numbers.map((_, n) => this.rust.get(n));
        this.stage.querySelector("svg").outerHTML = svg;
        this.sentence.innerHTML = sentence;
        this.update(lines.map((line) => line.split("\t")));
    }

    update(lines) {
        const of = (kind) => lines.filter(([first]) => first === kind).map(([, ...rest]) => rest);
        const sheet = this.sheet();
        of("handle").forEach(([x, y], n) => {
            // A handle that would leave the drawing stays at its rim, so that it can be dragged back.
            const percent = (place, size) => `${100 * Math.min(Math.max(place / size, 0), 1)}%`;
            this.handles[n].style.left = percent(x, sheet.width);
            this.handles[n].style.top = percent(y, sheet.height);
        });
        of("value").forEach(([value, words, most], n) => {
            for (const input of this.inputs[n]) {
                input.max = most;
                input.value = value;
                // A list reads its choice aloud by itself.
                if (input.type === "range") {
                    input.ariaValueText = words;
                }
            }
        });
        of("says").forEach(([name, value]) => {
            for (const number of document.querySelectorAll(`[data-told="${this.figure.id} ${name}"]`)) {
                number.textContent = value;
            }
        });
    }

    // Ends a move: lets the sentence be read aloud, and the link lead to the current state.
    settle() {
        requestAnimationFrame(() => {
            this.sentence.ariaBusy = "false";
            const link = this.figure.querySelector(".this-case");
            link.href = `?${this.figure.id}=${this.numbers.join(",")}#${this.figure.id}`;
        });
    }
}
