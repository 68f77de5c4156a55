/* gl.c - headless contexts (OSMesa, EGL), GL functions, textures, programs, GPU time. Declared in kit_gl.h. */
#include "kit/kit_gl.h"
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define KIT_GL_DEFINE(name, NAME) PFNGL##NAME##PROC gl##name;
KIT_GL_CORE(KIT_GL_DEFINE)
KIT_GL_ES31(KIT_GL_DEFINE)
KIT_GL_DESKTOP(KIT_GL_DEFINE)

typedef void (*function)(void);
typedef struct kept { uint64_t key; GLuint program; } kept;

static struct {
    int         open;                      /* 0 none, 1 by OSMesa, 2 by EGL, 3 a window's */
    void       *context, *display;
    function  (*proc)(const char *);
    int         es, software;
    char        name[256];
    GLuint      vertex_array, query;
    double      began;
    kept       *kept;
    int         kept_count;
    uint8_t     osmesa_buffer[16 * 16 * 4];
} gl;

/* Opens the first library of names that exists and fills the function pointers; NULL if none exists. It is never
   closed: Mesa's compiler threads do not survive that. C has no cast from dlsym's object pointer to a function pointer;
   POSIX promises that copying it works. */
static void *library(const char *const *names, const char *const *symbols, void *const *functions)
{
    void *l = NULL;
    while (!l && *names) l = dlopen(*names++, RTLD_NOW | RTLD_LOCAL);
    for (; l && *symbols; symbols++, functions++) {
        void *p = dlsym(l, *symbols);
        memcpy(*functions, &p, sizeof p);
    }
    return l;
}

/* ---- >>osmesa ----------------------------------------------------------------------------------------------- */

enum { OSMESA_FORMAT = 0x22, OSMESA_DEPTH_BITS = 0x30, OSMESA_PROFILE = 0x33, OSMESA_CORE_PROFILE = 0x34,
       OSMESA_MAJOR = 0x36, OSMESA_MINOR = 0x37 };

static struct {
    void          *library;
    void        *(*create)(const int *, void *);
    unsigned char (*current)(void *, void *, GLenum, int, int);
    void         (*destroy)(void *);
    function     (*proc)(const char *);
} osmesa;

static int osmesa_open(kit_error *err)
{
    static const char *const names[] = { "libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so", NULL };
    static const char *const symbols[] = { "OSMesaCreateContextAttribs", "OSMesaMakeCurrent", "OSMesaDestroyContext",
                                           "OSMesaGetProcAddress", NULL };
    static void *const functions[] = { &osmesa.create, &osmesa.current, &osmesa.destroy, &osmesa.proc };
    if (!osmesa.library) osmesa.library = library(names, symbols, functions);
    if (!osmesa.library)
        return kit_fail(err, "context osmesa: libOSMesa.so is not there; install it (Debian: libosmesa6) or try egl");
    if (!osmesa.create || !osmesa.current || !osmesa.destroy || !osmesa.proc)
        return kit_fail(err, "context osmesa: this libOSMesa is too old (no OSMesaCreateContextAttribs); Mesa 12 or "
                             "newer is needed, or try egl");
    for (int minor = 5; minor >= 3 && !gl.context; minor -= 2) {
        int attributes[] = { OSMESA_FORMAT, GL_RGBA, OSMESA_DEPTH_BITS, 24, OSMESA_PROFILE, OSMESA_CORE_PROFILE,
                             OSMESA_MAJOR, 4, OSMESA_MINOR, minor, 0 };
        gl.context = osmesa.create(attributes, NULL);
    }
    if (!gl.context)
        return kit_fail(err, "context osmesa: libOSMesa gives no GL 4.3 core; Mesa 20.2 or newer with llvmpipe is "
                             "needed, or try egl");
    gl.open = 1;
    if (!osmesa.current(gl.context, gl.osmesa_buffer, GL_UNSIGNED_BYTE, 16, 16))
        return kit_fail(err, "context osmesa: OSMesaMakeCurrent failed; try egl");
    return 0;
}

/* ---- >>egl -------------------------------------------------------------------------------------------------- */

