// The live figures of this chapter: a throw, balls in a box, an orbit.
'use strict';

(function () {
    const { short } = FlyingStage;
    const METHODS = [['0', 'explicit Euler'], ['1', 'symplectic Euler'], ['2', 'Verlet']];
    const rows = (numbers, size) => Array.from({ length: numbers.length / size }, (_, k) => numbers.slice(k * size, (k + 1) * size));

    flyingLive('01-flying-balls/throw', {
        controls: {
            angle: { label: 'angle', min: 5, max: 85, step: 1, value: 55, unit: '°' },
            speed: { label: 'speed', min: 4, max: 14, step: 0.5, value: 11, unit: 'm/s' },
            g: { label: 'gravity', min: 1.6, max: 20, step: 0.2, value: 9.8, unit: 'm/s²' },
            step: { label: 'length of a step', min: 0.01, max: 0.4, step: 0.01, value: 0.15, unit: 's' },
            method: { label: 'steps by', options: METHODS, value: '0' }
        },
        view: [-0.5, -1.4, 17.5, 7.6],
        until: (p) => Math.max(0.3, (2 * p.speed * Math.sin((p.angle * Math.PI) / 180)) / p.g),
        setup: (p, ask) => {
            const turn = (p.angle * Math.PI) / 180;
            const velocity = [p.speed * Math.cos(turn), p.speed * Math.sin(turn)];
            const until = Math.max(0.3, (2 * velocity[1]) / p.g) + p.step;
            const steps = rows(ask('toss', [...velocity, p.g, p.step, Number(p.method), until]).engine, 5);
            const curve = rows(ask('toss', [...velocity, p.g, 0.01, 2, until]).engine, 5);
            ask('toss', [...velocity, p.g, p.step, Number(p.method), until]);
            return { steps, curve, velocity };
        },
        draw: (stage, t, s) => {
            stage.floor(0);
            const now = s.steps.filter((row) => row[0] <= t + 1e-9);
            const flown = s.curve.filter((row) => row[0] <= t + 1e-9);
            stage.line(s.curve.map((row) => [row[3], row[4]]), stage.colour(0), { width: 1.4, alpha: 0.35 });
            stage.line(flown.map((row) => [row[3], row[4]]), stage.colour(0), { width: 2.4 });
            stage.line(now.map((row) => [row[1], row[2]]), stage.colour(1), { width: 1.8 });
            for (const row of now) {
                stage.line([[row[1], row[2]], [row[3], row[4]]], stage.soft, { width: 1, alpha: 0.7 });
                stage.dot([row[1], row[2]], stage.colour(1), 3.5);
            }
            const last = flown[flown.length - 1];
            stage.body({ radius: 0.22 }, [last[3], last[4]], { colour: stage.colour(0), spoke: false });
            const step = now[now.length - 1];
            stage.body({ radius: 0.22 }, [step[1], step[2]], { colour: stage.colour(1), spoke: false });
            if (t === 0) stage.arrow([0, 0], [s.velocity[0] * 0.25, s.velocity[1] * 0.25], stage.ink);
        },
        readout: (t, s) => {
            const now = s.steps.filter((row) => row[0] <= t + 1e-9).pop();
            return [['steps made', String(Math.round(s.steps.indexOf(now)))], ['off by', short(Math.hypot(now[1] - now[3], now[2] - now[4])) + ' m']];
        },
        legend: [['body', 0, 'closed form'], ['body', 1, 'by steps'], ['line', 'fixed', 'error of each step so far']],
        strip: {
            label: 'distance between the two, in metres', colour: 1,
            value: (t, s) => { const row = s.steps.filter((step) => step[0] <= t + 1e-9).pop(); return Math.hypot(row[1] - row[3], row[2] - row[4]); }
        }
    });

    flyingLive('01-flying-balls/box', {
        controls: {
            count: { label: 'balls', min: 1, max: 40, step: 1, value: 9 },
            g: { label: 'gravity', min: 0, max: 10, step: 0.5, value: 4, unit: 'm/s²' },
            speed: { label: 'speed', min: 0.2, max: 4, step: 0.1, value: 1, unit: '×' }
        },
        view: [-0.1, -0.1, 8.1, 4.6],
        until: 30,
        setup: (p, ask) => ({ at: (t) => rows(ask('box', [p.count, p.g, p.speed, t]).engine.slice(1), 4),
            energy: (t) => ask('box', [p.count, p.g, p.speed, t]).engine[0] }),
        draw: (stage, t, s) => {
            stage.walls([0, 0, 8, 4.5]);
            s.at(t).forEach(([radius, x, y, angle], k) => stage.body({ radius }, [x, y, angle], { colour: stage.colour(k) }));
        },
        trails: (t, s) => s.at(t).map(([, x, y]) => [x, y]),
        trailLength: 50,
        legend: [['line', 0, 'where a ball has just been']],
        readout: (t, s) => [['energy of all, at 1 kg each', s.energy(t).toPrecision(12) + ' J']],
        strip: { label: 'energy, in joules', value: (t, s) => s.energy(t) }
    });

    flyingLive('01-flying-balls/orbits', {
        controls: {
            eccentricity: { label: 'eccentricity', min: 0, max: 0.8, step: 0.05, value: 0.5 },
            steps: { label: 'steps a period', min: 20, max: 1000, step: 20, value: 200 },
            method: { label: 'steps by', options: METHODS, value: '1' }
        },
        view: [-2.7, -1.5, 1.9, 1.5],
        until: 40,
        speed: 2,
        setup: (p, ask) => {
            const answer = ask('orbit', [p.eccentricity, p.steps, 7, Number(p.method)]).engine;
            return { period: answer[0], rows: rows(answer.slice(1), 5), step: answer[0] / p.steps };
        },
        draw: (stage, t, s, p) => {
            const at = Math.min(Math.floor(t / s.step), s.rows.length - 1);
            stage.line(s.rows.slice(0, p.steps + 1).map((row) => [row[2], row[3]]), stage.soft, { width: 1.4, dash: [4, 4] });
            stage.trail(s.rows.slice(Math.max(0, at - 4 * p.steps), at + 1).map((row) => [row[0], row[1]]), stage.colour(1));
            const [x, y, ex, ey] = s.rows[at];
            stage.dot([0, 0], stage.colour(4), 10);
            stage.ghost({ radius: 0.08 }, [ex, ey]);
            stage.body({ radius: 0.08 }, [x, y], { colour: stage.colour(1), spoke: false });
        },
        readout: (t, s) => {
            const row = s.rows[Math.min(Math.floor(t / s.step), s.rows.length - 1)];
            return [['periods', short(t / s.period)], ['off by', short(Math.hypot(row[0] - row[2], row[1] - row[3])) + ' m'],
                ['energy off by', short(100 * row[4]) + ' %']];
        },
        legend: [['body', 1, 'by steps'], ['ghost', 'ink', 'closed form']],
        strip: { label: 'energy, off by a share of its size', colour: 1, value: (t, s) => s.rows[Math.min(Math.floor(t / s.step), s.rows.length - 1)][4] }
    });
})();
