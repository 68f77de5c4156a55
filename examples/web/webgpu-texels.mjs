/* webgpu-texels.mjs - reads a texture of WebGPU. */

const pipelines = new WeakMap();                    /* of a device */

function pipelineOf(device) {
    const module = device.createShaderModule({ code: `
        @group(0) @binding(0) var picture: texture_2d<f32>;
        @vertex fn all(@builtin(vertex_index) v: u32) -> @builtin(position) vec4f {
            return vec4f(f32(v & 1) * 4 - 1, f32(v >> 1) * 4 - 1, 0, 1); }
        @fragment fn texel(@builtin(position) p: vec4f) -> @location(0) vec4f {
            return textureLoad(picture, vec2u(p.xy), 0); }
        ` });
    const layout = device.createBindGroupLayout({ entries: [
        { binding: 0, visibility: 2, texture: { sampleType: 'unfilterable-float' } }] });
    return { layout, pipeline: device.createRenderPipeline({
        layout: device.createPipelineLayout({ bindGroupLayouts: [layout] }),
        vertex: { module }, fragment: { module, targets: [{ format: 'rgba32float' }] } }) };
}

/* A promise of its texels, four floats each, the first row first. */
export async function texelsOf(device, texture) {
    const { width, height } = texture, bytesPerRow = Math.ceil(width / 16) * 256;
    if (!pipelines.has(device)) pipelines.set(device, pipelineOf(device));
    const { layout, pipeline } = pipelines.get(device), encoder = device.createCommandEncoder();
    const floats = device.createTexture({ size: [width, height], format: 'rgba32float', usage: 1 | 16 });
    const buffer = device.createBuffer({ size: bytesPerRow * height, usage: 1 | 8 });
    const pass = encoder.beginRenderPass({ colorAttachments: [
        { view: floats.createView(), loadOp: 'clear', storeOp: 'store' }] });
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, device.createBindGroup({ layout, entries: [
        { binding: 0, resource: texture.createView() }] }));
    pass.draw(3);
    pass.end();
    encoder.copyTextureToBuffer({ texture: floats }, { buffer, bytesPerRow }, [width, height]);
    device.queue.submit([encoder.finish()]);
    await buffer.mapAsync(1);
    const all = new Float32Array(buffer.getMappedRange()), got = new Float32Array(4 * width * height);
    for (let y = 0, from = 0; y < height; ++y, from += bytesPerRow / 4)
        got.set(all.subarray(from, from + 4 * width), 4 * y * width);
    buffer.destroy();
    floats.destroy();
    return got;
}
