/* model.mjs - reads a scene of make web, or an OBJ or glTF of the visitor's, and looks it over before it is shown. What
   cannot be shown is thrown as one sentence that names the file. Readers are fetched when they are wanted. */
import * as THREE from 'three';
import { fetchFile } from './fetch.mjs';
import { lambert } from './stage.mjs';

function fail(sentence) { throw new Error(sentence); }

/* A file of scenes.c. */
export async function readScene(path) {
    const file = await (await fetchFile(path)).arrayBuffer();
    const [vertices, indices] = new Uint32Array(file, 0, file.byteLength < 8 ? 0 : 2);
    const at = [8, 8 + 12 * vertices, 8 + 20 * vertices, 8 + 28 * vertices], end = at[3] + 4 * indices;
    if (file.byteLength !== end) fail(`${path}: is cut short or no scene; must be as make web writes it`);
    const geometry = new THREE.BufferGeometry();
    const fours = (Type, offset) => new THREE.InterleavedBufferAttribute(
        new THREE.InterleavedBuffer(new Type(file, offset, 4 * vertices), 4), 3, 0, true);
    geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(file, at[0], 3 * vertices), 3));
    geometry.setAttribute('normal', fours(Int16Array, at[1]));
    geometry.setAttribute('color', fours(Uint16Array, at[2]));
    geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(file, at[3], indices), 1));
    return new THREE.Mesh(geometry, lambert({ color: 0xffffff, vertexColors: true }));
}

/* ---- a file of the visitor's */

const load = which => import(`three/addons/loaders/${which}.js`);

/* Without its lines and points: the loader takes faces of the same object for more of them. */
async function parseObj(bytes) {
    const { OBJLoader } = await load('OBJLoader');
    return new OBJLoader().parse(new TextDecoder().decode(bytes).replace(/^[ \t]*[lp][ \t].*$/gm, ''));
}

/* The JSON of a .gltf, or of a .glb, whose first chunk it is. */
function gltfText(bytes) {
    const view = new DataView(bytes), binary = bytes.byteLength >= 20 && view.getUint32(0, true) === 0x46546c67;
    return new TextDecoder().decode(binary ? new Uint8Array(bytes, 20, view.getUint32(12, true)) : bytes);
}

/* Other files are not looked for: a name in this one would fetch what lies there on the server. */
async function parseGltf(bytes) {
    const { buffers = [], images = [] } = JSON.parse(gltfText(bytes));
    const elsewhere = [...buffers, ...images].find(({ uri }) => uri !== undefined && !/^data:/i.test(uri));
    if (elsewhere) fail(`${elsewhere.uri} is another file`);
    const { GLTFLoader } = await load('GLTFLoader');
    return (await new GLTFLoader().parseAsync(bytes, '')).scene;
}

const gltf = { parse: parseGltf, must: 'must be glTF 2.0, all of it in one file, without Draco, Meshopt or KTX2' };
const formats = { __proto__: null, gltf, glb: gltf,
                  obj: { parse: parseObj, must: 'must be an OBJ of vertices (v) and faces (f)' } };

/* What keeps a geometry from being drawn: a sentence, or null. */
function unsound({ attributes: { position, normal }, index }) {
    if (!position) return 'a mesh has no vertices; each must have some';
    for (const [what, list] of [['position', position], ['normal', normal]])
        for (let i = 0; i < (list?.count ?? 0); ++i)
            if (![list.getX(i), list.getY(i), list.getZ(i)].every(Number.isFinite))
                return `the ${what} of corner ${i + 1} is not there or not finite; must be three numbers`;
    for (let i = 0; i < (index?.count ?? 0); ++i)
        if (!(index.getX(i) < position.count))
            return `index ${i + 1} is ${index.getX(i)}; must be below ${position.count}, the number of vertices`;
    return null;
}

/* Triangles with materials that the G-buffer knows; lines and points, which nothing here lights, are left out. */
function prepare(model) {
    const parts = [];
    let triangles = 0;
    model.traverse(part => parts.push(part));
    for (const part of parts) {
        if (part.isLine || part.isPoints || part.isSprite) part.removeFromParent();
        if (!part.isMesh) continue;
        const { geometry } = part, wrong = unsound(geometry);
        if (wrong) fail(wrong);
        if (!geometry.attributes.normal) geometry.computeVertexNormals();
        geometry.computeBoundingBox();                  /* a glTF's are what it says they are */
        geometry.computeBoundingSphere();
        part.material = Array.isArray(part.material) ? part.material.map(lambert) : lambert(part.material);
        triangles += Math.floor((geometry.index ?? geometry.attributes.position).count / 3);
    }
    if (!triangles) fail('holds no triangles; must hold one at least');
}

/* Where float arithmetic has room for radii, planes and areas of such a scene. */
const narrowest = 1e-6, widest = 1e8;

/* On a floor, seen as a whole. */
function stagedOnFloor(model, title) {
    const box = new THREE.Box3().setFromObject(model), middle = box.getCenter(new THREE.Vector3());
    const wide = box.getSize(new THREE.Vector3()).length();
    if (wide === 0) fail('has all its corners in one place; must span some space');
    if (!(wide >= narrowest && wide <= widest))
        fail(`spans ${wide.toPrecision(2)} units; must span ${narrowest} to ${widest}`);
    const floor = new THREE.Mesh(new THREE.PlaneGeometry(5 * wide, 5 * wide).rotateX(-Math.PI / 2),
                                 lambert({ color: 0xe0e0e0 }));
    floor.position.set(middle.x, box.min.y, middle.z);
    const eye = new THREE.Vector3(0.4, 0.32, 0.9).normalize().multiplyScalar(1.25 * wide).add(middle);
    const info = { name: 'file', title, radius: wide / 10, fovy: 45, near: wide / 100, far: 10 * wide,
                   eye: eye.toArray(), target: middle.toArray() };
    return { model: new THREE.Group().add(model, floor), info };
}

/* { model, info } for Stage.show. */
export async function readFile(file) {
    const format = formats[/[^.]*$/.exec(file.name.toLowerCase())[0]];
    try {
        if (!format) fail('must be .obj, .glb or .gltf');
        const bytes = await file.arrayBuffer().catch(e => fail(`cannot be read: ${e.message}; must be a file`));
        const model = await format.parse(bytes).catch(e => fail(`cannot be read: ${e.message}; ${format.must}`));
        prepare(model);
        return stagedOnFloor(model, file.name);
    } catch (e) { throw new Error(`${file.name}: ${e.message}`, { cause: e }); }
}
