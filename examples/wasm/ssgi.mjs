/* ssgi.mjs - ssgi in JavaScript: loads ssgi.wasm (make wasm), no dependency, in a page or in node.

      import { load } from './ssgi.mjs';
      const ssgi = await load();                             // or a URL, bytes, a WebAssembly.Module
      const desc = ssgi.preset({ pass: 'HSAO', dialect: '300ES', normal: 'FROM_DEPTH' }, 'BALANCED');
      gl.shaderSource(shader, ssgi.text(desc, 'frag'));      // and 'vert'
      for (const row of ssgi.rows(desc)) ..                  // { name: 't_ssgi_depth', kind: 'TEXTURE', slot: 0, .. }
      const view = ssgi.view(projection, width, height);     // projection: 16 numbers, as GL has them
      const frame = ssgi.frame(view, 0.5);                   // frame.thickness[0] = 0.2; ..
      gl.bufferSubData(gl.UNIFORM_BUFFER, 0, frame.buffer);  // the block "ssgi_frame"
      for (const step of ssgi.steps({ desc, width, height, blur: 1 })) ..    // what is drawn, in order

   A desc is an object of the fields of ssgi_gl_desc (ssgi_gl.h; ssgi.choices lists them), enums by their words: the C
   name less its prefix. What is wrong with an argument is thrown as an Error with the library's sentence. */

const stages = ['vert', 'frag', 'tesc', 'tese', 'geom'];
const kinds = ['TEXTURE', 'PARAM', 'OUTPUT', 'CONSTANT', 'ATTRIBUTE', 'CAPTURE'];
const presets = ['FAST', 'BALANCED', 'BEST'];
const meanings = ['DEPTH', 'LAYERS', 'BACK', 'VIEWS', 'NORMAL', 'ALBEDO', 'LAYER_NORMALS', 'LAYER_ALBEDOS', 'DIRECT',
                  'NOISE', 'KERNEL', 'ENVIRONMENT', 'IRRADIANCE', 'LIGHTS', 'SHADOW', 'OCCLUDERS', 'FIELDS', 'OBJECTS',
                  'MOTION', 'AMBIENT'];                                         /* SSGI_GL_YOUR_ .. */
const results = ['NONE', 'LIGHT', 'BOUNCE'], sizes = ['FULL', 'HALF', 'LEVELS'];
const floats = { float: 1, int: 1, vec2: 2, ivec2: 2, vec4: 4, mat3: 12, mat4: 16 };     /* in std140 */

export async function load(source = new URL('ssgi.wasm', import.meta.url)) {
    if (source instanceof URL && source.protocol === 'file:')
        source = await (await import('node:fs/promises')).readFile(source);
    else if (typeof source === 'string' || source instanceof URL) source = await (await fetch(source)).arrayBuffer();
    const made = await WebAssembly.instantiate(source, { Math });
    return new Ssgi((made.instance ?? made).exports);
}

export class Ssgi {
    #c; #top; #strings;
    #at = {};                                   /* sizes and places by name */
    #of = {};                                   /* places: struct, member */

