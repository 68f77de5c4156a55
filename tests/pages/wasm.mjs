/* wasm.mjs - checks ssgi.mjs and ssgi.wasm against manifests of build/glsl-text and against a block written by C.

      node wasm.mjs build/wasm ROOT     in the folder of frame.bin and of the manifests: texts, others, computed */
import { readFileSync as read } from 'node:fs';
import { equal, deepEqual, throws } from 'node:assert/strict';
const { load } = await import(process.argv[2] + '/ssgi.mjs');
const ssgi = await load();
const formatOf = f => ({ name: f.name, ...f.gl, bytes: f.bytes, vulkan: f.vulkan_number,
                         vulkan_name: f.vulkan, webgpu: f.webgpu });
for (const folder of ['texts', 'others', 'computed']) {
    const m = JSON.parse(read(folder + '/manifest.json', 'utf8'));
    for (const v of m.variants) {
        const desc = v.fetch ? { ...v.desc, fetch: m.fetch } : v.desc;
        for (const [stage, file] of Object.entries(v.files))
            equal(ssgi.shader(desc, stage), read(folder + '/' + file, 'utf8'), file);
        deepEqual(ssgi.rows(desc), m.row_lists[v.rows].map(i => m.rows[i]));
    }
    for (const c of m.chains) {
        const steps = ssgi.steps({ ...c.chain, width: 1, height: 1 });
        equal(steps.length, c.steps.length, c.name);
        equal(steps.length <= 32, true, `${c.name} does not fit into SSGI_GL_MAX_STEPS`);
        for (const [i, step] of steps.entries()) {
            const said = c.steps[i];
            for (const [stage, file] of Object.entries(said.files))
                equal(ssgi.shader(step.desc, stage), read(folder + '/' + file, 'utf8'), file);
            deepEqual(step.inputs.map(k => [k.name, k.unit, k.set, k.binding, k.meaning ?? k.texture, k.last]),
                said.inputs.map(k => [k.name, k.unit, k.set|0, k.binding, k.yours ?? k.texture, k.last ?? 0]));
            deepEqual(step.outputs.map(k => [k.texture, k.layer, k.format]), said.outputs.map(k =>
                [k.texture, k.layer, formatOf(m.formats[c.textures[k.texture].format])]));
            deepEqual(ssgi.rows(step.desc), said.rows.map(k => m.rows[k]));
            deepEqual(step.groups, said.group ? [1, 1] : [0, 0]);
            if (said.group)
                deepEqual([[step.desc.group_width, step.desc.group_height],
                           ...step.outputs.map(k => [k.set, k.binding])],
                          [said.group, ...said.outputs.map(k => [k.set, k.binding])]);
            deepEqual([step.scale, step.frame, step.vertices, step.instances, step.blend[0] !== 0],
                [said.scale, said.frame, said.vertices, said.instances, said.blend !== null]);
        }
    }
    deepEqual(ssgi.members.length, m.frame.members.length + m.views.members.length);
    deepEqual(ssgi.resolve({ pass: 'HSAO' }), m.defaults.hsao);
}
const id = [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1], last = [...id];
last[12] = 0.25;
const view = ssgi.view([1.3,0,0,0, 0,2.4,0,0, 0,0,-1.002,-1, 0,0,-0.2002,0], 64, 48);
const frame = ssgi.harmonics(ssgi.history(ssgi.frame(view, 0.5), view, id, last), [1, 2, 3], 1);
frame.phase[0] = ssgi.phase(5);
ssgi.surfels(frame, view, { size: 0.03, keep_small: true }, 3);
deepEqual(Buffer.from(frame.buffer), read('frame.bin'));
equal(frame.radius[0], 0.5);
const d = ssgi.preset({ pass: 'HSAO', version: '' }, 'FAST');
equal(d.resolution, 'HALF');
equal(ssgi.shader(d).indexOf('#version'), -1);
equal(typeof ssgi.key(d), 'bigint');
throws(() => ssgi.shader({ pass: 'HSAO', samples: 99 }), /^Error: desc.gather.samples: must be 0..64$/);
throws(() => ssgi.shader({ pass: 'NONE' }), /^Error: desc.pass: must be/);
equal(ssgi.read(d).match(/float ssgi_visibility_at/g).length, 1);
throws(() => ssgi.read({ pass: 'EMITTERS' }), /^Error: desc.pass: /);
equal(ssgi.reflection().match(/^float ssgi_specular_visibility/m).length, 1);
throws(() => ssgi.shader({ smaples: 1 }), /^Error: desc.smaples: there is no such field$/);
throws(() => ssgi.frame(view, -1), /^Error: radius: /);
throws(() => ssgi.view(id, 0, 1), /^Error: width: /);
throws(() => ssgi.preset({}, 'GOOD'), /^Error: preset: /);
const many = { search: 'POINTS', layers: 8, views: 4, view_layers: 8 };
const all = ssgi.steps({ desc: { pass: 'SSDO', bounce: 'PATCH', environment: 'SH', ...many }, blur: 1, vpls: 1,
         lights: { pass: 'LIGHTS', ...many }, width: 64, height: 64 });
equal(all.length, 124);
equal(all.at(-1).outputs[0].result, 'BOUNCE');
const computed = ssgi.chain('hsao,dialect=450,compute=ALL,group_width=16,group_height=4');
deepEqual(ssgi.steps({ ...computed, width: 101, height: 67 }).map(step => step.groups),
          [[4, 9], [4, 9], [7, 17]]);
const { calls, works } = await import(process.argv[3] + '/tests/pages/web-hostile.mjs');
for (const [call, says] of calls({ load, Ssgi: ssgi.constructor }, ssgi)) {
    const e = await Promise.resolve().then(call).then(() => null, e => e);
    equal(e?.constructor === Error && (says.test ? says.test(e.message) : says === e.message), true,
          `${call}: ${e?.name}: ${e?.message}`);
}
equal(works(ssgi), true);
