
/** Types of ssgi.mjs. Desc and Frame are above, printed by build/glsl-text --types. A wrong argument throws an Error
 *  whose message names the argument and says what it must be. */
export type Stage = 'vert' | 'frag' | 'tesc' | 'tese' | 'geom' | 'comp';
export type Preset = 'FAST' | 'BALANCED' | 'BEST';

/** ssgi_gl_choice: a field of a desc, from 0 to most. field: its name in C, as "gather.samples" */
export interface Choice { name: string; field: string; offset: number; most: number; values: string[];
                         sentence: string; }

/** ssgi_gl_io: an input or output of a program */
export interface Row {
  name: string;
  kind: 'TEXTURE' | 'PARAM' | 'OUTPUT' | 'CONSTANT' | 'ATTRIBUTE' | 'CAPTURE';
  type: string;
  /** TEXTURE: unit. OUTPUT, ATTRIBUTE: location. CONSTANT: value. PARAM: binding of its block */
  slot: number;
  /** PARAM: byte offset in the block */
  offset: number;
  format: string;
  /** VULKAN: the descriptor set of a TEXTURE, of the block of a PARAM, of the image of a compute stage's OUTPUT */
  set: number;
  binding: number;
}

/** ssgi_gl_chain: the draws for a desc. A missing member is 0 */
export interface Chain {
  desc: Desc; lights?: Desc; width: number; height: number;
  blur?: number; history?: number; coefficients?: number; reuse?: number; vpls?: number; direct?: number;
  surfels?: number; hidden_sky?: number; unsmoothed?: number; bounced?: number;
  precise?: number; rgba8?: number;
}

/** ssgi_gl_method: a named chain */
export interface Method { name: string; sentence: string; pass: string; preset: Preset; settings: string; }

/** ssgi_gl_format: the arguments of texImage2D */
export interface Format {
  name: string; internal: number; format: number; type: number; bytes: number;
  /** VkFormat's number and name; WebGPU's name */
  vulkan: number; vulkan_name: string; webgpu: string;
}

/** ssgi_gl_input */
export interface Input {
  name: string; type: string; unit: number; target: number;
  /** WebGPU: in group `set`. array: 1 = viewDimension "2d-array"; integer: 1 = sampleType "uint", 0 =
   *  "unfilterable-float" */
  set: number; binding: number; array: number; multisampled: number; integer: number;
  /** your texture for it, a word of SSGI_GL_YOUR_*; null: a texture of the steps, by its number */
  meaning: string | null; texture: number; last: number; format: Format | 0; width: number; height: number;
}

/** ssgi_gl_output */
export interface Output {
  name: string; texture: number; format: Format | 0; layers: number; layer: number;
  /** of a compute stage: those of the storage image, in GL `binding` is its unit */
  set: number; binding: number;
  kept: number; result: 'NONE' | 'LIGHT' | 'BOUNCE';
}

/** ssgi_gl_step: one draw */
export interface Step {
  desc: Desc; scale: 'FULL' | 'HALF' | 'LEVELS' | 'TILES' | 'QUARTER'; width: number; height: number; inputs: Input[];
  outputs: Output[];
  frame: number; primitive: number; vertices: number; instances: number; blend: number[]; clear: number;
  clear_to: number;
  /** of a compute stage: how many groups to dispatch across and down; else 0 */
  groups: number[];
}

/** ssgi_hit */
export interface Hit { t: number; u: number; v: number; triangle: number; }
export interface Trace {
  triangles: number;
  any(origin: ArrayLike<number>, direction: ArrayLike<number>, tmin: number, tmax: number): boolean;
  closest(origin: ArrayLike<number>, direction: ArrayLike<number>, tmin: number, tmax: number): Hit | null;
}

/** ssgi_surfel_desc */
export interface SurfelDesc {
  size?: number; splits?: number; offscreen_growth?: number; keep_small?: number; max_distance?: number;
  overhang?: number;
}

