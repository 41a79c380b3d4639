/* ground_pairs.c: new pairs of lines and what is awake. Each segment is a shape of its own, found by
 * its index. */
#include "contact.h"
#include "pairs.h"
#include "shape.h"

static bool pair_terrain(thud_world *w, int terrain_shape, int shape)
{
    const td_stance *stance = td_stance_at(w, shape);
    if (td_terrain_below(w, terrain_shape, stance->center, &stance->fat)) {
        return true;
    }
    thud_terrain terrain = td_terrain_view(w, terrain_shape);
    int marks = *td_marks_at(w, terrain_shape) | *td_marks_at(w, shape);
    if (!td_pair_allowed(w, terrain_shape, shape)) {
        return true;
    }
    int first, last;
    td_place at = td_stance_at(w, shape)->center;
    td_terrain_segments_of(w, terrain_shape, &terrain, at, td_fat_at(w, shape), &first, &last);
    for (int i = first; i <= last; i++) {
        if (!td_terrain_reaches(w, terrain_shape, &terrain, at, td_fat_at(w, shape), i)) {
            continue;
        }
        bool old = !(marks & (TD_MARK_WOKEN | TD_MARK_FRESH)) && !w->vast &&
                   td_terrain_reaches(w, terrain_shape, &terrain, at, td_bounds_before(w, shape), i);
        if (!old && !td_pairs_add(w, terrain_shape, shape, i)) {
            return false;
        }
    }
    return true;
}

bool td_pairs_add_ground(thud_world *w)
{
    for (int t = 0; t < w->terrains.count; t++) {
        const td_terrain_record *record = td_slot_at(&w->terrains, t);
        if (record->shape == TD_NONE) {
            continue;
        }
        if (*td_marks_at(w, record->shape) & TD_MARK_FRESH) {
            const td_array *all = &w->awake_shapes.ids;
            for (int i = 0; i < all->count; i++) {
                if (!pair_terrain(w, record->shape, *(int *)td_at(all, i))) {
                    return false;
                }
            }
            continue;
        }
        for (int i = 0; i < w->moved.count; i++) {
            int shape = *(int *)td_at(&w->moved, i);
            if (td_body_at(w, td_shape_at(w, shape)->body)->awake > 0 &&
                !pair_terrain(w, record->shape, shape)) {
                return false;
            }
        }
    }
    return true;
}
