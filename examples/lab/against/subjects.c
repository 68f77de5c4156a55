/* subjects.c - reads the rows by which two builds are compared. Declared in subjects.h. */
#include "lab/against/subjects.h"
#include <string.h>
#include "lab/measure/line.h"

const quantity quantities[QUANTITIES] = {
    { "visibility", { "Y", 0, 0 }, 1, 0 },
    { "irradiance", { "irradiance.R", "irradiance.G", "irradiance.B" }, 3, 1 },
    { "bounce", { "bounce.R", "bounce.G", "bounce.B" }, 3, 1 }
};

subject subjects[MOST_SUBJECTS];
int subjects_count;

void subjects_load(void)
{
    line l = { "examples/lab/against", .file = "subjects" };
    for (line_open(&l), subjects_count = 0; l.at < l.of.rows; ++l.at) {
        const char *of = line_cell(&l, "quantity"), *view = line_cell(&l, "view");
        if (subjects_count == MOST_SUBJECTS) line_fault(&l, "name");
        subjects[subjects_count++] = (subject){
            line_cell(&l, "name"), line_cell(&l, "method"), line_cell(&l, "settings"),
            line_word(&l, "quantity", "visibility irradiance bounce", of, strlen(of)),
            line_word(&l, "view", "frame slabs orthographic scene turned", view, strlen(view)),
            line_cell(&l, "new_alone")
        };
    }
}
