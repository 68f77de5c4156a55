import type { Chain, Desc, Format, Frame, Ssgi, Step } from 'ssgi';

/** Textures by their meanings (Input.meaning), and what else a step reads. */
export interface Yours {
  [meaning: string]: WebGLTexture | null | undefined | WebGLFramebuffer | WebGLVertexArrayObject | number;
  /** desc.onto draws onto this framebuffer, onto the canvas where there is none */
  PICTURE?: WebGLFramebuffer | null;
  array?: WebGLVertexArrayObject;
  instances?: number;
}

/** A chain with its targets, of one size. */
export interface Run {
  readonly chain: Chain;
  readonly steps: Step[];
  /** ambient visibility, or light over pi; what a bounce adds to it */
  readonly light: WebGLTexture | null;
  readonly format: Format | null;
  readonly bounce: WebGLTexture | null;
  /** its programs are linked: draw() does not wait */
  readonly linked: boolean;
  /** of each step, once poll() has said so */
  readonly ms: number[];
  readonly waiting: boolean;
  draw(yours: Yours, frame: Frame, clock?: 0 | 1 | 2): void;
  poll(): boolean;
  /** after each frame whose history is kept */
  turn(): void;
  free(): void;
}

export class Drawer {
  constructor(gl: WebGL2RenderingContext, ssgi: Ssgi);
  readonly dialect: '300ES';
  readonly language: 'GLSL';
  /** of the block "ssgi_frame" */
  binding: number;
  shader(desc: Desc, stage?: 'vert' | 'frag'): string;
  texture(width: number, height: number, format: { internal: number }, layers?: number): WebGLTexture;
  floats(rgba: Float32Array, width: number, height: number, layers?: number, given?: WebGLTexture | null): WebGLTexture;
  copy(texture: WebGLTexture, format: Format, width: number, height: number): WebGLTexture;
  read(texture: WebGLTexture, format: Format, width: number, height: number): Float32Array;
  free(texture: WebGLTexture): void;
  run(chain: Chain): Run;
  /** once its runs are freed */
  dispose(): void;
}
