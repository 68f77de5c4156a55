/* webgpu-page.mjs - a part of make web-test: compares the page with ?webgpu and the page without, in one browser. */
import { readFileSync } from 'node:fs';
import { check, launch, note, rest, run, serve, withWebgpu } from './web-kit.mjs';

const browser = await launch(...withWebgpu), root = await serve('build');

const said = [];                                    /* errors, except ANGLE's on the test's own reading of pixels */
async function open(query, hash, before = null) {
    const page = await browser.newPage();
    page.on('console', m => {
        if (['error', 'warn', 'warning'].includes(m.type()) && !m.text().includes('GPU stall due to ReadPixels'))
            said.push(`${hash}: ${m.text()}`);
    });
    page.on('pageerror', e => said.push(`${hash}: ${e.message}`));
    await page.setViewport({ width: 900, height: 600 });
    if (before) await page.evaluateOnNewDocument(before);
    await page.goto(`${root}/web/${query}#${hash}`, { waitUntil: 'domcontentloaded' });
    await page.waitForFunction('globalThis.page && page.first', { timeout: 60000 });
    return page;
}
const state = page => page.evaluate(() => ({
    notice: document.getElementById('notice').hidden ? '' : document.getElementById('notice').textContent,
    draws: !!page.inside().gpu, search: location.search, box: document.getElementById('webgpu-box').checked }));

/* Returns the differences of both sides' results and of the picture for an address. Light is divided by its mean. Its
   alpha is not compared, as it is the filter's own, and neither are pixels without a surface. */
const compare = (page, hash) => page.evaluate(async hash => {
    const draw = async gpu => {
        if (!!page.inside().gpu !== gpu) await page.webgpu(gpu);
        if (!!page.inside().gpu !== gpu) throw new Error(document.getElementById('notice').textContent);
        if (hash !== null) await page.go(hash);
        do await new Promise(requestAnimationFrame); while (!page.smooth() || (page.set.history && !page.settled()));
        const sides = [0, 1].map(i => (['none', 'off'].includes(page.set[i ? 'b' : 'a']) ? null : page.result(i)));
        return [...(await Promise.all(sides)).map(side => side?.pixels ?? null), await page.picture()];
    };
    const is = await draw(true), wanted = await draw(false);
    return is.map((of, i) => {
        if (!of) return 0;
        let sum = 0, n = 0, level = 0;
        const light = of.length === 4 * page.inside().size.width * page.inside().size.height;
        of.forEach((value, k) => {
            if (light && k % 4 === 3) return;
            if (!Number.isFinite(wanted[i][k]) && !Number.isFinite(value)) return;
            sum += (value - wanted[i][k]) ** 2;
            level += wanted[i][k];
            ++n;
        });
        return Math.sqrt(sum / n) / (i === 2 ? 255 : light ? level / n : 1);
    });
}, hash);

