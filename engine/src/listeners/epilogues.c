/* epilogues.c: epilogues of single bodies and of categories of shapes (thud_listeners.h).
 *
 * The epilogues of bodies are in a dense list. An array by body index says where in the list a
 * body's epilogue is, so that a contact finds those of its two bodies without a search. Epilogues
 * of destroyed bodies are removed as a step begins. */
#include "listeners/listeners.h"
#include "state/handles.h"

/* The epilogue of a body, or of the categories of shapes in a mask. */
typedef struct td_object_epilogue {
    thud_object_epilogue_fn *call;
    void *context;
    thud_body_id body;   /* zero for that of categories */
    uint32_t categories; /* 0 for that of a body */
} td_object_epilogue;

typedef struct td_objects {
    td_array bodies;     /* td_object_epilogue, one for each body that has one */
    td_array by_body;    /* int, by body: its place in `bodies` plus 1; 0: none */
    td_array categories; /* td_object_epilogue, in the order in which they were first set */
    uint32_t any;        /* the union of their categories */
} td_objects;

static td_objects *objects_of(const thud_world *w) {
    return w->listeners->objects;
}

static td_object_epilogue *epilogue_at(const td_array *list, int i) {
    return TD_AT(td_object_epilogue, list, i);
}

/* The place of a body's epilogue in `bodies` plus 1; 0: the body has none. */
static int place_of(const td_objects *o, int body) {
    return body < o->by_body.count ? td_int_at(&o->by_body, body) : 0;
}

/* td_object_hooks.wants. */
static bool wants(const thud_world *w, int shape_a, int shape_b) {
    const td_objects *o = objects_of(w);
    const td_shape *a = td_shape_at(w, shape_a), *b = td_shape_at(w, shape_b);
    return place_of(o, a->body.at) || place_of(o, b->body.at) ||
           ((a->filter.category | b->filter.category) & o->any);
}

/* Calls the epilogues of one side of a contact: of its body, then of the categories of its shape. A
 * callback of this step may have destroyed the body. */
static void tell_side(thud_world *w, const thud_contact *seen, int side) {
    const td_objects *o = objects_of(w);
    const td_shape *shape = td_shape_at(w, (int)(side ? seen->shape_b : seen->shape_a).index1 - 1);
    uint32_t category = shape->filter.category;
    thud_body_id body = td_body_handle(w, shape->body);
    int place = place_of(o, shape->body.at);
    if (place) {
        td_object_epilogue own = *epilogue_at(&o->bodies, place - 1);
        if (own.body.generation == body.generation && thud_body_is_valid(w, body)) {
            own.call(w, seen, side, own.context);
        }
    }
    for (int i = 0; category & o->any && i < o->categories.count; i++) {
        td_object_epilogue all = *epilogue_at(&o->categories, i);
        if (all.categories & category && thud_body_is_valid(w, body)) {
            all.call(w, seen, side, all.context);
        }
    }
}

/* td_object_hooks.tell. */
static void tell(thud_world *w, const thud_contact *seen) {
    tell_side(w, seen, 0);
    tell_side(w, seen, 1);
}

/* Removes a body's epilogue; the last of the list takes its place. */
static void remove_body(td_objects *o, int place) {
    const td_object_epilogue *last = epilogue_at(&o->bodies, --o->bodies.count);
    td_int_set(&o->by_body, (int)last->body.index1 - 1, place + 1);
    td_int_set(&o->by_body, (int)epilogue_at(&o->bodies, place)->body.index1 - 1, 0);
    *epilogue_at(&o->bodies, place) = *last;
}

/* td_object_hooks.prune. */
static bool prune(thud_world *w) {
    td_objects *o = objects_of(w);
    for (int i = o->bodies.count - 1; i >= 0; i--) {
        if (!thud_body_is_valid(w, epilogue_at(&o->bodies, i)->body)) {
            remove_body(o, i);
        }
    }
    return o->bodies.count + o->categories.count > 0;
}

