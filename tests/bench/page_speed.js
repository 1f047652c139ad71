// How much longer a run takes in a page than in the program: the same scenes in headless Chromium and by `flying simulate`,
// in turns, medians of the ratios.
//
//   node tests/bench/page_speed.js BOOK/html FLYING
'use strict';

const { execFileSync } = require('node:child_process');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const { Browser } = require('../../docs/browser.js');

const [html, flying] = process.argv.slice(2).map((name) => path.resolve(name));
const ROUNDS = 7;
const SCENES = [
    ['a gas of 200 discs, 100 s', 'gas --count 200 --seed 1 --until 100', 'events'],
    ['a gas of 60 polygons, 40 s', 'gas --shape polygon --count 60 --seed 1 --until 40', 'events'],
    ['polygons that fall to rest, 6 s', 'polygons --count 24 --seed 5 --packing 0.12 --gravity 0 -9.81 --restitution 0.4 --friction 0.5 --until 6', 'auto'],
    ['a pile of 100 discs, 3 s', 'pile --count 100 --seed 1 --until 3', 'rest']
];
const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

async function main() {
    const work = fs.mkdtempSync(path.join(os.tmpdir(), 'flying-speed-'));
    const browser = new Browser();
    await browser.open();
    await browser.go('file://' + path.join(html, 'index.html'));
    await browser.until("document.documentElement.dataset.live === 'ready'");
    await browser.ask('flyingFigures.forEach((figure) => figure.play(false))');
    for (const [what, words, engine] of SCENES) {
        const text = execFileSync(flying, ['generate', ...words.split(' ')], { encoding: 'utf8' });
        const scene = path.join(work, 'scene.toml');
        const report = path.join(work, 'report.json');
        fs.writeFileSync(scene, text);
        const times = { page: [], program: [] };
        let hashes = [];
        for (let round = 0; round <= ROUNDS; ++round) {
            const [seconds, hash] = await browser.ask(`(() => {
                const run = flyingFigures[0].module.open(${JSON.stringify(text)}, { engine: '${engine}' });
                const start = performance.now();
                run.advance(run.until);
                const passed = performance.now() - start;
                const hash = run.hash;
                run.close();
                return [passed / 1000, hash];
            })()`);
            execFileSync(flying, ['simulate', scene, '--engine', engine, '--report', report, '--quiet'], { stdio: 'ignore' });
            const native = JSON.parse(fs.readFileSync(report, 'utf8'));
            hashes = [hash, native.hash];
            if (round === 0) continue; // the browser compiles as it goes
            times.page.push(seconds);
            times.program.push(native.wall_seconds);
        }
        const ratio = median(times.page.map((seconds, k) => seconds / times.program[k]));
        console.log(`${what}: page ${(1e3 * median(times.page)).toFixed(1)} ms, program ${(1e3 * median(times.program)).toFixed(1)} ms, ` +
            `ratio ${ratio.toFixed(2)}${hashes[0] === hashes[1] ? '' : ', WITH OTHER BITS'}`);
    }
    await browser.close();
    fs.rmSync(work, { recursive: true, force: true });
}

main().catch((error) => {
    console.log(error.stack);
    process.exit(1);
});
