/* test_tools.c - the examples from a shell: outputs and refusals of programs, packages, files of GLSL, make. */
#include <float.h>
#include <math.h>
#include "kit/kit_gl.h"
#include "shell.h"

static char said[8000];

/* Runs a shell line in the folder; said gets its output. $T is the repository, $R its build/render, $G its
   build/glsl-text, $C its capture.py. Returns the status. */
static int run(const char *line) { return shell(said, sizeof said, "%s%s", line, ""); }

static int works(const char *line) { return CHECK(!run(line), "%s: %s", line, said); }

/* Arguments that a program refuses, and a part of its one line of output. */
typedef struct refusal { const char *arguments, *word; } refusal;

static void refused(const char *program, const refusal *row, size_t rows)
{
    char line[700];
    for (size_t i = 0; i < rows; ++i) {
        snprintf(line, sizeof line, "%s %s", program, row[i].arguments);
        const int status = run(line);
        const char *end = strchr(said, '\n');
        CHECK(status == 2 && end && !end[1] && strstr(said, row[i].word), "%s: status %d, %s", line, status, said);
    }
}
#define REFUSED(program, rows) refused(program, rows, sizeof(rows) / sizeof *(rows))

/* Writes an image into the folder; header: of a frame, or NULL. */
static void write_image(const char *name, kit_image *image, const kit_header *header)
{
    char path[256];
    kit_error err = { "" };
    snprintf(path, sizeof path, "%s/%s", folder, name);
    CHECK(!kit_exr_write_frame(image, header, path, &err), "%s", err.text);
}

/* Writes an image of zeros. */
static void write_zeros(const char *name, int width, int height, const char *channels, const kit_header *header)
{
    kit_image image;
    if (kit_image_new(&image, width, height, channels, NULL)) return;
    write_image(name, &image, header);
    kit_image_free(&image);
}

static int read_image(kit_image *image, kit_header *header, const char *name)
{
    char path[256];
    kit_error err = { "" };
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return CHECK(!kit_exr_read(image, path, &err) && !kit_exr_header(header, KIT_HEADER_ALL, path, &err), "%s",
                 err.text);
}

/* Checks that examples/minimal.c draws the same picture on the CPU with OSMesa's header and without it. */
static void minimal(void)
{
    static const struct { const char *header, *line; } ways[] = {
        { "GL/osmesa.h", "cp $T/examples/minimal.c examples && gcc $W examples/minimal.c -lOSMesa -lm -o minimal" },
        { "EGL/egl.h", "sed 's|__has_include.*|0|' $T/examples/minimal.c >examples/egl.c && "
                       "gcc $W examples/egl.c -lEGL -lGL -lm -o minimal" }
    };
    char line[100];
    int ran = 0;
    run("mkdir examples");
    setenv("W", "-std=c99 -Wall -Wextra -Werror", 1);
    for (size_t i = 0; i < sizeof ways / sizeof *ways; ++i) {
        snprintf(line, sizeof line, "echo '#include <%s>' | gcc -E -", ways[i].header);
        if (run(line)) {
            t_note("%s is not here: not tried", ways[i].header);
            continue;
        }
        works(ways[i].line);
        works("LIBGL_ALWAYS_SOFTWARE=1 ./minimal && head -c 14 ao.pgm | grep -q 'P5 960 540 255' && "
              "test $(tail -c +16 ao.pgm | tr -d '\\377' | wc -c) -gt 100000");
        works(ran ? "cmp ao.pgm other.pgm" : "mv ao.pgm other.pgm");
        ++ran;
    }
    CHECK(ran, "neither OSMesa nor EGL is here");
}

/* Checks that without OSMesa, whose library empty files replace, the default context is EGL's, and draws the same. A
   call for OSMesa is refused. */
static void without_osmesa(void)
{
    static const refusal asked[] = { { "room --size 8x8 --context osmesa --out a.exr", "libOSMesa.so is not there" } };
    if (run("$R plane --size 8x8 --context egl --out egl.exr")) {
        t_note("not tried: %s", said);
        return;
    }
    works("mkdir lacks && cd lacks && touch libOSMesa.so libOSMesa.so.6 libOSMesa.so.8 && cd .. && "
          "$R room --size 64x36 --out with.exr && export LD_LIBRARY_PATH=lacks && "
          "$R room --size 64x36 --json --out without.exr | grep -q llvmpipe && cmp with.exr without.exr");
    REFUSED("LD_LIBRARY_PATH=lacks $R", asked);
}

/* Checks that each room is a file, without C's quotes, its conditions in pairs; all main functions are there. */
static void rooms_as_files(void)
{
    works("MAKEFLAGS= make -s -C $T glsl-out DIR=$PWD/glsl && ! grep -n '\"' glsl/*.glsl && cd glsl && "
          "test $(ls | wc -l) = $(grep -c '^/[*] ==== >>' *.glsl | grep -c ':1$') && for f in *; do "
          "test $(grep -c '^#if' $f) = $(grep -c '^#endif' $f) || exit 1; done && "
          "test $(cat * | grep -c '^void main()') = $(grep -c '^ *\"void main()' ../ssgi_gl.h)");
}

/* Writes a thousand cameras: projection, width, height, SSGI_CLIP_ZERO, _ROWS_DOWN, radius, then the frame of it. */
static void write_cameras(FILE *f)
{
    for (int made = 0; made < 1000;) {
        const int flat = (int)t_below(2), zero = (int)t_below(2), reversed = zero && t_below(2), left = (int)t_below(2),
                  size[4] = { 1 + (int)t_below(4096), 1 + (int)t_below(4096), zero, (int)t_below(2) };
        const double first = exp((double)t_uniform(-3, 3)), nearest = first - (flat && t_below(2) ? 20 : 0),
                     farthest = nearest + first * exp((double)t_uniform(1, 8)),
                     at_near = reversed ? 1 : zero ? 0 : -1, at_far = reversed ? 0 : 1,
                     a = flat ? nearest : 1 / nearest, b = flat ? farthest : 1 / farthest,
                     slope = (at_far - at_near) / (b - a);
        const float radius = expf(t_uniform(-4, 4));
        float m[16] = { t_uniform(0.3f, 3), 0, 0, 0, 0, t_uniform(-3, -0.3f) };
        m[flat ? 12 : 8] = t_uniform(-0.3f, 0.3f);
        m[flat ? 13 : 9] = t_uniform(-0.3f, 0.3f);
        m[10] = (float)(flat ? -slope : -(at_near - slope * a));
        m[14] = (float)(flat ? at_near - slope * a : slope);
        m[flat ? 15 : 11] = flat ? 1.0f : -1.0f;
        if (!t_below(4)) m[2] = t_uniform(-0.02f, 0.02f) * m[10];
        for (int i = 8; left && i < 12; ++i) m[i] = -m[i];
        ssgi_view view;
        ssgi_gl_frame frame;
        if (ssgi_view_from_projection(&view, m, size[2] + SSGI_CLIP_ROWS_DOWN * size[3], size[0], size[1], NULL)
            != SSGI_OK)
            continue;
        ++made;
        CHECK(ssgi_gl_frame_init(&frame, &view, radius, NULL) == SSGI_OK && fwrite(m, sizeof m, 1, f)
              && fwrite(size, sizeof size, 1, f) && fwrite(&radius, sizeof radius, 1, f)
              && fwrite(&frame, sizeof frame, 1, f), "a camera cannot be written");
    }
}

/* Checks that a program that knows the manifest alone makes the frames of ssgi_gl_frame_init. */
static void manifest_of_cameras(void)
{
    static const char *const check =
        "import json, struct\n"
        "m = json.load(open('cameras/manifest.json'))\n"
        "data, block, at, worst, kinds = open('cameras.bin', 'rb').read(), m['frame']['size'], 0, 0, set()\n"
        "bits = lambda x: struct.unpack('<i', struct.pack('<f', x))[0]\n"
        "rounded = lambda x: struct.unpack('<f', struct.pack('<f', x))[0]\n"
        "place = lambda x: bits(x) if bits(x) >= 0 else -(bits(x) & 0x7fffffff)\n"
        "while at < len(data):\n"
        "    projection, (width, height, zero, down, radius) = (struct.unpack_from(f, data, at + to)\n"
        "                                                       for f, to in (('<16f', 0), ('<4if', 64)))\n"
        "    v = dict(m=projection, width=width, height=height, zero=zero, down=down, abs=abs, min=min, max=max)\n"
        "    kind = 'perspective' if projection[11] else 'orthographic'\n"
        "    for x in m['values']:\n"
        "        value = eval(x[kind], v)\n"
        "        v[x['name']] = rounded(value) if x['rounded'] else value\n"
        "    kinds.add((kind, bool(v['hand'] < 0), bool(v['clear']), bool(v['moved']), bool(v['skew'])))\n"
        "    for x in m['frame']['members']:\n"
        "        whole, given = x['type'].startswith('i'), x['default']\n"
        "        times = radius if 'times' in x else 1\n"
        "        is_ = [eval(e, v) for e in x['formula']] if given == 'view' else [\n"
        "            times * y for y in (given if isinstance(given, list) else [given])]\n"
        "        form = f\"<{x['bytes'] // 4}{'i' if whole else 'f'}\"\n"
        "        wanted = struct.unpack_from(form, data, at + 84 + x['offset'])\n"
        "        assert len(is_) == len(wanted) and (not whole or list(wanted) == is_), (x, is_, wanted)\n"
        "        off = max(abs(place(y) - place(z)) for y, z in zip(is_, wanted)) if not whole else 0\n"
        "        worst = max(worst, off)\n"
        "        assert off <= 2, (x['name'], kind, projection, is_, wanted)\n"
        "    at += 84 + block\n"
        "assert at == len(data) == 1000 * (84 + block) and len(kinds) > 15, (at, kinds)\n"
        "print(worst)\n";
    if (!has("python3") || !works("$G --chain hsao --vulkan cameras")) return;
    FILE *f = fopen(in_folder("cameras.bin"), "wb");
    if (!CHECK(f, "cameras.bin cannot be written")) return;
    write_cameras(f);
    fclose(f);
    write_text("cameras.py", check);
    works("python3 cameras.py");
}

