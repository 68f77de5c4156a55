/* compile.c - compiles pipelines. The bindings, attributes and targets that a pipeline needs are read from its SPIR-V.
   Declared in compile.h. */
#include "lab/cost/compile.h"
#include <glslang/Include/glslang_c_interface.h>
#include <glslang/Public/resource_limits_c.h>
#include <glob.h>
#include <spirv_cross/spirv_cross_c.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

double compile_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* ---- SPIR-V ------------------------------------------------------------------------------------------------------ */

int spirv_read(spirv *s, const char *path, kit_error *err)
{
    static const struct { const char *ending; VkShaderStageFlagBits stage; } endings[] = {
        { ".vert.spv", VK_SHADER_STAGE_VERTEX_BIT }, { ".tesc.spv", VK_SHADER_STAGE_TESSELLATION_CONTROL_BIT },
        { ".tese.spv", VK_SHADER_STAGE_TESSELLATION_EVALUATION_BIT }, { ".geom.spv", VK_SHADER_STAGE_GEOMETRY_BIT },
        { ".frag.spv", VK_SHADER_STAGE_FRAGMENT_BIT }, { ".comp.spv", VK_SHADER_STAGE_COMPUTE_BIT }
    };
    const size_t length = strlen(path);
    memset(s, 0, sizeof *s);
    for (size_t i = 0; i < sizeof endings / sizeof *endings; ++i) {
        const size_t n = strlen(endings[i].ending);
        if (length > n && !strcmp(path + length - n, endings[i].ending)) s->stage = endings[i].stage;
    }
    if (!s->stage) return kit_fail(err, "%s: must end in .frag.spv, or another stage's letters and .spv", path);
    char *bytes;
    size_t size;
    if (kit_file_read(&bytes, &size, path, err)) return -1;
    s->word = (uint32_t *)(void *)bytes;
    s->count = size / sizeof *s->word;
    return s->count < 5 || s->word[0] != 0x07230203 ? kit_fail(err, "%s: is not SPIR-V", path) : 0;
}

static glslang_stage_t glslang_stage_of(VkShaderStageFlagBits stage)
{
    return stage == VK_SHADER_STAGE_VERTEX_BIT                    ? GLSLANG_STAGE_VERTEX
         : stage == VK_SHADER_STAGE_TESSELLATION_CONTROL_BIT      ? GLSLANG_STAGE_TESSCONTROL
         : stage == VK_SHADER_STAGE_TESSELLATION_EVALUATION_BIT   ? GLSLANG_STAGE_TESSEVALUATION
         : stage == VK_SHADER_STAGE_GEOMETRY_BIT                  ? GLSLANG_STAGE_GEOMETRY
         : stage == VK_SHADER_STAGE_COMPUTE_BIT                   ? GLSLANG_STAGE_COMPUTE
                                                                  : GLSLANG_STAGE_FRAGMENT;
}

int spirv_make(spirv *s, const char *text, VkShaderStageFlagBits stage, int relaxed, kit_error *err)
{
    const glslang_messages_t rules = GLSLANG_MSG_SPV_RULES_BIT | GLSLANG_MSG_VULKAN_RULES_BIT;
    const glslang_input_t input = {
        .language = GLSLANG_SOURCE_GLSL, .stage = glslang_stage_of(stage), .client = GLSLANG_CLIENT_VULKAN,
        .client_version = GLSLANG_TARGET_VULKAN_1_0, .target_language = GLSLANG_TARGET_SPV,
        .target_language_version = GLSLANG_TARGET_SPV_1_0, .code = text, .default_version = 450,
        .default_profile = GLSLANG_NO_PROFILE, .messages = rules, .resource = glslang_default_resource()
    };
    glslang_spv_options_t options = { .disable_optimizer = true };
    glslang_shader_t *shader = glslang_shader_create(&input);
    glslang_program_t *program = glslang_program_create();
    int failed = 0;
    *s = (spirv) { NULL, 0, stage };
    if (relaxed)
        glslang_shader_set_options(shader, GLSLANG_SHADER_AUTO_MAP_BINDINGS | GLSLANG_SHADER_AUTO_MAP_LOCATIONS
                                           | GLSLANG_SHADER_VULKAN_RULES_RELAXED);
    if (!glslang_shader_preprocess(shader, &input) || !glslang_shader_parse(shader, &input))
        failed = kit_fail(err, "glslang: %.900s", glslang_shader_get_info_log(shader));
    if (!failed) {
        glslang_program_add_shader(program, shader);
        if (!glslang_program_link(program, (int)rules) || (relaxed && !glslang_program_map_io(program)))
            failed = kit_fail(err, "glslang: %.900s", glslang_program_get_info_log(program));
    }
    if (!failed) {
        glslang_program_SPIRV_generate_with_options(program, input.stage, &options);
        s->count = glslang_program_SPIRV_get_size(program);
        s->word = malloc(s->count * sizeof *s->word);
        if (s->word) glslang_program_SPIRV_get(program, s->word);
        else failed = kit_fail(err, "out of memory");
    }
    glslang_program_delete(program);
    glslang_shader_delete(shader);
    return failed;
}

