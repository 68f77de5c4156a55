/* chains.mjs - for make npm: writes each method's chain, with its shaders in WGSL, as a module that bundlers can
   follow.
      node chains.mjs FOLDER TO         FOLDER: manifest.json and NAME.wgsl; TO: gets NAME.mjs
   A shader of several methods is a module of its own, which all of them import. */
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { planOf } from '../wasm/webgpu.mjs';

const [folder, to] = process.argv.slice(2), read = name => readFileSync(join(folder, name), 'utf8');
const manifest = JSON.parse(read('manifest.json'));
const modules = new Map();                          /* the name of each shader's module */
mkdirSync(join(to, 'shaders'), { recursive: true });
function moduleOf(name) {
    const text = read(`${name}.wgsl`);
    if (!modules.has(text)) {
        modules.set(text, name);
        writeFileSync(join(to, 'shaders', `${name}.mjs`), `export default ${JSON.stringify(text)};\n`);
    }
    return modules.get(text);
}
for (const chain of manifest.chains) {
    if (chain.name.includes(',')) continue;                                     /* a method with other settings */
    if (chain.textures.some(({ scale }) => scale === 'LEVELS')) continue;       /* sized by surfels */
    const { name, textures, steps } = planOf(manifest, chain), used = [];
    const imported = file => {
        const module = moduleOf(file);
        if (!used.includes(module)) used.push(module);
        return `import ${used.indexOf(module)}`;
    };
    const plan = { name, textures, steps: steps.map(({ files: { vert, frag }, rows, inputs, outputs, ...step }) => ({
        ...step, rows: rows.map(({ kind, slot, offset }) => ({ kind, slot, offset })),
        inputs: inputs.map(({ name: _, unit: __, ...input }) => input),
        outputs: outputs.map(({ texture, layer, format }) => ({ texture, layer, format })),
        code: { vert: imported(vert), frag: imported(frag) } })) };
    const imports = used.map((module, i) => `import shader${i} from './shaders/${module}.mjs';\n`).join('');
    const code = JSON.stringify(plan).replace(/"import (\d+)"/g, 'shader$1');
    writeFileSync(join(to, `${name}.mjs`), `${imports}export default ${code};\n`);
}
