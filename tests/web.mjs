/* web.mjs - make web-test: the texts of WebGL 2 and the page of make web in a browser without a window.
   node tests/web.mjs [WORD OF A TEST], from the repository's root after make web. */
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, statSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { read, write } from '../examples/web/settings.mjs';
import { check, end, launch, note, rest, run, serve } from './web-kit.mjs';
import { calls, hashes, indexed, models, unsound, wedge, works } from './web-hostile.mjs';

const browser = await launch('--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist',
                             '--hide-scrollbars');
const root = await serve('build');

const said = [];                                    /* what consoles said that is wrong */
async function open(hash, { width = 1280, height = 800, scale = 1, before = null } = {}) {
    const page = await browser.newPage();
    page.on('console', m => {
        if (['error', 'warn', 'warning'].includes(m.type())) said.push(`${hash}: ${m.type()}: ${m.text()}`);
    });
    page.on('pageerror', e => said.push(`${hash}: ${e.message}`));
    page.on('requestfailed', r => said.push(`${hash}: ${r.url()}: ${r.failure()?.errorText}`));
    await page.setViewport({ width, height, deviceScaleFactor: scale, isMobile: width < 600, hasTouch: width < 600 });
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
    const before = read('a=s3ho&p=FAST&sky=white&size=640x360&cam=1,2,3,4,5,6&radius=1&thickness=1', limits).set;
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
        ['scene=file', 'scene=file: must be opened again: a model of your own is in no address'],
        ['cam=1,2,3,1,2,3', 'cam=1,2,3,1,2,3: must be six numbers, an eye and a target elsewhere, -1e9 to 1e9'],
        ['radius=3', 'radius=3: must be a number from -2 to 2'],
        ['thickness=-2', 'thickness=-2: must be a number from 0 to 2, or -1 for the method\'s own'],
        ['sun=yes', 'sun=yes: must be 0 or 1'], ['constructor=1', 'constructor: there is no such setting']]) {
        const { set, wrong } = read(hash, limits, before), [name] = hash.split('=');
        check(wrong.length === 1 && wrong[0] === wanted, `${hash}: ${wrong}`);
        check(set[name] === before[name] || !Object.hasOwn(before, name), `${hash} changes ${name}`);
    }
    check(read('a=ssao&a=hsao&b=none&a=ssdo', limits).set.a === 'ssdo', 'of a name that is repeated the last counts');
    note(`4,000 addresses, ${sentences} sentences`);
});

/* ---- the page */

const page = await open('size=960x540');
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
    ['casters', 'a=march', ['hsao-march']], ['casters', 'a=hsao&behind=BACK', ['hsao', '--set', 'behind=back']],
    ['plates', 'a=hsao&p=FAST', ['hsao-fast']]])
    await run(`ambient visibility is build/render's: ${scene}, ${words.join(' ')}`, async () => {
        render(scene, '--method', ...words, '--size', '480x270', '--out', `${out}/ao.png`);
        await go(`scene=${scene}&b=off&size=480x270&${hash}`);
        const { rmse, near, least } = await against(`${out}/ao.png`);
        note(`RMSE ${rmse.toFixed(4)}, ${(100 * near).toFixed(1)} % of pixels within 1/255`);
        check(least < 0.8, 'nothing is occluded');
        check(rmse <= 0.006, `RMSE ${rmse}`);
    });
/* Both read one G-buffer, which the page drew and which brings its camera and radius. */
await run('the same of one G-buffer, that of the page: room', async () => {
    await go('scene=room&b=off&size=480x270');
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
        await go(`scene=room&b=off&size=480x270&${hash}`);
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
    await go('b=truth&size=480x270');
    await page.waitForFunction('page.rays() >= 8', { timeout: 60000 });
    const [is, rays] = await page.evaluate('[page.error(0), page.rays()]');
    note(`RMSE ${is.toFixed(4)} by ${rays} rays a pixel, ${wanted.toFixed(4)} by build/render's 64`);
    check(Math.abs(is - wanted) < 0.003, `${is} against ${wanted}`);
});
await run('and of light: the same error of ssdo under the sky', async () => {
    const words = ['casters', '--method', 'ssdo', '--env', 'sky', '--set', 'bounce=none', '--size', '240x136'];
    render(...words, '--truth', '64', '--out', `${out}/truth.exr`);
    const wanted = +/irradiance: RMSE ([\d.]+)/.exec(render(...words, '--score', `${out}/truth.exr`))[1];
    await go('scene=casters&a=ssdo&b=truth&size=240x136');
    await page.waitForFunction('page.rays() >= 16', { timeout: 60000 });
    const is = await page.evaluate('page.error(0)');
    note(`RMSE ${is.toFixed(4)}, ${wanted.toFixed(4)} by build/render, noise of its 64 rays and all`);
    check(Math.abs(is - wanted) < 0.004, `${is} against ${wanted}`);
});

