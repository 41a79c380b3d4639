/* rules_support.h: worlds whose shapes belong to categories, for tests of collision rules
 * (thud_rules.h). */
#ifndef RULES_SUPPORT_H
#define RULES_SUPPORT_H

#include "engine_support.h"
#include "every_choice.h"

#include <thud/thud_rules.h>

enum { DETECTIONS = 4, BROADPHASES = 3 };
/* Categories of shapes. */
enum { GROUND = 1, PLANK = 2, PLAYER = 4, CRATE = 8 };

static inline thud_world *make(const thud_detection *detection, const thud_broadphase *broadphase) {
    thud_world_def def = thud_default_world_def();
    def.detection = detection;
    def.broadphase = broadphase;
    return make_world(def);
}

static inline thud_shape_def of_kind(uint32_t category) {
    thud_shape_def def = thud_default_shape_def();
    def.filter.category = category;
    return def;
}

/* Adds a body with one shape of a category. Forms: 0 a circle of radius hx, 1 an AABB, 2 an OBB of
 * half extents hx, hy. */
static inline thud_body_id add(thud_world *w, thud_body_kind body_kind, uint32_t category, int form,
                               double x, double y, float hx, float hy) {
    thud_shape_def def = of_kind(category);
    thud_body_id body = add_body(w, body_kind, x, y, 0);
    add_shape(w, body, hx, form ? hy : 0, form == 1, &def);
    return body;
}

static inline thud_body_state get(thud_world *w, thud_body_id body) {
    thud_body_state state;
    OK(thud_body_get_state(w, body, &state));
    return state;
}

static inline void steps(thud_world *w, int count) {
    for (int i = 0; i < count; i++) {
        OK(thud_world_step(w));
    }
}

/* The default rule with another kind. */
static inline thud_rule rule_of_kind(thud_rule_kind kind) {
    thud_rule rule = thud_default_rule();
    rule.kind = kind;
    return rule;
}

static inline void throw_up(thud_world *w, thud_body_id body, float vx, float vy) {
    OK(thud_body_set_velocity(w, body, (thud_vec2){vx, vy}, 0));
}

#endif
