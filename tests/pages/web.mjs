/* web.mjs - make web-test: the shaders of WebGL 2, and the page of make web, in a browser without a window.
   node tests/pages/web.mjs [WORD OF A TEST], from the repository's root after make web. */
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, statSync, readdirSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { isDeepStrictEqual } from 'node:util';
import { exr } from '../../examples/web/exr.mjs';
import { resolutions, lookOf, looks, methods, normals, presets, read, settings, shadows, thicknesses, views,
         write } from '../../examples/web/settings.mjs';
import { skies } from '../../examples/web/sky.mjs';
import { check, end, launch, note, rest, run, serve, software } from './web-kit.mjs';
import { draco, glowingWedge, hdr, indexed, models, wedge } from './web-hostile.mjs';

const browser = await launch(...software), root = await serve('build'), out = 'build/web-test';

const said = [];                                    /* errors on the consoles */
function hear(page, name) {
    page.on('console', m => {
        if (/was preloaded .* but not used/.test(m.text())) return;     /* on a busy machine; a wrong name is a 404 */
        if (['error', 'warn', 'warning'].includes(m.type())) said.push(`${name}: ${m.type()}: ${m.text()}`);
    });
    page.on('pageerror', e => said.push(`${name}: ${e.message}`));
    page.on('requestfailed', r => said.push(`${name}: ${r.url()}: ${r.failure()?.errorText}`));
}
async function open(hash, { width = 1280, height = 800, before = null } = {}) {
    const page = await browser.newPage();
    hear(page, hash);
    await page.setViewport({ width, height, isMobile: width < 600, hasTouch: width < 600 });
    if (before) await page.evaluateOnNewDocument(before);
    await page.goto(`${root}/web/#${hash}`, { waitUntil: 'domcontentloaded' });
    await page.waitForFunction('globalThis.page && (page.first || page.lacks)', { timeout: 60000 });
    return page;
}
/* Runs a test that fails if the console has an error meanwhile. */
const quietly = (sentence, test) => run(sentence, async () => {
    const begun = said.length;
    await test();
    check(said.length === begun, said.slice(begun).join('\n'));
});
const render = (...words) =>
    execFileSync('build/render', words, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
/* Returns the bytes of an expression's value in the page. */
const bytesOf = async (page, expression) => Buffer.from(await page.evaluate(async expression => {
    const bytes = new Uint8Array((await (0, eval)(expression)).buffer);
    let text = '';
    for (let i = 0; i < bytes.length; i += 32768) text += String.fromCharCode(...bytes.subarray(i, i + 32768));
    return btoa(text);
}, expression), 'base64');

/* ---- without a page: the address */

const limits = { scenes: ['room', 'bunny', 'cornell'], side: 4096, pixels: 1920 * 1080 };
const words = { scene: limits.scenes, sky: Object.keys(skies), view: views, a: Object.keys(methods),
                b: [...Object.keys(methods), 'truth', 'off'], p: Object.keys(presets), q: Object.keys(presets),
                shadow: Object.keys(shadows), resolution: Object.keys(resolutions), thickness: Object.keys(thicknesses),
                normals: Object.keys(normals), size: ['auto', '16x16', '1920x1080'], cam: ['', '1,2,3,4,5,6'] };
const never = ['NaN', 'constructor', '__proto__', 'toString', '😀', '%00', '1,2,3', '<b>', 'x'.repeat(300)];
await run('each setting takes its values, which an address carries; all else is refused in a sentence', () => {
    const before = read('a=s3ho&p=FAST&sky=white&size=640x360&cam=1,2,3,4,5,6&radius=1&thickness_limit=1', limits).set;
    for (const [name, { least, most, initial, must }] of Object.entries(settings)) {
        const number = least !== undefined;
        for (const value of words[name] ?? (number ? [least, most, initial] : [0, 1])) {
            const { set, wrong } = read(`${name}=${value}`, limits, before), again = read(write(set), limits);
            check(!wrong.length && (set[name] === value || +set[name] === +value), `${name}=${value}: ${wrong}`);
            check(isDeepStrictEqual(again, { set, wrong: [] }), `${name}=${value} is written as ${write(set)}`);
        }
        for (const value of [...never, ...(number ? [most + 1, least - 2, 'Infinity', ''] : [])]) {
            const { set, wrong } = read(`${name}=${value}`, limits, before);
            check(set[name] === before[name] && wrong.length === 1 && wrong[0].startsWith(`${name}=`)
                  && wrong[0].endsWith(`: ${must(`${value}`, limits)}`), `${name}=${value} says ${wrong}`);
        }
    }
    for (const [hash, wanted] of [
        ['size=1921x1080',
         'size=1921x1080: must be auto or WIDTHxHEIGHT, 16 to 4096 pixels each, at most 2073600 in all'],
        ['p=constructor', 'p=constructor: must be one of FAST, BALANCED, BEST'],
        ['sky=file', 'sky=file: must be opened again: a sky of your own is in no address'],
        ['samples=1.5', 'samples=1.5: must be a whole number from 1 to 32, or 0 for the preset\'s'],
        ['scene=file', 'scene=file: must be opened again: a model of your own is in no address'],
        ['cam=1,2,3,1,2,3', 'cam=1,2,3,1,2,3: must be six numbers, an eye and a target elsewhere, -1e9 to 1e9'],
        ['sun=yes', 'sun=yes: must be 0 or 1'], ['constructor=1', 'constructor: there is no such setting']]) {
        const { wrong } = read(hash, limits, before);
        check(wrong.length === 1 && wrong[0] === wanted, `${hash}: ${wrong}`);
    }
    check(read('a=ssao&a=hsao&b=none&a=ssdo', limits).set.a === 'ssdo', 'of a name that is repeated the last counts');
    check(Object.keys(Object.prototype).length === 0, 'Object.prototype has got members');
});

/* ---- pictures beside build/render's */

const page = await open('size=64x36&scene=cornell&b=off&history=0');
const go = hash => page.evaluate(h => page.go(h), hash);

/* Returns the page's sun, in words of build/render. */
async function sunlight() {
    const { toSun, irradiance } = await page.evaluate('page.inside().stage.sunlight');
    return ['--light', `sun:${[...toSun, ...irradiance].join()}`];
}
/* Returns the RMSE between build/render's picture and the page's left side; of light, over the mean. */
async function apart(given) {
    const { width, height, light } = await page.evaluate(() => {
        const { width, height, pixels } = page.result(0);
        return { width, height, light: pixels.length > width * height };
    });
    const bytes = await bytesOf(page, 'page.result(0).pixels');
    const pixels = new Float32Array(bytes.buffer, bytes.byteOffset, bytes.length / 4), channels = {};
    if (!light) channels.Y = pixels;
    for (const of of light ? ['', 'irradiance.', 'bounce.'] : [])
        ['R', 'G', 'B'].forEach((name, c) => { channels[of + name] = pixels.filter((_, i) => i % 4 === c); });
    writeFileSync(`${out}/page.exr`, exr(width, height, channels));
    const told = render(...given, '--score', `${out}/page.exr`);
    const [, rmse, mean, p95] = /(?:exr|irradiance): RMSE ([\d.]+) \(\S+ of (?:its mean )?([^)]+)\).* p95 ([\d.]+)/
        .exec(told);
    return light ? { rmse: rmse / mean, p95: p95 / mean } : { rmse: +rmse, p95: +p95 };
}
/* Both draw the scene. Rasterisers differ at silhouettes by a pixel here and there, and fine scenes have many
   silhouettes. For the room both use one G-buffer, which the page drew, and its camera and radius. */
