/* detection.c: public functions about the kinds of detection. */
#include "detection/detection.h"

#include "state/handles.h"
#include "state/shape.h"

const char *thud_detection_name(const thud_detection *detection) {
    return detection ? detection->name : "";
}

/* The speed at which a body moves by the thickness of the thinnest shape in one step. */
thud_result thud_world_get_bisection_limit(thud_world *w, double *speed) {
    if (!w || !speed) {
        return td_refuse(w, THUD_ERROR_NULL, "bisection limit: world or speed is null");
    }
    *speed = (double)td_thinnest(w) / w->def.time_step;
    return THUD_OK;
}
