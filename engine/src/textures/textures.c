/* textures.c: gives terrain lines their textures, and reads the friction of contacts from them; see
 * thud_textured.h. */
#include "textures/textures.h"

#include "constraint/lanes.h"
#include "contact/contact.h"
#include "edits/edit.h"
#include "state/body.h"
#include "state/handles.h"
#include "state/shape.h"
#include "state/surface.h"
#include "terrain/terrain.h"
#include "terrain/terrain_texture.h"

#include <string.h>

/* ---- reading ---- */

/* The texture of a shape; null if it is not a line or has none. */
static const td_texture *texture_of(const thud_world *w, int shape) {
    const td_shape *s = td_shape_at(w, shape);
    return w->texture_hooks && s->terrain != TD_NONE ? td_texture_of(w, s->terrain) : NULL;
}

/* Sets segment and weights of *sample for a line at x, relative to its origin; beyond an end, to
 * those of the end. `near_segment`: a first guess of the segment; TD_NONE: no guess. */
static void weigh(const thud_terrain *line, int near_segment, double x,
                  thud_terrain_sample *sample) {
    if (line->kind == THUD_TERRAIN_FLAT) {
        *sample = (thud_terrain_sample){.weight = {1.0 - x, x}};
        return;
    }
    x = td_clamp(x, td_terrain_x(line, 0), td_terrain_x(line, line->count - 1));
    int i = near_segment;
    if (i < 0 || i > line->count - 2 || x < td_terrain_x(line, i) ||
        x > td_terrain_x(line, i + 1)) {
        i = td_terrain_segment_at(line, x);
    }
    double left = td_terrain_x(line, i);
    double weight = (x - left) / (td_terrain_x(line, i + 1) - left);
    *sample = (thud_terrain_sample){.segment = i, .weight = {1.0 - weight, weight}};
}

/* A line with its texture; `texture.count` 0: it has none. */
typedef struct textured_line {
    int shape;
    double origin; /* world x coordinate of the line's origin */
    thud_terrain terrain;
    thud_texture texture;
} textured_line;

static textured_line line_of(const thud_world *w, int shape) {
    const td_texture *texture = texture_of(w, shape);
    if (!texture) {
        return (textured_line){.shape = shape};
    }
    return (textured_line){.shape = shape,
                           .origin =
                               td_place_to(w, td_body_origin(w, td_shape_at(w, shape)->body)).x,
                           .terrain = td_terrain_view(w, shape),
                           .texture = td_texture_view(texture)};
}

/* Sets *out to the friction of a line at x, a world coordinate. `near_segment`: as in weigh. False
 * where the line has no texture, or x is not finite. */
static bool friction_at(const textured_line *line, int near_segment, double x, float *out) {
    if (line->texture.count == 0 || !td_finite(x)) {
        return false;
    }
    thud_terrain_sample sample;
    weigh(&line->terrain, near_segment, x - line->origin, &sample);
    return thud_texture_friction_at(&line->texture, &sample, out) == THUD_OK;
}

/* The settings of a pair in which the line's friction is replaced by `friction`, from its
 * texture. */
static thud_contact_settings settings_with(const thud_world *w, int line, int other,
                                           float friction) {
    return td_surface_of_frictions(w, line, other, friction, td_shape_at(w, other)->friction);
}

/* td_texture_hooks.settle_one. */
static void settle_one(const thud_world *w, const thud_contact *seen,
                       thud_contact_settings *settings) {
    int sides[2] = {(int)seen->shape_a.index1 - 1, (int)seen->shape_b.index1 - 1};
    for (int side = 0; side < 2; side++) {
        textured_line line = line_of(w, sides[side]);
        float friction;
        if (friction_at(&line, TD_NONE, seen->point.x, &friction)) {
            *settings = settings_with(w, line.shape, sides[1 - side], friction);
        }
    }
}

/* Sets the friction of a lane whose side a is the line, and undoes changes that a prologue made in
 * the last step. */
static void settle_lane(thud_world *w, const textured_line *line, td_block *block, int points,
                        int lane) {
    int segment = td_contact_at(w, block->constraint[lane])->child;
    thud_contact seen = td_contact_view(w, block, lane);
    float friction;
    if (friction_at(line, segment, seen.point.x, &friction)) {
        thud_contact_settings own = settings_with(w, line->shape, block->shape_b[lane], friction);
        td_surface_set(w, block, points, lane, &own);
        block->mark[lane].rule &= (uint16_t)~TD_LANE_ALTERED;
    }
}

