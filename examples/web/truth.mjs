/* truth.mjs - the traced truth of the picture as it grows: gives workers their rows, gathers their sums, scores. */

export class Truth {
    #workers = []; #id = 0; #job = null;
    rays = 0;                                       /* of each pixel at least */
    rows = 0;                                       /* share of those that have some */

    constructor(changed) {
        this.changed = changed;
    }

    /* position, normal: nine numbers a triangle. */
    scene({ position, normal }) {
        this.stop();
        if (!this.#workers.length)
            for (let i = 0, n = Math.min(4, Math.max(1, (navigator.hardwareConcurrency ?? 2) - 1)); i < n; ++i) {
                const worker = new Worker(new URL('tracer.mjs', import.meta.url), { type: 'module' });
                worker.onmessage = ({ data }) => this.#hear(worker, data);
                worker.onerror = e => this.changed(new Error(`the tracer failed: ${e.message}`));
                this.#workers.push(worker);
            }
        this.#workers.forEach(w => w.postMessage({ scene: { position, normal } }));
    }

    start(job) {
        const { width, height } = job;
        this.stop();
        this.#job = { ...job, id: ++this.#id };
        this.width = width;
        this.height = height;
        this.sums = [new Float32Array(4 * width * height), new Float32Array(4 * width * height)];
        this.count = new Uint16Array(height);       /* rays of each row's pixels, both halves */
        this.#send(this.#workers);
    }
    #send(workers) {
        if (this.#job) workers.forEach(w => w.postMessage({ job: { ...this.#job, first: this.#workers.indexOf(w),
                                                                   every: this.#workers.length } }));
    }

    stop() {
        this.#job = null;
        this.rays = this.rows = 0;
        this.#workers.forEach(w => w.postMessage({}));
    }
    get busy() { return this.#job !== null; }

    #hear(worker, data) {
        if (data.error) return this.changed(new Error(`the truth: ${data.error}`));
        if (data.ready) return this.#send([worker]);
        if (!this.#job || data.id !== this.#job.id) return;
        const { width, height } = this;
        const rows = data.done ?? Array.from({ length: data.sums[0].length / (4 * width) }, (_, r) => r);
        for (const r of rows) {
            const y = data.first + r * data.every;
            this.count[y] = data.rays;
            for (let h = 0; h < 2; ++h)
                this.sums[h].set(data.sums[h].subarray(4 * width * r, 4 * width * (r + 1)), 4 * width * y);
        }
        this.rays = this.count.reduce((least, n) => Math.min(least, n), 65535);
        this.rows = this.count.reduce((sum, n) => sum + (n > 0), 0) / height;
        this.changed(null);
    }

    /* For a texture: light in rgb, visibility in a; a is -1 where nothing is known. */
    texels() {
        const { width, height, sums: [a, b], count } = this, out = new Float32Array(4 * width * height);
        for (let y = 0, i = 0; y < height; ++y)
            for (let x = 0; x < 4 * width; ++x, ++i)
                out[i] = count[y] ? (a[i] + b[i]) / count[y] : x % 4 === 3 ? -1 : 0;
        return out;
    }

    /* Root of the mean square error of a result over the pixels that show something, or null. components 1: ambient
       visibility; 3: light, first three of four. */
    rmse(result, components) {
        const { width, height, sums: [a, b], count } = this, stride = components === 1 ? 1 : 4;
        let sum = 0, n = 0;
        for (let y = 0; y < height; ++y) {
            if (!count[y]) return null;
            const k = 2 / count[y];
            for (let x = 0, i = y * width; x < width; ++x, ++i) {
                if (!a[4 * i + 3] && !b[4 * i + 3]) continue;
                for (let c = 0; c < components; ++c) {
                    const at = 4 * i + (components === 1 ? 3 : c), m = result[stride * i + c];
                    sum += (m - a[at] * k) * (m - b[at] * k);
                }
                n += components;
            }
        }
        return n ? Math.sqrt(Math.max(0, sum / n)) : null;
    }
}
