/* tsl.mjs - three.js' node effects (GTAONode, DenoiseNode, SSGINode) as GLSL, for peers.mjs.

   Their WebGPURenderer draws with its WebGL 2 backend into a context that draws nothing and notes each call. Its texts
   come back with plain uniforms in place of blocks, whose values are read from the buffers by std140. */
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

/* ---- >>context: WebGL 2 that draws nothing ----------------------------------------------------------------------- */

/* Every constant has a number of its own, the same in all contexts; from units and attachments others are counted. */
const ATTACHMENT = 1e6, constants = {
    numbers: new Map([ [ 'TEXTURE0', 0 ], [ 'COLOR_ATTACHMENT0', ATTACHMENT ] ]),
    names: [],
    number(name) {
        if (!this.numbers.has(name)) this.numbers.set(name, 1000 + this.names.push(name) - 1);
        return this.numbers.get(name);
    },
    name(number) { return this.names[number - 1000]; }
};

/* draw: told at every draw of the program, the textures of units, the buffers of blocks, the targets and the colour
   that clears them. */
function contextOf(width, height, draw) {
    const bound = [], blocks = [], buffers = {};
    let program, unit = 0, framebuffer;
    const upload = (target, data) => {
        buffers[target].bytes = new Uint8Array(data.buffer, data.byteOffset, data.byteLength);
    };
    const calls = {
        getContextAttributes: () => ({}),
        getParameter: () => 16384,
        getSupportedExtensions: () => [],
        getExtension: () => null,
        getShaderParameter: () => true,
        getProgramParameter: () => true,
        getShaderInfoLog: () => '',
        getProgramInfoLog: () => '',
        getError: () => 0,
        checkFramebufferStatus: () => constants.number('FRAMEBUFFER_COMPLETE'),
        createShader: type => ({ type: constants.name(type) }),
        shaderSource: (shader, text) => { shader.text = text; },
        createProgram: () => ({ text: {}, blocks: [], binding: [], units: new Map() }),
        attachShader: (to, { type, text }) => { to.text[type] = text; },
        useProgram: is => { program = is; },
        getUniformBlockIndex: (of, name) => of.blocks.push(name) - 1,
        uniformBlockBinding: (of, index, binding) => { of.binding[index] = binding; },
        getUniformLocation: (of, name) => ({ of, name }),
        uniform1i: ({ of, name }, value) => { of.units.set(name, value); },
        createTexture: () => ({}),
        activeTexture: number => { unit = number; },
        bindTexture: (target, texture) => { bound[unit] = texture; },
        texStorage2D: (target, levels, format, w, h) =>
            Object.assign(bound[unit], { format: constants.name(format), width: w, height: h }),
        texSubImage2D: (...all) => { bound[unit].data = all.at(-1); },
        texParameteri: (target, name, value) => { bound[unit][constants.name(name)] = constants.name(value); },
        createBuffer: () => ({}),
        bindBuffer: (target, buffer) => { buffers[target] = buffer; },
        bindBufferBase: (target, binding, buffer) => { blocks[binding] = buffers[target] = buffer; },
        bufferData: upload,
        bufferSubData: (target, at, data) => upload(target, data),
        createFramebuffer: () => ({ targets: [] }),
        bindFramebuffer: (target, is) => { framebuffer = is; },
        framebufferTexture2D: (target, attachment, kind, texture) => {
            if (attachment >= ATTACHMENT) framebuffer.targets[attachment - ATTACHMENT] = texture;
        },
        clearBufferfv: (buffer, n, colour) => { if (colour.length > 1) framebuffer.cleared = colour; },
        drawArrays: () => draw({ program, bound, blocks, ...framebuffer })
    };
    return new Proxy(calls, {
        get: (own, name) => name in own                       ? own[name]
                            : /^[A-Z][A-Z0-9_]+$/.test(name)   ? constants.number(name)
                            : name === 'drawingBufferWidth'    ? width
                            : name === 'drawingBufferHeight'   ? height
                                                               : () => null
    });
}

/* ---- >>texts ----------------------------------------------------------------------------------------------------- */

