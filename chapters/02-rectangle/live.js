// The live figure of this chapter: a door, pushed where you like.
'use strict';

(function () {
    const { short } = FlyingStage;
    const turned = (length, angle) => [length * Math.cos(angle), length * Math.sin(angle)];

    flyingLive('02-rectangle/doors', {
        controls: {
            push: { label: 'push at', min: 0.1, max: 1, step: 0.05, value: 0.5, show: (x) => Math.round(100 * x) + '\u202f% of the width' },
            force: { label: 'force', min: 1, max: 12, step: 0.5, value: 4, unit: 'N' },
            width: { label: 'width', min: 0.5, max: 1.4, step: 0.05, value: 1, unit: 'm' },
            mass: { label: 'mass', min: 5, max: 60, step: 1, value: 20, unit: 'kg' }
        },
        view: [-0.9, -0.25, 3.4, 1.5],
        until: 4,
        setup: (p, ask) => ({ at: (t, share) => ask('door', [p.width, p.mass, p.force, share * p.width, t]).engine }),
        handles: (p) => [[p.push * p.width, -0.03]],
        move: (k, [x], p) => { p.push = Math.max(0.1, Math.min(1, x / p.width)); },
        draw: (stage, t, s, p) => {
            const leaf = { rings: [[[0, -0.03], [p.width, -0.03], [p.width, 0.03], [0, 0.03]]] };
            const quarter = Math.PI / 2;
            const push = (left, share, colour) => {
                const [, , angle] = s.at(t, share);
                const open = Math.min(angle, quarter);
                stage.body(leaf, [left, 0, open], { colour });
                stage.dot([left, 0], stage.ink, 5);
                const [x, y] = turned(share * p.width, open);
                const [ux, uy] = turned(0.05 + 0.03 * p.force, open + quarter);
                stage.arrow([left + x - ux, y - uy], [left + x, y], stage.colour(1));
            };
            push(0, p.push, stage.colour(0));
            push(1.9, 1, stage.colour(2));
            stage.words([-0.85, -0.17], 'pushed where you say', { align: 'left', colour: stage.soft, size: 13 });
            stage.words([3.35, -0.17], 'pushed at the handle', { align: 'right', colour: stage.soft, size: 13 });
        },
        readout: (t, s, p) => {
            const [inertia, felt, angle] = s.at(t, p.push);
            return [['moment of inertia', short(inertia) + ' kg m²'], ['mass you feel', short(felt) + ' kg'],
                ['turned', short((Math.min(angle, Math.PI / 2) * 180) / Math.PI) + '°']];
        },
        legend: [['body', 0, 'your push'], ['body', 2, 'the same force at the handle'], ['arrow', 1, 'force']],
        strip: { label: 'angle of your door, in radians', value: (t, s, p) => Math.min(s.at(t, p.push)[2], Math.PI / 2) }
    });
})();