const sky = 'a=ssdo&sky=sky', ssdo = ['ssdo', '--env', 'sky', '--set'];
for (const [scene, hash, given, most = 0.006] of [
    ['plates', 'a=hsao&p=FAST', ['hsao-fast']], ['casters', 'a=hsao&p=BEST', ['hsao-best']],
    ['casters', 'a=ssao', ['ssao']], ['casters', 'a=march', ['hsao-march']],
    ['casters', 'a=hsao&thickness=BACK', ['hsao', '--set', 'thickness=back']],
    ['casters', 'a=hsao&thickness=SLABS', ['hsao', '--set', 'thickness=slabs']],
    ['casters', 'a=hsao&slices=3&samples=7&resolution=FULL&filter=2',
     ['hsao', '--set', 'slices=3,samples=7,resolution=full,blur=2']],
    ['casters', 'a=dss&p=BEST', ['dss', '--set', 'levels=4,resolution=full,samples=7']],
    ['cornell', 'a=dss&surfel=1.5&levels=3', ['dss', '--set', 'size=0.015,levels=3']],
    ['room', `${sky}&sun=0`, [...ssdo, 'bounce=none']],
    ['room', `${sky}&shadow=SEGMENT`, [...ssdo, 'bounce=none,shadows=segment']],
    ['casters', `${sky}&shadow=FILL`, [...ssdo, 'bounce=none,shadows=fill,shadow_size=2048'], 0.1]])
    await run(`the picture is build/render's: ${scene}, ${hash}`, async () => {
        const size = '320x180';
        await go(`scene=${scene}&b=off&size=${size}&history=0&radius=0&${hash}`);
        if (scene === 'room') writeFileSync(`${out}/frame.exr`, await bytesOf(page, 'page.frame()'));
        const { rmse, p95 } = await apart([
            ...(scene === 'room' ? ['--gbuffer', `${out}/frame.exr`] : [scene, '--size', size]), '--method', ...given,
            ...(hash.includes('shadow') ? await sunlight() : [])]);
        note(`RMSE ${rmse.toFixed(4)}, 95 % of pixels within ${p95.toFixed(4)}`);
        check(rmse <= most && p95 <= 0.006, `RMSE ${rmse}, 95 % of pixels within ${p95}`);
    });

