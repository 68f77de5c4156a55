/* webgpu-show.mjs - the last draws in WebGPU: what show.mjs is for WebGL 2, whose text this follows line by line. Row 0
   is the bottom one, until the picture is put onto the canvas. */

const triangle = `
@vertex fn all(@builtin(vertex_index) v: u32) -> @builtin(position) vec4f {
    return vec4f(f32(v & 1) * 4 - 1, f32(v >> 1) * 4 - 1, 0, 1); }
`;

const picture = `${triangle}
struct Look {
    sky: array<vec4f, 9>,       // radiance as spherical harmonics
    world: mat3x3f,             // view space to the world
    ray: vec4f,                 // a pixel's way in view space: xy * [0,1] + [2,3], -1
    view: f32, light: f32, traced: f32, sun: f32,
    range: f32, exposure: f32, effect: f32, kind: f32,
    decode: vec2f,              // 1 / view depth = x + y * window depth
    step: f32,                  // pixels between those of t_truth
    rough: f32,                 // 1: neighbours of t_truth on the same surface are averaged
}
@group(0) @binding(0) var<uniform> look: Look;
@group(0) @binding(1) var t_depth: texture_2d<f32>;
@group(0) @binding(2) var t_normal: texture_2d<f32>;
@group(0) @binding(3) var t_albedo: texture_2d<f32>;
@group(0) @binding(4) var t_direct: texture_2d<f32>;
@group(0) @binding(5) var t_truth: texture_2d<f32>;
@group(0) @binding(6) var t_light: texture_2d<f32>;
@group(0) @binding(7) var t_bounce: texture_2d<f32>;

fn harmonics(n: vec3f, band: vec3f) -> vec3f {
    var l = look.sky[0].xyz * 0.282095 * band.x;
    l += (look.sky[1].xyz * n.y + look.sky[2].xyz * n.z + look.sky[3].xyz * n.x) * 0.488603 * band.y;
    l += (look.sky[4].xyz * 1.092548 * n.x * n.y + look.sky[5].xyz * 1.092548 * n.y * n.z
          + look.sky[6].xyz * (0.946175 * n.z * n.z - 0.315392) + look.sky[7].xyz * 1.092548 * n.x * n.z
          + look.sky[8].xyz * 0.546274 * (n.x * n.x - n.y * n.y)) * band.z;
    return max(l, vec3f(0));
}
fn coded(c: vec3f) -> vec3f {
    return mix(12.92 * c, 1.055 * pow(max(c, vec3f(1e-6)), vec3f(1 / 2.4)) - 0.055, step(vec3f(0.0031308), c));
}
fn shown(light: vec3f) -> vec3f { // the curve of film [Narkowicz 2016], then sRGB
    let c = max(light, vec3f(0)) * look.exposure;
    return coded(clamp(c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14), vec3f(0), vec3f(1)));
}
fn near(p: vec2i) -> f32 { // 1 / view depth, which is linear on planes of the picture
    return look.decode.x + look.decode.y * textureLoad(t_depth, p, 0).x;
}
fn traced(p: vec2i) -> vec4f { // a: -1: nothing is known
    let last = vec2i(textureDimensions(t_truth)) - 1;
    let apart = i32(look.step);
    let start = vec2i(apart >> 1);
    let nearest = clamp((p - start + (apart >> 1)) / apart, vec2i(0), last);
    let here = textureLoad(t_truth, nearest, 0);
    if (look.rough == 0) { return here; }
    let n = textureLoad(t_normal, p, 0).xyz;
    let at = near(p) / dot(n, vec3f((vec2f(p) + 0.5) * look.ray.xy + look.ray.zw, -1));
    var sum = vec4f(0);
    var all = 0.0;
    for (var i = 0; i < 25; i++) {
        let t = clamp(nearest + vec2i(i % 5 - 2, i / 5 - 2), vec2i(0), last);
        let q = start + apart * t;
        let plane = at * dot(n, vec3f((vec2f(q) + 0.5) * look.ray.xy + look.ray.zw, -1));
        let seen = textureLoad(t_truth, t, 0);
        let off = max(2.5 - abs(vec2f(p - q)) / look.step, vec2f(0));
        let weight = pow(max(dot(n, textureLoad(t_normal, q, 0).xyz), 0), 16) * off.x * off.y
            * exp2(-100 * abs(near(q) / plane - 1)) * step(0, seen.a);
        sum += weight * seen;
        all += weight;
    }
    return select(here, sum / max(all, 1e-6), all > 0.01);
}
fn error(e: f32) -> vec3f { // from -1, too dark, to 1, too bright: the root, so that small ones are seen
    let a = sqrt(abs(e));
    let middle = select(vec3f(0.98, 0.62, 0.42), vec3f(0.45, 0.68, 0.9), e < 0);
    let end = select(vec3f(0.6, 0.02, 0.12), vec3f(0.05, 0.18, 0.55), e < 0);
    return select(mix(middle, end, 2 * a - 1), mix(vec3f(0.96), middle, 2 * a), a < 0.5);
}
fn coloured(place: vec2f) -> vec3f {
    let p = vec2u(place);
    let way = look.world * vec3f(place * look.ray.xy + look.ray.zw, -1);
    if (textureLoad(t_depth, p, 0).x >= 1) {
        return select(vec3f(0.105, 0.11, 0.118), shown(harmonics(normalize(way), vec3f(1)) * 0.6), look.view == 0);
    }
    let n = normalize(look.world * textureLoad(t_normal, p, 0).xyz);
    let open = harmonics(n, vec3f(1, 0.6666667, 0.25));
    var seen = vec4f(-1);
    if (look.traced > 0) { seen = traced(vec2i(p)); }
    let known = seen.a >= 0;
    let truth = select(open * seen.a, seen.rgb, look.light > 0);
    let got = textureLoad(t_light, p, 0);
    var light = open;
    var visible = 1.0;
    if (look.kind == 1) { visible = got.r; light = open * visible; }
    if (look.kind == 2 || look.kind == 3) { light = got.rgb; }
    if (look.kind == 3) { light += textureLoad(t_bounce, p, 0).rgb; }
    if (look.kind == 4 && known) { light = truth; visible = seen.a; }
    if (look.view < 2) {
        let share = max(light, vec3f(0)) / max(open, vec3f(1e-4)); // above 1 is what a lamp adds
        light = open * pow(min(share, vec3f(1)), vec3f(look.effect)) * max(share, vec3f(1));
        visible = pow(visible, look.effect);
    }
    if (look.view == 0) {
        return shown(textureLoad(t_albedo, p, 0).rgb * light + textureLoad(t_direct, p, 0).rgb * look.sun);
    }
    if (look.view == 1 || look.kind == 4) { return select(vec3f(visible), shown(light), look.light > 0); }
    var off = select(visible - seen.a, dot(light - truth, vec3f(0.3333333)), look.light > 0);
    let map = select(vec3f(0.5), error(clamp(off / look.range, -1, 1)), known);
    return map * (0.8 + 0.2 * dot(textureLoad(t_normal, p, 0).xyz, -normalize(way * look.world))); // as a relief
}
@fragment fn main(@builtin(position) p: vec4f) -> @location(0) vec4f { return vec4f(coloured(p.xy), 1); }`;

