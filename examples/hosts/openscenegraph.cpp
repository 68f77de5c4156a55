/* openscenegraph.cpp - ambient occlusion in an engine that knows nothing of ssgi: OpenSceneGraph draws a mesh as usual,
   ssgi reads only its depth buffer, and the last step of hsao multiplies its picture. The code between the lines of
   "====" is needed in every engine; (1) to (3) are traps of this one. Draw glass and fog by a camera of their own
   (POST_RENDER), which draws after this one's callback. It draws one frame of one size; glfw.c shows the code for a
   change of size. Debian: libopenscenegraph-dev.
     c++ -std=c++17 examples/hosts/openscenegraph.cpp -losgViewer -losgDB -losg -lGL -o openscenegraph && \
     ./openscenegraph MESH.obj ex,ey,ez,tx,ty,tz RADIUS OUT         writes OUT-before.png, OUT-after.png, OUT-ao.png */
#define GL_GLEXT_PROTOTYPES
#include <osg/GL>
#include <GL/glext.h>
#include <osgDB/ReadFile>
#include <osgDB/WriteFile>
#include <osgViewer/Viewer>
#include <cstdio>
#define SSGI_IMPLEMENTATION
#define SSGI_GL_IMPLEMENTATION
#include "../../ssgi_gl.h"
enum { W = 960, H = 540, STEPS = SSGI_GL_MAX_STEPS };

static GLuint program_of(const char *vertex, const char *fragment)
{
    const char *text[2] = { vertex, fragment };
    const GLuint p = glCreateProgram();
    char log[1000] = "";
    for (int i = 0; i < 2; ++i) {
        const GLuint s = glCreateShader(i ? GL_FRAGMENT_SHADER : GL_VERTEX_SHADER);
        glShaderSource(s, 1, &text[i], nullptr);
        glCompileShader(s);
        glAttachShader(p, s);
    }
    glLinkProgram(p);
    glGetProgramInfoLog(p, sizeof log, nullptr, log);
    std::fputs(log, stderr);
    return p;
}

/* ==== ssgi: the steps of a desc, each with its program, its target and its inputs ================================= */
struct Occlusion {
    ssgi_gl_step step[STEPS];
    GLuint program[STEPS], framebuffer[STEPS] = {}, texture[STEPS], block;
    int steps = 0;
    void open()
    {
        static char text[2][32768];
        ssgi_gl_chain chain = {};
        const char *why = "";
        chain.desc.pass = SSGI_GL_PASS_HSAO;
        ssgi_gl_preset(&chain.desc, SSGI_GL_PRESET_BALANCED, nullptr);
        chain.desc.input.normal = SSGI_GL_NORMAL_FROM_DEPTH;
        chain.desc.filter.onto = SSGI_GL_ONTO_MULTIPLY;
        chain.blur = 1;
        chain.width = W, chain.height = H;
        steps = ssgi_gl_steps(step, STEPS, &chain, &why);
        if (steps > STEPS) steps = 0, why = "the chain has more steps than SSGI_GL_MAX_STEPS";
        if (!steps) std::puts(why);
        glGenBuffers(1, &block);
        glGenTextures(STEPS, texture);
        for (int i = 0; i < steps; ++i) {
            const ssgi_gl_output &to = step[i].output[0];       /* one output each; the last step's is the image */
            for (int s = 0; s < 2; ++s) ssgi_gl_emit(text[s], sizeof text[s], &step[i].desc, s);
            glUseProgram(program[i] = program_of(text[SSGI_GL_STAGE_VERTEX], text[SSGI_GL_STAGE_FRAGMENT]));
            for (int k = 0; k < step[i].inputs; ++k)
                glUniform1i(glGetUniformLocation(program[i], step[i].input[k].name), step[i].input[k].unit);
            glUniformBlockBinding(program[i], glGetUniformBlockIndex(program[i], "ssgi_frame"), 0);
            if (to.texture < 0) continue;
            glBindTexture(GL_TEXTURE_2D, texture[to.texture]);
            glTexImage2D(GL_TEXTURE_2D, 0, GLint(to.format->internal), step[i].width, step[i].height, 0,
                         to.format->format, to.format->type, nullptr);
            for (GLenum filter : { GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER })
                glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);     /* otherwise integer textures read 0 */
            glGenFramebuffers(1, &framebuffer[i]);
            glBindFramebuffer(GL_FRAMEBUFFER, framebuffer[i]);
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture[to.texture], 0);
        }
    }
    void draw(GLuint depth, const float projection[16], float radius)
    {
        ssgi_view view;
        ssgi_gl_frame frame;
        const char *why = "";
        if (ssgi_view_from_projection(&view, projection, SSGI_CLIP_GL, W, H, &why)
            || ssgi_gl_frame_init(&frame, &view, radius, &why)) std::puts(why);
        glBindBufferBase(GL_UNIFORM_BUFFER, 0, block);
        glBufferData(GL_UNIFORM_BUFFER, sizeof frame, &frame, GL_DYNAMIC_DRAW);
        for (GLenum off : { GL_DEPTH_TEST, GL_CULL_FACE, GL_SCISSOR_TEST, GL_ALPHA_TEST }) glDisable(off);
        for (int i = 0; i < steps; ++i) {
            for (int k = 0; k < step[i].inputs; ++k) {          /* with this desc, depth is the engine's only texture */
                const ssgi_gl_input &in = step[i].input[k];
                glActiveTexture(GL_TEXTURE0 + GLenum(in.unit));
                glBindTexture(in.target, in.texture < 0 ? depth : texture[in.texture]);
            }
            glBindFramebuffer(GL_FRAMEBUFFER, framebuffer[i]);
            glViewport(0, 0, step[i].width, step[i].height);
            glUseProgram(program[i]);
            if (step[i].blend[0]) glEnable(GL_BLEND); else glDisable(GL_BLEND);
            if (step[i].blend[0]) glBlendEquation(step[i].blend[0]), glBlendFunc(step[i].blend[1], step[i].blend[2]);
            glDrawArraysInstanced(step[i].primitive, 0, step[i].vertices, step[i].instances);
        }
    }
};
/* ================================================================================================================== */

