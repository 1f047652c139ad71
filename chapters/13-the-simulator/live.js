// The live figure of this chapter: polygons that change hands between the two integrators.
'use strict';

(function () {
    const { short } = FlyingStage;
    const STEPS = [['1/30', '1/30 s'], ['1/60', '1/60 s'], ['1/120', '1/120 s'], ['1/240', '1/240 s']];
    const COLOURS = { events: 0, rest: 1, asleep: 7 };
    const seconds = (text) => 1 / Number(text.slice(2));
    const movers = (run) => Array.from({ length: run.bodyCount }, (_, k) => run.mover(k));

    flyingLive('13-the-simulator/two', {
        controls: {
            count: { label: 'polygons', min: 2, max: 60, step: 1, value: 24 },
            e: { label: 'restitution', min: 0, max: 0.9, step: 0.05, value: 0.4 },
            mu: { label: 'friction', min: 0, max: 1, step: 0.05, value: 0.5 },
            g: { label: 'gravity', min: 0, max: 20, step: 0.5, value: 10, unit: 'm/s\u00b2' },
            step: { label: 'length of a step', options: STEPS, value: '1/60' },
            seed: { label: 'start', min: 1, max: 50, step: 1, value: 5, show: (n) => 'number ' + n }
        },
        view: (p, s, run) => { const [left, bottom, right, top] = run.box(); return [left - 0.2, bottom - 0.2, right + 0.2, top + 0.2]; },
        until: 12,
        checkTime: 2,
        scene: (p, module) => ({ step: seconds(p.step), text: module.generate(
            `polygons --count ${p.count} --seed ${p.seed} --packing 0.12 --gravity 0 ${-p.g} --restitution ${p.e} --friction ${p.mu} --speed 1 3`) }),
        draw: (stage, t, s, p, run) => {
            stage.walls(run.box());
            run.states().forEach((state, k) => {
                const mover = run.mover(k);
                stage.body(run.shapes[k], state, { colour: stage.colour(COLOURS[mover]), alpha: mover === 'asleep' ? 0.5 : 0.85 });
            });
        },
        grab: true,
        readout: (t, s, p, run) => {
            const all = movers(run);
            const count = (kind) => String(all.filter((mover) => mover === kind).length);
            return [['fly', count('events')], ['moved by steps', count('rest')], ['asleep', count('asleep')],
                ['impacts', String(run.collisions)], ['energy', short(run.energy) + ' J']];
        },
        legend: [['body', 0, 'flies from impact to impact'], ['body', 1, 'is moved by steps'], ['body', 7, 'sleeps']],
        strip: { label: 'how many are moved by steps', colour: 1, value: (t, s, p, run) => movers(run).filter((mover) => mover === 'rest').length }
    });
})();
