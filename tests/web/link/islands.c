/* islands.c: circles at the default quality, which has the solver of direct islands. */
#define QUALITY thud_quality_default
#include "circles.c"
