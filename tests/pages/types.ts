/* types.ts - tests the types of the npm package by tsc: right uses compile, wrong ones do not. For hosts.sh. */
import * as THREE from 'three';
import { load, type Desc, type Frame } from 'ssgi';
import { Drawer } from 'ssgi/webgl';
import { SSGIPass, ambientOf } from 'ssgi/three';
import { SSGIPass as OfPmndrs, SSGIRenderPass } from 'ssgi/postprocessing';
import { EffectComposer } from 'postprocessing';
import hsao from 'ssgi/chains/hsao';
import { occlusion } from 'ssgi/three/webgpu';
import { Passes, sized } from 'ssgi/webgpu';
import { pass as passOf } from 'three/tsl';

const pass = new SSGIPass(new THREE.Scene(), new THREE.PerspectiveCamera(),
                          { pass: 'SSDO', preset: 'FAST', resolution: 'FULL' });
pass.adjust = (frame: Frame) => { frame.thickness_limit[0] = 0.2; };
pass.given = { MOTION: new THREE.Texture() };
pass.harmonics = ambientOf(pass.scene);
pass.set({ thickness: 'SLABS', history: true });
/* @ts-expect-error */
pass.adjust = frame => { frame.thicknes[0] = 0.2; };
/* @ts-expect-error */
pass.set({ pass: 'HSOA' });
/* @ts-expect-error */
pass.set({ radus: 1 });

const composer = new EffectComposer();
for (const own of [new OfPmndrs(pass.scene, pass.camera, { radius: 2 }), new SSGIRenderPass(pass.scene, pass.camera)]) {
    composer.addPass(own);
    own.strength = 0.5;
}
/* @ts-expect-error */
new OfPmndrs(pass.scene, pass.camera, { ambient: true });

const picture = passOf(pass.scene, pass.camera), depth = picture.getTextureNode('depth');
occlusion(hsao, { DEPTH: depth, NORMAL: new THREE.Texture() }, pass.camera, { radius: 2 }).getTextureNode();
new Passes(null, sized(hsao, 64, 64)).result('LIGHT');
/* @ts-expect-error */
occlusion(hsao, { DEPTH: depth }, pass.camera, { radius: '2' });
/* @ts-expect-error */
new Passes(null, hsao).result('LIHGT');

export async function draw(gl: WebGL2RenderingContext, depth: WebGLTexture, projection: number[]) {
    const ssgi = await load(), desc: Desc = ssgi.preset({ pass: 'HSAO', dialect: '300ES' }, 'BALANCED');
    const run = new Drawer(gl, ssgi).run({ desc, width: 64, height: 64, blur: 1 });
    run.draw({ DEPTH: depth }, ssgi.frame(ssgi.view(projection, 64, 64), 0.5));
    /* @ts-expect-error */
    run.draw({ DEPTH: depth }, { buffer: new ArrayBuffer(64) });
    return run.light;
}
