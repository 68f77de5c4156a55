import type { Camera, DepthTexture, Material, Object3D, Scene, Texture, WebGLRenderer, WebGLRenderTarget } from 'three';
import type { Desc, Frame, Preset, Ssgi } from 'ssgi';

/** Fields of a desc, of which pass is the method, and: */
export interface Options extends Desc {
  /** default 'BALANCED' */
  preset?: Preset;
  /** [units: of the scene] distance of the farthest occluder; default 1 */
  radius?: number;
  /** default 1: visibility v is shown as 1 + strength (v - 1) */
  strength?: number;
  /** default true, false if drawn: only ambient light is dimmed; false: the whole picture is */
  ambient?: boolean;
  /** default false; true: 16 frames are averaged */
  history?: boolean;
  /** multisampling: the samples of a pixel at opaque edges; default 0 */
  samples?: number;
  /** default false; true: a pass before this one has drawn the scene, whose picture and depth are read */
  drawn?: boolean;
  /** default 1: the result is filtered; 0: it is not */
  blur?: 0 | 1;
}

/** A pass of EffectComposer that draws the scene with occlusion. */
export class SSGIPass {
  /** source: default: ssgi.wasm in three.mjs's folder */
  constructor(scene: Scene, camera: Camera, options?: Options,
              source?: Ssgi | string | URL | BufferSource | WebAssembly.Module);
  /** resolves when ssgi.wasm is loaded; before that the scene is drawn without occlusion */
  readonly ready: Promise<SSGIPass>;
  scene: Scene;
  /** of any kind; may be replaced at any time */
  camera: Camera;
  readonly isPass: true;
  enabled: boolean;
  needsSwap: boolean;
  clear: boolean;
  renderToScreen: boolean;
  radius: number;
  strength: number;
  /** the result without the picture */
  alone: boolean;
  /** called with each frame's block before it is drawn */
  adjust: ((frame: Frame) => void) | null;
  /** your textures by meaning, as MOTION */
  given: { [meaning: string]: Texture };
  /** whether an object is drawn after occlusion; default: if it is transparent */
  isLate: (object: Object3D) => boolean;
  /** radiance of the ambient light, nine coefficients of three colours; null: from the scene's lights */
  harmonics: ArrayLike<number> | null;
  /** ambient visibility, or light over pi, of the last frame */
  readonly texture: Texture | null;
  /** the scene's depth in the last frame; render's target also has it */
  readonly depthTexture: DepthTexture | null;
  /** throws an Error of one sentence if an option is wrong */
  set(options: Options): void;
  /** call it before a frame that shows another place: history begins anew */
  cut(): void;
  setSize(width: number, height: number): void;
  render(renderer: WebGLRenderer, writeBuffer: WebGLRenderTarget | null, readBuffer?: WebGLRenderTarget | null,
         deltaTime?: number, maskActive?: boolean): void;
  dispose(): void;
}

/** The WebGL texture of a texture of three. */
export function rawOf(renderer: WebGLRenderer, texture: Texture): WebGLTexture | null;
/** Call it after draws outside three: it renews three's copy of GL's state. */
export function resetState(renderer: WebGLRenderer): void;
export function viewOf(ssgi: Ssgi, camera: Camera, width: number, height: number): Uint8Array;
export function writes(material: Material, outputs: { name: string; is: string; fogged?: boolean }[]): () => void;
/** Nine coefficients of AmbientLight, HemisphereLight and LightProbe, as radiance in world space. */
export function ambientOf(scene: Object3D): Float32Array;
export function harmonicsText(name: string): string;

/** Depth of back faces, for thickness BACK (count 1) and SLABS (3). */
export class Behind {
  constructor(width: number, height: number);
  draw(renderer: WebGLRenderer, scene: Scene, camera: Camera, count: 1 | 3): Texture | DepthTexture;
  dispose(): void;
}