struct After : osg::Camera::DrawCallback {  /* called after the engine has drawn its image */
    mutable Occlusion occlusion;
    mutable GLuint depth = 0;
    float radius = 1;
    std::string out;
    void operator()(osg::RenderInfo &info) const override
    {
        const osg::Matrixf projection(info.getCurrentCamera()->getProjectionMatrix());
        const auto save = [this](const char *ending) {
            osg::ref_ptr<osg::Image> picture = new osg::Image;
            picture->readPixels(0, 0, W, H, GL_RGB, GL_UNSIGNED_BYTE);
            osgDB::writeImageFile(*picture, out + ending);
        };
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        save("-before.png");
        if (!occlusion.steps) occlusion.open();
        if (!depth) glGenTextures(1, &depth);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, depth);
        glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 0, 0, W, H, 0);    /* the window's depth */
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        occlusion.draw(depth, projection.ptr(), radius);
        save("-after.png");
        glClearColor(1, 1, 1, 1);           /* draws once more onto white, to see the occlusion alone */
        glClear(GL_COLOR_BUFFER_BIT);
        occlusion.draw(depth, projection.ptr(), radius);
        save("-ao.png");
        glUseProgram(0);
        glPopAttrib();                      /* (1) OpenSceneGraph caches GL's state: restore it, then tell it so */
        info.getState()->dirtyAllModes();
        info.getState()->dirtyAllAttributes();
    }
};

int main(int argc, char **argv)
{
    double p[6];
    if (argc != 5 || std::sscanf(argv[2], "%lf,%lf,%lf,%lf,%lf,%lf", p, p + 1, p + 2, p + 3, p + 4, p + 5) != 6)
        return std::puts("usage: openscenegraph MESH.obj ex,ey,ez,tx,ty,tz RADIUS OUT"), 2;
    osgViewer::Viewer viewer;
    osg::ref_ptr<After> after = new After;
    viewer.setSceneData(osgDB::readNodeFile(argv[1], new osgDB::Options("noRotation")));  /* (2) else it turns y up */
    if (!viewer.getSceneData()) return std::printf("openscenegraph: %s: cannot be read\n", argv[1]), 2;
    viewer.setUpViewInWindow(0, 0, W, H);
    viewer.getLight()->setAmbient(osg::Vec4(0.5f, 0.5f, 0.5f, 1));
    osg::Camera *camera = viewer.getCamera();
    camera->setViewMatrixAsLookAt(osg::Vec3d(p[0], p[1], p[2]), osg::Vec3d(p[3], p[4], p[5]), osg::Y_AXIS);
    camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);  /* (3) GL's planes must equal */
    camera->setProjectionMatrixAsPerspective(45, double(W) / H, 0.1, 100);      /* those that ssgi gets */
    camera->setFinalDrawCallback(after), camera->setClearColor(osg::Vec4(0.7f, 0.78f, 0.85f, 1));
    after->radius = std::strtof(argv[3], nullptr), after->out = argv[4];
    viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    return viewer.frame(), 0;
}
