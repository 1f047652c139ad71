// The live figures of this chapter: two polygons to drag, and squares that meet head on.
'use strict';

(function () {
    const { short } = FlyingStage;
    const outline = (sides) => (sides === 4 ? [[-1, -0.6], [1, -0.6], [1, 0.6], [-1, 0.6]]
        : Array.from({ length: sides }, (_, k) => [Math.cos((2 * Math.PI * k) / sides), Math.sin((2 * Math.PI * k) / sides)]));
    const place = ([x, y], at, angle) => [at[0] + Math.cos(angle) * x - Math.sin(angle) * y, at[1] + Math.sin(angle) * x + Math.cos(angle) * y];
    const SIDES = [3, 4, 5, 6, 8].map((n) => [n, n === 4 ? 'rectangle' : n + ' sides']);

    flyingLive('05-separating-axis/axes', {
        still: true,
        view: [-4, -2.1, 4, 2.1],
        start: () => ({ at: [[-0.9, -0.2], [0.75, 0.35]] }),
        controls: {
            a: { label: 'blue', options: SIDES, value: 4 },
            b: { label: 'orange', options: SIDES, value: 5 },
            turnA: { label: 'blue turned', min: -90, max: 90, step: 1, value: 12, unit: '°' },
            turnB: { label: 'orange turned', min: -90, max: 90, step: 1, value: 20, unit: '°' }
        },
        handles: (p, kept) => kept.at,
        move: (k, [x, y], p, kept) => { kept.at[k] = [Math.max(-3, Math.min(3, x)), Math.max(-1.2, Math.min(1.2, y))]; },
        setup: (p, ask, run, kept) => {
            const turns = [(p.turnA * Math.PI) / 180, (p.turnB * Math.PI) / 180];
            const answer = ask('axes', [p.a, p.b, ...kept.at[0], turns[0], ...kept.at[1], turns[1]]).engine;
            const [separation, owner, edge, vertex, nx, ny, count] = answer;
            const contacts = Array.from({ length: count }, (_, k) => answer.slice(7 + 3 * k, 10 + 3 * k));
            const of = answer.slice(7 + 3 * count);
            return { turns, separation, owner, edge, vertex, normal: [nx, ny], contacts, ofA: of.slice(0, p.a), ofB: of.slice(p.a) };
        },
        draw: (stage, t, s, p, run, kept) => {
            const rings = [outline(p.a), outline(p.b)];
            rings.forEach((ring, k) => stage.body({ rings: [ring] }, [...kept.at[k], s.turns[k]], { colour: stage.colour(k), alpha: 0.4 }));
            const owner = rings[s.owner].map((corner) => place(corner, kept.at[s.owner], s.turns[s.owner]));
            const other = rings[1 - s.owner].map((corner) => place(corner, kept.at[1 - s.owner], s.turns[1 - s.owner]));
            const [from, to] = [owner[s.edge], owner[(s.edge + 1) % owner.length]];
            const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
            stage.line([[from[0] - 6 * dx, from[1] - 6 * dy], [to[0] + 6 * dx, to[1] + 6 * dy]], stage.soft, { width: 1.3, dash: [6, 5] });
            stage.line([from, to], stage.colour(2), { width: 4 });
            const corner = other[s.vertex];
            stage.dot(corner, stage.colour(2), 5);
            const sign = s.owner === 0 ? 1 : -1;
            const foot = [corner[0] - sign * s.separation * s.normal[0], corner[1] - sign * s.separation * s.normal[1]];
            if (s.separation > 0) stage.line([corner, foot], stage.colour(2), { width: 2 });
            else stage.arrow(kept.at[1], [kept.at[1][0] - s.separation * s.normal[0], kept.at[1][1] - s.separation * s.normal[1]], stage.ink, 3);
            for (const [x, y] of s.contacts) stage.ring([x, y], stage.colour(6), 6);
            if (s.separation < 0)
                stage.ghost({ rings: [rings[1]] }, [kept.at[1][0] - s.separation * s.normal[0], kept.at[1][1] - s.separation * s.normal[1], s.turns[1]]);
        },
        readout: (t, s) => [
            [s.separation > 0 ? 'apart by at least' : 'overlap, to be undone by a push of', short(Math.abs(s.separation)) + ' m'],
            ['along each blue edge', s.ofA.map(short).join(', ')], ['along each orange edge', s.ofB.map(short).join(', ')]],
        legend: [['line', 2, 'edge of the greatest separation'], ['arrow', 'ink', 'shortest push that parts them'],
            ['ghost', 'ink', 'where it leads'], ['dot', 6, 'contact points']]
    });

    // Where a step's places begin, and how far two squares that meet head on are inside each other
    const stepAt = (s, p, t) => 8 * Math.min(Math.floor(t * p.steps + 1e-9), s.places.length / 8 - 1);
    const overlap = (s, k) => Math.max(0, 1 - Math.abs(s.places[k + 2] - s.places[k]));

    flyingLive('05-separating-axis/head-on', {
        controls: {
            speed: { label: 'speed', min: 0.3, max: 6, step: 0.1, value: 1, unit: 'm/s' },
            steps: { label: 'steps a second', min: 10, max: 240, step: 10, value: 60 }
        },
        view: [-3, -0.8, 3, 2.6],
        until: 2,
        speed: 0.5,
        setup: (p, ask) => ({ places: ask('head-on', [p.speed, p.steps, 2]).engine }),
        draw: (stage, t, s, p) => {
            const k = stepAt(s, p, t);
            const square = { rings: [[[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]]] };
            for (let body = 0; body < 4; ++body)
                stage.body(square, [s.places[k + 2 * body], s.places[k + 2 * body + 1] + (body < 2 ? 1.8 : 0)],
                    { colour: stage.colour(body % 2), alpha: 0.6 });
            stage.words([-2.9, 2.48], 'greatest separation', { colour: stage.soft, size: 13 });
            stage.words([-2.9, 0.68], 'nearest edge', { colour: stage.soft, size: 13 });
        },
        readout: (t, s, p) => [['overlap above', short(overlap(s, stepAt(s, p, t))) + ' m'], ['below', short(overlap(s, stepAt(s, p, t) + 4)) + ' m']],
        strip: { label: 'overlap of the lower pair, in metres', colour: 1, value: (t, s, p) => overlap(s, stepAt(s, p, t) + 4) },
        legend: [['body', 0, 'flies to the right'], ['body', 1, 'flies to the left']]
    });
})();
