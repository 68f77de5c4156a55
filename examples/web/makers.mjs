/* makers.mjs - the inputs of methods that are made from triangles beforehand: surfels, fields. The left and the right
   side have their own. The modules are fetched when they are first needed. */
import { methods, namedChain } from './settings.mjs';

const modules = { surfels: () => import('./surfels.mjs').then(m => m.Surfels),
                  fields: () => import('./fields.mjs').then(m => m.Fields) };

export class Makers {
    #given; #made = [{}, {}];

    /* given: { gl, drawer, ssgi, loading }; changed(side, error or null): a side's inputs are there, or failed */
    constructor(given, changed) {
        this.#given = given;
        this.changed = changed;
    }

    /* Returns the maker of a method's inputs; null: it needs none, or the maker's module is being fetched. */
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

    /* Returns whether a side's inputs are ready, and asks for them. about: scene, view and settings for them */
    ready(side, name, about) {
        if (!methods[name]?.module) return true;
        const maker = this.of(side, name);
        maker?.want(about);
        return !!maker?.ready(about);
    }
    /* Stops makers whose inputs the side no longer draws. */
    leave(side, name) {
        for (const [module, one] of Object.entries(this.#made[side]))
            if (module !== methods[name]?.module) one.leave?.();
    }
    get busy() { return this.#made.some(all => Object.values(all).some(one => one === 'coming' || one.busy)); }
}

/* Returns the settings of a method's surfels or fields: the preset's or, if own (the left side), the panel's. */
export function setOf(name, preset, set, own) {
    const { presets, module } = methods[name], is = { ...presets?.[preset] };
    if (own && module === 'surfels' && set.surfel) is.size = set.surfel / 100;
    if (own && module === 'surfels' && set.levels) is.levels = set.levels;
    if (own && module === 'fields' && set.field) is.resolution = set.field;
    if (module === 'fields') is.reach = set.reach;
    return is;
}

/* Returns the chain of a method that needs surfels or fields, by the page's settings. */
export function madeChain(ssgi, name, preset, set, own, { dialect, width, height, precise }) {
    const { levels } = setOf(name, preset, set, own);
    const chain = namedChain(ssgi, name, preset);
    return { ...chain, desc: { ...chain.desc, dialect, normal: set.normals, ...(levels && { levels }) }, width, height,
             precise };
}
