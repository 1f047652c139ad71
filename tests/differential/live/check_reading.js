// The book as a page to read: language, headings, words for pictures, what a screen reader is told, contrast by day and by
// night, the keyboard, widths from telephone to screen, what a page weighs, and a search that finds what a student types.
// A formula that must be moved sideways on a telephone is a fault, too.
//
//   node tests/differential/live/check_reading.js BOOK/html
//
// The last line says how many pages were read and how many faults were found.
'use strict';

const fs = require('node:fs');
const path = require('node:path');
const zlib = require('node:zlib');
const { Browser } = require('../../../docs/browser.js');

const html = path.resolve(process.argv[2]);
const faults = [];
function complain(place, what) { faults.push(`${place}: ${what}`); }

// Runs in the page; returns what is wrong with it
function inspect() {
    const found = [];
    const say = (what, element) => found.push(`${what}: ${element.outerHTML.slice(0, 110).replace(/\s+/g, ' ')}`);
    const shown = (element) => element.checkVisibility({ opacityProperty: true, visibilityProperty: true }) && element.getClientRects().length > 0;
    const nameOf = (element) => (element.getAttribute('aria-label') || element.textContent || element.getAttribute('title') || '').trim() ||
        [...element.querySelectorAll('img[alt]')].map((image) => image.alt).join(' ');
    if (!/^en/.test(document.documentElement.lang)) found.push('no language');
    if (!document.title.trim()) found.push('no title');
    if (document.querySelectorAll('main, [role=main]').length !== 1) found.push('not one main');

    const headings = [...document.querySelectorAll('h1, h2, h3, h4, h5, h6, [role=heading]')];
    const levelOf = (heading) => Number(heading.getAttribute('aria-level') || heading.tagName[1]);
    if (headings.filter((heading) => levelOf(heading) === 1).length !== 1) found.push('not one h1');
    let level = 0;
    for (const heading of headings) {
        const own = levelOf(heading);
        if (own > level + 1) say(`a heading h${own} below h${level}`, heading);
        if (!heading.textContent.trim()) say('an empty heading', heading);
        level = own;
    }

    // Doxygen lays its pages out by tables, with signs that mean nothing beside their words
    const isManual = !document.querySelector('main');
    const ids = new Set();
    for (const element of document.querySelectorAll('main [id], nav [id], header [id]')) {
        if (ids.has(element.id)) say('an id for the second time', element);
        ids.add(element.id);
    }
    for (const image of document.querySelectorAll('img')) if (!isManual && !(image.alt || '').trim()) say('a picture without words', image);
    for (const canvas of document.querySelectorAll('canvas'))
        if (!canvas.getAttribute('aria-label') && !canvas.getAttribute('aria-hidden')) say('a canvas without words', canvas);
    for (const figure of document.querySelectorAll('figure.picture')) {
        const words = (figure.querySelector('img').alt || '').trim();
        const caption = figure.querySelector('figcaption');
        if (!/^Figure (\d+|[A-Z])\.\d+\./.test(caption.textContent)) say('a figure without a number', caption);
        if (words.length < 10) say('a figure without words', figure);
    }
    for (const element of document.querySelectorAll('a[href], button, summary')) if (shown(element) && !nameOf(element)) say('nothing to call it by', element);
    for (const element of document.querySelectorAll('input, select, textarea')) {
        const named = element.getAttribute('aria-label') || element.closest('label') || (element.id && document.querySelector(`label[for="${element.id}"]`));
        if (!named) say('a control without a name', element);
    }
    for (const element of document.querySelectorAll('[aria-controls], [aria-labelledby], [aria-describedby]'))
        for (const name of ['aria-controls', 'aria-labelledby', 'aria-describedby'])
            for (const id of (element.getAttribute(name) || '').split(/\s+/))
                if (id && !document.getElementById(id)) say(`${name} leads to no element`, element);
    if (/user-scalable *= *no|maximum-scale/.test(document.querySelector('meta[name=viewport]')?.content || '')) found.push('a page that can not be enlarged');
    for (const element of document.querySelectorAll('main li')) if (!/^(UL|OL|MENU)$/.test(element.parentElement.tagName)) say('a point of no list', element);
    for (const element of document.querySelectorAll('[tabindex]')) if (element.tabIndex > 0) say('a tabindex that jumps', element);
    for (const element of document.querySelectorAll('[onclick]')) if (element.tabIndex < 0) say('out of the keyboard’s reach', element);
    for (const link of document.querySelectorAll('main p a[href], main li a[href]')) {
        const beside = [...link.parentElement.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && /\w/.test(node.data));
        if (beside && shown(link) && getComputedStyle(link).textDecorationLine === 'none') say('a link that only its colour tells from the text', link);
    }
    for (const table of document.querySelectorAll('table')) if (!isManual && !table.querySelector('th')) say('a table without heads', table);
    for (const head of document.querySelectorAll('th')) if (!nameOf(head)) say('an empty head of a table', head.parentElement);
    for (const image of document.querySelectorAll('[role=img]')) if (image.querySelector('a, button')) say('links in what is a picture by its role', image);
    for (const element of document.querySelectorAll('main pre, main table, .sheet, div.fragment')) {
        const moves = /auto|scroll/.test(getComputedStyle(element).overflowX) && element.scrollWidth > element.clientWidth + 1;
        if (moves && shown(element) && element.tabIndex < 0 && !element.querySelector('a, button')) say('only a pointer can move it', element);
    }

    // Contrast of text with the ground under it: 4.5, for large letters 3
    const canvas = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
    const known = new Map();
    const colour = (text) => {
        if (!known.has(text)) {
            canvas.clearRect(0, 0, 1, 1);
            canvas.fillStyle = text;
            canvas.fillRect(0, 0, 1, 1);
            const [r, g, b, a] = canvas.getImageData(0, 0, 1, 1).data;
            known.set(text, [r, g, b, a / 255]);
        }
        return known.get(text);
    };
    const over = (a, b) => [0, 1, 2].map((k) => a[k] * a[3] + b[k] * (1 - a[3])).concat(1);
    const ground = (element) => {
        const layers = [];
        for (let at = element; at; at = at.parentElement) layers.push(colour(getComputedStyle(at).backgroundColor));
        return layers.reverse().reduce((below, layer) => over(layer, below), [255, 255, 255, 1]);
    };
    const light = (c) => [0, 1, 2].map((k) => c[k] / 255).map((v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4))
        .reduce((sum, v, k) => sum + v * [0.2126, 0.7152, 0.0722][k], 0);
    const pale = new Set();
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    const seen = new Set();
    while (walker.nextNode()) {
        const element = walker.currentNode.parentElement;
        if (!walker.currentNode.data.trim() || seen.has(element) || !shown(element) || element.closest('script, style, noscript, .katex-mathml')) continue;
        seen.add(element);
        const style = getComputedStyle(element);
        const size = parseFloat(style.fontSize);
        const below = ground(element);
        const [a, b] = [light(over(colour(element.closest('svg') ? style.fill : style.color), below)), light(below)];
        const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
        // The signs of a legend are pictures, not letters
        const enough = element.classList.contains('sign') || size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700) ? 3 : 4.5;
        if (ratio < enough) pale.add(`contrast ${ratio.toFixed(2)} of <${element.tagName.toLowerCase()} class="${element.getAttribute('class') || ''}"> in ${element.parentElement.tagName.toLowerCase()}`);
    }
    return [...found, ...pale];
}

