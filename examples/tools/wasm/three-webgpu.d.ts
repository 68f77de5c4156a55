import type { Camera, Node, Texture, TextureNode } from 'three/webgpu';
import type { Frame, Ssgi } from 'ssgi';
import type { Plan } from 'ssgi/webgpu';

export interface Options {
  /** [units: of the scene] distance of the farthest occluder; default 1 */
  radius?: number;
  /** is given each frame's block before it is drawn */
  adjust?: ((frame: Frame) => void) | null;
}

/** A chain as a node of WebGPURenderer. */
export class OcclusionNode extends Node {
  constructor(chain: Plan, inputs: { [meaning: string]: TextureNode | Texture }, camera: Camera, options?: Options,
              source?: Ssgi | string | URL | BufferSource | WebAssembly.Module);
  /** kept once ssgi.wasm is there: until then it is white */
  readonly ready: Promise<OcclusionNode>;
  /** must be one of perspective: while it is not, nothing is drawn */
  camera: Camera;
  /** [units: of the scene] */
  radius: number;
  adjust: ((frame: Frame) => void) | null;
  /** why nothing is drawn; null: it is */
  readonly lacks: string | null;
  /** LIGHT: ambient visibility, or light over pi; BOUNCE: what is added to that; null: the chain has none */
  getTextureNode(name?: 'LIGHT' | 'BOUNCE'): TextureNode;
  /** the next frame shows another place */
  cut(): void;
  dispose(): void;
}

export function occlusion(chain: Plan, inputs: { [meaning: string]: TextureNode | Texture }, camera: Camera,
                          options?: Options, source?: Ssgi | string | URL | BufferSource | WebAssembly.Module):
  OcclusionNode;
