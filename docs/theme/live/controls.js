// Controls of live figures: sliders, choices, ticks, each with its label.
'use strict';

(function (home) {

    function make(tag, attributes = {}, ...inside) {
        const element = document.createElement(tag);
        for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
        element.append(...inside);
        return element;
    }

    // One control with its label: a slider, a choice, or a tick. `changed` is called after each change.
    function knob(key, of, values, changed) {
        values[key] = of.value;
        const name = make('span', {}, of.label);
        if (of.options) {
            const select = make('select', { name: key });
            of.options.forEach(([value, label]) => select.append(make('option', { value }, label)));
            select.value = of.value;
            select.onchange = () => {
                values[key] = of.options.find(([value]) => String(value) === select.value)[0];
                changed();
            };
            return make('label', { class: 'choice' }, name, select);
        }
        if (of.check) {
            const tick = make('input', { type: 'checkbox', name: key });
            tick.checked = of.value;
            tick.onchange = () => { values[key] = tick.checked; changed(); };
            return make('label', { class: 'tick' }, tick, name);
        }
        const input = make('input', { type: 'range', name: key, min: of.min, max: of.max, step: of.step, value: of.value });
        const shown = make('output');
        // As many decimals as the step has; a unit stands apart, but for signs that belong to the number
        const decimals = (String(of.step).split('.')[1] || '').length;
        const unit = !of.unit || '\u00b0\u00d7'.includes(of.unit) ? of.unit || '' : '\u202f' + of.unit;
        const show = () => {
            const text = of.show ? of.show(values[key]) : values[key].toFixed(decimals).replace('-', '\u2212') + unit;
            shown.textContent = text;
            input.setAttribute('aria-valuetext', text);
        };
        input.oninput = () => { values[key] = Number(input.value); show(); changed(); };
        show();
        return make('label', { class: 'range' }, name, input, shown);
    }

    // What stands in a legend before its words: a picture of what is drawn, in its colour
    const SIGNS = {
        body: '<circle cx="11" cy="7" r="5.5" fill="currentColor"/>',
        ghost: '<circle cx="11" cy="7" r="5.5" fill="none" stroke="currentColor" stroke-width="1.6" stroke-dasharray="3.2 2.4"/>',
        line: '<path d="M1 7H21" stroke="currentColor" stroke-width="2.6"/>',
        dashes: '<path d="M1 7H21" stroke="currentColor" stroke-width="1.8" stroke-dasharray="5 3.5"/>',
        dot: '<circle cx="11" cy="7" r="3.4" fill="currentColor"/>',
        arrow: '<path d="M1 7H15" stroke="currentColor" stroke-width="2.4"/><path d="M21 7L13 2.6V11.4Z" fill="currentColor"/>'
    };
    function sign(kind) {
        const of = make('span', { class: 'sign' });
        of.innerHTML = `<svg viewBox="0 0 22 14" width="22" height="14">${SIGNS[kind]}</svg>`;
        return of;
    }

    home.FlyingControls = { make, knob, sign };
})(globalThis);
