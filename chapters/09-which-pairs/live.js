// The live figures of this chapter: the cells of a gas, and two rooms whose pairs are found in two ways.
'use strict';

(function () {
    const { short } = FlyingStage;

    // Where the discs of a room are, and how far two of them are inside each other
    function roomAt(s, p, t, room) {
        const at = 4 * p.count * Math.min(Math.round(60 * t), s.places.length / (4 * p.count) - 1) + 2 * room * p.count;
        return Array.from({ length: p.count }, (_, k) => s.places.slice(at + 2 * k, at + 2 * k + 2));
    }
    function deepest(places) {
        let depth = 0;
        places.forEach(([x, y], k) => places.slice(0, k).forEach(([px, py]) => { depth = Math.max(depth, 1 - Math.hypot(x - px, y - py)); }));
        return depth;
    }

    flyingLive('09-which-pairs/cells', {
        controls: {
            count: { label: 'discs', min: 10, max: 400, step: 10, value: 80 },
            packing: { label: 'share of the room that they cover', min: 0.02, max: 0.4, step: 0.02, value: 0.1, show: (x) => Math.round(100 * x) + '\u202f%' }
        },
        view: (p, s, run) => { const [left, bottom, right, top] = run.box(); return [left - 0.2, bottom - 0.2, right + 0.2, top + 0.2]; },
        scene: (p, module) => module.generate(`gas --count ${p.count} --packing ${p.packing} --radius 0.5 --rms-speed 3 --seed 5 --until 1000`),
        setup: (p, ask) => ({ ask, at: null }),
        frame: (t, s, p, run) => {
            const answer = s.ask('cells', [0.5, 0, ...run.states().flatMap(([x, y]) => [x, y])]).engine;
            s.at = { size: answer[0], counts: answer.slice(1, 5), cells: answer.slice(5, 5 + 2 * p.count), seen: answer.slice(5 + 2 * p.count) };
        },
        draw: (stage, t, s, p, run) => {
            const [left, bottom, right, top] = run.box();
            const { size, cells, seen } = s.at;
            const [column, row] = cells;
            stage.area([[column - 1, row - 1], [column + 2, row - 1], [column + 2, row + 2], [column - 1, row + 2]].map(([x, y]) => [x * size, y * size]),
                stage.colour(4), 0.18);
            for (let x = Math.ceil(left / size) * size; x < right; x += size) stage.line([[x, bottom], [x, top]], stage.soft, { width: 1, alpha: 0.45 });
            for (let y = Math.ceil(bottom / size) * size; y < top; y += size) stage.line([[left, y], [right, y]], stage.soft, { width: 1, alpha: 0.45 });
            stage.walls(run.box());
            const [first, ...others] = run.states();
            others.forEach((state, k) => {
                const isSeen = seen.includes(k + 1);
                stage.body({ radius: 0.5 }, state, { colour: isSeen ? stage.colour(1) : stage.colour(7), spoke: false, alpha: isSeen ? 0.9 : 0.45 });
            });
            stage.body({ radius: 0.5 }, first, { colour: stage.colour(0), spoke: false });
            for (const k of seen) stage.line([first, run.states()[k]], stage.colour(1), { width: 1.4 });
        },
        readout: (t, s) => [['all pairs', String(s.at.counts[1])], ['compared by a sweep', String(s.at.counts[2])],
            ['compared by cells', String(s.at.counts[3])], ['boxes that overlap', String(s.at.counts[0])]],
        legend: [['body', 0, 'asks'], ['body', 1, 'those that it looks at'], ['body', 7, 'never looked at by it']],
        strip: { label: 'pairs compared by cells', colour: 1, value: (t, s) => s.at.counts[3] }
    });

    flyingLive('09-which-pairs/rooms', {
        controls: {
            count: { label: 'discs in each room', min: 4, max: 25, step: 1, value: 24 },
            speed: { label: 'speed up to', min: 1, max: 8, step: 0.5, value: 4, unit: 'm/s' }
        },
        view: [-0.3, -0.3, 25.3, 13.2],
        until: 6,
        setup: (p, ask) => ({ places: ask('rooms', [p.count, p.speed, 6]).engine }),
        legend: [['body', 0, 'a disc, in the same colour in both rooms']],
        strip: { label: 'deepest overlap on the right, in metres', colour: 1, value: (t, s, p) => deepest(roomAt(s, p, t, 1)) },
        readout: (t, s, p) => [['deepest overlap on the left', short(deepest(roomAt(s, p, t, 0))) + ' m'],
            ['on the right', short(deepest(roomAt(s, p, t, 1))) + ' m']],
        draw: (stage, t, s, p) => {
            stage.walls([0, 0, 12, 12]);
            stage.walls([13, 0, 25, 12]);
            for (const room of [0, 1])
                roomAt(s, p, t, room).forEach(([x, y], k) => stage.body({ radius: 0.5 }, [x + 13 * room, y], { colour: stage.colour(k), spoke: false }));
            stage.words([6, 12.6], 'by position', { align: 'center', size: 13, colour: stage.soft });
            stage.words([19, 12.6], 'by velocity', { align: 'center', size: 13, colour: stage.soft });
        }
    });
})();
