/* peers.c - effects of other libraries, as rows beside this library's. Declared in peers.h.

   peers.mjs writes the draws of each effect for a view, as GLSL and numbers (make peers puts it, and the packages that
   it drives, under build/peers). Here these are drawn on the stage's own depth and normals, and timed and scored as the
   library's methods are. They are scored once more after the best fit of two numbers to each picture, which no gain,
   power or intensity of theirs could better. The time is that of all passes that make the ambient visibility, denoisers
   included, without those that only multiply the picture by it. */
#include "lab/measure/peers.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "lab/measure/clock.h"
#include "lab/measure/csv.h"
#include "lab/measure/score.h"
#include "lab/measure/script.h"

#define PEERS "build/peers/"
enum { PEER_PASSES = 8, PEER_SAMPLERS = 12, PEER_TARGETS = 2, PEER_TEXTURES = 160, PEER_BINS = 1024 };

typedef struct peer_pass {
    GLuint program, framebuffer, sampler[PEER_SAMPLERS];
    int    samplers, targets, width, height, shown, cleared;
    float  colour[4];
} peer_pass;
typedef struct peer { char label[64], settings[128]; peer_pass pass[PEER_PASSES]; int passes, result; } peer;
typedef struct peer_texture { GLuint name; int width, height; } peer_texture;
/* A set of other libraries' effects for one view. folder: of the script's files. whole: the frame, truth or not. */
typedef struct peer_set {
    peer         peer[MOST_PEERS];
    peer_texture texture[PEER_TEXTURES];
    int          peers, textures;
    char         folder[64];
    kit_image    whole;
} peer_set;

static const char *missing = "";

const char *peers_missing(void) { return missing; }

/* ---- >>reading: the view for the script, and the script's results ------------------------------------------------ */

/* Runs peers.mjs for a stage's view. Returns 0 if there are no peers, and missing says why. */
static int peers_write(const peer_set *set, const stage *s, int quick, kit_error *err)
{
    const kit_camera *c = &s->gbuffer.camera;
    const size_t pixels = (size_t)c->width * (size_t)c->height;
    const float *z = kit_image_channel(&s->frame, "Z");
    double *depths = malloc(pixels * sizeof *depths);
    struct stat status;
    int n = 0;
    if (!depths) return kit_fail(err, "out of memory");
    for (size_t i = 0; i < pixels; ++i) if (z[i] > 0) depths[n++] = (double)z[i];
    missing = stat(SCRIPT, &status)
                  ? "Without " PEERS_THEY ": make peers installs them (it needs node, npm and the network)."
              : c->fovy <= 0 || c->depth != KIT_DEPTH_NORMAL || s->gbuffer.depth_is_linear || !n
                  ? "Without " PEERS_THEY ": they are not driven with such a view."
                  : "";
    const double depth = *missing ? 0 : kit_median(depths, n);
    free(depths);
    if (*missing) return 0;
    const int ran = script_run(set->folder, c, s->radius, depth, quick, err);
    if (ran < 0) return -1;
    if (!ran) missing = "Without " PEERS_THEY ": node cannot run " SCRIPT ".";
    return !*missing;
}

static void peer_uniform(GLuint program, const char *type, const char *name, int count, const float *values)
{
    const GLint at = glGetUniformLocation(program, name);
    glUseProgram(program);
    if (!strcmp(type, "float")) glUniform1fv(at, count, values);
    else if (!strcmp(type, "vec2")) glUniform2fv(at, count, values);
    else if (!strcmp(type, "vec3")) glUniform3fv(at, count, values);
    else if (!strcmp(type, "vec4")) glUniform4fv(at, count, values);
    else if (!strcmp(type, "mat3")) glUniformMatrix3fv(at, count, GL_FALSE, values);
    else if (!strcmp(type, "mat4")) glUniformMatrix4fv(at, count, GL_FALSE, values);
    else if (!strcmp(type, "uint")) glUniform1ui(at, (GLuint)values[0]);
    else glUniform1i(at, (int)values[0]);
}

