/* kit.h - the small embedder that the examples and the tests share. Not part of the library.

   It brings what an engine already has: a headless GL context, meshes, pictures, a G-buffer; and what
   only a laboratory needs: ray-traced truth and scores. A room is a folder, and calls those above it alone:

     kit/       util.c     errors, progress, threads, whole files, JSON, vectors
                image.c    float pictures; exr.c, hdr.c, png.c: read and written; score.c: compared
     scene/     mesh.c     triangles of an OBJ of a package; soup.c: objects of any
                models.c   users' models, which assimp.c reads, with gltf.c; texture.c, cards.c: what cuts them
                scene.c    scenes by name or path, objects and their places; shapes.c: what they are built of;
                           scenes.c: the built-in ones, of buildings.c, thin.c and solids.c; seeds.c: those drawn from
                           a seed, by the rows of tables/, and models of packages: see kit_seed.h
                light.c    environments and lights
     trace/     camera.c   cameras
                truth.c    ray-traced truth over ssgi.h's trace room; lit.c: of light, scatter.c: under surfaces
                floor.c    what one depth layer can know
                places.c   where a picture's error sits: edges, border, interior
                agree.c    whether a frame's normals and its depth are of one camera
     gl/        gl.c       contexts (OSMesa, EGL), GL functions, textures, targets, programs
                gbuffer.c  the G-buffer: rasterised from a scene or taken from a frame's EXR
                shadow.c   shadow maps as one atlas, reflective shadow maps
                field.c    ambient occlusion fields of a scene's shapes, baked and as textures
     run/       settings.c the table of methods and their settings
                run.c      a method made ready on a G-buffer; kit_run.h names the files that this takes
                frames.c   one frame after another
                plan.c     what a scene needs

   CONVENTIONS
     errors    every function that can fail returns 0, or -1 with one line in the kit_error that names the file or
               argument and what is wrong with it; outputs are then untouched and nothing needs freeing. err may be
               NULL.
     pictures  planar floats, row 0 at the top
     matrices  float[16], column-major, as in ssgi.h
     world     right-handed; angles in degrees at this level (people type them), radians inside */
#ifndef KIT_H
#define KIT_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#define KIT_PI 3.14159265358979323846
#define KIT_MOST 1e12                      /* of a number that people type: floats still compute with its squares */

/* ---- >>util ------------------------------------------------------------------------------------------------- */

typedef struct kit_error { char text[1024]; } kit_error;

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
int    kit_fail(kit_error *err, const char *format, ...);   /* writes the line (when err is not NULL), returns -1 */
/* A regular file that is not empty, and its size, for who looks at its start before he trusts the rest; NULL: it cannot
   be opened. fclose() */
FILE  *kit_file_open(size_t *size, const char *path, kit_error *err);
/* such a file whole; a 0 follows the last byte; free(data) */
int    kit_file_read(char **data, size_t *size, const char *path, kit_error *err);
/* Whole or not at all: beside it, then renamed, which no signal but SIGKILL comes between (one that ends the program
   ends it afterwards; other threads must have them blocked). A file that is there keeps its mode; where the system
   allows it, its owner. */
int    kit_file_write(const char *path, const void *data, size_t size, kit_error *err);
/* A string with its quotes; bytes that are not UTF-8 become U+FFFD. A number with so many decimals, below 0: so many
   digits in all; null if it is not finite. */
void   kit_json_string(FILE *out, const char *text);
void   kit_json_number(FILE *out, double v, int decimals);
/* Prints the words of a text from `column` on, in lines of at most `most` characters, whose further ones begin at
   `indent`. */
void   kit_print_words(const char *text, int column, int indent, int most);
/* For a program's start and end. open: a standard stream that is closed gets nothing else in its place; files beyond
   the limit of their size are errors.
   close: -1 when something that was printed is lost. */
void   kit_streams_open(void);
int    kit_streams_close(kit_error *err);
double kit_seconds(void);                                   /* monotonic clock */
double kit_median(double *v, int count);                    /* sorts v; count > 0 */
float  kit_middle(float *v, size_t count);                  /* the same, of an even count the upper of the two */
double kit_dot(const double a[3], const double b[3]);
void   kit_cross(const double a[3], const double b[3], double out[3]);      /* out is neither a nor b */
int    kit_unit(double v[3]);                               /* 0 if v has no direction, then left as it is */
/* FNV-1a of size bytes, continued from h; the first call passes KIT_HASH. */
#define KIT_HASH UINT64_C(14695981039346656037)
uint64_t kit_hash(uint64_t h, const void *data, size_t size);

