// Every live figure of the book in headless Chromium, at the ends of all its controls: the hashes that the page shows must
// be those of the native program, and the page must be in order.
//
//   node tests/differential/live/compare_pages.js BOOK/html FLYING PIECES
//
// FLYING is the program `flying`, PIECES the program built from pieces.cpp. The last line says how many figures agree.
'use strict';

const { execFileSync, spawn } = require('node:child_process');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');

const [html, flying, pieces] = process.argv.slice(2).map((name) => path.resolve(name));
const work = fs.mkdtempSync(path.join(os.tmpdir(), 'live-'));
const FLAGS = ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
    '--disable-component-update', '--disable-sync', '--hide-scrollbars'];
const LATEST = 1000; // from opening the page to the first picture of a figure [ms]
const faults = [];

function chromium(address, ...more) {
    const profile = fs.mkdtempSync(path.join(work, 'profile-'));
    return new Promise((done) => {
        const child = spawn('chromium', [...FLAGS, `--user-data-dir=${profile}`, '--window-size=1100,900', '--virtual-time-budget=30000',
            '--enable-logging=stderr', '--v=0', ...more, '--dump-dom', address], { stdio: ['ignore', 'pipe', 'pipe'] });
        let out = '';
        let log = '';
        child.stdout.on('data', (data) => { out += data; });
        child.stderr.on('data', (data) => { log += data; });
        const late = setTimeout(() => child.kill('SIGKILL'), 300000);
        child.on('close', () => {
            clearTimeout(late);
            done({ out, errors: log.split('\n').filter((line) => /CONSOLE/.test(line) && /error|uncaught|violat/i.test(line)) });
        });
    });
}

const unescape = (text) => text.replace(/&lt;/g, '<').replace(/&gt;/g, '>').replace(/&quot;/g, '"').replace(/&amp;/g, '&');

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
    let compared = 0;
    for (const { what, time, fault, run, asks } of figure.cases) {
        const place = `${figure.name}, ${what}`;
        if (fault) complain(place, `a fault: ${fault}`);
        if (run) {
            const expected = nativeHash(run, time);
            ++compared;
            if (run.hash !== expected) complain(place, `the page's hash ${run.hash}, the program's ${expected}`);
        }
        if (asks.length) {
            const questions = asks.map(({ name, numbers }) => [name, ...numbers].join(' ')).join('\n') + '\n';
            const answers = execFileSync(pieces, { input: questions, encoding: 'utf8', maxBuffer: 1 << 26 }).trim().split('\n');
            asks.forEach(({ name, hash }, k) => {
                ++compared;
                if (hash !== answers[k]) complain(place, `${name}: the page's hash ${hash}, the native one ${answers[k]}`);
            });
        }
    }
    if (compared === 0) complain(figure.name, 'nothing to compare');
    const [first, ...others] = figure.cases;
    for (const other of others)
        if (other.pixels === first.pixels) complain(figure.name, `${other.what} changes nothing in the picture`);
    return compared;
}

async function main() {
    const pages = fs.readdirSync(html).filter((name) => name.endsWith('.html') && /<figure class="live/.test(fs.readFileSync(path.join(html, name), 'utf8')));
    let good = 0;
    let bad = 0;
    let hashes = 0;
    for (const page of pages) {
        const address = 'file://' + path.join(html, page);
        const { out, errors } = await chromium(address + '?check');
        const found = out.match(/<script type="application\/json" id="live-check">([\s\S]*?)<\/script>/);
        const wanted = (fs.readFileSync(path.join(html, page), 'utf8').match(/<figure class="live/g) || []).length;
        if (!found) {
            complain(page, 'no report from its live figures');
            bad += wanted;
            continue;
        }
        const report = JSON.parse(unescape(found[1]));
        for (const error of [...errors, ...report.troubles]) complain(page, error);
        if (report.tooWide) complain(page, `wider than the window by ${report.tooWide}`);
        if (report.waiting) complain(page, `${report.waiting} live figures without an experiment`);
        for (const figure of report.figures) {
            const before = faults.length;
            hashes += compare(figure);
            if (figure.startedAt > LATEST) complain(figure.name, `starts after ${Math.round(figure.startedAt)} ms`);
            faults.length > before ? ++bad : ++good;
        }
        bad += report.waiting;
        const narrow = await chromium(address + '?steps=30', '--window-size=500,900', '--force-device-scale-factor=1');
        if (!/data-live="ready"/.test(narrow.out)) complain(page, 'is not ready in a narrow window');
        const weight = fs.statSync(path.join(html, page)).size;
        console.log(`${page}: ${report.figures.length} live figures, page of ${Math.round(weight / 1000)} kB`);
    }
    fs.rmSync(work, { recursive: true, force: true });
    for (const fault of faults) console.log(fault);
    if (faults.length && !bad) ++bad;
    console.log(`${hashes} hashes compared`);
    console.log(`${good} live figures agree, ${bad} differ`);
    process.exitCode = bad ? 1 : 0;
}

main();
