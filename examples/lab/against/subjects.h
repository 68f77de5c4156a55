/* subjects.h - what two builds are held against each other by: a row a picture and a quantity in it. */
#ifndef LAB_SUBJECTS_H
#define LAB_SUBJECTS_H

/* lit: the truth that it is of is light's. Light counts in shares of the mean light of open surfaces. */
enum { VISIBILITY, IRRADIANCE, BOUNCE, QUANTITIES };
typedef struct quantity { const char *word, *channel[3]; int channels, lit; } quantity;
extern const quantity quantities[QUANTITIES];

/* A frame, with the back faces of what it shows or without; one of an orthographic camera; the scene itself, whose
   depth is a window's; its eighth frame while the camera turns about it. */
enum { FRAME, SLABS, ORTHOGRAPHIC, SCENE, TURNED, VIEWS };

/* new_alone: settings of the new build, whose picture must be that of the old one without. Rows of one name are of one
   picture, and follow each other. */
typedef struct subject { const char *name, *method, *settings; int quantity, view; const char *new_alone; } subject;
enum { SUBJECTS = 25 };
extern const subject subjects[SUBJECTS];

#endif
