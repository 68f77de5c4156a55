/* makers.mjs - what methods draw that is made of triangles beforehand: surfels, fields. Each side has its own; their
   modules are fetched when they are first asked for. */
import { methods, namedChain } from './settings.mjs';

const modules = { surfels: () => import('./surfels.mjs').then(m => m.Surfels),
                  fields: () => import('./fields.mjs').then(m => m.Fields) };

export class Makers {
    #given; #made = [{}, {}];

    /* given: { gl, drawer, ssgi, loading }; changed(side, error or null): something else is there */
    constructor(given, changed) {
        this.#given = given;
        this.changed = changed;
    }

    /* null: the method has none, or its module is on its way. */
    of(side, name) {
        const { module } = methods[name] ?? {}, made = this.#made[side];
        if (!module || made[module] === 'coming') return null;
        if (made[module]) return made[module];
        made[module] = 'coming';
        modules[module]().then(Maker => {
            made[module] = new Maker({ ...this.#given, changed: error => this.changed(side, error) });
            this.changed(side, null);
        }, e => {
            delete made[module];
            this.changed(side, e);
        });
        return null;
    }

    /* Has made of what is shown what the side draws, or asks for it. about: what it is made of, as settings have it */
    ready(side, name, about) {
        if (!methods[name]?.module) return true;
        const maker = this.of(side, name);
        maker?.want(about);
        return !!maker?.ready(about);
    }
    /* What the side no longer draws is not waited for. */
    leave(side, name) {
        for (const [module, one] of Object.entries(this.#made[side]))
            if (module !== methods[name]?.module) one.leave?.();
    }
    get busy() { return this.#made.some(all => Object.values(all).some(one => one === 'coming' || one.busy)); }
}

/* What of it is set: as the preset, or, of the left side, as the panel has it. */
export function setOf(name, preset, set, own) {
    const { presets, module } = methods[name], is = { ...presets?.[preset] };
    if (own && module === 'surfels' && set.surfel) is.size = set.surfel / 100;
    if (own && module === 'surfels' && set.levels) is.levels = set.levels;
    if (own && module === 'fields' && set.field) is.resolution = set.field;
    if (module === 'fields') is.reach = set.reach;
    return is;
}

/* Their chain, as settings have it. */
export function madeChain(ssgi, name, preset, set, own, { dialect, width, height, precise }) {
    const { levels } = setOf(name, preset, set, own);
    const chain = namedChain(ssgi, name, preset);
    return { ...chain, desc: { ...chain.desc, dialect, normal: set.normals, ...(levels && { levels }) }, width, height,
             precise };
}
