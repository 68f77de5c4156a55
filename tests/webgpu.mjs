/* webgpu.mjs - make webgpu-test: what a browser says of the WGSL that make glsl WGSL=1 makes. The tint that translates
   lets pass what browsers refuse: words that WGSL reserves.
   node tests/webgpu.mjs [WORD OF A TEST], from the repository's root; the texts lie in build/webgpu-test. */
import { readdirSync, readFileSync } from 'node:fs';
import { check, end, launch, note, run, serve, skip } from './web-kit.mjs';

const folder = 'build/webgpu-test/glsl', ending = '.wgsl';
const names = readdirSync(folder).filter(name => name.endsWith(ending));
const { rows, row_lists, variants } = JSON.parse(readFileSync(`${folder}/manifest.json`, 'utf8'));
const programs = variants.filter(({ files: { vert, frag, tesc } }) => vert && frag && !tesc)
    .map(({ files, rows: list }) => ({ vert: files.vert + ending, frag: files.frag + ending,
                                       rows: row_lists[list].map(i => rows[i]) }));
await run('every program has its two texts', () => {
    const lacking = programs.flatMap(({ vert, frag }) => [vert, frag]).filter(name => !names.includes(name));
    check(programs.length > 200 && !lacking.length, `${programs.length} programs lack ${lacking.join(' ')}`);
});

const browser = await launch('--enable-unsafe-webgpu', '--use-webgpu-adapter=swiftshader');
const page = await browser.newPage();
await page.goto(`${await serve('build/webgpu-test')}/empty.html`);
const adapter = await page.evaluate(async () => {
    const adapter = await navigator.gpu?.requestAdapter(), device = await adapter?.requestDevice();
    if (!device) return navigator.gpu ? 'no adapter for WebGPU, not even SwiftShader' : 'no WebGPU in this browser';
    globalThis.device = device;
    return { vendor: adapter.info.vendor, architecture: adapter.info.architecture };
});
if (typeof adapter === 'string') await skip(`everything: ${adapter}`);

/* Modules stay in the page for the pipelines. What is said of each text, by its name. */
const said = new Map(await page.evaluate(async names => {
    globalThis.modules = new Map();
    return Promise.all(names.map(async name => {
        const code = await (await fetch(`glsl/${name}`)).text(), lines = code.split('\n');
        const module = device.createShaderModule({ code, label: name });
        const { messages } = await module.getCompilationInfo();
        modules.set(name, module);
        return [name, messages.map(m => `${name}:${m.lineNum}: ${m.type}: ${m.message}: ${lines[m.lineNum - 1]}`)];
    }));
}, names));

const passOf = name => name.split('.')[0];
for (const pass of new Set(names.map(passOf)))
    await run(`every text of ${pass} is a module`, () => {
        const texts = names.filter(name => passOf(name) === pass);
        const wrong = texts.filter(name => said.get(name).length);
        note(`${texts.length} texts, ${wrong.length} refused`);
        check(!wrong.length, wrong.map(name => said.get(name)[0]).join('\n'));
    });

await run('both stages of every program make a pipeline', async () => {
    const sound = programs.filter(({ vert, frag }) => said.get(vert)?.length === 0 && said.get(frag)?.length === 0);
    const wrong = await page.evaluate(programs => {
        const formats = { float: 'r16float', vec2: 'rg16float', vec4: 'rgba16float',
                          uvec2: 'rg32uint', uvec4: 'rgba32uint' };
        const of = (rows, kind) => rows.filter(row => row.kind === kind);
        return Promise.all(programs.map(async ({ vert, frag, rows }) => {
            const attributes = of(rows, 'ATTRIBUTE').map(({ slot, type }) => ({
                shaderLocation: slot, offset: 16 * slot, format: type === 'vec3' ? 'float32x3' : 'float32x4' }));
            const targets = of(rows, 'OUTPUT').sort((a, b) => a.slot - b.slot)
                .map(({ type }) => ({ format: formats[type] }));
            const buffers = attributes.length ? [{ arrayStride: 16 * attributes.length, attributes }] : [];
            return device.createRenderPipelineAsync({
                layout: 'auto', vertex: { module: modules.get(vert), buffers },
                fragment: { module: modules.get(frag), targets }
            }).then(() => null, e => `${vert} ${frag}: ${e.message}`);
        })).then(all => all.filter(Boolean));
    }, sound);
    note(`${sound.length} programs, ${programs.length - sound.length} left out with a module that is refused`);
    check(!wrong.length, wrong.join('\n'));
});

const reserved = names.flatMap(name => said.get(name).map(line => /'(\w+)' is a reserved keyword/.exec(line)?.[1]))
    .filter(Boolean);
if (reserved.length) console.log(`        WGSL reserves: ${[...new Set(reserved)].join(' ')}`);
console.log(`        ${names.length} texts; WebGPU on ${adapter.vendor} ${adapter.architecture}`);
await end();
