// Is a chapter that is typed in its page drawn and judged there, whatever is typed?

import assert from "node:assert/strict";

import { complaintsSoFar, inBrowsers, open, said } from "./browsers.js";
import { faults } from "./looks.js";

const AREA = ".typing textarea";

inBrowsers("a chapter is typed in its page", async (page) => {
    assert.match(await begin(page, "normals.html"), /^Not written yet: todo!\(\) at src\/lib.rs/);
    // The listing's place in the text is selected, and Tab leaves the text field.
    const selected = await page.$eval(AREA, (it) => it.value.slice(it.selectionStart, it.selectionEnd));
    assert.equal(selected, "todo!()");
    await page.keyboard.press("Tab");
    assert.equal(await page.evaluate(() => document.activeElement.localName), "button");
    await page.click(".typing [data-action=full]");
    assert.match(await answer(page), /to the last bit\. The laws hold\./);
    assert.match(await page.$eval(".typing .rest a.door", (it) => it.href), /half_b_sphere\.html#type$/);
    assert.deepEqual(await page.evaluate(faults), []);

    // A wrong sign, with the reader's own line and the chapter's.
    assert.match(await typeOver(page, "-2.0", "2.0"), /^Wrong: [^]*b = 2\.0[^]*b = -2\.0/);
    assert.match(await typeOver(page, "return None;", "return false;"), /^The program does not compile\.[^]*expected `Option`, found `bool`/);
    assert.equal(await page.$eval(".typing .faults mark", (it) => it.textContent), "false");
    assert.match(await typeOver(page, "return false;", "loop {}"), /takes too many turns of loops and calls/);

    // Undo brings the last text back, and the browser keeps it until the next visit.
    await page.keyboard.down("Control");
    await page.keyboard.press("z");
    await page.keyboard.up("Control");
    await answer(page);
    const kept = await page.$eval(AREA, (area) => area.value);
    await begin(page, "normals.html");
    assert.equal(await page.$eval(AREA, (area) => area.value), kept);
    assert.deepEqual(complaintsSoFar(), []);
});

inBrowsers("a right function is never called wrong while it is typed", async (page) => {
    await begin(page, "normals.html");
    await page.$eval(".typing [data-action=empty]", (button) => button.click());
    const fault = ".typing :is(.is-wrong, .faults mark)";
    for (const [start, lines] of Object.entries(TYPED)) {
        await page.$eval(AREA, (area, start) => {
            const at = area.value.indexOf("todo!()", area.value.indexOf(start));
            area.setSelectionRange(at, at + 7);
        }, start);
        for (const [n, line] of lines.entries()) {
            // The last letter waits until all before it was answered.
            for (const typed of [`${n ? "\n" : ""}${line.slice(0, -1)}`, line.at(-1)]) {
                await page.keyboard.type(typed);
                const text = await answer(page);
                assert.equal(await page.$(fault), null, `${typed} of ${line}: ${text}`);
            }
        }
    }
    assert.match(await answer(page), /to the last bit/);
    // It lacks nothing, and no help changes it.
    const right = await page.$eval(AREA, (area) => area.value);
    for (const action of ["hint", "next"]) {
        await page.click(`.typing [data-action=${action}]`);
        await said(page, ".typing", "nothing is missing");
    }
    assert.equal(await page.$eval(AREA, (area) => area.value), right);
    // An unfinished line is judged when the caret leaves it.
    await page.focus(AREA);
    await page.keyboard.type("x");
    assert.match(await answer(page), /^Not finished: you are typing line \d+/);
    await page.keyboard.press("ArrowUp");
    await page.waitForSelector(fault);
});
const TYPED = {
    "fn ray_color": ["let center = Point3::new(0.0, 0.0, -1.0);", "if let Some(t) = hit_sphere(center, 0.5, ray)", "&& t > 0.0", "{",
        "let normal = (ray.at(t) - center).normalize();", "return 0.5 * (normal + Vec3::ONE);", "}", "sky(ray)"],
    "fn hit_sphere": ["let oc = center - ray.origin;", "let a = ray.direction.dot(ray.direction);", "let b = -2.0 * ray.direction.dot(oc);",
        "let c = oc.dot(oc) - radius * radius;", "let discriminant = b * b - 4.0 * a * c;", "if discriminant < 0.0 {", "return None;", "}",
        "Some((-b - discriminant.sqrt()) / (2.0 * a))"],
};

inBrowsers("a listing opens in its own file", async (page) => {
    await open(page, "hittable_list.html");
    await page.$eval(".listing:has(> #listing-first-HittableList) button", (button) => button.click());
    await page.waitForSelector(".typing");
    assert.equal(await page.$eval(".typing [type=radio]:checked", (it) => it.parentElement.innerText.trim()), "src/hittable_list.rs");
    assert.deepEqual(complaintsSoFar(), []);
});

inBrowsers("a finished line is judged where the reader rests, and the right line shows when asked for", async (page) => {
    await begin(page, "gradient.html");
    await page.click(".typing [data-action=full]");
    assert.match(await answer(page), /to the last bit/);
    await typeOver(page, "a) * white + a * blue", "a) * white");
    await said(page, ".typing", "Wrong");
    const isSeen = () => page.$eval(".typing .rest details code", (it) => it.checkVisibility());
    assert.equal(await isSeen(), false);
    await page.click(".typing .rest summary");
    assert.equal(await isSeen(), true);
    // What cannot be read yet is no mistake.
    assert.match(await typeOver(page, "a) * white", "a) * "), /^Not finished: you are typing line \d+/);
    await page.waitForFunction(() => document.querySelector(".typing .rest").textContent.startsWith("So far: "));
    assert.equal(await page.$(".typing :is(.is-wrong, .faults mark)"), null);
});

for (const width of [360, 375, 414]) {
    inBrowsers(`with ${width} pixels and a keyboard what is typed is seen, and indented as rustfmt has it`, async (page) => {
        await open(page, "normals.html#type", width);
        await page.setViewport({ width, height: 460 });
        await page.waitForSelector(".typing");
        await page.$eval(".typing [data-action=empty]", (button) => button.click());
        await page.$eval(AREA, (area) => area.setSelectionRange(area.value.indexOf("todo!()"), area.value.indexOf("todo!()") + 7));
        const heights = new Set();
        for (const [n, line] of INDENTED.entries()) {
            await page.keyboard.type((n ? "\n" : "") + line.trim());
            heights.add(await page.$eval(".typing .said", (it) => it.offsetHeight));
            // Firefox scrolls smoothly.
            await answer(page);
            const [first, typed, box, above, below, height] = await page.evaluate(places, AREA);
            const seen = `${line}: ${JSON.stringify([first, typed, box, above, below])}`;
            assert.ok(above <= typed.top + 2 && typed.bottom <= below + 2, seen);
            assert.ok(box.left <= typed.left && typed.right < box.right, seen);
            assert.ok(Math.abs(first.area - first.colors) < 1 && first.scrolled === 0, seen);
            heights.add(height);
        }
        assert.equal(heights.size, 1, `the answer is ${[...heights]} pixels high`);
        // The colored text breaks no line that the textarea above it does not break.
        const [lines, colored] = await page.evaluate((selector) => {
            const range = document.createRange();
            range.selectNodeContents(document.querySelector(".typing pre[aria-hidden] code"));
            return [document.querySelector(selector).value.split("\n").length, range.getBoundingClientRect().height / 19.5];
        }, AREA);
        assert.ok(Math.abs(lines - colored) < 2, `${lines} lines, ${colored} colored ones`);
        const text = await page.$eval(AREA, (area) => area.value);
        assert.ok(text.includes(`\n${INDENTED.join("\n")}\n`), text);
        // A line without its semicolon leaves the next one where it belongs.
        await typeOver(page, "- center;", "- center");
        await page.keyboard.type("\nlet color = normal;");
        assert.match(await page.$eval(AREA, (area) => area.value), /\n        let normal = [^\n]*\n        let color = normal;\n/);
    });
}
const INDENTED = ["    if let Some(t) = hit_sphere(center, 0.5, ray)", "        && t > 0.0", "    {",
    "        let normal = ray.at(t) - center;", "    }", "    sky(ray)"];

// Returns where the first column of the field and of its colors begins and by how much the field is
// scrolled, the box of the last typed letter, the box that scrolls, the room between the answer and the
// buttons, and the height of the answer.
function places(selector) {
    const box = (it) => document.querySelector(`.typing ${it}`).getBoundingClientRect();
    const area = document.querySelector(selector);
    const walker = document.createTreeWalker(document.querySelector(".typing pre[aria-hidden] code"), NodeFilter.SHOW_TEXT);
    let left = area.selectionStart;
    while (walker.nextNode() && walker.currentNode.length < left) {
        left -= walker.currentNode.length;
    }
    const letter = document.createRange();
    letter.setStart(walker.currentNode, left - 1);
    letter.setEnd(walker.currentNode, left);
    const first = { area: area.getBoundingClientRect().left, colors: box("pre[aria-hidden] code").left, scrolled: area.scrollLeft };
    return [first, letter.getBoundingClientRect().toJSON(), box(".text").toJSON(), box(".said").bottom, box(".controls").top, box(".said").height];
}

const PASTED = ["[".repeat(1 << 20), `fn f() { ${"-".repeat(90000)}`, "\0", "fn <img src=x onerror=alert(1)>() {}",
    "use common::rtweekend::*; pub fn picture(width: u32) -> Picture { picture(width) }"];
inBrowsers("whatever is pasted is answered, and the page lives", async (page) => {
    await begin(page, "hittable_list.html");
    for (const pasted of PASTED) {
        await page.$eval(AREA, (area, pasted) => {
            area.value = pasted;
            area.dispatchEvent(new Event("input"));
        }, pasted);
        assert.match(await answer(page), /\w/, pasted.slice(0, 40));
    }
    assert.equal(await page.$(".typing :is(.verdict, .rest) img"), null);
});

async function begin(page, place) {
    await open(page, place);
    await page.$eval(".listing .tools button", (button) => button.click());
    await page.waitForSelector(".typing");
    return answer(page);
}

// Types one text in the place of another, key by key.
async function typeOver(page, old, typed) {
    await page.$eval(AREA, (area, old) => {
        const start = area.value.indexOf(old);
        area.focus();
        area.setSelectionRange(start, start + old.length);
    }, old);
    await page.keyboard.type(typed);
    return answer(page);
}

const answer = (page) => said(page, ".typing", "");
