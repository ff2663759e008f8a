// Does the page Check your picture tell a right picture from a wrong one?

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";

import { TARGET, complaintsSoFar, inBrowsers, open, said } from "./browsers.js";

inBrowsers("each chapter's picture is right, and one that is turned is named", async (page) => {
    await open(page, "check.html");
    for (const chapter of ["build_test", "gradient", "red_sphere", "normals", "half_b_sphere", "hittable_list"]) {
        assert.match(await judged(page, "right.ppm", drawn(chapter)), / is right: /);
    }
    const levels = drawn("normals").split(" ");
    const head = levels.splice(0, 4);
    const turned = Array.from({ length: 225 }, (_, row) => levels.slice(1200 * (224 - row), 1200 * (225 - row)));
    assert.match(await judged(page, "turned.ppm", [...head, ...turned.flat()].join(" ")), /upside-down/);
    assert.deepEqual(complaintsSoFar(), []);
});

inBrowsers("a picture is chosen, and an arrow leads to the numbers of its next pixel", async (page) => {
    await open(page, "check.html");
    const field = await page.$("#check [name=file]");
    await field.uploadFile(`${TARGET}/pictures/red_sphere.ppm`);
    assert.match(await said(page, "#check", "red_sphere.ppm"), / is right: /);
    await page.click("#check canvas");
    await page.keyboard.press("ArrowRight");
    await page.waitForFunction(() => document.querySelector("#check caption")?.textContent.startsWith("Column 201,"));
    assert.match(await page.$eval("#check .inspector", (it) => it.textContent), /levels\s*\d+ \d+ \d+/);
});

inBrowsers("whatever is dropped is answered, and the page lives", async (page) => {
    await open(page, "check.html");
    for (const text of ["", "P3\n99999999 99999999\n255\n1 2 <b>\n", "P6\n4000000000 1\n255\n", "\x89PNG", "\xff\xd8\xff\xe0"]) {
        assert.doesNotMatch(await judged(page, `<b>${text.length}</b>`, text), / is right: /, text);
    }
    assert.equal(await page.$("#check b"), null);
    assert.match(await judged(page, "right.ppm", drawn("normals")), / is right: /);
    assert.deepEqual(complaintsSoFar(), []);
});

// Returns the picture that a chapter draws, as the text of a P3 file on one line.
function drawn(chapter) {
    return readFileSync(`${TARGET}/pictures/${chapter}.ppm`, "utf8").trim().replaceAll(/\s+/g, " ");
}

// Drops a file on the page, each letter of `text` a byte; returns the page's answer.
async function judged(page, name, text) {
    await page.evaluate((name, text) => {
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([Uint8Array.from(text, (it) => it.charCodeAt(0))], name));
        document.dispatchEvent(new DragEvent("drop", { dataTransfer }));
    }, name, text);
    return said(page, "#check", name);
}
