/* test_cost.c - make cost: counts of instructions, shares of waves, and the model, against figures worked out by
   hand. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "lab/cost/model.h"
#include "lab/cost/share.h"
#include "t.h"

/* ---- >>walks ----------------------------------------------------------------------------------------------------- */

/* Assembly of an `if` whose condition is the same for all lanes. */
#define SIDES "\ts_cmp_eq_i32 s5, 0\n\ts_cbranch_scc1 BB3\n" \
              "BB2:\n\tv_mov_b32_e32 v0, 0\n\ts_branch BB4\n" \
              "BB3:\n\tv_mov_b32_e32 v0, 1\n\tv_rsq_f32_e32 v0, v1\n" \
              "BB4:\n"
/* Assembly of a loop whose bound is read from memory, so that its number of turns is unknown. */
#define ENDLESS "BB0:\n\ts_mov_b32 s0, 0\n\ts_buffer_load_dword s1, s[4:7], 0x68\n" \
                "BB3:\n\ts_cmp_ge_i32 s0, s1\n\ts_cbranch_scc1 BB9\n" \
                "BB4:\n\tv_mul_f32_e32 v0, v0, v0\n\ts_add_u32 s0, s0, 1\n\ts_branch BB3\n" \
                "BB9:\n\ts_endpgm\n"

