/* webgpu.mjs - draws a chain of ssgi with WebGPU, from its plan alone.

      import hsao from 'ssgi/chains/hsao';
      const passes = new Passes(device, sized(hsao, width, height));
      await passes.ready;
      passes.draw(encoder, { block: () => block, yours: (number, { yours }) => textures[yours] });
      passes.result('LIGHT')                                         // a GPUTexture: ambient visibility, or light

   A plan: textures: [{ format, size, layers, kept, result }]; steps: [{ rows, blend: [operation, source, destination]
   or null, clear: null or a number, vertices, instances, inputs: [{ binding, sample, dimension, yours, texture, last
   }], outputs: [{ texture, layer, format }], code: { vert, frag } }]. Formats are WebGPU's words. A step with a compute
   stage has code: { comp } and group: [width, height]; its outputs have a binding, too. */

const usage = 1 | 2 | 4 | 16;                       /* COPY_SRC, COPY_DST, TEXTURE_BINDING, RENDER_ATTACHMENT */
const stored = 1 | 2 | 4 | 8;                       /* STORAGE_BINDING instead of RENDER_ATTACHMENT */
const both = 3, compute = 4;                        /* visible in VERTEX and FRAGMENT; in COMPUTE */
const of = (rows, kind) => rows.filter(row => row.kind === kind);

/* A chain of a manifest as a plan without code; sizes: of its textures. */
export function planOf(manifest, chain, sizes = chain.textures.map(({ scale }) => scale)) {
    const formatOf = texture => (texture < 0 ? 'rgba16float'        /* your picture */
        : manifest.formats[chain.textures[texture].format].webgpu);
    return {
        name: chain.name,
        textures: chain.textures.map(({ layers, kept, result }, i) => ({
            format: formatOf(i), size: sizes[i], layers, kept, result })),
        steps: chain.steps.map(({ files, rows, blend, clear, vertices, instances, group, inputs, outputs }) => ({
            files, rows: rows.map(i => manifest.rows[i]), blend: blend?.webgpu, clear, vertices, instances, group,
            inputs, outputs: outputs.map(output => ({ ...output, format: formatOf(output.texture) })) }))
    };
}

/* A plan of the package for pictures of this size. */
export function sized({ name, textures, steps }, width, height) {
    const shares = { FULL: 1, HALF: 2, QUARTER: 4, TILES: 8 };
    return { name, steps, textures: textures.map(texture => {
        const share = shares[texture.size];
        if (!share) throw new Error(`${name}: must be a chain without surfels, whose levels have sizes of their own`);
        return { ...texture, size: [width, height].map(n => Math.ceil(n / share)) };
    }) };
}

/* The descriptor of a pipeline without its layout. stride: of the buffer of attributes, if there are any. */
export function pipelineOf({ rows, blend, group, outputs }, modules, stride) {
    const counts = of(rows, 'CONSTANT').filter(row => row.offset);
    const constants = Object.fromEntries(counts.map(row => [row.offset, row.slot]));
    if (group) return { compute: { module: modules.comp, constants } };
    const [operation, srcFactor, dstFactor] = blend ?? [], by = { operation, srcFactor, dstFactor };
    const blending = blend && { blend: { color: by, alpha: by } };
    const attributes = of(rows, 'ATTRIBUTE').map(({ slot }) => ({
        shaderLocation: slot, offset: 16 * slot, format: 'float32x4' }));
    return {
        vertex: { module: modules.vert, buffers: attributes.length
            ? [{ arrayStride: stride ?? 16 * attributes.length, stepMode: 'instance', attributes }] : [] },
        fragment: { module: modules.frag, constants,
                    targets: outputs.map(({ format }) => ({ format, ...blending })) }
    };
}

function layoutOf(device, { rows, group, inputs, outputs }) {
    const blocks = new Set(of(rows, 'PARAM').map(row => row.slot)), visibility = group ? compute : both;
    return device.createBindGroupLayout({ entries: [
        ...[...blocks].map(binding => ({ binding, visibility, buffer: {} })),
        ...inputs.map(({ binding, sample, dimension }) => ({
            binding, visibility, texture: { sampleType: sample, viewDimension: dimension } })),
        ...(group ? outputs : []).map(({ binding, format }) => ({
            binding, visibility, storageTexture: { access: 'write-only', format } }))] });
}

