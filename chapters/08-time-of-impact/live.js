// The live figure of this chapter: the safe steps towards a turning bar's impact.
'use strict';

(function () {

    const LEFT = -1.3;
    const PLOT = { left: 0.55, right: 3.3, bottom: 0, top: 1.5 };

    flyingLive('08-time-of-impact/bar', {
        controls: {
            y: { label: 'height of the middle', min: 0.1, max: 0.99, step: 0.01, value: 0.75, unit: 'm' },
            spin: { label: 'spin', min: 0.5, max: 6, step: 0.1, value: 2, unit: 'rad/s' },
            looseness: { label: 'bound too large by', min: 1, max: 20, step: 0.5, value: 1, unit: '×' },
            e: { label: 'restitution', min: 0, max: 1, step: 0.05, value: 1 }
        },
        view: [-2.5, -0.35, 3.5, 1.9],
        until: (p, s) => 1.6 * s.hit,
        speed: 0.25,
        setup: (p, ask) => {
            const { engine, paper } = ask('march', [p.y, p.spin, p.looseness]);
            const [hit, angle, rise, spin] = ask('bounce', [p.y, p.spin, p.e]).engine;
            const looks = [];
            for (let k = 1; k < engine.length; k += 3) looks.push({ time: engine[k], gap: engine[k + 1], rate: engine[k + 2] });
            return { bend: engine[0], looks, paper: paper[0], hit, angle, rise, spin };
        },
        next: (t, s) => { const look = s.looks.find((one) => one.time > t + 1e-9); return look ? look.time : t + 1 / 60; },
        draw: (stage, t, s, p) => {
            const bar = { rings: [[[-1, -0.01], [1, -0.01], [1, 0.01], [-1, 0.01]]] };
            stage.floor(0);
            const done = s.looks.filter((look) => look.time <= t + 1e-9);
            for (const look of done) {
                stage.trace(bar, [LEFT, p.y, -p.spin * look.time]);
                stage.stroke(stage.colour(2), { width: 1, alpha: 0.45 });
            }
            const state = t < s.hit ? [LEFT, p.y, -p.spin * t] : [LEFT, p.y + s.rise * (t - s.hit), s.angle + s.spin * (t - s.hit)];
            const [c, d] = [Math.cos(state[2]), Math.sin(state[2])];
            stage.line([[LEFT - c, state[1] - d], [LEFT + c, state[1] + d]], stage.colour(0), { width: 4 });
            stage.dot([LEFT, state[1]], stage.ink, 3.5);

            // The gap over time, and the parabola below which it can't fall before the next look
            const x = (time) => PLOT.left + ((PLOT.right - PLOT.left) * time) / (1.05 * s.hit);
            const y = (gap) => Math.max(-0.3, PLOT.bottom + (PLOT.top * gap) / p.y);
            stage.line([[PLOT.left, PLOT.top + 0.15], [PLOT.left, 0], [PLOT.right, 0]], stage.soft, { width: 1.4 });
            stage.words([PLOT.left + 0.1, PLOT.top + 0.2], 'gap at the corner', { colour: stage.soft, size: 13 });
            stage.words([PLOT.right, -0.16], 'time', { colour: stage.soft, size: 13, align: 'right' });
            done.forEach((look, k) => {
                const until = k + 1 < s.looks.length ? s.looks[k + 1].time : look.time;
                const safe = Array.from({ length: 25 }, (_, j) => {
                    const dt = ((until - look.time) * j) / 24;
                    return [x(look.time + dt), y(look.gap + look.rate * dt - 0.5 * s.bend * dt * dt)];
                });
                stage.line(safe, stage.colour(2), { width: 1.6 });
                stage.line([[x(look.time), 0], [x(look.time), y(look.gap)]], stage.soft, { width: 1, dash: [3, 3] });
                stage.dot([x(look.time), y(look.gap)], stage.colour(1), 4);
            });
        },
        readout: (t, s) => [
            ['looks so far', `${s.looks.filter((look) => look.time <= t + 1e-9).length} of ${s.looks.length}`],
            ['the march finds', s.hit.toFixed(12) + ' s'], ['by the arc sine', s.paper.toFixed(12) + ' s']],
        legend: [['dot', 1, 'a look at the gap'], ['line', 2, 'what the gap can\u2019t fall below'], ['line', 0, 'the bar; pale, where it was at each look']]
    });
})();