int spirv_triangle(spirv *s, kit_error *err)
{
    return spirv_make(s, "#version 450\nvoid main() { gl_Position = vec4(0); }\n", VK_SHADER_STAGE_VERTEX_BIT, 0, err);
}

/* ---- the needs of a pipeline ------------------------------------------------------------------------------------- */

enum { MOST_BINDINGS = 64, MOST_GROUPS = 4, MOST_PLACES = 16 };

typedef struct needs {
    VkDescriptorSetLayoutBinding binding[MOST_GROUPS][MOST_BINDINGS];
    uint32_t bindings[MOST_GROUPS];
    VkVertexInputAttributeDescription attribute[MOST_PLACES];
    VkFormat target[8];
    uint32_t attributes, targets;
    VkShaderStageFlags push;
} needs;

static void add_binding(needs *n, spvc_compiler of, const spvc_reflected_resource *r, VkDescriptorType kind,
                        VkShaderStageFlagBits stage)
{
    const spvc_type type = spvc_compiler_get_type_handle(of, r->type_id);
    const uint32_t group = spvc_compiler_get_decoration(of, r->id, SpvDecorationDescriptorSet),
                   binding = spvc_compiler_get_decoration(of, r->id, SpvDecorationBinding),
                   count = spvc_type_get_num_array_dimensions(type) ? spvc_type_get_array_dimension(type, 0) : 1;
    const int is_image = spvc_type_get_basetype(type) == SPVC_BASETYPE_IMAGE
                      || spvc_type_get_basetype(type) == SPVC_BASETYPE_SAMPLED_IMAGE;
    if (group >= MOST_GROUPS) return;
    if (is_image && spvc_type_get_image_dimension(type) == SpvDimBuffer)
        kind = kind == VK_DESCRIPTOR_TYPE_STORAGE_IMAGE ? VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER
                                                        : VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
    for (uint32_t i = 0; i < n->bindings[group]; ++i)
        if (n->binding[group][i].binding == binding) {
            n->binding[group][i].stageFlags |= stage;
            return;
        }
    if (n->bindings[group] == MOST_BINDINGS) return;
    n->binding[group][n->bindings[group]++] =
        (VkDescriptorSetLayoutBinding) { binding, kind, count, stage, NULL };
}

/* Returns the widest format of a scalar, a vector or a matrix' column; half: 16 bits for a float. */
static VkFormat format_of(spvc_type type, int half)
{
    static const VkFormat formats[3][4] = {
        { VK_FORMAT_R32_SFLOAT, VK_FORMAT_R32G32_SFLOAT, VK_FORMAT_R32G32B32_SFLOAT, VK_FORMAT_R32G32B32A32_SFLOAT },
        { VK_FORMAT_R32_SINT, VK_FORMAT_R32G32_SINT, VK_FORMAT_R32G32B32_SINT, VK_FORMAT_R32G32B32A32_SINT },
        { VK_FORMAT_R32_UINT, VK_FORMAT_R32G32_UINT, VK_FORMAT_R32G32B32_UINT, VK_FORMAT_R32G32B32A32_UINT }
    };
    static const VkFormat halves[4] = { VK_FORMAT_R16_SFLOAT, VK_FORMAT_R16G16_SFLOAT, VK_FORMAT_R16G16B16A16_SFLOAT,
                                        VK_FORMAT_R16G16B16A16_SFLOAT };
    const spvc_basetype base = spvc_type_get_basetype(type);
    const int kind = base == SPVC_BASETYPE_INT32 ? 1 : base == SPVC_BASETYPE_UINT32 ? 2 : 0;
    const uint32_t width = spvc_type_get_vector_size(type);
    if (half && !kind) return halves[width - 1];
    return formats[kind][half && width == 3 ? 3 : width - 1];
}

