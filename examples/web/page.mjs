/* page.mjs - the page: settings, the frame, what is written beside it. What is drawn of the library is in steps.mjs. */
import { load } from './ssgi.mjs';
import { skies, equirect } from './sky.mjs';
import { Drawer } from './steps.mjs';
import { Show } from './show.mjs';
import { exr } from './exr.mjs';

const $ = id => document.getElementById(id), panel = $('panel'), canvas = $('canvas');
const methods = {
    none: { title: 'no occlusion' },
    ssao: { title: 'SSAO', desc: { pass: 'SSAO' }, thickness: 1 },
    hsao: { title: 'HSAO', desc: { pass: 'HSAO' }, thickness: 0.6 },
    march: { title: 'HSAO, march', desc: { pass: 'HSAO', search: 'MARCH' }, thickness: 0.5 },
    ssdo: { title: 'SSDO', desc: { pass: 'SSDO', environment: 'MAP' }, thickness: 0.4, light: true },
    points: { title: 'SSDO, points', desc: { pass: 'SSDO', search: 'POINTS', environment: 'MAP' }, thickness: 1,
              light: true },
    s3ho: { title: 'S3HO', desc: { pass: 'S3HO', environment: 'SH', bands: 4, shaded: 1, residual: 1,
                                   restore: 'RATIO' }, thickness: 0.4, light: true }
};
const presets = { FAST: 'fast', BALANCED: 'balanced', BEST: 'best' };
const defaults = { scene: 'room', sky: 'sky', sun: true, view: 'lit', a: 'hsao', p: 'BALANCED', b: 'none',
                   q: 'BALANCED', radius: 0, behind: 'CONSTANT', thickness: -1,
                   normals: 'SIGNED', history: false, bounce: false,
                   size: 'auto', truth: false, split: 0.5, cam: '' };
const set = { ...defaults };
const most = 4096;                                  /* rays a pixel, after which the truth is left alone */

let ssgi, stage, drawer, show, truth, scenes = [], gl, software = false;
let sides = [null, null];                           /* { run, key, frame number, .. } left and right */
let buffers = null, size = { width: 0, height: 0 }, last = null, pending = 0, still = 0, frames = 0;
let dirty = { scene: true, gather: true }, traced = null, clockless = false, environments = new Map(), errors = {};

/* ---- settings: in the address, in the panel */

function fromAddress() {
    const given = Object.fromEntries(new URLSearchParams(location.hash.slice(1)));
    Object.assign(set, defaults);
    for (const [name, value] of Object.entries(given)) {
        if (!(name in defaults)) continue;
        const kind = typeof defaults[name];
        if (kind === 'boolean') set[name] = value === '1';
        else if (kind === 'number') set[name] = Number.isFinite(+value) ? +value : defaults[name];
        else set[name] = value;
    }
    if (!methods[set.a]) set.a = defaults.a;
    if (!methods[set.b] && set.b !== 'truth' && set.b !== 'off') set.b = defaults.b;
    for (const name of ['p', 'q']) if (!presets[set[name]]) set[name] = 'BALANCED';
    if (!skies[set.sky]) set.sky = 'sky';
    if (!['lit', 'ambient', 'difference'].includes(set.view)) set.view = 'lit';
    if (!['CONSTANT', 'SOLID', 'BACK'].includes(set.behind)) set.behind = 'CONSTANT';
    if (!['SIGNED', 'FROM_DEPTH'].includes(set.normals)) set.normals = 'SIGNED';
    if (!/^(auto|\d{2,4}x\d{2,4})$/.test(set.size)) set.size = 'auto';
    set.radius = Math.min(2, Math.max(-2, set.radius));
    set.split = Math.min(1, Math.max(0, set.split));
}
function address() {
    const short = value => (typeof value === 'string' ? value : +Number(value).toFixed(3));
    return Object.entries(set).filter(([name, value]) => value !== defaults[name])
        .map(([name, value]) => `${name}=${short(value)}`).join('&');
}
let addressed = 0;
function writeAddress() {
    clearTimeout(addressed);
    addressed = setTimeout(() => history.replaceState(null, '', '#' + address()), 250);
}
const radius = () => stage.info.radius * 2 ** set.radius;
const thickness = method => set.thickness < 0 ? methods[method]?.thickness ?? 0.6 : set.thickness;
const wantsTruth = () => set.truth || set.b === 'truth' || set.view === 'difference';
const digits = v => v >= 100 ? v.toFixed(0) : v >= 10 ? v.toFixed(1) : v.toFixed(2);

