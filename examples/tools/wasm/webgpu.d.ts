/** GPUDevice, GPUTexture and so on, from any package of types. */
type OfWebGPU = any;

export interface Input {
  binding: number; sample: 'uint' | 'unfilterable-float'; dimension: '2d' | '2d-array';
  /** your texture for it: DEPTH, NORMAL ..; undefined: a texture of the chain, by its number */
  yours?: string; texture?: number; last?: number;
}

/** A chain: its textures and draws, in order. */
export interface Plan {
  name?: string;
  textures: {
    format: string; layers: number; kept: number; result?: 'NONE' | 'LIGHT' | 'BOUNCE';
    /** [width, height] after sized() */
    size: 'FULL' | 'HALF' | 'QUARTER' | 'TILES' | 'LEVELS' | number[];
  }[];
  steps: {
    rows: { kind: string; slot: number; offset: number }[]; blend?: [string, string, string] | null;
    clear: number | null; vertices: number; instances: number; inputs: Input[];
    /** of a compute stage: the width and height of a group */
    group?: [number, number];
    outputs: { texture: number; layer: number; format: string; binding?: number }[];
    code?: { vert: string; frag: string } | { comp: string };
  }[];
}
export type Step = Plan['steps'][number];

/** A chain of the manifest of package ssgi-wgsl as a plan without code. */
export function planOf(manifest: object, chain: object, sizes?: number[][]): Plan;
/** A plan of the package for pictures of this size. Throws if the chain draws surfels. */
export function sized(plan: Plan, width: number, height: number): Plan;
export function pipelineOf(step: Step, modules: { vert?: OfWebGPU; frag?: OfWebGPU; comp?: OfWebGPU },
                           stride?: number): OfWebGPU;

/** A chain with its pipelines and textures. */
export class Passes {
  constructor(device: OfWebGPU, plan: Plan,
              modulesOf?: ((step: Step) => OfWebGPU) | null, stride?: number);
  /** resolves when its pipelines exist; before that draw() draws nothing */
  readonly ready: Promise<void>;
  readonly textures: OfWebGPU[][];
  resize(textures: Plan['textures']): void;
  result(name: 'LIGHT' | 'BOUNCE'): OfWebGPU;
  draw(encoder: OfWebGPU, its: {
    block: (step: number) => OfWebGPU; yours: (step: number, input: Input) => OfWebGPU;
    instances?: (step: number) => number; surfels?: OfWebGPU; stamps?: ((step: number) => OfWebGPU) | null;
  }): void;
  /** call it after each frame whose history is kept */
  turn(): void;
  free(): void;
}
