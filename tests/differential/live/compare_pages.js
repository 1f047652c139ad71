// Every live figure of the book in headless Chromium: at the ends of all its controls, the hashes that the page shows must
// be those of the native program; and the page must be in order: no error, no overflow on a telephone, figures that start
// when seen unless the reader wants no motion, recordings where there is no engine.
//
//   node tests/differential/live/compare_pages.js BOOK/html FLYING PIECES
//
// FLYING is the program `flying`, PIECES the program built from pieces.cpp. The last line says how many figures agree.
'use strict';

const { execFileSync } = require('node:child_process');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const { Browser } = require('../../../docs/browser.js');

const [html, flying, pieces] = process.argv.slice(2).map((name) => path.resolve(name));
const work = fs.mkdtempSync(path.join(os.tmpdir(), 'flying-pages-'));
const faults = [];
let hashes = 0;

function complain(place, what) { faults.push(`${place}: ${what}`); }

// The hash of a scene at a moment, by the native program
function nativeHash({ text, engine = 'auto', step, without = [] }, time) {
    const scene = path.join(work, 'scene.toml');
    const report = path.join(work, 'report.json');
    fs.writeFileSync(scene, text);
    const options = ['simulate', scene, '--until', String(time), '--engine', engine, '--report', report, '--quiet'];
    if (step) options.push('--step', String(step));
    for (const name of without) options.push('--without', name);
    execFileSync(flying, options, { stdio: 'ignore' });
    return JSON.parse(fs.readFileSync(report, 'utf8')).hash;
}

function compare(figure) {
    const before = hashes;
    for (const { what, time, fault, run, asks } of figure.cases) {
        const place = `${figure.name}, ${what}`;
        if (fault) complain(place, `a fault: ${fault}`);
        if (run) {
            const expected = nativeHash(run, time);
            ++hashes;
            if (run.hash !== expected) complain(place, `the page's hash ${run.hash}, the program's ${expected}`);
        }
        if (!asks.length) continue;
        const questions = asks.map(({ name, numbers }) => [name, ...numbers].join(' ')).join('\n') + '\n';
        const answers = execFileSync(pieces, { input: questions, encoding: 'utf8' }).trim().split('\n');
        asks.forEach(({ name, hash }, k) => {
            ++hashes;
            if (hash !== answers[k]) complain(place, `${name}: the page's hash ${hash}, the native one ${answers[k]}`);
        });
    }
    if (hashes === before) complain(figure.name, 'nothing to compare');

    // What came of a control: in the picture, in the numbers beside it, or in what the engine was given
    const trace = ({ pixels, words, run, asks }) => JSON.stringify([pixels, words, run, asks]);
    const [first, ...others] = figure.cases;
    for (const other of others)
        if (trace(other) === trace(first)) complain(figure.name, `${other.what} changes nothing`);
}

const READY = "document.documentElement.dataset.live === 'ready'";

async function checkControls(browser, page, address) {
    await browser.size(1100, 900);
    await browser.media({});
    await browser.go(`${address}?check`);
    if (!(await browser.until("document.getElementById('live-check') !== null", 120000))) {
        complain(page, 'no report from its live figures');
        return [];
    }
    const report = JSON.parse(await browser.ask("document.getElementById('live-check').textContent"));
    for (const error of [...browser.errors, ...report.troubles]) complain(page, error);
    if (report.waiting) complain(page, `${report.waiting} live figures without an experiment`);
    for (const figure of report.figures) compare(figure);
    return report.figures;
}

// As a reader meets it, on a telephone
async function checkReading(browser, page, address) {
    await browser.size(390, 844, true);
    await browser.media({ 'prefers-color-scheme': 'dark' });
    await browser.go(address);
    if (!(await browser.until(READY))) {
        complain(page, 'its figures are not ready');
        return;
    }
    const wide = await browser.ask('document.documentElement.scrollWidth');
    if (wide > 390) complain(page, `${wide} pixels wide on a screen of 390`);
    const count = await browser.ask('flyingFigures.length');
    for (let k = 0; k < count; ++k) {
        const name = await browser.ask(`flyingFigures[${k}].name`);
        if (k === 0) console.log(`${page}: the first figure shows ${Math.round(await browser.ask('flyingFigures[0].startedAt'))} ms after the page`);
        if (await browser.ask(`Boolean(flyingFigures[${k}].experiment.still)`)) continue;
        await browser.ask(`flyingFigures[${k}].canvas.scrollIntoView({ block: 'center', behavior: 'instant' })`);
        if (!(await browser.until(`flyingFigures[${k}].time > 0`, 10000))) complain(name, 'does not start when it is seen');
    }
    for (const error of browser.errors) complain(page, error);

    await browser.media({ 'prefers-reduced-motion': 'reduce' });
    await browser.go(address);
    await browser.until(READY);
    await browser.ask("flyingFigures[0].canvas.scrollIntoView({ block: 'center', behavior: 'instant' })");
    await new Promise((done) => setTimeout(done, 300));
    if (await browser.ask('flyingFigures.some((figure) => figure.isPlaying)')) complain(page, 'moves though the reader wants no motion');
}

