/* webgpu-texels.mjs - reads a texture of WebGPU. */
import { drawTriangle } from './webgpu-triangle.mjs';

const text = `
@group(0) @binding(0) var picture: texture_2d<f32>;
@fragment fn texel(@builtin(position) p: vec4f) -> @location(0) vec4f {
    return textureLoad(picture, vec2u(p.xy), 0); }`;

/* Returns a promise of a texture's texels, four floats each, the first row first. */
export async function texelsOf(device, texture) {
    const { width, height } = texture, bytesPerRow = Math.ceil(width / 16) * 256, format = 'rgba32float';
    const encoder = device.createCommandEncoder();
    const floats = device.createTexture({ size: [width, height], format, usage: 1 | 16 });
    const buffer = device.createBuffer({ size: bytesPerRow * height, usage: 1 | 8 });
    drawTriangle(device, encoder, text, { view: floats.createView(), format }, [texture.createView()]);
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