/* Shows what is being done, how far, and the time left, on stderr when that is a terminal; nothing otherwise.
   fraction 0 starts the clock, 1 clears the line. Call it as often as you like: it redraws at most ten times a
   second. */
void   kit_progress(const char *what, double fraction);

/* Calls job(context, i) for every i in [0, count) on as many threads as the machine has cores (KIT_THREADS in the
   environment overrides), in blocks of at least 1, in no order. what: shown by kit_progress, NULL = quiet. */
void   kit_parallel(const char *what, int count, void (*job)(void *context, int i), void *context);

/* ---- >>image ------------------------------------------------------------------------------------------------ */

#define KIT_MAX_CHANNELS 64
typedef struct kit_image {
    int    width, height, channels;
    char   name[KIT_MAX_CHANNELS][32];     /* as in the EXR file: "Y", "R", "N.X", "layer1.Z" */
    float *data;                           /* channel c, row y, column x: data[((size_t)c * height + y) * width + x] */
} kit_image;

/* names: "Z,N.X,N.Y,N.Z"; zeroed */
int    kit_image_new(kit_image *image, int width, int height, const char *names, kit_error *err);
void   kit_image_free(kit_image *image);                                 /* leaves it all zero; fine to call again */
float *kit_image_channel(const kit_image *image, const char *name);      /* NULL if there is no such channel */

/* EXR through OpenEXR's C core; every channel is read as float (half, float, uint; any order; scanline or tiled; deep
   and subsampled files are refused, and those that the C core cannot decompress: DWAA, DWAB in 3.1); look channels up
   by name. Of several parts those are read, on a window that holds all of theirs, which are flat and of the view that
   comes first; a channel whose name an earlier part has is PART.NAME. A header that claims more than the file's bytes
   can hold is refused before there is room for it. Files are written as 32-bit float, ZIP, to a temporary name beside
   the target and renamed: never half-written. */
int    kit_exr_read(kit_image *image, const char *path, kit_error *err);
int    kit_exr_write(const kit_image *image, const char *path, kit_error *err);

/* What an EXR's header says of where a frame was taken, for its pixels as they are: where the data window is not the
   display window, the view is off-centre.
     worldToCamera       m44f, as OpenEXR's standard has it: the camera is left-handed (x to the right, y up, looking
                         down +z) and the matrix for row vectors, so that its numbers lie as those of this kit do. It
                         turns and moves a right-handed world, without scale
     ssgi.worldToCamera  m44d: the same in doubles, of what lies so far from 0 that floats would be coarse; it is taken
                         instead
     screenWindowWidth, screenWindowCenter   likewise: the picture on the plane at distance 1, +y up; not looked at
                         without worldToCamera, because every EXR has them
     ssgi.orthoHeight    float: the picture is orthographic, so many world units from bottom to top of its display
                         window; the screen window is in world units then
     ssgi.radius         float: a radius that suits it, world units
   wanted: others are not looked at. Of those header->has what there is; one that is malformed is an error.
   KIT_HEADER_PART: header->orthographic and height are given, of the display window; where the data window is another,
   header has that one's window. */
enum { KIT_HEADER_PLACE = 1, KIT_HEADER_WINDOW = 2, KIT_HEADER_RADIUS = 4, KIT_HEADER_ALL = 7, KIT_HEADER_PART = 8 };
typedef struct kit_header {
    int   has;
    float world_to_camera[16];             /* about the origin, a mesh's or the eye */
    double origin[3];
    int   orthographic;
    float height, centre[2];               /* of the picture: at distance 1, or orthographic in world units */
    float radius;
} kit_header;
int    kit_exr_header(kit_header *header, int wanted, const char *path, kit_error *err);
/* kit_exr_write with what the header has; NULL: nothing */
int    kit_exr_write_frame(const kit_image *image, const kit_header *header, const char *path, kit_error *err);
/* Radiance .hdr through stb, rows flat or in runs (not the old way, a pixel repeated): channels R, G, B; the same of
   its header. */
int    kit_hdr_read(kit_image *image, const char *path, kit_error *err);

