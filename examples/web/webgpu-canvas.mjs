/* webgpu-canvas.mjs - the page in WebGPU: a canvas above that of WebGL 2, which still gets the pointer's events. It is
   fetched if the user asks for WebGPU. */
import { fetchFile } from './fetch.mjs';
import { Drawer } from './webgpu-steps.mjs';
import { Scene } from './webgpu-scene.mjs';
import { Show } from './webgpu-show.mjs';

function fail(sentence) { throw new Error(`${sentence}: WebGL 2 draws`); }

async function deviceOf() {
    if (!navigator.gpu) fail('This browser has no WebGPU');
    const adapter = await navigator.gpu.requestAdapter({ powerPreference: 'high-performance' });
    if (!adapter) fail('WebGPU finds no graphics card here that it can use');
    const { maxTextureDimension2D, maxBufferSize } = adapter.limits;
    const device = await adapter.requestDevice({
        requiredFeatures: ['timestamp-query'].filter(feature => adapter.features.has(feature)),
        requiredLimits: { maxTextureDimension2D, maxBufferSize } }).catch(e => fail(e.message));
    return { device, info: adapter.info };
}

/* Opens WebGPU. canvas: of WebGL 2. gone: called with a sentence when the device is lost. Failures throw a sentence. */
export async function open(ssgi, canvas, gone) {
    const keys = await (await fetchFile('wgsl/list.json')).json();
    if (!keys.length) fail('This page was made without texts in WGSL');
    const { device, info } = await deviceOf(), over = document.createElement('canvas');
    const scene = new Scene(device);
    let closed = false;
    const give = why => {
        if (!closed) gone(`${why}: WebGL 2 draws`);
    };
    device.onuncapturederror = ({ error }) => give(`WebGPU: ${error.message.split('\n')[0]}`);
    device.lost.then(() => give('The device lost its WebGPU'));
    over.id = 'webgpu';
    over.hidden = true;                             /* until something is drawn */
    over.style.cssText = 'position: absolute; inset: 0; width: 100%; height: 100%; pointer-events: none';
    canvas.after(over);
    const show = new Show(device, over), drawer = new Drawer(device, ssgi, keys);
    await Promise.all([scene.link(), show.link()]);
    return {
        device, drawer, show, canvas: over, name: `WebGPU: ${[info.vendor, info.architecture, info.description]
            .filter(Boolean).join(' ')}`,
        draw: (stage, backs, { width, height }) => scene.draw(stage, backs, width, height),
        async pixels(...placed) {
            const texture = show.placed(...placed), all = await drawer.read(texture);
            texture.destroy();
            return Uint8Array.from(all, v => Math.round(255 * v));
        },
        close() {
            closed = true;
            over.remove();
            device.destroy();
        }
    };
}
