// A canvas in the scene's own metres, y up. All that live figures draw goes through here, so that they look alike.
'use strict';

(function (home) {
    const FONT = '"Book Sans", system-ui, sans-serif';
    const PALETTE = ['#2f7fc4', '#d4602b', '#3f9a57', '#9a5bb5', '#c29a12', '#1f9ca6', '#c24b6e', '#7b8894'];
    const TALLEST = 440;
    const SPECK = 4; // [px]

    class Stage {
        // view  [left, bottom, right, top] in metres
        constructor(canvas, view) {
            this.canvas = canvas;
            this.context = canvas.getContext('2d');
            this.view = view;
            this.tallest = TALLEST;
            this.palette = PALETTE;
        }

        // Take the width that the page gives, and the colours of its theme
        begin() {
            const [left, bottom, right, top] = this.view;
            const width = this.canvas.clientWidth || 600;
            const height = Math.round(Math.min((width * (top - bottom)) / (right - left), this.tallest));
            const dots = home.devicePixelRatio || 1;
            if (this.canvas.width !== Math.round(width * dots) || this.canvas.height !== Math.round(height * dots)) {
                this.canvas.width = Math.round(width * dots);
                this.canvas.height = Math.round(height * dots);
                this.canvas.style.height = height + 'px';
            }
            this.scale = Math.min(width / (right - left), height / (top - bottom));
            this.origin = [width / 2 - (this.scale * (left + right)) / 2, height / 2 + (this.scale * (bottom + top)) / 2];
            const style = getComputedStyle(this.canvas);
            const named = (name, otherwise) => style.getPropertyValue(name).trim() || otherwise;
            this.ink = named('--live-ink', '#20262c');
            this.soft = named('--live-soft', '#7c8791');
            this.fixed = named('--live-fixed', '#c3c9cf');
            this.ground = named('--live-ground', '#fbfbf9');
            const c = this.context;
            c.setTransform(dots, 0, 0, dots, 0, 0);
            c.globalAlpha = 1;
            c.fillStyle = this.ground;
            c.fillRect(0, 0, width, height);
            c.lineJoin = 'round';
            c.lineCap = 'round';
        }

        colour(k) { return PALETTE[k % PALETTE.length]; }
        at([x, y]) { return [this.origin[0] + this.scale * x, this.origin[1] - this.scale * y]; }

        // The point of the scene under the pointer
        under(event) {
            const box = this.canvas.getBoundingClientRect();
            return [(event.clientX - box.left - this.origin[0]) / this.scale,
                (this.origin[1] - (event.clientY - box.top)) / this.scale];
        }

        path(points, closed) {
            points.forEach((point, k) => this.context[k ? 'lineTo' : 'moveTo'](...this.at(point)));
            if (closed) this.context.closePath();
        }

        stroke(colour, { width = 1.8, dash = [], alpha = 1 } = {}) {
            const c = this.context;
            c.setLineDash(dash);
            c.lineWidth = width;
            c.globalAlpha = alpha;
            c.strokeStyle = colour;
            c.stroke();
            c.setLineDash([]);
            c.globalAlpha = 1;
        }

        fill(colour, alpha = 1) {
            this.context.globalAlpha = alpha;
            this.context.fillStyle = colour;
            this.context.fill('evenodd');
            this.context.globalAlpha = 1;
        }

        trace(shape, [x, y, angle = 0]) {
            const c = this.context;
            c.beginPath();
            if (shape.radius !== undefined) {
                const [px, py] = this.at([x, y]);
                c.arc(px, py, shape.radius * this.scale, 0, 2 * Math.PI);
                return;
            }
            const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
            for (const ring of shape.rings)
                this.path(ring.map(([px, py]) => [x + cosine * px - sine * py, y + sine * px + cosine * py]), true);
        }

        // A body; discs get a spoke, so that their turning can be seen, and outlines unless they are specks
        body(shape, state, { colour, isFixed = false, spoke = true, alpha = 0.85 } = {}) {
            this.trace(shape, state);
            this.fill(isFixed ? this.fixed : colour, isFixed ? 1 : alpha);
            if (shape.radius * this.scale < SPECK) return;
            this.stroke(this.ink, { width: 1.2, alpha: 0.55 });
            if (shape.radius === undefined || !spoke || isFixed) return;
            const [x, y, angle = 0] = state;
            this.line([[x, y], [x + shape.radius * Math.cos(angle), y + shape.radius * Math.sin(angle)]], this.ground,
                { width: 1.6, alpha: 0.9 });
        }

        ghost(shape, state, colour = this.ink) {
            this.trace(shape, state);
            this.stroke(colour, { width: 1.6, dash: [5, 4] });
        }

        line(points, colour, options) {
            if (points.length < 2) return;
            this.context.beginPath();
            this.path(points, false);
            this.stroke(colour, options);
        }

        area(points, colour, alpha = 0.3) {
            this.context.beginPath();
            this.path(points, true);
            this.fill(colour, alpha);
        }

        // A trail that fades into the past
        trail(points, colour, { width = 2 } = {}) {
            const pieces = 12;
            for (let k = 0; k < pieces; ++k) {
                const from = Math.floor((k * points.length) / pieces);
                const to = Math.floor(((k + 1) * points.length) / pieces);
                this.line(points.slice(from, to + 1), colour, { width, alpha: 0.12 + (0.75 * (k + 1)) / pieces });
            }
        }

        // A dot whose radius is in pixels
        dot(point, colour, radius = 4) {
            const c = this.context;
            c.beginPath();
            c.arc(...this.at(point), radius, 0, 2 * Math.PI);
            this.fill(colour);
        }

        ring(point, colour, radius = 8, options = {}) {
            const c = this.context;
            c.beginPath();
            c.arc(...this.at(point), radius, 0, 2 * Math.PI);
            this.stroke(colour, { width: 2, ...options });
        }

        arrow(from, to, colour, width = 2.4) {
            const [x0, y0] = this.at(from);
            const [x1, y1] = this.at(to);
            const length = Math.hypot(x1 - x0, y1 - y0);
            if (length < 2) return;
            const head = Math.min(10, length);
            const [ux, uy] = [(x1 - x0) / length, (y1 - y0) / length];
            const c = this.context;
            c.beginPath();
            c.moveTo(x0, y0);
            c.lineTo(x1 - 0.7 * head * ux, y1 - 0.7 * head * uy);
            this.stroke(colour, { width });
            c.beginPath();
            c.moveTo(x1, y1);
            c.lineTo(x1 - head * ux + 0.45 * head * uy, y1 - head * uy - 0.45 * head * ux);
            c.lineTo(x1 - head * ux - 0.45 * head * uy, y1 - head * uy + 0.45 * head * ux);
            c.closePath();
            this.fill(colour);
        }

        words(point, text, { colour = this.ink, size = 14, align = 'left', shift = [0, 0] } = {}) {
            const c = this.context;
            c.font = `${size}px ${FONT}`;
            c.textAlign = align;
            c.textBaseline = 'middle';
            const [x, y] = this.at(point);
            c.lineWidth = 3.5;
            c.strokeStyle = this.ground;
            c.strokeText(text, x + shift[0], y + shift[1]);
            c.fillStyle = colour;
            c.fillText(text, x + shift[0], y + shift[1]);
        }

        // The four walls of a box, drawn outside it
        walls([left, bottom, right, top]) {
            this.context.beginPath();
            this.path([[left, bottom], [right, bottom], [right, top], [left, top]], true);
            this.stroke(this.soft, { width: 2.5 });
        }

        floor(y = 0) {
            const [left, , right] = this.view;
            const [x0, y0] = this.at([left, y]);
            const [x1] = this.at([right, y]);
            const c = this.context;
            c.beginPath();
            c.rect(Math.min(0, x0), y0, Math.max(this.canvas.clientWidth, x1), this.canvas.clientHeight - y0);
            this.fill(this.fixed, 0.55);
            this.context.beginPath();
            c.moveTo(0, y0);
            c.lineTo(this.canvas.clientWidth, y0);
            this.stroke(this.soft, { width: 1.6 });
        }
    }

    // A curve over time under the stage: what is shown, and how large it got
    class Strip {
        constructor(canvas, { label, colour = 0, zero = true }) {
            Object.assign(this, { canvas, label, colour, zero, points: [] });
        }

        clear() { this.points = []; }

        add(time, value) {
            const { points } = this;
            while (points.length && points[points.length - 1][0] >= time) points.pop();
            if (Number.isFinite(value)) points.push([time, value]);
            if (points.length > 4000) points.splice(0, 1000);
        }

        draw(until) {
            const stage = new Stage(this.canvas, [0, 0, 1, 1]);
            const width = this.canvas.clientWidth;
            const dots = home.devicePixelRatio || 1;
            const c = stage.context;
            const font = `12.5px ${FONT}`;
            const { points } = this;
            const values = points.map((point) => point[1]);
            let low = Math.min(...values, this.zero ? 0 : Infinity);
            let high = Math.max(...values, this.zero ? 0 : -Infinity);
            if (!points.length) [low, high] = [0, 1];

            // On a narrow page the greatest value is written under the label, and the strip is higher
            const most = Math.abs(high) > Math.abs(low) ? high : low;
            const size = points.length ? 'up to ' + (Number.isInteger(most) ? most : short(most)) : '';
            if (high - low < 1e-300) high = low + 1;
            c.font = font;
            const isNarrow = c.measureText(this.label).width + c.measureText('up to \u2212' + short(1.1e-10)).width + 24 > width;
            const above = isNarrow ? 36 : 20;
            const height = 38 + above;
            this.canvas.width = Math.round(width * dots);
            this.canvas.height = Math.round(height * dots);
            this.canvas.style.height = height + 'px';
            c.setTransform(dots, 0, 0, dots, 0, 0);
            const style = getComputedStyle(this.canvas);
            const soft = style.getPropertyValue('--live-soft').trim() || '#7c8791';
            const first = points.length ? points[0][0] : 0;
            const last = Math.max(until || 0, points.length ? points[points.length - 1][0] : 1, first + 1e-9);
            const x = (time) => 6 + ((width - 12) * (time - first)) / (last - first);
            const y = (value) => height - 8 - ((height - above - 8) * (value - low)) / (high - low);
            c.beginPath();
            c.moveTo(6, y(Math.max(low, Math.min(0, high))));
            c.lineTo(width - 6, y(Math.max(low, Math.min(0, high))));
            stage.stroke(soft, { width: 1, alpha: 0.6 });
            c.beginPath();
            points.forEach(([time, value], k) => c[k ? 'lineTo' : 'moveTo'](x(time), y(value)));
            stage.stroke(stage.colour(this.colour), { width: 1.8 });
            c.font = font;
            c.fillStyle = soft;
            c.textBaseline = 'top';
            c.textAlign = 'left';
            c.fillText(this.label, 6, 2);
            c.textAlign = isNarrow ? 'left' : 'right';
            c.fillText(size, isNarrow ? 6 : width - 6, isNarrow ? 18 : 2);
        }
    }

    // A number in as many digits as anyone reads
    function short(x) {
        if (x === 0) return '0';
        const size = Math.abs(x);
        if (size >= 1e5 || size < 1e-3) {
            const [digits, power] = x.toExponential(1).split('e');
            return `${digits.replace('-', '\u2212')}\u00b710${[...String(Number(power))].map((d) => (d === '-' ? '\u207b' : '\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079'[d])).join('')}`;
        }
        return x.toFixed(size >= 100 ? 0 : size >= 10 ? 1 : size >= 0.1 ? 2 : 4).replace('-', '\u2212');
    }

    home.FlyingStage = { Stage, Strip, short };
})(globalThis);