/* Makes the program of a pass from the script's files N.vert and N.frag. */
static int peer_programs(peer_pass *pass, const peer_set *set, int number, kit_error *err)
{
    char path[96], *text[2] = { NULL, NULL };
    size_t size;
    for (int k = 0; k < 2; ++k) {
        snprintf(path, sizeof path, "%s/%d.%s", set->folder, number, k ? "frag" : "vert");
        if (kit_file_read(&text[k], &size, path, err)) { free(text[0]); return -1; }
    }
    pass->program = kit_program_text("", text[0], text[1], err);
    free(text[0]);
    free(text[1]);
    return pass->program ? 0 : -1;
}

/* One line of peers.mjs' manifest.csv. */
typedef struct told { const csv *all; int row; } told;

static const char *text_of(const told *t, const char *key) { return csv_text(t->all, t->row, key); }
static int whole_of(const told *t, const char *key) { return atoi(text_of(t, key)); }

static int peer_texture_read(peer_texture *t, const peer_set *set, const told *is, kit_error *err)
{
    const int format = whole_of(is, "format"),
              parts = format == GL_R8 || format == GL_R16F || format == GL_R32F ? 1 : 4;
    char path[128], *data = NULL;
    size_t size = 0;
    *t = (peer_texture){ 0, whole_of(is, "width"), whole_of(is, "height") };
    snprintf(path, sizeof path, "%s/%s", set->folder, text_of(is, "file"));
    if (*text_of(is, "file") && kit_file_read(&data, &size, path, err)) return -1;
    if (data && size < (size_t)t->width * (size_t)t->height * (size_t)parts * sizeof(float)) {
        free(data);
        return kit_fail(err, "%s: is too short", path);
    }
    t->name = kit_texture(t->width, t->height, (GLenum)format, (const float *)(void *)data);
    free(data);
    glBindTexture(GL_TEXTURE_2D, t->name);
    if (whole_of(is, "linear")) kit_texture_linear(GL_TEXTURE_2D);
    for (GLenum k = 0; k < 2 && whole_of(is, "repeat"); ++k)
        glTexParameteri(GL_TEXTURE_2D, k ? GL_TEXTURE_WRAP_T : GL_TEXTURE_WRAP_S, GL_REPEAT);
    return t->name ? 0 : kit_fail(err, "peers' manifest.csv, line %d: no such texture", is->row + 2);
}

/* Makes a texture of view depth times a number, with a given value at pixels without a surface. */
static int peer_depth_read(peer_texture *t, const kit_image *frame, const told *is, kit_error *err)
{
    const int width = frame->width, height = frame->height;
    const float *z = kit_image_channel(frame, "Z");
    const float times = (float)atof(text_of(is, "scale")), empty = (float)atof(text_of(is, "empty"));
    float *depths = malloc((size_t)width * (size_t)height * sizeof *depths);
    for (int y = 0; y < height && depths; ++y) for (int x = 0; x < width; ++x) {
        const float at = z[(size_t)(height - 1 - y) * (size_t)width + (size_t)x];
        depths[(size_t)y * (size_t)width + (size_t)x] = at > 0 ? at * times : empty;
    }
    *t = (peer_texture){ depths ? kit_texture(width, height, GL_R32F, depths) : 0, width, height };
    glBindTexture(GL_TEXTURE_2D, t->name);
    if (whole_of(is, "linear")) kit_texture_linear(GL_TEXTURE_2D);
    free(depths);
    return t->name ? 0 : kit_fail(err, "out of memory");
}

static const peer_texture *peer_texture_of(const peer_set *set, int number)
{
    return &set->texture[number < 0 || number >= set->textures ? 0 : number];
}

static int peer_pass_read(peer_pass *pass, const peer_set *set, const told *is, kit_error *err)
{
    GLenum attachment[PEER_TARGETS];
    const char *at = text_of(is, "targets");
    char *end;
    float *const c = pass->colour;
    pass->shown = whole_of(is, "shown");
    pass->width = whole_of(is, "width");
    pass->height = whole_of(is, "height");
    pass->cleared = sscanf(text_of(is, "values"), "%f %f %f", &c[0], &c[1], &c[2]) == 3;
    c[3] = 1;
    if (peer_programs(pass, set, whole_of(is, "number"), err)) return -1;
    glGenFramebuffers(1, &pass->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, pass->framebuffer);
    for (; *at && pass->targets < PEER_TARGETS; at = end) {
        const peer_texture *t = peer_texture_of(set, (int)strtol(at, &end, 10));
        attachment[pass->targets] = GL_COLOR_ATTACHMENT0 + (GLenum)pass->targets;
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachment[pass->targets++], GL_TEXTURE_2D, t->name, 0);
    }
    glDrawBuffers(pass->targets, attachment);
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE
               ? 0
               : kit_fail(err, "peers' manifest.csv, line %d: no such targets", is->row + 2);
}