/* A chain with its pipelines and textures. */
export class Passes {
    #device; #draws = []; #results; #usage;
    textures = [];                                  /* by number; a kept one has two, [0] is drawn into */
    ready;                                          /* a promise, resolved when its pipelines exist */

    /* modulesOf: gives a step's { vert, frag } or { comp }, or a promise of them; default: from the plan's code */
    constructor(device, { steps, textures }, modulesOf = null, stride = undefined) {
        const moduleOf = code => device.createShaderModule({ code });
        this.#device = device;
        this.#usage = steps.some(step => step.group) ? stored : usage;
        this.resize(textures);
        this.ready = Promise.all(steps.map(async step => {
            const layout = layoutOf(device, step), modules = modulesOf ? await modulesOf(step)
                : Object.fromEntries(Object.entries(step.code).map(([stage, code]) => [stage, moduleOf(code)]));
            const needs = { layout: device.createPipelineLayout({ bindGroupLayouts: [layout] }),
                            ...pipelineOf(step, modules, stride) };
            const pipeline = await (step.group ? device.createComputePipelineAsync(needs)
                                               : device.createRenderPipelineAsync(needs));
            return { step, layout, pipeline };
        })).then(draws => { this.#draws = draws; });
    }

    /* Replaces the textures by those of a plan of the same chain. */
    resize(textures) {
        this.free();
        this.#results = textures.map(({ result }) => result);
        this.textures = textures.map(({ format, size, layers, kept }) => Array.from({ length: kept ? 2 : 1 },
            () => this.#device.createTexture({ format, size: [...size, layers || 1], usage: this.#usage })));
    }

    /* LIGHT or BOUNCE of the last frame; undefined: the chain has none. */
    result(name) { return this.textures[this.#results.indexOf(name)]?.[0]; }

    /* block(number of the step): its uniform buffer; yours(number, input): your texture, null: one of the chain's;
       instances(number) and surfels for a step that draws those; stamps(number): where its times are written. */
    draw(encoder, { block, yours, instances, surfels, stamps }) {
        this.#draws.forEach(({ step, layout, pipeline }, number) => {
            const entries = [{ binding: 0, resource: { buffer: block(number) } }];
            for (const input of step.inputs) {
                const { binding, dimension, texture, last } = input;
                const read = yours(number, input) ?? this.textures[texture].at(last ? -1 : 0);
                entries.push({ binding, resource: read.createView({ dimension }) });
            }
            const views = step.outputs.map(({ texture, layer }) => this.textures[texture][0].createView({
                dimension: '2d', baseArrayLayer: layer, arrayLayerCount: 1 }));
            if (step.group) step.outputs.forEach(({ binding }, k) => entries.push({ binding, resource: views[k] }));
            const timestampWrites = stamps?.(number);
            const pass = step.group ? encoder.beginComputePass({ timestampWrites }) : encoder.beginRenderPass({
                timestampWrites, colorAttachments: views.map(view => ({
                    view, loadOp: step.clear === null ? 'load' : 'clear', storeOp: 'store',
                    clearValue: Array(4).fill(step.clear ?? 0) })) });
            pass.setPipeline(pipeline);
            pass.setBindGroup(0, this.#device.createBindGroup({ layout, entries }));
            if (step.group) {
                const { width, height } = this.textures[step.outputs[0].texture][0], [across, down] = step.group;
                pass.dispatchWorkgroups(Math.ceil(width / across), Math.ceil(height / down));
                pass.end();
                return;
            }
            if (surfels) pass.setVertexBuffer(0, surfels);
            pass.draw(step.vertices, instances?.(number) ?? step.instances);
            pass.end();
        });
    }

    /* Call it after a frame whose history is kept. */
    turn() { this.textures.forEach(pair => pair.reverse()); }
    free() { this.textures.flat().forEach(texture => texture.destroy()); }
}