    constructor(exports) {
        this.#c = exports;
        this.#top = exports.__heap_base.value;
        for (let i = 0, at; (at = exports.ssgi_wasm_place_at(i)) !== 0; ++i) {
            const name = this.#string(this.#int(at)), [of, member] = name.split('.');
            this.#at[name] = this.#int(at + 4);
            if (member) (this.#of[of] ??= {})[member] = this.#at[name];
        }
        if (this.#at.meanings !== meanings.length) throw new Error('ssgi.mjs and ssgi.wasm are of different versions');
        const { ssgi_gl_choice: choice } = this.#of;
        this.#strings = { version: this.#at['ssgi_gl_desc.version'], fetch: this.#at['ssgi_gl_desc.fetch'] };
        this.version = `${this.#at.major}.${this.#at.minor}`;
        this.choices = this.#list(exports.ssgi_gl_choice_at, c => ({
            name: this.#string(this.#int(c + choice.name)), offset: this.#int(c + choice.offset),
            most: this.#int(c + choice.most),
            values: this.#string(this.#int(c + choice.values)).split(' ').filter(Boolean),
            sentence: this.#string(this.#int(c + choice.sentence)) }));
        this.members = this.#list(exports.ssgi_gl_member_at, row => this.#row(row));
        this.passes = this.#list(exports.ssgi_gl_pass_name, s => this.#string(s));
        this.dialects = this.#list(exports.ssgi_gl_dialect_name, s => this.#string(s));
    }

    /* The GLSL of a stage; '' where the pass has none. */
    text(desc, stage = 'frag') {
        return this.#scope(() => {
            const d = this.#good(desc), s = stages.indexOf(stage);
            if (s < 0) throw new Error(`stage: must be one of ${stages.join(' ')}`);
            const n = this.#c.ssgi_gl_emit(0, 0, d, s), out = this.#room(n + 1);
            this.#c.ssgi_gl_emit(out, n + 1, d, s);
            return this.#string(out);
        });
    }