for (const [scene, hash, given, off] of [
    ['room', 'a=hsao&size=120x68', ['hsao'], 0.004],
    ['casters', `${sky}&size=120x68&shadow=MAP`, [...ssdo, 'bounce=none,shadows=map,shadow_size=2048'], 0.02]])
    await run(`the truth traced in the page finds the error that build/render's does: ${scene}, ${hash}`, async () => {
        await go(`scene=${scene}&b=truth&history=0&radius=0&${hash}`);
        const all = [scene, '--size', '120x68', '--method', ...given,
                     ...(hash.includes('shadow') ? await sunlight() : [])];
        render(...all, '--truth', '256', '--out', `${out}/truth.exr`);
        const wanted = +/(?:exr|irradiance): RMSE ([\d.]+)/.exec(render(...all, '--score', `${out}/truth.exr`))[1];
        await page.waitForFunction('page.rays() >= 16', { timeout: 60000 });
        const is = await page.evaluate('page.error(0)');
        note(`RMSE ${is.toFixed(4)}, ${wanted.toFixed(4)} by build/render`);
        check(Math.abs(is - wanted) < off, `${is} against ${wanted}`);
    });

/* ---- settings */

/* Returns the canvas and the panel beside it; calm: waits until the page rests. */
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
await quietly('every word of every setting is drawn, on both sides', async () => {
    const others = Object.entries(words).filter(([name]) => !['scene', 'size', 'cam', 'a', 'b'].includes(name))
        .flatMap(([name, list]) => list.map(word => `${name}=${word}${name === 'shadow' ? '' : '&a=hsao'}`));
    const all = [...words.b.map(b => `b=${b}${words.a.includes(b) ? `&a=${b}` : ''}`), ...others,
                 'bounce=1&shadow=FILL&b=s3ho', 'view=difference&b=ssao', 'moves=1&a=aof'];
    for (const hash of all) {
        await go(`size=96x54&scene=casters&p=FAST&a=ssdo&b=off&${hash}`);
        const { there, notice } = await seen(page, false);
        check(there && !notice, `${hash}: ${notice || 'no picture'}`);
    }
    note(`${all.length} addresses`);
});
/* Returns the sentences that node makes of an address and settings, which the page must show. */
const expected = (hash, { limits, before }) => {
    const { wrong } = read(hash, limits, before), shown = wrong.slice(0, 3), more = wrong.length - shown.length;
    return [...shown, ...(more ? [`and ${more} more`] : [])].join('\n');
};
await quietly('no address stops a page that is open', async () => {
    const all = Object.keys(settings).map((name, i) => `${name}=${never[i % never.length]}&a=hsao&p=${i}`);
    for (const hash of [...all.filter((_, i) => i % 4 === 0), all.join('&'), '%',
                        'scene=%E0%A4%A&cam=1e300,0,0,0,0,0', '\ud800=%F0%9F%98%80',
                        '__proto__=1&toString=2', 'size=9999x9999&scene=file&sky=file']) {
        const got = await page.evaluate(async hash => {
            const before = { ...page.set }, going = page.go(hash), { hash: taken } = location;
            const error = await going.then(() => null, e => e.message);
            return { before, taken, error, limits: page.limits() };
        }, `size=64x36&scene=cornell&history=0&${hash}`);
        const { there, notice } = await seen(page, false), wanted = expected(got.taken.slice(1), got);
        check(got.error === null && there, `${hash}: ${got.error ?? 'no picture'}`);
        check(notice === wanted, `${hash} says ${notice}\nand should say ${wanted}`);
    }
});

/* ---- files */

/* Drops files onto the page; resolves when they are shown or refused. unread: the reason why none can be read. */
const drop = (page, contents, unread = null) => page.evaluate(async (files, unread) => {
    const dataTransfer = new DataTransfer(), loading = document.getElementById('loading');
    const { stream } = File.prototype;
    const broken = () => new ReadableStream({ pull(c) { c.error(new DOMException(unread, 'NotReadableError')); } });
    if (unread) File.prototype.stream = broken;
    for (const [name, bytes] of files) dataTransfer.items.add(new File([Uint8Array.from(bytes)], name));
    dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
    const begun = !loading.hidden;
    while (!loading.hidden) await new Promise(requestAnimationFrame);
    if (unread) File.prototype.stream = stream;
    for (let i = 0; i < 3; ++i) await new Promise(requestAnimationFrame);
    return begun;
}, Object.entries(contents).map(([name, content]) => [name, [...Buffer.from(content)]]), unread);
const says = (message, wanted) => (typeof wanted === 'string' ? message === wanted : wanted.test(message));

