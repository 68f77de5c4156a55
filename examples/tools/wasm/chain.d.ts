import type { Plan } from 'ssgi/webgpu';

/** A chain that has a name, with its texts in WGSL. */
declare const chain: Plan;
export default chain;
