/* test_tools.c - what a shell sees of the examples: what programs print and refuse, packages, files of GLSL, make. */
#include <float.h>
#include <math.h>
#include <zlib.h>
#include "kit/kit_gl.h"
#include "shell.h"

/* examples/minimal.c with the header of OSMesa and as it is read without: the same picture, on the CPU. */
static void minimal(void)
{
    static const struct { const char *header, *line; } ways[] = {
        { "GL/osmesa.h", "cp '%s/examples/minimal.c' examples && gcc $W examples/minimal.c -lOSMesa -lm -o minimal%s" },
        { "EGL/egl.h", "sed 's|__has_include.*|0|' '%s/examples/minimal.c' >examples/egl.c && "
                       "gcc $W examples/egl.c -lEGL -lGL -lm -o minimal%s" } };
    char text[4000];
    int ran = 0;
    setenv("W", "-std=c99 -Wall -Wextra -Werror", 1);
    shell(text, sizeof text, "mkdir examples%s%s", "", "");
    for (size_t i = 0; i < sizeof ways / sizeof *ways; ++i) {
        if (shell(text, sizeof text, "echo '#include <%s>' | gcc -E -%s", ways[i].header, "")) {
            t_note("%s is not here: not tried", ways[i].header);
            continue;
        }
        CHECK(!shell(text, sizeof text, ways[i].line, t_root, "")
                  && !shell(text, sizeof text, "LIBGL_ALWAYS_SOFTWARE=1 ./minimal && head -c 15 ao.pgm && "
                            "test $(tail -c +16 ao.pgm | tr -d '\\377' | wc -c) -gt 100000%s%s", "", "")
                  && strstr(text, "P5 960 540 255"),
              "%s: %s", ways[i].line, text);
        CHECK(!shell(text, sizeof text, "%s ao.pgm other.pgm%s", ran ? "cmp" : "mv", ""), "by %s: %s", ways[i].header,
              text);
        ++ran;
    }
    CHECK(ran, "neither OSMesa nor EGL is here");
}

/* Where there is no OSMesa, which empty files in its place stand for, the default context is EGL's, and draws the same;
   who asks for it is told. */
static void without_osmesa(void)
{
    char text[4000];
    if (shell(text, sizeof text, "'%s/build/render' plane --size 8x8 --context egl --out egl.exr%s", t_root, "")) {
        t_note("not tried: %s", text);
        return;
    }
    CHECK(!shell(text, sizeof text, "mkdir lacks && cd lacks && touch libOSMesa.so libOSMesa.so.6 libOSMesa.so.8 && "
                 "cd .. && '%s/build/render' room --size 64x36 --out with.exr && export LD_LIBRARY_PATH=lacks && "
                 "'%s/build/render' room --size 64x36 --json --out without.exr && cmp with.exr without.exr", t_root,
                 t_root)
              && strstr(text, "llvmpipe"), "%s", text);
    CHECK(shell(text, sizeof text, "LD_LIBRARY_PATH=lacks '%s/build/render' room --size 8x8 --context osmesa --out "
                "a.exr%s", t_root, "") == 2 && strstr(text, "libOSMesa.so is not there"), "%s", text);
}

/* install.sh as root on a Debian where these packages are there, and those can be had. */
static void installs(void)
{
    static const char rest[] = "gcc make pkg-config libopenexr-dev libstb-dev glslang-tools glmark2-data",
                      egl[] = "libegl-dev libegl-mesa0 libgl1-mesa-dri";
    static const struct { const char *has, *can, *got; } cases[] = {
        { "libosmesa6-dev", "", "" }, { egl, "libosmesa6-dev", "" },
        { "", "libosmesa6-dev libegl-dev libegl-mesa0 libgl1-mesa-dri", "libosmesa6-dev\n" },
        { "libegl-mesa0", egl, "libegl-dev libgl1-mesa-dri\n" }, { "", "", NULL } };
    char text[4000], line[600];
    shell(text, sizeof text, "mkdir bin%s%s", "", "");
    write_text("bin/id", "echo 0\n");
    write_text("bin/dpkg-query", "case \" $HAS \" in *\" $4 \"*) echo install ok installed ;; *) exit 1 ;; esac\n");
    write_text("bin/apt-get", "[ $1 = update ] && exit\nshift 3\necho \"$@\" >asked\n"
                              "for p; do case \" $CAN \" in *\" $p \"*) ;; *) exit 100 ;; esac; done\nmv asked got\n");
    shell(text, sizeof text, "chmod +x bin/*%s%s", "", "");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        snprintf(line, sizeof line, "export HAS='%s %s' CAN='%s' PATH=\"$PWD/bin:$PATH\"", rest, cases[i].has,
                 cases[i].can);
        const int status = shell(text, sizeof text, "%s; : >got; sh '%s/examples/kit/install.sh' >said 2>&1; s=$?; "
                                 "cat got; exit $s", line, t_root);
        CHECK(cases[i].got ? !status && !strcmp(text, cases[i].got) : status == 1, "%s: status %d, installs %s", line,
              status, text);
    }
}

/* The library of GLSL as files: Khronos' compiler takes each as it stands, and by every command in its head; back it is
   the same header, to the byte; an edit arrives; a broken file is refused by name and leaves the header as it was. */
static void library_as_files(void)
{
    static const struct { const char *edit, *says; } broken[] = {
        { "sed -i '/^..@@ the room/,/^#endif$/{/^#endif$/d}' glsl/visibility.glsl", "not in pairs" },
        { "echo '// mine' >glsl/mine.glsl", "mine.glsl: is no room" },
        { "rm glsl/fetch.glsl", "fetch.glsl" },
        { "printf %%s '//@ ssgi_x' >>glsl/fetch.glsl", "fetch.glsl: is no text that ends its last line" },
        { ": >glsl/fetch.glsl", "fetch.glsl: " } };
    char text[4000], line[600];
    CHECK(!shell(text, sizeof text,
                 "cp ssgi_gl.h edited.h && '%s/build/library' out edited.h glsl && "
                 "'%s/build/library' in edited.h glsl && cmp ssgi_gl.h edited.h",
                 t_root, t_root), "%s", text);
    CHECK(
        !shell(
            text, sizeof text,
            "cd glsl && sed -n 's|^//  *glslangValidator|run|p' *.glsl >../heads.sh && test $(wc -l <../heads.sh) -gt "
            "%s "
            "&& echo 'run -l -S frag -Dmain_ssdo -DSSGI_PASS=2 -DSSGI_SEARCH=0 -DSSGI_ENVIRONMENT=1 -DSSGI_BANDS=2 "
            "-DSSGI_BOUNCE=1 -DSSGI_THICKNESS=5 -DSSGI_ORTHOGRAPHIC=1 -DSSGI_HALF=2 gather.glsl' >>../heads.sh && sed "
            "'1irun() { glslangValidator \"$@\" >../said || { echo \"$@\"; cat ../said; }; }' ../heads.sh | sh "
            ">../all; cat "
            "../all; test ! -s ../all%s",
            "40", ""),
        "a room is no GLSL: %s", text);
    CHECK(!shell(text, sizeof text,
                 "sed -i 's/SSGI_UNSEEN = [0-9.]*/SSGI_UNSEEN = 0.5/' glsl/*.glsl && "
                 "'%s/build/library' in edited.h glsl && diff ssgi_gl.h edited.h | "
                 "grep -c '^> .*SSGI_UNSEEN = 0.5' && gcc -fsyntax-only -xc edited.h%s",
                 t_root, ""), "an edit of a file does not reach the header: %s", text);
    for (size_t i = 0; i < sizeof broken / sizeof *broken; ++i) {
        snprintf(line, sizeof line,
                 "cp ssgi_gl.h edited.h && rm -r glsl && '%%s/build/library' out edited.h glsl && "
                 "%s && ! '%%s/build/library' in edited.h glsl && cmp ssgi_gl.h edited.h", broken[i].edit);
        const int failed = shell(text, sizeof text, line, t_root, t_root);
        const char *end = strchr(text, '\n');
        CHECK(!failed && end && !end[1] && strstr(text, broken[i].says), "%s: %s", broken[i].edit, text);
    }
}

/* Are brackets and strings of a JSON text closed? */
static int balanced(const char *s)
{
    char open[64];
    int depth = 0, quoted = 0;
    for (; *s; ++s) {
        if (quoted) { if (*s == '\\' && s[1]) ++s; else quoted = *s != '"'; continue; }
        quoted = *s == '"';
        if ((*s == '[' || *s == '{') && depth < 64) open[depth++] = *s;
        if ((*s == ']' || *s == '}') && (!depth || open[--depth] != (*s == ']' ? '[' : '{'))) return 0;
    }
    return !depth && !quoted;
}

/* Every file is a variant's, every variant has its files, members fill their blocks. */
static void manifest(void)
{
    static const char *const check =
        "import json, os\n"
        "m = json.load(open('texts/manifest.json'))\n"
        "files = {f for v in m['variants'] for f in v['files'].values()} | set(m['functions']) | {'manifest.json'}\n"
        "files |= {f for c in m['chains'] for s in c['steps'] for f in s['files'].values()}\n"
        "assert files == set(os.listdir('texts')), files ^ set(os.listdir('texts'))\n"
        "for v in m['variants']:\n"
        "    rows = [m['rows'][i] for i in m['row_lists'][v['rows']]]\n"
        "    assert any(r['kind'] in ('OUTPUT', 'CAPTURE') for r in rows), v\n"
        "    for r in rows:\n"
        "        assert any(r['name'] in open('texts/' + f).read() for f in v['files'].values()), (v, r)\n"
        "    for name, value in v['desc'].items():\n"
        "        f = next(f for f in m['desc']['fields'] if f['name'] == name)\n"
        "        value = f['values'].index(value) if f['values'] else value\n"
        "        assert 0 <= value <= f['most'], v\n"
        "for b in m['frame'], m['views']:\n"
        "    end = 0\n"
        "    for x in b['members']:\n"
        "        assert x['offset'] == end, x\n"
        "        end += x['bytes']\n"
        "    assert (end + 15) // 16 * 16 == b['size'], end\n"
        "for c in m['chains']:\n"
        "    written = set()\n"
        "    for s in c['steps']:\n"
        "        rows = [m['rows'][i] for i in s['rows']]\n"
        "        texts = ''.join(open('texts/' + f).read() for f in s['files'].values())\n"
        "        assert all(r['name'] in texts for r in rows), (c, s)\n"
        "        for kind, side in ('TEXTURE', s['inputs']), ('OUTPUT', s['outputs']):\n"
        "            assert [r['name'] for r in rows if r['kind'] == kind] == [x['name'] for x in side], (c, s)\n"
        "        for i in s['inputs']:\n"
        "            assert 'yours' in i or i['last'] or i['texture'] in written, (c, s)\n"
        "        written |= {o['texture'] for o in s['outputs']}\n"
        "    assert written == set(range(len(c['textures']))), c\n"
        "    assert any(t['result'] != 'NONE' for t in c['textures']), c\n"
        "    assert all(t['format'] < len(m['formats']) for t in c['textures']), c\n"
        "names = [c['name'] for c in m['chains']]\n"
        "assert len(set(names)) == len(names) and {'hsao-fast', 'hsao', 'hsao-best', 'hsao-history'} < set(names)\n"
        "default = {x['name']: x for x in m['frame']['members']}\n"
        "assert default['offset']['default'] == 1.5 and default['rotation']['default'] == [1,0,0,0, 0,1,0,0, 0,0,1,0]\n"
        "assert default['size']['default'] == 'view' and default['fade']['times'] == 'radius'\n"
        "assert m['defaults']['hsao']['steps'] == 6 and m['defaults']['lights']['samples'] == 8\n"
        "print(len(m['variants']), 'variants')\n";
    char text[4000], path[256], *json;
    if (!CHECK(!shell(text, sizeof text, "'%s/build/glsl-text' texts 300es%s", t_root, ""), "%s", text)) return;
    snprintf(path, sizeof path, "%s/texts/manifest.json", folder);
    json = read_text(path);
    CHECK(json && balanced(json), "manifest.json: brackets or strings are not closed");
    free(json);
    write_text("manifest.py", check);
    if (has("python3")) CHECK(!shell(text, sizeof text, "python3 manifest.py%s%s", "", ""), "%s", text);
}