/* Checks that Rust's reader of C headers gives constants the type of the fields that take them. */
static void bindings_of_rust(void)
{
    if (has("bindgen"))
        works("bindgen ssgi_gl.h --allowlist-var SSGI_GL_PASS_HSAO --allowlist-type ssgi_gl_desc -- "
              "--target=x86_64-pc-windows-msvc -ffreestanding >bind.rs && "
              "grep -q 'pub type ssgi_gl_pass = ::std::os::raw::c_int' bind.rs && "
              "grep -q 'pub pass: ssgi_gl_pass' bind.rs");
}

/* Checks a chain in a user's words, and mistakes in one. */
static void own_chain(void)
{
    static const refusal wrong[] = {
        { "hsao,best,depth=NEAR --330 own", "desc.input.depth: must be" },
        { "hsao,depht=LINEAR --330 own", "name: there is no such field; the nearest is depth" },
        { "hsao,best,depth --330 own", "name: must be NAME[,PRESET]" },
        { "gtao --330 own", "--chain gtao: name: there is no such method; the nearest are hsao, hsao-fast" },
        { "hsao,multisampled=1 --300es own", "desc.input.multisampled: " },
        { "dss,surfels=1 --vulkan own", "desc.pass: surfels" },
        { "hsao own", "in which language" }, { "hsao --330", "the folder is missing" },
        { "hsao --glsl own", "--glsl: there is no such option" } };
    works("$G --chain hsao,depth=linear --300es --450 own && test $(ls own | wc -l) = 13 && "
          "grep -q 'SSGI_SAMPLES = 8' own/*2-hsao.450.frag && ! grep -q ssgi_decode own/*.frag");
    works("$G --chain ssdo-points,environment=SH,bounce=PATCH,layers=8,views=4,view_layers=8,lights.layers=8,"
          "lights.views=4,lights.view_layers=8,vpls=1 --450 many && ls many/*.100-* && "
          "grep -q 'vpls=1\", \"dialect\": \"450\", \"about' many/manifest.json");
    REFUSED("$G --chain", wrong);
}

/* Checks the headers without a C library, in node: every shader and row of the manifest, blocks as in C, errors. */
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
    char path[256], *bytes = NULL;
    size_t size = 0;
    if (!(has("clang") & has("wasm-ld") & has("node")) || !works("MAKEFLAGS= make -s -C $T wasm")) return;
    snprintf(path, sizeof path, "%s/build/wasm/ssgi.wasm", t_root);
    if (CHECK(!kit_file_read(&bytes, &size, path, NULL) && size <= 284 * 1024, "ssgi.wasm has %zu bytes", size))
        t_note("ssgi.wasm has %zu bytes", size);
    free(bytes);
    write_text("blocks.c", blocks);
    works("$G texts 300es && $G others 330 && "
          "$G --chain hsao,compute=basic,group_width=16,group_height=4,output_set=3 --vulkan computed && "
          "gcc -I. blocks.c -o blocks -lm && ./blocks >frame.bin");
    works("node $T/tests/pages/wasm.mjs $T/build/wasm $T");
}

/* Checks that other tools can use the packages of make install and make npm. */
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
        "const gl = require('./glsl/manifest.json'), gpu = require('ssgi-wgsl/manifest.json');\n"
        "const text = name => read(new URL(import.meta.resolve(name)), 'utf8');\n"
        "const check = (ok, what) => { if (!ok) throw new Error(`the package disagrees with itself: ${what}`); };\n"
        "check(ssgi.version === gl.ssgi && gl.chains.length > 30 && gpu.chains.length > 30, 'chains');\n"
        "for (const { name, chain, steps } of gl.chains) {\n"
        "    const desc = { ...chain.desc, dialect: '300ES' }, lights = { ...chain.lights, dialect: '300ES' };\n"
        "    const drawn = ssgi.steps({ ...chain, desc, ...chain.lights && { lights }, width: 64, height: 64 });\n"
        "    check(drawn.length === steps.length, name);\n"
        "    for (const [i, { files }] of steps.entries())\n"
        "        for (const stage in files)\n"
        "            check(ssgi.shader(drawn[i].desc, stage) === text(`./glsl/${files[stage]}`), files[stage]);\n"
        "}\n"
        "for (const { steps } of gpu.chains)\n"
        "    for (const { files } of steps)\n"
        "        for (const [stage, word] of [['vert', '@vertex'], ['frag', '@fragment']])\n"
        "            check(text(`ssgi-wgsl/${files[stage]}.wgsl`).includes(word), files[stage]);\n"
        "for (const name of ['hsao', 's3ho', 'hsao-history']) {\n"
        "    const { default: plan } = await import(`ssgi/chains/${name}`);\n"
        "    const of = gpu.chains.find(chain => chain.name === name);\n"
        "    for (const [i, { code, outputs }] of plan.steps.entries()) {\n"
        "        for (const stage of ['vert', 'frag'])\n"
        "            check(code[stage] === text(`ssgi-wgsl/${of.steps[i].files[stage]}.wgsl`), `${name} ${stage}`);\n"
        "        check(outputs.every(({ layer }) => layer >= 0), `${name}: layers`);\n"
        "    }\n"
        "}\n"
        "const before = Reflect.ownKeys(globalThis).length;\n"
        "for (const name of ['three', 'webgl', 'webgpu', 'chains/hsao']) await import(`ssgi/${name}`);\n"
        "check(Reflect.ownKeys(globalThis).length === before, 'modules have side effects');\n";
    works("MAKEFLAGS= make -s -C $T install DESTDIR=$PWD/to PREFIX=/usr && mkdir -p app");
    write_text("app/app.c", program);
    if (has("pkg-config"))
        works("export PKG_CONFIG_PATH=$PWD/to/usr/share/pkgconfig && pkg-config --exact-version=0.5 ssgi && gcc "
              "$(pkg-config --cflags ssgi) app/app.c -o app/app $(pkg-config --libs ssgi) && app/app");
    if (has("cmake")) {
        write_text("app/CMakeLists.txt",
                   "cmake_minimum_required(VERSION 3.5)\nproject(app C)\nfind_package(ssgi 0.5 REQUIRED)\n"
                   "find_package(ssgi 0.3 QUIET)\nif(ssgi_FOUND)\n  message(FATAL_ERROR \"0.4 passes for 0.3\")\n"
                   "endif()\nadd_executable(app app.c)\ntarget_link_libraries(app ssgi::ssgi)\n");
        works("cmake -S app -B app/build -DCMAKE_PREFIX_PATH=$PWD/to/usr -DCMAKE_C_COMPILER_WORKS=1 && "
              "cmake --build app/build && app/build/app");
        works("cmake -S $T/examples/tools/packages -B cmake && cmake --install cmake --prefix by-cmake && "
              "diff -r by-cmake to/usr");
        works("sed -i \"s|^find.* REQUIRED.*|add_subdirectory($T/examples/tools/packages ssgi)|; /^find/,/^endif/d\" "
              "app/CMakeLists.txt && cmake -S app -B app/within -DCMAKE_C_COMPILER_WORKS=1 && "
              "cmake --build app/within && app/within/app");
    }
    works("MAKEFLAGS= make -s -C $T uninstall DESTDIR=$PWD/to PREFIX=/usr && test -z \"$(find to -type f)\"");
    int packed, unpacked;
    const int translates = !run("test -e $T/build/tint/twgsl.wasm") && has("glslangValidator");
    if (!translates) t_note("package not tried, without tint: make npm brings it");
    if (!(has("clang") & has("wasm-ld") & has("node") & has("npm") & translates)) return;
    run("mkdir page page/three");
    write_text("page/npm.mjs", script);
    write_text("page/used.mjs", "export { SSGIPass } from 'ssgi/three';\n");
    write_text("page/bare.mjs", "import 'ssgi';\nimport 'ssgi/three';\nimport 'ssgi/chains/hsao';\n");
    write_text("page/three/package.json", "{ \"name\": \"three\", \"version\": \"0.187.0\", \"type\": \"module\", "
               "\"exports\": \"./three.js\" }");
    write_text("page/three/three.js", "export class Matrix4 { set() { return this; } }\n");
    works("MAKEFLAGS= make -s -C $T npm && cd page && $T/build/glsl-text --chain all --300es glsl && "
          "for of in $T/build/ssgi-*.tgz $T/build/wgsl/ssgi-*.tgz ./three; do npm install --offline "
          "--no-audit --no-fund --silent \"$of\" || exit 1; done && test -d node_modules/ssgi && "
          "! test -L node_modules/ssgi && node npm.mjs");
    if (CHECK(!run("cd $T/build && printf '%d kB packed, %d unpacked' $(($(cat ssgi-*.tgz | wc -c) / 1000)) "
                   "$(($(tar -xOzf ssgi-*.tgz | wc -c) / 1000))")
                  && sscanf(said, "%d kB packed, %d", &packed, &unpacked) == 2 && packed <= 330 && unpacked <= 1300,
              "the npm package has %s", said))
        t_note("the npm package has %s", said);
    works("cd $T/build && grep -q \"npm install PATH/TO/build/$(echo ssgi-*.tgz)\" ../README.md");
    if (run("test -x $T/build/web-deps/node_modules/.bin/esbuild")) t_note("esbuild is not here: no bundle tried");
    else works("cd page && $T/build/web-deps/node_modules/.bin/esbuild --bundle --format=esm --log-level=error "
               "--outdir=out used.mjs bare.mjs && test $(wc -c <out/bare.js) -lt 100 && "
               "test $(wc -c <out/used.js) -gt 10000");
}

