/* web-hostile.mjs - what the page and the loader are given that is wrong: addresses, models, arguments. For web.mjs. */
import { halves, methods, normals, presets, settings, thicknesses, views } from '../examples/web/settings.mjs';
import { skies } from '../examples/web/sky.mjs';

/* ---- addresses */

const inherited = ['constructor', '__proto__', 'toString', 'valueOf', 'hasOwnProperty', '__defineGetter__',
                   'prototype'];
const bad = [...inherited,
             'NaN', 'Infinity', '-Infinity', '1e999', '-1e999', '1e308', '9007199254740993', '-0', '0x10', '2', '-7',
             '+1', '', ' ', '%', '%E0%A4%A', '%00', '%0A', '%F0%9F%98%80', '😀', '\ud800', 'x'.repeat(300),
             'null', 'undefined', 'true', '<b>', '../..', 'file', 'cornell', 'ssdo', 'dss', 'aof', 'off', 'BEST', '0',
             '1', 'auto', '16x16', '9999x9999', '0x0', '1x1', '-5x5', '8x9000', '99999999999x1', '1e3x10',
             '0,0,0,0,0,0', 'NaN,0,0,0,0,0', '1e300,0,0,1,1,1', '1,2,3', '0,5,0,0,0,0', '1e9,5,0,1e9,0,0',
             '1,2,3,4,5,6,7'];
const names = [...Object.keys(settings), ...inherited, 'nobody', '', '😀', '%', 'A', 'scene[]'];

/* n hashes, the same for the same seed [mulberry32]. */
export function hashes(n, seed) {
    const random = () => {
        seed = seed + 0x6d2b79f5 | 0;
        let t = Math.imul(seed ^ seed >>> 15, 1 | seed);
        t = t + Math.imul(t ^ t >>> 7, 61 | t) ^ t;
        return ((t ^ t >>> 14) >>> 0) / 4294967296;
    };
    const below = most => Math.floor(random() * most), one = list => list[below(list.length)];
    const unit = () => below(random() < 0.8 ? 128 : 65536);
    const junk = () => String.fromCharCode(...Array.from({ length: below(30) }, unit));
    const joint = () => (random() < 0.9 ? '=' : one(['', '==', '&']));
    const value = () => (random() < 0.85 ? one(bad) : junk());
    const pair = () => one(names) + joint() + value();
    const hash = () => {
        if (random() < 0.05) return junk();
        const pairs = Array.from({ length: random() < 0.02 ? 400 : below(6) }, pair);
        return (random() < 0.2 ? [...pairs, ...pairs] : pairs).join('&');
    };
    return Array.from({ length: n }, hash);
}

/* What is wrong with settings, by other means than they were read; or null. */
export function unsound(set, { scenes, sky = false, side, pixels }) {
    const words = { scene: scenes, sky: [...Object.keys(skies), ...(sky ? ['file'] : [])], view: views,
                    a: Object.keys(methods),
                    b: [...Object.keys(methods), 'truth', 'off'], p: Object.keys(presets), q: Object.keys(presets),
                    thickness: Object.keys(thicknesses), normals: Object.keys(normals), half: Object.keys(halves) };
    const ranges = { radius: [-2, 2], thickness_limit: [-1, 2], split: [0, 1], azimuth: [-180, 180], height: [0, 90],
                     strength: [0, 4], exposure: [-3, 3], effect: [0, 3], slices: [0, 32], steps: [0, 32],
                     filter: [-1, 4], surfel: [0, 6], levels: [0, 7], field: [0, 64], reach: [0.1, 1] };
    const flags = ['sun', 'history', 'bounce', 'truth', 'moves', 'circle'], cam = set.cam.split(',').map(Number);
    const [width, height] = set.size.split('x').map(Number);
    if (Object.keys(set).sort().join() !== Object.keys(settings).sort().join()) return `has ${Object.keys(set)}`;
    for (const [name, list] of Object.entries(words)) if (!list.includes(set[name])) return `${name}=${set[name]}`;
    for (const [name, [least, most]] of Object.entries(ranges))
        if (!(typeof set[name] === 'number' && set[name] >= least && set[name] <= most)) return `${name}=${set[name]}`;
    for (const name of ['slices', 'steps', 'filter', 'levels', 'field'])
        if (!Number.isInteger(set[name])) return `${name}=${set[name]}`;
    for (const name of flags) if (typeof set[name] !== 'boolean') return `${name}=${set[name]}`;
    if (set.cam && !(cam.length === 6 && cam.every(v => Math.abs(v) <= 1e9))) return `cam=${set.cam}`;
    const fits = width >= 16 && height >= 16 && width <= side && height <= side && width * height <= pixels;
    return set.size === 'auto' || fits ? null : `size=${set.size}`;
}

