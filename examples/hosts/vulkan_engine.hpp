/* vulkan_engine.hpp - the engine of vulkan.cpp, without ssgi: Vulkan 1.3 without a window, images, buffers and
   programs, each as simple as possible. The kit makes its G-buffer and writes its images. Every image always has layout
   GENERAL, and each submit waits. */
#ifndef VULKAN_ENGINE_HPP
#define VULKAN_ENGINE_HPP

#include <fstream>
#include <iostream>
#include <map>
#include <vulkan/vulkan_raii.hpp>
extern "C" {
#include "kit/kit.h"
#include "ssgi_gl.h"
}

/* Throws why unless good is true. why is a reference, because the call that computes good sets it. */
static inline void must(bool good, const char *const &why)
{
    if (!good) throw std::runtime_error(why);
}

static inline void must(bool good, const std::string &why) { must(good, why.c_str()); }

static inline std::string file_of(const std::string &path)
{
    std::ifstream file(path, std::ios::binary);
    const std::string data{ std::istreambuf_iterator<char>(file), {} };
    must(!data.empty(), path + ": cannot be read");
    return data;
}

struct image {                                              /* slice: views of one layer each, to draw into */
    vk::raii::Image image = nullptr;
    vk::raii::DeviceMemory memory = nullptr;
    vk::raii::ImageView view = nullptr;
    std::vector<vk::raii::ImageView> slice;
    vk::Format format;
    uint32_t width, height, slices;
};

struct buffer {                                             /* always mapped */
    vk::raii::Buffer buffer = nullptr;
    vk::raii::DeviceMemory memory = nullptr;
    void *data;
};

struct program {
    std::string vertex, fragment;                           /* files of SPIR-V */
    const vk::SpecializationInfo *constants;          /* values of the shaders' constants; NULL: those in the shaders */
    uint32_t attributes;                                    /* vec4s an instance, consecutive */
    bool blends;
    vk::BlendOp equation;
    vk::BlendFactor source, destination;
    std::vector<vk::Format> targets;
    uint32_t width, height;                                 /* of the viewport */
};

static int messages;                                        /* of the validation layer */
static VkBool32 heard(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                      const VkDebugUtilsMessengerCallbackDataEXT *data, void *)
{
    std::cerr << "vulkan: " << data->pMessage << "\n";
    ++messages;
    return VK_FALSE;
}

struct gpu {
    vk::raii::Context context;
    vk::raii::Instance instance = nullptr;
    vk::raii::DebugUtilsMessengerEXT messenger = nullptr;
    vk::raii::PhysicalDevice physical = nullptr;
    vk::raii::Device device = nullptr;
    vk::raii::Queue queue = nullptr;
    vk::raii::CommandPool pool = nullptr;
    vk::raii::CommandBuffer commands = nullptr;
    /* every program's bindings, in set `set`: blocks from binding 0 on, then textures; the sets before it are empty */
    vk::raii::DescriptorSetLayout bindings = nullptr, nothing = nullptr;
    vk::raii::PipelineLayout layout = nullptr;
    uint32_t set;

    /* Opens the first device. blocks: the number of bindings before those of textures. */
    explicit gpu(bool validate, uint32_t set_ = 0, uint32_t blocks = 2) : set(set_)
    {
        using severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
        using type = vk::DebugUtilsMessageTypeFlagBitsEXT;
        const std::vector<const char *> layers(validate, "VK_LAYER_KHRONOS_validation");
        const std::vector<const char *> debug(validate, "VK_EXT_debug_utils"), push{ "VK_KHR_push_descriptor" };
        const vk::ApplicationInfo application({}, {}, {}, {}, VK_API_VERSION_1_3);
        instance = { context, vk::InstanceCreateInfo({}, &application, layers, debug) };
        const vk::DebugUtilsMessengerCreateInfoEXT hears({}, severity::eWarning | severity::eError,
                                                         type::eGeneral | type::eValidation, heard);
        if (validate) messenger = { instance, hears };
        physical = std::move(vk::raii::PhysicalDevices(instance).at(0));
        const auto families = physical.getQueueFamilyProperties();
        uint32_t family = 0;
        while (!(families.at(family).queueFlags & vk::QueueFlagBits::eGraphics)) ++family;
        const float priority = 1;
        const vk::DeviceQueueCreateInfo queues({}, family, 1, &priority);
        vk::PhysicalDeviceVulkan13Features features;
        features.dynamicRendering = true;
        device = { physical, vk::DeviceCreateInfo({}, queues, {}, push, {}, &features) };
        queue = device.getQueue(family, 0);
        pool = { device, { vk::CommandPoolCreateFlagBits::eResetCommandBuffer, family } };
        commands = std::move(vk::raii::CommandBuffers(device, { *pool, vk::CommandBufferLevel::ePrimary, 1 }).at(0));
        std::vector<vk::DescriptorSetLayoutBinding> all;
        for (uint32_t i = 0; i < 18; ++i)
            all.push_back({ i, i < blocks ? vk::DescriptorType::eUniformBuffer : vk::DescriptorType::eSampledImage, 1,
                            vk::ShaderStageFlagBits::eAllGraphics });
        bindings = { device, { vk::DescriptorSetLayoutCreateFlagBits::ePushDescriptorKHR, all } };
        nothing = { device, vk::DescriptorSetLayoutCreateInfo() };
        std::vector<vk::DescriptorSetLayout> sets(set, *nothing);
        sets.push_back(*bindings);
        layout = { device, { {}, sets } };
    }