async function checkRecordings(browser, page, address) {
    await browser.go(`${address}?engine=off`);
    const shows = `[...document.querySelectorAll('figure.live')].every((figure) => {
        const still = figure.querySelector('.still');
        return figure.querySelector('.controls, .fault') !== null || (still !== null && still.clientHeight > 0);
    })`;
    if (!(await browser.until(shows, 20000))) complain(page, 'a figure shows nothing without the engine');
    for (const error of browser.errors) complain(page, error);
}

// The hands: a body of the first page is dragged with the pointer, and pushed with the keys
async function checkHands(browser) {
    await browser.size(1100, 900);
    await browser.media({});
    await browser.go('file://' + path.join(html, 'index.html'));
    await browser.until(READY);
    const spot = `(() => {
        const figure = flyingFigures[0];
        figure.canvas.scrollIntoView({ block: 'center', behavior: 'instant' });
        figure.play(false);
        const k = figure.shapes.findIndex((shape, n) => !figure.run.isStatic(n));
        const [x, y] = figure.stage.at(figure.run.states()[k]);
        const box = figure.canvas.getBoundingClientRect();
        return [box.left + x, box.top + y];
    })()`;
    const [x, y] = await browser.ask(spot);
    const mouse = (type, dx) => browser.send('Input.dispatchMouseEvent', { type, x: x + dx, y, button: 'left', buttons: 1, clickCount: 1 });
    await mouse('mousePressed', 0);
    for (let k = 1; k <= 5; ++k) await mouse('mouseMoved', 8 * k);
    if (!(await browser.until('flyingFigures[0].isSteered', 5000))) complain('index.html', 'a body does not follow the pointer');
    await mouse('mouseReleased', 40);
    await browser.ask('flyingFigures[0].reset(), flyingFigures[0].canvas.focus()');
    for (const key of ['PageDown', 'ArrowUp'])
        for (const type of ['keyDown', 'keyUp']) await browser.send('Input.dispatchKeyEvent', { type, key, code: key });
    if (!(await browser.ask('flyingFigures[0].isSteered'))) complain('index.html', 'a body does not obey the keys');

    // The playground says what is wrong, with line and column
    await browser.go('file://' + path.join(html, 'playground.html'));
    await browser.until(READY);
    await browser.ask(`(() => {
        const area = document.querySelector('.scene-text textarea');
        area.value = 'until = 1\\n[[body]]\\nshape = { kind = "disc", radius = -1.0 }\\nposition = [0, 0]\\n';
        document.querySelector('.scene-text button').click();
    })()`);
    const fault = await browser.ask('flyingFigures[0].fault.textContent');
    if (!/scene:3:\d+: .*radius/.test(fault)) complain('playground.html', `says "${fault}" of a radius of -1 in line 3`);
}

async function main() {
    const isLive = (name) => name.endsWith('.html') && name !== 'print.html' && /<figure class="live/.test(fs.readFileSync(path.join(html, name), 'utf8'));
    const pages = fs.readdirSync(html).filter(isLive);
    const browser = new Browser();
    await browser.open();
    let figures = 0;
    for (const page of pages) {
        const address = 'file://' + path.join(html, page);
        const wanted = fs.readFileSync(path.join(html, page), 'utf8').match(/<figure class="live/g).length;
        const found = await checkControls(browser, page, address);
        if (found.length !== wanted) complain(page, `${found.length} of ${wanted} live figures run`);
        figures += wanted;
        await checkReading(browser, page, address);
        await checkRecordings(browser, page, address);
        console.log(`${page}: ${found.length} live figures`);
    }
    await checkHands(browser);
    await browser.close();
    fs.rmSync(work, { recursive: true, force: true });
    for (const fault of faults) console.log(fault);
    console.log(`${hashes} hashes compared`);
    console.log(`${figures} live figures, ${faults.length} faults`);
    process.exitCode = faults.length || !figures ? 1 : 0;
}

main().catch((error) => {
    console.log(error.stack);
    console.log('0 live figures, 1 faults');
    process.exit(1);
});
