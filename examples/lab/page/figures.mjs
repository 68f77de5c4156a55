/* figures.mjs - makes examples/docs/FIGURES.md, the csv beside it, README's charts and the tables of README and BENCH
   from the records of make chart, seeds, light, stability, papers, cost and cost-peers.

      node examples/lab/page/figures.mjs [report]
      node examples/lab/page/figures.mjs --csv [FOLDER]       README's charts and the tables alone, of the csv there

   A full run replaces its own parts of the page in examples/docs, and no others. A quick run's page lies beside the
   records. Runs of some scenes, methods or papers (SCENE, METHOD, PAPER) change nothing. If a record cannot be read:
   one line on stderr, status 2, and the page stays as it is. */
import { copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync } from 'node:fs';
import { renameSync, statSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { basename, resolve } from 'node:path';
import vm from 'node:vm';

const { ssgi_report: report, ssgi_record } = createRequire(import.meta.url)('./report.js');
const { grouped, means, given, peer, by_pair, by_kind, by_cause, chains, devices, modelled, tables } = report;
const [folder = 'report', drawn] = process.argv.slice(2),
    docs = 'examples/docs';

/* ---- >>markdown -------------------------------------------------------------------------------------------------- */

const cell = (v, digits = 3, sign = false) =>
    v === null || v === undefined || Number.isNaN(v)
        ? ''
        : typeof v !== 'number'
          ? String(v).replaceAll('|', '\\|')
          : (sign && v > 0 ? '+' : '') + v.toFixed(digits);
const table = (heads, rows) =>
    [heads, null, ...rows]
        .map(r => (r ? `| ${r.join(' | ')} |` : `|${'---|'.repeat(heads.length)}`))
        .join('\n')
        .replaceAll('|  |', '| |')
        .replaceAll('|  |', '| |');
/* Writes rows as a table of Markdown. Each column is its head, the key of a figure or a function of a row (none: the
   head is the key), the number of digits, and whether a plus sign is written. */
const listed = (rows, ...columns) =>
    table(
        columns.map(([head]) => head),
        rows.map(r =>
            columns.map(([head, of = head, digits, sign]) =>
                cell(typeof of === 'function' ? of(r) : r[of], digits, sign)
            )
        )
    );
/* Returns a row's name in the tables: its label, and its method and settings unless the label names them. */
function title(r) {
    const told = r.label === r.method || given(r);
    return `${r.label}${told ? '' : `, \`${r.method}\``}${
        r.settings && !String(r.label).includes(r.settings) ? `: \`${r.settings.replaceAll(',', ', ')}\`` : ''
    }`;
}
const METHOD = ['method', title],
    TIME = ['time', 'relative_time', 2],
    ON_GPU = ['RX 6800, ms', modelled];
const found = (record, kind) => (record && report.entry(record.name, kind)) ?? [];

/* ---- >>parts: the text of each, from its rows ------------------------------------------------------------------- */

function ambient(all, record) {
    const columns = [METHOD, ['bytes', , 0], TIME, ON_GPU, ['error', 'share']];
    return `![Cost against error](${record.kind === 'full' ? 'pictures/' : ''}chart.svg)

Mean of ${grouped(all, 'scene').size} scenes. Noise: deviation over two phases of it; model error: RMSE of their mean.

${listed(means(all).filter(r => !peer(r)), ...columns, ['model error', 'model_error'], ['noise'])}`;
}

function others(rows) {
    return `Matched: with the radius of ours. Fitted: after the better of a v^b and 1 - a (1 - v)^b for each
picture, found with the truth in hand.

${listed(rows, ['what', 'label'], ['settings'], TIME, ['error', 'share'], ['error, fitted', 'share_fitted'])}`;
}

function light(rows) {
    const bias = key => ['bias', `${key}_bias`, 3, true];
    const columns = [METHOD, TIME, ['radiance'], ['irradiance'], bias('irradiance')];
    return `The bunny and four boxes under a sky, one bounce: RMSE over the mean of the truth.

${listed(rows, ...columns, ['bounce', , 2], bias('bounce'))}`;
}

function pairs(rows) {
    const columns = [METHOD, ['time', , 2], ['mean'], ['worst'], ['pair']];
    return `RMSE of irradiance over that of no occlusion, no bounce, over ${rows[0].pairs} pairs.

${listed(rows, ...columns, ['below 1', r => `${r['below 1']} of ${r.pairs}`], ['bias', , 3, true])}`;
}

/* Returns this machine's clock of a row, among means of the built-in scenes. */
const clock_of = (built_in, r) =>
    built_in.find(a => a.method === r.method && a.settings === r.settings && (!peer(r) || a.label === r.label))
        ?.relative_time;

function seeds(rows, record) {
    const built_in = means(found(record, 'ambient')),
        kinds = [...grouped(rows, 'kind').keys()].filter(k => k !== 'models').map(k => [k]);
    const list = [...grouped(rows, r => `${r.set} ${r.seed}`).keys()],
        count = set => list.filter(s => s.startsWith(`${set} `)).length;
    const of = (what, others = false) =>
        by_kind(rows.filter(r => r.what === what && peer(r) === others && r.method !== 'none'));
    const gpu = ['RX 6800, ms'],
        cpu = ['CPU', r => clock_of(built_in, r), 2],
        mean = r => `${cell(r.mean)} &plusmn; ${cell(r['±'])}`;
    const own = (what, seen = what === 'visibility') =>
        listed(
            of(what),
            ...[METHOD, gpu, ...(seen ? [cpu] : []), ['mean', mean], ['median']],
            ...[['worst', r => `${cell(r.worst)}, ${r.of}`], ['above 1', , 0], ...(seen ? [['noise', , 1]] : [])],
            ...[['judged'], ['drawn'], ...kinds, ['models'], ['worst', 'models, worst']]
        );
    const effects = of('visibility', true);
    return `${count('judged') + count('drawn')} scenes at 1280x720, none picked by hand: ${count('judged')} by seeds on
which nothing is tuned (judged), ${count('drawn')} drawn from the code's hash; beside them ${count('models')} models
of packages. Error over that of no occlusion: the mean with its 95 % interval, on how many it is worse than nothing,
means by kind. Noise: thousandths of visibility, of 1.2 to 8 pixels, where a smooth surface is in shade. Milliseconds
are modelled; CPU: ${record.cores} cores, over one unblurred 16-sample \`ssao\`.

${own('visibility')}

Irradiance under each scene's own environment, no bounce:

${own('light')}

One bounce of that light alone:

${own('bounce')}

Visibility of the same scenes in pictures a quarter as wide and high, where the pixel grid is most of the error:

${own('small')}
${
    effects.length
        ? `
Effects of other libraries there, raw, and fitted with the truth in hand: by one gain and exponent over all scenes, and
by two numbers a picture, as by kind.

${listed(
    effects,
    ...[['effect', 'label'], ['settings'], gpu, cpu, ['raw', mean], ['fitted over all', 'fitted, all']],
    ...[['fitted a picture', 'fitted'], ...kinds]
)}

${leads(rows)}`
        : ''
}`;
}

