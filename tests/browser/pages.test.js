// Can every page be read, on a phone, a tablet and a desk, and in each theme of mdBook?

import assert from "node:assert/strict";

import axe from "axe-core";

import { PAGES, alive, complaintsSoFar, inBrowsers, nextFrame, open } from "./browsers.js";
import { faintTexts } from "./contrast.js";
import { faults } from "./looks.js";

for (const place of PAGES) {
    inBrowsers(`${place} can be read at every width and in every theme`, async (page) => {
        const problems = [];
        const look = async (where, find) => {
            problems.push(...(await page.evaluate(find)).map((it) => `${where}: ${it}`));
        };
        // A narrow window that was wide keeps the list of pages open.
        await open(page, place, 320);
        await alive(page);
        await page.evaluate(() => document.querySelectorAll("details").forEach((it) => { it.open = true; }));
        for (const width of [320, 375, 768, 1300]) {
            await page.setViewport({ width, height: 800 });
            // Tables fit themselves to the page after it was drawn.
            await nextFrame(page);
            await nextFrame(page);
            await look(`${width} pixels`, faults);
        }
        problems.push(...complaintsSoFar());
        await page.evaluate(axe.source);
        await look("axe-core", barriers);
        for (const theme of ["light", "rust", "coal", "navy", "ayu"]) {
            await page.evaluate((id) => document.getElementById(id)?.click(), `mdbook-theme-${theme}`);
            await nextFrame(page);
            await look(theme, faintTexts);
            await look(theme, linksByColor);
        }
        await page.evaluate(() => document.getElementById("mdbook-theme-default_theme")?.click());
        assert.equal(problems.join("\n"), "");
    });
}

// Returns the links that only their color tells from the text around them.
async function linksByColor() {
    const { violations } = await axe.run({ preload: false, runOnly: ["link-in-text-block"] });
    return violations.flatMap(({ id, nodes }) => nodes.map(({ target }) => `${id}: ${target}`));
}

// Returns the barriers for a reader who listens, or has only a keyboard. axe-core may not load style
// sheets: the page comes from a file, so the browser would complain.
async function barriers() {
    const rules = { "color-contrast": { enabled: false } };
    const { violations } = await axe.run({ preload: false, resultTypes: ["violations"], rules });
    return violations.map(({ id, nodes }) => `${id}, ${nodes.length} times: ${nodes[0].target}`);
}
