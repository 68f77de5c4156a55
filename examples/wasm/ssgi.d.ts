
/** Types of ssgi.mjs. Desc stands above: build/glsl-text --types prints it. */
export type Stage = 'vert' | 'frag' | 'tesc' | 'tese' | 'geom';
export type Preset = 'FAST' | 'BALANCED' | 'BEST';

/** ssgi_gl_choice: a field of a desc, 0 .. most */
export interface Choice { name: string; offset: number; most: number; values: string[]; sentence: string; }

/** ssgi_gl_io: what a program reads or writes */
export interface Row {
  name: string;
  kind: 'TEXTURE' | 'PARAM' | 'OUTPUT' | 'CONSTANT' | 'ATTRIBUTE' | 'CAPTURE';
  type: string;
  /** TEXTURE: unit. OUTPUT, ATTRIBUTE: location. CONSTANT: value. PARAM: binding of its block */
  slot: number;
  /** PARAM: byte in the block */
  offset: number;
  format: string;
}

/** ssgi_gl_frame: buffer is the uniform block "ssgi_frame"; its members are arrays in it. */
export type Frame = { buffer: ArrayBuffer } & { [member: string]: Float32Array | Int32Array };

export class Ssgi {
  constructor(exports: WebAssembly.Exports);
  readonly version: string;
  readonly choices: Choice[];
  readonly members: Row[];
  readonly passes: string[];
  readonly dialects: string[];
  text(desc: Desc, stage?: Stage): string;
  rows(desc: Desc): Row[];
  check(desc: Desc): void;
  key(desc: Desc): bigint;
  preset(desc: Desc, preset: Preset): Desc;
  resolve(desc: Desc): Desc;
  view(projection: ArrayLike<number>, width: number, height: number, clip?: 'GL' | 'ZERO'): Uint8Array;
  frame(view: Uint8Array, radius: number): Frame;
  history(frame: Frame, view: Uint8Array, worldToView: ArrayLike<number>, lastWorldToView: ArrayLike<number>): Frame;
  harmonics(frame: Frame, coefficients: ArrayLike<number>, bands: number, worldToView?: ArrayLike<number> | null): Frame;
  phase(k: number): number;
}

/** source: by default ssgi.wasm beside this file */
export function load(source?: string | URL | BufferSource | WebAssembly.Module): Promise<Ssgi>;
