/* three-webgpu.mjs - ssgi in three.js' WebGPURenderer: a node that draws a chain of the package, used as GTAONode is.

      import hsao from 'ssgi/chains/hsao';
      import { occlusion } from 'ssgi/three/webgpu';
      const before = pass(scene, camera, { samples: 0 }), picture = pass(scene, camera);
      before.setMRT(mrt({ output: normalView }));
      const seen = occlusion(hsao, { DEPTH: before.getTextureNode('depth'), NORMAL: before.getTextureNode() }, camera,
                             { radius: 0.5 });
      picture.contextNode = builtinAOContext(seen.getTextureNode().sample(screenUV).r);   // only ambient light
      pipeline.outputNode = picture;

   The node is white, and node.lacks says why, if three has fallen back to WebGL 2, whose cached state cannot be reset
   there, and while node.camera is orthographic, because these chains are for perspective. */
import { DataTexture, ExternalTexture, NearestFilter, Node, NodeUpdateType } from 'three/webgpu';
import { passTexture } from 'three/tsl';
import { loadOnce } from './ssgi.mjs';
import { Passes, sized } from './webgpu.mjs';

const fallen = 'renderer: must draw with WebGPU; WebGLRenderer has a pass in ssgi/three';
const parallel = 'camera: must be one of perspective, as these chains are';
const isOrthographic = camera => camera.projectionMatrix.elements[11] === 0;
const textureOf = input => (input.isTexture ? input : input.value);

function white() {
    const texture = new DataTexture(new Uint8Array(4).fill(255), 1, 1);
    texture.needsUpdate = true;
    return texture;
}

export class OcclusionNode extends Node {
    static get type() { return 'OcclusionNode'; }

    /* radius: in units of the scene. adjust: called with each frame's block, to set harmonics, thickness_limit. lacks:
       why nothing is drawn; null: the node is drawn. */
    radius = 1;
    adjust = null;
    lacks = null;

    #chain; #history; #nodes = {}; #ssgi = null; #passes = null; #linked = false; #device = null; #block = null;
    #size = [0, 0]; #shown = new Map(); #white = white(); #frames = 0; #last = null;

    /* A promise of this node, resolved when ssgi.wasm is loaded; before that the node is white. */
    ready;

    /* chain: of ssgi/chains. inputs: texture nodes or textures by meaning. source: as in SSGIPass */
    constructor(chain, inputs, camera, { radius = 1, adjust = null } = {}, source = undefined) {
        super('vec4');
        if (typeof radius !== 'number' || !(radius > 0)) throw new Error('radius: must be a number above 0');
        for (const { yours } of chain.steps.flatMap(step => step.inputs))
            if (yours && !inputs[yours]) throw new Error(`inputs: ${chain.name} reads ${yours}: give its texture node`);
        if (isOrthographic(camera)) throw new Error(parallel);
        sized(chain, 1, 1);                         /* throws if it cannot draw the chain */
        Object.assign(this, { inputs, camera, radius, adjust, updateBeforeType: NodeUpdateType.FRAME });
        this.#chain = chain;
        this.#history = chain.textures.some(({ kept }) => kept);
        for (const name of ['LIGHT', 'BOUNCE'])
            if (chain.textures.some(({ result }) => result === name))
                this.#nodes[name] = passTexture(this, this.#white);
        this.ready = loadOnce(source).then(ssgi => {
            this.#ssgi = ssgi;
            return this;
        });
    }

    /* LIGHT: ambient visibility, or light over pi; BOUNCE: to be added to the light. */
    getTextureNode(name = 'LIGHT') { return this.#nodes[name] ?? null; }

    /* Call it before a frame that shows another place: history begins anew. */
    cut() { this.#last = null; }

    setup(builder) {
        const properties = builder.getNodeProperties(this);
        for (const [meaning, input] of Object.entries(this.inputs)) if (input.isNode) properties[meaning] = input;
        return this.#nodes.LIGHT;
    }

    updateBefore(frame) {
        const { renderer: { backend } } = frame, ssgi = this.#ssgi;
        for (const { passNode } of Object.values(this.inputs)) if (passNode) frame.updateBeforeNode(passNode);
        this.lacks = !backend.isWebGPUBackend ? fallen : isOrthographic(this.camera) ? parallel : null;
        if (this.lacks) {
            this.cut();
            this.#hide();
        }
        if (this.lacks || !ssgi) return;
        const raw = Object.fromEntries(Object.entries(this.inputs).map(([meaning, input]) =>
            [meaning, backend.get(textureOf(input)).texture]));
        if (!raw.DEPTH) return;
        if (raw.DEPTH.sampleCount > 1)
            throw new Error('inputs.DEPTH: must have one sample a pixel: pass(scene, camera, { samples: 0 })');
        this.#fit(backend.device, raw.DEPTH);
        if (this.#linked) this.#draw(raw);
    }

    #fit(device, { width, height }) {
        if (this.#device !== device) {
            this.#free();
            this.#device = device;
        }
        if (this.#passes && this.#size[0] === width && this.#size[1] === height) return;
        const plan = sized(this.#chain, width, height);
        this.#size = [width, height];
        this.cut();
        this.#hide();
        if (this.#passes) { this.#passes.resize(plan.textures); return; }
        const passes = this.#passes = new Passes(device, plan);
        passes.ready.then(() => { this.#linked = this.#passes === passes; }, error => { this.lacks = error.message; });
    }

    #draw(raw) {
        const ssgi = this.#ssgi, device = this.#device, { camera } = this, encoder = device.createCommandEncoder();
        const view = ssgi.view(camera.projectionMatrix.elements, ...this.#size, 'ZERO_ROWS_DOWN');
        const toView = Float32Array.from(camera.matrixWorldInverse.elements), block = ssgi.frame(view, this.radius);
        if (this.#history) {
            if (this.#last) ssgi.history(block, this.#last.view, toView, this.#last.toView);
            block.phase[0] = ssgi.phase(this.#frames++);
            this.#last = { view, toView };
        }
        this.adjust?.(block);
        this.#block ??= device.createBuffer({ size: block.buffer.byteLength, usage: 64 | 8 });  /* UNIFORM, COPY_DST */
        device.queue.writeBuffer(this.#block, 0, block.buffer);
        this.#passes.draw(encoder, { block: () => this.#block, yours: (number, { yours }) => yours && raw[yours] });
        device.queue.submit([encoder.finish()]);
        for (const [name, node] of Object.entries(this.#nodes)) node.value = this.#shownOf(this.#passes.result(name));
        if (this.#history) this.#passes.turn();
    }

    /* A texture of three for a texture of the chain; a kept one has two. */
    #shownOf(gpu) {
        if (!this.#shown.has(gpu)) {
            const texture = new ExternalTexture(gpu);
            Object.assign(texture, { minFilter: NearestFilter, magFilter: NearestFilter, generateMipmaps: false,
                                     needsUpdate: true });
            this.#shown.set(gpu, texture);
        }
        return this.#shown.get(gpu);
    }

    #hide() {
        for (const node of Object.values(this.#nodes)) node.value = this.#white;
        for (const texture of this.#shown.values()) texture.dispose();
        this.#shown.clear();
    }
    #free() {
        this.#hide();
        this.#passes?.free();
        this.#block?.destroy();
        this.#passes = this.#block = null;
        this.#linked = false;
    }
    dispose() {
        this.#free();
        this.#white.dispose();
        super.dispose();
    }
}

export const occlusion = (chain, inputs, camera, options, source) =>
    new OcclusionNode(chain, inputs, camera, options, source);