/* Returns the kinds of scenes in which a peer has a smaller error than a row of ours with at least its cost. */
function leads(rows) {
    const of = grouped(
        rows.filter(r => r.what === 'visibility' && r.set !== 'models'),
        r => `${r.label} ${r.settings ?? ''}`
    );
    const lines = [];
    for (const [name, own] of of)
        for (const [other, theirs] of of) {
            const ms = [modelled(own[0]), modelled(theirs[0])];
            if (peer(own[0]) || !peer(theirs[0]) || !(ms[1] <= ms[0])) continue;
            for (const { kind, by, within } of report.ahead(own, theirs))
                lines.push(`${kind}: ${other} before ${name} by ${cell(by)} &plusmn; ${cell(within)}`);
        }
    return lines.length
        ? `Kinds in which one of them, fitted a picture, errs less than a row of ours that costs as much or more, by
more than the interval: ${lines.join('; ')}.`
        : 'In no kind does one of them, fitted a picture, err less than a row of ours that costs as much or more.';
}

/* Returns the first table of plain rows that stands under a heading of a record. */
const under = (record, heading) =>
    tables(record).find(t => t.heading === heading && t.kind === 'rows')?.rows ?? [];

function plan(rows) {
    return `On views that it was not fitted on. Good: at most 1.25 times the cost of the cheapest choice that
meets the error, and at most 1.2 times the error asked for.

${listed(rows, ['', 'what'], ['good', r => `${r.good} of ${r.pairs}`])}`;
}

