/* page.mjs - the page: its settings, its frames and the text beside them. webgl.mjs draws the library's passes. */
import { load } from './ssgi.mjs';
import { defaults, resolutions, lookOf, methods, namedChain, normals, presets, read, sentenceOf, settings, shadows,
         shows,
         sizes, thicknesses, views, write } from './settings.mjs';
import { chainAs, countOf, lightsOf } from './chain.mjs';
import { skies, equirect } from './sky.mjs';
import { Drawer } from './webgl.mjs';
import { Show } from './show.mjs';
import { cLines } from './code.mjs';
import { exr } from './exr.mjs';
import { fetchFile } from './fetch.mjs';
import { bar } from './bar.mjs';
import { Makers, madeChain, setOf } from './makers.mjs';

const $ = id => document.getElementById(id), panel = $('panel'), canvas = $('canvas');
const set = lookOf(defaults.scene);
const most = 4096;                                  /* rays a pixel at which the ground truth is finished */

const settled = 32;                                 /* frames of a still view after which history no longer changes */
const kept = 31;                                    /* number of a pass's last times whose median is shown */

let ssgi, stage, drawer, show, truth, scenes = [], gl, software = false;
let own, gpu = null;                         /* own: { drawer, show } of WebGL 2; gpu: those of WebGPU, if it draws */
let sides = [null, null];                           /* left and right: { run, key, frame number, .. } */
let buffers = null, size = { width: 0, height: 0 }, last = null, pending = 0, still = 0, frames = 0;
let calm = null;                                    /* the view without the subpixel offsets that smooth edges */
let samples = 0;                                  /* number of images with subpixel offsets in the mean that is shown */
let dirty = { scene: true, gather: true, picture: true }, traced = null, clockless = false, environments = new Map();
let errors = {}, ownSky = null, makers;
let readScene, readFiles;                   /* functions of model.mjs, which is fetched once WebGL 2 is known to work */

/* ---- settings, in the address and in the panel */

/* Takes the address's settings. Returns sentences for notice() about those that are refused and keep their values. */
function fromAddress() {
    const { set: all, wrong } = read(location.hash.slice(1), limits(), set);
    Object.assign(set, all);
    return wrong;
}
function limits() {
    const side = Math.min(4096, gl.getParameter(gl.MAX_TEXTURE_SIZE), ...gl.getParameter(gl.MAX_VIEWPORT_DIMS));
    return { scenes: scenes.map(s => s.name), sky: !!ownSky, side, pixels: software ? 1920 * 1080 : 3840 * 2160 };
}
let addressed = 0;
function writeAddress() {
    clearTimeout(addressed);
    addressed = setTimeout(() => history.replaceState(null, '', '#' + write(set)), 250);
}
const radius = () => stage.info.radius * 2 ** set.radius;
/* Returns the limit in radii: the user's, or the library's for the method, without digits of float rounding. */
function thicknessLimit(method) {
    if (set.thickness_limit >= 0) return set.thickness_limit;
    if (!methods[method]?.method) return 0.6;
    const view = ssgi.view([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -2, 0], 1, 1);
    return Number(ssgi.frame(view, 1, namedChain(ssgi, method, 'BALANCED')).thickness_limit[0].toPrecision(6));
}
const wantsTruth = () => set.truth || set.b === 'truth' || set.view === 'difference';
const moving = () => set.moves || set.circle;
/* Whether a shown chain includes the sun's light, so that the ground truth must, too. */
const lit = () => [set.a, set.b].some(name => lightsOf(set, name));
const uses = name => set.a === name || set.b === name;
const averages = () => sides.some(side => side?.run.chain.history);
const digits = v => v >= 100 ? v.toFixed(0) : v >= 10 ? v.toFixed(1) : v.toFixed(2);

function toPanel() {
    const chain = methods[set.a]?.method ? chainFor(set.a, set.p, true) : null, is = chain && ssgi.resolve(chain.desc);
    const made = chain && setOf(set.a, set.p, set, true), { module } = methods[set.a] ?? {};
    /* settings that have the preset's value until the user changes them */
    const used = { thickness_limit: thicknessLimit(set.a), slices: is?.[countOf(is)] ?? 0, samples: is?.samples ?? 0,
                   filter: chain?.blur ? filterOf(chain.desc) : 0, surfel: 100 * (made?.size ?? 0),
                   levels: made?.levels ?? 0, field: made?.resolution ?? 0 };
    const texts = { radius: stage.info ? +radius().toPrecision(2) : '', effect: set.effect.toFixed(2),
                    thickness_limit: `${used.thickness_limit.toFixed(2)} R`, reach: `${set.reach.toFixed(2)} ×`,
                    azimuth: `${set.azimuth}°`, height: `${set.height}°`, strength: `${set.strength.toFixed(2)} ×`,
                    exposure: `${set.exposure > 0 ? '+' : ''}${set.exposure.toFixed(1)}` };
    for (const control of panel.elements) {
        const { name, type } = control, output = control.parentElement.querySelector('output');
        if (!Object.hasOwn(set, name)) continue;
        if (type === 'checkbox') control.checked = set[name];
        else if (type === 'radio') control.checked = control.value === set[name];
        else if (name === 'size') showSize(control, set.size);
        else control.value = used[name] ?? set[name];
        if (output) output.textContent = texts[name] ?? `${control.value}${name === 'surfel' ? ' %' : ''}`;
    }
    const method = name => !!methods[name]?.method;
    const on = (of, yes) => panel.querySelectorAll(of).forEach(e => { e.hidden = !yes; });
    on('.of-a', method(set.a));
    on('.of-b', method(set.b));
    on('.of-gather', method(set.a) && !module);
    on('.of-samples', !!is?.samples && !module);
    on('.of-surfels', module === 'surfels');
    on('.of-field', module === 'fields');
    on('.of-sun', set.sun);
    on('.of-lights', set.sun && [set.a, set.b].some(m => methods[m]?.light));
    on('.of-thickness', set.thickness !== 'SOLID');
    on('.of-bounce', [set.a, set.b].some(m => methods[m]?.method?.startsWith('ssdo')));
    if (is) $('slices-field').textContent = `desc.gather.${countOf(is)}`;
    $('smooth').checked = set.filter !== 0;
    $('about').textContent = `${methods[set.a].title}: ${sentenceOf(ssgi, set.a)}`;
    $('alone').textContent = [set.a, set.b].some(name => methods[name]?.light) ? 'Light alone' : 'AO alone';
    panel.elements.truth.checked = wantsTruth();
    panel.elements.truth.disabled = wantsTruth() && !set.truth;
    $('own').hidden = !method(set.a) || !(module ? made.size !== methods[set.a].presets[set.p].size
        || made.levels !== methods[set.a].presets[set.p].levels || (module === 'fields' && set.field)
        : set.slices || set.samples || set.filter >= 0 || set.resolution !== 'preset');
    for (const thumb of $('thumbs').children) thumb.setAttribute('aria-pressed', thumb.value === set.scene);
    const title = (name, preset) => name === 'truth' ? 'truth, ray-traced'
        : methods[name] ? methods[name].title + (method(name) ? ` · ${presets[preset]}` : '') : '';
    $('left-tag').textContent = title(set.a, set.p) + ($('own').hidden ? '' : ' *');
    $('right-tag').textContent = set.b === 'off' ? '' : title(set.b, set.q);
    $('split').hidden = set.b === 'off';
    $('split').style.left = `${100 * set.split}%`;
    $('split').setAttribute('aria-valuenow', Math.round(100 * set.split));
    page.bar?.show();
}

