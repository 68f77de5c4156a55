/* peers.mjs - effects of other libraries: three.js' GTAO, SSAO and SAO passes, its node effects (tsl.mjs), n8ao,
   Babylon.js' SSAO2 and PlayCanvas' SSAO, as plain GLSL for peers.c to draw.

      make peers                        installs the packages into build/peers, with this script beside them, where it
         finds them
      node peers.mjs OUT [quick] < view     quick: fewer

   Their own code drives them: each effect is rendered with a renderer that only writes its draws down, so that every
   text, uniform, kernel, noise texture, target and clear colour is theirs. Reads a view from stdin, as numbers: width,
   height, near, far, radius, its projection and world-to-view matrices (column-major), and the median view depth.
   Writes into OUT: N.vert and N.frag (without a version line, for GLSL 330 and ES 300); N.cost.vert and N.cost.frag
   (the same for Vulkan, with integer uniforms as constants, so that loops have known ends); N.f32 (texels);
   manifest.csv. Textures have numbers. The first four are the caller's: 0 window depth, 1 view normals as n/2 + 1/2,
   2 the picture, 3 view normals, 0 without a surface. The others follow as they appear. Lines of manifest.csv:

      texture    width, height, format (as GL numbers them), linear, repeat, file: its texels
      depth      a texture of the distance along the view times scale; empty: its value without a surface; linear
      peer       name, settings
      pass       number: N.vert and N.frag; shown: it only shows a finished result, and is no cost of the effect;
                 values: the clear colour; targets; width, height, bytes_in and bytes_out of all its texels
      sampler    name, number: a texture of the pass above
      uniform    type, name, count, values, of the pass above
      result     number: the texture of ambient visibility, red */
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import * as THREE from 'three';
import { GTAOPass } from 'three/addons/postprocessing/GTAOPass.js';
import { SSAOPass } from 'three/addons/postprocessing/SSAOPass.js';
import { SAOPass } from 'three/addons/postprocessing/SAOPass.js';
import { N8AOPass } from 'n8ao';
import { NullEngine } from '@babylonjs/core/Engines/nullEngine.js';
import { Scene } from '@babylonjs/core/scene.js';
import { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js';
import { Matrix, Vector3 } from '@babylonjs/core/Maths/math.vector.js';
import { GeometryBufferRenderer } from '@babylonjs/core/Rendering/geometryBufferRenderer.js';
import {
    SSAO2RenderingPipeline
} from '@babylonjs/core/PostProcesses/RenderPipeline/Pipelines/ssao2RenderingPipeline.js';
import { Logger } from '@babylonjs/core/Misc/logger.js';
import { tsl_draw } from './tsl.mjs';
import { AppBase, AppOptions, CameraFrame, NullGraphicsDevice, PIXELFORMAT_R8, RenderPassSsao } from 'playcanvas';

const v = readFileSync(0, 'utf8').trim().split(/\s+/).map(Number);
if (v.length !== 38 || v.some(n => !Number.isFinite(n))) {
    console.error('peers.mjs: a view is 38 numbers');
    process.exit(2);
}
const [width, height, near, far, radius] = v, middle = v[37];
const quick = process.argv[3] === 'quick', out = pathToFileURL(`${resolve(process.argv[2])}/`), lines = [];
const heads = [ 'kind', 'name', 'settings', 'number', 'width', 'height', 'format', 'linear', 'repeat', 'file', 'scale',
                'empty', 'shown', 'targets', 'type', 'count', 'values', 'bytes_in', 'bytes_out' ];
const line = of => lines.push(heads.map(head => `"${of[head] ?? ''}"`).join());
mkdirSync(out, { recursive: true });

Logger.LogLevels = Logger.ErrorLogLevel;

/* Makes Math.random the same sequence each time, as some effects make kernels and noise by it. */
let state;
Math.random = () => (state = (state * 48271) % 2147483647) / 2147483647;

/* ---- >>writing: textures, texts, uniforms ------------------------------------------------------------------------ */

const RGBA8 = 0x8058, RGBA16F = 0x881A, RGBA32F = 0x8814, R8 = 0x8229, R16F = 0x822D, R32F = 0x822E,
      R11F_G11F_B10F = 0x8C3A;
const sizes = { float: 1, int: 1, uint: 1, bool: 1, vec2: 2, vec3: 3, vec4: 4, mat3: 9, mat4: 16 };
const flat = value => value.toArray            ? value.toArray()
                      : value[Symbol.iterator] ? [...value ].flatMap(flat)
                                               : [ Number(value) ];

const numbers = new Map(), bytes = new Map([ [ R8, 1 ], [ RGBA16F, 8 ], [ RGBA32F, 16 ] ]);
/* The textures 0 to 3 of the caller: their width, height and bytes. */
const sized = [ 4, 8, 8, 8 ].map(texel => ({ width, height, bytes : texel * width * height }));
let programs = 0;

/* Returns a texture's number. A new texture is written, with the description that of(texture) returns. */
function number(texture, of) {
    if (!numbers.has(texture)) {
        const { width : w, height : h, format, linear, repeat, data } = of(texture), n = sized.length;
        if (!format) throw new Error('a texture of an unknown format');
        if (data)
            writeFileSync(new URL(`${n}.f32`, out), Float32Array.from(data, format === RGBA8 ? c => c / 255 : c => c));
        sized.push({ width : w, height : h, bytes : (bytes.get(format) ?? 4) * w * h });
        line({ kind : 'texture', width : w, height : h, format, linear : +linear, repeat : +repeat,
               file : data && `${n}.f32` });
        numbers.set(texture, n);
    }
    return numbers.get(texture);
}

/* Adds a texture of depth that replaces an effect's own depth texture. Returns its number. */
function depth(texture, scale, empty, linear) {
    numbers.set(texture, sized.length);
    sized.push({ width, height, bytes : 4 * width * height });
    line({ kind : 'depth', scale, empty, linear : +linear });
}

/* Writes a pass. value(), texture(): return the value of a uniform by its name, and the texture of a sampler. */
function pass({ vertex, fragment, shown, cleared, targets, value, texture }) {
    const n = programs++, uniforms = [], named = new Set();
    for (const [, type, length, name, also] of (vertex + fragment).matchAll(
             /\buniform\s+(?:(?:high|medium|low)p\s+)?(\w+)\s*(\[.*?\])?\s+(\w+)\s*(\[.*?\])?\s*;/g)) {
        const is = value(name);
        if (is === undefined || is === null || named.has(name)) continue;
        named.add(name);
        if (type === 'sampler2D') { uniforms.push({ kind : 'sampler', name, number : texture(is) }); continue; }
        if (!sizes[type]) throw new Error(`uniform ${type} ${name}`);
        const values = flat(is);
        uniforms.push({ kind : 'uniform', type, name, count : length || also ? values.length / sizes[type] : 1,
                        values : values.join(' ') });
    }
    const sum = list => list.reduce((all, number) => all + sized[number].bytes, 0);
    line({ kind : 'pass', number : n, shown : +!!shown, values : cleared?.join(' '), targets : targets.join(' '),
           ...sized[targets[0]], bytes_in : sum(uniforms.flatMap(is => is.number ?? [])), bytes_out : sum(targets) });
    uniforms.forEach(line);
    for (const [ending, text] of [ [ 'vert', vertex ], [ 'frag', fragment ] ]) {
        writeFileSync(new URL(`${n}.${ending}`, out), text);
        writeFileSync(new URL(`${n}.cost.${ending}`, out), uniforms.reduce(constant, vulkan + text));
    }
}
const vulkan = '#version 450\n#define gl_VertexID gl_VertexIndex\n';
const constant = (text, { type, name, count, values }) =>
    count === 1 && ([ 'int', 'uint', 'bool' ].includes(type) || name.includes('Count'))
        ? text.replace(`uniform ${type} ${name};`, `const ${type} ${name} = ${type}(${values.split(' ')});`) : text;

/* Rewrites a vertex shader without attributes: it draws one triangle that covers the picture. */
const triangle = (text, position, also = '') => `#define main peer_main
${text.replace(/\battribute\s+(\w+\s+\w+\s*;)/g, '$1')}
#undef main
void main() {
    ${position}.xy = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 4.0 - 1.0;
    ${also}
    peer_main();
}
`;
const older = (text, output) => `#define varying ${output ? 'in' : 'out'}
#define texture2D texture
${output ? 'layout(location = 0) out highp vec4 pc_fragColor;\n#define gl_FragColor pc_fragColor\n' : ''}${text}
`;

/* ---- >>three.js: a renderer, and the calls of an effect to it ---------------------------------------------------- */

const camera = new THREE.PerspectiveCamera();
camera.near = near;
camera.far = far;
camera.projectionMatrix.fromArray(v, 5);
camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
camera.matrixAutoUpdate = false;
camera.matrix.fromArray(v, 21).invert();
camera.updateMatrixWorld(true);

const formats = new Map([
    [ [ THREE.RGBAFormat, THREE.UnsignedByteType ], RGBA8 ], [ [ THREE.RGBAFormat, THREE.HalfFloatType ], RGBA16F ],
    [ [ THREE.RGBAFormat, THREE.FloatType ], RGBA32F ], [ [ THREE.RedFormat, THREE.UnsignedByteType ], R8 ],
    [ [ THREE.RedFormat, THREE.HalfFloatType ], R16F ], [ [ THREE.RedFormat, THREE.FloatType ], R32F ],
    [ [ THREE.RGBFormat, THREE.UnsignedInt101111Type ], R11F_G11F_B10F ]
].map(([ kind, format ]) => [kind.join(), format]));
const three_texture = texture => number(texture, ({ image, format, type, magFilter, wrapS }) => ({
    ...image, format : formats.get([ format, type ].join()), linear : magFilter === THREE.LinearFilter,
    repeat : wrapS === THREE.RepeatWrapping }));

const whole = text => text.replace(/^[ \t]*#include +<([\w\d./]+)>/gm, (line, name) => {
    if (!(name in THREE.ShaderChunk)) throw new Error(`no chunk ${name}`);
    return whole(THREE.ShaderChunk[name]);
});
const defines = material => Object.entries(material.defines ?? {})
                                .filter(([, value ]) => value !== false)
                                .map(([ name, value ]) => `#define ${name} ${value}\n`)
                                .join('');
