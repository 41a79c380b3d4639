/* default_world.c: the def that names the default quality. It stands apart from world.c, since
 * whatever links it links the island solver. */
#include "thud/thud.h"

thud_world_def thud_default_world_def(void) {
    return thud_world_def_of(&thud_quality_default);
}