/* ---- models: name, text or bytes, what is said of it */

const triangle = (...corners) => `${corners.map(at => `v ${at}\n`).join('')}f 1 2 3\n`;
const gltf = more => JSON.stringify({ asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }],
                                      nodes: [{ mesh: 0 }], ...more });
/* A triangle of these indices, a line, bounds that are not theirs. */
export function indexed(...indices) {
    const bytes = new Uint8Array(36 + 2 * indices.length);
    bytes.set(new Uint8Array(Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0).buffer));
    bytes.set(new Uint8Array(Uint16Array.from(indices).buffer), 36);
    const uri = `data:application/octet-stream;base64,${btoa(String.fromCharCode(...bytes))}`;
    return gltf({
        buffers: [{ byteLength: bytes.length, uri }],
        bufferViews: [{ buffer: 0, byteLength: 36 }, { buffer: 0, byteOffset: 36, byteLength: 2 * indices.length }],
        accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [0, 0, 0], max: [0, 0, 0] },
                    { bufferView: 1, componentType: 5123, count: indices.length, type: 'SCALAR' }],
        meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 },
                                { attributes: { POSITION: 0 }, mode: 1 }] }]
    });
}

export const wedge = (scale, place = [0, 0, 0]) => [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    .map(at => `v ${at.map((v, i) => v * scale + place[i]).join(' ')}\n`).join('')
    + 'f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n';
/* The same by a node that stands there, as a glTF; it glows. east: its own floats begin there. */
export function glowingWedge(place, east = 0) {
    const bytes = new Uint8Array(72);
    bytes.set(new Uint8Array(Float32Array.of(east, 0, 0, east + 1, 0, 0, east, 1, 0, east, 0, 1).buffer));
    bytes.set(new Uint8Array(Uint16Array.of(0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3).buffer), 48);
    return gltf({
        nodes: [{ translation: place, children: [1] }, { mesh: 0 }], materials: [{ emissiveFactor: [0.001, 0, 0] }],
        buffers: [{ byteLength: 72,
                    uri: `data:application/octet-stream;base64,${btoa(String.fromCharCode(...bytes))}` }],
        bufferViews: [{ buffer: 0, byteLength: 48 }, { buffer: 0, byteOffset: 48, byteLength: 24 }],
        accessors: wedgeAccessors(bufferView => ({ bufferView })),
        meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1, material: 0 }] }]
    });
}

/* Of one brightness; rows without run lengths. */
export function hdr(width, height, value) {
    const head = new TextEncoder().encode(`#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ${height} +X ${width}\n`);
    const bytes = new Uint8Array(head.length + 4 * width * height);
    bytes.set(head);
    for (let i = head.length; i < bytes.length; i += 4) bytes.set([value, value, value, value && 129], i);
    return bytes;
}

/* The corners of the wedge and its faces, as the npm packages draco3d 1.5.7 and meshoptimizer 0.22.0 packed them. */
const packed = text => Uint8Array.from(atob(text), c => c.charCodeAt(0));
const dracoMesh = packed('RFJBQ08CAgEBAAAABAQAAwAAAS8BARAB/wAAAQAJAwAAAgEBAQADAwEQATADAFCCJJEEAAAAAP8DAAAAAAAAAAAAAAAA'
    + 'AAAAAIA/Cg==');
const meshoptCorners = packed('oAAAATwAAAD//wE8AAAAfn0AAAEPAAAA//8BDwAAAH59AAABAwAAAP8BAwAAAH4AAAAAAAAAAAAAAAAA'
    + 'AAAAAAAAAAAAAAAAAAAAAAAAAA==');
const meshoptFaces = packed('4f4OAhHwBAB2h1ZneKmGZYlomAFpAAA=');