#define NO_BODY { { 0, 0, 0 }, { 0, 0, 0 } }
typedef struct expected { double vector, transcendental, fetches; } expected;
/* turns: assumed for a loop without a known end; endless: the loop's block, from 1 on; 0: there is none. */
static const struct {
    const char *sentence, *text;
    expected busy, calm, body[2];
    int bodies, turns, endless, unknown;
} walks[] = {
    /* 3 turns of 2, each with an `if` of lanes: 1 + 6 * 4 vector instructions, or 1 + 6 * 2 if no lane enters */
    { "loops of constant count are counted as often as they run, an `if` in them busy and calm",
      "BB0:\n\ts_mov_b32 s0, 0 ; be800380\n\tv_mov_b32_e32 v0, 0\n"
      "BB1:\n\ts_cmp_ge_i32 s0, 3\n\ts_cbranch_scc1 BB6\n"
      "BB2:\n\ts_movk_i32 s1, 0x0\n"
      "BB3:\n\ts_cmp_lt_i32 s1, 2\n\ts_cbranch_scc0 BB5\n"
      "BB4:\n\tv_add_f32_e32 v0, 1.0, v0\n"
      "\timage_load v[2:5], v[0:1], s[8:15] dmask:0xf dim:SQ_RSRC_IMG_2D unorm\n"
      "\tv_cmp_lt_f32_e32 vcc, 0, v2\n\ts_and_saveexec_b64 s[2:3], vcc\n"
      "\ts_cbranch_execz BB7\n"
      "BB8:\n\tv_rcp_f32_e32 v1, v2\n\tv_mul_f32_e32 v0, v0, v1\n"
      "BB7:\n\ts_mov_b64 exec, s[2:3]\n\ts_add_u32 s1, s1, 1\n\ts_branch BB3\n"
      "BB5:\n\ts_addk_i32 s0, 0x1\n\ts_branch BB1\n"
      "BB6:\n\texp mrt0 v0, v0, v0, v0 done vm\n\ts_endpgm\n",
      { 25, 6, 6 }, { 13, 0, 6 }, { { 12, 6, 0 }, { 0, 0, 0 } }, 1, 1, 0, 0 },
    /* four turns, which lanes leave one by one; the counter ends the loop, beside the mask of the lanes left */
    { "a loop that lanes leave ends by its counter",
      "BB0:\n\ts_mov_b64 s[0:1], exec\n\ts_mov_b32 s8, 0\n"
      "BB1:\n\tv_cmp_gt_f32_e32 vcc, 1.0, v1\n\ts_cmp_lt_i32 s8, 4\n"
      "\ts_cselect_b64 s[10:11], -1, 0\n\ts_and_b64 s[10:11], s[10:11], vcc\n"
      "\ts_and_saveexec_b64 s[10:11], s[10:11]\n"
      "BB4:\n\ts_andn2_b64 exec, s[10:11], exec\n"
      "BB5:\n\ts_andn2_b64 s[10:11], s[10:11], exec\n\ts_cbranch_scc0 BB10\n"
      "BB9:\n\ts_mov_b64 exec, s[10:11]\n\ts_add_u32 s8, s8, 1\n\tv_exp_f32_e32 v3, v4\n"
      "\ts_branch BB1\n"
      "BB10:\n\ts_mov_b64 exec, s[0:1]\n\tv_log_f32_e64 v0, -v0\n\ts_endpgm\n",
      { 5 + 4 + 1, 4 + 1, 0 }, { 5 + 4 + 1, 4 + 1, 0 }, NO_BODY, 0, 1, 0, 0 },
    { "a loop of none or three turns, as a lane chooses, has three busy, none calm",
      "BB0:\n\tv_cndmask_b32_e64 v4, 3, 0, vcc\n\ts_mov_b64 s[8:9], exec\n\ts_mov_b32 s30, 0\n"
      "BB1:\n\ts_mov_b64 s[10:11], exec\n\tv_cmpx_ge_i32_e32 s30, v4\n"
      "BB2:\n\ts_andn2_b64 s[10:11], s[10:11], exec\n\ts_cbranch_scc0 BB4\n"
      "BB3:\n\ts_mov_b64 exec, s[10:11]\n\tv_sin_f32_e32 v1, v1\n\ts_add_u32 s30, s30, 1\n"
      "\ts_branch BB1\n"
      "BB4:\n\ts_mov_b64 exec, s[8:9]\n\ts_endpgm\n",
      { 1 + 4 + 3, 3, 0 }, { 1 + 1, 0, 0 }, NO_BODY, 0, 1, 0, 0 },
    { "of an unknown condition that lanes share the dearer side counts",
      "BB0:\n" SIDES "\ts_endpgm\n", { 2, 1, 0 }, { 2, 1, 0 }, NO_BODY, 0, 1, 0, 1 },
    { "and calm, inside a loop, the cheaper one",
      "BB0:\n\ts_mov_b32 s0, 0\nBB1:\n" SIDES "\ts_add_u32 s0, s0, 1\n\ts_cmp_lg_u32 s0, 7\n"
      "\ts_cbranch_scc1 BB1\nBB5:\n\ts_endpgm\n", { 14, 7, 0 }, { 7, 0, 0 }, NO_BODY, 0, 1, 0, 1 },
    { "a loop without a known end is named, and counted as told: never", ENDLESS, { 0, 0, 0 }, { 0, 0, 0 },
      NO_BODY, 0, 0, 4, 0 },
    { "or three times", ENDLESS, { 3, 0, 0 }, { 3, 0, 0 }, NO_BODY, 0, 3, 4, 0 },
    /* four turns, each with an `if` and an else, which a wave may enter in part or not at all, and another `if` inside;
       the else's instruction counts in any case, as the remaining lanes execute it */
    { "each body that a wave may leave out is counted by itself, an else in any case",
      "BB0:\n\ts_mov_b32 s0, 0\n"
      "BB1:\n\tv_cmp_lt_f32_e32 vcc, 0, v2\n\ts_and_saveexec_b64 s[2:3], vcc\n"
      "\ts_cbranch_execz BB3\n"
      "BB2:\n\tv_rcp_f32_e32 v1, v2\n\tv_mul_f32_e32 v0, v0, v1\n"
      "BB3:\n\ts_andn2_b64 exec, s[2:3], exec\n\ts_cbranch_execz BB5\n"
      "BB4:\n\tv_mov_b32_e32 v0, 0\n"
      "BB5:\n\ts_mov_b64 exec, s[2:3]\n\tv_cmp_lt_f32_e32 vcc, 0, v3\n"
      "\ts_and_saveexec_b64 s[4:5], vcc\n\ts_cbranch_execz BB8\n"
      "BB6:\n\tv_add_f32_e32 v0, v0, v1\n\tv_cmp_lt_f32_e32 vcc, 0, v4\n"
      "\ts_and_saveexec_b64 s[6:7], vcc\n\ts_cbranch_execz BB8\n"
      "BB7:\n\timage_load v[2:3], v[0:1], s[8:15] dmask:0x3 dim:SQ_RSRC_IMG_2D unorm\n"
      "BB8:\n\ts_mov_b64 exec, s[4:5]\n\ts_add_u32 s0, s0, 1\n\ts_cmp_lg_u32 s0, 4\n"
      "\ts_cbranch_scc1 BB1\nBB9:\n\ts_endpgm\n",
      { 4 * (2 + 2 + 1 + 2), 4, 4 }, { 4 * (2 + 1), 0, 0 }, { { 4 * 2, 4, 0 }, { 4 * 2, 0, 4 } }, 2, 1, 0, 0 }
};
static size_t walked;

