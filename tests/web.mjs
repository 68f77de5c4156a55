/* web.mjs - make web-test: the texts of WebGL 2 and the page of make web in a browser without a window.
   node tests/web.mjs [WORD OF A TEST], from the repository's root after make web. */
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, statSync, readdirSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { read, write } from '../examples/web/settings.mjs';
import { check, end, launch, note, rest, run, serve } from './web-kit.mjs';
import { calls, draco, glowingWedge, hashes, hdr, indexed, meshopt, models, unsound, wedge,
         works } from './web-hostile.mjs';

const browser = await launch('--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist',
                             '--hide-scrollbars');
const root = await serve('build');

const said = [];                                    /* what consoles said that is wrong */
async function open(hash, { width = 1280, height = 800, scale = 1, before = null, motion = null } = {}) {
    const page = await browser.newPage();
    page.on('console', m => {
        if (/was preloaded .* but not used/.test(m.text())) return;     /* on a busy machine; a wrong name is a 404 */
        if (['error', 'warn', 'warning'].includes(m.type())) said.push(`${hash}: ${m.type()}: ${m.text()}`);
    });
    page.on('pageerror', e => said.push(`${hash}: ${e.message}`));
    page.on('requestfailed', r => said.push(`${hash}: ${r.url()}: ${r.failure()?.errorText}`));
    await page.setViewport({ width, height, deviceScaleFactor: scale, isMobile: width < 600, hasTouch: width < 600 });
    if (motion) await page.emulateMediaFeatures([{ name: 'prefers-reduced-motion', value: motion }]);
    if (before) await page.evaluateOnNewDocument(before);
    await page.goto(`${root}/web/#${hash}`, { waitUntil: 'domcontentloaded' });
    await page.waitForFunction('globalThis.page && (page.first || page.lacks)', { timeout: 60000 });
    return page;
}
const render = (...words) =>
    execFileSync('build/render', words, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });

/* ---- without a page: the loader and the address */

const says = (message, wanted) => (typeof wanted === 'string' ? message === wanted : wanted.test(message));
await run('ssgi.mjs names what is wrong with an argument', async () => {
    const loader = await import('../build/wasm/ssgi.mjs'), bytes = readFileSync('build/wasm/ssgi.wasm');
    const { exports } = await WebAssembly.instantiate(await WebAssembly.compile(bytes), { Math });
    const ssgi = new loader.Ssgi(exports), all = calls(loader, ssgi), wrong = [];
    for (const [call, wanted] of all) {
        const e = await Promise.resolve().then(call).then(() => null, e => e);
        if (e?.constructor !== Error || !says(e.message, wanted)) wrong.push(`${call}: ${e?.name}: ${e?.message}`);
    }
    check(!wrong.length, wrong.join('\n'));
    check(works(ssgi), 'what is right is refused, too');
    const many = new Float32Array(9e6), told = new Set();
    exports.memory.grow = () => { throw new RangeError('no more'); };
    for (let i = 0; i < 5000; ++i) try { ssgi.trace(many); } catch (e) { told.add(e.message); }
    check(told.size === 1 && /^position: would take \d+ MB of memory, more than this machine gives$/.test([...told][0]),
          [...told].join('\n'));
    check(works(ssgi), 'what failed kept its memory');
    note(`${all.length} calls`);
});

const limits = { scenes: ['room', 'bunny', 'cornell'], side: 4096, pixels: 1920 * 1080 };
await run('any address is read: sound settings, a sentence for what cannot be had', () => {
    const before = read('a=s3ho&p=FAST&sky=white&size=640x360&cam=1,2,3,4,5,6&radius=1&thickness_limit=1', limits).set;
    let sentences = 0;
    for (const hash of hashes(4000, 1)) {
        const { set, wrong } = read(hash, limits, before), again = read(write(set), limits);
        const bad = unsound(set, limits), at = JSON.stringify(hash.slice(0, 200));
        check(!bad, `${at} gives ${bad}`);
        for (const sentence of wrong)
            check(/^.{0,60}: (must be .+|there is no such setting)$/su.test(sentence) && !/\n/.test(sentence)
                  && sentence.length < 300, `${at} says ${sentence}`);
        check(!again.wrong.length && write(again.set) === write(set), `${at} is written as ${write(set)}`);
        sentences += wrong.length;
    }
    check(sentences > 4000, `only ${sentences} sentences`);
    check(Object.keys(Object.prototype).length === 0, 'Object.prototype has got members');
    for (const [hash, wanted] of [
        ['size=9999x9999',
         'size=9999x9999: must be auto or WIDTHxHEIGHT, 16 to 4096 pixels each, at most 2073600 in all'],
        ['size=1921x1080',
         'size=1921x1080: must be auto or WIDTHxHEIGHT, 16 to 4096 pixels each, at most 2073600 in all'],
        ['radius=', 'radius=: must be a number from -2 to 2'],
        ['p=constructor', 'p=constructor: must be one of FAST, BALANCED, BEST'],
        ['sky=toString', 'sky=toString: must be one of sky, windows, white'],
        ['sky=file', 'sky=file: must be opened again: a sky of your own is in no address'],
        ['steps=1.5', 'steps=1.5: must be a whole number from 1 to 32, or 0 for the preset\'s'],
        ['filter=5', 'filter=5: must be a whole number from 0 to 4, or -1 for the preset\'s'],
        ['scene=file', 'scene=file: must be opened again: a model of your own is in no address'],
        ['cam=1,2,3,1,2,3', 'cam=1,2,3,1,2,3: must be six numbers, an eye and a target elsewhere, -1e9 to 1e9'],
        ['radius=3', 'radius=3: must be a number from -2 to 2'],
        ['thickness_limit=-2', 'thickness_limit=-2: must be a number from 0 to 2, or -1 for the method\'s own'],
        ['sun=yes', 'sun=yes: must be 0 or 1'], ['constructor=1', 'constructor: there is no such setting']]) {
        const { set, wrong } = read(hash, limits, before), [name] = hash.split('=');
        check(wrong.length === 1 && wrong[0] === wanted, `${hash}: ${wrong}`);
        check(set[name] === before[name] || !Object.hasOwn(before, name), `${hash} changes ${name}`);
    }
    check(read('a=ssao&a=hsao&b=none&a=ssdo', limits).set.a === 'ssdo', 'of a name that is repeated the last counts');
    note(`4,000 addresses, ${sentences} sentences`);
});

/* ---- the page */

const page = await open('size=960x540&history=0');
await run('the page draws', async () => {
    const first = await page.evaluate('page.first');
    note(`first picture after ${(first / 1000).toFixed(2)} s at 960x540`);
    const shown = await page.evaluate(() => {
        const gl = document.getElementById('canvas').getContext('webgl2');
        return gl && !gl.isContextLost();
    });
    check(shown, 'no picture');
});

/* ---- the texts */

await run('every text of WebGL 2 compiles, vertex and fragment of every variant link', async () => {
    const page = await browser.newPage();
    await page.goto(`${root}/web-test/empty.html`);
    const { texts, programs, wrong, renderer } = await page.evaluate(async () => {
        const gl = document.createElement('canvas').getContext('webgl2');
        const shaders = new Map(), programs = [], wrong = [];
        const info = gl.getExtension('WEBGL_debug_renderer_info');
        gl.getExtension('KHR_parallel_shader_compile');
        const { variants } = await (await fetch('glsl/manifest.json')).json();
        const kinds = { vert: gl.VERTEX_SHADER, frag: gl.FRAGMENT_SHADER };
        const files = new Set(variants.flatMap(v => Object.values(v.files)));
        await Promise.all([...files].map(async file => {
            const text = await (await fetch(`glsl/${file}`)).text();
            const shader = gl.createShader(kinds[file.split('.').pop()]);
            gl.shaderSource(shader, text);
            gl.compileShader(shader);
            shaders.set(file, shader);
        }));
        for (const { files: { vert, frag } } of variants) {
            const program = gl.createProgram();
            gl.attachShader(program, shaders.get(vert));
            gl.attachShader(program, shaders.get(frag));
            gl.linkProgram(program);
            programs.push({ program, vert, frag });
        }
        for (const [file, shader] of shaders)
            if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) || gl.getShaderInfoLog(shader).trim())
                wrong.push(`${file}: ${gl.getShaderInfoLog(shader)}`);
        for (const { program, vert, frag } of programs)
            if (!gl.getProgramParameter(program, gl.LINK_STATUS))
                wrong.push(`${vert} ${frag}: ${gl.getProgramInfoLog(program)}`);
        return { texts: shaders.size, programs: programs.length, wrong,
                 renderer: gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER) };
    });
    await page.close();
    note(`${texts} texts compiled, ${programs} programs linked, ${wrong.length} with a complaint; ${renderer}`);
    check(texts > 200 && programs > 200, `only ${texts} texts, ${programs} programs`);
    check(!wrong.length, wrong.join('\n'));
});