static void add_attribute(needs *n, spvc_compiler of, const spvc_reflected_resource *r)
{
    const spvc_type type = spvc_compiler_get_type_handle(of, r->type_id);
    const uint32_t location = spvc_compiler_get_decoration(of, r->id, SpvDecorationLocation);
    for (uint32_t i = 0; i < spvc_type_get_columns(type) && n->attributes < MOST_PLACES; ++i, ++n->attributes)
        n->attribute[n->attributes] = (VkVertexInputAttributeDescription) { location + i, 0, format_of(type, 0),
                                                                            16 * n->attributes };
}

static void add_target(needs *n, spvc_compiler of, const spvc_reflected_resource *r)
{
    const uint32_t location = spvc_compiler_get_decoration(of, r->id, SpvDecorationLocation);
    if (location >= 8) return;
    n->target[location] = format_of(spvc_compiler_get_type_handle(of, r->type_id), 1);
    if (location >= n->targets) n->targets = location + 1;
}

static int look(needs *n, const spirv *s, kit_error *err)
{
    static const struct { spvc_resource_type type; VkDescriptorType kind; } bound[] = {
        { SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER },
        { SPVC_RESOURCE_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER },
        { SPVC_RESOURCE_TYPE_SAMPLED_IMAGE, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER },
        { SPVC_RESOURCE_TYPE_SEPARATE_IMAGE, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE },
        { SPVC_RESOURCE_TYPE_SEPARATE_SAMPLERS, VK_DESCRIPTOR_TYPE_SAMPLER },
        { SPVC_RESOURCE_TYPE_STORAGE_IMAGE, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE }
    };
    const spvc_reflected_resource *r;
    spvc_context context;
    spvc_parsed_ir parsed;
    spvc_compiler of;
    spvc_resources all;
    size_t count;
    if (spvc_context_create(&context)) return kit_fail(err, "out of memory");
    const int failed = spvc_context_parse_spirv(context, s->word, s->count, &parsed)
                    || spvc_context_create_compiler(context, SPVC_BACKEND_NONE, parsed, SPVC_CAPTURE_MODE_COPY, &of)
                    || spvc_compiler_create_shader_resources(of, &all);
    if (failed) kit_fail(err, "SPIRV-Cross: %.900s", spvc_context_get_last_error_string(context));
    for (size_t i = 0; i < sizeof bound / sizeof *bound && !failed; ++i) {
        spvc_resources_get_resource_list_for_type(all, bound[i].type, &r, &count);
        for (size_t k = 0; k < count; ++k) add_binding(n, of, &r[k], bound[i].kind, s->stage);
    }
    if (!failed && s->stage == VK_SHADER_STAGE_VERTEX_BIT) {
        spvc_resources_get_resource_list_for_type(all, SPVC_RESOURCE_TYPE_STAGE_INPUT, &r, &count);
        for (size_t k = 0; k < count; ++k) add_attribute(n, of, &r[k]);
    }
    if (!failed && s->stage == VK_SHADER_STAGE_FRAGMENT_BIT) {
        spvc_resources_get_resource_list_for_type(all, SPVC_RESOURCE_TYPE_STAGE_OUTPUT, &r, &count);
        for (size_t k = 0; k < count; ++k) add_target(n, of, &r[k]);
    }
    if (!failed) {
        spvc_resources_get_resource_list_for_type(all, SPVC_RESOURCE_TYPE_PUSH_CONSTANT, &r, &count);
        if (count) n->push |= s->stage;
    }
    spvc_context_destroy(context);
    return failed ? -1 : 0;
}

/* ---- the device -------------------------------------------------------------------------------------------------- */

