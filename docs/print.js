// The page that holds the whole book as a PDF, by headless Chromium: live figures stand still as their own pages show them,
// and the contents and the index get the numbers of the pages that a first printing finds.
//
//   node docs/print.js BOOK/html/print.html FILE.pdf
'use strict';

const { execFileSync } = require('node:child_process');
const fs = require('node:fs');
const path = require('node:path');
const { Browser } = require('./browser.js');

const [page, file] = process.argv.slice(2).map((name) => path.resolve(name));
const TRIES = 4; // numbers may make a line longer, and move what follows
const PATIENCE = 300000; // until the figures of a page are drawn [ms]
const MOMENT = 90; // at which they stand, in sixtieths of a second

// Where each anchor came to lie: its page, by name
function pagesOf(pdf) {
    const pages = {};
    for (const line of execFileSync('pdfinfo', ['-dests', pdf], { encoding: 'utf8', maxBuffer: 1 << 26 }).split('\n')) {
        const [, number, name] = line.match(/^\s*(\d+) \[.*\] "(.*)"$/) || [];
        if (number) pages[name] = Number(number);
    }
    return pages;
}

// In a chapter's page: what its live figures show, as pictures, by their names
function stills() {
    const found = {};
    for (const figure of document.querySelectorAll('figure.live')) {
        const still = figure.cloneNode(true);
        const drawn = figure.querySelectorAll('canvas');
        still.querySelectorAll('canvas').forEach((canvas, k) => {
            const picture = document.createElement('img');
            picture.src = drawn[k].toDataURL();
            picture.alt = canvas.getAttribute('aria-label') || '';
            picture.className = 'still';
            canvas.replaceWith(picture);
        });
        for (const part of still.querySelectorAll('.controls, .knobs, .state-hash, .fault, .for-readers, .scene-text')) part.remove();
        found[figure.dataset.trace] = still.innerHTML;
    }
    return found;
}

async function drawLiveFigures(browser) {
    const home = path.dirname(page);
    const isLive = (name) => /^chapter_\d+\.html$/.test(name) && fs.readFileSync(path.join(home, name), 'utf8').includes('<figure class="live');
    const found = {};
    for (const name of fs.readdirSync(home).filter(isLive)) {
        await browser.go(`file://${path.join(home, name)}?steps=${MOMENT}`);
        const isDrawn = "location.href.includes('" + name + "') && document.documentElement.dataset.live === 'ready'";
        if (!(await browser.until(isDrawn, PATIENCE))) throw new Error(`the figures of ${name} are not drawn`);
        Object.assign(found, await browser.ask(`(${stills})()`));
    }
    return found;
}

// In the page: put the stills in
function place(found) {
    for (const figure of document.querySelectorAll('figure.live')) figure.innerHTML = found[figure.dataset.trace] || figure.innerHTML;
    return Promise.all([...document.querySelectorAll('img')].map((image) => image.decode().catch(() => {}))).then(() => true);
}

// In the page: what is folded on a screen opens, but for the receipts, whose sentences are at the end
function unfold() {
    for (const details of document.querySelectorAll('details:not(.receipt):not(.inner)')) details.open = true;
}

// In the page: the number behind each line of the contents and each place of the index, and where an answer is; how many
// have none. Of two places of a term on one page the index names one.
function setNumbers(pages) {
    let without = 0;
    for (const link of document.querySelectorAll('.to a[href^="#"], #terms a[href^="#"], .try a[href^="#"]')) {
        const number = pages[decodeURIComponent(link.hash.slice(1))];
        if (!number) ++without;
        else link.dataset.page = number;
        const before = link.previousElementSibling;
        if (!number || !link.closest('#terms') || !before || Number(before.dataset.page) !== number) continue;
        link.previousSibling.remove();
        link.remove();
    }
    return without;
}

async function print(browser, isLast) {
    const { data } = await browser.send('Page.printToPDF',
        { preferCSSPageSize: true, printBackground: true, generateDocumentOutline: isLast, generateTaggedPDF: isLast });
    fs.writeFileSync(`${file}.part`, Buffer.from(data, 'base64'));
    return pagesOf(`${file}.part`);
}

async function main() {
    const browser = new Browser();
    await browser.open();
    await browser.send('Emulation.setDeviceMetricsOverride', { width: 800, height: 1100, deviceScaleFactor: 3, mobile: false });
    const found = await drawLiveFigures(browser);
    await browser.go(`file://${page}`);
    if (!(await browser.until("location.href.endsWith('" + path.basename(page) + "') && document.readyState === 'complete'", PATIENCE)))
        throw new Error(`${page} does not open`);
    await browser.ask(`(${place})(${JSON.stringify(found)})`);
    await browser.ask('document.fonts.ready.then(() => true)');
    await browser.ask(`(${unfold})()`);

    let pages = await print(browser, false);
    for (let tries = 1; ; ++tries) {
        const without = await browser.ask(`(${setNumbers})(${JSON.stringify(pages)})`);
        if (without) throw new Error(`${without} lines of the contents or the index lead nowhere`);
        const after = await print(browser, true);
        const isSame = JSON.stringify(after) === JSON.stringify(pages);
        pages = after;
        if (isSame) break;
        if (tries === TRIES) throw new Error('the numbers of the pages do not settle');
    }
    if (browser.errors.length) throw new Error(browser.errors.join('; '));
    await browser.close();
    fs.renameSync(`${file}.part`, file);
    console.log(`${file}: ${(fs.statSync(file).size / 1e6).toFixed(1)} MB`);
}

main().catch((error) => {
    console.error(error.message);
    process.exit(1);
});
