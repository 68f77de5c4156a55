import type { Camera, Node, Texture, TextureNode } from 'three/webgpu';
import type { Frame, Ssgi } from 'ssgi';
import type { Plan } from 'ssgi/webgpu';

export interface Options {
  /** [units: of the scene] distance of the farthest occluder; default 1 */
  radius?: number;
  /** called with each frame's block before it is drawn */
  adjust?: ((frame: Frame) => void) | null;
}

/** A chain as a node of WebGPURenderer. */
export class OcclusionNode extends Node {
  constructor(chain: Plan, inputs: { [meaning: string]: TextureNode | Texture }, camera: Camera, options?: Options,
              source?: Ssgi | string | URL | BufferSource | WebAssembly.Module);
  /** resolves when ssgi.wasm is loaded; before that the node is white */
  readonly ready: Promise<OcclusionNode>;
  /** must be a perspective camera, else nothing is drawn */
  camera: Camera;
  /** [units: of the scene] */
  radius: number;
  adjust: ((frame: Frame) => void) | null;
  /** why nothing is drawn; null: the node is drawn */
  readonly lacks: string | null;
  /** LIGHT: ambient visibility, or light over pi; BOUNCE: to be added to the light; null: the chain has no such
   *  result */
  getTextureNode(name?: 'LIGHT' | 'BOUNCE'): TextureNode;
  /** call it before a frame that shows another place: history begins anew */
  cut(): void;
  dispose(): void;
}

export function occlusion(chain: Plan, inputs: { [meaning: string]: TextureNode | Texture }, camera: Camera,
                          options?: Options, source?: Ssgi | string | URL | BufferSource | WebAssembly.Module):
  OcclusionNode;