// What the browser tells a screen reader: everything that is named in speech has a name, and nothing that can be pressed holds
// something else that can
const SPOKEN = new Set(['button', 'canvas', 'checkbox', 'combobox', 'dialog', 'heading', 'image', 'link', 'listbox', 'menuitem', 'radio', 'searchbox', 'slider',
    'spinbutton', 'switch', 'tab', 'textbox']);
const PRESSED = new Set(['button', 'checkbox', 'combobox', 'link', 'radio', 'searchbox', 'slider', 'spinbutton', 'textbox']);
async function listen(browser) {
    const { nodes } = await browser.send('Accessibility.getFullAXTree');
    const known = new Map(nodes.map((node) => [node.nodeId, node]));
    const roleOf = (node) => (node.ignored ? '' : node.role.value.toLowerCase());
    const found = [];
    const say = async (what, node) => {
        const { outerHTML } = await browser.send('DOM.getOuterHTML', { backendNodeId: node.backendDOMNodeId }).catch(() => ({ outerHTML: '' }));
        found.push(`${what}: ${outerHTML.slice(0, 110).replace(/\s+/g, ' ')}`);
    };
    const nameOf = (node) => (node.name?.value || '').trim();
    for (const node of nodes) {
        const role = roleOf(node);
        let above = known.get(node.parentId);
        while (above && !PRESSED.has(roleOf(above))) above = known.get(above.parentId);
        // A sign on a button with a name only adorns it
        if (SPOKEN.has(role) && !nameOf(node) && !(role === 'image' && above && nameOf(above))) await say(`a ${role} without a name`, node);
        if (PRESSED.has(role) && above) await say(`a ${role} within a ${roleOf(above)}`, node);
    }
    return found;
}

