/* show.mjs - the last draws, onto the canvas: light times albedo, the views that compare, edges smoothed. Left and
   right are pictures of their own, so that what divides them moves over finished ones. */
import { harmonicsText } from './three.mjs';

const vertex = `#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }`;

/* Of each side: 0 ambient light as it is, 1 ambient visibility, 2 light, 3 light and a bounce, 4 the truth. */
const fragment = `#version 300 es
precision highp float;
uniform sampler2D t_depth, t_normal, t_albedo, t_direct, t_truth, t_light, t_bounce;
uniform vec3 u_sky[9];       // radiance as spherical harmonics
uniform mat3 u_world;        // view space to the world
uniform vec4 u_ray;          // a pixel's way in view space: xy * [0,1] + [2,3], -1
uniform int u_kind;
uniform int u_view;          // 0 lit, 1 ambient light alone, 2 difference
uniform int u_light;         // 1: the truth of light, else of visibility
uniform int u_traced;        // 1: there is a truth
uniform int u_step;          // pixels between those of t_truth
uniform int u_rough;         // 1: neighbours of t_truth on the same surface are averaged
uniform vec2 u_decode;       // 1 / view depth = x + y * window depth
uniform float u_sun, u_range;
uniform float u_exposure;    // a factor
uniform float u_effect;      // exponent of what occlusion leaves: 1 as it is; for the eye alone
out vec4 o_colour;

${harmonicsText('u_sky')}
vec3 coded(vec3 c) {
    return mix(12.92 * c, 1.055 * pow(max(c, 1e-6), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}
vec3 shown(vec3 c) { // the curve of film [Narkowicz 2016], then sRGB
    c = max(c, 0.0) * u_exposure;
    return coded(clamp(c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14), 0.0, 1.0));
}
float near(ivec2 p) { // 1 / view depth, which is linear on planes of the picture
    return u_decode.x + u_decode.y * texelFetch(t_depth, p, 0).x;
}
vec4 traced(ivec2 p) { // a: -1: nothing is known
    ivec2 last = textureSize(t_truth, 0) - 1, from = ivec2(u_step >> 1);
    ivec2 nearest = clamp((p - from + (u_step >> 1)) / u_step, ivec2(0), last);
    vec4 here = texelFetch(t_truth, nearest, 0), sum = vec4(0.0);
    if (u_rough == 0) return here;
    vec3 n = texelFetch(t_normal, p, 0).xyz;
    float at = near(p) / dot(n, vec3((vec2(p) + 0.5) * u_ray.xy + u_ray.zw, -1.0)), all = 0.0;
    for (int i = 0; i < 25; ++i) {
        ivec2 t = clamp(nearest + ivec2(i % 5 - 2, i / 5 - 2), ivec2(0), last), q = from + u_step * t;
        float there = near(q), plane = at * dot(n, vec3((vec2(q) + 0.5) * u_ray.xy + u_ray.zw, -1.0));
        vec4 of = texelFetch(t_truth, t, 0);
        vec2 off = max(2.5 - abs(vec2(p - q)) / float(u_step), 0.0);
        float weight = pow(max(dot(n, texelFetch(t_normal, q, 0).xyz), 0.0), 16.0) * off.x * off.y
            * exp2(-100.0 * abs(there / plane - 1.0)) * step(0.0, of.a);
        sum += weight * of;
        all += weight;
    }
    return all > 0.01 ? sum / all : here;
}
vec3 error(float e) { // from -1, too dark, to 1, too bright: the root, so that small ones are seen
    float a = sqrt(abs(e));
    vec3 white = vec3(0.96), middle = e < 0.0 ? vec3(0.45, 0.68, 0.9) : vec3(0.98, 0.62, 0.42);
    vec3 end = e < 0.0 ? vec3(0.05, 0.18, 0.55) : vec3(0.6, 0.02, 0.12);
    return a < 0.5 ? mix(white, middle, 2.0 * a) : mix(middle, end, 2.0 * a - 1.0);
}
void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    o_colour = vec4(0.0, 0.0, 0.0, 1.0);
    vec3 way = u_world * vec3(gl_FragCoord.xy * u_ray.xy + u_ray.zw, -1.0);
    if (texelFetch(t_depth, p, 0).x >= 1.0) {
        o_colour.rgb = u_view == 0 ? shown(harmonics(normalize(way), vec3(1.0)) * 0.6) : vec3(0.105, 0.11, 0.118);
        return;
    }
    vec3 n = normalize(u_world * texelFetch(t_normal, p, 0).xyz);
    vec3 open = harmonics(n, vec3(1.0, 0.6666667, 0.25)), light = open;
    vec4 seen = u_traced == 1 ? traced(p) : vec4(-1.0);
    bool known = seen.a >= 0.0;
    vec3 truth = u_light == 1 ? seen.rgb : open * seen.a;
    float visible = 1.0;
    vec4 of = texelFetch(t_light, p, 0);
    if (u_kind == 1) light = open * (visible = of.r);
    if (u_kind == 2 || u_kind == 3) light = of.rgb;
    if (u_kind == 3) light += texelFetch(t_bounce, p, 0).rgb;
    if (u_kind == 4 && known) { light = truth; visible = seen.a; }
    if (u_view < 2) {
        vec3 share = max(light, 0.0) / max(open, 1e-4); // above 1 is what a lamp adds
        light = open * pow(min(share, 1.0), vec3(u_effect)) * max(share, 1.0);
        visible = pow(visible, u_effect);
    }
    if (u_view == 0) {
        vec3 sun = texelFetch(t_direct, p, 0).rgb * u_sun;
        o_colour.rgb = shown(texelFetch(t_albedo, p, 0).rgb * light + sun);
    } else if (u_view == 1 || u_kind == 4) {
        o_colour.rgb = u_light == 1 ? shown(light) : vec3(visible);
    } else {
        float off = u_light == 1 ? dot(light - truth, vec3(0.3333333)) : visible - seen.a;
        o_colour.rgb = known ? error(clamp(off / u_range, -1.0, 1.0)) : vec3(0.5);
        o_colour.rgb *= 0.8 + 0.2 * dot(texelFetch(t_normal, p, 0).xyz, -normalize(way * u_world)); // as a relief
    }
}`;

