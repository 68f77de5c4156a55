/* kit.h - the small embedder that the examples and the tests share. Not part of the library.

   It has the things that an engine already has (a headless GL context, meshes, images, a G-buffer) and those that only
   a laboratory needs (ray-traced ground truth and scores). A room is a folder. It calls only those above it:

     kit/       util.c     errors, progress, threads, whole files, JSON, vectors
                image.c    float images; exr.c, hdr.c, png.c read and write them; score.c compares them
     scene/     mesh.c     triangles of an OBJ from a package; soup.c: objects of any model
                models.c   users' models, by assimp.c and gltf.c; texture.c and cards.c cut holes into cards
                scene.c    scenes by name or path, objects and their places; shapes.c: their shapes;
                           scenes.c: the built-in scenes, of buildings.c, thin.c and solids.c; seeds.c: scenes drawn
                           from a seed by the rows of tables/, and models of packages: see kit_seed.h
                light.c    environments and lights
     trace/     camera.c   cameras
                truth.c    ray-traced ground truth by ssgi.h's room trace; lit.c: of light, scatter.c: under surfaces
                floor.c    the best answer that one depth layer allows
                places.c   where the error of an image is: edges, border, interior
                agree.c    whether the normals of a frame fit its depth under the camera
     gl/        gl.c       contexts (OSMesa, EGL), GL functions, textures, targets, programs
                gbuffer.c  the G-buffer: rasterised from a scene or read from a frame's EXR
                shadow.c   shadow maps as one atlas, reflective shadow maps
                field.c    ambient occlusion fields of a scene's shapes, baked and as textures
     run/       settings.c the table of methods and their settings
                run.c      prepares a method on a G-buffer; kit_run.h names the other files of this folder
                frames.c   one frame after another
                plan.c     measures a scene for the planner

   CONVENTIONS
     errors    every function that can fail returns 0, or -1 with one line in the kit_error that names the file or
               argument and its fault; outputs are then untouched and nothing needs freeing. err may be NULL.
     pictures  planar floats, row 0 at the top
     matrices  float[16], column-major, as in ssgi.h
     world     right-handed; angles in degrees in this interface, because people type them; radians inside */
#ifndef KIT_H
#define KIT_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#define KIT_PI 3.14159265358979323846
#define KIT_MOST 1e12                      /* the largest number that a user may give; its square still fits a float */

/* ---- >>util ------------------------------------------------------------------------------------------------- */

typedef struct kit_error { char text[1024]; } kit_error;

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
int    kit_fail(kit_error *err, const char *format, ...);   /* writes the line unless err is NULL; always returns -1 */
/* Opens a regular file that is not empty and writes its size, for callers that check the file's start before they read
   the rest. Returns NULL if it cannot be opened. The caller calls fclose(). */
FILE  *kit_file_open(size_t *size, const char *path, kit_error *err);
/* Reads a file that kit_file_open takes whole and puts a 0 byte after its content. The caller calls free(data). */
int    kit_file_read(char **data, size_t *size, const char *path, kit_error *err);
/* Writes the whole file or nothing: it writes a temporary file in the same folder and renames it. Signals other than
   SIGKILL are held back until that is done (other threads must have them blocked). A file that exists keeps its mode
   and, if the system allows it, its owner. */
int    kit_file_write(const char *path, const void *data, size_t size, kit_error *err);
/* kit_json_string writes a string with its quotes; bytes that are not UTF-8 become U+FFFD. kit_json_number writes
   `decimals` decimals, or -decimals significant digits if that is below 0; null if v is not finite. */
void   kit_json_string(FILE *out, const char *text);
void   kit_json_number(FILE *out, double v, int decimals);
/* Prints the words of a text, the first at `column`, in lines of at most `most` characters. Later lines begin at
   `indent`. */
void   kit_print_words(const char *text, int column, int indent, int most);
/* A row of a program's command line, of its --help, or of both; the last has neither name nor text. A row without a
   name is a paragraph. `at` is the offset of the member that takes the value. Its type follows from the kind. FLAG: an
   int that becomes 1. NUMBERS: `least` doubles. SIZE: int[2]. LIST: const char *[], whose number, up to `most`, stands
   at offset `said`. With other kinds the int at `said`, unless that is 0, becomes 1. TAKEN: take() reads the value.
   TOLD: the row is help alone. */