const first = await open('?webgpu', 'size=96x54&scene=cornell&history=0&b=off');
if ((await state(first)).notice) console.log(`skipped: the page in WebGPU: ${(await state(first)).notice}`);
else {
    /* Mostly pixels on silhouettes, which one rasteriser covers and the other does not. */
    const most = 0.008, small = 'sky=sky&size=192x108&history=0';
    const alike = async hash => {
        const differs = await compare(first, hash), { notice } = await state(first);
        note(`${hash ?? 'the same'}: RMSE ${differs.map(v => v.toExponential(1)).join(' ')}`);
        check(differs.every(v => v < most) && !notice, `${hash}: ${differs} ${notice}`);
    };
    for (const of of ['p=FAST&b=hsao&q=BEST', 'a=ssao&b=march', 'a=points&b=ssdo&bounce=1&view=ambient',
                      'a=ssdo&shadow=FILL&b=s3ho', 'a=ssdo&shadow=SEGMENT&bounce=1', 'history=1&b=s3ho',
                      'thickness=SLABS&b=ssdo', 'thickness=BACK&scene=casters',
                      'normals=FROM_DEPTH&slices=3&samples=4&resolution=HALF&filter=3&size=320x180'])
        await run(`WebGPU draws what WebGL 2 does: ${of || 'hsao'}`, () => alike(`${small}&${of}`));

    await run('WebGPU: what moves is followed, the truth is traced, a change of size is drawn', async () => {
        await first.evaluate('page.webgpu(true)');
        await first.evaluate(`page.go('size=160x90&moves=1&scene=cornell')`);
        await rest(700);
        await first.evaluate(`page.go('${small.replace('192x108', '96x54')}&b=truth&scene=cornell')`);
        await first.waitForFunction('page.rays() >= 4 && page.error(0) !== null', { timeout: 60000 });
        const error = await first.evaluate('page.error(0)');
        check(error > 0 && error < 0.2, `error ${error}`);
        await first.evaluate(`page.go('history=0&scene=cornell&a=ssao&b=off')`);
        for (const width of [700, 500]) {
            await first.setViewport({ width, height: 600 });
            await first.waitForFunction(`(() => { const { gpu, size } = page.inside();
                const box = document.getElementById('picture').getBoundingClientRect();
                return gpu.canvas.width === size.width && Math.abs(size.width / size.height - box.width / box.height)
                    < 0.02; })()`, { timeout: 20000 });
        }
        await alike(null);
    });

    await run('WebGPU: a device that is lost leaves the page to WebGL 2', async () => {
        await first.evaluate(`page.go('${small}')`);
        await first.evaluate('page.webgpu(true)');
        const is = await state(first);
        check(is.search === '?webgpu' && is.box, JSON.stringify(is));
        await first.evaluate('page.inside().gpu.device.destroy()');
        await first.waitForFunction('!page.inside().gpu && page.smooth()', { timeout: 20000 });
        const { notice, search, box } = await state(first);
        check(notice === 'The device lost its WebGPU: WebGL 2 draws' && !search && !box, `${notice} ${search} ${box}`);
        check(await first.evaluate('page.picture().some((v, i) => i % 4 < 3 && v > 100)'), 'nothing is drawn');
    });

    await run('WebGPU: its files come when it is asked for, and are small', async () => {
        const page = await open('', `${small}&scene=cornell`);
        const files = () => page.evaluate(() => performance.getEntriesByType('resource')
            .map(r => r.name.split('/web/')[1]).filter(name => /^webgpu|^wgsl/.test(name)));
        check(!(await files()).length, `without ?webgpu: ${await files()}`);
        await page.evaluate('page.webgpu(true)');
        await page.waitForFunction('page.smooth()');
        const come = await files();
        const bytes = come.reduce((sum, name) => sum + readFileSync(`build/web/${name}`).length, 0);
        note(`${come.length} files, ${(bytes / 1000).toFixed(0)} KB: ${come.join(' ')}`);
        check(come.some(name => name.endsWith('.wgsl')) && bytes < 150e3, `${bytes} bytes`);
        await page.close();
    });
}

await run('without WebGPU, or without a text in WGSL, the page says so and goes on in WebGL 2', async () => {
    const blind = await open('?webgpu', 'size=64x36&scene=cornell&history=0',
                             `Object.defineProperty(navigator, 'gpu', {})`);
    const { notice, draws, search } = await state(blind);
    check(notice === 'This browser has no WebGPU: WebGL 2 draws' && !draws && !search, `${notice} ${search}`);
    const [off, reason] = await blind.$eval('#webgpu-box', box => [box.disabled, box.parentElement.title]);
    check(off && reason === 'This browser has no WebGPU', `${off} ${reason}`);
    await blind.close();
    const page = await open('', 'size=64x36&scene=cornell&history=0&a=none', `{ const all = globalThis.fetch;
        globalThis.fetch = async (url, ...more) => (String(url).endsWith('list.json') && String(url).includes('wgsl')
            ? new Response('["0"]') : all(url, ...more)); }`);
    await page.evaluate('page.webgpu(true)');
    if ((await state(page)).draws) {
        const [grey, why] = await page.$eval('[name=a] [value=hsao]', option => [option.disabled, option.title]);
        check(grey && why === 'HSAO has no text in WGSL here: draw it with WebGL 2', `${grey} ${why}`);
    } else note('skipped: no WebGPU');
    await page.close();
});

await run('WebGPU and WebGL 2: the console is silent', () => { check(!said.length, said.join('\n')); });
