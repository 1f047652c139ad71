// Renders all formulas of the book in one run: node formulas.js WANTED.json > RENDERED.json
// WANTED maps keys to {tex, display}; RENDERED holds the HTML of those that KaTeX reads, and what it says of the others.
'use strict';
const fs = require('fs');
const places = ['/usr/share/javascript/katex/katex.js', '/usr/share/nodejs/katex/katex.js', 'katex'];

function load() {
    for (const place of places) {
        try {
            return require(place);
        } catch (error) {
            if (error.code !== 'MODULE_NOT_FOUND') throw error;
        }
    }
    throw new Error('no KaTeX in ' + places.join(', '));
}

const katex = load();
const rendered = {html: {}, errors: {}};
for (const [key, {tex, display}] of Object.entries(JSON.parse(fs.readFileSync(process.argv[2], 'utf8')))) {
    try {
        rendered.html[key] = katex.renderToString(tex, {displayMode: display, throwOnError: true, strict: 'error'});
    } catch (error) {
        rendered.errors[key] = String(error.message).replace(/^KaTeX parse error: /, '');
    }
}
process.stdout.write(JSON.stringify(rendered));