static void expect(const char *what, const counts *c, const expected *e)
{
    CHECK(c->vector == e->vector && c->transcendental == e->transcendental && c->fetches == e->fetches,
          "%s: %g vector (%g), %g transcendental (%g), %g fetches (%g)", what, c->vector, e->vector,
          c->transcendental, e->transcendental, c->fetches, e->fetches);
}

static void walk(void)
{
    const int turns[2] = { walks[walked].turns, walks[walked].turns }, endless = walks[walked].endless;
    const char *bad = "";
    counted c;
    CHECK(!count_instructions(&c, walks[walked].text, turns, &bad), "not understood: %.60s", bad);
    expect("busy", &c.busy, &walks[walked].busy);
    expect("calm", &c.calm, &walks[walked].calm);
    CHECK(c.bodies == walks[walked].bodies && c.report.unknown == walks[walked].unknown, "%d bodies, %d unknown",
          c.bodies, c.report.unknown);
    for (int i = 0; i < walks[walked].bodies; ++i) expect("a body", &c.body[i], &walks[walked].body[i]);
    CHECK(c.report.loops == (endless > 0) && (!endless || c.report.endless[0] == endless - 1),
          "%d loops without an end, BB%d", c.report.loops, c.report.endless[0]);
    CHECK(walked || c.busy.wide_fetches == 6, "four channels are more than 8 bytes");
}

/* ---- >>shares ---------------------------------------------------------------------------------------------------- */

/* Checks shares of waves on five by three texels, each with the bits of two sides, "." without a surface. Tiles of 2x2
   are six waves, and the last one shows no surface; the others enter 2 2 0 1 2 times of two. */
static void waves_of_tiles(void)
{
    static const char picture[] = "10020" "20100" "1.03.";
    static const struct { tile tile; double share; } cases[] = {
        { { "2x2", 2, 2 }, (2 + 2 + 0 + 1 + 2) / 10.0 },
        { { "4x1", 4, 1 }, (2 + 0 + 2 + 0 + 2) / 10.0 },
        { { "1x1", 1, 1 }, (1 + 1 + 1 + 1 + 1 + 2) / 26.0 },
        { { "8x8", 8, 8 }, 1 }
    };
    told texel[15];
    for (int i = 0; i < 15; ++i) {
        texel[i] = (told) { { (float)((picture[i] - '0') & 1), (float)((picture[i] - '0') >> 1) } };
        if (picture[i] == '.') texel[i] = (told) { { 0, -1 } };
    }
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const double share = share_of(texel, 5, 3, &cases[i].tile, 2);
        CHECK(fabs(share - cases[i].share) < 1e-9, "%s: %g of %g", cases[i].tile.name, share, cases[i].share);
    }
}

/* Checks that bodies count by their own shares; or all that may be skipped counts by one share; or all counts. */
static void weighed_by_hand(void)
{
    static const double shares[] = { 0.5, 0.25 };
    static const struct { int bodies, shares; double vector; int failed; } cases[] = {
        { 2, 2, 100 + 0.5 * 40 + 0.25 * 8, 0 },
        { 1, 1, 100 + 0.5 * 40, 0 },
        { 0, 1, 100 + 0.5 * 60, 0 },
        { 3, 1, 100 + 0.5 * 60, 0 },
        { 4, 2, 100 + 0.5 * 40 + 0.25 * 8 + 0.5 * 4 + 0.25 * 2, 0 },
        { 2, 0, 160, 0 },
        { 1, 2, 160, -1 }
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const counted of = { .busy = { .vector = 160 }, .calm = { .vector = 100 }, .bodies = cases[i].bodies,
                             .body = { { .vector = 40 }, { .vector = 8 }, { .vector = 4 }, { .vector = 2 } } };
        counts c;
        const int failed = weigh(&c, &of, shares, cases[i].shares);
        CHECK(failed == cases[i].failed && fabs(c.vector - cases[i].vector) < 1e-9, "case %zu: %g, not %g", i, c.vector,
              cases[i].vector);
    }
}