/* A chain as one writes it, and what is wrong with one. */
static void own_chain(void)
{
    static const struct { const char *chain, *says; } wrong[] = {
        { "hsao,best,depth=NEAR --330 own", "desc.input.depth: must be" },
        { "hsao,depht=LINEAR --330 own", "name: there is no such field; the nearest is depth" },
        { "hsao,best,depth --330 own", "name: must be NAME[,PRESET]" },
        { "gtao --330 own", "--chain gtao: name: there is no such method; the nearest are hsao, hsao-fast" },
        { "hsao,multisampled=1 --300es own", "desc.input.multisampled: " },
        { "dss,surfels=1 --vulkan own", "desc.pass: surfels" },
        { "hsao own", "in which language" }, { "hsao --330", "the folder is missing" },
        { "hsao --glsl own", "--glsl: must be" } };
    char text[4000], line[512];
    CHECK(!shell(text, sizeof text, "'%s/build/glsl-text' --chain hsao,depth=linear --300es --450 "
                 "own && test $(ls own | wc -l) = 13 && grep -q 'SSGI_STEPS = 8' own/*2-hsao.450.frag && "
                 "! grep -q ssgi_decode own/*.frag%s", t_root, ""), "%s", text);
    CHECK(!shell(
              text, sizeof text,
              "'%s/build/glsl-text' --chain ssdo-points,environment=SH,bounce=PATCH,"
              "layers=8,views=4,view_layers=8,lights.layers=8,lights.views=4,lights.view_layers=8,vpls=1 --450 many && "
              "ls many/*.100-* && grep -q 'vpls=1\", \"dialect\": \"450\", \"about' many/manifest.json%s",
              t_root, ""),
          "124 steps: %s", text);
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; ++i) {
        snprintf(line, sizeof line, "'%s/build/glsl-text' --chain %s", t_root, wrong[i].chain);
        const int status = shell(text, sizeof text, "%s%s", line, "");
        const char *end = strchr(text, '\n');
        CHECK(status == 2 && end && !end[1] && strstr(text, wrong[i].says), "%s: status %d, %s", line, status, text);
    }
}

/* The headers without a C library, in node: every text and row of the manifest, blocks as C makes them, errors. */
static void wasm(void)
{
    static const char *const blocks =
        "#define SSGI_IMPLEMENTATION\n#define SSGI_GL_IMPLEMENTATION\n#include \"ssgi_gl.h\"\n#include <stdio.h>\n"
        "int main(void) {\n"
        "    float m[16] = { 1.3f,0,0,0, 0,2.4f,0,0, 0,0,-1.002f,-1, 0,0,-0.2002f,0 }, id[16] = { 1,0,0,0, 0,1,0,0, "
        "0,0,1,0, 0,0,0,1 }, last[16] = { 1,0,0,0, 0,1,0,0, 0,0,1,0, 0.25f,0,0,1 }, sh[3] = { 1, 2, 3 };\n"
        "    ssgi_view v; ssgi_gl_frame f;\n"
        "    ssgi_view_from_projection(&v, m, SSGI_CLIP_GL, 64, 48, NULL);\n"
        "    ssgi_gl_frame_init(&f, &v, 0.5f, NULL);\n"
        "    ssgi_gl_frame_history(&f, &v, id, last, NULL);\n"
        "    ssgi_gl_harmonics_set(&f, sh, 1, NULL, NULL);\n"
        "    f.phase = ssgi_gl_phase(5);\n"
        "    ssgi_gl_surfels_set(&f, &v, &(ssgi_surfel_desc){ .size = 0.03f, .keep_small = 1 }, NULL, NULL);\n"
        "    return fwrite(&f, 1, sizeof f, stdout) != sizeof f;\n"
        "}\n";
    static const char *const script =
        "import { readFileSync as read } from 'node:fs';\n"
        "import { equal, deepEqual, throws } from 'node:assert/strict';\n"
        "const { load } = await import(process.argv[2] + '/ssgi.mjs');\n"
        "const ssgi = await load();\n"
        "const formatOf = f => ({ name: f.name, ...f.gl, bytes: f.bytes, vulkan: f.vulkan_number,\n"
        "                         vulkan_name: f.vulkan, webgpu: f.webgpu });\n"
        "for (const folder of ['texts', 'others']) {\n"
        "    const m = JSON.parse(read(folder + '/manifest.json', 'utf8'));\n"
        "    for (const v of m.variants) {\n"
        "        const desc = v.fetch ? { ...v.desc, fetch: m.fetch } : v.desc;\n"
        "        for (const [stage, file] of Object.entries(v.files))\n"
        "            equal(ssgi.text(desc, stage), read(folder + '/' + file, 'utf8'), file);\n"
        "        deepEqual(ssgi.rows(desc), m.row_lists[v.rows].map(i => m.rows[i]));\n"
        "    }\n"
        "    for (const c of m.chains) {\n"
        "        const steps = ssgi.steps({ ...c.chain, width: 1, height: 1 });\n"
        "        equal(steps.length, c.steps.length, c.name);\n"
        "        equal(steps.length <= 32, true, `${c.name} does not fit into SSGI_GL_MAX_STEPS`);\n"
        "        for (const [i, step] of steps.entries()) {\n"
        "            const said = c.steps[i];\n"
        "            for (const [stage, file] of Object.entries(said.files))\n"
        "                equal(ssgi.text(step.desc, stage), read(folder + '/' + file, 'utf8'), file);\n"
        "            deepEqual(step.inputs.map(k => [k.name, k.unit, k.set, k.binding, k.meaning ?? k.texture, k.last]),\n"
        "                      said.inputs.map(k => [k.name, k.unit, k.set|0, k.binding, k.yours ?? k.texture, "
        "k.last ?? 0]));\n"
        "            deepEqual(step.outputs.map(k => [k.texture, k.slice, k.format]), said.outputs.map(k =>\n"
        "                [k.texture, k.slice, formatOf(m.formats[c.textures[k.texture].format])]));\n"
        "            deepEqual([step.size, step.frame, step.vertices, step.instances, step.blend[0] !== 0],\n"
        "                      [said.size, said.frame, said.vertices, said.instances, said.blend !== null]);\n"
        "        }\n"
        "    }\n"
        "    deepEqual(ssgi.members.length, m.frame.members.length + m.views.members.length);\n"
        "    deepEqual(ssgi.resolve({ pass: 'HSAO' }), m.defaults.hsao);\n"
        "}\n"
        "const id = [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1], last = [...id];\n"
        "last[12] = 0.25;\n"
        "const view = ssgi.view([1.3,0,0,0, 0,2.4,0,0, 0,0,-1.002,-1, 0,0,-0.2002,0], 64, 48);\n"
        "const frame = ssgi.harmonics(ssgi.history(ssgi.frame(view, 0.5), view, id, last), [1, 2, 3], 1);\n"
        "frame.phase[0] = ssgi.phase(5);\n"
        "ssgi.surfels(frame, view, { size: 0.03, keep_small: true }, 3);\n"
        "deepEqual(Buffer.from(frame.buffer), read('frame.bin'));\n"
        "equal(frame.radius[0], 0.5);\n"
        "const d = ssgi.preset({ pass: 'HSAO', version: '' }, 'FAST');\n"
        "equal(d.half, 'FIRST');\n"
        "equal(ssgi.text(d).indexOf('#version'), -1);\n"
        "equal(typeof ssgi.key(d), 'bigint');\n"
        "throws(() => ssgi.text({ pass: 'HSAO', steps: 99 }), /^Error: desc.gather.steps: must be 0..64$/);\n"
        "throws(() => ssgi.text({ pass: 'NONE' }), /^Error: desc.pass: must be/);\n"
        "equal(ssgi.read(d).match(/float ssgi_visibility_at/g).length, 1);\n"
        "throws(() => ssgi.read({ pass: 'EMITTERS' }), /^Error: desc.pass: /);\n"
        "equal(ssgi.reflection().match(/^float ssgi_specular_visibility/m).length, 1);\n"
        "throws(() => ssgi.text({ stpes: 1 }), /^Error: desc.stpes: there is no such field$/);\n"
        "throws(() => ssgi.frame(view, -1), /^Error: radius: /);\n"
        "throws(() => ssgi.view(id, 0, 1), /^Error: width: /);\n"
        "throws(() => ssgi.preset({}, 'GOOD'), /^Error: preset: /);\n"
        "const many = { search: 'POINTS', layers: 8, views: 4, view_layers: 8 };\n"
        "const all = ssgi.steps({ desc: { pass: 'SSDO', bounce: 'PATCH', environment: 'SH', ...many }, blur: 1, vpls: "
        "1,\n"
        "                         lights: { pass: 'LIGHTS', ...many }, width: 64, height: 64 });\n"
        "equal(all.length, 124);\n"
        "equal(all.at(-1).outputs[0].result, 'BOUNCE');\n"
        "const { calls, works } = await import(process.argv[3] + '/tests/web-hostile.mjs');\n"
        "for (const [call, says] of calls({ load, Ssgi: ssgi.constructor }, ssgi)) {\n"
        "    const e = await Promise.resolve().then(call).then(() => null, e => e);\n"
        "    equal(e?.constructor === Error && (says.test ? says.test(e.message) : says === e.message), true,\n"
        "          `${call}: ${e?.name}: ${e?.message}`);\n"
        "}\n"
        "equal(works(ssgi), true);\n";
    char text[4000], path[256], *bytes = NULL;
    size_t size = 0;
    if (!(has("clang") & has("wasm-ld") & has("node"))) return;
    if (!CHECK(!shell(text, sizeof text, "MAKEFLAGS= make -s -C '%s' wasm%s", t_root, ""), "%s", text)) return;
    snprintf(path, sizeof path, "%s/build/wasm/ssgi.wasm", t_root);
    if (CHECK(!kit_file_read(&bytes, &size, path, NULL) && size <= 252 * 1024, "ssgi.wasm has %zu bytes", size))
        t_note("ssgi.wasm has %zu bytes", size);
    free(bytes);
    write_text("blocks.c", blocks);
    write_text("wasm.mjs", script);
    CHECK(!shell(text, sizeof text, "'%s/build/glsl-text' others 330 && gcc -I. blocks.c -o blocks %s && "
                 "./blocks >frame.bin", t_root, "-lm"), "%s", text);
    CHECK(!shell(text, sizeof text, "node wasm.mjs '%s/build/wasm' '%s'", t_root, t_root), "%s", text);
}

