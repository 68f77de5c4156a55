/* webgpu-scene.mjs - the G-buffer in WebGPU: three.js' scene, camera and sun drawn as stage.mjs has WebGL 2 draw them,
   with its lambert material, its shadow map and the same noise in its edge. Row 0 of every target is the bottom one and
   depth is that of GL, so that ssgi's frames are the same bytes for both. */
import * as THREE from 'three';
import { drawTriangle } from './webgpu-triangle.mjs';

const text = `
struct Frame {
    project: mat4x4f,
    sun_from_view: mat4x4f,     // to the shadow map: 0 to 1
    way: vec4f,                 // to the sun in view space; normal bias
    colour: vec4f,              // irradiance over pi; depth bias
    shadow: vec4f,              // radius, in texels; 1 / size of the map
}
struct Part {
    to_view: mat4x4f,           // to the sun's clip space where its map is drawn
    normal: mat3x3f,
    map: mat3x3f,
    bumps: mat3x3f,
    colour: vec4f,
    is: vec4f,                  // 1: has colours; second uv for map, for bumps; alpha below which nothing is
    more: vec4f,                // 1: has bumps; 1: rests; -1: mirrored
}
@group(0) @binding(0) var<uniform> frame: Frame;
@group(0) @binding(1) var t_shadow: texture_depth_2d;
@group(0) @binding(2) var s_shadow: sampler_comparison;
@group(1) @binding(0) var<uniform> part: Part;
@group(2) @binding(0) var t_map: texture_2d<f32>;
@group(2) @binding(1) var s_map: sampler;
@group(2) @binding(2) var t_bumps: texture_2d<f32>;
@group(2) @binding(3) var s_bumps: sampler;
@group(3) @binding(0) var t_before: texture_depth_2d;

struct Corner {
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) colour: vec4f,
    @location(3) uv: vec4f,
}
struct Seen {
    @builtin(position) place: vec4f,
    @location(0) at: vec3f,
    @location(1) normal: vec3f,
    @location(2) colour: vec4f,
    @location(3) map: vec2f,
    @location(4) bumps: vec2f,
    @location(5) shadow: vec3f,
}
/* GL's clip space, turned upside down, in WebGPU's. */
fn turned(clip: vec4f) -> vec4f { return vec4f(clip.x, -clip.y, 0.5 * (clip.z + clip.w), clip.w); }

@vertex fn surface(c: Corner) -> Seen {
    var s: Seen;
    let at = part.to_view * vec4f(c.position, 1);
    s.place = turned(frame.project * at);
    s.at = at.xyz;
    s.normal = part.normal * c.normal;
    s.colour = select(vec4f(1), c.colour, part.is.x > 0);
    s.map = (part.map * vec3f(select(c.uv.xy, c.uv.zw, part.is.y > 0), 1)).xy;
    s.bumps = (part.bumps * vec3f(select(c.uv.xy, c.uv.zw, part.is.z > 0), 1)).xy;
    s.shadow = (frame.sun_from_view * vec4f(at.xyz + normalize(s.normal) * frame.way.w, 1)).xyz;
    return s;
}

struct Written { @location(0) direct: vec4f, @location(1) normal: vec4f, @location(2) albedo: vec4f }

fn lit(at: vec3f, place: vec2f) -> f32 {
    let p = at + vec3f(0, 0, frame.colour.w);
    let phi = 6.283185307 * fract(52.9829189 * fract(dot(place, vec2f(0.06711056, 0.00583715))));
    var sum = 0.0;
    for (var i = 0; i < 5; i++) {
        let turn = f32(i) * 2.399963229728653 + phi;
        let off = sqrt((f32(i) + 0.5) / 5) * vec2f(cos(turn), sin(turn)) * frame.shadow.x * frame.shadow.y;
        sum += textureSampleCompareLevel(t_shadow, s_shadow, p.xy + off, p.z);
    }
    let inside = all(p.xy >= vec2f(0)) && all(p.xy <= vec2f(1)) && p.z <= 1;
    return select(1, sum * 0.2, inside);
}

@fragment fn shade(s: Seen, @builtin(front_facing) front: bool) -> Written {
    let side = select(-1.0, 1.0, front) * part.more.z;
    var colour = part.colour * textureSample(t_map, s_map, s.map) * s.colour;
    let bumps = textureSample(t_bumps, s_bumps, s.bumps).xyz * 2 - 1;
    let q0 = dpdx(s.at);
    let q1 = dpdy(s.at);
    let st0 = dpdx(s.bumps);
    let st1 = dpdy(s.bumps);
    if (colour.a < part.is.w) { discard; }
    var normal = normalize(s.normal) * side;
    let tangent = cross(q1, normal) * st0.x + cross(normal, q0) * st1.x;
    let bitangent = cross(q1, normal) * st0.y + cross(normal, q0) * st1.y;
    let most = max(dot(tangent, tangent), dot(bitangent, bitangent));
    if (part.more.x > 0 && most > 0) {
        normal = normalize((tangent * bumps.x + bitangent * bumps.y) * inverseSqrt(most) * side + normal * bumps.z);
    }
    let level = clamp(dot(normal, frame.way.xyz), 0, 1) * lit(s.shadow, s.place.xy);
    return Written(vec4f(colour.rgb * level * frame.colour.rgb, 1), vec4f(normal, 0), vec4f(colour.rgb, part.more.y));
}

@vertex fn place(@location(0) position: vec3f) -> @builtin(position) vec4f {
    return turned(frame.project * (part.to_view * vec4f(position, 1))); }
@vertex fn from_sun(@location(0) position: vec3f) -> @builtin(position) vec4f {
    return turned(part.to_view * vec4f(position, 1)); }
@fragment fn behind(@builtin(position) p: vec4f) {
    let before = textureLoad(t_before, vec2u(p.xy), 0);
    if (before >= 1 || p.z <= before + 1e-7) { discard; }
}`;

