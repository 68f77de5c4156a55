/* window.c - opens the window with its context, and writes its title. */
#include "viewer.h"
#include <GLFW/glfw3.h>
#include <stdio.h>
#include <string.h>

int window_open(viewer *v)
{
    static const int versions[][2] = { { 4, 5 }, { 4, 3 }, { 3, 3 } };
    const char *why = "";
    if (!glfwInit()) {
        glfwGetError(&why);
        return kit_fail(&v->err, "no window: %s", why ? why : "no display");
    }
    for (int i = 0; i < 3 && !v->window; ++i) {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, versions[i][0]);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, versions[i][1]);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, 1);
        glfwWindowHint(GLFW_DEPTH_BITS, 0);
        v->window = glfwCreateWindow(v->size[0], v->size[1], "ssgi", NULL, NULL);
    }
    if (!v->window) {
        glfwGetError(&why);
        return kit_fail(&v->err, "no window with OpenGL 3.3: %s", why ? why : "");
    }
    glfwMakeContextCurrent(v->window);
    glfwSwapInterval(v->shot ? 0 : 1);
    return kit_gl_adopt(glfwGetProcAddress, &v->err);
}

/* Writes scene, method, size, milliseconds and number of averaged frames as title, at most 4 times a second. */
void window_title(viewer *v)
{
    const char *slash = strrchr(v->path, '/');
    const side *s = v->side;
    char title[sizeof v->title], mean[40] = "";
    if (kit_seconds() < v->titled + 0.25) return;
    if (v->mean) snprintf(mean, sizeof mean, " - mean of %u", v->mean);
    snprintf(title, sizeof title, "%.100s - %s%s%s - %dx%d - %.*f ms%s", slash && slash[1] ? slash + 1 : v->path,
             s[0].method.name, v->split_on ? " | " : "",
             !v->split_on ? ""
             : s[1].truth ? "truth"
                          : s[1].method.name,
             v->drawn[0], v->drawn[1], v->ms < 10 ? 1 : 0, v->ms, mean);
    v->titled = kit_seconds();
    if (!strcmp(title, v->title)) return;
    strcpy(v->title, title);
    glfwSetWindowTitle(v->window, title);
}
