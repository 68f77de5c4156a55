/* ssgi.mjs - ssgi in JavaScript: loads ssgi.wasm (make wasm), without dependencies, in a page or in node.

      import { load } from './ssgi.mjs';
      const ssgi = await load();                             // or a URL, bytes, a WebAssembly.Module
      const chain = ssgi.chain('hsao,dialect=300es,normal=from-depth');       // ssgi.methods lists the names
      const view = ssgi.view(projection, width, height);     // projection: 16 numbers, in GL's order
      const frame = ssgi.frame(view, 0.5, chain);            // frame.thickness_limit[0] = 0.2; ..
      gl.bufferSubData(gl.UNIFORM_BUFFER, 0, frame.buffer);  // the block "ssgi_frame"
      for (const step of ssgi.steps({ ...chain, width, height })) {           // the draws, in order
          gl.shaderSource(shader, ssgi.shader(step.desc, 'frag'));              // and 'vert'
          for (const row of ssgi.rows(step.desc)) ..         // { name: 't_ssgi_depth', kind: 'TEXTURE', slot: 0, .. }
      }

   A desc is a flat object of the fields of ssgi_gl_desc (ssgi_gl.h) by the names in ssgi.choices, without their groups:
   samples is gather.samples. Enums are words: the C name without its prefix. A wrong argument throws an Error of one
   sentence: the library's or, for faults that it cannot see (types, lengths, memory), one of this file. */

const stages = ['vert', 'frag', 'tesc', 'tese', 'geom', 'comp'];
const kinds = ['TEXTURE', 'PARAM', 'OUTPUT', 'CONSTANT', 'ATTRIBUTE', 'CAPTURE'];
const presets = ['FAST', 'BALANCED', 'BEST'];
const meanings = ['DEPTH', 'LAYERS', 'BACK', 'VIEWS', 'NORMAL', 'ALBEDO', 'LAYER_NORMALS', 'LAYER_ALBEDOS', 'DIRECT',
                  'NOISE', 'KERNEL', 'ENVIRONMENT', 'IRRADIANCE', 'LIGHTS', 'SHADOW', 'OCCLUDERS', 'FIELDS', 'OBJECTS',
                  'MOTION', 'AMBIENT', 'CAP'];                                  /* SSGI_GL_YOUR_ .. */
const results = ['NONE', 'LIGHT', 'BOUNCE'], scales = ['FULL', 'HALF', 'LEVELS', 'TILES', 'QUARTER'];
const clips = ['GL', 'ZERO', 'GL_ROWS_DOWN', 'ZERO_ROWS_DOWN'], lamps = ['SUN', 'POINT', 'SPOT', 'VPL'];
const floats = { float: 1, int: 1, vec2: 2, ivec2: 2, vec4: 4, mat3: 12, mat4: 16 };     /* in std140 */
const memoryMost = 0x7fff0000;                                                  /* addresses are signed */
const rowsMost = 16384;                                                         /* of a texture */

/* ---- checks of arguments that the library cannot make */

function fail(sentence) { throw new Error(sentence); }

/* A number, true or false as an int32; null: it is none. WebAssembly would truncate it silently. */
function int32(value) {
    const whole = typeof value === 'boolean' ? Number(value) : value;
    return Number.isInteger(whole) && Math.abs(whole) <= 0x7fffffff ? whole : null;
}

function whole(name, value) { return int32(value) ?? fail(`${name}: must be a whole number`); }

function number(name, value) { return typeof value === 'number' ? value : fail(`${name}: must be a number`); }

function word(name, value, words) {
    const at = words.indexOf(value);
    return at < 0 ? fail(`${name}: must be one of ${words.join(' ')}`) : at;
}

function object(name, value) {
    return typeof value === 'object' && value !== null && !Array.isArray(value) ? value
        : fail(`${name}: must be an object`);
}

/* The number of numbers in an array, plain or typed, which must have from least to most. */
function countOf(name, list, least = 0, most = least || Infinity) {
    const { length } = typeof list === 'object' && list !== null ? list : {};
    if (!Number.isInteger(length)) fail(`${name}: must be an array of numbers`);
    if (length < least || length > most)
        fail(`${name}: must have ${most > least ? 'at least ' : ''}${least} numbers, has ${length}`);
    return length;
}

