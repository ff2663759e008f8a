// Shows pictures side by side, enlarged up to single pixels: the right one, the reader's, the
// difference, and the right one over the reader's with a slider between.

"use strict";

class Pixels {
    // `box` has the canvases and the controls; `pick` is called with the column and the row of each
    // pixel that a reader chooses.
    constructor(box, pick) {
        this.box = box;
        this.pick = pick;
        this.canvases = [...box.querySelectorAll("canvas")];
        this.slider = box.querySelector("input[type=range]");
        this.pictures = [];
        this.canvases.forEach((canvas) => {
            canvas.addEventListener("click", (event) => this.click(canvas, event));
            canvas.addEventListener("keydown", (event) => this.press(event));
        });
        this.slider.addEventListener("input", () => this.draw());
        box.addEventListener("click", ({ target }) => this.act(target.dataset?.action));
        new ResizeObserver(() => this.draw()).observe(box);
    }

    // Shows new pictures. If they have the size of the old ones, zoom and chosen pixel stay. `first` is
    // the first pixel that differs.
    show(pictures, first) {
        const [width, height] = [this.width, this.height];
        this.pictures.forEach((picture) => picture?.close());
        this.pictures = pictures;
        const any = pictures.find((picture) => picture);
        this.box.hidden = !any;
        [this.width, this.height] = [any?.width, any?.height];
        this.first = first;
        if (this.width !== width || this.height !== height) {
            this.zoom = 1;
            this.chosen = null;
        }
        const [right, yours, difference] = pictures;
        this.canvases.forEach((canvas, n) => {
            canvas.parentElement.hidden = ![right, yours, difference, right && yours][n];
        });
        this.draw();
    }

    // Returns the part of the pictures that is shown (left, top, width and height in pixels), with the
    // chosen pixel as near to the middle as possible.
    view() {
        const [wide, high] = [this.width / this.zoom, this.height / this.zoom];
        const [column, row] = this.chosen ?? [this.width / 2, this.height / 2];
        const start = (middle, size, all) => Math.min(Math.max(middle + 0.5 - size / 2, 0), all - size);
        return [start(column, wide, this.width), start(row, high, this.height), wide, high];
    }

    draw() {
        if (this.box.hidden || !this.width) {
            return;
        }
        const [right, yours, difference] = this.pictures;
        [right, yours, difference, right && yours].forEach((picture, n) => {
            const canvas = this.canvases[n];
            if (!picture || !canvas.clientWidth) {
                return;
            }
            canvas.width = Math.round(canvas.clientWidth * devicePixelRatio);
            canvas.height = Math.max(Math.round(canvas.width * this.height / this.width), 1);
            const context = canvas.getContext("2d");
            context.imageSmoothingEnabled = canvas.width < this.width / this.zoom;
            this.paint(context, picture);
            if (n === 3) {
                const edge = canvas.width * this.slider.value / 100;
                context.save();
                context.beginPath();
                context.rect(0, 0, edge, canvas.height);
                context.clip();
                this.paint(context, right);
                context.restore();
                context.fillStyle = "#808080";
                context.fillRect(edge - 1, 0, 2, canvas.height);
            }
            this.mark(context);
        });
    }

    paint(context, picture) {
        const { width, height } = context.canvas;
        context.drawImage(picture, ...this.view(), 0, 0, width, height);
    }

    // Draws a frame around the chosen pixel that can be seen on any color.
    mark(context) {
        if (!this.chosen) {
            return;
        }
        const [left, above, wide] = this.view();
        const scale = context.canvas.width / wide;
        const size = Math.max(scale, 7);
        const at = [this.chosen[0] - left, this.chosen[1] - above].map((it) => (it + 0.5) * scale - size / 2);
        for (const [color, grown] of [["#000000", 1], ["#ffffff", 3]]) {
            context.strokeStyle = color;
            context.lineWidth = 2;
            context.strokeRect(at[0] - grown, at[1] - grown, size + 2 * grown, size + 2 * grown);
        }
    }

    click(canvas, event) {
        const box = canvas.getBoundingClientRect();
        const [left, above, wide, high] = this.view();
        this.choose(
            Math.floor(left + wide * (event.clientX - box.left) / box.width),
            Math.floor(above + high * (event.clientY - box.top) / box.height));
    }

    press(event) {
        const next = pixelByArrow(this.chosen ?? this.first, event);
        if (next) {
            this.choose(...next);
        } else if (event.key === "+" || event.key === "-") {
            this.act(event.key === "+" ? "closer" : "farther");
        }
    }

    choose(column, row) {
        this.chosen = nearestPixel([column, row], [this.width, this.height]);
        this.draw();
        this.pick(...this.chosen);
    }

    act(action) {
        const most = Math.max(this.width / 8, 1);
        const zoom = { closer: this.zoom * 2, farther: this.zoom / 2, whole: 1, first: most }[action];
        if (zoom === undefined) {
            return;
        }
        this.zoom = Math.min(Math.max(zoom, 1), most);
        if (action === "first" || !this.chosen) {
            this.choose(...this.first);
        }
        this.draw();
    }
}
