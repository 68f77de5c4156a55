/* library.c - the one file of the kit that holds ssgi.h's code. */
#define SSGI_IMPLEMENTATION
#include "../../ssgi.h"
