/* webgpu-steps.mjs - the interface of webgl.mjs on WebGPU. The shaders in WGSL are translated by make web. */
import { fetchFile } from './fetch.mjs';
import { Passes } from './webgpu.mjs';
import { keyOf } from './webgpu-keys.mjs';
import { texelsOf } from './webgpu-texels.mjs';

const usage = { texture: 1 | 2 | 4 | 16, uniform: 64 | 8 };     /* sums of bits of GPUTextureUsage and GPUBufferUsage */

/* Returns the steps of Ssgi.steps with the textures that each reads and writes. */
function planOf(ssgi, steps) {
    const textures = [];
    for (const { outputs, width, height } of steps)
        for (const { texture, format: { webgpu }, layers, kept, result } of outputs)
            textures[texture] = { format: webgpu, size: [width, height], layers, kept, result };
    return { textures, steps: steps.map(step => ({
        desc: step.desc, rows: ssgi.rows(step.desc), blend: null, clear: step.clear ? step.clear_to : null,
        vertices: step.vertices, instances: step.instances,
        inputs: step.inputs.map(({ binding, array, integer, meaning, texture, last }) => ({
            binding, sample: integer ? 'uint' : 'unfilterable-float', dimension: array ? '2d-array' : '2d',
            yours: meaning, texture, last })),
        outputs: step.outputs.map(({ texture, layer, format: { webgpu } }) => ({ texture, layer, format: webgpu }))
    })) };
}

const given = ['DEPTH', 'NORMAL', 'ALBEDO', 'DIRECT', 'BACK', 'MOTION', 'ENVIRONMENT', 'IRRADIANCE', 'LIGHTS',
               'SHADOW'];

export class Drawer {
    #device; #ssgi; #keys; #texts = new Map(); #modules = new Map();
    dialect = 'VULKAN';
    language = 'WGSL';

    /* keys: those of the shaders that exist in WGSL */
    constructor(device, ssgi, keys) {
        this.#device = device;
        this.#ssgi = ssgi;
        this.#keys = new Set(keys);
        this.timer = device.features.has('timestamp-query');
        this.clock = this.timer ? 'Timed by timestamp-query, which browsers round to some 0.1 ms'
            : 'No timestamp-query here: passes are not timed.';
    }

    #key(desc, stage) { return keyOf(this.#ssgi.shader(desc, stage)); }

