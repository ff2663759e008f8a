// Starts the live figures of a page.

"use strict";

for (const name of modules) {
    instantiate(globalThis[`${name}Module`]).then((rust) => {
        for (const figure of document.querySelectorAll(`[data-module=${name}]`)) {
            new LiveFigure(figure, rust);
        }
    });
}

// Returns the last answer of Rust, which is `length` bytes long and stays until the next call.
function bytes(rust, length) {
    return new Uint8Array(rust.memory.buffer, rust.place(), length);
}

// Returns the last answer of Rust as text.
function read(rust, length) {
    return new TextDecoder().decode(bytes(rust, length));
}
