/* wide_project.c: see project.h. Compiled once for each instruction set. */
#include "detection/project.h"

#include "solver/wide_solve.h"

/* Adds the impulses `normal` of the points, times the inverse masses, to the motions or velocities
 * v, and writes them to `records`. */
TD_INLINE void apply_sums(float (*records)[4], const td_block *block, int points, bool a_static,
                          sides v, const sides *mass, const f8 *normal) {
    const td_point *p = block->point;
    f8 sum = normal[0], turn_a = p[0].cross_a * normal[0], turn_b = p[0].cross_b * normal[0];
    if (points == 2) {
        sum += normal[1];
        turn_a += p[1].cross_a * normal[1];
        turn_b += p[1].cross_b * normal[1];
    }
    if (!a_static) {
        v.a.x -= mass->a.w * (block->nx * sum);
        v.a.y -= mass->a.w * (block->ny * sum);
        v.a.z -= block->inv_inertia_a * turn_a;
        td_scatter(records, block->a, v.a);
    }
    v.b.x += mass->b.w * (block->nx * sum);
    v.b.y += mass->b.w * (block->ny * sum);
    v.b.z += block->inv_inertia_b * turn_b;
    td_scatter(records, block->b, v.b);
}

/* The changes of the impulses of a block's points, and their new sums in `applied`, which stay >=
 * 0. `shortfall` is the length or speed that is missing at each point. The second point is
 * corrected after the first; `coupled` is the change there by a unit of impulse at the first point.
 * Lanes that are not `active` do not change. */
TD_INLINE void point_changes(const td_block *block, int points, float over_relaxation, f8 coupled,
                             const f8 *shortfall, const i8 *active, f8 *applied, f8 *change) {
    for (int k = 0; k < points; k++) {
        f8 lack = k ? shortfall[k] - coupled * change[0] : shortfall[k];
        f8 correction = f8_all(over_relaxation) * block->point[k].normal_mass * lack;
        change[k] = f8_keep(active[k], f8_max(correction, -applied[k]));
        applied[k] += change[k];
    }
}

/* Mask of the lanes in which joints tie no body to others; all lanes where next_tied is null. */
TD_INLINE i8 untied_lanes(const td_block *block, const int32_t *next_tied) {
    i8 out = i8_all(-1);
    for (int i = 0; i < TD_LANES && next_tied; i++) {
        int a = (int)(block->a[i] / TD_AWAKE_BYTES), b = (int)(block->b[i] / TD_AWAKE_BYTES);
        out[i] = (next_tied[a] == a && next_tied[b] == b) ? -1 : 0;
    }
    return out;
}

/* Mask of the lanes in which the centre of neither body moves by `distance_max` in the step. */
TD_INLINE i8 both_rest(const sides *d, bool a_static, float distance_max) {
    f8 square = f8_all(distance_max * distance_max);
    i8 rest = d->b.x * d->b.x + d->b.y * d->b.y < square;
    return a_static ? rest : rest & (d->a.x * d->a.x + d->a.y * d->a.y < square);
}

/* td_project_fn, specialised at compile time for a number of points and for side a static or not.
 */
TD_INLINE int project(td_block *const *blocks, td_pushes *pushes, int count, int points,
                      bool a_static, const td_project_context *c) {
    f8 zero = f8_all(0.0f), skin = f8_all(c->skin), target_distance = f8_all(c->target_distance);
    int unfinished = 0;
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        td_fetch_early(blocks, i, count, points);
        sides d = read_sides((const float(*)[4])c->delta, block, a_static);
        f8 opened = centres_along(&d, a_static, block->nx, block->ny);
        f8 shortfall[2], closing[2], change[2];
        /* Elastic pairs and those of tied bodies are left out. */
        i8 projected = (block->restitution < f8_all(1.0f)) & untied_lanes(block, c->next_tied);
        i8 active[2], any = i8_all(0);
        f8 yield = f8_keep(both_rest(&d, a_static, c->rest_motion), f8_all(c->yield_at_rest));
        for (int k = 0; k < points; k++) {
            td_point *p = &block->point[k];
            p->separation = p->start_separation + at_point(opened, &d, a_static, ARMS_ALL, p);
            f8 start = p->start_separation + skin - yield, gap = p->separation + skin;
            shortfall[k] = f8_min(target_distance, start) - gap;
            active[k] = projected & (p->normal_mass > zero) &
                        ((shortfall[k] > zero) | (pushes[i].motion[k] > zero));
            i8 lacks = gap < f8_min(f8_all(c->enough), start - f8_all(c->closing));
            unfinished += __builtin_popcount((unsigned)i8_bits(active[k] & lacks));
            any |= active[k];
        }
        if (!i8_bits(any)) {
            continue;
        }
        sides v = read_sides((const float(*)[4])c->velocity, block, a_static);
        f8 coupled = points == 2 ? by_first(block, &v, a_static) : zero;
        f8 speed = centres_along(&v, a_static, block->nx, block->ny);
        for (int k = 0; k < points; k++) {
            closing[k] = -at_point(speed, &v, a_static, ARMS_ALL, &block->point[k]);
        }
        point_changes(block, points, c->over_relaxation, coupled, shortfall, active,
                      pushes[i].motion, change);
        apply_sums(c->delta, block, points, a_static, d, &v, change);
        point_changes(block, points, c->over_relaxation, coupled, closing, active,
                      pushes[i].velocity, change);
        apply_sums(c->velocity, block, points, a_static, v, &v, change);
    }
    return unfinished;
}

