/* input.c - handles the window's events: keys, mouse, dropped files. */
#include "viewer.h"
#include <GLFW/glfw3.h>
#include <math.h>
#include <string.h>

static void on_key(GLFWwindow *window, int code, int scan, int action, int mods)
{
    viewer *v = glfwGetWindowUserPointer(window);
    (void)scan;
    if (action == GLFW_RELEASE) return;
    for (const key *k = keys; k->code; ++k)
        if (k->code == code) k->press((press){ v, k, mods & GLFW_MOD_SHIFT });
    v->redraw = 1;
}

/* ---- >>mouse ----------------------------------------------------------------------------------------------------- */

static void move(viewer *v, double right, double up, double turn, double tilt, double zoom)
{
    kit_camera *c = &v->camera;
    double away[3], axis[3], level[3], length = 0, along = 0, flat = 0, m = 0;
    float to_view[16], projection[16];
    const kit_camera from = *c;
    kit_camera_orbit(c, &from, turn);
    for (int i = 0; i < 3; ++i) m += (double)c->up[i] * (double)c->up[i];
    for (int i = 0; i < 3; ++i) {
        axis[i] = (double)c->up[i] / sqrt(m);
        away[i] = (double)c->eye[i] - (double)c->target[i];
        along += away[i] * axis[i];
        length += away[i] * away[i];
    }
    length = sqrt(length);
    for (int i = 0; i < 3; ++i) flat += pow(level[i] = away[i] - along * axis[i], 2);
    flat = sqrt(flat);
    const double angle = fmin(fmax(atan2(flat, along) + tilt, 0.03), 3.11);
    for (int i = 0; i < 3 && flat > 0; ++i)
        c->eye[i] = c->target[i] + (float)(zoom * length * (cos(angle) * axis[i] + sin(angle) * level[i] / flat));
    if (!(c->fovy > 0)) c->ortho_height *= (float)zoom;
    kit_camera_matrices(c, to_view, projection);
    const double unit = c->fovy > 0 ? 2 * length * tan((double)c->fovy * 0.00872664626) : (double)c->ortho_height;
    for (int i = 0; i < 3; ++i) {
        const float by = (float)(unit * (right * (double)to_view[4 * i] + up * (double)to_view[4 * i + 1]));
        c->eye[i] += by;
        c->target[i] += by;
    }
    v->moved = 1;
}

static void on_mouse(GLFWwindow *window, double x, double y)
{
    viewer *v = glfwGetWindowUserPointer(window);
    int w, h;
    glfwGetWindowSize(window, &w, &h);
    const double dx = (x - v->mouse[0]) / h, dy = (y - v->mouse[1]) / h;
    const int turns = glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT);
    const int pans = glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_RIGHT)
                  || glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_MIDDLE);
    v->mouse[0] = x;
    v->mouse[1] = y;
    if (turns) move(v, 0, 0, -200 * dx, -3 * dy, 1);
    else if (pans) move(v, -dx, dy, 0, 0, 1);
}

static void on_wheel(GLFWwindow *window, double x, double y)
{
    (void)x;
    move(glfwGetWindowUserPointer(window), 0, 0, 0, 0, pow(0.9, y));
}

static void on_drop(GLFWwindow *window, int count, const char **paths)
{
    viewer *v = glfwGetWindowUserPointer(window);
    for (int i = 0; i < count; ++i) dropped(v, paths[i]);
    v->redraw = 1;
}

static void on_change(GLFWwindow *window) { ((viewer *)glfwGetWindowUserPointer(window))->redraw = 1; }

static void on_size(GLFWwindow *window, int width, int height)
{
    (void)width;
    (void)height;
    ((viewer *)glfwGetWindowUserPointer(window))->moved = 1;
}

void input_open(viewer *v)
{
    glfwSetWindowUserPointer(v->window, v);
    glfwSetKeyCallback(v->window, on_key);
    glfwSetCursorPosCallback(v->window, on_mouse);
    glfwSetScrollCallback(v->window, on_wheel);
    glfwSetDropCallback(v->window, on_drop);
    glfwSetWindowRefreshCallback(v->window, on_change);
    glfwSetFramebufferSizeCallback(v->window, on_size);
}

/* Turns the camera by --orbit a frame, or once in 20 seconds; and moves the sliding object on a circle of four radii's
   diameter in 4 seconds. */
void input_move(viewer *v, double seconds)
{
    const double turn = (v->frame ? v->orbit : 0) + (v->circles ? 18 * seconds : 0);
    const kit_camera from = v->camera;
    if (turn != 0) {
        kit_camera_orbit(&v->camera, &from, turn);
        v->moved = 1;
    }
    if (!v->slides) return;
    v->phase += 0.5 * KIT_PI * seconds;
    slide_to(v,
             (const float[3]){ 2 * v->radius * (float)sin(v->phase), 0, 2 * v->radius * (float)(1 - cos(v->phase)) });
}
