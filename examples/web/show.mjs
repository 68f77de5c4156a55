/* show.mjs - the page's last draws, onto the canvas: light times albedo, views that compare, smoothed edges. The left
   and the right side have textures of their own, so that the line between them moves without drawing them again. */
import { pictureNumbers, textOf, texts } from './show-texts.mjs';

const vertex = `#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }`;

export class Show {
    #gl; #drawer; #programs = {}; #block; #nothing; #sides = []; #means = []; #moved = []; #numbers = [];

    constructor(gl, drawer) {
        this.#gl = gl;
        this.#drawer = drawer;
        this.#block = gl.createBuffer();
        this.#nothing = drawer.texture(1, 1, { internal: gl.RGBA8 });
        for (const name of ['picture', 'smooth']) this.#program(name);         /* compiled while the scene is fetched */
    }

    #program(name) {
        if (this.#programs[name]) return this.#programs[name];
        const gl = this.#gl, program = gl.createProgram();
        for (const [kind, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, textOf(name, '300ES')]]) {
            const shader = gl.createShader(kind);
            gl.shaderSource(shader, source);
            gl.compileShader(shader);
            gl.attachShader(program, shader);
        }
        gl.linkProgram(program);
        return this.#programs[name] = { program, linked: false };
    }
    #use(name) {
        const gl = this.#gl, made = this.#program(name), { program } = made;
        if (!made.linked && !gl.getProgramParameter(program, gl.LINK_STATUS))
            throw new Error(gl.getProgramInfoLog(program));
        gl.useProgram(program);
        if (made.linked) return;
        made.linked = true;
        texts[name].textures.forEach((texture, unit) => gl.uniform1i(gl.getUniformLocation(program, texture), unit));
        const block = gl.getUniformBlockIndex(program, 'block');
        if (block !== gl.INVALID_INDEX) gl.uniformBlockBinding(program, block, this.#drawer.binding);
    }

    /* Draws a shader's triangle into a target with its uniforms and textures. mean: 0: replaces the content; n: makes
       it the mean of n images. */
    #draw(name, { framebuffer, width, height }, numbers, textures, mean = 0) {
        const gl = this.#gl, data = new Float32Array(Math.ceil(numbers.length / 4) * 4);
        data.set(numbers);
        this.#use(name);
        gl.bindBufferBase(gl.UNIFORM_BUFFER, this.#drawer.binding, this.#block);
        gl.bufferData(gl.UNIFORM_BUFFER, data, gl.DYNAMIC_DRAW);
        textures.forEach((texture, unit) => {
            gl.activeTexture(gl.TEXTURE0 + unit);
            gl.bindTexture(gl.TEXTURE_2D, texture ?? this.#nothing);
        });
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        gl.viewport(0, 0, width, height);
        for (const state of [gl.DEPTH_TEST, gl.BLEND, gl.SCISSOR_TEST, gl.CULL_FACE, gl.STENCIL_TEST])
            gl.disable(state);
        gl.colorMask(true, true, true, true);
        if (mean > 1) {
            gl.enable(gl.BLEND);
            gl.blendEquation(gl.FUNC_ADD);
            gl.blendColor(0, 0, 0, 1 / mean);
            gl.blendFunc(gl.CONSTANT_ALPHA, gl.ONE_MINUS_CONSTANT_ALPHA);
        }
        gl.bindVertexArray(this.#drawer.array);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        gl.disable(gl.BLEND);
        gl.activeTexture(gl.TEXTURE0);
    }

    #target(width, height, internal) {
        const gl = this.#gl, texture = this.#drawer.texture(width, height, { internal });
        const framebuffer = gl.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
        return { width, height, texture, framebuffer };
    }
    #free({ texture, framebuffer }) {
        this.#gl.deleteTexture(texture);
        this.#gl.deleteFramebuffer(framebuffer);
    }

    /* Returns targets of that size, for the left and the right side. */
    #fit(list, width, height, internal, count = 2) {
        if (list[0]?.width === width && list[0].height === height) return list;
        const gl = this.#gl;
        for (let i = 0; i < count; ++i) {
            if (list[i]) this.#free(list[i]);
            list[i] = this.#target(width, height, internal);
            if (count === 1) continue;              /* the shader that smooths edges reads between texels */
            gl.bindTexture(gl.TEXTURE_2D, list[i].texture);
            for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
                gl.texParameteri(gl.TEXTURE_2D, name, gl.LINEAR);
            for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T])
                gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
        }
        return list;
    }

    /* Draws both sides. sides: [left, right or null], each { light, bounce, kind, sun: 0 if its light includes the
       sun's }. sample: 0: the image of this frame; n: the n-th of the images whose mean is shown. */
    draw(width, height, bound, sides, look, sample) {
        const gl = this.#gl, targets = sample ? this.#fit(this.#means, width, height, gl.RGBA16F)
            : this.#fit(this.#sides, width, height, gl.RGBA8);
        sides.forEach((side, i) => {
            if (!side) return;
            this.#draw('picture', targets[i], pictureNumbers(look, side, !!bound.t_truth),
                       texts.picture.textures.map(name => bound[name] ?? side[name]), sample);
        });
        this.place(width, height, look.split, look.view === 2 || sample > 0, sample);
    }

    /* Shows the sides as they were drawn, with the line at split. plain: without the smoothing of edges. */
    place(width, height, split, plain, sample) {
        const both = (sample ? this.#means : this.#sides).map(({ texture }) => texture);
        this.#draw('smooth', { framebuffer: null, width, height }, [width, height, split, +plain, 0], both);
    }

    /* Returns the motion texture for history, from the matrices of Stage.reprojection. */
    motion(width, height, { DEPTH, ALBEDO }, { back, last, moved }) {
        const [target] = this.#fit(this.#moved, width, height, this.#gl.RG16F, 1);
        this.#draw('motion', target, [...back, ...last, ...moved, width, height], [DEPTH, ALBEDO]);
        return target.texture;
    }

    /* Returns a texture of objects' numbers, for fields. */
    objects(width, height, { ALBEDO }) {
        const [target] = this.#fit(this.#numbers, width, height, this.#gl.R8UI, 1);
        this.#draw('objects', target, [0], [ALBEDO]);
        return target.texture;
    }

    /* Returns the G-buffer's channels N.X N.Y N.Z Z, bottom row first. */
    frame(width, height, { DEPTH, NORMAL }, decode) {
        const gl = this.#gl, target = this.#target(width, height, gl.RGBA32F);
        const all = new Float32Array(4 * width * height);
        this.#draw('held', target, decode, [DEPTH, NORMAL]);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, all);
        this.#free(target);
        return Object.fromEntries(['N.X', 'N.Y', 'N.Z', 'Z'].map((name, c) => [name,
            Float32Array.from({ length: width * height }, (_, i) => all[4 * i + c])]));
    }
}
