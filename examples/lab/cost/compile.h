/* compile.h - from GLSL to the instructions of a GPU that need not be here, by glslang and Mesa's RADV on its null
   device. */
#ifndef COST_COMPILE_H
#define COST_COMPILE_H

#include "kit/kit.h"
#include <stdint.h>
#include <vulkan/vulkan.h>

typedef struct compiler {
    VkInstance instance;
    VkDevice device;
    char name[VK_MAX_PHYSICAL_DEVICE_NAME_SIZE];
    char driver[64];                                    /* such as "Mesa 22.3.6" */
    int least_lanes;                                    /* lanes of the smallest wave */
} compiler;

enum { SHADER_STAGES = 5 };            /* vertex, tessellation control and evaluation, geometry, fragment */

/* The SPIR-V of one stage; count: in words of 32 bits. */
typedef struct spirv { uint32_t *word; size_t count; VkShaderStageFlagBits stage; } spirv;

/* One executable of a pipeline, which may be several stages merged into one. */
typedef struct executable {
    VkShaderStageFlags stages;
    char *assembly;
    int vgprs, spilled, scratch, waves;    /* how many waves of 64 lanes share a SIMD */
} executable;

/* seconds: processor time of the compilation. */
typedef struct pipeline { executable part[SHADER_STAGES]; int parts; double seconds; } pipeline;

/* To be called first. 0: RADV is missing, as err says. */
int compiler_exists(kit_error *err);
/* family: a GPU family by its name in RADV_FORCE_FAMILY. */
int compiler_open(compiler *c, const char *family, kit_error *err);
void compiler_close(compiler *c);

/* Processor time of the calling thread. */
double compile_seconds(void);

/* spirv_read reads a file, such as FILE.vert.spv; spirv_make translates a stage's shader, in any number of threads.
   relaxed: the shader is for OpenGL, so its uniforms and varyings have no numbers. */
int spirv_read(spirv *s, const char *path, kit_error *err);
int spirv_make(spirv *s, const char *text, VkShaderStageFlagBits stage, int relaxed, kit_error *err);

/* A vertex stage that only places vertices, for a fragment stage without varyings. */
int spirv_triangle(spirv *s, kit_error *err);

/* formats: of the fragment stage's targets by location; NULL: the widest formats that fit its outputs. May be called by
   any number of threads. */
int compile(const compiler *c, pipeline *p, const spirv *stage, int stages, const VkFormat *formats, kit_error *err);
void pipeline_free(pipeline *p);

#endif