int compiler_exists(kit_error *err)
{
    glob_t found;
    const int lacks = glob("/usr/share/vulkan/icd.d/radeon_icd*.json", 0, NULL, &found);
    if (lacks) return kit_fail(err, "radeon_icd is missing (apt-get install mesa-vulkan-drivers)"), 0;
    setenv("VK_ICD_FILENAMES", found.gl_pathv[0], 1);
    setenv("VK_DRIVER_FILES", found.gl_pathv[0], 1);
    globfree(&found);
    glslang_initialize_process();
    return 1;
}

int compiler_open(compiler *c, const char *family, kit_error *err)
{
    const char *const wanted[] = { VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME };
    const VkApplicationInfo application = { .sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                            .apiVersion = VK_API_VERSION_1_3 };
    const VkInstanceCreateInfo instance = { .sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                            .pApplicationInfo = &application };
    memset(c, 0, sizeof *c);
    setenv("RADV_FORCE_FAMILY", family, 1);
    if (vkCreateInstance(&instance, NULL, &c->instance) != VK_SUCCESS)
        return kit_fail(err, "RADV cannot be opened");
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    uint32_t count = 1;
    if (vkEnumeratePhysicalDevices(c->instance, &count, &physical) < 0 || !count)
        return kit_fail(err, "RADV has no device for the family %s", family);
    VkPhysicalDeviceSubgroupSizeControlProperties wave = {
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_SIZE_CONTROL_PROPERTIES };
    VkPhysicalDeviceDriverProperties driver = { .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES,
                                                .pNext = &wave };
    VkPhysicalDeviceProperties2 about = { .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, .pNext = &driver };
    vkGetPhysicalDeviceProperties2(physical, &about);
    snprintf(c->name, sizeof c->name, "%s", about.properties.deviceName);
    c->least_lanes = (int)wave.minSubgroupSize;
    snprintf(c->driver, sizeof c->driver, "%.40s", driver.driverInfo);
    VkPhysicalDeviceVulkan13Features dynamic = { .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES,
                                                 .dynamicRendering = VK_TRUE };
    VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR told = {
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR, .pNext = &dynamic,
        .pipelineExecutableInfo = VK_TRUE
    };
    const VkPhysicalDeviceFeatures2 features = {
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, .pNext = &told,
        .features = { .geometryShader = VK_TRUE, .tessellationShader = VK_TRUE, .independentBlend = VK_TRUE }
    };
    const float priority = 1;
    const VkDeviceQueueCreateInfo queue = { .sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, .queueCount = 1,
                                            .pQueuePriorities = &priority };
    const VkDeviceCreateInfo device = { .sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, .pNext = &features,
                                        .queueCreateInfoCount = 1, .pQueueCreateInfos = &queue,
                                        .enabledExtensionCount = 1, .ppEnabledExtensionNames = wanted };
    if (vkCreateDevice(physical, &device, NULL, &c->device) != VK_SUCCESS)
        return kit_fail(err, "RADV gives no device that tells of its pipelines for the family %s", family);
    return 0;
}

void compiler_close(compiler *c)
{
    if (c->device) vkDestroyDevice(c->device, NULL);
    if (c->instance) vkDestroyInstance(c->instance, NULL);
    memset(c, 0, sizeof *c);
}

/* ---- a pipeline -------------------------------------------------------------------------------------------------- */

static void take_statistic(executable *e, const VkPipelineExecutableStatisticKHR *s)
{
    const struct { const char *name; int *to; } wanted[] = {
        { "VGPRs", &e->vgprs }, { "Spilled VGPRs", &e->spilled }, { "Spilled SGPRs", &e->spilled },
        { "Scratch size", &e->scratch }, { "Subgroups per SIMD", &e->waves }
    };
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; ++i)
        if (!strcmp(s->name, wanted[i].name)) *wanted[i].to += (int)s->value.u64;
}