/* from the EGL registry */
enum {
    EGL_NONE = 0x3038,
    EGL_EXTENSIONS = 0x3055,
    EGL_OPENGL_API = 0x30A2,
    EGL_OPENGL_ES_API = 0x30A0,
    EGL_MAJOR = 0x3098,
    EGL_MINOR = 0x30FB,
    EGL_PROFILE_MASK = 0x30FD,
    EGL_CORE_PROFILE = 1,
    EGL_PLATFORM_DEVICE = 0x313F,
    EGL_PLATFORM_SURFACELESS = 0x31DD
};
enum { EGL_MAX_DEVICES = 64 };

static struct {
    void        *library;
    function    (*proc)(const char *);
    const char *(*query_string)(void *display, int32_t name);
    unsigned    (*initialize)(void *display, int32_t *major, int32_t *minor);
    unsigned    (*terminate)(void *display);
    unsigned    (*bind_api)(unsigned api);
    void       *(*create)(void *display, void *config, void *share, const int32_t *attributes);
    unsigned    (*destroy)(void *display, void *context);
    unsigned    (*current)(void *display, void *draw, void *read, void *context);
    void       *(*platform_display)(unsigned platform, void *native, const int32_t *attributes);
    unsigned    (*query_devices)(int32_t max, void **devices, int32_t *count);
    const char *(*device_string)(void *device, int32_t name);
} egl;

static int is_rasteriser(const char *renderer)
{
    static const char *const names[] = { "llvmpipe", "softpipe", "swrast", "Software", "SwiftShader",
                                          "Basic Render" };
    int found = 0;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) found |= renderer && strstr(renderer, names[i]) != NULL;
    return found;
}

/* Returns whether the CPU draws for the current context. EGL lists a display adapter without a 3D engine as hardware,
   but Mesa's rasteriser draws for it. */
static int egl_is_software(void)
{
    const PFNGLGETSTRINGPROC get = (PFNGLGETSTRINGPROC)egl.proc("glGetString");
    return get && is_rasteriser((const char *)get(GL_RENDERER));
}

/* Returns 1 if it made a context on this display current. software 0: none that the CPU draws for; 2: only those. */
static int egl_try(void *display, int es, int software)
{
    static const int32_t versions[2][3] = { { 45, 43, 0 }, { 32, 31, 30 } };
    if (!display || !egl.initialize(display, NULL, NULL)) return 0;
    if (egl.bind_api(es ? EGL_OPENGL_ES_API : EGL_OPENGL_API))
        for (int i = 0; i < 3 && versions[es][i]; i++) {
            int32_t attributes[] = { EGL_MAJOR, versions[es][i] / 10, EGL_MINOR, versions[es][i] % 10,
                                     es ? EGL_NONE : EGL_PROFILE_MASK, EGL_CORE_PROFILE, EGL_NONE };
            void *context = egl.create(display, NULL, NULL, attributes);
            const int current = context && egl.current(display, NULL, NULL, context);
            if (current && (software == 1 || egl_is_software() == (software == 2))) {
                gl.open = 2; gl.display = display; gl.context = context;
                return 1;
            }
            if (current) egl.current(display, NULL, NULL, NULL);
            if (context) egl.destroy(display, context);
            if (current) break;
        }
    egl.terminate(display);
    return 0;
}

