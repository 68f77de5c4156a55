/* papers.h - the papers' own tables and figures, drawn here beside the printed ones. Writes papers.csv. */
#ifndef LAB_PAPERS_H
#define LAB_PAPERS_H

#include "lab/page/units.h"

enum { PAPERS_THRIFT = 4 };                   /* stage_thrift of the quick form */

int  papers_units(const options *o);            /* 0: no table or figure is asked for */
int  papers_chart(FILE *record, const options *o, kit_error *err);

#endif
