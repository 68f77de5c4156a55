/* web.mjs - make web-test: the texts of WebGL 2 and the page of make web in a browser without a window.
   node tests/web.mjs, from the repository's root after make web; puppeteer-core lies in build/web-deps. */
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, statSync, readdirSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, resolve } from 'node:path';

let passed = 0, failed = 0;
const notes = [];
function check(ok, what) { if (!ok) throw new Error(what); }
function note(text) { notes.push(text); }
async function run(sentence, test) {
    const begun = performance.now();
    try { await test(); ++passed; console.log(`ok      ${sentence}`); }
    catch (e) {
        ++failed;
        console.log([`FAILED  ${sentence}`, ...String(e.message).split('\n').slice(0, 12)].join('\n        '));
    }
    const took = (performance.now() - begun) / 1000;
    if (took >= 1) notes.push(`${took.toFixed(1)} s`);
    for (const text of notes.splice(0)) console.log(`        ${text}`);
}
function end() {
    console.log(`${passed} passed, ${failed} failed`);
    process.exit(failed ? 1 : 0);
}
function skip(what) {
    console.log(`skipped: ${what}`);
    end();
}

const chromium = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(existsSync);
if (!chromium) skip('everything: no browser (apt-get install chromium)');
const puppeteer =
    await import(resolve('build/web-deps/node_modules/puppeteer-core/lib/esm/puppeteer/puppeteer-core.js'))
    .then(m => m.default, () => null);
if (!puppeteer) skip('everything: no puppeteer-core (npm could not install it)');

/* ---- a server of build/, a browser */

const types = { '.html': 'text/html', '.mjs': 'text/javascript', '.js': 'text/javascript', '.css': 'text/css',
                '.json': 'application/json', '.wasm': 'application/wasm' };
const server = createServer((request, answer) => {
    const path = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
    try {
        const file = readFileSync(join('build', path.endsWith('/') ? `${path}index.html` : path));
        const type = path.endsWith('/') ? 'text/html' : types[extname(path)] ?? 'application/octet-stream';
        answer.writeHead(200, { 'content-type': type });
        answer.end(file);
    } catch { answer.writeHead(404).end(); }
});
await new Promise(done => server.listen(0, '127.0.0.1', done));
const root = `http://127.0.0.1:${server.address().port}`;
const browser = await puppeteer.launch({
    executablePath: chromium, headless: true, protocolTimeout: 300000,
    args: ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--no-sandbox', '--ignore-gpu-blocklist',
           '--hide-scrollbars']
}).catch(e => { skip(`everything: the browser does not start: ${e.message.split('\n')[0]}`); });

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
const rest = ms => new Promise(done => setTimeout(done, ms));
const render = (...words) =>
    execFileSync('build/render', words, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });

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
/* Both read one G-buffer, which the page drew. */
await run('the same of one G-buffer, that of the page: room', async () => {
    await go('scene=room&b=off&size=480x270');
    const [bytes, fovy, radius] = await page.evaluate(() => {
        const [file, fovy, radius] = page.frame();
        let text = '';
        for (let i = 0; i < file.length; i += 32768) text += String.fromCharCode(...file.subarray(i, i + 32768));
        return [btoa(text), fovy, radius];
    });
    writeFileSync(`${out}/frame.exr`, Buffer.from(bytes, 'base64'));
    const found = [];
    for (const [hash, words] of [['a=hsao', ['hsao']], ['a=hsao&p=FAST', ['hsao-fast']],
                                 ['a=hsao&p=BEST', ['hsao-best']],
                                 ['a=ssao', ['ssao']], ['a=march', ['hsao-march']],
                                 ['a=hsao&normals=FROM_DEPTH', ['hsao', '--set', 'normal=depth']]]) {
        render('--gbuffer', `${out}/frame.exr`, '--fovy', String(fovy), '--radius', String(radius),
               '--method', ...words,
               '--out', `${out}/ao.png`);
        await go(`scene=room&b=off&size=480x270&${hash}`);
        const { rmse } = await against(`${out}/ao.png`);
        found.push(`${words.join(' ')} ${rmse.toFixed(4)}`);
        check(rmse <= 0.006, found.join(', '));
    }
    note(`RMSE ${found.join(', ')}`);
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
    const wedge = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n';
    writeFileSync(`${out}/wedge.obj`, wedge);
    await go('size=320x180&b=off');
    await (await page.$('#file')).uploadFile(`${out}/wedge.obj`);
    await page.waitForFunction(`document.querySelector('[name=scene]').value === 'file'`, { timeout: 20000 });
    await rest(500);
    const least = await page.evaluate(() => page.result(0).pixels.reduce((a, b) => Math.min(a, b), 1));
    check(least < 0.9, `nothing is occluded: ${least}`);
});
await page.close();

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
await browser.close();
server.close();
end();