static void peer_sampler_read(peer_pass *pass, const peer_set *set, const told *is)
{
    const float unit = (float)pass->samplers;
    peer_uniform(pass->program, "int", text_of(is, "name"), 1, &unit);
    pass->sampler[pass->samplers++] = peer_texture_of(set, whole_of(is, "number"))->name;
}

static void peer_uniform_read(peer_pass *pass, const told *is)
{
    float values[16 * 64];
    char *at = (char *)(uintptr_t)text_of(is, "values");
    for (int i = 0; i < COUNT(values); ++i) values[i] = strtof(at, &at);
    peer_uniform(pass->program, text_of(is, "type"), text_of(is, "name"), whole_of(is, "count"), values);
}

static int peer_line_read(peer_set *set, const told *is, kit_error *err)
{
    const char *kind = text_of(is, "kind");
    peer *p = set->peers ? &set->peer[set->peers - 1] : NULL;
    peer_pass *pass = p && p->passes ? &p->pass[p->passes - 1] : NULL;
    if (!strcmp(kind, "texture") && set->textures < PEER_TEXTURES)
        return peer_texture_read(&set->texture[set->textures++], set, is, err);
    if (!strcmp(kind, "depth") && set->textures < PEER_TEXTURES)
        return peer_depth_read(&set->texture[set->textures++], &set->whole, is, err);
    if (!strcmp(kind, "pass") && p && p->passes < PEER_PASSES)
        return peer_pass_read(&p->pass[p->passes++], set, is, err);
    if (!strcmp(kind, "peer") && set->peers < MOST_PEERS) {
        p = &set->peer[set->peers++];
        snprintf(p->label, sizeof p->label, "%s", text_of(is, "name"));
        snprintf(p->settings, sizeof p->settings, "%s", text_of(is, "settings"));
    } else if (!strcmp(kind, "uniform") && pass) peer_uniform_read(pass, is);
    else if (!strcmp(kind, "sampler") && pass && pass->samplers < PEER_SAMPLERS) peer_sampler_read(pass, set, is);
    else if (!strcmp(kind, "result") && p) p->result = whole_of(is, "number");
    else return kit_fail(err, "peers' manifest.csv, line %d: %s: too many, or out of place", is->row + 2, kind);
    return 0;
}

/* Reads peers.mjs' manifest.csv. Textures 0 to 3 of the set are the caller's. */
static int peers_read(peer_set *set, kit_error *err)
{
    const csv all = csv_read(set->folder, "manifest.csv");
    int failed = all.rows ? 0 : kit_fail(err, "%s/manifest.csv: cannot be read", set->folder);
    for (told is = { &all, 0 }; is.row < all.rows && !failed; ++is.row) failed = peer_line_read(set, &is, err);
    free(all.cell);
    free(all.text);
    return failed;
}

/* ---- >>drawing --------------------------------------------------------------------------------------------------- */