const packed = `
@group(0) @binding(0) var t_0: texture_depth_2d;
@group(0) @binding(1) var t_1: texture_depth_2d;
@group(0) @binding(2) var t_2: texture_depth_2d;
@fragment fn pack(@builtin(position) p: vec4f) -> @location(0) vec4f {
    let at = vec2u(p.xy);
    return vec4f(textureLoad(t_0, at, 0), textureLoad(t_1, at, 0), textureLoad(t_2, at, 0), 0); }`;

const halved = `
@group(0) @binding(0) var t_whole: texture_2d<f32>;
@group(0) @binding(1) var s_whole: sampler;
@fragment fn half_of(@builtin(position) p: vec4f) -> @location(0) vec4f {
    let size = max(textureDimensions(t_whole) / 2, vec2u(1));
    return textureSampleLevel(t_whole, s_whole, p.xy / vec2f(size), 0); }`;

const partSize = 256, corner = 14;                  /* bytes of the struct Part; floats of the struct Corner */
const shadowSize = 2048;
const columns = ({ elements: e }) => [e[0], e[1], e[2], 0, e[3], e[4], e[5], 0, e[6], e[7], e[8], 0];   /* of a mat3 */
const wraps = { [THREE.RepeatWrapping]: 'repeat', [THREE.ClampToEdgeWrapping]: 'clamp-to-edge',
                [THREE.MirroredRepeatWrapping]: 'mirror-repeat' };

export class Scene {
    #device; #layouts; #pipelines; #frame; #sun; #shadow; #parts = null; #room = 0; #white; #size = {};
    #target = null; #back = []; #slabs = null; #materials = new WeakMap();
    #textures = new Map(); #geometries = new Map();     /* keys: three's textures and geometries */
    #samplers = new Map(); #shadowed = false;

