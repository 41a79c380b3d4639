/* default_small_world.c: thud_default_small_world_def. It is a file of its own because a program
 * that links it also links the broadphase that it names. */
#include "state/world.h"

thud_world_def thud_default_small_world_def(const thud_quality *quality) {
    thud_world_def def = td_world_def_of(quality);
    def.broadphase = &thud_broadphase_all;
    return def;
}