/* 8-bit PNG through stb, 1 channel (grey) or 3 (rgb), taken in the given order from names ("Y" or "R,G,B"); values
   [0,1] are clamped, NaN is written as 0. srgb: 1 encodes linear values as sRGB, 0 writes them as they are (ambient
   visibility, colour maps). Same renaming. */
int    kit_png_write(const kit_image *image, const char *names, int srgb, const char *path, kit_error *err);

/* mask: width*height floats, a pixel counts where mask > 0; NULL = all. All figures are of (a - b). */
typedef struct kit_score { double rmse, bias, p95, ssim; size_t pixels; } kit_score;
int kit_score_channel(kit_score *score, const kit_image *a, const kit_image *b, const char *channel, const float *mask,
                      kit_error *err);
/* Of count channels together: root of the mean square, means of the others. */
int kit_score_channels(kit_score *score, const kit_image *a, const kit_image *b, const char *const *channels, int count,
                       const float *mask, kit_error *err);

/* Signed difference (a - b) of one channel as colours: a perceptually uniform diverging map, 0 is white-grey, blue
   where a is darker than b, red where brighter; full colour at +-range. out: a new R,G,B picture, sRGB-encoded already
   (write it with srgb 0). */
int kit_image_difference(kit_image *out, const kit_image *a, const kit_image *b, const char *channel, float range,
                         kit_error *err);

/* ---- >>mesh ------------------------------------------------------------------------------------------------- */

/* A triangle soup: corner k of triangle t at index 3*t + k. */
typedef struct kit_mesh {
    size_t triangles;
    float *position;                       /* 9 a triangle */
    float *normal;                         /* 9 a triangle, unit; the face's where the file gives none */
    float *albedo;                         /* 3 a triangle, linear, [0,1]; 0.8 grey where the file gives none */
    /* one a triangle: the number of its object, from 1 on; 0 = none. NULL = none at all */
    uint32_t *object;
    float  lower[3], upper[3];             /* bounds */
    /* What stands at 0 here, in the file's own coordinates: 0 but of what lies more than a hundred of its diagonals
       from there, where floats would be coarse. Near the middle of its bounds then */
    double origin[3];
} kit_mesh;

/* What is rigid and may stand elsewhere than the rest. Object number k + 1 is object[k]. */
#define KIT_MAX_OBJECTS 256                /* of an OBJ file */
typedef struct kit_object {
    char   name[64];
    int    shape;                          /* index into the scene's shapes */
    float  to_world[16];                   /* from the shape's coordinates: rotation, uniform scale, translation */
    float  lower[3], upper[3];             /* world bounds */
    int    casts;                          /* 1 = it occludes other objects; see kit_scene_load */
    /* its first triangle in the scene's mesh; the others follow, in the shape's order, perhaps among others' */
    size_t first;
    float  loaded[16];                     /* of what kit_scene_move moves: to_world as loaded (else all 0), and */
    int    base;                           /* the lowest object of the stack that it moves with */
} kit_object;

void   kit_mesh_free(kit_mesh *mesh);
/* Objects are told apart by their names on o lines; if these make fewer than two, by those on g lines; if these do as
   well, they are the connected parts (corners at equal positions join). One name is one object wherever it comes. They
   count in the order of their first triangles; of more than KIT_MAX_OBJECTS only the KIT_MAX_OBJECTS - 1 with most
   triangles are objects, all others are the last one, "rest", that does not cast (casts 0). object: name, first and
   casts filled in (casts -1: to be judged), to be freed by the caller; it and objects NULL = not wanted. */
int    kit_mesh_obj(kit_mesh *mesh, kit_object **object, int *objects, const char *path, kit_error *err);

typedef struct kit_camera {
    float eye[3], target[3], up[3];
    float fovy;                            /* degrees, full vertical angle; 0 = orthographic */
    float ortho_height;                    /* world units from bottom to top of the picture, when fovy is 0 */
    float znear, zfar;                     /* 0 = from the scene's bounds (kit_camera_planes) */
    int   width, height;
    float shift[2];                        /* moves the projection's centre by so many pixels: off-centre frustum */
    int   depth;                           /* how window depth is laid out */
} kit_camera;
enum { KIT_DEPTH_NORMAL, KIT_DEPTH_REVERSED, KIT_DEPTH_INFINITE /* reversed, far plane at infinity */ };