await run('every method, side, view and choice is drawn', async () => {
    const drawn = [];
    for (const hash of ['a=none', 'a=ssdo&b=points&view=ambient', 'a=s3ho&b=march&p=FAST', 
                        'a=ssdo&bounce=1&history=1&b=s3ho&q=BEST',
                        'a=ssao&b=hsao&behind=SOLID&history=1',
                        'a=ssdo&behind=BACK&normals=FROM_DEPTH&sky=windows&sun=0',
                        'scene=cornell&view=difference&b=ssao&sky=white',
                        'scene=bunny&a=hsao&radius=1&thickness=1.5']) {
        await go(`size=320x180&${hash}`);
        const notice = await page.$eval('#notice', p => (p.hidden ? '' : p.textContent));
        check(!notice, `${hash}: ${notice}`);
        drawn.push(hash);
    }
    note(`${drawn.length} addresses`);
});

await run('the address carries the settings', async () => {
    await go('scene=cornell&a=ssdo&p=BEST&b=truth&radius=0.5&behind=SOLID&size=320x180&cam=0,2.745,9,0,2.7,0');
    await rest(400);
    const { hash, selected } = await page.evaluate(() => {
        const { elements } = document.getElementById('panel');
        return { hash: location.hash,
                 selected: ['scene', 'a', 'p', 'b', 'behind'].map(name => elements[name].value).join() };
    });
    check(selected === 'cornell,ssdo,BEST,truth,SOLID', selected);
    for (const part of ['scene=cornell', 'a=ssdo', 'p=BEST', 'b=truth', 'radius=0.5', 'behind=SOLID',
                        'cam=0,2.745,9,0,2.7,0'])
        check(hash.includes(part), `${hash} lacks ${part}`);
});

await run('history settles, and lowers the error', async () => {
    await go('size=320x180&a=hsao&p=FAST&b=truth');
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
    await go('size=320x180&b=off');
    await (await page.$('#file')).uploadFile(`${out}/wedge.obj`);
    await page.waitForFunction(`document.querySelector('[name=scene]').value === 'file'`, { timeout: 20000 });
    await rest(500);
    const least = await page.evaluate(() => page.result(0).pixels.reduce((a, b) => Math.min(a, b), 1));
    check(least < 0.9, `nothing is occluded: ${least}`);
});

/* What is seen: on the canvas, and beside it. */
const seen = page => page.evaluate(() => {
    const { elements } = document.getElementById('panel'), notice = document.getElementById('notice');
    const picture = page.picture();
    let opaque = true, sum = 0;
    for (let i = 0; i < picture.length; i += 4) {
        opaque &&= picture[i + 3] === 255;
        sum = (Math.imul(sum, 31) + picture[i] + 256 * picture[i + 1] + 65536 * picture[i + 2]) | 0;
    }
    return { there: opaque && picture.length > 0, sum, scene: elements.scene.value,
             title: elements.scene.selectedOptions[0].text, notice: notice.hidden ? '' : notice.textContent };
});
const same = (a, b) => Object.keys(a).every(key => a[key] === b[key]);
/* Drops a file onto the page; resolves when it is shown, or what is wrong with it. unread: why it cannot be read. */
const drop = (page, name, text, unread = null) => page.evaluate(async (name, text, unread) => {
    const file = new File([text], name), dataTransfer = new DataTransfer(), shown = page.result(0).pixels;
    const { arrayBuffer } = File.prototype, notice = document.getElementById('notice');
    if (unread) File.prototype.arrayBuffer = () => Promise.reject(new DOMException(unread, 'NotReadableError'));
    dataTransfer.items.add(file);
    dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
    while (notice.hidden && page.result(0).pixels === shown) await new Promise(requestAnimationFrame);
    if (unread) File.prototype.arrayBuffer = arrayBuffer;
}, name, text, unread);

