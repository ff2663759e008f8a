// Runs Rust, compiled to WebAssembly, in a worker, so that the page never waits for it.
//
// A page that is opened from a file may not load a worker's script. So the functions below become
// one as text, in a Blob.

"use strict";

// The main function of a worker. `work` makes an object of methods that answer questions, from the
// functions of a WebAssembly module. The first message brings that module, as base64 of gzip.
function serve(work) {
    let rust = null;
    let answers = null;

    // Return the last answer of Rust, which is `length` bytes long and stays until the next call:
    // as bytes, or as text.
    const bytes = (length) => new Uint8Array(rust.memory.buffer, rust.place(), length);
    const text = (length) => new TextDecoder().decode(bytes(length));

    // Writes a question, a text and perhaps bytes, into the memory of Rust. Returns the length of the
    // text in bytes.
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

// Makes the methods that judge pictures.
function judgeMethods(rust, { bytes, text, give }) {
    // Splits the last answer into facts, verdict and rest.
    function parsed(length) {
        const [facts, verdict, ...rest] = text(length).split("\n");
        const [chapter, probe, size, different] = facts.split("\t");
        const [width, height, column, row] = size.split(" ").map(Number);
        return {
            chapter, probe, verdict, rest: rest.join("\n"),
            width, height, first: [column, row], different: Number(different),
        };
    }

    async function judged({ file, most, asked }) {
        const question = [file.name, ...asked].join("\0");
        if (file.size > most) {
            return parsed(rust.too_large(give(question)));
        }
        return parsed(rust.check(give(question, new Uint8Array(await file.arrayBuffer()))));
    }

    // Returns the right picture, the reader's and the difference; null for one that is not there.
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
            const answer = await judged(question);
            return { ...answer, pictures: await pictures(answer) };
        },
        inspect: ({ column, row }) => text(rust.inspect(column, row)),
    };
}

// Starts a worker with this script.
function workerOf(code) {
    const url = URL.createObjectURL(new Blob([code]));
    const worker = new Worker(url);
    URL.revokeObjectURL(url);
    return worker;
}

// A worker that answers questions by methods of `work`. A worker that has crashed or takes too long
// is replaced by a new one, so a hostile file spoils only its own answer.
class RustWorker {
    constructor(work, base64) {
        this.code = `${instantiate}(${serve})(${work})`;
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
        // The next question reports this error.
        this.started.catch(() => {});
    }

    ask(what, question) {
        const id = ++this.last;
        return new Promise((resolve, reject) => {
            this.waiting.set(id, { resolve, reject });
            this.worker.postMessage({ id, what, ...question });
        });
    }

    // Returns the answer, or throws an Error after `patience` milliseconds; the message is "replaced"
    // if another call has replaced the worker meanwhile.
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

// The worker that judges pictures. A question about a new picture ends the work on an old one.
class Judge extends RustWorker {
    static PATIENCE = 60000;

    constructor() {
        super(judgeMethods, judgeModule);
    }

    get choices() {
        return this.started;
    }

    async judge(question) {
        await this.started;
        if (this.waiting.size > 0) {
            this.start();
        }
        return this.within(Judge.PATIENCE, "judge", question);
    }

    inspect(column, row) {
        return this.ask("inspect", { column, row });
    }
}
