/* terms.h - what the figures of a page mean, in HTML. */
#ifndef LAB_TERMS_H
#define LAB_TERMS_H

#include <stdio.h>

void terms_chart(FILE *f);            /* of every page; the others after it */
void terms_light(FILE *f);
void terms_fields(FILE *f);
void terms_deep(FILE *f);
void terms_peers(FILE *f);

#endif
