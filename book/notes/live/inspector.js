// The numbers of a pixel: lines of Rust, a label and then what each program has for it,
// become the rows of a table.

"use strict";

// Shows in `box` the lines under these heads. A number that the second program has otherwise
// than the first is marked; of the line `yours` there is the color beside the right one.
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
        sentence.append("Your picture has here ", patch(levels), levels, ".");
        box.append(sentence);
    }
}

// Where an arrow leads from a pixel, ten pixels with Shift; nothing for any other key.
function beside([column, row], event) {
    const step = event.shiftKey ? 10 : 1;
    const way = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowDown: [0, 1], ArrowUp: [0, -1] }[event.key];
    if (!way || event.ctrlKey || event.altKey || event.metaKey) {
        return null;
    }
    event.preventDefault();
    return [column + step * way[0], row + step * way[1]];
}

// The nearest pixel of a picture of that size.
function within(pixel, size) {
    return pixel.map((it, n) => Math.min(Math.max(it, 0), size[n] - 1));
}

// A square of that color.
function patch(levels) {
    const square = document.createElement("span");
    square.className = "patch";
    square.style.background = `rgb(${levels.split(" ").join(",")})`;
    return square;
}
