// Functions that run in a page, and list what is wrong with it.

// Each element that sticks out to the right, unless it is in a box that scrolls.
export function overflow() {
    const width = document.documentElement.clientWidth;
    const scrolls = (element) => ["auto", "scroll"].includes(getComputedStyle(element).overflowX);
    const inScrollingBox = ({ parentElement: around }) =>
        around.localName !== "main" && (scrolls(around) || inScrollingBox(around));
    const isOut = (element) => element.getBoundingClientRect().right > width + 0.5 && !inScrollingBox(element);
    const wrong = [...document.querySelectorAll("main *")].filter(isOut)
        .map((element) => `it sticks out: ${element.outerHTML.slice(0, 80)}`);
    const whole = document.documentElement.scrollWidth - width;
    return whole > 0 ? [`the page scrolls sideways by ${whole} pixels`, ...wrong] : wrong;
}

// Pictures whose width and height are not in the ratio of their own, but for 2 %: a sphere in
// them is an egg.
export function eggs() {
    return [...document.querySelectorAll("main :is(img, canvas, svg[viewBox])")].flatMap((picture) => {
        const style = getComputedStyle(picture);
        const [width, height] = [style.width, style.height].map(parseFloat);
        const own = picture.viewBox?.baseVal ?? picture;
        const [ownWidth, ownHeight] = [own.naturalWidth ?? own.width, own.naturalHeight ?? own.height];
        const isRound = Math.abs(width / height * ownHeight / ownWidth - 1) <= 0.02;
        return isRound || !picture.checkVisibility() ? [] : [
            `an egg, ${width} × ${height} of ${ownWidth} × ${ownHeight}: ${picture.outerHTML.slice(0, 80)}`,
        ];
    });
}

// Drawings and terminals with words of less than ten pixels, or nine on the narrowest phone.
// A terminal's picture is 740 wide with words of 14.
export function smallWords() {
    const least = innerWidth > 320 ? 10 : 8.5;
    const drawings = [...document.querySelectorAll("svg.drawing text")].map((text) =>
        [text, parseFloat(getComputedStyle(text).fontSize) * text.getScreenCTM().a]);
    const terminals = [...document.querySelectorAll("img[src*=terminal]")].map((terminal) =>
        [terminal, 14 / 740 * terminal.width]);
    return [...drawings, ...terminals]
        .filter(([element, size]) => element.checkVisibility() && size < least)
        .map(([element, size]) => `words of ${size} pixels: ${element.outerHTML.slice(0, 80)}`);
}