/* Blends along edges of luminance [after Lottes 2009, FXAA]. */
const smooth = `#version 300 es
precision highp float;
uniform sampler2D t_left, t_right;
uniform vec2 u_texel;
uniform float u_split;       // right of so many pixels is right
uniform int u_plain;         // 1: edges are smooth
out vec4 o_colour;
vec3 at(vec2 p) {
    return gl_FragCoord.x > u_split ? textureLod(t_right, p, 0.0).rgb : textureLod(t_left, p, 0.0).rgb;
}
float luma(vec3 c) { return dot(c, vec3(0.299, 0.587, 0.114)); }
void main() {
    vec2 p = gl_FragCoord.xy * u_texel;
    vec3 here = at(p);
    vec4 l = vec4(luma(at(p + u_texel * vec2(-1.0, 1.0))), luma(at(p + u_texel)), luma(at(p - u_texel)),
                  luma(at(p + u_texel * vec2(1.0, -1.0)))); // nw ne sw se
    float m = luma(here), least = min(m, min(min(l.x, l.y), min(l.z, l.w)));
    float most = max(m, max(max(l.x, l.y), max(l.z, l.w)));
    o_colour = vec4(here, 1.0);
    if (u_plain == 1 || most - least < max(0.04, 0.1 * most)) return;
    vec2 way = vec2(l.z + l.w - l.x - l.y, l.x + l.z - l.y - l.w);
    float weak = max((l.x + l.y + l.z + l.w) * 0.03, 0.008);
    way = clamp(way / (min(abs(way.x), abs(way.y)) + weak), -8.0, 8.0) * u_texel;
    vec3 near = 0.5 * (at(p - way / 6.0) + at(p + way / 6.0));
    vec3 far = 0.5 * near + 0.25 * (at(p - 0.5 * way) + at(p + 0.5 * way));
    float found = luma(far);
    o_colour.rgb = found < least || found > most ? near : far;
}`;

/* View space normal and depth, for a file. */
const held = `#version 300 es
precision highp float;
uniform sampler2D t_depth, t_normal;
uniform vec2 u_decode;       // 1 / view depth = x + y * window depth
out vec4 o_frame;
void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    float d = texelFetch(t_depth, p, 0).x;
    o_frame = d < 1.0 ? vec4(texelFetch(t_normal, p, 0).xyz, 1.0 / (u_decode.x + u_decode.y * d)) : vec4(0.0);
}`;

