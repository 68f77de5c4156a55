/* scenes.c - a table of the built-in scenes, and scenes of a few shapes. Declared in kit_build.h. */
#include "kit/kit_build.h"

/* ---- >>scenes with a closed form; big planes are cut finer near the origin, so that they interpolate precisely --- */

enum { FAR = 200 };                        /* metres: where the big planes end */
static const double whole[]   = { 0, 1 };
static const double outward[] = { 0, 0.0025, 0.01, 0.03, 0.1, 0.3, 1 };

static void build_plane(kit_build *b)
{
    static const double floor_[4][3] = { {-FAR, 0, FAR}, {FAR, 0, FAR}, {FAR, 0, -FAR}, {-FAR, 0, -FAR} };
    kit_sheet(b, floor_, KIT_CUTS(kit_both), KIT_CUTS(kit_both));
}

static void build_corner(kit_build *b)
{
    static const double floor_[4][3] = { {0, 0, FAR}, {FAR, 0, FAR}, {FAR, 0, -FAR}, {0, 0, -FAR} };
    static const double wall[4][3]   = { {0, 0, FAR}, {0, 0, -FAR}, {0, FAR, -FAR}, {0, FAR, FAR} };
    kit_sheet(b, floor_, KIT_CUTS(outward), KIT_CUTS(kit_both));
    kit_sheet(b, wall, KIT_CUTS(kit_both), KIT_CUTS(outward));
}

static void build_groove(kit_build *b)
{
    static const double left[4][3]  = { {-0.5, 0, -FAR}, {-FAR, 0, -FAR}, {-FAR, 0, FAR}, {-0.5, 0, FAR} };
    static const double right[4][3] = { {0.5, 0, FAR}, {FAR, 0, FAR}, {FAR, 0, -FAR}, {0.5, 0, -FAR} };
    static const double deep[3][4][3] = { { {-0.5, -1, FAR}, {0.5, -1, FAR}, {0.5, -1, -FAR}, {-0.5, -1, -FAR} },
                                          { {-0.5, 0, FAR}, {-0.5, -1, FAR}, {-0.5, -1, -FAR}, {-0.5, 0, -FAR} },
                                          { {0.5, -1, FAR}, {0.5, 0, FAR}, {0.5, 0, -FAR}, {0.5, -1, -FAR} } };
    kit_sheet(b, left, KIT_CUTS(outward), KIT_CUTS(kit_both));
    kit_sheet(b, right, KIT_CUTS(outward), KIT_CUTS(kit_both));
    for (int i = 0; i < 3; i++) kit_sheet(b, deep[i], KIT_CUTS(whole), KIT_CUTS(kit_both));
}

static void build_sphere(kit_build *b)
{
    static const double radius = 1;
    kit_begin_object(b, "plane", 0);
    build_plane(b);
    kit_place_at(b, 0, 1, 0, 0);
    kit_begin_object(b, "ball", 1);
    kit_patch(b, 256, 128, kit_sphere_surface, &radius);
}

static void build_hole(kit_build *b)
{
    static const double top[4][3]  = { {-0.5, 0, 0.5}, {-FAR, 0, FAR}, {FAR, 0, FAR}, {0.5, 0, 0.5} };
    static const double wall[4][3] = { {-0.5, 0, 0.5}, {0.5, 0, 0.5}, {0.5, -1, 0.5}, {-0.5, -1, 0.5} };
    kit_level(b, -0.5, -0.5, 0.5, 0.5, -1);
    for (int i = 0; i < 4; i++) {
        kit_place_at(b, 0, 0, 0, 90 * i);
        kit_sheet(b, top, KIT_CUTS(outward), KIT_CUTS(whole));
        kit_quad(b, wall);
    }
}

/* ---- >>all -------------------------------------------------------------------------------------------------- */