/* td_texture_hooks.settle. The contact point comes from lever arms that move with the body, so that
 * it is up to date even if the manifold is kept from an earlier step. Consecutive lanes are mostly
 * of the same line, which is looked up once. */
static void settle(thud_world *w) {
    textured_line line = {.shape = TD_NONE};
    for (int r = 0; r < w->scratch.runs.count; r++) {
        const td_run *run = TD_AT(td_run, &w->scratch.runs, r);
        if (run->kind >= TD_PAIR_COUNT || !td_pair_is_on_line((td_pair_kind)run->kind)) {
            continue;
        }
        int points = td_form_points(w->kinds[run->kind]->form);
        for (int i = 0; i < run->count; i++) {
            td_block *block = *TD_AT(td_block *, &w->scratch.blocks, run->first + i);
            for (int lane = 0; lane < block->used; lane++) {
                if (block->shape_a[lane] != line.shape) {
                    line = line_of(w, block->shape_a[lane]);
                }
                if (line.texture.count) {
                    settle_lane(w, &line, block, points, lane);
                }
            }
        }
    }
}

/* ---- edits of the line ---- */

/* td_texture_hooks.reserve: `count` more values, and as many again as scratch memory for splice. */
static bool reserve(thud_world *w, int line, int count) {
    int terrain = td_shape_at(w, line)->terrain;
    td_texture *texture = td_texture_of(w, terrain);
    return !texture ||
           td_array_reserve(&w->memory, &texture->vertices, texture->vertices.count + 2 * count);
}

/* td_texture_hooks.splice. The values of new vertices are interpolated from the values that they
 * replace. So they are first written behind the end of the list, and moved to their place
 * afterwards. */
static void splice(thud_world *w, int line, int first, int removed, const thud_pos *points,
                   int count) {
    td_texture *texture = td_texture_of(w, td_shape_at(w, line)->terrain);
    if (!texture || (!removed && !count)) {
        return;
    }
    thud_terrain terrain = td_terrain_view(w, line);
    double *values = texture->vertices.data;
    int total = texture->vertices.count, left = total - removed + count;
    double *made = values + td_max_int(total, left);
    for (int i = 0; i < count; i++) {
        thud_terrain_sample s;
        weigh(&terrain, TD_NONE, points[i].x, &s);
        made[i] = s.weight[0] * values[s.segment] + s.weight[1] * values[s.segment + 1];
    }
    int end = first + removed;
    memmove(values + first + count, values + end, (size_t)(total - end) * sizeof *values);
    memcpy(values + first, made, (size_t)count * sizeof *values);
    texture->vertices.count = left;
}

/* Removes a slot's texture, and frees its memory. */
static void forget(thud_world *w, int terrain) {
    td_texture *texture = td_texture_of(w, terrain);
    if (texture) {
        td_array_free(&w->memory, &texture->vertices);
        td_array_free(&w->memory, &texture->table);
    }
}

/* td_texture_hooks.end. */
static void end(thud_world *w) {
    td_array *of = &w->textures->of;
    for (int i = 0; i < of->count; i++) {
        td_array_free(&w->memory, &TD_AT(td_texture, of, i)->vertices);
        td_array_free(&w->memory, &TD_AT(td_texture, of, i)->table);
    }
    td_array_free(&w->memory, of);
    td_memory_put(&w->memory, w->textures, sizeof *w->textures);
}

static const td_texture_hooks HOOKS = {.settle = settle,
                                       .settle_one = settle_one,
                                       .reserve = reserve,
                                       .splice = splice,
                                       .forget = forget,
                                       .bytes = td_textures_bytes,
                                       .write = td_textures_write,
                                       .valid = td_textures_valid,
                                       .make_room = td_textures_make_room,
                                       .read = td_textures_read,
                                       .end = end};

/* ---- the calls ---- */

/* Creates the world's textures and sets the hooks, if it has none yet. False when memory is
 * short. */
static bool make_textures(thud_world *w) {
    if (!w->textures) {
        w->textures = td_memory_get(&w->memory, sizeof *w->textures);
        if (w->textures) {
            w->textures->of.stride = (int)sizeof(td_texture);
            w->texture_hooks = &HOOKS;
        }
    }
    return w->textures != NULL;
}

thud_result thud_world_use_textures(thud_world *w) {
    if (!w) {
        return THUD_ERROR_NULL;
    }
    if (w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "use textures: not inside a callback");
    }
    return make_textures(w) ? THUD_OK
                            : td_refuse(w, THUD_ERROR_MEMORY, "use textures: out of memory");
}