    /* Returns the shader of a pass that has been drawn. */
    shader(desc, stage = 'frag') { return this.#texts.get(this.#key(desc, stage)) ?? ''; }

    /* Returns why a chain cannot be drawn; null: it can. */
    lacks(chain) {
        for (const { desc, inputs, blend } of this.#ssgi.steps(chain)) {
            const strange = inputs.find(({ meaning }) => meaning && !given.includes(meaning));
            if (strange || blend[0]) return 'reads what the page’s WebGPU does not make';
            if (!['vert', 'frag'].every(stage => this.#keys.has(this.#key(desc, stage))))
                return 'has no text in WGSL here';
        }
        return null;
    }

    async module(desc, stage) {
        const key = this.#key(desc, stage);
        if (!this.#modules.has(key))
            this.#modules.set(key, fetchFile(`wgsl/${key}.wgsl`).then(answer => answer.text()).then(code => {
                this.#texts.set(key, code);
                return this.#device.createShaderModule({ code });
            }));
        return this.#modules.get(key);
    }

    texture(width, height, format, layers = 0) {
        return this.#device.createTexture({ format, size: [width, height, layers || 1], usage: usage.texture });
    }
    /* Uploads four floats a texel, the first row first, to the texture into, which has that size, or to a new one. */
    floats(rgba, width, height, layers = 0, into = this.texture(width, height, 'rgba32float', layers)) {
        this.#device.queue.writeTexture({ texture: into }, rgba, { bytesPerRow: 16 * width }, [width, height]);
        return into;
    }
    copy(texture, format, width, height) {
        const made = this.texture(width, height, format.webgpu), encoder = this.#device.createCommandEncoder();
        encoder.copyTextureToTexture({ texture }, { texture: made }, [width, height]);
        this.#device.queue.submit([encoder.finish()]);
        return made;
    }
    read(texture) { return texelsOf(this.#device, texture); }
    free(texture) { texture.destroy(); }

    run(chain) { return new Run(this.#device, this.#ssgi, this, chain); }
}

/* A chain with its targets, which have one size. */
class Run {
    #device; #passes; #block; #clock = null; #fresh = null; #wrong = null; #linked = false; #freed = false;
    format = null;
    ms = [];

    constructor(device, ssgi, drawer, chain) {
        this.#device = device;
        this.chain = chain;
        this.steps = ssgi.steps(chain);
        const wrong = drawer.lacks(chain);
        if (wrong) throw new Error(`${chain.desc.pass} ${wrong}`);
        this.#passes = new Passes(device, planOf(ssgi, this.steps), async ({ desc }) => {
            const [vert, frag] = await Promise.all(['vert', 'frag'].map(stage => drawer.module(desc, stage)));
            return { vert, frag };
        });
        this.#passes.ready.then(() => { this.#linked = true; }, error => { this.#wrong = error; });
        this.format = this.steps.flatMap(step => step.outputs).find(({ result }) => result === 'LIGHT')?.format ?? null;
    }

    get light() { return this.#passes.result('LIGHT') ?? null; }
    get bounce() { return this.#passes.result('BOUNCE') ?? null; }

    get linked() {
        if (this.#wrong) throw this.#wrong;
        return this.#linked;
    }

    draw(yours, frame, clock = 0) {
        const device = this.#device, encoder = device.createCommandEncoder();
        this.#block ??= device.createBuffer({ size: frame.buffer.byteLength, usage: usage.uniform });
        device.queue.writeBuffer(this.#block, 0, frame.buffer);
        const timed = clock === 1 && device.features.has('timestamp-query') && !this.waiting;
        if (timed) this.#clock ??= this.#queries();
        const { set, resolved, mapped } = (timed && this.#clock) || {};
        this.#passes.draw(encoder, {
            block: () => this.#block,
            yours: (number, { yours: meaning }) => meaning && yours[meaning],
            stamps: timed ? number => ({ querySet: set, beginningOfPassWriteIndex: 2 * number,
                                         endOfPassWriteIndex: 2 * number + 1 }) : null
        });
        if (timed) {
            encoder.resolveQuerySet(set, 0, set.count, resolved, 0);
            encoder.copyBufferToBuffer(resolved, 0, mapped, 0, 8 * set.count);
        }
        device.queue.submit([encoder.finish()]);
        if (timed) this.#read(mapped);
    }
    #queries() {
        const device = this.#device, count = 2 * this.steps.length;
        return { set: device.createQuerySet({ type: 'timestamp', count }),
                 resolved: device.createBuffer({ size: 8 * count, usage: 0x200 | 4 }),  /* QUERY_RESOLVE, COPY_SRC */
                 mapped: device.createBuffer({ size: 8 * count, usage: 1 | 8 }) };      /* MAP_READ, COPY_DST */
    }
    async #read(mapped) {
        this.waiting = true;
        try {
            await mapped.mapAsync(1);
            const times = new BigInt64Array(mapped.getMappedRange());
            this.#fresh = this.steps.map((_, i) => Math.max(0, Number(times[2 * i + 1] - times[2 * i]) / 1e6));
            mapped.unmap();
        } catch { /* freed or lost meanwhile */ }
        this.waiting = false;
    }
    waiting = false;

    /* true: ms is new. */
    poll() {
        if (!this.#fresh) return false;
        [this.ms, this.#fresh] = [this.#fresh, null];
        return true;
    }

    turn() { this.#passes.turn(); }

    free() {
        if (this.#freed) return;
        this.#freed = true;
        this.#passes.free();
        this.#block?.destroy();
        if (this.#clock) for (const part of Object.values(this.#clock)) part.destroy();
    }
}