/* A result of the page against a PNG of build/render, top row first. */
const go = hash => page.evaluate(h => page.go(h), hash);
const against = png => {
    return page.evaluate(async bytes => {
        const blob = await (await fetch(`data:image/png;base64,${bytes}`)).blob();
        const image = await createImageBitmap(blob, { colorSpaceConversion: 'none' });
        const { width, height, pixels } = page.result(0), canvas = new OffscreenCanvas(image.width, image.height);
        if (width !== image.width || height !== image.height) return { rmse: NaN };
        const context = canvas.getContext('2d', { willReadFrequently: true });
        context.drawImage(image, 0, 0);
        const { data } = context.getImageData(0, 0, width, height);
        let sum = 0, near = 0, least = 1;
        for (let y = 0; y < height; ++y)
            for (let x = 0; x < width; ++x) {
                const is = pixels[(height - 1 - y) * width + x], off = is - data[4 * (y * width + x)] / 255;
                sum += off * off;
                near += Math.abs(off) < 1.5 / 255;
                least = Math.min(least, is);
            }
        return { rmse: Math.sqrt(sum / (width * height)), near: near / (width * height), least };
    }, readFileSync(png).toString('base64'));
};
const out = 'build/web-test';
/* Both draw the scene: at silhouettes rasterisers differ by a pixel here and there, which fine scenes have many of. */
for (const [scene, hash, words] of [
    ['casters', 'a=hsao', ['hsao']], ['casters', 'a=hsao&p=BEST', ['hsao-best']], ['casters', 'a=ssao', ['ssao']],
    ['casters', 'a=march', ['hsao-march']], ['casters', 'a=hsao&thickness=BACK', ['hsao', '--set', 'thickness=back']],
    ['casters', 'a=hsao&thickness=SLABS', ['hsao', '--set', 'thickness=slabs']],
    ['casters', 'a=hsao&slices=3&steps=7&half=NONE&filter=2',
     ['hsao', '--set', 'directions=3,steps=7,half=none,blur=2']],
    ['plates', 'a=hsao&p=FAST', ['hsao-fast']]])
    await run(`ambient visibility is build/render's: ${scene}, ${words.join(' ')}`, async () => {
        render(scene, '--method', ...words, '--size', '480x270', '--out', `${out}/ao.png`);
        await go(`scene=${scene}&b=off&size=480x270&history=0&radius=0&${hash}`);
        const { rmse, near, least } = await against(`${out}/ao.png`);
        note(`RMSE ${rmse.toFixed(4)}, ${(100 * near).toFixed(1)} % of pixels within 1/255`);
        check(least < 0.8, 'nothing is occluded');
        check(rmse <= 0.006, `RMSE ${rmse}`);
    });
await run('deep screen space is build/render\'s: its surfels are made in a worker', async () => {
    const found = [];
    for (const [scene, hash, words] of [['casters', '', ['--set', 'levels=4']],
                                        ['plates', '&p=BEST', ['--set', 'levels=4,half=0,steps=7']],
                                        ['cornell', '&surfel=1.5&levels=3', ['--set', 'size=0.015,levels=3']]]) {
        render(scene, '--method', 'dss', ...words, '--size', '320x180', '--out', `${out}/ao.png`);
        await go(`scene=${scene}&b=off&size=320x180&history=0&radius=0&a=dss${hash}`);
        const { rmse, least } = await against(`${out}/ao.png`);
        found.push(`${scene} ${rmse.toFixed(4)}`);
        check(least < 0.8 && rmse <= 0.006, found.join(', '));
    }
    note(`RMSE ${found.join(', ')}`);
});
await run('while the camera moves the last surfels stay where they are in the world', async () => {
    await go('scene=casters&b=off&size=320x180&history=0&radius=0&a=dss');
    const { turned, left } = await page.evaluate(async () => {
        const frame = () => new Promise(requestAnimationFrame), { postMessage } = Worker.prototype, held = [];
        const off = (a, b) => Math.sqrt(a.reduce((sum, v, i) => sum + (v - b[i]) ** 2, 0) / a.length);
        const { stage } = page.inside(), [x, y, z] = stage.info.eye, before = page.result(0).pixels;
        Worker.prototype.postMessage = function (...all) { held.push(() => postMessage.apply(this, all)); };
        const cam = [x + 0.15 * stage.info.radius, y + 0.1 * stage.info.radius, z, ...stage.info.target];
        location.hash += `&cam=${cam.join()}`;
        while (!held.length) await frame();
        for (let i = 0; i < 3; ++i) await frame();
        const last = page.result(0).pixels;
        Worker.prototype.postMessage = postMessage;
        held.forEach(send => send());
        while (page.making()) await frame();
        for (let i = 0; i < 3; ++i) await frame();
        const made = page.result(0).pixels;
        return { turned: off(last, made), left: off(before, made) };
    });
    note(`the picture of the last ones is ${turned.toFixed(4)} from that of new ones, that of the last view ${
        left.toFixed(4)}`);
    check(turned < 0.02 && left > 2 * turned, `${turned} ${left}`);
});

/* Both read one G-buffer, which the page drew and which brings its camera and radius. */
await run('the same of one G-buffer, that of the page: room', async () => {
    await go('scene=room&b=off&size=480x270&history=0&radius=0');
    const bytes = await page.evaluate(() => {
        const file = page.frame();
        let text = '';
        for (let i = 0; i < file.length; i += 32768) text += String.fromCharCode(...file.subarray(i, i + 32768));
        return btoa(text);
    });
    writeFileSync(`${out}/frame.exr`, Buffer.from(bytes, 'base64'));
    const found = [];
    for (const [hash, words] of [['a=hsao', ['hsao']], ['a=hsao&p=FAST', ['hsao-fast']],
                                 ['a=hsao&p=BEST', ['hsao-best']],
                                 ['a=ssao', ['ssao']], ['a=march', ['hsao-march']],
                                 ['a=hsao&normals=FROM_DEPTH', ['hsao', '--set', 'normal=depth']]]) {
        render('--gbuffer', `${out}/frame.exr`, '--method', ...words, '--out', `${out}/ao.png`);
        await go(`scene=room&b=off&size=480x270&history=0&radius=0&${hash}`);
        const { rmse } = await against(`${out}/ao.png`);
        found.push(`${words.join(' ')} ${rmse.toFixed(4)}`);
        check(rmse <= 0.006, found.join(', '));
    }
    /* in light, which tells where the camera was: the scene's own picture, but for silhouettes */
    const lit = ['--method', 'ssdo', '--env', 'sky', '--set', 'bounce=none'];
    render('room', '--size', '480x270', ...lit, '--out', `${out}/lit.exr`);
    const told = render('--gbuffer', `${out}/frame.exr`, ...lit, '--score', `${out}/lit.exr`);
    const off = +/irradiance: RMSE ([\d.]+)/.exec(told)[1];
    note(`RMSE ${found.join(', ')}; of light ${off}`);
    check(off < 0.02, `light from the frame's own camera: RMSE ${off}`);
});

await run('the truth traced in the page is build/render\'s: the same error of hsao', async () => {
    render('room', '--truth', '64', '--size', '480x270', '--out', `${out}/truth.exr`);
    const told = render('room', '--method', 'hsao', '--size', '480x270', '--score', `${out}/truth.exr`);
    const wanted = +/RMSE ([\d.]+)/.exec(told)[1];
    await go('b=truth&size=480x270&history=0&radius=0');
    await page.waitForFunction('page.rays() >= 8', { timeout: 60000 });
    const [is, rays] = await page.evaluate('[page.error(0), page.rays()]');
    note(`RMSE ${is.toFixed(4)} by ${rays} rays a pixel, ${wanted.toFixed(4)} by build/render's 64`);
    check(Math.abs(is - wanted) < 0.003, `${is} against ${wanted}`);
});
await run('and of light: the same error of ssdo under the sky', async () => {
    const words = ['casters', '--method', 'ssdo', '--env', 'sky', '--set', 'bounce=none', '--size', '240x136'];
    render(...words, '--truth', '64', '--out', `${out}/truth.exr`);
    const wanted = +/irradiance: RMSE ([\d.]+)/.exec(render(...words, '--score', `${out}/truth.exr`))[1];
    await go('scene=casters&a=ssdo&b=truth&size=240x136&history=0&radius=0');
    await page.waitForFunction('page.rays() >= 16', { timeout: 60000 });
    const is = await page.evaluate('page.error(0)');
    note(`RMSE ${is.toFixed(4)}, ${wanted.toFixed(4)} by build/render, noise of its 64 rays and all`);
    check(Math.abs(is - wanted) < 0.004, `${is} against ${wanted}`);
});

/* A control of the panel is set as a visitor does it; resolves when that is drawn. */
const put = (page, name, value) => page.evaluate(async (name, value) => {
    const all = [...document.getElementById('panel').elements].filter(e => e.name === name);
    const control = all.length > 1 ? all.find(e => e.value === value) : all[0];
    if (!control || control.disabled) throw new Error(`${name}: there is no such control`);
    if (control.type === 'checkbox' || control.type === 'radio') control.checked = value !== false;
    else control.value = value;
    control.dispatchEvent(new Event('input', { bubbles: true }));
    for (let i = 0; i < 3 || page.making(); ++i) await new Promise(requestAnimationFrame);
}, name, value);

