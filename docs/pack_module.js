// The engine's module as a script: node pack_module.js flying.wasm > module.js
// Pages that are read from files may load scripts and nothing else: so base64, of gzip, which every browser unpacks by itself.
'use strict';
const fs = require('fs');
const zlib = require('zlib');

const packed = zlib.gzipSync(fs.readFileSync(process.argv[2]), { level: 9 });
process.stdout.write(`window.flyingModule = '${packed.toString('base64')}';\n`);
