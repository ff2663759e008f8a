// Starts the live figures of a page.

"use strict";

for (const name of modules) {
    instantiate(globalThis[`${name}Module`]).then((rust) => {
        for (const figure of document.querySelectorAll(`[data-module=${name}]`)) {
            new LiveFigure(figure, rust);
        }
    });
}

// Returns the functions of a WebAssembly module. The module is a text, base64 of gzip, because a page
// that is opened from a file may load nothing but scripts.
async function instantiate(base64) {
    const compressed = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const module = new Blob([compressed]).stream().pipeThrough(new DecompressionStream("gzip"));
    const headers = { "Content-Type": "application/wasm" };
    const { instance } = await WebAssembly.instantiateStreaming(new Response(module, { headers }));
    return instance.exports;
}

// Returns the last answer of Rust, which is `length` bytes long and stays until the next call.
function bytes(rust, length) {
    return new Uint8Array(rust.memory.buffer, rust.place(), length);
}

// Returns the last answer of Rust as text.
function read(rust, length) {
    return new TextDecoder().decode(bytes(rust, length));
}
