/* demo.mjs - make demo-test: the page of make demo, opened in a wide window and on a phone. */
import { check, end, launch, note, run, serve } from './web-kit.mjs';

const browser = await launch(), root = await serve('report');
const chart = `ssgi_record({ name: 'chart', kind: 'full', command: 'make chart', entries: [
    { level: 2, heading: 'One' }, { level: 2, heading: 'Another' }, { paragraph: 'within' }] })`;

async function open(width, height, hash = '') {
    const page = await browser.newPage();
    await page.setViewport({ width, height });
    await page.setRequestInterception(true);
    page.on('request', r => r.url().endsWith('/chart.js') ? r.respond({ body: chart }) : r.continue());
    await page.goto(`${root}/${hash}`, { waitUntil: 'networkidle0' });
    return page;
}

await run("the page opens with README's pictures, each of its own shape and whole on the first screen", async () => {
    for (const [width, height] of [[1280, 720], [390, 844]]) {
        const page = await open(width, height);
        const seen = await page.$$eval('main > details:first-child[open] img', all => all.map(i => ({
            whole: i.complete && i.naturalWidth === +i.getAttribute('width')
                   && i.naturalHeight === +i.getAttribute('height'),
            below: i.getBoundingClientRect().bottom })));
        await page.close();
        check(seen.length === 3 && seen.every(i => i.whole), `${width}: ${JSON.stringify(seen)}`);
        check(width < 800 || seen.every(i => i.below <= height), `${width}: ${JSON.stringify(seen)}`);
    }
});

await run('beneath them a screen has a picture of each method beside its truth, and says when to take it', async () => {
    const page = await open(1280, 800);
    await page.click('main > details:first-child summary');
    const seen = await page.evaluate(() => {
        const below = selector => [...document.querySelectorAll(selector)].map(e => e.getBoundingClientRect().bottom);
        return { pictures: below('.methods img'), table: below('.when tr'), height: document.body.scrollHeight,
                 drawn: [...document.querySelectorAll('.methods img')].every(i => i.naturalWidth) };
    });
    await page.close();
    note(`${seen.height} pixels high`);
    check(seen.drawn && seen.pictures.length === 10 && Math.max(...seen.pictures) <= 800, `${seen.pictures}`);
    check(seen.table.length === 6 && Math.max(...seen.table) <= 800, `${seen.table}`);
    check(seen.height <= 6000, `${seen.height} pixels`);
});

const section = (page, id) => page.evaluate(id => {
    const of = document.getElementById(id);
    return of && { open: of.open, top: of.getBoundingClientRect().top, holds: of.querySelector('img, td, p') !== null };
}, id);
const opened = s => s?.open && s.holds && s.top >= 0 && s.top < 800;

await run('a link of the contents opens its section, as an address does; folded text can be found', async () => {
    const page = await open(1280, 800), links = await page.$$('.contents a');
    check(links.length >= 5, `${links.length} links`);
    for (const link of links) {
        const id = await link.evaluate(a => a.hash.slice(1)), before = await section(page, id);
        check(before?.holds, `${id}: holds nothing before it is opened`);
        await page.evaluate(id => { document.getElementById(id).open = false; }, id);
        await link.click();
        const after = await section(page, id);
        check(opened(after), `${id}: ${JSON.stringify(after)}`);
    }
    const id = await links.at(-1).evaluate(a => a.hash.slice(1)), straight = await open(1280, 800, `#${id}`);
    const after = await section(straight, id);
    check(opened(after), `#${id}: ${JSON.stringify(after)}`);
    await straight.close();
    await page.close();
});

await run('other pages are reached from it and lead back; one that is not there names its command', async () => {
    const page = await open(1280, 800);
    const text = await page.$eval('main', e => e.innerText);
    for (const name of ['seeds', 'stability', 'papers'])
        check(await page.$(`nav a[href='#${name}']`) || text.includes(`make ${name}`), name);
    const there = of => page.waitForSelector(of, { timeout: 5000 });        /* the page follows the address later */
    const click = of => page.locator(of).setTimeout(5000).click();          /* clicks once the element stands still */
    await click("nav a[href='#chart']");
    await click("a[href='#chart/another']");
    await there('#chart\\/another[open]').catch(() => 0);
    const after = await section(page, 'chart/another');
    check(opened(after), JSON.stringify(after));
    await click("nav a[href='#demo']");
    check(await there('.methods').catch(() => false), 'no way back');
    await page.close();
});

await run('on a phone (390 x 844) nothing runs out of the page, folded or open', async () => {
    const page = await open(390, 844);
    const wide = await page.evaluate(() => [false, true].map(open => {
        if (open) for (const d of document.querySelectorAll('details')) d.open = true;
        return document.documentElement.scrollWidth;
    }));
    await page.close();
    check(Math.max(...wide) <= 390, `${wide}`);
});

await end();
