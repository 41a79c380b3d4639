/* island_rows.c: the problem of direct.h, taken from an island's bodies and contacts. */
#include "islands/island_solve.h"

#include <string.h>

/* Overlap that goes in a step. */
#define PUSH_SHARE 0.2
/* Gaps of less are none: in multiples of the arms, and of the length scale. Ground that goes on for
 * thousands of those would else hold bodies up where it is far from its middle. */
#define BLUR 1e-6
#define BLUR_LEAST 1e-7
#define BLUR_MOST 1e-4

enum { TANGENT = TD_DIRECT_TANGENT, PATIENCE = 200 };

/* The soft solver begins without the direct one's impulses, which would be too much for it to take
 * back: a light body between heavy ones would leave at any speed. */
void td_island_note(thud_world *w) {
    td_islands *s = &w->islands;
    for (int i = 0; i < s->slots.count; i++) {
        memcpy(td_row(&s->before, i), td_row(&w->velocity, td_int_at(&s->slots, i)),
               sizeof(float[4]));
    }
    float steps = (float)w->substeps;
    for (int i = 0; i < s->contacts.count; i++) {
        const td_contact *contact = td_contact_at(w, td_int_at(&s->contacts, i));
        td_block *block = td_island_block(w, contact);
        float *impulses = td_row(&s->impulses, i);
        int lane = contact->slot % TD_LANES;
        float kept = block->loaded[lane] & TD_DIRECT ? 0.0f : 1.0f;
        for (int k = 0; k < td_island_points(w, contact); k++) {
            impulses[k] = steps * block->point[k].normal_impulse[lane];
            block->point[k].normal_impulse[lane] *= kept;
        }
        impulses[TANGENT] = steps * block->tangent_impulse[lane];
        block->tangent_impulse[lane] *= kept;
        block->loaded[lane] &= TD_DIRECT - 1;
    }
}

/* ---- the problem ---- */

/* Mean velocity of a step without contacts, whose end is as the substeps would have it. */
static void take_body(td_island_work *work, int i) {
    thud_world *w = work->w;
    int slot = work->slots[i];
    const td_body *body = td_body_at(w, td_body_of(w, slot));
    const float *before = td_row(&w->islands.before, work->island->first_body + i);
    const float *push = td_row(&w->push, slot);
    double h = work->time / w->substeps;
    double linear = 1.0 / (1.0 + h * (double)body->linear_damping);
    double angular = 1.0 / (1.0 + h * (double)body->angular_damping);
    td_direct_body *b = &work->problem.bodies[i];
    b->inverse_mass = (double)body->inv_mass;
    b->inverse_inertia = (double)body->inv_inertia;
    for (int k = 0; k < 3; k++) {
        double after = b->velocity[k] = (double)before[k];
        for (int n = 0; n < w->substeps; n++) {
            after = after * (k < 2 ? linear : angular) + (double)push[k];
        }
        b->free[k] = 0.5 * ((double)before[k] + after);
    }
}

/* The body's number in the island; TD_NONE where the solver does not move it. Its velocity then
 * goes to `known`. */
static int side_of(const thud_world *w, uint32_t record, double known[3]) {
    int slot = (int)(record / TD_AWAKE_BYTES);
    const float *v = td_row(&w->velocity, slot);
    for (int k = 0; k < 3; k++) {
        known[k] = (double)v[k];
    }
    return v[3] > 0.0f ? td_int_at(&w->islands.local, slot) - 1 : TD_NONE;
}

static double by_known(const double *j, const double *v) {
    return j[0] * v[0] + j[1] * v[1] + j[2] * v[2];
}

/* Apart: not to meet before the end. Within the skin: not to come nearer. Overlapping: apart again.
 */
static double wanted_of(const thud_world *w, double gap, double blur) {
    double most = (double)(w->def.push_speed * w->unit), time = w->def.time_step;
    if (gap > blur) {
        return -gap / time;
    }
    double depth = -(gap + (double)w->skin), pushed = PUSH_SHARE * depth / time;
    return depth < blur ? 0.0 : pushed < most ? pushed : most;
}

/* Whether the soft solver has had the point bounce in this step. */
static bool bounces(const thud_world *w, const td_contact *contact, td_block *block, int lane) {
    return block->restitution[lane] > 0.0f &&
           td_surface_at(block, td_island_points(w, contact))->energy[lane] >= 0.0f;
}

static void take_row(td_direct_contact *c, td_direct_row *r, double x, double y, double cross_a,
                     double cross_b, double known[2][3]) {
    *r = (td_direct_row){.a = {-x, -y, -cross_a}, .b = {x, y, cross_b}, .used = true};
    r->known = (c->a == TD_NONE ? by_known(r->a, known[0]) : 0.0) +
               (c->b == TD_NONE ? by_known(r->b, known[1]) : 0.0);
}

/* Floats tell gaps no better than this. Contacts that carry too little to be sure of would come and
 * go with the noise, and a heap at rest has many such. */
