// Do live figures draw what was woven, and follow mouse, finger and keyboard?

import assert from "node:assert/strict";

import { PAGES, alive, complaintsSoFar, inBrowsers, nextFrame, open, textOf } from "./browsers.js";

// The page and the name of each live figure.
const FIGURES = PAGES.flatMap((place) =>
    [...textOf(place).matchAll(/<figure id="(\w+)"[^>]*data-figure/g)].map(([, name]) => [place, name]));
assert.ok(FIGURES.length >= 10, `only ${FIGURES.length} live figures`);

for (const [place, name] of FIGURES) {
    inBrowsers(`${place}: the figure ${name} is as woven, and its handles follow the pointer`, async (page) => {
        const before = await visit(page, `${place}#${name}`, name);
        assert.deepEqual({ ...before, link: null }, await page.evaluate(shownIn, name, textOf(place)));
        const middle = await middleOf(await page.$(`#${name} svg`));
        for (const handle of await page.$$(`#${name} .handle`)) {
            const from = await middleOf(handle);
            // Inwards, by more than half of a pixel of the grid, which is its least step.
            const to = from.map((at, axis) => at + 24 * Math.sign(middle[axis] - at));
            const distance = ([x, y]) => Math.hypot(x - to[0], y - to[1]);
            for (const drag of [byMouse, byFinger]) {
                await drag(page, from, to);
                assert.notEqual((await shown(page, name)).link, before.link, `${drag.name}: nothing moves`);
                assert.ok(distance(await middleOf(handle)) < distance(from), `${drag.name}: it stays behind`);
                assert.deepEqual(await click(page, name, "reset"), before, `${drag.name}: a reset leaves something`);
            }
        }
        assert.deepEqual(complaintsSoFar(), []);
    });
}

inBrowsers("a button changes a figure, and the link leads back to it", async (page) => {
    await visit(page, "gradient.html#ray", "ray");
    const after = await click(page, "ray", "0");
    assert.deepEqual(await visit(page, `gradient.html${after.link}`, "ray"), after);
});

inBrowsers("arrows move a handle, with Shift by ten steps, and Home to the least", async (page) => {
    const link = async (name) => (await shown(page, name)).link;
    await visit(page, "gradient.html#ray", "ray");
    await page.focus("#ray .handle input");
    await page.keyboard.press("ArrowRight");
    await page.keyboard.down("Shift");
    await page.keyboard.press("ArrowUp");
    await page.keyboard.up("Shift");
    assert.equal(await link("ray"), "?ray=0.05,0.5,1,0.5,2#ray");
    await page.keyboard.press("Home");
    assert.equal(await link("ray"), "?ray=0.05,-0.75,1,0.5,2#ray");
    // The row above has the smaller number.
    await page.focus("#viewport_grid .handle input");
    await page.keyboard.press("ArrowUp");
    assert.equal(await link("viewport_grid"), "?viewport_grid=8,5,1#viewport_grid");
});

async function visit(page, place, name) {
    await open(page, place);
    await alive(page);
    await page.$eval(`#${name}`, (figure) => figure.scrollIntoView({ block: "center" }));
    return shown(page, name);
}

async function click(page, name, action) {
    await page.$eval(`#${name} [data-action="${action}"]`, (button) => button.click());
    return shown(page, name);
}

async function shown(page, name) {
    await nextFrame(page);
    return page.evaluate(shownIn, name);
}

// Returns a figure's words, the words of the page that follow it, and its link: on the current page, or
// in the text of one.
function shownIn(name, text) {
    const page = text ? new DOMParser().parseFromString(text, "text/html") : document;
    const figure = page.getElementById(name);
    return {
        words: figure.querySelector("svg").textContent,
        sentence: figure.querySelector(".sentence").innerHTML,
        told: [...page.querySelectorAll(`[data-told^="${name} "]`)].map((it) => it.textContent),
        link: figure.querySelector(".this-case").getAttribute("href"),
    };
}

async function middleOf(element) {
    const { x, y, width, height } = await element.boundingBox();
    return [x + width / 2, y + height / 2];
}

async function byMouse({ mouse }, from, to) {
    await mouse.move(...from);
    await mouse.down();
    await mouse.move(...to, { steps: 3 });
    await mouse.up();
}

async function byFinger({ touchscreen }, from, to) {
    await touchscreen.touchStart(...from);
    await touchscreen.touchMove(...to);
    await touchscreen.touchEnd();
}
