/* terrain_edit.c: edits the line of a terrain shape: sets heights, replaces a range, digs, raises.
 *
 * Every edit is a splice: it replaces consecutive vertices by others. Bodies follow in the next
 * step, through the change list: those with a contact on a changed segment, or with bounds that
 * reach a new one, wake and search their segments again. The contacts of unchanged segments, whose
 * indices may shift, get the new index at once. Coordinates of vertices are relative to the body's
 * origin, in the caller's unit. */
#include "terrain/terrain_reshape.h"

#include "state/body.h"
#include "contact/contact.h"
#include "state/handles.h"
#include "constraint/lanes.h"
#include "state/shape.h"
#include "terrain/terrain.h"
#include "textures/texture_hooks.h"

#include "thud/thud_terrain.h"

#include <string.h>

/* Replaces the `removed` vertices from index `first` on by the `count` vertices at `points`. */
typedef struct splice {
    int first, removed, count;
    const thud_pos *points;
} splice;

/* ---- contacts with the line ---- */

/* The index of a segment after the splice; TD_NONE: it no longer exists. Segment i joins the
 * vertices i and i + 1. The segment that ends at the first unchanged vertex on the right shifts
 * with that vertex; a changed segment before it keeps its index if the splice makes enough segments
 * for it. */
static int renumbered(const splice *s, int segment) {
    if (segment < s->first - 1) {
        return segment;
    }
    if (segment >= s->first + s->removed - 1) {
        return segment + s->count - s->removed;
    }
    return segment < s->first + s->count - 1 ? segment : TD_NONE;
}

/* Whether one side of the contact is that shape. */
static bool has_shape(const td_contact *contact, int shape) {
    return contact->shape_a == shape || contact->shape_b == shape;
}

/* Marks a shape and its body so that the next step wakes the body, searches the shape's segments
 * again, and works out its manifolds with this terrain anew. */
static void wake_and_renew(thud_world *w, int terrain_shape, int shape) {
    td_body_index body = td_shape_at(w, shape)->body;
    td_body_mark(w, body, TD_CHANGE_WAKE);
    td_shape_mark_moved(w, shape);
    *td_marks_at(w, shape) |= TD_MARK_WOKEN;
    for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *contact = td_constraint_at(w, td_edge_constraint(e));
        if (contact->state == TD_TOUCHING && has_shape(contact, terrain_shape)) {
            td_lane_renew(w, td_edge_constraint(e));
        }
    }
}

/* Gives each contact of the line the new index of its segment, and wakes the bodies on changed
 * segments. */
static void update_contacts(thud_world *w, int terrain_shape, const splice *s) {
    int e = td_body_at(w, td_shape_at(w, terrain_shape)->body)->first_constraint;
    for (; e != TD_NONE; e = td_next_edge(w, e)) {
        td_constraint *contact = td_constraint_at(w, td_edge_constraint(e));
        if (!has_shape(contact, terrain_shape) || contact->child == TD_NONE) {
            continue;
        }
        if (contact->child >= s->first - 1 && contact->child < s->first + s->removed) {
            bool is_a = contact->shape_a == terrain_shape;
            wake_and_renew(w, terrain_shape, is_a ? contact->shape_b : contact->shape_a);
        }
        contact->child = renumbered(s, contact->child);
    }
}

/* A range of x in the world, in bounds quanta. */
typedef struct columns {
    int64_t left, right;
} columns;

/* The range of x of the segments that the splice has made, extended by 2 quanta against rounding.
 */
static columns columns_of(const thud_world *w, int terrain_shape, const thud_terrain *line,
                          const splice *s) {
    int64_t origin = td_shape_proxy_at(w, terrain_shape)->center.x >> TD_COARSE_SHIFT;
    double left = td_terrain_x(line, td_max_int(s->first - 1, 0));
    double right = td_terrain_x(line, td_min_int(s->first + s->count, line->count - 1));
    return (columns){origin + td_round64(left * w->to_coarse) - 2,
                     origin + td_round64(right * w->to_coarse) + 2};
}

/* Whether the shape's fat bounds overlap the range. */
static bool overlaps_columns(const columns *c, const td_shape_proxy *proxy) {
    return td_unwrap(proxy->fat.max_x, proxy->center.x) >= c->left &&
           td_unwrap(proxy->fat.min_x, proxy->center.x) <= c->right;
}

/* Whether the shape's fat bounds reach down to a segment that the splice has made. */
static bool reaches_new_segment(const thud_world *w, int terrain_shape, const thud_terrain *line,
                                const splice *s, const td_shape_proxy *proxy) {
    int segment, last;
    td_terrain_segments_of(w, terrain_shape, line, proxy->center, &proxy->fat, &segment, &last);
    segment = td_max_int(segment, s->first - 1);
    last = td_min_int(last, s->first + s->count - 1);
    while (segment <= last &&
           !td_terrain_reaches(w, terrain_shape, line, proxy->center, &proxy->fat, segment)) {
        segment++;
    }
    return segment <= last;
}

