/* model.mjs - reads a scene of make web, or the visitor's files: OBJ or glTF with the files that they name, a sky as
   HDR or EXR; and checks them before they are shown. A file that cannot be shown is an error of one sentence that names
   the file. Readers are fetched when they are first needed. */
import * as THREE from 'three';
import { fetchFile } from './fetch.mjs';
import { finish, placesOf } from './finishes.mjs';
import { floatsAt, gapSaid, originOf } from './origin.mjs';
import { skyOf } from './sky.mjs';
import { lambert } from './stage.mjs';

function fail(sentence) { throw new Error(sentence); }

/* Reads a file that scenes.c wrote. */
export async function readScene(path) {
    const file = await (await fetchFile(path)).arrayBuffer();
    const [vertices, indices] = new Uint32Array(file, 0, file.byteLength < 8 ? 0 : 2);
    const at = [8, 8 + 12 * vertices, 8 + 20 * vertices, 8 + 28 * vertices], end = at[3] + 4 * indices;
    if (file.byteLength !== end) fail(`${path}: is cut short or no scene; must be as make web writes it`);
    const geometry = new THREE.BufferGeometry();
    const fours = (Type, offset) => new THREE.InterleavedBufferAttribute(
        new THREE.InterleavedBuffer(new Type(file, offset, 4 * vertices), 4), 3, 0, true);
    geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(file, at[0], 3 * vertices), 3));
    geometry.setAttribute('color', fours(Uint16Array, at[2]));
    geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(file, at[3], indices), 1));
    if (new Int16Array(file, at[1], 4 * vertices).some(v => v))
        geometry.setAttribute('normal', fours(Int16Array, at[1]));
    else geometry.computeVertexNormals();                       /* of a scan */

    const index = new Uint32Array(file, at[3], indices), covers = new Uint16Array(file, at[2], 4 * vertices);
    const numberOf = i => covers[4 * index[i] + 3], model = new THREE.Group(), parts = new Map();
    for (let i = 0; i < indices; i += 3) {
        const number = numberOf(i);
        if (!parts.has(number)) parts.set(number, []);
        parts.get(number).push(index[i], index[i + 1], index[i + 2]);
    }
    for (const [number, corners] of parts) {
        const { span, map } = number ? finish(number) : {};
        let part = new THREE.BufferGeometry();
        for (const name in geometry.attributes) part.setAttribute(name, geometry.attributes[name]);
        part.setIndex(corners);
        if (map) {
            part = part.toNonIndexed();
            const { position } = part.attributes;
            const at = corners.map((_, i) => new THREE.Vector3().fromBufferAttribute(position, i));
            const places = at.flatMap((_, i) => (i % 3 ? [] : placesOf(at.slice(i, i + 3), span)));
            part.setAttribute('uv', new THREE.Float32BufferAttribute(places.flat(), 2));
        }
        model.add(new THREE.Mesh(part, lambert({ color: 0xffffff, vertexColors: true, map })));
    }
    return model;
}

/* ---- files of the visitor's */

const load = which => import(`three/addons/${which}.js`);
const baseOf = path => path.replace(/^.*[/\\]/, '').toLowerCase();
const kindOf = ({ name }) => /[^.]*$/.exec(name.toLowerCase())[0];

/* Returns a file's bytes; calls progress with the share that is read. */
async function bytesOf(file, progress) {
    const bytes = new Uint8Array(file.size), reader = file.stream().getReader();
    for (let at = 0; ;) {
        const { done, value } = await reader.read();
        if (done) break;
        bytes.set(value, at);
        progress((at += value.length) / file.size);
    }
    return bytes;
}

/* The files that were dropped together with a model, by the names that the model uses. */
class Beside {
    #files = new Map(); #addresses = [];
    failed = [];