/* What make install and make npm leave serves their tools. */
static void packages(void)
{
    static const char *const program =
        "#define SSGI_IMPLEMENTATION\n#define SSGI_GL_IMPLEMENTATION\n#include <ssgi_gl.h>\n"
        "int main(void) { ssgi_gl_desc d = { 0 }; return ssgi_gl_emit(NULL, 0, &d, SSGI_GL_STAGE_FRAGMENT) < 100; }\n";
    static const char *const script =
        "import { load } from 'ssgi';\n"
        "import { readFileSync as read } from 'node:fs';\n"
        "import { createRequire } from 'node:module';\n"
        "const require = createRequire(import.meta.url), ssgi = await load();\n"
        "const gl = require('ssgi/manifest.json'), gpu = require('ssgi/wgsl/manifest.json');\n"
        "const text = name => read(new URL(import.meta.resolve(`ssgi/${name}`)), 'utf8');\n"
        "const check = (ok, what) => { if (!ok) throw new Error(`the package disagrees with itself: ${what}`); };\n"
        "check(ssgi.version === gl.ssgi && gl.chains.length > 30 && gpu.chains.length > 30, 'chains');\n"
        "for (const { name, chain, steps } of gl.chains) {\n"
        "    const desc = { ...chain.desc, dialect: '300ES' }, lights = { ...chain.lights, dialect: '300ES' };\n"
        "    const drawn = ssgi.steps({ ...chain, desc, ...chain.lights && { lights }, width: 64, height: 64 });\n"
        "    check(drawn.length === steps.length, name);\n"
        "    for (const [i, { files }] of steps.entries())\n"
        "        for (const stage in files)\n"
        "            check(ssgi.text(drawn[i].desc, stage) === text(`glsl/${files[stage]}`), files[stage]);\n"
        "}\n"
        "for (const { steps } of gpu.chains)\n"
        "    for (const { files } of steps)\n"
        "        for (const [stage, word] of [['vert', '@vertex'], ['frag', '@fragment']])\n"
        "            check(text(`wgsl/${files[stage]}.wgsl`).includes(word), files[stage]);\n"
        "const before = Reflect.ownKeys(globalThis).length;\n"
        "for (const name of ['three', 'webgl', 'webgpu', 'chains/hsao']) await import(`ssgi/${name}`);\n"
        "check(Reflect.ownKeys(globalThis).length === before, 'modules have side effects');\n";
    char text[4000];
    CHECK(!shell(text, sizeof text, "MAKEFLAGS= make -s -C '%s' install DESTDIR='%s/to' PREFIX=/usr", t_root,
                 folder), "%s", text);
    shell(text, sizeof text, "mkdir -p app%s%s", "", "");
    write_text("app/app.c", program);
    if (has("pkg-config"))
        CHECK(!shell(text, sizeof text, "export PKG_CONFIG_PATH=$PWD/to/usr/share/pkgconfig && pkg-config "
                     "--exact-version=0.5 ssgi && gcc $(pkg-config --cflags ssgi) app/app.c -o app/app "
                     "$(pkg-config --libs ssgi) && app/app%s%s", "", ""), "%s", text);
    if (has("cmake")) {
        write_text("app/CMakeLists.txt",
                   "cmake_minimum_required(VERSION 3.5)\nproject(app C)\nfind_package(ssgi 0.5 REQUIRED)\n"
                   "find_package(ssgi 0.3 QUIET)\nif(ssgi_FOUND)\n  message(FATAL_ERROR \"0.4 passes for 0.3\")\n"
                   "endif()\nadd_executable(app app.c)\ntarget_link_libraries(app ssgi::ssgi)\n");
        CHECK(!shell(text, sizeof text, "cmake -S app -B app/build -DCMAKE_PREFIX_PATH=$PWD/to/usr -DCMAKE_C_COMPILER_"
                     "WORKS=1 && cmake --build app/build && app/build/app%s%s", "", ""), "%s", text);
        CHECK(!shell(text, sizeof text,
                     "cmake -S '%s/examples/tools/packages' -B cmake && cmake --install cmake --prefix by-cmake && "
                     "diff -r by-cmake to/usr%s",
                     t_root, ""),
              "cmake installs otherwise: %s", text);
        CHECK(!shell(text, sizeof text,
                     "sed -i 's|^find.* REQUIRED.*|add_subdirectory(\"%s/examples/tools/packages\" ssgi)|; "
                     "/^find/,/^endif/d' app/CMakeLists.txt && cmake -S app -B app/within -DCMAKE_C_COMPILER_WORKS=1 "
                     "&& cmake --build app/within && app/within/app%s",
                     t_root, ""),
              "as a part of another project: %s", text);
    }
    CHECK(!shell(text, sizeof text, "MAKEFLAGS= make -s -C '%s' uninstall DESTDIR='%s/to' PREFIX=/usr && test -z "
                 "\"$(find to -type f)\"", t_root, folder), "left behind: %s", text);
    snprintf(text, sizeof text, "%s/build/tint/twgsl.wasm", t_root);
    const int translates = !access(text, R_OK) && has("glslangValidator");
    if (!translates) t_note("package not tried, without tint: make npm brings it");
    if (has("clang") & has("wasm-ld") & has("node") & has("npm") & translates) {
        shell(text, sizeof text, "mkdir page page/three%s%s", "", "");
        write_text("page/npm.mjs", script);
        write_text("page/used.mjs", "export { SSGIPass } from 'ssgi/three';\n");
        write_text("page/bare.mjs", "import 'ssgi';\nimport 'ssgi/three';\nimport 'ssgi/chains/hsao';\n");
        write_text("page/three/package.json", "{ \"name\": \"three\", \"version\": \"0.187.0\", \"type\": \"module\", "
                   "\"exports\": \"./three.js\" }");
        write_text("page/three/three.js", "export class Matrix4 { set() { return this; } }\n");
        CHECK(!shell(text, sizeof text, "MAKEFLAGS= make -s -C '%s' npm && cd page && for of in '%s'/build/ssgi-*.tgz "
                     "./three; do npm install --offline --no-audit --no-fund --silent \"$of\" || exit 1; "
                     "done && test -d node_modules/ssgi && ! test -L node_modules/ssgi && node npm.mjs", t_root,
                     t_root),
              "the package as npm installs it, then another one: %s", text);
        CHECK(!shell(text, sizeof text, "cd '%s/build' && grep -q \"npm install PATH/TO/build/$(echo ssgi-*.tgz)\" "
                     "../README.md%s", t_root, ""), "README does not name what make npm packs");
        snprintf(text, sizeof text, "%s/build/web-deps/node_modules/.bin/esbuild", t_root);
        if (access(text, X_OK)) t_note("esbuild is not here: no bundle tried");
        else CHECK(!shell(text, sizeof text, "cd page && '%s/build/web-deps/node_modules/.bin/esbuild' --bundle "
                          "--format=esm --log-level=error --outdir=out used.mjs bare.mjs && "
                          "test $(wc -c <out/bare.js) -lt 100 && test $(wc -c <out/used.js) -gt 10000%s", t_root, ""),
                   "a bundle: %s", text);
    }
}

/* Readers of C headers in other languages: constants have the fields' type, a call works. */
static void bindings(void)
{
    static const char *const script =
        "import cffi\n"
        "ffi = cffi.FFI()\n"
        "ffi.cdef(open('plain.h').read())\n"
        "lib = ffi.dlopen('./libssgi.so')\n"
        "d = ffi.new('ssgi_gl_desc *', { 'text': { 'dialect': lib.SSGI_GL_DIALECT_300ES } })\n"
        "setattr(d, 'pass', lib.SSGI_GL_PASS_HSAO)\n"
        "n = lib.ssgi_gl_emit(ffi.NULL, 0, d, lib.SSGI_GL_STAGE_FRAGMENT)\n"
        "out = ffi.new('char[]', n + 1)\n"
        "lib.ssgi_gl_emit(out, n + 1, d, lib.SSGI_GL_STAGE_FRAGMENT)\n"
        "assert ffi.string(out).decode() == open('texts/hsao.300es.frag').read()\n"
        "print(ffi.sizeof('ssgi_gl_frame'))\n";
    char text[4000];
    write_text("bind.py", script);
    write_text("whole.c", "#define SSGI_IMPLEMENTATION\n#define SSGI_GL_IMPLEMENTATION\n#include \"ssgi_gl.h\"\n");
    if (shell(text, sizeof text, "python3 -c 'import cffi'%s%s", "", "")) t_note("cffi is not here: not tried");
    else CHECK(!shell(text, sizeof text, "gcc -E -P %s ssgi_gl.h >plain.h && gcc -shared -fPIC whole.c -o "
                      "libssgi.so %s && python3 bind.py", "'-D__attribute__(x)='", "-lm"), "%s", text);
    if (has("bindgen"))
        CHECK(!shell(text, sizeof text,
                     "bindgen ssgi_gl.h --allowlist-var 'SSGI_GL_PASS_HSAO' --allowlist-type ssgi_gl_desc -- "
                     "--target=x86_64-pc-windows-msvc -ffreestanding >bind.rs && "
                     "grep -q 'pub type ssgi_gl_pass = ::std::os::raw::c_int' bind.rs && grep -q 'pub pass: "
                     "ssgi_gl_pass' bind.rs%s%s",
                     "", ""),
              "%s", text);
}

/* ssgi_gl_method_at in each language that the headers or the module serve. */
static void methods_anywhere(void)
{
    static const char *const c =
        "#include \"ssgi_gl.h\"\n#include <stdio.h>\nint main(void) {\n    const ssgi_gl_method *m;\n"
        "    for (int i = 0; (m = ssgi_gl_method_at(i)) != NULL; ++i)\n"
        "        printf(\"%s|%s|%s|%d|%s\\n\", m->name, m->sentence, ssgi_gl_pass_name(m->pass), m->preset, "
        "m->settings);\n"
        "    return 0;\n}\n";
    static const char *const python =
        "import ctypes as c\n"
        "class Method(c.Structure):\n"
        "    _fields_ = [('name', c.c_char_p), ('sentence', c.c_char_p), ('pass_', c.c_int), ('preset', c.c_int), "
        "('settings', c.c_char_p)]\n"
        "lib = c.CDLL('./libssgi.so')\n"
        "lib.ssgi_gl_method_at.restype, lib.ssgi_gl_pass_name.restype = c.POINTER(Method), c.c_char_p\n"
        "i = 0\n"
        "while m := lib.ssgi_gl_method_at(i):\n"
        "    m, i = m.contents, i + 1\n"
        "    texts = [t.decode() for t in (m.name, m.sentence, lib.ssgi_gl_pass_name(m.pass_), m.settings)]\n"
        "    print('|'.join([*texts[:3], str(m.preset), texts[3]]))\n";
    static const char *const javascript =
        "const { load } = await import(process.argv[2] + '/build/wasm/ssgi.mjs'), ssgi = await load();\n"
        "for (const m of ssgi.methods)\n"
        "    console.log([m.name, m.sentence, m.pass.toLowerCase(), ['FAST', 'BALANCED', 'BEST'].indexOf(m.preset), "
        "m.settings].join('|'));\n";
    char text[4000];
    write_text("methods.c", c);
    write_text("methods.py", python);
    write_text("methods.mjs", javascript);
    write_text("whole.c", "#define SSGI_IMPLEMENTATION\n#define SSGI_GL_IMPLEMENTATION\n#include \"ssgi_gl.h\"\n");
    CHECK(
        !shell(text, sizeof text,
               "gcc -shared -fPIC whole.c -o libssgi.so -lm && for s in c99 c++11 c++20; do "
               "$(case $s in c99) echo gcc;; *) echo g++ -xc++;; esac) -std=$s methods.c -o m -xnone libssgi.so "
               "'-Wl,-rpath,.' && ./m >$s.txt || exit 1; done; test $(wc -l <c99.txt) -gt 20 && cmp c99.txt c++11.txt "
               "&& cmp c99.txt c++20.txt && python3 methods.py | cmp c99.txt && node methods.mjs '%s' | cmp c99.txt%s",
               t_root, ""),
        "%s", text);
}

/* One small picture of each method, every object of the kit under address and undefined-behaviour sanitizers. */
static void sanitized(void)
{
    static const char *const world = "--env sky --light sun:1,2,1,3,3,3", *const cheap = "--set resolution=4,rays=16";
    char text[4000];
    kit_method m;
    for (int i = 0; kit_method_at(&m, i); ++i) {
        char arguments[160];
        snprintf(arguments, sizeof arguments, "boxes --size 64x36 --method %s %s --out s.exr", m.name, m.lit ? world
            : m.between ? cheap : "");
        CHECK(!shell(text, sizeof text, "ASAN_OPTIONS=detect_leaks=0 '%s/build/render-sanitized' %s", t_root,
            arguments), "render %s: %s", arguments, text);
    }
}

/* What is lost on its way out: status 2, one line. What is odd but readable or writable is read and written. */
static void streams(void)
{
    static const struct { const char *line, *word; } lost[] = {
        { "%s/build/render --list >/dev/full", "standard output" }, { "%s/build/render --list >&-", "standard output" },
        { "%s/build/render room --size 8x8 --score s.exr --json >/dev/full", "standard output" },
            { "%s/build/render room --size 8x8 --score s.exr >&-", "standard output" },
        { "%s/build/glsl-text --passes ssgi_gl.h >/dev/full", "standard output" },
            { "%s/build/glsl-text --passes ssgi_gl.h >&-", "standard output" },
        { "ulimit -f 8 && %s/build/render room --size 160x90 --out big.exr", "big.exr: cannot be written" },
        { "ulimit -v 300000 && %s/build/render room --size 4096x4096 --out big.exr", "4096 x 4096" },
        { "ln -s loop.exr loop.exr && %s/build/render room --size 8x8 --out loop.exr", "loop.exr" } };
    char text[4000], line[512];
    CHECK(!shell(text, sizeof text, "'%s/build/render' room --size 8x8 --out s.exr%s", t_root, ""), "%s", text);
    for (size_t i = 0; i < sizeof lost / sizeof lost[0]; ++i) {
        snprintf(line, sizeof line, lost[i].line, t_root);
        const int status = shell(text, sizeof text, "%s%s", line, "");
        const char *end = strchr(text, '\n');
        CHECK(status == 2 && end && !end[1] && strstr(text, lost[i].word), "%s: status %d, %s", line, status, text);
    }
    CHECK(shell(text, sizeof text, "ls big* s.exr.*%s%s", "", ""), "left behind: %s", text);
    CHECK(!shell(text, sizeof text,
                 "ln -s there.exr here.exr && '%s/build/render' room --size 8x8 --out here.exr && test -L here.exr && "
                 "cmp there.exr s.exr%s",
                 t_root, ""),
          "a dangling link is not written through: %s", text);
    CHECK(!shell(text, sizeof text, "for s in 0,0,0 0.3,0,0; do '%s/build/render' casters --size 64x36 --frames 2 "
                 "--method hsao-history --slide $s --out $s-%%d.exr || exit 1; done; cmp 0,0,0-0.exr 0.3,0,0-0.exr && "
                 "! cmp -s 0,0,0-1.exr 0.3,0,0-1.exr%s", t_root, ""),
          "an object slides from the second frame on: %s", text);
    CHECK(!shell(text, sizeof text, "'%s/build/render' cr.obj --size 8x8 --out cr.exr && test -s cr.exr%s",
        t_root, ""), "lines that end in CR: %s", text);
}

