// Opens the pages of the woven book in the browsers that are installed, each with one tab.
//
// puppeteer-core brings no browser of its own. It drives Chromium by the protocol of its
// developer tools, and Firefox by WebDriver BiDi.

import assert from "node:assert/strict";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { delimiter, join } from "node:path";
import { after, test } from "node:test";
import { fileURLToPath } from "node:url";

import puppeteer from "puppeteer-core";

export const TARGET = fileURLToPath(new URL("../../target", import.meta.url));
const BOOK = join(TARGET, "book");
assert.ok(existsSync(BOOK), "There is no target/book yet: weave it by `cargo rtrace`.");

// The file names of the book's pages, with the page that stands for a missing one.
export const PAGES = readdirSync(BOOK).filter(
    (name) => name.endsWith(".html") && !["index.html", "print.html", "toc.html"].includes(name));
export const textOf = (name) => readFileSync(join(BOOK, name), "utf8");

const BROWSERS = {
    // The sandbox does not work for root, and only pages of this book are opened.
    Chromium: { browser: "chrome", args: ["--no-sandbox", "--disable-gpu"],
        executablePath: find("CHROMIUM", ["chromium", "chromium-browser", "google-chrome"]) },
    Firefox: { browser: "firefox", executablePath: find("FIREFOX", ["firefox", "firefox-esr"]) },
};

// Returns the path of a program: from the environment variable, or by one of its names on PATH.
function find(variable, names) {
    const folders = process.env.PATH.split(delimiter);
    const places = folders.flatMap((folder) => names.map((name) => join(folder, name)));
    return process.env[variable] ?? places.find(existsSync);
}

// Registers a test for each of these browsers; `look` gets a page. A browser that is not installed is
// reported as skipped.
export function inBrowsers(sentence, look, names = Object.keys(BROWSERS)) {
    for (const name of names) {
        const browser = BROWSERS[name];
        const skip = !browser.executablePath && `LEFT OUT: there is no ${name}`;
        test(`${sentence} (${name})`, { skip, timeout: 300_000 }, async () => {
            browser.page ??= await start(browser);
            await look(browser.page);
        });
    }
}

after(() => Promise.all(Object.values(BROWSERS).map(({ page }) => page?.browser().close())));

const complaints = [];

async function start(options) {
    const browser = await puppeteer.launch(options);
    const [page] = await browser.pages();
    const isOwn = (request) => /^(file|data|about|blob):/.test(request.url());
    // Firefox draws a page before it has read all of it, and then misses parts of a formula.
    const isHalf = ({ message }) => message.startsWith("Invalid markup: Incorrect number of children for <m");
    page.on("console", (said) => ["error", "warn"].includes(said.type()) && complaints.push(said.text()));
    page.on("pageerror", (error) => isHalf(error) || complaints.push(error.message));
    page.on("requestfailed", (request) => complaints.push(`${request.url()} is missing`));
    page.on("request", (request) => isOwn(request) || complaints.push(`${request.url()} is asked for`));
    return page;
}

// Returns and forgets the browser's complaints since a page was opened, and each request that left it.
export const complaintsSoFar = () => complaints.splice(0);

// Opens a page of the book, `place` with its query or fragment, and waits until it is drawn.
export async function open(page, place, width = 1200) {
    // A browser would not load the page anew if only the fragment differs.
    await page.goto("about:blank");
    await page.setViewport({ width, height: 800 });
    complaintsSoFar();
    await page.goto(`file://${BOOK}/${place}`);
    await page.evaluate(() => document.fonts.ready.then(() => null));
    await nextFrame(page);
}

// Waits until the page has been drawn once more.
export const nextFrame = (page) => page.evaluate(() => new Promise((done) =>
    requestAnimationFrame(() => requestAnimationFrame(() => done()))));

// Brings the first live figure near the screen, and waits until all of them can be moved and are
// drawn.
export async function alive(page) {
    await page.evaluate(() => document.querySelector("figure.live")?.scrollIntoView());
    await page.waitForFunction(() => !document.querySelector(
        "figure.live:not(.alive), figure.live:has(.sentence[aria-busy=true])"));
}

// Waits until the verdict in a box names `name`; returns the headline and the rest as text.
export async function said(page, box, name) {
    await page.waitForFunction((box, name) => box.ariaBusy === "false"
        && box.querySelector(".verdict").textContent.includes(name), {}, await page.$(box), name);
    return page.$$eval(`${box} :is(.verdict, .rest)`, (parts) => parts.map((it) => it.textContent).join("\n"));
}