const vertex = m => older(triangle(`${defines(m)}const mat4 projectionMatrix = mat4(1.0), modelViewMatrix = mat4(1.0);
vec3 position = vec3(0.0);
vec2 uv;
${whole(m.vertexShader)}`, 'position', 'uv = 0.5 * position.xy + 0.5;'), false);
const fragment = m => {
    const text = `${defines(m)}${whole(THREE.ShaderChunk.colorspace_pars_fragment)}
${whole(m.fragmentShader)}`;
    return m.glslVersion === THREE.GLSL3 ? `#define varying in\n#define texture2D texture\n${text}\n`
                                         : older(text, true);
};

class Renderer {
    capabilities = {};
    extensions = { has: () => true };
    xr = { enabled: false };
    autoClear = true;
    #target = null; #colour = new THREE.Color(0, 0, 0); #alpha = 1; #cleared = null; #result;

    constructor(picture, shown) { Object.assign(this, { picture, shown }); }
    getClearColor(colour) { return colour.copy(this.#colour); }
    getClearAlpha() { return this.#alpha; }
    setClearColor(colour, alpha = 1) { this.#colour.set(colour); this.#alpha = alpha; }
    setClearAlpha(alpha) { this.#alpha = alpha; }
    setRenderTarget(target) { this.#target = target; this.#cleared = null; }
    clear() { this.#cleared = this.#colour.clone(); }

    /* Scenes would draw the G-buffer, which the caller has already. All other objects are passes over the picture. */
    render(object) {
        const target = this.#target, m = object.material;
        if (object.isScene) {
            numbers.set(target.depthTexture, 0);
            numbers.set(target.texture, object.overrideMaterial ? 1 : 2);
            return;
        }
        if (target === this.picture) return;               /* this pass only blends the result with the picture */
        const targets = target.textures.map(three_texture);
        pass({ vertex: vertex(m), fragment: fragment(m), shown: target === this.shown,
               cleared: this.#cleared?.toArray(), targets, value: name => m.uniforms[name]?.value,
               texture: three_texture });
        this.#result = targets[0];
    }
    result() { return this.#result; }
}

/* Draws an effect of three.js. Returns the texture with its result. */
function three_draw(effect) {
    const write = new THREE.WebGLRenderTarget(width, height, { type : THREE.HalfFloatType }), read = write.clone(),
          renderer = new Renderer(read, effect.configuration?.halfRes ? null : write);
    effect.render(renderer, write, read);
    return renderer.result();
}

/* ---- >>three.js, nodes ------------------------------------------------------------------------------------------- */

const tsl_inputs = { depth: 0, picture: 2, normal: 3 };

/* Draws a node effect of three.js. filter: of its denoiser, whose distances of depth are in the scene's units. */
async function tsl(effect, set, filter) {
    const view = { width, height, near, far, projection : v.slice(5, 21) };
    const told = of => pass({...of, targets : of.targets.map(three_texture), texture : three_texture });
    const input = (texture, name) => numbers.set(texture, tsl_inputs[name]);
    return three_texture(await tsl_draw(view, effect, set, filter, told, input));
}

/* ---- >>Babylon.js: an engine without a GPU, whose draws are written down ----------------------------------------- */

/* The shader takes one of 16 directions even if there are fewer. Past the end browsers read the last, GL anything. */
const past = /\(i\+int\(random\.y\*16\.0\)\) % 16/, kept = 'min($&, SAMPLES - 1)';

class Engine extends NullEngine {
    #set = new Map(); #result;

    constructor() {
        super({ renderWidth: width, renderHeight: height, textureSize: 512 });
        Object.assign(this._caps, { maxTextureSize: 16384, maxRenderTextureSize: 16384 });
        const keep = (name, value) => {
            if (!this.#set.has(this._currentEffect)) this.#set.set(this._currentEffect, new Map());
            this.#set.get(this._currentEffect).set(name, value);
            return true;
        };
        for (const kind of [ 'setInt', 'setFloat', 'setFloat2', 'setFloat3', 'setFloat4', 'setArray3', 'setFloatArray3',
                             'setMatrices', 'setMatrix3x3' ])
            this[kind] = (name, ...values) => keep(name, values.flatMap(flat));
        this.setTexture = (channel, location, texture, name) => keep(name, texture);
        this._bindTexture = (channel, texture, name) => keep(name, texture);
    }
    getUniforms(context, names) { return names; }
    #texture(texture) {
        const { wrapU = 0 } = texture;
        return numbers.get(texture)
               ?? number(texture._texture ?? texture, ({ width, height, type, samplingMode, _bufferView }) => ({
                             width, height, format : type ? 0 : RGBA8, linear : samplingMode === 2,
                             repeat : wrapU === 1, data : _bufferView }));
    }

    /* Draws other than SSAO2's own only copy the picture or multiply it. */
    drawElementsType() {
        const effect = this._currentEffect, set = this.#set.get(effect);
        if (effect.name.fragment !== 'ssao2') return;
        this.#result = this.#texture(this._currentRenderTarget.texture);
        pass({ vertex: older(triangle(effect.vertexSourceCode, 'position'), false),
               fragment: older(`${effect.defines}\n${effect.fragmentSourceCode.replace(past, kept)}`, true),
               targets: [ this.#result ], value: name => set.get(name), texture: texture => this.#texture(texture) });
    }
    result() { return this.#result; }
}

/* Draws SSAO2 of Babylon.js. Its camera and geometry buffer are right-handed, so that depths are below 0. */
async function babylon_draw(ratio, set) {
    const engine = new Engine(), scene = new Scene(engine), camera = new FreeCamera('', Vector3.Zero(), scene),
          buffer = Object.create(GeometryBufferRenderer.prototype), textures = [ {}, {} ];
    scene.useRightHandedSystem = true;
    camera.fov = 2 * Math.atan(1 / v[10]);
    camera.minZ = near;
    camera.maxZ = far;
    camera.freezeProjectionMatrix(Matrix.FromArray(v, 5));
    buffer.getGBuffer = () => ({ textures });
    depth(textures[0], -1, 0, true);
    numbers.set(textures[1], 3);
    const effect = Object.assign(new SSAO2RenderingPipeline('', scene, ratio, [ camera ], buffer), set);
    while (!effect.isReady() || engine.postProcesses.some(pass => !pass.isReady())) await new Promise(setTimeout);
    scene.render();
    return engine.result();
}

/* ---- >>PlayCanvas: a device without a GPU, and the settings and draws of a frame --------------------------------- */

class Device extends NullGraphicsDevice {
    #pass; #shader;

    startRenderPass(pass) { this.#pass = pass; }
    endRenderPass() {}
    setShader(shader) { this.#shader = shader; }
    texture(texture) {
        return number(texture, ({ width, height, format }) => ({
            width, height, format : format === PIXELFORMAT_R8 ? R8 : 0, linear : false, repeat : false }));
    }
    draw() {
        const { vshader, fshader } = this.#shader.definition, { renderTarget, colorOps } = this.#pass,
              plain = text => text.replace(/^\s*#\s*(version|extension).*$/gm, ''), { r, g, b } = colorOps.clearValue;
        pass({ vertex: triangle(plain(vshader), 'aPosition'), fragment: plain(fshader),
               cleared: colorOps.clear && [ r, g, b ], targets: [ this.texture(renderTarget.colorBuffer) ],
               value: name => this.scope.variables.get(name)?.value, texture: texture => this.texture(texture) });
    }
}
class Frame extends CameraFrame {
    constructor() { super({}, { on() {} }); }
    enable() {}
}

/* Draws the SSAO of PlayCanvas. unit: how many of its units are one of the scene's. Depth comes from its prepass. */
function playcanvas_draw(set, unit = 1) {
    const canvas = { width, height }, device = new Device(canvas), app = new AppBase(canvas), frame = new Frame(),
          options = new AppOptions(), texture = {};
    options.graphicsDevice = device;
    app.init(options);
    device.scope.resolve('uSceneDepthMap').setValue(texture);
    depth(texture, unit, far * unit, false);
    Object.assign(frame.ssao, { type : 'lighting' }, set);
    const ssaoPass = new RenderPassSsao(device, canvas, { shaderParams : { sceneDepthMapLinear : true } },
                                        frame.ssao.blurEnabled);
    frame.renderPassCamera = { update() {}, composePass : {}, ssaoPass };
    frame.update();
    const passes = [ ssaoPass, ...ssaoPass.afterPasses ];
    for (const pass of passes) pass.frameUpdate();
    for (const pass of passes) pass.render();
    return device.texture(ssaoPass.ssaoTexture);
}

/* ---- >>peers: at their defaults, and with the chart's radius ----------------------------------------------------- */

/* SAO's radius lies on the screen: this is the radius in pixels, at the median depth */
const pixels = radius / middle * v[10] * height / 2;

function three(Pass, pass = new Pass(new THREE.Scene(), camera, width, height)) {
    pass.setSize(width, height);
    return pass;
}

const gtao = set => {
    const pass = three(GTAOPass);
    pass.output = GTAOPass.OUTPUT.Off;
    pass.updateGtaoMaterial(set);
    return three_draw(pass);
};
const ssao = set => three_draw(Object.assign(three(SSAOPass), set));
const sao = set => {
    const pass = three(SAOPass, new SAOPass(new THREE.Scene(), camera, new THREE.Vector2(width, height)));
    Object.assign(pass.params, set);
    return three_draw(pass);
};
const n8ao = (mode, set) => {
    const pass = new N8AOPass(new THREE.Scene(), camera, width, height);
    pass.setSize(width, height);
    pass.setQualityMode(mode);
    pass.setDisplayMode('AO');
    Object.assign(pass.configuration, { gammaCorrection: false }, set);
    return three_draw(pass);
};

/* SAO weighs a sample at distance t by 1 / (1 + (slope t)^2), and divides its cosine by the slope, less the bias */
const slope = 1 / radius;

/* Matched: the radius, and the settings that came nearest to the truth in the chart's scenes, in coarse steps; for
   Babylon.js and PlayCanvas in bunny, room and colonnade. R: the radius.
   Nodes: five scenes by seed below 26.
   Babylon.js: at the resolutions that its documentation shows and at full resolution, with 16 samples (its text tells
   no more apart), and without its limits of near and far depths.
   PlayCanvas: 2 R, as its text takes any field of view for one of 53 degrees; the scene's units make R 20, as its blur
   takes a depth step of 1 for an edge. */
const filter = { depthPhi: 0.2 * radius, radius: 3 }, filter_words = 'DenoiseNode of radius 3, depths 0.2 R';
const gtao_node = { radius, thickness: 0.8 * radius }, gtao_words = `radius R, thickness 0.8 R, ${filter_words}`;
const ssgi_node = { useScreenSpaceSampling: false, radius, thickness: 0.25 * radius },
      ssgi_words = `radius R, thickness 0.25 R, ${filter_words}`;
const matched = { aoRadius: radius, intensity: 2 }, words = 'radius R, intensity 2';
const half = { ssaoRatio: 0.5, blurRatio: 1 }, full = { ssaoRatio: 1, blurRatio: 1 };
const ssao2 = {
    samples: 16, radius: 0.8 * radius, totalStrength: 1.75, epsilon: radius / 100, bilateralSamples: 8,
    bilateralSoften: 1, bilateralTolerance: radius / 50, maxZ: 2 * far, minZAspect: far
};
const ssao2_words = '16 samples, radius 0.8 R, strength 1.75, soft blur of 8';
const playcanvas = samples => playcanvas_draw({ samples, radius: 40, power: 1.5 }, 20 / radius);
const peers = [
    [
        'three.js GTAO', 'radius R, thickness 0.8 R, fall-off 0.7, exponent 1.25, scale 1.3',
        () => gtao({ radius, thickness : 0.8 * radius, distanceFallOff : 0.7, distanceExponent : 1.25, scale : 1.3 })
    ],
    [
        'three.js SSAO', 'radius R, distances 0.01 R to R',
        () => ssao(
            { kernelRadius : radius, minDistance : 0.01 * radius / (far - near), maxDistance : radius / (far - near) })
    ],
    [
        'three.js SAO', 'radius R/2 at the middle depth, scale far/R, bias R/10, intensity 2/R',
        () => sao(
            { saoKernelRadius : pixels / 2, saoScale : slope * far, saoBias : 0.1 / slope, saoIntensity : 2 * slope })
    ],
    [ 'three.js GTAONode', `16 samples, ${gtao_words}`, () => tsl('gtao', gtao_node, filter) ],
    ...(quick ? [ 1 ] : [ 1, 2 ])
        .map(n => ['three.js SSGINode', `${n} x 12 steps, ${ssgi_words}`,
                   () => tsl('ssgi', {...ssgi_node, sliceCount : n }, filter)]),
    ...(quick ? [ 'Medium' ] : [ 'Low', 'Medium' ])
        .map(mode => ['n8ao', `${mode}, ${words}`, () => n8ao(mode, matched)]),
    ...(quick ? [ 'Medium' ] : [ 'Medium', 'High' ])
        .map(mode => ['n8ao, neural', `Neural-${mode}, ${words}`, () => n8ao(`Neural-${mode}`, matched)]),
    [ 'n8ao, half size', `Medium, ${words}`, () => n8ao('Medium', {...matched, halfRes : true }) ],
    ...(quick ? [ half ] : [ half, full ])
        .map(size => ['Babylon.js SSAO2', `${size === half ? 'half size' : 'full size'}, ${ssao2_words}`,
                      () => babylon_draw(size, ssao2)]),
    ...(quick ? [ 12 ] : [ 12, 24 ])
        .map(samples => ['PlayCanvas SSAO', `${samples} samples, radius 2 R, power 1.5, units of R/20`,
                         () => playcanvas(samples)])
];
for (const [label, settings, draw] of peers) {
    state = 1;
    line({ kind : 'peer', name : label, settings });
    line({ kind : 'result', number : await draw() });
}
writeFileSync(new URL('manifest.csv', out), [ heads, ...lines ].join('\n') + '\n');
