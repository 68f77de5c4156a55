/* vtkSSGIPass.h - a pass for VTK 9 in the place of vtkSSAOPass: it multiplies the picture by hsao's ambient visibility,
   from depth alone. vtk.cpp is a program that uses it. In one file, define SSGI_IMPLEMENTATION and
   SSGI_GL_IMPLEMENTATION before you include it. Include it from its folder, because it includes ../../ssgi_gl.h. It
   calls GL itself, so link GL in addition to VTK's modules: CMake's find_package(OpenGL) and OpenGL::GL, or -lGL.

     vtkNew<vtkRenderStepsPass> steps;
     vtkNew<vtkSSGIPass> ssgi;
     ssgi->SetDelegatePass(steps);                 // dims everything, as vtkSSAOPass does, or ..
     renderer->SetPass(ssgi);

     vtkNew<vtkOpaquePass> opaque;
     ssgi->SetDelegatePass(opaque);                // .. opaque things: translucent things and volumes come after it
     steps->SetOpaquePass(ssgi);
     renderer->SetPass(steps);

   SetRadius is in units of the scene; begin with a tenth of its diagonal. Depth has one sample a pixel here, so edges
   are as with SetMultiSamples(0); FXAA smooths them. The code that ssgi needs in any engine is between the lines of
   "===="; (1) to (3) are rules of VTK for code that calls GL itself. */
#ifndef vtkSSGIPass_h
#define vtkSSGIPass_h
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <vtkImageProcessingPass.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOpenGLCamera.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>
#include <vtkTextureObject.h>
#include <string>
#include "../../ssgi_gl.h"

class vtkSSGIPass : public vtkImageProcessingPass
{
public:
    vtkTypeMacro(vtkSSGIPass, vtkImageProcessingPass);
    static vtkSSGIPass *New()
    {
        vtkSSGIPass *made = new vtkSSGIPass;
        made->InitializeObjectBase();
        return made;
    }
    vtkGetMacro(Radius, double);
    vtkSetMacro(Radius, double);
    vtkGetMacro(Strength, double);      /* factor of 1 - visibility; above 1 it exaggerates the occlusion */
    vtkSetMacro(Strength, double);
    vtkGetMacro(Preset, int);
    void SetPreset(int preset)          /* SSGI_GL_PRESET_FAST, _BALANCED, _BEST */
    {
        if (preset != Preset) Steps = Compiled = 0, Preset = preset, Modified();
    }