    constructor(files) { for (const file of files) this.#files.set(baseOf(file.name), file); }

    find(path) {
        let name = path;
        try { name = decodeURIComponent(path); } catch { /* as it stands */ }
        return this.#files.get(baseOf(name)) ?? this.#files.get(baseOf(path));
    }

    /* Returns three.js' manager of URLs, by which its loaders find these files. */
    manager() {
        const manager = new THREE.LoadingManager(), names = new Map();
        manager.setURLModifier(url => {
            if (/^(data|blob):/i.test(url)) return url;
            const file = this.find(url), address = file ? URL.createObjectURL(file) : 'data:,';
            if (file) this.#addresses.push(address);
            names.set(address, file?.name);
            return address;
        });
        manager.onError = url => { if (url !== 'data:,') this.failed.push(names.get(url) ?? 'a picture within'); };
        return manager;
    }
    close() { this.#addresses.forEach(address => URL.revokeObjectURL(address)); }
}

/* ---- OBJ */

function inWorker(bytes) {
    return new Promise((resolve, reject) => {
        const worker = new Worker(new URL('reader.mjs', import.meta.url), { type: 'module' });
        const end = how => value => { worker.terminate(); how(value); };
        worker.onmessage = ({ data }) => (data.error ? end(reject)(new Error(data.error)) : end(resolve)(data));
        worker.onerror = e => end(reject)(new Error(e.message ?? 'its reader failed'));
        worker.postMessage({ bytes }, [bytes.buffer]);
    });
}

/* Returns the materials of the MTL files that an OBJ names and that are there; adds a note for each that is missing. */
async function materialsOf(text, beside, notes) {
    const names = [...text.matchAll(/^[ \t]*mtllib[ \t]+(.+?)[ \t\r]*$/gm)].map(([, name]) => name), all = new Map();
    if (!names.length) return all;
    const { MTLLoader } = await load('loaders/MTLLoader');
    for (const name of names) {
        const file = beside.find(name), manager = beside.manager();
        if (!file) { notes.push(`${name} is not beside it: drop both together for its materials`); continue; }
        const library = await file.text();
        const pictures = library.matchAll(/^[ \t]*(?:map_Kd|map_Bump|bump|norm)[ \t]+(?:.*[ \t])?(\S+)[ \t\r]*$/gmi);
        for (const picture of new Set([...pictures].map(([, name]) => name)))
            if (!beside.find(picture)) notes.push(`${picture} is not beside it: drop all together`);
        const come = new Promise(done => { manager.onLoad = done; });
        manager.itemStart('library');                   /* so that the manager ends only after the last texture */
        const made = new MTLLoader(manager).parse(library, '');
        made.preload();
        manager.itemEnd('library');
        await come;
        for (const [id, material] of Object.entries(made.materials)) {
            if (material.map && !material.map.image?.width) material.map = null;
            all.set(id, material);
        }
    }
    return all;
}

async function parseObj(bytes, beside, notes) {
    /* lines of the OBJ name the MTL files; of a large OBJ only the beginning is searched */
    const text = new TextDecoder().decode(bytes.subarray(0, 1 << 20));
    const materials = await materialsOf(text, beside, notes), model = new THREE.Group();
    const own = ({ name, vertexColors }) => Object.assign(
        (materials.get(name) ?? new THREE.MeshLambertMaterial({ color: 0xc8c2ba })).clone(), { vertexColors });
    const { meshes, origin } = await inWorker(bytes);
    for (const { attributes, groups, materials: named, many } of meshes) {
        const geometry = new THREE.BufferGeometry();
        for (const { name, array, itemSize } of attributes)
            geometry.setAttribute(name, new THREE.BufferAttribute(array, itemSize));
        geometry.groups = groups;
        model.add(new THREE.Mesh(geometry, many ? named.map(own) : own(named[0])));
    }
    return { model, about: origin };
}

/* ---- glTF */

/* Returns the JSON of a .gltf, or of a .glb, whose first chunk it is. */
function gltfText(bytes) {
    const view = new DataView(bytes.buffer), binary = bytes.length >= 20 && view.getUint32(0, true) === 0x46546c67;
    return new TextDecoder().decode(binary ? bytes.subarray(20, 20 + view.getUint32(12, true)) : bytes);
}

/* Parses a glTF. Files that were not dropped are refused: their names could otherwise be fetched from the server. */
async function parseGltf(bytes, beside) {
    const { buffers = [], images = [], extensionsRequired = [], extensionsUsed = [] } = JSON.parse(gltfText(bytes));
    const away = [...buffers, ...images].map(({ uri }) => uri)
        .find(uri => uri !== undefined && !/^data:/i.test(uri) && (/^\w+:/.test(uri) || !beside.find(uri)));
    if (away) fail(`${away} is another file that is not beside it; drop all together`);
    if (extensionsRequired.includes('KHR_texture_basisu')) fail('its pictures are KTX2, which nothing here reads');
    const { GLTFLoader } = await load('loaders/GLTFLoader'), loader = new GLTFLoader(beside.manager());
    let draco = null;
    if (extensionsUsed.includes('KHR_draco_mesh_compression')) {
        const { DRACOLoader } = await load('loaders/DRACOLoader');
        draco = new DRACOLoader().setDecoderPath(new URL('three/libs/draco/gltf/', import.meta.url).href);
        loader.setDRACOLoader(draco);
    }
    if (extensionsUsed.some(name => /_meshopt_compression$/.test(name)))
        loader.setMeshoptDecoder((await load('libs/meshopt_decoder.module')).MeshoptDecoder);
    try { return { model: (await loader.parseAsync(bytes.buffer, '')).scene }; } finally { draco?.dispose(); }
}

/* ---- skies */

async function readSky(file, kind, progress) {
    const name = kind === 'hdr' ? 'HDRLoader' : 'EXRLoader', Loader = (await load(`loaders/${name}`))[name];
    const bytes = await bytesOf(file, progress);
    let is;
    try { is = new Loader().setDataType(THREE.FloatType).parse(bytes.buffer); }
    catch (e) { fail(`cannot be read: ${plain(e)}; must be ${kind === 'hdr' ? 'a Radiance HDR' : 'an OpenEXR'}`); }
    const { width, height, data } = is ?? {};
    if (!data || data.length !== 4 * width * height) fail('must have R, G and B');
    if (Math.abs(width / height - 2) > 0.1)
        fail(`is ${width} x ${height}; must be a latitude-longitude picture, twice as wide as high`);
    if (!is.flipY)                                      /* bottom row first */
        for (let y = 0, row = 4 * width; y < height >> 1; ++y) {
            const above = data.slice(y * row, (y + 1) * row), below = (height - 1 - y) * row;
            data.copyWithin(y * row, below, below + row);
            data.set(above, below);
        }
    return skyOf(data, { width, height }, 256, 128);
}

const plain = e => String(e?.message ?? e).replace(/^THREE\.\w+: /, '').replace(/[.\s]+$/, '');

const gltf = { parse: parseGltf, must: 'must be glTF 2.0, dropped with the files that it names' };
const formats = { __proto__: null, gltf, glb: gltf,
                  obj: { parse: parseObj, must: 'must be an OBJ of vertices (v) and faces (f)' } };
const skyKinds = ['hdr', 'exr'];

/* Returns why a geometry cannot be drawn as a sentence, or null. */
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

/* Gives triangles materials for the G-buffer; removes lines and points, which nothing here lights. */
function prepare(model, notes) {
    const parts = [];
    let triangles = 0, emits = false;
    model.traverse(part => parts.push(part));
    for (const part of parts) {
        if (part.isLine || part.isPoints || part.isSprite) part.removeFromParent();
        if (!part.isMesh) continue;
        const { geometry } = part, wrong = unsound(geometry);
        if (wrong) fail(wrong);
        if (!geometry.attributes.normal) geometry.computeVertexNormals();
        geometry.computeBoundingBox();                  /* a glTF's own bounds may be wrong */
        geometry.computeBoundingSphere();
        emits ||= [part.material].flat().some(m => m.emissiveIntensity > 0 && m.emissive?.toArray().some(v => v > 0));
        part.material = Array.isArray(part.material) ? part.material.map(m => lambert(m, 2))
            : lambert(part.material, 2);
        triangles += Math.floor((geometry.index ?? geometry.attributes.position).count / 3);
    }
    if (!triangles) fail('holds no triangles; must hold one at least');
    if (emits) notes.push('its materials emit light, which is not shown');
}

/* Returns the largest spacing of floats at the meshes' vertices, in world space. */
function gapIn(model) {
    let most = 0;
    model.traverse(({ isMesh, geometry, matrixWorld }) => {
        if (!isMesh) return;
        const { min, max } = geometry.boundingBox;
        const gaps = ['x', 'y', 'z'].map(i => floatsAt(Math.max(-min[i], max[i])));
        const rows = [0, 1, 2].map(row => gaps.map((gap, i) => Math.abs(matrixWorld.elements[4 * i + row]) * gap));
        most = Math.max(most, ...rows.map(row => row.reduce((a, b) => a + b)));
    });
    return most;
}

/* Moves the vertices of meshes far from their own 0 there: if a matrix moved them, they would be as coarse. */
function moveVertices(model) {
    const moved = new Map();
    model.traverse(part => {
        const { geometry, position, scale, quaternion } = part, floats = geometry?.attributes.position;
        if (!part.isMesh || part.isSkinnedMesh || !(floats.array instanceof Float32Array)) return;
        if (!moved.has(geometry)) {
            const by = originOf(geometry.boundingBox.min.toArray(), geometry.boundingBox.max.toArray());
            moved.set(geometry, new THREE.Vector3(...by));
            if (!by.some(v => v)) return;
            geometry.setAttribute('position', floats.clone());           /* others may share them */
            geometry.translate(...by.map(v => 0 - v));
        }
        const by = moved.get(geometry);
        position.add(by.clone().multiply(scale).applyQuaternion(quaternion));
        for (const child of part.children) child.position.sub(by);
    });
}

/* Moves a model that is far from 0 to 0, in doubles, as three's matrices are. about: the origin that its reader has
   subtracted already. Returns the point of the file that is now at 0. */
function approach({ model, about = [0, 0, 0] }, notes) {
    const box = new THREE.Box3().setFromObject(model);
    const by = originOf(box.min.toArray(), box.max.toArray()), origin = about.map((v, i) => v + by[i]);
    const gap = gapSaid(gapIn(model), box.getSize(new THREE.Vector3()).length());
    if (gap) moveVertices(model);
    model.position.sub(new THREE.Vector3(...by));
    model.updateMatrixWorld(true);
    if (gap) notes.push(gap);
    if (origin.some(v => v)) notes.push(`it lies far from 0 beside its size, and is shown about ${origin.join()}`);
    return origin;
}

/* Limits of a scene's diagonal: floats must hold its radii, planes and areas. */
const narrowest = 1e-6, widest = 1e8;

/* Puts a model on a floor, with a camera that sees all of it. */
function stagedOnFloor(read, title, notes) {
    const origin = approach(read, notes), { model } = read;
    const box = new THREE.Box3().setFromObject(model), middle = box.getCenter(new THREE.Vector3());
    const wide = box.getSize(new THREE.Vector3()).length();
    if (wide === 0) fail('has all its corners in one place; must span some space');
    if (!(wide >= narrowest && wide <= widest))
        fail(`spans ${wide.toPrecision(2)} units; must span ${narrowest} to ${widest}`);
    const floor = new THREE.Mesh(new THREE.PlaneGeometry(5 * wide, 5 * wide).rotateX(-Math.PI / 2),
                                 lambert({ color: 0xb4b4b4 }));
    floor.position.set(middle.x, box.min.y, middle.z);
    floor.userData.ground = true;                       /* shadows nothing */
    const eye = new THREE.Vector3(0.4, 0.32, 0.9).normalize().multiplyScalar(1.25 * wide).add(middle);
    const info = { name: 'file', title, origin, radius: wide / 10, fovy: 45, near: wide / 100, far: 10 * wide,
                   eye: eye.toArray(), target: middle.toArray() };
    return { model: new THREE.Group().add(model, floor), info };
}

async function readModel(file, beside, progress, notes) {
    const format = formats[kindOf(file)];
    const bytes = await bytesOf(file, progress).catch(e => fail(`cannot be read: ${e.message}; must be a file`));
    const read = await format.parse(bytes, beside, notes)
        .catch(e => fail(`cannot be read: ${plain(e)}; ${format.must}`));
    const [broken] = beside.failed;
    if (broken) fail(`${broken} cannot be read; must be a picture that the browser shows`);
    prepare(read.model, notes);
    return stagedOnFloor(read, file.name, notes);
}

/* Reads dropped or chosen files. Returns { staged: { model, info } for Stage.show, sky, notes }. */
export async function readFiles(files, progress) {
    const model = files.find(file => formats[kindOf(file)]), sky = files.find(file => skyKinds.includes(kindOf(file)));
    const beside = new Beside(files), notes = [], read = { staged: null, sky: null, notes };
    const console = THREE.getConsoleFunction();         /* the page shows one sentence instead */
    THREE.setConsoleFunction(() => {});
    const about = async (file, body) => {
        try { return await body(); } catch (e) { throw new Error(`${file.name}: ${plain(e)}`, { cause: e }); }
    };
    try {
        if (!model && !sky) await about(files[0], () => fail('must be .obj, .glb, .gltf, .hdr or .exr'));
        if (model) {
            read.staged = await about(model, () => readModel(model, beside, progress, notes));
            notes.forEach((note, i) => { notes[i] = `${model.name}: ${note}`; });
        }
        if (sky) read.sky = await about(sky, () => readSky(sky, kindOf(sky), progress));
        return read;
    } finally {
        beside.close();
        THREE.setConsoleFunction(console);
    }
}