    constructor(device) {
        this.#device = device;
        const uniform = dynamic => ({ visibility: 3, buffer: { hasDynamicOffset: dynamic } });
        const layout = entries => device.createBindGroupLayout({
            entries: entries.map((entry, binding) => ({ visibility: 2, ...entry, binding })) });
        const depth = { texture: { sampleType: 'depth' } };
        this.#layouts = {
            frame: layout([uniform(false), depth, { sampler: { type: 'comparison' } }]),
            bare: layout([uniform(false)]),
            part: layout([uniform(true)]),
            maps: layout([{ texture: {} }, { sampler: {} }, { texture: {} }, { sampler: {} }]),
            none: layout([]), before: layout([depth])
        };
        this.#frame = device.createBuffer({ size: 176, usage: 64 | 8 });
        this.#shadow = device.createTexture({ size: [shadowSize, shadowSize], format: 'depth32float', usage: 4 | 16 });
        this.#sun = device.createSampler({ compare: 'less-equal', minFilter: 'linear', magFilter: 'linear' });
        this.#white = device.createTexture({ size: [1, 1], format: 'rgba8unorm', usage: 4 | 2 });
        device.queue.writeTexture({ texture: this.#white }, new Uint8Array(4).fill(255), {}, [1, 1]);
    }

    /* Compiles the pipelines side by side; returns a promise. */
    async link() {
        const device = this.#device, module = device.createShaderModule({ code: text }), all = this.#layouts;
        const corners = [[0, 3], [12, 3], [24, 4], [40, 4]].map(([offset, n], shaderLocation) =>
            ({ shaderLocation, offset, format: `float32x${n}` }));
        const make = (groups, vertex, fragment, targets, cullMode, frontFace) => device.createRenderPipelineAsync({
            layout: device.createPipelineLayout({ bindGroupLayouts: groups.map(name => all[name]) }),
            vertex: { module, entryPoint: vertex, buffers: [{
                arrayStride: 4 * corner, attributes: vertex === 'surface' ? corners : corners.slice(0, 1) }] },
            fragment: fragment === null ? undefined
                : { module, entryPoint: fragment, targets: targets.map(format => ({ format })) },
            primitive: { cullMode, frontFace },
            depthStencil: { format: 'depth32float', depthWriteEnabled: true, depthCompare: 'less-equal' }
        });
        const made = await Promise.all([
            make(['frame', 'part', 'maps'], 'surface', 'shade', ['rgba16float', 'rgba16float', 'rgba8unorm'], 'none',
                 'cw'),
            make(['bare', 'part'], 'from_sun', null, [], 'none'),
            ...[['front', null], ['back', 'behind'], ['front', 'behind']].flatMap(([cull, fragment]) =>
                ['cw', 'ccw'].map(face => make(fragment ? ['bare', 'part', 'none', 'before'] : ['bare', 'part'],
                                               'place', fragment, [], cull, face)))
        ]);
        const [surface, sun, ...peels] = made;
        this.#pipelines = { surface, sun, peels: [0, 2, 4].map(i => peels.slice(i, i + 2)) };
    }

    /* ---- three's geometries and textures, in buffers and textures of WebGPU */

    #geometry(mesh) {
        const { geometry } = mesh, posed = mesh.isSkinnedMesh || mesh.morphTargetInfluences?.length;
        const key = posed ? mesh : geometry;
        if (this.#geometries.has(key)) return this.#geometries.get(key);
        const device = this.#device, shape = posed ? asPosed(mesh) : geometry, { attributes, index } = shape;
        const { count } = attributes.position, all = new Float32Array(corner * count);
        [['position', 0, 3], ['normal', 3, 3], ['color', 6, 4], ['uv', 10, 2], ['uv1', 12, 2]]
            .forEach(([name, at, most]) => {
                const from = attributes[name], get = ['getX', 'getY', 'getZ', 'getW'];
                if (name === 'color') for (let i = 0; i < count; ++i) all.fill(1, corner * i + 6, corner * i + 10);
                for (let c = 0; from && c < Math.min(most, from.itemSize); ++c)
                    for (let i = 0; i < count; ++i) all[corner * i + at + c] = from[get[c]](i);
            });
        const upload = (data, usage) => {
            const buffer = device.createBuffer({ size: Math.max(4, data.byteLength), usage: usage | 8 });
            device.queue.writeBuffer(buffer, 0, data);
            return buffer;
        };
        const list = index && Uint32Array.from({ length: index.count }, (_, i) => index.getX(i));
        const made = { corners: upload(all, 32), index: list && upload(list, 16), count: list ? list.length : count };
        this.#geometries.set(key, made);
        geometry.addEventListener('dispose', () => {
            made.corners.destroy();
            made.index?.destroy();
            this.#geometries.delete(key);
        });
        return made;
    }

    #texture(from, linear) {
        if (!from?.image) return this.#white;
        if (this.#textures.has(from)) return this.#textures.get(from);
        const device = this.#device, { image } = from, most = device.limits.maxTextureDimension2D;
        const width = Math.min(image.width, most), height = Math.min(image.height, most);
        const levels = from.generateMipmaps === false ? 1 : 1 + Math.floor(Math.log2(Math.max(width, height)));
        const format = !linear && from.colorSpace === THREE.SRGBColorSpace ? 'rgba8unorm-srgb' : 'rgba8unorm';
        const texture = device.createTexture({ size: [width, height], format, mipLevelCount: levels,
                                               usage: 2 | 4 | 16 });
        if (image.data) device.queue.writeTexture({ texture }, new Uint8Array(image.data.buffer ?? image.data),
                                                  { bytesPerRow: 4 * width }, [width, height]);
        else device.queue.copyExternalImageToTexture(
            { source: image, flipY: from.flipY && !isBitmap(image) }, { texture }, [width, height]);
        if (levels > 1) this.#shrink(texture, levels);
        this.#textures.set(from, texture);
        return texture;
    }

    /* Makes the mip levels of a texture: each is half as wide as the one before. */
    #shrink(texture, levels) {
        const device = this.#device, { format } = texture, encoder = device.createCommandEncoder();
        const view = baseMipLevel => texture.createView({ baseMipLevel, mipLevelCount: 1 });
        for (let level = 1; level < levels; ++level)
            drawTriangle(device, encoder, halved, { view: view(level), format },
                         [view(level - 1), this.#sampler(null)]);
        device.queue.submit([encoder.finish()]);
    }

    #sampler(from) {
        const nearest = [THREE.NearestFilter, THREE.NearestMipmapNearestFilter, THREE.NearestMipmapLinearFilter];
        const filter = kind => (nearest.includes(kind) ? 'nearest' : 'linear');
        const filters = !from ? { minFilter: 'linear', magFilter: 'linear' } : {
            minFilter: filter(from.minFilter), magFilter: filter(from.magFilter),
            mipmapFilter: /Nearest$/.test(from.minFilter) ? 'nearest' : 'linear' };
        const smooth = Object.values(filters).every(kind => kind === 'linear');    /* anisotropy needs linear filters */
        const like = !from ? filters : { addressModeU: wraps[from.wrapS], addressModeV: wraps[from.wrapT], ...filters,
                                         maxAnisotropy: smooth ? from.anisotropy : 1 };
        const key = JSON.stringify(like);
        if (!this.#samplers.has(key)) this.#samplers.set(key, this.#device.createSampler(like));
        return this.#samplers.get(key);
    }

    #group(layout, resources) {
        return this.#device.createBindGroup({ layout: this.#layouts[layout],
                                              entries: resources.map((resource, binding) => ({ binding, resource })) });
    }

    #maps(material) {
        if (!this.#materials.has(material)) {
            const { map, normalMap } = material;
            this.#materials.set(material, this.#group('maps', [
                this.#texture(map).createView(), this.#sampler(map),
                this.#texture(normalMap, true).createView(), this.#sampler(normalMap)]));
            material.addEventListener('dispose', () => {
                for (const from of [map, normalMap]) {
                    this.#textures.get(from)?.destroy();
                    this.#textures.delete(from);
                }
            });
        }
        return this.#materials.get(material);
    }

    /* ---- the list of draws: a part for each material of each mesh, and for each instance */

    #list(scene) {
        const list = [], matrix = new THREE.Matrix4();
        scene.traverseVisible(mesh => {
            if (!mesh.isMesh) return;
            const { material, geometry } = mesh, shape = this.#geometry(mesh), { start, count } = geometry.drawRange;
            const whole = [{ start, count, materialIndex: 0 }], many = Array.isArray(material);
            for (let i = 0; i < (mesh.isInstancedMesh ? mesh.count : 1); ++i) {
                const model = mesh.matrixWorld.clone();
                if (mesh.isInstancedMesh) { mesh.getMatrixAt(i, matrix); model.multiply(matrix); }
                for (const group of many ? geometry.groups : whole) {
                    const first = Math.max(group.start, start);
                    const end = Math.min(group.start + group.count, start + count, shape.count);
                    const is = many ? material[group.materialIndex] : material;
                    if (is && end > first) list.push({ model, shape, material: is, first, count: end - first });
                }
            }
        });
        return list;
    }

    /* Writes each part's uniforms twice: for the camera and for the sun. */
    #fill(list, camera, sun) {
        const device = this.#device, data = new Float32Array(2 * list.length * partSize / 4);
        const to = new THREE.Matrix4(), normal = new THREE.Matrix3(), none = new THREE.Matrix3();
        const fromSun = sun.projectionMatrix.clone().multiply(sun.matrixWorldInverse);
        const uv = texture => {
            if (texture?.matrixAutoUpdate) texture.updateMatrix();
            return columns(texture?.matrix ?? none);
        };
        list.forEach(({ model, material }, i) => {
            const { map, normalMap, color, alphaTest, vertexColors, userData } = material, at = i * partSize / 4;
            to.multiplyMatrices(camera.matrixWorldInverse, model);
            data.set(to.elements, at);
            data.set(columns(normal.getNormalMatrix(to)), at + 16);
            data.set(uv(map), at + 28);
            data.set(uv(normalMap), at + 40);
            data.set([color.r, color.g, color.b, 1, +vertexColors, +(map?.channel > 0), +(normalMap?.channel > 0),
                      alphaTest, +!!normalMap?.image, +!userData.moves, model.determinant() < 0 ? -1 : 1, 0], at + 52);
            data.set(to.multiplyMatrices(fromSun, model).elements, at + list.length * partSize / 4);
        });
        if (this.#room < data.byteLength) {
            this.#parts?.destroy();
            this.#room = 2 * data.byteLength;
            this.#parts = device.createBuffer({ size: this.#room, usage: 64 | 8 });
        }
        device.queue.writeBuffer(this.#parts, 0, data);
    }

    #light({ camera, sun }) {
        const way = sun.position.clone().sub(sun.target.position).transformDirection(camera.matrixWorldInverse);
        const { shadow, color, intensity } = sun, level = intensity / Math.PI;
        const fromView = shadow.matrix.clone().multiply(camera.matrixWorld);
        this.#device.queue.writeBuffer(this.#frame, 0, Float32Array.from([
            ...camera.projectionMatrix.elements, ...fromView.elements, ...way.toArray(), shadow.normalBias,
            color.r * level, color.g * level, color.b * level, shadow.bias, shadow.radius, 1 / shadowSize, 0, 0]));
    }

    #draw(pass, list, parts, each, offset = 0) {
        list.forEach((part, i) => {
            const { shape, first, count } = part;
            each?.(part);
            pass.setBindGroup(1, parts, [(offset + i) * partSize]);
            pass.setVertexBuffer(0, shape.corners);
            if (shape.index) {
                pass.setIndexBuffer(shape.index, 'uint32');
                pass.drawIndexed(count, 1, first);
            } else pass.draw(count, 1, first);
        });
        pass.end();
    }

    #fit(width, height) {
        if (this.#size.width === width && this.#size.height === height) return;
        this.#size = { width, height };
        const device = this.#device;
        for (const texture of [...Object.values(this.#target ?? {}), ...this.#back, this.#slabs]) texture?.destroy();
        const made = format => device.createTexture({ size: [width, height], format, usage: 1 | 4 | 16 });
        this.#target = { DIRECT: made('rgba16float'), NORMAL: made('rgba16float'), ALBEDO: made('rgba8unorm'),
                         DEPTH: made('depth32float') };
        this.#back = [];
        this.#slabs = null;
    }

    /* Draws the G-buffer as Stage.draw does; width, height: those of the image. */
    draw(stage, backs, width, height) {
        const { scene, camera, sun, renderer } = stage, device = this.#device, encoder = device.createCommandEncoder();
        this.#fit(width, height);
        scene.updateMatrixWorld();
        camera.updateMatrixWorld();
        sun.shadow.updateMatrices(sun);
        const list = this.#list(scene);
        this.#fill(list, camera, sun.shadow.camera);
        this.#light(stage);
        const depth = texture => ({ view: texture.createView(), depthClearValue: 1, depthLoadOp: 'clear',
                                    depthStoreOp: 'store' });
        const parts = this.#group('part', [{ buffer: this.#parts, size: partSize }]);
        const bare = this.#group('bare', [{ buffer: this.#frame }]);
        if (renderer.shadowMap.needsUpdate || !this.#shadowed) {
            const pass = encoder.beginRenderPass({ colorAttachments: [], depthStencilAttachment: depth(this.#shadow) });
            pass.setPipeline(this.#pipelines.sun);
            pass.setBindGroup(0, bare);
            this.#draw(pass, list, parts, null, list.length);
            this.#shadowed = true;
            renderer.shadowMap.needsUpdate = false;
        }
        const { DIRECT, NORMAL, ALBEDO, DEPTH } = this.#target, pass = encoder.beginRenderPass({
            colorAttachments: [DIRECT, NORMAL, ALBEDO].map(texture => ({
                view: texture.createView(), loadOp: 'clear', storeOp: 'store', clearValue: [0, 0, 0, 0] })),
            depthStencilAttachment: depth(DEPTH) });
        pass.setPipeline(this.#pipelines.surface);
        pass.setBindGroup(0, this.#group('frame', [{ buffer: this.#frame }, this.#shadow.createView(), this.#sun]));
        this.#draw(pass, list, parts, ({ material }) => pass.setBindGroup(2, this.#maps(material)));
        for (let i = 0; i < backs; ++i) this.#peel(encoder, i, list, parts, bare, depth);
        if (backs > 1) this.#pack(encoder);
        device.queue.submit([encoder.finish()]);
        return { ...this.#target, SHADOW: this.#shadow, backs,
                 BACK: backs > 1 ? this.#slabs : backs ? this.#back[0] : null };
    }

    #peel(encoder, i, list, parts, bare, depth) {
        const { width, height } = this.#size;
        this.#back[i] ??= this.#device.createTexture({ size: [width, height], format: 'depth32float',
                                                       usage: 1 | 4 | 16 });
        const pass = encoder.beginRenderPass({ colorAttachments: [], depthStencilAttachment: depth(this.#back[i]) });
        pass.setBindGroup(0, bare);
        if (i) {
            pass.setBindGroup(2, this.#group('none', []));
            pass.setBindGroup(3, this.#group('before', [this.#back[i - 1].createView()]));
        }
        this.#draw(pass, list, parts,
                   ({ model }) => pass.setPipeline(this.#pipelines.peels[i][+(model.determinant() < 0)]));
    }

    #pack(encoder) {
        const { width, height } = this.#size, format = 'rgba32float';
        this.#slabs ??= this.#device.createTexture({ size: [width, height], format, usage: 1 | 4 | 16 });
        drawTriangle(this.#device, encoder, packed, { view: this.#slabs.createView(), format },
                     this.#back.map(texture => texture.createView()));
    }
}

/* Bitmaps are already turned as their loader asked for. */
const isBitmap = image => typeof ImageBitmap !== 'undefined' && image instanceof ImageBitmap;

/* Returns the triangles of a mesh with its bones or morphs applied. */
function asPosed(mesh) {
    const shape = mesh.geometry.clone(), { position } = shape.attributes, p = new THREE.Vector3();
    const at = new Float32Array(3 * position.count);
    for (let i = 0; i < position.count; ++i) mesh.getVertexPosition(i, p).toArray(at, 3 * i);
    shape.setAttribute('position', new THREE.BufferAttribute(at, 3));
    shape.computeVertexNormals();
    return shape;
}
