/* tsl.mjs - makes GLSL of three.js' node effects (GTAONode, DenoiseNode, SSGINode) for peers.mjs. Their renderer draws
   with a backend without a GPU, which builds the shaders of the WebGL 2 backend and notes each draw. In the resulting
   shaders plain uniforms replace the blocks. */
globalThis.self ??= globalThis;
globalThis.requestAnimationFrame ??= () => 0;
globalThis.cancelAnimationFrame ??= () => {};
for (const name of [ 'ImageBitmap', 'HTMLImageElement', 'HTMLCanvasElement', 'HTMLVideoElement', 'OffscreenCanvas',
                     'VideoFrame' ])
    globalThis[name] ??= class {};

const THREE = await import('three/webgpu'), TSL = await import('three/tsl');
const { ao } = await import('three/addons/tsl/display/GTAONode.js');
const { denoise } = await import('three/addons/tsl/display/DenoiseNode.js');
const { ssgi } = await import('three/addons/tsl/display/SSGINode.js');

/* ---- >>texts ----------------------------------------------------------------------------------------------------- */

const bare = text => text.replace(/^(#version|precision) .*$/gm, '')
    .replace(/(?:layout\( std140 \) )?uniform \w+ \{([^}]*)\};/g,
             (all, members) => members.replace(/\w+ \w+(?:\[\d+\])?;/g, 'uniform $&'));

/* Rewrites a vertex shader: the quad's texture coordinates are made from gl_VertexID, as its vertices are. */
const vertexOf = text => `${bare(text).replace(/layout\( location = 0 \) in vec2 uv;/, 'vec2 uv;')
    .replace('void main()', 'void peer_main()')}
void main() {
    uv = vec2(gl_VertexID == 2 ? 2.0 : 0.0, gl_VertexID == 0 ? -1.0 : 1.0);
    peer_main();
}
`;

/* Rewrites a fragment shader: outputs with fewer than four components are written as vec4. */
function fragmentOf(text) {
    const swizzle = { float: 'x', vec2: 'xy', vec3: 'xyz', vec4: 'xyzw' };
    return bare(text).replace(/layout\( location = (\d) \) out (\w+) (\w+);/g, (all, n, type, name) =>
        `layout(location = ${n}) out highp vec4 peer_color${n};\n#define ${name} peer_color${n}.${swizzle[type]}`)
        + '\n#define gl_FragColor peer_color0\n';
}

/* ---- >>backend: draws nothing, and notes each draw --------------------------------------------------------------- */

class Notes extends THREE.Backend {
    extensions = { has: () => false };

    constructor(canvas, told) {
        super({ canvas });
        this.told = told;
    }
    get coordinateSystem() { return THREE.WebGLCoordinateSystem; }
    createNodeBuilder(object, renderer) {
        return THREE.WebGLBackend.prototype.createNodeBuilder.call(this, object, renderer);
    }
    hasFeature() { return false; }
    createRenderPipeline({ pipeline }) { this.get(pipeline).pipeline = pipeline; }         /* is ready at once */
    draw(object) {
        const { vertexShader, fragmentShader } = object.getNodeBuilderState(), values = new Map(),
              { textures, clearColor, clearColorValue: colour } = object.context;
        for (const is of object.getBindings().flatMap(group => group.bindings)) {
            if (is.isUniformsGroup) for (const of of is.uniforms) values.set(of.name, of.getValue());
            else if (is.isUniformBuffer)                   /* a uniform block with one member */
                values.set((vertexShader + fragmentShader).match(`${is.name} \\{\\s*\\w+ (\\w+)`)[1], is.buffer);
            else values.set(is.name, is.texture);
        }
        this.told({ vertex: vertexOf(vertexShader), fragment: fragmentOf(fragmentShader), targets: textures,
                    cleared: clearColor && [ colour.r, colour.g, colour.b ], value: name => values.get(name) });
        this.result = textures[0];
    }
}

/* ---- >>effects --------------------------------------------------------------------------------------------------- */

/* Draws ambient visibility by gtao or ssgi with the members of set, then their denoiser with those of filter. told():
   called for each pass with { vertex, fragment, cleared, targets, value: a uniform's value by its name }; input():
   called with a texture that is the caller's depth, normal or picture, and with which of them it is. */
export async function tsl_draw({ width, height, near, far, projection }, effect, set, filter, told, input) {
    const canvas = { width, height, style: {}, addEventListener() {}, removeEventListener() {}, setAttribute() {} },
          backend = new Notes(canvas, told), renderer = new THREE.Renderer(backend, { antialias: false });
    await renderer.init();
    renderer.setPixelRatio(1);
    renderer.setSize(width, height, false);
    const camera = new THREE.PerspectiveCamera();
    Object.assign(camera, { near, far, fov: 2 * Math.atan(1 / projection[5]) * 180 / Math.PI });
    camera.projectionMatrix.fromArray(projection);
    camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
    const target = name => {
        const of = new THREE.RenderTarget(width, height, { type: THREE.HalfFloatType, depthTexture: name === 'depth'
                                                           ? new THREE.DepthTexture(width, height) : null });
        const texture = name === 'depth' ? of.depthTexture : of.texture;
        input(texture, name);
        return TSL.texture(texture);
    };
    const depth = target('depth'), normal = target('normal');
    const node = effect === 'ssgi' ? ssgi(target('picture'), depth, normal, camera) : ao(depth, normal, camera);
    node.useTemporalFiltering = false;
    const assign = (to, from) => {
        for (const [name, value] of Object.entries(from))
            if (to[name]?.isNode) to[name].value = value; else to[name] = value;
    };
    assign(node, set);
    const filtered = denoise(effect === 'ssgi' ? node.getAONode() : node.getTextureNode(), depth, normal, camera),
          material = new THREE.NodeMaterial();
    assign(filtered, filter);
    material.fragmentNode = filtered;
    renderer.setRenderTarget(new THREE.RenderTarget(width, height, { depthBuffer: false, type: THREE.HalfFloatType }));
    new THREE.QuadMesh(material).render(renderer);
    return backend.result;
}
