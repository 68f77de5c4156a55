/* vulkan.cpp - ambient visibility of a saved G-buffer by Vulkan, from the manifest and the SPIR-V of build/glsl-text.
   It draws any chain whose steps are triangles. vulkan_engine.hpp stands for the engine; the kit reads and writes
   pictures.
     build/glsl-text --chain hsao,depth=LINEAR --spv DIR    and    build/render SCENE --save-gbuffer FRAME.exr
     build/vulkan DIR FRAME.exr FOVY RADIUS OUT.exr|OUT.png [validate] */
#include <nlohmann/json.hpp>
#include "vulkan_engine.hpp"
using nlohmann::json;

struct step {
    json is; /* in the manifest */
    vk::raii::Pipeline pipeline = nullptr;
    uint32_t width = 0, height = 0, instances = 0;
    /* set by the caller: an image for each input that is yours; ssgi_gl_frame; for pass dss ssgi_surfel[] */
    std::vector<image *> yours;
    vk::Buffer frame, surfels;
};

struct chain {
    json is;
    std::vector<std::vector<image>> textures; /* a kept texture is two: this frame's, the last frame's */
    std::vector<step> steps;
};

/* Makes a step's textures and program. */
static step step_of(gpu &g, const std::string &folder, const json &manifest, chain &c, const json &is, int width,
                    int height, const vk::SpecializationInfo *constants)
{
    int size[2] = { width, height };
    if (is["scale"] == "HALF") size[0] = (width + 1) / 2, size[1] = (height + 1) / 2;
    if (is["scale"] == "QUARTER") size[0] = (width + 3) / 4, size[1] = (height + 3) / 4;
    if (is["scale"] == "TILES") size[0] = (width + 7) / 8, size[1] = (height + 7) / 8;
    if (is["scale"] == "LEVELS") {
        const int levels = c.is["chain"]["desc"].value("levels", manifest["defaults"]["dss"]["levels"].get<int>());
        const auto gathered = c.is["chain"]["desc"].value("resolution", std::string());
        const int part = gathered.empty() ? 1 : gathered[0] == 'Q' ? 4 : 2;
        ssgi_splat_size(size, (width + part - 1) / part, (height + part - 1) / part, levels, nullptr);
        size[1] *= levels;
    }
    step s;
    s.is = is;
    s.instances = is["instances"];
    s.yours.resize(is["inputs"].size());
    program p{};
    for (auto [stage, file] : { std::pair{ "vert", &p.vertex }, { "frag", &p.fragment }, { "comp", &p.compute } })
        if (is["files"].contains(stage)) *file = folder + "/" + is["files"][stage].get<std::string>() + ".spv";
    p.constants = constants;
    p.width = s.width = (uint32_t)size[0], p.height = s.height = (uint32_t)size[1];
    for (const json &row : is["rows"]) p.attributes += manifest["rows"][row.get<size_t>()]["kind"] == "ATTRIBUTE";
    if ((p.blends = !is["blend"].is_null())) {
        p.equation = is["blend"]["vulkan"][0].get<vk::BlendOp>();
        p.source = is["blend"]["vulkan"][1].get<vk::BlendFactor>();
        p.destination = is["blend"]["vulkan"][2].get<vk::BlendFactor>();
    }
    for (const json &o : is["outputs"]) {
        const json &t = c.is["textures"][o["texture"].get<size_t>()];
        std::vector<image> &made = c.textures[o["texture"]];
        p.targets.push_back(manifest["formats"][t["format"].get<size_t>()]["vulkan_number"].get<vk::Format>());
        while (made.size() <= t["kept"]) made.push_back(g.image_of(p.targets.back(), s.width, s.height, t["layers"]));
    }
    s.pipeline = g.pipeline_of(p);
    return s;
}

/* Makes the manifest's first chain for an image of that size. constants: replace the counts in its shaders. */
static chain chain_of(gpu &g, const std::string &folder, int width, int height, const vk::SpecializationInfo *constants)
{
    const json manifest = json::parse(file_of(folder + "/manifest.json"));
    chain c{ manifest["chains"].at(0), {}, {} };
    c.textures.resize(c.is["textures"].size());
    for (const json &is : c.is["steps"])
        c.steps.push_back(step_of(g, folder, manifest, c, is, width, height, constants));
    return c;
}

