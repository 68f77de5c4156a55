/* peers.mjs - what people would pick instead of this library: three.js' GTAO, SSAO and SAO passes and n8ao, as plain
   GLSL for peers.c to draw.

      make peers                        installs the packages into build/peers, with this script beside them, where it
         finds them
      node peers.mjs [quick] < view     quick: fewer

   Their own code drives them: each effect's render() is called with a renderer that only writes down what it is told to
   draw, so that every text, uniform, kernel, noise texture, target and clear colour is theirs. Reads a view from stdin,
   numbers only: width, height, near, far, radius, its projection and world-to-view matrices (column-major), and the
   view depth of the middle of the pixels. Writes into out/ beside it: N.vert and N.frag (without a version line, for
   GLSL 330 and ES 300), N.f32 (texels) and manifest.txt, lines of words; numbers are textures, in order of appearance,
   after 0, window depth, 1, view normals as n/2 + 1/2, and 2, the picture:

      texture N WIDTH HEIGHT FORMAT LINEAR REPEAT FILE|-     FORMAT as GL numbers them
      peer LABEL / SETTINGS
      pass N SHOWN CLEAR R G B TARGETS..                     N.vert and N.frag; SHOWN: it only shows what is there
         already, and is no cost of the effect
      uniform TYPE NAME COUNT VALUES.. / sampler NAME TEXTURE of the pass above
      result TEXTURE                                         ambient visibility, red */
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import * as THREE from 'three';
import { GTAOPass } from 'three/addons/postprocessing/GTAOPass.js';
import { SSAOPass } from 'three/addons/postprocessing/SSAOPass.js';
import { SAOPass } from 'three/addons/postprocessing/SAOPass.js';
import { N8AOPass } from 'n8ao';

const v = readFileSync(0, 'utf8').trim().split(/\s+/).map(Number);
if (v.length !== 38 || v.some(n => !Number.isFinite(n))) {
    console.error('peers.mjs: a view is 38 numbers');
    process.exit(2);
}
const [width, height, near, far, radius] = v, middle = v[37];
const quick = process.argv[2] === 'quick', out = new URL('out/', import.meta.url), lines = [];
mkdirSync(out, { recursive: true });

/* Numbers that are the same each time: some kernels and noise are made by Math.random. */
let state;
Math.random = () => (state = (state * 48271) % 2147483647) / 2147483647;

const camera = new THREE.PerspectiveCamera();
camera.near = near;
camera.far = far;
camera.projectionMatrix.fromArray(v, 5);
camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
camera.matrixAutoUpdate = false;
camera.matrix.fromArray(v, 21).invert();
camera.updateMatrixWorld(true);

/* ---- >>writing: textures, texts, uniforms ------------------------------------------------------------------------ */

const formats = new Map([
    [ [ THREE.RGBAFormat, THREE.UnsignedByteType ], 0x8058 ], [ [ THREE.RGBAFormat, THREE.HalfFloatType ], 0x881A ],
    [ [ THREE.RGBAFormat, THREE.FloatType ], 0x8814 ], [ [ THREE.RedFormat, THREE.UnsignedByteType ], 0x8229 ],
    [ [ THREE.RedFormat, THREE.HalfFloatType ], 0x822D ], [ [ THREE.RedFormat, THREE.FloatType ], 0x822E ]
].map(([ kind, format ]) => [kind.join(), format]));
const sizes = { float: 1, int: 1, bool: 1, vec2: 2, vec3: 3, vec4: 4, mat4: 16 };
const flat = value => value.toArray            ? value.toArray()
                      : value[Symbol.iterator] ? [...value ].flatMap(flat)
                                               : [ Number(value) ];

const numbers = new Map();
let textures = 3, programs = 0;

