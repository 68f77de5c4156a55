/* chains.mjs - for make npm: writes each method's chain, with its shaders in WGSL, as a module that bundlers can
   follow.
      node chains.mjs FOLDER TO         FOLDER: manifest.json and NAME.wgsl; TO: gets NAME.mjs */
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { planOf } from '../wasm/webgpu.mjs';

const [folder, to] = process.argv.slice(2), read = name => readFileSync(join(folder, name), 'utf8');
const manifest = JSON.parse(read('manifest.json'));
mkdirSync(to, { recursive: true });
for (const chain of manifest.chains) {
    if (chain.name.includes(',')) continue;                                     /* a method with other settings */
    if (chain.textures.some(({ size }) => size === 'LEVELS')) continue;         /* sized by surfels */
    const { name, textures, steps } = planOf(manifest, chain);
    const plan = { name, textures, steps: steps.map(({ files: { vert, frag }, rows, inputs, outputs, ...step }) => ({
        ...step, rows: rows.map(({ kind, slot, offset }) => ({ kind, slot, offset })),
        inputs: inputs.map(({ name: _, unit: __, ...input }) => input),
        outputs: outputs.map(({ texture, slice, format }) => ({ texture, slice, format })),
        code: { vert: read(`${vert}.wgsl`), frag: read(`${frag}.wgsl`) } })) };
    writeFileSync(join(to, `${name}.mjs`), `export default ${JSON.stringify(plan)};\n`);
}