    void Render(const vtkRenderState *s) override
    {
        vtkRenderer *renderer = s->GetRenderer();
        vtkOpenGLRenderWindow *window = static_cast<vtkOpenGLRenderWindow *>(renderer->GetRenderWindow());
        vtkOpenGLCamera *camera = static_cast<vtkOpenGLCamera *>(renderer->GetActiveCamera());
        vtkOpenGLState *state = window->GetState();
        int width, height, x, y;
        GLint into = 0;
        NumberOfRenderedProps = 0;
        if (!DelegatePass) { vtkErrorMacro("DelegatePass: must be set"); return; }
        renderer->GetTiledSizeAndOrigin(&width, &height, &x, &y);
        state->vtkglGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &into);
        if (s->GetFrameBuffer()) x = y = 0;
        if (width < 1 || height < 1) return;
        /* (1) Bindings, viewport, tests and blending are set through VTK's copy of GL's state, so that it stays
           correct. */
        vtkOpenGLState::ScopedglViewport viewport(state);
        vtkOpenGLState::ScopedglBlendFuncSeparate blend(state);
        vtkOpenGLState::ScopedglDepthFunc depth(state);
        vtkOpenGLState::ScopedglDepthMask mask(state);
        state->PushFramebufferBindings();
        Resize(window, width, height);
        RenderDelegate(s, state, GLuint(into), x, y, width, height);
        {
            vtkOpenGLState::ScopedglEnableDisable tested(state, GL_DEPTH_TEST), culled(state, GL_CULL_FACE);
            vtkOpenGLState::ScopedglEnableDisable cut(state, GL_SCISSOR_TEST), blended(state, GL_BLEND);
            for (GLenum off : { GL_CULL_FACE, GL_SCISSOR_TEST, GL_BLEND, GL_DEPTH_TEST }) state->vtkglDisable(off);
            const char *why = Occlude(renderer, camera, state, width, height);
            if (why) vtkErrorMacro(<< why);
            Combine(state, GLuint(into), x, y, width, height, why ? 0 : Strength);
        }
        state->PopFramebufferBindings();
        state->vtkglActiveTexture(GL_TEXTURE0);
        glBindVertexArray(0);
        window->GetShaderCache()->ReleaseCurrentShader();   /* (2) VTK assumes that its last program is in use */
    }

    void ReleaseGraphicsResources(vtkWindow *w) override
    {
        vtkImageProcessingPass::ReleaseGraphicsResources(w);
        if (!Block) return;
        for (GLuint &p : Program) glDeleteProgram(p), p = 0;
        glDeleteProgram(Combined), glDeleteTextures(MOST, Texture), glDeleteFramebuffers(MOST, Framebuffer);
        glDeleteBuffers(1, &Block), glDeleteVertexArrays(1, &Array);
        Block = Combined = 0, Steps = Compiled = Width = 0;
        Colour->ReleaseGraphicsResources(w), Depth->ReleaseGraphicsResources(w), Drawn->ReleaseGraphicsResources(w);
    }

protected:
    vtkSSGIPass() = default;
    ~vtkSSGIPass() override = default;