await quietly('a model that cannot be shown is named with what is wrong; scene and title stay', async () => {
    await go('size=64x36&b=off&scene=cornell&history=0');
    await drop(page, { 'wedge.obj': wedge(1) });
    const before = await seen(page);
    check(before.there && !before.notice, `before: ${JSON.stringify(before)}`);
    for (const [name, text, wanted, unread] of [...models,
        ['gone.obj', wedge(1), 'gone.obj: cannot be read: it is gone; must be a file', 'it is gone']]) {
        await drop(page, { [name]: text }, unread);
        const { notice, ...after } = await seen(page);
        check(says(notice, wanted), `${name}: ${notice}`);
        check(isDeepStrictEqual({ ...after, notice: '' }, before), `${name}: ${JSON.stringify([before, after])}`);
    }
    await go('scene=cornell&size=64x36&b=off&history=0');
    await go('scene=file&size=64x36&b=off&history=0');
    const { title, notice } = await seen(page);
    check(title === 'wedge.obj' && !notice, `the model is not found again: ${title}: ${notice}`);
});
await quietly('a model is drawn alike in any unit and place, and without the lines beside it', async () => {
    const place = [13487434.764, -6.397, -3741689.403], means = [];
    const far = 'it lies far from 0 beside its size, and is shown about ';
    const emits = 'its materials emit light, which is not shown';
    for (const [name, text, ...notes] of [
        ['some.obj', wedge(1e7)], ['far.obj', `${wedge(1, place)}l 1 4\np 2\n`, `${far}13487436,-6,-3741689`],
        ['tiny.obj', wedge(1e-5, [1, 1, 1]), `${far}1,1,1`],
        ['far.gltf', glowingWedge(place), emits, `${far}13487435,-6,-3741689`],
        ['near.gltf', glowingWedge([0, 0, 0]), emits],
        ['own.gltf', glowingWedge([0, 0, 0], 13487434), emits,
         'its coordinates are floats, which so far from 0 are 1 apart, 0.58 of its size', `${far}13487435,1,1`],
        ['bounds.gltf', indexed(0, 1, 2)]]) {
        await drop(page, { [name]: text });
        const { title, notice } = await seen(page);
        check(title === name && notice === notes.map(said => `${name}: ${said}`).join('\n'), `${name}: ${notice}`);
        means.push(await page.evaluate(() => {
            const { pixels } = page.result(0);
            return pixels.reduce((sum, v) => sum + v, 0) / pixels.length;
        }));
    }
    note(`mean visibility ${means.map(v => v.toFixed(4)).join(', ')}`);
    for (const all of [means.slice(0, 3), means.slice(3, 6)])       /* corners of a glTF share their normals */
        check(all[0] < 0.999 && all.every(v => Math.abs(v - all[0]) < 0.001), all.join());
});
await quietly('files that belong together are read together: OBJ, MTL, picture; glTF, BIN; packed GLB', async () => {
    const faces = wedge(1).replace(/f /, 'vt 0 0\nusemtl red\nf ');
    const picture = await bytesOf(page, `(async () => {
        const canvas = new OffscreenCanvas(4, 4), context = canvas.getContext('2d');
        context.fillStyle = '#00f';
        context.fillRect(0, 0, 4, 4);
        return new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer());
    })()`);
    const parts = JSON.parse(indexed(0, 1, 2)), bytes = Buffer.from(parts.buffers[0].uri.split(',')[1], 'base64');
    parts.buffers[0].uri = 'some%20parts.bin';
    for (const [files, channel, said = ''] of [
        [{ 'b.obj': `mtllib b.mtl\n${faces.replace(/f (\d) (\d) (\d)/g, 'f $1/1 $2/1 $3/1')}`,
           'b.mtl': 'newmtl red\nmap_Kd blue.png\n', 'blue.png': picture }, 2],
        [{ 'c.gltf': JSON.stringify(parts), 'some parts.bin': bytes }], [{ 'd.glb': draco }],
        [{ 'grey.obj': `mtllib gone.mtl\n${faces}` }, undefined,
         'grey.obj: gone.mtl is not beside it: drop both together for its materials']]) {
        const [name] = Object.keys(files);
        await go('size=160x90&b=off&scene=cornell&history=0&a=none');
        check(await drop(page, files), `${name}: nothing says that it is read`);
        const { title, notice } = await seen(page);
        check(title === name && notice === said, `${title}: ${notice}`);
        const found = await page.evaluate(() => {         /* the colour in the middle: the model, not the floor */
            const all = page.picture(), at = 4 * (45 * 160 + 78);
            return [...all.subarray(at, at + 3)];
        });
        check(channel === undefined || found.every((v, c) => c === channel || found[channel] > 1.5 * v),
              `${name}: ${found}`);
    }
});
await quietly('a sky of one\'s own lights the scene, and its truth', async () => {
    const blue = hdr(64, 32, 128), head = blue.length - 4 * 64 * 32;
    for (let i = head; i < blue.length; i += 4) blue[i] = blue[i + 1] = 20;
    await go('size=160x90&b=off&scene=cornell&history=0&a=ssdo&view=ambient&sky=white');
    await drop(page, { 'blue.hdr': blue });
    const { notice } = await seen(page), sum = await page.evaluate(() => {
        const { pixels } = page.result(0);
        return [0, 1, 2].map(c => pixels.reduce((sum, v, i) => sum + (i % 4 === c ? v : 0), 0));
    });
    check(!notice && sum[2] > 4 * sum[0] && sum[2] > 4 * sum[1], `${sum} ${notice}`);
    await go('size=160x90&b=truth&scene=cornell&history=0&a=ssdo&sky=file');
    await page.waitForFunction('page.rays() >= 16', { timeout: 60000 });
    const error = await page.evaluate('page.error(0)');
    check(error > 0.005 && error < 0.2, `RMSE of ssdo ${error}`);
});
await quietly('the field of a model of one\'s own is build/render\'s, on its ground', async () => {
    await go('size=320x180&b=off&history=0&a=aof&p=FAST&radius=0');
    writeFileSync(`${out}/wedge.obj`, wedge(1));
    await (await page.$('#file')).uploadFile(`${out}/wedge.obj`);
    await page.waitForFunction(`page.inside().stage.info.title === 'wedge.obj' && !page.making()`, { timeout: 60000 });
    await go('scene=file&size=320x180&b=off&history=0&a=aof&p=FAST&radius=0');
    const { position, eye, target, fov, near, far } = await page.evaluate(() => {
        const { stage } = page.inside(), { info: { eye, target, near, far }, camera: { fov } } = stage;
        return { position: [...stage.triangles(0).position], eye, target, fov, near, far };
    });
    const corners = Array.from({ length: position.length / 3 }, (_, i) => i);
    writeFileSync(`${out}/ground.obj`, [`o wedge\n${wedge(1)}o ground`,
        ...corners.map(i => `v ${position.slice(3 * i, 3 * i + 3).join(' ')}`),
        ...corners.filter(i => i % 3 === 0).map(i => `f ${[5, 6, 7].map(k => k + i).join(' ')}`), ''].join('\n'));
    const { rmse } = await apart([`${out}/ground.obj`,
        '--method', 'aof', '--set', 'field_resolution=8,rays=64', '--size', '320x180',
        '--camera', [...eye, ...target].join(), '--fovy', `${fov}`, '--near', `${near}`, '--far', `${far}`]);
    const least = await page.evaluate(() => page.result(0).pixels.reduce((a, b) => Math.min(a, b), 1));
    note(`RMSE ${rmse.toFixed(4)}, darkest ${least.toFixed(2)}`);
    check(least < 0.8 && rmse <= 0.005, `RMSE ${rmse}, darkest ${least}`);
});
await quietly('a scene that does not come leaves the one that is shown', async () => {
    await go('size=160x90&b=off&scene=cornell&history=0');
    const before = await seen(page), cut = request => (request.url().endsWith('slats.bin')
        ? request.respond({ status: 200, body: Buffer.alloc(100) }) : request.continue());
    await page.setRequestInterception(true);
    page.on('request', cut);
    await go('size=160x90&b=off&scene=slats&history=0');
    page.off('request', cut);
    await page.setRequestInterception(false);
    const { notice, ...after } = await seen(page);
    check(notice === 'scenes/slats.bin: is cut short or no scene; must be as make web writes it', notice);
    check(isDeepStrictEqual({ ...after, notice: '' }, before), JSON.stringify([before, after]));
});
await page.close();                                 /* pages in the background draw no frames */

