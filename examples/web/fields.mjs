/* fields.mjs - ambient occlusion fields of the scene's objects: of the moving object, or of the visitor's model on its
   ground. A worker bakes them, first a coarse one, so that something is soon seen; they are drawn where the object is
   now. */
import { Matrix4 } from 'three';

const coarse = { resolution: 8, rays: 64 };
const most = 2;                                     /* objects at most, numbered as in the G-buffer */

export class Fields {
    #worker = null; #id = 0; #baking = null;
    static #baked = new Map();                            /* ssgi.field() by #key: the object and its fineness */
    static #failed = new Set();                     /* keys of objects whose bake failed */
    #shown = []; #slices = null; #rows = null;      /* [{ object, field }]; textures */

    /* given: { gl, drawer, ssgi, changed, loading }. changed(error or null): other fields are there; loading(text or
       null, share): the bake's progress */
    constructor(given) { Object.assign(this, given); }
    get busy() { return this.#baking !== null; }

    #objects(stage) { return stage.objects().filter(({ key }) => !Fields.#failed.has(key)); }

    /* Returns whether the fields of all objects can be drawn. */
    ready({ stage }) {
        return !!this.#slices
            && this.#objects(stage).every(({ key }) => this.#shown.some(({ object }) => object.key === key));
    }

    /* Asks for the fields of the scene's objects, baked at that resolution with so many rays. */
    want({ stage, resolution, rays }) {
        const objects = this.#objects(stage), best = object => this.#best(object, { resolution, rays });
        if (objects.every(object => best(object)))
            this.#show(objects.map(object => ({ object, field: best(object) })));
        const wanted = objects.map(object => ({ object, how: best(object) ? { resolution, rays } : coarse }))
            .find(({ object, how }) => !Fields.#baked.has(this.#key(object, how)));
        const key = wanted && this.#key(wanted.object, wanted.how);
        if (this.#baking && this.#baking.key !== key) this.#stop();     /* no object needs it any more */
        if (key && !this.#baking) this.#bake(wanted.object, wanted.how, key);
    }
    #key({ key }, { resolution, rays }) { return `${key} ${resolution} ${rays}`; }
    #best(object, how) {
        return Fields.#baked.get(this.#key(object, how)) ?? Fields.#baked.get(this.#key(object, coarse));
    }

    leave() {
        if (this.#baking) this.#stop();
    }
    #stop() {
        this.#worker?.terminate();
        this.#worker = this.#baking = null;
        this.loading(null);
    }

    #bake(object, how, key) {
        this.#worker ??= new Worker(new URL('baker.mjs', import.meta.url), { type: 'module' });
        this.#worker.onmessage = ({ data }) => this.#hear(data);
        this.#worker.onerror = e => this.changed(new Error(`field: its worker failed: ${e.message}`));
        this.#baking = { key, id: ++this.#id, object, title: object.title,
                         fineness: `${how.resolution}×${how.resolution}` };
        const position = object.triangles();
        this.#worker.postMessage({ field: { id: this.#id, position, ...how } }, [position.buffer]);
        this.#told(0);
    }
    #told(share) {
        const { title, fineness } = this.#baking;
        this.loading(`Baking the field of ${title}, ${fineness}`, share, this.#shown.length > 0);
    }

    #hear({ id, field, progress, error }) {
        if (id !== this.#baking?.id) return;
        if (progress !== undefined) { this.#told(progress); return; }
        const { key, object } = this.#baking;
        this.#baking = null;
        this.loading(null);
        if (error) {
            Fields.#failed.add(object.key);
            this.changed(new Error(`${object.title}: no field: ${error}`));
            return;
        }
        Fields.#baked.set(key, this.ssgi.field(field));
        this.changed(null);
    }

    /* Uploads the fields, one in each layer; smaller ones are in a layer's lower corner. */
    #show(all) {
        const same = all.length === this.#shown.length
            && all.every(({ object, field }, i) => this.#shown[i].object.key === object.key
                                                  && this.#shown[i].field === field);
        this.#shown = all;
        if (same && this.#slices) return;
        const { gl } = this, wide = Math.max(2, ...all.map(({ field }) => field.resolution)) + 2;
        gl.deleteTexture(this.#slices);
        this.#slices = this.drawer.texture(wide, 6 * wide, { internal: gl.RG32UI }, Math.max(1, all.length));
        this.drawer.plainUploads();
        all.forEach(({ field: { resolution: r, texels } }, i) => gl.texSubImage3D(
            gl.TEXTURE_2D_ARRAY, 0, 0, 0, i, r + 2, 6 * (r + 2), 1, gl.RG_INTEGER, gl.UNSIGNED_INT, texels));
    }

    /* Returns the inputs for Run.draw: fields, and a row for each object in this view. reach: share of the baked one */
    given({ now, reach }) {
        const { gl } = this, rows = new Float32Array(40 * most), view = new Matrix4().fromArray(now.toView);
        this.#shown.forEach(({ object, field }, i) => {
            const toView = view.clone().multiply(object.toWorld()).toArray();
            rows.set(field.occluder(toView, i, object.number, { reach: reach * field.reach }), 40 * i);
        });
        this.#rows ??= this.drawer.texture(10, most, { internal: gl.RGBA32F });
        this.drawer.plainUploads();
        gl.bindTexture(gl.TEXTURE_2D, this.#rows);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 10, most, gl.RGBA, gl.FLOAT, rows);
        return { FIELDS: this.#slices, OCCLUDERS: this.#rows, instances: this.#shown.length };
    }
}