await run('the truth is there soon, the error readable: a map, its worst, the pointer\'s pixel, a share', async () => {
    const begun = said.length, page = await open('size=320x180&a=hsao&b=truth&view=difference&history=0');
    const seconds = rays => page.evaluate(async rays => {
        const since = performance.now();
        while (!(page.truth()?.rays >= rays)) await new Promise(requestAnimationFrame);
        return (performance.now() - since) / 1000;
    }, rays);
    note(`16 rays at every 4th pixel ${(await seconds(16)).toFixed(1)} s after the picture`);
    const box = await page.evaluate(() => {
        const { left, top, width, height } = document.getElementById('canvas').getBoundingClientRect();
        return { left, top, width, height };
    });
    await page.mouse.move(box.left + 0.25 * box.width, box.top + 0.6 * box.height);
    await page.waitForFunction(`!document.getElementById('worst').hidden`, { timeout: 20000 });
    const told = await page.evaluate(() => {
        const text = id => document.getElementById(id).textContent, at = document.getElementById('worst');
        const all = page.picture(), { width, height } = page.inside().size, sides = [[], []];
        for (let i = 0; i < width * height; ++i)
            sides[+(i % width > width / 2)].push((all[4 * i] + all[4 * i + 1] + all[4 * i + 2]) / 765);
        const mean = v => v.reduce((sum, x) => sum + x, 0) / v.length;
        const spread = v => Math.sqrt(mean(v.map(x => (x - mean(v)) ** 2)));
        const { left, top } = at.getBoundingClientRect();
        const wide = id => document.getElementById(id).offsetWidth;
        return { error: text('error'), here: text('here'), rays: text('rays'), worst: at.textContent, left, top,
                 mean: sides.map(mean), spread: sides.map(spread), legend: wide('legend'),
                 overflow: document.getElementById('status').scrollWidth - wide('picture') };
    });
    note(`${told.error}; ${told.here}; ${told.worst}; ${told.rays}`);
    check(/^RMSE 0\.\d{4}, \d+ % of no occlusion’s 0\.\d{4}$/.test(told.error), told.error);
    check(/^here 0\.\d{3}, truth [01]\.\d{3} ± 0\.\d{3}$/.test(told.here), told.here);
    check(/^worst [−+]0\.\d\d$/.test(told.worst) && told.left < box.left + box.width / 2 && told.top > 0, told.worst);
    check(told.legend > 150 && told.overflow < 0, 'no legend, or out of the picture');
    check(told.mean[0] > 0.6 && told.spread[0] > 0.03 && told.spread[1] > 0.08,
          `map ${told.mean[0]} +- ${told.spread[0]}, truth +- ${told.spread[1]}`);
    await page.waitForFunction('page.rays() >= 16', { timeout: 60000 });
    const { rmse, none, wanted } = await page.evaluate(() => {
        const truth = page.truth(), all = truth.texels(), { none, rmse } = page.errors()[0];
        let sum = 0, n = 0;
        for (let i = 3; i < all.length; i += 4) {          /* what its rays leave open is taken off */
            const v = all[i];
            if (v > 0) { sum += (1 - v) ** 2 - v * (1 - v) / truth.rays / 2; ++n; }
        }
        return { none, rmse, wanted: Math.sqrt(sum / n) };
    });
    check(Math.abs(none / wanted - 1) < 0.03 && rmse < 0.6 * none, `no occlusion errs ${none}, ${wanted} by its truth`);
    await page.evaluate('page.go("size=320x180&a=hsao&b=none&view=difference&history=0")');
    await seconds(16);
    await page.mouse.move(box.left + 0.75 * box.width, box.top + 0.6 * box.height);
    const right = await page.$eval('#here', e => e.textContent);
    check(/^here 1\.000, truth/.test(right), `on the right, where nothing occludes: ${right}`);
    check(said.length === begun, said.slice(begun).join('\n'));
    await page.close();
});
await run('a scene has its light, a method the view that shows it, and what moves is seen everywhere', async () => {
    const begun = said.length, page = await open('size=160x90&history=0'), is = what => page.evaluate(what);
    check(await is('page.set.sky') === 'windows' && await is('page.set.view') === 'lit', 'the first scene');
    await put(page, 'scene', 'cornell');
    check(await is('page.set.bounce && !page.set.sun && page.set.sky') === 'white', 'Cornell\'s box');
    await put(page, 'scene', 'casters');
    check(await is('!page.set.bounce && page.set.sun && page.set.sky') === 'sky', 'after Cornell\'s box');
    await put(page, 'a', 'ssdo');
    check(await is('page.set.bounce && page.set.view') === 'ambient', 'SSDO is chosen');
    await put(page, 'view', 'lit');
    await put(page, 'a', 'hsao');
    check(await is('page.set.view') === 'lit', 'a view that was chosen does not stay');
    await is('page.go("size=160x90&history=0&moves=1")');
    const shares = [];
    for (const scene of await is('[...document.querySelector("[name=scene]").options].map(o => o.value)')) {
        await put(page, 'scene', scene);
        await page.waitForFunction(`page.inside().stage.info.name === '${scene}'`, { timeout: 30000 });
        await rest(300);
        shares.push([scene, ...await page.evaluate(() => {
            const { stage, show, size: { width, height }, gl } = page.inside(), seen = [];
            const framebuffer = gl.createFramebuffer(), all = new Uint32Array(4 * width * height);
            for (const seconds of [0, 2.2, 4.5, 6.7]) {
                stage.move(seconds);
                const drawn = stage.draw(0), texture = show.objects(width, height, drawn);
                const { Z } = show.frame(width, height, drawn, [0, 1]);         /* 0: nothing is there */
                gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
                gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
                gl.readPixels(0, 0, width, height, gl.RGBA_INTEGER, gl.UNSIGNED_INT, all);
                seen.push(Z.filter((z, i) => z > 0 && all[4 * i] === 1).length / (width * height));
            }
            gl.deleteFramebuffer(framebuffer);
            return seen;
        })]);
    }
    note(shares.map(([scene, ...seen]) => `${scene} ${seen.map(s => (100 * s).toFixed(1)).join(' ')} %`).join(', '));
    for (const [scene, ...seen] of shares) check(seen.filter(s => s > 0.002).length >= 3, `${scene}: ${seen}`);
    check(said.length === begun, said.slice(begun).join('\n'));
    await page.close();
});

/* A side's light, and the sun that is in it, as a file that build/render scores against. */
async function lightFile(path) {
    const { sun, bytes } = await page.evaluate(async () => {
        const { exr } = await import('./exr.mjs'), { width, height, pixels } = page.result(0), light = {};
        ['R', 'G', 'B'].forEach((name, c) => {
            const one = Float32Array.from({ length: width * height }, (_, i) => pixels[4 * i + c]);
            for (const of of ['', 'irradiance.', 'bounce.']) light[of + name] = one;
        });
        const file = exr(width, height, light);
        let text = '';
        for (let i = 0; i < file.length; i += 32768) text += String.fromCharCode(...file.subarray(i, i + 32768));
        return { sun: page.inside().stage.sunlight, bytes: btoa(text) };
    });
    writeFileSync(path, Buffer.from(bytes, 'base64'));
    return `sun:${[...sun.toSun, ...sun.irradiance].join()}`;
}
const scored = (words, file, sets) => {
    const told = render(...words, '--method', 'ssdo', '--env', 'sky', '--set', `bounce=none,${sets}`, '--score', file);
    const [, rmse, mean, p95] = /irradiance: RMSE ([\d.]+) \([\d.]+ of its mean ([\d.]+)\).* p95 ([\d.]+)/.exec(told);
    return { rmse: rmse / mean, p95: p95 / mean };
};
await run('the sun through its shadow map is build/render\'s', async () => {
    const found = [], file = `${out}/light.exr`;
    for (const [shadow, scene] of [['MAP', 'casters'], ['FILL', 'casters'], ['MAP', 'room']]) {
        await go(`scene=${scene}&a=ssdo&b=off&sky=sky&size=480x270&history=0&radius=0&shadow=${shadow}`);
        const sun = await lightFile(file), words = [scene, '--size', '480x270', '--light', sun];
        const is = scored(words, file, `shadows=${shadow.toLowerCase()},shadow_size=2048`);
        const open = scored(words, file, 'shadows=none');
        found.push(`${shadow} of ${scene}: 95 % of pixels within ${is.p95.toFixed(4)} of the mean, RMSE ${
            is.rmse.toFixed(3)} with the silhouettes, ${open.rmse.toFixed(3)} from no shadow`);
        check(is.p95 <= 0.005 && is.rmse < 0.3 * open.rmse, found.join('; '));
    }
    found.forEach(note);
});
await run('the sun by points on the screen is build/render\'s of one G-buffer', async () => {
    await go('scene=room&a=ssdo&b=off&sky=sky&size=480x270&history=0&radius=0&shadow=SEGMENT');
    const sun = await lightFile(`${out}/light.exr`), bytes = await page.evaluate(() => {
        const file = page.frame();
        let text = '';
        for (let i = 0; i < file.length; i += 32768) text += String.fromCharCode(...file.subarray(i, i + 32768));
        return btoa(text);
    });
    writeFileSync(`${out}/frame.exr`, Buffer.from(bytes, 'base64'));
    const words = ['--gbuffer', `${out}/frame.exr`, '--light', sun];
    const is = scored(words, `${out}/light.exr`, 'shadows=segment'), open = scored(words, `${out}/light.exr`,
                                                                                   'shadows=none');
    note(`RMSE ${is.rmse.toFixed(4)} of the mean, ${open.rmse.toFixed(4)} from no shadow`);
    check(is.rmse <= 0.005 && open.rmse > 0.02, `${is.rmse} ${open.rmse}`);
});
await run('the truth has the sun where the chain has it: the same error of ssdo', async () => {
    await go('scene=casters&a=ssdo&b=truth&size=240x136&history=0&radius=0&shadow=MAP');
    const { toSun, irradiance } = await page.evaluate('page.inside().stage.sunlight');
    const words = ['casters', '--method', 'ssdo', '--env', 'sky', '--light', `sun:${[...toSun, ...irradiance].join()}`,
                   '--set', 'bounce=none,shadows=map,shadow_size=2048', '--size', '240x136'];
    render(...words, '--truth', '64', '--out', `${out}/truth.exr`);
    const wanted = +/irradiance: RMSE ([\d.]+)/.exec(render(...words, '--score', `${out}/truth.exr`))[1];
    await page.waitForFunction('page.rays() >= 16', { timeout: 60000 });
    const is = await page.evaluate('page.error(0)');
    note(`RMSE ${is.toFixed(4)}, ${wanted.toFixed(4)} by build/render`);
    check(Math.abs(is - wanted) < 0.02, `${is} against ${wanted}`);
});

