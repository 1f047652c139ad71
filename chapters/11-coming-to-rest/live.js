// The live figures of this chapter: a ball that hops to rest, the forces in a column after some sweeps, a box on a slope, a stack.
'use strict';

(function () {
    const { short } = FlyingStage;
    const STEPS = [['1/30', '1/30 s'], ['1/60', '1/60 s'], ['1/120', '1/120 s'], ['1/240', '1/240 s'], ['1/960', '1/960 s']];
    const seconds = (text) => 1 / Number(text.slice(2));

    flyingLive('11-coming-to-rest/zeno', {
        controls: {
            e: { label: 'restitution', min: 0, max: 0.9, step: 0.05, value: 0.7 },
            height: { label: 'height', min: 0.2, max: 1.6, step: 0.1, value: 1, unit: 'm' },
            step: { label: 'length of a step', options: STEPS, value: '1/60' },
            engine: { label: 'moved', options: [['rest', 'by steps'], ['auto', 'event by event, then handed over']], value: 'rest' }
        },
        view: [-3, -0.3, 3, 2.8],
        until: 5,
        scene: (p) => ({ engine: p.engine, step: seconds(p.step), text: flyingScene({ gravity: [0, -9.81], restitution: p.e,
            bodies: [{ disc: 0.5, at: [0, 0.5 + p.height] }, { rectangle: [6, 1], at: [0, -0.5], fixed: true }] }) }),
        setup: (p, ask) => ({ ask, end: ask('hop', [p.height, p.e, 0]).engine[1] }),
        draw: (stage, t, s, p, run) => {
            stage.floor(0);
            const [ball] = run.states();
            stage.body({ radius: 0.5 }, ball, { colour: stage.colour(1) });
            stage.ghost({ radius: 0.5 }, [0, 0.5 + s.ask('hop', [p.height, p.e, t]).engine[0]]);
        },
        readout: (t, s, p, run) => [['closed form: at rest after', s.end.toFixed(3) + ' s'], ['moved by', run.mover(0)],
            ['height above the floor', short(run.states()[0][1] - 0.5) + ' m']],
        legend: [['body', 1, 'the engine\u2019s ball'], ['ghost', 'ink', 'closed form']],
        strip: { label: 'distance from the closed form, in metres', colour: 1,
            value: (t, s, p, run) => Math.abs(run.states()[0][1] - 0.5 - s.ask('hop', [p.height, p.e, t]).engine[0]) }
    });

    // Beside each contact a bar, as long as the force that the sweeps have found there, and the outline of what it has to bear
    const BARS = 1.6;
    const share = (x) => (x >= 0.9995 ? '100 %' : x >= 0.001 ? (100 * x).toFixed(1) + ' %' : short(x));
    flyingLive('11-coming-to-rest/column', {
        still: true,
        controls: {
            sweeps: { label: 'sweeps', min: 0, max: 300, step: 1, value: 8 },
            boxes: { label: 'boxes', min: 1, max: 20, step: 1, value: 8 },
            top: { label: 'top box heavier', min: 1, max: 100, step: 1, value: 1, unit: '×' }
        },
        tallest: 420,
        view: (p) => [-1, -0.9, 2 + BARS + 1.1 * p.boxes, p.boxes + 0.3],
        setup: (p, ask) => {
            const [error, left, inTheEnd, ...forces] = ask('column', [p.boxes, p.top, p.sweeps]).engine;
            return { error, left, inTheEnd, found: forces.slice(0, p.boxes), due: forces.slice(p.boxes) };
        },
        draw: (stage, t, s, p) => {
            stage.floor(0);
            const length = (force) => (1.1 * p.boxes * force) / s.due[0];
            s.due.forEach((due, k) => {
                const isTop = k + 1 === p.boxes;
                stage.body({ rings: [[[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]]] }, [0, k + 0.5],
                    { colour: stage.colour(isTop && p.top > 1 ? 1 : 0) });
                const bar = (force) => [[BARS, k - 0.26], [BARS + length(force), k - 0.26], [BARS + length(force), k + 0.26], [BARS, k + 0.26]];
                stage.line([[0.62, k], [BARS - 0.12, k]], stage.soft, { width: 1, dash: [2, 4] });
                stage.area(bar(s.found[k]), stage.colour(2), 0.85);
                stage.line([...bar(due), bar(due)[0]], stage.ink, { width: 1.4, dash: [4, 3] });
            });
        },
        readout: (t, s, p) => {
            const rows = [['worst error of a force', share(s.error)], ['one more sweep leaves of it', share(s.left)]];
            if (s.inTheEnd >= 0) rows.push(['in the long run, closed form', share(s.inTheEnd)]);
            rows.push(['under the lowest box', `${short(s.found[0])} of ${s.due[0]} weights of a box`]);
            return rows;
        },
        legend: [['line', 2, 'force found so far'], ['ghost', 'ink', 'weight to bear']]
    });

    flyingLive('11-coming-to-rest/slope', {
        controls: {
            slope: { label: 'slope', min: 0, max: 60, step: 1, value: 25, unit: '°' },
            mu: { label: 'friction', min: 0, max: 1.2, step: 0.02, value: 0.4 },
            step: { label: 'length of a step', options: STEPS, value: '1/60' }
        },
        view: [-2, -4, 7.4, 1.6],
        until: 2.5,
        // The scene lies flat and gravity leans; the picture is turned
        scene: (p, module, kept, ask) => {
            const [along, across] = ask('slide', [9.81, (p.slope * Math.PI) / 180, p.mu, 0]).engine;
            return { engine: 'rest', step: seconds(p.step), text: flyingScene({ gravity: [along, -across], restitution: 0, friction: p.mu,
                bodies: [{ rectangle: [1, 0.6], at: [0, 0.3] }, { rectangle: [80, 1], at: [30, -0.5], fixed: true }] }) };
        },
        setup: (p, ask) => ({ ask, angle: (p.slope * Math.PI) / 180 }),
        draw: (stage, t, s, p, run) => {
            const [c, d] = [Math.cos(s.angle), Math.sin(s.angle)];
            const turned = ([x, y, angle]) => [c * x + d * y, c * y - d * x, angle - s.angle];
            stage.body(run.shapes[1], turned([30, -0.5, 0]), { isFixed: true });
            const box = { rings: [[[-0.5, -0.3], [0.5, -0.3], [0.5, 0.3], [-0.5, 0.3]]] };
            stage.body(box, turned(run.states()[0]), { colour: stage.colour(0) });
            stage.ghost(box, turned([s.ask('slide', [9.81, s.angle, p.mu, t]).engine[2], 0.3, 0]));
        },
        readout: (t, s, p, run) => {
            const way = s.ask('slide', [9.81, s.angle, p.mu, t]).engine[2];
            return [['tangent of the slope', short(Math.tan(s.angle))], ['friction', short(p.mu)],
                ['so it', Math.tan(s.angle) > p.mu ? 'slides' : 'stays'], ['slid', short(run.states()[0][0]) + ' m'],
                ['closed form', short(way) + ' m']];
        },
        legend: [['body', 0, 'the engine\u2019s box'], ['ghost', 'ink', 'closed form']],
        strip: { label: 'distance from the closed form, in metres', colour: 1,
            value: (t, s, p, run) => Math.abs(run.states()[0][0] - s.ask('slide', [9.81, s.angle, p.mu, t]).engine[2]) }
    });

    flyingLive('11-coming-to-rest/topple', {
        controls: {
            boxes: { label: 'boxes', min: 1, max: 12, step: 1, value: 6 },
            speed: { label: 'speed of the ball', min: 0, max: 16, step: 0.5, value: 7.5, unit: 'm/s' },
            top: { label: 'top box heavier', min: 1, max: 200, step: 1, value: 1, unit: '×' },
            mu: { label: 'friction', min: 0, max: 1, step: 0.05, value: 0.5 },
            step: { label: 'length of a step', options: STEPS, value: '1/60' },
            warm: { label: 'warm start', check: true, value: true }
        },
        view: (p) => [-7, -0.6, 11, Math.max(7, p.boxes + 1)],
        until: 8,
        scene: (p) => {
            const bodies = Array.from({ length: p.boxes }, (_, k) => ({ rectangle: [1, 1], at: [0, k + 0.5], mass: k + 1 === p.boxes ? p.top : 1 }));
            if (p.speed > 0) bodies.push({ disc: 0.5, at: [-5, Math.max(0.6, p.boxes / 2)], velocity: [0.9 * p.speed, 0.44 * p.speed], mass: 2 });
            bodies.push({ rectangle: [60, 1], at: [0, -0.5], fixed: true });
            return { engine: 'rest', step: seconds(p.step), without: p.warm ? [] : ['warm-start'], text: flyingScene({ gravity: [0, -9.81], restitution: 0.2, friction: p.mu, bodies }) };
        },
        draw: (stage, t, s, p, run) => {
            stage.floor(0);
            run.states().forEach((state, k) => {
                if (run.isStatic(k)) return;
                const isAsleep = run.mover(k) === 'asleep' || (state[3] === 0 && state[4] === 0 && state[5] === 0);
                stage.body(run.shapes[k], state, { colour: stage.colour(k), alpha: isAsleep ? 0.35 : 0.85 });
            });
        },
        readout: (t, s, p, run) => [['steps made', String(run.events)],
            ['bodies that lie still', `${run.states().filter((state, k) => !run.isStatic(k) && state[3] === 0 && state[4] === 0 && state[5] === 0).length} of ${run.bodyCount - 1}`]],
        legend: [['body', 0, 'moves'], ['body', 'fixed', 'pale: lies still, and no bit changes']],
        strip: { label: 'energy, in joules', value: (t, s, p, run) => run.energy }
    });
})();
