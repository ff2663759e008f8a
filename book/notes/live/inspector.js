// Shows the numbers behind a pixel as a table. Rust writes them as lines: a label, and then the value
// that each program computes.

"use strict";

// Shows the lines in `box`, a column for each program under its head. A value that differs from the
// first program's is bold. The line `yours`, the levels of the reader's pixel, becomes a sentence
// below.
function showNumbers(box, lines, [column, row], heads) {
    const rows = lines.split("\n").map((line) => line.split("\t"));
    const yours = rows.findIndex(([label]) => label === "yours");
    const [, levels] = yours < 0 ? [] : rows.splice(yours, 1)[0];
    const table = document.createElement("table");
    const columns = rows[0].length - 1;
    const caption = table.createCaption();
    caption.textContent = `Column ${column}, row ${row}`;
    const head = table.createTHead().insertRow();
    ["", ...heads].slice(0, columns + 1).forEach((words) => {
        const cell = document.createElement(words ? "th" : "td");
        cell.textContent = words;
        head.append(cell);
    });
    const body = table.createTBody();
    for (const [label, ...said] of rows) {
        const line = body.insertRow();
        const name = document.createElement("th");
        name.scope = "row";
        name.textContent = label;
        line.append(name);
        said.forEach((value, n) => {
            const cell = line.insertCell();
            const other = n > 0 && value !== said[0];
            cell.append(other ? Object.assign(document.createElement("strong"), { textContent: value }) : value);
            if (label === "levels") {
                cell.prepend(patch(value));
            }
        });
    }
    box.replaceChildren(table);
    if (levels) {
        const sentence = document.createElement("p");
        sentence.append("Your picture has ", patch(levels), levels, " here.");
        box.append(sentence);
    }
}

// Returns the pixel to which an arrow key leads, ten pixels away with Shift; null for any other key.
function pixelByArrow([column, row], event) {
    const step = event.shiftKey ? 10 : 1;
    const way = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowDown: [0, 1], ArrowUp: [0, -1] }[event.key];
    if (!way || event.ctrlKey || event.altKey || event.metaKey) {
        return null;
    }
    event.preventDefault();
    return [column + step * way[0], row + step * way[1]];
}

// Returns the pixel of a picture of that size which is nearest to `pixel`.
function nearestPixel(pixel, size) {
    return pixel.map((it, n) => Math.min(Math.max(it, 0), size[n] - 1));
}

// Returns a small square of the color with these levels, such as "128 178 255".
function patch(levels) {
    const square = document.createElement("span");
    square.className = "patch";
    square.style.background = `rgb(${levels.split(" ").join(",")})`;
    return square;
}