td_project_fn TD_WIDE(td_project_points);
int TD_WIDE(td_project_points)(td_block *const *blocks, td_pushes *pushes, int count, int points,
                               bool a_static, const td_project_context *c) {
    if (points == 2) {
        return a_static ? project(blocks, pushes, count, 2, true, c)
                        : project(blocks, pushes, count, 2, false, c);
    }
    return a_static ? project(blocks, pushes, count, 1, true, c)
                    : project(blocks, pushes, count, 1, false, c);
}

/* The max_extent of the bodies on one side of a block. */
TD_INLINE f8 reach_of(const float (*reach)[2], const uint32_t *side) {
    f8 out = f8_all(0.0f);
    for (int i = 0; i < TD_LANES; i++) {
        out[i] = reach[side[i] / TD_AWAKE_BYTES][1];
    }
    return out;
}

/* edge_slope of gaps.c for eight lanes: the length by which the gap may shrink per length of
 * sliding. */
TD_INLINE f8 edge_slope(const td_block *block) {
    const td_point *p = block->point;
    f8 width = f8_abs(p[0].cross_b - p[1].cross_b),
       rise = f8_abs(p[0].start_separation - p[1].start_separation);
    return f8_keep(width > f8_all(0.0f), rise / width);
}

/* See td_find_open_fn. `slack` bounds the error of the rows, as row_error and slide in gaps.c. A
 * missing point had a gap of at least `margin` at the start of the step; the motion along the
 * normal and the rotations may have reduced it. */
td_find_open_fn TD_WIDE(td_find_open_points);
void TD_WIDE(td_find_open_points)(td_block *const *blocks, int count, int points, bool turns,
                                  const td_project_context *c) {
    f8 zero = f8_all(0.0f), skin = f8_all(c->skin),
       collision_distance = f8_all(c->collision_distance);
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        sides d = read_sides((const float(*)[4])c->delta, block, false);
        f8 along = centres_along(&d, false, block->nx, block->ny), slack = zero, turn_reach = zero;
        f8 x = d.b.x - d.a.x, y = d.b.y - d.a.y;
        if (turns) {
            f8 turn = f8_abs(d.a.z) + f8_abs(d.b.z);
            turn_reach = turn * (reach_of(c->reach, block->a) + reach_of(c->reach, block->b));
            slack = turn * (f8_all(0.5f) * turn_reach + f8_sqrt(x * x + y * y));
        }
        if (points == 2) {
            slack += edge_slope(block) * (f8_abs(x * block->ny - y * block->nx) + turn_reach);
        }
        i8 apart = block->restitution < f8_all(1.0f), any = i8_all(0);
        i8 clear = f8_all(c->margin) + along - turn_reach - slack >= collision_distance;
        for (int k = 0; k < points; k++) {
            const td_point *p = &block->point[k];
            f8 from = p->start_separation + skin,
               to = from + at_point(along, &d, false, ARMS_ALL, p) - slack;
            i8 present = p->normal_mass > zero;
            apart &= (present & (to >= f8_min(collision_distance, from - f8_all(c->closing_max)))) |
                     (~present & clear);
            any |= present;
        }
        block->apart = i8_bits(apart & any);
    }
}
