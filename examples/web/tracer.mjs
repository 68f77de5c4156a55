/* tracer.mjs - a worker that ray-traces the ground truth of some rows of the image by ssgi.h's trace (WebAssembly).

   Each pixel's rays are of two halves, A and B, whose errors know nothing of each other: (m - A)(m - B), averaged, is
   the mean square error of m without that of the rays, be they ever so few. */
import { load } from './ssgi.mjs';
import { radianceOf, skies } from './sky.mjs';

let trace = null, normal = null, job = null;

/* Returns a number with well mixed bits [PCG, O'Neill 2014]. */
function hash(x) {
    x = (Math.imul(x, 747796405) + 2891336453) >>> 0;
    x = Math.imul((x >>> ((x >>> 28) + 4)) ^ x, 277803737) >>> 0;
    return ((x >>> 22) ^ x) >>> 0;
}

/* Finds the point that a camera ray sees, lifted off its face, and its shading normal on the visible side. */
function place(eye, way, origin, n) {
    const hit = trace.closest(eye, way, 0, 1e12);
    if (!hit) return false;
    const at = 9 * hit.triangle, w = 1 - hit.u - hit.v;
    const { corner } = job;
    let facing = 0, length = 0;
    const e = [0, 1, 2].map(i => corner[at + 3 + i] - corner[at + i]);
    const f = [0, 1, 2].map(i => corner[at + 6 + i] - corner[at + i]);
    const face = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
    const side = face[0] * way[0] + face[1] * way[1] + face[2] * way[2] > 0 ? -1 : 1, size = side / Math.hypot(...face);
    for (let i = 0; i < 3; ++i) {
        n[i] = normal[at + i] * w + normal[at + 3 + i] * hit.u + normal[at + 6 + i] * hit.v;
        length += n[i] * n[i];
        facing += n[i] * face[i] * side;
    }
    length = (facing < 0 ? -1 : 1) / (Math.sqrt(length) || 1);
    let far = 0;                                    /* the hit's rounding grows with these coordinates */
    for (let i = 0; i < 3; ++i)
        far = Math.max(far, Math.abs(eye[i]), Math.abs(way[i] * hit.t), Math.abs(eye[i] + way[i] * hit.t));
    for (let i = 0; i < 3; ++i) {
        n[i] *= length;
        origin[i] = eye[i] + way[i] * hit.t + face[i] * size * 4e-6 * far;
    }
    return true;
}

function begin() {
    const { width, height, first, every } = job, rows = Math.ceil((height - first) / every);
    job.rows = rows;
    job.origin = new Float64Array(3 * width * rows);
    job.n = new Float32Array(3 * width * rows).fill(NaN);
    job.lit = new Uint8Array(width * rows);          /* 1: the sun shines on the pixel */
    job.sums = [new Float32Array(4 * width * rows), new Float32Array(4 * width * rows)];
    job.taken = [new Float32Array(3 * width * rows), new Float32Array(3 * width * rows)];  /* light, by occluders */
    job.radiance = typeof job.sky === 'string' ? skies[job.sky].radiance : radianceOf(job.sky);
    job.order = spread(rows);
    job.done = 0;                                   /* number of rows in that order whose first rays were traced */
    job.round = 0;
}

/* Returns the rows in an order that soon has some everywhere: every 16th, then those between. */
function spread(rows) {
    const order = [];
    for (let step = 16; step; step >>= 1)
        for (let r = 0; r < rows; r += step) if (step === 16 || r / step & 1) order.push(r);
    return order;
}

/* Finds the points that a row's pixels show, and whether the sun reaches them. */
function look(r) {
    const { width, camera, first, every, step } = job, origin = [0, 0, 0], n = [0, 0, 0], way = [0, 0, 0];
    const middle = (step >> 1) + 0.5;
    for (let x = 0; x < width; ++x) {
        const sx = camera.ray[0] * (step * x + middle) + camera.ray[2];
        const sy = camera.ray[1] * (step * (first + r * every) + middle) + camera.ray[3];
        for (let i = 0; i < 3; ++i) way[i] = camera.world[i] * sx + camera.world[3 + i] * sy - camera.world[6 + i];
        if (!place(camera.eye, way, origin, n)) continue;
        job.origin.set(origin, 3 * (r * width + x));
        job.n.set(n, 3 * (r * width + x));
        if (job.sun && shines(origin, n, job.sun.toSun)) job.lit[r * width + x] = 1;
    }
}

/* Returns whether nothing is between a point and the sun, at any distance. */
function shines(origin, n, to) {
    return n[0] * to[0] + n[1] * to[1] + n[2] * to[2] > 0 && !trace.any(origin, to, 0, 1e12);
}

