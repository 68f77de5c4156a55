/* surfels.mjs - the surfels of deep screen space, which a worker makes of the scene for a camera. Until those of a new
   view are ready, the last ones are drawn at their places in the world. */
import { Matrix4 } from 'three';

/* Transforms positions and normals of count surfels from one view space into another. */
function turned(out, from, first, count, { elements: m }) {
    for (let i = 12 * first, end = 12 * (first + count); i < end; i += 12)
        for (let k = 0; k < 3; ++k) {
            out[i + k] = m[k] * from[i] + m[4 + k] * from[i + 1] + m[8 + k] * from[i + 2] + m[12 + k];
            out[i + 4 + k] = m[k] * from[i + 4] + m[4 + k] * from[i + 5] + m[8 + k] * from[i + 6];
        }
}

export class Surfels {
    #worker = null; #scene = null; #mover = null; #id = 0; #asked = ''; #next = null;
    #made = null;                                   /* { surfels, counts, views, scene } */
    #buffer = null; #array = null; #held = '';      /* #held: the view for which the buffer has surfels */
    busy = false;

    /* given: { gl, ssgi, changed, loading }. changed(error or null): called when other surfels are there */
    constructor(given) { Object.assign(this, given); }

    /* Returns whether there are surfels of the shown scene. */
    ready({ stage }) { return this.#made?.scene === stage.info; }

    /* Asks for the surfels of a view with these settings, unless they are there or being made. */
    want({ stage, now, size, radius }) {
        const { width, height, projection } = now, views = this.#views(stage, now).map(v => v && v.toArray());
        const look = { projection, width, height, size, reach: radius, views };
        const key = JSON.stringify([look, stage.info.key]);
        this.#send(stage);
        if (key === this.#asked) return;
        this.#asked = key;
        this.#next = { look, scene: stage.info };
        this.#ask();
    }

    /* Returns the matrices to view space: of the scene, and of the moving object or null. */
    #views(stage, { toView }) {
        const view = new Matrix4().fromArray(toView);
        return [view, stage.mover && view.clone().multiply(stage.mover.now)];
    }

    #send(stage) {
        const part = (k, { position, normal }) => this.#worker.postMessage(
            { part: k, position, normal }, [position.buffer, normal.buffer]);
        if (!this.#worker) {
            this.#worker = new Worker(new URL('baker.mjs', import.meta.url), { type: 'module' });
            this.#worker.onmessage = ({ data }) => this.#hear(data);
            this.#worker.onerror = e => this.changed(new Error(`surfels: their worker failed: ${e.message}`));
        }
        if (this.#scene !== stage.info) part(0, stage.triangles());
        this.#scene = stage.info;
        if (stage.mover && this.#mover !== stage.mover.mesh) part(1, stage.moverTriangles());
        this.#mover = stage.mover?.mesh ?? this.#mover;
    }
    #ask() {
        if (this.busy || !this.#next) return;
        this.busy = true;
        const { look, scene } = this.#next;
        this.#next = null;
        if (this.#made?.scene !== scene) this.loading('Making surfels');
        this.now = { id: ++this.#id, views: look.views, scene };
        this.#worker.postMessage({ surfels: { ...look, projection: Float32Array.from(look.projection), id: this.#id,
                                              views: look.views.map(v => v && Float32Array.from(v)) } });
    }

    #hear({ id, surfels, counts, error }) {
        this.busy = false;
        if (this.#made?.scene !== this.now.scene) this.loading(null);
        if (error) { this.#asked = ''; this.changed(new Error(`surfels: ${error}`)); return; }
        if (id === this.now.id) {
            const views = this.now.views.map(v => v && new Matrix4().fromArray(v));
            this.#made = { surfels, counts, views, scene: this.now.scene };
            this.#held = '';
            this.changed(null);
        }
        this.#ask();
    }

    /* Returns the inputs for Run.draw: the surfels' vertex array, in this view's space. */
    given({ stage, now }, steps) {
        const { gl } = this, views = this.#views(stage, now), { surfels, counts, views: made } = this.#made;
        const key = JSON.stringify(views.map(v => v?.elements));
        let count = counts[0] + (views[1] ? counts[1] ?? 0 : 0);
        if (!made[1]) count = counts[0];
        if (!this.#array) this.#open(steps.find(({ desc }) => desc.pass === 'DSS').desc);
        if (key !== this.#held) {
            let all = surfels, first = 0;
            if (views.some((view, k) => view && made[k] && !view.equals(made[k]))) {
                all = surfels.slice();
                views.forEach((view, k) => {
                    if (view && made[k])
                        turned(all, surfels, first, counts[k], view.clone().multiply(made[k].clone().invert()));
                    first += counts[k] ?? 0;
                });
            }
            gl.bindBuffer(gl.ARRAY_BUFFER, this.#buffer);
            gl.bufferData(gl.ARRAY_BUFFER, all, gl.DYNAMIC_DRAW);
            this.#held = key;
        }
        return { array: this.#array, instances: count };
    }

    /* Opens a vertex array with three vec4 for each instance, at the splat shader's locations. */
    #open(desc) {
        const { gl } = this;
        this.#buffer = gl.createBuffer();
        this.#array = gl.createVertexArray();
        gl.bindVertexArray(this.#array);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.#buffer);
        this.ssgi.rows(desc).filter(({ kind }) => kind === 'ATTRIBUTE').forEach(({ slot }, i) => {
            gl.enableVertexAttribArray(slot);
            gl.vertexAttribPointer(slot, 4, gl.FLOAT, false, 48, 16 * i);
            gl.vertexAttribDivisor(slot, 1);
        });
        gl.bindVertexArray(null);
    }
}