await run('every method, side, view and choice is drawn', async () => {
    const drawn = [];
    for (const hash of ['a=none', 'a=ssdo&b=points&view=ambient', 'a=s3ho&b=march&p=FAST', 
                        'a=ssdo&bounce=1&history=1&b=s3ho&q=BEST',
                        'a=ssao&b=hsao&thickness=SOLID&history=1', 'a=ssdo&shadow=FILL&bounce=1&b=s3ho&history=1',
                        'a=ssdo&thickness=BACK&normals=FROM_DEPTH&sky=windows&sun=0',
                        'scene=cornell&view=difference&b=ssao&sky=white',
                        'scene=bunny&a=hsao&radius=1&thickness_limit=1.5']) {
        await go(`size=320x180&${hash}`);
        const notice = await page.$eval('#notice', p => (p.hidden ? '' : p.textContent));
        check(!notice, `${hash}: ${notice}`);
        drawn.push(hash);
    }
    note(`${drawn.length} addresses`);
});

await run('the address carries the settings', async () => {
    await go('scene=cornell&a=ssdo&p=BEST&b=truth&radius=0.5&thickness=SOLID&size=320x180&cam=0,2.745,9,0,2.7,0');
    await rest(400);
    const { hash, selected } = await page.evaluate(() => {
        const { elements } = document.getElementById('panel');
        return { hash: location.hash,
                 selected: ['scene', 'a', 'p', 'b', 'thickness'].map(name => elements[name].value).join() };
    });
    check(selected === 'cornell,ssdo,BEST,truth,SOLID', selected);
    for (const part of ['scene=cornell', 'a=ssdo', 'p=BEST', 'b=truth', 'radius=0.5', 'thickness=SOLID',
                        'cam=0,2.745,9,0,2.7,0'])
        check(hash.includes(part), `${hash} lacks ${part}`);
});

await run('history settles, and lowers the error', async () => {
    await go('size=320x180&a=hsao&p=FAST&b=truth&history=0');
    await page.waitForFunction('page.rays() >= 8', { timeout: 60000 });
    const alone = await page.evaluate('page.error(0)');
    await go('size=320x180&a=hsao&p=FAST&b=truth&history=1');
    await page.waitForFunction('page.settled() && page.rays() >= 8', { timeout: 60000 });
    const averaged = await page.evaluate('page.error(0)');
    note(`RMSE ${alone.toFixed(4)} alone, ${averaged.toFixed(4)} over 32 frames`);
    check(averaged < alone, 'it does not');
});

await run('a model of one\'s own is drawn', async () => {
    writeFileSync(`${out}/wedge.obj`, wedge(1));
    await go('size=320x180&b=off&history=0');
    await (await page.$('#file')).uploadFile(`${out}/wedge.obj`);
    await page.waitForFunction(`document.querySelector('[name=scene]').value === 'file'`, { timeout: 20000 });
    await rest(500);
    const least = await page.evaluate(() => page.result(0).pixels.reduce((a, b) => Math.min(a, b), 1));
    check(least < 0.9, `nothing is occluded: ${least}`);
});

await run('the sun throws the shadow of a model onto its ground, as far as it reaches', async () => {
    const corner = i => `v ${(i & 1) * 0.2 - 0.1} ${(i >> 1 & 1) * 2} ${(i >> 2) * 0.2 - 0.1}`;
    const pillar = [...Array(8).keys()].map(corner);
    const faces = ['1 5 7 3', '2 4 8 6', '1 2 6 5', '3 7 8 4', '1 3 4 2', '5 6 8 7'].map(face => `f ${face}`);
    writeFileSync(`${out}/pillar.obj`, [...pillar, ...faces, ''].join('\n'));
    await go('size=320x180&b=off&history=0&a=none&azimuth=90&height=30');
    await (await page.$('#file')).uploadFile(`${out}/pillar.obj`);
    await page.waitForFunction(`page.inside().stage.info.title === 'pillar.obj' && page.smooth()`, { timeout: 20000 });
    const [shadow, beside] = await page.evaluate(() => {
        const { stage, size: { width, height } } = page.inside(), all = page.picture();
        return [0, 0.8].map(z => {
            const at = stage.camera.position.clone().set(-1.3, 0, z).project(stage.camera);
            return all[4 * (Math.floor((at.y * 0.5 + 0.5) * height) * width + Math.floor((at.x * 0.5 + 0.5) * width))];
        });
    });
    note(`${shadow} in it, ${beside} beside it`);
    check(beside > 1.1 * shadow, `${shadow} in it, ${beside} beside it`);
});

/* A ring with points on it that is no solid of revolution, on a floor as the page has it. */
const ring = (out = []) => {
    const around = 20, along = 10, at = (i, k) => 1 + (i % around) * along + k % along;
    for (let i = 0; i < around; ++i)
        for (let k = 0; k < along; ++k) {
            const a = 2 * Math.PI * i / around, b = 2 * Math.PI * k / along, r = 0.4 + 0.1 * Math.cos(3 * a);
            const far = 1.2 + r * Math.cos(b);
            out.push(`v ${far * Math.cos(a)} ${0.8 * far * Math.sin(a) + 1.5} ${r * Math.sin(b) + 0.3 * Math.cos(a)}`);
        }
    out.push('o ring');
    for (let i = 0; i < around; ++i)
        for (let k = 0; k < along; ++k)
            out.push(`f ${at(i, k)} ${at(i + 1, k)} ${at(i + 1, k + 1)} ${at(i, k + 1)}`);
    return out.join('\n');
};
await run('the field of a model of one\'s own is build/render\'s, on its ground', async () => {
    writeFileSync(`${out}/ring.obj`, ring());
    await go('size=320x180&b=off&history=0&a=aof&p=FAST&radius=0');
    await (await page.$('#file')).uploadFile(`${out}/ring.obj`);
    const [loading, bar] = ['#loading-text', '#loading-bar'].map(name => `document.querySelector('${name}')`);
    await page.waitForFunction(`${loading}.textContent === 'Baking the field of ring.obj, 8×8' && ${bar}.value > 0`,
                               { timeout: 60000, polling: 20 });
    await page.waitForFunction(`page.inside().stage.info.title === 'ring.obj' && !page.making()`, { timeout: 60000 });
    check(await page.evaluate(`document.getElementById('loading').hidden`), 'the bar stays');
    await go('scene=file&size=320x180&b=off&history=0&a=aof&p=FAST&radius=0');
    const floor = await page.evaluate(() => {
        const { stage } = page.inside(), { position } = stage.triangles(0), { info, camera } = stage;
        return { position: [...position], eye: info.eye, target: info.target, fov: camera.fov, near: info.near,
                 far: info.far };
    });
    const corners = floor.position.length / 3, at = Array.from({ length: corners }, (_, i) => i);
    writeFileSync(`${out}/ground.obj`, [ring(), 'o ground',
        ...at.map(i => `v ${floor.position.slice(3 * i, 3 * i + 3).join(' ')}`),
        ...at.filter(i => i % 3 === 0).map(i => `f ${[201, 202, 203].map(k => k + i).join(' ')}`), ''].join('\n'));
    render(`${out}/ground.obj`, '--method', 'aof', '--set', 'resolution=8,rays=64', '--size', '320x180',
           '--camera', [...floor.eye, ...floor.target].join(), '--fovy', `${floor.fov}`, '--near', `${floor.near}`,
           '--far', `${floor.far}`, '--out', `${out}/ao.png`);
    const { rmse, least } = await against(`${out}/ao.png`);
    note(`RMSE ${rmse.toFixed(4)}, darkest ${least.toFixed(2)}`);
    check(least < 0.7 && rmse <= 0.005, `RMSE ${rmse}, darkest ${least}`);
});