await run('a model that cannot be shown is named with what is wrong; scene and title stay', async () => {
    for (const begin of [() => go('size=160x90&b=off&scene=cornell'), () => drop(page, 'wedge.obj', wedge(1))]) {
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
    await go('scene=cornell&size=160x90&b=off');
    await go('scene=file&size=160x90&b=off');
    const { title, notice } = await seen(page);
    check(title === 'wedge.obj' && !notice, `the model is not found again: ${title}: ${notice}`);
});
await run('a model is drawn alike in any unit, and without the lines beside it', async () => {
    const means = [], begun = said.length;
    for (const text of [wedge(1), wedge(1e-5), wedge(1e7), `${wedge(1)}l 1 4\np 2\n`]) {
        await drop(page, 'some.obj', text);
        check(!(await seen(page)).notice, (await seen(page)).notice);
        means.push(await page.evaluate(() => {
            const { pixels } = page.result(0);
            return pixels.reduce((sum, v) => sum + v, 0) / pixels.length;
        }));
    }
    await drop(page, 'bounds.gltf', indexed(0, 1, 2));
    const { title, notice } = await seen(page);
    check(title === 'bounds.gltf' && !notice, `${title}: ${notice}`);
    check(said.length === begun, said.slice(begun).join('\n'));
    note(`mean visibility ${means.map(v => v.toFixed(4)).join(', ')}`);
    check(means[0] < 0.999 && means.every(v => Math.abs(v - means[0]) < 0.001), means.join());
});
await run('a scene that does not come leaves the one that is shown', async () => {
    await go('size=160x90&b=off&scene=cornell');
    const before = await seen(page);
    await page.setRequestInterception(true);
    const cut = request => (request.url().endsWith('slats.bin')
        ? request.respond({ status: 200, body: Buffer.alloc(100) }) : request.continue());
    page.on('request', cut);
    await page.evaluate(hash => page.go(hash), 'size=160x90&b=off&scene=slats');
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
        const { there, notice } = await seen(page), wanted = expected(got.taken.slice(1), got);
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
        const page = await open(`size=64x36&${hash}`), { there, notice } = await seen(page);
        const limits = await page.evaluate('page.limits()');
        await page.close();
        check(there, `${hash}: no picture`);
        check(said.length === begun, `${hash}: ${said.slice(begun).join()}`);
        const wanted = expected(`size=64x36&${hash}`, { limits });
        check(!!notice === !!wanted, `${hash} says ${notice || 'nothing'}`);
    }
    note(`${all.length} loads`);
});

/* ---- how it looks, and where there is little */

mkdirSync('report', { recursive: true });
const shots = [];
async function shoot(name, hash, options, settle = 1500) {
    const page = await open(hash, options);
    if (typeof settle === 'number') await rest(settle); else await page.waitForFunction(settle, { timeout: 60000 });
    await page.screenshot({ path: `report/web-${name}.png` });
    shots.push(`report/web-${name}.png`);
    return page;
}
await run('on a desktop (1280 x 800)', async () => {
    await (await shoot('desktop', '')).close();
    const page = await shoot('difference', 'b=ssao&view=difference', {}, 'page.rays() >= 4');
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

await run('a tracer that fails is said', async () => {
    const page = await open('size=64x36&b=truth', { before: `globalThis.Worker = class extends Worker {
        postMessage(data) { super.postMessage(data.scene ? { scene: { position: [1], normal: [1] } } : data); } };` });
    await page.waitForSelector('#notice:not([hidden])', { timeout: 20000 });
    const { notice } = await seen(page);
    await page.close();
    check(notice === 'the truth: position: must have 9 numbers a triangle, has 1', notice);
});

await run('the console is silent, the folder small', async () => {
    const bytes = readdirSync('build/web', { recursive: true }).filter(name => !name.startsWith('scenes'))
        .reduce((sum, name) => {
            const file = statSync(join('build/web', name));
            return sum + (file.isFile() && file.size);
        }, 0);
    note(`build/web without its scenes: ${(bytes / 1e6).toFixed(2)} MB`);
    check(bytes <= 3e6, `${bytes} bytes`);
    check(!said.length, said.join('\n'));
});
console.log(`        ${shots.join(' ')}`);
await end();
