/* default_world.c: thud_default_world_def, which names the default quality. It is a file of its own
 * because a program that links it also links the direct island solver of that quality. */
#include "thud/thud.h"

thud_world_def thud_default_world_def(void) {
    return thud_default_world_def_of(&thud_quality_default);
}