await run('a field moves with its object, and is baked once', async () => {
    await go('scene=casters&size=320x180&b=off&history=0&a=aof&p=FAST');
    const { shown, moved, bakes } = await page.evaluate(async () => {
        const { postMessage } = Worker.prototype, shown = page.makers().of(0, 'aof').shown;
        let bakes = 0;
        Worker.prototype.postMessage = function (data, ...more) {
            bakes += !!data.field;
            return postMessage.call(this, data, ...more);
        };
        const darkest = () => {
            const { width, pixels } = page.result(0), sum = [0, 0, 0];
            pixels.forEach((v, i) => {
                sum[0] += (1 - v) * (i % width);
                sum[1] += (1 - v) * Math.floor(i / width);
                sum[2] += 1 - v;
            });
            return [sum[0] / sum[2], sum[1] / sum[2]];
        };
        const object = () => {
            const { stage: { mover, camera }, size: { width, height } } = page.inside();
            const at = mover.mesh.position.clone().project(camera);
            return [(at.x * 0.5 + 0.5) * width, (at.y * 0.5 + 0.5) * height];
        };
        const all = [];
        const box = document.querySelector('[name=moves]');
        for (let k = 0; k < 4; ++k) {
            all.push([darkest(), object()]);
            box.checked = true;
            box.dispatchEvent(new Event('input', { bubbles: true }));
            const from = page.inside().stage.mover.mesh.position.clone();
            while (page.inside().stage.mover.mesh.position.distanceTo(from) < 2.5 * page.inside().stage.info.radius)
                await new Promise(requestAnimationFrame);
            box.checked = false;
            box.dispatchEvent(new Event('input', { bubbles: true }));
            for (let i = 0; i < 3; ++i) await new Promise(requestAnimationFrame);
        }
        Worker.prototype.postMessage = postMessage;
        return { shown, bakes, moved: all };
    });
    const left = await page.evaluate(async () => {
        const put = async (name, value) => {
            const control = document.querySelector(`[name=${name}]`);
            control.value = value;
            control.dispatchEvent(new Event('input', { bubbles: true }));
            for (let i = 0; i < 4; ++i) await new Promise(requestAnimationFrame);
            return page.making();
        };
        return [await put('field', 32), await put('a', 'hsao'), document.getElementById('loading').hidden].join();
    });
    check(left === 'true,false,true', `a bake that nobody waits for: ${left}`);
    const off = moved.map(([is, at]) => Math.hypot(is[0] - at[0], is[1] - at[1]));
    const ways = moved.slice(1).map(([, at], i) => Math.hypot(at[0] - moved[i][1][0], at[1] - moved[i][1][1]));
    note(`what is dark is ${off.map(v => v.toFixed(0)).join(', ')} px from the object, which moved by ${
        ways.map(v => v.toFixed(0)).join(', ')} px; 95 % of its errors are below ${shown[0].p95.toFixed(3)}`);
    check(Math.max(...off) < 0.5 * Math.min(...ways) && Math.min(...ways) > 20, `${off}; ${ways}`);
    check(bakes === 0, `${bakes} bakes`);
});

await run('what cannot be made of a model is said, and the side goes on without it', async () => {
    const begun = said.length, page = await open('size=160x90&b=off&scene=cornell', { before: `
        const { postMessage } = Worker.prototype;
        Worker.prototype.postMessage = function (data, ...more) {
            return postMessage.call(this, data.surfels ? { surfels: { ...data.surfels, size: 9 } } : data, ...more);
        };` });
    await page.evaluate(() => { const left = document.querySelector('[name=a]'); left.value = 'dss';
                                left.dispatchEvent(new Event('input', { bubbles: true })); });
    await page.waitForSelector('#notice:not([hidden])', { timeout: 20000 });
    const { notice, a } = await page.evaluate(() => ({ notice: document.getElementById('notice').textContent,
                                                       a: page.set.a }));
    await page.close();
    check(/^surfels: .*size/.test(notice) && a === 'none', `${notice}: ${a}`);
    check(said.length === begun, said.slice(begun).join('\n'));
});

/* What is seen: on the canvas, of calm pages at rest, and beside it. */
const seen = (page, calm = true) => page.evaluate(async calm => {
    for (let i = 0; i < 400 && calm && !page.smooth() && page.resting(); ++i) await new Promise(requestAnimationFrame);
    const { elements } = document.getElementById('panel'), notice = document.getElementById('notice');
    const picture = page.picture();
    let opaque = true, sum = 0;
    for (let i = 0; i < picture.length; i += 4) {
        opaque &&= picture[i + 3] === 255;
        sum = (Math.imul(sum, 31) + picture[i] + 256 * picture[i + 1] + 65536 * picture[i + 2]) | 0;
    }
    return { there: opaque && picture.length > 0, sum, scene: elements.scene.value,
             title: elements.scene.selectedOptions[0].text, notice: notice.hidden ? '' : notice.textContent };
}, calm);
const same = (a, b) => Object.keys(a).every(key => a[key] === b[key]);
/* Drops a file onto the page; resolves when it is shown, or what is wrong with it. unread: why it cannot be read. */
const drop = (page, name, content, unread = null) => dropAll(page, { [name]: content }, unread);
const dropAll = (page, contents, unread = null) => page.evaluate(async (files, unread) => {
    const dataTransfer = new DataTransfer(), loading = document.getElementById('loading');
    const { stream } = File.prototype, bytes = text => Uint8Array.from(atob(text), c => c.charCodeAt(0));
    const broken = () => new ReadableStream({ pull(c) { c.error(new DOMException(unread, 'NotReadableError')); } });
    if (unread) File.prototype.stream = broken;
    for (const [name, text] of files) dataTransfer.items.add(new File([bytes(text)], name));
    dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
    const begun = !loading.hidden;
    while (!loading.hidden) await new Promise(requestAnimationFrame);
    if (unread) File.prototype.stream = stream;
    for (let i = 0; i < 3; ++i) await new Promise(requestAnimationFrame);
    return begun;
}, Object.entries(contents).map(([name, content]) => [name, Buffer.from(content).toString('base64')]), unread);

await run('a model that cannot be shown is named with what is wrong; scene and title stay', async () => {
    for (const begin of [() => go('size=160x90&b=off&scene=cornell&history=0'),
                         () => drop(page, 'wedge.obj', wedge(1))]) {
        await begin();
        const before = await seen(page);
        check(before.there && !before.notice, `before: ${JSON.stringify(before)}`);
        for (const [name, text, wanted, unread] of [...models,
            ['gone.obj', wedge(1), 'gone.obj: cannot be read: it is gone; must be a file', 'it is gone']]) {
            await drop(page, name, text, unread);
            const { notice, ...after } = await seen(page);
            check(says(notice, wanted), `${name}: ${notice}`);
            check(!/\n/.test(notice), `${name}: more than a line: ${notice}`);
            check(same(after, before), `${name}: ${JSON.stringify([before, after])}`);
        }
    }
    await go('scene=cornell&size=160x90&b=off&history=0');
    await go('scene=file&size=160x90&b=off&history=0');
    const { title, notice } = await seen(page);
    check(title === 'wedge.obj' && !notice, `the model is not found again: ${title}: ${notice}`);
});
await run('a model is drawn alike in any unit and place, and without the lines beside it', async () => {
    const means = [], begun = said.length, place = [13487434.764, -6.397, -3741689.403];
    const far = east => `: it lies far from 0 beside its size, and is shown about ${east},-6,-3741689`;
    const emits = 'its materials emit light, which is not shown';
    for (const [name, text, notes = ''] of [
        ['some.obj', wedge(1)], ['some.obj', wedge(1e-5)], ['some.obj', wedge(1e7)],
        ['some.obj', `${wedge(1)}l 1 4\np 2\n`], ['far.obj', wedge(1, place), `far.obj${far(13487436)}`],
        ['tiny.obj', wedge(1e-5, [1, 1, 1]),
         'tiny.obj: it lies far from 0 beside its size, and is shown about 1,1,1'],
        ['far.gltf', glowingWedge(place), `far.gltf: ${emits}\nfar.gltf${far(13487435)}`],
        ['near.gltf', glowingWedge([0, 0, 0]), `near.gltf: ${emits}`],
        ['own.gltf', glowingWedge([0, 0, 0], 13487434),
         [emits, 'its coordinates are floats, which so far from 0 are 1 apart, 0.58 of its size',
          'it lies far from 0 beside its size, and is shown about 13487435,1,1'].map(s => `own.gltf: ${s}`).join('\n')]
    ]) {
        await drop(page, name, text);
        const { notice } = await seen(page);
        check(notice === notes, `${name}: ${notice}`);
        means.push(await page.evaluate(() => {
            const { pixels } = page.result(0);
            return pixels.reduce((sum, v) => sum + v, 0) / pixels.length;
        }));
        if (name !== 'far.obj') continue;
        const off = await page.evaluate(([east, , south]) => {    /* where a saved frame puts a corner, and the page */
            const { camera } = page.inside().stage, { origin } = page.inside().stage.info, file = page.frame();
            const at = new TextDecoder('latin1').decode(file).indexOf('ssgi.worldToCamera\0m44d\0') + 28;
            const view = new DataView(file.buffer.slice(at)), m = i => view.getFloat64(8 * i, true);
            const x = origin[0] - east, z = origin[2] - south, inverse = camera.matrixWorldInverse.elements;
            return [0, 1].map(i => m(i) * east + m(8 + i) * south + m(12 + i)
                - (inverse[12 + i] - inverse[i] * x - inverse[4 + i] * origin[1] - inverse[8 + i] * z));
        }, place);
        check(off.every(v => Math.abs(v) < 1e-6), `the saved frame is off by ${off}`);
    }
    await drop(page, 'bounds.gltf', indexed(0, 1, 2));
    const { title, notice } = await seen(page);
    check(title === 'bounds.gltf' && !notice, `${title}: ${notice}`);
    check(said.length === begun, said.slice(begun).join('\n'));
    note(`mean visibility ${means.map(v => v.toFixed(4)).join(', ')}`);
    const smooth = means.splice(-3);                      /* a glTF's corners share their normals */
    for (const all of [means, smooth])
        check(all[0] < 0.999 && all.every(v => Math.abs(v - all[0]) < 0.001), all.join());
});
await run('files that belong together are read together: OBJ, MTL and picture; glTF and BIN; packed GLB', async () => {
    const begun = said.length, red = 'newmtl red\nKd 1 0 0\n', dot = await page.evaluate(async () => {
        const canvas = new OffscreenCanvas(4, 4), context = canvas.getContext('2d');
        context.fillStyle = '#00f';
        context.fillRect(0, 0, 4, 4);
        const bytes = new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer());
        return btoa(String.fromCharCode(...bytes));
    });
    const faces = wedge(1).replace(/f /, 'vt 0 0\nusemtl red\nf '), picture = Buffer.from(dot, 'base64');
    const bin = JSON.parse(indexed(0, 1, 2)), bytes = Buffer.from(bin.buffers[0].uri.split(',')[1], 'base64');
    bin.buffers[0].uri = 'some%20parts.bin';
    const colour = () => page.evaluate(() => {            /* of the middle: the model, not the floor */
        const all = page.picture(), [width, height] = [160, 90], sum = [0, 0, 0];
        for (let y = height * 0.45 | 0; y < height * 0.55; ++y)
            for (let x = width * 0.46 | 0; x < width * 0.52; ++x)
                for (let c = 0; c < 3; ++c) sum[c] += all[4 * (y * width + x) + c];
        return sum;
    });
    for (const [files, is] of [
        [{ 'a.obj': `mtllib a.mtl\n${faces}`, 'a.mtl': red }, ([r, g, b]) => r > 1.5 * g && r > 1.5 * b],
        [{ 'b.mtl': 'newmtl red\nmap_Kd some blue.png\n'.replace('some ', ''), 'blue.png': picture,
           'b.obj': `mtllib b.mtl\n${faces.replace(/f (\d) (\d) (\d)/g, 'f $1/1 $2/1 $3/1')}` },
         ([r, g, b]) => b > 1.5 * r && b > 1.5 * g],
        [{ 'c.gltf': JSON.stringify(bin), 'some parts.bin': bytes }, null],
        [{ 'd.glb': draco }, null], [{ 'e.glb': meshopt }, null]]) {
        const name = Object.keys(files).find(name => /obj$|gl/.test(name));
        await go('size=160x90&b=off&scene=cornell&history=0&a=none');
        check(await dropAll(page, files), `${name}: nothing says that it is read`);
        const { title, notice } = await seen(page), found = await colour();
        check(title === name && !notice, `${title}: ${notice}`);
        check(!is || is(found), `${name}: ${found}`);
    }
    await drop(page, 'grey.obj', `mtllib gone.mtl\n${faces}`);
    const { title, notice } = await seen(page);
    check(title === 'grey.obj'
          && notice === 'grey.obj: gone.mtl is not beside it: drop both together for its materials', notice);
    check(said.length === begun, said.slice(begun).join('\n'));
});
await run('a sky of one\'s own lights the scene, and its truth', async () => {
    const begun = said.length, blue = Buffer.from(hdr(64, 32, 128)), head = blue.length - 4 * 64 * 32;
    for (let i = head; i < blue.length; i += 4) blue[i] = blue[i + 1] = 20;
    await go('size=160x90&b=off&scene=cornell&history=0&a=ssdo&view=ambient&sky=white');
    await dropAll(page, { 'blue.hdr': blue });
    const mean = () => page.evaluate(() => {
        const { pixels } = page.result(0), sum = [0, 0, 0];
        pixels.forEach((v, i) => { if (i % 4 < 3) sum[i % 4] += v; });
        return sum;
    });
    const [r, g, b] = await mean();
    check(!(await seen(page)).notice && b > 4 * r && b > 4 * g, `${[r, g, b]}`);
    await go('size=160x90&b=truth&scene=cornell&history=0&a=ssdo&sky=file');
    await page.waitForFunction('page.rays() >= 16', { timeout: 60000 });
    const error = await page.evaluate('page.error(0)');
    note(`RMSE of ssdo ${error.toFixed(4)}`);
    check(error > 0.005 && error < 0.2, `${error}`);
    check(said.length === begun, said.slice(begun).join('\n'));
    const { loader } = await page.evaluate(async () => {
        const { exr } = await import('./exr.mjs'), one = new Float32Array(64 * 32).fill(1);
        const file = exr(64, 32, { R: one, G: one.map(() => 0.1), B: one.map(() => 0.1) });
        let text = '';
        for (let i = 0; i < file.length; i += 32768) text += String.fromCharCode(...file.subarray(i, i + 32768));
        return { loader: btoa(text) };
    });
    await go('size=160x90&b=off&scene=cornell&history=0&a=ssdo&view=ambient&sky=white');
    await dropAll(page, { 'red.exr': Buffer.from(loader, 'base64') });
    const found = await mean();
    check(!(await seen(page)).notice && found[0] > 4 * found[1], `${found}: ${(await seen(page)).notice}`);
});