/* ---- controls and keys */

/* Sets a control of the panel as a visitor does; resolves when the page has drawn it. */
const put = (page, name, value) => page.evaluate(async (name, value) => {
    const all = [...document.getElementById('panel').elements].filter(e => e.name === name);
    const control = all.length > 1 ? all.find(e => e.value === value) : all[0];
    if (!control || control.disabled) throw new Error(`${name}: there is no such control`);
    if (control.type === 'checkbox' || control.type === 'radio') control.checked = value !== false;
    else control.value = value;
    control.dispatchEvent(new Event('input', { bubbles: true }));
    for (let i = 0; i < 3 || page.making(); ++i) await new Promise(requestAnimationFrame);
}, name, value);

await quietly('a scene brings its light, a method the view that shows it', async () => {
    const page = await open('size=96x54&history=0&scene=casters'), is = what => page.evaluate(what);
    for (const scene of [...Object.keys(looks), 'casters']) {
        await put(page, 'scene', scene);
        const wanted = { ...lookOf(scene), scene, size: '96x54', history: false }, set = await is('page.set');
        check(isDeepStrictEqual(set, wanted), `${scene}: ${write(set)}`);
    }
    await put(page, 'a', 'ssdo');
    check(await is('page.set.bounce && page.set.view') === 'ambient', 'SSDO is chosen');
    await put(page, 'view', 'lit');
    await put(page, 'a', 'hsao');
    check(await is('page.set.view') === 'lit', 'a view that was chosen does not stay');
    await page.close();
});
mkdirSync('report', { recursive: true });
for (const [width, height] of [[1280, 800], [390, 844]])
    await quietly(`every control is operated at ${width} x ${height}`, async () => {
        const page = await open('size=160x90&history=0&scene=casters&b=off', { width, height });
        await page.screenshot({ path: `report/web-${width}.png` });
        const state = () => page.evaluate(async () => {
            for (let i = 0; i < 2; ++i) await new Promise(requestAnimationFrame);
            const { chain, steps } = page.chain(0), was = globalThis.shown ?? [], is = page.picture();
            globalThis.shown = is;
            let sum = 0;
            for (let i = 0; i < is.length; ++i) sum += Math.abs(is[i] - (was[i] ?? 0));
            return { other: sum / is.length, chain, steps, set: { ...page.set } };
        });
        const operated = [
            ['exposure', 1.5, 'picture'], ['effect', 3, 'picture'], ['azimuth', -90, 'picture'],
            ['height', 80, 'picture'], ['strength', 3, 'picture'], ['sun', false, 'picture'],
            ['sky', 'windows', 'picture'], ['view', 'ambient', 'picture'], ['radius', 0, 'picture'],
            ['slices', 4, ({ chain }) => chain.desc.slices === 4],
            ['samples', 3, ({ chain }) => chain.desc.samples === 3],
            ['resolution', 'FULL', ({ chain }) => chain.desc.resolution === 'FULL'],
            ['filter', 3, ({ chain }) => chain.desc.filter_radius === 3],
            ['filter', 0, ({ chain, steps }) => !chain.blur && !steps.includes('BLUR')],
            ['resolution', 'HALF', ({ chain, steps }) => chain.desc.resolution === 'HALF' && steps.includes('BLUR')],
            ['thickness', 'SLABS', ({ chain }) => chain.desc.thickness === 'SLABS'],
            ['thickness_limit', 1.7, ({ set }) => set.thickness_limit === 1.7],
            ['normals', 'FROM_DEPTH', ({ chain }) => chain.desc.normal === 'FROM_DEPTH'],
            ['p', 'BEST', ({ chain }) => chain.desc.samples === 3],
            ['a', 'dss', ({ chain, steps }) => chain.desc.pass === 'DSS' && steps.includes('INTERLEAVE')],
            ['levels', 3, ({ chain }) => chain.desc.levels === 3],
            ['surfel', 6, 'picture'],
            ['field', 8, ({ set }) => set.field === 8],
            ['a', 'aof', ({ chain }) => chain.desc.pass === 'AOF'], ['reach', 0.2, 'picture'],
            ['moves', false, ({ set }) => !set.moves],      /* what moves is drawn all the time */
            ['a', 'ssdo', ({ chain }) => chain.desc.pass === 'SSDO'],
            ['bounce', true, ({ chain }) => chain.desc.bounce === 'SOLID_ANGLE'], ['sun', true, 'picture'],
            ['shadow', 'MAP', ({ steps }) => steps.includes('LIGHTS')],
            ['b', 'ssao', ({ set }) => set.b === 'ssao'], ['q', 'FAST', ({ set }) => set.q === 'FAST'],
            ['circle', true, ({ set }) => set.circle], ['circle', false, ({ set }) => !set.circle],
            ['scene', 'cornell', ({ set }) => set.scene === 'cornell'],
            ['history', true, ({ steps }) => steps.includes('HISTORY')],
            ['moves', true, ({ chain }) => chain.desc.motion === 1],
            ['moves', false, ({ chain }) => !chain.desc.motion],
            ['truth', true, ({ set }) => set.truth], ['truth', false, ({ set }) => !set.truth],
            ['size', '480x270', ({ chain }) => chain.width === 480]];
        const untried = Object.keys(settings)
            .filter(name => !['split', 'cam'].includes(name) && !operated.some(([is]) => is === name));
        check(!untried.length, `not tried: ${untried}`);
        const few = ['exposure', 'sky', 'slices', 'thickness', 'b', 'scene', 'history', 'moves', 'truth'];
        for (const [name, value, seen] of operated.filter(([name]) => width > 600 || few.includes(name))) {
            await state();
            await put(page, name, value);
            const after = await state();
            check(seen === 'picture' ? after.other > 0.2 : seen(after),
                  `${name}=${value} does nothing: ${JSON.stringify(after.chain)}`);
        }
        await rest(400);
        const { hash, set } = await page.evaluate(() => ({ hash: location.hash, set: page.set }));
        check(hash === `#${write(set)}`, `the address is ${hash}, the settings ${write(set)}`);
        await page.evaluate(() => document.getElementById('own').click());
        const own = (await state()).set;
        check(['slices', 'samples', 'filter', 'resolution', 'levels', 'surfel', 'field']
            .every(name => own[name] === settings[name].initial), 'the preset stays away');
        const wide = await page.evaluate(() => [document.documentElement.scrollWidth,
            ...[...document.querySelectorAll('#panel :is(select, input, button, p)')].filter(e => e.offsetParent)
                .filter(e => e.getBoundingClientRect().right > innerWidth + 1)
                .map(e => e.name || e.id || e.textContent)]);
        check(wide[0] <= width && wide.length === 1, `out of the page: ${wide}`);
        const small = await page.evaluate(() => [...document.querySelectorAll('#bar button')]
            .filter(e => e.offsetParent).map(e => e.getBoundingClientRect())
            .filter(r => r.width < 32 || r.height < 32 || r.right > innerWidth || r.bottom > innerHeight).length);
        check(small === 0, `${small} buttons over the picture are small or outside`);
        if (width < 600) {
            await page.evaluate('scrollTo(0, 0)');
            await page.touchscreen.touchStart(120, 200);
            for (const x of [140, 170, 200]) await page.touchscreen.touchMove(x, 210);
            await page.touchscreen.touchEnd();
            check(await page.waitForFunction('page.set.cam', { timeout: 30000 }).catch(() => false),
                  'a finger does not orbit');
        }
        await page.close();
    });
