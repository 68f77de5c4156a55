/* page.mjs - the page: settings, the frame, what is written beside it. What is drawn of the library is in steps.mjs. */
import { load } from './ssgi.mjs';
import { behinds, defaults, methods, normals, presets, read, settings, sizes, views, write } from './settings.mjs';
import { skies, equirect } from './sky.mjs';
import { Drawer } from './steps.mjs';
import { Show } from './show.mjs';
import { exr } from './exr.mjs';
import { fetchFile } from './fetch.mjs';

const $ = id => document.getElementById(id), panel = $('panel'), canvas = $('canvas');
const set = { ...defaults };
const most = 4096;                                  /* rays a pixel, after which the truth is left alone */

let ssgi, stage, drawer, show, truth, scenes = [], gl, software = false;
let sides = [null, null];                           /* { run, key, frame number, .. } left and right */
let buffers = null, size = { width: 0, height: 0 }, last = null, pending = 0, still = 0, frames = 0;
let dirty = { scene: true, gather: true }, traced = null, clockless = false, environments = new Map(), errors = {};
let readScene, readFile;                            /* of model.mjs, which comes when WebGL 2 is known to be here */

/* ---- settings: in the address, in the panel */

/* Returns what is wrong with it, for notice(): what cannot be had stays as it was. */
function fromAddress() {
    const { set: all, wrong } = read(location.hash.slice(1), limits(), set);
    Object.assign(set, all);
    return wrong;
}
function limits() {
    const side = Math.min(4096, gl.getParameter(gl.MAX_TEXTURE_SIZE), ...gl.getParameter(gl.MAX_VIEWPORT_DIMS));
    return { scenes: scenes.map(s => s.name), side, pixels: software ? 1920 * 1080 : 3840 * 2160 };
}
let addressed = 0;
function writeAddress() {
    clearTimeout(addressed);
    addressed = setTimeout(() => history.replaceState(null, '', '#' + write(set)), 250);
}
const radius = () => stage.info.radius * 2 ** set.radius;
const thickness = method => set.thickness < 0 ? methods[method]?.thickness ?? 0.6 : set.thickness;
const wantsTruth = () => set.truth || set.b === 'truth' || set.view === 'difference';
const digits = v => v >= 100 ? v.toFixed(0) : v >= 10 ? v.toFixed(1) : v.toFixed(2);

