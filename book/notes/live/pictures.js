// Live pictures: shows what a chapter's own code paints, and beside it what a slip does.
//
// Rust hands out a picture in pieces. Each frame shows as many as there are in a few
// milliseconds, so that the page never waits for a picture, however wide.

"use strict";

const MILLISECONDS_A_FRAME = 5;

// Ends with the last picture that was asked for. Rust paints one at a time, and the page
// of the whole book has six.
let painting = Promise.resolve();

class LivePicture {
    constructor(figure, rust) {
        this.figure = figure;
        this.rust = rust;
        this.place = Number(figure.dataset.picture);
        [this.right, this.wrong] = figure.querySelectorAll("canvas");
        this.canvases = figure.querySelector(".canvases");
        this.sentence = figure.querySelector(".sentence");
        this.inspector = figure.querySelector(".inspector");
        this.width = figure.querySelector("input[type=number]");
        this.slip = figure.querySelector("select");
        // Counts what was asked for: what is painted for an earlier question is given up.
        this.turn = 0;
        // The right picture that is shown: its width and its pixels.
        this.painted = null;
        // The pixel whose numbers are shown.
        this.chosen = null;

        for (const canvas of [this.right, this.wrong]) {
            canvas.addEventListener("click", (event) => this.touch(canvas, event));
            canvas.addEventListener("keydown", (event) => {
                const next = beside(this.chosen ?? this.middle(), event);
                next && this.choose(next);
            });
        }
        figure.addEventListener("input", () => this.show());
        // What was taken is in the field when the reader leaves it.
        this.width.addEventListener("change", () => { this.width.value = this.taken(); });
        figure.addEventListener("click", ({ target }) => {
            if (target.dataset.action === "reset") {
                this.ask(this.width.defaultValue, "");
            } else if (target.dataset.action === "more") {
                this.slip.querySelectorAll("optgroup").forEach((it) => { it.hidden = false; });
                target.remove();
                this.slip.focus();
            }
        });
        figure.classList.add("alive");
        this.ask(...this.fromLink());
    }

    // A link such as ?picture=100,minus-h#picture carries a width and a slip.
    fromLink() {
        const [width, slip] = new URLSearchParams(location.search).get(this.figure.id)?.split(",") ?? [];
        return [width ?? this.width.defaultValue, slip ?? ""];
    }

    ask(width, slip) {
        this.width.value = width;
        this.slip.value = slip;
        if (this.slip.selectedIndex < 0) {
            this.slip.value = "";
        }
        this.show();
    }

    // The width, within its limits. An empty field, or no number in a link, is as good as none.
    taken() {
        const asked = Math.trunc(this.width.value || this.width.defaultValue);
        return Math.min(Math.max(asked, this.width.min), this.width.max);
    }

    async show() {
        const turn = ++this.turn;
        const width = this.taken();
        const slip = Number(this.slip.selectedOptions[0].dataset.slip);
        this.sentence.ariaBusy = "true";
        this.figure.querySelector(".this-case").href =
            `?${this.figure.id}=${width},${this.slip.value}#${this.figure.id}`;
        this.wrong.hidden = slip < 0;
        this.wrong.ariaLabel = `What this draws: ${this.slip.selectedOptions[0].label}: arrows choose a pixel`;

        for (const canvas of [this.right, this.wrong]) {
            canvas.classList.toggle("pixels", width < this.width.defaultValue);
        }

        // Another slip leaves the right picture as it is.
        if (this.painted?.width !== width) {
            this.painted = await this.paint(this.right, -1, width, turn);
        }
        const others = this.painted?.pixels;
        const last = slip < 0 ? this.painted : await this.paint(this.wrong, slip, width, turn, others);
        if (last && turn === this.turn) {
            const length = this.rust.verdict(this.place, slip, width, last.different);
            this.sentence.innerHTML = read(this.rust, length);
            this.sentence.ariaBusy = "false";
            // Of another width it is another pixel.
            this.choose(this.chosenWidth === width ? this.chosen : null);
        }
    }

    middle() {
        return [this.right.width, this.right.height].map((it) => Math.floor(it / 2));
    }

    touch(canvas, { clientX, clientY }) {
        const box = canvas.getBoundingClientRect();
        const across = (clientX - box.left) / box.width;
        const down = (clientY - box.top) / box.height;
        this.choose([across * canvas.width, down * canvas.height].map(Math.floor));
    }

    // Shows the numbers of a pixel, and where it is; or of none.
    choose(pixel) {
        this.canvases.classList.toggle("touched", pixel !== null);
        if (pixel === null) {
            this.chosen = null;
            this.inspector.textContent = "Choose a pixel, and see its numbers.";
            return;
        }
        const size = [this.right.width, this.right.height];
        this.chosen = within(pixel, size);
        this.chosenWidth = this.taken();
        ["--x", "--y"].forEach((name, n) => {
            this.canvases.style.setProperty(name, (this.chosen[n] + 0.5) / size[n]);
        });
        const slip = Number(this.slip.selectedOptions[0].dataset.slip);
        const length = this.rust.inspect(this.place, slip, this.chosenWidth, ...this.chosen);
        showNumbers(this.inspector, read(this.rust, length), this.chosen, ["as it should be", "with that mistake"]);
    }

    // Paints a picture after those that were asked for before. Returns its pixels, and how
    // many are different from `others`; or nothing, if something else is asked for meanwhile.
    paint(canvas, slip, width, turn, others) {
        painting = painting.then(() => this.paintNow(canvas, slip, width, turn, others));
        return painting;
    }

    async paintNow(canvas, slip, width, turn, others) {
        if (turn !== this.turn) {
            return null;
        }
        this.rust.paint(this.place, slip, width);
        const image = imageOf(canvas, this.rust.get(0), this.rust.get(1));
        const pixels = new Uint32Array(image.data.buffer);
        let [from, done, different] = [-1, 0, 0];
        while (from < done) {
            [from, done] = [done, this.paintPieces(image.data, done)];
            const top = Math.floor(from / (4 * image.width));
            const bottom = Math.ceil(done / (4 * image.width));
            canvas.getContext("2d").putImageData(image, 0, 0, 0, top, image.width, bottom - top);
            for (let n = from / 4; others && n < done / 4; n++) {
                different += Number(pixels[n] !== others[n]);
            }
            await new Promise(requestAnimationFrame);
            if (turn !== this.turn) {
                return null;
            }
        }
        return { width, pixels, different };
    }

    // Paints what can be painted in a part of a frame, from the byte `done` on; returns
    // where it ends.
    paintPieces(data, done) {
        const end = performance.now() + MILLISECONDS_A_FRAME;
        let length;
        do {
            length = this.rust.piece();
            data.set(bytes(this.rust, length), done);
            done += length;
        } while (length > 0 && performance.now() < end);
        return done;
    }
}

// The pixels of a canvas of that size. Where a slip leaves no pixel, one is left blank.
function imageOf(canvas, width, height) {
    const size = [Math.max(width, 1), Math.max(height, 1)];
    if (canvas.width !== size[0] || canvas.height !== size[1]) {
        [canvas.width, canvas.height] = size;
    }
    return new ImageData(...size);
}