/* Opens a context by EGL. cpu: 1 = only one that the CPU draws for. */
static int egl_open(int es, int cpu, kit_error *err)
{
    static const char *const names[] = { "libEGL.so.1", "libEGL.so", NULL };
    static const char *const symbols[] = { "eglGetProcAddress", "eglQueryString", "eglInitialize",
                                           "eglTerminate",      "eglBindAPI",     "eglCreateContext",
                                           "eglDestroyContext", "eglMakeCurrent", NULL };
    static void *const functions[] = { &egl.proc,     &egl.query_string, &egl.initialize, &egl.terminate,
                                       &egl.bind_api, &egl.create,       &egl.destroy,    &egl.current };
    const char *self = es ? "egl-es" : "egl", *client;
    void *devices[EGL_MAX_DEVICES];
    int32_t count = 0;
    if (!egl.library) egl.library = library(names, symbols, functions);
    if (!egl.library)
        return kit_fail(err,
                        "context %s: libEGL.so.1 is not there; install it (Debian: libegl1 and libegl-mesa0, or the "
                        "GPU's driver)",
                        self);
    if (egl.proc) {
        egl.platform_display = (void *(*)(unsigned, void *, const int32_t *))egl.proc("eglGetPlatformDisplayEXT");
        egl.query_devices    = (unsigned (*)(int32_t, void **, int32_t *))egl.proc("eglQueryDevicesEXT");
        egl.device_string    = (const char *(*)(void *, int32_t))egl.proc("eglQueryDeviceStringEXT");
    }
    if (!egl.query_string || !egl.initialize || !egl.terminate || !egl.bind_api || !egl.create || !egl.destroy
        || !egl.current || !egl.proc || !egl.platform_display)
        return kit_fail(err,
                        "context %s: this libEGL has no eglGetPlatformDisplayEXT; EGL 1.5 is needed, or try osmesa",
                        self);
    client = egl.query_string(NULL, EGL_EXTENSIONS);
    if (!client) client = "";

    if (strstr(client, "EGL_EXT_platform_device") && egl.query_devices && egl.device_string)
        if (!egl.query_devices(EGL_MAX_DEVICES, devices, &count)) count = 0;
    /* Devices that a GPU draws for come first; if the CPU draws, the surfaceless platform comes before devices. */
    const int surfaceless = strstr(client, "EGL_MESA_platform_surfaceless") != NULL;
    for (int software = cpu; software < 2; software++) {
        if (software && surfaceless
            && egl_try(egl.platform_display(EGL_PLATFORM_SURFACELESS, NULL, NULL), es, software + cpu))
            return 0;
        for (int32_t i = 0; i < count; i++) {
            const char *extensions = egl.device_string(devices[i], EGL_EXTENSIONS);
            const int marked = extensions && strstr(extensions, "EGL_MESA_device_software");
            if (marked <= software
                && egl_try(egl.platform_display(EGL_PLATFORM_DEVICE, devices[i], NULL), es, software + cpu))
                return 0;
        }
        if (!software && surfaceless && egl_try(egl.platform_display(EGL_PLATFORM_SURFACELESS, NULL, NULL), es, 0))
            return 0;
    }
    return kit_fail(err,
                    "context %s: none of %d EGL devices, nor Mesa's surfaceless platform, gives %s; install the GPU's "
                    "EGL driver or "
                    "libegl-mesa0 and libgl1-mesa-dri, or try osmesa",
                    self, (int)count, es ? "GLES 3.0" : "GL 4.3 core");
}

/* ---- >>context ---------------------------------------------------------------------------------------------- */

static int has_extension(const char *name)
{
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; i++)
        if (!strcmp((const char *)glGetStringi(GL_EXTENSIONS, (GLuint)i), name)) return 1;
    return 0;
}

/* Loads GL's functions that GL's version has: libglvnd returns a pointer for any name that begins with gl. */
static int load(kit_error *err)
{
    function (*const proc)(const char *) = gl.proc;
    const char *version, *renderer, *missing = NULL;
    GLint major = 0, minor = 0;
    int es31;
#define KIT_GL_LOAD(name, NAME)     gl##name = (PFNGL##NAME##PROC)proc("gl" #name);
#define KIT_GL_REQUIRE(name, NAME)  KIT_GL_LOAD(name, NAME) if (!gl##name) missing = "gl" #name;
#define KIT_GL_LOAD_31(name, NAME)  gl##name = es31 ? (PFNGL##NAME##PROC)proc("gl" #name) : NULL;
#define KIT_GL_LOAD_GL(name, NAME)  gl##name = gl.es ? NULL : (PFNGL##NAME##PROC)proc("gl" #name);
    KIT_GL_CORE(KIT_GL_REQUIRE)
    if (missing) return kit_fail(err, "GL context: it lacks %s; GL 4.3 or GLES 3.0 is needed", missing);
    version  = (const char *)glGetString(GL_VERSION);
    renderer = (const char *)glGetString(GL_RENDERER);
    if (!version || !renderer)
        return kit_fail(err, "GL context: it answers no calls (glGetString gives nothing); another driver's libGL may "
                             "be in the way");
    gl.es = strstr(version, "OpenGL ES") != NULL;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    es31 = !gl.es || major * 10 + minor >= 31;
    KIT_GL_ES31(KIT_GL_LOAD_31)
    KIT_GL_DESKTOP(KIT_GL_LOAD_GL)
    if (gl.es && has_extension("GL_EXT_clip_control"))
        glClipControl = (PFNGLCLIPCONTROLPROC)proc("glClipControlEXT");
    if (gl.es && has_extension("GL_EXT_disjoint_timer_query"))
        glGetQueryObjectui64v = (PFNGLGETQUERYOBJECTUI64VPROC)proc("glGetQueryObjectui64vEXT");
    if (!gl.es && major * 10 + minor < 45 && !has_extension("GL_ARB_clip_control")) glClipControl = NULL;
    if (!gl.es && major < 4) glPatchParameteri = NULL;
    gl.software = is_rasteriser(renderer);
    snprintf(gl.name, sizeof gl.name, "%s, %s", renderer, version);
    return 0;
}