/* Pixels from where a point was in the last frame to where it is. */
const motion = `#version 300 es
precision highp float;
uniform sampler2D t_depth, t_albedo;
uniform mat4 u_back, u_last, u_moved;
uniform vec2 u_size;
out vec2 o_motion;
void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    vec3 at = vec3(gl_FragCoord.xy / u_size, texelFetch(t_depth, p, 0).x) * 2.0 - 1.0;
    vec4 world = u_back * vec4(at, 1.0);
    vec4 was = (texelFetch(t_albedo, p, 0).a < 0.5 ? u_moved : u_last) * vec4(world.xyz / world.w, 1.0);
    o_motion = gl_FragCoord.xy - (was.xy / was.w * 0.5 + 0.5) * u_size;
}`;

/* The number of the object that is seen, 0: the scene. */
const objects = `#version 300 es
precision highp float;
uniform sampler2D t_albedo;
out highp uint o_object;
void main() {
    float mark = texelFetch(t_albedo, ivec2(gl_FragCoord.xy), 0).a;
    o_object = mark < 0.25 ? 1u : mark < 0.9 ? 2u : 0u;
}`;

const textures = ['t_depth', 't_normal', 't_albedo', 't_direct', 't_truth', 't_light', 't_bounce'];

export class Show {
    #gl; #drawer; #picture; #smooth; #held; #motion; #objects; #nothing; #sides = []; #means = [];
    #moved = null; #numbers = null;

    constructor(gl, drawer) {
        this.#gl = gl;
        this.#drawer = drawer;
        this.#picture = this.#program(fragment);
        this.#smooth = this.#program(smooth);
        this.#nothing = drawer.texture(1, 1, { internal: gl.RGBA8 });
    }

