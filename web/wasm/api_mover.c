/* api_mover.c: exports for movers (thud_mover.h), which JavaScript knows by their address. Each has
 * the one-way platforms of thud_mover_passes_one_way. api.h has the conventions. */
#include "api.h"

#include <thud/thud_mover.h>

#include <stdlib.h>

/* A mover with the context of its callback, and the report of its last move. */
typedef struct api_mover {
    thud_mover mover;
    thud_one_way one_way;
    thud_mover_report report;
} api_mover;

static api_buffer rows;

/* Slots out: mover_options. */
void api_mover_defaults(int kind, double hx, double hy, double angle) {
    thud_mover mover = thud_default_mover(api_placed(kind, hx, hy, angle));
    api_slots.mover_options = (struct mover_options){
        .up = {mover.up.x, mover.up.y},
        .skin = mover.skin,
        .max_slope = mover.max_slope,
        .step_height = mover.step_height,
        .snap_distance = mover.snap_distance,
        .push_force = mover.push_force,
        .filter = {.category = mover.filter.category,
                   .mask = mover.filter.mask,
                   .sensors = mover.filter.sensors},
    };
}

/* Creates a mover with its centre at (x, y). Returns null where memory is short. Slots in:
 * mover_options. */
api_mover *api_mover_create(int kind, double x, double y, double hx, double hy, double angle,
                            uint32_t body_index1, uint32_t body_generation) {
    const struct mover_options *s = &api_slots.mover_options;
    api_mover *made = calloc(1, sizeof *made);
    if (made == NULL)
        return NULL;
    thud_geometry shape = api_placed(kind, hx, hy, angle);
    shape.x = x;
    shape.y = y;
    made->mover = thud_default_mover(shape);
    made->mover.up = (thud_vec2){(float)s->up[0], (float)s->up[1]};
    made->mover.skin = s->skin;
    made->mover.max_slope = s->max_slope;
    made->mover.step_height = s->step_height;
    made->mover.snap_distance = s->snap_distance;
    made->mover.push_force = s->push_force;
    made->mover.filter = api_filter(&s->filter);
    made->mover.body = api_body(body_index1, body_generation);
    made->mover.pass = thud_mover_passes_one_way;
    made->mover.context = &made->one_way;
    made->one_way.categories = api_to_u32(s->one_way);
    return made;
}

void api_mover_destroy(api_mover *mover) {
    free(mover);
}

/* Puts a mover at a place, in the air. */
void api_mover_place(api_mover *m, double x, double y) {
    m->mover.shape.x = x;
    m->mover.shape.y = y;
    m->mover.on_ground = false;
}

/* Slots out: mover_state. */
void api_mover_get_state(const api_mover *m) {
    const thud_mover *mover = &m->mover;
    struct mover_state *s = &api_slots.mover_state;
    s->position[0] = mover->shape.x;
    s->position[1] = mover->shape.y;
    s->on_ground = mover->on_ground;
    s->normal[0] = mover->ground_normal.x;
    s->normal[1] = mover->ground_normal.y;
    s->shape[0] = mover->ground_shape.index1;
    s->shape[1] = mover->ground_shape.generation;
    s->body[0] = mover->ground_body.index1;
    s->body[1] = mover->ground_body.generation;
    s->point[0] = mover->ground_point.x;
    s->point[1] = mover->ground_point.y;
    s->place[0] = mover->ground_place.x;
    s->place[1] = mover->ground_place.y;
    s->cosine = mover->ground_cosine;
    s->sine = mover->ground_sine;
}

/* Slots in: mover_state. */
void api_mover_set_state(api_mover *m) {
    thud_mover *mover = &m->mover;
    const struct mover_state *s = &api_slots.mover_state;
    mover->shape.x = s->position[0];
    mover->shape.y = s->position[1];
    mover->on_ground = s->on_ground != 0.0;
    mover->ground_normal = (thud_vec2){(float)s->normal[0], (float)s->normal[1]};
    mover->ground_shape = (thud_shape_id){api_to_u32(s->shape[0]), api_to_u32(s->shape[1])};
    mover->ground_body = (thud_body_id){api_to_u32(s->body[0]), api_to_u32(s->body[1])};
    mover->ground_point = (thud_pos){s->point[0], s->point[1]};
    mover->ground_place = (thud_pos){s->place[0], s->place[1]};
    mover->ground_cosine = (float)s->cosine;
    mover->ground_sine = (float)s->sine;
}

/* Moves by (vx, vy) * dt, in length/s and s; `drop`: through one-way platforms, too. Slots out:
 * mover_report, whose list has a row of mover_hit for each hit, and behind them the sensors'
 * handles.
 */
int api_mover_move(thud_world *world, api_mover *m, double vx, double vy, double dt, int drop) {
    m->one_way.drop = drop != 0;
    thud_result result =
        thud_mover_move(world, &m->mover, (thud_vec2){(float)vx, (float)vy}, dt, &m->report);
    if (result != THUD_OK)
        return result;
    const thud_mover *mover = &m->mover;
    const thud_mover_report *report = &m->report;
    api_buffer_clear(&rows);
    for (int i = 0; i < report->hit_count; i++) {
        const thud_mover_hit *hit = &report->hits[i];
        struct mover_hit row = {.shape = {hit->shape.index1, hit->shape.generation},
                                .body = {hit->body.index1, hit->body.generation},
                                .point = {hit->point.x, hit->point.y},
                                .normal = {hit->normal.x, hit->normal.y},
                                .depth = hit->depth};
        api_buffer_push(&rows, &row, sizeof row);
    }
    for (int i = 0; i < report->sensor_count; i++) {
        double id[2] = {report->sensors[i].index1, report->sensors[i].generation};
        api_buffer_push(&rows, id, sizeof id);
    }
    struct mover_report *s = &api_slots.mover_report;
    s->position[0] = mover->shape.x;
    s->position[1] = mover->shape.y;
    s->on_ground = mover->on_ground;
    s->normal[0] = mover->ground_normal.x;
    s->normal[1] = mover->ground_normal.y;
    s->shape[0] = mover->ground_shape.index1;
    s->shape[1] = mover->ground_shape.generation;
    s->body[0] = mover->ground_body.index1;
    s->body[1] = mover->ground_body.generation;
    s->velocity[0] = report->velocity.x;
    s->velocity[1] = report->velocity.y;
    s->ground_velocity[0] = report->ground_velocity.x;
    s->ground_velocity[1] = report->ground_velocity.y;
    s->depth = report->depth;
    s->hits.address = (double)(uintptr_t)rows.data;
    s->hits.count = report->hit_count;
    s->sensor_count = report->sensor_count;
    return api_buffer_result(&rows);
}
