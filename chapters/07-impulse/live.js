// The live figure of this chapter: a ball strikes a rod where you say.
'use strict';

(function () {
    const { short } = FlyingStage;
    const START = -0.62; // half a metre below the place where it touches
    const TOUCH = 0.5; // [s]

    flyingLive('07-impulse/strike', {
        controls: {
            arm: { label: 'strikes at', min: 0, max: 0.48, step: 0.02, value: 0.44, show: (x) => x.toFixed(2) + '\u202fm from the middle' },
            mass: { label: 'mass of the ball', min: 0.1, max: 5, step: 0.1, value: 1, unit: 'kg' },
            e: { label: 'restitution', min: 0, max: 1, step: 0.05, value: 1 },
            mu: { label: 'friction', min: 0, max: 1, step: 0.05, value: 0.3 },
            slip: { label: 'speed along the rod', min: -1, max: 1, step: 0.1, value: 0, unit: 'm/s' }
        },
        view: [-1.5, -0.9, 1.9, 1.3],
        until: 2,
        speed: 0.5,
        scene: (p) => flyingScene({ restitution: p.e, friction: p.mu,
            bodies: [{ disc: 0.1, at: [p.arm - 0.5 * p.slip, START], velocity: [p.slip, 1], mass: p.mass },
                { rectangle: [1, 0.04], at: [0, 0], mass: 1 }] }),
        setup: (p, ask) => {
            const [normal, along, , , , , up, spin, lost] = ask('strike', [p.mass, p.slip, p.arm, p.e, p.mu]).engine;
            return { normal, along, up, spin, lost };
        },
        draw: (stage, t, s, p, run) => {
            const [ball, rod] = run.states();
            stage.body(run.shapes[1], rod, { colour: stage.colour(0) });
            stage.body(run.shapes[0], ball, { colour: stage.colour(1) });
            stage.dot(rod, stage.ink, 4);
            if (run.collisions < 2) {
                const after = Math.max(0, t - TOUCH);
                stage.ghost(run.shapes[1], [s.along * after, s.up * after, s.spin * after]);
                stage.ghost(run.shapes[0], [p.arm + p.slip * (t - TOUCH) - (s.along / p.mass) * after, -0.12 + t - TOUCH - (s.normal / p.mass) * after]);
            }
            if (run.collisions > 0 && t < 0.95) stage.arrow([p.arm, -0.02], [p.arm + 0.25 * s.along, -0.02 + 0.25 * s.normal], stage.colour(2), 3);
        },
        trails: (t, s, p, run) => { const [ball, rod] = run.states(); return [ball, rod]; },
        trailColours: [1, 0],
        readout: (t, s, p, run) => {
            const rod = run.states()[1];
            return [['impulse across', short(s.normal) + ' N s'], ['along, by friction', short(s.along) + ' N s'],
                ['rod then: speed, spin', `${short(Math.hypot(rod[3], rod[4]))} m/s, ${short(rod[5])} rad/s`], ['energy lost', short(s.lost) + ' J']];
        },
        legend: [['body', 1, 'the ball'], ['body', 0, 'the rod, 1 kg'], ['arrow', 2, 'impulse on the rod'],
            ['ghost', 'ink', 'where the impulse sends them, on paper']],
        strip: { label: 'energy, in joules', value: (t, s, p, run) => run.energy }
    });
})();
