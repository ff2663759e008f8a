// Each text on the page whose contrast with what is behind it is below 4.5, as WCAG
// 2.2 measures it: [ratio, color, ground, text].
(() => {
    const canvas = new OffscreenCanvas(1, 1).getContext("2d", { willReadFrequently: true });
    const known = new Map();

    // Red, green, blue from 0 to 255 and alpha from 0 to 1, however it is written.
    function rgba(color) {
        if (!known.has(color)) {
            canvas.clearRect(0, 0, 1, 1);
            canvas.fillStyle = color;
            canvas.fillRect(0, 0, 1, 1);
            const [r, g, b, a] = canvas.getImageData(0, 0, 1, 1).data;
            known.set(color, [r, g, b, a / 255]);
        }
        return known.get(color);
    }

    function over([r, g, b, a], below) {
        return [r, g, b].map((level, i) => a * level + (1 - a) * below[i]);
    }

    // The same function, that remembers what it said of each element.
    function remembering(ask) {
        const said = new Map();
        return (element) => {
            if (!said.has(element)) {
                said.set(element, ask(element));
            }
            return said.get(element);
        };
    }

    // What is behind an element: the grounds of all around it, one over the other.
    const ground = remembering((element) => {
        const below = element.parentElement ? ground(element.parentElement) : [255, 255, 255];
        return over(rgba(getComputedStyle(element).backgroundColor), below);
    });

    function luminance(color) {
        const [r, g, b] = color.map((level) => {
            const part = level / 255;
            return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
        });
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    }

    const opacity = remembering((element) => {
        const own = Number(getComputedStyle(element).opacity);
        return element.parentElement ? own * opacity(element.parentElement) : own;
    });

    // The shapes of a drawing, each with its box on the screen.
    const shapes = remembering((drawing) =>
        [...drawing.querySelectorAll("rect, circle, ellipse, path, polygon")].map(
            (shape) => [shape, shape.getBoundingClientRect()]));

    // What is behind a text in a drawing: the shapes that were drawn there before it.
    function shapesBehind(text) {
        const box = text.getBoundingClientRect();
        const middle = new DOMPoint(box.x + box.width / 2, box.y + box.height / 2);
        let behind = ground(text);
        for (const [shape, { left, right, top, bottom }] of shapes(text.ownerSVGElement)) {
            if (middle.x < left || middle.x > right || middle.y < top || middle.y > bottom) {
                continue;
            }
            const { fill, fillOpacity } = getComputedStyle(shape);
            const before = shape.compareDocumentPosition(text) & Node.DOCUMENT_POSITION_FOLLOWING;
            const local = middle.matrixTransform(shape.getScreenCTM().inverse());
            if (before && fill !== "none" && !fill.startsWith("url") && shape.isPointInFill(local)) {
                const [r, g, b, a] = rgba(fill);
                behind = over([r, g, b, a * Number(fillOpacity)], behind);
            }
        }
        return behind;
    }

    function colors(element) {
        const style = getComputedStyle(element);
        const text = element.closest("text");
        if (!text) {
            return [rgba(style.color), ground(element)];
        }
        const halo = style.paintOrder.startsWith("stroke") && style.stroke !== "none";
        const behind = shapesBehind(text);
        return [rgba(style.fill), halo ? over(rgba(style.stroke), behind) : behind];
    }

    const faint = [];
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
        const element = node.parentElement;
        const text = node.data.trim();
        const hidden = element.closest("script, style, noscript, template, title, desc");
        if (!text || hidden || !element.checkVisibility({ visibilityProperty: true })) {
            continue;
        }
        const [ink, behind] = colors(element);
        const seen = over([...ink.slice(0, 3), ink[3] * opacity(element)], behind);
        const [darker, lighter] = [seen, behind].map(luminance).sort((a, b) => a - b);
        const ratio = (lighter + 0.05) / (darker + 0.05);
        if (ratio < 4.5) {
            faint.push([ratio.toFixed(2), `rgb(${seen.map(Math.round)})`, `rgb(${behind.map(Math.round)})`, text.slice(0, 40)]);
        }
    }
    return faint;
})()
