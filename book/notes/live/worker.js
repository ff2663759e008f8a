// Rust in a worker, so that the page never waits for it.
//
// From a file no worker is loaded: functions become one as text, in a Blob.

"use strict";

// What a worker is: `work` makes answers of the functions of a module. The first question
// brings that along, as base64 of gzip.
function serve(work) {
    let rust = null;
    let answers = null;

    async function instantiate(base64) {
        const compressed = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
        const module = new Blob([compressed]).stream().pipeThrough(new DecompressionStream("gzip"));
        const headers = { "Content-Type": "application/wasm" };
        const { instance } = await WebAssembly.instantiateStreaming(new Response(module, { headers }));
        return instance.exports;
    }

    // The answer of Rust that is so many bytes long, until the next call; and as text.
    const bytes = (length) => new Uint8Array(rust.memory.buffer, rust.place(), length);
    const text = (length) => new TextDecoder().decode(bytes(length));

    // Puts what Rust is asked about where Rust wants it. Returns the length of the first part.
    function give(question, ...parts) {
        const all = [new TextEncoder().encode(question), ...parts];
        let place = rust.take(all.reduce((sum, part) => sum + part.length, 0));
        for (const part of all) {
            new Uint8Array(rust.memory.buffer).set(part, place);
            place += part.length;
        }
        return all[0].length;
    }

    onmessage = async ({ data }) => {
        try {
            if (!rust) {
                rust = await instantiate(data.base64);
                answers = work(rust, { bytes, text, give });
            }
            postMessage({ id: data.id, answer: await answers[data.what](data) });
        } catch (error) {
            postMessage({ id: data.id, error: String(error) });
        }
    };
}

// The answers of the judge of pictures.
function judging(rust, { bytes, text, give }) {
    // The lines of facts, of the verdict, and of the rest.
    function said(length) {
        const [facts, verdict, ...rest] = text(length).split("\n");
        const [chapter, probe, cause, size, different] = facts.split("\t");
        const [width, height, column, row] = size.split(" ").map(Number);
        return {
            chapter, probe, cause, verdict, rest: rest.join("\n"),
            width, height, first: [column, row], different: Number(different),
        };
    }

    async function judge({ file, most, asked }) {
        const question = [file.name, ...asked].join("\0");
        if (file.size > most) {
            return said(rust.too_large(give(question)));
        }
        const bytes = new Uint8Array(await file.arrayBuffer());
        const answer = said(rust.check(give(question, bytes)));
        // A WebP begins with RIFF. It loses levels in ways that the judge does not know.
        const isWebP = bytes[0] === 0x52 && bytes[1] === 0x49;
        return { ...answer, isForeign: answer.cause === "other-format" && !isWebP };
    }

    // Of a format that Rust does not read: the pixels that the browser has made of it.
    async function judgePixels({ file, asked, pixels: { width, height, data } }) {
        const question = [file.name, ...asked].join("\0");
        const why = new Uint8Array(await file.slice(0, 64).arrayBuffer());
        return said(rust.decoded(give(question, why, data), why.length, width, height));
    }

    // The right picture, the reader's, and the difference; null if there is none.
    async function pictures({ width, height }) {
        const all = [];
        for (const which of [0, 1, 2]) {
            const length = width ? rust.picture(which) : 0;
            const data = length && new ImageData(new Uint8ClampedArray(bytes(length)), width, height);
            all.push(data ? await createImageBitmap(data) : null);
        }
        return all;
    }

    return {
        start: () => text(rust.choices()).split("\n").map((line) => line.split("\t")),
        async judge(question) {
            const answer = await (question.pixels ? judgePixels : judge)(question);
            return { ...answer, pictures: await pictures(answer) };
        },
        inspect: ({ column, row }) => text(rust.inspect(column, row)),
    };
}

// What the browser makes of a picture, with its colors as they are; null if it can't read it.
// It is a worker's whole life: Firefox 140 computes slowly in a thread that has drawn.
function decoding() {
    onmessage = async ({ data: file }) => {
        const options = { colorSpaceConversion: "none", premultiplyAlpha: "none" };
        const bitmap = await createImageBitmap(file, options).catch(() => null);
        // Rust says no to more, and a canvas may not hold it.
        if (!bitmap || bitmap.width * bitmap.height > 2 ** 24) {
            postMessage(null);
            return;
        }
        const { width, height } = bitmap;
        const canvas = new OffscreenCanvas(width, height).getContext("2d");
        canvas.drawImage(bitmap, 0, 0);
        postMessage({ width, height, data: canvas.getImageData(0, 0, width, height).data });
    };
}

// A worker that does what such a function does.
function workerOf(code) {
    const url = URL.createObjectURL(new Blob([code]));
    const worker = new Worker(url);
    URL.revokeObjectURL(url);
    return worker;
}

// Asks a worker. What has trapped or takes too long can't be called again, and is replaced: a
// hostile file has only itself to spoil.
class Asked {
    constructor(work, base64) {
        this.code = `(${serve})(${work})`;
        this.base64 = base64;
        this.start();
    }

    start() {
        this.worker?.terminate();
        this.waiting?.forEach(({ reject }) => reject(new Error("replaced")));
        this.waiting = new Map();
        this.last = 0;
        this.worker = workerOf(this.code);
        this.worker.onmessage = ({ data }) => {
            const { resolve, reject } = this.waiting.get(data.id) ?? {};
            this.waiting.delete(data.id);
            data.error ? reject?.(new Error(data.error)) : resolve?.(data.answer);
        };
        this.started = this.ask("start", { base64: this.base64 });
        // A question that comes later hears of it.
        this.started.catch(() => {});
    }

    ask(what, question) {
        const id = ++this.last;
        return new Promise((resolve, reject) => {
            this.waiting.set(id, { resolve, reject });
            this.worker.postMessage({ id, what, ...question });
        });
    }

    // The answer within so many milliseconds, or an Error: "replaced" if the worker has been
    // replaced meanwhile.
    async within(patience, what, question) {
        await this.started;
        const worker = this.worker;
        const late = setTimeout(() => this.worker === worker && this.fail("it takes too long"), patience);
        try {
            return await this.ask(what, question);
        } catch (error) {
            if (this.worker === worker && error.message !== "replaced") {
                this.start();
            }
            throw error;
        } finally {
            clearTimeout(late);
        }
    }

    fail(why) {
        this.waiting.forEach(({ reject }) => reject(new Error(why)));
        this.waiting.clear();
        this.start();
    }
}

// The judge of pictures. One that is asked for a new picture while judging an old one is
// replaced.
class Judge extends Asked {
    static PATIENCE = 60000;

    constructor() {
        super(judging, judgeModule);
    }

    get choices() {
        return this.started;
    }

    async judge(question) {
        await this.started;
        if (this.waiting.size > 0) {
            this.start();
        }
        const answer = await this.within(Judge.PATIENCE, "judge", question);
        const pixels = answer.isForeign && await pixelsOf(question.file);
        return pixels ? this.within(Judge.PATIENCE, "judge", { ...question, pixels }) : answer;
    }

    inspect(column, row) {
        return this.ask("inspect", { column, row });
    }
}

// The width, the height and the bytes of a picture that the browser reads, or null.
async function pixelsOf(file) {
    const worker = workerOf(`(${decoding})()`);
    try {
        return await new Promise((resolve) => {
            worker.onmessage = ({ data }) => resolve(data);
            worker.onerror = () => resolve(null);
            worker.postMessage(file);
        });
    } finally {
        worker.terminate();
    }
}
