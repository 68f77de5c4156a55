/* viewer.c - a window onto a scene: methods live, beside another or beside the ground truth, with their error and
   times.

     build/viewer                               build/viewer model.glb --method hsao --right truth
     build/viewer model.obj --method s3ho-best  keys: h; options: --help

   To put ssgi into a program of your own, copy a page of examples/hosts, not this: frames are drawn by the kit here, as
   in build/render. arguments.c: the command line; keys.c, input.c: keys, mouse, drops; load.c: scenes and light;
   settings.c: methods; draw.c: a frame; motion.c: motion of the sliding object; pace.c: the frame's size; panel.c:
   text; command.c, pictures.c: output; truth.c: ray tracing beside the drawing. */
#include "viewer.h"
#include <GLFW/glfw3.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- >>begin: what the command line asks for ------------------------------------------------------------------- */

static int open_methods(viewer *v, const asked *to)
{
    kit_method m;
    side *right = &v->side[1];
    for (int i = 0; i < to->sets; ++i)
        for (const char *at = to->set[i]; *at; at += at[strcspn(at, ",")] ? strcspn(at, ",") + 1 : strlen(at)) {
            char text[256];
            snprintf(text, sizeof text, "%.*s", (int)strcspn(at, ","), at);
            if (wish(v, text)) return -1;
        }
    if (kit_method_find(&m, to->method ? to->method : "ssdo", &v->err) || method_choose(v, &v->side[0], m.number, 1))
        return -1;
    method_choose(v, right, m.number, 0);
    if (!to->right) return 0;
    v->split_on = v->error = 1;
    if (strcmp(to->right, "truth") && kit_method_find(&m, to->right, &v->err)) return -1;
    method_choose(v, right, m.number, 0);
    right->truth = !strcmp(to->right, "truth");
    return 0;
}

/* Sets the scene's camera, with the options that replace parts of it. */
static int open_camera(viewer *v, const asked *to)
{
    kit_camera *c = &v->camera;
    double away[3], length = 0, up = 0, along = 0;
    for (int i = 0; i < 3 && to->camera; ++i) {
        c->eye[i] = (float)(to->place[i] - v->scene.mesh.origin[i]);
        c->target[i] = (float)(to->place[3 + i] - v->scene.mesh.origin[i]);
    }
    for (int i = 0; i < 3 && to->up; ++i) c->up[i] = (float)to->upward[i];
    if (to->fovy > 0) {
        c->fovy = (float)to->fovy;
        c->ortho_height = 0;
    }
    if (to->ortho_height > 0) {
        c->fovy = 0;
        c->ortho_height = (float)to->ortho_height;
    }
    for (int i = 0; i < 3; ++i) {
        away[i] = (double)c->eye[i] - (double)c->target[i];
        length += away[i] * away[i];
        up += (double)c->up[i] * (double)c->up[i];
        along += away[i] * (double)c->up[i];
    }
    if (!(length > 0)) return kit_fail(&v->err, "--camera: eye and target must differ");
    if (!(up > 0) || along * along > 0.999999 * length * up)
        return kit_fail(&v->err, "--up: must not be zero or along the view direction");
    v->home = *c;
    return 0;
}

static int open_all(viewer *v, const asked *to)
{
    kit_lighting *l = &v->light.now;
    v->light.asked = to->env || to->lights;
    if (open_methods(v, to) || scene_open(v, to->scene)) return -1;
    if (*v->scene.note) fprintf(stderr, "viewer: note: %s: %s\n", to->scene, v->scene.note);
    if (open_camera(v, to)) return -1;
    for (; l->lights < to->lights; ++l->lights)
        if (kit_light_parse(&l->light[l->lights], to->light[l->lights], v->scene.mesh.origin, &v->err)) return -1;
    if (to->env && env_open(v, to->env)) return -1;
    for (int i = 0; i < 3; ++i) v->slid[i] = (float)to->slide[i];
    return kit_scene_slide(&v->scene, v->slid, 1, &v->err);
}