/* std140: a type's alignment, its columns and their components, in words. */
const layout = { float: [ 1, 1, 1 ], int: [ 1, 1, 1 ], uint: [ 1, 1, 1 ], bool: [ 1, 1, 1 ], vec2: [ 2, 1, 2 ],
                 vec3: [ 4, 1, 3 ], vec4: [ 4, 1, 4 ], mat3: [ 4, 3, 3 ], mat4: [ 4, 4, 4 ] };

/* The members of a block with their values; its text with plain uniforms. */
function plain(text, values, bytesOf) {
    return text.replace(/(?:layout\( std140 \) )?uniform (\w+) \{([^}]*)\};/g, (all, block, members) => {
        const bytes = bytesOf(block), view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
        let at = 0;
        return members.replace(/(\w+) (\w+)(?:\[(\d+)\])?;/g, (member, type, name, length) => {
            const [align, columns, components] = layout[type], read = type === 'uint' ? 'getUint32' : 'getFloat32',
                  stride = length || columns > 1 ? 4 : 0, list = [];
            at = Math.ceil(at / (stride || align)) * (stride || align);
            for (let k = 0; k < columns * (length ?? 1); ++k, at += stride)
                for (let c = 0; c < components; ++c) list.push(view[read](4 * (at + c), true));
            if (!stride) at += components;
            values.set(name, list);
            return `uniform ${member}`;
        });
    });
}

const bare = text => text.replace(/^(#version|precision) .*$/gm, '');

/* The quad's texture coordinates come from its vertices, whose positions the text has. */
const vertexOf = text => `${bare(text).replace(/layout\( location = 0 \) in vec2 uv;/, 'vec2 uv;')
    .replace('void main()', 'void peer_main()')}
void main() {
    uv = vec2(gl_VertexID == 2 ? 2.0 : 0.0, gl_VertexID == 0 ? -1.0 : 1.0);
    peer_main();
}
`;

/* Outputs of fewer components are written as four. */
function fragmentOf(text) {
    const swizzle = { float: 'x', vec2: 'xy', vec3: 'xyz', vec4: 'xyzw' };
    return bare(text).replace(/layout\( location = (\d) \) out (\w+) (\w+);/g, (all, n, type, name) =>
        `layout(location = ${n}) out highp vec4 peer_color${n};\n#define ${name} peer_color${n}.${swizzle[type]}`)
        + '\n#define gl_FragColor peer_color0\n';
}

/* ---- >>effects --------------------------------------------------------------------------------------------------- */

/* Draws ambient visibility by gtao or ssgi, whose members set has, then their denoiser, whose members filter has.
   told: of each pass, { vertex, fragment, cleared, targets, value: of the uniform of a name }. A texture is { format:
   its name, width, height, data, parameters by their names }, and input: depth, normal or picture where it is the
   caller's. */
export async function tsl_draw({ width, height, near, far, projection }, effect, set, filter, told) {
    const inputs = new Map();
    let result;
    const draw = ({ program, bound, blocks, targets, cleared }) => {
        const values = new Map(), text = program.text,
              bytesOf = name => blocks[program.binding[program.blocks.indexOf(name)]].bytes;
        const vertex = vertexOf(plain(text.VERTEX_SHADER, values, bytesOf)),
              fragment = fragmentOf(plain(text.FRAGMENT_SHADER, values, bytesOf));
        told({ vertex, fragment, cleared: cleared?.slice(0, 3), targets,
               value: name => values.get(name) ?? bound[program.units.get(name)] });
        result = targets[0];
    };
    const gl = contextOf(width, height, draw),
          canvas = { width, height, style: {}, getContext: () => gl, addEventListener() {}, removeEventListener() {},
                     setAttribute() {} },
          renderer = new THREE.WebGPURenderer({ canvas, context: gl, forceWebGL: true, antialias: false });
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
        renderer.setRenderTarget(of);
        renderer.clear();
        const texture = name === 'depth' ? of.depthTexture : of.texture;
        inputs.set(renderer.backend.get(texture).textureGPU, name);
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
    for (const [texture, name] of inputs) texture.input = name;
    new THREE.QuadMesh(material).render(renderer);
    return result;
}
