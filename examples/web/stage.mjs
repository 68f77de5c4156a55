/* stage.mjs - the host: three.js keeps scene, camera and sun, and draws once what ssgi reads: depth, normals in view
   space, albedo, and beside them what the sun lights. Its materials stay its own, two outputs added. */
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

/* Outputs 1 and 2 of a material of three's, which turns its normal to the side that is seen. */
function seen(material) {
    material.onBeforeCompile = shader => {
        shader.fragmentShader = shader.fragmentShader
            .replace('void main() {', `layout(location = 1) out highp vec4 g_normal;
                layout(location = 2) out highp vec4 g_albedo;
                void main() {`)
            .replace('#include <opaque_fragment>', `#include <opaque_fragment>
                g_normal = vec4(normal, 0.0);
                g_albedo = vec4(diffuseColor.rgb, 1.0);`);
    };
    return material;
}

export const lambert = from => seen(new THREE.MeshLambertMaterial({
    color: from.color ?? 0xcccccc, map: from.map ?? null, normalMap: from.normalMap ?? null,
    alphaTest: from.alphaTest || (from.transparent ? 0.5 : 0), vertexColors: from.vertexColors ?? false,
    side: THREE.DoubleSide, shadowSide: THREE.DoubleSide
}));

export class Stage {
    #target = null; #back = null; #model = null; #sunAt = new THREE.Vector3(0.5792280, 0.5735764, 0.5792280);
    #behind = new THREE.MeshBasicMaterial({ side: THREE.BackSide, colorWrite: false });

    constructor(canvas) {
        this.renderer = new THREE.WebGLRenderer({ canvas, antialias: false, stencil: false,
                                                  powerPreference: 'high-performance' });
        this.renderer.shadowMap.enabled = true;
        this.renderer.shadowMap.autoUpdate = false;
        this.renderer.setClearColor(0x000000, 0);
        this.scene = new THREE.Scene();
        this.camera = new THREE.PerspectiveCamera();
        this.controls = new OrbitControls(this.camera, canvas);
        this.controls.enableDamping = false;
        this.controls.zoomToCursor = true;
        this.controls.listenToKeyEvents(canvas);            /* arrows move, with shift they turn */
        this.sun = new THREE.DirectionalLight(0xffffff, 3.2);
        this.sun.color.setRGB(1, 0.89, 0.74);
        this.sun.castShadow = true;
        this.sun.shadow.mapSize.set(2048, 2048);
        this.sun.shadow.radius = 2;
        this.scene.add(this.sun, this.sun.target);
    }
    get gl() { return this.renderer.getContext(); }

    resize(width, height) {
        this.renderer.setSize(width, height, false);
        this.camera.aspect = width / height;
        this.#widen();
        const nearest = { minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter };
        const depth = () => new THREE.DepthTexture(width, height, THREE.FloatType);
        this.#target?.dispose();
        this.#back?.dispose();
        this.#target = new THREE.WebGLRenderTarget(width, height, { count: 3, type: THREE.HalfFloatType, ...nearest,
                                                                    depthTexture: depth() });
        this.#target.textures[2].type = THREE.UnsignedByteType;
        this.#back = new THREE.WebGLRenderTarget(width, height, { ...nearest, depthTexture: depth() });
    }

    /* What is seen from now on: info tells where from, and the radius. */
    show(model, info) {
        if (this.#model) {
            this.scene.remove(this.#model);
            this.#model.traverse(part => {
                part.geometry?.dispose();
                [part.material ?? []].flat().forEach(m => m.dispose());
            });
        }
        model.traverse(part => { part.castShadow = part.receiveShadow = true; });
        this.scene.add(this.#model = model);
        this.info = info;
        Object.assign(this.camera, { near: info.near, far: info.far });
        this.#widen();
        this.look(info.eye, info.target);
        /* the sun's map covers what the first view looks at */
        const reach = new THREE.Vector3(...info.eye).distanceTo(this.controls.target), { shadow } = this.sun;
        this.sun.target.position.copy(this.controls.target);
        this.sun.position.copy(this.#sunAt).multiplyScalar(3 * reach).add(this.controls.target);
        Object.assign(shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: 0.2 * reach,
                                       far: 6 * reach });
        shadow.camera.updateProjectionMatrix();
        shadow.normalBias = 3 * reach / shadow.mapSize.x;
        shadow.bias = -0.0008;
        this.renderer.shadowMap.needsUpdate = true;
    }

    /* Narrow pictures see as far to the sides as those a little wider than high. */
    #widen() {
        const half = Math.tan((this.info?.fovy ?? 50) * Math.PI / 360), { camera } = this;
        camera.fov = Math.atan(half * Math.max(1, 1.25 / camera.aspect)) * 360 / Math.PI;
        camera.updateProjectionMatrix();
    }

    look(eye, target) {
        this.camera.position.fromArray(eye);
        this.controls.target.fromArray(target);
        this.controls.update();
        this.camera.updateProjectionMatrix();
        this.camera.updateMatrixWorld();
    }

    /* The G-buffer, as three's textures are in WebGL. back: 1: depth of the nearest back face, too. */
    draw(back) {
        const { renderer, scene, camera } = this, raw = texture => renderer.properties.get(texture).__webglTexture;
        renderer.resetState();
        renderer.setRenderTarget(this.#target);
        renderer.clear();
        renderer.render(scene, camera);
        if (back) {
            const shadows = this.sun.castShadow;
            scene.overrideMaterial = this.#behind;
            renderer.setRenderTarget(this.#back);
            renderer.clear();
            renderer.render(scene, camera);
            scene.overrideMaterial = null;
            this.sun.castShadow = shadows;
        }
        renderer.setRenderTarget(null);
        const [direct, normal, albedo] = this.#target.textures.map(raw);
        return { DIRECT: direct, NORMAL: normal, ALBEDO: albedo, DEPTH: raw(this.#target.depthTexture),
                 BACK: back ? raw(this.#back.depthTexture) : null };
    }

    /* The triangles in the world, for the tracer. */
    triangles() {
        const position = [], normal = [], p = new THREE.Vector3(), turn = new THREE.Matrix3();
        this.#model.updateMatrixWorld(true);
        this.#model.traverse(part => {
            if (!part.isMesh) return;
            const { attributes, index } = part.geometry, count = index ? index.count : attributes.position.count;
            const at = new Float32Array(3 * count), way = new Float32Array(3 * count);
            turn.getNormalMatrix(part.matrixWorld);
            for (let i = 0; i < count; ++i) {
                const k = index ? index.getX(i) : i;
                p.fromBufferAttribute(attributes.position, k).applyMatrix4(part.matrixWorld).toArray(at, 3 * i);
                p.fromBufferAttribute(attributes.normal, k).applyMatrix3(turn).normalize().toArray(way, 3 * i);
            }
            position.push(at);
            normal.push(way);
        });
        const join = parts => {
            const all = new Float32Array(parts.reduce((n, part) => n + part.length, 0));
            let at = 0;
            for (const part of parts) { all.set(part, at); at += part.length; }
            return all;
        };
        return { position: join(position), normal: join(normal) };
    }
}
