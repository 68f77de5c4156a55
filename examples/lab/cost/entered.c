/* entered.c - draws passes with edited shaders, which record the bodies they enter. Declared in entered.h. */
#include "lab/cost/entered.h"
#include "lab/against/look.h"
#include "lab/cost/share.h"
#include <stdlib.h>
#include <string.h>

enum { SEEDS = 12, MOST_BITS = 24 };        /* MOST_BITS: whole numbers below 2^24 are exact in a float */

/* A method's frames. ONCE: one alone; STANDS, TURNS: the last of LOOK_FRAMES of a camera that stands or turns. */
typedef enum moves { ONCE, STANDS, TURNS } moves;
static const char *const cameras[] = { "", "stands", "turns" };

/* A method to be drawn, and its bodies, which are measured one after the other. */
typedef struct drawn { const char *method, *settings; moves camera; int body[2], count; } drawn;

static const drawn all[] = {
    { "hsao", "", ONCE, { COVER }, 1 },
    { "hsao-fast", "", ONCE, { COVER }, 1 },
    { "hsao-best", "", ONCE, { COVER }, 1 },
    { "ssdo", "bounce=none", ONCE, { COVER }, 1 },
    { "s3ho", "", ONCE, { COVER }, 1 },
    { "hsao", "thickness=solid", ONCE, { COVER_SOLID }, 1 },
    { "hsao", "thickness=slabs", ONCE, { SECOND }, 1 },
    { "hsao-fast", "thickness=slabs", ONCE, { SECOND }, 1 },
    { "hsao-best", "thickness=slabs", ONCE, { SECOND }, 1 },
    { "ssdo", "", ONCE, { SENT }, 1 },
    { "ssdo-fast", "", ONCE, { SENT }, 1 },
    { "ssdo-best", "", ONCE, { SENT }, 1 },
    { "hsao-history", "", STANDS, { UNSETTLED, CHANGED }, 2 },
    { "hsao-history", "", TURNS, { UNSETTLED, CHANGED }, 2 }
};
enum { DRAWN = (int)(sizeof all / sizeof *all) };

/* ---- the text ---------------------------------------------------------------------------------------------------- */

/* Edits the fragment shader of a pass so that it records, at the body's line, whether a texel enters the body, and
   writes that in a main function of its own. The caller frees it. */
static char *telling(const char *text, const body *b, const kit_pass *p, kit_error *err)
{
    const char *line = strstr(text, b->line), *rest = strchr(text, '\n') + 1;
    const size_t size = strlen(text) + 1024;
    char *to;
    if (strstr(line + 1, b->line)) return kit_fail(err, "a text has the line `%s` twice", b->line), NULL;
    if (!(to = malloc(size))) return kit_fail(err, "out of memory"), NULL;
    snprintf(to, size, "%.*s#define main picture\nuvec2 told = uvec2(0u);\nint times = 0;\nbool shown = false;\n"
             "%.*s%s\n%s\n#undef main\nvoid main() {\n    picture();\n"
             "    %s.xy = vec2(float(told.x), shown ? float(told.y) : -1.0 - float(told.y));\n}\n",
             (int)(rest - text), text, (int)(line - rest), rest, b->tells, line, p->step->output[0].name);
    return to;
}

/* Compiles the program of an edited shader, or finds it among those compiled before. */
static GLuint program_of(const kit_pass *p, const body *b, const char *fragment, kit_error *err)
{
    static const GLenum stages[] = { GL_VERTEX_SHADER, GL_FRAGMENT_SHADER };
    char *text = telling(fragment, b, p, err), *vertex = text_of(&p->desc, SSGI_GL_STAGE_VERTEX);
    const uint64_t key = text ? kit_hash(KIT_HASH, text, strlen(text)) : 0;
    GLuint program = text ? kit_program_kept(key) : 0;
    if (text && vertex && !program) {
        program = kit_program((const char *const[]) { vertex, text }, stages, 2, err);
        if (program && !kit_program_keep(key, program, err)) kit_pass_bind(program, p->io, p->rows);
    }
    free(vertex);
    free(text);
    return program;
}

/* Returns the first pass of a run whose shader has the body; NULL: no pass has it, or its program failed. */
static kit_pass *pass_of(kit_run *run, const body *b, GLuint *program, kit_error *err)
{
    for (int i = 0; i < run->passes; ++i) {
        kit_pass *p = &run->pass[i];
        char *text = text_of(&p->desc, SSGI_GL_STAGE_FRAGMENT);
        const int has = text && strstr(text, b->line);
        *program = has ? program_of(p, b, text, err) : 0;
        free(text);
        if (has) return *program ? p : NULL;
    }
    return kit_fail(err, "no pass has the line `%s` any more", b->line), NULL;
}

/* ---- pictures ---------------------------------------------------------------------------------------------------- */

/* The shares of a body on one scene, by tile. half, steps: settings of the pass. */
typedef struct found { double share[TILES]; int half, steps; } found;
static found results[DRAWN][2][SEEDS];

