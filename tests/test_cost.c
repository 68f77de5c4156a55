/* test_cost.c - make cost: how often instructions are counted, and the model, by figures worked out by hand. */
#include <math.h>
#include <string.h>
#include "lab/cost/count.h"
#include "lab/cost/model.h"
#include "t.h"

static counts count(const char *text, way how, int turns, walk_report *report)
{
    counts c;
    const char *bad = "";
    CHECK(!count_instructions(&c, report, text, how, turns, &bad), "not understood: %.60s", bad);
    return c;
}

/* vector, transcendental, fetches */
static void expect(const char *text, way how, double vector, double transcendental, double fetches)
{
    walk_report report;
    const counts c = count(text, how, 1, &report);
    CHECK(c.vector == vector && c.transcendental == transcendental && c.fetches == fetches && !report.loops,
          "%s: %g vector (%g), %g transcendental (%g), %g fetches (%g), %d loops without an end",
          how == BUSY ? "busy" : "calm", c.vector, vector, c.transcendental, transcendental, c.fetches, fetches,
          report.loops);
}

/* Three turns of two, in each an `if` of lanes: 1 + 6 * 4 vector instructions, 1 + 6 * 2 where no lane enters. */
static void nested_loops(void)
{
    static const char text[] = "BB0:\n\ts_mov_b32 s0, 0 ; be800380\n\tv_mov_b32_e32 v0, 0\n"
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
                               "BB6:\n\texp mrt0 v0, v0, v0, v0 done vm\n\ts_endpgm\n";
    walk_report report;
    expect(text, BUSY, 25, 6, 6);
    expect(text, CALM, 13, 0, 6);
    CHECK(count(text, BUSY, 1, &report).wide_fetches == 6, "four channels are more than 8 bytes");
}

/* A loop of four turns that lanes leave one by one: the mask of those that are left, and the counter, end it. */
static void loop_with_breaks(void)
{
    static const char text[] = "BB0:\n\ts_mov_b64 s[0:1], exec\n\ts_mov_b32 s8, 0\n"
                               "BB1:\n\tv_cmp_gt_f32_e32 vcc, 1.0, v1\n\ts_cmp_lt_i32 s8, 4\n"
                               "\ts_cselect_b64 s[10:11], -1, 0\n\ts_and_b64 s[10:11], s[10:11], vcc\n"
                               "\ts_and_saveexec_b64 s[10:11], s[10:11]\n"
                               "BB4:\n\ts_andn2_b64 exec, s[10:11], exec\n"
                               "BB5:\n\ts_andn2_b64 s[10:11], s[10:11], exec\n\ts_cbranch_scc0 BB10\n"
                               "BB9:\n\ts_mov_b64 exec, s[10:11]\n\ts_add_u32 s8, s8, 1\n\tv_exp_f32_e32 v3, v4\n"
                               "\ts_branch BB1\n"
                               "BB10:\n\ts_mov_b64 exec, s[0:1]\n\tv_log_f32_e64 v0, -v0\n\ts_endpgm\n";
    expect(text, BUSY, 5 + 4 + 1, 4 + 1, 0);
    expect(text, CALM, 5 + 4 + 1, 4 + 1, 0);
}

/* A loop of none or three turns, as a lane chooses. */
static void chosen_turns(void)
{
    static const char text[] = "BB0:\n\tv_cndmask_b32_e64 v4, 3, 0, vcc\n\ts_mov_b64 s[8:9], exec\n\ts_mov_b32 s30, 0\n"
                               "BB1:\n\ts_mov_b64 s[10:11], exec\n\tv_cmpx_ge_i32_e32 s30, v4\n"
                               "BB2:\n\ts_andn2_b64 s[10:11], s[10:11], exec\n\ts_cbranch_scc0 BB4\n"
                               "BB3:\n\ts_mov_b64 exec, s[10:11]\n\tv_sin_f32_e32 v1, v1\n\ts_add_u32 s30, s30, 1\n"
                               "\ts_branch BB1\n"
                               "BB4:\n\ts_mov_b64 exec, s[8:9]\n\ts_endpgm\n";
    expect(text, BUSY, 1 + 4 + 3, 3, 0);
    expect(text, CALM, 1 + 1, 0, 0);
}

