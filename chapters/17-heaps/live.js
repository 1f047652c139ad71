// The live figure of this chapter: bodies that fall into a pit.
'use strict';

(function () {
    const STEPS = [['1/30', '1/30 s'], ['1/60', '1/60 s'], ['1/120', '1/120 s'], ['1/240', '1/240 s']];
    const seconds = (text) => 1 / Number(text.slice(2));

    // Numbers that look random and are the same every time
    const mixed = (k) => (Math.imul(k + 1, 2654435761) >>> 0) / 2 ** 32;
    const lies = (state) => state[3] === 0 && state[4] === 0 && state[5] === 0;

    flyingLive('17-heaps/pour', {
        controls: {
            count: { label: 'bodies', min: 10, max: 150, step: 10, value: 80 },
            kind: { label: 'shapes', options: [['discs', 'discs'], ['boxes', 'boxes'], ['both', 'discs and boxes']], value: 'both' },
            mu: { label: 'friction', min: 0, max: 1, step: 0.05, value: 0.5 },
            e: { label: 'restitution', min: 0, max: 0.8, step: 0.05, value: 0.1 },
            heavy: { label: 'every tenth heavier', min: 1, max: 100, step: 1, value: 1, unit: '×' },
            step: { label: 'length of a step', options: STEPS, value: '1/60' }
        },
        view: (p) => [-6, -0.5, 6, Math.max(8, 1.2 * Math.ceil(p.count / 10) + 1)],
        until: 8,
        scene: (p) => {
            const bodies = Array.from({ length: p.count }, (_, k) => {
                const at = [-4.6 + 1.02 * (k % 10) + 0.06 * mixed(2 * k), 0.6 + 1.15 * Math.floor(k / 10)];
                const isDisc = p.kind === 'discs' || (p.kind === 'both' && k % 2 === 0);
                const size = 0.3 + 0.18 * mixed(2 * k + 1);
                const mass = size * size * (k % 10 === 0 ? p.heavy : 1);
                return isDisc ? { disc: size, at, mass } : { rectangle: [1.6 * size, 1.2 * size], at, mass };
            });
            bodies.push({ rectangle: [14, 1], at: [0, -0.5], fixed: true });
            for (const side of [-1, 1]) bodies.push({ rectangle: [1, 60], at: [5.7 * side, 30], fixed: true });
            return { engine: 'rest', step: seconds(p.step), text: flyingScene({ gravity: [0, -9.81], restitution: p.e, friction: p.mu, bodies }) };
        },
        draw: (stage, t, s, p, run) => {
            run.states().forEach((state, k) => {
                if (run.isStatic(k)) stage.body(run.shapes[k], state, { isFixed: true });
                else stage.body(run.shapes[k], state, { colour: stage.colour(k % 10 === 0 && p.heavy > 1 ? 1 : 0), alpha: lies(state) ? 0.35 : 0.85 });
            });
        },
        readout: (t, s, p, run) => [['steps made', String(run.events)],
            ['bodies that lie still', `${run.states().filter((state, k) => !run.isStatic(k) && lies(state)).length} of ${p.count}`]],
        legend: [['body', 0, 'moves'], ['body', 1, 'made heavier'], ['body', 'fixed', 'pale: lies still, and no bit changes']],
        strip: { label: 'energy, in joules', value: (t, s, p, run) => run.energy }
    });
})();
