/* compile.h - compiles GLSL to the instructions of a GPU that need not be here, by glslang and Mesa's RADV on its null
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
    int least_lanes;                                    /* lanes of the GPU's smallest wave */
} compiler;

enum { SHADER_STAGES = 5 };            /* vertex, tessellation control and evaluation, geometry, fragment; or compute */

/* The SPIR-V of one shader stage; count: how many words of 32 bits. */
typedef struct spirv { uint32_t *word; size_t count; VkShaderStageFlagBits stage; } spirv;

/* One compiled program of a pipeline, which may be several stages merged into one. */
typedef struct executable {
    VkShaderStageFlags stages;
    char *assembly;
    int vgprs, spilled, scratch, waves;    /* waves: how many of 64 lanes fit on a SIMD */
} executable;

/* A compiled pipeline. seconds: processor time of its compilation. */
typedef struct pipeline { executable part[SHADER_STAGES]; int parts; double seconds; } pipeline;

/* Checks for RADV, before all other calls. Returns 0 if it is missing, as err says. */
int compiler_exists(kit_error *err);
/* Opens a compiler for a GPU family, by its name in RADV_FORCE_FAMILY. */
int compiler_open(compiler *c, const char *family, kit_error *err);
void compiler_close(compiler *c);

/* Returns the processor time of the calling thread, in seconds. */
double compile_seconds(void);

/* spirv_read reads a file, such as FILE.vert.spv; spirv_make translates the shader of a stage, and may be called by any
   number of threads. relaxed: the shader is for OpenGL, so its uniforms and varyings have no locations. */
int spirv_read(spirv *s, const char *path, kit_error *err);
int spirv_make(spirv *s, const char *text, VkShaderStageFlagBits stage, int relaxed, kit_error *err);

/* Makes a vertex stage that only places vertices, for a fragment stage without varyings. */
int spirv_triangle(spirv *s, kit_error *err);

/* Compiles a pipeline of so many stages, in any number of threads. formats: of the fragment stage's targets by
   location; NULL: the widest formats that fit its outputs. */
int compile(const compiler *c, pipeline *p, const spirv *stage, int stages, const VkFormat *formats, kit_error *err);
void pipeline_free(pipeline *p);

#endif
