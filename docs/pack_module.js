// The engine's module as a script: node pack_module.js flying.wasm > module.js
// Pages that are read from files may load scripts and nothing else: so base64, of LZMA, which theme/live/unpack.js unpacks.
// Against gzip it saves a quarter; the theme's script says which of LZMA's settings it knows.
'use strict';
const { execFileSync } = require('child_process');
const fs = require('fs');

const file = process.argv[2];
const packed = execFileSync('xz', ['--format=raw', '--lzma1=preset=9e,lc=3,lp=0,pb=0', '--stdout', file], { maxBuffer: 2 ** 26 });
process.stdout.write(`window.flyingModule = { size: ${fs.statSync(file).size}, packed: '${packed.toString('base64')}' };\n`);
