/* webgpu-replay.mjs - in a page: what build/capture wrote (tests/capture.c tells its format), drawn by WebGPU by the
   data of manifest.json and capture.json alone. */
const usage = { texture: 4 | 2 | 16 };          /* TEXTURE_BINDING, COPY_DST, RENDER_ATTACHMENT */
const both = 3;                                 /* visible in VERTEX and FRAGMENT */

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

const of = (rows, kind) => rows.filter(row => row.kind === kind);

/* What a pipeline needs besides its texts, of a step of the manifest: for one that nothing is drawn with, too. */
export function pipelineOf(manifest, chain, step, texts, stride) {
    const rows = step.rows.map(i => manifest.rows[i]), [operation, srcFactor, dstFactor] = step.blend?.webgpu ?? [];
    const attributes = of(rows, 'ATTRIBUTE').map(({ slot }) => ({
        shaderLocation: slot, offset: 16 * slot, format: 'float32x4' }));
    const counts = of(rows, 'CONSTANT').filter(row => row.offset);
    const constants = Object.fromEntries(counts.map(row => [row.offset, row.slot]));
    const target = ({ texture }) => ({
        format: texture < 0 ? 'rgba16float' : manifest.formats[chain.textures[texture].format].webgpu,
        ...operation && { blend: { color: { operation, srcFactor, dstFactor },
                                   alpha: { operation, srcFactor, dstFactor } } } });
    return {
        vertex: { module: texts.vert, buffers: attributes.length
            ? [{ arrayStride: stride ?? 16 * attributes.length, stepMode: 'instance', attributes }] : [] },
        fragment: { module: texts.frag, targets: step.outputs.map(target), constants }
    };
}

function layoutOf(device, manifest, step) {
    const blocks = new Set(of(step.rows.map(i => manifest.rows[i]), 'PARAM').map(row => row.slot));
    return device.createBindGroupLayout({ entries: [
        ...[...blocks].map(binding => ({ binding, visibility: both, buffer: {} })),
        ...step.inputs.map(({ binding, sample, dimension }) => ({
            binding, visibility: both, texture: { sampleType: sample, viewDimension: dimension } }))] });
}

/* The texels of a texture, four floats each. */
async function read(device, texture) {
    const { width, height } = texture, bytesPerRow = Math.ceil(width / 16) * 256;
    const module = device.createShaderModule({ code: `
        @group(0) @binding(0) var picture: texture_2d<f32>;
        @vertex fn all(@builtin(vertex_index) v: u32) -> @builtin(position) vec4f {
            return vec4f(f32(v & 1) * 4 - 1, f32(v >> 1) * 4 - 1, 0, 1); }
        @fragment fn texel(@builtin(position) p: vec4f) -> @location(0) vec4f {
            return textureLoad(picture, vec2u(p.xy), 0); }
        ` });
    const layout = device.createBindGroupLayout({ entries: [
        { binding: 0, visibility: both, texture: { sampleType: 'unfilterable-float' } }] });
    const pipeline = device.createRenderPipeline({
        layout: device.createPipelineLayout({ bindGroupLayouts: [layout] }),
        vertex: { module }, fragment: { module, targets: [{ format: 'rgba32float' }] } });
    const floats = device.createTexture({ size: [width, height], format: 'rgba32float', usage: 1 | 16 });
    const buffer = device.createBuffer({ size: bytesPerRow * height, usage: 1 | 8 });
    const encoder = device.createCommandEncoder();
    const group = device.createBindGroup({ layout, entries: [{ binding: 0, resource: texture.createView() }] });
    draw(encoder, pipeline, group, [{ view: floats.createView(), loadOp: 'clear', storeOp: 'store' }], 3, 1);
    encoder.copyTextureToBuffer({ texture: floats }, { buffer, bytesPerRow }, [width, height]);
    device.queue.submit([encoder.finish()]);
    await buffer.mapAsync(1);
    const all = new Float32Array(buffer.getMappedRange()), got = new Float32Array(4 * width * height);
    for (let y = 0, from = 0; y < height; ++y, from += bytesPerRow / 4)
        got.set(all.subarray(from, from + 4 * width), 4 * y * width);
    buffer.destroy();
    floats.destroy();
    return got;
}