typedef struct kit_option {
    const char *name, *value, *about;
    enum { KIT_TOLD, KIT_FLAG, KIT_TEXT, KIT_WHOLE, KIT_NUMBER, KIT_NUMBERS, KIT_SIZE, KIT_LIST, KIT_TAKEN } kind;
    size_t at;
    double least, most;
    size_t said;
    int    empty;                                           /* 1: the value may be empty */
    int  (*take)(void *to, const char *name, const char *text, kit_error *err);
} kit_option;
/* Prints the help if --help or -h is the only argument, or the version for --version, and then returns 1. */
int    kit_help(int argc, char **argv, const char *usage, const kit_option *table);
/* kit_options fills a struct from all arguments. Those without a "-" go to other(); NULL: there are none. _take does so
   for one option and the argument behind it (NULL: none), and returns how many it took; -1: refused. */
int    kit_options(void *to, const kit_option *table, int argc, char **argv,
                   int (*other)(void *to, const char *text, kit_error *err), kit_error *err);
int    kit_option_take(void *to, const kit_option *table, const char *name, const char *text, kit_error *err);
/* Read a value: numbers in world units, up to KIT_MOST, with commas between; one number or whole number in least..most;
   "WxH", each in least..most. */
int    kit_numbers(const char *name, const char *text, double *out, int count, kit_error *err);
int    kit_number(const char *name, const char *text, double least, double most, double *out, kit_error *err);
int    kit_whole(const char *name, const char *text, int least, int most, int *out, kit_error *err);
int    kit_size(const char *name, const char *text, int least, int most, int out[2], kit_error *err);
/* Returns the number of digits with which a text begins, and moves *at past them; 0: none, or it is above most. */
int    kit_digits(const char **at, int most);
/* Called at a program's start and end. open connects closed standard streams to /dev/null, so that no file takes their
   place, and makes the signal for a file above the size limit an error. close returns -1 if printed text was lost. */
void   kit_streams_open(void);
int    kit_streams_close(kit_error *err);
double kit_seconds(void);                                   /* monotonic clock */
double kit_median(double *v, int count);                    /* sorts v; count > 0 */
float  kit_middle(float *v, size_t count); /* also reorders v; returns the median, of two middle values the upper one */
double kit_dot(const double a[3], const double b[3]);
void   kit_cross(const double a[3], const double b[3], double out[3]);      /* out must be neither a nor b */
int    kit_unit(double v[3]);                   /* makes v a unit vector; 0: it has no direction and is left as it is */
int    kit_face(const float corner[9], double n[3]);   /* writes the unit normal of a triangle's face; 0: it has none */
/* Computes the FNV-1a hash of size bytes, continued from h; the first call passes KIT_HASH. */
#define KIT_HASH UINT64_C(14695981039346656037)
uint64_t kit_hash(uint64_t h, const void *data, size_t size);

/* A number by its name of so many letters. */
typedef struct kit_variable { const char *name; int length; double value; } kit_variable;
/* Reads an expression as kit_seed.h explains them. *text moves past it. Of variables of one name the last counts; key:
   of its chances. Returns NULL, or what is wrong and where. */
const char *kit_expression(double *out, const char **text, const kit_variable *variable, int variables, uint32_t key,
                           const char **where);

/* Shows an activity, its progress and the time left on stderr if that is a terminal, else nothing. fraction 0 starts
   the clock, 1 clears the line. Call it as often as you like: it redraws at most ten times a second. */
void   kit_progress(const char *what, double fraction);

/* Calls job(context, i) for every i in [0, count) on as many threads as the machine has cores (KIT_THREADS in the
   environment overrides this), in any order. what: the activity that kit_progress shows, NULL = none. */
void   kit_parallel(const char *what, int count, void (*job)(void *context, int i), void *context);

/* ---- >>image ------------------------------------------------------------------------------------------------ */

#define KIT_MAX_CHANNELS 64
typedef struct kit_image {
    int    width, height, channels;
    char   name[KIT_MAX_CHANNELS][32];     /* as in the EXR file: "Y", "R", "N.X", "layer1.Z" */
    float *data;                           /* channel c, row y, column x: data[((size_t)c * height + y) * width + x] */
} kit_image;

