/* reader.mjs - a worker that reads OBJ, which takes seconds if it is large. It gets { bytes } and answers { meshes,
   origin } or { error }. Meshes are relative to the origin. A worker has no import map, so make web writes URLs of
   files into three's loaders. */
import { originOf } from './origin.mjs';
import { OBJLoader } from './three/loaders/OBJLoader.js';

/* Removes an OBJ's lines and points: the loader would take later faces of the object for more of them. */
const faces = text => text.replace(/^[ \t]*[lp][ \t].*$/gm, '');

function meshesOf(text) {
    const meshes = [];
    new OBJLoader().parse(faces(text)).traverse(({ isMesh, geometry, material }) => {
        if (!isMesh) return;
        const attributes = Object.entries(geometry.attributes)
            .map(([name, { array, itemSize }]) => ({ name, array, itemSize }));
        meshes.push({ attributes, groups: geometry.groups,
                      materials: [material].flat().map(({ name, vertexColors }) => ({ name, vertexColors })),
                      many: Array.isArray(material) });
    });
    return meshes;
}

function boundsOf(meshes) {
    const lower = [Infinity, Infinity, Infinity], upper = [-Infinity, -Infinity, -Infinity];
    for (const { attributes } of meshes) {
        const { array } = attributes.find(({ name }) => name === 'position') ?? { array: [] };
        array.forEach((v, i) => {
            if (v < lower[i % 3]) lower[i % 3] = v;
            if (v > upper[i % 3]) upper[i % 3] = v;
        });
    }
    return [lower, upper];
}

/* Subtracts an origin from an OBJ's vertices in the text, because the loader rounds them to floats. */
const moved = (text, [x, y, z]) => text.replace(/\\\r?\n/g, ' ')
    .replace(/^([ \t]*v[ \t]+)(\S+)([ \t]+)(\S+)([ \t]+)([^\s#]+)/gm,
             (_, v, a, b, c, d, e) => v + (a - x) + b + (c - y) + d + (e - z));

/* Reads an OBJ; if it is far from 0, again about its middle, perhaps twice, because floats find the middle roughly. */
function read(text) {
    const origin = [0, 0, 0];
    let meshes = meshesOf(text);
    for (let turn = 0; turn < 2; ++turn) {
        const by = originOf(...boundsOf(meshes));
        if (!by.some(v => v)) break;
        by.forEach((v, i) => { origin[i] += v; });
        meshes = meshesOf(moved(text, origin));
    }
    return { meshes, origin };
}

onmessage = ({ data: { bytes } }) => {
    try {
        const { meshes, origin } = read(new TextDecoder().decode(bytes));
        postMessage({ meshes, origin }, meshes.flatMap(mesh => mesh.attributes.map(({ array }) => array.buffer)));
    } catch (e) { postMessage({ error: e.message }); }
};
