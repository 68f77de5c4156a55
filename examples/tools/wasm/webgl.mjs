/* webgl.mjs - draws the steps of ssgi.steps() with WebGL 2 alone. No code here names a method; the draws, their order,
   inputs and outputs come from the steps.

      const drawer = new Drawer(gl, ssgi), run = drawer.run({ desc, width, height, blur: 1 });
      run.draw({ DEPTH: texture }, ssgi.frame(view, 0.5));        // your textures by their meanings
      run.light                                                   // a texture: ambient visibility, or light

   With desc.onto the last step draws onto the framebuffer PICTURE, or onto the canvas. Afterwards GL's tests, culling
   and blending are off: an engine that keeps a copy of GL's state must drop it. */

export class Drawer {
    #gl; #ssgi; #programs = new Map(); #reader = null;
    dialect = '300ES';
    language = 'GLSL';

    constructor(gl, ssgi) {
        this.#gl = gl;
        this.#ssgi = ssgi;
        this.array = gl.createVertexArray();
        /* nearest texels for any texture: its own filters may differ, and three.js compares depths of the sun's map */
        this.plain = gl.createSampler();
        for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
            gl.samplerParameteri(this.plain, name, gl.NEAREST);
        gl.getExtension('EXT_float_blend');         /* for depths that need 32 bits */
        /* engines assume that they own the first binding */
        this.binding = gl.getParameter(gl.MAX_UNIFORM_BUFFER_BINDINGS) - 1;
        this.timer = gl.getExtension('EXT_disjoint_timer_query_webgl2');
        /* tells without blocking whether a program is linked */
        this.parallel = gl.getExtension('KHR_parallel_shader_compile');
    }

