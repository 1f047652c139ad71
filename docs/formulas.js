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

// In the text a line may end behind a sign between two parts of a formula. These breaks are taken away, where the part isn't
// too long for a phone: inside of brackets, behind a sign of multiplication, and everywhere in a short formula.
const k_short = 10;
const k_held = 28;
const PART = '<span class="base">';
const TIMES = /class="mbin">[⋅×]<\/span>(<span class="mspace"[^>]*><\/span>)?<\/span>$/;

function held(html) {
    const [head, ...parts] = html.split(PART);
    const shown = (part) => part.replace(/<[^>]*>/g, '').replace(/[\s\u200b]/g, '').length;
    const count = (part, what) => part.split(`class="${what}`).length - 1;
    const all = parts.reduce((sum, part) => sum + shown(part), 0);
    let out = head;
    let depth = 0;
    let length = 0; // of what is held together
    const runs = [];
    parts.forEach((part, k) => {
        const joined = k > 0 && (all <= k_short || depth > 0 || TIMES.test(parts[k - 1])) && length + shown(part) <= k_held;
        length = joined ? length + shown(part) : shown(part);
        if (joined) runs[runs.length - 1].push(part);
        else runs.push([part]);
        depth = Math.max(0, depth + count(part, 'mopen') - count(part, 'mclose'));
    });
    const end = '</span></span>'; // of the formula, behind its last part
    runs.forEach((run, k) => {
        const last = k === runs.length - 1;
        const text = run.join('<span class="base on">');
        const inner = last ? text.slice(0, -end.length) : text;
        out += (run.length > 1 ? '<span class="held">' + PART + inner + '</span>' : PART + inner) + (last ? end : '');
    });
    return out;
}

const katex = load();
const rendered = {html: {}, errors: {}};
for (const [key, {tex, display}] of Object.entries(JSON.parse(fs.readFileSync(process.argv[2], 'utf8')))) {
    try {
        const html = katex.renderToString(tex, {displayMode: display, throwOnError: true, strict: 'error'});
        rendered.html[key] = display ? html : held(html);
    } catch (error) {
        rendered.errors[key] = String(error.message).replace(/^KaTeX parse error: /, '');
    }
}
process.stdout.write(JSON.stringify(rendered));
