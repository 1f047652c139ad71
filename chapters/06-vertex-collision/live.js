// The live figure of this chapter: a body to drag into another, convex or not.
'use strict';

(function () {
    const { short } = FlyingStage;
    const PAIRS = [[0, 'a crate and a floor'], [1, 'a crate and a table'], [2, 'a diamond and a frame']];
    const PLACES = [[4.4, 0.9], [0, -0.35], [0.35, 0.1]];

    flyingLive('06-vertex-collision/rocking', {
        still: true,
        view: (p) => (p.pair === 0 ? [1.4, -0.8, 7.4, 2.4] : p.pair === 1 ? [-5, -1.7, 5, 3.6] : [-4, -2.4, 4, 2.4]),
        start: () => ({ at: PLACES.map((place) => [...place]) }),
        controls: {
            pair: { label: 'what', options: PAIRS, value: 0 },
            turn: { label: 'turned', min: -90, max: 90, step: 1, value: 9, unit: '°' }
        },
        handles: (p, kept) => [kept.at[p.pair]],
        move: (k, [x, y], p, kept) => {
            const [left, bottom, right, top] = [[1.6, -0.6, 7.2, 2.2], [-4.8, -1.5, 4.8, 3.4], [-3.8, -2.2, 3.8, 2.2]][p.pair];
            kept.at[p.pair] = [Math.max(left, Math.min(right, x)), Math.max(bottom, Math.min(top, y))];
        },
        setup: (p, ask, run, kept) => {
            const angle = (p.turn * Math.PI) / 180;
            const { engine } = ask('entered', [p.pair, ...kept.at[p.pair], angle]);
            let k = 0;
            const shape = () => {
                const rings = [];
                for (let count = engine[k++]; count > 0; --count) {
                    const ring = [];
                    for (let corners = engine[k++]; corners > 0; --corners, k += 2) ring.push([engine[k], engine[k + 1]]);
                    rings.push(ring);
                }
                return { rings };
            };
            const [still, held] = [shape(), shape()];
            const contacts = [];
            for (; k < engine.length; k += 5) contacts.push(engine.slice(k, k + 5));
            return { angle, still, held, contacts };
        },
        draw: (stage, t, s, p, run, kept) => {
            stage.body(s.still, [0, 0, 0], { isFixed: true });
            stage.body(s.held, [...kept.at[p.pair], s.angle], { colour: stage.colour(0), alpha: 0.45 });
            for (const [x, y, nx, ny, separation] of s.contacts) {
                const length = Math.max(0.35, -separation);
                stage.arrow([x, y], [x + length * nx, y + length * ny], stage.colour(2), 3);
                stage.dot([x, y], stage.colour(1), 6);
            }
        },
        readout: (t, s) => (s.contacts.length
            ? s.contacts.map(([, , , , separation], k) => [`contact ${k + 1}: deep by`, short(-separation) + ' m'])
            : [['contacts', 'none']]),
        legend: [['body', 1, 'contact, one for each piece that the two share'], ['arrow', 2, 'its normal']]
    });
})();
