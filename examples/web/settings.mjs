/* settings.mjs - the page's settings, read from its address and written to it. It does not use the page.

   Tables have no prototype: words of the address are looked up in them, and every other object has "constructor". */
import { skies } from './sky.mjs';

const surfels = { size: 0.03, levels: 4, epsilon: 0.3 };      /* the library's defaults */

/* method: the library's name for Ssgi.chain, whose sentence is shown. The other members are the page's own. */
export const methods = {
    __proto__: null,
    none: { title: 'No occlusion' },
    ssao: { title: 'SSAO', method: 'ssao' },
    hsao: { title: 'HSAO', method: 'hsao' },
    march: { title: 'HSAO, march', method: 'hsao-march' },
    ssdo: { title: 'SSDO', method: 'ssdo', light: true },
    points: { title: 'SSDO, points', method: 'ssdo-points', light: true },
    s3ho: { title: 'S3HO', method: 's3ho', settings: ',transfer=direct,packed_coefficients=0,restore=ratio',
        light: true },
    dss: { title: 'Deep screen space', method: 'dss', module: 'surfels',
           presets: { FAST: surfels, BALANCED: surfels, BEST: surfels } },
    aof: { title: 'Fields of objects', method: 'aof', settings: ',objects=texture', module: 'fields', presets: {
        FAST: { resolution: 8, rays: 64 }, BALANCED: { resolution: 16, rays: 96 },
        BEST: { resolution: 32, rays: 96 } } }
};

/* Returns the library's sentence about a method. */
export const sentenceOf = (ssgi, name) => ssgi.methods.find(m => m.name === methods[name].method)?.sentence
    ?? 'All light as it comes.';

/* Returns the library's chain of a method with a preset. */
export const namedChain = (ssgi, name, preset) =>
    ssgi.chain(`${methods[name].method},${preset}${methods[name].settings ?? ''}`);
/* Settings that a method's choice changes, so that its effect is seen. */
export const shows = {
    __proto__: null,
    ssdo: { bounce: true }, points: { bounce: true }, aof: { moves: true }
};
/* The light of each scene until the user chooses another. */
export const looks = {
    __proto__: null,
    room: { sky: 'windows' },
    cornell: { sky: 'white', sun: false, bounce: true }
};
export const presets = { __proto__: null, FAST: 'fast', BALANCED: 'balanced', BEST: 'best' };
export const views = ['lit', 'ambient', 'difference'];
export const thicknesses = { __proto__: null, DEFAULT: 'as thick as wide', CONSTANT: 'constant',
                             SOLID: 'unlimited', BACK: 'to the back face', SLABS: 'two slabs, peeled' };
export const shadows = { __proto__: null, HOST: 'by three.js, beside the chain', MAP: 'mapped',
                         FILL: 'mapped, the bias filled', SEGMENT: 'on the screen', NONE: 'none' };
export const resolutions = { __proto__: null, preset: 'as the preset', HALF: 'half', FULL: 'full' };
export const normals = { __proto__: null, SIGNED: 'of the G-buffer', FROM_DEPTH: 'from depth' };
export const sizes = ['480x270', '640x360', '960x540', '1280x720', '1920x1080'];

/* ---- kinds of settings. read: returns the value of a text, or undefined; must: describes a valid one */

const word = (initial, words) => ({
    initial,
    read: text => (words.includes(text) ? text : undefined),
    must: () => `must be one of ${words.join(', ')}`
});

const flag = initial => ({
    initial,
    read: text => (text === '0' || text === '1' ? text === '1' : undefined),
    must: () => 'must be 0 or 1'
});

/* Makes a setting in [least, most]. other: one value outside these limits that has its own meaning, named by words */
const number = (initial, least, most, other = null, words = '', of = 'a number') => ({
    initial, least, most,
    read(text) {
        const value = text.trim() ? Number(text) : NaN, good = of === 'a number' || Number.isInteger(value);
        return good && ((value >= least && value <= most) || value === other) ? value : undefined;
    },
    must: () => `must be ${of} from ${least} to ${most}${words}`
});

/* Makes a setting that is a whole number. other: the word for the preset's number */
const count = (least, most, other) =>
    number(other, least, most, other, `, or ${other} for the preset's`, 'a whole number');

/* The names of scenes are known when the page has fetched their list. */
const scene = {
    initial: 'room',
    read: (text, { scenes }) => (scenes.includes(text) ? text : undefined),
    must: (text, { scenes }) => (text === 'file' ? 'must be opened again: a model of your own is in no address'
        : `must be one of ${scenes.join(', ')}`)
};