function toPanel() {
    for (const control of panel.elements) {
        if (!(control.name in set)) continue;
        const value = set[control.name];
        if (control.type === 'checkbox') control.checked = value;
        else if (control.type === 'radio') control.checked = control.value === value;
        else if (control.name === 'thickness') control.value = thickness(set.a);
        else control.value = value;
    }
    const output = name => panel.elements[name].parentElement.querySelector('output');
    if (stage.info) output('radius').textContent = +radius().toPrecision(2);
    output('thickness').textContent = `${thickness(set.a).toFixed(2)} R`;
    const method = name => !!methods[name]?.desc;
    const on = (of, yes) => panel.querySelectorAll(of).forEach(e => { e.hidden = !yes; });
    on('.of-a', method(set.a));
    on('.of-b', method(set.b));
    on('.of-thickness', set.behind !== 'SOLID');
    on('.of-bounce', [set.a, set.b].some(m => methods[m]?.desc?.pass === 'SSDO'));
    panel.elements.truth.checked = wantsTruth();
    panel.elements.truth.disabled = wantsTruth() && !set.truth;
    const title = (name, preset) => name === 'truth' ? 'truth, ray-traced'
        : methods[name] ? methods[name].title + (method(name) ? ` · ${presets[preset]}` : '') : '';
    $('left-tag').textContent = title(set.a, set.p);
    $('right-tag').textContent = set.b === 'off' ? '' : title(set.b, set.q);
    $('split').hidden = set.b === 'off';
    $('split').style.left = `${100 * set.split}%`;
    $('split').setAttribute('aria-valuenow', Math.round(100 * set.split));
}

function options(select, entries) {
    select.replaceChildren(...entries.map(([value, text]) => new Option(text, value)));
}

function listen() {
    panel.addEventListener('input', ({ target }) => {
        const { name, type } = target;
        if (!(name in set)) return;
        set[name] = type === 'checkbox' ? target.checked : type === 'range' ? +target.value : target.value;
        if (name === 'scene') { set.cam = ''; openScene(); }
        changed(name);
    });
    panel.addEventListener('submit', e => e.preventDefault());
    addEventListener('hashchange', () => { fromAddress(); openScene(); changed(); });
    stage.controls.addEventListener('change', () => {
        const at = v => v.toArray().map(x => +x.toPrecision(6)).join(',');
        set.cam = `${at(stage.camera.position)},${at(stage.controls.target)}`;
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
        const way = { ArrowLeft: -1, ArrowRight: 1 }[e.key], box = shownBox();
        if (way) move(box.left + (set.split + way * 0.02) * box.width);
    });
    $('home').onclick = () => { set.cam = ''; stage.look(stage.info.eye, stage.info.target); set.cam = ''; };
    $('open').onclick = () => $('file').click();
    $('file').onchange = ({ target }) => { if (target.files[0]) openFile(target.files[0]); target.value = ''; };
    const drop = $('drop');
    addEventListener('dragover', e => { e.preventDefault(); drop.hidden = false; });
    addEventListener('dragleave', e => { if (!e.relatedTarget) drop.hidden = true; });
    addEventListener('drop', e => {
        e.preventDefault();
        drop.hidden = true;
        if (e.dataTransfer.files[0]) openFile(e.dataTransfer.files[0]);
    });
    $('link').onclick = async () => {
        clearTimeout(addressed);
        history.replaceState(null, '', '#' + address());
        await copied($('link'), location.href);
    };
    $('read').onclick = readText;
    $('save').onclick = () => {
        const link = document.createElement('a');
        link.href = URL.createObjectURL(new Blob([frameFile()], { type: 'image/x-exr' }));
        link.download = 'frame.exr';
        link.click();
        setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    };
    $('text-which').onchange = showText;
    $('text-close').onclick = () => $('text').close();
    $('text').onclick = e => { if (e.target === $('text')) $('text').close(); };
    $('text-copy').onclick = () => copied($('text-copy'), $('text').querySelector('pre').textContent);
    canvas.addEventListener('webglcontextlost', e => {
        e.preventDefault();
        notice('The device lost its WebGL context. Reload the page.');
    });
}

