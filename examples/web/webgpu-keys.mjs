/* webgpu-keys.mjs - the names of translated shaders' files, for the page and for make web. */

/* Removes the values of constants, which a pipeline sets: shaders that differ in nothing else share a file. */
export const bare = glsl => glsl.replace(/^(layout\(constant_id = \d+\) const int \w+ =) .*;$/gm, '$1;');
export function keyOf(glsl) {                       /* [FNV-1a] */
    let hash = 0x811c9dc5;
    for (const c of bare(glsl)) hash = Math.imul(hash ^ c.charCodeAt(0), 0x01000193);
    return (hash >>> 0).toString(36);
}