const size = {
    initial: 'auto',
    read(text, { side, pixels }) {
        const [, width, height] = /^([1-9]\d{0,5})x([1-9]\d{0,5})$/.exec(text) ?? [];
        const fits = Math.min(width, height) >= 16 && Math.max(width, height) <= side && width * height <= pixels;
        return text === 'auto' || fits ? text : undefined;
    },
    must: (text, { side, pixels }) =>
        `must be auto or WIDTHxHEIGHT, 16 to ${side} pixels each, at most ${pixels} in all`
};

const sky = {
    initial: 'sky',
    read: (text, { sky }) => (Object.hasOwn(skies, text) || (text === 'file' && sky) ? text : undefined),
    must: text => (text === 'file' ? 'must be opened again: a sky of your own is in no address'
        : `must be one of ${Object.keys(skies).join(', ')}`)
};

/* Eye and target. Beyond 1e9 floats are too coarse for a scene. */
const camera = {
    initial: '',
    read(text) {
        const at = text.split(',').map(part => (part.trim() ? Number(part) : NaN));
        const good = at.length === 6 && at.every(v => Math.abs(v) <= 1e9) && [0, 1, 2].some(i => at[i] !== at[3 + i]);
        return text === '' ? '' : good ? at.join(',') : undefined;
    },
    must: () => 'must be six numbers, an eye and a target elsewhere, -1e9 to 1e9'
};

export const settings = {
    __proto__: null,
    scene,
    sky,
    sun: flag(true),
    azimuth: number(55, -180, 180),
    height: number(22, 0, 90),
    strength: number(1.2, 0, 4),
    shadow: word('HOST', Object.keys(shadows)),
    exposure: number(0, -3, 3),
    effect: number(1, 0, 3),
    view: word('lit', views),
    a: word('hsao', Object.keys(methods)),
    p: word('BALANCED', Object.keys(presets)),
    b: word('none', [...Object.keys(methods), 'truth', 'off']),
    q: word('BALANCED', Object.keys(presets)),
    radius: number(1, -2, 2),
    slices: count(1, 32, 0),
    samples: count(1, 32, 0),
    filter: count(0, 4, -1),
    surfel: number(0, 0.5, 6, 0, ', or 0 for the preset\'s'),
    levels: count(1, 7, 0),
    field: count(4, 64, 0),
    reach: number(1, 0.1, 1),
    resolution: word('preset', Object.keys(resolutions)),
    thickness: word('DEFAULT', Object.keys(thicknesses)),
    thickness_limit: number(-1, 0, 2, -1, ', or -1 for the method\'s own'),
    normals: word('SIGNED', Object.keys(normals)),
    history: flag(true),
    bounce: flag(false),
    moves: flag(false),
    circle: flag(false),
    size,
    truth: flag(false),
    split: number(0.5, 0, 1),
    cam: camera
};
export const defaults = Object.fromEntries(Object.entries(settings).map(([name, { initial }]) => [name, initial]));
export const lookOf = scene => ({ ...defaults, ...looks[scene] });

/* Returns a text as quoted in a sentence, shortened. */
function quoted(text) {
    const all = [...text.replace(/\p{Cc}|\p{Cs}/gu, '\ufffd')];
    return all.length > 40 ? `${all.slice(0, 40).join('')}…` : all.join('');
}

/* Returns { set, wrong }: all settings, and a sentence for each refused one, which stays as in before. hash: the
   address after its #; of a name that is repeated the last counts. limits: { scenes: names, side, pixels: of a picture
   } */
export function read(hash, limits, before = defaults) {
    const named = new URLSearchParams(hash).getAll('scene').at(-1) ?? defaults.scene;
    const set = lookOf(scene.read(named, limits) ?? before.scene), wrong = [];
    for (const [name, text] of new URLSearchParams(hash)) {
        const setting = settings[name], value = setting?.read(text, limits);
        if (value !== undefined) { set[name] = value; continue; }
        if (setting) set[name] = before[name];
        wrong.push(setting ? `${name}=${quoted(text)}: ${setting.must(text, limits)}`
            : `${quoted(name)}: there is no such setting`);
    }
    return { set, wrong };
}

/* Returns the address of all settings that differ from the scene's defaults. */
export function write(set) {
    const short = value => (typeof value === 'string' ? value : +Number(value).toFixed(3));
    const look = lookOf(set.scene);
    return Object.entries(set).filter(([name, value]) => value !== (name === 'scene' ? defaults : look)[name])
        .map(([name, value]) => `${name}=${short(value)}`).join('&');
}