async function copied(button, text) {
    const was = button.textContent;
    try { await navigator.clipboard.writeText(text); button.textContent = 'Copied'; }
    catch { button.textContent = 'Cannot copy'; }
    setTimeout(() => { button.textContent = was; }, 1200);
}

function notice(sentence) {
    $('notice').hidden = !sentence;
    $('notice').textContent = sentence ?? '';
}

function changed(name) {
    if (name !== 'split' && name !== 'view' && name !== 'truth' && name !== 'sun') dirty.gather = true;
    if (name === 'sun') dirty.gather ||= set.bounce;
    still = 0;
    toPanel();
    writeStatus();
    writeAddress();
    request();
}

/* ---- scenes */

let opening = 0;
async function openScene() {
    const named = name => scenes.find(s => s.name === name), mine = ++opening;
    const info = named(set.scene) ?? named(defaults.scene) ?? scenes[0];
    const looked = set.cam.split(',').map(Number);
    if (stage.info !== info) {
        set.scene = info.name;
        await stage.fetch(info, 'scenes', () => mine === opening);
        if (mine !== opening) return;
        traced = truthGiven = null;
        truth?.stop();
    }
    if (looked.length === 6 && looked.every(Number.isFinite)) stage.look(looked.slice(0, 3), looked.slice(3));
    else { stage.look(info.eye, info.target); set.cam = ''; }
    dirty.scene = dirty.gather = true;
    toPanel();
    request();
}
async function openFile(file) {
    try {
        ++opening;
        notice(null);
        const info = await stage.open(file);
        if (!scenes.some(s => s.name === 'file')) panel.elements.scene.add(new Option(info.title, 'file'));
        scenes = [...scenes.filter(s => s.name !== 'file'), info];
        [...panel.elements.scene.options].find(o => o.value === 'file').text = info.title;
        set.scene = 'file';
        set.cam = '';
        traced = null;
        truth?.stop();
        dirty.scene = true;
        changed('scene');
    } catch (e) { notice(e.message); }
}

/* ---- what the passes are given */

const skyImage = name => {
    if (!environments.has(name)) environments.set(name, equirect(name, 256, 128));
    return environments.get(name);
};
function cached(key, make) {
    if (!environments.has(key)) environments.set(key, make());
    return environments.get(key);
}
function upload(rgb, n, slices) {
    const rgba = new Float32Array(4 * n * n), target = slices ? gl.TEXTURE_2D_ARRAY : gl.TEXTURE_2D;
    for (let i = 0; i < n * n; ++i) rgba.set(rgb.subarray(3 * i, 3 * i + 3), 4 * i);
    const texture = drawer.texture(n, n, { internal: gl.RGBA32F }, slices);
    plainUploads();
    if (slices) gl.texSubImage3D(target, 0, 0, 0, 0, n, n, 1, gl.RGBA, gl.FLOAT, rgba);
    else gl.texSubImage2D(target, 0, 0, 0, n, n, gl.RGBA, gl.FLOAT, rgba);
    return texture;
}
function plainUploads() {                           /* three leaves its own settings behind */
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 4);
    gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, null);
}
const coefficients = bands => cached(`${set.sky} harmonics ${bands}`,
    () => ssgi.projectEquirect(bands, skyImage(set.sky), 256, 128));