function opaque(name, value, length, from) {
    return value instanceof Uint8Array && value.length === length ? value : fail(`${name}: must be what ${from} gave`);
}

/* Returns ssgi.wasm from a URL: the bytes of a file: URL in Node.js, else a module that is compiled while it arrives,
   or its bytes if the server gives them another type. */
async function moduleOf(source) {
    const url = new URL(source, globalThis.location?.href);
    if (url.protocol === 'file:' && globalThis.process?.versions?.node) {
        const files = 'node:fs/promises';           /* not a literal, which bundlers of pages would follow */
        return (await import(/* webpackIgnore: true */ /* @vite-ignore */ files)).readFile(url);
    }
    const answer = await fetch(url);
    if (!answer.ok) fail(`${answer.status} ${answer.statusText}`);
    const typed = /^application\/wasm\s*(;|$)/.test(answer.headers.get('content-type') ?? '');
    return typed && WebAssembly.compileStreaming ? WebAssembly.compileStreaming(answer) : answer.arrayBuffer();
}

export async function load(source = new URL('ssgi.wasm', import.meta.url)) {
    const named = typeof source === 'string' || source instanceof URL;
    const held = source instanceof WebAssembly.Module || source instanceof ArrayBuffer || ArrayBuffer.isView(source);
    if (!named && !held) fail('source: must be a URL, bytes or a WebAssembly.Module');
    const name = named ? source : 'source';
    const strange = e => fail(`${name}: must be the ssgi.wasm that make wasm builds: ${e.message}`);
    const unread = e => (e instanceof WebAssembly.CompileError ? strange(e) : fail(`${name}: cannot be read: ${
        e.message}`));
    const is = named ? await moduleOf(source).catch(unread) : source;
    const made = await WebAssembly.instantiate(is, { Math }).catch(strange);
    return new Ssgi((made.instance ?? made).exports);
}

const loaded = new Map();                       /* promises of Ssgi by source */

/* As load, but reads each source only once. source may also be an Ssgi. */
export function loadOnce(source) {
    if (source instanceof Ssgi) return Promise.resolve(source);
    if (!loaded.has(source))
        loaded.set(source, load(source).catch(e => { loaded.delete(source); throw e; }));
    return loaded.get(source);
}

export class Ssgi {
    #c; #top; #strings;
    #at = {};                                   /* sizes and offsets by name */
    #of = {};                                   /* offsets: struct, member */

    constructor(exports) {
        if (!(exports?.memory instanceof WebAssembly.Memory) || typeof exports.ssgi_wasm_place_at !== 'function'
            || typeof exports.__heap_base?.value !== 'number')
            fail('exports: must be those of ssgi.wasm, its memory among them');
        this.#c = exports;
        this.#top = exports.__heap_base.value;
        for (let i = 0, at; (at = exports.ssgi_wasm_place_at(i)) !== 0; ++i) {
            const name = this.#string(this.#int(at)), [of, member] = name.split('.');
            this.#at[name] = this.#int(at + 4);
            if (member) (this.#of[of] ??= {})[member] = this.#at[name];
        }
        if (this.#at.meanings !== meanings.length) fail('ssgi.mjs and ssgi.wasm are of different versions');
        const { ssgi_gl_choice: choice, ssgi_gl_method: method } = this.#of;
        this.#strings = { version: this.#at['ssgi_gl_desc.version'], fetch: this.#at['ssgi_gl_desc.fetch'] };
        this.version = `${this.#at.major}.${this.#at.minor}`;
        const choices = list => this.#list(list, c => ({
            name: this.#string(this.#int(c + choice.name)), field: this.#string(this.#int(c + choice.field)),
            offset: this.#int(c + choice.offset), most: this.#int(c + choice.most),
            values: this.#string(this.#int(c + choice.values)).split(' ').filter(Boolean),
            sentence: this.#string(this.#int(c + choice.sentence)) }));
        this.choices = choices(exports.ssgi_gl_choice_at);
        for (const { name, offset } of choices(exports.ssgi_gl_chain_choice_at)) this.#of.ssgi_gl_chain[name] = offset;
        this.methods = this.#list(exports.ssgi_gl_method_at, m => ({
            name: this.#string(this.#int(m + method.name)), sentence: this.#string(this.#int(m + method.sentence)),
            pass: this.choices[0].values[this.#int(m + method.pass)], preset: presets[this.#int(m + method.preset)],
            settings: this.#string(this.#int(m + method.settings)) }));
        this.members = this.#list(exports.ssgi_gl_member_at, row => this.#row(row));
        this.passes = this.#list(exports.ssgi_gl_pass_name, s => this.#string(s));
        this.dialects = this.#list(exports.ssgi_gl_dialect_name, s => this.#string(s));
    }

    /* The text that a function like snprintf writes; '' if it writes none. */
    #written(write) {
        const n = write(0, 0), out = this.#room(n + 1);
        write(out, n + 1);
        return n ? this.#string(out) : '';
    }

    /* The GLSL of a stage; '' if the pass has no such stage. */
    shader(desc, stage = 'frag') {
        return this.#scope(() => {
            const d = this.#good(desc), s = word('stage', stage, stages);
            return this.#written((out, room) => this.#c.ssgi_gl_emit(out, room, d, s));
        });
    }

