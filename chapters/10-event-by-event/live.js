// The live figure of this chapter: a gas whose speeds find their law.
'use strict';

(function () {
    const { short } = FlyingStage;
    // Directions of equal speeds, the same each time
    function directions(count) {
        let seed = 1021;
        return Array.from({ length: count }, () => {
            seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
            return (2 * Math.PI * seed) / 4294967296;
        });
    }

    const BINS = 24;
    const WARM = 1; // until then the lattice is still to be seen [s]

    // The area between the bars and the curve, halved: of all speeds, how many lie in a wrong bar
    function away(s) {
        if (!s.total) return NaN;
        const law = (k) => 0.5 * (s.density[3 * k + 1] + s.density[3 * k + 2]);
        return s.counts.reduce((sum, count, k) => sum + 0.5 * Math.abs(count / s.total - law(k) * s.width), 0);
    }

    flyingLive('10-event-by-event/gas', {
        controls: {
            side: { label: 'discs in a row', min: 4, max: 16, step: 1, value: 10 },
            speed: { label: 'speed at the start', min: 0.5, max: 8, step: 0.5, value: 3, unit: 'm/s' }
        },
        view: (p, s, run) => { const length = run.box()[2]; return [-0.2, -0.2, 2.15 * length, length + 0.2]; },
        scene: (p) => {
            const gap = 2.2;
            const way = directions(p.side * p.side);
            return flyingScene({ box: [0, 0, gap * p.side, gap * p.side], bodies: way.map((angle, k) => ({ disc: 0.5, mass: 1,
                at: [gap * ((k % p.side) + 0.5), gap * (Math.floor(k / p.side) + 0.5)],
                velocity: [p.speed * Math.cos(angle), p.speed * Math.sin(angle)] })) });
        },
        setup: (p, ask) => {
            const width = (3 * p.speed) / BINS;
            const curve = Array.from({ length: 73 }, (_, k) => (3 * p.speed * k) / 72);
            return { counts: new Array(BINS).fill(0), total: 0, width, curve, density: ask('maxwell', [p.speed * p.speed, ...curve]).paper };
        },
        frame: (t, s, p, run) => {
            if (t < WARM) return;
            for (const [, , , vx, vy] of run.states()) {
                const bin = Math.floor(Math.hypot(vx, vy) / s.width);
                if (bin < BINS) ++s.counts[bin];
                ++s.total;
            }
        },
        draw: (stage, t, s, p, run) => {
            const length = run.box()[2];
            stage.walls(run.box());
            run.states().forEach((state) => {
                const share = Math.min(1, Math.hypot(state[3], state[4]) / (2 * p.speed));
                stage.body({ radius: 0.5 }, state, { colour: `hsl(${230 - 210 * share}, 62%, 52%)`, spoke: false });
            });
            const [left, right] = [1.12 * length, 2.1 * length];
            const x = (v) => left + ((right - left) * v) / (3 * p.speed);
            const y = (d) => 0.08 * length + 0.72 * length * d * p.speed;
            stage.line([[left, y(0)], [right, y(0)]], stage.soft, { width: 1.4 });
            const now = t < WARM ? [] : s.counts;
            now.forEach((count, k) => {
                const high = Math.min(y(count / s.total / s.width), length);
                stage.area([[x(k * s.width), y(0)], [x((k + 0.92) * s.width), y(0)], [x((k + 0.92) * s.width), high], [x(k * s.width), high]], stage.colour(0), 0.55);
            });
            stage.line(s.curve.map((v, k) => [x(v), y(s.density[k])]), stage.colour(1), { width: 2.4 });
            stage.words([(left + right) / 2, 0.02 * length], `speed, from 0 to ${short(3 * p.speed)} m/s`, { align: 'center', colour: stage.soft, size: 13 });
            if (t < WARM) stage.words([(left + right) / 2, 0.92 * length], 'counting begins at 1 s', { align: 'center', colour: stage.soft, size: 13 });
        },
        readout: (t, s, p, run) => [['impacts', String(run.collisions)], ['speeds counted', String(s.total)], ['energy', run.energy.toPrecision(12) + ' J'],
            ['temperature, as energy of a disc', short(run.energy / run.bodyCount) + ' J']],
        strip: { label: 'distance from the law, as a share of all speeds', colour: 1, value: (t, s) => away(s) },
        legend: [['body', 'hsl(230, 62%, 52%)', 'slow'], ['body', 'hsl(20, 62%, 52%)', 'fast'], ['body', 0, 'speeds counted so far'], ['line', 1, 'Maxwell\u2019s law, from the energy alone']]
    });
})();
