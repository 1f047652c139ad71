// Plays recorded motion, where the engine can't run. A trace is a list: first {view, shapes}, then the frames {time, bodies, ghosts?}; a body or a ghost is
// [x, y, angle, ...]. A shape is {radius} or {rings: [[[x, y], ...], ...]} about the body's origin. Ghosts, drawn as outlines,
// are where the closed form has the same bodies.
// With ?at=S in the address every trace stands at the share S of its length, for pictures of the page.
'use strict';

(function () {
    const colours = ['#1f6fb4', '#c8501e', '#3d8b4f', '#8a4fa3', '#b58a00', '#158b94', '#b03a5b', '#5f6b77'];

    function outline(context, shape, [x, y, angle], spoke) {
        context.save();
        context.translate(x, y);
        context.rotate(angle || 0);
        context.beginPath();
        if (shape.radius !== undefined) {
            context.arc(0, 0, shape.radius, 0, 2 * Math.PI);
            if (spoke) {
                context.moveTo(0, 0);
                context.lineTo(shape.radius, 0);
            }
        } else {
            for (const ring of shape.rings) {
                ring.forEach(([px, py], k) => (k ? context.lineTo(px, py) : context.moveTo(px, py)));
                context.closePath();
            }
        }
        context.restore();
    }

    // The smallest view that holds all bodies at all times, where the trace names none
    function viewOf(header, frames) {
        if (header.view) return header.view;
        const view = [Infinity, Infinity, -Infinity, -Infinity];
        for (const frame of frames)
            frame.bodies.forEach(([x, y], k) => {
                const shape = header.shapes[k];
                const r = shape.radius || Math.max(...shape.rings.flat().map(([px, py]) => Math.hypot(px, py)));
                view[0] = Math.min(view[0], x - r), view[1] = Math.min(view[1], y - r);
                view[2] = Math.max(view[2], x + r), view[3] = Math.max(view[3], y + r);
            });
        return view;
    }

    function between(a, b, share) {
        return a.map((value, k) => value + (b[k] - value) * share);
    }

    function start(figure, trace) {
        const header = trace[0];
        const frames = trace.slice(1);
        const view = viewOf(header, frames);
        const first = frames[0].time;
        const last = frames[frames.length - 1].time;
        const canvas = figure.querySelector('canvas');
        const hasGhosts = frames.some((frame) => frame.ghosts);
        let time = first;
        let playing = false;
        let before = 0;

        const controls = document.createElement('div');
        controls.className = 'controls';
        controls.innerHTML = '<button class="play" aria-label="Play">\u25b6</button><button class="step" aria-label="Next moment">\u275a\u25b6</button>' +
            '<input type="range" min="0" max="1" step="any" value="0" aria-label="Moment"><output></output>' +
            (hasGhosts ? '<label><input type="checkbox" checked> exact</label>' : '');
        canvas.after(controls);
        const [play, step] = controls.querySelectorAll('button');
        const slider = controls.querySelector('input[type=range]');
        const shown = controls.querySelector('output');
        const ghost = controls.querySelector('input[type=checkbox]');

        function draw() {
            // Fit the view into the width, no higher than a window is
            const width = canvas.clientWidth;
            const ratio = (view[3] - view[1]) / (view[2] - view[0]);
            const height = Math.min(width * ratio, 420);
            const dots = window.devicePixelRatio || 1;
            canvas.width = Math.round(width * dots);
            canvas.height = Math.round(height * dots);
            canvas.style.height = height + 'px';
            const scale = 0.96 * Math.min(canvas.width / (view[2] - view[0]), canvas.height / (view[3] - view[1]));
            const context = canvas.getContext('2d');
            const style = getComputedStyle(canvas);
            const ink = style.getPropertyValue('--live-ink').trim() || '#20262c';
            const fixed = style.getPropertyValue('--live-fixed').trim() || '#b9bfc6';
            context.setTransform(scale, 0, 0, -scale, canvas.width / 2 - scale * (view[0] + view[2]) / 2,
                canvas.height / 2 + scale * (view[1] + view[3]) / 2);
            context.lineWidth = 1.6 * dots / scale;
            context.lineJoin = 'round';

            // Draw the moment between two frames
            let k = 0;
            while (k + 2 < frames.length && frames[k + 1].time <= time) ++k;
            const a = frames[k];
            const b = frames[Math.min(k + 1, frames.length - 1)];
            const share = b.time > a.time ? Math.min((time - a.time) / (b.time - a.time), 1) : 0;
            a.bodies.forEach((body, n) => {
                outline(context, header.shapes[n], between(body, b.bodies[n], share), true);
                context.fillStyle = header.fixed && header.fixed[n] ? fixed : colours[n % colours.length];
                context.globalAlpha = 0.88;
                context.fill('evenodd');
                context.globalAlpha = 0.5;
                context.strokeStyle = ink;
                context.stroke();
                context.globalAlpha = 1;
            });
            if (a.ghosts && ghost.checked) {
                context.setLineDash([5 * dots / scale, 4 * dots / scale]);
                context.strokeStyle = ink;
                a.ghosts.forEach((body, n) => {
                    outline(context, header.shapes[n], between(body, b.ghosts[n], share), false);
                    context.stroke();
                });
                context.setLineDash([]);
            }
            shown.textContent = time.toFixed(2) + ' s';
            slider.value = (time - first) / (last - first);
            play.textContent = playing ? '\u275a\u275a' : '\u25b6';
            play.setAttribute('aria-label', playing ? 'Pause' : 'Play');
        }

        function tick(now) {
            if (!playing) return;
            time += Math.min((now - before) / 1000, 0.1);
            before = now;
            if (time >= last) {
                time = last;
                playing = false;
            }
            draw();
            if (playing) requestAnimationFrame(tick);
        }

        function go(isOn) {
            if (isOn === playing) return;
            playing = isOn;
            if (playing && time >= last) time = first;
            before = performance.now();
            if (playing) requestAnimationFrame(tick);
            draw();
        }
        play.onclick = () => {
            wantsToPlay = !playing;
            go(wantsToPlay);
        };
        step.onclick = () => {
            playing = wantsToPlay = false;
            const next = frames.find((frame) => frame.time > time + 1e-12);
            time = next ? next.time : first;
            draw();
        };
        slider.oninput = () => {
            playing = wantsToPlay = false;
            time = first + (last - first) * slider.value;
            draw();
        };
        if (ghost) ghost.onchange = draw;
        new ResizeObserver(draw).observe(figure);
        new MutationObserver(draw).observe(document.documentElement, { attributes: true, attributeFilter: ['class'] });
        const at = new URLSearchParams(location.search).get('at');
        if (at !== null) time = first + (last - first) * Number(at);

        // As figures on the engine do: it starts once in view, unless the reader asked for less motion, and rests out of view
        let wantsToPlay = at === null && !window.matchMedia('(prefers-reduced-motion: reduce)').matches;
        new IntersectionObserver(([entry]) => {
            if (!entry.isIntersecting) {
                wantsToPlay = wantsToPlay || playing;
                go(false);
            } else if (wantsToPlay) {
                wantsToPlay = false;
                go(true);
            }
        }, { threshold: 0.35 }).observe(canvas);
        draw();
    }

    window.FlyingRecording = {
        start(figure) {
            const trace = (window.flyingTraces || {})[figure.dataset.trace];
            if (trace) start(figure, trace);
        }
    };
})();
