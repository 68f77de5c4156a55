import type { Plan } from 'ssgi/webgpu';

/** The chain of a method, with its texts in WGSL. */
declare const chain: Plan;
export default chain;