/* Checks that make dist gives the same bytes each time, and that its archives serve CMake and Meson. */
static void release(void)
{
    static const char *const program = "#define SSGI_IMPLEMENTATION\n#include <ssgi.h>\n"
                                       "int main(void) { return ssgi_sh_cosine(0) < 0; }\n";
    if (!works("export MAKEFLAGS= URL=file://$PWD/two METHODS=hsao-fast && make -s -C $T dist DIST=$PWD/one && sleep 1 "
               "&& make -s -C $T dist DIST=$PWD/two && diff -r one two && cd two && sha256sum --quiet -c SHA256SUMS"))
        return;
    works("cd two && test $(wc -l <SHA256SUMS) -ge 6 && test \"$(sed -n 's/^## //p' CHANGELOG.md)\" = "
          "\"$(sed -n 's/^   CHANGES in //p' $T/ssgi.h)\" && grep -q '^`_choice_at`, `_member_at`' CHANGELOG.md && "
          "grep -qx 'SSGI_GL_HALF_NONE -> SSGI_GL_RESOLUTION_FULL' CHANGELOG.md && ! grep -r @ vcpkg conan");
    works("mkdir here from && MAKEFLAGS= make -s -C $T install DESTDIR=$PWD/here PREFIX=/usr && "
          "for of in two/ssgi-*.tar.gz; do tar -xzf $of -C from || exit 1; done && cd from/ssgi-shaders-0.5 && "
          "grep -q '\"ssgi\": \"0.5\"' manifest.json && test $(ls *.vulkan.frag | wc -l) = 2");
    if (has("glslangValidator") & has("spirv-cross"))
        works("cd from/ssgi-shaders-0.5 && "
              "for of in spv hlsl msl; do test $(ls *.frag.$of | wc -l) = 2 || exit 1; done");
    run("mkdir -p fetch meson/subprojects");
    write_text("fetch/app.c", program);
    write_text("meson/app.c", program);
    if (has("cmake")) {
        write_text("fetch/CMakeLists.txt",
                   "cmake_minimum_required(VERSION 3.18)\nproject(app C)\ninclude(FetchContent)\n"
                   "FetchContent_Declare(ssgi ${FROM})\nFetchContent_MakeAvailable(ssgi)\n"
                   "add_executable(app app.c)\ntarget_link_libraries(app ssgi::ssgi)\n");
        works("sum=$(sed -n 's/  ssgi-0.*//p' two/SHA256SUMS) && for from in "
              "\"URL;file://$PWD/two/ssgi-0.5.tar.gz;URL_HASH;SHA256=$sum\" "
              "\"SOURCE_DIR;$T;SOURCE_SUBDIR;examples/tools/packages\"; do rm -rf by && "
              "cmake -S fetch -B by \"-DFROM=$from\" -DCMAKE_C_COMPILER_WORKS=1 && cmake --build by && by/app || "
              "exit 1; done");
        works("cmake -S from/ssgi-0.5 -B alone && cmake --install alone --prefix alone/to && "
              "diff -r alone/to here/usr");
    }
    if (has("meson") & has("ninja")) {
        write_text("meson/meson.build", "project('app', 'c')\n"
                                        "executable('app', 'app.c', dependencies: dependency('ssgi'))\n");
        works("{ echo '[wrap-file]'; echo directory = ssgi-0.5; echo source_url = file://$PWD/two/ssgi-0.5.tar.gz; "
              "echo source_filename = ssgi-0.5.tar.gz; "
              "echo source_hash = $(sed -n 's/  ssgi-0.*//p' two/SHA256SUMS); echo '[provide]'; "
              "echo dependency_names = ssgi; } >meson/subprojects/ssgi.wrap && "
              "meson setup meson/by meson && ninja -C meson/by && meson/by/app");
        works("meson setup --prefix $PWD/meson/to from/ssgi-0.5 meson/alone && meson install -C meson/alone && "
              "diff -r meson/to here/usr");
    }
}

/* Checks ssgi_gl_method_at in each language that can use the headers or the module. */
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
    write_text("methods.c", c);
    write_text("methods.py", python);
    write_text("methods.mjs", javascript);
    works("MAKEFLAGS= make -s -C $T shared SHARED=$PWD/libssgi.so && "
          "sed -n 's/^SSGI_DEF .*[ *]\\(ssgi_[a-z0-9_]*\\)(.*/\\1/p' $T/ssgi.h $T/ssgi_gl.h | sort -u >declared.txt && "
          "nm -D --defined-only libssgi.so | sed 's/.* //' | sort >exported.txt && "
          "test $(wc -l <exported.txt) -gt 100 && cmp declared.txt exported.txt");
    works("for s in c99 c++11 c++20; do "
          "$(case $s in c99) echo gcc;; *) echo g++ -xc++;; esac) -std=$s methods.c -o m -xnone libssgi.so "
          "'-Wl,-rpath,.' && ./m >$s.txt || exit 1; done; test $(wc -l <c99.txt) -gt 20 && cmp c99.txt c++11.txt && "
          "cmp c99.txt c++20.txt && python3 methods.py | cmp c99.txt && node methods.mjs $T | cmp c99.txt");
}

/* Draws one small picture of each method, with the kit under address and undefined-behaviour sanitizers. */
static void sanitized(void)
{
    kit_method m;
    for (int i = 0; kit_method_at(&m, i); ++i) {
        char line[300];
        snprintf(line, sizeof line, "ASAN_OPTIONS=detect_leaks=0 $T/build/render-sanitized boxes --size 64x36 "
                 "--out s.exr --method %s %s", m.name, m.lit ? "--env sky --light sun:1,2,1,3,3,3"
                 : m.between ? "--set field_resolution=4,rays=16" : "");
        works(line);
    }
}