/* Bad command lines and files: status 2, one line that names the argument or file, nothing left behind. */
static void command_line(void)
{
    static const struct { const char *arguments, *word;
    } cases[] = { { "nowhere.obj --out a.exr", "nowhere.obj" },
                  { "cut.obj --out a.exr", "cut.obj" },
                  { "empty.obj --out a.exr", "empty.obj" },
                  { "far.obj --out a.exr", "1e+38" },
                  { "room --method none --out a.exr", "--method none" },
                  { "room --set steps=99 --out a.exr", "steps=99" },
                  { "casters --method aof --set cap_table=1,resolution=4,rays=16 --out a.exr", "cap_table=1: size:" },
                  { "casters --method aof --set unfiltered=2 --out a.exr", "unfiltered=2" },
                  { "room --method hsao-march --set terms=all --out a.exr", "terms=all" },
                  { "room --set colour=1 --out a.exr", "colour=1" },
                  { "room --set left_handed=2 --out a.exr", "left_handed=2" },
                  { "room --size 0x5 --out a.exr", "--size 0x5" },
                  { "room --camera 1,2 --out a.exr", "--camera 1,2" },
                  { "room --camera 1,1,1,1,1,1 --out a.exr", "--camera" },
                  { "room --fovy 999 --out a.exr", "--fovy 999" },
                  { "room --out a.bmp", "--out a.bmp" },
                  { "room --size 8x8 --out none/a.exr", "none/a.exr" },
                  { "room --size 8x8 --out none/a.png", "none/a.png" },
                  { "--gbuffer cut.exr --fovy 50 --radius 1 --out a.exr", "cut.exr" },
                  { "--gbuffer y.exr --fovy 50 --radius 1 --out a.exr", "y.exr" },
                  { "--gbuffer y.exr --radius 1 --out a.exr", "--fovy" },
                  { "room --size 8x8 --score y.exr", "y.exr" },
                  { "room --radius nan --out a.exr", "--radius nan" },
                  { "room --radius -1 --out a.exr", "--radius -1" },
                  { "room --wrong 1 --out a.exr", "--wrong" },
                  { "--list none", "--list none" },
                  { "room --context vulkan --out a.exr", "vulkan" },
                  { "room", "--out" },
                  { "room --set half=1,blur=0 --size 8x8 --out a.exr", "half=1" },
                  { "room --near 5 --far 2 --out a.exr", "--far" },
                  { "room --env sky --out a.exr", "--env" },
                  { "room --light sun:0,1,0,1,1,1 --method hsao-march --out a.exr", "--light" },
                  { "room --method ssdo --env none.hdr --out a.exr", "none.hdr" },
                  { "room --method ssdo --out a.exr", "--method ssdo: needs light" },
        { "room --method ssdo --env sky.png --out a.exr", "sky.png" },
                  { "room --method ssdo --env y.exr --out a.exr", "y.exr" },
                  { "room --method ssdo --light lamp:1,2 --out a.exr", "lamp:1,2" },
                  { "room --method ssdo --light point:0,1,0,1,1 --out a.exr", "point:0,1,0,1,1" },
                  { "room --method ssdo --light sun:0,0,0,1,1,1 --out a.exr", "sun:0,0,0" },
                  { "room --method ssdo --light point:0,0,0,1,-1,1 --out a.exr", "1,-1,1" },
                  { "room --method ssdo --floor 4 --out a.exr", "--floor" },
                  { "room --method ssdo --set bounce=three --out a.exr", "bounce=three" },
                  { "room --method ssdo --set layers=9 --out a.exr", "layers=9" },
                  { "room --size 8x8 --env sky --method ssdo --set vpls=4 --out a.exr", "vpls=4" },
                  { "room --size 8x8 --method ssdo --env sky --score y.exr", "y.exr" },
                  { "--gbuffer f.exr --fovy 57 --radius 0.5 --method ssao --set layers=2 --out a.exr", "layers=2" },
                  { "--gbuffer f.exr --fovy 57 --radius 0.5 --method ssdo-points --env sky --set views=1 --out a.exr",
                    "views=1: a frame" },
                  { "--gbuffer f.exr --fovy 57 --radius 0.5 --set thickness=slabs --out a.exr", "channel back.Z" },
                  { "room --size 8x8 --env sky --method s3ho --set dimmed=1 --out a.exr", "dimmed=1" },
                  { "room --set thin=1 --out a.exr", "--set thin=1: the setting is thickness" },
                  { "--gbuffer f.exr --fovy 57 --radius 0.5 --method ssdo --truth 4 --out a.exr", "--truth" },
                  { "room --plan best:1 --out a.exr", "--plan best:1" },
                  { "room --frames 2 --out a.exr", "--out a.exr" },
                  { "--gbuffer f.exr --fovy 57 --radius 0.5 --slide 1,0,0 --out a.exr", "--slide: needs a scene" },
                  { "plane --size 8x8 --slide 1,0,0 --out a.exr", "--slide: scene plane" },
                  { "room --still 0 --out a.exr", "--still 0" },
                  { "room --still 2 --frames 2 --out a%d.exr", "--still: cannot go with --frames" },
                  { "room --size 8x8 --method ssdo --env sky --env-strength -1 --out a.exr", "--env-strength -1" },
                  { "room --method ssdo --light sun:0,1,0,1,1,1 --env-turn 5 --out a.exr", "--env-turn: needs" },
                  { "room --method ssdo --light sun:0,1,0,1,1,1 --backdrop --out a.exr", "--backdrop: needs" },
                  { "room --size 8x8 --method ssdo --env sky --colours --out a.exr", "--colours: is of a method" },
                  { "room --frames 2 --slide 1,0 --out a%d.exr", "--slide 1,0" },
                  { "plane --size 8x8 --frames 2 --slide 1,0,0 --out a%d.exr", "--slide: scene plane" },
                  { "room --plan light:x --env sky --out a.exr", "light:x" },
                  { "--gbuffer f.exr --fovy 57 --radius 0.5 --set margin=0.5 --out a.exr", "margin=0.5" },
                  { "room --plan visibility:0.1: --out a.exr", "visibility:0.1:" },
                  { "room --plan light:0.1 --out a.exr", "--env" },
                  { "room --plan visibility:0.1 --set steps=3 --out a.exr", "--plan" },
                  /* of frames nothing is open yet that would have to be closed */
                  { "room --frames 2 --method bogus --out q%d.exr", "--method bogus" },
                  { "room --frames 2 --set steps=0 --out q%d.exr", "steps=0" },
                  { "room --frames 2 --context bogus --out q%d.exr", "bogus" },
                  { "room --frames 2 --method ssdo --out q%d.exr", "needs light" },
                  { "room --frames 2 --method ssdo --light lamp --out q%d.exr", "lamp" },
                  { "nowhere.obj --frames 2 --out q%d.exr", "nowhere.obj" },
                  { "--sequence good.txt --method bogus $F", "--method bogus" },
                  { "--sequence good.txt --set thickness=slabs $F", "channel back.Z" },
                  { "--sequence good.txt --method ssdo $F", "line 1: --gbuffer f.exr: --method ssdo needs light" },
                  { "--sequence nowhere.txt $F", "nowhere.txt" },
                  { "--sequence zero.txt $F", "zero.txt: line 3: holds a zero byte" },
                  { "--sequence blank.txt $F", "blank.txt: names no frame" },
                  { "--sequence number.txt $F", "number.txt: line 4: must be FRAME.exr" },
                  { "--sequence gone.txt $F", "gone.txt: line 2: gone.exr: cannot be read" },
                  { "--sequence cut.txt $F", "cut.txt: line 2: cut.exr" },
                  { "--sequence other.txt $F", "other.txt: line 2: small.exr: must be like the first frame in size" },
                  { "--sequence lit.txt $F", "lit.txt: line 2: lit.exr: must be like the first frame in direct.R" },
                  { "--sequence along.txt $F", "along.txt: line 2: --up" },
                  { "--sequence bare.txt --fovy 57 --out q%d.exr", "line 1: --gbuffer lit.exr: needs --radius" },
                  { "--sequence bare.txt $F", "bare.txt: line 2: --gbuffer lit.exr: needs a camera" },
                  { "--sequence good.txt --fovy 57 --radius guess --out q%d.exr", "--radius guess: needs a scene" },
                  { "--gbuffer lit.exr --fovy 57 --radius 2 --flat --out a.exr", "--flat: needs a scene" },
                  { "room --size 8x8 --method ssdo --env sky --set clamp=-1 --out a.exr", "clamp=-1" },
                  { "room --size 8x8 --method ssdo --env sky --set one_sided=1,two_sided=1 --out a.exr", "one_sided" },
                  { "--gbuffer lit.exr --ortho-height 2 --out a.exr", "lit.exr: needs --radius" },
                  { "--gbuffer lit.exr --radius 2 --out a.exr", "lit.exr: needs --fovy or --ortho-height" },
                  { "--gbuffer bent.exr --out a.exr", "bent.exr: worldToCamera: must turn" },
                  { "--gbuffer bent.exr --camera 0,0,0,1,0,0 --out a.exr", "bent.exr: screenWindowWidth nan" },
                  { "--gbuffer bent.exr --camera 0,0,0,1,0,0 --fovy 57 --out a.exr", "bent.exr: ssgi.radius 0" },
                  { "--gbuffer half.exr --fovy 57 --radius 0.5 --out a.exr", "half.exr: frame: channel N.Z" },
                  { "--gbuffer deep.exr --fovy 57 --radius 0.5 --out a.exr", "deep.exr: frame: channel N.X" },
                  { "--sequence mixed.txt $F", "mixed.txt: line 2: bent.exr: must be like the first frame in N.X" },
                  { "room --radius gues --out a.exr", "--radius gues" },
                  { "room --size 4294967304x8 --out a.exr", "--size 4294967304x8" },
                  { "room --size +8x8 --out a.exr", "--size +8x8" },
                  { "room --frames inf --out q%d.exr", "--frames inf" },
                  { "room --frames 2 --orbit nan --out q%d.exr", "--orbit nan" },
                  { "room --frames 2 --out q%+4d.exr", "--out q%+4d.exr" },
                  { "room --camera 1e30,0,0,0,0,0 --out a.exr", "1e30" },
                  { "cornell --method ssdo --light point:1e38,0,0,1,1,1 --out a.exr", "1e38" },
                  { "casters --frames 99 --slide 0,1e12,0 --out q%d.exr --size 8x8 --slide 1e13,0,0", "--slide" },
                  { "casters --frames 200 --slide 1e12,0,0 --out q%d.exr", "--slide: in 200 frames" },
                  { "room --size 8x8 --score ''", "--score: its value is empty" },
                  { "room --o", "--o: there is no such option" },
                  { "room --size 8x8 --save-gbuffer g.png", "--save-gbuffer g.png: must end in .exr" },
                  { "room --size 8x8 --save-gbuffer g.exr --out g.exr", "--save-gbuffer g.exr: is --out's" },
                  { "room --size 8x8 --save-gbuffer g.exr --score y.exr", "y.exr" },
                  { "--gbuffer f.exr --method ssdo $F", "needs light" },
                  { "--gbuffer f.exr --plan objects:0.1 $F", "--plan objects: needs a scene" },
                  { "room --plan objects: --out a.exr", "--plan objects:" },
                  { "room --size 8x8 --method s3ho --env sky --set store=float --out a.exr", "store=float" } };
    static const struct { const char *name, *text; } lists[] = {
        { "good.txt", "f.exr 1,1,3,0,0.5,0\r\n\r\nf.exr\t1,1,4,0,0.5,0,0,1,0" },
        { "blank.txt", "\n \t\n" },
        { "number.txt", "f.exr 1,1,3,0,0.5,0\n\n\r\nf.exr 1,1,3,0,nan,0\n" },
        { "gone.txt", "f.exr 1,1,3,0,0.5,0\ngone.exr 1,1,3,0,0.5,0\n" },
        { "cut.txt", "f.exr 1,1,3,0,0.5,0\rcut.exr 1,1,3,0,0.5,0\r" },
        { "other.txt", "f.exr 1,1,3,0,0.5,0\nsmall.exr 1,1,3,0,0.5,0\n" },
        { "lit.txt", "f.exr 1,1,3,0,0.5,0\nlit.exr 1,1,3,0,0.5,0\n" },
        { "along.txt", "f.exr 1,1,3,0,0.5,0\nf.exr 1,1,3,1,2,3,0,1,0\n" },
        { "bare.txt", "lit.exr 1,1,3,0,0.5,0\nlit.exr\n" },
        { "mixed.txt", "f.exr\nbent.exr 1,1,3,0,0.5,0\n" },
        { "own.txt", "f.exr\nf.exr 1,1,4,0,0.5,0\nf.exr \n" } };
    char text[4000], zero[] = "f.exr 1,1,3,0,0.5,0\n\nf.exr 1,1,3,0,0.5,0 \nf.exr 1,1,3,0,0.5,0\n";
    kit_image y;
    char path[256];
    write_text("cut.obj", "v 0 0 0\nv 1 0 0\nv 0 1");
    write_text("empty.obj", "v 0 0 0\n");
    write_text("far.obj", "v 0 0 0\nv 1e38 0 0\nv 0 1 0\nf 1 2 3\n");
    write_text("cr.obj", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r");
    snprintf(path, sizeof path, "%s/y.exr", folder);
    if (!kit_image_new(&y, 4, 4, "Y", NULL)) { kit_exr_write(&y, path, NULL); kit_image_free(&y); }
    shell(text, sizeof text, "head -c 300 %s > cut.exr%s", "y.exr", "");
    CHECK(!shell(text, sizeof text, "'%s/build/render' room --size 16x9 --save-gbuffer f.exr%s", t_root, ""),
          "a frame of one layer: %s", text);
    for (size_t i = 0; i < sizeof lists / sizeof lists[0]; ++i) write_text(lists[i].name, lists[i].text);
    zero[40] = 0;
    snprintf(path, sizeof path, "%s/zero.txt", folder);
    kit_file_write(path, zero, sizeof zero - 1, NULL);
    kit_image lit;
    snprintf(path, sizeof path, "%s/lit.exr", folder);
    if (!kit_image_new(&lit, 16, 9, "Z,N.X,N.Y,N.Z,albedo.R,albedo.G,albedo.B,direct.R,direct.G,direct.B", NULL)) {
        kit_exr_write(&lit, path, NULL);
        kit_image_free(&lit);
    }
    static const kit_header bent = { .has = KIT_HEADER_ALL, .height = NAN, .world_to_camera = { 2 } };
    static const struct { const char *name, *channels; const kit_header *header; } odd[] = {
        { "bent.exr", "Z", &bent }, { "half.exr", "Z,N.X,N.Y", NULL },
        { "deep.exr", "Z,layer1.Z,layer1.N.X,layer1.N.Y,layer1.N.Z", NULL } };
    for (size_t i = 0; i < sizeof odd / sizeof *odd; ++i) {
        kit_image frame;
        snprintf(path, sizeof path, "%s/%s", folder, odd[i].name);
        if (kit_image_new(&frame, 16, 9, odd[i].channels, NULL)) continue;
        kit_exr_write_frame(&frame, odd[i].header, path, NULL);
        kit_image_free(&frame);
    }
    CHECK(!shell(text, sizeof text, "'%s/build/render' room --size 8x8 --save-gbuffer small.exr%s", t_root, ""),
          "a smaller frame: %s", text);
    shell(text, sizeof text, "ls > before%s%s", "", "");
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        int status = shell(text, sizeof text, "F='--fovy 57 --radius 0.5 --out q%%d.exr'; '%s/build/render' %s",
                           t_root, cases[i].arguments);
        char *line = strchr(text, '\n');
        CHECK(status == 2 && line && !line[1] && strstr(text, cases[i].word), "render %s: status %d, %s",
              cases[i].arguments, status, text);
    }
    CHECK(!shell(text, sizeof text, "ls | grep -v after > after; diff before after%s%s", "", ""), "left behind: %s",
          text);
    CHECK(!shell(text, sizeof text, "'%s/build/render' room --size 64x36 --save-gbuffer g.exr --out a.exr%s",
                 t_root, "")
              && !shell(text, sizeof text,
                        "'%s/build/render' --gbuffer g.exr --fovy 57 --radius 0.5 --out b.exr --json --score a.exr%s",
                        t_root, "")
              && strstr(text, "\"rmse\""),
          "a frame saved and taken back: %s", text);
    CHECK(!shell(text, sizeof text,
                 "'%s/build/render' --gbuffer g.exr --fovy 57 --radius 0.5 --plan visibility:0.1 --json --out b.exr%s",
                 t_root, "")
              && strstr(text, "\"plan\": {\"error\""),
          "a plan of a frame: %s", text);
    CHECK(!shell(text, sizeof text, "'%s/build/render' plane --size 4x4 --plan objects:0.1 --score y.exr%s",
                 t_root, "")
              && strstr(text, "nothing: errs by 0.0000"),
          "a plan of what is between no objects: %s", text);
    CHECK(!shell(text, sizeof text, "'%s/build/render' --sequence good.txt --fovy 57 --radius 0.5 --set history=1 "
                 "--out s%%d.exr && test -s s0.exr && test -s s1.exr && ! test -e s2.exr%s", t_root, ""),
          "a sequence: %s", text);
    CHECK(!shell(text, sizeof text, "'%s/build/render' --sequence own.txt --set history=1 --out o%%d.exr && "
                 "test -s o2.exr%s", t_root, ""),
          "a sequence of frames that have their cameras: %s", text);
}

