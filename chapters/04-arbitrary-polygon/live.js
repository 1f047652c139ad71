// The live figures of this chapter: a dumbbell thrown, and a polygon whose corners can be dragged.
'use strict';

(function () {
    const { short } = FlyingStage;
    const DUMBBELL = [[0.4, 0.2], [-0.4, 0.2], [-0.4, 0.4], [-0.8, 0.4], [-0.8, -0.4], [-0.4, -0.4], [-0.4, -0.2], [0.4, -0.2], [0.4, -0.4],
        [0.64, -0.4], [0.72, -0.4], [0.8, -0.32], [0.8, -0.16], [0.8, 0.16], [0.8, 0.4], [0.4, 0.4]];

    flyingLive('04-arbitrary-polygon/toss', {
        controls: {
            angle: { label: 'angle', min: 20, max: 85, step: 1, value: 61, unit: '°' },
            speed: { label: 'speed', min: 3, max: 7, step: 0.1, value: 6, unit: 'm/s' },
            spin: { label: 'spin', min: -10, max: 10, step: 0.5, value: 5.5, unit: 'rad/s' }
        },
        view: [-1.2, -1.3, 6, 2.7],
        until: (p) => (2 * p.speed * Math.sin((p.angle * Math.PI) / 180)) / 9.81, // as high again as at the start
        speed: 0.5,
        scene: (p) => {
            const turn = (p.angle * Math.PI) / 180;
            return flyingScene({ gravity: [0, -9.81],
                bodies: [{ polygon: DUMBBELL, at: [0, 0], angle: 0.4, spin: p.spin, velocity: [p.speed * Math.cos(turn), p.speed * Math.sin(turn)] }] });
        },
        setup: (p, ask, run) => {
            const ring = run.shape(0).rings[0];
            const turn = (p.angle * Math.PI) / 180;
            const velocity = [p.speed * Math.cos(turn), p.speed * Math.sin(turn)];
            const flight = ask('toss', [...velocity, 9.81, 0.02, 2, 1.4]).engine;
            const exact = (t) => (t > 0 ? ask('toss', [...velocity, 9.81, t, 2, t]).engine.slice(8, 10) : [0, 0]);
            return { exact, curve: Array.from({ length: flight.length / 5 }, (_, k) => flight.slice(5 * k + 3, 5 * k + 5)), mean: [0, 1].map((k) => ring.reduce((sum, corner) => sum + corner[k], 0) / ring.length) };
        },
        draw: (stage, t, s, p, run) => {
            const state = run.states()[0];
            stage.line(s.curve, stage.ink, { width: 1.4, dash: [5, 4], alpha: 0.6 });
            stage.body(run.shapes[0], state, { colour: stage.colour(4), alpha: 0.5 });
            stage.dot(state, stage.colour(2), 7);
            stage.dot(mean(s, state), stage.colour(1), 5.5);
        },
        trails: (t, s, p, run) => { const state = run.states()[0]; return [state, mean(s, state)]; },
        trailColours: [2, 1],
        strip: { label: 'from the centre to the parabola, in metres', colour: 2, value: (t, s, p, run) => {
            const [x, y] = run.states()[0];
            const [ex, ey] = s.exact(t);
            return Math.hypot(x - ex, y - ey);
        } },
        legend: [['body', 2, 'centre of mass: flies a parabola'], ['body', 1, 'mean of the corners: wobbles'],
            ['dashes', 'ink', 'the parabola, in closed form']],
        readout: (t, s, p, run) => [['the two are apart by', short(Math.hypot(...s.mean)) + ' m'], ['turned', short((run.states()[0][2] * 180) / Math.PI) + '°']]
    });

    function mean(s, [x, y, angle]) {
        const [c, d] = [Math.cos(angle), Math.sin(angle)];
        return [x + c * s.mean[0] - d * s.mean[1], y + d * s.mean[0] + c * s.mean[1]];
    }

    flyingLive('04-arbitrary-polygon/vertices', {
        still: true,
        view: [-3.4, -2, 3.4, 2],
        start: () => ({ point: [-2.4, -1.3], ring: [[-1.2, -1], [1.4, -1.1], [0.6, 0.1], [2, 1], [-0.6, 1.4], [-1.8, 0.4]] }),
        controls: { triangles: { label: 'triangles', check: true, value: true } },
        setup: (p, ask, run, kept) => {
            const answer = ask('outline', [...kept.point, ...kept.ring.flat()]).engine;
            return { isGood: answer[0] === 1, area: answer[1], centroid: answer.slice(2, 4), inertia: answer[4], signed: answer.slice(5) };
        },
        handles: (p, kept) => [...kept.ring, kept.point],
        move: (k, [x, y], p, kept) => {
            const at = [Math.max(-3.3, Math.min(3.3, x)), Math.max(-1.9, Math.min(1.9, y))];
            if (k < kept.ring.length) kept.ring[k] = at;
            else kept.point = at;
        },
        draw: (stage, t, s, p, run, kept) => {
            const { ring, point } = kept;
            if (s.isGood && p.triangles)
                s.signed.forEach((area, k) => stage.area([point, ring[k], ring[(k + 1) % ring.length]], stage.colour(area > 0 ? 0 : 1), 0.22));
            stage.trace({ rings: [ring] }, [0, 0]);
            stage.fill(stage.colour(4), s.isGood && !p.triangles ? 0.25 : 0.06);
            stage.stroke(s.isGood ? stage.ink : stage.colour(1), { width: 2 });
            if (s.isGood && p.triangles)
                for (const corner of ring) stage.line([point, corner], stage.soft, { width: 1, dash: [3, 3] });
            ring.forEach((corner) => stage.dot(corner, stage.ink, 5.5));
            stage.ring(point, stage.colour(3), 7);
            stage.dot(point, stage.colour(3), 3);
            if (s.isGood) stage.dot(s.centroid, stage.colour(2), 8);
            else stage.words([0, -1.75], 'no polygon: its sides cross', { align: 'center', colour: stage.colour(1) });
        },
        readout: (t, s) => (s.isGood
            ? [['area', short(s.area) + ' m²'], ['sum of the signed triangles', short(s.signed.reduce((a, b) => a + b, 0)) + ' m²'],
                ['moment of inertia at 1 kg/m²', short(s.inertia) + ' kg m²']]
            : [['area', 'none']]),
        legend: [['body', 0, 'triangles that count'], ['body', 1, 'triangles that are taken away'], ['body', 2, 'centroid'], ['body', 3, 'the point they start from']]
    });
})();