/* Writes the table of stability: a row for each cause, a column for each method. */
function worst(causes) {
    const methods = [...new Set(causes.flatMap(Object.keys))].filter(key => key !== 'cause');
    const digits = v => (v > 1000 ? 0 : v > 0.03 ? 3 : 4);
    return listed(causes, ['cause'], ...methods.map(m => [m, c => cell(c[m], digits(c[m]))]));
}
/* Writes a row of a moving camera for each method: the mean of each figure, and its worst in brackets. */
function moved(record, heading, key) {
    const rows = under(record, heading),
        known = (list, f) => list.map(r => r[f]).filter(x => f !== 'by TAA' || x > 0);
    const of = ([, list], f, v = known(list, f)) =>
        v.length ? `${cell(v.reduce((s, x) => s + x, 0) / v.length, 4)} (${cell(Math.max(...v), 4)})` : '';
    const figures = ['filling', 'filled', 'error', 'over alone', 'by TAA'].map(f => [f, g => of(g, f)]);
    return (
        rows.length &&
        `${heading}, ${new Set(rows.map(r => r.scene)).size} scenes of seeds from 1000 on and models, 640x360.
The mean (the worst) of the deviation over the truth's in frames 1 to 8 and 9 to 16, of the last frame's error, of that
over the error of the frame alone, and of the error of TAA's picture of a camera that stands.

${listed([...grouped(rows, r => (key ? `${r[key]}, ` : '') + r.method)], ['', 0], ...figures)}`
    );
}
function stability(causes, record) {
    const still = causes.filter(c => 'hsao' in c);
    const moving = causes.filter(c => !still.includes(c) && Object.keys(c).some(key => key.endsWith('-history')));
    const others = causes.filter(c => !still.includes(c) && !moving.includes(c));
    const hosts = moved(record, 'Frames as hosts make them', 'move');
    const moves = [moved(record, 'Cameras that move'), hosts].filter(Boolean);
    return `The worst of each sweep: RMSE of ambient visibility, or what the page says of that sweep. Beside: no
ambient occlusion at all, the truth's own flicker, or open ground.

${worst(still)}${moving.length ? `\n\nOver frames:\n\n${worst(moving)}` : ''}${
        others.length ? `\n\nOf light, and of functions alone:\n\n${worst(others)}` : ''
    }${moves
    .map(m => `\n\n${m}`)
    .join('')}`;
}

/* Writes a paper's sheet: its printed figures beside those drawn here, then claims, rules and outcomes. */
function sheet(t) {
    const kinds = { printed: 'the paper', measured: 'here', time: 'here, a time', modelled: 'here, modelled' },
        of = (row, head) => t.rows.find(c => c.row === row && head === `${kinds[c.kind]}: ${c.head}`)?.text;
    const all = kind => t.rows.filter(c => c.kind === kind),
        shown = t.rows.filter(c => c.row > 0 && kinds[c.kind] && (c.kind !== 'modelled' || c.text)),
        heads = new Set(shown.map(c => `${kinds[c.kind]}: ${c.head}`));
    const rule = c => all('rule').filter(r => r.row === c.row).map(r => `${r.head}: ${r.text}`)[0];
    return `### [${t.rows[0].paper}] ${t.heading}

${listed(all('what'), ['row', 'text'], ...[...heads].map(head => [head, c => `${of(c.row, head) ?? ''}`]))}

${listed(all('claim'), ['what the paper says, and what came of it', 'text'], ['judged by', rule])}`;
}