/* Of an `if` whose condition all lanes share one side is executed: the dearer one; calm, inside a loop, the cheaper. */
static void shared_conditions(void)
{
    static const char sides[] = "\ts_cmp_eq_i32 s5, 0\n\ts_cbranch_scc1 BB3\n"
                                "BB2:\n\tv_mov_b32_e32 v0, 0\n\ts_branch BB4\n"
                                "BB3:\n\tv_mov_b32_e32 v0, 1\n\tv_rsq_f32_e32 v0, v1\n"
                                "BB4:\n";
    char text[1024];
    walk_report report;
    snprintf(text, sizeof text, "BB0:\n%s\ts_endpgm\n", sides);
    expect(text, BUSY, 2, 1, 0);
    expect(text, CALM, 2, 1, 0);
    CHECK(count(text, BUSY, 1, &report).vector > 0 && report.unknown == 1, "%d unknown", report.unknown);
    snprintf(text, sizeof text, "BB0:\n\ts_mov_b32 s0, 0\nBB1:\n%s\ts_add_u32 s0, s0, 1\n\ts_cmp_lg_u32 s0, 7\n"
             "\ts_cbranch_scc1 BB1\nBB5:\n\ts_endpgm\n", sides);
    expect(text, BUSY, 14, 7, 0);
    expect(text, CALM, 7, 0, 0);
}

/* Nothing tells how many turns a loop has whose bound is read from memory: it is named, and counted as told. */
static void unknown_end(void)
{
    static const char text[] = "BB0:\n\ts_mov_b32 s0, 0\n\ts_buffer_load_dword s1, s[4:7], 0x68\n"
                               "BB3:\n\ts_cmp_ge_i32 s0, s1\n\ts_cbranch_scc1 BB9\n"
                               "BB4:\n\tv_mul_f32_e32 v0, v0, v0\n\ts_add_u32 s0, s0, 1\n\ts_branch BB3\n"
                               "BB9:\n\ts_endpgm\n";
    walk_report report;
    for (int turns = 0; turns < 4; ++turns) {
        const counts c = count(text, BUSY, turns, &report);
        CHECK(c.vector == turns, "%g turns of %d", c.vector, turns);
        CHECK(report.loops == 1 && report.endless[0] == 3, "%d loops, BB%d", report.loops, report.endless[0]);
    }
}

/* A millisecond of this device has a million cycles, its 128 lanes 100 instructions each of 1.28 million pixels. */
static void model_by_hand(void)
{
    static const struct { load load; int apart; bound bound; double ms; } cases[] = {
        { { 1.28e6, 100, 0, 0, 0, 0, 10 }, 1, ALU, 1.0 },
        { { 1.28e6, 100, 20, 0, 0, 0, 10 }, 1, ALU, 1.0 },          /* 80 quarters, beside the others */
        { { 1.28e6, 100, 30, 0, 0, 0, 10 }, 1, ALU, 1.2 },
        { { 1.28e6, 100, 30, 0, 0, 0, 10 }, 0, ALU, 1.9 },          /* 70 + 4 * 30 */
        { { 1.28e6, 0, 0, 64, 0, 0, 1000 }, 1, TEX, 2.56 },         /* 2 units of 16 a cycle */
        { { 1.28e6, 0, 0, 64, 16, 0, 1000 }, 1, TEX, 3.2 },         /* 48 and 16, which count twice */
        { { 1.28e6, 100, 0, 10, 0, 0, 10 }, 1, HIDE, 1.7 },         /* 5000 waves a SIMD, each 200 + 3200 cycles */
        { { 256, 100, 0, 10, 0, 0, 10 }, 1, HIDE, 0.0034 },         /* a wave a SIMD: none to take its place */
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

void test_cost(void)
{
    RUN("loops of constant count are counted as often as they run, an `if` in them busy and calm", nested_loops);
    RUN("a loop that lanes leave ends by its counter", loop_with_breaks);
    RUN("a loop of none or three turns has three busy, none calm", chosen_turns);
    RUN("of an unknown condition that lanes share one side counts", shared_conditions);
    RUN("a loop without a known end is named, and counted as told", unknown_end);
    RUN("milliseconds are those of the slowest of four", model_by_hand);
}