// What a page loads, its pictures included, as a server sends it: text packed by gzip, the rest as it is. Half of the bound is
// the engine: whoever makes a page heavier than the heaviest is today should know it. [kB]
const HEAVIEST = 470;
const packed = new Map();
async function weigh(browser) {
    const pictures = await browser.ask('[...document.images].map((image) => image.src)');
    let sum = 0;
    for (const address of new Set([...browser.loaded, ...pictures.map((one) => one.replace(/[?#].*/, ''))])) {
        if (!address.startsWith('file://')) continue;
        if (!packed.has(address)) {
            const bytes = fs.readFileSync(decodeURIComponent(address.slice(7)));
            packed.set(address, /\.(woff2|png)$/.test(address) ? bytes.length : zlib.gzipSync(bytes).length);
        }
        sum += packed.get(address) / 1000;
    }
    return Math.round(sum);
}

const LONG_FORMULAS = `document.fonts.ready.then(() => [...document.querySelectorAll('.formula .sheet')]
    .filter((sheet) => sheet.scrollWidth > sheet.clientWidth + 1).map((sheet) => sheet.closest('[id]')?.id || sheet.textContent.slice(0, 60)))`;

// Letters in pictures, which are drawn as shapes: their contrast with the page by day, and by night, when the page turns the light
// of a picture over (figure.picture img in book.css). White ones lie on discs.
function checkPictures() {
    const light = (c) => c.map((v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)).reduce((sum, v, k) => sum + v * [0.2126, 0.7152, 0.0722][k], 0);
    const ratio = (a, b) => (Math.max(light(a), light(b)) + 0.05) / (Math.min(light(a), light(b)) + 0.05);
    const turned = ([r, g, b]) => {
        const [x, y, z] = [r, g, b].map((v) => 0.88 - 0.76 * v);
        const grey = 2 * (0.213 * x + 0.715 * y + 0.072 * z);
        return [grey - x, grey - y, grey - z].map((v) => Math.min(1, Math.max(0, v)));
    };
    let count = 0;
    for (const folder of fs.readdirSync(path.join(html, 'figures')))
        for (const file of fs.readdirSync(path.join(html, 'figures', folder)).filter((name) => name.endsWith('.svg'))) {
            ++count;
            const pale = new Set();
            const svg = fs.readFileSync(path.join(html, 'figures', folder, file), 'utf8');
            for (const [, r, g, b, cover] of svg.matchAll(/<g style="fill:rgb\(([\d.]+)%,([\d.]+)%,([\d.]+)%\);fill-opacity:([\d.]+);">\s*<use /g)) {
                const ink = [r, g, b].map((v) => (v / 100) * cover + 1 - cover);
                const [day, night] = [ratio(ink, [1, 1, 1]), ratio(turned(ink), [0x16 / 255, 0x19 / 255, 0x1d / 255])];
                if (light(ink) < 0.99 && Math.min(day, night) < 4.5) pale.add(`letters of contrast ${day.toFixed(2)} by day, ${night.toFixed(2)} by night`);
            }
            for (const fault of pale) complain(`figures/${folder}/${file}`, fault);
        }
    return count;
}

// What students type, and where it must lead: one of the first three places that aren't the glossary's
const WORDS = [
    ['restitution', /chapter_18|Material/], ['inertia', /chapter_0[234]/], ['moment of inertia', /chapter_0[234]/], ['parallel axes', /chapter_02/],
    ['impulse', /chapter_07/], ['friction', /chapter_(07|11)/], ['heap', /chapter_17/], ['coulomb', /chapter_(07|11)/], ['momentum', /chapter_/], ['energy', /chapter_/],
    ['separating axis', /chapter_05/], ['overlap', /chapter_/], ['corner', /chapter_06/], ['convex', /chapter_0[456]/], ['normal', /chapter_0[5-7]/],
    ['time of impact', /chapter_08/], ['quadratic', /chapter_18/], ['newton', /chapter_/], ['grid', /chapter_09/], ['sweep', /chapter_(09|11|17)/],
    ['zeno', /chapter_1[01]/], ['event queue', /chapter_10|EventQueue/], ['pi', /chapter_/], ['stack', /chapter_11/], ['complementarity', /chapter_11/],
    ['sleep', /chapter_1[127]/], ['kepler', /chapter_16/], ['euler', /chapter_01/], ['verlet', /chapter_01/], ['centre of mass', /chapter_0[24]/],
    ['rounding', /chapter_/], ['Polygon', /./], ['(8.4)', /chapter_07.html#eq/], ['exercise 5.1', /chapter_04/], ['playground', /playground/],
    // Words of other books
    ['torque', /chapter_02/], ['tunnelling', /chapter_08/], ['continuous collision detection', /chapter_08/], ['SAT', /chapter_05/], ['penetration', /chapter_05/],
    ['broad phase', /chapter_09/], ['narrow phase', /chapter_09/], ['spatial hash', /chapter_09/], ['bounding box', /chapter_09/], ['priority queue', /chapter_10/],
    ['event-driven', /chapter_10/], ['chaos', /chapter_10/], ['ideal gas', /chapter_10/], ['union-find', /chapter_17/], ['LCP', /chapter_11/], ['Gauss-Seidel', /chapter_11/],
    ['coefficient of friction', /chapter_07/], ['coefficient of restitution', /chapter_18/], ['conservation of momentum', /chapter_(07|18)/], ["Newton's cradle", /chapter_07/],
    ['cancellation', /chapter_(18|02|03)/], ['shoelace formula', /chapter_04/], ['centroid', /chapter_04/], ['ear clipping', /chapter_06/], ['leapfrog', /chapter_01/],
    ['Runge-Kutta', /chapter_01/], ['deterministic', /chapter_01/], ['orbit', /chapter_(01|16)/], ['snapshot', /chapter_13/], ['warm start', /chapter_1[17]/],
];

// What must lead to its place at once: it is first or second of all that is found
const FIRST = [
    ['torque', /chapter_02/], ['friction', /chapter_07.html#friction/], ['bounce', /chapter_18/], ['spin', /chapter_02/], ['pile', /chapter_17/], ['sleep', /chapter_17/],
    ['restitution', /chapter_18/], ['quadtree', /chapter_09/], ['coefficient', /chapter_18/], ['moment of inertia', /chapter_02/], ['collision', /chapter_18/],
    ['gravity', /chapter_01/], ['SAT', /chapter_05/], ['TOI', /chapter_08/], ['stack', /chapter_11/], ['jitter', /chapter_11.html#where-it-breaks/],
    ['tunneling', /chapter_08/], ['python', /manual.index/], ['install', /manual.index/], ['exercise', /#exercises/], ['contact', /chapter_(05|06|11)/],
    ['impulse', /chapter_07/], ['Zeno', /chapter_11/], ['integrator', /chapter_13/], ['convex', /chapter_06/], ['centroid', /chapter_04/],
    ['energy', /chapter_(17|18)/], ['broad phase', /chapter_09/], ['snapshot', /chapter_13/], ['units', /chapter_01/], ['center of mass', /chapter_04/],
    ['substep', /chapter_11/], ['license', /about.html#licence/], ['cite', /about.html#how-to-cite/], ['projectile', /chapter_01/], ['determinism', /chapter_01/],
    ['inclined plane', /chapter_11/], ['answers', /answers/], ['video', /chapter_13/], ['mass', /chapter_02/],
];

async function checkSearch(browser) {
    await browser.go('file://' + path.join(html, 'chapter_02.html'));
    await browser.until("document.readyState === 'complete'");
    const key = (name, code) => Promise.all(['keyDown', 'keyUp'].map((type) => browser.send('Input.dispatchKeyEvent', { type, key: name, code, text: type === 'keyDown' && name.length === 1 ? name : undefined })));
    await key('/', 'Slash');
    if (!(await browser.until('window.flyingIndex && window.FlyingSearch && document.querySelector("dialog.search[open] input") === document.activeElement', 15000))) {
        complain('search', 'does not open by its key');
        return 0;
    }
    let good = 0;
    for (const [word, where] of WORDS) {
        const found = await browser.ask(`FlyingSearch.find(flyingIndex, ${JSON.stringify(word)}, 9).map((one) => one.address)`);
        const places = found.filter((place) => !place.startsWith('glossary')).slice(0, 3);
        if (places.some((place) => where.test(place))) ++good;
        else complain('search', `"${word}" leads to ${places.join(', ') || 'nothing'}; expected ${where}`);
    }

    for (const [word, where] of FIRST) {
        const places = await browser.ask(`FlyingSearch.find(flyingIndex, ${JSON.stringify(word)}, 2).map((one) => one.address)`);
        if (places.some((place) => where.test(place))) ++good;
        else complain('search', `"${word}" leads to ${places.join(', ') || 'nothing'} at once; expected ${where}`);
    }

    // A word of the glossary leads to its line, and to where it is taught
    const terms = await browser.ask(`flyingIndex.filter((one) => one[2].startsWith('glossary.html#')).map((one) => [one[0], one[2]])`);
    if (terms.length < 60) complain('search', `knows ${terms.length} words of the glossary`);
    for (const [term, line] of [...terms, ['angular velocity', 'glossary.html#term-spin']]) {
        const places = await browser.ask(`FlyingSearch.find(flyingIndex, ${JSON.stringify(term)}, 4).map((one) => one.address)`);
        if (!places.includes(line)) complain('search', `"${term}" leads to ${places.join(', ') || 'nothing'}; expected ${line}`);
        if (!places.some((place) => /^chapter_/.test(place))) complain('search', `"${term}" leads to no chapter: ${places.join(', ')}`);
    }
    await browser.go('file://' + path.join(html, 'glossary.html'));
    await browser.until("document.readyState === 'complete'");
    const missing = await browser.ask(`${JSON.stringify(terms)}.filter(([, line]) => !document.getElementById(line.split('#')[1]))`);
    for (const [term] of missing) complain('glossary.html', `has no line for ${term}`);
    const index = fs.readFileSync(path.join(html, 'terms.html'), 'utf8');
    for (const [term, line] of terms) if (!index.includes(`href="${line}"`)) complain('terms.html', `has no place for ${term}`);
    await browser.go('file://' + path.join(html, 'chapter_02.html'));
    await browser.until("document.readyState === 'complete'");
    await key('/', 'Slash');
    await browser.until('document.querySelector("dialog.search[open] input") === document.activeElement', 15000);

    await browser.send('Input.insertText', { text: 'parallel axes' });
    if (!(await browser.until("document.querySelectorAll('dialog.search li a').length > 0", 5000))) complain('search', 'lists nothing');
    await key('Enter', 'Enter');
    if (!(await browser.until("location.href.includes('#') || !location.href.includes('chapter_02')", 5000))) complain('search', 'goes nowhere');
    return good;
}

// Every stop of the tabulator shows where it is, on a page of each kind
async function checkKeyboard(browser, page, kinds) {
    await browser.size(1280, 900);
    await browser.go('file://' + path.join(html, page));
    await browser.until("document.readyState === 'complete'");
    await browser.until("!document.querySelector('figure.live') || document.documentElement.dataset.live === 'ready'");
    const tab = () => Promise.all(['keyDown', 'keyUp'].map((type) => browser.send('Input.dispatchKeyEvent', { type, key: 'Tab', code: 'Tab', windowsVirtualKeyCode: 9 })));
    await tab();
    if (!(await browser.ask("document.activeElement.classList.contains('skip')"))) complain(page, 'the first stop of the keyboard is not the way to the text');
    const reached = new Set();
    for (let k = 0; k < 400; ++k) {
        await tab();
        const name = await browser.ask(`(() => {
            const at = document.activeElement;
            if (at === document.body) return '';
            const style = getComputedStyle(at);
            return at.tagName + (style.outlineStyle === 'none' ? ' without outline ' + at.outerHTML.slice(0, 80) : '');
        })()`);
        if (!name) break;
        reached.add(name);
    }
    for (const name of reached) if (name.includes('without')) complain(page, `no sign of focus on ${name}`);
    for (const kind of kinds) if (!reached.has(kind)) complain(page, `the keyboard never comes to a ${kind.toLowerCase()}`);
}

async function main() {
    const all = fs.readdirSync(html).filter((name) => name.endsWith('.html') && name !== 'print.html');
    const sources = fs.readdirSync(path.join(html, 'manual')).filter((name) => /^(rectangle|geometry_2polygon|one__point|event__queue)_8.pp_source\.html$/.test(name));
    const doxygens = ['index.html', 'classflying_1_1World.html'];
    const pages = [...all, ...[...sources, ...doxygens].map((name) => 'manual/' + name)];
    const browser = new Browser();
    await browser.open();
    let heaviest = [0, ''];
    for (const page of pages) {
        await browser.go('file://' + path.join(html, page));
        for (const [width, shade] of [[1280, 'light'], [1280, 'dark'], [390, 'dark'], [390, 'light']]) {
            await browser.size(width, 900, width < 600);
            await browser.media({ 'prefers-color-scheme': shade });
            await browser.until("document.readyState === 'complete' && document.querySelector('main, [role=main]') !== null");
            const place = `${page}, ${width}, ${shade}`;
            if (width === 390) {
                const wide = await browser.ask('document.documentElement.scrollWidth');
                if (wide > width) complain(place, `${wide} pixels wide`);
                for (const id of await browser.ask(LONG_FORMULAS)) complain(place, `the formula ${id} has to be moved sideways`);
            }
            for (const fault of [...await browser.ask(`(${inspect})()`), ...await listen(browser)]) complain(place, fault);
        }
        await browser.until("!document.querySelector('figure.live') || document.documentElement.dataset.live === 'ready'");
        const weight = await weigh(browser);
        if (weight > heaviest[0]) heaviest = [weight, page];
        if (weight > HEAVIEST) complain(page, `${weight} kB to load, expected ${HEAVIEST} at most`);
    }
    await browser.media({});
    const pictures = checkPictures();
    await checkKeyboard(browser, 'chapter_02.html', ['A', 'BUTTON', 'SUMMARY']);
    await checkKeyboard(browser, 'playground.html', ['A', 'BUTTON', 'SELECT', 'TEXTAREA']);
    await checkKeyboard(browser, 'module_rest.html', ['A', 'BUTTON']);
    const words = await checkSearch(browser);
    await browser.close();
    for (const fault of faults) console.log(fault);
    console.log(`${words} of ${WORDS.length + FIRST.length} words found`);
    console.log(`${pictures} pictures, their letters by day and by night`);
    console.log(`the heaviest page is ${heaviest[1]}: ${heaviest[0]} kB to load, packed`);
    console.log(`${pages.length} pages read, ${faults.length} faults`);
    process.exitCode = faults.length ? 1 : 0;
}

main().catch((error) => {
    console.log(error.stack);
    console.log('0 pages read, 1 faults');
    process.exit(1);
});
