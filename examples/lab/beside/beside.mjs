/* beside.mjs - a scene of the page as others draw it in a browser: three.js' GTAOPass, n8ao, Babylon.js' SSAO2, each as
   its own examples set it up, with this page's camera, size, radius and light. make web-shots bundles it and calls
   draw(name, look) for each.

   look: of the page: { width, height, file: the scene's .bin, camera: { position, target, fov, near, far }, radius,
   sun: { toSun, irradiance, position, target, half, near, far, normalBias, bias }, sky: radiance as nine harmonics } */
import * as THREE from 'three';
import { EffectComposer } from 'three/addons/postprocessing/EffectComposer.js';
import { GTAOPass } from 'three/addons/postprocessing/GTAOPass.js';
import { OutputPass } from 'three/addons/postprocessing/OutputPass.js';
import { RenderPass } from 'three/addons/postprocessing/RenderPass.js';
import { N8AOPass } from 'n8ao';
import { Engine } from '@babylonjs/core/Engines/engine.js';
import { Scene } from '@babylonjs/core/scene.js';
import { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js';
import { DirectionalLight } from '@babylonjs/core/Lights/directionalLight.js';
import { HemisphericLight } from '@babylonjs/core/Lights/hemisphericLight.js';
import { ShadowGenerator } from '@babylonjs/core/Lights/Shadows/shadowGenerator.js';
import '@babylonjs/core/Lights/Shadows/shadowGeneratorSceneComponent.js';
import { Material } from '@babylonjs/core/Materials/material.js';
import { StandardMaterial } from '@babylonjs/core/Materials/standardMaterial.js';
import { Color3, Color4 } from '@babylonjs/core/Maths/math.color.js';
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js';
import { Mesh } from '@babylonjs/core/Meshes/mesh.js';
import { VertexData } from '@babylonjs/core/Meshes/mesh.vertexData.js';
import { SSAO2RenderingPipeline } from
    '@babylonjs/core/PostProcesses/RenderPipeline/Pipelines/ssao2RenderingPipeline.js';
import '@babylonjs/core/Rendering/geometryBufferRendererSceneComponent.js';
import '@babylonjs/core/Rendering/prePassRendererSceneComponent.js';

/* Of a file of examples/web/scenes.c. */
async function meshOf(file) {
    const bytes = await (await fetch(file)).arrayBuffer(), [vertices, indices] = new Uint32Array(bytes, 0, 2);
    const at = [8, 8 + 12 * vertices, 8 + 20 * vertices, 8 + 28 * vertices], three = (list, scale) =>
        Float32Array.from({ length: 3 * vertices }, (_, i) => list[4 * Math.floor(i / 3) + i % 3] / scale);
    return { positions: new Float32Array(bytes, at[0], 3 * vertices),
             normals: three(new Int16Array(bytes, at[1], 4 * vertices), 32767),
             colours: three(new Uint16Array(bytes, at[2], 4 * vertices), 65535),
             indices: new Uint32Array(bytes, at[3], indices) };
}

const exposure = 0.45;                              /* as show.mjs has it */

/* ---- three.js */

async function stageOf({ width, height, file, camera: from, sun: is, sky }, canvas) {
    const renderer = new THREE.WebGLRenderer({ canvas, antialias: false });
    renderer.setSize(width, height, false);
    renderer.shadowMap.enabled = true;
    renderer.toneMapping = THREE.ACESFilmicToneMapping;
    renderer.toneMappingExposure = exposure;
    const scene = new THREE.Scene(), { positions, normals, colours, indices } = await meshOf(file);
    const shape = new THREE.BufferGeometry();
    for (const [name, list] of [['position', positions], ['normal', normals], ['color', colours]])
        shape.setAttribute(name, new THREE.BufferAttribute(list, 3));
    shape.setIndex(new THREE.BufferAttribute(indices, 1));
    const mesh = new THREE.Mesh(shape, new THREE.MeshLambertMaterial({ vertexColors: true, side: THREE.DoubleSide,
                                                                       shadowSide: THREE.DoubleSide }));
    mesh.castShadow = mesh.receiveShadow = true;
    const probe = new THREE.LightProbe(), sun = new THREE.DirectionalLight();
    probe.sh.fromArray(sky);
    sun.color.setRGB(...is.irradiance);
    sun.position.fromArray(is.position);
    sun.target.position.fromArray(is.target);
    sun.castShadow = true;
    sun.shadow.mapSize.set(2048, 2048);
    Object.assign(sun.shadow, { radius: 2, normalBias: is.normalBias, bias: is.bias });
    Object.assign(sun.shadow.camera, { left: -is.half, right: is.half, top: is.half, bottom: -is.half, near: is.near,
                                       far: is.far });
    sun.shadow.camera.updateProjectionMatrix();
    scene.add(mesh, probe, sun, sun.target);
    const camera = new THREE.PerspectiveCamera(from.fov, width / height, from.near, from.far);
    camera.position.fromArray(from.position);
    camera.lookAt(...from.target);
    camera.updateMatrixWorld();
    return { renderer, scene, camera };
}

async function byThree(look, canvas, passes) {
    const { renderer, scene, camera } = await stageOf(look, canvas), { width, height } = look;
    const target = new THREE.WebGLRenderTarget(width, height, { type: THREE.HalfFloatType, samples: 4 });
    const composer = new EffectComposer(renderer, target);
    composer.setPixelRatio(1);
    composer.setSize(width, height);
    for (const pass of [...passes(scene, camera), new OutputPass()]) composer.addPass(pass);
    for (let i = 0; i < 2; ++i) composer.render();
}

/* ---- Babylon.js */

async function byBabylon({ width, height, file, camera: from, sun: is, sky, radius }, canvas) {
    canvas.width = width;
    canvas.height = height;
    const engine = new Engine(canvas, true, { preserveDrawingBuffer: true }), scene = new Scene(engine);
    const { positions, normals, colours, indices } = await meshOf(file), data = new VertexData();
    scene.useRightHandedSystem = true;
    scene.clearColor = new Color4(0, 0, 0, 1);
    const coded = c => (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055);   /* its colours are sRGB */
    Object.assign(data, { positions, normals, indices, colors: Float32Array.from(
        { length: 4 * positions.length / 3 }, (_, i) => (i % 4 === 3 ? 1 : coded(colours[3 * (i >> 2) + i % 4]))) });
    const mesh = new Mesh('scene', scene), material = new StandardMaterial('lambert', scene);
    data.applyToMesh(mesh);
    material.specularColor = Color3.Black();
    material.backFaceCulling = false;
    material.sideOrientation = Material.CounterClockWiseSideOrientation;
    mesh.material = material;
    mesh.receiveShadows = true;
    const camera = new FreeCamera('eye', Vector3.FromArray(from.position), scene);
    camera.setTarget(Vector3.FromArray(from.target));
    Object.assign(camera, { fov: from.fov * Math.PI / 180, minZ: from.near, maxZ: from.far });
    /* of the sky what it has room for: a colour above and one below, displayed as they are */
    const level = up => Color3.FromArray([0, 1, 2].map(c => coded(Math.min(1, exposure * Math.max(
        0, 0.886227 * sky[c] / Math.PI + up * 1.023328 * sky[3 + c] / Math.PI)))));
    const above = new HemisphericLight('sky', Vector3.Up(), scene);
    above.diffuse = level(1);
    above.groundColor = level(-1);
    const sun = new DirectionalLight('sun', Vector3.FromArray(is.toSun).negate(), scene);
    sun.position = Vector3.FromArray(is.position);
    sun.diffuse = Color3.FromArray(is.irradiance.map(c => coded(exposure * c / Math.PI)));
    sun.shadowFrustumSize = 2 * is.half;
    Object.assign(sun, { shadowMinZ: is.near, shadowMaxZ: is.far });
    const shadows = new ShadowGenerator(2048, sun);
    shadows.usePercentageCloserFiltering = true;
    shadows.bias = 0.002;
    shadows.addShadowCaster(mesh);
    const ssao = new SSAO2RenderingPipeline('ssao', scene, { ssaoRatio: 1, blurRatio: 1 }, [camera]);
    Object.assign(ssao, { radius, samples: 16, expensiveBlur: true, maxZ: from.far, minZAspect: 0.5,
                          totalStrength: 1 });
    await scene.whenReadyAsync();
    for (let i = 0; i < 3; ++i) scene.render();
}

const peers = {
    __proto__: null,
    gtao: (look, canvas) => byThree(look, canvas, (scene, camera) => {
        const pass = new GTAOPass(scene, camera, look.width, look.height);
        pass.updateGtaoMaterial({ radius: look.radius });
        return [new RenderPass(scene, camera), pass];
    }),
    n8ao: (look, canvas) => byThree(look, canvas, (scene, camera) => {
        const pass = new N8AOPass(scene, camera, look.width, look.height);
        Object.assign(pass.configuration, { aoRadius: look.radius, distanceFalloff: 1, gammaCorrection: false });
        return [pass];
    }),
    babylon: byBabylon
};

globalThis.draw = async (name, look) => {
    const canvas = document.createElement('canvas');
    canvas.style.cssText = `position: fixed; inset: 0; width: ${look.width}px; height: ${look.height}px`;
    document.body.replaceChildren(canvas);
    await peers[name](look, canvas);
};