/* clang-format off */
static const kit_builtin builtins[] = {
    { "room", "corner of a furnished room: boxes, books, thin railing, torus, lamp",
      kit_build_room, { 4.55f, 1.75f, 4.25f }, { 1.35f, 0.85f, 0.85f }, 50, 0.1f, 0.5f },
    { "grass", "some thousands of bent blades on rolling ground, with stones",
      kit_build_grass, { 0, 0.85f, 3 }, { 0, 0.05f, 0.2f }, 42, 0.05f, 0.3f },
    { "colonnade", "columns, arches, coffered ceiling and steps",
      kit_build_colonnade, { -0.75f, 1.75f, 2.9f }, { 0.35f, 2.0f, -6 }, 55, 0.05f, 0.8f },
    { "cornell", "open box: red and green walls, two white boxes",
      kit_build_cornell, { 0, 2.745f, 7.7f }, { 0, 2.745f, 0 }, 38, 0.1f, 1.5f },
    { "columns", "white columns, coloured ones hidden behind them, a box off screen",
      kit_build_columns, { 0, 1.7f, 6.2f }, { 0, 0.95f, 0 }, 33, 0.1f, 1 },
    { "plates", "thin plates, bars and hoops floating over a floor",
      kit_build_plates, { 1.3f, 3.3f, 4.0f }, { 0, 0.45f, 0.05f }, 36, 0.1f, 0.8f },
    { "pebbles", "some hundred small boxes, studs and balls, two tables on thin legs",
      kit_build_pebbles, { 0.35f, 0.65f, 1.5f }, { 0.05f, 0.08f, 0 }, 36, 0.05f, 0.08f },
    { "slats", "a veranda: blinds, louvres, decking, curtains, railing, chains, a gutter",
      kit_build_slats, { -1.9f, 1.65f, 4.6f }, { 0.35f, 1.0f, 0.2f }, 42, 0.1f, 0.4f },
    { "boxes", "three white boxes near each other on a floor",
      kit_build_boxes, { 0.25f, 3.3f, 3.6f }, { 0, 0.3f, 0 }, 34, 0.1f, 0.6f },
    { "spheres", "seven white spheres on a floor or just above it",
      kit_build_spheres, { 0.6f, 2.0f, 6.0f }, { 0, 0.5f, 0 }, 38, 0.1f, 0.6f },
    { "blocks", "a dozen of white tower blocks, from above",
      kit_build_blocks, { 2.4f, 6.0f, 4.6f }, { 0.1f, 0.5f, 0.1f }, 31, 0.1f, 0.5f },
    { "casters", "two dozen shapes standing, leaning, lying on a ground and on each other",
      kit_build_casters, { 2.2f, 5.6f, 8.3f }, { 0, 0.4f, 0 }, 34, 0.1f, 0.8f },
    { "crowd", "a hundred such shapes on a wide ground",
      kit_build_crowd, { 5.5f, 9.5f, 16 }, { 0, 0, 0.8f }, 33, 0.1f, 0.8f },
    { "plane", "one big square",
      build_plane, { 0, 1.5f, 2 }, { 0, 0, 0 }, 45, 0.1f, 0.5f },
    { "corner", "floor (y = 0) and wall (x = 0) at a right angle",
      build_corner, { 3.2f, 1.9f, 2.6f }, { 0.4f, 0.5f, 0 }, 40, 0.1f, 0.5f },
    { "groove", "a square groove in a plane, 1 wide and 1 deep, along z",
      build_groove, { 0.9f, 2.4f, 2.6f }, { 0, -0.3f, 0 }, 34, 0.1f, 0.5f },
    { "sphere", "a sphere of radius 1 on a big plane",
      build_sphere, { 1.5f, 3.6f, 4.2f }, { 0, 0.7f, 0 }, 34, 0.1f, 1 },
    { "hole", "a cubic hole in a plane, 1 wide and 1 deep",
      build_hole, { 0.9f, 2.2f, 1.9f }, { 0, -0.3f, 0 }, 30, 0.1f, 0.5f },
};
/* clang-format on */
enum { BUILTINS = sizeof builtins / sizeof *builtins };

const kit_builtin *kit_builtin_at(int i) { return i >= 0 && i < BUILTINS ? &builtins[i] : NULL; }