function draw(encoder, pipeline, group, colorAttachments, vertices, instances, surfels) {
    const pass = encoder.beginRenderPass({ colorAttachments });
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, group);
    if (surfels) pass.setVertexBuffer(0, surfels);
    pass.draw(vertices, instances);
    pass.end();
}

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
    const pieces = new Map(), yours = new Map(), blocks = new Map(), made = [];
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
            yours.set(number, device.createTexture({ size, format: webgpu, usage: usage.texture }));
            device.queue.writeTexture({ texture: yours.get(number) }, await bytes(data),
                                      { bytesPerRow: each * width, rowsPerImage: height }, size);
        }
        return yours.get(number);
    };
    const shader = async name =>
        device.createShaderModule({ code: exact(await (await get(`${texts}/${name}.wgsl`)).text()) });
    const steps = await Promise.all(chain.steps.map(async step => {
        const layout = layoutOf(device, manifest, step);
        const modules = { vert: await shader(step.files.vert), frag: await shader(step.files.frag) };
        return { ...step, layout, pipeline: await device.createRenderPipelineAsync({
            layout: device.createPipelineLayout({ bindGroupLayouts: [layout] }),
            ...pipelineOf(manifest, chain, step, modules, capture.frames[0].surfels?.stride) }) };
    }));
    /* of a kept texture there are two: [0] is drawn into */
    chain.textures.forEach(({ format, slices, kept }, number) => {
        const by = chain.steps.findIndex(({ outputs }) => outputs.some(o => o.texture === number));
        const { width, height } = capture.frames[0].steps[by];
        made[number] = Array.from({ length: kept ? 2 : 1 }, () => device.createTexture({
            size: [width, height, slices || 1], format: manifest.formats[format].webgpu, usage: usage.texture }));
    });
    const found = [];
    for (const frame of capture.frames) {
        const surfels = frame.surfels && await bufferOf(frame.surfels.data, 32);
        for (let time = 0; time < frame.draws; ++time) {
            const encoder = device.createCommandEncoder();
            for (const [i, step] of steps.entries()) {
                const { frame: block, instances, yours: numbers } = frame.steps[i];
                const entries = [{ binding: 0, resource: { buffer: await bufferOf(block, 64) } }];
                for (const [k, { binding, dimension, texture, last }] of step.inputs.entries()) {
                    const read = numbers[k] < 0 ? made[texture].at(last ? -1 : 0) : await yourTexture(numbers[k]);
                    entries.push({ binding, resource: read.createView({ dimension }) });
                }
                const targets = step.outputs.map(({ texture, slice }) => ({
                    view: made[texture][0].createView({ dimension: '2d', baseArrayLayer: slice, arrayLayerCount: 1 }),
                    loadOp: step.clear === null ? 'load' : 'clear', storeOp: 'store',
                    clearValue: Array(4).fill(step.clear ?? 0) }));
                draw(encoder, step.pipeline, device.createBindGroup({ layout: step.layout, entries }), targets,
                     step.vertices, instances, surfels);
            }
            device.queue.submit([encoder.finish()]);
        }
        for (const { texture, is } of frame.results) {
            const { data, bytes: each, width, height } = capture.textures[is];
            const got = await read(device, made[texture][0]), wanted = new Float32Array(await bytes(data));
            const all = each / 4, channels = all < 3 ? 1 : 3;       /* light; or visibility, with depth behind it */
            let sum = 0;
            for (let i = 0; i < width * height; ++i)
                for (let c = 0; c < channels; ++c) sum += (got[4 * i + c] - wanted[all * i + c]) ** 2;
            found.push(Math.sqrt(sum / (width * height * channels)));
        }
        made.forEach(pair => pair.reverse());
    }
    for (const texture of [...made.flat(), ...yours.values()]) texture.destroy();
    return found;
}
