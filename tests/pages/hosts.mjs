/* hosts.mjs - pictures of pages of examples/hosts in Chromium without a window, after their size has changed. Prints
   the errors of their consoles. For hosts.sh, from the repository's root.
      node tests/pages/hosts.mjs FOLDER PAGE PICTURE.png .. */
import { launch, serve, withWebgpu } from './web-kit.mjs';

const [folder, ...pairs] = process.argv.slice(2), root = await serve(folder);
const browser = await launch(...withWebgpu, '--force-color-profile=srgb');
const said = [];
for (let i = 0; i + 1 < pairs.length; i += 2) {
    const page = await browser.newPage(), [address, path] = pairs.slice(i, i + 2);
    page.on('console', m => {
        if (/GPU stall due to ReadPixels/.test(m.text())) return;      /* tests read many pixels */
        if (['error', 'warn', 'warning'].includes(m.type())) said.push(m.text());
    });
    page.on('pageerror', e => said.push(e.message));
    page.on('requestfailed', r => said.push(`${r.url()}: ${r.failure()?.errorText}`));
    const drawn = async more => {
        const frames = await page.evaluate('globalThis.drawn ?? 0');
        await page.waitForFunction(`globalThis.drawn >= ${frames + more}`, { timeout: 60000 })
            .catch(() => said.push(`${address}: no frame in a minute`));
    };
    await page.setViewport({ width: 800, height: 450 });
    await page.goto(`${root}/${address}`);
    await drawn(1);
    await page.setViewport({ width: 960, height: 540 });
    await drawn(4);                                 /* the first may be of the old size, or of an empty texture */
    await page.screenshot({ path });
    await page.close();
}
await browser.close();
if (said.length) console.log(said.join('\n'));
process.exit(said.length ? 1 : 0);
