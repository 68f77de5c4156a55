/* report.js - the page: shows records (page.c) as text, tables and pictures. Observable Plot draws its charts, if make
   page-deps installed it. figures.mjs uses the functions in node. */
const ssgi_report = (() => {
const records = {};

/* ---- >>data ------------------------------------------------------------------------------------------------- */

/* Returns a csv's rows as objects. Cells without quotes that look like numbers become numbers. */
function parse(text) {
    const rows = [], cell = /("(?:[^"]|"")*"|[^,\n]*)(,|\n|$)/y;
    let row = [];
    while (cell.lastIndex < text.length) {
        const [, value, end] = cell.exec(text);
        row.push(value[0] === '"' ? value.slice(1, -1).replaceAll('""', '"')
                 : value === '' ? null : isNaN(value) ? value : +value);
        if (end !== ',') { rows.push(row); row = []; }
    }
    const head = rows.shift() ?? [];
    return rows.map(r => Object.fromEntries(head.map((key, i) => [key, r[i] ?? null])));
}
const known = v => v !== null && v !== undefined && !Number.isNaN(v);
const mean = list => { const v = list.filter(known); return v.length ? v.reduce((a, b) => a + b) / v.length : null; };
const median = list => {
    const v = list.filter(known).sort((a, b) => a - b), n = v.length;
    return n ? (v[(n - 1) >> 1] + v[n >> 1]) / 2 : null;
};
/* Returns half of the 95 % interval of the mean of a list of numbers. */
const half = list => {
    const v = list.filter(known), m = mean(v);
    return v.length > 1 ? 1.96 * Math.sqrt(v.reduce((s, x) => s + (x - m) ** 2, 0) / (v.length - 1) / v.length) : null;
};
const grouped = (rows, key) => {
    const groups = new Map();
    for (const r of rows) {
        const k = typeof key === 'function' ? key(r) : r[key];
        groups.has(k) ? groups.get(k).push(r) : groups.set(k, [r]);
    }
    return groups;
};
const unique = list => [...new Set(list)];

/* Returns a row's name: its label, and its method and settings unless the label names them. */
const named = r => `${r.label && r.label !== r.method ? `${r.label}: ` : ''}${r.method ?? ''}${
    r.settings ? ` ${r.settings}` : ''}`;
const families = ['ssao', 'hsao', 'ssdo', 's3ho', 'ssbn', 'dss', 'aof'];
const family = r => families.find(f => String(r.method).startsWith(f)) ?? 'others';

/* Returns a row for all rows of one label, method and settings, with the means of their numbers. */
function means(rows) {
    return [...grouped(rows, r => [r.label, r.method, r.settings].join('|')).values()].map(group => {
        const of = { ...group[0], scene: 'mean' };
        for (const key of Object.keys(of))
            if (group.every(r => typeof r[key] === 'number' || r[key] === null) && key !== 'seed')
                of[key] = mean(group.map(r => r[key]));
        return of;
    });
}

/* For a row: the chain of make cost that draws it, and its modelled milliseconds on a device, if they are known. */
const chain_words = { 'normal=depth': 'normal=from_depth',
                      'indirect=none': 'transfer=direct,packed_coefficients=0,restore=ratio' };
const chain_key = text => text.toLowerCase().split(',').sort().join();
function modelled(r, device = 'RX 6800') {
    const others = peer(r) ? entry('cost-peers', 'cost') ?? [] : null;
    if (others) return others.find(c => c.chain === `${r.label} / ${r.settings}` && !c.pass
                                       && known(c[`${device} weighed`]))?.[`${device} weighed`] ?? null;
    const table = entry('cost', 'cost');
    if (!table) return null;
    const settings = String(r.settings ?? '').split(',').filter(Boolean).map(s => chain_words[s] ?? s);
    const is = chain_key([r.method, ...settings].join());
    const row = table.find(c => chain_key(c.chain) === is && !c.pass && known(c[`${device} weighed`]));
    return row?.[`${device} weighed`] ?? null;
}
/* Returns a record's tables with their headings, parsed once; and the first table of a kind, or null. */
function tables(record) {
    let heading = '';
    return record.tables ??= record.entries.flatMap(e => {
        if (e?.heading) heading = e.heading;
        return e?.table ? [{ heading, kind: e.table, rows: parse(e.csv) }] : [];
    });
}
const entry = (name, kind) => records[name] ? tables(records[name]).find(t => t.kind === kind)?.rows ?? null : null;

/* Return whether a row has no method (no occlusion, or the floor), and whether it is another library's. */
const given = r => r.method === 'none' || r.method === 'floor';
const peer = r => family(r) === 'others' && !given(r);

/* Returns a row for each method, with means over the pairs of a scene and a probe. */
const by_pair = rows => [...grouped(rows, named).values()].map(g => {
    const share = g.map(r => r.share), worst = g.reduce((a, b) => b.share > a.share ? b : a);
    return { label: g[0].label, method: g[0].method, settings: g[0].settings, time: mean(g.map(r => r.relative_time)),
             mean: mean(share), worst: worst.share, pair: `${worst.scene}, ${worst.probe}`,
             'below 1': share.filter(v => v < 1).length, pairs: g.length, bias: mean(g.map(r => r.irradiance_bias)) };
});
/* Returns a row for each method, with means over scenes by seed, with models apart. A kind without rows has the mean
   null; peers are fitted first. Noise: bands from 1.2 to 8 pixels, in thousandths. */
const by_kind = rows => [...grouped(rows, named).values()].map(all => {
    const g = all.filter(r => r.set !== 'models'), models = all.filter(r => r.set === 'models');
    const of_all = g.length ? g : all;
    const share = of_all.map(r => r.share), worst = of_all.reduce((a, b) => b.share > a.share ? b : a);
    const drawn = mean(g.filter(r => r.set === 'drawn').map(r => r.share));
    const of = { label: all[0].label, method: all[0].method, settings: all[0].settings, 'RX 6800, ms': modelled(all[0]),
                 mean: mean(share), '±': half(share), median: median(share), worst: worst.share,
                 of: `${worst.kind}-${worst.seed}`, 'above 1': share.filter(v => v > 1).length,
                 fitted: mean(of_all.map(r => r.fitted)), 'fitted, all': mean(of_all.map(r => r.fitted_all)),
                 noise: mean(of_all.map(r => known(r.noise_3) ? Math.hypot(r.noise_3, r.noise_8) : null)),
                 judged: drawn === null ? null : mean(g.filter(r => r.set === 'judged').map(r => r.share)), drawn };
    for (const [kind, list] of grouped(g, 'kind')) of[kind] = mean(list.map(r => r.fitted ?? r.share));
    if (models.length) Object.assign(of, { models: mean(models.map(r => r.share)),
                                           'models, worst': Math.max(...models.map(r => r.share)) });
    return of;
});
/* Returns each method's mean error of visibility for a chart by a GPU's time, with peers after their fit. */
const on_gpu = rows => by_kind(rows).map(r => ({ ...r, _ms: r['RX 6800, ms'], share: r.fitted ?? r.mean }));
/* Returns the kinds in which a peer, fitted to each picture, has a smaller error than a row of ours that costs at least
   as much, by more than the interval of their difference. */
function ahead(own, other) {
    const out = [], theirs = grouped(other, 'kind');
    for (const [kind, list] of grouped(own, 'kind')) {
        const pairs = list.map(r => r.share - (theirs.get(kind)?.find(o => o.seed === r.seed)?.fitted ?? NaN));
        const by = mean(pairs), within = half(pairs);
        if (known(by) && by > (within ?? 0) && by > 0) out.push({ kind, by, within });
    }
    return out;
}
const by_cause = record => tables(record).filter(t => t.kind.startsWith('sweep')).map(t => {
    const of = { cause: t.heading };
    for (const [method, g] of grouped(t.rows, 'method')) of[method] = g[0].number;
    return of;
});

const chains = rows => rows.filter(r => !r.pass);
const devices = rows => Object.keys(rows[0]).filter(k => k.endsWith(' weighed')).map(k => k.slice(0, -8))
    .filter(d => rows.some(r => known(r[`${d} weighed`])));

/* ---- >>charts: options of Plot, for the page and for README's SVG -------------------------------------------- */

const colours = { ssao: '#e69f00', hsao: '#0072b2', ssdo: '#009e73', s3ho: '#cc79a7', ssbn: '#56b4e9', dss: '#d55e00',
                  aof: '#8c6d31', others: '#77777f' };
const tip = r => Object.entries(r).filter(([key, v]) => known(v) && v !== '' && key[0] !== '_').map(([key, v]) =>
    `${key.replaceAll('_', ' ')}: ${typeof v === 'number' ? +v.toPrecision(4) : v}`).slice(0, 16).join('\n');

/* Returns the point at which a line's name stands: the method without settings, and best of all the one named first in
   the label. Of several settings it is the one with the smallest error; of a sweep the last one. */
function meant(group, x, y) {
    const fits = r => 2 * !r.settings + (r.method === String(r.label).split(',')[0]);
    const most = Math.max(...group.map(fits)), of = group.filter(r => fits(r) === most);
    return of.reduce(unique(of.map(named)).length > 1 ? (a, b) => b[y] < a[y] ? b : a : (a, b) => b[x] > a[x] ? b : a);
}

/* The sides of a point on which its name may stand: offset, and where the text begins. */
const sides = [{ dx: 8, dy: 0, textAnchor: 'start' }, { dx: -8, dy: 0, textAnchor: 'end' },
               { dx: 0, dy: -11, textAnchor: 'middle' }, { dx: 0, dy: 12, textAnchor: 'middle' },
               { dx: -2, dy: 12, textAnchor: 'end' }, { dx: -2, dy: -11, textAnchor: 'end' }];
/* Returns names and the side of each: the first one on which it covers no point and no other name. at: of a row, in
   pixels. */
function placed(names, points, at, width) {
    const taken = points.map(r => ({ left: at(r)[0] - 4, right: at(r)[0] + 4, top: at(r)[1] - 4, low: at(r)[1] + 4 }));
    return names.map(r => {
        const [x, y] = at(r), wide = 7.3 * String(r.label).length;
        const boxes = sides.map(({ dx, dy, textAnchor: a }) => {
            const left = x + dx - wide * { start: 0, middle: 0.5, end: 1 }[a];
            return { left, right: left + wide, top: y + dy - 6, low: y + dy + 6 };
        });
        const free = boxes.findIndex(b => b.left > 0 && b.right < width && !taken.some(t =>
            t !== b && b.left < t.right && t.left < b.right && b.top < t.low && t.top < b.low));
        const side = Math.max(free, 0);
        taken.push(boxes[side]);
        return { ...r, side };
    });
}

/* Draws points of rows, joined by label; x is logarithmic. The broad line joins rows that no row beats in x and y. */
function scatter(Plot, rows, { x, y, across, up, floor = null, width = 900, height = 520 }) {
    const points = rows.filter(r => known(r[x]) && known(r[y]) && !given(r))
        .sort((a, b) => a[x] - b[x]);
    const front = [];
    for (const r of points)
        if (!front.length || r[y] < front.at(-1)[y]) front.push(r);
    const margin = { left: 56, right: width > 600 ? 110 : 24 };
    const ends = key => [Math.min, Math.max].map(f => f(...points.map(r => r[key])));
    const [left, right] = ends(x).map(Math.log), [low, high] = ends(y), zero = low < 0.35 * high;
    const share = (v, from, to) => to > from ? (v - from) / (to - from) : 0.5;
    const at = r => [margin.left + share(Math.log(r[x]), left, right) * (width - margin.left - margin.right),
                     20 + (1 - share(r[y], zero ? 0 : low, high)) * (height - 64)];
    const names = placed([...grouped(points, 'label').values()].map(g => meant(g, x, y)), points, at, width);
    return {
        width, height, marginLeft: margin.left, marginRight: margin.right, marginBottom: 44, grid: true,
        x: { type: 'log', label: across, tickFormat: '~g' },
        y: { label: `${up}; lower is better${floor === null ? '' : '; dashed: exact, if all is paper-thin'}`, zero },
        color: { domain: Object.keys(colours), range: Object.values(colours),
                 legend: false },
        marks: [
            Plot.line(front, { x, y, curve: 'step-after', stroke: '#8884', strokeWidth: 7 }),
            floor === null ? null : Plot.ruleY([floor], { stroke: '#888', strokeDasharray: '6 4' }),
            Plot.line(points, { x, y, z: 'label', stroke: family, strokeOpacity: 0.55 }),
            ...sides.map((side, i) => Plot.text(names.filter(r => r.side === i), { x, y, text: 'label', ...side,
                fill: family, stroke: 'var(--plot-background)', strokeWidth: 3 })),
            Plot.dot(points, { x, y, fill: family, r: 4, title: tip, tip: typeof window !== 'undefined' })
        ].filter(Boolean)
    };
}

/* Draws a strip for each method: a dot for each scene, and the mean with its interval. */
function strips(Plot, rows, { x = 'share', dot = 'kind', across, width = 900 }) {
    const groups = [...grouped(rows, named).entries()].filter(([, g]) => g.some(r => known(r[x])));
    const all = groups.map(([name, g]) => ({ name, mean: mean(g.map(r => r[x])), half: half(g.map(r => r[x])) ?? 0 }));
    const most = Math.max(...all.map(a => a.mean));
    const shown = rows.filter(r => known(r[x]));
    return {
        width, height: 60 + 19 * groups.length, marginLeft: 340, marginBottom: 36,
        x: { label: across, grid: true, domain: [0, Math.min(Math.max(...shown.map(r => r[x])), 2.2 * most)],
             clamp: true },
        y: { domain: groups.map(([name]) => name), label: null, tickSize: 0,
             tickFormat: name => name.length > 48 ? `${name.slice(0, 47)}\u2026` : name },
        color: { legend: true, scheme: 'tableau10' },
        marks: [
            Plot.dot(shown, { x, y: named, fill: dot, r: 2.2, fillOpacity: 0.6, title: tip,
                              tip: typeof window !== 'undefined' }),
            Plot.link(all, { x1: a => a.mean - a.half, x2: a => a.mean + a.half, y1: 'name', y2: 'name',
                             stroke: 'currentColor', strokeWidth: 1.5 }),
            Plot.tickX(all, { x: 'mean', y: 'name', stroke: 'currentColor', strokeWidth: 2.5,
                              title: a => `${a.name}\nmean ${a.mean.toFixed(4)} +- ${a.half.toFixed(4)}` })
        ]
    };
}

function curves(Plot, rows, { log = false, up, width = 900 }) {
    const first = rows[0] ?? {}, many = rows.length / unique(rows.map(r => r.method)).length > 16;
    return {
        width, height: 400, marginLeft: 60, marginRight: 110, grid: true,
        x: { type: log ? 'log' : 'linear', label: first.unit, tickFormat: log ? '~g' : undefined },
        y: { label: up, zero: true }, color: { scheme: 'tableau10' },
        marks: [
            Plot.line(rows, { x: 'value', y: 'figure', stroke: 'method' }),
            many ? null : Plot.dot(rows, { x: 'value', y: 'figure', fill: 'method', r: 2.5 }),
            Plot.tip(rows, Plot.pointer({ x: 'value', y: 'figure', title: tip })),
            Plot.text(rows, Plot.selectLast({ x: 'value', y: 'figure', z: 'method', text: 'method', fill: 'method',
                                              dx: 6, textAnchor: 'start', fontSize: 10 }))
        ].filter(Boolean)
    };
}

/* Draws a line for each name: a bar of milliseconds from one column to another, and a tick at a third. */
const ranges = (rows, at, from, to, { x, ...more } = {}, ...marks) => ({
    width: 900, height: 60 + 18 * rows.length, marginLeft: 230, x: { label: 'milliseconds', grid: true, ...x },
    y: { domain: unique(rows.map(r => r.name)), label: null }, ...more,
    marks: [Plot_.ruleY(rows, { x1: from, x2: to, y: 'name', strokeWidth: 7, stroke: '#8888' }),
            Plot_.tickX(rows, { x: at, y: 'name', strokeWidth: 3, title: tip, tip: true }), ...marks] });

const clocks = {
    'this machine: over ssao': { x: 'relative_time', across: 'GL time over that of one unblurred 16-sample ssao' },
    'RX 6800, modelled: ms': { x: '_ms', across: 'milliseconds of an RX 6800 at 1920x1080, modelled' }
};
const timed = rows => rows.map(r => ({ ...r, _ms: modelled(r) }));
/* Returns the rows of chart.csv for the chart of ambient occlusion, with peers after their fit. */
function ambient(rows, scene) {
    return timed(scene === 'mean' ? means(rows) : rows.filter(r => r.scene === scene)).map(r =>
        ({ ...r, share: peer(r) && known(r.share_fitted) ? r.share_fitted : r.share }));
}
const floor_of = rows => rows.find(r => r.method === 'floor')?.share ?? null;

/* ---- >>page -------------------------------------------------------------------------------------------------- */

const el = (tag, attributes = {}, ...children) => {
    const e = document.createElement(tag);
    for (const [key, v] of Object.entries(attributes)) key in e ? e[key] = v : e.setAttribute(key, v);
    e.append(...children.filter(c => c !== null && c !== undefined));
    return e;
};
const plotted = options => {
    if (typeof Plot === 'undefined')
        return el('p', { className: 'faint' }, 'The chart needs @observablehq/plot: make page-deps, then this again.');
    const style = { color: 'var(--ink)', background: 'none', fontSize: '12px' };
    return el('div', { className: 'plot' }, Plot.plot({ ...options, style }));
};
const choose = (label, values, changed) => el('label', {}, `${label} `, el('select', {
    onchange: e => changed(e.target.value) }, ...values.map(v => el('option', { value: v }, v))));

let columns = new Map();
const shown = (v, key) => {
    const c = columns.get(key);
    if (!known(v)) return '–';
    if (typeof v !== 'number') return String(v);
    if (c) return (c[4] && v > 0 ? '+' : '') + v.toFixed(c[3]);
    return Number.isInteger(v) ? String(v) : String(+v.toPrecision(4));
};
/* Makes a table of rows. Columns without values are left out. A click on a head sorts. */
function table(rows, keys = null) {
    keys ??= Object.keys(rows[0] ?? {}).filter(k => k[0] !== '_' && !['label', 'method', 'settings'].includes(k)
        && (!columns.size || columns.get(k)?.[1] !== '') && rows.some(r => known(r[k]) && r[k] !== ''));
    const names = rows.length && 'method' in rows[0];
    const body = el('tbody');
    const fill = list => body.replaceChildren(...list.map(r => el('tr', {}, names ? el('td', {}, named(r)) : null,
        ...keys.map(k => el('td', { className: typeof r[k] === 'string' ? 'words' : '' }, shown(r[k], k))))));
    const sort = k => { let up = true; return () => {
        fill([...rows].sort((a, b) => (up ? 1 : -1) * (a[k] > b[k] ? 1 : a[k] < b[k] ? -1 : 0))); up = !up; }; };
    fill(rows);
    return el('div', { className: 'wide' }, el('table', {}, el('thead', {}, el('tr', {},
        names ? el('th', { onclick: () => fill(rows) }, 'method') : null, ...keys.map(k =>
            el('th', { className: typeof rows[0]?.[k] === 'string' ? 'words' : '', title: columns.get(k)?.[2] ?? '',
                       onclick: sort(k) },
               columns.get(k)?.[1] || k.replaceAll('_', ' '))))), body));
}
/* Makes a part of the page that is drawn again after each choice. */
function chosen(choices, draw) {
    const state = Object.fromEntries(Object.entries(choices).map(([k, v]) => [k, v[0]])), at = el('div');
    const again = () => at.replaceChildren(...draw(state));
    const bar = el('div', { className: 'choose' }, ...Object.entries(choices).filter(([, v]) => v.length > 1).map(
        ([k, v]) => choose(k, v, value => { state[k] = value; again(); })));
    again();
    return [bar, at];
}
const of_family = (rows, f) => f === 'all' ? rows : rows.filter(r => family(r) === f);
const all_families = rows => ['all', ...unique(rows.map(family))];

const views = {
    rows: rows => [table(rows)],
    ambient: rows => chosen({ scene: ['mean', ...unique(rows.map(r => r.scene))], family: all_families(rows),
                              clock: Object.keys(clocks).slice(0, records.cost ? 2 : 1) }, s => {
        const list = of_family(ambient(rows, s.scene), s.family), clock = clocks[s.clock];
        return [plotted(scatter(Plot_, list, { ...clock, y: 'share', floor: floor_of(ambient(rows, s.scene)),
                                               up: 'error (RMSE), share of having no AO at all' })), table(list)];
    }),
    light: rows => chosen({ family: all_families(rows), clock: Object.keys(clocks).slice(0, records.cost ? 2 : 1) },
        s => { const list = of_family(timed(rows), s.family);
            return [plotted(scatter(Plot_, list, { ...clocks[s.clock], y: 'radiance',
                up: "error (RMSE), share of the truth's mean radiance" })), table(list)]; }),
    scatter: rows => [plotted(scatter(Plot_, rows, { ...Object.values(clocks)[0], y: 'share',
        up: 'error (RMSE), share of having no AO at all' })), table(rows)],
    memory: rows => [plotted(scatter(Plot_, rows, { x: 'kilobytes', y: 'rmse', height: 280,
        across: 'kB of the fields', up: 'RMSE of occlusion' })), table(rows)],
    pairs: rows => chosen({ family: all_families(rows), probe: ['all', ...unique(rows.map(r => r.probe))] }, s => {
        const list = of_family(rows, s.family).filter(r => s.probe === 'all' || r.probe === s.probe);
        return [plotted(strips(Plot_, list.filter(r => r.share !== 1), { dot: 'probe',
            across: 'RMSE of irradiance over that of no occlusion, a dot a pair' })), table(by_pair(list))];
    }),
    seeds: rows => chosen({ of: unique(rows.map(r => r.what)), family: all_families(rows),
                            scenes: ['all', ...unique(rows.map(r => r.set)), ...unique(rows.map(r => r.kind))] }, s => {
        const list = of_family(rows, s.family).filter(r => r.what === s.of
            && (s.scenes === 'all' || r.kind === s.scenes || r.set === s.scenes));
        const sums = on_gpu(list);
        return [sums.some(r => known(r._ms)) ? plotted(scatter(Plot_, sums, { ...Object.values(clocks)[1], y: 'share',
                    up: 'error (RMSE), share of no occlusion; of others after their fit' })) : null,
                plotted(strips(Plot_, list, { across: 'RMSE over that of no occlusion, a dot a scene' })),
                table(sums, Object.keys(sums[0] ?? {}).filter(k => !['label', 'method', 'settings', '_ms', 'share']
                    .includes(k) && sums.some(r => known(r[k]))))].filter(Boolean);
    }),
    plan: rows => [plotted({ width: 700, height: 420, grid: true, marginLeft: 56,
        x: { type: 'log', label: 'error asked for', tickFormat: '~g' },
        y: { type: 'log', label: "the plan's error, measured", tickFormat: '~g' },
        color: { type: 'categorical', domain: ['good', 'not'], range: ['#0072b2', '#d55e00'], legend: true },
        marks: [Plot_.line([[0.01, 0.01], [0.2, 0.2]], { stroke: '#888' }),
                Plot_.dot(rows.filter(r => r.measured > 0), { x: 'asked', y: 'measured', r: 3, title: tip, tip: true,
                                                              stroke: r => r.good ? 'good' : 'not' })] }),
        fold('Pair by pair', () => [table(rows)])],
    sweep: rows => [plotted(curves(Plot_, rows, {})), numbers(rows)],
    'sweep-log': rows => [plotted(curves(Plot_, rows, { log: true })), numbers(rows)],
    paper: rows => paper(rows),
    cost: rows => cost(rows),
    bench: rows => {
        const list = rows.filter(r => r.pass === 'frame').map(r => ({ ...r, name: named(r) }));
        return chosen({ size: unique(list.map(r => `${r.width}x${r.height}`)) }, s => {
            const at = list.filter(r => `${r.width}x${r.height}` === s.size);
            const traffic = at.filter(r => r.traffic_ms > 0).map(r => ({ ...r, of: 'traffic' }));
            return [plotted(ranges(at, 'ms', 'lower_quartile', 'upper_quartile', { x: { type: 'log', tickFormat: '~g' },
                color: { legend: true } }, Plot_.dot(traffic, { x: 'traffic_ms', y: 'name', stroke: 'of', r: 3 }))),
                table(at)];
        });
    },
    quiet: rows => {
        const list = rows.map(r => ({ ...r, label: r.settings ? `${r.method} ${r.settings}` : r.method,
            noise: known(r.noise_seen) ? 1e3 * r.noise_seen : null, error: 1e3 * r.truth_seen }));
        return ['noise', 'error'].map(y => plotted(scatter(Plot_, list, { x: 'ms', y, height: 340,
            across: 'milliseconds', up: `${y} of 1.2 to 8 pixels, thousandths of visibility` }))).concat(
            table(rows, ['ms', ...Object.keys(rows[0]).filter(k => /^(noise|truth)_/.test(k))]));
    }
};

const numbers = rows => table([...grouped(rows, r => r.method).values()].map(g =>
    ({ method: g[0].method, settings: g[0].settings, number: g[0].number })));

/* Makes a paper's sheet from its cells, one for each line: texts, a table and the claims. */
function paper(cells) {
    const text = kind => cells.find(c => c.kind === kind)?.text, word = v => known(v) ? String(v) : '';
    const rows = [...grouped(cells.filter(c => c.row > 0), 'row').values()].map(g => {
        const method = g.find(c => c.kind === 'method'), note = g.find(c => c.kind === 'note')?.text;
        const of = { "the paper's": word(g.find(c => c.kind === 'what')?.text),
                     ours: method?.head ? `${method.head} ${word(method.text)}${note ? `; ${note}` : ''}`
                                        : `not drawn: ${word(note)}` };
        for (const c of g) if (c.kind === 'printed') of[`paper: ${c.head}`] = c.text;
        for (const c of g) if (c.kind === 'measured' || c.kind === 'time') of[c.head] = c.text;
        for (const c of g) if (c.kind === 'modelled' && c.text) of[`${c.head}, modelled`] = c.text;
        return of;
    });
    return [el('p', {}, el('b', {}, 'The paper: '), word(text('theirs')),
               text('erratum') ? ` Erratum: ${text('erratum')}` : ''),
            el('p', {}, el('b', {}, 'Here: '), word(text('ours'))), table(rows, Object.keys(rows[0] ?? {})),
            el('ul', {}, ...cells.filter(c => c.kind === 'claim').map(c => el('li', {}, c.text)))];
}

function cost(rows) {
    return chosen({ device: devices(rows), passes: ['chains', ...unique(chains(rows).map(r => r.chain))] }, s => {
        const key = `${s.device} weighed`, of = s.passes === 'chains' ? chains(rows) : rows.filter(r =>
            r.chain === s.passes && r.pass);
        const list = of.filter(r => known(r[key])).map(r => ({ ...r, name: r.pass || r.chain }));
        return [plotted(ranges(list, key, `${s.device} calm`, `${s.device} busy`)),
                table(list, ['name', key, `${s.device} busy`, `${s.device} calm`, 'busy', 'fetches', 'bytes_in',
                             'bytes_out', 'vgprs', 'waves'])];
    });
}

/* Makes a folded part of the page, whose contents are made when it is opened. */
const fold = (title, make) => {
    const d = el('details', {}, el('summary', {}, title));
    d.addEventListener('toggle', () => d.children.length < 2 && d.append(...make()));
    return d;
};

function figure(e) {
    const link = (slug, label) => el('a', { href: `${slug}.png` }, el('img', { src: `${slug}.png`, alt: label,
        width: e.width, height: e.height, loading: 'lazy' }));
    return el('figure', {}, el('figcaption', {}, el('b', {}, e.label), el('span', {}, e.note)),
              link(e.picture, e.label),
              e.difference ? link(`${e.picture}-difference`, `difference of ${e.label}`) : null);
}
/* Shows a record's entries. Pictures that follow each other form a grid. Those below a heading of level 4 are pairs,
   and lie folded, once for each heading. */
function shown_entries(entries) {
    const out = [];
    const folded = new Map();
    let grid = null, pairs = null;
    for (const e of entries) {
        if (!e) continue;
        if (e.columns) { columns = new Map(e.columns.map(c => [c[0], c])); continue; }
        if (e.level === 4) {
            const list = pairs = folded.get(e.heading) ?? [];
            if (!list.length) out.push(fold(`Pictures of ${e.heading}`, () => [el('div', { className: 'grid pairs' },
                                                                                  ...list.map(figure))]));
            folded.set(e.heading, list);
            continue;
        }
        if (e.picture && pairs) { pairs.push(e); continue; }
        pairs = null;
        if (e.picture || e.key) {
            const style = `--wide: ${e.width > 320 ? 400 : 220}px`;
            if (!grid) out.push(grid = el('div', { className: 'grid', style }));
            grid.append(e.picture ? figure(e) : el('figure', { className: 'key' },
                el('img', { src: 'legend-difference.png', alt: 'blue over white to red' }),
                el('div', { className: 'faint' }, el('span', {}, `−${e.key} too dark`), el('span', {}, '0'),
                   el('span', {}, `too bright +${e.key}`)),
                el('p', { className: 'faint' }, 'Under each picture: its difference to the truth.')));
            continue;
        }
        grid = null;
        if (e.heading) out.push(el(`h${e.level}`, {}, e.heading));
        else if (e.paragraph) out.push(el('p', { className: e.paragraph.length > 60 ? 'faint' : '' }, e.paragraph));
        else if (e.table) out.push(...(views[e.table] ?? views.rows)(parse(e.csv)));
    }
    return out;
}

/* Returns a table of one number for each method and cause, from a record of all sweeps. */
function worst(record) {
    const rows = by_cause(record);
    return rows.length ? [table(rows, unique(rows.flatMap(Object.keys)))] : [];
}

/* The terms that the page explains. The first two stand above the demo's first pictures, where a reader needs them. */
const terms = [
    ['time', 'The time of an image, denoisers included, over that of ssao with 16 samples and without a denoiser on '
        + 'the same machine: 2 is twice as long. Both are drawn in turns, and the median of several rounds counts.'],
    ['error', 'The RMSE of an image against ray tracing, without a fitted gain or exponent. For occlusion it is '
        + 'divided by the RMSE of an image without any (tables: share): 0 is exact, 1 is no better than doing nothing. '
        + 'For light it is divided by the mean of the ray-traced light (radiance).'],
    ['milliseconds, modelled', 'An estimate for a GPU, from a compiler\'s count of instructions.'],
    ['bytes', 'The bytes that all passes read and write for a pixel. Each texel of their textures counts once.'],
    ['bias, p95, SSIM', 'The mean difference, below 0 if the image is too dark; the difference that 95 % of the pixels '
        + 'stay below; and structural similarity.'],
    ['model, noise', 'The model\'s error is that of the mean image over phases of the noise. The noise is the '
        + 'deviation of a pixel over these phases.'],
    ['floor', 'The exact answer if the surfaces of one depth layer are thin sheets. Information that would lower this '
        + 'error is not in the depth buffer.'],
    ['the broad line', 'No other point of the chart is both faster and more accurate.'],
    ['radiance, irradiance, bounce', 'RMSE over the mean of the ground truth, red, green and blue together, of the '
        + 'light that leaves the surface; of the light that arrives, over pi; and of light reflected once before.'],
    ['three.js, n8ao, Babylon.js, PlayCanvas', 'The code of these libraries, denoisers included, on the same depth and '
        + 'normals. Fitted: after the better of a v^b and 1 - a (1 - v)^b for each image, found by the ground truth.']
];

/* Each record's name, command and subject, in the order of the page, which also lists records that are not there, so
   that readers know of them. Parts of the chart have no subject, and are not listed. */
const commands = [
    ['demo', 'make demo', 'every method beside its truth'],
    ['chart', 'make chart', 'speed against accuracy'],
    ['ambient'], ['lit'], ['fields'], ['deep'],
    ['light', 'make light', 'light on every pair of a scene and a probe'],
    ['seeds', 'make seeds', 'scenes by seed'],
    ['seeds-fit'],
    ['plan', 'build/report plan', "the planner's choices"],
    ['stability', 'make stability', 'where methods fail'],
    ['papers', 'make papers', "the papers' tables and figures"],
    ['cost', 'make cost', 'milliseconds of a GPU, modelled'],
    ['cost-peers', 'make cost-peers', "the same of others' effects"],
    ['quiet', 'make quiet', 'noise that the eye sees'],
    ['bench', 'make bench', 'milliseconds, measured on a GPU']
];
function missing() {
    const list = commands.filter(([name, command]) => command && !records[name]).flatMap(([, command, about], i) =>
        [i ? ', ' : '', el('code', {}, command), ` (${about})`]);
    return list.length && el('p', { className: 'faint' }, 'More pages, once their commands have run: ', ...list, '.');
}

/* README's pictures, which the demo opens with, and their sizes, so that nothing moves when they arrive. */
const pictures = [
    { picture: 'lit', width: 1284, height: 266, label: 'A whole frame, lit by the sky',
      note: 'without occlusion; with ssdo and one bounce; by ray tracing' },
    { picture: 'beside-1001', width: 1266, height: 660, label: 'A crop at 200 %',
      note: 'beside other libraries and ray tracing' },
    { picture: 'moving', width: 1384, height: 756, label: 'A moving box at 200 %',
      note: 'with history; without; by ray tracing' }
];
const glance = () => el('details', { open: true }, el('summary', {}, el('h2', {}, 'At a glance')),
                        el('div', { className: 'grid glance' }, ...pictures.map(figure)));

/* Methods in README's order, each with a picture of the demo (drawn: the preset that drew it). */
const methods = [
    { method: 'hsao', drawn: 'hsao-best', picture: 'ao-bunny-hsao-best', truth: 'ao-bunny-ray-traced-truth',
      'take it for': 'ambient occlusion; times irradiance, cheap light',
      'instead, or besides': 'hsao-fast, hsao-best; hsao-history over frames; thickness BACK for wide plates' },
    { method: 'ssdo', picture: 'lit-bunny-ssdo-with-bounce', truth: 'lit-bunny-ray-traced-truth',
      'take it for': 'coloured light with direction, and a diffuse bounce',
      'instead, or besides': 'ssdo-best; thickness SLABS has the least error; chain.reuse makes the bounce cheap' },
    { method: 's3ho', picture: 'lit-blocks-s3ho', truth: 'lit-blocks-ray-traced-truth',
      'take it for': 'the same, of light kept as spherical harmonics',
      'instead, or besides': 's3ho-fast, s3ho-best; shadow maps for long shadows of suns' },
    { method: 'aof', picture: 'aof-occluders-0-casters', truth: 'aof-occluders-0-ray-traced-truth',
      'take it for': 'occlusion by rigid objects that move, seen or not',
      'instead, or besides': 'a shorter reach in a crowd; hsao within an object' },
    { method: 'dss', picture: 'deep-bunny-on-floor-dss', truth: 'deep-bunny-on-floor-ray-traced-truth',
      'take it for': 'occlusion wherever the camera looks, of hidden things, too',
      'instead, or besides': 'dss-lit for a bounce, dss-gloss for a specular one, dss-scatter under the surface' }
];
function front(entries) {
    const shown = (slug, label) => {
        const e = entries.find(e => e?.picture === slug);
        return e && figure({ ...e, label, difference: 0 });
    };
    return [defined(terms.slice(0, 2)), el('div', { className: 'grid methods' }, ...methods.map(m =>
        el('div', {}, shown(m.picture, m.drawn ?? m.method), shown(m.truth, 'truth')))),
            el('div', { className: 'when' }, table(methods, ['take it for', 'instead, or besides']))];
}
const defined = list => el('dl', {}, ...list.flatMap(([t, d]) => [el('dt', {}, t), el('dd', {}, d)]));

/* Opens all folded parts around the section id of the address, as it may lie inside of one. */
function reveal(id) {
    const at = document.getElementById(id);
    for (let e = at; e; e = e.parentElement) if ('open' in e) e.open = true;
    at ? at.scrollIntoView() : scrollTo(0, 0);
}
/* Shows a record. All sections but the first are folded, which keeps the page short. Their text is made at once, so
   that a search in the page opens the section with the word. */
function record(of) {
    const lead = [], parts = [];
    for (const e of of.entries)
        if (e?.level !== 2) (parts.at(-1)?.entries ?? lead).push(e);
        else parts.push({ title: e.heading, id: `${of.name}/${e.heading.toLowerCase().replace(/\W+/g, '-')}`,
                          entries: [] });
    columns = new Map();
    const is_demo = of === records.demo, above = shown_entries(lead);
    return [
        ...(is_demo ? [glance()] : []), el('p', { className: 'contents' }, ...parts.map(({ id, title }, i) => {
            const [, group, rest] = title.match(/(.+?: )(.+)/) ?? [];
            return el('a', { href: `#${id}`, onclick: () => reveal(id) },
                      group && parts[i - 1]?.title.startsWith(group) ? rest : title);
        })),
        ...(is_demo ? front(of.entries) : []), missing() || '',
        el('p', { className: 'faint' }, `${of.command}: ${of.kind === 'full' ? '' :
            `a ${of.kind === 'quick' ? 'quick run, smaller and with fewer rows' : 'part'}; `}commit ${of.commit}, ${
            of.cores} cores (${of.processor}), ${of.driver}`),
        ...worst(of), ...above, ...parts.map(({ title, id, entries }, i) => el('details', { id, open: !i },
            el('summary', {}, el('h2', {}, title)), ...shown_entries(entries))),
        fold('What the figures mean', () => [defined(terms.slice(is_demo ? 2 : 0))])];
}

/* Loads the records that are there, then shows them. */
function load() {
    for (const [name] of commands) document.head.append(el('script', { src: `${name}.js`, async: false }));
    addEventListener('load', show);
}

let Plot_;
function show() {
    Plot_ = typeof Plot === 'undefined' ? new Proxy({}, { get: () => () => null }) : Plot;
    const names = Object.keys(records), main = document.getElementById('main');
    if (!names.length) return main.append(missing());
    let now;
    const open = () => {
        const id = decodeURIComponent(location.hash.slice(1)), of = records[id.split('/')[0]] ?? records[names[0]];
        if (of !== now) {                          /* a shown record stays: somebody may be about to click in it */
            document.getElementById('records').replaceChildren(...names.map(n => el('a', { href: `#${n}`,
                className: records[n] === of ? 'now' : '' }, n)));
            main.replaceChildren(...record(now = of));
        }
        reveal(id);
    };
    addEventListener('hashchange', open);
    open();
}

return { records, parse, mean, grouped, named, means, modelled, tables, entry, given, peer, by_pair, by_kind, by_cause,
         on_gpu, ahead, chains, devices, scatter, ambient, floor_of, clocks, load };
})();

function ssgi_record(record) { ssgi_report.records[record.name] = record; }
if (typeof module !== 'undefined') module.exports = { ssgi_report, ssgi_record };
