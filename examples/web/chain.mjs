/* chain.mjs - makes the ssgi_gl_chain of the page's settings. It does not use the page, so that make web can ask it
   which shaders the page can need in WGSL. */
import { methods, namedChain } from './settings.mjs';

/* Returns the field that counts the directions in which a gather looks for occluders: slices or directions. */
export const countOf = ({ pass, search = 'SLICES' }) =>
    (pass === 'SSAO' || search !== 'SLICES' ? 'directions' : 'slices');

/* Returns whether a chain adds the sun, shadowed by desc.lights, to its result; else three.js draws the sun. */
export const lightsOf = (set, name) => !!methods[name]?.light && set.sun && set.shadow !== 'HOST';

/* Returns the chain of a method. own: with the panel's numbers, which replace the preset's. */
export function chainAs(ssgi, set, name, preset, own, { dialect, width, height, precise }) {
    const d = { ...namedChain(ssgi, name, preset).desc, dialect, normal: set.normals };
    const bounce = set.bounce && d.pass === 'SSDO';
    if (set.thickness !== 'DEFAULT') d.thickness = set.thickness;
    if (!bounce) delete d.bounce;
    if (set.moves && set.history) d.motion = 1;
    if (own && set.slices) d[countOf(d)] = set.slices;
    if (own && set.samples && ssgi.resolve(d).samples) d.samples = set.samples;
    if (own && set.resolution !== 'preset') d.resolution = set.resolution;
    if (own && set.filter > 0) d.filter_radius = set.filter;
    const halved = d.resolution && d.resolution !== 'FULL';
    /* the filter is also needed to upsample, to restore light and to average frames */
    const blur = +!(own && set.filter === 0 && !halved && !d.restore && !set.history);
    const lit = lightsOf(set, name), lights = { pass: 'LIGHTS', dialect, normal: set.normals, thickness: 'CONSTANT',
                                                shadow: set.shadow };
    return { desc: d, ...(lit && { lights }), width, height, blur, history: +set.history,
             direct: +(bounce && set.sun && !lit), precise };
}