function lightOf(desc) {
    const sky = skyImage(set.sky), given = {};
    if (desc.environment === 'MAP') {
        const angle = desc.samples ? 2 * Math.PI / desc.samples : 0.75 * Math.PI / (desc.directions || 1);
        given.ENVIRONMENT = cached(`${set.sky} map ${angle}`,
            () => upload(ssgi.environmentMap(64, sky, 256, 128, angle), 64, 0));
        given.IRRADIANCE = cached(`${set.sky} open`, () => upload(ssgi.environmentCone(32, sky, 256, 128, 0), 32, 1));
    }
    if (desc.pass === 'S3HO')
        given.IRRADIANCE = cached(`${set.sky} residual`, () => upload(
            ssgi.residual(32, ssgi.environmentMap(32, sky, 256, 128, 0), coefficients(4), 4), 32, 1));
    return given;
}

/* The chain of a side, as settings have it. */
function chainOf(name, preset) {
    const { desc } = methods[name], bounce = set.bounce && desc.pass === 'SSDO';
    const d = ssgi.preset({ ...desc, dialect: '300ES', normal: set.normals, behind: set.behind }, preset);
    if (methods[name].desc.restore) d.restore = methods[name].desc.restore;
    return { desc: { ...d, ...(bounce && { bounce: 'SOLID_ANGLE' }) }, width: size.width, height: size.height, blur: 1,
             history: +set.history, direct: +(bounce && set.sun) };
}

/* Until its programs are linked what was shown stays: true. */
const coming = [null, null];
function side(i, name, preset) {
    const chain = methods[name]?.desc ? chainOf(name, preset) : null, key = JSON.stringify(chain);
    if (coming[i] && coming[i].key !== key) { coming[i].run.free(); coming[i] = null; }
    if (!chain) {
        sides[i]?.run.free();
        sides[i] = null;
        return false;
    }
    if (sides[i]?.key === key) return false;
    coming[i] ??= { run: drawer.run(chain), key, name, frames: 0, ms: null };
    if (!coming[i].run.linked) return true;
    sides[i]?.run.free();
    [sides[i], coming[i]] = [coming[i], null];
    dirty.gather = true;
    writePasses();
    return false;
}

function view() {
    const { projectionMatrix: p, matrixWorld: m, matrixWorldInverse: v } = stage.camera, { width, height } = size;
    const e = m.elements, q = p.elements;
    return { made: ssgi.view(q, width, height), toView: Float32Array.from(v.elements), width, height,
             world: Float32Array.from([e[0], e[1], e[2], e[4], e[5], e[6], e[8], e[9], e[10]]),
             eye: [e[12], e[13], e[14]],
             ray: [2 / (width * q[0]), 2 / (height * q[5]), (q[8] - 1) / q[0], (q[9] - 1) / q[5]] };
}

function frameOf(side, now) {
    const frame = ssgi.frame(now.made, radius()), { desc } = side.run.chain, v = now.toView;
    frame.thickness[0] = thickness(side.name) * radius();
    for (let column = 0; column < 3; ++column)
        for (let row = 0; row < 3; ++row) frame.rotation[4 * column + row] = v[4 * column + row];
    if (desc.environment === 'SH') ssgi.harmonics(frame, coefficients(desc.bands), desc.bands, v);
    if (set.history) {
        if (side.frames && last && last.width === now.width) ssgi.history(frame, last.made, v, last.toView);
        frame.phase[0] = ssgi.phase(side.frames);
    }
    return frame;
}

/* ---- the frame */

function fit() {
    const box = $('picture').getBoundingClientRect();
    let width, height;
    if (set.size !== 'auto') [width, height] = set.size.split('x').map(Number);
    else {
        const limit = software ? 960 * 540 : 1920 * 1200, area = Math.max(1, box.width * box.height);
        const scale = Math.min(devicePixelRatio || 1, Math.sqrt(limit / area));
        width = Math.max(16, Math.round(box.width * scale));
        height = Math.max(16, Math.round(box.height * scale));
    }
    if (width === size.width && height === size.height) return;
    size = { width, height };
    stage.resize(width, height);
    canvas.style.objectFit = set.size === 'auto' ? 'fill' : 'contain';
    last = null;
    dirty.scene = dirty.gather = true;
}