/* Checks that the row most alike is found: by resolution, then samples; a turning camera's, not a standing one's. */
static void shares_recorded(void)
{
    static char *cells[] = { "body", "camera", "half", "steps", "tile", "share",
                             "cover", "", "1", "10", "8x8", ".1",  "cover", "", "1", "6", "8x8", ".2",
                             "cover", "", "0", "10", "8x8", ".3",  "cover", "", "1", "10", "16x4", ".4",
                             "unsettled", "stands", "1", "12", "8x8", ".5",
                             "unsettled", "turns", "1", "12", "8x8", ".6" };
    static const struct { int body, half, steps, tile; double share; } cases[] = {
        { COVER, 1, 10, SQUARE, .1 }, { COVER, 2, 12, SQUARE, .1 }, { COVER, 1, 6, SQUARE, .2 },
        { COVER, 0, 6, SQUARE, .3 }, { COVER, 1, 6, FLAT, .4 }, { UNSETTLED, 2, 12, SQUARE, .6 }
    };
    const csv shares = { NULL, cells, 6, 6 };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const ssgi_gl_desc d = { .gather.resolution = cases[i].half, .gather.samples = cases[i].steps };
        const double share = share_recorded(&shares, cases[i].body, &d, &tiles[cases[i].tile]);
        CHECK(share == cases[i].share, "case %zu: %g, not %g", i, share, cases[i].share);
    }
    CHECK(isnan(share_recorded(&shares, SECOND, &(ssgi_gl_desc) { 0 }, &tiles[SQUARE])), "a share of no record");
    const csv recorded = csv_read("examples/lab/cost", "shares.csv");
    for (int i = 0; i < BODIES; ++i)
        for (int t = 0; t < TILES; ++t) {
            const double share = share_recorded(&recorded, i, &(ssgi_gl_desc) { 0 }, &tiles[t]);
            CHECK(share > 0 && share < 1, "shares.csv, %s, %s: %g", bodies[i].name, tiles[t].name, share);
        }
}

/* Checks that shaders have share.c's lines: without its line all of a body would count, so both must change. */
static void texts_have_bodies(void)
{
    static const struct { ssgi_gl_desc desc; int count, body[4];
    } cases[] = { { { .pass = SSGI_GL_PASS_HSAO }, 1, { COVER } },
                  { { .pass = SSGI_GL_PASS_HSAO, .gather.thickness = SSGI_GL_THICKNESS_SOLID }, 1, { COVER_SOLID } },
                  { { .pass = SSGI_GL_PASS_HSAO, .gather.thickness = SSGI_GL_THICKNESS_SLABS }, 2, { COVER, SECOND } },
                  { { .pass = SSGI_GL_PASS_SSDO,
                      .light.bounce = SSGI_GL_BOUNCE_SOLID_ANGLE,
                      .gather.thickness = SSGI_GL_THICKNESS_SLABS },
                    3,
                    { COVER, SECOND, SENT } },
                  { { .pass = SSGI_GL_PASS_S3HO, .light.transfer = SSGI_GL_TRANSFER_BOTH,
                    .light.packed_coefficients = 1 },
                    2,
                    { COVER, SENT } },
                  { { .pass = SSGI_GL_PASS_HISTORY }, 1, { UNSETTLED } },
                  { { .pass = SSGI_GL_PASS_CHANGE_MASK }, 1, { CHANGED } },
                  { { .pass = SSGI_GL_PASS_BLUR }, 0, { 0 } } };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        char *text = text_of(&cases[i].desc, SSGI_GL_STAGE_FRAGMENT);
        int of[BODIES];
        if (!text) return;
        const int count = bodies_of(of, text);
        CHECK(count == cases[i].count && !memcmp(of, cases[i].body, (size_t)count * sizeof *of),
              "%s, case %zu: %d bodies, the first %s", ssgi_gl_pass_name(cases[i].desc.pass), i, count,
              count ? bodies[of[0]].name : "none");
        free(text);
    }
}

/* Checks the model by a device of a million cycles a millisecond, 128 lanes and 100 instructions for 1.28 million
   pixels. */
