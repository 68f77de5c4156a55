/* chain.mjs - the ssgi_gl_chain that settings mean. Pure, as settings.mjs is: make web asks it which texts the page can
   come to need in WGSL. */
import { methods, namedChain } from './settings.mjs';

/* The field that says in how many directions a gather looks. */
export const countOf = ({ pass, search = 'SLICES' }) =>
    (pass === 'SSAO' || search !== 'SLICES' ? 'directions' : 'slices');

/* Whether the chain adds the sun, as desc.lights shadows it, to what it gathers; else three.js does. */
export const lightsOf = (set, name) => !!methods[name]?.light && set.sun && set.shadow !== 'HOST';

/* own: with the numbers that replace the preset's. */
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
    /* half size becomes whole, light is restored, and frames are averaged where it is filtered */
    const blur = +!(own && set.filter === 0 && !halved && !d.restore && !set.history);
    const lit = lightsOf(set, name), lights = { pass: 'LIGHTS', dialect, normal: set.normals, thickness: 'CONSTANT',
                                                shadow: set.shadow };
    return { desc: d, ...(lit && { lights }), width, height, blur, history: +set.history,
             direct: +(bounce && set.sun && !lit), precise };
}