function glb(json, ...parts) {
    const pad = (bytes, with_) => [...bytes, ...Array(-bytes.length & 3).fill(with_)];
    const text = pad(new TextEncoder().encode(json), 32), bin = parts.flatMap(part => pad(part, 0));
    const words = (...all) => [...new Uint8Array(Uint32Array.from(all).buffer)];
    return Uint8Array.from([...words(0x46546c67, 2, 28 + text.length + bin.length, text.length, 0x4e4f534a), ...text,
                            ...words(bin.length, 0x4e4942), ...bin]);
}
const wedgeAccessors = of => [
    { ...of(0), componentType: 5126, count: 4, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 1] },
    { ...of(1), componentType: 5123, count: 12, type: 'SCALAR' }];
const extension = name => ({ extensionsUsed: [name], extensionsRequired: [name] });
export const draco = glb(gltf({
    ...extension('KHR_draco_mesh_compression'),
    buffers: [{ byteLength: dracoMesh.length }], bufferViews: [{ buffer: 0, byteLength: dracoMesh.length }],
    accessors: wedgeAccessors(() => ({})),
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1, extensions: {
        KHR_draco_mesh_compression: { bufferView: 0, attributes: { POSITION: 0 } } } }] }]
}), dracoMesh);
const after = meshoptCorners.length + (-meshoptCorners.length & 3);
const opt = (byteOffset, byteLength, byteStride, count, mode) =>
    ({ EXT_meshopt_compression: { buffer: 0, byteOffset, byteLength, byteStride, count, mode } });
export const meshopt = glb(gltf({
    ...extension('EXT_meshopt_compression'),
    buffers: [{ byteLength: after + meshoptFaces.length },
              { byteLength: 72, extensions: { EXT_meshopt_compression: { fallback: true } } }],
    bufferViews: [{ buffer: 1, byteLength: 48, byteStride: 12,
                    extensions: opt(0, meshoptCorners.length, 12, 4, 'ATTRIBUTES') },
                  { buffer: 1, byteOffset: 48, byteLength: 24,
                    extensions: opt(after, meshoptFaces.length, 2, 12, 'TRIANGLES') }],
    accessors: wedgeAccessors(bufferView => ({ bufferView })),
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }]
}), meshoptCorners, meshoptFaces);

export const models = [
    ['empty.obj', '', 'empty.obj: holds no triangles; must hold one at least'],
    ['point.obj', 'v 0 0 0\np 1\n', 'point.obj: holds no triangles; must hold one at least'],
    ['vertex.obj', 'v 1 2 3\n', 'vertex.obj: holds no triangles; must hold one at least'],
    ['line.obj', 'v 0 0 0\nv 1 0 0\nl 1 2\n', 'line.obj: holds no triangles; must hold one at least'],
    ['nan.obj', triangle('0 0 0', '1 0 nan', '0 1 0'),
     'nan.obj: the position of corner 2 is not there or not finite; must be three numbers'],
    ['inf.obj', triangle('0 0 0', '1 0 1e39', '0 1 0'),
     'inf.obj: the position of corner 2 is not there or not finite; must be three numbers'],
    ['range.obj', triangle('0 0 0', '1 0 0'),
     'range.obj: the position of corner 3 is not there or not finite; must be three numbers'],
    ['normal.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 nan\nf 1//1 2//1 3//1\n',
     'normal.obj: the normal of corner 1 is not there or not finite; must be three numbers'],
    ['place.obj', triangle('1 1 1', '1 1 1', '1 1 1'),
     'place.obj: has all its corners in one place; must span some space'],
    ['wide.obj', wedge(1e30), 'wide.obj: spans 1.7e+30 units; must span 0.000001 to 100000000'],
    ['narrow.obj', wedge(1e-20), 'narrow.obj: spans 1.7e-20 units; must span 0.000001 to 100000000'],
    ['index.gltf', indexed(0, 1, 7), 'index.gltf: index 3 is 7; must be below 3, the number of vertices'],
    ['cut.glb', 'glTF', /^cut\.glb: cannot be read: .+; must be glTF 2\.0, dropped with the files that it names$/],
    ['cut.gltf', '{', /^cut\.gltf: cannot be read: .+; must be glTF 2\.0/],
    ['list.gltf', '[]', /^list\.gltf: cannot be read: .+; must be glTF 2\.0/],
    ['old.gltf', '{"asset":{"version":"1.0"}}', /^old\.gltf: cannot be read: .+; must be glTF 2\.0/],
    ['parts.gltf', gltf({ buffers: [{ uri: 'parts.bin', byteLength: 36 }] }),
     /^parts\.gltf: cannot be read: parts\.bin is another file that is not beside it; drop all together; must/],
    ['far.gltf', gltf({ images: [{ uri: 'https://example.com/a.png' }] }),
     /^far\.gltf: cannot be read: https:\/\/example\.com\/a\.png is another file that is not beside it; drop/],
    ['text.txt', 'hello', 'text.txt: must be .obj, .glb, .gltf, .hdr or .exr'],
    ['constructor', '', 'constructor: must be .obj, .glb, .gltf, .hdr or .exr'],
    ['x.__proto__', '', 'x.__proto__: must be .obj, .glb, .gltf, .hdr or .exr'],
    ['cut.hdr', '#?RADIANCE\n', /^cut\.hdr: cannot be read: .+; must be a Radiance HDR$/],
    ['text.hdr', 'hello', /^text\.hdr: cannot be read: .+; must be a Radiance HDR$/],
    ['text.exr', 'hello', /^text\.exr: cannot be read: .+; must be an OpenEXR$/],
    ['square.hdr', hdr(8, 8, 128), 'square.hdr: is 8 x 8; must be a latitude-longitude picture, twice as wide as high'],
    ['black.hdr', hdr(16, 8, 0), 'black.hdr: is black; must send light'],
    ['bad.glb', draco.slice(0, -40), /^bad\.glb: cannot be read: .+; must be glTF 2\.0/],
    ['basis.gltf', gltf({ extensionsRequired: ['KHR_texture_basisu'] }),
     /^basis\.gltf: cannot be read: its pictures are KTX2, which nothing here reads; must/]
];

