/* ssgi.mjs - ssgi in JavaScript: loads ssgi.wasm (make wasm), no dependency, in a page or in node.

      import { load } from './ssgi.mjs';
      const ssgi = await load();                             // or a URL, bytes, a WebAssembly.Module
      const desc = ssgi.preset({ pass: 'HSAO', dialect: '300ES', normal: 'FROM_DEPTH' }, 'BALANCED');
      gl.shaderSource(shader, ssgi.text(desc, 'frag'));      // and 'vert'
      for (const row of ssgi.rows(desc)) ..                  // { name: 't_ssgi_depth', kind: 'TEXTURE', slot: 0, .. }
      const view = ssgi.view(projection, width, height);     // projection: 16 numbers, as GL has them
      const frame = ssgi.frame(view, 0.5);                   // frame.thickness[0] = 0.2; ..
      gl.bufferSubData(gl.UNIFORM_BUFFER, 0, frame.buffer);  // the block "ssgi_frame"

   A desc is an object of the fields of ssgi_gl_desc (ssgi_gl.h; ssgi.choices lists them), enums by their words: the C
   name less its prefix. What is wrong with an argument is thrown as an Error with the library's sentence. */

const stages = ['vert', 'frag', 'tesc', 'tese', 'geom'];
const kinds = ['TEXTURE', 'PARAM', 'OUTPUT', 'CONSTANT', 'ATTRIBUTE', 'CAPTURE'];
const presets = ['FAST', 'BALANCED', 'BEST'];
const floats = { float: 1, int: 1, vec2: 2, ivec2: 2, vec4: 4, mat3: 12, mat4: 16 };     /* in std140 */

export async function load(source = new URL('ssgi.wasm', import.meta.url)) {
    if (source instanceof URL && source.protocol === 'file:')
        source = await (await import('node:fs/promises')).readFile(source);
    else if (typeof source === 'string' || source instanceof URL) source = await (await fetch(source)).arrayBuffer();
    const made = await WebAssembly.instantiate(source, { Math });
    return new Ssgi((made.instance ?? made).exports);
}

export class Ssgi {
    #c; #top; #size; #io; #strings;

    constructor(exports) {
        this.#c = exports;
        this.#top = exports.__heap_base.value;
        const at = exports.ssgi_wasm_layout();
        const [view, desc, frame, views, io, version, fetch, name, values, sentence, offset, most, ...rest] =
            Array.from({ length: 20 }, (_, i) => this.#int(at + 4 * i));
        this.#size = { view, desc, frame, views, io };
        this.#strings = { version, fetch };
        this.#io = rest;
        this.version = `${rest[6]}.${rest[7]}`;
        this.choices = this.#list(exports.ssgi_gl_choice_at, c => ({
            name: this.#string(this.#int(c + name)), offset: this.#int(c + offset), most: this.#int(c + most),
            values: this.#string(this.#int(c + values)).split(' ').filter(Boolean),
            sentence: this.#string(this.#int(c + sentence)) }));
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
            const d = this.#good(desc), n = this.#c.ssgi_gl_reflect(d, 0, 0), rows = this.#room(n * this.#size.io);
            this.#c.ssgi_gl_reflect(d, rows, n);
            return Array.from({ length: n }, (_, i) => this.#row(rows + i * this.#size.io));
        });
    }

    /* steps(desc): ssgi_gl_steps goes here */

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
            const d = this.#good(desc), out = this.#room(this.#size.desc);
            this.#c.ssgi_gl_resolve(out, d);
            return this.#object(out, desc);
        });
    }

    /* An opaque ssgi_view. clip: 'GL', or 'ZERO' with EXT_clip_control's ZERO_TO_ONE. */
    view(projection, width, height, clip = 'GL') {
        return this.#scope(() => {
            const view = this.#room(this.#size.view), m = this.#floats(projection);
            this.#try(why => this.#c.ssgi_view_from_projection(view, m, ['GL', 'ZERO'].indexOf(clip), width, height,
                                                               why));
            return this.#bytes(view, this.#size.view).slice();
        });
    }

    /* { buffer, and each member of ssgi_gl_frame as a typed array in it } */
    frame(view, radius) {
        const frame = { buffer: new ArrayBuffer(this.#size.frame) };
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
        const [name, kind, type, slot, offset, format] = this.#io.map(o => this.#int(at + o));
        return { name: this.#string(name), kind: kinds[kind], type: this.#string(type), slot, offset,
                 format: this.#string(format) };
    }
    #try(call) {
        const why = this.#room(4);
        if (call(why)) throw new Error(this.#string(this.#int(why)));
    }
    #onFrame(frame, body) {
        this.#scope(() => {
            const f = this.#copy(new Uint8Array(frame.buffer));
            body(f);
            new Uint8Array(frame.buffer).set(this.#bytes(f, this.#size.frame));
        });
        return frame;
    }

    /* ---- a desc, by the names of its fields */

    #desc(desc) {
        const d = this.#room(this.#size.desc);
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
