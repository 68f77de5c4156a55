/* webgpu-keys.mjs - names of translated texts, for the page and for what makes it. */

/* Counts are constants that a pipeline is given: texts that differ in nothing else are one. */
export const bare = glsl => glsl.replace(/^(layout\(constant_id = \d+\) const int \w+ =) .*;$/gm, '$1;');
export function keyOf(glsl) {                       /* [FNV-1a] */
    let hash = 0x811c9dc5;
    for (const c of bare(glsl)) hash = Math.imul(hash ^ c.charCodeAt(0), 0x01000193);
    return (hash >>> 0).toString(36);
}
