// The texts on the page whose contrast with what is behind them is below 4.5, as WCAG 2.2
// measures it. Unlike axe-core, this knows drawings, and is fast enough for each theme.
export function faintTexts() {
    // Red, green, blue from 0 to 255 and alpha from 0 to 1. What was mixed comes as color(srgb …).
    const rgba = (color) => {
        const [r, g, b, a = 1] = color.match(/[\d.]+/g).map(Number);
        return color.startsWith("rgb") ? [r, g, b, a] : [255 * r, 255 * g, 255 * b, a];
    };
    const over = ([r, g, b, a], below) => [r, g, b].map((level, i) => a * level + (1 - a) * below[i]);

    // What is behind an element: the grounds of all around it, one over the other.
    const ground = (element) => {
        const below = element.parentElement ? ground(element.parentElement) : [255, 255, 255];
        return over(rgba(getComputedStyle(element).backgroundColor), below);
    };
    const opacity = (element) =>
        element ? getComputedStyle(element).opacity * opacity(element.parentElement) : 1;

    // What is behind a text in a drawing: the shapes that were drawn there before it, and a halo.
    const groundInDrawing = (text) => {
        const { x, y, width, height } = text.getBoundingClientRect();
        const middle = new DOMPoint(x + width / 2, y + height / 2);
        let behind = ground(text);
        for (const shape of text.ownerSVGElement.querySelectorAll("rect, circle, ellipse, path, polygon")) {
            const { fill, fillOpacity } = getComputedStyle(shape);
            const isBefore = shape.compareDocumentPosition(text) & Node.DOCUMENT_POSITION_FOLLOWING;
            const isFilled = fill !== "none" && !fill.startsWith("url");
            const place = middle.matrixTransform(shape.getScreenCTM().inverse());
            if (isBefore && isFilled && shape.isPointInFill(place)) {
                const [r, g, b, a] = rgba(fill);
                behind = over([r, g, b, a * fillOpacity], behind);
            }
        }
        const { paintOrder, stroke } = getComputedStyle(text);
        return paintOrder.startsWith("stroke") && stroke !== "none" ? over(rgba(stroke), behind) : behind;
    };

    const luminance = (color) => {
        const [r, g, b] = color.map((level) => level / 255)
            .map((part) => part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4);
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    // The ratio, and what was measured.
    const contrast = (element) => {
        const text = element.closest("svg text");
        const { color, fill } = getComputedStyle(element);
        const [r, g, b, a] = rgba(text ? fill : color);
        const behind = text ? groundInDrawing(text) : ground(element);
        const ink = over([r, g, b, a * opacity(element)], behind);
        const [darker, lighter] = [ink, behind].map(luminance).sort((one, other) => one - other);
        return { ratio: (lighter + 0.05) / (darker + 0.05), ink, behind };
    };

    const hasWords = (element) => [...element.childNodes].some(
        (node) => node.nodeType === Node.TEXT_NODE && node.data.trim());
    return [...document.body.querySelectorAll(":not(script, style, noscript, template, title, desc)")]
        .filter((element) => hasWords(element) && element.checkVisibility({ visibilityProperty: true }))
        .map((element) => ({ ...contrast(element), words: element.textContent.trim().slice(0, 40) }))
        .filter(({ ratio }) => ratio < 4.5)
        .map(({ ratio, ink, behind, words }) => `contrast ${ratio.toFixed(2)}, rgb(${ink}) on rgb(${behind}): ${words}`);
}
