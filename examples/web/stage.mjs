/* stage.mjs - the host of ssgi: three.js has scene, camera and sun, and draws the inputs of ssgi in one pass: depth,
   normals in view space, albedo, and beside them what the sun lights. Its materials stay its own, two outputs added.
   The albedo's fourth component tells objects apart. */
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { Behind, rawOf, resetState, writes } from './three.mjs';

/* Albedo's fourth component on object 0, the scene; on 1, the moving object; on 2, the visitor's model. */
const marks = ['1.0', '0.0', '0.75'];

/* Makes a material of three.js write outputs 1 and 2, normal and albedo. three turns the normal to the visible side. */
function seen(material) {
    writes(material, [{ name: 'g_normal', is: 'vec4(normal, 0.0)' },
                      { name: 'g_albedo', is: `vec4(diffuseColor.rgb, ${marks[material.userData.object]})` }]);
    return material;
}

export const lambert = (from, object = 0) => seen(new THREE.MeshLambertMaterial({
    color: from.color ?? 0xcccccc, map: from.map ?? null, normalMap: from.normalMap ?? null,
    alphaTest: from.alphaTest || (from.transparent ? 0.5 : 0), vertexColors: from.vertexColors ?? false,
    side: THREE.DoubleSide, shadowSide: THREE.DoubleSide, userData: { object }
}));

export class Stage {
    #target = null; #behind = null; #model = null; #size = { width: 1, height: 1 };
    #casts = new THREE.Box3(); #all = new THREE.Box3(); #toSun = new THREE.Vector3(0, 1, 0);
    #seenFrom = null;
    mover = null;

    constructor(canvas) {
        this.renderer = new THREE.WebGLRenderer({ canvas, context: canvas.getContext('webgl2') });
        this.renderer.shadowMap.enabled = true;
        this.renderer.shadowMap.autoUpdate = false;
        this.renderer.setClearColor(0x000000, 0);
        this.scene = new THREE.Scene();
        this.camera = new THREE.PerspectiveCamera();
        this.controls = new OrbitControls(this.camera, canvas);
        this.controls.enableDamping = false;
        this.controls.zoomToCursor = true;
        this.controls.listenToKeyEvents(canvas);            /* arrow keys move the view, with shift they turn it */
        this.sun = new THREE.DirectionalLight(0xffffff, 3.2);
        this.sun.color.setRGB(1, 0.89, 0.74);
        this.sun.castShadow = true;
        this.sun.shadow.mapSize.set(2048, 2048);
        this.sun.shadow.radius = 2;
        this.scene.add(this.sun, this.sun.target);
    }
    get gl() { return this.renderer.getContext(); }

