// Live figures: an experiment with controls, on the engine itself. A chapter's live.js registers its experiments:
//
//   flyingLive('07-impulse/strike', {
//       controls: {e: {label: 'restitution', min: 0, max: 1, step: 0.05, value: 1}},
//       view: [-1, -1, 1, 1],                   // or a function of the controls' values
//       until: 3,                               // [s], or a function; without it the experiment goes on for ever
//       scene: (p) => toml,                     // optional: what a run is opened with; or {text, engine, step, without}
//       setup: (p, ask, run, kept) => state,    // ask(name, numbers) is a piece of the engine: {engine, paper}
//       frame: (t, state, p, run) => {},        // optional: after each move in time
//       next: (t, state, p, run) => t,          // optional: where the button for one step leads
//       draw: (stage, t, state, p, run) => {},
//       readout: (t, state, p, run) => [['impulse', '1.2 N s']],
//       legend: [['body', 0, 'the ball'], ['ghost', 'ink', 'closed form'], ['line', 1, 'path']],
//       strip: {label: 'energy', value: (t, state, p, run) => 0},
//       trails: (t, state, p, run) => [[x, y], ...],
//       handles: (p, kept) => [[x, y], ...], move: (k, point, p, kept) => {}, start: () => kept,
//       begun: (figure) => {},                  // optional: once, when all is built
//       grab: true,                             // bodies of the run follow the pointer
//   });
//
// Nothing here knows physics. In the address, ?steps=N shows the moment N/60 s without playing, ?engine=off the recorded
// motion; ?check tries every control and writes what came out into the page (tests/differential/live).
'use strict';

