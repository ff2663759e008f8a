// Does a reader find and reach what is on a page?

import assert from "node:assert/strict";

import { alive, inBrowsers, open } from "./browsers.js";

const FOUND = {
    "discriminant": "red_sphere.html#what-the-discriminant-says",
    "half b": "half_b_sphere.html#chapter-4-half-of-b",
    "normal": "normals.html#which-way-the-normal",
    "viewport": "gradient.html#the-camera",
    "delta u": "gradient.html#the-grid-of-pixels",
    "b^2-4ac": "red_sphere.html#what-the-discriminant-says",
    "tangent": "red_sphere.html#what-the-discriminant-says",
    "shadow acne": "speed_vs_accuracy.html#shadow-acne-and-why-0001",
    "trait object": "hittable_list.html#what-becomes-of-vector-and-shared_ptr",
    "macOS": "setup.html#rust-on-your-machine",
    "black image": "slips.html#dark",
    "epsilon": "hittable_list.html#the-range-t_min-and-t_max",
    "front face": "hittable_list.html#outward-or-against-the-ray",
    "lerp": "gradient.html#the-color-of-the-sky",
    "gamma": "setup.html#what-is-not-here-yet",
    "t_min": "hittable_list.html#the-range-t_min-and-t_max",
    "trait": "hittable_list.html#anything-that-a-ray-can-hit",
    "NaN": "setup.html#from-a-color-to-levels-and-nan",
    "quadratic": "red_sphere.html",
    "proof": "proofs.html#proofs",
    "error": "speed_vs_accuracy.html",
    "f32": "speed_vs_accuracy.html",
    "errata": "errata.html#errata",
    "C++ to Rust": "cpp_to_rust.html",
};
inBrowsers("the first that the search finds is the lesson, or the page about the very word", async (page) => {
    for (const [words, place] of Object.entries(FOUND)) {
        await open(page, `introduction.html?search=${encodeURIComponent(words)}`);
        await page.waitForSelector("#mdbook-searchresults a");
        const link = await page.$eval("#mdbook-searchresults a", (it) => it.getAttribute("href"));
        // Between page and place stands which words are to be marked.
        assert.ok(link.replace(/\?.*#/, "#").includes(place), `${words} leads to ${link}`);
    }
});

inBrowsers("the first key leads past the list of pages", async (page) => {
    await open(page, "normals.html");
    await page.keyboard.press("Tab");
    await page.keyboard.press("Enter");
    assert.equal(await page.evaluate(() => document.activeElement.localName), "main");
}, ["Chromium"]);

// Only in Chromium: a Firefox without a window shows no focus.
inBrowsers("an answer opens by keyboard and shows where the keyboard is", async (page) => {
    // The keyboard goes on from the heading that was jumped to.
    await open(page, "normals.html#exercises");
    const answer = "details.answer > summary:focus";
    for (let steps = 0; steps < 10 && !await page.$(answer); steps++) {
        await page.keyboard.press("Tab");
    }
    assert.notEqual(await page.$eval(answer, (it) => getComputedStyle(it).outlineStyle), "none");
    await page.keyboard.press("Enter");
    assert.ok(await page.$eval(answer, (it) => it.parentElement.open));
}, ["Chromium"]);

inBrowsers("an arrow turns the page only where nothing has the keyboard", async (page) => {
    await open(page, "normals.html#the-code", 360);
    await alive(page);
    for (const place of [".listing pre > code[tabindex]", "#normal [data-action]", "details summary"]) {
        await page.focus(place);
        await page.keyboard.press("ArrowRight");
        assert.match(page.url(), /normals\.html/, `${place} has the keyboard`);
    }
    await page.evaluate(() => document.activeElement.blur());
    await Promise.all([page.waitForNavigation(), page.keyboard.press("ArrowRight")]);
    assert.doesNotMatch(page.url(), /normals\.html/);
});

inBrowsers("a letter says in a box what it is, and the next press leads to its row", async (page) => {
    await open(page, "gradient.html#a-ray-is-a-function");
    const letter = await page.$("a.symbol[href='symbols.html#bold-d']");
    await letter.click();
    assert.equal(await letter.evaluate((it) => it.title), "the direction of the ray");
    assert.notEqual(await letter.evaluate((it) => getComputedStyle(it, "::after").content), "none");
    assert.match(page.url(), /gradient\.html/);
    await Promise.all([page.waitForNavigation(), letter.click()]);
    assert.match(page.url(), /symbols\.html#bold-d$/);
});

inBrowsers("the page for the printer has the lesson alone if it is asked for", async (page) => {
    await page.evaluateOnNewDocument(() => { window.print = () => {}; });
    const titles = async (place) => {
        await open(page, place);
        return page.$$eval("main h1", (all) => all.map((it) => it.id));
    };
    const all = await titles("print.html");
    const lesson = await titles("print.html?lesson");
    assert.deepEqual(lesson, all.slice(0, all.indexOf("check-your-picture")));
}, ["Chromium"]);