function number(texture) {
    if (!numbers.has(texture)) {
        const { width : w, height : h, data } = texture.image,
                                            format = formats.get([ texture.format, texture.type ].join()),
                                            n = textures++;
        if (!format) throw new Error(`a texture of format ${texture.format}, type ${texture.type}`);
        if (data)
            writeFileSync(new URL(`${n}.f32`, out),
                          Float32Array.from(data, texture.type === THREE.UnsignedByteType ? c => c / 255 : c => c));
        lines.push(`texture ${n} ${w} ${h} ${format} ${+ (texture.magFilter === THREE.LinearFilter)} ${
            + (texture.wrapS === THREE.RepeatWrapping)} ${data ? `${n}.f32` : '-'}`);
        numbers.set(texture, n);
    }
    return numbers.get(texture);
}

const whole = text => text.replace(/^[ \t]*#include +<([\w\d./]+)>/gm, (line, name) => {
    if (!(name in THREE.ShaderChunk)) throw new Error(`no chunk ${name}`);
    return whole(THREE.ShaderChunk[name]);
});
const defines = material => Object.entries(material.defines ?? {})
                                .filter(([, value ]) => value !== false)
                                .map(([ name, value ]) => `#define ${name} ${value}\n`)
                                .join('');

/* Vertices without attributes: one triangle over all. */
const vertex = m => `#define varying out
#define texture2D texture
${defines(m)}const mat4 projectionMatrix = mat4(1.0), modelViewMatrix = mat4(1.0);
vec3 position;
vec2 uv;
#define main peer_main
${whole(m.vertexShader)}
#undef main
void main() {
    uv = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0;
    position = vec3(2.0 * uv - 1.0, 0.0);
    peer_main();
}
`;
const fragment = m => `#define varying in
#define texture2D texture
${
    m.glslVersion === THREE.GLSL3
        ? ''
        : 'layout(location = 0) out highp vec4 pc_fragColor;\n#define gl_FragColor pc_fragColor\n'}${defines(m)}${
    whole(THREE.ShaderChunk.colorspace_pars_fragment)}
${whole(m.fragmentShader)}
`;

/* ---- >>renderer: what an effect asks of it ----------------------------------------------------------------------- */

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

    /* Scenes are the G-buffer, which the caller has; all else is a pass over the picture. */
    render(object) {
        const target = this.#target;
        if (object.isScene) {
            numbers.set(target.depthTexture, 0);
            numbers.set(target.texture, object.overrideMaterial ? 1 : 2);
            return;
        }
        if (target === this.picture) return;               /* blends with it what is done by now */
        const n = programs++, m = object.material, text = vertex(m) + fragment(m), uniforms = [], named = new Set();
        for (const [, type, length, name, also] of text.matchAll(
                 /^\s*uniform\s+(?:(?:high|medium|low)p\s+)?(\w+)\s*(\[.*?\])?\s+(\w+)\s*(\[.*?\])?\s*;/gm)) {
            const value = m.uniforms[name]?.value;
            if (value === undefined || value === null || named.has(name)) continue;
            named.add(name);
            if (type === 'sampler2D') { uniforms.push(`sampler ${name} ${number(value)}`); continue; }
            if (!sizes[type]) throw new Error(`uniform ${type} ${name}`);
            const values = flat(value);
            uniforms.push(
                `uniform ${type} ${name} ${length || also ? values.length / sizes[type] : 1} ${values.join(' ')}`);
        }
        const targets = target.textures.map(number), c = this.#cleared;
        lines.push(`pass ${n} ${+ (target === this.shown)} ${c ? `1 ${c.r} ${c.g} ${c.b}` : '0 0 0 0'} ${
                       targets.join(' ')}`,
                   ...uniforms);
        writeFileSync(new URL(`${n}.vert`, out), vertex(m));
        writeFileSync(new URL(`${n}.frag`, out), fragment(m));
        this.#result = targets[0];
    }
    result() { lines.push(`result ${this.#result}`); }
}

/* ---- >>peers: by default, and such that the radius is ours ------------------------------------------------------- */

