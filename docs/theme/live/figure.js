// Live figures: an experiment with controls, on the engine itself. A chapter's live.js registers its experiments:
//
//   flyingLive('07-impulse/strike', {
//       controls: {e: {label: 'restitution', min: 0, max: 1, step: 0.05, value: 1}},
//       view: [-1, -1, 1, 1],                   // or a function of the controls' values
//       tallest: 640,                           // optional: of the picture [px]
//       until: 3,                               // [s], or a function; without it the experiment goes on for ever
//       scene: (p) => toml,                     // optional: what a run is opened with; or {text, engine, step, without}
//       setup: (p, ask, run, kept) => state,    // ask(name, numbers) is a piece of the engine: {engine, paper}
//       frame: (t, state, p, run) => {},        // optional: after each move in time
//       next: (t, state, p, run) => t,          // optional: where the button for one step leads
//       draw: (stage, t, state, p, run) => {},
//       readout: (t, state, p, run) => [['impulse', '1.2 N s']],
//       legend: [['body', 0, 'the ball'], ['ghost', 'ink', 'closed form'], ['line', 1, 'path']], // also dashes, dot, arrow
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
    const { Stage, Strip } = home.FlyingStage;
    const { make, knob, sign } = home.FlyingControls;
    const FRAME = 1 / 60;
    const MOST_STRIDES = 400;
    const BITE = 400; // events or steps between two looks at the clock, at most
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

    // The module, once a page: base64 of LZMA, since file:// lets scripts in and nothing else
    function theEngine() {
        engine = engine || (async () => {
            if (asked.get('engine') === 'off') throw new Error('the engine is switched off');
            await load('live/module.js');
            return home.FlyingEngine.load(home.FlyingUnpack(Uint8Array.from(atob(home.flyingModule), (letter) => letter.charCodeAt(0))));
        })();
        return engine;
    }

    class Figure {
        constructor(figure, experiment, module) {
            Object.assign(this, { figure, experiment, module, time: 0, isPlaying: false, wantsToPlay: false, asks: [], most: 1, sought: null, ticks: 0 });
            this.name = figure.dataset.trace;
            this.p = {};
            this.kept = experiment.start ? experiment.start() : null;
            this.canvas = figure.querySelector('canvas');
            this.stage = new Stage(this.canvas, [0, 0, 1, 1]);
            if (experiment.tallest) this.stage.tallest = experiment.tallest;
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
                this.playButton = make('button', { type: 'button', class: 'play', 'aria-label': 'Play' }, '\u25b6');
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
                    this.slider.oninput = () => this.seek(this.slider.value * this.until());
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
            this.sought = null;
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
            this.deadline = whole ? Infinity : performance.now() + PATIENCE;
            const end = this.until();
            const wanted = Math.min(time, end);
            try {
                if (this.run) {
                    if (wanted < this.time) {
                        this.open();
                        this.time = 0;
                        this.set();
                        this.trails = [];
                        if (this.strip) this.strip.clear();
                    }
                } else if (wanted < this.time) {
                    this.trails = [];
                    if (this.strip) this.strip.clear();
                    this.time = 0;
                }

                // A leap is made in strides, so that trails and strips have no gaps
                const strides = Math.min(MOST_STRIDES, Math.ceil((wanted - this.time) / (2 * FRAME)) || 1);
                const start = this.time;
                this.isLate = false;
                for (let stride = 1; stride <= strides && !this.isLate; ++stride)
                    this.walk(stride < strides ? start + ((wanted - start) * stride) / strides : wanted);
                if (this.time >= end) this.play(false);
            } catch (error) {
                this.fail(error);
            }
        }

        walk(time) {
            if (this.run) {
                let isThere = this.bite(time);
                while (!isThere && performance.now() < this.deadline) isThere = this.bite(time);
                this.time = isThere ? time : Math.max(this.time, this.run.time);
            } else {
                this.time = time;
            }
            this.isLate = this.time < time || performance.now() > this.deadline;
            this.note();
        }

        // So many events or steps as take a part of a frame; true when the run is there
        bite(time) {
            const start = performance.now();
            const isThere = this.run.advance(time, this.most);
            const passed = performance.now() - start;
            if (passed > PATIENCE / 2) this.most = Math.max(1, this.most >> 2);
            else if (passed < PATIENCE / 8) this.most = Math.min(BITE, 2 * this.most);
            return isThere;
        }

        // Where the slider leads: at once, or in as many frames as it takes, so that the page never stands still
        seek(time) {
            this.play(false);
            const isOnTheWay = this.sought !== null;
            this.sought = time;
            if (isOnTheWay) return;
            const go = () => {
                if (this.sought === null) return;
                this.go(this.sought, false);
                const isDone = this.isFailed || this.time >= Math.min(this.sought, this.until());
                if (isDone) this.sought = null;
                this.draw();
                if (!isDone) requestAnimationFrame(go);
            };
            go();
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
            this.sought = null;
            let before = performance.now();
            const own = ++this.ticks; // one that was paused and began again ticks no longer
            const tick = (now) => {
                if (!this.isPlaying || own !== this.ticks) return;
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
                    this.wantsToPlay = this.wantsToPlay || this.isPlaying;
                    this.play(false);
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
                    const of = sign(kind);
                    of.style.color = colour === 'ink' ? '' : colour === 'fixed' ? 'var(--live-soft)' : typeof colour === 'string' ? colour : stage.colour(colour);
                    this.legend.append(make('span', {}, of, text));
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
            this.clock.textContent = this.time.toFixed(2) + ' s' + (this.sought !== null ? ' (on its way)' : this.isPlaying && this.isLate ? ' (slower than the clock)' : '');
            if (this.slider && this.sought === null) this.slider.value = this.time / this.until();
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

    }

    Object.assign(Figure.prototype, home.FlyingHands, home.FlyingCheck);

    function tooWide() {
        return Math.max(0, document.documentElement.scrollWidth - home.innerWidth);
    }

    async function begin() {
        const figures = [...document.querySelectorAll('figure.live')];
        if (!figures.length) return;
        const live = [];
        const opened = performance.now();
        for (const figure of figures) {
            const experiment = experiments[figure.dataset.trace];
            let module = null;
            try {
                module = experiment && (await theEngine());
            } catch (error) {
                figure.dataset.why = error.message;
            }
            if (!module) {
                if (figure.dataset.recorded !== 'no') {
                    load(`traces/${figure.dataset.trace}.js`).then(() => home.FlyingRecording.start(figure), () => {});
                } else if (figure.dataset.still) {
                    const canvas = figure.querySelector('canvas');
                    canvas.before(make('img', { class: 'still', src: figure.dataset.still, alt: canvas.getAttribute('aria-label') }));
                } else {
                    figure.querySelector('canvas').replaceWith(make('p', { class: 'fault', role: 'alert' }, `The engine can't run here: ${figure.dataset.why}.`));
                }
                continue;
            }
            const made = new Figure(figure, experiment, module);
            made.startedAt = performance.now() - opened;
            live.push(made);
        }
        home.flyingFigures = live;
        document.fonts.ready.then(() => live.forEach((figure) => figure.draw()));
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

    if (document.readyState !== 'complete') document.addEventListener('DOMContentLoaded', begin);
    else begin();
})(globalThis);