static double blur_of(const thud_world *w, const td_direct_row *r) {
    double arm_a = r->a[2] < 0.0 ? -r->a[2] : r->a[2], arm_b = r->b[2] < 0.0 ? -r->b[2] : r->b[2];
    double blur = BLUR * (arm_a + arm_b), most = BLUR_MOST * (double)w->unit;
    return (blur < most ? blur : most) + BLUR_LEAST * (double)w->unit;
}

/* Bodies that do not turn feel no arms. */
static void take_contact(td_island_work *work, int i) {
    thud_world *w = work->w;
    const td_contact *contact = td_contact_at(w, work->contacts[i]);
    td_block *block = td_island_block(w, contact);
    const float *impulses = td_row(&w->islands.impulses, work->island->first_contact + i);
    int lane = contact->slot % TD_LANES;
    td_direct_contact *c = &work->problem.contacts[i];
    double known[2][3], x = (double)block->nx[lane], y = (double)block->ny[lane];
    double turns_a = block->inv_inertia_a[lane] > 0.0f, turns_b = block->inv_inertia_b[lane] > 0.0f;
    *c = (td_direct_contact){.a = side_of(w, block->a[lane], known[0]),
                             .b = side_of(w, block->b[lane], known[1]),
                             .friction = (double)block->friction[lane]};
    turns_a = c->a == TD_NONE ? 1.0 : turns_a;
    turns_b = c->b == TD_NONE ? 1.0 : turns_b;
    if (c->a != TD_NONE && c->b != TD_NONE) {
        c->entry = td_sparse_find(work->problem.matrix, c->a, c->b);
        c->b_later = td_sparse_is_later(work->problem.matrix, c->b, c->a);
    }
    for (int k = 0; k < TANGENT; k++) {
        if (k >= td_island_points(w, contact) || block->point[k].normal_mass[lane] == 0.0f) {
            continue;
        }
        const td_point *p = &block->point[k];
        take_row(c, &c->row[k], x, y, turns_a * (double)p->cross_a[lane],
                 turns_b * (double)p->cross_b[lane], known);
        c->row[k].impulse = 0.5 * (double)impulses[k];
        c->row[k].wanted = wanted_of(w, (double)p->base[lane], blur_of(w, &c->row[k]));
        work->bounces |= bounces(w, contact, block, lane);
        work->pushed = td_max_double(work->pushed, c->row[k].wanted);
    }
    /* Arms end in the middle of the gap. Where that is open, as it is about a skin, a disc would
     * roll as if it were greater: beside what does not move, friction acts at the surface. */
    double gap = (double)(block->point[0].base[lane] + w->skin);
    double outside = c->a == TD_NONE && gap > 0.0 ? 0.5 * gap : 0.0;
    td_direct_row *tangent = &c->row[TANGENT];
    take_row(c, tangent, y, -x, turns_a * (double)block->tangent_cross_a[lane],
             turns_b * ((double)block->tangent_cross_b[lane] - outside), known);
    tangent->impulse = 0.5 * (double)impulses[TANGENT];
    tangent->wanted = (double)td_surface_at(block, td_island_points(w, contact))->speed[lane] *
                      (w->surface_speeds > 0);
    tangent->used = block->tangent_mass[lane] > 0.0f && c->friction > 0.0;
}

/* Matrices that the island may take of what the quality allows for the step; a time budget that
 * lowers the substeps lowers that as well. */
int td_island_patience(const thud_world *w, const td_island *island) {
    int64_t work = w->quality.island_work / w->quality.substeps * w->substeps;
    int64_t most = (work - w->stats.island_work) / td_island_cost(island);
    return most < 0 ? 0 : most < PATIENCE ? (int)most : PATIENCE;
}

static td_direct problem_of(thud_world *w, const td_island *island) {
    td_islands *s = &w->islands;
    s->matrix.now = island->system;
    double x = (double)w->def.gravity.x, y = (double)w->def.gravity.y;
    return (td_direct){.bodies = s->bodies.data,
                       .contacts = s->rows.data,
                       .matrix = &s->matrix,
                       .step = s->step.data,
                       .work = s->work.data,
                       .body_count = island->bodies,
                       .contact_count = island->contacts,
                       .patience = td_island_patience(w, island),
                       .unit_speed = w->def.time_step * __builtin_sqrt(x * x + y * y)};
}

td_island_work td_island_take(thud_world *w, const td_island *island) {
    td_islands *s = &w->islands;
    td_island_work work = {.w = w,
                           .island = island,
                           .problem = problem_of(w, island),
                           .slots = (const int *)s->slots.data + island->first_body,
                           .contacts = (const int *)s->contacts.data + island->first_contact,
                           .moved = s->moved.data,
                           .time = w->def.time_step};
    for (int i = 0; i < island->bodies; i++) {
        take_body(&work, i);
    }
    for (int i = 0; i < island->contacts; i++) {
        take_contact(&work, i);
    }
    return work;
}
