// The engine's module as a script: node pack_module.js flying.wasm > module.js
// Pages that are read from files may load scripts and nothing else: so base64, of LZMA, which theme/live/unpack.js unpacks.
'use strict';
const { execFileSync } = require('child_process');
const fs = require('fs');

const options = ['--format=lzma', '--lzma1=preset=9e,lc=4,lp=0,pb=0', '--keep', '--stdout'];
const packed = execFileSync('xz', [...options, process.argv[2]], { maxBuffer: 2 ** 24 });
packed.writeBigUInt64LE(BigInt(fs.statSync(process.argv[2]).size), 5); // xz leaves the size open
process.stdout.write(`window.flyingModule = '${packed.toString('base64')}';\n`);