static void peer_pass_draw(const peer_pass *pass, GLuint program)
{
    glViewport(0, 0, pass->width, pass->height);
    glUseProgram(program);
    for (int k = 0; k < pass->samplers; ++k) {
        glActiveTexture(GL_TEXTURE0 + (GLenum)k);
        glBindTexture(GL_TEXTURE_2D, pass->sampler[k]);
    }
    if (pass->cleared) glClearBufferfv(GL_COLOR, 0, pass->colour);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

/* Draws all passes of peer i. Returns milliseconds. */
static double peer_draw(void *set, int i)
{
    const peer *p = &((const peer_set *)set)->peer[i];
    double ms = 0;
    for (int k = 0; k < p->passes; ++k) {
        kit_timer_begin();
        glBindFramebuffer(GL_FRAMEBUFFER, p->pass[k].framebuffer);
        peer_pass_draw(&p->pass[k], p->pass[k].program);
        ms += p->pass[k].shown ? (kit_timer_end(), 0) : kit_timer_end();
    }
    return ms;
}

static int peer_picture(kit_image *out, const peer_set *set, const peer *p, const stage *s, kit_error *err)
{
    const int width = s->truth.width, height = s->truth.height;
    float *rows = malloc((size_t)width * (size_t)height * sizeof *rows);
    int failed = rows ? kit_image_new(out, width, height, "Y", err) : kit_fail(err, "out of memory");
    if (!failed && kit_texture_read(peer_texture_of(set, p->result)->name, width, height, 1, rows)) {
        kit_image_free(out);
        failed = kit_fail(err, "%s: cannot be read", p->label);
    }
    for (int y = 0; y < height && !failed; ++y)
        memcpy(out->data + (size_t)y * (size_t)width, rows + (size_t)(height - 1 - y) * (size_t)width,
               (size_t)width * sizeof *rows);
    free(rows);
    return failed;
}

/* ---- >>fit: the best fit of two numbers -------------------------------------------------------------------------- */

/* a histogram of visibility v from -1 to 1; each bin also has the sum of the truth at its pixels */
typedef struct histogram { double count[PEER_BINS], truth[PEER_BINS], squares, pixels; } histogram;

/* Returns the RMSE to the truth of a v^b, or, if open, of 1 - a (1 - v)^b. */
static double fit_rmse(const histogram *h, int open, const double log_ab[2])
{
    const double a = exp(log_ab[0]), b = exp(log_ab[1]);
    double sum = h->squares;
    for (int i = 0; i < PEER_BINS; ++i) {
        const double v = 2 * (i + 0.5) / PEER_BINS - 1, x = a * pow(fmax(open ? v : 1 - v, 0), b),
                     fitted = fmin(fmax(open ? x : 1 - x, 0), 1);
        if (h->count[i] > 0) sum += h->count[i] * fitted * fitted - 2 * fitted * h->truth[i];
    }
    return sqrt(fmax(sum, 0) / h->pixels);
}

static void histogram_of(histogram *h, const kit_image *picture, const stage *s)
{
    const float *z = kit_image_channel(&s->frame, "Z"), *truth = kit_image_channel(&s->truth, "Y");
    memset(h, 0, sizeof *h);
    for (size_t i = 0; i < (size_t)picture->width * (size_t)picture->height; ++i) {
        const int bin = (int)fmin(fmax((double)(picture->data[i] + 1) * PEER_BINS / 2, 0), PEER_BINS - 1);
        if (!(z[i] > 0)) continue;
        h->count[bin] += 1;
        h->truth[bin] += (double)truth[i];
        h->squares += (double)truth[i] * (double)truth[i];
        h->pixels += 1;
    }
}

static double fit_best(const histogram *h)
{
    double best = HUGE_VAL;
    for (int start = 0; start < 6; ++start) {
        double at[2] = { 0, log(0.4) + log(2.5) * (start / 2) }, here = fit_rmse(h, start % 2, at);
        for (double step = 1; step > 1e-3;) {
            int better = 0;
            for (int k = 0; k < 4; ++k) {
                double to[2] = { at[0], at[1] }, there;
                to[k / 2] += k % 2 ? step : -step;
                there = fit_rmse(h, start % 2, to);
                if (there < here) { here = there; at[0] = to[0]; at[1] = to[1]; better = 1; }
            }
            if (!better) step /= 2;
        }
        best = fmin(best, here);
    }
    return best;
}

/* Fills in the relative error of a peer's row after its picture's own best fit, and after each of a table of fits, from
   which the best one over all scenes is taken later. Gains are from .61 to 1.65, exponents from .37 to 2.7, in even
   logarithmic steps. */
static void fit_row(row *r, const histogram *h)
{
    const double share = r->share / r->score.rmse;
    r->figure[FITTED] = share * fit_best(h);
    for (int i = 0; i < FITS; ++i) {
        const int gain = i / 2 % FIT_GAINS, exponent = i / 2 / FIT_GAINS;
        const double at[2] = { 0.125 * (gain - FIT_GAINS / 2), 0.25 * (exponent - FIT_EXPONENTS / 2) };
        r->figure[FIT + i] = share * fit_rmse(h, i % 2, at);
    }
}

/* ---- >>rows ------------------------------------------------------------------------------------------------------ */

static void peers_free(peer_set *set)
{
    for (int i = 0; i < set->peers; ++i) for (int k = 0; k < set->peer[i].passes; ++k) {
        glDeleteProgram(set->peer[i].pass[k].program);
        glDeleteFramebuffers(1, &set->peer[i].pass[k].framebuffer);
    }
    for (int i = 1; i < set->textures; ++i) glDeleteTextures(1, &set->texture[i].name);     /* 0: the stage's depth */
    kit_image_free(&set->whole);
    set->peers = set->textures = 0;
    glActiveTexture(GL_TEXTURE0);
    glUseProgram(0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

/* Makes the textures that peers read: depth, normals as three.js writes them, a white picture, raw normals. */
static int peers_inputs(peer_set *set, const stage *s, kit_error *err)
{
    static const char *const names[3] = { "N.X", "N.Y", "N.Z" };
    static const float background[3] = { 0.184f, 0.184f, 1 };
    const kit_image *frame = &set->whole;
    const int width = frame->width, height = frame->height;
    const size_t stride = (size_t)width, pixels = stride * (size_t)height;
    const float *z = kit_image_channel(frame, "Z");
    float *texel = malloc(4 * pixels * sizeof *texel);
    if (!texel) return kit_fail(err, "out of memory");
    set->texture[set->textures++] = (peer_texture){ s->gbuffer.depth, width, height };
    for (; set->textures < 4; ++set->textures) {
        const int halved = set->textures == 1, white = set->textures == 2;
        for (size_t i = 0; i < 4 * pixels; ++i) {
            const size_t c = i % 4, to = i / 4, from = pixels - (to / stride + 1) * stride + to % stride;
            const float n = c < 3 && z[from] > 0 ? kit_image_channel(frame, names[c])[from] : 0;
            texel[i] = white ? 1 : !halved ? n : c == 3 ? 1 : z[from] > 0 ? n / 2 + 0.5f : background[c];
        }
        set->texture[set->textures] = (peer_texture){ kit_texture(width, height, GL_RGBA16F, texel), width, height };
    }
    glBindTexture(GL_TEXTURE_2D, set->texture[3].name);
    kit_texture_linear(GL_TEXTURE_2D);
    free(texel);
    return 0;
}

int peers_measure(row *rows, stage *s, int rounds, int most, kit_image *pictures, kit_error *err)
{
    static peer_set set;
    char what[128], command[96];
    memset(&set, 0, sizeof set);
    snprintf(set.folder, sizeof set.folder, PEERS "out-%ld", (long)getpid());
    int failed = peers_write(&set, s, most < MOST_PEERS, err), count;
    if (failed <= 0) return failed;
    snprintf(what, sizeof what, "%s: peers", s->name);
    kit_progress(what, 0);
    failed = kit_gbuffer_read(&set.whole, &s->gbuffer, err) || peers_inputs(&set, s, err) || peers_read(&set, err);
    snprintf(command, sizeof command, "rm -r %s", set.folder);       /* the script's files have been read */
    if (system(command)) fprintf(stderr, "report: note: %s: cannot be removed\n", set.folder);
    count = set.peers < most ? set.peers : most;
    for (int i = 0; i < count && !failed; ++i) {
        kit_image picture;
        histogram h;
        row *r = &rows[i];
        *r = row_blank(0, s->name, set.peer[i].label, set.peer[i].label, set.peer[i].settings);
        r->bytes = 0;                          /* how many bytes a peer moves is not counted */
        peer_draw(&set, i);
        failed = peer_picture(&picture, &set, &set.peer[i], s, err);
        if (failed) break;
        histogram_of(&h, &picture, s);         /* before the picture's values are clamped */
        for (size_t k = 0; k < (size_t)picture.width * (size_t)picture.height; ++k)
            picture.data[k] = fminf(fmaxf(picture.data[k], 0), 1);
        failed = score_picture(r, s, &picture, err);
        fit_row(r, &h);
        if (pictures) pictures[i] = picture;
        else kit_image_free(&picture);
        kit_progress(what, (i + 1.0) / (count + 1.0));
    }
    kit_progress(what, 1);
    failed = failed || (rounds && clock_all(rows, s, peer_draw, &set, count, rounds, err));
    peers_free(&set);
    return failed ? -1 : count;
}
