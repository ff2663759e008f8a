// Does a reader find, reach and print what is on a page?

import assert from "node:assert/strict";

import { alive, inBrowsers, open } from "./browsers.js";
import { eggs, overflow } from "./looks.js";

const FOUND = {
    "hit_sphere": "#listing-hit-sphere",
    "viewport_u": "gradient.html#listing-impl-Camera",
    "set_face_normal": "#listing-impl-HitRecord",
    "P(t)": "symbols.html#a-ray",
    "discriminant": "red_sphere.html#what-the-discriminant-says",
};
inBrowsers("the first that the search finds is the listing of a name", async (page) => {
    for (const [words, place] of Object.entries(FOUND)) {
        await open(page, `introduction.html?search=${encodeURIComponent(words)}`);
        await page.waitForSelector("#mdbook-searchresults a");
        const link = await page.$eval("#mdbook-searchresults a", (it) => it.getAttribute("href"));
        // Between page and place stands which words are to be marked.
        assert.ok(link.replace(/\?.*#/, "#").includes(place), `${words} leads to ${link}`);
    }
});

// Only in Chromium: a Firefox that nobody looks at shows no focus.
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

// Only in Chromium, which can be told that a screen is paper.
inBrowsers("on paper answers are open, and a live figure is a drawing with a caption", async (page) => {
    // As wide as a sheet between its margins.
    await open(page, "normals.html", 670);
    await page.emulateMediaType("print");
    const height = await page.$eval("#exercises ~ details.answer", (it) => it.clientHeight);
    const parts = await page.$$eval("#normal :is(.question, .handle, .sentence, button, svg, figcaption)", (all) =>
        all.filter((it) => it.checkVisibility()).map((it) => it.localName));
    const wrong = [...await page.evaluate(overflow), ...await page.evaluate(eggs)];
    await page.emulateMediaType();
    assert.ok(height > 50 + await page.$eval("#exercises ~ details.answer", (it) => it.clientHeight));
    assert.deepEqual([...parts, ...wrong], ["svg", "figcaption"]);
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
