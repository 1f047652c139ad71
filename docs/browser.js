// Headless Chromium by its debugging pipe: questions go in by one pipe, answers and events come out by another.
'use strict';

const { spawn } = require('node:child_process');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');

const FLAGS = ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
    '--disable-component-update', '--disable-sync', '--hide-scrollbars', '--remote-debugging-pipe', 'about:blank'];

class Browser {
    constructor() {
        this.profile = fs.mkdtempSync(path.join(os.tmpdir(), 'flying-browser-'));
        this.child = spawn('chromium', [`--user-data-dir=${this.profile}`, ...FLAGS], { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
        this.gone = new Promise((done) => this.child.on('exit', done));
        this.child.on('error', (error) => { throw new Error(`no chromium: ${error.message}`); });
        this.waiting = new Map();
        this.errors = [];
        this.loaded = new Set();
        this.count = 0;
        let rest = '';
        this.child.stdio[4].on('data', (data) => {
            const parts = (rest + data).split('\0');
            rest = parts.pop();
            for (const part of parts) this.take(JSON.parse(part));
        });
    }

    take({ id, result, error, method, params }) {
        if (id !== undefined) {
            const { done, failed } = this.waiting.get(id);
            this.waiting.delete(id);
            if (error) failed(new Error(error.message));
            else done(result);
        } else if (method === 'Network.requestWillBeSent') {
            this.loaded.add(params.request.url.replace(/[?#].*/, ''));
        } else if (method === 'Runtime.exceptionThrown') {
            this.errors.push(params.exceptionDetails.exception?.description || params.exceptionDetails.text);
        } else if (method === 'Log.entryAdded' && params.entry.level === 'error') {
            this.errors.push(`${params.entry.text} ${params.entry.url || ''}`);
        } else if (method === 'Runtime.consoleAPICalled' && params.type === 'error') {
            this.errors.push(params.args.map((one) => one.value || one.description).join(' '));
        }
    }

    send(method, params = {}) {
        return new Promise((done, failed) => {
            const id = ++this.count;
            this.waiting.set(id, { done, failed });
            this.child.stdio[3].write(JSON.stringify({ id, method, params, sessionId: this.session }) + '\0');
        });
    }

    async open() {
        const { targetInfos } = await this.send('Target.getTargets');
        const { targetId } = targetInfos.find(({ type }) => type === 'page');
        this.session = (await this.send('Target.attachToTarget', { targetId, flatten: true })).sessionId;
        for (const domain of ['Page', 'Runtime', 'Log', 'Network']) await this.send(`${domain}.enable`);
    }

    size(width, height, mobile = false) {
        return this.send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile });
    }

    media(features) {
        return this.send('Emulation.setEmulatedMedia', { features: Object.entries(features).map(([name, value]) => ({ name, value })) });
    }

    // What the page loads from then on is in `loaded`
    async go(address) {
        this.errors = [];
        this.loaded = new Set();
        await this.send('Page.navigate', { url: address });
    }

    // The value of an expression in the page
    async ask(expression) {
        const { result, exceptionDetails } = await this.send('Runtime.evaluate', { expression, returnByValue: true, awaitPromise: true });
        if (exceptionDetails) throw new Error(exceptionDetails.exception?.description || exceptionDetails.text);
        return result.value;
    }

    // Wait until an expression is true; false where it doesn't come true in time
    async until(expression, milliseconds = 60000) {
        for (const end = Date.now() + milliseconds; Date.now() < end;) {
            if (await this.ask(expression).catch(() => false)) return true;
            await new Promise((done) => setTimeout(done, 50));
        }
        return false;
    }

    async picture(file, full = false) {
        const { data } = await this.send('Page.captureScreenshot', { captureBeyondViewport: full });
        fs.writeFileSync(file, Buffer.from(data, 'base64'));
    }

    async close() {
        this.session = undefined;
        await this.send('Browser.close').catch(() => {});
        await this.gone;
        fs.rmSync(this.profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
    }
}

module.exports = { Browser };
