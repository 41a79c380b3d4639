/* terrain_edit.c: changing the line of a terrain shape under whatever rests on it.
 *
 * Every edit replaces a run of vertices by another. What it may do to bodies happens in the next
 * step, through the change list: those that touch a changed segment, or would now, wake and look
 * for their segments again. Contacts with segments that stay are told their new numbers at once. */
#include "terrain/terrain_reshape.h"

#include "state/body.h"
#include "contact/contact.h"
#include "state/handles.h"
#include "constraint/lanes.h"
#include "state/shape.h"
#include "terrain/terrain.h"

#include "thud/thud_terrain.h"

#include <string.h>

/* `removed` vertices from `first` on give way to `count` others. */
typedef struct splice {
    int first, removed, count;
    const thud_pos *points;
} splice;

/* ---- what rests on the line ---- */

/* The number of a segment after the splice, TD_NONE if it is gone. The segment up to the first
 * vertex that stays on the right goes with that vertex; one before it keeps its number as long as
 * there is such a segment. */
static int renumbered(const splice *s, int segment) {
    if (segment < s->first - 1) {
        return segment;
    }
    if (segment >= s->first + s->removed - 1) {
        return segment + s->count - s->removed;
    }
    return segment < s->first + s->count - 1 ? segment : TD_NONE;
}

static bool joins(const td_contact *contact, int shape) {
    return contact->shape_a == shape || contact->shape_b == shape;
}

/* Wakes a body for its shape's sake, in the next step, which works out anew how and where the shape
 * touches the terrain. */
static void disturb(thud_world *w, int terrain_shape, int shape) {
    td_body_index body = td_shape_at(w, shape)->body;
    td_body_mark(w, body, TD_CHANGE_WAKE);
    td_shape_mark_moved(w, shape);
    *td_marks_at(w, shape) |= TD_MARK_WOKEN;
    for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *contact = td_constraint_at(w, e / 2);
        if (contact->state == TD_TOUCHING && joins(contact, terrain_shape)) {
            td_lane_renew(w, e / 2);
        }
    }
}

/* Contacts with the line as it was. */
static void disturb_contacts(thud_world *w, int terrain_shape, const splice *s) {
    int e = td_body_at(w, td_shape_at(w, terrain_shape)->body)->first_constraint;
    for (; e != TD_NONE; e = td_next_edge(w, e)) {
        td_constraint *contact = td_constraint_at(w, e / 2);
        if (!joins(contact, terrain_shape) || contact->child == TD_NONE) {
            continue;
        }
        if (contact->child >= s->first - 1 && contact->child < s->first + s->removed) {
            bool is_a = contact->shape_a == terrain_shape;
            disturb(w, terrain_shape, is_a ? contact->shape_b : contact->shape_a);
        }
        contact->child = renumbered(s, contact->child);
    }
}

/* Columns of the world in bounds quanta. */
typedef struct columns {
    int64_t left, right;
} columns;

/* The columns of the segments that the splice made, and a quantum more on either side. */
static columns columns_of(const thud_world *w, int terrain_shape, const thud_terrain *line,
                          const splice *s) {
    int64_t origin = td_shape_proxy_at(w, terrain_shape)->center.x >> TD_COARSE_SHIFT;
    double left = td_terrain_x(line, td_max_int(s->first - 1, 0));
    double right = td_terrain_x(line, td_min_int(s->first + s->count, line->count - 1));
    return (columns){origin + td_round64(left * w->to_coarse) - 2,
                     origin + td_round64(right * w->to_coarse) + 2};
}

static bool stands_in(const columns *c, const td_shape_proxy *proxy) {
    return td_unwrap(proxy->fat.max_x, proxy->center.x) >= c->left &&
           td_unwrap(proxy->fat.min_x, proxy->center.x) <= c->right;
}