/* What render says that its picture errs by against another; below 0: it says something else. */
static double errs_by(const char *arguments, const char *reference)
{
    char text[8000];
    const int status = shell(text, sizeof text, "$R %s --json --score %s", arguments, reference);
    const char *rmse = strstr(text, "\"rmse\": ");
    return CHECK(!status && rmse, "render %s: %s", arguments, text) ? strtod(rmse + 8, NULL) : -1;
}

/* A floor and a wall, so large, at a place. */
static void write_corner(const char *name, double size, double x, double y, double z)
{
    static const double corner[8][3] = { { -2, 0, 2 }, { 2, 0, 2 }, { 2, 0, -2 }, { -2, 0, -2 },
                                         { -2, 0, -1 }, { 2, 0, -1 }, { 2, 2, -1 }, { -2, 2, -1 } };
    char text[1000] = "";
    for (int i = 0; i < 8; ++i)
        snprintf(text + strlen(text), sizeof text - strlen(text), "v %.11g %.11g %.11g\n", size * corner[i][0] + x,
                 size * corner[i][1] + y, size * corner[i][2] + z);
    strcat(text, "f 1 2 3 4\nf 5 6 7 8\n");
    write_text(name, text);
}

/* A cube of eight smooth normals is convex: nothing occludes its faces. By its own normals something does. */
static void normals_are_told(void)
{
    static const char cube[] =
        "v -1 -1 -1\nv -1 -1 1\nv -1 1 -1\nv -1 1 1\nv 1 -1 -1\nv 1 -1 1\nv 1 1 -1\nv 1 1 1\n"
        "vn -1 -1 -1\nvn -1 -1 1\nvn -1 1 -1\nvn -1 1 1\nvn 1 -1 -1\nvn 1 -1 1\nvn 1 1 -1\nvn 1 1 1\n"
        "f 1//1 2//2 4//4 3//3\nf 5//5 7//7 8//8 6//6\nf 1//1 5//5 6//6 2//2\nf 3//3 4//4 8//8 7//7\n"
        "f 1//1 3//3 7//7 5//5\nf 2//2 6//6 8//8 4//4\n";
    static const struct { const char *settings; double least, most; const char *about; } row[] = {
        { "", 0.1, 0.2, "about the mesh's own normals" },
        { "--set facets=1", 0, 0.01, "about the faces" },
        { "--set normal=depth", 0, 0.01, "about the faces" },
        { "--flat", 0, 1e-6, "" } };
    char text[4000], render[300], line[400];
    static const char at[] = "cube.obj --camera 2.5,2,4,0,0,0 --fovy 40 --size 96x54 --radius 1";
    snprintf(render, sizeof render, "%s/build/render", t_root);
    setenv("R", render, 1);
    snprintf(line, sizeof line, "%s/cube.obj", folder);
    if (!CHECK(!kit_file_write(line, cube, sizeof cube - 1, NULL), "%s: cannot be written", line)) return;
    CHECK(!shell(text, sizeof text, "$R %s --truth 4 --out smooth.exr%s", at, "")
              && strstr(text, "note: --truth: is about the mesh's own normals"), "%s", text);
    CHECK(!shell(text, sizeof text, "$R %s --flat --truth 4 --out flat.exr%s", at, "") && !strstr(text, "note"), "%s",
          text);
    for (size_t i = 0; i < sizeof row / sizeof *row; ++i) {
        snprintf(line, sizeof line, "%s %s", at, row[i].settings);
        const double off = errs_by(line, "flat.exr");
        CHECK(off >= row[i].least && off <= row[i].most, "%s: RMSE %g", row[i].settings, off);
        CHECK(!shell(text, sizeof text, "$R %s --score smooth.exr%s", line, "") && strstr(text, row[i].about)
                  && (*row[i].about || !strstr(text, "note")), "%s: %s", row[i].settings, text);
    }
}

/* A scene's picture, and that of its saved frame by nothing but that: the same up to the rounding of depths, which a
   few pixels on edges see. Light tells whether the camera looks the same way in the world. */
static void frames_carry_cameras(void)
{
    static const char *const scenes[] = {
        "room --size 96x54 --camera 3,2,4,1,1,1 --up 0.3,1,0.1 --fovy 70",
        "room --size 54x96 --camera 3,2,4,1,1,1 --up 0.3,1,0.1 --ortho-height 3.6 --radius 0.3",
        "away.obj --size 96x54 --camera 13487437.764,-4.397,-3741685.403,13487435.764,-5.397,-3741688.403" };
    static const char *const sky = "--method ssdo --env sky --set bounce=none";
    double worst = 0;
    char line[400], text[4000], render[300];
    snprintf(render, sizeof render, "%s/build/render", t_root);
    setenv("R", render, 1);
    write_corner("corner.obj", 1, 0, 0, 0);
    write_corner("away.obj", 1, 13487434.764, -6.397, -3741689.403);
    write_corner("small.obj", 2.5e-13, 0, 0, 0);
    write_corner("large.obj", 2.5e8, 0, 0, 0);
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; ++i) {
        CHECK(!shell(text, sizeof text, "$R %s --save-gbuffer f.exr --out ao.exr%s", scenes[i], "")
                  && !shell(text, sizeof text, "$R %s %s --out lit.exr", scenes[i], sky),
              "%s", text);
        snprintf(line, sizeof line, "--gbuffer f.exr %s", sky);
        const double off[2] = { errs_by("--gbuffer f.exr", "ao.exr"), errs_by(line, "lit.exr") };
        for (int k = 0; k < 2; ++k) {
            CHECK(off[k] >= 0 && off[k] < 0.001, "%s, from its frame%s: RMSE %g", scenes[i], k ? ", lit" : "", off[k]);
            worst = fmax(worst, off[k]);
        }
        static const char *const others[] = { "--fovy 30", "--ortho-height 2", "--radius 1" };
        for (size_t k = i; k < sizeof others / sizeof *others; ++k) {
            snprintf(line, sizeof line, "--gbuffer f.exr %s", others[k]);
            CHECK(errs_by(line, "ao.exr") > 0.01, "%s: %s changes nothing", scenes[i], others[k]);
        }
        static const char *const places[] = { "--up 1,0,0", "--camera 0,0,0,0,0,-1" };
        for (size_t k = i; k < sizeof places / sizeof *places; ++k) {
            snprintf(line, sizeof line, "--gbuffer f.exr %s %s", sky, places[k]);
            CHECK(errs_by(line, "lit.exr") > 0.01, "%s: %s changes nothing", scenes[i], places[k]);
        }
    }
    static const char *const places[2][3] = {
        { "corner.obj", "3,2,4,1,1,1", "1,3,2" },
        { "away.obj", "13487437.764,-4.397,-3741685.403,13487435.764,-5.397,-3741688.403",
          "13487435.764,-3.397,-3741687.403" } };
    for (int i = 0; i < 6; ++i) {
        const char *const *p = places[i % 2], *lamp = "--method ssdo --light point:";
        if (i < 2) snprintf(line, sizeof line, "%s --size 96x54 --camera %s --fovy 45 --truth 16", p[0], p[1]);
        else if (i < 4)
            snprintf(line, sizeof line, "%s --size 96x54 --camera %s --fovy 45 --save-gbuffer %d.exr %s%s,9,9,9", p[0],
                     p[1], i, lamp, p[2]);
        else snprintf(line, sizeof line, "--gbuffer %d.exr %s%s,9,9,9", i - 2, lamp, p[2]);
        if (i % 2) CHECK(errs_by(line, "near.exr") < 1e-3, "far from 0 it is another picture: %s", line);
        else CHECK(!shell(text, sizeof text, "$R %s --out near.exr%s", line, ""), "%s", text);
    }
    static const struct { const char *name, *light; } sizes[] = {
        { "corner.obj", "sun:1,2,-1,3,3,3" }, { "small.obj", "sun:1,2,-1,3,3,3" }, { "large.obj", "sun:1,2,-1,3,3,3" },
        { "corner.obj", "point:1,3,-2,9,9,9" },
        { "small.obj", "point:2.5e-13,7.5e-13,-5e-13,5.625e-25,5.625e-25,5.625e-25" } };
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; ++i) {
        snprintf(line, sizeof line, "%s --size 96x54 --method ssdo-points --set bounce=none,shadows=map,views=1 "
                 "--light %s", sizes[i].name, sizes[i].light);
        if (i % 3) CHECK(errs_by(line, "near.exr") < 0.002, "of another size it is another picture: %s", line);
        else CHECK(!shell(text, sizeof text, "$R %s --out near.exr%s", line, ""), "%s", text);
    }
    static const char *const behind[] = { "hsao --set thickness=back", "hsao --set thickness=slabs",
                                          "hsao-march --set layers=2" };
    for (size_t i = 0; i < sizeof behind / sizeof *behind; ++i) {
        CHECK(!shell(text, sizeof text, "$R plates --size 96x54 --save-gbuffer f.exr --out ao.exr --method %s%s",
                     behind[i], ""), "%s", text);
        snprintf(line, sizeof line, "--gbuffer f.exr --method %s", behind[i]);
        const double off = errs_by(line, "ao.exr");
        CHECK(off >= 0 && off < 0.002, "%s, from its frame: RMSE %g", behind[i], off);
    }
    t_note("RMSE %.1e at most from the saved frame", worst);
}

