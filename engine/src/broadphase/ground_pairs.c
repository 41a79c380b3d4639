/* ground_pairs.c: adds the new pairs of the segments of terrain lines with awake shapes, and with
 * resting ones where either is a sensor. Each segment has a contact of its own, whose `child` is
 * the segment's index; a pair exists while the shape's fat bounds reach down to the segment. */
#include "contact/contact.h"
#include "broadphase/pairs.h"
#include "state/shape.h"

/* Whether the pair can have a contact: the body of the shape is awake, or the shape or the line is
 * a sensor. */
static bool may_pair(const thud_world *w, int line, int shape) {
    return td_body_at(w, td_shape_at(w, shape)->body)->awake.at > 0 || td_senses(w, line) ||
           td_senses(w, shape);
}

/* Adds the pairs of one shape with those segments of a line that its fat bounds reach now and did
 * not reach at the last broadphase. Where the old bounds do not tell which pairs are new
 * (td_bounds_tell_nothing), it adds the pairs with all segments that they reach now. Most shapes
 * are above the whole line, which is tested first from the proxy alone. False when memory is short.
 */
static bool add_pairs_of_shape(thud_world *w, int terrain_shape, int shape) {
    const td_shape_proxy *proxy = td_shape_proxy_at(w, shape);
    if (td_terrain_below(w, terrain_shape, proxy->center, &proxy->fat) ||
        !may_pair(w, terrain_shape, shape)) {
        return true;
    }
    thud_terrain terrain = td_terrain_view(w, terrain_shape);
    int marks = *td_marks_at(w, terrain_shape) | *td_marks_at(w, shape);
    if (!td_pair_allowed(w, terrain_shape, shape)) {
        return true;
    }
    int first, last;
    td_position at = td_shape_proxy_at(w, shape)->center;
    td_terrain_segments_of(w, terrain_shape, &terrain, at, td_fat_at(w, shape), &first, &last);
    for (int i = first; i <= last; i++) {
        if (!td_terrain_reaches(w, terrain_shape, &terrain, at, td_fat_at(w, shape), i)) {
            continue;
        }
        bool old =
            !(marks & (TD_MARK_WOKEN | TD_MARK_FRESH)) && !w->vast &&
            td_terrain_reaches(w, terrain_shape, &terrain, at, td_bounds_before(w, shape), i);
        if (!old && !td_pairs_add(w, terrain_shape, shape, i)) {
            return false;
        }
    }
    return true;
}

/* Adds the new pairs of a line with a list of shapes, leaving out resting ones unless one of the
 * two is a sensor. False when memory is short. */
static bool add_pairs_of_line(thud_world *w, int line, const td_array *shapes) {
    for (int i = 0; i < shapes->count; i++) {
        int shape = td_int_at(shapes, i);
        /* TD_NONE stands for a shape that has left the set since it was built. */
        if (shape != TD_NONE && !add_pairs_of_shape(w, line, shape)) {
            return false;
        }
    }
    return true;
}

/* Adds the new pairs of every line: of a new line with all shapes, of another one with those that
 * moved. */
bool td_pairs_add_ground(thud_world *w) {
    for (int t = 0; t < w->terrains.count; t++) {
        int line = td_terrain_record_at(w, t)->shape;
        bool is_new = line != TD_NONE && *td_marks_at(w, line) & TD_MARK_FRESH;
        if (line != TD_NONE && !(is_new ? add_pairs_of_line(w, line, &w->awake_shapes.ids) &&
                                              add_pairs_of_line(w, line, &w->rest_shapes.ids)
                                        : add_pairs_of_line(w, line, &w->moved))) {
            return false;
        }
    }
    return true;
}