static bool reaches_new(const thud_world *w, int terrain_shape, const thud_terrain *line,
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

/* Shapes that the new line reaches, but for those that have no place yet: they will look at all of
 * it anyway. */
static void disturb_reached(thud_world *w, int terrain_shape, const splice *s) {
    thud_terrain line = td_terrain_view(w, terrain_shape);
    columns changed = columns_of(w, terrain_shape, &line, s);
    for (int i = 0; i < w->shapes.count; i++) {
        const td_shape_proxy *proxy = td_shape_proxy_at(w, i);
        const td_shape *shape = td_shape_at(w, i);
        if (stands_in(&changed, proxy) && (shape->flags & TD_SHAPE_LIVE) &&
            !td_kind_is_line(shape->kind) && !(*td_marks_at(w, i) & TD_MARK_FRESH) &&
            td_pair_allowed(w, terrain_shape, i) &&
            reaches_new(w, terrain_shape, &line, s, proxy)) {
            disturb(w, terrain_shape, i);
        }
    }
}

/* ---- the line ---- */

/* What is the same at both ends stays out of it. */
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

/* The new vertices are a line by themselves, between the neighbours that they get. */
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

static thud_result apply(thud_world *w, int terrain_shape, splice s, const char *wrong,
                         const char *no_memory) {
    td_terrain_record *record = td_terrain_record_at(w, td_shape_at(w, terrain_shape)->terrain);
    s = trimmed(record, s);
    if (s.removed == 0 && s.count == 0) {
        return THUD_OK;
    }
    if (!splice_valid(record, &s)) {
        return td_refuse(w, THUD_ERROR_INVALID, wrong);
    }
    int total = record->points.count, end = s.first + s.removed;
    if (!td_array_reserve(&w->memory, &record->points, total - s.removed + s.count)) {
        return td_refuse(w, THUD_ERROR_MEMORY, no_memory);
    }
    thud_pos *points = record->points.data;
    memmove(points + s.first + s.count, points + end, (size_t)(total - end) * sizeof *points);
    for (int i = 0; i < s.count; i++) {
        points[s.first + i] = s.points[i];
        record->highest = td_max_double(record->highest, s.points[i].y);
    }
    record->points.count = total - s.removed + s.count;
    if (!(*td_marks_at(w, terrain_shape) & TD_MARK_FRESH)) {
        disturb_contacts(w, terrain_shape, &s);
        disturb_reached(w, terrain_shape, &s);
    }
    return THUD_OK;
}

/* ---- the calls ---- */

/* The slot of a terrain shape that may be edited now. */
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
    TD_IN_OWN_MODE;
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
    result = apply(w, shape, (splice){first, count, count, points.data},
                   "set heights: a height is out of range", "set heights: out of memory");
    td_array_free(&w->memory, &points);
    return result;
}

thud_result thud_shape_replace_range(thud_world *w, thud_shape_id id, double x0, double x1,
                                     const thud_pos *points, int count) {
    TD_IN_OWN_MODE;
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
    return apply(w, shape, s,
                 "replace range: not finite, x does not rise, or fewer than 2 points are left",
                 "replace range: out of memory");
}

/* Digs or raises; `tool` is in the world's coordinates. */
static thud_result reshape(thud_world *w, thud_shape_id id, td_tool tool, const char *wrong,
                           const char *no_memory) {
    TD_IN_OWN_MODE;
    int shape;
    thud_result result = find_terrain(w, id, &shape);
    if (result != THUD_OK) {
        return result;
    }
    thud_terrain line = td_terrain_view(w, shape);
    if (line.kind == THUD_TERRAIN_FLAT) {
        return td_refuse(w, THUD_ERROR_INVALID, wrong);
    }
    double unit = (double)w->unit, most = THUD_PLACE_MAX * unit;
    td_reason why;
    if (!td_in_world(w, &why, "dig or raise: x or y", tool.x, tool.y) ||
        !td_in(&why, "dig or raise: radius", tool.radius, (double)THUD_SIZE_MIN * unit,
               (double)THUD_SIZE_MAX * unit) ||
        !td_in(&why, "raise: height", tool.rise, -most, most)) {
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
        return td_refuse(w, THUD_ERROR_MEMORY, no_memory);
    }
    s.points = points.data;
    s.count = td_tool_reshape(&line, &tool, s.first, s.removed, points.data);
    result = apply(w, shape, s, wrong, no_memory);
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
