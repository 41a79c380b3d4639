/* moved_bodies.c: thud_world_get_moved_bodies: compares the pose of every body, bit by bit, with
 * the one that the caller was last given. The caller keeps these poses, so that the world stores
 * nothing for the list, and steps, edits and restores need not maintain it. */
#include "lists/lists.h"
#include "state/body.h"

#include "thud/thud_lists.h"

/* The present pose of a body. */
static thud_body_seen seen_of(const thud_world *w, td_body_index body) {
    td_position origin = td_body_origin(w, body);
    return (thud_body_seen){td_body_handle(w, body), origin.x, origin.y,
                            (int64_t)td_pose_at(w, body)->angle};
}

/* Whether body and pose are the same. */
static bool same(const thud_body_seen *a, const thud_body_seen *b) {
    return a->body.index1 == b->body.index1 && a->body.generation == b->body.generation &&
           a->x == b->x && a->y == b->y && a->angle == b->angle;
}

thud_result thud_world_get_moved_bodies(const thud_world *w, thud_body_seen *seen, int slots,
                                        thud_body_id *out, int capacity, int *out_count) {
    TD_IN_OWN_FLOAT_MODE;
    thud_result result = td_list_check(w, out, capacity, out_count);
    if (result != THUD_OK) {
        return result;
    }
    if (slots < 0 || (!seen && slots > 0)) {
        return slots < 0 ? td_refuse(w, THUD_ERROR_INVALID, "moved bodies: slots is negative")
                         : td_refuse(w, THUD_ERROR_NULL, "moved bodies: seen is null");
    }
    int n = 0;
    for (td_body_index i = {0}; i.at < slots; i.at++) {
        if (i.at >= w->bodies.count || !td_body_lives(w, i)) {
            seen[i.at] =
                (thud_body_seen){0}; /* a body that a restore brings back is listed again */
            continue;
        }
        thud_body_seen now = seen_of(w, i);
        if (same(&now, &seen[i.at])) {
            continue;
        }
        if (n < capacity) {
            out[n] = now.body;
            seen[i.at] = now;
        }
        n++;
    }
    *out_count = n;
    return THUD_OK;
}
