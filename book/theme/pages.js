// Adds to mdBook's pages what they lack on a narrow screen, for a keyboard, and for a reader who has
// them read aloud.

// mdBook opens the sidebar by a label, which no keyboard reaches: a button takes its place.
const label = document.getElementById("mdbook-sidebar-toggle");
const opened = document.getElementById("mdbook-sidebar-toggle-anchor");
const button = document.createElement("button");
button.className = label.className;
button.type = "button";
button.title = label.title;
button.setAttribute("aria-label", label.title);
button.setAttribute("aria-controls", "mdbook-sidebar");
button.append(...label.childNodes);
button.addEventListener("click", () => label.click());
const tell = () => button.setAttribute("aria-expanded", opened.checked);
opened.addEventListener("change", tell);
tell();
label.before(button);
label.style.display = "none";

document.getElementById("mdbook-menu-bar").role = "banner";

// A first link skips the list of pages for the keyboard.
const main = document.querySelector("main");
main.id = "text";
main.tabIndex = -1;
const skip = document.createElement("a");
skip.className = "skip";
skip.href = "#text";
skip.textContent = "Skip to the text";
document.body.prepend(skip);

// The list of pages scrolls to the current one, and Chromium would then begin there with Tab.
if (!location.hash) {
    document.body.tabIndex = -1;
    document.body.focus({ preventScroll: true });
    document.body.removeAttribute("tabindex");
}

// The arrow keys turn the page only while nothing has the keyboard: no box that scrolls, no figure
// and no button. mdBook listens at the document, which gets a key after the body.
document.body.addEventListener("keydown", (event) => {
    if (/^Arrow(Left|Right)$/.test(event.key) && event.target !== document.body) {
        event.stopPropagation();
    }
});

// A table that is too wide for the page is stacked: each row becomes a block, in which each field has
// its label (see book.css).
for (const table of document.querySelectorAll("main table")) {
    const heads = [...table.querySelectorAll("thead th")];
    for (const row of table.querySelectorAll("tbody tr")) {
        [...row.cells].forEach((cell, column) => {
            cell.dataset.label = heads[column]?.textContent.trim() ?? "";
        });
    }
    // A head without words becomes a plain cell.
    const blank = heads.filter((head) => !head.textContent.trim());
    blank.forEach((head) => head.replaceWith(document.createElement("td")));
    table.tHead.hidden = blank.length === heads.length;
}

// Stacks the table of a box if it is too wide.
function fit(box) {
    const table = box.querySelector(":scope > table");
    table?.classList.remove("stacked");
    table?.classList.toggle("stacked", box.scrollWidth > box.clientWidth);
    // A box that scrolls all the same can be reached by the keyboard.
    if (box.scrollWidth > box.clientWidth) {
        box.tabIndex = 0;
    } else {
        box.removeAttribute("tabindex");
    }
}

// Fits a box again whenever its width changes; a new height is no reason.
const widths = new Map();
const observer = new ResizeObserver((entries) => requestAnimationFrame(() => {
    for (const { target } of entries) {
        if (widths.get(target) !== target.clientWidth) {
            widths.set(target, target.clientWidth);
            fit(target);
        }
    }
}));
const boxes = "main .table-wrapper, main pre > code, main .formula, main td:has(math), main p:has(img[src*='terminal/'])";
document.fonts.ready.then(() => {
    document.querySelectorAll(boxes).forEach((box) => observer.observe(box));
});

// A letter is explained in a box where it stands: the first press shows the box, the next one leads
// to the letter's row.
document.addEventListener("click", (event) => {
    const letter = event.target.closest?.("a.symbol");
    const isOpen = letter?.classList.contains("open");
    document.querySelectorAll("a.symbol.open").forEach((it) => it.classList.remove("open"));
    if (letter && !isOpen && event.detail) {
        event.preventDefault();
        letter.classList.add("open");
    }
});

// Loads scripts of the folder `live`, in this order.
function load(...files) {
    return Promise.all(files.map((file) => new Promise((done, fail) => {
        const script = document.createElement("script");
        script.src = `live/${file}.js`;
        script.async = false;
        script.onload = done;
        script.onerror = fail;
        document.head.append(script);
    })));
}