    /* Begins a program at once; finish() waits for it. So many are linked in parallel. */
    program(desc) {
        const gl = this.#gl, key = this.#ssgi.key(desc);
        if (this.#programs.has(key)) return this.#programs.get(key);
        const program = gl.createProgram(), shaders = [];
        for (const [stage, kind] of [['vert', gl.VERTEX_SHADER], ['frag', gl.FRAGMENT_SHADER]]) {
            const shader = gl.createShader(kind);
            gl.shaderSource(shader, this.#ssgi.shader(desc, stage));
            gl.compileShader(shader);
            gl.attachShader(program, shader);
            shaders.push(shader);
        }
        gl.linkProgram(program);
        const made = { program, shaders, desc, finished: false };
        this.#programs.set(key, made);
        return made;
    }

    finish(made) {
        const gl = this.#gl, { program, shaders, desc } = made;
        if (made.finished) return program;
        if (!gl.getProgramParameter(program, gl.LINK_STATUS))
            throw new Error(`pass ${desc.pass}: ${shaders.map(s => gl.getShaderInfoLog(s)).join('')}${
                gl.getProgramInfoLog(program)}`);
        shaders.forEach(s => gl.deleteShader(s));
        gl.useProgram(program);
        const rows = this.#ssgi.rows(desc);
        for (const { kind, name, slot } of rows)
            if (kind === 'TEXTURE') gl.uniform1i(gl.getUniformLocation(program, name), slot);
        made.attributes = rows.some(({ kind }) => kind === 'ATTRIBUTE');
        const block = gl.getUniformBlockIndex(program, 'ssgi_frame');
        if (block !== gl.INVALID_INDEX) gl.uniformBlockBinding(program, block, this.binding);
        made.finished = true;
        return program;
    }

    linked({ program, finished }) {
        return finished || !this.parallel || this.#gl.getProgramParameter(program, this.parallel.COMPLETION_STATUS_KHR);
    }

    texture(width, height, { internal }, layers = 0) {
        const gl = this.#gl, target = layers ? gl.TEXTURE_2D_ARRAY : gl.TEXTURE_2D, texture = gl.createTexture();
        gl.bindTexture(target, texture);
        if (layers) gl.texStorage3D(target, 1, internal, width, height, layers);
        else gl.texStorage2D(target, 1, internal, width, height);
        for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(target, name, gl.NEAREST);
        return texture;
    }

    /* Resets the pixel-store settings, which three leaves changed. */
    plainUploads() {
        const gl = this.#gl;
        gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
        gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
        gl.pixelStorei(gl.UNPACK_ALIGNMENT, 4);
        gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, null);
    }

    /* A texture of four floats a texel, the first row first; given: a texture of that size to fill, else a new one is
       made. */
    floats(rgba, width, height, layers = 0, given = null) {
        const gl = this.#gl, target = layers ? gl.TEXTURE_2D_ARRAY : gl.TEXTURE_2D;
        const into = given ?? this.texture(width, height, { internal: gl.RGBA32F }, layers);
        this.plainUploads();
        gl.bindTexture(target, into);
        if (layers) gl.texSubImage3D(target, 0, 0, 0, 0, width, height, 1, gl.RGBA, gl.FLOAT, rgba);
        else gl.texSubImage2D(target, 0, 0, 0, width, height, gl.RGBA, gl.FLOAT, rgba);
        return into;
    }
    #from(texture) {
        const gl = this.#gl;
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.#reader ??= gl.createFramebuffer());
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    }
    copy(texture, format, width, height) {
        const gl = this.#gl;
        this.#from(texture);
        const made = this.texture(width, height, format);
        gl.copyTexSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 0, 0, width, height);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        return made;
    }
    /* Reads four numbers a texel; bytes become 0 to 1. */
    read(texture, format, width, height) {
        const gl = this.#gl, bytes = format.type === gl.UNSIGNED_BYTE;
        const all = new (bytes ? Uint8Array : Float32Array)(4 * width * height);
        this.#from(texture);
        gl.pixelStorei(gl.PACK_ALIGNMENT, 4);
        gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
        gl.readPixels(0, 0, width, height, gl.RGBA, bytes ? gl.UNSIGNED_BYTE : gl.FLOAT, all);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        return bytes ? Float32Array.from(all, v => v / 255) : all;
    }
    free(texture) { this.#gl.deleteTexture(texture); }
    shader(desc, stage) { return this.#ssgi.shader(desc, stage); }

    run(chain) { return new Run(this.#gl, this.#ssgi, this, chain); }

    /* Call it after its runs are freed. */
    dispose() {
        const gl = this.#gl;
        for (const { program } of this.#programs.values()) gl.deleteProgram(program);
        this.#programs.clear();
        gl.deleteSampler(this.plain);
        gl.deleteVertexArray(this.array);
        gl.deleteFramebuffer(this.#reader);
    }
}

/* A chain with its targets, of one size. */
class Run {
    #gl; #drawer; #block; #textures = []; #draws; #pending = []; #clocked = null;
    light = null;                                   /* result: ambient visibility or light; its format */
    format = null;
    bounce = null;
    ms = [];                                        /* of each step, if clocked */

    constructor(gl, ssgi, drawer, chain) {
        this.#gl = gl;
        this.#drawer = drawer;
        this.chain = chain;
        this.steps = ssgi.steps(chain);
        this.#block = gl.createBuffer();
        this.#draws = this.steps.map(step => this.#draw(step));
        this.#results();
    }

    #draw(step) {
        const gl = this.#gl, draw = { step, made: this.#drawer.program(step.desc), framebuffer: [] };
        if (step.outputs[0].texture < 0) return draw;           /* onto the picture */
        for (const { texture, format, layers, kept } of step.outputs)
            this.#textures[texture] ??= Array.from({ length: kept ? 2 : 1 },
                () => this.#drawer.texture(step.width, step.height, format, layers));
        for (let turn = 0; turn < (step.outputs.some(o => o.kept) ? 2 : 1); ++turn) {
            const attachments = step.outputs.map((_, i) => gl.COLOR_ATTACHMENT0 + i);
            gl.bindFramebuffer(gl.FRAMEBUFFER, draw.framebuffer[turn] = gl.createFramebuffer());
            step.outputs.forEach(({ texture, layers, layer }, i) => {
                const of = this.#textures[texture][turn] ?? this.#textures[texture][0];
                if (layers) gl.framebufferTextureLayer(gl.FRAMEBUFFER, attachments[i], of, 0, layer);
                else gl.framebufferTexture2D(gl.FRAMEBUFFER, attachments[i], gl.TEXTURE_2D, of, 0);
            });
            gl.drawBuffers(attachments);
            if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE)
                throw new Error(`this device cannot draw into ${step.outputs.map(o => o.format.name).join(', ')}`);
        }
        return draw;
    }

    #results() {
        for (const { outputs } of this.steps)
            for (const { result, texture, format } of outputs) {
                if (texture < 0) continue;                      /* onto the picture */
                if (result === 'LIGHT') { this.light = this.#textures[texture][0]; this.format = format; }
                if (result === 'BOUNCE') this.bounce = this.#textures[texture][0];
            }
    }

    get linked() { return this.#draws.every(({ made }) => this.#drawer.linked(made)); }

    /* yours: your textures by meaning, and PICTURE, the framebuffer that desc.onto draws onto (default: the canvas);
       array: the vertex array of a step with attributes; instances: of a step that has no number of its own. frame: of
       ssgi.frame(). clock: 1 times each step; 2 times it by waiting if there are no timer queries. */
    draw(yours, frame, clock = 0) {
        const gl = this.#gl, timer = clock === 1 ? this.#drawer.timer : null, queries = [];
        if (this.#pending.length) clock = 0;
        for (const state of [gl.DEPTH_TEST, gl.BLEND, gl.SCISSOR_TEST, gl.CULL_FACE, gl.STENCIL_TEST])
            gl.disable(state);
        gl.colorMask(true, true, true, true);
        gl.bindBuffer(gl.UNIFORM_BUFFER, this.#block);
        gl.bufferData(gl.UNIFORM_BUFFER, frame.buffer, gl.DYNAMIC_DRAW);
        gl.bindBufferBase(gl.UNIFORM_BUFFER, this.#drawer.binding, this.#block);
        this.#draws.forEach(({ step, made, framebuffer }, number) => {
            const program = this.#drawer.finish(made), turn = framebuffer.length - 1;
            for (const { name, unit, target, meaning, texture, last } of step.inputs) {
                const own = this.#textures[texture], of = meaning ? yours[meaning] : last ? own[1] ?? own[0] : own[0];
                if (!of) throw new Error(`pass ${step.desc.pass} reads ${name}, which nobody gives`);
                gl.activeTexture(gl.TEXTURE0 + unit);
                gl.bindTexture(target, of);
                gl.bindSampler(unit, this.#drawer.plain);
            }
            gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer[turn > 0 && this.turned ? 1 : 0] ?? yours.PICTURE ?? null);
            gl.viewport(0, 0, step.width, step.height);
            gl.useProgram(program);
            if (clock && timer) gl.beginQuery(timer.TIME_ELAPSED_EXT, queries[number] = gl.createQuery());
            const begun = clock === 2 ? (this.#wait(step), performance.now()) : 0;
            if (step.clear) step.outputs.forEach((_, i) => gl.clearBufferfv(gl.COLOR, i, Array(4).fill(step.clear_to)));
            if (step.blend[0]) {
                gl.enable(gl.BLEND);
                gl.blendEquation(step.blend[0]);
                gl.blendFunc(step.blend[1], step.blend[2]);
            }
            gl.bindVertexArray(made.attributes ? yours.array : this.#drawer.array);
            gl.drawArraysInstanced(step.primitive, 0, step.vertices, step.instances || yours.instances);
            gl.disable(gl.BLEND);
            for (const { unit } of step.inputs) gl.bindSampler(unit, null);
            if (clock && timer) gl.endQuery(timer.TIME_ELAPSED_EXT);
            if (clock === 2) { this.#wait(step); this.ms[number] = performance.now() - begun; }
        });
        if (queries.length) this.#pending = queries;
        gl.activeTexture(gl.TEXTURE0);
    }

    /* Waits for a step: a texel is read back, which comes after its drawing; in a browser gl.finish() need not wait. */
    #wait({ outputs: [{ format: { type, name } }] }) {
        const gl = this.#gl;
        gl.finish();
        if (name.endsWith('UI')) gl.readPixels(0, 0, 1, 1, gl.RGBA_INTEGER, gl.UNSIGNED_INT, new Uint32Array(4));
        else if (type === gl.UNSIGNED_BYTE) gl.readPixels(0, 0, 1, 1, gl.RGBA, type, new Uint8Array(4));
        else gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.FLOAT, new Float32Array(4));
    }

    /* Collects timer queries, which arrive some frames later; true: ms is new. */
    poll() {
        const gl = this.#gl, { timer } = this.#drawer, queries = this.#pending;
        if (!queries.length || !gl.getQueryParameter(queries.at(-1), gl.QUERY_RESULT_AVAILABLE)) return false;
        const torn = gl.getParameter(timer.GPU_DISJOINT_EXT);
        if (!torn) this.ms = queries.map(q => gl.getQueryParameter(q, gl.QUERY_RESULT) / 1e6);
        queries.forEach(q => gl.deleteQuery(q));
        this.#pending = [];
        return !torn;
    }
    get waiting() { return this.#pending.length > 0; }

    /* Call it after a frame whose history is kept: it exchanges both textures of each kept one. */
    turn() {
        for (const { outputs } of this.steps)
            for (const { texture, kept } of outputs) if (kept) this.#textures[texture].reverse();
        this.turned = !this.turned;
        this.#results();
    }

    free() {
        const gl = this.#gl;
        this.#pending.forEach(q => gl.deleteQuery(q));
        this.#textures.flat().forEach(t => gl.deleteTexture(t));
        this.#draws.forEach(({ framebuffer }) => framebuffer.forEach(f => gl.deleteFramebuffer(f)));
        gl.deleteBuffer(this.#block);
    }
}
