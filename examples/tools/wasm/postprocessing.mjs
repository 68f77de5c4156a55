/* postprocessing.mjs - ssgi in the EffectComposer of pmndrs' postprocessing, also in @react-three/postprocessing.

      import { SSGIPass } from 'ssgi/postprocessing';
      composer.addPass(new SSGIPass(scene, camera, { radius: 0.5 }));      // after RenderPass

   SSGIPass reads the picture and the composer's depth, and darkens all light. SSGIRenderPass stands where RenderPass
   stood: it draws the scene itself, as SSGIPass of ssgi/three does, and darkens ambient light alone. Both leave depth
   for later effects. */
import { Pass } from 'postprocessing';
import { SSGIPass as Occluding } from './three.mjs';

class Wrapped extends Pass {
    #of;

    static {
        for (const name of ['radius', 'strength', 'alone', 'adjust', 'given', 'isLate', 'harmonics', 'texture',
                            'depthTexture'])
            Object.defineProperty(this.prototype, name, { get() { return this.#of[name]; },
                                                          set(value) { this.#of[name] = value; } });
    }

    constructor(name, scene, camera, options, source) {
        super(name, scene, camera);
        this.#of = new Occluding(scene, camera, options, source);
        this.ready = this.#of.ready.then(() => this);
    }

    set mainScene(scene) { this.scene = this.#of.scene = scene; }
    set mainCamera(camera) { this.camera = this.#of.camera = camera; }
    set(options) { this.#of.set(options); }
    cut() { this.#of.cut(); }
    setSize(width, height) { this.#of.setSize(width, height); }
    dispose() { this.#of.dispose(); }

    render(renderer, to, from) {
        this.#of.renderToScreen = this.renderToScreen;
        this.#of.render(renderer, to, from);
    }
}

export class SSGIPass extends Wrapped {
    #depth = null;

    constructor(scene, camera, options = {}, source = undefined) {
        super('SSGIPass', scene, camera, { ...options, drawn: true }, source);
        this.needsDepthTexture = true;
    }

    set(options) { super.set({ ...options, drawn: true }); }
    getDepthTexture() { return this.#depth; }
    setDepthTexture(depth) { this.#depth = depth; }
    render(renderer, input, output) {
        super.render(renderer, output, { texture: input.texture, depthTexture: this.#depth });
    }
}

export class SSGIRenderPass extends Wrapped {
    constructor(scene, camera, options = {}, source = undefined) {
        super('SSGIRenderPass', scene, camera, options, source);
        Object.assign(this, { needsSwap: false, needsDepthBlit: true });
    }

    render(renderer, input) { super.render(renderer, input); }
}