/* Adds the sizes that only an address can ask for. */
function showSize(select, value) {
    if (![...select.options].some(o => o.value === value)) select.add(new Option(value));
    select.value = value;
}

function options(select, entries) {
    select.replaceChildren(...entries.map(([value, text]) => new Option(text, value)));
}

function listen() {
    panel.addEventListener('input', ({ target }) => {
        const { name, type } = target;
        if (!Object.hasOwn(set, name)) return;
        choose(name, type === 'checkbox' ? target.checked : type === 'range' ? +target.value : target.value);
    });
    $('thumbs').onclick = ({ target }) => {
        const { value } = target.closest('button') ?? {};
        if (value && value !== set.scene) choose('scene', value);
    };
    $('smooth').onchange = ({ target }) => choose('filter', target.checked ? -1 : 0);
    $('own').onclick = () => {
        Object.assign(set, { slices: 0, samples: 0, filter: -1, resolution: 'preset', surfel: 0, levels: 0, field: 0 });
        changed('resolution');
    };
    $('canvas').addEventListener('pointerdown', () => stand());
    $('picture').addEventListener('pointermove', e => { pointer = e; writeHere(); });
    $('picture').addEventListener('pointerleave', () => { pointer = null; writeHere(); });
    $('canvas').addEventListener('wheel', () => stand(), { passive: true });
    $('canvas').addEventListener('keydown', e => { if (e.key.startsWith('Arrow')) stand(); });
    panel.addEventListener('submit', e => e.preventDefault());
    addEventListener('hashchange', goToAddress);
    stage.controls.addEventListener('change', () => {
        if (set.circle) return;
        set.cam = lookedFrom();
        dirty.scene = dirty.gather = true;
        writeAddress();
        request();
    });
    new ResizeObserver(request).observe($('picture'));
    const split = $('split'), move = x => {
        const box = shownBox();
        set.split = Math.min(1, Math.max(0, (x - box.left) / box.width));
        toPanel();
        placeSplit();
        writeAddress();
        request();
    };
    split.addEventListener('pointerdown', e => {
        split.setPointerCapture(e.pointerId);
        split.focus({ preventScroll: true });
        e.preventDefault();
    });
    split.addEventListener('pointermove', e => { if (split.hasPointerCapture(e.pointerId)) move(e.clientX); });
    split.addEventListener('keydown', e => {
        const way = (e.key === 'ArrowRight') - (e.key === 'ArrowLeft'), box = shownBox();
        if (way) move(box.left + (set.split + way * 0.02) * box.width);
    });
    $('home').onclick = lookHome;
    $('open').onclick = () => $('file').click();
    $('file').onchange = ({ target }) => {
        if (target.files.length) openFiles([...target.files]);
        target.value = '';
    };
    const drop = $('drop');
    addEventListener('dragover', e => { e.preventDefault(); drop.hidden = false; });
    addEventListener('dragleave', e => { if (!e.relatedTarget) drop.hidden = true; });
    addEventListener('drop', e => {
        e.preventDefault();
        drop.hidden = true;
        if (e.dataTransfer.files.length) openFiles([...e.dataTransfer.files]);
    });
    $('link').onclick = async () => {
        clearTimeout(addressed);
        history.replaceState(null, '', '#' + write(set));
        await copied($('link'), location.href);
        const own = [[set.scene, 'model'], [set.sky, 'sky']].filter(([is]) => is === 'file').map(([, what]) => what);
        if (own.length)
            notice(`The ${own.join(' and the ')} that you opened will not be there: a link holds no files.`);
    };
    $('webgpu-box').disabled = !navigator.gpu;
    if (!navigator.gpu) $('webgpu-box').parentElement.title = 'This browser has no WebGPU';
    $('webgpu-box').onchange = ({ target }) => chooseGpu(target.checked);
    $('read').onclick = readText;
    $('copy-glsl').onclick = () => copied($('copy-glsl'),
                                          glslTexts().map(({ name, text }) => `// ${name}\n${text}`).join('\n'));
    $('copy-c').onclick = () => copied($('copy-c'), page.code(0) ?? page.code(1) ?? '');
    $('save').onclick = () => saved('frame.exr', new Blob([frameFile()], { type: 'image/x-exr' }));
    $('text-which').onchange = showText;
    $('text-close').onclick = () => $('text').close();
    $('text').onclick = e => { if (e.target === $('text')) $('text').close(); };
    $('text-copy').onclick = () => copied($('text-copy'), $('text').querySelector('pre').textContent);
    canvas.addEventListener('webglcontextlost', e => {
        e.preventDefault();
        notice('The device lost its WebGL context. Reload the page.');
    });
}

