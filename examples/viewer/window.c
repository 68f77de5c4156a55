/* window.c - the window, its keys and its mouse. */
#include "viewer.h"
#include <GLFW/glfw3.h>
#include <math.h>
#include <string.h>

static void on_key(GLFWwindow *window, int key, int code, int action, int mods)
{
    viewer *v = glfwGetWindowUserPointer(window);
    half *h = &v->half[mods & GLFW_MOD_SHIFT && v->split_on ? 1 : 0];
    (void)code;
    if (action == GLFW_RELEASE) return;
    switch (key) {
    case GLFW_KEY_Q: case GLFW_KEY_ESCAPE: glfwSetWindowShouldClose(window, 1); return;
    case GLFW_KEY_H: v->help = !v->help; return;
    case GLFW_KEY_G: v->panel = !v->panel; return;
    case GLFW_KEY_C: v->colours = !v->colours; return;
    case GLFW_KEY_E: v->error = !v->error; return;
    case GLFW_KEY_O: picture_save(v, 0); return;
    case GLFW_KEY_X: picture_save(v, 1); return;
    case GLFW_KEY_R: memcpy(v->camera.eye, v->home.eye, sizeof v->home.eye);
                     memcpy(v->camera.target, v->home.target, sizeof v->home.target); return;
    case GLFW_KEY_LEFT: v->split = fmaxf(v->split - 0.02f, 0.05f); return;
    case GLFW_KEY_RIGHT: v->split = fminf(v->split + 0.02f, 0.95f); return;
    case GLFW_KEY_LEFT_BRACKET: v->radius /= 1.1f; return;
    case GLFW_KEY_RIGHT_BRACKET: v->radius *= 1.1f; return;
    case GLFW_KEY_S:
        if (!v->split_on) { v->split_on = 1; v->half[1].method = v->half[0].method; }
        else if (v->half[1].method != TRUTH) v->half[1].method = TRUTH;
        else { v->split_on = 0; v->half[1].method = v->half[0].method; }
        break;
    case GLFW_KEY_M: h->method = (h->method + 1) % (METHODS + (h != v->half)); break;
    case GLFW_KEY_P: h->preset = (h->preset + 1) % 3; break;
    case GLFW_KEY_B: v->behind = (v->behind + 1) % BEHINDS; break;
    case GLFW_KEY_N: v->from_depth = !v->from_depth; break;
    case GLFW_KEY_T: v->history = !v->history; break;
    default: return;
    }
    v->dirty = 1;
}

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

int window_open(viewer *v, const int size[2])
{
    const char *why = "";
    if (!glfwInit()) { glfwGetError(&why); return kit_fail(&v->err, "no window: %s", why ? why : "no display"); }
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, 1);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    v->window = glfwCreateWindow(size[0], size[1], "ssgi", NULL, NULL);
    if (!v->window) { glfwGetError(&why); return kit_fail(&v->err, "no window with OpenGL 3.3: %s", why ? why : ""); }
    glfwMakeContextCurrent(v->window);
    glfwSwapInterval(v->shot ? 0 : 1);
    glfwSetWindowUserPointer(v->window, v);
    glfwSetKeyCallback(v->window, on_key);
    glfwSetCursorPosCallback(v->window, on_mouse);
    glfwSetScrollCallback(v->window, on_wheel);
    const char *renderer = (const char *)glGetString(GL_RENDERER);
    gl_software = !renderer || strstr(renderer, "llvmpipe") || strstr(renderer, "softpipe")
               || strstr(renderer, "SwiftShader");
    return 0;
}