/* td_object_hooks.end. */
static void end(thud_world *w) {
    td_objects *o = objects_of(w);
    td_array_free(&w->memory, &o->bodies);
    td_array_free(&w->memory, &o->by_body);
    td_array_free(&w->memory, &o->categories);
    td_memory_put(&w->memory, o, sizeof *o);
}

static const td_object_hooks HOOKS = {.wants = wants, .tell = tell, .prune = prune, .end = end};

/* ---- setting them ---- */

/* Gives the world an empty list of objects with epilogues, if it has none yet. False when memory is
 * short. */
static bool make_objects(thud_world *w) {
    if (!td_listeners_make(w)) {
        return false;
    }
    if (!objects_of(w)) {
        td_objects *o = td_memory_get(&w->memory, sizeof *o);
        if (!o) {
            return false;
        }
        o->bodies.stride = o->categories.stride = (int)sizeof(td_object_epilogue);
        o->by_body.stride = (int)sizeof(int);
        w->listeners->objects = o;
        w->listeners->object_hooks = &HOOKS;
    }
    return true;
}

/* Refuses a call inside a callback, and one that the world has no memory for. */
static thud_result begin_setting(thud_world *w) {
    if (w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "epilogue: not inside a callback");
    }
    return make_objects(w) ? THUD_OK : td_refuse(w, THUD_ERROR_MEMORY, "epilogue: out of memory");
}

thud_result thud_body_set_epilogue(thud_world *w, thud_body_id id,
                                   thud_object_epilogue_fn *epilogue, void *context) {
    td_body_index body;
    thud_result result = td_find_body(w, id, &body);
    result = result == THUD_OK ? begin_setting(w) : result;
    if (result != THUD_OK) {
        return result;
    }
    td_objects *o = objects_of(w);
    int place = place_of(o, body.at);
    if (!epilogue) {
        if (place) {
            remove_body(o, place - 1);
        }
    } else {
        if (!place) {
            int by_body = td_max_int(o->by_body.count, body.at + 1);
            if (!td_array_reserve(&w->memory, &o->bodies, o->bodies.count + 1) ||
                !td_array_reserve(&w->memory, &o->by_body, by_body)) {
                return td_refuse(w, THUD_ERROR_MEMORY, "epilogue: out of memory");
            }
            o->by_body.count = by_body;
            place = ++o->bodies.count;
            td_int_set(&o->by_body, body.at, place);
        }
        *epilogue_at(&o->bodies, place - 1) =
            (td_object_epilogue){.call = epilogue, .context = context, .body = id};
    }
    td_listeners_update(w);
    return THUD_OK;
}

/* Removes the epilogue at a place of the list of categories; the others keep their order. */
static void remove_categories(td_objects *o, int place) {
    for (int i = place + 1; i < o->categories.count; i++) {
        *epilogue_at(&o->categories, i - 1) = *epilogue_at(&o->categories, i);
    }
    o->categories.count -= place < o->categories.count;
}

thud_result thud_world_set_category_epilogue(thud_world *w, uint32_t categories,
                                             thud_object_epilogue_fn *epilogue, void *context) {
    if (!w) {
        return THUD_ERROR_NULL;
    }
    if (categories == 0) {
        return td_refuse(w, THUD_ERROR_INVALID, "epilogue: no category");
    }
    thud_result result = begin_setting(w);
    if (result != THUD_OK) {
        return result;
    }
    td_objects *o = objects_of(w);
    int place = 0;
    while (place < o->categories.count &&
           epilogue_at(&o->categories, place)->categories != categories) {
        place++;
    }
    if (epilogue) {
        if (!td_array_reserve(&w->memory, &o->categories, place + 1)) {
            return td_refuse(w, THUD_ERROR_MEMORY, "epilogue: out of memory");
        }
        o->categories.count += place == o->categories.count;
        *epilogue_at(&o->categories, place) =
            (td_object_epilogue){.call = epilogue, .context = context, .categories = categories};
    } else {
        remove_categories(o, place);
    }
    o->any = 0;
    for (int i = 0; i < o->categories.count; i++) {
        o->any |= epilogue_at(&o->categories, i)->categories;
    }
    td_listeners_update(w);
    return THUD_OK;
}
