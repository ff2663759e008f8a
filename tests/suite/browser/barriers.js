// What axe-core finds on the page, which was loaded before: [rule, element, elements].
// Contrast is looked at by contrast.js, which knows drawings too.
axe.run(document, { resultTypes: ["violations"], rules: { "color-contrast": { enabled: false } } })
    .then(({ violations }) => violations.map(
        ({ id, nodes }) => [id, nodes[0].target.join(" "), nodes.length]))
