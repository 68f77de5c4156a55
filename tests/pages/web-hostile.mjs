/* web-hostile.mjs - bad inputs for the page and the loader: models, for web.mjs; arguments, for test_tools.c. */

/* ---- models: name, text or bytes, the error -------- */

const triangle = (...corners) => `${corners.map(at => `v ${at}\n`).join('')}f 1 2 3\n`;
const gltf = more => JSON.stringify({ asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }],
                                      nodes: [{ mesh: 0 }], ...more });
/* Returns a model: a triangle with these indices, a line, and bounds that do not fit them. */
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
/* Returns the same wedge as a glTF, in a node at place; it glows. east: where its own coordinates begin. */
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

/* Returns a Radiance picture of one brightness, without run lengths. */
export function hdr(width, height, value) {
    const head = new TextEncoder().encode(`#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ${height} +X ${width}\n`);
    const bytes = new Uint8Array(head.length + 4 * width * height);
    bytes.set(head);
    for (let i = head.length; i < bytes.length; i += 4) bytes.set([value, value, value, value && 129], i);
    return bytes;
}

/* The wedge's corners and faces, packed by the npm package draco3d 1.5.7. */
const packed = text => Uint8Array.from(atob(text), c => c.charCodeAt(0));
const dracoMesh = packed('RFJBQ08CAgEBAAAABAQAAwAAAS8BARAB/wAAAQAJAwAAAgEBAQADAwEQATADAFCCJJEEAAAAAP8DAAAAAAAAAAAAAAAA'
    + 'AAAAAIA/Cg==');

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

export const models = [
    ['empty.obj', '', 'empty.obj: holds no triangles; must hold one at least'],
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
    ['old.gltf', '{"asset":{"version":"1.0"}}', /^old\.gltf: cannot be read: .+; must be glTF 2\.0/],
    ['parts.gltf', gltf({ buffers: [{ uri: 'parts.bin', byteLength: 36 }] }),
     /^parts\.gltf: cannot be read: parts\.bin is another file that is not beside it; drop all together; must/],
    ['far.gltf', gltf({ images: [{ uri: 'https://example.com/a.png' }] }),
     /^far\.gltf: cannot be read: https:\/\/example\.com\/a\.png is another file that is not beside it; drop/],
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

/* ---- arguments of ssgi.mjs: a call, its error ---- */

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], nothing = identity.map(() => NaN);
const projection = [1.3, 0, 0, 0, 0, 2.4, 0, 0, 0, 0, -1.002, -1, 0, 0, -0.2002, 0];
const corners = [0, 0, 0, 1, 0, 0, 0, 1, 0];

/* Returns a list whose length is 16, but whose iterator yields more. */
const endless = list => Object.assign(list, { length: 16, *[Symbol.iterator]() { yield* new Array(1e5).fill(1); } });

/* Bad values, by the type that an argument should have. */
const whole = [NaN, 1.5, 2 ** 32 + 4, undefined, '4', 4n, {}], number = ['1', {}, []], made = [{}, null, [1, 2, 3]];
const list = [null, '0123456789abcdef', new BigInt64Array(16), [1], { length: 2 ** 31 }, [NaN]];
const matrix = [undefined, ...list, nothing, [...identity, 0], endless([])], object = [undefined, 'HSAO', []];

