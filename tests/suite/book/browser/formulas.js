// What is wrong with the formulas of the page: [what, formula].
(() => {
    const canvas = new OffscreenCanvas(1, 1).getContext("2d");
    const width = (font, text) => {
        canvas.font = `100px ${font}`;
        return canvas.measureText(text).width;
    };
    // A sign that the font lacks is as wide as without the font.
    const lacks = (letter) => ["serif", "monospace"].every(
        (other) => width(`"Notes Math", ${other}`, letter) === width(other, letter));
    const invisible = /[\s\u2061-\u2064]/;

    const wrong = [];
    const parts = { mfrac: 2, mroot: 2, msub: 2, msup: 2, munder: 2, mover: 2, msubsup: 3, munderover: 3 };
    for (const [name, count] of Object.entries(parts)) {
        for (const { childElementCount, parentElement } of document.querySelectorAll(name)) {
            if (childElementCount !== count) {
                wrong.push([`${name} has ${childElementCount} of ${count} parts`, parentElement.textContent]);
            }
        }
    }
    // The box that a formula has to itself: a line of its own, or a field of a table.
    const cut = (formula) => {
        const box = formula.closest(".equation, td, p, li")?.getBoundingClientRect();
        const signs = [...formula.querySelectorAll("mi, mn, mo, mtext, msqrt")]
            .map((sign) => sign.getBoundingClientRect());
        return box && signs.some(({ left, right }) => left < box.left - 1 || right > box.right + 1);
    };
    for (const hat of document.querySelectorAll("mover[accent] > mo")) {
        const { left, right } = hat.previousElementSibling.getBoundingClientRect();
        const own = hat.getBoundingClientRect();
        const middle = (own.left + own.right) / 2;
        if (middle < left || middle > right) {
            wrong.push(["a hat beside its letter", hat.parentElement.textContent]);
        }
    }
    for (const formula of document.querySelectorAll("math")) {
        if (formula.getClientRects().length > 1) {
            wrong.push(["broken inside", formula.textContent]);
        }
        if (cut(formula)) {
            wrong.push(["cut off", formula.textContent]);
        }
        const { width, height } = formula.getBoundingClientRect();
        const size = parseFloat(getComputedStyle(formula).fontSize);
        const around = parseFloat(getComputedStyle(formula.parentElement).fontSize);
        const text = formula.textContent;
        if (width < 4 || height < 8 || height > 400) {
            wrong.push([`${width} × ${height} pixels`, text]);
        }
        if (size < around || size > 1.5 * around) {
            wrong.push([`${size} pixels high in a text of ${around}`, text]);
        }
        const missing = [...new Set(text)].filter((letter) => !invisible.test(letter) && lacks(letter));
        if (missing.length > 0 && !formula.querySelector("mtext")) {
            wrong.push([`the font lacks ${missing.join(" ")}`, text]);
        }
    }
    const loaded = [...document.fonts].some(
        (font) => font.family.includes("Notes Math") && font.status === "loaded");
    if (document.querySelector("math") && !loaded) {
        wrong.push(["the font is not loaded", ""]);
    }
    return wrong;
})()