/* Checks output that cannot be written: status 2, one line. Unusual files that can be read or written are. */
static void streams(void)
{
    static const refusal lost[] = {
        { "$R --list >/dev/full", "standard output" }, { "$R --list >&-", "standard output" },
        { "$R room --size 8x8 --score s.exr --json >/dev/full", "standard output" },
        { "$G --passes ssgi_gl.h >/dev/full", "standard output" },
        { "ulimit -f 8 && $R room --size 160x90 --out big.exr", "big.exr: cannot be written" },
        { "ulimit -v 4000000 && $R room --size 16384x16384 --out big.exr", "16384 x 16384" },
        { "ln -s loop.exr loop.exr && $R room --size 8x8 --out loop.exr", "loop.exr" } };
    works("$R room --size 8x8 --out s.exr");
    REFUSED("", lost);
    works("! ls big* s.exr.*");
    works("ln -s there.exr here.exr && $R room --size 8x8 --out here.exr && test -L here.exr && cmp there.exr s.exr");
    works("for s in 0,0,0 0.3,0,0; do $R casters --size 64x36 --frames 2 --method hsao-history --slide $s "
          "--out $s-%d.exr || exit 1; done; cmp 0,0,0-0.exr 0.3,0,0-0.exr && ! cmp -s 0,0,0-1.exr 0.3,0,0-1.exr");
    write_text("cr.obj", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r");
    works("$R cr.obj --size 8x8 --out cr.exr && test -s cr.exr");
}

/* Tries each setting of each method, with values beyond its limits and with no word of it. */
static void settings(void)
{
    kit_method m;
    kit_setting s;
    int tried = 0;
    for (int i = 0; kit_method_at(&m, i); ++i)
        for (int k = 0; kit_method_setting(&s, &m, k); ++k) {
            char text[3][80], named[40];
            snprintf(named, sizeof named, "%s=", s.key);
            snprintf(text[0], sizeof text[0], "%s%.9g", named, s.most + 1);
            snprintf(text[1], sizeof text[1], "%s%.9g", named, s.least - 1);
            snprintf(text[2], sizeof text[2], "%sx", named);
            for (int t = 0; t < 3; ++t, ++tried) {
                kit_method changed = m;
                kit_error err = { "" };
                CHECK(kit_method_set(&changed, text[t], &err) && strstr(err.text, text[t]), "%s: %s: %s", m.name,
                      text[t], err.text);
            }
        }
    CHECK(tried > 1000, "%d settings", tried);
}

/* Tries bad command lines and files: status 2, one line that names the argument or file, no file left behind. */
static void command_line(void)
{
    static const refusal cases[] = {
        { "nowhere.obj --out a.exr", "nowhere.obj" },
        { "cut.obj --out a.exr", "cut.obj" },
        { "empty.obj --out a.exr", "empty.obj" },
        { "far.obj --out a.exr", "1e+38" },
        { "room --method none --out a.exr", "--method none" },
        { "room --set samples=99 --out a.exr", "samples=99" },
        { "casters --method aof --set cap_table=1,field_resolution=4,rays=16 --out a.exr", "cap_table=1: size:" },
        { "room --set colour=1 --out a.exr", "colour=1" },
        { "room --set resolution=half,blur=0 --size 8x8 --out a.exr", "resolution=half" },
        { "room --size 8x8 --env sky --method ssdo --set vpls=4 --out a.exr", "vpls=4" },
        { "room --size 8x8 --env sky --method s3ho --set occluded_emitters=1 --out a.exr", "occluded_emitters=1" },
        { "room --size 8x8 --method ssdo --env sky --set one_sided=1,two_sided=1 --out a.exr", "one_sided" },
        { "room --size 0x5 --out a.exr", "--size 0x5" },
        { "room --size 4294967304x8 --out a.exr", "--size 4294967304x8" },
        { "room --camera 1,2 --out a.exr", "--camera 1,2" },
        { "room --camera 1,1,1,1,1,1 --out a.exr", "--camera" },
        { "room --camera 1e30,0,0,0,0,0 --out a.exr", "1e30" },
        { "room --fovy 999 --out a.exr", "--fovy 999" },
        { "room --radius nan --out a.exr", "--radius nan" },
        { "room --near 5 --far 2 --out a.exr", "--far" },
        { "room --context vulkan --out a.exr", "vulkan" },
        { "room --wrong 1 --out a.exr", "--wrong" },
        { "room --o", "--o: there is no such option" },
        { "room --size 8x8 --score ''", "--score: its value is empty" },
        { "--list none", "--list none" },
        { "room", "--out" },
        { "room --out a.bmp", "--out a.bmp" },
        { "room --size 8x8 --out none/a.exr", "none/a.exr" },
        { "room --size 8x8 --out none/a.png", "none/a.png" },
        { "room --size 8x8 --score y.exr", "y.exr" },
        { "room --size 8x8 --save-gbuffer g.png", "--save-gbuffer g.png: must end in .exr" },
        { "room --size 8x8 --save-gbuffer g.exr --out g.exr", "--save-gbuffer g.exr: is --out's" },
        { "room --env sky --out a.exr", "--env" },
        { "room --light sun:0,1,0,1,1,1 --method hsao-march --out a.exr", "--light" },
        { "room --method ssdo --out a.exr", "--method ssdo: needs light" },
        { "room --method ssdo --env none.hdr --out a.exr", "none.hdr" },
        { "room --method ssdo --env y.exr --out a.exr", "y.exr" },
        { "room --method ssdo --light lamp:1,2 --out a.exr", "lamp:1,2" },
        { "room --method ssdo --light sun:0,0,0,1,1,1 --out a.exr", "sun:0,0,0" },
        { "room --method ssdo --light point:0,0,0,1,-1,1 --out a.exr", "1,-1,1" },
        { "cornell --method ssdo --light point:1e38,0,0,1,1,1 --out a.exr", "1e38" },
        { "room --method ssdo --floor 4 --out a.exr", "--floor" },
        { "room --size 8x8 --method ssdo --env sky --env-strength -1 --out a.exr", "--env-strength -1" },
        { "room --method ssdo --light sun:0,1,0,1,1,1 --env-turn 5 --out a.exr", "--env-turn: needs" },
        { "room --method ssdo --light sun:0,1,0,1,1,1 --backdrop --out a.exr", "--backdrop: needs" },
        { "room --size 8x8 --method ssdo --env sky --colours --out a.exr", "--colours: is of a method" },
        { "room --plan best:1 --out a.exr", "--plan best:1" },
        { "room --plan visibility:0.1: --out a.exr", "visibility:0.1:" },
        { "room --plan visibility:0.1%5 --out a.exr", "visibility:0.1%5" },
        { "room --plan light:0.1 --out a.exr", "--env" },
        { "room --plan visibility:0.1 --set samples=3 --out a.exr", "--plan" },
        { "--gbuffer f.exr --plan objects:0.1 $F", "--plan objects: needs a scene" },
        { "--gbuffer cut.exr --fovy 50 --radius 1 --out a.exr", "cut.exr" },
        { "--gbuffer y.exr --fovy 50 --radius 1 --out a.exr", "y.exr" },
        { "--gbuffer half.exr --fovy 57 --radius 0.5 --out a.exr", "half.exr: frame: channel N.Z" },
        { "--gbuffer f.exr --fovy 57 --radius 0.5 --method ssao --set layers=2 --out a.exr", "layers=2" },
        { "--gbuffer f.exr --fovy 57 --radius 0.5 --set thickness=slabs --out a.exr", "channel back.Z" },
        { "--gbuffer f.exr --fovy 57 --radius 0.5 --set margin=0.5 --out a.exr", "margin=0.5" },
        { "--gbuffer f.exr --fovy 57 --radius 0.5 --method ssdo-points --env sky --set views=1 --out a.exr",
          "views=1: a frame" },
        { "--gbuffer f.exr --fovy 57 --radius 0.5 --method ssdo --truth 4 --out a.exr", "--truth" },
        { "--gbuffer f.exr --fovy 57 --radius 0.5 --slide 1,0,0 --out a.exr", "--slide: needs a scene" },
        { "--gbuffer lit.exr --fovy 57 --radius 2 --flat --out a.exr", "--flat: needs a scene" },
        { "--gbuffer lit.exr --method s3ho --env sky $F", "direct.R ..: take ssdo, or --set indirect=none" },
        { "--gbuffer lit.exr --method s3ho --set indirect=apart --env sky $F", "would lack the frame's direct.R" },
        { "room --method s3ho --set store=half --env sky --out a.exr", "store=half: one gather with the bounce packs" },
        { "room --method s3ho --set store=float --env sky --out a.exr", "it needs indirect=none or apart" },
        { "--gbuffer lit.exr --ortho-height 2 --out a.exr", "lit.exr: needs --radius" },
        { "--gbuffer lit.exr --radius 2 --out a.exr", "lit.exr: needs --fovy or --ortho-height" },
        { "--gbuffer bent.exr --out a.exr", "bent.exr: worldToCamera: must turn" },
        { "--gbuffer bent.exr --camera 0,0,0,1,0,0 --out a.exr", "bent.exr: screenWindowWidth nan" },
        { "--gbuffer bent.exr --camera 0,0,0,1,0,0 --fovy 57 --out a.exr", "bent.exr: ssgi.radius 0" },
        { "plane --size 8x8 --slide 1,0,0 --out a.exr", "--slide: scene plane" },
        { "casters --frames 200 --slide 1e12,0,0 --out q%d.exr", "--slide: in 200 frames" },
        { "room --still 2 --frames 2 --out a%d.exr", "--still: cannot go with --frames" },
        { "room --frames 2 --out a.exr", "--out a.exr" },
        { "room --frames 2 --out q%+4d.exr", "--out q%+4d.exr" },
        { "room --frames inf --out q%d.exr", "--frames inf" },
        { "room --frames 2 --method ssdo --out q%d.exr", "needs light" },
        { "nowhere.obj --frames 2 --out q%d.exr", "nowhere.obj" },
        { "--sequence good.txt --set thickness=slabs $F", "channel back.Z" },
        { "--sequence good.txt --method ssdo $F", "line 1: --gbuffer f.exr: --method ssdo needs light" },
        { "--sequence nowhere.txt $F", "nowhere.txt" },
        { "--sequence zero.txt $F", "zero.txt: line 3: holds a zero byte" },
        { "--sequence blank.txt $F", "blank.txt: names no frame" },
        { "--sequence number.txt $F", "number.txt: line 4: must be FRAME.exr" },
        { "--sequence gone.txt $F", "gone.txt: line 2: gone.exr: cannot be read" },
        { "--sequence other.txt $F", "other.txt: line 2: small.exr: must be like the first frame in size" },
        { "--sequence lit.txt $F", "lit.txt: line 2: lit.exr: must be like the first frame in direct.R" },
        { "--sequence along.txt $F", "along.txt: line 2: --up" },
        { "--sequence bare.txt --fovy 57 --out q%d.exr", "line 1: --gbuffer lit.exr: needs --radius" },
        { "--sequence bare.txt $F", "bare.txt: line 2: --gbuffer lit.exr: needs a camera" }
    };
    static const struct { const char *name, *text; } files[] = {
        { "cut.obj", "v 0 0 0\nv 1 0 0\nv 0 1" },
        { "empty.obj", "v 0 0 0\n" },
        { "far.obj", "v 0 0 0\nv 1e38 0 0\nv 0 1 0\nf 1 2 3\n" },
        { "good.txt", "f.exr 1,1,3,0,0.5,0\r\n\r\nf.exr\t1,1,4,0,0.5,0,0,1,0" },
        { "blank.txt", "\n \t\n" },
        { "number.txt", "f.exr 1,1,3,0,0.5,0\n\n\r\nf.exr 1,1,3,0,nan,0\n" },
        { "gone.txt", "f.exr 1,1,3,0,0.5,0\ngone.exr 1,1,3,0,0.5,0\n" },
        { "other.txt", "f.exr 1,1,3,0,0.5,0\nsmall.exr 1,1,3,0,0.5,0\n" },
        { "lit.txt", "f.exr 1,1,3,0,0.5,0\nlit.exr 1,1,3,0,0.5,0\n" },
        { "along.txt", "f.exr 1,1,3,0,0.5,0\nf.exr 1,1,3,1,2,3,0,1,0\n" },
        { "bare.txt", "lit.exr 1,1,3,0,0.5,0\nlit.exr\n" },
        { "own.txt", "f.exr\nf.exr 1,1,4,0,0.5,0\nf.exr \n" } };
    static const kit_header bent = { .has = KIT_HEADER_ALL, .height = NAN, .world_to_camera = { 2 } };
    setenv("F", "--fovy 57 --radius 0.5 --out q%d.exr", 1);
    for (size_t i = 0; i < sizeof files / sizeof *files; ++i) write_text(files[i].name, files[i].text);
    write_zeros("y.exr", 4, 4, "Y", NULL);
    write_zeros("bent.exr", 16, 9, "Z", &bent);
    write_zeros("half.exr", 16, 9, "Z,N.X,N.Y", NULL);
    write_zeros("lit.exr", 16, 9, "Z,N.X,N.Y,N.Z,albedo.R,albedo.G,albedo.B,direct.R,direct.G,direct.B", NULL);
    works("head -c 300 y.exr >cut.exr && printf 'f.exr 1,1,3,0,0.5,0\\n\\nf.exr\\0' >zero.txt && "
          "$R room --size 16x9 --save-gbuffer f.exr && $R room --size 8x8 --save-gbuffer small.exr && ls >before");
    REFUSED("$R", cases);
    works("ls | grep -v after >after; diff before after");
    works("$R room --size 64x36 --save-gbuffer g.exr --out a.exr && "
          "$R --gbuffer g.exr --fovy 57 --radius 0.5 --out b.exr --json --score a.exr | grep -q '\"rmse\"'");
    works("$R --gbuffer g.exr --plan visibility:0.1 --json --out b.exr | grep -q '\"plan\": {\"error\"'");
    works("$R plane --size 4x4 --plan objects:0.1 --score y.exr | grep -q 'nothing is the cheapest .*: error 0.0000'");
    works("$R --sequence good.txt --fovy 57 --radius 0.5 --set history=1 --out s%d.exr && test -s s0.exr && "
          "test -s s1.exr && ! test -e s2.exr");
    works("$R --sequence own.txt --set history=1 --out o%d.exr && test -s o2.exr");
    works("$R --gbuffer lit.exr --method s3ho --set indirect=none --env sky $F && "
          "$R room --size 8x8 --method s3ho --set indirect=joint,store=packed --env sky --out b.exr");
}

/* Returns the error of a picture against another, as render prints it; below 0: it prints something else. */
static double errs_by(const char *arguments, const char *reference)
{
    char line[700];
    snprintf(line, sizeof line, "$R %s --json --score %s", arguments, reference);
    const char *rmse = works(line) ? strstr(said, "\"rmse\": ") : NULL;
    return CHECK(rmse, "%s: %s", line, said) ? strtod(rmse + 8, NULL) : -1;
}

/* The planner's document has a plan whose error is met on its own scene. An error that nothing meets gives a picture,
   status 1, and in both units the same. */
static void plans_are_met(void)
{
    const char *share = works("$R room --truth 8 --out truth.exr && $R $(grep -om1 'room --plan visibility:[0-9]*%' "
                              "$T/examples/docs/PLANNER.md) --json --score truth.exr")
                          ? strstr(said, "\"share\": ") : NULL;
    const char *asked = share ? strstr(said, "for a relative error of ") : NULL;
    if (CHECK(asked, "a plan: %s", said))
        CHECK(strtod(share + 9, NULL) <= 1.05 * strtod(asked + 24, NULL), "the planner's example: %s", said);
    works("for e in 0.001 0.1%; do $R boxes --size 64x36 --plan visibility:$e --json --out u.png >u.json; "
          "test $? = 1 && test -s u.png && grep -q '\"meets\": 0' u.json && "
          "grep -q '\"cheaper\": {\"error\"' u.json || exit 1; done; $R boxes --size 64x36 --plan visibility:0:0.2ms "
          "--out u.png | grep -q 'in the budget: .* ms'");
}

/* Writes a model of a floor and a wall of this size at a place. */
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

/* Checks normals: a cube with eight smooth ones is convex, so nothing occludes its faces; with others it does. */
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
    static const char at[] = "cube.obj --camera 2.5,2,4,0,0,0 --fovy 40 --size 96x54 --radius 1";
    char line[400];
    write_text("cube.obj", cube);
    setenv("A", at, 1);
    works("$R $A --truth 4 --out smooth.exr 2>&1 | grep -q 'note: --truth: is about the mesh.s own normals'");
    works("! $R $A --flat --truth 4 --out flat.exr | grep note");
    for (size_t i = 0; i < sizeof row / sizeof *row; ++i) {
        snprintf(line, sizeof line, "%s %s", at, row[i].settings);
        const double off = errs_by(line, "flat.exr");
        CHECK(off >= row[i].least && off <= row[i].most, "%s: RMSE %g", row[i].settings, off);
        snprintf(line, sizeof line, "$R $A %s --score smooth.exr", row[i].settings);
        CHECK(works(line) && strstr(said, row[i].about) && (*row[i].about || !strstr(said, "note")), "%s: %s",
              row[i].settings, said);
    }
}