    /* GLSL functions by which your own shaders read the result of the step with this desc: ssgi_gl_read. */
    read(desc) {
        return this.#scope(() => {
            const d = this.#good(desc), text = this.#written((out, room) => this.#c.ssgi_gl_read(out, room, d));
            if (!text) throw new Error('desc.pass: its result has no functions that read it');
            return text;
        });
    }
    /* GLSL functions for the light that visibility dims: ssgi_gl_reflection. */
    reflection() {
        return this.#scope(() => this.#written((out, room) => this.#c.ssgi_gl_reflection(out, room)));
    }

    /* The inputs and outputs to bind: ssgi_gl_io. */
    rows(desc) {
        return this.#scope(() => {
            const d = this.#good(desc), n = this.#c.ssgi_gl_reflect(d, 0, 0);
            const rows = this.#room(n * this.#at.ssgi_gl_io);
            this.#c.ssgi_gl_reflect(d, rows, n);
            return Array.from({ length: n }, (_, i) => this.#row(rows + i * this.#at.ssgi_gl_io));
        });
    }

    /* The draws of a chain in order: members of ssgi_gl_chain and ssgi_gl_step by their names, enums by their words
       without the prefix (an input's meaning null: a texture of the steps). */
    steps(chain) {
        return this.#scope(() => {
            const { ssgi_gl_step: step } = this.#of, size = this.#at.ssgi_gl_step, at = this.#chain(chain);
            const why = this.#room(4), most = 32;       /* few chains have more; they need a second call */
            let steps = this.#room(most * size);
            const n = this.#c.ssgi_gl_steps(steps, most, at, why);
            if (!n) fail(this.#string(this.#int(why)));
            if (n > most) this.#c.ssgi_gl_steps(steps = this.#room(n * size), n, at, why);
            return Array.from({ length: n }, (_, i) => this.#step(steps + i * size, step, { ...chain.lights,
                                                                                            ...chain.desc }));
        });
    }

    /* A method's chain by name and settings, as by ssgi_gl_chain_of: { ...chain('hsao'), width, height } */
    chain(name) {
        return this.#scope(() => {
            const { ssgi_gl_chain: places } = this.#of, at = this.#room(this.#at.ssgi_gl_chain);
            const text = this.#cString('name', name);
            this.#try(why => this.#c.ssgi_gl_chain_of(at, text, why));
            const { desc, lights, ...members } = places, all = this.#ints(at, members, Object.keys(members));
            const lamps = this.#object(at + lights, {});
            return { desc: this.#object(at + desc, {}), ...(lamps.pass === 'LIGHTS' && { lights: lamps }),
                     ...Object.fromEntries(Object.entries(all).filter(([, value]) => value)) };
        });
    }

    check(desc) { this.#scope(() => this.#good(desc)); }
    key(desc) { return this.#scope(() => BigInt.asUintN(64, this.#c.ssgi_gl_key(this.#good(desc)))); }

    /* preset: the desc with a preset's settings. resolve: the desc with zeros replaced by their defaults. */
    preset(desc, preset) {
        return this.#scope(() => {
            const d = this.#desc(desc);
            this.#try(why => this.#c.ssgi_gl_preset(d, word('preset', preset, presets), why));
            return this.#object(d, desc);
        });
    }
    resolve(desc) {
        return this.#scope(() => {
            const d = this.#good(desc), out = this.#room(this.#at.ssgi_gl_desc);
            this.#c.ssgi_gl_resolve(out, d);
            return this.#object(out, desc);
        });
    }

    /* An opaque ssgi_view. clip: 'GL', or 'ZERO' with EXT_clip_control's ZERO_TO_ONE; with _ROWS_DOWN where row 0 of
       textures is the top of the picture, as in WebGPU. */
    view(projection, width, height, clip = 'GL') {
        return this.#scope(() => {
            const view = this.#room(this.#at.ssgi_view), m = this.#floats('projection', projection, 16);
            const c = word('clip', clip, clips), w = whole('width', width), h = whole('height', height);
            this.#try(why => this.#c.ssgi_view_from_projection(view, m, c, w, h, why));
            return this.#bytes(view, this.#at.ssgi_view).slice();
        });
    }

    /* Returns { buffer, and each member of ssgi_gl_frame as a typed array in it }; with chain: the values for it */
    frame(view, radius, chain = null) {
        const frame = { buffer: new ArrayBuffer(this.#at.ssgi_gl_frame) };
        for (const m of this.members.filter(m => m.slot === 0)) {
            const [, type, count] = /^(\w+)(?:\[(\d+)\])?$/.exec(m.type);
            frame[m.name.slice('u_ssgi_'.length)] = new (/^i/.test(type) ? Int32Array : Float32Array)(
                frame.buffer, m.offset, floats[type] * (count ?? 1));
        }
        return this.#onFrame(frame, f => {
            const v = this.#view(view), r = number('radius', radius);
            const c = chain === null ? 0 : this.#chain(chain);
            this.#try(why => (c ? this.#c.ssgi_gl_frame_of(f, c, v, r, why)
                : this.#c.ssgi_gl_frame_init(f, v, r, why)));
        });
    }

    /* view and lastWorldToView: of the last frame. Do not call it after a cut or a change of size. */
    history(frame, view, worldToView, lastWorldToView) {
        return this.#onFrame(frame, f => {
            const v = this.#view(view), now = this.#floats('worldToView', worldToView, 16);
            const last = this.#floats('lastWorldToView', lastWorldToView, 16);
            this.#try(why => this.#c.ssgi_gl_frame_history(f, v, now, last, why));
        });
    }
    harmonics(frame, coefficients, bands, worldToView = null) {
        return this.#onFrame(frame, f => {
            const from = this.#coefficients(coefficients, bands);
            const turn = worldToView === null ? 0 : this.#floats('worldToView', worldToView, 16, 16, true);
            this.#try(why => this.#c.ssgi_gl_harmonics_set(f, from, bands, turn, why));
        });
    }
    /* A complete surfel desc; desc: members of ssgi_surfel_desc, 0 if missing. */
    surfels(frame, view, desc = {}) {
        return this.#onFrame(frame, f => {
            const { ssgi_surfel_desc: places } = this.#of, d = this.#room(this.#at.ssgi_surfel_desc);
            for (const [name, value] of Object.entries(object('desc', desc))) {
                if (!Object.hasOwn(places, name)) fail(`desc.${name}: there is no such member`);
                if (/^(splits|keep_small|overhang)$/.test(name)) this.#setInt(d + places[name], whole(name, value));
                else this.#setFloats(d + places[name], [number(name, value)], 1, name);
            }
            const v = this.#view(view);
            this.#try(why => this.#c.ssgi_gl_surfels_set(f, v, d, 0, why));
        });
    }
    /* A light's row of t_ssgi_lights: 8 texels of RGBA32F. light: members of ssgi_gl_light; map: the place of its
       shadow map in t_ssgi_shadow, the view with which that was drawn, and matrices to the picture's view space and to
       its own. */
    light(light, map = null) {
        return this.#scope(() => {
            const { kind, at, colour, min_distance = 0, normal = [0, 0, 0] } = object('light', light);
            const { ssgi_gl_light: places } = this.#of, l = this.#room(this.#at.ssgi_gl_light);
            const put = (name, list, n) =>
                this.#setFloats(l + places[name], list, countOf(`light.${name}`, list, n), `light.${name}`, true);
            for (const [name, list] of Object.entries({ at, colour, normal })) put(name, list, 3);
            put('kind', [word('light.kind', kind, lamps)], 1);
            put('min_distance', [number('light.min_distance', min_distance)], 1);
            if (kind === 'SUN' && !(Number.isInteger(min_distance) && min_distance >= 0 && min_distance < rowsMost))
                fail(`light.min_distance: of a SUN must be a whole number of rows that follow, 0..${rowsMost - 1}`);
            if (map !== null) {
                const { view, x = 0, y = 0, worldToView, worldToLight } = object('map', map), v = this.#view(view);
                const left = whole('map.x', x), low = whole('map.y', y);
                const to = this.#floats('map.worldToView', worldToView, 16);
                const from = this.#floats('map.worldToLight', worldToLight, 16);
                this.#try(why => this.#c.ssgi_gl_light_map(l, v, left, low, to, from, why));
            }
            return new Float32Array(this.#bytes(l, this.#at.ssgi_gl_light).slice().buffer);
        });
    }
    phase(k) { return this.#c.ssgi_gl_phase(whole('k', k)); }

    /* ---- an environment: rgb, latitude-longitude, +y up, its centre toward +z (ssgi.h, >>environment and >>sh) */

    /* size * size * 3 floats: through a lobe (0: irradiance over pi); over a cone; the residual of harmonics */
    environmentMap(size, rgb, width, height, solidAngle = 0) {
        const angle = number('solidAngle', solidAngle);
        return this.#made('size', size, map => {
            const from = this.#image(rgb, width, height);
            this.#try(why => this.#c.ssgi_environment_map(map, size, from, width, height, angle, why));
        });
    }
    environmentCone(size, rgb, width, height, cosine = 0) {
        const rim = number('cosine', cosine);
        return this.#made('size', size, map => {
            const from = this.#image(rgb, width, height);
            this.#try(why => this.#c.ssgi_environment_cone(map, size, from, width, height, rim, why));
        });
    }
    residual(size, map, coefficients, bands) {
        return this.#made('size', size, at => {
            this.#setFloats(at, map, countOf('map', map, 3 * size * size), 'map');
            const from = this.#coefficients(coefficients, bands);
            this.#try(why => this.#c.ssgi_sh_residual(at, size, from, bands, 0, 0, why));
        });
    }
    projectEquirect(bands, rgb, width, height) {
        return this.#made('bands', bands, out => {
            const from = this.#image(rgb, width, height);
            this.#try(why => this.#c.ssgi_sh_project_equirect(out, bands, from, width, height, why));
        });
    }

    /* ---- a baked field, from the bytes of ssgi_field_save. texels: a slice of t_ssgi_fields, RG32UI. occluder: its
       row of t_ssgi_occluders at a place; limits: those that differ from ssgi_field_limits_of's. A field's memory is
       kept as long as this Ssgi. */
    field(bytes) {
        if (!(bytes instanceof Uint8Array)) fail('field: must be bytes of ssgi_field_save');
        const { ssgi_field: places } = this.#of;
        const [field, texels, size] = this.#kept(() => {
            const f = this.#room(this.#at.ssgi_field);
            const load = (to, room) => this.#scope(() => {
                const file = this.#copy(bytes);
                this.#try(why => this.#c.ssgi_field_load(f, to, room, file, bytes.length, why));
            });
            const full = n => { const at = this.#room(n, 'field'); load(at, n); return [f, at, n]; };
            load(0, 0);
            return full(this.#c.ssgi_field_size(this.#int(f + places.resolution)));
        });
        const float = name => new DataView(this.#c.memory.buffer).getFloat32(field + places[name], true);
        const made = { resolution: this.#int(field + places.resolution), radius: float('radius'),
                       reach: float('reach'), inside: float('inside'), p95: float('p95'),
                       texels: new Uint32Array(this.#bytes(texels, size).slice().buffer) };
        return {
            ...made,
            occluder: (meshToView, slice = 0, object = 0, limits = {}) => this.#scope(() => {
                const { reach = made.reach, ramp = 0.75 * reach, inside = made.inside, power = 1 } = limits;
                const s = whole('slice', slice), o = whole('object', object);
                const at = this.#room(this.#at.ssgi_gl_occluder);
                const l = this.#floats('limits', [ramp, reach, inside, power]);
                const m = this.#floats('meshToView', meshToView, 16);
                this.#try(why => this.#c.ssgi_gl_occluder_set(at, field, l, m, s, o, why));
                return new Float32Array(this.#bytes(at, this.#at.ssgi_gl_occluder).slice().buffer);
            })
        };
    }

    /* ---- rays against triangles. position: xyz a vertex; index: three a triangle, null: vertices in order. Its memory
       is kept as long as this Ssgi. As in C, triangles and rays with a number that is not finite never meet. */
    trace(position, index = null) {
        const [triangles, places] = this.#counts(position, index), size = this.#c.ssgi_trace_size(triangles) >>> 0;
        const [trace, ray, hit] = this.#kept(() => {
            const all = [this.#at.ssgi_trace, 24, this.#at.ssgi_hit].map(n => this.#room(n));
            const memory = this.#room(size, 'position');
            this.#scope(() => {
                const p = this.#floats('position', position, places);
                const i = index ? this.#corners(index, 3 * triangles, places / 3) : 0;
                this.#try(why => this.#c.ssgi_trace_build(all[0], memory, size, p, 12, i, triangles, why));
            });
            return all;
        });
        let floats = new Float32Array(0), ints;
        const send = (origin, direction, tmin, tmax) => {
            if (origin?.length !== 3 || direction?.length !== 3) fail('origin, direction: must be three numbers each');
            if (typeof tmin !== 'number' || typeof tmax !== 'number') fail('tmin, tmax: must be numbers');
            if (!floats.length) {                           /* another call's memory has grown */
                floats = new Float32Array(this.#c.memory.buffer);
                ints = new Uint32Array(this.#c.memory.buffer);
            }
            for (let i = 0; i < 3; ++i) {
                floats[(ray >> 2) + i] = origin[i];
                floats[(ray >> 2) + 3 + i] = direction[i];
            }
        };
        return {
            triangles,
            any: (origin, direction, tmin, tmax) => {
                send(origin, direction, tmin, tmax);
                return this.#c.ssgi_trace_any(trace, ray, ray + 12, tmin, tmax) === 1;
            },
            closest: (origin, direction, tmin, tmax) => {
                send(origin, direction, tmin, tmax);
                if (!this.#c.ssgi_trace_closest(hit, trace, ray, ray + 12, tmin, tmax)) return null;
                const at = hit >> 2;
                return { t: floats[at], u: floats[at + 1], v: floats[at + 2], triangle: ints[at + 3] };
            }
        };
    }

    /* The numbers of triangles and of positions' numbers. */
    #counts(position, index) {
        const [of, what] = index === null ? [9, 'triangle'] : [3, 'vertex'], places = countOf('position', position);
        if (!places || places % of) fail(`position: must have ${of} numbers a ${what}, has ${places}`);
        if (index === null) return [places / 9, places];
        const corners = countOf('index', index);
        if (corners % 3) fail(`index: must have 3 numbers a triangle, has ${corners}`);
        return [corners / 3, places];
    }
    /* Checks that the corners of triangles exist. */
    #corners(index, n, vertices) {
        const at = this.#room(4 * n, 'index'), to = new Uint32Array(this.#c.memory.buffer, at, n);
        for (let i = 0; i < n; ++i) {
            const vertex = index[i];
            if (!(Number.isInteger(vertex) && vertex >= 0 && vertex < vertices))
                fail(`index[${i}]: must be a vertex, 0..${vertices - 1}, is ${String(vertex)}`);
            to[i] = vertex;
        }
        return at;
    }

    /* ---- memory: a call allocates from #top on, and frees it when its scope ends */

    #scope(body) {
        const top = this.#top;
        try { return body(); } finally { this.#top = top; }
    }
    /* Frees body's memory only if body fails. */
    #kept(body) {
        const top = this.#top;
        try { return body(); } catch (e) { this.#top = top; throw e; }
    }
    /* what: the argument that needs it, for the error message */
    #room(bytes, what = 'memory') {
        const at = Math.ceil(this.#top / 16) * 16, end = at + bytes, memory = this.#c.memory;
        const lacking = end - memory.buffer.byteLength, MB = Math.ceil(end / 2 ** 20);
        if (end > memoryMost) fail(`${what}: would take ${MB} MB of memory, 2047 at most are there`);
        if (lacking > 0)
            try { memory.grow(Math.ceil(lacking / 65536)); }
            catch { fail(`${what}: would take ${MB} MB of memory, more than this machine gives`); }
        this.#top = end;
        this.#bytes(at, bytes).fill(0);
        return at;
    }
    #bytes(at, n) { return new Uint8Array(this.#c.memory.buffer, at, n); }
    #int(at) { return new DataView(this.#c.memory.buffer).getInt32(at, true); }
    #setInt(at, value) { new DataView(this.#c.memory.buffer).setInt32(at, value, true); }
    #copy(bytes) {
        const at = this.#room(bytes.byteLength);
        this.#bytes(at, bytes.byteLength).set(bytes);
        return at;
    }
    /* Copies the first n of a list by their indices, because an iterator may give more than there is room for. */
    #setFloats(at, list, n, name, finite = false) {
        const to = new Float32Array(this.#c.memory.buffer, at, n);
        for (let i = 0; i < n; ++i) {
            const value = list[i];
            to[i] = typeof value === 'number' ? value : fail(`${name}: must be an array of numbers`);
            if (finite && !Number.isFinite(to[i])) fail(`${name}: must be finite`);
        }
    }
    /* Copies a list of numbers, the first `least` or, with a limit `most`, all of them; returns their address. */
    #floats(name, list, least, most, finite) {
        const all = countOf(name, list, least, most), n = most === Infinity ? least : all;
        const at = this.#room(4 * n, name);
        this.#setFloats(at, list, n, name, finite);
        return at;
    }
    #view(view) { return this.#copy(opaque('view', view, this.#at.ssgi_view, 'view()')); }
    #coefficients(list, bands) {
        countOf('coefficients', list);
        return this.#floats('coefficients', list, 3 * whole('bands', bands) ** 2, Infinity, true);
    }
    #image(rgb, width, height) {                            /* the library reports sides below 1 */
        const pixels = whole('width', width) > 0 && whole('height', height) > 0 ? width * height : 0;
        return this.#floats('rgb', rgb, 3 * pixels);
    }
    #string(at) {
        const all = new Uint8Array(this.#c.memory.buffer);
        return new TextDecoder().decode(all.subarray(at, all.indexOf(0, at)));
    }
    #list(function_, item) {
        const all = [];
        for (let at; (at = function_(all.length)) !== 0;) all.push(item(at));
        return all;
    }
    #row(at) {
        const { ssgi_gl_io: io } = this.#of;
        return { name: this.#string(this.#int(at + io.name)), kind: kinds[this.#int(at + io.kind)],
                 type: this.#string(this.#int(at + io.type)), slot: this.#int(at + io.slot),
                 offset: this.#int(at + io.offset), format: this.#string(this.#int(at + io.format)),
                 ...this.#ints(at, io, ['set', 'binding']) };
    }
    /* Reads the ints of these names from the struct at `at`. */
    #ints(at, places, names) {
        return Object.fromEntries(names.map(name => [name, this.#int(at + places[name])]));
    }
    #format(at) {
        const { ssgi_gl_format: f } = this.#of;
        return at && { name: this.#string(this.#int(at + f.name)),
                       ...this.#ints(at, f, ['internal', 'format', 'type', 'bytes', 'vulkan']),
                       vulkan_name: this.#string(this.#int(at + f.vulkan_name)),
                       webgpu: this.#string(this.#int(at + f.webgpu)) };
    }
    #step(at, step, like) {
        const { ssgi_gl_input: i, ssgi_gl_output: o } = this.#of;
        const of = (count, first, size, item) => Array.from({ length: count }, (_, k) => item(first + k * size));
        const s = this.#ints(at, step, ['width', 'height', 'inputs', 'outputs', 'frame', 'primitive', 'vertices',
                                        'instances', 'clear']);
        return {
            ...s, desc: this.#object(at + step.desc, like), scale: scales[this.#int(at + step.scale)],
            inputs: of(s.inputs, at + step.input, this.#at.ssgi_gl_input, k => ({
                ...this.#ints(k, i, ['unit', 'target', 'set', 'binding', 'array', 'multisampled', 'integer', 'texture',
                                     'last', 'width', 'height']),
                name: this.#string(this.#int(k + i.name)), type: this.#string(this.#int(k + i.type)),
                meaning: meanings[this.#int(k + i.meaning)] ?? null, format: this.#format(this.#int(k + i.format)) })),
            outputs: of(s.outputs, at + step.output, this.#at.ssgi_gl_output, k => ({
                ...this.#ints(k, o, ['texture', 'layers', 'layer', 'set', 'binding', 'kept']),
                name: this.#string(this.#int(k + o.name)), format: this.#format(this.#int(k + o.format)),
                result: results[this.#int(k + o.result)] })),
            blend: of(3, at + step.blend, 4, k => this.#int(k)), groups: of(2, at + step.groups, 4, k => this.#int(k)),
            clear_to: new DataView(this.#c.memory.buffer).getFloat32(at + step.clear_to, true)
        };
    }
    /* Returns the 3 * side^2 floats that body writes. */
    #made(name, side, body) {
        return this.#scope(() => {
            const bytes = 12 * whole(name, side) ** 2, at = this.#room(bytes, name);
            body(at);
            return new Float32Array(this.#bytes(at, bytes).slice().buffer);
        });
    }
    #try(call) {
        const why = this.#room(4);
        if (call(why)) fail(this.#string(this.#int(why)));
    }
    #onFrame(frame, body) {
        const { buffer } = object('frame', frame), { ssgi_gl_frame: size } = this.#at;
        if (!(buffer instanceof ArrayBuffer && buffer.byteLength === size)) fail('frame: must be what frame() gave');
        this.#scope(() => {
            const f = this.#copy(new Uint8Array(buffer));
            body(f);
            new Uint8Array(buffer).set(this.#bytes(f, size));
        });
        return frame;
    }

    /* ---- a desc, by the names of its fields */

    #desc(desc, d = this.#room(this.#at.ssgi_gl_desc), name = 'desc') {
        for (const [field, value] of Object.entries(object(name, desc))) {
            if (Object.hasOwn(this.#strings, field)) {
                if (value != null) this.#setInt(d + this.#strings[field], this.#cString(`${name}.${field}`, value));
                continue;
            }
            const choice = this.choices.find(c => c.name === field);
            if (!choice) fail(`${name}.${field}: there is no such field`);
            const at = typeof value === 'string' ? choice.values.indexOf(value) : int32(value);
            if (at === null || (typeof value === 'string' && at < 0)) fail(choice.sentence);
            this.#setInt(d + choice.offset, at);
        }
        return d;
    }
    #chain(chain) {
        const { ssgi_gl_chain: places } = this.#of, at = this.#room(this.#at.ssgi_gl_chain);
        for (const [name, value] of Object.entries(object('chain', chain))) {
            if (!Object.hasOwn(places, name)) fail(`chain.${name}: there is no such member`);
            if (name === 'desc' || name === 'lights') this.#desc(value, at + places[name], `chain.${name}`);
            else this.#setInt(at + places[name], int32(value) ?? fail(`chain.${name}: must be a whole number`));
        }
        return at;
    }
    #cString(name, value) {
        if (typeof value !== 'string' || value.includes('\0')) fail(`${name}: must be a string, without a NUL`);
        return this.#copy(new TextEncoder().encode(value + '\0'));
    }
    #good(desc) {
        const d = this.#desc(desc);
        this.#try(why => this.#c.ssgi_gl_check(d, why));
        return d;
    }
    #object(d, { version, fetch }) {
        const desc = {};
        for (const { name, offset, values } of this.choices) {
            const value = this.#int(d + offset);
            if (value || name === 'pass') desc[name] = values[value] ?? value;
        }
        return { ...desc, ...(version != null && { version }), ...(fetch != null && { fetch }) };
    }
}