/* Wakes the bodies whose shapes reach a new segment. Shapes marked TD_MARK_FRESH are left out: the
 * broadphase searches the whole line for them anyway. */
static void wake_reached(thud_world *w, int terrain_shape, const splice *s) {
    thud_terrain line = td_terrain_view(w, terrain_shape);
    columns changed = columns_of(w, terrain_shape, &line, s);
    for (int i = 0; i < w->shapes.count; i++) {
        const td_shape_proxy *proxy = td_shape_proxy_at(w, i);
        const td_shape *shape = td_shape_at(w, i);
        if (overlaps_columns(&changed, proxy) && (shape->flags & TD_SHAPE_LIVE) &&
            !td_kind_is_line(shape->kind) && !(*td_marks_at(w, i) & TD_MARK_FRESH) &&
            td_pair_allowed(w, terrain_shape, i) &&
            reaches_new_segment(w, terrain_shape, &line, s, proxy)) {
            wake_and_renew(w, terrain_shape, i);
        }
    }
}

/* ---- the line ---- */

/* The splice without those vertices at its ends that it would replace by equal ones: bodies near
 * these need not wake. */
static splice trimmed(const td_terrain_record *record, splice s) {
    const thud_pos *old = record->points.data;
    while (s.removed && s.count && old[s.first].x == s.points->x && old[s.first].y == s.points->y) {
        s.first++;
        s.points++;
        s.removed--;
        s.count--;
    }
    while (s.removed && s.count && old[s.first + s.removed - 1].x == s.points[s.count - 1].x &&
           old[s.first + s.removed - 1].y == s.points[s.count - 1].y) {
        s.removed--;
        s.count--;
    }
    return s;
}

/* Whether the line is valid after the splice: the new vertices are in range and rise in x, also
 * with respect to the neighbours that stay, and at least two vertices remain. */
static bool splice_valid(const td_terrain_record *record, const splice *s) {
    const thud_pos *old = record->points.data;
    int total = record->points.count;
    const thud_pos *left = s->first > 0 ? &old[s->first - 1] : NULL;
    for (int i = 0; i < s->count; i++) {
        const thud_pos *p = &s->points[i];
        if (!td_terrain_vertex_valid(record->kind, left, p)) {
            return false;
        }
        left = p;
    }
    int right = s->first + s->removed;
    return total - s->removed + s->count >= 2 &&
           (right == total || !left || left->x < old[right].x);
}

static thud_result apply_splice(thud_world *w, int terrain_shape, splice s, const char *range_error,
                                const char *memory_error) {
    td_terrain_record *record = td_terrain_record_at(w, td_shape_at(w, terrain_shape)->terrain);
    s = trimmed(record, s);
    if (s.removed == 0 && s.count == 0) {
        return THUD_OK;
    }
    if (!splice_valid(record, &s)) {
        return td_refuse(w, THUD_ERROR_INVALID, range_error);
    }
    int total = record->points.count, end = s.first + s.removed;
    if (!td_array_reserve(&w->memory, &record->points, total - s.removed + s.count) ||
        (w->texture_hooks && !w->texture_hooks->reserve(w, terrain_shape, s.count))) {
        return td_refuse(w, THUD_ERROR_MEMORY, memory_error);
    }
    if (w->texture_hooks) {
        w->texture_hooks->splice(w, terrain_shape, s.first, s.removed, s.points, s.count);
    }
    thud_pos *points = record->points.data;
    memmove(points + s.first + s.count, points + end, (size_t)(total - end) * sizeof *points);
    for (int i = 0; i < s.count; i++) {
        points[s.first + i] = s.points[i];
        record->highest = td_max_double(record->highest, s.points[i].y);
    }
    record->points.count = total - s.removed + s.count;
    if (!(*td_marks_at(w, terrain_shape) & TD_MARK_FRESH)) {
        update_contacts(w, terrain_shape, &s);
        wake_reached(w, terrain_shape, &s);
    }
    return THUD_OK;
}

/* ---- the calls ---- */

/* Sets *shape to the slot of a terrain shape; refuses other shapes, and calls inside a callback. */
static thud_result find_terrain(thud_world *w, thud_shape_id id, int *shape) {
    thud_result result = td_find_shape(w, id, shape);
    if (result != THUD_OK) {
        return result;
    }
    if (w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "terrain edit: not inside a callback");
    }
    return td_kind_is_line(td_shape_at(w, *shape)->kind)
               ? THUD_OK
               : td_refuse(w, THUD_ERROR_INVALID, "terrain edit: the shape is no terrain");
}

