// Returns the faults in the look of a page at its current width; the function runs in the page.
export function faults() {
    const all = (selector) => [...document.querySelectorAll(selector)].filter((it) => it.checkVisibility());
    const as = (fault) => (element) => `${fault}: ${element.outerHTML.slice(0, 80)}`;

    // Finds elements that stick out to the right, unless they are in a box that scrolls.
    const width = document.documentElement.clientWidth;
    const scrolls = (element) => ["auto", "scroll"].includes(getComputedStyle(element).overflowX);
    const inScrollingBox = ({ parentElement: around }) =>
        around.localName !== "main" && (scrolls(around) || inScrollingBox(around));
    const isOut = (element) => element.getBoundingClientRect().right > width + 0.5 && !inScrollingBox(element);
    const whole = document.documentElement.scrollWidth - width;

    // Finds pictures whose width and height are out of ratio by more than 2 %: a sphere in them is an
    // egg.
    const isEgg = (picture) => {
        const style = getComputedStyle(picture);
        const own = picture.viewBox?.baseVal ?? picture;
        const ratio = parseFloat(style.width) / parseFloat(style.height);
        return Math.abs(ratio * (own.naturalHeight ?? own.height) / (own.naturalWidth ?? own.width) - 1) > 0.02;
    };

    // Finds letters of less than 10 pixels, or 8.5 on the narrowest phone. The picture of a terminal is
    // 740 units wide, with letters of 14.
    const isSmall = (element) => (element.localName === "img" ? 14 / 740 * element.width
        : parseFloat(getComputedStyle(element).fontSize) * element.getScreenCTM().a) < (innerWidth > 320 ? 10 : 8.5);

    // Finds words of a drawing that overlap others. A text has room above and below its letters, which
    // others may share.
    const box = (text) => {
        const { left, right, top, bottom, width, height } = text.getBoundingClientRect();
        // Firefox counts the halo of the letters, too.
        const halo = Math.max(0, width - text.getComputedTextLength() * text.getScreenCTM().a) / 2;
        return { text, left: left + halo, right: right - halo, top: top + 0.2 * height, bottom: bottom - 0.2 * height };
    };
    const meet = (one, other) => one.text !== other.text && one.left < other.right && other.left < one.right
        && one.top < other.bottom && other.top < one.bottom;
    const hidden = all("svg.drawing").flatMap((drawing) => {
        const boxes = [...drawing.querySelectorAll("text")].filter((it) => it.checkVisibility()).map(box);
        return boxes.filter((one) => boxes.some((other) => meet(one, other)));
    });

    return [
        ...whole > 0 ? [`the page scrolls sideways by ${whole} pixels`] : [],
        ...all("main *").filter(isOut).map(as("it sticks out")),
        ...all("main :is(img, canvas, svg[viewBox])").filter(isEgg).map(as("an egg")),
        ...all("svg.drawing text, img[src*=terminal]").filter(isSmall).map(as("small words")),
        ...hidden.map(({ text }) => as("it lies on others")(text)),
    ];
}
