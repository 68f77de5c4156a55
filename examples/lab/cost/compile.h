/* compile.h - GLSL to the instructions of a GPU that need not be here: glslang, then Mesa's RADV on its null device. */
#ifndef COST_COMPILE_H
#define COST_COMPILE_H

#include "kit/kit.h"
#include <stdint.h>
#include <vulkan/vulkan.h>

typedef struct compiler {
    VkInstance instance;
    VkDevice device;
    char name[VK_MAX_PHYSICAL_DEVICE_NAME_SIZE];
    char driver[64];                                    /* "Mesa 22.3.6" */
    int least_lanes;                                    /* of a wave */
} compiler;

enum { STAGES = 5 };            /* vertex, tessellation control and evaluation, geometry, fragment */

/* Words of SPIR-V of one stage. */
typedef struct spirv { uint32_t *word; size_t count; VkShaderStageFlagBits stage; } spirv;

/* What one executable of a pipeline is: several stages may be merged into one. */
typedef struct executable {
    VkShaderStageFlags stages;
    char *assembly;
    int vgprs, spilled, scratch, waves;    /* waves of 64 that share a SIMD */
} executable;

/* seconds: of processor, that it took to make. */
typedef struct pipeline { executable part[STAGES]; int parts; double seconds; } pipeline;

/* 0: RADV is not here, err says so. To be called first. */
int compiler_exists(kit_error *err);
/* family: as RADV_FORCE_FAMILY names it. */
int compiler_open(compiler *c, const char *family, kit_error *err);
void compiler_close(compiler *c);

/* Of processor, of the calling thread. */
double compile_seconds(void);

/* From a file, FILE.vert.spv ..; from the text of a stage, in any number of threads. relaxed: of
   OpenGL, whose uniforms and varyings have no numbers. */
int spirv_read(spirv *s, const char *path, kit_error *err);
int spirv_make(spirv *s, const char *text, VkShaderStageFlagBits stage, int relaxed, kit_error *err);

/* A vertex stage that only places vertices, for a fragment stage that takes nothing from one. */
int spirv_triangle(spirv *s, kit_error *err);

/* formats: of the targets of the fragment stage by location, or NULL: as wide as what it writes. In any number of
   threads. */
int compile(const compiler *c, pipeline *p, const spirv *stage, int stages, const VkFormat *formats, kit_error *err);
void pipeline_free(pipeline *p);

#endif