/* Makes an image with channels of these names, for example "Z,N.X,N.Y,N.Z". All pixels are 0. */
int    kit_image_new(kit_image *image, int width, int height, const char *names, kit_error *err);
void   kit_image_free(kit_image *image);         /* frees the pixels and sets the struct to zero; may be called again */
float *kit_image_channel(const kit_image *image, const char *name);      /* returns NULL if there is no such channel */

/* Reads and writes EXR by OpenEXR's C core. Every channel (half, float, uint; any order; scanlines or tiles) is read as
   float; look channels up by name. Refused are deep and subsampled files and those that the C core cannot decompress
   (DWAA, DWAB in 3.1). Of a file with several parts, the flat ones of the first view are read, on a window that holds
   all of theirs; a channel whose name an earlier part has is called PART.NAME. A header that claims more than the
   file's bytes can hold is refused before memory is allocated. Files are written as 32-bit float, ZIP, to a temporary
   name in the same folder, then renamed: never half-written. */
int    kit_exr_read(kit_image *image, const char *path, kit_error *err);
int    kit_exr_write(const kit_image *image, const char *path, kit_error *err);

/* The camera in an EXR's header, for the file's pixels as they are: if the data window differs from the display window,
   the view is off-centre.
     worldToCamera       m44f, as in OpenEXR's standard: the camera is left-handed (x to the right, y up, looking
                         down +z) and the matrix is for row vectors, so its numbers are stored as this kit stores them.
                         It turns and moves a right-handed world, without scale
     ssgi.worldToCamera  m44d: the same in doubles, for a camera so far from 0 that floats are too coarse; it has
                         precedence
     screenWindowWidth, screenWindowCenter   as in the standard: the picture on the plane at distance 1, +y up;
                         ignored without worldToCamera, because every EXR has them
     ssgi.orthoHeight    float: the picture is orthographic; its display window is this high in world units, and the
                         screen window is in world units, too
     ssgi.radius         float: a suitable radius, world units
   wanted: the parts to read; the others are ignored. header->has: the parts that were found. A malformed one is an
   error. KIT_HEADER_PART: the caller gives header->orthographic and height for the display window; if the data window
   is another, header receives the data window's. */
enum { KIT_HEADER_PLACE = 1, KIT_HEADER_WINDOW = 2, KIT_HEADER_RADIUS = 4, KIT_HEADER_ALL = 7, KIT_HEADER_PART = 8 };
typedef struct kit_header {
    int   has;
    float world_to_camera[16];             /* relative to origin */
    double origin[3];                      /* a mesh's, or the eye */
    int   orthographic;
    float height, centre[2];               /* of the screen window: at distance 1; in world units if orthographic */
    float radius;
} kit_header;
int    kit_exr_header(kit_header *header, int wanted, const char *path, kit_error *err);
/* Writes the image and the parts of the camera header that header->has names; header may be NULL. */
int    kit_exr_write_frame(const kit_image *image, const kit_header *header, const char *path, kit_error *err);
/* Reads a Radiance .hdr by stb, flat rows or run-length rows (not the old run-length format), as channels R, G, B. A
   header that claims more than the file can hold is refused. */
int    kit_hdr_read(kit_image *image, const char *path, kit_error *err);

/* Writes an 8-bit PNG by stb, of 1 channel (grey) or 3 (RGB), in the order of names ("Y" or "R,G,B"); values are
   clamped to [0,1], NaN is written as 0. srgb: 1 encodes linear values as sRGB, 0 writes them unchanged (ambient
   visibility, colour maps). Written under a temporary name and renamed, as an EXR. */
int    kit_png_write(const kit_image *image, const char *names, int srgb, const char *path, kit_error *err);

/* All figures are of a - b; p95: of its absolute value. mask: a pixel counts if its number is above 0; NULL: all do. */
typedef struct kit_score { double rmse, bias, p95, ssim; size_t pixels; } kit_score;
int kit_score_channel(kit_score *score, const kit_image *a, const kit_image *b, const char *channel, const float *mask,
                      kit_error *err);
/* Scores `count` channels together: rmse is the root of their mean square, other figures are means over channels. */
int kit_score_channels(kit_score *score, const kit_image *a, const kit_image *b, const char *const *channels, int count,
                       const float *mask, kit_error *err);