await quietly('buttons over the picture and keys', async () => {
    const page = await open('size=160x90&history=0&scene=cornell'), is = what => page.evaluate(what);
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
    for (const [key, wanted] of [
        ['2', 'page.set.view === "ambient"'], ['p', '!document.getElementById("panel").offsetParent'],
        ['p', 'document.getElementById("panel").offsetParent'], ['?', 'document.getElementById("keys").open'],
        ['Escape', '!document.getElementById("keys").open'], ['m', 'page.set.moves'], ['c', 'page.set.circle'],
        ['f', 'document.fullscreenElement?.id === "picture"'], ['f', 'document.fullscreenElement === null']]) {
        await page.keyboard.press(key);
        check(await page.waitForFunction(wanted, { timeout: 5000 }).catch(() => false), key);
    }
    await page.mouse.click(300, 300);
    check(await is('!page.set.circle'), 'a touch does not stop it');
    await page.click('#read');
    const first = await page.$eval('#text pre', pre => pre.textContent);
    check(first.startsWith('#version 300 es') && first.includes('ssgi_frame'), first.slice(0, 80));
    await page.click('#text-close');
    await page.evaluate(() => document.querySelector('#thumbs button[value=room]').click());
    await page.waitForFunction(`page.set.scene === 'room' && document.getElementById('loading').hidden`);
    await page.close();
});
await quietly('the error is readable: a map, its worst, the pointer\'s pixel, a share', async () => {
    const page = await open('size=160x90&scene=cornell&a=hsao&b=truth&view=difference&history=0');
    const { left, top, width, height } = await page.$eval('#canvas', e => e.getBoundingClientRect().toJSON());
    await page.waitForFunction('page.truth()?.rays >= 16', { timeout: 60000 });
    await page.mouse.move(left + 0.25 * width, top + 0.6 * height);
    await page.waitForFunction(`!document.getElementById('worst').hidden`, { timeout: 20000 });
    for (const [id, wanted] of [['error', /^RMSE 0\.\d{4}, \d+ % of no occlusion’s 0\.\d{4}$/],
                                ['here', /^here 0\.\d{3}, truth [01]\.\d{3} ± 0\.\d{3}$/],
                                ['worst', /^worst [−+]0\.\d\d$/], ['rays', /^\d+ rays (a|at every \S+) pixel/]]) {
        const told = await page.$eval(`#${id}`, e => e.textContent);
        check(wanted.test(told), `${id}: ${told}`);
    }
    await page.close();
});