await run('a scene that does not come leaves the one that is shown', async () => {
    await go('size=160x90&b=off&scene=cornell&history=0');
    const before = await seen(page);
    await page.setRequestInterception(true);
    const cut = request => (request.url().endsWith('slats.bin')
        ? request.respond({ status: 200, body: Buffer.alloc(100) }) : request.continue());
    page.on('request', cut);
    await page.evaluate(hash => page.go(hash), 'size=160x90&b=off&scene=slats&history=0');
    page.off('request', cut);
    await page.setRequestInterception(false);
    const { notice, ...after } = await seen(page);
    check(notice === 'scenes/slats.bin: is cut short or no scene; must be as make web writes it', notice);
    check(same(after, before), JSON.stringify([before, after]));
});

/* The page's own sentences are of what node reads of the same address and settings. */
const expected = (hash, { limits, before }) => {
    const { wrong } = read(hash, limits, before), shown = wrong.slice(0, 3), more = wrong.length - shown.length;
    return [...shown, ...(more ? [`and ${more} more`] : [])].join('\n');
};
await run('no address stops a page that is open', async () => {
    const begun = said.length, all = hashes(100, 2).map(hash => `size=64x36&${hash}`);
    for (const hash of all) {
        const got = await page.evaluate(async hash => {
            const before = { ...page.set }, going = page.go(hash), { hash: taken } = location;
            const error = await going.then(() => null, e => e.message);
            return { before, taken, error, limits: page.limits() };
        }, hash);
        const { there, notice } = await seen(page, false), wanted = expected(got.taken.slice(1), got);
        check(got.error === null && there, `${hash}: ${got.error ?? 'no picture'}`);
        check(notice === wanted, `${hash} says ${notice}\nand should say ${wanted}`);
        check(said.length === begun, `${hash}: ${said.slice(begun).join()}`);
    }
    note(`${all.length} addresses`);
});
await page.close();

await run('no address stops a page that is loaded with it', async () => {
    const begun = said.length;
    const all = ['p=constructor', 'sky=toString', 'size=9999x9999', 'a=__proto__&b=valueOf', '__proto__=1&toString=2',
                 'cam=NaN,0,0,0,0,0', 'cam=1e300,0,0,0,0,0', 'scene=file', 'scene=%E0%A4%A', '😀=%F0%9F%98%80', '%',
                 ...hashes(9, 3)];
    for (const hash of all) {
        const page = await open(`size=64x36&${hash}`), { there, notice } = await seen(page, false);
        const limits = await page.evaluate('page.limits()');
        await page.close();
        check(there, `${hash}: no picture`);
        check(said.length === begun, `${hash}: ${said.slice(begun).join()}`);
        const wanted = expected(`size=64x36&${hash}`, { limits });
        check(!!notice === !!wanted, `${hash} says ${notice || 'nothing'}`);
    }
    note(`${all.length} loads`);
});

/* ---- each control does what it says, at both sizes */