/* Draws the signed difference (a - b) of one channel in a perceptually uniform diverging colour map: near-white at 0,
   blue where a is darker than b, red where it is brighter, full colour at +-range. out: a new R,G,B image that is
   sRGB-encoded already (write it with srgb 0). */
int kit_image_difference(kit_image *out, const kit_image *a, const kit_image *b, const char *channel, float range,
                         kit_error *err);

/* ---- >>mesh ------------------------------------------------------------------------------------------------- */

/* A triangle soup: corner k of triangle t at index 3*t + k. */
typedef struct kit_mesh {
    size_t triangles;
    float *position;                       /* 9 a triangle */
    float *normal;                       /* 9 floats a triangle, unit vectors; the face's normal if the file has none */
    float *albedo;                         /* 3 floats a triangle, linear, [0,1]; 0.8 grey if the file has none */
    /* one number a triangle: that of its object, from 1 on; 0 = no object. NULL: the mesh has no objects */
    uint32_t *object;
    float  lower[3], upper[3];             /* bounds */
    /* The point in the file's own coordinates that is the origin of this mesh. It is 0, unless the mesh lies farther
       from 0 than a hundred of its diagonals, too far for floats; then it is near the middle of the bounds */
    double origin[3];
} kit_mesh;

/* A rigid part of a scene that can be moved. Object number k + 1 is object[k]. */
#define KIT_MAX_OBJECTS 256                /* the most objects of one OBJ file */
typedef struct kit_object {
    char   name[64];
    int    shape;                          /* index into the scene's shapes */
    float  to_world[16];       /* from the shape's own coordinates to the world: rotation, uniform scale, translation */
    float  lower[3], upper[3];             /* world bounds */
    int    casts;                          /* 1 = it occludes other objects; kit_scene_load decides */
    /* index of its first triangle in the scene's mesh; the others follow in order, perhaps among other objects' */
    size_t first;
    float  loaded[16];                   /* to_world as it was loaded, if kit_scene_move moves the object; else all 0 */
    int    base;                  /* index of the lowest object of the stack with which kit_scene_move moves this one */
} kit_object;

void   kit_mesh_free(kit_mesh *mesh);
void   kit_mesh_bounds(kit_mesh *mesh);         /* sets the bounds from the triangles */
/* Reads an OBJ. Its objects are the names on o lines; if these make fewer than two, the names on g lines; if these do
   as well, the connected parts (corners at equal positions join). A name is one object however often it occurs. Objects
   are numbered in the order of their first triangles. If there are more than KIT_MAX_OBJECTS, only the KIT_MAX_OBJECTS
   - 1 with most triangles are objects; all others are the last one, "rest", which does not cast (casts 0). object: an
   array with name, first and casts filled in (casts -1: still to be decided), which the caller frees; it and objects
   may be NULL. */
int    kit_mesh_obj(kit_mesh *mesh, kit_object **object, int *objects, const char *path, kit_error *err);

typedef struct kit_camera {
    float eye[3], target[3], up[3];
    float fovy;                            /* degrees, full vertical angle; 0 = orthographic */
    float ortho_height;                    /* world units from bottom to top of the picture, when fovy is 0 */
    float znear, zfar;                     /* 0 = from the scene's bounds (kit_camera_planes) */
    int   width, height;
    float shift[2];                        /* pixels by which the projection's centre is moved: off-centre frustum */
    int   depth;                           /* KIT_DEPTH_..: the layout of window depth */
} kit_camera;
enum { KIT_DEPTH_NORMAL, KIT_DEPTH_REVERSED, KIT_DEPTH_INFINITE /* reversed, far plane at infinity */ };

enum { KIT_SUN, KIT_POINT };
typedef struct kit_light {
    int   kind;
    float at[3];                    /* SUN: unit vector from the scene to the light; POINT: its position. World space */
    float colour[3];                       /* SUN: irradiance of a surface that faces it; POINT: radiant intensity */
} kit_light;

enum { KIT_SCENE_LIGHTS = 4 };
typedef struct kit_scene {
    const char *name;                      /* a built-in scene's name, or a path */
    const char *about;                     /* one line */
    char        note[512];                 /* one line: how the model differs from its file, "" = not at all */
    kit_mesh    mesh;
    kit_camera  camera;                    /* a suitable view; width, height 1280 x 720 */
    float       radius;                    /* a suitable radius, world units */
    const char *env;          /* for scenes by seed, the name of the built-in environment that lights them; else NULL */
    int         lights;                    /* further lights */
    kit_light   light[KIT_SCENE_LIGHTS];
    int         objects, shapes;
    kit_object *object;
    /* meshes in their own coordinates, with positions, normals and bounds only. Several objects may share one. An
       object's triangles in mesh are those of its shape, transformed by to_world */
    kit_mesh   *shape;
} kit_scene;