function shownBox() {                               /* where the picture is on the page: it may have bars */
    const box = canvas.getBoundingClientRect(), scale = Math.min(box.width / size.width, box.height / size.height);
    const width = size.width * scale;
    return { left: box.left + (box.width - width) / 2, width };
}
function placeSplit() {
    const box = shownBox(), frame = $('picture').getBoundingClientRect();
    $('split').style.left = `${box.left - frame.left + set.split * box.width}px`;
}

function request() { pending ||= requestAnimationFrame(frame); }

function frame() {
    pending = 0;
    if (!stage.info) return;
    try {
        if (draw()) first();
    } catch (e) {
        notice(e.message);
        console.error(e);
    }
}

function draw() {
    fit();
    if (side(0, set.a, set.p) | side(1, set.b, set.q)) {
        request();
        return false;
    }
    const now = view(), gather = dirty.gather;
    if (dirty.scene || (set.behind === 'BACK' && !buffers.BACK)) {
        buffers = stage.draw(set.behind === 'BACK');
        dirty.scene = false;
        still = 0;
    }
    const again = set.history && still < 32;
    if (gather) { still = 0; truth?.stop(); traced = null; errors = {}; }
    if (gather || again)
        for (const side of sides) {
            if (!side) continue;
            side.given = { ...buffers, ...lightOf(side.run.chain.desc) };
            side.frame = frameOf(side, now);
            side.run.draw(side.given, side.frame);
            if (set.history) side.run.turn();
            ++side.frames;
            side.pixels = null;
        }
    dirty.gather = false;
    last = now;
    present(now);
    ++frames;
    ++still;
    if (set.history && still < 32) request();
    if (gather) { clearTimeout(rested); rested = setTimeout(rest, software ? 350 : 200); }
    else if (wantsTruth() && !traced && !rested) rest();
    else if (again) score();
    return true;
}

function present(now) {
    const light = sides.some(s => s && methods[s.name].light), kind = (s, name) => name === 'truth' ? 4 : !s ? 0
        : !methods[s.name].light ? 1 : s.run.bounce ? 3 : 2;
    const [a, b] = sides, kinds = [kind(a, set.a), set.b === 'off' ? kind(a, set.a) : kind(b, set.b)];
    const right = set.b === 'off' ? a : b;
    show.draw(size.width, size.height, {
        t_depth: buffers.DEPTH, t_normal: buffers.NORMAL, t_albedo: buffers.ALBEDO, t_direct: buffers.DIRECT,
        t_truth: truthTexture(), t_left: a?.run.light, t_right: right?.run.light, t_left_bounce: a?.run.bounce,
        t_right_bounce: right?.run.bounce
    }, { sky: coefficients(3), world: now.world, ray: now.ray, kinds, light: +light, sun: +set.sun,
         range: light ? 0.5 : 0.4, view: ['lit', 'ambient', 'difference'].indexOf(set.view),
         split: set.b === 'off' ? 1e6 : set.split * size.width });
    if (set.b !== 'off') placeSplit();
}

/* Some time after the last change: passes are timed, the truth begins. */
let rested = 0;
function rest() {
    rested = 0;
    if (pending) { rested = setTimeout(rest, 100); return; }
    for (const side of sides) if (side) clock(side);
    writePasses();
    if (!wantsTruth() || traced) return;
    beginTruth();
}

function clock(side) {
    const { run } = side;
    clockless = !drawer.timer;
    if (set.history) run.turn();                    /* what was last written is written again */
    if (!clockless) {
        run.draw(side.given, side.frame, 1);
        const poll = tries => {
            if (sides.includes(side) && run.poll()) { side.ms = run.ms; writePasses(); }
            else if (run.waiting && tries) setTimeout(() => poll(tries - 1), 30);
        };
        setTimeout(() => poll(200), 20);
    } else {
        const all = [];
        for (let i = 0; i < 3; ++i) { run.draw(side.given, side.frame, 2); all.push([...run.ms]); }
        side.ms = all[0].map((_, k) => all.map(ms => ms[k]).sort((x, y) => x - y)[1]);
    }
    if (set.history) run.turn();
}

