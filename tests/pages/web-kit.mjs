/* web-kit.mjs - shared by tests in a browser: a line for each test, a server of a folder, Chromium without a window.
   Parts that the machine lacks are named as skipped. make web-deps puts puppeteer-core into build/web-deps. */
import { existsSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, resolve } from 'node:path';

let passed = 0, failed = 0;
const notes = [], closing = [], only = process.argv[2] ?? '';

export function check(ok, what) { if (!ok) throw new Error(what); }

export function note(text) { notes.push(text); }

/* Runs a test, unless the command line has a word that its sentence lacks. */
export async function run(sentence, test) {
    if (!sentence.includes(only)) return;
    const begun = performance.now();
    try { await test(); ++passed; console.log(`ok      ${sentence}`); }
    catch (e) {
        ++failed;
        const lines = String(e.message).split('\n').slice(0, 12).map(line => line.slice(0, 500));
        console.log([`FAILED  ${sentence}`, ...lines].join('\n        '));
    }
    const took = (performance.now() - begun) / 1000;
    if (took >= 1) notes.push(`${took.toFixed(1)} s`);
    for (const text of notes.splice(0)) console.log(`        ${text}`);
}

export async function end() {
    for (const close of closing) await close();
    console.log(`${passed} passed, ${failed} failed`);
    process.exit(failed ? 1 : 0);
}

export async function skip(what) {
    console.log(`skipped: ${what}`);
    await end();
}

export const rest = ms => new Promise(done => setTimeout(done, ms));

const types = { __proto__: null, '.html': 'text/html', '.mjs': 'text/javascript', '.js': 'text/javascript',
                '.css': 'text/css', '.json': 'application/json', '.wasm': 'application/wasm' };

/* Serves a folder; returns its address. */
export async function serve(folder) {
    const server = createServer((request, answer) => {
        try {
            const path = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
            const file = readFileSync(join(folder, path.endsWith('/') ? `${path}index.html` : path));
            const type = path.endsWith('/') ? 'text/html' : types[extname(path)] ?? 'application/octet-stream';
            answer.writeHead(200, { 'content-type': type });
            answer.end(file);
        } catch { answer.writeHead(404).end(); }
    });
    await new Promise(done => server.listen(0, '127.0.0.1', done));
    closing.push(() => server.close());
    return `http://127.0.0.1:${server.address().port}`;
}

/* The browser's arguments for WebGL 2, and with WebGPU beside it, without a GPU. */
export const software = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist',
                         '--hide-scrollbars'];
export const withWebgpu = [...software, '--enable-unsafe-webgpu', '--use-webgpu-adapter=swiftshader',
                                '--enable-features=Vulkan', '--use-vulkan=swiftshader'];

export async function launch(...args) {
    const chromium = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(existsSync);
    if (!chromium) await skip('everything: no browser (apt-get install chromium)');
    const puppeteer =
        await import(resolve('build/web-deps/node_modules/puppeteer-core/lib/esm/puppeteer/puppeteer-core.js'))
        .then(m => m.default, () => null);
    if (!puppeteer) await skip('everything: no puppeteer-core (npm could not install it)');
    const browser = await puppeteer
        .launch({ executablePath: chromium, headless: true, protocolTimeout: 300000, args: ['--no-sandbox', ...args] })
        .catch(e => skip(`everything: the browser does not start: ${e.message.split('\n')[0]}`));
    closing.unshift(() => browser.close());
    return browser;
}
