// Each element of the page that sticks out to the right, unless it is in a box
// that scrolls: [how far in pixels, tag, text].
(() => {
    const width = document.documentElement.clientWidth;
    const scrolls = (element) => ["auto", "scroll"].includes(getComputedStyle(element).overflowX);
    const inScrollingBox = (element) => {
        const around = element.parentElement;
        return around.localName !== "main" && (scrolls(around) || inScrollingBox(around));
    };
    const outside = [];
    for (const element of document.querySelectorAll("main *")) {
        const right = element.getBoundingClientRect().right;
        if (right > width + 0.5 && !inScrollingBox(element)) {
            outside.push([Math.round(right - width), element.outerHTML.slice(0, 60), element.textContent.trim().slice(0, 40)]);
        }
    }
    const whole = document.documentElement.scrollWidth - width;
    return whole > 0 ? [[whole, "the page", ""], ...outside] : outside;
})()
