/* webgpu-show.mjs - the page's last draws in WebGPU, as show.mjs does them in WebGL 2, by the same shaders, translated
   by make web. Row 0 is the bottom one, until the image is drawn onto the canvas. */
import { fetchFile } from './fetch.mjs';
import { pictureNumbers, textOf, texts } from './show-texts.mjs';
import { keyOf } from './webgpu-keys.mjs';
import { drawTriangle } from './webgpu-triangle.mjs';

export class Show {
    #device; #context; #canvas; #texts = {}; #nothing; #linear; #blocks = {}; #sides = []; #means = []; #moved = [];

    constructor(device, canvas) {
        this.#device = device;
        this.#canvas = canvas;
        this.#context = canvas.getContext('webgpu');
        this.#context.configure({ device, format: navigator.gpu.getPreferredCanvasFormat(), alphaMode: 'opaque' });
        this.#nothing = device.createTexture({ size: [1, 1], format: 'rgba8unorm', usage: 4 });
        this.#linear = device.createSampler({ minFilter: 'linear', magFilter: 'linear' });
    }

    /* Its texts; a promise. */
    async link() {
        await Promise.all(['picture', 'smooth', 'motion'].map(async name => {
            this.#texts[name] = await (await fetchFile(`wgsl/${keyOf(textOf(name, 'VULKAN'))}.wgsl`)).text();
        }));
    }

    /* Draws a shader's triangle into a texture, as #draw of show.mjs does. held: the key of its uniform buffer */
    #draw(name, into, numbers, textures, mean = 0, held = name) {
        const device = this.#device, data = new Float32Array(Math.ceil(numbers.length / 4) * 4);
        data.set(numbers);
        this.#blocks[held] ??= device.createBuffer({ size: data.byteLength, usage: 64 | 8 });
        device.queue.writeBuffer(this.#blocks[held], 0, data);
        const views = textures.map(texture => (texture ?? this.#nothing).createView());
        const encoder = device.createCommandEncoder();
        drawTriangle(device, encoder, this.#texts[name], { view: into.createView(), format: into.format },
                     [{ buffer: this.#blocks[held] }, ...views, ...(name === 'smooth' ? [this.#linear] : [])], mean);
        device.queue.submit([encoder.finish()]);
    }

    #fit(list, width, height, format, count = 2) {
        if (list[0]?.width === width && list[0].height === height) return list;
        for (let i = 0; i < count; ++i) {
            list[i]?.destroy();
            list[i] = this.#device.createTexture({ size: [width, height], format, usage: 1 | 4 | 16 });
        }
        return list;
    }

    /* Draws both sides as Show.draw of show.mjs does. */
    draw(width, height, bound, sides, look, sample) {
        const targets = sample ? this.#fit(this.#means, width, height, 'rgba16float')
            : this.#fit(this.#sides, width, height, 'rgba8unorm');
        sides.forEach((side, i) => {
            if (!side) return;
            this.#draw('picture', targets[i], pictureNumbers(look, side, !!bound.t_truth),
                       texts.picture.textures.map(name => bound[name] ?? side[name]), sample, `picture ${i}`);
        });
        this.place(width, height, look.split, look.view === 2 || sample > 0, sample);
    }

    place(width, height, split, plain, sample) {
        const canvas = this.#canvas;
        canvas.hidden = false;
        if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
        this.#put(this.#context.getCurrentTexture(), width, height, split, plain, sample, 1);
    }
    #put(into, width, height, split, plain, sample, upright) {
        this.#draw('smooth', into, [width, height, split, +plain, upright], sample ? this.#means : this.#sides, 0,
                   `place ${upright}`);
    }

    /* Returns the canvas's pixels, bottom row first. */
    placed(width, height, split, plain, sample) {
        const texture = this.#device.createTexture({ size: [width, height], format: 'rgba8unorm', usage: 1 | 4 | 16 });
        this.#put(texture, width, height, split, plain, sample, 0);
        return texture;
    }

    motion(width, height, { DEPTH, ALBEDO }, { back, last, moved }) {
        const [target] = this.#fit(this.#moved, width, height, 'rg16float', 1);
        this.#draw('motion', target, [...back, ...last, ...moved, width, height], [DEPTH, ALBEDO]);
        return target;
    }
}