    resize(width, height) {
        this.#size = { width, height };
        this.renderer.setSize(width, height, false);
        this.camera.aspect = width / height;
        this.#widen();
        this.#target?.dispose();
        this.#behind?.dispose();
        this.#behind = new Behind(width, height);
        this.#target = new THREE.WebGLRenderTarget(width, height, {
            minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter, count: 3, type: THREE.HalfFloatType,
            depthTexture: new THREE.DepthTexture(width, height, THREE.FloatType) });
        this.#target.textures[2].type = THREE.UnsignedByteType;
    }

    /* Shows a scene from now on; info has its camera and radius. */
    show(model, info) {
        if (this.#model) {
            this.scene.remove(this.#model);
            this.#model.traverse(part => {
                part.geometry?.dispose();
                [part.material ?? []].flat().forEach(m => m.dispose());
            });
        }
        this.#casts.makeEmpty();
        model.updateMatrixWorld(true);
        model.traverse(part => {
            part.castShadow = part.receiveShadow = true;
            if (part.isMesh && !part.userData.ground) this.#casts.expandByObject(part);
        });
        this.scene.add(this.#model = model);
        this.info = info;
        if (this.mover) this.mover.around = null;
        this.#all.setFromObject(model);
        info.key ??= ++shown;
        Object.assign(this.camera, { near: info.near, far: info.far });
        this.#widen();
        this.look(info.eye, info.target);
        this.#aim();
    }

    /* Fits the sun's shadow map around all that casts, as build/render's widest map is, and as deep as the scene. */
    #aim() {
        const { shadow, position, target } = this.sun, { camera } = shadow, to = this.#toSun;
        camera.up.set(+(Math.abs(to.y) >= 0.9), +(Math.abs(to.y) < 0.9), 0);
        const axes = new THREE.Matrix4().lookAt(to, new THREE.Vector3(), camera.up), way = axes.clone().transpose();
        const box = this.#reached().applyMatrix4(way), size = box.getSize(new THREE.Vector3());
        const middle = box.getCenter(new THREE.Vector3()), margin = 0.01 * size.z + 1e-6;
        const low = this.#all.clone().applyMatrix4(way).min.z, half = 0.5 * (1.01 * Math.max(size.x, size.y) + 1e-6);
        position.set(middle.x, middle.y, box.max.z + 2 * margin).applyMatrix4(axes);
        target.position.copy(position).sub(to);
        Object.assign(camera, { left: -half, right: half, top: half, bottom: -half, near: margin,
                                far: box.max.z - Math.min(low, box.min.z) + 3 * margin });
        camera.updateProjectionMatrix();
        shadow.normalBias = 3 * half / shadow.mapSize.x;
        shadow.bias = -0.0008;
        this.renderer.shadowMap.needsUpdate = true;
    }
    /* Returns the bounds of all that casts, with the circle of the moving object. */
    #reached() {
        const { info, mover } = this, box = this.#casts.clone();
        if (!mover) return box;
        return box.union(new THREE.Box3(new THREE.Vector3(), new THREE.Vector3())
            .setFromCenterAndSize(new THREE.Vector3(...info.target), new THREE.Vector3().setScalar(5.6 * info.radius)));
    }

    /* Sets the sun: degrees from +z toward +x, and above the horizon; strength 1 suits the clear sky. */
    shine(azimuth, height, strength) {
        const lon = azimuth * Math.PI / 180, lat = height * Math.PI / 180, level = Math.cos(lat);
        this.#toSun.set(Math.sin(lon) * level, Math.sin(lat), Math.cos(lon) * level);
        this.sun.intensity = 3.2 * strength;
        this.#aim();
    }

    /* Returns the sun for the library: the way to it and its irradiance, in the world; the matrices of its map. */
    get sunlight() {
        const { color, intensity, shadow: { camera, mapSize } } = this.sun;
        camera.updateMatrixWorld();
        return { toSun: this.#toSun.toArray(), irradiance: color.toArray().map(c => c * intensity),
                 projection: camera.projectionMatrix.elements, size: mapSize.x,
                 worldToLight: camera.matrixWorldInverse.elements };
    }

    /* Moves an object around the view's target to its place at that time; null: removes it. Its matrices of this and
       the last frame are mover.now and mover.before. */
    move(seconds) {
        if (seconds === null) {
            this.mover?.mesh.removeFromParent();
            if (!this.mover) return;
            this.mover = null;
            this.#aim();
            return;
        }
        if (!this.mover) {
            const mesh = new THREE.Mesh(new THREE.TorusKnotGeometry(1, 0.38, 160, 24), lambert({ color: 0xe8b04a }, 1));
            mesh.castShadow = mesh.receiveShadow = true;
            this.mover = { mesh, now: new THREE.Matrix4(), before: null };
        }
        const { mesh } = this.mover, turn = 0.7 * seconds, { wide } = this.mover.around ??= this.#around();
        mesh.scale.setScalar(wide * 0.55);
        mesh.position.copy(this.#onCircle(this.mover.around, turn));
        mesh.position.y += 0.3 * wide * Math.sin(2.3 * turn);
        mesh.rotation.set(0.6 * turn, turn, 0);
        if (mesh.parent !== this.scene) this.scene.add(mesh);
        mesh.updateMatrixWorld(true);
        if (!this.mover.started) this.#aim();
        this.mover.before = this.mover.started ? this.mover.now.clone() : mesh.matrixWorld.clone();
        this.mover.now.copy(mesh.matrixWorld);
        this.mover.started = true;
        this.renderer.shadowMap.needsUpdate = true;
    }

    #onCircle({ at, far }, turn) {
        return at.clone().add(new THREE.Vector3(Math.sin(turn) * far, 0, Math.cos(turn) * far));
    }
    /* Chooses the moving object's circle about the view's target, so high that more than half of it is visible, and the
       object's width, at least a sixth of half the image's height. */
    #around() {
        const { info } = this, eye = new THREE.Vector3(...info.eye), target = new THREE.Vector3(...info.target);
        const half = eye.distanceTo(target) * Math.tan(info.fovy * Math.PI / 360);
        const far = Math.min(2.2 * info.radius, 0.8 * half), wide = Math.max(0.55 * info.radius, 0.17 * half);
        let best = null;
        for (let lift = 0; lift < 5 && !(best?.seen >= 7); ++lift) {
            const circle = { at: target.clone().setY(target.y + lift * 0.6 * info.radius), far, wide, seen: 0 };
            for (let i = 0; i < 12; ++i) {
                const way = this.#onCircle(circle, i * Math.PI / 6).sub(eye), length = way.length();
                const ray = new THREE.Raycaster(eye, way.normalize(), 0, length + 0.3 * info.radius);
                circle.seen += !ray.intersectObject(this.#model).length;
            }
            if (!(best?.seen >= circle.seen)) best = circle;
        }
        return best;
    }

    /* Returns matrices that find each pixel in the last frame that asked: from this view to the world, and from there
       to the last view, for resting and for moving things. */
    reprojection() {
        const { camera, mover } = this, now = camera.projectionMatrix.clone().multiply(camera.matrixWorldInverse);
        const last = this.#seenFrom ?? now, moved = last.clone();
        if (mover) moved.multiply(mover.before).multiply(mover.now.clone().invert());
        this.#seenFrom = now;
        return { back: now.clone().invert().elements, last: last.elements, moved: moved.elements };
    }

    /* Moves the projection by that many pixels, for the mean of images that smooths edges. */
    jitter(x, y) {
        const { camera, info } = this, { elements } = camera.projectionMatrix;
        /* the far plane holds the whole scene, as far as 16-bit floats hold depth */
        const { center, radius } = this.#all.getBoundingSphere(new THREE.Sphere());
        camera.far = Math.max(info.far, Math.min(camera.position.distanceTo(center) + radius, 65504));
        camera.updateProjectionMatrix();
        elements[8] -= 2 * x / this.#size.width;
        elements[9] -= 2 * y / this.#size.height;
        camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
    }

    /* Turns the view about its target by radians. */
    circle(by) {
        const { camera, controls } = this;
        camera.position.sub(controls.target).applyAxisAngle(new THREE.Vector3(0, 1, 0), by).add(controls.target);
        controls.update();
        camera.updateMatrixWorld();
    }

    /* Widens the vertical angle of narrow images, so that they show as much to the sides as at 5:4. */
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

    /* Draws the G-buffer and returns its WebGL textures. backs: 1: also the depth of the nearest back face; 3: also
       those of the next slab's two faces. */
    draw(backs) {
        const { renderer, scene, camera } = this, raw = texture => rawOf(renderer, texture);
        resetState(renderer);
        renderer.setRenderTarget(this.#target);
        renderer.clear();
        renderer.render(scene, camera);
        const back = backs && this.#behind.draw(renderer, scene, camera, backs);
        renderer.setRenderTarget(null);
        const [direct, normal, albedo] = this.#target.textures.map(raw);
        return { DIRECT: direct, NORMAL: normal, ALBEDO: albedo, DEPTH: raw(this.#target.depthTexture), backs,
                 SHADOW: raw(this.sun.shadow.map.depthTexture), BACK: back ? raw(back) : null };
    }

    /* Returns the scene's triangles in world space, or those of one of its objects. */
    triangles(object = null) {
        return trianglesOf(this.#model, ({ userData }) => object === null || userData.object === object);
    }
    /* Returns the moving object's triangles in its own space or, if placed, in world space. */
    moverTriangles(placed = false) {
        const { mesh, now } = this.mover;
        return trianglesOf(mesh, () => true, placed ? now : new THREE.Matrix4());
    }

    /* Returns all triangles in world space. */
    everything() {
        const scene = this.triangles(), moves = this.mover && this.moverTriangles(true);
        if (!moves) return scene;
        return { position: joined([scene.position, moves.position]), normal: joined([scene.normal, moves.normal]) };
    }

    /* Returns the objects that can have fields: title, number in the G-buffer, triangles and matrix to the world. */
    objects() {
        const all = [], { info, mover } = this;
        if (mover)
            all.push({ key: 'mover', title: 'what moves', number: 1, toWorld: () => mover.now,
                       triangles: () => this.moverTriangles().position });
        if (info.name === 'file')
            all.push({ key: `model ${info.key}`, title: info.title, number: 2,
                       toWorld: () => new THREE.Matrix4(), triangles: () => this.triangles(2).position });
        return all;
    }
}

let shown = 0;                                      /* scenes so far */

/* Returns triangles of wanted materials, nine floats each. matrix: from their own space; null: to world space. */
function trianglesOf(root, wanted, matrix = null) {
    const position = [], normal = [], p = new THREE.Vector3(), turn = new THREE.Matrix3();
    root.updateMatrixWorld(true);
    root.traverse(part => {
        if (!part.isMesh || ![part.material].flat().some(wanted)) return;
        const { attributes, index } = part.geometry, count = index ? index.count : attributes.position.count;
        const at = new Float32Array(3 * count), way = new Float32Array(3 * count), to = matrix ?? part.matrixWorld;
        turn.getNormalMatrix(to);
        for (let i = 0; i < count; ++i) {
            const k = index ? index.getX(i) : i;
            p.fromBufferAttribute(attributes.position, k).applyMatrix4(to).toArray(at, 3 * i);
            p.fromBufferAttribute(attributes.normal, k).applyMatrix3(turn).normalize().toArray(way, 3 * i);
        }
        position.push(at);
        normal.push(way);
    });
    return { position: joined(position), normal: joined(normal) };
}

function joined(parts) {
    const all = new Float32Array(parts.reduce((n, part) => n + part.length, 0));
    let at = 0;
    for (const part of parts) { all.set(part, at); at += part.length; }
    return all;
}
