// The live figure of this chapter: error against time, measured on the reader's own machine while it is drawn.
'use strict';

(function () {
    const { short } = FlyingStage;
    const NAMES = ['closed form', 'Euler', 'symplectic Euler', 'Verlet'];
    const COURSES = { box: ['box_race', 'from wall to wall'], orbit: ['orbit_race', 'once round in one flight'] };
    const ROUNDS = 15;
    const LEAST = 3; // a measurement takes so long at least [ms]
    const LOW = -7; // powers of ten: seconds ...
    const HIGH = -1;
    const DECADE = 1.25; // of the drawing, 7.5 wide
    const BOTTOM = -16; // ... and metres
    const TOP = 1;

    const place = (seconds, error) => [DECADE * (Math.log10(seconds) - LOW), 0.4 * (Math.max(Math.log10(error), BOTTOM) - BOTTOM)];
    const quantile = (values, share) => [...values].sort((a, b) => a - b)[Math.floor(share * (values.length - 1) + 0.5)];
    const median = (values) => quantile(values, 0.5);
    const ten = (power) => '10' + String(power).replace(/./g, (c) => ({ '-': '\u207b', 0: '\u2070', 1: '\u00b9', 2: '\u00b2', 3: '\u00b3', 4: '\u2074', 5: '\u2075', 6: '\u2076', 7: '\u2077', 8: '\u2078', 9: '\u2079' }[c]));

    function entries() {
        const all = [{ method: 0, steps: 1, times: [], runs: 1 }];
        for (const method of [1, 2, 3])
            for (let steps = 240; steps <= 61440; steps *= 2) all.push({ method, steps, times: [], runs: 1 });
        return all;
    }

    // Powers of ten of the error for one of the time, by least squares; nothing where the method has come to no end
    function slope(s, method) {
        const points = s.entries.filter((one) => one.method === method && one.times.length && one.error < 0.5)
            .map((one) => [Math.log10(median(one.times)), Math.log10(one.error)]);
        if (points.length < 4) return '';
        const mean = (k) => points.reduce((sum, point) => sum + point[k], 0) / points.length;
        const [x, y] = [mean(0), mean(1)];
        const rise = points.reduce((sum, [a, b]) => sum + (a - x) * (b - y), 0) / points.reduce((sum, [a]) => sum + (a - x) ** 2, 0);
        return rise.toFixed(2).replace('-', '\u2212');
    }

    // Once more for one of them; as many runs as the page's watch needs to see
    function measure(s, one, p) {
        for (;;) {
            const start = performance.now();
            one.error = s.ask(COURSES[p.course][0], [one.method, one.steps, one.runs, p.speed]).engine[0];
            const passed = performance.now() - start;
            if (passed >= LEAST || one.runs * one.steps > 5e6) {
                if (passed > 0) one.times.push(passed / 1000 / one.runs);
                return;
            }
            one.runs *= 4;
        }
    }

    flyingLive('14-time-against-error/race', {
        controls: {
            course: { label: 'where', options: [['box', 'between walls'], ['orbit', 'round a centre, no walls']], value: 'box' },
            speed: { label: 'speed at the start', min: 0.5, max: 6, step: 0.1, value: 3.1, unit: 'm/s' }
        },
        view: [-1.7, -1.1, 8.2, 7.3],
        tallest: 560,
        setup: (p, ask) => ({ ask, entries: entries(), turn: 0, round: 0 }),
        frame: (t, s, p) => {
            if (s.round >= ROUNDS) return;
            const k = s.round % 2 === 0 ? s.turn : s.entries.length - 1 - s.turn;
            measure(s, s.entries[k], p);
            if (++s.turn < s.entries.length) return;
            s.turn = 0;
            ++s.round;
        },
        draw: (stage, t, s) => {
            for (let power = LOW; power <= HIGH; ++power) {
                const x = DECADE * (power - LOW);
                stage.line([[x, 0], [x, 6.8]], stage.soft, { width: 1, alpha: 0.3 });
                stage.words([x, -0.45], ten(power), { colour: stage.soft, align: 'center', size: 13 });
            }
            for (let power = BOTTOM; power <= TOP; power += 4) {
                const y = 0.4 * (power - BOTTOM);
                stage.line([[0, y], [7.5, y]], stage.soft, { width: 1, alpha: 0.3 });
                stage.words([-0.15, y - 0.08], ten(power), { colour: stage.soft, align: 'right', size: 13 });
            }
            stage.words([7.5, -0.95], 'seconds for the whole race', { colour: stage.soft, align: 'right', size: 13 });
            stage.words([-1.5, 6.95], 'error in metres', { colour: stage.soft, size: 13 });
            for (let method = 0; method < NAMES.length; ++method) {
                const seen = s.entries.filter((one) => one.method === method && one.times.length);
                const points = seen.map((one) => place(median(one.times), one.error));
                for (const one of seen)
                    stage.line([0.25, 0.75].map((share) => place(quantile(one.times, share), one.error)), stage.colour(method), { width: 5, alpha: 0.4 });
                if (points.length > 1) stage.line(points, stage.colour(method), { width: 2 });
                for (const point of points) stage.dot(point, stage.colour(method), method === 0 ? 6 : 4);
            }
        },
        readout: (t, s, p) => {
            const rows = [['rounds', `${s.round} of ${ROUNDS}`]];
            const best = s.entries[0];
            const last = s.entries[s.entries.length - 1];
            if (best.times.length) rows.push([COURSES[p.course][1], `${(1e6 * median(best.times)).toFixed(2)} \u00b5s, off by ${short(best.error)} m`]);
            if (last.times.length) rows.push([`Verlet, ${last.steps} steps`, `${(1e6 * median(last.times)).toFixed(0)} \u00b5s, off by ${short(last.error)} m`]);
            for (const method of [1, 2, 3]) if (slope(s, method)) rows.push([`slope of ${NAMES[method]}`, slope(s, method)]);
            return rows;
        },
        legend: [...NAMES.map((name, k) => ['dot', k, name]), ['line', 'fixed', 'middle half of the times']]
    });
})();