enum { KIT_SUN, KIT_POINT };
typedef struct kit_light {
    int   kind;
    float at[3];                           /* SUN: unit direction to the light; POINT: where it is. World space */
    float colour[3];                       /* SUN: irradiance facing it; POINT: radiant intensity */
} kit_light;

enum { KIT_SCENE_LIGHTS = 4 };
typedef struct kit_scene {
    const char *name;                      /* built-in name or path */
    const char *about;                     /* one line */
    char        note[512];                 /* one line: what of a model is not as its file has it, "" = nothing */
    kit_mesh    mesh;
    kit_camera  camera;                    /* a view that shows something; width, height 1280 x 720 */
    float       radius;                    /* a radius that suits it, world units */
    const char *env;                       /* of scenes by seed: what lights them, a built-in environment; else NULL */
    int         lights;                    /* and lights beside it */
    kit_light   light[KIT_SCENE_LIGHTS];
    int         objects, shapes;
    kit_object *object;
    /* meshes in their own coordinates, each perhaps of many objects: positions, normals and bounds only. An object's
       triangles in mesh are its shape's by to_world */
    kit_mesh   *shape;
} kit_scene;

/* name_or_path: a built-in scene ("room"), one drawn from a seed ("random:7", "random:streets:7"; of the first, the
   kind is number SEED modulo KIT_KINDS; the same on every machine), a model that a package brings, on a floor, camera
   and radius drawn from a seed ("model:bunny", "model:bunny:7") or a model's file: OBJ, and where Assimp was there
   when this was built, glTF, GLB, PLY, FBX and what else it reads. Of these: triangles where the nodes put them, in the
   pose that the file has; nodes are objects as an OBJ's o lines, meshes as its g lines; albedo is the base colour times
   the mean of its texture and of the corners' colours; a card whose texture has holes (glTF: alphaMode MASK, or BLEND
   where alpha is nearly all 0 or 1; others: the latter, or a map of opacity) is cut along its texels, or squares of
   them, of which a triangle has 4096 at most, fewer where more than 512 triangles are cut. FBX, Collada, IFC and 3DS
   are turned upright, others stand as they are; units stay as they are. What lies more than 100 diagonals of its bounds
   from 0 in x, y or z is read in doubles, as far as its format has them, about mesh.origin: all places here are about
   that, to be added for the file's own coordinates; its note says so, and where numbers are coarse. A model: the camera
   looks at the bounds from the front, above and to the side so that all is in view; radius is a tenth of the bounds'
   diagonal. floor_: adds a square under it, at its lowest y, five diagonals wide, as object "floor". Every triangle has
   an object. Of a model each is its own shape, at its place (to_world 1), and casts unless it is flat (its bounds'
   thinnest side below 1e-3 of the widest) or its bounds hold those of most other objects entirely, as rooms and grounds
   do. Built-in scenes say themselves what casts. */
int         kit_scene_load(kit_scene *scene, const char *name_or_path, int floor_, kit_error *err);
void        kit_scene_free(kit_scene *scene);
int         kit_scene_seeded(const char *name);    /* whether a name is of a scene that brings its own light */
/* name of the i-th built-in scene, of the i-th kind of those by seed, and of the i-th model that packages bring; NULL
   past the last */
const char *kit_scene_builtin(int i, const char **about);
const char *kit_scene_kind(int i, const char **about);
const char *kit_scene_model(int i);
enum { KIT_KINDS = 7 };

/* Appends a closed box, as an object "box", to the scene's mesh and widens its bounds. Sides at least 1e-4 units, all
   finite; albedo linear, [0, 1]. It casts as an OBJ's object would; what holds most objects now casts no more. */
int kit_scene_add_box(kit_scene *scene, const float lower[3], const float upper[3], const float albedo[3],
                      kit_error *err);

/* Puts object[object] elsewhere: its triangles in the mesh (positions, normals), its bounds and the mesh's. to_world: a
   rotation (no mirroring), a uniform scale above 0 and a translation, to 1e-3, all below 1e15; else, or if there is no
   such object, -1 and all stays. */
int         kit_scene_place(kit_scene *scene, int object, const float to_world[16], kit_error *err);

/* Moves the first object that casts on by so much, so many times; -1: by is not 0, and there is none. */
int         kit_scene_slide(kit_scene *scene, const float by[3], int times, kit_error *err);

