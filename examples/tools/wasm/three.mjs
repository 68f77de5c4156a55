/* three.mjs - ssgi in three.js: a pass for EffectComposer of WebGLRenderer, and its parts.

      import { SSGIPass } from 'ssgi/three';
      composer.addPass(new SSGIPass(scene, camera, { radius: 0.5 }));      // in the place of RenderPass
      composer.addPass(new OutputPass());

   It draws the scene itself: first all opaque objects, with depth; then occlusion, which only dims ambient light; then
   all transparent objects, which neither occlude nor are dimmed. Passes of TAA come after it. In addition to the
   options of SSGIPass.set it has the fields of a desc (ssgi.choices), such as pass, thickness, resolution, samples:

      { pass: 'HSAO', preset: 'FAST', history: true }         // ambient visibility
      { pass: 'SSDO' }                                        // the scene's ambient light, by direction
      { pass: 'SSDO', bounce: 'SOLID_ANGLE' }                 // and one diffuse bounce of all light */
import * as THREE from 'three';
import { Ssgi, loadOnce } from './ssgi.mjs';
import { Drawer } from './webgl.mjs';

/* ---- parts, for renderers of your own */

/* The WebGL texture of a texture of three, after three has drawn into it or uploaded it. */
export const rawOf = (renderer, texture) => renderer.properties.get(texture).__webglTexture ?? null;

/* The camera as a view of ssgi; call it after three has drawn with the camera, because that may reverse its depth. */
export const viewOf = (ssgi, camera, width, height) =>
    ssgi.view(camera.projectionMatrix.elements, width, height, camera.reversedDepth ? 'ZERO' : 'GL');

/* Whether the camera is orthographic, as a desc's field. */
const isOrthographic = camera => +(camera.projectionMatrix.elements[11] === 0);

/* Sets the clear colour, which three converts to the colour space of the bound target. */
const setClear = renderer =>
    renderer.setClearColor(renderer.getClearColor(new THREE.Color()), renderer.getClearAlpha());

/* Tells three, after draws outside it, that its copy of GL's state is stale. three's own resetState loses the clear
   colour and the reversal of depth. */
export function resetState(renderer) {
    const { depth } = renderer.state.buffers, reversed = depth.getReversed?.();
    renderer.resetState();
    setClear(renderer);
    if (!reversed) return;
    depth.setReversed(true);
    depth.setClear(1);
}

/* Makes a material of three write outputs 1, 2 .. in addition to its colour. outputs: [{ name, is, fogged }]. is: a
   vec4 in GLSL, evaluated after the material's lights are summed; fogged: fog hides it. Returns a function that undoes
   this. */
export function writes(material, outputs) {
    const { onBeforeCompile: before, customProgramCacheKey: key } = material;
    const named = key !== THREE.Material.prototype.customProgramCacheKey, all = JSON.stringify(outputs);
    material.onBeforeCompile = function (shader, renderer) {
        before.call(this, shader, renderer);
        const declared = outputs.map(({ name }, i) => `layout(location = ${i + 1}) out highp vec4 ${name};\n`).join('');
        const written = outputs.map(({ name, is }) => `\n${name} = ${is};`).join('');
        const fogged = outputs.filter(o => o.fogged).map(({ name }) => `${name} *= 1.0 - fogFactor;\n`).join('');
        shader.fragmentShader = shader.fragmentShader
            .replace('void main() {', `${declared}void main() {`)
            .replace('#include <opaque_fragment>', `#include <opaque_fragment>${written}`)
            .replace('#include <fog_fragment>', `#include <fog_fragment>\n#ifdef USE_FOG\n${fogged}#endif`);
    };
    material.customProgramCacheKey = function () { return `${named ? key.call(this) : before} ${all}`; };
    material.needsUpdate = true;
    return () => {
        Object.assign(material, { onBeforeCompile: before, needsUpdate: true });
        if (named) material.customProgramCacheKey = key;
        else delete material.customProgramCacheKey;
    };
}