for (const [width, height] of [[1280, 800], [390, 844]])
    await run(`every control is operated at ${width} x ${height}`, async () => {
        const begun = said.length, page = await open('size=160x90&history=0&scene=casters&b=off', { width, height });
        const state = () => page.evaluate(async () => {
            for (let i = 0; i < 2; ++i) await new Promise(requestAnimationFrame);
            const { chain, steps } = page.chain(0), was = globalThis.shown ?? [], is = page.picture();
            globalThis.shown = is;
            let sum = 0;
            for (let i = 0; i < is.length; ++i) sum += Math.abs(is[i] - (was[i] ?? 0));
            return { other: sum / is.length, chain, steps, set: { ...page.set } };
        });
        const named = await page.evaluate(() => [...document.getElementById('panel').elements].map(e => e.name)
            .filter(name => Object.hasOwn(page.set, name)));
        const missing = Object.keys(await page.evaluate('page.set'))
            .filter(name => !named.includes(name) && !['split', 'cam'].includes(name));
        check(!missing.length, `no control for ${missing}`);
        for (const [name, value, seen] of [
            ['exposure', 1.5, 'picture'], ['effect', 3, 'picture'], ['azimuth', -90, 'picture'],
            ['height', 80, 'picture'], ['strength', 3, 'picture'], ['sun', false, 'picture'],
            ['sky', 'windows', 'picture'], ['view', 'ambient', 'picture'], ['radius', 0, 'picture'],
            ['slices', 4, ({ chain }) => chain.desc.directions === 4],
            ['steps', 3, ({ chain }) => chain.desc.steps === 3],
            ['half', 'NONE', ({ chain }) => chain.desc.half === 'NONE'],
            ['filter', 3, ({ chain }) => chain.desc.filter_radius === 3],
            ['filter', 0, ({ chain, steps }) => !chain.blur && !steps.includes('BLUR')],
            ['half', 'FIRST', ({ chain, steps }) => chain.desc.half === 'FIRST' && steps.includes('BLUR')],
            ['thickness', 'SLABS', ({ chain }) => chain.desc.thickness === 'SLABS'],
            ['thickness_limit', 1.7, ({ set }) => set.thickness_limit === 1.7],
            ['normals', 'FROM_DEPTH', ({ chain }) => chain.desc.normal === 'FROM_DEPTH'],
            ['p', 'BEST', ({ chain }) => chain.desc.steps === 3],
            ['history', true, ({ steps }) => steps.includes('HISTORY')],
            ['a', 'dss', ({ chain, steps }) => chain.desc.pass === 'SPLAT' && steps.includes('INTERLEAVE')],
            ['levels', 3, ({ chain }) => chain.desc.levels === 3],
            ['surfel', 6, 'picture'],
            ['field', 8, ({ set }) => set.field === 8],
            ['a', 'aof', ({ chain }) => chain.desc.pass === 'FIELD'], ['reach', 0.2, 'picture'],
            ['a', 'ssdo', ({ chain }) => chain.desc.pass === 'SSDO'],
            ['bounce', true, ({ chain }) => chain.desc.bounce === 'SOLID_ANGLE'], ['sun', true, 'picture'],
            ['shadow', 'MAP', ({ steps }) => steps.includes('LIGHTS')],
            ['b', 'ssao', ({ set }) => set.b === 'ssao'], ['q', 'FAST', ({ set }) => set.q === 'FAST'],
            ['scene', 'cornell', ({ set }) => set.scene === 'cornell'],
            ['size', '480x270', ({ chain }) => chain.width === 480],
            ['truth', true, ({ set }) => set.truth]]) {
            await state();
            await put(page, name, value);
            const after = await state();
            check(seen === 'picture' ? after.other > 0.2 : seen(after),
                  `${name}=${value} does nothing: ${JSON.stringify(after.chain)}`);
        }
        await page.evaluate(() => document.getElementById('own').click());
        const { set } = await state();
        check(!set.slices && !set.steps && set.filter === -1 && set.half === 'preset' && !set.levels && !set.surfel
              && !set.field, 'the preset stays away');
        const wide = await page.evaluate(() => [document.documentElement.scrollWidth,
            ...[...document.querySelectorAll('#panel :is(select, input, button, p)')].filter(e => e.offsetParent)
                .filter(e => e.getBoundingClientRect().right > innerWidth + 1)
                .map(e => e.name || e.id || e.textContent)]);
        check(wide[0] <= width && wide.length === 1, `out of the page: ${wide}`);
        const small = await page.evaluate(() => [...document.querySelectorAll('#bar button')]
            .filter(e => e.offsetParent).map(e => e.getBoundingClientRect())
            .filter(r => r.width < 32 || r.height < 32 || r.right > innerWidth || r.bottom > innerHeight).length);
        check(small === 0, `${small} buttons over the picture are small or outside`);
        check(said.length === begun, said.slice(begun).join('\n'));
        await page.close();
    });

await run('buttons over the picture and keys', async () => {
    const begun = said.length, page = await open('size=160x90&history=0&scene=cornell');
    const text = await page.evaluate(async () => {
        const saved = [], { click } = HTMLAnchorElement.prototype;
        HTMLAnchorElement.prototype.click = function () { saved.push([this.download, this.href]); };
        document.getElementById('png').click();
        while (!saved.length) await new Promise(requestAnimationFrame);
        HTMLAnchorElement.prototype.click = click;
        const image = await createImageBitmap(await (await fetch(saved[0][1])).blob());
        return `${saved[0][0]} ${image.width}x${image.height}`;
    });
    check(text === 'ssgi.png 160x90', text);
    const is = what => page.evaluate(what);
    await page.keyboard.press('2');
    check(await is('page.set.view') === 'ambient', '2');
    await page.keyboard.press('p');
    check(await is('!document.getElementById("panel").offsetParent'), 'p');
    await page.keyboard.press('p');
    await page.keyboard.type('?');
    check(await is('document.getElementById("keys").open'), '?');
    check(await is('document.querySelectorAll("#keys kbd").length') === 11, 'keys that are not listed');
    check(await is('["HSAO", "SSDO", "S3HO", "Deep screen space", "Fields of objects", "SSAO"].every(name => '
                   + 'document.getElementById("keys").innerText.includes(name))'), 'methods that are not told');
    await page.keyboard.press('Escape');
    await page.keyboard.press('m');
    check(await is('page.set.moves'), 'm');
    await page.keyboard.press('c');
    check(await is('page.set.circle'), 'c');
    await rest(500);
    await page.mouse.move(300, 300);
    await page.mouse.down();
    await page.mouse.up();
    check(await is('!page.set.circle'), 'a touch does not stop it');
    await page.click('#whole');
    await rest(500);
    check(await is('document.fullscreenElement?.id') === 'picture', 'full screen');
    await page.keyboard.press('f');
    await rest(300);
    check(await is('document.fullscreenElement') === null, 'f');
    await page.evaluate(() => document.querySelector('#thumbs button[value=room]').click());
    await page.waitForFunction(`page.set.scene === 'room' && document.getElementById('loading').hidden`);
    check(said.length === begun, said.slice(begun).join('\n'));
    await page.close();
});

await run('the camera circles until it is touched, where it is fast and motion is welcome', async () => {
    const fast = `{ const { prototype } = WebGL2RenderingContext, all = prototype.getParameter;
        prototype.getParameter = function (name) { return name === 0x9246 ? 'Some GPU' : all.call(this, name); }; }`;
    const turns = async (hash, before, motion = 'no-preference') => {
        const page = await open(hash, { width: 320, height: 300, before, motion });
        const is = await page.evaluate('page.set.circle');
        await page.close();
        return is;
    };
    check(await turns('size=64x36', fast), 'it does not');
    check(!await turns('size=64x36', fast, 'reduce'), 'though motion is unwelcome');
    check(!await turns('size=64x36', null), 'though it is drawn in software');
    check(!await turns('size=64x36&cam=1,2,3,0,0,0', fast), 'though the address has a view');
});

await run('what moves is followed: vectors say where its points were', async () => {
    const page = await open('size=320x180&scene=casters&moves=1&b=off');
    await page.waitForFunction(`document.getElementById('rate').textContent.includes('frames/s')`, { timeout: 30000 });
    const motion = await page.evaluate('page.chain(0).chain.desc.motion');
    check(motion === 1, 'history does not ask for vectors');
    const by = await page.evaluate(async () => {
        for (let i = 0; i < 3; ++i) await new Promise(requestAnimationFrame);
        const { stage, show, buffers, size: { width, height }, gl } = page.inside(), { camera, mover } = stage;
        const vectors = new Float32Array(4 * width * height), framebuffer = gl.createFramebuffer();
        const texture = show.motion(width, height, buffers, stage.reprojection());
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, vectors);
        const p = camera.projectionMatrix.elements;
        const { Z } = show.frame(width, height, buffers, [(p[10] - 1) / p[14], 2 / p[14]]);
        const { position } = mover.mesh.geometry.attributes, moved = [], its = new Set();
        const at = (matrix, i) => {                       /* pixels and view depth of a vertex */
            const v = mover.mesh.position.clone().fromBufferAttribute(position, i).applyMatrix4(matrix)
                .applyMatrix4(camera.matrixWorldInverse);
            const depth = -v.z;
            v.applyMatrix4(camera.projectionMatrix);
            return [(v.x * 0.5 + 0.5) * width, (v.y * 0.5 + 0.5) * height, depth];
        };
        for (let i = 0; i < position.count; ++i) {
            const [x, y, depth] = at(mover.now, i), [wasX, wasY] = at(mover.before, i);
            const k = Math.floor(y) * width + Math.floor(x);
            if (!(x > 0 && x < width && y > 0 && y < height) || Math.abs(Z[k] / depth - 1) > 0.004) continue;
            its.add(k);
            moved.push([vectors[4 * k], x - wasX], [vectors[4 * k + 1], y - wasY]);
        }
        let still = Infinity;                             /* the farthest corner of the picture shows none of it */
        for (const k of [0, width - 1, width * (height - 1), width * height - 1])
            if (Z[k] > 0) still = Math.min(still, Math.hypot(vectors[4 * k], vectors[4 * k + 1]));
        return { moved, still };
    });
    const off = by.moved.map(([is, wanted]) => Math.abs(is - wanted)).sort((a, b) => a - b);
    const most = Math.max(...by.moved.map(([, wanted]) => Math.abs(wanted)));
    note(`${by.moved.length / 2} vertices of it, which moved by ${most.toFixed(1)} px at most: off by ${
        off[off.length >> 1].toFixed(3)} px, nine of ten by less than ${off[off.length * 0.9 | 0].toFixed(3)}`);
    check(by.moved.length > 200 && most > 0.05, `${by.moved.length} numbers, ${most} px`);
    check(by.still < 0.02 && off[off.length >> 1] < 0.03 && off[off.length * 0.9 | 0] < 0.2,
          `what rests moves by ${by.still} px`);
    await page.close();
});

/* ---- the C lines */

/* What is made of a triangle by these lines; what is wrong goes into what is printed. */
const surfelsMain = `static const float corners[9] = { -1, -1, -5, 1, -1, -5, 0, 1, -5 };
    ssgi_surfel_source source = { .position = corners, .triangles = 1, .to_view = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0,
                                                                                   0, 0, 0, 1 } };
    ssgi_view seen;
    size_t count = 0;
    const char *wrong = "";
    ssgi_view_from_projection(&seen, projection, SSGI_CLIP_GL, 160, 90, NULL);
    ssgi_surfel *made = make_surfels(&count, &seen, &source, &wrong);
    if (!made || count < 20) printf("%s", wrong);
    free(made);`;