static int take_executable(const compiler *c, executable *e, const VkPipelineExecutableInfoKHR *which)
{
#define FUNCTION(name) const PFN_##name get_##name = (PFN_##name)vkGetDeviceProcAddr(c->device, #name)
    FUNCTION(vkGetPipelineExecutableStatisticsKHR);
    FUNCTION(vkGetPipelineExecutableInternalRepresentationsKHR);
    VkPipelineExecutableStatisticKHR statistic[64];
    VkPipelineExecutableInternalRepresentationKHR text[8];
    uint32_t statistics = 64, texts = 8;
    for (int i = 0; i < 64; ++i)
        statistic[i] = (VkPipelineExecutableStatisticKHR) {
            .sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR };
    for (int i = 0; i < 8; ++i)
        text[i] = (VkPipelineExecutableInternalRepresentationKHR) {
            .sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INTERNAL_REPRESENTATION_KHR };
    get_vkGetPipelineExecutableStatisticsKHR(c->device, which, &statistics, statistic);
    for (uint32_t i = 0; i < statistics; ++i) take_statistic(e, &statistic[i]);
    get_vkGetPipelineExecutableInternalRepresentationsKHR(c->device, which, &texts, text);
    for (uint32_t i = 0; i < texts; ++i) text[i].pData = calloc(1, text[i].dataSize + 1);
    get_vkGetPipelineExecutableInternalRepresentationsKHR(c->device, which, &texts, text);
    for (uint32_t i = 0; i < texts; ++i) {
        if (!e->assembly && !strcmp(text[i].name, "Assembly")) e->assembly = text[i].pData;
        else free(text[i].pData);
    }
    return e->assembly ? 0 : -1;
}

static int take_parts(const compiler *c, pipeline *p, VkPipeline made, kit_error *err)
{
    FUNCTION(vkGetPipelineExecutablePropertiesKHR);
    const VkPipelineInfoKHR info = { .sType = VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR, .pipeline = made };
    VkPipelineExecutablePropertiesKHR about[SHADER_STAGES + 1];
    uint32_t count = SHADER_STAGES + 1;
    for (int i = 0; i <= SHADER_STAGES; ++i)
        about[i] = (VkPipelineExecutablePropertiesKHR) {
            .sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR };
    get_vkGetPipelineExecutablePropertiesKHR(c->device, &info, &count, about);
    for (uint32_t i = 0; i < count && p->parts < SHADER_STAGES; ++i) {
        const VkPipelineExecutableInfoKHR which = { .sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR,
                                                    .pipeline = made, .executableIndex = i };
        executable *e = &p->part[p->parts++];
        e->stages = about[i].stages;
        if (take_executable(c, e, &which)) return kit_fail(err, "RADV shows no assembly");
        e->waves = e->waves * c->least_lanes / 64;          /* in waves of 64 lanes, though least_lanes may be 32 */
    }
    return 0;
}

static VkPipelineLayout make_layout(const compiler *c, const needs *n, VkDescriptorSetLayout group[MOST_GROUPS])
{
    VkPipelineLayout layout = VK_NULL_HANDLE;
    for (int i = 0; i < MOST_GROUPS; ++i) {
        const VkDescriptorSetLayoutCreateInfo info = {
            .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO, .bindingCount = n->bindings[i],
            .pBindings = n->binding[i]
        };
        vkCreateDescriptorSetLayout(c->device, &info, NULL, &group[i]);
    }
    const VkPushConstantRange push = { n->push, 0, 128 };
    const VkPipelineLayoutCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO, .setLayoutCount = MOST_GROUPS, .pSetLayouts = group,
        .pushConstantRangeCount = n->push ? 1 : 0, .pPushConstantRanges = &push
    };
    vkCreatePipelineLayout(c->device, &info, NULL, &layout);
    return layout;
}

