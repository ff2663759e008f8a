// Tables that are too wide for the page are restacked: a row becomes a block, in which
// each field has its label (see book.css). What scrolls all the same can be reached by
// keyboard.
for (const table of document.querySelectorAll("main table")) {
    const labels = [...table.querySelectorAll("thead th")].map((head) => head.textContent.trim());
    for (const row of table.querySelectorAll("tbody tr")) {
        [...row.cells].forEach((cell, column) => { cell.dataset.label = labels[column] ?? ""; });
    }
}

const widths = new Map();

// Its width is measured as a table, so once more whenever the room for it changes.
function restack(wrapper, table) {
    table.classList.remove("stacked");
    table.classList.toggle("stacked", wrapper.scrollWidth > wrapper.clientWidth);
}

function makeReachable(box) {
    const scrolls = box.scrollWidth > box.clientWidth || box.scrollHeight > box.clientHeight;
    if (scrolls) {
        box.tabIndex = 0;
    } else {
        box.removeAttribute("tabindex");
    }
}

const observer = new ResizeObserver((entries) => requestAnimationFrame(() => {
    for (const { target } of entries) {
        if (widths.get(target) !== target.clientWidth) {
            widths.set(target, target.clientWidth);
            const table = target.querySelector(":scope > table");
            if (table) {
                restack(target, table);
            }
            makeReachable(target);
        }
    }
}));
const boxes = "main .table-wrapper, main pre > code, main p:has(img[src*='terminal/'])";
document.fonts.ready.then(() => {
    document.querySelectorAll(boxes).forEach((box) => observer.observe(box));
});
