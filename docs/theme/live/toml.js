// Scenes as text, from plain objects: the same text that `flying simulate` reads.
'use strict';

(function (home) {
    const list = (numbers) => '[' + numbers.map((x) => (Array.isArray(x) ? list(x) : String(x))).join(', ') + ']';

    function shape(body) {
        if (body.disc) return `{ kind = "disc", radius = ${body.disc} }`;
        if (body.rectangle) return `{ kind = "rectangle", width = ${body.rectangle[0]}, height = ${body.rectangle[1]} }`;
        if (body.regular) return `{ kind = "regular", sides = ${body.regular[0]}, radius = ${body.regular[1]} }`;
        return `{ kind = "polygon", vertices = ${list(body.polygon)} }`;
    }

    home.flyingScene = ({ until = 1000, gravity = null, restitution = 1, friction = 0, box = null, bodies }) => {
        const lines = [`until = ${until}`, '[world]'];
        if (gravity) lines.push(`field = { kind = "uniform", gravity = ${list(gravity)} }`);
        lines.push(`restitution = ${restitution}`, `friction = ${friction}`);
        if (box) lines.push(`box = { min = ${list(box.slice(0, 2))}, max = ${list(box.slice(2))} }`);
        for (const body of bodies) {
            lines.push('[[body]]', `shape = ${shape(body)}`, `position = ${list(body.at)}`);
            for (const key of ['angle', 'spin', 'density', 'mass', 'restitution', 'friction'])
                if (body[key] !== undefined) lines.push(`${key} = ${body[key]}`);
            if (body.velocity) lines.push(`velocity = ${list(body.velocity)}`);
            if (body.fixed) lines.push('static = true');
        }
        return lines.join('\n') + '\n';
    };
})(globalThis);
