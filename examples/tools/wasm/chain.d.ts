import type { Plan } from 'ssgi/webgpu';

/** The chain of a method, with its shaders in WGSL. */
declare const chain: Plan;
export default chain;