/* Blends along edges of luminance [after Lottes 2009, FXAA]. */
const smooth = `${triangle}
struct Place { size: vec2f, split: f32, plain: f32, upright: f32 }
@group(0) @binding(0) var<uniform> place: Place;
@group(0) @binding(1) var t_left: texture_2d<f32>;
@group(0) @binding(2) var t_right: texture_2d<f32>;
@group(0) @binding(3) var s_both: sampler;
fn at(p: vec2f, right: bool) -> vec3f {
    let uv = p / place.size;
    if (right) { return textureSampleLevel(t_right, s_both, uv, 0).rgb; }
    return textureSampleLevel(t_left, s_both, uv, 0).rgb;
}
fn luma(c: vec3f) -> f32 { return dot(c, vec3f(0.299, 0.587, 0.114)); }
fn blended(p: vec2f, right: bool) -> vec3f {
    let here = at(p, right);
    let l = vec4f(luma(at(p + vec2f(-1, 1), right)), luma(at(p + 1, right)), luma(at(p - 1, right)),
                  luma(at(p + vec2f(1, -1), right))); // nw ne sw se
    let m = luma(here);
    let least = min(m, min(min(l.x, l.y), min(l.z, l.w)));
    let most = max(m, max(max(l.x, l.y), max(l.z, l.w)));
    if (place.plain > 0 || most - least < max(0.04, 0.1 * most)) { return here; }
    var way = vec2f(l.z + l.w - l.x - l.y, l.x + l.z - l.y - l.w);
    let weak = max((l.x + l.y + l.z + l.w) * 0.03, 0.008);
    way = clamp(way / (min(abs(way.x), abs(way.y)) + weak), vec2f(-8), vec2f(8));
    let near = 0.5 * (at(p - way / 6, right) + at(p + way / 6, right));
    let far = 0.5 * near + 0.25 * (at(p - 0.5 * way, right) + at(p + 0.5 * way, right));
    let found = luma(far);
    return select(far, near, found < least || found > most);
}
@fragment fn main(@builtin(position) p: vec4f) -> @location(0) vec4f {
    let seen = vec2f(p.x, select(p.y, place.size.y - p.y, place.upright > 0));
    return vec4f(blended(seen, p.x > place.split), 1);
}`;