/* Called at exit: if Mesa's rasteriser is drawing then, the exit can hang, as it waits for threads that wait. */
static void finish_drawing(void)
{
    if (gl.vertex_array) glFinish();
}

/* Loads the functions and sets the state that the kit expects; result: of opening the context. */
static int make_ready(int result, kit_error *err)
{
    static int at_exit;
    if (!result) result = load(err);
    if (result) { kit_gl_close(); return -1; }
    glGenVertexArrays(1, &gl.vertex_array);
    glBindVertexArray(gl.vertex_array);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    if (!at_exit) at_exit = !atexit(finish_drawing);       /* registered now, so that it runs before Mesa's handler */
    return 0;
}

int kit_gl_adopt(void (*(*proc)(const char *name))(void), kit_error *err)
{
    kit_gl_close();
    gl.open = 3;
    gl.proc = proc;
    return make_ready(0, err);
}

int kit_gl_open(const char *context, kit_error *err)
{
    int result;
    kit_gl_close();
    if (!context) context = getenv("KIT_CONTEXT");
    if (!context) {
        result = osmesa_open(NULL);
        if (result) { kit_gl_close(); result = egl_open(0, 1, err); }
    } else if (!strcmp(context, "osmesa")) result = osmesa_open(err);
    else if (!strcmp(context, "egl"))      result = egl_open(0, 0, err);
    else if (!strcmp(context, "egl-es"))   result = egl_open(1, 0, err);
    else return kit_fail(err, "context '%s': no such kind; there are osmesa, egl and egl-es", context);
    gl.proc = gl.open == 1 ? osmesa.proc : egl.proc;
    return make_ready(result, err);
}

void kit_gl_close(void)
{
    finish_drawing();
    if (gl.open == 1) {
        osmesa.current(NULL, NULL, 0, 0, 0);
        osmesa.destroy(gl.context);
    } else if (gl.open == 2) {
        egl.current(gl.display, NULL, NULL, NULL);
        egl.destroy(gl.display, gl.context);
        egl.terminate(gl.display);
    }
    free(gl.kept);
    memset(&gl, 0, sizeof gl);
}

const char *kit_gl_name(void)        { return gl.name; }
int         kit_gl_is_es(void)       { return gl.es; }
int         kit_gl_is_software(void) { return gl.software; }

/* ---- >>texture ---------------------------------------------------------------------------------------------- */

static const struct format { GLenum internal, format; int components; GLenum type;
} formats[] = {
    { GL_R8, GL_RED, 1, GL_UNSIGNED_BYTE },
    { GL_RG8, GL_RG, 2, GL_UNSIGNED_BYTE },
    { GL_RGBA8, GL_RGBA, 4, GL_UNSIGNED_BYTE },
    { GL_R16F, GL_RED, 1, GL_FLOAT },
    { GL_RG16F, GL_RG, 2, GL_FLOAT },
    { GL_RGBA16F, GL_RGBA, 4, GL_FLOAT },
    { GL_R11F_G11F_B10F, GL_RGB, 3, GL_FLOAT },
    { GL_R32F, GL_RED, 1, GL_FLOAT },
    { GL_RG32F, GL_RG, 2, GL_FLOAT },
    { GL_RGBA32F, GL_RGBA, 4, GL_FLOAT },
    { GL_R32UI, GL_RED_INTEGER, 1, GL_UNSIGNED_INT },
    { GL_RG32UI, GL_RG_INTEGER, 2, GL_UNSIGNED_INT },
    { GL_RGBA32UI, GL_RGBA_INTEGER, 4, GL_UNSIGNED_INT },
    { GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, 1, GL_UNSIGNED_INT },
    { GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, 1, GL_FLOAT },
};

