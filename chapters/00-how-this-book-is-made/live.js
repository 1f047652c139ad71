// The live figure of this chapter: a fall by steps beside the closed form.
'use strict';

(function () {
    const { short } = FlyingStage;
    const UNTIL = 2;

    flyingLive('00-how-this-book-is-made/fall', {
        controls: {
            step: { label: 'length of a step', min: 0.02, max: 0.5, step: 0.02, value: 0.2, unit: 's' },
            g: { label: 'gravity', min: 1.6, max: 9.8, step: 0.1, value: 9.8, unit: 'm/s²' }
        },
        view: [-10, -21.5, 10, 1.5],
        until: UNTIL,
        speed: 0.5,
        setup: (p, ask) => ({ at: (t) => ask('fall', [p.g, p.step, t]).engine }),
        draw: (stage, t, s, p) => {
            for (let depth = 0; depth <= 20; depth += 5) {
                stage.line([[-6, -depth], [6, -depth]], stage.soft, { width: 1, alpha: 0.5 });
                stage.words([-6.3, -depth], depth + ' m', { colour: stage.soft, align: 'right', size: 13 });
            }
            for (let k = 0; k * p.step <= t + 1e-9; ++k) {
                const [steps, exact] = s.at(k * p.step);
                stage.dot([-2, -steps], stage.colour(1), 3);
                stage.dot([2, -exact], stage.colour(0), 3);
            }
            const [steps, exact] = s.at(t);
            stage.body({ radius: 0.6 }, [-2, -steps], { colour: stage.colour(1), spoke: false });
            stage.ghost({ radius: 0.6 }, [-2, -exact]);
            stage.body({ radius: 0.6 }, [2, -exact], { colour: stage.colour(0), spoke: false });
        },
        readout: (t, s) => {
            const [steps, exact] = s.at(t);
            return [['by steps', short(steps) + ' m'], ['closed form', short(exact) + ' m'], ['behind by', short(exact - steps) + ' m']];
        },
        legend: [['body', 1, 'by steps'], ['body', 0, 'closed form'], ['ghost', 'ink', 'closed form, beside the steps']],
        strip: { label: 'how far the steps are behind, in metres', colour: 1, value: (t, s) => { const [a, b] = s.at(t); return b - a; } }
    });
})();
