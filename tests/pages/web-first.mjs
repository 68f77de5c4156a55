/* web-first.mjs - make web-first: the time of the page's first picture in a browser without a window, with a new
   profile each time: node tests/pages/web-first.mjs COUNT FOLDER.. Folders take turns, so that other load
   on the machine affects all. Prints a line for each: median, least and most. */
import { launch, serve, software } from './web-kit.mjs';

const [count = 5, ...folders] = process.argv.slice(2), middle = all => all.toSorted((a, b) => a - b)[all.length >> 1];
const pages = await Promise.all((folders.length ? folders : ['build/web']).map(async folder => (
    { folder, root: await serve(folder), first: [], steps: new Map() })));

for (let i = 0; i < +count; ++i)
    for (const of of pages) {
        const browser = await launch(...software), page = await browser.newPage();
        await page.setViewport({ width: 1280, height: 800 });
        await page.goto(`${of.root}/#size=960x540`, { waitUntil: 'domcontentloaded' });
        await page.waitForFunction(`globalThis.page && page.first && (performance.getEntriesByName('in its size').length
                                    || performance.now() > page.first + 2000)`, { timeout: 60000 });
        const { first, marks } = await page.evaluate(() => ({ first: page.first,
            marks: performance.getEntriesByType('mark').map(({ name, startTime }) => [name, startTime]) }));
        of.first.push(first / 1000);
        for (const [name, at] of marks) of.steps.set(name, [...of.steps.get(name) ?? [], at / 1000]);
        await browser.close();
    }
for (const { folder, first, steps } of pages) {
    console.log(`${folder}: first picture ${middle(first).toFixed(2)} s (${Math.min(...first).toFixed(2)} to ${
        Math.max(...first).toFixed(2)}, ${first.length} times)`);
    for (const [name, all] of steps) console.log(`    ${name} ${middle(all).toFixed(2)} s`);
}
process.exit(0);
