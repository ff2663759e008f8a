// What axe-core finds on the page, which was loaded before: [rule, element, elements].
// Contrast is looked at by contrast.js, which knows drawings too. Style sheets can't be
// loaded once more by a page from a file: the browser would complain.
axe.run(document, { preload: false, resultTypes: ["violations"], rules: { "color-contrast": { enabled: false } } })
    .then(({ violations }) => violations.map(
        ({ id, nodes }) => [id, nodes[0].target.join(" "), nodes.length]))