/* ---- truth */

let truthMade = null, truthGiven = null;
async function beginTruth() {
    const { Truth } = await import('./truth.mjs');
    if (!wantsTruth() || traced) return;
    truth ??= new Truth(error => {
        if (error) { notice(error.message); return; }
        truthMade = null;
        score();
        request();
    });
    if (truthGiven !== stage.info) {
        truthGiven = stage.info;
        truth.scene(stage.triangles());
    }
    const now = view();
    traced = now;
    truth.start({ width: size.width, height: size.height, radius: radius(), sky: set.sky, most,
                  camera: { eye: now.eye, world: now.world, ray: now.ray } });
    writeStatus();
}
let truthHeld = null;
function truthTexture() {
    if (!traced || !truth?.rays) return null;
    if (truthMade) return truthMade;
    const { width, height } = truth;
    if (truthHeld?.width !== width || truthHeld.height !== height) {
        if (truthHeld) gl.deleteTexture(truthHeld.texture);
        truthHeld = { texture: drawer.texture(width, height, { internal: gl.RGBA32F }), width, height };
    }
    plainUploads();
    gl.bindTexture(gl.TEXTURE_2D, truthHeld.texture);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, gl.RGBA, gl.FLOAT, truth.texels());
    return truthMade = truthHeld.texture;
}

/* A side's result: ambient visibility, one number a pixel; or light, four; bottom row first. */
let reader = null;
function pixelsOf(side) {
    if (side.pixels) return side.pixels;
    const { width, height } = size, { light } = methods[side.name], n = width * height;
    reader ??= gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, reader);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, side.run.light, 0);
    gl.pixelStorei(gl.PACK_ALIGNMENT, 4);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    if (light) {
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, side.pixels = new Float32Array(4 * n));
    } else {
        const bytes = new Uint8Array(4 * n);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
        side.pixels = new Float32Array(n);
        for (let i = 0; i < n; ++i) side.pixels[i] = bytes[4 * i] / 255;
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return side.pixels;
}

function score() {
    errors = {};
    if (traced && truth.rays)
        sides.forEach((s, i) => {
            if (s && truth.width === size.width) errors[i] = truth.rmse(pixelsOf(s), methods[s.name].light ? 3 : 1);
        });
    writeStatus();
}

/* What the passes read, for build/render --gbuffer frame.exr --fovy .. --radius ... */
function frameFile() {
    const p = stage.camera.projectionMatrix.elements, { width, height } = size;
    /* 1 / view depth is linear in window depth, whatever the planes */
    return exr(width, height, show.frame(width, height, buffers, [(p[10] - 1) / p[14], 2 / p[14]]));
}

/* ---- what is written */

const sum = ms => ms.reduce((all, one) => all + one, 0);
function writeStatus() {
    const times = sides.filter(s => s?.ms).map(s => `${digits(sum(s.ms))} ms`);
    $('cost').textContent = times.join(' | ');
    const clock = software ? 'in software' : clockless ? 'by the CPU’s clock' : 'on the GPU';
    $('clock').textContent = times.length ? clock : '';
    const found = [0, 1].filter(i => errors[i] != null).map(i => errors[i].toFixed(4));
    $('error').textContent = found.length ? `RMSE ${found.join(' | ')}` : '';
    $('legend').hidden = set.view !== 'difference';
    $('status').hidden = !times.length && !traced && $('legend').hidden;
    $('rays').textContent = traced ? truth.rays ? `${truth.rays} rays a pixel` : 'tracing …' : '';
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
    $('timer-note').textContent = !rows.length ? '' : clockless
        ? 'No EXT_disjoint_timer_query_webgl2 here: the CPU’s clock around each pass and a wait for it '
            + '(gl.finish and a pixel read back), median of 3.'
        : 'Timed by EXT_disjoint_timer_query_webgl2.';
    writeStatus();
}

