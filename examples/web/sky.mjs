/* sky.mjs - functions that return the radiance of a direction, for the built-in environments of build/render --env. */

const degree = Math.PI / 180;

/* Returns the weight of a glow: 1 in the middle, 1/2 at its half sizes, 0 from 1.4 of them on. */
function glowAt([longitude, latitude, wide, high, power], [x, y, z]) {
    const lon = longitude * degree, lat = latitude * degree, level = x * Math.sin(lon) + z * Math.cos(lon);
    const depth = level * Math.cos(lat) + y * Math.sin(lat);
    if (depth <= 0) return 0;
    const across = Math.atan2(x * Math.cos(lon) - z * Math.sin(lon), depth);
    const up = Math.atan2(y * Math.cos(lat) - level * Math.sin(lat), depth);
    const off = (Math.abs(across / degree / wide) ** power + Math.abs(up / degree / high) ** power) ** (1 / power);
    const t = Math.min(1, Math.max(0, (1.4 - off) / 0.8));
    return t * t * (3 - 2 * t);
}

const windows = [
    [64, 16, 8, 19, 8, 9.0, 11.5, 15.0], [90, 16, 8, 19, 8, 9.5, 12.0, 15.5], [116, 16, 8, 19, 8, 9.0, 11.5, 15.0],
    [-82, 12, 17, 11, 8, 5.2, 4.6, 3.6], [-128, -40, 11, 7, 6, 7.5, 6.4, 4.6], [10, 74, 5, 5, 2, 14, 10.5, 7]
];

/* Functions that write the radiance of a unit direction to out. */
export const skies = {
    __proto__: null,
    sky: { title: 'Clear sky', radiance([x, y, z], out) {
        const off = 1 - (x * 0.5792280 + y * 0.5735764 + z * 0.5792280);
        const high = 1 - (1 - Math.max(0, y)) ** 3, nearSun = 2 ** (-off / 0.0603074);
        const t = Math.min(1, Math.max(0, 1 + y / 0.1)), above = t * t * (3 - 2 * t);
        const zenith = [0.38, 0.66, 1.28], horizon = [1.20, 1.32, 1.42], glow = [4.4, 3.1, 1.6];
        const ground = [0.24, 0.17, 0.11];
        for (let c = 0; c < 3; ++c)
            out[c] = ground[c] + above * (horizon[c] + high * (zenith[c] - horizon[c]) + nearSun * glow[c] - ground[c]);
    } },
    windows: { title: 'Windows of a room', radiance(d, out) {
        const low = [0.26, 0.19, 0.13], high = [0.62, 0.58, 0.52], t = 0.5 + 0.5 * d[1];
        for (let c = 0; c < 3; ++c) out[c] = low[c] + t * (high[c] - low[c]);
        for (const glow of windows) {
            const is = glowAt(glow, d);
            for (let c = 0; c < 3 && is > 0; ++c) out[c] += is * glow[5 + c];
        }
        for (let c = 0; c < 3; ++c) out[c] /= 1.21445;
    } },
    white: { title: 'White', radiance(d, out) { out[0] = out[1] = out[2] = 1; } }
};

/* Returns a function that looks up the texel of { rgb, width, height } in a direction, without interpolation. */
export function radianceOf({ rgb, width, height }) {
    return ([x, y, z], out) => {
        const column = Math.floor((0.5 - Math.atan2(x, z) / (2 * Math.PI)) * width);
        const row = Math.floor(Math.acos(Math.min(1, Math.max(-1, y))) / Math.PI * height);
        const at = 3 * (Math.min(height - 1, row) * width + Math.min(width - 1, Math.max(0, column)));
        for (let c = 0; c < 3; ++c) out[c] = rgb[at + c];
    };
}

/* Shrinks an image of rgba, top row first, so far that a few directions sample all of its light, and scales its mean to
   1, because the exposure of photographs varies. */
export function skyOf(rgba, from, width, height) {
    const rgb = new Float32Array(3 * width * height);
    const range = (i, n, of) => [Math.floor(i * of / n), Math.max(Math.floor((i + 1) * of / n),
                                                                  Math.floor(i * of / n) + 1)];
    for (let i = 0; i < width * height; ++i) {
        const [left, right] = range(i % width, width, from.width);
        const [top, bottom] = range(Math.floor(i / width), height, from.height);
        for (let y = top; y < bottom; ++y)
            for (let x = left; x < right; ++x)
                for (let c = 0; c < 3; ++c) {
                    const v = rgba[4 * (y * from.width + x) + c];
                    if (!Number.isFinite(v)) throw new Error(`texel ${x}, ${y} is ${v}; must be finite`);
                    /* resampling leaves some values a little below 0 */
                    rgb[3 * i + c] += Math.max(0, v) / ((right - left) * (bottom - top));
                }
    }
    let sum = 0, weights = 0;
    for (let i = 0; i < width * height; ++i) {
        const weight = Math.sin((Math.floor(i / width) + 0.5) / height * Math.PI);
        for (let c = 0; c < 3; ++c) sum += weight * rgb[3 * i + c];
        weights += 3 * weight;
    }
    if (!(sum > 0)) throw new Error('is black; must send light');
    return { rgb: rgb.map(v => v * weights / sum), width, height };
}

/* Returns a built-in environment as a latitude-longitude image: +y up, its centre toward +z, +x left of that. */
export function equirect(name, width, height) {
    const rgb = new Float32Array(3 * width * height), d = [0, 0, 0], out = [0, 0, 0];
    for (let y = 0; y < height; ++y)
        for (let x = 0; x < width; ++x) {
            const lon = Math.PI - 2 * Math.PI * (x + 0.5) / width, lat = Math.PI * (0.5 - (y + 0.5) / height);
            d[0] = Math.sin(lon) * Math.cos(lat);
            d[1] = Math.sin(lat);
            d[2] = Math.cos(lon) * Math.cos(lat);
            skies[name].radiance(d, out);
            rgb.set(out, 3 * (y * width + x));
        }
    return rgb;
}
