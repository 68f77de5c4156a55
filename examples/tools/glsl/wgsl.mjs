/* wgsl.mjs - translates SPIR-V to WGSL by tint, which npm's @babylonjs/core has in assets/twgsl. For translate.sh.

      node wgsl.mjs TWGSL OF FILE.spv ..      TWGSL.cjs (the package's twgsl.js) and TWGSL.wasm; writes FILE.wgsl, or
         prints the reason and has status 1. On a terminal it shows how many of OF are done */
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { resolve } from 'node:path';

/* Removes text that the rest implies: layout, offsets of members that follow from their types, types of values. */
const compact = text => text.replace(/^ *\/\* @offset\(\d+\) \*\/\n/gm, '').replace(/^\s+/gm, '')
    .replace(/^let (\w+) : .*? = /gm, 'let $1 = ');

const [tint, of, ...files] = process.argv.slice(2), said = [];
console.log = console.warn = console.error = line => said.push(line);        /* tint reports errors here */
const twgsl = await createRequire(import.meta.url)(resolve(`${tint}.cjs`))(resolve(`${tint}.wasm`));
for (const file of files) {
    said.length = 0;
    const text = twgsl.convertSpirV2WGSL(new Uint32Array(new Uint8Array(readFileSync(file)).buffer));
    if (said.length || !/@(vertex|fragment|compute\s+@workgroup_size\([^)]*\))\s+fn main/.test(text)) {
        /* a failure leaves an earlier text */
        process.stderr.write(`${file}: tint: ${said.join(' ').replace(/\s+/g, ' ') || 'no text'}\n`);
        process.exitCode = 1;
    } else writeFileSync(file.replace(/\.spv$/, '.wgsl'), compact(text));
    if (process.stderr.isTTY)
        process.stderr.write(`\r  tint: ${readdirSync('.').filter(name => name.endsWith('.wgsl')).length} of ${of}   `);
}