function papers(sheets) {
    const count = head => t => t.rows.filter(c => c.kind === 'claim' && c.head === head).length;
    const sum = head => sheets.map(count(head)).reduce((s, n) => s + n, 0);
    const heads = [['statements that agree', 'agrees'], ['that do not', 'differs'], ['not judged here', 'not judged']];
    const rows = [...sheets.map(t => [`[${t.rows[0].paper}] ${t.heading}`, ...heads.map(h => count(h[1])(t))]),
        ['all', ...heads.map(h => sum(h[1]))]];
    return `What the papers say of their tables and figures, judged by what is drawn here on comparable scenes. The page
has pictures. A column that is called a time differs from run to run; no other figure does. Statements on times are
judged by a model of an RX 6800 at 1920x1080 (\`make cost-papers\`), or say why they are not.

${table(['figure', ...heads.map(h => h[0])], rows)}

${sheets.map(sheet).join('\n\n')}`;
}

/* Returns "weighed (busy, calm)" for a row's costs on a device, or one number if all are equal. */
function ways(r, device, digits) {
    const key = way => `${device}${device ? ' ' : ''}${way}`;
    const [weighed, busy, calm] = ['weighed', 'busy', 'calm'].map(way => cell(r[key(way)], digits));
    return weighed === busy && weighed === calm ? weighed : `${weighed} (${busy}, ${calm})`;
}
function cost(rows) {
    const [first, second] = [...grouped(rows, 'family').keys()],
        of = rows.filter(r => r.family === first);
    const beside = r => rows.find(o => o.chain === r.chain && o.family === second);
    const ms = d => [`${d}, ms`, r => ways(typeof r[`${d} weighed`] === 'number' ? r : beside(r), d, 3)];
    return `Never measured: Mesa's compiler made these instructions of the passes, for GPUs that were not there.
Milliseconds are a model's of 1920x1080 (examples/lab/cost/model.h): weighed as waves of 8x8 texels enter on twelve
scenes by seed, in brackets busy, all that an \`if\` guards, and calm, none of what a wave may leave out. Splats and
surfels are left out.

${listed(
    of.filter(beside),
    ['chain', r => `${r.chain}${r.splats ? ', counts less splats' : ''}`],
    [`${first}: instructions`, r => ways(r, '', 0)],
    ...[['fetches', , 1], ['bytes in', 'bytes_in', 1], ['out', 'bytes_out', 1]],
    ...[['registers', 'vgprs', 0], ['waves', , 0]],
    [`${second}: instructions`, r => ways(beside(r), '', 0)],
    ...devices(rows).map(ms),
    ...[['programs', , 0], ['text, kB', r => r.text_bytes / 1e3, 1]],
    ['MB of targets at 1080', r => r.targets_1080 / 1e6, 1]
)}

Cheaper by every figure, in both families, and than all of its kind that take more instructions than the next:
${of
    .filter(r => r.cheaper_than)
    .map(r => `${r.chain} < ${r.cheaper_than}`)
    .join('; ')}.`;
}

/* The page's parts in their order: heading, the record, the function that finds the rows, the one that writes the text.
   chart's parts may have records of their own. */