static void draw(const char *arguments, const char *out)
{
    char line[700];
    snprintf(line, sizeof line, "$R %s --out %s", arguments, out);
    works(line);
}

/* Checks that a scene's picture equals that of its saved frame alone, up to the rounding of depths, which changes a few
   pixels on edges. Light shows whether the camera looks the same way in the world. */
static void frames_carry_cameras(void)
{
    static const char *const scenes[] = {
        "room --size 96x54 --camera 3,2,4,1,1,1 --up 0.3,1,0.1 --fovy 70",
        "room --size 54x96 --camera 3,2,4,1,1,1 --up 0.3,1,0.1 --ortho-height 3.6 --radius 0.3",
        "away.obj --size 96x54 --camera 13487437.764,-4.397,-3741685.403,13487435.764,-5.397,-3741688.403" };
    static const char *const sky = "--method ssdo --env sky --set bounce=none";
    double worst = 0;
    char line[400];
    write_corner("corner.obj", 1, 0, 0, 0);
    write_corner("away.obj", 1, 13487434.764, -6.397, -3741689.403);
    write_corner("small.obj", 2.5e-13, 0, 0, 0);
    write_corner("large.obj", 2.5e8, 0, 0, 0);
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; ++i) {
        snprintf(line, sizeof line, "S='%s' && $R $S --save-gbuffer f.exr --out ao.exr && $R $S %s --out lit.exr",
                 scenes[i], sky);
        works(line);
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
        else draw(line, "near.exr");
    }
    static const struct { const char *name, *light; } sizes[] = {
        { "corner.obj", "sun:1,2,-1,3,3,3" }, { "small.obj", "sun:1,2,-1,3,3,3" }, { "large.obj", "sun:1,2,-1,3,3,3" },
        { "corner.obj", "point:1,3,-2,9,9,9" },
        { "small.obj", "point:2.5e-13,7.5e-13,-5e-13,5.625e-25,5.625e-25,5.625e-25" } };
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; ++i) {
        snprintf(line, sizeof line, "%s --size 96x54 --method ssdo-points --set bounce=none,shadows=map,views=1 "
                 "--light %s", sizes[i].name, sizes[i].light);
        if (i % 3) CHECK(errs_by(line, "near.exr") < 0.002, "of another size it is another picture: %s", line);
        else draw(line, "near.exr");
    }
    static const char *const behind[] = { "hsao --set thickness=back", "hsao --set thickness=slabs",
                                          "hsao-march --set layers=2" };
    for (size_t i = 0; i < sizeof behind / sizeof *behind; ++i) {
        snprintf(line, sizeof line, "plates --size 96x54 --save-gbuffer f.exr --method %s", behind[i]);
        draw(line, "ao.exr");
        snprintf(line, sizeof line, "--gbuffer f.exr --method %s", behind[i]);
        const double off = errs_by(line, "ao.exr");
        CHECK(off >= 0 && off < 0.002, "%s, from its frame: RMSE %g", behind[i], off);
    }
    t_note("RMSE %.1e at most from the saved frame", worst);
}

