// What a test asks of a live figure: ?check in the address (tests/differential/live).
'use strict';

(function (home) {
    home.FlyingCheck = {
        outcome(what) {
            const { scene = null, time } = this;
            const pixels = this.canvas.getContext('2d').getImageData(0, 0, this.canvas.width, this.canvas.height).data;
            let sum = 0;
            for (let k = 0; k < pixels.length; k += 4) sum = (sum * 31 + pixels[k] + 7 * pixels[k + 1] + 13 * pixels[k + 2]) % 1000000007;
            const asks = this.asks.slice();
            return { what, time, fault: this.fault.textContent, pixels: sum, words: this.readout.textContent, asks,
                run: this.run && !this.isFailed ? { ...scene, hash: this.run.hash } : null };
        },

        // The figure at its controls as they come, then with each at every end or choice
        check() {
            const { experiment } = this;
            const end = experiment.checkTime || Math.min(1.5, this.until());
            const look = (what) => {
                this.go(end);
                this.draw();
                cases.push(this.outcome(what));
            };
            const cases = [];
            this.reset();
            look('as it comes');
            for (const [key, of] of Object.entries(experiment.controls || {})) {
                const values = of.options ? of.options.map(([value]) => value) : of.check ? [!of.value] : [of.min, of.max];
                const input = this.figure.querySelector(`[name="${key}"]`);
                for (const value of values) {
                    if (value === of.value) continue;
                    if (of.check) input.checked = value;
                    else input.value = value;
                    input.dispatchEvent(new Event(of.check || of.options ? 'change' : 'input'));
                    look(`${key} = ${value}`);
                }
                if (of.check) input.checked = of.value;
                else input.value = of.value;
                input.dispatchEvent(new Event(of.check || of.options ? 'change' : 'input'));
            }
            if (experiment.handles) {
                const [x, y] = this.handles()[0];
                this.target = [x + 0.21, y + 0.13];
                this.move(0);
                look('the first handle moved');
            }
            return { name: this.name, cases, startedAt: this.startedAt };
        }
    };
})(globalThis);
