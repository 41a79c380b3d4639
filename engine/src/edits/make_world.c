/* make_world.c: thud_world_make, a world by gravity and quality alone; see thud_make.h. */
#include "thud/thud_make.h"

thud_world *thud_world_make(thud_vec2 gravity, const thud_quality *quality) {
    thud_world *made = NULL;
    if (!quality) {
        return NULL;
    }
    thud_world_def def = thud_default_world_def_of(quality);
    def.gravity = gravity;
    return thud_world_create(&def, &made) == THUD_OK ? made : NULL;
}
