/* webgpu.mjs - make webgpu-test: WGSL in a browser. Each shader of make glsl WGSL=1 becomes a module, and with its
   other stage a pipeline; browsers refuse words that WGSL reserves, and the tint that translates does not. The page
   examples/hosts/webgpu.html draws with the package of make npm. webgpu-page.mjs compares the pictures of chains.
   node tests/pages/webgpu.mjs [WORD OF A TEST], from the repository's root; the shaders lie in build/webgpu-test. */
import { execFileSync, spawnSync } from 'node:child_process';
import { copyFileSync, mkdirSync, readdirSync, readFileSync } from 'node:fs';
import { check, end, launch, note, run, serve, skip, withWebgpu } from './web-kit.mjs';

const top = 'build/webgpu-test', folder = `${top}/glsl`, ending = '.wgsl';
const names = readdirSync(folder).filter(name => name.endsWith(ending));
const manifest = JSON.parse(readFileSync(`${folder}/manifest.json`, 'utf8'));
const { rows, row_lists, variants, chains } = manifest;
const programs = variants.filter(({ files: { vert, frag, tesc } }) => vert && frag && !tesc)
    .map(({ files, rows: list }) => ({ vert: files.vert + ending, frag: files.frag + ending,
                                       rows: row_lists[list].map(i => rows[i]) }));
const steps = chains.flatMap(chain => chain.steps.map(({ files }) =>
    ({ vert: files.vert + ending, frag: files.frag + ending })));

const browser = await launch(...withWebgpu);
const page = await browser.newPage();
const address = await serve(top);
copyFileSync('examples/tools/wasm/webgpu.mjs', `${top}/webgpu.mjs`);
await page.goto(`${address}/empty.html`);
const adapter = await page.evaluate(async () => {
    const adapter = await navigator.gpu?.requestAdapter();
    const features = ['float32-blendable'].filter(feature => adapter?.features.has(feature));
    const device = await adapter?.requestDevice({ requiredFeatures: features });
    if (!device) return navigator.gpu ? 'no adapter for WebGPU, not even SwiftShader' : 'no WebGPU in this browser';
    globalThis.device = device;
    return { vendor: adapter.info.vendor, architecture: adapter.info.architecture };
});
if (typeof adapter === 'string') await skip(`everything: ${adapter}`);

/* Modules stay in the page, as pipelines need them. said: the messages on each text, by its name. */
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