/** ssgi_field, as ssgi_field_save wrote it */
export interface Field {
  resolution: number; radius: number; reach: number; inside: number; p95: number;
  /** texels of a slice of t_ssgi_fields: RG32UI, resolution + 2 wide, 6 (resolution + 2) high */
  texels: Uint32Array;
  /** its row of t_ssgi_occluders: 10 texels of RGBA32F */
  occluder(meshToView: ArrayLike<number>, slice?: number, object?: number,
           limits?: { ramp?: number; reach?: number; inside?: number; power?: number }): Float32Array;
}

/** ssgi_gl_light. at, normal: in the picture's view space */
export interface Light {
  kind: 'SUN' | 'POINT' | 'SPOT' | 'VPL';
  at: ArrayLike<number>; colour: ArrayLike<number>; min_distance?: number; normal?: ArrayLike<number>;
}
/** its shadow map: the first texel in t_ssgi_shadow, the view with which it was drawn, matrices from the world */
export interface LightMap {
  view: Uint8Array; x?: number; y?: number; worldToView: ArrayLike<number>; worldToLight: ArrayLike<number>;
}

export class Ssgi {
  constructor(exports: WebAssembly.Exports);
  readonly version: string;
  readonly choices: Choice[];
  readonly methods: Method[];
  readonly members: Row[];
  readonly passes: string[];
  readonly dialects: string[];
  shader(desc: Desc, stage?: Stage): string;
  /** GLSL of functions that read the result of the step with this desc: ssgi_gl_read */
  read(desc: Desc): string;
  /** GLSL of ssgi_interreflected and ssgi_specular_visibility: ssgi_gl_reflection */
  reflection(): string;
  rows(desc: Desc): Row[];
  check(desc: Desc): void;
  key(desc: Desc): bigint;
  preset(desc: Desc, preset: Preset): Desc;
  resolve(desc: Desc): Desc;
  view(projection: ArrayLike<number>, width: number, height: number,
       clip?: 'GL' | 'ZERO' | 'GL_ROWS_DOWN' | 'ZERO_ROWS_DOWN'): Uint8Array;
  /** with chain: the values of ssgi_gl_frame_init for it */
  frame(view: Uint8Array, radius: number, chain?: Partial<Chain> | null): Frame;
  history(frame: Frame, view: Uint8Array, worldToView: ArrayLike<number>, lastWorldToView: ArrayLike<number>): Frame;
  harmonics(frame: Frame, coefficients: ArrayLike<number>, bands: number,
            worldToView?: ArrayLike<number> | null): Frame;
  surfels(frame: Frame, view: Uint8Array, desc?: SurfelDesc): Frame;
  /** a row of t_ssgi_lights: 8 texels of RGBA32F */
  light(light: Light, map?: LightMap | null): Float32Array;
  phase(k: number): number;
  /** the chain of a method by its name, as "hsao,thickness=slabs": ssgi_gl_chain_of. Width and height are missing.
      With depth=custom set chain.desc.fetch to GLSL with float ssgi_custom_depth(ivec2 texel, int layer) */
  chain(name: string): Omit<Chain, 'width' | 'height'>;
  steps(chain: Chain): Step[];
  environmentMap(size: number, rgb: ArrayLike<number>, width: number, height: number,
                 solidAngle?: number): Float32Array;
  environmentCone(size: number, rgb: ArrayLike<number>, width: number, height: number, cosine?: number): Float32Array;
  residual(size: number, map: Float32Array, coefficients: ArrayLike<number>, bands: number): Float32Array;
  projectEquirect(bands: number, rgb: ArrayLike<number>, width: number, height: number): Float32Array;
  field(bytes: Uint8Array): Field;
  trace(position: ArrayLike<number>, index?: ArrayLike<number> | null): Trace;
}

/** source: default: ssgi.wasm in this file's folder */
export function load(source?: string | URL | BufferSource | WebAssembly.Module): Promise<Ssgi>;
/** as load, but reads each source only once; returns an Ssgi unchanged */
export function loadOnce(source?: Ssgi | string | URL | BufferSource | WebAssembly.Module): Promise<Ssgi>;