const fieldMain = `static const float corners[36] = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1,
                                      0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0 };
    static uint32_t texels[4096];
    ssgi_field field;
    ssgi_gl_occluder row;
    const char *wrong = "";
    if (make_field(&field, texels, corners, 4, &wrong) != SSGI_OK
        || make_row(&row, &field, unit, 0, 1, &wrong) != SSGI_OK
        || !(row.reach < 0.51f * field.reach)) printf("%s", wrong);`;
const sunMain = `static const float to[3] = { 0, 0, 1 }, white[3] = { 1, 1, 1 };
    ssgi_gl_light row;
    ssgi_view map;
    const char *wrong = "";
    if (ssgi_view_from_projection(&map, projection, SSGI_CLIP_GL, 64, 64, &wrong) != SSGI_OK
        || make_sun(&row, to, white, &map, unit, unit, &wrong) != SSGI_OK || !(row.at[2] > 0.99f && row.tile[2] > 63))
        printf("%s", wrong);`;
await run('the C lines compile, and make the chain that is drawn', async () => {
    const page = await open('size=160x90&history=0'), made = [];
    for (const hash of ['a=hsao', 'a=hsao&history=1&slices=3&steps=7&half=NONE&filter=2&thickness=SLABS',
                        'a=ssao&p=BEST', 'a=ssdo&bounce=1&history=1', 'a=march&filter=0&half=NONE', 'a=s3ho&history=1',
                        'a=s3ho&p=FAST', 'a=points&thickness=BACK&normals=FROM_DEPTH', 'a=dss&levels=3',
                        'a=aof&p=FAST&reach=0.5', 'a=ssdo&shadow=FILL']) {
        await page.evaluate(h => page.go(h), `size=160x90&history=0&b=off&${hash}`);
        const { code, chain, list, given } = await page.evaluate(() => ({ code: page.code(0), ...page.chain(0) }));
        const history = !!chain.history, bands = /coefficients\[(\d+)\]/.exec(code)?.[1];
        const main = `${code}
#include <stdio.h>
int main(void)
{
    static ssgi_gl_step steps[STEPS];
    static const float unit[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
    static const float projection[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1.002f, -1, 0, 0, -0.2002f, 0 };
    ${bands ? `static const float coefficients[${bands}];` : ''}
    const char *why = "";
    ssgi_view view;
    ssgi_gl_frame frame;
    ${code.includes('make_sun') ? sunMain : ''}
    ${code.includes('make_surfels') ? surfelsMain : code.includes('make_field') ? fieldMain : ''}
    const int n = make_steps(steps, ${chain.width}, ${chain.height}, &why);
    for (int i = 0; i < n; ++i)
        printf("%s:%dx%d:%llu ", ssgi_gl_pass_name(steps[i].desc.pass), steps[i].width, steps[i].height,
               (unsigned long long)ssgi_gl_key(&steps[i].desc));
    if (ssgi_view_from_projection(&view, projection, SSGI_CLIP_GL, 160, 90, &why) != SSGI_OK
        || make_frame(&frame, &view, unit${history ? ', NULL, unit, 0' : ''}${bands ? ', coefficients' : ''}, &why)
           != SSGI_OK) printf("%s", why);
    printf("%g %g\\n", (double)frame.radius, (double)frame.thickness_limit);
    return 0;
}
#define SSGI_IMPLEMENTATION
#define SSGI_GL_IMPLEMENTATION
#include "ssgi.h"
#include "ssgi_gl.h"
`;
        writeFileSync(`${out}/lines.c`, main);
        execFileSync('gcc', ['-std=c99', '-Wall', '-Wextra', '-Wpedantic', '-Wconversion', '-Wshadow', '-Werror', '-I.',
                             `${out}/lines.c`, '-lm', '-o', `${out}/lines`], { stdio: ['ignore', 'ignore', 'pipe'] });
        const told = execFileSync(`${out}/lines`, { encoding: 'utf8' }).trim().split(' ');
        const [radius, limit] = told.splice(-2).map(Number), near = (a, b) => Math.abs(a - b) < 1e-4 * b;
        check(told.join(' ') === list.join(' '), `${hash}: ${told.join(' ')}\n${list.join(' ')}`);
        check(near(radius, given[0]) && near(limit, given[1]), `${hash}: ${radius}, ${limit}: ${given}`);
        made.push(told.length);
    }
    await page.close();
    note(`${made.length} chains of ${made.join(', ')} steps, each with the keys of the page's texts`);
});

/* ---- how it looks, and where there is little */

mkdirSync('report', { recursive: true });
const shots = [];
async function shoot(name, hash, options, settle = 1500) {
    const page = await open(hash, options);
    if (typeof settle === 'number') await rest(settle); else await page.waitForFunction(settle, { timeout: 180000 });
    await page.screenshot({ path: `report/web-${name}.png` });
    shots.push(`report/web-${name}.png`);
    return page;
}
await run('on a desktop (1280 x 800)', async () => {
    await (await shoot('desktop', '', {}, 'page.smooth()')).close();
    const page = await shoot('difference', 'b=ssao&view=difference', {}, 'page.truth()?.rays >= 16');
    await page.click('#read');
    await rest(300);
    const text = await page.$eval('#text pre', pre => pre.textContent);
    check(text.startsWith('#version 300 es') && text.includes('ssgi_frame'), text.slice(0, 80));
    await page.screenshot({ path: 'report/web-text.png' });
    shots.push('report/web-text.png');
    await page.close();
});
await run('on a phone (390 x 844, and 320 wide) nothing runs out of the page', async () => {
    const page = await shoot('phone', 'scene=bunny&a=ssdo', { width: 390, height: 844, scale: 2 });
    for (const width of [390, 320]) {
        await page.setViewport({ width, height: 844, deviceScaleFactor: 2, isMobile: true, hasTouch: true });
        await rest(200);
        const wide = await page.evaluate(() => document.documentElement.scrollWidth);
        check(wide <= width, `${wide} pixels on ${width}`);
    }
    await page.setViewport({ width: 390, height: 844, deviceScaleFactor: 2, isMobile: true, hasTouch: true });
    await page.touchscreen.touchStart(120, 200);
    for (const x of [140, 170, 200]) await page.touchscreen.touchMove(x, 210);
    await page.touchscreen.touchEnd();
    await rest(800);
    check((await page.evaluate('location.hash')).includes('cam='), 'a finger does not orbit');
    await page.evaluate(() => scrollTo(0, 520));
    await rest(1500);
    await page.screenshot({ path: 'report/web-phone-controls.png' });
    shots.push('report/web-phone-controls.png');
    await page.close();
});
await run('what a device lacks is said', async () => {
    const told = async before => {
        const page = await open('', { before });
        const text = await page.$eval('#notice', p => (p.hidden ? '' : p.textContent));
        await page.close();
        return text;
    };
    const none = await told('HTMLCanvasElement.prototype.getContext = () => null;');
    check(none.includes('no WebGL 2'), none || 'nothing is said without WebGL 2');
    const without = names => `const { prototype } = WebGL2RenderingContext, all = prototype.getExtension;
        prototype.getExtension = function (name) { return ${names}.test(name) ? null : all.call(this, name); };`;
    const poor = await told(without('/color_buffer/'));
    check(poor.includes('EXT_color_buffer_float'), poor || 'nothing is said without EXT_color_buffer_float');
    const clockless = await open('size=320x180&a=ssdo&bounce=1&b=ssao', { before: without('/timer/') });
    await clockless.waitForFunction('page.ms(0) && page.ms(1)', { timeout: 60000 });
    const said = await clockless.$eval('#timer-note', p => p.textContent), ms = await clockless.evaluate('page.ms(0)');
    await clockless.close();
    check(said.includes('CPU') && ms.every(one => one > 0), `${said}: ${ms}`);
});

await run('opened as a file it says in a line what to do, and nothing on the console', async () => {
    const begun = said.length, page = await browser.newPage();
    page.on('console', m => said.push(`file: ${m.text()}`));
    page.on('pageerror', e => said.push(`file: ${e.message}`));
    await page.goto(pathToFileURL(resolve('build/web/index.html')).href);
    await rest(500);
    const told = await page.evaluate(() => [document.getElementById('notice').textContent,
                                            document.getElementById('loading').hidden]);
    await page.close();
    check(told[0].includes('python3 -m http.server') && told[1], `${told}`);
    check(said.length === begun, said.slice(begun).join('\n'));
});

await run('a tracer that fails is said', async () => {
    const page = await open('size=64x36&b=truth', { before: `globalThis.Worker = class extends Worker {
        postMessage(data) { super.postMessage(data.scene ? { scene: { position: [1], normal: [1] } } : data); } };` });
    await page.waitForSelector('#notice:not([hidden])', { timeout: 20000 });
    const { notice } = await seen(page);
    await page.close();
    check(notice === 'the truth: position: must have 9 numbers a triangle, has 1', notice);
});

await run('the console is silent, the folder small', async () => {
    const bytes = readdirSync('build/web', { recursive: true })
        .filter(name => !/^scenes|^three.(loaders|libs)|^webgpu|^wgsl/.test(name))
        .reduce((sum, name) => {
            const file = statSync(join('build/web', name));
            return sum + (file.isFile() && file.size);
        }, 0);
    note(`build/web without its scenes, what reads files and WebGPU: ${(bytes / 1e6).toFixed(2)} MB`);
    check(bytes <= 3e6, `${bytes} bytes`);
    check(!said.length, said.join('\n'));
});
console.log(`        ${shots.join(' ')}`);
await import('./webgpu-page.mjs');
await end();