    #program(text) {
        const gl = this.#gl, program = gl.createProgram();
        for (const [kind, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, text]]) {
            const shader = gl.createShader(kind);
            gl.shaderSource(shader, source);
            gl.compileShader(shader);
            gl.attachShader(program, shader);
        }
        gl.linkProgram(program);
        return { program, place: null };
    }
    /* Places of its uniforms, looked up when it is first drawn: by then it is linked. */
    #use(of) {
        const gl = this.#gl, { program } = of;
        if (!of.place && !gl.getProgramParameter(program, gl.LINK_STATUS))
            throw new Error(gl.getProgramInfoLog(program));
        gl.useProgram(program);
        if (of.place) return of.place;
        of.place = {};
        for (let i = 0, unit = 0, n = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); i < n; ++i) {
            const { name, type } = gl.getActiveUniform(program, i), at = gl.getUniformLocation(program, name);
            of.place[name.replace('[0]', '')] = at;
            if (type === gl.SAMPLER_2D) gl.uniform1i(at, of === this.#picture ? textures.indexOf(name) : unit++);
        }
        return of.place;
    }
    /* mean: 0: replaces what is there; n: makes it the mean of n such pictures */
    #triangle(framebuffer, width, height, mean = 0) {
        const gl = this.#gl;
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
    #bind(list) {
        const gl = this.#gl;
        list.forEach((texture, unit) => {
            gl.activeTexture(gl.TEXTURE0 + unit);
            gl.bindTexture(gl.TEXTURE_2D, texture ?? this.#nothing);
        });
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

    /* Targets of that size, left and right. */
    #fit(list, width, height, internal) {
        if (list[0]?.width === width && list[0].height === height) return list;
        const gl = this.#gl;
        for (let i = 0; i < 2; ++i) {
            if (list[i]) this.#free(list[i]);
            list[i] = this.#target(width, height, internal);
            gl.bindTexture(gl.TEXTURE_2D, list[i].texture);
            for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
                gl.texParameteri(gl.TEXTURE_2D, name, gl.LINEAR);
            for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T])
                gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
        }
        return list;
    }

    /* sides: [left, right or null], each { light, bounce, kind, sun: 0 where its light has the sun's }. sample: 0: the
       picture of this frame; n: the n-th of those whose mean is shown. */
    draw(width, height, bound, sides,
         { sky, world, ray, view, light, split, range, exposure, effect, step, rough, decode }, sample) {
        const gl = this.#gl, at = this.#use(this.#picture);
        const targets = sample ? this.#fit(this.#means, width, height, gl.RGBA16F)
            : this.#fit(this.#sides, width, height, gl.RGBA8);
        gl.uniform3fv(at.u_sky, sky);
        gl.uniformMatrix3fv(at.u_world, false, world);
        gl.uniform4fv(at.u_ray, ray);
        gl.uniform1i(at.u_view, view);
        gl.uniform1i(at.u_light, light);
        gl.uniform1i(at.u_traced, +!!bound.t_truth);
        gl.uniform1i(at.u_step, step);
        gl.uniform1i(at.u_rough, rough);
        gl.uniform2fv(at.u_decode, decode);
        gl.uniform1f(at.u_range, range);
        gl.uniform1f(at.u_exposure, exposure);
        gl.uniform1f(at.u_effect, effect);
        sides.forEach((side, i) => {
            if (!side) return;
            this.#bind(textures.map(name => bound[name] ?? side[name]));
            gl.uniform1i(at.u_kind, side.kind);
            gl.uniform1f(at.u_sun, side.sun);
            this.#triangle(targets[i].framebuffer, width, height, sample);
        });
        this.place(width, height, split, view === 2 || sample > 0, sample);
    }

    /* What was drawn, divided elsewhere. plain: its edges are as they shall be. */
    place(width, height, split, plain, sample) {
        const gl = this.#gl, at = this.#use(this.#smooth), [left, right] = sample ? this.#means : this.#sides;
        this.#bind(Object.keys(at).filter(name => name.startsWith('t_'))
            .map(name => (name === 't_left' ? left : right).texture));
        gl.uniform2f(at.u_texel, 1 / width, 1 / height);
        gl.uniform1f(at.u_split, split);
        gl.uniform1i(at.u_plain, +plain);
        this.#triangle(null, width, height);
    }

    /* A texture for history, of Stage.reprojection. */
    motion(width, height, { DEPTH, ALBEDO }, { back, last, moved }) {
        const gl = this.#gl, at = this.#use(this.#motion ??= this.#program(motion));
        if (this.#moved?.width !== width || this.#moved.height !== height) {
            if (this.#moved) this.#free(this.#moved);
            this.#moved = this.#target(width, height, gl.RG16F);
        }
        this.#bind(Object.keys(at).filter(name => name.startsWith('t_'))
            .map(name => (name === 't_depth' ? DEPTH : ALBEDO)));
        gl.uniformMatrix4fv(at.u_back, false, back);
        gl.uniformMatrix4fv(at.u_last, false, last);
        gl.uniformMatrix4fv(at.u_moved, false, moved);
        gl.uniform2f(at.u_size, width, height);
        this.#triangle(this.#moved.framebuffer, width, height);
        return this.#moved.texture;
    }

    /* A texture of objects' numbers, for fields. */
    objects(width, height, { ALBEDO }) {
        const gl = this.#gl;
        this.#use(this.#objects ??= this.#program(objects));
        if (this.#numbers?.width !== width || this.#numbers.height !== height) {
            if (this.#numbers) this.#free(this.#numbers);
            this.#numbers = this.#target(width, height, gl.R8UI);
        }
        this.#bind([ALBEDO]);
        this.#triangle(this.#numbers.framebuffer, width, height);
        return this.#numbers.texture;
    }

    /* The G-buffer as numbers: N.X N.Y N.Z Z, bottom row first. */
    frame(width, height, { DEPTH, NORMAL }, decode) {
        const gl = this.#gl, target = this.#target(width, height, gl.RGBA32F);
        const all = new Float32Array(4 * width * height);
        const at = this.#use(this.#held ??= this.#program(held));
        this.#bind(Object.keys(at).filter(name => name.startsWith('t_'))
            .map(name => (name === 't_depth' ? DEPTH : NORMAL)));
        gl.uniform2fv(at.u_decode, decode);
        this.#triangle(target.framebuffer, width, height);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, all);
        this.#free(target);
        return Object.fromEntries(['N.X', 'N.Y', 'N.Z', 'Z'].map((name, c) => [name,
            Float32Array.from({ length: width * height }, (_, i) => all[4 * i + c])]));
    }
}