export function calls({ load, Ssgi }, ssgi) {
    const rgb = new Float32Array(3 * 8 * 4).fill(1), hsao = { pass: 'HSAO' }, up = [0, 0, 1], here = [0.2, 0.2, -1];
    const view = ssgi.view(projection, 64, 48), frame = ssgi.frame(view, 0.5), trace = ssgi.trace(corners);
    const bytes = Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0), sun = { kind: 'SUN', at: up, colour: up };
    const map = { view, worldToView: identity, worldToLight: identity };
    const refused = [
        ['desc', object, v => ssgi.shader(v)], ['desc', object, v => ssgi.check(v)], ['desc', object, v => ssgi.key(v)],
        ['desc.gather.samples', [...whole, Infinity, null, [], Symbol('four')], 
         samples => ssgi.shader({ ...hsao, samples })],
        ['desc.pass', ['constructor', 'toString', 99], pass => ssgi.shader({ pass })],
        ['desc.version', [5, 'a\0b'], version => ssgi.shader({ ...hsao, version })],
        ['stage', ['constructor', 'FRAG', 7], v => ssgi.shader(hsao, v)],
        ['preset', ['toString', 7], v => ssgi.preset(hsao, v)],
        ['projection', matrix, v => ssgi.view(v, 4, 4)], ['width', [...whole, 0], v => ssgi.view(projection, v, 4)],
        ['height', [...whole, 0], v => ssgi.view(projection, 4, v)],
        ['clip', ['VULKAN', 'constructor', 7], v => ssgi.view(projection, 4, 4, v)],
        ['view', [...made, new Uint8Array(view.length - 1)], v => ssgi.frame(v, 1)],
        ['radius', [...number, undefined, NaN, 0], v => ssgi.frame(view, v)],
        ['frame', made, v => ssgi.history(v, view, identity, identity)],
        ['view', made, v => ssgi.history(frame, v, identity, identity)],
        ['(main_world_to_view|worldToView)', matrix, v => ssgi.history(frame, view, v, identity)],
        ['(last_world_to_view|lastWorldToView)', matrix, v => ssgi.history(frame, view, identity, v)],
        ['coefficients', list, v => ssgi.harmonics(frame, v, 4)],
        ['bands', [...whole, -1], v => ssgi.harmonics(frame, [1, 2, 3], v)],
        ['worldToView', matrix.slice(2), v => ssgi.harmonics(frame, [1, 2, 3], 1, v)],
        ['frame', made, v => ssgi.surfels(v, view)], ['view', made, v => ssgi.surfels(frame, v)],
        ['(desc\\.)?size', [...number, 2], size => ssgi.surfels(frame, view, { size })],
        ['splits', whole, splits => ssgi.surfels(frame, view, { splits })],
        ['light', object, v => ssgi.light(v)], ['light.kind', ['MOON', 7], kind => ssgi.light({ ...sun, kind })],
        ['light.at', [null, [0, 1], nothing.slice(13)], at => ssgi.light({ ...sun, at })],
        ['light.colour', [null, [0, 1], nothing.slice(13)], colour => ssgi.light({ ...sun, colour })],
        ['light.min_distance', [-1, 0.5, 2 ** 31], min_distance => ssgi.light({ ...sun, min_distance })],
        ['map.worldToLight', matrix.slice(0, 3), worldToLight => ssgi.light(sun, { ...map, worldToLight })],
        ['(map\\.)?x', [...whole.filter(v => v !== undefined), -1], x => ssgi.light(sun, { ...map, x })],
        ['field', [null, 'bytes', [1]], v => ssgi.field(v)], ['k', whole, v => ssgi.phase(v)],
        ['size', [...whole, 7], v => ssgi.environmentMap(v, rgb, 8, 4)],
        ['rgb', list, v => ssgi.environmentMap(8, v, 8, 4)],
        ['width', [...whole, 0], v => ssgi.environmentMap(8, rgb, v, 4)],
        ['solidAngle', number, v => ssgi.environmentMap(8, rgb, 8, 4, v)],
        ['cosine', [...number, 2], v => ssgi.environmentCone(8, rgb, 8, 4, v)],
        ['map', list, v => ssgi.residual(8, v, [1, 2, 3], 1)],
        ['bands', [...whole, 99], v => ssgi.projectEquirect(v, rgb, 8, 4)],
        ['position', [undefined, [], [...corners, 1]], v => ssgi.trace(v)],
        ['index', [[0, 1], [0, 1, 3], [0, -1, 2], [NaN, 1, 2]], v => ssgi.trace(corners, v)],
        ['origin, direction', [undefined, [0, 0]], v => trace.any(v, up, 0, 1)],
        ['tmin, tmax', [undefined, '0'], v => trace.closest(here, up, 0, v)],
        ['chain', object, v => ssgi.steps(v)],
        ['chain.desc', [null, 7], desc => ssgi.steps({ desc, width: 4, height: 4 })],
        ['chain.width', whole, width => ssgi.steps({ desc: hsao, width, height: 64 })]];
    return [
        ...refused.flatMap(([name, wrong, call]) => wrong.map(v =>
            [() => call(v), new RegExp(`^${name}(\\[\\d\\])?: ([^\\n]*must |would take \\d+ MB)[^\n]+$`)])),
        [() => load(null), 'source: must be a URL, bytes or a WebAssembly.Module'],
        [() => load('gone.wasm'), /^gone\.wasm: cannot be read: /],
        [() => load(Uint8Array.of(1, 2, 3)), /^source: must be the ssgi\.wasm that make wasm builds: /],
        [() => load(bytes), 'exports: must be those of ssgi.wasm, its memory among them'],
        [() => new Ssgi({ __heap_base: { value: 0 }, ssgi_wasm_place_at: () => 0 }),
         'exports: must be those of ssgi.wasm, its memory among them'],
        [() => ssgi.shader({ ...hsao, constructor: 1 }), 'desc.constructor: there is no such field'],
        [() => ssgi.shader(JSON.parse('{"pass":"HSAO","__proto__":1}')), 'desc.__proto__: there is no such field'],
        [() => ssgi.surfels(frame, view, { sise: 1 }), 'desc.sise: there is no such member'],
        [() => ssgi.steps({ desc: hsao, width: 4, height: 4, constructor: 1 }),
         'chain.constructor: there is no such member'],
        [() => ssgi.shader({ ...hsao, samples: 99 }), 'desc.gather.samples: must be 0..64'],
        [() => ssgi.preset(hsao, 'GOOD'), 'preset: must be one of FAST BALANCED BEST'],
        [() => ssgi.view(projection.slice(1), 4, 4), 'projection: must have 16 numbers, has 15'],
        [() => ssgi.view(projection, 4, 0), 'height: must be 1..65536'],
        [() => ssgi.harmonics(frame, [1, 2, 3], 4), 'coefficients: must have at least 48 numbers, has 3'],
        [() => ssgi.light({ ...sun, min_distance: 3e9 }),
         'light.min_distance: of a SUN must be a whole number of rows that follow, 0..16383'],
        [() => ssgi.field(bytes), /^file: /],
        [() => ssgi.environmentMap(1e9, rgb, 8, 4), /^size: would take \d+ MB of memory, 2047 at most are there$/],
        [() => ssgi.environmentMap(8, rgb, 8, 5), 'rgb: must have 120 numbers, has 96'],
        [() => ssgi.environmentMap(8, rgb, 8, 4, NaN), /^solid_angle: must be finite/],
        [() => ssgi.trace(corners, [0, -1, 2]), 'index[1]: must be a vertex, 0..2, is -1'],
        [() => ssgi.trace({ length: 9e8 }), /^position: would take \d+ MB of memory, 2047 at most are there$/]
    ];
}

/* Checks that valid calls still work after all of these. */
export const works = ssgi => ssgi.shader({ pass: 'HSAO', resolution: true }).startsWith('#version')
    && ssgi.steps({ desc: { pass: 'HSAO' }, width: 64, height: 48, blur: 1, history: true }).length > 1
    && ssgi.view(endless([...projection]), 64, 48).join() === ssgi.view(projection, 64, 48).join()
    && ssgi.trace(corners, [0, 1, 2]).closest([0.2, 0.2, 1], [0, 0, -1], 0, 10).t === 1;