/* Makes a frame a part of a picture of 192 x 108, down and to the right. */
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

/* Checks the saved frame as Blender would write it: two view layers, 1e10 without a surface, normals of the world. Its
   picture equals the frame's. Layers and channels are chosen by name. Another camera would turn the normals, so it is
   refused unless they are not read. A note appears if --fovy has the horizontal angle. */
static void frames_of_blender(void)
{
    static const char *const theirs[7] = { "Depth.Z",   "Normal.X",  "Normal.Y", "Normal.Z",
                                           "DiffCol.R", "DiffCol.G", "DiffCol.B" };
    static const char *const ours[7] = { "Z", "N.X", "N.Y", "N.Z", "albedo.R", "albedo.G", "albedo.B" };
    static const char *const at = "--gbuffer b.exr --camera 3,2,4,1,1,1 --fovy 70 --radius 0.3";
    static const refusal bad[] = {
        { "--camera 3,2,4,1,1,1", "has several view layers, of which --layer takes one: A, B" },
        { "--camera 3,2,4,1,1,1 --layer C", "--layer C: must be one of the frame's view layers: A, B" },
        { "--layer A", "A.Normal.X is of the world: --camera must say" },
        { "--camera 3,2,4,1,1,1 --layer A --up 0,0,1", "is --up right (Blender: 0,0,1), is --fovy the vertical" },
        { "--channel Z=A.Depth.V",
          "--channel Z=A.Depth.V: there is no such channel; there are A.Depth.Z, A.DiffCol.B," },
        { "--channel Z", "--channel Z: must be NAME=CHANNEL" },
        { "--channel N.X=A.Depth.Z --channel Q=B.Depth.Z",
          "channel Z is missing, view depth; there are N.X, A.DiffCol.B, A.DiffCol.G" } };
    char path[300], line[300], names[600] = "";
    kit_image own, frame;
    kit_header header;
    kit_camera camera = { .eye = { 3, 2, 4 }, .target = { 1, 1, 1 }, .up = { 0, 1, 0 }, .fovy = 70, .znear = 0.1f,
                          .zfar = 100, .width = 96, .height = 54 };
    float view[16], p[16];
    if (!works("$R room --size 96x54 --camera 3,2,4,1,1,1 --fovy 70 --radius 0.3 --save-gbuffer o.exr --out ao.exr")
        || !read_image(&own, &header, "o.exr"))
        return;
    for (int i = 0; i < 14; ++i)
        snprintf(names + strlen(names), sizeof names - strlen(names), "%s%c.%s", i ? "," : "", "AB"[i / 7],
                 theirs[i % 7]);
    kit_camera_matrices(&camera, view, p);
    if (!CHECK(!kit_image_new(&frame, 96, 54, names, NULL), "out of memory")) return;
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
    write_image("b.exr", &frame, NULL);
    snprintf(line, sizeof line, "%s --layer A", at);
    const double off = errs_by(line, "ao.exr");
    CHECK(off >= 0 && off < 0.001, "Blender's layer A: RMSE %g", off);
    snprintf(line, sizeof line, "%s --layer B", at);
    CHECK(errs_by(line, "ao.exr") > 0.01, "layer B is layer A");
    works("$R --gbuffer o.exr --set normal=depth --out n.exr");
    snprintf(line, sizeof line, "%s --channel Z=A.Depth.Z --set normal=depth", at);
    CHECK(errs_by(line, "n.exr") < 0.001, "a channel by its name");
    snprintf(line, sizeof line, "%s --layer A --up 0,0,1 --set normal=depth", at);
    CHECK(errs_by(line, "n.exr") < 0.001, "another --up, which nothing reads");
    setenv("A", at, 1);
    works("$R $A --layer A --fovy 102.4 --out q.exr 2>&1 | "
          "grep -q 'note: --gbuffer b.exr: its normals agree with --fovy 70.0 better than with 102.4'");
    works("! $R $A --layer A --out q.exr 2>&1 | grep note:");
    REFUSED("$R --gbuffer b.exr --fovy 70 --radius 0.3 --out q.exr", bad);
    float *const z = kit_image_channel(&own, "Z");         /* other programs store a sky as such depths */
    for (int k = 0; k < 2; ++k) {
        for (size_t i = 0; i < pixels / 2; ++i) z[i] = k ? FLT_MAX : 0;
        write_image(k ? "sky1.exr" : "sky0.exr", &own, NULL);
    }
    draw("--gbuffer sky0.exr --fovy 70 --radius 0.3", "sky.exr");
    CHECK(errs_by("--gbuffer sky1.exr --fovy 70 --radius 0.3", "sky.exr") < 1e-6, "pixels at FLT_MAX are not sky");
    snprintf(path, sizeof path, "%s/o.exr", folder);
    make_part(path);
    draw("--gbuffer o.exr --set normal=depth", "part.exr");
    CHECK(errs_by("--gbuffer o.exr --set normal=depth --fovy 70", "part.exr") < 1e-4
          && errs_by("--gbuffer o.exr --set normal=depth --fovy 70", "n.exr") > 0.01,
          "the angle of a picture of which the frame is a part");
    kit_image_free(&own);
    kit_image_free(&frame);
}

/* One way in which engines store depth: the layout, OpenGL's clip space or 0 to 1, y down as in Vulkan, a view space
   that looks down +z; or an orthographic camera whose eye stands so far before the frame's. */
typedef struct way { int layout, gl, down, left, orthographic; float shift; const char *options; float eye; } way;

/* Writes the depth buffer of a frame by a way's projection. */
static void buffer_of(float *out, const kit_image *frame, const way *w, const float p[16])
{
    const float *z = kit_image_channel(frame, "Z");
    for (int i = 0; i < frame->width * frame->height; ++i) {
        const double deep = (double)z[i] - (double)w->eye, along = w->left ? deep : -deep;
        const double clip = ((double)p[10] * along + (double)p[14]) / ((double)p[11] * along + (double)p[15]);
        out[i] = !(z[i] > 0) ? (float)(w->layout == KIT_DEPTH_NORMAL) : (float)(w->gl ? 0.5 + 0.5 * clip : clip);
    }
}

/* Returns the largest difference of a depth from the frame's plus more, over that; 1 if one lacks a surface. */
static double depths_off(const kit_image *a, const kit_image *b, double more)
{
    const float *z[2] = { kit_image_channel(a, "Z"), kit_image_channel(b, "Z") };
    double most = 0;
    for (int i = 0; i < a->width * a->height; ++i)
        if (z[0][i] > 0 || z[1][i] > 0)
            most = fmax(most, z[0][i] > 0 && z[1][i] > 0 ? fabs((double)z[1][i] / ((double)z[0][i] + more) - 1) : 1);
    return most;
}

