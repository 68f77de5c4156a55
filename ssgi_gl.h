/* ssgi_gl.h - v0.1 - screen-space illumination: the GLSL of every pass, as text. C99, includes ssgi.h only. Licence: end of ssgi.h.

   Do this in *one* C or C++ file:      #define SSGI_IMPLEMENTATION          (unless ssgi.h is implemented elsewhere already)
                                        #define SSGI_GL_IMPLEMENTATION
                                        #include "ssgi_gl.h"

   QUICK USE  (compiled and run by tests/test_build.c; examples/minimal.c is the whole of it with GL around)

      ssgi_gl_desc d = { 0 };                               // every choice at its default; C++: ssgi_gl_desc d = {};
      d.pass = SSGI_GL_HSAO;
      size_t length = ssgi_gl_emit(NULL, 0, &d, SSGI_GL_FRAGMENT);       // snprintf's law
      char *text = (char *)malloc(length + 1);
      ssgi_gl_emit(text, length + 1, &d, SSGI_GL_FRAGMENT);              // compile this with your own GL ...
      ssgi_gl_io row[SSGI_GL_MAX_IO];
      int rows = ssgi_gl_reflect(&d, row, SSGI_GL_MAX_IO), i;            // ... and bind what it reads and writes:
      for (i = 0; i < rows; ++i)
         if (row[i].kind == SSGI_GL_TEXTURE) printf("unit %d: %s, %s\n", row[i].slot, row[i].name, row[i].format);
      ssgi_gl_frame frame;                                  // what changes per frame: fill, upload as one uniform buffer
      ssgi_gl_frame_init(&frame, &view, 0.5f, NULL);              // view: an ssgi_view, see ssgi.h; radius 0.5 view units

   HOW A PASS IS DRAWN
      Vertex stage and fragment stage from ssgi_gl_emit, an empty vertex array, depth test and blending off, the viewport on the picture inside
      the target, glDrawArrays(GL_TRIANGLES, 0, 3). Textures are read with texelFetch: any filter, any wrap, level 0. The uniform block
      "ssgi_frame" is ssgi_gl_frame byte for byte (std140). In dialects that have layout(binding) the rows' slots are in the text; in the
      others set them once by name (glUniform1i, glUniformBlockBinding). This header calls no GL and includes no GL header.

   PASSES       ssao     fetch -> gather            ambient visibility: point samples in the hemisphere [SA07]
                hsao     fetch -> gather            ambient visibility: horizon search, slices or the paper's march [HSAO08]
                ssdo     fetch -> gather -> light   directional occlusion of an environment, one diffuse bounce, or both [SSDO09]
                s3ho     fetch -> gather            occlusion as spherical harmonics: a vector that light is dotted with, and what blockers reflect [S3HO12]
                lights   fetch -> light             suns, point lights, virtual point lights; shadow maps, or segments in screen space [SSDO09 4, 5]
                surfels  splat                      surfels from triangles, or lights those that are there; into a buffer [DSS14]
                shuffle  fetch -> splat             positions and normals, pixels dealt out to the sub-buffers of every level
                splat    splat                      what each surfel does to pixels around it, added up
                unshuffle, smooth, sum   splat      pixels back in place; within surfaces; ambient visibility, light or bounce
                senders  fetch -> light             packs what surfaces send, their normal and depth: one fetch a sample for the bounce
                shade    light                      the vectors of s3ho meet light: harmonics, lamps, bent normals and cones [S3HO12, SSBN11]
                field    fetch -> field             ambient occlusion by rigid casters whose fields were baked (ssgi_field_bake), blended over each other [AOF05]
                blur     fetch -> filter            smooths what the others wrote, within surfaces
                survey   fetch                      what stands around one pixel of every 8x8: for ssgi_survey_of and the plan in ssgi.h

   DIRECTIONAL OCCLUSION AND A BOUNCE, in the order of drawing; all but the first are optional
      ssdo     with an environment writes o_ssgi_light: irradiance over pi, and depth; blur with colour = 1 smooths it
      lights   with accumulate = 1 adds suns and point lights to it; its shadow maps are yours, drawn as ever
      senders  packs albedo * o_ssgi_light (and a radiance of your own) with depth and normal into one slice of t_ssgi_senders; a draw a layer
      ssdo     with a bounce and no environment reads that and writes o_ssgi_bounce; blur. Outgoing radiance = albedo * (light + bounce)
      When senders may shine with the last frame's light, draw senders first, then one ssdo with environment and bounce: two targets, one visibility.

   OCCLUSION AS SPHERICAL HARMONICS, when light changes more often than geometry, or is spherical harmonics already
      senders  radiance ALBEDO, for a bounce only; a draw a layer
      s3ho     writes o_ssgi_sh0 .., the transfer of each pixel; with a transfer BOTH one a channel, which holds a bounce for whatever light comes
      blur     with colour = SSGI_GL_VECTORS; or none here and blur what shade wrote: far cheaper, and the same but for the clamp
      shade    dots them with frame.harmonics (ssgi_gl_harmonics_set) and adds lamps: irradiance over pi, or radiance. bands = 2 serves bent normals and cones
      With shaded = 1 s3ho does that itself and keeps nothing.

   OCCLUSION BETWEEN MOVING OBJECTS
      field    a ssgi_gl_caster each, as rows of t_ssgi_casters; clear the target to 1, blend by GL_DST_COLOR, GL_ZERO (or GL_ZERO, GL_SRC_COLOR), and draw all at once:
               glDrawArraysInstanced(GL_TRIANGLES, 0, 6, casters): a rectangle each, around the sphere that it reaches; culling off. No noise, no filter
      In your own forward shader: ssgi_gl_field, the same functions as text

   DEEP SCREEN SPACE, which sees what the picture does not; all levels lie below each other in textures of frame.level[0] x (levels * frame.level[1])
      surfels    ssgi_surfels on the CPU, or this pass: rasteriser discarded, transform feedback of its CAPTURE rows, interleaved, is ssgi_surfel[] (some of radius 0 among them: at most two for each of ssgi_surfels'). With tessellate patches of 3 vertices, instanced
                 splits * splits times; without it a point a surfel, whose light it brings up to date
      shuffle    over the texture of all levels, once a picture
      splat      blend GL_ONE, GL_ONE onto 0; glDrawArraysInstanced(GL_TRIANGLES, 0, 6 * levels, surfels), the buffer's three vec4 a surfel with divisor 1: runs on GL 3.3, GLES 3.0, WebGL 2.
                 With tessellate patches as above: nothing is kept. Culling off
      unshuffle  over all levels; then smooth along x, smooth along y (both over all levels), sum over the picture
   ROOMS        search for ">>"
      >>desc       what you choose               >>io      what a pass reads and writes       >>frame    what changes per frame
      >>emit       text out                      >>rows    the table of inputs and outputs
      >>fetch  >>visibility  >>harmonics  >>gather  >>light  >>field  >>splat  >>filter  the GLSL, one chunk a function      >>passes   the table of passes

   NAMES IN THE TEXT   u_ssgi_* uniforms, t_ssgi_* samplers, o_ssgi_* outputs, v_ssgi_* between stages, ssgi_*() functions, SSGI_* constants; nothing else at global scope. */
#ifndef SSGI_GL_H
#define SSGI_GL_H

#include "ssgi.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ==== >>desc =================================================================================================== */

enum { SSGI_GL_SSAO = 0, SSGI_GL_HSAO, SSGI_GL_SSDO, SSGI_GL_S3HO, SSGI_GL_LIGHTS, SSGI_GL_SENDERS, SSGI_GL_SHADE, SSGI_GL_FIELD,
       SSGI_GL_SURFELS, SSGI_GL_SHUFFLE, SSGI_GL_SPLAT, SSGI_GL_UNSHUFFLE, SSGI_GL_SMOOTH, SSGI_GL_SUM, SSGI_GL_BLUR, SSGI_GL_SURVEY, SSGI_GL_PASSES /* how many */ };   /* desc.pass */
enum { SSGI_GL_330 = 0, SSGI_GL_410, SSGI_GL_450, SSGI_GL_300ES, SSGI_GL_310ES, SSGI_GL_320ES, SSGI_GL_DIALECTS };   /* desc.dialect */
enum { SSGI_GL_VERTEX = 0, SSGI_GL_FRAGMENT, SSGI_GL_TESS_CONTROL, SSGI_GL_TESS_EVALUATION, SSGI_GL_GEOMETRY, SSGI_GL_STAGES };   /* stage of ssgi_gl_emit */

/* desc.depth: what the depth texture holds */
enum { SSGI_GL_DEPTH_WINDOW = 0,     /* hardware depth, any layout that ssgi_view decodes */
       SSGI_GL_DEPTH_LINEAR,         /* positive view depth; <= 0, inf or NaN is background */
       SSGI_GL_DEPTH_CUSTOM };       /* your GLSL in desc.fetch: float ssgi_custom_depth(ivec2 texel, int layer), positive view depth; layer 0 is what is seen */
/* desc.normal: how the normal is had */
enum { SSGI_GL_NORMAL_SIGNED = 0,    /* xyz in [-1,1] (any float or snorm texture), need not be unit */
       SSGI_GL_NORMAL_UNSIGNED,      /* xyz * 0.5 + 0.5 (unorm texture) */
       SSGI_GL_NORMAL_OCTAHEDRAL,    /* xy in [-1,1], octahedral map (RG16_SNORM, RG16F) */
       SSGI_GL_NORMAL_FROM_DEPTH,    /* no texture: from the nearer depth neighbours, 4 more fetches */
       SSGI_GL_NORMAL_CUSTOM };      /* your GLSL in desc.fetch: vec3 ssgi_custom_normal(ivec2 texel), view space */
/* desc.noise: what decorrelates neighbouring pixels */
enum { SSGI_GL_NOISE_GRADIENT = 0,   /* interleaved gradient noise: suits a filter of 3x3 */
       SSGI_GL_NOISE_TILE4,          /* 4x4 tile computed from the pixel: 16 directions x 4 offsets; filter_radius 2 averages exactly one tile */
       SSGI_GL_NOISE_TEXTURE };      /* your texture, tiled: ., ., b, c as ssgi_jitter_tile makes it; 1 more fetch */
/* desc.search */
enum { SSGI_GL_SLICES = 0,           /* hsao: planes through the view direction, both sides in one walk on the screen: the fast way */
       SSGI_GL_MARCH };              /* hsao: the paper's deflected ray, and normal rays above it [HSAO08 3.1-3.3] */
/* desc.falloff: how a blocker's weight falls with its distance t, by how far along their directions samples stand */
enum { SSGI_GL_FALLOFF_LINEAR = 0,   /* 1 - t/radius: lengths uniform, the paper's */
       SSGI_GL_FALLOFF_SQUARE,       /* 1 - (t/radius)^2; what a bounce needs that restores clamped virtual point lights (ssgi_gl_light.least = radius) */
       SSGI_GL_FALLOFF_CUBE };       /* 1 - (t/radius)^3: lengths uniform in volume */
/* desc.fade: how a blocker's weight falls with the distance at which the picture shows it, from the receiver, d in radii */
enum { SSGI_GL_FADE_NONE = 0,
       SSGI_GL_FADE_SMOOTH,          /* from 1 at frame.fade to 0 at the radius */
       SSGI_GL_FADE_LAMBDA,          /* 1 / (1 + lambda d), the paper's: not 0 at the radius; more lambda is weaker [S3HO12 2.1] */
       SSGI_GL_FADE_LAMBDA_ENDED };  /* (1 - d) / (1 + lambda d): the same, made to end at the radius */
/* desc.environment */
enum { SSGI_GL_ENVIRONMENT_NONE = 0,
       SSGI_GL_ENVIRONMENT_SH,       /* frame.harmonics: all directions for the price of the visibility; what s3ho does when shaded */
       SSGI_GL_ENVIRONMENT_MAP };    /* one look-up a direction in an octahedral map (ssgi_environment_map), world space */
/* desc.bounce: what a blocked direction brings */
enum { SSGI_GL_BOUNCE_NONE = 0,
       SSGI_GL_BOUNCE_SOLID_ANGLE,   /* the sender's radiance over the sample's solid angle: never more than the brightest sender, no scale */
       SSGI_GL_BOUNCE_PATCH,         /* the paper's: a patch of pi r^2/N, its distance clamped at frame.nearest radii [SSDO09 section 3] */
       SSGI_GL_BOUNCE_DISC };        /* the same patch as a disc, its form factor at most 1 */
/* desc.shadow: what stands between a light and a point */
enum { SSGI_GL_SHADOW_SEGMENT = 0,   /* points on the segment to the light, radius long at most, in screen space */
       SSGI_GL_SHADOW_MAP,           /* your shadow maps, biased so that nothing shadows itself; lights without a map are unshadowed */
       SSGI_GL_SHADOW_FILL,          /* the same, and what the bias loses from points on its segment [SSDO09 section 5]; lights without a map as SEGMENT */
       SSGI_GL_SHADOW_NONE };
/* desc.radiance: what senders send */
enum { SSGI_GL_RADIANCE_LIGHT = 0,   /* albedo times what ssdo, shade or lights wrote */
       SSGI_GL_RADIANCE_DIRECT,      /* your own texture of outgoing radiance */
       SSGI_GL_RADIANCE_BOTH,        /* the sum */
       SSGI_GL_RADIANCE_ALBEDO };    /* albedo alone: what s3ho reads, whose light comes later */
/* desc.transfer: what the vectors of s3ho hold */
enum { SSGI_GL_TRANSFER_FREE = 0,    /* one vector: what free directions bring */
       SSGI_GL_TRANSFER_BOTH,        /* one a channel: that and what blockers reflect, lit as if nothing stood before them [S3HO12 2.3] */
       SSGI_GL_TRANSFER_REFLECTED }; /* one a channel: only what blockers reflect. Three vectors are six targets with 3 or 4 bands, three with fewer (GLES promises four) */
/* desc.shading: how vectors meet light */
enum { SSGI_GL_SHADING_HARMONICS = 0,/* dot product with frame.harmonics [S3HO12 2.2] */
       SSGI_GL_SHADING_BENT_NORMAL,  /* ambient visibility times the environment's irradiance along the mean free direction */
       SSGI_GL_SHADING_BENT_CONE,    /* the same, from a cone as wide as free directions are spread [SSBN11] */
       SSGI_GL_SHADING_BENT };       /* no light: that direction, view space, unit, and the cosine of the cone's half-angle */
/* desc.storage: how fields are kept */
enum { SSGI_GL_STORAGE_ATLAS = 0,    /* ssgi_field.texels as slices of one integer array: many fields at once, filtered in the shader, in every dialect: 4 fetches */
       SSGI_GL_STORAGE_CUBE };       /* one field as two cube maps (ssgi_field_cube), LINEAR, GL_TEXTURE_CUBE_MAP_SEAMLESS enabled (GLES always is); 16 bits need RGBA16, which GLES lacks: 2 fetches */
/* desc.cap: how a cap becomes occlusion */
enum { SSGI_GL_CAP_CLOSED = 0,       /* closed form: two arcs */
       SSGI_GL_CAP_TABLE };          /* your texture of ssgi_cap_table: 1 fetch */
/* desc.objects: which object a pixel shows, so that no caster shades itself */
enum { SSGI_GL_OBJECTS_NONE = 0,     /* casters shade whatever is there */
       SSGI_GL_OBJECTS_TEXTURE,      /* your texture of numbers, 0 = none; a pixel whose number is ssgi_gl_caster.object is left alone */
       SSGI_GL_OBJECTS_CUSTOM };     /* your GLSL in desc.fetch: uint ssgi_custom_object(ivec2 texel) */
/* desc.effect: what surfels do to pixels */
enum { SSGI_GL_EFFECT_OCCLUSION = 0, /* ambient visibility; within frame.radius, by 1 - distance/radius unless hard */
       SSGI_GL_EFFECT_LIGHT,         /* directional occlusion: irradiance over pi of the open surface less what surfels hide of the environment */
       SSGI_GL_EFFECT_BOUNCE,        /* irradiance over pi from what surfels send */
       SSGI_GL_EFFECT_SPECULAR,      /* radiance of a lobe about the mirrored view direction, cos^frame.exponent, normalised: times your specular reflectance */
       SSGI_GL_EFFECT_SCATTER };     /* radiance that leaves a translucent surface: the dipole over what surfels receive (frame.dipole) */
/* desc.overlap: where surfels hide each other, for nobody looks whether they do */
enum { SSGI_GL_OVERLAP_SHARE = 0,    /* as if each hid its share of what the others leave: 1 - exp(-sum of form factors) */
       SSGI_GL_OVERLAP_ADD };        /* form factors add up, to 1 at most, as published */
/* desc.sends: what surfels send, as ssgi_surfel.colour has it afterwards */
enum { SSGI_GL_SENDS_COLOUR = 0,     /* the colour that they had */
       SSGI_GL_SENDS_LIGHTS,         /* colour times irradiance over pi by t_ssgi_lights, shadowed when desc.shadow is MAP or FILL, else open; and by the environment, open, when desc.environment is not NONE */
       SSGI_GL_SENDS_CUSTOM };       /* your GLSL in desc.fetch: vec3 ssgi_custom_surfel(vec3 position, vec3 normal, vec3 colour), view space */
/* desc.colour: what blur filters */
enum { SSGI_GL_GREY = 0, SSGI_GL_COLOUR, SSGI_GL_VECTORS };   /* ambient visibility; light, three channels; what s3ho wrote */
/* desc.filter */
enum { SSGI_GL_BILATERAL = 0,        /* box over a tile, weighted by distance to the centre's tangent plane (position and normal) */
       SSGI_GL_GAUSSIAN };           /* the paper's: Gaussian, weighted by the inverse of the depth difference [HSAO08 4.1.3] */

/* What you choose when a program is built. Zero is the default everywhere; counts become literal constants in the text, and what is off leaves no
   text behind. Fields that a pass does not use are not looked at, but must be in their limits. ssgi_gl_check names the field that is not. */
typedef struct ssgi_gl_desc {
    int pass;               /* SSGI_GL_SSAO .. */
    int dialect;            /* SSGI_GL_330 .. */
    int orthographic;       /* [limit: 0..1]  1: the camera is orthographic (ssgi_view.orthographic says so) */
    int depth;              /* SSGI_GL_DEPTH_WINDOW .. */
    int normal;             /* SSGI_GL_NORMAL_SIGNED .. */
    int world_normals;      /* [limit: 0..1]  1: the normals are in world space; frame.rotation turns them into view space */
    int noise;              /* SSGI_GL_NOISE_GRADIENT .. */
    int samples;            /* ssao, ssdo, s3ho   [limit: 0..64] [default: 16]  directions per pixel. lights [default: 8]  points on a segment. survey [default: 32] */
    int search;             /* hsao   SSGI_GL_SLICES, SSGI_GL_MARCH */
    int directions;         /* hsao   [limit: 0..32] [default: slices 1, march 6]  slices (two directions each), or N_d */
    int steps;              /* hsao   [limit: 0..64] [default: 6]  per direction: N_s. ssao, ssdo, s3ho [default: 1]  points along a direction, the first blocked one counts */
    int normal_rays;        /* hsao, march only   [limit: 0..8]  N_n: rays above the horizon, per direction; 0 = none */
    int hard;               /* hsao   [limit: 0..1]  1: no attenuation, all within the radius occludes fully */
    int thin;               /* all but senders, shade, field, blur   [limit: 0..1]  0: what is seen extends away from the viewer without end; 1: by frame.thickness */
    int falloff;            /* ssao, ssdo, s3ho   SSGI_GL_FALLOFF_LINEAR .. */
    int kernel;             /* ssao, ssdo, s3ho   [limit: 0..1]  0: one set in the text, turned by the noise; 1: M sets in a texture, the noise picks one */
    int fade;               /* ssao, ssdo, s3ho   SSGI_GL_FADE_NONE .. */
    int range;              /* ssao, ssdo, s3ho   [limit: 0..1]  1: what the picture shows farther than the radius, or below the receiver's plane, blocks nothing [S3HO12 2.1] */
    int layers;             /* all that test points   [limit: 0..8] [default: 1]  depth layers, peeled: matter is from an odd one to the next; an odd last one as thin says */
    int views;              /* all that test points   [limit: 0..4]  extra cameras: a point that any camera sees in the open is; else blocked if one finds it in matter */
    int view_layers;        /* [limit: 0..8] [default: 1]  depth layers of each extra camera */
    int receiver;           /* ssdo, lights, senders   [limit: 0..7, below layers]  which layer is lit: hidden ones become senders */
    int environment;        /* ssdo   SSGI_GL_ENVIRONMENT_NONE .. */
    int bounce;             /* ssdo   SSGI_GL_BOUNCE_NONE ..; one of the two must not be NONE; both at once share the visibility and write two targets */
    int bands;              /* s3ho, shade, blur of vectors, ssdo with SH   [limit: 0..4] [default: 4; ssdo 3]  of spherical harmonics: 1, 4, 9, 16 coefficients; bent normals need 2, and read no more */
    int packed;             /* s3ho, shade, blur of vectors   [limit: 0..1]  0: targets of four floats, RGBA16F, up to four; 1: halves in RGBA32UI, eight a target, up to two a vector */
    int transfer;           /* the same   SSGI_GL_TRANSFER_FREE ..; three vectors must be packed */
    int shaded;             /* s3ho   [limit: 0..1]  1: keeps no vectors: meets frame.harmonics at once and writes light; shade is not drawn */
    int exact;              /* s3ho when shaded, ssdo with SH, shade by HARMONICS   [limit: 0..1]  1: what the bands lack on open surfaces is looked up (t_ssgi_irradiance: ssgi_sh_lacking) and dimmed by ambient visibility; not where transfer is REFLECTED */
    int shading;            /* shade   SSGI_GL_SHADING_HARMONICS .. */
    int lamps;              /* shade   [limit: 0..1]  1: rows of t_ssgi_lights light it too, as harmonics, unshadowed but for the vectors; a POINT is a sphere of radius `least` */
    int albedo;             /* shade   [limit: 0..1]  1: writes outgoing radiance; 0: irradiance over pi */
    int two_sided;          /* ssdo, s3ho   [limit: 0..1]  1: senders shine from both sides; 0: only toward their normal. splat   the same of surfels, which occlude so, too: 1 for sheets and leaves, 0 for what is closed */
    int shadow;             /* lights   SSGI_GL_SHADOW_SEGMENT .. */
    int accumulate;         /* lights   [limit: 0..1]  1: adds to t_ssgi_light, what an earlier pass wrote */
    int radiance;           /* senders   SSGI_GL_RADIANCE_LIGHT .. */
    int storage;            /* field  SSGI_GL_STORAGE_ATLAS .. */
    int measure;            /* field  SSGI_FIELD_VECTOR ..: as the fields were baked */
    int eight_bits;         /* field, ATLAS   [limit: 0..1]  1: the fields have 8 bits a component */
    int cap;                /* field  SSGI_GL_CAP_CLOSED .. */
    int objects;            /* field  SSGI_GL_OBJECTS_NONE .. */
    int effect;             /* splat, unshuffle, smooth, sum   SSGI_GL_EFFECT_OCCLUSION .. */
    int levels;             /* shuffle .. sum   [limit: 0..7] [default: 5]  each doubles the reach; smoothing of the last takes 2^(levels - 1) + 1 taps along each axis */
    int fixed;              /* shuffle .. sum   [limit: 0..1]  which pixel of a block goes to which sub-buffer: 0: by chance, another way in each block; 1: the same everywhere */
    int tessellate;         /* surfels, splat   [limit: 0..1]  0: from a buffer of surfels; 1: from triangles as patches, by tessellation (and for splat geometry) shaders: 410, 450, 320es */
    int sends;              /* surfels, splat when tessellate   SSGI_GL_SENDS_COLOUR .. */
    int enlarge;            /* splat   [limit: 0..1]  levels make up for being drawn to 1 pixel of 4^level by: 0: weight; 1: the radius, the paper's, which is too dark by up to 1/3 at epsilon .1 */
    int closely;            /* splat   [limit: 0..16]  points over a surfel's disc, for pixels within 4 of its radii, where its centre alone finds too little: half at 1/3 radius from a wall; 0, 1: the centre, as published */
    int overlap;            /* sum     SSGI_GL_OVERLAP_SHARE .. */
    int axis;               /* smooth  [limit: 0..1]  0: along x; 1: along y */
    int half;               /* all but lights, senders, field, surfels .. sum   [limit: 0..1]  1: gathers draw one pixel of every 2x2, into targets of half size (rounded up); blur brings it to full size */
    int colour;             /* blur   SSGI_GL_GREY .. */
    int filter;             /* blur   SSGI_GL_BILATERAL, SSGI_GL_GAUSSIAN */
    int filter_radius;      /* blur   [limit: 0..4] [default: bilateral 1, Gaussian 2]  pixels: 1 is 3x3; of half-size pixels when half is 1 */
    int filter_normals;     /* blur   [limit: 0..1]  1: neighbours' normals are compared too, 1 more fetch each */
    int lines;              /* [limit: 0..1]  1: #line directives, so that a compiler's "0:N" is line N of this header */
    const char *version;    /* your first line(s) instead of "#version ..", verbatim; NULL = ours. The dialect still decides the rest. */
    const char *fetch;      /* your GLSL, verbatim before ours, for the CUSTOM choices; NULL = none */
} ssgi_gl_desc;

/* Measured settings: the points of the README's chart. Sets the fields of desc->pass and desc->search that trade cost for accuracy (and the filter's,
   so that the same desc serves blur), leaves the others alone.
     hsao slices   FAST half 1x3, BALANCED half 2x6, BEST full size 3x8 (slices x steps)    hsao march   4x6, 6x9 + 1 normal ray, 8x18 + 2, thin
     ssao          8, 16, 32 points, thin               ssdo, s3ho     half 4x4, 4x4, 8x6 (directions x points), thin, range, fade
   Bad input leaves desc as it is. */
enum { SSGI_GL_FAST, SSGI_GL_BALANCED, SSGI_GL_BEST };
SSGI_DEF ssgi_result ssgi_gl_preset(ssgi_gl_desc *desc, int preset, const char **why);

/* A plan of ssgi_plan_make (ssgi.h) as a desc: the pass that does most of the work, with its settings and the filter's; the rest of desc stays. s3ho becomes shaded and exact; ssdo without an
   environment gets MAP; a bounce is yours to add. Surfels, fields: the pass that draws them. Bad input, or a plan of NOTHING: desc stays as it is. */
SSGI_DEF ssgi_result ssgi_gl_plan(ssgi_gl_desc *desc, const ssgi_plan *plan, const char **why);

/* SSGI_OK, or which field is wrong and what it may be ("desc.steps: must be 0..64"). */
SSGI_DEF ssgi_result ssgi_gl_check(const ssgi_gl_desc *desc, const char **why);

/* ==== >>emit =================================================================================================== */

/* Writes the GLSL of one stage. snprintf's law: returns the length of the whole text without its 0, writes at most capacity bytes, always ends
   them with 0 (when capacity > 0); out may be NULL when capacity is 0. A desc that ssgi_gl_check refuses, or a stage that is none or that the pass
   does not have, returns 0 and writes nothing (but the 0 in the last case). A pure function: the same desc gives the same bytes, whatever the locale. */
SSGI_DEF size_t ssgi_gl_emit(char *out, size_t capacity, const ssgi_gl_desc *desc, int stage);

/* A number for caches of programs: equal when the choices that reach the text are equal (texts in desc.version and desc.fetch by content). */
SSGI_DEF uint64_t ssgi_gl_key(const ssgi_gl_desc *desc);

/* The GLSL of spherical harmonics alone, for your own shaders: twins of ssgi_sh_basis, _zonal, _rotate, _product (ssgi_sh_turn is _rotate) and a dot product, over
   struct ssgi_sh { vec4 a, b, c, d; }, coefficient 4w + k in lane k of the w-th (bands 1: a.x; 2: a; 3: a, b, c.x). snprintf's law. bands [limit: 1..4]; 0 is returned for others. 3 ms a call for 4 bands, whose product has 194 terms. */
SSGI_DEF size_t ssgi_gl_sh(char *out, size_t capacity, int bands);

/* The GLSL of fields for your own shaders (forward, or wherever a position and a normal are at hand), of desc's storage, measure, eight_bits and cap; the samplers t_ssgi_casters, t_ssgi_fields (or the two cube maps),
   t_ssgi_cap are declared in it. float ssgi_field_visibility(int casters, int object, vec3 position, vec3 normal): the product of 1 - occlusion over rows 0 .. casters - 1 but those of that object (0: none), in the space
   that ssgi_gl_caster_set was given. GLES: after "precision highp float; precision highp int;". snprintf's law; 0 for a bad desc. */
SSGI_DEF size_t ssgi_gl_field(char *out, size_t capacity, const ssgi_gl_desc *desc);

/* The most texel fetches that a pixel of this pass makes, 0 for a bad desc; what desc.fetch does counts as one; lights, surfels: with one light, a surfel; field: with one caster; splat: with one surfel; smooth: at the last level. */
SSGI_DEF int ssgi_gl_fetches(const ssgi_gl_desc *desc);

SSGI_DEF const char *ssgi_gl_pass_name(int pass);         /* "hsao"; NULL past the last */
SSGI_DEF const char *ssgi_gl_dialect_name(int dialect);   /* "330", "300es"; NULL past the last */

/* ==== >>io ===================================================================================================== */

enum { SSGI_GL_TEXTURE, SSGI_GL_PARAM, SSGI_GL_OUTPUT, SSGI_GL_CONSTANT, SSGI_GL_ATTRIBUTE, SSGI_GL_CAPTURE };   /* ssgi_gl_io.kind. CAPTURE: a varying for transform feedback */

/* One input or output of a pass: the very row that its declaration was printed from. */
typedef struct ssgi_gl_io {
    const char *name;       /* exactly as in the text: "t_ssgi_depth" */
    int         kind;
    const char *type;       /* GLSL: "sampler2D", "vec4" */
    int         slot;       /* TEXTURE: unit (binding in dialects that have it). OUTPUT, ATTRIBUTE: location. CAPTURE: place in the interleaved buffer. CONSTANT: its value. PARAM: its block's binding: 0 ssgi_frame, 1 ssgi_views */
    size_t      offset;     /* PARAM: byte in ssgi_gl_frame or ssgi_gl_views = byte in the std140 block. Else 0 */
    const char *format;     /* TEXTURE, OUTPUT: what the texture is. PARAM: units */
} ssgi_gl_io;

#define SSGI_GL_MAX_IO 48

/* Writes the rows of a pass in this variant, in the order of the text, at most capacity of them; returns how many there are, 0 for a bad desc. */
SSGI_DEF int ssgi_gl_reflect(const ssgi_gl_desc *desc, ssgi_gl_io *rows, int capacity);

/* ==== >>frame ================================================================================================== */

/* What changes per frame, for all passes: upload it whole as the uniform block "ssgi_frame" (std140; a pass declares the members that it reads, each in its place). */
typedef struct ssgi_gl_frame {
    float   project[4];     /* from ssgi_view */
    float   unproject[4];
    float   decode[4];      /* depth[0], depth[1], clear, 0 */
    int32_t origin[2];      /* [units: texels]  first texel of the picture in the G-buffer's textures */
    int32_t size[2];        /* [units: pixels]  of the picture */
    int32_t target[2];      /* [units: texels]  first texel of the picture in the targets, and in textures that earlier passes wrote; half of it in those of half size */
    float   radius;         /* [units: view] [limit: > 0]  farthest occluder */
    float   offset;         /* [units: half pixels] [default: 1.5]  lift of the receiver along its normal, for nearest fetches: all that test points */
    float   thickness;      /* [units: view] [limit: >= 0] [default: radius]  how far behind what is seen things are taken to reach (desc.thin); 0.7 of it suits ssdo, half march */
    float   phase;          /* [limit: 0..1]  turns the noise; 0, or another value each frame when frames are averaged */
    float   fade;           /* [units: view] [default: 0.3 radii]  where blockers begin to fade (desc.fade SMOOTH); the radius: nowhere */
    float   nearest;        /* [units: radii] [default: 0.25]  clamp of the distance in BOUNCE_PATCH */
    float   gain;           /* [default: 1]  of the patches' area in BOUNCE_PATCH and BOUNCE_DISC: the paper's strength of the bounce */
    float   steepest;       /* [default: 20]  slope, tan of the angle between light and normal, up to which the bias of shadow maps follows */
    int32_t lights;         /* rows of t_ssgi_lights */
    float   lambda;         /* [units: 1/radius] [limit: >= 0] [default: 4]  desc.fade LAMBDA */
    float   rotation[12];   /* world to view, 3 columns padded to 4 (desc.world_normals, ENVIRONMENT_MAP, desc.exact, bent normals); identity by default */
    float   harmonics[48];  /* ENVIRONMENT_SH, SHADING_HARMONICS, desc.shaded: the light's coefficients in view space: ssgi_gl_harmonics_set; black by default */
    float   surfel[4];      /* surfels, smooth: ssgi_gl_surfels_set */
    float   mesh[16];       /* surfels: mesh to view space, column-major; identity by default */
    float   dipole[16];     /* EFFECT_SCATTER: ssgi_gl_dipole_set */
    float   more[2];        /* surfels: ssgi_surfel_desc.aside, .every: ssgi_gl_surfels_set */
    float   front;          /* field, splat: no pixel shows anything nearer [units: view] [default: the near plane]: the nearest depth seen, of the last frame, say, saves most of what stands around the eye */
    float   gap_;
    float   epsilon;        /* splat: the least that a surfel is drawn for [default: 0.1]: form factor, or that times what it sends (times the lobe's peak): a tenth of what counts as bright */
    float   exponent;       /* EFFECT_SPECULAR [limit: >= 0] [default: 32] */
    int32_t level[2];       /* [units: texels]  of one level: ssgi_splat_size */
    float   window[4];      /* desc.lamps: ssgi_sh_window of 4 bands, or of as many as desc.bands; Hann's by default */
} ssgi_gl_frame;

/* Fills a frame: the view, the picture at the origin of textures and targets, defaults everywhere else. radius [units: view] [limit: > 0, finite]. */
SSGI_DEF ssgi_result ssgi_gl_frame_init(ssgi_gl_frame *frame, const ssgi_view *view, float radius, const char **why);

/* Sets what surfels are made with: view, desc (but shrink, and frame.radius in place of most) and mesh_to_view as in ssgi_surfels; levels as in desc.levels. splits: draw the mesh with splits * splits instances; ssgi_surfels_predict tells how many it asks for. */
SSGI_DEF ssgi_result ssgi_gl_surfels_set(ssgi_gl_frame *frame, const ssgi_view *view, const ssgi_surfel_desc *desc, int levels, const float *mesh_to_view, const char **why);

/* Sets frame->dipole; unit: view units of the dipole's unit of length (0.001 when it is per mm and the scene in m). */
SSGI_DEF ssgi_result ssgi_gl_dipole_set(ssgi_gl_frame *frame, const ssgi_dipole *dipole, float unit, const char **why);

/* Sets frame->harmonics: coefficients [3*i + c] of 1..4 bands in the world, turned by world_to_view (NULL: in view space already). */
SSGI_DEF ssgi_result ssgi_gl_harmonics_set(ssgi_gl_frame *frame, const float *coefficients, int bands, const float *world_to_view, const char **why);

/* The extra cameras (desc.views): the uniform block "ssgi_views", binding 1. Their depths are hardware depths in the slices of one array texture, camera v's
   layer j in slice v * view_layers + j, from texel 0,0 on; each camera may use a part of it. */
typedef struct ssgi_gl_views {
    float   to[4][16];      /* view space to x, y, z, 1: pixels (times z when perspective) and view depth of that camera; column-major */
    float   from[4][16];    /* back */
    float   decode[4][4];   /* ssgi_view.depth[0], [1], clear, orthographic */
    float   size[4][4];     /* [units: pixels]  width, height; slack: what lies less before a surface is not known to be in the open, at depth 1 when perspective; 0 */
} ssgi_gl_views;

/* Sets camera i of 0..3. Both matrices are rigid, world to view: of the camera of the picture, and of the extra one whose projection `view` decodes. */
SSGI_DEF ssgi_result ssgi_gl_views_set(ssgi_gl_views *views, int i, const ssgi_view *view, const float picture_world_to_view[16],
                                       const float extra_world_to_view[16], const char **why);

/* A light: one row of the texture t_ssgi_lights, 8 texels of RGBA32F, byte for byte. All zero but the first eight members is a light without a shadow map.
   A SPOT lights only what its map sees, with desc.shadow MAP or FILL: six of them are a point light with a cube of maps. */
enum { SSGI_GL_SUN = 0, SSGI_GL_POINT, SSGI_GL_SPOT, SSGI_GL_VPL };
typedef struct ssgi_gl_light {
    float at[3], kind;      /* SUN: unit vector to the light; else where it is; view space. kind: SSGI_GL_SUN .. */
    float colour[3], least; /* SUN: irradiance facing it; POINT, SPOT: radiant intensity; VPL: radiant intensity along its normal. least: the distance below which 1/d^2 grows no more */
    float normal[3], patch; /* VPL: unit normal, falls off by the cosine. patch: width of a texel of the map, at depth 1 when perspective (ssgi_shadow_patch) */
    float map[3][4];        /* view space to x, y (texels in the tile, times depth when perspective) and view depth of the light's camera: rows */
    float decode[4];        /* of its ssgi_view: depth[0], [1], clear, orthographic */
    float tile[4];          /* [units: texels]  x, y, width, height of the map in the atlas t_ssgi_shadow; width 0: no map */
} ssgi_gl_light;

/* Gives a light its shadow map: drawn by a camera (rigid world to view, projection decoded as `view`) into texels x, y .. of the atlas. */
SSGI_DEF ssgi_result ssgi_gl_light_map(ssgi_gl_light *light, const ssgi_view *view, int x, int y, const float picture_world_to_view[16],
                                       const float light_world_to_view[16], const char **why);

/* A caster: one row of the texture t_ssgi_casters, 10 texels of RGBA32F, byte for byte. ssgi_gl_caster_set fills it. */
typedef struct ssgi_gl_caster {
    float at[3], reach;     /* the sphere that it reaches, view space */
    float to_field[3][4];   /* view space to the caster's coordinates about the field's centre: rows */
    float ramp, end, inside, power;     /* ssgi_field_limits */
    float low[8], span[8];
    float resolution, slice, fitted, object;   /* slice: of t_ssgi_fields. fitted: ssgi_field.reach. object: a whole number, what desc.objects compares; 0 = none */
} ssgi_gl_caster;

/* Sets a caster where it stands now.
     limits        NULL: ssgi_field_limits_of     slice   [limit: 0..2047] of t_ssgi_fields; smaller fields than the array's slices stand in their lower corner
     mesh_to_view  [limit: rotation, translation and uniform scale] from the coordinates that the field was baked in to those of the pass: world to view times object to world
     object        [limit: 0..16777215]
   Outputs are untouched when something is wrong. */
SSGI_DEF ssgi_result ssgi_gl_caster_set(ssgi_gl_caster *caster, const ssgi_field *field, const ssgi_field_limits *limits, const float mesh_to_view[16], int slice, int object, const char **why);

#ifdef __cplusplus
}
#endif
#endif /* SSGI_GL_H: END OF HEADER ------------------------------------------------------------------------------------- */

#if defined(SSGI_GL_IMPLEMENTATION) && !defined(SSGI_GL_IMPLEMENTED)
#define SSGI_GL_IMPLEMENTED

#include <math.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ==== >>features: what a desc asks for, as bits ================================================================== */

/* A row or a chunk exists in a variant when all bits that it needs are set. */
#define SSGI_GL__BIT(n)          ((uint64_t)1 << (n))
#define SSGI_GL__PERSPECTIVE     SSGI_GL__BIT(0)
#define SSGI_GL__ORTHOGRAPHIC    SSGI_GL__BIT(1)
#define SSGI_GL__GBUFFER         SSGI_GL__BIT(2) /* depth or normals are read */
#define SSGI_GL__D_TEXTURE       SSGI_GL__BIT(3) /* depth: through a texture of ours, and what it holds */
#define SSGI_GL__D_WINDOW        SSGI_GL__BIT(4)
#define SSGI_GL__D_LINEAR        SSGI_GL__BIT(5)
#define SSGI_GL__D_CUSTOM        SSGI_GL__BIT(6)
#define SSGI_GL__NORMALS         SSGI_GL__BIT(7) /* normals are read */
#define SSGI_GL__N_TEXTURE       SSGI_GL__BIT(8) /* through a texture of ours, and what it holds */
#define SSGI_GL__N_SIGNED        SSGI_GL__BIT(9)
#define SSGI_GL__N_UNSIGNED      SSGI_GL__BIT(10)
#define SSGI_GL__N_OCTA          SSGI_GL__BIT(11)
#define SSGI_GL__N_CUSTOM        SSGI_GL__BIT(12)
#define SSGI_GL__N_DEPTH         SSGI_GL__BIT(13) /* from depth */
#define SSGI_GL__N_VIEW          SSGI_GL__BIT(14) /* in view space, in world space */
#define SSGI_GL__N_WORLD         SSGI_GL__BIT(15)
#define SSGI_GL__TOWARD          SSGI_GL__BIT(16) /* the direction to the eye is needed */
#define SSGI_GL__POSITION        SSGI_GL__BIT(17) /* points are asked for */
#define SSGI_GL__LOBES           SSGI_GL__BIT(18) /* vectors are made from directions */
#define SSGI_GL__BY_SENT         SSGI_GL__BIT(19) /* splat: the reach follows what a surfel sends, not its form factor alone */
#define SSGI_GL__FULL            SSGI_GL__BIT(20) /* size of what gathers draw */
#define SSGI_GL__HALF            SSGI_GL__BIT(21)
#define SSGI_GL__SOLID           SSGI_GL__BIT(22) /* how far what is seen reaches */
#define SSGI_GL__THIN            SSGI_GL__BIT(23)
#define SSGI_GL__FIXED           SSGI_GL__BIT(24) /* thin: by the thickness alone; in lights by a segment's length too */
#define SSGI_GL__REACH           SSGI_GL__BIT(25)
#define SSGI_GL__BLOCKED         SSGI_GL__BIT(26) /* points are tested: ssao, ssdo, lights, normal rays */
#define SSGI_GL__SHALLOW         SSGI_GL__BIT(27) /* against the depth buffer alone; against more */
#define SSGI_GL__DEEP            SSGI_GL__BIT(28)
#define SSGI_GL__LAYERS          SSGI_GL__BIT(29) /* layers of the picture's camera: several, one */
#define SSGI_GL__ONE_LAYER       SSGI_GL__BIT(30)
#define SSGI_GL__VIEWS           SSGI_GL__BIT(31) /* extra cameras */
#define SSGI_GL__LOOK            SSGI_GL__BIT(33) /* the blocker itself is looked at: FADE or SENDERS */
#define SSGI_GL__FADE            SSGI_GL__BIT(34)
#define SSGI_GL__NO_FADE         SSGI_GL__BIT(35)
#define SSGI_GL__SENDERS         SSGI_GL__BIT(36) /* a bounce */
#define SSGI_GL__FIRST           SSGI_GL__BIT(37) /* receiver: what is seen, a hidden layer */
#define SSGI_GL__HIDDEN          SSGI_GL__BIT(38)
#define SSGI_GL__WORLD           SSGI_GL__BIT(39) /* world space is met: normals or an environment */
#define SSGI_GL__PROJECT         SSGI_GL__BIT(40) /* points are lifted and projected, or the width of a pixel is asked for */
#define SSGI_GL__OCTAHEDRON      SSGI_GL__BIT(41) /* an environment map is read, or normals are packed */
#define SSGI_GL__NORMALS_SENT    SSGI_GL__BIT(42) /* senders: their normals matter */
#define SSGI_GL__DEPTHS          SSGI_GL__BIT(43) /* points are tested against depth textures; else against what senders wrote, which holds depth too */
#define SSGI_GL__LAYERS_READ     SSGI_GL__BIT(44) /* hidden layers are read: for the test, or as the receiver */
#define SSGI_GL__INSIDE          SSGI_GL__BIT(45) /* pixels are asked whether they lie in the picture */
#define SSGI_GL__RECEIVED        SSGI_GL__BIT(46) /* what is found depends on where the receiver is */
#define SSGI_GL__SEEN            SSGI_GL__BIT(32) /* the depth of what is seen is read; only that of a hidden receiver */
#define SSGI_GL__UNSEEN          SSGI_GL__BIT(47)
/* From 48 on there are four words of bits; a need has bits of one of them beside the common ones, and so has what is added at once. */
#define SSGI_GL__OWN(word, n)    ((uint64_t)(word) << 62 | SSGI_GL__BIT(48 + (n)))
#define SSGI_GL__COMMON          (SSGI_GL__BIT(48) - 1)
/* word 0, vectors: s3ho, shade, blur, where their meaning is one; else each pass has its own meanings */
#define SSGI_GL__VECTORS         SSGI_GL__OWN(0, 5)
#define SSGI_GL__V2              SSGI_GL__OWN(0, 6) /* at least so many bands */
#define SSGI_GL__V3              SSGI_GL__OWN(0, 7)
#define SSGI_GL__V4              SSGI_GL__OWN(0, 8)
#define SSGI_GL__WORDS           SSGI_GL__OWN(0, 9) /* storage: four floats a texel, halves packed into integers */
#define SSGI_GL__PACKED          SSGI_GL__OWN(0, 10)
#define SSGI_GL__MONO            SSGI_GL__OWN(0, 11) /* one vector, one a channel */
#define SSGI_GL__RGB             SSGI_GL__OWN(0, 12)
#define SSGI_GL__FREE            SSGI_GL__OWN(0, 13) /* s3ho: what is free; else only what blockers reflect */
#define SSGI_GL__SINGLE          SSGI_GL__OWN(0, 0) /* ssao, ssdo, s3ho: points along a direction */
#define SSGI_GL__SEVERAL         SSGI_GL__OWN(0, 1)
#define SSGI_GL__K_TEXT          SSGI_GL__OWN(0, 2) /* kernel */
#define SSGI_GL__K_TEXTURE       SSGI_GL__OWN(0, 3)
#define SSGI_GL__RAYS            SSGI_GL__OWN(0, 0) /* hsao: march with normal rays */
#define SSGI_GL__LINEAR          SSGI_GL__OWN(0, 1) /* attenuation */
#define SSGI_GL__HARD            SSGI_GL__OWN(0, 2)
#define SSGI_GL__MAPS_READ       SSGI_GL__OWN(0, 0) /* lights: shadow maps */
#define SSGI_GL__SEGMENTS        SSGI_GL__OWN(0, 1) /* points on segments */
#define SSGI_GL__ADD             SSGI_GL__OWN(0, 2) /* accumulate */
#define SSGI_GL__ALBEDO          SSGI_GL__OWN(0, 0) /* senders, shade: albedo is read */
#define SSGI_GL__S_LIGHT         SSGI_GL__OWN(0, 1) /* senders: and the light that falls on it */
#define SSGI_GL__S_DIRECT        SSGI_GL__OWN(0, 2)
#define SSGI_GL__LAMPS           SSGI_GL__OWN(0, 1) /* shade: lights as harmonics */
#define SSGI_GL__HARMONICS       SSGI_GL__OWN(0, 4) /* s3ho, shade: vectors meet light in the dot product; shade: or by the mean free direction */
#define SSGI_GL__CONES           SSGI_GL__OWN(0, 3)
#define SSGI_GL__BILATERAL       SSGI_GL__OWN(0, 0) /* blur */
#define SSGI_GL__GAUSSIAN        SSGI_GL__OWN(0, 1)
#define SSGI_GL__F_NORMALS       SSGI_GL__OWN(0, 2) /* compares normals */
#define SSGI_GL__GREY            SSGI_GL__OWN(0, 3)
#define SSGI_GL__COLOUR          SSGI_GL__OWN(0, 4)
/* word 0 in field */
#define SSGI_GL__ATLAS           SSGI_GL__OWN(0, 0) /* storage */
#define SSGI_GL__CUBES           SSGI_GL__OWN(0, 1)
#define SSGI_GL__VECTOR_KEPT     SSGI_GL__OWN(0, 2) /* measure */
#define SSGI_GL__ANGLE_KEPT      SSGI_GL__OWN(0, 3)
#define SSGI_GL__BITS16          SSGI_GL__OWN(0, 4)
#define SSGI_GL__BITS8           SSGI_GL__OWN(0, 6)
#define SSGI_GL__CAP_CLOSED      SSGI_GL__OWN(0, 7)
#define SSGI_GL__CAP_TABLE       SSGI_GL__OWN(0, 8)
#define SSGI_GL__OBJECTS         SSGI_GL__OWN(0, 9) /* pixels tell their object: through a texture of ours, your way */
#define SSGI_GL__O_TEXTURE       SSGI_GL__OWN(0, 10)
#define SSGI_GL__O_CUSTOM        SSGI_GL__OWN(0, 11)
/* word 0 in surfels .. sum, beside MAPS_READ, GREY, COLOUR and BILATERAL */
#define SSGI_GL__RANDOM          SSGI_GL__OWN(0, 1) /* layout */
#define SSGI_GL__REGULAR         SSGI_GL__OWN(0, 2)
#define SSGI_GL__NEAR            SSGI_GL__OWN(0, 2) /* splat: surfels at hand are looked at more closely */
#define SSGI_GL__FORM            SSGI_GL__OWN(0, 5) /* effects: by the form factor, which are */
#define SSGI_GL__OCCLUDES        SSGI_GL__OWN(0, 6)
#define SSGI_GL__HIDES           SSGI_GL__OWN(0, 7)
#define SSGI_GL__BRINGS          SSGI_GL__OWN(0, 8)
#define SSGI_GL__MIRRORS         SSGI_GL__OWN(0, 9)
#define SSGI_GL__SCATTERS        SSGI_GL__OWN(0, 10)
#define SSGI_GL__SOFT            SSGI_GL__OWN(0, 11) /* occlusion ends at the radius */
#define SSGI_GL__ENLARGED        SSGI_GL__OWN(0, 12)
#define SSGI_GL__WEIGHTED        SSGI_GL__OWN(0, 13)
/* word 1, light */
#define SSGI_GL__E_LIT           SSGI_GL__OWN(1, 0) /* ssdo, s3ho: an environment lights; by look-ups */
#define SSGI_GL__E_MAP           SSGI_GL__OWN(1, 2)
#define SSGI_GL__BY_ONE          SSGI_GL__OWN(1, 1) /* splat: the reach is that of a form factor alone */
#define SSGI_GL__SOLID_ANGLE     SSGI_GL__OWN(1, 4) /* bounce */
#define SSGI_GL__AREA            SSGI_GL__OWN(1, 5) /* PATCH or DISC */
#define SSGI_GL__PATCH           SSGI_GL__OWN(1, 6)
#define SSGI_GL__DISC            SSGI_GL__OWN(1, 7)
#define SSGI_GL__ONE_SIDED       SSGI_GL__OWN(1, 8)
#define SSGI_GL__TWO_SIDED       SSGI_GL__OWN(1, 9)
#define SSGI_GL__SENDER_KEPT     SSGI_GL__OWN(1, 10) /* the sender's normal is asked for */
#define SSGI_GL__I_MAP           SSGI_GL__OWN(1, 11) /* an irradiance map is read */
#define SSGI_GL__BENT_OUT        SSGI_GL__OWN(1, 3) /* shade: that direction comes out, its irradiance is looked up, its cone's light is */
#define SSGI_GL__BENT_NORMAL     SSGI_GL__OWN(1, 12)
#define SSGI_GL__BENT_CONE       SSGI_GL__OWN(1, 13)
/* word 2, weights and packing */
#define SSGI_GL__UNIFORM         SSGI_GL__OWN(2, 0) /* falloff */
#define SSGI_GL__SQUARE          SSGI_GL__OWN(2, 1)
#define SSGI_GL__CUBE            SSGI_GL__OWN(2, 2)
#define SSGI_GL__SMOOTH          SSGI_GL__OWN(2, 3) /* fade */
#define SSGI_GL__LAMBDA          SSGI_GL__OWN(2, 4)
#define SSGI_GL__ENDED           SSGI_GL__OWN(2, 6)
#define SSGI_GL__SHADED          SSGI_GL__OWN(2, 5) /* shade: light comes out */
#define SSGI_GL__RANGE           SSGI_GL__OWN(2, 7)
#define SSGI_GL__FACING          SSGI_GL__OWN(2, 8) /* the receiver's normal is asked for where blockers are looked at */
#define SSGI_GL__HALF_NATIVE     SSGI_GL__OWN(2, 9) /* packHalf2x16 is in the language, or not */
#define SSGI_GL__HALF_MADE       SSGI_GL__OWN(2, 10)
#define SSGI_GL__PACKS           SSGI_GL__OWN(2, 11) /* written, read */
#define SSGI_GL__UNPACKS         SSGI_GL__OWN(2, 12)
#define SSGI_GL__PLAIN           SSGI_GL__OWN(2, 13) /* blur: not of vectors */

/* word 3, noise, and what harmonics lack */
#define SSGI_GL__NOISE_GRADIENT  SSGI_GL__OWN(3, 0)
#define SSGI_GL__NOISE_TILE4     SSGI_GL__OWN(3, 1)
#define SSGI_GL__NOISE_TEXTURE   SSGI_GL__OWN(3, 2)
#define SSGI_GL__EXACT           SSGI_GL__OWN(3, 3) /* open surfaces are exact: of environment and suns, of lamps, in shade, which has no normal else */
#define SSGI_GL__EXACT_LAMPS     SSGI_GL__OWN(3, 4)
#define SSGI_GL__EXACT_SHADE     SSGI_GL__OWN(3, 5)
#define SSGI_GL__BENT_LIT        SSGI_GL__OWN(3, 6) /* shade: BENT_NORMAL or BENT_CONE */
#define SSGI_GL__STORES          SSGI_GL__OWN(3, 7) /* vectors are written */
#define SSGI_GL__COSINE          SSGI_GL__OWN(3, 8) /* the clamped cosine's harmonics are asked for */
#define SSGI_GL__LIGHT_ROWS      SSGI_GL__OWN(3, 9) /* t_ssgi_lights is walked: lights, lamps of shade */

#define SSGI_GL__TESSELLATED     SSGI_GL__OWN(3, 10) /* surfels, splat: from triangles, from a buffer */
#define SSGI_GL__BUFFERED        SSGI_GL__OWN(3, 11)
#define SSGI_GL__S_CUSTOM        SSGI_GL__OWN(3, 12) /* what surfels send */
#define SSGI_GL__S_LIT           SSGI_GL__OWN(3, 13)
#define SSGI_GL__ADDS_UP         SSGI_GL__OWN(0, 12) /* sum: overlap */
#define SSGI_GL__SHARES          SSGI_GL__OWN(0, 13)

typedef struct ssgi_gl__set { uint64_t word[4]; } ssgi_gl__set;

static void ssgi_gl__add(ssgi_gl__set *set, uint64_t bits)
{
    int i;
    for (i = 0; i < 4; ++i) set->word[i] |= bits & SSGI_GL__COMMON;
    set->word[bits >> 62] |= bits;
}

static int ssgi_gl__has(const ssgi_gl__set *set, uint64_t need) { return (set->word[need >> 62] & need) == need; }

typedef struct ssgi_gl__chunk { int line; uint64_t need; const char *text; } ssgi_gl__chunk;
typedef struct ssgi_gl__row { uint64_t need; ssgi_gl_io io; } ssgi_gl__row;   /* CONSTANT: io.offset is the field's place in ssgi_gl_desc */

/* ==== >>rows: inputs and outputs ================================================================================= */

#define SSGI_GL__P(need, name, type, member, units) { need, { "u_ssgi_" name, SSGI_GL_PARAM, type, 0, offsetof(ssgi_gl_frame, member), units } }
#define SSGI_GL__V(need, name, type, member, units) { need, { "u_ssgi_view_" name, SSGI_GL_PARAM, type, 1, offsetof(ssgi_gl_views, member), units } }
#define SSGI_GL__C(need, name, field)                   { need, { name, SSGI_GL_CONSTANT, "int", 0, offsetof(ssgi_gl_desc, field), "" } }
#define SSGI_GL__T(need, name, format)                  { need, { "t_ssgi_" name, SSGI_GL_TEXTURE, "sampler2D", 0, 0, format } }
#define SSGI_GL__A(need, name, type, format)            { need, { "t_ssgi_" name, SSGI_GL_TEXTURE, type "2DArray", 0, 0, format } }
#define SSGI_GL__O(need, name, type, format)            { need, { "o_ssgi_" name, SSGI_GL_OUTPUT, type, 0, 0, format } }

static const ssgi_gl__row ssgi_gl__project     = SSGI_GL__P(0, "project", "vec4", project, "pixels per view xy / depth; pixels");
static const ssgi_gl__row ssgi_gl__unproject   = SSGI_GL__P(SSGI_GL__POSITION, "unproject", "vec4", unproject, "view xy / depth per pixel");
static const ssgi_gl__row ssgi_gl__decode_row  = SSGI_GL__P(SSGI_GL__D_WINDOW, "decode", "vec4", decode, "window depth to view depth");
static const ssgi_gl__row ssgi_gl__origin      = SSGI_GL__P(SSGI_GL__GBUFFER, "origin", "ivec2", origin, "texels");
static const ssgi_gl__row ssgi_gl__size        = SSGI_GL__P(SSGI_GL__INSIDE, "size", "ivec2", size, "pixels");
static const ssgi_gl__row ssgi_gl__target      = SSGI_GL__P(0, "target", "ivec2", target, "texels");
static const ssgi_gl__row ssgi_gl__radius      = SSGI_GL__P(0, "radius", "float", radius, "view units");
static const ssgi_gl__row ssgi_gl__near_radius = SSGI_GL__P(SSGI_GL__BILATERAL, "radius", "float", radius, "view units");
static const ssgi_gl__row ssgi_gl__soft_radius = SSGI_GL__P(SSGI_GL__SOFT, "radius", "float", radius, "view units");
static const ssgi_gl__row ssgi_gl__offset      = SSGI_GL__P(0, "offset", "float", offset, "half pixels");
static const ssgi_gl__row ssgi_gl__p_project   = SSGI_GL__P(SSGI_GL__BLOCKED, "project", "vec4", project, "pixels per view xy / depth; pixels");
static const ssgi_gl__row ssgi_gl__p_radius    = SSGI_GL__P(SSGI_GL__BLOCKED, "radius", "float", radius, "view units");
static const ssgi_gl__row ssgi_gl__p_offset    = SSGI_GL__P(SSGI_GL__BLOCKED, "offset", "float", offset, "half pixels");
static const ssgi_gl__row ssgi_gl__p_phase     = SSGI_GL__P(SSGI_GL__BLOCKED, "phase", "float", phase, "turns");
static const ssgi_gl__row ssgi_gl__thickness   = SSGI_GL__P(SSGI_GL__THIN, "thickness", "float", thickness, "view units");
static const ssgi_gl__row ssgi_gl__phase       = SSGI_GL__P(0, "phase", "float", phase, "turns");
static const ssgi_gl__row ssgi_gl__rotation    = SSGI_GL__P(SSGI_GL__WORLD, "rotation", "mat3", rotation, "world to view");
static const ssgi_gl__row ssgi_gl__lit_rotation = SSGI_GL__P(SSGI_GL__S_LIT | SSGI_GL__WORLD, "rotation", "mat3", rotation, "world to view");
static const ssgi_gl__row ssgi_gl__fade_row    = SSGI_GL__P(SSGI_GL__SMOOTH, "fade", "float", fade, "view units");
static const ssgi_gl__row ssgi_gl__nearest     = SSGI_GL__P(SSGI_GL__PATCH, "nearest", "float", nearest, "radii");
static const ssgi_gl__row ssgi_gl__gain        = SSGI_GL__P(SSGI_GL__AREA, "gain", "float", gain, "");
static const ssgi_gl__row ssgi_gl__steepest    = SSGI_GL__P(SSGI_GL__MAPS_READ, "steepest", "float", steepest, "tan");
static const ssgi_gl__row ssgi_gl__lights_row  = SSGI_GL__P(SSGI_GL__LIGHT_ROWS, "lights", "int", lights, "rows of t_ssgi_lights");
static const ssgi_gl__row ssgi_gl__lambda_row  = SSGI_GL__P(SSGI_GL__LAMBDA, "lambda", "float", lambda, "per radius");
static const ssgi_gl__row ssgi_gl__harmonics_row = SSGI_GL__P(SSGI_GL__HARMONICS, "harmonics", "vec4[12]", harmonics, "light, view space: coefficients 4w .. 4w + 3 of channel c at 3w + c");
static const ssgi_gl__row ssgi_gl__window_row  = SSGI_GL__P(SSGI_GL__LAMPS, "window", "vec4", window, "a band");
static const ssgi_gl__row ssgi_gl__view_to     = SSGI_GL__V(SSGI_GL__VIEWS, "to", "mat4[4]", to, "view space to pixels (times depth) and depth");
static const ssgi_gl__row ssgi_gl__view_from   = SSGI_GL__V(SSGI_GL__VIEWS | SSGI_GL__LOOK, "from", "mat4[4]", from, "and back");
static const ssgi_gl__row ssgi_gl__view_decode = SSGI_GL__V(SSGI_GL__VIEWS, "decode", "vec4[4]", decode, "window depth to view depth; w: orthographic");
static const ssgi_gl__row ssgi_gl__view_size   = SSGI_GL__V(SSGI_GL__VIEWS, "size", "vec4[4]", size, "pixels; z: slack of surfaces, per depth");
static const ssgi_gl__row ssgi_gl__depth_tex   = SSGI_GL__T(SSGI_GL__D_TEXTURE | SSGI_GL__SEEN, "depth", "depth: hardware depth (any DEPTH_COMPONENT, compare mode off) or R32F view depth");
static const ssgi_gl__row ssgi_gl__normal_tex  = SSGI_GL__T(SSGI_GL__N_TEXTURE | SSGI_GL__FIRST, "normal", "normal: RGBA16F, RGB10_A2, RG16F .. as desc.normal says");
static const ssgi_gl__row ssgi_gl__normals_tex = SSGI_GL__A(SSGI_GL__N_TEXTURE | SSGI_GL__HIDDEN, "normal", "sampler", "normals of layers 2 .. in slices 0 ..: as desc.normal says");
static const ssgi_gl__row ssgi_gl__layers_tex  = SSGI_GL__A(SSGI_GL__LAYERS_READ | SSGI_GL__D_TEXTURE, "layers", "sampler", "layers 2 .. in slices 0 ..: as t_ssgi_depth");
static const ssgi_gl__row ssgi_gl__views_tex   = SSGI_GL__A(SSGI_GL__VIEWS | SSGI_GL__DEPTHS, "views", "sampler", "extra cameras: hardware depth, slice camera * view_layers + layer");
static const ssgi_gl__row ssgi_gl__senders_tex = SSGI_GL__A(SSGI_GL__SENDERS, "senders", "usampler", "RG32UI: what senders wrote, a slice a layer");
static const ssgi_gl__row ssgi_gl__view_senders = SSGI_GL__A(SSGI_GL__SENDERS | SSGI_GL__VIEWS, "view_senders", "usampler", "RG32UI: the same of extra cameras, slice camera * view_layers + layer");
static const ssgi_gl__row ssgi_gl__kernel_tex  = SSGI_GL__T(SSGI_GL__K_TEXTURE, "kernel", "RGBA32F or RGBA16F, a row a set: ssgi_kernel, SSGI_COSINE");
static const ssgi_gl__row ssgi_gl__map_tex     = SSGI_GL__T(SSGI_GL__E_MAP, "environment", "RGB32F, RGB16F ..: ssgi_environment_map, a sample's solid angle");
static const ssgi_gl__row ssgi_gl__open_tex    = SSGI_GL__A(SSGI_GL__I_MAP, "irradiance", "sampler", "RGB32F, RGB16F ..: slice 0 ssgi_environment_map, solid angle 0, with exact harmonics less those (ssgi_sh_lacking); for cones slice k of n is ssgi_environment_cone, cosine k/n");
static const ssgi_gl__row ssgi_gl__lights_tex  = SSGI_GL__T(SSGI_GL__LIGHT_ROWS, "lights", "RGBA32F, 8 wide: a row a ssgi_gl_light");
static const ssgi_gl__row ssgi_gl__shadow_tex  = SSGI_GL__T(SSGI_GL__MAPS_READ, "shadow", "depth: hardware depth, compare mode off; the shadow maps as tiles");
static const ssgi_gl__row ssgi_gl__added_tex   = SSGI_GL__T(SSGI_GL__ADD, "light", "what an earlier pass wrote: RGBA32F or RGBA16F");
static const ssgi_gl__row ssgi_gl__albedo_tex  = SSGI_GL__T(SSGI_GL__ALBEDO | SSGI_GL__FIRST, "albedo", "RGBA8, RGBA16F ..: linear albedo");
static const ssgi_gl__row ssgi_gl__albedos_tex = SSGI_GL__A(SSGI_GL__ALBEDO | SSGI_GL__HIDDEN, "albedo", "sampler", "albedos of layers 2 .. in slices 0 ..");
static const ssgi_gl__row ssgi_gl__s_light_tex = SSGI_GL__T(SSGI_GL__S_LIGHT, "light", "what ssdo, shade or lights wrote: RGBA32F or RGBA16F");
static const ssgi_gl__row ssgi_gl__direct_tex  = SSGI_GL__T(SSGI_GL__S_DIRECT, "direct", "your outgoing radiance: RGBA16F, R11F_G11F_B10F ..");
static const ssgi_gl__row ssgi_gl__noise_tex   = SSGI_GL__T(SSGI_GL__NOISE_TEXTURE, "noise", "RGBA16F, any size: ssgi_jitter_tile");
static const ssgi_gl__row ssgi_gl__ao_tex      = SSGI_GL__T(SSGI_GL__GREY, "ao", "what ssao or hsao wrote: RG32F or RG16F");
static const ssgi_gl__row ssgi_gl__light_tex   = SSGI_GL__T(SSGI_GL__COLOUR, "light", "what ssdo, shade or lights wrote: RGBA32F or RGBA16F");
static const ssgi_gl__row ssgi_gl__frame_size  = SSGI_GL__P(0, "size", "ivec2", size, "pixels");
static const ssgi_gl__row ssgi_gl__casters_tex = SSGI_GL__T(0, "casters", "RGBA32F, 10 wide: a row a ssgi_gl_caster");
static const ssgi_gl__row ssgi_gl__fields_tex  = SSGI_GL__A(SSGI_GL__ATLAS | SSGI_GL__BITS16, "fields", "usampler", "RGBA32UI: ssgi_field.texels, a slice a field");
static const ssgi_gl__row ssgi_gl__fields8_tex = SSGI_GL__A(SSGI_GL__ATLAS | SSGI_GL__BITS8, "fields", "usampler", "RG32UI: ssgi_field.texels, a slice a field");
static const ssgi_gl__row ssgi_gl__cube_tex    = { SSGI_GL__CUBES, { "t_ssgi_field", SSGI_GL_TEXTURE, "samplerCube", 0, 0, "RGBA16 or RGBA8, LINEAR, seamless: ssgi_field_cube, distance" } };
static const ssgi_gl__row ssgi_gl__centre_tex  = { SSGI_GL__CUBES, { "t_ssgi_field_centre", SSGI_GL_TEXTURE, "samplerCube", 0, 0, "the same: ssgi_field_cube, centre" } };
static const ssgi_gl__row ssgi_gl__cap_tex     = SSGI_GL__T(SSGI_GL__CAP_TABLE, "cap", "R16F or R32F, LINEAR, CLAMP_TO_EDGE: ssgi_cap_table");
static const ssgi_gl__row ssgi_gl__objects_tex = { SSGI_GL__O_TEXTURE, { "t_ssgi_objects", SSGI_GL_TEXTURE, "usampler2D", 0, 0, "R8UI, R16UI or R32UI: number of the object that a pixel shows, 0 = none" } };
static const ssgi_gl__row ssgi_gl__factor_out  = SSGI_GL__O(0, "ao", "float", "R8, R16F ..: what ambient visibility there is is multiplied by");
static const ssgi_gl__row ssgi_gl__ao_out      = SSGI_GL__O(0, "ao", "vec2", "RG32F or RG16F: ambient visibility, view depth for the filter; R8 or R16F if nothing filters");
static const ssgi_gl__row ssgi_gl__survey_out  = SSGI_GL__O(0, "survey", "vec4", "RGBA16F or RGBA32F, an eighth of the picture's width and height, rounded up: shares of points around a surface; -1 where nothing is seen");
static const ssgi_gl__row ssgi_gl__blurred_out = SSGI_GL__O(SSGI_GL__GREY, "ao", "float", "R8 or R16F: ambient visibility");
static const ssgi_gl__row ssgi_gl__colour_out  = SSGI_GL__O(SSGI_GL__COLOUR, "light", "vec4", "RGBA32F or RGBA16F: the same three channels, view depth");
static const ssgi_gl__row ssgi_gl__light_out   = SSGI_GL__O(SSGI_GL__E_LIT, "light", "vec4", "RGBA32F or RGBA16F: irradiance over pi, view depth for the filter");
static const ssgi_gl__row ssgi_gl__bounce_out  = SSGI_GL__O(SSGI_GL__SENDERS, "bounce", "vec4", "RGBA32F or RGBA16F: irradiance over pi from the bounce, view depth");
static const ssgi_gl__row ssgi_gl__lights_out  = SSGI_GL__O(0, "light", "vec4", "RGBA32F or RGBA16F: irradiance over pi, view depth");
static const ssgi_gl__row ssgi_gl__sender_out  = SSGI_GL__O(0, "sender", "uvec2", "RG32UI: outgoing radiance as 9 9 9 bits and 5 of exponent; view depth as 6 bits of exponent and 14, octahedral view-space normal as 6 6");
static const ssgi_gl__row ssgi_gl__bent_out    = SSGI_GL__O(SSGI_GL__BENT_OUT, "bent", "vec4", "RGBA16F ..: mean free direction, view space, unit; cosine of the cone's half-angle");
static const ssgi_gl__row ssgi_gl__shaded_out  = SSGI_GL__O(SSGI_GL__SHADED, "light", "vec4", "RGBA32F or RGBA16F: irradiance over pi, or radiance, view depth for the filter");
/* What s3ho writes and shade and blur read: a texture and an output of one name each. */
#define SSGI_GL__VECTOR(id, need, name, sampler, type, format) \
    static const ssgi_gl__row ssgi_gl__t_##id = { need, { "t_ssgi_" name, SSGI_GL_TEXTURE, sampler, 0, 0, format } }; \
    static const ssgi_gl__row ssgi_gl__o_##id = { need, { "o_ssgi_" name, SSGI_GL_OUTPUT, type, 0, 0, format } };
#define SSGI_GL__FLOATS(id, need, format) SSGI_GL__VECTOR(id, (need) | SSGI_GL__WORDS, #id, "sampler2D", "vec4", "RGBA16F or RGBA32F: " format)
#define SSGI_GL__HALVES(id, need, name, format) SSGI_GL__VECTOR(id, (need) | SSGI_GL__PACKED, name, "usampler2D", "uvec4", "RGBA32UI: " format)
SSGI_GL__FLOATS(sh0, SSGI_GL__VECTORS, "coefficients 0..3; R16F suffices for 1 band")
SSGI_GL__FLOATS(sh1, SSGI_GL__V3, "coefficients 4..7")
SSGI_GL__FLOATS(sh2, SSGI_GL__V3, "coefficients 8..11; R16F suffices for 3 bands")
SSGI_GL__FLOATS(sh3, SSGI_GL__V4, "coefficients 12..15")
SSGI_GL__HALVES(packed0, SSGI_GL__MONO, "sh0", "coefficients 0..7; R32UI suffices for 1 band, RG32UI for 2")
SSGI_GL__HALVES(packed1, SSGI_GL__MONO | SSGI_GL__V3, "sh1", "coefficients 8..15; R32UI suffices for 3 bands")
SSGI_GL__HALVES(red0, SSGI_GL__RGB, "red0", "coefficients 0..7 of red; R32UI suffices for 1 band, RG32UI for 2")
SSGI_GL__HALVES(red1, SSGI_GL__RGB | SSGI_GL__V3, "red1", "coefficients 8..15 of red; R32UI suffices for 3 bands")
SSGI_GL__HALVES(green0, SSGI_GL__RGB, "green0", "the same of green")
SSGI_GL__HALVES(green1, SSGI_GL__RGB | SSGI_GL__V3, "green1", "the same of green")
SSGI_GL__HALVES(blue0, SSGI_GL__RGB, "blue0", "the same of blue")
SSGI_GL__HALVES(blue1, SSGI_GL__RGB | SSGI_GL__V3, "blue1", "the same of blue")
static const ssgi_gl__row ssgi_gl__wide_unproject = SSGI_GL__P(SSGI_GL__TESSELLATED, "unproject", "vec4", unproject, "view xy / depth per pixel");
static const ssgi_gl__row ssgi_gl__surfel_row  = SSGI_GL__P(SSGI_GL__TESSELLATED, "surfel", "vec4", surfel, "view radius per depth; near plane; stillness; splits");
static const ssgi_gl__row ssgi_gl__mesh_row    = SSGI_GL__P(SSGI_GL__TESSELLATED, "mesh", "mat4", mesh, "mesh to view");
static const ssgi_gl__row ssgi_gl__dipole_row  = SSGI_GL__P(SSGI_GL__SCATTERS, "dipole", "vec4[4]", dipole, "z_r, z_v, sigma_tr, alpha'/4");
static const ssgi_gl__row ssgi_gl__epsilon     = SSGI_GL__P(0, "epsilon", "float", epsilon, "");
static const ssgi_gl__row ssgi_gl__exponent    = SSGI_GL__P(SSGI_GL__MIRRORS, "exponent", "float", exponent, "");
static const ssgi_gl__row ssgi_gl__front_row   = SSGI_GL__P(0, "front", "float", front, "view units");
static const ssgi_gl__row ssgi_gl__more_row   = SSGI_GL__P(SSGI_GL__TESSELLATED, "more", "vec2", more, "radii per distance; 1: no triangle stands for others");
static const ssgi_gl__row ssgi_gl__level_row   = SSGI_GL__P(0, "level", "ivec2", level, "texels of a level");
static const ssgi_gl__row ssgi_gl__shuffled_tex = { 0, { "t_ssgi_shuffled", SSGI_GL_TEXTURE, "usampler2D", 0, 0, "what shuffle wrote: RGBA32UI" } };
static const ssgi_gl__row ssgi_gl__levels_tex  = SSGI_GL__T(0, "levels", "what splat, unshuffle or smooth wrote, in this order: R32F or R16F for occlusion, else RGBA32F or RGBA16F");
static const ssgi_gl__row ssgi_gl__shuffled_out = SSGI_GL__O(0, "shuffled", "uvec4", "RGBA32UI: view-space position, octahedral normal as 16 16");
static const ssgi_gl__row ssgi_gl__levels_out  = SSGI_GL__O(SSGI_GL__GREY, "levels", "float", "R32F, or R16F that loses what is below 1/2000 of the sum: form factors");
static const ssgi_gl__row ssgi_gl__levels4_out = SSGI_GL__O(SSGI_GL__COLOUR, "levels", "vec4", "RGBA32F or RGBA16F: what surfels bring, form factors");
static const ssgi_gl__row ssgi_gl__sum_ao_out  = SSGI_GL__O(SSGI_GL__OCCLUDES, "ao", "vec2", "RG32F or RG16F: ambient visibility, view depth; R8 or R16F if nothing filters");
static const ssgi_gl__row ssgi_gl__sum_light_out = SSGI_GL__O(SSGI_GL__HIDES, "light", "vec4", "RGBA32F or RGBA16F: irradiance over pi, view depth");
static const ssgi_gl__row ssgi_gl__sum_bounce_out = SSGI_GL__O(SSGI_GL__BRINGS, "bounce", "vec4", "RGBA32F or RGBA16F: irradiance over pi from the bounce, view depth");
static const ssgi_gl__row ssgi_gl__sum_specular_out = SSGI_GL__O(SSGI_GL__MIRRORS, "specular", "vec4", "RGBA32F or RGBA16F: radiance of the lobe, view depth");
static const ssgi_gl__row ssgi_gl__sum_scatter_out = SSGI_GL__O(SSGI_GL__SCATTERS, "scatter", "vec4", "RGBA32F or RGBA16F: radiance, view depth");
#define SSGI_GL__I(need, name, type, format)            { need, { name, SSGI_GL_ATTRIBUTE, type, 0, 0, format } }
static const ssgi_gl__row ssgi_gl__in_position = SSGI_GL__I(SSGI_GL__TESSELLATED, "a_ssgi_position", "vec3", "mesh space");
static const ssgi_gl__row ssgi_gl__in_normal   = SSGI_GL__I(SSGI_GL__TESSELLATED, "a_ssgi_normal", "vec3", "mesh space, any length; 0 0 0: the triangle's own");
static const ssgi_gl__row ssgi_gl__in_colour   = SSGI_GL__I(SSGI_GL__TESSELLATED, "a_ssgi_colour", "vec3", "of ssgi_surfel");
static const ssgi_gl__row ssgi_gl__in_surfel0  = SSGI_GL__I(SSGI_GL__BUFFERED, "a_ssgi_surfel0", "vec4", "ssgi_surfel: position, radius");
static const ssgi_gl__row ssgi_gl__in_surfel1  = SSGI_GL__I(SSGI_GL__BUFFERED, "a_ssgi_surfel1", "vec4", "normal, seed");
static const ssgi_gl__row ssgi_gl__in_surfel2  = SSGI_GL__I(SSGI_GL__BUFFERED, "a_ssgi_surfel2", "vec4", "colour");
static const ssgi_gl__row ssgi_gl__kept0       = { 0, { "v_ssgi_surfel0", SSGI_GL_CAPTURE, "vec4", 0, 0, "ssgi_surfel: position, radius" } };
static const ssgi_gl__row ssgi_gl__kept1       = { 0, { "v_ssgi_surfel1", SSGI_GL_CAPTURE, "vec4", 0, 0, "normal, seed" } };
static const ssgi_gl__row ssgi_gl__kept2       = { 0, { "v_ssgi_surfel2", SSGI_GL_CAPTURE, "vec4", 0, 0, "colour" } };
static const ssgi_gl__row ssgi_gl__c_levels    = SSGI_GL__C(0, "SSGI_LEVELS", levels);
static const ssgi_gl__row ssgi_gl__c_near      = SSGI_GL__C(SSGI_GL__NEAR, "SSGI_NEAR", closely);
static const ssgi_gl__row ssgi_gl__c_axis      = SSGI_GL__C(0, "SSGI_AXIS", axis);
static const ssgi_gl__row ssgi_gl__c_samples   = SSGI_GL__C(0, "SSGI_SAMPLES", samples);
static const ssgi_gl__row ssgi_gl__c_directions = SSGI_GL__C(0, "SSGI_DIRECTIONS", directions);
static const ssgi_gl__row ssgi_gl__c_steps     = SSGI_GL__C(0, "SSGI_STEPS", steps);
static const ssgi_gl__row ssgi_gl__c_several   = SSGI_GL__C(SSGI_GL__SEVERAL, "SSGI_STEPS", steps);
static const ssgi_gl__row ssgi_gl__c_points    = SSGI_GL__C(SSGI_GL__SEGMENTS, "SSGI_SAMPLES", samples);
static const ssgi_gl__row ssgi_gl__c_layers    = SSGI_GL__C(SSGI_GL__DEEP, "SSGI_LAYERS", layers);
static const ssgi_gl__row ssgi_gl__c_views     = SSGI_GL__C(SSGI_GL__VIEWS, "SSGI_VIEWS", views);
static const ssgi_gl__row ssgi_gl__c_view_layers = SSGI_GL__C(SSGI_GL__VIEWS, "SSGI_VIEW_LAYERS", view_layers);
static const ssgi_gl__row ssgi_gl__c_receiver  = SSGI_GL__C(SSGI_GL__HIDDEN, "SSGI_RECEIVER", receiver);
static const ssgi_gl__row ssgi_gl__c_rays      = SSGI_GL__C(SSGI_GL__RAYS, "SSGI_NORMAL_RAYS", normal_rays);
static const ssgi_gl__row ssgi_gl__c_filter    = SSGI_GL__C(0, "SSGI_FILTER_RADIUS", filter_radius);

/* ==== >>fetch: depth, position, normal, noise ==================================================================== */

static const ssgi_gl__chunk ssgi_gl__triangle = { __LINE__ + 1, 0,
    "// one triangle that covers the viewport\n"
    "void main()\n"
    "{\n"
    "    gl_Position = vec4(float((gl_VertexID & 1) * 4) - 1.0, float((gl_VertexID & 2) * 2) - 1.0, 0.0, 1.0);\n"
    "}\n" };

#define SSGI_GL__FAR_TEXT "const float SSGI_FAR = 1e18; // the view depth of nothing\n"
static const ssgi_gl__chunk ssgi_gl__far = { __LINE__, 0, SSGI_GL__FAR_TEXT };
static const ssgi_gl__chunk ssgi_gl__map_far = { __LINE__, SSGI_GL__MAPS_READ, SSGI_GL__FAR_TEXT };

static const ssgi_gl__chunk ssgi_gl__decode_perspective = { __LINE__ + 1, SSGI_GL__D_WINDOW | SSGI_GL__PERSPECTIVE,
    "float ssgi_decode(float d)\n"
    "{\n"
    "    float w = u_ssgi_decode.x + u_ssgi_decode.y * d;\n"
    "    return d != u_ssgi_decode.z && w > 1.0 / SSGI_FAR ? 1.0 / w : SSGI_FAR;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__decode_orthographic = { __LINE__ + 1, SSGI_GL__D_WINDOW | SSGI_GL__ORTHOGRAPHIC,
    "float ssgi_decode(float d)\n"
    "{\n"
    "    float z = u_ssgi_decode.x + u_ssgi_decode.y * d;\n"
    "    return d != u_ssgi_decode.z && z > 0.0 && z < SSGI_FAR ? z : SSGI_FAR;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__depth_window = { __LINE__ + 1, SSGI_GL__D_WINDOW | SSGI_GL__SEEN,
    "// view depth at a pixel of the picture\n"
    "float ssgi_depth(ivec2 p)\n"
    "{\n"
    "    return ssgi_decode(texelFetch(t_ssgi_depth, p + u_ssgi_origin, 0).x);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__depth_linear = { __LINE__ + 1, SSGI_GL__D_LINEAR | SSGI_GL__SEEN,
    "// view depth at a pixel of the picture\n"
    "float ssgi_depth(ivec2 p)\n"
    "{\n"
    "    float z = texelFetch(t_ssgi_depth, p + u_ssgi_origin, 0).x;\n"
    "    return z > 0.0 && z < SSGI_FAR ? z : SSGI_FAR;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__depth_custom = { __LINE__ + 1, SSGI_GL__D_CUSTOM | SSGI_GL__FIRST,
    "// view depth at a pixel of the picture\n"
    "float ssgi_depth(ivec2 p)\n"
    "{\n"
    "    float z = ssgi_custom_depth(p + u_ssgi_origin, 0);\n"
    "    return z > 0.0 && z < SSGI_FAR ? z : SSGI_FAR;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__layer_window = { __LINE__ + 1, SSGI_GL__LAYERS_READ | SSGI_GL__D_WINDOW | SSGI_GL__SEEN,
    "// view depth of a layer at a pixel of the picture; layer 0 is what is seen\n"
    "float ssgi_layer(ivec2 p, int j)\n"
    "{\n"
    "    return j == 0 ? ssgi_depth(p) : ssgi_decode(texelFetch(t_ssgi_layers, ivec3(p + u_ssgi_origin, j - 1), 0).x);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__layer_linear = { __LINE__ + 1, SSGI_GL__LAYERS_READ | SSGI_GL__D_LINEAR | SSGI_GL__SEEN,
    "// view depth of a layer at a pixel of the picture; layer 0 is what is seen\n"
    "float ssgi_layer(ivec2 p, int j)\n"
    "{\n"
    "    if (j == 0) return ssgi_depth(p);\n"
    "    float z = texelFetch(t_ssgi_layers, ivec3(p + u_ssgi_origin, j - 1), 0).x;\n"
    "    return z > 0.0 && z < SSGI_FAR ? z : SSGI_FAR;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__hidden_window = { __LINE__ + 1, SSGI_GL__D_WINDOW | SSGI_GL__UNSEEN,
    "// view depth of a hidden layer at a pixel of the picture\n"
    "float ssgi_layer(ivec2 p, int j)\n"
    "{\n"
    "    return ssgi_decode(texelFetch(t_ssgi_layers, ivec3(p + u_ssgi_origin, j - 1), 0).x);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__hidden_linear = { __LINE__ + 1, SSGI_GL__D_LINEAR | SSGI_GL__UNSEEN,
    "// view depth of a hidden layer at a pixel of the picture\n"
    "float ssgi_layer(ivec2 p, int j)\n"
    "{\n"
    "    float z = texelFetch(t_ssgi_layers, ivec3(p + u_ssgi_origin, j - 1), 0).x;\n"
    "    return z > 0.0 && z < SSGI_FAR ? z : SSGI_FAR;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__layer_custom = { __LINE__ + 1, SSGI_GL__LAYERS_READ | SSGI_GL__D_CUSTOM,
    "// view depth of a layer at a pixel of the picture; layer 0 is what is seen\n"
    "float ssgi_layer(ivec2 p, int j)\n"
    "{\n"
    "    float z = ssgi_custom_depth(p + u_ssgi_origin, j);\n"
    "    return z > 0.0 && z < SSGI_FAR ? z : SSGI_FAR;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__position_perspective = { __LINE__ + 1, SSGI_GL__POSITION | SSGI_GL__PERSPECTIVE,
    "// the view-space point seen at a pixel position, at a view depth\n"
    "vec3 ssgi_position(vec2 pixel, float z)\n"
    "{\n"
    "    return vec3((pixel * u_ssgi_unproject.xy + u_ssgi_unproject.zw) * z, -z);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__position_orthographic = { __LINE__ + 1, SSGI_GL__POSITION | SSGI_GL__ORTHOGRAPHIC,
    "// the view-space point seen at a pixel position, at a view depth\n"
    "vec3 ssgi_position(vec2 pixel, float z)\n"
    "{\n"
    "    return vec3(pixel * u_ssgi_unproject.xy + u_ssgi_unproject.zw, -z);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__project_perspective = { __LINE__ + 1, SSGI_GL__PROJECT | SSGI_GL__PERSPECTIVE,
    "// the pixel position of a view-space point in front of the eye\n"
    "vec2 ssgi_project(vec3 P)\n"
    "{\n"
    "    return P.xy * (u_ssgi_project.xy / -P.z) + u_ssgi_project.zw;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__project_orthographic = { __LINE__ + 1, SSGI_GL__PROJECT | SSGI_GL__ORTHOGRAPHIC,
    "// the pixel position of a view-space point\n"
    "vec2 ssgi_project(vec3 P)\n"
    "{\n"
    "    return P.xy * u_ssgi_project.xy + u_ssgi_project.zw;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__footprint_perspective = { __LINE__ + 1, SSGI_GL__PROJECT | SSGI_GL__PERSPECTIVE,
    "// width of a pixel at a view depth\n"
    "float ssgi_footprint(float z)\n"
    "{\n"
    "    return max(abs(u_ssgi_unproject.x), abs(u_ssgi_unproject.y)) * z;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__footprint_orthographic = { __LINE__ + 1, SSGI_GL__PROJECT | SSGI_GL__ORTHOGRAPHIC,
    "// width of a pixel\n"
    "float ssgi_footprint(float z)\n"
    "{\n"
    "    return max(abs(u_ssgi_unproject.x), abs(u_ssgi_unproject.y));\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__inside = { __LINE__ + 1, SSGI_GL__INSIDE,
    "bool ssgi_inside(ivec2 p)\n"
    "{\n"
    "    return uint(p.x) < uint(u_ssgi_size.x) && uint(p.y) < uint(u_ssgi_size.y); // negative is large\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__toward_perspective = { __LINE__ + 1, SSGI_GL__TOWARD | SSGI_GL__PERSPECTIVE,
    "// unit vector to the eye\n"
    "vec3 ssgi_toward(vec3 P)\n"
    "{\n"
    "    return P * -inversesqrt(dot(P, P));\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__toward_orthographic = { __LINE__ + 1, SSGI_GL__TOWARD | SSGI_GL__ORTHOGRAPHIC,
    "// unit vector to the eye\n"
    "vec3 ssgi_toward(vec3 P)\n"
    "{\n"
    "    return vec3(0.0, 0.0, 1.0);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__unit = { __LINE__ + 1, SSGI_GL__NORMALS,
    "// a unit normal from whatever the texture held\n"
    "vec3 ssgi_unit(vec3 n)\n"
    "{\n"
    "    float l = dot(n, n);\n"
    "    return l > 1e-12 && l < 1e12 ? n * inversesqrt(l) : vec3(0.0, 0.0, 1.0);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__texel_first = { __LINE__ + 1, SSGI_GL__N_TEXTURE | SSGI_GL__FIRST,
    "vec4 ssgi_normal_texel(ivec2 p)\n"
    "{\n"
    "    return texelFetch(t_ssgi_normal, p + u_ssgi_origin, 0);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__texel_hidden = { __LINE__ + 1, SSGI_GL__N_TEXTURE | SSGI_GL__HIDDEN,
    "vec4 ssgi_normal_texel(ivec2 p)\n"
    "{\n"
    "    return texelFetch(t_ssgi_normal, ivec3(p + u_ssgi_origin, SSGI_RECEIVER - 1), 0);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__raw_signed = { __LINE__ + 1, SSGI_GL__N_SIGNED,
    "vec3 ssgi_raw_normal(ivec2 p)\n"
    "{\n"
    "    return ssgi_normal_texel(p).xyz;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__raw_unsigned = { __LINE__ + 1, SSGI_GL__N_UNSIGNED,
    "vec3 ssgi_raw_normal(ivec2 p)\n"
    "{\n"
    "    return ssgi_normal_texel(p).xyz * 2.0 - 1.0;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__raw_octahedral = { __LINE__ + 1, SSGI_GL__N_OCTA,
    "vec3 ssgi_raw_normal(ivec2 p)\n"
    "{\n"
    "    vec2 e = ssgi_normal_texel(p).xy;\n"
    "    vec3 n = vec3(e, 1.0 - abs(e.x) - abs(e.y));\n"
    "    float t = max(-n.z, 0.0);\n"
    "    return vec3(n.x + (n.x >= 0.0 ? -t : t), n.y + (n.y >= 0.0 ? -t : t), n.z);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__raw_custom = { __LINE__ + 1, SSGI_GL__N_CUSTOM,
    "vec3 ssgi_raw_normal(ivec2 p)\n"
    "{\n"
    "    return ssgi_custom_normal(p + u_ssgi_origin);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__normal_view = { __LINE__ + 1, SSGI_GL__N_VIEW,
    "// unit view-space normal at a pixel of the picture whose point is P\n"
    "vec3 ssgi_normal(ivec2 p, vec3 P)\n"
    "{\n"
    "    return ssgi_unit(ssgi_raw_normal(p));\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__normal_world = { __LINE__ + 1, SSGI_GL__N_WORLD,
    "// unit view-space normal at a pixel of the picture whose point is P\n"
    "vec3 ssgi_normal(ivec2 p, vec3 P)\n"
    "{\n"
    "    return ssgi_unit(u_ssgi_rotation * ssgi_raw_normal(p));\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__normal_from_depth = { __LINE__ + 1, SSGI_GL__N_DEPTH,
    "// the neighbour on either side whose depth is nearer, as a difference along +step\n"
    "vec3 ssgi_tangent(ivec2 p, vec3 P, ivec2 step_)\n"
    "{\n"
    "    float a = ssgi_inside(p + step_) ? ssgi_depth(p + step_) : SSGI_FAR, b = ssgi_inside(p - step_) ? ssgi_depth(p - step_) : SSGI_FAR;\n"
    "    vec3 A = ssgi_position(vec2(p + step_) + 0.5, a) - P, B = P - ssgi_position(vec2(p - step_) + 0.5, b);\n"
    "    return abs(A.z) < abs(B.z) ? A : B;\n"
    "}\n"
    "\n"
    "// unit view-space normal at a pixel of the picture whose point is P, facing the viewer\n"
    "vec3 ssgi_normal(ivec2 p, vec3 P)\n"
    "{\n"
    "    vec3 x = ssgi_tangent(p, P, ivec2(1, 0)), y = ssgi_tangent(p, P, ivec2(0, 1));\n"
    "    vec3 n = ssgi_unit(cross(x * inversesqrt(dot(x, x) + 1e-30), y * inversesqrt(dot(y, y) + 1e-30)));\n"
    "    return dot(n, ssgi_toward(P)) < 0.0 ? -n : n;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__noise_tile4 = { __LINE__ + 1, SSGI_GL__NOISE_TILE4,
    "// x, y: in [0,1), evenly spread over every 4x4 block\n"
    "vec2 ssgi_noise(ivec2 p)\n"
    "{\n"
    "    return fract((vec2(float((((p.x + p.y) & 3) << 2) + (p.x & 3)), float((p.y - p.x) & 3) * 4.0) + 0.5) / 16.0 + u_ssgi_phase);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__noise_gradient = { __LINE__ + 1, SSGI_GL__NOISE_GRADIENT,
    "// in [0,1): x interleaved gradient noise, evenly spread over every 3x3 block, y the R2 sequence along the picture\n"
    "vec2 ssgi_noise(ivec2 p)\n"
    "{\n"
    "    vec2 q = vec2(p);\n"
    "    return fract(vec2(52.9829189 * fract(dot(q, vec2(0.06711056, 0.00583715))), dot(q, vec2(0.75487767, 0.56984029))) + u_ssgi_phase);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__noise_texture = { __LINE__ + 1, SSGI_GL__NOISE_TEXTURE,
    "// in [0,1): x turns the directions, y offsets the steps; c and b + 0.5 of ssgi_jitter_tile\n"
    "vec2 ssgi_noise(ivec2 p)\n"
    "{\n"
    "    ivec2 tile = textureSize(t_ssgi_noise, 0);\n"
    "    vec4 j = texelFetch(t_ssgi_noise, ivec2(p.x % tile.x, p.y % tile.y), 0);\n"
    "    return fract(vec2(j.w, j.z + 0.5) + u_ssgi_phase);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__unpack = { __LINE__ + 1, SSGI_GL__SENDERS,
    "// what senders wrote: radiance; view depth; the way of the normal, not unit\n"
    "vec3 ssgi_unpack_radiance(uint u)\n"
    "{\n"
    "    return vec3(float(u & 511u), float((u >> 9u) & 511u), float((u >> 18u) & 511u)) * uintBitsToFloat(((u >> 27u) + 103u) << 23u);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__unpack_depth = { __LINE__ + 1, SSGI_GL__SENDERS,
    "float ssgi_unpack_depth(uint u)\n"
    "{\n"
    "    return u < 0xfffff000u ? uintBitsToFloat(((u >> 12u) + (107u << 14u)) << 9u) : SSGI_FAR;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__unpack_normal = { __LINE__ + 1, SSGI_GL__NORMALS_SENT,
    "vec3 ssgi_unpack_normal(uint u)\n"
    "{\n"
    "    vec2 e = vec2(float(u & 63u), float((u >> 6u) & 63u)) - 32.0;\n"
    "    vec3 n = vec3(e, 31.0 - abs(e.x) - abs(e.y));\n"
    "    float t = max(-n.z, 0.0);\n"
    "    return vec3(n.x + (n.x >= 0.0 ? -t : t), n.y + (n.y >= 0.0 ? -t : t), n.z);\n"
    "}\n" };

#define SSGI_GL__OCTAHEDRON_TEXT \
    "// a direction on the octahedral map's square, [-1,1]\n" \
    "vec2 ssgi_octahedral(vec3 d)\n" \
    "{\n" \
    "    vec2 e = d.xy / (abs(d.x) + abs(d.y) + abs(d.z));\n" \
    "    return d.z >= 0.0 ? e : (1.0 - abs(e.yx)) * vec2(e.x >= 0.0 ? 1.0 : -1.0, e.y >= 0.0 ? 1.0 : -1.0);\n" \
    "}\n"
static const ssgi_gl__chunk ssgi_gl__octahedron = { __LINE__, SSGI_GL__OCTAHEDRON, SSGI_GL__OCTAHEDRON_TEXT };
static const ssgi_gl__chunk ssgi_gl__octahedron_open = { __LINE__, SSGI_GL__I_MAP, SSGI_GL__OCTAHEDRON_TEXT };     /* of stages that read the irradiance map; the environment */
static const ssgi_gl__chunk ssgi_gl__octahedron_map = { __LINE__, SSGI_GL__E_MAP, SSGI_GL__OCTAHEDRON_TEXT };

static const ssgi_gl__chunk ssgi_gl__pack = { __LINE__ + 1, 0,
    "// radiance in [0, 65408] as three mantissas of 9 bits and one exponent\n"
    "uint ssgi_pack_radiance(vec3 c)\n"
    "{\n"
    "    c = clamp(c, 0.0, 65408.0);\n"
    "    float most = max(max(c.x, c.y), max(c.z, 6.1035156e-5)) * 1.0009775; // rounds up to the next exponent where 9 bits would overflow\n"
    "    uint e = min((floatBitsToUint(most) >> 23u) - 111u, 31u);\n"
    "    uvec3 m = min(uvec3(c * uintBitsToFloat((151u - e) << 23u) + 0.5), uvec3(511u));\n"
    "    return m.x | (m.y << 9u) | (m.z << 18u) | (e << 27u);\n"
    "}\n"
    "\n"
    "// view depth in [1e-6, 1e13], to 3e-5 of it, and a normal, to 4 degrees\n"
    "uint ssgi_pack_place(float z, vec3 n)\n"
    "{\n"
    "    uvec2 e = uvec2(round(ssgi_octahedral(n) * 31.0) + 32.0);\n"
    "    return ((((floatBitsToUint(clamp(z, 1e-6, 1e13)) + 256u) >> 9u) - (107u << 14u)) << 12u) | (e.y << 6u) | e.x;\n"
    "}\n" };

/* ==== >>visibility: is this point behind a surface ================================================================ */

static const ssgi_gl__chunk ssgi_gl__lift = { __LINE__ + 1, SSGI_GL__PROJECT,
    "// the receiver lifted along its normal, so that nearest fetches of its own plane stay below it [HSAO08 eq. 13]\n"
    "vec3 ssgi_lift(vec3 P, vec3 n)\n"
    "{\n"
    "    return P + n * (u_ssgi_offset * 0.5 * ssgi_footprint(-P.z));\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__back_fixed = { __LINE__ + 1, SSGI_GL__FIXED,
    "// how far what is seen reaches away from the viewer\n"
    "float ssgi_thickness()\n"
    "{\n"
    "    return u_ssgi_thickness;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__back_reach = { __LINE__ + 1, SSGI_GL__REACH,
    "// how far what is seen reaches away from the viewer; a short segment must not end on what floats far before it\n"
    "float ssgi_reach;\n"
    "float ssgi_thickness()\n"
    "{\n"
    "    return min(u_ssgi_thickness, 2.0 * ssgi_reach);\n"
    "}\n" };

/* The blocker itself, where it is looked at: what it sends, how far it is. */

static const ssgi_gl__chunk ssgi_gl__look_from = { __LINE__ + 1, SSGI_GL__RECEIVED,
    "vec3 ssgi_P; // the receiver\n" };
static const ssgi_gl__chunk ssgi_gl__look_normal = { __LINE__ + 1, SSGI_GL__FACING,
    "vec3 ssgi_n; // its normal\n" };

static const ssgi_gl__chunk ssgi_gl__look_head = { __LINE__ + 1, SSGI_GL__LOOK,
    "// the point that camera v shows at a pixel and depth; -1 is the picture's\n"
    "vec3 ssgi_point(int v, ivec2 p, float z)\n"
    "{\n" };
static const ssgi_gl__chunk ssgi_gl__look_views = { __LINE__ + 1, SSGI_GL__LOOK | SSGI_GL__VIEWS,
    "    if (v >= 0) return (u_ssgi_view_from[v] * vec4((vec2(p) + 0.5) * (u_ssgi_view_decode[v].w > 0.0 ? 1.0 : z), z, 1.0)).xyz;\n" };
static const ssgi_gl__chunk ssgi_gl__look_tail = { __LINE__ + 1, SSGI_GL__LOOK,
    "    return ssgi_position(vec2(p) + 0.5, z);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__sent_kept = { __LINE__ + 1, SSGI_GL__SENDER_KEPT,
    "uint ssgi_sender_place; // its normal, packed\n" };
static const ssgi_gl__chunk ssgi_gl__sent_head = { __LINE__ + 1, SSGI_GL__SENDERS,
    "vec4 ssgi_sender; // what the surface found around the sample sends to the receiver, and how near it is\n"
    "\n"
    "// what layer j of camera v holds at a pixel: radiance, normal, view depth\n"
    "uvec2 ssgi_held(int v, ivec2 p, int j)\n"
    "{\n" };
static const ssgi_gl__chunk ssgi_gl__sent_views = { __LINE__ + 1, SSGI_GL__SENDERS | SSGI_GL__VIEWS,
    "    if (v >= 0) return texelFetch(t_ssgi_view_senders, ivec3(p, v * SSGI_VIEW_LAYERS + j), 0).xy;\n" };
static const ssgi_gl__chunk ssgi_gl__sent_main = { __LINE__ + 1, SSGI_GL__SENDERS,
    "    return texelFetch(t_ssgi_senders, ivec3(p + u_ssgi_target, j), 0).xy;\n"
    "}\n"
    "\n"
    "// what a surface at Q sends to the receiver\n"
    "vec3 ssgi_sent(uvec2 s, vec3 Q)\n"
    "{\n" };
static const ssgi_gl__chunk ssgi_gl__sent_both = { __LINE__ + 1, SSGI_GL__TWO_SIDED | SSGI_GL__SOLID_ANGLE,
    "    return ssgi_unpack_radiance(s.x);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__sent_facing = { __LINE__ + 1, SSGI_GL__ONE_SIDED | SSGI_GL__SOLID_ANGLE,
    "    return dot(ssgi_unpack_normal(s.y), ssgi_P - Q) > 0.0 ? ssgi_unpack_radiance(s.x) : vec3(0.0);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__sent_area = { __LINE__ + 1, SSGI_GL__AREA,
    "    vec3 d = ssgi_P - Q;\n"
    "    float dd = max(dot(d, d), 1e-30), area = u_ssgi_radius * u_ssgi_radius * u_ssgi_gain, r = -dot(ssgi_n, d), c = dot(normalize(ssgi_unpack_normal(s.y)), d);\n" };
static const ssgi_gl__chunk ssgi_gl__sent_area_both = { __LINE__ + 1, SSGI_GL__AREA | SSGI_GL__TWO_SIDED,
    "    c = abs(c);\n" };
static const ssgi_gl__chunk ssgi_gl__sent_patch = { __LINE__ + 1, SSGI_GL__PATCH,
    "    float least = u_ssgi_nearest * u_ssgi_radius;\n"
    "    return ssgi_unpack_radiance(s.x) * (area * max(r, 0.0) * max(c, 0.0) / (dd * max(dd, least * least)));\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__sent_disc = { __LINE__ + 1, SSGI_GL__DISC,
    "    return ssgi_unpack_radiance(s.x) * (area * max(r, 0.0) * max(c, 0.0) / (dd * (dd + area / float(SSGI_SAMPLES))));\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__faded_head = { __LINE__ + 1, SSGI_GL__FADE,
    "// how much a blocker that the picture shows at Q still blocks\n"
    "float ssgi_faded(vec3 Q)\n"
    "{\n"
    "    vec3 d = Q - ssgi_P;\n"
    "    float t = length(d) / u_ssgi_radius, weight = 1.0;\n" };
static const ssgi_gl__chunk ssgi_gl__faded_range = { __LINE__ + 1, SSGI_GL__RANGE,
    "    if (t > 1.0 || dot(d, ssgi_n) <= 0.0) return 0.0;\n" };
static const ssgi_gl__chunk ssgi_gl__faded_smooth = { __LINE__ + 1, SSGI_GL__SMOOTH,
    "    weight -= smoothstep(u_ssgi_fade, u_ssgi_radius * 1.0001, t * u_ssgi_radius);\n" };
static const ssgi_gl__chunk ssgi_gl__faded_ended = { __LINE__ + 1, SSGI_GL__ENDED,
    "    weight -= t;\n" };
static const ssgi_gl__chunk ssgi_gl__faded_lambda = { __LINE__ + 1, SSGI_GL__LAMBDA,
    "    weight /= 1.0 + u_ssgi_lambda * t;\n" };
static const ssgi_gl__chunk ssgi_gl__faded_tail = { __LINE__ + 1, SSGI_GL__FADE,
    "    return max(weight, 1e-6); // found, however little it counts\n"
    "}\n" };

/* The shallow test: against the depth buffer alone. */

static const ssgi_gl__chunk ssgi_gl__shallow_head = { __LINE__ + 1, SSGI_GL__BLOCKED | SSGI_GL__SHALLOW,
    "// how much S is blocked: behind what is seen at its pixel; 0 off the picture and behind the eye\n"
    "float ssgi_blocked(vec3 S)\n"
    "{\n"
    "    ivec2 p = ivec2(floor(ssgi_project(S)));\n" };
static const ssgi_gl__chunk ssgi_gl__shallow_depth = { __LINE__ + 1, SSGI_GL__SHALLOW | SSGI_GL__DEPTHS,
    "    float z = ssgi_depth(p), behind = -S.z - z;\n" };
static const ssgi_gl__chunk ssgi_gl__shallow_send = { __LINE__ + 1, SSGI_GL__SHALLOW | SSGI_GL__SENDERS,
    "    uvec2 s = ssgi_held(-1, p, 0);\n"
    "    float z = ssgi_unpack_depth(s.y), behind = -S.z - z;\n"
    "    ssgi_sender.xyz = ssgi_sent(s, ssgi_point(-1, p, z));\n" };
static const ssgi_gl__chunk ssgi_gl__shallow_keep = { __LINE__ + 1, SSGI_GL__SHALLOW | SSGI_GL__SENDER_KEPT,
    "    ssgi_sender_place = s.y;\n" };
static const ssgi_gl__chunk ssgi_gl__shallow_test = { __LINE__ + 1, SSGI_GL__BLOCKED | SSGI_GL__SHALLOW,
    "    return S.z < 0.0 && ssgi_inside(p) && behind > 0.0\n" };
static const ssgi_gl__chunk ssgi_gl__shallow_thin = { __LINE__ + 1, SSGI_GL__BLOCKED | SSGI_GL__SHALLOW | SSGI_GL__THIN,
    "        && behind < ssgi_thickness()\n" };
static const ssgi_gl__chunk ssgi_gl__shallow_whole = { __LINE__ + 1, SSGI_GL__BLOCKED | SSGI_GL__SHALLOW | SSGI_GL__NO_FADE,
    "        ? 1.0 : 0.0;\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__shallow_fade = { __LINE__ + 1, SSGI_GL__SHALLOW | SSGI_GL__FADE,
    "        ? ssgi_faded(ssgi_point(-1, p, z)) : 0.0;\n"
    "}\n" };

/* The deep test: the same question to depth layers of the picture's camera (v = -1) and of extra ones. */

static const ssgi_gl__chunk ssgi_gl__view_surface = { __LINE__ + 1, SSGI_GL__VIEWS | SSGI_GL__DEPTHS,
    "// view depth of a layer that extra camera v sees\n"
    "float ssgi_view_layer(int v, ivec2 p, int j)\n"
    "{\n"
    "    float d = texelFetch(t_ssgi_views, ivec3(p, v * SSGI_VIEW_LAYERS + j), 0).x, w = u_ssgi_view_decode[v].x + u_ssgi_view_decode[v].y * d;\n"
    "    if (d == u_ssgi_view_decode[v].z || w <= 1.0 / SSGI_FAR) return SSGI_FAR;\n"
    "    return u_ssgi_view_decode[v].w > 0.0 ? w : 1.0 / w;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__surface_head = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__DEPTHS,
    "// view depth of layer j at a pixel of camera v\n"
    "float ssgi_surface(int v, ivec2 p, int j)\n"
    "{\n" };
static const ssgi_gl__chunk ssgi_gl__surface_views = { __LINE__ + 1, SSGI_GL__VIEWS | SSGI_GL__DEPTHS,
    "    if (v >= 0) return ssgi_view_layer(v, p, j);\n" };
static const ssgi_gl__chunk ssgi_gl__surface_layers = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__DEPTHS | SSGI_GL__LAYERS,
    "    return ssgi_layer(p, j);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__surface_one = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__DEPTHS | SSGI_GL__ONE_LAYER,
    "    return ssgi_depth(p);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__offer = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__SENDERS,
    "vec3 ssgi_way; // from the receiver to the sample\n"
    "\n"
    "// of the surfaces around the sample that send anything the sender is the one nearest to that way\n"
    "void ssgi_offer(uvec2 s, vec3 Q)\n"
    "{\n"
    "    vec3 L = ssgi_sent(s, Q), d = cross(Q - ssgi_P, ssgi_way);\n"
    "    float gap = dot(d, d);\n"
    "    if (gap >= ssgi_sender.w || L == vec3(0.0)) return;\n"
    "    ssgi_sender = vec4(L, gap);\n" };
static const ssgi_gl__chunk ssgi_gl__offer_keep = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__SENDER_KEPT,
    "    ssgi_sender_place = s.y;\n" };
static const ssgi_gl__chunk ssgi_gl__offer_end = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__SENDERS,
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__matter_head = { __LINE__ + 1, SSGI_GL__DEEP,
    "// Where depth s stands at a pixel of camera v: above 0 inside matter, which is from an odd layer to the next; -1 seen in the open, by more than the slack; 0 not known.\n"
    "float ssgi_matter(int v, ivec2 p, float s, int layers, float slack)\n"
    "{\n" };
static const ssgi_gl__chunk ssgi_gl__matter_solid = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__SOLID,
    "    // matter whose far side is no layer has no end\n" };
static const ssgi_gl__chunk ssgi_gl__matter_thin = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__THIN,
    "    // matter whose far side is no layer is ssgi_thickness() thick, and what lies behind it is not known\n" };
static const ssgi_gl__chunk ssgi_gl__matter_loop = { __LINE__ + 1, SSGI_GL__DEEP,
    "    float found = 0.0;\n"
    "    bool known = false;\n"
    "    for (int j = 0; j < layers; j += 2) {\n" };
static const ssgi_gl__chunk ssgi_gl__matter_depths = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__DEPTHS,
    "        float near = ssgi_surface(v, p, j), far = j + 1 < layers ? ssgi_surface(v, p, j + 1) : SSGI_FAR, back = far;\n" };
static const ssgi_gl__chunk ssgi_gl__matter_held = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__SENDERS,
    "        uvec2 a = ssgi_held(v, p, j), b = j + 1 < layers ? ssgi_held(v, p, j + 1) : uvec2(0xffffffffu);\n"
    "        float near = ssgi_unpack_depth(a.y), far = ssgi_unpack_depth(b.y), back = far;\n" };
static const ssgi_gl__chunk ssgi_gl__matter_back = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__THIN,
    "        if (far >= SSGI_FAR) back = near + ssgi_thickness();\n" };
static const ssgi_gl__chunk ssgi_gl__matter_inside = { __LINE__ + 1, SSGI_GL__DEEP,
    "        bool inside = !known && s > near && s < back;\n"
    "        if (!known && s <= near - slack) found = -1.0;\n" };
static const ssgi_gl__chunk ssgi_gl__matter_offer = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__SENDERS,
    "        if (inside) {\n"
    "            ssgi_offer(a, ssgi_point(v, p, near));\n"
    "            if (far < SSGI_FAR) ssgi_offer(b, ssgi_point(v, p, far));\n"
    "        }\n" };
static const ssgi_gl__chunk ssgi_gl__matter_fade = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__FADE,
    "        if (inside) found = ssgi_faded(ssgi_point(v, p, s - near < far - s ? near : far));\n" };
static const ssgi_gl__chunk ssgi_gl__matter_whole = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__NO_FADE,
    "        if (inside) found = 1.0;\n" };
static const ssgi_gl__chunk ssgi_gl__matter_tail = { __LINE__ + 1, SSGI_GL__DEEP,
    "        known = known || s < back || far >= SSGI_FAR; // within the slack before a surface nothing is known either\n"
    "    }\n"
    "    return found;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__deep_head = { __LINE__ + 1, SSGI_GL__DEEP,
    "// how much S is blocked: inside matter\n"
    "float ssgi_blocked(vec3 S)\n"
    "{\n"
    "    ivec2 p = ivec2(floor(ssgi_project(S)));\n" };
static const ssgi_gl__chunk ssgi_gl__deep_reset = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__SENDERS,
    "    ssgi_sender = vec4(0.0, 0.0, 0.0, SSGI_FAR);\n"
    "    ssgi_way = S - ssgi_P;\n" };
static const ssgi_gl__chunk ssgi_gl__deep_main = { __LINE__ + 1, SSGI_GL__DEEP,
    "    float found = S.z < 0.0 && ssgi_inside(p) ? ssgi_matter(-1, p, -S.z, SSGI_LAYERS, 0.0) : 0.0;\n" };
static const ssgi_gl__chunk ssgi_gl__deep_views = { __LINE__ + 1, SSGI_GL__VIEWS,
    "    for (int v = 0; v < SSGI_VIEWS; ++v) { // whoever sees it in the open is right\n"
    "        vec3 q = (u_ssgi_view_to[v] * vec4(S, 1.0)).xyz;\n"
    "        p = ivec2(floor(u_ssgi_view_decode[v].w > 0.0 ? q.xy : q.xy / q.z));\n"
    "        if (q.z > 0.0 && p.x >= 0 && p.y >= 0 && p.x < int(u_ssgi_view_size[v].x) && p.y < int(u_ssgi_view_size[v].y)) {\n"
    "            float m = ssgi_matter(v, p, q.z, SSGI_VIEW_LAYERS, u_ssgi_view_size[v].z * (u_ssgi_view_decode[v].w > 0.0 ? 1.0 : q.z));\n"
    "            found = min(found, m) < 0.0 ? -1.0 : max(found, m);\n"
    "        }\n"
    "    }\n" };
static const ssgi_gl__chunk ssgi_gl__deep_tail = { __LINE__ + 1, SSGI_GL__DEEP,
    "    return max(found, 0.0);\n"
    "}\n" };

/* ==== >>harmonics: vectors of coefficients, and how they are stored ================================================ */

/* Coefficient 4w + k is lane k of word a, b, c, d. Lanes beyond the bands are 0: compilers drop them. Twins of >>sh in ssgi.h. */

static const ssgi_gl__chunk ssgi_gl__sh_struct = { __LINE__ + 1, SSGI_GL__VECTORS,
    "struct ssgi_sh { // coefficient 4w + k in lane k of word w\n"
    "    vec4 a;\n" };
static const ssgi_gl__chunk ssgi_gl__sh_struct3 = { __LINE__ + 1, SSGI_GL__V3,
    "    vec4 b, c;\n" };
static const ssgi_gl__chunk ssgi_gl__sh_struct4 = { __LINE__ + 1, SSGI_GL__V4,
    "    vec4 d;\n" };
static const ssgi_gl__chunk ssgi_gl__sh_struct_end = { __LINE__ + 1, SSGI_GL__VECTORS,
    "};\n" };

static const ssgi_gl__chunk ssgi_gl__sh_basis = { __LINE__ + 1, SSGI_GL__LOBES | SSGI_GL__VECTORS,
    "// real spherical harmonics at a unit direction, l*l + l + m, without the Condon-Shortley sign\n"
    "ssgi_sh ssgi_sh_basis(vec3 n)\n"
    "{\n"
    "    ssgi_sh y;\n"
    "    y.a = vec4(0.28209479, 0.0, 0.0, 0.0);\n" };
static const ssgi_gl__chunk ssgi_gl__sh_basis2 = { __LINE__ + 1, SSGI_GL__LOBES | SSGI_GL__V2,
    "    y.a.yzw = 0.48860251 * n.yzx;\n" };
static const ssgi_gl__chunk ssgi_gl__sh_basis3 = { __LINE__ + 1, SSGI_GL__LOBES | SSGI_GL__V3,
    "    float zz = n.z * n.z;\n"
    "    vec3 m = n.xyz * n.yzx;\n"
    "    vec2 q = n.xy * n.xy;\n"
    "    y.b = vec4(1.09254843 * m.xy, 0.94617470 * zz - 0.31539157, 1.09254843 * m.z);\n"
    "    y.c = vec4(0.54627422 * (q.x - q.y), 0.0, 0.0, 0.0);\n" };
static const ssgi_gl__chunk ssgi_gl__sh_basis4 = { __LINE__ + 1, SSGI_GL__LOBES | SSGI_GL__V4,
    "    float five = 2.28522901 * zz - 0.45704580;\n"
    "    y.c.yzw = vec3(0.59004359 * n.y * (3.0 * q.x - q.y), 2.89061144 * m.x * n.z, n.y * five);\n"
    "    y.d = vec4(n.z * (1.86588166 * zz - 1.11952900), n.x * five, 1.44530572 * n.z * (q.x - q.y), 0.59004359 * n.x * (q.x - 3.0 * q.y));\n" };
static const ssgi_gl__chunk ssgi_gl__sh_basis_end = { __LINE__ + 1, SSGI_GL__LOBES | SSGI_GL__VECTORS,
    "    return y;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__sh_add = { __LINE__ + 1, SSGI_GL__VECTORS,
    "void ssgi_sh_add(inout ssgi_sh s, ssgi_sh y, float w)\n"
    "{\n"
    "    s.a += y.a * w;\n" };
static const ssgi_gl__chunk ssgi_gl__sh_add3 = { __LINE__ + 1, SSGI_GL__V3,
    "    s.b += y.b * w;\n"
    "    s.c += y.c * w;\n" };
static const ssgi_gl__chunk ssgi_gl__sh_add4 = { __LINE__ + 1, SSGI_GL__V4,
    "    s.d += y.d * w;\n" };
static const ssgi_gl__chunk ssgi_gl__sh_add_end = { __LINE__ + 1, SSGI_GL__VECTORS,
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__sh_dot = { __LINE__ + 1, SSGI_GL__LOBES | SSGI_GL__VECTORS,
    "// the integral of the product\n"
    "float ssgi_sh_dot(ssgi_sh x, ssgi_sh y)\n"
    "{\n"
    "    float s = dot(x.a, y.a);\n" };
static const ssgi_gl__chunk ssgi_gl__sh_dot3 = { __LINE__ + 1, SSGI_GL__LOBES | SSGI_GL__V3,
    "    s += dot(x.b, y.b) + dot(x.c, y.c);\n" };
static const ssgi_gl__chunk ssgi_gl__sh_dot4 = { __LINE__ + 1, SSGI_GL__LOBES | SSGI_GL__V4,
    "    s += dot(x.d, y.d);\n" };
static const ssgi_gl__chunk ssgi_gl__sh_dot_end = { __LINE__ + 1, SSGI_GL__LOBES | SSGI_GL__VECTORS,
    "    return s;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__sh_cosine = { __LINE__ + 1, SSGI_GL__COSINE,
    "const vec4 SSGI_COSINE = vec4(0.88622693, 1.02332671, 0.49541591, 0.0); // zonal harmonics of the clamped cosine\n" };
static const ssgi_gl__chunk ssgi_gl__sh_zonal = { __LINE__ + 1, SSGI_GL__LOBES | SSGI_GL__VECTORS,
    "// a lobe about n from its zonal harmonics, a lane a band\n"
    "ssgi_sh ssgi_sh_zonal(vec4 zonal, vec3 n)\n"
    "{\n"
    "    ssgi_sh y = ssgi_sh_basis(n);\n"
    "    zonal *= vec4(3.54490770, 2.04665341, 1.58533092, 1.33984917);\n"
    "    y.a *= zonal.xyyy;\n" };
static const ssgi_gl__chunk ssgi_gl__sh_zonal3 = { __LINE__ + 1, SSGI_GL__LOBES | SSGI_GL__V3,
    "    y.b *= zonal.z;\n"
    "    y.c *= zonal.zwww;\n" };
static const ssgi_gl__chunk ssgi_gl__sh_zonal4 = { __LINE__ + 1, SSGI_GL__LOBES | SSGI_GL__V4,
    "    y.d *= zonal.w;\n" };
static const ssgi_gl__chunk ssgi_gl__sh_zonal_end = { __LINE__ + 1, SSGI_GL__LOBES | SSGI_GL__VECTORS,
    "    return y;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__sh_about = { __LINE__ + 1, SSGI_GL__FREE | SSGI_GL__V3,
    "vec2 ssgi_sh_complex(vec2 a, vec2 b)\n"
    "{\n"
    "    return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);\n"
    "}\n"
    "\n"
    "// turns the bands from the third on about z, by the angle whose cosine and sine are u\n"
    "void ssgi_sh_about_z(inout ssgi_sh s, vec2 u)\n"
    "{\n"
    "    vec2 uu = ssgi_sh_complex(u, u);\n"
    "    s.b.wy = ssgi_sh_complex(s.b.wy, u);\n"
    "    vec2 t = ssgi_sh_complex(vec2(s.c.x, s.b.x), uu);\n"
    "    s.c.x = t.x;\n"
    "    s.b.x = t.y;\n" };
static const ssgi_gl__chunk ssgi_gl__sh_about4 = { __LINE__ + 1, SSGI_GL__FREE | SSGI_GL__V4,
    "    vec2 one = ssgi_sh_complex(vec2(s.d.y, s.c.w), u), two = ssgi_sh_complex(vec2(s.d.z, s.c.z), uu), three = ssgi_sh_complex(vec2(s.d.w, s.c.y), ssgi_sh_complex(uu, u));\n"
    "    s.d.yzw = vec3(one.x, two.x, three.x);\n"
    "    s.c.yzw = vec3(three.y, two.y, one.y);\n" };
static const ssgi_gl__chunk ssgi_gl__sh_quarter = { __LINE__ + 1, SSGI_GL__FREE | SSGI_GL__V3,
    "}\n"
    "\n"
    "// and about x by a quarter, forth (1) or back (-1)\n"
    "void ssgi_sh_quarter(inout ssgi_sh s, float way)\n"
    "{\n"
    "    float q = s.c.x;\n"
    "    s.c.x = 0.5 * q - 0.86602540 * s.b.z;\n"
    "    s.b = vec4(-way * s.b.w, -s.b.y, -0.5 * s.b.z - 0.86602540 * q, way * s.b.x);\n" };
static const ssgi_gl__chunk ssgi_gl__sh_quarter4 = { __LINE__ + 1, SSGI_GL__FREE | SSGI_GL__V4,
    "    vec4 o = vec4(s.c.y, s.c.w, s.d.x, s.d.z);\n"
    "    s.c.yzw = vec3(way * (0.79056942 * o.z - 0.61237244 * o.w), -s.c.z, way * (0.61237244 * o.z + 0.79056942 * o.w));\n"
    "    s.d = vec4(way * (-0.79056942 * o.x - 0.61237244 * o.y), -0.25 * s.d.y - 0.96824584 * s.d.w, way * (0.61237244 * o.x - 0.79056942 * o.y), 0.25 * s.d.w - 0.96824584 * s.d.y);\n" };
static const ssgi_gl__chunk ssgi_gl__sh_quarter_end = { __LINE__ + 1, SSGI_GL__FREE | SSGI_GL__V3,
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__sh_turn = { __LINE__ + 1, SSGI_GL__FREE,
    "// turns a function by a rotation: its value at n goes to R n\n"
    "void ssgi_sh_turn(inout ssgi_sh s, mat3 R)\n"
    "{\n" };
static const ssgi_gl__chunk ssgi_gl__sh_turn2 = { __LINE__ + 1, SSGI_GL__FREE | SSGI_GL__V2,
    "    s.a.yzw = (R * s.a.wyz).yzx;\n" };
static const ssgi_gl__chunk ssgi_gl__sh_turn3 = { __LINE__ + 1, SSGI_GL__FREE | SSGI_GL__V3,
    "    // R = Rz(phi) Ry(theta) Rz(psi), and Ry is Rz between two quarters about x. Near a pole only phi + psi or phi - psi is sure, so psi is what remains of that\n"
    "    float m = dot(R[2].xy, R[2].xy);\n"
    "    vec2 phi = m > 1e-30 ? R[2].xy * inversesqrt(m) : vec2(1.0, 0.0);\n"
    "    vec2 psi = R[2].z < 0.0 ? ssgi_sh_complex(vec2(R[1].y - R[0].x, R[0].y + R[1].x), phi) : ssgi_sh_complex(vec2(R[0].x + R[1].y, R[0].y - R[1].x), vec2(phi.x, -phi.y));\n"
    "    ssgi_sh_about_z(s, normalize(psi));\n"
    "    ssgi_sh_quarter(s, 1.0);\n"
    "    ssgi_sh_about_z(s, vec2(R[2].z, sqrt(m)));\n"
    "    ssgi_sh_quarter(s, -1.0);\n"
    "    ssgi_sh_about_z(s, phi);\n" };
static const ssgi_gl__chunk ssgi_gl__sh_turn_end = { __LINE__ + 1, SSGI_GL__FREE,
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__half_native = { __LINE__ + 1, SSGI_GL__HALF_NATIVE | SSGI_GL__PACKS,
    "uint ssgi_pack_half(vec2 v)\n"
    "{\n"
    "    return packHalf2x16(clamp(v, -65504.0, 65504.0));\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__half_made = { __LINE__ + 1, SSGI_GL__HALF_MADE | SSGI_GL__PACKS,
    "// packHalf2x16, which this language lacks: to nearest even\n"
    "uint ssgi_pack_half(vec2 v)\n"
    "{\n"
    "    uvec2 u = floatBitsToUint(clamp(v, -65504.0, 65504.0)), a = u & 0x7fffffffu;\n"
    "    uvec2 h = (a - 0x38000000u + 0xfffu + ((a >> 13u) & 1u)) >> 13u, small = floatBitsToUint(uintBitsToFloat(a) + 0.5) - 0x3f000000u; // below 2^-14 the sum rounds\n"
    "    h = uvec2(a.x < 0x38800000u ? small.x : h.x, a.y < 0x38800000u ? small.y : h.y) | ((u >> 16u) & 0x8000u);\n"
    "    return h.x | (h.y << 16u);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__unhalf_native = { __LINE__ + 1, SSGI_GL__HALF_NATIVE | SSGI_GL__UNPACKS,
    "vec2 ssgi_unpack_half(uint u)\n"
    "{\n"
    "    return unpackHalf2x16(u);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__unhalf_made = { __LINE__ + 1, SSGI_GL__HALF_MADE | SSGI_GL__UNPACKS,
    "vec2 ssgi_unpack_half(uint u)\n"
    "{\n"
    "    uvec2 h = uvec2(u & 0xffffu, u >> 16u), e = h & 0x7c00u;\n"
    "    vec2 v = uintBitsToFloat(((h & 0x7fffu) << 13u) + 0x38000000u), small = vec2(h & 0x3ffu) * 5.9604645e-8;\n"
    "    v = vec2(e.x == 0u ? small.x : v.x, e.y == 0u ? small.y : v.y);\n"
    "    return vec2(h.x > 0x7fffu ? -v.x : v.x, h.y > 0x7fffu ? -v.y : v.y);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__vectors_mono = { __LINE__ + 1, SSGI_GL__MONO,
    "struct ssgi_vectors { ssgi_sh c[1]; };\n" };
static const ssgi_gl__chunk ssgi_gl__vectors_rgb = { __LINE__ + 1, SSGI_GL__RGB,
    "struct ssgi_vectors { ssgi_sh c[3]; }; // red, green, blue\n" };

static const ssgi_gl__chunk ssgi_gl__unpack_sh = { __LINE__ + 1, SSGI_GL__PACKED,
    "ssgi_sh ssgi_unpack(uvec4 u, uvec4 v)\n"
    "{\n"
    "    ssgi_sh s;\n"
    "    s.a = vec4(ssgi_unpack_half(u.x).x, 0.0, 0.0, 0.0);\n" };
static const ssgi_gl__chunk ssgi_gl__unpack_sh2 = { __LINE__ + 1, SSGI_GL__PACKED | SSGI_GL__V2,
    "    s.a = vec4(ssgi_unpack_half(u.x), ssgi_unpack_half(u.y));\n" };
static const ssgi_gl__chunk ssgi_gl__unpack_sh3 = { __LINE__ + 1, SSGI_GL__PACKED | SSGI_GL__V3,
    "    s.b = vec4(ssgi_unpack_half(u.z), ssgi_unpack_half(u.w));\n"
    "    s.c = vec4(ssgi_unpack_half(v.x).x, 0.0, 0.0, 0.0);\n" };
static const ssgi_gl__chunk ssgi_gl__unpack_sh4 = { __LINE__ + 1, SSGI_GL__PACKED | SSGI_GL__V4,
    "    s.c = vec4(ssgi_unpack_half(v.x), ssgi_unpack_half(v.y));\n"
    "    s.d = vec4(ssgi_unpack_half(v.z), ssgi_unpack_half(v.w));\n" };
static const ssgi_gl__chunk ssgi_gl__unpack_sh_end = { __LINE__ + 1, SSGI_GL__PACKED,
    "    return s;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__load = { __LINE__ + 1, SSGI_GL__VECTORS,
    "// what s3ho wrote at a texel of its targets\n"
    "ssgi_vectors ssgi_load(ivec2 p)\n"
    "{\n"
    "    ssgi_vectors v;\n" };
static const ssgi_gl__chunk ssgi_gl__load_words = { __LINE__ + 1, SSGI_GL__WORDS,
    "    v.c[0].a = vec4(texelFetch(t_ssgi_sh0, p, 0).x, 0.0, 0.0, 0.0);\n" };
static const ssgi_gl__chunk ssgi_gl__load_words2 = { __LINE__ + 1, SSGI_GL__WORDS | SSGI_GL__V2,
    "    v.c[0].a = texelFetch(t_ssgi_sh0, p, 0);\n" };
static const ssgi_gl__chunk ssgi_gl__load_words3 = { __LINE__ + 1, SSGI_GL__WORDS | SSGI_GL__V3,
    "    v.c[0].b = texelFetch(t_ssgi_sh1, p, 0);\n"
    "    v.c[0].c = vec4(texelFetch(t_ssgi_sh2, p, 0).x, 0.0, 0.0, 0.0);\n" };
static const ssgi_gl__chunk ssgi_gl__load_words4 = { __LINE__ + 1, SSGI_GL__WORDS | SSGI_GL__V4,
    "    v.c[0].c = texelFetch(t_ssgi_sh2, p, 0);\n"
    "    v.c[0].d = texelFetch(t_ssgi_sh3, p, 0);\n" };
static const ssgi_gl__chunk ssgi_gl__load_mono = { __LINE__ + 1, SSGI_GL__PACKED | SSGI_GL__MONO,
    "    uvec4 first = texelFetch(t_ssgi_sh0, p, 0), more = uvec4(0u);\n" };
static const ssgi_gl__chunk ssgi_gl__load_mono3 = { __LINE__ + 1, SSGI_GL__PACKED | SSGI_GL__MONO | SSGI_GL__V3,
    "    more = texelFetch(t_ssgi_sh1, p, 0);\n" };
static const ssgi_gl__chunk ssgi_gl__load_mono_end = { __LINE__ + 1, SSGI_GL__PACKED | SSGI_GL__MONO,
    "    v.c[0] = ssgi_unpack(first, more);\n" };
static const ssgi_gl__chunk ssgi_gl__load_rgb = { __LINE__ + 1, SSGI_GL__RGB,
    "    uvec4 red = uvec4(0u), green = red, blue = red;\n" };
static const ssgi_gl__chunk ssgi_gl__load_rgb3 = { __LINE__ + 1, SSGI_GL__RGB | SSGI_GL__V3,
    "    red = texelFetch(t_ssgi_red1, p, 0);\n"
    "    green = texelFetch(t_ssgi_green1, p, 0);\n"
    "    blue = texelFetch(t_ssgi_blue1, p, 0);\n" };
static const ssgi_gl__chunk ssgi_gl__load_rgb_end = { __LINE__ + 1, SSGI_GL__RGB,
    "    v.c[0] = ssgi_unpack(texelFetch(t_ssgi_red0, p, 0), red);\n"
    "    v.c[1] = ssgi_unpack(texelFetch(t_ssgi_green0, p, 0), green);\n"
    "    v.c[2] = ssgi_unpack(texelFetch(t_ssgi_blue0, p, 0), blue);\n" };
static const ssgi_gl__chunk ssgi_gl__load_end = { __LINE__ + 1, SSGI_GL__VECTORS,
    "    return v;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__pack_sh = { __LINE__ + 1, SSGI_GL__PACKED,
    "// coefficients 0..7, 8..15\n"
    "uvec4 ssgi_pack_first(ssgi_sh s)\n"
    "{\n"
    "    uvec4 u = uvec4(ssgi_pack_half(s.a.xy), 0u, 0u, 0u);\n" };
static const ssgi_gl__chunk ssgi_gl__pack_sh2 = { __LINE__ + 1, SSGI_GL__PACKED | SSGI_GL__V2,
    "    u.y = ssgi_pack_half(s.a.zw);\n" };
static const ssgi_gl__chunk ssgi_gl__pack_sh3 = { __LINE__ + 1, SSGI_GL__PACKED | SSGI_GL__V3,
    "    u.z = ssgi_pack_half(s.b.xy);\n"
    "    u.w = ssgi_pack_half(s.b.zw);\n" };
static const ssgi_gl__chunk ssgi_gl__pack_sh_end = { __LINE__ + 1, SSGI_GL__PACKED,
    "    return u;\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__pack_more = { __LINE__ + 1, SSGI_GL__PACKED | SSGI_GL__V3,
    "uvec4 ssgi_pack_more(ssgi_sh s)\n"
    "{\n"
    "    uvec4 u = uvec4(ssgi_pack_half(s.c.xy), 0u, 0u, 0u);\n" };
static const ssgi_gl__chunk ssgi_gl__pack_more4 = { __LINE__ + 1, SSGI_GL__PACKED | SSGI_GL__V4,
    "    u.yzw = uvec3(ssgi_pack_half(s.c.zw), ssgi_pack_half(s.d.xy), ssgi_pack_half(s.d.zw));\n" };
static const ssgi_gl__chunk ssgi_gl__pack_more_end = { __LINE__ + 1, SSGI_GL__PACKED | SSGI_GL__V3,
    "    return u;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__store = { __LINE__ + 1, SSGI_GL__STORES,
    "void ssgi_store(ssgi_vectors v)\n"
    "{\n" };
static const ssgi_gl__chunk ssgi_gl__store_words = { __LINE__ + 1, SSGI_GL__WORDS,
    "    o_ssgi_sh0 = v.c[0].a;\n" };
static const ssgi_gl__chunk ssgi_gl__store_words3 = { __LINE__ + 1, SSGI_GL__WORDS | SSGI_GL__V3,
    "    o_ssgi_sh1 = v.c[0].b;\n"
    "    o_ssgi_sh2 = v.c[0].c;\n" };
static const ssgi_gl__chunk ssgi_gl__store_words4 = { __LINE__ + 1, SSGI_GL__WORDS | SSGI_GL__V4,
    "    o_ssgi_sh3 = v.c[0].d;\n" };
static const ssgi_gl__chunk ssgi_gl__store_mono = { __LINE__ + 1, SSGI_GL__PACKED | SSGI_GL__MONO,
    "    o_ssgi_sh0 = ssgi_pack_first(v.c[0]);\n" };
static const ssgi_gl__chunk ssgi_gl__store_mono3 = { __LINE__ + 1, SSGI_GL__PACKED | SSGI_GL__MONO | SSGI_GL__V3,
    "    o_ssgi_sh1 = ssgi_pack_more(v.c[0]);\n" };
static const ssgi_gl__chunk ssgi_gl__store_rgb = { __LINE__ + 1, SSGI_GL__PACKED | SSGI_GL__RGB,
    "    o_ssgi_red0 = ssgi_pack_first(v.c[0]);\n"
    "    o_ssgi_green0 = ssgi_pack_first(v.c[1]);\n"
    "    o_ssgi_blue0 = ssgi_pack_first(v.c[2]);\n" };
static const ssgi_gl__chunk ssgi_gl__store_rgb3 = { __LINE__ + 1, SSGI_GL__PACKED | SSGI_GL__RGB | SSGI_GL__V3,
    "    o_ssgi_red1 = ssgi_pack_more(v.c[0]);\n"
    "    o_ssgi_green1 = ssgi_pack_more(v.c[1]);\n"
    "    o_ssgi_blue1 = ssgi_pack_more(v.c[2]);\n" };
static const ssgi_gl__chunk ssgi_gl__store_end = { __LINE__ + 1, SSGI_GL__STORES,
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__lacking = { __LINE__ + 1, SSGI_GL__EXACT,
    "vec3 ssgi_lacking = vec3(0.0); // what the harmonics lack of an open surface's irradiance over pi\n" };
static const ssgi_gl__chunk ssgi_gl__incoming = { __LINE__ + 1, SSGI_GL__HARMONICS,
    "// one channel of irradiance from a vector [S3HO12 eq. 3]\n"
    "float ssgi_incoming(int c, ssgi_sh s)\n"
    "{\n"
    "    float e = dot(u_ssgi_harmonics[c], s.a);\n" };
static const ssgi_gl__chunk ssgi_gl__incoming3 = { __LINE__ + 1, SSGI_GL__HARMONICS | SSGI_GL__V3,
    "    e += dot(u_ssgi_harmonics[3 + c], s.b) + dot(u_ssgi_harmonics[6 + c], s.c);\n" };
static const ssgi_gl__chunk ssgi_gl__incoming4 = { __LINE__ + 1, SSGI_GL__HARMONICS | SSGI_GL__V4,
    "    e += dot(u_ssgi_harmonics[9 + c], s.d);\n" };
static const ssgi_gl__chunk ssgi_gl__incoming_end = { __LINE__ + 1, SSGI_GL__HARMONICS,
    "    return e;\n"
    "}\n"
    "\n"
    "// and all three, over pi\n"
    "vec3 ssgi_irradiance(ssgi_vectors v)\n"
    "{\n"
    "    vec3 e = vec3(ssgi_incoming(0, v.c[0]), ssgi_incoming(1, v.c[1 % v.c.length()]), ssgi_incoming(2, v.c[2 % v.c.length()])) * 0.31830989;\n" };
static const ssgi_gl__chunk ssgi_gl__incoming_exact = { __LINE__ + 1, SSGI_GL__EXACT,
    "    e += ssgi_lacking * ssgi_free(v);\n" };
static const ssgi_gl__chunk ssgi_gl__incoming_out = { __LINE__ + 1, SSGI_GL__HARMONICS,
    "    return e;\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__free_part = { __LINE__ + 1, SSGI_GL__EXACT,
    "// ambient visibility, as the vectors know it\n"
    "vec3 ssgi_free(ssgi_vectors v)\n"
    "{\n"
    "    return clamp(vec3(v.c[0].a.x, v.c[1 % v.c.length()].a.x, v.c[2 % v.c.length()].a.x) * 1.12837917, 0.0, 1.0);\n"
    "}\n" };

/* ==== >>gather: what a pixel collects ============================================================================= */

static const ssgi_gl__chunk ssgi_gl__basis = { __LINE__ + 1, 0,
    "// any rotation that takes +z to the unit vector n [Duff et al. 2017]\n"
    "mat3 ssgi_basis(vec3 n)\n"
    "{\n"
    "    float s = n.z >= 0.0 ? 1.0 : -1.0, a = -1.0 / (s + n.z), b = n.x * n.y * a;\n"
    "    return mat3(1.0 + s * n.x * n.x * a, s * b, -s * n.x, b, s + n.y * n.y * a, -n.y, n);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__kernel = { __LINE__ + 1, SSGI_GL__K_TEXT, "" };   /* printed by ssgi_gl__put_kernel */

/* Points along directions: ssao and ssdo are this one loop; what they do with a blocked direction differs. */

static const ssgi_gl__chunk ssgi_gl__points_ao = { __LINE__ + 1, 0,
    "// occlusion from point samples: directions by the cosine, lengths such that it converges to the attenuation that desc.falloff names\n"
    "float ssgi_occlusion(ivec2 p, vec3 P, vec3 n, vec2 xi)\n"
    "{\n"
    "    float sum = 0.0;\n" };

static const ssgi_gl__chunk ssgi_gl__points_ssdo = { __LINE__ + 1, 0,
    "// what directions by the cosine bring: an environment where they are free, a sender's light where they are blocked [SSDO09 section 3]\n"
    "void ssgi_gather(vec3 P, vec3 n, vec2 xi)\n"
    "{\n" };

static const ssgi_gl__chunk ssgi_gl__points_s3ho = { __LINE__ + 1, 0,
    "// the transfer from light in spherical harmonics to irradiance: the cosine lobe less what is blocked of it, in directions by the cosine [S3HO12 eq. 2];\n"
    "// it is exact where nothing is blocked\n"
    "void ssgi_gather(vec3 P, vec3 n, vec2 xi, inout ssgi_vectors v)\n"
    "{\n" };

static const ssgi_gl__chunk ssgi_gl__points_from = { __LINE__ + 1, SSGI_GL__RECEIVED,
    "    ssgi_P = P;\n" };

static const ssgi_gl__chunk ssgi_gl__points_normal = { __LINE__ + 1, SSGI_GL__FACING,
    "    ssgi_n = n;\n" };

static const ssgi_gl__chunk ssgi_gl__points_turn = { __LINE__ + 1, SSGI_GL__K_TEXT,
    "    float a = 6.28318531 * xi.x, c = cos(a), s = sin(a);\n"
    "    mat3 basis = ssgi_basis(n) * mat3(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0);\n" };

static const ssgi_gl__chunk ssgi_gl__points_pick = { __LINE__ + 1, SSGI_GL__K_TEXTURE,
    "    int set = int(xi.x * float(textureSize(t_ssgi_kernel, 0).y));\n"
    "    mat3 basis = ssgi_basis(n);\n" };

static const ssgi_gl__chunk ssgi_gl__points_map = { __LINE__ + 1, SSGI_GL__E_MAP,
    "    mat3 world = transpose(u_ssgi_rotation) * basis;\n"
    "    vec3 all = vec3(0.0), dark = vec3(0.0);\n" };

static const ssgi_gl__chunk ssgi_gl__points_bounce = { __LINE__ + 1, SSGI_GL__SENDERS,
    "    vec3 bounce = vec3(0.0);\n" };

static const ssgi_gl__chunk ssgi_gl__points_free = { __LINE__ + 1, SSGI_GL__FREE,
    "    ssgi_sh lobe = ssgi_sh_zonal(SSGI_COSINE, vec3(0.0, 0.0, 1.0)); // about n\n" };

static const ssgi_gl__chunk ssgi_gl__points_loop = { __LINE__ + 1, 0,
    "    vec3 start = ssgi_lift(P, n);\n"
    "    for (int i = 0; i < SSGI_SAMPLES; ++i) {\n" };

static const ssgi_gl__chunk ssgi_gl__points_constant = { __LINE__ + 1, SSGI_GL__K_TEXT,
    "        vec4 k = SSGI_KERNEL[i];\n" };

static const ssgi_gl__chunk ssgi_gl__points_fetched = { __LINE__ + 1, SSGI_GL__K_TEXTURE,
    "        vec4 k = texelFetch(t_ssgi_kernel, ivec2(i, set), 0);\n" };

static const ssgi_gl__chunk ssgi_gl__points_single = { __LINE__ + 1, SSGI_GL__SINGLE,
    "        float blocked = ssgi_blocked(start + basis * k.xyz * (u_ssgi_radius * ssgi_length(fract(k.w + xi.y))));\n" };

static const ssgi_gl__chunk ssgi_gl__points_several = { __LINE__ + 1, SSGI_GL__SEVERAL,
    "        vec3 w = basis * k.xyz * u_ssgi_radius;\n"
    "        float t = fract(k.w + xi.y), blocked = 0.0;\n"
    "        for (int j = 0; j < SSGI_STEPS && blocked <= 0.0; ++j) blocked = ssgi_blocked(start + w * ssgi_length((float(j) + t) / float(SSGI_STEPS)));\n" };

static const ssgi_gl__chunk ssgi_gl__length_uniform = { __LINE__ + 1, SSGI_GL__UNIFORM,
    "// where on its direction a sample stands\n"
    "float ssgi_length(float xi)\n"
    "{\n"
    "    return xi;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__length_square = { __LINE__ + 1, SSGI_GL__SQUARE,
    "// where on its direction a sample stands\n"
    "float ssgi_length(float xi)\n"
    "{\n"
    "    return sqrt(xi);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__length_cube = { __LINE__ + 1, SSGI_GL__CUBE,
    "// where on its direction a sample stands\n"
    "float ssgi_length(float xi)\n"
    "{\n"
    "    return pow(xi, 1.0 / 3.0);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__sum_ao = { __LINE__ + 1, 0,
    "        sum += blocked;\n"
    "    }\n"
    "    return sum / float(SSGI_SAMPLES);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__sum_map = { __LINE__ + 1, SSGI_GL__E_MAP,
    "        vec3 L = ssgi_environment(world * k.xyz);\n"
    "        all += L;\n"
    "        dark += L * blocked;\n" };

static const ssgi_gl__chunk ssgi_gl__sum_angle = { __LINE__ + 1, SSGI_GL__SOLID_ANGLE,
    "        bounce += ssgi_sender.xyz * blocked;\n" };

static const ssgi_gl__chunk ssgi_gl__sum_area = { __LINE__ + 1, SSGI_GL__AREA,
    "        bounce += ssgi_sender.xyz * (blocked * 0.5 / max(k.z, 0.05)); // as often as if directions were uniform, which the area is meant for\n" };

static const ssgi_gl__chunk ssgi_gl__sum_free = { __LINE__ + 1, SSGI_GL__FREE,
    "        ssgi_sh_add(lobe, ssgi_sh_basis(k.xyz), blocked * (-3.14159265 / float(SSGI_SAMPLES)));\n" };

static const ssgi_gl__chunk ssgi_gl__sum_reflected = { __LINE__ + 1, SSGI_GL__RGB,
    "        if (blocked > 0.0) { // the sender's own cosine lobe, unoccluded, times its albedo [S3HO12 eq. 5, ours of solid angle]\n"
    "            vec3 o = normalize(ssgi_unpack_normal(ssgi_sender_place)), albedo = ssgi_sender.xyz * (blocked / float(SSGI_SAMPLES));\n" };
static const ssgi_gl__chunk ssgi_gl__sum_both_sides = { __LINE__ + 1, SSGI_GL__SENDER_KEPT | SSGI_GL__TWO_SIDED,
    "            if (dot(o, basis * k.xyz) > 0.0) o = -o;\n" };
static const ssgi_gl__chunk ssgi_gl__sum_reflected_end = { __LINE__ + 1, SSGI_GL__RGB,
    "            ssgi_sh y = ssgi_sh_zonal(SSGI_COSINE, o);\n"
    "            for (int c = 0; c < v.c.length(); ++c) ssgi_sh_add(v.c[c], y, albedo[c]);\n"
    "        }\n" };

static const ssgi_gl__chunk ssgi_gl__points_end = { __LINE__ + 1, 0,
    "    }\n" };

static const ssgi_gl__chunk ssgi_gl__light_vectors = { __LINE__ + 1, SSGI_GL__FREE,
    "    ssgi_vectors v = ssgi_vectors_none();\n" };

static const ssgi_gl__chunk ssgi_gl__light_dot = { __LINE__ + 1, SSGI_GL__HARMONICS,
    "    o_ssgi_light.xyz = max(ssgi_irradiance(v), 0.0);\n" };

static const ssgi_gl__chunk ssgi_gl__light_map = { __LINE__ + 1, SSGI_GL__E_MAP,
    "    // the share of the samples' light that is free, of what the open pixel gets: exact where nothing is blocked\n"
    "    o_ssgi_light.xyz = ssgi_open(world[2], 0) * (1.0 - dark / max(all, 1e-30));\n" };

static const ssgi_gl__chunk ssgi_gl__light_bounce = { __LINE__ + 1, SSGI_GL__SENDERS,
    "    o_ssgi_bounce.xyz = bounce / float(SSGI_SAMPLES);\n" };

static const ssgi_gl__chunk ssgi_gl__points_turned = { __LINE__ + 1, SSGI_GL__FREE,
    "    ssgi_sh_turn(lobe, basis);\n"
    "    for (int c = 0; c < v.c.length(); ++c) ssgi_sh_add(v.c[c], lobe, 1.0);\n" };

static const ssgi_gl__chunk ssgi_gl__points_exact = { __LINE__ + 1, SSGI_GL__EXACT,
    "    ssgi_lacking = ssgi_open(transpose(u_ssgi_rotation) * n, 0);\n" };

static const ssgi_gl__chunk ssgi_gl__points_close = { __LINE__ + 1, 0,
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__attenuation_linear = { __LINE__ + 1, SSGI_GL__LINEAR,
    "// weight of an occluder at a distance [HSAO08 3.5]\n"
    "float ssgi_attenuation(float d)\n"
    "{\n"
    "    return max(1.0 - d / u_ssgi_radius, 0.0);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__attenuation_hard = { __LINE__ + 1, SSGI_GL__HARD,
    "// weight of an occluder at a distance: all within the radius count alike\n"
    "float ssgi_attenuation(float d)\n"
    "{\n"
    "    return d < u_ssgi_radius ? 1.0 : 0.0;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__normal_ray = { __LINE__ + 1, SSGI_GL__RAYS,
    "// occlusion along one ray from the lifted receiver: the weight of the first blocked step\n"
    "float ssgi_ray(vec3 start, vec3 direction, float xi)\n"
    "{\n"
    "    for (int i = 0; i < SSGI_STEPS; ++i) {\n"
    "        float d = u_ssgi_radius * (float(i) + xi) / float(SSGI_STEPS);\n"
    "        if (ssgi_blocked(start + direction * d) > 0.0) return ssgi_attenuation(d);\n"
    "    }\n"
    "    return 0.0;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__march = { __LINE__ + 1, 0,
    "// Horizon of one tangent direction t by deflecting a ray toward the surface [HSAO08 fig. 4]: x is H, the sine of its elevation, y the\n"
    "// occlusion below it, the sum of the increments of H^2, each attenuated by the distance at which it was found.\n"
    "vec2 ssgi_horizon(vec3 P, vec3 start, vec3 n, vec3 t, float beta)\n"
    "{\n"
    "    vec3 h = t;\n"
    "    vec2 r = vec2(0.0);\n"
    "    for (int i = 1; i <= SSGI_STEPS; ++i) {\n"
    "        vec3 Q = start + h * (u_ssgi_radius * (float(i) + beta) / float(SSGI_STEPS));\n"
    "        if (Q.z >= 0.0) break;\n"
    "        ivec2 q = ivec2(floor(ssgi_project(Q)));\n"
    "        if (!ssgi_inside(q)) break;\n"
    "        float z = ssgi_depth(q);\n"
    "        vec3 d = ssgi_position(vec2(q) + 0.5, z) - P;\n"
    "        float x = dot(d, t), y = dot(d, n), l = length(d);\n"
    "        if (z < -Q.z && l < u_ssgi_radius && x > 0.0) {\n"
    "            float H = y * inversesqrt(x * x + y * y);\n"
    "            if (H > r.x) {\n"
    "                r = vec2(H, r.y + (H * H - r.x * r.x) * ssgi_attenuation(l));\n"
    "                h = H * n + sqrt(max(1.0 - H * H, 0.0)) * t;\n"
    "            }\n"
    "        }\n"
    "    }\n"
    "    return r;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__above_rays = { __LINE__ + 1, SSGI_GL__RAYS,
    "// occlusion above a horizon H in direction t: equal weights over z^2 in [H^2, 1] [HSAO08 3.3, corrected]\n"
    "float ssgi_above(vec3 start, vec3 n, vec3 t, float H, vec2 xi)\n"
    "{\n"
    "    float sum = 0.0;\n"
    "    for (int k = 0; k < SSGI_NORMAL_RAYS; ++k) {\n"
    "        float zz = H * H + (1.0 - H * H) * (float(k) + xi.x) / float(SSGI_NORMAL_RAYS);\n"
    "        sum += ssgi_ray(start, n * sqrt(zz) + t * sqrt(1.0 - zz), xi.y);\n"
    "    }\n"
    "    return (1.0 - H * H) * sum / float(SSGI_NORMAL_RAYS);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__gather_march_head = { __LINE__ + 1, 0,
    "// occlusion: horizons of SSGI_DIRECTIONS tangent directions [HSAO08 eq. 6]\n"
    "float ssgi_occlusion(ivec2 p, vec3 P, vec3 n, vec2 xi)\n"
    "{\n"
    "    mat3 basis = ssgi_basis(n);\n"
    "    vec3 start = ssgi_lift(P, n);\n"
    "    float sum = 0.0;\n"
    "    for (int i = 0; i < SSGI_DIRECTIONS; ++i) {\n"
    "        float a = 6.28318531 * (float(i) + xi.x) / float(SSGI_DIRECTIONS);\n"
    "        vec3 t = basis[0] * cos(a) + basis[1] * sin(a);\n"
    "        vec2 h = ssgi_horizon(P, start, n, t, xi.y - 0.5);\n"
    "        sum += h.y;\n" };

static const ssgi_gl__chunk ssgi_gl__gather_march_rays = { __LINE__ + 1, SSGI_GL__RAYS,
    "        sum += ssgi_above(start, n, t, h.x, vec2(fract(xi.x * 3.0 + float(i) * 0.61803399), xi.y));\n" };

static const ssgi_gl__chunk ssgi_gl__gather_march_tail = { __LINE__ + 1, 0,
    "    }\n"
    "    return sum / float(SSGI_DIRECTIONS);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__arc = { __LINE__ + 1, 0,
    "// Occlusion of a slice's two sides from the tangent plane up to elevations with cosines c and sines s: the integral of sin x cos(g - x), where\n"
    "// g is the signed angle from the view direction to the projected normal; half its cosine and +-half its sine are given.\n"
    "vec2 ssgi_arc(vec2 c, vec2 s, float cosg, vec2 sing)\n"
    "{\n"
    "    vec2 x = abs(c), e = sqrt(max(1.0 - x, 0.0)) * (1.5707288 + x * (-0.2121144 + x * (0.0742610 - 0.0187293 * x))); // acos, error < 7e-5\n"
    "    return cosg * s * s + sing * (mix(e, 3.14159265 - e, lessThan(c, vec2(0.0))) - s * c);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__screen_perspective = { __LINE__ + 1, SSGI_GL__PERSPECTIVE,
    "// pixels that a small step along t from P covers, per unit of length\n"
    "vec2 ssgi_screen(vec3 P, vec3 t)\n"
    "{\n"
    "    return (t.xy - P.xy * (t.z / P.z)) * (u_ssgi_project.xy / -P.z);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__screen_orthographic = { __LINE__ + 1, SSGI_GL__ORTHOGRAPHIC,
    "// pixels that a small step along t from P covers, per unit of length\n"
    "vec2 ssgi_screen(vec3 P, vec3 t)\n"
    "{\n"
    "    return t.xy * u_ssgi_project.xy;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__slices_head = { __LINE__ + 1, 0,
    "// Occlusion: horizons on both sides (.x, .y) of SSGI_DIRECTIONS planes through the view direction. n over the length l of its projection makes\n"
    "// dot(d, n) the height over the tangent plane within the slice: exactly 0 on a plane, wherever texels lie. Each rise of a horizon is attenuated\n"
    "// by the mean distance of the taps that it lies between. Sines of elevations below SSGI_LEVEL count as 0: normals of 10 bits do not know better;\n"
    "// beyond the zenith those below SSGI_OVER do: that is rounding, or a tap that a texel's centre took off the slice.\n"
    "const float SSGI_LEVEL = 0.004, SSGI_OVER = 0.4;\n"
    "float ssgi_occlusion(ivec2 p, vec3 P, vec3 normal, vec2 xi)\n"
    "{\n"
    "    vec2 pixel = vec2(p) + 0.5;\n"
    "    vec3 V = ssgi_toward(P);\n"
    "    mat3 basis = ssgi_basis(V);\n"
    "    float total = 0.0;\n"
    "    for (int i = 0; i < SSGI_DIRECTIONS; ++i) {\n"
    "        float phi = 3.14159265 * (float(i) + xi.x) / float(SSGI_DIRECTIONS);\n"
    "        vec3 slice = basis[0] * cos(phi) + basis[1] * sin(phi);\n"
    "        float a = dot(normal, slice), b = dot(normal, V), l = max(sqrt(a * a + b * b), 1e-4), cosg = b / l, sing = a / l;\n"
    "        vec2 pixels = ssgi_screen(P, slice) * u_ssgi_radius;\n"
    "        vec3 t = slice * cosg - V * sing, n = normal / l;\n"
    "        vec2 low = vec2(1.0), below = vec2(0.0), sum = vec2(0.0), sings = vec2(0.5, -0.5) * sing;\n"
    "        cosg *= 0.5;\n" };

static const ssgi_gl__chunk ssgi_gl__slices_thin = { __LINE__ + 1, SSGI_GL__THIN,
    "        vec3 back = vec3(dot(t, V) * vec2(1.0, -1.0), dot(n, V)) * u_ssgi_thickness; // what is seen reaches so far away from the viewer\n" };

static const ssgi_gl__chunk ssgi_gl__slices_last = { __LINE__ + 1, SSGI_GL__LINEAR,
    "        vec2 last = vec2(0.0);\n" };

static const ssgi_gl__chunk ssgi_gl__slices_loop = { __LINE__ + 1, 0,
    "        for (int k = 0; k < SSGI_STEPS; ++k) {\n"
    "            vec2 u = (float(k) + vec2(xi.y, 1.0 - xi.y)) / float(SSGI_STEPS);\n"
    "            u *= u;\n"
    "            ivec2 q0 = ivec2(floor(pixel + pixels * u.x)), q1 = ivec2(floor(pixel - pixels * u.y));\n"
    "            vec3 d0 = ssgi_position(vec2(q0) + 0.5, ssgi_depth(q0)) - P, d1 = ssgi_position(vec2(q1) + 0.5, ssgi_depth(q1)) - P;\n"
    "            vec2 x = vec2(dot(d0, t), -dot(d1, t)), y = vec2(dot(d0, n), dot(d1, n));\n"
    "            vec2 far = max(sqrt(vec2(dot(d0, d0), dot(d1, d1))), 1e-18), h = min(y / far, 1.0), c = sqrt(1.0 - h * h) * mix(vec2(1.0), vec2(-1.0), lessThan(x, vec2(0.0)));\n"
    "            vec2 above = ssgi_arc(c, h, cosg, sings);\n"
    "            bvec2 rises = bvec2(h.x > (x.x < 0.0 ? SSGI_OVER : SSGI_LEVEL) && c.x < low.x && far.x < u_ssgi_radius && ssgi_inside(q0),\n"
    "                                h.y > (x.y < 0.0 ? SSGI_OVER : SSGI_LEVEL) && c.y < low.y && far.y < u_ssgi_radius && ssgi_inside(q1));\n" };

static const ssgi_gl__chunk ssgi_gl__slices_gap = { __LINE__ + 1, SSGI_GL__THIN,
    "            vec2 xb = x - back.xy, yb = y - back.z, rb = inversesqrt(xb * xb + yb * yb), cb = xb * rb; // light passes between its back and low\n"
    "            below = mix(below, ssgi_arc(cb, yb * rb, cosg, sings), bvec2(rises.x && yb.x > 0.0 && cb.x < low.x, rises.y && yb.y > 0.0 && cb.y < low.y));\n" };

static const ssgi_gl__chunk ssgi_gl__slices_linear = { __LINE__ + 1, SSGI_GL__LINEAR,
    "            sum += mix(vec2(0.0), (above - below) * (1.0 - 0.5 * (far + last) / u_ssgi_radius), rises);\n"
    "            last = min(far, u_ssgi_radius);\n" };

static const ssgi_gl__chunk ssgi_gl__slices_hard = { __LINE__ + 1, SSGI_GL__HARD,
    "            sum += mix(vec2(0.0), above - below, rises);\n" };

static const ssgi_gl__chunk ssgi_gl__slices_tail = { __LINE__ + 1, 0,
    "            low = mix(low, c, rises);\n"
    "            below = mix(below, above, rises);\n"
    "        }\n"
    "        total += l * (sum.x + sum.y);\n"
    "    }\n"
    "    return total / float(SSGI_DIRECTIONS);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__main_full = { __LINE__ + 1, SSGI_GL__FULL,
    "void main()\n"
    "{\n"
    "    ivec2 p = ivec2(gl_FragCoord.xy) - u_ssgi_target;\n"
    "    vec2 xi = ssgi_noise(p);\n" };

static const ssgi_gl__chunk ssgi_gl__main_half = { __LINE__ + 1, SSGI_GL__HALF,
    "void main() // one pixel of every 2x2\n"
    "{\n"
    "    ivec2 p = ivec2(gl_FragCoord.xy) - u_ssgi_target / 2;\n"
    "    vec2 xi = ssgi_noise(p);\n"
    "    p *= 2;\n" };

static const ssgi_gl__chunk ssgi_gl__main_ao = { __LINE__ + 1, 0,
    "    float z = ssgi_depth(p);\n"
    "    o_ssgi_ao = vec2(1.0, SSGI_FAR);\n"
    "    if (z < SSGI_FAR) {\n"
    "        vec3 P = ssgi_position(vec2(p) + 0.5, z);\n"
    "        o_ssgi_ao = vec2(clamp(1.0 - ssgi_occlusion(p, P, ssgi_normal(p, P), xi), 0.0, 1.0), z);\n"
    "    }\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__main_depth = { __LINE__ + 1, SSGI_GL__FIRST,
    "    float z = ssgi_depth(p);\n" };
static const ssgi_gl__chunk ssgi_gl__main_layer = { __LINE__ + 1, SSGI_GL__HIDDEN,
    "    float z = ssgi_layer(p, SSGI_RECEIVER);\n" };
static const ssgi_gl__chunk ssgi_gl__main_light = { __LINE__ + 1, SSGI_GL__E_LIT,
    "    o_ssgi_light = vec4(0.0, 0.0, 0.0, z);\n" };
static const ssgi_gl__chunk ssgi_gl__main_bounce = { __LINE__ + 1, SSGI_GL__SENDERS,
    "    o_ssgi_bounce = vec4(0.0, 0.0, 0.0, z);\n" };
static const ssgi_gl__chunk ssgi_gl__main_ssdo = { __LINE__ + 1, 0,
    "    if (z < SSGI_FAR) {\n"
    "        vec3 P = ssgi_position(vec2(p) + 0.5, z);\n"
    "        ssgi_gather(P, ssgi_normal(p, P), xi);\n"
    "    }\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__vectors_none = { __LINE__ + 1, SSGI_GL__LOBES | SSGI_GL__VECTORS,
    "ssgi_vectors ssgi_vectors_none()\n"
    "{\n"
    "    ssgi_vectors v;\n"
    "    for (int c = 0; c < v.c.length(); ++c) v.c[c] = ssgi_sh_zonal(vec4(0.0), vec3(0.0, 0.0, 1.0));\n"
    "    return v;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__main_s3ho = { __LINE__ + 1, 0,
    "    float z = ssgi_depth(p);\n"
    "    ssgi_vectors v = ssgi_vectors_none();\n"
    "    if (z < SSGI_FAR) {\n"
    "        vec3 P = ssgi_position(vec2(p) + 0.5, z);\n"
    "        ssgi_gather(P, ssgi_normal(p, P), xi, v);\n"
    "    }\n" };
static const ssgi_gl__chunk ssgi_gl__main_store = { __LINE__ + 1, SSGI_GL__STORES,
    "    ssgi_store(v);\n" };
static const ssgi_gl__chunk ssgi_gl__main_dot = { __LINE__ + 1, SSGI_GL__HARMONICS,
    "    o_ssgi_light = vec4(max(ssgi_irradiance(v), 0.0), z);\n" };

/* ==== >>light: environment, lights, senders ======================================================================== */

static const ssgi_gl__chunk ssgi_gl__environment = { __LINE__ + 1, SSGI_GL__E_MAP,
    "// radiance of the environment about a world-space direction\n"
    "vec3 ssgi_environment(vec3 d)\n"
    "{\n"
    "    ivec2 size = textureSize(t_ssgi_environment, 0);\n"
    "    return texelFetch(t_ssgi_environment, min(ivec2((ssgi_octahedral(d) * 0.5 + 0.5) * vec2(size)), size - 1), 0).xyz;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__open = { __LINE__ + 1, SSGI_GL__I_MAP,
    "vec3 ssgi_open_texel(ivec2 p, ivec2 last, int slice)\n"
    "{\n"
    "    if (p.x < 0 || p.x > last.x) p = ivec2(clamp(p.x, 0, last.x), last.y - p.y); // over an edge the square goes on mirrored\n"
    "    if (p.y < 0 || p.y > last.y) p = ivec2(last.x - p.x, clamp(p.y, 0, last.y));\n"
    "    return texelFetch(t_ssgi_irradiance, ivec3(p, slice), 0).xyz;\n"
    "}\n"
    "\n"
    "// irradiance over pi of an open surface with a world-space normal, or what a cone about it brings, between four texels\n"
    "vec3 ssgi_open(vec3 n, int slice)\n"
    "{\n"
    "    ivec2 last = textureSize(t_ssgi_irradiance, 0).xy - 1;\n"
    "    vec2 t = (ssgi_octahedral(n) * 0.5 + 0.5) * vec2(last + 1) - 0.5;\n"
    "    ivec2 p = ivec2(floor(t));\n"
    "    t -= vec2(p);\n"
    "    return mix(mix(ssgi_open_texel(p, last, slice), ssgi_open_texel(p + ivec2(1, 0), last, slice), t.x),\n"
    "               mix(ssgi_open_texel(p + ivec2(0, 1), last, slice), ssgi_open_texel(p + 1, last, slice), t.x), t.y);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__segment = { __LINE__ + 1, SSGI_GL__SEGMENTS,
    "// 1 where any point of a segment from the lifted receiver is blocked\n"
    "float ssgi_segment(vec3 start, vec3 along, float xi)\n"
    "{\n"
    "    for (int i = 0; i < SSGI_SAMPLES; ++i)\n"
    "        if (ssgi_blocked(start + along * ((float(i + 1) - xi) / float(SSGI_SAMPLES))) > 0.0) return 1.0;\n"
    "    return 0.0;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__shadow_map = { __LINE__ + 1, SSGI_GL__MAPS_READ,
    "// 1 where the map of light i shadows P. Its texels are taken to lie below the surface by the bias that keeps a plane from shadowing itself: half a\n"
    "// texel's diagonal times the plane's slope against the map; bias returns that along the ray to the light, -1 where no map sees P [SSDO09 section 5, corrected]\n"
    "float ssgi_shadow(int i, vec3 P, vec3 n, float d, float cosine, float patch_, out float bias)\n"
    "{\n"
    "    vec4 decode = texelFetch(t_ssgi_lights, ivec2(6, i), 0), tile = texelFetch(t_ssgi_lights, ivec2(7, i), 0), axis = texelFetch(t_ssgi_lights, ivec2(5, i), 0), Q = vec4(P, 1.0);\n"
    "    vec3 q = vec3(dot(texelFetch(t_ssgi_lights, ivec2(3, i), 0), Q), dot(texelFetch(t_ssgi_lights, ivec2(4, i), 0), Q), dot(axis, Q));\n"
    "    bool flat_ = decode.w > 0.0;\n"
    "    vec2 t = floor(flat_ ? q.xy : q.xy / q.z);\n"
    "    bias = -1.0;\n"
    "    if (q.z <= 0.0 || t.x < 0.0 || t.y < 0.0 || t.x >= tile.z || t.y >= tile.w) return 0.0;\n"
    "    float across = dot(n, axis.xyz), length_ = flat_ ? 1.0 : d / q.z; // of the ray, per depth\n"
    "    float size = flat_ ? patch_ : patch_ * q.z;\n"
    "    float b = size * 0.70710678 * min(sqrt(max(1.0 - across * across, 0.0)) / (cosine * length_), u_ssgi_steepest);\n"
    "    float s = texelFetch(t_ssgi_shadow, ivec2(tile.xy + t), 0).x, w = decode.x + decode.y * s;\n"
    "    float z = s == decode.z || w <= 1.0 / SSGI_FAR ? SSGI_FAR : flat_ ? w : 1.0 / w;\n"
    "    bias = b * length_;\n"
    "    float slack = 0.02 * size + 3e-7 * abs(decode.y) * (flat_ ? 1.0 : q.z * q.z) - 2e-5 * P.z; // and what depths of the map and of P are rounded by\n"
    "    return q.z - b - slack > z ? 1.0 : 0.0;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__lights_head = { __LINE__ + 1, SSGI_GL__FULL,
    "void main()\n"
    "{\n"
    "    ivec2 p = ivec2(gl_FragCoord.xy) - u_ssgi_target;\n" };
static const ssgi_gl__chunk ssgi_gl__lights_noise = { __LINE__ + 1, SSGI_GL__SEGMENTS,
    "    vec2 xi = ssgi_noise(p);\n" };
static const ssgi_gl__chunk ssgi_gl__lights_begin = { __LINE__ + 1, 0,
    "    o_ssgi_light = vec4(0.0, 0.0, 0.0, z);\n"
    "    if (z >= SSGI_FAR) return;\n"
    "    vec3 P = ssgi_position(vec2(p) + 0.5, z), n = ssgi_normal(p, P), sum = vec3(0.0);\n" };
static const ssgi_gl__chunk ssgi_gl__lights_lift = { __LINE__ + 1, SSGI_GL__SEGMENTS,
    "    vec3 start = ssgi_lift(P, n);\n" };
static const ssgi_gl__chunk ssgi_gl__lights_loop = { __LINE__ + 1, SSGI_GL__LIGHT_ROWS,
    "    for (int i = 0; i < u_ssgi_lights; ++i) {\n"
    "        vec4 at = texelFetch(t_ssgi_lights, ivec2(0, i), 0), colour = texelFetch(t_ssgi_lights, ivec2(1, i), 0), facing = texelFetch(t_ssgi_lights, ivec2(2, i), 0);\n"
    "        vec3 l = at.w > 0.5 ? at.xyz - P : at.xyz;\n"
    "        float dd = max(dot(l, l), 1e-30), d = sqrt(dd), g = 1.0;\n"
    "        l /= d;\n"
    "        if (at.w > 0.5) g /= max(dd, colour.w * colour.w);\n"
    "        if (at.w > 2.5) g *= max(-dot(facing.xyz, l), 0.0);\n" };
static const ssgi_gl__chunk ssgi_gl__lights_cosine = { __LINE__ + 1, SSGI_GL__LIGHT_ROWS,
    "        float cosine = dot(n, l);\n"
    "        g *= cosine;\n"
    "        if (cosine <= 0.0 || g <= 0.0) continue;\n" };
static const ssgi_gl__chunk ssgi_gl__lights_reach = { __LINE__ + 1, SSGI_GL__SEGMENTS,
    "        float reach = at.w > 0.5 ? min(u_ssgi_radius, d) : u_ssgi_radius;\n" };
static const ssgi_gl__chunk ssgi_gl__lights_map = { __LINE__ + 1, SSGI_GL__MAPS_READ,
    "        float bias;\n"
    "        if (ssgi_shadow(i, P, n, d, cosine, facing.w, bias) > 0.0 || (bias < 0.0 && at.w > 1.5 && at.w < 2.5)) continue;\n" };
static const ssgi_gl__chunk ssgi_gl__lights_fill = { __LINE__ + 1, SSGI_GL__MAPS_READ | SSGI_GL__SEGMENTS,
    "        if (bias >= 0.0) reach = min(reach, max(bias, 1.5 * ssgi_footprint(z))); // a segment shorter than a pixel finds nothing\n" };
static const ssgi_gl__chunk ssgi_gl__lights_limit = { __LINE__ + 1, SSGI_GL__REACH,
    "        ssgi_reach = reach;\n" };
static const ssgi_gl__chunk ssgi_gl__lights_segment = { __LINE__ + 1, SSGI_GL__SEGMENTS,
    "        g *= 1.0 - ssgi_segment(start, l * reach, fract(xi.y + 0.61803399 * float(i)));\n" };
static const ssgi_gl__chunk ssgi_gl__lights_tail = { __LINE__ + 1, SSGI_GL__LIGHT_ROWS,
    "        sum += colour.xyz * g;\n"
    "    }\n" };
static const ssgi_gl__chunk ssgi_gl__lights_write = { __LINE__ + 1, 0,
    "    o_ssgi_light.xyz = sum * 0.31830989;\n" };
static const ssgi_gl__chunk ssgi_gl__lights_add = { __LINE__ + 1, SSGI_GL__ADD,
    "    o_ssgi_light.xyz += texelFetch(t_ssgi_light, p + u_ssgi_target, 0).xyz;\n" };
static const ssgi_gl__chunk ssgi_gl__lights_end = { __LINE__ + 1, 0,
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__senders_head = { __LINE__ + 1, 0,
    "    o_ssgi_sender = uvec2(0u, 0xffffffffu);\n"
    "    if (z >= SSGI_FAR) return;\n"
    "    vec3 sum = vec3(0.0);\n" };
static const ssgi_gl__chunk ssgi_gl__senders_first = { __LINE__ + 1, SSGI_GL__ALBEDO | SSGI_GL__FIRST,
    "    sum += texelFetch(t_ssgi_albedo, p + u_ssgi_origin, 0).xyz;\n" };
static const ssgi_gl__chunk ssgi_gl__senders_hidden = { __LINE__ + 1, SSGI_GL__ALBEDO | SSGI_GL__HIDDEN,
    "    sum += texelFetch(t_ssgi_albedo, ivec3(p + u_ssgi_origin, SSGI_RECEIVER - 1), 0).xyz;\n" };
static const ssgi_gl__chunk ssgi_gl__senders_lit = { __LINE__ + 1, SSGI_GL__S_LIGHT,
    "    sum *= texelFetch(t_ssgi_light, p + u_ssgi_target, 0).xyz;\n" };
static const ssgi_gl__chunk ssgi_gl__senders_direct = { __LINE__ + 1, SSGI_GL__S_DIRECT,
    "    sum += texelFetch(t_ssgi_direct, p + u_ssgi_origin, 0).xyz;\n" };
static const ssgi_gl__chunk ssgi_gl__senders_tail = { __LINE__ + 1, 0,
    "    o_ssgi_sender = uvec2(ssgi_pack_radiance(sum), ssgi_pack_place(z, ssgi_normal(p, ssgi_position(vec2(p) + 0.5, z))));\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__bent = { __LINE__ + 1, SSGI_GL__CONES,
    "// The mean of the free directions, which is band 1, and the cosine of the half-angle of a cone about it that is spread as they are: of directions by the\n"
    "// cosine in a cone of cosine c the mean has the length 2/3 (1 + c + c^2) / (1 + c) [SSBN11, for directions by the cosine].\n"
    "vec4 ssgi_bent(ssgi_sh s)\n"
    "{\n"
    "    vec3 m = s.a.wyz * 0.65147002;\n"
    "    float l = length(m), q = clamp(3.0 * l / max(s.a.x * 1.12837917, 1e-6) - 2.0, 0.0, 1.0);\n"
    "    return vec4(l > 1e-6 ? m / l : vec3(0.0, 0.0, 1.0), 0.25 * (q + sqrt(q * q + 8.0 * q)));\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__shade_half = { __LINE__ + 1, SSGI_GL__HALF,
    "void main()\n"
    "{\n"
    "    ivec2 p = 2 * (ivec2(gl_FragCoord.xy) - u_ssgi_target / 2);\n" };
static const ssgi_gl__chunk ssgi_gl__shade_bent = { __LINE__ + 1, SSGI_GL__BENT_OUT,
    "    o_ssgi_bent = z < SSGI_FAR ? ssgi_bent(ssgi_load(ivec2(gl_FragCoord.xy)).c[0]) : vec4(0.0);\n" };
static const ssgi_gl__chunk ssgi_gl__shade_head = { __LINE__ + 1, SSGI_GL__SHADED,
    "    o_ssgi_light = vec4(0.0, 0.0, 0.0, z);\n"
    "    if (z >= SSGI_FAR) return;\n"
    "    ssgi_vectors v = ssgi_load(ivec2(gl_FragCoord.xy));\n" };
static const ssgi_gl__chunk ssgi_gl__shade_normal_read = { __LINE__ + 1, SSGI_GL__EXACT_SHADE,
    "    vec3 n = ssgi_normal(p, ssgi_position(vec2(p) + 0.5, z));\n" };
static const ssgi_gl__chunk ssgi_gl__shade_harmonics = { __LINE__ + 1, SSGI_GL__HARMONICS,
    "    vec3 sum = ssgi_irradiance(v);\n" };
static const ssgi_gl__chunk ssgi_gl__shade_cones = { __LINE__ + 1, SSGI_GL__BENT_LIT,
    "    vec4 bent = ssgi_bent(v.c[0]);\n"
    "    vec3 axis = transpose(u_ssgi_rotation) * bent.xyz, sum = vec3(clamp(v.c[0].a.x * 1.12837917, 0.0, 1.0));\n" };
static const ssgi_gl__chunk ssgi_gl__shade_normal = { __LINE__ + 1, SSGI_GL__BENT_NORMAL,
    "    sum *= ssgi_open(axis, 0);\n" };
static const ssgi_gl__chunk ssgi_gl__shade_cone = { __LINE__ + 1, SSGI_GL__BENT_CONE,
    "    int last = textureSize(t_ssgi_irradiance, 0).z - 1;\n"
    "    float slice = min(bent.w * float(last + 1), float(last));\n"
    "    sum *= mix(ssgi_open(axis, int(slice)), ssgi_open(axis, min(int(slice) + 1, last)), fract(slice));\n" };
static const ssgi_gl__chunk ssgi_gl__shade_point = { __LINE__ + 1, SSGI_GL__LAMPS,
    "    vec3 P = ssgi_position(vec2(p) + 0.5, z);\n" };
static const ssgi_gl__chunk ssgi_gl__shade_lamp = { __LINE__ + 1, SSGI_GL__LAMPS,
    "        // a cap of the sky as wide as the sphere, windowed, and such that it lights what faces it openly by what it sends [S3HO12 2.2, normalised]\n"
    "        float c = at.w > 0.5 ? sqrt(max(1.0 - colour.w * colour.w / dd, 0.0)) : 1.0;\n"
    "        vec4 w = u_ssgi_window * vec4(1.0, 0.5 + 0.5 * c, 0.5 * c * (1.0 + c), 0.125 * (1.0 + c) * (5.0 * c * c - 1.0));\n"
    "        float open = 0.25 * w.x;\n" };
static const ssgi_gl__chunk ssgi_gl__shade_lamp2 = { __LINE__ + 1, SSGI_GL__LAMPS | SSGI_GL__V2,
    "        open += 0.5 * w.y;\n" };
static const ssgi_gl__chunk ssgi_gl__shade_lamp3 = { __LINE__ + 1, SSGI_GL__LAMPS | SSGI_GL__V3,
    "        open += 0.3125 * w.z;\n" };
static const ssgi_gl__chunk ssgi_gl__shade_lamp_end = { __LINE__ + 1, SSGI_GL__LAMPS,
    "        ssgi_sh y = ssgi_sh_zonal(w * vec4(0.28209479, 0.48860251, 0.63078313, 0.74635267), l);\n"
    "        vec3 e = vec3(ssgi_sh_dot(y, v.c[0]), ssgi_sh_dot(y, v.c[1 % v.c.length()]), ssgi_sh_dot(y, v.c[2 % v.c.length()])) / open;\n" };
static const ssgi_gl__chunk ssgi_gl__shade_lamp_exact = { __LINE__ + 1, SSGI_GL__EXACT_LAMPS,
    "        e += ssgi_free(v) * (max(dot(n, l), 0.0) - ssgi_sh_dot(y, ssgi_sh_zonal(SSGI_COSINE, n)) / open);\n" };
static const ssgi_gl__chunk ssgi_gl__shade_lamp_add = { __LINE__ + 1, SSGI_GL__LAMPS,
    "        sum += colour.xyz * e * (0.31830989 * g);\n"
    "    }\n" };
static const ssgi_gl__chunk ssgi_gl__shade_tail = { __LINE__ + 1, SSGI_GL__SHADED,
    "    o_ssgi_light.xyz = max(sum, 0.0);\n" };
static const ssgi_gl__chunk ssgi_gl__shade_albedo = { __LINE__ + 1, SSGI_GL__ALBEDO,
    "    o_ssgi_light.xyz *= texelFetch(t_ssgi_albedo, p + u_ssgi_origin, 0).xyz;\n" };

/* ==== >>field: casters whose occlusion was baked ================================================================= */

static const ssgi_gl__chunk ssgi_gl__sphere_perspective = { __LINE__ + 1, SSGI_GL__PERSPECTIVE,
    "// pixels that a sphere spans deeper than the front: slopes of its tangents in the planes of x and of y, or where it meets the front; empty behind it\n"
    "vec4 ssgi_sphere(vec4 at)\n"
    "{\n"
    "    float near = u_ssgi_front, z = -at.z, r = at.w, chord = sqrt(max(r * r - (near - z) * (near - z), 0.0));\n"
    "    if (z + r <= near) return vec4(0.0);\n"
    "    vec2 x = at.xy, cc = x * x + z * z, off = cc - r * r, t = sqrt(max(off, 0.0)), a = z * t + x * r, b = z * t - x * r;\n"
    "    vec2 from = (x - chord) / near, to = (x + chord) / near;\n"
    "    if (off.x > 0.0 && a.x * t.x > near * cc.x) from.x = (x.x * t.x - z * r) / a.x;\n"
    "    if (off.y > 0.0 && a.y * t.y > near * cc.y) from.y = (x.y * t.y - z * r) / a.y;\n"
    "    if (off.x > 0.0 && b.x * t.x > near * cc.x) to.x = (x.x * t.x + z * r) / b.x;\n"
    "    if (off.y > 0.0 && b.y * t.y > near * cc.y) to.y = (x.y * t.y + z * r) / b.y;\n"
    "    vec4 p = vec4(from, to) * u_ssgi_project.xyxy + u_ssgi_project.zwzw;\n"
    "    return vec4(min(p.xy, p.zw), max(p.xy, p.zw));\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__sphere_orthographic = { __LINE__ + 1, SSGI_GL__ORTHOGRAPHIC,
    "// pixels that a sphere spans deeper than the front\n"
    "vec4 ssgi_sphere(vec4 at)\n"
    "{\n"
    "    if (at.w - at.z <= u_ssgi_front) return vec4(0.0);\n"
    "    float off = max(u_ssgi_front + at.z, 0.0), r = sqrt(max(at.w * at.w - off * off, 0.0));\n"
    "    vec4 t = vec4(at.xy - r, at.xy + r) * u_ssgi_project.xyxy + u_ssgi_project.zwzw;\n"
    "    return vec4(min(t.xy, t.zw), max(t.xy, t.zw));\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__caster_main = { __LINE__ + 1, 0,
    "flat out vec4 v_ssgi_caster[9]; // ssgi_gl_caster from to_field on\n"
    "void main()\n"
    "{\n"
    "    vec4 bounds = ssgi_sphere(texelFetch(t_ssgi_casters, ivec2(0, gl_InstanceID), 0)); // that it reaches\n"
    "    for (int i = 0; i < 9; ++i) v_ssgi_caster[i] = texelFetch(t_ssgi_casters, ivec2(i + 1, gl_InstanceID), 0);\n"
    "    int corner = gl_VertexID < 3 ? gl_VertexID : 6 - gl_VertexID;\n"
    "    vec2 pixel = vec2((corner & 1) == 1 ? bounds.z : bounds.x, corner > 1 ? bounds.w : bounds.y);\n"
    "    gl_Position = vec4(pixel / vec2(u_ssgi_size) * 2.0 - 1.0, 0.0, 1.0);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__field_texel16 = { __LINE__ + 1, SSGI_GL__ATLAS | SSGI_GL__BITS16,
    "const float SSGI_FIELD_UNIT = 1.0 / 65535.0;\n"
    "void ssgi_field_texel(ivec3 p, float weight, inout vec4 a, inout vec4 b)\n"
    "{\n"
    "    uvec4 v = texelFetch(t_ssgi_fields, p, 0);\n"
    "    a += weight * vec4(v.x & 65535u, v.x >> 16, v.y & 65535u, v.y >> 16);\n"
    "    b += weight * vec4(v.z & 65535u, v.z >> 16, v.w & 65535u, v.w >> 16);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__field_texel8 = { __LINE__ + 1, SSGI_GL__ATLAS | SSGI_GL__BITS8,
    "const float SSGI_FIELD_UNIT = 1.0 / 255.0;\n"
    "void ssgi_field_texel(ivec3 p, float weight, inout vec4 a, inout vec4 b)\n"
    "{\n"
    "    uvec2 v = texelFetch(t_ssgi_fields, p, 0).xy;\n"
    "    a += weight * vec4(v.x & 255u, v.x >> 8 & 255u, v.x >> 16 & 255u, v.x >> 24);\n"
    "    b += weight * vec4(v.y & 255u, v.y >> 8 & 255u, v.y >> 16 & 255u, v.y >> 24);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__field_atlas = { __LINE__ + 1, SSGI_GL__ATLAS,
    "// the eight components along w in [0,1]: bilinear within a face and its border; at: resolution, slice\n"
    "void ssgi_field_fetch(vec3 w, vec2 at, out vec4 a, out vec4 b)\n"
    "{\n"
    "    vec3 m = abs(w);\n"
    "    float face = 4.0, back = w.z;\n"
    "    vec2 s = vec2(w.z < 0.0 ? -w.x : w.x, -w.y) / m.z;\n"
    "    if (m.x >= m.y && m.x >= m.z) {\n"
    "        face = 0.0;\n"
    "        back = w.x;\n"
    "        s = vec2(w.x < 0.0 ? w.z : -w.z, -w.y) / m.x;\n"
    "    } else if (m.y >= m.z) {\n"
    "        face = 2.0;\n"
    "        back = w.y;\n"
    "        s = vec2(w.x, w.y < 0.0 ? -w.z : w.z) / m.y;\n"
    "    }\n"
    "    if (back < 0.0) face += 1.0;\n"
    "    s = (s * 0.5 + 0.5) * at.x + 0.5;\n"
    "    vec2 f = clamp(floor(s), 0.0, at.x);\n"
    "    ivec3 p = ivec3(f.x, f.y + face * (at.x + 2.0), at.y);\n"
    "    f = s - f;\n"
    "    a = vec4(0.0);\n"
    "    b = vec4(0.0);\n"
    "    ssgi_field_texel(p, (1.0 - f.x) * (1.0 - f.y), a, b);\n"
    "    ssgi_field_texel(p + ivec3(1, 0, 0), f.x * (1.0 - f.y), a, b);\n"
    "    ssgi_field_texel(p + ivec3(0, 1, 0), (1.0 - f.x) * f.y, a, b);\n"
    "    ssgi_field_texel(p + ivec3(1, 1, 0), f.x * f.y, a, b);\n"
    "    a *= SSGI_FIELD_UNIT;\n"
    "    b *= SSGI_FIELD_UNIT;\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__field_cubes = { __LINE__ + 1, SSGI_GL__CUBES,
    "void ssgi_field_fetch(vec3 w, vec2 at, out vec4 a, out vec4 b)\n"
    "{\n"
    "    a = textureLod(t_ssgi_field, w, 0.0);\n"
    "    b = textureLod(t_ssgi_field_centre, w, 0.0);\n"
    "}\n" };

/* k: the cosine of the cap's radius, S its squared sine */
static const ssgi_gl__chunk ssgi_gl__cap_closed = { __LINE__ + 1, SSGI_GL__CAP_CLOSED,
    "// cosine-weighted occlusion of a spherical cap: k, S: cosine of its radius, squared sine, at most half of the sphere; c: cosine between its axis and the normal\n"
    "float ssgi_cap(float k, float S, float c)\n"
    "{\n"
    "    if (c * c >= S) return S * max(c, 0.0);\n"
    "    float x = k * inversesqrt(S), w = sqrt(max(1.0 - c * c / S, 0.0));\n"
    "    return ((c * atan(w, -x * c) - x * w) * S + atan(w, x)) * 0.318309886;\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__cap_whole = { __LINE__ + 1, SSGI_GL__CAP_CLOSED | SSGI_GL__ANGLE_KEPT,
    "// h: solid angle / 2 pi, in [0,2]; what a large cap leaves over is a cap, too\n"
    "float ssgi_cap_any(float h, float c)\n"
    "{\n"
    "    float a = ssgi_cap(abs(1.0 - h), h * (2.0 - h), h > 1.0 ? -c : c);\n"
    "    return h > 1.0 ? 1.0 - a : a;\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__cap_table = { __LINE__ + 1, SSGI_GL__CAP_TABLE,
    "// the same from a table: h: solid angle / 2 pi; coordinates hit texel centres\n"
    "float ssgi_cap_any(float h, float c)\n"
    "{\n"
    "    float n = float(textureSize(t_ssgi_cap, 0).x);\n"
    "    return textureLod(t_ssgi_cap, (vec2(h, c + 1.0) * (0.5 * n - 0.5) + 0.5) / n, 0.0).x;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__field_at = { __LINE__ + 1, 0,
    "// where a point is about the caster: direction from the centre, distance; caster: ssgi_gl_caster from to_field on\n"
    "vec4 ssgi_field_at(vec4 caster[9], vec3 P)\n"
    "{\n"
    "    vec3 w = vec3(dot(caster[0], vec4(P, 1.0)), dot(caster[1], vec4(P, 1.0)), dot(caster[2], vec4(P, 1.0)));\n"
    "    float r = length(w);\n"
    "    return r > 0.0 ? vec4(w / r, r) : vec4(0.0, 0.0, 1.0, 0.0);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__field_head = { __LINE__ + 1, 0,
    "// occlusion by a caster, in [0,1]; n: unit normal\n"
    "float ssgi_field_occlusion(vec4 caster[9], vec4 at, vec3 n)\n"
    "{\n"
    "    vec4 a, b;\n"
    "    ssgi_field_fetch(at.xyz, caster[8].xy, a, b);\n"
    "    a = caster[4] + caster[6] * a;\n"
    "    b = caster[5] + caster[7] * b;\n"
    "    float hull = a.w, r = max(at.w, hull), t = min((r - hull) / (caster[8].z - hull), 1.0);\n"
    "    a.xyz = exp2(a.xyz);\n"
    "    a.y -= sqrt(a.x * a.z); // 1/(a quadratic in r) by its Bernstein form from the hull to the end\n"
    "    float q = mix(mix(a.x, a.y, t), mix(a.y, a.z, t), t);\n"
    "    vec3 axis = b.xyz - r * at.xyz;\n"
    "    axis = dot(axis, axis) > 0.0 ? normalize(axis) : -at.xyz;\n"
    "    float c = dot(axis, normalize(vec3(dot(caster[0].xyz, n), dot(caster[1].xyz, n), dot(caster[2].xyz, n))));\n" };
static const ssgi_gl__chunk ssgi_gl__field_vector = { __LINE__ + 1, SSGI_GL__VECTOR_KEPT,
    "    // the cap of this vector irradiance, and the share of it that is covered\n"
    "    float S = 0.318309886 / max(q, 0.318309886), fill = max(b.w, S);\n"
    "    S /= fill;\n" };
static const ssgi_gl__chunk ssgi_gl__field_vector_closed = { __LINE__ + 1, SSGI_GL__VECTOR_KEPT | SSGI_GL__CAP_CLOSED,
    "    float A = fill * ssgi_cap(sqrt(max(1.0 - S, 0.0)), S, c);\n" };
static const ssgi_gl__chunk ssgi_gl__field_vector_table = { __LINE__ + 1, SSGI_GL__VECTOR_KEPT | SSGI_GL__CAP_TABLE,
    "    float A = fill * ssgi_cap_any(S / (1.0 + sqrt(max(1.0 - S, 0.0))), c);\n" };
static const ssgi_gl__chunk ssgi_gl__field_angle = { __LINE__ + 1, SSGI_GL__ANGLE_KEPT,
    "    float A = ssgi_cap_any(0.159154943 / max(q, 0.0795774715), c);\n" };
static const ssgi_gl__chunk ssgi_gl__field_tail = { __LINE__ + 1, 0,
    "    if (at.w < hull) A = mix(caster[3].z, A, pow(at.w / hull, caster[3].w));\n"
    "    return clamp(A, 0.0, 1.0) * (1.0 - smoothstep(caster[3].x, caster[3].y, at.w));\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__field_all = { __LINE__ + 1, 0,
    "// what casters 0 .. casters - 1 leave of the ambient light, but those of the object itself\n"
    "float ssgi_field_visibility(int casters, int object, vec3 P, vec3 n)\n"
    "{\n"
    "    float visibility = 1.0;\n"
    "    for (int i = 0; i < casters; ++i) {\n"
    "        vec4 sphere = texelFetch(t_ssgi_casters, ivec2(0, i), 0), caster[9];\n"
    "        if (!(distance(P, sphere.xyz) < sphere.w)) continue;\n"
    "        for (int k = 0; k < 9; ++k) caster[k] = texelFetch(t_ssgi_casters, ivec2(k + 1, i), 0);\n"
    "        if (object == 0 || object != int(caster[8].w)) visibility *= 1.0 - ssgi_field_occlusion(caster, ssgi_field_at(caster, P), n);\n"
    "    }\n"
    "    return visibility;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__field_in = { __LINE__ + 1, 0,
    "flat in vec4 v_ssgi_caster[9];\n" };
static const ssgi_gl__chunk ssgi_gl__object_texture = { __LINE__ + 1, SSGI_GL__O_TEXTURE,
    "uint ssgi_object(ivec2 p)\n"
    "{\n"
    "    return texelFetch(t_ssgi_objects, p + u_ssgi_origin, 0).x;\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__object_custom = { __LINE__ + 1, SSGI_GL__O_CUSTOM,
    "uint ssgi_object(ivec2 p)\n"
    "{\n"
    "    return ssgi_custom_object(p + u_ssgi_origin);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__field_main = { __LINE__ + 1, 0,
    "    vec3 P = ssgi_position(vec2(p) + 0.5, z);\n"
    "    vec4 at = ssgi_field_at(v_ssgi_caster, P);\n"
    "    if (!(z < SSGI_FAR && at.w < v_ssgi_caster[3].y)) discard;\n" };
static const ssgi_gl__chunk ssgi_gl__field_own = { __LINE__ + 1, SSGI_GL__OBJECTS,
    "    uint object = ssgi_object(p);\n"
    "    if (object != 0u && object == uint(v_ssgi_caster[8].w)) discard; // its own surface\n" };
static const ssgi_gl__chunk ssgi_gl__field_end = { __LINE__ + 1, 0,
    "    o_ssgi_ao = 1.0 - ssgi_field_occlusion(v_ssgi_caster, at, ssgi_normal(p, P));\n" };

/* ==== >>splat: surfels, and what they do to pixels ================================================================= */

/* Twins of >>surfels in ssgi.h. */
static const ssgi_gl__chunk ssgi_gl__patch_vertex = { __LINE__ + 1, SSGI_GL__TESSELLATED,
    "out vec3 v_ssgi_position, v_ssgi_normal, v_ssgi_colour;\n"
    "out vec2 v_ssgi_part; // of splits * splits; which vertex\n"
    "void main()\n"
    "{\n"
    "    mat3 m = mat3(u_ssgi_mesh);\n"
    "    vec3 x = cross(m[1], m[2]);\n"
    "    v_ssgi_position = (u_ssgi_mesh * vec4(a_ssgi_position, 1.0)).xyz;\n"
    "    v_ssgi_normal = mat3(x, cross(m[2], m[0]), cross(m[0], m[1])) * a_ssgi_normal * sign(dot(x, m[0]));\n"
    "    v_ssgi_colour = a_ssgi_colour;\n"
    "    v_ssgi_part = vec2(gl_InstanceID, gl_VertexID & 16777215);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__patch_hash = { __LINE__ + 1, SSGI_GL__TESSELLATED,
    "uint ssgi_hash(uint x)\n"
    "{\n"
    "    x = x * 747796405u + 2891336453u;\n"
    "    x = ((x >> ((x >> 28) + 4u)) ^ x) * 277803737u;\n"
    "    return (x >> 22) ^ x;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__patch_levels = { __LINE__ + 1, SSGI_GL__TESSELLATED,
    "layout(vertices = 3) out;\n"
    "in vec3 v_ssgi_position[], v_ssgi_normal[], v_ssgi_colour[];\n"
    "in vec2 v_ssgi_part[];\n"
    "out vec3 v_ssgi_corner[], v_ssgi_facing[], v_ssgi_tint[];\n"
    "patch out vec4 v_ssgi_patch; // radius, level, key in two halves\n"
    "\n"
    "// integers are wanted exactly\n"
    "int ssgi_tess_count(int level)\n"
    "{\n"
    "    int half_ = (level + 1) / 2;\n"
    "    return 3 * half_ * half_ + (level % 2 == 0 ? 3 * half_ + 1 : 0);\n"
    "}\n"
    "\n"
    "// weights of corner c of part i of n * n\n"
    "vec3 ssgi_part(int i, int n, int c)\n"
    "{\n"
    "    int row = int(sqrt(float(i) + 0.5)), place = i - row * row, odd = place & 1;\n"
    "    int down = row + (odd == 1 ? (c == 1 ? 1 : 0) : (c > 0 ? 1 : 0)), across = place / 2 + (odd == 1 ? (c > 0 ? 1 : 0) : (c > 1 ? 1 : 0));\n"
    "    return vec3(n - down, down - across, across) / float(n);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__patch_radius_perspective = { __LINE__ + 1, SSGI_GL__TESSELLATED | SSGI_GL__PERSPECTIVE,
    "float ssgi_surfel_radius(float depth)\n"
    "{\n"
    "    return u_ssgi_surfel.x * (abs(depth - u_ssgi_surfel.y) + u_ssgi_surfel.y);\n"
    "}\n"
    "\n"
    "// how far outside of the frustum\n"
    "float ssgi_aside(vec3 P)\n"
    "{\n"
    "    vec2 a = u_ssgi_unproject.zw, b = u_ssgi_unproject.xy * vec2(u_ssgi_size) + a, low = min(a, b), high = max(a, b);\n"
    "    vec2 d = max((low * -P.z - P.xy) * inversesqrt(1.0 + low * low), (P.xy + high * P.z) * inversesqrt(1.0 + high * high));\n"
    "    return max(max(d.x, d.y), max(u_ssgi_surfel.y + P.z, 0.0));\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__patch_radius_orthographic = { __LINE__ + 1, SSGI_GL__TESSELLATED | SSGI_GL__ORTHOGRAPHIC,
    "float ssgi_surfel_radius(float depth)\n"
    "{\n"
    "    return u_ssgi_surfel.x;\n"
    "}\n"
    "\n"
    "// how far outside of what is seen\n"
    "float ssgi_aside(vec3 P)\n"
    "{\n"
    "    vec2 a = u_ssgi_unproject.zw, b = u_ssgi_unproject.xy * vec2(u_ssgi_size) + a, d = max(min(a, b) - P.xy, P.xy - max(a, b));\n"
    "    return max(max(d.x, d.y), max(u_ssgi_surfel.y + P.z, 0.0));\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__patch_control = { __LINE__ + 1, SSGI_GL__TESSELLATED,
    "void main()\n"
    "{\n"
    "    vec3 z = -vec3(v_ssgi_position[0].z, v_ssgi_position[1].z, v_ssgi_position[2].z), at[3], edge;\n"
    "    float whole = 0.5 * length(cross(v_ssgi_position[1] - v_ssgi_position[0], v_ssgi_position[2] - v_ssgi_position[0]));\n"
    "    float low = min(z.x, min(z.y, z.z)), high = max(z.x, max(z.y, z.z)), nearest = low > 0.0 ? low : high < 0.0 ? high : 0.0;\n"
    "    if (nearest >= 0.0) nearest = max(nearest, u_ssgi_surfel.y);\n"
    "    float r = ssgi_surfel_radius(nearest);\n"
    "    int n = int(clamp(ceil(sqrt(whole / (3.14159265 * 3169.0 * r * r)) - 1e-5), 1.0, u_ssgi_surfel.w)), part = int(v_ssgi_part[0].x + 0.5);\n"
    "    bool empty = part >= n * n || !(whole > 0.0 && whole < SSGI_FAR);\n"
    "    part = min(part, n * n - 1);\n"
    "    for (int c = 0; c < 3; ++c) {\n"
    "        vec3 w = ssgi_part(part, n, c);\n"
    "        at[c] = v_ssgi_position[0] * w.x + v_ssgi_position[1] * w.y + v_ssgi_position[2] * w.z;\n"
    "    }\n"
    "    vec3 middle = (at[0] + at[1] + at[2]) / 3.0;\n"
    "    float area = whole / float(n * n), aside = ssgi_aside(middle);\n"
    "    empty = empty || aside - max(distance(at[0], middle), max(distance(at[1], middle), distance(at[2], middle))) > u_ssgi_radius;\n"
    "    r = ssgi_surfel_radius(-middle.z) + u_ssgi_more.x * aside;\n"
    "    uint a = uint(v_ssgi_part[0].y), b = uint(v_ssgi_part[1].y), c = uint(v_ssgi_part[2].y);\n"
    "    uint key = a + (b - a) * 2654435769u + (c - a) * 3266489909u + uint(part) * 2246822507u;\n"
    "    float discs = area / (3.14159265 * r * r), share = u_ssgi_more.y > 0.0 ? 1.0 : min(discs / 3.0, 1.0);\n"
    "    int alive = 0; // of a small triangle's three points: others stand for the rest\n"
    "    for (int i = 0; i < 3; ++i) if (float(((key + uint(i)) * 2654435769u) >> 8) / 16777216.0 < share) alive |= 1 << i;\n"
    "    empty = empty || alive == 0;\n"
    "    int level = discs > 3.0 ? int(min(ceil(sqrt((4.0 * discs - 1.0) / 3.0) - 1.0 - 1e-5), 64.0)) : 1;\n"
    "    r = sqrt(area / (3.14159265 * share * float(ssgi_tess_count(level)))); // together they have the area\n"
    "    edge = vec3(length(at[2] - at[1]), length(at[0] - at[2]), length(at[1] - at[0]));\n"
    "    float perimeter = edge.x + edge.y + edge.z, inset = max(1.0 - r * perimeter / (2.0 * area), 0.25);\n"
    "    vec3 centre = (edge.x * at[0] + edge.y * at[1] + edge.z * at[2]) / perimeter, w = ssgi_part(part, n, gl_InvocationID); // of the inscribed circle: discs end at the edges\n"
    "    v_ssgi_corner[gl_InvocationID] = centre + inset * (at[gl_InvocationID] - centre);\n"
    "    v_ssgi_facing[gl_InvocationID] = v_ssgi_normal[0] * w.x + v_ssgi_normal[1] * w.y + v_ssgi_normal[2] * w.z;\n"
    "    v_ssgi_tint[gl_InvocationID] = v_ssgi_colour[0] * w.x + v_ssgi_colour[1] * w.y + v_ssgi_colour[2] * w.z;\n"
    "    v_ssgi_patch = vec4(r, level, (key >> 16) + uint(alive) * 65536u, key & 65535u);\n"
    "    float all = empty ? 0.0 : float(level);\n"
    "    gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = gl_TessLevelOuter[2] = gl_TessLevelInner[0] = all;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__surfel_lit = { __LINE__ + 1, SSGI_GL__S_LIT,
    "// irradiance over pi\n"
    "vec3 ssgi_surfel_light(vec3 P, vec3 n)\n"
    "{\n"
    "    vec3 sum = vec3(0.0);\n" };
static const ssgi_gl__chunk ssgi_gl__surfel_lit_open = { __LINE__ + 1, SSGI_GL__I_MAP,
    "    sum += ssgi_open(transpose(u_ssgi_rotation) * n, 0) * 3.14159265; // as if nothing stood before it\n" };
static const ssgi_gl__chunk ssgi_gl__surfel_lit_end = { __LINE__ + 1, SSGI_GL__S_LIT,
    "    return sum * 0.31830989;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__patch_points = { __LINE__ + 1, SSGI_GL__TESSELLATED,
    "layout(triangles, equal_spacing, ccw, point_mode) in;\n"
    "in vec3 v_ssgi_corner[], v_ssgi_facing[], v_ssgi_tint[];\n"
    "patch in vec4 v_ssgi_patch;\n"
    "void main()\n"
    "{\n"
    "    vec3 w = gl_TessCoord, P = v_ssgi_corner[0] * w.x + v_ssgi_corner[1] * w.y + v_ssgi_corner[2] * w.z;\n"
    "    vec3 u = v_ssgi_corner[1] - v_ssgi_corner[0], v = v_ssgi_corner[2] - v_ssgi_corner[0], n = v_ssgi_facing[0] * w.x + v_ssgi_facing[1] * w.y + v_ssgi_facing[2] * w.z;\n"
    "    vec3 flat_ = normalize(cross(u, v)), colour = v_ssgi_tint[0] * w.x + v_ssgi_tint[1] * w.y + v_ssgi_tint[2] * w.z;\n"
    "    n = dot(n, n) > 0.0 ? normalize(n) : flat_ * sign(determinant(mat3(u_ssgi_mesh)));\n"
    "    // which point of the tessellator's rings this is: the same number on every machine\n"
    "    float ring = floor(min(w.x, min(w.y, w.z)) * 1.5 * v_ssgi_patch.y + 0.5);\n"
    "    uvec3 place = uvec3(max(w * v_ssgi_patch.y - ring / 1.5 + 0.5, 0.0));\n"
    "    uint h = ssgi_hash(ssgi_hash((uint(v_ssgi_patch.z) << 16) | uint(v_ssgi_patch.w)) + (place.x | (place.y << 7) | (uint(ring) << 14))), h2 = ssgi_hash(h);\n"
    "    u = normalize(u);\n"
    "    float away = (1.0 - u_ssgi_surfel.z) * v_ssgi_patch.x * sqrt(float(h2 >> 16) / 65536.0), angle = 6.28318531 * float(h2 & 65535u) / 65536.0;\n"
    "    P += away * (cos(angle) * u + sin(angle) * cross(flat_, u));\n" };
static const ssgi_gl__chunk ssgi_gl__buffer_points = { __LINE__ + 1, SSGI_GL__BUFFERED,
    "void main()\n"
    "{\n"
    "    vec3 P = a_ssgi_surfel0.xyz, n = a_ssgi_surfel1.xyz, colour = a_ssgi_surfel2.xyz;\n" };
static const ssgi_gl__chunk ssgi_gl__points_sent_lit = { __LINE__ + 1, SSGI_GL__S_LIT,
    "    colour *= ssgi_surfel_light(P, n);\n" };
static const ssgi_gl__chunk ssgi_gl__points_sent_custom = { __LINE__ + 1, SSGI_GL__S_CUSTOM,
    "    colour = ssgi_custom_surfel(P, n, colour);\n" };
static const ssgi_gl__chunk ssgi_gl__nothing = { __LINE__ + 1, 0,
    "// nothing is drawn; GLES wants the stage\n"
    "void main()\n"
    "{\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__patch_kept = { __LINE__ + 1, SSGI_GL__TESSELLATED,
    "    v_ssgi_surfel0 = vec4(P, v_ssgi_patch.y > 1.0 || (uint(v_ssgi_patch.z) >> (16u + place.y + 2u * place.z) & 1u) > 0u ? v_ssgi_patch.x : 0.0); // radius 0 reaches nothing\n"
    "    v_ssgi_surfel1 = vec4(n, float(h >> 8) / 16777216.0);\n"
    "    v_ssgi_surfel2 = vec4(colour, 0.0);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__buffer_kept = { __LINE__ + 1, SSGI_GL__BUFFERED,
    "    v_ssgi_surfel0 = a_ssgi_surfel0;\n"
    "    v_ssgi_surfel1 = a_ssgi_surfel1;\n"
    "    v_ssgi_surfel2 = vec4(colour, 0.0);\n"
    "}\n" };

/* Level l deals the pixels of each block of 2^l x 2^l out to as many sub-buffers, which lie side by side. */
static const ssgi_gl__chunk ssgi_gl__deal_random = { __LINE__ + 1, SSGI_GL__RANDOM,
    "// which pixel of a block is dealt where: an exclusive or is its own inverse\n"
    "ivec2 ssgi_deal(ivec2 block, int mask)\n"
    "{\n"
    "    uint h = uint(block.x) * 747796405u + uint(block.y) * 2891336453u + uint(mask);\n"
    "    h = ((h >> ((h >> 28) + 4u)) ^ h) * 277803737u;\n"
    "    h ^= h >> 22;\n"
    "    return ivec2(int(h & 255u), int((h >> 8) & 255u)) & mask;\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__deal_fixed = { __LINE__ + 1, SSGI_GL__REGULAR,
    "ivec2 ssgi_deal(ivec2 block, int mask)\n"
    "{\n"
    "    return ivec2(0);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__shuffle_main = { __LINE__ + 1, 0,
    "void main()\n"
    "{\n"
    "    ivec2 q = ivec2(gl_FragCoord.xy);\n"
    "    int l = q.y / u_ssgi_level.y, mask = (1 << l) - 1;\n"
    "    q.y -= l * u_ssgi_level.y;\n"
    "    ivec2 across = (u_ssgi_size + mask) >> l, sub = q / across, block = q - sub * across, p = (block << l) | ((sub ^ ssgi_deal(block, mask)) & mask);\n"
    "    o_ssgi_shuffled = uvec4(floatBitsToUint(vec3(SSGI_FAR)), 0u);\n"
    "    if (max(sub.x, sub.y) > mask || !ssgi_inside(p)) return; // sizes need not be multiples\n"
    "    float z = ssgi_depth(p);\n"
    "    if (z >= SSGI_FAR) return;\n"
    "    vec3 P = ssgi_position(vec2(p) + 0.5, z);\n"
    "    ivec2 e = ivec2(round(ssgi_octahedral(ssgi_normal(p, P)) * 32767.0));\n"
    "    o_ssgi_shuffled = uvec4(floatBitsToUint(P), (uint(e.x + 32768) << 16) | uint(e.y + 32768));\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__unshuffle_main = { __LINE__ + 1, 0,
    "void main()\n"
    "{\n"
    "    ivec2 q = ivec2(gl_FragCoord.xy);\n"
    "    int l = q.y / u_ssgi_level.y, mask = (1 << l) - 1;\n"
    "    ivec2 p = ivec2(q.x, q.y - l * u_ssgi_level.y), block = p >> l, across = (u_ssgi_size + mask) >> l, sub = (p & mask) ^ ssgi_deal(block, mask);\n"
    "    if (p.x >= u_ssgi_size.x || p.y >= u_ssgi_size.y) discard;\n"
    "    ivec2 at = sub * across + block + ivec2(0, l * u_ssgi_level.y);\n" };
static const ssgi_gl__chunk ssgi_gl__unshuffle_grey = { __LINE__ + 1, SSGI_GL__GREY,
    "    o_ssgi_levels = texelFetch(t_ssgi_levels, at, 0).x;\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__unshuffle_colour = { __LINE__ + 1, SSGI_GL__COLOUR,
    "    o_ssgi_levels = texelFetch(t_ssgi_levels, at, 0);\n"
    "}\n" };

/* What of a surfel is drawn at a level: a rectangle of one sub-buffer. */
static const ssgi_gl__chunk ssgi_gl__shell_head = { __LINE__ + 1, 0,
    "flat out vec4 v_ssgi_at, v_ssgi_turned, v_ssgi_sent; // position, r^2; normal, weight; sent, inner^2\n"
    "flat out float v_ssgi_end; // outer^2\n"
    "vec4 ssgi_shell(vec4 at, vec4 turned, vec3 sent, int l) // texels, empty where nothing is reached\n"
    "{\n" };
static const ssgi_gl__chunk ssgi_gl__shell_one = { __LINE__ + 1, SSGI_GL__BY_ONE,
    "    float reach = at.w * sqrt(max(1.0 / u_ssgi_epsilon - 1.0, 0.0)), block = exp2(float(l));\n" };
static const ssgi_gl__chunk ssgi_gl__shell_sent = { __LINE__ + 1, SSGI_GL__BY_SENT,
    "    float most = max(sent.x, max(sent.y, sent.z));\n" };
static const ssgi_gl__chunk ssgi_gl__shell_peak = { __LINE__ + 1, SSGI_GL__MIRRORS,
    "    most *= 0.5 * (u_ssgi_exponent + 1.0); // of the lobe\n" };
static const ssgi_gl__chunk ssgi_gl__shell_reach = { __LINE__ + 1, SSGI_GL__BY_SENT,
    "    float reach = at.w * sqrt(max(most / u_ssgi_epsilon - 1.0, 0.0)), block = exp2(float(l));\n" };
static const ssgi_gl__chunk ssgi_gl__shell_bounds = { __LINE__ + 1, 0,
    "    float inner = l > 0 ? reach * 0.5 * block : -1.0, outer = min(reach * block, u_ssgi_radius);\n"
    "    if (!(outer > max(inner, 0.0))) return vec4(0.0);\n"
    "    vec4 b = clamp(ssgi_sphere(vec4(at.xyz, outer)), vec4(0.0), vec2(u_ssgi_size).xyxy);\n"
    "    b = vec4(floor(b.xy / block), ceil(b.zw / block));\n"
    "    if (b.x >= b.z || b.y >= b.w) return vec4(0.0);\n"
    "    int mask = (1 << l) - 1, seed = int(turned.w * 16777216.0); // by chance: what is by turns follows the tessellator's order\n"
    "    vec2 from = vec2((ivec2(seed, seed >> 8) & mask) * ((u_ssgi_size + mask) >> l) + ivec2(0, l * u_ssgi_level.y));\n" };
static const ssgi_gl__chunk ssgi_gl__shell_weighted = { __LINE__ + 1, SSGI_GL__WEIGHTED,
    "    v_ssgi_at = vec4(at.xyz, at.w * at.w);\n"
    "    v_ssgi_turned = vec4(turned.xyz, block * block); // a pixel meets one surfel of that many\n" };
static const ssgi_gl__chunk ssgi_gl__shell_enlarged = { __LINE__ + 1, SSGI_GL__ENLARGED,
    "    v_ssgi_at = vec4(at.xyz, at.w * at.w * block * block); // a pixel meets one surfel of that many, as large as they [DSS14 3.2]\n"
    "    v_ssgi_turned = vec4(turned.xyz, 1.0);\n" };
static const ssgi_gl__chunk ssgi_gl__shell_end = { __LINE__ + 1, 0,
    "    v_ssgi_sent = vec4(sent, inner * abs(inner));\n"
    "    v_ssgi_end = outer * outer;\n"
    "    return b + from.xyxy;\n"
    "}\n"
    "vec4 ssgi_corner(vec4 b, int corner)\n"
    "{\n"
    "    return vec4(vec2((corner & 1) == 1 ? b.z : b.x, corner > 1 ? b.w : b.y) / vec2(u_ssgi_level * ivec2(1, SSGI_LEVELS)) * 2.0 - 1.0, 0.0, 1.0);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__splat_vertex = { __LINE__ + 1, SSGI_GL__BUFFERED,
    "void main()\n"
    "{\n"
    "    int corner = gl_VertexID % 6;\n"
    "    gl_Position = ssgi_corner(ssgi_shell(a_ssgi_surfel0, a_ssgi_surfel1, a_ssgi_surfel2.xyz, gl_VertexID / 6), corner < 3 ? corner : 6 - corner);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__splat_geometry_in = { __LINE__ + 1, SSGI_GL__TESSELLATED,
    "layout(points) in;\n"
    "layout(triangle_strip, max_vertices = 28) out; // 4 a level\n"
    "in vec4 v_ssgi_surfel0[], v_ssgi_surfel1[], v_ssgi_surfel2[];\n" };
static const ssgi_gl__chunk ssgi_gl__splat_geometry = { __LINE__ + 1, SSGI_GL__TESSELLATED,
    "void main()\n"
    "{\n"
    "    for (int l = 0; l < SSGI_LEVELS; ++l)\n"
    "        for (int corner = 0; corner < 4; ++corner) {\n"
    "            vec4 b = ssgi_shell(v_ssgi_surfel0[0], v_ssgi_surfel1[0], v_ssgi_surfel2[0].xyz, l); // outputs are undefined after each vertex\n"
    "            if (b.x >= b.z) break;\n"
    "            gl_Position = ssgi_corner(b, corner);\n"
    "            EmitVertex();\n"
    "            if (corner == 3) EndPrimitive();\n"
    "        }\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__splat_head = { __LINE__ + 1, 0,
    "flat in vec4 v_ssgi_at, v_ssgi_turned, v_ssgi_sent;\n"
    "flat in float v_ssgi_end;\n"
    "void main()\n"
    "{\n"
    "    uvec4 t = texelFetch(t_ssgi_shuffled, ivec2(gl_FragCoord.xy), 0);\n"
    "    vec3 P = uintBitsToFloat(t.xyz), v = v_ssgi_at.xyz - P;\n"
    "    float dd = dot(v, v);\n"
    "    if (!(dd > v_ssgi_sent.w && dd <= v_ssgi_end)) discard;\n" };
static const ssgi_gl__chunk ssgi_gl__splat_normal = { __LINE__ + 1, SSGI_GL__FORM,
    "    vec2 e = (vec2(t.w >> 16, t.w & 65535u) - 32768.0) * (1.0 / 32767.0);\n"
    "    vec3 n = vec3(e, 1.0 - abs(e.x) - abs(e.y));\n"
    "    n.xy -= vec2(n.x >= 0.0 ? 1.0 : -1.0, n.y >= 0.0 ? 1.0 : -1.0) * max(-n.z, 0.0);\n"
    "    n *= inversesqrt(dot(n, n));\n"
    "    float near = dot(v, n), away = -dot(v, v_ssgi_turned.xyz), rr = v_ssgi_at.w, form = max(near, 0.0) / (max(dd, 1e-30) * (dd + rr));\n" };
static const ssgi_gl__chunk ssgi_gl__splat_front = { __LINE__ + 1, SSGI_GL__ONE_SIDED,
    "    if (!(away > 0.0)) discard; // fronts alone: backs would count what is closed twice\n" };
static const ssgi_gl__chunk ssgi_gl__splat_both = { __LINE__ + 1, SSGI_GL__TWO_SIDED,
    "    away = abs(away);\n" };
static const ssgi_gl__chunk ssgi_gl__splat_near = { __LINE__ + 1, SSGI_GL__NEAR | SSGI_GL__FORM,
    "    if (dd < 16.0 * rr) { // the disc as smaller ones, which may rise above the horizon where its centre does not\n"
    "        vec3 m = v_ssgi_turned.xyz, a = normalize(abs(m.z) < 0.7 ? vec3(m.y, -m.x, 0.0) : vec3(0.0, m.z, -m.y)), b = cross(m, a);\n"
    "        vec2 turn = vec2(1.0, 0.0);\n"
    "        form = 0.0;\n"
    "        for (int i = 0; i < SSGI_NEAR; ++i) {\n"
    "            vec2 o = turn * sqrt((float(i) + 0.5) / float(SSGI_NEAR) * rr);\n"
    "            vec3 w = v + a * o.x + b * o.y;\n"
    "            float ww = dot(w, w);\n"
    "            form += max(dot(w, n), 0.0) / (max(ww, 1e-30) * (ww + rr / float(SSGI_NEAR)));\n"
    "            turn = mat2(-0.73736888, 0.67549029, -0.67549029, -0.73736888) * turn; // by the golden angle\n"
    "        }\n"
    "        form /= float(SSGI_NEAR);\n"
    "    }\n" };
static const ssgi_gl__chunk ssgi_gl__splat_form = { __LINE__ + 1, SSGI_GL__FORM,
    "    form *= v_ssgi_turned.w * rr * away;\n"
    "    if (!(form > 0.0)) discard;\n" };
static const ssgi_gl__chunk ssgi_gl__splat_soft = { __LINE__ + 1, SSGI_GL__SOFT,
    "    form *= max(1.0 - sqrt(dd) / u_ssgi_radius, 0.0);\n" };
static const ssgi_gl__chunk ssgi_gl__splat_occludes = { __LINE__ + 1, SSGI_GL__OCCLUDES,
    "    o_ssgi_levels = form;\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__splat_hides = { __LINE__ + 1, SSGI_GL__HIDES,
    "    o_ssgi_levels = form * vec4(ssgi_environment(transpose(u_ssgi_rotation) * v), 1.0);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__splat_brings = { __LINE__ + 1, SSGI_GL__BRINGS,
    "    o_ssgi_levels = form * vec4(v_ssgi_sent.xyz, 1.0);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__splat_mirrors = { __LINE__ + 1, SSGI_GL__MIRRORS,
    "    float mirrored = max(dot(v, reflect(-ssgi_toward(P), normalize(n))), 1e-20) * inversesqrt(max(dd, 1e-30));\n"
    "    float lobe = 0.5 * (u_ssgi_exponent + 1.0) * pow(mirrored, u_ssgi_exponent); // over 2 pi, times the disc's solid angle\n"
    "    o_ssgi_levels = vec4(v_ssgi_sent.xyz * (lobe * v_ssgi_turned.w * v_ssgi_at.w * away * inversesqrt(max(dd, 1e-30)) / (dd + v_ssgi_at.w)), form);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__splat_scatters = { __LINE__ + 1, SSGI_GL__SCATTERS,
    "    // a deeper source is the same one blurred, by as much: surfels wider than the source is deep would show as dots\n"
    "    vec3 s = u_ssgi_dipole[2].xyz, h = max(sqrt(v_ssgi_at.w) - u_ssgi_dipole[0].xyz, 0.0), y = u_ssgi_dipole[0].xyz + h, z = u_ssgi_dipole[1].xyz + h;\n"
    "    vec3 a = inversesqrt(dd + y * y), b = inversesqrt(dd + z * z), R = y * (s + a) * exp(s * (h - 1.0 / a)) * a * a + z * (s + b) * exp(s * (h - 1.0 / b)) * b * b;\n"
    "    o_ssgi_levels = vec4(v_ssgi_sent.xyz * u_ssgi_dipole[3].xyz * R, 1.0) * (v_ssgi_turned.w * v_ssgi_at.w);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__smooth_head = { __LINE__ + 1, 0,
    "void main()\n"
    "{\n"
    "    ivec2 q = ivec2(gl_FragCoord.xy);\n"
    "    int l = q.y / u_ssgi_level.y, reach = (1 << l) >> 1;\n"
    "    ivec2 first = ivec2(0, l * u_ssgi_level.y), p = q - first;\n"
    "    float z = ssgi_inside(p) ? ssgi_depth(p) : SSGI_FAR;\n"
    "    if (z >= SSGI_FAR) discard;\n"
    "    vec3 P = ssgi_position(vec2(p) + 0.5, z), n = ssgi_normal(p, P), plane = ssgi_plane(P, n);\n"
    "    float footprint = ssgi_footprint(z), near = 1.0 / (footprint * (1.0 + float(reach)));\n"
    "    vec4 sum = vec4(texelFetch(t_ssgi_levels, q, 0));\n"
    "    float all = 1.0;\n"
    "    for (int i = -reach; i <= reach; ++i) { // a box over the block that the level deals out\n"
    "        ivec2 o = SSGI_AXIS == 0 ? ivec2(i, 0) : ivec2(0, i);\n"
    "        if (i == 0 || !ssgi_inside(p + o)) continue;\n"
    "        float d = ssgi_depth(p + o), w = max(1.0 - ssgi_off_plane(plane, vec2(o), P, d) * near, 0.0) * (abs(i) == reach ? 0.5 : 1.0);\n" };
static const ssgi_gl__chunk ssgi_gl__smooth_normals = { __LINE__ + 1, SSGI_GL__F_NORMALS,
    "        if (w > 0.0) w *= max(dot(n, ssgi_normal(p + o, ssgi_position(vec2(p + o) + 0.5, d))), 0.0);\n" };
static const ssgi_gl__chunk ssgi_gl__smooth_tail = { __LINE__ + 1, 0,
    "        if (!(w > 0.0) || d >= SSGI_FAR) continue;\n"
    "        sum += w * texelFetch(t_ssgi_levels, q + o, 0);\n"
    "        all += w;\n"
    "    }\n" };
static const ssgi_gl__chunk ssgi_gl__smooth_grey = { __LINE__ + 1, SSGI_GL__GREY,
    "    o_ssgi_levels = sum.x / all;\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__smooth_colour = { __LINE__ + 1, SSGI_GL__COLOUR,
    "    o_ssgi_levels = sum / all;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__sum_adds = { __LINE__ + 1, SSGI_GL__ADDS_UP | SSGI_GL__FORM,
    "// of what is hidden so much is hidden once\n"
    "float ssgi_once(float form)\n"
    "{\n"
    "    return 1.0 / max(form, 1.0);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__sum_shares = { __LINE__ + 1, SSGI_GL__SHARES | SSGI_GL__FORM,
    "// of what is hidden so much is hidden once\n"
    "float ssgi_once(float form)\n"
    "{\n"
    "    return form > 1e-4 ? (1.0 - exp(-form)) / form : 1.0;\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__sum_levels = { __LINE__ + 1, 0,
    "    vec4 sum = vec4(0.0);\n"
    "    if (z < SSGI_FAR) for (int l = 0; l < SSGI_LEVELS; ++l) sum += texelFetch(t_ssgi_levels, p + ivec2(0, l * u_ssgi_level.y), 0);\n" };
static const ssgi_gl__chunk ssgi_gl__sum_occludes = { __LINE__ + 1, SSGI_GL__OCCLUDES,
    "    o_ssgi_ao = vec2(1.0 - sum.x * ssgi_once(sum.x), z);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__sum_hides = { __LINE__ + 1, SSGI_GL__HIDES,
    "    o_ssgi_light = vec4(0.0, 0.0, 0.0, z);\n"
    "    if (z < SSGI_FAR) o_ssgi_light.xyz = max(ssgi_open(transpose(u_ssgi_rotation) * ssgi_normal(p, ssgi_position(vec2(p) + 0.5, z)), 0) - sum.xyz * ssgi_once(sum.w), 0.0);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__sum_brings = { __LINE__ + 1, SSGI_GL__BRINGS,
    "    o_ssgi_bounce = vec4(sum.xyz * ssgi_once(sum.w), z);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__sum_mirrors = { __LINE__ + 1, SSGI_GL__MIRRORS,
    "    o_ssgi_specular = vec4(sum.xyz * ssgi_once(sum.w), z);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__sum_scatters = { __LINE__ + 1, SSGI_GL__SCATTERS,
    "    o_ssgi_scatter = vec4(sum.xyz, z);\n"
    "}\n" };

/* ==== >>filter ==================================================================================================== */

static const ssgi_gl__chunk ssgi_gl__plane_perspective = { __LINE__ + 1, SSGI_GL__BILATERAL | SSGI_GL__PERSPECTIVE,
    "// dot(k, vec3(o, 1)) * z - dot(n, P): how far the point seen o pixels from P at depth z lies off the plane through P\n"
    "vec3 ssgi_plane(vec3 P, vec3 n)\n"
    "{\n"
    "    return vec3(n.xy * u_ssgi_unproject.xy, dot(n, P) / -P.z);\n"
    "}\n"
    "float ssgi_off_plane(vec3 k, vec2 o, vec3 P, float z)\n"
    "{\n"
    "    return abs((dot(k.xy, o) + k.z) * z + k.z * P.z);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__plane_orthographic = { __LINE__ + 1, SSGI_GL__BILATERAL | SSGI_GL__ORTHOGRAPHIC,
    "// how far the point seen o pixels from P at depth z lies off the plane through P\n"
    "vec3 ssgi_plane(vec3 P, vec3 n)\n"
    "{\n"
    "    return vec3(n.xy * u_ssgi_unproject.xy, n.z);\n"
    "}\n"
    "float ssgi_off_plane(vec3 k, vec2 o, vec3 P, float z)\n"
    "{\n"
    "    return abs(dot(k.xy, o) - k.z * (z + P.z));\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__blur_head = { __LINE__ + 1, 0,
    "void main()\n"
    "{\n"
    "    ivec2 p = ivec2(gl_FragCoord.xy) - u_ssgi_target;\n" };

static const ssgi_gl__chunk ssgi_gl__blur_full_grey = { __LINE__ + 1, SSGI_GL__FULL | SSGI_GL__GREY,
    "    vec2 sum = texelFetch(t_ssgi_ao, p + u_ssgi_target, 0).xy;\n"
    "    float z = sum.y;\n"
    "    sum.y = 1.0;\n" };

static const ssgi_gl__chunk ssgi_gl__blur_full_colour = { __LINE__ + 1, SSGI_GL__FULL | SSGI_GL__COLOUR,
    "    vec4 sum = texelFetch(t_ssgi_light, p + u_ssgi_target, 0);\n"
    "    float z = sum.w;\n"
    "    sum.w = 1.0;\n" };

static const ssgi_gl__chunk ssgi_gl__blur_half_grey = { __LINE__ + 1, SSGI_GL__HALF | SSGI_GL__GREY,
    "    vec2 sum = vec2(0.0);\n"
    "    float z = ssgi_depth(p);\n" };

static const ssgi_gl__chunk ssgi_gl__blur_half_colour = { __LINE__ + 1, SSGI_GL__HALF | SSGI_GL__COLOUR,
    "    vec4 sum = vec4(0.0);\n"
    "    float z = ssgi_depth(p);\n" };

static const ssgi_gl__chunk ssgi_gl__blur_full_vectors = { __LINE__ + 1, SSGI_GL__FULL | SSGI_GL__VECTORS,
    "    ssgi_vectors sum = ssgi_load(p + u_ssgi_target);\n"
    "    float z = ssgi_depth(p), all = 1.0;\n" };

static const ssgi_gl__chunk ssgi_gl__blur_half_vectors = { __LINE__ + 1, SSGI_GL__HALF | SSGI_GL__VECTORS,
    "    ssgi_vectors sum = ssgi_vectors_none();\n"
    "    float z = ssgi_depth(p), all = 0.0;\n" };

static const ssgi_gl__chunk ssgi_gl__blur_centre = { __LINE__ + 1, 0,
    "    vec3 P = ssgi_position(vec2(p) + 0.5, z);\n"
    "    float footprint = ssgi_footprint(z);\n" };

static const ssgi_gl__chunk ssgi_gl__blur_normal = { __LINE__ + 1, SSGI_GL__BILATERAL,
    "    vec3 n = ssgi_normal(p, P), plane = ssgi_plane(P, n);\n"
    "    float near = 1.0 / (0.05 * u_ssgi_radius + footprint);\n" };

static const ssgi_gl__chunk ssgi_gl__blur_loop = { __LINE__ + 1, 0,
    "    for (int y = -SSGI_FILTER_RADIUS; y <= SSGI_FILTER_RADIUS; ++y)\n"
    "        for (int x = -SSGI_FILTER_RADIUS; x <= SSGI_FILTER_RADIUS; ++x) {\n" };

static const ssgi_gl__chunk ssgi_gl__blur_tap_full = { __LINE__ + 1, SSGI_GL__FULL,
    "            if (x == 0 && y == 0) continue;\n"
    "            ivec2 o = ivec2(x, y), q = p + o, at = q + u_ssgi_target;\n" };

static const ssgi_gl__chunk ssgi_gl__blur_tap_half = { __LINE__ + 1, SSGI_GL__HALF,
    "            ivec2 h = p / 2 + ivec2(x, y), q = h * 2, o = q - p, at = h + u_ssgi_target / 2;\n" };

static const ssgi_gl__chunk ssgi_gl__blur_tap_grey = { __LINE__ + 1, SSGI_GL__GREY,
    "            vec2 s = texelFetch(t_ssgi_ao, at, 0).xy;\n"
    "            float d = s.y;\n"
    "            s.y = 1.0;\n" };

static const ssgi_gl__chunk ssgi_gl__blur_tap_colour = { __LINE__ + 1, SSGI_GL__COLOUR,
    "            vec4 s = texelFetch(t_ssgi_light, at, 0);\n"
    "            float d = s.w;\n"
    "            s.w = 1.0;\n" };

static const ssgi_gl__chunk ssgi_gl__blur_tap_vectors = { __LINE__ + 1, SSGI_GL__VECTORS,
    "            float d = ssgi_depth(q);\n" };

static const ssgi_gl__chunk ssgi_gl__weight_gaussian = { __LINE__ + 1, SSGI_GL__GAUSSIAN,
    "            // Gaussian over its depth difference, softened by a pixel's footprint [HSAO08 4.1.3]\n"
    "            float w = exp(-0.5 * float(x * x + y * y) / (0.25 * float(SSGI_FILTER_RADIUS * SSGI_FILTER_RADIUS) + 0.25)) * footprint / (footprint + abs(d - z));\n" };

static const ssgi_gl__chunk ssgi_gl__weight_bilateral = { __LINE__ + 1, SSGI_GL__BILATERAL,
    "            // nearness to the tangent plane of the centre\n"
    "            float off = ssgi_off_plane(plane, vec2(o), P, d) * near;\n" };

static const ssgi_gl__chunk ssgi_gl__weight_box = { __LINE__ + 1, SSGI_GL__BILATERAL | SSGI_GL__FULL,
    "            float w = max(1.0 - off, 0.0); // a box that covers one tile of noise\n"
    "            if (SSGI_FILTER_RADIUS > 1 && abs(x) == SSGI_FILTER_RADIUS) w *= 0.5;\n"
    "            if (SSGI_FILTER_RADIUS > 1 && abs(y) == SSGI_FILTER_RADIUS) w *= 0.5;\n" };

static const ssgi_gl__chunk ssgi_gl__weight_tent = { __LINE__ + 1, SSGI_GL__BILATERAL | SSGI_GL__HALF,
    "            vec2 tent = float(2 * SSGI_FILTER_RADIUS + 2) - abs(vec2(o));\n"
    "            float w = tent.x * tent.y * max(1.0 - off, 1e-3 / (1.0 + off)); // never 0: where nothing fits, the nearest\n" };

static const ssgi_gl__chunk ssgi_gl__weight_normals = { __LINE__ + 1, SSGI_GL__F_NORMALS,
    "            w *= max(dot(n, ssgi_normal(q, ssgi_position(vec2(q) + 0.5, d))), 1e-3);\n" };

static const ssgi_gl__chunk ssgi_gl__blur_tail = { __LINE__ + 1, SSGI_GL__PLAIN,
    "            if (ssgi_inside(q) && d < SSGI_FAR) sum += s * w;\n"
    "        }\n" };

static const ssgi_gl__chunk ssgi_gl__blur_tail_vectors = { __LINE__ + 1, SSGI_GL__VECTORS,
    "            if (!ssgi_inside(q) || d >= SSGI_FAR || w <= 0.0) continue;\n"
    "            ssgi_vectors s = ssgi_load(at);\n"
    "            for (int c = 0; c < s.c.length(); ++c) ssgi_sh_add(sum.c[c], s.c[c], w);\n"
    "            all += w;\n"
    "        }\n"
    "    float scale = z < SSGI_FAR && all > 0.0 ? 1.0 / all : 0.0;\n"
    "    for (int c = 0; c < sum.c.length(); ++c) ssgi_sh_add(sum.c[c], sum.c[c], scale - 1.0);\n"
    "    ssgi_store(sum);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__blur_grey = { __LINE__ + 1, SSGI_GL__GREY,
    "    o_ssgi_ao = z < SSGI_FAR && sum.y > 0.0 ? sum.x / sum.y : 1.0;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__blur_colour = { __LINE__ + 1, SSGI_GL__COLOUR,
    "    o_ssgi_light = vec4(z < SSGI_FAR && sum.w > 0.0 ? sum.xyz / sum.w : vec3(0.0), z);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__survey_main = { __LINE__ + 1, 0,
    "// one pixel of every 8x8: which share of points around it stands behind what is seen by less than a quarter of the radius, less than the radius, more; or off the picture\n"
    "void main()\n"
    "{\n"
    "    ivec2 p = ivec2(gl_FragCoord.xy) * 8 + 4;\n"
    "    float z = ssgi_inside(p) ? ssgi_depth(p) : SSGI_FAR;\n"
    "    o_ssgi_survey = vec4(-1.0);\n"
    "    if (z < SSGI_FAR) {\n"
    "        vec3 P = ssgi_position(vec2(p) + 0.5, z), n = ssgi_normal(p, P), start = ssgi_lift(P, n);\n"
    "        vec2 xi = ssgi_noise(p);\n"
    "        mat3 basis = ssgi_basis(n);\n"
    "        vec4 sum = vec4(0.0);\n"
    "        for (int i = 0; i < SSGI_SAMPLES; ++i) {\n"
    "            float u = (float(i) + 0.5) / float(SSGI_SAMPLES), a = 2.39996323 * float(i) + 6.28318531 * xi.x;\n"
    "            vec3 S = start + basis * vec3(sqrt(u) * vec2(cos(a), sin(a)), sqrt(1.0 - u)) * (u_ssgi_radius * fract(0.61803399 * float(i) + xi.y));\n"
    "            ivec2 q = ivec2(floor(ssgi_project(S)));\n"
    "            float behind = -S.z - ssgi_depth(q);\n"
    "            bool seen = S.z < 0.0 && ssgi_inside(q);\n"
    "            sum += !seen ? vec4(0.0, 0.0, 0.0, 1.0) : vec4(step(vec3(0.0, 0.25, 1.0) * u_ssgi_radius, vec3(behind)) - vec3(step(vec2(0.25, 1.0) * u_ssgi_radius, vec2(behind)), 0.0), 0.0);\n"
    "        }\n"
    "        o_ssgi_survey = sum / float(SSGI_SAMPLES);\n"
    "    }\n"
    "}\n" };

/* ==== >>passes: what each is made of ============================================================================== */

/* In the order of the text; what a variant does not need falls out by its bits. */
#define SSGI_GL__PROJECTIONS(name) &ssgi_gl__##name##_perspective, &ssgi_gl__##name##_orthographic
#define SSGI_GL__FETCH  &ssgi_gl__far, &ssgi_gl__inside, SSGI_GL__PROJECTIONS(decode), &ssgi_gl__depth_window, &ssgi_gl__depth_linear, &ssgi_gl__depth_custom, \
                        &ssgi_gl__layer_window, &ssgi_gl__layer_linear, &ssgi_gl__hidden_window, &ssgi_gl__hidden_linear, &ssgi_gl__layer_custom, SSGI_GL__PROJECTIONS(position), SSGI_GL__PROJECTIONS(toward), &ssgi_gl__unit, \
                        &ssgi_gl__texel_first, &ssgi_gl__texel_hidden, &ssgi_gl__raw_signed, &ssgi_gl__raw_unsigned, &ssgi_gl__raw_octahedral, &ssgi_gl__raw_custom, \
                        &ssgi_gl__normal_view, &ssgi_gl__normal_world, &ssgi_gl__normal_from_depth
#define SSGI_GL__GATHER &ssgi_gl__noise_tile4, &ssgi_gl__noise_gradient, &ssgi_gl__noise_texture, &ssgi_gl__basis
#define SSGI_GL__TEST   SSGI_GL__PROJECTIONS(project), SSGI_GL__PROJECTIONS(footprint), &ssgi_gl__lift, &ssgi_gl__back_fixed, &ssgi_gl__back_reach, &ssgi_gl__look_from, &ssgi_gl__look_normal, &ssgi_gl__look_head, \
                        &ssgi_gl__look_views, &ssgi_gl__look_tail, &ssgi_gl__unpack, &ssgi_gl__unpack_depth, &ssgi_gl__unpack_normal, &ssgi_gl__sent_kept, &ssgi_gl__sent_head, &ssgi_gl__sent_views, &ssgi_gl__sent_main, \
                        &ssgi_gl__sent_both, &ssgi_gl__sent_facing, &ssgi_gl__sent_area, &ssgi_gl__sent_area_both, &ssgi_gl__sent_patch, &ssgi_gl__sent_disc, &ssgi_gl__faded_head, &ssgi_gl__faded_range, &ssgi_gl__faded_smooth, &ssgi_gl__faded_ended, &ssgi_gl__faded_lambda, &ssgi_gl__faded_tail, \
                        &ssgi_gl__shallow_head, &ssgi_gl__shallow_depth, &ssgi_gl__shallow_send, &ssgi_gl__shallow_keep, &ssgi_gl__shallow_test, &ssgi_gl__shallow_thin, &ssgi_gl__shallow_whole, &ssgi_gl__shallow_fade, \
                        &ssgi_gl__view_surface, &ssgi_gl__surface_head, &ssgi_gl__surface_views, &ssgi_gl__surface_layers, &ssgi_gl__surface_one, &ssgi_gl__offer, &ssgi_gl__offer_keep, &ssgi_gl__offer_end, \
                        &ssgi_gl__matter_head, &ssgi_gl__matter_solid, &ssgi_gl__matter_thin, &ssgi_gl__matter_loop, &ssgi_gl__matter_depths, &ssgi_gl__matter_held, &ssgi_gl__matter_back, &ssgi_gl__matter_inside, \
                        &ssgi_gl__matter_offer, &ssgi_gl__matter_fade, &ssgi_gl__matter_whole, &ssgi_gl__matter_tail, &ssgi_gl__deep_head, &ssgi_gl__deep_reset, \
                        &ssgi_gl__deep_main, &ssgi_gl__deep_views, &ssgi_gl__deep_tail
#define SSGI_GL__LOOP   &ssgi_gl__points_turn, &ssgi_gl__points_pick, &ssgi_gl__points_map, &ssgi_gl__points_loop, \
                        &ssgi_gl__points_constant, &ssgi_gl__points_fetched, &ssgi_gl__points_single, &ssgi_gl__points_several
#define SSGI_GL__LENGTH &ssgi_gl__kernel, &ssgi_gl__length_uniform, &ssgi_gl__length_square, &ssgi_gl__length_cube
#define SSGI_GL__PLACES &ssgi_gl__unproject, &ssgi_gl__decode_row, &ssgi_gl__origin, &ssgi_gl__size
#define SSGI_GL__READS  SSGI_GL__PLACES, &ssgi_gl__target
#define SSGI_GL__MAPS   &ssgi_gl__depth_tex, &ssgi_gl__layers_tex, &ssgi_gl__normal_tex, &ssgi_gl__normals_tex, &ssgi_gl__noise_tex
#define SSGI_GL__SH     &ssgi_gl__sh_struct, &ssgi_gl__sh_struct3, &ssgi_gl__sh_struct4, &ssgi_gl__sh_struct_end, &ssgi_gl__sh_basis, &ssgi_gl__sh_basis2, &ssgi_gl__sh_basis3, &ssgi_gl__sh_basis4, \
                        &ssgi_gl__sh_basis_end, &ssgi_gl__sh_zonal, &ssgi_gl__sh_zonal3, &ssgi_gl__sh_zonal4, &ssgi_gl__sh_zonal_end
#define SSGI_GL__SH_ADD &ssgi_gl__sh_add, &ssgi_gl__sh_add3, &ssgi_gl__sh_add4, &ssgi_gl__sh_add_end
#define SSGI_GL__SH_DOT &ssgi_gl__sh_dot, &ssgi_gl__sh_dot3, &ssgi_gl__sh_dot4, &ssgi_gl__sh_dot_end
#define SSGI_GL__SH_TURN &ssgi_gl__sh_about, &ssgi_gl__sh_about4, &ssgi_gl__sh_quarter, &ssgi_gl__sh_quarter4, &ssgi_gl__sh_quarter_end, &ssgi_gl__sh_turn, &ssgi_gl__sh_turn2, &ssgi_gl__sh_turn3, &ssgi_gl__sh_turn_end
#define SSGI_GL__VECTOR_TYPE &ssgi_gl__vectors_mono, &ssgi_gl__vectors_rgb
#define SSGI_GL__LOAD   &ssgi_gl__unhalf_native, &ssgi_gl__unhalf_made, &ssgi_gl__unpack_sh, &ssgi_gl__unpack_sh2, &ssgi_gl__unpack_sh3, &ssgi_gl__unpack_sh4, &ssgi_gl__unpack_sh_end, \
                        &ssgi_gl__load, &ssgi_gl__load_words, &ssgi_gl__load_words2, &ssgi_gl__load_words3, &ssgi_gl__load_words4, &ssgi_gl__load_mono, &ssgi_gl__load_mono3, &ssgi_gl__load_mono_end, \
                        &ssgi_gl__load_rgb, &ssgi_gl__load_rgb3, &ssgi_gl__load_rgb_end, &ssgi_gl__load_end
#define SSGI_GL__STORE  &ssgi_gl__half_native, &ssgi_gl__half_made, &ssgi_gl__pack_sh, &ssgi_gl__pack_sh2, &ssgi_gl__pack_sh3, &ssgi_gl__pack_sh_end, &ssgi_gl__pack_more, &ssgi_gl__pack_more4, \
                        &ssgi_gl__pack_more_end, &ssgi_gl__store, &ssgi_gl__store_words, &ssgi_gl__store_words3, &ssgi_gl__store_words4, &ssgi_gl__store_mono, &ssgi_gl__store_mono3, &ssgi_gl__store_rgb, \
                        &ssgi_gl__store_rgb3, &ssgi_gl__store_end
#define SSGI_GL__DOT    &ssgi_gl__free_part, &ssgi_gl__lacking, &ssgi_gl__incoming, &ssgi_gl__incoming3, &ssgi_gl__incoming4, &ssgi_gl__incoming_end, &ssgi_gl__incoming_exact, &ssgi_gl__incoming_out
#define SSGI_GL__OF_VECTORS(x) &ssgi_gl__##x##_sh0, &ssgi_gl__##x##_sh1, &ssgi_gl__##x##_sh2, &ssgi_gl__##x##_sh3, &ssgi_gl__##x##_packed0, &ssgi_gl__##x##_packed1, &ssgi_gl__##x##_red0, \
                        &ssgi_gl__##x##_red1, &ssgi_gl__##x##_green0, &ssgi_gl__##x##_green1, &ssgi_gl__##x##_blue0, &ssgi_gl__##x##_blue1
#define SSGI_GL__DEEP_C &ssgi_gl__c_layers, &ssgi_gl__c_views, &ssgi_gl__c_view_layers
#define SSGI_GL__CAMERAS &ssgi_gl__view_to, &ssgi_gl__view_from, &ssgi_gl__view_decode, &ssgi_gl__view_size

static const ssgi_gl__chunk *const ssgi_gl__vertex_chunks[] = { &ssgi_gl__triangle, NULL };
static const ssgi_gl__row *const ssgi_gl__vertex_rows[] = { NULL };

static const ssgi_gl__chunk *const ssgi_gl__ssao_chunks[] = {
    SSGI_GL__FETCH, SSGI_GL__GATHER, SSGI_GL__TEST, SSGI_GL__LENGTH, &ssgi_gl__points_ao, &ssgi_gl__points_from, &ssgi_gl__points_normal, SSGI_GL__LOOP, &ssgi_gl__sum_ao, &ssgi_gl__main_full, &ssgi_gl__main_half, &ssgi_gl__main_ao, NULL };
static const ssgi_gl__row *const ssgi_gl__ssao_rows[] = {
    &ssgi_gl__c_samples, &ssgi_gl__c_several, SSGI_GL__DEEP_C, &ssgi_gl__project, SSGI_GL__READS, &ssgi_gl__radius, &ssgi_gl__offset, &ssgi_gl__thickness, &ssgi_gl__phase,
    &ssgi_gl__fade_row, &ssgi_gl__lambda_row, &ssgi_gl__rotation, SSGI_GL__CAMERAS, SSGI_GL__MAPS, &ssgi_gl__views_tex, &ssgi_gl__kernel_tex, &ssgi_gl__ao_out, NULL };

static const ssgi_gl__chunk *const ssgi_gl__slices_chunks[] = {
    SSGI_GL__FETCH, SSGI_GL__GATHER, SSGI_GL__PROJECTIONS(screen), &ssgi_gl__arc, &ssgi_gl__slices_head, &ssgi_gl__slices_thin, &ssgi_gl__slices_last, &ssgi_gl__slices_loop,
    &ssgi_gl__slices_gap, &ssgi_gl__slices_linear, &ssgi_gl__slices_hard, &ssgi_gl__slices_tail, &ssgi_gl__main_full, &ssgi_gl__main_half, &ssgi_gl__main_ao, NULL };
static const ssgi_gl__row *const ssgi_gl__slices_rows[] = {
    &ssgi_gl__c_directions, &ssgi_gl__c_steps, &ssgi_gl__project, SSGI_GL__READS, &ssgi_gl__radius, &ssgi_gl__thickness, &ssgi_gl__phase, &ssgi_gl__rotation, SSGI_GL__MAPS, &ssgi_gl__ao_out, NULL };

static const ssgi_gl__chunk *const ssgi_gl__march_chunks[] = {
    SSGI_GL__FETCH, SSGI_GL__GATHER, SSGI_GL__TEST, &ssgi_gl__attenuation_linear, &ssgi_gl__attenuation_hard, &ssgi_gl__march, &ssgi_gl__normal_ray, &ssgi_gl__above_rays,
    &ssgi_gl__gather_march_head, &ssgi_gl__gather_march_rays, &ssgi_gl__gather_march_tail, &ssgi_gl__main_full, &ssgi_gl__main_half, &ssgi_gl__main_ao, NULL };
static const ssgi_gl__row *const ssgi_gl__march_rows[] = {
    &ssgi_gl__c_directions, &ssgi_gl__c_steps, &ssgi_gl__c_rays, SSGI_GL__DEEP_C, &ssgi_gl__project, SSGI_GL__READS, &ssgi_gl__radius, &ssgi_gl__offset, &ssgi_gl__thickness,
    &ssgi_gl__phase, &ssgi_gl__rotation, SSGI_GL__CAMERAS, SSGI_GL__MAPS, &ssgi_gl__views_tex, &ssgi_gl__ao_out, NULL };

static const ssgi_gl__chunk *const ssgi_gl__ssdo_chunks[] = {
    SSGI_GL__FETCH, SSGI_GL__GATHER, SSGI_GL__TEST, &ssgi_gl__sh_cosine, SSGI_GL__SH, SSGI_GL__SH_ADD, SSGI_GL__SH_TURN, SSGI_GL__VECTOR_TYPE, &ssgi_gl__vectors_none, SSGI_GL__DOT, &ssgi_gl__octahedron, &ssgi_gl__environment, &ssgi_gl__open,
    SSGI_GL__LENGTH, &ssgi_gl__points_ssdo, &ssgi_gl__points_from, &ssgi_gl__points_normal,
    &ssgi_gl__points_bounce, &ssgi_gl__points_free, SSGI_GL__LOOP, &ssgi_gl__sum_free, &ssgi_gl__sum_map, &ssgi_gl__sum_angle, &ssgi_gl__sum_area, &ssgi_gl__points_end, &ssgi_gl__light_vectors, &ssgi_gl__points_turned, &ssgi_gl__points_exact, &ssgi_gl__light_dot, &ssgi_gl__light_map, &ssgi_gl__light_bounce,
    &ssgi_gl__points_close, &ssgi_gl__main_full, &ssgi_gl__main_half, &ssgi_gl__main_depth, &ssgi_gl__main_layer, &ssgi_gl__main_light, &ssgi_gl__main_bounce, &ssgi_gl__main_ssdo, NULL };
static const ssgi_gl__row *const ssgi_gl__ssdo_rows[] = {
    &ssgi_gl__c_samples, &ssgi_gl__c_several, SSGI_GL__DEEP_C, &ssgi_gl__c_receiver, &ssgi_gl__project, SSGI_GL__READS, &ssgi_gl__radius, &ssgi_gl__offset, &ssgi_gl__thickness,
    &ssgi_gl__phase, &ssgi_gl__fade_row, &ssgi_gl__nearest, &ssgi_gl__gain, &ssgi_gl__lambda_row, &ssgi_gl__rotation, &ssgi_gl__harmonics_row, SSGI_GL__CAMERAS, SSGI_GL__MAPS, &ssgi_gl__views_tex, &ssgi_gl__senders_tex, &ssgi_gl__view_senders,
    &ssgi_gl__kernel_tex, &ssgi_gl__map_tex, &ssgi_gl__open_tex, &ssgi_gl__light_out, &ssgi_gl__bounce_out, NULL };

static const ssgi_gl__chunk *const ssgi_gl__s3ho_chunks[] = {
    SSGI_GL__FETCH, SSGI_GL__GATHER, SSGI_GL__TEST, SSGI_GL__LENGTH, &ssgi_gl__sh_cosine, SSGI_GL__SH, SSGI_GL__SH_ADD, SSGI_GL__SH_TURN, SSGI_GL__VECTOR_TYPE, &ssgi_gl__vectors_none, SSGI_GL__STORE, SSGI_GL__DOT, &ssgi_gl__octahedron,
    &ssgi_gl__open, &ssgi_gl__points_s3ho,
    &ssgi_gl__points_from, &ssgi_gl__points_normal, &ssgi_gl__points_free, SSGI_GL__LOOP, &ssgi_gl__sum_free, &ssgi_gl__sum_reflected, &ssgi_gl__sum_both_sides, &ssgi_gl__sum_reflected_end, &ssgi_gl__points_end,
    &ssgi_gl__points_turned, &ssgi_gl__points_exact, &ssgi_gl__points_close, &ssgi_gl__main_full, &ssgi_gl__main_half, &ssgi_gl__main_s3ho, &ssgi_gl__main_store, &ssgi_gl__main_dot, &ssgi_gl__lights_end, NULL };
static const ssgi_gl__row *const ssgi_gl__s3ho_rows[] = {
    &ssgi_gl__c_samples, &ssgi_gl__c_several, SSGI_GL__DEEP_C, &ssgi_gl__project, SSGI_GL__READS, &ssgi_gl__radius, &ssgi_gl__offset, &ssgi_gl__thickness, &ssgi_gl__phase, &ssgi_gl__fade_row,
    &ssgi_gl__lambda_row, &ssgi_gl__rotation, &ssgi_gl__harmonics_row, SSGI_GL__CAMERAS, SSGI_GL__MAPS, &ssgi_gl__views_tex, &ssgi_gl__senders_tex, &ssgi_gl__view_senders, &ssgi_gl__kernel_tex, &ssgi_gl__open_tex,
    SSGI_GL__OF_VECTORS(o), &ssgi_gl__light_out, NULL };

static const ssgi_gl__chunk *const ssgi_gl__shade_chunks[] = {
    SSGI_GL__FETCH, &ssgi_gl__octahedron, &ssgi_gl__open, &ssgi_gl__sh_cosine, SSGI_GL__SH, SSGI_GL__SH_DOT, SSGI_GL__VECTOR_TYPE, SSGI_GL__LOAD, SSGI_GL__DOT, &ssgi_gl__bent, &ssgi_gl__lights_head, &ssgi_gl__shade_half, &ssgi_gl__main_depth, &ssgi_gl__shade_bent, &ssgi_gl__shade_head, &ssgi_gl__shade_normal_read, &ssgi_gl__points_exact, &ssgi_gl__shade_harmonics, &ssgi_gl__shade_cones,
    &ssgi_gl__shade_normal, &ssgi_gl__shade_cone, &ssgi_gl__shade_point, &ssgi_gl__lights_loop, &ssgi_gl__shade_lamp, &ssgi_gl__shade_lamp2, &ssgi_gl__shade_lamp3, &ssgi_gl__shade_lamp_end, &ssgi_gl__shade_lamp_exact, &ssgi_gl__shade_lamp_add, &ssgi_gl__shade_tail,
    &ssgi_gl__shade_albedo, &ssgi_gl__lights_end, NULL };
static const ssgi_gl__row *const ssgi_gl__shade_rows[] = {
    SSGI_GL__READS, &ssgi_gl__lights_row, &ssgi_gl__rotation, &ssgi_gl__harmonics_row, &ssgi_gl__window_row, SSGI_GL__MAPS, &ssgi_gl__lights_tex, &ssgi_gl__open_tex, &ssgi_gl__albedo_tex,
    SSGI_GL__OF_VECTORS(t), &ssgi_gl__shaded_out, &ssgi_gl__bent_out, NULL };

static const ssgi_gl__chunk *const ssgi_gl__lights_chunks[] = {
    SSGI_GL__FETCH, &ssgi_gl__noise_tile4, &ssgi_gl__noise_gradient, &ssgi_gl__noise_texture, SSGI_GL__TEST, &ssgi_gl__segment, &ssgi_gl__shadow_map, &ssgi_gl__lights_head, &ssgi_gl__lights_noise, &ssgi_gl__main_depth,
    &ssgi_gl__main_layer, &ssgi_gl__lights_begin, &ssgi_gl__lights_lift, &ssgi_gl__lights_loop, &ssgi_gl__lights_cosine, &ssgi_gl__lights_reach, &ssgi_gl__lights_map, &ssgi_gl__lights_fill,
    &ssgi_gl__lights_limit, &ssgi_gl__lights_segment, &ssgi_gl__lights_tail, &ssgi_gl__lights_write, &ssgi_gl__lights_add, &ssgi_gl__lights_end, NULL };
static const ssgi_gl__row *const ssgi_gl__lights_rows[] = {
    &ssgi_gl__c_points, SSGI_GL__DEEP_C, &ssgi_gl__c_receiver, &ssgi_gl__p_project, SSGI_GL__READS, &ssgi_gl__p_radius, &ssgi_gl__p_offset, &ssgi_gl__thickness, &ssgi_gl__p_phase,
    &ssgi_gl__steepest, &ssgi_gl__lights_row, &ssgi_gl__rotation, SSGI_GL__CAMERAS, SSGI_GL__MAPS, &ssgi_gl__views_tex, &ssgi_gl__lights_tex, &ssgi_gl__shadow_tex, &ssgi_gl__added_tex, &ssgi_gl__lights_out, NULL };

static const ssgi_gl__chunk *const ssgi_gl__senders_chunks[] = {
    SSGI_GL__FETCH, &ssgi_gl__octahedron, &ssgi_gl__pack, &ssgi_gl__lights_head, &ssgi_gl__main_depth, &ssgi_gl__main_layer, &ssgi_gl__senders_head, &ssgi_gl__senders_first,
    &ssgi_gl__senders_hidden, &ssgi_gl__senders_lit, &ssgi_gl__senders_direct, &ssgi_gl__senders_tail, NULL };
static const ssgi_gl__row *const ssgi_gl__senders_rows[] = {
    &ssgi_gl__c_receiver, SSGI_GL__READS, &ssgi_gl__rotation, SSGI_GL__MAPS, &ssgi_gl__albedo_tex, &ssgi_gl__albedos_tex, &ssgi_gl__s_light_tex, &ssgi_gl__direct_tex, &ssgi_gl__sender_out, NULL };

#define SSGI_GL__FIELD_OF &ssgi_gl__field_texel16, &ssgi_gl__field_texel8, &ssgi_gl__field_atlas, &ssgi_gl__field_cubes, &ssgi_gl__cap_closed, &ssgi_gl__cap_whole, &ssgi_gl__cap_table, &ssgi_gl__field_at, \
                        &ssgi_gl__field_head, &ssgi_gl__field_vector, &ssgi_gl__field_vector_closed, &ssgi_gl__field_vector_table, &ssgi_gl__field_angle, &ssgi_gl__field_tail
static const ssgi_gl__chunk *const ssgi_gl__caster_chunks[] = { SSGI_GL__PROJECTIONS(sphere), &ssgi_gl__caster_main, NULL };
static const ssgi_gl__row *const ssgi_gl__caster_rows[] = { &ssgi_gl__project, &ssgi_gl__frame_size, &ssgi_gl__front_row, &ssgi_gl__casters_tex, NULL };
static const ssgi_gl__chunk *const ssgi_gl__field_chunks[] = {
    &ssgi_gl__field_in, SSGI_GL__FETCH, &ssgi_gl__object_texture, &ssgi_gl__object_custom, SSGI_GL__FIELD_OF, &ssgi_gl__lights_head, &ssgi_gl__main_depth, &ssgi_gl__field_main, &ssgi_gl__field_own,
    &ssgi_gl__field_end, &ssgi_gl__lights_end, NULL };
#define SSGI_GL__FIELD_MAPS &ssgi_gl__fields_tex, &ssgi_gl__fields8_tex, &ssgi_gl__cube_tex, &ssgi_gl__centre_tex, &ssgi_gl__cap_tex
static const ssgi_gl__row *const ssgi_gl__field_rows[] = { SSGI_GL__READS, &ssgi_gl__rotation, SSGI_GL__MAPS, SSGI_GL__FIELD_MAPS, &ssgi_gl__objects_tex, &ssgi_gl__factor_out, NULL };

/* The shading of surfels is the loop of lights over their own points. */
#define SSGI_GL__SENT   &ssgi_gl__map_far, &ssgi_gl__octahedron_open, &ssgi_gl__open, &ssgi_gl__shadow_map, &ssgi_gl__surfel_lit, &ssgi_gl__surfel_lit_open, &ssgi_gl__lights_loop, &ssgi_gl__lights_cosine, &ssgi_gl__lights_map, &ssgi_gl__lights_tail, &ssgi_gl__surfel_lit_end
#define SSGI_GL__SENT_ROWS &ssgi_gl__steepest, &ssgi_gl__lights_row, &ssgi_gl__lit_rotation, &ssgi_gl__lights_tex, &ssgi_gl__shadow_tex, &ssgi_gl__open_tex
#define SSGI_GL__SHELL  SSGI_GL__PROJECTIONS(sphere), &ssgi_gl__shell_head, &ssgi_gl__shell_one, &ssgi_gl__shell_sent, &ssgi_gl__shell_peak, &ssgi_gl__shell_reach, &ssgi_gl__shell_bounds, &ssgi_gl__shell_weighted, \
                        &ssgi_gl__shell_enlarged, &ssgi_gl__shell_end
#define SSGI_GL__SHELL_ROWS &ssgi_gl__c_levels, &ssgi_gl__project, &ssgi_gl__frame_size, &ssgi_gl__front_row, &ssgi_gl__radius, &ssgi_gl__epsilon, &ssgi_gl__exponent, &ssgi_gl__level_row
static const ssgi_gl__chunk *const ssgi_gl__nothing_chunks[] = { &ssgi_gl__nothing, NULL };
static const ssgi_gl__chunk *const ssgi_gl__patch_vertex_chunks[] = { &ssgi_gl__patch_vertex, NULL };
static const ssgi_gl__row *const ssgi_gl__patch_vertex_rows[] = { &ssgi_gl__mesh_row, &ssgi_gl__in_position, &ssgi_gl__in_normal, &ssgi_gl__in_colour, NULL };
static const ssgi_gl__chunk *const ssgi_gl__patch_control_chunks[] = { &ssgi_gl__far, &ssgi_gl__patch_levels, SSGI_GL__PROJECTIONS(patch_radius), &ssgi_gl__patch_control, NULL };
static const ssgi_gl__row *const ssgi_gl__patch_control_rows[] = { &ssgi_gl__wide_unproject, &ssgi_gl__frame_size, &ssgi_gl__radius, &ssgi_gl__surfel_row, &ssgi_gl__more_row, NULL };
static const ssgi_gl__chunk *const ssgi_gl__patch_points_chunks[] = {
    &ssgi_gl__patch_hash, SSGI_GL__SENT, &ssgi_gl__patch_points, &ssgi_gl__points_sent_lit, &ssgi_gl__points_sent_custom, &ssgi_gl__patch_kept, NULL };
static const ssgi_gl__row *const ssgi_gl__patch_points_rows[] = { &ssgi_gl__surfel_row, SSGI_GL__SENT_ROWS, &ssgi_gl__kept0, &ssgi_gl__kept1, &ssgi_gl__kept2, NULL };
static const ssgi_gl__chunk *const ssgi_gl__buffer_chunks[] = {
    SSGI_GL__SENT, &ssgi_gl__buffer_points, &ssgi_gl__points_sent_lit, &ssgi_gl__points_sent_custom, &ssgi_gl__buffer_kept, NULL };
static const ssgi_gl__row *const ssgi_gl__buffer_rows[] = { SSGI_GL__SENT_ROWS, &ssgi_gl__in_surfel0, &ssgi_gl__in_surfel1, &ssgi_gl__in_surfel2, &ssgi_gl__kept0, &ssgi_gl__kept1, &ssgi_gl__kept2, NULL };

static const ssgi_gl__chunk *const ssgi_gl__shuffle_chunks[] = { SSGI_GL__FETCH, &ssgi_gl__octahedron, &ssgi_gl__deal_random, &ssgi_gl__deal_fixed, &ssgi_gl__shuffle_main, NULL };
static const ssgi_gl__row *const ssgi_gl__shuffle_rows[] = { SSGI_GL__PLACES, &ssgi_gl__rotation, &ssgi_gl__level_row, SSGI_GL__MAPS, &ssgi_gl__shuffled_out, NULL };

static const ssgi_gl__chunk *const ssgi_gl__splat_vertex_chunks[] = { SSGI_GL__SHELL, &ssgi_gl__splat_vertex, NULL };
static const ssgi_gl__row *const ssgi_gl__splat_vertex_rows[] = { SSGI_GL__SHELL_ROWS, &ssgi_gl__in_surfel0, &ssgi_gl__in_surfel1, &ssgi_gl__in_surfel2, NULL };
static const ssgi_gl__chunk *const ssgi_gl__splat_geometry_chunks[] = { &ssgi_gl__splat_geometry_in, SSGI_GL__SHELL, &ssgi_gl__splat_geometry, NULL };
static const ssgi_gl__row *const ssgi_gl__splat_geometry_rows[] = { SSGI_GL__SHELL_ROWS, NULL };
static const ssgi_gl__chunk *const ssgi_gl__splat_chunks[] = {
    SSGI_GL__PROJECTIONS(toward), &ssgi_gl__octahedron_map, &ssgi_gl__environment, &ssgi_gl__splat_head, &ssgi_gl__splat_normal, &ssgi_gl__splat_front, &ssgi_gl__splat_both, &ssgi_gl__splat_near, &ssgi_gl__splat_form, &ssgi_gl__splat_soft, &ssgi_gl__splat_occludes,
    &ssgi_gl__splat_hides, &ssgi_gl__splat_brings, &ssgi_gl__splat_mirrors, &ssgi_gl__splat_scatters, NULL };
static const ssgi_gl__row *const ssgi_gl__splat_rows[] = {
    &ssgi_gl__c_near, &ssgi_gl__soft_radius, &ssgi_gl__rotation, &ssgi_gl__dipole_row, &ssgi_gl__exponent, &ssgi_gl__shuffled_tex, &ssgi_gl__map_tex, &ssgi_gl__levels_out, &ssgi_gl__levels4_out, NULL };

static const ssgi_gl__chunk *const ssgi_gl__unshuffle_chunks[] = { &ssgi_gl__deal_random, &ssgi_gl__deal_fixed, &ssgi_gl__unshuffle_main, &ssgi_gl__unshuffle_grey, &ssgi_gl__unshuffle_colour, NULL };
static const ssgi_gl__row *const ssgi_gl__unshuffle_rows[] = { &ssgi_gl__frame_size, &ssgi_gl__level_row, &ssgi_gl__levels_tex, &ssgi_gl__levels_out, &ssgi_gl__levels4_out, NULL };

static const ssgi_gl__chunk *const ssgi_gl__smooth_chunks[] = {
    SSGI_GL__FETCH, SSGI_GL__PROJECTIONS(footprint), SSGI_GL__PROJECTIONS(plane), &ssgi_gl__smooth_head, &ssgi_gl__smooth_normals, &ssgi_gl__smooth_tail, &ssgi_gl__smooth_grey, &ssgi_gl__smooth_colour, NULL };
static const ssgi_gl__row *const ssgi_gl__smooth_rows[] = { &ssgi_gl__c_axis, SSGI_GL__PLACES, &ssgi_gl__rotation, &ssgi_gl__level_row, SSGI_GL__MAPS, &ssgi_gl__levels_tex, &ssgi_gl__levels_out, &ssgi_gl__levels4_out, NULL };

static const ssgi_gl__chunk *const ssgi_gl__sum_chunks[] = {
    SSGI_GL__FETCH, &ssgi_gl__octahedron, &ssgi_gl__open, &ssgi_gl__sum_adds, &ssgi_gl__sum_shares, &ssgi_gl__lights_head, &ssgi_gl__main_depth, &ssgi_gl__sum_levels, &ssgi_gl__sum_occludes, &ssgi_gl__sum_hides,
    &ssgi_gl__sum_brings, &ssgi_gl__sum_mirrors, &ssgi_gl__sum_scatters, NULL };
static const ssgi_gl__row *const ssgi_gl__sum_rows[] = {
    &ssgi_gl__c_levels, SSGI_GL__READS, &ssgi_gl__rotation, &ssgi_gl__level_row, SSGI_GL__MAPS, &ssgi_gl__open_tex, &ssgi_gl__levels_tex, &ssgi_gl__sum_ao_out, &ssgi_gl__sum_light_out, &ssgi_gl__sum_bounce_out,
    &ssgi_gl__sum_specular_out, &ssgi_gl__sum_scatter_out, NULL };

static const ssgi_gl__chunk *const ssgi_gl__blur_chunks[] = {
    SSGI_GL__FETCH, SSGI_GL__PROJECTIONS(footprint), SSGI_GL__PROJECTIONS(plane), SSGI_GL__SH, SSGI_GL__SH_ADD, SSGI_GL__VECTOR_TYPE, &ssgi_gl__vectors_none, SSGI_GL__LOAD, SSGI_GL__STORE, &ssgi_gl__blur_head, &ssgi_gl__blur_full_grey, &ssgi_gl__blur_full_colour, &ssgi_gl__blur_half_grey,
    &ssgi_gl__blur_half_colour, &ssgi_gl__blur_full_vectors, &ssgi_gl__blur_half_vectors, &ssgi_gl__blur_centre, &ssgi_gl__blur_normal, &ssgi_gl__blur_loop, &ssgi_gl__blur_tap_full, &ssgi_gl__blur_tap_half, &ssgi_gl__blur_tap_grey,
    &ssgi_gl__blur_tap_colour, &ssgi_gl__blur_tap_vectors, &ssgi_gl__weight_gaussian, &ssgi_gl__weight_bilateral, &ssgi_gl__weight_box, &ssgi_gl__weight_tent, &ssgi_gl__weight_normals, &ssgi_gl__blur_tail, &ssgi_gl__blur_tail_vectors,
    &ssgi_gl__blur_grey, &ssgi_gl__blur_colour, NULL };
static const ssgi_gl__row *const ssgi_gl__blur_rows[] = {
    &ssgi_gl__c_filter, SSGI_GL__READS, &ssgi_gl__near_radius, &ssgi_gl__rotation, SSGI_GL__MAPS, &ssgi_gl__ao_tex, &ssgi_gl__light_tex, SSGI_GL__OF_VECTORS(t), &ssgi_gl__blurred_out,
    &ssgi_gl__colour_out, SSGI_GL__OF_VECTORS(o), NULL };

static const ssgi_gl__chunk *const ssgi_gl__survey_chunks[] = {
    SSGI_GL__FETCH, SSGI_GL__GATHER, SSGI_GL__PROJECTIONS(project), SSGI_GL__PROJECTIONS(footprint), &ssgi_gl__lift, &ssgi_gl__survey_main, NULL };
static const ssgi_gl__row *const ssgi_gl__survey_rows[] = {
    &ssgi_gl__c_samples, &ssgi_gl__project, SSGI_GL__PLACES, &ssgi_gl__radius, &ssgi_gl__offset, &ssgi_gl__phase, &ssgi_gl__rotation, SSGI_GL__MAPS, &ssgi_gl__survey_out, NULL };

typedef struct ssgi_gl__pass {
    const char *name;
    int pass, variant;                      /* the desc that it is for; variant: of search or tessellate; -1: any */
    const ssgi_gl__chunk *const *chunks[SSGI_GL_STAGES];        /* NULL: the pass has no such stage */
    const ssgi_gl__row *const *rows[SSGI_GL_STAGES];
} ssgi_gl__pass;

#define SSGI_GL__PLAIN_PASS(name) { ssgi_gl__vertex_chunks, ssgi_gl__##name##_chunks, NULL, NULL, NULL }, { ssgi_gl__vertex_rows, ssgi_gl__##name##_rows, NULL, NULL, NULL }
static const ssgi_gl__pass ssgi_gl__passes[] = {
    { "ssao", SSGI_GL_SSAO, -1, SSGI_GL__PLAIN_PASS(ssao) },
    { "hsao", SSGI_GL_HSAO, SSGI_GL_SLICES, SSGI_GL__PLAIN_PASS(slices) },
    { "hsao", SSGI_GL_HSAO, SSGI_GL_MARCH, SSGI_GL__PLAIN_PASS(march) },
    { "ssdo", SSGI_GL_SSDO, -1, SSGI_GL__PLAIN_PASS(ssdo) },
    { "s3ho", SSGI_GL_S3HO, -1, SSGI_GL__PLAIN_PASS(s3ho) },
    { "lights", SSGI_GL_LIGHTS, -1, SSGI_GL__PLAIN_PASS(lights) },
    { "senders", SSGI_GL_SENDERS, -1, SSGI_GL__PLAIN_PASS(senders) },
    { "shade", SSGI_GL_SHADE, -1, SSGI_GL__PLAIN_PASS(shade) },
    { "field", SSGI_GL_FIELD, -1, { ssgi_gl__caster_chunks, ssgi_gl__field_chunks, NULL, NULL, NULL }, { ssgi_gl__caster_rows, ssgi_gl__field_rows, NULL, NULL, NULL } },
    { "surfels", SSGI_GL_SURFELS, 0, { ssgi_gl__buffer_chunks, ssgi_gl__nothing_chunks, NULL, NULL, NULL }, { ssgi_gl__buffer_rows, ssgi_gl__vertex_rows, NULL, NULL, NULL } },
    { "surfels", SSGI_GL_SURFELS, 1, { ssgi_gl__patch_vertex_chunks, ssgi_gl__nothing_chunks, ssgi_gl__patch_control_chunks, ssgi_gl__patch_points_chunks, NULL },
                                     { ssgi_gl__patch_vertex_rows, ssgi_gl__vertex_rows, ssgi_gl__patch_control_rows, ssgi_gl__patch_points_rows, NULL } },
    { "shuffle", SSGI_GL_SHUFFLE, -1, SSGI_GL__PLAIN_PASS(shuffle) },
    { "splat", SSGI_GL_SPLAT, 0, { ssgi_gl__splat_vertex_chunks, ssgi_gl__splat_chunks, NULL, NULL, NULL }, { ssgi_gl__splat_vertex_rows, ssgi_gl__splat_rows, NULL, NULL, NULL } },
    { "splat", SSGI_GL_SPLAT, 1, { ssgi_gl__patch_vertex_chunks, ssgi_gl__splat_chunks, ssgi_gl__patch_control_chunks, ssgi_gl__patch_points_chunks, ssgi_gl__splat_geometry_chunks },
                                 { ssgi_gl__patch_vertex_rows, ssgi_gl__splat_rows, ssgi_gl__patch_control_rows, ssgi_gl__patch_points_rows, ssgi_gl__splat_geometry_rows } },
    { "unshuffle", SSGI_GL_UNSHUFFLE, -1, SSGI_GL__PLAIN_PASS(unshuffle) },
    { "smooth", SSGI_GL_SMOOTH, -1, SSGI_GL__PLAIN_PASS(smooth) },
    { "sum", SSGI_GL_SUM, -1, SSGI_GL__PLAIN_PASS(sum) },
    { "blur", SSGI_GL_BLUR, -1, SSGI_GL__PLAIN_PASS(blur) },
    { "survey", SSGI_GL_SURVEY, -1, SSGI_GL__PLAIN_PASS(survey) }
};
enum { SSGI_GL__ROWS = (int)(sizeof ssgi_gl__passes / sizeof ssgi_gl__passes[0]) };

static const ssgi_gl__pass *ssgi_gl__find(const ssgi_gl_desc *d)
{
    int i;
    for (i = 0; i < SSGI_GL__ROWS; ++i)
        if (ssgi_gl__passes[i].pass == d->pass && (ssgi_gl__passes[i].variant < 0 || ssgi_gl__passes[i].variant == (d->pass == SSGI_GL_HSAO ? d->search : d->tessellate))) return &ssgi_gl__passes[i];
    return NULL;
}

/* ==== >>desc (implementation) ===================================================================================== */

static ssgi_result ssgi_gl__bad(const char **why, const char *sentence)
{
    if (why) *why = sentence;
    return SSGI_BAD_ARGUMENT;
}

typedef struct ssgi_gl__field { size_t offset; int most; const char *sentence; } ssgi_gl__field;

/* Every int of ssgi_gl_desc, in order: 0 .. most. */
#define SSGI_GL__F(field, most, text) { offsetof(ssgi_gl_desc, field), most, "desc." #field ": must be " text }
static const ssgi_gl__field ssgi_gl__fields[] = {
    SSGI_GL__F(pass, SSGI_GL_PASSES - 1, "a pass, SSGI_GL_SSAO .."),
    SSGI_GL__F(dialect, SSGI_GL_DIALECTS - 1, "a dialect, SSGI_GL_330 .."),
    SSGI_GL__F(orthographic, 1, "0 or 1"),
    SSGI_GL__F(depth, SSGI_GL_DEPTH_CUSTOM, "SSGI_GL_DEPTH_WINDOW, _LINEAR or _CUSTOM"),
    SSGI_GL__F(normal, SSGI_GL_NORMAL_CUSTOM, "SSGI_GL_NORMAL_SIGNED, _UNSIGNED, _OCTAHEDRAL, _FROM_DEPTH or _CUSTOM"),
    SSGI_GL__F(world_normals, 1, "0 or 1"),
    SSGI_GL__F(noise, SSGI_GL_NOISE_TEXTURE, "SSGI_GL_NOISE_GRADIENT, _TILE4 or _TEXTURE"),
    SSGI_GL__F(samples, 64, "0..64"),
    SSGI_GL__F(search, SSGI_GL_MARCH, "SSGI_GL_SLICES or SSGI_GL_MARCH"),
    SSGI_GL__F(directions, 32, "0..32"),
    SSGI_GL__F(steps, 64, "0..64"),
    SSGI_GL__F(normal_rays, 8, "0..8"),
    SSGI_GL__F(hard, 1, "0 or 1"),
    SSGI_GL__F(thin, 1, "0 or 1"),
    SSGI_GL__F(falloff, SSGI_GL_FALLOFF_CUBE, "SSGI_GL_FALLOFF_LINEAR, _SQUARE or _CUBE"),
    SSGI_GL__F(kernel, 1, "0 or 1"),
    SSGI_GL__F(fade, SSGI_GL_FADE_LAMBDA_ENDED, "SSGI_GL_FADE_NONE, _SMOOTH, _LAMBDA or _LAMBDA_ENDED"),
    SSGI_GL__F(range, 1, "0 or 1"),
    SSGI_GL__F(layers, 8, "0..8"),
    SSGI_GL__F(views, 4, "0..4"),
    SSGI_GL__F(view_layers, 8, "0..8"),
    SSGI_GL__F(receiver, 7, "0..7"),
    SSGI_GL__F(environment, SSGI_GL_ENVIRONMENT_MAP, "SSGI_GL_ENVIRONMENT_NONE, _SH or _MAP"),
    SSGI_GL__F(bounce, SSGI_GL_BOUNCE_DISC, "SSGI_GL_BOUNCE_NONE, _SOLID_ANGLE, _PATCH or _DISC"),
    SSGI_GL__F(bands, 4, "0..4"),
    SSGI_GL__F(packed, 1, "0 or 1"),
    SSGI_GL__F(transfer, SSGI_GL_TRANSFER_REFLECTED, "SSGI_GL_TRANSFER_FREE, _BOTH or _REFLECTED"),
    SSGI_GL__F(shaded, 1, "0 or 1"),
    SSGI_GL__F(exact, 1, "0 or 1"),
    SSGI_GL__F(shading, SSGI_GL_SHADING_BENT, "SSGI_GL_SHADING_HARMONICS, _BENT_NORMAL, _BENT_CONE or _BENT"),
    SSGI_GL__F(lamps, 1, "0 or 1"),
    SSGI_GL__F(albedo, 1, "0 or 1"),
    SSGI_GL__F(two_sided, 1, "0 or 1"),
    SSGI_GL__F(shadow, SSGI_GL_SHADOW_NONE, "SSGI_GL_SHADOW_SEGMENT, _MAP, _FILL or _NONE"),
    SSGI_GL__F(accumulate, 1, "0 or 1"),
    SSGI_GL__F(radiance, SSGI_GL_RADIANCE_ALBEDO, "SSGI_GL_RADIANCE_LIGHT, _DIRECT, _BOTH or _ALBEDO"),
    SSGI_GL__F(storage, SSGI_GL_STORAGE_CUBE, "SSGI_GL_STORAGE_ATLAS or _CUBE"),
    SSGI_GL__F(measure, SSGI_FIELD_SOLID_ANGLE, "SSGI_FIELD_VECTOR or _SOLID_ANGLE"),
    SSGI_GL__F(eight_bits, 1, "0 or 1"),
    SSGI_GL__F(cap, SSGI_GL_CAP_TABLE, "SSGI_GL_CAP_CLOSED or _TABLE"),
    SSGI_GL__F(objects, SSGI_GL_OBJECTS_CUSTOM, "SSGI_GL_OBJECTS_NONE, _TEXTURE or _CUSTOM"),
    SSGI_GL__F(effect, SSGI_GL_EFFECT_SCATTER, "SSGI_GL_EFFECT_OCCLUSION, _LIGHT, _BOUNCE, _SPECULAR or _SCATTER"),
    SSGI_GL__F(levels, SSGI_SPLAT_LEVELS, "0..7"),
    SSGI_GL__F(fixed, 1, "0 or 1"),
    SSGI_GL__F(tessellate, 1, "0 or 1"),
    SSGI_GL__F(sends, SSGI_GL_SENDS_CUSTOM, "SSGI_GL_SENDS_COLOUR, _LIGHTS or _CUSTOM"),
    SSGI_GL__F(enlarge, 1, "0 or 1"),
    SSGI_GL__F(closely, 16, "0..16"),
    SSGI_GL__F(overlap, SSGI_GL_OVERLAP_ADD, "SSGI_GL_OVERLAP_SHARE or _ADD"),
    SSGI_GL__F(axis, 1, "0 or 1"),
    SSGI_GL__F(half, 1, "0 or 1"),
    SSGI_GL__F(colour, SSGI_GL_VECTORS, "SSGI_GL_GREY, _COLOUR or _VECTORS"),
    SSGI_GL__F(filter, SSGI_GL_GAUSSIAN, "SSGI_GL_BILATERAL or SSGI_GL_GAUSSIAN"),
    SSGI_GL__F(filter_radius, 4, "0..4"),
    SSGI_GL__F(filter_normals, 1, "0 or 1"),
    SSGI_GL__F(lines, 1, "0 or 1")
};

typedef struct ssgi_gl__dialect { const char *name, *version; int es, bindings, halves, tessellation; } ssgi_gl__dialect;    /* halves: packHalf2x16 */
static const ssgi_gl__dialect ssgi_gl__dialects[] = {
    { "330", "#version 330 core\n", 0, 0, 0, 0 }, { "410", "#version 410 core\n", 0, 0, 0, 1 }, { "450", "#version 450 core\n", 0, 1, 1, 1 },
    { "300es", "#version 300 es\n", 1, 0, 1, 0 }, { "310es", "#version 310 es\n", 1, 1, 1, 0 }, { "320es", "#version 320 es\n", 1, 1, 1, 1 }
};

static int ssgi_gl__get(const ssgi_gl_desc *d, size_t offset)
{
    int value;
    memcpy(&value, (const char *)d + offset, sizeof value);
    return value;
}

/* Vectors that are read or written; ssdo makes one of its own besides. */
static int ssgi_gl__stored(const ssgi_gl_desc *d)
{
    return (d->pass == SSGI_GL_S3HO && !d->shaded) || d->pass == SSGI_GL_SHADE || (d->pass == SSGI_GL_BLUR && d->colour == SSGI_GL_VECTORS);
}

SSGI_DEF ssgi_result ssgi_gl_check(const ssgi_gl_desc *desc, const char **why)
{
    size_t i;
    if (!desc) return ssgi_gl__bad(why, "desc: must not be NULL");
    for (i = 0; i < sizeof ssgi_gl__fields / sizeof ssgi_gl__fields[0]; ++i) {
        int value = ssgi_gl__get(desc, ssgi_gl__fields[i].offset);
        if (value < 0 || value > ssgi_gl__fields[i].most) return ssgi_gl__bad(why, ssgi_gl__fields[i].sentence);
    }
    if (desc->normal_rays && desc->pass == SSGI_GL_HSAO && desc->search == SSGI_GL_SLICES)
        return ssgi_gl__bad(why, "desc.normal_rays: slices see what is above the horizon themselves; only SSGI_GL_MARCH has normal rays");
    if (desc->world_normals && desc->normal == SSGI_GL_NORMAL_FROM_DEPTH)
        return ssgi_gl__bad(why, "desc.world_normals: normals from depth are in view space");
    if (desc->half && desc->pass == SSGI_GL_BLUR && desc->filter == SSGI_GL_GAUSSIAN)
        return ssgi_gl__bad(why, "desc.filter: only SSGI_GL_BILATERAL brings half size to full");
    if (desc->pass == SSGI_GL_SSDO && desc->environment == SSGI_GL_ENVIRONMENT_NONE && desc->bounce == SSGI_GL_BOUNCE_NONE)
        return ssgi_gl__bad(why, "desc.environment: ssdo needs an environment, a bounce or both");
    if (ssgi_gl__stored(desc) && desc->transfer && !desc->packed)
        return ssgi_gl__bad(why, "desc.packed: three vectors need it: more floats than there are targets");
    if (desc->pass == SSGI_GL_SHADE && desc->shading && (desc->bands == 1 || desc->transfer))
        return ssgi_gl__bad(why, "desc.shading: a mean direction is had from one vector of two bands or more: desc.bands, desc.transfer");
    if (desc->receiver && desc->receiver >= desc->layers)
        return ssgi_gl__bad(why, "desc.receiver: must be below desc.layers");
    if (desc->receiver && desc->normal == SSGI_GL_NORMAL_FROM_DEPTH)
        return ssgi_gl__bad(why, "desc.receiver: hidden layers need their normals");
    if (desc->tessellate && (desc->pass == SSGI_GL_SURFELS || desc->pass == SSGI_GL_SPLAT) && !ssgi_gl__dialects[desc->dialect].tessellation)
        return ssgi_gl__bad(why, "desc.tessellate: needs a dialect with tessellation and geometry shaders: SSGI_GL_410, _450 or _320ES");
    if (!desc->fetch && desc->sends == SSGI_GL_SENDS_CUSTOM)
        return ssgi_gl__bad(why, "desc.fetch: must hold ssgi_custom_surfel when sends is CUSTOM");
    if (!desc->fetch && (desc->depth == SSGI_GL_DEPTH_CUSTOM || desc->normal == SSGI_GL_NORMAL_CUSTOM || desc->objects == SSGI_GL_OBJECTS_CUSTOM))
        return ssgi_gl__bad(why, "desc.fetch: must hold ssgi_custom_depth, _normal or _object when depth, normal or objects is CUSTOM");
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_gl_preset(ssgi_gl_desc *desc, int preset, const char **why)
{
    static const struct counts { unsigned char half, samples, directions, steps, rays, thin, faded; } table[5][3] = {    /* FAST, BALANCED, BEST */
        { { 0, 8, 0, 1, 0, 1, 0 }, { 0, 16, 0, 1, 0, 1, 0 }, { 0, 32, 0, 1, 0, 1, 0 } },     /* ssao */
        { { 1, 0, 1, 3, 0, 0, 0 }, { 1, 0, 2, 6, 0, 0, 0 }, { 0, 0, 3, 8, 0, 0, 0 } },       /* slices */
        { { 0, 0, 4, 6, 0, 1, 0 }, { 0, 0, 6, 9, 1, 1, 0 }, { 0, 0, 8, 18, 2, 1, 0 } },      /* march: rays past a solid foreground would all end on it */
        { { 1, 4, 0, 4, 0, 1, 1 }, { 0, 4, 0, 4, 0, 1, 1 }, { 0, 8, 0, 6, 0, 1, 1 } },       /* ssdo, s3ho: points along a direction find what single ones miss, faded by where it is seen */
        { { 0, 4, 0, 1, 0, 1, 0 }, { 0, 8, 0, 1, 0, 1, 0 }, { 0, 16, 0, 1, 0, 1, 0 } } };    /* lights */
    const struct counts *c;
    ssgi_result r = ssgi_gl_check(desc, why);
    if (r != SSGI_OK) return r;
    if (preset < SSGI_GL_FAST || preset > SSGI_GL_BEST) return ssgi_gl__bad(why, "preset: must be SSGI_GL_FAST, _BALANCED or _BEST");
    if ((desc->pass >= SSGI_GL_FIELD && desc->pass <= SSGI_GL_SUM) || desc->pass == SSGI_GL_SURVEY) return SSGI_OK;        /* what trades cost for accuracy is not in the text: bakes, sizes of surfels, epsilon */
    c = &table[desc->pass == SSGI_GL_SSAO ? 0 : desc->pass == SSGI_GL_SSDO || desc->pass == SSGI_GL_S3HO || desc->pass == SSGI_GL_SHADE ? 3 : desc->pass == SSGI_GL_LIGHTS ? 4 : desc->search == SSGI_GL_SLICES ? 1 : 2][preset];
    desc->half = c->half;
    desc->steps = c->steps;
    if (c->samples) {
        desc->samples = c->samples;
        desc->range = c->faded;
        desc->fade = c->faded ? SSGI_GL_FADE_SMOOTH : SSGI_GL_FADE_NONE;
    } else {
        desc->directions = c->directions;
        desc->normal_rays = c->rays;
    }
    desc->thin = c->thin;
    desc->filter = SSGI_GL_BILATERAL;
    desc->filter_radius = 1;
    desc->noise = SSGI_GL_NOISE_GRADIENT;
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_gl_plan(ssgi_gl_desc *desc, const ssgi_plan *plan, const char **why)
{
    static const int passes[] = { 0, SSGI_GL_HSAO, SSGI_GL_HSAO, SSGI_GL_SSDO, SSGI_GL_S3HO, SSGI_GL_SPLAT, SSGI_GL_FIELD };
    ssgi_gl_desc d;
    ssgi_result r = ssgi_gl_check(desc, why);
    if (r != SSGI_OK) return r;
    if (!plan || plan->method <= SSGI_PLAN_NOTHING || plan->method > SSGI_PLAN_FIELD) return ssgi_gl__bad(why, "plan: must not be NULL, and of something");
    d = *desc;
    d.pass = passes[plan->method];
    d.search = plan->method == SSGI_PLAN_MARCH ? SSGI_GL_MARCH : SSGI_GL_SLICES;
    if (d.pass == SSGI_GL_SSDO && !d.environment) d.environment = SSGI_GL_ENVIRONMENT_MAP;
    r = ssgi_gl_preset(&d, SSGI_GL_BALANCED, why);
    if (r != SSGI_OK) return r;
    d.half = plan->half;
    d.directions = plan->directions;
    d.samples = plan->samples;
    d.steps = plan->steps;
    d.bands = plan->bands;
    d.layers = plan->layers;
    d.views = plan->cameras;
    d.levels = plan->levels;
    d.filter_radius = plan->filter;
    if (d.pass == SSGI_GL_S3HO) d.shaded = d.exact = 1;
    r = ssgi_gl_check(&d, why);
    if (r == SSGI_OK) *desc = d;
    return r;
}

/* The desc with its defaults in place. */
static ssgi_gl_desc ssgi_gl__resolve(const ssgi_gl_desc *desc)
{
    ssgi_gl_desc d = *desc;
    if (!d.samples) d.samples = d.pass == SSGI_GL_LIGHTS ? 8 : d.pass == SSGI_GL_SURVEY ? 32 : 16;
    if (!d.directions) d.directions = d.search == SSGI_GL_MARCH ? 6 : 1;
    if (!d.steps) d.steps = d.pass == SSGI_GL_HSAO ? 6 : 1;
    if (!d.filter_radius) d.filter_radius = d.filter == SSGI_GL_GAUSSIAN ? 2 : 1;
    if (!d.bands) d.bands = d.pass == SSGI_GL_SSDO ? 3 : 4;
    if (!d.levels) d.levels = 5;
    if (!d.layers) d.layers = 1;
    if (!d.view_layers) d.view_layers = 1;
    return d;
}

static ssgi_gl__set ssgi_gl__features(const ssgi_gl_desc *d)
{
    static const uint64_t depth_kind[] = { SSGI_GL__D_WINDOW | SSGI_GL__D_TEXTURE, SSGI_GL__D_LINEAR | SSGI_GL__D_TEXTURE, SSGI_GL__D_CUSTOM };
    static const uint64_t normal_kind[] = { SSGI_GL__N_SIGNED | SSGI_GL__N_TEXTURE, SSGI_GL__N_UNSIGNED | SSGI_GL__N_TEXTURE, SSGI_GL__N_OCTA | SSGI_GL__N_TEXTURE,
                                            SSGI_GL__N_DEPTH | SSGI_GL__TOWARD, SSGI_GL__N_CUSTOM };
    static const uint64_t noise_kind[] = { SSGI_GL__NOISE_GRADIENT, SSGI_GL__NOISE_TILE4, SSGI_GL__NOISE_TEXTURE };
    static const uint64_t falloff_kind[] = { SSGI_GL__UNIFORM, SSGI_GL__SQUARE, SSGI_GL__CUBE };
    static const uint64_t fade_kind[] = { 0, SSGI_GL__SMOOTH, SSGI_GL__LAMBDA, SSGI_GL__LAMBDA | SSGI_GL__ENDED };
    static const uint64_t bounce_kind[] = { 0, SSGI_GL__SENDERS | SSGI_GL__SOLID_ANGLE, SSGI_GL__SENDERS | SSGI_GL__AREA | SSGI_GL__PATCH, SSGI_GL__SENDERS | SSGI_GL__AREA | SSGI_GL__DISC };
    static const uint64_t light_kind[] = { 0, SSGI_GL__E_LIT, SSGI_GL__E_LIT | SSGI_GL__E_MAP | SSGI_GL__WORLD | SSGI_GL__OCTAHEDRON };
    static const uint64_t shadow_kind[] = { SSGI_GL__SEGMENTS | SSGI_GL__BLOCKED, SSGI_GL__MAPS_READ, SSGI_GL__MAPS_READ | SSGI_GL__SEGMENTS | SSGI_GL__BLOCKED, 0 };
    static const uint64_t radiance_kind[] = { SSGI_GL__ALBEDO | SSGI_GL__S_LIGHT, SSGI_GL__S_DIRECT, SSGI_GL__ALBEDO | SSGI_GL__S_LIGHT | SSGI_GL__S_DIRECT, SSGI_GL__ALBEDO };
    static const uint64_t shading_kind[] = { SSGI_GL__HARMONICS, SSGI_GL__CONES, SSGI_GL__CONES, SSGI_GL__CONES };
    static const uint64_t bent_kind[] = { 0, SSGI_GL__BENT_NORMAL | SSGI_GL__I_MAP | SSGI_GL__WORLD | SSGI_GL__OCTAHEDRON, SSGI_GL__BENT_CONE | SSGI_GL__I_MAP | SSGI_GL__WORLD | SSGI_GL__OCTAHEDRON,
                                          SSGI_GL__BENT_OUT };
    static const uint64_t content_kind[] = { SSGI_GL__GREY, SSGI_GL__COLOUR, 0 };
    const int blur = d->pass == SSGI_GL_BLUR, survey = d->pass == SSGI_GL_SURVEY, hsao = d->pass == SSGI_GL_HSAO, shade = d->pass == SSGI_GL_SHADE, slices = hsao && d->search == SSGI_GL_SLICES;
    const int points = d->pass == SSGI_GL_SSAO || d->pass == SSGI_GL_SSDO || d->pass == SSGI_GL_S3HO, stored = ssgi_gl__stored(d);
    const int sized = blur || hsao || points || shade, hidden = d->receiver && (d->pass == SSGI_GL_SSDO || d->pass == SSGI_GL_LIGHTS || d->pass == SSGI_GL_SENDERS);
    const int dotted = (d->pass == SSGI_GL_S3HO && d->shaded) || (d->pass == SSGI_GL_SSDO && d->environment == SSGI_GL_ENVIRONMENT_SH) || (shade && d->shading == SSGI_GL_SHADING_HARMONICS);
    const int exact = d->exact && dotted && (d->pass == SSGI_GL_SSDO || d->transfer != SSGI_GL_TRANSFER_REFLECTED), lamps = shade && d->lamps && d->shading != SSGI_GL_SHADING_BENT;
    const int deep = d->pass >= SSGI_GL_SURFELS && d->pass <= SSGI_GL_SUM, placed = d->pass == SSGI_GL_SHUFFLE || d->pass == SSGI_GL_SMOOTH;
    const int normals = blur ? d->filter == SSGI_GL_BILATERAL : deep ? placed || (d->pass == SSGI_GL_SUM && d->effect == SSGI_GL_EFFECT_LIGHT) : !shade || exact;
    const int depth = deep ? placed || d->pass == SSGI_GL_SUM : !blur || d->half || stored || (normals && d->normal == SSGI_GL_NORMAL_FROM_DEPTH);
    ssgi_gl__set s = { { 0, 0, 0, 0 } };
    uint64_t f = (d->orthographic ? SSGI_GL__ORTHOGRAPHIC : SSGI_GL__PERSPECTIVE) | (hidden ? SSGI_GL__HIDDEN : SSGI_GL__FIRST) | (sized && d->half ? SSGI_GL__HALF : SSGI_GL__FULL);
    if (depth || normals) f |= SSGI_GL__GBUFFER;
    if (deep ? normals : !shade || lamps || exact) f |= SSGI_GL__POSITION;
    if (depth) f |= depth_kind[d->depth];
    if (normals) {
        f |= SSGI_GL__NORMALS | normal_kind[d->normal];
        if (d->normal != SSGI_GL_NORMAL_FROM_DEPTH) f |= d->world_normals ? SSGI_GL__N_WORLD | SSGI_GL__WORLD : SSGI_GL__N_VIEW;
    }
    switch (d->pass) {
    case SSGI_GL_SSAO: case SSGI_GL_SURVEY: break;
    case SSGI_GL_HSAO:
        ssgi_gl__add(&s, d->hard ? SSGI_GL__HARD : SSGI_GL__LINEAR);
        if (slices) f |= SSGI_GL__TOWARD | (d->thin ? SSGI_GL__THIN : SSGI_GL__SOLID);
        else if (d->normal_rays) ssgi_gl__add(&s, SSGI_GL__RAYS | SSGI_GL__BLOCKED);
        break;
    case SSGI_GL_SSDO:
        ssgi_gl__add(&s, bounce_kind[d->bounce]);
        ssgi_gl__add(&s, light_kind[d->environment]);
        if (d->environment == SSGI_GL_ENVIRONMENT_MAP) ssgi_gl__add(&s, SSGI_GL__I_MAP);
        if (d->bounce) ssgi_gl__add(&s, d->two_sided ? SSGI_GL__TWO_SIDED : SSGI_GL__ONE_SIDED);
        if (d->bounce > SSGI_GL_BOUNCE_SOLID_ANGLE) ssgi_gl__add(&s, SSGI_GL__FACING);
        if (d->bounce && (!d->two_sided || d->bounce > SSGI_GL_BOUNCE_SOLID_ANGLE)) f |= SSGI_GL__NORMALS_SENT;
        break;
    case SSGI_GL_S3HO:
        if (d->transfer) ssgi_gl__add(&s, SSGI_GL__SENDERS | SSGI_GL__SOLID_ANGLE | SSGI_GL__SENDER_KEPT | SSGI_GL__NORMALS_SENT | (d->two_sided ? SSGI_GL__TWO_SIDED : SSGI_GL__ONE_SIDED));
        break;
    case SSGI_GL_LIGHTS:
        ssgi_gl__add(&s, SSGI_GL__LIGHT_ROWS);
        ssgi_gl__add(&s, shadow_kind[d->shadow]);
        if (d->accumulate) ssgi_gl__add(&s, SSGI_GL__ADD);
        break;
    case SSGI_GL_SENDERS:
        ssgi_gl__add(&s, radiance_kind[d->radiance]);
        f |= SSGI_GL__OCTAHEDRON;
        break;
    case SSGI_GL_SHADE:
        ssgi_gl__add(&s, shading_kind[d->shading]);
        ssgi_gl__add(&s, bent_kind[d->shading]);
        if (d->shading == SSGI_GL_SHADING_BENT_NORMAL || d->shading == SSGI_GL_SHADING_BENT_CONE) ssgi_gl__add(&s, SSGI_GL__BENT_LIT);
        if (lamps) ssgi_gl__add(&s, SSGI_GL__LAMPS);
        if (lamps) ssgi_gl__add(&s, SSGI_GL__LIGHT_ROWS);
        if (d->shading != SSGI_GL_SHADING_BENT) {
            ssgi_gl__add(&s, SSGI_GL__SHADED);
            if (d->albedo) ssgi_gl__add(&s, SSGI_GL__ALBEDO);
        }
        break;
    case SSGI_GL_FIELD:
        ssgi_gl__add(&s, (d->storage ? SSGI_GL__CUBES : SSGI_GL__ATLAS | (d->eight_bits ? SSGI_GL__BITS8 : SSGI_GL__BITS16)) | (d->measure ? SSGI_GL__ANGLE_KEPT : SSGI_GL__VECTOR_KEPT)
                     | (d->cap ? SSGI_GL__CAP_TABLE : SSGI_GL__CAP_CLOSED) | (d->objects ? SSGI_GL__OBJECTS | (d->objects == SSGI_GL_OBJECTS_CUSTOM ? SSGI_GL__O_CUSTOM : SSGI_GL__O_TEXTURE) : 0));
        break;
    case SSGI_GL_SURFELS: case SSGI_GL_SHUFFLE: case SSGI_GL_SPLAT: case SSGI_GL_UNSHUFFLE: case SSGI_GL_SMOOTH: case SSGI_GL_SUM: {
        static const uint64_t effect_kind[] = { SSGI_GL__OCCLUDES | SSGI_GL__FORM | SSGI_GL__GREY, SSGI_GL__HIDES | SSGI_GL__FORM | SSGI_GL__COLOUR, SSGI_GL__BRINGS | SSGI_GL__FORM | SSGI_GL__COLOUR,
                                                SSGI_GL__MIRRORS | SSGI_GL__FORM | SSGI_GL__COLOUR, SSGI_GL__SCATTERS | SSGI_GL__COLOUR };
        const int splat = d->pass == SSGI_GL_SPLAT, made = d->pass == SSGI_GL_SURFELS || splat, sends = splat ? d->tessellate && d->effect > SSGI_GL_EFFECT_LIGHT : made, lit = sends && d->sends == SSGI_GL_SENDS_LIGHTS;
        if (d->pass != SSGI_GL_SURFELS && d->pass != SSGI_GL_SHUFFLE) ssgi_gl__add(&s, effect_kind[d->effect]);
        if (d->pass == SSGI_GL_SHUFFLE || d->pass == SSGI_GL_UNSHUFFLE) ssgi_gl__add(&s, d->fixed ? SSGI_GL__REGULAR : SSGI_GL__RANDOM);
        if (splat) ssgi_gl__add(&s, (d->enlarge ? SSGI_GL__ENLARGED : SSGI_GL__WEIGHTED) | (d->closely > 1 && d->effect != SSGI_GL_EFFECT_SCATTER ? SSGI_GL__NEAR : 0) | (d->effect == SSGI_GL_EFFECT_OCCLUSION && !d->hard ? SSGI_GL__SOFT : 0));
        if (d->pass == SSGI_GL_SUM) ssgi_gl__add(&s, d->overlap ? SSGI_GL__ADDS_UP : SSGI_GL__SHARES);
        if (d->pass == SSGI_GL_SMOOTH) ssgi_gl__add(&s, SSGI_GL__BILATERAL | (d->filter_normals ? SSGI_GL__F_NORMALS : 0));
        if (made) ssgi_gl__add(&s, (d->tessellate ? SSGI_GL__TESSELLATED : SSGI_GL__BUFFERED) | (lit ? SSGI_GL__S_LIT | SSGI_GL__LIGHT_ROWS : 0) | (sends && d->sends == SSGI_GL_SENDS_CUSTOM ? SSGI_GL__S_CUSTOM : 0));
        if (lit && (d->shadow == SSGI_GL_SHADOW_MAP || d->shadow == SSGI_GL_SHADOW_FILL)) ssgi_gl__add(&s, SSGI_GL__MAPS_READ);
        if (lit && d->environment) {
            ssgi_gl__add(&s, SSGI_GL__I_MAP);
            f |= SSGI_GL__WORLD | SSGI_GL__OCTAHEDRON;
        }
        if (splat && d->effect != SSGI_GL_EFFECT_SCATTER) ssgi_gl__add(&s, d->two_sided ? SSGI_GL__TWO_SIDED : SSGI_GL__ONE_SIDED);
        if (splat) ssgi_gl__add(&s, d->effect > SSGI_GL_EFFECT_LIGHT ? SSGI_GL__BY_SENT : SSGI_GL__BY_ONE);
        if (splat && d->effect == SSGI_GL_EFFECT_LIGHT) ssgi_gl__add(&s, SSGI_GL__E_MAP);
        if (d->pass == SSGI_GL_SUM && d->effect == SSGI_GL_EFFECT_LIGHT) ssgi_gl__add(&s, SSGI_GL__I_MAP);
        if ((splat || d->pass == SSGI_GL_SUM) && d->effect == SSGI_GL_EFFECT_LIGHT) f |= SSGI_GL__WORLD | SSGI_GL__OCTAHEDRON;
        if (splat && d->effect == SSGI_GL_EFFECT_SPECULAR) f |= SSGI_GL__TOWARD;
        if (d->pass == SSGI_GL_SHUFFLE) f |= SSGI_GL__OCTAHEDRON;
        if (placed) f |= SSGI_GL__INSIDE;
        if (d->pass == SSGI_GL_SMOOTH) f |= SSGI_GL__PROJECT;
        break;
    }
    default:
        ssgi_gl__add(&s, (d->filter == SSGI_GL_GAUSSIAN ? SSGI_GL__GAUSSIAN : SSGI_GL__BILATERAL) | content_kind[d->colour]);
        if (!stored) ssgi_gl__add(&s, SSGI_GL__PLAIN);
        if (d->filter == SSGI_GL_BILATERAL && d->filter_normals) ssgi_gl__add(&s, SSGI_GL__F_NORMALS);
    }
    if (stored || d->pass == SSGI_GL_S3HO || (d->pass == SSGI_GL_SSDO && d->environment == SSGI_GL_ENVIRONMENT_SH)) {
        const int bands = shade && d->shading && !lamps && d->bands > 2 ? 2 : d->bands;     /* a mean direction needs no more */
        ssgi_gl__add(&s, SSGI_GL__VECTORS | (!stored ? SSGI_GL__HARMONICS : d->packed ? SSGI_GL__PACKED : SSGI_GL__WORDS) | (d->transfer && d->pass != SSGI_GL_SSDO ? SSGI_GL__RGB : SSGI_GL__MONO)
                     | (bands > 1 ? SSGI_GL__V2 : 0) | (bands > 2 ? SSGI_GL__V3 : 0) | (bands > 3 ? SSGI_GL__V4 : 0));
        if (d->pass == SSGI_GL_SSDO || (d->pass == SSGI_GL_S3HO && d->transfer != SSGI_GL_TRANSFER_REFLECTED)) ssgi_gl__add(&s, SSGI_GL__FREE);
        if (!stored) ssgi_gl__add(&s, SSGI_GL__E_LIT);
        if (stored && !shade) ssgi_gl__add(&s, SSGI_GL__STORES);
        if (points || (exact && lamps)) ssgi_gl__add(&s, SSGI_GL__COSINE);
        if (lamps || !(shade || (blur && !d->half))) f |= SSGI_GL__LOBES;
        if (stored && d->packed) ssgi_gl__add(&s, (ssgi_gl__dialects[d->dialect].halves ? SSGI_GL__HALF_NATIVE : SSGI_GL__HALF_MADE) | (shade ? 0 : SSGI_GL__PACKS) | (d->pass == SSGI_GL_S3HO ? 0 : SSGI_GL__UNPACKS));
    }
    if (exact) {
        ssgi_gl__add(&s, SSGI_GL__EXACT | (shade ? SSGI_GL__EXACT_SHADE : 0) | (lamps ? SSGI_GL__EXACT_LAMPS : 0) | SSGI_GL__WORLD | SSGI_GL__OCTAHEDRON);
        ssgi_gl__add(&s, SSGI_GL__I_MAP);
    }
    if (points) {
        ssgi_gl__add(&s, SSGI_GL__BLOCKED | (d->steps > 1 ? SSGI_GL__SEVERAL : SSGI_GL__SINGLE) | (d->kernel ? SSGI_GL__K_TEXTURE : SSGI_GL__K_TEXT));
        ssgi_gl__add(&s, falloff_kind[d->falloff] | fade_kind[d->fade] | (d->range ? SSGI_GL__RANGE | SSGI_GL__FACING : 0));
        if (d->fade || d->range) f |= SSGI_GL__FADE;
    }
    f |= s.word[0] & SSGI_GL__COMMON;
    if (blur || survey || (hsao && !slices) || (f & SSGI_GL__BLOCKED)) f |= SSGI_GL__PROJECT;
    if (hsao || survey || (f & SSGI_GL__BLOCKED)) ssgi_gl__add(&s, noise_kind[d->noise]);
    if (f & SSGI_GL__BLOCKED) {
        f |= d->thin ? SSGI_GL__THIN | (d->pass == SSGI_GL_LIGHTS ? SSGI_GL__REACH : SSGI_GL__FIXED) : SSGI_GL__SOLID;
        if (d->views) f |= SSGI_GL__VIEWS;
        if (f & (SSGI_GL__FADE | SSGI_GL__SENDERS)) f |= SSGI_GL__LOOK;
        if (!(f & SSGI_GL__FADE)) f |= SSGI_GL__NO_FADE;
        if (!(f & SSGI_GL__SENDERS)) f |= SSGI_GL__DEPTHS;
        f |= d->layers > 1 || d->views ? SSGI_GL__DEEP | (d->layers > 1 ? SSGI_GL__LAYERS : SSGI_GL__ONE_LAYER) : SSGI_GL__SHALLOW;
    }
    if ((f & SSGI_GL__FADE) || ssgi_gl__has(&s, SSGI_GL__ONE_SIDED) || ssgi_gl__has(&s, SSGI_GL__AREA) || ((f & SSGI_GL__DEEP) && (f & SSGI_GL__SENDERS))) f |= SSGI_GL__RECEIVED;
    f |= hidden && !(f & SSGI_GL__DEPTHS) ? SSGI_GL__UNSEEN : SSGI_GL__SEEN;
    if (blur || hsao || survey || (f & (SSGI_GL__BLOCKED | SSGI_GL__N_DEPTH))) f |= SSGI_GL__INSIDE;
    if (hidden || ((f & SSGI_GL__DEPTHS) && (f & SSGI_GL__LAYERS))) f |= SSGI_GL__LAYERS_READ;
    ssgi_gl__add(&s, f);
    return s;
}

SSGI_DEF const char *ssgi_gl_pass_name(int pass)
{
    int i;
    for (i = 0; i < SSGI_GL__ROWS; ++i) if (ssgi_gl__passes[i].pass == pass) return ssgi_gl__passes[i].name;
    return NULL;
}

SSGI_DEF const char *ssgi_gl_dialect_name(int dialect)
{
    return dialect >= 0 && dialect < SSGI_GL_DIALECTS ? ssgi_gl__dialects[dialect].name : NULL;
}

SSGI_DEF int ssgi_gl_fetches(const ssgi_gl_desc *desc)
{
    ssgi_gl_desc d;
    ssgi_gl__set s;
    uint64_t f;
    int n, test, open, vectors;
    if (ssgi_gl_check(desc, NULL) != SSGI_OK) return 0;
    d = ssgi_gl__resolve(desc);
    s = ssgi_gl__features(&d);
    f = s.word[0];
    n = 1 + (f & SSGI_GL__N_DEPTH ? 4 : f & SSGI_GL__NORMALS ? 1 : 0) + (ssgi_gl__has(&s, SSGI_GL__NOISE_TEXTURE) ? 1 : 0);
    test = (f & SSGI_GL__LAYERS ? d.layers : 1) + (f & SSGI_GL__VIEWS ? d.views * d.view_layers : 0);
    open = ssgi_gl__has(&s, SSGI_GL__I_MAP) ? ssgi_gl__has(&s, SSGI_GL__BENT_CONE) ? 8 : 4 : 0;
    vectors = ssgi_gl__has(&s, SSGI_GL__PACKED) ? (d.transfer ? 3 : 1) * (ssgi_gl__has(&s, SSGI_GL__V3) ? 2 : 1) : ssgi_gl__has(&s, SSGI_GL__V4) ? 4 : ssgi_gl__has(&s, SSGI_GL__V3) ? 3 : 1;
    switch (d.pass) {
    case SSGI_GL_SSAO: case SSGI_GL_S3HO: return n + d.samples * (d.steps * test + d.kernel) + open;
    case SSGI_GL_SSDO: return n + d.samples * (d.steps * test + d.kernel + (ssgi_gl__has(&s, SSGI_GL__E_MAP) ? 1 : 0)) + open;
    case SSGI_GL_SURVEY: return n + d.samples;
    case SSGI_GL_HSAO: return n + d.directions * d.steps * (d.search == SSGI_GL_SLICES ? 2 : 1 + d.normal_rays * test);
    case SSGI_GL_LIGHTS: return n + 3 + (ssgi_gl__has(&s, SSGI_GL__MAPS_READ) ? 6 : 0) + (ssgi_gl__has(&s, SSGI_GL__SEGMENTS) ? d.samples * test : 0) + d.accumulate;
    case SSGI_GL_SENDERS: return n + (ssgi_gl__has(&s, SSGI_GL__ALBEDO) ? 1 : 0) + (ssgi_gl__has(&s, SSGI_GL__S_LIGHT) ? 1 : 0) + (ssgi_gl__has(&s, SSGI_GL__S_DIRECT) ? 1 : 0);
    case SSGI_GL_SHADE: return n + vectors + open + (ssgi_gl__has(&s, SSGI_GL__LAMPS) ? 3 : 0) + (ssgi_gl__has(&s, SSGI_GL__ALBEDO) ? 1 : 0);
    case SSGI_GL_SURFELS: return ssgi_gl__has(&s, SSGI_GL__S_LIT) ? 3 + (ssgi_gl__has(&s, SSGI_GL__MAPS_READ) ? 6 : 0) + open : 0;
    case SSGI_GL_SHUFFLE: return n;
    case SSGI_GL_SPLAT: return ssgi_gl__has(&s, SSGI_GL__E_MAP) ? 2 : 1;
    case SSGI_GL_UNSHUFFLE: return 1;
    case SSGI_GL_SMOOTH: return n + 1 + (d.levels > 1 ? 1 << (d.levels - 1) : 0) * (2 + (ssgi_gl__has(&s, SSGI_GL__F_NORMALS) ? f & SSGI_GL__N_DEPTH ? 4 : 1 : 0));
    case SSGI_GL_SUM: return n + d.levels + open;
    case SSGI_GL_FIELD: return n + (d.storage ? 2 : 4) + d.cap + (d.objects ? 1 : 0);
    default: {
        const int side = 2 * d.filter_radius + 1, tap = d.colour == SSGI_GL_VECTORS ? vectors + 1 : 1;
        n -= d.colour == SSGI_GL_VECTORS || !d.half;        /* depth comes with the centre */
        return n + side * side * tap + (d.half && tap > 1 ? 1 : 0) + (ssgi_gl__has(&s, SSGI_GL__F_NORMALS) ? (f & SSGI_GL__N_DEPTH ? 4 : 1) * (side * side - !d.half) : 0);
    } }
}

/* ==== >>emit (implementation) ===================================================================================== */

/* Writes, measures and hashes in one. */
typedef struct ssgi_gl__text { char *out; size_t capacity, length; uint64_t hash; } ssgi_gl__text;

static void ssgi_gl__put(ssgi_gl__text *t, const char *s)
{
    for (; *s; ++s, ++t->length) {
        if (t->length + 1 < t->capacity) t->out[t->length] = *s;
        t->hash = (t->hash ^ (uint64_t)(unsigned char)*s) * 1099511628211u;
    }
}

static void ssgi_gl__put_int(ssgi_gl__text *t, int value)
{
    char digits[12];
    int i = (int)sizeof digits - 1;
    unsigned int v = value < 0 ? 0u - (unsigned int)value : (unsigned int)value;
    digits[i] = 0;
    do digits[--i] = (char)('0' + v % 10); while (v /= 10);
    if (value < 0) ssgi_gl__put(t, "-");
    ssgi_gl__put(t, digits + i);
}

/* 7 decimals by integers: printf's follow the locale. [limit: |x| < 100] */
static void ssgi_gl__put_float(ssgi_gl__text *t, float x)
{
    int v = (int)((double)x * 1e7 + (x < 0.0f ? -0.5 : 0.5)), k;
    if (v < 0) { ssgi_gl__put(t, "-"); v = -v; }
    ssgi_gl__put_int(t, v / 10000000);
    ssgi_gl__put(t, ".");
    for (k = 1000000; k > 1 && v % 10000000 < k; k /= 10) ssgi_gl__put(t, "0");
    ssgi_gl__put_int(t, v % 10000000);
}

static void ssgi_gl__line(ssgi_gl__text *t, const ssgi_gl_desc *d, int line)
{
    if (!d->lines) return;
    ssgi_gl__put(t, "#line ");
    ssgi_gl__put_int(t, line);
    ssgi_gl__put(t, "\n");
}

/* The points of SSAO, as ssgi_kernel makes them. */
static void ssgi_gl__put_kernel(ssgi_gl__text *t, int samples)
{
    float k[4 * 64];
    int i;
    ssgi_kernel(k, 1, samples, NULL);
    ssgi_gl__put(t, "// ssgi_kernel: cosine-weighted directions about +z, w: length\nconst vec4 SSGI_KERNEL[");
    ssgi_gl__put_int(t, samples);
    ssgi_gl__put(t, "] = vec4[");
    ssgi_gl__put_int(t, samples);
    ssgi_gl__put(t, "](");
    for (i = 0; i < 4 * samples; ++i) {
        ssgi_gl__put(t, i == 0 ? "\n    vec4(" : i % 4 == 0 ? "),\n    vec4(" : ", ");
        ssgi_gl__put_float(t, k[i]);
    }
    ssgi_gl__put(t, "));\n");
}

static int ssgi_gl__row_of(const ssgi_gl__pass *pass, int stage, const ssgi_gl__set *features, const char *name)
{
    const ssgi_gl__row *const *row = pass->rows[stage];
    for (; row && *row; ++row) if (ssgi_gl__has(features, (*row)->need) && !strcmp((*row)->io.name, name)) return 1;
    return 0;
}

/* Rows of a stage that exist in this variant, or of all, each once; slots are given in the order of all, the fragment stage's first. */
static int ssgi_gl__collect(const ssgi_gl__pass *pass, int stage, const ssgi_gl_desc *d, const ssgi_gl__set *features, ssgi_gl_io *out, int capacity)
{
    static const int order[SSGI_GL_STAGES] = { SSGI_GL_FRAGMENT, SSGI_GL_GEOMETRY, SSGI_GL_TESS_EVALUATION, SSGI_GL_TESS_CONTROL, SSGI_GL_VERTEX };
    int n = 0, slots[SSGI_GL_CAPTURE + 1] = { 0, 0, 0, 0, 0, 0 }, s, k;
    for (s = 0; s < SSGI_GL_STAGES; ++s) {
        const ssgi_gl__row *const *row;
        for (row = pass->rows[order[s]]; row && *row; ++row) {
            ssgi_gl_io io = (*row)->io;
            if (!ssgi_gl__has(features, (*row)->need)) continue;
            for (k = 0; k < s && !ssgi_gl__row_of(pass, order[k], features, io.name); ++k) {}
            if (k < s) continue;                                /* an earlier stage has it */
            if (io.kind == SSGI_GL_CAPTURE && stage == SSGI_GL_STAGES && pass->rows[SSGI_GL_GEOMETRY]) continue;    /* it goes to the next stage */
            if (io.kind == SSGI_GL_CONSTANT) { io.slot = ssgi_gl__get(d, io.offset); io.offset = 0; }
            else if (io.kind != SSGI_GL_PARAM) io.slot = slots[io.kind]++;
            if (stage != SSGI_GL_STAGES && (io.kind == SSGI_GL_PARAM ? !pass->rows[stage] || !pass->rows[stage][0] : !ssgi_gl__row_of(pass, stage, features, io.name))) continue;     /* a block has all members in every stage */
            if (n < capacity) out[n] = io;
            ++n;
        }
    }
    return n;
}

static size_t ssgi_gl__size_of(const char *type)
{
    static const struct size { const char *type; size_t bytes; } sizes[] = { { "float", 4 }, { "int", 4 }, { "ivec2", 8 }, { "vec2", 8 }, { "vec4", 16 }, { "mat3", 48 }, { "mat4", 64 },
                                                                            { "vec4[12]", 192 }, { "mat4[4]", 256 }, { "vec4[4]", 64 } };
    size_t i = 0;
    while (strcmp(sizes[i].type, type)) ++i;        /* the rows above have no others */
    return sizes[i].bytes;
}

/* A uniform block: members in the order of its struct, gaps where this pass reads nothing. */
static void ssgi_gl__put_block(ssgi_gl__text *t, const ssgi_gl_io *io, int n, int block, int bindings)
{
    size_t at = 0;
    int gaps = 0;
    for (;;) {
        const ssgi_gl_io *next = NULL;
        int i;
        for (i = 0; i < n; ++i)
            if (io[i].kind == SSGI_GL_PARAM && io[i].slot == block && io[i].offset >= at && (!next || io[i].offset < next->offset)) next = &io[i];
        if (!next) break;
        if (!at && !gaps) {
            ssgi_gl__put(t, "layout(std140");
            if (bindings) ssgi_gl__put(t, block ? ", binding = 1" : ", binding = 0");
            ssgi_gl__put(t, block ? ") uniform ssgi_views {\n" : ") uniform ssgi_frame {\n");
        }
        while (at < next->offset) {
            size_t gap = at % 16 == 0 && next->offset - at >= 16 ? (next->offset - at) / 16 * 16 : 4;
            ssgi_gl__put(t, gap == 4 ? "    float u_ssgi_gap" : "    vec4 u_ssgi_gap");
            ssgi_gl__put_int(t, 10 * block + gaps++);
            if (gap > 16) {
                ssgi_gl__put(t, "[");
                ssgi_gl__put_int(t, (int)(gap / 16));
                ssgi_gl__put(t, "]");
            }
            ssgi_gl__put(t, ";\n");
            at += gap;
        }
        ssgi_gl__put(t, "    ");
        ssgi_gl__put(t, next->type);
        ssgi_gl__put(t, " ");
        ssgi_gl__put(t, next->name);
        ssgi_gl__put(t, *next->format ? "; // " : ";");
        ssgi_gl__put(t, next->format);
        ssgi_gl__put(t, "\n");
        at = next->offset + ssgi_gl__size_of(next->type);
    }
    if (at) ssgi_gl__put(t, "};\n");
}

static void ssgi_gl__put_chunks(ssgi_gl__text *t, const ssgi_gl__chunk *const *chunk, const ssgi_gl__set *features, const ssgi_gl_desc *d)
{
    for (; *chunk; ++chunk) {
        if (!ssgi_gl__has(features, (*chunk)->need)) continue;
        if ((*chunk)->text[0] != ' ' && (*chunk)->text[0] != '}') ssgi_gl__put(t, "\n");       /* chunks that begin inside a function continue it */
        if (d) ssgi_gl__line(t, d, (*chunk)->line);
        if (d && *chunk == &ssgi_gl__kernel) ssgi_gl__put_kernel(t, d->samples);
        ssgi_gl__put(t, (*chunk)->text);
    }
}

static void ssgi_gl__write(ssgi_gl__text *t, const ssgi_gl_desc *desc, int stage)
{
    ssgi_gl_desc d = ssgi_gl__resolve(desc);
    const ssgi_gl__pass *pass = ssgi_gl__find(&d);
    const ssgi_gl__dialect *dialect = &ssgi_gl__dialects[d.dialect];
    const ssgi_gl__set features = ssgi_gl__features(&d);
    ssgi_gl_io io[SSGI_GL_MAX_IO];
    int n, i;
    if (!pass->chunks[stage]) return;
    n = ssgi_gl__collect(pass, stage, &d, &features, io, SSGI_GL_MAX_IO);

    ssgi_gl__put(t, d.version ? d.version : dialect->version);
    if (d.version && *d.version && d.version[strlen(d.version) - 1] != '\n') ssgi_gl__put(t, "\n");
    if (dialect->es) {
        static const char *const types[] = { "sampler2D", "sampler2DArray", "usampler2D", "usampler2DArray", "samplerCube" };
        int k;
        ssgi_gl__put(t, "precision highp float;\nprecision highp int;\n");
        for (k = 0; k < 5; ++k) {
            for (i = 0; i < n && strcmp(io[i].type, types[k]); ++i) {}
            if (i == n) continue;
            ssgi_gl__put(t, "precision highp ");
            ssgi_gl__put(t, types[k]);
            ssgi_gl__put(t, ";\n");
        }
    }
    for (i = 0; i < n; ++i) {
        if (io[i].kind != SSGI_GL_CONSTANT) continue;
        ssgi_gl__put(t, "const int ");
        ssgi_gl__put(t, io[i].name);
        ssgi_gl__put(t, " = ");
        ssgi_gl__put_int(t, io[i].slot);
        ssgi_gl__put(t, ";\n");
    }
    ssgi_gl__put_block(t, io, n, 0, dialect->bindings);
    ssgi_gl__put_block(t, io, n, 1, dialect->bindings);
    for (i = 0; i < n; ++i) {
        const int located = io[i].kind == SSGI_GL_OUTPUT || io[i].kind == SSGI_GL_ATTRIBUTE;
        if (io[i].kind == SSGI_GL_PARAM || io[i].kind == SSGI_GL_CONSTANT) continue;
        if (located || (io[i].kind == SSGI_GL_TEXTURE && dialect->bindings)) {
            ssgi_gl__put(t, located ? "layout(location = " : "layout(binding = ");
            ssgi_gl__put_int(t, io[i].slot);
            ssgi_gl__put(t, ") ");
        }
        ssgi_gl__put(t, io[i].kind == SSGI_GL_TEXTURE ? "uniform " : io[i].kind == SSGI_GL_ATTRIBUTE ? "in " : "out ");
        ssgi_gl__put(t, io[i].type);
        ssgi_gl__put(t, " ");
        ssgi_gl__put(t, io[i].name);
        ssgi_gl__put(t, "; // ");
        ssgi_gl__put(t, io[i].format);
        ssgi_gl__put(t, "\n");
    }
    if (d.fetch && stage == (ssgi_gl__has(&features, SSGI_GL__S_CUSTOM) ? d.tessellate ? SSGI_GL_TESS_EVALUATION : SSGI_GL_VERTEX : SSGI_GL_FRAGMENT)) {
        ssgi_gl__put(t, "\n");
        ssgi_gl__put(t, d.fetch);
        ssgi_gl__put(t, "\n");
    }
    ssgi_gl__put_chunks(t, pass->chunks[stage], &features, &d);
}

SSGI_DEF size_t ssgi_gl_emit(char *out, size_t capacity, const ssgi_gl_desc *desc, int stage)
{
    ssgi_gl__text t;
    if (ssgi_gl_check(desc, NULL) != SSGI_OK || stage < 0 || stage >= SSGI_GL_STAGES || (!out && capacity)) return 0;
    memset(&t, 0, sizeof t);
    t.out = out;
    t.capacity = capacity;
    ssgi_gl__write(&t, desc, stage);
    if (capacity) out[t.length < capacity ? t.length : capacity - 1] = 0;
    return t.length;
}

static void ssgi_gl__put_lane(ssgi_gl__text *t, const char *vector, int i)
{
    const char name[] = { '.', "abcd"[i / 4], '.', "xyzw"[i % 4], 0 };
    ssgi_gl__put(t, vector);
    ssgi_gl__put(t, name);
}

/* The product's terms by what ssgi_sh_product makes of pairs of basis functions. */
static void ssgi_gl__put_product(ssgi_gl__text *t, int bands)
{
    const int n = bands * bands;
    int i, j, k;
    ssgi_gl__put(t, "\n// the product of two functions, as far as these bands hold it\nssgi_sh ssgi_sh_product(ssgi_sh x, ssgi_sh y)\n{\n    ssgi_sh p = ssgi_sh_zonal(vec4(0.0), vec3(0.0, 0.0, 1.0));\n");
    for (i = 0; i < n; ++i)
        for (j = i; j < n; ++j) {
            float one[16] = { 0 }, other[16] = { 0 }, product[16];
            one[i] = other[j] = 1.0f;
            ssgi_sh_product(product, bands, one, other);
            ssgi_gl__put(t, i == 0 && j == 0 ? "    float q = " : "    q = ");
            ssgi_gl__put_lane(t, "x", i);
            ssgi_gl__put(t, " * ");
            ssgi_gl__put_lane(t, "y", j);
            if (i != j) {
                ssgi_gl__put(t, " + ");
                ssgi_gl__put_lane(t, "x", j);
                ssgi_gl__put(t, " * ");
                ssgi_gl__put_lane(t, "y", i);
            }
            ssgi_gl__put(t, ";\n");
            for (k = 0; k < n; ++k) {
                if (product[k] < 1e-5f && product[k] > -1e-5f) continue;
                ssgi_gl__put_lane(t, "    p", k);
                ssgi_gl__put(t, " += q * ");
                ssgi_gl__put_float(t, product[k]);
                ssgi_gl__put(t, ";\n");
            }
        }
    ssgi_gl__put(t, "    return p;\n}\n");
}

SSGI_DEF size_t ssgi_gl_sh(char *out, size_t capacity, int bands)
{
    static const ssgi_gl__chunk *const chunks[] = { &ssgi_gl__sh_cosine, SSGI_GL__SH, SSGI_GL__SH_ADD, SSGI_GL__SH_DOT, SSGI_GL__SH_TURN, NULL };
    ssgi_gl__set features = { { 0, 0, 0, 0 } };
    ssgi_gl__text t;
    if (bands < 1 || bands > 4 || (!out && capacity)) return 0;
    ssgi_gl__add(&features, SSGI_GL__COSINE);
    ssgi_gl__add(&features, SSGI_GL__VECTORS | SSGI_GL__LOBES | SSGI_GL__FREE | (bands > 1 ? SSGI_GL__V2 : 0) | (bands > 2 ? SSGI_GL__V3 : 0) | (bands > 3 ? SSGI_GL__V4 : 0));
    memset(&t, 0, sizeof t);
    t.out = out;
    t.capacity = capacity;
    ssgi_gl__put_chunks(&t, chunks, &features, NULL);
    ssgi_gl__put_product(&t, bands);
    if (capacity) out[t.length < capacity ? t.length : capacity - 1] = 0;
    return t.length;
}

SSGI_DEF size_t ssgi_gl_field(char *out, size_t capacity, const ssgi_gl_desc *desc)
{
    static const ssgi_gl__row *const rows[] = { &ssgi_gl__casters_tex, SSGI_GL__FIELD_MAPS, NULL };
    static const ssgi_gl__chunk *const chunks[] = { SSGI_GL__FIELD_OF, &ssgi_gl__field_all, NULL };
    ssgi_gl_desc d;
    ssgi_gl__set features;
    ssgi_gl__text t;
    int i;
    if (ssgi_gl_check(desc, NULL) != SSGI_OK || (!out && capacity)) return 0;
    d = *desc;
    d.pass = SSGI_GL_FIELD;
    features = ssgi_gl__features(&d);
    memset(&t, 0, sizeof t);
    t.out = out;
    t.capacity = capacity;
    for (i = 0; rows[i]; ++i) {
        if (!ssgi_gl__has(&features, rows[i]->need)) continue;
        ssgi_gl__put(&t, "uniform highp ");
        ssgi_gl__put(&t, rows[i]->io.type);
        ssgi_gl__put(&t, " ");
        ssgi_gl__put(&t, rows[i]->io.name);
        ssgi_gl__put(&t, "; // ");
        ssgi_gl__put(&t, rows[i]->io.format);
        ssgi_gl__put(&t, "\n");
    }
    ssgi_gl__put_chunks(&t, chunks, &features, NULL);
    if (capacity) out[t.length < capacity ? t.length : capacity - 1] = 0;
    return t.length;
}

SSGI_DEF int ssgi_gl_reflect(const ssgi_gl_desc *desc, ssgi_gl_io *rows, int capacity)
{
    ssgi_gl_desc d;
    ssgi_gl__set features;
    if (ssgi_gl_check(desc, NULL) != SSGI_OK || (!rows && capacity > 0)) return 0;
    d = ssgi_gl__resolve(desc);
    features = ssgi_gl__features(&d);
    return ssgi_gl__collect(ssgi_gl__find(&d), SSGI_GL_STAGES, &d, &features, rows, capacity);
}

SSGI_DEF uint64_t ssgi_gl_key(const ssgi_gl_desc *desc)
{
    uint64_t h = 14695981039346656037u;     /* FNV-1a over the very texts */
    ssgi_gl__text t;
    int stage;
    if (ssgi_gl_check(desc, NULL) != SSGI_OK) return 0;
    for (stage = 0; stage < SSGI_GL_STAGES; ++stage) {
        memset(&t, 0, sizeof t);
        t.hash = h;
        ssgi_gl__write(&t, desc, stage);
        h = t.hash;
    }
    return h;
}

/* ==== >>frame (implementation) ==================================================================================== */

SSGI_DEF ssgi_result ssgi_gl_frame_init(ssgi_gl_frame *frame, const ssgi_view *view, float radius, const char **why)
{
    ssgi_gl_frame f;
    if (!frame) return ssgi_gl__bad(why, "frame: must not be NULL");
    if (!view || view->width < 1 || view->height < 1) return ssgi_gl__bad(why, "view: must come from ssgi_view_from_projection");
    if (!(radius > 0.0f && radius < SSGI_FAR)) return ssgi_gl__bad(why, "radius: must be > 0 and finite");
    memset(&f, 0, sizeof f);
    memcpy(f.project, view->project, sizeof f.project);
    memcpy(f.unproject, view->unproject, sizeof f.unproject);
    f.decode[0] = view->depth[0];
    f.decode[1] = view->depth[1];
    f.decode[2] = view->clear;
    f.size[0] = view->width;
    f.size[1] = view->height;
    f.radius = radius;
    f.offset = 1.5f;
    f.thickness = radius;
    f.fade = 0.3f * radius;
    f.nearest = 0.25f;
    f.gain = 1.0f;
    f.steepest = 20.0f;
    f.lambda = 4.0f;
    ssgi_sh_window(f.window, 4, SSGI_SH_WINDOW_HANN);
    f.rotation[0] = f.rotation[5] = f.rotation[10] = 1.0f;
    f.mesh[0] = f.mesh[5] = f.mesh[10] = f.mesh[15] = 1.0f;
    f.front = ssgi_view_near(view);
    f.epsilon = 0.1f;
    f.exponent = 32.0f;
    *frame = f;
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_gl_surfels_set(ssgi_gl_frame *frame, const ssgi_view *view, const ssgi_surfel_desc *desc, int levels, const float *mesh_to_view, const char **why)
{
    float scale[4], more[2];
    int size[2], i;
    ssgi_result r;
    if (!frame) return ssgi_gl__bad(why, "frame: must not be NULL");
    for (i = 0; mesh_to_view && i < 16; ++i)
        if (!(mesh_to_view[i] > -SSGI_FAR && mesh_to_view[i] < SSGI_FAR)) return ssgi_gl__bad(why, "mesh_to_view: must be finite");
    r = ssgi_surfel_scale(scale, more, desc, view, why);
    if (r == SSGI_OK) r = ssgi_splat_size(size, view->width, view->height, levels, why);
    if (r != SSGI_OK) return r;
    memcpy(frame->surfel, scale, sizeof scale);
    memcpy(frame->more, more, sizeof more);
    memcpy(frame->level, size, sizeof size);
    if (mesh_to_view) memcpy(frame->mesh, mesh_to_view, sizeof frame->mesh);
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_gl_dipole_set(ssgi_gl_frame *frame, const ssgi_dipole *dipole, float unit, const char **why)
{
    int c;
    if (!frame || !dipole) return ssgi_gl__bad(why, "frame, dipole: must not be NULL");
    if (!(unit > 0.0f && unit < SSGI_FAR)) return ssgi_gl__bad(why, "unit: must be > 0 and finite");
    for (c = 0; c < 3; ++c) {
        frame->dipole[c] = (float)dipole->above[c] * unit;
        frame->dipole[4 + c] = (float)dipole->below[c] * unit;
        frame->dipole[8 + c] = (float)dipole->fading[c] / unit;
        frame->dipole[12 + c] = 0.25f * (float)dipole->albedo[c];       /* pi r^2 over 4 pi */
    }
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_gl_harmonics_set(ssgi_gl_frame *frame, const float *coefficients, int bands, const float *world_to_view, const char **why)
{
    float turned[48];
    int i;
    if (!frame) return ssgi_gl__bad(why, "frame: must not be NULL");
    if (!coefficients) return ssgi_gl__bad(why, "coefficients: must not be NULL");
    if (bands < 1 || bands > 4) return ssgi_gl__bad(why, "bands: must be 1..4");
    memset(turned, 0, sizeof turned);
    memcpy(turned, coefficients, 3 * (size_t)(bands * bands) * sizeof *turned);
    if (world_to_view) ssgi_sh_rotate(turned, bands, turned, 3, world_to_view);
    for (i = 0; i < 48; ++i) frame->harmonics[12 * (i / 12) + 4 * (i % 3) + i / 3 % 4] = turned[i];
    return SSGI_OK;
}

/* a * b of two rigid world-to-view matrices: a after the inverse of b */
static void ssgi_gl__relative(double out[16], const float a[16], const float b[16])
{
    int r, c, k;
    for (c = 0; c < 4; ++c)
        for (r = 0; r < 4; ++r) {
            double sum = c == 3 ? (double)a[12 + r] : 0.0;
            for (k = 0; k < 3; ++k) {
                double inverse = 0.0;               /* element k, c of b's: the transposed rotation; its translation is that times -t */
                int i;
                if (c < 3) inverse = (double)b[4 * k + c];
                else for (i = 0; i < 3; ++i) inverse -= (double)b[4 * k + i] * (double)b[12 + i];
                sum += (double)a[4 * k + r] * inverse;
            }
            out[4 * c + r] = sum;
        }
}

/* Column-major: a point of the picture's view space to x, y (pixels, times depth when perspective), view depth, 1 of another camera; and back. */
static void ssgi_gl__to_pixels(float to[16], float from[16], const ssgi_view *view, const float picture[16], const float other[16])
{
    double m[16], b[16];
    int c, r;
    ssgi_gl__relative(m, other, picture);
    ssgi_gl__relative(b, picture, other);
    for (c = 0; c < 4; ++c) {
        const double z = -m[4 * c + 2], unit = view->orthographic ? (c == 3 ? 1.0 : 0.0) : z;
        to[4 * c + 0] = (float)((double)view->project[0] * m[4 * c + 0] + (double)view->project[2] * unit);
        to[4 * c + 1] = (float)((double)view->project[1] * m[4 * c + 1] + (double)view->project[3] * unit);
        to[4 * c + 2] = (float)z;
        to[4 * c + 3] = c == 3 ? 1.0f : 0.0f;
    }
    for (r = 0; r < 4; ++r) {       /* view xy = pixel * unproject.xy + unproject.zw, the latter times depth or not */
        const double shift = b[r] * (double)view->unproject[2] + b[4 + r] * (double)view->unproject[3];
        from[r] = (float)(b[r] * (double)view->unproject[0]);
        from[4 + r] = (float)(b[4 + r] * (double)view->unproject[1]);
        from[8 + r] = (float)((view->orthographic ? 0.0 : shift) - b[8 + r]);
        from[12 + r] = (float)((view->orthographic ? shift : 0.0) + b[12 + r]);
    }
}

static ssgi_result ssgi_gl__check_camera(const ssgi_view *view, const float *picture, const float *other, const char *name, const char **why)
{
    int i;
    if (!view || view->width < 1 || view->height < 1) return ssgi_gl__bad(why, "view: must come from ssgi_view_from_projection");
    if (!picture) return ssgi_gl__bad(why, "picture_world_to_view: must not be NULL");
    if (!other) return ssgi_gl__bad(why, name);
    for (i = 0; i < 16; ++i)
        if (!(picture[i] > -SSGI_FAR && picture[i] < SSGI_FAR && other[i] > -SSGI_FAR && other[i] < SSGI_FAR))
            return ssgi_gl__bad(why, "picture_world_to_view: both matrices must be finite");
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_gl_views_set(ssgi_gl_views *views, int i, const ssgi_view *view, const float picture_world_to_view[16],
                                       const float extra_world_to_view[16], const char **why)
{
    ssgi_result r;
    if (!views) return ssgi_gl__bad(why, "views: must not be NULL");
    if (i < 0 || i > 3) return ssgi_gl__bad(why, "i: must be 0..3");
    r = ssgi_gl__check_camera(view, picture_world_to_view, extra_world_to_view, "extra_world_to_view: must not be NULL", why);
    if (r != SSGI_OK) return r;
    ssgi_gl__to_pixels(views->to[i], views->from[i], view, picture_world_to_view, extra_world_to_view);
    views->decode[i][0] = view->depth[0];
    views->decode[i][1] = view->depth[1];
    views->decode[i][2] = view->clear;
    views->decode[i][3] = (float)view->orthographic;
    views->size[i][0] = (float)view->width;
    views->size[i][1] = (float)view->height;
    views->size[i][2] = 2.0f * ssgi_pixel_footprint(view, 1.0f);
    views->size[i][3] = 0.0f;
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_gl_light_map(ssgi_gl_light *light, const ssgi_view *view, int x, int y, const float picture_world_to_view[16],
                                       const float light_world_to_view[16], const char **why)
{
    float to[16], from[16];
    ssgi_result r;
    int i, k;
    if (!light) return ssgi_gl__bad(why, "light: must not be NULL");
    if (x < 0 || y < 0) return ssgi_gl__bad(why, "x: the tile must lie in the atlas, x and y >= 0");
    r = ssgi_gl__check_camera(view, picture_world_to_view, light_world_to_view, "light_world_to_view: must not be NULL", why);
    if (r != SSGI_OK) return r;
    ssgi_gl__to_pixels(to, from, view, picture_world_to_view, light_world_to_view);
    for (i = 0; i < 3; ++i)
        for (k = 0; k < 4; ++k) light->map[i][k] = to[4 * k + i];
    light->patch = ssgi_pixel_footprint(view, 1.0f);
    light->decode[0] = view->depth[0];
    light->decode[1] = view->depth[1];
    light->decode[2] = view->clear;
    light->decode[3] = (float)view->orthographic;
    light->tile[0] = (float)x;
    light->tile[1] = (float)y;
    light->tile[2] = (float)view->width;
    light->tile[3] = (float)view->height;
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_gl_caster_set(ssgi_gl_caster *caster, const ssgi_field *field, const ssgi_field_limits *limits, const float mesh_to_view[16], int slice, int object, const char **why)
{
    ssgi_field_limits l;
    ssgi_gl_caster c;
    double square[3] = { 0.0, 0.0, 0.0 }, across[3] = { 0.0, 0.0, 0.0 }, turn;
    const float *m = mesh_to_view;
    int i, k;
    if (!caster) return ssgi_gl__bad(why, "caster: must not be NULL");
    if (!field || !field->texels || field->resolution < 2) return ssgi_gl__bad(why, "field: must come from ssgi_field_bake or ssgi_field_load");
    if (!m) return ssgi_gl__bad(why, "mesh_to_view: must not be NULL");
    if (slice < 0 || slice > 2047) return ssgi_gl__bad(why, "slice: must be 0..2047");
    if (object < 0 || object > 16777215) return ssgi_gl__bad(why, "object: must be 0..16777215");
    l = limits ? *limits : ssgi_field_limits_of(field);
    if (!(l.ramp >= 0.0f && l.ramp < l.reach && l.reach <= field->reach * 1.000001f)) return ssgi_gl__bad(why, "limits.reach: must be above limits.ramp, which is 0 or more, and at most field->reach");
    if (!(l.inside >= 0.0f && l.inside <= 1.0f)) return ssgi_gl__bad(why, "limits.inside: must be 0..1");
    if (!(l.power > 0.0f && l.power < SSGI_FAR)) return ssgi_gl__bad(why, "limits.power: must be above 0 and finite");
    for (i = 0; i < 16; ++i)
        if (!(m[i] > -SSGI_FAR && m[i] < SSGI_FAR)) return ssgi_gl__bad(why, "mesh_to_view: must be finite");
    for (i = 0; i < 3; ++i)
        for (k = 0; k < 3; ++k) {
            square[i] += (double)m[4 * i + k] * (double)m[4 * i + k];
            across[i] += (double)m[4 * i + k] * (double)m[4 * ((i + 1) % 3) + k];
        }
    turn = (double)m[0] * ((double)m[5] * (double)m[10] - (double)m[6] * (double)m[9]) - (double)m[4] * ((double)m[1] * (double)m[10] - (double)m[2] * (double)m[9])
         + (double)m[8] * ((double)m[1] * (double)m[6] - (double)m[2] * (double)m[5]);
    for (i = 0; i < 3; ++i)
        if (!(square[i] > 1e-30 && square[i] < 1.002 * square[0] && square[i] > 0.998 * square[0] && across[i] < 1e-3 * square[0] && across[i] > -1e-3 * square[0] && turn > 0.0))
            return ssgi_gl__bad(why, "mesh_to_view: must be a rotation, a translation and a uniform scale");
    memset(&c, 0, sizeof c);
    for (i = 0; i < 3; ++i) {           /* the inverse: transposed over the squared scale */
        double shift = -(double)field->centre[i];
        c.at[i] = m[12 + i];
        for (k = 0; k < 3; ++k) {
            c.at[i] += m[4 * k + i] * field->centre[k];
            c.to_field[i][k] = (float)((double)m[4 * i + k] / square[0]);
            shift -= (double)m[4 * i + k] / square[0] * (double)m[12 + k];
        }
        c.to_field[i][3] = (float)shift;
    }
    c.reach = l.reach * sqrtf((float)square[0]);
    c.ramp = l.ramp;
    c.end = l.reach;
    c.inside = l.inside;
    c.power = l.power;
    memcpy(c.low, field->low, sizeof c.low);
    memcpy(c.span, field->span, sizeof c.span);
    c.resolution = (float)field->resolution;
    c.slice = (float)slice;
    c.fitted = field->reach;
    c.object = (float)object;
    *caster = c;
    return SSGI_OK;
}

#ifdef __cplusplus
}
#endif
#endif /* SSGI_GL_IMPLEMENTATION; the licence stands at the end of ssgi.h */