function saved(name, blob) {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(blob);
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/* Shows an activity and its share that is done, 0 to 1; NaN: unknown; text null: there is none. aside: in a corner, so
   that the image stays visible. Until the first image only the text is shown: a bar that moves makes the browser
   compose the page all the time, which without a GPU takes as long as the image. */
function loading(text, share = NaN, aside = false) {
    $('loading').classList.toggle('aside', aside);
    $('loading').hidden = text === null;
    $('loading-text').textContent = text ?? '';
    $('loading-bar').hidden = false;
    if (Number.isFinite(share)) $('loading-bar').value = share;
    else $('loading-bar').removeAttribute('value');
}

async function copied(button, text) {
    const was = button.textContent;
    try { await navigator.clipboard.writeText(text); button.textContent = 'Copied'; }
    catch { button.textContent = 'Cannot copy'; }
    setTimeout(() => { button.textContent = was; }, 4000);
}

/* Shows sentences, a line each; without any the notice is hidden. */
function notice(...sentences) {
    const shown = sentences.slice(0, 3), more = sentences.length - shown.length;
    $('notice').hidden = !shown.length;
    $('notice').textContent = [...shown, ...(more ? [`and ${more} more`] : [])].join('\n');
}

/* Takes the default light of a scene for all settings of light that the user has not changed. */
function takeLook(scene) {
    const was = lookOf(set.scene), is = lookOf(scene);
    for (const key in is) if (key !== 'scene' && set[key] === was[key]) set[key] = is[key];
}
let ownView = false;                                 /* the user has chosen the view, so that it stays */
function choose(name, value) {
    if (name === 'scene') takeLook(value);
    set[name] = value;
    notice();
    if (name === 'scene') {
        set.cam = '';
        openScene();
    }
    if (name === 'view') ownView = true;
    if (name === 'a' || name === 'b') {
        Object.assign(set, shows[value]);
        if (software && methods[value]?.module === 'surfels') set[name === 'a' ? 'p' : 'q'] = 'FAST';
        if (!ownView && methods[value]?.method) set.view = 'ambient';
    }
    if (name === 'circle' && !value) set.cam = lookedFrom();
    changed(name);
}

/* Stops the turning of the view when the user touches it. */
function stand() {
    if (set.circle) choose('circle', false);
}

const suns = ['sun', 'azimuth', 'height', 'strength'];      /* light a bounce, too */
const forEyes = ['exposure', 'effect', 'truth'];            /* settings that change no gather */
function changed(name) {
    if (suns.includes(name)) {
        dirty.scene = true;
        dirty.gather ||= set.bounce || lit();
    } else if (!forEyes.includes(name) && name !== 'split') dirty.gather = true;
    if (name !== 'split') dirty.picture = true;
    if (stage.info) stage.shine(set.azimuth, set.height, sunStrength());
    toPanel();
    writeStatus();
    writeAddress();
    request();
}

/* ---- scenes */

/* Opens the address's scene and settings. Those that are refused are reported and stay as they were. */
function goToAddress() {
    notice(...fromAddress());
    const opened = openScene();
    changed();
    return opened;
}

let opening = 0;
async function openScene() {
    const named = name => scenes.find(s => s.name === name), mine = ++opening;
    const info = named(set.scene) ?? named(defaults.scene) ?? scenes[0], { cam } = set;     /* show() looks elsewhere */
    try {
        if (stage.info !== info && told) loading(`Loading ${info.title}`);
        const model = stage.info === info ? null : info.model ?? await readScene(`scenes/${info.name}.bin`);
        if (mine !== opening) return;                   /* another was chosen meanwhile */
        if (told) loading(null);
        if (model) showModel(model, info);
    } catch (e) {
        if (mine !== opening) return;
        loading(null);
        notice(e.message);
        takeLook(stage.info?.name ?? info.name);
        set.scene = stage.info?.name ?? info.name;
        if (stage.info) set.cam = lookedFrom();
        toPanel();
        writeAddress();
        return;
    }
    set.scene = info.name;
    if (cam) {
        const at = cam.split(',').map(Number);
        stage.look(at.slice(0, 3), at.slice(3));
    } else lookHome();
    dirty.scene = dirty.gather = true;
    toPanel();
    request();
}

async function openFiles(files) {
    const mine = ++opening, name = files.length > 1 ? `${files.length} files` : files[0].name;
    notice();
    loading(`Reading ${name}`);
    try {
        const { staged, sky, notes } = await readFiles(files,
            share => loading(share < 1 ? `Reading ${name}` : `Opening ${name}`, share < 1 ? share : NaN));
        if (mine !== opening) return;
        if (sky) takeSky(sky);
        if (staged) takeModel(staged);
        changed(staged ? 'scene' : 'sky');
        notice(...notes);
    } catch (e) {
        if (mine !== opening) return;
        notice(e.message);
        if (stage.info?.name !== set.scene) openScene();    /* this cancelled its opening */
    } finally {
        if (mine === opening) loading(null);
    }
}

function takeModel({ model, info }) {
    const select = panel.elements.scene;
    if (!scenes.some(s => s.name === 'file')) select.add(new Option(info.title, 'file'));
    scenes = [...scenes.filter(s => s.name !== 'file'), Object.assign(info, { model })];
    takeLook('file');
    [...select.options].find(o => o.value === 'file').text = info.title;
    set.scene = 'file';
    showModel(model, info);
    lookHome();
    dirty.scene = true;
}

function takeSky(sky) {
    const select = panel.elements.sky;
    if (!ownSky) select.add(new Option('Opened', 'file'));
    ownSky = sky;
    for (const key of [...environments.keys()].filter(key => /^file( |$)/.test(key))) {
        const made = environments.get(key);
        if (!(made instanceof Float32Array)) drawer.free(made);
        environments.delete(key);
    }
    set.sky = 'file';
}

function showModel(model, info) {
    stage.show(model, info);
    stage.shine(set.azimuth, set.height, sunStrength());
    traced = truthGiven = null;
    truth?.stop();
}

/* The sun is weakened, because strong sunlight would hide the occlusion of the sky's light. */
const sunStrength = () => 0.7 * set.strength;

function lookHome() {
    stage.look(stage.info.eye, stage.info.target);
    set.cam = '';
}

function lookedFrom() {
    const at = v => v.toArray().map(x => +x.toPrecision(6)).join(',');
    return `${at(stage.camera.position)},${at(stage.controls.target)}`;
}

/* ---- inputs of the passes */

const skyImage = name => {
    if (!environments.has(name)) environments.set(name, name === 'file' ? ownSky.rgb : equirect(name, 256, 128));
    return environments.get(name);
};
function cached(key, make) {
    if (!environments.has(key)) environments.set(key, make());
    return environments.get(key);
}
function upload(rgb, n, slices) {
    const rgba = new Float32Array(4 * n * n);
    for (let i = 0; i < n * n; ++i) rgba.set(rgb.subarray(3 * i, 3 * i + 3), 4 * i);
    return drawer.floats(rgba, n, n, slices);
}
const coefficients = bands => cached(`${set.sky} harmonics ${bands}`,
    () => ssgi.projectEquirect(bands, skyImage(set.sky), 256, 128));

function lightOf(desc) {
    const sky = skyImage(set.sky), given = {};
    if (desc.environment === 'MAP') {
        const angle = desc.directions ? 2 * Math.PI / desc.directions : 0.75 * Math.PI / (desc.slices || 1);
        given.ENVIRONMENT = cached(`${set.sky} map ${angle}`,
            () => upload(ssgi.environmentMap(64, sky, 256, 128, angle), 64, 0));
        given.IRRADIANCE = cached(`${set.sky} open`, () => upload(ssgi.environmentCone(32, sky, 256, 128, 0), 32, 1));
    }
    if (desc.pass === 'S3HO')
        given.IRRADIANCE = cached(`${set.sky} residual`, () => upload(
            ssgi.residual(32, ssgi.environmentMap(32, sky, 256, 128, 0), coefficients(4), 4), 32, 1));
    return given;
}

/* Returns the sun as a row of t_ssgi_lights, and its shadow map, which three.js has drawn. */
function sunOf(now) {
    const { toSun, irradiance, projection, size, worldToLight } = stage.sunlight, v = now.toView;
    const at = [0, 1, 2].map(k => v[k] * toSun[0] + v[4 + k] * toSun[1] + v[8 + k] * toSun[2]);
    const map = { view: ssgi.view(projection, size, size), worldToView: v, worldToLight };
    lamps = drawer.floats(ssgi.light({ kind: 'SUN', at, colour: irradiance }, map), 8, 1, 0, lamps ?? undefined);
    return { LIGHTS: lamps };
}
let lamps = null;                                   /* rows of t_ssgi_lights */

const farthestHalf = 65504;                         /* the largest depth that a 16-bit float holds */

const filterOf = desc => desc.filter_radius || (desc.filter === 'GAUSSIAN' ? 2 : 1);

/* Returns a method's chain by the page's settings; own: with the panel's numbers, which replace the preset's. */
function chainOf(name, preset, own) {
    return chainAs(ssgi, set, name, preset, own, { dialect: drawer.dialect, ...size,
                                                   precise: +(stage.info?.far > farthestHalf) });
}

/* Returns any method's chain. Surfels and fields have chains of their own, without settings of noise and filters. */
function chainFor(name, preset, own) {
    if (!methods[name].module) return chainOf(name, preset, own);
    return madeChain(ssgi, name, preset, set, own, { ...size, dialect: '300ES',
                                                     precise: +(stage.info?.far > farthestHalf) });
}

/* Returns the C that makes a side's chain; null: the side has none. */
function codeOf(i) {
    const side = sides[i];
    if (!side) return null;
    const { chain } = side.run, { desc } = chain, method = methods[side.name].title;
    const is = ssgi.resolve(desc), bands = is.environment === 'SH' ? is.bands : 0;
    const made = { [methods[side.name].module]: setOf(side.name, i ? set.q : set.p, set, !i) };
    return cLines(ssgi, chain, { radius: radius(), thickness_limit: thicknessLimit(side.name) * radius(), bands,
                                 ...made, title: `${method} of "${stage.info.title}", as the page shows it` });
}

/* Chains whose programs are being linked: what was shown stays until then. side returns true meanwhile. */
const coming = [null, null];
function side(i, name, preset) {
    const chain = methods[name]?.method ? chainFor(name, preset, i === 0) : null, key = JSON.stringify(chain);
    if (coming[i] && coming[i].key !== key) { coming[i].run.free(); coming[i] = null; }
    if (!chain) {
        forget(sides[i]);
        sides[i] = null;
        return false;
    }
    if (sides[i]?.key === key) return false;
    coming[i] ??= { run: drawer.run(chain), key, name, frames: 0, ms: null, times: [], rested: null };
    if (!coming[i].run.linked) return true;
    forget(sides[i]);
    [sides[i], coming[i]] = [coming[i], null];
    dirty.gather = true;
    writePasses();
    return false;
}

function forget(side) {
    side?.run.free();
    if (side?.rested) drawer.free(side.rested);
}

function view() {
    const { projectionMatrix: p, matrixWorld: m, matrixWorldInverse: v } = stage.camera, { width, height } = size;
    const e = m.elements, q = p.elements;
    return { made: ssgi.view(q, width, height), projection: [...q], width, height,
             toView: Float32Array.from(v.elements),
             world: Float32Array.from([e[0], e[1], e[2], e[4], e[5], e[6], e[8], e[9], e[10]]),
             eye: [e[12], e[13], e[14]],
             ray: [2 / (width * q[0]), 2 / (height * q[5]), (q[8] - 1) / q[0], (q[9] - 1) / q[5]] };
}

function frameOf(side, now) {
    const frame = ssgi.frame(now.made, radius()), desc = ssgi.resolve(side.run.chain.desc), v = now.toView;
    frame.thickness_limit[0] = thicknessLimit(side.name) * radius();
    for (let column = 0; column < 3; ++column)
        for (let row = 0; row < 3; ++row) frame.rotation[4 * column + row] = v[4 * column + row];
    if (side.run.chain.lights) frame.lights[0] = 1;
    if (desc.environment === 'SH') ssgi.harmonics(frame, coefficients(desc.bands), desc.bands, v);
    if (desc.pass === 'DSS') {
        const { size, epsilon } = side.about;
        ssgi.surfels(frame, now.made, { size, max_distance: radius() });
        frame.epsilon[0] = epsilon;
    }
    if (side.run.chain.history) {
        if (side.frames && last && last.width === now.width) ssgi.history(frame, last.made, v, last.toView);
        frame.phase[0] = ssgi.phase(side.frames);
    }
    return frame;
}

/* ---- the frame */

function fit() {
    const box = $('picture').getBoundingClientRect();
    let width, height;
    /* without a GPU the first image has half the width and height, so that it is there sooner */
    const early = software && !told ? 0.5 : 1;
    if (set.size !== 'auto') [width, height] = set.size.split('x').map(Number);
    else {
        const limit = software ? 960 * 540 : 1920 * 1200, area = Math.max(1, box.width * box.height);
        const scale = Math.min(devicePixelRatio || 1, Math.sqrt(limit / area));
        width = Math.max(16, Math.round(box.width * scale));
        height = Math.max(16, Math.round(box.height * scale));
    }
    width = Math.max(16, Math.round(width * early));
    height = Math.max(16, Math.round(height * early));
    if (width === size.width && height === size.height) return;
    size = { width, height };
    stage.resize(width, height);
    for (const on of [canvas, gpu?.canvas ?? canvas]) on.style.objectFit = set.size === 'auto' ? 'fill' : 'contain';
    last = null;
    dirty.scene = dirty.gather = true;
}

function shownBox() {                    /* returns where the image is within the page, which may show bars beside it */
    const box = canvas.getBoundingClientRect(), scale = Math.min(box.width / size.width, box.height / size.height);
    const width = size.width * scale, height = size.height * scale;
    return { left: box.left + (box.width - width) / 2, width, top: box.top + (box.height - height) / 2, height };
}
function placeSplit() {
    const box = shownBox(), frame = $('picture').getBoundingClientRect();
    $('split').style.left = `${box.left - frame.left + set.split * box.width}px`;
    placeWorst();
}

let failure = null;                                 /* of the last picture */
function request() { pending ||= requestAnimationFrame(frame); }

function frame() {
    pending = 0;
    if (!stage.info) return;
    try {
        if (draw()) first();
    } catch (e) {
        failure = e;
        notice(e.message);
        console.error(e);
    }
}

function draw() {
    fit();
    placeMover();
    if (side(0, set.a, set.p) | side(1, set.b, set.q) | !made()) {
        request();
        return false;
    }
    animate();
    const gather = dirty.gather, again = averages() && still < settled && !moving();
    if (gather || again || dirty.scene || dirty.picture || buffers.backs < backs()) drawCalm(gather, again);
    else if (samples < wantedSamples()) drawSample();
    else placeAgain();
    if (set.b !== 'off') placeSplit();
    ++frames;
    takeTimes();
    if (moving() || (averages() && still < settled) || samples < wantedSamples()) request();
    if (gather && !moving()) {
        clearTimeout(rested);
        rested = setTimeout(rest, software ? 350 : 200);
    }
    if (gather) clearTimeout(tracing);
    if (wantsTruth() && !traced && !moving() && (gather || !tracing)) tracing = setTimeout(beginTruth, 120);
    return true;
}

/* Returns whether the surfels and fields of both sides are ready; asks for them if something has changed. */
function made() {
    const of = [[set.a, set.p], [set.b, set.q]].filter(([name]) => methods[name]?.module);
    [set.a, set.b].forEach((name, i) => makers.leave(i, name));
    if (!of.length || !(dirty.gather || makers.busy)) return true;
    stage.jitter(0, 0);
    const now = view();
    return [[set.a, set.p], [set.b, set.q]]
        .map(([name, preset], i) => makers.ready(i, name, aboutOf(i, name, preset, now))).every(Boolean);
}
function aboutOf(i, name, preset, now) {
    return { stage, now, radius: radius(), ...(methods[name]?.module && setOf(name, preset, set, i === 0)) };
}

/* The number of layers of back faces that the passes read. */
const backs = () => (set.thickness === 'SLABS' ? 3 : +(set.thickness === 'BACK'));
const gbuffer = () => (gpu ? gpu.draw(stage, backs(), size) : stage.draw(backs()));

/* Returns the number of images whose mean smooths edges at rest; the ground truth shows pixels' centres alone. */
function wantedSamples() {
    if (moving() || set.view === 'difference' || set.b === 'truth') return 0;
    return !software ? 32 : uses('dss') ? 0 : 8;
}

function drawCalm(gather, again) {
    if (samples || dirty.scene || buffers.backs < backs()) {
        stage.jitter(0, 0);
        buffers = gbuffer();
    }
    if (gather) { still = 0; truth?.stop(); traced = null; errors = {}; tracing = 0; }
    const now = view();
    if (gather || again) {
        for (const side of sides) if (side?.rested) { drawer.free(side.rested); side.rested = null; }
        drawSides(now);
        ++still;
    }
    samples = 0;
    dirty = { scene: false, gather: false, picture: false };
    calm = now;
    present(now);
    if (again && !gather) score();
}

/* Draws one more image, moved by less than a pixel: edges change, and the pixels that half resolution gathers. */
function drawSample() {
    if (!samples) sides.forEach(keepRested);
    stage.jitter(radicalInverse(samples + 1, 2) - 0.5, radicalInverse(samples + 1, 3) - 0.5);
    buffers = gbuffer();
    const now = view();
    drawSides(now);
    ++samples;
    present(now);
}

function radicalInverse(i, base) {
    let sum = 0;
    for (let share = 1 / base; i; i = Math.floor(i / base), share /= base) sum += share * (i % base);
    return sum;
}

/* Keeps the result without a subpixel offset, of which errors are computed. */
function keepRested(side) {
    if (!side || side.rested) return;
    side.rested = drawer.copy(side.run.light, side.run.format, size.width, size.height);
}

function drawSides(now) {
    const from = stage.reprojection(), moved = sides.some(s => s?.run.chain.desc.motion);
    const given = { ...buffers };
    if (moved) given.MOTION = show.motion(size.width, size.height, buffers, from);
    if (sides.some(s => s?.run.chain.lights)) Object.assign(given, sunOf(now));
    if (sides.some(s => s?.run.chain.desc.objects)) given.OBJECTS = show.objects(size.width, size.height, buffers);
    for (const [i, side] of sides.entries()) {
        if (!side) continue;
        side.about = aboutOf(i, side.name, i ? set.q : set.p, now);
        side.given = { ...given, ...lightOf(side.run.chain.desc),
                       ...makers.of(i, side.name)?.given(side.about, side.run.steps) };
        side.frame = frameOf(side, now);
        side.run.draw(side.given, side.frame, drawer.timer ? 1 : 0);
        if (side.run.chain.history) side.run.turn();
        ++side.frames;
        if (!side.rested) side.pixels = null;
    }
    last = now;
}

/* ---- what moves */

let then = 0, seconds = 0, times = [];
function animate() {
    const time = performance.now(), passed = Math.min(0.1, (time - then) / 1000);
    then = time;
    times = moving() ? [...times.filter(t => time - t < 1000), time] : [];
    if (!moving()) return;
    if (set.moves) stage.move(seconds += passed);
    if (set.circle) stage.circle(0.15 * passed);
    dirty.scene = dirty.gather = true;
}

/* Shows the moving object if it moves or if its field is drawn; else removes it. */
let placed = null;
function placeMover() {
    const wanted = set.moves || (uses('aof') && stage.info.name !== 'file');
    if (wanted === !!stage.mover && (!wanted || placed === stage.info)) return;
    stage.move(wanted ? seconds : null);
    placed = stage.info;
    dirty.scene = dirty.gather = true;
}

const splitAt = () => (set.b === 'off' ? 1e6 : set.split * size.width);

function present(now) {
    const light = sides.some(s => s && methods[s.name].light), kind = (s, name) => name === 'truth' ? 4 : !s ? 0
        : !methods[s.name].light ? 1 : s.run.bounce ? 3 : 2;
    const shown = (s, name) => ({ t_light: (set.view === 'difference' && s?.rested) || s?.run.light,
                                  t_bounce: s?.run.bounce, kind: kind(s, name),
                                  sun: +(set.sun && !lightsOf(set, name) && !(name === 'truth' && light && lit())) });
    show.draw(size.width, size.height, {
        t_depth: buffers.DEPTH, t_normal: buffers.NORMAL, t_albedo: buffers.ALBEDO, t_direct: buffers.DIRECT,
        t_truth: truthTexture()
    }, [shown(sides[0], set.a), set.b === 'off' ? null : shown(sides[1], set.b)],
    { sky: coefficients(3), world: now.world, ray: now.ray, light: +light, range: 0.4, decode: decodeOf(),
      view: views.indexOf(set.view), split: splitAt(), exposure: 0.45 * 2 ** set.exposure,
      effect: set.effect, step: truth?.step || 1, rough: +!!truth?.rough }, samples);
}

/* Returns a and b of 1 / view depth = a + b * window depth, which holds for any planes. */
function decodeOf() {
    const { elements: p } = stage.camera.projectionMatrix;
    return [(p[10] - 1) / p[14], 2 / p[14]];
}

/* Takes the times of passes, which arrive some frames later; shows the median of the last ones. */
function takeTimes() {
    let waits = false;
    for (const side of sides) {
        if (side?.run.poll()) keepTimes(side, side.run.ms);
        waits ||= !!side?.run.waiting;
    }
    if (moving()) writeStatus();
    if (waits && !pending) setTimeout(takeTimes, 30);
}
let wrote = 0;
function keepTimes(side, ms) {
    side.times = [...side.times, ms].slice(-kept);
    side.ms = ms.map((_, k) => side.times.map(all => all[k]).sort((x, y) => x - y)[side.times.length >> 1]);
    if (performance.now() - wrote < 250 && side.times.length > 1) return;
    wrote = performance.now();
    writePasses();
}

/* Called some time after the last change; if there is no GPU timer, it times the passes by the clock. */
let rested = 0, tracing = 0;
function rest() {
    rested = 0;
    clockless = !drawer.timer;
    if (!clockless || gpu) return;
    if (pending) { rested = setTimeout(rest, 100); return; }
    for (const side of sides) if (side) clock(side);
    writePasses();
}

function clock(side) {
    const { run } = side;
    if (run.chain.history) run.turn();                    /* the last frame's history is written again */
    const all = [];
    for (let i = 0; i < 3; ++i) { run.draw(side.given, side.frame, 2); all.push([...run.ms]); }
    side.ms = all[0].map((_, k) => all.map(ms => ms[k]).sort((x, y) => x - y)[1]);
    if (run.chain.history) run.turn();
}

/* Called when a side's surfels or fields have changed, or cannot be made. */
function remade(i, error) {
    const name = i ? 'b' : 'a';
    if (error && methods[set[name]]?.module) {
        choose(name, 'none');
        notice(error.message);
    }
    dirty.gather = true;
    request();
}

/* ---- truth */

let truthMade = null, truthGiven = null;
async function beginTruth() {
    const { Truth } = await import('./truth.mjs');
    if (!wantsTruth() || traced || moving() || !calm) return;
    truth ??= new Truth((error, shown) => {
        if (error) { notice(error.message); return; }
        writeStatus();
        if (!shown) return;
        truthMade = null;
        score();
        if (set.b === 'truth' || set.view === 'difference') dirty.picture = true;
        request();
    });
    const shown = `${stage.info.key} ${stage.mover?.now.elements}`;
    if (truthGiven !== shown) {
        truthGiven = shown;
        truth.scene(stage.everything());
    }
    traced = calm;
    truth.start({ width: size.width, height: size.height, radius: radius(), most,
                  sky: set.sky === 'file' ? ownSky : set.sky, sun: lit() ? stage.sunlight : null,
                  camera: { eye: calm.eye, world: calm.world, ray: calm.ray } });
    writeStatus();
}
let truthHeld = null;
function truthTexture() {
    if (!traced || !truth?.step) return null;
    if (truthMade) return truthMade;
    const { width, height } = truth;
    if (truthHeld?.width !== width || truthHeld.height !== height) {
        if (truthHeld) drawer.free(truthHeld.texture);
        truthHeld = { width, height };
    }
    return truthMade = truthHeld.texture = drawer.floats(truth.texels(), width, height, 0, truthHeld.texture);
}

/* Returns a side's result: ambient visibility, one number a pixel, or light, four; bottom row first. */
function pixelsOf(side) {
    if (side.pixels) return side.pixels;
    const { width, height } = size, { light } = methods[side.name];
    const take = all => side.pixels = light ? all : Float32Array.from({ length: width * height }, (_, i) => all[4 * i]);
    const got = drawer.read(side.rested ?? side.run.light, side.run.format, width, height);
    return got.then?.(take) ?? take(got);           /* WebGPU's comes later */
}

function score() {
    errors = {};
    sides.forEach(async (s, i) => {
        if (!s || !traced || !truth.rays) return;
        const of = traced, pixels = pixelsOf(s), is = gpu ? await pixels : pixels;
        if (sides[i] !== s || traced !== of) return;
        errors[i] = truth.score(is, methods[s.name].light ? 3 : 1, size.width, splitAt());
        if (gpu) writeStatus();
    });
    writeStatus();
}

/* Returns the G-buffer as an EXR for build/render --gbuffer, with the camera; OpenEXR's camera looks down +z. */
function frameFile() {
    stage.jitter(0, 0);
    const drawn = stage.draw(backs());
    if (!gpu) buffers = drawn;
    else stage.renderer.shadowMap.needsUpdate = true;
    dirty.picture = true;
    request();
    const { projectionMatrix, matrixWorldInverse } = stage.camera, p = projectionMatrix.elements;
    const { width, height } = size, worldToCamera = matrixWorldInverse.elements.map((v, i) => i % 4 === 2 ? 0 - v : v);
    const [x, y, z] = stage.info.origin ?? [0, 0, 0], far = x || y || z;
    for (let i = 12; i < 15; ++i)                       /* moves the camera's matrix to the model's own origin */
        worldToCamera[i] -= x * worldToCamera[i - 12] + y * worldToCamera[i - 8] + z * worldToCamera[i - 4];
    const precise = far ? { 'ssgi.worldToCamera': new Float64Array(worldToCamera) } : {};
    const channels = own.show.frame(width, height, drawn, decodeOf());
    return exr(width, height, channels,
               { screenWindowWidth: 2 / p[0], worldToCamera, ...precise, 'ssgi.radius': radius() });
}

/* ---- WebGPU instead of WebGL 2, by the same steps */

let choosing = 0;
async function chooseGpu(wanted) {
    const mine = ++choosing;
    let made = null;
    const alone = [set.a, set.b].find(name => methods[name]?.module);
    if (wanted && alone) {
        notice(`${methods[alone].title} is not in WebGPU: WebGL 2 draws`);
        $('webgpu-box').checked = false;
        return;
    }
    if (wanted) {
        if (told) loading('Opening WebGPU');
        made = await import('./webgpu-canvas.mjs').then(({ open }) => open(ssgi, canvas, lost => {
            drawBy(null);
            notice(lost);
        })).catch(e => notice(e.message));
        if (told) loading(null);
        if (mine !== choosing) { made?.close(); return; }
    } else notice();
    drawBy(made ?? null);
}

/* Returns why WebGPU cannot draw a method; falsy: it can. */
function lacksOf(name) {
    if (methods[name]?.module) return 'is not in WebGPU';
    return methods[name]?.method && gpu.drawer.lacks(chainOf(name, set.p, false));
}

/* Changes to WebGPU (made) or WebGL 2 (null), and frees the textures and programs of the one before. */
function drawBy(made) {
    for (const run of [...sides, ...coming]) forget(run);
    sides.fill(null);
    coming.fill(null);
    for (const [key, is] of environments)
        if (!(is instanceof Float32Array)) { drawer.free(is); environments.delete(key); }
    if (truthHeld) drawer.free(truthHeld.texture);
    truthHeld = truthMade = null;
    if (lamps) drawer.free(lamps);
    lamps = null;
    if (gpu !== made) gpu?.close();
    gpu = made;
    ({ drawer, show } = gpu ?? own);
    samples = 0;
    last = null;
    dirty = { scene: true, gather: true, picture: true };
    stage.renderer.shadowMap.needsUpdate = true;
    if (gpu) gpu.canvas.style.objectFit = canvas.style.objectFit;
    $('device').textContent = gpu?.name ?? own.name;
    $('webgpu-box').checked = !!gpu;
    $('read').textContent = `Read ${drawer.language} and C`;
    $('copy-glsl').textContent = `Copy the ${drawer.language}`;
    for (const select of [panel.elements.a, panel.elements.b])
        for (const option of select.options) {          /* methods that only WebGL 2 has are grey, and say why */
            const lacks = gpu && lacksOf(option.value);
            option.disabled = !!lacks;
            option.title = lacks ? `${methods[option.value].title} ${lacks}: draw it with WebGL 2` : '';
        }
    history.replaceState(null, '', `${location.pathname}${gpu ? '?webgpu' : ''}${location.hash}`);
    request();
}

/* ---- what is written */

const sum = ms => ms.reduce((all, one) => all + one, 0);
function writeStatus() {
    const ms = sides.filter(s => s?.ms).map(s => `${digits(sum(s.ms))} ms`);
    const clock = software ? 'in software' : clockless ? 'by the CPU’s clock' : 'on the GPU';
    const found = [0, 1].filter(i => errors[i]).map(i => errors[i]);
    const shares = found.filter(({ none }) => none).map(({ rmse, none }) => `${(100 * rmse / none).toFixed(0)} %`);
    const nones = new Set(found.map(({ none }) => none?.toFixed(4)));   /* light and visibility have their own */
    const paused = wantsTruth() && moving();
    $('cost').textContent = ms.join(' | ');
    $('clock').textContent = ms.length ? clock : '';
    $('rate').textContent = times.length > 1 ? `${times.length} frames/s` : '';
    $('error').textContent = !found.length ? '' : `RMSE ${found.map(({ rmse }) => rmse.toFixed(4)).join(' | ')}`
        + (shares.length ? `, ${shares.join(' | ')} of no occlusion’s ${[...nones].join(' | ')}` : '');
    $('legend').hidden = set.view !== 'difference';
    const which = { 1: 'a pixel', 2: 'at every 2nd pixel', 4: 'at every 4th pixel' }[truth?.step];
    $('rays').textContent = paused ? 'no rays while something moves' : !traced ? ''
        : truth.rays ? `${truth.rays} rays ${which}${truth.rough ? ', smoothed' : ''}` : 'tracing';
    const share = traced ? truth.share : 1;
    $('ring').hidden = share >= 1;
    $('ring').style.setProperty('--share', share.toFixed(3));
    placeWorst();
    writeHere();
    $('status').hidden = !ms.length && !traced && !paused && $('legend').hidden && times.length < 2;
}
/* Shows the result at the pixel under the pointer, for the side that is there, and its ground truth. */
let pointer = null;
function writeHere() {
    const box = shownBox(), x = Math.floor((pointer?.clientX - box.left) / box.width * size.width);
    const y = Math.floor((1 - (pointer?.clientY - box.top) / box.height) * size.height);
    const seen = traced && x >= 0 && y >= 0 && x < size.width && y < size.height ? truth.at(x, y) : null;
    const mean = v => (v[0] + v[1] + v[2]) / 3, light = sides.some(s => s && methods[s.name].light);
    const side = +(x > splitAt()), { pixels, name } = sides[side] ?? {}, i = y * size.width + x;
    const is = !pixels?.length ? set[side ? 'b' : 'a'] === 'none' && !light ? 1 : NaN
        : methods[name].light ? mean(pixels.subarray(4 * i)) : light ? NaN : pixels[i];
    $('here').textContent = !seen ? '' : `${Number.isNaN(is) ? '' : `here ${is.toFixed(3)}, `}truth ${
        (light ? mean(seen.light) : seen.visibility).toFixed(3)} ± ${seen.off.toFixed(3)}`;
}
/* Marks the pixel of the left side whose error is the largest beyond doubt. */
function placeWorst() {
    const { worst } = errors[0] ?? {}, box = shownBox(), frame = $('picture').getBoundingClientRect();
    $('worst').hidden = set.view !== 'difference' || !worst || worst.x > splitAt();
    if ($('worst').hidden) return;
    $('worst').style.left = `${box.left - frame.left + (worst.x + 0.5) / size.width * box.width}px`;
    $('worst').style.top = `${box.top - frame.top + (1 - (worst.y + 0.5) / size.height) * box.height}px`;
    $('worst').textContent = `worst ${worst.off < 0 ? '−' : '+'}${Math.abs(worst.off).toFixed(2)}`;
}
function writePasses() {
    const rows = [];
    sides.forEach((side, i) => side?.run.steps.forEach((step, k) => {
        const row = document.createElement('tr');
        const cells = [(sides[0] && sides[1] ? i ? 'right: ' : 'left: ' : '') + step.desc.pass.toLowerCase(),
                       `${step.width}×${step.height}`, step.outputs.map(o => o.format.name).join(' '),
                       side.ms?.[k] === undefined ? '–' : digits(side.ms[k])];
        cells.forEach(text => { row.insertCell().textContent = text; });
        rows.push(row);
    }));
    $('passes').tBodies[0].replaceChildren(...rows);
    $('passes').hidden = !rows.length;
    $('timer-note').textContent = !rows.length ? '' : gpu ? drawer.clock : clockless
        ? 'No EXT_disjoint_timer_query_webgl2 here: the CPU’s clock around each pass and a wait for it '
            + '(gl.finish and a pixel read back), median of 3.'
        : `Timed by EXT_disjoint_timer_query_webgl2, median of the last ${kept} frames.`;
    writeStatus();
}

function texts() {
    const all = [];
    sides.forEach((side, i) => {
        if (side) all.push({ name: `${sides[0] && sides[1] ? `${i ? 'right' : 'left'}: ` : ''}in C`, text: codeOf(i) });
    });
    const glsl = glslTexts();
    return [...all, ...glsl];
}
function glslTexts() {
    const all = [];
    sides.forEach((side, i) => side?.run.steps.forEach(step => {
        for (const stage of ['frag', 'vert']) {
            const text = drawer.shader(step.desc, stage);
            const name = `${step.desc.pass.toLowerCase()}.${stage}${gpu ? '.wgsl' : ''}`;
            if (text && !all.some(t => t.text === text))
                all.push({ name: sides[0] && sides[1] ? `${i ? 'right' : 'left'}: ${name}` : name, text });
        }
    }));
    return all;
}
function chainShown(i) {
    const { name, run: { chain, steps } } = sides[i];
    return { chain, steps: steps.map(step => step.desc.pass), given: [radius(), thicknessLimit(name) * radius()],
             list: steps.map(step => `${step.desc.pass.toLowerCase()}:${step.width}x${step.height}:${
                 ssgi.key(step.desc)}`) };
}

function readText() {
    const all = texts();
    options($('text-which'), all.map(({ name }, i) => [i, name]));
    $('text-which').value = Math.max(0, all.findIndex(({ name }) => !name.endsWith('in C')));
    $('text').showModal();
    showText();
}
function showText() {
    const { text = 'No pass is drawn.' } = texts()[+$('text-which').value] ?? {}, pre = $('text').querySelector('pre');
    pre.textContent = text;
    pre.scrollTop = 0;
    $('text-size').textContent = `${text.split('\n').length - 1} lines, ${
        text.startsWith('#version') ? 'GLSL 300 es, as it is compiled'
            : text.startsWith('/*') ? 'C, behind ssgi_gl.h' : 'WGSL, as it is compiled'}`;
}

/* ---- begin */

let told = false, whole = false;                    /* told: the first image was shown; whole: at its full size */
function first() {
    if (whole) return;
    /* reading a pixel waits until the image is drawn */
    if (!gpu) gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    performance.mark(told ? 'in its size' : 'first picture');
    whole = told || !software;
    if (told) return;
    told = true;
    page.first = performance.now();
    loading(null);
    showThumbs();
    toPanel();
    request();
}

/* For scripts: make web-test waits for these, and reads results. */
const page = globalThis.page = { set, first: null, lacks: null, result,
                                 error: i => errors[i]?.rmse ?? null,
                                 rays: () => (truth?.step === 1 ? truth.rays : 0), truth: () => truth,
                                 settled: () => !averages() || still >= settled,
                                 making: () => makers.busy,
                                 resting: () => wantedSamples() > 0,
                                 smooth: () => samples > 0 && samples >= wantedSamples(),
                                 code: codeOf, chain: chainShown,
                                 inside: () => ({ stage, show, buffers, size, gl, gpu, sky: () => coefficients(3) }),
                                 frame: frameFile,
                                 limits, picture, webgpu: chooseGpu };
/* Takes the settings of an address; resolves when they are drawn. */
page.go = async hash => {
    history.replaceState(null, '', '#' + hash);
    await goToAddress();
    changed();
    const was = frames;
    failure = null;
    const waits = () => frames === was || (!moving() && (makers.busy || dirty.gather));
    while (waits() && !failure) await new Promise(requestAnimationFrame);
    if (failure) throw failure;
};

/* Returns the canvas's pixels, four bytes each; draws again, because browsers do not keep them. */
function picture() {
    if (gpu) return gpu.pixels(...placing());
    const all = new Uint8Array(4 * size.width * size.height);
    placeAgain();
    gl.readPixels(0, 0, size.width, size.height, gl.RGBA, gl.UNSIGNED_BYTE, all);
    return all;
}
function placeAgain() {
    show.place(...placing());
}
function placing() {
    return [size.width, size.height, splitAt(), samples > 0 || set.view === 'difference', samples];
}
function result(i) {
    const of = { ...size }, pixels = pixelsOf(sides[i]);
    return pixels.then?.(all => ({ ...of, pixels: all })) ?? { ...of, pixels };
}
async function savePicture() {
    while (!whole) await new Promise(requestAnimationFrame);    // the first image is smaller
    placeAgain();
    (gpu?.canvas ?? canvas).toBlob(blob => { if (blob) saved('ssgi.png', blob); });
}

/* The attributes of a WebGL context that three.js would ask for: three.js is given this context. */
const contextLike = { alpha: true, depth: true, stencil: false, antialias: false, premultipliedAlpha: true,
                      preserveDrawingBuffer: false, powerPreference: 'high-performance' };
function lacks() {
    const probe = canvas.getContext('webgl2', contextLike);
    if (!probe) return 'This browser or device has no WebGL 2, which every pass here is written for.';
    const half = probe.getExtension('EXT_color_buffer_float') || probe.getExtension('EXT_color_buffer_half_float');
    const missing = half ? null : 'This device cannot draw into floating-point textures (no EXT_color_buffer_float, no '
        + 'EXT_color_buffer_half_float); the passes between gather and filter need 16 bits.';
    const info = probe.getExtension('WEBGL_debug_renderer_info');
    const name = probe.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : probe.RENDERER);
    software = /swiftshader|llvmpipe|software|basic render/i.test(name);
    $('device').textContent = name + (software ? ': a software renderer; the picture has 960×540 pixels at most' : '');
    return missing;
}