// Returns the functions of a WebAssembly module. The module is a text, base64 of gzip, because a page
// that is opened from a file may load nothing but scripts.
async function instantiate(base64) {
    const compressed = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const module = new Blob([compressed]).stream().pipeThrough(new DecompressionStream("gzip"));
    const headers = { "Content-Type": "application/wasm" };
    const { instance } = await WebAssembly.instantiateStreaming(new Response(module, { headers }));
    return instance.exports;
}

// The scripts of live figures are loaded when the first figure comes near the screen, and those of the
// judge on the page Check your picture.
const figures = [...document.querySelectorAll("figure.live")];
const modules = new Set(figures.map((figure) => figure.dataset.module));
const near = new IntersectionObserver((entries) => {
    if (entries.some((entry) => entry.isIntersecting)) {
        near.disconnect();
        load(...[...modules].map((name) => `${name}.module`), "figures", "start");
    }
}, { rootMargin: "100%" });
figures.forEach((figure) => near.observe(figure));
if (document.getElementById("check")) {
    load("judge.module", "worker", "inspector", "pixels", "check");
}

// A search finds the lesson first, which is the first part of the list of pages, and the bibliography
// last: their scores are multiplied by these numbers. mdBook ranks pages by their words alone.
const LESSON = 4;
const BIBLIOGRAPHY = 0.1;
if (window.elasticlunr) {
    const { search } = elasticlunr.Index.prototype;
    elasticlunr.Index.prototype.search = function (...asked) {
        const [, ...entries] = document.querySelectorAll("mdbook-sidebar-scrollbox :is(.part-title, a[href])");
        const end = entries.findIndex((it) => it.matches(".part-title"));
        const lesson = new Set(entries.slice(0, end).map((link) => link.pathname.split("/").at(-1)));
        const found = search.apply(this, asked);
        for (const result of found) {
            const [page] = window.search.doc_urls[result.ref].split("#");
            result.score *= lesson.has(page) ? LESSON : page === "bibliography.html" ? BIBLIOGRAPHY : 1;
        }
        return found.sort((one, other) => other.score - one.score);
    };
    // A link to a search may have started it before. mdBook does not search for the same words twice,
    // so other words come between.
    const bar = document.getElementById("mdbook-searchbar");
    if (window.search.index && bar.value) {
        for (const words of [`${bar.value} again`, bar.value]) {
            bar.value = words;
            bar.dispatchEvent(new Event("keyup"));
        }
    }
}

// A reader can type a chapter beside its listing. The editor is loaded when it is first opened, which
// takes seconds on a slow line.
let editor = null;
async function type(tools, asked = tools) {
    const sign = document.createElement("p");
    sign.className = "loading";
    sign.role = "status";
    sign.textContent = "The editor is loading …";
    editor || asked.after(sign);
    editor ??= load("judge.module", "worker", "field", "editor");
    await editor;
    await openEditor(tools.parentElement, tools.dataset.chapter);
    sign.remove();
}
const allTools = [...document.querySelectorAll(".listing > .tools")];
for (const tools of allTools) {
    // A link to a listing opens the editor there.
    if (location.hash === `#${tools.parentElement.querySelector(".source").id}`) {
        document.fonts.ready.then(() => type(tools));
    }
    tools.querySelector("button").addEventListener("click", () => type(tools));
}

// The page of a chapter begins with a button that opens the editor, to which the page of the chapter
// before links.
const [first] = allTools;
if (first && location.pathname.endsWith(`/${first.dataset.chapter}.html`)) {
    const door = first.querySelector("button").cloneNode(true);
    door.className = "door";
    door.id = "type";
    door.addEventListener("click", () => type(first, door));
    document.querySelector("main > ul")?.after(door);
    if (location.hash === "#type") {
        document.fonts.ready.then(() => door.click());
    }
}

// The page of all pages, which prints itself, has only the lesson if it is asked for that.
if (location.search === "?lesson") {
    const tools = document.getElementById("check-your-picture");
    const rest = document.createRange();
    rest.setStartBefore(tools);
    rest.setEndAfter(main.lastChild);
    rest.deleteContents();
}

// Shows the pictures that the reader's own chapters have drawn.
for (const picture of document.querySelectorAll(".made img")) {
    const [, name] = picture.src.match(/(\w+)\.snap\.png$/);
    const drawn = localStorage.getItem(`drawn ${name}`);
    if (drawn) {
        picture.src = drawn;
        picture.alt += ", typed by you";
        picture.title = "Typed by you";
        picture.className = "yours";
    }
}