/* Loads a scene. name_or_path is one of:
     a built-in scene ("room")
     a scene by seed ("random:7", "random:streets:7"), the same on every machine; "random:SEED" has kind SEED modulo
     KIT_KINDS
     a model from a package on a floor ("model:bunny", "model:bunny:7"); the seed chooses camera and radius
     a model's file: OBJ; if this build has Assimp, also glTF, GLB, PLY, FBX and its other formats
   Of a file, triangles are where the nodes put them, in the pose that the file has. Nodes are objects as an OBJ's o
   lines are, and meshes as its g lines are. Albedo is the base colour times the mean of its texture and of the corners'
   colours. A card whose texture has holes is cut along its texels, or along squares of texels: at most 4096 of them a
   triangle, fewer if more than 512 triangles are cut. (glTF: alphaMode MASK, or BLEND with alpha nearly all 0 or 1;
   other formats: such alpha, or an opacity map.) FBX, Collada, IFC and 3DS are turned upright, others are not. Units
   stay. A model farther from 0 than 100 diagonals of its bounds is read in doubles, as far as its format has them. All
   places here are then relative to mesh.origin; the note says so, and whether numbers are coarse. The camera looks at
   the bounds from the front, above and to the side, with all in view; radius is a tenth of the bounds' diagonal.
   floor_: adds a square at the model's lowest y, five diagonals wide, as object "floor". Every triangle has an object.
   Each object of a model is its own shape, with to_world 1. It casts unless it is flat (the thinnest side of its bounds
   is below 1e-3 of the widest) or its bounds hold those of most other objects entirely, as rooms and grounds do. In a
   built-in scene, the scene decides which objects cast. */
int         kit_scene_load(kit_scene *scene, const char *name_or_path, int floor_, kit_error *err);
void        kit_scene_free(kit_scene *scene);
int         kit_scene_seeded(const char *name);    /* returns 1 if the scene has its own light */
/* Return the name of the i-th built-in scene, of the i-th kind of scenes by seed, and of the i-th model that packages
   have; NULL past the last. */
const char *kit_scene_builtin(int i, const char **about);
const char *kit_scene_kind(int i, const char **about);
const char *kit_scene_model(int i);
enum { KIT_KINDS = 7 };

/* Appends a closed box as an object "box" to the scene's mesh, and widens the bounds. Sides are at least 1e-4 units,
   all finite; albedo linear, [0, 1]. It casts as an OBJ's object would; objects that now hold most others cast no
   more. */
int kit_scene_add_box(kit_scene *scene, const float lower[3], const float upper[3], const float albedo[3],
                      kit_error *err);

/* Places object[object]: changes its triangles in the mesh (positions, normals), its bounds and the mesh's. to_world: a
   rotation (no mirroring), a uniform scale above 0 and a translation, to 1e-3, all below 1e15. For any other, or if
   there is no such object: -1, and nothing changes. */
int         kit_scene_place(kit_scene *scene, int object, const float to_world[16], kit_error *err);

/* Moves the first object that casts by times * by. -1 if by is not 0 and no object casts. */
int         kit_scene_slide(kit_scene *scene, const float by[3], int times, kit_error *err);

/* Places the objects of "casters" and "crowd" for a time: they orbit, hop and tumble around their places as loaded,
   smoothly, with period 1 (0 = as loaded), never below the ground. All other objects and scenes stay. */
void        kit_scene_move(kit_scene *scene, double time);

#define KIT_BEHIND 0.2f                    /* grey of colour images where no surface is seen */

/* ---- >>light ------------------------------------------------------------------------------------------------ */

#define KIT_MAX_LIGHTS 16
typedef struct kit_lighting {
    kit_image env;                         /* radiance in the layout of kit_env_read; data NULL: no environment */
    float     reach;                /* radius of the shadows of lights in the ground truth, world units; 0: unlimited */
    int       lights;
    kit_light light[KIT_MAX_LIGHTS];
} kit_lighting;

