// The engine as pages use it: docs/theme/engine.js on the module of the build that FLYING_WASM_BIN names.
//
//   FLYING_WASM_BIN=build/wasm/bin node --test tests/differential/bits/engine.test.js
'use strict';

const assert = require('node:assert/strict');
const fs = require('node:fs');
const path = require('node:path');
const test = require('node:test');

const bin = path.resolve(process.env.FLYING_WASM_BIN);
require(path.join(bin, 'engine.js'));
const bytes = fs.readFileSync(path.join(bin, 'flying.wasm'));

const FALL = `
until = 1.0
[world]
field = { kind = "uniform", gravity = [0.0, -10.0] }
box = { min = [-5.0, 0.0], max = [5.0, 10.0] }
[[body]]
name = "ball"
shape = { kind = "disc", radius = 0.5 }
position = [0.0, 8.0]
velocity = [1.0, 0.0]
[[body]]
name = "plate"
shape = { kind = "polygon", vertices = [[-1, -1], [1, -1], [1, 1], [-1, 1]], holes = [[[-0.5, -0.5], [0.5, -0.5], [0, 0.5]]] }
position = [3.0, 1.2]
static = true
`;

test('a ball falls as the closed form has it, and what is static stays', async () => {
    const run = (await FlyingEngine.load(bytes)).open(FALL);
    assert.equal(run.until, 1);
    assert.equal(run.bodyCount, 2);
    assert.deepEqual([run.isStatic(0), run.isStatic(1)], [false, true]);
    assert.deepEqual(run.box(), [-5, 0, 5, 10]);
    assert.ok(run.advance(0.5));
    assert.equal(run.time, 0.5);
    const [ball, plate] = run.states();
    assert.deepEqual(ball, [0.5, 6.75, 0, 1, -5, 0]); // exact in binary: 8 - 10 / 2 * 0.25
    assert.deepEqual(plate, [3, 1.2, 0, 0, 0, 0]);
    run.close();
});

test('shapes come out with their rings', async () => {
    const run = (await FlyingEngine.load(bytes)).open(FALL);
    assert.deepEqual(run.shape(0), { radius: 0.5 });
    const { rings } = run.shape(1);
    assert.deepEqual(rings.map((ring) => ring.length), [4, 3]);
    // About the centre of mass: the square's is 0, the hole takes a half of area at y = -1/6 out of four
    const lift = (0.5 * (1 / 6)) / 3.5;
    rings[0].forEach(([x, y]) => {
        assert.equal(Math.abs(x), 1);
        assert.ok(Math.abs(Math.abs(y + lift) - 1) < 1e-15);
    });
    run.close();
});

test('small bites of work lead to the same bits as one', async () => {
    const engine = await FlyingEngine.load(bytes);
    const scene = engine.generate('gas --count 60 --seed 5 --until 3');
    const whole = engine.open(scene);
    assert.ok(whole.advance(3));
    const bitten = engine.open(scene);
    let bites = 1;
    while (!bitten.advance(3, 7)) ++bites;
    assert.ok(bites > 10);
    assert.equal(bitten.hash, whole.hash);
    assert.equal(bitten.logHash, whole.logHash);
    assert.equal(bitten.events, whole.events);
    assert.match(whole.hash, /^[0-9a-f]{16}$/);
    const other = engine.open(engine.generate('gas --count 60 --seed 6 --until 3'));
    other.advance(3);
    assert.notEqual(other.hash, whole.hash);
});