/* ---- arguments of ssgi.mjs: a call, what it says */

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const projection = [1.3, 0, 0, 0, 0, 2.4, 0, 0, 0, 0, -1.002, -1, 0, 0, -0.2002, 0];
const corners = [0, 0, 0, 1, 0, 0, 0, 1, 0];

/* A list of 16 that iterates over more. */
const endless = list => Object.assign(list, { length: 16, *[Symbol.iterator]() { yield* new Array(1e5).fill(1); } });

export function calls({ load, Ssgi }, ssgi) {
    const nothing = identity.map(() => NaN), rgb = new Float32Array(3 * 8 * 4).fill(1), hsao = { pass: 'HSAO' };
    const view = ssgi.view(projection, 64, 48), frame = ssgi.frame(view, 0.5), trace = ssgi.trace(corners);
    const up = [0, 0, 1], here = [0.2, 0.2, -1], bytes = Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0);
    return [
        [() => load(null), 'source: must be a URL, bytes or a WebAssembly.Module'],
        [() => load('gone.wasm'), /^gone\.wasm: cannot be read: /],
        [() => load(new URL('file:///gone.wasm')), /^file:\/\/\/gone\.wasm: cannot be read: /],
        [() => load(Uint8Array.of(1, 2, 3)), /^source: must be the ssgi\.wasm that make wasm builds: /],
        [() => load(bytes), 'exports: must be those of ssgi.wasm, its memory among them'],
        [() => new Ssgi(), 'exports: must be those of ssgi.wasm, its memory among them'],
        [() => new Ssgi({ __heap_base: { value: 0 }, ssgi_wasm_place_at: () => 0 }),
         'exports: must be those of ssgi.wasm, its memory among them'],
        [() => ssgi.text(), 'desc: must be an object'],
        [() => ssgi.check('HSAO'), 'desc: must be an object'],
        [() => ssgi.key([]), 'desc: must be an object'],
        [() => ssgi.text({ ...hsao, constructor: 1 }), 'desc.constructor: there is no such field'],
        [() => ssgi.text(JSON.parse('{"pass":"HSAO","__proto__":1}')), 'desc.__proto__: there is no such field'],
        [() => ssgi.text({ ...hsao, toString: '1' }), 'desc.toString: there is no such field'],
        ...[NaN, Infinity, 1.5, 2 ** 32, '4', 4n, null, undefined, {}, [], Symbol('four')].map(steps =>
            [() => ssgi.text({ ...hsao, steps }), 'desc.gather.steps: must be 0..64']),
        [() => ssgi.text({ pass: 'constructor' }), /^desc\.pass: must be /],
        [() => ssgi.text({ ...hsao, version: 5 }), 'desc.version: must be a string, without a NUL'],
        [() => ssgi.text({ ...hsao, fetch: 'a\0b' }), 'desc.fetch: must be a string, without a NUL'],
        [() => ssgi.text(hsao, 'constructor'), 'stage: must be one of vert frag tesc tese geom'],
        [() => ssgi.preset(hsao, 'toString'), 'preset: must be one of FAST BALANCED BEST'],
        [() => ssgi.view(), 'projection: must be an array of numbers'],
        [() => ssgi.view('0123456789abcdef', 4, 4), 'projection: must be an array of numbers'],
        [() => ssgi.view(new BigInt64Array(16), 4, 4), 'projection: must be an array of numbers'],
        [() => ssgi.view(projection.slice(1), 4, 4), 'projection: must have 16 numbers, has 15'],
        [() => ssgi.view([...projection, 0], 4, 4), 'projection: must have 16 numbers, has 17'],
        [() => ssgi.view(nothing, 4, 4), 'projection: must be finite'],
        ...[NaN, 1.5, 2 ** 32 + 4, undefined, '4'].map(width =>
            [() => ssgi.view(projection, width, 4), 'width: must be a whole number']),
        [() => ssgi.view(projection, 4, 0), 'height: must be 1..65536'],
        [() => ssgi.view(projection, 4, 4, 'VULKAN'), 'clip: must be one of GL ZERO'],
        [() => ssgi.frame([1, 2, 3], 1), 'view: must be what view() gave'],
        [() => ssgi.frame(new Uint8Array(view.length - 1), 1), 'view: must be what view() gave'],
        [() => ssgi.frame(view), 'radius: must be a number'],
        [() => ssgi.frame(view, NaN), 'radius: must be > 0 and finite'],
        [() => ssgi.history({}, view, identity, identity), 'frame: must be what frame() gave'],
        [() => ssgi.history(frame, null, identity, identity), 'view: must be what view() gave'],
        [() => ssgi.history(frame, view, identity, [1]), 'lastWorldToView: must have 16 numbers, has 1'],
        [() => ssgi.history(frame, view, nothing, identity), /must be finite$/],
        [() => ssgi.history(frame, view, endless([]), identity), 'worldToView: must be an array of numbers'],
        [() => ssgi.harmonics(frame), 'coefficients: must be an array of numbers'],
        [() => ssgi.harmonics(frame, [1, 2, 3], 4), 'coefficients: must have at least 48 numbers, has 3'],
        [() => ssgi.harmonics(frame, [1, 2, NaN], 1), 'coefficients: must be finite'],
        [() => ssgi.harmonics(frame, { length: 2 ** 31 }, 4), 'coefficients: must be an array of numbers'],
        [() => ssgi.harmonics(frame, [1, 2, 3], NaN), 'bands: must be a whole number'],
        [() => ssgi.harmonics(frame, [1, 2, 3], -1), 'bands: must be 1..4'],
        [() => ssgi.harmonics(frame, [1, 2, 3], 1, nothing), 'worldToView: must be finite'],
        [() => ssgi.surfels({}, view), 'frame: must be what frame() gave'],
        [() => ssgi.surfels(frame, view, { sise: 1 }), 'desc.sise: there is no such member'],
        [() => ssgi.surfels(frame, view, { size: '1' }), 'size: must be a number'],
        [() => ssgi.surfels(frame, view, { splits: 1.5 }), 'splits: must be a whole number'],
        [() => ssgi.surfels(frame, view, { size: 2 }), /^desc\.size: must be /],
        [() => ssgi.light(), 'light: must be an object'],
        [() => ssgi.light({ kind: 'MOON', at: up, colour: up }), 'light.kind: must be one of SUN POINT SPOT VPL'],
        [() => ssgi.light({ kind: 'SUN', at: [0, 1], colour: up }), 'light.at: must have 3 numbers, has 2'],
        [() => ssgi.light({ kind: 'SUN', at: up, colour: [1, NaN, 1] }), 'light.colour: must be finite'],
        ...[-1, 0.5, 2 ** 31, 3e9].map(min_distance => [() => ssgi.light({ kind: 'SUN', at: up, colour: up, min_distance }),
            'light.min_distance: of a SUN must be a whole number of rows that follow, 0..16383']),
        [() => ssgi.light({ kind: 'SUN', at: up, colour: up }, { view, worldToView: identity }),
         'map.worldToLight: must be an array of numbers'],
        [() => ssgi.light({ kind: 'SUN', at: up, colour: up },
                          { view, x: -1, worldToView: identity, worldToLight: identity }),
         /^x: the tile must lie in the atlas/],
        [() => ssgi.field('bytes'), 'field: must be bytes of ssgi_field_save'],
        [() => ssgi.field(bytes), /^file: /],
        [() => ssgi.phase(NaN), 'k: must be a whole number'],
        [() => ssgi.environmentMap(NaN, rgb, 8, 4), 'size: must be a whole number'],
        [() => ssgi.environmentMap(1e9, rgb, 8, 4), /^size: would take \d+ MB of memory, 2047 at most are there$/],
        [() => ssgi.environmentMap(7, rgb, 8, 4), 'size: must be 8..256'],
        [() => ssgi.environmentMap(8, null, 8, 4), 'rgb: must be an array of numbers'],
        [() => ssgi.environmentMap(8, rgb, 8, 5), 'rgb: must have 120 numbers, has 96'],
        [() => ssgi.environmentMap(8, rgb, 0, 4), 'width: must be 1..65536'],
        [() => ssgi.environmentMap(8, rgb, 8, 4, NaN), /^solid_angle: must be finite/],
        [() => ssgi.environmentMap(8, rgb, 8, 4, '1'), 'solidAngle: must be a number'],
        [() => ssgi.environmentCone(8, rgb, 8, 4, 2), 'cosine: must be 0..0.95'],
        [() => ssgi.residual(8, rgb, [1, 2, 3], 1), 'map: must have 192 numbers, has 96'],
        [() => ssgi.projectEquirect(99, rgb, 8, 4), /^bands: must be 1\.\./],
        [() => ssgi.trace(), 'position: must be an array of numbers'],
        [() => ssgi.trace([]), 'position: must have 9 numbers a triangle, has 0'],
        [() => ssgi.trace([...corners, 1]), 'position: must have 9 numbers a triangle, has 10'],
        [() => ssgi.trace(corners, [0, 1, 3]), 'index[2]: must be a vertex, 0..2, is 3'],
        [() => ssgi.trace(corners, [0, -1, 2]), 'index[1]: must be a vertex, 0..2, is -1'],
        [() => ssgi.trace(corners, [NaN, 1, 2]), 'index[0]: must be a vertex, 0..2, is NaN'],
        [() => ssgi.trace(corners, [0, 1]), 'index: must have 3 numbers a triangle, has 2'],
        [() => ssgi.trace({ length: 9e8 }), /^position: would take \d+ MB of memory, 2047 at most are there$/],
        [() => trace.any([0, 0], up, 0, 1), 'origin, direction: must be three numbers each'],
        [() => trace.closest(here, up, 0), 'tmin, tmax: must be numbers'],
        [() => ssgi.steps(), 'chain: must be an object'],
        [() => ssgi.steps({ desc: null, width: 4, height: 4 }), 'chain.desc: must be an object'],
        [() => ssgi.steps({ desc: hsao, width: 4, height: 4, constructor: 1 }),
         'chain.constructor: there is no such member'],
        ...[NaN, 0.5, 2 ** 32 + 64, '64', undefined].map(width =>
            [() => ssgi.steps({ desc: hsao, width, height: 64 }), 'chain.width: must be a whole number'])
    ];
}

/* What is right is still done after all that. */
export const works = ssgi => ssgi.text({ pass: 'HSAO', half: true }).startsWith('#version')
    && ssgi.steps({ desc: { pass: 'HSAO' }, width: 64, height: 48, blur: 1, history: true }).length > 1
    && ssgi.view(endless([...projection]), 64, 48).join() === ssgi.view(projection, 64, 48).join()
    && ssgi.trace(corners, [0, 1, 2]).closest([0.2, 0.2, 1], [0, 0, -1], 0, 10).t === 1;
