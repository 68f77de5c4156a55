/* web-shots.mjs - make web-shots: pictures of the page for examples/docs/pictures/page.
   node tests/pages/web-shots.mjs [WORD]: only those whose name has the word. */
import { mkdirSync, readFileSync } from 'node:fs';
import { launch, rest, serve, software } from './web-kit.mjs';

const folder = 'examples/docs/pictures/page', only = process.argv[2] ?? '';
const browser = await launch(...software);
const root = await serve('build');
mkdirSync(folder, { recursive: true });

/* A CPU's milliseconds say nothing about the page on a GPU, so they are hidden. */
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
    const path = `${folder}/${name}.jpg`;
    await page.screenshot({ path, type: 'jpeg', quality: 82 });
    console.log(`${path}: ${(readFileSync(path).length / 1000).toFixed(0)} KB`);
    await page.close();
}
await browser.close();
process.exit(0);
