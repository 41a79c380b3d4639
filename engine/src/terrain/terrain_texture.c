/* terrain_texture.c: the friction that a texture has at a sample of a line; see thud_textured.h. */
#include "terrain/terrain_texture.h"

#include "geometry/shape_instance.h"

bool td_texture_vertex_valid(bool has_table, double value) {
    return has_table ? td_abs(value) <= THUD_TERRAIN_PLACE_MAX
                     : value >= 0.0 && value <= (double)THUD_FRICTION_MAX;
}

bool td_texture_entry_valid(float entry) {
    return entry >= 0.0f && entry <= THUD_FRICTION_MAX;
}

/* The two entries of the table between which a texture coordinate lies, and the weight of the
 * second in the interpolation. */
typedef struct entries {
    int first, second;
    double weight;
} entries;

static entries entries_at(const thud_texture *t, double u) {
    double place = t->repeats ? (u - __builtin_floor(u)) * t->table_count
                              : td_clamp(u, 0.0, 1.0) * (t->table_count - 1);
    int first = (int)place, last = t->table_count - 1;
    double weight = place - first;
    /* For u slightly below 0, rounding makes u - floor(u) equal to 1. */
    first = first <= last ? first : 0;
    int next = first < last ? first + 1 : t->repeats ? 0 : last;
    return (entries){first, next, weight};
}

thud_result thud_texture_friction_at(const thud_texture *t, const thud_terrain_sample *sample,
                                     float *out) {
    if (!t || !t->vertices || !sample || !out) {
        return THUD_ERROR_NULL;
    }
    if (t->count < 2 || sample->segment < 0 || sample->segment >= t->count - 1 ||
        (t->table ? t->table_count < 1 : t->table_count != 0)) {
        return THUD_ERROR_INVALID;
    }
    const double *value = t->vertices + sample->segment, *weight = sample->weight;
    double mean = weight[0] * value[0] + weight[1] * value[1];
    bool has_table = t->table != NULL;
    if (!td_texture_vertex_valid(has_table, value[0]) ||
        !td_texture_vertex_valid(has_table, value[1]) || !td_finite(mean)) {
        return THUD_ERROR_INVALID;
    }
    if (t->table) {
        entries e = entries_at(t, mean);
        if (!td_texture_entry_valid(t->table[e.first]) ||
            !td_texture_entry_valid(t->table[e.second])) {
            return THUD_ERROR_INVALID;
        }
        mean = (1.0 - e.weight) * (double)t->table[e.first] + e.weight * (double)t->table[e.second];
    }
    *out = (float)td_clamp(mean, 0.0, (double)THUD_FRICTION_MAX);
    return THUD_OK;
}
