/* passing.c: see passing.h. */
#include "passing.h"

#include <math.h>
#include <stdlib.h>
#include <thud/thud_lists.h>
#include <thud/thud_queries.h>
#include <thud/thud_rules.h>

/* Static shapes that are looked at on the way of a body in one step. */
enum { ON_THE_WAY_MAX = 16 };

void passing_free(passing *p) {
    free(p->places);
    *p = (passing){0};
}

thud_result passing_before(passing *p, thud_world *world) {
    int slots = 0;
    thud_result result = thud_world_get_slot_counts(world, &slots, NULL);
    if (result == THUD_OK && slots > p->capacity) {
        passing_place *places = realloc(p->places, 2 * (size_t)slots * sizeof *places);
        if (!places)
            return THUD_ERROR_MEMORY;
        p->places = places;
        p->capacity = 2 * slots;
    }
    p->count = slots;
    for (int i = 0; i < slots && result == THUD_OK; i++) {
        passing_place *place = &p->places[i];
        result = thud_world_get_body_at(world, i, &place->body);
        thud_body_state body;
        if (result != THUD_OK || place->body.index1 == 0)
            continue;
        result = thud_body_get_state(world, place->body, &body);
        place->center = body.center;
        if (body.kind != THUD_BODY_DYNAMIC || !body.awake || !body.enabled || body.shape_count == 0)
            place->body = (thud_body_id){0};
    }
    return result;
}

/* Whether a shape of category `moving` collides with one of category `standing` on all sides. A
 * shape's kind in the table of rules is its lowest category bit. */
static bool is_solid(thud_world *world, uint32_t moving, uint32_t standing) {
    uint32_t first = moving & (~moving + 1), second = standing & (~standing + 1);
    thud_rule rule;
    bool is_set;
    return first == 0 || second == 0 ||
           thud_world_get_rule(world, first, second, &rule, &is_set, NULL) != THUD_OK || !is_set ||
           rule.kind == THUD_RULE_COLLIDE;
}

/* Whether one of the hits is a static shape that stops `shape`. */
static bool stops(thud_world *world, const thud_shape_state *shape, const thud_ray_hit *hits,
                  int count) {
    for (int i = 0; i < count; i++) {
        thud_shape_state hit;
        thud_body_state body;
        if (thud_shape_get_state(world, hits[i].shape, &hit) == THUD_OK &&
            thud_body_get_state(world, hit.body, &body) == THUD_OK &&
            body.kind == THUD_BODY_STATIC &&
            is_solid(world, shape->filter.category, hit.filter.category))
            return true;
    }
    return false;
}

/* Whether the body passed on its way from `from`. A body that moved by less than its first shape's
 * smallest half extent cannot have left a shape behind it without an overlap that is measured. */
static thud_result did_pass(thud_world *world, thud_body_id id, thud_pos from, bool *out) {
    thud_body_state body;
    thud_shape_id first;
    thud_shape_state shape;
    thud_result result = thud_body_get_state(world, id, &body);
    *out = false;
    if (result == THUD_OK)
        result = thud_body_get_shapes(world, id, &first, 1, NULL);
    if (result == THUD_OK)
        result = thud_shape_get_state(world, first, &shape);
    double dx = body.center.x - from.x, dy = body.center.y - from.y;
    double half = shape.kind == THUD_SHAPE_CIRCLE
                      ? shape.half_extents.x
                      : fmin(shape.half_extents.x, shape.half_extents.y);
    if (result != THUD_OK || shape.sensor || !(dx * dx + dy * dy > half * half))
        return result;
    thud_query_filter filter = thud_default_query_filter();
    filter.category = shape.filter.category;
    filter.mask = shape.filter.mask;
    filter.group = shape.filter.group;
    filter.ignore = id;
    thud_ray way = {.origin = from, .dx = dx, .dy = dy, .filter = &filter};
    thud_ray_hit hits[ON_THE_WAY_MAX];
    int count = 0;
    if (filter.category == 0 && filter.mask == 0 && filter.group <= 0)
        return THUD_OK;
    result = thud_world_cast_ray_all(world, &way, hits, ON_THE_WAY_MAX, &count);
    *out = result == THUD_OK &&
           stops(world, &shape, hits, count < ON_THE_WAY_MAX ? count : ON_THE_WAY_MAX);
    return result;
}

thud_result passing_after(const passing *p, thud_world *world, long *count) {
    thud_result result = THUD_OK;
    for (int i = 0; i < p->count && result == THUD_OK; i++) {
        thud_body_id id = p->places[i].body;
        bool passed = false;
        if (id.index1 != 0 && thud_body_is_valid(world, id))
            result = did_pass(world, id, p->places[i].center, &passed);
        *count += passed;
    }
    return result;
}
