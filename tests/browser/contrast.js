// Returns the texts on the page whose contrast with their background is below 4.5, as WCAG 2.2
// measures it. Unlike axe-core, this function knows drawings, and is fast enough for each theme.
export function faintTexts() {
    const dot = new OffscreenCanvas(1, 1).getContext("2d", { willReadFrequently: true });
    // Returns the luminance of layers, each a color with an opacity, one over the other.
    const luminance = (layers) => {
        for (const [color, opacity] of [["white", 1], ...layers]) {
            dot.globalAlpha = opacity;
            dot.fillStyle = color;
            dot.fillRect(0, 0, 1, 1);
        }
        const [r, g, b] = [...dot.getImageData(0, 0, 1, 1).data].map((level) => level / 255)
            .map((part) => part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4);
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const around = (element) => element ? [...around(element.parentElement), element] : [];
    const styles = (element) => around(element).map((it) => getComputedStyle(it));

    // Returns the shapes behind a text of a drawing, and its halo.
    const behind = (text) => {
        const { x, y, width, height } = text.getBoundingClientRect();
        const middle = new DOMPoint(x + width / 2, y + height / 2);
        const shapes = [...text.ownerSVGElement.querySelectorAll("rect, circle, ellipse, path, polygon")]
            .filter((shape) => shape.compareDocumentPosition(text) & Node.DOCUMENT_POSITION_FOLLOWING)
            .filter((shape) => shape.isPointInFill(middle.matrixTransform(shape.getScreenCTM().inverse())))
            .map((shape) => [getComputedStyle(shape).fill, getComputedStyle(shape).fillOpacity])
            .filter(([fill]) => fill !== "none" && !fill.startsWith("url"));
        const { paintOrder, stroke } = getComputedStyle(text);
        return paintOrder.startsWith("stroke") && stroke !== "none" ? [...shapes, [stroke, 1]] : shapes;
    };

    const contrast = (element) => {
        const text = element.closest("svg text");
        const { color, fill } = getComputedStyle(element);
        const grounds = styles(element).map((style) => [style.backgroundColor, 1]);
        const opacity = styles(element).reduce((product, style) => product * style.opacity, 1);
        const ground = text ? [...grounds, ...behind(text)] : grounds;
        const seenAs = [ground, [...ground, [text ? fill : color, opacity]]];
        const [darker, lighter] = seenAs.map(luminance).sort((one, other) => one - other);
        return (lighter + 0.05) / (darker + 0.05);
    };

    const hasWords = (element) => [...element.childNodes].some(
        (node) => node.nodeType === Node.TEXT_NODE && node.data.trim());
    return [...document.body.querySelectorAll(":not(script, style, noscript, template, title, desc)")]
        .filter((element) => hasWords(element) && element.checkVisibility({ visibilityProperty: true }))
        .map((element) => [contrast(element), element.outerHTML.slice(0, 80)])
        .filter(([ratio]) => ratio < 4.5)
        .map(([ratio, element]) => `contrast ${ratio.toFixed(2)}: ${element}`);
}
