/* wgsl.mjs - make web: translates every shader that the page's settings can need to WGSL.

      node wgsl.mjs SSGI.wasm SSGI.mjs FOLDER TO      FOLDER: for the GLSL; TO: a folder, gets KEY.wgsl, by keyOf the
                                                      GLSL that it comes from, and list.json of these keys: none of
                                                      them if there is no translator */
import { spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { Worker, isMainThread, parentPort, workerData } from 'node:worker_threads';
import { chainAs } from '../chain.mjs';
import { defaults, resolutions, methods, normals, presets, shadows, thicknesses } from '../settings.mjs';
import { textOf } from '../show-texts.mjs';
import { bare, keyOf } from '../webgpu-keys.mjs';

const [wasm, loader, folder, to] = process.argv.slice(2);
const { load } = await import(pathToFileURL(resolve(loader)).href), ssgi = await load(readFileSync(wasm));
const translate = join(dirname(fileURLToPath(import.meta.url)), '../../tools/glsl/translate.sh');

/* The settings that change shaders, each with all of its values. */
const every = {
    name: Object.keys(methods).filter(name => methods[name].method && !methods[name].module),
    preset: Object.keys(presets),
    thickness: Object.keys(thicknesses), normals: Object.keys(normals), resolution: Object.keys(resolutions),
    filter: [-1, 0, 1, 2, 3, 4],
    history: [false, true], moves: [false, true], bounce: [false, true], sun: [false, true], precise: [0, 1]
};
/* The settings that change shaders of pass LIGHTS and of the passes about it; all others have their defaults. */
const ofLights = {
    name: every.name.filter(name => methods[name].light), preset: ['BALANCED'], shadow: Object.keys(shadows),
    normals: every.normals, history: every.history, bounce: every.bounce, precise: every.precise
};
function* products([[name, values], ...rest]) {
    if (!name) { yield {}; return; }
    for (const value of values)
        for (const others of products(rest.length ? rest : [[]])) yield { [name]: value, ...others };
}

/* The shaders of this worker's share of all choices. */
const texts = new Map(), seen = new Set(), block = 2048;
const choices = isMainThread ? [] : [...products(Object.entries(every)), ...products(Object.entries(ofLights))]
    .filter((_, i) => Math.floor(i / block) % workerData.parts === workerData.part);
for (const { name, preset, precise, ...choice } of choices) {
    const chain = chainAs(ssgi, { ...defaults, ...choice }, name, preset, true,
                          { dialect: 'VULKAN', width: 64, height: 64, precise }), whole = JSON.stringify(chain);
    if (seen.has(whole)) continue;
    seen.add(whole);
    for (const { desc } of ssgi.steps(chain)) {
        const said = JSON.stringify(desc);          /* compared before the key, which takes as long as all other work */
        if (seen.has(said)) continue;
        seen.add(said);
        const key = `${desc.pass} ${ssgi.key(desc)}`;
        if (seen.has(key)) continue;
        seen.add(key);
        for (const stage of ['vert', 'frag']) {
            const text = ssgi.shader(desc, stage);
            add(keyOf(text), { text, stage });
        }
    }
}
function add(at, is) {
    const had = texts.get(at);
    if (had && bare(had.text) !== bare(is.text)) throw new Error(`two texts of key ${at}`);
    texts.set(at, is);
}
if (!isMainThread) parentPort.postMessage([...texts]);
else await translated();

async function translated() {
    const parts = availableParallelism(), argv = process.argv.slice(2), all = await Promise.all(
        Array.from({ length: parts }, (_, part) =>
            once(new Worker(new URL(import.meta.url), { argv, workerData: { part, parts } }), 'message')));
    for (const [some] of all) for (const [at, is] of some) add(at, is);
    for (const name of ['picture', 'smooth', 'motion']) {    /* the page's own shaders, as webgpu-show.mjs draws them */
        const text = textOf(name, 'VULKAN');
        add(keyOf(text), { text, stage: 'frag' });
    }

    for (const path of [folder, to]) {
        rmSync(path, { recursive: true, force: true });
        mkdirSync(path, { recursive: true });
    }
    const nameOf = ([key, { stage }]) => join(folder, `${key}.vulkan.${stage}`);
    for (const one of texts) writeFileSync(nameOf(one), one[1].text);
    console.log(`  ${texts.size} texts of WebGPU are translated, by glslangValidator and tint`);
    const { status } = spawnSync('sh', [translate, folder, 'wgsl'], { stdio: ['ignore', 'ignore', 'inherit'] });
    if (status === 2) {
        writeFileSync(join(to, 'list.json'), '[]');
        console.error('web: the page is made without WebGPU');
    } else if (status) process.exit(status);
    else {
        for (const one of texts) copyFileSync(`${nameOf(one)}.wgsl`, join(to, `${one[0]}.wgsl`));
        writeFileSync(join(to, 'list.json'), JSON.stringify([...texts.keys()]));
        console.log(`${to}: ${texts.size} texts`);
    }
}
