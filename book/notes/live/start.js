// Makes alive what a page has of live figures.

"use strict";

for (const name of modules) {
    instantiate(globalThis[`${name}Module`]).then((rust) => {
        for (const figure of document.querySelectorAll(`[data-module=${name}]`)) {
            new LiveFigure(figure, rust);
        }
    });
}

// The functions of a module, which is base64 of gzip: from a file nothing else is loaded.
async function instantiate(base64) {
    const compressed = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const module = new Blob([compressed]).stream().pipeThrough(new DecompressionStream("gzip"));
    const headers = { "Content-Type": "application/wasm" };
    const { instance } = await WebAssembly.instantiateStreaming(new Response(module, { headers }));
    return instance.exports;
}

// The answer of Rust that is so many bytes long, until the next call.
function bytes(rust, length) {
    return new Uint8Array(rust.memory.buffer, rust.place(), length);
}

// The same as text.
function read(rust, length) {
    return new TextDecoder().decode(bytes(rust, length));
}
