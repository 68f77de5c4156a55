/* webgpu-triangle.mjs - draws a triangle that covers a texture of WebGPU, by a shader that reads other textures. */

const vertex = `
@vertex fn all(@builtin(vertex_index) v: u32) -> @builtin(position) vec4f {
    return vec4f(f32(v & 1) * 4 - 1, f32(v >> 1) * 4 - 1, 0, 1); }`;
const pipelines = new WeakMap();                    /* for each device, the pipelines by shader and target format */

function pipelineOf(device, code, format, blends) {
    const key = `${format} ${blends} ${code}`;
    if (!pipelines.has(device)) pipelines.set(device, new Map());
    const all = pipelines.get(device), by = { srcFactor: 'constant', dstFactor: 'one-minus-constant' };
    if (!all.has(key))
        all.set(key, device.createRenderPipeline({
            layout: 'auto', vertex: { module: device.createShaderModule({ code: vertex }) },
            fragment: { module: device.createShaderModule({ code }),
                        targets: [{ format, ...(blends && { blend: { color: by, alpha: by } }) }] } }));
    return all.get(key);
}

/* Draws the triangle. code: of the fragment shader; bound: its bindings' resources in order. mean: 0: replaces the
   content; n: makes it the mean of n images. */
export function drawTriangle(device, encoder, code, { view, format }, bound, mean = 0) {
    const pipeline = pipelineOf(device, code, format, mean > 1);
    const pass = encoder.beginRenderPass({ colorAttachments: [
        { view, loadOp: mean > 1 ? 'load' : 'clear', storeOp: 'store' }] });
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, device.createBindGroup({
        layout: pipeline.getBindGroupLayout(0), entries: bound.map((resource, binding) => ({ binding, resource })) }));
    if (mean > 1) pass.setBlendConstant([0, 1, 2, 3].map(() => 1 / mean));
    pass.draw(3);
    pass.end();
}
