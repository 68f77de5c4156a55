/* subjects.h - the rows by which two builds are compared. A row is one quantity of one picture. */
#ifndef LAB_SUBJECTS_H
#define LAB_SUBJECTS_H

/* The quantity that a row compares. lit: 1 if it is light; its errors are divided by the mean unoccluded light. */
enum { VISIBILITY, IRRADIANCE, BOUNCE, QUANTITIES };
typedef struct quantity { const char *word, *channel[3]; int channels, lit; } quantity;
extern const quantity quantities[QUANTITIES];

/* FRAME: a saved frame; SLABS: one with back faces; ORTHOGRAPHIC: one of an orthographic camera; SCENE: the scene
   itself, with window depth; TURNED: the eighth frame of a camera that turns about the scene. */
enum { FRAME, SLABS, ORTHOGRAPHIC, SCENE, TURNED, VIEWS };

/* A row of the comparison. new_alone: settings that only the new build gets, and with which it must draw the same
   picture as the old build without them. Rows of one name have one picture and stand together. */
typedef struct subject { const char *name, *method, *settings; int quantity, view; const char *new_alone; } subject;
enum { MOST_SUBJECTS = 64 };
extern subject subjects[MOST_SUBJECTS];
extern int subjects_count;
void subjects_load(void);                      /* reads subjects.csv; call it first */

#endif