/* of the radius, at the middle of the depths: SAO's is one of the screen */
const pixels = radius / middle * v[10] * height / 2;

function three(Pass, pass = new Pass(new THREE.Scene(), camera, width, height)) {
    pass.setSize(width, height);
    return pass;
}

const gtao = set => {
    const pass = three(GTAOPass);
    pass.output = GTAOPass.OUTPUT.Off;
    pass.updateGtaoMaterial(set);
    return pass;
};
const ssao = set => Object.assign(three(SSAOPass), set);
const sao = set => {
    const pass = three(SAOPass, new SAOPass(new THREE.Scene(), camera, new THREE.Vector2(width, height)));
    Object.assign(pass.params, set);
    return pass;
};
const n8ao = (mode, set) => {
    const pass = new N8AOPass(new THREE.Scene(), camera, width, height);
    pass.setSize(width, height);
    pass.setQualityMode(mode);
    pass.setDisplayMode('AO');
    Object.assign(pass.configuration, { gammaCorrection: false }, set);
    return pass;
};

/* SAO weighs by 1 / (1 + (slope t)^2), and divides a sample's cosine by the slope, less the bias */
const slope = 1 / radius;

/* Matched: beside the radius what of theirs shapes the effect, as it came nearest to the truth in the chart's scenes,
   in coarse steps. R: the radius. */
const matched = { aoRadius: radius, intensity: 2 }, words = 'radius R, intensity 2';
const peers = [
    [ 'three.js GTAO', 'defaults', () => gtao({}) ],
    [
        'three.js GTAO', 'radius R, thickness 0.8 R, fall-off 0.7, exponent 1.25, scale 1.3',
        () => gtao({ radius, thickness : 0.8 * radius, distanceFallOff : 0.7, distanceExponent : 1.25, scale : 1.3 })
    ],
    [ 'three.js SSAO', 'defaults', () => ssao({}) ],
    [
        'three.js SSAO', 'radius R, distances 0.01 R to R',
        () => ssao(
            { kernelRadius : radius, minDistance : 0.01 * radius / (far - near), maxDistance : radius / (far - near) })
    ],
    [ 'three.js SAO', 'defaults', () => sao({}) ],
    [
        'three.js SAO', 'radius R/2 at the middle depth, scale far/R, bias R/10, intensity 2/R',
        () => sao(
            { saoKernelRadius : pixels / 2, saoScale : slope * far, saoBias : 0.1 / slope, saoIntensity : 2 * slope })
    ],
    [ 'n8ao', 'defaults', () => n8ao('Medium', {}) ],
    ...(quick ? [ 'Medium' ] : [ 'Performance', 'Low', 'Medium', 'High', 'Ultra' ])
        .map(mode => ['n8ao', `${mode}, ${words}`, () => n8ao(mode, matched)]),
    ...(quick ? [ 'Medium' ] : [ 'Performance', 'Low', 'Medium', 'High' ])
        .map(mode => ['n8ao, neural', `Neural-${mode}, ${words}`, () => n8ao(`Neural-${mode}`, matched)]),
    ...(quick ? [ 'Medium' ] : [ 'Performance', 'Medium', 'Ultra' ])
        .map(mode => ['n8ao, half size', `${mode}, ${words}`, () => n8ao(mode, {...matched, halfRes : true })])
];
for (const [label, settings, make] of peers) {
    if (quick && settings === 'defaults') continue;
    state = 1;
    const pass = make(), write = new THREE.WebGLRenderTarget(width, height, { type : THREE.HalfFloatType }),
          read = write.clone();
    lines.push(`peer ${label} / ${settings}`);
    const renderer = new Renderer(read, pass.configuration?.halfRes ? null : write);
    pass.render(renderer, write, read);
    renderer.result();
}
writeFileSync(new URL('manifest.txt', out), lines.join('\n') + '\n');