/* Checks capture.py's frame: the buffer's depths and the camera. pictures: 1: from an EXR, 2: from a PNG, too */
static void capture(const kit_image *frame, kit_camera camera, const way *w, int pictures)
{
    char line[1000], words[800] = "";
    float p[16], view[16], q[16];
    kit_image buffer, made;
    kit_header header;
    camera.depth = w->layout;
    for (int i = 0; i < 2; ++i) camera.shift[i] = w->shift * (float)(1 + i);
    if (w->orthographic) { camera.fovy = 0; camera.ortho_height = 4; }
    /* with an eye elsewhere, depths begin at the near plane, less a thousandth of the range */
    const double range = (double)(camera.zfar - camera.znear),
                 more = w->eye != 0 ? 1e-3 * range - (double)camera.znear : 0;
    camera.znear -= w->eye;
    camera.zfar -= w->eye;
    kit_camera_matrices(&camera, view, p);
    if (w->layout == KIT_DEPTH_NORMAL && !w->gl) {                         /* from clip space's [-w, w] to [0, w] */
        p[10] = 0.5f * (p[10] + p[11]);
        p[14] = 0.5f * (p[14] + p[15]);
    }
    for (int i = 8; i < 12 && w->left; ++i) p[i] = 0 - p[i];
    for (int i = 1; i < 16 && w->down; i += 4) p[i] = 0 - p[i];
    for (int i = 0; i < 16; ++i)
        snprintf(words + strlen(words), sizeof words - strlen(words), "%s%.9g", i ? "," : "", (double)p[i]);
    if (!CHECK(!kit_image_new(&buffer, frame->width, frame->height, "A,R", NULL), "out of memory")) return;
    buffer_of(kit_image_channel(&buffer, "R"), frame, w, p);
    write_image("depth.exr", &buffer, NULL);
    kit_image_free(&buffer);
    if (pictures > 1) works("python3 png.py $T/examples/tools/capture");
    for (int png = 0; png < pictures; ++png) {
        snprintf(line, sizeof line, "python3 $C depth.%s made.exr %s%s%s", png ? "png" : "exr",
                 w->options ? w->options : "--projection=", w->options ? "" : words,
                 w->gl && !w->options ? " --gl" : "");
        if (!works(line) || !read_image(&made, &header, "made.exr")) return;
        const double off = depths_off(frame, &made, more);
        CHECK(off < (png ? 2e-3 : 2e-5 + 1e-7 * fabs((double)w->eye)), "%s: depth off by %g", line, off);
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

/* Checks that view depth and world normals as raw floats, bottom row first, come back as frame and camera. */
static void raw_captures(void)
{
    char path[300], line[300], words[800] = "";
    float view[16], p[16], *raw[2] = { NULL, NULL };
    kit_image frame = { 0 }, made;
    kit_header header;
    kit_camera camera = { .znear = 0.1f, .zfar = 100, .width = 96, .height = 54 };
    kit_error err = { "" };
    if (!works("$R room --size 96x54 --save-gbuffer g.exr") || !read_image(&frame, &header, "g.exr")) return;
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
    setenv("V", words, 1);
    snprintf(line, sizeof line, "python3 $C z.raw raw.exr --linear --bottom-up --size=96x54 --normals=n.raw --world "
             "--view=$V --fovy=%.9g --radius=0.5", (double)camera.fovy);
    if (works(line) && read_image(&made, &header, "raw.exr")) {
        double most = 0;
        for (int c = 0; c < 4; ++c)
            for (size_t i = 0; i < pixels; ++i)
                most = fmax(most, fabs((double)(kit_image_channel(&made, names[c])[i]
                                                - kit_image_channel(&frame, names[c])[i])));
        CHECK(most < 1e-5, "a channel is off by %g", most);
        kit_image_free(&made);
    }
    works("$R --gbuffer g.exr --out a.exr && $R --gbuffer raw.exr --score a.exr | grep -q 'RMSE 0.000'");
    for (int k = 0; k < 2; ++k) free(raw[k]);
    kit_image_free(&frame);
}

/* Checks that every layout of depth gives the same frame, and that the script's frame is rendered as the scene is. */
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
    static const refusal bad[] = {
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
    /* a PNG of 16 bits, grey; the rows take turns with all filters */
    static const char png[] =
        "import sys, zlib\nfrom struct import pack\nsys.path.insert(0, sys.argv[1])\nimport pictures\n"
        "wide, high, (depth,) = pictures.exr(open('depth.exr', 'rb').read(), 1, 'R')\n"
        "above, rows = bytes(2 * wide), b''\n"
        "for y in range(high):\n"
        "    row = pack(f'>{wide}H', *(round(65535 * v) for v in depth[y * wide:(y + 1) * wide]))\n"
        "    rows += bytes([y % 5])\n"
        "    for now, a, b, c in zip(row, bytes(2) + row, above, bytes(2) + above):\n"
        "        paeth = min((a, b, c), key=lambda v: abs(a + b - c - v))\n"
        "        rows += bytes([now - (0, a, b, (a + b) // 2, paeth)[y % 5] & 255])\n"
        "    above = row\n"
        "packed = zlib.compress(rows)\n"
        "chunks = (b'IHDR', pack('>2I5B', wide, high, 16, 0, 0, 0, 0)), (b'IDAT', packed[:100]), (b'IDAT', "
        "packed[100:])\n"
        "open('depth.png', 'wb').write(b'\\x89PNG\\r\\n\\x1a\\n' + b''.join(\n"
        "    pack('>I', len(data)) + name + data + bytes(4) for name, data in (*chunks, (b'IEND', b''))))\n";
    char path[300];
    kit_image frame;
    kit_header header;
    if (!has("python3")) return;
    snprintf(path, sizeof path, "%s/examples/tools/capture/capture.py", t_root);
    setenv("C", path, 1);
    write_text("png.py", png);
    if (!works("$R room --size 96x54 --set normal=depth --save-gbuffer f.exr --out ao.exr")
        || !read_image(&frame, &header, "f.exr"))
        return;
    /* at the origin, looking down -z, as in a capture */
    kit_camera camera = { .target = { 0, 0, -1 }, .up = { 0, 1, 0 }, .znear = 0.1f, .zfar = 100, .width = 96,
                          .height = 54 };
    header.has = KIT_HEADER_WINDOW;
    kit_camera_from_header(&camera, &header);
    kit_image_channel(&frame, "Z")[200] = 0;                               /* no surface */
    for (size_t i = 0; i < sizeof ways / sizeof *ways; ++i) capture(&frame, camera, &ways[i], 1 + (i % 4 == 0));
    kit_image_free(&frame);
    setenv("E", endless, 1);
    const double off[2] = { errs_by("--gbuffer made.exr", "ao.exr"),
                            works("python3 $C depth.exr made.exr $E") ? errs_by("--gbuffer made.exr", "ao.exr") : -1 };
    CHECK(off[0] >= 0 && off[0] < 0.03 && off[1] >= 0 && off[1] < 0.005, "RMSE of a PNG %g, of an EXR %g", off[0],
          off[1]);
    raw_captures();
    t_note("a captured room: RMSE %.4f of 16 bits, %.4f of floats", off[0], off[1]);
    write_text("noise.txt", "noise");
    run("head -c 900 depth.png >cut.png; head -c 900 depth.exr >cut.exr; ls >before");
    REFUSED("python3 $C", bad);
    works("ls | diff before - && rm before");
}

/* Checks that JSON is valid whatever a file's name and a reference hold. Words that are a default are shown. */
static void what_is_printed(void)
{
    kit_image endless;
    if (!kit_image_new(&endless, 16, 9, "Y", NULL)) {
        for (int i = 0; i < 16 * 9; ++i) endless.data[i] = INFINITY;
        write_image("endless.exr", &endless, NULL);
        kit_image_free(&endless);
    }
    works("n=$(printf 'a\\377\\303\\251\\355\\240\\200\\\\\"\\tb.exr') && cp f.exr \"$n\" && "
          "$R --gbuffer \"$n\" --fovy 57 --radius 0.5 --score endless.exr --time 1 --json && rm \"$n\"");
    CHECK(strstr(said, "{\"source\": \"a\\ufffd\303\251\\ufffd\\ufffd\\ufffd\\\\\\\"\\u0009b.exr\", \"method\": "
                       "\"hsao\""),
          "a name that is no UTF-8: %s", said);
    CHECK(strstr(said, "\"rmse\": null, \"bias\": null") && !strstr(said, "nan") && !strstr(said, "inf"),
          "a score against infinity: %s", said);
    write_text("json.txt", said);
    if (has("python3"))
        works("python3 -c 'import json; json.load(open(\"json.txt\"), parse_constant=exit)'");
    works("test \"$($R --version)\" = 'ssgi 0.5' && for o in --help --list '--list s3ho'; do $R $o | "
          "awk 'length > 100 { exit 1 }' || exit 1; done");
    works("for p in $T/build/report $T/build/try $T/build/quiet $T/build/reflection $T/build/stability $T/build/bench "
          "$T/build/fit; do test \"$($p --version)\" = 'ssgi 0.5' && $p --help | "
          "awk 'length > 100 || (NR == 1 && !/^usage: /) { exit 1 } END { if (NR < 5) exit 1 }' || "
          "{ echo $p; exit 1; }; done");
    CHECK(works("$R --list s3ho") && strstr(said, "none [joint] apart") && strstr(said, "[linear] square")
              && strstr(said, "4 in 1..4"), "the settings of s3ho: %s", said);
}

/* ---- >>bench ----------------------------------------------------------------------------------------------------- */

/* Checks rows of bench.csv, for a picture that the room fills: a frame's milliseconds and bytes are the sums of its
   passes', and its traffic takes bytes / copied seconds. */
static void bench_rows(const char *csv, double copied)
{
    static const char *const passes[] = { "frame", "thickness", "hsao", "blur" };
    double v[4][6], sum = 0; /* a row's count, ms, two quartiles, bytes, ms of traffic */
    for (int i = 0; i < 4; ++i) {
        char begins[80];
        snprintf(begins, sizeof begins, "\nhsao-best,\"\",64,36,%s,", passes[i]);
        const char *at = strstr(csv, begins);
        if (!CHECK(at && sscanf(at + strlen(begins), "%lf,%lf,%lf,%lf,%lf,%lf", v[i], v[i] + 1, v[i] + 2, v[i] + 3,
                                v[i] + 4, v[i] + 5) == 6, "no row of %s: %s", passes[i], csv))
            return;
        CHECK(v[i][0] >= 1 && v[i][2] > 0 && v[i][2] <= v[i][1] && v[i][1] <= v[i][3] && v[i][5] <= v[i][1],
              "%s: %g times, %g ms, quartiles %g, %g, traffic's %g", passes[i], v[i][0], v[i][1], v[i][2], v[i][3],
              v[i][5]);
        CHECK(fabs(v[i][4] / (v[i][5] * 1e-3) / copied - 1) < 0.02, "%s: %g bytes in %g ms at %g a second", passes[i],
              v[i][4], v[i][5], copied);
        sum += i ? v[i][4] : 0;
    }
    CHECK(fabs(sum / v[0][4] - 1) < 1e-4, "passes move %g bytes, the frame %g", sum, v[0][4]);
    /* bytes a pixel: 16 of a normal and 8 written, and 16 of thickness at half resolution */
    CHECK(fabs(v[2][4] - (24 * 64 * 36 + 16 * 32 * 18)) < 1, "hsao moves %g bytes", v[2][4]);
}

/* Checks that of the table fit prints the lines that changed: here that of choice 3, in its second cost. */
static void bench_fits(const char *plan)
{
    char was[300], is[300];
    double cost, before[2], after[2];
    int choice;
    const char *row = strchr(plan, '\n');
    if (!CHECK(*plan == '#' && row && sscanf(row, "%d,%lf", &choice, &cost) == 2 && choice == 3 && cost > 0,
               "plan-software.csv: %s", plan)
        || !works("$T/build/fit /dev/null 2>/dev/null >was.txt && "
                  "$T/build/fit /dev/null b/plan-software.csv 2>/dev/null >is.txt; diff was.txt is.txt | "
                  "grep -c '^[<>]'; grep -c SSGI__P is.txt; sed -n 4p was.txt; sed -n 4p is.txt; "
                  "grep '^  SSGI__P(' ssgi.h | diff - was.txt")
        || !CHECK(sscanf(said, "2\n%d\n%299[^\n]\n%299[^\n]", &choice, was, is) == 3
                      && choice == SSGI_PLAN_CHOICES, "fit: %s", said))
        return;
    const char *const costs = "  SSGI__P(V, HSAO, WIDTH, 1, 1, 8, 0, 0, 0, 0, %lff, %lff";
    CHECK(sscanf(was, costs, &before[0], &before[1]) == 2 && sscanf(is, costs, &after[0], &after[1]) == 2
          && after[0] == before[0] && fabs(after[1] / cost - 1) < 0.05, "measured %g: %s became %s", cost, was, is);
}

static void bench(void)
{
    static const refusal bad[] = {
        { "--size 4x4", "--size 4x4" }, { "--size 64x36,", "--size 64x36," }, { "--plan 999", "--plan 999" },
        { "--seconds 1s", "--seconds 1s" }, { "--method none", "--method none" }, { "--context none", "none" },
        { "--scene nowhere", "nowhere" }, { "--none 1", "--none" }, { "--method", "--method: needs a value" },
        { "--out /dev/null/b", "/dev/null" } };
    static const refusal bad_costs[] = { { "bad.csv", "bad.csv: line 1" }, { "worse.csv", "worse.csv: line 2" } };
    char path[256], *file;
    double copied = 0;
    setenv("CONTEXT", run("$R plane --size 8x8 --context osmesa --out o.exr") ? "egl" : "osmesa", 1); /* the CPU's */
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    REFUSED("$T/build/bench --context $CONTEXT --size 64x36 --method hsao-best", bad);
    works("! test -e report");
    write_text("bad.csv", "3\n");
    write_text("worse.csv", "3,1.5\n3,1.5 x\n");
    REFUSED("$T/build/fit /dev/null", bad_costs);
    if (!works("$T/build/bench --context $CONTEXT --size 64x36 --method hsao-best --plan 3 --seconds 1 --out b >b.txt "
               "&& cat b.txt && { ! command -v node >/dev/null || node -e 'ssgi_record = r => "
               "process.exit(r.entries.some(e => e?.table == `bench` && e.csv) ? 0 : 1); require(`./b/bench.js`)'; }"))
        return;
    const char *rate = strstr(said, "passes copied ");
    CHECK(strstr(said, "\nhsao-best  ") && strstr(said, "No GPU was found") && strstr(said, "llvmpipe") && rate
          && sscanf(rate, "passes copied %lf GB/s", &copied) == 1, "%s", said);
    snprintf(path, sizeof path, "%s/b/bench.csv", folder);
    if (CHECK((file = read_text(path)) != NULL, "no bench.csv")) { bench_rows(file, copied * 1e9); free(file); }
    snprintf(path, sizeof path, "%s/b/plan-software.csv", folder);
    if (CHECK((file = read_text(path)) != NULL, "no plan-software.csv")) { bench_fits(file); free(file); }
    works("! test -e b/plan-gpu.csv");
}

/* ---- >>make ------------------------------------------------------------------------------------------------------ */

/* Returns how many objects of build/render and of both test programs make would compile in the copy. */
static int compiled_again(void)
{
    return works("MAKEFLAGS= make -n -C tree build/render build/test build/test-examples >made.txt && "
                 "grep -c ' -c .* -o build/.*[.]o$' made.txt || test $? = 1") ? atoi(said) : -1;
}

/* Checks what make compiles after edits in a copy of the tree, made of links and built as far as the tree is. */
static void edits(void)
{
    static const struct { const char *edit; int least, most; } cases[] = {
        { "$s/$/ /", 2, 8 },                               /* behind the declarations: library_gl.o, own.h */
        { "s/END OF HEADER/& /", 40, 400 } };              /* in the declarations: all that include kit_gl.h */
    char line[300];
    works("mkdir -p tree/build && cp -rs $T/Makefile $T/*.h $T/examples $T/tests tree && cd $T/build && "
          "cp -rs $PWD/kit $PWD/examples $PWD/tests $PWD/include $PWD/assimp \"$OLDPWD/tree/build\"");
    const int before = compiled_again();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        snprintf(line, sizeof line, "cp $T/ssgi_gl.h tree/edited && sed -i '%s' tree/edited && mv tree/edited "
                 "tree/ssgi_gl.h && ! cmp -s tree/ssgi_gl.h $T/ssgi_gl.h", cases[i].edit);
        works(line);
        const int again = compiled_again() - before;
        CHECK(again >= cases[i].least && again <= cases[i].most, "%s: %d objects are compiled again", cases[i].edit,
              again);
        t_note("%d objects", again);
    }
}

/* Checks that the tests run from any folder and environment. */
static void anywhere(void)
{
    works("cd / && env -i $T/build/test library | grep -q ' passed, 0 failed'");
}

void test_tools(void)
{
    char path[300];
    if (!folder_begin()) return;
    setenv("T", t_root, 1);
    snprintf(path, sizeof path, "%s/build/render", t_root);
    setenv("R", path, 1);
    snprintf(path, sizeof path, "%s/build/glsl-text", t_root);
    setenv("G", path, 1);
    RUN("tests run from any folder, without an environment", anywhere);
    RUN("an edit of GLSL compiles again what holds the implementation, one of a declaration all that calls it", edits);
    RUN("examples/minimal.c draws the same by OSMesa and by EGL", minimal);
    RUN("without OSMesa the default context is EGL's, and draws the same", without_osmesa);
    RUN("the library of GLSL as files: a room each, of GLSL alone", rooms_as_files);
    RUN("the manifest's formulas make the frames of 1,000 cameras, within 2 units of the last place",
        manifest_of_cameras);
    RUN("bindgen gives constants the type of their fields", bindings_of_rust);
    RUN("a chain as one writes it is made in the languages named, or refused by its field", own_chain);
    RUN("the headers as WebAssembly, without a C library, give the same texts, rows and blocks", wasm);
    RUN("what make install and make npm leave serves pkg-config, CMake and node", packages);
    RUN("make dist gives the same bytes each time, and serves CMake and Meson", release);
    RUN("C, C++, Python and JavaScript have the same methods", methods_anywhere);
    RUN("a saved frame is rendered by nothing but itself: the scene's picture; options override", frames_carry_cameras);
    RUN("truth and scores say whose normals they are about, and can be about faces", normals_are_told);
    RUN("a frame as Blender writes it is the frame, its view layers and channels are named", frames_of_blender);
    RUN("a captured depth buffer becomes a frame with its camera, however the engine lays it out", captures);
    RUN("each setting of each method is refused beyond its limits, by its name", settings);
    RUN("render answers bad input with one line, status 2 and no file", command_line);
    RUN("the planner's example is met, and an error that nothing meets gives status 1 and a picture", plans_are_met);
    RUN("what render prints is JSON, and names defaults", what_is_printed);
    RUN("bench has every row, with bounds that add up and no traffic faster than a copy; fit takes its costs", bench);
    RUN("what cannot be written is said, with status 2; links are written through, lines may end in CR", streams);
    RUN("every method draws under sanitizers", sanitized);
    folder_end();
}
