/* exr.mjs - writes a float image as an uncompressed OpenEXR file, which build/render --gbuffer reads. */

/* Returns the file. channels: { name: Float32Array of width * height }, bottom row first. attributes: { name: a number,
   or a matrix's 16, in doubles as a Float64Array }: those of the header that are not required. */
export function exr(width, height, channels, { screenWindowWidth = 1, ...attributes } = {}) {
    const names = Object.keys(channels).sort(), bytes = [], text = new TextEncoder();
    const word = (...values) => values.forEach(v => bytes.push(v & 255, v >> 8 & 255, v >> 16 & 255, v >> 24 & 255));
    const float = v => bytes.push(...new Uint8Array(new Float32Array([v]).buffer));
    const string = s => bytes.push(...text.encode(s), 0);
    const attribute = (name, type, size) => { string(name); string(type); word(size); };
    word(20000630, 2);
    attribute('channels', 'chlist', 1 + names.reduce((sum, name) => sum + name.length + 17, 0));
    for (const name of names) { string(name); word(2, 0, 1, 1); }      /* a channel's type: float, one sample a pixel */
    bytes.push(0);
    attribute('compression', 'compression', 1);
    bytes.push(0);
    for (const window of ['dataWindow', 'displayWindow']) {
        attribute(window, 'box2i', 16);
        word(0, 0, width - 1, height - 1);
    }
    attribute('lineOrder', 'lineOrder', 1);
    bytes.push(0);
    attribute('pixelAspectRatio', 'float', 4);
    float(1);
    attribute('screenWindowCenter', 'v2f', 8);
    float(0);
    float(0);
    attribute('screenWindowWidth', 'float', 4);
    float(screenWindowWidth);
    for (const [name, value] of Object.entries(attributes)) {
        const values = value instanceof Float64Array ? value : new Float32Array([value].flat());
        const type = values.length < 16 ? 'float' : values instanceof Float64Array ? 'm44d' : 'm44f';
        attribute(name, type, values.byteLength);
        bytes.push(...new Uint8Array(values.buffer));
    }
    bytes.push(0);
    const head = bytes.length + 8 * height, row = 4 * width * names.length;
    const file = new Uint8Array(head + (row + 8) * height), view = new DataView(file.buffer);
    file.set(bytes);
    for (let y = 0; y < height; ++y) {
        const at = head + y * (row + 8);
        view.setUint32(bytes.length + 8 * y, at, true);    /* the upper half of the offset is 0: files are below 4 GB */
        view.setInt32(at, y, true);
        view.setInt32(at + 4, row, true);
        names.forEach((name, c) => file.set(new Uint8Array(
            channels[name].slice((height - 1 - y) * width, (height - y) * width).buffer), at + 8 + 4 * width * c));
    }
    return file;
}
