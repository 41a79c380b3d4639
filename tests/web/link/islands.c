/* islands.c: circles at quality default, which links the direct solver of islands. */
#define QUALITY thud_quality_default
#include "circles.c"