    /* Makes all writes visible to all later commands. */
    void barrier()
    {
        using stage = vk::PipelineStageFlagBits;
        using access = vk::AccessFlagBits;
        const vk::MemoryBarrier all(access::eMemoryWrite, access::eMemoryRead | access::eMemoryWrite);
        commands.pipelineBarrier(stage::eAllCommands, stage::eAllCommands | stage::eHost, {}, all, {}, {});
    }

    template <class F> void run(F record)
    {
        commands.begin(vk::CommandBufferBeginInfo());
        record();
        barrier();
        commands.end();
        queue.submit(vk::SubmitInfo({}, {}, *commands));
        queue.waitIdle();
    }

    template <class T> vk::raii::DeviceMemory memory_of(const T &object, vk::MemoryPropertyFlags flags)
    {
        const auto needs = object.getMemoryRequirements();
        const auto has = physical.getMemoryProperties();
        uint32_t i = 0;
        while (!(needs.memoryTypeBits >> i & 1) || (has.memoryTypes.at(i).propertyFlags & flags) != flags) ++i;
        vk::raii::DeviceMemory memory(device, { needs.size, i });
        object.bindMemory(*memory, 0);
        return memory;
    }

    buffer buffer_of(size_t size, const void *data)
    {
        using use = vk::BufferUsageFlagBits;
        using memory = vk::MemoryPropertyFlagBits;
        const auto uses = use::eUniformBuffer | use::eVertexBuffer | use::eTransferSrc | use::eTransferDst;
        buffer b;
        b.buffer = { device, { {}, size, uses } };
        b.memory = memory_of(b.buffer, memory::eHostVisible | memory::eHostCoherent);
        b.data = b.memory.mapMemory(0, VK_WHOLE_SIZE);
        if (data) memcpy(b.data, data, size);
        return b;
    }

    /* Returns an image of zeros. layers 0: 2D; else an array of that many layers, perhaps one. */
    image image_of(vk::Format format, uint32_t width, uint32_t height, uint32_t layers)
    {
        using use = vk::ImageUsageFlagBits;
        using stage = vk::PipelineStageFlagBits;
        const auto uses = use::eSampled | use::eColorAttachment | use::eTransferSrc | use::eTransferDst;
        const auto flat = vk::ImageViewType::e2D, array = vk::ImageViewType::e2DArray;
        const vk::ImageSubresourceRange all(vk::ImageAspectFlagBits::eColor, 0, 1, 0, layers ? layers : 1);
        image i;
        i.image = { device, { {}, vk::ImageType::e2D, format, { width, height, 1 }, 1, all.layerCount,
                              vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal, uses } };
        i.memory = memory_of(i.image, vk::MemoryPropertyFlagBits::eDeviceLocal);
        i.view = { device, { {}, *i.image, layers ? array : flat, format, {}, all } };
        for (uint32_t k = 0; k < all.layerCount; ++k)
            i.slice.push_back({ device, { {}, *i.image, flat, format, {}, { all.aspectMask, 0, 1, k, 1 } } });
        i.format = format, i.width = width, i.height = height, i.slices = all.layerCount;
        const vk::ImageMemoryBarrier begins({}, vk::AccessFlagBits::eTransferWrite, {}, vk::ImageLayout::eGeneral,
                                            VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED, *i.image, all);
        run([&] {
            commands.pipelineBarrier(stage::eTopOfPipe, stage::eTransfer, {}, {}, {}, begins);
            commands.clearColorImage(*i.image, vk::ImageLayout::eGeneral, vk::ClearColorValue(), all);
        });
        return i;
    }

    /* Copies all texels into the image or out of it. */
    void copy(image &i, void *texels, size_t size, bool in)
    {
        const buffer b = buffer_of(size, in ? texels : nullptr);
        const vk::BufferImageCopy all(0, 0, 0, { vk::ImageAspectFlagBits::eColor, 0, 0, i.slices }, {},
                                      { i.width, i.height, 1 });
        run([&] {
            if (in) commands.copyBufferToImage(*b.buffer, *i.image, vk::ImageLayout::eGeneral, all);
            else commands.copyImageToBuffer(*i.image, vk::ImageLayout::eGeneral, *b.buffer, all);
        });
        if (!in) memcpy(texels, b.data, size);
    }

