/* baker.mjs - a worker that makes surfels and fields from triangles by bake.wasm. It is sent

      { part, position, normal }    part of the scene, nine floats a triangle; kept until another has its number
      { surfels: { id, projection, width, height, size, reach, views } }    views: to view space, of each part, or null
      { field: { id, position, resolution, rays } }

   and answers { id, surfels, counts }, { id, progress } and { id, field } or { id, error }. */
import { fetchFile } from './fetch.mjs';

let c = null, tell = () => {}, guess = 0;
const parts = [];
let top = 0;

async function open() {
    if (c) return;
    const bytes = await (await fetchFile('bake.wasm')).arrayBuffer();
    const made = await WebAssembly.instantiate(bytes, { Math, page: { progress: share => tell(share) } });
    c = made.instance.exports;
    top = c.__heap_base.value;
}

/* ---- memory: parts of the scene come first, then the memory of a call */

function room(bytes) {
    const at = Math.ceil(top / 16) * 16, lacking = at + bytes - c.memory.buffer.byteLength;
    if (at + bytes > 0x7fff0000) throw new Error('would take more than 2 GB of memory');
    if (lacking > 0)
        try { c.memory.grow(Math.ceil(lacking / 65536)); }
        catch { throw new Error('would take more memory than this machine gives'); }
    top = at + bytes;
    return at;
}
function put(floats) {
    const at = room(floats.byteLength);
    new Float32Array(c.memory.buffer, at, floats.length).set(floats);
    return at;
}
function scope(body) {
    const before = top;
    try { return body(); } finally { top = before; }
}
function good(result) {
    if (result >= 0) return result;
    const bytes = new Uint8Array(c.memory.buffer), at = c.bake_why();
    throw new Error(new TextDecoder().decode(bytes.slice(at, bytes.indexOf(0, at))));
}

/* Calls make(to, capacity), which returns how many elements there are; calls it again if more than expected. */
function all(size, expected, make) {
    let at = room(size * expected), count = good(make(at, expected));
    if (count > expected) {
        top = at;
        at = room(size * count);
        count = good(make(at, count));
    }
    return { at, count };
}

/* ---- what is made */

/* Stores a part. Parts lie in memory one after another, so all later ones move, too. */
function take({ part, position, normal }) {
    parts[part] = { position, normal };
    top = c.__heap_base.value;
    for (const one of parts.filter(Boolean)) {
        one.p = put(one.position);
        one.n = put(one.normal);
        one.triangles = one.position.length / 9;
    }
}

function surfels({ id, projection, width, height, size, reach, views }) {
    return scope(() => {
        good(c.bake_look(put(projection), width, height, size, reach));
        const made = views.map((view, k) => (view && parts[k] ? surfelsOf(parts[k], put(view)) : new Float32Array(0)));
        const joined = new Float32Array(made.reduce((n, one) => n + one.length, 0));
        made.reduce((at, one) => { joined.set(one, at); return at + one.length; }, 0);
        guess = Math.ceil(joined.length / 12 * 1.1);
        return { id, surfels: joined, counts: made.map(one => one.length / 12) };
    });
}
function surfelsOf({ p, n, triangles }, view) {
    return scope(() => {
        const divided = all(108, Math.ceil(triangles * 1.02) + 4096,
                            (to, most) => c.bake_divide(to, most, view, p, n, triangles));
        const sorted = room(108 * divided.count);
        c.bake_sort(sorted, view, divided.at, divided.count);
        const made = all(48, guess || triangles,
                         (to, most) => c.bake_surfels(to, most, view, sorted, divided.count));
        return new Float32Array(c.memory.buffer, made.at, 12 * made.count).slice();
    });
}

function field({ id, position, resolution, rays }) {
    return scope(() => {
        const triangles = position.length / 9, size = c.bake_field_work(resolution, rays, triangles);
        const texels = room(c.bake_field_texels(resolution)), at = put(position), work = room(size);
        tell = share => postMessage({ id, progress: share });
        const bytes = good(c.bake_field(work, size, texels, resolution, rays, at, triangles));
        return { id, field: new Uint8Array(c.memory.buffer, work, bytes).slice() };
    });
}

let queue = Promise.resolve();
onmessage = ({ data }) => {
    queue = queue.then(async () => {
        const { id } = data.surfels ?? data.field ?? data;
        try {
            await open();
            if (data.surfels) { const made = surfels(data.surfels); postMessage(made, [made.surfels.buffer]); }
            else if (data.field) postMessage(field(data.field));
            else take(data);
        } catch (e) { postMessage({ id, error: e.message }); }
    });
};