/* Refuses a shape that is no terrain. `found`: the result of looking up its handle, which is
 * returned if it is an error. */
static thud_result find_line(const thud_world *w, thud_result found, int index) {
    return found == THUD_OK && !td_kind_is_line(td_shape_at(w, index)->kind)
               ? td_refuse(w, THUD_ERROR_INVALID, "texture: the shape is no terrain")
               : found;
}

/* Refuses a texture that does not fit the line. */
static thud_result check(const thud_world *w, int line, const thud_texture *t) {
    thud_terrain terrain = td_terrain_view(w, line);
    if (!t->vertices) {
        return td_refuse(w, THUD_ERROR_NULL, "texture: vertices is null");
    }
    if (t->count != (terrain.kind == THUD_TERRAIN_FLAT ? 2 : terrain.count)) {
        return td_refuse(w, THUD_ERROR_INVALID,
                         "texture: count is not that of the line's vertices");
    }
    if (t->table ? t->table_count < 1 || t->table_count > THUD_TERRAIN_COUNT_MAX
                 : t->table_count != 0) {
        return td_refuse(w, THUD_ERROR_INVALID,
                         "texture: table_count is not in 1..THUD_TERRAIN_COUNT_MAX, or not 0 "
                         "without a table");
    }
    for (int i = 0; i < t->count; i++) {
        if (!td_texture_vertex_valid(t->table, t->vertices[i])) {
            return td_refuse(w, THUD_ERROR_INVALID, "texture: a value of vertices is out of range");
        }
    }
    for (int i = 0; i < t->table_count; i++) {
        if (!td_texture_entry_valid(t->table[i])) {
            return td_refuse(w, THUD_ERROR_INVALID, "texture: an entry of table is out of range");
        }
    }
    return THUD_OK;
}

/* Removes a line's texture: its contacts have the friction of the shapes again. */
static void take_away(thud_world *w, int line) {
    if (texture_of(w, line)) {
        forget(w, td_shape_at(w, line)->terrain);
        td_edit_settle_contacts(w, line);
        td_edit_wake(w, td_shape_at(w, line)->body, line);
    }
}

thud_result thud_shape_set_texture(thud_world *w, thud_shape_id id, const thud_texture *t) {
    TD_IN_OWN_FLOAT_MODE;
    int line = 0;
    thud_result result = td_edit_shape(w, id, &line);
    result = find_line(w, result, line);
    if (result == THUD_OK && !t) {
        take_away(w, line);
    }
    if (result != THUD_OK || !t) {
        return result;
    }
    result = check(w, line, t);
    if (result != THUD_OK) {
        return result;
    }
    td_texture *texture = make_textures(w) ? td_texture_room(w, td_shape_at(w, line)->terrain,
                                                             t->count, t->table_count)
                                           : NULL;
    if (!texture) {
        return td_refuse(w, THUD_ERROR_MEMORY, "texture: out of memory");
    }
    /* The arrays may be the texture's own, from thud_shape_get_texture. */
    memmove(texture->vertices.data, t->vertices, (size_t)t->count * sizeof *t->vertices);
    if (t->table) {
        memmove(texture->table.data, t->table, (size_t)t->table_count * sizeof *t->table);
    }
    texture->vertices.count = t->count;
    texture->table.count = t->table_count;
    texture->repeats = t->repeats;
    td_edit_wake(w, td_shape_at(w, line)->body, line);
    return THUD_OK;
}

thud_result thud_shape_get_texture(const thud_world *w, thud_shape_id id, thud_texture *out) {
    int line = 0;
    thud_result result = td_find_shape(w, id, &line);
    result = find_line(w, result, line);
    if (result == THUD_OK && out) {
        const td_texture *texture = texture_of(w, line);
        *out = texture ? td_texture_view(texture) : (thud_texture){0};
    }
    return result;
}

thud_result thud_shape_get_friction_at(const thud_world *w, thud_shape_id id, double x,
                                       float *out) {
    TD_IN_OWN_FLOAT_MODE;
    int line = 0;
    thud_result result = td_find_shape(w, id, &line);
    result = find_line(w, result, line);
    if (result == THUD_OK && !td_finite(x)) {
        result = td_refuse(w, THUD_ERROR_INVALID, "friction at: x is not finite");
    }
    if (result == THUD_OK && out) {
        textured_line ground = line_of(w, line);
        *out = td_shape_at(w, line)->friction;
        friction_at(&ground, TD_NONE, x, out);
    }
    return result;
}
