// Does each chapter's page paint what the chapter draws, to the bit, and what is wrong? Does
// the page Check your picture tell one from the other?

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";

import { TARGET, alive, complaintsSoFar, inBrowsers, open, said } from "./browsers.js";

// The page of each chapter, and a slip that is seen in its picture.
const CHAPTERS = {
    build_test: ["setup.html", "red-and-green-swapped"],
    gradient: ["gradient.html", "viewport-upside-down"],
    red_sphere: ["red_sphere.html", "radius-not-squared"],
    normals: ["normals.html", "far-root"],
    half_b_sphere: ["half_b_sphere.html", "not-divided"],
    hittable_list: ["hittable_list.html", "farthest-wins"],
};

for (const [chapter, [place, slip]] of Object.entries(CHAPTERS)) {
    inBrowsers(`${place} paints ${chapter}, and what ${slip} draws, and the judge knows both`, async (page) => {
        await open(page, place);
        const [right] = await painted(page);
        assert.ok(right === drawn(chapter), "the page paints something else than the chapter draws");
        // Of what is asked for meanwhile only the last is painted.
        await ask(page, 1920, slip);
        await ask(page, 64, slip);
        const [, wrong] = await painted(page);
        const link = await page.$eval("#picture .this-case", (it) => it.getAttribute("href"));
        assert.equal(link, `?picture=64,${slip}#picture`);
        await open(page, `${place}${link}`);
        assert.ok((await painted(page))[1] === wrong, `${link} leads to another picture`);

        await open(page, "check.html");
        assert.match(await judged(page, "right.ppm", right), / is right: /);
        const answer = await judged(page, "wrong.ppm", wrong);
        assert.ok(answer.includes("64 × ") && answer.includes(slip), answer);
        assert.deepEqual(complaintsSoFar(), []);
    });
}

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

// The picture that a chapter draws, as the text of a P3 file in one line.
function drawn(chapter) {
    return readFileSync(`${TARGET}/pictures/${chapter}.ppm`, "utf8").trim().replaceAll(/\s+/g, " ");
}

// The pictures that are shown on a page, as such texts, once all is painted.
async function painted(page) {
    await alive(page);
    return page.$$eval("#picture canvas:not([hidden])", (canvases) => canvases.map((canvas) => {
        const { width, height } = canvas;
        const { data } = canvas.getContext("2d").getImageData(0, 0, width, height);
        return ["P3", width, height, 255, ...data.filter((_, n) => n % 4 < 3)].join(" ");
    }));
}

// Asks for a width and a slip, as a reader does who changes the one and the other.
async function ask(page, width, slip) {
    await page.$eval("#picture input[type=number]", (input, width) => { input.value = width; }, width);
    await page.select("#picture select", slip);
}

// What is said of a file that is dropped, each letter a byte.
async function judged(page, name, text) {
    await page.evaluate((name, text) => {
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([Uint8Array.from(text, (it) => it.charCodeAt(0))], name));
        document.dispatchEvent(new DragEvent("drop", { dataTransfer }));
    }, name, text);
    return said(page, "#check", name);
}