/* A frame becomes a part of a picture of 192 x 108, down and to the right. */
static void make_part(const char *path)
{
    static const int32_t shown[4] = { -96, -54, 95, 53 };
    char *bytes;
    size_t size, at = 0;
    if (!CHECK(!kit_file_read(&bytes, &size, path, NULL), "%s cannot be read", path)) return;
    while (at + 60 < size && memcmp(bytes + at, "displayWindow\0box2i", 20)) ++at;
    memcpy(bytes + at + 24, shown, sizeof shown);
    CHECK(!kit_file_write(path, bytes, size, NULL), "%s cannot be written", path);
    free(bytes);
}

/* The saved frame as Blender would write it: two view layers, 1e10 where nothing is, normals of the world. It errs by
   nothing from the frame's own picture; which layer and which channel is meant is asked for by name. A camera that is
   another one's turns the normals: it is refused, unless they are not read; the horizontal angle is told. */
static void frames_of_blender(void)
{
    static const char *const theirs[7] = { "Depth.Z",   "Normal.X",  "Normal.Y", "Normal.Z",
                                           "DiffCol.R", "DiffCol.G", "DiffCol.B" };
    static const char *const ours[7] = { "Z", "N.X", "N.Y", "N.Z", "albedo.R", "albedo.G", "albedo.B" };
    static const char *const at = "--gbuffer b.exr --camera 3,2,4,1,1,1 --fovy 70 --radius 0.3";
    static const struct { const char *arguments, *word; } bad[] = {
        { "--camera 3,2,4,1,1,1", "has several view layers, of which --layer takes one: A, B" },
        { "--camera 3,2,4,1,1,1 --layer C", "--layer C: must be one of the frame's view layers: A, B" },
        { "--layer A", "A.Normal.X is of the world: --camera must say" },
        { "--camera 3,2,4,1,1,1 --layer A --up 0,0,1", "is --up right (Blender: 0,0,1), is --fovy the vertical" },
        { "--channel Z=A.Depth.V",
          "--channel Z=A.Depth.V: there is no such channel; there are A.Depth.Z, A.DiffCol.B," },
        { "--channel Z", "--channel Z: must be NAME=CHANNEL" },
        { "--channel N.X=A.Depth.Z --channel Q=B.Depth.Z",
          "channel Z is missing, view depth; there are N.X, A.DiffCol.B, A.DiffCol.G" } };
    char text[4000], path[300], line[300], names[600] = "";
    kit_image own, frame;
    kit_camera camera = { .eye = { 3, 2, 4 }, .target = { 1, 1, 1 }, .up = { 0, 1, 0 }, .fovy = 70, .znear = 0.1f,
                          .zfar = 100, .width = 96, .height = 54 };
    float view[16], p[16];
    kit_error err = { "" };
    snprintf(path, sizeof path, "%s/o.exr", folder);
    if (!CHECK(!shell(text, sizeof text, "$R room --size 96x54 --camera 3,2,4,1,1,1 --fovy 70 --radius 0.3 "
                      "--save-gbuffer o.exr --out ao.exr%s%s", "", ""), "%s", text)
        || !CHECK(!kit_exr_read(&own, path, &err), "%s", err.text)) return;
    for (int i = 0; i < 14; ++i)
        snprintf(names + strlen(names), sizeof names - strlen(names), "%s%c.%s", i ? "," : "", "AB"[i / 7],
                 theirs[i % 7]);
    kit_camera_matrices(&camera, view, p);
    if (!CHECK(!kit_image_new(&frame, 96, 54, names, &err), "%s", err.text)) return;
    const size_t pixels = 96 * 54;
    for (size_t i = 0; i < pixels; ++i)
        for (size_t k = 0; k < 7; ++k) {
            float value = kit_image_channel(&own, ours[k])[i];
            if (!k && !(value > 0)) value = 1e10f;
            for (size_t c = 0; c < 3 && k > 0 && k < 4; ++c)
                value = (c ? value : 0) + view[4 * (k - 1) + c] * kit_image_channel(&own, ours[1 + c])[i];
            frame.data[k * pixels + i] = value;
            if (k < 4) value = k ? view[4 * (k - 1) + 2] : 1;      /* a wall before all */
            frame.data[(7 + k) * pixels + i] = value;
        }
    snprintf(path, sizeof path, "%s/b.exr", folder);
    CHECK(!kit_exr_write(&frame, path, &err), "%s", err.text);
    snprintf(line, sizeof line, "%s --layer A", at);
    const double off = errs_by(line, "ao.exr");
    CHECK(off >= 0 && off < 0.001, "Blender's layer A: RMSE %g", off);
    snprintf(line, sizeof line, "%s --layer B", at);
    CHECK(errs_by(line, "ao.exr") > 0.01, "layer B is layer A");
    CHECK(!shell(text, sizeof text, "$R --gbuffer o.exr --set normal=depth --out n.exr%s%s", "", ""), "%s", text);
    snprintf(line, sizeof line, "%s --channel Z=A.Depth.Z --set normal=depth", at);
    CHECK(errs_by(line, "n.exr") < 0.001, "a channel by its name");
    snprintf(line, sizeof line, "%s --layer A --up 0,0,1 --set normal=depth", at);
    CHECK(errs_by(line, "n.exr") < 0.001, "another --up, which nothing reads");
    CHECK(!shell(text, sizeof text, "$R %s --layer A --fovy 102.4 --out q.exr%s", at, "")
              && strstr(text, "note: --gbuffer b.exr: its normals agree with --fovy 70.0 better than with 102.4"),
          "the horizontal angle: %s", text);
    CHECK(!shell(text, sizeof text, "$R %s --layer A --out q.exr%s", at, "") && !strstr(text, "note:"), "%s", text);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i)
        CHECK(shell(text, sizeof text, "$R --gbuffer b.exr --fovy 70 --radius 0.3 --out q.exr %s%s", bad[i].arguments,
                    "") == 2 && strstr(text, bad[i].word), "%s: %s", bad[i].arguments, text);
    float *const z = kit_image_channel(&own, "Z");         /* of a sky as others have it */
    for (int k = 0; k < 2; ++k) {
        for (size_t i = 0; i < pixels / 2; ++i) z[i] = k ? FLT_MAX : 0;
        snprintf(path, sizeof path, "%s/sky%d.exr", folder, k);
        CHECK(!kit_exr_write(&own, path, &err), "%s", err.text);
    }
    CHECK(!shell(text, sizeof text, "$R --gbuffer sky0.exr --fovy 70 --radius 0.3 --out sky.exr%s%s", "", "")
              && errs_by("--gbuffer sky1.exr --fovy 70 --radius 0.3", "sky.exr") < 1e-6,
          "what is FLT_MAX away is not sky: %s", text);
    snprintf(path, sizeof path, "%s/o.exr", folder);
    make_part(path);
    CHECK(!shell(text, sizeof text, "$R --gbuffer o.exr --set normal=depth --out part.exr%s%s", "", "")
              && errs_by("--gbuffer o.exr --set normal=depth --fovy 70", "part.exr") < 1e-4
              && errs_by("--gbuffer o.exr --set normal=depth --fovy 70", "n.exr") > 0.01,
          "the angle of a picture of which the frame is a part: %s", text);
    kit_image_free(&own);
    kit_image_free(&frame);
}

/* A PNG of 16 bits, grey, its rows filtered in every way by turns; wide is below 500. */
static void write_png(const char *name, const float *value, int wide, int high)
{
    static unsigned char raw[1001 * 500], packed[1001 * 500 + 1000], file[1001 * 500 + 2000];
    const unsigned char head[13] = { 0, 0, (unsigned char)(wide >> 8), (unsigned char)wide, 0, 0,
                                     (unsigned char)(high >> 8), (unsigned char)high, 16 };
    static unsigned char row[2][1002];
    const int bytes = 2 * wide;
    char path[256];
    uLongf size = sizeof packed;
    memset(row, 0, sizeof row);
    for (int y = 0; y < high; ++y) {
        const unsigned char *above = row[(y + 1) & 1];
        unsigned char *now = row[y & 1], *out = raw + y * (bytes + 1);     /* two bytes of 0 before both */
        *out++ = (unsigned char)(y % 5);
        for (int x = 0; x < wide; ++x) {
            const int v = (int)lroundf(65535 * value[y * wide + x]);
            now[2 + 2 * x] = (unsigned char)(v >> 8);
            now[3 + 2 * x] = (unsigned char)v;
        }
        for (int i = 2; i < bytes + 2; ++i) {
            const int a = now[i - 2], b = above[i], c = above[i - 2], p = a + b - c;
            const int paeth = abs(p - a) <= abs(p - b) && abs(p - a) <= abs(p - c) ? a
                              : abs(p - b) <= abs(p - c)                           ? b
                                                                                   : c;
            const int by[5] = { 0, a, b, (a + b) / 2, paeth };
            *out++ = (unsigned char)(now[i] - by[y % 5]);
        }
    }
    compress2(packed, &size, raw, (uLong)(high * (bytes + 1)), 6);
    const struct { const char *kind; const unsigned char *data; size_t size; } chunk[] = {
        { "IHDR", head, sizeof head }, { "IDAT", packed, 100 }, { "IDAT", packed + 100, size - 100 },
        { "IEND", head, 0 } };
    size_t n = 8;
    memcpy(file, "\x89PNG\r\n\x1a\n", 8);
    for (size_t k = 0; k < 4; ++k, n += 4) {               /* and 0 for the sum, which nobody looks at */
        for (int i = 0; i < 4; ++i) file[n++] = (unsigned char)(chunk[k].size >> (24 - 8 * i));
        memcpy(file + n, chunk[k].kind, 4);
        memcpy(file + n + 4, chunk[k].data, chunk[k].size);
        n += 4 + chunk[k].size;
        memset(file + n, 0, 4);
    }
    snprintf(path, sizeof path, "%s/%s", folder, name);
    kit_file_write(path, file, n, NULL);
}

/* One way in which engines have depth: which layout, OpenGL's clip space or from 0 to 1, y down as in Vulkan, a view
   space that looks down +z; or of an orthographic camera whose eye stands this much before the frame's. */
typedef struct way { int layout, gl, down, left, orthographic; float shift; const char *options; float eye; } way;

/* What a depth buffer holds of a frame by that projection. */
static void buffer_of(float *out, const kit_image *frame, const way *w, const float p[16])
{
    const float *z = kit_image_channel(frame, "Z");
    for (int i = 0; i < frame->width * frame->height; ++i) {
        const double deep = (double)z[i] - (double)w->eye, along = w->left ? deep : -deep;
        const double clip = ((double)p[10] * along + (double)p[14]) / ((double)p[11] * along + (double)p[15]);
        out[i] = !(z[i] > 0) ? (float)(w->layout == KIT_DEPTH_NORMAL) : (float)(w->gl ? 0.5 + 0.5 * clip : clip);
    }
}

/* The farthest that a depth is from the frame's and so much more, as a share of it; 1 where only one of them shows
   something. */
static double depths_off(const kit_image *a, const kit_image *b, double more)
{
    const float *z[2] = { kit_image_channel(a, "Z"), kit_image_channel(b, "Z") };
    double most = 0;
    for (int i = 0; i < a->width * a->height; ++i)
        if (z[0][i] > 0 || z[1][i] > 0)
            most = fmax(most, z[0][i] > 0 && z[1][i] > 0 ? fabs((double)z[1][i] / ((double)z[0][i] + more) - 1) : 1);
    return most;
}

/* The frame that the script makes has the depths that went into the buffer, and the camera. pictures: 1: of an EXR, 2:
   of a PNG as well */
