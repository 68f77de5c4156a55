/* ssgi.c - the headers as WebAssembly, without a C library: make wasm builds build/wasm/ssgi.wasm, ssgi.mjs loads it.

   The functions that a page needs each frame are exported by name; the linker drops the rest. To have more (views,
   plans), add lines of EXPORT; examples/web/bake.c makes surfels and fields. The page owns the memory from __heap_base
   on: code here only uses it by the pointers that it gets. */
#include "../../../ssgi_gl.h"

#define EXPORT(function) extern __typeof__(function) function __attribute__((export_name(#function)))
EXPORT(ssgi_view_from_projection);
EXPORT(ssgi_gl_choice_at);
EXPORT(ssgi_gl_check);
EXPORT(ssgi_gl_preset);
EXPORT(ssgi_gl_resolve);
EXPORT(ssgi_gl_emit);
EXPORT(ssgi_gl_read);
EXPORT(ssgi_gl_reflection);
EXPORT(ssgi_gl_key);
EXPORT(ssgi_gl_pass_name);
EXPORT(ssgi_gl_dialect_name);
EXPORT(ssgi_gl_reflect);
EXPORT(ssgi_gl_member_at);
EXPORT(ssgi_gl_frame_init);
EXPORT(ssgi_gl_frame_history);
EXPORT(ssgi_gl_phase);
EXPORT(ssgi_gl_harmonics_set);
EXPORT(ssgi_gl_steps);
EXPORT(ssgi_gl_chain_choice_at);
EXPORT(ssgi_gl_method_at);
EXPORT(ssgi_gl_chain_of);
EXPORT(ssgi_gl_frame_of);
EXPORT(ssgi_gl_surfels_set);
EXPORT(ssgi_gl_occluder_set);
EXPORT(ssgi_gl_light_map);
EXPORT(ssgi_field_size);
EXPORT(ssgi_field_load);
EXPORT(ssgi_environment_map);
EXPORT(ssgi_environment_cone);
EXPORT(ssgi_sh_project_equirect);
EXPORT(ssgi_sh_residual);
EXPORT(ssgi_trace_size);
EXPORT(ssgi_trace_build);
EXPORT(ssgi_trace_closest);
EXPORT(ssgi_trace_any);

/* Sizes and offsets of members by name, for ssgi.mjs: the i-th; NULL past the last. */
typedef struct place { const char *name; int32_t value; } place;
const place *ssgi_wasm_place_at(int i) __attribute__((export_name("ssgi_wasm_place_at")));
const place *ssgi_wasm_place_at(int i)
{
#define SIZE(of) { #of, (int32_t)sizeof(of) }
#define AT(of, member) { #of "." #member, (int32_t)offsetof(of, member) }
#define CHAIN(member) AT(ssgi_gl_chain, member)
#define STEP(member) AT(ssgi_gl_step, member)
#define INPUT(member) AT(ssgi_gl_input, member)
#define OUTPUT(member) AT(ssgi_gl_output, member)
#define SURFELS(member) AT(ssgi_surfel_desc, member)
#define FIELD(member) AT(ssgi_field, member)
#define LIGHT(member) AT(ssgi_gl_light, member)
#define CHOICE(member) AT(ssgi_gl_choice, member)
#define IO(member) AT(ssgi_gl_io, member)
#define METHOD(member) AT(ssgi_gl_method, member)
#define FORMAT(member) AT(ssgi_gl_format, member)
    /* in paragraphs of structs */
    static const place places[] = {
        { "major", SSGI_VERSION_MAJOR }, { "minor", SSGI_VERSION_MINOR }, { "meanings", SSGI_GL_YOURS },
        SIZE(ssgi_view), SIZE(ssgi_gl_desc), SIZE(ssgi_gl_frame), SIZE(ssgi_gl_io), SIZE(ssgi_gl_chain),
        SIZE(ssgi_gl_step), SIZE(ssgi_gl_input), SIZE(ssgi_gl_output), SIZE(ssgi_trace), SIZE(ssgi_hit),
        SIZE(ssgi_surfel_desc), SIZE(ssgi_field), SIZE(ssgi_gl_occluder), SIZE(ssgi_gl_light),
        { "ssgi_gl_desc.version", (int)offsetof(ssgi_gl_desc, shader.version) },
        { "ssgi_gl_desc.fetch", (int)offsetof(ssgi_gl_desc, shader.fetch) },
        CHOICE(name), CHOICE(field), CHOICE(values), CHOICE(sentence), CHOICE(offset), CHOICE(most),
        IO(name), IO(kind), IO(type), IO(slot), IO(offset), IO(format), IO(set), IO(binding),
        CHAIN(desc), CHAIN(lights), CHAIN(width), CHAIN(height),
        METHOD(name), METHOD(sentence), METHOD(pass), METHOD(preset), METHOD(settings),
        STEP(desc), STEP(scale), STEP(width), STEP(height), STEP(inputs), STEP(outputs), STEP(input), STEP(output),
        STEP(frame), STEP(primitive), STEP(vertices), STEP(instances), STEP(blend), STEP(clear), STEP(clear_to),
        STEP(groups),
        INPUT(name), INPUT(type), INPUT(unit), INPUT(target), INPUT(meaning), INPUT(texture), INPUT(last),
        INPUT(format), INPUT(width), INPUT(height), INPUT(set), INPUT(binding), INPUT(array), INPUT(multisampled),
        INPUT(integer),
        OUTPUT(name), OUTPUT(texture), OUTPUT(format), OUTPUT(layers), OUTPUT(layer), OUTPUT(set), OUTPUT(binding),
        OUTPUT(kept), OUTPUT(result),
        FORMAT(name), FORMAT(internal), FORMAT(format), FORMAT(type), FORMAT(bytes), FORMAT(vulkan),
        FORMAT(vulkan_name), FORMAT(webgpu),
        SURFELS(size), SURFELS(splits), SURFELS(offscreen_growth), SURFELS(keep_small), SURFELS(max_distance),
        SURFELS(overhang),
        FIELD(resolution), FIELD(radius), FIELD(reach), FIELD(inside), FIELD(p95),
        LIGHT(at), LIGHT(kind), LIGHT(colour), LIGHT(min_distance), LIGHT(normal),
    };
    return i >= 0 && i < (int)(sizeof places / sizeof *places) ? &places[i] : NULL;
}

#define SSGI_IMPLEMENTATION
#define SSGI_GL_IMPLEMENTATION
#include "../../../ssgi.h"
#include "../../../ssgi_gl.h"

#include "libc/string.c"
