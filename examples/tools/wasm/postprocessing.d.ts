import type { Pass } from 'postprocessing';
import type { Camera, Scene, WebGLRenderer, WebGLRenderTarget } from 'three';
import type { Options, SSGIPass as Occluding } from 'ssgi/three';
import type { Ssgi } from 'ssgi';

type Members = Pick<Occluding, 'radius' | 'strength' | 'alone' | 'adjust' | 'given' | 'isLate' | 'harmonics' | 'texture'
                               | 'depthTexture' | 'cut'>;
type Source = Ssgi | string | URL | BufferSource | WebAssembly.Module;

/** A pass of pmndrs' EffectComposer after RenderPass: it reads the picture and the composer's depth. */
export class SSGIPass extends Pass {
  /** source: by default ssgi.wasm beside three.mjs */
  constructor(scene: Scene, camera: Camera, options?: Omit<Options, 'drawn' | 'ambient' | 'samples'>, source?: Source);
  /** kept once ssgi.wasm is there: until then the picture is passed on as it is */
  readonly ready: Promise<SSGIPass>;
  /** throws an Error of one sentence if an option is wrong */
  set(options: Omit<Options, 'drawn' | 'ambient' | 'samples'>): void;
  render(renderer: WebGLRenderer, input: WebGLRenderTarget, output: WebGLRenderTarget | null): void;
}
export interface SSGIPass extends Members {}

/** A pass of pmndrs' EffectComposer where RenderPass stood: it draws the scene, and darkens ambient light alone. */
export class SSGIRenderPass extends Pass {
  /** source: by default ssgi.wasm beside three.mjs */
  constructor(scene: Scene, camera: Camera, options?: Omit<Options, 'drawn'>, source?: Source);
  /** kept once ssgi.wasm is there: until then the scene is drawn without occlusion */
  readonly ready: Promise<SSGIRenderPass>;
  /** throws an Error of one sentence if an option is wrong */
  set(options: Omit<Options, 'drawn'>): void;
  render(renderer: WebGLRenderer, input: WebGLRenderTarget): void;
}
export interface SSGIRenderPass extends Members {}