/* Reads an environment. Built in are "sky", a clear sky with a soft sun side, no sharp sun; "probe", a dim room with
   coloured windows and lamps up to a thousand times as bright; "windows", a room by day; "street", a street at night
   whose lamps give most of the light from a thousandth of the sphere; "white", radiance 1 everywhere. Else an .exr or
   .hdr file with channels R, G, B. Latitude-longitude, oriented as OpenEXR defines it: +y up, the picture's centre
   looks to +z, +x left of the centre; texels are areas, so the first row ends at the pole. env gets channels R,G,B in
   this order; values that are not finite or below 0 become 0. */
int  kit_env_read(kit_image *env, const char *name_or_path, kit_error *err);
/* Turns the environment about +y, anticlockwise as seen from above, and scales its radiance. */
int  kit_env_adjust(kit_image *env, double degrees, double strength, kit_error *err);
/* Adds the own light of a scene by seed: its environment and its lights. lighting must be empty. */
int  kit_light_scene(kit_lighting *lighting, const kit_scene *scene, kit_error *err);
/* Draws a sun into env as a disc with soft edges, such that a surface facing it receives the sun's colour as
   irradiance. If env has no data it becomes 1024 x 512 black texels first. degrees: half-angle, from one texel's height
   to 45. The light must be a SUN. */
int  kit_env_add_sun(kit_image *env, const kit_light *sun, double degrees, kit_error *err);
/* Writes the radiance of a direction, which need not be unit: bilinear, wrapping around; 0 if data is NULL. */
void kit_env_radiance(const kit_image *env, const float direction[3], float rgb[3]);
/* Convert between a direction and its place in the environment's image, in texels from the top left corner: the centre
   of the first texel is (0.5, 0.5). */
/* at: in texels, in [0, width] x [0, height]; direction need not be unit */
void kit_env_place(const kit_image *env, const float direction[3], double at[2]);
void kit_env_direction(const kit_image *env, double x, double y, float direction[3]);  /* unit */
/* Returns an environment as three floats a texel, row by row, for ssgi.h; NULL: no memory. The caller calls free(). */
float *kit_env_interleaved(const kit_image *env);

/* Published scattering constants [JMLH01 figure 5], per millimetre. The function gives the i-th; NULL past the last. */
typedef struct kit_material { const char *name; float sigma_s[3], sigma_a[3], eta; } kit_material;
const kit_material *kit_material_of(int i);

/* Parses "point:x,y,z,r,g,b" or "sun:x,y,z,r,g,b": numbers in -KIT_MOST..KIT_MOST, colours at least 0. A sun's
   direction need not be unit, but not 0. The position is stored relative to origin, a mesh's; NULL: to 0. */
int  kit_light_parse(kit_light *light, const char *text, const double origin[3], kit_error *err);

/* ---- >>truth ------------------------------------------------------------------------------------------------ */

void kit_camera_planes(kit_camera *camera, const kit_mesh *mesh);         /* sets znear and zfar if they are 0 */
/* Sets camera's eye to from's eye, turned by degrees about from's target, around from's up vector. */
void kit_camera_orbit(kit_camera *camera, const kit_camera *from, double degrees);
/* Writes the matrices to view and clip space. REVERSED and INFINITE: clip z in [0, w]; NORMAL: [-w, w]. */
void kit_camera_matrices(const kit_camera *camera, float view[16], float projection[16]);
/* Convert a camera to the position, rotation and window of a header (not the radius), and back. From a header only the
   parts that it has are taken; the camera's width and height must be the frame's. */
void kit_camera_to_header(kit_header *header, const kit_camera *camera);
void kit_camera_from_header(kit_camera *camera, const kit_header *header);
/* Writes the ray through the centre of the pixel in column x, row y counted from the TOP. direction is unit; origin is
   the eye (perspective) or on the plane of the eye (orthographic). */
void kit_camera_ray(const kit_camera *camera, int x, int y, float origin[3], float direction[3]);
/* Writes the world-space point that is seen at a view depth in the pixel in column x, row y counted from the top. */
void kit_camera_point(const kit_camera *camera, int x, int y, double view_depth, float point[3]);
/* Returns the projection of a radius in image heights, a mean over the pixels that show a surface. */
double kit_screen_radius(const kit_image *frame, const kit_camera *camera, float radius);