/* A triangle that covers the picture. */
function over(parameters) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute([-1, -1, 0, 3, -1, 0, -1, 3, 0], 3));
    const mesh = new THREE.Mesh(geometry, new THREE.ShaderMaterial({
        depthTest: false, depthWrite: false, ...parameters,
        vertexShader: 'void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }'
    }));
    mesh.frustumCulled = false;
    return mesh;
}

/* Draws while these objects have other values of these members. */
function changed(objects, members, draw) {
    const names = Object.keys(members), were = objects.map(object => names.map(name => object[name]));
    for (const object of objects) Object.assign(object, members);
    try { return draw(); } finally {
        objects.forEach((object, i) => names.forEach((name, k) => { object[name] = were[i][k]; }));
    }
}
/* Draws a scene without these objects. */
const masked = (objects, draw) => changed(objects.map(({ layers }) => layers), { mask: 0 }, draw);
/* Draws a scene without its background and without new shadow maps, which exist already. */
const again = (renderer, scene, camera, members = {}) =>
    changed([renderer.shadowMap], { autoUpdate: false, needsUpdate: false }, () =>
        changed([scene], { background: null, ...members }, () => renderer.render(scene, camera)));

const nearest = { minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter };

/* Window depth of faces that are behind others. */
const peeling = side => new THREE.ShaderMaterial({
    side, glslVersion: THREE.GLSL3, uniforms: { t_before: { value: null }, u_reversed: { value: false } },
    vertexShader: `#include <batching_pars_vertex>
        #include <skinning_pars_vertex>
        #include <morphtarget_pars_vertex>
        void main() {
            #include <batching_vertex>
            #include <begin_vertex>
            #include <morphtarget_vertex>
            #include <skinbase_vertex>
            #include <skinning_vertex>
            #include <project_vertex>
        }`,
    fragmentShader: `uniform highp sampler2D t_before;
        uniform bool u_reversed;
        out highp vec4 o_nothing;
        void main() {
            highp float before = texelFetch(t_before, ivec2(gl_FragCoord.xy), 0).x, here = gl_FragCoord.z;
            if (u_reversed) { before = 1.0 - before; here = 1.0 - here; }
            if (before >= 1.0 || here <= before + 1e-7) discard;
            o_nothing = vec4(0.0);
        }`
});

/* The back faces that thickness BACK and SLABS read: a second drawing of the scene with its sides turned. */
export class Behind {
    #size; #targets = []; #slabs = null; #pack = null;
    #back = new THREE.MeshBasicMaterial({ side: THREE.BackSide, colorWrite: false });
    #peels = [peeling(THREE.FrontSide), peeling(THREE.BackSide)];

