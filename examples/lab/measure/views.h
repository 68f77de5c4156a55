/* views.h - views of scenes as lines of a csv: views.csv of the charts, and of the papers. */
#ifndef LAB_VIEWS_H
#define LAB_VIEWS_H

#include "lab/measure/line.h"
#include "lab/measure/stage.h"

/* Reads a line: a view, and its light, to which the view then points if it has any. Columns have the names of the
   members of view and lit; one that is missing is empty. view: the name, unless there is one in name; scene: the path,
   or bunny; light, crops, spots (NAME SIZE X Y Z) and solids: with bars between them. */
void view_read(view *v, lit *light, const line *l);

#endif
