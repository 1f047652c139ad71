// The live figures of this chapter: a run with a skip turned off beside one with it, and the spoilt bound.
'use strict';

(function () {
    const SCENES = [['gas --count 60 --seed 3 --until 1000', 'discs'], ['gas --shape polygon --count 24 --seed 4 --until 1000', 'polygons'],
        ['cradle --until 1000', 'a cradle']];

    flyingLive('12-skipping-work/skips', {
        controls: {
            scene: { label: 'scene', options: SCENES, value: SCENES[0][0] },
            off: { label: 'turned off on the right', options: (module) => module.skips().map((name) => [name, name]), value: 'grid' }
        },
        view: (p, s, run) => { const [left, bottom, right, top] = s.room; return [left - 0.2, bottom - 0.2, 2 * right - left + 1.4, top + 0.12 * (top - bottom)]; },
        scene: (p, module) => ({ engine: 'events', text: module.generate(p.scene) }),
        setup: (p, ask, run, kept, module) => {
            if (kept.other) kept.other.close();
            kept.other = module.open(module.generate(p.scene), { engine: 'events', without: [p.off] });
            const states = run.states();
            const room = run.box() || [Math.min(...states.map(([x]) => x)) - 2, Math.min(...states.map(([, y]) => y)) - 2,
                Math.max(...states.map(([x]) => x)) + 2, Math.max(...states.map(([, y]) => y)) + 2];
            return { other: kept.other, room };
        },
        start: () => ({ other: null }),
        frame: (t, s) => { s.other.advance(t); },
        draw: (stage, t, s, p, run) => {
            const [left, bottom, right, top] = s.room;
            const shift = right - left + 1;
            stage.walls(s.room);
            stage.walls([left + shift, bottom, right + shift, top]);
            stage.words([(left + right) / 2, top + 0.06 * (top - bottom)], 'with all skips', { align: 'center', size: 13, colour: stage.soft });
            stage.words([(left + right) / 2 + shift, top + 0.06 * (top - bottom)], 'without ' + p.off, { align: 'center', size: 13, colour: stage.soft });
            for (const [of, by] of [[run, 0], [s.other, shift]])
                of.states().forEach(([x, y, angle], k) => stage.body(run.shapes[k], [x + by, y, angle], { colour: stage.colour(k), isFixed: run.isStatic(k) }));
        },
        legend: [['body', 0, 'a body, in the same colour on both sides']],
        strip: { label: 'distance between the two runs, in metres', colour: 1, value: (t, s, p, run) => {
            const others = s.other.states();
            return run.states().reduce((sum, [x, y], k) => sum + Math.hypot(x - others[k][0], y - others[k][1]), 0);
        } },
        readout: (t, s, p, run) => {
            const skip = run.plan().find((one) => one.name === p.off);
            return [['log on the left', run.logHash], ['log on the right', s.other.logHash],
                ['the same bits', run.logHash === s.other.logHash ? 'yes' : 'NO'],
                [`${p.off} on the left`, skip.isActive ? `saved ${skip.saved} ${skip.unit}` : 'not active here: ' + skip.reason]];
        }
    });

    flyingLive('12-skipping-work/hexagons', {
        controls: { seed: { label: 'start', min: 1, max: 200, step: 1, value: 121, show: (n) => 'number ' + n } },
        view: [-0.1, -0.1, 6.1, 6.1],
        until: 6,
        checkTime: 3,
        setup: (p, ask) => ({ places: ask('hexagons', [p.seed, 6]).engine }),
        draw: (stage, t, s) => {
            const at = 54 * Math.min(Math.round(60 * t), s.places.length / 54 - 1);
            const shape = { rings: [Array.from({ length: 6 }, (_, k) => [0.5 * Math.cos((k * Math.PI) / 3), 0.5 * Math.sin((k * Math.PI) / 3)])] };
            stage.walls([0, 0, 6, 6]);
            for (let k = 0; k < 9; ++k) stage.body(shape, s.places.slice(at + 3 * k, at + 3 * k + 3), { colour: stage.colour(k) });
            for (let k = 9; k < 18; ++k) stage.ghost(shape, s.places.slice(at + 3 * k, at + 3 * k + 3));
        },
        legend: [['body', 0, 'by the spoilt bound'], ['ghost', 'ink', 'by the right one']],
        strip: { label: 'distance between the two, on average, in metres', colour: 1, value: (t, s) => {
            const at = 54 * Math.min(Math.round(60 * t), s.places.length / 54 - 1);
            let sum = 0;
            for (let k = 0; k < 9; ++k)
                sum += Math.hypot(s.places[at + 3 * k] - s.places[at + 27 + 3 * k], s.places[at + 3 * k + 1] - s.places[at + 28 + 3 * k]) / 9;
            return sum;
        } }
    });
})();