/* Shows small images of the scenes, which make web drew. */
function showThumbs() {
    $('thumbs').replaceChildren(...scenes.filter(s => s.picture).map(({ name, title, picture }) => {
        const button = document.createElement('button'), image = new Image(96, 60);
        Object.assign(button, { type: 'button', value: name, title });
        Object.assign(image, { src: `scenes/${picture}`, alt: title, loading: 'lazy' });
        button.append(image);
        return button;
    }));
}

async function start() {
    page.lacks = lacks();
    if (page.lacks) { loading(null); notice(page.lacks); return; }
    const [{ Stage }, model, wasm, list] = await Promise.all([
        import('./stage.mjs'), import('./model.mjs'), load(),
        fetchFile('scenes/scenes.json').then(answer => answer.json())]);
    ({ readScene, readFiles } = model);
    ssgi = wasm;
    scenes = list;
    stage = new Stage(canvas);
    gl = stage.gl;
    drawer = new Drawer(gl, ssgi);
    show = new Show(gl, drawer);
    own = { drawer, show, name: $('device').textContent };
    const named = Object.entries(methods).map(([name, { title }]) => [name, title]);
    const words = {
        scene: scenes.map(s => [s.name, s.title]), a: named, size: [['auto', 'as shown'], ...sizes.map(s => [s, s])],
        sky: Object.entries(skies).map(([name, { title }]) => [name, title]),
        b: [['off', 'the same'], ...named, ['truth', 'truth, ray-traced']]
    };
    for (const [name, all] of Object.entries({ p: presets, q: presets, thickness: thicknesses, resolution: resolutions,
                                               shadow: shadows, normals })) words[name] = Object.entries(all);
    for (const [name, all] of Object.entries(words)) options(panel.elements[name], all);
    makers = new Makers({ gl, drawer, ssgi, loading }, remade);
    for (const control of panel.elements) {
        if (control.type !== 'range') continue;
        control.min = settings[control.name].least;
        control.max = settings[control.name].most;
    }
    const given = new URLSearchParams(location.hash.slice(1)), calmly = matchMedia('(prefers-reduced-motion: reduce)');
    notice(...fromAddress());
    if (!software && !calmly.matches && !['circle', 'cam', 'b', 'view', 'truth'].some(name => given.has(name)))
        set.circle = true;
    page.bar = bar(ssgi, set, { choose, home: () => $('home').click(), save: savePicture, fit: request });
    listen();
    panel.inert = false;
    fit();
    if (new URLSearchParams(location.search).has('webgpu')) await chooseGpu(true);
    side(0, set.a, set.p);                          /* links programs while the scene is fetched */
    side(1, set.b, set.q);
    await openScene();
}

start().catch(e => { loading(null); notice(e.message); console.error(e); });