thud_result thud_shape_set_heights(thud_world *w, thud_shape_id id, int first,
                                   const double *heights, int count) {
    TD_IN_OWN_FLOAT_MODE;
    int shape;
    thud_result result = find_terrain(w, id, &shape);
    if (result != THUD_OK) {
        return result;
    }
    if (!heights) {
        return td_refuse(w, THUD_ERROR_NULL, "set heights: heights is null");
    }
    thud_terrain line = td_terrain_view(w, shape);
    if (first < 0 || count < 0 || first > line.count - count) {
        return td_refuse(w, THUD_ERROR_INVALID, "set heights: no such vertices");
    }
    td_array points = {.stride = sizeof(thud_pos)};
    if (!td_array_reserve(&w->memory, &points, count)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "set heights: out of memory");
    }
    for (int i = 0; i < count; i++) {
        *TD_AT(thud_pos, &points, i) = (thud_pos){line.points[first + i].x, heights[i]};
    }
    result = apply_splice(w, shape, (splice){first, count, count, points.data},
                          "set heights: a height is out of range", "set heights: out of memory");
    td_array_free(&w->memory, &points);
    return result;
}

thud_result thud_shape_replace_range(thud_world *w, thud_shape_id id, double x0, double x1,
                                     const thud_pos *points, int count) {
    TD_IN_OWN_FLOAT_MODE;
    int shape;
    thud_result result = find_terrain(w, id, &shape);
    if (result != THUD_OK) {
        return result;
    }
    if (!points && count != 0) {
        return td_refuse(w, THUD_ERROR_NULL, "replace range: points is null");
    }
    thud_terrain line = td_terrain_view(w, shape);
    if (line.kind != THUD_TERRAIN_IRREGULAR) {
        return td_refuse(w, THUD_ERROR_INVALID, "replace range: the line is not irregular");
    }
    if (!(x0 <= x1) || count < 0 || (count && (points[0].x < x0 || points[count - 1].x > x1))) {
        return td_refuse(w, THUD_ERROR_INVALID,
                         "replace range: the range is empty, or points are outside");
    }
    splice s = {.first = td_terrain_vertices_left_of(&line, x0), .count = count, .points = points};
    while (s.first + s.removed < line.count && line.points[s.first + s.removed].x <= x1) {
        s.removed++;
    }
    return apply_splice(
        w, shape, s, "replace range: not finite, x does not rise, or fewer than 2 points are left",
        "replace range: out of memory");
}

/* Digs or raises with a tool that is given in the world's coordinates (terrain_reshape.h). */
static thud_result reshape(thud_world *w, thud_shape_id id, td_tool tool, const char *range_error,
                           const char *memory_error) {
    TD_IN_OWN_FLOAT_MODE;
    int shape;
    thud_result result = find_terrain(w, id, &shape);
    if (result != THUD_OK) {
        return result;
    }
    thud_terrain line = td_terrain_view(w, shape);
    if (line.kind == THUD_TERRAIN_FLAT) {
        return td_refuse(w, THUD_ERROR_INVALID, range_error);
    }
    double unit = (double)w->length_scale, max = THUD_PLACE_MAX * unit;
    td_reason why;
    if (!td_in_world(w, &why, "dig or raise: x or y", tool.x, tool.y) ||
        !td_in(&why, "dig or raise: radius", tool.radius, (double)THUD_SIZE_MIN * unit,
               (double)THUD_SIZE_MAX * unit) ||
        !td_in(&why, "raise: height", tool.rise, -max, max)) {
        return td_refuse(w, THUD_ERROR_INVALID, why.text);
    }
    td_position center = td_place_from(w, (thud_pos){tool.x, tool.y});
    td_position origin = td_body_origin(w, td_shape_at(w, shape)->body);
    tool.x = (double)(center.x - origin.x) / w->to_fixed;
    tool.y = (double)(center.y - origin.y) / w->to_fixed;
    splice s = {0};
    td_tool_vertices(&line, &tool, &s.first, &s.removed);
    td_array points = {.stride = sizeof(thud_pos)};
    if (!td_array_reserve(&w->memory, &points, td_tool_room(s.removed))) {
        return td_refuse(w, THUD_ERROR_MEMORY, memory_error);
    }
    s.points = points.data;
    s.count = td_tool_reshape(&line, &tool, s.first, s.removed, points.data);
    result = apply_splice(w, shape, s, range_error, memory_error);
    td_array_free(&w->memory, &points);
    return result;
}

thud_result thud_shape_dig(thud_world *w, thud_shape_id id, thud_pos center, double radius) {
    return reshape(w, id, (td_tool){true, center.x, center.y, radius, 0.0},
                   "dig: the ground is flat, or would leave the range of places",
                   "dig: out of memory");
}

thud_result thud_shape_raise(thud_world *w, thud_shape_id id, double x, double radius,
                             double height) {
    return reshape(w, id, (td_tool){false, x, 0.0, radius, height},
                   "raise: the ground is flat, or would leave the range of places",
                   "raise: out of memory");
}
