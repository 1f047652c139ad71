// The engine's module as a script: node pack_module.js flying.wasm > module.js
// Pages that are read from files may load scripts and nothing else: so base64, of gzip, which every browser unpacks by itself;
// zopfli packs it for seconds, and a twentieth smaller.
'use strict';
const { execFileSync } = require('child_process');

const packed = execFileSync('zopfli', ['-c', '--i15', process.argv[2]], { maxBuffer: 2 ** 24 });
process.stdout.write(`window.flyingModule = '${packed.toString('base64')}';\n`);