const of_kind = (kind, made = rows => rows) => record => made(found(record, kind));
const parts = [
    ['Ambient occlusion', 'ambient', of_kind('ambient'), ambient],
    ['What others have', 'ambient', of_kind('ambient', rows => means(rows).filter(peer)), others],
    ['Light: speed against accuracy', 'lit', of_kind('light'), light],
    ['Light on every pair of a scene and a probe', 'light', of_kind('pairs', by_pair), pairs],
    ['Scenes by seed', 'seeds', of_kind('seeds'), seeds],
    ['The plan', 'plan', record => under(record, 'What a scene needs'), plan],
    ['Where methods fail', 'stability', by_cause, stability],
    ["The papers' own tables and figures", 'papers', record => tables(record).filter(t => t.kind === 'paper'), papers],
    ['What chains cost a GPU, modelled', 'cost', of_kind('cost', chains), cost]
];
/* The csv of each record that examples/docs/figures keeps, by their beginnings. */
const csv = {
    ambient: ['chart.csv'],
    lit: ['chart-lit'],
    fields: ['chart-aof'],
    deep: ['chart-deep'],
    light: ['chart-pairs'],
    seeds: ['seeds.csv'],
    plan: ['plan.csv', 'plan-summary'],
    ...Object.fromEntries(['stability', 'papers', 'cost', 'cost-peers', 'quiet'].map(name => [name, [name]])),
    chart: ['chart', 'seeds.csv']
};

const head = `# Figures

Made by \`make figures\`: change nothing here. Each part names its command, commit, machine and driver. The page
report/index.html has charts of every scene and pictures, and [figures](figures) has the csv of full runs. \`make
figures-check\` names the parts whose figures are of other code than today's, by a hash of all shaders and of ssgi.h
without comments.

- Time: GL time of all passes, filter included, over one unblurred 16-sample \`ssao\` in the same interleaved run.
- Error: RMSE against ray-traced truth over the RMSE of having no ambient occlusion. Raw output: no gain, no exponent.
- Biases: below 0 is too dark. Bytes: a pixel, all passes.
`;

/* ---- >>writing --------------------------------------------------------------------------------------------------- */