/* ---- the C lines */

await run('the C lines compile, and make the chain that is drawn', async () => {
    const page = await open('size=96x54&history=0&scene=casters');
    const gcc = (...words) => execFileSync('gcc', [
        '-std=c99', '-Wall', '-Wextra', '-Wpedantic', '-Wconversion', '-Wshadow', '-Werror', '-I.', ...words],
                                           { stdio: ['ignore', 'ignore', 'pipe'] });
    writeFileSync(`${out}/ssgi.c`, `#define SSGI_IMPLEMENTATION
#define SSGI_GL_IMPLEMENTATION
#include "ssgi_gl.h"
`);
    gcc('-c', `${out}/ssgi.c`, '-o', `${out}/ssgi.o`);
    for (const hash of ['a=hsao', 'a=hsao&history=1&slices=3&samples=7&resolution=FULL&filter=2&thickness=SLABS',
                        'a=ssao&p=BEST', 'a=ssdo&bounce=1&history=1', 'a=march&filter=0&resolution=FULL',
                        'a=s3ho&history=1',
                        'a=points&thickness=BACK&normals=FROM_DEPTH', 'a=dss&levels=3', 'a=aof&p=FAST&reach=0.5',
                        'a=ssdo&shadow=FILL']) {
        await page.evaluate(h => page.go(h), `size=96x54&scene=casters&history=0&b=off&${hash}`);
        const { code, chain, list, given } = await page.evaluate(() => ({ code: page.code(0), ...page.chain(0) }));
        const bands = /coefficients\[(\d+)\]/.exec(code)?.[1];
        const others = [...code.matchAll(/^static \w+ \*?(make_(?!steps|frame)\w+)/gm)].map(([, name]) => name);
        writeFileSync(`${out}/lines.c`, `${code}
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
    const int n = make_steps(steps, ${chain.width}, ${chain.height}, &why);
    ${others.map(name => `(void)${name};`).join(' ')}
    for (int i = 0; i < n; ++i)
        printf("%s:%dx%d:%llu ", ssgi_gl_pass_name(steps[i].desc.pass), steps[i].width, steps[i].height,
               (unsigned long long)ssgi_gl_key(&steps[i].desc));
    if (ssgi_view_from_projection(&view, projection, SSGI_CLIP_GL, 160, 90, &why) != SSGI_OK
        || make_frame(&frame, &view, unit${chain.history ? ', NULL, unit, 0' : ''}${bands ? ', coefficients' : ''},
                      &why) != SSGI_OK) printf("%s", why);
    printf("%g %g\\n", (double)frame.radius, (double)frame.thickness_limit);
    return 0;
}
`);
        gcc(`${out}/lines.c`, `${out}/ssgi.o`, '-lm', '-o', `${out}/lines`);
        const told = execFileSync(`${out}/lines`, { encoding: 'utf8' }).trim().split(' ');
        const [radius, limit] = told.splice(-2).map(Number), near = (a, b) => Math.abs(a - b) < 1e-4 * b;
        check(told.join(' ') === list.join(' '), `${hash}: ${told.join(' ')}\n${list.join(' ')}`);
        check(near(radius, given[0]) && near(limit, given[1]), `${hash}: ${radius}, ${limit}: ${given}`);
    }
    await page.close();
});

