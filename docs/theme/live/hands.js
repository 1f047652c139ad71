// What a pointer or the keyboard moves in a live figure: the handles of an experiment, or the bodies of its run.
'use strict';

(function (home) {
    const { make } = home.FlyingControls;

    home.FlyingHands = {
        listen() {
            const { canvas, experiment } = this;
            canvas.tabIndex = 0;
            canvas.setAttribute('role', 'application'); // so that a screen reader lets the keys through
            canvas.classList.add('to-drag');
            this.held = -1;
            this.chosen = 0;
            const hint = make('span', { class: 'for-readers', 'aria-live': 'polite' });
            this.hint = hint;
            const words = experiment.grab ? 'Page up and page down choose a body, the arrow keys push it.'
                : 'Page up and page down choose a handle, the arrow keys move it.';
            canvas.setAttribute('aria-description', words);
            canvas.title = words;
            canvas.after(hint);
            canvas.addEventListener('pointerdown', (event) => {
                const k = this.nearest(this.stage.under(event));
                if (k < 0) return;
                this.held = this.chosen = k;
                this.target = this.stage.under(event);
                canvas.setPointerCapture(event.pointerId);
                event.preventDefault();
                this.pull();
            });
            canvas.addEventListener('pointermove', (event) => {
                if (this.held < 0) {
                    canvas.style.cursor = this.nearest(this.stage.under(event)) < 0 ? '' : 'grab';
                    return;
                }
                this.target = this.stage.under(event);
                this.pull();
            });
            for (const kind of ['pointerup', 'pointercancel'])
                canvas.addEventListener(kind, () => { this.held = -1; });
            canvas.addEventListener('keydown', (event) => {
                const count = experiment.grab ? this.run.bodyCount : this.handles().length;
                const turn = { PageDown: 1, PageUp: count - 1 }[event.key];
                const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
                if ((!turn && !way) || (experiment.grab && !this.run)) return;
                event.preventDefault();
                if (turn) {
                    do this.chosen = (this.chosen + turn) % count;
                    while (experiment.grab && this.run.isStatic(this.chosen));
                } else if (experiment.grab) {
                    const state = this.run.states()[this.chosen];
                    this.steer(this.chosen, state[3] + way[0], state[4] + way[1]);
                } else {
                    const [x, y] = this.handles()[this.chosen];
                    const size = (event.shiftKey ? 0.01 : 0.04) * (this.stage.view[2] - this.stage.view[0]);
                    this.target = [x + size * way[0], y + size * way[1]];
                    this.move(this.chosen);
                }
                this.hint.textContent = `number ${this.chosen + 1} of ${count}`;
                this.draw();
            });
        },

        handles() { return this.experiment.handles(this.p, this.kept, this.state); },

        // The handle or the body under a point, -1 where there is none
        nearest(point) {
            if (this.experiment.grab && !this.run) return -1;
            const reach = 26 / this.stage.scale;
            let best = -1;
            let closest = Infinity;
            const look = ([x, y], k, size) => {
                const distance = Math.hypot(point[0] - x, point[1] - y);
                if (distance < Math.max(size, reach) && distance < closest) [best, closest] = [k, distance];
            };
            if (this.experiment.handles) this.handles().forEach((at, k) => look(at, k, 0));
            else this.run.states().forEach((at, k) => this.run.isStatic(k) || look(at, k, this.reaches[k]));
            return best;
        },

        pull() {
            if (this.experiment.handles) {
                this.move(this.held);
                this.draw();
            } else if (!this.isPlaying) {
                this.play(true);
            }
        },

        move(k) {
            this.experiment.move(k, this.target, this.p, this.kept, this.state);
            this.reset();
        },

        // A held body gets the velocity that brings it under the pointer soon
        follow() {
            const soon = 0.12;
            const fastest = 1.5 * (this.stage.view[2] - this.stage.view[0]);
            const [x, y] = this.run.states()[this.held];
            let [vx, vy] = [(this.target[0] - x) / soon, (this.target[1] - y) / soon];
            const speed = Math.hypot(vx, vy);
            if (speed > fastest) [vx, vy] = [(vx * fastest) / speed, (vy * fastest) / speed];
            this.steer(this.held, vx, vy);
        },

        steer(body, vx, vy) {
            if (this.run.steer(body, vx, vy)) this.isSteered = true;
        }
    };
})(globalThis);
