import type { Chain, Desc, Format, Frame, Ssgi, Step } from 'ssgi';

/** Your textures by their meanings (Input.meaning), and other inputs of steps. */
export interface Yours {
  [meaning: string]: WebGLTexture | null | undefined | WebGLFramebuffer | WebGLVertexArrayObject | number;
  /** the framebuffer that desc.onto draws onto; default: the canvas */
  PICTURE?: WebGLFramebuffer | null;
  array?: WebGLVertexArrayObject;
  instances?: number;
}

/** A chain with its targets, of one size. */
export interface Run {
  readonly chain: Chain;
  readonly steps: Step[];
  /** ambient visibility, or light over pi; the bounce, to be added to it */
  readonly light: WebGLTexture | null;
  readonly format: Format | null;
  readonly bounce: WebGLTexture | null;
  /** its programs are linked, so draw() does not wait */
  readonly linked: boolean;
  /** of each step; new if poll() has returned true */
  readonly ms: number[];
  readonly waiting: boolean;
  draw(yours: Yours, frame: Frame, clock?: 0 | 1 | 2): void;
  poll(): boolean;
  /** call it after each frame whose history is kept */
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
  /** call it after its runs are freed */
  dispose(): void;
}