/* Converts floats to the type that GLES demands for the format; NULL: no memory. */
static void *packed(const float *data, size_t count, GLenum type)
{
    void *out = malloc(count * (type == GL_UNSIGNED_BYTE ? 1 : 4) + 1);
    for (size_t i = 0; out && i < count; i++) {
        double v = data[i] > 0 ? (data[i] < 1 ? (double)data[i] : 1.0) : 0.0;
        if (type == GL_UNSIGNED_BYTE) ((uint8_t *)out)[i] = (uint8_t)(v * 255 + 0.5);
        else                          ((uint32_t *)out)[i] = (uint32_t)(v * 4294967295.0 + 0.5);
    }
    return out;
}

/* Makes a texture; layers 0: 2D, not an array. */
static GLuint texture_new(int width, int height, int layers, GLenum internal_format, const float *data_or_null)
{
    const GLenum target = layers ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
    const struct format *f = NULL;
    const void *data = data_or_null;
    void *copy = NULL;
    GLuint texture = 0;
    GLint bound = 0;
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        if (formats[i].internal == internal_format) f = &formats[i];
    if (!f || width < 1 || height < 1 || layers < 0) return 0;
    if (data && (f->type == GL_UNSIGNED_BYTE || internal_format == GL_DEPTH_COMPONENT24)) {
        data = copy =
            packed(data_or_null, (size_t)width * (size_t)height * (size_t)(layers ? layers : 1) * (size_t)f->components,
                   f->type);
        if (!copy) return 0;
    }
    glGetIntegerv(layers ? GL_TEXTURE_BINDING_2D_ARRAY : GL_TEXTURE_BINDING_2D, &bound);
    glGenTextures(1, &texture);
    glBindTexture(target, texture);
    if (layers) glTexImage3D(target, 0, (GLint)internal_format, width, height, layers, 0, f->format, f->type, data);
    else        glTexImage2D(target, 0, (GLint)internal_format, width, height, 0, f->format, f->type, data);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
    glBindTexture(target, (GLuint)bound);
    free(copy);
    return texture;
}

GLuint kit_texture(int width, int height, GLenum internal_format, const float *data_or_null)
{
    return texture_new(width, height, 0, internal_format, data_or_null);
}

GLuint kit_texture_array(int width, int height, int layers, GLenum internal_format, const float *data_or_null)
{
    return layers < 1 ? 0 : texture_new(width, height, layers, internal_format, data_or_null);
}

void kit_texture_linear(GLenum target)
{
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

/* Attaches a texture to the read framebuffer; slice -1: it is not an array. */
static void attach_to_read(GLenum attachment, GLuint texture, int slice)
{
    if (slice < 0) glFramebufferTexture2D(GL_READ_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture, 0);
    else           glFramebufferTextureLayer(GL_READ_FRAMEBUFFER, attachment, texture, 0, slice);
}

/* Reads depth, one float a texel, as the first of four floats. */
static void read_depth(int width, int height, float *data)
{
    const size_t texels = (size_t)width * (size_t)height;
    glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, data);
    if (glGetError() != GL_NO_ERROR) {                         /* GLES gives integer depth only as integers */
        glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, data);
        for (size_t i = 0; i < texels; i++) {
            uint32_t bits;
            memcpy(&bits, data + i, sizeof bits);
            data[i] = (float)((double)bits / 4294967295.0);
        }
    }
    for (size_t i = texels; i-- > 0; ) data[4 * i] = data[i];
}

/* Reads colours as four floats a texel, or integers as floats with the same bits. */
static int read_colour(int width, int height, float *data)
{
    const size_t texels = (size_t)width * (size_t)height;
    GLint type = GL_FLOAT;
    glGetFramebufferAttachmentParameteriv(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                                          GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
    if (type == GL_UNSIGNED_INT) glReadPixels(0, 0, width, height, GL_RGBA_INTEGER, GL_UNSIGNED_INT, data);
    else if (type != GL_UNSIGNED_NORMALIZED || !gl.es) glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, data);
    else {                                 /* GLES reads normalised texels as bytes only; the kit has no wider ones */
        uint8_t *bytes = malloc(texels * 4);
        if (!bytes) return -1;
        glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
        for (size_t i = 0; i < texels * 4; i++) data[i] = (float)bytes[i] / 255.0f;
        free(bytes);
    }
    return 0;
}