    constructor(width, height) { this.#size = [width, height]; }

    /* count 1: a depth texture of the nearest back face; 3: of that and of both sides of the next object */
    draw(renderer, scene, camera, count) {
        for (let i = 0; i < count; ++i) {
            const target = this.#targets[i] ??= new THREE.WebGLRenderTarget(...this.#size, { ...nearest,
                depthTexture: new THREE.DepthTexture(...this.#size, THREE.FloatType) });
            const material = i ? this.#peels[i - 1] : this.#back;
            if (i) {
                material.uniforms.t_before.value = this.#targets[i - 1].depthTexture;
                material.uniforms.u_reversed.value = !!camera.reversedDepth;
            }
            renderer.setRenderTarget(target);
            renderer.clear();
            again(renderer, scene, camera, { overrideMaterial: material });
        }
        return count > 1 ? this.#packed(renderer, camera) : this.#targets[0].depthTexture;
    }

    #packed(renderer, camera) {
        this.#slabs ??= new THREE.WebGLRenderTarget(...this.#size, { ...nearest, type: THREE.FloatType,
                                                                     depthBuffer: false });
        this.#pack ??= over({
            glslVersion: THREE.GLSL3, uniforms: { t_0: { value: null }, t_1: { value: null }, t_2: { value: null } },
            fragmentShader: `uniform highp sampler2D t_0, t_1, t_2;
                out highp vec4 o_slabs;
                void main() {
                    ivec2 p = ivec2(gl_FragCoord.xy);
                    o_slabs = vec4(texelFetch(t_0, p, 0).x, texelFetch(t_1, p, 0).x, texelFetch(t_2, p, 0).x, 0.0);
                }`
        });
        this.#targets.forEach((target, i) => { this.#pack.material.uniforms[`t_${i}`].value = target.depthTexture; });
        renderer.setRenderTarget(this.#slabs);
        renderer.render(this.#pack, camera);
        return this.#slabs.texture;
    }

    dispose() {
        this.#targets.forEach(target => target.dispose());
        this.#slabs?.dispose();
        for (const material of [this.#back, ...this.#peels, this.#pack?.material]) material?.dispose();
        this.#pack?.geometry.dispose();
    }
}

/* GLSL of irradiance over pi along n, from radiance as nine coefficients; band: factors of the bands, 1 2/3 1/4 for
   that. */
export const harmonicsText = name => `
    vec3 harmonics(vec3 n, vec3 band) {
        vec3 l = ${name}[0] * 0.282095 * band.x;
        l += (${name}[1] * n.y + ${name}[2] * n.z + ${name}[3] * n.x) * 0.488603 * band.y;
        l += (${name}[4] * 1.092548 * n.x * n.y + ${name}[5] * 1.092548 * n.y * n.z
              + ${name}[6] * (0.946175 * n.z * n.z - 0.315392) + ${name}[7] * 1.092548 * n.x * n.z
              + ${name}[8] * 0.546274 * (n.x * n.x - n.y * n.y)) * band.z;
        return max(l, 0.0);
    }`;

/* ---- ambient light of a scene, as radiance: nine coefficients of three colours each, in world space */

const Y0 = 0.282095, Y1 = 0.488603;
const plus = (sum, k, { r, g, b }, by) => [r, g, b].forEach((c, i) => { sum[3 * k + i] += c * by; });

/* Sums AmbientLight, HemisphereLight and LightProbe anywhere in the scene. */
export function ambientOf(scene) {
    const sum = new Float32Array(27), up = new THREE.Vector3();
    scene.traverseVisible(light => {
        const { intensity, color, groundColor } = light;
        if (light.isAmbientLight) plus(sum, 0, color, intensity / (Math.PI * Y0));
        if (light.isHemisphereLight) {
            for (const [c, sign] of [[color, 1], [groundColor, -1]]) {
                up.setFromMatrixPosition(light.matrixWorld).normalize();
                plus(sum, 0, c, 0.5 * intensity / (Math.PI * Y0));
                [up.y, up.z, up.x].forEach((n, i) =>
                    plus(sum, 1 + i, c, sign * n * 0.75 * intensity / (Math.PI * Y1)));
            }
        }
        if (light.isLightProbe)
            light.sh.coefficients.forEach(({ x, y, z }, k) => plus(sum, k, { r: x, g: y, b: z }, intensity));
    });
    return sum;
}

/* The pixels of an equirectangular texture in ssgi's order: rgb, the first row at the top of the sky. */
function pixelsOf({ image: { data, width, height }, flipY }) {
    const half = data instanceof Uint16Array, channels = data.length / (width * height);
    const value = data instanceof Uint8Array ? v => v / 255 : half ? THREE.DataUtils.fromHalfFloat : v => v;
    const rgb = new Float32Array(3 * width * height);
    for (let y = 0, at = 0; y < height; ++y)
        for (let x = 0, row = (flipY ? y : height - 1 - y) * width; x < width; ++x)
            for (let c = 0; c < 3; ++c) rgb[at++] = value(data[channels * (row + x) + c]);
    return rgb;
}

/* three's longitudes are a quarter turn from ssgi's. */
const quarter = new THREE.Matrix4().set(0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 0, 1);

/* ---- the pass */

/* Outputs of materials in addition to their colour, by ssgi's names; unlit: for materials without lights. */
const outputsOf = {
    __proto__: null,
    AMBIENT: { is: 'vec4(reflectedLight.indirectDiffuse + reflectedLight.indirectSpecular, 0.0)', unlit: 'vec4(0.0)',
               fogged: true },
    NORMAL: { is: 'vec4(normal, 0.0)', unlit: 'vec4(0.0, 0.0, 1.0, 0.0)' },
    ALBEDO: { is: 'vec4(diffuseColor.rgb, 0.0)', unlit: 'vec4(0.0)' },
    DIRECT: { is: 'vec4(reflectedLight.directDiffuse + totalEmissiveRadiance, 0.0)', unlit: 'vec4(outgoingLight, 0.0)' }
};
const isLit = m => m.isMeshStandardMaterial || m.isMeshPhongMaterial || m.isMeshLambertMaterial || m.isMeshToonMaterial;
const isOwn = m => isLit(m) || m.isMeshBasicMaterial || m.isMeshMatcapMaterial || m.isLineBasicMaterial
    || m.isPointsMaterial;
const materialsOf = objects => [...new Set(objects.flatMap(({ material }) => material ?? []))];
const onDevice = new Set(['DEPTH', 'BACK', 'NORMAL', 'ALBEDO', 'DIRECT', 'MOTION']);
const drawnBefore = new Set(['DEPTH', 'BACK', 'MOTION']);

const encoded = `
        #include <tonemapping_fragment>
        #include <colorspace_fragment>
    }`;
const plain = `
    uniform highp sampler2D t_picture;
    void main() {
        gl_FragColor = texelFetch(t_picture, ivec2(gl_FragCoord.xy), 0);${encoded}`;
const deep = `
    uniform highp sampler2D t_depth;
    void main() {
        gl_FragColor = vec4(0.0);
        gl_FragDepth = texelFetch(t_depth, ivec2(gl_FragCoord.xy), 0).x;
    }`;
const composite = `
    uniform highp sampler2D t_picture, t_ambient, t_normal, t_albedo, t_light, t_bounce;
    uniform highp vec3 u_harmonics[9];
    uniform highp float u_strength;
    ${harmonicsText('u_harmonics')}
    void main() {
        ivec2 p = ivec2(gl_FragCoord.xy);
        gl_FragColor = texelFetch(t_picture, p, 0);
        vec3 share = texelFetch(t_light, p, 0).rgb;
    #if SSGI_LIGHT
        share /= max(harmonics(texelFetch(t_normal, p, 0).xyz, vec3(1.0, 0.6666667, 0.25)), 1e-5);
    #else
        share = share.rrr;
    #endif
        share = max(1.0 + u_strength * (share - 1.0), 0.0);
    #if SSGI_ALONE
        gl_FragColor = vec4(share, 1.0);
    #else
        #if SSGI_AMBIENT // 0 where nothing is lit, whatever the result is there
            vec3 ambient = texelFetch(t_ambient, p, 0).rgb;
            if (dot(ambient, vec3(1.0)) > 0.0) gl_FragColor.rgb = max(gl_FragColor.rgb + ambient * (share - 1.0), 0.0);
        #else
            gl_FragColor.rgb *= share;
        #endif
        #if SSGI_BOUNCE
            vec3 albedo = texelFetch(t_albedo, p, 0).rgb;
            if (dot(albedo, vec3(1.0)) > 0.0) gl_FragColor.rgb += u_strength * albedo * texelFetch(t_bounce, p, 0).rgb;
        #endif
    #endif${encoded}`;

export class SSGIPass {
    isPass = true;                                  /* EffectComposer requires it of a pass */
    enabled = true;
    needsSwap = true;
    clear = false;
    renderToScreen = false;

    /* radius: in units of the scene. strength: of the effect, 1: as computed. alone: the result without the picture.
       adjust: called with each frame's block, to set thickness_limit, jitter, phase. given: your textures by meaning,
       as MOTION, and with the option drawn as DEPTH. */
    radius = 1;
    strength = 1;
    alone = false;
    adjust = null;
    given = {};
    /* Whether an object is drawn after occlusion; all objects with its materials must be, too. Objects that three calls
       transmissive read the opaque picture while three draws it, so they stay in it. */
    isLate = object => object.isSprite || materialsOf([object]).some(m => m.transparent && !m.transmission);
    /* Radiance of ambient light as 27 numbers; null: from the scene's lights and its equirectangular environment. */
    harmonics = null;

    #ssgi = null; #asked = {}; #options = {}; #width = 1; #height = 1; #drawer = null; #run = null; #renderer = null;
    #frames = 0; #last = null; #opaque = null; #over = null; #behind = null; #screen = null; #copy = null;
    #deep = null; #outputs = []; #light = new THREE.Texture(); #bounce = new THREE.Texture(); #backs = 0;
    #environment = { of: null, sh: null }; #before = null;

    /* A promise of this pass, resolved when ssgi.wasm is loaded; before that the scene is shown without occlusion. It
       is rejected with a sentence if ssgi.wasm cannot be read or an option is wrong. */
    ready;

    /* source: an Ssgi, which needs no waiting, or a source of load(); default: ssgi.wasm in this file's folder */
    constructor(scene, camera, options = {}, source = undefined) {
        Object.assign(this, { scene, camera });
        const there = source instanceof Ssgi;
        if (there) this.#ssgi = source;
        this.set(options);
        this.ready = loadOnce(source).then(ssgi => {
            if (there) return this;
            this.#ssgi = ssgi;
            this.set(this.#asked);
            return this;
        });
    }

    /* Sets the method and its options from now on; a wrong option throws a sentence, and nothing changes. preset:
       'FAST', 'BALANCED', 'BEST'. ambient: true: only ambient light is dimmed (materials of three are made to write it;
       those of your own shaders are not dimmed), false: the whole picture is. history: 16 frames are averaged. samples:
       multisampling of opaque edges. drawn: true: an earlier pass has drawn the scene; this pass reads the picture and
       depth of the target that render() is given to read, and dims the whole picture. radius, strength: as the members.
       All others: fields of a desc. */
    set(options) {
        this.#asked = options;
        if (!this.#ssgi) return;
        const { preset = 'BALANCED', drawn = false, ambient = !drawn, history = false, samples = 0, blur = 1,
                radius = this.radius, strength = this.strength, ...own } = options;
        const lit = own.pass === 'SSDO' || own.pass === 'S3HO';
        const desc = this.#ssgi.preset({ dialect: '300ES', pass: 'HSAO', normal: lit ? 'SIGNED' : 'FROM_DEPTH',
                                         orthographic: isOrthographic(this.camera),
                                         ...(lit && { environment: 'SH' }), ...(own.pass === 'S3HO' && { shaded: 1 }),
                                         ...own }, preset);
        const chain = { desc, blur: +blur, history: +history, direct: +!!(desc.bounce && desc.bounce !== 'NONE') };
        const steps = this.#ssgi.steps({ ...chain, width: 64, height: 64 });
        const inputs = new Set(steps.flatMap(step => step.inputs).map(input => input.meaning).filter(Boolean));
        if (drawn && ambient) throw new Error('ambient: must be false if drawn is true');
        for (const meaning of inputs)
            if (!(drawn ? drawnBefore : onDevice).has(meaning) && !this.given[meaning])
                throw new Error(`desc.pass: ${desc.pass} with these choices reads ${meaning}, which this pass does not `
                                + 'make: set given');
        if (typeof radius !== 'number' || !(radius > 0)) throw new Error('radius: must be a number above 0');
        if (typeof strength !== 'number' || !(strength >= 0))
            throw new Error('strength: must be a number of 0 or more');
        this.#release();
        this.#unmakeAll();
        Object.assign(this, { radius, strength });
        this.#options = { ambient, samples, chain, lit, drawn };
        this.#backs = inputs.has('BACK') ? (desc.thickness === 'SLABS' ? 3 : 1) : 0;
        const names = ['NORMAL', 'ALBEDO', 'DIRECT'].filter(name => inputs.has(name) && !this.given[name]);
        this.#outputs = [...(ambient ? ['AMBIENT'] : []), ...names];
    }

    setSize(width, height) {
        [this.#width, this.#height] = [Math.max(1, Math.round(width)), Math.max(1, Math.round(height))];
    }

    /* Call it before a frame that shows another place: history begins anew. */
    cut() { this.#last = null; }

    /* Ambient visibility, or light over pi, of the last frame; null: no frame was drawn. */
    get texture() { return this.#run ? this.#light : null; }

    /* The scene's depth in the last frame; null: no frame was drawn. */
    get depthTexture() { return this.#before?.depth ?? this.#opaque?.depthTexture ?? null; }

    render(renderer, writeBuffer, readBuffer) {
        const target = this.renderToScreen ? null : writeBuffer, { drawn = false } = this.#asked;
        this.#before = drawn
            ? { picture: readBuffer.texture, depth: this.given.DEPTH ?? readBuffer.depthTexture } : null;
        changed([renderer], { autoClear: false }, () => {
            if (this.#ssgi) this.#drawInto(renderer, target);
            else if (drawn) this.#show(renderer, readBuffer.texture, target);
            else {
                renderer.setRenderTarget(target);
                renderer.clear();
                renderer.render(this.scene, this.camera);
            }
        });
    }

    /* Draws into a target, whose depth buffer gets the scene's depth, as RenderPass leaves it for later passes. */
    #drawInto(renderer, target) {
        const { scene, camera } = this, before = this.#before;
        if (renderer.capabilities.logarithmicDepthBuffer)
            throw new Error('logarithmicDepthBuffer: must be false: its depth cannot be read; see reversedDepthBuffer');
        if (before && !before.depth)
            throw new Error('drawn: the target that is read has no depthTexture, and given.DEPTH is not set');
        this.#fit(renderer);
        const late = [], early = [];
        scene.traverseVisible(o => {
            if (o.isMesh || o.isLine || o.isPoints || o.isSprite) (this.isLate(o) ? late : early).push(o);
        });
        if (!before)
            changed(materialsOf(late), { colorWrite: false, depthWrite: false }, () =>  /* they still cast shadows */
                this.#drawOpaque(renderer, early, late));
        const back = this.#backs && masked(late, () => this.#behind.draw(renderer, scene, camera, this.#backs));
        this.#occlude(renderer, back);
        const drawsLate = late.length && !before;
        this.#place(renderer, drawsLate ? this.#over : target);
        if (drawsLate) {
            masked(early, () => again(renderer, scene, camera));
            this.#show(renderer, this.#over.texture, target);
        }
        this.#deep.material.uniforms.t_depth.value = this.depthTexture;
        if (target?.depthBuffer ?? true) renderer.render(this.#deep, camera);
    }

    /* Copies a picture into a target. */
    #show(renderer, picture, target) {
        this.#copy ??= over({ fragmentShader: plain, uniforms: { t_picture: { value: null } } });
        this.#copy.material.uniforms.t_picture.value = picture;
        renderer.setRenderTarget(target);
        renderer.render(this.#copy, this.camera);
    }

    /* Makes the run for the picture's size, the camera's kind and its far plane, unless it exists. */
    #fit(renderer) {
        const [width, height] = [this.#width, this.#height], { near, far } = this.camera, { chain } = this.#options;
        const orthographic = this.#asked.orthographic ?? isOrthographic(this.camera);
        const precise = +(Math.max(far, far - near) > 65504);           /* the largest 16-bit float */
        if (this.#renderer !== renderer) this.#leave();
        this.#renderer = renderer;
        if (this.#run?.chain.width === width && this.#run.chain.height === height && chain.precise === precise
            && chain.desc.orthographic === orthographic) return;
        this.#release();
        chain.precise = precise;
        chain.desc.orthographic = orthographic;
        this.#drawer ??= new Drawer(renderer.getContext(), this.#ssgi);
        if (!this.#before) {
            const { samples } = this.#options, count = 1 + this.#outputs.length;
            const depthTexture = new THREE.DepthTexture(width, height, THREE.FloatType);
            const like = { ...nearest, type: THREE.HalfFloatType, depthTexture };
            this.#opaque = new THREE.WebGLRenderTarget(width, height, { ...like, samples, count });
            this.#over = new THREE.WebGLRenderTarget(width, height, like);
        }
        this.#behind = new Behind(width, height);
        this.#run = this.#drawer.run({ ...chain, width, height });
        const { ambient, lit } = this.#options, names = ['picture', 'ambient', 'normal', 'albedo', 'light', 'bounce'];
        const uniforms = Object.fromEntries(names.map(name => [`t_${name}`, { value: null }]));
        this.#screen = over({ fragmentShader: composite, uniforms: { ...uniforms, u_strength: { value: 1 },
            u_harmonics: { value: Array.from({ length: 9 }, () => new THREE.Vector3()) } },
            defines: { SSGI_AMBIENT: +ambient, SSGI_LIGHT: +lit, SSGI_BOUNCE: +!!this.#run.bounce, SSGI_ALONE: 0 } });
        this.#deep = over({ fragmentShader: deep, uniforms: { t_depth: { value: null } }, colorWrite: false,
                            depthTest: true, depthFunc: THREE.AlwaysDepth, depthWrite: true });
        resetState(renderer);
    }

    /* While several outputs are bound, WebGL refuses a material that only writes its colour, such as those of your own
       shaders and three's background. So the other outputs are bound only for materials that write them. The depth of
       the others is drawn first, so that nothing behind them leaves ambient light there. */
    #drawOpaque(renderer, early, late) {
        const gl = renderer.getContext(), opaque = this.#opaque, made = this.#made, { scene, camera } = this;
        const materials = materialsOf(early), hooks = new Map(materials.map(m => [m, m.onBeforeRender]));
        const all = opaque.textures.map((_, i) => gl.COLOR_ATTACHMENT0 + i);
        for (const material of materials) this.#make(material);
        const isStrange = object => materialsOf([object]).some(material => !made.has(material));
        const strange = new Set(all.length > 1 ? early.filter(isStrange) : []);
        let bound = 0;
        function bind(count) {
            if (bound !== count) gl.drawBuffers(all.map((to, i) => (i < count ? to : gl.NONE)));
            bound = count;
        }
        function onBeforeRender(...its) {
            if (renderer.getRenderTarget() === opaque) bind(made.has(this) ? all.length : 1);
            hooks.get(this).apply(this, its);
        }
        renderer.setRenderTarget(opaque);
        bind(all.length);
        if (this.renderToScreen) setClear(renderer);
        renderer.clear();
        this.#outputs.forEach((_, i) => gl.clearBufferfv(gl.COLOR, 1 + i, [0, 0, 0, 0]));
        if (strange.size)
            masked([...early, ...late].filter(object => !strange.has(object)), () =>
                changed(materialsOf([...strange]), { colorWrite: false }, () => again(renderer, scene, camera)));
        bind(1);
        changed([renderer], { autoClearDepth: false }, () =>            /* three would clear to a colour again */
            changed(materials, { onBeforeRender }, () => renderer.render(scene, camera)));
    }

    #make(material) {
        if (!this.#outputs.length || this.#made.has(material) || !isOwn(material)) return;
        const names = this.#outputs.join(' '), held = written.get(material) ?? { names, passes: 0 };
        if (held.names !== names)
            throw new Error(`ambient, pass, normal: another pass has materials of this scene write ${held.names}, this `
                            + `one needs ${names}`);
        held.undo ??= writes(material, this.#outputs.map(name => {
            const { is, unlit, fogged } = outputsOf[name];
            return { name: `o_ssgi_${name.toLowerCase()}`, is: isLit(material) ? is : unlit, fogged: !!fogged };
        }));
        ++held.passes;
        written.set(material, held);
        this.#made.add(material);
        material.addEventListener('dispose', this.#gone);
    }
    #made = new Set();
    #gone = ({ target }) => this.#unmake(target);
    #unmake(material) {
        const held = written.get(material);
        material.removeEventListener('dispose', this.#gone);
        this.#made.delete(material);
        if (--held.passes) return;
        held.undo();
        written.delete(material);
    }

    #occlude(renderer, back) {
        const ssgi = this.#ssgi, { camera } = this, run = this.#run, raw = texture => rawOf(renderer, texture);
        const view = viewOf(ssgi, camera, this.#width, this.#height), frame = ssgi.frame(view, this.radius);
        const toView = Float32Array.from(camera.matrixWorldInverse.elements);
        if (this.#options.lit) this.#shine(frame, toView);
        if (run.chain.history) {
            if (this.#last) ssgi.history(frame, this.#last.view, toView, this.#last.toView);
            frame.phase[0] = ssgi.phase(this.#frames++);
        }
        this.adjust?.(frame);
        const yours = { DEPTH: raw(this.depthTexture), BACK: back ? raw(back) : null };
        this.#outputs.forEach((name, i) => { yours[name] = raw(this.#opaque.textures[1 + i]); });
        for (const [meaning, texture] of Object.entries(this.given)) yours[meaning] = raw(texture);
        run.draw(yours, frame);
        for (const [texture, of] of [[this.#light, run.light], [this.#bounce, run.bounce]])
            Object.assign(renderer.properties.get(texture), { __webglTexture: of, __webglInit: true });
        if (run.chain.history) { run.turn(); this.#last = { view, toView }; }
        resetState(renderer);
    }

    /* Writes the harmonics into the block, turned to view space, and for the composite. */
    #shine(frame, toView) {
        const ssgi = this.#ssgi, { scene } = this, { environment } = scene, at = new THREE.Matrix4();
        ssgi.harmonics(frame, this.harmonics ?? ambientOf(scene), 3, toView);
        const around = environment?.mapping === THREE.EquirectangularReflectionMapping && environment.image?.data;
        if (!this.harmonics && around) {
            const { image: { width, height } } = environment, by = scene.environmentIntensity ?? 1;
            if (this.#environment.of !== environment)
                this.#environment = { of: environment,
                                      sh: ssgi.projectEquirect(3, pixelsOf(environment), width, height) };
            const lights = frame.harmonics.slice(), turn = scene.environmentRotation;
            at.fromArray(toView);
            if (turn) at.multiply(new THREE.Matrix4().makeRotationFromEuler(turn));
            ssgi.harmonics(frame, this.#environment.sh.map(c => c * by), 3, at.multiply(quarter).elements);
            lights.forEach((c, i) => { frame.harmonics[i] += c; });
        }
        this.#screen.material.uniforms.u_harmonics.value.forEach((v, k) =>
            v.fromArray([0, 1, 2].map(c => frame.harmonics[12 * (k >> 2) + 4 * c + k % 4])));
    }

    #place(renderer, target) {
        const { material } = this.#screen, { uniforms, defines } = material, alone = +this.alone;
        if (defines.SSGI_ALONE !== alone) {
            defines.SSGI_ALONE = alone;
            material.needsUpdate = true;
        }
        uniforms.t_picture.value = this.#before?.picture ?? this.#opaque.textures[0];
        uniforms.t_light.value = this.#light;
        uniforms.t_bounce.value = this.#bounce;
        for (const name of ['AMBIENT', 'NORMAL', 'ALBEDO'])
            uniforms[`t_${name.toLowerCase()}`].value =
                this.given[name] ?? this.#opaque?.textures[1 + this.#outputs.indexOf(name)];
        uniforms.u_strength.value = this.strength;
        renderer.setRenderTarget(target);
        renderer.render(this.#screen, this.camera);
    }

    #unmakeAll() { for (const material of [...this.#made]) this.#unmake(material); }

    /* Frees everything that was made for a size. */
    #release() {
        this.#opaque?.dispose();
        this.#over?.dispose();
        this.#behind?.dispose();
        this.#run?.free();
        for (const mesh of [this.#screen, this.#copy, this.#deep]) {
            mesh?.material.dispose();
            mesh?.geometry.dispose();
        }
        this.#opaque = this.#over = this.#behind = this.#run = this.#screen = this.#copy = this.#deep = null;
        this.#last = null;
    }
    #leave() {
        this.#release();
        this.#unmakeAll();
        this.#drawer?.dispose();
        this.#drawer = null;
    }

    dispose() { this.#leave(); }
}

const written = new WeakMap();                      /* outputs of materials, and the number of passes that need them */