/* Puts the objects of "casters" and "crowd" where they are at a time: they orbit, hop and tumble around the places
   where they were loaded, smoothly, with period 1 (0 = as loaded), never below the ground. Whatever else the scene
   holds, and other scenes, stay as they are. */
void        kit_scene_move(kit_scene *scene, double time);

#define KIT_BEHIND 0.2f                    /* what pictures show on colours where nothing is seen */

/* ---- >>light ------------------------------------------------------------------------------------------------ */

#define KIT_MAX_LIGHTS 16
typedef struct kit_lighting {
    kit_image env;                         /* radiance as kit_env_read gives it; data NULL = none */
    float     reach;                       /* of what shadows the lights in the truth; 0: all of the scene does */
    int       lights;
    kit_light light[KIT_MAX_LIGHTS];
} kit_lighting;

/* Built in: "sky", a clear sky with a soft sun side, no sharp sun; "probe", a dim room with coloured windows and lamps
   up to a thousand times as bright as it; "windows", a room by day; "street", a street at night whose lamps bring most
   of the light from a thousandth of the sphere; "white", radiance 1 everywhere. Else an .exr or .hdr file with channels
   R, G, B. Latitude-longitude, oriented as OpenEXR defines it: +y up, the picture's centre looks to +z, +x left of the
   centre; texels are areas, the first row reaches up to the pole. env gets channels R,G,B in this order; values that
   are not finite or below 0 become 0. */
int  kit_env_read(kit_image *env, const char *name_or_path, kit_error *err);
/* Turns it about +y, anticlockwise as seen from above, and scales its radiance. */
int  kit_env_adjust(kit_image *env, double degrees, double strength, kit_error *err);
/* A scene's own light, of one by seed: its environment and its lights; lighting must be empty. */
int  kit_light_scene(kit_lighting *lighting, const kit_scene *scene, kit_error *err);
/* Adds a sun as a disc with soft edges, whose irradiance facing it is the sun's colour, to env (1024 x 512 black texels
   first if it has no data). degrees: half-angle, from one texel's height to 45. The light must be a SUN. */
int  kit_env_add_sun(kit_image *env, const kit_light *sun, double degrees, kit_error *err);
/* bilinear; wraps around; direction need not be unit; 0 if data is NULL */
void kit_env_radiance(const kit_image *env, const float direction[3], float rgb[3]);
/* Between a direction and its place in the picture, in texels from the top left corner: (0.5, 0.5) is the first texel's
   centre. */
/* in [0, width] x [0, height]; direction need not be unit */
void kit_env_place(const kit_image *env, const float direction[3], double at[2]);
void kit_env_direction(const kit_image *env, double x, double y, float direction[3]);  /* unit */
/* The picture as three floats a texel, row by row, which ssgi.h takes; free(). NULL: no memory. */
float *kit_env_interleaved(const kit_image *env);

/* Published constants of scattering [JMLH01 figure 5], per millimetre: number i; NULL past them. */
typedef struct kit_material { const char *name; float sigma_s[3], sigma_a[3], eta; } kit_material;
const kit_material *kit_material_of(int i);

/* "point:x,y,z,r,g,b" or "sun:x,y,z,r,g,b": numbers in -KIT_MOST..KIT_MOST, colours 0 or more; a sun's direction need
   not be unit, but not 0. Places are about a mesh's origin then; NULL: about 0. */
int  kit_light_parse(kit_light *light, const char *text, const double origin[3], kit_error *err);

/* ---- >>truth ------------------------------------------------------------------------------------------------ */

void kit_camera_planes(kit_camera *camera, const kit_mesh *mesh);         /* fills znear and zfar where they are 0 */
/* moves the eye to where from's is when turned about its target, around its up */
void kit_camera_orbit(kit_camera *camera, const kit_camera *from, double degrees);
/* world to view, view to clip as the depth layout wants it (REVERSED and INFINITE: clip z in [0, w]; NORMAL: [-w,
   w]) */
void kit_camera_matrices(const kit_camera *camera, float view[16], float projection[16]);
/* A frame's place and window of a camera (not its radius), and back: of what the header has, the camera's width and
   height being the frame's. */
void kit_camera_to_header(kit_header *header, const kit_camera *camera);
void kit_camera_from_header(kit_camera *camera, const kit_header *header);
/* the ray through the centre of the pixel in column x, row y counted from the TOP; direction is unit; origin is on the
   eye (perspective) or on the plane of the eye (orthographic) */
