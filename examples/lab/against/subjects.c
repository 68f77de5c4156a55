/* subjects.c - the rows by which two builds are compared: methods, thicknesses, kinds of view. See subjects.h. */
#include "lab/against/subjects.h"

const quantity quantities[QUANTITIES] = {
    { "visibility", { "Y", 0, 0 }, 1, 0 },
    { "irradiance", { "irradiance.R", "irradiance.G", "irradiance.B" }, 3, 1 },
    { "bounce", { "bounce.R", "bounce.G", "bounce.B" }, 3, 1 }
};

/* clang-format off */
const subject subjects[SUBJECTS] = {
    { "hsao", "hsao", "", VISIBILITY, FRAME, "" },
    { "hsao-fast", "hsao-fast", "", VISIBILITY, FRAME, "" },
    { "hsao-best", "hsao-best", "", VISIBILITY, FRAME, "" },
    { "hsao-constant", "hsao", "thickness=constant", VISIBILITY, FRAME, "" },
    { "hsao-solid", "hsao", "thickness=solid", VISIBILITY, FRAME, "" },
    { "hsao-back", "hsao", "thickness=back", VISIBILITY, SLABS, "" },
    { "hsao-slabs", "hsao", "thickness=slabs", VISIBILITY, SLABS, "" },
    { "hsao-window", "hsao", "", VISIBILITY, SCENE, "" },
    { "hsao-orthographic", "hsao", "", VISIBILITY, ORTHOGRAPHIC, "" },
    { "hsao-left-handed", "hsao", "", VISIBILITY, FRAME, "left_handed=1" },
    { "hsao-history", "hsao-history", "", VISIBILITY, TURNED, "" },
    { "march", "hsao-march", "", VISIBILITY, FRAME, "" },
    { "ssao", "ssao", "", VISIBILITY, FRAME, "" },
    { "ssdo", "ssdo", "", IRRADIANCE, FRAME, "" },
    { "ssdo", "ssdo", "", BOUNCE, FRAME, "" },
    { "ssdo-best", "ssdo-best", "", IRRADIANCE, FRAME, "" },
    { "ssdo-best", "ssdo-best", "", BOUNCE, FRAME, "" },
    { "ssdo-harmonics", "ssdo", "environment=sh,bounce=none", IRRADIANCE, FRAME, "" },
    { "ssdo-reuse", "ssdo", "thickness=slabs,reuse=1", IRRADIANCE, SLABS, "" },
    { "ssdo-reuse", "ssdo", "thickness=slabs,reuse=1", BOUNCE, SLABS, "" },
    { "ssdo-points", "ssdo-points", "", IRRADIANCE, FRAME, "" },
    { "ssdo-points", "ssdo-points", "", BOUNCE, FRAME, "" },
    { "s3ho", "s3ho", "", IRRADIANCE, FRAME, "" },
    { "s3ho", "s3ho", "", BOUNCE, FRAME, "" },
    { "ssbn", "ssbn", "", IRRADIANCE, FRAME, "" }
};
/* clang-format on */