static void draw_step(gpu &g, chain &c, step &s)
{
    const vk::DescriptorBufferInfo block(s.frame, 0, VK_WHOLE_SIZE);
    std::vector<vk::WriteDescriptorSet> set{ { {}, 0, 0, vk::DescriptorType::eUniformBuffer, {}, block } };
    std::vector<vk::DescriptorImageInfo> read(s.yours.size()), written(s.is["outputs"].size());
    for (size_t k = 0; k < read.size(); ++k) {
        const json &in = s.is["inputs"][k];
        const std::vector<image> *made = in.contains("yours") ? nullptr : &c.textures[in["texture"]];
        const image *i = !made ? s.yours[k] : in["last"] == 1 ? &made->back() : &made->front();
        read[k] = vk::DescriptorImageInfo({}, *i->view, vk::ImageLayout::eGeneral);
        set.push_back({ {}, in["binding"], 0, vk::DescriptorType::eSampledImage, read[k] });
    }
    if (s.is.contains("group")) {
        for (size_t k = 0; k < written.size(); ++k) {
            const json &o = s.is["outputs"][k];
            const image &i = c.textures[o["texture"]].front();
            written[k] = vk::DescriptorImageInfo({}, *i.slice[o["layer"]], vk::ImageLayout::eGeneral);
            set.push_back({ {}, o["binding"], 0, vk::DescriptorType::eStorageImage, written[k] });
        }
        const uint32_t group[2] = { s.is["group"][0], s.is["group"][1] };
        g.barrier();
        g.commands.bindPipeline(vk::PipelineBindPoint::eCompute, *s.pipeline);
        g.commands.pushDescriptorSetKHR(vk::PipelineBindPoint::eCompute, *g.layout, g.set, set);
        g.commands.dispatch((s.width + group[0] - 1) / group[0], (s.height + group[1] - 1) / group[1], 1);
        return;
    }
    vk::RenderingAttachmentInfo target({}, vk::ImageLayout::eGeneral);
    std::vector<vk::RenderingAttachmentInfo> targets;
    target.loadOp = s.is["clear"].is_null() ? vk::AttachmentLoadOp::eLoad : vk::AttachmentLoadOp::eClear;
    if (!s.is["clear"].is_null()) target.clearValue.color.float32.fill(s.is["clear"]);
    for (const json &o : s.is["outputs"]) {
        target.imageView = *c.textures[o["texture"]].front().slice[o["layer"]];
        targets.push_back(target);
    }
    g.barrier();
    g.commands.beginRendering({ {}, { {}, { s.width, s.height } }, 1, 0, targets });
    g.commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *s.pipeline);
    g.commands.pushDescriptorSetKHR(vk::PipelineBindPoint::eGraphics, *g.layout, g.set, set);
    if (s.surfels) g.commands.bindVertexBuffers(0, s.surfels, vk::DeviceSize{ 0 });
    g.commands.draw(s.is["vertices"], s.instances, 0, 0);
    g.commands.endRendering();
}

static void draw(gpu &g, chain &c)
{
    for (std::vector<image> &t : c.textures) std::reverse(t.begin(), t.end());
    g.run([&] {
        for (step &s : c.steps) draw_step(g, c, s);
    });
}

/* Rows run from the bottom, as in GL, so that the noise is build/render's. If yours run from the top, give a projection
   with y down. */
static void picture(gpu &g, const char *folder, const kit_image &frame, double fovy, float radius, const char *out)
{
    const float f = (float)(1 / tan(fovy * KIT_PI / 360)), wide = (float)frame.width / (float)frame.height;
    const float projection[16] = { f / wide, 0, 0, 0, 0, f, 0, 0, 0, 0, -1, -1, 0, 0, -1e-3f, 0 };
    const char *why = "";
    ssgi_view view;
    ssgi_gl_frame block;
    must(ssgi_view_from_projection(&view, projection, SSGI_CLIP_ZERO, frame.width, frame.height, &why) == SSGI_OK, why);
    must(ssgi_gl_frame_init(&block, &view, radius, &why) == SSGI_OK, why);
    std::map<std::string, image> yours;
    yours["DEPTH"] = image_of(g, frame, vk::Format::eR32Sfloat, { "Z" });
    yours["NORMAL"] = image_of(g, frame, vk::Format::eR32G32B32A32Sfloat, { "N.X", "N.Y", "N.Z", "" });
    const buffer uniforms = g.buffer_of(sizeof block, &block);
    chain c = chain_of(g, folder, frame.width, frame.height, nullptr);
    must(c.is["chain"]["desc"].value("depth", "") == "LINEAR", "the chain needs depth=LINEAR, which a frame has");
    for (step &s : c.steps) {
        s.frame = *uniforms.buffer;
        for (size_t k = 0; k < s.yours.size(); ++k) {
            const std::string meaning = s.is["inputs"][k].value("yours", "");
            must(meaning.empty() || yours.count(meaning), "the chain asks for " + meaning + ", which is not here");
            if (!meaning.empty()) s.yours[k] = &yours[meaning];
        }
    }
    draw(g, c);
    for (size_t t = 0; t < c.textures.size(); ++t)
        if (c.is["textures"][t]["result"] == "LIGHT") write(g, c.textures[t].front(), out);
}

int main(int argc, char **argv)
{
    try {
        const double fovy = argc > 3 ? atof(argv[3]) : 0;
        must(argc > 5 && fovy > 0 && fovy < 180, "usage: vulkan DIR FRAME.exr FOVY RADIUS OUT.exr|OUT.png [validate]");
        const saved_frame frame(argv[2]);
        const json manifest = json::parse(file_of(std::string(argv[1]) + "/manifest.json")),
                   desc = manifest["chains"].at(0)["chain"]["desc"];
        must(desc.value("block_set", 0) == desc.value("texture_set", 0), "one set is pushed: block_set=texture_set");
        const bool computes = desc.contains("compute");
        must(!computes || (!desc.value("dense", 0) && desc.value("output_set", 0) == desc.value("block_set", 0)),
             "one set of fixed bindings is pushed: compute with dense=0, output_set=block_set");
        gpu g(argc > 6, desc.value("block_set", 0u), desc.value("dense", 0) ? 1 : 2, computes);
        picture(g, argv[1], frame.image, fovy, (float)atof(argv[4]), argv[5]);
    } catch (const std::exception &e) {
        std::cerr << "vulkan: " << e.what() << "\n";
        return 2;
    }
    return messages > 0;
}
