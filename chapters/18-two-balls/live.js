// The live figures of this chapter: two discs that meet or miss, and the billiard that counts pi.
'use strict';

(function () {
    const { short } = FlyingStage;

    flyingLive('18-two-balls/discs', {
        controls: {
            b: { label: 'offset', min: -1.2, max: 1.2, step: 0.05, value: 0.45, unit: 'm' },
            speed: { label: 'speed', min: 0.5, max: 4, step: 0.1, value: 2, unit: 'm/s' },
            first: { label: 'mass of the blue disc', min: 0.1, max: 10, step: 0.1, value: 1, unit: 'kg' },
            mass: { label: 'mass of the orange disc', min: 0.1, max: 10, step: 0.1, value: 1, unit: 'kg' },
            e: { label: 'restitution', min: 0, max: 1, step: 0.05, value: 1 }
        },
        view: [-3.6, -1.9, 3.6, 1.9],
        until: 4,
        scene: (p) => flyingScene({ restitution: p.e,
            bodies: [{ disc: 0.5, at: [-3, p.b], velocity: [p.speed, 0], mass: p.first }, { disc: 0.5, at: [0, 0], mass: p.mass }] }),
        setup: (p, ask) => {
            const at = (t) => ask('meeting', [p.b, p.speed, p.first, p.mass, p.e, t]);
            return { at, meet: at(0).engine[0] };
        },
        draw: (stage, t, s, p, run) => {
            stage.line([[-3, p.b], [3.6, p.b]], stage.soft, { width: 1, dash: [4, 4] });
            stage.line([[-3.6, 0], [3.6, 0]], stage.soft, { width: 1, alpha: 0.5 });
            const [a, b] = run.states();
            if (s.meet >= 0) {
                // Where the quadratic has them meet, and the line of centres there
                const x = -3 + p.speed * s.meet;
                stage.trace({ radius: 0.5 }, [x, p.b, 0]);
                stage.stroke(stage.soft, { width: 1, alpha: 0.7 });
                stage.line([[2.2 * x, 2.2 * p.b], [-1.8 * x, -1.8 * p.b]], stage.soft, { width: 1 });
            }
            stage.body({ radius: 0.5 }, b, { colour: stage.colour(1), spoke: false });
            stage.body({ radius: 0.5 }, a, { colour: stage.colour(0), spoke: false });
            const [ax, ay, bx, by] = s.at(t).paper;
            stage.ghost({ radius: 0.5 }, [ax, ay]);
            stage.ghost({ radius: 0.5 }, [bx, by]);
            for (const [x, y, , vx, vy] of [a, b]) stage.arrow([x, y], [x + 0.5 * vx, y + 0.5 * vy], stage.ink);
        },
        trails: (t, s, p, run) => run.states(),
        readout: (t, s, p, run) => {
            const [a, b] = run.states();
            const across = Math.abs(Math.atan2(a[4], a[3]) - Math.atan2(b[4], b[3]));
            const apart = run.collisions && Math.hypot(b[3], b[4]) > 0 && Math.hypot(a[3], a[4]) > 1e-9
                ? short((Math.min(across, 2 * Math.PI - across) * 180) / Math.PI) + '°' : '\u2013';
            return [['they meet at', s.meet < 0 ? 'never' : s.meet.toFixed(4) + ' s'], ['angle between their ways', apart],
                ['speeds', `${short(Math.hypot(a[3], a[4]))} and ${short(Math.hypot(b[3], b[4]))} m/s`]];
        },
        legend: [['body', 0, 'comes in'], ['body', 1, 'at rest at first'], ['ghost', 'ink', 'the quadratic and the push, on paper'],
            ['line', 'fixed', 'line of centres']],
        strip: { label: 'energy, in joules', value: (t, s, p, run) => run.energy }
    });

    flyingLive('18-two-balls/billiard', {
        controls: { digits: { label: 'digits after the 3', min: 0, max: 4, step: 1, value: 1 } },
        view: [-0.45, -0.9, 4.6, 1],
        until: 4,
        speed: 0.5,
        scene: (p) => ({ engine: 'events', text: flyingScene({ bodies: [
            { rectangle: [0.5, 2], at: [-0.25, 0], fixed: true },
            { disc: 0.25, at: [1, 0], mass: 1 }, { disc: 0.5, at: [2.5, 0], velocity: [-1, 0], mass: 100 ** p.digits }] }) }),
        setup: (p, ask) => ({ ask, most: ask('unfolded', [100 ** p.digits, 0]).paper[0] }),
        next: (t, s, p, run) => { while (run.time < 4 && !run.advance(4, 1) && run.time <= t); return Math.max(run.time, t + 1e-6); },
        draw: (stage, t, s, p, run) => {
            stage.body(run.shapes[0], [-0.25, 0, 0], { isFixed: true });
            const [, light, heavy] = run.states();
            stage.body({ radius: 0.5 }, heavy, { colour: stage.colour(1), spoke: false });
            stage.body({ radius: 0.25 }, light, { colour: stage.colour(0), spoke: false });
            const [, x, X] = s.ask('unfolded', [100 ** p.digits, t]).paper;
            stage.ghost({ radius: 0.25 }, [x, 0]);
            stage.ghost({ radius: 0.5 }, [X, 0]);
            stage.words([2.3, 0.78], String(run.collisions), { size: 30, align: 'center' });
        },
        readout: (t, s, p, run) => [['impacts', `${run.collisions} of ${s.most}`], ['energy', short(run.energy) + ' J']],
        strip: { label: 'impacts so far', value: (t, s, p, run) => run.collisions },
        legend: [['body', 0, '1 kg'], ['body', 1, 'heavier by a power of 100'], ['ghost', 'ink', 'the folded straight line']]
    });
})();
