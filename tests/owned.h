/* owned.h - variables of tests that release what they hold. */
#ifndef OWNED_H
#define OWNED_H
#include "kit/kit_gl.h"
#include <stdlib.h>
#include <string.h>

/* Before a type: these variables are released where their block ends. They begin as { 0 }. FREED: a pointer that malloc
   gave. */
#define OWN(type) __attribute__((cleanup(own_##type))) type
#define FREED __attribute__((cleanup(own_memory)))
static inline void own_kit_image(kit_image *image)          { kit_image_free(image); }
static inline void own_kit_gbuffer(kit_gbuffer *gbuffer)    { kit_gbuffer_free(gbuffer); }
static inline void own_kit_scene(kit_scene *scene)          { kit_scene_free(scene); }
static inline void own_kit_run(kit_run *run)                { kit_run_close(run); }
static inline void own_kit_lighting(kit_lighting *lighting) { kit_image_free(&lighting->env); }
static inline void own_kit_mesh(kit_mesh *mesh)             { kit_mesh_free(mesh); }
static inline void own_memory(const void *pointer)
{
    void *memory;
    memcpy(&memory, pointer, sizeof memory);
    free(memory);
}
#endif
