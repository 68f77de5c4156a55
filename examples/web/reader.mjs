/* reader.mjs - a worker that reads OBJ, which takes seconds for a large one: { bytes } comes, { meshes } or { error }
   goes back. A worker knows no import map: make web writes addresses of files into three's loaders. */
import { OBJLoader } from './three/loaders/OBJLoader.js';

/* Without its lines and points: the loader takes faces of the same object for more of them. */
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

onmessage = ({ data: { bytes } }) => {
    try {
        const meshes = meshesOf(new TextDecoder().decode(bytes));
        postMessage({ meshes }, meshes.flatMap(mesh => mesh.attributes.map(({ array }) => array.buffer)));
    } catch (e) { postMessage({ error: e.message }); }
};