(function (home) {
    const { Stage, Strip, short } = home.FlyingStage;
    const FRAME = 1 / 60;
    const BITE = 400; // events or steps between two looks at the clock
    const PATIENCE = 14; // of a frame [ms]
    const experiments = {};
    const asked = new URLSearchParams(location.search);
    const troubles = [];
    let engine = null;

    home.flyingLive = (name, experiment) => { experiments[name] = experiment; };
    home.addEventListener('error', (event) => troubles.push(String(event.message)));
    home.addEventListener('unhandledrejection', (event) => troubles.push(String(event.reason)));

    function load(source) {
        return new Promise((done, failed) => {
            const script = document.createElement('script');
            script.src = source;
            script.onload = done;
            script.onerror = () => failed(new Error('no ' + source));
            document.head.append(script);
        });
    }

    // The module, once a page: base64 of gzip, since file:// lets scripts in and nothing else
    function theEngine() {
        engine = engine || (async () => {
            if (asked.get('engine') === 'off') throw new Error('the engine is switched off');
            await load('live/module.js');
            const packed = Uint8Array.from(atob(home.flyingModule), (letter) => letter.charCodeAt(0));
            const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
            return home.FlyingEngine.load(await new Response(stream).arrayBuffer());
        })();
        return engine;
    }

    function make(tag, attributes = {}, ...inside) {
        const element = document.createElement(tag);
        for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
        element.append(...inside);
        return element;
    }

    // ---- Controls ----------------------------------------------------------------------------------------------------

    // One control with its label: a slider, a choice, or a tick. `changed` is called after each change.
    function knob(key, of, values, changed) {
        values[key] = of.value;
        const name = make('span', {}, of.label);
        if (of.options) {
            const select = make('select', { name: key });
            of.options.forEach(([value, label]) => select.append(make('option', { value }, label)));
            select.value = of.value;
            select.onchange = () => {
                values[key] = of.options.find(([value]) => String(value) === select.value)[0];
                changed();
            };
            return make('label', { class: 'choice' }, name, select);
        }
        if (of.check) {
            const tick = make('input', { type: 'checkbox', name: key });
            tick.checked = of.value;
            tick.onchange = () => { values[key] = tick.checked; changed(); };
            return make('label', { class: 'tick' }, tick, name);
        }
        const input = make('input', { type: 'range', name: key, min: of.min, max: of.max, step: of.step, value: of.value });
        const shown = make('output');
        const show = () => {
            const text = of.show ? of.show(values[key]) : short(values[key]) + (of.unit ? '\u202f' + of.unit : '');
            shown.textContent = text;
            input.setAttribute('aria-valuetext', text);
        };
        input.oninput = () => { values[key] = Number(input.value); show(); changed(); };
        show();
        return make('label', { class: 'range' }, name, input, shown);
    }

    const KIND = { body: '\u25cf', ghost: '\u254c', line: '\u2501', dot: '\u2022', arrow: '\u279d' };

    class Figure {
        constructor(figure, experiment, module) {
            Object.assign(this, { figure, experiment, module, time: 0, isPlaying: false, wantsToPlay: false, asks: [] });
            this.name = figure.dataset.trace;
            this.p = {};
            this.kept = experiment.start ? experiment.start() : null;
            this.canvas = figure.querySelector('canvas');
            this.stage = new Stage(this.canvas, [0, 0, 1, 1]);
            figure.classList.add('running');
            this.build();
            this.reset();
            if (experiment.begun) experiment.begun(this);
            if (!experiment.still) this.watch();
            new ResizeObserver(() => this.draw()).observe(figure);
            new MutationObserver(() => this.draw()).observe(document.documentElement, { attributes: true, attributeFilter: ['class'] });
        }

        build() {
            const { experiment, canvas } = this;
            const bar = make('div', { class: 'controls' });
            if (!experiment.still) {
                this.playButton = make('button', { type: 'button', class: 'play' });
                this.playButton.onclick = () => this.play(!this.isPlaying);
                const step = make('button', { type: 'button', 'aria-label': 'Next moment', title: 'Next moment' }, '\u275a\u25b6');
                step.onclick = () => { this.play(false); this.go(this.next()); this.draw(); };
                const again = make('button', { type: 'button', 'aria-label': 'From the start', title: 'From the start' }, '\u21ba');
                again.onclick = () => { this.reset(); this.draw(); };
                const speed = make('select', { 'aria-label': 'Speed' });
                for (const [value, label] of [[0.125, '\u215b'], [0.25, '\u00bc'], [0.5, '\u00bd'], [1, '1'], [2, '2'], [4, '4']])
                    speed.append(make('option', { value }, label + '\u00d7'));
                speed.value = String(experiment.speed || 1);
                this.speed = experiment.speed || 1;
                speed.onchange = () => { this.speed = Number(speed.value); };
                bar.append(this.playButton, step, again, speed);
                if (experiment.until) {
                    this.slider = make('input', { type: 'range', min: 0, max: 1, step: 'any', value: 0, 'aria-label': 'Moment' });
                    this.slider.oninput = () => {
                        this.play(false);
                        this.go(this.slider.value * this.until());
                        this.draw();
                    };
                    bar.append(this.slider);
                }
                this.clock = make('output', { class: 'clock' });
                bar.append(this.clock);
            }
            const knobs = make('div', { class: 'knobs' });
            for (const of of Object.values(experiment.controls || {}))
                if (typeof of.options === 'function') of.options = of.options(this.module);
            for (const [key, of] of Object.entries(experiment.controls || {}))
                knobs.append(knob(key, of, this.p, () => { this.reset(); this.draw(); }));
            if (experiment.legend)
                this.legend = make('p', { class: 'legend', 'aria-hidden': 'true' });
            this.readout = make('dl', { class: 'readout' });
            this.fault = make('p', { class: 'fault', role: 'alert' });
            this.hashLine = make('p', { class: 'state-hash', title: 'The state after these controls and this time, as sixteen digits. The program on your machine gets the same ones.' });
            const parts = [];
            if (experiment.strip) {
                const strip = make('canvas', { class: 'strip', role: 'img', 'aria-label': experiment.strip.label });
                this.strip = new Strip(strip, experiment.strip);
                parts.push(strip);
            }
            if (this.legend) parts.push(this.legend);
            if (bar.childNodes.length) parts.push(bar);
            if (knobs.childNodes.length) parts.push(knobs);
            parts.push(this.readout, this.fault, this.hashLine);
            canvas.after(...parts);
            if (experiment.handles || experiment.grab) this.listen();
        }

        // ---- What a pointer or the keyboard moves -------------------------------------------------------------------

        listen() {
            const { canvas, experiment } = this;
            canvas.tabIndex = 0;
            canvas.classList.add('to-drag');
            this.held = -1;
            this.chosen = 0;
            const hint = make('span', { class: 'for-readers', 'aria-live': 'polite' });
            this.hint = hint;
            const words = experiment.grab ? 'Page up and page down choose a body, the arrow keys push it.'
                : 'Page up and page down choose a handle, the arrow keys move it.';
            canvas.setAttribute('aria-description', words);
            canvas.title = words;
            canvas.after(hint);
            canvas.addEventListener('pointerdown', (event) => {
                const k = this.nearest(this.stage.under(event));
                if (k < 0) return;
                this.held = this.chosen = k;
                this.target = this.stage.under(event);
                canvas.setPointerCapture(event.pointerId);
                event.preventDefault();
                this.pull();
            });
            canvas.addEventListener('pointermove', (event) => {
                if (this.held < 0) {
                    canvas.style.cursor = this.nearest(this.stage.under(event)) < 0 ? '' : 'grab';
                    return;
                }
                this.target = this.stage.under(event);
                this.pull();
            });
            for (const kind of ['pointerup', 'pointercancel'])
                canvas.addEventListener(kind, () => { this.held = -1; });
            canvas.addEventListener('keydown', (event) => {
                const count = experiment.grab ? this.run.bodyCount : this.handles().length;
                const turn = { PageDown: 1, PageUp: count - 1 }[event.key];
                const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
                if (!turn && !way) return;
                event.preventDefault();
                if (turn) {
                    do this.chosen = (this.chosen + turn) % count;
                    while (experiment.grab && this.run.isStatic(this.chosen));
                } else if (experiment.grab) {
                    const state = this.run.states()[this.chosen];
                    this.steer(this.chosen, state[3] + way[0], state[4] + way[1]);
                } else {
                    const [x, y] = this.handles()[this.chosen];
                    const size = (event.shiftKey ? 0.01 : 0.04) * (this.stage.view[2] - this.stage.view[0]);
                    this.target = [x + size * way[0], y + size * way[1]];
                    this.move(this.chosen);
                }
                this.hint.textContent = `number ${this.chosen + 1} of ${count}`;
                this.draw();
            });
        }

        handles() { return this.experiment.handles(this.p, this.kept, this.state); }

        // The handle or the body under a point, -1 where there is none
        nearest(point) {
            const reach = 26 / this.stage.scale;
            let best = -1;
            let closest = Infinity;
            const look = ([x, y], k, size) => {
                const distance = Math.hypot(point[0] - x, point[1] - y);
                if (distance < Math.max(size, reach) && distance < closest) [best, closest] = [k, distance];
            };
            if (this.experiment.handles) this.handles().forEach((at, k) => look(at, k, 0));
            else this.run.states().forEach((at, k) => this.run.isStatic(k) || look(at, k, this.reaches[k]));
            return best;
        }

        pull() {
            if (this.experiment.handles) {
                this.move(this.held);
                this.draw();
            } else if (!this.isPlaying) {
                this.play(true);
            }
        }

        move(k) {
            this.experiment.move(k, this.target, this.p, this.kept, this.state);
            this.reset();
        }

        // A held body gets the velocity that brings it under the pointer soon
        follow() {
            const soon = 0.12;
            const fastest = 1.5 * (this.stage.view[2] - this.stage.view[0]);
            const [x, y] = this.run.states()[this.held];
            let [vx, vy] = [(this.target[0] - x) / soon, (this.target[1] - y) / soon];
            const speed = Math.hypot(vx, vy);
            if (speed > fastest) [vx, vy] = [(vx * fastest) / speed, (vy * fastest) / speed];
            this.steer(this.held, vx, vy);
        }

        steer(body, vx, vy) {
            if (this.run.steer(body, vx, vy)) this.isSteered = true;
        }

        // ---- Time ----------------------------------------------------------------------------------------------------

        until() {
            const { until } = this.experiment;
            return typeof until === 'function' ? until(this.p, this.state) : until || Infinity;
        }

        ask(name, numbers) {
            const answer = this.module.ask(name, numbers);
            this.asks = this.asks.filter((other) => other.name !== name);
            this.asks.push({ name, numbers: Array.from(numbers), hash: answer.hash });
            return answer;
        }

        open() {
            if (this.run) this.run.close();
            this.run = null;
            this.isSteered = false;
            const scene = this.experiment.scene(this.p, this.module, this.kept, (name, numbers) => this.ask(name, numbers));
            this.scene = typeof scene === 'string' ? { text: scene } : scene;
            this.run = this.module.open(this.scene.text, this.scene);
            this.shapes = Array.from({ length: this.run.bodyCount }, (_, k) => this.run.shape(k));
            this.reaches = this.shapes.map((shape) => shape.radius || Math.max(...shape.rings[0].map(([x, y]) => Math.hypot(x, y))));
            this.run.shapes = this.shapes;
        }

        // The moment that the button for one step leads to
        next() {
            const { experiment } = this;
            return experiment.next ? experiment.next(this.time, this.state, this.p, this.run) : this.time + FRAME * this.speed;
        }

        set() {
            const { experiment } = this;
            if (experiment.setup)
                this.state = experiment.setup(this.p, (name, numbers) => this.ask(name, numbers), this.run, this.kept, this.module);
        }

        reset() {
            const { experiment } = this;
            this.time = 0;
            this.isFailed = false;
            this.trails = [];
            this.asks = [];
            if (this.strip) this.strip.clear();
            this.fault.textContent = '';
            try {
                if (experiment.scene) this.open();
                this.set();
                this.note();
            } catch (error) {
                this.fail(error);
            }
        }

        fail(error) {
            if (!(error instanceof home.FlyingError)) throw error;
            this.isFailed = true;
            this.play(false);
            this.fault.textContent = error.message;
            if (this.experiment.failed) this.experiment.failed(error.message, this);
        }

        // Move to a moment; where the machine can't keep up, as far as a frame allows unless `whole`
        go(time, whole = true) {
            if (this.isFailed) return;
            const end = this.until();
            const wanted = Math.min(time, end);
            try {
                if (this.run) {
                    if (wanted < this.time) {
                        this.open();
                        this.set();
                        this.trails = [];
                        if (this.strip) this.strip.clear();
                    }
                    const late = performance.now() + PATIENCE;
                    let isThere = this.run.advance(wanted, BITE);
                    while (!isThere && (whole || performance.now() < late)) isThere = this.run.advance(wanted, BITE);
                    this.isLate = !isThere;
                    this.time = isThere ? wanted : Math.max(this.time, this.run.time);
                } else {
                    if (wanted < this.time) this.trails = [];
                    this.time = wanted;
                }
                if (this.time >= end) this.play(false);
                this.note();
            } catch (error) {
                this.fail(error);
            }
        }

        note() {
            const { experiment, time, state, p, run } = this;
            if (experiment.frame) experiment.frame(time, state, p, run);
            if (this.strip) this.strip.add(time, experiment.strip.value(time, state, p, run));
            if (!experiment.trails) return;
            experiment.trails(time, state, p, run).forEach((point, k) => {
                const trail = (this.trails[k] = this.trails[k] || []);
                trail.push(point.slice(0, 2));
                if (trail.length > (experiment.trailLength || 400)) trail.shift();
            });
        }

        play(isPlaying) {
            if (this.experiment.still || isPlaying === this.isPlaying) return;
            if (isPlaying && (this.time >= this.until() || this.isFailed)) this.reset();
            this.isPlaying = isPlaying && !this.isFailed;
            if (!this.isPlaying) {
                this.draw();
                return;
            }
            let before = performance.now();
            const tick = (now) => {
                if (!this.isPlaying) return;
                const passed = Math.min((now - before) / 1000, 0.1);
                before = now;
                if (this.held >= 0 && this.experiment.grab) this.follow();
                this.go(this.time + Math.max(passed, 0) * this.speed, false);
                this.draw();
                requestAnimationFrame(tick);
            };
            requestAnimationFrame(tick);
        }

        // Starts by itself once in view, unless the reader asked for less motion; rests while out of view
        watch() {
            this.wantsToPlay = !home.matchMedia('(prefers-reduced-motion: reduce)').matches && !asked.has('steps') && !asked.has('check');
            this.playButton.addEventListener('click', () => { this.wantsToPlay = this.isPlaying; });
            new IntersectionObserver(([entry]) => {
                if (!entry.isIntersecting) {
                    const was = this.isPlaying;
                    this.play(false);
                    this.wantsToPlay = was;
                } else if (this.wantsToPlay) {
                    this.wantsToPlay = false;
                    this.play(true);
                }
            }, { threshold: 0.35 }).observe(this.canvas);
        }

        // ---- Drawing -------------------------------------------------------------------------------------------------

        draw() {
            if (this.isFailed || (this.experiment.scene && !this.run)) {
                this.showPlay();
                return;
            }
            const { experiment, stage, time, state, p, run } = this;
            stage.view = typeof experiment.view === 'function' ? experiment.view(p, state, run) : experiment.view;
            stage.begin();
            this.trails.forEach((trail, k) => stage.trail(trail, stage.colour(experiment.trailColours ? experiment.trailColours[k] : k)));
            experiment.draw(stage, time, state, p, run, this.kept);
            if (experiment.handles && document.activeElement === this.canvas) {
                const at = this.handles()[this.chosen];
                if (at) stage.ring(at, stage.ink, 12);
            } else if (experiment.grab && document.activeElement === this.canvas) {
                stage.ring(run.states()[this.chosen].slice(0, 2), stage.ink, this.reaches[this.chosen] * stage.scale + 4);
            }
            if (this.strip) this.strip.draw(Number.isFinite(this.until()) ? this.until() : 0);
            if (this.legend && !this.legend.firstChild)
                for (const [kind, colour, text] of experiment.legend) {
                    const sign = make('span', { class: 'sign' }, KIND[kind]);
                    sign.style.color = colour === 'ink' ? '' : colour === 'fixed' ? 'var(--live-soft)' : stage.colour(colour);
                    this.legend.append(make('span', {}, sign, ' ' + text));
                }
            const rows = experiment.readout ? experiment.readout(time, state, p, run, this.kept) : [];
            this.show(rows);
            this.showPlay();
            this.isDrawn = true;
        }

        showPlay() {
            if (this.experiment.still) {
                this.showHash(this.lastAsk());
                return;
            }
            this.playButton.textContent = this.isPlaying ? '\u275a\u275a' : '\u25b6';
            this.playButton.setAttribute('aria-label', this.isPlaying ? 'Pause' : 'Play');
            this.clock.textContent = this.time.toFixed(2) + ' s' + (this.isPlaying && this.isLate ? ' (slower than the clock)' : '');
            if (this.slider) this.slider.value = this.time / this.until();
            const now = performance.now();
            if (this.isPlaying && now - (this.hashedAt || 0) < 400) return;
            this.hashedAt = now;
            this.showHash(this.run && !this.isFailed ? this.run.hash : this.lastAsk());
        }

        lastAsk() { return this.asks.length ? this.asks[this.asks.length - 1].hash : ''; }

        showHash(hash) { this.hashLine.textContent = hash ? 'state ' + hash : ''; }

        // Rows of words and values; those that stay are not made anew
        show(rows) {
            const { readout } = this;
            while (readout.children.length > rows.length) readout.lastChild.remove();
            rows.forEach(([name, value], k) => {
                const row = readout.children[k] || readout.appendChild(make('div', {}, make('dt'), make('dd')));
                if (row.firstChild.textContent !== name) row.firstChild.textContent = name;
                if (row.lastChild.textContent !== value) row.lastChild.textContent = value;
            });
        }

        // ---- What a test asks -------------------------------------------------------------------------------------------

        outcome(what) {
            const { scene = null, time } = this;
            const pixels = this.canvas.getContext('2d').getImageData(0, 0, this.canvas.width, this.canvas.height).data;
            let sum = 0;
            for (let k = 0; k < pixels.length; k += 4) sum = (sum * 31 + pixels[k] + 7 * pixels[k + 1] + 13 * pixels[k + 2]) % 1000000007;
            const asks = this.asks.slice();
            return { what, time, fault: this.fault.textContent, pixels: sum, asks,
                run: this.run && !this.isFailed ? { ...scene, hash: this.run.hash } : null };
        }

        // The figure at its controls as they come, then with each at every end or choice
        check() {
            const { experiment } = this;
            const end = experiment.checkTime || Math.min(1.5, this.until());
            const look = (what) => {
                this.go(end);
                this.draw();
                cases.push(this.outcome(what));
            };
            const cases = [];
            this.reset();
            look('as it comes');
            for (const [key, of] of Object.entries(experiment.controls || {})) {
                const values = of.options ? of.options.map(([value]) => value) : of.check ? [!of.value] : [of.min, of.max];
                const input = this.figure.querySelector(`[name="${key}"]`);
                for (const value of values) {
                    if (value === of.value) continue;
                    if (of.check) input.checked = value;
                    else input.value = value;
                    input.dispatchEvent(new Event(of.check || of.options ? 'change' : 'input'));
                    look(`${key} = ${value}`);
                }
                if (of.check) input.checked = of.value;
                else input.value = of.value;
                input.dispatchEvent(new Event(of.check || of.options ? 'change' : 'input'));
            }
            if (experiment.handles) {
                const [x, y] = this.handles()[0];
                this.target = [x + 0.21, y + 0.13];
                this.move(0);
                look('the first handle moved');
            }
            return { name: this.name, cases, startedAt: this.startedAt, width: this.figure.scrollWidth, room: this.figure.clientWidth };
        }
    }

    function tooWide() {
        return Math.max(0, document.documentElement.scrollWidth - home.innerWidth);
    }

    async function begin() {
        const figures = [...document.querySelectorAll('figure.live')];
        if (!figures.length) return;
        const live = [];
        for (const figure of figures) {
            const experiment = experiments[figure.dataset.trace];
            let module = null;
            try {
                module = experiment && (await theEngine());
            } catch (error) {
                figure.dataset.why = error.message;
            }
            if (!module) {
                if (figure.dataset.recorded !== 'no') load(`traces/${figure.dataset.trace}.js`).then(() => home.FlyingRecording.start(figure), () => {});
                continue;
            }
            const made = new Figure(figure, experiment, module);
            made.startedAt = performance.now();
            live.push(made);
        }
        home.flyingFigures = live;
        if (asked.has('steps'))
            for (const figure of live) {
                figure.go(Number(asked.get('steps')) * FRAME);
                figure.draw();
            }
        if (asked.has('check')) {
            const report = { figures: live.map((figure) => figure.check()), waiting: figures.length - live.length, tooWide: tooWide(), troubles };
            document.body.append(make('script', { type: 'application/json', id: 'live-check' }, JSON.stringify(report)));
        }
        document.documentElement.dataset.live = 'ready';
    }

    if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', begin);
    else begin();
})(globalThis);