/* How an occluder's weight falls with its distance t, R the radius: 1 - t/R, 1, 1 - (t/R)^2; it is 0 beyond R. */
enum { KIT_ATTENUATION_LINEAR, KIT_ATTENUATION_NONE, KIT_ATTENUATION_SQUARE };

/* Ray-traces the ambient visibility of every pixel (channel Y; 1 in the background). A primary ray goes through the
   pixel's centre. Stratified rays, cosine-weighted about the shading normal (turned toward the viewer), are each
   blocked by the nearest hit at t < radius with the attenuation's weight. rays 1..65536; radius above 0, INFINITY only
   with NONE. stride > 1 computes one pixel in every stride x stride block (its top-left one offset by stride/2) and
   writes NaN elsewhere. The result does not depend on the number of threads. */
int kit_truth_ao(kit_image *out, const kit_scene *scene, const kit_camera *camera, float radius, int attenuation,
                 int rays, int stride, kit_error *err);

/* Ray-traces visibility with linear attenuation twice, in the channels "Y" and "again", whose noise is independent. The
   mean product of an image's differences from both is its squared error, without the noise of the ground truth. */
int kit_truth_pair(kit_image *out, const kit_scene *scene, const kit_camera *camera, float radius, int rays,
                   kit_error *err);

/* Ray-traces visibility between objects: rays are blocked at any distance, by casting objects but the pixel's own. */
int kit_truth_objects(kit_image *out, const kit_scene *scene, const kit_camera *camera, int rays, int stride,
                      kit_error *err);

/* the channels of images of light */
#define KIT_LIT_CHANNELS "R,G,B,irradiance.R,irradiance.G,irradiance.B,bounce.R,bounce.G,bounce.B"

/* Ray-traces the light of every pixel; all channels are 0 in the background:
     R, G, B            outgoing radiance: albedo * (irradiance + bounce)
     irradiance.R .G .B irradiance over pi, before albedo: light of the environment, each direction blocked by the
                        nearest hit at t < radius with the attenuation's weight; and the lights, shadowed by the whole
                        scene
     bounce.R .G .B     the same of light that is reflected once (all 0 if bounce is 0; else bounce must be 1): in each
                        direction, the nearest hit at t < radius sends albedo * irradiance (as above, on the side that
                        is hit) with the attenuation's weight
   Primary rays, normals, stride, threads and limits as in kit_truth_ao. Half of the rays are cosine-weighted and also
   find the bounce; the other half are drawn by the environment's light (without an environment all are of the first
   kind). Every hit that bounces light sends one ray of each kind and one to each light. Without bounce, texels brighter
   than 50 times the environment's mean luminance, up to 512 of them, get a further ray each. lighting: env without data
   or as kit_env_read gives it (fewer than 3 channels fail; values that are not finite or below 0 spoil the result). */
int kit_truth_lit(kit_image *out, const kit_scene *scene, const kit_camera *camera, const kit_lighting *lighting,
                  float radius, int attenuation, int bounce, int rays, int stride, kit_error *err);

/* Ray-traces one specular bounce: irradiance.* holds the radiance of the lobe cos^exponent [limit: 0..1e5] about the
   mirrored view direction, normalised over its hemisphere. In each direction the nearest hit at t < radius sends the
   light that it sends in the bounce of kit_truth_lit, with the attenuation's weight; all other directions, and those
   below the surface, give none. R, G, B are albedo times it, bounce is 0. All else as in kit_truth_lit; most noise is
   in the light of the hits. */
int kit_truth_gloss(kit_image *out, const kit_scene *scene, const kit_camera *camera, const kit_lighting *lighting,
                    float radius, int attenuation, double exponent, int rays, int stride, kit_error *err);

/* Ray-traces the light that ambient visibility approximates when it dims light; NaN in the background:
     Y            ambient visibility, as in kit_truth_ao
     bent, normal cosines of the mirrored view direction to the mean unoccluded direction, and to the normal
     white.*      Y of surfaces that reflect, all of one albedo, under light of 1 from everywhere: any number of bounces
                  within the radius
     lobe.*       the part of a glossy lobe that nothing occludes: directions above the surface in which half vectors
                  of GGX with a roughness mirror the view
   Rays as in kit_truth_ao. Each continues as a path, and each lobe has as many. */
