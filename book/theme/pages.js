// What mdBook's pages lack for a narrow screen, for the keyboard, and for whoever has a
// page read aloud.

// What opens the sidebar is a label to mdBook, which no keyboard reaches: a button stands
// for it.
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

// The keyboard need not go through the list of pages.
const main = document.querySelector("main");
main.id = "text";
main.tabIndex = -1;
const skip = document.createElement("a");
skip.className = "skip";
skip.href = "#text";
skip.textContent = "Skip to the text";
document.body.prepend(skip);

// The list of pages scrolls to this one, and Chromium then begins there with Tab.
if (!location.hash) {
    document.body.tabIndex = -1;
    document.body.focus({ preventScroll: true });
    document.body.removeAttribute("tabindex");
}

// The arrows turn the page, unless something has the keyboard: what scrolls, what a figure
// has, or a button that was pressed. mdBook listens at the document, behind the body.
document.body.addEventListener("keydown", (event) => {
    if (/^Arrow(Left|Right)$/.test(event.key) && event.target !== document.body) {
        event.stopPropagation();
    }
});

// A table that is too wide for the page is restacked: a row becomes a block, in which
// each field has its label (see book.css).
for (const table of document.querySelectorAll("main table")) {
    const heads = [...table.querySelectorAll("thead th")];
    for (const row of table.querySelectorAll("tbody tr")) {
        [...row.cells].forEach((cell, column) => {
            cell.dataset.label = heads[column]?.textContent.trim() ?? "";
        });
    }
    // A head without words heads nothing.
    const blank = heads.filter((head) => !head.textContent.trim());
    blank.forEach((head) => head.replaceWith(document.createElement("td")));
    table.tHead.hidden = blank.length === heads.length;
}

function fit(box) {
    const table = box.querySelector(":scope > table");
    table?.classList.remove("stacked");
    table?.classList.toggle("stacked", box.scrollWidth > box.clientWidth);
    // What scrolls all the same can be reached.
    if (box.scrollWidth > box.clientWidth) {
        box.tabIndex = 0;
    } else {
        box.removeAttribute("tabindex");
    }
}

// Again whenever there is another width; the new height is no reason.
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

// Loads these scripts of the folder `live`, in this order.
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

// What moves live figures is loaded when the first comes near the screen, and the judge where
// there is something to judge.
const figures = [...document.querySelectorAll("figure.live")];
const modules = new Set(figures.map((figure) => figure.dataset.module));
const near = new IntersectionObserver((entries) => {
    if (entries.some((entry) => entry.isIntersecting)) {
        near.disconnect();
        load(...modules, "figures", "start");
    }
}, { rootMargin: "100%" });
figures.forEach((figure) => near.observe(figure));
if (document.getElementById("check")) {
    load("judge", "worker", "inspector", "pixels", "check");
}

// A search finds the lesson first, which is the first part of the list of pages, and the sources
// last: what a page says counts so many times. mdBook ranks pages by their words alone.
const LESSON = 4;
const SOURCES = 0.1;
if (window.elasticlunr) {
    const { search } = elasticlunr.Index.prototype;
    elasticlunr.Index.prototype.search = function (...asked) {
        const [, ...entries] = document.querySelectorAll("mdbook-sidebar-scrollbox :is(.part-title, a[href])");
        const end = entries.findIndex((it) => it.matches(".part-title"));
        const lesson = new Set(entries.slice(0, end).map((link) => link.pathname.split("/").at(-1)));
        const found = search.apply(this, asked);
        for (const result of found) {
            const [page] = window.search.doc_urls[result.ref].split("#");
            result.score *= lesson.has(page) ? LESSON : page === "bibliography.html" ? SOURCES : 1;
        }
        return found.sort((one, other) => other.score - one.score);
    };
    // A link to a search may have been faster; mdBook does not search for the same words twice.
    const bar = document.getElementById("mdbook-searchbar");
    if (window.search.index && bar.value) {
        for (const words of [`${bar.value} again`, bar.value]) {
            bar.value = words;
            bar.dispatchEvent(new Event("keyup"));
        }
    }
}

// What a reader types can be typed beside its listing, and broken there. The
// editor is loaded when it is first asked for, which takes seconds on a slow line.
let editor = null;
async function type(tools, isBroken = false, asked = tools) {
    const sign = document.createElement("p");
    sign.className = "loading";
    sign.role = "status";
    sign.textContent = "The editor is loading …";
    editor || asked.after(sign);
    editor ??= load("judge", "worker", "breaking", "editor");
    await editor;
    await openEditor(tools.parentElement, tools.dataset.chapter, isBroken);
    sign.remove();
}
const allTools = document.querySelectorAll(".listing > .tools");
for (const tools of allTools) {
    // A link to a listing opens it.
    if (location.hash === `#${tools.parentElement.querySelector(".source").id}`) {
        document.fonts.ready.then(() => type(tools));
    }
    tools.querySelectorAll("button").forEach((button) => {
        button.addEventListener("click", () => type(tools, button.className === "break"));
    });
}

// The page of a chapter begins with a way to type it, and the chapter before leads there.
const [first] = allTools;
if (first && location.pathname.endsWith(`/${first.dataset.chapter}.html`)) {
    const door = first.querySelector("button").cloneNode(true);
    door.className = "door";
    door.id = "type";
    door.addEventListener("click", () => type(first, false, door));
    document.querySelector("main > ul")?.after(door);
    if (location.hash === "#type") {
        document.fonts.ready.then(() => door.click());
    }
}

// Whoever has typed a chapter has drawn its picture.
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