    /* What to bind: ssgi_gl_io. */
    rows(desc) {
        return this.#scope(() => {
            const d = this.#good(desc), n = this.#c.ssgi_gl_reflect(d, 0, 0);
            const rows = this.#room(n * this.#at.ssgi_gl_io);
            this.#c.ssgi_gl_reflect(d, rows, n);
            return Array.from({ length: n }, (_, i) => this.#row(rows + i * this.#at.ssgi_gl_io));
        });
    }

    /* The draws of a chain in their order: ssgi_gl_chain's and ssgi_gl_step's members by their names, enums by their
       words less the prefix (an input's meaning null: a texture of the steps). */
    steps(chain) {
        return this.#scope(() => {
            const { ssgi_gl_chain: places, ssgi_gl_step: step } = this.#of;
            const size = this.#at.ssgi_gl_step, at = this.#room(this.#at.ssgi_gl_chain);
            for (const [name, value] of Object.entries(chain)) {
                if (!(name in places)) throw new Error(`chain.${name}: there is no such member`);
                if (name === 'desc' || name === 'lights') this.#desc(value, at + places[name]);
                else this.#setInt(at + places[name], Number(value));
            }
            const why = this.#room(4), n = this.#c.ssgi_gl_steps(0, 0, at, why);
            if (!n) throw new Error(this.#string(this.#int(why)));
            const steps = this.#room(n * size);
            this.#c.ssgi_gl_steps(steps, n, at, why);
            return Array.from({ length: n }, (_, i) => this.#step(steps + i * size, step, { ...chain.lights,
                                                                                            ...chain.desc }));
        });
    }

    check(desc) { this.#scope(() => this.#good(desc)); }
    key(desc) { return this.#scope(() => BigInt.asUintN(64, this.#c.ssgi_gl_key(this.#good(desc)))); }

    /* The desc with a preset's settings; with what its zeros mean. */
    preset(desc, preset) {
        return this.#scope(() => {
            const d = this.#desc(desc);
            this.#try(why => this.#c.ssgi_gl_preset(d, presets.indexOf(preset), why));
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

    /* An opaque ssgi_view. clip: 'GL', or 'ZERO' with EXT_clip_control's ZERO_TO_ONE. */
    view(projection, width, height, clip = 'GL') {
        return this.#scope(() => {
            const view = this.#room(this.#at.ssgi_view), m = this.#floats(projection);
            this.#try(why => this.#c.ssgi_view_from_projection(view, m, ['GL', 'ZERO'].indexOf(clip), width, height,
                                                               why));
            return this.#bytes(view, this.#at.ssgi_view).slice();
        });
    }

    /* { buffer, and each member of ssgi_gl_frame as a typed array in it } */
    frame(view, radius) {
        const frame = { buffer: new ArrayBuffer(this.#at.ssgi_gl_frame) };
        for (const m of this.members.filter(m => m.slot === 0)) {
            const [, type, count] = /^(\w+)(?:\[(\d+)\])?$/.exec(m.type);
            frame[m.name.slice('u_ssgi_'.length)] = new (/^i/.test(type) ? Int32Array : Float32Array)(
                frame.buffer, m.offset, floats[type] * (count ?? 1));
        }
        return this.#onFrame(frame, f => this.#try(why => this.#c.ssgi_gl_frame_init(f, this.#copy(view), radius,
                                                                                    why)));
    }

    /* view and lastWorldToView: of the last frame. Leave out after a cut or a change of size. */
    history(frame, view, worldToView, lastWorldToView) {
        return this.#onFrame(frame, f => this.#try(why => this.#c.ssgi_gl_frame_history(
            f, this.#copy(view), this.#floats(worldToView), this.#floats(lastWorldToView), why)));
    }
    harmonics(frame, coefficients, bands, worldToView = null) {
        return this.#onFrame(frame, f => this.#try(why => this.#c.ssgi_gl_harmonics_set(
            f, this.#floats(coefficients), bands, worldToView ? this.#floats(worldToView) : 0, why)));
    }
    phase(k) { return this.#c.ssgi_gl_phase(k); }

    /* ---- an environment: rgb, latitude-longitude, +y up, its centre toward +z (ssgi.h, >>environment and >>sh) */

    /* size * size * 3 floats: seen through a lobe, 0: irradiance over pi; over a cone; the residual of harmonics */
    environmentMap(size, rgb, width, height, solidAngle = 0) {
        return this.#map(size, (map, why) => this.#c.ssgi_environment_map(map, size, this.#floats(rgb), width, height,
                                                                          solidAngle, why));
    }
    environmentCone(size, rgb, width, height, cosine = 0) {
        return this.#map(size, (map, why) => this.#c.ssgi_environment_cone(map, size, this.#floats(rgb), width, height,
                                                                           cosine, why));
    }
    residual(size, map, coefficients, bands) {
        return this.#map(size, (at, why) => {
            this.#bytes(at, 12 * size * size).set(new Uint8Array(map.buffer, map.byteOffset, 12 * size * size));
            return this.#c.ssgi_sh_residual(at, size, this.#floats(coefficients), bands, 0, 0, why);
        });
    }
    projectEquirect(bands, rgb, width, height) {
        return this.#scope(() => {
            const out = this.#room(12 * bands * bands), from = this.#floats(rgb);
            this.#try(why => this.#c.ssgi_sh_project_equirect(out, bands, from, width, height, why));
            return new Float32Array(this.#bytes(out, 12 * bands * bands).slice().buffer);
        });
    }

    /* ---- rays against triangles: position xyz a vertex; index three a triangle, null: vertices in order. What it
       takes is kept for as long as this Ssgi is. */
    trace(position, index = null) {
        const triangles = (index ?? position).length / (index ? 3 : 9), size = this.#c.ssgi_trace_size(triangles);
        const trace = this.#room(this.#at.ssgi_trace), ray = this.#room(24), hit = this.#room(this.#at.ssgi_hit);
        const memory = this.#room(size);
        this.#scope(() => {
            const p = this.#floats(position);
            const i = index ? this.#copy(new Uint8Array(Uint32Array.from(index).buffer)) : 0;
            this.#try(why => this.#c.ssgi_trace_build(trace, memory, size, p, 12, i, triangles, why));
        });
        let floats = new Float32Array(0), ints;
        const send = (origin, direction) => {
            if (!floats.length) {                           /* it was another's memory that grew */
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
                send(origin, direction);
                return this.#c.ssgi_trace_any(trace, ray, ray + 12, tmin, tmax) === 1;
            },
            closest: (origin, direction, tmin, tmax) => {
                send(origin, direction);
                if (!this.#c.ssgi_trace_closest(trace, ray, ray + 12, tmin, tmax, hit)) return null;
                const at = hit >> 2;
                return { t: floats[at], u: floats[at + 1], v: floats[at + 2], triangle: ints[at + 3] };
            }
        };
    }

    /* ---- memory: what a call needs is taken from #top on, and given back when its scope ends */

    #scope(body) {
        const top = this.#top;
        try { return body(); } finally { this.#top = top; }
    }
    #room(bytes) {
        const at = (this.#top + 15) & ~15, memory = this.#c.memory;
        this.#top = at + bytes;
        const lacking = this.#top - memory.buffer.byteLength;
        if (lacking > 0) memory.grow(Math.ceil(lacking / 65536));
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
    #floats(numbers) { return this.#copy(new Uint8Array(Float32Array.from(numbers).buffer)); }
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
                 offset: this.#int(at + io.offset), format: this.#string(this.#int(at + io.format)) };
    }
    /* The ints at `at`, of each of these names. */
    #ints(at, places, names) {
        return Object.fromEntries(names.map(name => [name, this.#int(at + places[name])]));
    }
    #format(at) {
        const { ssgi_gl_format: f } = this.#of;
        return at && { name: this.#string(this.#int(at + f.name)),
                       ...this.#ints(at, f, ['internal', 'format', 'type', 'bytes']) };
    }
    #step(at, step, like) {
        const { ssgi_gl_input: i, ssgi_gl_output: o } = this.#of;
        const of = (count, first, size, item) => Array.from({ length: count }, (_, k) => item(first + k * size));
        const s = this.#ints(at, step, ['width', 'height', 'inputs', 'outputs', 'frame', 'primitive', 'vertices',
                                        'instances', 'clear']);
        return {
            ...s, desc: this.#object(at + step.desc, like), size: sizes[this.#int(at + step.size)],
            inputs: of(s.inputs, at + step.input, this.#at.ssgi_gl_input, k => ({
                ...this.#ints(k, i, ['unit', 'target', 'texture', 'last', 'width', 'height']),
                name: this.#string(this.#int(k + i.name)), type: this.#string(this.#int(k + i.type)),
                meaning: meanings[this.#int(k + i.meaning)] ?? null, format: this.#format(this.#int(k + i.format)) })),
            outputs: of(s.outputs, at + step.output, this.#at.ssgi_gl_output, k => ({
                ...this.#ints(k, o, ['texture', 'slices', 'slice', 'kept']), name: this.#string(this.#int(k + o.name)),
                format: this.#format(this.#int(k + o.format)), result: results[this.#int(k + o.result)] })),
            blend: of(3, at + step.blend, 4, k => this.#int(k)),
            clear_to: new DataView(this.#c.memory.buffer).getFloat32(at + step.clear_to, true)
        };
    }
    #map(size, call) {
        return this.#scope(() => {
            const map = this.#room(12 * size * size);
            this.#try(why => call(map, why));
            return new Float32Array(this.#bytes(map, 12 * size * size).slice().buffer);
        });
    }
    #try(call) {
        const why = this.#room(4);
        if (call(why)) throw new Error(this.#string(this.#int(why)));
    }
    #onFrame(frame, body) {
        this.#scope(() => {
            const f = this.#copy(new Uint8Array(frame.buffer));
            body(f);
            new Uint8Array(frame.buffer).set(this.#bytes(f, this.#at.ssgi_gl_frame));
        });
        return frame;
    }

    /* ---- a desc, by the names of its fields */

    #desc(desc, d = this.#room(this.#at.ssgi_gl_desc)) {
        for (const [name, value] of Object.entries(desc)) {
            if (name in this.#strings) {
                if (value != null)
                    this.#setInt(d + this.#strings[name], this.#copy(new TextEncoder().encode(value + '\0')));
                continue;
            }
            const choice = this.choices.find(c => c.name === name);
            if (!choice) throw new Error(`desc.${name}: there is no such field`);
            const number = typeof value === 'string' ? choice.values.indexOf(value) : Number(value);
            if (!Number.isInteger(number)) throw new Error(choice.sentence);
            this.#setInt(d + choice.offset, number);
        }
        return d;
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