test('energy holds in a gas of elastic discs, and the resting engine makes the steps it is told to', async () => {
    const engine = await FlyingEngine.load(bytes);
    const gas = engine.open(engine.generate('gas --count 40 --seed 8 --until 5'));
    const before = gas.energy;
    gas.advance(5);
    assert.ok(gas.collisions > 0);
    assert.ok(Math.abs(gas.energy / before - 1) < 1e-12);
    const scene = engine.generate('stack --count 3 --seed 9');
    const awake = engine.open(scene, { engine: 'rest', step: 1 / 128, without: ['sleeping'] });
    awake.advance(1);
    assert.equal(awake.events, 128);
    // A stack that sleeps asks for no more steps, and the clock goes on all the same
    const asleep = engine.open(scene, { engine: 'rest', step: 1 / 128 });
    asleep.advance(1);
    assert.equal(asleep.time, 1);
    assert.ok(asleep.events < 16);
    assert.equal(asleep.energy, awake.energy);
});

test('all faults of a scene come back together, and a text that is none does no harm', async () => {
    const engine = await FlyingEngine.load(bytes);
    const bodies = '[[body]]\nshape = { kind = "disc", radius = -1.0 }\nposition = [0, 0]\n[[body]]\nspeed = 3';
    assert.throws(() => engine.open(bodies), (error) => {
        assert.ok(error instanceof FlyingError);
        assert.match(error.message, /^scene:2:\d+: body 0, shape\.radius: found -1/m);
        assert.match(error.message, /^scene:5:1: body 1: found the unknown key "speed"/m);
        return true;
    });
    assert.throws(() => engine.open('\u{1f3b1} = ['), FlyingError);
    assert.throws(() => engine.open(''.padStart(100, '[')), FlyingError);
    assert.throws(() => engine.open(FALL, { engine: 'fast' }), FlyingError);
    assert.throws(() => engine.generate('gas --packing 7'), FlyingError);
    assert.throws(() => engine.generate('gas --colour red'), FlyingError);
    assert.throws(() => engine.generate(''), FlyingError);
    assert.equal(engine.open(FALL).bodyCount, 2);
});

test('runs beside each other do not meet', async () => {
    const engine = await FlyingEngine.load(bytes);
    const first = engine.open(FALL);
    const second = engine.open(FALL);
    first.advance(1);
    assert.deepEqual([first.time, second.time], [1, 0]);
    first.close();
    second.advance(1);
    assert.equal(second.time, 1);
});

test('a skip that is turned off changes no bit, and an unknown one is refused', async () => {
    const engine = await FlyingEngine.load(bytes);
    const scene = engine.generate('gas --count 60 --seed 5 --until 3');
    const runs = [[], ['grid']].map((without) => engine.open(scene, { engine: 'events', without }));
    for (const run of runs) run.advance(3);
    assert.equal(runs[0].logHash, runs[1].logHash);
    const active = runs.map((run) => run.plan().find(({ name }) => name === 'grid').isActive);
    assert.deepEqual(active, [true, false]);
    assert.throws(() => engine.open(scene, { without: ['thinking'] }), FlyingError);
});

test('a steered body goes on with its new velocity, and what is static is not steered', async () => {
    const run = (await FlyingEngine.load(bytes)).open(FALL);
    run.advance(0.5);
    assert.ok(run.steer(0, -2, 1));
    assert.equal(run.time, 0.5);
    run.advance(0.75);
    assert.equal(run.time, 0.75);
    assert.deepEqual(run.states()[0].slice(0, 2), [0, 6.6875]); // 6.75 + 0.25 - 10 / 2 * 0.0625
    assert.ok(!run.steer(1, 1, 1));
    run.close();
});

test('pieces of the engine answer by name, and refuse what they can not answer', async () => {
    const engine = await FlyingEngine.load(bytes);
    const { engine: numbers, hash } = engine.ask('fall', [10, 0.5, 1]);
    assert.deepEqual(numbers, [2.5, 5]); // two steps of half a second: 0 + 5 * 0.5
    assert.match(hash, /^[0-9a-f]{16}$/);
    assert.throws(() => engine.ask('fall', [10]), FlyingError);
    assert.throws(() => engine.ask('fall', [10, NaN, 1]), FlyingError);
    assert.throws(() => engine.ask('nothing', [1, 2, 3]), FlyingError);
});