/* Pixels from where a point was in the last frame to where it is. */
const motion = `${triangle}
struct Ways { back: mat4x4f, last: mat4x4f, moved: mat4x4f, size: vec2f }
@group(0) @binding(0) var<uniform> ways: Ways;
@group(0) @binding(1) var t_depth: texture_2d<f32>;
@group(0) @binding(2) var t_albedo: texture_2d<f32>;
@fragment fn main(@builtin(position) place: vec4f) -> @location(0) vec4f {
    let p = vec2u(place.xy);
    let world = ways.back * vec4f(vec3f(place.xy / ways.size, textureLoad(t_depth, p, 0).x) * 2 - 1, 1);
    let point = vec4f(world.xyz / world.w, 1);
    let last = ways.last * point;
    let moved = ways.moved * point;
    let was = select(last, moved, textureLoad(t_albedo, p, 0).a < 0.5);
    return vec4f(place.xy - (was.xy / was.w * 0.5 + 0.5) * ways.size, 0, 0);
}`;

const four = rgb => Array.from({ length: 9 }, (_, i) => [...rgb.slice(3 * i, 3 * i + 3), 0]).flat();
const rows = m => [0, 3, 6].flatMap(i => [m[i], m[i + 1], m[i + 2], 0]);

export class Show {
    #device; #context; #canvas; #format; #modules = new Map(); #pipelines = new Map(); #nothing; #linear; #blocks = {};
    #sides = []; #means = []; #moved = null;

    constructor(device, canvas) {
        this.#device = device;
        this.#canvas = canvas;
        this.#format = navigator.gpu.getPreferredCanvasFormat();
        this.#context = canvas.getContext('webgpu');
        this.#context.configure({ device, format: this.#format, alphaMode: 'opaque' });
        this.#nothing = device.createTexture({ size: [1, 1], format: 'rgba8unorm', usage: 4 });
        this.#linear = device.createSampler({ minFilter: 'linear', magFilter: 'linear' });
    }