/* ---- >>run ------------------------------------------------------------------------------------------------------- */

/* Returns whether the frame for --shot was drawn; shot_now also waits for rays of a shown ground truth. */
static int shot_drawn(const viewer *v) { return v->shot && v->frame >= (unsigned)(v->frames ? v->frames : 1); }

static int shot_now(const viewer *v) { return shot_drawn(v) && (!v->error || v->shown.rounds); }

static int take_shot(viewer *v)
{
    if (v->error) {
        v->scored = 0;
        draw_window(v);
        printf("RMSE %.5f\n", v->side[0].error);
    }
    if (v->panel || v->help) panel_draw(v);
    return window_save(v, v->shot);
}

/* Returns whether the next image of the window would differ from the last. */
static int to_show(viewer *v)
{
    const int says = panel_says(v), traced = v->error || (v->split_on && v->side[1].truth);
    if (!says && v->noted > 0) {
        v->noted = 0;
        return 1;
    }
    return v->redraw || traced;
}

/* Draws a frame if it is due, and the window if it would change. */
static int turn(viewer *v)
{
    const double now = kit_seconds();
    const int moves = v->circles || v->slides || v->orbit != 0;
    const int waits = v->shot ? shot_drawn(v) : draw_settled(v) && !moves && !v->redraw;
    if (waits) glfwWaitEventsTimeout(0.05);
    else glfwPollEvents();
    if (!shot_drawn(v)) input_move(v, fmin(now - v->last, 0.25));
    v->last = now;
    const int draws = v->shot ? !shot_drawn(v) : !draw_settled(v);
    if (draws && draw_frame(v)) return -1;
    if (v->asks) command_print(v);
    v->asks = 0;
    if (!v->shot) window_title(v);
    if (!draws && !to_show(v)) return 0;
    v->redraw = 0;
    draw_window(v);
    if (shot_now(v)) return 0;
    panel_draw(v);
    glfwSwapBuffers(v->window);
    return 0;
}

static int run(viewer *v) /* runs until the window is closed or --shot is taken */
{
    v->truth.scene = &v->scene;
    v->truth.lighting = &v->light.now;
    pace_begin(&v->pace, v->size, kit_gl_is_software());
    v->last = kit_seconds();
    while (!glfwWindowShouldClose(v->window) && !shot_now(v))
        if (turn(v)) return -1;
    if (v->shot && take_shot(v)) return -1;
    if (v->command) command_print(v);
    return 0;
}

int main(int argc, char **argv)
{
    static viewer v = { .size = { 1280, 720 }, .split = 0.5f, .colours = 1 };
    asked to;
    char cores[32];
    kit_streams_open();
    pthread_mutex_init(&v.truth.lock, NULL);
    pthread_cond_init(&v.truth.wake, NULL);
    for (int i = 0; i < 2; ++i) v.side[i].error = (double)NAN;
    snprintf(cores, sizeof cores, "%ld", sysconf(_SC_NPROCESSORS_ONLN) > 1 ? sysconf(_SC_NPROCESSORS_ONLN) - 1 : 1);
    setenv("KIT_THREADS", cores, 0); /* one core stays free for drawing */
    const int helped = viewer_help(argc, argv);
    int failed = !helped && arguments(&v, &to, argc, argv);
    if (!failed && !helped) {
        failed = open_all(&v, &to) || window_open(&v) || draw_open(&v);
        if (!failed) input_open(&v);
        failed = failed || run(&v);
    }
    truth_stop(&v.truth);
    free(v.truth.rgb);
    free(v.truth.rays);
    draw_close(&v);
    kit_gl_close();
    if (v.window) glfwDestroyWindow(v.window);
    glfwTerminate();
    if (!failed) failed = kit_streams_close(&v.err);
    if (failed) fprintf(stderr, "viewer: %s\n", v.err.text);
    load_close(&v);
    return failed ? 2 : 0;
}