/* ---- a narrow window, a small GPU ---- */

const without = names => `{ const { prototype } = WebGL2RenderingContext, all = prototype.getExtension;
    prototype.getExtension = function (name) { return ${names}.test(name) ? null : all.call(this, name); }; }`;
const asked = change => `{ const { postMessage } = Worker.prototype;
    Worker.prototype.postMessage = function (data, ...more) { return postMessage.call(this, ${change}, ...more); }; }`;
await quietly('what a device lacks and what fails is said, and the page goes on', async () => {
    for (const [hash, before, element, wanted] of [
        ['', 'HTMLCanvasElement.prototype.getContext = () => null;', 'notice', /no WebGL 2/],
        ['', without('/color_buffer/'), 'notice', /EXT_color_buffer_float/],
        ['size=64x36&scene=cornell&b=off', without('/timer/'), 'timer-note', /CPU/],
        ['size=64x36&scene=cornell&b=truth', asked('data.scene ? { scene: { position: [1], normal: [1] } } : data'),
         'notice', /^the truth: position: must have 9 numbers a triangle, has 1$/],
        ['size=64x36&b=off&scene=cornell&a=dss',
         asked('data.surfels ? { surfels: { ...data.surfels, size: 9 } } : data'), 'notice', /^surfels: .*size/]]) {
        const page = await open(hash, { before });
        const says = (id, wanted) => new RegExp(wanted).test(document.getElementById(id).textContent);
        await page.waitForFunction(says, { timeout: 20000 }, element, wanted.source).catch(() => 0);
        const told = await page.$eval(`#${element}`, e => e.textContent);
        await page.close();
        check(wanted.test(told), `${wanted}: ${told}`);
    }
});
await quietly('opened as a file it says in a line what to do', async () => {
    const page = await browser.newPage();
    hear(page, 'file');
    await page.goto(pathToFileURL(resolve('build/web/index.html')).href);
    await rest(500);
    const told = await page.evaluate(() => [document.getElementById('notice').textContent,
                                            document.getElementById('loading').hidden]);
    await page.close();
    check(told[0].includes('python3 -m http.server') && told[1], `${told}`);
});

await run('the console is silent, the folder small', async () => {
    const bytes = readdirSync('build/web', { recursive: true })
        .filter(name => !/^scenes|^three.(loaders|libs)|^webgpu|^wgsl/.test(name))
        .map(name => statSync(join('build/web', name))).filter(file => file.isFile())
        .reduce((sum, file) => sum + file.size, 0);
    note(`build/web without its scenes, what reads files and WebGPU: ${(bytes / 1e6).toFixed(2)} MB`);
    check(bytes <= 3e6, `${bytes} bytes`);
    check(!said.length, said.join('\n'));
});
await import('./webgpu-page.mjs');

/* The last test, because the browser goes on compiling after programs are linked. */
await run('every text of WebGL 2 compiles, vertex and fragment of every variant link', async () => {
    const page = await browser.newPage();
    await page.goto(`${root}/web-test/empty.html`);
    const { texts, programs, wrong } = await page.evaluate(async () => {
        const gl = document.createElement('canvas').getContext('webgl2');
        const shaders = new Map(), wrong = [], kinds = { vert: gl.VERTEX_SHADER, frag: gl.FRAGMENT_SHADER };
        gl.getExtension('KHR_parallel_shader_compile');
        const { variants } = await (await fetch('glsl/manifest.json')).json();
        const files = new Set(variants.flatMap(v => Object.values(v.files)));
        await Promise.all([...files].map(async file => {
            const shader = gl.createShader(kinds[file.split('.').pop()]);
            gl.shaderSource(shader, await (await fetch(`glsl/${file}`)).text());
            gl.compileShader(shader);
            shaders.set(file, shader);
        }));
        const programs = variants.map(({ files: { vert, frag } }) => {
            const program = gl.createProgram();
            for (const file of [vert, frag]) gl.attachShader(program, shaders.get(file));
            gl.linkProgram(program);
            return { program, vert, frag };
        });
        for (const [file, shader] of shaders)
            if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) || gl.getShaderInfoLog(shader).trim())
                wrong.push(`${file}: ${gl.getShaderInfoLog(shader)}`);
        for (const { program, vert, frag } of programs)
            if (!gl.getProgramParameter(program, gl.LINK_STATUS))
                wrong.push(`${vert} ${frag}: ${gl.getProgramInfoLog(program)}`);
        return { texts: shaders.size, programs: programs.length, wrong };
    });
    await page.close();
    note(`${texts} shaders compiled, ${programs} programs linked, ${wrong.length} with a complaint`);
    check(texts > 200 && programs > 200, `only ${texts} shaders, ${programs} programs`);
    check(!wrong.length, wrong.join('\n'));
});
await end();
