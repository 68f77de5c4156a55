/* finishes.mjs - textures of surfaces in the page's own scenes. They are drawn here, so that none need be fetched. The
   albedo is the scene's colour times the texture. scenes.c has their numbers, from 1 on. */
import * as THREE from 'three';

const size = 512;

/* [metres that the texture spans, or 0: the whole face; draw(context, random number from 0 to 1)] */
const kinds = [
    [1.2, planks], [1.6, plaster], [0.8, wood], [0, rug], [0, landscape], [1.2, flagstones], [1.6, blocks]
];
const grey = (v, opacity = 1) => `rgb(${[v, v, v].map(c => Math.round(255 * c)).join(' ')} / ${opacity})`;

function fill(on, colour, x = 0, y = 0, width = size, height = size) {
    on.fillStyle = colour;
    on.fillRect(x, y, width, height);
}
function speckle(on, random, count, width, height, opacity) {
    for (let i = 0; i < count; ++i)
        fill(on, grey(random() < 0.5 ? 0.3 : 1, opacity * random()), size * random(), size * random(),
             width * (0.4 + random()), height * (0.4 + random()));
}
function planks(on, random) {
    const rows = 8, high = size / rows;
    for (let row = 0; row < rows; ++row)
        for (let half = 0, x = -size * random() / 2; half < 3; ++half, x += size / 2) {
            fill(on, grey(0.72 + 0.26 * random()), x, row * high, size / 2, high);
            fill(on, grey(0.12), x, row * high, 2, high);
        }
    speckle(on, random, 3000, 70, 1.2, 0.16);
    for (let row = 0; row < rows; ++row) fill(on, grey(0.12), 0, row * high, size, 2);
}
function plaster(on, random) {
    fill(on, grey(0.94));
    speckle(on, random, 6000, 5, 5, 0.07);
}
function wood(on, random) {
    fill(on, grey(0.86));
    speckle(on, random, 2600, 160, 1.6, 0.2);
}
function rug(on, random) {
    fill(on, '#e9d2b4');
    for (const [edge, colour] of [[16, '#f4f4f4'], [52, '#7f86a8'], [64, '#f4f4f4'], [76, '#ffffff']])
        fill(on, colour, edge, edge, size - 2 * edge, size - 2 * edge);
    for (let y = 0; y < 6; ++y)
        for (let x = 0; x < 6; ++x)
            for (const [wide, colour] of [[26, '#8f6f5a'], [18, '#f0d9a8'], [9, '#6f7fb0']]) {
                on.fillStyle = colour;
                on.beginPath();
                const [cx, cy] = [x, y].map(i => 106 + 60 * i);
                [[1, 0], [0, 1], [-1, 0], [0, -1]].forEach(([i, j]) => on.lineTo(cx + i * wide, cy + j * wide));
                on.fill();
            }
    speckle(on, random, 9000, 4, 2, 0.16);
}
function landscape(on, random) {
    const sky = on.createLinearGradient(0, 0, 0, size);
    [[0, '#4f79a8'], [0.45, '#f2c79a'], [0.6, '#ffe9c4']].forEach(([at, colour]) => sky.addColorStop(at, colour));
    fill(on, sky);
    for (const [at, high, colour] of [[0.52, 70, '#8fa0b0'], [0.64, 50, '#6f8f6a'], [0.8, 36, '#4f6f40']]) {
        const phase = 6 * random();
        on.fillStyle = colour;
        on.beginPath();
        on.moveTo(0, size);
        for (let x = 0; x <= size; x += 8)
            on.lineTo(x, size * at - high * (Math.sin(x / 90 + phase) + 0.4 * Math.sin(x / 31 + 2 * phase)));
        on.lineTo(size, size);
        on.fill();
    }
}
function flagstones(on, random) {
    fill(on, grey(0.55));
    for (let y = 0; y < 2; ++y)
        for (let x = 0; x < 2; ++x)
            fill(on, grey(0.82 + 0.16 * random()), 256 * x + 2, 256 * y + 2, 252, 252);
    speckle(on, random, 5000, 9, 6, 0.1);
}
function blocks(on, random) {
    fill(on, grey(0.6));
    for (let row = 0; row < 4; ++row)
        for (let i = 0; i < 3; ++i)
            fill(on, grey(0.8 + 0.2 * random()), 256 * i - 128 * (row & 1) + 2, 128 * row + 2, 252, 124);
    speckle(on, random, 5000, 8, 6, 0.1);
}

/* Makes the texture of a number. span: the metres that it covers, or 0: the whole face. */
export function finish(number) {
    const [span, draw] = kinds[number - 1], canvas = new OffscreenCanvas(size, size);
    let state = number;
    draw(canvas.getContext('2d'), () => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 4294967296);
    const map = new THREE.CanvasTexture(canvas);
    map.wrapS = map.wrapT = THREE.RepeatWrapping;
    map.colorSpace = THREE.SRGBColorSpace;
    map.anisotropy = 4;
    return { span, map };
}

/* Returns the texture coordinates of a triangle's corners, three vectors. If two sides are at right angles, the axes
   follow these, u the longer one, so that grain runs along boards; else they follow the axes of the world. */
export function placesOf(corners, span) {
    const at = [0, 1, 2].map(i => [corners[(i + 1) % 3], corners[(i + 2) % 3]].map(c => c.clone().sub(corners[i])));
    const angle = ([a, b]) => Math.abs(a.dot(b)) / (a.length() * b.length()), square = [0, 1, 2].sort(
        (i, j) => angle(at[i]) - angle(at[j]))[0];
    let [across, up] = at[square].sort((a, b) => b.length() - a.length());
    /* returns whether a side points to the negative: the other triangle of a face has opposite sides */
    const back = way => way.toArray().reduce((most, v) => (Math.abs(v) > Math.abs(most) ? v : most), 0) < 0;
    if (!span)
        return corners.map(c => [across, up].map(way => {
            const share = c.clone().sub(corners[square]).dot(way) / way.lengthSq();
            return back(way) ? 1 - share : share;
        }));
    for (const way of [across, up]) if (back(way)) way.negate();
    if (angle([across, up]) > 0.01) {
        const normal = new THREE.Vector3().crossVectors(across, up), far = normal.toArray().map(Math.abs);
        const most = far.indexOf(Math.max(...far));
        [across, up] = [0, 1, 2].filter(k => k !== most).map(k => new THREE.Vector3().setComponent(k, 1));
    }
    return corners.map(c => [across, up].map(way => c.dot(way) / way.length() / span));
}