    vk::raii::ShaderModule module_of(const std::string &path)
    {
        const std::string code = file_of(path);
        return { device, { {}, code.size(), (const uint32_t *)(const void *)code.data() } };
    }

    /* Returns a pipeline that draws triangles over the whole viewport. */
    vk::raii::Pipeline pipeline_of(const program &p)
    {
        const auto vertex = module_of(p.vertex), fragment = module_of(p.fragment);
        const std::vector<vk::PipelineShaderStageCreateInfo> stages{
            { {}, vk::ShaderStageFlagBits::eVertex, *vertex, "main", p.constants },
            { {}, vk::ShaderStageFlagBits::eFragment, *fragment, "main", p.constants }
        };
        const vk::VertexInputBindingDescription binding(0, 16 * p.attributes, vk::VertexInputRate::eInstance);
        std::vector<vk::VertexInputAttributeDescription> attributes;
        for (uint32_t i = 0; i < p.attributes; ++i)
            attributes.push_back({ i, 0, vk::Format::eR32G32B32A32Sfloat, 16 * i });
        vk::PipelineVertexInputStateCreateInfo input({}, binding, attributes);
        if (!p.attributes) input.vertexBindingDescriptionCount = 0;
        const vk::PipelineInputAssemblyStateCreateInfo assembly({}, vk::PrimitiveTopology::eTriangleList);
        const vk::Viewport viewport(0, 0, (float)p.width, (float)p.height, 0, 1);
        const vk::Rect2D scissor({}, { p.width, p.height });
        const vk::PipelineViewportStateCreateInfo view({}, viewport, scissor);
        vk::PipelineRasterizationStateCreateInfo raster;
        raster.lineWidth = 1;
        const vk::PipelineMultisampleStateCreateInfo samples({}, vk::SampleCountFlagBits::e1);
        using channel = vk::ColorComponentFlagBits;
        const vk::PipelineColorBlendAttachmentState blend(p.blends, p.source, p.destination, p.equation, p.source,
            p.destination, p.equation, channel::eR | channel::eG | channel::eB | channel::eA);
        const std::vector<vk::PipelineColorBlendAttachmentState> blends(p.targets.size(), blend);
        const vk::PipelineColorBlendStateCreateInfo blending({}, false, {}, blends);
        const vk::PipelineRenderingCreateInfo targets(0, p.targets);
        return { device, nullptr, { {}, stages, &input, &assembly, {}, &view, &raster, &samples, {}, &blending, {},
                                    *layout, {}, {}, {}, {}, &targets } };
    }
};

struct saved_frame {
    kit_image image;

    explicit saved_frame(const char *path)
    {
        kit_error err;
        must(!kit_exr_read(&image, path, &err), err.text);
    }

    ~saved_frame() { kit_image_free(&image); }
    saved_frame(const saved_frame &) = delete;
};

/* Uploads channels of a saved frame as an image; the name "" gives zeros. The last row is first, as in GL. */
static inline image image_of(gpu &g, const kit_image &frame, vk::Format format, const std::vector<const char *> &names)
{
    const size_t width = (size_t)frame.width, pixels = width * (size_t)frame.height, n = names.size();
    std::vector<float> texels(pixels * n);
    for (size_t c = 0; c < n; ++c) {
        const float *from = kit_image_channel(&frame, names[c]);
        must(from || !*names[c], std::string("the frame has no channel ") + names[c]);
        for (size_t i = 0; from && i < pixels; ++i)
            texels[(pixels - (i / width + 1) * width + i % width) * n + c] = from[i];
    }
    image i = g.image_of(format, (uint32_t)width, (uint32_t)frame.height, 0);
    g.copy(i, texels.data(), texels.size() * sizeof(float), true);
    return i;
}

/* Writes an image of one channel, bytes or floats, to a .png or .exr, in which the image's first row is the last. */
static inline void write(gpu &g, image &i, const std::string &path)
{
    const size_t width = i.width, pixels = width * i.height;
    const bool floats = i.format == vk::Format::eR32Sfloat, png = path.ends_with(".png");
    std::vector<float> texels(pixels);
    const uint8_t *bytes = (const uint8_t *)texels.data();
    kit_image picture;
    kit_error err = { "" };
    must(floats || i.format == vk::Format::eR8Unorm, vk::to_string(i.format) + ": is not a picture's here");
    must(!kit_image_new(&picture, (int)width, (int)i.height, "Y", &err), err.text);
    g.copy(i, texels.data(), pixels * (floats ? 4 : 1), false);
    for (size_t k = 0; k < pixels; ++k)
        picture.data[pixels - (k / width + 1) * width + k % width] = floats ? texels[k] : (float)bytes[k] / 255;
    const int failed = png ? kit_png_write(&picture, "Y", 0, path.c_str(), &err)
                           : kit_exr_write(&picture, path.c_str(), &err);
    kit_image_free(&picture);
    must(!failed, err.text);
}

#endif
