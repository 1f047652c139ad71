// The live figure of this chapter: a regular polygon races a disc.
'use strict';

(function () {
    const { short } = FlyingStage;
    const ring = (sides, radius) => Array.from({ length: sides }, (_, k) => [radius * Math.sin((2 * Math.PI * k) / sides), radius * Math.cos((2 * Math.PI * k) / sides)]).reverse();

    flyingLive('03-regular-polygon/race', {
        controls: {
            sides: { label: 'sides', min: 3, max: 16, step: 1, value: 3 },
            torque: { label: 'torque', min: 1, max: 10, step: 0.5, value: 4, unit: 'N m' }
        },
        view: [-2.2, -2, 5.8, 2],
        until: 6,
        setup: (p, ask) => ({ at: (t) => ask('race', [p.sides, p.torque, t]).engine }),
        draw: (stage, t, s, p) => {
            const [, angle, disc, radius] = s.at(t);
            stage.body({ rings: [ring(p.sides, radius)] }, [0, 0, angle], { colour: stage.colour(1) });
            stage.body({ radius: 1 }, [3.6, 0, disc + Math.PI / 2], { colour: stage.colour(0), spoke: false });
            for (const [x, by] of [[0, angle], [3.6, disc]])
                stage.dot([x - 0.55 * Math.sin(by), 0.55 * Math.cos(by)], stage.ground, 6);
            stage.line([[0, 0], [-0.55 * Math.sin(disc), 0.55 * Math.cos(disc)]], stage.ink, { width: 1.4, dash: [4, 4] });
        },
        readout: (t, s) => {
            const [share, angle, disc] = s.at(t);
            return [['moment of inertia beside the disc', '+' + short(100 * (share - 1)) + ' %'],
                ['behind by', short(((disc - angle) * 180) / Math.PI) + '°']];
        },
        legend: [['body', 1, 'the polygon'], ['body', 0, 'the disc of the same mass and area'], ['dashes', 'ink', 'where the disc\u2019s mark is']],
        strip: { label: 'how far the polygon is behind, in turns', colour: 1, value: (t, s) => { const [, a, b] = s.at(t); return (b - a) / (2 * Math.PI); } }
    });
})();