static void capture(const kit_image *frame, kit_camera camera, const way *w, int pictures)
{
    char text[4000], path[256], words[800] = "";
    float p[16], view[16], q[16];
    kit_image buffer, made;
    kit_header header;
    kit_error err = { "" };
    camera.depth = w->layout;
    for (int i = 0; i < 2; ++i) camera.shift[i] = w->shift * (float)(1 + i);
    if (w->orthographic) { camera.fovy = 0; camera.ortho_height = 4; }
    /* behind the eye, or far before it, depths begin at the near plane, less a thousandth of the range */
    const double range = (double)(camera.zfar - camera.znear),
                 more = w->eye != 0 ? 1e-3 * range - (double)camera.znear : 0;
    camera.znear -= w->eye;
    camera.zfar -= w->eye;
    kit_camera_matrices(&camera, view, p);
    if (w->layout == KIT_DEPTH_NORMAL && !w->gl) {                         /* from [-w, w] to [0, w] */
        p[10] = 0.5f * (p[10] + p[11]);
        p[14] = 0.5f * (p[14] + p[15]);
    }
    for (int i = 8; i < 12 && w->left; ++i) p[i] = 0 - p[i];
    for (int i = 1; i < 16 && w->down; i += 4) p[i] = 0 - p[i];
    for (int i = 0; i < 16; ++i)
        snprintf(words + strlen(words), sizeof words - strlen(words), "%s%.9g", i ? "," : "", (double)p[i]);
    if (!CHECK(!kit_image_new(&buffer, frame->width, frame->height, "A,R", &err), "%s", err.text)) return;
    buffer_of(kit_image_channel(&buffer, "R"), frame, w, p);
    write_png("depth.png", kit_image_channel(&buffer, "R"), frame->width, frame->height);
    snprintf(path, sizeof path, "%s/depth.exr", folder);
    CHECK(!kit_exr_write(&buffer, path, &err), "%s", err.text);
    kit_image_free(&buffer);
    snprintf(path, sizeof path, "%s/made.exr", folder);
    for (int png = 0; png < pictures; ++png) {
        const char *options = w->options;
        char projection[900];
        if (!options) snprintf(projection, sizeof projection, "--projection=%s%s", words, w->gl ? " --gl" : "");
        snprintf(words + 700, 100, "depth.%s made.exr", png ? "png" : "exr");
        if (!options) options = projection;
        if (!CHECK(!shell(text, sizeof text, "python3 $C %s %s", words + 700, options), "%s", text)
            || !CHECK(!kit_exr_read(&made, path, &err) && !kit_exr_header(&header, KIT_HEADER_ALL, path, &err), "%s",
                      err.text)) return;
        const double off = depths_off(frame, &made, more);
        CHECK(off < (png ? 2e-3 : 2e-5 + 1e-7 * fabs((double)w->eye)), "%s, %s: depth off by %g", options,
              png ? "PNG" : "EXR", off);
        kit_camera c = { .znear = camera.znear, .zfar = camera.zfar, .width = frame->width, .height = frame->height };
        kit_camera_from_header(&c, &header);
        kit_camera_matrices(&camera, view, p);
        kit_camera_matrices(&c, view, q);
        for (int i = 0; i < 16; ++i)
            CHECK(i == 10 || i == 14 || fabsf(p[i] - q[i]) < 1e-5f, "%s: projection[%d] %g, not %g", words, i,
                  (double)q[i], (double)p[i]);
        kit_image_free(&made);
    }
}

/* View depth and normals as raw floats, the bottom row first, normals in the world: the frame and its camera come
   back. */
static void raw_captures(void)
{
    char text[4000], path[300], words[800] = "", window[100];
    float view[16], p[16], *raw[2] = { NULL, NULL };
    kit_image frame = { 0 }, made;
    kit_header header;
    kit_camera camera = { .znear = 0.1f, .zfar = 100, .width = 96, .height = 54 };
    kit_error err = { "" };
    snprintf(path, sizeof path, "%s/g.exr", folder);
    if (!CHECK(!shell(text, sizeof text, "$R room --size 96x54 --save-gbuffer g.exr%s%s", "", ""), "%s", text)
        || !CHECK(!kit_exr_read(&frame, path, &err) && !kit_exr_header(&header, KIT_HEADER_ALL, path, &err), "%s",
                  err.text)) return;
    kit_camera_from_header(&camera, &header);
    kit_camera_matrices(&camera, view, p);
    for (int i = 0; i < 16; ++i)
        snprintf(words + strlen(words), sizeof words - strlen(words), "%s%.9g", i ? "," : "", (double)view[i]);
    const size_t pixels = 96 * 54;
    for (int k = 0; k < 2; ++k) raw[k] = malloc((k ? 3 : 1) * pixels * sizeof(float));
    static const char *const names[4] = { "Z", "N.X", "N.Y", "N.Z" };
    for (size_t i = 0; i < pixels && raw[0] && raw[1]; ++i) {
        const size_t from = (53 - i / 96) * 96 + i % 96;
        float n[3];
        raw[0][i] = kit_image_channel(&frame, names[0])[from];
        for (int k = 0; k < 3; ++k) n[k] = kit_image_channel(&frame, names[1 + k])[from];
        for (size_t k = 0; k < 3; ++k)
            raw[1][3 * i + k] = view[4 * k] * n[0] + view[4 * k + 1] * n[1] + view[4 * k + 2] * n[2];
    }
    for (int k = 0; k < 2 && raw[0] && raw[1]; ++k) {
        snprintf(path, sizeof path, "%s/%s", folder, k ? "n.raw" : "z.raw");
        CHECK(!kit_file_write(path, raw[k], (k ? 3 : 1) * pixels * sizeof(float), &err), "%s", err.text);
    }
    snprintf(window, sizeof window, "--fovy=%.9g --radius=0.5", (double)camera.fovy);
    snprintf(path, sizeof path, "%s/raw.exr", folder);
    setenv("V", words, 1);
    CHECK(!shell(text, sizeof text, "python3 $C z.raw raw.exr --linear --bottom-up --size=96x54 --normals=n.raw "
                 "--world --view=$V %s%s", window, ""), "%s", text);
    if (CHECK(!kit_exr_read(&made, path, &err), "%s", err.text)) {
        double most = 0;
        for (int c = 0; c < 4; ++c)
            for (size_t i = 0; i < pixels; ++i)
                most = fmax(most, fabs((double)(kit_image_channel(&made, names[c])[i]
                                                - kit_image_channel(&frame, names[c])[i])));
        CHECK(most < 1e-5, "a channel is off by %g", most);
        kit_image_free(&made);
    }
    CHECK(!shell(text, sizeof text, "$R --gbuffer g.exr --out a.exr && $R --gbuffer raw.exr --score a.exr%s%s", "", "")
              && strstr(text, "RMSE 0.000"), "the picture of raw floats: %s", text);
    for (int k = 0; k < 2; ++k) free(raw[k]);
    kit_image_free(&frame);
}

/* Every layout of depth becomes the same frame; what the script makes is rendered as the scene is. */
static void captures(void)
{
    static const char by_numbers[] = "--fovy=50 --near=0.1 --far=100 --radius=0.5",
                      endless[] = "--fovy=50 --near=0.1 --reversed --radius=0.5";
    static const way ways[] = {
        { KIT_DEPTH_NORMAL, 1, 0, 0, 0, 0, NULL, 0 },   { KIT_DEPTH_NORMAL, 0, 0, 0, 0, 3, NULL, 0 },
        { KIT_DEPTH_NORMAL, 0, 1, 0, 0, 3, NULL, 0 },   { KIT_DEPTH_REVERSED, 0, 0, 1, 0, 0, NULL, 0 },
        { KIT_DEPTH_INFINITE, 0, 1, 1, 0, 5, NULL, 0 }, { KIT_DEPTH_NORMAL, 1, 0, 0, 1, 2, NULL, 0 },
        { KIT_DEPTH_REVERSED, 0, 0, 1, 1, 0, NULL, 0 }, { KIT_DEPTH_NORMAL, 1, 0, 0, 1, 0, NULL, 0.1f },
        { KIT_DEPTH_NORMAL, 1, 0, 0, 1, 0, NULL, 3 }, { KIT_DEPTH_REVERSED, 0, 0, 0, 1, 0, NULL, 3 },
        { KIT_DEPTH_REVERSED, 0, 1, 0, 1, 0, NULL, -4096 }, { KIT_DEPTH_NORMAL, 0, 0, 0, 0, 0, by_numbers, 0 },
        { KIT_DEPTH_INFINITE, 0, 0, 0, 0, 0, endless, 0 } };
    static const struct { const char *arguments, *word; } bad[] = {
        { "none.png a.exr --fovy=50 --near=1", "none.png" },
        { "cut.png a.exr --fovy=50 --near=1", "cut.png: is cut off" },
        { "cut.exr a.exr --fovy=50 --near=1", "cut.exr" },
        { "z.raw a.exr --linear --fovy=50 --size=95x54", "z.raw: must have 20520 bytes, has 20736" },
        { "z.raw a.exr --linear --fovy=50 --size=96", "--size: must be WIDTHxHEIGHT" },
        { "depth.exr a.exr --linear --fovy=50 --normals=depth.exr", "depth.exr: has no channels X Y Z or R G B" },
        { "depth.exr a.exr --linear --fovy=50 --normals=depth.png", "depth.png: must be RGB of 8 or 16 bits" },
        { "depth.exr a.exr --linear --fovy=50 --normals=f.exr --world", "--world: needs --normals and --view" },
        { "depth.exr a.exr --linear --fovy=50 --view=1,2", "--view: must be 16 numbers" },
        { "noise.txt a.exr --fovy=50 --near=1", "noise.txt: is neither PNG nor EXR" },
        { "depth.exr a.exr --fovy=50 --near=1 --channel=Q", "has no channel Q" },
        { "depth.exr a.exr", "needs --projection, or --fovy" },
        { "depth.exr a.exr --fovy=50 --near=2 --far=1", "needs --projection, or --fovy" },
        { "depth.exr a.exr --projection=1,2,3", "--projection" },
        { "depth.exr a.exr --projection=1,0,0,0,0,1,0,0,0,0,-1,-2,0,0,-1,0", "--projection" },
        { "depth.exr a.exr --projection=1,0,0,0,0,1,0,0,0,0,-1,1,0,0,nan,0", "shows nothing" },
        { "depth.exr nowhere/a.exr --fovy=50 --near=0.1", "nowhere/a.exr" } };
    char text[4000], path[300];
    kit_image frame;
    kit_header header;
    kit_error err = { "" };
    if (!has("python3")) return;
    snprintf(path, sizeof path, "%s/examples/tools/capture/capture.py", t_root);
    setenv("C", path, 1);
    snprintf(path, sizeof path, "%s/f.exr", folder);
    if (!CHECK(!shell(text, sizeof text, "$R room --size 96x54 --set normal=depth --save-gbuffer f.exr %s %s",
                      "--out", "ao.exr"), "%s", text)
        || !CHECK(!kit_exr_read(&frame, path, &err) && !kit_exr_header(&header, KIT_HEADER_ALL, path, &err), "%s",
                  err.text)) return;
    /* at the origin, looking down -z, as a capture has it */
    kit_camera camera = { .target = { 0, 0, -1 }, .up = { 0, 1, 0 }, .znear = 0.1f, .zfar = 100, .width = 96,
                          .height = 54 };
    header.has = KIT_HEADER_WINDOW;
    kit_camera_from_header(&camera, &header);
    kit_image_channel(&frame, "Z")[200] = 0;                               /* nothing is there */
    for (size_t i = 0; i < sizeof ways / sizeof *ways; ++i) capture(&frame, camera, &ways[i], 1 + (i % 4 == 0));
    kit_image_free(&frame);
    const double off[2] = { errs_by("--gbuffer made.exr", "ao.exr"),
                            shell(text, sizeof text, "python3 $C depth.exr made.exr %s%s", endless, "")
                                ? -1 : errs_by("--gbuffer made.exr", "ao.exr") };
    CHECK(off[0] >= 0 && off[0] < 0.03 && off[1] >= 0 && off[1] < 0.005, "RMSE of a PNG %g, of an EXR %g", off[0],
          off[1]);
    raw_captures();
    t_note("a captured room: RMSE %.4f of 16 bits, %.4f of floats", off[0], off[1]);
    write_text("noise.txt", "noise");
    shell(text, sizeof text, "head -c 900 depth.png >cut.png; head -c 900 depth.exr >cut.exr; ls > %s%s", "before", "");
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        const int status = shell(text, sizeof text, "python3 $C %s%s", bad[i].arguments, "");
        const char *line = strchr(text, '\n');
        CHECK(status == 2 && line && !line[1] && strstr(text, bad[i].word), "capture.py %s: status %d, %s",
              bad[i].arguments, status, text);
    }
    CHECK(!shell(text, sizeof text, "ls | diff before - && rm before%s%s", "", ""), "left behind: %s", text);
}

/* JSON is JSON whatever a file's name and a reference hold; words that are a default are shown. */
static void what_is_printed(void)
{
    char text[8000], path[256];
    kit_image endless;
    snprintf(path, sizeof path, "%s/endless.exr", folder);
    if (!kit_image_new(&endless, 16, 9, "Y", NULL)) {
        for (int i = 0; i < 16 * 9; ++i) endless.data[i] = INFINITY;
        kit_exr_write(&endless, path, NULL);
        kit_image_free(&endless);
    }
    CHECK(!shell(text, sizeof text,
                 "n=$(printf 'a\\377\\303\\251\\355\\240\\200\\\\\"\\tb.exr') && cp f.exr \"$n\" && "
                 "'%s/build/render' --gbuffer \"$n\" --fovy 57 --radius 0.5 --score endless.exr --time 1 "
                 "--json && rm \"$n\"%s",
                 t_root, ""), "%s", text);
    CHECK(strstr(text, "{\"source\": \"a\\ufffd\303\251\\ufffd\\ufffd\\ufffd\\\\\\\"\\u0009b.exr\", \"method\": "
                       "\"hsao\""),
          "a name that is no UTF-8: %s", text);
    CHECK(strstr(text, "\"rmse\": null, \"bias\": null") && !strstr(text, "nan") && !strstr(text, "inf"),
          "a score against infinity: %s", text);
    if (has("python3")) {
        write_text("json.txt", text);
        CHECK(!shell(text, sizeof text, "python3 -c 'import json; json.load(open(\"json.txt\"), parse_constant=exit)'"
                     "%s%s", "", ""), "%s", text);
    }
    CHECK(!shell(text, sizeof text, "'%s/build/render' --list s3ho%s", t_root, "")
              && strstr(text, "none [joint] apart") && strstr(text, "[linear] square") && strstr(text, "4 in 1..4"),
          "the settings of s3ho: %s", text);
}

