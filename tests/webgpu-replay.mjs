/* webgpu-replay.mjs - in a page: what build/capture wrote (tests/capture.c tells its format), drawn by WebGPU by the
   data of manifest.json and capture.json alone. */
import { Passes, planOf } from './webgpu.mjs';
import { texelsOf } from './webgpu-texels.mjs';

/* WGSL asks sines to be right to 2^-11, and Dawn's software adapter gives no more, by which some taps fall on other
   pixels than in GL. Texts get sines that are right to the last bits. */
const sines = `
    fn exact_sin(x: f32) -> f32 {
        let turns = round(x * 0.31830989);
        let r = (x - turns * 3.140625) - turns * 0.00096765358979;
        let s = r * r;
        let high = -0.00019841270 + s * (2.7557319e-6 - s * 2.5052108e-8);
        let y = r + r * s * (-0.16666667 + s * (0.0083333333 + s * high));
        return select(y, -y, (i32(turns) & 1) == 1);
    }
    fn exact_cos(x: f32) -> f32 { return exact_sin(x + 1.57079633); }`;
const exact = code => /\b(sin|cos)\(/.test(code) ? code.replace(/\b(sin|cos)\(/g, 'exact_$1(') + sines : code;

/* texts: of another capture, whose constants differ. Returns, of each frame's results, the root of the mean square of
   differences to what capture.json says it is. */
export async function replay(device, folder, texts = folder) {
    const get = async path => {
        const file = await fetch(path);
        if (!file.ok) throw new Error(`${path}: ${file.status}`);
        return file;
    };
    const json = async name => (await get(`${folder}/${name}.json`)).json();
    const [manifest, capture] = [await json('manifest'), await json('capture')], [chain] = manifest.chains;
    const pieces = new Map(), yours = new Map(), blocks = new Map();
    const bytes = async number => {
        if (!pieces.has(number)) pieces.set(number, await (await get(`${folder}/${number}.bin`)).arrayBuffer());
        return pieces.get(number);
    };
    const bufferOf = async (number, usage) => {
        const data = await bytes(number);
        if (!blocks.has(number)) blocks.set(number, device.createBuffer({ size: data.byteLength, usage: usage | 8 }));
        device.queue.writeBuffer(blocks.get(number), 0, data);
        return blocks.get(number);
    };
    const yourTexture = async number => {
        const { data, webgpu, bytes: each, width, height, layers } = capture.textures[number];
        if (!yours.has(number)) {
            const size = [width, height, layers || 1];
            yours.set(number, device.createTexture({ size, format: webgpu, usage: 4 | 2 }));
            device.queue.writeTexture({ texture: yours.get(number) }, await bytes(data),
                                      { bytesPerRow: each * width, rowsPerImage: height }, size);
        }
        return yours.get(number);
    };
    const shader = async name =>
        device.createShaderModule({ code: exact(await (await get(`${texts}/${name}.wgsl`)).text()) });
    const sizes = chain.textures.map((_, number) => {
        const by = chain.steps.findIndex(({ outputs }) => outputs.some(o => o.texture === number));
        const { width, height } = capture.frames[0].steps[by];
        return [width, height];
    });
    const passes = new Passes(device, planOf(manifest, chain, sizes), async ({ files }) => (
        { vert: await shader(files.vert), frag: await shader(files.frag) }), capture.frames[0].surfels?.stride);
    await passes.ready;
    const found = [];
    for (const frame of capture.frames) {
        const surfels = frame.surfels && await bufferOf(frame.surfels.data, 32);
        for (const { yours: numbers } of frame.steps) for (const k of numbers) if (k >= 0) await yourTexture(k);
        for (let time = 0; time < frame.draws; ++time) {
            const encoder = device.createCommandEncoder(), of = [];
            for (const { frame: block } of frame.steps) of.push(await bufferOf(block, 64));
            passes.draw(encoder, {
                block: number => of[number], instances: number => frame.steps[number].instances, surfels,
                yours: (number, input) => yours.get(frame.steps[number].yours[chain.steps[number].inputs
                    .findIndex(({ binding }) => binding === input.binding)])
            });
            device.queue.submit([encoder.finish()]);
        }
        for (const { texture, is } of frame.results) {
            const { data, bytes: each, width, height } = capture.textures[is];
            const got = await texelsOf(device, passes.textures[texture][0]);
            const wanted = new Float32Array(await bytes(data));
            const all = each / 4, channels = all < 3 ? 1 : 3;       /* light; or visibility, with depth behind it */
            let sum = 0;
            for (let i = 0; i < width * height; ++i)
                for (let c = 0; c < channels; ++c) sum += (got[4 * i + c] - wanted[all * i + c]) ** 2;
            found.push(Math.sqrt(sum / (width * height * channels)));
        }
        passes.turn();
    }
    passes.free();
    for (const texture of yours.values()) texture.destroy();
    return found;
}