private:
    enum { MOST = SSGI_GL_MAX_STEPS };
    ssgi_gl_step Step[MOST];
    GLuint Program[MOST] = {}, Texture[MOST] = {}, Framebuffer[MOST] = {}, Block = 0, Array = 0, Combined = 0;
    int Steps = 0, Compiled = 0, Width = 0, Height = 0, Preset = SSGI_GL_PRESET_BALANCED, Orthographic = 0;
    double Radius = 0.5, Strength = 1;
    vtkNew<vtkTextureObject> Colour, Depth;
    vtkNew<vtkOpenGLFramebufferObject> Drawn;

    /* Draws the delegate's image over the present one, unless the delegate clears it; a vtkOpaquePass does not. */
    void RenderDelegate(const vtkRenderState *s, vtkOpenGLState *state, GLuint into, int x, int y, int width,
                        int height)
    {
        Drawn->Bind();
        Drawn->AddColorAttachment(0, Colour);
        Drawn->AddDepthAttachment(Depth);
        Drawn->ActivateDrawBuffer(0);
        Drawn->StartNonOrtho(width, height);
        state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, into);
        state->vtkglBlitFramebuffer(x, y, x + width, y + height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        state->vtkglDepthMask(GL_TRUE);
        state->vtkglClearDepth(1);
        state->vtkglClear(GL_DEPTH_BUFFER_BIT);
        vtkRenderState inner(s->GetRenderer());
        inner.SetPropArrayAndCount(s->GetPropArray(), s->GetPropArrayCount());
        inner.SetFrameBuffer(Drawn);
        DelegatePass->Render(&inner);
        NumberOfRenderedProps += DelegatePass->GetNumberOfRenderedProps();
    }

    static GLuint ProgramOf(const char *vertex, const char *fragment)
    {
        const char *text[2] = { vertex, fragment };
        const GLuint program = glCreateProgram();
        char log[1000] = "";
        for (int i = 0; i < 2; ++i) {
            const GLuint shader = glCreateShader(i ? GL_FRAGMENT_SHADER : GL_VERTEX_SHADER);
            glShaderSource(shader, 1, &text[i], nullptr);
            glCompileShader(shader);
            glAttachShader(program, shader);
            glDeleteShader(shader);
        }
        glLinkProgram(program);
        glGetProgramInfoLog(program, sizeof log, nullptr, log);
        if (*log) vtkGenericWarningMacro(<< log);
        glUseProgram(program);
        return program;
    }

    void Resize(vtkOpenGLRenderWindow *window, int width, int height)
    {
        Drawn->SetContext(window);
        if (width == Width && height == Height) return;
        /* a framebuffer object keeps the old textures' names as its attachments, unless it is made anew */
        Drawn->ReleaseGraphicsResources(window);
        Drawn->SetContext(window);
        for (vtkTextureObject *one : { Colour.Get(), Depth.Get() }) {
            one->ReleaseGraphicsResources(window);
            one->SetContext(window);
        }
        Colour->Allocate2D(unsigned(width), unsigned(height), 4, VTK_UNSIGNED_CHAR);
        Depth->AllocateDepth(unsigned(width), unsigned(height), vtkTextureObject::Float32);
        Width = width, Height = height, Steps = 0;
    }

    /* ==== ssgi ==================================================================================================== */
    const char *Open()
    {
        static const char *const vertex = "#version 330 core\n"
            "void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }\n";
        static const char *const fragment = "#version 330 core\n"
            "uniform sampler2D t_picture, t_depth, t_visible; uniform ivec2 u_origin; uniform float u_strength;\n"
            "out vec4 o_picture;\n"
            "void main() {\n"
            "    ivec2 p = ivec2(gl_FragCoord.xy) - u_origin;\n"
            "    float v = u_strength > 0.0 ? 1.0 + u_strength * (texelFetch(t_visible, p, 0).x - 1.0) : 1.0;\n"
            "    o_picture = texelFetch(t_picture, p, 0) * vec4(vec3(max(v, 0.0)), 1.0);\n"
            "    gl_FragDepth = texelFetch(t_depth, p, 0).x;\n"
            "}\n";
        std::string text[2];
        ssgi_gl_chain chain = {};
        const char *why = "";
        chain.desc.pass = SSGI_GL_PASS_HSAO;
        chain.desc.input.normal = SSGI_GL_NORMAL_FROM_DEPTH;
        chain.desc.input.orthographic = Orthographic;
        chain.blur = 1;
        chain.width = Width, chain.height = Height;
        if (ssgi_gl_preset(&chain.desc, Preset, &why)) return why;
        if (!(Steps = ssgi_gl_steps(Step, MOST, &chain, &why))) return why;
        if (Steps > MOST) return "the chain has more steps than SSGI_GL_MAX_STEPS";
        if (!Block) {
            glGenBuffers(1, &Block), glGenVertexArrays(1, &Array);
            glGenTextures(MOST, Texture), glGenFramebuffers(MOST, Framebuffer);
            Combined = ProgramOf(vertex, fragment);
            const char *const names[] = { "t_picture", "t_depth", "t_visible" };
            for (int i = 0; i < 3; ++i) glUniform1i(glGetUniformLocation(Combined, names[i]), i);
        }
        for (int i = 0; i < Steps; ++i) {
            const ssgi_gl_output &to = Step[i].output[0];       /* a step of hsao has one output */
            glBindTexture(GL_TEXTURE_2D, Texture[to.texture]);
            glTexImage2D(GL_TEXTURE_2D, 0, GLint(to.format->internal), Step[i].width, Step[i].height, 0,
                         to.format->format, to.format->type, nullptr);
            if (Compiled) continue;                           /* programs do not depend on the size, so they are kept */
            for (int k = 0; k < 2; ++k) {
                const size_t length = ssgi_gl_emit(nullptr, 0, &Step[i].desc, k);
                text[k].resize(length + 1);
                ssgi_gl_emit(&text[k][0], length + 1, &Step[i].desc, k);
            }
            glDeleteProgram(Program[i]);
            Program[i] = ProgramOf(text[SSGI_GL_STAGE_VERTEX].c_str(), text[SSGI_GL_STAGE_FRAGMENT].c_str());
            for (int k = 0; k < Step[i].inputs; ++k)
                glUniform1i(glGetUniformLocation(Program[i], Step[i].input[k].name), Step[i].input[k].unit);
            glUniformBlockBinding(Program[i], glGetUniformBlockIndex(Program[i], "ssgi_frame"), 0);
        }
        Compiled = 1;
        return nullptr;
    }

    const char *Occlude(vtkRenderer *renderer, vtkOpenGLCamera *camera, vtkOpenGLState *state, int width, int height)
    {
        vtkMatrix4x4 *toWorld, *toClip, *all;
        vtkMatrix3x3 *normals;
        ssgi_view view;
        ssgi_gl_frame frame;
        float projection[16];
        const char *why = "";
        camera->GetKeyMatrices(renderer, toWorld, normals, toClip, all);
        for (int i = 0; i < 16; ++i) projection[i] = float(toClip->GetData()[i]);   /* VTK stores it in GL's order */
        if (Orthographic != camera->GetParallelProjection()) {
            Orthographic = camera->GetParallelProjection();
            Steps = Compiled = 0;
        }
        if (!Steps && (why = Open()) != nullptr) return Steps = 0, why;
        if (ssgi_view_from_projection(&view, projection, SSGI_CLIP_GL, width, height, &why)
            || ssgi_gl_frame_init(&frame, &view, float(Radius), &why)) return why;
        glBindBufferBase(GL_UNIFORM_BUFFER, 0, Block);
        glBufferData(GL_UNIFORM_BUFFER, sizeof frame, &frame, GL_DYNAMIC_DRAW);
        glBindVertexArray(Array);
        for (int i = 0; i < Steps; ++i) {
            const GLuint to = Texture[Step[i].output[0].texture];
            for (int k = 0; k < Step[i].inputs; ++k) {          /* with this desc, depth is VTK's only texture */
                const ssgi_gl_input &in = Step[i].input[k];
                Bind(state, GLuint(in.unit), in.texture < 0 ? Depth->GetHandle() : Texture[in.texture]);
            }
            state->vtkglBindFramebuffer(GL_FRAMEBUFFER, Framebuffer[i]);
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, to, 0);
            state->vtkglViewport(0, 0, Step[i].width, Step[i].height);
            glUseProgram(Program[i]);
            glDrawArraysInstanced(Step[i].primitive, 0, Step[i].vertices, Step[i].instances);
        }
        return nullptr;
    }
    /* ============================================================================================================== */

    /* Binds a texture for reading. (3) VTK sets a vtkTextureObject's filters when it binds it; here GL binds it. */
    static void Bind(vtkOpenGLState *state, GLuint unit, GLuint texture)
    {
        state->vtkglActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_2D, texture);
        for (GLenum filter : { GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER })
            glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    }

    void Combine(vtkOpenGLState *state, GLuint into, int x, int y, int width, int height, double strength)
    {
        if (!Combined) return;
        const GLuint last = Steps ? Texture[Step[Steps - 1].output[0].texture] : 0;
        const GLuint textures[] = { Colour->GetHandle(), Depth->GetHandle(), last };
        for (GLuint i = 0; i < 3; ++i) Bind(state, i, textures[i]);
        state->vtkglBindFramebuffer(GL_FRAMEBUFFER, into);
        state->vtkglViewport(x, y, width, height);
        state->vtkglEnable(GL_DEPTH_TEST);                  /* GL only writes depth while it tests depth */
        state->vtkglDepthFunc(GL_ALWAYS);
        state->vtkglDepthMask(GL_TRUE);
        glUseProgram(Combined);
        glUniform2i(glGetUniformLocation(Combined, "u_origin"), x, y);
        glUniform1f(glGetUniformLocation(Combined, "u_strength"), float(strength));
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
};
#endif