/* Reads the texture attached to the read framebuffer as four floats a texel. */
static int read_attached(GLuint texture, int slice, int width, int height, float *data)
{
    attach_to_read(GL_COLOR_ATTACHMENT0, texture, slice);
    const int is_depth = glCheckFramebufferStatus(GL_READ_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE;
    if (is_depth) {                        /* GLES reads depth by NV_read_depth, which Mesa and NVIDIA have */
        attach_to_read(GL_COLOR_ATTACHMENT0, 0, slice);
        attach_to_read(GL_DEPTH_ATTACHMENT, texture, slice);
    }
    if (glCheckFramebufferStatus(GL_READ_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return -1;
    while (glGetError() != GL_NO_ERROR) {}
    if (is_depth) read_depth(width, height, data);
    else if (read_colour(width, height, data)) return -1;
    return glGetError() == GL_NO_ERROR ? 0 : -1;
}

static int texture_read(GLuint texture, int slice, int width, int height, int components, float *out)
{
    const size_t texels = (size_t)width * (size_t)height, wanted = (size_t)components;
    GLint framebuffer_was = 0;
    GLuint framebuffer;
    if (width < 1 || height < 1 || components < 1 || components > 4) return -1;
    float *data = malloc(texels * 4 * sizeof *data);
    if (!data) return -1;
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &framebuffer_was);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    const int failed = read_attached(texture, slice, width, height, data);
    for (size_t i = 0; i < texels && !failed; i++) memcpy(out + i * wanted, data + 4 * i, wanted * sizeof *out);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, (GLuint)framebuffer_was);
    glDeleteFramebuffers(1, &framebuffer);
    free(data);
    return failed;
}

int kit_texture_read(GLuint texture, int width, int height, int components, float *out)
{
    return texture_read(texture, -1, width, height, components, out);
}

int kit_texture_slice_read(GLuint array, int slice, int width, int height, int components, float *out)
{
    return slice < 0 ? -1 : texture_read(array, slice, width, height, components, out);
}

/* ---- >>program ---------------------------------------------------------------------------------------------- */

static const char *stage_name(GLenum stage)
{
    return stage == GL_VERTEX_SHADER            ? "vertex"
           : stage == GL_FRAGMENT_SHADER        ? "fragment"
           : stage == GL_GEOMETRY_SHADER        ? "geometry"
           : stage == GL_TESS_CONTROL_SHADER    ? "tessellation control"
           : stage == GL_TESS_EVALUATION_SHADER ? "tessellation evaluation"
                                                : "compute";
}

/* Joins the first lines of a driver's log to one line. */
static void shorten(char *log)
{
    size_t length = strlen(log);
    int lines = 0;
    while (length && (log[length - 1] == '\n' || log[length - 1] == ' ')) log[--length] = 0;
    for (char *c = log; *c; c++)
        if (*c == '\n' || *c == '\r') {
            if (++lines == 4) { *c = 0; break; }
            *c = ';';
        }
}

GLuint kit_program(const char *const *source, const GLenum *stage, int count, kit_error *err)
{
    GLuint program = glCreateProgram();
    GLint ok = 1;
    char log[800] = "";
    for (int i = 0; i < count && ok; i++) {
        GLuint shader = glCreateShader(stage[i]);
        if (!shader) {
            kit_fail(err, "%s shader: this context (%s) has no such stage", stage_name(stage[i]), gl.name);
            ok = 0;
            break;
        }
        glShaderSource(shader, 1, &source[i], NULL);
        glCompileShader(shader);
        glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
        if (!ok) {
            glGetShaderInfoLog(shader, sizeof log, NULL, log);
            shorten(log);
            kit_fail(err, "%s shader does not compile: %s", stage_name(stage[i]), log);
        }
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    if (ok) {
        glLinkProgram(program);
        glGetProgramiv(program, GL_LINK_STATUS, &ok);
        if (!ok) {
            glGetProgramInfoLog(program, sizeof log, NULL, log);
            shorten(log);
            kit_fail(err, "program does not link: %s", log);
        }
    }
    if (!ok) { glDeleteProgram(program); program = 0; }
    return program;
}

GLuint kit_program_text(const char *head, const char *vertex, const char *fragment, kit_error *err)
{
    static const GLenum stage[2] = { GL_VERTEX_SHADER, GL_FRAGMENT_SHADER };
    const char *prelude =
        gl.es ? "#version 300 es\nprecision highp float;\nprecision highp sampler2D;\n" : "#version 330 core\n";
    const char *body[2] = { vertex, fragment };
    char *text[2] = { NULL, NULL };
    GLuint program = 0;
    for (int i = 0; i < 2; i++) {
        size_t size = strlen(prelude) + strlen(head) + strlen(body[i]) + 1;
        text[i] = malloc(size);
        if (text[i]) snprintf(text[i], size, "%s%s%s", prelude, head, body[i]);
    }
    if (text[0] && text[1]) program = kit_program((const char *const *)text, stage, 2, err);
    else kit_fail(err, "program: no memory for its text");
    free(text[0]);
    free(text[1]);
    return program;
}

GLuint kit_program_kept(uint64_t key)
{
    for (int i = 0; i < gl.kept_count; i++)
        if (gl.kept[i].key == key) return gl.kept[i].program;
    return 0;
}

int kit_program_keep(uint64_t key, GLuint program, kit_error *err)
{
    kept *more = realloc(gl.kept, (size_t)(gl.kept_count + 1) * sizeof *more);
    if (!more) return kit_fail(err, "out of memory");
    gl.kept = more;
    gl.kept[gl.kept_count++] = (kept){ key, program };
    return 0;
}

GLuint kit_program_kept_text(const char *head, const char *vertex, const char *fragment, kit_error *err)
{
    const uint64_t key = kit_hash(kit_hash(kit_hash(KIT_HASH, head, strlen(head)), vertex, strlen(vertex)), fragment,
                                  strlen(fragment));
    GLuint program = kit_program_kept(key);
    if (program) return program;
    program = kit_program_text(head, vertex, fragment, err);
    if (!program || !kit_program_keep(key, program, err)) return program;
    glDeleteProgram(program);
    return 0;
}

/* ---- >>soup ------------------------------------------------------------------------------------------------- */

void kit_soup_open(kit_soup *soup, const float *vertices, size_t count, int attributes)
{
    const size_t stride = 3 * sizeof *vertices * (size_t)attributes;
    glGenVertexArrays(1, &soup->vertex_array);
    kit_soup_use(soup);
    glGenBuffers(1, &soup->buffer);
    glBindBuffer(GL_ARRAY_BUFFER, soup->buffer);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(count * stride), vertices, GL_STATIC_DRAW);
    for (int i = 0; i < attributes; i++) {
        glVertexAttribPointer((GLuint)i, 3, GL_FLOAT, GL_FALSE, (GLsizei)stride,
                              (const void *)(3 * (size_t)i * sizeof *vertices));
        glEnableVertexAttribArray((GLuint)i);
    }
}

void kit_soup_use(kit_soup *soup)
{
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &soup->vertex_array_was);
    glBindVertexArray(soup->vertex_array);
    glDisable(GL_SCISSOR_TEST); glDisable(GL_BLEND); glDisable(GL_CULL_FACE); glDisable(GL_STENCIL_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glDepthRangef(0, 1);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
}

void kit_soup_rest(kit_soup *soup)
{
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
    glUseProgram(0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glBindVertexArray((GLuint)soup->vertex_array_was);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void kit_soup_close(kit_soup *soup)
{
    GLint bound;
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
    if ((GLuint)bound == soup->vertex_array) kit_soup_rest(soup);
    glDeleteBuffers(1, &soup->buffer);
    glDeleteVertexArrays(1, &soup->vertex_array);
    memset(soup, 0, sizeof *soup);
}

/* ---- >>timer ------------------------------------------------------------------------------------------------ */

/* Returns if timer queries can be used: a software renderer answers them before its threads have drawn. */
static int timer_by_query(void) { return !gl.software && glGetQueryObjectui64v; }

const char *kit_timer_name(void) { return timer_by_query() ? "timer queries" : "the clock"; }

void kit_timer_begin(void)
{
    glFinish();
    gl.began = kit_seconds();
    if (timer_by_query()) {
        if (!gl.query) glGenQueries(1, &gl.query);
        glBeginQuery(GL_TIME_ELAPSED, gl.query);
    }
}

double kit_timer_end(void)
{
    GLuint64 nanoseconds = 0;
    if (timer_by_query()) {
        glEndQuery(GL_TIME_ELAPSED);
        glGetQueryObjectui64v(gl.query, GL_QUERY_RESULT, &nanoseconds);
        return (double)nanoseconds * 1e-6;
    }
    glFinish();
    return (kit_seconds() - gl.began) * 1e3;
}
