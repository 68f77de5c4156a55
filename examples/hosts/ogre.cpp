/* ogre.cpp - ambient occlusion in Ogre 1.12, whose materials set uniforms by name and have no uniform blocks. A
   compositor draws normals and depth of the boxes of boxes.h, then the steps of ssgi as quads, then shows the result.
   In a material of yours TextureUnitState::setCompositorReference fetches it, to multiply ambient light alone. Debian:
   libogre-1.12-dev. OpenGL in Ogre needs a display, such as Xvfb's.
     c++ -std=c++17 examples/hosts/ogre.cpp -isystem /usr/include/OGRE -lOgreMain -o ogre && \
     OGRE_PLUGIN_DIR=$(pkg-config --variable=plugindir OGRE) ./ogre FILE.png       draws two sizes, writes the second */
#include <Ogre.h>
#include <cstdio>
#include <cstring>
#define SSGI_IMPLEMENTATION
#define SSGI_GL_IMPLEMENTATION
#include "../../ssgi_gl.h"
using namespace Ogre;

static Pass *new_material(const String &name, const char *vertex, const char *fragment, int textures)
{
    Pass *pass = MaterialManager::getSingleton().create(name, RGN_DEFAULT)->getTechnique(0)->getPass(0);
    for (GpuProgramType type : { GPT_VERTEX_PROGRAM, GPT_FRAGMENT_PROGRAM }) {
        auto program = HighLevelGpuProgramManager::getSingleton().createProgram(name + (type ? " fragment" : " vertex"),
                                                                                RGN_DEFAULT, "glsl", type);
        program->setSource(type ? fragment : vertex), pass->setGpuProgram(type, program);
    }
    for (int i = 0; i < textures; ++i)  /* linear filters read textures of integers as 0 */
        pass->createTextureUnitState()->setTextureFiltering(TFO_NONE);
    return pass->setCullingMode(CULL_NONE), pass;
}

static CompositionTargetPass *new_target(CompositionTechnique *to, const String &name, int width, int height,
                                         const PixelFormatList &formats)
{
    auto *texture = to->createTextureDefinition(name);
    texture->width = width, texture->height = height, texture->formatList = formats;
    auto *target = to->createTargetPass();
    return target->setOutputName(name), target;
}

/* ==== ssgi ======================================================================================================== */
struct Occlusion : CompositorInstance::Listener {
    ssgi_gl_step step[SSGI_GL_MAX_STEPS];
    ssgi_gl_frame frame;
    Camera *camera;
    int width, height, steps;
    float radius = 1;   /* the distance of the farthest occluders */

    /* Gets the steps and the frame's values. The engine's own projection has y up, but row 0 of its render textures is
       the top of the picture. */
    void look()
    {
        const Matrix4 columns = camera->getProjectionMatrixWithRSDepth().transpose();
        const char *why = "", *const method = "hsao,normal=unsigned,uniforms=loose";
        ssgi_view view;
        if (ssgi_view_from_projection(&view, columns[0], SSGI_CLIP_GL + SSGI_CLIP_ROWS_DOWN, width, height, &why)
            || !(steps = ssgi_gl_steps_of(step, SSGI_GL_MAX_STEPS, &frame, method, &view, radius, &why)))
            throw std::runtime_error(why);
    }

    /* Adds the steps to a compositor whose texture "scene" has normals and depth; returns the name of the result. */
    String add(CompositionTechnique *to)
    {
        static const std::map<String, PixelFormat> formats = { { "RGBA32UI", PF_R32G32B32A32_UINT },
                                                               { "RG16F", PF_FLOAT16_GR }, { "R8", PF_R8 } };
        static char text[2][32768];
        const auto name_of = [](int texture) { return texture < 0 ? "scene" : "ssgi " + std::to_string(texture); };
        String name;
        look();
        for (const ssgi_gl_step *s = step; s < step + steps; ++s) {
            name = name_of(s->output[0].texture);       /* hsao's steps have one output each */
            if (!MaterialManager::getSingleton().resourceExists(name, RGN_DEFAULT)) {   /* none depends on the size */
                for (int k = 0; k < 2; ++k) ssgi_gl_emit(text[k], sizeof text[k], &s->desc, k);
                Pass *pass = new_material(name, text[SSGI_GL_STAGE_VERTEX], text[SSGI_GL_STAGE_FRAGMENT], s->inputs);
                pass->setDepthCheckEnabled(false), pass->setDepthWriteEnabled(false);
                for (int k = 0; k < s->inputs; ++k)
                    pass->getFragmentProgramParameters()->setNamedConstant(s->input[k].name, k);
            }
            auto *target = new_target(to, name, s->width, s->height, { formats.at(s->output[0].format->name) });
            auto *quad = target->createPass(CompositionPass::PT_RENDERQUAD);
            quad->setMaterialName(name), quad->setIdentifier(s - step + 1);
            for (int k = 0; k < s->inputs; ++k)
                quad->setInput(k, name_of(s->input[k].texture), s->input[k].meaning == SSGI_GL_YOUR_DEPTH);
        }
        return name;
    }