    /* A triangle into a texture, that reads others. name: of its block. mean: 0: replaces what is there; n: makes it
       the mean of n such pictures. */
    #draw(code, into, name, numbers, textures, filters, mean = 0) {
        const device = this.#device, { format } = into, key = `${name.split(' ')[0]} ${format} ${mean > 1}`;
        const kind = filters ? 'float' : 'unfilterable-float';
        const by = { srcFactor: 'constant', dstFactor: 'one-minus-constant' };
        if (!this.#modules.has(code)) this.#modules.set(code, device.createShaderModule({ code }));
        if (!this.#pipelines.has(key)) {
            const layout = device.createBindGroupLayout({ entries: [{ binding: 0, visibility: 2, buffer: {} },
                ...textures.map((_, i) => ({ binding: 1 + i, visibility: 2, texture: { sampleType: kind } })),
                ...filters ? [{ binding: 1 + textures.length, visibility: 2, sampler: {} }] : []] });
            const module = this.#modules.get(code);
            const target = { format, ...mean > 1 && { blend: { color: by, alpha: by } } };
            this.#pipelines.set(key, { layout, pipeline: device.createRenderPipeline({
                layout: device.createPipelineLayout({ bindGroupLayouts: [layout] }),
                vertex: { module }, fragment: { module, targets: [target] } }) });
        }
        const data = Float32Array.from(numbers), { layout, pipeline } = this.#pipelines.get(key);
        const block = this.#blocks[name] ??= device.createBuffer({ size: Math.ceil(data.byteLength / 16) * 16,
                                                                   usage: 64 | 8 });
        device.queue.writeBuffer(block, 0, data);
        const group = device.createBindGroup({ layout, entries: [{ binding: 0, resource: { buffer: block } },
            ...textures.map((texture, i) => ({ binding: 1 + i, resource: (texture ?? this.#nothing).createView() })),
            ...filters ? [{ binding: 1 + textures.length, resource: this.#linear }] : []] });
        const encoder = device.createCommandEncoder(), pass = encoder.beginRenderPass({ colorAttachments: [{
            view: into.createView(), loadOp: mean > 1 ? 'load' : 'clear', storeOp: 'store' }] });
        pass.setPipeline(pipeline);
        pass.setBindGroup(0, group);
        if (mean > 1) pass.setBlendConstant([0, 1, 2, 3].map(() => 1 / mean));
        pass.draw(3);
        pass.end();
        device.queue.submit([encoder.finish()]);
    }

    #fit(list, width, height, format, count = 2) {
        if (list[0]?.width === width && list[0].height === height) return list;
        for (let i = 0; i < count; ++i) {
            list[i]?.destroy();
            list[i] = this.#device.createTexture({ size: [width, height], format, usage: 1 | 4 | 16 });
        }
        return list;
    }

    /* As Show.draw of show.mjs. */
    draw(width, height, bound, sides,
         { sky, world, ray, view, light, split, range, exposure, effect, step, rough, decode }, sample) {
        const targets = sample ? this.#fit(this.#means, width, height, 'rgba16float')
            : this.#fit(this.#sides, width, height, 'rgba8unorm');
        const { t_depth, t_normal, t_albedo, t_direct, t_truth } = bound;
        sides.forEach((side, i) => {
            if (!side) return;
            this.#draw(picture, targets[i], `picture ${i}`,
                       [...four(sky), ...rows(world), ...ray, view, light, +!!t_truth, side.sun, range, exposure,
                        effect, side.kind, ...decode, step, rough],
                       [t_depth, t_normal, t_albedo, t_direct, t_truth, side.t_light, side.t_bounce], false, sample);
        });
        this.place(width, height, split, view === 2 || sample > 0, sample);
    }

    place(width, height, split, plain, sample) {
        const canvas = this.#canvas;
        canvas.hidden = false;
        if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
        this.#put(this.#context.getCurrentTexture(), width, height, split, plain, sample, 1);
    }
    #put(into, width, height, split, plain, sample, upright) {
        const both = sample ? this.#means : this.#sides;
        this.#draw(smooth, into, `place ${upright}`, [width, height, split, +plain, upright], both, true);
    }

    /* What is on the canvas, bottom row first. */
    placed(width, height, split, plain, sample) {
        const texture = this.#device.createTexture({ size: [width, height], format: 'rgba8unorm', usage: 1 | 4 | 16 });
        this.#put(texture, width, height, split, plain, sample, 0);
        return texture;
    }

    motion(width, height, { DEPTH, ALBEDO }, { back, last, moved }) {
        this.#moved = this.#fit(this.#moved ?? [], width, height, 'rg16float', 1);
        this.#draw(motion, this.#moved[0], 'motion', [...back, ...last, ...moved, width, height, 0, 0], [DEPTH, ALBEDO],
                   false);
        return this.#moved[0];
    }
}