static void model_by_hand(void)
{
    static const struct { load load; int apart; bound bound; double ms; } cases[] = {
        { { 1.28e6, 100, 0, 0, 0, 0, 10 }, 1, ALU, 1.0 },
        { { 1.28e6, 100, 20, 0, 0, 0, 10 }, 1, ALU, 1.0 },          /* 20 transcendental ones take 80, beside others */
        { { 1.28e6, 100, 30, 0, 0, 0, 10 }, 1, ALU, 1.2 },
        { { 1.28e6, 100, 30, 0, 0, 0, 10 }, 0, ALU, 1.9 },          /* 70 + 4 * 30 */
        { { 1.28e6, 0, 0, 64, 0, 0, 1000 }, 1, TEX, 2.56 },         /* 64 fetches; 2 units fetch 16 a cycle each */
        { { 1.28e6, 0, 0, 64, 16, 0, 1000 }, 1, TEX, 3.2 },         /* 64 fetches, 16 of which count twice */
        { { 1.28e6, 100, 0, 10, 0, 0, 10 }, 1, HIDE, 1.7 },         /* 5000 waves a SIMD, 200 + 3200 cycles each */
        { { 256, 100, 0, 10, 0, 0, 10 }, 1, HIDE, 0.0034 },         /* one wave a SIMD: nothing hides its waits */
        { { 1.28e6, 100, 0, 0, 0, 2e8, 10 }, 1, MEMORY, 2.0 }
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const device d = { "", "", 2, 2, 32, 1.0, 100, 16, 8, cases[i].apart };
        bound which;
        const double ms = model(&d, &cases[i].load, &which);
        CHECK(fabs(ms - cases[i].ms) < 1e-9 && which == cases[i].bound, "case %zu: %g ms by %s, %g by %s", i, ms,
              bound_names[which], cases[i].ms, bound_names[cases[i].bound]);
    }
}

/* Checks modelled over published times: the ratios are 1/2, 2 and 8. */
static void published_by_hand(void)
{
    static const double modelled[] = { 1, 6, 4 }, published[] = { 2, 3, 0.5 };
    const trust t = trust_of(modelled, published, 3);
    CHECK(fabs(t.mean - 2) < 1e-9 && t.least == 0.5 && t.most == 8, "%g, from %g to %g", t.mean, t.least, t.most);
}

/* Checks csv_put: cells with commas and quotes; columns by keys, without empty ones; a selection of rows. */
static void tables_put(void)
{
    static const char text[] = "a,b,c,d\n1,\"x, \"\"y\"\"\",,\n22.5,z,,p\n";
    static const struct { const char *keys, *empty; int aligned; const char *put; } cases[] = {
        { "b,a", NULL, 0, "b,a\n\"x, \"\"y\"\"\",1\nz,22.5\n" },
        { "a,c,none,b", NULL, 0, "a,c,b\n1,,\"x, \"\"y\"\"\"\n22.5,,z\n" },
        { "a,b,c", "d", 1, "   a  b\n   1  x, \"y\"\n" }
    };
    const csv c = csv_of(strdup(text), "text");
    CHECK(c.rows == 2 && c.columns == 4 && csv_number(&c, 1, "a") == 22.5 && isnan(csv_number(&c, 0, "c")),
          "%d rows of %d columns", c.rows, c.columns);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        char out[128] = "";
        FILE *f = fmemopen(out, sizeof out, "w");
        csv_put(f, &c, cases[i].keys, cases[i].empty, cases[i].aligned);
        fclose(f);
        CHECK(!strcmp(out, cases[i].put), "%s: %s", cases[i].keys, out);
    }
}

void test_cost(void)
{
    for (walked = 0; walked < sizeof walks / sizeof *walks; ++walked) RUN(walks[walked].sentence, walk);
    RUN("waves enter where one of their lanes does, of those that show something", waves_of_tiles);
    RUN("bodies are weighed by their own shares, or all by one", weighed_by_hand);
    RUN("a share is of the gather that is most alike; of each body one is recorded", shares_recorded);
    RUN("texts have the lines that shares are told at", texts_have_bodies);
    RUN("milliseconds are those of the slowest of four", model_by_hand);
    RUN("the model is compared with published times by ratios and their geometric mean", published_by_hand);
    RUN("a table is put by its keys, as csv and to be read", tables_put);
}