await run('every text is there, and a module', () => {
    const needed = [...programs, ...steps].flatMap(({ vert, frag }) => [vert, frag]);
    const lacking = needed.filter(name => !said.has(name));
    const refused = [...said.values()].flatMap(lines => lines[0] ?? []);
    note(`${names.length} shaders, ${refused.length} refused`);
    check(programs.length > 200 && steps.length > 100 && !lacking.length,
          `${programs.length} programs, ${steps.length} steps lack ${lacking.join(' ')}`);
    check(!refused.length, refused.join('\n'));
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

await run('every step of every chain makes a pipeline of its formats, blending and constants', async () => {
    const wrong = await page.evaluate(async manifest => {
        const { planOf, pipelineOf } = await import('./webgpu.mjs');
        return (await Promise.all(manifest.chains.flatMap(chain => planOf(manifest, chain).steps.map((step, i) => {
            const { vert, frag } = step.files, modules = { vert: `${vert}.wgsl`, frag: `${frag}.wgsl` };
            return device.createRenderPipelineAsync({ layout: 'auto', ...pipelineOf(step, {
                vert: globalThis.modules.get(modules.vert), frag: globalThis.modules.get(modules.frag) })
            }).then(() => null, e => `${chain.name}, step ${i + 1}: ${e.message}`);
        })))).filter(Boolean);
    }, manifest);
    note(`${steps.length} steps of ${chains.length} chains`);
    check(!wrong.length, wrong.join('\n'));
});

/* ---- compute stages, of what build/capture wrote */

/* Fragment and compute stages of a capture's chain, on the same inputs: how many bytes of the results differ. */
const drawn = (capture, folders) => page.evaluate(async (capture, folders) => {
    const { Passes, planOf } = await import('./webgpu.mjs');
    const get = async (path, as) => (await fetch(path))[as]();
    const { frames, textures } = await get(`${capture}/capture.json`, 'json');
    const data = number => get(`${capture}/${number}.bin`, 'arrayBuffer');
    const yours = await Promise.all(textures.map(async ({ webgpu: format, bytes, width, height, layers, data: at }) => {
        const texture = device.createTexture({ format, size: [width, height, layers || 1], usage: 2 | 4 });
        device.queue.writeTexture({ texture }, await data(at), { bytesPerRow: bytes * width, rowsPerImage: height },
                                  [width, height, layers || 1]);
        return texture;
    }));
    const read = async (texture, bytes) => {
        const { width, height } = texture, bytesPerRow = Math.ceil(bytes * width / 256) * 256;
        const buffer = device.createBuffer({ size: bytesPerRow * height, usage: 1 | 8 });
        const encoder = device.createCommandEncoder();
        encoder.copyTextureToBuffer({ texture }, { buffer, bytesPerRow }, [width, height]);
        device.queue.submit([encoder.finish()]);
        await buffer.mapAsync(1);
        const all = new Uint8Array(buffer.getMappedRange());
        return Array.from({ length: height }, (_, y) => all.slice(bytesPerRow * y, bytesPerRow * y + bytes * width));
    };
    const results = [];
    for (const folder of folders) {
        const manifest = await get(`${folder}/manifest.json`, 'json'), [chain] = manifest.chains, sizes = [], rows = [];
        chain.steps.forEach(({ outputs }, i) => outputs.forEach(({ texture }) => {
            sizes[texture] = [frames[0].steps[i].width, frames[0].steps[i].height];
        }));
        const plan = planOf(manifest, chain, sizes);
        const passes = new Passes(device, plan, async ({ files }) => Object.fromEntries(await Promise.all(
            Object.entries(files).map(async ([stage, name]) => [stage, device.createShaderModule({
                code: await get(`${folder}/${name}.wgsl`, 'text') })]))));
        await passes.ready;
        for (const { steps, draws, results: made } of frames) {
            const blocks = await Promise.all(steps.map(async ({ frame }) => {
                const bytes = await data(frame);
                const buffer = device.createBuffer({ size: bytes.byteLength, usage: 64 | 8 });
                device.queue.writeBuffer(buffer, 0, bytes);
                return buffer;
            }));
            for (let i = 0; i < draws; ++i) {
                passes.turn();
                const encoder = device.createCommandEncoder();
                passes.draw(encoder, { block: number => blocks[number], yours: (number, input) =>
                    yours[steps[number].yours[plan.steps[number].inputs.indexOf(input)]] ?? null });
                device.queue.submit([encoder.finish()]);
            }
            for (const { texture, is } of made)
                rows.push(...await read(passes.textures[texture][0], textures[is].bytes));
        }
        results.push({ rows, computes: plan.steps.every(({ group }) => group) });
    }
    const [is, wanted] = results.map(({ rows }) => rows.flatMap(row => [...row]));
    let differ = 0;
    is.forEach((byte, i) => { differ += byte !== wanted[i]; });
    return { differ, bytes: is.length, values: new Set(is).size, computes: results.map(({ computes }) => computes) };
}, capture, folders);

for (const [name, ...set] of [['hsao', 'room', 'hsao'], ['ssdo', 'room', 'ssdo', 'set', 'bounce=solid-angle'],
                              ['history', 'casters', 'hsao', 'set', 'history=1', 'frames', '4']])
    await run(`compute stages write the bytes that fragment stages draw: ${name}`, async () => {
        const folders = [`${name}-drawn`, `${name}-computed`];
        folders.forEach((folder, i) => {
            const env = { ...process.env, ...i && { KIT_COMPUTE: 'BASIC' } };
            execFileSync('build/capture', [`${top}/${folder}`, ...set, 'size', '160x90'], { env });
            execFileSync('sh', ['examples/tools/glsl/translate.sh', `${top}/${folder}`, 'wgsl'], { stdio: 'pipe' });
        });
        const { differ, bytes, values, computes } = await drawn(folders[0], folders);
        note(`${differ} of ${bytes} bytes differ`);
        check(!computes[0] && computes[1], `every step is a compute stage: ${computes}`);
        check(bytes >= 4 * 160 * 90 && values > 100, `${bytes} bytes of ${values} values: nothing is drawn`);
        check(!differ, `${differ} of ${bytes} bytes differ`);
    });

/* ---- the page */

const has = program => spawnSync('sh', ['-c', `command -v ${program}`]).status === 0;
if (!has('clang') || !has('wasm-ld')) console.log('skipped: examples/hosts/webgpu.html: no clang or wasm-ld');
else await run('examples/hosts/webgpu.html draws hsao out of what make npm packs', async () => {
    const to = `${top}/page`;
    execFileSync('make', ['-s', 'npm'], { stdio: ['ignore', 'ignore', 'inherit'],
                                          env: { ...process.env, MAKEFLAGS: '' } });
    mkdirSync(to, { recursive: true });
    const packed = readdirSync('build').find(name => /^ssgi-.*\.tgz$/.test(name));
    execFileSync('npm', ['install', '--no-save', '--silent', '--no-audit', '--no-fund', `../../${packed}`],
                 { cwd: to });
    copyFileSync('examples/hosts/webgpu.html', `${to}/index.html`);
    const said = [], host = await browser.newPage();
    host.on('console', line => said.push(line.text()));
    host.on('pageerror', error => said.push(error.message));
    await host.evaluateOnNewDocument(() => {        /* the canvas keeps its picture until the page's script ends */
        const { submit } = GPUQueue.prototype;
        GPUQueue.prototype.submit = function (buffers) {
            submit.call(this, buffers);
            globalThis.picture ??= document.querySelector('canvas').toDataURL();
        };
    });
    await host.goto(`${address}/page/`);
    await host.waitForFunction(() => globalThis.picture, { timeout: 30000 }).catch(() => said.push('nothing is drawn'));
    const grey = await host.evaluate(async () => {
        const image = new Image(), canvas = document.createElement('canvas'), context = canvas.getContext('2d');
        image.src = globalThis.picture ?? '';
        await image.decode();
        [canvas.width, canvas.height] = [image.width, image.height];
        context.drawImage(image, 0, 0);
        return Array.from(context.getImageData(0, 0, image.width, image.height).data.filter((_, i) => i % 4 === 0));
    }).catch(() => []);
    const mean = grey.reduce((sum, value) => sum + value, 0) / grey.length / 255;
    const at = (x, y) => grey[960 * y + x] / 255;
    note(`${packed}: mean ${mean.toFixed(3)}`);
    check(!said.length && grey.length === 960 * 540, `${grey.length} pixels; ${said.join('; ')}`);
    check(mean > 0.9 && mean < 0.99, `mean ${mean}`);
    check(at(480, 67) > 0.97 && at(40, 500) > 0.97, `not open: wall ${at(480, 67)}, floor ${at(40, 500)}`);
    check(at(600, 473) < 0.7 && at(445, 448) < 0.7, `below spheres ${at(600, 473)}, ${at(445, 448)}`);
    await host.close();
});

console.log(`        ${names.length} shaders; WebGPU on ${adapter.vendor} ${adapter.architecture}`);
await end();