#define KIT_REFLECTED_ALBEDOS { 0.2f, 0.5f, 0.8f }
#define KIT_REFLECTED_ROUGHNESSES { 0.05f, 0.15f, 0.35f, 0.7f }  /* alpha of GGX, the square of an artist's roughness */
#define KIT_REFLECTED_CHANNELS "Y,bent,normal,white.1,white.2,white.3,lobe.1,lobe.2,lobe.3,lobe.4"
int kit_truth_reflected(kit_image *out, const kit_scene *scene, const kit_camera *camera, float radius, int rays,
                        int stride, kit_error *err);

/* Computes multiple scattering [Jensen and Buhler 2002] as the plain sum, without their octree: irradiance.* holds M/pi
   = sum E A R_d / pi over samples [limit: 1..2^26] spread evenly over all of the mesh, each with the irradiance E of
   the lights (the environment is ignored), shadowed by the whole scene, on the side of its normals. unit: world units
   of the dipole's unit of length [limit: > 0]. R, G, B are albedo times it, bounce is 0. If samples are farther apart
   than z_r / 2 the sum is noisy. R_d comes from a table, exact to 1e-4 if z_r is above 2e-3 of the bounds' diagonal.
   Time: about 2 ns of one core for each pair of a pixel and a lit sample. */
struct ssgi_dipole;                        /* ssgi.h's */
int kit_truth_scatter(kit_image *out, const kit_scene *scene, const kit_camera *camera, const kit_lighting *lighting,
                      const struct ssgi_dipole *dipole, float unit, size_t samples, int stride, kit_error *err);

/* Finds what kind of place each pixel is, in channels edge, border and interior: it has 1 in the channel of its kind;
   all 0 where nothing is seen. frame: channel Z, view depth as in the build/render contract, seen by camera.
     edge      within 3 pixels, along its row or column, of a jump in depth. u is 1/z, or z if orthographic, which is
               linear over a plane. Two neighbours have a jump between them if u changes there by more, or by less, than
               on both sides, and the depth by more than 1/20 of the radius and 0.2 % of itself (the rounding of frames
               that are stored as halves). A fold is no jump: its change lies between those of its two planes. If
               adjacent pixels have jumps that grow, only the largest is one. A silhouette against the background is an
               edge, except for a plane that ends at its horizon
     border    not edge, and nearer to the picture's border than the projected length of the radius at its depth
     interior  all others */
enum { KIT_EDGE, KIT_BORDER, KIT_INTERIOR, KIT_PLACES };
int  kit_image_places(kit_image *out, const kit_image *frame, const kit_camera *camera, float radius, kit_error *err);
/* The score of one kind of place, over count channels. area: the share of the pixels with ground truth that are of this
   kind; error: the kind's share of the squared error. All 0 if there is no such pixel. */
typedef struct kit_score_place { kit_score score; double area, error; } kit_score_place;
int  kit_score_places(kit_score_place place[KIT_PLACES], const kit_image *a, const kit_image *b,
    const char *const *channels, int count, const kit_image *places, kit_error *err);

/* Computes the floor: the exact visibility if only the content of one depth layer occludes. frame: channels Z, N.X,
   N.Y, N.Z as in the build/render contract (view depth, view-space normals). The visible surface is rebuilt as thin
   sheets (neighbouring pixel centres are joined if they are on one surface) and traced as in kit_truth_ao. */
int kit_floor_ao(kit_image *out, const kit_image *frame, const kit_camera *camera, float radius, int attenuation,
                 int rays, int stride, kit_error *err);

/* Compares a frame's normals with those that its depth and the camera give, at up to 500 x 500 pixels whose neighbours
   are on one surface with them. frame: channels as for the floor. */
#define KIT_OFF 45.0
typedef struct kit_agreement {
    int    pixels;
    double off, angle;   /* share of these pixels that differ by more than KIT_OFF degrees; the median angle, degrees */
    /* median ratio of the tangents of both normals' angles to the view axis; above 1: the lens is too wide */
    double steeper;
} kit_agreement;
int  kit_frame_agreement(kit_agreement *out, const kit_image *frame, const kit_camera *camera, kit_error *err);

/* ---- >>gl, >>gbuffer, >>method are in kit_gl.h ----------------------------------------------------------------- */
#endif