static int read(found *f, const kit_pass *p, const body *b, kit_error *err)
{
    const int ways = p->desc.gather.slices ? p->desc.gather.slices : p->desc.gather.directions,
              gathered = ways * p->desc.gather.samples, times = b->times ? b->times : 2 * gathered;
    told *texel = malloc((size_t)p->width * (size_t)p->height * sizeof *texel);
    const int failed = !texel || (b->times ? times : gathered) > MOST_BITS ||
                       kit_texture_read(p->target[0], p->width, p->height, 2, texel->entered);
    for (int t = 0; t < TILES && !failed; ++t)
        f->share[t] = share_of(texel, p->width, p->height, &tiles[t], times);
    f->half = p->desc.gather.resolution > 0;
    f->steps = p->desc.gather.samples;
    free(texel);
    return failed ? kit_fail(err, "the texels cannot be read, or hold more than %d bits", MOST_BITS) : 0;
}

/* Draws a frame for each body. As an output of the pass is overwritten, the next frame's history is useless. */
static int ask(found of[][SEEDS], int seed, kit_run *run, const drawn *d, kit_error *err)
{
    for (int i = 0; i < d->count; ++i) {
        const body *b = &bodies[d->body[i]];
        GLuint program;
        kit_pass *p = pass_of(run, b, &program, err);
        if (!p) return -1;
        const GLuint was = p->program;
        p->program = program;
        kit_run_draw(run, 0);
        p->program = was;
        if (read(&of[i][seed], p, b, err)) return -1;
    }
    return 0;
}

static int draw(int which, int seed, stage *s, kit_error *err)
{
    const drawn *d = &all[which];
    const kit_world world = { &s->scene, &s->lighting };
    const int last = d->camera == ONCE ? 0 : LOOK_FRAMES - 1;
    kit_gbuffer turned[2] = { { .width = 0 }, { .width = 0 } };
    kit_frames run = { .now = NULL };
    kit_method method;
    int failed = kit_method_find(&method, d->method, err) || kit_method_set(&method, d->settings, err);
    for (int k = 0; k <= last && !failed; ++k) {
        kit_gbuffer *g = d->camera == TURNS && k ? &turned[k & 1] : &s->gbuffer;
        if (g != &s->gbuffer) {
            kit_camera camera = s->gbuffer.camera;
            kit_camera_orbit(&camera, &s->gbuffer.camera, LOOK_ORBIT * k);
            if (g->depth) kit_gbuffer_free(g);
            failed = kit_gbuffer_from_scene(g, &s->scene, &camera, NULL, err);
        }
        failed = failed || (d->camera == STANDS && k ? kit_frames_again(&run, err)
                            : kit_frames_next(&run, g, &method, s->radius, &world, NULL, err));
        if (!failed && k < last) kit_run_draw(run.now, 0);
    }
    failed = failed || ask(results[which], seed, run.now, d, err);
    kit_frames_close(&run);
    for (int k = 0; k < 2; ++k) if (turned[k].depth) kit_gbuffer_free(&turned[k]);
    return failed;
}

static int measure(int seed, kit_error *err)
{
    static const lit own = { .rays = 1, .exposure = 1, .bounce = 1 };
    char name[32];
    stage s;
    snprintf(name, sizeof name, "random:%d", seed);
    const view v = { .name = name, .path = name, .lit = &own };
    if (stage_load(&s, &v, err)) return -1;
    kit_camera camera = s.scene.camera;
    camera.width = LOOK_WIDTH;
    camera.height = LOOK_HEIGHT;
    s.radius = s.scene.radius;
    int failed = kit_gbuffer_from_scene(&s.gbuffer, &s.scene, &camera, NULL, err);
    for (int i = 0; i < DRAWN && !failed; ++i) failed = draw(i, seed, &s, err);
    stage_close(&s);
    return failed;
}

/* ---- results ----------------------------------------------------------------------------------------------------- */

static void write_row(FILE *f, const drawn *d, int which, const found *of, int t)
{
    double share = 0;
    for (int k = 0; k < SEEDS; ++k) share += of[k].share[t] / SEEDS;
    fprintf(f, "%s,\"%s\",%s,%s,%d,%d,%s,%.4f\n", d->method, d->settings, cameras[d->camera],
            bodies[d->body[which]].name, of->half, of->steps, tiles[t].name, share);
}

int entered_write(FILE *f, kit_error *err)
{
    int failed = kit_gl_open(NULL, err);
    for (int k = 0; k < SEEDS && !failed; ++k) {
        kit_progress("scenes by seed", k / (double)SEEDS);
        failed = measure(k, err);
    }
    kit_gl_close();
    if (failed) return -1;
    kit_progress("scenes by seed", 1);
    fputs("method,settings,camera,body,half,steps,tile,share\n", f);
    for (int i = 0; i < DRAWN; ++i)
        for (int which = 0; which < all[i].count; ++which)
            for (int t = 0; t < TILES; ++t) write_row(f, &all[i], which, results[i][which], t);
    return 0;
}