/* Traces one more ray from each pixel of some rows, and adds it to half A or B. */
function round(k, firstRow, rows) {
    const { width, first, every, radius, origin, n, radiance, lit, sun } = job;
    const half = k & 1, sums = job.sums[half], taken = job.taken[half], index = k >> 1;
    const from = [0, 0, 0], d = [0, 0, 0], light = [0, 0, 0];
    for (let i = width * firstRow; i < width * (firstRow + rows); ++i) {
        const nx = n[3 * i], ny = n[3 * i + 1], nz = n[3 * i + 2];
        if (nx !== nx) continue;
        const pixel = (first + Math.floor(i / width) * every) * width + i % width;
        const a = hash(2 * pixel + half), b = hash(a ^ 0x9e3779b9);
        const u = (a / 4294967296 + index * 0.7548776662466927) % 1;
        const v = (b / 4294967296 + index * 0.5698402909980532) % 1;
        const ring = Math.sqrt(u), turn = 2 * Math.PI * v, x = ring * Math.cos(turn), y = ring * Math.sin(turn);
        const z = Math.sqrt(1 - u), sign = nz < 0 ? -1 : 1, c = -1 / (sign + nz), m = nx * ny * c;
        d[0] = x * (1 + sign * nx * nx * c) + y * m + z * nx;
        d[1] = x * sign * m + y * (sign + ny * ny * c) + z * ny;
        d[2] = -x * sign * nx - y * ny + z * nz;
        from[0] = origin[3 * i];
        from[1] = origin[3 * i + 1];
        from[2] = origin[3 * i + 2];
        /* Not from 0: rays from a corner that rounding puts into the floor would all hit the floor. */
        const hit = trace.closest(from, d, 1e-4 * radius, radius), open = hit ? hit.t / radius : 1;
        radiance(d, light);
        const level = lit[i] ? (nx * sun.toSun[0] + ny * sun.toSun[1] + nz * sun.toSun[2]) / Math.PI : 0;
        for (let c = 0; c < 3; ++c) {
            sums[4 * i + c] += light[c] * open + (level && level * sun.irradiance[c]);
            taken[3 * i + c] += light[c] * (1 - open);
        }
        sums[4 * i + 3] += open;
    }
}

/* Returns the summed squared errors of no occlusion, each the product of the errors against halves A and B. */
function ofNone() {
    const { sums: [a, b], taken: [c, d], n, round: rays } = job, k = 2 / rays;
    let visibility = 0, light = 0, pixels = 0;
    for (let i = 0; i < n.length / 3; ++i) {
        if (!a[4 * i + 3] && !b[4 * i + 3]) continue;
        visibility += (1 - a[4 * i + 3] * k) * (1 - b[4 * i + 3] * k);
        for (let j = 3 * i; j < 3 * i + 3; ++j) light += c[j] * k * d[j] * k;
        ++pixels;
    }
    return { visibility, light, pixels };
}

let told = 0, begunAt = 0, working = false;
function work() {
    const mine = job;
    working = mine !== null;
    if (!mine) return;
    if (!mine.sums) begin();
    const begun = mine.done < mine.rows;
    if (begun) {                                    /* the first two rays row by row, so that an image is soon there */
        const until = performance.now() + 60;
        do {
            const r = mine.order[mine.done++];
            look(r);
            round(0, r, 1);
            round(1, r, 1);
        } while (mine.done < mine.rows && performance.now() < until);
        mine.round = 2;
    } else round(mine.round++, 0, mine.rows);
    const now = performance.now(), even = mine.round % 2 === 0, all = mine.done === mine.rows;
    const pause = all ? Math.max(400, (now - begunAt) / 8) : 200;   /* seldom if little changes: sending takes time */
    if (even && (now - told > pause || mine.round >= mine.most || (begun && all))) {
        told = now;
        const sums = mine.sums.map(s => s.slice());
        postMessage({ id: mine.id, first: mine.first, every: mine.every, rays: mine.round, sums,
                      none: ofNone(), done: all ? null : mine.order.slice(0, mine.done) }, sums.map(s => s.buffer));
    }
    if (mine.round >= mine.most && all) job = null;
    setTimeout(work);                               /* lets messages come first: another job, or none */
}

async function take(scene) {
    job = trace = null;
    const ssgi = await load();
    trace = ssgi.trace(scene.position);
    normal = scene.normal;
    self.corner = scene.position;
    postMessage({ ready: true });
}

onmessage = ({ data }) => {
    if (data.scene) take(data.scene).catch(e => postMessage({ error: e.message }));
    else if (data.job) {
        job = trace && data.job.first < data.job.height && { ...data.job, corner: self.corner } || null;
        told = 0;
        begunAt = performance.now();
        if (!working && job) work();
    } else job = null;
};