function toPanel() {
    for (const control of panel.elements) {
        if (!Object.hasOwn(set, control.name)) continue;
        const value = set[control.name];
        if (control.type === 'checkbox') control.checked = value;
        else if (control.type === 'radio') control.checked = control.value === value;
        else if (control.name === 'thickness') control.value = thickness(set.a);
        else if (control.name === 'size') showSize(control, value);
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

/* Sizes that only an address names are added. */
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
        set[name] = type === 'checkbox' ? target.checked : type === 'range' ? +target.value : target.value;
        notice();
        if (name === 'scene') { set.cam = ''; openScene(); }
        changed(name);
    });
    panel.addEventListener('submit', e => e.preventDefault());
    addEventListener('hashchange', goToAddress);
    stage.controls.addEventListener('change', () => {
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
        history.replaceState(null, '', '#' + write(set));
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

/* A line each; none: there is nothing to say. */
function notice(...sentences) {
    const shown = sentences.slice(0, 3), more = sentences.length - shown.length;
    $('notice').hidden = !shown.length;
    $('notice').textContent = [...shown, ...(more ? [`and ${more} more`] : [])].join('\n');
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

/* What cannot be had of an address, a scene or a file is said, and scene and settings stay as they were. */
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
        const model = stage.info === info ? null : info.model ?? await readScene(`scenes/${info.name}.bin`);
        if (mine !== opening) return;                   /* another was chosen meanwhile */
        if (model) showModel(model, info);
    } catch (e) {
        if (mine !== opening) return;
        notice(e.message);
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

async function openFile(file) {
    const mine = ++opening;
    notice();
    try {
        const { model, info } = await readFile(file);
        if (mine !== opening) return;
        if (!scenes.some(s => s.name === 'file')) panel.elements.scene.add(new Option(info.title, 'file'));
        scenes = [...scenes.filter(s => s.name !== 'file'), Object.assign(info, { model })];
        [...panel.elements.scene.options].find(o => o.value === 'file').text = info.title;
        set.scene = 'file';
        showModel(model, info);
        lookHome();
        dirty.scene = true;
        changed('scene');
    } catch (e) {
        if (mine !== opening) return;
        notice(e.message);
        if (stage.info?.name !== set.scene) openScene();    /* which was still on its way */
    }
}

function showModel(model, info) {
    stage.show(model, info);
    traced = truthGiven = null;
    truth?.stop();
}

function lookHome() {
    stage.look(stage.info.eye, stage.info.target);
    set.cam = '';
}

function lookedFrom() {
    const at = v => v.toArray().map(x => +x.toPrecision(6)).join(',');
    return `${at(stage.camera.position)},${at(stage.controls.target)}`;
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

const farthestHalf = 65504;                         /* depths that 16 bits hold */

/* The chain of a side, as settings have it. */
function chainOf(name, preset) {
    const { desc } = methods[name], bounce = set.bounce && desc.pass === 'SSDO';
    const d = ssgi.preset({ ...desc, dialect: '300ES', normal: set.normals, thickness: set.behind }, preset);
    if (methods[name].desc.restore) d.restore = methods[name].desc.restore;
    return { desc: { ...d, ...(bounce && { bounce: 'SOLID_ANGLE' }) }, width: size.width, height: size.height, blur: 1,
             history: +set.history, direct: +(bounce && set.sun), precise: +(stage.info?.far > farthestHalf) };
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
         range: light ? 0.5 : 0.4, view: views.indexOf(set.view),
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
    const bytes = side.run.format.type === gl.UNSIGNED_BYTE, all = new (bytes ? Uint8Array : Float32Array)(4 * n);
    reader ??= gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, reader);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, side.run.light, 0);
    gl.pixelStorei(gl.PACK_ALIGNMENT, 4);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    gl.readPixels(0, 0, width, height, gl.RGBA, bytes ? gl.UNSIGNED_BYTE : gl.FLOAT, all);
    side.pixels = light ? all : new Float32Array(n);
    for (let i = 0; i < n && !light; ++i) side.pixels[i] = all[4 * i] / (bytes ? 255 : 1);
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

/* What the passes read, for build/render --gbuffer frame.exr, with the camera: OpenEXR's looks down +z. */
function frameFile() {
    const { projectionMatrix, matrixWorldInverse } = stage.camera, p = projectionMatrix.elements;
    const { width, height } = size, worldToCamera = matrixWorldInverse.elements.map((v, i) => i % 4 === 2 ? 0 - v : v);
    /* 1 / view depth is linear in window depth, whatever the planes */
    const channels = show.frame(width, height, buffers, [(p[10] - 1) / p[14], 2 / p[14]]);
    return exr(width, height, channels, { screenWindowWidth: 2 / p[0], worldToCamera, 'ssgi.radius': radius() });
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
                                 frame: frameFile,
                                 limits, picture };
page.drawn = new Promise(resolve => { page.ready = resolve; });
/* Settings as the address has them; resolves when they are drawn. */
page.go = async hash => {
    history.replaceState(null, '', '#' + hash);
    await goToAddress();
    changed();
    const was = frames;
    failure = null;
    while (frames === was && !failure) await new Promise(requestAnimationFrame);
    if (failure) throw failure;
};

/* What is on the canvas, four bytes a pixel: drawn once more, as browsers do not keep it. */
function picture() {
    const all = new Uint8Array(4 * size.width * size.height);
    present(last);
    gl.readPixels(0, 0, size.width, size.height, gl.RGBA, gl.UNSIGNED_BYTE, all);
    return all;
}

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
    const [{ Stage }, model, wasm, list] = await Promise.all([
        import('./stage.mjs'), import('./model.mjs'), load(),
        fetchFile('scenes/scenes.json').then(answer => answer.json())]);
    ({ readScene, readFile } = model);
    ssgi = wasm;
    scenes = list;
    stage = new Stage(canvas);
    gl = stage.gl;
    drawer = new Drawer(gl, ssgi);
    show = new Show(gl, drawer);
    const named = Object.entries(methods).map(([name, { title }]) => [name, title]);
    options(panel.elements.scene, scenes.map(s => [s.name, s.title]));
    options(panel.elements.sky, Object.entries(skies).map(([name, { title }]) => [name, title]));
    options(panel.elements.a, named);
    options(panel.elements.b, [['off', 'the same'], ...named, ['truth', 'truth, ray-traced']]);
    for (const name of ['p', 'q']) options(panel.elements[name], Object.entries(presets));
    options(panel.elements.behind, Object.entries(behinds));
    options(panel.elements.normals, Object.entries(normals));
    options(panel.elements.size, [['auto', 'as shown'], ...sizes.map(size => [size, size])]);
    for (const control of panel.elements) {
        if (control.type !== 'range') continue;
        control.min = settings[control.name].least;
        control.max = settings[control.name].most;
    }
    notice(...fromAddress());
    listen();
    panel.inert = false;
    fit();
    side(0, set.a, set.p);                          /* linked while the scene comes */
    side(1, set.b, set.q);
    await openScene();
}

start().catch(e => { notice(e.message); console.error(e); });