/* Writes a text to a file whole, or not at all. */
function write(path, text) {
    writeFileSync(`${path}.part`, text);
    renameSync(`${path}.part`, path);
}
/* Returns a record; for a part of the chart the newer one of its own and the chart's. */
const of_chart = ['ambient', 'lit', 'fields', 'deep', 'seeds', 'plan'];
function records(name) {
    const own = report.records[name], whole = of_chart.includes(name) ? report.records.chart : null;
    return !whole || own?.made > whole.made ? own : whole;
}
const origin = r => `*\`${r.command}\`, commit ${r.commit}, ${r.cores} cores (${r.processor}), ${r.driver}*`;
/* Returns a table of the parts that make figures measured: of which code, and how long it took. */
function sources() {
    const path = `${docs}/figures/parts.csv`;
    const [, ...rows] = existsSync(path) ? readFileSync(path, 'utf8').trim().split('\n') : [''];
    const heads = ['part of `make figures`', 'code', 'commit', 'minutes'];
    return rows.length ? `\n${table(heads, rows.map(r => r.split(',')))}\n` : '';
}
function page(kind, old) {
    const kept = new Map(old.split(/\n(?=## )/).slice(1).map(part => [part.slice(3, part.indexOf('\n')), part]));
    const text = ([name, of, rows_of, write]) => {
        const record = records(of), rows = record?.kind === kind ? rows_of(record) : [];
        if (rows.length) return `\n## ${name}\n\n${origin(record)}\n\n${write(rows, record)}\n`;
        return kept.has(name) ? `\n${kept.get(name)}` : '';
    };
    return head + sources() + parts.map(text).join('');
}
/* Writes the figures of the judged scenes into the tables of README and BENCH that stand below such a comment. A row is
   found by its method and settings in backticks, or by the name of an effect; a column by its head. In a row that says
   "light" the error is that of light without a bounce. Empty cells stay empty. */
const marked = /(<!-- judged scenes, by make figures -->\n+)((?:\|.*\n)+)/g;
const renamed = [
    ['GTAOPass', 'GTAO'],
    ['resolution', 'size'],
    ['n8ao, Neural', 'n8ao, neural, Neural']
];
const columns = {
    ...Object.fromEntries(['RX 6800', 'Steam Deck', 'RX 480'].map(d => [d, r => cell(modelled(r, d))])),
    ms: r => cell(modelled(r)),
    error: r => cell(r.mean),
    'relative error': r => `${cell(r.mean)} +- ${cell(r['±'])}`,
    fitted: r => cell(r.fitted),
    'worst scene': r => cell(r.worst)
};
function judged_tables(text, all) {
    const judged = all.filter(r => r.set === 'judged');
    const of = what => by_kind(judged.filter(r => r.what === what));
    const [visible, lit] = [of('visibility'), of('light')];
    const found_by = (cells, rows, settings) => {
        const [, method] = cells.join('|').match(/`([a-z0-9-]+)`/) ?? [];
        if (method) return rows.find(r => r.method === method && (r.settings ?? '') === settings);
        const name = renamed.reduce((text, [a, b]) => text.replace(a, b), cells[1]?.trim() ?? '');
        return rows.find(r => peer(r) && `${r.label}, ${r.settings}`.startsWith(`${name},`));
    };
    return text.replace(marked, (whole, mark, rows) => {
        const lines = rows.split('\n'), heads = lines[0].split('|').map(head => head.trim());
        const written = lines.map(line => {
            const cells = line.split('|'), light = /light/.test(line);
            const asked = line.match(/`([^`]*=[^`]*)`/)?.[1] ?? '';
            const row = found_by(cells, light ? lit : visible, light ? 'bounce=none' : asked);
            if (!row) return line;
            const drawn = light ? { ...row, settings: asked } : row;
            return cells
                .map((text, i) => {
                    const of = heads[i].includes('error') || !columns[heads[i]] ? row : drawn;
                    const figure = columns[heads[i]]?.(of);
                    return figure ? text.replace(/\d*\.\d+( \+- \d*\.\d+)?/, figure) : text;
                })
                .join('|');
        });
        return mark + written.join('\n');
    });
}
function rewrite_tables(into) {
    for (const path of ['README.md', `${docs}/BENCH.md`])
        if (existsSync(path))
            write(into ? `${into}/${basename(path)}` : path,
                  judged_tables(readFileSync(path, 'utf8'), found(report.records.chart, 'seeds')));
}

/* Draws README's charts and writes the tables anew, from the csv of the newest full runs. */
async function redraw(into) {
    const path = name => `${docs}/figures/${name}.csv`,
        of = (table, name) => ({ table, csv: readFileSync(path(name), 'utf8') });
    if (!['chart', 'seeds', 'cost', 'cost-peers'].every(name => existsSync(path(name)))) return;
    ssgi_record({ name: 'chart', entries: [of('ambient', 'chart'), of('seeds', 'seeds')] });
    for (const name of ['cost', 'cost-peers']) ssgi_record({ name, entries: [of('cost', name)] });
    if (existsSync(path('quiet'))) ssgi_record({ name: 'quiet', entries: [of('quiet', 'quiet')] });
    rewrite_tables(drawn);
    await draw(into);
}
/* Draws README's chart: error by two clocks, and the error of fine detail, one below the other, so that a phone shows
   them large enough. The csv of the built-in scenes has this machine's clock. Without Plot it stays as it is. */
async function draw(into) {
    const here = name => resolve('build/page/node_modules', name);
    const rows = found(records('chart'), 'ambient'), built_in = rows.length ? means(rows) : [];
    if (!existsSync(here('linkedom'))) return;
    const Plot = await import(here('@observablehq/plot/src/index.js'));
    const { parseHTML } = await import(here('linkedom/esm/index.js'));
    const { document } = parseHTML('<html><body></body></html>');
    const [cpu, gpu] = Object.values(report.clocks), up = 'error, of that without occlusion';
    const sums = report.on_gpu(found(records('chart'), 'seeds').filter(r => r.what === 'visibility'));
    const clocked = sums.map(r => ({ ...r, relative_time: clock_of(built_in, r) }));
    const fine = found(report.records.quiet, 'quiet').map(r => ({
        ...r,
        label: r.method,
        _ms: r.ms ?? modelled({ ...r, label: r.method }),
        grain: 1e3 * r.truth_seen
    }));
    const panels = [
        [clocked, { ...gpu, y: 'share', up, floor: report.floor_of(sums) }],
        [clocked, { ...cpu, y: 'share', up, floor: report.floor_of(sums) }],
        [fine, { ...gpu, y: 'grain', up: 'error of 1.2 to 8 pixels where it is smooth, thousandths' }]
    ];
    const drawn = panels
        .filter(([list, { x, y }]) => list.filter(r => Number.isFinite(r[x]) && Number.isFinite(r[y])).length >= 6)
        .map(([list, options]) => report.scatter(Plot, list, { ...options, width: 560, height: 400 }))
        .map(options => Plot.plot({ ...options, document, style: { fontSize: '13px' } }));
    if (drawn.length) keep(`${into}/chart.svg`, drawn);
}
/* Writes SVG pictures below each other into one file, on white, as the page that shows them may be dark. */
function keep(path, all) {
    const sizes = side => all.map(svg => +svg.getAttribute(side)),
        startOf = i => sizes('height').slice(0, i).reduce((sum, h) => sum + h, 0);
    const placed = all.map((svg, i) => {
        svg.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
        svg.setAttribute('y', startOf(i));
        return svg.outerHTML.replaceAll('currentColor', '#222').replaceAll('var(--plot-background)', '#fff');
    });
    const size = `width="${Math.max(...sizes('width'))}" height="${startOf(all.length)}"`;
    const ground = '<rect width="100%" height="100%" fill="#fff"/>';
    write(path, `<svg xmlns="http://www.w3.org/2000/svg" ${size}>${ground}${placed.join('')}</svg>\n`);
    console.log(`figures: ${path}`);
}

if (folder === '--csv') {
    await redraw(drawn ?? `${docs}/pictures`);
    process.exit();
}
for (const name of Object.keys(csv)) {
    const file = `${folder}/${name}.js`;
    if (!existsSync(file)) continue;
    try {
        vm.runInNewContext(readFileSync(file, 'utf8'), { ssgi_record });
        report.records[name].made = statSync(file).mtimeMs;
    } catch (e) {
        console.error(`figures: ${file}: is no record: ${e.message}`);
        process.exit(2);
    }
}
const kinds = Object.values(report.records).map(r => r.kind);
if (!kinds.length) {
    console.error(
        `figures: ${folder}: holds none of chart.js, stability.js, papers.js and cost.js (make chart, make ` +
            'stability, make papers, make cost)'
    );
    process.exit(2);
}
for (const [kind, into] of [
    ['full', docs],
    ['quick', folder]
]) {
    if (!kinds.includes(kind)) continue;
    const path = `${into}/FIGURES.md`;
    write(path, page(kind, existsSync(path) && kind === 'full' ? readFileSync(path, 'utf8') : ''));
    console.log(`figures: ${path}${kind === 'full' ? '' : ` (${docs}/FIGURES.md has full runs alone)`}`);
    if (kind !== 'full') {
        if (records('chart')?.kind === kind) await draw(folder);
        continue;
    }
    mkdirSync(`${docs}/figures`, { recursive: true });
    for (const file of readdirSync(folder).filter(file => file.endsWith('.csv')))
        for (const [name, begin] of Object.entries(csv))
            if (begin.some(b => file.startsWith(b)) && records(name)?.kind === kind)
                copyFileSync(`${folder}/${file}`, `${docs}/figures/${file}`);
}
if (kinds.includes('full')) {
    const seeds_are_new = records('seeds')?.kind === 'full';
    await redraw(`${docs}/pictures`);
    if (seeds_are_new) rewrite_tables();
}
if (kinds.includes('part')) console.log('figures: some are left as they are, for a part alone was measured');