static VkResult make_pipeline(const compiler *c, VkPipeline *made, const needs *n, VkPipelineLayout layout,
                              const VkPipelineShaderStageCreateInfo *stage, uint32_t stages)
{
    const VkPipelineCreateFlags told = VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR
                                     | VK_PIPELINE_CREATE_CAPTURE_INTERNAL_REPRESENTATIONS_BIT_KHR;
    if (stage[0].stage == VK_SHADER_STAGE_COMPUTE_BIT) {
        const VkComputePipelineCreateInfo alone = { .sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
                                                    .flags = told, .stage = stage[0], .layout = layout };
        return vkCreateComputePipelines(c->device, VK_NULL_HANDLE, 1, &alone, NULL, made);
    }
    VkPipelineColorBlendAttachmentState blend[8];
    int patches = 0;
    for (uint32_t i = 0; i < stages; ++i) patches |= stage[i].stage == VK_SHADER_STAGE_TESSELLATION_CONTROL_BIT;
    for (int i = 0; i < 8; ++i) blend[i] = (VkPipelineColorBlendAttachmentState) { .colorWriteMask = 15 };
    const VkVertexInputBindingDescription vertex = { 0, 16 * MOST_PLACES, VK_VERTEX_INPUT_RATE_VERTEX };
    const VkPipelineVertexInputStateCreateInfo input = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO,
        .vertexBindingDescriptionCount = n->attributes ? 1 : 0, .pVertexBindingDescriptions = &vertex,
        .vertexAttributeDescriptionCount = n->attributes, .pVertexAttributeDescriptions = n->attribute
    };
    const VkPipelineInputAssemblyStateCreateInfo assembly = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
        .topology = patches ? VK_PRIMITIVE_TOPOLOGY_PATCH_LIST : VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST
    };
    const VkPipelineTessellationStateCreateInfo patch = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_TESSELLATION_STATE_CREATE_INFO, .patchControlPoints = 3 };
    const VkPipelineViewportStateCreateInfo view = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO, .viewportCount = 1, .scissorCount = 1 };
    const VkPipelineRasterizationStateCreateInfo raster = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO, .lineWidth = 1 };
    const VkPipelineMultisampleStateCreateInfo samples = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO, .rasterizationSamples = 1 };
    const VkPipelineColorBlendStateCreateInfo colour = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO, .attachmentCount = n->targets,
        .pAttachments = blend };
    const VkDynamicState moving[] = { VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR };
    const VkPipelineDynamicStateCreateInfo dynamic = { .sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
                                                       .dynamicStateCount = 2, .pDynamicStates = moving };
    const VkPipelineRenderingCreateInfo targets = { .sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
                                                    .colorAttachmentCount = n->targets,
                                                    .pColorAttachmentFormats = n->target };
    const VkGraphicsPipelineCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO, .pNext = &targets,
        .flags = told,
        .stageCount = stages, .pStages = stage, .pVertexInputState = &input, .pInputAssemblyState = &assembly,
        .pTessellationState = &patch, .pViewportState = &view, .pRasterizationState = &raster,
        .pMultisampleState = &samples, .pColorBlendState = &colour, .pDynamicState = &dynamic, .layout = layout
    };
    return vkCreateGraphicsPipelines(c->device, VK_NULL_HANDLE, 1, &info, NULL, made);
}

int compile(const compiler *c, pipeline *p, const spirv *stage, int stages, const VkFormat *formats, kit_error *err)
{
    VkPipelineShaderStageCreateInfo info[SHADER_STAGES];
    VkDescriptorSetLayout group[MOST_GROUPS] = { VK_NULL_HANDLE };
    VkPipeline made = VK_NULL_HANDLE;
    needs n;
    memset(&n, 0, sizeof n);
    memset(p, 0, sizeof *p);
    for (int i = 0; i < stages; ++i) {
        const VkShaderModuleCreateInfo text = { .sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                                .codeSize = stage[i].count * 4, .pCode = stage[i].word };
        if (look(&n, &stage[i], err)) return -1;
        info[i] = (VkPipelineShaderStageCreateInfo) { .sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                                                      .stage = stage[i].stage, .pName = "main" };
        vkCreateShaderModule(c->device, &text, NULL, &info[i].module);
    }
    for (uint32_t i = 0; formats && i < n.targets; ++i) n.target[i] = formats[i];
    const VkPipelineLayout layout = make_layout(c, &n, group);
    const double start = compile_seconds();
    const VkResult result = make_pipeline(c, &made, &n, layout, info, (uint32_t)stages);
    p->seconds = compile_seconds() - start;
    int failed = result != VK_SUCCESS ? kit_fail(err, "RADV makes no pipeline (%d)", result)
                                      : take_parts(c, p, made, err);
    vkDestroyPipeline(c->device, made, NULL);
    vkDestroyPipelineLayout(c->device, layout, NULL);
    for (int i = 0; i < MOST_GROUPS; ++i) vkDestroyDescriptorSetLayout(c->device, group[i], NULL);
    for (int i = 0; i < stages; ++i) vkDestroyShaderModule(c->device, info[i].module, NULL);
    return failed;
}

void pipeline_free(pipeline *p)
{
    for (int i = 0; i < p->parts; ++i) free(p->part[i].assembly);
    memset(p, 0, sizeof *p);
}
