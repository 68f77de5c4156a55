/* truth.mjs - the ray-traced ground truth as it is refined: gives rows to workers, adds their sums, scores.

   Every fourth pixel in both ways comes first, then every second, then all: a picture is there after a sixteenth of the
   rays, and an error of these pixels is one of the whole picture. What was traced stays until the finer is as good. */

/* steps: every 4th, 2nd, then each pixel of a row is traced; enough, good: rays that end a step, that show it */
const steps = [4, 2, 1], enough = 16, good = 8;
const smoothed = 64;                                /* with fewer rays a pixel the image is smoothed */

/* Returns the image's pixel column (or row) of the traced column (or row) i. */
const pixelAt = (step, i) => (step >> 1) + step * i;
const latticeSize = (step, size) => Math.floor((size - 1 - (step >> 1)) / step) + 1;

export class Truth {
    #workers = []; #id = 0; #job = null; #growing = null; #shown = null;

    /* changed(error, shown): called after an error, or when rays arrive; shown: whether the visible step got them. */
    constructor(changed) {
        this.changed = changed;
    }
    get rays() { return this.#shown?.rays ?? 0; }   /* the least number of rays over the image's pixels */
    get step() { return this.#shown?.step ?? 0; }   /* pixels between its pixels */
    get width() { return this.#shown?.width ?? 0; }
    get height() { return this.#shown?.height ?? 0; }
    get rough() { return this.step > 1 || this.rays < smoothed; }
    /* Returns the finished share, 0 to 1; it grows with the logarithm of rays, because later rays change less. */
    get share() {
        if (!this.#growing) return 0;
        const { step, rays, rows } = this.#growing, done = steps.indexOf(step);
        return (done + (step > 1 ? Math.min(1, (rows + rays) / (1 + enough))
            : rays ? Math.log2(1 + rays) / Math.log2(1 + this.#job.most) : 0)) / steps.length;
    }

    /* Sends a scene to the workers. position, normal: nine numbers a triangle. */
    scene({ position, normal }) {
        this.stop();
        if (!this.#workers.length)
            for (let i = 0, n = Math.min(16, Math.max(1, (navigator.hardwareConcurrency ?? 2) - 1)); i < n; ++i) {
                const worker = new Worker(new URL('tracer.mjs', import.meta.url), { type: 'module' });
                worker.onmessage = ({ data }) => this.#hear(i, data);
                worker.onerror = e => this.changed(new Error(`the tracer failed: ${e.message}`));
                this.#workers.push(worker);
            }
        this.#workers.forEach(w => w.postMessage({ scene: { position, normal } }));
    }

    /* Begins a ground truth. job: width, height of the image, camera, sky, sun, radius, most: rays a pixel in all. */
    start(job) {
        this.stop();
        this.#job = job;
        this.#grow(steps[0]);
    }
    #grow(step) {
        const width = latticeSize(step, this.#job.width), height = latticeSize(step, this.#job.height);
        this.#growing = { id: ++this.#id, step, width, height, rays: 0, rows: 0, none: [],
                          count: new Uint16Array(height),
                          sums: [0, 1].map(() => new Float32Array(4 * width * height)) };
        this.#workers.forEach((_, i) => this.#send(i));
    }
    #send(i) {
        if (!this.#growing) return;
        const { id, step, width, height } = this.#growing, most = step > 1 ? enough : this.#job.most;
        this.#workers[i].postMessage({ job: { ...this.#job, id, step, width, height, most, first: i,
                                              every: this.#workers.length } });
    }

    stop() {
        this.#job = this.#growing = this.#shown = null;
        this.#workers.forEach(w => w.postMessage({}));
    }

    #hear(i, data) {
        if (data.error) return this.changed(new Error(`the truth: ${data.error}`));
        if (data.ready) return this.#send(i);
        const of = this.#growing;
        if (!of || data.id !== of.id) return;
        const { width, height, step } = of;
        const rows = data.done ?? Array.from({ length: data.sums[0].length / (4 * width) }, (_, r) => r);
        for (const r of rows) {
            const y = data.first + r * data.every;
            of.count[y] = data.rays;
            for (let h = 0; h < 2; ++h)
                of.sums[h].set(data.sums[h].subarray(4 * width * r, 4 * width * (r + 1)), 4 * width * y);
        }
        of.none[i] = data.none;
        of.rays = of.count.reduce((least, n) => Math.min(least, n), 65535);
        of.rows = of.count.reduce((sum, n) => sum + (n > 0), 0) / height;
        if (!this.#shown || this.#shown === of || of.rays >= good) this.#shown = of;
        if (step > 1 && of.rays >= enough) this.#grow(steps[steps.indexOf(step) + 1]);
        this.changed(null, this.#shown === of);
    }

    /* Returns a texture's texels: light in rgb, visibility in a; a is -1 for pixels without rays. */
    texels() {
        const { width, height, sums: [a, b], count } = this.#shown, out = new Float32Array(4 * width * height);
        for (let y = 0, i = 0; y < height; ++y)
            for (let x = 0; x < 4 * width; ++x, ++i)
                out[i] = count[y] ? (a[i] + b[i]) / count[y] : x % 4 === 3 ? -1 : 0;
        return out;
    }

    /* Compares a result of the image's size with it. rmse: root of the mean square error over the pixels that show a
       surface; none: that of no occlusion; worst: { x, y, off } of the pixel, left of column `until`, whose error most
       exceeds twice its standard deviation by the rays. null: a pixel has no rays yet. components 1: ambient
       visibility; 3: light, the first three of four. */
    score(result, components, pictureWidth, until) {
        const { width, height, sums: [a, b], count, step, rays, none } = this.#shown ?? {}, four = components > 1;
        let sum = 0, n = 0, most = 0, worst = null;
        if (!rays) return null;
        for (let y = 0; y < height; ++y) {
            const k = 2 / count[y], line = pixelAt(step, y);
            for (let x = 0, i = y * width; x < width; ++x, ++i) {
                if (!a[4 * i + 3] && !b[4 * i + 3]) continue;
                const column = pixelAt(step, x), at = (line * pictureWidth + column) * (four ? 4 : 1);
                let off = 0;
                for (let c = 0; c < components; ++c) {
                    const from = 4 * i + (four ? c : 3), m = result[at + c];
                    sum += (m - a[from] * k) * (m - b[from] * k);
                    off += (m - (a[from] + b[from]) * k / 2) / components;
                }
                n += components;
                const seen = (a[4 * i + 3] + b[4 * i + 3]) * k / 2;
                const sure = Math.abs(off) - 2 * Math.sqrt(seen * (1 - seen) / count[y]);
                if (sure > most && column < until) {
                    most = sure;
                    worst = { x: column, y: line, off };
                }
            }
        }
        const [of, all] = none.reduce(([s, m], { light, visibility, pixels }) =>
            [s + (four ? light : visibility), m + pixels * components], [0, 0]);
        const root = (s, m) => (m ? Math.sqrt(Math.max(0, s / m)) : null);
        return n ? { rmse: root(sum, n), none: root(of, all), worst } : null;
    }

    /* Returns visibility and light of the pixel, or of the nearest traced one, and the standard deviation of visibility
       at most; null: it has no rays, or shows no surface. */
    at(x, y) {
        const { width, height, sums: [a, b] = [], count, step } = this.#shown ?? {};
        if (!count) return null;
        const near = (v, size) => Math.min(size - 1, Math.max(0, Math.round((v - (step >> 1)) / step)));
        const row = near(y, height), i = 4 * (row * width + near(x, width)), n = count[row];
        const [red, green, blue, visibility] = [0, 1, 2, 3].map(c => (a[i + c] + b[i + c]) / n);
        return visibility ? { visibility, light: [red, green, blue], off: Math.sqrt(visibility * (1 - visibility) / n) }
            : null;
    }
}