    /* Ogre calls it before each quad, with its identifier; that of others is 0. */
    void notifyMaterialRender(uint32 quad, MaterialPtr &material) override
    {
        const auto set = material->getTechnique(0)->getPass(0)->getFragmentProgramParameters();
        ssgi_gl_io row[SSGI_GL_MAX_IO];
        if (!quad) return;
        if (quad == 1) look();
        for (int k = 0, rows = ssgi_gl_reflect(&step[quad - 1].desc, row, SSGI_GL_MAX_IO); k < rows; ++k) {
            if (row[k].kind != SSGI_GL_IO_PARAM) continue;
            const char *digit = std::strpbrk(row[k].type, "24");        /* of float, vec4, ivec2 .. */
            const int count = digit ? *digit - '0' : 1;
            const void *at = reinterpret_cast<const char *>(&frame) + row[k].offset;
            if (*row[k].type == 'i') set->setNamedConstant(row[k].name, static_cast<const int *>(at), 1, count);
            else set->setNamedConstant(row[k].name, static_cast<const float *>(at), 1, count);
        }
    }
};

/* ================================================================================================================== */
int main(int argc, char **argv)
{
    const char *plugins = std::getenv("OGRE_PLUGIN_DIR");
    if (argc != 2 || !plugins) return std::fputs("usage: OGRE_PLUGIN_DIR=FOLDER ogre FILE.png\n", stderr), 2;
    LogManager logs;
    logs.createLog("", true, false, true);
    Root root("", "", "");
    for (const char *name : { "/RenderSystem_GL3Plus", "/Codec_STBI" }) root.loadPlugin(plugins + String(name));
    root.setRenderSystem(root.getAvailableRenderers()[0]);
    root.initialise(false);
    root.createRenderWindow("ssgi", 64, 64, false);
    SceneManager *scene = root.createSceneManager();
    Pass *both = new_material("boxes",
                              "#version 330\nuniform mat4 to, view; in vec4 vertex; in vec3 normal; out vec3 n;\n"
                              "void main() { gl_Position = to * vertex; n = mat3(view) * normal; }\n",
                              "#version 330\nin vec3 n; layout(location = 0) out vec4 o;"
                              "layout(location = 1) out float z;\n"
                              "void main() { o = vec4(normalize(n) * 0.5 + 0.5, 0); z = gl_FragCoord.z; }\n", 0);
    both->getVertexProgramParameters()->setNamedAutoConstant("to", GpuProgramParameters::ACT_WORLDVIEWPROJ_MATRIX);
    both->getVertexProgramParameters()->setNamedAutoConstant("view", GpuProgramParameters::ACT_WORLDVIEW_MATRIX);
    new_material("show", "#version 330\nin vec4 vertex; void main() { gl_Position = vertex; }\n",
                 "#version 330\nuniform sampler2D result; out vec4 picture;\n"
                 "void main() { picture = texelFetch(result, ivec2(gl_FragCoord.xy), 0).rrra; }\n", 1);
    for (int i = 0; i < 25; ++i) {
        const Vector3 half(0.35f + 0.05f * (i * 3 % 8), 0.2f + 0.2f * (i * 7 % 5), 0.35f + 0.05f * (i * 5 % 7));
        const Vector3 at(1.5f * (i % 5 - 2), half.y, 1.5f * (i / 5 - 2));
        SceneNode *node = scene->getRootSceneNode()->createChildSceneNode(i ? at : Vector3(0, -0.1f, 0));
        Entity *box = scene->createEntity(SceneManager::PT_CUBE);       /* 100 units wide */
        node->setScale((i ? half : Vector3(4.5f, 0.1f, 4.5f)) / 50);    /* 0 is the slab */
        node->attachObject(box), box->setMaterialName("boxes");
    }
    Occlusion occlusion;
    Camera *camera = occlusion.camera = scene->createCamera("eye");
    SceneNode *eye = scene->getRootSceneNode()->createChildSceneNode(Vector3(0, 6, 8));
    eye->attachObject(camera), eye->lookAt(Vector3::ZERO, Node::TS_WORLD);
    camera->setFOVy(Degree(45)), camera->setNearClipDistance(0.1f), camera->setFarClipDistance(100);
    for (const int w : { 800, 960 }) {
        const int h = w * 9 / 16;
        const String name = std::to_string(w);
        auto *technique = CompositorManager::getSingleton().create(name, RGN_DEFAULT)->createTechnique();
        occlusion.width = w, occlusion.height = h, camera->setAspectRatio(Real(w) / h);
        auto *target = new_target(technique, "scene", w, h, { PF_BYTE_RGBA, PF_FLOAT32_R });
        target->createPass(CompositionPass::PT_CLEAR)->setClearColour(ColourValue::White);
        target->createPass(CompositionPass::PT_RENDERSCENE);
        const String result = occlusion.add(technique);
        auto *quad = technique->getOutputTargetPass()->createPass(CompositionPass::PT_RENDERQUAD);
        quad->setMaterialName("show"), quad->setInput(0, result);
        auto picture = TextureManager::getSingleton().createManual(name, RGN_DEFAULT, TEX_TYPE_2D, w, h, 0, PF_BYTE_RGB,
                                                                   TU_RENDERTARGET);
        RenderTarget *into = picture->getBuffer()->getRenderTarget();
        auto *instance = CompositorManager::getSingleton().addCompositor(into->addViewport(camera), name);
        instance->addListener(&occlusion), instance->setEnabled(true);
        into->update(), into->writeContentsToFile(argv[1]);
    }
}
