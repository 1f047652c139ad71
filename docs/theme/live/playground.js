// The playground: every scene of the course, and the reader's own.
'use strict';

(function () {
    const names = Object.keys(flyingScenes).sort();
    const kept = { text: '' };
    let area = null;

    // The text with its scene, and the place of a fault in it
    function place(figure) {
        area = document.createElement('textarea');
        area.spellcheck = false;
        area.rows = 18;
        area.setAttribute('aria-label', 'The scene as text');
        const run = document.createElement('button');
        run.type = 'button';
        run.textContent = 'Run this text (Ctrl + Enter)';
        // Marks where the first fault is, which its message names by line and column
        const find = () => {
            const [, line, column] = figure.fault.textContent.match(/scene:(\d+):(\d+)/) || [];
            if (!line) return;
            const at = area.value.split('\n').slice(0, line - 1).reduce((sum, one) => sum + one.length + 1, Number(column) - 1);
            area.focus();
            area.setSelectionRange(at, at + 1);
        };
        const start = () => {
            kept.text = area.value;
            figure.reset();
            if (figure.isFailed) {
                find();
                return;
            }
            figure.play(true);
            figure.draw();
        };
        run.onclick = start;
        area.onkeydown = (event) => {
            if (event.key === 'Enter' && event.ctrlKey) start();
        };
        const form = document.createElement('div');
        form.className = 'scene-text';
        form.append(area, run);
        figure.fault.after(form);
        figure.fault.onclick = find;
    }

    flyingLive('playground', {
        checkTime: 1,
        grab: true,
        controls: {
            scene: { label: 'scene', options: names.map((name) => [name, name]), value: 'balls-and-polygons' },
            engine: { label: 'moved', options: [['auto', 'as the plan says'], ['events', 'event by event'], ['rest', 'by steps']], value: 'auto' }
        },
        start: () => kept,
        scene: (p) => {
            if (kept.name !== p.scene) {
                kept.name = p.scene;
                kept.text = flyingScenes[p.scene];
                if (area) area.value = kept.text;
            }
            return { text: kept.text, engine: p.engine };
        },
        begun: (figure) => { place(figure); area.value = kept.text; },
        view: (p, s, run) => {
            const box = run.box();
            if (box) return box.map((x, k) => x + (k < 2 ? -1 : 1) * 0.02 * (box[2] - box[0]));
            return s.view;
        },
        // Without a box: what the bodies span at the start, and as much round it
        setup: (p, ask, run) => {
            if (!run.bodyCount)
                throw new FlyingError('The scene has no body yet. Add one, such as\n[[body]]\nshape = { kind = "disc", radius = 1.0 }\nposition = [0.0, 0.0]\nvelocity = [1.0, 0.0]');
            const view = [Infinity, Infinity, -Infinity, -Infinity];
            run.states().forEach(([x, y], k) => {
                const shape = run.shapes[k];
                const reach = shape.radius || Math.max(...shape.rings[0].map(([a, b]) => Math.hypot(a, b)));
                view[0] = Math.min(view[0], x - 1.2 * reach), view[1] = Math.min(view[1], y - 1.2 * reach);
                view[2] = Math.max(view[2], x + 1.2 * reach), view[3] = Math.max(view[3], y + 1.2 * reach);
            });
            const wide = Math.max(view[2] - view[0], 1.6 * (view[3] - view[1]));
            const middle = [(view[0] + view[2]) / 2, (view[1] + view[3]) / 2];
            return { view: [middle[0] - 0.65 * wide, middle[1] - 0.41 * wide, middle[0] + 0.65 * wide, middle[1] + 0.41 * wide] };
        },
        draw: (stage, t, s, p, run) => {
            const box = run.box();
            if (box) stage.walls(box);
            run.states().forEach((state, k) => stage.body(run.shapes[k], state, { colour: stage.colour(k), isFixed: run.isStatic(k) }));
        },
        readout: (t, s, p, run) => [['events', String(run.events)], ['impacts', String(run.collisions)], ['energy', run.energy.toPrecision(10) + ' J']],
        strip: { label: 'energy, in joules', value: (t, s, p, run) => run.energy }
    });
})();