/* ---- >>bench ----------------------------------------------------------------------------------------------------- */

/* A line of bench.csv. v: how often it was measured, ms, quartiles, bytes, fetches, operations, and the milliseconds
   that these three bound it by. */
typedef struct timed { char method[32], pass[32]; int width, height; double v[10]; } timed;

static int timed_read(timed *t, const char *line)
{
    double *v = t->v;
    return sscanf(line, "%31[^,],\"\",%d,%d,%31[^,],%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf", t->method, &t->width,
                  &t->height, t->pass, v, v + 1, v + 2, v + 3, v + 4, v + 5, v + 6, v + 7, v + 8, v + 9) == 14;
}

/* In 64 x 36 pixels, which the room fills. copied: bytes a second. */
static void bench_rows(char *csv, double copied)
{
    static const char *const passes[] = { "frame", "thickness", "hsao", "blur" };
    timed t[4];
    int n = 0;
    char *line = strtok(csv, "\n");
    for (line = line ? strtok(NULL, "\n") : NULL; line; line = strtok(NULL, "\n"), ++n)
        if (n < 4) CHECK(timed_read(&t[n], line), "bench.csv: %s", line);
    if (!CHECK(n == 4, "bench.csv: %d rows", n)) return;
    for (int i = 0; i < 4; ++i) {
        const double *v = t[i].v;
        CHECK(!strcmp(t[i].method, "hsao-best") && !strcmp(t[i].pass, passes[i]) && t[i].width == 64
              && t[i].height == 36, "row %d: %s, %s, %dx%d", i, t[i].method, t[i].pass, t[i].width, t[i].height);
        CHECK(v[0] >= 1 && v[2] > 0 && v[2] <= v[1] && v[1] <= v[3], "%s: %g times, %g ms, quartiles %g, %g",
              passes[i], v[0], v[1], v[2], v[3]);
        for (int k = 4; k < 10; ++k) CHECK(v[k] > 0, "%s: figure %d: %g", passes[i], k, v[k]);
        CHECK(v[7] <= v[1], "%s: takes %g ms, though its traffic alone takes %g", passes[i], v[1], v[7]);
        CHECK(fabs(v[4] / (v[7] * 1e-3) / copied - 1) < 0.02, "%s: %g bytes in %g ms at %g a second", passes[i], v[4],
              v[7], copied);
    }
    for (int k = 4; k < 10; ++k)
        CHECK(fabs((t[1].v[k] + t[2].v[k] + t[3].v[k]) / t[0].v[k] - 1) < 1e-4, "figure %d: %g + %g + %g, of all %g", k,
              t[1].v[k], t[2].v[k], t[3].v[k], t[0].v[k]);
    /* two slices of 7 steps each way, its own depth and normal; of bytes 16 of a normal and 8 written a pixel, 16 of
       widths at half size */
    CHECK(fabs(t[2].v[5] - 30 * 64 * 36) < 1, "hsao fetches %g texels", t[2].v[5]);
    CHECK(fabs(t[2].v[4] - (24 * 64 * 36 + 16 * 32 * 18)) < 1, "hsao moves %g bytes", t[2].v[4]);
}

/* Of the table that fit prints the lines that another has otherwise: that of choice 3, in its second cost. */
static void bench_fits(const char *plan)
{
    char text[16000], was[300], is[300];
    double cost, before[2], after[2];
    int choice;
    const char *row = strchr(plan, '\n');
    if (!CHECK(*plan == '#' && row && sscanf(row, "%d,%lf", &choice, &cost) == 2 && choice == 3 && cost > 0,
               "plan-software.csv: %s", plan))
        return;
    CHECK(!shell(text, sizeof text,
                 "'%s/build/fit' /dev/null 2>/dev/null >was.txt && "
                 "'%s/build/fit' /dev/null b/plan-software.csv 2>/dev/null >is.txt; diff was.txt is.txt | "
                 "grep -c '^[<>]'; grep -c SSGI__P is.txt; sed -n 4p was.txt; "
                 "sed -n 4p is.txt; grep '^  SSGI__P(' ssgi.h | diff - was.txt",
                 t_root, t_root),
          "fit of no rows does not print ssgi.h's table: %s", text);
    if (!CHECK(!strncmp(text, "2\n", 2) && sscanf(text, "2\n%d\n%299[^\n]\n%299[^\n]", &choice, was, is) == 3
               && choice == SSGI_PLAN_CHOICES, "fit: %s", text))
        return;
    const char *const costs = "  SSGI__P(V, HSAO, WIDTH, 1, 2, 6, 0, 0, 0, 0, %lff, %lff";
    CHECK(sscanf(was, costs, &before[0], &before[1]) == 2 && sscanf(is, costs, &after[0], &after[1]) == 2
          && after[0] == before[0] && fabs(after[1] / cost - 1) < 0.05, "measured %g: %s became %s", cost, was, is);
}

static void bench(void)
{
    static const struct { const char *arguments, *word;
    } bad[] = { { "--size 4x4", "--size 4x4" },
                { "--size 64x36,", "--size 64x36," },
                { "--size 64x36x", "--size 64x36x" },
                { "--plan 999", "--plan 999" },
                { "--plan 0", "--plan 0" },
                { "--seconds 0", "--seconds 0" },
                { "--seconds 1s", "--seconds 1s" },
                { "--method none", "--method none" },
                { "--context none", "none" },
                { "--scene nowhere", "nowhere" },
                { "--none 1", "--none" },
                { "--method", "--method: needs a value" },
                { "--out /dev/null/b", "/dev/null" } };
    char text[8000], path[256], *file;
    double copied = 0;
    const int none =
        shell(text, sizeof text, "'%s/build/render' plane --size 8x8 --context osmesa --out o.exr%s", t_root, "");
    setenv("CONTEXT", none ? "egl" : "osmesa", 1);                         /* the CPU's */
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        const int status =
            shell(text, sizeof text, "'%s/build/bench' --context $CONTEXT --size 64x36 --method hsao-best %s",
                  t_root, bad[i].arguments);
        const char *end = strchr(text, '\n');
        CHECK(status == 2 && end && !end[1] && strstr(text, bad[i].word), "%s: status %d, %s", bad[i].arguments, status,
              text);
    }
    CHECK(shell(text, sizeof text, "test -e report%s%s", "", ""), "left behind: report");
    for (int i = 0; i < 2; ++i) {
        write_text("bad.csv", i ? "3,1.5\n3,1.5 x\n" : "3\n");
        const int status = shell(text, sizeof text, "'%s/build/fit' /dev/null bad.csv%s", t_root, "");
        CHECK(status == 2 && strstr(text, i ? "bad.csv: line 2" : "bad.csv: line 1"), "fit: status %d, %s", status,
              text);
    }
    if (!CHECK(!shell(text, sizeof text, "'%s/build/bench' --context $CONTEXT --size 64x36 --method hsao-best --plan 3 "
                      "--seconds 1 --out b >out.txt && cat out.txt && { ! command -v node >/dev/null || node -e '"
                      "ssgi_record = r => process.exit(r.entries.some(e => e?.table == `bench` && e.csv) ? 0 : 1); "
                      "require(`./b/bench.js`)'; }%s",
                      t_root, ""), "%s", text))
        return;
    const char *rate = strstr(text, "passes copied ");
    CHECK(strstr(text, "\nhsao-best  ") && strstr(text, "No GPU was found") && strstr(text, "llvmpipe") && rate
          && sscanf(rate, "passes copied %lf GB/s", &copied) == 1, "%s", text);
    snprintf(path, sizeof path, "%s/b/bench.csv", folder);
    if (CHECK((file = read_text(path)) != NULL, "no bench.csv")) { bench_rows(file, copied * 1e9); free(file); }
    snprintf(path, sizeof path, "%s/b/plan-software.csv", folder);
    if (CHECK((file = read_text(path)) != NULL, "no plan-software.csv")) { bench_fits(file); free(file); }
    snprintf(path, sizeof path, "%s/b/plan-gpu.csv", folder);
    CHECK(access(path, F_OK), "a CPU's costs as a GPU's");
}

/* ---- >>make ------------------------------------------------------------------------------------------------------ */

/* How many objects of build/render and of both programs of tests make would compile in the copy. */
static int compiled_again(void)
{
    char text[200];
    const int failed = shell(text, sizeof text,
                             "MAKEFLAGS= make -n -C tree build/render build/test build/test-examples "
                             ">made.txt && "
                             "grep -c ' -c .* -o build/.*[.]o$' made.txt || test $? = 1%s%s", "", "");
    return CHECK(!failed, "make -n: %s", text) ? atoi(text) : -1;
}

/* In a copy of the tree by links, built as far as the tree is. */
static void edits(void)
{
    static const struct { const char *edit; int least, most; } cases[] = {
        { "$s/$/ /", 2, 8 },                               /* behind the declarations: library_gl.o, tests/own.h */
        { "s/END OF HEADER/& /", 40, 400 } };              /* among them: all that include kit_gl.h */
    char text[400];
    CHECK(!shell(text, sizeof text, "mkdir -p tree/build && cp -rs '%s'/Makefile '%s'/*.h tree", t_root, t_root)
              && !shell(text, sizeof text, "cp -rs '%s'/examples '%s'/tests tree", t_root, t_root)
              && !shell(text, sizeof text, "cd '%s'/build && cp -rs $PWD/kit $PWD/examples $PWD/tests $PWD/include "
                        "$PWD/assimp '%s'/tree/build", t_root, folder), "%s", text);
    const int before = compiled_again();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        shell(text, sizeof text, "cp '%s/ssgi_gl.h' tree/edited && sed -i '%s' tree/edited && mv tree/edited "
              "tree/ssgi_gl.h", t_root, cases[i].edit);
        CHECK(shell(text, sizeof text, "cmp -s tree/ssgi_gl.h '%s/ssgi_gl.h'%s", t_root, ""), "%s: edits nothing",
              cases[i].edit);
        const int again = compiled_again() - before;
        CHECK(again >= cases[i].least && again <= cases[i].most, "%s: %d objects are compiled again", cases[i].edit,
              again);
        t_note("%d objects", again);
    }
}

/* Whatever the folder and the environment. */
static void anywhere(void)
{
    char text[2000];
    CHECK(!shell(text, sizeof text, "cd / && env -i '%s/build/test' library%s", t_root, "")
              && strstr(text, " passed, 0 failed"), "%s", text);
}

void test_tools(void)
{
    if (!folder_begin()) return;
    RUN("tests run from any folder, without an environment", anywhere);
    RUN("an edit of GLSL compiles again what holds the implementation, one of a declaration all that calls it", edits);
    RUN("examples/minimal.c draws the same by OSMesa and by EGL", minimal);
    RUN("without OSMesa the default context is EGL's, and draws the same", without_osmesa);
    RUN("install.sh takes OSMesa or EGL, whichever can be had", installs);
    RUN("the library of GLSL as files comes back to the byte; edits arrive, what is broken is refused",
        library_as_files);
    RUN("the manifest names every file, what belongs together, and rows that the texts have", manifest);
    RUN("a chain as one writes it is made in the languages named, or refused by its field", own_chain);
    RUN("the headers as WebAssembly, without a C library, give the same texts, rows and blocks", wasm);
    RUN("what make install and make npm leave serves pkg-config, CMake and node", packages);
    RUN("cffi and bindgen take the headers", bindings);
    RUN("C, C++, Python and JavaScript have the same methods", methods_anywhere);
    RUN("a saved frame is rendered by nothing but itself: the scene's picture; options override", frames_carry_cameras);
    RUN("truth and scores say whose normals they are about, and can be about faces", normals_are_told);
    RUN("a frame as Blender writes it is the frame, its view layers and channels are named", frames_of_blender);
    RUN("a captured depth buffer becomes a frame with its camera, however the engine lays it out", captures);
    RUN("render answers bad input with one line, status 2 and no file", command_line);
    RUN("what render prints is JSON, and names defaults", what_is_printed);
    RUN("bench has every row, with bounds that add up and no traffic faster than a copy; fit takes its costs", bench);
    RUN("what cannot be written is said, with status 2; links are written through, lines may end in CR", streams);
    RUN("every method draws under sanitizers", sanitized);
    folder_end();
}
