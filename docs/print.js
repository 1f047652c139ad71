// The page that holds the whole book as a PDF, by headless Chromium: the contents and the index get the numbers of the
// pages that a first printing finds.
//
//   node docs/print.js BOOK/html/print.html FILE.pdf
'use strict';

const { execFileSync } = require('node:child_process');
const fs = require('node:fs');
const path = require('node:path');
const { Browser } = require('./browser.js');

const [page, file] = process.argv.slice(2).map((name) => path.resolve(name));
const TRIES = 4; // numbers may make a line longer, and move what follows
const PATIENCE = 180000; // until every figure is drawn [ms]

// Where each anchor came to lie: its page, by name
function pagesOf(pdf) {
    const pages = {};
    for (const line of execFileSync('pdfinfo', ['-dests', pdf], { encoding: 'utf8', maxBuffer: 1 << 26 }).split('\n')) {
        const [, number, name] = line.match(/^\s*(\d+) \[.*\] "(.*)"$/) || [];
        if (number) pages[name] = Number(number);
    }
    return pages;
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
    await browser.go(`file://${page}?steps=90`);
    if (!(await browser.until("document.documentElement.dataset.live === 'ready' || !document.querySelector('figure.live')", PATIENCE)))
        throw new Error('the figures are not drawn');
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
