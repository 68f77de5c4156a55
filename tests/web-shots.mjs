/* web-shots.mjs - make web-shots: pictures of the page for examples/docs/pictures/page, and the same view as others
   draw it. node tests/web-shots.mjs [WORD]: those whose name has it. */
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { launch, rest, serve } from './web-kit.mjs';

const folder = 'examples/docs/pictures/page', only = process.argv[2] ?? '';
const browser = await launch('--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist',
                             '--hide-scrollbars');
const root = await serve('build');
mkdirSync(folder, { recursive: true });

/* Milliseconds of a CPU say nothing about the page on a GPU. */
const unclocked = `#rate, #cost, #clock,
    #status:not(:has(:is(#error, #rays, #here):not(:empty), #legend:not([hidden]))) { display: none !important }`;

async function open(hash, width, height) {
    const page = await browser.newPage();
    await page.setViewport({ width, height, isMobile: width < 600, hasTouch: width < 600 });
    await page.goto(`${root}/web/#${hash}`, { waitUntil: 'domcontentloaded' });
    await page.waitForFunction('globalThis.page && page.first', { timeout: 60000 });
    await page.addStyleTag({ content: unclocked });
    await page.waitForFunction(`!page.making() && document.getElementById('loading').hidden
                                && (page.smooth() || !page.resting())`, { timeout: 180000, polling: 250 });
    return page;
}
async function shoot(page, name, quality = 82) {
    await page.screenshot({ path: `${folder}/${name}.jpg`, type: 'jpeg', quality });
    console.log(`${folder}/${name}.jpg: ${(readFileSync(`${folder}/${name}.jpg`).length / 1000).toFixed(0)} KB`);
}

const wide = [1280, 800], phone = [390, 844];
for (const [name, hash, [width, height], then] of [
    ['first', 'sun=0&split=0.58&cam=3.5,1.5,3.4,1.75,0.8,0.5&size=1280x800', wide,      /* shelves on both sides */
     `document.getElementById('hide').click() || true`],
    ['ssdo', 'a=ssdo&b=none&bounce=1&shadow=FILL&scene=colonnade&history=0&size=720x605', wide],
    ['s3ho', 'a=s3ho&b=none&sky=windows&sun=0&view=ambient&history=0&size=720x605', wide],
    ['dss', 'a=dss&b=hsao&view=ambient&scene=slats&history=0', wide],
    ['aof', 'a=aof&b=none&scene=casters&p=FAST', wide],
    ['bounce', 'scene=cornell&a=ssdo&b=none', wide],
    ['colonnade', 'scene=colonnade&a=ssdo&b=none', wide],
    ['moves', 'scene=grass&moves=1&a=hsao&b=off', wide],
    ['error', 'a=hsao&b=ssao&view=difference', wide, 'page.rays() >= 8'],
    ['truth-soon', 'a=hsao&b=truth&view=ambient', wide, 'page.truth()?.rays >= 16'],
    ['help', '', wide, `document.getElementById('help').click() || true`],
    ['phone', '', phone],
    ['phone-error', 'a=hsao&b=truth&view=difference', phone, 'page.truth()?.rays >= 16'],
    ['phone-panel', '', phone, 'scrollTo(0, 520) || true']]) {
    if (!name.includes(only)) continue;
    const page = await open(hash, width, height);
    if (then) await page.waitForFunction(then, { timeout: 180000, polling: 250 });
    if (then && !then.startsWith('page')) await rest(1000);
    await shoot(page, name);
    await page.close();
}

/* One view by four: the page at rest, without its texts, and the others; of a scene whose surfaces have no pictures of
   their own, which the others would lack. */
if ('beside'.includes(only) && existsSync('build/peers/beside.js')) {
    const [width, height] = [800, 500], page = await open(`scene=slats&b=off&size=${width}x${height}`, 1400, 900);
    const look = await page.evaluate(() => {
        const { stage, sky } = page.inside(), { camera, controls, sun, info } = stage, { shadow } = sun;
        return { file: `/web/scenes/${info.name}.bin`, radius: info.radius * 2 ** page.set.radius, sky: [...sky()],
                 camera: { position: camera.position.toArray(), target: controls.target.toArray(), fov: camera.fov,
                           near: camera.near, far: camera.far },
                 sun: { ...stage.sunlight, position: sun.position.toArray(), target: sun.target.position.toArray(),
                        half: shadow.camera.right, near: shadow.camera.near, far: shadow.camera.far,
                        normalBias: shadow.normalBias, bias: shadow.bias } };
    });
    const shots = [['ssgi: hsao, balanced, as the page rests', await page.evaluate(() => {
        const { size: { width, height } } = page.inside(), all = page.picture();
        const canvas = new OffscreenCanvas(width, height), image = new ImageData(width, height);
        for (let y = 0; y < height; ++y)
            image.data.set(all.subarray(4 * width * (height - 1 - y), 4 * width * (height - y)), 4 * width * y);
        canvas.getContext('2d').putImageData(image, 0, 0);
        return canvas.convertToBlob().then(blob => new Promise(done => {
            const reader = new FileReader();
            reader.onload = () => done(reader.result);
            reader.readAsDataURL(blob);
        }));
    })]];
    await page.close();
    for (const [name, title] of [['gtao', 'three.js: GTAOPass'], ['n8ao', 'n8ao'],
                                 ['babylon', 'Babylon.js: SSAO2']]) {
        const page = await browser.newPage();
        page.on('pageerror', e => console.log(`${name}: ${e.message}`));
        page.on('console', m => { if (m.type() === 'error') console.log(`${name}: ${m.text()}`); });
        await page.setViewport({ width, height });
        await page.goto(`${root}/peers/beside.html`);
        await page.waitForFunction('globalThis.draw');
        await page.evaluate((name, look) => draw(name, look), name, { ...look, width, height });
        await rest(300);
        shots.push([title, `data:image/png;base64,${await page.screenshot({ encoding: 'base64' })}`]);
        await page.close();
    }
    const sheet = await browser.newPage();
    await sheet.setViewport({ width: 2 * width, height: 2 * (height + 30) });
    await sheet.setContent(`<style>body { margin: 0; display: grid; grid-template-columns: 1fr 1fr; background: #111;
        color: #eee; font: 15px/30px sans-serif } div { padding-left: 8px } img { display: block; margin-left: -8px }
        </style>${shots.map(([title, src]) => `<div>${title}<img src="${src}"></div>`).join('')}`);
    await rest(300);
    await shoot(sheet, 'beside', 85);
}
await browser.close();
process.exit(0);