void kit_camera_ray(const kit_camera *camera, int x, int y, float origin[3], float direction[3]);
/* the point in the world that such a pixel shows at a view depth */
void kit_camera_point(const kit_camera *camera, int x, int y, double view_depth, float point[3]);
/* A radius over the frame's height, as it is seen: the mean over the pixels that Z has. */
double kit_screen_radius(const kit_image *frame, const kit_camera *camera, float radius);

/* weight of a occluder at distance t, R the radius: 1 - t/R, 1, 1 - (t/R)^2; 0 beyond R */
enum { KIT_ATTENUATION_LINEAR, KIT_ATTENUATION_NONE, KIT_ATTENUATION_SQUARE };

/* Ray-traced ambient visibility of every pixel (channel Y; 1 where nothing is seen): primary ray through the pixel's
   centre, then rays cosine-weighted about the shading normal (turned toward the viewer), stratified, each blocked by
   the nearest hit at t < radius with the attenuation's weight. rays 1..65536; radius above 0, INFINITY only with NONE.
   stride > 1 computes one pixel in every stride x stride block (its top-left one offset by stride/2) and leaves NaN
   elsewhere. Same result for any number of threads. */
int kit_truth_ao(kit_image *out, const kit_scene *scene, const kit_camera *camera, float radius, int attenuation,
                 int rays, int stride, kit_error *err);

/* Two such pictures of linear attenuation, channels Y and again, whose noise is independent: the mean product of what a
   picture is off by from each is its squared error, without the truth's noise. */
int kit_truth_pair(kit_image *out, const kit_scene *scene, const kit_camera *camera, float radius, int rays,
                   kit_error *err);

/* The same between objects: rays are blocked at any distance, by objects that cast and are not the one that the pixel
   shows; they pass through all others. */
int kit_truth_objects(kit_image *out, const kit_scene *scene, const kit_camera *camera, int rays, int stride,
                      kit_error *err);

/* what lit pictures hold */
#define KIT_LIT_CHANNELS "R,G,B,irradiance.R,irradiance.G,irradiance.B,bounce.R,bounce.G,bounce.B"

/* Ray-traced light of every pixel; all channels 0 where nothing is seen:
     R, G, B            outgoing radiance: albedo * (irradiance + bounce)
     irradiance.R .G .B irradiance over pi, before albedo: the environment, each direction blocked by the nearest hit at
        t < radius with the attenuation's
                        weight; and the lights, shadowed by the whole scene
     bounce.R .G .B     the same of light reflected once (all 0 if bounce is 0, else it must be 1): each direction's
        nearest hit at t < radius sends albedo *
                        irradiance (as above, at the hit, on the side that is hit) with the attenuation's weight
   Primary rays, normals, stride, threads and limits as in kit_truth_ao. Half of the rays are cosine-weighted and also
   find the bounce, half seek the environment's light (without environment all are of the first kind); every hit that
   bounces sends one of each and one to each light. Without bounce, texels of 50 times the environment's mean luminance,
   up to 512, get a ray each beside those. lighting: env without data or as kit_env_read gives it (fewer than 3
   channels fail; values that are not finite or below 0 spoil the result). */
int kit_truth_lit(kit_image *out, const kit_scene *scene, const kit_camera *camera, const kit_lighting *lighting,
                  float radius, int attenuation, int bounce, int rays, int stride, kit_error *err);

/* One specular bounce: irradiance.* holds the radiance of the lobe cos^exponent [limit: 0..1e5] about the mirrored view
   direction, normalised over its hemisphere: each direction's nearest hit at t < radius sends, with the attenuation's
   weight, what it sends for kit_truth_lit's bounce; nothing comes from below the surface or from elsewhere. R, G, B are
   albedo times it, bounce is 0. Else as kit_truth_lit, whose hits' light is the noisy part. */
int kit_truth_gloss(kit_image *out, const kit_scene *scene, const kit_camera *camera, const kit_lighting *lighting,
                    float radius, int attenuation, double exponent, int rays, int stride, kit_error *err);

/* The light that ambient visibility stands for when it dims light; NaN where nothing is seen:
     Y            ambient visibility, as kit_truth_ao has it
     bent, normal cosines of the mirrored view direction to the mean unoccluded direction, and to the normal
     white.*      Y of surfaces that reflect, all of one albedo, under light of 1 from everywhere: any number of bounces
                  within the radius
     lobe.*       the share of a glossy lobe that nothing occludes: directions by which GGX's half vectors of a
                  roughness mirror the view, above the surface
   Rays as in kit_truth_ao, each with a path, and as many a lobe. */
