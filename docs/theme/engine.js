// The engine itself, compiled to WebAssembly (src/live), as objects of JavaScript. Works in a page and in Node.
//
//   const engine = await FlyingEngine.load(bytes);
//   const run = engine.open(text, {engine: 'auto', step: 1 / 60});   // throws FlyingError: the scene's faults, a line each
//   run.advance(2.5);                                                // throws FlyingError where the run has to stop
//   for (const [x, y, angle] of run.states()) ...
//   run.close();
'use strict';

(function (home) {
    const THERE = 0;
    const ON_THE_WAY = 1;
    const ENGINES = ['auto', 'events', 'rest'];
    const MOVERS = ['nothing', 'events', 'rest', 'asleep'];
    const NUMBERS_OF_A_STATE = 6;

    class FlyingError extends Error {}

    // The module's C library asks for files and a clock, which it doesn't get: every such call fails with "no such function"
    function refusals(module) {
        const imports = {};
        for (const { module: from, name } of WebAssembly.Module.imports(module)) {
            imports[from] = imports[from] || {};
            imports[from][name] = () => 52;
        }
        return imports;
    }

    class FlyingRun {
        constructor(engine, pointer) {
            this.engine = engine;
            this.module = engine.module;
            this.pointer = pointer;
            if (!this.module.is_ready(pointer)) {
                const faults = this.message();
                this.close();
                throw new FlyingError(faults);
            }
        }

        // What is wrong, a line each; empty where nothing is
        message() {
            return this.engine.text(this.module.message_data(this.pointer), this.module.message_size(this.pointer)).trimEnd();
        }

        // Move on to a time, or as far as that many events or steps lead; true when there
        advance(time, most = Infinity) {
            const bound = Math.max(1, Math.min(most, 0x7fffffff));
            const end = this.module.advance(this.pointer, time, bound);
            if (end !== THERE && end !== ON_THE_WAY) throw new FlyingError(this.message());
            return end === THERE;
        }

        get time() { return this.module.time(this.pointer); }
        get until() { return this.module.until(this.pointer); }
        get bodyCount() { return this.module.body_count(this.pointer); }
        get events() { return this.module.events(this.pointer); }
        get collisions() { return this.module.collisions(this.pointer); }
        get energy() { return this.module.energy(this.pointer); }
        // Of all that happened and of where it led; of all that happened: sixteen hexadecimal digits
        get hash() { return digits(this.module.hash(this.pointer)); }
        get logHash() { return digits(this.module.log_hash(this.pointer)); }

        // What the plan skips: {name, kind, isActive, saved, unit, reason} each
        plan() {
            return this.engine.take(this.module.plan_text(this.pointer)).trimEnd().split('\n').map((line) => {
                const [name, kind, active, saved, unit, reason] = line.split('\t');
                return { name, kind, isActive: active === '1', saved: Number(saved), unit, reason };
            });
        }

        // Give a body another velocity, now; false where that can't be done
        steer(body, vx, vy) { return this.module.steer(this.pointer, body, vx, vy) === 1; }

        // 'nothing', 'events', 'rest' or 'asleep'
        mover(body) { return MOVERS[this.module.mover(this.pointer, body)]; }

        isStatic(body) { return this.module.is_static(this.pointer, body) === 1; }

        // Of each body [x, y, angle, velocity along x, along y, spin]
        states() {
            const numbers = this.engine.numbers(this.module.states(this.pointer), NUMBERS_OF_A_STATE * this.bodyCount);
            const states = [];
            for (let k = 0; k < numbers.length; k += NUMBERS_OF_A_STATE) states.push(numbers.slice(k, k + NUMBERS_OF_A_STATE));
            return states;
        }

        // {radius} or {rings: [[[x, y], ...], ...]} about the body's centre of mass
        shape(body) {
            const size = this.module.outline_size(this.pointer, body);
            const numbers = this.engine.numbers(this.module.outline_data(this.pointer, body), size);
            if (numbers[0] === 0) return { radius: numbers[1] };
            const rings = [];
            for (let k = 0; k < numbers.length;) {
                const count = numbers[k++];
                const ring = [];
                for (let vertex = 0; vertex < count; ++vertex, k += 2) ring.push([numbers[k], numbers[k + 1]]);
                rings.push(ring);
            }
            return { rings };
        }

        // [left, bottom, right, top], or null where there is no box
        box() {
            const pointer = this.module.box(this.pointer);
            return pointer ? this.engine.numbers(pointer, 4) : null;
        }

        close() {
            this.module.close_run(this.pointer);
            this.pointer = 0;
        }
    }

    function digits(hash) {
        return BigInt.asUintN(64, hash).toString(16).padStart(16, '0');
    }

    class FlyingEngine {
        constructor(instance) {
            this.module = instance.exports;
            this.module._initialize();
        }

        // From the bytes of the module
        static async load(bytes) {
            const module = await WebAssembly.compile(bytes);
            return new FlyingEngine(await WebAssembly.instantiate(module, refusals(module)));
        }

        // A run of a scene, a text of TOML
        open(scene, { engine = 'auto', step = 0, without = [] } = {}) {
            if (!ENGINES.includes(engine)) throw new FlyingError(`no engine '${engine}' (there are: ${ENGINES.join(', ')})`);
            const skips = this.skips();
            const unknown = without.find((name) => !skips.includes(name));
            if (unknown) throw new FlyingError(`no skip '${unknown}' (there are: ${skips.join(', ')})`);
            const bits = without.reduce((sum, name) => sum | (1 << skips.indexOf(name)), 0);
            const pointer = this.give(scene, (data, size) => this.module.open_run(data, size, ENGINES.indexOf(engine), step, bits));
            return new FlyingRun(this, pointer);
        }

        // A scene as text, from the words behind `flying generate`
        generate(words) {
            const answer = this.give(words, (data, size) => this.module.generate(data, size));
            const isGood = this.module.text_is_good(answer);
            const text = this.take(answer);
            if (!isGood) throw new FlyingError(text.trimEnd());
            return text;
        }

        // Names of the skips that `open` may be told to leave inactive
        skips() {
            this.skipNames = this.skipNames || this.take(this.module.skips()).trimEnd().split('\n');
            return this.skipNames;
        }

        // A piece of the engine by its name, with the numbers it wants: {engine, paper, hash}
        ask(name, numbers) {
            const bytes = new TextEncoder().encode(name);
            const pointer = this.module.take_memory(bytes.length + 8 * numbers.length + 8);
            if (!pointer) throw new FlyingError('no room for what was asked');
            const words = pointer + 8 * numbers.length;
            new Float64Array(this.module.memory.buffer, pointer, numbers.length).set(numbers);
            new Uint8Array(this.module.memory.buffer, words, bytes.length).set(bytes);
            const answer = this.module.ask(words, bytes.length, pointer, numbers.length);
            this.module.give_memory_back(pointer);
            const isGood = this.module.answer_is_good(answer);
            const all = isGood ? this.numbers(this.module.answer_data(answer), this.module.answer_size(answer)) : [];
            const hash = digits(this.module.answer_hash(answer));
            this.module.drop_answer(answer);
            if (!isGood) throw new FlyingError(`the engine can't answer '${name}' with ${numbers.length} numbers`);
            const count = all[0];
            return { engine: all.slice(1, 1 + count), paper: all.slice(1 + count), hash };
        }

        // The words of a text that the module made
        take(made) {
            const text = this.text(this.module.text_data(made), this.module.text_size(made));
            this.module.drop_text(made);
            return text;
        }

        // The memory moves when it grows, so every look at it is a new one
        numbers(pointer, count) {
            return Array.from(new Float64Array(this.module.memory.buffer, pointer, count));
        }

        text(pointer, size) {
            return new TextDecoder().decode(new Uint8Array(this.module.memory.buffer, pointer, size));
        }

        // Lend the module a text for the time of a call
        give(text, call) {
            const bytes = new TextEncoder().encode(text);
            const pointer = this.module.take_memory(bytes.length || 1);
            if (!pointer) throw new FlyingError(`no room for ${bytes.length} bytes of text`);
            new Uint8Array(this.module.memory.buffer, pointer, bytes.length).set(bytes);
            try {
                return call(pointer, bytes.length);
            } finally {
                this.module.give_memory_back(pointer);
            }
        }
    }

    home.FlyingEngine = FlyingEngine;
    home.FlyingError = FlyingError;
})(globalThis);