function texts() {
    const all = [];
    sides.forEach((side, i) => side?.run.steps.forEach(step => {
        for (const stage of ['frag', 'vert']) {
            const text = ssgi.text(step.desc, stage), name = `${step.desc.pass.toLowerCase()}.${stage}`;
            if (text && !all.some(t => t.text === text))
                all.push({ name: sides[0] && sides[1] ? `${i ? 'right' : 'left'}: ${name}` : name, text });
        }
    }));
    return all;
}
function readText() {
    options($('text-which'), texts().map(({ name }, i) => [i, name]));
    $('text').showModal();
    showText();
}
function showText() {
    const { text = 'No pass is drawn.' } = texts()[+$('text-which').value] ?? {}, pre = $('text').querySelector('pre');
    pre.textContent = text;
    pre.scrollTop = 0;
    $('text-size').textContent = `${text.split('\n').length - 1} lines, GLSL 300 es, as it is compiled`;
}

/* ---- begin */

let told = false;
function first() {
    if (told) return;
    told = true;
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));   /* it is there, not just asked for */
    page.first = performance.now();
    page.ready();
}

/* For scripts: make web-test waits for it, and reads results. */
const page = globalThis.page = { set, first: null, lacks: null, result: i => ({ ...size, pixels: pixelsOf(sides[i]) }),
                                 error: i => errors[i] ?? null, rays: () => truth?.rays ?? 0,
                                 ms: i => sides[i]?.ms ?? null,
                                 settled: () => still >= 32,
                                 frame: () => [frameFile(), stage.camera.fov, radius()] };
page.drawn = new Promise(resolve => { page.ready = resolve; });
/* Settings as the address has them; resolves when they are drawn. */
page.go = async hash => {
    history.replaceState(null, '', '#' + hash);
    fromAddress();
    await openScene();
    changed();
    const was = frames;
    while (frames === was) await new Promise(requestAnimationFrame);
};

function lacks() {
    const probe = document.createElement('canvas').getContext('webgl2');
    if (!probe) return 'This browser or device has no WebGL 2, which every pass here is written for.';
    const half = probe.getExtension('EXT_color_buffer_float') || probe.getExtension('EXT_color_buffer_half_float');
    const missing = half ? null : 'This device cannot draw into floating-point textures (no EXT_color_buffer_float, no '
        + 'EXT_color_buffer_half_float); the passes between gather and filter need 16 bits.';
    const info = probe.getExtension('WEBGL_debug_renderer_info');
    const name = probe.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : probe.RENDERER);
    software = /swiftshader|llvmpipe|software|basic render/i.test(name);
    $('device').textContent = name + (software ? ': a software renderer; the picture has 960×540 pixels at most' : '');
    probe.getExtension('WEBGL_lose_context')?.loseContext();
    return missing;
}

async function start() {
    page.lacks = lacks();
    if (page.lacks) { notice(page.lacks); return; }
    fromAddress();
    const wasm = load(), list = fetch('scenes/scenes.json').then(answer => answer.json());
    const { Stage } = await import('./stage.mjs');
    stage = new Stage(canvas);
    gl = stage.gl;
    [ssgi, scenes] = await Promise.all([wasm, list]);
    drawer = new Drawer(gl, ssgi);
    show = new Show(gl, drawer);
    const named = Object.entries(methods).map(([name, { title }]) => [name, title]);
    options(panel.elements.scene, scenes.map(s => [s.name, s.title]));
    options(panel.elements.sky, Object.entries(skies).map(([name, { title }]) => [name, title]));
    options(panel.elements.a, named);
    options(panel.elements.b, [['off', 'the same'], ...named, ['truth', 'truth, ray-traced']]);
    for (const name of ['p', 'q']) options(panel.elements[name], Object.entries(presets));
    listen();
    panel.inert = false;
    fit();
    side(0, set.a, set.p);                          /* linked while the scene comes */
    side(1, set.b, set.q);
    await openScene();
}

start().catch(e => { notice(e.message); console.error(e); });