#define KIT_REFLECTED_ALBEDOS { 0.2f, 0.5f, 0.8f }
#define KIT_REFLECTED_ROUGHNESSES { 0.05f, 0.15f, 0.35f, 0.7f }     /* alpha, the square of what artists set */
#define KIT_REFLECTED_CHANNELS "Y,bent,normal,white.1,white.2,white.3,lobe.1,lobe.2,lobe.3,lobe.4"
int kit_truth_reflected(kit_image *out, const kit_scene *scene, const kit_camera *camera, float radius, int rays,
                        int stride, kit_error *err);

/* Multiple scattering [Jensen and Buhler 2002], the sum itself instead of their octree: irradiance.* holds M/pi = sum E
   A R_d / pi over samples [limit: 1..2^26] spread evenly over all of the mesh, each with the irradiance E of the lights
   (the environment is not looked at), shadowed by the whole scene, on the side of its normals. unit: world units of the
   dipole's unit of length [limit: > 0]. R, G, B are albedo times it, bounce is 0. Where samples are farther apart than
   z_r / 2 the sum is noisy. R_d from a table: to 1e-4 for z_r above 2e-3 of the bounds' diagonal. Time: about 2 ns a
   pixel and lit sample, a core. */
struct ssgi_dipole;                        /* ssgi.h's */
int kit_truth_scatter(kit_image *out, const kit_scene *scene, const kit_camera *camera, const kit_lighting *lighting,
                      const struct ssgi_dipole *dipole, float unit, size_t samples, int stride, kit_error *err);

/* Where a picture's error sits. Channels edge, border, interior: each pixel is of one kind, 1 there; all 0 where
   nothing is seen. frame: channel Z, view depth as in the build/render contract, of that camera.
     edge      within 3 pixels, along its row or column, of a jump in depth: between two neighbours u (1/z; z if
               orthographic), which is straight on a plane however it is tilted, changes by more, or by less, than on
               both sides of them; that makes over a 20th of the radius, and over 0.2 % of the depth, in which frames
               stored as halves are rounded. A fold is no jump: the change lies between those of its two planes. Of
               jumps in a row that grow, a pixel each, only the largest is one. What is seen against nothing is an edge,
               but for a plane that ends at its horizon
     border    else, nearer to the picture's border than the radius is long, facing the camera at the pixel's depth
     interior  what is left */
enum { KIT_EDGE, KIT_BORDER, KIT_INTERIOR, KIT_PLACES };
int  kit_image_places(kit_image *out, const kit_image *frame, const kit_camera *camera, float radius, kit_error *err);
/* Scores of each kind alone, of count channels together; area: its share of the pixels that are known, error: of their
   squared error. All 0 where there is no such pixel. */
typedef struct kit_score_place { kit_score score; double area, error; } kit_score_place;
int  kit_score_places(kit_score_place place[KIT_PLACES], const kit_image *a, const kit_image *b,
    const char *const *channels, int count, const kit_image *places, kit_error *err);

/* The floor: the exact answer from what one depth layer holds. frame: channels Z, N.X, N.Y, N.Z as in the build/render
   contract (view depth, view-space normals). The visible surface is rebuilt as thin sheets (neighbouring pixel centres
   are joined where they lie on one surface) and traced likewise. */
int kit_floor_ao(kit_image *out, const kit_image *frame, const kit_camera *camera, float radius, int attenuation,
                 int rays, int stride, kit_error *err);

/* How well a frame's normals agree with those that its depth has by the camera. frame: channels as for the floor. It
   looks at pixels, at most some 500 to a side, whose neighbours lie on one surface with them. */
#define KIT_OFF 45.0
typedef struct kit_agreement {
    int    pixels;
    double off, angle;                     /* share of them where they differ by more than KIT_OFF degrees; median */
    /* how much steeper normals are to the view axis than those of depth, median of tangents: a lens so much too wide */
    double steeper;
} kit_agreement;
int  kit_frame_agreement(kit_agreement *out, const kit_image *frame, const kit_camera *camera, kit_error *err);

/* ---- >>gl, >>gbuffer, >>method: see kit_gl.h ------------------------------------------------------------------- */
#endif
